//! Quantities of a strip as readings.
//!
//! A quantity depends on the numbers of the flow, on the unknowns of the inflow and on the loads of the
//! kernel, which vary as in [`super::kinematics`] and [`rotor_aero::strip`].

use rotor_aero::strip::ReportNumber;

use super::columns::OWN;
use super::kinematics::FLOW;
use super::strip::AirStrip;
use crate::elements::{Local, ReadingRow, StripQuantity};
use crate::model::Variable;

impl AirStrip {
    /// A quantity times a weight, and its derivatives; `None` for the load around the shaft.
    pub(super) fn quantity(
        &self,
        (quantity, weight): (StripQuantity, f64),
        at: &Local<'_>,
        row: Option<&mut ReadingRow<'_>>,
    ) -> Option<f64> {
        let carrier = self.carrier(at);
        let flow = self.flow(&carrier, at);
        let numbers = self.numbers(&flow, at);
        let states = self.states();
        let (values, rates) = (&at.scalars.values[..states], &at.scalars.rates[..states]);
        let air = self.acting(at);
        let side = self.location.side;
        let Some(row) = row else {
            let report = self.strip.report(air, &numbers, values, rates);
            return Some(weight * quantity.on_side(side, quantity.of_report(&report)?));
        };
        if quantity == StripQuantity::TangentialLoad {
            return None;
        }
        let by = self.strip.linearize(air, &numbers, values, rates);
        let zero = ReportNumber::from_re(0.0);
        let (value, slopes) = self
            .strip
            .report_slopes(air, (&numbers, values), &by, |report| {
                quantity.of_report(report).unwrap_or(zero)
            });
        let slopes = slopes.map(|slope| weight * quantity.sense(side) * slope);
        let mut own = [0.0; FLOW];
        own[..OWN].copy_from_slice(&slopes[..OWN]);
        let by_motion = flow.slopes(&own);
        for j in 0..flow.point.count {
            for (variable, slope) in flow.by_node(at, j, &by_motion) {
                row.by_node(j, variable, &slope.transpose());
            }
        }
        if let Some(hub) = self.mount.hub {
            let variables = [Variable::Position, Variable::Rotation];
            let slopes = flow.slopes_by_hub(&own, &flow.by_turn_of_hub());
            for (variable, slope) in variables.into_iter().zip(slopes) {
                row.by_node(hub, variable, &slope.transpose());
            }
        }
        self.each_scalar(at, |column, input, slope| {
            row.by_scalar(column, slope * slopes[input]);
        });
        Some(weight * quantity.on_side(side, value))
    }
}

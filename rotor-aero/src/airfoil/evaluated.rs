//! The evaluated airfoil.

use std::sync::Arc;

use nalgebra::Vector4;
use num_dual::{Derivative, DualSVec64};

use super::check;
use super::constants::UnsteadyConstants;
use super::cubic::Interpolation;
use super::data::{AirfoilData, Coefficients, Curve, Flow};
use super::formula::{FlatPlate, LinearLift};
use super::problem::{AirfoilProblem, AirfoilRemark};
use super::stall_delay::StallDelay;
use super::table::{Slopes, Table};
use crate::real::Real;

/// Static coefficients of a section in a flow.
pub trait Profile {
    /// Coefficients in a flow; angles of attack are periodic, and numbers outside a table take
    /// the values of its ends.
    fn at<T: Real>(&self, flow: &Flow<T>) -> Coefficients<T>;
}

/// An airfoil that is checked and ready for evaluation.
#[derive(Debug, Clone, PartialEq)]
pub struct Airfoil {
    name: String,
    thickness: Option<f64>,
    mach_range: Option<[f64; 2]>,
    reynolds_range: Option<[f64; 2]>,
    flap_range: Option<[f64; 2]>,
    law: Law,
    remarks: Vec<AirfoilRemark>,
    unsteady: UnsteadyConstants,
    /// The table as given, unless its stall must not be delayed.
    source: Option<(Arc<AirfoilData>, Interpolation)>,
}

/// Largest lift of tables without a stall to delay \[-\].
const LIFTLESS: f64 = 0.2;

#[derive(Debug, Clone, PartialEq)]
enum Law {
    Table(Box<Tables>),
    Plate(FlatPlate),
    Linear(LinearLift),
}

#[derive(Debug, Clone, PartialEq)]
struct Tables {
    lift: Table,
    drag: Table,
    /// Zero if absent.
    moment: Option<Table>,
}

impl Airfoil {
    /// Checks a table and prepares its interpolation.
    ///
    /// # Errors
    /// All problems of the table, for which see [`AirfoilProblem`]. Peculiarities that are
    /// accepted are [`Airfoil::remarks`].
    pub fn new(
        data: &AirfoilData,
        interpolation: Interpolation,
    ) -> Result<Self, Vec<AirfoilProblem>> {
        let checked = check::checked(data)?;
        let table = |curves| Table::new(curves, interpolation);
        let absent = |coefficient| {
            let airfoil = data.name.clone();
            vec![AirfoilProblem::Absent {
                airfoil,
                coefficient,
            }]
        };
        let tables = Tables {
            lift: table(&checked.data.lift).ok_or_else(|| absent("lift"))?,
            drag: table(&checked.data.drag).ok_or_else(|| absent("drag"))?,
            moment: table(&checked.data.moment),
        };
        Ok(Self {
            name: data.name.clone(),
            thickness: data.thickness,
            mach_range: range(data, |curve| curve.mach),
            reynolds_range: range(data, |curve| curve.reynolds),
            flap_range: range(data, |curve| curve.flap),
            law: Law::Table(Box::new(tables)),
            remarks: checked.remarks,
            unsteady: UnsteadyConstants::default(),
            source: Some((Arc::new(data.clone()), interpolation)),
        })
    }

    /// A flat plate.
    pub fn flat_plate(plate: FlatPlate) -> Self {
        Self::of_law("flat plate", Law::Plate(plate))
    }

    /// An airfoil of linear lift, without stall.
    pub fn linear(lift: LinearLift) -> Self {
        Self::of_law("linear lift", Law::Linear(lift))
    }

    fn of_law(name: &str, law: Law) -> Self {
        Self {
            name: name.to_owned(),
            thickness: Some(0.0),
            mach_range: None,
            reynolds_range: None,
            flap_range: None,
            law,
            remarks: Vec::new(),
            unsteady: UnsteadyConstants::default(),
            source: None,
        }
    }

    /// The same, whose stall is not delayed again.
    #[must_use]
    pub fn without_stall_delay(self) -> Self {
        Self {
            source: None,
            ..self
        }
    }

    /// Whether it has a table whose stall may be delayed.
    pub fn has_stall_delay(&self) -> bool {
        self.source.is_some()
    }

    /// Reasons why the lift of its table has no line between two angles \[rad\], which a delay of stall needs; none
    /// without a table, and for tables whose lift is small at all angles, as of cylinders.
    pub fn without_line(&self, fit: [f64; 2]) -> Vec<AirfoilProblem> {
        let Some((data, _)) = &self.source else {
            return Vec::new();
        };
        let values = data.lift.iter().flat_map(|curve| &curve.values);
        if values.fold(0.0, |largest: f64, value| largest.max(value.abs())) < LIFTLESS {
            return Vec::new();
        }
        let delay = StallDelay::snel(1.0).with_fit(fit);
        data.with_stall_delay(&delay).err().unwrap_or_default()
    }

    /// The airfoil with delayed stall; `None` if it has no such table, or no lift to delay.
    pub(crate) fn with_stall_delay(&self, delay: &StallDelay) -> Option<Self> {
        let (data, interpolation) = self.source.as_ref()?;
        let delayed = data.with_stall_delay(delay).ok()?;
        let found = Self::new(&delayed, *interpolation).ok()?;
        let found = found.with_unsteady(self.unsteady.clone());
        Some(found.with_thickness(self.thickness).without_stall_delay())
    }

    /// The same with constants of unsteady models.
    #[must_use]
    pub fn with_unsteady(self, unsteady: UnsteadyConstants) -> Self {
        Self { unsteady, ..self }
    }

    /// The same with a thickness over chord, if one is given \[-\].
    #[must_use]
    pub fn with_thickness(self, thickness: Option<f64>) -> Self {
        Self {
            thickness: thickness.or(self.thickness),
            ..self
        }
    }

    /// Its constants of unsteady models.
    pub fn unsteady(&self) -> &UnsteadyConstants {
        &self.unsteady
    }

    /// Name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Thickness over chord, if known \[-\].
    pub fn thickness(&self) -> Option<f64> {
        self.thickness
    }

    /// Least and largest Mach number of the table; absent if it does not depend on it, or has a
    /// single one \[-\].
    pub fn mach_range(&self) -> Option<[f64; 2]> {
        self.mach_range
    }

    /// Least and largest Reynolds number of the table; absent if it does not depend on it, or has a
    /// single one \[-\].
    pub fn reynolds_range(&self) -> Option<[f64; 2]> {
        self.reynolds_range
    }

    /// Least and largest deflection of the flap in the table; absent if it does not depend on it,
    /// or has a single one \[rad\].
    pub fn flap_range(&self) -> Option<[f64; 2]> {
        self.flap_range
    }

    /// Peculiarities of the table that are accepted.
    pub fn remarks(&self) -> &[AirfoilRemark] {
        &self.remarks
    }

    /// Coefficients in a flow; angles of attack are periodic, and numbers outside the table take
    /// the values of its ends.
    pub fn at<T: Real>(&self, flow: &Flow<T>) -> Coefficients<T> {
        match &self.law {
            Law::Table(tables) => Coefficients {
                lift: tables.lift.at(flow),
                drag: tables.drag.at(flow),
                moment: match &tables.moment {
                    Some(table) => table.at(flow),
                    None => T::from(0.0),
                },
            },
            Law::Plate(plate) => plate.at(flow),
            Law::Linear(lift) => lift.at(flow),
        }
    }

    /// Coefficients in a flow, and their derivatives by its numbers in their order.
    pub(crate) fn slopes(&self, flow: &Flow<f64>) -> Coefficients<FlowNumber> {
        let Law::Table(tables) = &self.law else {
            return self.at(&variables(flow));
        };
        Coefficients {
            lift: number(tables.lift.slopes(flow)),
            drag: number(tables.drag.slopes(flow)),
            moment: match &tables.moment {
                Some(table) => number(table.slopes(flow)),
                None => FlowNumber::from_re(0.0),
            },
        }
    }

    /// The drag coefficient alone.
    pub(crate) fn drag(&self, flow: &Flow<f64>) -> f64 {
        match &self.law {
            Law::Table(tables) => tables.drag.at(flow),
            Law::Plate(_) | Law::Linear(_) => self.at(flow).drag,
        }
    }

    /// The same with derivatives.
    pub(crate) fn drag_slopes(&self, flow: &Flow<f64>) -> FlowNumber {
        match &self.law {
            Law::Table(tables) => number(tables.drag.slopes(flow)),
            Law::Plate(_) | Law::Linear(_) => self.at(&variables(flow)).drag,
        }
    }
}

/// A number with its derivatives by angle of attack, Mach number, Reynolds number and deflection.
pub(crate) type FlowNumber = DualSVec64<4>;

/// The numbers of a flow as variables.
fn variables(flow: &Flow<f64>) -> Flow<FlowNumber> {
    let variable = |number: f64, i: usize| FlowNumber::from_re(number).derivative(i);
    Flow {
        alpha: variable(flow.alpha, 0),
        mach: variable(flow.mach, 1),
        reynolds: variable(flow.reynolds, 2),
        flap: variable(flow.flap, 3),
    }
}

/// A number from its value and derivatives.
fn number([value, alpha, mach, reynolds, flap]: Slopes) -> FlowNumber {
    let slopes = Vector4::new(alpha, mach, reynolds, flap);
    FlowNumber::new(value, Derivative::some(slopes))
}

/// Least and largest condition of the curves of lift and drag; absent with fewer than two.
fn range(data: &AirfoilData, condition: fn(&Curve) -> Option<f64>) -> Option<[f64; 2]> {
    let curves = data.lift.iter().chain(&data.drag);
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    let [low, high] = curves
        .filter_map(condition)
        .fold(none, |[low, high], value| [low.min(value), high.max(value)]);
    (low < high).then_some([low, high])
}

impl Profile for Airfoil {
    fn at<T: Real>(&self, flow: &Flow<T>) -> Coefficients<T> {
        Airfoil::at(self, flow)
    }
}

#[cfg(test)]
#[path = "evaluated_tests.rs"]
mod tests;

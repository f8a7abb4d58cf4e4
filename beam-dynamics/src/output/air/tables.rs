//! Tables of strips, for programs.

use crate::elements::{AirState, StripQuantity};
use crate::output::rows::{csv_text, number};
use crate::output::text::RPM;

/// Degrees in one radian.
const DEGREES: f64 = 180.0 / std::f64::consts::PI;

/// Columns of flow and loads: heading, quantity, and its units in one SI unit.
const QUANTITIES: [(&str, StripQuantity, f64); 15] = [
    (
        "angle of attack [deg]",
        StripQuantity::AngleOfAttack,
        DEGREES,
    ),
    ("inflow angle [deg]", StripQuantity::InflowAngle, DEGREES),
    (
        "induced velocity [m/s]",
        StripQuantity::InducedVelocity,
        1.0,
    ),
    ("induced swirl [m/s]", StripQuantity::InducedSwirl, 1.0),
    ("flow speed [m/s]", StripQuantity::FlowSpeed, 1.0),
    ("CL [-]", StripQuantity::LiftCoefficient, 1.0),
    ("CD [-]", StripQuantity::DragCoefficient, 1.0),
    ("CM [-]", StripQuantity::MomentCoefficient, 1.0),
    ("Mach number [-]", StripQuantity::Mach, 1.0),
    ("Reynolds number [-]", StripQuantity::Reynolds, 1.0),
    ("normal load [N/m]", StripQuantity::NormalLoad, 1.0),
    ("tangential load [N/m]", StripQuantity::TangentialLoad, 1.0),
    ("lift load [N/m]", StripQuantity::LiftLoad, 1.0),
    ("drag load [N/m]", StripQuantity::DragLoad, 1.0),
    ("moment load [N]", StripQuantity::MomentLoad, 1.0),
];
const LOCATION: &str = "rotor,blade,strip,span [m],radius [m],azimuth [deg],x [m],y [m],z [m]";
const SUMS: &str = "force x [N],force y [N],force z [N],moment x [N m],moment y [N m],\
    moment z [N m],rotor speed [rpm]";

/// One row per strip of each group: its location, its flow and loads, its force and its moment about
/// the center of the shaft, without a rotor about the origin, in the axes of the model. `lead` are the headings of the values that
/// precede a group. Values that are not finite are empty.
pub(in crate::output) fn air_csv<'a>(
    lead: &str,
    groups: impl Iterator<Item = (Vec<String>, &'a [AirState])>,
) -> String {
    let quantities = QUANTITIES.map(|quantity| quantity.0).join(",");
    let rows = groups.flat_map(|(lead, states)| {
        states.iter().map(move |state| {
            let mut row = lead.clone();
            row.extend(cells(state));
            row
        })
    });
    csv_text(&format!("{lead},{LOCATION},{quantities},{SUMS}"), rows)
}

fn cells(state: &AirState) -> Vec<String> {
    let location = &state.location;
    let mut row = vec![
        location.rotor.clone().unwrap_or_default(),
        location.blade.clone(),
        location.number.to_string(),
    ];
    let mut values = vec![location.span, state.radius, state.azimuth * DEGREES];
    values.extend(state.position.iter());
    values.extend(QUANTITIES.map(|(_, quantity, factor)| factor * quantity.of(state)));
    values.extend(state.force.iter().chain(&state.moment));
    values.push(state.rotor.map_or(f64::NAN, |rotor| rotor.turning * RPM));
    let cell = |value: f64| {
        if value.is_finite() {
            number(value)
        } else {
            String::new()
        }
    };
    row.extend(values.into_iter().map(cell));
    row
}

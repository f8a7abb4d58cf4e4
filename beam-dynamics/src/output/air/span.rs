//! Flow and loads along the blades.

use shared_geom::figure::{Panel, PanelPlot};

use crate::elements::{AirState, StripQuantity};

/// Name, unit, quantity, and its units in one SI unit.
type Drawn = (&'static str, &'static str, StripQuantity, f64);

const QUANTITIES: [Drawn; 4] = [
    (
        "angle of attack",
        "deg",
        StripQuantity::AngleOfAttack,
        180.0 / std::f64::consts::PI,
    ),
    (
        "induced velocity",
        "m/s",
        StripQuantity::InducedVelocity,
        1.0,
    ),
    ("normal load", "N/m", StripQuantity::NormalLoad, 1.0),
    ("tangential load", "N/m", StripQuantity::TangentialLoad, 1.0),
];

/// The distributions over the radius, a curve for each blade; `None` without strips.
pub(in crate::output) fn span_plot(title: &str, states: &[AirState]) -> Option<PanelPlot> {
    let mut names: Vec<&str> = Vec::new();
    for state in states {
        if !names.contains(&state.location.blade.as_str()) {
            names.push(&state.location.blade);
        }
    }
    let panel = |(name, unit, quantity, factor): &Drawn| {
        let curve = |blade: &&str| {
            let own = states.iter().filter(|state| state.location.blade == *blade);
            own.map(|state| [position(state), factor * quantity.of(state)])
                .collect::<Vec<_>>()
        };
        Panel::scaled((name, unit), names.iter().map(curve).collect())
    };
    let count = states.iter().filter(|state| state.rotor.is_some()).count();
    (!states.is_empty()).then(|| PanelPlot {
        title: format!("{title}, air along the blades"),
        across: match count {
            0 => "position along the line [m]".to_owned(),
            count if count == states.len() => "radius [m]".to_owned(),
            _ => "radius, without a rotor position along the line [m]".to_owned(),
        },
        names: names.iter().map(|&name| name.to_owned()).collect(),
        panels: QUANTITIES.iter().map(panel).collect(),
    })
}

/// The radius of a strip, without a rotor its position along the line \[m\].
fn position(state: &AirState) -> f64 {
    match state.rotor {
        Some(_) => state.radius,
        None => state.location.span,
    }
}

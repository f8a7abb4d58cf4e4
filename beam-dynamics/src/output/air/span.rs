//! Flow and loads along the blades.

use crate::elements::{AirState, StripQuantity};
use crate::output::panels::{Panel, PanelPlot, scale};

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
        if !names.contains(&state.place.blade.as_str()) {
            names.push(&state.place.blade);
        }
    }
    let panel = |(name, unit, quantity, factor): &Drawn| {
        let curve = |blade: &&str| {
            let own = states.iter().filter(|state| state.place.blade == *blade);
            own.map(|state| [state.radius, factor * quantity.of(state)])
                .collect::<Vec<_>>()
        };
        let mut curves: Vec<_> = names.iter().map(curve).collect();
        let values = curves.iter().flatten().map(|point| point[1]);
        let (prefix, factor) = scale(unit, values);
        for point in curves.iter_mut().flatten() {
            point[1] *= factor;
        }
        Panel {
            title: format!("{name} [{prefix}{unit}]"),
            curves,
        }
    };
    (!states.is_empty()).then(|| PanelPlot {
        title: format!("{title}, air along the blades"),
        across: "radius [m]".to_owned(),
        names: names.iter().map(|&name| name.to_owned()).collect(),
        panels: QUANTITIES.iter().map(panel).collect(),
    })
}

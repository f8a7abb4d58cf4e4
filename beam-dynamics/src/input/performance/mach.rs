//! Mach numbers of operating points beyond the tables of airfoils.

use rotor_aero::airfoil::Section;
use rotor_aero::rotor::RigidRotor;
use shared_geom::document::Table;

use super::problem::PerformanceProblem;
use crate::case::{OperatingSetting, PerformancePart, PerformanceRequest};
use crate::input::aerodynamics::mach_limits;

/// Notes each airfoil whose tables end below the Mach numbers of the points, which are formed
/// without induction; `sound_speed` \[m/s\].
pub(super) fn check(
    (table, key): (&Table<'_>, &str),
    rotor: &RigidRotor<Section>,
    parts: &[PerformancePart],
    sound_speed: f64,
) {
    let stations = rotor.stations.iter();
    let limits = mach_limits(stations.map(|station| (station.radius, &station.section)));
    for limit in limits {
        let of_part = |part: &PerformancePart| {
            let speed = |at: &OperatingSetting| at.speed.hypot(at.omega * limit.radius);
            let speeds = fastest(part).into_iter().map(|at| speed(&at));
            (speeds.fold(0.0, f64::max) / sound_speed, part.name.clone())
        };
        let parts = parts.iter().map(of_part);
        let Some((found, part)) = parts.max_by(|a, b| a.0.total_cmp(&b.0)) else {
            continue;
        };
        if found > limit.range[1] {
            let problem = PerformanceProblem::Mach {
                airfoil: limit.airfoil,
                largest: limit.range[1],
                found,
                part,
            };
            table.note(key, &problem);
        }
    }
}

/// Points among which the fastest is; of a power curve a bound.
fn fastest(part: &PerformancePart) -> Vec<OperatingSetting> {
    match &part.request {
        PerformanceRequest::Settings(settings) => settings.clone(),
        PerformanceRequest::PowerCurve(curve) => vec![OperatingSetting {
            speed: curve.speeds.iter().copied().fold(0.0, f64::max),
            omega: curve.rotor_speeds[1],
            pitch: 0.0,
        }],
    }
}

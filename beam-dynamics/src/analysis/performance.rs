//! Performance of a rigid rotor at all requested operating points, in parallel. A point does not
//! depend on the others: the result is the same for any number of threads.

use rayon::iter::{IntoParallelIterator, ParallelIterator};
use rotor_aero::airfoil::Section;
use rotor_aero::rotor::{
    BalanceOutcome, OperatingPoint, Performance, RigidRotor, balanced_speed, pitch_for_power,
};

use crate::case::{
    OperatingSetting, PerformanceCase, PerformancePart, PerformanceRequest, PowerCurve,
    RotorSpeedLaw, linear_between,
};
use crate::result::{PerformancePoint, PerformanceResult, PerformanceTable, PointStatus};
use limits::Reached;

mod limits;

/// Relative difference up to which a point is at a chosen value of the abscissa [-].
const SAME: f64 = 1e-6;

/// Computes every point of a case.
pub fn performance(case: &PerformanceCase) -> PerformanceResult {
    let tables = case.parts.iter().map(|part| table(case, part));
    let (tables, reached): (Vec<_>, Vec<_>) = tables.unzip();
    let beyond = limits::remarks(&reached.concat());
    PerformanceResult {
        name: case.name.clone(),
        machine: case.machine,
        blades: case.rotor.blades,
        disk_radius: case.rotor.disk_radius(),
        density: case.air.density,
        tables,
        remarks: case.remarks.iter().cloned().chain(beyond).collect(),
    }
}

/// The points of a part, and the Mach and Reynolds numbers that they reach.
fn table(case: &PerformanceCase, part: &PerformancePart) -> (PerformanceTable, Vec<Reached>) {
    let points = (0..part.request.count()).into_par_iter();
    let points = points.filter_map(|index| {
        let mut point = point(case, &part.request, index)?;
        let of = (case.machine, part.abscissa);
        let reached = Reached::of(&case.rotor, &point.performance, of);
        let radius = point.performance.disk_radius;
        let at = part.abscissa.of(&point.setting(), radius);
        let is_at = |chosen: &f64| (at - chosen).abs() <= SAME * chosen.abs().max(1.0);
        if !part.loads_at.iter().any(is_at) {
            point.performance.sectors = Vec::new();
        }
        Some((point, reached))
    });
    let (points, reached) = points.unzip();
    let table = PerformanceTable {
        name: part.name.clone(),
        abscissa: part.abscissa,
        curves: part.curves.clone(),
        is_map: part.is_map,
        points,
    };
    (table, reached)
}

/// The point number `index`, from zero.
fn point(
    case: &PerformanceCase,
    request: &PerformanceRequest,
    index: usize,
) -> Option<PerformancePoint> {
    match request {
        PerformanceRequest::Settings(settings) => Some(PerformancePoint {
            performance: case
                .rotor
                .performance(&operating(case, settings.get(index)?)),
            status: PointStatus::Given,
        }),
        PerformanceRequest::PowerCurve(curve) => {
            Some(controlled(case, curve, *curve.speeds.get(index)?))
        }
    }
}

fn operating(case: &PerformanceCase, at: &OperatingSetting) -> OperatingPoint {
    OperatingPoint {
        speed: at.speed,
        omega: at.omega,
        pitch: at.pitch,
        ..case.air
    }
}

/// The point of a turbine under control: the speed of rotation by its law at the pitch below rated
/// power; if the power is then above rated power, the largest speed of rotation and the pitch for
/// rated power.
fn controlled(case: &PerformanceCase, curve: &PowerCurve, speed: f64) -> PerformancePoint {
    let start = OperatingSetting {
        speed,
        omega: curve.rotor_speeds[1],
        pitch: curve.pitch,
    };
    let below = below_rated(&case.rotor, &operating(case, &start), curve);
    let rated = curve.rated.filter(|rated| below.power > rated.power);
    let Some(rated) = rated else {
        return PerformancePoint {
            performance: below,
            status: PointStatus::BelowRated,
        };
    };
    let limits = (curve.pitch, rated.largest_pitch);
    match pitch_for_power(&case.rotor, &operating(case, &start), rated.power, limits) {
        BalanceOutcome::Found(performance) => PerformancePoint {
            performance: *performance,
            status: PointStatus::Rated,
        },
        BalanceOutcome::NotBracketed { .. } => PerformancePoint {
            performance: below,
            status: PointStatus::NoPitch,
        },
    }
}

/// The performance at the speed of rotation that follows from the law of a curve.
fn below_rated(
    rotor: &RigidRotor<Section>,
    start: &OperatingPoint,
    curve: &PowerCurve,
) -> Performance {
    let [least, largest] = curve.rotor_speeds;
    let at = |omega: f64| rotor.performance(&OperatingPoint { omega, ..*start });
    let load: Box<dyn Fn(f64) -> f64 + '_> = match &curve.law {
        RotorSpeedLaw::TipSpeedRatio(ratio) => {
            let omega = ratio * start.speed / rotor.disk_radius();
            return at(omega.clamp(least, largest));
        }
        RotorSpeedLaw::TorqueGain(gain) => Box::new(move |omega| gain * omega * omega),
        RotorSpeedLaw::Torque(rows) => Box::new(|omega| linear_between(rows, omega)),
    };
    match balanced_speed(rotor, start, load, (least, largest)) {
        BalanceOutcome::Found(performance) => *performance,
        // The rotor drives the load at all speeds, or at none.
        BalanceOutcome::NotBracketed { high, .. } if high > 0.0 => at(largest),
        BalanceOutcome::NotBracketed { .. } => at(least),
    }
}

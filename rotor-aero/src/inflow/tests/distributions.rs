//! Mean and first harmonic of the distributions over the disk.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::polar;
use crate::inflow::{Drees, Inflow, Loading, ManglerSquire, PittPeters, RotorFlow};

/// Points and weights of the Gauss rule with four points.
const GAUSS: [(f64, f64); 4] = [
    (-0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
    (-0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
    (0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
    (0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
];

/// Integral over the disk, over pi: Gauss in the angle of `r = cos(angle)`, by which the
/// square root at the edge is smooth, and equal steps of azimuth.
fn disk(value: impl Fn(f64, f64) -> f64) -> f64 {
    let sectors = 24;
    let mut sum = 0.0;
    for panel in 0..8 {
        for (at, weight) in GAUSS {
            let angle = FRAC_PI_2 * (f64::from(panel) + 0.5 + 0.5 * at) / 8.0;
            let radius = angle.cos();
            for sector in 0..sectors {
                let azimuth = TAU * f64::from(sector) / f64::from(sectors);
                let area = radius * angle.sin() * weight * FRAC_PI_2 / 16.0;
                sum += value(radius, azimuth) * area * TAU / f64::from(sectors);
            }
        }
    }
    sum / PI
}

fn flow(advance: f64) -> RotorFlow<f64> {
    RotorFlow {
        advance,
        axial: 0.01,
        speed: 1.0,
    }
}

fn check<M: Inflow>(model: &M, states: &[f64], advance: f64) {
    let flow = flow(advance);
    let at = |radius, azimuth| {
        let position = polar(radius, azimuth);
        model.induced(&flow, states, &position).unwrap()
    };
    // Gauss rule on smooth functions: rounding.
    assert!(
        (disk(at) - states[0]).abs() < 1e-10,
        "{}",
        disk(at) - states[0]
    );
    let moment = disk(|radius, azimuth| at(radius, azimuth) * radius * azimuth.cos());
    if advance > 0.0 {
        assert!(moment > 0.0, "larger aft: {moment}");
        assert!(at(1.0, 0.0) > at(1.0, PI), "larger at the aft edge");
    } else {
        assert!(moment.abs() < 1e-12, "symmetric in hover: {moment}");
    }
}

#[test]
fn the_mean_is_the_first_state_and_inflow_is_larger_aft() {
    for advance in [0.0, 0.1, 0.2, 0.35] {
        for loading in [Loading::Elliptic, Loading::ZeroAtHub] {
            check(&ManglerSquire { loading }, &[0.03], advance);
        }
        check(&Drees, &[0.03], advance);
        let aft = if advance > 0.0 { 0.02 } else { 0.0 };
        check(&PittPeters, &[0.03, -0.01, aft], advance);
    }
}

#[test]
fn the_front_edge_has_upwash_at_high_speed() {
    // Ahead of a lifting surface air rises: the edge has c_0 = 0, and the first harmonic there
    // decides the sign ([Mangler1950] has it so for both loadings).
    for loading in [Loading::Elliptic, Loading::ZeroAtHub] {
        let front = ManglerSquire { loading }.induced(&flow(0.35), &[0.01], &polar(1.0, PI));
        assert!(front.unwrap() < 0.0, "{front:?}");
    }
}

#[test]
fn less_inflow_on_the_advancing_side() {
    let at = |azimuth| {
        let position = polar(0.7, azimuth);
        Drees.induced(&flow(0.2), &[0.02], &position).unwrap()
    };
    assert!(at(FRAC_PI_2) < at(-FRAC_PI_2));
}

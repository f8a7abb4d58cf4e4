//! Friction of the flow along the span: its closed form, its energy and its derivatives.

use std::sync::Arc;

use super::{ActingAir, FLOW, SectionModel, Strip, StripDesign};
use crate::airfoil::{Flow, Section, built_in};
use crate::wind::Atmosphere;

const CHORD: f64 = 0.3;

fn strip(name: &str, radial_drag: bool) -> Strip {
    Strip::new(StripDesign {
        chord: CHORD,
        section: section(name),
        model: SectionModel::of_word("quasi_steady").unwrap(),
        inflow: None,
        radial_drag,
    })
}

fn section(name: &str) -> Section {
    Section::single(Arc::new(built_in(name).unwrap()))
}

/// A section without rotation: velocity against the air, shaft along y.
fn flow(velocity: [f64; 3]) -> [f64; FLOW] {
    let [x, y, z] = velocity;
    [x, y, z, 0.0, 0.0, 1.0, 0.0, 1.0, 2.0, 0.0]
}

/// Velocities of up to 40 m/s in all directions.
fn velocities() -> impl Iterator<Item = [f64; 3]> {
    (0..500).map(|k| {
        let of = |factor: f64| 80.0 * ((f64::from(k) * factor).fract() - 0.5);
        [of(0.754_877_67), of(0.569_840_29), of(0.618_033_99)]
    })
}

/// `F_z = - rho/2 c c_d(0) w_z |w|` in the thesis, 5.9; the smooth speed of 1e-3 m/s is below 1e-6
/// of the force at speeds above 1 m/s.
#[test]
fn it_is_the_drag_at_zero_angle_along_the_span() {
    let still = Atmosphere::default();
    let air = ActingAir {
        still: &still,
        part: 0.7,
    };
    for name in ["naca0012", "flat_plate", "thin"] {
        let (with, without) = (strip(name, true), strip(name, false));
        for velocity in velocities() {
            let [x, y, z] = velocity;
            let speed = x.hypot(y).hypot(z);
            let in_plane = x.hypot(y);
            let drag = section(name).at(&Flow {
                alpha: 0.0,
                mach: in_plane / still.sound_speed,
                reynolds: in_plane * CHORD * still.density / still.viscosity,
                flap: 0.0,
            });
            let expected = -0.5 * 0.7 * still.density * CHORD * drag.drag * z * speed;
            let found = with.evaluate(air, &flow(velocity), &[], &[]);
            let size = 1.0 + expected.abs();
            assert!(
                (found[2] - expected).abs() < 1e-5 * size,
                "{name} {velocity:?}"
            );
            // it takes energy, and leaves the section as it is
            assert!(found[2] * z <= 0.0, "{name} {velocity:?}");
            let other = without.evaluate(air, &flow(velocity), &[], &[]);
            assert_eq!(other[2], 0.0);
            assert_eq!(
                [found[0], found[1], found[3]],
                [other[0], other[1], other[3]]
            );
        }
    }
}

/// Central differences of 1e-4 m/s; at rest the force and its derivative by the velocity along the
/// span are small: `rho/2 c c_d` times the smooth speed.
#[test]
fn its_derivatives_are_exact() {
    let still = Atmosphere::default();
    let air = ActingAir {
        still: &still,
        part: 1.0,
    };
    let strip = strip("naca0012", true);
    for velocity in velocities().chain([[0.0; 3]]) {
        let at = flow(velocity);
        let jacobian = strip.linearize(air, &at, &[], &[]);
        for k in 0..3 {
            let side = |step: f64| {
                let mut moved = at;
                moved[k] += step;
                strip.evaluate(air, &moved, &[], &[])[2]
            };
            let expected = (side(1e-4) - side(-1e-4)) / 2e-4;
            let error = (jacobian.by[2][k] - expected).abs();
            assert!(error < 1e-6, "{velocity:?} {k}: {error:e}");
        }
    }
}

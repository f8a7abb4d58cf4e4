//! Pendulums on stiff and on elastic rods, in `cases/dynamics/bathe_pendulum` and
//! `cases/dynamics/deformable_pendulum`.
//!
//! Sources: `tests/reference/dynamics/bathe_pendulum.csv`, `deformable_pendulum_unstretched.csv`
//! and `_balanced.csv` in the same folder.

use beam_dynamics::integrator::{Scheme, Stepping};

use crate::in_time::{Run, Table};
use crate::record;

/// Angle from the downward vertical \[deg\], positive to the side of x.
fn angle(run: &Run, time: f64) -> f64 {
    let position = run.motion("mass", time).position;
    position.x.atan2(-position.y).to_degrees()
}

/// Largest error of the angle over ten seconds \[deg\].
fn angle_error(file: &str, step: f64) -> f64 {
    let every = (0.05 / step).round() as usize;
    let run = Run::new("bathe_pendulum", file, every, |settings| {
        settings.stepping = Stepping::Constant { step };
    });
    let table = Table::new("bathe_pendulum.csv");
    let errors = table
        .rows
        .iter()
        .map(|row| (angle(&run, row[0]) - row[1]).abs());
    errors.fold(0.0, f64::max)
}

/// 0.05 degrees over ten seconds at 5 ms. The stretch of the rod, 3e-7 of it, is negligible in
/// both.
#[test]
fn bathes_pendulum_keeps_its_angle() {
    let source = "equation of the angle, 1e-12";
    for name in ["elastic", "rigid"] {
        let error = angle_error(&format!("{name}.dynamics.toml"), 5e-3);
        let case = format!("Bathe's pendulum, {name} rod");
        record::largest(source, &case, "angle to 10 s, step 5 ms [deg]", error, 0.05);
        assert!(error < 0.05, "{case}: {error}");
    }
}

/// Elongation of the rod.
fn elongation(run: &Run, time: f64) -> f64 {
    run.motion("mass", time).position.norm() - 1.0
}

/// Largest error of the elongation over the first second, relative to its peak; later, near the
/// top, the path is sensitive.
fn elongation_error(start: &str, scheme: Scheme) -> f64 {
    let file = format!("{start}.dynamics.toml");
    let run = Run::new("deformable_pendulum", &file, 80, |settings| {
        settings.to = 1.0;
        settings.scheme = scheme;
    });
    let table = Table::new(&format!("deformable_pendulum_{start}.csv"));
    let column = table.column("elongation");
    let rows = || table.rows.iter().filter(|row| row[0] < 1.0 + 1e-9);
    let peak = rows().map(|row| row[column].abs()).fold(0.0, f64::max);
    let errors = rows().map(|row| (elongation(&run, row[0]) - row[column]).abs());
    errors.fold(0.0, f64::max) / peak
}

/// 1 % of the peak at a quarter of a millisecond: with the two-step scheme if the rod does not
/// ring; if it rings, fifty times in this second, with the scheme of third order.
#[test]
fn the_rod_stretches_as_it_should() {
    let source = "ordinary differential equations, 1e-12";
    for (start, scheme, name) in [
        ("balanced", Scheme::default(), "two steps"),
        ("unstretched", Scheme::Cubic { radius: 0.6 }, "cubic"),
    ] {
        let error = elongation_error(start, scheme);
        let case = format!("deformable pendulum, {start}, {name}");
        record::largest(source, &case, "elongation to 1 s, of its peak", error, 0.01);
        assert!(error < 0.01, "{case}: {error:e}");
    }
}

/// The two-step scheme of radius 0.6 has an error of 8 % of the ringing at one second with steps of
/// a quarter of a millisecond; another program with the same scheme has it too. Its first steps
/// differ: 1 % of the amplitude.
#[test]
fn the_ringing_by_two_steps() {
    let source = "the same scheme in another program";
    let file = "unstretched.dynamics.toml";
    let run = Run::new("deformable_pendulum", file, 80, |settings| {
        settings.to = 1.0
    });
    for (time, expected) in [(0.5, -4.417_865_386e-4), (1.0, -3.318_373_583e-4)] {
        let found = elongation(&run, time);
        let error = (found - expected).abs();
        let quantity = format!("elongation at {time} s [m]");
        let case = "deformable pendulum, unstretched";
        record::value(source, case, &quantity, [found, expected], error, 1e-10);
        assert!(error < 1e-10, "{quantity}: {found:e} {expected:e}");
    }
}

/// The elongations of the first five steps of 20 ms, which do not resolve them: the result of the
/// scheme, to the digits of an independent script without the multiplier, with the unknowns x, y
/// and their rates.
#[test]
fn a_step_too_long_for_the_rod() {
    let source = "the same scheme on x and y by an independent script";
    let case = "deformable pendulum at 20 ms";
    for (file, radius, expected, tolerance) in [
        (
            "unstretched",
            0.6,
            [
                0.000_911_5,
                0.000_355_9,
                0.000_338_3,
                0.000_752_3,
                0.000_183_1,
            ],
            1e-7,
        ),
        (
            "unstretched",
            1.0,
            [0.000_911_5, 0.000_312_1, 0.000_363_4, 0.000_837_3, -5.04e-5],
            1e-7,
        ),
        (
            "balanced",
            0.6,
            [
                0.000_503_7,
                0.000_495_9,
                0.000_484_7,
                0.000_469_1,
                0.000_450_2,
            ],
            1e-7,
        ),
    ] {
        let name = format!("{file}.dynamics.toml");
        let run = Run::new("deformable_pendulum", &name, 1, |settings| {
            settings.to = 0.1;
            settings.stepping = Stepping::Constant { step: 0.02 };
            settings.scheme = Scheme::TwoStep { radius };
        });
        for (step, expected) in (1..).zip(expected) {
            let found = elongation(&run, 0.02 * f64::from(step));
            let error = (found - expected).abs();
            let quantity = format!("{file}, radius {radius}: elongation after {step} steps [m]");
            record::value(source, case, &quantity, [found, expected], error, tolerance);
            assert!(error < tolerance, "{quantity}: {found:e} {expected:e}");
        }
    }
}

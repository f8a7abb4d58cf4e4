//! The swinging cantilever, in `cases/dynamics/swinging_cantilever`.
//!
//! Sources: two other programs, one with the same elements and the same step, the other
//! with two-node elements, 200 of them: their tips agree within 4e-7 after 0.2 s;
//! `tests/reference/dynamics/swinging_cantilever.csv`: the former at a quarter of the step.

use beam_dynamics::integrator::Stepping;
use nalgebra::Vector3;

use crate::in_time::{Run, Table};
use crate::record;

const SOURCE: &str = "the same elements in another program";
const CASE: &str = "swinging cantilever";

fn run(to: f64, step: f64, every: usize) -> Run {
    let file = "swinging_cantilever.dynamics.toml";
    Run::new("swinging_cantilever", file, every, |question| {
        question.to = to;
        question.stepping = Stepping::Constant { step };
    })
}

/// One second at 1 ms. The other program starts in another way, and the step leaves the
/// axial waves of the first instant: 1e-6 at 0.2 s; later what waves of another start have
/// become in a motion that goes on for a second: 1e-5.
#[test]
fn the_tip_over_a_second() {
    let run = run(1.0, 1e-3, 200);
    for (time, tip, tolerance) in [
        (
            0.2,
            [0.839_347_753_6, 0.413_019_030_8, -0.266_564_889_7],
            1e-6,
        ),
        (
            0.4,
            [0.336_670_428_7, 0.492_138_990_4, -0.670_272_083_2],
            1e-5,
        ),
        (
            0.6,
            [0.411_957_889_5, 0.114_025_743_4, -0.811_324_712_6],
            1e-5,
        ),
        (
            0.8,
            [0.869_128_080_3, 0.251_378_754_3, -0.393_305_791_6],
            1e-5,
        ),
        (
            1.0,
            [0.767_067_321_7, 0.540_206_355_8, 0.168_048_615_3],
            1e-5,
        ),
    ] {
        let found = run.motion("beam/tip", time).position;
        let error = (found - Vector3::from(tip)).norm();
        let quantity = format!("tip at {time} s, step 1 ms [m]");
        record::largest(SOURCE, CASE, &quantity, error, tolerance);
        assert!(error < tolerance, "{time} s: {found} {error:e}");
    }
}

/// At a quarter of the step, all along the first fifth of a second.
#[test]
fn the_path_of_the_tip() {
    let run = run(0.2, 2.5e-4, 1);
    let table = Table::new("swinging_cantilever.csv");
    let rows = table.rows.iter().filter(|row| row[0] < 0.2);
    let errors = rows.map(|row| {
        let found = run.motion("beam/tip", row[0]).position;
        (found - table.vector(row, "x_tip")).norm()
    });
    let error = errors.fold(0.0, f64::max);
    record::largest(
        SOURCE,
        CASE,
        "path of the tip to 0.2 s, step 0.25 ms [m]",
        error,
        1e-5,
    );
    assert!(error < 1e-5, "{error:e}");
}

//! The swinging cantilever, in `cases/dynamics/swinging_cantilever`.
//!
//! Sources: another program with the finite-volume elements of the thesis and the same
//! step; `tests/reference/dynamics/swinging_cantilever.csv`: the same at a quarter of the
//! step. The limit of fine meshes: our own finite volumes of 40 and 80 elements, of second
//! order, extrapolated.

use beam_dynamics::integrator::Stepping;
use nalgebra::Vector3;

use crate::case_files::Case;
use crate::in_time::{Run, Table};
use crate::record;

const SOURCE: &str = "the same elements in another program";
const CASE: &str = "swinging cantilever";

const FILE: &str = "swinging_cantilever.dynamics.toml";

/// For the elements of the thesis.
fn run(to: f64, step: f64, every: usize) -> Run {
    let case = Case::new("swinging_cantilever");
    case.replace(
        FILE,
        "inertia = \"lumped\"",
        "formulation = \"finite-volume\"",
    );
    run_of(&case, to, step, every)
}

fn run_of(case: &Case, to: f64, step: f64, every: usize) -> Run {
    let run = Run::of_file(&case.path(FILE), every, |settings| {
        settings.to = to;
        settings.stepping = Stepping::Constant { step };
    });
    run.check_end();
    run
}

/// The default beams at 1 ms: 4e-6 from the limit; the error of twenty finite volumes is 3e-5; with
/// the meshes of the extrapolation, 2e-6 apart, 1e-5 is allowed.
#[test]
fn twenty_variational_beams_are_near_the_limit_of_fine_meshes() {
    let run = run_of(&Case::new("swinging_cantilever"), 0.2, 1e-3, 200);
    let limit = Vector3::new(0.839_367_227, 0.412_995_090, -0.266_566_567);
    let found = run.motion("beam/tip", 0.2).position;
    let error = (found - limit).norm();
    let source = "finite volumes, 40 and 80 elements, extrapolated";
    record::largest(source, CASE, "tip at 0.2 s, step 1 ms [m]", error, 1e-5);
    assert!(error < 1e-5, "{found} {error:e}");
}

/// One second at 1 ms. The other program starts in another way, and the step does not damp the
/// axial waves of the first instant: 1e-6 at 0.2 s; later the effect of the waves of another start
/// on a motion of a second: 1e-5.
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

/// At a quarter of the step, over the first fifth of a second.
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

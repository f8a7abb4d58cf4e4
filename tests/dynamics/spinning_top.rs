//! The spinning top, in `cases/dynamics/spinning_top`.
//!
//! Source: `tests/reference/dynamics/spinning_top_case?.csv`.

use beam_dynamics::integrator::Stepping;

use crate::in_time::{Run, Table};
use crate::record;

/// Largest distance of the mass center from the reference.
fn error(case: usize, to: f64, step: f64) -> f64 {
    let file = format!("case_{case}.dynamics.toml");
    let every = (0.05 / step).round() as usize;
    let run = Run::new("spinning_top", &file, every, |settings| {
        settings.to = to;
        settings.stepping = Stepping::Constant { step };
    });
    let table = Table::new(&format!("spinning_top_case{case}.csv"));
    let rows = table.rows.iter().filter(|row| row[0] < to + 1e-9);
    let errors = rows.map(|row| {
        let found = run.motion("top", row[0]).position;
        (found - table.vector(row, "x")).norm()
    });
    errors.fold(0.0, f64::max)
}

/// 1e-5 over ten seconds at a step of 1 ms. The largest error is in the first case; the others are
/// ten times smaller.
#[test]
fn the_mass_center_follows_its_path() {
    let source = "rotation-matrix equations, 1e-11";
    for (case, tolerance) in [(1, 1e-5), (2, 1e-5), (3, 1e-5)] {
        let error = error(case, 10.0, 1e-3);
        let name = format!("spinning top, case {case}");
        record::largest(
            source,
            &name,
            "mass center to 10 s, step 1 ms",
            error,
            tolerance,
        );
        assert!(error < tolerance, "{name}: {error:e}");
    }
}

/// Second order in the step.
#[test]
fn the_error_falls_with_the_square_of_the_step() {
    let [coarse, fine] = [0.01, 0.005].map(|step| error(3, 10.0, step));
    let order = (coarse / fine).log2();
    record::order("halved step", "spinning top, case 3", "order", order, 1.9);
    assert!(order > 1.9, "{coarse:e} {fine:e}");
}

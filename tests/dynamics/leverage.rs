//! The flexible leverage, in `cases/dynamics/flexible_leverage`.
//!
//! Sources: `tests/reference/dynamics/flexible_leverage_2_beams.csv`, `_4_beams.csv`: the
//! same elements in another program, at a fine step; the range of the peak from
//! independent runs with several meshes and steps.

use crate::in_time::{Run, Table};
use crate::record;

/// The path of the mass at the time of a row, by cubics through the steps around it: the steps of a
/// run with variable step do not end at the times of the rows.
fn position(run: &Run, node: usize, time: f64) -> nalgebra::Vector3<f64> {
    let after = run.instants.iter().position(|(t, _)| *t >= time).unwrap();
    if after == 0 {
        return run.instants[0].1.nodes[node].position;
    }
    let [a, b] = [after - 1, after].map(|number| &run.instants[number]);
    let (h, x) = (b.0 - a.0, (time - a.0) / (b.0 - a.0));
    let (from, to) = (&a.1.nodes[node], &b.1.nodes[node]);
    let (back, on) = (1.0 - x, x);
    from.position * (back * back * (1.0 + 2.0 * on))
        + to.position * (on * on * (1.0 + 2.0 * back))
        + (from.velocity * back - to.velocity * on) * (h * on * back)
}

fn check(beams: usize, word: &str) {
    let source = "the same elements in another program";
    let run = Run::new(
        "flexible_leverage",
        &format!("{word}_beams.dynamics.toml"),
        1,
        |settings| settings.to = 0.645,
    );
    let table = Table::new(&format!("flexible_leverage_{beams}_beams.csv"));
    let middle = run.node("middle");
    let (x, y) = (table.column("x_mid"), table.column("y_mid"));
    let mut error = 0.0_f64;
    for row in table.rows.iter().filter(|row| row[0] < 0.6) {
        let found = position(&run, middle, row[0]);
        error = error.max((found.x - row[x]).hypot(found.y - row[y]));
    }
    let case = format!("flexible leverage, {beams} beams");
    record::largest(source, &case, "path of the mass to 0.6 s [m]", error, 1e-4);
    assert!(error < 1e-4, "{case}: {error:e}");
    let pulls = run.instants.iter().map(|(time, state)| {
        let conditions = run.model.conditions_at(*time);
        let sections = run.model.system.observe(state, &conditions).sections;
        let pulls = sections.iter().map(|section| section.internal_force[0]);
        (pulls.fold(f64::NEG_INFINITY, f64::max), *time)
    });
    let (peak, time) = pulls.fold((0.0, 0.0), |a, b| if b.0 > a.0 { b } else { a });
    record::value(
        "independent runs, 2 and 4 beams, several steps",
        &case,
        "time of the largest tension [s]",
        [time, 0.64],
        (time - 0.64).abs(),
        0.005,
    );
    assert!((time - 0.64).abs() < 0.005, "{case}: {peak} N at {time} s");
    // The range of the runs, relative to its middle.
    let source = "independent runs, 2 and 4 beams, several steps";
    let quantity = "largest tension, range [N]";
    let off = (peak - 120.0).abs();
    record::value(source, &case, quantity, [peak, 120.0], off, 30.0);
    assert!(
        (90.0..150.0).contains(&peak),
        "{case}: {peak} N at {time} s"
    );
}

#[test]
fn two_beams() {
    check(2, "two");
}

#[test]
fn four_beams() {
    check(4, "four");
}

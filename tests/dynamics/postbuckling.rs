//! A column pushed slowly beyond its critical load, in `cases/dynamics/buckling`.
//!
//! Source: the elastica, `tests/reference/dynamics/exact_static_beams.json`.

use crate::case_files::Case;
use crate::in_time::Run;
use crate::record;

/// At rest after the push, four elements: 5e-4 of the length from the elastica, and below
/// the critical load straight.
#[test]
fn a_column_stays_bent_beyond_its_critical_load() {
    for (load, [x, z]) in [
        (0.5, [1.0, 0.0]),
        (1.5, [0.363_588_22, 0.788_575_81]),
        (2.0, [0.070_861_82, 0.796_961_42]),
    ] {
        let case = Case::new("buckling");
        let critical = std::f64::consts::PI.powi(2) / 4.0;
        let file = "buckling.dynamics.toml";
        let given = "load = 3.701101650408628";
        case.replace(file, given, &format!("load = {}", load * critical));
        let run = Run::of_file(&case.path(file), 1, |_| {});
        run.check_end();
        let (_, last) = run.instants.last().unwrap();
        let tip = last.nodes[run.node("column/tip")].position;
        let error = (tip.x - x).hypot(tip.z - z);
        let name = format!("column under {load} critical loads");
        record::largest("elastica, Figure 10.13", &name, "tip at rest", error, 5e-4);
        assert!(error < 5e-4, "{name}: {tip}");
    }
}

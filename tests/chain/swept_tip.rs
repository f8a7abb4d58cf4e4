//! Swept-tip blades of Epps and Chandra, from the mesh of the strip.
//!
//! Source: `tests/reference/rotors/epps_chandra_swept_tip.json`: measured frequencies of
//! an aluminum strip with a tip swept by 0, 15, 30 and 45 degrees at 0, 500, 750 rpm.
//! Tolerance: 10 % or 1 Hz for the first three flap modes, 10 % for the three following
//! modes at 750 rpm, as in the validation of another beam program that the file names. It
//! is the uncertainty of the experiment: at rest the strip's first three frequencies
//! follow from its dimensions to 1 %, and the measured ones scatter by up to 0.5 Hz
//! around them.

use std::path::{Path, PathBuf};

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::result::{Comparison, FrequencyTable, Measured};

use crate::record;

const SWEEPS: [usize; 4] = [0, 15, 30, 45];

/// The case and its mesh in a separate folder, with the section analyzed.
struct Chain {
    folder: tempfile::TempDir,
}

pub fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        if entry.file_type().unwrap().is_file() {
            std::fs::copy(entry.path(), to.join(entry.file_name())).unwrap();
        }
    }
}

impl Chain {
    fn analyzed() -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let folder = tempfile::tempdir().unwrap();
        for part in ["cases/chain/swept_tip", "meshes/strip"] {
            copy(&root.join(part), &folder.path().join(part));
        }
        let chain = Self { folder };
        let section = chain.case("strip.section.toml");
        let arguments = ["section-analyzer".into(), "analyze".into(), section.into()];
        let (mut out, mut err) = (Vec::new(), Vec::new());
        let code = section_analyzer::cli::run(arguments, &mut out, &mut err);
        assert_eq!(code, 0, "{}", String::from_utf8_lossy(&err));
        chain
    }

    fn case(&self, file: &str) -> PathBuf {
        self.folder.path().join("cases/chain/swept_tip").join(file)
    }

    fn frequencies(&self, sweep: usize) -> (FrequencyTable, Measured) {
        let file = self.case(&format!("sweep_{sweep:02}.dynamics.toml"));
        let input = beam_dynamics::input::read(&file).unwrap();
        let outcome = modes(&input.model, input.modes.as_ref().unwrap());
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        (outcome.table, input.measured)
    }
}

/// Measured frequencies of the reference file: (rpm, order without lag, Hz).
fn reference(sweep: usize) -> Vec<(f64, usize, f64)> {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/reference/rotors/epps_chandra_swept_tip.json"
    );
    let text = std::fs::read_to_string(path).unwrap();
    let file: serde_json::Value = serde_json::from_str(&text).unwrap();
    let row = SWEEPS.iter().position(|s| *s == sweep).unwrap();
    let measured = &file["experiment_Hz"];
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    let mut points = Vec::new();
    for (column, rpm) in [0.0, 500.0, 750.0].into_iter().enumerate() {
        for order in 1..=3 {
            points.push((
                rpm,
                order,
                number(&measured[format!("flap{order}")][row][column]),
            ));
        }
    }
    let above = &measured["at_750rpm_three_modes_after_flap3_lag_excluded_ascending"][row];
    points.extend((0..3).map(|i| (750.0, 4 + i, number(&above[i]))));
    points
}

#[test]
fn frequencies_meet_the_measurements() {
    let chain = Chain::analyzed();
    for sweep in SWEEPS {
        let (table, measured) = chain.frequencies(sweep);
        let compared: Vec<Comparison> = measured.compare(&table);
        let expected = reference(sweep);
        assert_eq!(compared.len(), expected.len());
        for ((rpm, order, frequency), comparison) in expected.into_iter().zip(compared) {
            let point = comparison.measured;
            // The case's file of measurements agrees with the reference.
            assert!((point.speed * 30.0 / std::f64::consts::PI - rpm).abs() < 1e-9);
            assert_eq!((point.order, point.frequency), (Some(order), frequency));
            let difference = (comparison.computed - frequency).abs();
            let absolute = if order <= 3 { 1.0 } else { 0.0 };
            println!(
                "sweep {sweep} {rpm} rpm {order}: {frequency} {:.2} {} {:+.1} %",
                comparison.computed,
                comparison.name,
                100.0 * (comparison.computed / frequency - 1.0)
            );
            let allowed = f64::max(0.1 * frequency, absolute);
            let case = format!("tip swept by {sweep} degrees, {rpm} rpm");
            record::value(
                "Epps and Chandra 1996, measured",
                &case,
                &format!("mode {order} [Hz]"),
                [comparison.computed, frequency],
                difference / frequency,
                allowed / frequency,
            );
            assert!(
                difference <= allowed,
                "sweep {sweep}, {rpm} rpm, mode {order}: measured {frequency} Hz, computed {} Hz",
                comparison.computed
            );
        }
    }
}

/// Convergence, which the measurements cannot show: doubling the elements changes no
/// compared value by more than 0.3 %, the sixth flap mode most, so the differences are
/// not due to the mesh.
#[test]
fn the_blade_mesh_is_fine_enough() {
    let chain = Chain::analyzed();
    let (coarse, measured) = chain.frequencies(45);
    let file = chain.case("sweep_45.dynamics.toml");
    let text = std::fs::read_to_string(&file).unwrap();
    let finer = text
        .replace("elements = 8", "elements = 16")
        .replace("elements = 3", "elements = 6");
    assert_ne!(text, finer);
    std::fs::write(&file, finer).unwrap();
    let (fine, _) = chain.frequencies(45);
    for (a, b) in measured
        .compare(&coarse)
        .iter()
        .zip(measured.compare(&fine))
    {
        let change = (a.computed / b.computed - 1.0).abs();
        assert!(change < 3e-3, "{}: {} {}", a.name, a.computed, b.computed);
    }
}

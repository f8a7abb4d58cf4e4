//! The bimetal strip, from the mesh of its two layers to the tip of a heated beam.
//!
//! Source: Timoshenko, *Analysis of bi-metal thermostats*, J. Opt. Soc. Am. 11 (1925)
//! 233-255, for the curvature; a free beam has it everywhere, and so the shape of an arc.

use std::path::{Path, PathBuf};

use beam_dynamics::analysis::statics::statics;
use nalgebra::Vector3;

use crate::record;
use crate::swept_tip::copy;

const SOURCE: &str = "Bimetal strip, arc of Timoshenko's curvature";
const CASE: &str = "cases/section/bimetal_strip";

/// Curvature [1/m] and strain of the bottom, by the balance of two plane layers:
/// see the README of the case.
const HOT: [f64; 2] = [-0.470_570_660_292_800_9, 0.001_901_404_242_605_320_8];

/// Length of the strip [m].
const LENGTH: f64 = 0.4;

struct Chain(tempfile::TempDir);

impl Chain {
    fn analyzed() -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let folder = tempfile::tempdir().unwrap();
        copy(&root.join(CASE), &folder.path().join(CASE));
        let chain = Self(folder);
        let section = chain.file("bimetal_strip.section.toml");
        let arguments = ["section-analyzer".into(), "analyze".into(), section.into()];
        let (mut out, mut err) = (Vec::new(), Vec::new());
        let code = section_analyzer::cli::run(arguments, &mut out, &mut err);
        assert_eq!(code, 0, "{}", String::from_utf8_lossy(&err));
        chain
    }

    fn file(&self, name: &str) -> PathBuf {
        self.0.path().join(CASE).join(name)
    }

    /// The tip of the strip clamped at x = 0, under the heat given by two lines of the
    /// card of its properties; or the messages on their errors.
    fn tip(&self, heat: &str) -> Result<Vector3<f64>, String> {
        let text = format!(
            "units = \"SI\"\n[properties.strip]\n\
             file = \"results/bimetal_strip.properties.json\"\n{heat}\n\
             [[blade]]\nname = \"strip\"\nproperties = \"strip\"\n\
             [[blade.piece]]\nlength = {LENGTH}\nelements = 8\n[static]\n"
        );
        let file = self.file("strip.dynamics.toml");
        std::fs::write(&file, text).unwrap();
        let input = beam_dynamics::input::read(&file).map_err(|problems| problems.to_string())?;
        let outcome = statics(&input.model, &input.statics.unwrap());
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        Ok(*outcome.result.last().unwrap().positions.last().unwrap())
    }
}

/// The tip of an arc: the bottom, x of the strip, is stretched and turns about y by the
/// curvature times its undeformed length.
fn arc(part: f64) -> Vector3<f64> {
    let [curvature, strain] = HOT.map(|value| part * value);
    let angle = curvature * LENGTH;
    (1.0 + strain) / curvature * Vector3::new(angle.sin(), 0.0, angle.cos() - 1.0)
}

/// By the temperature and by the named state, which is 100 K. The elements are of order
/// four: eight of an arc of 0.19 rad turn by 0.024 rad each, and 0.024^4 is 3e-7; their
/// error is a small part of it.
#[test]
fn heated_strips_curl_into_arcs() {
    const TOLERANCE: f64 = 2e-8;
    let chain = Chain::analyzed();
    let cold = Vector3::x() * LENGTH;
    for (heat, part) in [
        ("temperature = 100", 1.0),
        ("temperature = \"-90 degF\"", -0.5),
        ("imposed = { hot = 1 }", 1.0),
        ("temperature = 30\nimposed = { hot = \"= 0.2\" }", 0.5),
    ] {
        let (found, expected) = (chain.tip(heat).unwrap(), arc(part));
        let error = (found - expected).norm() / (expected - cold).norm();
        println!("{heat}: {found} {expected} {error:e}");
        let deflections = [found.z, expected.z];
        record::value(
            SOURCE,
            heat,
            "deflection [m]",
            deflections,
            error,
            TOLERANCE,
        );
        assert!(error < TOLERANCE, "{heat}: {error:e}");
    }
    assert!((chain.tip("").unwrap() - cold).norm() < 1e-14);
}

#[test]
fn states_that_the_section_does_not_have_are_reported() {
    let chain = Chain::analyzed();
    let reported = chain.tip("imposed = { hut = 1 }").unwrap_err();
    assert!(
        reported.contains(
            "strip.dynamics.toml:4: unknown imposed state \"hut\" in properties \"strip\"\n  \
             help: did you mean \"hot\"?"
        ),
        "{reported}"
    );
    let reported = chain.tip("temperature = \"3 m\"").unwrap_err();
    assert!(
        reported.contains("measures a length, expected a rise of temperature"),
        "{reported}"
    );
}

//! The Princeton beam, from the mesh of its rectangle to large deflections.
//!
//! Sources: `tests/reference/rotors/princeton_beam.json`, the constants of the strip;
//! `tests/reference/dynamics/exact_static_beams.json`, the tip for 21 loads by shooting on
//! the exact rod with these constants, residual below 1e-14.

use std::path::{Path, PathBuf};

use beam_dynamics::analysis::statics::statics;
use nalgebra::Vector3;
use serde_json::Value;

use crate::record;
use crate::swept_tip::copy;

const CONSTANTS: &str = "Princeton beam, constants of the strip";
const ROD: &str = "Princeton beam, shooting on the exact rod";
const CASE: &str = "cases/chain/princeton";

fn reference(file: &str) -> Value {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/reference");
    serde_json::from_str(&std::fs::read_to_string(folder.join(file)).unwrap()).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

/// The case with its section analyzed, in a separate folder.
struct Chain(tempfile::TempDir);

impl Chain {
    fn analyzed() -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let folder = tempfile::tempdir().unwrap();
        for part in [CASE, "meshes/princeton"] {
            copy(&root.join(part), &folder.path().join(part));
        }
        let chain = Self(folder);
        let section = chain.file("princeton.section.toml");
        let arguments = ["section-analyzer".into(), "analyze".into(), section.into()];
        let (mut out, mut err) = (Vec::new(), Vec::new());
        let code = section_analyzer::cli::run(arguments, &mut out, &mut err);
        assert_eq!(code, 0, "{}", String::from_utf8_lossy(&err));
        chain
    }

    fn file(&self, name: &str) -> PathBuf {
        self.0.path().join(CASE).join(name)
    }

    /// Diagonal of the stiffness in the property file \[N, N m^2\].
    fn stiffness(&self) -> [f64; 6] {
        let text = std::fs::read_to_string(self.file("results/princeton.properties.json")).unwrap();
        let file: Value = serde_json::from_str(&text).unwrap();
        std::array::from_fn(|i| number(&file["stiffness"][i][i]))
    }

    /// Displacement \[m\] and twist \[rad\] of the tip under a force \[N\].
    fn tip(&self, force: f64, degrees: f64) -> (Vector3<f64>, f64) {
        let text = std::fs::read_to_string(self.file("princeton.dynamics.toml")).unwrap();
        let (sin, cos) = degrees.to_radians().sin_cos();
        let old = "force = [0, 9.436339992, 9.436339992]";
        assert!(text.contains(old));
        let new = format!("force = [0, {:e}, {:e}]", force * cos, force * sin);
        let file = self.file("one.dynamics.toml");
        std::fs::write(&file, text.replace(old, &new)).unwrap();
        let input = beam_dynamics::input::read(&file).unwrap_or_else(|e| panic!("{e}"));
        let outcome = statics(&input.model, &input.statics.unwrap());
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        let result = outcome.result;
        let (first, last) = (result.nodes.last().unwrap(), result.last().unwrap());
        assert_eq!(last.factor, 1.0);
        let turn = last.rotations.last().unwrap();
        let displacement = last.positions.last().unwrap() - first.position;
        (displacement, turn[(2, 1)].atan2(turn[(1, 1)]))
    }
}

/// Bending and torsion within 0.5 % of the constants, which are Euler-Bernoulli's and de
/// Saint-Venant's series: the mesh is much more accurate.
#[test]
fn constants_of_the_strip_come_out_of_its_mesh() {
    let constants = reference("rotors/princeton_beam.json");
    let found = Chain::analyzed().stiffness();
    for (quantity, found, key, tolerance) in [
        ("EA [N]", found[0], "EA", 5e-3),
        ("EI, soft [N m^2]", found[4], "EI_soft", 5e-3),
        ("EI, stiff [N m^2]", found[5], "EI_stiff", 5e-3),
        ("GJ [N m^2]", found[3], "GJ", 5e-3),
    ] {
        let expected = number(&constants[key]);
        let error = (found / expected - 1.0).abs();
        record::value(
            CONSTANTS,
            "princeton",
            quantity,
            [found, expected],
            error,
            tolerance,
        );
        println!("{quantity} {found} {expected} {error:e}");
        assert!(error < tolerance, "{quantity}: {found} {expected}");
    }
}

/// The whole chain for the 21 loads. Displacements differ, relative to the largest of the
/// tip, by at most 1e-5 for the elements and the effect of the constants: a part for each
/// of EI and GJ as they differ, since displacements grow at most as their inverses, and
/// the deflections by shear, `P L (1/GA - 1/GA')`. The reference has `GA = 5/6 G A` in
/// both directions; for shear across the strip, the real one is smaller by a third.
#[test]
fn tip_of_the_whole_chain_for_21_loads() {
    let all = reference("dynamics/exact_static_beams.json");
    let (constants, results) = (&all["princeton"]["props"], &all["princeton"]["results"]);
    let chain = Chain::analyzed();
    let stiffness = chain.stiffness();
    let of = |key: &str| number(&constants[key]);
    let differs = |component: usize, key: &str| (stiffness[component] / of(key) - 1.0).abs();
    let explained = differs(3, "GJ") + differs(4, "EIw") + differs(5, "EIs");
    let flexibility =
        |component: usize, key: &str| (1.0 / stiffness[component] - 1.0 / of(key)).abs();
    let shear = of("L") * flexibility(1, "GA2").max(flexibility(2, "GA3"));
    assert_eq!(results.as_object().unwrap().len(), 21);
    let mut worst = 0.0_f64;
    for (p, force) in [4.448, 8.896, 13.345].into_iter().enumerate() {
        for degrees in (0..=90).step_by(15) {
            let name = format!("P{},theta={degrees}", p + 1);
            let exact = &results[name.as_str()];
            let expected = Vector3::from_fn(|i, _| number(&exact["u"][i]));
            let (found, twist) = chain.tip(force, f64::from(degrees));
            let size = expected.amax();
            let tolerance = 1e-5 + explained + shear * force / size;
            let error = (found - expected).amax() / size;
            let case = format!("princeton, {force} N");
            let largest = (found - expected).iamax();
            record::value(
                ROD,
                &case,
                "tip, 7 angles [m]",
                [found[largest], expected[largest]],
                error,
                tolerance,
            );
            println!("{name} {error:e} {tolerance:e} {found:?} {expected:?}");
            assert!(error < tolerance, "{name}: {found} {expected}");
            // Twist: relative to the largest of the 21, 0.06 rad.
            let exact_twist = number(&exact["twist_atan2_R32_R22"]);
            let error = (twist - exact_twist).abs() / 0.0608;
            record::value(
                ROD,
                &case,
                "twist, 7 angles [rad]",
                [twist, exact_twist],
                error,
                tolerance,
            );
            println!("   {twist} {exact_twist} {error:e}");
            assert!(error < tolerance, "{name}: {twist} {exact_twist}");
            worst = worst.max(error);
        }
    }
    assert!(worst < 1e-3);
}

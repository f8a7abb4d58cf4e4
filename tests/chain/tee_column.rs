//! A column of T-section: without the table of prestress the beam misses its buckling, by
//! bending and torsion together.
//!
//! # References
//! - Timoshenko, Gere, *Theory of Elastic Stability*, 2nd ed. 1961, section 5.5: a pinned
//!   column of a section with one axis of symmetry z, shear center z_s from the centroid,
//!   warping constant zero,
//!
//! ```text
//! (Pz - P)(Pf - P) r0^2 = P^2 z_s^2
//! Pz = pi^2 EIz / L^2 ,   Pf = GJ / r0^2 ,   r0^2 = (EIy + EIz)/EA + z_s^2
//! ```

use std::f64::consts::PI;
use std::fmt::Write as _;
use std::path::Path;

use beam_dynamics::analysis::buckling::buckling;
use beam_dynamics::result::BucklingResult;
use nalgebra::Vector2;
use shared_geom::section::{self, SectionProperties};

use crate::record;

const SOURCE: &str = "Column of T-section, Timoshenko and Gere";
const LENGTH: f64 = 1.5;
const ELEMENTS: usize = 8;
const SECTION: &str = "mesh = \"tee.msh\"\nprestress = \"biot\"\n[units]\nlength = \"mm\"\n\
    stress = \"GPa\"\n[material.al]\nyoung = 70\npoisson = 0.3\ndensity = \"2700 kg/m^3\"\n\
    [[lamina]]\ncurve = \"flange\"\nmaterial = \"al\"\nthickness = 2\n\
    [[lamina]]\ncurve = \"web\"\nmaterial = \"al\"\nthickness = 2\n";

/// Lines of a flange of 100 mm and of a web of 80 mm below its middle.
fn mesh() -> String {
    let flange = (0..=50).map(|i| [f64::from(i) * 2.0 - 50.0, 0.0]);
    let web = (1..=40).map(|i| [0.0, -2.0 * f64::from(i)]);
    let nodes: Vec<_> = flange.chain(web).collect();
    let of_web = (51..=90).map(|node| {
        if node == 51 {
            [26, 52]
        } else {
            [node, node + 1]
        }
    });
    let lines = (1..=50).map(|node| (1, [node, node + 1]));
    let lines: Vec<_> = lines.chain(of_web.map(|ends| (2, ends))).collect();
    let mut text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n1 1 \"flange\"\n\
        1 2 \"web\"\n$EndPhysicalNames\n"
        .to_owned();
    write!(text, "$Nodes\n{}\n", nodes.len()).unwrap();
    for (i, [y, z]) in nodes.iter().enumerate() {
        writeln!(text, "{} {y} {z} 0", i + 1).unwrap();
    }
    write!(text, "$EndNodes\n$Elements\n{}\n", lines.len()).unwrap();
    for (i, (group, [a, b])) in lines.iter().enumerate() {
        writeln!(text, "{} 1 2 {group} {group} {a} {b}", i + 1).unwrap();
    }
    text + "$EndElements\n"
}

/// The section about its tension center.
fn section_of(folder: &Path) -> SectionProperties {
    std::fs::write(folder.join("tee.msh"), mesh()).unwrap();
    let file = folder.join("tee.section.toml");
    std::fs::write(&file, SECTION).unwrap();
    let words = ["section-analyzer".into(), "analyze".into(), file.into()];
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let code = section_analyzer::cli::run(words, &mut out, &mut err);
    assert_eq!(code, 0, "{}", String::from_utf8_lossy(&err));
    let found = section::read(&folder.join("results/tee.properties.json")).unwrap();
    let by: Vector2<f64> = found.centers.tension;
    found.shift(by)
}

/// Critical loads of the pinned column \[N\].
fn column(folder: &Path, keys: &str) -> (BucklingResult, Vec<String>) {
    let mut text = format!("units = \"SI\"\n[properties.s]\nfile = \"s.json\"\n{keys}\n");
    let last = 2 * ELEMENTS;
    for i in 0..=last {
        let x = LENGTH * i as f64 / last as f64;
        write!(
            text,
            "[[node]]\nname = \"n{i}\"\nposition = [{x:e}, 0, 0]\n"
        )
        .unwrap();
    }
    for i in (0..last).step_by(2) {
        let nodes = format!("[\"n{i}\", \"n{}\", \"n{}\"]", i + 1, i + 2);
        write!(
            text,
            "[[beam]]\nname = \"b{i}\"\nnodes = {nodes}\nproperties = \"s\"\n"
        )
        .unwrap();
    }
    write!(
        text,
        "[[joint]]\nkind = \"total\"\nnodes = [\"n0\"]\nlocked = [\"x\", \"y\", \"z\", \"about x\"]\n\
         [[joint]]\nkind = \"total\"\nnodes = [\"n{last}\"]\nlocked = [\"y\", \"z\", \"about x\"]\n\
         [[load]]\nnode = \"n{last}\"\nforce = [-1, 0, 0]\n[buckling]\ncount = 2\n"
    )
    .unwrap();
    let file = folder.join("column.dynamics.toml");
    std::fs::write(&file, text).unwrap();
    let input = beam_dynamics::input::read(&file).unwrap_or_else(|problems| panic!("{problems}"));
    let outcome = buckling(&input.model, input.buckling.as_ref().unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    (outcome.result, input.remarks)
}

/// The closed form with stiffnesses, centroid and shear center of the section itself. It
/// is for thin walls, whose error of GJ is 2 nu (1 + nu) (t/b)^2 and the like, below
/// 1e-3, and neglects the shortening before buckling, 4e-4; eight elements add 1e-5.
#[test]
fn a_column_of_tee_section_gives_way_in_bending_and_torsion() {
    const TOLERANCE: f64 = 3e-3;
    let folder = tempfile::tempdir().unwrap();
    let section = section_of(folder.path());
    std::fs::write(folder.path().join("s.json"), section::write(&section)).unwrap();
    let compliance = section.stiffness.try_inverse().unwrap();
    let torsion = 1.0 / compliance[(3, 3)];
    let k = section.stiffness;
    let arm = section.centers.shear.y;
    let square =
        (1.0 / compliance[(4, 4)] + 1.0 / compliance[(5, 5)]) * compliance[(0, 0)] + arm * arm;
    let bending = PI * PI / compliance[(5, 5)] / LENGTH.powi(2);
    let twist = torsion / square;
    let a = 1.0 - arm * arm / square;
    let sum = bending + twist;
    let expected = (sum - (sum * sum - 4.0 * a * bending * twist).sqrt()) / (2.0 * a);
    assert!(k[(0, 4)].abs() < 1e-9 * (k[(0, 0)] * k[(4, 4)]).sqrt());

    let (with, remarks) = column(folder.path(), "prestress = true");
    assert_eq!(remarks, Vec::<String>::new());
    let found = with.modes[0].factor;
    let error = (found / expected - 1.0).abs();
    println!("{found} {expected} {error:e}");
    let quantity = "least critical load [N]";
    record::value(
        SOURCE,
        "pinned, 1.5 m",
        quantity,
        [found, expected],
        error,
        TOLERANCE,
    );
    assert!(error < TOLERANCE, "{found} {expected}");

    // without the table it is bending about y, at three times the load, and a remark
    // reports it
    let (without, remarks) = column(folder.path(), "");
    assert!(without.modes[0].factor > 3.0 * expected);
    assert!(
        remarks.join("\n").contains("torsional-flexural buckling"),
        "{remarks:?}"
    );
}

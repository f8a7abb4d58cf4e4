//! Spars around the nose that turn into a web.

use std::path::Path;

use section_analyzer::analysis::analyze;
use section_analyzer::input::layup::{self, Layup};
use section_analyzer::mesh::generate::layup::{Layer, LayupSection, Spar, SparWeb};
use section_analyzer::output::layup_file;

use crate::files::section;

/// A D-spar in a skin.
pub const TEXT: &str = "\
units = \"SI\"
[shape]
naca = \"0018\"
chord = 1
[[layer]]
name = \"skin\"
material = \"metal\"
thickness = 0.001
[[layer]]
name = \"spar\"
material = \"metal\"
thickness = 0.004
web = \"rear\"
[[layer]]
name = \"cap\"
material = \"metal\"
thickness = 0.002
from = \"rear.suction\"
to = { x = 0.2, side = \"suction\" }
[[layer]]
name = \"cap_below\"
material = \"metal\"
thickness = 0.002
from = { x = 0.2, side = \"pressure\" }
to = \"rear.pressure\"
[[layer]]
name = \"filler\"
material = \"metal\"
thickness = 0.002
from = { x = 0.2, side = \"suction\" }
to = { x = 0.2, side = \"pressure\" }
web = \"rear\"
[[web]]
name = \"rear\"
at = { x = 0.4 }
plies = []
[[fill]]
name = \"nose\"
material = \"metal\"
ahead_of = \"rear\"
eta = [0.5, 1]
[material.metal]
young = 70e9
poisson = 0.3
density = 1
";

fn parse(text: &str) -> Result<Layup, String> {
    layup::parse(text, Path::new("a.layup.toml")).map_err(|problems| problems.to_string())
}

/// Areas of all layers lie on the curved surfaces and along the web less the mitres, to 2e-4;
/// the mass is their sum.
#[test]
fn layers_of_a_spar_have_their_areas() {
    let layup = parse(TEXT).unwrap_or_else(|text| panic!("{text}"));
    let meshed = layup
        .mesh(0.0)
        .unwrap_or_else(|problems| panic!("{problems}"));
    for area in &meshed.areas {
        println!("{} {:e}", area.name, area.meshed / area.nominal - 1.0);
    }
    for area in &meshed.areas {
        let error = area.meshed / area.nominal - 1.0;
        assert!(error.abs() < 2e-4, "{}: {error:e}", area.name);
    }
    let found = analyze(&section(&layup, 0.0).section).expect("a solution");
    let sum: f64 = meshed.areas.iter().map(|area| area.meshed).sum();
    assert!((found.mass[(0, 0)] / sum - 1.0).abs() < 1e-9);
    // filled, with the same outer faces
    let filled = layup
        .mesh(1.0)
        .unwrap_or_else(|problems| panic!("{problems}"));
    let nose = filled.areas.last().expect("an area");
    assert!(nose.name == "nose" && nose.meshed > 0.02, "{nose:?}");
    let again = parse(&layup_file(&layup, "a")).unwrap_or_else(|text| panic!("{text}"));
    for eta in [0.0, 1.0] {
        let sections = [&layup, &again].map(|layup| layup.section(eta).expect("a section"));
        assert_eq!(sections[0], sections[1]);
    }
}

/// Words, others in their place, and the problem.
const WRONG: &[(&str, &str, &str)] = &[
    (
        "web = \"rear\"",
        "web = \"raer\"",
        "error: a.layup.toml:13: web \"raer\" is not in the file\n  help: did you mean \"rear\"?",
    ),
    (
        "plies = []",
        "plies = [{ name = \"b\", material = \"metal\", thickness = 0.003 }]",
        "error: a.layup.toml:13: web \"rear\" has plies of its own, and layers that continue along \
         it, expected one of them",
    ),
    (
        "web = \"rear\"\n[[web]]",
        "web = \"fore\"\n[[web]]\nname = \"fore\"\nat = { x = 0.2 }\nplies = []\n[[web]]",
        "error: a.layup.toml:32: layers continue along webs \"rear\" and \"fore\", expected one web \
         at each position along the span",
    ),
    (
        "thickness = 0.002\nfrom = \"rear.suction\"",
        "thickness = 0.001\nfrom = \"rear.suction\"",
        "error: a.layup.toml:33: eta 0: the layers along web \"rear\" are 0.004, 0.002 thick, those \
         inside of the spar at its suction end 0.004, 0.001, expected the same; lengths in m\n  help: a layer inside \
         of the spar that is not along the web needs one of its thickness along the web, which may be \
         elsewhere on the surfaces",
    ),
    (
        "from = \"rear.suction\"",
        "from = 0",
        "error: a.layup.toml:14: eta 0: layer \"cap\" is inside of the spar with web \"rear\", and \
         goes behind the web\n  help: list it before the layers of the spar, or end it at the web",
    ),
    (
        "from = { x = 0.2, side = \"pressure\" }\nto = \"rear.pressure\"",
        "from = \"rear.pressure\"\nto = 1",
        "error: a.layup.toml:20: eta 0: layer \"cap_below\" behind the spar with web \"rear\" reaches \
         the web\n  help: end it before the web, by half the length of its drop or more",
    ),
    (
        "at = { x = 0.4 }",
        "at = { x = 0.998 }",
        "eta 0: web \"rear\" stands at arc",
    ),
    (
        "at = { x = 0.4 }",
        "at = { x = 0.02 }",
        "error: a.layup.toml:14: layer \"cap\" at eta 0 starts at arc 0.47977444 (\"rear.suction\") and ends at",
    ),
];

#[test]
fn wrong_spars_are_named() {
    for (from, to, expected) in WRONG {
        assert!(TEXT.contains(from), "{from}");
        let made = parse(&TEXT.replacen(from, to, 1));
        let problem = made.and_then(|layup| {
            let meshed = layup.mesh(0.0).map_err(|problems| problems.to_string());
            meshed.map(|_| layup)
        });
        let problem = problem.expect_err(to);
        assert!(problem.contains(expected), "{to}: {problem}\n{expected}");
    }
}

/// Two spars along one span: each section has its own, also where the layers of both are there; where
/// both webs stand, the section names them.
#[test]
fn two_spars_follow_each_other_along_the_span() {
    let second = "[[layer]]\nname = \"outboard\"\nmaterial = \"metal\"\nthickness = 0.003\n\
                  web = \"fore\"\n[[web]]\nname = \"rear\"";
    let text = TEXT.replace("[[web]]\nname = \"rear\"", second);
    let both = |ranges: [&str; 2]| {
        let [rear, fore] = ranges;
        let webs = format!(
            "plies = []\neta = {rear}\n[[web]]\nname = \"fore\"\nat = {{ x = 0.2 }}\nplies = []\n\
             eta = {fore}"
        );
        text.replace("plies = []", &webs)
    };
    let layup = parse(&both(["[0, 0.4]", "[0.4, 1]"])).unwrap_or_else(|text| panic!("{text}"));
    let spar = |eta: f64| {
        let section = layup.section(eta).expect("a section");
        let web = section.spar.expect("a spar").webs.remove(0);
        let layers = web.layers.iter();
        let names = layers.map(|layer| section.layers[*layer].name.clone());
        (web.name, names.collect::<Vec<_>>())
    };
    let rear = (
        "rear".to_owned(),
        vec!["spar".to_owned(), "filler".to_owned()],
    );
    assert_eq!(spar(0.2), rear);
    assert_eq!(spar(0.8), ("fore".to_owned(), vec!["outboard".to_owned()]));
    let both_stand = layup.section(0.4).expect_err("two spars").to_string();
    let expected = "layers continue along webs \"rear\" and \"fore\"";
    assert!(both_stand.contains(expected), "{both_stand}");
    let overlap = parse(&both(["[0, 0.5]", "[0.4, 1]"])).expect_err("two spars");
    assert!(overlap.contains(expected), "{overlap}");
}

/// An ellipse with semi-axes of 0.5 and 0.2 and a box-spar inside of its skin, of one layer on each
/// side and along both webs: areas on the curved surfaces and along the webs, less the mitres, to 2e-5.
#[test]
fn a_box_spar_turns_into_both_webs() {
    let point = |i: usize| {
        let angle = std::f64::consts::TAU * i as f64 / 200.0;
        [-0.5 * angle.cos(), 0.2 * angle.sin()]
    };
    let layer = |name: &str, thickness: f64, [from, to]: [f64; 2]| Layer {
        name: name.into(),
        thickness,
        from,
        to,
        taper: None,
        profile: Vec::new(),
    };
    let (rear, fore) = ([0.15, 0.85], [0.35, 0.65]);
    let web = |name: &str, arcs: [f64; 2]| SparWeb {
        name: name.into(),
        arcs,
        layers: vec![1],
        feet: None,
    };
    let section = LayupSection {
        contour: (0..=200).map(point).collect(),
        layers: vec![
            layer("skin", 0.002, [0.0, 1.0]),
            layer("above", 0.006, [rear[0], fore[0]]),
            layer("below", 0.006, [fore[1], rear[1]]),
        ],
        webs: Vec::new(),
        spar: Some(Spar {
            first: 1,
            webs: vec![web("rear", rear), web("fore", fore)],
        }),
        fills: Vec::new(),
        size: Some(0.01),
    };
    let made = section
        .generate()
        .unwrap_or_else(|problem| panic!("{problem}"));
    for area in &made.areas {
        let error = area.meshed / area.nominal - 1.0;
        println!("{} {error:e}", area.name);
        assert!(error.abs() < 1e-3, "{}: {error:e}", area.name);
    }
    for name in [
        "above@suction",
        "above@rear",
        "above@fore",
        "below@pressure",
    ] {
        assert!(made.mesh.group(2, name).is_some(), "{name}");
    }
    assert!(made.mesh.group(2, "below@suction").is_none());
}

//! Layers and webs without effect: bond layers of webs that do not stand, drops without an end, webs
//! of nothing.

use std::path::Path;

use section_analyzer::input::layup::{self, Layup};
use section_analyzer::output::{layer_rows, layup_report};

const TEXT: &str = "\
units = \"SI\"
[shape]
chord = 2
origin = 0.25
naca = \"0018\"
[[layer]]
name = \"skin\"
material = \"glass\"
thickness = 0.002
[[layer]]
name = \"bond\"
material = \"glass\"
thickness = 0.003
from = \"web.suction.aft - 80 mm\"
to = \"bond_end\"
[place.bond_end]
at = \"web.suction.fore\"
shift = \"80 mm\"
[[web]]
name = \"web\"
at = { x = 0.3 }
eta = [0, 0.5]
plies = [{ name = \"ply\", material = \"glass\", thickness = { eta = [0, 0.3, 0.31, 0.4, 0.41, 0.5], value = [0.004, 0.004, 0, 0, 0.004, 0.004], course = \"linear\" } }]
[[fill]]
name = \"core\"
material = \"glass\"
ahead_of = { x = 0.1 }
[material.glass]
young = 40e9
poisson = 0.3
density = 1900
";

fn parse(text: &str) -> Result<Layup, String> {
    layup::parse(text, Path::new("a.layup.toml")).map_err(|problems| problems.to_string())
}

/// The bond layer of a web is where the web has plies.
#[test]
fn a_bond_layer_ends_with_its_web() {
    let layup = parse(TEXT).expect("a layup");
    for (eta, is_there) in [(0.2, true), (0.35, false), (0.45, true), (0.6, false)] {
        let section = layup
            .section(eta)
            .unwrap_or_else(|problems| panic!("{problems}"));
        let found = section.layers.iter().any(|layer| layer.name == "bond");
        assert_eq!(found, is_there, "{eta}");
    }
    // a layer from a web over the nose to its other foot is none of its bond layers
    let around = TEXT.replace("to = \"bond_end\"", "to = \"web.pressure.aft + 80 mm\"");
    let section = parse(&around).expect("a layup").section(0.6);
    assert_eq!(section.expect("a section").layers.len(), 2);
}

/// A fill has an area, and neither arcs nor a thickness.
#[test]
fn a_fill_has_no_thickness() {
    let layup = parse(TEXT).expect("a layup");
    let meshed = layup
        .mesh(0.6)
        .unwrap_or_else(|problems| panic!("{problems}"));
    let rows = layer_rows(&layup, &meshed);
    let core = rows.last().expect("the fill");
    assert_eq!(
        (core.layer.as_str(), core.arcs, core.thickness),
        ("core", None, None)
    );
    assert!(core.meshed > 0.0 && core.nominal == core.meshed);
    let report = layup_report(&layup, 0.6, &meshed);
    let line = report.lines().find(|line| line.contains("core"));
    let cells: Vec<&str> = line.expect("the fill").split_whitespace().collect();
    assert_eq!(cells[2..5], ["-"; 3], "{report}");
}

/// Drops and webs without effect are refused, with the remedy.
#[test]
fn drops_and_webs_without_effect_are_refused() {
    let web = "plies = [{";
    let start = TEXT.find(web).expect("plies");
    let end = start + TEXT[start..].find('\n').expect("a line");
    let without = format!("{}plies = []{}", &TEXT[..start], &TEXT[end..]);
    let idle = without
        .replace("from = \"web.suction.aft - 80 mm\"", "from = 0.2")
        .replace("at = \"web.suction.fore\"", "at = \"nose\"");
    let problem = parse(&idle).expect_err("a web of nothing");
    let expected = "a.layup.toml:19: web \"web\" has no plies, and no layer continues along it";
    assert!(problem.contains(expected), "{problem}");
    assert!(
        problem.contains("or web = \"web\" in the layers of a spar"),
        "{problem}"
    );
    // as a plane by which places are given it has a use
    parse(&without).expect("a layup");
    let spar = without.replace(
        "[[web]]",
        "[[layer]]\nname = \"spar\"\nmaterial = \"glass\"\nthickness = 0.002\nweb = \"web\"\n\
         taper = 0.05\n[[web]]",
    );
    let problem = parse(&spar).expect_err("a drop without an end");
    let expected = "a.layup.toml:24: layer \"spar\" continues along its web at both ends";
    assert!(
        problem.contains(expected) && problem.contains("remove \"taper\""),
        "{problem}"
    );
    parse(&spar.replace("taper = 0.05\n", "")).expect("a layup");
}

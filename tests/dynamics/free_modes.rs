//! Modes of models that nothing holds: rigid-body motions of frequency zero, and elastic modes of
//! free beams against their closed form.

use std::f64::consts::TAU;
use std::fmt::Write;

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::input;
use beam_dynamics::result::{FrequencyTable, ModeKind};

use crate::record;

const LENGTH: f64 = 2.0;
const MASS: f64 = 3.0;
const EI: f64 = 5.0;
/// EIz / EIy.
const RATIO: f64 = 4.0;
/// GA L^2 / EI, and m L^2 over the rotary inertia: higher ones leave no digits for bending.
const SLENDER: f64 = 1e7;

/// Nodes and elements of a beam along x from `from`, 2 m long.
fn beam(name: &str, from: f64, elements: usize) -> String {
    let mut text = String::new();
    let last = 2 * elements;
    for i in 0..=last {
        let x = from + LENGTH * i as f64 / last as f64;
        writeln!(
            text,
            "[[node]]\nname = \"{name}{i}\"\nposition = [{x:e}, 0, 0]"
        )
        .unwrap();
    }
    for i in (0..last).step_by(2) {
        let nodes = [i, i + 1, i + 2].map(|i| format!("{name}{i}"));
        writeln!(text, "[[beam]]\nnodes = {nodes:?}\nproperties = \"p\"").unwrap();
    }
    text
}

fn properties() -> String {
    let shear = SLENDER * EI / LENGTH.powi(2);
    let turning = MASS * LENGTH.powi(2) / SLENDER;
    format!(
        "units = \"SI\"\n[properties.p]\nea = {shear:e}\ngay = {shear:e}\ngaz = {shear:e}\n\
         gj = {:e}\neiy = {EI:e}\neiz = {:e}\nm = {MASS:e}\niy = {turning:e}\niz = {turning:e}\n",
        1e3 * EI,
        RATIO * EI
    )
}

fn table(text: &str) -> FrequencyTable {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.dynamics.toml");
    std::fs::write(&path, text).unwrap();
    let input = input::read(&path).unwrap_or_else(|problems| panic!("{problems}"));
    let outcome = modes(&input.model, &input.modes.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    outcome.table
}

/// Names and frequencies, ascending [rad/s].
fn named(table: &FrequencyTable) -> Vec<(String, f64)> {
    let found = table.at_speed(0).into_iter();
    let mut found: Vec<_> = found
        .map(|(branch, point)| (branch.name.clone(), TAU * point.frequency))
        .collect();
    found.sort_by(|a, b| a.1.total_cmp(&b.1));
    found
}

// Free bending: (beta L)^2 of cos(beta L) cosh(beta L) = 1. The elements are of fourth order; shear
// and rotary inertia lower the third frequency by less than 121 / SLENDER times three, and in the
// stiffer plane the shear by four times as much.
#[test]
fn a_free_beam_has_six_rigid_modes_and_the_closed_form() {
    const CLOSED: [f64; 3] = [22.373_285, 61.672_823, 120.903_392];
    let text = properties() + &beam("n", 0.0, 24) + "[modes]\nspeeds = 0\ncount = 5\nfree = true\n";
    let found = named(&table(&text));
    let names: Vec<_> = found.iter().map(|(name, _)| name.as_str()).collect();
    let rigid = (1..=6).map(|i| format!("rigid {i}"));
    let elastic = ["flap 1", "lag 1", "flap 2", "flap 3", "lag 2"];
    let expected: Vec<_> = rigid.chain(elastic.map(str::to_owned)).collect();
    assert_eq!(names, expected);
    let unit = (EI / (MASS * LENGTH.powi(4))).sqrt();
    let root = RATIO.sqrt();
    let closed = [
        CLOSED[0],
        root * CLOSED[0],
        CLOSED[1],
        CLOSED[2],
        root * CLOSED[1],
    ];
    let errors = found[6..]
        .iter()
        .zip(closed)
        .map(|((_, f), c)| (f / (c * unit) - 1.0).abs());
    let largest = errors.fold(0.0, f64::max);
    record::largest(
        "closed form of the free beam",
        "free beam of 24 elements",
        "error of five frequencies",
        largest,
        1e-4,
    );
    assert!(largest < 1e-4, "{largest:e}");
    assert!(found[..6].iter().all(|(_, frequency)| *frequency == 0.0));
}

// Gravity drives the free beam: no equilibrium, for which there are modes.
#[test]
fn loads_that_drive_a_free_motion_are_reported() {
    let modes_of = "[modes]\nspeeds = 0\nfree = true\n";
    let gravity = "gravity = { acceleration = [0, 0, -9.81] }\n";
    let text =
        properties().replacen('\n', &format!("\n{gravity}"), 1) + &beam("n", 0.0, 4) + modes_of;
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.dynamics.toml");
    std::fs::write(&path, text).unwrap();
    let input = input::read(&path).unwrap_or_else(|problems| panic!("{problems}"));
    let outcome = modes(&input.model, &input.modes.unwrap());
    let failure = outcome.failure.unwrap().to_string();
    assert!(
        failure.contains("drive a motion without stiffness"),
        "{failure}"
    );
}

// Two parts have twelve motions; a hinge between two parts leaves seven.
#[test]
fn parts_and_hinges_add_rigid_modes() {
    let two = properties() + &beam("a", 0.0, 4) + &beam("b", LENGTH, 4);
    let modes = "[modes]\nspeeds = 0\ncount = 2\nfree = true\n";
    let hinge = "[[hinge]]\nname = \"h\"\nnodes = [\"a8\", \"b0\"]\naxis = [0, 1, 0]\n";
    for (text, expected) in [
        (format!("{two}{modes}"), 12),
        (format!("{two}{hinge}{modes}"), 7),
    ] {
        let table = table(&text);
        let rigid = table
            .branches
            .iter()
            .filter(|branch| branch.kind == ModeKind::Rigid);
        assert_eq!(rigid.count(), expected);
        assert_eq!(table.branches.len(), expected + 2);
        let zero = named(&table)
            .iter()
            .filter(|(_, frequency)| *frequency == 0.0)
            .count();
        assert_eq!(zero, expected);
    }
}

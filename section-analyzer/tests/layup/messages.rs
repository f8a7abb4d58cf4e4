//! Messages about common faults, compared as a text: a change of any word of them is seen.

use std::path::Path;

use section_analyzer::input::layup::{self, Layup};

use crate::{prevabs, windio};

/// All messages, each under the name of its fault.
const MESSAGES: &str = include_str!("files/messages.txt");

/// The input that has a fault.
#[derive(Clone, Copy)]
enum Input {
    Layup,
    WindIo,
    PreVabs,
}
use Input::{Layup as Own, PreVabs, WindIo};

/// The name of a fault, the input, a text in it, the text in its place, and the position along the span of
/// a section that is meshed, if the file is read.
type Fault = (&'static str, Input, &'static str, &'static str, f64);

const FAULTS: [Fault; 42] = [
    (
        "unknown material",
        Own,
        "material = \"foam\"\nthickness = { eta = [0.15, 0.9]",
        "material = \"faom\"\nthickness = { eta = [0.15, 0.9]",
        0.5,
    ),
    (
        "unknown place",
        Own,
        "to = \"cap_suction.start\"",
        "to = \"cap_sucton.start\"",
        0.5,
    ),
    (
        "place of a layer that is no end of it",
        Own,
        "to = \"cap_suction.start\"",
        "to = \"cap_suction.begin\"",
        0.5,
    ),
    (
        "laminate as a text",
        Own,
        "thickness = \"0.5 mm\"",
        "plies = \"45/-45\"",
        0.5,
    ),
    (
        "thickness in another unit",
        Own,
        "thickness = \"0.5 mm\"",
        "thickness = 500",
        0.5,
    ),
    (
        "modulus in another unit",
        Own,
        "e1 = 28.2e9",
        "e1 = 28.2",
        0.5,
    ),
    (
        "comma that is missing",
        Own,
        "eta = [0.1, 0.3, 0.95], value = [0.005,",
        "eta = [0.1 0.3, 0.95], value = [0.005,",
        0.5,
    ),
    (
        "places in a circle",
        Own,
        "from = { eta = [0, 1], value = [0.29, 0.27], course = \"linear\" }",
        "from = \"panel_suction.end\"",
        0.5,
    ),
    (
        "name twice",
        Own,
        "name = \"shell_inner\"",
        "name = \"shell_outer\"",
        0.5,
    ),
    (
        "unknown key",
        Own,
        "taper = \"0.1 m\"",
        "tapper = \"0.1 m\"",
        0.5,
    ),
    ("no name", Own, "name = \"gelcoat\"\n", "", 0.5),
    ("no thickness", Own, "thickness = \"0.5 mm\"\n", "", 0.5),
    (
        "negative thickness",
        Own,
        "thickness = \"0.5 mm\"",
        "thickness = \"-0.5 mm\"",
        0.5,
    ),
    (
        "not a number",
        Own,
        "thickness = \"0.5 mm\"",
        "thickness = nan",
        0.5,
    ),
    (
        "wrong unit",
        Own,
        "thickness = \"0.5 mm\"",
        "thickness = \"0.5 kg\"",
        0.5,
    ),
    (
        "shorter list",
        Own,
        "value = [0.03, 0.02, 0.003, 0.0015]",
        "value = [0.03, 0.02, 0.003]",
        0.5,
    ),
    (
        "positions not ascending",
        Own,
        "eta = [0, 0.05, 0.15, 1]",
        "eta = [0, 0.15, 0.05, 1]",
        0.5,
    ),
    (
        "ends exchanged",
        Own,
        "from = 0.62\nto = { eta = [0, 1], value = [0.71, 0.73], course = \"linear\" }",
        "to = 0.62\nfrom = 0.71",
        0.5,
    ),
    (
        "count without a ply thickness",
        Own,
        "thickness = \"0.5 mm\"",
        "count = 3",
        0.5,
    ),
    (
        "plies that are none",
        Own,
        "thickness = \"0.5 mm\"",
        "plies = []",
        0.5,
    ),
    ("impossible material", Own, "nu12 = 0.5", "nu12 = 5", 0.5),
    ("no airfoil", Own, "naca = \"4418\"", "naca = \"44\"", 0.5),
    ("no units", Own, "units = \"SI\"\n", "", 0.5),
    (
        "places beyond the contour",
        Own,
        "shift = -0.05",
        "shift = -9",
        0.5,
    ),
    (
        "thicker than the section",
        Own,
        "value = [0.03, 0.02, 0.003, 0.0015]",
        "value = [0.03, 0.9, 0.9, 0.9]",
        0.3,
    ),
    (
        "a foot where both sides meet",
        Own,
        "suction = { at = \"cap_suction.start\", shift = 0.05 }",
        "suction = { arc = 0.001 }",
        0.6,
    ),
    (
        "windIO: unknown anchor",
        WindIo,
        "anchor: {name: cap,",
        "anchor: {name: cp,",
        0.5,
    ),
    (
        "windIO: arc beyond the contour",
        WindIo,
        "values: [0.6, 0.62]",
        "values: [0.6, 1.62]",
        0.5,
    ),
    (
        "windIO: missing table",
        WindIo,
        "components:",
        "component:",
        0.5,
    ),
    (
        "windIO: incompressible material",
        WindIo,
        "nu: 0.35",
        "nu: 0.5",
        0.5,
    ),
    (
        "windIO: thickness over span and arc",
        WindIo,
        "thickness: {grid: *ends, values: [0.006, 0.006]}",
        "thickness: {grid: [[0, 1], [0, 1]], values: [[0.006, 0.006], [0.004, 0.004]]}",
        0.5,
    ),
    (
        "angle of another unit",
        Own,
        "taper = \"0.1 m\"",
        "fiber_angle = 3000",
        0.5,
    ),
    (
        "twist of another unit",
        Own,
        "units = \"SI\"",
        "units = \"SI\"\nline = { length = 60, twist = { eta = [0, 1], value = [\"10 rad\", 0] } }",
        0.5,
    ),
    (
        "cells longer than the chord",
        Own,
        "units = \"SI\"",
        "units = \"SI\"\nmesh = { size = 10 }",
        0.5,
    ),
    (
        "cells that are too short",
        Own,
        "units = \"SI\"",
        "units = \"SI\"\nmesh = { size = 1e-7 }",
        0.5,
    ),
    (
        "stations not ascending",
        Own,
        "units = \"SI\"",
        "units = \"SI\"\nstations = [0.1, 0.5, 0.3]",
        0.5,
    ),
    (
        "a web with both places on one side",
        Own,
        "pressure = { at = \"cap_pressure.end\", shift = -0.05 }",
        "pressure = 0.4",
        0.5,
    ),
    (
        "windIO: chord of another sign",
        WindIo,
        "chord: {grid: *ends, values: [2, 2]}",
        "chord: {grid: *ends, values: [2, -2]}",
        0.5,
    ),
    (
        "windIO: place of the axis of another unit",
        WindIo,
        "section_offset_y: {grid: *ends, values: [1, 1]}",
        "section_offset_y: {grid: *ends, values: [1000, 1000]}",
        0.5,
    ),
    (
        "windIO: thickness in percent",
        WindIo,
        "      rthick: {grid: *ends, values: [1, 1]}",
        "      rthick: {grid: *ends, values: [100, 100]}",
        0.5,
    ),
    (
        "PreVABS: unknown line",
        PreVabs,
        ">around</baseline>",
        ">arund</baseline>",
        0.0,
    ),
    ("PreVABS: part of a ply", PreVabs, "-15:6", "-15:6.5", 0.0),
];

/// The messages of a fault.
fn messages((name, input, from, to, eta): &Fault) -> String {
    let changed = |text: &str| {
        assert!(text.contains(from), "{name}: {from}");
        text.replacen(from, to, 1)
    };
    let file =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/layup/files/wind_blade.layup.toml");
    let read: Result<Layup, String> = match input {
        Own => {
            let text = changed(&std::fs::read_to_string(file).expect("a file"));
            layup::parse(&text, Path::new("a.layup.toml")).map_err(|problems| problems.to_string())
        }
        WindIo => windio::read(&changed(&windio::tube().1)),
        PreVabs => prevabs::read(&changed(&prevabs::text("box.xml"))),
    };
    let meshed = read.and_then(|layup| {
        let meshed = layup.mesh(*eta);
        meshed.map(drop).map_err(|problems| problems.to_string())
    });
    let text = meshed.expect_err(name);
    // files in a folder of the test are named with it once they are read
    let start = text.find("error: ").map_or(0, |at| at + 7);
    let file = text[start..].split(':').next().unwrap_or_default();
    let folder = file.rfind('/').map_or("", |end| &file[..=end]);
    if folder.is_empty() {
        text
    } else {
        text.replace(folder, "")
    }
}

/// The file is written anew with the text that this test prints, after each message has been read as a
/// user would.
#[test]
fn messages_are_those_of_the_file() {
    let all = FAULTS
        .iter()
        .map(|fault| format!("# {}\n{}\n", fault.0, messages(fault).trim_end()));
    let all: Vec<String> = all.collect();
    let text = all.join("\n");
    let same = text
        .lines()
        .zip(MESSAGES.lines())
        .take_while(|(found, known)| found == known)
        .count();
    assert!(
        text == MESSAGES,
        "line {} differs:\n{:?}\nexpected\n{:?}\n=====\n{text}=====",
        same + 1,
        text.lines().nth(same),
        MESSAGES.lines().nth(same),
    );
}

/// Each message has its file and a remedy or the value that is expected.
#[test]
fn messages_have_a_place_and_a_remedy() {
    for part in MESSAGES.split("# ").skip(1) {
        let messages = part.split("error: ").skip(1);
        for message in messages {
            assert!(message.starts_with("a."), "{message}");
            let is_helpful = message.contains("  help: ") || message.contains("expected");
            assert!(is_helpful, "{message}");
        }
    }
}

/// Four places that do not exist, one of them of two layers: all are reported at once, each once, with
/// the line of the place and the first layer that has it.
#[test]
fn all_places_beyond_the_contour_are_reported_at_once() {
    let file =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/layup/files/wind_blade.layup.toml");
    let mut text = std::fs::read_to_string(file).expect("a file");
    for (from, to) in [
        ("to = 0.38", "to = \"far\""),
        ("from = 0.62", "from = { at = \"far\", shift = 0.1 }"),
        (
            "distance = \"0.3 m\", side = \"suction\"",
            "distance = \"90 m\", side = \"suction\"",
        ),
        (
            "suction = { at = \"cap_suction.start\", shift = 0.05 }",
            "suction = { x = 1.4, side = \"suction\" }",
        ),
        (
            "pressure = { at = \"cap_pressure.end\", shift = -0.05 }",
            "pressure = { plane = 70, side = \"pressure\" }",
        ),
        (
            "[[web]]\nname = \"front_web\"",
            "[place.far]\nx = -7\nside = \"suction\"\n\n[[web]]\nname = \"front_web\"",
        ),
    ] {
        assert!(text.contains(from), "{from}");
        text = text.replacen(from, to, 1);
    }
    let layup = layup::parse(&text, Path::new("a.layup.toml"));
    let layup = layup.unwrap_or_else(|problems| panic!("{problems}"));
    let problems = layup.mesh(0.5).expect_err("places").to_string();
    let errors: Vec<&str> = problems
        .lines()
        .filter(|line| line.starts_with("error"))
        .collect();
    let expected = [
        "error: a.layup.toml:60: \"x = -7\" of layer \"cap_suction\" is not on the contour at eta 0.5",
        "error: a.layup.toml:45: \"distance = 90 m\" of layer \"panel_suction\" is not on the contour at eta 0.5",
        "error: a.layup.toml:77: \"x = 1.4\" of web \"rear_web\" is not on the contour at eta 0.5",
        "error: a.layup.toml:78: \"plane = 70\" of web \"rear_web\" is not on the contour at eta 0.5",
    ];
    assert_eq!(errors, expected, "{problems}");
}

//! Tests of drives in inputs: their values, and the problems reported for wrong ones.

use std::fs;

use approx::assert_relative_eq;
use shared_geom::document::Document;
use shared_geom::units::Dimension;

use super::{read_named, read_value};
use crate::model::Drive;

/// Reads the drive under `drive` of a file with the given text, with a table `a.csv` in its
/// folder.
fn found(text: &str, dimension: Dimension) -> Result<Drive, String> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.toml");
    fs::write(
        folder.path().join("a.csv"),
        "# measured\ntime, thrust, torque\n0, 1, 5\n1, 3, 6\n\n2, 2, x\n",
    )
    .unwrap();
    fs::write(&path, text).unwrap();
    let prefix = format!("{}/", folder.path().display());
    let document = Document::read(&path).map_err(|problems| problems.to_string())?;
    let root = document.root();
    document.declare_units(&root);
    document.declare_parameters(&root);
    let catalog = read_named(&root, &[]);
    let item = root.item("drive");
    let drive = item.and_then(|item| read_value(&item, dimension, &catalog));
    catalog.check(&document, [0.0, 5.0]);
    root.finish();
    let drive = document.finish(drive);
    drive.map_err(|problems| problems.to_string().replace(&prefix, ""))
}

fn value(text: &str, dimension: Dimension, time: f64) -> f64 {
    found(text, dimension).unwrap().at(time).value
}

const IMPERIAL: &str = "[units]\nlength = \"in\"\nforce = \"lbf\"\n";
const INCH: f64 = 0.0254;

#[test]
fn numbers_count_in_the_unit_of_their_key() {
    let length = |drive: &str, more: &str| {
        let text =
            format!("drive = {drive}\n{more}\n{IMPERIAL}[parameters]\na = 2\nb = \"1 ft\"\n");
        value(&text, Dimension::LENGTH, 3.0)
    };
    let near =
        |found: f64, inches: f64| assert_relative_eq!(found, inches * INCH, max_relative = 1e-14);
    near(length("4", ""), 4.0);
    assert_relative_eq!(length("\"4 mm\"", ""), 4e-3, max_relative = 1e-14);
    near(length("\"= a*t + b\"", ""), 18.0);
    near(length("\"= a*b\"", ""), 24.0);
    near(
        length("{ kind = \"ramp\", to = 8, start = 1, duration = 4 }", ""),
        4.0,
    );
    near(
        length("{ kind = \"step\", from = 1, to = \"= a\", time = 3 }", ""),
        2.0,
    );
    near(
        length("{ kind = \"table\", rows = [[0, 1], [5, 6]] }", ""),
        4.0,
    );
    near(
        length(
            "{ kind = \"product\", factors = [\"2 in\", \"= t\", 5] }",
            "",
        ),
        30.0,
    );
    near(
        length(
            "{ kind = \"sum\", terms = [\"= t\", { kind = \"constant\", value = \"1 ft\" }] }",
            "",
        ),
        15.0,
    );
}

#[test]
fn drives_with_names_count_in_the_unit_of_each_key_or_in_their_own() {
    let named = |drive: &str| {
        let text = format!(
            "drive = \"swing\"\n{IMPERIAL}[drives.half]\nkind = \"constant\"\nvalue = 0.5\n[drives.swing]\n{drive}\n"
        );
        found(&text, Dimension::LENGTH)
    };
    // A quarter cycle from the phase of 90 degrees: -2 + 5.
    let harmonic =
        "kind = \"harmonic\"\nmean = 5\namplitude = 2\nfrequency = 0.25\nphase = 90\nstart = 1";
    assert_relative_eq!(
        named(harmonic).unwrap().at(3.0).value,
        3.0 * INCH,
        max_relative = 1e-14
    );
    let metric = format!("{harmonic}\nunit = \"mm\"");
    assert_relative_eq!(
        named(&metric).unwrap().at(3.0).value,
        3e-3,
        max_relative = 1e-14
    );
    let product = "kind = \"product\"\nfactors = [8, \"half\"]";
    assert_relative_eq!(
        named(product).unwrap().at(0.0).value,
        4.0 * INCH,
        max_relative = 1e-14
    );
    let force = named(&format!("{harmonic}\nunit = \"kN\"")).unwrap_err();
    assert!(
        force.contains("a.toml:1: \"swing\" measures a force, expected a length"),
        "{force}"
    );
}

#[test]
fn tables_are_columns_of_a_file() {
    let table = |more: &str| {
        let text = format!(
            "units = \"SI\"\ndrive = {{ kind = \"table\", file = \"a.csv\", outside = \"hold\"{more} }}\n"
        );
        found(&text, Dimension::FORCE)
    };
    let thrust = table("").unwrap();
    assert_eq!(
        [0.5, 1.5, 9.0].map(|time| thrust.at(time).value),
        [2.0, 2.5, 2.0]
    );
    assert_eq!(thrust.next_corner(0.2), 1.0);
    let torque = table(", columns = [\"time\", \"torque\"]").unwrap_err();
    assert_eq!(
        torque,
        "error: a.csv:6: \"x\" in column \"torque\" is not a number"
    );
    let column = table(", columns = [\"time\", \"trust\"]").unwrap_err();
    assert_eq!(
        column,
        "error: a.csv:2: no column \"trust\"\n  help: did you mean \"thrust\"?"
    );
}

#[test]
fn a_run_that_leaves_a_table_is_reported_before() {
    let shown = found(
        "units = \"SI\"\ndrive = { kind = \"table\", rows = [[0, 1], [2, 3]] }\n",
        Dimension::FORCE,
    );
    assert_eq!(
        shown.unwrap_err(),
        "error: a.toml:2: \"drive\" has values from 0 s to 2 s, and the run goes from 0 s to 5 s\n  \
         help: give more values, or outside = \"hold\" to continue with the first and the last"
    );
}

#[test]
fn a_parameter_is_read_by_an_expression() {
    let text = "units = \"SI\"\ndrive = \"push\"\n[parameters]\npush = 3\n";
    assert_eq!(
        found(text, Dimension::FORCE).unwrap_err(),
        "error: a.toml:2: \"push\" under \"drive\" is a parameter, expected an expression, or the name of a \
         drive\n  help: write \"= push\""
    );
}

#[test]
fn what_is_wrong_is_reported_with_its_line_and_the_nearest_name() {
    let text = "units = \"SI\"
drive = \"swin\"
[drives.swing]
kind = \"harmonik\"
[drives.a]
kind = \"sum\"
terms = [1, \"b\"]
[drives.b]
kind = \"product\"
factors = [\"a\", \"= sinn(t)\"]
[drives.c]
kind = \"ramp\"
to = 1
start = 2
end = 1
ends = 3
[drives.d]
kind = \"table\"
rows = [[0, 1], [1, 2], [1, 3]]
[drives.e]
kind = \"random\"
deviation = 1
seed = 1
[drives.f]
kind = \"expression\"
expression = \"2*(t + lenght\"
[parameters]
length = 3
p = \"= q + 1\"
q = \"= p\"
";
    let shown = found(text, Dimension::FORCE).unwrap_err();
    for expected in [
        "a.toml:2: unknown drive \"swin\" in \"drive\"\n  help: did you mean \"swing\"?",
        "a.toml:4: \"kind\" is \"harmonik\"",
        "did you mean \"harmonic\"?",
        "a.toml:8: the drive \"a\" uses itself: a -> b -> a",
        "unknown function \"sinn\" at letter 2 of \"sinn(t)\"\n  help: did you mean \"sin\"?",
        "a.toml:11: the drive ends at 1 s, expected a time after its start at 2 s",
        "a.toml:16: unknown key \"ends\" in drives \"c\"",
        "a.toml:19: the time 1 is not after 1",
        "a.toml:20: drives \"e\" has none of \"band\" and \"interval\", expected one",
        "a.toml:26: \"expression\": unknown name \"lenght\" at letter 8 of \"2*(t + lenght\"\n  \
         help: did you mean \"length\"?",
        "a.toml:29: the parameter \"p\" depends on itself: p -> q -> p",
    ] {
        assert!(shown.contains(expected), "{expected}\nis not in\n{shown}");
    }
}

#[test]
fn of_a_wrong_drive_no_known_key_is_unknown() {
    let reported = |drive: &str| {
        let text = format!("[drive]\n{drive}");
        found(&text, Dimension::LENGTH).unwrap_err()
    };
    for (drive, expected) in [
        (
            "kind = \"random\"\ndeviation = -1\nseed = 1\nband = [1, 2]\nterms = 8",
            "zero or more",
        ),
        (
            "kind = \"random\"\ndeviation = 1\nseed = 1\nband = [1, 2]\ninterval = 1\nterms = 8",
            "\"interval\"",
        ),
        (
            "kind = \"table\"\nfile = \"a.csv\"\nrows = [[0, 1]]\ncolumns = [\"a\", \"b\"]",
            "\"rows\"",
        ),
        ("kind = \"rmp\"\nto = 1\nduration = 2", "\"rmp\""),
        ("to = 1\nduration = 2", "no \"kind\""),
    ] {
        let text = reported(drive);
        assert!(text.contains(expected), "{text}");
        assert!(!text.contains("unknown key"), "{text}");
    }
    // Unknown keys of the kind are still reported, together with the other problems.
    let text = reported("kind = \"random\"\ndeviation = -1\nseed = 1\nbnd = [1, 2]");
    assert!(text.contains("unknown key \"bnd\""), "{text}");
}

//! Three files in the words of the design of layups, a wind blade, a helicopter section and a propeller:
//! they have the sections of the same layups in the other words of layup files.

use std::path::Path;

use section_analyzer::input::layup::{self, Layup};
use section_analyzer::mesh::generate::layup::LayupSection;
use section_analyzer::output::layup_file;

fn text(name: &str) -> String {
    std::fs::read_to_string(path(name)).expect("a file of the tests")
}

fn path(name: &str) -> std::path::PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/layup/files");
    // webs without plies of their own do not fit the schema, with which files of this ending are compared
    let ending = if name == "helicopter" {
        "txt"
    } else {
        "layup.toml"
    };
    folder.join(format!("words_{name}.{ending}"))
}

fn parse(name: &str, text: &str) -> Layup {
    let read = layup::parse(text, &path(name));
    read.unwrap_or_else(|problems| panic!("{problems}"))
}

fn section(layup: &Layup, eta: f64) -> LayupSection {
    let section = layup.section(eta);
    section.unwrap_or_else(|problems| panic!("{problems}"))
}

/// Both layups have equal sections, which mesh.
fn are_equal(one: &Layup, other: &Layup, etas: &[f64]) {
    for &eta in etas {
        let found = section(one, eta);
        assert_eq!(found, section(other, eta), "{eta}");
        one.mesh(eta)
            .unwrap_or_else(|problems| panic!("{problems}"));
    }
}

/// Replaces each text by another; both must be different, and the first must be there.
fn replaced(text: &str, pairs: &[(&str, &str)]) -> String {
    let mut text = text.to_owned();
    for (from, to) in pairs {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    text
}

/// The layers of the feet of the web of the wind blade.
fn feet() -> [String; 4] {
    let layer = |kind: &str, side: &str, rest: &str, places: [&str; 2]| {
        let [from, to] = places;
        format!(
            "[[layer]]\nname = \"front_web_{kind}_{side}\"\n{rest}\nfrom = \"front_web.{from}\"\nto = \
             \"front_web.{to}\"\n"
        )
    };
    let bond = "material = \"glue\"\nthickness = \"5 mm\"";
    let flange = "material = \"biax\"\nthickness = \"2 mm\"";
    let suction = ["suction.aft - 80 mm", "suction.fore"];
    let pressure = ["pressure.fore", "pressure.aft + 80 mm"];
    [
        layer("bond", "suction", bond, suction),
        layer("flange", "suction", flange, suction),
        layer("bond", "pressure", bond, pressure),
        layer("flange", "pressure", flange, pressure),
    ]
}

/// The width of a cap, a distance from the trailing edge, the sides of the places of a web, the feet of
/// the web as layers, the adhesive as a fill. Above 0.9 the plane of the cap is ahead of the nose.
#[test]
fn a_wind_blade_in_other_words() {
    let words = text("wind_blade");
    let own = parse("wind_blade", &words);
    assert_eq!(own.name.as_deref(), Some("demo61"));
    let foot = "foot = { width = \"80 mm\", plies = \"outer\", bond = { material = \"glue\", thickness = \
                \"5 mm\" }, side = \"aft\" }\n";
    let edge = "[trailing_edge]\nclose = \"auto\"                        # \"wall\", \"face\", \"bond\" (needs \
                material), \"open\"\nbond = { material = \"glue\", to = { distance = \"0.1 m\", from = \
                \"trailing_edge\" } }\n";
    let fill = "[[fill]]\nname = \"trailing_edge_bond\"\nmaterial = \"glue\"\naft_of = { distance = \"0.1 m\" \
                }\n";
    let feet = feet();
    let other = replaced(
        &words,
        &[
            ("width = \"0.8 m\"", "to = \"cap_front + 0.8 m\""),
            ("0.3 m\", from = \"trailing_edge\"", "0.3 m\""),
            (
                "suction = { plane = \"-0.35 m\" }",
                "suction = { plane = \"-0.35 m\", side = \"suction\" }",
            ),
            (
                "pressure = { plane = \"-0.35 m\" }",
                "pressure = { plane = \"-0.35 m\", side = \"pressure\" }",
            ),
            (foot, ""),
            ("\n[[web]]", &format!("\n{}\n[[web]]", feet.concat())),
            (edge, fill),
        ],
    );
    are_equal(
        &own,
        &parse("wind_blade", &other),
        &[0.0, 0.06, 0.3, 0.62, 0.85],
    );
}

/// No adhesive in the thick root; with feet on both sides of a web a flange of each skin, which abut at
/// its middle.
#[test]
fn adhesive_and_feet_are_where_they_fit() {
    let words = text("wind_blade");
    let own = parse("wind_blade", &words);
    let has_bond = |eta: f64| {
        let meshed = own
            .mesh(eta)
            .unwrap_or_else(|problems| panic!("{problems}"));
        meshed
            .areas
            .iter()
            .any(|area| area.name == "trailing_edge_bond")
    };
    assert!(!has_bond(0.0) && has_bond(0.3));
    let both = replaced(&words, &[("side = \"aft\" }", "side = \"both\" }")]);
    let layers = section(&parse("wind_blade", &both), 0.3).layers;
    let ends = |name: &str| {
        let layer = layers.iter().find(|one| one.name == name).expect(name);
        [layer.from, layer.to]
    };
    let [aft, fore] = ["aft", "fore"].map(|way| ends(&format!("front_web_{way}_flange_suction")));
    let whole = ends("front_web_bond_suction");
    assert!(
        aft[1] == fore[0] && [aft[0], fore[1]] == whole,
        "{aft:?} {fore:?} {whole:?}"
    );
}

/// The line of the wind blade goes through its tables: prebend at 30 m of a table in lengths, twist by
/// monotone cubics, of which the value at 0.2 is given. 61.5 m and the slope of the prebend, 0.06, have
/// a line that is 0.1 % longer.
#[test]
fn lines_by_tables() {
    let line = parse("wind_blade", &text("wind_blade"))
        .line
        .expect("a line");
    let at = |x: f64| {
        let points = line.points.iter();
        let near = points.min_by(|a, b| {
            let off = |point: &&shared_geom::line::LinePoint| (point.position[0] - x).abs();
            off(a).total_cmp(&off(b))
        });
        near.expect("a point")
    };
    let (middle, tip) = (at(30.0), at(61.5));
    assert!((middle.position[0] - 30.0).abs() < 1e-9 && (middle.position[2] - 0.5).abs() < 1e-12);
    assert_eq!(
        [tip.position[0], tip.position[2], tip.twist],
        [61.5, 2.5, 0.0]
    );
    let fifth = at(12.3);
    assert!((fifth.position[0] - 12.3).abs() < 1e-9);
    assert!((fifth.twist.to_degrees() - 11.0).abs() < 1e-12);
    assert!(
        line.length() > 61.5 && line.length() < 61.6,
        "{}",
        line.length()
    );
    let straight = parse("propeller", &text("propeller")).line.expect("a line");
    assert!((straight.length() - 0.19).abs() < 1e-12);
    assert!((straight.points[0].twist.to_degrees() - 24.0).abs() < 1e-12);
    let wrong = text("propeller").replace("length = 190", "span = [0, 190]\nlength = 190");
    let problems = layup::parse(&wrong, &path("propeller"))
        .unwrap_err()
        .to_string();
    let expected = "expected the ascending positions of root and tip, without \"length\"";
    assert!(problems.contains(expected), "{problems}");
}

#[test]
fn a_helicopter_section_and_a_propeller_in_other_words() {
    let words = text("helicopter");
    let own = parse("helicopter", &words);
    let other = replaced(
        &words,
        &[(
            "around = \"nose\"                       # between the web's two feet, over the nose\n",
            "",
        )],
    );
    are_equal(&own, &parse("helicopter", &other), &[0.0]);
    let propeller = parse("propeller", &text("propeller"));
    for eta in [0.1, 0.4, 0.75] {
        propeller
            .mesh(eta)
            .unwrap_or_else(|problems| panic!("{problems}"));
    }
}

/// Files that the program writes of them have the same sections, which shows that nothing of them is
/// left out; fingerprints are equal if the texts of the constants are, without comments and blank lines.
#[test]
fn written_files_have_the_same_sections() {
    for (name, etas) in [
        ("wind_blade", &[0.06, 0.3, 0.85][..]),
        ("helicopter", &[0.0]),
    ] {
        let own = parse(name, &text(name));
        let written = layup_file(&own, "words");
        let again = layup::parse(&written, Path::new("again.layup.toml"));
        let again = again.unwrap_or_else(|problems| panic!("{problems}\n{written}"));
        assert_eq!((&own.name, &own.constants), (&again.name, &again.constants));
        for &eta in etas {
            assert_eq!(section(&own, eta), section(&again, eta), "{name} {eta}");
        }
    }
}

/// Words that contradict each other, and words of the design that the format does not have.
#[test]
fn wrong_words_have_a_remedy() {
    for (name, from, to, expected) in [
        (
            "wind_blade",
            "width = \"0.8 m\"",
            "width = \"0.8 m\"\nto = \"nose\"",
            "layer \"cap_suction\" has a \"width\", expected one of \"from\" and \"to\" beside it",
        ),
        (
            "helicopter",
            "web = \"rear\"",
            "",
            "layer \"spar\" goes around the nose, expected the \"web\" along which it continues",
        ),
        (
            "helicopter",
            "origin = 0.25",
            "origin = 0.25\ntrailing_edge = \"tab\"",
            "a tab behind a flat base such a web as thick as the tab is long",
        ),
        (
            "wind_blade",
            "close = \"auto\"",
            "close = \"wall\"",
            "expected one of \"auto\", \"bond\"",
        ),
        (
            "wind_blade",
            "plies = \"outer\", bond = { material = \"glue\", thickness = \"5 mm\" }, ",
            "",
            "the foot of web \"front_web\" has neither \"plies\" nor \"bond\", expected one of them or both",
        ),
        (
            "wind_blade",
            "naca = \"4418\"",
            "naca = \"64618\"",
            "file = \"airfoil.dat\"",
        ),
    ] {
        let text = replaced(&text(name), &[(from, to)]);
        let problems = layup::parse(&text, &path(name)).unwrap_err().to_string();
        assert!(problems.contains(expected), "{expected}\n{problems}");
    }
}

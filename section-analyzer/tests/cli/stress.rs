//! Load cases, strengths, and the files of a recovery.

use crate::workplace::{SECTION, Workplace};

const FILES: [&str; 11] = [
    "stress.txt",
    "stress.csv",
    "stress_cells.csv",
    "stress_nodes.csv",
    "stress.vtu",
    "stress_xx.png",
    "stress_xx.svg",
    "shear.png",
    "shear.svg",
    "von_mises.png",
    "von_mises.svg",
];

/// A section of 2 x 1 mm under loads of the file; line numbers start at 21.
fn with(more: &str) -> Workplace {
    let workplace = Workplace::with(&[], &[]);
    workplace.write("a.section.toml", &format!("{SECTION}{more}"));
    workplace
}

/// Column of a table by its name.
fn column(table: &str, name: &str) -> Vec<String> {
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    let at = reader.headers().unwrap().iter().position(|h| h == name);
    let at = at.unwrap_or_else(|| panic!("no column {name}"));
    let rows = reader.records().map(|row| row.unwrap()[at].to_owned());
    rows.collect()
}

fn numbers(table: &str, name: &str) -> Vec<f64> {
    let texts = column(table, name);
    texts.iter().map(|text| text.parse().unwrap()).collect()
}

#[test]
fn analyze_recovers_every_load_of_the_file() {
    let workplace =
        with("[load.pull]\naxial = \"400 N\"\npoint = [1, 0.5]\n[load.turn]\ntorsion = 1\n");
    let run = workplace.run(&["analyze", "a.section.toml"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    for load in ["pull", "turn"] {
        for file in FILES {
            let path = format!("results/a.{load}.{file}");
            assert!(
                workplace.path(&path).exists() && run.out.contains(&path),
                "{path}"
            );
        }
    }
    // 400 N in the middle of 2 mm^2: 200 MPa at all of the 2 x 4 points; the table has
    // nine digits
    let table = workplace.read("results/a.pull.stress.csv");
    let stresses = numbers(&table, "stress_xx [Pa]");
    assert_eq!(stresses.len(), 8);
    assert!(
        stresses.iter().all(|s| (s / 200e6 - 1.0).abs() < 1e-8),
        "{stresses:?}"
    );
    assert_eq!(column(&table, "region")[0], "skin");
    assert_eq!(column(&table, "cell")[7], "12");
}

/// A load other than the load of the file, with units, at another point: 1 kN at the
/// corner (2, 1) mm bends by 1 N m about y and by -2 N m about z.
#[test]
fn command_line_gives_a_load() {
    let workplace = with("[load.pull]\naxial = 400\n");
    let point = ["--point", "2 mm", "1e-3", "--name", "corner", "--out", "r"];
    let arguments = ["stress", "a.section.toml", "--axial", "1 kN"];
    let signed = [&arguments[..], &["--torsion", "-2 N m", "--shear-y", "-3"]].concat();
    let signed = workplace.run(&[&signed[..], &["--name", "signed", "--out", "r"]].concat());
    assert_eq!((signed.code, signed.err.as_str()), (0, ""));
    let report = squeezed(&workplace.read("r/a.signed.stress.txt"));
    assert!(report.contains("torsion -2.00000e0"), "{report}");
    assert!(report.contains("shear y -3.00000e0"), "{report}");
    let run = workplace.run(&[&arguments[..], &point].concat());
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(!workplace.path("r/a.pull.stress.csv").exists());
    let report = workplace.read("r/a.corner.stress.txt");
    assert!(run.out.starts_with(&report), "{}", run.out);
    for line in ["bending y  1.00000e0", "bending z  -2.00000e0"] {
        assert!(squeezed(&report).contains(&squeezed(line)), "{report}");
    }
    assert!(report.contains("none: no material has strengths"));
    let run = workplace.run(&["stress", "a.section.toml"]);
    assert_eq!(run.code, 0);
    assert!(workplace.path("results/a.pull.stress.csv").exists());
}

/// Negative values with units are values, not options.
#[test]
fn command_line_takes_negative_loads_with_units() {
    let workplace = with("");
    let run = workplace.run(&[
        "stress",
        "a.section.toml",
        "--axial",
        "-1 kN",
        "--bending-z",
        "-2e3 N mm",
        "--point",
        "-2 mm",
        "-1e-3",
    ]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let report = squeezed(&run.out);
    for line in [
        "axial -1.00000e3",
        "bending y 1.00000e0",
        "bending z -4.00000e0",
    ] {
        assert!(report.contains(line), "{}", run.out);
    }
}

/// Isotropic materials have no material axes: no rows of stresses in them. Tension causes
/// no bending: the curvatures are round-off, and shown as zero.
#[test]
fn report_leaves_out_what_means_nothing() {
    let workplace = with("[load.pull]\naxial = 400\npoint = [1, 0.5]\n");
    let run = workplace.run(&["stress", "a.section.toml"]);
    let rows: Vec<_> = run.out.lines().map(squeezed).collect();
    let is_shown = |name: &str| rows.iter().any(|row| row.starts_with(name));
    assert!(is_shown("xx ") && is_shown("xy 0") && is_shown("von Mises "));
    assert!(
        !is_shown("11 ") && !is_shown("12 0") && !is_shown("12 -"),
        "{}",
        run.out
    );
    for component in ["shear y", "shear z", "torsion"] {
        assert!(rows.contains(&format!("{component} 0 0 0")), "{}", run.out);
    }
}

fn squeezed(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// 200 MPa against a yield stress of 250 MPa: index 0.8, reserve factor 1.25.
#[test]
fn strengths_give_failure_indices() {
    let workplace = with(
        "[load.pull]\naxial = \"400 N\"\npoint = [1, 0.5]\n\
         [material.steel.strength]\nyield = 0.25\n\
         [material.steel.strain_limit]\ntension = 0.002\ncompression = 0.002\nshear = 0.002\n",
    );
    assert_eq!(workplace.run(&["analyze", "a.section.toml"]).code, 0);
    let table = workplace.read("results/a.pull.stress.csv");
    for (name, value) in [
        ("von_mises_index [-]", 0.8),
        ("von_mises_reserve_factor [-]", 1.25),
        // 200 MPa / 210 GPa, and 1.3 of it in shear
        ("max_strain_index [-]", 1.3 * 200.0 / 210e3 / 0.002),
    ] {
        let found = numbers(&table, name);
        assert!(
            found.iter().all(|v| (v / value - 1.0).abs() < 1e-8),
            "{name} {found:?}"
        );
    }
    assert!(workplace.path("results/a.pull.failure.png").exists());
    let fields = workplace.read("results/a.pull.stress.vtu");
    assert!(fields.contains("failure_von_mises") && fields.contains("failure_max_strain"));
    let report = squeezed(&workplace.read("results/a.pull.stress.txt"));
    assert!(
        report.contains("skin von Mises 8.00000e-1 1.25000e0 yielding"),
        "{report}"
    );
    assert!(
        report.contains("smallest reserve factor: 1.25000e0"),
        "{report}"
    );
}

#[test]
fn wrong_loads_are_reported() {
    let workplace = with(
        "[load.none]\naxial = 0\n[load.\"a/b\"]\naxial = \"3 mm\"\n[load.c]\nshear = 1\npoint = [1]\n",
    );
    workplace.is_refused(&[
        "error: a.section.toml:21: load \"none\" is zero, expected at least one of \"axial\", \
         \"shear_y\", \"shear_z\", \"torsion\", \"bending_y\", \"bending_z\", \"temperature\", \
         \"initial_strain\", \"traction\", \"volume\", \"voltages\"",
        "error: a.section.toml:23: load \"a/b\": expected a name of letters, digits, \"-\" and \"_\"",
        "  help: the name becomes part of file names",
        "error: a.section.toml:24: \"axial\": \"mm\" measures a length, expected a force",
        "  help: units of it: N, kN, MN, mN, daN, lbf, kip",
        "error: a.section.toml:25: load \"c\" is zero, expected at least one of \"axial\", \
         \"shear_y\", \"shear_z\", \"torsion\", \"bending_y\", \"bending_z\", \"temperature\", \
         \"initial_strain\", \"traction\", \"volume\", \"voltages\"",
        "error: a.section.toml:26: unknown key \"shear\" in load \"c\"",
        "  help: did you mean \"shear_y\"?",
        "error: a.section.toml:27: \"point\" is an array of 1, expected an array of 2, y and z, each a \
         length",
    ]);
    let workplace = Workplace::with(&[], &[]);
    let run = workplace.run(&["stress", "a.section.toml"]);
    assert_eq!(
        run.err,
        "error: a.section.toml: the section file has no load case, and the command line has no \
         load\n  help: add [load.NAME] to the section file, or give some of --axial, --shear-y, \
         --shear-z, --torsion, --bending-y, --bending-z\n"
    );
    assert_eq!(run.code, 2);
    assert!(!workplace.path("results").exists());
    for wrong in [
        &["--axial", "1 mm"][..],
        &["--torsion", "inf"],
        &["--axial", "0"],
        &["--name", "a"],
        &["--point", "1", "2"],
        &["--axial", "1", "--name", "a/b"],
    ] {
        let run = workplace.run(&[&["stress", "a.section.toml"], wrong].concat());
        assert_eq!(run.code, 2, "{wrong:?} {}", run.err);
    }
}

/// The squares of their stresses would not be finite. The force of 1 N at 1e30 m has a
/// moment of 1e30 N m about the origin.
#[test]
fn loads_beyond_all_structures_are_reported() {
    with("[load.far]\naxial = \"1 N\"\npoint = [\"0 m\", \"1e30 m\"]\n").is_refused(&[
        "error: a.section.toml:21: load \"far\" has bending y of 1e30 about the origin of the \
         mesh, expected at most 1e20",
        "  help: this is in SI units; check the unit and the \"point\" where the load acts",
    ]);
    let workplace = Workplace::with(&[], &[]);
    let run = workplace.run(&["stress", "a.section.toml", "--axial", "1e300"]);
    let reported = "error: load \"load\" has axial of 1e300 about";
    assert!(run.err.starts_with(reported), "{}", run.err);
    assert_eq!(run.code, 2);
}

#[test]
fn wrong_strengths_are_reported() {
    let refused = |strength: &str, expected: &[&str]| with(strength).is_refused(expected);
    refused(
        "[material.steel.strength]\nxt = 1\n",
        &[
            "error: a.section.toml:22: [material.steel.strength] has \"xt\", but the material is \
             isotropic",
            "  help: give \"yield\", or \"tension\", \"compression\" and \"shear\"",
        ],
    );
    refused(
        "[material.steel.strength]\nyield = 1\ntension = 1\n",
        &[
            "error: a.section.toml:22: [material.steel.strength] has \"tension\" and \"yield\", \
             which belong to two kinds of strength, expected one kind",
        ],
    );
    refused(
        "[material.steel.strength]\n[material.steel.strain_limit]\nyield = 1\n",
        &[
            "error: a.section.toml:21: [material.steel.strength] is empty, expected \"xt\" to \
             \"s23\", \"tension\" to \"shear\", or \"yield\"",
            "error: a.section.toml:22: [material.steel.strain_limit] is empty, expected \"xt\" to \
             \"s23\", or \"tension\" to \"shear\"",
            "error: a.section.toml:23: unknown key \"yield\" in [material.steel.strain_limit]",
            "  help: known keys: tension, compression, shear, m, xt, xc, yt, yc, s12, zt, zc, s13, s23, \
             m_matrix",
        ],
    );
    refused(
        "[material.steel.strength]\ntension = 1\ncompression = \"-5 MPa\"\n",
        &[
            "error: a.section.toml:21: [material.steel.strength] has no \"shear\", expected a stress",
        ],
    );
    refused(
        "[material.steel.strength]\ntension = 1\nshear = 1\ncompression = \"-5 Pa\"\n",
        &[
            "error: a.section.toml:24: material \"steel\": compression is -5, expected more than 0",
            "  help: strengths are positive numbers, also in compression; omit unknown ones",
        ],
    );
}

#[test]
fn wrong_strengths_of_plies_are_reported() {
    let ply = "e1 = 142\ne2 = 9.8\ne3 = 9.8\ng12 = 6\ng13 = 6\ng23 = 4.8\n\
        nu12 = 0.3\nnu13 = 0.3\nnu23 = 0.34";
    let section = SECTION.replace("young = 210\npoisson = 0.3", ply);
    let workplace = Workplace::with(&[], &[]);
    let strength = "[material.steel.strength]\nxt = 1\nxc = 1\nyt = -1\nyc = 1\ns12 = 1\nf12 = 2\n";
    workplace.write("a.section.toml", &format!("{section}{strength}"));
    workplace.is_refused(&[
        "error: a.section.toml:31: material \"steel\": yt is -1000000000, expected more than 0",
        "  help: strengths are positive numbers, also in compression; omit unknown ones",
        "error: a.section.toml:34: material \"steel\": f12 is 2, expected more than -1 and less \
         than 1",
        "  help: it is F12 / sqrt(F11 F22), without a unit; -0.5 is the usual choice",
    ]);
    let strength = "[material.steel.strength]\nyield = 1\n";
    workplace.write("a.section.toml", &format!("{section}{strength}"));
    workplace.is_refused(&[
        "error: a.section.toml:29: [material.steel.strength] has \"yield\", but the material is \
         not isotropic",
        "  help: give \"xt\", \"xc\", \"yt\", \"yc\" and \"s12\"",
    ]);
}

/// A section that cannot be solved leaves no stresses of an earlier run.
#[test]
fn stale_stresses_are_removed() {
    let workplace = with("[load.pull]\naxial = 400\n");
    assert_eq!(workplace.run(&["stress", "a.section.toml"]).code, 0);
    // a material so soft that the web is loose
    let text = workplace.read("a.section.toml");
    let soft = "[material.air]\nyoung = 1e-16\npoisson = 0.3\ndensity = 1\n\n[[region]]\ngroup = \"web\"\nmaterial = \"air\"";
    let text = text.replace("[[region]]\ngroup = \"web\"\nmaterial = \"steel\"", soft);
    workplace.write("a.section.toml", &text);
    let run = workplace.run(&["stress", "a.section.toml"]);
    assert_eq!((run.code, run.out.as_str()), (1, ""), "{}", run.err);
    assert!(
        FILES
            .iter()
            .all(|file| !workplace.path(&format!("results/a.pull.{file}")).exists())
    );
}

//! Piezoelectric materials, electrodes and voltages in the section file.

use crate::workplace::Workplace;

/// Three layers of two square cells each.
///
/// ```text
///   10 --- 11 --- 12   curve "top"
///    |  25  |  26  |   "upper"
///    7 ---- 8 ---- 9   curve "middle"
///    |  23  |  24  |   "lower"
///    4 ---- 5 ---- 6   curve "bottom"
///    |  21  |  22  |   "base"
///    1 ---- 2 ---- 3   curve "under"
/// ```
///
/// The curve "side" runs along 6, 9, 12; the point "wire" is node 10.
const LAYERS: &str = "\
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
9
0 9 \"wire\"
1 4 \"top\"
1 5 \"middle\"
1 6 \"bottom\"
1 7 \"under\"
1 8 \"side\"
2 1 \"base\"
2 2 \"lower\"
2 3 \"upper\"
$EndPhysicalNames
$Nodes
12
1 0 0 0
2 1 0 0
3 2 0 0
4 0 1 0
5 1 1 0
6 2 1 0
7 0 2 0
8 1 2 0
9 2 2 0
10 0 3 0
11 1 3 0
12 2 3 0
$EndNodes
$Elements
17
21 3 2 1 1 1 2 5 4
22 3 2 1 1 2 3 6 5
23 3 2 2 2 4 5 8 7
24 3 2 2 2 5 6 9 8
25 3 2 3 3 7 8 11 10
26 3 2 3 3 8 9 12 11
1 1 2 4 4 10 11
2 1 2 4 4 11 12
3 1 2 5 5 7 8
4 1 2 5 5 8 9
5 1 2 6 6 4 5
6 1 2 6 6 5 6
7 1 2 7 7 1 2
8 1 2 7 7 2 3
9 1 2 8 8 6 9
10 1 2 8 8 9 12
11 15 2 9 9 10
$EndElements
";

/// A bimorph on steel; electrodes follow, from line 36 on.
const SECTION: &str = "\
mesh = \"layers.msh\"

[units]
length = \"mm\"
stress = \"GPa\"

[material.steel]
young = 210
poisson = 0.3
density = \"7850 kg/m^3\"

[material.pzt]
young = 60
poisson = 0.3
density = \"7500 kg/m^3\"

[material.pzt.electric]
relative_permittivity = [3130, 3130, 3400]
[material.pzt.electric.d]
d31 = \"-274 pC/N\"
d32 = \"-274 pC/N\"
d33 = \"593 pC/N\"

[[region]]
group = \"base\"
material = \"steel\"

[[region]]
group = \"lower\"
material = \"pzt\"

[[region]]
group = \"upper\"
material = \"pzt\"

";

const TOP: &str = "[[electrode]]\nname = \"top\"\ncurve = \"top\"\n";
const MIDDLE: &str = "[[electrode]]\nname = \"middle\"\ncurve = \"middle\"\ncircuit = \"ground\"\n";

/// The section with more text at its end, in which each pair of texts has been replaced.
fn with(more: &str, changes: &[(&str, &str)]) -> Workplace {
    let workplace = Workplace::new();
    let mut text = format!("{SECTION}{more}");
    for (from, to) in changes {
        assert_eq!(text.matches(from).count(), 1, "\"{from}\"");
        text = text.replacen(from, to, 1);
    }
    workplace.write("a.section.toml", &text);
    workplace.write("layers.msh", LAYERS);
    workplace
}

fn refused(more: &str, changes: &[(&str, &str)], expected: &[&str]) {
    with(more, changes).is_refused(expected);
}

/// Output of `check`, with single spaces.
fn checked(more: &str, changes: &[(&str, &str)]) -> String {
    let run = with(more, changes).run(&["check", "a.section.toml"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    run.out.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// c33 = 0.7 / 0.52 * 60e9 = 80.769e9, c13 = 0.3 / 0.52 * 60e9 = 34.615e9 Pa:
/// e31 = -274e-12 * 115.385e9 + 593e-12 * 34.615e9 = -11.0885,
/// e33 = -548e-12 * 34.615e9 + 593e-12 * 80.769e9 = 28.9269, and
/// epsT33 - 548e-12 * 11.0885 - 593e-12 * 28.9269 = 6.8741e-9 F/m = 776.37 eps0.
#[test]
fn electric_laws_and_electrodes_are_shown() {
    let floating = "[[electrode]]\nname = \"sensor\"\npoint = \"wire\"\ncircuit = \"floating\"\n";
    let grounded = "[[electrode]]\nname = \"gnd\"\nregion = \"base\"\ncircuit = \"ground\"\n";
    let report = checked(&format!("{TOP}{grounded}"), &[]);
    for expected in [
        "relative permittivity at constant strain 3130, 3130, 776.367",
        "e31 -11.0885, e32 -11.0885, e33 28.9269 C/m^2",
        "top driven curve \"top\" 3 nodes",
        "gnd ground region \"base\" 3 nodes",
    ] {
        assert!(report.contains(expected), "{expected}: {report}");
    }
    // cells of steel are ignored, and a body is not a loose electrode
    assert!(!report.contains("Remarks"), "{report}");
    let report = checked(&format!("{floating}{MIDDLE}"), &[]);
    assert!(
        report.contains("sensor floating point \"wire\" 1 node"),
        "{report}"
    );
    let fingers = "[[electrode]]\nname = \"fibers\"\ninterdigitated = { regions = [2, \"upper\"], \
                   reversed = \"lower\", spacing = 0.5 }\n";
    let poled = ("[3130, 3130, 3400]", "[3130, 3130, 3400]\npoling = 1");
    let report = checked(fingers, &[poled]);
    for expected in [
        "e11 28.9269, e12 -11.0885, e13 -11.0885 C/m^2",
        "fibers driven interdigitated \"2\", \"upper\" 4 cells -2.00000e3 along axis 1, in 2 \
         cells reversed",
    ] {
        assert!(report.contains(expected), "{expected}: {report}");
    }
}

#[test]
fn what_is_odd_is_reported() {
    let report = checked("", &[]);
    assert!(
        report.contains(
            "remark: material \"pzt\" is piezoelectric, and the section has no electrodes: it \
             is solved with its stiffness at constant field, without potentials"
        ),
        "{report}"
    );
    let side =
        "[[electrode]]\nname = \"gnd\"\ncurve = [\"under\", \"bottom\"]\ncircuit = \"ground\"\n";
    let report = checked(side, &[("d32 = \"-274 pC/N\"\n", "")]);
    for expected in [
        "remark: material \"pzt\" has d31 and no d32, which is then 0",
        "remark: 3 of the 6 nodes of electrode \"gnd\" (node 1 for example) are on no dielectric",
        "gnd ground curve \"under\", \"bottom\" 3 nodes",
    ] {
        assert!(report.contains(expected), "{expected}: {report}");
    }
    let low = (
        "[3130, 3130, 3400]\n[material.pzt.electric.d]",
        "[0.2, 1, 1]\nat = \"strain\"\n[material.pzt.electric.d]",
    );
    let report = checked(&format!("{TOP}{MIDDLE}"), &[low]);
    assert!(
        report.contains("has a relative permittivity of 0.2 at constant strain"),
        "{report}"
    );
}

#[test]
fn electrodes_must_be_on_a_dielectric() {
    let under = "[[electrode]]\nname = \"under\"\ncurve = \"under\"\n";
    refused(
        &format!("{under}{MIDDLE}"),
        &[],
        &[
            "error: a.section.toml:36: electrode \"under\" is on no dielectric: none of its 3 nodes \
         belongs to a cell with an electric law",
            "  help: regions with an electric law: \"lower\", \"upper\"",
        ],
    );
    let steel = (
        "group = \"lower\"\nmaterial = \"pzt\"",
        "group = \"lower\"\nmaterial = \"steel\"",
    );
    let upper = (
        "group = \"upper\"\nmaterial = \"pzt\"",
        "group = \"upper\"\nmaterial = \"steel\"",
    );
    refused(
        &format!("{TOP}{MIDDLE}"),
        &[steel, upper],
        &[
            "error: a.section.toml:36: the section has electrodes, but no region is of a material \
         with an electric law",
            "  help: materials with an electric law, of no region: \"pzt\"",
        ],
    );
    let fingers = "[[electrode]]\nname = \"f\"\ninterdigitated = { regions = [\"upper\"], \
                   spacing = 1, axis = 3 }\n";
    refused(
        &format!("{fingers}{TOP}{MIDDLE}"),
        &[],
        &[
            "error: a.section.toml:39: electrode \"top\" is on no dielectric: none of its 3 nodes \
         belongs to a cell with an electric law outside of interdigitated electrodes",
            "  help: regions with an electric law: \"lower\", \"upper\"",
        ],
    );
}

#[test]
fn conductors_must_be_apart_and_grounded() {
    let side = "[[electrode]]\nname = \"side\"\ncurve = \"side\"\n";
    refused(
        &format!("{TOP}{MIDDLE}{side}"),
        &[],
        &[
            "error: a.section.toml:43: electrodes \"top\" (line 36) and \"side\" touch: both have \
             node 12, at (0.002, 0.003) m, expected separate conductors",
            "  help: shorten one of the curves so that dielectric is between them, or make both one \
         electrode by a list of curves",
            "error: a.section.toml:43: electrodes \"middle\" (line 39) and \"side\" touch: both \
             have node 9, at (0.002, 0.002) m, expected separate conductors",
            "  help: shorten one of the curves so that dielectric is between them, or make both one \
         electrode by a list of curves",
        ],
    );
    let ungrounded = MIDDLE.replace("ground", "floating");
    refused(
        &format!("{TOP}{ungrounded}"),
        &[],
        &[
            "error: a.section.toml:36: the dielectric of 4 cells in \"lower\", \"upper\" (cell 23 \
         for example, at (0.0005, 0.0015) m) has no ground: on it are \"top\" (driven), \
         \"middle\" (floating), expected one with circuit = \"ground\"",
            "  help: voltages are differences: ground one of the electrodes on each piece of \
         dielectric",
        ],
    );
}

/// The two dielectrics on both sides of steel are two pieces, which a conductor through
/// both connects.
#[test]
fn each_piece_of_dielectric_needs_a_ground() {
    let changes = [
        (
            "group = \"base\"\nmaterial = \"steel\"",
            "group = \"base\"\nmaterial = \"pzt\"",
        ),
        (
            "group = \"lower\"\nmaterial = \"pzt\"",
            "group = \"lower\"\nmaterial = \"steel\"",
        ),
    ];
    refused(
        &format!("{TOP}{MIDDLE}"),
        &changes,
        &[
            "error: a.section.toml:17: the dielectric of 2 cells in \"base\" (cell 21 for example, \
         at (0.0005, 0.0005) m) has no ground: no electrode is on it, expected one with circuit \
         = \"ground\"",
            "  help: add a grounded electrode, put its regions between fingers, or use a material \
             without [material.NAME.electric]",
        ],
    );
    let both = MIDDLE.replace("\"middle\"\ncirc", "[\"middle\", \"bottom\"]\ncirc");
    checked(&format!("{TOP}{both}"), &changes);
    // fingers have no potentials, and without a conductor no potentials exist: no
    // reference is needed
    let fingers = "[[electrode]]\nname = \"f\"\ninterdigitated = { regions = [\"base\", \
                   \"upper\"], spacing = 1, axis = 3 }\n";
    checked(fingers, &changes);
    checked(&fingers.replace("\"base\", ", ""), &changes);
}

#[test]
fn fingers_must_be_felt() {
    let fingers = |name: &str, rest: &str| {
        format!("[[electrode]]\nname = \"{name}\"\ninterdigitated = {{ spacing = 1, {rest} }}\n")
    };
    let first = fingers("f", "regions = [\"base\", \"upper\", \"lower\"]");
    let second = fingers("g", "regions = \"upper\", axis = 3");
    refused(
        &(first + &second),
        &[],
        &[
            "error: a.section.toml:36: interdigitated electrode \"f\" is in region \"base\", whose \
         material \"steel\" has no electric law",
            "  help: name the plies between the fingers only, NAME/1 and so on in a laminate",
            "error: a.section.toml:36: interdigitated electrode \"f\" has its field along axis 1 of \
         material \"pzt\" in region \"lower\", which couples fields along 3 only",
            "  help: fibers are poled along the field: set \"poling\" in [material.NAME.electric], \
         or \"axis\" of the electrode",
            "error: a.section.toml:36: interdigitated electrode \"f\" has its field along axis 1 of \
         material \"pzt\" in region \"upper\", which couples fields along 3 only",
            "  help: fibers are poled along the field: set \"poling\" in [material.NAME.electric], \
         or \"axis\" of the electrode",
            "error: a.section.toml:39: region \"upper\" is in the interdigitated electrodes \"f\" \
         (line 36) and \"g\", expected one",
        ],
    );
    let wrong = fingers("f", "regions = [\"uper\"], reversed = \"lower\"").replace("= 1", "= 0");
    refused(
        &wrong,
        &[],
        &[
            "error: a.section.toml:38: \"spacing\" is 0, expected a length greater than zero",
            "error: a.section.toml:38: the mesh has no physical surface \"uper\"",
            "  help: did you mean \"upper\"? physical surfaces of the mesh: \"base\", \"lower\", \
         \"upper\"",
        ],
    );
    let wrong = fingers("f", "regions = \"upper\", reversed = \"lower\", axis = 4");
    refused(
        &wrong,
        &[],
        &[
            "error: a.section.toml:38: \"axis\" is 4, expected 1, 2 or 3, an axis of the material",
            "error: a.section.toml:38: reversed region \"lower\" is not one of the regions \
             \"upper\"",
            "  help: \"reversed\" names some of the \"regions\"",
        ],
    );
}

#[test]
fn everything_wrong_with_electrodes_is_reported_at_once() {
    let wrong = "\
[[electrode]]
name = \"top\"
curve = \"tip\"
circut = \"ground\"
[[electrode]]
name = \"top\"
curve = [\"top\", 44]
region = \"base\"
[[electrode]]
curve = \"upper\"
circuit = \"grounded\"
[[electrode]]
name = \"a\"
point = \"wore\"
[[electrode]]
name = \"b\"
";
    refused(
        wrong,
        &[],
        &[
            "error: a.section.toml:38: the mesh has no physical curve \"tip\"",
            "  help: did you mean \"top\"? physical curves of the mesh: \"top\", \"middle\", \
         \"bottom\", \"under\", \"side\"",
            "error: a.section.toml:39: unknown key \"circut\" in [[electrode]] number 1",
            "  help: did you mean \"circuit\"?",
            "error: a.section.toml:41: electrode \"top\" has the same name as the electrode on \
             line 36, expected different names",
            "  help: upper and lower case are not distinguished: names are parts of file names",
            "error: a.section.toml:43: the electrode has \"curve\" and \"region\", expected one of \
         them",
            "  help: a conductor is on curves, fills regions or is at points of the mesh; fingers \
             across the beam are \"interdigitated\" and in regions",
            "error: a.section.toml:44: [[electrode]] number 3 has no \"name\", expected a name of \
         its own",
            "error: a.section.toml:45: the mesh has no physical curve \"upper\"",
            "  help: \"upper\" is a physical surface; give a physical curve",
            "error: a.section.toml:46: \"circuit\" is \"grounded\", expected one of \"driven\", \
         \"ground\", \"floating\"",
            "  help: did you mean \"ground\"?",
            "error: a.section.toml:49: the mesh has no physical point \"wore\"",
            "  help: did you mean \"wire\"? physical points of the mesh: \"wire\"",
            "error: a.section.toml:50: the electrode has no location, expected \"curve\", \
             \"region\", \"point\" or \"interdigitated\"",
            "  help: a conductor is on curves, fills regions or is at points of the mesh; fingers \
             across the beam are \"interdigitated\" and in regions",
        ],
    );
}

#[test]
fn voltages_belong_to_driven_electrodes() {
    let load = "[load.on]\nvoltages = { tip = 1, middle = \"2 V\" }\n[load.off]\nvoltages = {}\n";
    refused(
        &format!("{TOP}{MIDDLE}{load}"),
        &[],
        &[
            "error: a.section.toml:44: voltage for an unknown electrode \"tip\" in load \"on\"",
            "  help: did you mean \"top\"?",
            "error: a.section.toml:44: load \"on\" has a voltage for electrode \"middle\", whose \
         circuit is \"ground\", expected a driven one",
            "  help: a voltage belongs to circuit = \"driven\"; \"ground\" is at 0 V, and the \
             voltage of a floating electrode follows",
            "error: a.section.toml:45: load \"off\" is zero, expected at least one of \"axial\", \
         \"shear_y\", \"shear_z\", \"torsion\", \"bending_y\", \"bending_z\", \"temperature\", \
         \"initial_strain\", \"traction\", \"volume\", \"voltages\"",
        ],
    );
    let load = "[load.on]\nvoltages = { top = \"3 mm\" }\n";
    refused(
        &format!("{TOP}{MIDDLE}{load}"),
        &[],
        &[
            "error: a.section.toml:44: \"top\": \"mm\" measures a length, expected a voltage",
            "  help: units of it: V, mV, kV",
        ],
    );
    checked(
        &format!("{TOP}{MIDDLE}[load.on.voltages]\ntop = 0.1\n"),
        &[],
    );
    let load = "[load.on]\nvoltages = { top = 1 }\n";
    refused(
        load,
        &[],
        &[
            "error: a.section.toml:37: voltage for an unknown electrode \"top\" in load \"on\"",
            "  help: electrodes of the file: none",
        ],
    );
}

#[test]
fn what_does_not_work_with_electrodes_is_refused() {
    let head = (
        "mesh = \"layers.msh\"\n",
        "mesh = \"layers.msh\"\nprestress = \"biot\"\nend_effects = 2\n",
    );
    refused(
        &format!("{TOP}{MIDDLE}"),
        &[head],
        &[
            "error: a.section.toml:2: \"prestress\" is not known for sections with electrodes",
            "  help: remove it, or the electrodes",
            "error: a.section.toml:3: \"end_effects\" is not known for sections with electrodes",
            "  help: remove it, or the electrodes",
        ],
    );
    let workplace = with(&format!("{TOP}{MIDDLE}"), &[]);
    let both = ["--sensitivity", "--mesh-error"];
    let run = workplace.run(&[&["analyze", "a.section.toml"][..], &both].concat());
    assert_eq!(run.code, 2);
    let expected = both.map(|option| {
        format!(
            "error: a.section.toml: {option} is not known for sections with electrodes\n  help: \
             remove {option}, or the electrodes from the file\n"
        )
    });
    assert_eq!(run.err, expected.concat());
}

//! Temperatures and initial strains of the section file: messages, and written files.

use crate::workplace::Workplace;

/// The steel of both cells expands.
const EXPANDS: (&str, &str) = (
    "density = \"7850 kg/m^3\"\n",
    "density = \"7850 kg/m^3\"\nexpansion = 12e-6\n",
);

/// A section that expands, with more text at its end.
fn with(text: &str) -> Workplace {
    let last = "fiber_angle = 0\nplane_angle = 0\n";
    Workplace::with(&[EXPANDS, (last, &format!("{last}{text}"))], &[])
}

#[test]
fn wrong_temperatures_are_reported_together() {
    let text = "[temperature.none]\n\
        [temperature.both]\nrise = 1\ntable = \"a.csv\"\n\
        [temperature.zero]\nrise = 0\n\
        [temperature.long]\ngradient = [1, 2, 3]\n\
        [temperature.hot]\nrise = \"3 mm\"\n\
        [load.heat]\ntemperature = \"hat\"\n\
        [load.nothing]\naxial = 0\n";
    with(text).is_refused(&[
        "error: a.section.toml:22: temperature \"none\" has none of them, expected \"rise\", \
         \"gradient\" with or without \"rise\", or \"table\"",
        "error: a.section.toml:23: temperature \"both\" has \"rise\" and \"table\", expected \"rise\", \
         \"gradient\" with or without \"rise\", or \"table\"",
        "error: a.section.toml:26: temperature \"zero\" is zero everywhere, expected a nonzero \
         number",
        "error: a.section.toml:29: \"gradient\" is an array of 3, expected an array of 2, the \
         gradients along y and z",
        "error: a.section.toml:31: \"rise\": \"mm\" measures a length, expected a rise of temperature",
        "  help: units of it: K, degC, degF, R",
        "error: a.section.toml:33: unknown temperature \"hat\" in load \"heat\"",
        "  help: did you mean \"hot\"?",
        "error: a.section.toml:34: load \"nothing\" is zero, expected at least one of \"axial\", \
         \"shear_y\", \"shear_z\", \"torsion\", \"bending_y\", \"bending_z\", \"temperature\", \
         \"initial_strain\", \"traction\", \"volume\", \"voltages\"",
    ]);
}

#[test]
fn wrong_initial_strains_are_reported_together() {
    let text = "[initial_strain.cure]\n\
        [[initial_strain.cure.region]]\ngroup = \"wab\"\nstrain = [1e-3, 0, 0, 0, 0, 0]\n\
        [[initial_strain.cure.region]]\ngroup = \"skin\"\nstrain = [1e-3, 0, 0, 0, 0, 0]\n\
        [[initial_strain.cure.region]]\ngroup = \"skin\"\nstrain = [1e-3, 0, 0, 0, 0, 0]\n\
        [initial_strain.empty]\n\
        [initial_strain.short]\n\
        [[initial_strain.short.region]]\ngroup = \"skin\"\nstrain = [1e-3, 0]\n\
        [initial_strain.large]\n\
        [[initial_strain.large.region]]\ngroup = \"skin\"\nstrain = [2, 0, 0, 0, 0, 0]\n\
        [temperature.hot]\nrise = 1\n\
        [initial_strain.hot]\n\
        [[initial_strain.hot.region]]\ngroup = \"skin\"\nstrain = [1e-3, 0, 0, 0, 0, 0]\n";
    let run = with(text).run(&["check", "a.section.toml"]);
    assert_eq!(run.code, 2);
    for expected in [
        ":24: unknown region \"wab\" in initial strain \"cure\"\n  help: did you mean \"web\"?",
        ":30: initial strain \"cure\" has region \"skin\" twice, expected it once",
        ":32: initial strain \"empty\" has no region, expected [[initial_strain.empty.region]]",
        ":36: \"strain\" is an array of 2, expected an array of 6 strains in material axes, order \
         11 22 33 23 13 12",
        ":40: strain 11 is 2, expected at most 1",
        ":43: [initial_strain.hot] has the name of [temperature.hot] on line 41, expected \
         different names",
    ] {
        assert!(
            run.err.contains(expected),
            "{expected}\nis not in\n{}",
            run.err
        );
    }
}

#[test]
fn tables_of_rises_fit_the_cells_of_the_mesh() {
    let workplace = with("[temperature.map]\ntable = \"map.csv\"\n");
    workplace.write("map.csv", "cell,rise\n11,20\n13,20\n");
    workplace.is_refused(&[
        "error: a.section.toml:23: rise table \"map.csv\" has 2 rows, expected 2, one for each cell \
         of the mesh; no rise for cell 12; unknown cell 13",
    ]);
    workplace.write("map.csv", "cell,angle\n11,20\n12,1e9\n");
    workplace.is_refused(&[
        "error: map.csv:1: the columns are \"cell,angle\", expected \"cell,rise\"",
        "error: map.csv:3: row \"12,1e9\" cannot be read, expected a rise of temperature of at most \
         100000 in the second column",
    ]);
}

#[test]
fn heat_needs_something_that_expands() {
    let last = "fiber_angle = 0\nplane_angle = 0\n";
    let heated = format!("{last}[temperature.hot]\nrise = 5\n");
    Workplace::with(&[(last, &heated)], &[]).is_refused(&[
        "error: a.section.toml:21: temperature \"hot\" has no effect: no region has a material \
         with a nonzero \"expansion\"",
        "  help: add \"expansion\" to [material.NAME] of the heated regions: strain per declared \
         unit of temperature, or a text with its own unit, \"12e-6 1/K\"",
    ]);
    // an expansion of zero is treated as none
    let zero = (
        "density = \"7850 kg/m^3\"\n",
        "density = \"7850 kg/m^3\"\nexpansion = 0\n",
    );
    let run = Workplace::with(&[zero, (last, &heated)], &[]).run(&["check", "a.section.toml"]);
    assert_eq!(run.code, 2);
    assert!(
        run.err.contains("temperature \"hot\" has no effect"),
        "{}",
        run.err
    );
    let material = "[material.foam]\nyoung = 0.1\npoisson = 0.3\ndensity = \"100 kg/m^3\"\n";
    let region = "group = \"web\"\nmaterial = \"steel\"";
    let changes = [
        EXPANDS,
        (region, "group = \"web\"\nmaterial = \"foam\""),
        (last, &format!("{last}{material}")),
    ];
    let run = Workplace::with(&changes, &[]).run(&["check", "a.section.toml"]);
    assert_eq!(run.code, 0);
    let warning = "material \"foam\" has no \"expansion\", and others have: it does not expand";
    assert!(run.out.contains(warning), "{}", run.out);

    let expansion = ("expansion = 12e-6", "expansion = [1e-6, 2e-6]");
    let both = [EXPANDS, expansion];
    Workplace::with(&both, &[]).is_refused(&[
        "error: a.section.toml:11: \"expansion\" is an array of 2, expected an expansion \
         coefficient, or an array of 3, one for each material axis",
    ]);
    Workplace::with(&[EXPANDS, ("12e-6", "12")], &[]).is_refused(&[
        "error: a.section.toml:11: \"expansion\" is 12, expected coefficients of at most 0.01 1/K",
    ]);
}

/// An unknown name is reported together with a wrong value of the same table, and a key
/// of another table with the intended key.
#[test]
fn names_are_looked_for_even_if_values_are_wrong() {
    let text = "[initial_strain.cure]\n\
        [[initial_strain.cure.region]]\ngroup = \"wab\"\nstrain = [1e-3]\n\
        [[initial_strain.cure.region]]\nregion = \"skin\"\nstrain = [1e-3, 0, 0, 0, 0, 0]\n\
        [temperature.none]\ntable = \"zero.csv\"\n";
    let workplace = with(text);
    workplace.write("zero.csv", "cell,rise\n11,0\n12,0\n");
    let run = workplace.run(&["check", "a.section.toml"]);
    assert_eq!(run.code, 2);
    for expected in [
        ":24: unknown region \"wab\" in initial strain \"cure\"\n  help: did you mean \"web\"?",
        ":25: \"strain\" is an array of 1",
        "unknown key \"region\"",
        "  help: did you mean \"group\"?",
        ":30: temperature \"none\" is zero everywhere",
    ] {
        assert!(run.err.contains(expected), "{expected}\n{}", run.err);
    }
}

/// Steel heated uniformly without any stress: round-off is shown as zero, in the report
/// and in the figures, compared with the stress of the restrained section.
#[test]
fn free_heat_is_shown_without_stress() {
    let strong = (
        "[[region]]\ngroup = \"skin\"",
        "[material.steel.strength]\nyield = 0.3\n[[region]]\ngroup = \"skin\"",
    );
    let last = "fiber_angle = 0\nplane_angle = 0\n";
    let heat = format!("{last}[temperature.hot]\nrise = 50\n[load.heat]\ntemperature = \"hot\"\n");
    let workplace = Workplace::with(&[EXPANDS, strong, (last, &heat)], &[]);
    let run = workplace.run(&["analyze", "a.section.toml"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let report = workplace.read("results/a.heat.stress.txt");
    let (_, stresses) = report.split_once("Extreme stresses").unwrap();
    assert!(!stresses.contains("e-"), "{report}");
    assert!(report.contains("smallest reserve factor: none"), "{report}");
    // its strain is not zero
    assert!(report.contains("6.00000e-4"), "{report}");
}

/// Property file, report and stresses: two cells of one steel, 2 mm wide and 1 mm high,
/// heated by 50 K, have the force E alpha A T if restrained and no stress if free.
#[test]
fn heat_is_in_all_results() {
    let workplace = with("[temperature.hot]\nrise = 50\n[load.heat]\ntemperature = \"hot\"\n");
    let run = workplace.run(&["analyze", "a.section.toml"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    for words in [
        "expansion 1.2e-5 1/K",
        "Thermal force, per kelvin when fully restrained [N/K, N m/K]",
        "Imposed state \"hot\"",
        "free strain [-, 1/m]",
    ] {
        assert!(run.out.contains(words), "{words}\n{}", run.out);
    }
    let file = shared_geom::section::read(&workplace.path("results/a.properties.json")).unwrap();
    // E alpha A
    let push = 210e9 * 12e-6 * 2e-6;
    let thermal = file.thermal_force.unwrap();
    assert!((thermal[0] / -push - 1.0).abs() < 1e-12, "{thermal}");
    let state = &file.imposed[0];
    assert_eq!(state.name, "hot");
    assert!((state.restrained_force[0] / (-50.0 * push) - 1.0).abs() < 1e-12);
    assert!((state.free_strain[0] / 6e-4 - 1.0).abs() < 1e-12);
    assert!(
        workplace
            .read("results/a.properties.json")
            .contains("\"version\": 3")
    );

    let stresses = workplace.read("results/a.heat.stress.txt");
    assert!(
        stresses.contains("under the imposed strains of hot"),
        "{stresses}"
    );
    let reported = workplace.run(&["report", "results/a.properties.json"]);
    assert!(
        reported.out.contains("Imposed state \"hot\""),
        "{}",
        reported.out
    );
}

//! Electric laws of materials in the section file, and materials without stiffness.

use crate::workplace::Workplace;

const MATERIAL: (&str, &str) = (
    "poisson = 0.3\ndensity = \"7850 kg/m^3\"\n",
    "poisson = 0.3\ndensity = 7\n",
);

/// The section of steel with this table after its material, from line 11 on.
fn with(table: &str) -> Workplace {
    let material = format!("{}[material.steel.electric]\n{table}\n", MATERIAL.1);
    Workplace::with(&[(MATERIAL.0, &material)], &[])
}

fn refused(table: &str, expected: &[&str]) {
    with(table).is_refused(expected);
}

/// The same ceramic in both forms, and in units of pounds and inches: 1 psi in/V is
/// 175.126835 C/m^2, 1 lbf/V^2 is 4.4482216 F/m, from which these numbers are computed.
#[test]
fn both_forms_and_other_units_give_one_law() {
    let shown = |table: &str| {
        let run = with(table).run(&["check", "a.section.toml"]);
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{table}");
        let lines = run
            .out
            .lines()
            .skip_while(|line| !line.contains("relative permittivity"));
        let lines: Vec<_> = lines.take(2).map(str::trim).map(str::to_owned).collect();
        lines.join("; ")
    };
    let d = "relative_permittivity = 3000\nd = { d31 = \"-100 pC/N\", d32 = \"-100 pC/N\", d33 = \"200 pC/N\" }";
    // c33 = 0.7 / 0.52 * 210e9 = 282.692e9, c13 = 0.3 / 0.52 * 210e9 = 121.154e9
    // e31 = -1e-10 * 403.846e9 + 2e-10 * 121.154e9 = -16.1538
    // e33 = -2e-10 * 121.154e9 + 2e-10 * 282.692e9 = 32.3077
    // epsS33 = 3000 eps0 - 2e-10 * 16.1538 - 2e-10 * 32.3077 = 16.8703e-9 = 1905.34 eps0
    let of_d = shown(d);
    assert_eq!(
        of_d,
        "relative permittivity at constant strain 3000, 3000, 1905.34; e31 -16.1538, e32 \
         -16.1538, e33 32.3077 C/m^2"
    );
    let e = "relative_permittivity = 3000\nat = \"stress\"\ne = [[0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], \
             [\"-16.153846153846 C/m^2\", \"-16.153846153846 C/m^2\", \"32.307692307692 C/m^2\", 0, 0, 0]]";
    assert_eq!(shown(e), of_d);
    let psi = "permittivity = [\"5.9715018e-9 lbf/V^2\", \"5.9715018e-9 lbf/V^2\", \"3.7925844e-9 lbf/V^2\"]\n\
               e = { e31 = \"-0.09224084 psi in/V\", e32 = \"-0.09224084 psi in/V\", e33 = \"0.1844817 psi in/V\" }";
    assert_eq!(shown(psi), of_d);
}

#[test]
fn poling_must_be_at_a_right_angle() {
    let dielectric = |rest: &str| format!("relative_permittivity = 3000\n{rest}");
    let across = "  help: \"poling\" is the axis 3 of the constants and \"across\" their axis 1: \
                  give a direction normal to the poling";
    refused(
        &dielectric("poling = [1, 0, 1]\nacross = 1"),
        &[
            "error: a.section.toml:14: material \"steel\": \"poling\" and \"across\" are at 45.000 \
         deg, expected a right angle",
            across,
        ],
    );
    refused(
        &dielectric("poling = 2\nacross = [0, 3, 0]"),
        &[
            "error: a.section.toml:14: material \"steel\": \"poling\" and \"across\" are at 0.000 \
         deg, expected a right angle",
            across,
        ],
    );
    refused(
        &dielectric("poling = [0, 0, 0]"),
        &[
            "error: a.section.toml:13: material \"steel\": \"poling\" has no length, expected a \
         direction",
            "  help: give 1, 2 or 3 for a material axis, or three components",
        ],
    );
    refused(
        &dielectric("poling = [1, 1, 0]"),
        &[
            "error: a.section.toml:13: material \"steel\": \"poling\" is along none of the \
             material axes and without \"across\", expected both",
            "  help: \"across\" is the direction of axis 1 of the constants, at a right angle to \
             \"poling\"; for a ceramic, isotropic across the poling, any direction works",
        ],
    );
    refused(
        &dielectric("poling = 4"),
        &[
            "error: a.section.toml:13: \"poling\" is 4, expected 1, 2 or 3 for a material axis, \
             with a minus for the opposite direction, or an array of 3, its components along \
             them",
        ],
    );
    for sound in [
        "poling = -3",
        "poling = [0.6, 0, 0.8]\nacross = [0.8, 0, -0.6]",
    ] {
        assert_eq!(
            with(&dielectric(sound))
                .run(&["check", "a.section.toml"])
                .code,
            0
        );
    }
}

/// e31 = -1e-10 * 282.692e9 + 2e-10 * 121.154e9 = -4.0385, e33 = 44.4231 likewise: they
/// subtract 1e-10 * 4.0385 + 2e-10 * 44.4231 = 9.2885e-9 from 300 times 8.8542e-12 F/m.
#[test]
fn laws_that_cannot_exist_are_reported_with_the_part() {
    refused(
        "relative_permittivity = 300\nd = { d31 = \"-100 pC/N\", d32 = 0, d33 = \"200 pC/N\" }",
        &[
            "error: a.section.toml:13: material \"steel\": the coupled law is indefinite: the \
             permittivity at constant strain, epsT - d c d', has the eigenvalue -6.6322e-9 F/m \
             (at constant stress 2.6563e-9 to 2.6563e-9 F/m), expected all of them more than 0",
            "  help: d, the stiffness and the permittivity are inconsistent: the stiffness is at \
             constant field, and with d the permittivity is at constant stress unless at = \
             \"strain\"; check the unit of d too",
        ],
    );
    refused(
        "permittivity = [[1e-9, 2e-9, 0], [2e-9, 1e-9, 0], [0, 0, 1e-9]]",
        &[
            "error: a.section.toml:12: material \"steel\": the permittivity has the eigenvalue \
         -1e-9 F/m, expected all of them more than 0",
            "  help: the energy of a field must be positive in all directions: rows and columns \
             are in the order of axes 1 2 3",
        ],
    );
    refused(
        "permittivity = 3000",
        &[
            "error: a.section.toml:12: material \"steel\": the permittivity has the eigenvalue \
         3e3 F/m, expected 1e-15 to 1e-4 F/m",
            "  help: the vacuum permittivity is 8.854e-12 F/m; \"relative_permittivity\" is in \
             units of it",
        ],
    );
    // millimeters and newtons
    let e = "relative_permittivity = 3000\ne = { e33 = 17 }";
    refused(
        e,
        &[
            "error: a.section.toml:13: material \"steel\": e33 is 1.7e4 C/m^2, expected at most \
             1e3 C/m^2",
            "  help: plain numbers are in units of the declared force, length and voltage: give \
             the unit with the number, as in \"17 C/m^2\" or \"741 pC/N\"",
        ],
    );
}

#[test]
fn forms_exclude_each_other() {
    refused(
        "d = { d33 = 1e-12 }\ne = { e33 = 1 }\nat = \"stres\"",
        &[
            "error: a.section.toml:11: [material.steel.electric] has no permittivity, expected \
         \"permittivity\" or \"relative_permittivity\"",
            "error: a.section.toml:13: [material.steel.electric] has \"d\" and \"e\", expected one \
         of them",
            "  help: one follows from the other by the stiffness: e = d c",
            "error: a.section.toml:14: \"at\" is \"stres\", expected one of \"stress\", \"strain\"",
            "  help: did you mean \"stress\"?",
        ],
    );
    refused(
        "relative_permittivity = 3\npermittivity = 3\nat = \"stress\"",
        &[
            "error: a.section.toml:12: [material.steel.electric] has \"permittivity\" and \
         \"relative_permittivity\", expected one of them",
        ],
    );
    refused(
        "relative_permittivity = 3\nat = \"stress\"",
        &[
            "error: a.section.toml:13: [material.steel.electric] has \"at\", but no \"d\" or \"e\"",
            "  help: without coupling the permittivity is the same at constant stress and strain",
        ],
    );
    refused(
        "relative_permittivity = [3, 3]\nd = { d13 = 0, d3 = 1 }",
        &[
            "error: a.section.toml:12: \"relative_permittivity\" is an array of 2, expected a pure \
         number, an array of 3, one for each axis, or 3 rows of 3",
            "error: a.section.toml:13: unknown key \"d3\" in [material.steel.electric.d]",
            "  help: did you mean \"d13\"?",
            "error: a.section.toml:13: [material.steel.electric]: \"d\" is zero, expected a \
             nonzero constant",
            "  help: remove it for a dielectric that is not piezoelectric",
        ],
    );
    refused(
        "relative_permittivity = 3\nd = { d33 = \"3 pC/m\" }",
        &[
            "error: a.section.toml:13: \"d33\": \"pC/m\" measures a charge per length, expected a \
         strain per electric field",
            "  help: units of it: m/V, pC/N, in/V",
        ],
    );
}

/// Expansions 3e-6 along (1, 0, 1) and 2e-6 along (-1, 0, 1) have the shear (3 - 2)/2 e-6.
#[test]
fn poling_turns_no_strengths_and_only_plain_expansions() {
    let ply = "e1 = 142\ne2 = 9.8\ne3 = 9.8\ng12 = 6\ng13 = 6\ng23 = 4.8\n\
        nu12 = 0.3\nnu13 = 0.34\nnu23 = 0.42\ndensity = 7\nexpansion = [1e-6, 2e-6, 3e-6]\n\
        [material.steel.strength]\nxt = 1\nxc = 1\nyt = 1\nyc = 1\ns12 = 1\n\
        [material.steel.electric]\nrelative_permittivity = 3\n";
    let workplace = |poling: &str| {
        let law = "young = 210\npoisson = 0.3\ndensity = \"7850 kg/m^3\"\n";
        Workplace::with(&[(law, &format!("{ply}{poling}\n"))], &[])
    };
    workplace("poling = [1, 0, 1]\nacross = 2").is_refused(&[
        "error: a.section.toml:18: material \"steel\": rotated by \"poling\", the expansion has a \
         shear 5.000e-7 1/K in material axes, expected axes without shear",
        "  help: rotate the material by the angles of its regions, or make the expansion one \
         number",
        "error: a.section.toml:19: [material.steel.strength] is along the material axes, and \
         \"poling\" rotates the other constants, expected no poling but 3 with strengths",
        "  help: give all constants along the material axes, with \"d\" or \"e\" as 3 rows of 6, \
         and no \"poling\"",
    ]);
    assert_eq!(
        workplace("poling = 3")
            .run(&["check", "a.section.toml"])
            .code,
        0
    );
}

/// The web has no stiffness.
fn potted(material: &str, web: &str) -> Workplace {
    let web = format!("group = \"web\"\nmaterial = \"{web}\"");
    Workplace::with(
        &[
            ("group = \"web\"\nmaterial = \"steel\"", &web),
            ("[material.steel]", &format!("{material}[material.steel]")),
        ],
        &[],
    )
}

#[test]
fn materials_without_stiffness_are_dielectrics() {
    let air = "[material.air]\nstiffness = \"none\"\nelectric = { relative_permittivity = 1 }\n";
    let run = potted(air, "air").run(&["check", "a.section.toml"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(!run.out.contains("Remarks"), "{}", run.out);
    assert!(
        run.out.contains(
            "  air: no stiffness, 0 kg/m^3\n      relative permittivity at constant strain 1, 1, 1\n"
        ),
        "{}",
        run.out
    );
    potted(
        "[material.air]\nstiffness = \"none\"\nexpansion = 1e-5\n",
        "air",
    )
    .is_refused(&[
        "error: a.section.toml:8: material \"air\" has neither stiffness nor electric law, \
         expected [material.air.electric]",
        "  help: remove its cells from the mesh, or give a filler a small modulus",
        "error: a.section.toml:9: material \"air\" has no stiffness, and \"expansion\"",
        "  help: remove it: it has no effect",
    ]);
    let coupled = air.replace("= 1 }", "= 1, e = { e33 = 1 } }");
    potted(&coupled, "air").is_refused(&[
        "error: a.section.toml:9: material \"air\" has no stiffness, and \"e\" of \
         [material.air.electric]",
        "  help: the coupling needs a stiffness: give one, or remove the coupling",
    ]);
    potted(&air.replace("none", "non"), "air").is_refused(&[
        "error: a.section.toml:7: material \"air\" has no \"density\", expected a density",
        "error: a.section.toml:8: \"stiffness\" is \"non\", expected one of \"none\"",
        "  help: did you mean \"none\"?",
    ]);
}

/// A section of air only, and three cells, the middle one of air.
#[test]
fn what_has_a_stiffness_must_hold_together() {
    let air = "stiffness = \"none\"\nelectric = { relative_permittivity = 1 }\n";
    let law = "young = 210\npoisson = 0.3\ndensity = \"7850 kg/m^3\"\n";
    Workplace::with(&[(law, air)], &[]).is_refused(&[
        "error: a.section.toml:1: no cell of the section has a stiffness: all regions are of \
         materials with stiffness = \"none\"",
        "  help: a beam needs at least one region with a stiffness",
    ]);
    let workplace = potted(&format!("[material.air]\n{air}"), "air");
    let mesh = crate::workplace::TWO_CELLS
        .replace("$Nodes\n6\n", "$Nodes\n8\n7 3 0 0\n8 3 1 0\n")
        .replace("$Elements\n3\n", "$Elements\n4\n14 3 2 1 1 3 7 8 6\n");
    workplace.write("two.msh", &mesh);
    workplace.is_refused(&[
        "error: a.section.toml:1: only cells without stiffness connect the section: the others \
         are in 2 parts, 1 cell with cell 14 in \"skin\" at (0.0025, 0.0005) m, 1 cell with cell \
         11 in \"skin\" at (0.0005, 0.0005) m, expected one part, connected through whole sides",
        "  help: give the filler between them a small modulus, such as 1e-6 of the modulus of the \
         others",
    ]);
}

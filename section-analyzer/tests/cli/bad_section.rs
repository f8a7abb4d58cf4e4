//! Problems of the section file itself.

use crate::workplace::Workplace;

#[test]
fn unknown_key_is_reported_with_the_nearest() {
    let workplace = Workplace::with(&[("fiber_angle = 0", "fibre_angle = 0")], &[]);
    workplace.is_refused(&[
        "error: a.section.toml:19: unknown key \"fibre_angle\" in [[region]] number 2",
        "  help: did you mean \"fiber_angle\"?",
    ]);
}

#[test]
fn wrong_units_are_reported_with_those_that_fit() {
    let density = ("\"7850 kg/m^3\"", "\"7850 kg/m^2\"");
    Workplace::with(&[density], &[]).is_refused(&[
        "error: a.section.toml:10: \"density\": \"kg/m^2\" measures a quantity in kg m^-2, \
         expected a density",
        "  help: units of it: kg/m^3, g/cm^3, lb/in^3, slug/ft^3",
    ]);
    Workplace::with(&[("\"mm\"", "\"mmm\"")], &[]).is_refused(&[
        "error: a.section.toml:4: \"length\": unknown unit \"mmm\"",
        "  help: did you mean \"mm\"?",
    ]);
    Workplace::with(&[("\"mm\"", "\"mn\"")], &[]).is_refused(&[
        "error: a.section.toml:4: \"length\": unknown unit \"mn\"",
        "  help: did you mean \"mm\"?",
    ]);
    Workplace::with(&[("\"mm\"", "25.4")], &[])
        .is_refused(&["error: a.section.toml:4: \"length\" is 25.4, expected a text in quotes"]);
    Workplace::with(&[("young = 210", "young = \"210,5GPa\"")], &[]).is_refused(&[
        "error: a.section.toml:8: \"young\": \"210,5GPa\" cannot be read, expected a number \
         and a unit, as in \"73.1 GPa\"",
        "  help: write \"210.5GPa\", with a decimal point",
    ]);
    Workplace::with(&[("fiber_angle = 0", "fiber_angle = \"3 mm\"")], &[]).is_refused(&[
        "error: a.section.toml:19: \"fiber_angle\": \"mm\" measures a length, expected an angle",
        "  help: units of it: rad, deg, rev",
    ]);
    let none = ("[units]\nlength = \"mm\"\nstress = \"GPa\"", "\n\n");
    Workplace::with(&[none], &[]).is_refused(&[
        "error: a.section.toml:1: the file has no \"units\", expected \"SI\", or a table as in \
         { length = \"mm\", force = \"N\" }",
    ]);
}

#[test]
fn materials_that_cannot_exist_are_reported_with_the_bound() {
    Workplace::with(&[("poisson = 0.3", "poisson = 0.5")], &[]).is_refused(&[
        "error: a.section.toml:9: material \"steel\": poisson is 0.5, expected more than -1 and \
         less than 0.5",
        "  help: nearly incompressible materials such as rubber have 0.49 to 0.4999",
    ]);
    let orthotropic = "e1 = 142\ne2 = 9.8\ne3 = 9.8\ng12 = 6\ng13 = 6\ng23 = 4.8\n\
        nu12 = 0.3\nnu13 = 4\nnu23 = 0.34";
    // sqrt(142/9.8) = 3.80654...
    Workplace::with(&[("young = 210\npoisson = 0.3", orthotropic)], &[]).is_refused(&[
        "error: a.section.toml:15: material \"steel\": |nu13| is 4.000000, expected less than \
         sqrt(E1/E3) = 3.806546",
        "  help: nu_ij is -strain_j / strain_i under a stress along i alone; nu_ji = nu_ij E_j / \
         E_i may have been given instead",
    ]);
    let rows = "stiffness = [\n[1, 2, 0, 0, 0, 0],\n[2, 1, 0, 0, 0, 0],\n[0, 0, 1, 0, 0, 0],\n\
        [0, 0, 0, 1, 0, 0],\n[0, 0, 0, 0, 1, 0],\n[0, 0, 0, 0, 0, 1]]";
    // The block [1 2; 2 1] has the eigenvalues 3 and -1.
    Workplace::with(&[("young = 210\npoisson = 0.3", rows)], &[]).is_refused(&[
        "error: a.section.toml:8: material \"steel\": smallest eigenvalue of the stiffness is \
         -1e9 Pa, the largest 3e9 Pa, expected more than 0",
        "  help: rows and columns are ordered 11 22 33 23 13 12, with engineering shear strains",
    ]);
}

#[test]
fn kind_of_material_must_be_clear() {
    Workplace::with(&[("poisson = 0.3", "e1 = 3")], &[]).is_refused(&[
        "error: a.section.toml:9: material \"steel\" has \"young\" and \"e1\", which belong to \
         two kinds of material, expected one kind",
    ]);
    Workplace::with(&[("young = 210\npoisson = 0.3\n", "")], &[]).is_refused(&[
        "error: a.section.toml:7: material \"steel\" has no elastic constants, expected \
         \"young\" and \"poisson\", \"e1\" to \"nu23\", or \"stiffness\"",
    ]);
    Workplace::with(&[("poisson = 0.3\n", "")], &[]).is_refused(&[
        "error: a.section.toml:7: material \"steel\" has no \"poisson\", expected a pure number",
    ]);
}

#[test]
fn unknown_material_is_reported_with_the_nearest() {
    let slip = (
        "group = \"web\"\nmaterial = \"steel\"",
        "group = \"web\"\nmaterial = \"steal\"",
    );
    Workplace::with(&[slip], &[]).is_refused(&[
        "error: a.section.toml:18: unknown material \"steal\" in region \"web\"",
        "  help: did you mean \"steel\"?",
    ]);
    let other = (
        "group = \"web\"\nmaterial = \"steel\"",
        "group = \"web\"\nmaterial = \"foam\"",
    );
    Workplace::with(&[other], &[]).is_refused(&[
        "error: a.section.toml:18: unknown material \"foam\" in region \"web\"",
        "  help: materials of the file: \"steel\"",
    ]);
}

#[test]
fn unknown_group_is_reported_with_the_nearest_and_all() {
    Workplace::with(&[("\"web\"", "\"wib\"")], &[]).is_refused(&[
        "error: a.section.toml:1: physical surface \"web\" (1 cell) has no region",
        "  help: add [[region]] with group = \"web\" and its material",
        "error: a.section.toml:17: the mesh has no physical surface \"wib\"",
        "  help: did you mean \"web\"? physical surfaces of the mesh: \"skin\", \"web\"",
    ]);
}

#[test]
fn group_needs_one_region() {
    Workplace::with(&[("\"web\"", "\"skin\"")], &[]).is_refused(&[
        "error: a.section.toml:1: physical surface \"web\" (1 cell) has no region",
        "  help: add [[region]] with group = \"web\" and its material",
        "error: a.section.toml:17: physical surface \"skin\" already has a region on line 12, \
         expected one",
    ]);
    let bare = ("group = \"web\"\nmaterial = \"steel\"", "group = \"web\"");
    Workplace::with(&[bare], &[]).is_refused(&[
        "error: a.section.toml:16: [[region]] number 2 has no \"material\", expected the name \
         of a material",
    ]);
}

#[test]
fn group_may_be_given_by_its_number() {
    for number in ["2", "\"2\""] {
        let workplace = Workplace::with(&[("\"web\"", number)], &[]);
        assert_eq!(workplace.run(&["check", "a.section.toml"]).code, 0);
    }
}

#[test]
fn angle_must_be_a_number_a_table_or_a_curve() {
    let change = |angle| Workplace::with(&[("plane_angle = 0", angle)], &[]);
    change("plane_angle = {}")
        .is_refused(&["error: a.section.toml:20: \"plane_angle\" has no \"table\" or \"follow\""]);
    change("plane_angle = { table = \"a.csv\", follow = \"edge\" }").is_refused(&[
        "error: a.section.toml:20: \"plane_angle\" has both \"table\" and \"follow\", expected \
         one of them",
    ]);
    change("plane_angle = { follow = \"egde\" }").is_refused(&[
        "error: a.section.toml:20: the mesh has no physical curve \"egde\"",
        "  help: did you mean \"edge\"? physical curves of the mesh: \"edge\", \"bare\"",
    ]);
    change("plane_angle = { follow = \"bare\" }").is_refused(&[
        "error: a.section.toml:20: physical curve \"bare\" has no lines in the mesh, expected \
         at least one",
    ]);
    change("plane_angle = { follow = \"edge\", revers = true }").is_refused(&[
        "error: a.section.toml:20: unknown key \"revers\" in [region.plane_angle]",
        "  help: did you mean \"reverse\"?",
    ]);
    let fiber = ("fiber_angle = 0", "fiber_angle = { follow = \"edge\" }");
    Workplace::with(&[fiber], &[]).is_refused(&[
        "error: a.section.toml:19: \"fiber_angle\" has no \"table\"",
        "error: a.section.toml:19: unknown key \"follow\" in [region.fiber_angle]",
        "  help: known keys: table",
    ]);
}

#[test]
fn several_problems_come_together() {
    let changes = [
        ("poisson = 0.3", "poisson = 0.7"),
        ("\"skin\"", "\"skim\""),
        ("fiber_angle = 0", "fiber_angel = 0"),
        ("plane_angle = 0", "plane_angle = { table = \"none.csv\" }"),
    ];
    Workplace::with(&changes, &[]).is_refused(&[
        "error: a.section.toml:1: physical surface \"skin\" (1 cell) has no region",
        "  help: add [[region]] with group = \"skin\" and its material",
        "error: a.section.toml:9: material \"steel\": poisson is 0.7, expected more than -1 and \
         less than 0.5",
        "  help: nearly incompressible materials such as rubber have 0.49 to 0.4999",
        "error: a.section.toml:13: the mesh has no physical surface \"skim\"",
        "  help: did you mean \"skin\"? physical surfaces of the mesh: \"skin\", \"web\"",
        "error: a.section.toml:19: unknown key \"fiber_angel\" in [[region]] number 2",
        "  help: did you mean \"fiber_angle\"?",
        "error: a.section.toml:20: angle table \"none.csv\" cannot be read: no such file",
        "  help: no file there ends in .csv; files there: a.section.toml, two.msh",
    ]);
}

#[test]
fn text_that_is_no_toml_is_reported_with_its_line() {
    let run =
        Workplace::with(&[("young = 210", "young 210")], &[]).run(&["check", "a.section.toml"]);
    assert_eq!(run.code, 2);
    assert!(
        run.err
            .starts_with("error: a.section.toml:8: not valid TOML: "),
        "{}",
        run.err
    );
}

#[test]
fn a_name_of_several_lines_is_refused() {
    let name = ("mesh = ", "name = \"a\\u001b[31m\\nb\"\nmesh = ");
    Workplace::with(&[name], &[]).is_refused(&[
        "error: a.section.toml:1: \"name\" is the text \"a\\u{1b}[31m\\nb\", expected a text of \
         one line, without control characters",
    ]);
}

/// The remainder of such an angle after whole revolutions is round-off.
#[test]
fn angles_of_many_revolutions_are_refused() {
    Workplace::with(&[("fiber_angle = 0", "fiber_angle = 1e20")], &[]).is_refused(&[
        "error: a.section.toml:19: \"fiber_angle\" is 1e20, expected an angle of at most 1000 \
         revolutions",
    ]);
}

/// At a distance of 1e9 sizes from the origin the torsional stiffness is the difference
/// of numbers 1e18 times as large.
#[test]
fn a_mesh_far_from_its_origin_is_refused() {
    let moved: Vec<_> = [
        "1 0 0 0", "2 1 0 0", "3 2 0 0", "4 0 1 0", "5 1 1 0", "6 2 1 0",
    ]
    .map(|line| {
        let [tag, y, z] = [0, 2, 4].map(|at| &line[at..=at]);
        (
            format!("\n{line}\n"),
            format!("\n{tag} 100000000{y} {z} 0\n"),
        )
    })
    .to_vec();
    let workplace = Workplace::with(&[], &[]);
    let mut mesh = workplace.read("two.msh");
    for (from, to) in moved {
        mesh = mesh.replacen(&from, &to, 1);
    }
    workplace.write("two.msh", &mesh);
    // the middle at 1000000001 mm, the size sqrt(5) mm
    workplace.is_refused(&[
        "error: a.section.toml:1: the section lies 1.000e6 m from the origin of the mesh, 4.5e8 \
         times its size, expected at most 1e5 times: torsion about the origin would have no \
         accurate digits",
        "  help: move the mesh to its origin (in gmsh, Translate): results are about the origin",
    ]);
}

/// Its stiffness would not be finite.
#[test]
fn a_section_beyond_all_structures_is_refused() {
    let workplace = Workplace::with(&[], &[]);
    let mesh = workplace.read("two.msh");
    let tiny = mesh
        .replace("2 1 0 0", "2 1e-80 0 0")
        .replace("3 2 0 0", "3 2e-80 0 0")
        .replace("4 0 1 0", "4 0 1e-80 0")
        .replace("5 1 1 0", "5 1e-80 1e-80 0")
        .replace("6 2 1 0", "6 2e-80 1e-80 0");
    workplace.write("two.msh", &tiny);
    let run = workplace.run(&["analyze", "a.section.toml"]);
    let reported = "error: a.section.toml:1: the section is 2.2";
    assert!(run.err.starts_with(reported), "{}", run.err);
    assert_eq!(run.code, 2);
}

#[test]
fn fiber_angles_of_isotropic_materials_are_a_warning() {
    let workplace = Workplace::with(&[("fiber_angle = 0", "fiber_angle = 45")], &[]);
    let run = workplace.run(&["check", "a.section.toml"]);
    let warning = "remark: region \"web\" has a fiber angle, but its material \"steel\" is \
                   isotropic: the angle does not change its stiffness";
    assert!(run.out.contains(warning), "{}", run.out);
    assert_eq!(run.code, 0);
    let run = Workplace::with(&[], &[]).run(&["check", "a.section.toml"]);
    assert!(!run.out.contains("fiber angle, but"), "{}", run.out);
}

#[test]
fn materials_without_a_name_are_reported() {
    Workplace::with(&[("[material.steel]", "[[material]]")], &[]).is_refused(&[
        "error: a.section.toml:7: \"material\" is an array of 1, expected tables [material.NAME]",
        "error: a.section.toml:14: unknown material \"steel\" in region \"skin\"",
        "  help: materials of the file: none",
        "error: a.section.toml:18: unknown material \"steel\" in region \"web\"",
        "  help: materials of the file: none",
    ]);
}

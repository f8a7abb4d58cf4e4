//! Problems of the files that a section names.

use crate::workplace::Workplace;

#[test]
fn missing_files_are_reported_where_they_are_named() {
    Workplace::with(&[("two.msh", "tow.msh")], &[]).is_refused(&[
        "error: a.section.toml:1: mesh \"tow.msh\" cannot be read: no such file",
        "  help: did you mean \"two.msh\"?",
    ]);
    // without a file of this ending, the meshes of other formats
    Workplace::with(&[("two.msh", "two.inp")], &[]).is_refused(&[
        "error: a.section.toml:1: mesh \"two.inp\" cannot be read: no such file",
        "  help: no file there ends in .inp; files there: two.msh",
    ]);
    Workplace::with(&[("two.msh", "meshes/two.msh")], &[]).is_refused(&[
        "error: a.section.toml:1: \"mesh\" is \"meshes/two.msh\", but there is no folder \"meshes\"",
        "  help: make the folder, or correct its name; names are relative to the folder of the \
         naming file",
    ]);
    Workplace::with(&[("\"two.msh\"", "\".\"")], &[])
        .is_refused(&["error: a.section.toml:1: mesh \".\" cannot be read: it is a folder"]);
    let run = Workplace::new().run(&["check", "b.section.toml"]);
    assert_eq!(
        run.err,
        "error: b.section.toml: cannot be read: no such file\n"
    );
    assert_eq!(run.code, 2);
}

#[test]
fn mesh_file_errors_carry_the_line_of_the_mesh() {
    Workplace::with(&[], &[("3 2 0 0\n", "3 2 zero 0\n")])
        .is_refused(&["error: two.msh:15: coordinate: expected a finite number, found \"zero\""]);
}

#[test]
fn surface_without_material_is_reported() {
    let region =
        "[[region]]\ngroup = \"web\"\nmaterial = \"steel\"\nfiber_angle = 0\nplane_angle = 0\n";
    Workplace::with(&[(region, "")], &[]).is_refused(&[
        "error: a.section.toml:1: physical surface \"web\" (1 cell) has no region",
        "  help: add [[region]] with group = \"web\" and its material",
    ]);
}

#[test]
fn cells_without_surface_are_counted() {
    let free = ("12 3 2 2 2 2 3 6 5", "12 3 2 0 2 2 3 6 5");
    let workplace = Workplace::with(&[], &[free]);
    workplace.is_refused(&[
        "error: a.section.toml:1: mesh \"two.msh\" has 1 cell in no physical surface (cell 12 \
         for example), expected every cell in one",
        "  help: in gmsh, put every surface of the section in a physical surface, and set \
         Mesh.SaveAll = 0 (with 1, files of version 2.2 contain no groups)",
        "error: a.section.toml:17: physical surface \"web\" has no cells in the mesh, expected \
         at least one",
    ]);
}

/// The remedy is one of the format of the mesh.
#[test]
fn cells_without_set_or_array_are_counted() {
    let nodes = "1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n";
    let abaqus = format!("*node\n{nodes}*element, type=CPS4\n1, 1, 2, 3, 4\n");
    let vtk = "# vtk DataFile Version 3.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 float\n\
        0 0 0 1 0 0 0 1 0\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n";
    for (file, content, kind, help) in [
        (
            "two.inp",
            abaqus.as_str(),
            "set of cells",
            "in Abaqus, put every element of the section in a set",
        ),
        (
            "two.vtk",
            vtk,
            "group of cells",
            "give every cell a number in an array of whole numbers by cell",
        ),
    ] {
        let workplace = Workplace::with(&[("two.msh", file)], &[]);
        workplace.write(file, content);
        let err = workplace.run(&["check", "a.section.toml"]).err;
        assert!(err.contains(&format!("has 1 cell in no {kind}")), "{err}");
        let unknown =
            format!("the mesh has no {kind} \"web\"\n  help: the mesh has no {kind}: add");
        assert!(err.contains(&unknown), "{err}");
        assert!(err.contains(&format!("  help: {help}")), "{err}");
    }
}

/// The second cell moved away by one: the parts are reported with their positions.
#[test]
fn parts_of_a_section_are_named_by_their_location() {
    let changes = [
        ("6\n1 0 0 0", "8\n7 3 0 0\n8 3 1 0\n1 0 0 0"),
        ("12 3 2 2 2 2 3 6 5", "12 3 2 2 2 3 7 8 6"),
    ];
    Workplace::with(&[], &changes).is_refused(&[
        "error: two.msh: the section falls into 2 parts that share no side, expected one",
        "    part 1: 1 cell at (0.5, 0.5), between (0, 0) and (1, 1), in \"skin\"",
        "    part 2: 1 cell at (2.5, 0.5), between (2, 0) and (3, 1), in \"web\"",
        "  help: parts must share whole sides of cells: join them, or analyze each alone",
    ]);
}

/// Node 5 pulled into the lower left of cell 12: its corner there opens beyond 180
/// degrees.
#[test]
fn inverted_cell_is_named_with_its_location_and_node() {
    Workplace::with(&[], &[("5 1 1 0", "5 1.6 0.3 0")]).is_refused(&[
        "error: two.msh: cell 12 at (1.65, 0.325) is inverted: the corner at node 5 is not \
         less than 180 degrees, or its sides cross",
        "  help: mesh this part again; in a structured mesh, check the order of the points and \
         the numbers of cells on facing curves",
    ]);
}

fn with_table(text: &str) -> Workplace {
    let table = (
        "plane_angle = 0",
        "plane_angle = { table = \"angles.csv\" }",
    );
    let workplace = Workplace::with(&[table], &[]);
    workplace.write("angles.csv", text);
    workplace
}

#[test]
fn angle_table_must_have_a_row_for_each_cell() {
    with_table("cell,angle\n").is_refused(&[
        "error: a.section.toml:20: angle table \"angles.csv\" has 0 rows, expected 1, one for \
         each cell of \"web\"; no angle for cell 12",
    ]);
    with_table("cell,angle\n11,30\n12,30\n13,3\n").is_refused(&[
        "error: a.section.toml:20: angle table \"angles.csv\" has 3 rows, expected 1, one for \
         each cell of \"web\"; unknown cells 11, 13",
    ]);
    with_table("cell,angle\n7,30\n").is_refused(&[
        "error: a.section.toml:20: angle table \"angles.csv\" has 1 row, expected 1, one for \
         each cell of \"web\"; no angle for cell 12; unknown cell 7",
    ]);
    assert_eq!(
        with_table("cell,angle\n12,30\n")
            .run(&["check", "a.section.toml"])
            .code,
        0
    );
}

#[test]
fn table_for_two_regions_must_have_the_cells_of_both() {
    let table = "plane_angle = { table = \"angles.csv\" }";
    let changes = [
        ("group = \"skin\"", &*format!("{table}\ngroup = \"skin\"")),
        ("plane_angle = 0", table),
    ];
    let workplace = Workplace::with(&changes, &[]);
    workplace.write("angles.csv", "cell,angle\n12,30\n");
    workplace.is_refused(&[
        "error: a.section.toml:13: angle table \"angles.csv\" has 1 row, expected 2, one for \
         each cell of \"skin\", \"web\"; no angle for cell 11",
    ]);
    workplace.write("angles.csv", "cell,angle\n12,30\n11,0\n");
    assert_eq!(workplace.run(&["check", "a.section.toml"]).code, 0);
}

#[test]
fn unreadable_rows_are_reported_with_the_line_of_the_table() {
    with_table("cell;angle\n12;x\n").is_refused(&[
        "error: angles.csv:1: the columns are \"cell;angle\", expected \"cell,angle\"",
        "error: angles.csv:2: row \"12;x\" cannot be read, expected two columns, the number of \
         a cell and its angle",
    ]);
    with_table("cell,angle\n12,3 deg\n12.5,3\n").is_refused(&[
        "error: angles.csv:2: row \"12,3 deg\" cannot be read, expected an angle in the second \
         column",
        "error: angles.csv:3: row \"12.5,3\" cannot be read, expected the number of a cell in \
         the first column",
    ]);
}

#[test]
fn a_file_of_the_other_program_is_recognized() {
    let workplace = Workplace::new();
    workplace.write(
        "a.dynamics.toml",
        "units = \"SI\"\n[[blade]]\nname = \"b\"\n",
    );
    for command in ["check", "analyze"] {
        let run = workplace.run(&[command, "a.dynamics.toml"]);
        assert_eq!(
            run.err,
            "error: a.dynamics.toml: this is a dynamics file, expected a section file\n  help: \
             use \"beam-dynamics\"\n"
        );
        assert_eq!(run.code, 2);
    }
}

#[test]
fn a_blade_file_is_recognized() {
    let workplace = Workplace::new();
    workplace.write("nrel.blade.toml", "units = \"SI\"\n[[station]]\n");
    let run = workplace.run(&["check", "nrel.blade.toml"]);
    assert_eq!(
        run.err,
        "error: nrel.blade.toml: this is a blade file, expected a section file\n  help: use \
         \"beam-dynamics\", or \"section-analyzer mesh blade\" for the shape of a section\n"
    );
    assert_eq!(run.code, 2);
}

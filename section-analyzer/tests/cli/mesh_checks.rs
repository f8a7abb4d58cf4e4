//! Messages about meshes whose cells overlap, touch without being joined, or have a poor
//! shape; and the figures of a check.

use super::workplace::Workplace;

/// The mesh of the workplace; at `seam` "web" has its own nodes, 7 and 8, on its common
/// side with "skin".
fn unjoined(seam: &str) -> Workplace {
    let nodes = ("6\n1 0 0 0", "8\n1 0 0 0");
    let own = (
        "6 2 1 0\n",
        &*format!("6 2 1 0\n7 {seam} 0 0\n8 {seam} 1 0\n"),
    );
    let cell = ("2 2 2 3 6 5", "2 2 7 3 6 8");
    Workplace::with(&[], &[nodes, own, cell])
}

#[test]
fn doubled_nodes_come_with_positions_and_remedy() {
    unjoined("1").is_refused(&[
        "error: two.msh: \"skin\" and \"web\" touch along 1 side between (1, 0) and (1, 1) but \
         share no nodes there: 2 nodes are doubled, as 2 and 7 at (1, 0), 5 and 8 at (1, 1); so \
         the section falls into 2 parts",
        "  help: let the surfaces share their common curve and mesh again: in gmsh \"Coherence;\" \
         (built-in geometry) or BooleanFragments (OpenCASCADE) before meshing, with a larger \
         Geometry.Tolerance if points nearly meet; or, if a slit is intended, write doubled_nodes \
         = \"allow\" at the head of the section file",
    ]);
}

#[test]
fn a_gap_that_takes_the_section_apart_is_reported_with_its_width() {
    unjoined("1.001").is_refused(&[
        "error: two.msh: the section falls into 2 parts that share no side, expected one",
        "    part 1: 1 cell at (0.5, 0.5), between (0, 0) and (1, 1), in \"skin\"",
        "    part 2: 1 cell at (1.5005, 0.5), between (1.001, 0) and (2, 1), in \"web\"",
        "    \"skin\" and \"web\" run within 0.001 of each other along 1 side between (1, 0.25) \
         and (1.001, 0.75) without touching: they are not connected across this gap",
        "  help: close the gap: move the points of one side onto the other, or in gmsh raise \
         Geometry.Tolerance before \"Coherence;\" or BooleanFragments",
    ]);
}

#[test]
fn an_overlap_is_reported_with_cells_and_location() {
    unjoined("0.9").is_refused(&[
        "error: two.msh: cells of \"skin\" overlap cells of \"web\": 11 and 12 at (1, 0.5); the \
         area there would be counted twice",
        "  help: a surface meshed twice, or surfaces that reach into each other: in gmsh, \
         \"Coherence;\" (built-in geometry) or BooleanFragments (OpenCASCADE) before meshing, \
         and delete copies",
    ]);
}

/// A ring of four squares around a hole, "skin" above and "web" below. They share nodes
/// on the left; on the right 9 coincides with 1, and 10 with 2.
///
/// ```text
///             4
///             3
///     6   5       1   2
///                 9   10
///             7
///             8
/// ```
const RING: &str = "\
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
2 1 \"skin\"
2 2 \"web\"
$EndPhysicalNames
$Nodes
10
1 1 0 0
2 2 0 0
3 0 1 0
4 0 2 0
5 -1 0 0
6 -2 0 0
7 0 -1 0
8 0 -2 0
9 1 0 0
10 2 0 0
$EndNodes
$Elements
4
1 3 2 1 1 1 2 4 3
2 3 2 1 1 3 4 6 5
3 3 2 2 2 5 6 8 7
4 3 2 2 2 7 8 10 9
$EndElements
";

#[test]
fn a_slit_between_regions_is_allowed_in_the_section_file() {
    let workplace = Workplace::with(&[], &[]);
    workplace.write("two.msh", RING);
    let run = workplace.run(&["check", "a.section.toml"]);
    assert_eq!(run.code, 2);
    let first = run.err.lines().next().unwrap();
    assert_eq!(
        first,
        "error: two.msh: \"skin\" and \"web\" touch along 1 side between (1, 0) and (2, 0) but \
         share no nodes there: 2 nodes are doubled, as 1 and 9 at (1, 0), 2 and 10 at (2, 0)"
    );

    let section = workplace.read("a.section.toml");
    workplace.write(
        "a.section.toml",
        &format!("doubled_nodes = \"allow\"\n{section}"),
    );
    let run = workplace.run(&["check", "a.section.toml"]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(
        run.out.contains(
            "remark: slit: \"skin\" and \"web\" touch along 1 side between (1, 0) and (2, 0) \
             but share no nodes there"
        ),
        "{}",
        run.out
    );

    workplace.write(
        "a.section.toml",
        &format!("doubled_nodes = \"alow\"\n{section}"),
    );
    workplace.is_refused(&[
        "error: a.section.toml:1: \"doubled_nodes\" is \"alow\", expected one of \"error\", \
         \"allow\"",
        "  help: did you mean \"allow\"?",
    ]);
}

#[test]
fn poor_cells_are_a_warning_with_positions() {
    // "web" is 3000 long: a strip next to a square
    let long = [("3 2 0 0", "3 3001 0 0"), ("6 2 1 0", "6 3001 1 0")];
    let workplace = Workplace::with(&[], &long);
    let run = workplace.run(&["check", "a.section.toml"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let warning = "Remarks\n  remark: 1 cell has a poor shape: results nearby are less \
                   accurate\n      cell 12 at (1501, 0.5) in \"web\": aspect ratio 3000.0, poor \
                   above 1000\n\n";
    assert!(run.out.contains(warning), "{}", run.out);
    let table = "\
Cell quality by region, the worst value (and the mean)
  region       Jacobian           aspect  corners from   corners to  poor cells
  skin    1.000 (1.000)        1.0 (1.0)   90.0 (90.0)  90.0 (90.0)      0 of 1
  web     1.000 (1.000)  3000.0 (3000.0)   90.0 (90.0)  90.0 (90.0)      1 of 1
";
    assert!(run.out.contains(table), "{}", run.out);
    // the square next to the strip is good, and not one of the worst
    let worst = "Worst cells, at their centers in the unit of the mesh\n  \
                 cell  region  y [mm]  z [mm]\n  \
                 12    web       1501     0.5  aspect ratio 3000.0, poor above 1000\n\n";
    assert!(run.out.contains(worst), "{}", run.out);
    let run = Workplace::with(&[], &[]).run(&["check", "a.section.toml"]);
    let good = "\n\nAll cells are good by every measure\n";
    assert!(run.out.contains(good), "{}", run.out);
    let run = workplace.run(&["analyze", "a.section.toml"]);
    let words = "Cell quality\n  aspect ratios up to 3000.0, corners of 90.0 to 90.0 deg,\n  least \
                 over largest Jacobian 1.00 or more: 1 cell is poor\n";
    assert!(run.out.contains(words), "{}", run.out);
}

#[test]
fn check_draws_only_when_requested_and_fibers_only_where_there_are_some() {
    let ply = "e1 = 140\ne2 = 10\ne3 = 10\ng12 = 5\ng13 = 5\ng23 = 4\nnu12 = 0.3\nnu13 = 0.3\n\
               nu23 = 0.4\n";
    let plain = Workplace::with(&[], &[]);
    let wound = Workplace::with(&[("young = 210\npoisson = 0.3\n", ply)], &[]);
    for (workplace, has_fibers) in [(plain, false), (wound, true)] {
        assert_eq!(workplace.run(&["check", "a.section.toml"]).code, 0);
        assert!(!workplace.path("results").exists());
        let run = workplace.run(&["check", "a.section.toml", "--out", "figures"]);
        assert_eq!(run.code, 0, "{}", run.err);
        let is_there = |file: &str| workplace.path(file).exists();
        assert!(is_there("figures/a.mesh.png"));
        assert_eq!(is_there("figures/a.fibers.png"), has_fibers);
        assert_eq!(run.out.contains("figures/a.fibers.png"), has_fibers);
        let run = workplace.run(&["analyze", "a.section.toml"]);
        assert_eq!(run.code, 0, "{}", run.err);
        assert_eq!(is_there("results/a.fibers.png"), has_fibers);
        assert_eq!(run.out.contains("a.fibers.png"), has_fibers);
    }
}

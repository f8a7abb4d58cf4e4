//! Angles that follow a curve: a wound tube.

use std::f64::consts::TAU;
use std::fmt::Write;
use std::path::Path;

use section_analyzer::analysis::analyze;
use section_analyzer::input;
use section_analyzer::mesh::generate::Tube;
use shared_geom::gmsh;
use shared_geom::mesh::{CellKind, Mesh};

const CELLS_AROUND: usize = 24;

/// A wall of an orthotropic ply wound at 30 degrees.
fn section(plane_angle: &str) -> String {
    format!(
        "mesh = \"tube.msh\"\n\
         units = \"SI\"\n\
         [material.carbon]\n\
         e1 = 142e9\ne2 = 9.8e9\ne3 = 10.4e9\n\
         g12 = 6e9\ng13 = 5.5e9\ng23 = 4.8e9\n\
         nu12 = 0.3\nnu13 = 0.32\nnu23 = 0.42\n\
         density = 1550\n\
         [[region]]\n\
         group = \"wall\"\n\
         material = \"carbon\"\n\
         fiber_angle = 30\n\
         plane_angle = {plane_angle}\n"
    )
}

/// The angle of the wall at the middle of each cell's sector, in degrees, as a table. The
/// boundaries run clockwise: the wall direction at the polar angle phi is phi - 90 deg.
fn table(mesh: &Mesh, turn: f64) -> String {
    let mut text = "cell,angle\n".to_owned();
    for cell in &mesh.cells {
        let corners = cell
            .corners()
            .iter()
            .map(|&node| mesh.nodes[node as usize].position);
        let (y, z) = corners.fold((0.0, 0.0), |(y, z), p| (y + p.x, z + p.y));
        // the nearest middle of a sector: an odd multiple of half its angle
        let half = 0.5 * TAU / CELLS_AROUND as f64;
        let polar = (2.0 * ((z.atan2(y) / half - 1.0) / 2.0).round() + 1.0) * half;
        writeln!(text, "{},{:?}", cell.tag, polar.to_degrees() - 90.0 + turn).unwrap();
    }
    text
}

fn stiffness(folder: &Path, plane_angle: &str) -> nalgebra::Matrix6<f64> {
    let file = folder.join("tube.section.toml");
    std::fs::write(&file, section(plane_angle)).unwrap();
    let input = input::read(&file).unwrap_or_else(|problems| panic!("{problems}"));
    analyze(&input.section).unwrap().stiffness
}

/// `follow` equals the table to 1e-12 of sqrt(Kii Kjj): both angles are exact up to
/// round-off (1e-15), to which the stiffness is not sensitive beyond its condition.
fn is_same(kind: CellKind, curved: bool) {
    let tube = Tube {
        outer_radius: 0.05,
        thickness: 0.008,
        cells_around: CELLS_AROUND,
        cells_through: 2,
        kind,
        curved,
    };
    let mesh = tube.generate().unwrap();
    let folder = tempfile::tempdir().unwrap();
    let write = |file: &str, text: String| std::fs::write(folder.path().join(file), text).unwrap();
    write("tube.msh", gmsh::write(&mesh));
    write("angles.csv", table(&mesh, 0.0));
    write("reverse.csv", table(&mesh, 180.0));

    let by_table = stiffness(folder.path(), "{ table = \"angles.csv\" }");
    let reverse = stiffness(folder.path(), "{ table = \"reverse.csv\" }");
    for (angle, expected) in [
        ("{ follow = \"outer\" }", by_table),
        ("{ follow = \"inner\" }", by_table),
        ("{ follow = \"outer\", reverse = true }", reverse),
    ] {
        let found = stiffness(folder.path(), angle);
        for i in 0..6 {
            for j in 0..6 {
                let scale = (expected[(i, i)] * expected[(j, j)]).sqrt();
                let error = (found[(i, j)] - expected[(i, j)]).abs() / scale;
                assert!(
                    error < 1e-12,
                    "{kind:?} {curved} {angle} ({i}, {j}): {error:e}"
                );
            }
        }
    }
    // A wound tube couples extension and torsion, strongly and with the sign of its
    // direction: otherwise the comparison would not be significant.
    let coupling = by_table[(0, 3)] / (by_table[(0, 0)] * by_table[(3, 3)]).sqrt();
    assert!(coupling.abs() > 0.3, "{coupling}");
    assert!((reverse[(0, 3)] / by_table[(0, 3)] + 1.0).abs() < 1e-9);
}

#[test]
fn wound_tube_with_curved_sides_follows_its_boundaries() {
    is_same(CellKind::Quadrilateral9, true);
    is_same(CellKind::Quadrilateral8, true);
}

#[test]
fn wound_tube_with_straight_sides_follows_its_boundaries() {
    is_same(CellKind::Quadrilateral9, false);
    is_same(CellKind::Quadrilateral4, false);
}

/// In meters or millimeters the angles are the same.
#[test]
fn angles_do_not_depend_on_the_unit_of_length() {
    let tube = Tube {
        outer_radius: 0.05,
        thickness: 0.008,
        cells_around: CELLS_AROUND,
        cells_through: 1,
        kind: CellKind::Triangle6,
        curved: true,
    };
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("tube.section.toml");
    std::fs::write(
        folder.path().join("tube.msh"),
        gmsh::write(&tube.generate().unwrap()),
    )
    .unwrap();
    let angles = |units: &str| {
        let text = section("{ follow = \"outer\" }").replace("units = \"SI\"\n", "");
        std::fs::write(&file, text + units).unwrap();
        input::read(&file).unwrap().section.cells
    };
    let (meters, inches) = (
        angles("[units]\nlength = \"m\"\n"),
        angles("[units]\nlength = \"in\"\n"),
    );
    for (a, b) in meters.iter().zip(&inches) {
        assert!((a.plane_angle - b.plane_angle).abs() < 1e-13);
    }
}

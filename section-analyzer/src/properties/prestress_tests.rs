use super::*;
use crate::analysis::analyze;
use crate::section::samples::coupled_rectangle;
use shared_geom::mesh::CellKind;

fn of(section: &Section, measure: StrainMeasure) -> CubicTable {
    let solution = analyze(section).expect("sound");
    prestress(section, &solution, measure)
        .expect("straight")
        .third
}

/// Largest difference of two tables, entries made comparable by the stiffness: beside
/// `sqrt(K_ii K_jj K_kk / K_11)`.
fn difference(section: &Section, a: &CubicTable, b: &CubicTable) -> f64 {
    let k = analyze(section).expect("sound").stiffness;
    let root = |i: usize| k[(PRESTRESS_COMPONENTS[i], PRESTRESS_COMPONENTS[i])].sqrt();
    let relative = |([i, j, l], value): ([usize; 3], f64)| {
        (value - b.at([i, j, l])).abs() * root(0) / (root(i) * root(j) * root(l))
    };
    a.entries().map(relative).fold(0.0, f64::max)
}

/// A section of no symmetry, with shear strains in all its states, moved: the table of
/// the moved mesh is the moved table, to the digits that the moved analysis has.
#[test]
fn the_table_moves_with_the_mesh() {
    let section = coupled_rectangle(CellKind::Quadrilateral9);
    for measure in StrainMeasure::ALL {
        let table = of(&section, measure);
        let by = [1.7, -0.9];
        let mut moved = section.clone();
        for node in &mut moved.mesh.nodes {
            *node = [node[0] + by[0], node[1] + by[1]];
        }
        // the mesh moves by +d: its reference point is where -d was
        let expected = table.shifted(-Vector2::from(by));
        assert!(difference(&moved, &expected, &table) > 1e-2);
        let error = difference(&moved, &expected, &of(&moved, measure));
        assert!(error < 1e-12, "{measure:?} {error:e}");
    }
}

/// The same in axes turned by 40 degrees.
#[test]
fn the_table_turns_with_the_axes() {
    let section = coupled_rectangle(CellKind::Quadrilateral9);
    let angle = 40.0_f64.to_radians();
    let (s, c) = angle.sin_cos();
    let mut turned = section.clone();
    for node in &mut turned.mesh.nodes {
        *node = [c * node[0] + s * node[1], c * node[1] - s * node[0]];
    }
    for made_of in &mut turned.cells {
        made_of.plane_angle -= angle;
    }
    for measure in StrainMeasure::ALL {
        let expected = of(&section, measure).rotated(angle);
        assert!(difference(&turned, &expected, &of(&section, measure)) > 1e-2);
        let error = difference(&turned, &expected, &of(&turned, measure));
        assert!(error < 1e-12, "{measure:?} {error:e}");
    }
}

/// A mesh far from its origin loses no more digits than its stiffness does.
#[test]
fn far_from_the_origin_the_digits_are_kept() {
    let section = coupled_rectangle(CellKind::Quadrilateral8);
    let mut far = section.clone();
    for node in &mut far.mesh.nodes {
        *node = [node[0] + 1e2, node[1] - 2e2];
    }
    let solution = analyze(&far).expect("sound");
    let found = Fields::new(&far, &solution).expect("sound");
    let here = Fields::new(&section, &analyze(&section).expect("sound")).expect("sound");
    let tables = [found, here].map(|fields| fields.table(StrainMeasure::Green));
    let error = difference(&section, &tables[0], &tables[1]);
    // the forces of each state about the origin cancel by the square of the distance, 1e5
    assert!(error < 1e-9, "{error:e}");
}

#[test]
fn curved_beams_have_no_table() {
    let mut section = coupled_rectangle(CellKind::Triangle6);
    let solution = analyze(&section).expect("sound");
    section.initial_curvature.curvature.x = 0.1;
    let found = prestress(&section, &solution, StrainMeasure::Biot);
    assert_eq!(found, Err(NoPrestress::Curved));
    assert!(
        NoPrestress::Curved
            .to_string()
            .contains("initial curvature")
    );
}

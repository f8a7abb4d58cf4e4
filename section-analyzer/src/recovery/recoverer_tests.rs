use super::*;
use crate::analysis::analyze;
use crate::section::samples::{Random, coupled_rectangle};
use shared_geom::mesh::CellKind;

fn load(force: [f64; 6]) -> LoadCase {
    LoadCase {
        name: "load".into(),
        force: Vector6::from(force),
        imposed: Vec::new(),
        voltages: Vec::new(),
    }
}

const ALL_SIX: [f64; 6] = [1.0, -0.7, 0.4, 0.3, -0.2, 0.5];

/// The stresses of a section without any symmetry add up to the load: round-off of
/// sums over some hundred points, for every kind of cell.
#[test]
fn resultants_are_the_load() {
    for kind in CellKind::ALL {
        let section = coupled_rectangle(kind);
        let solution = analyze(&section).unwrap();
        let recovery = recover(&section, &solution, &load(ALL_SIX)).unwrap();
        assert!(recovery.resultant_error < 1e-12, "{kind:?}");
        let difference = (recovery.resultant - Vector6::from(ALL_SIX)).amax();
        assert!(difference < 1e-12, "{kind:?} {difference:e}");
    }
}

/// Many forces at once: the stresses of each force equal the stresses of a single recovery, point
/// by point, with more points than one block contains.
#[test]
fn stresses_of_many_forces_are_those_of_each() {
    let section = coupled_rectangle(CellKind::Quadrilateral9);
    let solution = analyze(&section).unwrap();
    let recoverer = Recoverer::new(&section, &solution);
    let forces = nalgebra::Matrix6xX::from_fn(7, |i, k| ((5 * i + 3 * k) % 11) as f64 - 4.0);
    let of_each = forces.column_iter().map(|force| {
        let load = load(force.into_owned().into());
        recoverer.recover(&load).unwrap().points
    });
    let of_each: Vec<_> = of_each.collect();
    let mut seen = 0;
    recoverer.each_stress(&forces, |block| {
        assert_eq!(block.points().start, seen);
        for (row, point) in block.points().enumerate() {
            for (k, points) in of_each.iter().enumerate() {
                let found = block.stress().fixed_view::<6, 1>(6 * row, k).into_owned();
                let difference = (found - points[point].tensors.stress).amax();
                assert!(difference < 1e-12, "{difference:e}");
            }
        }
        seen = block.points().end;
    });
    assert_eq!(seen, of_each[0].len());
    assert!(seen > 0);
}

/// 200 random forces: the sums of the six stresses of each cell are the means of single
/// recoveries, to the round-off of sums that may cancel.
#[test]
fn stresses_of_cells_add_up_to_single_recoveries() {
    let section = coupled_rectangle(CellKind::Quadrilateral8);
    let solution = analyze(&section).unwrap();
    let recoverer = Recoverer::new(&section, &solution);
    let unit = recoverer.unit_cell_stresses();
    assert_eq!(unit.len(), section.cells.len());
    let mut random = Random(8);
    for _ in 0..200 {
        let load = load(std::array::from_fn(|_| random.next()));
        let recovery = recoverer.recover(&load).unwrap();
        for (columns, cell) in unit.iter().zip(&recovery.cells) {
            let difference = columns * load.force - cell.tensors.material_stress;
            assert!(difference.amax() < 1e-11 * recovery.stress_scale);
        }
    }
}

/// A section moved by 100 times its size, under the same force at the same point of the
/// section, has the same stresses: three digits of the sixteen are lost by the coordinates,
/// and another two by the force about the reference point.
#[test]
fn stresses_do_not_depend_on_the_position_of_the_reference_point() {
    let section = coupled_rectangle(CellKind::Quadrilateral9);
    let mut moved = section.clone();
    let by = [150.0, -70.0];
    for [y, z] in &mut moved.mesh.nodes {
        (*y, *z) = (*y + by[0], *z + by[1]);
    }
    let here = recover(&section, &analyze(&section).unwrap(), &load(ALL_SIX)).unwrap();
    let there = LoadCase::at_point("load", &Vector6::from(ALL_SIX), by);
    let there = recover(&moved, &analyze(&moved).unwrap(), &there).unwrap();
    let scale = here.points.iter().map(|p| p.tensors.stress.amax());
    let scale = scale.fold(0.0, f64::max);
    for (a, b) in here.points.iter().zip(&there.points) {
        let difference = (a.tensors.stress - b.tensors.stress).amax();
        assert!(difference < 1e-10 * scale, "{difference:e}");
    }
}

/// Stress in material axes is the law of the material applied to the strain in these axes:
/// the rotations of the law and of the tensors are independent code.
#[test]
fn law_holds_in_material_axes() {
    let section = coupled_rectangle(CellKind::Triangle6);
    let solution = analyze(&section).unwrap();
    let recovery = recover(&section, &solution, &load(ALL_SIX)).unwrap();
    let law = section.materials[0].law.stiffness();
    for point in &recovery.points {
        let Tensors {
            material_strain,
            material_stress,
            ..
        } = point.tensors;
        let difference = (law * material_strain - material_stress).amax();
        assert!(difference < 1e-12 * material_stress.amax());
    }
}

/// `at` an integration point is the state of that point.
#[test]
fn any_position_can_be_requested() {
    let section = coupled_rectangle(CellKind::Quadrilateral8);
    let solution = analyze(&section).unwrap();
    let recoverer = Recoverer::new(&section, &solution);
    let load = load(ALL_SIX);
    for point in &recoverer.recover(&load).unwrap().points {
        let (cell, tensors) = recoverer.at(&load, point.position).unwrap();
        assert_eq!(cell, point.cell);
        let difference = (tensors.stress - point.tensors.stress).amax();
        assert!(difference < 1e-10 * point.tensors.stress.amax());
    }
    assert_eq!(recoverer.at(&load, [10.0, 10.0]), None);
}

/// Each region has the nodes of its own cells, in order; the indices of the cells refer to
/// them.
#[test]
fn nodes_are_listed_by_region() {
    let mut section = coupled_rectangle(CellKind::Triangle3);
    section.mesh.groups = vec!["left".into(), "right".into()];
    let half = section.mesh.cells.len() / 2;
    for cell in &mut section.mesh.cells[half..] {
        cell.group = 1;
    }
    let solution = analyze(&section).unwrap();
    let recovery = recover(&section, &solution, &load(ALL_SIX)).unwrap();
    let order: Vec<_> = recovery.nodes.iter().map(|n| (n.group, n.node)).collect();
    assert!(order.is_sorted() && order.len() > section.mesh.nodes.len());
    for (cell, nodes) in section.mesh.cells.iter().zip(&recovery.cell_nodes) {
        for (&node, &state) in cell.nodes().iter().zip(nodes) {
            let state = &recovery.nodes[state as usize];
            assert_eq!((state.node, state.group), (node as usize, cell.group));
        }
    }
}

/// The solution of another section has a wrong resultant, and is refused.
#[test]
fn stresses_that_do_not_add_up_are_refused() {
    let section = coupled_rectangle(CellKind::Quadrilateral4);
    let mut solution = analyze(&section).unwrap();
    solution.strain *= 1.0 + 1e-4;
    let failure = recover(&section, &solution, &load(ALL_SIX)).unwrap_err();
    assert!(matches!(failure, Failure::Resultant { error, .. } if error > 1e-5));
}

/// Von Mises stress: tension 3 gives 3, shear 1 gives sqrt 3, pressure nothing.
#[test]
fn von_mises_stress_of_simple_states() {
    let of = |stress: [f64; 6]| {
        let stress = Vector6::from(stress);
        Tensors {
            stress,
            ..Tensors::default()
        }
        .von_mises()
    };
    assert_eq!(of([3.0, 0.0, 0.0, 0.0, 0.0, 0.0]), 3.0);
    assert!((of([0.0, 0.0, 0.0, 0.0, 1.0, 0.0]) - 3f64.sqrt()).abs() < 1e-15);
    assert_eq!(of([-5.0, -5.0, -5.0, 0.0, 0.0, 0.0]), 0.0);
}

use super::*;
use crate::analysis::central::solve_central;
use crate::assembly::{DomainElectrode, Model, Pattern, SectionMatrices, add_rigid_motions};
use crate::material::ElectricLaw;
use crate::mesh::SectionMesh;
use crate::mesh::generate::Rectangle;
use crate::section::samples::{Random, coupled_rectangle};
use crate::section::{Circuit, Electrode, FingeredCell, Section};
use crate::solve::{CentralSolution, Decoupled, Pins};
use nalgebra::{Matrix3, Matrix3x6};
use shared_geom::error::SourceLocation;
use shared_geom::mesh::CellKind;
use shared_geom::section::InitialCurvature;

/// A section off its axes without any symmetry: a part of it a dielectric of piezoelectric
/// material in all directions with three conductors, one cell of the rest between fingers;
/// straight and curved.
fn sections() -> [Section; 2] {
    let mut straight = coupled_rectangle(CellKind::Quadrilateral9);
    let mut random = Random(5);
    let half = Matrix3::from_fn(|_, _| random.next());
    let mut poled = straight.materials[0].clone();
    poled.electric = Some(ElectricLaw {
        coupling: Matrix3x6::from_fn(|_, _| random.next()),
        permittivity: half * half.transpose() + Matrix3::identity(),
    });
    straight.materials.push(poled);
    // cells are row by row, three in a row
    let columns: Vec<usize> = (0..6).map(|cell| cell % 3).collect();
    for (made_of, column) in straight.cells.iter_mut().zip(&columns) {
        made_of.material = usize::from(*column < 2);
    }
    straight.cells[5].material = 1;
    let nodes_of = |cell: usize, local: &[usize]| -> Vec<u32> {
        let nodes = straight.mesh.cells[cell].nodes();
        local.iter().map(|&i| nodes[i]).collect()
    };
    let conductor = |name: &str, nodes: Vec<u32>, circuit: Circuit| Electrode {
        name: name.into(),
        circuit,
        shape: ElectrodeShape::Conductor { nodes },
    };
    straight.electrodes = vec![
        conductor("bottom", nodes_of(0, &[0, 1, 4]), Circuit::Ground),
        conductor("top", nodes_of(3, &[2, 3, 6]), Circuit::Driven),
        Electrode {
            name: "fingers".into(),
            circuit: Circuit::Driven,
            shape: ElectrodeShape::Interdigitated {
                cells: vec![FingeredCell {
                    cell: 5,
                    field: Vector3::new(2.0, -0.3, 0.7),
                }],
            },
        },
        // without the node that it shares with the bottom
        conductor("side", nodes_of(1, &[1]), Circuit::Driven),
    ];
    let mut curved = straight.clone();
    curved.initial_curvature = InitialCurvature {
        curvature: Vector3::new(0.2, -0.15, 0.1),
        slope: Vector3::new(0.95, 0.1, -0.05),
    };
    [straight, curved]
}

/// Domain, pattern and held unknowns of a section.
fn prepared(section: &Section) -> (Domain, Pattern) {
    let domain = Domain::new(section).expect("sound");
    let pattern = Pattern::new(&domain);
    (domain, pattern)
}

fn central(domain: &Domain, pattern: &Pattern) -> (Central, CentralSystems) {
    let matrices = SectionMatrices::assemble(domain, pattern).expect("sound");
    let naming = |_| super::super::Named {
        tag: 0,
        position: [0.0; 2],
    };
    solve_central(domain, pattern, matrices, &naming, OF_CELLS).expect("sound")
}

/// The decoupled free strains do not depend on the pins, to round-off times a condition of
/// about 1e4; before decoupling they do.
#[test]
fn free_strains_do_not_depend_on_the_pins() {
    for section in sections() {
        let (domain, pattern) = prepared(&section);
        let (own, systems) = central(&domain, &pattern);
        let expected = Voltages::solve(&domain, &systems, &own)
            .expect("sound")
            .expect("some");
        let scale = expected.y.iter().map(|y| y.amax()).fold(0.0, largest);
        let last = domain.nodes.len() - 1;
        for triple in [[0, last / 2, last], [3, 11, last - 4], [last, 7, 1]] {
            let pins = Pins::at(&domain.nodes, triple).with(domain.held());
            let matrices = SectionMatrices::assemble(&domain, &pattern).expect("sound");
            let systems = CentralSystems::new(&domain, &pattern, matrices, pins).expect("sound");
            let found = CentralSolution::solve(&domain, &systems).expect("memory");
            let other = Central {
                compliance: found.work,
                decoupled: Decoupled::new(&domain, found),
                checks: own.checks,
            };
            let difference = (other.compliance - own.compliance).amax();
            assert!(difference < 1e-11 * own.compliance.amax(), "{difference:e}");
            let found = Voltages::solve(&domain, &systems, &other)
                .expect("sound")
                .expect("some");
            for (found, expected) in found.y.iter().zip(&expected.y) {
                let difference = (found - expected).amax();
                assert!(difference < 1e-10 * scale, "{triple:?}: {difference:e}");
            }
            let difference = (&found.charges - &expected.charges).amax();
            assert!(
                difference < 1e-11 * expected.charges.amax(),
                "{difference:e}"
            );
        }
    }
}

/// Charges per unit internal force on the conductors of a section, with the rates along the
/// beam: the imbalance of the electric displacements of the central solutions.
fn charges_of_forces(domain: &Domain, central: &Central) -> Vec<Option<Vector6<f64>>> {
    let solution = &central.decoupled;
    let state = State {
        rate: Rate::Central,
        warping: Some(&solution.x),
        strain: &solution.y,
    };
    let forces = section_forces(domain, state);
    let unbalanced = &forces.within - &forces.face * domain.line.equilibrium();
    let of_electrode = |electrode: &DomainElectrode| {
        let unknown = |&node: &u32| domain.potential_unknown(node as usize).expect("dielectric");
        let rows = electrode.nodes.iter().map(unknown);
        let charge: Vector6<f64> = rows
            .map(|row| -unbalanced.fixed_view::<1, 6>(row, 0).transpose())
            .sum();
        (!electrode.nodes.is_empty()).then_some(charge)
    };
    domain
        .electric
        .electrodes
        .iter()
        .map(of_electrode)
        .collect()
}

/// Real charges of the central solutions against the free strains: the full reciprocity of
/// the theory, `Y_v = q_F' + T (X' P - Ph_V' X_v)`.
#[test]
fn charges_of_forces_are_strains_of_voltages() {
    for section in sections() {
        let (domain, pattern) = prepared(&section);
        let (central, systems) = central(&domain, &pattern);
        let voltages = Voltages::solve(&domain, &systems, &central).expect("sound");
        let voltages = voltages.expect("some");
        let solution = &central.decoupled;
        let along = domain.line.equilibrium();
        let scale = voltages.y.iter().map(|y| y.amax()).fold(0.0, largest);
        let x = &voltages.x[0];
        let of_voltage = State {
            rate: Rate::Zero,
            warping: Some(x),
            strain: &Matrix6::from_fn(|i, k| voltages.y.get(k).map_or(0.0, |y| y[i])),
        };
        let face = section_forces(&domain, of_voltage).face;
        let product = solution.x.tr_mul(&face);
        let on_charges = electric_work(&domain, &solution.face, x);
        let charges = charges_of_forces(&domain, &central);
        for (number, charge) in charges.into_iter().enumerate() {
            let Some(charge) = charge else { continue };
            let on_face: Vector6<f64> =
                product.fixed_view::<6, 1>(0, number).into_owned() - on_charges.column(number);
            let expected = charge + along.transpose() * on_face;
            let difference = (voltages.y[number] - expected).amax();
            assert!(
                difference < 1e-11 * scale,
                "{number}: {difference:e} of {scale:e}"
            );
            // the end terms are needed: real charges alone do not agree
            assert!((voltages.y[number] - charge).amax() > 1e-4 * scale);
        }
    }
}

/// In a symmetric section the charges of all six forces are the free strains: round-off.
#[test]
fn ends_take_no_part_in_symmetric_sections() {
    let mut section = coupled_rectangle(CellKind::Quadrilateral9);
    let mesh = Rectangle {
        width: 2.0,
        height: 1.0,
        cells_y: 3,
        cells_z: 2,
        kind: CellKind::Quadrilateral9,
        name: "layer".into(),
    };
    let mesh = SectionMesh::from_mesh(
        &mesh.generate().expect("sound"),
        1.0,
        &SourceLocation::file("test"),
    );
    section.mesh = mesh.expect("sound").0;
    for made_of in &mut section.cells {
        (made_of.fiber_angle, made_of.plane_angle) = (0.0, 0.0);
    }
    let mut coupling = Matrix3x6::zeros();
    (coupling[(2, 0)], coupling[(2, 1)], coupling[(2, 2)]) = (-0.4, -0.3, 1.1);
    (coupling[(1, 3)], coupling[(0, 4)]) = (0.7, 0.6);
    section.materials[0].electric = Some(ElectricLaw {
        coupling,
        permittivity: Matrix3::from_diagonal(&Vector3::new(1.0, 1.1, 0.9)),
    });
    let face = |z: f64| {
        let nodes = 0..section.mesh.nodes.len() as u32;
        let there = nodes.filter(|&n| (section.mesh.nodes[n as usize][1] - z).abs() < 1e-9);
        ElectrodeShape::Conductor {
            nodes: there.collect(),
        }
    };
    section.electrodes = [("bottom", -0.5), ("top", 0.5)]
        .map(|(name, z)| Electrode {
            name: name.into(),
            circuit: Circuit::Driven,
            shape: face(z),
        })
        .to_vec();
    let (domain, pattern) = prepared(&section);
    let (central, systems) = central(&domain, &pattern);
    let voltages = Voltages::solve(&domain, &systems, &central).expect("sound");
    let voltages = voltages.expect("some");
    let charges = charges_of_forces(&domain, &central);
    for (strain, charge) in voltages.y.iter().zip(charges) {
        let difference = (strain - charge.expect("a conductor")).amax();
        assert!(difference < 1e-13 * strain.amax(), "{difference:e}");
    }
}

/// Rigid motions of the section cause no strain, with any potentials.
#[test]
fn identities_hold_with_potentials() {
    for section in sections() {
        let (domain, pattern) = prepared(&section);
        assert!(domain.potentials() > 0);
        let matrices = SectionMatrices::assemble(&domain, &pattern).expect("sound");
        let errors = crate::assembly::check_identities(&domain, &matrices);
        assert!(errors.iter().all(|error| *error < 1e-13), "{errors:?}");
        let mut motions = DMatrix::zeros(domain.unknowns(), 6);
        add_rigid_motions(&domain, &Matrix6::identity(), &mut motions);
        let potentials = motions.rows(3 * domain.nodes.len(), domain.potentials());
        assert_eq!(potentials.amax(), 0.0);
    }
}

/// The assembled matrices agree with the integrated stresses: E x + R y of random states,
/// also after other elimination orders.
#[test]
fn matrices_are_those_of_the_stresses() {
    for section in sections() {
        let (domain, pattern) = prepared(&section);
        let matrices = SectionMatrices::assemble(&domain, &pattern).expect("sound");
        let mut random = Random(9);
        let x = DMatrix::from_fn(domain.unknowns(), 6, |_, _| random.next());
        let y = Matrix6::from_fn(|_, _| random.next());
        let state = State {
            rate: Rate::Zero,
            warping: Some(&x),
            strain: &y,
        };
        let forces = section_forces(&domain, state);
        let mut expected = &matrices.r * y;
        let unknown = |row: usize| matrices.order[row] as usize;
        for (column, entries) in matrices.e.outer_iterator().enumerate() {
            for (row, &value) in entries.iter() {
                let (i, j) = (unknown(row), unknown(column));
                for case in 0..6 {
                    expected[(i, case)] += value * x[(j, case)];
                    if i != j {
                        expected[(j, case)] += value * x[(i, case)];
                    }
                }
            }
        }
        let difference = (&forces.within - &expected).amax();
        assert!(difference < 1e-12 * expected.amax(), "{difference:e}");
        let resultant = matrices.r.tr_mul(&x) + matrices.a * y;
        let difference = (forces.resultant - resultant).amax();
        assert!(
            difference < 1e-12 * forces.resultant.amax(),
            "{difference:e}"
        );
        let half = x.tr_mul(&forces.within) + y.transpose() * forces.resultant;
        let difference = (forces.work - half).amax();
        assert!(difference < 1e-11 * forces.work.amax(), "{difference:e}");
    }
}

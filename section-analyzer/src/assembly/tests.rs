use super::*;
use crate::element::Line;
use crate::section::samples::{coupled_rectangle, of_quadrilaterals};
use approx::assert_relative_eq;
use nalgebra::{Complex, DMatrix, Matrix6, Vector3, Vector6};
use shared_geom::mesh::CellKind;

const KINDS: [CellKind; 3] = [
    CellKind::Triangle6,
    CellKind::Quadrilateral4,
    CellKind::Quadrilateral9,
];

fn domain(kind: CellKind) -> Domain {
    Domain::new(&coupled_rectangle(kind)).expect("sound section")
}

/// A straight beam, one with an oblique line, and one of general curvature and slope.
fn domains(kind: CellKind) -> [Domain; 3] {
    let straight = domain(kind);
    let with = |curvature: [f64; 3], slope: [f64; 3]| Domain {
        line: Line {
            curvature: Vector3::from(curvature),
            slope: Vector3::from(slope),
        },
        ..straight.clone()
    };
    [
        with([0.0; 3], [1.0, 0.3, -0.2]),
        with([0.3, -0.2, 0.25], [0.9, 0.1, -0.05]),
        straight,
    ]
}

/// A state without any symmetry, k cases.
fn state(n: usize, k: usize, seed: usize) -> DMatrix<f64> {
    DMatrix::from_fn(n, k, |i, j| {
        (((i + seed) * 37 + j * 101) % 19) as f64 / 9.0 - 1.0
    })
}

/// Oracle: column j of E has the forces of the stresses of a unit displacement j; R and A
/// have the forces of unit generalized strains. The lower triangle in compressed columns
/// must agree, to round-off of sums of order one.
#[test]
fn assembled_matrices_are_the_forces_of_unit_states() {
    for domain in KINDS.into_iter().flat_map(domains) {
        let n = domain.unknowns();
        let matrices = SectionMatrices::assemble(&domain, &Pattern::new(&domain)).expect("sound");
        let still = Matrix6::zeros();
        for j in 0..n {
            let mut unit = DMatrix::zeros(n, 1);
            unit[j] = 1.0;
            let state = State {
                rate: Rate::Zero,
                warping: Some(&unit),
                strain: &still,
            };
            let forces = section_forces(&domain, state);
            for i in j..n {
                let found = matrices.e.get(i, j).copied().unwrap_or(0.0);
                assert_relative_eq!(found, forces.within[i], epsilon = 1e-13);
            }
            let row = matrices.r.row(j).transpose();
            let theta = forces.resultant.column(0).into_owned();
            assert_relative_eq!(
                Vector6::from_column_slice(row.as_slice()),
                theta,
                epsilon = 1e-13
            );
        }

        let strained = State {
            rate: Rate::Zero,
            warping: None,
            strain: &Matrix6::identity(),
        };
        let forces = section_forces(&domain, strained);
        assert_relative_eq!(matrices.r, forces.within, epsilon = 1e-13);
        assert_relative_eq!(matrices.a, forces.resultant, epsilon = 1e-13);
    }
}

/// Oracle: with `B = B0 + i w B1` a unit displacement has the forces
/// `B^H D B e = Q0 + w^2 P1 + i w (Q1 - P0)`, where (Q0, P0) are the forces of the
/// displacement and (Q1, P1) the forces of its rate; a unit strain has `R - i w L`.
#[test]
fn matrices_of_a_wave_are_the_forces_of_unit_waves() {
    let w = 0.7;
    for domain in KINDS.into_iter().flat_map(domains) {
        let n = domain.unknowns();
        let pattern = Pattern::new(&domain);
        let matrices = SectionMatrices::of_wave(&domain, &pattern, Complex::new(0.0, w));
        let matrices = matrices.expect("sound");
        let (still, mut unit) = (Matrix6::zeros(), DMatrix::zeros(n, 1));
        for j in [0, n / 2, n - 1] {
            unit.fill(0.0);
            unit[j] = 1.0;
            let of = |rate, warping| {
                let strain = &still;
                section_forces(
                    &domain,
                    State {
                        rate,
                        warping,
                        strain,
                    },
                )
            };
            let (position, rate) = (of(Rate::Zero, Some(&unit)), of(Rate::Given(&unit), None));
            for i in j..n {
                let found = matrices.e.get(i, j).copied().unwrap_or_default();
                let real = position.within[i] + w * w * rate.face[i];
                let imaginary = w * (rate.within[i] - position.face[i]);
                assert_relative_eq!(found.re, real, epsilon = 1e-13);
                assert_relative_eq!(found.im, imaginary, epsilon = 1e-13);
            }
        }
        let strain = Matrix6::identity();
        let strained = State {
            rate: Rate::Zero,
            warping: None,
            strain: &strain,
        };
        let forces = section_forces(&domain, strained);
        assert_relative_eq!(matrices.r.map(|v| v.re), forces.within, epsilon = 1e-13);
        assert_relative_eq!(matrices.r.map(|v| v.im), -w * forces.face, epsilon = 1e-13);
        assert_relative_eq!(matrices.a, forces.resultant, epsilon = 1e-13);
    }
}

/// Virtual work: the stresses of a state do the same work on another state as its forces,
/// `eps2' D eps1 = u2' . P1 + u2 . Q1 + psi2 . theta1`, summed over the section.
#[test]
fn forces_do_the_work_of_the_stresses() {
    for domain in KINDS.into_iter().flat_map(domains) {
        let n = domain.unknowns();
        let (rate, warping) = (state(n, 6, 1), state(n, 6, 5));
        let strain = Matrix6::from_fn(|i, j| ((i * 5 + j * 3) % 7) as f64 - 3.0);
        let state = State {
            rate: Rate::Given(&rate),
            warping: Some(&warping),
            strain: &strain,
        };
        let forces = section_forces(&domain, state);
        let work = rate.tr_mul(&forces.face)
            + warping.tr_mul(&forces.within)
            + strain.tr_mul(&forces.resultant);
        let energy = forces.work;
        let scale = energy.amax();
        assert_relative_eq!(
            work.fixed_view::<6, 6>(0, 0).into_owned() / scale,
            energy / scale,
            epsilon = 1e-14
        );
    }
}

/// All identities to round-off for a section with every coupling and curved sides.
#[test]
fn identities_hold() {
    for domain in KINDS.into_iter().flat_map(domains) {
        let matrices = SectionMatrices::assemble(&domain, &Pattern::new(&domain)).expect("sound");
        let errors = check_identities(&domain, &matrices);
        for (error, name) in errors.into_iter().zip(IDENTITIES) {
            assert!(error < 1e-13, "{:?} {name}: {error:e}", domain.line);
        }
    }
}

/// A matrix that does not belong to the domain is detected: one entry of R, E, A wrong by a
/// thousandth.
#[test]
fn identities_notice_a_wrong_entry() {
    let domain = domain(CellKind::Quadrilateral9);
    let sound = SectionMatrices::assemble(&domain, &Pattern::new(&domain)).expect("sound");
    let worst = |matrices: &SectionMatrices<f64>| {
        let errors = check_identities(&domain, matrices);
        errors.into_iter().fold(0.0, f64::max)
    };
    let mut wrong = sound.clone();
    wrong.r[(7, 3)] += 1e-3;
    assert!(worst(&wrong) > 1e-5);
    let mut wrong = sound.clone();
    wrong.a[(2, 3)] += 1e-3;
    assert!(worst(&wrong) > 1e-5);
    let mut wrong = sound.clone();
    wrong.e.data_mut()[40] += 1e-3;
    assert!(worst(&wrong) > 1e-5);
}

/// The rigid motions of a point at t, translation plus rotation x t, and forces that
/// do the work of their resultant on them.
#[test]
fn rigid_motions_move_every_node() {
    let domain = domain(CellKind::Triangle6);
    let motions = Matrix6::from_fn(|i, j| ((5 * i + 3 * j) % 11) as f64 / 7.0 - 0.6);
    let mut displacement = DMatrix::zeros(domain.unknowns(), 6);
    add_rigid_motions(&domain, &motions, &mut displacement);
    for (node, &[y, z]) in domain.nodes.iter().enumerate() {
        let t = nalgebra::Vector3::new(0.0, y, z);
        let motion = motions.column(2);
        let expected = motion.fixed_rows::<3>(0) + motion.fixed_rows::<3>(3).cross(&t);
        let found = displacement.fixed_view::<3, 1>(3 * node, 2).into_owned();
        assert_relative_eq!(found, expected, epsilon = 1e-15);
    }
    let forces = state(domain.unknowns(), 6, 2);
    let work = displacement
        .tr_mul(&forces)
        .fixed_view::<6, 6>(0, 0)
        .into_owned();
    let of_resultant = motions.transpose() * resultant(&domain, &forces);
    assert_relative_eq!(work, of_resultant, epsilon = 1e-14 * work.amax());
}

/// Mass of a square of side 2 with density 2 at (y, z) = (0.5, -1) from the origin:
/// m = 8, I = m / 6 (each axis) plus m times the squared distance, products by hand.
#[test]
fn mass_of_a_square_off_the_origin() {
    let square = [[-0.5, -2.0], [1.5, -2.0], [1.5, 0.0], [-0.5, 0.0]];
    let section = of_quadrilaterals(&square, &[[0, 1, 2, 3]]);
    let mass = mass_per_length(&Domain::new(&section).expect("sound"));
    let (m, y, z) = (8.0, 0.5, -1.0);
    let mut expected = Matrix6::zeros();
    for i in 0..3 {
        expected[(i, i)] = m;
    }
    // momentum m (v + omega x c)
    expected[(0, 4)] = m * z;
    expected[(0, 5)] = -m * y;
    expected[(1, 3)] = -m * z;
    expected[(2, 3)] = m * y;
    expected[(3, 3)] = m / 3.0 + m * (y * y + z * z);
    expected[(4, 4)] = m / 6.0 * 2.0 + m * z * z;
    expected[(5, 5)] = m / 6.0 * 2.0 + m * y * y;
    expected[(4, 5)] = -m * y * z;
    expected.fill_lower_triangle_with_upper_triangle();
    expected[(3, 3)] += m / 3.0;
    assert_relative_eq!(mass, expected, epsilon = 1e-14);
}

/// Nodes without a cell have no unknowns, and neighbors follow from the cells.
#[test]
fn unused_nodes_are_left_out() {
    let nodes = [
        [0.0, 0.0],
        [9.0, 9.0],
        [1.0, 0.0],
        [1.0, 1.0],
        [0.0, 1.0],
        [2.0, 0.0],
        [2.0, 1.0],
    ];
    let section = of_quadrilaterals(&nodes, &[[0, 2, 3, 4], [2, 5, 6, 3]]);
    let domain = Domain::new(&section).expect("sound");
    assert_eq!(domain.mesh_nodes, [0, 2, 3, 4, 5, 6]);
    assert_eq!(domain.unknowns(), 18);
    let pattern = Pattern::new(&domain);
    assert_eq!(pattern.neighbors(0), [0, 1, 2, 3]);
    assert_eq!(pattern.neighbors(1), [0, 1, 2, 3, 4, 5]);
    assert_eq!(pattern.parts(), [0]);
}

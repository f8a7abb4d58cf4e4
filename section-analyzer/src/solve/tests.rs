use super::*;
use crate::assembly::{
    Domain, Pattern, SectionMatrices, State, face_forces, internal_forces, rigid_modes,
};
use crate::section::samples::{coupled_rectangle, of_quadrilaterals};
use approx::assert_relative_eq;
use nalgebra::{DMatrix, Matrix6, Matrix6xX};
use shared_geom::mesh::CellKind;

struct Problem {
    domain: Domain,
    pattern: Pattern,
    matrices: SectionMatrices,
}

fn problem() -> Problem {
    let domain = Domain::new(&coupled_rectangle(CellKind::Quadrilateral8)).expect("sound");
    let pattern = Pattern::new(&domain);
    let matrices = SectionMatrices::assemble(&domain, &pattern).expect("sound");
    Problem {
        domain,
        pattern,
        matrices,
    }
}

/// E as a full dense matrix.
fn dense(matrices: &SectionMatrices) -> DMatrix<f64> {
    let n = matrices.unknowns();
    let mut e = DMatrix::zeros(n, n);
    for (&value, (i, j)) in matrices.e.iter() {
        e[(i, j)] = value;
        e[(j, i)] = value;
    }
    e
}

/// Oracle: dense Cholesky of E with pinned rows and columns replaced.
#[test]
fn factor_solves_the_pinned_matrix() {
    let p = problem();
    let pins = Pins::choose(&p.domain.nodes).expect("wide");
    let factor = Factor::new(&p.matrices.e, &p.pattern, pins).expect("positive definite");
    let mut e = dense(&p.matrices);
    for &pin in pins.unknowns() {
        let diagonal = e[(pin, pin)];
        e.row_mut(pin).fill(0.0);
        e.column_mut(pin).fill(0.0);
        e[(pin, pin)] = diagonal;
    }
    let mut b = DMatrix::from_fn(e.nrows(), 4, |i, j| ((i * 7 + j * 3) % 11) as f64 - 5.0);
    let mut x = b.clone();
    factor.solve(&mut x).expect("memory");
    factor.clear_pinned(&mut b);
    let expected = e.clone().cholesky().expect("positive definite").solve(&b);
    assert_relative_eq!(
        x,
        expected,
        max_relative = 1e-10,
        epsilon = 1e-11 * expected.amax()
    );

    // the smallest pivot is that of a Cholesky factor in some order: between the
    // smallest eigenvalue of the scaled matrix and one
    let d = e.diagonal().map(|value| 1.0 / value.sqrt());
    let scaled = DMatrix::from_diagonal(&d) * &e * DMatrix::from_diagonal(&d);
    let smallest = scaled.symmetric_eigenvalues().min();
    let ratio = factor.smallest_pivot().ratio;
    assert!(
        ratio >= smallest && ratio <= 1.0,
        "{ratio} against {smallest}"
    );
}

/// Two squares that share no node: the pins hold one of them, the other is free, and
/// the factorization says so.
#[test]
fn factor_refuses_a_singular_matrix() {
    let square = |y: f64| [[y, 0.0], [y + 1.0, 0.0], [y + 1.0, 1.0], [y, 1.0]];
    let nodes = [square(0.0), square(3.0)].concat();
    let section = of_quadrilaterals(&nodes, &[[0, 1, 2, 3], [4, 5, 6, 7]]);
    let domain = Domain::new(&section).expect("sound lists");
    let pattern = Pattern::new(&domain);
    assert_eq!(pattern.parts(), [0, 4]);
    let matrices = SectionMatrices::assemble(&domain, &pattern).expect("sound cells");
    let pins = Pins::choose(&domain.nodes).expect("wide");
    match Factor::new(&matrices.e, &pattern, pins) {
        Err(FactorError::NotPositive(pivot)) => assert!(pivot.ratio < 1e-14),
        Ok(factor) => assert!(factor.smallest_pivot().ratio < 1e-14),
        Err(error) => panic!("{error:?}"),
    }
}

/// A balanced state has the forces that were asked for, in pinned rows too.
#[test]
fn balanced_states_are_in_balance() {
    let p = problem();
    let pins = Pins::choose(&p.domain.nodes).expect("wide");
    let system = CentralSystem::new(&p.domain, &p.pattern, &p.matrices, pins).expect("definite");
    let n = p.domain.unknowns();
    let theta = Matrix6xX::identity(6).columns(0, 1).into_owned();
    let state = system
        .balance(None, &DMatrix::zeros(n, 1), &theta)
        .expect("memory");
    let mut strain = Matrix6::zeros();
    strain.set_column(0, &state.y.column(0));
    let forces = internal_forces(
        &p.domain,
        State {
            rate: None,
            warping: Some(&state.x),
            strain: &strain,
        },
        1,
    );
    assert!(forces.within.amax() < 1e-14);
    assert_relative_eq!(forces.resultant.column(0), theta.column(0), epsilon = 1e-14);
    for &pin in pins.unknowns() {
        assert_eq!(state.x[pin], 0.0);
    }
}

fn decoupled(p: &Problem, pins: Pins) -> Decoupled {
    let system = CentralSystem::new(&p.domain, &p.pattern, &p.matrices, pins).expect("definite");
    let central = CentralSolution::solve(&p.domain, &system).expect("memory");
    Decoupled::new(&p.domain, &rigid_modes(&p.domain), &central)
}

/// The stresses on the face carry the unit force and do no work on the warping:
/// `H' Ph = I`, `Ph' Xd = 0`; and Yd is symmetric.
#[test]
fn decoupled_warping_is_free_of_the_face_stresses() {
    let p = problem();
    let solution = decoupled(&p, Pins::choose(&p.domain.nodes).expect("wide"));
    let state = State {
        rate: Some(&warping_rate(&solution.x)),
        warping: Some(&solution.x),
        strain: &solution.y,
    };
    let face = face_forces(&p.domain, state, 6);
    assert!(face.tr_mul(&solution.x).amax() < 1e-13 * solution.x.amax());
    assert_relative_eq!(
        solution.internal_force,
        Matrix6::identity(),
        epsilon = 1e-13
    );
    assert_relative_eq!(
        solution.y,
        solution.y.transpose(),
        epsilon = 1e-13 * solution.y.amax()
    );
}

/// Pins are a choice without consequence: held at quite other nodes, the decoupled
/// solutions are the same.
#[test]
fn solutions_do_not_depend_on_the_pins() {
    let p = problem();
    let farthest = Pins::choose(&p.domain.nodes).expect("wide");
    // the pins of a mirrored, sheared copy of the nodes
    let moved: Vec<[f64; 2]> = p
        .domain
        .nodes
        .iter()
        .map(|&[y, z]| [0.4 - y, 2.0 * z + y])
        .collect();
    let other = Pins::choose(&moved).expect("wide");
    assert_ne!(farthest, other);

    let (one, two) = (decoupled(&p, farthest), decoupled(&p, other));
    assert_relative_eq!(one.x, two.x, epsilon = 1e-12 * one.x.amax());
    assert_relative_eq!(one.y, two.y, epsilon = 1e-12 * one.y.amax());
}

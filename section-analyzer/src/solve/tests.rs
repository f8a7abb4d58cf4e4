use super::*;
use crate::assembly::{Domain, Pattern, Rate, SectionMatrices, State, section_forces};
use crate::element::Line;
use crate::section::samples::{coupled_rectangle, of_quadrilaterals};
use approx::assert_relative_eq;
use nalgebra::{DMatrix, Matrix6, Matrix6xX};
use shared_geom::mesh::CellKind;

pub(super) struct Problem {
    pub domain: Domain,
    pub pattern: Pattern,
    pub matrices: SectionMatrices<f64>,
}

pub(super) fn problem() -> Problem {
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
fn dense(matrices: &SectionMatrices<f64>) -> DMatrix<f64> {
    let n = matrices.unknowns();
    let mut e = DMatrix::zeros(n, n);
    for (&value, (i, j)) in matrices.e.iter() {
        let (i, j) = (i as usize, j as usize);
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
    let factor =
        Factor::new(p.matrices.e.clone(), &p.pattern, pins.clone()).expect("positive definite");
    let mut e = dense(&p.matrices);
    for &pin in pins.unknowns() {
        let diagonal = e[(pin, pin)];
        e.row_mut(pin).fill(0.0);
        e.column_mut(pin).fill(0.0);
        e[(pin, pin)] = diagonal;
    }
    let mut b = DMatrix::from_fn(e.nrows(), 4, |i, j| ((i * 7 + j * 3) % 11) as f64 - 5.0);
    let mut x = b.clone();
    factor.solve(x.as_mut_slice()).expect("memory");
    factor.clear_pinned(b.as_mut_slice());
    let expected = e.clone().cholesky().expect("positive definite").solve(&b);
    assert_relative_eq!(
        x,
        expected,
        max_relative = 1e-10,
        epsilon = 1e-11 * expected.amax()
    );

    // the smallest pivot of a Cholesky factor in any order is between the smallest
    // eigenvalue of the scaled matrix and one
    let d = e.diagonal().map(|value| 1.0 / value.sqrt());
    let scaled = DMatrix::from_diagonal(&d) * &e * DMatrix::from_diagonal(&d);
    let smallest = scaled.symmetric_eigenvalues().min();
    let ratio = factor.smallest_pivot().ratio;
    assert!(
        ratio >= smallest && ratio <= 1.0,
        "{ratio} against {smallest}"
    );
}

/// The order of elimination is a permutation with a smaller factor than the order of a
/// mesh; the domain in that order has the same cells.
#[test]
fn elimination_order_keeps_the_factor_small() {
    let p = problem();
    let order = elimination_order(&p.pattern).expect("memory");
    let mut sorted = order.clone();
    sorted.sort_unstable();
    assert!(sorted.iter().copied().eq(0..p.domain.nodes.len() as u32));

    let entries = |domain: &Domain| {
        let pattern = Pattern::new(domain);
        let matrices = SectionMatrices::assemble(domain, &pattern).expect("sound");
        let pins = Pins::choose(&domain.nodes).expect("wide");
        let factor = Factor::new(matrices.e, &pattern, pins.clone()).expect("definite");
        factor.entries()
    };
    let ordered = p.domain.clone().renumbered(&order);
    assert!(entries(&ordered) < entries(&p.domain));
    for cell in &ordered.cells {
        let before = p.domain.cells.iter().find(|before| before.tag == cell.tag);
        let before = before.expect("the same cells");
        let count = cell.kind.node_count();
        assert_eq!(
            ordered.positions(cell)[..count],
            p.domain.positions(before)[..count]
        );
    }
}

/// Two squares that share no node: the pins hold one of them, the other is free, and the
/// factorization reports it.
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
    match Factor::new(matrices.e, &pattern, pins.clone()) {
        Err(FactorError::NotPositive(pivot)) => assert!(pivot.ratio < 1e-14),
        Ok(factor) => assert!(factor.smallest_pivot().ratio < 1e-14),
        Err(error) => panic!("{error:?}"),
    }
}

fn system(p: &Problem, pins: Pins) -> CentralSystem<f64> {
    CentralSystem::new(&p.pattern, p.matrices.clone(), pins.clone()).expect("definite")
}

/// A balanced state has the required forces, in pinned rows too.
#[test]
fn balanced_states_are_in_balance() {
    let p = problem();
    let pins = Pins::choose(&p.domain.nodes).expect("wide");
    // shears are not in balance without a rate
    let theta = Matrix6::from_diagonal(&[1.0, 0.0, 0.0, 1.0, 1.0, 1.0].into());
    let columns: Matrix6xX<f64> = theta.columns(0, 6).into_owned();
    let (x, y) = system(&p, pins.clone()).balance_of(&columns);
    let y = y.fixed_columns::<6>(0).into_owned();
    let state = State {
        rate: Rate::Zero,
        warping: Some(&x),
        strain: &y,
    };
    let forces = section_forces(&p.domain, state);
    // one solution without corrections: round-off times a condition of about 1e4
    assert!(forces.within.amax() < 1e-11);
    assert_relative_eq!(forces.resultant, theta, epsilon = 1e-11);
    for &pin in pins.unknowns() {
        assert_eq!(x.row(pin).amax(), 0.0);
    }
}

/// A correction balances the missing forces: any warping is recovered from its own forces,
/// up to rigid motions, which the pins remove.
#[test]
fn corrections_find_the_state_of_given_forces() {
    let p = problem();
    let pins = Pins::choose(&p.domain.nodes).expect("wide");
    let n = p.domain.unknowns();
    let mut warping = DMatrix::from_fn(n, 2, |i, j| (((i + 3 * j) * 37) % 19) as f64 / 9.0 - 1.0);
    for &pin in pins.unknowns() {
        warping.row_mut(pin).fill(0.0);
    }
    let mut strain = Matrix6::zeros();
    strain[(2, 0)] = 0.7;
    strain[(4, 1)] = -0.4;
    let state = State {
        rate: Rate::Zero,
        warping: Some(&warping),
        strain: &strain,
    };
    let forces = section_forces(&p.domain, state);
    let mut dx = forces.within.columns(0, 2).into_owned();
    let theta = [forces.resultant.column(0), forces.resultant.column(1)];
    let mut dy = Matrix6xX::from_columns(&theta);
    let system = system(&p, pins.clone());
    system.correct(dx.as_mut_slice(), &mut dy).expect("memory");
    // the Schur complement and E of this section have a condition of about 1e4
    assert_relative_eq!(dx, warping, epsilon = 1e-10);
    assert_relative_eq!(dy.column(0), strain.column(0), epsilon = 1e-10);
    assert_relative_eq!(dy.column(1), strain.column(1), epsilon = 1e-10);
}

/// The bound of the condition number is below the condition number, and close to it: the
/// soft warping is found.
#[test]
fn condition_is_bounded_from_below() {
    let p = problem();
    let pins = Pins::choose(&p.domain.nodes).expect("wide");
    let mut e = dense(&p.matrices);
    for &pin in pins.unknowns() {
        let diagonal = e[(pin, pin)];
        e.row_mut(pin).fill(0.0);
        e.column_mut(pin).fill(0.0);
        e[(pin, pin)] = diagonal;
    }
    let norm = |m: &DMatrix<f64>| -> f64 {
        let sums = m.column_iter().map(|column| column.lp_norm(1));
        sums.fold(0.0, f64::max)
    };
    let exact = norm(&e) * norm(&e.clone().try_inverse().expect("regular"));
    let system = system(&p, pins.clone());
    assert_relative_eq!(system.factor().norm(), norm(&e), max_relative = 1e-14);
    let found = system.condition();
    assert!(found <= exact && found > 0.05 * exact, "{found} {exact}");
}

pub(super) fn systems(p: &Problem, pins: Pins) -> CentralSystems {
    CentralSystems::new(&p.domain, &p.pattern, p.matrices.clone(), pins.clone()).expect("definite")
}

fn decoupled(p: &Problem, pins: Pins) -> Decoupled {
    let central = CentralSolution::solve(&p.domain, &systems(p, pins.clone())).expect("memory");
    Decoupled::new(&p.domain, central)
}

/// The problem of the sample on a beam of given line, in units of the domain.
pub(super) fn problem_along(curvature: [f64; 3], slope: [f64; 3]) -> Problem {
    let mut p = problem();
    p.domain.line = Line {
        curvature: curvature.into(),
        slope: slope.into(),
    };
    p.matrices = SectionMatrices::assemble(&p.domain, &p.pattern).expect("sound");
    p
}

/// A straight beam, a beam with an oblique line, and strongly and slightly curved beams.
pub(super) fn problems() -> [Problem; 4] {
    [
        problem(),
        problem_along([0.0; 3], [1.0, 0.3, -0.2]),
        problem_along([0.3, -0.2, 0.25], [0.9, 0.1, -0.05]),
        problem_along([2e-9, 1e-9, -1e-9], [1.0, 0.0, 0.0]),
    ]
}

/// The stresses on the face carry the unit force and do no work on the warping:
/// `H' Ph = I`, `Ph' Xd = 0`; Yd is symmetric; and the forces within the section balance,
/// `Q = Ph T'` (S-75).
#[test]
fn decoupled_warping_is_free_of_the_face_stresses() {
    for p in problems() {
        let solution = decoupled(&p, Pins::choose(&p.domain.nodes).expect("wide"));
        let state = State {
            rate: Rate::Central,
            warping: Some(&solution.x),
            strain: &solution.y,
        };
        let forces = section_forces(&p.domain, state);
        let (line, face) = (&p.domain.line, &forces.face);
        assert!(
            face.tr_mul(&solution.x).amax() < 1e-13 * solution.x.amax(),
            "{line:?}"
        );
        assert_relative_eq!(
            solution.internal_force,
            Matrix6::identity(),
            epsilon = 1e-12
        );
        assert_relative_eq!(
            solution.y,
            solution.y.transpose(),
            epsilon = 1e-13 * solution.y.amax()
        );
        // round-off of stresses that are up to a hundred times the unit force
        assert!((&forces.within - face * line.equilibrium()).amax() < 1e-12);
    }
}

/// Forces within the section that balance only stresses: the forces of an imposed stress of
/// a warping `w`, of a rate and a strain, all without any symmetry, as f0, f1, fp of
/// imposed strains.
fn imposed(p: &Problem) -> (DMatrix<f64>, Matrix6<f64>) {
    let n = p.domain.unknowns();
    let field = |seed: usize| {
        DMatrix::from_fn(n, 6, |i, j| {
            (((i + seed) * 37 + j * 101) % 19) as f64 / 9.0 - 1.0
        })
    };
    let (rate, warping) = (field(3), field(8));
    let state = State {
        rate: Rate::Given(&rate),
        warping: Some(&warping),
        strain: &Matrix6::from_fn(|i, j| ((i * 5 + j * 3) % 7) as f64 - 3.0),
    };
    let forces = section_forces(&p.domain, state);
    (forces.within, forces.resultant)
}

/// The choice of pins has no influence: for random nodes the decoupled central solutions
/// and the particular ones, which have no internal force, are the same.
#[test]
fn solutions_do_not_depend_on_the_pins() {
    for p in problems() {
        let of_pins = |pins: Pins| {
            let systems = systems(&p, pins.clone());
            let central = CentralSolution::solve(&p.domain, &systems).expect("memory");
            let coupled = central.y;
            let central = Decoupled::new(&p.domain, central);
            let (within, resultant) = imposed(&p);
            let load = Load {
                within: &within,
                resultant: &resultant,
                rate: Rate::Zero,
            };
            let particular =
                ParticularSolution::solve(&p.domain, systems.steady(), &central.face, &load);
            (central, particular.expect("memory"), coupled)
        };
        let (central, particular, coupled) = of_pins(Pins::choose(&p.domain.nodes).expect("wide"));
        let nodes = &p.domain.nodes;
        for [a, b, c] in random_triangles(nodes) {
            let (other, with, before) = of_pins(Pins::at(nodes, [a, b, c]));
            // round-off times a condition of about 1e4, times the condition of narrow pins
            let line = &p.domain.line;
            let close = |one: f64, scale: f64| assert!(one < 1e-10 * scale, "{line:?} {one:e}");
            close((&central.x - other.x).amax(), central.x.amax());
            close((central.y - other.y).amax(), central.y.amax());
            close((&particular.x - with.x).amax(), particular.x.amax());
            close((particular.y - with.y).amax(), particular.y.amax());
            // without decoupling the shears of these strains depend on the pins
            let difference = (coupled - before).amax() / coupled.amax();
            assert!(difference > 1e-3, "{line:?} {difference:e}");
        }
    }
}

/// Triples of nodes, pseudo-random, whose triangle has an area.
pub(super) fn random_triangles(nodes: &[[f64; 2]]) -> Vec<[usize; 3]> {
    let mut state = 12345_u64;
    let mut next = || {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (state >> 33) as usize % nodes.len()
    };
    let mut found = Vec::new();
    while found.len() < 8 {
        let [a, b, c] = [next(), next(), next()];
        let from_a = |i: usize| [nodes[i][0] - nodes[a][0], nodes[i][1] - nodes[a][1]];
        let (ab, ac) = (from_a(b), from_a(c));
        if (ab[0] * ac[1] - ab[1] * ac[0]).abs() > 0.05 {
            found.push([a, b, c]);
        }
    }
    found
}

/// A particular solution balances the given forces, in pinned rows too if these are forces
/// of stresses.
#[test]
fn particular_solutions_are_in_balance() {
    for p in problems() {
        let systems = systems(&p, Pins::choose(&p.domain.nodes).expect("wide"));
        let central = CentralSolution::solve(&p.domain, &systems).expect("memory");
        let central = Decoupled::new(&p.domain, central);
        // a strain without warping: E x + R y = R y0 has the solution x = 0, y = y0 up to a
        // rigid motion
        let strain = Matrix6::from_fn(|i, j| ((i * 5 + j * 3) % 7) as f64 - 3.0);
        let state = State {
            rate: Rate::Zero,
            warping: None,
            strain: &strain,
        };
        let forces = section_forces(&p.domain, state);
        let load = Load {
            within: &forces.within,
            resultant: &forces.resultant,
            rate: Rate::Zero,
        };
        let found = ParticularSolution::solve(&p.domain, systems.steady(), &central.face, &load);
        let found = found.expect("memory");
        let state = State {
            rate: Rate::Zero,
            warping: Some(&found.x),
            strain: &found.y,
        };
        let again = section_forces(&p.domain, state);
        let scale = forces.within.amax();
        assert_relative_eq!(again.within, forces.within, epsilon = 1e-11 * scale);
        assert_relative_eq!(again.resultant, forces.resultant, epsilon = 1e-11 * scale);
        assert!(central.face.tr_mul(&found.x).amax() < 1e-12);
    }
}

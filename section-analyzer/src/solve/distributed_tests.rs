use super::tests::{Problem, problem, problem_along, problems, random_triangles, systems};
use super::*;
use crate::assembly::{Rate, SectionForces, State, resultant, section_forces};
use approx::assert_relative_eq;
use nalgebra::{DMatrix, Matrix6, Matrix6xX};

/// Forces at the nodes without any symmetry: six loads that vary along the beam as a
/// parabola, f_0, f_1, f_2.
fn loads(n: usize) -> [DMatrix<f64>; 3] {
    [2, 5, 11].map(|seed| {
        DMatrix::from_fn(n, 6, |i, j| {
            (((i + seed) * 37 + j * 101) % 19) as f64 / 9.0 - 1.0
        })
    })
}

fn central(p: &Problem, systems: &CentralSystems) -> Decoupled {
    let central = CentralSolution::solve(&p.domain, systems).expect("memory");
    Decoupled::new(&p.domain, central)
}

fn solution(p: &Problem, pins: Pins, loads: &[DMatrix<f64>]) -> (Decoupled, DistributedSolution) {
    let systems = systems(p, pins.clone());
    let central = central(p, &systems);
    let found = DistributedSolution::solve(&p.domain, systems.steady(), &central, loads);
    (central, found.expect("memory"))
}

fn forces_of(p: &Problem, solution: &DistributedSolution) -> SectionForces {
    let state = State {
        rate: Rate::Given(&solution.rate),
        warping: Some(&solution.x),
        strain: &solution.y,
    };
    section_forces(&p.domain, state)
}

/// The choice of pins has no influence, on straight, oblique and curved lines.
#[test]
fn loads_do_not_depend_on_the_pins() {
    for p in problems() {
        let loads = loads(p.domain.unknowns());
        let nodes = &p.domain.nodes;
        let (_, one) = solution(&p, Pins::choose(nodes).expect("wide"), &loads);
        for triangle in random_triangles(nodes) {
            let (_, other) = solution(&p, Pins::at(nodes, triangle), &loads);
            // round-off times a condition of about 1e4, times the condition of narrow pins
            let close = |error: f64, scale: f64| {
                assert!(error < 1e-10 * scale, "{:?} {error:e}", p.domain.line);
            };
            close((&one.x - other.x).amax(), one.x.amax());
            close((&one.rate - other.rate).amax(), one.rate.amax());
            close((one.y - other.y).amax(), one.y.amax());
        }
    }
}

/// Along the beam `Q = P' + f` (S-103): with the state a small distance further, solved
/// independently with the load and the internal force there, the rate of the forces on the
/// face balances the load.
#[test]
fn forces_are_in_balance_along_the_beam() {
    for p in problems() {
        let pins = Pins::choose(&p.domain.nodes).expect("wide");
        let loads = loads(p.domain.unknowns());
        let (central, here) = solution(&p, pins.clone(), &loads);
        let forces = forces_of(&p, &here);
        let scale = forces.within.amax();
        // no internal force at the section
        assert!(forces.resultant.amax() < 1e-11 * scale);
        // the load at x = h and, to the second order, the internal force there: with
        // theta = 0 at x = 0, theta' = -s0 and theta'' = -T' s0 - s1
        let tt = p.domain.line.equilibrium();
        let face_at = |h: f64| {
            let moved = [
                &loads[0] + h * &loads[1] + 0.5 * h * h * &loads[2],
                &loads[1] + h * &loads[2],
                loads[2].clone(),
            ];
            let (_, there) = solution(&p, pins.clone(), &moved);
            let (s0, s1) = (
                resultant(&p.domain, &loads[0]),
                resultant(&p.domain, &loads[1]),
            );
            let theta = -h * s0 - 0.5 * h * h * (tt * s0 + s1);
            forces_of(&p, &there).face + &central.face * theta
        };
        let h = 1e-4;
        let rate = (face_at(h) - face_at(-h)) / (2.0 * h);
        let balance = &forces.within - (rate + &loads[0]);
        // the neglected third order of theta, h^2 = 1e-8, and round-off over h
        assert!(balance.amax() < 1e-6 * scale, "{:e}", balance.amax());
    }
}

/// Warping and generalized strain of six cases.
type Field = (DMatrix<f64>, Matrix6<f64>);

/// The state under `forces` and internal forces `theta`, by order of the derivative, and
/// the state of the first derivative: the recursion from the highest degree down, with
/// pinned solutions that are neither corrected nor decoupled.
fn by_recursion(
    p: &Problem,
    pins: Pins,
    forces: &[DMatrix<f64>],
    theta: &[Matrix6<f64>],
) -> (Field, Field) {
    let systems = systems(p, pins.clone());
    let zero = (DMatrix::zeros(p.domain.unknowns(), 6), Matrix6::zeros());
    let (mut next, mut second) = (zero.clone(), zero);
    for i in (0..forces.len()).rev() {
        let along = State {
            rate: Rate::Given(&second.0),
            warping: Some(&next.0),
            strain: &next.1,
        };
        let face = section_forces(&p.domain, along).face;
        let rate_alone = State {
            rate: Rate::Given(&next.0),
            warping: None,
            strain: &Matrix6::zeros(),
        };
        let of_rate = section_forces(&p.domain, rate_alone);
        let mut x = &forces[i] + face - of_rate.within;
        let missing = theta[i] - of_rate.resultant;
        let mut y: Matrix6xX<f64> = missing.columns(0, 6).into_owned();
        let system = systems.steady();
        system.correct(x.as_mut_slice(), &mut y).expect("memory");
        second = std::mem::replace(&mut next, (x, y.fixed_columns::<6>(0).into_owned()));
    }
    (next, second)
}

/// The generalized strain against another method: the recursion of polynomials in x for
/// internal force and state together, from the highest degree down, with pinned and not
/// decoupled solutions; only its stresses are used, on which the rigid part has no
/// influence, and their work on the central solutions (S-107).
#[test]
fn generalized_strain_is_the_work_on_the_central_solutions() {
    for p in [problem(), problem_along([0.0; 3], [1.0, 0.3, -0.2])] {
        let pins = Pins::choose(&p.domain.nodes).expect("wide");
        let [f0, f1, _] = loads(p.domain.unknowns());
        let (central, found) = solution(&p, pins.clone(), &[f0.clone(), f1.clone()]);

        // theta_0 = 0, theta_(i+1) = T' theta_i - H' f_i
        let tt = p.domain.line.equilibrium();
        let n = p.domain.unknowns();
        let forces = [f0, f1, DMatrix::zeros(n, 6), DMatrix::zeros(n, 6)];
        let mut theta = vec![Matrix6::zeros()];
        for (i, force) in forces.iter().enumerate() {
            theta.push(tt * theta[i] - resultant(&p.domain, force));
        }
        assert!(theta[4].amax() < 1e-12);

        let (next, second) = by_recursion(&p, pins.clone(), &forces, &theta);
        let state = State {
            rate: Rate::Given(&second.0),
            warping: Some(&next.0),
            strain: &next.1,
        };
        let stresses = section_forces(&p.domain, state);
        let product = |columns: &DMatrix<f64>| -> Matrix6<f64> {
            let product = central.x.tr_mul(columns);
            product.fixed_view::<6, 6>(0, 0).into_owned()
        };
        let work = product(&stresses.within) + tt.transpose() * product(&stresses.face);
        // solutions without corrections: round-off times a condition of about 1e4, and
        // polynomials that grow with the load
        assert_relative_eq!(work, found.y, epsilon = 1e-10 * found.x.amax());
        let again = forces_of(&p, &found);
        assert_relative_eq!(
            again.face,
            stresses.face,
            epsilon = 1e-10 * stresses.face.amax()
        );
        // not decoupled, the generalized strain differs
        assert!((next.1 - found.y).amax() > 1e-3 * found.y.amax());
    }
}

/// For loads that are constant along a straight beam the axial, torsion and bending strains
/// are the work of the load on the warping of the central solutions: `y = X' f + T X' P`,
/// where T contributes only to the rows of the shears.
#[test]
fn strain_under_a_constant_load_is_work_on_the_warping() {
    let p = problem();
    let pins = Pins::choose(&p.domain.nodes).expect("wide");
    let load = loads(p.domain.unknowns())[0].clone();
    let (central, found) = solution(&p, pins.clone(), std::slice::from_ref(&load));
    let work = central.x.tr_mul(&load);
    for row in [0, 3, 4, 5] {
        let difference = (work.row(row) - found.y.row(row)).amax();
        assert!(difference < 1e-11 * found.x.amax(), "{row} {difference:e}");
    }
    assert!((work.row(1) - found.y.row(1)).amax() > 1e-6);
}

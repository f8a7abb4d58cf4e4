//! Solutions of factorizations with kept pivots, on matrices of several kinds.

use std::sync::Arc;

use sparse_solver::{Pattern, Sparse, StepSolver};

/// Pseudo-random numbers between -1 and 1.
fn scattered(seed: usize, count: usize) -> Vec<f64> {
    (0..count)
        .map(|i| (1.7 + 3.1 * seed as f64 + 2.3 * i as f64 + 0.7 * (i * i % 1009) as f64).sin())
        .collect()
}

fn matrix(n: usize, entries: &[(usize, usize, f64)]) -> Sparse {
    let indices = entries.iter().map(|entry| (entry.0, entry.1));
    let diagonal = (0..n).map(|i| (i, i));
    let pattern = Arc::new(Pattern::new(n, indices.chain(diagonal).collect()));
    let mut matrix = Sparse::zero(Arc::clone(&pattern));
    for &(i, j, value) in entries {
        matrix.values_mut()[pattern.index(i, j).unwrap()] += value;
    }
    matrix
}

/// Some entries off the diagonal of each row, and a diagonal of the given size.
fn unsymmetric(n: usize, seed: usize, diagonal: f64) -> Vec<(usize, usize, f64)> {
    let numbers = scattered(seed, 5 * n);
    let mut entries: Vec<_> = (0..n).map(|i| (i, i, diagonal * numbers[i])).collect();
    for i in 0..n {
        for k in 1..5 {
            let j = (i * (3 * k + 1) + 7 * k * k + seed) % n;
            entries.push((i, j, numbers[k * n + i]));
        }
    }
    entries
}

/// A tridiagonal stiffness of n freedoms, and a multiplier between every third and the one
/// after next, whose diagonal is zero.
fn saddle(n: usize) -> Sparse {
    let mut entries = Vec::new();
    for i in 0..n {
        entries.push((i, i, 4.0 + (i % 5) as f64));
        if i > 0 {
            entries.extend([(i, i - 1, -1.5), (i - 1, i, -1.0)]);
        }
    }
    for (k, i) in (0..n - 2).step_by(3).enumerate() {
        let row = n + k;
        let (near, far) = ((row, i), (row, i + 2));
        entries.extend([(near.0, near.1, 1.0), (far.0, far.1, -2.0)]);
        entries.extend([(near.1, near.0, 1.0), (far.1, far.0, -2.0)]);
    }
    matrix(n + (0..n - 2).step_by(3).count(), &entries)
}

/// Solves for a known solution.
fn check(solver: &mut StepSolver, matrix: &Sparse, tolerance: f64) {
    check_in_units(solver, matrix, tolerance, |_| 1.0);
}

/// Like [`check`], each unknown measured in its unit.
fn check_in_units(
    solver: &mut StepSolver,
    matrix: &Sparse,
    tolerance: f64,
    unit: impl Fn(usize) -> f64,
) {
    solver.factorize(matrix).unwrap();
    let n = matrix.pattern().size();
    let mut exact = scattered(99, n);
    exact
        .iter_mut()
        .enumerate()
        .for_each(|(i, x)| *x *= unit(i));
    let mut b = vec![0.0; n];
    matrix.multiply_add(&exact, &mut b);
    solver.solve(&mut b).unwrap();
    for (i, (found, exact)) in b.iter().zip(&exact).enumerate() {
        let limit = tolerance * unit(i);
        assert!((found - exact).abs() < limit, "{found} {exact}");
    }
}

/// Matrices of 60 to 300 unknowns with entries of size one have condition numbers up
/// to some 1e4: solutions agree to 1e-10.
const TOLERANCE: f64 = 1e-10;

#[test]
fn unsymmetric_systems_are_solved_again_and_again_on_the_same_pivots() {
    for (seed, n) in [(1, 60), (2, 150), (3, 300)] {
        let first = matrix(n, &unsymmetric(n, seed, 6.0));
        let mut solver = StepSolver::new(first.pattern());
        check(&mut solver, &first, TOLERANCE);
        let changes = scattered(seed + 10, first.values().len());
        for step in 1..4 {
            let mut next = first.clone();
            for (value, change) in next.values_mut().iter_mut().zip(&changes) {
                *value *= 1.0 + 0.02 * f64::from(step) * change;
            }
            check(&mut solver, &next, TOLERANCE);
        }
        let counts = solver.counts();
        assert_eq!((counts.pivotings, counts.refactorizations), (1, 3));
        assert_eq!(counts.fallbacks, 0);
    }
}

#[test]
fn multipliers_with_zero_diagonals_are_solved() {
    let matrix = saddle(90);
    let mut solver = StepSolver::new(matrix.pattern());
    check(&mut solver, &matrix, TOLERANCE);
    check(&mut solver, &matrix, TOLERANCE);
    assert_eq!(solver.counts().fallbacks, 0);
}

/// The doubled pattern of a scheme of two stages, whose unknowns are in pairs.
#[test]
fn interleaved_stages_are_solved() {
    let one = saddle(60);
    let weights = [[1.0, 0.4], [-0.3, 1.2]];
    let entries: Vec<_> = one
        .triplets()
        .flat_map(|(i, j, value)| {
            let block = |s: usize, t: usize| (2 * i + s, 2 * j + t, weights[s][t] * value);
            [block(0, 0), block(0, 1), block(1, 0), block(1, 1)]
        })
        .collect();
    let whole = matrix(2 * one.pattern().size(), &entries);
    let mut solver = StepSolver::new(whole.pattern());
    check(&mut solver, &whole, TOLERANCE);
    assert_eq!(solver.counts().fallbacks, 0);
}

/// Diagonal pivots are right for the first matrix; in the second the diagonal has nearly
/// vanished, so that the kept factors would grow without bound.
#[test]
fn pivots_that_turn_bad_are_chosen_again() {
    let n = 80;
    let strong = matrix(n, &unsymmetric(n, 5, 20.0));
    let mut solver = StepSolver::new(strong.pattern());
    check(&mut solver, &strong, TOLERANCE);
    for (diagonal, pivotings) in [(1e-13, 2), (1e-13, 2), (20.0, 2)] {
        let weak = matrix(n, &unsymmetric(n, 5, diagonal));
        let mut same_pattern = strong.clone();
        same_pattern.values_mut().copy_from_slice(weak.values());
        // The condition number of the second matrix is not prescribed: at most 1e6.
        check(&mut solver, &same_pattern, 1e-8);
        assert!(solver.counts().pivotings >= pivotings);
    }
    assert_eq!(solver.counts().fallbacks, 0);
}

/// Two unknowns in axes that turn by a third of a right angle from matrix to matrix: a diagonal that is
/// one at first is zero after each quarter of a turn. Two choices of pivots suffice for all turns.
#[test]
fn pivots_of_matrices_that_recur_are_chosen_once() {
    let n = 60;
    let strong = unsymmetric(n, 7, 20.0);
    let turned = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        let own = [[cos, -sin], [sin, cos]];
        let pair = |i: usize, j: usize| (n + i, n + j, own[i][j]);
        let coupled = [(n, 0, 0.1), (0, n + 1, 0.1)];
        let pairs = [pair(0, 0), pair(0, 1), pair(1, 0), pair(1, 1)];
        let all: Vec<_> = strong.iter().copied().chain(pairs).chain(coupled).collect();
        matrix(n + 2, &all)
    };
    let first = turned(0.0);
    let mut solver = StepSolver::new(first.pattern());
    let mut next = first.clone();
    for step in 0..60 {
        let right_angles = f64::from(step) / 3.0;
        let of = turned(right_angles * std::f64::consts::FRAC_PI_2);
        next.values_mut().copy_from_slice(of.values());
        check(&mut solver, &next, TOLERANCE);
    }
    let counts = solver.counts();
    assert_eq!((counts.pivotings, counts.fallbacks), (2, 0), "{counts:?}");
}

/// Three pairs of unknowns, each with a diagonal or an antidiagonal, in all eight combinations again and
/// again: each combination has its own pivots, which are chosen once.
#[test]
fn all_recurring_choices_of_pivots_are_stored() {
    let n = 60;
    let strong = unsymmetric(n, 8, 20.0);
    let of = |combination: usize| {
        let pairs = (0..3).flat_map(|pair| {
            let diagonal = f64::from(u8::from((combination >> pair) & 1 == 0));
            let first = n + 2 * pair;
            let entry = |i: usize, j: usize, value: f64| (first + i, first + j, value);
            let other = 1.0 - diagonal;
            let own = [
                (0, 0, diagonal),
                (0, 1, other),
                (1, 0, other),
                (1, 1, diagonal),
            ];
            own.map(|(i, j, value)| entry(i, j, value))
        });
        let all: Vec<_> = strong.iter().copied().chain(pairs).collect();
        matrix(n + 6, &all)
    };
    let first = of(0);
    let mut solver = StepSolver::new(first.pattern());
    let mut next = first.clone();
    for step in 0..80 {
        next.values_mut().copy_from_slice(of(step % 8).values());
        check(&mut solver, &next, TOLERANCE);
    }
    let counts = solver.counts();
    assert_eq!((counts.pivotings, counts.refactorizations), (8, 72));
    assert_eq!(counts.fallbacks, 0);
}

/// The last pivot, 1e-18, counts as zero beside entries of one; the general factorization solves
/// the system.
#[test]
fn pivots_that_look_like_zero_are_left_to_the_general_factorization() {
    let entries = [
        (0, 0, 1.0),
        (0, 1, 1.0),
        (1, 0, 1e-18),
        (1, 2, 1.0),
        (2, 2, 1.0),
    ];
    let matrix = matrix(3, &entries);
    let mut solver = StepSolver::new(matrix.pattern());
    solver.factorize(&matrix).unwrap();
    assert_eq!(solver.counts().fallbacks, 1);
    // A (1e18, 1e18, 3)
    let mut b = [2e18, 4.0, 3.0];
    solver.solve(&mut b).unwrap();
    for (found, exact) in b.iter().zip([1e18, 1e18, 3.0]) {
        assert!((found / exact - 1.0).abs() < 1e-14, "{b:?}");
    }
}

/// Equations in units that are ten orders of magnitude apart.
#[test]
fn scales_of_equations_and_unknowns_do_not_matter() {
    let mut stiff = saddle(60);
    let pattern = Arc::clone(stiff.pattern());
    let scale = |i: usize| 10.0_f64.powi([-5, 0, 5][i % 3]);
    for j in 0..pattern.size() {
        for at in pattern.column_starts()[j]..pattern.column_starts()[j + 1] {
            stiff.values_mut()[at] *= scale(pattern.rows()[at] as usize) * scale(j + 1);
        }
    }
    let mut solver = StepSolver::new(&pattern);
    check_in_units(&mut solver, &stiff, TOLERANCE, |j| 1.0 / scale(j + 1));
}

#[test]
fn singular_and_undefined_matrices_have_no_solution() {
    let all = [(0, 0, 1.0), (1, 0, 1.0), (0, 1, 1.0), (1, 1, 1.0)];
    let singular = matrix(2, &all);
    let mut solver = StepSolver::new(singular.pattern());
    assert!(solver.factorize(&singular).is_none());
    assert!(solver.solve(&mut [1.0, 2.0]).is_none());

    let mut regular = singular.clone();
    regular.values_mut()[0] = 3.0;
    check(&mut solver, &regular, TOLERANCE);
    assert!(solver.solve(&mut [f64::NAN, 2.0]).is_none());

    // Starting from the pivots of a regular matrix too.
    assert!(solver.factorize(&singular).is_none());
    solver.factorize(&regular).unwrap();
    let mut undefined = regular.clone();
    undefined.values_mut()[2] = f64::NAN;
    assert!(solver.factorize(&undefined).is_none());
    assert!(solver.solve(&mut [1.0, 2.0]).is_none());

    solver.factorize(&regular).unwrap();
    solver.forget();
    assert!(solver.solve(&mut [1.0, 2.0]).is_none());
}

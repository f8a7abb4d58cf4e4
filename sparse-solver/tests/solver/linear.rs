//! Small systems by the general factorization.

use std::sync::Arc;

use sparse_solver::{LinearSolver, Pattern, Sparse};

fn solver(indices: Vec<(usize, usize)>, values: &[f64]) -> (LinearSolver, Sparse) {
    let n = indices.iter().map(|index| index.0 + 1).max().unwrap_or(0);
    let pattern = Arc::new(Pattern::new(n, indices));
    let mut matrix = Sparse::zero(Arc::clone(&pattern));
    matrix.values_mut().copy_from_slice(values);
    (LinearSolver::new(&pattern), matrix)
}

#[test]
fn badly_scaled_unsymmetric_systems_are_solved() {
    // [1e9 2e-3; 3e4 0], x = (2, -5e8): b = (2e9 - 1e6, 6e4).
    let indices = vec![(0, 0), (1, 0), (0, 1)];
    let (solver, matrix) = solver(indices, &[1e9, 3e4, 2e-3]);
    let factorization = solver.factorize(matrix).unwrap();
    let mut b = [2e9 - 1e6, 6e4];
    factorization.solve(&mut b).unwrap();
    assert!((b[0] - 2.0).abs() < 1e-12);
    assert!((b[1] / -5e8 - 1.0).abs() < 1e-10);
}

#[test]
fn singular_matrices_give_no_solution() {
    let indices = vec![(0, 0), (1, 0), (0, 1), (1, 1)];
    let (solver, matrix) = solver(indices, &[1.0, 1.0, 1.0, 1.0]);
    let solution = solver.factorize(matrix).and_then(|f| {
        let mut b = [1.0, 2.0];
        f.solve(&mut b)
    });
    assert!(solution.is_none());
}

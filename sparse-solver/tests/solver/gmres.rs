//! GMRES on matrices whose number of products is known.

use sparse_solver::{Preconditioner, gmres};

/// Pseudorandom numbers between -1 and 1.
pub fn scattered(count: usize, seed: usize) -> Vec<f64> {
    (0..count)
        .map(|i| (1.0 + 12.9898 * (i + 1) as f64 + 78.233 * seed as f64).sin() * 43758.5453)
        .map(|x| 2.0 * (x - x.floor()) - 1.0)
        .collect()
}

// The identity plus a matrix of rank 4 has 5 different eigenvalues at most: five products.
#[test]
fn a_matrix_of_few_eigenvalues_needs_few_products() {
    for seed in 0..200 {
        let n = 5 + seed % 20;
        let (left, right) = (scattered(4 * n, seed), scattered(4 * n, seed + 1000));
        let multiply = |x: &[f64]| -> Vec<f64> {
            let mut y = x.to_vec();
            for (l, r) in left.chunks(n).zip(right.chunks(n)) {
                let part: f64 = r.iter().zip(x).map(|(r, x)| r * x).sum();
                y.iter_mut().zip(l).for_each(|(y, l)| *y += 0.1 * part * l);
            }
            y
        };
        let x = scattered(n, seed + 2000);
        let b = multiply(&x);
        let mut product = |v: &mut [f64]| {
            v.copy_from_slice(&multiply(v));
            Some(())
        };
        let found = gmres(&mut product, &b, (1e-12, n), &mut Preconditioner::default()).unwrap();
        assert!(found.products <= 5, "{}", found.products);
        // Condition numbers are below 1e3.
        let error = found.x.iter().zip(&x).map(|(a, b)| (a - b).abs());
        assert!(error.fold(0.0, f64::max) < 1e-8, "{seed}");
    }
}

// `A P` is the identity on the space of the first solution, which has the range of `A - I`, and adds a vector of it to
// any other: it has the minimal polynomial (x - 1)^2, two products. A matrix that differs by 1e-10 leaves 1e-7 of
// the residual after two products, at condition numbers of 1e3, and its square after four.
#[test]
fn systems_after_the_first_need_fewer_products() {
    for seed in 0..200 {
        let n = 10 + seed % 20;
        let (left, right) = (scattered(4 * n, seed), scattered(4 * n, seed + 1000));
        let multiply = |x: &[f64], size: f64| -> Vec<f64> {
            let mut y = x.to_vec();
            for (l, r) in left.chunks(n).zip(right.chunks(n)) {
                let part: f64 = r.iter().zip(x).map(|(r, x)| r * x).sum();
                y.iter_mut().zip(l).for_each(|(y, l)| *y += size * part * l);
            }
            y.iter_mut().zip(x.iter().rev()).for_each(|(y, x)| *y += (size - 0.1) * x);
            y
        };
        let mut preconditioner = Preconditioner::default();
        for (system, (size, most)) in [(0.1, 5), (0.1, 2), (0.1 + 1e-10, 4)].into_iter().enumerate() {
            let x = scattered(n, seed + 2000 + system);
            let b = multiply(&x, size);
            let mut product = |v: &mut [f64]| {
                v.copy_from_slice(&multiply(v, size));
                Some(())
            };
            let found = gmres(&mut product, &b, (1e-11, n), &mut preconditioner).unwrap();
            assert!(found.products <= most, "{seed} {system}: {}", found.products);
            // Condition numbers are below 1e3.
            let error = found.x.iter().zip(&x).map(|(a, b)| (a - b).abs());
            assert!(error.fold(0.0, f64::max) < 1e-7, "{seed} {system}");
        }
    }
}

#[test]
fn a_singular_matrix_leaves_a_residual() {
    let mut product = |v: &mut [f64]| {
        v[1] = 0.0;
        Some(())
    };
    let found = gmres(&mut product, &[1.0, 1.0], (1e-9, 10), &mut Preconditioner::default()).unwrap();
    assert!(found.residual > 0.5 && found.residual < 0.8);
}

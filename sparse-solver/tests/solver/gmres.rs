//! GMRES on matrices whose number of products is known.

use sparse_solver::gmres;

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
        let found = gmres(&mut product, &b, (1e-12, n)).unwrap();
        assert!(found.products <= 5, "{}", found.products);
        // Condition numbers are below 1e3.
        let error = found.x.iter().zip(&x).map(|(a, b)| (a - b).abs());
        assert!(error.fold(0.0, f64::max) < 1e-8, "{seed}");
    }
}

#[test]
fn a_singular_matrix_leaves_a_residual() {
    let mut product = |v: &mut [f64]| {
        v[1] = 0.0;
        Some(())
    };
    let found = gmres(&mut product, &[1.0, 1.0], (1e-9, 10)).unwrap();
    assert!(found.residual > 0.5 && found.residual < 0.8);
}

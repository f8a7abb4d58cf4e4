//! Dominant pairs of maps with known eigenvalues.

use faer::c64;
use sparse_solver::{LinearMap, largest};

/// A diagonal map in turned axes: blocks `r [c -s; s c]` and real values.
struct Blocks(Vec<(f64, f64)>);

impl LinearMap for Blocks {
    fn size(&self) -> usize {
        2 * self.0.len()
    }

    fn apply(&self, x: &mut [f64]) -> Option<()> {
        for (pair, (r, angle)) in x.chunks_mut(2).zip(&self.0) {
            let (a, b) = (pair[0], pair[1]);
            let (s, c) = angle.sin_cos();
            (pair[0], pair[1]) = (r * (c * a - s * b), r * (s * a + c * b));
        }
        Some(())
    }

    fn project(&self, _: &mut [f64]) -> Option<()> {
        Some(())
    }
}

// Each pair twice, and all of them if the space is whole.
#[test]
fn repeated_pairs_are_found_as_often_as_they_occur() {
    let map = Blocks(vec![(0.9, 0.7), (0.9, 0.7), (0.5, 0.2), (0.1, 1.0)]);
    let found = largest(&map, 8, 50).unwrap();
    assert_eq!(found.dimension, Some(8));
    let sizes: Vec<_> = found.pairs.iter().map(|pair| pair.value.norm()).collect();
    for (found, expected) in sizes.iter().zip([0.9, 0.9, 0.5, 0.1]) {
        assert!((found - expected).abs() < 1e-12, "{sizes:?}");
    }
    assert_eq!(sizes.len(), 4);
}

// Hundreds of maps of up to 80 dimensions: the two largest pairs from part of the space.
#[test]
fn the_largest_pairs_of_large_maps() {
    for seed in 0..200_usize {
        let rest = (0..10 + seed % 30).map(|i| (0.6 * (0.8_f64).powi(i as i32), i as f64));
        let first = [(0.99, 0.3 + 0.01 * seed as f64), (0.9, 1.0)];
        let map = Blocks(first.into_iter().chain(rest).collect());
        let found = largest(&map, 4, 60).unwrap();
        for (pair, (r, angle)) in found.pairs.iter().zip(first) {
            let expected = c64::new(r * f64::cos(angle), (r * f64::sin(angle)).abs());
            assert!((pair.value - expected).norm() < 1e-9, "{seed}: {pair:?}");
        }
    }
}

// Four copies of a pair among others, hundreds of times: their vectors are orthonormal in the space of the
// method, and each is a vector of the map. A dense solver returns vectors of copies that are parallel to 1e-4.
#[test]
fn vectors_of_repeated_pairs_are_independent() {
    for seed in 0..200_usize {
        let angle = 0.3 + 0.01 * seed as f64;
        let rest = (0..4).map(|i| (0.5 * (0.8_f64).powi(i), 0.2 + f64::from(i)));
        let map = Blocks(std::iter::repeat_n((0.9, angle), 4).chain(rest).collect());
        let found = largest(&map, 16, 50).unwrap();
        let copies = &found.pairs[..4];
        for (number, a) in copies.iter().enumerate() {
            let size = (a.value.norm() - 0.9).abs();
            assert!(size < 1e-12 && a.residual < 1e-12, "{seed}: {a:?}");
            for b in &copies[..number] {
                let entries = |k: usize| {
                    let at =
                        |own: &sparse_solver::Ritz| c64::new(own.vector[0][k], own.vector[1][k]);
                    at(a).conj() * at(b)
                };
                let product = (0..16).fold(c64::new(0.0, 0.0), |sum, k| sum + entries(k));
                assert!(product.norm() < 1e-9, "{seed}: {product}");
            }
            let mut parts = a.vector.clone();
            parts.iter_mut().for_each(|part| map.apply(part).unwrap());
            for k in 0..16 {
                let image = c64::new(parts[0][k], parts[1][k]);
                let own = a.value * c64::new(a.vector[0][k], a.vector[1][k]);
                assert!((image - own).norm() < 1e-9, "{seed}: {image} {own}");
            }
        }
    }
}

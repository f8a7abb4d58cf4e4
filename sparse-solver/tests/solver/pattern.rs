//! Positions of entries, and products.

use std::sync::Arc;

use sparse_solver::{Pattern, Sparse};

#[test]
fn repeated_positions_count_once_and_products_match_the_dense_ones() {
    let indices = vec![(2, 1), (0, 0), (1, 2), (0, 0), (1, 1)];
    let pattern = Arc::new(Pattern::new(3, indices));
    assert_eq!(pattern.entries(), 4);
    assert_eq!(pattern.index(2, 2), None);
    let mut a = Sparse::zero(Arc::clone(&pattern));
    a.values_mut().copy_from_slice(&[2.0, 3.0, 4.0, 5.0]);
    // Columns: (2, 0, 0), (0, 3, 4), (0, 5, 0).
    let mut y = vec![1.0; 3];
    a.multiply_add(&[1.0, 10.0, 100.0], &mut y);
    assert_eq!(y, [3.0, 531.0, 41.0]);
    assert_eq!(a.entry(2, 1), 4.0);
    assert_eq!(a.plus(-1.0, &a).triplets().map(|t| t.2).sum::<f64>(), 0.0);
}

//! Sparse Cholesky factors on random band matrices: solutions, pivots and failures.

use faer::c64;
use sparse_solver::{
    Cholesky, CholeskyBlocks, CholeskyError, CholeskyNumber, Definiteness, Triangle, minimum_degree,
};

use crate::gmres::scattered;

/// Columns below and above the diagonal.
const BAND: usize = 3;

/// Column starts and rows of a triangle of a band matrix.
fn triangle(n: usize, is_lower: bool) -> (Vec<u32>, Vec<u32>) {
    let (mut starts, mut rows) = (vec![0], Vec::new());
    for j in 0..n {
        let range = if is_lower {
            j..n.min(j + BAND + 1)
        } else {
            j.saturating_sub(BAND)..j + 1
        };
        rows.extend(range.map(|i| i as u32));
        starts.push(rows.len() as u32);
    }
    (starts, rows)
}

/// The factor of the matrix whose entry below the diagonal is `of(row, column)`.
fn factor<T: CholeskyNumber>(
    n: usize,
    of: impl Fn(usize, usize) -> T,
    definiteness: Definiteness,
) -> Result<Cholesky<T>, CholeskyError> {
    let (starts, rows) = triangle(n, false);
    let upper = Triangle {
        starts: &starts,
        rows: &rows,
    };
    let blocks = CholeskyBlocks::new(upper).ok_or(CholeskyError::OutOfMemory)?;
    let (starts, rows) = triangle(n, true);
    let lower = Triangle {
        starts: &starts,
        rows: &rows,
    };
    let entry = |j: usize, at: usize| of(rows[at] as usize, j);
    let column = |j: usize| (starts[j] as usize..starts[j + 1] as usize).map(move |at| (j, at));
    let entries: Vec<T> = (0..n)
        .flat_map(column)
        .map(|(j, at)| entry(j, at))
        .collect();
    Cholesky::new(blocks, (lower, &entries), definiteness)
}

// A diagonal of 12 beside six entries of at most 1.42: the condition is below 20.5/3.5, the errors a
// few units of round-off.
#[test]
fn solutions_satisfy_the_equations() {
    for case in 0..100 {
        let n = 1 + case % 23;
        let mut numbers = scattered(2 * n * (n + 1), case).into_iter();
        let mut number = || c64::new(numbers.next().unwrap(), numbers.next().unwrap());
        let is_quasi = case % 2 == 1;
        let drawn: Vec<c64> = (0..n * n).map(|_| number()).collect();
        let of = |i: usize, j: usize| match i == j {
            false => drawn[i + n * j],
            true if is_quasi && i % 2 == 1 => c64::new(-12.0, 0.0),
            true => c64::new(12.0, 0.0),
        };
        let definiteness = match is_quasi {
            true => Definiteness::Quasi,
            false => Definiteness::Positive,
        };
        let x: Vec<c64> = (0..n).map(|_| number()).collect();
        let whole = |i: usize, j: usize| match i.abs_diff(j) {
            0..=BAND if i >= j => of(i, j),
            0..=BAND => of(j, i).conj(),
            _ => c64::new(0.0, 0.0),
        };
        let product = |i: usize| (0..n).map(|j| whole(i, j) * x[j]).sum::<c64>();
        let mut b: Vec<c64> = (0..n).map(product).collect();
        let complex = factor(n, of, definiteness).unwrap();
        complex.solve(&mut b).unwrap();
        for (found, expected) in b.iter().zip(&x) {
            assert!((found - expected).norm() < 1e-13, "case {case}");
        }

        let real = factor(n, |i, j| of(i, j).re, definiteness).unwrap();
        let product = |i: usize| (0..n).map(|j| whole(i, j).re * x[j].re).sum::<f64>();
        let mut b: Vec<f64> = (0..n).map(product).collect();
        real.solve(&mut b).unwrap();
        for (found, expected) in b.iter().zip(&x) {
            assert!((found - expected.re).abs() < 1e-13, "case {case}");
        }
        if is_quasi {
            for (row, pivot) in real.pivots().enumerate() {
                assert_eq!(pivot > 0.0, row % 2 == 0, "inertia, case {case}");
            }
        } else {
            assert!(real.pivots().all(|pivot| pivot > 0.0));
        }
        assert_eq!((real.rows(), real.pivots().count()), (n, n));
        assert!(real.entries() >= n);
    }
}

#[test]
fn a_negative_pivot_has_its_row() {
    let of = |i: usize, j: usize| match (i, j) {
        (4, 4) => -1.0,
        _ if i == j => 1.0,
        _ => 0.0,
    };
    let found = factor(7, of, Definiteness::Positive).unwrap_err();
    assert_eq!(found, CholeskyError::Pivot(4));
    let quasi = factor(7, of, Definiteness::Quasi).unwrap();
    let pivots: Vec<f64> = quasi.pivots().collect();
    assert_eq!(pivots, [1.0, 1.0, 1.0, 1.0, -1.0, 1.0, 1.0]);
}

// The center of a star, eliminated first, would connect all others: it comes last or beside one.
#[test]
fn the_center_of_a_star_is_eliminated_late() {
    let n = 9;
    let mut rows: Vec<u32> = (0..n).collect();
    let mut starts = vec![0, rows.len() as u32];
    for i in 1..n {
        rows.extend([0, i]);
        starts.push(rows.len() as u32);
    }
    let order = minimum_degree(Triangle {
        starts: &starts,
        rows: &rows,
    })
    .unwrap();
    let center = order.iter().position(|&node| node == 0).unwrap();
    assert!(center >= 7, "{order:?}");
    let mut sorted = order;
    sorted.sort_unstable();
    assert!(sorted.into_iter().eq(0..n));
}

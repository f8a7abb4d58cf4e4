use super::*;
use crate::element::cell_points;
use crate::element::line::Line;
use crate::element::strain::{NO_COLUMNS, strain_at};
use approx::assert_relative_eq;
use nalgebra::DMatrix;

/// A law without symmetry, positive definite by diagonal dominance.
fn law() -> Matrix6<f64> {
    Matrix6::from_fn(|i, j| {
        let (i, j) = (i.min(j), i.max(j));
        let spread = 0.1 * ((3 * i + 5 * j) % 7) as f64;
        if i == j { 3.0 + spread } else { spread }
    })
}

/// A distorted cell, its sides curved where the kind allows it.
fn distorted(kind: CellKind) -> Vec<[f64; 2]> {
    kind.reference_nodes()
        .iter()
        .map(|&[r, s]| {
            [
                0.4 + r + 0.1 * r * s + 0.05 * s * s,
                -0.3 + 1.2 * s - 0.07 * r * r,
            ]
        })
        .collect()
}

/// The strain operators column by column: B0 (6 x 3 nodes) and Bpsi, as the strains of unit
/// displacements and unit generalized strains.
fn operators(point: &CellPoint) -> (DMatrix<f64>, DMatrix<f64>) {
    let mut b0 = DMatrix::zeros(6, 3 * point.count);
    for node in 0..point.count {
        let mut unit = NO_COLUMNS;
        unit[node].fixed_view_mut::<3, 3>(0, 0).fill_with_identity();
        let strain = strain_at(&Line::STRAIGHT, point, None, Some(&unit), &Matrix6::zeros());
        b0.columns_mut(3 * node, 3)
            .copy_from(&strain.fixed_columns::<3>(0));
    }
    let bpsi = strain_at(&Line::STRAIGHT, point, None, None, &Matrix6::identity());
    (b0, DMatrix::from_column_slice(6, 6, bpsi.as_slice()))
}

/// Oracle: each matrix by its definition, `sum B' D B w` with full operators.
/// The blocks do the same sums in another order: round-off only.
#[test]
fn blocks_are_the_integrals_of_the_strain_operators() {
    let d = law();
    let dense = DMatrix::from_column_slice(6, 6, d.as_slice());
    for kind in CellKind::ALL {
        let nodes = distorted(kind);
        let n = 3 * nodes.len();
        let mut e = DMatrix::<f64>::zeros(n, n);
        let mut r = DMatrix::<f64>::zeros(n, 6);
        let mut a = DMatrix::<f64>::zeros(6, 6);
        for point in cell_points(kind, &nodes) {
            let (b0, bpsi) = operators(&point);
            e += b0.transpose() * &dense * &b0 * point.area;
            r += b0.transpose() * &dense * &bpsi * point.area;
            a += bpsi.transpose() * &dense * &bpsi * point.area;
        }

        let integrals = CellIntegrals::new(kind, &nodes).expect("positive area");
        let blocks = CellBlocks {
            integrals: &integrals,
            law: &LawBlocks::new(&d),
        };
        for i in 0..nodes.len() {
            for j in 0..nodes.len() {
                let expected: Matrix3<f64> = e.fixed_view::<3, 3>(3 * i, 3 * j).into_owned();
                assert_relative_eq!(blocks.e(i, j), expected, epsilon = 1e-13);
            }
            let expected: Matrix3x6<f64> = r.fixed_view::<3, 6>(3 * i, 0).into_owned();
            assert_relative_eq!(blocks.r(i), expected, epsilon = 1e-13);
        }
        let expected: Matrix6<f64> = a.fixed_view::<6, 6>(0, 0).into_owned();
        assert_relative_eq!(
            blocks.law.a_of_moments(integrals.area()),
            expected,
            epsilon = 1e-13
        );
    }
}

/// Rigid motions of the cell: E H = R T and R' H = A T with T = [0, e1 x; 0, 0],
/// to round-off.
#[test]
fn blocks_meet_the_rigid_body_identities() {
    let mut t = Matrix6::zeros();
    t[(1, 5)] = -1.0;
    t[(2, 4)] = 1.0;
    for kind in CellKind::ALL {
        let nodes = distorted(kind);
        let integrals = CellIntegrals::new(kind, &nodes).expect("positive area");
        let blocks = CellBlocks {
            integrals: &integrals,
            law: &LawBlocks::new(&law()),
        };
        let h: Vec<Matrix3x6<f64>> = nodes
            .iter()
            .map(|&[y, z]| rigid_displacement(1.0, y, z))
            .collect();
        for i in 0..nodes.len() {
            let eh: Matrix3x6<f64> = (0..nodes.len()).map(|j| blocks.e(i, j) * h[j]).sum();
            assert_relative_eq!(eh, blocks.r(i) * t, epsilon = 1e-12);
        }
        let rh: Matrix6<f64> = (0..nodes.len()).map(|i| blocks.r(i).tr_mul(&h[i])).sum();
        assert_relative_eq!(
            rh,
            blocks.law.a_of_moments(integrals.area()) * t,
            epsilon = 1e-12
        );
    }
}

#[test]
fn inverted_and_flat_cells_are_refused() {
    let inverted = [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0]];
    assert!(CellIntegrals::new(CellKind::Triangle3, &inverted).is_err_and(|area| area < 0.0));
    let flat = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]];
    assert!(CellIntegrals::new(CellKind::Triangle3, &flat).is_err_and(|area| area == 0.0));
}

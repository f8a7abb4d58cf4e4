//! Rigid bodies that hold the mass of a blade.

use nalgebra::{Matrix3, Matrix6, Vector3};

use super::EVALUATION;
use crate::blade::Blade;
use crate::line::{Curve, Placed, Side};
use crate::rotation::skew;
use crate::{quadrature, wrench};

/// Points of the Gauss rule on a piece: exact for a linear mass matrix on a line of
/// constant curvature up to terms of the fifth order in its length.
const RULE: usize = 4;

/// A body at a node, in the axes of the node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Body {
    /// Index of the node.
    pub node: usize,
    /// Mass [kg].
    pub mass: f64,
    /// Center of mass from the node [m].
    pub center: Vector3<f64>,
    /// Moments of inertia about the center of mass [kg m^2].
    pub inertia: Matrix3<f64>,
    /// The greatest entry that no rigid body has, as part of the diagonal [-].
    pub beyond: f64,
}

/// The bodies of elements between `positions`, whose nodes are `nodes`.
pub(super) fn of(blade: &Blade, curve: &Curve, positions: &[f64], nodes: &[Placed]) -> Vec<Body> {
    let mut matrices = vec![Matrix6::zeros(); nodes.len()];
    for (e, two) in positions.windows(2).enumerate() {
        let (middle, half) = (0.5 * (two[0] + two[1]), 0.5 * (two[1] - two[0]));
        let [inner, outer] = [-1.0, 1.0].map(|side| middle + side * EVALUATION * half);
        let pieces = [(two[0], inner), (inner, outer), (outer, two[1])];
        for (i, (from, to)) in pieces.into_iter().enumerate() {
            let node = 2 * e + i;
            if let (Some(matrix), Some(at)) = (matrices.get_mut(node), nodes.get(node)) {
                *matrix += piece(blade, curve, from, to, at);
            }
        }
    }
    let bodies = matrices.iter().enumerate();
    bodies
        .filter_map(|(node, matrix)| body(node, matrix))
        .collect()
}

/// The mass matrix of the slices from `from` to `to`, about a node, in its axes.
fn piece(blade: &Blade, curve: &Curve, from: f64, to: f64, node: &Placed) -> Matrix6<f64> {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let rule = quadrature::line(RULE);
    let slices = rule.iter().map(|&(xi, weight)| {
        let s = middle + xi * half;
        let slice = curve.at(s);
        let mass = blade.at(s, Side::Outer).1;
        let turned = wrench::rotate(&mass, &slice.axes.tr_mul(&node.axes));
        let to_node = node.axes.tr_mul(&(node.position - slice.position));
        wrench::shift(&turned, &to_node) * (weight * half)
    });
    slices.sum()
}

/// The rigid body nearest to a mass matrix; `None` without mass.
fn body(node: usize, matrix: &Matrix6<f64>) -> Option<Body> {
    let mass = (matrix[(0, 0)] + matrix[(1, 1)] + matrix[(2, 2)]) / 3.0;
    if mass <= 0.0 {
        return None;
    }
    // The block of forces and rotations is -m [c]x.
    let block = matrix.fixed_view::<3, 3>(0, 3) / -mass;
    let center = Vector3::new(
        0.5 * (block[(2, 1)] - block[(1, 2)]),
        0.5 * (block[(0, 2)] - block[(2, 0)]),
        0.5 * (block[(1, 0)] - block[(0, 1)]),
    );
    let cross = skew(&center);
    let about_node = matrix.fixed_view::<3, 3>(3, 3);
    let own = about_node + mass * cross * cross;
    let inertia = 0.5 * (own + own.transpose());
    let mut rigid = Matrix6::zeros();
    rigid.fixed_view_mut::<3, 3>(0, 0).fill_diagonal(mass);
    rigid.fixed_view_mut::<3, 3>(3, 3).copy_from(&inertia);
    let rigid = wrench::shift(&rigid, &-center);
    let size = |i: usize, j: usize| (matrix[(i, i)] * matrix[(j, j)]).abs().sqrt();
    let pairs = (0..6).flat_map(|i| (0..6).map(move |j| (i, j)));
    let beyond = pairs.map(|(i, j)| {
        let off = (rigid[(i, j)] - matrix[(i, j)]).abs();
        if off > 0.0 { off / size(i, j) } else { 0.0 }
    });
    Some(Body {
        node,
        mass,
        center,
        inertia,
        beyond: beyond.fold(0.0, f64::max),
    })
}

//! Strain and stress at all integration points per unit internal force.
//!
//! Both are linear in the internal force,
//!
//! ```text
//! sigma(theta) = sum_i theta_i sigma(e_i)
//! ```
//!
//! so that six recoveries serve all forces.

use nalgebra::{Matrix6, Vector6};

use super::recoverer::Recoverer;
use super::state::{LoadCase, PointState, Tensors};
use crate::failure::Failure;

/// Strain and stress at an integration point per unit internal force, a column for each of
/// [`shared_geom::wrench::COMPONENTS`] \[1/N, 1/(N m), 1/m^2, 1/m^3\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnitPoint {
    /// Cell: index in the mesh of the section.
    pub cell: usize,
    /// Position (y, z) \[m\].
    pub position: [f64; 2],
    /// In section axes, rows xx yy zz yz xz xy.
    strain: Matrix6<f64>,
    stress: Matrix6<f64>,
    /// In material axes, rows 11 22 33 23 13 12.
    pub(super) material_strain: Matrix6<f64>,
    pub(super) material_stress: Matrix6<f64>,
}

impl UnitPoint {
    fn new(unit: &[Vec<PointState>], number: usize) -> Self {
        let columns = |of: fn(&Tensors) -> Vector6<f64>| {
            let columns: Vec<_> = unit
                .iter()
                .map(|points| of(&points[number].tensors))
                .collect();
            Matrix6::from_columns(&columns)
        };
        Self {
            cell: unit[0][number].cell,
            position: unit[0][number].position,
            strain: columns(|tensors| tensors.strain),
            stress: columns(|tensors| tensors.stress),
            material_strain: columns(|tensors| tensors.material_strain),
            material_stress: columns(|tensors| tensors.material_stress),
        }
    }

    /// The mean of several points with these weights; `None` without any.
    pub(super) fn mean(points: &[Self], weights: &[f64]) -> Option<Self> {
        let (first, all) = (points.first()?, weights.iter().sum::<f64>());
        let mean = |of: fn(&Self) -> Matrix6<f64>| {
            let parts = points.iter().zip(weights);
            parts
                .map(|(point, weight)| of(point) * (weight / all))
                .sum::<Matrix6<f64>>()
        };
        Some(Self {
            strain: mean(|point| point.strain),
            stress: mean(|point| point.stress),
            material_strain: mean(|point| point.material_strain),
            material_stress: mean(|point| point.material_stress),
            ..*first
        })
    }

    /// Strain and stress under the internal force `theta` about the reference point \[N, N m\].
    pub fn under(&self, theta: &Vector6<f64>) -> Tensors {
        Tensors {
            strain: self.strain * theta,
            stress: self.stress * theta,
            material_strain: self.material_strain * theta,
            material_stress: self.material_stress * theta,
        }
    }
}

/// Sizes of the stresses of the components of the internal force: sums over all points.
pub(super) fn weights(points: &[UnitPoint]) -> Vector6<f64> {
    let of_point = |point: &UnitPoint| point.material_stress.abs().row_sum().transpose();
    points.iter().map(of_point).sum()
}

impl Recoverer<'_> {
    /// Strain and stress at all integration points per unit internal force, in the order of
    /// [`super::Recovery::points`].
    ///
    /// # Errors
    /// As [`Recoverer::recover`].
    pub fn unit_points(&self) -> Result<Vec<UnitPoint>, Failure> {
        let mut unit = Vec::with_capacity(6);
        for i in 0..6 {
            let load = LoadCase::at_point("unit", &Vector6::ith(i, 1.0), [0.0; 2]);
            unit.push(self.recover(&load)?.points);
        }
        let points = 0..unit[0].len();
        Ok(points.map(|number| UnitPoint::new(&unit, number)).collect())
    }
}

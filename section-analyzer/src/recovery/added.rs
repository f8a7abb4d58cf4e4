//! The strain that a distributed load adds to the strain of the internal force.
//!
//! ```text
//! u' = X T' theta + w'      u = X theta + w      psi = Y theta + y
//! eps = G theta + B1 w' + B0 w + Bpsi y                                           (S-108)
//! ```

use super::recoverer::Recoverer;
use super::resultant::{face_stress, force_size};
use super::state::PointState;
use crate::assembly::largest;
use crate::element::{CellPoint, NO_COLUMNS, NodalColumns, cell_points, strain_at};
use crate::solution::DistributedState;
use nalgebra::{DVector, Matrix6, Vector6};
use shared_geom::wrench;

impl Recoverer<'_> {
    /// The strain that `state` adds at the integration points of a cell, order
    /// yz yy zz xx xy xz.
    pub(super) fn added_strains(&self, cell: usize, state: &DistributedState) -> Vec<Vector6<f64>> {
        let kind = self.section().mesh.cells[cell].kind;
        let positions = self.positions(cell);
        let fields = self.added_fields(cell, state);
        cell_points(kind, &positions)
            .map(|point| self.strain_of(&fields, &point))
            .collect()
    }

    /// The strain that `state` adds at a point of a cell, order yz yy zz xx xy xz.
    pub(super) fn added_strain(
        &self,
        cell: usize,
        state: &DistributedState,
        point: &CellPoint,
    ) -> Vector6<f64> {
        self.strain_of(&self.added_fields(cell, state), point)
    }

    /// The reference force \[N\] for the error of a distributed load, as its stresses have
    /// no resultant: the integral of the size of the stresses on the face, or the load over
    /// a length equal to the size of the section.
    pub(super) fn size_of(&self, state: &DistributedState, points: &[PointState]) -> f64 {
        let per_length = wrench::shift_matrix(&self.offset()) * state.force_per_length;
        let load = force_size(&per_length, self.size()) * self.size();
        largest(face_stress(points), load)
    }

    /// w', w at the nodes of a cell and y about the centroid, each in the first column.
    fn added_fields(
        &self,
        cell: usize,
        state: &DistributedState,
    ) -> (NodalColumns, NodalColumns, Matrix6<f64>) {
        let nodes = self.section().mesh.cells[cell].nodes();
        let at_nodes = |field: &DVector<f64>| {
            let mut columns = NO_COLUMNS;
            for (column, &node) in columns.iter_mut().zip(nodes) {
                column.set_column(0, &field.fixed_rows::<3>(3 * node as usize));
            }
            columns
        };
        let back = wrench::shift_matrix(&-self.offset());
        let mut strain = Matrix6::zeros();
        strain.set_column(0, &(back.transpose() * state.strain));
        (at_nodes(&state.rate), at_nodes(&state.warping), strain)
    }

    fn strain_of(
        &self,
        (rate, warping, strain): &(NodalColumns, NodalColumns, Matrix6<f64>),
        point: &CellPoint,
    ) -> Vector6<f64> {
        let strain = strain_at(self.line(), point, Some(rate), Some(warping), strain);
        strain.column(0).into_owned()
    }
}

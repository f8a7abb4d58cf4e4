//! Strain of imposed states: the strain of the section minus the free strain of the
//! material.
//!
//! ```text
//! eps - eps_p = B0 x + Bpsi psi_T - eps_p                       sigma = D (eps - eps_p)   (S-95)
//! ```

use nalgebra::{DVector, Matrix6, Vector6};

use super::state::LoadCase;
use crate::element::{CellPoint, Line, NO_COLUMNS, NodalColumns, strain_at};
use crate::failure::Failure;
use crate::material::section_strain;
use crate::section::{FreeStrain, Section};
use crate::solution::ImposedSolution;

/// The sum of the imposed states of a load.
#[derive(Debug, Clone)]
pub(super) struct Imposed {
    /// x: warping, rows ux, uy, uz of each node of the mesh \[m\].
    warping: DVector<f64>,
    /// Potential at each node of the mesh \[V\].
    pub potential: DVector<f64>,
    /// psi_T, about the reference point \[-, 1/m\].
    pub strain: Vector6<f64>,
    /// Free strain of each cell.
    cells: Vec<FreeStrain>,
}

impl Imposed {
    /// The states named by `load`, out of the known states; `None` for a load without any.
    ///
    /// # Errors
    /// [`Failure::UnknownState`] for an unknown state.
    pub fn of_load(
        section: &Section,
        known: &[ImposedSolution],
        load: &LoadCase,
    ) -> Result<Option<Self>, Failure> {
        if load.imposed.is_empty() {
            return Ok(None);
        }
        let mut sum = Self {
            warping: DVector::zeros(3 * section.mesh.nodes.len()),
            potential: DVector::zeros(section.mesh.nodes.len()),
            strain: Vector6::zeros(),
            cells: vec![FreeStrain::default(); section.cells.len()],
        };
        for name in &load.imposed {
            let found = known.iter().find(|known| known.state.name == *name);
            let Some(found) = found else {
                return Err(Failure::UnknownState {
                    load: load.name.clone(),
                    state: name.clone(),
                });
            };
            sum.warping += &found.warping;
            sum.potential += &found.potential;
            sum.strain += found.free_strain;
            for (sum, own) in sum.cells.iter_mut().zip(&found.state.cells) {
                sum.at_origin += own.at_origin;
                sum.by_y += own.by_y;
                sum.by_z += own.by_z;
            }
        }
        Ok(Some(sum))
    }

    /// The strain that causes stress in cell number `cell` at its `point`, which is at
    /// `position` in the mesh \[m\]; the point and psi_T, `strain`, are about the center of
    /// `line`. Order yz yy zz xx xy xz.
    pub fn strain_at(
        &self,
        section: &Section,
        cell: usize,
        (line, point, position): (&Line, &CellPoint, [f64; 2]),
        strain: &Vector6<f64>,
    ) -> Vector6<f64> {
        let mut warping: NodalColumns = NO_COLUMNS;
        let nodes = section.mesh.cells[cell].nodes();
        for (columns, &node) in warping.iter_mut().zip(nodes) {
            columns.set_column(0, &self.warping.fixed_rows::<3>(3 * node as usize));
        }
        let mut psi = Matrix6::zeros();
        psi.set_column(0, strain);
        let total = strain_at(line, point, None, Some(&warping), &psi);
        total.column(0) - self.free_strain(section, cell, position)
    }

    /// The free strain of a cell at a point of the mesh \[m\], section axes, order yz yy zz
    /// xx xy xz.
    pub fn free_strain(&self, section: &Section, cell: usize, position: [f64; 2]) -> Vector6<f64> {
        let made_of = &section.cells[cell];
        let free = self.cells[cell].at(position);
        section_strain(&free, made_of.fiber_angle, made_of.plane_angle)
    }
}

//! Strain, stress and electric field at any point.

use super::Recoverer;
use crate::element::CellPoint;
use crate::recovery::imposed::Imposed;
use crate::recovery::locate::{Located, locate};
use crate::recovery::state::{ElectricState, LoadCase, Tensors};
use crate::solution::DistributedState;

impl Recoverer<'_> {
    /// Strain and stress under `load` at the point (y, z) \[m\], and the index of the cell
    /// that contains it (the first of several on a common side); `None` outside the
    /// section, and for a load whose voltages are undetermined.
    ///
    /// The strain follows from the displacement of the cell there, without smoothing.
    /// Imposed states whose solution was not given are ignored.
    pub fn at(&self, load: &LoadCase, position: [f64; 2]) -> Option<(usize, Tensors)> {
        let (cell, tensors, _) = self.state_at(load, None, position)?;
        Some((cell, tensors))
    }

    /// As [`Recoverer::at`], with the state added by a distributed load.
    pub fn at_with(
        &self,
        load: &LoadCase,
        added: &DistributedState,
        position: [f64; 2],
    ) -> Option<(usize, Tensors)> {
        let (cell, tensors, _) = self.state_at(load, Some(added), position)?;
        Some((cell, tensors))
    }

    /// Electric field and displacement, as [`Recoverer::at`]; zero in cells without field.
    pub fn electric_at(
        &self,
        load: &LoadCase,
        position: [f64; 2],
    ) -> Option<(usize, ElectricState)> {
        let (cell, _, electric) = self.state_at(load, None, position)?;
        Some((cell, electric))
    }

    fn state_at(
        &self,
        load: &LoadCase,
        added: Option<&DistributedState>,
        position: [f64; 2],
    ) -> Option<(usize, Tensors, ElectricState)> {
        let Located { cell, r, s } = locate(&self.section.mesh, position)?;
        let kind = self.section.mesh.cells[cell].kind;
        let point = CellPoint::at(kind, &self.positions(cell), r, s, 1.0);
        let theta = self.about_center(load);
        let mut strain = self.unit_strain(cell, &point) * theta;
        let imposed = Imposed::of_load(self.section, self.imposed, load);
        let imposed = imposed.ok().flatten();
        if let Some(imposed) = &imposed {
            strain += self.imposed_strain(imposed, cell, &point);
        }
        if let Some(state) = added {
            strain += self.added_strain(cell, state, &point);
        }
        let mut tensors = self.tensors(cell, &strain);
        let electric = self.electric_load(load, imposed.as_ref(), added).ok()?;
        let field = electric.map_or_else(ElectricState::default, |load| {
            self.take_field(&load, (cell, &theta), &point, &mut tensors)
        });
        Some((cell, tensors, field))
    }
}

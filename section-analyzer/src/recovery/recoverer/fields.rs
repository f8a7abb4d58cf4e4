//! Electric fields under an internal force, voltages, imposed states and distributed loads.

use nalgebra::{DVector, Matrix3x6, Matrix6, RowVector6, Vector3, Vector6};
use shared_geom::error::nearest_name;

use super::{PointState, Recoverer};
use crate::assembly::largest;
use crate::element::{
    CellPoint, NO_COLUMNS, NodalColumns, NodalPotential, cell_points, gradient_at, strain_at,
};
use crate::failure::Failure;
use crate::recovery::electric::{ElectricSide, VoltageState};
use crate::recovery::imposed::Imposed;
use crate::recovery::state::{ElectricRecovery, ElectricState, LoadCase, Tensors};
use crate::section::Circuit;
use crate::solution::DistributedState;

/// The electric part of a load.
#[derive(Debug, Clone)]
pub(super) struct ElectricLoad {
    /// The voltages of the load, with the resulting voltages of floating electrodes.
    state: VoltageState,
    /// Potential at the nodes of the mesh without the potential of the internal force
    /// \[V\].
    potential: DVector<f64>,
    /// Rate of that potential along the beam \[V/m\]; `None` if it is constant.
    rate: Option<DVector<f64>>,
    found: ElectricRecovery,
    /// For each node the sum over its cells, with their area.
    sums: Vec<(ElectricState, f64)>,
    /// The size of the stresses of the voltages.
    pub held: HeldFields,
}

/// Sizes of the stress of the fields of voltages on a restrained section.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct HeldFields {
    /// Force, with all stress in the same direction \[N\].
    pub force: f64,
    /// The largest stress \[Pa\].
    pub stress: f64,
}

/// The vector as the first of six columns.
fn first(value: f64) -> RowVector6<f64> {
    let mut row = RowVector6::zeros();
    row[0] = value;
    row
}

impl Recoverer<'_> {
    /// The electric part of `load`; `None` for a section without electrodes.
    ///
    /// # Errors
    /// [`Failure::UnknownElectrode`], [`Failure::NotDriven`]; [`Failure::Undetermined`] and
    /// [`Failure::FloatingUnder`] for floating electrodes whose voltage is undetermined.
    pub(super) fn electric_load(
        &self,
        load: &LoadCase,
        imposed: Option<&Imposed>,
        added: Option<&DistributedState>,
    ) -> Result<Option<ElectricLoad>, Failure> {
        let driven = self.driven(load)?;
        let Some(electric) = &self.electric else {
            return Ok(None);
        };
        electric.require_determined()?;
        let is_alone = imposed.is_none() && added.is_none();
        let mut electrodes = electric.piezo.electrodes.iter();
        if !is_alone && electrodes.any(|known| known.circuit == Circuit::Floating) {
            let load = load.name.clone();
            return Err(Failure::FloatingUnder { load });
        }
        let (piezo, compliance) = (electric.piezo, &self.solution.compliance);
        let of = |force: &Vector6<f64>| {
            let voltages = piezo.voltages(compliance, force, &driven);
            voltages.ok_or_else(|| piezo.undetermined())
        };
        let state = electric.state(of(&Vector6::zeros())?);
        let mut potential = state.potential.clone();
        if let Some(imposed) = imposed {
            potential += &imposed.potential;
        }
        if let Some(added) = added {
            potential += &added.potential;
        }
        let voltages = of(&load.force)?;
        let charges = is_alone.then(|| piezo.charges(compliance, &load.force, &voltages));
        let charge_scale = piezo.largest_charge(compliance, &load.force, &voltages);
        let mut at_nodes = &piezo.potential * load.force + &potential;
        for (electrode, by_force) in piezo.electrodes.iter().zip(&electric.by_force) {
            let voltage = (by_force * self.about_center(load)).x;
            at_nodes.axpy(voltage, &electrode.potential, 1.0);
        }
        let cells = self.cells.len();
        let found = ElectricRecovery {
            field_scale: voltages.iter().map(|v| v.abs()).fold(0.0, largest) / self.size,
            voltages,
            charges,
            charge_scale,
            potential: at_nodes,
            has_field: (0..cells).map(|cell| electric.has_field(cell)).collect(),
            cells: vec![ElectricState::default(); cells],
            ..ElectricRecovery::default()
        };
        Ok(Some(ElectricLoad {
            state,
            potential,
            rate: added.map(|added| added.potential_rate.clone()),
            found,
            sums: vec![(ElectricState::default(), 0.0); self.nodes.len()],
            held: HeldFields::default(),
        }))
    }

    /// The generalized strain of all voltages under `load` about the reference point.
    pub(super) fn electric_strain(
        &self,
        load: &LoadCase,
        electric: Option<&ElectricLoad>,
    ) -> Vector6<f64> {
        let (Some(side), Some(electric)) = (&self.electric, electric) else {
            return Vector6::zeros();
        };
        electric.state.strain + side.floating_strain() * self.about_center(load)
    }

    /// Adds the effect of the voltages of floating electrodes to the generalized strain per
    /// unit force.
    pub(super) fn add_floating(&mut self) {
        if let Some(electric) = &self.electric {
            self.generalized += self.back.transpose() * electric.floating_strain();
        }
    }

    /// The voltage of each electrode given by `load`.
    fn driven(&self, load: &LoadCase) -> Result<Vec<f64>, Failure> {
        let known = self
            .electric
            .as_ref()
            .map_or(&[][..], |electric| &electric.piezo.electrodes);
        let mut driven = vec![0.0; known.len()];
        for (name, voltage) in &load.voltages {
            let Some(index) = known.iter().position(|known| known.name == *name) else {
                let names = known.iter().map(|known| known.name.as_str());
                return Err(Failure::UnknownElectrode {
                    load: load.name.clone(),
                    electrode: name.clone(),
                    nearest: nearest_name(name, names).map(str::to_owned),
                });
            };
            if known[index].circuit != Circuit::Driven {
                return Err(Failure::NotDriven {
                    load: load.name.clone(),
                    electrode: name.clone(),
                });
            }
            driven[index] = *voltage;
        }
        Ok(driven)
    }

    /// Adds strain and stress of the voltages, and the stress of all fields, to the points
    /// of a cell under the internal force `theta` about the centroid; records the fields.
    pub(super) fn add_fields(
        &self,
        (electric, load): (&ElectricSide<'_>, &mut ElectricLoad),
        (cell, theta): (usize, &Vector6<f64>),
        points: &mut [PointState],
    ) {
        let has_field = electric.has_field(cell);
        let grid = &self.cells[cell];
        let kind = self.section.mesh.cells[cell].kind;
        let positions = self.positions(cell);
        let before = load.found.points.len();
        for (number, point) in cell_points(kind, &positions).enumerate() {
            let state = &mut points[number];
            let strain = self.voltage_strain(&load.state, cell, &point);
            state.tensors.add(1.0, &self.tensors(cell, &strain));
            let mut fields = ElectricState::default();
            if has_field {
                let extra = self.extra_field((electric, load), cell, &point);
                let held = electric.largest_stress(cell, &extra);
                load.held.force += point.area * held;
                load.held.stress = largest(load.held.stress, held);
                let field = grid.fields[number] * theta + extra;
                fields = electric.take(cell, &field, &mut state.tensors);
                load.found.field_scale = largest(load.found.field_scale, field.norm());
            }
            load.found.points.push(fields);
        }
        if has_field {
            self.smooth_fields(load, cell, before, points);
        }
    }

    /// Adds the mean of a cell, and its contribution to its nodes.
    fn smooth_fields(
        &self,
        load: &mut ElectricLoad,
        cell: usize,
        before: usize,
        points: &[PointState],
    ) {
        let fields = &load.found.points[before..];
        let area: f64 = points.iter().map(|point| point.area).sum();
        let mut mean = ElectricState::default();
        for (field, point) in fields.iter().zip(points) {
            mean.add(point.area / area, field);
        }
        load.found.cells[cell] = mean;
        let rows = self.cells[cell].extrapolation.rows();
        for (weights, &node) in rows.zip(&self.cell_nodes[cell]) {
            let (sum, total) = &mut load.sums[node as usize];
            for (weight, field) in weights.iter().zip(fields) {
                sum.add(area * weight, field);
            }
            *total += area;
        }
    }

    /// Field and displacement at a point; adds the effects of electrodes to its `tensors`.
    pub(super) fn take_field(
        &self,
        load: &ElectricLoad,
        (cell, theta): (usize, &Vector6<f64>),
        point: &CellPoint,
        tensors: &mut Tensors,
    ) -> ElectricState {
        let Some(electric) = &self.electric else {
            return ElectricState::default();
        };
        let strain = self.voltage_strain(&load.state, cell, point);
        tensors.add(1.0, &self.tensors(cell, &strain));
        if !electric.has_field(cell) {
            return ElectricState::default();
        }
        let unit = self.unit_field(electric, cell, point);
        let field = unit * theta + self.extra_field((electric, load), cell, point);
        electric.take(cell, &field, tensors)
    }

    /// The strain of the voltages at a point, order yz yy zz xx xy xz.
    fn voltage_strain(&self, state: &VoltageState, cell: usize, point: &CellPoint) -> Vector6<f64> {
        let mut warping: NodalColumns = NO_COLUMNS;
        let nodes = self.section.mesh.cells[cell].nodes();
        for (columns, &node) in warping.iter_mut().zip(nodes) {
            columns.set_column(0, &state.warping.fixed_rows::<3>(3 * node as usize));
        }
        let mut psi = Matrix6::zeros();
        psi.set_column(0, &(self.back.transpose() * state.strain));
        let strain = strain_at(&self.line, point, None, Some(&warping), &psi);
        strain.column(0).into_owned()
    }

    /// The field at a point of a cell with field, without the field of the internal force.
    fn extra_field(
        &self,
        (electric, load): (&ElectricSide<'_>, &ElectricLoad),
        cell: usize,
        point: &CellPoint,
    ) -> Vector3<f64> {
        let voltage = |electrode: usize| load.state.voltages[electrode];
        let fingers = electric.of_fingers(cell, voltage);
        if !electric.has_potential(cell) {
            return fingers;
        }
        let nodes = self.section.mesh.cells[cell].nodes();
        let at_nodes = |field: &DVector<f64>| {
            let mut values: NodalPotential = [RowVector6::zeros(); 9];
            for (value, &node) in values.iter_mut().zip(nodes) {
                *value = first(field[node as usize]);
            }
            values
        };
        let rate = load.rate.as_ref().map(&at_nodes);
        let potential = at_nodes(&load.potential);
        let gradient = gradient_at(&self.line, point, rate.as_ref(), &potential);
        against(&gradient).column(0) + fingers
    }

    /// The field at a point of a cell with field per unit internal force: rows x y z.
    pub(super) fn unit_field(
        &self,
        electric: &ElectricSide<'_>,
        cell: usize,
        point: &CellPoint,
    ) -> Matrix3x6<f64> {
        let fingers = electric.of_fingers_by_force(cell);
        if !electric.has_potential(cell) {
            return fingers;
        }
        let zeros = [RowVector6::zeros(); 9];
        let (mut rate, mut potential) = (zeros, zeros);
        let nodes = self.section.mesh.cells[cell].nodes();
        for (i, &node) in nodes.iter().enumerate() {
            let node = node as usize;
            let of_forces = electric.piezo.potential.fixed_view::<1, 6>(node, 0) * self.back;
            rate[i] = of_forces * self.equilibrium;
            potential[i] = of_forces;
            for (electrode, by_force) in electric.piezo.electrodes.iter().zip(&electric.by_force) {
                potential[i] += electrode.potential[node] * by_force;
            }
        }
        let gradient = gradient_at(&self.line, point, Some(&rate), &potential);
        against(&gradient) + fingers
    }
}

/// Minus a gradient: from rows y z x to rows x y z.
fn against(gradient: &Matrix3x6<f64>) -> Matrix3x6<f64> {
    Matrix3x6::from_rows(&[-gradient.row(2), -gradient.row(0), -gradient.row(1)])
}

impl ElectricLoad {
    /// The electric recovery, after all cells have been added.
    pub fn finish(self) -> ElectricRecovery {
        let of_node = |(sum, area): &(ElectricState, f64)| {
            let mut state = ElectricState::default();
            if *area > 0.0 {
                state.add(1.0 / area, sum);
            }
            state
        };
        ElectricRecovery {
            nodes: self.sums.iter().map(of_node).collect(),
            ..self.found
        }
    }
}

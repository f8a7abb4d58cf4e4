//! Strain and stress of a section under any number of internal forces.
//!
//! # Symbols
//!
//! | symbol | meaning | unit | shape |
//! | --- | --- | --- | --- |
//! | `theta` | internal force | N, N m | 6 |
//! | `X`, `Y` | warping and generalized strain per unit internal force | m/N .. | n x 6, 6 x 6 |
//! | `G` | strain per unit internal force at a point | 1/N, 1/(N m) | 6 x 6 |
//! | `D` | law in section axes | Pa | 6 x 6 |
//! | `U` | shift of a force to another point | -, m | 6 x 6 |
//!
//! ```text
//! G = B1 X T' + B0 X + Bpsi Y      eps = G theta      sigma = D eps                (S-33)
//! ```
//!
//! G is stored, so that a load case needs one product at each point. It is about the area
//! centroid, `theta_c = U theta`: about a distant point the six forces cancel each other
//! and digits are lost.
//!
//! # References
//! - \[Giavotto1983\]: stresses of the central solutions.

mod at_point;
mod batch;
mod fields;

pub use batch::StressBlock;

use fields::ElectricLoad;

use super::axes::{USUAL_ORDER, strain_in_axes, stress_in_axes};
use super::electric::ElectricSide;
use super::extrapolate::Extrapolation;
use super::imposed::Imposed;
use super::resultant::{centroid_and_size, resultant, resultant_error};
use super::state::{CellState, LoadCase, NodalState, PointState, Recovery, Tensors};
use crate::assembly::largest;
use crate::element::{CellPoint, Line, NO_COLUMNS, NodalColumns, cell_points, strain_at};
use crate::failure::Failure;
use crate::material::{material_axes, section_stiffness};
use crate::section::Section;
use crate::solution::{DistributedState, ImposedSolution, SectionSolution};
use nalgebra::{Matrix3, Matrix3x6, Matrix6, Vector3, Vector6};
use shared_geom::wrench;

/// Largest error of the resultants of the recovered stress, equal to the limit of the
/// analysis for the internal force of its solutions: valid sections have 1e-12 and less;
/// above 1e-6 a stress would be less accurate than a strength.
const RESULTANT_LIMIT: f64 = 1e-6;

/// The common data of the recoveries of a section.
#[derive(Debug, Clone)]
pub struct Recoverer<'a> {
    section: &'a Section,
    solution: &'a SectionSolution,
    /// Solutions of the imposed states that loads may name.
    imposed: &'a [ImposedSolution],
    /// Area centroid \[m\].
    center: [f64; 2],
    /// Largest distance of a node from it \[m\].
    size: f64,
    /// The line of the beam through the centroid.
    line: Line,
    /// T' of that line.
    equilibrium: Matrix6<f64>,
    /// U from the centroid to the reference point.
    back: Matrix6<f64>,
    /// Generalized strain about the centroid per unit force there: `U' Y U`.
    generalized: Matrix6<f64>,
    /// Consecutive cells share them.
    laws: Vec<OrientedLaw>,
    law_of_cell: Vec<usize>,
    cells: Vec<CellGrid>,
    /// Effects of electrodes; `None` without any.
    electric: Option<ElectricSide<'a>>,
    /// Pairs of region and node, ascending.
    nodes: Vec<(usize, usize)>,
    cell_nodes: Vec<Vec<u32>>,
}

/// A law and the directions of its axes.
#[derive(Debug, Clone)]
struct OrientedLaw {
    /// Stiffness in section axes, order yz yy zz xx xy xz \[Pa\].
    stiffness: Matrix6<f64>,
    /// Material axes in section axes: columns \[-\].
    axes: Matrix3<f64>,
}

/// A cell: its integration points and their extrapolation to its nodes.
#[derive(Debug, Clone)]
struct CellGrid {
    /// G of each point with its position from the centroid \[m\] and area \[m^2\].
    points: Vec<(Matrix6<f64>, [f64; 2], f64)>,
    /// Electric field of each point per unit force about the centroid, rows x y z \[V/m/N,
    /// V/m/(N m)\]; empty in cells without field.
    fields: Vec<Matrix3x6<f64>>,
    extrapolation: Extrapolation,
}

/// Strain and stress of `section` under `load`; `solution` is the section's own.
///
/// # Errors
/// As [`Recoverer::recover`].
pub fn recover(
    section: &Section,
    solution: &SectionSolution,
    load: &LoadCase,
) -> Result<Recovery, Failure> {
    Recoverer::new(section, solution).recover(load)
}

impl<'a> Recoverer<'a> {
    /// Prepares the recoveries of `section`; `solution` is the section's own.
    pub fn new(section: &'a Section, solution: &'a SectionSolution) -> Self {
        let (center, size) = centroid_and_size(section);
        let (nodes, cell_nodes) = nodes_by_region(section);
        let (laws, law_of_cell) = laws(section);
        let line = Line::through(&section.initial_curvature, center, 1.0);
        let back = wrench::shift_matrix(&Vector3::new(0.0, -center[0], -center[1]));
        let mut recoverer = Self {
            line,
            equilibrium: line.equilibrium(),
            back,
            generalized: back.transpose() * solution.strain * back,
            section,
            solution,
            imposed: &[],
            center,
            size,
            laws,
            law_of_cell,
            cells: Vec::new(),
            electric: ElectricSide::new(section, solution, &back),
            nodes,
            cell_nodes,
        };
        recoverer.add_floating();
        recoverer.cells = (0..section.mesh.cells.len())
            .map(|cell| recoverer.grid(cell))
            .collect();
        recoverer
    }

    /// The same for loads with imposed states, given the solutions of the section for these
    /// states.
    pub fn with_imposed(self, imposed: &'a [ImposedSolution]) -> Self {
        Self { imposed, ..self }
    }

    /// Strain and stress under `load`. The strain is the one that causes stress: without
    /// the free strain of imposed states.
    ///
    /// # Errors
    /// [`Failure::Resultant`] when the resultant of the recovered stress differs from the
    /// load; [`Failure::UnknownState`] for an imposed state whose solution was not given.
    pub fn recover(&self, load: &LoadCase) -> Result<Recovery, Failure> {
        self.recovered(load, None)
    }

    /// Strain and stress under `load` and a distributed load, which adds the state `added`.
    ///
    /// # Errors
    /// As [`Recoverer::recover`].
    pub fn recover_with(
        &self,
        load: &LoadCase,
        added: &DistributedState,
    ) -> Result<Recovery, Failure> {
        self.recovered(load, Some(added))
    }

    fn recovered(
        &self,
        load: &LoadCase,
        added: Option<&DistributedState>,
    ) -> Result<Recovery, Failure> {
        let theta = self.about_center(load);
        let imposed = Imposed::of_load(self.section, self.imposed, load)?;
        let mut electric = self.electric_load(load, imposed.as_ref(), added)?;
        let mut points = Vec::with_capacity(self.cells.iter().map(|c| c.points.len()).sum());
        let mut cells = Vec::with_capacity(self.cells.len());
        let mut sums = vec![(Tensors::default(), 0.0); self.nodes.len()];
        for (cell, grid) in self.cells.iter().enumerate() {
            let first = points.len();
            let more = added.map(|state| self.added_strains(cell, state));
            let more = |point: usize| more.as_ref().map_or(Vector6::zeros(), |more| more[point]);
            points.extend((grid.points.iter().enumerate()).map(
                |(point, (unit, position, area))| PointState {
                    cell,
                    position: [position[0] + self.center[0], position[1] + self.center[1]],
                    area: *area,
                    tensors: self.tensors(cell, &(unit * theta + more(point))),
                },
            ));
            if let Some(imposed) = &imposed {
                self.add_imposed(imposed, cell, &mut points[first..]);
            }
            if let (Some(side), Some(load)) = (&self.electric, &mut electric) {
                self.add_fields((side, load), (cell, &theta), &mut points[first..]);
            }
            cells.push(self.smoothed(cell, &points[first..], &mut sums));
        }
        let about_center = resultant(&points, self.center);
        let held = imposed
            .as_ref()
            .map_or(0.0, |imposed| self.held(imposed, &points));
        let fields = electric.as_ref().map(|load| load.held).unwrap_or_default();
        let least = held + fields.force + added.map_or(0.0, |state| self.size_of(state, &points));
        let error = resultant_error(&about_center, &theta, self.size, least);
        self.require(load, error)?;
        let scales = self.scales(imposed.as_ref(), added, &points);
        Ok(Recovery {
            load: load.clone(),
            generalized_strain: self.solution.strain * load.force
                + imposed.map_or_else(Vector6::zeros, |imposed| imposed.strain)
                + added.map_or_else(Vector6::zeros, |state| state.strain)
                + self.electric_strain(load, electric.as_ref()),
            is_distributed: added.is_some(),
            stress_scale: largest(scales.stress, fields.stress),
            strain_scale: scales.strain,
            nodes: self.nodal_states(&sums),
            points,
            cells,
            cell_nodes: self.cell_nodes.clone(),
            resultant: self.back * about_center,
            resultant_error: error,
            electric: electric.map(ElectricLoad::finish),
        })
    }

    /// Adds strain and stress of imposed states at the points of a cell.
    fn add_imposed(&self, imposed: &Imposed, cell: usize, points: &mut [PointState]) {
        let kind = self.section.mesh.cells[cell].kind;
        let positions = self.positions(cell);
        for (state, point) in points.iter_mut().zip(cell_points(kind, &positions)) {
            let strain = self.imposed_strain(imposed, cell, &point);
            state.tensors.add(1.0, &self.tensors(cell, &strain));
        }
    }

    /// The strain of imposed states at a point of a cell, about the centroid.
    fn imposed_strain(&self, imposed: &Imposed, cell: usize, point: &CellPoint) -> Vector6<f64> {
        let strain = self.back.transpose() * imposed.strain;
        let position = [point.y + self.center[0], point.z + self.center[1]];
        imposed.strain_at(self.section, cell, (&self.line, point, position), &strain)
    }

    /// The law of a cell in section axes, order yz yy zz xx xy xz \[Pa\].
    pub(super) fn stiffness(&self, cell: usize) -> &Matrix6<f64> {
        &self.laws[self.law_of_cell[cell]].stiffness
    }

    pub(super) fn section(&self) -> &Section {
        self.section
    }

    /// Largest distance of a node from the centroid \[m\].
    pub(super) fn size(&self) -> f64 {
        self.size
    }

    pub(super) fn line(&self) -> &Line {
        &self.line
    }

    fn require(&self, load: &LoadCase, error: f64) -> Result<(), Failure> {
        if error <= RESULTANT_LIMIT {
            return Ok(());
        }
        Err(Failure::Resultant {
            load: load.name.clone(),
            error,
            limit: RESULTANT_LIMIT,
        })
    }

    /// Vector from the reference point to the centroid.
    pub(super) fn offset(&self) -> Vector3<f64> {
        Vector3::new(0.0, self.center[0], self.center[1])
    }

    /// The internal force about the centroid.
    fn about_center(&self, load: &LoadCase) -> Vector6<f64> {
        wrench::shift_matrix(&self.offset()) * load.force
    }

    /// Positions of the nodes of a cell from the centroid.
    pub(super) fn positions(&self, cell: usize) -> Vec<[f64; 2]> {
        let mesh = &self.section.mesh;
        let positions = mesh.positions(&mesh.cells[cell]);
        positions
            .map(|[y, z]| [y - self.center[0], z - self.center[1]])
            .collect()
    }

    fn grid(&self, cell: usize) -> CellGrid {
        let kind = self.section.mesh.cells[cell].kind;
        let positions = self.positions(cell);
        let points: Vec<_> = cell_points(kind, &positions).collect();
        let (rate, warping) = self.columns(cell);
        let strain = &self.generalized;
        let unit = |p: &CellPoint| strain_at(&self.line, p, Some(&rate), Some(&warping), strain);
        let side = self.electric.as_ref();
        let side = side.filter(|side| side.has_field(cell));
        let fields = side.map_or_else(Vec::new, |side| {
            let fields = points
                .iter()
                .map(|point| self.unit_field(side, cell, point));
            fields.collect()
        });
        CellGrid {
            fields,
            extrapolation: Extrapolation::new(kind, &positions, &points),
            points: points
                .iter()
                .map(|point| (unit(point), [point.y, point.z], point.area))
                .collect(),
        }
    }

    /// G at a point of a cell.
    fn unit_strain(&self, cell: usize, point: &CellPoint) -> Matrix6<f64> {
        let (rate, warping) = self.columns(cell);
        strain_at(
            &self.line,
            point,
            Some(&rate),
            Some(&warping),
            &self.generalized,
        )
    }

    /// `X U` and `X U T'` at the nodes of a cell, U from the centroid to the reference
    /// point.
    fn columns(&self, cell: usize) -> (NodalColumns, NodalColumns) {
        let (mut rate, mut warping) = (NO_COLUMNS, NO_COLUMNS);
        let nodes = self.section.mesh.cells[cell].nodes();
        for (i, &node) in nodes.iter().enumerate() {
            let x = self
                .solution
                .warping
                .fixed_view::<3, 6>(3 * node as usize, 0)
                * self.back;
            warping[i] = x;
            rate[i] = x * self.equilibrium;
            if let Some(electric) = &self.electric {
                warping[i] += electric.floating_warping(node as usize);
            }
        }
        (rate, warping)
    }

    /// Stress and material axes from the strain in the order yz yy zz xx xy xz.
    fn tensors(&self, cell: usize, strain: &Vector6<f64>) -> Tensors {
        let OrientedLaw { stiffness, axes } = &self.laws[self.law_of_cell[cell]];
        let stress = stiffness * strain;
        let usual = |v: &Vector6<f64>| Vector6::from_fn(|i, _| v[USUAL_ORDER[i]]);
        let (strain, stress) = (usual(strain), usual(&stress));
        Tensors {
            strain,
            stress,
            material_strain: strain_in_axes(axes, &strain),
            material_stress: stress_in_axes(axes, &stress),
        }
    }

    /// The mean of a cell; adds the values of its points to the nodes.
    fn smoothed(
        &self,
        cell: usize,
        points: &[PointState],
        sums: &mut [(Tensors, f64)],
    ) -> CellState {
        let (mean, area) = mean_of(points);
        let rows = self.cells[cell].extrapolation.rows();
        for (weights, &node) in rows.zip(&self.cell_nodes[cell]) {
            let (sum, total) = &mut sums[node as usize];
            for (weight, point) in weights.iter().zip(points) {
                sum.add(area * weight, &point.tensors);
            }
            *total += area;
        }
        mean
    }

    fn nodal_states(&self, sums: &[(Tensors, f64)]) -> Vec<NodalState> {
        let pairs = self.nodes.iter().zip(sums);
        pairs
            .map(|(&(group, node), (sum, area))| {
                let mut tensors = Tensors::default();
                tensors.add(1.0 / area, sum);
                NodalState {
                    node,
                    group,
                    tensors,
                }
            })
            .collect()
    }
}

/// The mean of a cell over its area, and the area.
fn mean_of(points: &[PointState]) -> (CellState, f64) {
    let area: f64 = points.iter().map(|point| point.area).sum();
    let mut mean = CellState {
        centroid: [0.0; 2],
        tensors: Tensors::default(),
    };
    for point in points {
        let part = point.area / area;
        mean.tensors.add(part, &point.tensors);
        mean.centroid[0] += part * point.position[0];
        mean.centroid[1] += part * point.position[1];
    }
    (mean, area)
}

/// Law and axes of each cell; equal neighbors in the list share them.
fn laws(section: &Section) -> (Vec<OrientedLaw>, Vec<usize>) {
    let mut laws = Vec::new();
    let mut law_of_cell = Vec::with_capacity(section.cells.len());
    let mut last = None;
    for made_of in &section.cells {
        if last != Some(made_of) {
            let stiffness = section.materials[made_of.material].law.stiffness();
            let (fiber, plane) = (made_of.fiber_angle, made_of.plane_angle);
            laws.push(OrientedLaw {
                stiffness: section_stiffness(&stiffness, fiber, plane),
                axes: material_axes(fiber, plane),
            });
            last = Some(made_of);
        }
        law_of_cell.push(laws.len() - 1);
    }
    (laws, law_of_cell)
}

/// All pairs of region and node, ascending, and for each cell the indices of its nodes in
/// that list.
fn nodes_by_region(section: &Section) -> (Vec<(usize, usize)>, Vec<Vec<u32>>) {
    let cells = &section.mesh.cells;
    let mut pairs: Vec<(usize, usize)> = cells
        .iter()
        .flat_map(|cell| cell.nodes().iter().map(|&node| (cell.group, node as usize)))
        .collect();
    pairs.sort_unstable();
    pairs.dedup();
    let index = |pair: (usize, usize)| pairs.partition_point(|known| *known < pair) as u32;
    let of_cells = cells.iter().map(|cell| {
        let nodes = cell.nodes().iter();
        nodes
            .map(|&node| index((cell.group, node as usize)))
            .collect()
    });
    let of_cells = of_cells.collect();
    (pairs, of_cells)
}

#[cfg(test)]
#[path = "recoverer_tests.rs"]
mod tests;

//! Recovered strain and stress as values.

use nalgebra::{DVector, Vector3, Vector6};
use shared_geom::wrench;

/// A named internal force, with or without imposed states and voltages.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadCase {
    /// Name, as given in the input.
    pub name: String,
    /// Internal force about the reference point, the origin of the mesh, order of
    /// [`shared_geom::wrench::COMPONENTS`] \[N, N m\].
    pub force: Vector6<f64>,
    /// Names of the imposed states that act with it.
    pub imposed: Vec<String>,
    /// Voltages of driven electrodes by name; zero for the others \[V\].
    pub voltages: Vec<(String, f64)>,
}

impl LoadCase {
    /// The internal force `force` about the point (y, z), shifted to the reference
    /// point: a force F there adds the moment `d x F`, d = (0, y, z).
    pub fn at_point(name: impl Into<String>, force: &Vector6<f64>, [y, z]: [f64; 2]) -> Self {
        Self {
            name: name.into(),
            force: wrench::shift_matrix(&-Vector3::new(0.0, y, z)) * force,
            imposed: Vec::new(),
            voltages: Vec::new(),
        }
    }
}

/// Strain and stress at one point, in both systems of axes. The strain is the one that
/// causes stress: it excludes the free strains of imposed states and includes the strains
/// of voltages. The stress is due to strain and electric field together.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Tensors {
    /// Strain in section axes, order xx yy zz yz xz xy \[-\].
    pub strain: Vector6<f64>,
    /// Stress in section axes, order xx yy zz yz xz xy \[Pa\].
    pub stress: Vector6<f64>,
    /// Strain in material axes, order 11 22 33 23 13 12 \[-\].
    pub material_strain: Vector6<f64>,
    /// Stress in material axes, order 11 22 33 23 13 12 \[Pa\].
    pub material_stress: Vector6<f64>,
}

impl Tensors {
    /// Von Mises stress \[Pa\]: the stress in tension with the same energy of distortion.
    ///
    /// ```text
    /// s^2 = 1/2 [(s11 - s22)^2 + (s22 - s33)^2 + (s33 - s11)^2] + 3 (s23^2 + s13^2 + s12^2)
    /// ```
    pub fn von_mises(&self) -> f64 {
        let s = &self.stress;
        let normal = (s[0] - s[1]).powi(2) + (s[1] - s[2]).powi(2) + (s[2] - s[0]).powi(2);
        let shear = s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
        (0.5 * normal + 3.0 * shear).sqrt()
    }

    /// Adds `factor` times `other`.
    pub(super) fn add(&mut self, factor: f64, other: &Self) {
        self.strain += factor * other.strain;
        self.stress += factor * other.stress;
        self.material_strain += factor * other.material_strain;
        self.material_stress += factor * other.material_stress;
    }
}

/// Strain and stress at an integration point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointState {
    /// Cell: index in the mesh of the section.
    pub cell: usize,
    /// Position (y, z) \[m\].
    pub position: [f64; 2],
    /// Area that the point represents \[m^2\].
    pub area: f64,
    /// Strain and stress.
    pub tensors: Tensors,
}

/// Mean strain and stress of a cell over its area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CellState {
    /// Centroid (y, z) \[m\].
    pub centroid: [f64; 2],
    /// Strain and stress.
    pub tensors: Tensors,
}

/// Smoothed strain and stress at a node in one region: stresses jump between materials, so
/// nodes on a border have a state for each region.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NodalState {
    /// Node: index in the mesh of the section.
    pub node: usize,
    /// Region: index of the physical surface in the mesh of the section.
    pub group: usize,
    /// Strain and stress.
    pub tensors: Tensors,
}

/// Electric field and displacement at one point of a dielectric or between fingers, in both
/// systems of axes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ElectricState {
    /// Electric field in section axes x y z \[V/m\].
    pub field: Vector3<f64>,
    /// Electric displacement in section axes x y z \[C/m^2\].
    pub displacement: Vector3<f64>,
    /// Electric field in material axes 1 2 3 \[V/m\].
    pub material_field: Vector3<f64>,
    /// Electric displacement in material axes 1 2 3 \[C/m^2\].
    pub material_displacement: Vector3<f64>,
}

impl ElectricState {
    /// Adds `factor` times `other`.
    pub(super) fn add(&mut self, factor: f64, other: &Self) {
        self.field += factor * other.field;
        self.displacement += factor * other.displacement;
        self.material_field += factor * other.material_field;
        self.material_displacement += factor * other.material_displacement;
    }
}

/// The electric part of a recovery.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ElectricRecovery {
    /// Voltages of the electrodes of the section, in its order: given by the load, or
    /// resulting for floating electrodes \[V\].
    pub voltages: Vec<f64>,
    /// Charge per length on each electrode; `None` with imposed states or distributed loads
    /// \[C/m\].
    pub charges: Option<Vec<f64>>,
    /// The largest part of a charge, due to the strain or to a voltage: the reference for
    /// round-off \[C/m\].
    pub charge_scale: f64,
    /// Potential at the nodes of the mesh, zero at nodes without one \[V\].
    pub potential: DVector<f64>,
    /// Whether each cell of the mesh has an electric field: dielectrics, and cells between
    /// fingers.
    pub has_field: Vec<bool>,
    /// At the integration points, parallel to the points of the recovery; zero in cells
    /// without field.
    pub points: Vec<ElectricState>,
    /// Means of the cells; zero in cells without field.
    pub cells: Vec<ElectricState>,
    /// At the smoothed nodes, parallel to the nodes of the recovery; zero where no cell of
    /// the region has a field.
    pub nodes: Vec<ElectricState>,
    /// The largest field, or the largest voltage over the size of the section: the
    /// reference for round-off \[V/m\].
    pub field_scale: f64,
}

/// Strain and stress of the whole section under one internal force.
#[derive(Debug, Clone, PartialEq)]
pub struct Recovery {
    /// The internal force.
    pub load: LoadCase,
    /// Generalized strain, order of [`shared_geom::wrench::COMPONENTS`] \[-, 1/m\].
    pub generalized_strain: Vector6<f64>,
    /// Whether a distributed load acts too.
    pub is_distributed: bool,
    /// The largest stress, or the largest stress of the actions on a restrained section:
    /// the reference for round-off \[Pa\].
    pub stress_scale: f64,
    /// The largest strain, or the strain of that stress \[-\].
    pub strain_scale: f64,
    /// Integration points, cell by cell.
    pub points: Vec<PointState>,
    /// Means of the cells, parallel to the cells of the mesh.
    pub cells: Vec<CellState>,
    /// Nodes, by region and then by node.
    pub nodes: Vec<NodalState>,
    /// For each cell, and each of its nodes in the cell's order, the index in `nodes`.
    pub cell_nodes: Vec<Vec<u32>>,
    /// Internal force of the recovered stress, integrated over the section \[N, N m\].
    pub resultant: Vector6<f64>,
    /// Largest difference of `resultant` from the load, relative to the load; moments are
    /// divided by the size of the section \[-\].
    pub resultant_error: f64,
    /// Electric fields; `None` for a section without electrodes.
    pub electric: Option<ElectricRecovery>,
}

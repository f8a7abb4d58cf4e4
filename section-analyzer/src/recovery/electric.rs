//! The electric part of recoveries: fields of dielectrics and between fingers, and the
//! stress that they subtract.
//!
//! # Symbols
//!
//! | symbol | meaning | unit | shape |
//! | --- | --- | --- | --- |
//! | `P` | potential per unit internal force | V/N, V/(N m) | n x 6 |
//! | `F` | voltages of floating electrodes per unit internal force | V/N, V/(N m) | n_V x 6 |
//! | `X_V`, `P_V`, `Y_V` | warping, potential and generalized strain per volt | m/V, -, 1/V .. | |
//! | `E` | electric field; between fingers a given field per volt | V/m | 3 |
//!
//! ```text
//! u = (X + X_V F) theta + X_V V      u' = X T' theta      psi = (Y + Y_V F) theta + Y_V V
//! E = -grad V of P alike             sigma = c eps - e' E      D = e eps + epsS E
//! ```
//!
//! Voltages are constant along the beam: floating electrodes contribute to u but not to u'.
//! Between fingers E depends only on the voltage, not on the strain.
//!
//! # References
//! - \[Masarati\], section 9.1: piezoelectric beam sections.

use super::state::{ElectricState, Tensors};
use crate::assembly::dielectric_cells;
use crate::failure::Failure;
use crate::material::{coupled_law, material_axes};
use crate::section::{CellMaterial, Circuit, ElectrodeShape, Section};
use crate::solution::{PiezoSolution, SectionSolution};
use nalgebra::{DVector, Matrix3, Matrix3x6, Matrix6, RowVector6, Vector3, Vector6};

use super::axes::{USUAL_ORDER, stress_in_axes};

/// No electric law.
const NONE: u32 = u32::MAX;

/// Axes y z x of the gradient in coupled laws, of x y z.
const OF_GRADIENT: [usize; 3] = [2, 0, 1];

/// The electric part of a section with electrodes.
#[derive(Debug, Clone)]
pub(super) struct ElectricSide<'a> {
    pub piezo: &'a PiezoSolution,
    /// F: voltage of each electrode per unit internal force about the centroid.
    pub by_force: Vec<RowVector6<f64>>,
    /// Whether the voltages of floating electrodes are determined.
    is_determined: bool,
    laws: Vec<ElectricPart>,
    /// For each cell the index of its law.
    law_of_cell: Vec<u32>,
    /// Whether each cell has a potential.
    is_dielectric: Vec<bool>,
    /// Cells between fingers, ascending.
    fingers: Vec<Finger>,
}

/// A cell between the fingers of an electrode.
#[derive(Debug, Clone, Copy)]
struct Finger {
    cell: u32,
    electrode: usize,
    /// Field per volt in section axes x y z \[1/m\].
    field: Vector3<f64>,
}

/// The electric part of a law, in section axes.
#[derive(Debug, Clone)]
struct ElectricPart {
    /// e: rows x y z, columns xx yy zz yz xz xy \[C/m^2\].
    coupling: Matrix3x6<f64>,
    /// epsS: rows and columns x y z \[F/m\].
    permittivity: Matrix3<f64>,
    /// Material axes in section axes: columns \[-\].
    axes: Matrix3<f64>,
}

/// Effects of the voltages of all electrodes.
#[derive(Debug, Clone)]
pub(super) struct VoltageState {
    /// Voltage of each electrode \[V\].
    pub voltages: Vec<f64>,
    /// Warping, rows ux, uy, uz of each node of the mesh \[m\].
    pub warping: DVector<f64>,
    /// Potential at each node of the mesh \[V\].
    pub potential: DVector<f64>,
    /// Generalized strain about the reference point \[-, 1/m\].
    pub strain: Vector6<f64>,
}

impl<'a> ElectricSide<'a> {
    /// The electric part of a section and its solution; `None` without electrodes. `back`
    /// shifts forces from the centroid to the reference point.
    pub fn new(
        section: &Section,
        solution: &'a SectionSolution,
        back: &Matrix6<f64>,
    ) -> Option<Self> {
        let piezo = solution.piezo.as_ref()?;
        let mut by_force = vec![RowVector6::zeros(); piezo.electrodes.len()];
        let mut is_determined = true;
        for case in 0..6 {
            let force = back.column(case).into_owned();
            match piezo.voltages(&solution.compliance, &force, &[]) {
                Some(voltages) => {
                    for (row, voltage) in by_force.iter_mut().zip(voltages) {
                        row[case] = voltage;
                    }
                }
                None => is_determined = false,
            }
        }
        let is_dielectric = dielectric_cells(section);
        let fingers = fingers(section);
        let mut has_field = is_dielectric.clone();
        for finger in &fingers {
            has_field[finger.cell as usize] = true;
        }
        let (laws, law_of_cell) = parts(section, &has_field);
        Some(Self {
            piezo,
            by_force,
            is_determined,
            laws,
            law_of_cell,
            is_dielectric,
            fingers,
        })
    }

    /// Whether a cell has an electric field.
    pub fn has_field(&self, cell: usize) -> bool {
        self.law_of_cell[cell] != NONE
    }

    /// Whether a cell has a potential.
    pub fn has_potential(&self, cell: usize) -> bool {
        self.is_dielectric[cell]
    }

    /// The field between fingers of a cell from the voltages of the electrodes.
    pub fn of_fingers(&self, cell: usize, voltage: impl Fn(usize) -> f64) -> Vector3<f64> {
        let terms = self.fingers_of(cell).iter();
        terms
            .map(|finger| voltage(finger.electrode) * finger.field)
            .sum()
    }

    /// The field between fingers of a cell per unit internal force.
    pub fn of_fingers_by_force(&self, cell: usize) -> Matrix3x6<f64> {
        let terms = self.fingers_of(cell).iter();
        terms
            .map(|finger| finger.field * self.by_force[finger.electrode])
            .sum()
    }

    fn fingers_of(&self, cell: usize) -> &[Finger] {
        let cell = cell as u32;
        let first = self.fingers.partition_point(|finger| finger.cell < cell);
        let last = self.fingers.partition_point(|finger| finger.cell <= cell);
        &self.fingers[first..last]
    }

    /// `e' x` of a cell with field, six columns at once: rows xx yy zz yz xz xy.
    pub fn stress_per_field(&self, cell: usize, field: &Matrix3x6<f64>) -> Matrix6<f64> {
        self.part(cell).coupling.transpose() * field
    }

    /// Bound of the stress of a field of this size in a cell with field, in any direction: a
    /// reference for round-off, not zero where the field and the coupling are at right angles
    /// \[Pa\].
    pub fn largest_stress(&self, cell: usize, field: &Vector3<f64>) -> f64 {
        self.part(cell).coupling.norm() * field.norm()
    }

    /// Subtracts the stress of `field` (x y z) from the `tensors` of a cell with field,
    /// whose strain is the total strain; returns field and displacement.
    pub fn take(&self, cell: usize, field: &Vector3<f64>, tensors: &mut Tensors) -> ElectricState {
        let ElectricPart {
            coupling,
            permittivity,
            axes,
        } = self.part(cell);
        let stress = -(coupling.tr_mul(field));
        tensors.stress += stress;
        tensors.material_stress += stress_in_axes(axes, &stress);
        let displacement = coupling * tensors.strain + permittivity * field;
        ElectricState {
            field: *field,
            displacement,
            material_field: axes.tr_mul(field),
            material_displacement: axes.tr_mul(&displacement),
        }
    }

    fn part(&self, cell: usize) -> &ElectricPart {
        &self.laws[self.law_of_cell[cell] as usize]
    }

    /// Effects of the `voltages` of all electrodes.
    pub fn state(&self, voltages: Vec<f64>) -> VoltageState {
        let piezo = self.piezo;
        let mut state = VoltageState {
            warping: DVector::zeros(3 * piezo.has_potential.len()),
            potential: DVector::zeros(piezo.has_potential.len()),
            strain: Vector6::zeros(),
            voltages,
        };
        for (electrode, voltage) in piezo.electrodes.iter().zip(&state.voltages) {
            if *voltage != 0.0 {
                state.warping.axpy(*voltage, &electrode.warping, 1.0);
                state.potential.axpy(*voltage, &electrode.potential, 1.0);
                state.strain += *voltage * electrode.free_strain;
            }
        }
        state
    }

    /// `Y_V F`: generalized strain of floating electrodes about the reference point per unit
    /// internal force about the centroid.
    pub fn floating_strain(&self) -> Matrix6<f64> {
        let terms = self.piezo.electrodes.iter().zip(&self.by_force);
        terms
            .map(|(electrode, by_force)| electrode.free_strain * by_force)
            .sum()
    }

    /// `X_V F` at a node of the mesh.
    pub fn floating_warping(&self, node: usize) -> Matrix3x6<f64> {
        let terms = self.piezo.electrodes.iter().zip(&self.by_force);
        let floating = terms.filter(|(known, _)| known.circuit == Circuit::Floating);
        floating
            .map(|(known, by_force)| known.warping.fixed_rows::<3>(3 * node) * by_force)
            .sum()
    }

    /// Requires that the voltages of floating electrodes are determined.
    pub fn require_determined(&self) -> Result<(), Failure> {
        if self.is_determined {
            Ok(())
        } else {
            Err(self.piezo.undetermined())
        }
    }
}

/// The cells between fingers, ascending.
fn fingers(section: &Section) -> Vec<Finger> {
    let mut all = Vec::new();
    for (electrode, known) in section.electrodes.iter().enumerate() {
        let ElectrodeShape::Interdigitated { cells } = &known.shape else {
            continue;
        };
        for fingered in cells {
            let made_of = &section.cells[fingered.cell as usize];
            if section.materials[made_of.material].electric.is_some() {
                let axes = material_axes(made_of.fiber_angle, made_of.plane_angle);
                all.push(Finger {
                    cell: fingered.cell,
                    electrode,
                    field: axes * fingered.field,
                });
            }
        }
    }
    all.sort_by_key(|finger| finger.cell);
    all
}

/// The electric laws of the cells with field; equal neighbors in the list share them.
fn parts(section: &Section, has_field: &[bool]) -> (Vec<ElectricPart>, Vec<u32>) {
    let mut laws = Vec::new();
    let mut last: Option<&CellMaterial> = None;
    let of_cells = section.cells.iter().zip(has_field).map(|(made_of, has)| {
        let material = &section.materials[made_of.material];
        let (true, Some(electric)) = (has, &material.electric) else {
            return NONE;
        };
        if last != Some(made_of) {
            let (fiber, plane) = (made_of.fiber_angle, made_of.plane_angle);
            let law = coupled_law(&material.law.stiffness(), electric, fiber, plane);
            let row = |axis: usize| 6 + OF_GRADIENT[axis];
            laws.push(ElectricPart {
                coupling: Matrix3x6::from_fn(|a, i| law[(row(a), USUAL_ORDER[i])]),
                permittivity: Matrix3::from_fn(|a, b| -law[(row(a), row(b))]),
                axes: material_axes(fiber, plane),
            });
            last = Some(made_of);
        }
        laws.len() as u32 - 1
    });
    let of_cells = of_cells.collect();
    (laws, of_cells)
}

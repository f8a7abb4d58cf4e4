//! Restrained warping of isotropic sections: shear-flow center and Vlasov's constant.
//!
//! In torsion without restraint a section of isotropic materials turns about an axis and
//! warps along the beam, `u_x = kappa_1 omega(y, z)`. The central solution of unit torque
//! contains both: its warping per unit twist is omega for a turn about the point c that
//! does not move,
//!
//! ```text
//! omega_c = X[ux, M1] / Y[kappa_1, M1]                                       (S-62)
//! y_c = -Y[nu_3, M1] / Y[kappa_1, M1]     z_c = Y[nu_2, M1] / Y[kappa_1, M1]
//! ```
//!
//! A turn about another pole p adds a rigid rotation of the section about y and z,
//!
//! ```text
//! omega_p = omega_c + (y_p - y_c) z - (z_p - z_c) y + constant               (S-63)
//! ```
//!
//! and the pole for which the stress `E omega` of a restraint has no resultant is the
//! shear-flow center:
//!
//! ```text
//! int E omega dA = int E omega y dA = int E omega z dA = 0                   (S-64)
//! E Gamma = int E omega^2 dA                                                 (S-65)
//! decay length = sqrt(E Gamma / G J)                                         (S-66)
//! ```
//!
//! # References
//! - [Vlasov1961]: the theory of restrained warping, chapter 1.
//! - [Trefftz1935]: the shear center by the energy of torsion and flexure, as the pole of
//!   this theory.
//! - [Pilkey2002]: the constants of solid sections by finite elements.

use std::fmt;

use nalgebra::{DMatrix, Matrix2, Matrix6, Vector2};

use crate::element::cell_points;
use crate::material::ElasticLaw;
use crate::section::Section;

/// Largest difference of a law from an isotropic one, relative to its largest entry.
const ISOTROPIC: f64 = 1e-9;

/// Section constants for a beam with restrained warping.
#[derive(Debug, Clone, PartialEq)]
pub struct RestrainedWarping {
    /// Shear-flow center (y, z), from the reference point \[m\].
    pub center: [f64; 2],
    /// omega: warping along the beam per unit twist about that center, at each node
    /// of the mesh; its mean, weighted by Young's modulus, is zero \[m^2\].
    pub function: Vec<f64>,
    /// `E Gamma`, the warping stiffness \[N m^4\].
    pub stiffness: f64,
    /// Gamma, Vlasov's warping constant; `None` when Young's modulus differs between cells
    /// \[m^6\].
    pub constant: Option<f64>,
    /// `G J`, the stiffness of torsion without restraint \[N m^2\].
    pub torsional_stiffness: f64,
    /// `sqrt(E Gamma / G J)`: the stresses of a restraint decrease by a factor e over this
    /// length \[m\].
    pub decay_length: f64,
}

/// Reason why a section has no [`RestrainedWarping`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NoRestrainedWarping {
    /// A material is not isotropic, and torsion is coupled with other strains.
    Anisotropic {
        /// Name of the first anisotropic material.
        material: String,
    },
    /// The beam is curved or twisted, and torsion is coupled with axial force and bending.
    Curved,
}

impl fmt::Display for NoRestrainedWarping {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Anisotropic { material } => write!(
                f,
                "material \"{material}\" is not isotropic; the torsion of an anisotropic \
                 section has no such constants"
            ),
            Self::Curved => f.write_str(
                "the beam is curved or twisted; these constants apply to straight beams, \
                 whose torsion is not coupled with axial force and bending",
            ),
        }
    }
}

impl RestrainedWarping {
    /// From the central solutions of `section`: `warping` (rows ux, uy, uz of each
    /// node) and `strain` per unit internal force, about the reference point, as
    /// [`crate::solution::SectionSolution`] holds them.
    ///
    /// # Errors
    /// [`NoRestrainedWarping`] for a curved or twisted beam, and when a material that has
    /// cells is not isotropic.
    pub fn new(
        section: &Section,
        warping: &DMatrix<f64>,
        strain: &Matrix6<f64>,
    ) -> Result<Self, NoRestrainedWarping> {
        if !section.initial_curvature.is_straight() {
            return Err(NoRestrainedWarping::Curved);
        }
        let young = young_of_materials(section)?;
        let modulus = |cell: usize| young[section.cells[cell].material];
        let twist = strain[(3, 3)];
        let mut function: Vec<f64> = (0..section.mesh.nodes.len())
            .map(|node| warping[(3 * node, 3)] / twist)
            .collect();

        let fit = LinearPart::of(section, &function, modulus);
        for (value, position) in function.iter_mut().zip(&section.mesh.nodes) {
            *value -= fit.at(*position);
        }
        let stiffness = integral(section, modulus, |at| at.value(&function).powi(2));
        let torsional_stiffness = 1.0 / twist;
        let [along_y, along_z] = fit.slope;
        Ok(Self {
            center: [
                -strain[(2, 3)] / twist - along_z,
                strain[(1, 3)] / twist + along_y,
            ],
            function,
            stiffness,
            constant: common(section, &young).map(|young| stiffness / young),
            torsional_stiffness,
            decay_length: (stiffness / torsional_stiffness).sqrt(),
        })
    }
}

/// The linear function of y and z nearest to a field, weighted by modulus: the rest of the
/// field has no resultants, (S-64).
struct LinearPart {
    mean: f64,
    /// Center of the weights [m].
    center: [f64; 2],
    /// Along y and z.
    slope: [f64; 2],
}

impl LinearPart {
    fn of(section: &Section, field: &[f64], modulus: impl Fn(usize) -> f64 + Copy) -> Self {
        // positions from a node: a mesh far from its origin keeps its digits
        let base = section.mesh.nodes[0];
        let weight = integral(section, modulus, |_| 1.0);
        let mean_of = |what: &dyn Fn(&Point<'_>) -> f64| integral(section, modulus, what) / weight;
        let center = [0, 1].map(|axis| base[axis] + mean_of(&|at| at.position[axis] - base[axis]));
        let mean = mean_of(&|at| at.value(field));
        let from = |at: &Point<'_>, axis: usize| at.position[axis] - center[axis];
        let second = |a: usize, b: usize| mean_of(&|at| from(at, a) * from(at, b));
        let first = |a: usize| mean_of(&|at| from(at, a) * (at.value(field) - mean));
        let matrix = Matrix2::new(second(0, 0), second(0, 1), second(1, 0), second(1, 1));
        // the inertia of a section with an area is positive definite
        let slope = matrix.try_inverse().unwrap_or_default() * Vector2::new(first(0), first(1));
        Self {
            mean,
            center,
            slope: slope.into(),
        }
    }

    fn at(&self, [y, z]: [f64; 2]) -> f64 {
        self.mean + self.slope[0] * (y - self.center[0]) + self.slope[1] * (z - self.center[1])
    }
}

/// An integration point: its position, and the weights of the nodes of its cell.
struct Point<'a> {
    position: [f64; 2],
    nodes: &'a [u32],
    shape: &'a [f64; 9],
}

impl Point<'_> {
    fn value(&self, field: &[f64]) -> f64 {
        let terms = self.nodes.iter().zip(self.shape);
        terms.map(|(&node, n)| n * field[node as usize]).sum()
    }
}

/// `int E f dA` by the rules of the cells.
fn integral(
    section: &Section,
    modulus: impl Fn(usize) -> f64,
    f: impl Fn(&Point<'_>) -> f64,
) -> f64 {
    let mesh = &section.mesh;
    let mut sum = 0.0;
    for (index, cell) in mesh.cells.iter().enumerate() {
        let positions: Vec<_> = mesh.positions(cell).collect();
        let of_cell = cell_points(cell.kind, &positions).map(|point| {
            let at = Point {
                position: [point.y, point.z],
                nodes: cell.nodes(),
                shape: &point.n,
            };
            point.area * f(&at)
        });
        sum += modulus(index) * of_cell.sum::<f64>();
    }
    sum
}

/// Young's modulus of each material; zero for those without cells.
fn young_of_materials(section: &Section) -> Result<Vec<f64>, NoRestrainedWarping> {
    let mut young = vec![0.0; section.materials.len()];
    for cell in &section.cells {
        let material = &section.materials[cell.material];
        if young[cell.material] == 0.0 {
            young[cell.material] =
                isotropic_young(&material.law).ok_or_else(|| NoRestrainedWarping::Anisotropic {
                    material: material.name.clone(),
                })?;
        }
    }
    Ok(young)
}

/// Young's modulus \[Pa\] of an isotropic law, for any form of input.
fn isotropic_young(law: &ElasticLaw) -> Option<f64> {
    if let ElasticLaw::Isotropic { young, .. } = law {
        return Some(*young);
    }
    let stiffness = law.stiffness();
    let compliance = stiffness.try_inverse()?;
    let young = 1.0 / compliance[(0, 0)];
    let poisson = -compliance[(0, 1)] * young;
    let isotropic = ElasticLaw::Isotropic { young, poisson }.stiffness();
    let difference = (stiffness - isotropic).amax();
    (difference <= ISOTROPIC * stiffness.amax()).then_some(young)
}

/// The modulus of all cells, if they have one.
fn common(section: &Section, young: &[f64]) -> Option<f64> {
    let mut of_cells = section.cells.iter().map(|cell| young[cell.material]);
    let first = of_cells.next()?;
    of_cells.all(|young| young == first).then_some(first)
}

#[cfg(test)]
#[path = "restrained_tests.rs"]
mod tests;

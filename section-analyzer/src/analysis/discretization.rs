//! Discretization error of the stiffness, by a second analysis with richer cells.
//!
//! ```text
//! K - K_exact  is about  f (K - K_fine)                                           (S-170)
//! ```
//!
//! The finer cells have all displacements of the cells, on the same outline ([`refined`]): an
//! entry of K_fine is nearer to the exact value. If the second analysis
//! divides the error by q, f is q / (q - 1): 16/15 for quadratic cells cut into four and a
//! smooth solution (error of order four), less for linear cells that become quadratic, and
//! 1.7 next to an edge that leaves a quarter of the plane open.
//!
//! A single linear cell between both faces of a wall has, across it, all odd displacements of a
//! quadratic one, and transverse shear has only odd ones: if such cells are a part of the
//! section, linear cells become quadratic ones and are cut into four.

use super::analyze;
use crate::failure::Failure;
use crate::mesh::{Refined, alone_in_walls, refined};
use crate::section::Section;
use crate::solution::DiscretizationError;
use nalgebra::Matrix6;

/// f: for errors of order two, between smooth solutions and edges.
const FACTOR: f64 = 4.0 / 3.0;
/// Part of the area in single linear cells through walls from which the cells are also cut: below
/// it they are tips of sharp edges.
const ALONE: f64 = 0.05;

/// Estimate of the discretization error of `stiffness`, the result of [`analyze`] for the
/// same section. Angles of the materials are constant in a cell, and sides of linear cells are
/// straight: errors by these two are not part of the estimate.
///
/// # Errors
/// The errors of the second analysis, for up to four times the number of unknowns, or sixteen
/// times with single linear cells through a wall.
pub fn discretization_error(
    section: &Section,
    stiffness: &Matrix6<f64>,
) -> Result<DiscretizationError, Failure> {
    let mut finer = refined(&section.mesh);
    if alone_in_walls(&section.mesh) > ALONE {
        let again = refined(&finer.mesh);
        let originals = again.originals.iter().map(|&part| finer.originals[part]);
        finer = Refined {
            originals: originals.collect(),
            mesh: again.mesh,
        };
    }
    let cells = finer.originals.iter();
    let fine = Section {
        name: section.name.clone(),
        cells: cells.map(|&original| section.cells[original]).collect(),
        mesh: finer.mesh,
        materials: section.materials.clone(),
        initial_curvature: section.initial_curvature,
        electrodes: Vec::new(),
    };
    let fine = analyze(&fine)?;
    Ok(DiscretizationError {
        stiffness: FACTOR * (stiffness - fine.stiffness),
        unknowns: fine.unknowns,
    })
}

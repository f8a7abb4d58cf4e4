//! Input folders of BECAS: four tables of numbers.
//!
//! ```text
//! N2D.in       node, x, y
//! E2D.in       element, 4 or 8 nodes: corners, then middles of the sides, 0 for none
//! EMAT.in      element, material (row of MATPROPS.in), fiber angle, fiber plane angle [deg]
//! MATPROPS.in  E11 E22 E33 G12 G13 G23 nu12 nu13 nu23 density
//! ```
//!
//! BECAS' x, y in the section and z along the beam are Helicoid's y, z and x. The plane
//! angle turns the wall about z, from x toward y; the fiber, direction 1, turns from z toward
//! the wall, so that it is along the beam at zero: Helicoid's plane and fiber angle.
//!
//! # References
//! - J. P. Blasques, "User's manual for BECAS v2.0" (2012), inputs. The sense of the angles
//!   is the sense of BECAS' drawings of the material directions, and of its own converter
//!   to VABS, which copies both angles.

use super::model::{Layup, Model, ModelLaw, ModelMaterial, Raw};
use super::problem::{FileProblem, Problems};
use super::rows::{Rows, index};
use super::words::real;
use crate::error::Diagnostics;

/// Names of the files: nodes, elements, layups, materials.
pub const BECAS_FILES: [&str; 4] = ["N2D.in", "E2D.in", "EMAT.in", "MATPROPS.in"];

/// Reads the texts of the four files, in the order of [`BECAS_FILES`], each with its name for
/// messages.
///
/// # Errors
/// All problems of the files, each with its line.
pub fn read_becas(files: [(&str, &str); 4]) -> Result<Model, Diagnostics> {
    let mut raw = Raw::default();
    let mut problems: [Problems; 4] = Default::default();
    let [nodes, elements, layups, materials] = &mut problems;
    let [of_nodes, of_elements, of_layups, of_materials] = files.map(|(_, text)| text);
    each(of_nodes, nodes, |_, row| {
        let [tag, x, y] = counted(row, "a node", "its number, x and y")?;
        let at = [real(x, "coordinate")?, real(y, "coordinate")?];
        raw.elements.node(index(tag, "the number of a node")?, at)
    });
    each(of_elements, elements, |line, row| {
        if !matches!(row.len(), 5 | 9) {
            return Err(FileProblem::Count {
                what: "an element".to_owned(),
                found: row.len(),
                expected: "its number and 4 or 8 nodes".to_owned(),
            });
        }
        let mut nodes = [0; 9];
        for (node, word) in nodes.iter_mut().zip(&row[1..]) {
            *node = index(word, "the number of a node")?;
        }
        let tag = index(row[0], "the number of an element")?;
        raw.elements.element((line, tag), nodes)
    });
    each(of_layups, layups, |line, row| {
        let expected = "element, material, fiber angle and plane angle";
        let [element, material, fiber, plane] = counted(row, "a layup", expected)?;
        raw.layups.push(Layup {
            line,
            element: index(element, "the number of an element")?,
            material: index(material, "the number of a material")?,
            fiber_angle: real(fiber, "fiber angle")?,
            plane_angle: real(plane, "fiber plane angle")?,
        });
        Ok(())
    });
    let mut number = 0;
    each(of_materials, materials, |_, row| {
        number += 1;
        raw.materials.insert(number, material(number, row)?);
        Ok(())
    });
    let are_read = [&*nodes, elements, layups, materials]
        .iter()
        .all(|all| all.is_empty());
    // rows that could not be read would be missed by other files
    let model = are_read.then(|| raw.finish(elements, layups));
    let mut diagnostics = Diagnostics::new();
    for (problems, (file, _)) in problems.into_iter().zip(files) {
        diagnostics.keep(problems.into_result(file, ()));
    }
    diagnostics.into_result(model.unwrap_or_default())
}

/// A row of a material.
fn material(number: u64, row: &[&str]) -> Result<ModelMaterial, FileProblem> {
    let expected = "9 elastic constants and the density";
    let row: [&str; 10] = counted(row, "a material", expected)?;
    let mut values = [0.0; 10];
    for (value, word) in values.iter_mut().zip(row) {
        *value = real(word, "a constant of a material")?;
    }
    let [e1, e2, e3, g12, g13, g23, nu12, nu13, nu23, density] = values;
    let constants = [e1, e2, e3, g12, g13, g23, nu12, nu13, nu23];
    Ok(ModelMaterial {
        name: format!("m{number}"),
        law: ModelLaw::Orthotropic(constants),
        density,
    })
}

/// Reads each row of a table; problems are noted with their lines, and so is a table without
/// rows.
fn each<'a>(
    text: &'a str,
    problems: &mut Problems,
    mut read: impl FnMut(usize, &[&'a str]) -> Result<(), FileProblem>,
) {
    let mut rows = Rows::new(text);
    let mut count = 0;
    while let Some(row) = rows.next() {
        count += 1;
        problems.keep(rows.line(), read(rows.line(), &row));
    }
    if count == 0 {
        problems.push(1, FileProblem::CutOff("the first row"));
    }
}

/// The words of a row of `N` words.
fn counted<'a, const N: usize>(
    row: &[&'a str],
    what: &str,
    expected: &str,
) -> Result<[&'a str; N], FileProblem> {
    row.try_into().map_err(|_| FileProblem::Count {
        what: what.to_owned(),
        found: row.len(),
        expected: expected.to_owned(),
    })
}

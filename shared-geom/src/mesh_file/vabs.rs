//! Input files of VABS 3 and 4, as PreVABS, SONATA and BECAS write them too.
//!
//! ```text
//! format  layers                        1: new format, 0: old format without layers
//! Timoshenko  recovery or damping  thermal
//! curved  oblique  trapeze  Vlasov
//! k1 k2 k3                              if curved
//! cos11 cos21                           if oblique
//! nodes  elements  materials
//! node  x2 x3                           each node
//! element  9 nodes                      each element, see super::elements
//! element  layer  theta1                new: each element
//! element  material  theta3  9 theta1   old: each element
//! layer  material  theta3               new: each layer
//! material  kind                        each material; 0, 1, 2, and then its constants
//! E nu | E1 E2 E3 G12 G13 G23 nu12 nu13 nu23 | 21 terms of the upper triangle
//! density
//! ```
//!
//! VABS' axes x1 along the beam, x2, x3 are Helicoid's x, y, z. theta1 turns the wall about
//! x1, theta3 the fiber about the normal of the wall: plane angle and fiber angle. The nine
//! theta1 belong to the nodes; a second one above 360 states that the first one holds.
//! The order of the full stiffness is 11, 12, 13, 22, 23, 33.
//!
//! # References
//! - W. Yu, "VABS manual for users" (2013), inputs and conventions; the files of VABS 4.1
//!   and their results that the authors of sgio publish.

use std::collections::BTreeMap;

use super::model::{Layup, Model, ModelLaw, ModelMaterial, Raw};
use super::problem::{FileProblem, Problems, text};
use super::rows::{Rows, index, integer};
use super::words::real;
use crate::error::Diagnostics;

/// Positions of 11, 22, 33, 23, 13, 12 in the order of VABS.
const ORDER: [usize; 6] = [0, 3, 5, 4, 2, 1];
/// Largest angle theta1 \[deg\]; a larger second one states that the first one holds.
const FULL_TURN: f64 = 360.0;

/// Whether the file begins as VABS does: rows of 2, 3 and 3 or 4 whole numbers.
pub(super) fn recognize(content: &[u8]) -> bool {
    let head = content.get(..content.len().min(4096)).unwrap_or(content);
    let head = String::from_utf8_lossy(head);
    let mut rows = Rows::new(&head);
    let mut has = |counts: std::ops::RangeInclusive<usize>| {
        rows.next().is_some_and(|row| {
            counts.contains(&row.len()) && row.iter().all(|word| word.parse::<i64>().is_ok())
        })
    };
    has(2..=2) && has(3..=3) && has(3..=4)
}

/// Reads an input file of VABS.
///
/// # Errors
/// All problems of the file, each with its line.
pub(super) fn read(content: &[u8], file: &str) -> Result<Model, Diagnostics> {
    let mut reader = Reader {
        rows: Rows::new(text(content, file)?),
        problems: Problems::default(),
        raw: Raw::default(),
        spread: 0.0,
    };
    let read = reader.read();
    let line = reader.rows.line();
    let Reader {
        mut problems,
        mut raw,
        spread,
        ..
    } = reader;
    let bent = problems.keep(line, read);
    if spread > 0.0 {
        raw.notes.push(format!(
            "theta1 that varies within elements, by up to {spread:.3} deg from its mean: each \
             cell has the mean"
        ));
    }
    let mut layups = Problems::default();
    let mut model = raw.finish(&mut problems, &mut layups);
    if bent.is_some() {
        problems.append(layups);
    }
    if let Some(bent) = bent {
        (model.curvature, model.slope) = (bent.curvature, bent.slope);
        model.notes.extend(bent.note);
    }
    problems.into_result(file, model)
}

/// The undeformed beam.
#[derive(Debug, Default)]
struct Bent {
    curvature: Option<[f64; 3]>,
    slope: Option<[f64; 3]>,
    note: Option<String>,
}

struct Reader<'a> {
    rows: Rows<'a>,
    problems: Problems,
    raw: Raw,
    /// Largest deviation of a theta1 from the mean of its element \[deg\].
    spread: f64,
}

impl Reader<'_> {
    /// Reads the whole file; the first problem of the structure ends the reading, problems
    /// of single rows do not.
    fn read(&mut self) -> Result<Bent, FileProblem> {
        let head = self.integers("format and layers", 2..=2)?;
        let is_new = match head[0] {
            0 => false,
            1 => true,
            other => return Err(flag("format", other, "0 or 1")),
        };
        let flags = self.integers("the flags of the analysis", 3..=3)?;
        if flags[2] != 0 {
            return Err(flag(
                "thermal",
                flags[2],
                "0: set it to 0, and give the expansion of \
                the materials in the section file",
            ));
        }
        let bent = self.bent()?;
        let counts = self.integers("numbers of nodes, elements and materials", 3..=3)?;
        let [nodes, elements, materials] =
            [0, 1, 2].map(|at| usize::try_from(counts[at]).unwrap_or(0));
        for _ in 0..nodes {
            let row = self.rows.expect("the last node")?;
            let node = node(&row).and_then(|(tag, at)| self.raw.elements.node(tag, at));
            self.problems.keep(self.rows.line(), node);
        }
        let mut slots = BTreeMap::new();
        for _ in 0..elements {
            let row = self.rows.expect("the last element")?;
            let line = self.rows.line();
            let read = element(&row).and_then(|(tag, nodes)| {
                slots.insert(tag, nodes);
                self.raw.elements.element((line, tag), nodes)
            });
            self.problems.keep(line, read);
        }
        for _ in 0..elements {
            let row = self.rows.expect("the layup of the last element")?;
            let layup = self.layup(&row, is_new, &slots);
            let layup = self.problems.keep(self.rows.line(), layup);
            self.raw.layups.extend(layup);
        }
        if is_new {
            self.layers(head[1])?;
        }
        for _ in 0..materials {
            let (number, material) = self.material()?;
            self.raw.materials.insert(number, material);
        }
        Ok(bent)
    }

    /// The numbers of the next row, all whole.
    fn integers(
        &mut self,
        what: &'static str,
        count: std::ops::RangeInclusive<usize>,
    ) -> Result<Vec<i64>, FileProblem> {
        let row = self.rows.counted(what, count)?;
        row.iter().map(|word| integer(word, what)).collect()
    }

    /// The next row of real numbers.
    fn reals<const N: usize>(&mut self, what: &'static str) -> Result<[f64; N], FileProblem> {
        let row = self.rows.counted(what, N..=N)?;
        let mut values = [0.0; N];
        for (value, word) in values.iter_mut().zip(row) {
            *value = real(word, what)?;
        }
        Ok(values)
    }

    /// Reads the flags of the undeformed beam, its curvature and its obliqueness.
    fn bent(&mut self) -> Result<Bent, FileProblem> {
        let flags = self.integers("the flags of the beam", 3..=4)?;
        let mut bent = Bent::default();
        if flags[0] != 0 {
            let curvature = self.reals("k1, k2 and k3")?;
            bent.curvature = Some(curvature).filter(|k| k.iter().any(|k| *k != 0.0));
        }
        if flags[1] != 0 {
            let [along, across] = self.reals("the cosines of the oblique section")?;
            let rest = 1.0 - along * along - across * across;
            if along <= 0.0 || rest < -1e-9 {
                return Err(FileProblem::Header {
                    found: format!("the cosines are {along} and {across}"),
                    expected: "the first above zero, and a sum of squares of at most 1",
                });
            }
            // the file has two cosines: the third is the positive root, as digits allow
            let third = if rest > 1e-9 { rest.sqrt() } else { 0.0 };
            bent.note = (third > 0.0).then(|| {
                format!(
                    "the third cosine of the oblique section is +{third:.6}, which VABS derives"
                )
            });
            bent.slope = Some([along, across, third]).filter(|slope| *slope != [1.0, 0.0, 0.0]);
        }
        Ok(bent)
    }

    /// The layup of an element; in the new format the layer is in place of the material, and
    /// the fiber angle is still zero.
    fn layup(
        &mut self,
        row: &[&str],
        is_new: bool,
        slots: &BTreeMap<u64, [u64; 9]>,
    ) -> Result<Layup, FileProblem> {
        let first = if is_new { 2 } else { 3 };
        let element = index(row.first().unwrap_or(&""), "the number of an element")?;
        let angles = row.get(first..).unwrap_or_default();
        if !matches!(angles.len(), 1 | 9) {
            return Err(FileProblem::Count {
                what: format!("the layup of element {element}"),
                found: row.len(),
                expected: if is_new {
                    "element, layer and theta1".to_owned()
                } else {
                    "element, material, theta3 and 9 theta1".to_owned()
                },
            });
        }
        let angles = angles.iter().map(|word| real(word, "theta1"));
        let angles: Vec<f64> = angles.collect::<Result<_, _>>()?;
        let nodes = slots.get(&element).copied().unwrap_or([1; 9]);
        Ok(Layup {
            line: self.rows.line(),
            element,
            material: index(row[1], if is_new { "a layer" } else { "a material" })?,
            fiber_angle: if is_new { 0.0 } else { real(row[2], "theta3")? },
            plane_angle: self.mean(&angles, nodes),
        })
    }

    /// The angle of an element from the angles of its nodes \[deg\].
    fn mean(&mut self, angles: &[f64], nodes: [u64; 9]) -> f64 {
        let first = angles.first().copied().unwrap_or(0.0);
        if angles.get(1).is_none_or(|second| *second > FULL_TURN) {
            return first;
        }
        let own = || angles.iter().zip(nodes).filter(|(_, node)| *node != 0);
        // turns relative to the first, within half a turn
        let turn = |angle: f64| (angle - first + 180.0).rem_euclid(360.0) - 180.0;
        let count = own().count().max(1) as f64;
        let mean = own().map(|(angle, _)| turn(*angle)).sum::<f64>() / count;
        let far = own().map(|(angle, _)| (turn(*angle) - mean).abs());
        self.spread = far.fold(self.spread, f64::max);
        first + mean
    }

    /// Reads the layers, and gives each layup the material and the fiber angle of its layer.
    fn layers(&mut self, count: i64) -> Result<(), FileProblem> {
        let mut layers = BTreeMap::new();
        for _ in 0..count.max(0) {
            let row = self.rows.counted("a layer", 3..=3)?;
            let layer = index(row[0], "the number of a layer")?;
            let material = index(row[1], "the material of a layer")?;
            layers.insert(layer, (material, real(row[2], "theta3")?));
        }
        let mut known = Vec::new();
        for mut layup in self.raw.layups.drain(..) {
            let Some(&(material, fiber_angle)) = layers.get(&layup.material) else {
                let problem = FileProblem::Unknown {
                    who: format!("element {}", layup.element),
                    what: "layer",
                    number: layup.material,
                };
                self.problems.push(layup.line, problem);
                continue;
            };
            (layup.material, layup.fiber_angle) = (material, fiber_angle);
            known.push(layup);
        }
        self.raw.layups = known;
        Ok(())
    }

    /// Reads a material: its number and kind, its constants, its density.
    fn material(&mut self) -> Result<(u64, ModelMaterial), FileProblem> {
        let row = self.rows.counted("number and kind of a material", 2..=2)?;
        let number = index(row[0], "the number of a material")?;
        let law = match integer(row[1], "the kind of a material")? {
            0 => ModelLaw::Isotropic(self.constants()?),
            1 => ModelLaw::Orthotropic(self.constants()?),
            2 => {
                let upper: [f64; 21] = self.constants()?;
                let mut stiffness = [[0.0; 6]; 6];
                let mut terms = upper.iter();
                for row in 0..6 {
                    for (column, value) in (row..6).zip(&mut terms) {
                        stiffness[row][column] = *value;
                        stiffness[column][row] = *value;
                    }
                }
                let full = ORDER.map(|row| ORDER.map(|column| stiffness[row][column]));
                ModelLaw::Full(Box::new(full))
            }
            other => return Err(flag("kind of a material", other, "0, 1 or 2")),
        };
        let row = self.rows.expect("the density of a material")?;
        let material = ModelMaterial {
            name: format!("m{number}"),
            law,
            density: real(row[0], "density")?,
        };
        Ok((number, material))
    }

    /// The next `N` numbers, in any number of rows.
    fn constants<const N: usize>(&mut self) -> Result<[f64; N], FileProblem> {
        let mut values = [0.0; N];
        let mut read = 0;
        while read < N {
            let row = self.rows.expect("the constants of a material")?;
            for word in &row {
                let value = real(word, "a constant of a material")?;
                let Some(slot) = values.get_mut(read) else {
                    return Err(FileProblem::Count {
                        what: "the last constants of a material".to_owned(),
                        found: row.len(),
                        expected: format!("{N} constants in all, and the density in a new row"),
                    });
                };
                *slot = value;
                read += 1;
            }
        }
        Ok(values)
    }
}

/// A flag with a value that is not read.
fn flag(name: &str, found: i64, expected: &'static str) -> FileProblem {
    let found = format!("the flag \"{name}\" is {found}");
    FileProblem::Header { found, expected }
}

/// A row of a node.
fn node(row: &[&str]) -> Result<(u64, [f64; 2]), FileProblem> {
    let [tag, y, z] = row else {
        return Err(FileProblem::Count {
            what: "a node".to_owned(),
            found: row.len(),
            expected: "its number, x2 and x3".to_owned(),
        });
    };
    let at = [real(y, "coordinate")?, real(z, "coordinate")?];
    Ok((index(tag, "the number of a node")?, at))
}

/// A row of an element.
fn element(row: &[&str]) -> Result<(u64, [u64; 9]), FileProblem> {
    if !(4..=10).contains(&row.len()) {
        return Err(FileProblem::Count {
            what: "an element".to_owned(),
            found: row.len(),
            expected: "its number and 9 nodes, 0 for absent ones".to_owned(),
        });
    }
    let mut nodes = [0; 9];
    for (node, word) in nodes.iter_mut().zip(&row[1..]) {
        *node = index(word, "the number of a node")?;
    }
    Ok((index(row[0], "the number of an element")?, nodes))
}

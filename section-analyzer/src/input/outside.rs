//! Sections given by their matrices: the file as written, and as meant.
//!
//! [`read`] takes a matrices file, its node table and its Matrix Market files to a
//! checked [`OutsideSection`] in SI units. It notes all problems before it gives up.

use std::path::Path;

use nalgebra::{DMatrix, Matrix6, Vector6};
use shared_geom::document::{Document, Table, read_text};
use shared_geom::error::Diagnostics;
use shared_geom::files::name_without;
use shared_geom::units::Dimension;
use sprs::CsMat;

use super::curvature;
use super::files::Files;
use super::regions::Written;
use crate::section::{Blocks, OutsideSection, Reduced, Through};

mod matrix_market;
mod nodes;
mod problem;

pub use problem::MatrixProblem;

use nodes::NodeTable;

/// The ending of the name of a matrices file.
const ENDING: &str = ".matrices.toml";

/// A section given by its matrices, and the fingerprint of all that was read.
#[derive(Debug, Clone)]
pub struct OutsideInput {
    /// The section, checked and in SI units.
    pub section: OutsideSection,
    /// Hash of all files.
    pub input_hash: String,
}

/// Reads and checks the matrices file at `path`, its node table and its matrices.
///
/// # Errors
/// Everything that is wrong with any of them, with file and line.
pub fn read(path: &Path) -> Result<OutsideInput, Diagnostics> {
    parse(&read_text(path)?, path)
}

/// Reads and checks the text of a matrices file, as if it stood at `path`.
///
/// # Errors
/// As [`read`].
pub fn parse(text: &str, path: &Path) -> Result<OutsideInput, Diagnostics> {
    let document = Document::parse(text, &path.display().to_string())?;
    let root = document.root();
    document.declare_units(&root);
    let mut reading = Reading {
        document: &document,
        files: Files::new(&document, text),
    };
    let section = reading.section(&root, name_of(path));
    root.finish();
    let input_hash = reading.files.hash();
    document.finish(section.map(|section| OutsideInput {
        section,
        input_hash,
    }))
}

/// The name of `path` without its ending.
pub fn name_of(path: &Path) -> String {
    name_without(path, ENDING)
}

struct Reading<'a> {
    document: &'a Document,
    files: Files<'a>,
}

impl Reading<'_> {
    fn section(&mut self, root: &Table<'_>, name: String) -> Option<OutsideSection> {
        let name = root.text("name").unwrap_or(name);
        let nodes = self.nodes(root);
        let count = nodes.as_ref().map(|nodes| nodes.tags.len());
        let initial_curvature = curvature::read(root).map(|written| written.initial);
        let given_mass = mass(root);
        let matrices = root.is_table("matrices").then(|| root.table("matrices"));
        let slice = root.is_table("slice").then(|| root.table("slice"));
        let found = match (matrices.flatten(), slice.flatten()) {
            (Some(table), None) => self.matrices(&table, count),
            (None, Some(table)) => self.slice(&table, count),
            (Some(_), Some(_)) => {
                root.note("slice", &form("[matrices] and [slice] are given"));
                None
            }
            (None, None) => {
                root.note("", &form("neither [matrices] nor [slice] is given"));
                None
            }
        };
        let (blocks, reduced, slice_mass) = found?;
        let nodes = nodes?;
        let of_slice = slice_mass.map(|mass| mass_of(&mass, &nodes.places));
        Some(OutsideSection {
            name,
            tags: nodes.tags,
            nodes: nodes.places,
            blocks,
            reduced,
            mass: given_mass?.or(of_slice).unwrap_or_else(Matrix6::zeros),
            initial_curvature: initial_curvature?,
        })
    }

    fn nodes(&mut self, root: &Table<'_>) -> Option<NodeTable> {
        let text = root.require_text("nodes", "the path of a node table, from this file's folder");
        let written = Written {
            text: text?,
            line: root.line_of("nodes"),
        };
        let path = self.files.path(&written);
        let text = self.files.read_text("node table", &path, &written)?;
        let unit = self.document.factor(Dimension::LENGTH);
        let table = NodeTable::parse(&text, &path.display().to_string(), unit);
        self.document.keep(table)
    }

    /// `[matrices]`: the blocks.
    fn matrices(&mut self, table: &Table<'_>, nodes: Option<usize>) -> Option<Given> {
        let square = nodes.map(|nodes| [3 * nodes, 3 * nodes]);
        let tall = nodes.map(|nodes| [3 * nodes, 6]);
        let m = self.matrix(table, "m", true, Dimension::FORCE, square);
        let c = self.matrix(table, "c", true, Dimension::FORCE_PER_LENGTH, square);
        let e = self.matrix(table, "e", true, Dimension::STRESS, square);
        let l = self.matrix(table, "l", false, Dimension::FORCE, tall);
        let r = self.matrix(table, "r", false, Dimension::FORCE_PER_LENGTH, tall);
        let a = self.matrix(table, "a", false, Dimension::FORCE, nodes.map(|_| [6, 6]));
        table.finish();
        // columns of curvatures have one more length
        let length = self.document.factor(Dimension::LENGTH);
        let unit = Vector6::new(1.0, 1.0, 1.0, length, length, length);
        let columns = |matrix: CsMat<f64>| {
            let dense = dense(&matrix);
            DMatrix::from_fn(dense.nrows(), 6, |i, k| unit[k] * dense[(i, k)])
        };
        let reduced = Reduced {
            l: l.map(columns),
            r: r.map(columns),
            a: a.map(|a| {
                let scaled = columns(a);
                Matrix6::from_fn(|i, k| unit[i] * scaled[(i, k)])
            }),
        };
        let blocks = Blocks {
            m: m?,
            c: c?,
            e: e?,
        };
        Some((blocks, reduced, None))
    }

    /// `[slice]`: the stiffness of a slice, and its mass.
    fn slice(&mut self, table: &Table<'_>, nodes: Option<usize>) -> Option<Given> {
        let square = nodes.map(|nodes| [6 * nodes, 6 * nodes]);
        let stiffness = self.matrix(
            table,
            "stiffness",
            true,
            Dimension::SPRING_STIFFNESS,
            square,
        );
        let mass = self.matrix(table, "mass", false, Dimension::MASS, square);
        let thickness = table.require_positive("thickness", Dimension::LENGTH);
        let through = match table.word("through", &["linear", "middle"]) {
            Some(1) => Through::Middle,
            _ => Through::Linear,
        };
        table.finish();
        let (stiffness, thickness) = (stiffness?, thickness?);
        let blocks = Blocks::of_slice(&stiffness, thickness, through);
        let per_length = mass.map(|mass| folded(&mass, thickness));
        Some((blocks, Reduced::default(), per_length))
    }

    /// The matrix that `key` names, in SI, of `size`.
    fn matrix(
        &mut self,
        table: &Table<'_>,
        key: &str,
        is_required: bool,
        unit: Dimension,
        size: Option<[usize; 2]>,
    ) -> Option<CsMat<f64>> {
        if !is_required && !table.has(key) {
            return None;
        }
        let text = table.require_text(key, "the path of a Matrix Market file")?;
        let written = Written {
            text,
            line: table.line_of(key),
        };
        let path = self.files.path(&written);
        let text = self.files.read_text("matrix", &path, &written)?;
        let read = matrix_market::parse(&text, &path.display().to_string());
        let matrix = self.document.keep(read)?;
        let [rows, columns] = size?;
        if [matrix.rows(), matrix.cols()] != [rows, columns] {
            let problem = MatrixProblem::Size {
                what: format!("\"{}\"", written.text),
                found: format!("{} x {}", matrix.rows(), matrix.cols()),
                expected: format!("{rows} x {columns}"),
                why: format!("\"{key}\" with the nodes of the table"),
            };
            table.note(key, &problem);
            return None;
        }
        let factor = self.document.factor(unit);
        Some(matrix.map(|value| factor * value))
    }
}

/// Blocks, L R A as given, and a mass matrix over the nodes per length.
type Given = (Blocks, Reduced, Option<CsMat<f64>>);

fn form(found: &'static str) -> MatrixProblem {
    MatrixProblem::Form { found }
}

/// `mass`: 6 x 6 per length about the reference point. `None` when it is wrong.
fn mass(root: &Table<'_>) -> Option<Option<Matrix6<f64>>> {
    if !root.has("mass") {
        return Some(None);
    }
    let rows = root.rows("mass", 6, 6)?;
    let document = root.document();
    let per_length = document.factor(Dimension::MASS_PER_LENGTH);
    let length = document.factor(Dimension::LENGTH);
    let unit = Vector6::new(1.0, 1.0, 1.0, length, length, length);
    Some(Some(Matrix6::from_fn(|i, j| {
        per_length * unit[i] * unit[j] * rows[i][j]
    })))
}

fn dense(matrix: &CsMat<f64>) -> DMatrix<f64> {
    let mut dense = DMatrix::zeros(matrix.rows(), matrix.cols());
    for (&value, (i, j)) in matrix {
        dense[(i, j)] += value;
    }
    dense
}

/// The mass matrix of a slice for motions that are the same on both faces, per length.
fn folded(mass: &CsMat<f64>, thickness: f64) -> CsMat<f64> {
    let n = mass.rows() / 2;
    let mut sum = sprs::TriMat::new((n, n));
    for (&value, (i, j)) in mass {
        sum.add_triplet(i % n, j % n, value / thickness);
    }
    sum.to_csr()
}

/// `H' m H`: mass per length of the section from that of its nodes.
fn mass_of(mass: &CsMat<f64>, nodes: &[[f64; 2]]) -> Matrix6<f64> {
    let motion = |i: usize| {
        let [y, z] = nodes[i / 3];
        crate::element::rigid_displacement(1.0, y, z)
            .row(i % 3)
            .transpose()
    };
    let mut sum = Matrix6::zeros();
    for (&value, (i, j)) in mass {
        sum += value * motion(i) * motion(j).transpose();
    }
    0.5 * (sum + sum.transpose())
}

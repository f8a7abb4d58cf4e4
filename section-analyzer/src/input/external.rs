//! Reads and checks sections given by their matrices.
//!
//! [`read`] converts a matrices file, its node table and its Matrix Market files to a
//! checked [`ExternalSection`] in SI units. It notes all problems before it fails.

use std::path::Path;

use nalgebra::{DMatrix, Matrix6, Vector6};
use shared_geom::document::{Document, Table, read_text};
use shared_geom::error::Diagnostics;
use shared_geom::file_kind::FileKind;
use shared_geom::files::name_without;
use shared_geom::section;
use shared_geom::units::Dimension;
use sprs::CsMat;

use super::curvature;
use super::files::Files;
use super::regions::Written;
use super::requests::END_EFFECTS;
use crate::section::{Blocks, ExternalSection, Reduced, Slice, Through};

mod keys;
mod matrix_market;
mod nodes;
mod problem;

pub use problem::MatrixProblem;

pub(super) use keys::MATRICES_FILE;

use keys::{
    A, C, E, L, M, MASS, MATRICES, NAME, NODES, R, SLICE, SLICE_MASS, STIFFNESS, THICKNESS, THROUGH,
};
use nodes::NodeTable;

/// The ending of the name of a matrices file.
const ENDING: &str = ".matrices.toml";

/// A section given by its matrices, and the fingerprint of its files.
#[derive(Debug, Clone)]
pub struct ExternalInput {
    /// The section, checked and in SI units.
    pub section: ExternalSection,
    /// Hash of all files.
    pub input_hash: String,
}

/// Reads and checks the matrices file at `path`, its node table and its matrices.
///
/// # Errors
/// All problems of these files, with file and line.
pub fn read(path: &Path) -> Result<ExternalInput, Diagnostics> {
    let text = read_text(path)?;
    FileKind::Matrices.require(path, &text)?;
    parse(&text, path)
}

/// Reads and checks the text of a matrices file, as if it were at `path`.
///
/// # Errors
/// As [`read`].
pub fn parse(text: &str, path: &Path) -> Result<ExternalInput, Diagnostics> {
    let document = Document::parse(text, &path.display().to_string())?;
    let root = document.root_of(&MATRICES_FILE);
    document.declare_units(&root);
    let mut reading = Reading {
        document: &document,
        files: Files::new(&document, text),
    };
    let section = reading.section(&root, name_of(path));
    root.finish();
    let input_hash = reading.files.hash();
    document.finish(section.map(|section| ExternalInput {
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
    fn section(&mut self, root: &Table<'_>, name: String) -> Option<ExternalSection> {
        let name = root.get(&NAME).flatten().unwrap_or(name);
        let nodes = self.nodes(root);
        let count = nodes.as_ref().map(|nodes| nodes.tags.len());
        let initial_curvature = curvature::read(root).map(|written| written.initial);
        let end_effects = root.get(&END_EFFECTS).flatten();
        let given_mass = mass(root);
        if root.has(&SLICE) && root.has(&curvature::BEAM) {
            root.note(&curvature::BEAM, &MatrixProblem::CurvedSlice);
        }
        let found = match (root.has(&MATRICES), root.has(&SLICE)) {
            (true, false) => root.nested(&MATRICES, |table| self.matrices(table, count))?,
            (false, true) => root.nested(&SLICE, |table| {
                self.slice(table, nodes.as_ref(), root.has(&MASS))
            })?,
            (true, true) => {
                root.note(&SLICE, &form("both [matrices] and [slice] are given"));
                None
            }
            (false, false) => {
                root.note("", &form("neither [matrices] nor [slice] is given"));
                None
            }
        };
        let (found, nodes) = (found?, nodes?);
        Some(ExternalSection {
            name,
            tags: nodes.tags,
            nodes: nodes.positions,
            blocks: found.blocks,
            slice: found.slice,
            reduced: found.reduced,
            mass: given_mass?.or(found.mass).unwrap_or_else(Matrix6::zeros),
            initial_curvature: initial_curvature?,
            end_effects,
        })
    }

    fn nodes(&mut self, root: &Table<'_>) -> Option<NodeTable> {
        let written = root.get(&NODES)?;
        let path = self.files.path(&written);
        let text = self.files.read_text("node table", &path, &written)?;
        let unit = self.document.factor(Dimension::LENGTH);
        let table = NodeTable::parse(&text, &path.display().to_string(), unit);
        self.document.keep(table)
    }

    /// `[matrices]`: the blocks.
    fn matrices(&mut self, table: &Table<'_>, nodes: Option<usize>) -> Option<ReadMatrices> {
        let square = nodes.map(|nodes| [3 * nodes, 3 * nodes]);
        let tall = nodes.map(|nodes| [3 * nodes, 6]);
        let m = self.matrix(table, (M.name(), table.get(&M)), Dimension::FORCE, square);
        let c = self.matrix(
            table,
            (C.name(), table.get(&C)),
            Dimension::FORCE_PER_LENGTH,
            square,
        );
        let e = self.matrix(table, (E.name(), table.get(&E)), Dimension::STRESS, square);
        let l = self.matrix(
            table,
            (L.name(), table.get(&L).flatten()),
            Dimension::FORCE,
            tall,
        );
        let r = self.matrix(
            table,
            (R.name(), table.get(&R).flatten()),
            Dimension::FORCE_PER_LENGTH,
            tall,
        );
        let a = self.matrix(
            table,
            (A.name(), table.get(&A).flatten()),
            Dimension::FORCE,
            nodes.map(|_| [6, 6]),
        );
        // columns of curvatures contain one more length
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
        Some(ReadMatrices {
            blocks,
            slice: None,
            reduced,
            mass: None,
        })
    }

    /// `[slice]`: the stiffness of a slice, and its mass, unless the mass of the section
    /// `is_given`.
    fn slice(
        &mut self,
        table: &Table<'_>,
        nodes: Option<&NodeTable>,
        is_given: bool,
    ) -> Option<ReadMatrices> {
        let square = nodes.map(|nodes| [6 * nodes.tags.len(), 6 * nodes.tags.len()]);
        let unit = Dimension::SPRING_STIFFNESS;
        let stiffness = self.matrix(
            table,
            (STIFFNESS.name(), table.get(&STIFFNESS)),
            unit,
            square,
        );
        let mass = self.matrix(
            table,
            (SLICE_MASS.name(), table.get(&SLICE_MASS).flatten()),
            Dimension::MASS,
            square,
        );
        let thickness = table.get(&THICKNESS);
        let through = match table.get(&THROUGH) {
            Some(1) => Through::Middle,
            _ => Through::Linear,
        };
        if is_given && table.has(&SLICE_MASS) {
            table.note(&SLICE_MASS, &form("\"mass\" is given above too"));
        }
        for (key, matrix) in [(STIFFNESS.name(), &stiffness), (SLICE_MASS.name(), &mass)] {
            if let Some(problem) = matrix.as_ref().and_then(asymmetry) {
                table.note(key, &problem);
            }
        }
        let (stiffness, thickness) = (stiffness?, thickness?);
        let slice = Slice { thickness, through };
        let mass = mass.zip(nodes).map(|(mass, nodes)| {
            let mass = mass_of(&folded(&mass, thickness), &nodes.positions);
            for problem in section::mass_problems(&mass) {
                table.note(&SLICE_MASS, &problem);
            }
            mass
        });
        Some(ReadMatrices {
            blocks: Blocks::of_slice(&stiffness, slice),
            slice: Some(slice),
            reduced: Reduced::default(),
            mass,
        })
    }

    /// The matrix in the file `written` under `key`, in SI, of `size`.
    fn matrix(
        &mut self,
        table: &Table<'_>,
        (key, written): (&str, Option<Written>),
        unit: Dimension,
        size: Option<[usize; 2]>,
    ) -> Option<CsMat<f64>> {
        let written = written?;
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

/// Matrices given in a file.
struct ReadMatrices {
    blocks: Blocks,
    slice: Option<Slice>,
    reduced: Reduced,
    /// Mass per length about the reference point.
    mass: Option<Matrix6<f64>>,
}

/// Largest asymmetry of the matrices of a slice, relative to their largest entry: files
/// of seven digits pass.
const SYMMETRY: f64 = 1e-6;

/// The pair of entries that differ most, if a matrix is not symmetric.
fn asymmetry(matrix: &CsMat<f64>) -> Option<MatrixProblem> {
    let mut worst = (0.0, (0, 0));
    let mut largest: f64 = 0.0;
    for (&value, (i, j)) in matrix {
        largest = largest.max(value.abs());
        let other = matrix.get(j, i).copied().unwrap_or(0.0);
        let off = (value - other).abs();
        if off > worst.0 {
            worst = (off, (i.min(j), i.max(j)));
        }
    }
    let (off, (row, column)) = worst;
    let entry = |i, j| matrix.get(i, j).copied().unwrap_or(0.0);
    (off > SYMMETRY * largest).then(|| MatrixProblem::Asymmetric {
        row: row + 1,
        column: column + 1,
        upper: entry(row, column),
        lower: entry(column, row),
    })
}

fn form(found: &'static str) -> MatrixProblem {
    MatrixProblem::Form { found }
}

/// `mass`: 6 x 6 per length about the reference point. `None` if it is wrong.
fn mass(root: &Table<'_>) -> Option<Option<Matrix6<f64>>> {
    let Some(rows) = root.get(&MASS)? else {
        return Some(None);
    };
    let document = root.document();
    let per_length = document.factor(Dimension::MASS_PER_LENGTH);
    let length = document.factor(Dimension::LENGTH);
    let unit = Vector6::new(1.0, 1.0, 1.0, length, length, length);
    let mass = Matrix6::from_fn(|i, j| per_length * unit[i] * unit[j] * rows[i][j]);
    let problems = section::mass_problems(&mass);
    for problem in &problems {
        root.note(&MASS, problem);
    }
    problems.is_empty().then_some(Some(mass))
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

/// `H' m H`: mass per length of the section from the mass of its nodes.
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

//! The matrix of all stages of a scheme.

use super::{Arc, Combination, Dae, Pattern, Residual, STAGES, Sparse};

/// Assembly of the blocks (D-112) of a scheme into one matrix, in which the stages of an
/// unknown are adjacent: an order of the unknowns suited to one stage then suits all.
#[derive(Debug)]
pub(in crate::integrator) struct StageMatrix {
    stages: usize,
    /// Pattern of the matrix.
    pattern: Arc<Pattern>,
    /// The blocks of one row of stages; empty with one stage.
    blocks: Vec<Sparse>,
    /// For each block, row by row, the index in the matrix of each of its entries.
    indices: Vec<Vec<Option<u32>>>,
}

impl StageMatrix {
    /// For a system of the given pattern.
    pub fn new(pattern: &Arc<Pattern>, stages: usize, algebraic: &[bool]) -> Self {
        if stages == 1 {
            return Self {
                stages,
                pattern: Arc::clone(pattern),
                blocks: Vec::new(),
                indices: Vec::new(),
            };
        }
        let of_block = |row: usize, column: usize| {
            entries(pattern).map(move |(i, j)| {
                let is_stored = row == column || !algebraic[j];
                is_stored.then_some((stages * i + row, stages * j + column))
            })
        };
        let blocks = || (0..stages).flat_map(|row| (0..stages).map(move |column| (row, column)));
        let whole = Pattern::of(stages * pattern.size(), |add| {
            for (row, column) in blocks() {
                let stored = of_block(row, column).flatten();
                stored.for_each(|(i, j)| add(i, j));
            }
        });
        let index = |stored: Option<(usize, usize)>| {
            let index = stored.and_then(|(i, j)| whole.index(i, j));
            index.map(|index| index as u32)
        };
        let indices = blocks().map(|(row, column)| of_block(row, column).map(index).collect());
        Self {
            stages,
            blocks: vec![Sparse::zero(Arc::clone(pattern)); stages],
            indices: indices.collect(),
            pattern: Arc::new(whole),
        }
    }

    /// The pattern of the matrix.
    pub fn pattern(&self) -> &Arc<Pattern> {
        &self.pattern
    }

    /// Fills a matrix, with any previous values, at the present stages of the system; `weights`
    /// are the weights of the scheme times the step, and `residuals`, if given, takes the
    /// residuals of the stages.
    pub fn combine(
        &mut self,
        dae: &mut dyn Dae,
        weights: &[[f64; STAGES]; STAGES],
        (matrix, mut residuals): (&mut Sparse, Option<&mut [Residual]>),
    ) {
        if self.stages == 1 {
            let sum = block(weights[0][0], true, matrix);
            let residual = residuals.map(|all| &mut all[0]);
            dae.jacobian(0, &mut [sum], residual);
            return;
        }
        for row in 0..self.stages {
            let weight = weights[row];
            let residual = residuals.as_deref_mut().map(|all| &mut all[row]);
            match &mut self.blocks[..] {
                [a, b] => dae.jacobian(
                    row,
                    &mut [block(weight[0], row == 0, a), block(weight[1], row == 1, b)],
                    residual,
                ),
                [a, b, c] => dae.jacobian(
                    row,
                    &mut [
                        block(weight[0], row == 0, a),
                        block(weight[1], row == 1, b),
                        block(weight[2], row == 2, c),
                    ],
                    residual,
                ),
                _ => {}
            }
            self.scatter(row, matrix);
        }
    }

    fn scatter(&self, row: usize, matrix: &mut Sparse) {
        let indices = &self.indices[row * self.stages..];
        for (block, indices) in self.blocks.iter().zip(indices) {
            for (value, index) in block.values().iter().zip(indices) {
                if let Some(index) = index {
                    matrix.values_mut()[*index as usize] = *value;
                }
            }
        }
    }
}

/// A block (D-112), written to `matrix`.
fn block(weight: f64, is_diagonal: bool, matrix: &mut Sparse) -> Combination<'_> {
    let diagonal = if is_diagonal { 1.0 } else { 0.0 };
    Combination {
        by_unknowns: weight,
        by_rates: diagonal,
        by_algebraic: diagonal,
        matrix,
    }
}

/// Row and column of each entry of a pattern.
fn entries(pattern: &Pattern) -> impl Iterator<Item = (usize, usize)> + '_ {
    (0..pattern.size()).flat_map(move |column| {
        let range = pattern.column_starts()[column]..pattern.column_starts()[column + 1];
        range.map(move |index| (pattern.rows()[index] as usize, column))
    })
}

//! Factorizations of matrices on one pattern: ours on kept pivots, and faer's with its
//! symbolic analysis kept, on the same matrices.

use std::hint::black_box;
use std::sync::Arc;
use std::time::{Duration, Instant};

use beam_dynamics::assembly::{Pattern, Sparse};
use beam_dynamics::solver::StepSolver;
use cpu_time::ThreadTime;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::lu::{LuSymbolicParams, NumericLu, SymbolicLu, factorize_symbolic_lu};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Spec};

/// Numbers between -1 and 1 without order.
pub struct Scattered(pub u64);

impl Scattered {
    pub fn next(&mut self) -> f64 {
        // The generator of Knuth's MMIX; its upper bits are the scattered ones.
        let (factor, sum) = (6_364_136_223_846_793_005, 1_442_695_040_888_963_407);
        self.0 = self.0.wrapping_mul(factor).wrapping_add(sum);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// faer's factorization of a pattern.
struct Peer<'a> {
    view: SymbolicSparseColMatRef<'a, usize>,
    symbolic: SymbolicLu<usize>,
    numeric: NumericLu<usize, f64>,
    memory: MemBuffer,
}

impl<'a> Peer<'a> {
    fn new(pattern: &'a Pattern, rows: &'a [usize], blocks: SupernodalThreshold) -> Option<Self> {
        let (n, starts) = (pattern.size(), pattern.column_starts());
        let view = SymbolicSparseColMatRef::new_checked(n, n, starts, None, rows);
        let parameters = LuSymbolicParams {
            supernodal_flop_ratio_threshold: blocks,
            ..Default::default()
        };
        let symbolic = factorize_symbolic_lu(view, parameters).ok()?;
        let scratch = symbolic.factorize_numeric_lu_scratch::<f64>(Par::Seq, Spec::default());
        let scratch = scratch.or(symbolic.solve_in_place_scratch::<f64>(1, Par::Seq));
        Some(Self {
            view,
            symbolic,
            numeric: NumericLu::new(),
            memory: MemBuffer::new(scratch),
        })
    }

    /// Factorizes and solves; times of both are the shortest so far.
    fn run(&mut self, matrix: &Sparse, b: &mut [f64], times: &mut Times) -> Option<()> {
        let view = SparseColMatRef::new(self.view, matrix.values());
        let (symbolic, numeric, memory) = (&self.symbolic, &mut self.numeric, &mut self.memory);
        let factors = timed(&mut times.factorization, || {
            let (stack, spec) = (MemStack::new(memory), Spec::default());
            symbolic.factorize_numeric_lu(numeric, view, Par::Seq, stack, spec)
        });
        let factors = factors.ok()?;
        let right_side = MatMut::from_column_major_slice_mut(b, self.view.nrows(), 1);
        timed(&mut times.solution, || {
            let stack = MemStack::new(memory);
            factors.solve_in_place_with_conj(Conj::No, right_side, Par::Seq, stack);
        });
        Some(())
    }
}

fn timed<T>(shortest: &mut Duration, work: impl FnOnce() -> T) -> T {
    let begin = ThreadTime::now();
    let made = black_box(work());
    *shortest = begin.elapsed().min(*shortest);
    made
}

/// Shortest times, and the error of the last solution.
#[derive(Debug, Clone, Copy)]
pub struct Times {
    pub factorization: Duration,
    pub solution: Duration,
    /// Largest residual relative to the terms of its equation (D-135) [-].
    pub error: f64,
}

impl Times {
    const NONE: Self = Self {
        factorization: Duration::MAX,
        solution: Duration::MAX,
        error: f64::INFINITY,
    };
}

/// Our factorization beside faer's.
#[derive(Debug)]
pub struct Comparison {
    pub solver: StepSolver,
    /// Time of the first factorization, which chooses the pivots.
    pub choice: Duration,
    pub own: Times,
    pub peer: Times,
}

impl Comparison {
    /// Factorizations of `original` with all values changed, call by call, by a part of up to
    /// `change`, in turns for the time `span`, three at least; `None` when a matrix has no
    /// factors.
    pub fn of(
        original: &Sparse,
        change: f64,
        blocks: SupernodalThreshold,
        span: Duration,
    ) -> Option<Self> {
        let pattern = Arc::clone(original.pattern());
        let rows: Vec<_> = pattern.rows().iter().map(|&row| row as usize).collect();
        let mut peer = Peer::new(&pattern, &rows, blocks)?;
        let mut made = Self {
            solver: StepSolver::new(&pattern),
            choice: Duration::MAX,
            own: Times::NONE,
            peer: Times::NONE,
        };
        timed(&mut made.choice, || made.solver.factorize(original))?;
        let mut matrix = original.clone();
        let mut scattered = Scattered(11);
        let b: Vec<_> = (0..pattern.size()).map(|_| scattered.next()).collect();
        let (begin, mut runs) = (Instant::now(), 0);
        while runs < 3 || begin.elapsed() < span {
            let values = matrix.values_mut().iter_mut().zip(original.values());
            values.for_each(|(value, original)| {
                *value = original * (1.0 + change * scattered.next());
            });
            let (solver, own) = (&mut made.solver, &mut made.own);
            let (mut x, mut theirs) = (b.clone(), b.clone());
            timed(&mut own.factorization, || solver.factorize(&matrix))?;
            timed(&mut own.solution, || solver.solve(&mut x))?;
            own.error = error(&matrix, &x, &b);
            peer.run(&matrix, &mut theirs, &mut made.peer)?;
            made.peer.error = error(&matrix, &theirs, &b);
            runs += 1;
        }
        Some(made)
    }
}

/// `|b - A x|_i / ( |A| |x| + |b| )_i`, the largest (D-135).
fn error(matrix: &Sparse, x: &[f64], b: &[f64]) -> f64 {
    let mut rows: Vec<_> = b.iter().map(|b| (*b, b.abs())).collect();
    for (row, column, value) in matrix.triplets() {
        let term = value * x[column];
        rows[row].0 -= term;
        rows[row].1 += term.abs();
    }
    let parts = rows.into_iter().filter(|(_, size)| *size > 0.0);
    parts.fold(0.0, |worst, (residual, size)| {
        (residual.abs() / size).max(worst)
    })
}

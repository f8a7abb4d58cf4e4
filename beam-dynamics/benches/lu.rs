//! Factorization of many matrices on one pattern: ours on kept pivots against faer's
//! with dense blocks forced. The matrix is that of a tree of four chains, 12 x 12 blocks
//! with four multipliers each, whose diagonal is zero; all values change by 1 % from
//! call to call. Processor times, as ratios within the run.
//!
//! `cargo bench -p beam-dynamics --bench lu`

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

/// Unknowns of a block, the last of which are multipliers.
const BLOCK: usize = 12;
const MULTIPLIERS: usize = 4;
const CHAINS: usize = 4;

/// Numbers between -1 and 1 without order.
struct Scattered(u64);

impl Scattered {
    fn next(&mut self) -> f64 {
        // The generator of Knuth's MMIX; its upper bits are the scattered ones.
        let (factor, sum) = (6_364_136_223_846_793_005, 1_442_695_040_888_963_407);
        self.0 = self.0.wrapping_mul(factor).wrapping_add(sum);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// The matrix of a root block and four chains on it, of about `size` unknowns: forces
/// of a block hang on all unknowns of its neighbors, constraints on those beside
/// multipliers.
fn tree(size: usize) -> Sparse {
    let blocks = size / BLOCK;
    let parent = |block: usize| block.saturating_sub(CHAINS);
    let is_multiplier = |i: usize| i >= BLOCK - MULTIPLIERS;
    let mut places: Vec<_> = (0..BLOCK * blocks).map(|i| (i, i)).collect();
    for block in 0..blocks {
        for i in 0..BLOCK {
            for j in 0..BLOCK {
                let (here, there) = (BLOCK * block, BLOCK * parent(block));
                if !(is_multiplier(i) && is_multiplier(j)) {
                    places.push((here + i, here + j));
                }
                if block > 0 && !is_multiplier(j) {
                    places.push((here + i, there + j));
                    places.push((there + j, here + i));
                }
            }
        }
    }
    let pattern = Arc::new(Pattern::new(BLOCK * blocks, places));
    let mut matrix = Sparse::zero(Arc::clone(&pattern));
    let mut scattered = Scattered(7);
    for j in 0..pattern.size() {
        for at in pattern.column_starts()[j]..pattern.column_starts()[j + 1] {
            let diagonal = pattern.rows()[at] == j;
            matrix.values_mut()[at] = match diagonal && is_multiplier(j % BLOCK) {
                true => 0.0,
                false => scattered.next() + if diagonal { 8.0 } else { 0.0 },
            };
        }
    }
    matrix
}

fn perturb(matrix: &mut Sparse, original: &Sparse, scattered: &mut Scattered) {
    let values = matrix.values_mut().iter_mut().zip(original.values());
    values.for_each(|(value, original)| *value = original * (1.0 + 0.01 * scattered.next()));
}

/// faer's factorization of a pattern with dense blocks.
struct Peer<'a> {
    view: SymbolicSparseColMatRef<'a, usize>,
    symbolic: SymbolicLu<usize>,
    numeric: NumericLu<usize, f64>,
    memory: MemBuffer,
}

impl<'a> Peer<'a> {
    fn new(pattern: &'a Pattern) -> Option<Self> {
        let (n, starts) = (pattern.size(), pattern.column_starts());
        let view = SymbolicSparseColMatRef::new_checked(n, n, starts, None, pattern.rows());
        let parameters = LuSymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
            ..Default::default()
        };
        let symbolic = factorize_symbolic_lu(view, parameters).ok()?;
        let room = symbolic.factorize_numeric_lu_scratch::<f64>(Par::Seq, Spec::default());
        let room = room.or(symbolic.solve_in_place_scratch::<f64>(1, Par::Seq));
        Some(Self {
            view,
            symbolic,
            numeric: NumericLu::new(),
            memory: MemBuffer::new(room),
        })
    }

    /// Factorizes and solves; times of both are the shortest so far.
    fn run(&mut self, matrix: &Sparse, b: &mut [f64], times: &mut [Duration]) {
        let view = SparseColMatRef::new(self.view, matrix.values());
        let stack = MemStack::new(&mut self.memory);
        let begin = ThreadTime::now();
        let numeric = &mut self.numeric;
        let factors =
            self.symbolic
                .factorize_numeric_lu(numeric, view, Par::Seq, stack, Spec::default());
        times[0] = begin.elapsed().min(times[0]);
        let Ok(factors) = factors else { return };
        let right_side = MatMut::from_column_major_slice_mut(b, self.view.nrows(), 1);
        let begin = ThreadTime::now();
        factors.solve_in_place_with_conj(Conj::No, right_side, Par::Seq, stack);
        times[1] = begin.elapsed().min(times[1]);
    }
}

fn timed<T>(shortest: &mut Duration, work: impl FnOnce() -> T) {
    let begin = ThreadTime::now();
    black_box(work());
    *shortest = begin.elapsed().min(*shortest);
}

fn compare(size: usize) -> Option<()> {
    let original = tree(size);
    let pattern = Arc::clone(original.pattern());
    let mut matrix = original.clone();
    let mut peer = Peer::new(&pattern)?;
    let mut own = StepSolver::new(&pattern)?;
    let mut first = Duration::MAX;
    timed(&mut first, || own.factorize(&matrix));
    let mut scattered = Scattered(11);
    let b: Vec<_> = (0..pattern.size()).map(|_| scattered.next()).collect();
    let mut x = b.clone();
    let mut times = [Duration::MAX; 4];
    let (begin, mut runs, mut apart) = (Instant::now(), 0, 0.0);
    while runs < 10 || begin.elapsed() < Duration::from_secs(4) {
        perturb(&mut matrix, &original, &mut scattered);
        timed(&mut times[0], || own.factorize(&matrix));
        x.copy_from_slice(&b);
        timed(&mut times[1], || own.solve(&mut x));
        let mut theirs = b.clone();
        peer.run(&matrix, &mut theirs, &mut times[2..]);
        let pairs = x.iter().zip(&theirs);
        apart = pairs.fold(0.0, |apart: f64, (x, y)| apart.max((x - y).abs()));
        runs += 1;
    }
    let mut residual = b;
    matrix.multiply_add(&x.iter().map(|x| -x).collect::<Vec<_>>(), &mut residual);
    let worst = residual.iter().fold(0.0_f64, |a, r| a.max(r.abs()));
    let [own_lu, own_solution, peer_lu, peer_solution] = times.map(|time| 1e3 * time.as_secs_f64());
    println!(
        "{size:6} unknowns, {} entries, {} in the factors: pivots {:.1} ms, {:?}",
        pattern.entries(),
        own.stored(),
        1e3 * first.as_secs_f64(),
        own.counts(),
    );
    println!(
        "  factorization {own_lu:.3} ms, faer {peer_lu:.3} ms: ratio {:.2}",
        own_lu / peer_lu
    );
    println!(
        "  solution {own_solution:.3} ms, faer {peer_solution:.3} ms; residual {worst:.1e}, \
         {apart:.1e} apart"
    );
    Some(())
}

fn main() {
    for size in [2004, 20004] {
        if compare(size).is_none() {
            println!("{size} unknowns: a matrix has no factors");
        }
    }
}

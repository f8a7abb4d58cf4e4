//! Factorization of many matrices on one pattern: ours on kept pivots against faer's
//! with dense blocks forced. The matrix describes a tree of four chains, 12 x 12 blocks
//! with four multipliers each, whose diagonal is zero; all values change by 1 % from
//! call to call. Processor times, as ratios within the run.
//!
//! `cargo bench -p beam-dynamics --bench lu`

#[path = "common/factors.rs"]
mod factors;

use std::sync::Arc;
use std::time::Duration;

use beam_dynamics::assembly::{Pattern, Sparse};
use faer::sparse::linalg::SupernodalThreshold;

use factors::{Comparison, Scattered};

/// Unknowns of a block, the last of which are multipliers.
const BLOCK: usize = 12;
const MULTIPLIERS: usize = 4;
const CHAINS: usize = 4;
/// Change of the values from call to call [-].
const CHANGE: f64 = 0.01;

/// The matrix of a root block and four chains on it, of about `size` unknowns: forces
/// of a block depend on all unknowns of its neighbors, constraints on those beside
/// multipliers.
fn tree(size: usize) -> Sparse {
    let blocks = size / BLOCK;
    let parent = |block: usize| block.saturating_sub(CHAINS);
    let is_multiplier = |i: usize| i >= BLOCK - MULTIPLIERS;
    let mut positions: Vec<_> = (0..BLOCK * blocks).map(|i| (i, i)).collect();
    for block in 0..blocks {
        for i in 0..BLOCK {
            for j in 0..BLOCK {
                let (here, there) = (BLOCK * block, BLOCK * parent(block));
                if !(is_multiplier(i) && is_multiplier(j)) {
                    positions.push((here + i, here + j));
                }
                if block > 0 && !is_multiplier(j) {
                    positions.push((here + i, there + j));
                    positions.push((there + j, here + i));
                }
            }
        }
    }
    let pattern = Arc::new(Pattern::new(BLOCK * blocks, positions));
    let mut matrix = Sparse::zero(Arc::clone(&pattern));
    let mut scattered = Scattered(7);
    for j in 0..pattern.size() {
        for at in pattern.column_starts()[j]..pattern.column_starts()[j + 1] {
            let diagonal = pattern.rows()[at] as usize == j;
            matrix.values_mut()[at] = if diagonal && is_multiplier(j % BLOCK) {
                0.0
            } else {
                scattered.next() + if diagonal { 8.0 } else { 0.0 }
            };
        }
    }
    matrix
}

fn compare(size: usize) -> Option<()> {
    let matrix = tree(size);
    let (blocks, span) = (
        SupernodalThreshold::FORCE_SUPERNODAL,
        Duration::from_secs(4),
    );
    let found = Comparison::of(&matrix, CHANGE, blocks, span)?;
    let milliseconds = |time: Duration| 1e3 * time.as_secs_f64();
    let (own, peer) = (&found.own, &found.peer);
    let [lu, peer_lu] = [own, peer].map(|times| milliseconds(times.factorization));
    let [solution, peer_solution] = [own, peer].map(|times| milliseconds(times.solution));
    println!(
        "{size:6} unknowns, {} entries, {} in the factors: pivots {:.1} ms, {:?}",
        matrix.pattern().entries(),
        found.solver.stored(),
        milliseconds(found.choice),
        found.solver.counts(),
    );
    println!(
        "  factorization {lu:.3} ms, faer {peer_lu:.3} ms: ratio {:.2}",
        lu / peer_lu
    );
    println!(
        "  solution {solution:.3} ms, faer {peer_solution:.3} ms: ratio {:.2}; \
         relative residual {:.1e}, faer {:.1e}",
        solution / peer_solution,
        own.error,
        peer.error,
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

//! Branches of large matrices: the same digits on any number of threads, and solutions that
//! satisfy their equations.

use super::*;
use crate::pattern::Sparse;

/// Unknowns of a block.
const BLOCK: usize = 6;

/// Pseudo-random numbers between -1 and 1.
struct Scattered(u64);

impl Scattered {
    fn next(&mut self) -> f64 {
        // The generator of Knuth's MMIX; its upper bits are the most random ones.
        let (factor, sum) = (6_364_136_223_846_793_005, 1_442_695_040_888_963_407);
        self.0 = self.0.wrapping_mul(factor).wrapping_add(sum);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// A pattern of blocks connected to their parents; the first one has no parent.
fn tree(parents: &[usize]) -> Pattern {
    Pattern::of(BLOCK * parents.len(), |add| {
        for (block, &parent) in parents.iter().enumerate() {
            for i in 0..BLOCK * BLOCK {
                let (row, column) = (i / BLOCK, i % BLOCK);
                let (here, there) = (BLOCK * block, BLOCK * parent);
                add(here + row, here + column);
                add(here + row, there + column);
                add(there + row, here + column);
            }
        }
    })
}

/// Pseudo-random values, with a diagonal that is larger than most of its column.
fn values(pattern: &Pattern, scattered: &mut Scattered) -> Vec<f64> {
    let of_column = |j: usize| {
        pattern.rows()[pattern.column(j)]
            .iter()
            .map(move |row| (*row, j))
    };
    let entries = (0..pattern.size()).flat_map(of_column);
    let value = |(row, column): (u32, usize)| {
        if row as usize == column {
            8.0 + scattered.next()
        } else {
            scattered.next()
        }
    };
    entries.map(value).collect()
}

/// Chooses pivots for one matrix and keeps them for another; returns the bits of both
/// solutions, and the number of branches.
fn solutions(pattern: &Arc<Pattern>, of: [&[f64]; 2], b: &[f64]) -> (Vec<u64>, usize) {
    let mut lu = Lu::choose(pattern, of[0]).unwrap();
    let mut buffer = vec![0.0; lu.plan().buffer_len()];
    let mut bits = Vec::new();
    for values in of {
        lu.factorize(values).unwrap();
        let mut x = b.to_vec();
        lu.solve(&mut x, &mut buffer);
        let mut matrix = Sparse::zero(Arc::clone(pattern));
        matrix.values_mut().copy_from_slice(values);
        let mut product = vec![0.0; b.len()];
        matrix.multiply_add(&x, &mut product);
        // Terms of size one, and factors that grow by a factor of some tens.
        let off = product.iter().zip(b).map(|(a, b)| (a - b).abs());
        assert!(off.fold(0.0, f64::max) < 1e-11);
        bits.extend(x.iter().map(|x| x.to_bits()));
    }
    (bits, lu.plan().structure.branches.len())
}

#[test]
fn branches_have_the_same_digits_on_any_number_of_threads() {
    let count = branches::LARGE / BLOCK + 1;
    let mut scattered = Scattered(3);
    // A chain, chains connected to the first block, and a random tree.
    let mut trees: Vec<(Vec<usize>, usize)> = [(1, 2), (2, 2), (3, 3), (4, 4)]
        .map(|(chains, branches)| {
            let parents = (0..count).map(|block: usize| block.saturating_sub(chains));
            (parents.collect(), branches)
        })
        .into();
    let near = |block: usize, number: f64| block.saturating_sub(1 + (20.0 * number.abs()) as usize);
    let wild = (0..count).map(|block| near(block, scattered.next()));
    trees.push((wild.collect(), 0));
    // A chain of three stages.
    let long = (0..3 * count).map(|block: usize| block.saturating_sub(1));
    trees.push((long.collect(), 2));
    for (parents, least) in trees {
        let pattern = Arc::new(tree(&parents));
        let of = [(); 2].map(|()| values(&pattern, &mut scattered));
        let b: Vec<_> = (0..pattern.size()).map(|_| scattered.next()).collect();
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
            let pool = pool.build().unwrap();
            pool.install(|| solutions(&pattern, [&of[0], &of[1]], &b))
        };
        let (expected, branches) = on(1);
        assert!(branches >= least, "{branches} branches, not {least}");
        for threads in 2..5 {
            assert!(on(threads).0 == expected, "{threads} threads");
        }
    }
}

#[test]
fn a_singular_branch_is_reported_and_leaves_nothing_behind() {
    let count = branches::LARGE / BLOCK + 1;
    let parents: Vec<_> = (0..count)
        .map(|block: usize| block.saturating_sub(2))
        .collect();
    let pattern = Arc::new(tree(&parents));
    let sound = values(&pattern, &mut Scattered(5));
    let mut singular = sound.clone();
    singular[pattern.column(BLOCK * (count - 3))].fill(0.0);
    let mut lu = Lu::choose(&pattern, &sound).unwrap();
    let solution = |lu: &Lu<f64>| {
        let mut x = vec![1.0; pattern.size()];
        lu.solve(&mut x, &mut vec![0.0; lu.plan().buffer_len()]);
        x
    };
    let expected = solution(&lu);
    assert!(lu.factorize(&singular).is_none());
    lu.factorize(&sound).unwrap();
    assert!(solution(&lu) == expected);
}

//! Which nodes meet in a cell, and where the entries of two nodes lie in the
//! lower triangle of a symmetric matrix in compressed columns.
//!
//! Column 3 j + b belongs to component b of node j; its rows are 3 i + a for the
//! neighbors i > j in rising order, after the rest of the block of j itself:
//!
//! ```text
//! column 3 j       a=0 a=1 a=2 | i1: 0 1 2 | i2: 0 1 2 ...
//! column 3 j + 1       a=1 a=2 | i1: 0 1 2 | i2: 0 1 2 ...
//! column 3 j + 2           a=2 | i1: 0 1 2 | i2: 0 1 2 ...
//! ```
//!
//! So the entries of a block need one search among the neighbors of j.

use super::domain::Domain;

/// Node adjacency of a domain, and the structure of its matrix E.
#[derive(Debug, Clone)]
pub struct Pattern {
    /// Neighbors of node j: `neighbors[starts[j]..starts[j + 1]]`.
    starts: Vec<u32>,
    neighbors: Vec<u32>,
    /// For each node the place of itself among its neighbors.
    own: Vec<usize>,
    /// First entry of column 3 j.
    columns: Vec<usize>,
}

impl Pattern {
    /// The adjacency of `domain`.
    pub fn new(domain: &Domain) -> Self {
        let (cell_starts, cells) = cells_of_nodes(domain);
        let count = domain.nodes.len();
        let mut starts = Vec::with_capacity(count + 1);
        let mut neighbors = Vec::with_capacity(16 * count);
        // last node that has taken each node for a neighbor
        let mut taken_by = vec![u32::MAX; count];
        starts.push(0);
        for node in 0..count {
            let first = neighbors.len();
            for &cell in &cells[cell_starts[node]..cell_starts[node + 1]] {
                for &other in domain.cells[cell as usize].nodes() {
                    if taken_by[other as usize] != node as u32 {
                        taken_by[other as usize] = node as u32;
                        neighbors.push(other);
                    }
                }
            }
            neighbors[first..].sort_unstable();
            starts.push(neighbors.len() as u32);
        }
        Self::from_adjacency(starts, neighbors)
    }

    /// The adjacency of `count` nodes that meet as `pairs` say; each pair in either
    /// order, any number of times, and each node with itself.
    pub fn of_pairs(count: usize, pairs: impl Iterator<Item = (u32, u32)>) -> Self {
        let mut lists: Vec<Vec<u32>> = (0..count as u32).map(|node| vec![node]).collect();
        for (a, b) in pairs {
            lists[a as usize].push(b);
            lists[b as usize].push(a);
        }
        let (mut starts, mut neighbors) = (vec![0], Vec::new());
        for mut list in lists {
            list.sort_unstable();
            list.dedup();
            neighbors.extend(list);
            starts.push(neighbors.len() as u32);
        }
        Self::from_adjacency(starts, neighbors)
    }

    /// Where the entry of unknowns `row >= column` stands; their nodes meet.
    pub fn entry(&self, row: usize, column: usize) -> usize {
        let (node, other) = ((row / 3) as u32, (column / 3) as u32);
        let (a, b) = (row % 3, column % 3);
        let skipped = if node == other { b } else { 0 };
        self.block(node, other)[b] + a - skipped
    }

    fn from_adjacency(starts: Vec<u32>, neighbors: Vec<u32>) -> Self {
        let count = starts.len() - 1;
        let mut own = Vec::with_capacity(count);
        let mut columns = Vec::with_capacity(count + 1);
        let mut next = 0;
        for node in 0..count {
            let list = &neighbors[starts[node] as usize..starts[node + 1] as usize];
            let before = list.partition_point(|&other| (other as usize) < node);
            own.push(before);
            columns.push(next);
            // 3 + 2 + 1 entries of the own block, nine of each block below
            next += 6 + 9 * (list.len() - before - 1);
        }
        columns.push(next);
        Self {
            starts,
            neighbors,
            own,
            columns,
        }
    }

    /// Number of nodes.
    pub fn node_count(&self) -> usize {
        self.starts.len() - 1
    }

    /// Neighbors of `node` in rising order, itself included.
    pub fn neighbors(&self, node: usize) -> &[u32] {
        &self.neighbors[self.starts[node] as usize..self.starts[node + 1] as usize]
    }

    /// First neighbor of each node in the list of all, and that list.
    pub fn adjacency(&self) -> (&[u32], &[u32]) {
        (&self.starts, &self.neighbors)
    }

    /// Number of entries of the lower triangle.
    pub fn entry_count(&self) -> usize {
        self.columns[self.node_count()]
    }

    /// Where the entries of row node `row` start in each column of node `column`:
    /// three in a row, of which those above the diagonal are left out when the nodes
    /// are the same. The nodes share a cell, and `row >= column`.
    pub fn block(&self, row: u32, column: u32) -> [usize; 3] {
        let node = column as usize;
        let below = &self.neighbors(node)[self.own[node]..];
        // the own block takes 3, 2 and 1 entries of the columns
        let others = 3 * (below.len() - 1);
        let first = self.columns[node];
        let own = [first, first + 3 + others, first + 5 + 2 * others];
        if row == column {
            return own;
        }
        let place = 3 * below.partition_point(|&other| other < row);
        [own[0] + place, own[1] + place - 1, own[2] + place - 2]
    }

    /// Column starts and row indices of the lower triangle, by unknown; `None` when
    /// 32 bits do not count them.
    pub fn structure(&self) -> Option<(Vec<u32>, Vec<u32>)> {
        // faer takes signed indices of this width
        if i32::try_from(self.entry_count()).is_err() {
            return None;
        }
        let mut starts = Vec::with_capacity(3 * self.node_count() + 1);
        let mut rows = Vec::with_capacity(self.entry_count());
        starts.push(0);
        for node in 0..self.node_count() {
            for b in 0..3 {
                let own = 3 * node as u32;
                rows.extend(own + b..own + 3);
                for &other in &self.neighbors(node)[self.own[node] + 1..] {
                    rows.extend([3 * other, 3 * other + 1, 3 * other + 2]);
                }
                starts.push(rows.len() as u32);
            }
        }
        Some((starts, rows))
    }

    /// Column starts and row indices of the upper triangle, by unknown; `None` when
    /// 32 bits do not count them.
    pub fn upper_structure(&self) -> Option<(Vec<u32>, Vec<u32>)> {
        i32::try_from(self.entry_count()).ok()?;
        let mut starts = Vec::with_capacity(3 * self.node_count() + 1);
        let mut rows = Vec::with_capacity(self.entry_count());
        starts.push(0);
        for node in 0..self.node_count() {
            for b in 0..3 {
                for &other in &self.neighbors(node)[..self.own[node]] {
                    rows.extend([3 * other, 3 * other + 1, 3 * other + 2]);
                }
                let own = 3 * node as u32;
                rows.extend(own..=own + b);
                starts.push(rows.len() as u32);
            }
        }
        Some((starts, rows))
    }

    /// First node of each part that shares no node with the others.
    pub fn parts(&self) -> Vec<usize> {
        let mut seen = vec![false; self.node_count()];
        let mut parts = Vec::new();
        let mut open = Vec::new();
        for node in 0..self.node_count() {
            if seen[node] {
                continue;
            }
            parts.push(node);
            seen[node] = true;
            open.push(node);
            while let Some(node) = open.pop() {
                for &other in self.neighbors(node) {
                    if !seen[other as usize] {
                        seen[other as usize] = true;
                        open.push(other as usize);
                    }
                }
            }
        }
        parts
    }
}

/// Cells of each node, as starts and list.
fn cells_of_nodes(domain: &Domain) -> (Vec<usize>, Vec<u32>) {
    let mut starts = vec![0; domain.nodes.len() + 1];
    for cell in &domain.cells {
        for &node in cell.nodes() {
            starts[node as usize + 1] += 1;
        }
    }
    for node in 1..starts.len() {
        starts[node] += starts[node - 1];
    }
    let mut next = starts.clone();
    let mut cells = vec![0; starts[starts.len() - 1]];
    for (index, cell) in domain.cells.iter().enumerate() {
        for &node in cell.nodes() {
            cells[next[node as usize]] = index as u32;
            next[node as usize] += 1;
        }
    }
    (starts, cells)
}

//! Pairs of nodes that share a cell, and the positions of their entries in the lower
//! triangle of a symmetric matrix in compressed columns.
//!
//! A node has three unknowns, or four with a potential; the unknowns of a node are adjacent
//! in the matrix. The columns of node j have the rows of the neighbors i > j in ascending
//! order, after the rest of the block of j itself:
//!
//! ```text
//! column of ux of j       a=0 a=1 a=2 | i1: 0 1 2 | i2: 0 1 2 3 ...
//! column of uy of j           a=1 a=2 | i1: 0 1 2 | i2: 0 1 2 3 ...
//! column of uz of j               a=2 | i1: 0 1 2 | i2: 0 1 2 3 ...
//! ```
//!
//! The entries of a block therefore need one search among the neighbors of j.

use super::domain::Domain;

/// Node adjacency of a domain, and the structure of its matrix E.
#[derive(Debug, Clone)]
pub struct Pattern {
    /// Neighbors of node j: `neighbors[starts[j]..starts[j + 1]]`.
    starts: Vec<u32>,
    neighbors: Vec<u32>,
    /// For each node its own index among its neighbors.
    own: Vec<usize>,
    /// First entry of the first column of each node.
    columns: Vec<usize>,
    /// Nodes with a potential; `None` without any.
    potentials: Option<Potentials>,
}

/// Nodes with a potential in a [`Pattern`].
#[derive(Debug, Clone)]
struct Potentials {
    /// First row of each node, and the number of rows.
    first: Vec<u32>,
    /// For each neighbor of each node, number of rows of the neighbors before it, from the
    /// node on.
    indices: Vec<u32>,
    /// For each row its index among the unknowns of the model.
    order: Vec<u32>,
}

impl Pattern {
    /// The adjacency of `domain`.
    pub fn new(domain: &Domain) -> Self {
        let (cell_starts, cells) = cells_of_nodes(domain);
        let count = domain.nodes.len();
        let mut starts = Vec::with_capacity(count + 1);
        let mut neighbors = Vec::with_capacity(16 * count);
        // last node that has each node as a neighbor
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
        let mut pattern = Self::from_adjacency(starts, neighbors);
        if domain.electric.potentials() > 0 {
            pattern.add_potentials(domain);
        }
        pattern
    }

    /// Adds a fourth unknown to the nodes of dielectrics.
    fn add_potentials(&mut self, domain: &Domain) {
        let count = self.node_count();
        let potential = |node: usize| domain.electric.potential(node);
        let size = |node: usize| 3 + u32::from(potential(node).is_some());
        let mut first = vec![0];
        let mut order = Vec::with_capacity(domain.unknowns());
        for node in 0..count {
            first.push(first[node] + size(node));
            order.extend((0..3).map(|axis| (3 * node + axis) as u32));
            order.extend(potential(node).map(|number| (3 * count + number) as u32));
        }
        let mut indices = vec![0; self.neighbors.len()];
        let mut next = 0;
        for node in 0..count {
            let start = self.starts[node] as usize;
            let mut rows = 0;
            for at in start + self.own[node]..self.starts[node + 1] as usize {
                indices[at] = rows;
                rows += size(self.neighbors[at] as usize);
            }
            self.columns[node] = next;
            let own = size(node) as usize;
            // own columns of all rows, less the triangle above the diagonal
            next += own * rows as usize - own * (own - 1) / 2;
        }
        self.columns[count] = next;
        self.potentials = Some(Potentials {
            first,
            indices,
            order,
        });
    }

    /// Number of rows: of unknowns.
    pub fn rows(&self) -> usize {
        match &self.potentials {
            None => 3 * self.node_count(),
            Some(potentials) => potentials.order.len(),
        }
    }

    /// For each row its index among the unknowns of the model; `None` if they are the same.
    pub fn order(&self) -> Option<&[u32]> {
        self.potentials
            .as_ref()
            .map(|potentials| &potentials.order[..])
    }

    /// The node and the component of a row.
    pub fn node_of(&self, row: usize) -> (usize, usize) {
        match &self.potentials {
            None => (row / 3, row % 3),
            Some(Potentials { first, .. }) => {
                let node = first.partition_point(|&first| first as usize <= row) - 1;
                (node, row - first[node] as usize)
            }
        }
    }

    /// First row of a node.
    fn first(&self, node: usize) -> u32 {
        match &self.potentials {
            None => 3 * node as u32,
            Some(Potentials { first, .. }) => first[node],
        }
    }

    /// Number of unknowns of a node.
    pub fn size(&self, node: usize) -> usize {
        (self.first(node + 1) - self.first(node)) as usize
    }

    /// The adjacency of `count` nodes from `pairs` of neighbors; each pair in either order,
    /// any number of times. Each node is its own neighbor.
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

    /// Index of the entry of the unknowns `row >= column`, whose nodes are neighbors.
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
            potentials: None,
        }
    }

    /// Number of nodes.
    pub fn node_count(&self) -> usize {
        self.starts.len() - 1
    }

    /// Neighbors of `node` in ascending order, itself included.
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

    /// Index of the first entry of row node `row` in each column of node `column`: the rows
    /// of the node are consecutive, without the rows above the diagonal when the nodes are
    /// the same. The nodes share a cell, and `row >= column`; the last column belongs to a
    /// potential.
    pub fn block(&self, row: u32, column: u32) -> [usize; 4] {
        let node = column as usize;
        let below = &self.neighbors(node)[self.own[node]..];
        let index = below.partition_point(|&other| other < row);
        let (size, rows, index) = match &self.potentials {
            None => (3, 3 * below.len(), 3 * index),
            Some(Potentials { indices, .. }) => {
                let start = self.starts[node] as usize + self.own[node];
                let last = below.len() - 1;
                let rows = indices[start + last] as usize + self.size(below[last] as usize);
                (self.size(node), rows, indices[start + index] as usize)
            }
        };
        let first = self.columns[node];
        let mut at = [
            first,
            first + rows,
            first + 2 * rows - 1,
            first + 3 * rows - 3,
        ];
        if row != column {
            // the rows of the own block above the diagonal are left out
            for (b, at) in at.iter_mut().enumerate().take(size) {
                *at += index - b;
            }
        }
        at
    }

    /// Column starts and row indices of the lower triangle, by row; `None` when 32 bits
    /// cannot count them.
    pub fn structure(&self) -> Option<(Vec<u32>, Vec<u32>)> {
        // faer takes signed indices of this width
        i32::try_from(self.entry_count()).ok()?;
        let mut starts = Vec::with_capacity(self.rows() + 1);
        let mut rows = Vec::with_capacity(self.entry_count());
        starts.push(0);
        for node in 0..self.node_count() {
            let (own, end) = (self.first(node), self.first(node + 1));
            for row in own..end {
                rows.extend(row..end);
                for &other in &self.neighbors(node)[self.own[node] + 1..] {
                    rows.extend(self.first(other as usize)..self.first(other as usize + 1));
                }
                starts.push(rows.len() as u32);
            }
        }
        Some((starts, rows))
    }

    /// Column starts and row indices of the upper triangle, by row; `None` when 32 bits
    /// cannot count them.
    pub fn upper_structure(&self) -> Option<(Vec<u32>, Vec<u32>)> {
        i32::try_from(self.entry_count()).ok()?;
        let mut starts = Vec::with_capacity(self.rows() + 1);
        let mut rows = Vec::with_capacity(self.entry_count());
        starts.push(0);
        for node in 0..self.node_count() {
            let (own, end) = (self.first(node), self.first(node + 1));
            for row in own..end {
                for &other in &self.neighbors(node)[..self.own[node]] {
                    rows.extend(self.first(other as usize)..self.first(other as usize + 1));
                }
                rows.extend(own..=row);
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

/// Cells of each node: starts, and list of cells.
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

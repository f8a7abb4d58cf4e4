//! Parts of a section made of some of its cells, and disjoint sets.

use std::collections::HashMap;

use super::section_mesh::SectionMesh;

/// Disjoint sets of numbers, initially of one member each.
#[derive(Debug)]
pub(crate) struct Sets(Vec<u32>);

impl Sets {
    pub fn new(count: usize) -> Self {
        Self((0..count as u32).collect())
    }

    /// The representative of the set of `member`.
    pub fn of(&mut self, member: u32) -> u32 {
        let mut member = member as usize;
        while self.0[member] as usize != member {
            self.0[member] = self.0[self.0[member] as usize];
            member = self.0[member] as usize;
        }
        member as u32
    }

    /// Merges the sets of two members; the smallest number represents the result.
    pub fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.of(a), self.of(b));
        self.0[a.max(b) as usize] = a.min(b);
    }

    /// Merges the sets of all these members.
    pub fn join_all(&mut self, members: &[u32]) {
        if let [first, rest @ ..] = members {
            rest.iter().for_each(|member| self.join(*first, *member));
        }
    }
}

impl SectionMesh {
    /// The parts formed by the cells for which `is_in` holds, connected through whole
    /// sides, the largest first: indices of cells.
    pub(crate) fn parts(&self, is_in: impl Fn(usize) -> bool) -> Vec<Vec<usize>> {
        let mut sets = Sets::new(self.cells.len());
        let mut cell_of_side: HashMap<[u32; 2], u32> = HashMap::new();
        let cells = || (0..self.cells.len()).filter(|cell| is_in(*cell));
        for index in cells() {
            let cell = &self.cells[index];
            for ([a, b], _) in cell.kind.sides(cell.nodes()) {
                let first = *cell_of_side
                    .entry([a.min(b), a.max(b)])
                    .or_insert(index as u32);
                sets.join(first, index as u32);
            }
        }
        let mut parts: HashMap<u32, Vec<usize>> = HashMap::new();
        for cell in cells() {
            parts.entry(sets.of(cell as u32)).or_default().push(cell);
        }
        let mut parts: Vec<_> = parts.into_values().collect();
        parts.sort_by_key(|part| (std::cmp::Reverse(part.len()), part[0]));
        parts
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::generate::Rectangle;
    use shared_geom::error::SourceLocation;
    use shared_geom::mesh::CellKind;

    /// A row of five cells without the second is in parts of one and three; two cells
    /// that share only a corner are two parts.
    #[test]
    fn cells_left_out_part_the_rest() {
        let mesh = |cells_z| {
            let bar = Rectangle {
                width: 5.0,
                height: cells_z as f64,
                cells_y: 5,
                cells_z,
                kind: CellKind::Quadrilateral8,
                name: "bar".into(),
            };
            let mesh = bar.generate().expect("sound measures");
            SectionMesh::from_mesh(&mesh, 1.0, &SourceLocation::file("bar"))
                .expect("sound")
                .0
        };
        let row = mesh(1);
        assert_eq!(row.parts(|cell| cell != 1), [vec![2, 3, 4], vec![0]]);
        assert_eq!(row.parts(|_| true).len(), 1);
        assert!(row.parts(|_| false).is_empty());
        let block = mesh(2);
        let diagonal = [block.cells[0], block.cells[6]].map(|cell| cell.tag);
        let parts = block.parts(|cell| diagonal.contains(&block.cells[cell].tag));
        assert_eq!(parts.len(), 2);
    }
}

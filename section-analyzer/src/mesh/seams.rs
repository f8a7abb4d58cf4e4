//! Seams: coincident sides of cells without shared nodes.

use super::boundary::Boundary;
use super::components::root;
use super::findings::Seam;
use super::plane::PlaneMesh;

/// The physical surface of each cell, for messages.
#[derive(Debug, Clone, Copy)]
pub(super) struct Groups<'a> {
    pub(super) labels: &'a [String],
    pub(super) of_cell: &'a [usize],
}

impl Groups<'_> {
    pub(super) fn label(&self, cell: usize) -> String {
        self.labels[self.of_cell[cell]].clone()
    }

    pub(super) fn labels_of(&self, cells: [usize; 2]) -> [String; 2] {
        cells.map(|cell| self.label(cell))
    }
}

/// Two sides (indices in the boundary) in opposite directions.
pub(super) type SidePair = [usize; 2];

/// For each node the smallest index of the nodes at its position.
pub(super) fn representatives(nodes: usize, coincident: &[[u32; 2]]) -> Vec<u32> {
    let mut parent: Vec<usize> = (0..nodes).collect();
    for pair in coincident {
        let [a, b] = pair.map(|node| root(&mut parent, node as usize));
        parent[a.max(b)] = a.min(b);
    }
    (0..nodes)
        .map(|node| root(&mut parent, node) as u32)
        .collect()
}

/// The pairs of sides with coincident ends and opposite directions, so that their cells
/// lie on either side.
pub(super) fn doubled_sides(boundary: &Boundary, least: &[u32]) -> Vec<SidePair> {
    let key = |side: usize| {
        let [a, b] = boundary.sides[side].ends.map(|node| least[node as usize]);
        (a.min(b), a.max(b), a < b)
    };
    let sides = 0..boundary.sides.len();
    let mut sides: Vec<_> = sides.map(|side| (key(side), side)).collect();
    sides.sort_unstable();
    let pairs = sides.windows(2).filter(|pair| {
        let [(a, _), (b, _)] = [pair[0], pair[1]];
        (a.0, a.1) == (b.0, b.1) && a.2 != b.2
    });
    pairs.map(|pair| [pair[0].1, pair[1].1]).collect()
}

/// The seams of these pairs of sides, one for each two physical surfaces. `parts` returns
/// for two cells the number of parts of the section if they are in different ones.
pub(super) fn seams(
    mesh: &PlaneMesh,
    boundary: &Boundary,
    pairs: &[SidePair],
    groups: Groups<'_>,
    parts: impl Fn([usize; 2]) -> Option<usize>,
) -> Vec<Seam> {
    let mut seams: Vec<([usize; 2], Seam, Vec<[u32; 2]>)> = Vec::new();
    for &pair in pairs {
        let [one, other] = pair.map(|side| boundary.sides[side]);
        let cells = [one.cell, other.cell];
        let mut key = cells.map(|cell| groups.of_cell[cell]);
        key.sort_unstable();
        let index = seams.iter().position(|(known, ..)| *known == key);
        let index = index.unwrap_or_else(|| {
            let empty = Seam {
                groups: key.map(|group| groups.labels[group].clone()),
                sides: 0,
                pairs: Vec::new(),
                positions: Vec::new(),
                parts: None,
            };
            seams.push((key, empty, Vec::new()));
            seams.len() - 1
        });
        let (_, seam, nodes) = &mut seams[index];
        seam.sides += 1;
        seam.parts = seam.parts.or(parts(cells));
        // the sides have opposite directions
        let [a, b] = one.ends;
        let [c, d] = other.ends;
        let middles = one.middle.zip(other.middle).map(|(m, n)| [m, n]);
        let met = [[a, d], [b, c]].into_iter().chain(middles);
        nodes.extend(
            met.filter(|[a, b]| a != b)
                .map(|[a, b]| [a.min(b), a.max(b)]),
        );
    }
    let finished = seams.into_iter();
    finished
        .map(|(_, seam, nodes)| with_nodes(mesh, seam, nodes))
        .collect()
}

/// The seam with its pairs of nodes, each once.
fn with_nodes(mesh: &PlaneMesh, seam: Seam, mut nodes: Vec<[u32; 2]>) -> Seam {
    nodes.sort_unstable();
    nodes.dedup();
    let tags = |pair: &[u32; 2]| pair.map(|node| mesh.node_tags[node as usize]);
    let position = |pair: &[u32; 2]| mesh.nodes[pair[0] as usize];
    Seam {
        pairs: nodes.iter().map(tags).collect(),
        positions: nodes.iter().map(position).collect(),
        ..seam
    }
}

//! Closed loops of joints with redundant constraints.
//!
//! Constraints follow from others only if joints close loops: multipliers with `Phi_y^T lambda = 0`
//! are loads that balance each other at every node, and a joint that is the only connection of two
//! parts carries none of them. Two joints are in one [`Loop`] if a ring of joints, possibly through
//! the frame, contains both.

use std::collections::BTreeMap;

use super::System;
use crate::elements::Queries;

/// Joints of connected closed loops, some constraints of which follow from others.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Loop {
    /// Indices of the elements.
    pub elements: Vec<usize>,
    /// Constraints that follow from others, by the indices of their multipliers.
    pub redundant: Vec<usize>,
}

/// A joint between two vertices: nodes, or the frame.
struct Edge {
    ends: [usize; 2],
    element: usize,
}

/// Sets that are joined.
struct Sets(Vec<usize>);

impl Sets {
    fn of(&mut self, mut i: usize) -> usize {
        while self.0[i] != i {
            self.0[i] = self.0[self.0[i]];
            i = self.0[i];
        }
        i
    }

    fn join(&mut self, i: usize, j: usize) {
        let (i, j) = (self.of(i), self.of(j));
        self.0[i.max(j)] = i.min(j);
    }
}

/// The loops of a system, from groups of constraints of which the first follows from the others.
pub(super) fn find(system: &System, redundant: &[Vec<usize>]) -> Vec<Loop> {
    let edges = edges(system);
    let mut sets = Sets((0..system.elements.len()).collect());
    join_rings(&edges, system.nodes.len() + 1, &mut sets);
    let owners = system.elements.iter().enumerate();
    let owners = owners.flat_map(|(index, element)| (0..element.multipliers()).map(move |_| index));
    let owners: Vec<_> = owners.collect();
    for group in redundant {
        let elements = group.iter().map(|constraint| owners[*constraint]);
        for pair in elements.collect::<Vec<_>>().windows(2) {
            sets.join(pair[0], pair[1]);
        }
    }
    let mut loops: BTreeMap<usize, Loop> = BTreeMap::new();
    for constraint in redundant.iter().filter_map(|group| group.first()) {
        let of = loops.entry(sets.of(owners[*constraint]));
        let of = of.or_insert_with(|| Loop {
            elements: Vec::new(),
            redundant: Vec::new(),
        });
        of.redundant.push(*constraint);
    }
    for (index, element) in system.elements.iter().enumerate() {
        if element.multipliers() > 0
            && let Some(of) = loops.get_mut(&sets.of(index))
        {
            of.elements.push(index);
        }
    }
    loops.into_values().collect()
}

/// Elements with constraints; the frame is the vertex after the nodes.
fn edges(system: &System) -> Vec<Edge> {
    let frame = system.nodes.len();
    let with = system.elements.iter().enumerate();
    let with = with.filter(|(_, element)| element.multipliers() > 0);
    with.flat_map(|(element, of)| {
        let ends: Vec<_> = match of.nodes() {
            [node] => vec![[frame, *node]],
            nodes => nodes.windows(2).map(|pair| [pair[0], pair[1]]).collect(),
        };
        ends.into_iter().map(move |ends| Edge { ends, element })
    })
    .collect()
}

/// Joins the elements of every ring that an edge closes in a tree of the others. These rings
/// generate all rings.
fn join_rings(edges: &[Edge], vertices: usize, sets: &mut Sets) {
    let mut beside = vec![Vec::new(); vertices];
    for (number, edge) in edges.iter().enumerate() {
        edge.ends.iter().for_each(|end| beside[*end].push(number));
    }
    // The edge towards the root of the tree, and the distance from it.
    let mut up: Vec<Option<(usize, usize)>> = vec![None; vertices];
    let mut depth = vec![usize::MAX; vertices];
    // From the frame, and from parts not connected to it.
    for root in (0..vertices).rev() {
        if depth[root] != usize::MAX {
            continue;
        }
        depth[root] = 0;
        let mut queue = std::collections::VecDeque::from([root]);
        while let Some(vertex) = queue.pop_front() {
            for &number in &beside[vertex] {
                let [a, b] = edges[number].ends;
                let other = if a == vertex { b } else { a };
                if depth[other] == usize::MAX {
                    depth[other] = depth[vertex] + 1;
                    up[other] = Some((number, vertex));
                    queue.push_back(other);
                }
            }
        }
    }
    for (number, edge) in edges.iter().enumerate() {
        let [mut a, mut b] = edge.ends;
        while a != b {
            let lower = if depth[a] >= depth[b] { &mut a } else { &mut b };
            let Some((through, parent)) = up[*lower] else {
                break;
            };
            if through != number {
                sets.join(edge.element, edges[through].element);
            }
            *lower = parent;
        }
    }
}

//! Ends of rods and springs: two nodes, or one node and a point of the frame.

use nalgebra::Vector3;
use shared_geom::document::Table;
use shared_geom::error::Explain;
use shared_geom::units::Dimension;

use super::builder::ModelBuilder;
use super::laws::LawProblem;
use super::problem::InputProblem;
use crate::elements::springs::End;

/// The name of card `number` of a kind.
pub(super) fn label(table: &Table<'_>, kind: &str, number: usize) -> String {
    let own = table.text("name");
    own.unwrap_or_else(|| format!("{kind} {}", number + 1))
}

/// The nodes under `nodes` of a card described by `words`: two of them, or one if the frame
/// may be the other end.
pub(super) fn nodes(
    table: &Table<'_>,
    builder: &mut ModelBuilder,
    words: &str,
    may_be_frame: bool,
) -> Option<Vec<usize>> {
    if !may_be_frame {
        return Some(pair(table, builder, words)?.to_vec());
    }
    one_or_two(table, builder, words, |found| LawProblem::Ends { found })
}

/// The two nodes under `nodes` of a card described by `words`.
pub(super) fn pair(
    table: &Table<'_>,
    builder: &mut ModelBuilder,
    words: &str,
) -> Option<[usize; 2]> {
    let found = listed(table, builder, words)?;
    let [first, second] = found[..] else {
        table.note("nodes", &count(found.len(), "two"));
        builder.note_loose_end();
        return None;
    };
    let nodes = [first?, second?];
    are_two(table, builder, words, &nodes).then_some(nodes)
}

/// One node or two under `nodes` of a card described by `words`; `wrong` is the problem
/// noted for another number.
pub(super) fn one_or_two<P: Explain>(
    table: &Table<'_>,
    builder: &mut ModelBuilder,
    words: &str,
    wrong: impl Fn(usize) -> P,
) -> Option<Vec<usize>> {
    let found = listed(table, builder, words)?;
    if !(1..=2).contains(&found.len()) {
        table.note("nodes", &wrong(found.len()));
        builder.note_loose_end();
        return None;
    }
    let nodes: Option<Vec<_>> = found.into_iter().collect();
    nodes.filter(|nodes| are_two(table, builder, words, nodes))
}

/// A number of nodes that differs from the expected one.
pub(super) fn count(found: usize, expected: &'static str) -> InputProblem {
    InputProblem::Count {
        key: "nodes",
        found,
        expected,
    }
}

/// The nodes listed under `nodes`; `None` for each unknown node.
fn listed(
    table: &Table<'_>,
    builder: &mut ModelBuilder,
    words: &str,
) -> Option<Vec<Option<usize>>> {
    if !table.has("nodes") {
        let _ = table.require_text("nodes", "the names of two nodes");
    }
    let Some(names) = table.texts("nodes") else {
        builder.note_loose_end();
        return None;
    };
    let find = |name: &String| builder.find_node(name, table, "nodes", words);
    Some(names.iter().map(find).collect())
}

/// Whether the nodes are different; notes equal nodes.
fn are_two(table: &Table<'_>, builder: &ModelBuilder, words: &str, nodes: &[usize]) -> bool {
    if nodes.len() < 2 || nodes[0] != nodes[1] {
        return true;
    }
    let node = builder.nodes()[nodes[0]].label.clone();
    let joint = words.to_owned();
    table.note("nodes", &InputProblem::JoinedToItself { joint, node });
    false
}

/// Points on two nodes at `offsets` from them, in their axes.
pub(super) fn points(table: &Table<'_>, nodes: [usize; 2]) -> Option<[End; 2]> {
    let [first, second] = offsets::<2>(table)?;
    let ends = [(nodes[0], first), (nodes[1], second)];
    Some(ends.map(|(node, offset)| End::Node { node, offset }))
}

/// A point of the frame, `at`, and one on a node.
pub(super) fn frame_and_point(table: &Table<'_>, node: usize, words: &str) -> Option<[End; 2]> {
    let offsets = offsets::<1>(table);
    if !table.has("at") {
        let rod = words.to_owned();
        table.note("nodes", &LawProblem::NoAnchor { rod });
        return None;
    }
    let position = table.vector("at", Dimension::LENGTH)?;
    let [offset] = offsets?;
    Some([End::Frame { position }, End::Node { node, offset }])
}

/// One vector per node; zeros if absent.
fn offsets<const N: usize>(table: &Table<'_>) -> Option<[Vector3<f64>; N]> {
    if !table.has("offsets") {
        return Some([Vector3::zeros(); N]);
    }
    let found = table.vectors("offsets", Dimension::LENGTH)?;
    let expected = format!("one offset for each of the nodes, {N}");
    let found = <[Vector3<f64>; N]>::try_from(found);
    found.map_err(|_| table.wrong("offsets", &expected)).ok()
}

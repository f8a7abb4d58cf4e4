//! Ends of rods and springs: two nodes, or one node and a point of the frame.

use nalgebra::Vector3;
use shared_geom::document::{Key, Table};
use shared_geom::error::Explain;

use super::builder::ModelBuilder;
use super::laws::LawProblem;
use super::problem::InputProblem;
use crate::elements::springs::End;

/// A card, and its key that lists the names of nodes.
pub(super) type Listed<'a> = (&'a Table<'a>, &'a Key<Vec<String>>);

/// The name of card `number` of a kind.
pub(super) fn label(
    table: &Table<'_>,
    key: &Key<Option<String>>,
    kind: &str,
    number: usize,
) -> String {
    let own = table.get(key).flatten();
    own.unwrap_or_else(|| format!("{kind} {}", number + 1))
}

/// The nodes under a key of a card described by `words`: two of them, or one if the frame
/// may be the other end.
pub(super) fn nodes(
    (table, key): Listed<'_>,
    builder: &mut ModelBuilder,
    words: &str,
    may_be_frame: bool,
) -> Option<Vec<usize>> {
    if !may_be_frame {
        return Some(pair((table, key), builder, words)?.to_vec());
    }
    one_or_two((table, key), builder, words, |found| LawProblem::Ends {
        found,
    })
}

/// The two nodes under a key of a card described by `words`.
pub(super) fn pair(
    (table, key): Listed<'_>,
    builder: &mut ModelBuilder,
    words: &str,
) -> Option<[usize; 2]> {
    let found = listed((table, key), builder, words)?;
    let [first, second] = found[..] else {
        table.note(key, &count(key.name(), found.len(), "two"));
        builder.note_loose_end();
        return None;
    };
    let nodes = [first?, second?];
    are_two((table, key), builder, words, &nodes).then_some(nodes)
}

/// One node or two under a key of a card described by `words`; `wrong` is the problem
/// noted for another number.
pub(super) fn one_or_two<P: Explain>(
    (table, key): Listed<'_>,
    builder: &mut ModelBuilder,
    words: &str,
    wrong: impl Fn(usize) -> P,
) -> Option<Vec<usize>> {
    let found = listed((table, key), builder, words)?;
    if !(1..=2).contains(&found.len()) {
        table.note(key, &wrong(found.len()));
        builder.note_loose_end();
        return None;
    }
    let nodes: Option<Vec<_>> = found.into_iter().collect();
    nodes.filter(|nodes| are_two((table, key), builder, words, nodes))
}

/// A length of a list that differs from the expected one.
pub(super) fn count(key: &'static str, found: usize, expected: &'static str) -> InputProblem {
    InputProblem::Count {
        key,
        found,
        expected,
    }
}

/// The nodes listed under a key; `None` for each unknown node.
fn listed(
    (table, key): Listed<'_>,
    builder: &mut ModelBuilder,
    words: &str,
) -> Option<Vec<Option<usize>>> {
    let Some(names) = table.get(key) else {
        builder.note_loose_end();
        return None;
    };
    let find = |name: &String| builder.find_node(name, table, key.name(), words);
    Some(names.iter().map(find).collect())
}

/// Whether the nodes are different; notes equal nodes.
fn are_two((table, key): Listed<'_>, builder: &ModelBuilder, words: &str, nodes: &[usize]) -> bool {
    if nodes.len() < 2 || nodes[0] != nodes[1] {
        return true;
    }
    let node = builder.nodes()[nodes[0]].label.clone();
    let joint = words.to_owned();
    table.note(key, &InputProblem::JoinedToItself { joint, node });
    false
}

/// Points on two nodes at offsets from them, in their axes.
pub(super) fn points(
    table: &Table<'_>,
    offsets: &Key<Option<Vec<Vector3<f64>>>>,
    nodes: [usize; 2],
) -> Option<[End; 2]> {
    let [first, second] = offsets_of::<2>(table, offsets)?;
    let ends = [(nodes[0], first), (nodes[1], second)];
    Some(ends.map(|(node, offset)| End::Node { node, offset }))
}

/// A point of the frame, `at`, and one on a node.
pub(super) fn frame_and_point(
    (table, at): (&Table<'_>, &Key<Option<Vector3<f64>>>),
    offsets: &Key<Option<Vec<Vector3<f64>>>>,
    node: usize,
    words: &str,
) -> Option<[End; 2]> {
    let offsets = offsets_of::<1>(table, offsets);
    let Some(position) = table.get(at)? else {
        let rod = words.to_owned();
        table.note(at, &LawProblem::NoAnchor { rod });
        return None;
    };
    let [offset] = offsets?;
    Some([End::Frame { position }, End::Node { node, offset }])
}

/// One vector per node; zeros if absent.
fn offsets_of<const N: usize>(
    table: &Table<'_>,
    key: &Key<Option<Vec<Vector3<f64>>>>,
) -> Option<[Vector3<f64>; N]> {
    let Some(found) = table.get(key)? else {
        return Some([Vector3::zeros(); N]);
    };
    let expected = format!("one offset for each of the nodes, {N}");
    let found = <[Vector3<f64>; N]>::try_from(found);
    found.map_err(|_| table.wrong(key, &expected)).ok()
}

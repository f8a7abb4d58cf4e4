//! Keys of layers, webs and anchors that windIO does not define: files may have them, and they have
//! no effect.

use shared_geom::error::nearest_name;
use shared_geom::exchange::yaml::{Node, Value};

use super::Notes;
use super::planes::{FORMER, OFFSET};
use super::version::Version;

/// Keys of places in both versions.
const ENDS: [&str; 5] = [
    "name",
    "start_nd_arc",
    "end_nd_arc",
    "start_nd_grid",
    "end_nd_grid",
];
/// Further keys of layers in both versions.
const LAYER: [&str; 5] = [
    "material",
    "web",
    "thickness",
    "n_plies",
    "fiber_orientation",
];
/// Holders named in a remark.
const NAMED: usize = 3;

/// Further keys of a list of a structure.
fn further(list: &str, version: Version) -> Vec<&'static str> {
    let (all, own): (&[&str], &[&str]) = match (list, version) {
        ("layers", Version::One) => {
            let own = &[
                "width",
                "midpoint_nd_arc",
                OFFSET,
                FORMER,
                "rotation",
                "side",
            ];
            (&LAYER, own)
        }
        ("layers", Version::Two) => (&LAYER, &[]),
        ("webs", Version::One) => (&[], &[OFFSET, FORMER, "rotation"]),
        ("webs", Version::Two) => (&[], &["anchors", "flanges"]),
        ("flanges", _) => (&[], &["type", "side", "bondline"]),
        _ => {
            let rules = &["offset_arc", "offset_nd_arc", "plane_intersection", "width"];
            (&["midpoint_nd_arc"], rules)
        }
    };
    all.iter().chain(own).copied().collect()
}

/// A key that is not read: its list, its first line, and the names that have it.
struct Other<'n> {
    list: &'static str,
    key: &'n str,
    line: usize,
    names: Vec<&'n str>,
}

/// Remarks on keys that are not read, one for all layers, webs or anchors that have it.
pub(super) fn report_others(structure: &Node, version: Version, notes: &mut Notes) {
    let mut others: Vec<Other<'_>> = Vec::new();
    for list in ["anchors", "webs", "layers"] {
        for item in listed(structure, list) {
            let name = item.entry("name").and_then(Node::text).unwrap_or("?");
            note(&mut others, (list, version), (item, name));
            for flange in listed(item, "flanges").filter(|_| list == "webs") {
                note(&mut others, ("flanges", version), (flange, name));
            }
        }
    }
    for other in others {
        let Other {
            list,
            key,
            line,
            names,
        } = other;
        let known = ENDS.into_iter().chain(further(list, version));
        let hint = match nearest_name(key, known) {
            Some(near) => format!("; did you mean \"{near}\"?"),
            None => String::new(),
        };
        let more = match names.len().saturating_sub(NAMED) {
            0 => String::new(),
            more => format!(" and {more} more"),
        };
        let names = names[..names.len().min(NAMED)].join(", ");
        notes.remarks.push(format!(
            "line {line}: \"{key}\" of {list} ({names}{more}) is no key of windIO and has no \
             effect{hint}"
        ));
    }
}

/// The tables of a list.
fn listed<'n>(node: &'n Node, key: &str) -> impl Iterator<Item = &'n Node> {
    let list: &[_] = match node.entry(key).map(|node| &node.value) {
        Some(Value::List(list)) => list,
        _ => &[],
    };
    list.iter().map(AsRef::as_ref)
}

/// Notes the keys of a table that are not read.
fn note<'n>(
    others: &mut Vec<Other<'n>>,
    (list, version): (&'static str, Version),
    (item, name): (&'n Node, &'n str),
) {
    let known = further(list, version);
    let is_known = |key: &str| ENDS.contains(&key) || known.contains(&key);
    for key in item.keys().into_iter().filter(|key| !is_known(key)) {
        let mut same = others.iter_mut();
        match same.find(|other| other.list == list && other.key == key) {
            Some(other) => other.names.push(name),
            None => others.push(Other {
                list,
                key,
                line: item.entry(key).map_or(item.line, |node| node.line),
                names: vec![name],
            }),
        }
    }
}

//! Places that windIO files name: tables of arcs, and the anchors of version 2.

use std::cell::RefCell;

use shared_geom::exchange::ExchangeProblem;
use shared_geom::exchange::text::number;
use shared_geom::exchange::yaml::{Node, Value};

use super::super::place::{Place, PlaceForm};
use super::planes::Tilt;
use super::planes::{FORMER, OFFSET};
use super::version::Version;
use super::{Notes, course, items, word};

pub(super) const START: &str = "start_nd_arc";
pub(super) const END: &str = "end_nd_arc";
pub(super) const MIDDLE: &str = "midpoint_nd_arc";
/// Places of an anchor to which others refer.
const HANDLES: [&str; 3] = [START, END, MIDDLE];
/// Rules of anchors beside their arcs.
pub(super) const RULES: [&str; 4] = ["offset_arc", "offset_nd_arc", "plane_intersection", "width"];
/// Round-off of arcs [-].
pub(super) const ROUND_OFF: f64 = 1e-6;

/// Keys of rules for places.
pub(super) const KEYS: [&str; 8] = [
    START, END, MIDDLE, OFFSET, FORMER, "rotation", "side", "width",
];

/// An entry of the file that has a place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Holder {
    Layer,
    Web,
}

/// A place that two rules determine: the one that is used first.
pub(super) struct Doubt {
    pub what: String,
    pub line: usize,
    pub rules: [&'static str; 2],
    pub pair: [Place; 2],
}

/// The places that a structure names.
pub(super) struct Places<'n> {
    pub version: Version,
    anchors: Vec<(&'n str, &'n Node)>,
    pub layers: Vec<(&'n str, &'n Node)>,
    pub tilt: Option<&'n Tilt>,
    pub doubts: RefCell<Vec<Doubt>>,
}

impl<'n> Places<'n> {
    /// The places of a structure.
    pub fn new(
        structure: &'n Node,
        version: Version,
        tilt: Option<&'n Tilt>,
        notes: &mut Notes,
    ) -> Self {
        let mut named = |key: &str| -> Vec<(&'n str, &'n Node)> {
            let all = structure
                .entry(key)
                .and_then(|node| items(node, key, notes));
            let all = all.unwrap_or_default().into_iter();
            all.filter_map(|item| Some((item.entry("name")?.text()?, item)))
                .collect()
        };
        let (anchors, layers) = (named("anchors"), named("layers"));
        note_doubled(&anchors, notes);
        Self {
            version,
            anchors,
            layers,
            tilt,
            doubts: RefCell::new(Vec::new()),
        }
    }

    /// The end of another layer, if its anchor is the anchor of a place.
    pub fn end_of_layer(&self, item: &Node, node: &Node) -> Option<Place> {
        let named = |node: &'_ Node| {
            let anchor = node.entry("anchor")?;
            let of = |key: &str| anchor.entry(key).and_then(Node::text).map(str::to_owned);
            Some((of("name")?, of("handle")?))
        };
        let (name, handle) = named(node)?;
        let (_, layer) = self.layers.iter().find(|(known, _)| *known == name)?;
        let is_its_own =
            layer.entry(&handle).and_then(named) == Some((name.clone(), handle.clone()));
        let is_other = item.entry("name").and_then(Node::text) != Some(&name);
        let end = [(START, "start"), (END, "end")];
        let (_, end) = end.into_iter().find(|(known, _)| *known == handle)?;
        let is_found = is_its_own && is_other && layer.entry("web").is_none();
        is_found.then(|| Place::of_name(format!("{name}.{end}"), node.line))
    }

    /// The place under a key of version 2: a table of arcs, or a reference to an anchor. `path`
    /// has the anchors that led to it.
    pub fn referred(
        &self,
        node: &'n Node,
        what: &str,
        path: &mut Vec<String>,
        notes: &mut Notes,
    ) -> Option<Place> {
        let Some(reference) = node.entry("anchor") else {
            return arc(node, what, notes);
        };
        let of = format!("the anchor of {what}");
        let name = word(reference, &of, "name", notes);
        let handle = word(reference, &of, "handle", notes);
        let (name, handle) = (name?, handle?);
        let Some((_, anchor)) = self.anchors.iter().find(|(known, _)| *known == name) else {
            let known: Vec<&str> = self.anchors.iter().map(|(name, _)| *name).collect();
            let expected = ["the name of an anchor", &known.join("\n")];
            notes.unknown(reference.line, what, name, expected);
            return None;
        };
        if !HANDLES.contains(&handle) {
            let expected = ["a handle of an anchor", &HANDLES.join("\n")];
            notes.unknown(reference.line, &of, handle, expected);
            return None;
        }
        self.handle(anchor, (name, handle), path, notes)
    }

    /// A place of an anchor: its arc if it has one, else by another rule.
    fn handle(
        &self,
        anchor: &'n Node,
        (name, handle): (&str, &str),
        path: &mut Vec<String>,
        notes: &mut Notes,
    ) -> Option<Place> {
        let full = format!("{name}.{handle}");
        let is_circle = path.contains(&full);
        path.push(full);
        if is_circle {
            let found = path.join(" -> ");
            let help = "give the arcs of one of them";
            let expected = "places that do not refer to themselves";
            notes.wrong(anchor.line, ["anchors", &found, expected, help]);
            return None;
        }
        let of = format!("{handle} of anchor \"{name}\"");
        let has_rule = RULES.iter().any(|key| rule(anchor, key, handle).is_some());
        let given = anchor.entry(handle);
        let arc = given.filter(|node| !(has_rule && is_padding(node)));
        let place = match arc {
            Some(node) => self.referred(node, &of, path, notes),
            None => self.derived(anchor, (name, handle), path, notes),
        };
        if given.is_some() && arc.is_none() {
            let line = anchor.line;
            let remark = format!("line {line}: {of} is constant: its rule is used");
            if !notes.remarks.contains(&remark) {
                notes.remarks.push(remark);
            }
        }
        path.pop();
        let is_new = || self.doubts.borrow().iter().all(|doubt| doubt.what != of);
        let is_arc = arc.is_some_and(|node| node.entry("grid").is_some());
        if is_arc && has_rule && path.is_empty() && is_new() {
            let by_rule = self.derived(anchor, (name, handle), path, notes);
            let mut rules = RULES.into_iter();
            let used = rules.find(|key| rule(anchor, key, handle).is_some());
            if let (Some(place), Some(by_rule)) = (&place, by_rule) {
                self.doubt(Doubt {
                    what: of,
                    line: anchor.line,
                    rules: ["arcs", used.unwrap_or("rule")],
                    pair: [place.clone(), by_rule],
                });
            }
        }
        place
    }

    /// Remembers a place of two rules, to be compared.
    pub fn doubt(&self, doubt: Doubt) {
        self.doubts.borrow_mut().push(doubt);
    }

    /// A place of an anchor by its rules.
    fn derived(
        &self,
        anchor: &'n Node,
        (name, handle): (&str, &str),
        path: &mut Vec<String>,
        notes: &mut Notes,
    ) -> Option<Place> {
        let of = format!("{handle} of anchor \"{name}\"");
        if let Some(node) = rule(anchor, "offset_arc", handle) {
            let base = self.referred(node, &of, path, notes);
            let by = course(node, &format!("offset_arc of {of}"), notes);
            return Some(base?.shifted(&by?, 1.0));
        }
        if let Some(node) = rule(anchor, "offset_nd_arc", handle) {
            let base = self.referred(node, &of, path, notes);
            let by = course(node, &format!("offset_nd_arc of {of}"), notes);
            let (base, by) = (base?, by?);
            if let PlaceForm::Arc(arc) = &base.form {
                let form = PlaceForm::Arc(arc.plus(&by, 1.0));
                return Some(Place { form, ..base });
            }
            let (found, expected) = ("an anchor without arcs", "an anchor with arcs");
            notes.wrong(
                node.line,
                ["offset_nd_arc", found, expected, "use offset_arc"],
            );
            return None;
        }
        if let Some(node) = rule(anchor, "plane_intersection", handle) {
            let side = plane_side(node, handle, &of, notes)?;
            return self.tilt?.version_2(node, &of, side, notes).map(Place::of);
        }
        let sign = if handle == START { -1.0 } else { 1.0 };
        let other = if handle == START { END } else { START };
        if let Some(node) = anchor.entry("width").filter(|_| handle != MIDDLE) {
            let width = course(node, &format!("width of anchor \"{name}\""), notes);
            let has_middle = anchor.entry(MIDDLE).is_some()
                || rule(anchor, "plane_intersection", MIDDLE).is_some();
            if has_middle {
                let middle = self.handle(anchor, (name, MIDDLE), path, notes);
                return Some(middle?.shifted(&width?, 0.5 * sign));
            }
            if anchor.entry(other).is_some() {
                let other = self.handle(anchor, (name, other), path, notes);
                return Some(other?.shifted(&width?, sign));
            }
        }
        let what = format!("{handle} of anchor \"{name}\"");
        let help = format!("the anchor has {}", anchor.keys().join(", "));
        notes
            .problems
            .push(anchor.line, &ExchangeProblem::Missing { what, help });
        None
    }
}

/// Notes anchors of one name, of which references cannot mean both.
fn note_doubled(anchors: &[(&str, &Node)], notes: &mut Notes) {
    for (number, (name, node)) in anchors.iter().enumerate() {
        let mut before = anchors[..number].iter();
        if let Some((_, first)) = before.find(|known| known.0 == *name) {
            let found = format!("given twice, first in line {}", first.line);
            let expected = "one anchor of each name";
            let help = "remove one of them, or give it another name";
            notes.wrong(
                node.line,
                [&format!("anchor \"{name}\""), &found, expected, help],
            );
        }
    }
}

/// A rule of an anchor that defines one of its places.
fn rule<'n>(anchor: &'n Node, key: &str, handle: &str) -> Option<&'n Node> {
    let rule = anchor.entry(key)?;
    let defines = rule.entry("defines")?;
    let is_one = match &defines.value {
        Value::Text(text) => text == handle,
        Value::List(list) => list.iter().any(|item| item.text() == Some(handle)),
        Value::Table(_) => false,
    };
    is_one.then_some(rule)
}

/// Whether a table of arcs has the edge of the contour along the whole span.
pub(super) fn is_padding(node: &Node) -> bool {
    let Some(Value::List(list)) = node.entry("values").map(|values| &values.value) else {
        return false;
    };
    let mut arcs = list.iter().map(|item| item.text().and_then(number));
    let first = arcs.next().flatten();
    first.is_some_and(|arc| arc == 0.0 || arc == 1.0) && arcs.all(|arc| arc == first)
}

/// The side of the plane of an anchor.
fn plane_side(rule: &Node, handle: &str, of: &str, notes: &mut Notes) -> Option<usize> {
    let side = word(rule, &format!("plane_intersection of {of}"), "side", notes)?;
    match (side, handle) {
        ("suction", _) | ("both", START) => Some(0),
        ("pressure", _) | ("both", END) => Some(1),
        _ => {
            let expected = "\"suction\" or \"pressure\"; \"both\" for start and end";
            let found = format!("\"{side}\"");
            let what = format!("side of the plane of {of}");
            notes.wrong(rule.line, [&what, &found, expected, "name the side"]);
            None
        }
    }
}

/// A table of arcs, from 0 to 1.
pub(super) fn arc(node: &Node, what: &str, notes: &mut Notes) -> Option<Place> {
    let arcs = course(node, what, notes)?;
    let outside = arcs
        .points()
        .find(|(_, arc)| !(-ROUND_OFF..=1.0 + ROUND_OFF).contains(arc));
    if let Some((eta, arc)) = outside {
        let found = format!("{arc} at {eta}");
        let help = "arcs grow from the trailing edge over the suction side (0) to it again (1)";
        notes.wrong(node.line, [what, &found, "arcs from 0 to 1", help]);
        return None;
    }
    let arcs = arcs.map(|_, arc| arc.clamp(0.0, 1.0));
    Some(Place::of(PlaceForm::Arc(arcs)))
}

/// Notes that the place of a layer or web lacks a part.
pub(super) fn half(
    holder: Holder,
    item: &Node,
    (of, given): (&str, &[&str]),
    expected: &str,
    notes: &mut Notes,
) {
    let found = match given {
        [] => "nothing".to_owned(),
        [one] => format!("{one} alone"),
        several => several.join(", "),
    };
    let help = match holder {
        Holder::Layer => "a layer without any of these keys lies all around",
        Holder::Web => "a web has a place on each side",
    };
    let what = format!("the place of {of}");
    notes.wrong(item.line, [&what, &found, expected, help]);
}

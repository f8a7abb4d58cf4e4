//! Places of layers and webs in windIO files.
//!
//! Of several rules the first wins: both arcs, one arc and the width, the middle and the width, a
//! plane (and the width), all around. A layer that starts at arc 1 and ends before it starts at 0.

use std::cell::RefCell;

use shared_geom::exchange::ExchangeProblem;
use shared_geom::exchange::text::number;
use shared_geom::exchange::yaml::{Node, Value};

use super::super::course::Course;
use super::super::place::{Place, PlaceForm, SIDES};
use super::planes::Tilt;
use super::{Notes, Version, course, items, word};

const START: &str = "start_nd_arc";
const END: &str = "end_nd_arc";
const MIDDLE: &str = "midpoint_nd_arc";
/// Rules of anchors beside their arcs.
const RULES: [&str; 4] = ["offset_arc", "offset_nd_arc", "plane_intersection", "width"];
/// Round-off of arcs [-].
const ROUND_OFF: f64 = 1e-6;

/// A place that two rules determine: the one that is used first.
pub(super) struct Doubt {
    pub what: String,
    pub line: usize,
    pub pair: [Place; 2],
}

/// The places that a structure names.
pub(super) struct Places<'n> {
    pub version: Version,
    anchors: Vec<(&'n str, &'n Node)>,
    layers: Vec<(&'n str, &'n Node)>,
    tilt: Option<&'n Tilt>,
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
        Self {
            version,
            anchors: named("anchors"),
            layers: named("layers"),
            tilt,
            doubts: RefCell::new(Vec::new()),
        }
    }

    /// Start and end of a layer, or the places of a web on both sides.
    pub fn of(&self, item: &'n Node, what: &str, notes: &mut Notes) -> Option<[Place; 2]> {
        let pair = match self.version {
            Version::One => self.version_1(item, what, notes),
            Version::Two => {
                let mut one = |key: &str, around: f64| match item.entry(key) {
                    Some(node) => {
                        let what = format!("{key} of {what}");
                        let place = self.referred(node, &what, &mut Vec::new(), notes)?;
                        Some(self.end_of_layer(item, node).unwrap_or(place))
                    }
                    None => Some(Place::arc(around)),
                };
                let pair = [one(START, 0.0), one(END, 1.0)];
                let [start, end] = pair;
                Some([start?, end?])
            }
        };
        pair.map(|pair| wrapped(pair, what, item.line, notes))
    }

    /// The end of another layer, if its anchor is the anchor of a place.
    fn end_of_layer(&self, item: &Node, node: &Node) -> Option<Place> {
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
        let form = PlaceForm::Named(format!("{name}.{end}"));
        (is_its_own && is_other && layer.entry("web").is_none()).then(|| Place::of(form))
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
            if let (Some(place), Some(by_rule)) = (&place, by_rule) {
                self.doubt(of, anchor.line, [place.clone(), by_rule]);
            }
        }
        place
    }

    fn doubt(&self, what: String, line: usize, pair: [Place; 2]) {
        self.doubts.borrow_mut().push(Doubt { what, line, pair });
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

    /// Start and end of a layer or web of version 1.
    fn version_1(&self, item: &'n Node, of: &str, notes: &mut Notes) -> Option<[Place; 2]> {
        let arcs = [START, END, MIDDLE].map(|key| match item.entry(key) {
            Some(node) => self.fixed(node, key, of, notes).map(Some),
            None => Some(None),
        });
        let width = match item.entry("width") {
            Some(node) => course(node, &format!("width of {of}"), notes).map(Some),
            None => Some(None),
        };
        let [start, end, middle] = arcs;
        let (start, end, middle, width) = (start?, end?, middle?, width?);
        let around = |middle: Place, width: &Course| {
            [-0.5, 0.5].map(|part| middle.clone().shifted(width, part))
        };
        let plane = match item.entry("offset_y_pa") {
            Some(_) => Some(self.plane_1(item, of, width.as_ref(), notes)?),
            None => None,
        };
        Some(match (start, end, middle, width) {
            (Some(start), Some(end), ..) => {
                if let Some(rule) = plane {
                    let pairs = [start.clone(), end.clone()].into_iter().zip(rule);
                    for (key, (place, rule)) in [START, END].iter().zip(pairs) {
                        self.doubt(format!("{key} of {of}"), item.line, [place, rule]);
                    }
                }
                [start, end]
            }
            (Some(start), None, _, Some(width)) => {
                let end = start.clone().shifted(&width, 1.0);
                [start, end]
            }
            (None, Some(end), _, Some(width)) => [end.clone().shifted(&width, -1.0), end],
            (_, _, Some(middle), Some(width)) => around(middle, &width),
            (start, end, ..) => match plane {
                Some(pair) => pair,
                None => [
                    start.unwrap_or_else(|| Place::arc(0.0)),
                    end.unwrap_or_else(|| Place::arc(1.0)),
                ],
            },
        })
    }

    /// The places of `offset_y_pa`: of a web on both sides, of a layer with its width on one.
    fn plane_1(
        &self,
        item: &'n Node,
        of: &str,
        width: Option<&Course>,
        notes: &mut Notes,
    ) -> Option<[Place; 2]> {
        let tilt = self.tilt?;
        let Some(width) = width else {
            let both = [0, 1].map(|side| tilt.version_1(item, of, side, notes).map(Place::of));
            let [suction, pressure] = both;
            return Some([suction?, pressure?]);
        };
        let side = word(item, of, "side", notes)?;
        let Some(side) = SIDES.iter().position(|known| *known == side) else {
            notes.unknown(
                item.line,
                &format!("side of {of}"),
                side,
                ["a side", &SIDES.join("\n")],
            );
            return None;
        };
        let middle = Place::of(tilt.version_1(item, of, side, notes)?);
        Some([-0.5, 0.5].map(|part| middle.clone().shifted(width, part)))
    }

    /// The place under a key of version 1: a table of arcs, or `fixed` at an edge or a layer.
    fn fixed(&self, node: &'n Node, key: &str, of: &str, notes: &mut Notes) -> Option<Place> {
        let what = format!("{key} of {of}");
        let Some(fixed) = node.entry("fixed") else {
            return arc(node, &what, notes);
        };
        let name = fixed.text().unwrap_or_default();
        let ends = [(START, "end", 0.0), (END, "start", 1.0)];
        let end = ends.iter().find(|end| end.0 == key);
        match (name, end) {
            ("LE", _) => Some(Place::of(PlaceForm::Named("leading_edge".to_owned()))),
            ("TE", Some((_, _, around))) => Some(Place::arc(*around)),
            (_, Some((_, end, _))) if self.layers.iter().any(|layer| layer.0 == name) => {
                Some(Place::of(PlaceForm::Named(format!("{name}.{end}"))))
            }
            ("TE", None) => {
                let found = "the trailing edge as the middle of a layer";
                let help = "write two layers, one on each side";
                notes.wrong(fixed.line, [&what, found, "a place on one side", help]);
                None
            }
            _ => {
                let layers = self.layers.iter().map(|layer| layer.0);
                let known: Vec<&str> = ["TE", "LE"].into_iter().chain(layers).collect();
                let expected = ["TE, LE or the name of a layer", &known.join("\n")];
                notes.unknown(fixed.line, &what, name, expected);
                None
            }
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
fn is_padding(node: &Node) -> bool {
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
fn arc(node: &Node, what: &str, notes: &mut Notes) -> Option<Place> {
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

/// Starts at arc 1 before a smaller end are starts at 0.
fn wrapped([start, end]: [Place; 2], what: &str, line: usize, notes: &mut Notes) -> [Place; 2] {
    let (PlaceForm::Arc(from), PlaceForm::Arc(to)) = (&start.form, &end.form) else {
        return [start, end];
    };
    let is_wrong =
        |eta: f64, arc: f64| arc > 1.0 - ROUND_OFF && to.at(eta) < 1.0 - 100.0 * ROUND_OFF;
    if !from.points().any(|(eta, arc)| is_wrong(eta, arc)) {
        return [start, end];
    }
    notes.remarks.push(format!(
        "line {line}: {what} starts at arc 1, beyond its end: arc 0 is taken"
    ));
    let from = from.map(|eta, arc| if is_wrong(eta, arc) { 0.0 } else { arc });
    let form = PlaceForm::Arc(from);
    [Place { form, ..start }, end]
}

//! Places of layers and webs in version 1 of windIO.
//!
//! A layer or web may have all parts of several rules; the first one counts, and the others are
//! compared with it. Some of the parts of a rule, without a complete one, are an error.

use shared_geom::exchange::yaml::Node;

use super::super::course::Course;
use super::super::place::{Place, PlaceForm, SIDES};
use super::places::{Doubt, END, Holder, KEYS, MIDDLE, Places, START, arc, half};
use super::planes::{FORMER, OFFSET, offset_key};
use super::seam::is_middle_at_edge;
use super::{Notes, course, word};

/// A rule with all its parts: its name, and both places.
type Rule = (&'static str, [Place; 2]);

impl<'n> Places<'n> {
    /// Start and end of a layer, or the places of a web on both sides.
    pub fn version_1(
        &self,
        holder: Holder,
        item: &'n Node,
        of: &str,
        notes: &mut Notes,
    ) -> Option<[Place; 2]> {
        // programs write a middle at the trailing edge beside arcs
        let has_arcs = [START, END].iter().all(|key| item.entry(key).is_some());
        let at_edge = holder == Holder::Layer && is_middle_at_edge(item);
        let is_padded = has_arcs && is_middle_at_edge(item);
        let arcs = [START, END, MIDDLE].map(|key| match item.entry(key) {
            Some(_) if key == MIDDLE && is_padded => Some(None),
            Some(node) => self.fixed(node, key, of, notes).map(Some),
            None => Some(None),
        });
        let width = match item.entry("width") {
            Some(node) => course(node, &format!("width of {of}"), notes).map(Some),
            None => Some(None),
        };
        let [start, end, middle] = arcs;
        let (start, end, middle, width) = (start?, end?, middle?, width?);
        let arcs = [start, end, middle];
        let offset = offset_key(item).filter(|_| holder == Holder::Web || width.is_some());
        let plane = match offset {
            Some(key) => Some((key, self.plane_1(item, of, width.as_ref(), notes)?)),
            None => None,
        };
        let rules = rules(&arcs, width.as_ref(), plane, at_edge);
        let Some((first, others)) = rules.split_first() else {
            return around(holder, item, of, notes);
        };
        for (name, other) in others {
            for (i, key) in [START, END].into_iter().enumerate() {
                let pair = [&first.1, other].map(|rule| rule[i].clone());
                self.doubt(Doubt {
                    what: format!("{key} of {of}"),
                    line: item.line,
                    rules: [first.0, *name],
                    pair,
                });
            }
        }
        if let ([Some(start), Some(end), Some(middle)], None) = (&arcs, &width) {
            self.middle(item, of, [start, end, middle]);
        }
        Some(first.1.clone())
    }

    /// Compares the middle of a layer with both of its arcs.
    fn middle(&self, item: &Node, of: &str, [start, end, middle]: [&Place; 3]) {
        let (PlaceForm::Arc(from), PlaceForm::Arc(to)) = (&start.form, &end.form) else {
            return;
        };
        let mean = from.plus(to, 1.0).map(|_, sum| 0.5 * sum);
        self.doubt(Doubt {
            what: format!("the middle of {of}"),
            line: item.line,
            rules: ["arcs", MIDDLE],
            pair: [Place::of(PlaceForm::Arc(mean)), middle.clone()],
        });
    }

    /// The places of `offset_y_pa`, or `offset_x_pa`: of a web on both sides, of a layer with its width on one.
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
        let is_own = of == format!("layer \"{name}\"");
        let ends = [(START, "end", 0.0), (END, "start", 1.0)];
        let end = ends.iter().find(|end| end.0 == key);
        match (name, end) {
            ("LE", _) => Some(Place::of(PlaceForm::Named("leading_edge".to_owned()))),
            ("TE", Some((_, _, around))) => Some(Place::arc(*around)),
            (_, Some((_, end, _)))
                if !is_own && self.layers.iter().any(|layer| layer.0 == name) =>
            {
                Some(Place::of_name(format!("{name}.{end}"), fixed.line))
            }
            ("TE", None) => Some(Place::arc(1.0)),
            _ => {
                let layers = self.layers.iter().map(|layer| layer.0);
                let layers = layers.filter(|layer| *layer != name);
                let known: Vec<&str> = ["TE", "LE"].into_iter().chain(layers).collect();
                let expected = ["TE, LE or the name of another layer", &known.join("\n")];
                notes.unknown(fixed.line, &what, name, expected);
                None
            }
        }
    }
}

/// The rules that have all their parts, in their order; of a layer whose middle is at the trailing
/// edge.
fn rules(
    [start, end, middle]: &[Option<Place>; 3],
    width: Option<&Course>,
    plane: Option<Rule>,
    at_edge: bool,
) -> Vec<Rule> {
    let mut all: Vec<Rule> = Vec::new();
    let both = start.as_ref().zip(end.as_ref());
    if let Some((start, end)) = both {
        all.push(("arcs", [start.clone(), end.clone()]));
    }
    let shifted = |place: &Place, factor: f64| match width {
        Some(width) if factor != 0.0 => place.clone().shifted(width, factor),
        _ => place.clone(),
    };
    // beside both arcs, the width alone is a rule of the end
    let has_other = middle.is_some() || plane.is_some();
    let named = [
        ("start_nd_arc and width", start, [0.0, 1.0], has_other),
        ("end_nd_arc and width", end, [-1.0, 0.0], true),
        ("midpoint_nd_arc and width", middle, [-0.5, 0.5], false),
    ];
    for (name, place, factors, is_left_out) in named {
        if let (Some(place), Some(_)) = (place, width)
            && !(is_left_out && both.is_some())
        {
            let edge = [Place::arc(1.0), Place::arc(0.0)];
            let pair = match factors {
                // on both sides of the trailing edge
                [from, to] if at_edge && from < 0.0 && to > 0.0 => {
                    [shifted(&edge[0], from), shifted(&edge[1], to)]
                }
                _ => factors.map(|factor| shifted(place, factor)),
            };
            all.push((name, pair));
        }
    }
    all.extend(plane);
    all
}

/// The places of a layer without any rule; notes a web without one, and parts of rules.
fn around(holder: Holder, item: &Node, of: &str, notes: &mut Notes) -> Option<[Place; 2]> {
    let given: Vec<&str> = KEYS
        .into_iter()
        .filter(|key| item.entry(key).is_some())
        .collect();
    let has = |key: &str| given.contains(&key);
    let has_offset = has(OFFSET) || has(FORMER);
    let expected = match holder {
        Holder::Layer if given.is_empty() => return Some([Place::arc(0.0), Place::arc(1.0)]),
        Holder::Layer if has(START) => "end_nd_arc or width too",
        Holder::Layer if has(END) => "start_nd_arc or width too",
        Holder::Layer if has(MIDDLE) => "width too",
        Holder::Layer if has_offset && has("side") => "width too",
        Holder::Layer if has_offset => "width and side too",
        Holder::Layer if has("width") => {
            "start_nd_arc, end_nd_arc, midpoint_nd_arc, or offset_y_pa and side too"
        }
        Holder::Layer => "offset_y_pa, width and side",
        Holder::Web if has(START) => "end_nd_arc too",
        Holder::Web if has(END) => "start_nd_arc too",
        Holder::Web => "offset_y_pa, or start_nd_arc and end_nd_arc",
    };
    half(holder, item, (of, &given), expected, notes);
    None
}

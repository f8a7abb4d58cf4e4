//! Both places of layers and webs in windIO files.
//!
//! Of several rules the first wins: both arcs, one arc and the width, the middle and the width, a
//! plane (and the width), all around. A layer that starts at arc 1 and ends before it starts at 0.

use shared_geom::exchange::yaml::Node;

use super::super::place::{Place, PlaceForm};
use super::Notes;
use super::places::{END, Holder, KEYS, Places, ROUND_OFF, RULES, START, half};
use super::version::Version;

impl<'n> Places<'n> {
    /// Start and end of a layer, or the places of a web on both sides.
    pub fn of(
        &self,
        holder: Holder,
        item: &'n Node,
        what: &str,
        notes: &mut Notes,
    ) -> Option<[Place; 2]> {
        let pair = match self.version {
            Version::One => self.version_1(holder, item, what, notes),
            Version::Two => self.version_2(holder, item, what, notes),
        };
        pair.map(|pair| wrapped(pair, what, item.line, notes))
    }

    /// The places of version 2, which has all rules in its anchors.
    fn version_2(
        &self,
        holder: Holder,
        item: &'n Node,
        what: &str,
        notes: &mut Notes,
    ) -> Option<[Place; 2]> {
        let rules = RULES.into_iter().filter(|key| !KEYS.contains(key));
        let keys = KEYS.into_iter().chain(rules);
        let given: Vec<&str> = keys.filter(|key| item.entry(key).is_some()).collect();
        let is_around = given.is_empty() && holder == Holder::Layer;
        if is_around {
            return Some([Place::arc(0.0), Place::arc(1.0)]);
        }
        if [START, END].iter().any(|key| item.entry(key).is_none()) {
            let expected = "start_nd_arc and end_nd_arc, which refer to anchors";
            half(holder, item, (what, &given), expected, notes);
            return None;
        }
        if let Some(at) = one_end(item) {
            let holder = match holder {
                Holder::Layer => "the start and the end of the layer",
                Holder::Web => "two places, one on each side",
            };
            let found = format!("{at} for both {START} and {END}");
            let help = "refer to another handle for one of them";
            notes.wrong(
                item.line,
                [&format!("the place of {what}"), &found, holder, help],
            );
            return None;
        }
        let pair = [START, END].map(|key| {
            let node = item.entry(key)?;
            let what = format!("{key} of {what}");
            let place = self.referred(node, &what, &mut Vec::new(), notes)?;
            Some(self.end_of_layer(item, node).unwrap_or(place))
        });
        let [start, end] = pair;
        Some([start?, end?])
    }
}

/// The handle of an anchor to which both ends refer, if they do.
fn one_end(item: &Node) -> Option<String> {
    let [start, end] = [START, END].map(|key| {
        let anchor = item.entry(key)?.entry("anchor")?;
        let of = |key: &str| anchor.entry(key).and_then(Node::text);
        Some(format!("{} of anchor \"{}\"", of("handle")?, of("name")?))
    });
    if start == end { start } else { None }
}

/// Starts at arc 1 before a smaller end are starts at 0.
fn wrapped([start, end]: [Place; 2], what: &str, line: usize, notes: &mut Notes) -> [Place; 2] {
    let (PlaceForm::Arc(from), PlaceForm::Arc(to)) = (&start.form, &end.form) else {
        return [start, end];
    };
    // a layer whose middle is the edge starts before it
    if !start.shift.is_zero() {
        return [start, end];
    }
    let is_wrong =
        |eta: f64, arc: f64| arc > 1.0 - ROUND_OFF && to.at(eta) < 1.0 - 100.0 * ROUND_OFF;
    // From 1 to 0 everywhere are swapped ends.
    let is_swapped = from
        .points()
        .all(|(eta, arc)| is_wrong(eta, arc) && to.at(eta) < ROUND_OFF);
    if is_swapped || !from.points().any(|(eta, arc)| is_wrong(eta, arc)) {
        return [start, end];
    }
    notes.remarks.push(format!(
        "line {line}: {what} starts at arc 1, beyond its end: arc 0 is taken"
    ));
    let from = from.map(|eta, arc| if is_wrong(eta, arc) { 0.0 } else { arc });
    let form = PlaceForm::Arc(from);
    [Place { form, ..start }, end]
}

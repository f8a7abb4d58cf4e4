//! Layers and webs of windIO files.

use shared_geom::error::quoted;
use shared_geom::exchange::text::number;
use shared_geom::exchange::yaml::{Node, Value};

use super::super::course::Course;
use super::super::place::Place;
use super::super::{WrittenLayer, WrittenWeb};
use super::angles::{self, Angle};
use super::places::{Holder, Places};
use super::seam;
use super::version::Version;
use super::{Notes, course, items, required, word};

/// Parts of a web or an angle that differ by less are equal [-] or \[rad\].
const SAME: f64 = 1e-6;
/// Negative thicknesses and numbers of plies above this one are round-off \[m\] or [-].
const ROUND_OFF: f64 = 1e-6;
/// Largest difference of a thickness and its plies that is not reported, as a part of them.
const SAME_THICKNESS: f64 = 0.01;
/// Tables of the structure that are read, or that do not belong to a section.
const KNOWN: [&str; 8] = [
    "anchors",
    "webs",
    "layers",
    "joint",
    "root",
    "elastic_properties",
    "reference_axis",
    "lofted_shape",
];

/// The layers of the shell and the webs of a blade, and places by their names.
pub(super) type Parts = (Vec<WrittenLayer>, Vec<WrittenWeb>, Vec<(String, Place)>);

/// The first use of a material.
pub(super) struct Used {
    pub material: String,
    pub line: usize,
    pub layer: String,
}

impl Used {
    /// Adds the material of a layer if it is new.
    fn note(all: &mut Vec<Self>, holder: &Node, layer: &str) {
        let Some(node) = holder.entry("material") else {
            return;
        };
        let material = node.text().unwrap_or_default().to_owned();
        if all.iter().all(|known| known.material != material) {
            all.push(Self {
                material,
                line: node.line,
                layer: layer.to_owned(),
            });
        }
    }
}

/// Reads the materials that a structure uses, and its layers and webs if all are right.
pub(super) fn read<'n>(
    structure: &'n Node,
    root: &Node,
    places: &Places<'n>,
    notes: &mut Notes,
) -> (Vec<Used>, Option<Parts>) {
    let mut used = Vec::new();
    remark_on_plies(&places.layers, root, notes);
    let parts = parts((structure, root), places, &mut used, notes);
    (used, parts)
}

fn parts<'n>(
    (structure, root): (&'n Node, &Node),
    places: &Places<'n>,
    used: &mut Vec<Used>,
    notes: &mut Notes,
) -> Option<Parts> {
    let what = "the structure";
    let list = required(structure, what, "layers", notes).and_then(|at| items(at, "layers", notes));
    let web_nodes = match structure.entry("webs") {
        Some(node) => items(node, "webs", notes)?,
        None => Vec::new(),
    };
    let mut is_complete = true;
    let mut webs: Vec<WrittenWeb> = Vec::new();
    for node in &web_nodes {
        match web(node, places, notes) {
            Some(web) => webs.push(web),
            None => is_complete = false,
        }
    }
    let names: Vec<&str> = web_nodes
        .iter()
        .filter_map(|node| node.entry("name")?.text())
        .collect();
    let (mut layers, mut named) = (Vec::new(), Vec::new());
    for item in list? {
        let Some(name) = word(item, "a layer", "name", notes) else {
            is_complete = false;
            continue;
        };
        Used::note(used, item, name);
        let read = layer(item, name, root, places, notes);
        let Some(web) = item.entry("web") else {
            is_complete &= read.is_some();
            let parts = read.map(|layer| {
                let to = (&mut named, &mut notes.remarks);
                seam::divided(layer, item, to)
            });
            layers.extend(parts.into_iter().flatten());
            continue;
        };
        let found = web.text().unwrap_or_default();
        if !names.contains(&found) {
            let expected = ["the name of a web", &names.join("\n")];
            let of = format!("web of layer \"{name}\"");
            notes.unknown(web.line, &of, found, expected);
        }
        let of_web = webs.iter_mut().find(|web| web.name == found);
        match (read, of_web) {
            (Some(ply), Some(web)) => web.plies.push(ply),
            _ => is_complete = false,
        }
    }
    for node in &web_nodes {
        is_complete &= bond_lines(node, places, (&mut layers, used), notes).is_some();
    }
    report_others(structure, notes);
    is_complete.then_some((layers, webs, named))
}

/// Reports the tables of the structure that are not meshed.
fn report_others(structure: &Node, notes: &mut Notes) {
    let others: Vec<&str> = structure
        .keys()
        .into_iter()
        .filter(|key| !KNOWN.contains(key))
        .collect();
    if !others.is_empty() {
        let line = structure.line;
        let others = others.join(", ");
        notes.remarks.push(format!(
            "line {line}: not meshed: {others}; a layer, or a [[fill]] for an adhesive, in the \
                 layup file that `layup --out` writes can stand for it"
        ));
    }
}

/// A layer of the shell or of a web.
fn layer<'n>(
    item: &'n Node,
    name: &str,
    root: &Node,
    places: &Places<'n>,
    notes: &mut Notes,
) -> Option<WrittenLayer> {
    let what = format!("layer \"{name}\"");
    let material = word(item, &what, "material", notes);
    let thickness = thickness(item, &what, root, notes);
    let fiber_angle = fiber_angle(item, &what, places.version, notes);
    let range = limits(item, &what, notes);
    let arcs = match item.entry("web") {
        None => places.of(Holder::Layer, item, &what, notes),
        Some(_) => Some([Place::arc(0.0), Place::arc(1.0)]),
    };
    let thickness = thickness?.within(range?);
    let (arcs, named) = (arcs?, (name.to_owned(), material?.to_owned()));
    Some(WrittenLayer {
        fiber_angle: fiber_angle?,
        ..WrittenLayer::plain(named, thickness, arcs, item.line)
    })
}

/// The positions along the span within which a layer or web is; the whole span without them [-].
fn limits(node: &Node, of: &str, notes: &mut Notes) -> Option<[f64; 2]> {
    let mut limit = |key: &str, whole: f64| {
        let Some(given) = node.entry(key) else {
            return Some(whole);
        };
        let position = given.text().and_then(number);
        let position = position.filter(|position| (0.0..=1.0).contains(position));
        if position.is_none() {
            let found = given.text().map_or("a list or a table".into(), |text| {
                number(text).map_or(format!("\"{text}\""), |number| number.to_string())
            });
            let help = "0 is the root, 1 the tip; without the key the thickness alone limits it";
            let what = format!("{key} of {of}");
            notes.wrong(given.line, [&what, &found, "a position from 0 to 1", help]);
        }
        position
    };
    let limits = [limit("start_nd_grid", 0.0), limit("end_nd_grid", 1.0)];
    Some([limits[0]?, limits[1]?])
}

/// The thickness, also by the number of plies of the thickness of the material.
fn thickness(item: &Node, of: &str, root: &Node, notes: &mut Notes) -> Option<Course> {
    let (given, plies) = (item.entry("thickness"), item.entry("n_plies"));
    let material = item.entry("material").and_then(Node::text).unwrap_or("");
    match (given, plies, ply_thickness(item, root)) {
        (Some(node), Some(plies), Some(ply)) => {
            let thickness = measure(node, ("thickness", of), notes);
            let plies = measure(plies, ("n_plies", of), notes);
            let (thickness, plies) = (thickness?, plies?);
            compare(
                item.line,
                of,
                [&thickness, &plies.map(|_, n| n * ply)],
                notes,
            );
            Some(thickness)
        }
        (None, Some(plies), Some(ply)) => {
            let plies = measure(plies, ("n_plies", of), notes)?;
            Some(plies.map(|_, value| ply * value))
        }
        (None, Some(plies), None) => {
            let found = format!("a number of plies of \"{material}\", which has no ply_t");
            let help = "give ply_t of the material, or the thickness of the layer";
            notes.wrong(
                plies.line,
                [&format!("thickness of {of}"), &found, "a thickness", help],
            );
            None
        }
        _ => {
            let node = required(item, of, "thickness", notes)?;
            measure(node, ("thickness", of), notes)
        }
    }
}

/// The thickness of a ply of the material of a layer, if it is given.
fn ply_thickness(item: &Node, root: &Node) -> Option<f64> {
    let material = super::named(root, item.entry("material")?.text()?)?;
    material.entry("ply_t")?.text().and_then(number)
}

/// A remark on numbers of plies beside a thickness that cannot be compared with it.
fn remark_on_plies(layers: &[(&str, &Node)], root: &Node, notes: &mut Notes) {
    let is_idle = |(_, item): &&(&str, &Node)| {
        let has = |key: &str| item.entry(key).is_some();
        has("thickness") && has("n_plies") && ply_thickness(item, root).is_none()
    };
    let idle: Vec<&(&str, &Node)> = layers.iter().filter(is_idle).collect();
    if let Some((_, first)) = idle.first() {
        let names: Vec<&str> = idle.iter().map(|layer| layer.0).collect();
        notes.remarks.push(format!(
            "line {}: n_plies has no effect beside thickness where the material has no ply_t: {}",
            first.line,
            quoted(&names)
        ));
    }
}

/// Remarks on a thickness that is not the one of the number of plies.
fn compare(line: usize, of: &str, [given, by_plies]: [&Course; 2], notes: &mut Notes) {
    let difference = given.plus(by_plies, -1.0);
    let is_other = |(eta, difference): &(f64, f64)| {
        difference.abs() > SAME_THICKNESS * given.at(*eta).max(by_plies.at(*eta))
    };
    let worst = difference
        .points()
        .filter(is_other)
        .max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
    if let Some((eta, _)) = worst {
        let [given, by_plies] = [given, by_plies].map(|course| 1e3 * course.at(eta));
        notes.remarks.push(format!(
            "line {line}: the thickness of {of} is used, {given:.4} mm at {eta}; n_plies times \
             ply_t of the material is {by_plies:.4} mm"
        ));
    }
}

/// A thickness or a number of plies along the span.
fn measure(node: &Node, (key, of): (&str, &str), notes: &mut Notes) -> Option<Course> {
    let is_list = |node: &Node| matches!(&node.value, Value::List(_));
    let is_plane = node
        .entry("values")
        .is_some_and(|values| match &values.value {
            Value::List(list) => list.first().is_some_and(|item| is_list(item)),
            _ => false,
        });
    let what = format!("{key} of {of}");
    if is_plane {
        let found = "a table along the span and the arc";
        let help = "split the layer into layers of one thickness each";
        notes.wrong(node.line, [&what, found, "a table along the span", help]);
        return None;
    }
    let read = course(node, &what, notes)?;
    let is_negative = |value: f64| value < -ROUND_OFF;
    if let Some((eta, value)) = read.points().find(|(_, value)| is_negative(*value)) {
        let found = format!("{value} at {eta}");
        notes.wrong(
            node.line,
            [&what, &found, "0 or more", "0 where the layer is absent"],
        );
        return None;
    }
    if let Some((eta, value)) = read.points().find(|(_, value)| *value < 0.0) {
        let line = node.line;
        let text = format!("line {line}: {what} is {value:e} at {eta}: 0 is taken");
        notes.remarks.push(text);
    }
    Some(read.map(|_, value| value.max(0.0)))
}

/// The angle of the fibers, toward the leading edge \[rad\].
fn fiber_angle(item: &Node, of: &str, version: Version, notes: &mut Notes) -> Option<Course> {
    let Some(node) = item.entry("fiber_orientation") else {
        return Some(Course::constant(0.0));
    };
    let what = format!("fiber_orientation of {of}");
    let read = course(node, &what, notes)?;
    let at = (what.as_str(), node.line);
    angles::check(version, at, read.points(), Angle::Small, notes)?;
    let first = read.at(0.0);
    let is_one = read
        .points()
        .all(|(_, angle)| (angle - first).abs() <= SAME);
    Some(match is_one {
        true => Course::constant(version.angle() * first),
        false => read.map(|_, angle| version.angle() * angle),
    })
}

/// A web without its plies; it is absent outside of the tables of its places.
fn web<'n>(node: &'n Node, places: &Places<'n>, notes: &mut Notes) -> Option<WrittenWeb> {
    let name = word(node, "a web", "name", notes)?;
    let what = format!("web \"{name}\"");
    let pair = places.of(Holder::Web, node, &what, notes)?;
    let mut range = [0.0_f64, 1.0];
    for place in &pair {
        if let [first, .., last] = place.positions() {
            range = [range[0].max(*first), range[1].min(*last)];
        }
    }
    let limits = limits(node, &what, notes)?;
    range = [range[0].max(limits[0]), range[1].min(limits[1])];
    if range[0] >= range[1] {
        let found = format!("from {} to {}", range[0], range[1]);
        let help = "compare the grids of its places";
        notes.wrong(node.line, [&what, &found, "a range along the span", help]);
        return None;
    }
    full_height(node, &what, notes)?;
    Some(WrittenWeb {
        name: name.to_owned(),
        places: pair,
        range,
        plies: Vec::new(),
        line: node.line,
    })
}

/// Refuses places along a web that are not its whole height.
fn full_height(node: &Node, of: &str, notes: &mut Notes) -> Option<()> {
    let Some(anchors) = node.entry("anchors") else {
        return Some(());
    };
    for anchor in items(anchors, &format!("anchors of {of}"), notes)? {
        for (key, end) in [("start_nd_arc", 0.0), ("end_nd_arc", 1.0)] {
            let Some(at) = anchor.entry(key) else {
                continue;
            };
            let what = format!("{key} of an anchor of {of}");
            let read = course(at, &what, notes)?;
            if let Some((eta, part)) = read.points().find(|(_, part)| (part - end).abs() > SAME) {
                let found = format!("{part} at {eta}");
                let help = "plies of webs have the whole height of the web";
                notes.wrong(at.line, [&what, &found, &end.to_string(), help]);
                return None;
            }
        }
    }
    Some(())
}

/// Bond lines of the flanges of a web, which are the innermost layers of the shell.
fn bond_lines<'n>(
    web: &'n Node,
    places: &Places<'n>,
    (layers, used): (&mut Vec<WrittenLayer>, &mut Vec<Used>),
    notes: &mut Notes,
) -> Option<()> {
    let Some(flanges) = web.entry("flanges") else {
        return Some(());
    };
    let name = web.entry("name").and_then(Node::text).unwrap_or_default();
    let of = format!("a flange of web \"{name}\"");
    for (index, flange) in items(flanges, &of, notes)?.into_iter().enumerate() {
        let bond = required(flange, &of, "bondline", notes)?;
        Used::note(used, bond, &of);
        let material = word(bond, &of, "material", notes);
        let thickness = required(bond, &of, "thickness", notes)
            .and_then(|at| course(at, &format!("bond line of {of}"), notes));
        let arcs = places.of(Holder::Layer, flange, &of, notes)?;
        let named = (format!("{name}_bond_{}", index + 1), material?.to_owned());
        layers.push(WrittenLayer::plain(named, thickness?, arcs, flange.line));
    }
    Some(())
}

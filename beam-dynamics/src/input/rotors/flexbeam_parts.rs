//! The tables of bearingless blades: flexbeam, torque tube and snubber.

use std::f64::consts::TAU;

use nalgebra::Vector3;
use shared_geom::document::{Key, Table};

use super::damper_law::DamperLaw;
use super::flexbeam::{Bearingless, Line, Snubber, SnubberLaw, Tube};
use super::flexbeam_keys::{
    FLEXBEAM, SNUBBER, SNUBBER_DAMPING, SNUBBER_FREQUENCY, SNUBBER_LOSS, SNUBBER_OFFSET,
    SNUBBER_REST, SNUBBER_STIFFNESS, SNUBBER_TO, TORQUE_TUBE, TUBE_CENTER, TUBE_LINE, TUBE_MASS,
    TUBE_OFFSET,
};
use super::parts::passed_on;
use super::problem::RotorProblem;
use crate::input::blades::{ELEMENTS, FLEXBEAM as FLEXBEAM_TABLE, LENGTH, OFFSET};
use crate::input::moments::{INERTIA, moments};

/// Reads the tables of a bearingless rotor called `name`, whose blades begin at the radius `root`
/// \[m\]; `Some(None)` without flexbeam.
pub(super) fn read(table: &Table<'_>, name: &str, root: f64) -> Option<Option<Bearingless>> {
    let beam = flexbeam(table, root);
    let inner = beam.as_ref().and_then(|beam| beam.as_ref());
    let inner = inner.map_or(0.0, |beam| beam.offset);
    let tube = tube(table, name, [inner, root]);
    let inner = tube.as_ref().map_or(inner, Tube::offset);
    let line = beam.as_ref().and_then(Option::as_ref);
    let snubber = table.nested(&SNUBBER, |table| {
        snubber(table, (name, line), [inner, root])
    });
    let (beam, tube, snubber) = (beam?, tube?, snubber?);
    Some(beam.map(|beam| Bearingless {
        beam,
        tube,
        snubber,
    }))
}

/// A problem of an offset \[m\] of a part that is not between two others, if it has one.
fn beyond(part: &str, found: f64, [from, to]: [f64; 2]) -> Option<RotorProblem> {
    let is_between = (from..=to * (1.0 + ROUNDING)).contains(&found);
    (!is_between).then(|| RotorProblem::HingeOrder {
        hinge: part.to_owned(),
        found,
        from,
        to,
    })
}

/// Relative error of sums of lengths: digits lost in the input.
const ROUNDING: f64 = 1e-9;

fn flexbeam(table: &Table<'_>, root: f64) -> Option<Option<Line>> {
    if !table.has(&FLEXBEAM) {
        return Some(None);
    }
    let table = table.table(&FLEXBEAM)?;
    let offset = table.get(&OFFSET);
    let mut keys = passed_on(&table, &FLEXBEAM_TABLE);
    keys.retain(|(key, _)| key != OFFSET.name());
    let offset = offset?;
    let words = ["the flexbeam", "the outer end of the flexbeam"];
    let nodes = nodes(&table, words, [offset, root])?;
    Some(Some(Line {
        offset,
        nodes,
        keys,
    }))
}

/// The distances from the center of the nodes of a line of beams \[m\], which is between the hub and the
/// root of the blade; notes one that is not. A file has none, since its length is not known here.
fn nodes(table: &Table<'_>, [part, end]: [&str; 2], [offset, root]: [f64; 2]) -> Option<Vec<f64>> {
    let pieces = if table.is_list("piece") {
        table.tables("piece")
    } else {
        Vec::new()
    };
    let mut nodes = Vec::new();
    let mut outer = offset;
    for piece in &pieces {
        let (length, elements) = (piece.get(&LENGTH), piece.get(&ELEMENTS));
        let (length, steps) = (length?, 2 * elements?);
        let first = usize::from(!nodes.is_empty());
        nodes.extend((first..=steps).map(|step| outer + length * step as f64 / steps as f64));
        outer += length;
    }
    let problem = beyond(part, offset, [0.0, root]).map(|problem| (OFFSET.name(), problem));
    let at_end = || Some(("piece", beyond(end, outer, [offset, root])?));
    if let Some((key, problem)) = problem.or_else(at_end) {
        table.note(key, &problem);
        return None;
    }
    Some(nodes)
}

fn tube(table: &Table<'_>, name: &str, [inner, root]: [f64; 2]) -> Option<Tube> {
    if !table.has(&TORQUE_TUBE) {
        return Some(Tube::Rigid(inner, None));
    }
    let table = table.table(&TORQUE_TUBE)?;
    let offset = table.get(&TUBE_OFFSET)?.unwrap_or(inner);
    let words = ["the torque tube", "the outer end of the torque tube"];
    if table.has("piece") || table.has("file") {
        let keys = passed_on(&table, &TUBE_LINE);
        let nodes = nodes(&table, words, [offset, root])?;
        return Some(Tube::Elastic(Line {
            offset,
            nodes,
            keys,
        }));
    }
    let (mass, center) = (table.get(&TUBE_MASS), table.get(&TUBE_CENTER));
    let inertia = moments(&table, name);
    table.finish();
    let (mass, center, inertia) = (mass?, center?, inertia?);
    nodes(&table, words, [offset, root])?;
    if mass.is_none() && (center.is_some() || inertia.amax() > 0.0) {
        let key = center.map_or(INERTIA.name(), |_| TUBE_CENTER.name());
        let (name, needed) = (name.to_owned(), "mass of [rotor.torque_tube]");
        table.note(key, &RotorProblem::Idle { name, key, needed });
        return None;
    }
    let center = center.unwrap_or(0.5 * (offset + root));
    Some(Tube::Rigid(
        offset,
        mass.map(|mass| (center, (mass, inertia))),
    ))
}

fn snubber(
    table: &Table<'_>,
    (name, line): (&str, Option<&Line>),
    [inner, root]: [f64; 2],
) -> Option<Snubber> {
    let (offset, to) = (table.get(&SNUBBER_OFFSET), table.get(&SNUBBER_TO));
    let all = |key: &Key<Option<Vector3<f64>>>| {
        let found = table.get(key)?;
        let is_sound = found.is_none_or(|found| found.min() >= 0.0);
        if !is_sound {
            table.wrong(key, "three numbers, zero or more");
        }
        is_sound.then_some(found)
    };
    let (stiffness, damping) = (all(&SNUBBER_STIFFNESS), all(&SNUBBER_DAMPING));
    let elastomer = elastomer(table, name, &all);
    let (stiffness, damping, elastomer) = (stiffness?, damping?, elastomer?);
    let offset = offset?.unwrap_or(inner);
    if let Some(problem) = beyond("the snubber", offset, [0.0, root]) {
        table.note(&SNUBBER_OFFSET, &problem);
        return None;
    }
    let law = match elastomer {
        Some(law) => Some(law),
        None => (stiffness.is_some() || damping.is_some()).then(|| {
            let [stiffness, damping] = [stiffness, damping].map(Option::unwrap_or_default);
            SnubberLaw::Linear([stiffness, damping])
        }),
    };
    let holder = match (to? == 1, line) {
        (true, Some(line)) => Some(holder(table, line, offset)?),
        _ => None,
    };
    Some(Snubber {
        offset,
        holder,
        law,
    })
}

/// Three numbers under a key, if it is given; `None` if they are wrong.
type Three<'a> = &'a dyn Fn(&Key<Option<Vector3<f64>>>) -> Option<Option<Vector3<f64>>>;

/// The elastomer of a snubber; `Some(None)` without its keys.
fn elastomer(table: &Table<'_>, name: &str, all: Three<'_>) -> Option<Option<SnubberLaw>> {
    let (loss, frequency) = (table.get(&SNUBBER_LOSS), table.get(&SNUBBER_FREQUENCY));
    let rest = all(&SNUBBER_REST);
    let (loss, frequency, rest) = (loss?, frequency?, rest?);
    if loss.is_none() && frequency.is_none() && rest.is_none() {
        return Some(None);
    }
    let stiffness = all(&SNUBBER_STIFFNESS)?;
    let keys = [
        (SNUBBER_STIFFNESS.name(), stiffness.is_some()),
        (SNUBBER_LOSS.name(), loss.is_some()),
        (SNUBBER_FREQUENCY.name(), frequency.is_some()),
    ];
    if let Some((needed, _)) = keys.iter().find(|(_, is_given)| !is_given) {
        let given = keys.iter().rev().find(|(_, is_given)| *is_given);
        let key = given.map_or(SNUBBER_REST.name(), |(key, _)| *key);
        let name = name.to_owned();
        table.note(key, &RotorProblem::Idle { name, key, needed });
        return None;
    }
    if table.has(&SNUBBER_DAMPING) {
        let (key, other) = (SNUBBER_DAMPING.name(), SNUBBER_LOSS.name());
        let name = name.to_owned();
        table.note(key, &RotorProblem::Both { name, key, other });
        return None;
    }
    let (stiffness, loss, frequency) = (stiffness?, loss?, frequency? * TAU);
    let Some(rest) = rest else {
        let damping = stiffness * (loss / frequency);
        return Some(Some(SnubberLaw::Linear([stiffness, damping])));
    };
    let is_below = |i: &usize| rest[*i] < stiffness[*i] || rest[*i] == 0.0 && stiffness[*i] == 0.0;
    if !(0..3).all(|i| is_below(&i)) {
        table.wrong(&SNUBBER_REST, "numbers less than \"stiffness\"");
        return None;
    }
    let laws = [0, 1, 2].map(|i| {
        let law = || DamperLaw::elastomer([stiffness[i], loss], frequency, Some(rest[i]));
        (stiffness[i] > 0.0).then(law)
    });
    Some(Some(SnubberLaw::Relaxing(laws)))
}

/// The node of a flexbeam that holds a snubber; notes it if there is none.
fn holder(table: &Table<'_>, line: &Line, offset: f64) -> Option<String> {
    // the outer end is one piece with a rigid tube
    let found = line.node_at(offset).filter(|node| node != "tip");
    if found.is_none() {
        let mut nodes = line.nodes.clone();
        nodes.pop();
        nodes.sort_by(|a, b| (a - offset).abs().total_cmp(&(b - offset).abs()));
        let nearest = nodes.first().copied();
        table.note(&SNUBBER_TO, &RotorProblem::NoHolder { offset, nearest });
    }
    found
}

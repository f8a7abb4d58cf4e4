//! The blades of a rotor, and the hinges between each and the yoke.

use nalgebra::Vector3;
use shared_geom::document::{Card, Content};
use std::f64::consts::{FRAC_PI_2, PI};

use super::base::{Base, FLAP, Hinge, LAG, Local, PITCH};
use super::controls::Sum;
use super::damper;
use super::keys::KINDS;
use super::pitch;
use super::stops;

/// Rotation vectors that turn the first axis of a blade to the axis of each kind of hinges, or to its mirror image.
const TURNS: [[Vector3<f64>; 2]; 3] = [
    [
        Vector3::new(0.0, 0.0, -FRAC_PI_2),
        Vector3::new(0.0, 0.0, FRAC_PI_2),
    ],
    [Vector3::new(0.0, -FRAC_PI_2, 0.0); 2],
    [Vector3::new(0.0, 0.0, 0.0), Vector3::new(0.0, 0.0, PI)],
];

/// Name of hinge `number` of a blade: by its kind, and its number if another has the kind.
fn word(hinges: &[Hinge], number: usize) -> String {
    let kind = hinges[number].kind;
    let before = hinges[..number]
        .iter()
        .filter(|other| other.kind == kind)
        .count();
    match before {
        0 => KINDS[kind].to_owned(),
        _ => format!("{} {}", KINDS[kind], before + 1),
    }
}

/// The node of the blade that turns with its pitch, of blade `k`; `None` without a bearing.
pub(super) fn feathering(base: &Base, k: usize) -> Option<(String, f64)> {
    let number = base.hinges.iter().position(|hinge| hinge.kind == PITCH)?;
    let node = base.of_blade(k, &word(&base.hinges, number));
    Some((node, base.hinges[number].offset))
}

/// The frame of blade `k`, the nodes of its hinges and the hinges, from the yoke to the root.
pub(super) fn cards(
    base: &Base,
    (k, yoke): (usize, &str),
    (control, command): (&pitch::Control, &Sum),
) -> Vec<Card> {
    let mut arm = base.arm(k);
    let mut cards = vec![base.frame(&arm)];
    let mut inner = yoke.to_owned();
    let mut flaps = Vec::new();
    for (number, hinge) in base.hinges.iter().enumerate() {
        let node = base.of_blade(k, &word(&base.hinges, number));
        if hinge.kind == PITCH && base.pitch != 0.0 && !arm.is_pitched {
            // This hinge and the ones outboard of it are turned with the blade.
            arm = base.pitched(k);
            cards.push(base.frame(&arm));
        }
        cards.push(base.node(&node, &arm, Vector3::new(hinge.offset, 0.0, 0.0)));
        let nodes = [inner.as_str(), &node];
        cards.extend(match hinge.kind {
            PITCH => pitch::cards(base, (k, nodes), (hinge, &flaps), (control, command)),
            kind => {
                let axis = base.axis(kind);
                vec![base.hinge(&node, nodes, (&arm, axis), &hinge.restraint)]
            }
        });
        cards.extend(restraints(base, (&node, nodes), &arm, hinge));
        if hinge.kind == FLAP {
            flaps.push([inner, node.clone()]);
        }
        inner = node;
    }
    let root = base.of_blade(k, "root");
    cards.push(
        base.listed("rigid")
            .with("name", base.of_blade(k, "root attachment"))
            .with("nodes", Content::texts([inner.as_str(), &root])),
    );
    cards
}

fn restraints(
    base: &Base,
    (name, nodes): (&str, [&str; 2]),
    arm: &Local,
    hinge: &Hinge,
) -> Vec<Card> {
    let turn = TURNS[hinge.kind][usize::from(base.mirror)];
    let (of, axes) = ((name, nodes), (arm, turn));
    let stop = stops::cards(base, of, axes, hinge);
    let damper = hinge.damper.iter();
    let damper = damper.flat_map(|law| damper::of_hinge(base, of, axes, law));
    stop.into_iter().chain(damper).collect()
}

/// The node outboard of the first lag hinge of blade `k`; `None` without one.
pub(super) fn lagging(base: &Base, k: usize) -> Option<String> {
    let number = base.hinges.iter().position(|hinge| hinge.kind == LAG)?;
    Some(base.of_blade(k, &word(&base.hinges, number)))
}

/// The frame of the blades, if the hub is underslung, and their card.
pub(super) fn blades(base: &Base, keys: &[(String, Content)]) -> Vec<Card> {
    let frame = base.frame_of_blades();
    let mut cards = Vec::new();
    if frame != base.name {
        let below = base.placed(&(Vector3::z() * -base.undersling));
        cards.push(
            base.listed("frame")
                .with("name", frame.as_str())
                .with("in", base.name.as_str())
                .with("position", super::base::lengths(&below)),
        );
    }
    cards.push(line(base, &base.name, keys));
    cards
}

/// A card of lines of beams along all blades.
pub(super) fn line(base: &Base, name: &str, keys: &[(String, Content)]) -> Card {
    let card = base
        .listed("blade")
        .with("name", name)
        .with("in", base.frame_of_blades())
        .with("azimuth", Content::quantity(base.azimuth, "rad"))
        .with("count", base.count)
        .with("clamp_root", false)
        .with_some("mirror", base.mirror.then_some(true))
        .with_all(keys.iter().cloned());
    let spin = base
        .spin
        .map(|spin| Content::quantities([0.0, 0.0, spin], "rad/s"));
    card.with_some("angular_velocity", spin)
}

//! Hinges between the hub and the root of a blade.
//!
//! From the hub outward; a hinge turns all parts outboard of it. In the axes A of the mount
//! (x out, y in the direction of motion, z up):
//!
//! ```text
//! flap  about -y, positive up        lag  about z, positive forward        pitch  about x, nose up
//! ```
//!
//! The pitch of the blade is the angle of its pitch hinge: hinges listed after it are
//! turned with the blade. Between two hinges there is a node without mass, at any distance;
//! the hinges are attached to it, and the last one to the root of the blade, by rigid
//! offsets.

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Quantity, Word};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::mounts::BladeMount;
use super::problem::BladeProblem;
use crate::input::builder::ModelBuilder;
use crate::input::drives::Catalog;
use crate::input::hinge_card::HingeCard;
use crate::input::joints::{ANGLE, DAMPING, STIFFNESS, spring};
use crate::model::Node;

keys! {
    /// A hinge between hub and root.
    pub(super) CARD = "hinges = [{ ... }]";
    /// Motion: flap, positive up; lag, positive forward; pitch, positive nose up.
    KIND: usize = "kind", [Word(&Kind::WORDS)], required, "\"flap\"";
    /// Distance from the center of the hub along the blade; without it the offset of the previous
    /// hinge, or of the root.
    OFFSET: Option<f64> = "offset", [Quantity(Dimension::LENGTH)], optional, "0.5";
    with STIFFNESS.schema, DAMPING.schema, ANGLE.schema;
}

/// Motion of the blade that a hinge allows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Flap,
    Lag,
    Pitch,
}

impl Kind {
    const ALL: [Self; 3] = [Self::Flap, Self::Lag, Self::Pitch];
    const WORDS: [&str; 3] = ["flap", "lag", "pitch"];

    fn word(self) -> &'static str {
        Self::WORDS[self as usize]
    }

    /// Axis of a positive angle in the axes of the blade.
    fn axis(self) -> Vector3<f64> {
        match self {
            Self::Flap => -Vector3::y(),
            Self::Lag => Vector3::z(),
            Self::Pitch => Vector3::x(),
        }
    }
}

/// A hinge as its table defines it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct BladeHinge {
    kind: Kind,
    /// Distance from the center of rotation along the span; `None` for the offset of the hinge
    /// before, or the root \[m\].
    offset: Option<f64>,
    card: HingeCard,
}

/// Reads `hinges` of a card; `None` when one is wrong.
pub(super) fn read(table: &Table<'_>, drives: &Catalog) -> Option<Vec<BladeHinge>> {
    table.each(&super::HINGES, |table| hinge(table, drives))
}

fn hinge(table: &Table<'_>, drives: &Catalog) -> Option<BladeHinge> {
    let (kind, offset) = (table.get(&KIND), table.get(&OFFSET));
    let card = spring(table, drives);
    Some(BladeHinge {
        kind: Kind::ALL[kind?],
        offset: offset?,
        card: card?,
    })
}

/// Offsets of all hinges of a blade whose root is at `root` \[m\]; notes offsets that do
/// not increase outward.
pub(super) fn offsets(table: &Table<'_>, hinges: &[BladeHinge], root: f64) -> Option<Vec<f64>> {
    let mut found = Vec::with_capacity(hinges.len());
    for (number, hinge) in hinges.iter().enumerate() {
        let before = found.last().copied();
        let offset = hinge.offset.or(before).unwrap_or(root);
        let words = || format!("hinge {} ({})", number + 1, hinge.kind.word());
        let problem = match before {
            Some(before) if offset < before => BladeProblem::HingesInward {
                hinge: words(),
                found: offset,
                before,
            },
            _ if offset > root => BladeProblem::HingeBeyondRoot {
                hinge: words(),
                found: offset,
                root,
            },
            _ if hinges[..number]
                .iter()
                .zip(&found)
                .any(|(inner, position)| is_same_motion((inner, *position), (hinge, offset))) =>
            {
                BladeProblem::HingesAlike { hinge: words() }
            }
            _ => {
                found.push(offset);
                continue;
            }
        };
        table.note("hinges", &problem);
        return None;
    }
    Some(found)
}

/// Whether two hinges without springs allow the same motion.
fn is_same_motion((inner, at): (&BladeHinge, f64), (outer, offset): (&BladeHinge, f64)) -> bool {
    let is_one_axis = inner.kind == outer.kind && (at == offset || inner.kind == Kind::Pitch);
    let are_free = [inner, outer].map(|hinge| hinge.card.spring.stiffness == 0.0);
    is_one_axis && are_free == [true, true]
}

/// Adds the hinges of a blade, at their offsets, between the hub and node number `root`.
pub(super) fn add(
    (hinges, offsets): (&[BladeHinge], &[f64]),
    mount: &BladeMount,
    root: usize,
    table: &Table<'_>,
    builder: &mut ModelBuilder,
) {
    let node = |builder: &mut ModelBuilder, end: &str, offset: f64, axes: &Matrix3<f64>| {
        let node = Node {
            label: format!("{}/{end}", mount.name),
            position: mount.at_radius(offset),
            rotation: *axes,
        };
        builder.add_node(node, table, Some(mount.axes))
    };
    let (mut axes, mut inner) = (mount.axes, builder.hub_node());
    if inner.is_none() {
        inner = node(
            builder,
            "hub",
            offsets.first().copied().unwrap_or(mount.radius),
            &axes,
        );
        if let Some(held) = inner {
            builder.add_clamp(held, table, "hinges");
        }
    }
    for (number, (hinge, &offset)) in hinges.iter().zip(offsets).enumerate() {
        let axis = axes * hinge.kind.axis();
        if hinge.kind == Kind::Pitch {
            axes = mount.blade_axes();
        }
        let outer = if number + 1 == hinges.len() {
            Some(root)
        } else {
            node(builder, &format!("hinge {}", number + 1), offset, &axes)
        };
        let (Some(from), Some(to)) = (inner, outer) else {
            return builder.note_loose_end();
        };
        let label = label(mount, hinges, number);
        builder.add_hinge(
            &label,
            [from, to],
            (mount.at_radius(offset), axis),
            &hinge.card,
        );
        inner = outer;
    }
}

/// Name of a hinge: by its kind, and its position in the list if another is of that kind.
fn label(mount: &BladeMount, hinges: &[BladeHinge], number: usize) -> String {
    let kind = hinges[number].kind;
    let same = hinges.iter().filter(|hinge| hinge.kind == kind).count();
    match same {
        1 => format!("{}/{} hinge", mount.name, kind.word()),
        _ => format!("{}/{} hinge {}", mount.name, kind.word(), number + 1),
    }
}

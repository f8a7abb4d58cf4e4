//! A hub that moves: its mass, and the springs and dampers that carry it.
//!
//! The support stands in the world and is the same in all directions about the axis, so
//! that it is constant in the turning frame too.

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::Table;
use shared_geom::units::Dimension;

use super::bodies;
use super::draft::Draft;
use super::number::not_negative;
use super::problem::InputProblem;
use crate::elements::bodies::RigidInertia;
use crate::elements::joints::partly_clamped;
use crate::elements::springs::{Stand, SupportLaw, SupportSpring};
use crate::model::Node;

/// Name of the node of a hub that moves.
const HUB: &str = "hub";
/// Directions of a support: across the axis, along it, about the diameters, about it.
const DIRECTIONS: [&str; 4] = ["in_plane", "axial", "tilt", "torsion"];
/// Direction of each component in the axes of the hub, of which z is the axis.
const COMPONENTS: [usize; 6] = [0, 0, 1, 2, 2, 3];

/// Mass and support of a hub.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct MovingHub {
    inertia: RigidInertia,
    /// Stiffness in each direction; `None` where the hub is held \[N/m, N m\].
    stiffness: [Option<f64>; 4],
    /// Damping in each direction \[N s/m, N m s\].
    damping: [f64; 4],
}

impl MovingHub {
    /// What `[hub]` says of its support: `None` when that is wrong, `Some(None)` when the
    /// frame holds the hub.
    pub fn read(table: &Table<'_>) -> Option<Option<Self>> {
        if !table.has("support") {
            let useless = ["mass", "inertia", "support_damping"];
            let useless: Vec<_> = useless.into_iter().filter(|key| table.has(key)).collect();
            for key in &useless {
                table.note(key, &InputProblem::HeldHub { key });
            }
            return useless.is_empty().then_some(None);
        }
        let mass = match table.has("mass") {
            true => not_negative(table, "mass", Dimension::MASS),
            false => Some(0.0),
        };
        let moments = bodies::moments(table, HUB);
        let stiffness = [Dimension::SPRING_STIFFNESS, Dimension::MOMENT];
        let stiffness = directions(table, "support", stiffness);
        let damping = [Dimension::DAMPER, Dimension::TURNING_DAMPER];
        let damping = directions(table, "support_damping", damping);
        let (stiffness, damping) = (stiffness?, damping?);
        let held = (0..4).find(|&i| damping[i].is_some() && stiffness[i].is_none());
        if let Some(i) = held {
            let direction = DIRECTIONS[i];
            table.note("support_damping", &InputProblem::DampedClamp { direction });
            return None;
        }
        let central = Matrix3::from_diagonal(&moments?);
        Some(Some(Self {
            inertia: RigidInertia::about_node(mass?, &Vector3::zeros(), &central),
            stiffness,
            damping: damping.map(|damping| damping.unwrap_or(0.0)),
        }))
    }
}

/// A number for each direction in the table under `key`.
fn directions(table: &Table<'_>, key: &str, of: [Dimension; 2]) -> Option<[Option<f64>; 4]> {
    if !table.has(key) {
        return Some([None; 4]);
    }
    let table = table.table(key)?;
    let read: Vec<_> = (0..4)
        .map(|i| match table.has(DIRECTIONS[i]) {
            true => not_negative(&table, DIRECTIONS[i], of[i / 2]).map(Some),
            false => Some(None),
        })
        .collect();
    table.finish();
    let read: Option<Vec<_>> = read.into_iter().collect();
    read?.try_into().ok()
}

/// Adds the node, the mass and the support of a hub that moves.
pub(super) fn add(root: &Table<'_>, draft: &mut Draft) {
    let Some(hub) = draft.hub().copied() else {
        return;
    };
    let (Some(moving), Some(table)) = (hub.moving(), root.table("hub")) else {
        return;
    };
    let node = Node {
        label: HUB.to_owned(),
        position: hub.spin().center,
        rotation: hub.axes(),
    };
    let Some(index) = draft.add_node(node.clone(), &table, Some(hub.axes())) else {
        return;
    };
    draft.set_hub_node(index);
    if moving.inertia != RigidInertia::zero() {
        draft.add_body(HUB.to_owned(), index, moving.inertia);
    }
    let held = COMPONENTS.map(|direction| moving.stiffness[direction].is_none());
    if held.contains(&true) {
        let bearing = partly_clamped("bearing of the hub", index, &node, &node.rotation, held);
        draft.add_joint(Box::new(bearing));
    }
    let stiffness = COMPONENTS.map(|direction| moving.stiffness[direction].unwrap_or(0.0));
    let damping = COMPONENTS.map(|direction| moving.damping[direction]);
    let law = SupportLaw::along(&node.rotation, &stiffness, &damping);
    let support = SupportSpring::new("support of the hub", index, &node, law, Stand::World);
    draft.add_joint(Box::new(support));
}

//! A hub that moves in the model: its node, its mass, and the springs and dampers that
//! support it.
//!
//! The support is fixed in the ground frame and isotropic about the axis, so that it is
//! constant in the turning frame too.

use shared_geom::document::Table;

use super::builder::ModelBuilder;
use super::hub::HUB;
use crate::elements::bodies::RigidInertia;
use crate::elements::joints::partly_clamped;
use crate::elements::springs::{SupportFrame, SupportLaw, SupportSpring};
use crate::model::Node;

/// Direction of each component in the axes of the hub, of which z is the axis.
const COMPONENTS: [usize; 6] = [0, 0, 1, 2, 2, 3];

/// Adds the node, the mass and the support of a hub that moves.
pub(super) fn add(root: &Table<'_>, builder: &mut ModelBuilder) {
    let Some(hub) = builder.hub().copied() else {
        return;
    };
    let (Some(moving), Some(table)) = (hub.moving(), root.table("hub")) else {
        return;
    };
    let node = Node {
        label: HUB.to_owned(),
        position: hub.frame_rotation().center,
        rotation: hub.axes(),
    };
    let Some(index) = builder.add_node(node.clone(), &table, Some(hub.axes())) else {
        return;
    };
    builder.set_hub_node(index);
    if moving.inertia != RigidInertia::zero() {
        builder.add_body(HUB.to_owned(), index, moving.inertia);
    }
    let held = COMPONENTS.map(|direction| moving.stiffness[direction].is_none());
    if held.contains(&true) {
        let bearing = partly_clamped("bearing of the hub", index, &node, &node.rotation, held);
        builder.add_joint(Box::new(bearing));
    }
    let stiffness = COMPONENTS.map(|direction| moving.stiffness[direction].unwrap_or(0.0));
    let damping = COMPONENTS.map(|direction| moving.damping[direction]);
    let law = SupportLaw::along(&node.rotation, &stiffness, &damping);
    let support = SupportSpring::new("support of the hub", index, &node, law, SupportFrame::World);
    builder.add_joint(Box::new(support));
}

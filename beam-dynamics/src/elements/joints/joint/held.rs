//! A joint in which what is driven by its velocity is held in its place.

use super::ConstraintJoint;
use crate::elements::Level;
use crate::elements::joints::algebra::{Held, Row};
use crate::elements::joints::kinds::about;
use crate::model::{Drive, Loading, NodeMotion, Scalars};

impl ConstraintJoint {
    /// The joint with constraints of places and attitudes, those at the state `nodes`, in the
    /// place of those of velocities; `None` when it has none of these.
    pub(super) fn without_velocities(&self, nodes: &[NodeMotion]) -> Option<Self> {
        if self.rows.iter().all(|row| row.level() == Level::Position) {
            return None;
        }
        let seen = self.seen(nodes, &Loading::none(), Scalars::NONE);
        let held = self.rows.iter().map(|row| match row.held {
            Held::Velocity(carrier, axis) => {
                let held = Held::Along(carrier, axis);
                let now = Row::zero(held).at(&seen).form.value(&seen.ends);
                Row::driven(held, Drive::Constant(now))
            }
            Held::Spin(_, axis) => {
                let held = about(axis);
                let now = Row::zero(held).at(&seen).form.value(&seen.ends);
                Row::driven(held, Drive::Constant(now))
            }
            _ => row.clone(),
        });
        Some(Self {
            rows: held.collect(),
            ..self.clone()
        })
    }
}

//! A joint whose driven velocities are replaced by held positions.

use super::ConstraintJoint;
use crate::elements::Level;
use crate::elements::joints::algebra::{Held, Row};
use crate::elements::joints::kinds::about;
use crate::model::{Drive, Loading, NodeMotion, Scalars};

impl ConstraintJoint {
    /// The joint with constraints of positions and attitudes, held at the state `nodes`, instead of
    /// its constraints of velocities; `None` if it has no constraint of velocities.
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
            Held::AngularVelocity(_, axis) => {
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

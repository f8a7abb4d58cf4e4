//! The mount of the shaft of a rotor: a tower with a nacelle, or a wing with a pylon that turns.
//!
//! Each kind has its keys, its reader and its cards in a file of its own. It determines the center and
//! the axis of the rotor, and the node that carries the shaft.

use shared_geom::document::{Card, Table};

use super::base::Base;
use super::context::Context;
use super::keys::{AFT, AXIS, CENTER};
use super::problem::RotorProblem;

mod column;
mod hub_frame;
pub(super) mod keys;
mod pylon;
mod turbine;

use hub_frame::HubFrame;
use keys::{FOOT, NACELLE, PYLON, TOWER};
use pylon::Pylon;
use turbine::Turbine;

/// The part of a model that carries a rotor.
#[derive(Debug)]
pub(super) enum Mount {
    /// A tower with a nacelle.
    Turbine(Turbine),
    /// A wing with a pylon.
    Pylon(Pylon),
}

/// Reads the tables of a rotor called `name`; `Some(None)` without any.
pub(super) fn read(table: &Table<'_>, name: &str, context: &Context) -> Option<Option<Mount>> {
    let foot = table.get(&FOOT);
    let turbine = turbine::read(table, name, (foot, context));
    let pylon = pylon::read(table, name, (foot, context));
    let (turbine, pylon, _) = (turbine?, pylon?, foot?);
    let both = |key, other| {
        let name = name.to_owned();
        table.note(key, &RotorProblem::Both { name, key, other });
    };
    let mount = match (turbine, pylon) {
        (Some(_), Some(_)) => {
            let other = if table.has(&TOWER) {
                TOWER.name()
            } else {
                NACELLE.name()
            };
            both(PYLON.name(), other);
            return None;
        }
        (Some(turbine), None) => Mount::Turbine(turbine),
        (None, Some(pylon)) => Mount::Pylon(pylon),
        (None, None) if table.has(&FOOT) => {
            let (name, key) = (name.to_owned(), FOOT.name());
            let needed = "tower\", \"nacelle\" or \"pylon";
            table.note(key, &RotorProblem::Idle { name, key, needed });
            return None;
        }
        (None, None) => return Some(None),
    };
    if table.has(&CENTER) {
        both(CENTER.name(), mount.key());
        return None;
    }
    Some(Some(mount))
}

impl Mount {
    /// The key of the part that has the shaft.
    fn key(&self) -> &'static str {
        match self {
            Self::Turbine(_) => NACELLE.name(),
            Self::Pylon(_) => PYLON.name(),
        }
    }

    /// The frame of the hub: `axis` of its card, if it is given, chooses the sense of rotation, and
    /// `aft` the direction of azimuth zero.
    pub fn hub_frame(&self, table: &Table<'_>) -> Option<HubFrame> {
        let mut frame = match self {
            Self::Turbine(turbine) => turbine.hub_frame(),
            Self::Pylon(pylon) => pylon.hub_frame(),
        };
        if table.has(&AXIS) && table.get(&AXIS)?.dot(&frame.axis) < 0.0 {
            frame.axis = -frame.axis;
        }
        if table.has(&AFT) {
            frame.aft = table.get(&AFT)?;
        }
        Some(frame)
    }

    /// The name of the node that carries the shaft of the rotor called `name`.
    pub fn node(&self, name: &str) -> String {
        format!("{name}/{}", self.key())
    }

    /// The cards, on the node `holder`, or on the frame of the model.
    pub fn cards(&self, base: &Base, holder: Option<&str>) -> Vec<Card> {
        let node = self.node(&base.name);
        match self {
            Self::Turbine(turbine) => turbine.cards(base, holder, &node),
            Self::Pylon(pylon) => pylon.cards(base, holder, &node),
        }
    }
}

//! Wing and pylon of a tiltrotor.
//!
//! ```text
//!              o hub
//!              | length              z up, x aft, the wing along y
//!   base ~~~~~(+) conversion axis
//!       wing
//! ```
//!
//! The conversion angle is zero with the shaft up, and a right angle with the shaft forward; it
//! turns the pylon about -y at the tip of the wing.

use nalgebra::Vector3;
use shared_geom::document::{Card, Table};
use shared_geom::rotation::vector;

use super::column::Column;
use super::hub_frame::{HubFrame, Turned, axes_along};
use super::keys::{CONVERSION, PYLON, PYLON_CENTER, PYLON_LENGTH, PYLON_MASS, SPAN, WING};
use crate::input::moments::{INERTIA, moments};
use crate::input::rotors::base::{Base, Lump, angles, lengths};
use crate::input::rotors::context::Context;
use crate::input::rotors::problem::RotorProblem;

/// A pylon.
#[derive(Debug)]
pub(in crate::input::rotors) struct Pylon {
    foot: Vector3<f64>,
    wing: Option<Column>,
    length: f64,
    /// Conversion angle, from the shaft up.
    conversion: Turned,
    body: Option<Lump>,
    center: f64,
}

/// Reads the table of a rotor called `name`, on a foot \[m\]; `Some(None)` without it.
pub(super) fn read(
    table: &Table<'_>,
    name: &str,
    (foot, context): (Option<Vector3<f64>>, &Context),
) -> Option<Option<Pylon>> {
    let foot = foot.unwrap_or_default();
    table.nested(&PYLON, |table| {
        let (length, center) = (table.get(&PYLON_LENGTH), table.get(&PYLON_CENTER));
        let (mass, inertia) = (table.get(&PYLON_MASS), moments(table, name));
        let conversion = Turned::read(table, &CONVERSION.schema, context);
        let wing = table.nested(&WING, |table| wing(table, foot));
        let (mass, inertia) = (mass?, inertia?);
        if mass == 0.0 && inertia.amax() > 0.0 {
            let (name, key, needed) = (name.to_owned(), INERTIA.name(), PYLON_MASS.name());
            table.note(key, &RotorProblem::Idle { name, key, needed });
            return None;
        }
        Some(Pylon {
            foot,
            wing: wing?,
            length: length?,
            conversion: conversion?,
            body: (mass > 0.0).then_some((mass, inertia)),
            center: center?,
        })
    })
}

/// A wing from a root \[m\].
fn wing(table: &Table<'_>, foot: Vector3<f64>) -> Option<Column> {
    let span = table.get(&SPAN)?;
    let forward = -Vector3::x();
    if span.cross(&forward).norm() <= 1e-9 * span.norm() {
        table.wrong(&SPAN, "a wing that is not along x");
        return None;
    }
    let axes = axes_along(&span, &forward);
    Column::read(table, "wing", (foot, axes, span.norm()))
}

impl Pylon {
    /// The point about which it turns \[m\].
    fn tip(&self) -> Vector3<f64> {
        self.wing.as_ref().map_or(self.foot, Column::end)
    }

    /// The rotation of the undeformed pylon from the shaft up.
    fn turn(&self) -> Vector3<f64> {
        Vector3::y() * -self.conversion.undeformed()
    }

    /// The frame of the hub.
    pub fn hub_frame(&self) -> HubFrame {
        let turn = vector::to_rotation(&self.turn());
        let shaft = turn * Vector3::z();
        HubFrame {
            center: self.tip() + shaft * self.length,
            axis: shaft,
            aft: turn * Vector3::x(),
        }
    }

    /// The cards; `node` is the pylon.
    pub fn cards(&self, base: &Base, holder: Option<&str>, node: &str) -> Vec<Card> {
        let (mut cards, below) =
            Column::mounted(self.wing.as_ref(), base, &base.part("wing"), holder);
        cards.push(
            base.listed("node")
                .with("name", node)
                .with("position", lengths(&self.tip()))
                .with("orientation", angles(&self.turn())),
        );
        let about = (self.tip(), Vector3::new(0.0, -1.0, 0.0));
        let joint = (node, "conversion");
        cards.push(self.conversion.card(base, joint, below.as_deref(), about));
        cards.extend(self.body.as_ref().map(|lump| {
            let center = Vector3::z() * self.center;
            base.body(node, lump).with("offset", lengths(&center))
        }));
        cards
    }
}

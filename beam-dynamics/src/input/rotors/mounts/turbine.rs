//! Tower and nacelle of a wind turbine.
//!
//! ```text
//!   overhang           yaw
//!  |<------>|           |
//!  o========[###nacelle#|##]     o hub; its shaft is raised by the tilt at the rotor
//!           `-----------+--'
//!                       | tower, height        z up, x downwind at zero yaw
//!                       |
//! ```
//!
//! The shaft points downwind, with the yaw psi about z and the tilt tau:
//!
//! ```text
//! d = Rz(psi) (cos tau, 0, -sin tau)        center = top + above z - overhang d
//! ```
//!
//! A yaw that is a drive turns the nacelle by a joint from the place without yaw.

use nalgebra::Vector3;
use shared_geom::document::{Card, Table};
use shared_geom::rotation::vector;

use super::column::Column;
use super::hub_frame::{HubFrame, Turned, axes_along};
use super::keys::{
    ABOVE, HEIGHT, NACELLE, NACELLE_CENTER, NACELLE_MASS, OVERHANG, TILT, TOWER, YAW,
};
use crate::input::moments::{INERTIA, moments};
use crate::input::rotors::base::{Base, Lump, angles, lengths};
use crate::input::rotors::context::Context;
use crate::input::rotors::problem::RotorProblem;

/// The nacelle.
#[derive(Debug, Default)]
struct Nacelle {
    yaw: Turned,
    tilt: f64,
    overhang: f64,
    above: f64,
    body: Option<Lump>,
    center: Vector3<f64>,
}

/// A tower with a nacelle, or a nacelle alone.
#[derive(Debug)]
pub(in crate::input::rotors) struct Turbine {
    foot: Vector3<f64>,
    tower: Option<Column>,
    nacelle: Nacelle,
}

/// Reads the tables of a rotor called `name`, on a foot \[m\]; `Some(None)` without them.
pub(super) fn read(
    table: &Table<'_>,
    name: &str,
    (foot, context): (Option<Vector3<f64>>, &Context),
) -> Option<Option<Turbine>> {
    let foot = foot.unwrap_or_default();
    let tower = table.nested(&TOWER, |table| {
        let height = table.get(&HEIGHT).unwrap_or(1.0);
        let axes = axes_along(&Vector3::z(), &Vector3::y());
        Column::read(table, "tower", (foot, axes, height))
    });
    let nacelle = table.nested(&NACELLE, |table| nacelle(table, name, context));
    let (tower, nacelle) = (tower?, nacelle?);
    let is_some = tower.is_some() || nacelle.is_some();
    Some(is_some.then(|| Turbine {
        foot,
        tower,
        nacelle: nacelle.unwrap_or_default(),
    }))
}

fn nacelle(table: &Table<'_>, name: &str, context: &Context) -> Option<Nacelle> {
    let (yaw, tilt) = (Turned::read(table, &YAW.schema, context), table.get(&TILT));
    let distances = [table.get(&OVERHANG), table.get(&ABOVE)];
    let (mass, center) = (table.get(&NACELLE_MASS), table.get(&NACELLE_CENTER));
    let inertia = moments(table, name);
    let [overhang, above] = distances;
    let (mass, inertia) = (mass?, inertia?);
    if mass == 0.0 && inertia.amax() > 0.0 {
        let (name, key, needed) = (name.to_owned(), INERTIA.name(), NACELLE_MASS.name());
        table.note(key, &RotorProblem::Idle { name, key, needed });
        return None;
    }
    Some(Nacelle {
        yaw: yaw?,
        tilt: tilt?,
        overhang: overhang?,
        above: above?,
        body: (mass > 0.0).then_some((mass, inertia)),
        center: center?,
    })
}

impl Turbine {
    /// The top of the tower \[m\].
    fn top(&self) -> Vector3<f64> {
        self.tower.as_ref().map_or(self.foot, Column::end)
    }

    /// The rotation of the undeformed nacelle about the tower.
    fn turn(&self) -> Vector3<f64> {
        Vector3::z() * self.nacelle.yaw.undeformed()
    }

    /// The frame of the hub: blades at azimuth zero point up.
    pub fn hub_frame(&self) -> HubFrame {
        let (sin, cos) = self.nacelle.tilt.sin_cos();
        let shaft = vector::to_rotation(&self.turn()) * Vector3::new(cos, 0.0, -sin);
        let above = Vector3::z() * self.nacelle.above;
        HubFrame {
            center: self.top() + above - shaft * self.nacelle.overhang,
            axis: shaft,
            aft: Vector3::z(),
        }
    }

    /// The cards; `node` is the nacelle.
    pub fn cards(&self, base: &Base, holder: Option<&str>, node: &str) -> Vec<Card> {
        let (mut cards, below) =
            Column::mounted(self.tower.as_ref(), base, &base.part("tower"), holder);
        cards.push(
            base.listed("node")
                .with("name", node)
                .with("position", lengths(&self.top()))
                .with("orientation", angles(&self.turn())),
        );
        let about = (self.top(), Vector3::z());
        let yaw = &self.nacelle.yaw;
        cards.push(yaw.card(base, (node, "yaw"), below.as_deref(), about));
        cards.extend(self.nacelle.body.as_ref().map(|lump| {
            base.body(node, lump)
                .with("offset", lengths(&self.nacelle.center))
        }));
        cards
    }
}

//! The shaft of a rotor: its hub, its bearing and its drive.

use shared_geom::document::{Card, Content};

use super::base::{Base, Lump, Units, lengths, signed};
use nalgebra::Vector3;

/// The drive of a shaft.
#[derive(Debug, Clone)]
pub(super) enum Drive {
    /// At a constant speed \[rad/s\].
    Speed(f64),
    /// By an angle over time, with its expression, if it is one, in the declared unit.
    Angle(Content, Option<String>),
    /// By a torque in the declared unit.
    Torque(Content),
}

impl Drive {
    /// The prescribed angle, if it is prescribed.
    pub fn angle(&self, units: &Units) -> Option<Content> {
        match self {
            Self::Speed(speed) => {
                let rate = speed * units.time / units.angle;
                Some(format!("= {}*t", signed(rate)).into())
            }
            Self::Angle(content, _) => Some(content.clone()),
            Self::Torque(_) => None,
        }
    }

    /// The angle \[rad\] as an expression; the reason if there is none.
    pub fn azimuth(&self, base: &Base) -> Result<String, &'static str> {
        let units = &base.units;
        match self {
            Self::Speed(speed) => Ok(format!("{}*t", signed(speed * units.time))),
            Self::Angle(_, Some(text)) => Ok(format!("{text}*{}", units.angle)),
            Self::Angle(_, None) => Err("\"angle\" is a drive by name or table"),
            Self::Torque(_) => Ok(sensor(&base.name)),
        }
    }
}

/// The name of the sensor of the azimuth of a rotor.
pub(super) fn sensor(rotor: &str) -> String {
    format!("{rotor}_azimuth")
}

/// Unit of the sensor of the azimuth.
pub(super) const SENSOR_UNIT: &str = "rad";

/// The hub node with its body, its bearing on the shaft and the drive; `senses` if other parts
/// need the azimuth.
pub(super) fn cards(base: &Base, drive: &Drive, body: Option<&Lump>, senses: bool) -> Vec<Card> {
    let (hub, shaft) = (base.hub(), base.part("shaft"));
    let mut cards = vec![base.node(&hub, &base.local(), Vector3::zeros())];
    cards.extend(body.map(|lump| base.body(&hub, lump)));
    cards.push(
        base.joint_to_mast(&shaft, "revolute", &hub)
            .with("at", lengths(&Vector3::zeros()))
            .with("axis", Content::numbers([0.0, 0.0, 1.0]))
            .with_some("angle", drive.angle(&base.units)),
    );
    let Drive::Torque(torque) = drive else {
        return cards;
    };
    let load = match &base.carrier {
        None => base.listed("load").with("node", hub.as_str()),
        Some(carrier) => base
            .listed("internal_force")
            .with("name", base.part("torque"))
            .with("nodes", Content::texts([carrier.as_str(), &hub])),
    };
    cards.push(
        load.with("in", base.name.as_str())
            .with("moment", Content::numbers([0.0, 0.0, 1.0]))
            .with("constant", true)
            .with("drive", torque.clone()),
    );
    if senses {
        cards.push(
            Card::single(["sensors", &sensor(&base.name)], base.line)
                .with("quantity", "joint_angle")
                .with("of", shaft)
                .with("unit", SENSOR_UNIT),
        );
    }
    cards
}

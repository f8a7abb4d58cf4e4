//! The shaft of a rotor: its hub, its bearing and its drive.

use nalgebra::Vector3;
use shared_geom::document::{Card, Content};

use super::base::{Base, Lump, Units, lengths, signed};
use super::train::{self, Train};
use super::train_keys::{FREE_WHEEL, GOVERNOR};

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

/// A shaft.
#[derive(Debug)]
pub(super) struct Shaft {
    /// The drive of its hub, or of the engine of its train.
    pub drive: Drive,
    /// The train between engine and hub.
    pub train: Option<Train>,
    /// Speed that the file gives \[rad/s\].
    pub given: Option<f64>,
    /// Speed at the time zero of an angle that is an expression of time \[rad/s\].
    pub turning: Option<f64>,
}

impl Shaft {
    /// Whether the angle of the hub is a result.
    pub fn is_free(&self) -> bool {
        self.train.is_some() || matches!(self.drive, Drive::Torque(_))
    }

    /// The speed, if it is constant but for vibrations \[rad/s\].
    pub fn constant_speed(&self) -> Option<f64> {
        let train = self.train.as_ref();
        match self.drive {
            Drive::Speed(speed) if train.is_none_or(|train| train.governor.is_none()) => {
                Some(speed)
            }
            _ => None,
        }
    }

    /// The key of a part that has no state of steady rotation, if there is one.
    pub fn unsteady(&self) -> Option<&'static str> {
        let train = self.train.as_ref()?;
        match (&train.governor, train.has_free_wheel) {
            (Some(_), _) => Some(GOVERNOR.name()),
            (None, true) => Some(FREE_WHEEL.name()),
            (None, false) => None,
        }
    }

    /// Whether it has a free wheel.
    pub fn has_free_wheel(&self) -> bool {
        self.train
            .as_ref()
            .is_some_and(|train| train.has_free_wheel)
    }

    /// Required speed of the governor, if there is one \[rad/s\].
    pub fn governed(&self) -> Option<f64> {
        let governor = self.train.as_ref()?.governor.as_ref()?;
        Some(governor.speed)
    }

    /// The prescribed angle of the hub, if it is prescribed.
    pub fn angle(&self, units: &Units) -> Option<Content> {
        match self.train {
            None => self.drive.angle(units),
            Some(_) => None,
        }
    }

    /// The sum of its prescribed angle and an expression, both in declared units.
    pub fn angle_and(&self, units: &Units, (angle, other): (Content, String)) -> Content {
        let written = match &self.drive {
            Drive::Speed(speed) => {
                let rate = speed * units.time / units.angle;
                Some(format!("{}*t", signed(rate)))
            }
            Drive::Angle(_, text) => text.clone(),
            Drive::Torque(_) => None,
        };
        match written {
            Some(written) => format!("= {written} + {other}").into(),
            None => Content::table([
                ("kind", "sum".into()),
                ("terms", Content::list([angle, format!("= {other}").into()])),
            ]),
        }
    }

    /// The angle of the hub \[rad\] as an expression; the reason if there is none.
    pub fn azimuth(&self, base: &Base) -> Result<String, &'static str> {
        match self.train {
            None => self.drive.azimuth(base),
            Some(_) => Ok(sensor(&base.name)),
        }
    }
}

impl Drive {
    /// The prescribed angle, if it is prescribed.
    fn angle(&self, units: &Units) -> Option<Content> {
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
    fn azimuth(&self, base: &Base) -> Result<String, &'static str> {
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
pub(super) fn cards(base: &Base, own: &Shaft, body: Option<&Lump>, senses: bool) -> Vec<Card> {
    let (hub, shaft) = (base.hub(), base.part("shaft"));
    let mut cards = vec![base.node(&hub, &base.local(), Vector3::zeros())];
    cards.extend(body.map(|lump| base.body(&hub, lump)));
    cards.push(
        base.joint_to_mast(&shaft, "revolute", &hub)
            .with("at", lengths(&Vector3::zeros()))
            .with("axis", Content::numbers([0.0, 0.0, 1.0]))
            .with_some("angle", own.angle(&base.units)),
    );
    let torque = match &own.drive {
        Drive::Torque(torque) => Some(torque),
        _ => None,
    };
    match &own.train {
        Some(train) => cards.extend(train.cards(base, (own.drive.angle(&base.units), torque))),
        None => cards.extend(torque.map(|torque| train::torque(base, &hub, torque.clone()))),
    }
    if senses && own.is_free() {
        cards.push(
            Card::single(["sensors", &sensor(&base.name)], base.line)
                .with("quantity", "joint_angle")
                .with("of", shaft)
                .with("unit", SENSOR_UNIT),
        );
    }
    cards
}

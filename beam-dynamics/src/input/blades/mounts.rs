//! Positions of the blades of a card on the hub, and their names.
//!
//! ```text
//! A = A_hub(azimuth) Ry(-precone)        B = A Rx(pitch)        root = center + R A e_x
//! ```
//!
//! A has the span as held by the hub (x out, y in the direction of motion, z up), B is the
//! blade with its pitch, which turns the whole blade about the span at its root, like a
//! pitch bearing. R is the hub radius; `root` gives the position directly.

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::schema::ValueKind::{
    Count, NotNegative, Quantities, Quantity, Text, Texts, Vector,
};
use shared_geom::document::{Key, Table};
use shared_geom::keys;
use shared_geom::rotation::vector;
use shared_geom::units::Dimension;
use std::f64::consts::TAU;

use super::MIRROR;
use super::problem::BladeProblem;
use crate::input::builder::ModelBuilder;
use crate::input::frames::IN;
use crate::input::hub::Hub;
use crate::input::number::short_number;
use crate::input::problem::InputProblem;

keys! {
    /// The name of the blade; its nodes are called `NAME/root`, `NAME/1`, ..., `NAME/tip`.
    pub(super) NAME: String = "name", [Text], required, "\"blade\"";
    /// Distance of the root from the center of the hub, along the blade with its precone.
    pub(in crate::input) HUB_RADIUS: f64 = "hub_radius", [NotNegative(Dimension::LENGTH)], or "0" = 0.0, "1.5";
    /// Position of the root at azimuth zero, in place of `hub_radius`.
    pub(super) ROOT: Option<Vector3<f64>> = "root", [Vector(3, Dimension::LENGTH)], optional, "[2.5, 0, 0]";
    /// Azimuth of the first blade about the axis of the hub; zero is along +x for an axis along z.
    pub(super) AZIMUTH: f64 = "azimuth", [Quantity(Dimension::ANGLE)], or "0" = 0.0, "90";
    /// Number of equal blades, evenly spaced about the axis; they are called `NAME 1` and so on.
    pub(super) COUNT: Option<usize> = "count", [Count(MOST_BLADES)], optional, "3";
    /// Azimuth of each blade, in place of `count` and `azimuth`.
    pub(super) AZIMUTHS: Option<Vec<f64>> = "azimuths", [Quantities(Dimension::ANGLE)], optional,
        "[0, 90, 180, 270]";
    /// Names of the blades of `count` or `azimuths`.
    pub(super) NAMES: Option<Vec<String>> = "names", [Texts], optional, "[\"a\", \"b\", \"c\"]";
    /// Cone angle, positive up, less than a quarter turn.
    pub(super) PRECONE: f64 = "precone", [Quantity(Dimension::ANGLE)], or "0" = 0.0, "-2.5";
    /// Rotation of the whole blade about its span at the root, positive nose up: the collective.
    pub(super) PITCH: f64 = "pitch", [Quantity(Dimension::ANGLE)], or "0" = 0.0, "8";
}

/// Blades of one card: more are treated as an error.
const MOST_BLADES: usize = 100;
/// Radius of a hub over the length of its blades, above which it is likely one in millimeters.
const MILLIMETERS: f64 = 20.0;
/// Azimuths nearer than this are the same \[rad\].
const SAME_AZIMUTH: f64 = 1e-6;

/// The mount of one blade on the hub.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct BladeMount {
    /// Name of the blade.
    pub name: String,
    /// Azimuth on the rotor, positive about the axis \[rad\].
    pub azimuth: f64,
    /// Position of the root \[m\].
    pub root: Vector3<f64>,
    /// Distance of the root from the center of rotation, along the span \[m\].
    pub radius: f64,
    /// Precone, positive up \[rad\].
    pub precone: f64,
    /// Axes (columns) before pitch, precone included.
    pub axes: Matrix3<f64>,
    /// Pitch, positive nose up \[rad\].
    pub pitch: f64,
}

impl BladeMount {
    /// Axes (columns) of the blade, pitch included.
    pub fn blade_axes(&self) -> Matrix3<f64> {
        self.axes * about(Vector3::x() * self.pitch)
    }

    /// Position at a distance from the center of rotation along the span \[m\].
    pub fn at_radius(&self, radius: f64) -> Vector3<f64> {
        self.root + self.axes.column(0) * (radius - self.radius)
    }
}

fn about(turn: Vector3<f64>) -> Matrix3<f64> {
    vector::to_rotation(&turn)
}

/// Position of the root, by key.
#[derive(Debug, Clone, Copy)]
enum RootPosition {
    /// `root`: its position at azimuth zero \[m\].
    At(Vector3<f64>),
    /// `hub_radius`: its distance from the center along the span \[m\].
    Radius(f64),
}

/// Names and azimuths \[rad\] of the blades of a card.
pub(super) type NamedAzimuths = Vec<(String, f64)>;

/// Names and azimuths; `None` if they are wrong, which is noted.
pub(super) fn named_azimuths(table: &Table<'_>) -> Option<NamedAzimuths> {
    let name = table.get(&NAME);
    let azimuths = azimuths(table, name.as_deref().unwrap_or_default());
    let names = table.get(&NAMES)?;
    let (name, azimuths) = (name?, azimuths?);
    let is_several = table.has(&COUNT) || table.has(&AZIMUTHS);
    let names = match names {
        Some(names) => names,
        None if is_several => (1..=azimuths.len())
            .map(|k| format!("{name} {k}"))
            .collect(),
        None => vec![name],
    };
    if names.len() != azimuths.len() {
        let (found, expected) = (names.len(), azimuths.len());
        table.note(&NAMES, &BladeProblem::Names { found, expected });
        return None;
    }
    Some(names.into_iter().zip(azimuths).collect())
}

fn azimuths(table: &Table<'_>, name: &str) -> Option<Vec<f64>> {
    let first = table.get(&AZIMUTH);
    let count = table.get(&COUNT)?;
    let Some(angles) = table.get(&AZIMUTHS)? else {
        let (first, count) = (first?, count.unwrap_or(1));
        return Some(
            (0..count)
                .map(|k| first + TAU * k as f64 / count as f64)
                .collect(),
        );
    };
    for key in [COUNT.name(), AZIMUTH.name()] {
        if table.has(key) {
            let problem = BladeProblem::Both {
                blade: format!("blade \"{name}\""),
                first: AZIMUTHS.name(),
                second: key,
            };
            table.note(key, &problem);
            return None;
        }
    }
    for (k, angle) in angles.iter().enumerate() {
        let apart = |other: &f64| (angle - other + TAU / 2.0).rem_euclid(TAU) - TAU / 2.0;
        if angles[..k]
            .iter()
            .any(|other| apart(other).abs() < SAME_AZIMUTH)
        {
            let degrees = angle.to_degrees();
            table.note(&AZIMUTHS, &BladeProblem::AzimuthTwice { degrees });
            return None;
        }
    }
    Some(angles)
}

/// The mounts of the blades of a card, by their names and azimuths.
pub(super) fn read(
    table: &Table<'_>,
    builder: &ModelBuilder,
    named: Option<&NamedAzimuths>,
) -> Option<Vec<BladeMount>> {
    let name = table.given(&NAME).unwrap_or_default();
    let root = root_position(table, &name);
    let precone = shallow(table, &PRECONE);
    let pitch = table.get(&PITCH);
    let side = match table.given(&MIRROR) {
        Some(true) => -1.0,
        _ => 1.0,
    };
    let (hub, named, root) = (hub(table, builder)?, named?, root?);
    let precone = precone?;
    let cone = about(Vector3::new(0.0, -side * precone, 0.0));
    let mut mounts = Vec::with_capacity(named.len());
    for (name, azimuth) in named {
        let Some(axes) = hub.blade_axes(*azimuth) else {
            table.note(&AZIMUTH, &InputProblem::AxisAlongSpan);
            return None;
        };
        let axes = axes * cone;
        let span = axes.column(0).into_owned();
        let center = hub.frame_rotation().center;
        let (root, radius) = match root {
            RootPosition::Radius(radius) => (center + radius * span, radius),
            RootPosition::At(position) => {
                let position = Vector3::new(position.x, position.y, side * position.z);
                let root = hub.at_azimuth(position, *azimuth);
                (root, (root - center).dot(&span))
            }
        };
        mounts.push(BladeMount {
            name: name.clone(),
            azimuth: *azimuth,
            root,
            radius,
            precone,
            axes,
            pitch: side * pitch?,
        });
    }
    Some(mounts)
}

/// The hub of a card: of `[hub]`, or of the frame in which the card is written.
pub(super) fn hub(table: &Table<'_>, builder: &ModelBuilder) -> Option<Hub> {
    if !table.has(&IN) {
        return builder.hub().copied();
    }
    let frame = builder.frames().of(table)?;
    let axes = frame.axes(&Matrix3::identity());
    Some(Hub::in_frame(frame.point(&Vector3::zeros()), &axes))
}

fn root_position(table: &Table<'_>, name: &str) -> Option<RootPosition> {
    match (table.has(&ROOT), table.has(&HUB_RADIUS)) {
        (true, true) => {
            let problem = BladeProblem::Both {
                blade: format!("blade \"{name}\""),
                first: ROOT.name(),
                second: HUB_RADIUS.name(),
            };
            table.note(&HUB_RADIUS, &problem);
            None
        }
        (true, false) => table.get(&ROOT)?.map(RootPosition::At),
        (false, true) => table.get(&HUB_RADIUS).map(RootPosition::Radius),
        (false, false) => Some(RootPosition::Radius(0.0)),
    }
}

/// A remark on a hub whose radius is larger than the length of its blades \[m\], with the likely unit.
pub(in crate::input) fn remark_on_hub(of: &str, radius: f64, length: f64) -> Option<String> {
    let number = |value: f64| short_number(value, 6);
    let unit = match radius > MILLIMETERS * length {
        true => format!(", as in hub_radius = \"{} mm\"", number(radius)),
        false => String::new(),
    };
    (radius > length).then(|| {
        format!(
            "{of}: \"hub_radius\" is {} m, more than the length of the blade, {} m: check the unit{unit}",
            number(radius),
            number(length)
        )
    })
}

/// An angle of less than a quarter turn; a line that turns back inward is an error.
pub(super) fn shallow(table: &Table<'_>, key: &Key<f64>) -> Option<f64> {
    let found = table.get(key)?.to_degrees();
    if found.abs() < 90.0 {
        return Some(found.to_radians());
    }
    let key = key.name();
    table.note(key, &InputProblem::SteepAngle { key, found });
    None
}

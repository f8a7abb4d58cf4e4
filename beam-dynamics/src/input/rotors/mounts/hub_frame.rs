//! The frame of a hub, and what holds or turns the node of its shaft.

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::schema::KeySchema;
use shared_geom::document::{Card, Content, Table};

use crate::elements::Smoothness;
use crate::input::rotors::base::{Base, lengths};
use crate::input::rotors::context::Context;
use crate::input::rotors::controls::{self, Sum};

/// Position and axes of the hub of a rotor.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::input::rotors) struct HubFrame {
    /// Center of the hub \[m\].
    pub center: Vector3<f64>,
    /// Axis of the shaft in the sense of rotation.
    pub axis: Vector3<f64>,
    /// Direction of azimuth zero.
    pub aft: Vector3<f64>,
}

/// The axes whose x is a direction and whose y is as near as possible to another one.
pub(super) fn axes_along(x: &Vector3<f64>, y: &Vector3<f64>) -> Matrix3<f64> {
    let x = x.normalize();
    let y = (y - x * x.dot(y)).normalize();
    Matrix3::from_columns(&[x, y, x.cross(&y)])
}

/// The angle by which the node of a shaft is turned: a number holds the node, a drive turns it from the
/// angle zero by a joint.
#[derive(Debug)]
pub(super) enum Turned {
    /// A number \[rad\].
    Fixed(f64),
    /// A drive.
    Driven(Sum),
}

impl Default for Turned {
    fn default() -> Self {
        Self::Fixed(0.0)
    }
}

impl Turned {
    /// Reads the angle of a key.
    pub fn read(table: &Table<'_>, key: &KeySchema, context: &Context) -> Option<Self> {
        let Some(item) = table.item(key.name) else {
            return Some(Self::default());
        };
        if let Some(angle) = context.constant(&item, key)? {
            return Some(Self::Fixed(angle));
        }
        let read = controls::read(table, key, (context, Smoothness::Acceleration))?;
        let mut drive = Sum::default();
        drive.add(read.as_ref(), None);
        Some(Self::Driven(drive))
    }

    /// The angle of the undeformed model \[rad\].
    pub fn undeformed(&self) -> f64 {
        match self {
            Self::Fixed(angle) => *angle,
            Self::Driven(_) => 0.0,
        }
    }

    /// The card that holds or turns `node` on another one, or on the frame of the model, by a joint of the
    /// given name about a point and an axis.
    pub fn card(
        &self,
        base: &Base,
        (node, joint): (&str, &str),
        below: Option<&str>,
        (at, axis): (Vector3<f64>, Vector3<f64>),
    ) -> Card {
        match self {
            Self::Fixed(_) => held(base, node, below),
            Self::Driven(drive) => {
                let nodes: Vec<_> = below.into_iter().chain([node]).collect();
                base.joint(&base.part(joint), "revolute", &nodes)
                    .with("at", lengths(&at))
                    .with("axis", Content::numbers([axis.x, axis.y, axis.z]))
                    .with("angle", drive.content())
            }
        }
    }
}

/// The card that holds a node on another one, or on the frame of the model.
fn held(base: &Base, node: &str, below: Option<&str>) -> Card {
    match below {
        Some(below) => base
            .listed("rigid")
            .with("name", format!("{node} attachment"))
            .with("nodes", Content::texts([below, node])),
        None => base.listed("clamp").with("node", node),
    }
}

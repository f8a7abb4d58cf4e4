//! The frames of a rotor, and its nodes.
//!
//! The axes A of a rotor are aft, to the side that a blade over the tail moves to, and along the
//! shaft. A blade k of N at the azimuth psi with the precone b has, at the distance u of the
//! undersling below the center,
//!
//! ```text
//! psi_k = psi_1 + 2 pi (k - 1) / N        A_k = A Rz(psi_k) Ry(-b)        x_k = x - A u e_z
//! ```
//!
//! A rotor that turns clockwise about its axis is the mirror image, in the plane of rotation, of one whose
//! third axis is against it. With S = diag(1, 1, -1) positions are S x, axes S A_k S, and in all axes of the
//! image rotation vectors, which are axial, are -S r.

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::{Card, Content, Document};
use shared_geom::rotation::vector;
use shared_geom::units::Dimension;
use std::f64::consts::TAU;

use super::damper_law::DamperLaw;

/// Axes of a positive angle of each kind, in the frame of a blade.
const AXES: [Vector3<f64>; 3] = [
    Vector3::new(0.0, -1.0, 0.0),
    Vector3::new(0.0, 0.0, 1.0),
    Vector3::new(1.0, 0.0, 0.0),
];
/// Index of flap in the kinds of hinges.
pub(super) const FLAP: usize = 0;
/// Index of lag in the kinds of hinges.
pub(super) const LAG: usize = 1;
/// Index of pitch in the kinds of hinges.
pub(super) const PITCH: usize = 2;

/// Units of plain numbers in expressions, in SI.
#[derive(Debug, Clone, Copy)]
pub(super) struct Units {
    /// Angle \[rad\].
    pub angle: f64,
    /// Length \[m\].
    pub length: f64,
    /// Time \[s\].
    pub time: f64,
    /// Moment \[N m\].
    pub moment: f64,
}

impl Units {
    /// The declared units of a file.
    pub fn of(document: &Document) -> Self {
        let factor = |dimension| document.factor(dimension);
        Self {
            angle: factor(Dimension::ANGLE),
            length: factor(Dimension::LENGTH),
            time: factor(Dimension::TIME),
            moment: factor(Dimension::MOMENT),
        }
    }
}

/// A number as a part of an expression.
pub(super) fn signed(number: f64) -> String {
    if number < 0.0 {
        format!("({number})")
    } else {
        number.to_string()
    }
}

/// Stops of an angle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stop {
    /// Least angle \[rad\].
    pub lower: Option<f64>,
    /// Largest angle \[rad\].
    pub upper: Option<f64>,
    /// Stiffness in contact \[N m\].
    pub stiffness: f64,
    /// Damping in contact \[N m s\].
    pub damping: f64,
    /// Angle over which the contact begins \[rad\].
    pub width: f64,
}

/// Spring, damper and stops of an angle.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Restraint {
    /// Stiffness \[N m\].
    pub stiffness: f64,
    /// Damping \[N m s\].
    pub damping: f64,
    /// Stops.
    pub stop: Option<Stop>,
}

/// A hinge of every blade.
#[derive(Debug, Clone)]
pub(super) struct Hinge {
    /// Index in the words of the kinds.
    pub kind: usize,
    /// Distance from the center along the blade \[m\].
    pub offset: f64,
    /// Spring, damper and stops.
    pub restraint: Restraint,
    /// Whether its stiffness is written, zero included.
    pub has_stiffness: bool,
    /// A damper beside the one of the restraint.
    pub damper: Option<DamperLaw>,
}

/// A mass and its moments of inertia \[kg, kg m^2\].
pub(super) type Lump = (f64, Vector3<f64>);

/// The parts of a rotor that its hub needs.
#[derive(Debug, Clone)]
pub(super) struct Base {
    /// Name of the rotor.
    pub name: String,
    /// Line of its card.
    pub line: usize,
    /// Node that carries the shaft; `None` for the frame.
    pub carrier: Option<String>,
    /// Number of blades.
    pub count: usize,
    /// Azimuth of the first blade \[rad\].
    pub azimuth: f64,
    /// Cone angle of the blades, positive up \[rad\].
    pub precone: f64,
    /// Pitch of the bearings in the undeformed model \[rad\].
    pub pitch: f64,
    /// Distance of the cone of the blades below the center \[m\].
    pub undersling: f64,
    /// Distance of the universal joints of a gimbal from the center \[m\].
    pub link: Option<f64>,
    /// Whether it is the mirror image, in its plane, of a rotor with its axes.
    pub mirror: bool,
    /// Speed of its nodes at the start \[rad/s\]; `None` if they begin at rest.
    pub spin: Option<f64>,
    /// Spring, damper and stops of the tilt.
    pub tilt: Restraint,
    /// The body that tilts.
    pub yoke: Option<Lump>,
    /// Whether its blades are on flexbeams.
    pub has_flexbeam: bool,
    /// Hinges of every blade, from the hub outward, pitch bearing included.
    pub hinges: Vec<Hinge>,
    /// Units of expressions.
    pub units: Units,
}

/// A frame of a rotor, which turns with it.
#[derive(Debug, Clone)]
pub(super) struct Local {
    /// Its name.
    pub name: String,
    /// Origin, in the frame of the rotor \[m\].
    origin: Vector3<f64>,
    /// Axes (columns), in the frame of the rotor.
    axes: Matrix3<f64>,
    /// Whether it has the pitch of the undeformed model.
    pub is_pitched: bool,
}

impl Local {
    /// A position in the frame \[m\] in the frame of the rotor.
    pub fn point(&self, position: &Vector3<f64>) -> Vector3<f64> {
        self.origin + self.axes * position
    }
}

impl Base {
    /// The name of a part of the rotor.
    pub fn part(&self, part: &str) -> String {
        format!("{}/{part}", self.name)
    }

    /// The name of a part of blade `k`, from zero.
    pub fn of_blade(&self, k: usize, part: &str) -> String {
        format!("{} {}/{part}", self.name, k + 1)
    }

    /// The node of the hub, which turns with the shaft.
    pub fn hub(&self) -> String {
        self.part("hub")
    }

    /// The frame of the blades: below the center by the undersling.
    pub fn frame_of_blades(&self) -> String {
        if self.undersling == 0.0 {
            self.name.clone()
        } else {
            format!("{} blades", self.name)
        }
    }

    /// The sign of heights and of rotations across the shaft.
    pub fn side(&self) -> f64 {
        if self.mirror { -1.0 } else { 1.0 }
    }

    /// A position, or its mirror image.
    pub fn placed(&self, position: &Vector3<f64>) -> Vector3<f64> {
        Vector3::new(position.x, position.y, self.side() * position.z)
    }

    /// A rotation vector, or its mirror image.
    pub fn turned(&self, rotation: &Vector3<f64>) -> Vector3<f64> {
        let side = self.side();
        Vector3::new(side * rotation.x, side * rotation.y, rotation.z)
    }

    /// The axis of a positive angle of a kind of hinges, in the frame of a blade.
    pub fn axis(&self, kind: usize) -> Vector3<f64> {
        self.turned(&AXES[kind])
    }

    /// Azimuth of blade `k`, from zero \[rad\].
    pub fn azimuth_of(&self, k: usize) -> f64 {
        self.azimuth + TAU * k as f64 / self.count as f64
    }

    /// The frame of the rotor.
    pub fn local(&self) -> Local {
        Local {
            name: self.name.clone(),
            origin: Vector3::zeros(),
            axes: Matrix3::identity(),
            is_pitched: false,
        }
    }

    /// The frame of blade `k`, from zero.
    pub fn arm(&self, k: usize) -> Local {
        let turn = vector::to_rotation(&(Vector3::z() * self.azimuth_of(k)));
        Local {
            name: format!("{} arm {}", self.name, k + 1),
            origin: self.placed(&(Vector3::z() * -self.undersling)),
            axes: turn * vector::to_rotation(&self.turned(&(Vector3::y() * -self.precone))),
            is_pitched: false,
        }
    }

    /// The frame of blade `k`, from zero, with its pitch in the undeformed model.
    pub fn pitched(&self, k: usize) -> Local {
        let arm = self.arm(k);
        Local {
            name: format!("{} pitched", arm.name),
            axes: arm.axes * vector::to_rotation(&self.turned(&(Vector3::x() * self.pitch))),
            is_pitched: true,
            ..arm
        }
    }

    /// A card of the rotor.
    pub fn listed(&self, kind: &str) -> Card {
        Card::listed(kind, self.line)
    }

    /// The card of a frame in the frame of the rotor.
    pub fn frame(&self, local: &Local) -> Card {
        self.listed("frame")
            .with("name", local.name.as_str())
            .with("in", self.name.as_str())
            .with("position", lengths(&local.origin))
            .with("orientation", angles(&vector::from_rotation(&local.axes)))
    }

    /// A node at a position in a frame \[m\], which turns with the rotor at the start.
    pub fn node(&self, name: &str, local: &Local, position: Vector3<f64>) -> Card {
        let card = self.fixed_node(name, local, position);
        let Some(spin) = self.spin else {
            return card;
        };
        let spin = Vector3::z() * spin;
        let velocity = spin.cross(&(local.origin + local.axes * position));
        let into = local.axes.transpose();
        card.with(
            "velocity",
            Content::quantities((into * velocity).iter().copied(), "m/s"),
        )
        .with(
            "angular_velocity",
            Content::quantities((into * spin).iter().copied(), "rad/s"),
        )
    }

    /// A node that does not turn with the rotor.
    pub fn fixed_node(&self, name: &str, local: &Local, position: Vector3<f64>) -> Card {
        self.listed("node")
            .with("name", name)
            .with("in", local.name.as_str())
            .with("position", lengths(&position))
    }

    /// A body on a node.
    pub fn body(&self, node: &str, (mass, inertia): &Lump) -> Card {
        self.listed("body")
            .with("name", node)
            .with("node", node)
            .with("mass", Content::quantity(*mass, "kg"))
            .with(
                "inertia",
                Content::quantities(inertia.iter().copied(), "kg*m^2"),
            )
    }

    /// A joint of a kind.
    pub fn joint(&self, name: &str, kind: &str, nodes: &[&str]) -> Card {
        self.listed("joint")
            .with("name", name)
            .with("kind", kind)
            .with("nodes", Content::texts(nodes.iter().copied()))
    }

    /// A joint of the carrier of the shaft, or of the frame, and a node; written in the frame of the
    /// rotor.
    pub fn joint_to_mast(&self, name: &str, kind: &str, node: &str) -> Card {
        let nodes: Vec<_> = self
            .carrier
            .iter()
            .map(String::as_str)
            .chain([node])
            .collect();
        self.joint(name, kind, &nodes)
            .with("in", self.name.as_str())
    }

    /// A hinge with spring and damper at its second node, about an axis in a frame.
    pub fn hinge(
        &self,
        name: &str,
        nodes: [&str; 2],
        (local, axis): (&Local, Vector3<f64>),
        restraint: &Restraint,
    ) -> Card {
        let card = self
            .listed("hinge")
            .with("name", name)
            .with("nodes", Content::texts(nodes))
            .with("in", local.name.as_str())
            .with("axis", Content::numbers(axis.iter().copied()));
        let some = |value: f64, unit| (value != 0.0).then(|| Content::quantity(value, unit));
        card.with_some("stiffness", some(restraint.stiffness, "N*m"))
            .with_some("damping", some(restraint.damping, "N*m*s"))
    }
}

/// A vector of lengths \[m\].
pub(super) fn lengths(vector: &Vector3<f64>) -> Content {
    Content::quantities(vector.iter().copied(), "m")
}

/// A vector of angles \[rad\].
pub(super) fn angles(vector: &Vector3<f64>) -> Content {
    Content::quantities(vector.iter().copied(), "rad")
}

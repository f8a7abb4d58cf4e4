//! The drive train of a rotor: engine, governor, shaft and free wheel.
//!
//! All parts turn about the shaft of the rotor; an engine with the moment of inertia J and the speed of
//! n times the rotor is a body of `n^2 J` on a bearing of its own. The governor gives it the torque
//!
//! ```text
//! T = min(max(K_p e + K_i z, 0), T_max)       e = Omega_0 - omega       z' = e + (T - K_p e - K_i z) / K_p
//! ```
//!
//! whose last term keeps the integral z at the limits. A shaft with a free wheel has the windup w and the
//! torque
//!
//! ```text
//! T = max(0, k w + c d)       w' = d + max(0, -w) / tau       d = omega - omega_hub
//! ```
//!
//! so that it engages at any angle.

use nalgebra::Vector3;
use shared_geom::document::{Card, Content};

use super::base::{Base, angles, lengths, signed};

/// An engine and its connection with the hub.
#[derive(Debug, Clone)]
pub(super) struct Train {
    /// Moment of inertia of the engine about the shaft of the rotor \[kg m^2\]; `None` if its motion is
    /// prescribed.
    pub inertia: Option<f64>,
    /// Stiffness \[N m\] and damping \[N m s\] of the shaft; `None` for a rigid one.
    pub spring: Option<[f64; 2]>,
    /// Whether the shaft has a free wheel.
    pub has_free_wheel: bool,
    /// The governor.
    pub governor: Option<Governor>,
}

/// A governor of the speed of an engine.
#[derive(Debug, Clone)]
pub(super) struct Governor {
    /// Required speed \[rad/s\].
    pub speed: f64,
    /// Torque per difference of speed \[N m s\].
    pub proportional: f64,
    /// Torque per integral of the difference \[N m\].
    pub integral: f64,
    /// Largest torque \[N m\].
    pub largest: Option<f64>,
}

/// Mass per moment of inertia of an engine, which has none of its own: bodies have mass \[1/m^2\].
const TRACE: f64 = 1e-6;
/// Time in which a free wheel loses the windup of the wrong sense \[s\].
const RELEASE: f64 = 2e-3;

impl Train {
    /// The engine and its connection with the hub: its angle is prescribed, or it has a torque.
    pub fn cards(
        &self,
        base: &Base,
        (angle, torque): (Option<Content>, Option<&Content>),
    ) -> Vec<Card> {
        let engine = base.part("engine");
        let mut cards = vec![
            base.node(&engine, &base.local(), Vector3::zeros()),
            base.joint_to_mast(&bearing(base), "revolute", &engine)
                .with("at", lengths(&Vector3::zeros()))
                .with("axis", Content::numbers([0.0, 0.0, 1.0]))
                .with_some("angle", angle.filter(|_| self.inertia.is_none())),
        ];
        cards.extend(self.inertia.map(|polar| {
            let moments = Vector3::new(0.5, 0.5, 1.0) * polar;
            base.body(&engine, &(TRACE * polar, moments))
        }));
        if self.has_free_wheel || self.governor.is_some() {
            cards.push(speed(base, &engine_speed(base), bearing(base)));
        }
        cards.extend(
            self.governor
                .iter()
                .flat_map(|own| own.cards(base, &engine)),
        );
        cards.extend(torque.map(|torque| self::torque(base, &engine, torque.clone())));
        cards.extend(self.shaft(base, [&engine, &base.hub()]));
        cards
    }

    /// The connection of the engine with the hub.
    fn shaft(&self, base: &Base, nodes: [&str; 2]) -> Vec<Card> {
        let name = base.part("drive shaft");
        match self.spring {
            None => vec![
                base.joint(&name, "rotation", &nodes)
                    .with("in", base.name.as_str())
                    .with("rotation", Content::table([("z", 0.0.into())])),
            ],
            Some(spring) if self.has_free_wheel => free_wheel(base, (name, nodes), spring),
            Some([stiffness, damping]) => vec![
                base.listed("spring")
                    .with("name", name)
                    .with("nodes", Content::texts(nodes))
                    .with("in", base.name.as_str())
                    .with("orientation", angles(&Vector3::zeros()))
                    .with(
                        "rotational_stiffness",
                        Content::quantities([0.0, 0.0, stiffness], "N*m"),
                    )
                    .with(
                        "rotational_damping",
                        Content::quantities([0.0, 0.0, damping], "N*m*s"),
                    ),
            ],
        }
    }
}

impl Governor {
    fn cards(&self, base: &Base, engine: &str) -> Vec<Card> {
        let state = format!("{}_governor", base.name);
        let error = format!("({} - {})", signed(self.speed), engine_speed(base));
        let mut wanted = format!("{}*{error}", signed(self.proportional));
        let mut cards = Vec::new();
        if self.integral > 0.0 {
            wanted += &format!(" + {}*{state}", signed(self.integral));
            let held = format!("{} - ({wanted})", self.limited(&wanted));
            let input = format!("= {error} + ({held})/{}", signed(self.proportional));
            cards.push(integral(base, (base.part("governor"), &state), input));
        }
        let unit = base.units.moment;
        let drive = format!("= ({})/{}", self.limited(&wanted), signed(unit));
        cards.push(torque(base, engine, drive.into()));
        cards
    }

    /// A torque within the limits.
    fn limited(&self, torque: &str) -> String {
        let driving = format!("max({torque}, 0)");
        match self.largest {
            None => driving,
            Some(largest) => format!("min({driving}, {})", signed(largest)),
        }
    }
}

/// A shaft with a free wheel.
fn free_wheel(
    base: &Base,
    (name, nodes): (String, [&str; 2]),
    [stiffness, damping]: [f64; 2],
) -> Vec<Card> {
    let hub_speed = format!("{}_shaft_speed", base.name);
    let windup = format!("{}_windup", base.name);
    let slip = format!("({} - {hub_speed})", engine_speed(base));
    let input = format!("= {slip} + max(0, -{windup})/{}", signed(RELEASE));
    let unit = signed(base.units.moment);
    let drive = format!(
        "= max(0, {}*{windup} + {}*{slip})/{unit}",
        signed(stiffness),
        signed(damping)
    );
    vec![
        speed(base, &hub_speed, base.part("shaft")),
        integral(base, (base.part("free wheel"), &windup), input),
        base.listed("internal_force")
            .with("name", name)
            .with("nodes", Content::texts(nodes))
            .with("in", base.name.as_str())
            .with("moment", Content::numbers([0.0, 0.0, 1.0]))
            .with("constant", true)
            .with("drive", drive),
    ]
}

/// A torque on a node against the carrier of the shaft; the drive is in the declared unit.
pub(super) fn torque(base: &Base, node: &str, drive: Content) -> Card {
    let load = match &base.carrier {
        None => base.listed("load").with("node", node),
        Some(carrier) => base
            .listed("internal_force")
            .with("name", base.part("torque"))
            .with("nodes", Content::texts([carrier.as_str(), node])),
    };
    load.with("in", base.name.as_str())
        .with("moment", Content::numbers([0.0, 0.0, 1.0]))
        .with("constant", true)
        .with("drive", drive)
}

/// The joint of the engine.
fn bearing(base: &Base) -> String {
    base.part("engine bearing")
}

/// The name of the speed of the engine in expressions.
fn engine_speed(base: &Base) -> String {
    format!("{}_engine_speed", base.name)
}

/// The sensor of the speed of a bearing \[rad/s\].
fn speed(base: &Base, name: &str, bearing: String) -> Card {
    Card::single(["sensors", name], base.line)
        .with("quantity", "joint_angular_velocity")
        .with("of", bearing)
        .with("component", "x")
        .with("unit", "rad/s")
}

/// The integral of an expression, as a name in expressions.
fn integral(base: &Base, (card, name): (String, &str), input: String) -> Card {
    let row = |value: f64| Content::list([Content::numbers([value])]);
    base.listed("state_space")
        .with("name", card)
        .with("inputs", Content::texts([input.as_str()]))
        .with("outputs", Content::texts([name]))
        .with("a", row(0.0))
        .with("b", row(1.0))
        .with("c", row(1.0))
}

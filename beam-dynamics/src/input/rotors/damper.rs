//! Dampers of hinges, and dampers between hub and blade.
//!
//! A curve through `(v_i, m_i)` with the slopes `s_i` behind them is
//!
//! ```text
//! M = m_0 + s_0 (v - v_0) + sum_i (s_i - s_(i-1)) max(0, v - v_i)
//! ```
//!
//! A spring in series with a damper is a system of one state x, the displacement of the damper, of which
//! the deformation d of the whole is sensed; its force is the prestress of the spring beside it:
//!
//! ```text
//! x' = (d - x) / tau        F = k d + k_1 (d - x)
//! ```

use nalgebra::Vector3;
use shared_geom::document::{Card, Content};

use super::base::{Base, Local, Units, angles, lengths, signed};
use super::damper_law::DamperLaw;

/// Moment or force of a curve at the rate `v`, an expression, divided by `unit`.
pub(super) fn curve(curve: &[[f64; 2]], v: &str, unit: f64) -> String {
    let slopes: Vec<_> = curve
        .windows(2)
        .map(|pair| (pair[1][1] - pair[0][1]) / (pair[1][0] - pair[0][0]))
        .collect();
    let mut before = 0.0;
    let mut text = String::new();
    for (number, (slope, [rate, force])) in slopes.iter().zip(curve).enumerate() {
        let [change, force] = [slope - before, *force].map(|value| signed(value / unit));
        let rate = signed(*rate);
        text += &match number {
            0 => format!("{force} + {change}*({v} - {rate})"),
            _ => format!(" + {change}*max(0, {v} - {rate})"),
        };
        before = *slope;
    }
    text
}

/// A damper of the angle of a hinge between two nodes; the first axis of `axes`, a rotation vector in
/// a frame, is the axis of the hinge.
pub(super) fn of_hinge(
    base: &Base,
    (hinge, nodes): (&str, [&str; 2]),
    (local, axes): (&Local, Vector3<f64>),
    law: &DamperLaw,
) -> Vec<Card> {
    let name = format!("{hinge} damper");
    let of = Component {
        quantity: "spring_rotation",
        component: "x",
        unit: "rad",
        force: base.units.moment,
        rate: format!("x_rate*{}", base.units.angle / base.units.time),
        wrap: |content| Content::list([content, 0.0.into(), 0.0.into()]),
        expression: |text| Content::table([("x", text.into())]),
    };
    let card = base
        .listed("spring")
        .with("name", name.as_str())
        .with("nodes", Content::texts(nodes))
        .with("in", local.name.as_str())
        .with("orientation", angles(&axes))
        .with("rotational_law", of.law(law, &name, &base.units));
    let states = of.states(base, law, &name);
    [card].into_iter().chain(states).collect()
}

/// The ends of a damper in the axes of blades, from the center \[m\].
#[derive(Debug, Clone, Copy)]
pub(super) struct Ends {
    /// On the hub, or on the next blade in the axes of that one.
    pub hub: Vector3<f64>,
    /// On the blade.
    pub blade: Vector3<f64>,
}

impl Ends {
    /// The ends of the rotor, or of its mirror image.
    fn placed(&self, base: &Base) -> Self {
        Self {
            hub: base.placed(&self.hub),
            blade: base.placed(&self.blade),
        }
    }
}

/// A damper along the line from a point of the yoke to a point of a part of blade `k`.
pub(super) fn of_ends(
    base: &Base,
    (k, [yoke, part]): (usize, [&str; 2]),
    ends: &Ends,
    law: &DamperLaw,
) -> Vec<Card> {
    let (arm, name) = (base.arm(k), base.of_blade(k, "damper"));
    let of = Component::elongation(&base.units);
    let ends = ends.placed(base);
    let offsets = [lengths(&arm.point(&ends.hub)), lengths(&Vector3::zeros())];
    let cards = vec![
        base.node(&name, &arm, ends.blade),
        base.listed("rigid")
            .with("name", format!("{name} end"))
            .with("nodes", Content::texts([part, &name])),
        base.listed("rod")
            .with("name", name.as_str())
            .with("nodes", Content::texts([yoke, &name]))
            .with("offsets", Content::list(offsets))
            .with("measure", "elongation")
            .with("law", of.law(law, &name, &base.units)),
    ];
    let states = of.states(base, law, &name);
    cards.into_iter().chain(states).collect()
}

/// A damper along the line from a point of a part of the blade after blade `k` to one of a part of
/// this blade.
pub(super) fn of_blades(
    base: &Base,
    (k, [next, part]): (usize, [&str; 2]),
    ends: &Ends,
    law: &DamperLaw,
) -> Vec<Card> {
    let after = (k + 1) % base.count;
    let [name, other] = ["damper", "damper next"].map(|end| base.of_blade(k, end));
    let of = Component::elongation(&base.units);
    let end = |name: &str, blade: usize, place: Vector3<f64>, part: &str| {
        let rigid = base
            .listed("rigid")
            .with("name", format!("{name} end"))
            .with("nodes", Content::texts([part, name]));
        [base.node(name, &base.arm(blade), place), rigid]
    };
    let ends = ends.placed(base);
    let ends = [
        end(&other, after, ends.hub, next),
        end(&name, k, ends.blade, part),
    ];
    let rod = base
        .listed("rod")
        .with("name", name.as_str())
        .with("nodes", Content::texts([other.as_str(), &name]))
        .with("measure", "elongation")
        .with("law", of.law(law, &name, &base.units));
    let states = of.states(base, law, &name);
    ends.into_iter()
        .flatten()
        .chain([rod])
        .chain(states)
        .collect()
}

/// A spring with a law along one axis of a frame between two nodes, at a place \[m\]; curves are not
/// possible.
pub(super) fn along(
    base: &Base,
    (name, nodes): (&str, [&str; 2]),
    (local, at): (&Local, Vector3<f64>),
    (axis, law): (usize, &DamperLaw),
) -> Vec<Card> {
    const AXES: [&str; 3] = ["x", "y", "z"];
    const WRAPS: [fn(Content) -> Content; 3] = [
        |content| Content::list([content, 0.0.into(), 0.0.into()]),
        |content| Content::list([0.0.into(), content, 0.0.into()]),
        |content| Content::list([0.0.into(), 0.0.into(), content]),
    ];
    let of = Component {
        component: AXES[axis],
        wrap: WRAPS[axis],
        ..Component::elongation(&base.units)
    };
    let card = base
        .listed("spring")
        .with("name", name)
        .with("nodes", Content::texts(nodes))
        .with("in", local.name.as_str())
        .with("at", lengths(&at))
        .with("law", of.law(law, name, &base.units));
    [card]
        .into_iter()
        .chain(of.states(base, law, name))
        .collect()
}

/// The deformation of a damper: the angle about an axis, or the elongation.
struct Component {
    /// Its quantity in sensors.
    quantity: &'static str,
    /// Its component in sensors.
    component: &'static str,
    /// Its SI unit.
    unit: &'static str,
    /// The declared unit of its moment or force \[N m, N\].
    force: f64,
    /// Its rate in SI, as an expression of laws.
    rate: String,
    /// A number of the component as a number of the law.
    wrap: fn(Content) -> Content,
    /// An expression of the component as one of the law.
    expression: fn(String) -> Content,
}

impl Component {
    /// The elongation of a rod.
    fn elongation(units: &Units) -> Self {
        Self {
            quantity: "spring_displacement",
            component: "x",
            unit: "m",
            force: units.moment / units.length,
            rate: format!("e_rate*{}", units.length / units.time),
            wrap: |content| content,
            expression: Content::from,
        }
    }

    fn law(&self, law: &DamperLaw, name: &str, units: &Units) -> Content {
        let number = |value: f64| (self.wrap)((value / self.force).into());
        match law {
            DamperLaw::Linear([stiffness, damping]) => Content::table([
                ("kind", "viscoelastic".into()),
                ("stiffness", self.stiffness(*stiffness, units)),
                ("viscosity", self.stiffness(*damping / units.time, units)),
            ]),
            DamperLaw::Curve(points) => {
                let text = format!("= {}", curve(points, &self.rate, self.force));
                Content::table([
                    ("kind", "expression".into()),
                    ("force", (self.expression)(text)),
                ])
            }
            DamperLaw::Relaxing { rest, .. } => Content::table([
                ("kind", "linear".into()),
                ("stiffness", self.stiffness(*rest, units)),
                ("prestress", number(self.force)),
                ("prestress_drive", relaxing(name).into()),
            ]),
        }
    }

    /// A stiffness in the declared units.
    fn stiffness(&self, value: f64, units: &Units) -> Content {
        let length = if self.unit == "m" { units.length } else { 1.0 };
        (self.wrap)((value * length / self.force).into())
    }

    /// The sensor and the state of a spring in series with a damper.
    fn states(&self, base: &Base, law: &DamperLaw, name: &str) -> Vec<Card> {
        let DamperLaw::Relaxing { series, time, .. } = law else {
            return Vec::new();
        };
        let sensor = signal(name);
        let row = |value: f64| Content::list([Content::numbers([value])]);
        let series = series / self.force;
        vec![
            Card::single(["sensors", &sensor], base.line)
                .with("quantity", self.quantity)
                .with("of", name)
                .with("component", self.component)
                .with("unit", self.unit),
            base.listed("state_space")
                .with("name", name)
                .with("inputs", Content::texts([sensor.as_str()]))
                .with("outputs", Content::texts([relaxing(name).as_str()]))
                .with("a", row(-1.0 / time))
                .with("b", row(1.0 / time))
                .with("c", row(-series))
                .with("d", row(series)),
        ]
    }
}

/// The name of the deformation of a damper in expressions.
pub(super) fn signal(name: &str) -> String {
    let letter = |letter: char| {
        if letter.is_ascii_alphanumeric() {
            letter
        } else {
            '_'
        }
    };
    name.chars().map(letter).collect()
}

/// The name of the force of the spring in series in expressions.
fn relaxing(name: &str) -> String {
    format!("{}_relaxing", signal(name))
}

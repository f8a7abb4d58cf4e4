//! Stops of a hinge, as springs with laws of the angle x about its axis.
//!
//! A stop at the angle `x_u` with the stiffness k, the damping c and the width w of the contact
//! resists, with d = x - x_u, by
//!
//! ```text
//! M = k/2 (d + sqrt(d^2 + w^2)) + c/2 (1 + d / sqrt(d^2 + w^2)) x'
//! ```
//!
//! which is smooth, at most k w/2 at the stop, and `k w^2 / (4 |d|)` far from it; a lower stop is its
//! mirror image.

use nalgebra::Vector3;
use shared_geom::document::{Card, Content};

use super::base::{Base, Hinge, Local, Stop, Units, angles, signed};

/// The law of the rotation about the first axis.
fn law(force: String) -> Content {
    let force = Content::table([("x", format!("= {force}").into())]);
    Content::table([("kind", "expression".into()), ("force", force)])
}

/// Moment of a stop against the angle `x` \[rad\] with the rate `v` \[rad/s\], both as
/// expressions, in the declared unit.
pub(super) fn stop_moment(stop: &Stop, [x, v]: [&str; 2], units: &Units) -> String {
    let [k, c] = [stop.stiffness, stop.damping].map(|value| signed(0.5 * value / units.moment));
    let width = stop.width * stop.width;
    let side = |sign: &str, angle: f64| {
        let depth = match sign {
            "" => format!("({x} - {})", signed(angle)),
            _ => format!("({} - {x})", signed(angle)),
        };
        let root = format!("sqrt({depth}^2 + {width})");
        let contact = if stop.damping == 0.0 {
            String::new()
        } else {
            format!(" + {c}*(1 + {depth}/{root})*{v}")
        };
        format!("{sign}{k}*({depth} + {root}){contact}")
    };
    let sides = [("", stop.upper), ("-", stop.lower)].into_iter();
    let sides: Vec<_> = sides
        .filter_map(|(sign, angle)| angle.map(|angle| side(sign, angle)))
        .collect();
    sides.join(" + ")
}

/// The spring of the stops of a hinge between two nodes, in a frame; the first axis of `axes`, a rotation vector, is the axis of the hinge.
pub(super) fn cards(
    base: &Base,
    (name, nodes): (&str, [&str; 2]),
    (local, axes): (&Local, Vector3<f64>),
    hinge: &Hinge,
) -> Option<Card> {
    let units = &base.units;
    // In expressions x is in the declared unit of angle, its rate per declared unit of time.
    let x = format!("x*{}", units.angle);
    let v = format!("x_rate*{}", units.angle / units.time);
    let stop = hinge.restraint.stop.as_ref()?;
    Some(
        base.listed("spring")
            .with("name", format!("{name} stop"))
            .with("nodes", Content::texts(nodes))
            .with("in", local.name.as_str())
            .with("orientation", angles(&axes))
            .with("rotational_law", law(stop_moment(stop, [&x, &v], units))),
    )
}

/// Rotation vector that turns the first axis of a blade to its flap axis.
pub(super) fn across(base: &Base) -> Vector3<f64> {
    Vector3::z() * (-base.side() * std::f64::consts::FRAC_PI_2)
}

/// Tilt whose square keeps the direction of a tilt of zero defined \[rad\].
const NO_TILT: f64 = 1e-9;

/// The law of a stop of the tilt in any direction, at its upper angle.
pub(super) fn of_tilt(stop: &Stop, units: &Units) -> Content {
    let [a, rate] = [units.angle, units.angle / units.time];
    let tilt = format!("sqrt((x*{a})^2 + (y*{a})^2 + {})", NO_TILT * NO_TILT);
    let speed = format!("((x*x_rate + y*y_rate)*{}/{tilt})", a * rate);
    let moment = stop_moment(stop, [&tilt, &speed], units);
    let force = ["x", "y"].map(|axis| (axis, format!("= ({moment})*{axis}*{a}/{tilt}").into()));
    Content::table([
        ("kind", "expression".into()),
        ("force", Content::table(force)),
    ])
}

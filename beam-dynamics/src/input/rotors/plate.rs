//! Plates and links of a swashplate as parts of the model.
//!
//! The plate that does not turn slides along the mast and tilts, prescribed or by three actuators;
//! the other plate turns on it, at the angle of the shaft, or with scissors to the hub; a link joins
//! it with each blade.

use nalgebra::Vector3;
use shared_geom::document::{Card, Content};

use super::base::{Base, Units, lengths, signed};
use super::controls::{Control, Pitch, Sum};
use super::distributor::{Actuators, Links, Position};
use super::keys::COLLECTIVE;
use super::problem::RotorProblem;
use super::shaft::Shaft;

/// A plate, its actuators and the links to the blades.
#[derive(Debug, Clone)]
pub(super) struct Plate {
    /// Geometry of the links.
    pub links: Links,
    /// Stiffness of a link \[N/m\]; `None` for a rigid one.
    pub stiffness: Option<f64>,
    /// Damping of a link \[N s/m\].
    pub damping: f64,
    /// Actuators; `None` for a prescribed plate.
    pub actuators: Option<Actuators>,
}

/// A problem and its line.
type Located = (usize, RotorProblem);

/// Height and tilts of the plate.
enum Motion {
    /// Constant.
    At(Position),
    /// In declared units, linear in the controls.
    Linear([Sum; 3]),
}

impl Plate {
    fn motion(&self, base: &Base, pitch: &Pitch) -> Result<Motion, Located> {
        let units = &base.units;
        let controls = [&pitch.collective, &pitch.cosine, &pitch.sine].map(Option::as_ref);
        let numbers = controls.map(|one| one.map_or(Some(0.0), |one| one.number()));
        if let [Some(a), Some(b), Some(c)] = numbers {
            let wanted = [a, b, c].map(|number| number * units.angle);
            let position = self.links.exact(wanted);
            return position
                .map(Motion::At)
                .map_err(|off| (base.line, RotorProblem::Unreachable { off }));
        }
        let linear = self.links.linear();
        let sum = |row: usize| {
            let unit = [units.angle / units.length, 1.0, 1.0][row];
            let mut sum = Sum::default();
            for (column, control) in controls.iter().enumerate() {
                let factor = linear[(row, column)] * unit;
                if factor != 0.0 {
                    sum.add(*control, Some(signed(factor)));
                }
            }
            sum
        };
        Ok(Motion::Linear([0, 1, 2].map(sum)))
    }

    /// The plates, with the guide or the actuators of the one that does not turn.
    pub fn cards(&self, base: &Base, pitch: &Pitch, shaft: &Shaft) -> Result<Vec<Card>, Located> {
        let motion = self.motion(base, pitch)?;
        let [plate, turning] = ["plate", "rotating plate"].map(|part| base.part(part));
        let (local, center) = (base.local(), self.center(base));
        let mut cards = vec![
            base.fixed_node(&plate, &local, center),
            base.node(&turning, &local, center),
        ];
        let guide = base
            .joint_to_mast(&base.part("plate guide"), "total", &plate)
            .with("locked", Content::texts(["x", "y", "about z"]));
        match &self.actuators {
            None => cards.push(prescribed(base, guide, &motion)),
            Some(actuators) => {
                cards.push(guide);
                cards.extend(self.actuator_cards(base, actuators, (&motion, pitch))?);
            }
        }
        let angle = match shaft.angle(&base.units) {
            Some(angle) if self.actuators.is_some() => {
                let yaw = yaw_text(&base.units, (&motion, pitch))?;
                Some(shaft.angle_and(&base.units, (angle, yaw)))
            }
            angle => angle,
        };
        let bearing = base.joint(&base.part("plate bearing"), "revolute", &[&plate, &turning]);
        cards.push(
            bearing
                .with("in", base.name.as_str())
                .with("axis", Content::numbers([0.0, 0.0, 1.0]))
                .with_some("angle", angle),
        );
        if shaft.is_free() {
            let nodes = [base.hub(), turning];
            let nodes = [nodes[0].as_str(), &nodes[1]];
            cards.push(
                base.joint(&base.part("scissors"), "rotation", &nodes)
                    .with("in", base.name.as_str())
                    .with("rotation", Content::table([("z", 0.0.into())])),
            );
        }
        Ok(cards)
    }

    fn actuator_cards(
        &self,
        base: &Base,
        actuators: &Actuators,
        (motion, pitch): (&Motion, &Pitch),
    ) -> Result<Vec<Card>, Located> {
        let (local, center) = (base.local(), self.center(base));
        let plate = base.part("plate");
        let mut cards = Vec::new();
        for (number, &azimuth) in actuators.azimuths.iter().enumerate() {
            let name = base.part(&format!("actuator {}", number + 1));
            let [end, foot] = actuators
                .ends(azimuth)
                .map(|end| center + base.placed(&end));
            cards.push(base.fixed_node(&name, &local, end));
            cards.push(
                base.listed("rigid")
                    .with("name", format!("{name} end"))
                    .with("nodes", Content::texts([plate.as_str(), &name])),
            );
            let length = match motion {
                Motion::At(position) => {
                    Content::quantity(actuators.length(azimuth, *position), "m")
                }
                Motion::Linear(sums) => {
                    let length = length_text(base, actuators, azimuth, &texts(pitch, sums)?);
                    Content::from(length).on_line(sums[0].line())
                }
            };
            // The distance of one node is from the point `at` of the frame.
            let key = match base.carrier {
                Some(_) => "from",
                None => "at",
            };
            cards.push(
                base.joint_to_mast(&name, "distance", &name)
                    .with(key, lengths(&foot))
                    .with("length", length),
            );
        }
        Ok(cards)
    }

    /// Its center in the undeformed model \[m\].
    fn center(&self, base: &Base) -> Vector3<f64> {
        base.placed(&(Vector3::z() * -self.links.below))
    }

    /// The link of blade `k` to its node that has the pitch, at an offset along it \[m\].
    pub fn link(&self, base: &Base, k: usize, (node, offset): (&str, f64)) -> Card {
        let turning = base.part("rotating plate");
        let azimuth = base.azimuth_of(k);
        let [top, bottom] = [self.links.top(azimuth, 0.0), self.links.bottom(azimuth)];
        let [top, bottom] = [top, bottom].map(|end| base.placed(&end));
        let (name, nodes) = (base.of_blade(k, "pitch link"), [turning.as_str(), node]);
        let Some(stiffness) = self.stiffness else {
            return base
                .joint(&name, "distance", &nodes)
                .with("in", base.name.as_str())
                .with("from", lengths(&bottom))
                .with("at", lengths(&top));
        };
        let stiffness = Content::quantity(stiffness, "N/m");
        let law = if self.damping == 0.0 {
            Content::table([("kind", "linear".into()), ("stiffness", stiffness)])
        } else {
            Content::table([
                ("kind", "viscoelastic".into()),
                ("stiffness", stiffness),
                ("viscosity", Content::quantity(self.damping, "N*s/m")),
            ])
        };
        let center = self.center(base);
        let [x, y] = self.links.horn;
        let ends = [bottom - center, Vector3::new(x - offset, y, 0.0)];
        base.listed("rod")
            .with("name", name)
            .with("nodes", Content::texts(nodes))
            .with("offsets", Content::list(ends.iter().map(lengths)))
            .with("measure", "elongation")
            .with("law", law)
    }
}

/// The guide of a prescribed plate.
fn prescribed(base: &Base, guide: Card, motion: &Motion) -> Card {
    let side = base.side();
    let [height, x, y] = match motion {
        Motion::At([height, x, y]) => [
            Content::quantity(side * height, "m"),
            Content::quantity(side * x, "rad"),
            Content::quantity(side * y, "rad"),
        ],
        Motion::Linear(sums) => [0, 1, 2].map(|i| sums[i].on_side(side).content()),
    };
    guide
        .with("displacement", Content::table([("z", height)]))
        .with("rotation", Content::table([("x", x), ("y", y)]))
}

/// The motion of the plate as expressions, of a pitch without drives by name or table.
fn texts(pitch: &Pitch, sums: &[Sum; 3]) -> Result<[String; 3], Located> {
    if let [Some(height), Some(x), Some(y)] = sums.each_ref().map(Sum::text) {
        return Ok([height, x, y]);
    }
    let controls = [&pitch.collective, &pitch.cosine, &pitch.sine].into_iter();
    let drive = controls.flatten().find_map(Control::drive);
    let (line, key) = drive.unwrap_or((sums[0].line(), COLLECTIVE.name()));
    Err((line, RotorProblem::NotWritten { key }))
}

/// The angle, in declared units, from the plate with scissors to the one that is turned by the rotation vector
/// `(a_x, a_y, 0)`, about their common normal: both have the same pitch of the blades if the rotating plate is
/// turned by it.
///
/// ```text
/// sin delta = (1 - cos a)/a^2 a_x a_y / d                                                      (D-352)
/// ```
fn yaw_text(units: &Units, (motion, pitch): (&Motion, &Pitch)) -> Result<String, Located> {
    let [x, y] = match motion {
        Motion::At([_, x, y]) => [x, y].map(|angle| signed(*angle)),
        Motion::Linear(sums) => {
            let [_, x, y] = texts(pitch, sums)?;
            [x, y].map(|angle| format!("{}*({angle})", signed(units.angle)))
        }
    };
    let square = format!("(({x})^2 + ({y})^2 + 1e-30)");
    let s = format!("sin(sqrt({square}))/sqrt({square})");
    let d = format!("sqrt(1 - ({s}*({x}))^2)");
    // 1 - cos a = 2 sin^2 (a/2), without cancellation.
    let c = format!("2*sin(sqrt({square})/2)^2/{square}");
    Ok(format!("asin({c}*({x})*({y})/{d})/{}", signed(units.angle)))
}

/// The length of an actuator over the motion of the plate, with the normal n of the plate and scissors in the
/// plane of azimuth zero, as [`Actuators::length`]:
///
/// ```text
/// n = ( s a_y, -s a_x, cos a ) ,     s = sin a / a ,     a = |(a_x, a_y)| ,     d^2 = 1 - n_y^2
/// p_z = -r_s/d ( n_x cos psi + n_y n_z sin psi )
/// p_r = r_s ( ( n_z cos psi - n_x n_y sin psi ) cos psi / d + d sin^2 psi )
/// L^2 = r_s^2 + r_b^2 + H^2 + 2 H p_z - 2 r_b p_r ,     H = z_b + h
/// ```
fn length_text(
    base: &Base,
    actuators: &Actuators,
    azimuth: f64,
    [height, about_x, about_y]: &[String; 3],
) -> String {
    let units = &base.units;
    let (sin, cos) = azimuth.sin_cos();
    let [rim, foot, below] = [
        actuators.radius,
        actuators.base_radius,
        actuators.base_below,
    ]
    .map(|length| length / units.length);
    let [x, y] = [about_x, about_y].map(|angle| format!("{}*({angle})", signed(units.angle)));
    // Beside zero, where the sine over the angle is one.
    let angle = format!("sqrt(({x})^2 + ({y})^2 + 1e-30)");
    let [n_x, n_y] =
        [(&y, ""), (&x, "-")].map(|(own, sign)| format!("({sign}sin({angle})/{angle}*{own})"));
    let n_z = format!("cos({angle})");
    let d = format!("sqrt(1 - {n_y}^2)");
    let above = format!("({below} + {height})");
    let rise = format!(
        "{}/{d}*({}*{n_x} + {}*{n_y}*{n_z})",
        signed(-rim),
        signed(cos),
        signed(sin)
    );
    let along = format!(
        "{rim}*(({}*{n_z} - {}*{n_x}*{n_y})*{}/{d} + {}*{d})",
        signed(cos),
        signed(sin),
        signed(cos),
        sin * sin
    );
    let ends = rim * rim + foot * foot;
    format!(
        "= sqrt({ends} + {above}^2 + 2*{above}*{rise} - {}*({along}))",
        2.0 * foot
    )
}

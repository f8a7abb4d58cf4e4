//! A `[[rotor]]` as read, and the cards to which it expands.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::{Card, Content, Table};
use shared_geom::expression::is_name;
use shared_geom::rotation::vector;

use super::arms;
use super::base::{Base, FLAP, Lump, PITCH, Units, angles, lengths};
use super::context::Context;
use super::controls::{Pitch, Sum};
use super::damper;
use super::damper_keys::LAG_DAMPER;
use super::damper_parts::{self, LagDamper};
use super::flexbeam::{self, Bearingless};
use super::flexbeam_keys::{FLEXBEAM, SNUBBER, TORQUE_TUBE};
use super::flexbeam_parts;
use super::held_pitch::HeldPitch;
use super::hubs::{HUBS, HubKind};
use super::keys;
use super::mounts::keys::{NACELLE, PYLON, TOWER};
use super::mounts::{self, Mount};
use super::parts;
use super::pitch;
use super::plate::Plate;
use super::problem::RotorProblem;
use super::shaft::{self, Shaft};
use super::shaft_parts;
use crate::input::moments::moments;
use crate::input::problem::InputProblem;

/// Smallest sine of the angle between the shaft and azimuth zero.
const ALONG: f64 = 1e-3;

/// A rotor.
#[derive(Debug)]
pub(super) struct Rotor {
    /// Its frames and its hub.
    pub base: Base,
    /// Center of the hub \[m\].
    pub center: Vector3<f64>,
    /// Axes of the rotor (columns): aft, across, along the shaft.
    pub axes: Matrix3<f64>,
    /// Its shaft with the drive.
    pub shaft: Shaft,
    /// The pitch that analyses without time hold.
    pub held: Option<HeldPitch>,
    /// Mount of the shaft, and the node that holds it.
    mount: Option<(Mount, Option<String>)>,
    hub: &'static HubKind,
    body: Option<Lump>,
    blade: Vec<(String, Content)>,
    /// Pitch of the blades on their bearings \[rad\].
    fixed_pitch: f64,
    pitch: Option<Pitch>,
    control: pitch::Control,
    plate: Option<Plate>,
    flexbeam: Option<Bearingless>,
    lag_damper: Option<LagDamper>,
    inflow: Option<Vec<(String, Content)>>,
}

/// The azimuth of the first blade \[rad\]; notes one that is not within a turn.
fn azimuth(table: &Table<'_>, context: &Context) -> Option<f64> {
    let azimuth = table.get(&keys::AZIMUTH)?;
    if azimuth.abs() > TAU * (1.0 + f64::EPSILON) {
        let turns = azimuth / TAU;
        table.note(&keys::AZIMUTH, &RotorProblem::Azimuth { turns });
        context.refuse();
    }
    Some(azimuth)
}

/// Reads a rotor; `None` if it is wrong.
pub(super) fn read(table: &Table<'_>, context: &Context) -> Option<Rotor> {
    let name = name(table);
    let hub = table.get(&keys::HUB).map(|index| &HUBS[index]);
    let (azimuth, count) = (azimuth(table, context), table.get(&keys::BLADES));
    let shown = name.clone().unwrap_or_default();
    let placement = placement(table, &shown, context);
    let shaft = shaft_parts::read(table, &shown, context);
    let (body, blade) = (body(table, &shown), parts::blade(table));
    let inflow = parts::inflow(table, &shown);
    let (undersling, link) = (table.get(&keys::UNDERSLING), table.get(&keys::LINK));
    let cone = [blade.as_ref().map(|own| own.precone), undersling].map(Option::unwrap_or_default);
    let controls = parts::controls(table, (&shown, cone), context);
    let (tilt, yoke) = (parts::tilt(table), parts::yoke(table, &shown));
    let root = blade.as_ref().map_or(f64::INFINITY, |blade| blade.radius);
    let hinges = parts::hinges(table, root);
    let flexbeam = flexbeam_parts::read(table, &shown, root);
    let lag_damper = damper_parts::between(table, &shown);
    table.finish();
    let (hub, shaft, blade) = (hub?, shaft?, blade?);
    let (mut controls, flexbeam, placement) = (controls?, flexbeam?, placement?);
    let mut base = Base {
        name: name?,
        line: table.line(),
        carrier: placement.carrier,
        count: count?,
        azimuth: azimuth?,
        precone: blade.precone,
        pitch: 0.0,
        undersling: undersling?,
        link: link?,
        mirror: placement.mirror,
        spin: context.moves.then_some(shaft.given.unwrap_or(0.0)),
        tilt: tilt?.unwrap_or_default(),
        yoke: yoke?,
        has_flexbeam: flexbeam.is_some(),
        hinges: hinges?,
        units: Units::of(table.document()),
    };
    controls.build_in(&mut base, root);
    let held = HeldPitch::of(controls.pitch.as_ref(), (&base, &shaft), (table, context));
    let rotor = Rotor {
        center: placement.center,
        axes: placement.axes,
        mount: placement.mount,
        shaft,
        held,
        hub,
        body: body?,
        fixed_pitch: blade.pitch,
        blade: blade.keys,
        control: controls.control(hub.tilts),
        pitch: controls.pitch,
        plate: controls.plate,
        flexbeam,
        lag_damper: lag_damper?,
        inflow: inflow?,
        base,
    };
    is_sound(&rotor, table).then_some(rotor)
}

/// Hub frame of a rotor, and its mount.
struct Placement {
    center: Vector3<f64>,
    axes: Matrix3<f64>,
    /// Whether the rotor is the mirror image of one with these axes.
    mirror: bool,
    /// Node that carries the shaft.
    carrier: Option<String>,
    /// Mount of the shaft, and the node that holds it.
    mount: Option<(Mount, Option<String>)>,
}

fn placement(table: &Table<'_>, name: &str, context: &Context) -> Option<Placement> {
    let (carrier, center) = (table.get(&keys::NODE), table.get(&keys::CENTER));
    let clockwise = table.get(&keys::DIRECTION).map(|index| index == 1);
    let (axes, mount) = (axes(table, clockwise), mounts::read(table, name, context));
    let (carrier, center, axes, mount) = (carrier?, center?, axes?, mount?);
    let mirror = clockwise?;
    let Some(mount) = mount else {
        return Some(Placement {
            center,
            axes,
            mirror,
            carrier,
            mount: None,
        });
    };
    let frame = mount.hub_frame(table)?;
    Some(Placement {
        center: frame.center,
        axes: axes_of(table, &along(frame.axis, mirror), &frame.aft)?,
        mirror,
        carrier: Some(mount.node(name)),
        mount: Some((mount, carrier)),
    })
}

/// The name, which must be a part of names in expressions.
fn name(table: &Table<'_>) -> Option<String> {
    let name = table.get(&keys::NAME)?;
    if is_name(&name) {
        return Some(name);
    }
    table.note(&keys::NAME, &RotorProblem::Name { name });
    None
}

/// Axes of a rotor by the keys of its card.
fn axes(table: &Table<'_>, clockwise: Option<bool>) -> Option<Matrix3<f64>> {
    let (axis, aft) = (table.get(&keys::AXIS), table.get(&keys::AFT));
    let is_mounted = [TOWER.name(), NACELLE.name(), PYLON.name()];
    if is_mounted.into_iter().any(|key| table.has(key)) {
        return Some(Matrix3::identity());
    }
    axes_of(table, &along(axis?, clockwise?), &aft?)
}

/// The direction of the rotation vector: against the axis of a clockwise rotor.
fn along(axis: Vector3<f64>, clockwise: bool) -> Vector3<f64> {
    if clockwise { -axis } else { axis }
}

/// Axes of a rotor: aft, across, along the shaft.
fn axes_of(table: &Table<'_>, axis: &Vector3<f64>, aft: &Vector3<f64>) -> Option<Matrix3<f64>> {
    if axis.amax() == 0.0 {
        table.note(&keys::AXIS, &InputProblem::NoAxis);
        return None;
    }
    let axis = (axis / axis.amax()).normalize();
    let across = aft - axis * axis.dot(aft);
    if across.norm() <= ALONG * aft.norm() {
        table.note(&keys::AFT, &RotorProblem::AftAlongAxis);
        return None;
    }
    let x = across.normalize();
    Some(Matrix3::from_columns(&[x, axis.cross(&x), axis]))
}

/// The body of the hub; `Some(None)` without mass.
fn body(table: &Table<'_>, name: &str) -> Option<Option<Lump>> {
    let mass = table.get(&keys::MASS);
    let inertia = moments(table, name);
    let (mass, inertia) = (mass?, inertia?);
    if mass == 0.0 && inertia.amax() > 0.0 {
        let (name, key, needed) = (name.to_owned(), "inertia", keys::MASS.name());
        table.note(key, &RotorProblem::Idle { name, key, needed });
        return None;
    }
    Some((mass > 0.0).then_some((mass, inertia)))
}

/// Whether the parts of a rotor fit each other; notes the first problem.
fn is_sound(rotor: &Rotor, table: &Table<'_>) -> bool {
    let of_pitch = || Some((keys::SWASHPLATE.name(), pitch_problem(rotor)?));
    let of_damper = || Some((LAG_DAMPER.name(), damper_problem(rotor)?));
    let of_coupling = || Some((keys::PITCH_LINK.name(), coupling_problem(rotor)?));
    let found = hub_problem(rotor, table)
        .or_else(of_pitch)
        .or_else(of_coupling)
        .or_else(of_damper);
    if let Some((key, problem)) = &found {
        table.note(key, problem);
        return false;
    }
    let unwritten = unwritten(rotor);
    if let Some((line, key)) = unwritten {
        let problem = RotorProblem::NotWritten { key };
        table.document().note(line, &problem);
    }
    unwritten.is_none()
}

/// A pitch-flap coupling without a flap hinge inboard of the pitch bearing.
fn coupling_problem(rotor: &Rotor) -> Option<RotorProblem> {
    let base = &rotor.base;
    let mut inboard = base.hinges.iter().take_while(|hinge| hinge.kind != PITCH);
    let flaps = inboard.any(|hinge| hinge.kind == FLAP);
    let is_idle = matches!(&rotor.control, pitch::Control::Bearing(link) if link.delta_3 != 0.0);
    (is_idle && !flaps && !base.has_flexbeam).then(|| RotorProblem::Hub {
        hub: rotor.hub.word,
        found: "has \"delta_3\" without a flap hinge inboard of the pitch bearing".to_owned(),
        expected: "[[rotor.hinge]] with kind = \"flap\", or a hub that tilts",
    })
}

/// Line and key of a drive in a pitch that must be an expression.
fn unwritten(rotor: &Rotor) -> Option<(usize, &'static str)> {
    let (pitch, has_plate) = (rotor.pitch.as_ref()?, rotor.plate.is_some());
    let is_sensed = pitch.is_cyclic() && rotor.shaft.is_free();
    pitch.drive_in_sensed_sum(has_plate, is_sensed && !has_plate)
}

/// The first key that the hub does not have, or else its first problem, with the key.
fn hub_problem(rotor: &Rotor, table: &Table<'_>) -> Option<(&'static str, RotorProblem)> {
    const TILTING: &[&str] = &["teetering", "gimballed"];
    const BEARINGLESS: &[&str] = &["bearingless"];
    const HINGED: &[&str] = &[
        "rigid",
        "hingeless",
        "articulated",
        "teetering",
        "gimballed",
    ];
    let hub = rotor.hub;
    let keys: [(&str, &[&str]); 8] = [
        (keys::HINGES.name(), HINGED),
        (FLEXBEAM.name(), BEARINGLESS),
        (TORQUE_TUBE.name(), BEARINGLESS),
        (SNUBBER.name(), BEARINGLESS),
        (keys::UNDERSLING.name(), &["teetering"]),
        (keys::LINK.name(), &["gimballed"]),
        (keys::TILT.name(), TILTING),
        (keys::YOKE.name(), TILTING),
    ];
    let mut wrong = keys.into_iter();
    let wrong = wrong.find(|(key, kinds)| table.has(key) && !kinds.contains(&hub.word));
    if let Some((key, kinds)) = wrong {
        let hub = hub.word;
        return Some((key, RotorProblem::NotOfHub { hub, key, kinds }));
    }
    Some((keys::HUB.name(), (hub.problem)(&rotor.base)?))
}

/// A damper on a part that the blades do not have.
fn damper_problem(rotor: &Rotor) -> Option<RotorProblem> {
    let damper = rotor.lag_damper.as_ref()?;
    if damper.is_between_blades && rotor.base.count == 1 {
        return Some(RotorProblem::NoPartOfDamper {
            name: rotor.base.name.clone(),
            key: "between",
            word: "blades",
            lacks: "one blade",
        });
    }
    let on_lag = damper.on_root == Some(false);
    (on_lag && arms::lagging(&rotor.base, 0).is_none()).then(|| RotorProblem::NoPartOfDamper {
        name: rotor.base.name.clone(),
        key: "on",
        word: "lag",
        lacks: "no lag hinge",
    })
}

/// The first problem of the pitch.
fn pitch_problem(rotor: &Rotor) -> Option<RotorProblem> {
    let base = &rotor.base;
    let pitch = rotor.pitch.as_ref()?;
    let (found, expected) = (pitch.individual.len(), base.count);
    if found != 0 && found != expected {
        return Some(RotorProblem::Individual { found, expected });
    }
    let is_cyclic = pitch.is_cyclic() && rotor.plate.is_none();
    if let (true, Err(reason)) = (is_cyclic, rotor.shaft.azimuth(base)) {
        return Some(RotorProblem::NoAzimuth { reason });
    }
    if !matches!(rotor.control, pitch::Control::Prescribed) {
        return None;
    }
    let reason = match rotor.shaft.is_free() {
        true if is_cyclic => "its azimuth is a result, whose acceleration is not known",
        _ if rotor.hub.tilts => "the hub tilts against the swashplate",
        _ if has_spring(base) => "its hinge has a spring or damper",
        _ => return None,
    };
    let name = base.name.clone();
    Some(RotorProblem::NeedsLink { name, reason })
}

/// Whether the pitch bearing has a spring or damper of its own.
fn has_spring(base: &Base) -> bool {
    let mut bearings = base.hinges.iter().filter(|hinge| hinge.kind == PITCH);
    bearings.any(|hinge| hinge.restraint.stiffness != 0.0 || hinge.restraint.damping != 0.0)
}

impl Rotor {
    /// Whether a nacelle carries its shaft.
    pub fn has_nacelle(&self) -> bool {
        matches!(self.mount, Some((Mount::Turbine(_), _)))
    }

    /// Whether its blades have strips in the air.
    pub fn has_air(&self) -> bool {
        self.blade.iter().any(|(key, _)| key == parts::AERODYNAMICS)
    }

    /// All cards; `has_hub` if the input has a `[hub]`, or other rotors.
    ///
    /// # Errors
    /// A pitch that the swashplate cannot give, with its line.
    pub fn cards(&self, has_hub: bool) -> Result<Vec<Card>, (usize, RotorProblem)> {
        let base = &self.base;
        let mut cards = Vec::new();
        if let Some((mount, holder)) = &self.mount {
            cards.extend(mount.cards(base, holder.as_deref()));
        }
        if !has_hub {
            cards.push(
                Card::single(["hub"], base.line)
                    .with(
                        "axis",
                        Content::numbers(self.axes.column(2).iter().copied()),
                    )
                    .with("center", lengths(&self.center)),
            );
        }
        cards.push(
            base.listed("frame")
                .with("name", base.name.as_str())
                .with("position", lengths(&self.center))
                .with("orientation", angles(&vector::from_rotation(&self.axes))),
        );
        let is_cyclic = self.pitch.as_ref().is_some_and(Pitch::is_cyclic);
        let senses = is_cyclic && self.plate.is_none();
        cards.extend(shaft::cards(base, &self.shaft, self.body.as_ref(), senses));
        let (yoke, tilt) = (self.hub.yoke)(base);
        cards.extend(tilt);
        let pitch = self.pitch.clone().unwrap_or_default();
        if let Some(plate) = &self.plate {
            cards.extend(plate.cards(base, &pitch, &self.shaft)?);
        }
        for k in 0..base.count {
            let azimuth = self.shaft.azimuth(base).ok();
            let azimuth = azimuth.map(|text| format!("{text} + {}", base.azimuth_of(k)));
            let command = pitch.of_blade(k, azimuth.as_deref());
            cards.extend(self.arm(k, &yoke, &command));
        }
        cards.extend(self.inflow.as_ref().map(|keys| {
            base.listed("inflow")
                .with("name", base.name.as_str())
                .with("hub", base.hub())
                .with(
                    "axis",
                    Content::numbers(self.axes.column(2).iter().copied()),
                )
                .with_all(keys.iter().cloned())
        }));
        cards.extend(arms::blades(base, &self.blade_keys()));
        let flexbeam = self.flexbeam.iter();
        cards.extend(flexbeam.flat_map(|flexbeam| flexbeam.lines(base)));
        Ok(cards)
    }

    /// The parts between the yoke and blade `k`, with the control of its pitch.
    fn arm(&self, k: usize, yoke: &str, command: &Sum) -> Vec<Card> {
        let (base, control) = (&self.base, (&self.control, command));
        let (mut cards, pitched) = match &self.flexbeam {
            Some(flexbeam) => (
                flexbeam.cards(base, (k, yoke), control),
                Some((flexbeam::pitch_node(base, k), flexbeam.tube.offset())),
            ),
            None => (
                arms::cards(base, (k, yoke), control),
                arms::feathering(base, k),
            ),
        };
        let link = self.plate.as_ref().zip(pitched);
        cards.extend(link.map(|(plate, (node, offset))| plate.link(base, k, (&node, offset))));
        let dampers = self.lag_damper.iter().flat_map(|own| {
            let part = |k: usize| {
                let lagging = arms::lagging(base, k).filter(|_| own.on_root != Some(true));
                lagging.unwrap_or_else(|| base.of_blade(k, "root"))
            };
            let (own_part, next) = (part(k), part((k + 1) % base.count));
            match own.is_between_blades {
                // Two blades have one damper between them.
                true if base.count == 2 && k == 1 => Vec::new(),
                true => damper::of_blades(base, (k, [&next, &own_part]), &own.ends, &own.law),
                false => damper::of_ends(base, (k, [yoke, &own_part]), &own.ends, &own.law),
            }
        });
        cards.extend(dampers);
        cards
    }

    /// The keys of the blade, with the inflow of the rotor.
    fn blade_keys(&self) -> Vec<(String, Content)> {
        let pitch = self.fixed_pitch + self.base.pitch;
        let pitch = (parts::PITCH_KEY.to_owned(), Content::quantity(pitch, "rad"));
        let keys = self.blade.iter().cloned().chain([pitch]);
        keys.map(|(key, content)| match (key.as_str(), &self.inflow) {
            (parts::AERODYNAMICS, Some(_)) => {
                let content = content.with("inflow", self.base.name.as_str());
                (key, content)
            }
            _ => (key, content),
        })
        .collect()
    }
}

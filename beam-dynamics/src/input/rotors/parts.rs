//! The tables of a `[[rotor]]`: blade, hinges, tilt, swashplate and links.

use shared_geom::document::schema::TableSchema;
use shared_geom::document::{Content, Table};
use shared_geom::units::Dimension;
use std::collections::BTreeSet;
use std::f64::consts::{PI, TAU};

use super::base::{Base, Hinge, Lump, PITCH, Restraint, Stop};
use super::context::Context;
use super::controls::{self, Pitch, Wanted};
use super::damper_parts;
use super::distributor::{Actuators, Links};
use super::keys::{
    ACTUATORS, AZIMUTHS, BASE_BELOW, BASE_RADIUS, BELOW, BLADE, COLLECTIVE, CONTROL_STIFFNESS,
    COSINE, DAMPING, DELTA_3, HARMONIC, HINGES, HORN, INDIVIDUAL, INFLOW, KIND, KINDS,
    LINK_DAMPING, LINK_STIFFNESS, LOWER, OFFSET, ORDER, PITCH_LINK, PLATE, RADIUS, SINE, STIFFNESS,
    STOP, STOP_DAMPING, STOP_STIFFNESS, SWASHPLATE, TILT, UPPER, WIDTH, YOKE, YOKE_MASS,
};
use super::pitch::{Control, Link};
use super::plate::Plate;
use super::problem::RotorProblem;
use crate::elements::Smoothness;
use crate::input::aerodynamics::OF_ROTOR as OF_INFLOW;
use crate::input::blades::{HUB_RADIUS, OF_ROTOR as OF_BLADE};
use crate::input::moments::moments;

/// The key of the fixed pitch of a blade.
pub(super) const PITCH_KEY: &str = "pitch";
/// The key of the strips of a blade.
pub(super) const AERODYNAMICS: &str = "aerodynamics";
/// Largest `delta_3` \[rad\]: its tangent is near six.
const STEEPEST: f64 = 80.0 * PI / 180.0;
/// Least distance of the azimuths of actuators \[rad\].
const APART: f64 = 1e-3;
/// Keys of `[[blade]]` that follow from the rotor.
const OF_ROTOR: [&str; 13] = [
    "name",
    "count",
    "azimuth",
    "azimuths",
    "names",
    "hinges",
    "root",
    "clamp_root",
    "in",
    "velocity",
    "angular_velocity",
    "initial_weight",
    "velocity_weight",
];

/// The blade of a rotor.
pub(super) struct Blade {
    /// Its keys.
    pub keys: Vec<(String, Content)>,
    /// Radius of its root \[m\].
    pub radius: f64,
    /// Cone angle \[rad\].
    pub precone: f64,
    /// Fixed pitch \[rad\].
    pub pitch: f64,
}

/// Reads `[rotor.blade]`, whose keys the reader of `[[blade]]` checks.
pub(super) fn blade(table: &Table<'_>) -> Option<Blade> {
    table.require_item(&BLADE, "a table with the keys of [[blade]]")?;
    let blade = table.table(&BLADE)?;
    let keys = blade.keys();
    let wrong: Vec<_> = keys
        .iter()
        .filter(|key| OF_ROTOR.contains(&key.as_str()))
        .collect();
    for key in &wrong {
        let problem = RotorProblem::OfBlade {
            key: (*key).clone(),
        };
        blade.note(key, &problem);
    }
    if !wrong.is_empty() {
        return None;
    }
    let number = |key: &str, dimension| {
        if blade.has(key) {
            blade.quantity(key, dimension)
        } else {
            Some(0.0)
        }
    };
    let radius = blade.get(&HUB_RADIUS);
    let precone = number("precone", Dimension::ANGLE);
    let pitch = number(PITCH_KEY, Dimension::ANGLE);
    let mut keys = passed_on(&blade, &OF_BLADE);
    keys.retain(|(key, _)| key != PITCH_KEY);
    Some(Blade {
        keys,
        radius: radius?,
        precone: precone?,
        pitch: pitch?,
    })
}

/// The keys of a table that another card has, which checks their values; notes unknown ones.
pub(super) fn passed_on(table: &Table<'_>, of: &'static TableSchema) -> Vec<(String, Content)> {
    let known: BTreeSet<_> = of.all_keys().map(|key| key.name).collect();
    let keys = known.into_iter();
    let found = keys.filter_map(|key| Some((key.to_owned(), table.copied(key)?)));
    let found = found.collect();
    table.finish();
    found
}

/// Reads `[rotor.inflow]`; `Some(None)` without it.
pub(super) fn inflow(table: &Table<'_>, name: &str) -> Option<Option<Vec<(String, Content)>>> {
    if !table.has(&INFLOW) {
        return Some(None);
    }
    let inflow = table.table(&INFLOW)?;
    let blade = table
        .is_table(&BLADE)
        .then(|| table.table(&BLADE))
        .flatten();
    let air = blade.filter(|blade| blade.is_table(AERODYNAMICS));
    let air = air.and_then(|blade| blade.table(AERODYNAMICS));
    let (name, key) = (name.to_owned(), INFLOW.name());
    let problem = match air {
        None => RotorProblem::Idle {
            name,
            key,
            needed: "aerodynamics of [rotor.blade]",
        },
        Some(air) if air.has("inflow") => RotorProblem::Both {
            name,
            key,
            other: "inflow of [rotor.blade.aerodynamics]",
        },
        Some(_) => {
            return Some(Some(passed_on(&inflow, &OF_INFLOW)));
        }
    };
    table.note(&INFLOW, &problem);
    None
}

/// Reads `[rotor.tilt]`.
pub(super) fn tilt(table: &Table<'_>) -> Option<Option<Restraint>> {
    table.nested(&TILT, restraint)
}

/// Reads `[rotor.yoke]`.
pub(super) fn yoke(table: &Table<'_>, name: &str) -> Option<Option<Lump>> {
    table.nested(&YOKE, |table| {
        let (mass, inertia) = (table.get(&YOKE_MASS), moments(table, name));
        Some((mass?, inertia?))
    })
}

/// Spring, damper and stop.
fn restraint(table: &Table<'_>) -> Option<Restraint> {
    let (stiffness, damping) = (table.get(&STIFFNESS), table.get(&DAMPING));
    let stop = table.nested(&STOP, stop);
    Some(Restraint {
        stiffness: stiffness?,
        damping: damping?,
        stop: stop?,
    })
}

fn stop(table: &Table<'_>) -> Option<Stop> {
    let (lower, upper) = (table.get(&LOWER), table.get(&UPPER));
    let (stiffness, damping) = (table.get(&STOP_STIFFNESS), table.get(&STOP_DAMPING));
    let width = table.get(&WIDTH);
    let (lower, upper) = (lower?, upper?);
    let found = match (lower, upper) {
        (None, None) => Some("no angle"),
        (Some(lower), Some(upper)) if lower >= upper => Some("\"lower\" not below \"upper\""),
        _ => None,
    };
    if let Some(found) = found {
        table.note("", &RotorProblem::Stop { found });
        return None;
    }
    Some(Stop {
        lower,
        upper,
        stiffness: stiffness?,
        damping: damping?,
        width: width?,
    })
}

/// Reads the hinges of a rotor whose blades begin at the radius `root` \[m\].
pub(super) fn hinges(table: &Table<'_>, root: f64) -> Option<Vec<Hinge>> {
    let mut before = None;
    // Places and kinds of hinges without a spring.
    let mut free: Vec<(f64, usize)> = Vec::new();
    table.each(&HINGES, |table| {
        let (kind, offset) = (table.get(&KIND), table.get(&OFFSET));
        let restraint = restraint(table);
        let damper = damper_parts::of_hinge(table);
        let (kind, offset) = (kind?, offset?);
        let offset = offset.or(before).unwrap_or(root);
        let from = before.unwrap_or(0.0);
        if offset < from || offset > root {
            let problem = RotorProblem::HingeOrder {
                hinge: format!("the {} hinge", KINDS[kind]),
                found: offset,
                from,
                to: root,
            };
            table.note(&OFFSET, &problem);
            return None;
        }
        before = Some(offset);
        let (restraint, damper) = (restraint?, damper?);
        if restraint.stiffness == 0.0 && damper.is_none() {
            if free.contains(&(offset, kind)) {
                let kind = KINDS[kind];
                table.note(KIND.name(), &RotorProblem::HingesAlike { kind, offset });
                return None;
            }
            free.push((offset, kind));
        }
        Some(Hinge {
            kind,
            offset,
            restraint,
            has_stiffness: table.has(STIFFNESS.name()),
            damper,
        })
    })
}

/// Adds a pitch bearing at the root, unless there is one.
fn add_bearing(hinges: &mut Vec<Hinge>, root: f64) {
    if hinges.iter().all(|hinge| hinge.kind != PITCH) {
        hinges.push(Hinge {
            kind: PITCH,
            offset: root,
            restraint: Restraint::default(),
            has_stiffness: false,
            damper: None,
        });
    }
}

/// The control of the pitch.
pub(super) struct Controls {
    /// The commanded pitch, if there is a swashplate.
    pub pitch: Option<Pitch>,
    /// Plates and links as parts.
    pub plate: Option<Plate>,
    link: Option<Link>,
}

impl Controls {
    /// Gives a rotor the pitch of the undeformed model and a pitch bearing. Flexbeams are built
    /// without pitch and have no bearing.
    pub fn build_in(&mut self, base: &mut Base, root: f64) {
        let Some(pitch) = &mut self.pitch else {
            return;
        };
        if base.has_flexbeam {
            pitch.built_in = 0.0;
            return;
        }
        base.pitch = pitch.built_in * base.units.angle;
        add_bearing(&mut base.hinges, root);
    }

    /// The control of the bearings of a hub, which may tilt.
    pub fn control(&self, tilts: bool) -> Control {
        match (&self.pitch, &self.plate, self.link) {
            (None, _, _) | (_, Some(_), _) => Control::Free,
            (_, _, None) => Control::Prescribed,
            (_, _, Some(link)) if tilts => Control::Coupled(link),
            (_, _, Some(link)) => Control::Bearing(link),
        }
    }
}

/// Reads `[rotor.swashplate]` and `[rotor.pitch_link]` of the rotor called `name`, whose blades have
/// a cone angle \[rad\] and an undersling \[m\].
pub(super) fn controls(
    table: &Table<'_>,
    (name, cone): (&str, [f64; 2]),
    context: &Context,
) -> Option<Controls> {
    // Without links, bearings or plates have the commanded motion.
    let needed = if table.has(&PITCH_LINK) {
        Smoothness::Value
    } else {
        Smoothness::Acceleration
    };
    let found = table.nested(&SWASHPLATE, |table| {
        swashplate(table, cone, (context, needed))
    });
    let link = table.nested(&PITCH_LINK, |table| {
        let (stiffness, damping) = (table.get(&CONTROL_STIFFNESS), table.get(&DAMPING));
        let delta_3 = table.get(&DELTA_3)?;
        if delta_3.abs() > STEEPEST {
            let degrees = delta_3.to_degrees();
            table.note(&DELTA_3, &RotorProblem::Steep { degrees });
            return None;
        }
        Some(Link {
            stiffness: stiffness?,
            damping: damping?,
            delta_3,
        })
    });
    let (found, link) = (found?, link?);
    let (pitch, plate) = found.unzip();
    let controls = Controls {
        pitch,
        plate: plate.flatten(),
        link,
    };
    let (name, key) = (name.to_owned(), PITCH_LINK.name());
    let problem = match (&controls.pitch, &controls.plate, link) {
        (None, _, Some(_)) => RotorProblem::Idle {
            name,
            key,
            needed: SWASHPLATE.name(),
        },
        (_, Some(_), Some(_)) => RotorProblem::Both {
            name,
            key,
            other: "plate of [rotor.swashplate]",
        },
        _ => return Some(controls),
    };
    table.note(key, &problem);
    None
}

fn swashplate(
    table: &Table<'_>,
    cone: [f64; 2],
    wanted: Wanted<'_>,
) -> Option<(Pitch, Option<Plate>)> {
    let control = |table: &Table<'_>, key| controls::read(table, key, wanted);
    let [collective, cosine, sine] =
        [&COLLECTIVE, &COSINE, &SINE].map(|key| control(table, &key.schema));
    let harmonics = table.each(&HARMONIC, |table| {
        let order = table.get(&ORDER);
        let [cosine, sine] = [&COSINE, &SINE].map(|key| control(table, &key.schema));
        Some((order?, [cosine?, sine?]))
    });
    let individual = controls::list(table, &INDIVIDUAL.schema, wanted);
    let plate = table.nested(&PLATE, |table| plate(table, cone));
    let collective = collective?;
    // Links of plates have their undeformed length without pitch.
    let built_in = collective.as_ref().filter(|_| !table.has(&PLATE));
    let constants = wanted.0.constants(table.document());
    let built_in = built_in.and_then(|control| control.at_start(&constants));
    let pitch = Pitch {
        built_in: built_in.unwrap_or(0.0),
        collective,
        cosine: cosine?,
        sine: sine?,
        harmonics: harmonics?,
        individual: individual?,
    };
    let plate = plate?;
    let others = [
        (INDIVIDUAL.name(), !pitch.individual.is_empty()),
        (HARMONIC.name(), !pitch.harmonics.is_empty()),
    ];
    if let (Some((key, _)), Some(_)) = (others.iter().find(|one| one.1), &plate) {
        let (name, other) = (table.title().to_owned(), PLATE.name());
        table.note(key, &RotorProblem::Both { name, key, other });
        return None;
    }
    Some((pitch, plate))
}

fn plate(table: &Table<'_>, [precone, undersling]: [f64; 2]) -> Option<Plate> {
    let (below, horn) = (table.get(&BELOW), table.get(&HORN));
    let (stiffness, damping) = (table.get(&LINK_STIFFNESS), table.get(&LINK_DAMPING));
    let actuators = table.nested(&ACTUATORS, |table| {
        let (radius, base_radius) = (table.get(&RADIUS), table.get(&BASE_RADIUS));
        let (base_below, azimuths) = (table.get(&BASE_BELOW), table.get(&AZIMUTHS));
        let azimuths = azimuths?;
        let apart = |a: f64, b: f64| ((a - b + PI).rem_euclid(TAU) - PI).abs() > APART;
        let different = azimuths.iter().enumerate();
        let different = different.filter(|(i, a)| azimuths[..*i].iter().all(|b| apart(**a, *b)));
        let found = [azimuths.len(), different.count()];
        if found != [3, 3] {
            table.note(&AZIMUTHS, &RotorProblem::Actuators { found });
            return None;
        }
        Some(Actuators {
            radius: radius?,
            base_radius: base_radius?,
            base_below: base_below?,
            azimuths,
        })
    });
    let horn = horn?;
    if horn[1] == 0.0 {
        table.note(&HORN, &RotorProblem::NoLever);
        return None;
    }
    let links = Links {
        below: below?,
        horn,
        precone,
        undersling,
    };
    let needed = -links.top(0.0, 0.0).z;
    if links.below <= needed {
        let found = links.below;
        table.note(&BELOW, &RotorProblem::NoLength { found, needed });
        return None;
    }
    let (stiffness, damping) = (stiffness?, damping?);
    if stiffness.is_none() && damping != 0.0 {
        let name = table.title().to_owned();
        let (key, needed) = (LINK_DAMPING.name(), LINK_STIFFNESS.name());
        table.note(key, &RotorProblem::Idle { name, key, needed });
        return None;
    }
    Some(Plate {
        links,
        stiffness,
        damping,
        actuators: actuators?,
    })
}

//! Wind conditions of IEC 61400-1: `[air.event]`.

use rotor_aero::wind::{Event, EventShape, IecTurbine, MeanWind, TurbulenceCategory, WindClass};
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Boolean, Count, Positive, Quantity, Word};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::mean::MeanCard;
use super::problem::AirProblem;
use crate::input::number::short_number;

keys! {
    /// A wind condition of IEC 61400-1 ed. 3, for the class of a turbine and the speed of the mean wind
    /// at the hub.
    pub(super) CARD = "[air.event]";
    /// Operating gust (EOG), direction change (EDC), coherent gust with direction change (ECD),
    /// vertical or horizontal shear (EWS); steady extreme wind with a recurrence period of 50 years or
    /// 1 year (EWM); normal or extreme turbulence (NTM, ETM).
    pub(super) KIND: usize = "kind", [Word(&KINDS)], required, "\"EOG\"";
    /// Class of the turbine; of class S, the reference speed is given.
    CLASS: usize = "class", [Word(&["I", "II", "III", "S"])], required, "\"I\"";
    /// Category of turbulence; of category S, the intensity is given.
    CATEGORY: usize = "category", [Word(&["A", "B", "C", "S"])], required, "\"A\"";
    /// Reference speed of class S, averaged over 10 minutes.
    REFERENCE_SPEED: Option<f64> = "reference_speed", [Positive(Dimension::VELOCITY)], optional,
        "45";
    /// Turbulence intensity of category S, at 15 m/s.
    INTENSITY: Option<f64> = "intensity", [Positive(Dimension::NUMBER)], optional, "0.18";
    /// Height of the hub above the ground.
    HUB_HEIGHT: f64 = "hub_height", [Positive(Dimension::LENGTH)], required, "90";
    /// Diameter of the rotor.
    DIAMETER: f64 = "diameter", [Positive(Dimension::LENGTH)], required, "126";
    /// Time at which it begins.
    START: f64 = "start", [Quantity(Dimension::TIME)], or "0" = 0.0, "10";
    /// Whether direction change and shear have the other sign.
    REVERSED: bool = "reversed", [Boolean], or "false" = false, "true";
    /// Seed of generated turbulence.
    SEED: usize = "seed", [Count(1_000_000_000)], or "1" = 1, "7";
    /// Duration of generated turbulence, after which it begins again.
    pub(super) DURATION: f64 = "duration", [Positive(Dimension::TIME)], or "600 s" = 600.0, "100";
    /// Time between planes of generated turbulence.
    pub(super) TIME_STEP: f64 = "time_step", [Positive(Dimension::TIME)], or "0.25 s" = 0.25, "0.1";
    /// Number of points of generated turbulence across the wind, and over the height.
    pub(super) POINTS: usize = "points", [Count(64)], or "9" = 9, "15";
    /// Width and height of generated turbulence, whose middle is at the hub.
    pub(super) WIDTH: Option<f64> = "width", [Positive(Dimension::LENGTH)], or "1.2 diameters, above the ground",
        "160";
}

/// Words of the conditions: events, steady winds, and turbulence.
const KINDS: [&str; 9] = [
    "EOG",
    "EDC",
    "ECD",
    "EWS vertical",
    "EWS horizontal",
    "EWM 50",
    "EWM 1",
    "NTM",
    "ETM",
];

/// Keys of events alone, and of generated turbulence alone.
const OF_EVENTS: [&str; 2] = [START.name(), REVERSED.name()];
const OF_TURBULENCE: [&str; 5] = [
    SEED.name(),
    DURATION.name(),
    TIME_STEP.name(),
    POINTS.name(),
    WIDTH.name(),
];

/// Width of generated turbulence, in diameters of the rotor \[-\].
const WIDTH_OF_ROTOR: f64 = 1.2;
/// Part of the height of the hub that half of this width is at most.
const ABOVE_GROUND: f64 = 0.99;

/// A wind condition.
#[derive(Debug)]
pub(super) enum Condition {
    /// An event of the mean wind.
    Event(Event),
    /// A mean wind over the height.
    Profile(MeanWind),
    /// Turbulence.
    Turbulent(Turbulent),
}

/// Turbulence of a condition.
#[derive(Debug)]
pub(super) struct Turbulent {
    /// The turbine.
    pub turbine: IecTurbine,
    /// Whether it is extreme.
    is_extreme: bool,
    /// The box to be generated.
    pub generated: GeneratedBox,
}

/// Sizes of a box to be generated.
#[derive(Debug)]
pub(super) struct GeneratedBox {
    /// Seed.
    pub seed: u64,
    /// Duration \[s\].
    pub duration: f64,
    /// Time between planes \[s\].
    pub time_step: f64,
    /// Points across, and over the height.
    pub points: usize,
    /// Width and height \[m\].
    pub width: f64,
}

impl Turbulent {
    /// Standard deviation of u at the hub speed \[m/s\].
    pub fn sigma(&self, speed: f64) -> f64 {
        if self.is_extreme {
            self.turbine.extreme_sigma(speed)
        } else {
            self.turbine.normal_sigma(speed)
        }
    }
}

/// Reads the table. Without a mean wind, only the keys are checked.
pub(super) fn read(table: &Table<'_>, mean: Option<&MeanCard>, has_box: bool) -> Option<Condition> {
    let (kind, turbine) = (table.get(&KIND), turbine(table));
    let (start, reversed) = (table.get(&START), table.get(&REVERSED));
    let generated = generated(table);
    table.finish();
    let (kind, turbine) = (kind?, turbine?);
    let (is_event, is_steady) = (kind < 5, (5..7).contains(&kind));
    let lists = [
        (is_event, &OF_EVENTS[..], "it belongs to events"),
        (
            !is_event && !is_steady && !has_box,
            &OF_TURBULENCE[..],
            "it belongs to NTM and ETM without [air.turbulence]",
        ),
    ];
    let mut is_sound = true;
    for (has_effect, keys, reason) in lists {
        for key in keys.iter().filter(|key| !has_effect && table.has(key)) {
            let _: Option<()> = useless(table, key, reason);
            is_sound = false;
        }
    }
    if !is_sound {
        return None;
    }
    Some(match kind {
        5 => Condition::Profile(turbine.extreme_profile_50()),
        6 => Condition::Profile(turbine.extreme_profile_1()),
        7 | 8 => Condition::Turbulent(Turbulent {
            generated: generated?(&turbine),
            turbine,
            is_extreme: kind == 8,
        }),
        _ => {
            let (start, sign) = (start?, if reversed? { -1.0 } else { 1.0 });
            let speed = hub_speed(table, mean?.speed(turbine.hub_height, start))?;
            if kind == 0 {
                below_extreme(table, &turbine, speed)?;
            }
            let shape = shape(&turbine, kind, speed, sign);
            Condition::Event(Event { start, shape })
        }
    })
}

/// A speed at the hub \[m/s\], by which the standard scales a condition; another one is noted.
pub(super) fn hub_speed(table: &Table<'_>, speed: f64) -> Option<f64> {
    if speed > 0.0 {
        return Some(speed);
    }
    let problem = AirProblem::Value {
        key: "speed",
        found: format!("{speed} m/s at the hub"),
        expected: "a positive speed, by which the standard scales an event".to_owned(),
        help: "give \"speed\" in [air.wind]",
    };
    table.note(&KIND, &problem);
    None
}

/// Notes a speed at which the operating gust would be a lull.
fn below_extreme(table: &Table<'_>, turbine: &IecTurbine, speed: f64) -> Option<()> {
    let extreme = turbine.extreme_profile_1().speed;
    if speed < extreme {
        return Some(());
    }
    let problem = AirProblem::Value {
        key: "speed",
        found: format!("{} m/s at the hub", short_number(speed, 6)),
        expected: format!(
            "less than the extreme speed of one year of this class, {} m/s: the gust is a part of the \
             difference",
            short_number(extreme, 6)
        ),
        help: "choose another \"class\", or a speed at which the turbine operates",
    };
    table.note(&KIND, &problem);
    None
}

fn shape(turbine: &IecTurbine, kind: usize, speed: f64, sign: f64) -> EventShape {
    match kind {
        0 => turbine.operating_gust(speed),
        1 => turbine.direction_change(speed, sign),
        2 => turbine.coherent_gust(speed, sign),
        3 => turbine.vertical_shear(speed, sign),
        _ => turbine.horizontal_shear(speed, sign),
    }
}

/// The sizes of a generated box by the turbine.
fn generated(table: &Table<'_>) -> Option<impl FnOnce(&IecTurbine) -> GeneratedBox + use<>> {
    let (seed, points) = (table.get(&SEED), table.get(&POINTS));
    let (duration, time_step) = (table.get(&DURATION), table.get(&TIME_STEP));
    let width = table.get(&WIDTH);
    let (seed, points, duration, time_step) = (seed? as u64, points?, duration?, time_step?);
    let width = width?;
    Some(move |turbine: &IecTurbine| GeneratedBox {
        seed,
        duration,
        time_step,
        points,
        width: width.unwrap_or(f64::min(
            WIDTH_OF_ROTOR * turbine.diameter,
            ABOVE_GROUND * 2.0 * turbine.hub_height,
        )),
    })
}

fn turbine(table: &Table<'_>) -> Option<IecTurbine> {
    let (class, category) = (table.get(&CLASS), table.get(&CATEGORY));
    let (reference_speed, intensity) = (table.get(&REFERENCE_SPEED), table.get(&INTENSITY));
    let (hub_height, diameter) = (table.get(&HUB_HEIGHT), table.get(&DIAMETER));
    let (reference_speed, intensity) = (reference_speed?, intensity?);
    let class = match (class?, reference_speed) {
        (3, Some(reference_speed)) => Some(WindClass::Special { reference_speed }),
        (3, None) => missing(table, REFERENCE_SPEED.name(), "class S"),
        (_, Some(_)) => useless(table, REFERENCE_SPEED.name(), "the class has its own"),
        (0, None) => Some(WindClass::One),
        (1, None) => Some(WindClass::Two),
        (_, None) => Some(WindClass::Three),
    };
    let category = match (category?, intensity) {
        (3, Some(intensity)) => Some(TurbulenceCategory::Special { intensity }),
        (3, None) => missing(table, INTENSITY.name(), "category S"),
        (_, Some(_)) => useless(table, INTENSITY.name(), "the category has its own"),
        (0, None) => Some(TurbulenceCategory::A),
        (1, None) => Some(TurbulenceCategory::B),
        (_, None) => Some(TurbulenceCategory::C),
    };
    Some(IecTurbine {
        class: class?,
        category: category?,
        hub_height: hub_height?,
        diameter: diameter?,
    })
}

fn missing<T>(table: &Table<'_>, key: &'static str, user: &'static str) -> Option<T> {
    table.note(key, &AirProblem::Missing { key, user });
    None
}

fn useless<T>(table: &Table<'_>, key: &'static str, reason: &'static str) -> Option<T> {
    table.note(key, &AirProblem::Useless { key, reason });
    None
}

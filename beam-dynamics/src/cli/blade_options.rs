//! The options that mount the blade of a blade file, and the words of its modes.

use std::f64::consts::PI;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};
use shared_geom::units::{Dimension, parse_quantity};

use crate::case::{FrequencyUnit, Words};
use crate::input::BladeSettings;

/// How the root of a blade is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum RootWord {
    /// Clamped to the hub
    Clamped,
    /// Free to flap and lag about hinges at the root
    Hinged,
}

/// Settings for a blade file; a dynamics file contains all of them itself.
#[derive(Debug, Clone, Default, PartialEq, Args)]
#[command(next_help_heading = "Options for blade files")]
pub(super) struct BladeOptions {
    /// Rotor speeds in rpm, or with a unit as in 0,"0.8 rad/s", with commas between; at rest if
    /// not given
    #[arg(long, value_parser = speed, value_name = "RPM", value_delimiter = ',')]
    speeds: Option<Vec<f64>>,
    /// Number of modes to report at each speed
    #[arg(long, value_parser = whole, value_name = "N")]
    count: Option<usize>,
    /// Length in m of a straight blade, for files of sections without a line
    #[arg(long, value_parser = finite, value_name = "M", allow_negative_numbers = true)]
    length: Option<f64>,
    /// Distance in m of the root from the axis of rotation, along the blade; 0 if not given
    #[arg(long, value_parser = finite, value_name = "M", allow_negative_numbers = true)]
    hub_radius: Option<f64>,
    /// How the root is held; clamped if not given
    #[arg(long, value_name = "WORD")]
    root: Option<RootWord>,
    /// Angle in degrees by which the blade is raised above the plane of rotation
    #[arg(long, value_parser = finite, value_name = "DEG", allow_negative_numbers = true)]
    precone: Option<f64>,
    /// Angle in degrees by which the blade is turned nose up about its span
    #[arg(long, value_parser = finite, value_name = "DEG", allow_negative_numbers = true)]
    pitch: Option<f64>,
    /// Number of equal blades around the axis; one if not given
    #[arg(long, value_parser = whole, value_name = "N")]
    blades: Option<usize>,
    /// Number of elements; ends of elements at the stations if not given
    #[arg(long, value_parser = whole, value_name = "N")]
    elements: Option<usize>,
    /// Make sections without shear stiffness rigid in shear
    #[arg(long)]
    rigid_shear: bool,
    /// Damping ratio of all modes, from 0 to below 1, instead of the damping of the file
    #[arg(long, value_parser = finite, value_name = "RATIO", allow_negative_numbers = true)]
    damping_ratio: Option<f64>,
    /// Words for the motion of blades: lag, progressive, regressive; or edge, forward, backward
    #[arg(long, value_name = "WORD", value_parser = one_of(Words::NAMES, Words::ALL))]
    words: Option<Words>,
    /// Unit of frequencies in figures; Hz if not given
    #[arg(long, value_name = "UNIT", value_parser = one_of(FrequencyUnit::NAMES, FrequencyUnit::ALL))]
    frequency_unit: Option<FrequencyUnit>,
    /// Multiples of the rotor speed in figures and among the critical speeds, with commas between;
    /// 1 and multiples of the number of blades if not given
    #[arg(long, value_parser = whole, value_name = "N", value_delimiter = ',')]
    harmonics: Option<Vec<usize>>,
    /// Speed, among the rotor speeds, at which modes are named; the first if not given
    #[arg(long, value_parser = speed, value_name = "RPM")]
    name_at: Option<f64>,
}

/// Reads one of `names` as the value at its index.
fn one_of<T: Copy + Send + Sync + 'static, const N: usize>(
    names: [&'static str; N],
    all: [T; N],
) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(names).try_map(move |found| {
        let of_name = names.iter().zip(all).find(|(name, _)| **name == found);
        of_name
            .map(|(_, value)| value)
            .ok_or("expected one of the words")
    })
}

/// One of the rotor speeds, in rpm or with a unit \[rpm\].
pub(super) fn speed(text: &str) -> Result<f64, String> {
    let with_unit = || parse_quantity(text, Dimension::ROTATION_SPEED).ok();
    let rpm = |speed: f64| speed * 30.0 / PI;
    let found = finite(text).ok().or_else(|| with_unit().map(rpm));
    found.filter(|speed| speed.is_finite()).ok_or_else(|| {
        "expected rotation speeds with commas between, as in 0,4,8 or 0,\"0.8 rad/s\"".to_owned()
    })
}

/// A whole number of at least one.
fn whole(text: &str) -> Result<usize, String> {
    let number = text.trim().parse().ok().filter(|number| *number > 0);
    number.ok_or_else(|| "expected a whole number, 1 or more".to_owned())
}

/// A finite number.
fn finite(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        _ => Err("expected a number".to_owned()),
    }
}

impl BladeOptions {
    /// Name of an option that was given; `None` without one.
    pub fn given(&self) -> Option<&'static str> {
        let given = [
            (self.speeds.is_some(), "--speeds"),
            (self.count.is_some(), "--count"),
            (self.length.is_some(), "--length"),
            (self.hub_radius.is_some(), "--hub-radius"),
            (self.root.is_some(), "--root"),
            (self.precone.is_some(), "--precone"),
            (self.pitch.is_some(), "--pitch"),
            (self.blades.is_some(), "--blades"),
            (self.elements.is_some(), "--elements"),
            (self.rigid_shear, "--rigid-shear"),
            (self.damping_ratio.is_some(), "--damping-ratio"),
            (self.words.is_some(), "--words"),
            (self.frequency_unit.is_some(), "--frequency-unit"),
            (self.harmonics.is_some(), "--harmonics"),
            (self.name_at.is_some(), "--name-at"),
        ];
        given.iter().find(|option| option.0).map(|option| option.1)
    }

    /// The settings for a blade file.
    pub fn settings(&self) -> BladeSettings {
        let default = BladeSettings::default();
        BladeSettings {
            speeds_rpm: self.speeds.clone().unwrap_or(default.speeds_rpm),
            count: self.count,
            elements: self.elements,
            length: self.length,
            hub_radius: self.hub_radius.unwrap_or(default.hub_radius),
            precone_deg: self.precone.unwrap_or(default.precone_deg),
            pitch_deg: self.pitch.unwrap_or(default.pitch_deg),
            blades: self.blades,
            is_hinged: self.root == Some(RootWord::Hinged),
            rigid_shear: self.rigid_shear,
            damping_ratio: self.damping_ratio,
            words: self.words.unwrap_or_default(),
            frequency_unit: self.frequency_unit.unwrap_or_default(),
            harmonics: self.harmonics.clone().unwrap_or_default(),
            name_at_rpm: self.name_at,
        }
    }
}

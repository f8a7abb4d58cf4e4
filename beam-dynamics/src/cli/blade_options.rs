//! The options that mount the blade of a blade file.

use clap::{Args, ValueEnum};

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
    /// Rotor speeds in rpm, with commas between; at rest if not given
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
}

/// One of the rotor speeds.
fn speed(text: &str) -> Result<f64, String> {
    finite(text).map_err(|_| "expected numbers with commas between, as in 0,4,8".to_owned())
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
        }
    }
}

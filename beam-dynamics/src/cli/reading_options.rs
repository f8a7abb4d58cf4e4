//! Options of the commands that read any blade file.

use std::path::Path;

use clap::Args;
use shared_geom::error::Diagnostics;
use shared_geom::exchange::{self, Format, Options, Reading};

/// A length above zero, for files that contain none.
fn length(text: &str) -> Result<f64, String> {
    let value: Option<f64> = text.parse().ok();
    let value = value.filter(|value| value.is_finite() && *value > 0.0);
    value.ok_or_else(|| "expected a number of meters above zero".to_owned())
}

/// Settings that a blade file does not contain.
#[derive(Debug, Clone, Copy, Args)]
pub(super) struct ReadingOptions {
    /// Length of a uniform blade, for files of sections without a line: straight, or with the curvature of its section file
    #[arg(long, value_name = "METERS", value_parser = length, allow_negative_numbers = true)]
    pub length: Option<f64>,
    /// Make sections without shear stiffness rigid in shear
    #[arg(long)]
    pub rigid_shear: bool,
}

impl ReadingOptions {
    /// Reads a blade file with these settings, and `length` [m] unless one is given.
    pub fn read(&self, file: &Path, length: Option<f64>) -> Result<(Format, Reading), Diagnostics> {
        let length = self.length.or(length);
        let rigid_shear = self.rigid_shear;
        exchange::read_with(
            file,
            &Options {
                length,
                rigid_shear,
                ..Options::default()
            },
        )
    }
}

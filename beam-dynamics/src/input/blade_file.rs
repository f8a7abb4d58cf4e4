//! A model of blades from a blade file alone, with settings of the analysis.
//!
//! The settings become the text of a dynamics input, which is read like any other: a blade
//! file has the same meaning on both ways.

use std::fmt::Write;
use std::path::Path;

use shared_geom::document::{basic_string, read_text};
use shared_geom::error::{Diagnostics, SourceLocation};

use super::Input;
use crate::case::{FrequencyUnit, Words};

/// The file name of the text made from the settings.
const MADE: &str = "(made from the options)";
/// Endings that name a blade file.
const ENDINGS: [&str; 2] = [".blade.json", ".blade.toml"];

/// Requested analysis of the blade of a file, and its mounting.
#[derive(Debug, Clone, PartialEq)]
pub struct BladeSettings {
    /// Rotor speeds \[rpm\].
    pub speeds_rpm: Vec<f64>,
    /// Number of modes to report at each speed; `None` for the default.
    pub count: Option<usize>,
    /// Number of elements; `None` for element ends at the stations.
    pub elements: Option<usize>,
    /// Length of a uniform blade, for files of sections without a line \[m\].
    pub length: Option<f64>,
    /// Distance of the root from the axis, along the blade \[m\].
    pub hub_radius: f64,
    /// Precone, positive up \[deg\].
    pub precone_deg: f64,
    /// Pitch, nose up \[deg\].
    pub pitch_deg: f64,
    /// Number of blades; `None` for a single one.
    pub blades: Option<usize>,
    /// Whether the root is free to flap and lag, about hinges that coincide at it.
    pub is_hinged: bool,
    /// Whether sections without shear stiffness are rigid in shear.
    pub rigid_shear: bool,
    /// Damping ratio of all modes; `None` for the damping of the file [-].
    pub damping_ratio: Option<f64>,
    /// Words for the motion of blades.
    pub words: Words,
    /// Unit of frequencies in figures.
    pub frequency_unit: FrequencyUnit,
    /// Multiples of the rotor speed in figures; empty for 1 and the multiples of `blades`.
    pub harmonics: Vec<usize>,
    /// Speed, among the rotor speeds, at which modes are named; `None` for the first \[rpm\].
    pub name_at_rpm: Option<f64>,
}

impl Default for BladeSettings {
    /// The modes of a single blade, clamped and at rest.
    fn default() -> Self {
        Self {
            speeds_rpm: vec![0.0],
            count: None,
            elements: None,
            length: None,
            hub_radius: 0.0,
            precone_deg: 0.0,
            pitch_deg: 0.0,
            blades: None,
            is_hinged: false,
            rigid_shear: false,
            damping_ratio: None,
            words: Words::default(),
            frequency_unit: FrequencyUnit::default(),
            harmonics: Vec::new(),
            name_at_rpm: None,
        }
    }
}

impl BladeSettings {
    /// The text of the dynamics input.
    fn text(&self, file: &str) -> String {
        let mut text = format!(
            "units = \"SI\"\n[[blade]]\nname = \"blade\"\nfile = {}\nhub_radius = {:e}\n\
             precone = {:e}\npitch = {:e}\n",
            basic_string(file),
            self.hub_radius,
            self.precone_deg,
            self.pitch_deg
        );
        let numbers = [("elements", self.elements), ("count", self.blades)];
        for (key, number) in numbers {
            if let Some(number) = number {
                // Writing to a string does not fail.
                let _ = writeln!(text, "{key} = {number}");
            }
        }
        if let Some(length) = self.length {
            let _ = writeln!(text, "length = {length:e}");
        }
        if self.rigid_shear {
            text += "rigid_shear = true\n";
        }
        if self.is_hinged {
            text += "hinges = [{ kind = \"flap\" }, { kind = \"lag\" }]\n";
        }
        let speeds: Vec<_> = self
            .speeds_rpm
            .iter()
            .map(|rpm| format!("{rpm:e}"))
            .collect();
        let _ = writeln!(
            text,
            "[modes]\nspeeds = [{}]\nwords = \"{}\"\nfrequency_unit = \"{}\"",
            speeds.join(", "),
            self.words.name(),
            self.frequency_unit.word()
        );
        if let Some(ratio) = self.damping_ratio {
            let _ = writeln!(text, "damping_ratio = {ratio:e}");
        }
        if let Some(count) = self.count {
            let _ = writeln!(text, "count = {count}");
        }
        if !self.harmonics.is_empty() {
            let _ = writeln!(text, "harmonics = {:?}", self.harmonics);
        }
        if let Some(rpm) = self.name_at_rpm {
            let _ = writeln!(text, "name_at = {rpm:e}");
        }
        text
    }
}

/// Whether a file is a blade file by its name: no `.toml`, or one called
/// `NAME.blade.toml`.
pub fn is_blade_file(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    !name.ends_with(".toml") || name.ends_with(ENDINGS[1])
}

/// The name of a blade file without folder and ending.
pub(super) fn name_of(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let stem = ENDINGS.iter().find_map(|ending| name.strip_suffix(ending));
    let stem = stem.or_else(|| name.rsplit_once('.').map(|(stem, _)| stem));
    stem.filter(|stem| !stem.is_empty())
        .unwrap_or(&name)
        .to_owned()
}

/// Reads and checks the blade file at `path`: in our formats, or in another tool's format.
///
/// # Errors
/// All problems of the file and the settings.
pub fn read_blade(path: &Path, settings: &BladeSettings) -> Result<Input, Diagnostics> {
    // A missing file is reported with the name that the user gave.
    read_text(path)?;
    let file = path.display().to_string();
    let text = settings.text(&file);
    let input = super::checked(&text, (MADE, &name_of(path)), (&[], None));
    input.map_err(|problems| {
        problems.rewritten(MADE, |problem| {
            let line = problem.location.line.unwrap_or_default();
            for (key, option) in options_at(&text, line) {
                let key = format!("\"{key}\"");
                problem.message = problem.message.replace(&key, option);
            }
            problem.location = SourceLocation::file(file.clone());
        })
    })
}

/// Keys of `[[blade]]`, and the options that they are made of.
const OF_BLADE: [(&str, &str); 6] = [
    ("count", "--blades"),
    ("hub_radius", "--hub-radius"),
    ("precone", "--precone"),
    ("pitch", "--pitch"),
    ("elements", "--elements"),
    ("length", "--length"),
];
/// Keys of `[modes]`, and the options that they are made of.
const OF_MODES: [(&str, &str); 5] = [
    ("count", "--count"),
    ("speeds", "--speeds"),
    ("damping_ratio", "--damping-ratio"),
    ("harmonics", "--harmonics"),
    ("name_at", "--name-at"),
];

/// The keys of the table with a line of the text made from the settings, and their options.
fn options_at(text: &str, line: usize) -> &'static [(&'static str, &'static str)] {
    let is_of_modes = text.lines().take(line).any(|line| line == "[modes]");
    if is_of_modes { &OF_MODES } else { &OF_BLADE }
}

#[cfg(test)]
mod tests {
    use super::*;
    use shared_geom::document::Document;

    #[test]
    fn settings_become_a_sound_text() {
        let settings = BladeSettings {
            speeds_rpm: vec![0.0, 12.1],
            count: Some(8),
            elements: Some(30),
            hub_radius: 1.5,
            blades: Some(3),
            is_hinged: true,
            damping_ratio: Some(0.02),
            words: Words::Wind,
            frequency_unit: FrequencyUnit::PerRevolution,
            harmonics: vec![1, 3],
            name_at_rpm: Some(12.1),
            ..BladeSettings::default()
        };
        let file = "a \"b\"\\c\t.dat";
        let text = settings.text(file);
        let document = Document::parse(&text, MADE).unwrap();
        let blades = document.root().tables("blade");
        assert_eq!(blades[0].text("file").as_deref(), Some(file));
        assert_eq!(blades[0].tables("hinges").len(), 2);
        for line in [
            "elements = 30",
            "count = 3",
            "count = 8",
            "damping_ratio = 2e-2",
            "words = \"wind\"",
            "frequency_unit = \"1/rev\"",
            "harmonics = [1, 3]",
            "name_at = 1.21e1",
            "speeds = [0e0, 1.21e1]",
        ] {
            assert!(
                text.lines().any(|found| found == line),
                "{line} is not in {text}"
            );
        }
    }

    #[test]
    fn lines_of_the_text_lead_to_options() {
        let settings = BladeSettings {
            count: Some(8),
            blades: Some(3),
            ..BladeSettings::default()
        };
        let text = settings.text("a.dat");
        let lines: Vec<_> = text.lines().collect();
        let of = |line: &str| {
            let number = 1 + lines.iter().position(|found| *found == line).unwrap();
            options_at(&text, number)[0]
        };
        assert_eq!(of("count = 3"), ("count", "--blades"));
        assert_eq!(of("count = 8"), ("count", "--count"));
    }

    #[test]
    fn blade_files_are_known_by_their_names() {
        for (file, is_blade, name) in [
            ("a/x.blade.json", true, "x"),
            ("x.blade.toml", true, "x"),
            ("NREL_5MW.v2.dat", true, "NREL_5MW.v2"),
            ("st", true, "st"),
            ("x.toml", false, "x"),
            ("x.dynamics.toml", false, "x"),
        ] {
            let path = Path::new(file);
            assert_eq!(is_blade_file(path), is_blade, "{file}");
            assert_eq!(super::super::name_of(path), name);
        }
    }
}

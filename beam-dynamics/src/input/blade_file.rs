//! A model of blades from a blade file alone, with settings of the analysis.
//!
//! The settings become the text of a dynamics input, which is read like any other: a blade
//! file has the same meaning on both ways.

use std::fmt::Write;
use std::path::Path;

use shared_geom::document::read_text;
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
        }
    }
}

impl BladeSettings {
    /// The text of the dynamics input.
    fn text(&self, file: &str) -> String {
        let mut text = format!(
            "units = \"SI\"\n[[blade]]\nname = \"blade\"\nfile = {}\nhub_radius = {:e}\n\
             precone = {:e}\npitch = {:e}\n",
            quoted(file),
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
        text
    }
}

/// A basic string of TOML.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for letter in text.chars() {
        match letter {
            '"' | '\\' => quoted.extend(['\\', letter]),
            letter if letter.is_control() => {
                let _ = write!(quoted, "\\u{:04x}", letter as u32);
            }
            letter => quoted.push(letter),
        }
    }
    quoted + "\""
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
            if let Some((key, option)) = option_at(&text, line) {
                let key = format!("\"{key}\"");
                problem.message = problem.message.replace(&key, option);
            }
            problem.location = SourceLocation::file(file.clone());
        })
    })
}

/// The key on a line of the text made from the settings, and the option that it is made of.
fn option_at(text: &str, line: usize) -> Option<(&str, &'static str)> {
    let written = text.lines().nth(line.checked_sub(1)?)?;
    let (key, _) = written.split_once(" = ")?;
    let is_of_modes = text.lines().take(line).any(|line| line == "[modes]");
    let option = match (key, is_of_modes) {
        ("count", true) => "--count",
        ("count", false) => "--blades",
        ("speeds", _) => "--speeds",
        ("hub_radius", _) => "--hub-radius",
        ("precone", _) => "--precone",
        ("pitch", _) => "--pitch",
        ("elements", _) => "--elements",
        ("length", _) => "--length",
        _ => return None,
    };
    Some((key, option))
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
            length: Some(2.0),
            ..BladeSettings::default()
        };
        let text = settings.text("a.dat");
        let lines = 1..=text.lines().count() + 1;
        let options: Vec<_> = lines.filter_map(|line| option_at(&text, line)).collect();
        let expected = [
            ("hub_radius", "--hub-radius"),
            ("precone", "--precone"),
            ("pitch", "--pitch"),
            ("count", "--blades"),
            ("length", "--length"),
            ("speeds", "--speeds"),
            ("count", "--count"),
        ];
        assert_eq!(options, expected);
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

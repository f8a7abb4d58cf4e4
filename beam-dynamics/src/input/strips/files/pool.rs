//! The airfoils of the stations of a file, by index, name or thickness.

use std::mem::discriminant;
use std::sync::Arc;

use rotor_aero::airfoil::files::blade::{AeroStation, StationAirfoil};
use rotor_aero::airfoil::files::{self, ReadAirfoil};
use rotor_aero::airfoil::{Airfoil, Blend, BlendProblem, Section};
use shared_geom::document::Table;
use shared_geom::error::Explain;
use shared_geom::files::names_beside;

use super::super::stations::Station;
use super::problem::FileProblem;
use super::{AIRFOIL_FILE, AIRFOILS, DIGITS, FILE, one_set};
use crate::input::aerodynamics::family::position_between;
use crate::input::aerodynamics::{Airfoils, airfoil_constants, checked_airfoil};

/// An airfoil of the list.
struct Entry {
    name: String,
    set: Option<usize>,
    thickness: Option<f64>,
    content: Content,
}

enum Content {
    /// Of `[airfoils]`, or built in; `None` if it is wrong.
    Section(Option<Section>),
    /// A table that is not used yet.
    Table(Box<ReadAirfoil>),
    /// A table that is used; `None` if it is wrong.
    Airfoil(Option<Arc<Airfoil>>),
}

/// The airfoils of a blade; tables are checked when they are used.
pub(in crate::input) struct Pool<'a> {
    table: &'a Table<'a>,
    named: &'a Airfoils,
    user: &'a str,
    entries: Vec<Entry>,
    /// Number of entries before the ones of the file of the blade itself.
    given: usize,
    /// Names that no airfoil has.
    unknown: Vec<String>,
    /// Whether all names and files of the lists are found and right.
    sound: bool,
}

impl<'a> Pool<'a> {
    /// No airfoil yet.
    pub fn new(table: &'a Table<'a>, named: &'a Airfoils, user: &'a str) -> Self {
        Self {
            table,
            named,
            user,
            entries: Vec::new(),
            given: 0,
            unknown: Vec::new(),
            sound: true,
        }
    }

    /// Adds the list of names and files, and the airfoils of a file; whether all are found.
    pub fn add(
        &mut self,
        names: Option<Vec<String>>,
        file: Option<String>,
        remarks: &mut Vec<String>,
    ) -> bool {
        let mut sound = true;
        for name in names.unwrap_or_default() {
            if self.named.has(&name) {
                let section = self
                    .named
                    .find(&name, (self.table, AIRFOILS.name()), self.user);
                self.entries.push(Entry {
                    name,
                    set: None,
                    thickness: section.as_ref().and_then(thickness),
                    content: Content::Section(section),
                });
                continue;
            }
            sound &= self.add_files(&name, AIRFOILS.name(), remarks);
        }
        if let Some(file) = file {
            sound &= self.add_files(&file, AIRFOIL_FILE.name(), remarks);
        }
        self.given = self.entries.len();
        self.sound = sound;
        sound
    }

    /// Adds the airfoils of all files of a name with `*`, or of a folder, in the order of their names
    /// and of the numbers in them.
    fn add_files(&mut self, written: &str, key: &str, remarks: &mut Vec<String>) -> bool {
        let mut paths = Vec::new();
        let path = self.table.path(key, written);
        let folder = path.is_dir().then(|| path.join("*"));
        if folder.is_some() || written.contains('*') {
            let path = folder.unwrap_or(path);
            let pattern = path.file_name().unwrap_or_default().to_string_lossy();
            let mut names = names_beside(&path);
            names.retain(|name| fits(&pattern, name) && !name.starts_with('.'));
            names.sort_by_cached_key(|name| by_numbers(name));
            paths.extend(names.iter().map(|name| path.with_file_name(name)));
            if paths.is_empty() {
                let pattern = written.to_owned();
                self.table.note(key, &FileProblem::NoMatch { pattern });
            }
        } else {
            paths.extend(self.table.existing(key, written));
        }
        let mut sound = !paths.is_empty();
        for path in paths {
            match self.table.keep_file(key, files::read(&path)) {
                Some(reading) => {
                    let of_file = |remark: &String| format!("{}: {remark}", path.display());
                    remarks.extend(reading.remarks.iter().map(of_file));
                    self.add_own(reading.airfoils);
                }
                None => sound = false,
            }
        }
        sound
    }

    /// Adds the airfoils of a file that is read.
    pub fn add_own(&mut self, airfoils: Vec<ReadAirfoil>) {
        let entry = |airfoil: ReadAirfoil| Entry {
            name: airfoil.data.name.clone(),
            set: airfoil.set,
            thickness: airfoil.data.thickness,
            content: Content::Table(Box::new(airfoil)),
        };
        self.entries.extend(airfoils.into_iter().map(entry));
    }

    /// The sections of all stations; notes all problems, but for airfoils that may be in a file that
    /// cannot be read.
    pub fn sections(
        &mut self,
        stations: &[AeroStation],
        file: &str,
        remarks: &mut Vec<String>,
    ) -> Option<Vec<Section>> {
        let names_none =
            |station: &AeroStation| !matches!(station.airfoil, StationAirfoil::Blend(_));
        if self.entries.is_empty() && stations.iter().any(names_none) {
            let file = file.to_owned();
            self.note(&FileProblem::NoAirfoils { file });
            return None;
        }
        let mut problems: Vec<FileProblem> = Vec::new();
        let sections = stations.iter().enumerate().map(|(index, station)| {
            let found = self.section((index, station), (file, stations.len()), remarks);
            found.unwrap_or_else(|problem| {
                problems.push(problem);
                None
            })
        });
        let sections: Vec<_> = sections.collect();
        self.note_unknown(file);
        // Stations share their causes: the last of each kind, which has the largest index.
        for (at, problem) in problems.iter().enumerate() {
            let later = &problems[at + 1..];
            if !later
                .iter()
                .any(|other| discriminant(other) == discriminant(problem))
            {
                self.note(problem);
            }
        }
        sections.into_iter().collect()
    }

    /// The section of one station; `None` if a part of it is noted already.
    fn section(
        &mut self,
        (index, station): (usize, &AeroStation),
        (file, stations): (&str, usize),
        remarks: &mut Vec<String>,
    ) -> Result<Option<Section>, FileProblem> {
        let count = self.entries.len();
        let named = file;
        let file = named.to_owned();
        match &station.airfoil {
            StationAirfoil::Index(at) if *at < count => Ok(self.entry(*at, remarks)),
            StationAirfoil::Index(at) => {
                let found = at + 1;
                Err(FileProblem::Index {
                    file,
                    index,
                    found,
                    count,
                })
            }
            StationAirfoil::Unknown if count == 1 => Ok(self.entry(0, remarks)),
            StationAirfoil::Unknown if count == stations => Ok(self.entry(index, remarks)),
            StationAirfoil::Unknown => Err(FileProblem::NoName { file, index, count }),
            StationAirfoil::Blend(parts) => {
                let mut sections = Vec::new();
                for (name, weight) in parts {
                    let Some(section) = self.by_name(name, remarks) else {
                        return Ok(None);
                    };
                    let weighted = section.parts();
                    sections.extend(weighted.map(|(part, it)| (part * weight, it.clone())));
                }
                Section::weighted(&sections)
                    .map(Some)
                    .map_err(|problem| of_blend(named, index, &problem))
            }
            StationAirfoil::ByThickness(set) => {
                let wanted = station.thickness.unwrap_or_default();
                let Some(profiles) = self.profiles(*set, remarks) else {
                    return Ok(None);
                };
                if profiles.is_empty() {
                    let set = *set;
                    return Err(FileProblem::NoSet { file, index, set });
                }
                Blend::by_thickness(&profiles)
                    .and_then(|blend| blend.section(wanted))
                    .map(Some)
                    .map_err(|problem| of_thickness(named, index, &problem))
            }
        }
    }

    /// The section of an entry.
    fn entry(&mut self, index: usize, remarks: &mut Vec<String>) -> Option<Section> {
        let entry = self.entries.get_mut(index)?;
        if let Content::Table(read) = &entry.content {
            let airfoil = checked_airfoil(&read.data, (self.table, FILE.name()), remarks);
            let constants = airfoil_constants(read, remarks);
            let airfoil = airfoil.map(|airfoil| airfoil.with_unsteady(constants));
            entry.content = Content::Airfoil(airfoil.map(Arc::new));
        }
        match &entry.content {
            Content::Section(section) => section.clone(),
            Content::Airfoil(airfoil) => airfoil.clone().map(Section::single),
            Content::Table(_) => None,
        }
    }

    /// Adds an airfoil that needs no name: the only one of the stations.
    pub fn add_section(&mut self, section: Section) {
        self.entries.push(Entry {
            name: String::new(),
            set: None,
            thickness: thickness(&section),
            content: Content::Section(Some(section)),
        });
    }

    /// The named airfoils, and the ones of the list and the files, for stations that are typed.
    pub fn into_named(mut self, remarks: &mut Vec<String>) -> Airfoils {
        let mut airfoils = self.named.clone();
        for index in 0..self.entries.len() {
            let section = self.entry(index, remarks);
            let airfoil = section.and_then(|section| Some(Arc::clone(section.parts().next()?.1)));
            airfoils.add(&self.entries[index].name, airfoil);
        }
        airfoils
    }

    /// The airfoil of a name: of the list, of `[airfoils]`, of the file of the blade, or built in. Unknown
    /// ones are collected.
    fn by_name(&mut self, name: &str, remarks: &mut Vec<String>) -> Option<Section> {
        let found = self.entries.iter().position(|entry| entry.name == name);
        let is_of_blade = found.is_some_and(|index| index >= self.given);
        if let Some(index) = found.filter(|_| !(is_of_blade && self.named.has_own(name))) {
            return self.entry(index, remarks);
        }
        if self.unknown.iter().any(|known| known == name) {
            return None;
        }
        if self.named.has(name) {
            return self.named.find(name, (self.table, FILE.name()), self.user);
        }
        self.unknown.push(name.to_owned());
        None
    }

    /// Notes the unknown names of a file together.
    fn note_unknown(&self, file: &str) {
        if self.unknown.is_empty() {
            return;
        }
        let own = self.entries.iter().map(|entry| entry.name.as_str());
        let known = own.chain(self.named.known()).map(str::to_owned);
        let problem = FileProblem::Unknown {
            file: file.to_owned(),
            names: self.unknown.clone(),
            known: known.collect(),
        };
        self.note(&problem);
    }

    /// Notes a problem of the airfoils that are found, unless others may be in a file that cannot be read.
    fn note(&self, problem: &FileProblem) {
        if self.sound {
            self.table.note(&FILE, problem);
        }
    }

    /// The profiles of a set; all airfoils with a thickness if none has a set.
    fn profiles(&mut self, set: usize, remarks: &mut Vec<String>) -> Option<Vec<Arc<Airfoil>>> {
        let has_sets = self.entries.iter().any(|entry| entry.set.is_some());
        let belongs = |entry: &Entry| {
            if has_sets {
                entry.set == Some(set)
            } else {
                entry.thickness.is_some()
            }
        };
        let indices: Vec<_> = (0..self.entries.len())
            .filter(|index| belongs(&self.entries[*index]))
            .collect();
        let profiles = indices.into_iter().map(|index| {
            let section = self.entry(index, remarks)?;
            section.parts().next().map(|part| part.1.clone())
        });
        let profiles: Vec<_> = profiles.collect();
        profiles.into_iter().collect()
    }

    /// Sections between stations whose thicknesses enclose the one of a profile: there the
    /// mixture of two profiles changes.
    pub(in crate::input::strips) fn between(
        &mut self,
        read: &[AeroStation],
        stations: &[Station],
        remarks: &mut Vec<String>,
    ) -> Option<Vec<(f64, Section)>> {
        let mut more = Vec::new();
        for (read, stations) in read.windows(2).zip(stations.windows(2)) {
            let Some(set) = one_set(&read[0], &read[1]) else {
                continue;
            };
            let end = |i: usize| [stations[i].at, read[i].thickness.unwrap_or_default()];
            for profile in self.profiles(set, remarks)? {
                let thickness = profile.thickness().unwrap_or_default();
                let at = position_between(thickness, [end(0), end(1)]);
                more.extend(at.map(|at| (at, Section::single(profile))));
            }
        }
        Some(more)
    }
}

/// A name as letters and numbers, so that "polar 2" is before "polar 10".
fn by_numbers(name: &str) -> Vec<(String, u64)> {
    let mut parts: Vec<(String, u64)> = vec![(String::new(), 0)];
    let mut digits = false;
    for letter in name.chars() {
        if let Some((text, number)) = parts.last_mut() {
            match letter.to_digit(10) {
                Some(digit) => {
                    *number = number.saturating_mul(10).saturating_add(u64::from(digit));
                    digits = true;
                }
                None if digits => {
                    parts.push((letter.to_string(), 0));
                    digits = false;
                }
                None => text.push(letter),
            }
        }
    }
    parts
}

/// Thickness of a section of one airfoil \[-\].
fn thickness(section: &Section) -> Option<f64> {
    let (_, first) = section.parts().next()?;
    first.thickness()
}

fn of_blend(file: &str, index: usize, problem: &BlendProblem) -> FileProblem {
    FileProblem::Thickness {
        file: file.to_owned(),
        index,
        reason: problem.to_string(),
        help: problem.help(),
    }
}

/// As [`of_blend`], for a file with thicknesses in percent, of which a part of the chord is too small.
fn of_thickness(file: &str, index: usize, problem: &BlendProblem) -> FileProblem {
    match *problem {
        BlendProblem::OutOfRange { at, from, to }
            if (100.0 * at - from) > -DIGITS && (100.0 * at - to) < DIGITS =>
        {
            let (file, percent) = (file.to_owned(), 100.0 * at);
            FileProblem::Fraction {
                file,
                index,
                percent,
            }
        }
        _ => of_blend(file, index, problem),
    }
}

/// Whether a name fits a pattern in which `*` is any number of letters.
fn fits(pattern: &str, name: &str) -> bool {
    let Some((first, rest)) = pattern.split_once('*') else {
        return pattern == name;
    };
    let Some(mut left) = name.strip_prefix(first) else {
        return false;
    };
    let mut parts = rest.split('*').peekable();
    while let Some(part) = parts.next() {
        if parts.peek().is_none() {
            return left.ends_with(part);
        }
        match left.split_once(part) {
            Some((_, after)) => left = after,
            None => return false,
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::{by_numbers, fits};

    #[test]
    fn numbers_in_names_are_counted() {
        let mut names = ["p10.dat", "p9.dat", "p1_b.dat", "p1_a.dat", "a.dat"];
        names.sort_by_key(|name| by_numbers(name));
        assert_eq!(
            names,
            ["a.dat", "p1_a.dat", "p1_b.dat", "p9.dat", "p10.dat"]
        );
    }

    #[test]
    fn a_star_is_any_number_of_letters() {
        for (pattern, name, expected) in [
            ("*.dat", "a.dat", true),
            ("*.dat", "a.csv", false),
            ("Polar_*_1*.dat", "Polar_07_10.dat", true),
            ("Polar_*_1*.dat", "Polar_07_20.dat", false),
            ("a*a", "a", false),
            ("a", "a", true),
            ("a**b", "ab", true),
        ] {
            assert_eq!(fits(pattern, name), expected, "{pattern} {name}");
        }
    }
}

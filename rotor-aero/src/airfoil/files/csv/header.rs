//! The header of a CSV file of airfoils, and its cells.

use shared_geom::exchange::text::{Line, lines};

use super::super::grid::Unit;
use super::super::notes::Notes;

/// Content of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Name,
    Alpha,
    Lift,
    Drag,
    Moment,
    Mach,
    Reynolds,
    Flap,
    Thickness,
    Other,
}

/// Names of the columns, in small letters.
const NAMES: [(Kind, &[&str]); 9] = [
    (Kind::Name, &["airfoil", "name", "node", "section"]),
    (Kind::Alpha, &["alpha", "aoa", "angle of attack"]),
    (Kind::Lift, &["cl", "c_l", "lift"]),
    (Kind::Drag, &["cd", "c_d", "drag"]),
    (Kind::Moment, &["cm", "c_m", "moment"]),
    (Kind::Mach, &["mach", "m"]),
    (Kind::Reynolds, &["reynolds", "re"]),
    (Kind::Flap, &["flap", "deflection"]),
    (Kind::Thickness, &["thickness", "t/c"]),
];

impl Kind {
    /// Its name in messages.
    pub fn title(self) -> &'static str {
        let found = NAMES.iter().find(|(kind, _)| *kind == self);
        found
            .and_then(|(_, names)| names.first().copied())
            .unwrap_or("another column")
    }

    fn of(name: &str) -> Self {
        let found = NAMES.iter().find(|(_, names)| names.contains(&name));
        found.map_or(Self::Other, |(kind, _)| *kind)
    }
}

/// The columns of a file.
pub(super) struct Header {
    pub kinds: Vec<Kind>,
    /// Factors by which the numbers of the columns are multiplied: 0.01 of a column in per cent.
    pub factors: Vec<f64>,
    /// Unit of the angle of attack.
    pub unit: Unit,
    /// Unit of the deflection.
    pub flap: Unit,
}

/// The lines that are neither blank nor comments.
pub(in crate::airfoil::files) fn content(text: &str) -> Vec<Line<'_>> {
    let all = lines(text.strip_prefix('\u{feff}').unwrap_or(text)).into_iter();
    all.filter(|line| !line.text.starts_with('#')).collect()
}

/// Whether a line names the angle of attack and lift.
pub(super) fn is_header(text: &str) -> bool {
    let names: Vec<_> = names(text, separator(text))
        .into_iter()
        .map(|(name, _)| Kind::of(&name))
        .collect();
    names.contains(&Kind::Alpha) && names.contains(&Kind::Lift)
}

/// The separator of the cells; a blank for blanks.
pub(in crate::airfoil::files) fn separator(header: &str) -> char {
    [';', ',', '\t']
        .into_iter()
        .find(|&letter| header.contains(letter))
        .unwrap_or(' ')
}

/// The cells of a line, without quotes.
pub(in crate::airfoil::files) fn cells(text: &str, separator: char) -> Vec<String> {
    if separator == ' ' {
        return text.split_whitespace().map(str::to_owned).collect();
    }
    let mut cells = vec![String::new()];
    let mut is_quoted = false;
    for letter in text.chars() {
        match letter {
            '"' => is_quoted = !is_quoted,
            letter if letter == separator && !is_quoted => cells.push(String::new()),
            letter => cells.extend_last(letter),
        }
    }
    cells
        .into_iter()
        .map(|cell| cell.trim().to_owned())
        .collect()
}

/// Adds a letter to the last cell.
trait ExtendLast {
    fn extend_last(&mut self, letter: char);
}

impl ExtendLast for Vec<String> {
    fn extend_last(&mut self, letter: char) {
        if let Some(last) = self.last_mut() {
            last.push(letter);
        }
    }
}

/// Names and units of the columns, in small letters: `alpha [deg]`, `alpha_deg`, `alpha(deg)`.
fn names(header: &str, separator: char) -> Vec<(String, String)> {
    // A blank before a unit does not separate columns.
    let packed = header.replace(" [", "[").replace(" (", "(").to_lowercase();
    let split = |cell: String| {
        let ends = |c: char| c == '[' || c == '(';
        if let Some((name, unit)) = cell.split_once(ends) {
            return (
                name.trim().to_owned(),
                unit.trim_end_matches([']', ')']).trim().to_owned(),
            );
        }
        match cell.rsplit_once('_') {
            Some((name, unit @ ("deg" | "rad"))) => (name.to_owned(), unit.to_owned()),
            _ => (cell, String::new()),
        }
    };
    cells(&packed, separator).into_iter().map(split).collect()
}

impl Header {
    /// The columns of the first line; notes problems.
    pub fn of(line: &Line<'_>, separator: char, notes: &mut Notes) -> Option<Self> {
        let names = names(line.text, separator);
        let kinds: Vec<_> = names.iter().map(|(name, _)| Kind::of(name)).collect();
        for ((name, _), kind) in names.iter().zip(&kinds) {
            if *kind == Kind::Other {
                notes.remark(
                    line.number,
                    &format!("column \"{name}\" is not known and not used"),
                );
            }
        }
        let count = |kind: Kind| kinds.iter().filter(|known| **known == kind).count();
        let mut is_sound = true;
        for kind in [Kind::Alpha, Kind::Lift, Kind::Drag] {
            if count(kind) == 0 {
                notes.missing(
                    line.number,
                    &format!("column \"{}\"", kind.title()),
                    "write \"alpha [deg],cl,cd,cm\"",
                );
                is_sound = false;
            }
        }
        if let Some(kind) = kinds
            .iter()
            .find(|kind| **kind != Kind::Other && count(**kind) > 1)
        {
            let found = format!("two columns \"{}\"", kind.title());
            notes.wrong(
                line.number,
                [
                    "the header",
                    &found,
                    "each column once",
                    "delete one of them",
                ],
            );
            is_sound = false;
        }
        let unit = unit(line.number, &names, &kinds, Kind::Alpha, notes);
        let flap = unit_of_flap(line.number, &names, &kinds, notes);
        let factors = names.iter().zip(&kinds);
        let factors: Vec<_> = factors
            .map(|((_, unit), kind)| factor(line.number, *kind, unit, notes))
            .collect();
        let header = Self {
            kinds,
            factors: factors.into_iter().collect::<Option<_>>()?,
            unit: unit?,
            flap: flap?,
        };
        is_sound.then_some(header)
    }

    /// The index of a column.
    pub fn column(&self, kind: Kind) -> Option<usize> {
        self.kinds.iter().position(|known| *known == kind)
    }
}

/// The factor of a column: 1, a per cent, or a number such as `1e6`; notes another unit. Angles have
/// units of their own.
fn factor(line: usize, kind: Kind, unit: &str, notes: &mut Notes) -> Option<f64> {
    if matches!(kind, Kind::Name | Kind::Alpha | Kind::Flap | Kind::Other) {
        return Some(1.0);
    }
    match unit {
        "" | "-" => Some(1.0),
        "%" => Some(0.01),
        other => {
            let number = other.parse().ok().filter(|found: &f64| *found > 0.0);
            let factor = number.filter(|found| found.is_finite());
            if factor.is_none() {
                let of = format!("unit of column \"{}\"", kind.title());
                let help = "delete the unit; the numbers have none";
                let expected = "none, [-], [%] or a factor, such as [1e6]";
                notes.wrong(line, [&of, &format!("\"{other}\""), expected, help]);
            }
            factor
        }
    }
}

fn unit_of_flap(
    line: usize,
    names: &[(String, String)],
    kinds: &[Kind],
    notes: &mut Notes,
) -> Option<Unit> {
    if kinds.contains(&Kind::Flap) {
        unit(line, names, kinds, Kind::Flap, notes)
    } else {
        Some(Unit::Degrees)
    }
}

/// The unit of a column of angles; notes a missing one.
fn unit(
    line: usize,
    names: &[(String, String)],
    kinds: &[Kind],
    kind: Kind,
    notes: &mut Notes,
) -> Option<Unit> {
    let index = kinds.iter().position(|known| *known == kind)?;
    let (_, unit) = names.get(index)?;
    match unit.as_str() {
        "deg" | "degree" | "degrees" => Some(Unit::Degrees),
        "rad" => Some(Unit::Radians),
        other => {
            let what = format!("unit of column \"{}\"", kind.title());
            let help = format!("write \"{} [deg]\"", kind.title());
            notes.wrong(
                line,
                [&what, &format!("\"{other}\""), "[deg] or [rad]", &help],
            );
            None
        }
    }
}

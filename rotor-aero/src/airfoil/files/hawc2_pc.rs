//! Profile coefficients of HAWC2: sets of profiles by thickness.
//!
//! The first line has the number of sets; a set has a line with its number of profiles; a profile
//! has a line "index rows thickness[%] text", then rows of angle [deg], lift, drag and moment.
//! Text after the numbers of a line is a comment. Every profile has its own grid.

use shared_geom::error::shortened;
use shared_geom::exchange::text::{Line, lines, number};

use super::grid::{Grid, Row, Unit};
use super::joint::{Joint, is_sound};
use super::notes::Notes;
use super::reading::{Options, ReadAirfoil, Writing};

/// Whether `text` begins like a file of profiles.
pub(super) fn recognize(text: &str) -> bool {
    let lines: Vec<_> = lines(text).into_iter().take(4).collect();
    let is_count = |i: usize| {
        lines
            .get(i)
            .is_some_and(|line: &Line<'_>| line.first().parse::<usize>().is_ok())
    };
    let numbers = |i: usize| {
        lines
            .get(i)
            .map_or(0, |line| line.words().take(4).map_while(number).count())
    };
    let is_profile = numbers(2) == 3 || (numbers(2) == 4 && numbers(3) == 4);
    is_count(0) && is_count(1) && is_count(2) && is_profile && numbers(3) == 4
}

/// The lines of a file, taken one by one.
struct Lines<'t> {
    all: Vec<Line<'t>>,
    next: usize,
}

impl<'t> Lines<'t> {
    /// The next line; notes the end of the file.
    fn take(&mut self, what: &str, expected: &str, notes: &mut Notes) -> Option<Line<'t>> {
        let line = self.all.get(self.next).copied();
        self.next += 1;
        if line.is_none() {
            let last = self.all.last().map_or(0, |line| line.number);
            notes.cut(last, what, expected);
        }
        line
    }
}

/// Reads the profiles of all sets.
pub(super) fn read(text: &str, _: &Options, notes: &mut Notes) -> Option<Vec<ReadAirfoil>> {
    let mut lines = Lines {
        all: lines(text),
        next: 0,
    };
    let head = lines.take("the first line", "the number of sets", notes)?;
    let sets = notes.count(head.number, "number of sets", head.first())?;
    let mut airfoils = Vec::new();
    for set in 1..=sets {
        let name = format!("set {set} of {sets}");
        let line = lines.take(&name, "its number of profiles", notes)?;
        let profiles = notes.count(line.number, "number of profiles", line.first())?;
        for index in 1..=profiles {
            let prefix = if sets > 1 {
                format!("set {set}, ")
            } else {
                String::new()
            };
            airfoils.push(profile((set, index), &prefix, &mut lines, notes)?);
        }
    }
    check_rest(&lines, notes);
    check_thickness(&airfoils, notes);
    Some(airfoils)
}

/// Reads one profile.
fn profile(
    (set, index): (usize, usize),
    prefix: &str,
    lines: &mut Lines<'_>,
    notes: &mut Notes,
) -> Option<ReadAirfoil> {
    let what = format!("profile {index} of set {set}");
    let head = lines.take(&what, "a line \"index rows thickness\"", notes)?;
    let words: Vec<_> = head.words().take(3).collect();
    let [number, count, thickness] = words[..] else {
        let found = format!("\"{}\"", shortened(head.text));
        let help = "the counts of the file may be wrong";
        notes.wrong(
            head.number,
            [
                &what,
                &found,
                "three numbers: index, rows, thickness in per cent",
                help,
            ],
        );
        return None;
    };
    if number.parse() != Ok(index) {
        notes.remark(head.number, &format!("{what} has the index \"{number}\""));
    }
    let count = notes.count(head.number, &format!("rows of {what}"), count)?;
    let percent = notes.number(head.number, &format!("thickness of {what}"), thickness)?;
    let mut rows = Vec::new();
    for row in 1..=count {
        let line = lines.take(&what, &format!("{count} rows, found {}", row - 1), notes)?;
        if let Some([alpha, lift, drag, moment]) = numbers(&line, &what, notes) {
            let values = vec![lift, drag, moment];
            rows.push(Row {
                line: line.number,
                alpha,
                values,
            });
        }
    }
    let mut airfoil = ReadAirfoil {
        set: Some(set),
        ..ReadAirfoil::default()
    };
    airfoil.data.name = format!("{prefix}t/c {percent} %");
    airfoil.data.thickness = Some(percent / 100.0);
    if let Some(grid) = Grid::of(&rows, Unit::Degrees, (&what, head.number), notes) {
        airfoil.data.lift.extend(grid.curve(0, [None; 3]));
        airfoil.data.drag.extend(grid.curve(1, [None; 3]));
        airfoil.data.moment.extend(grid.curve(2, [None; 3]));
    }
    Some(airfoil)
}

/// The four numbers of a row, of which text may follow.
fn numbers(line: &Line<'_>, what: &str, notes: &mut Notes) -> Option<[f64; 4]> {
    let words: Vec<_> = line.words().take(4).collect();
    if words.len() < 4
        || line
            .words()
            .nth(4)
            .is_some_and(|word| number(word).is_some())
    {
        let found = format!("\"{}\"", shortened(line.text));
        let help = "the line may have been cut off, or the number of rows is wrong";
        notes.wrong(
            line.number,
            [
                what,
                &found,
                "four numbers: angle, lift, drag, moment",
                help,
            ],
        );
        return None;
    }
    let name = format!("a row of {what}");
    let numbers: Vec<_> = words
        .iter()
        .map(|word| notes.number(line.number, &name, word))
        .collect();
    let numbers: Option<Vec<f64>> = numbers.into_iter().collect();
    numbers?.try_into().ok()
}

/// Notes lines after the last profile.
fn check_rest(lines: &Lines<'_>, notes: &mut Notes) {
    let Some(line) = lines.all.get(lines.next) else {
        return;
    };
    if number(line.first()).is_none() {
        notes.remark(line.number, "the lines from here on are not read");
        return;
    }
    let found = format!("\"{}\"", shortened(line.text));
    let help = "the number of sets, profiles or rows may be wrong";
    notes.wrong(
        line.number,
        ["HAWC2 pc file", &found, "the end of the file", help],
    );
}

/// Notes profiles of a set that are not in the order of the thickness.
fn check_thickness(airfoils: &[ReadAirfoil], notes: &mut Notes) {
    for two in airfoils.windows(2) {
        let is_falling = two[0].data.thickness >= two[1].data.thickness;
        if two[0].set == two[1].set && is_falling {
            let found = format!("\"{}\" after \"{}\"", two[1].data.name, two[0].data.name);
            let help = "put the profiles of a set in the order of the thickness";
            notes.wrong(
                0,
                ["profiles of a set", &found, "ascending thickness", help],
            );
        }
    }
}

/// The airfoils as a file: sets as they were read, one set for airfoils of no set.
pub(super) fn write(airfoils: &[ReadAirfoil], notes: &mut Notes) -> Option<Writing> {
    let mut sets: Vec<usize> = airfoils
        .iter()
        .map(|airfoil| airfoil.set.unwrap_or(1))
        .collect();
    sets.sort_unstable();
    sets.dedup();
    let mut lost = Vec::new();
    let mut text = format!("{} sets of profiles\n", sets.len());
    for set in sets {
        let mut of_set: Vec<_> = airfoils
            .iter()
            .filter(|airfoil| airfoil.set.unwrap_or(1) == set)
            .collect();
        let thickness = |airfoil: &ReadAirfoil| airfoil.data.thickness.unwrap_or(0.0);
        of_set.sort_by(|a, b| thickness(a).total_cmp(&thickness(b)));
        if of_set
            .windows(2)
            .any(|two| thickness(two[0]) == thickness(two[1]))
        {
            let help = "put one of them into another set";
            notes.wrong(
                0,
                [
                    "profiles of a set",
                    "two of one thickness",
                    "different ones",
                    help,
                ],
            );
        }
        text += &format!("{} profiles\n", of_set.len());
        for (i, airfoil) in of_set.into_iter().enumerate() {
            text += &written(i + 1, airfoil, &mut lost, notes)?;
        }
    }
    Some(Writing { text, lost })
}

/// One profile as text.
fn written(
    index: usize,
    airfoil: &ReadAirfoil,
    lost: &mut Vec<String>,
    notes: &mut Notes,
) -> Option<String> {
    let data = &airfoil.data;
    let name = format!("airfoil \"{}\"", data.name);
    let Some(thickness) = data.thickness else {
        notes.missing(
            0,
            &format!("{name}: the thickness"),
            "HAWC2 finds profiles by their thickness",
        );
        return None;
    };
    if !is_sound(data, notes) {
        return None;
    }
    let ([lift], [drag], [] | [_]) = (&data.lift[..], &data.drag[..], &data.moment[..]) else {
        let help = "write one file per Mach number, Reynolds number and deflection";
        notes.wrong(0, [&name, "several tables", "one per coefficient", help]);
        return None;
    };
    if [lift, drag]
        .iter()
        .any(|curve| curve.mach.is_some() || curve.flap.is_some() || curve.reynolds.is_some())
    {
        lost.push(format!(
            "{name}: the Mach number, Reynolds number and deflection"
        ));
    }
    let mut curves = vec![lift, drag];
    match data.moment.first() {
        Some(moment) => curves.push(moment),
        None => lost.push(format!("{name}: it has no moment, which is written as 0")),
    }
    let joint = Joint::of(&curves);
    if joint.added > 0 {
        lost.push(format!(
            "{name}: {} values are interpolated to a common grid",
            joint.added
        ));
    }
    let comment = data.name.replace(['\n', '\r'], " ");
    let mut text = format!(
        "{index} {} {} {comment}\n",
        joint.alpha.len(),
        thickness * 100.0
    );
    text += &rows(&joint);
    Some(text)
}

/// The rows of a profile; a column that does not exist is 0.
fn rows(joint: &Joint) -> String {
    let mut text = String::new();
    for (i, alpha) in joint.alpha.iter().enumerate() {
        text += &format!("{:24.16e}", alpha.to_degrees());
        for column in 0..3 {
            let values = joint.columns.get(column);
            let value = values.and_then(|values| values.get(i)).copied();
            text += &format!("{:24.16e}", value.unwrap_or(0.0));
        }
        text += "\n";
    }
    text
}

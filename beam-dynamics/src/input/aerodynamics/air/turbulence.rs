//! Turbulence boxes from files: `[air.turbulence]`.

use std::path::PathBuf;

use rotor_aero::wind::{
    BladedInput, MannInput, Mean, MeanWind, OutsideGrid, PlaneOrder, Shear, TurbulenceBox,
    read_bladed, read_bts, read_mann, read_summary,
};
use shared_geom::document::schema::ValueKind::{
    Boolean, Count, Positive, Quantity, Text, Texts, Vector, Word,
};
use shared_geom::document::{Table, read_text};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::mean::MeanCard;
use super::problem::AirProblem;

keys! {
    /// A turbulence box that is carried downwind; its planes are read when they are needed.
    pub(super) CARD = "[air.turbulence]";
    /// A file of TurbSim (`.bts`) or Bladed (`.wnd`), which contains the mean wind.
    pub(super) FILE: Option<String> = "file", [Text], optional, "\"seed1.bts\"";
    /// The files of u, v, w of a Mann box, which do not contain the mean wind.
    pub(super) FILES: Option<Vec<String>> = "files", [Texts], optional, "[\"u.bin\", \"v.bin\", \"w.bin\"]";
    /// Mann box: numbers of points downwind, lateral and up.
    POINTS: Option<[f64; 3]> = "points", [Vector(3, Dimension::NUMBER)], optional,
        "[8192, 32, 32]";
    /// Mann box: distances of the points.
    SPACING: Option<[f64; 3]> = "spacing", [Vector(3, Dimension::LENGTH)], optional, "[1, 5, 5]";
    /// Mann box: speed at which it is carried.
    SPEED: Option<f64> = "speed", [Positive(Dimension::VELOCITY)], or "the speed of the wind", "12";
    /// Mann box: standard deviations of u, v and w to which it is scaled.
    SIGMA: Option<[f64; 3]> = "sigma", [Vector(3, Dimension::VELOCITY)], or "as in the files",
        "[1.8, 1.4, 0.9]";
    /// Mann box: whether the last plane of the files arrives first.
    REVERSED: bool = "reversed", [Boolean], or "false" = false, "true";
    /// Height of its middle above the ground: of a Mann box, and of a `.wnd` that does not contain
    /// it.
    HUB_HEIGHT: Option<f64> = "hub_height", [Positive(Dimension::LENGTH)], optional, "90";
    /// `.wnd`: the summary file, `.sum`.
    SUMMARY: Option<String> = "summary", [Text], optional, "\"seed1.sum\"";
    /// `.wnd`: turbulence intensities of u, v and w in per cent.
    INTENSITIES: Option<[f64; 3]> = "intensities", [Vector(3, Dimension::NUMBER)],
        or "as in the files", "[16, 12.8, 8]";
    /// `.wnd`: whether the first plane follows the last.
    PERIODIC: Option<bool> = "periodic", [Boolean], or "as in `summary`, else false", "true";
    /// `.wnd`: whether v has the sign of a left-handed system.
    LEFT_HANDED: bool = "left_handed", [Boolean], or "false" = false, "true";
    /// Downwind position of the first plane at time zero.
    SHIFT: Option<f64> = "shift", [Quantity(Dimension::LENGTH)],
        or "half the width of a box that is not periodic, else 0", "70";
    /// Points beside, above and below: an error, or the wind of the nearest point of the box.
    OUTSIDE: usize = "outside", [Word(&["error", "extend"])], or "\"error\"" = 0, "\"extend\"";
    /// Largest number of planes in memory.
    CACHE: Option<usize> = "cache", [Count(1_000_000)], or "64 MB of planes", "200";
}

/// Keys of Mann boxes alone, and of `.wnd` alone.
const OF_MANN: [&str; 5] = [
    POINTS.name(),
    SPACING.name(),
    SPEED.name(),
    SIGMA.name(),
    REVERSED.name(),
];
const OF_BLADED: [&str; 4] = [
    SUMMARY.name(),
    INTENSITIES.name(),
    PERIODIC.name(),
    LEFT_HANDED.name(),
];

/// Keys that scale a box.
pub(super) const OF_SCALE: [&str; 2] = [SIGMA.name(), INTENSITIES.name()];

/// Reads the table. Without a mean wind, only the keys and the files are checked.
pub(super) fn read(table: &Table<'_>, mean: Option<&MeanCard>) -> Option<TurbulenceBox> {
    let (file, files) = (table.get(&FILE), table.get(&FILES));
    let (mann, bladed) = (mann(table, mean), bladed(table));
    let (shift, outside, cache) = (table.get(&SHIFT), table.get(&OUTSIDE), table.get(&CACHE));
    table.finish();
    let cache = cache?;
    let found = match (file?, files?) {
        (Some(_), Some(_)) => useless(table, FILES.name(), "\"file\" names a box already"),
        (None, None) => {
            let key = FILE.name();
            let user = "[air.turbulence], or \"files\" of a Mann box";
            table.note(key, &AirProblem::Missing { key, user });
            None
        }
        (Some(file), None) => {
            one_file(table, &file, (bladed, cache)).filter(|_| with_mean(table, mean))
        }
        (None, Some(files)) => {
            let paths = three(table, &files);
            only(table, &OF_BLADED, "it belongs to a file .wnd")?;
            let (input, files) = (mann??, paths?);
            let input = MannInput {
                files,
                cache,
                ..input
            };
            table.keep_file(FILES.name(), read_mann(&input))
        }
    };
    let outside = [OutsideGrid::Refuse, OutsideGrid::Extend][outside?];
    let found = found?.with_outside(outside);
    Some(match shift? {
        Some(shift) => found.with_shift(shift),
        None => found,
    })
}

fn useless<T>(table: &Table<'_>, key: &'static str, reason: &'static str) -> Option<T> {
    table.note(key, &AirProblem::Useless { key, reason });
    None
}

/// Notes each of the keys that the table has.
fn only(table: &Table<'_>, keys: &[&'static str], reason: &'static str) -> Option<()> {
    let found: Vec<_> = keys.iter().filter(|key| table.has(key)).collect();
    for key in &found {
        let _: Option<()> = useless(table, key, reason);
    }
    found.is_empty().then_some(())
}

/// The box of one file, by the ending of its name.
fn one_file(
    table: &Table<'_>,
    file: &str,
    (bladed, cache): (Option<BladedInput>, Option<usize>),
) -> Option<TurbulenceBox> {
    let path = table.existing(&FILE, file);
    only(table, &OF_MANN, "it belongs to the \"files\" of a Mann box")?;
    let ending = file
        .rsplit_once('.')
        .map(|(_, ending)| ending.to_lowercase());
    match ending.as_deref() {
        Some("bts") => {
            only(table, &OF_BLADED, "it belongs to a file .wnd")?;
            only(table, &[HUB_HEIGHT.name()], "the file .bts contains it")?;
            table.keep_file(FILE.name(), read_bts(&path?, cache))
        }
        Some("wnd") => {
            let input = BladedInput { cache, ..bladed? };
            table.keep_file(FILE.name(), read_bladed(&path?, &input))
        }
        _ => {
            let expected =
                "the name of a file .bts or .wnd; the three files of a Mann box are \"files\"";
            table.wrong(&FILE, expected);
            None
        }
    }
}

/// Whether the mean wind is zero, since the box contains it; noted if not.
fn with_mean(table: &Table<'_>, mean: Option<&MeanCard>) -> bool {
    let Some(card) = mean else { return false };
    let found = card.mean.at(0.0);
    let changes = matches!(card.mean, Mean::Function(_)) || card.mean.next_corner(0.0).is_finite();
    if found.speed == 0.0 && found.vertical == 0.0 && !changes {
        return without_effect(table, &found);
    }
    let problem = AirProblem::Value {
        key: "speed",
        found: if changes {
            "a number that changes in the wind of [air]".to_owned()
        } else {
            format!("{} m/s in the wind of [air]", found.speed)
        },
        expected: "no mean wind, since the file contains it".to_owned(),
        help: "keep the directions of [air.wind], and remove its speed, shear and table",
    };
    table.note(&FILE, &problem);
    false
}

/// Whether the mean wind has nothing that a file with its own mean wind ignores; each is noted.
fn without_effect(table: &Table<'_>, mean: &MeanWind) -> bool {
    let law = match mean.shear {
        Shear::Uniform => None,
        Shear::Power { .. } => Some("exponent"),
        Shear::Log { .. } => Some("roughness"),
    };
    let numbers = [
        ("turn", mean.direction),
        ("upflow", mean.upflow),
        ("veer", mean.veer),
        ("horizontal_shear", mean.horizontal_shear),
        ("vertical_shear", mean.vertical_shear),
    ];
    let numbers = numbers
        .iter()
        .filter_map(|(key, value)| (*value != 0.0).then_some(*key));
    let found: Vec<_> = law.into_iter().chain(numbers).collect();
    for key in &found {
        let problem = AirProblem::Value {
            key,
            found: "in the wind of [air]".to_owned(),
            expected: "no such key: the file contains the mean wind, which blows along \
                       \"direction\""
                .to_owned(),
            help: "remove it; \"direction\" of [air.wind] turns the box with its mean wind",
        };
        table.note(&FILE, &problem);
    }
    found.is_empty()
}

fn bladed(table: &Table<'_>) -> Option<BladedInput> {
    let (intensities, hub_height) = (table.get(&INTENSITIES), table.get(&HUB_HEIGHT));
    let (periodic, left_handed) = (table.get(&PERIODIC), table.get(&LEFT_HANDED));
    let summary = match table.get(&SUMMARY)? {
        None => None,
        Some(name) => {
            let path = table.existing(&SUMMARY, &name)?;
            let shown = path.display().to_string();
            let read = read_text(&path).and_then(|text| read_summary(&text, &shown));
            Some(table.keep_file(SUMMARY.name(), read)?)
        }
    };
    Some(BladedInput {
        summary,
        intensities: intensities?,
        hub_height: hub_height?,
        periodic: periodic?,
        left_handed: left_handed?,
        cache: None,
    })
}

/// Numbers of a Mann box; `Some(None)` if some are missing, which is noted with its files.
fn mann(table: &Table<'_>, mean: Option<&MeanCard>) -> Option<Option<MannInput>> {
    let (points, spacing) = (table.get(&POINTS), table.get(&SPACING));
    let (speed, sigma) = (table.get(&SPEED), table.get(&SIGMA));
    let (reversed, hub_height) = (table.get(&REVERSED), table.get(&HUB_HEIGHT));
    let (points, spacing, hub_height) = (points?, spacing?, hub_height?);
    let (speed, sigma, reversed) = (speed?, sigma?, reversed?);
    if !table.has(&FILES) {
        return Some(None);
    }
    let given = [points.is_some(), spacing.is_some(), hub_height.is_some()];
    let names = [POINTS.name(), SPACING.name(), HUB_HEIGHT.name()];
    for key in names
        .iter()
        .zip(given)
        .filter_map(|(key, given)| (!given).then_some(*key))
    {
        let user = "a Mann box";
        table.note(key, &AirProblem::Missing { key, user });
    }
    let (Some(points), Some(steps), Some(hub_height)) = (points, spacing, hub_height) else {
        return Some(None);
    };
    let points = counts(table, points)?;
    let speed = speed.or_else(|| mean.map(|mean| mean.speed(hub_height, 0.0)))?;
    if speed == 0.0 {
        let problem = AirProblem::Value {
            key: "speed",
            found: "0 m/s at the hub".to_owned(),
            expected: "the speed by which the planes of a Mann box pass".to_owned(),
            help: "give \"speed\" in [air.wind], or here",
        };
        table.note(&FILES, &problem);
        return Some(None);
    }
    let order = if reversed {
        PlaneOrder::LastArrives
    } else {
        PlaneOrder::FirstArrives
    };
    Some(Some(MannInput {
        files: [None, None, None],
        points,
        steps,
        speed,
        hub_height,
        sigma,
        order,
        cache: None,
    }))
}

fn counts(table: &Table<'_>, points: [f64; 3]) -> Option<[usize; 3]> {
    const MOST: f64 = 1e9;
    let is_count = |number: &f64| number.fract() == 0.0 && (1.0..=MOST).contains(number);
    if !points.iter().all(is_count) {
        table.wrong(&POINTS, "three whole numbers of at least 1");
        return None;
    }
    Some(points.map(|number| number as usize))
}

fn three(table: &Table<'_>, files: &[String]) -> Option<[Option<PathBuf>; 3]> {
    let paths = files.iter().map(|file| table.existing(&FILES, file));
    let paths: Vec<_> = paths.collect();
    match <[Option<PathBuf>; 3]>::try_from(paths) {
        Ok(paths) => paths.iter().all(Option::is_some).then_some(paths),
        Err(_) => {
            table.wrong(&FILES, "three files: of u, v and w");
            None
        }
    }
}

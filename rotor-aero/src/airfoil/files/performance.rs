//! Measured propellers of UIUC: rows of J, CT, CP, eta at one speed, or of RPM, CT, CP at rest.
//!
//! `CT = T / (rho n^2 D^4)`, `CP = P / (rho n^3 D^5)`, `J = V / (n D)`, n in revolutions per
//! second and D the diameter. The speed of a table of J is the last number in the name of its
//! file, as in `apcsf_10x7_kt0831_5003.txt` (Propeller Data Site, Brandt and Selig 2011).

use std::f64::consts::PI;
use std::path::Path;

use shared_geom::error::Diagnostics;
use shared_geom::exchange::text::lines;

use super::notes::Notes;
use super::source::text_of;

/// A point of a measured propeller.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PropellerPoint {
    /// Advance ratio V / (n D) \[-\].
    pub advance_ratio: f64,
    /// Rotor speed, if known \[rad/s\].
    pub speed: Option<f64>,
    /// Thrust over density, speed in rev/s squared and diameter to the fourth \[-\].
    pub thrust: f64,
    /// Power over density, speed in rev/s cubed and diameter to the fifth \[-\].
    pub power: f64,
    /// Efficiency J CT / CP as in the file; absent at rest \[-\].
    pub efficiency: Option<f64>,
}

/// Reads the measured points of the file at `path`.
///
/// # Errors
/// A file that cannot be read, and all errors of the content.
pub fn read_performance(path: &Path) -> Result<Vec<PropellerPoint>, Diagnostics> {
    parse_performance(&text_of(path)?, path)
}

/// Reads the measured points of a text in the file at `path`.
///
/// # Errors
/// All errors of the content.
pub fn parse_performance(text: &str, path: &Path) -> Result<Vec<PropellerPoint>, Diagnostics> {
    let mut notes = Notes::new(path);
    let lines = lines(text);
    let (head, rows) = lines.split_at(lines.len().min(1));
    let titles: Vec<_> = head
        .iter()
        .flat_map(|line| line.words())
        .map(str::to_ascii_lowercase)
        .collect();
    let titles: Vec<_> = titles.iter().map(String::as_str).collect();
    let mut points = Vec::new();
    match titles[..] {
        ["j", "ct", "cp", "eta"] => {
            let speed = named_speed(path);
            for line in rows {
                let row = line.numbers("row of the table", &mut notes.problems);
                points.extend(
                    row.map(|[advance_ratio, thrust, power, eta]| PropellerPoint {
                        advance_ratio,
                        speed,
                        thrust,
                        power,
                        efficiency: Some(eta),
                    }),
                );
            }
        }
        ["rpm", "ct", "cp"] => {
            for line in rows {
                let row = line.numbers("row of the table", &mut notes.problems);
                points.extend(row.map(|[rpm, thrust, power]| PropellerPoint {
                    advance_ratio: 0.0,
                    speed: Some(rpm * PI / 30.0),
                    thrust,
                    power,
                    efficiency: None,
                }));
            }
        }
        _ => {
            let found = format!("\"{}\"", titles.join(" "));
            notes.wrong(
                1,
                [
                    "titles of the table",
                    &found,
                    "\"J CT CP eta\" or \"RPM CT CP\"",
                    "give a file of the Propeller Data Site of UIUC",
                ],
            );
        }
    }
    if points.is_empty() {
        notes.missing(0, "a row of numbers", "the file may have been cut off");
    }
    Ok(notes.finish(Some(points), "the table of a propeller")?.0)
}

/// The speed in the name of a file [rad/s].
fn named_speed(path: &Path) -> Option<f64> {
    let stem = path.file_stem()?.to_string_lossy().into_owned();
    let rpm: f64 = stem.rsplit('_').next()?.parse().ok()?;
    (rpm > 0.0).then_some(rpm * PI / 30.0)
}

#[cfg(test)]
mod tests {
    use super::super::samples::path;
    use super::*;

    /// First, last and number of rows by inspection of the files.
    #[test]
    fn tables_of_uiuc_are_read() {
        let folder = "aero/propellers";
        let points =
            read_performance(&path(&format!("{folder}/apcff_4.2x4_0620rd_10042.txt"))).unwrap();
        assert_eq!(
            (
                points[0].advance_ratio,
                points[0].thrust,
                points[0].power,
                points[0].efficiency
            ),
            (0.068988, 0.133330, 0.112496, Some(0.081764))
        );
        assert!((points[0].speed.unwrap() - 10042.0 * PI / 30.0).abs() < 1e-9);
        // J CT / CP of the file, rounded to six decimals.
        assert!(
            points.iter().all(
                |p| (p.advance_ratio * p.thrust / p.power - p.efficiency.unwrap()).abs() < 2e-5
            )
        );
        let rest =
            read_performance(&path(&format!("{folder}/apcsf_10x7_static_kt0827.txt"))).unwrap();
        assert_eq!(
            (
                rest.len(),
                rest[15].thrust,
                rest[15].power,
                rest[15].advance_ratio
            ),
            (16, 0.1606, 0.0797, 0.0)
        );
        for file in std::fs::read_dir(path(folder)).unwrap() {
            let file = file.unwrap().path();
            let name = file.file_name().unwrap().to_string_lossy().into_owned();
            if name.starts_with("apc") && !name.contains("geom") && name.ends_with(".txt") {
                assert!(read_performance(&file).is_ok(), "{name}");
            }
        }
    }

    #[test]
    fn wrong_tables_are_reported() {
        let shown = |text: &str| {
            parse_performance(text, Path::new("a.txt"))
                .unwrap_err()
                .to_string()
        };
        assert!(
            shown("J CT CP eta\n0.1 0.2 x 0.3\n0.1 0.2\n")
                .contains("a.txt:3: row of the table: expected 4 numbers")
        );
        assert!(shown("r/R c/R beta\n").contains("expected \"J CT CP eta\""));
        assert!(shown("").contains("a row of numbers is missing"));
    }
}

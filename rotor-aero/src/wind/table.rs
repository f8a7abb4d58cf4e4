//! Mean wind that changes with time: linear between the times of a table, constant outside, or a
//! given function of time.

use std::f64::consts::TAU;
use std::fmt::Debug;
use std::sync::Arc;

use super::problem::WindProblem;
use super::profile::{MeanWind, Shear};

/// Mean wind as a function of time.
pub trait WindOverTime: Debug + Send + Sync {
    /// The mean wind at a time \[s\].
    fn at(&self, time: f64) -> MeanWind;

    /// The first time after `time` \[s\] at which it is not smooth; infinite without one.
    fn next_corner(&self, time: f64) -> f64;
}

/// Mean wind over time.
#[derive(Debug, Clone)]
pub enum Mean {
    /// The same at all times.
    Steady(MeanWind),
    /// Linear between given times.
    Table(WindTable),
    /// A function of time.
    Function(Arc<dyn WindOverTime>),
}

impl Mean {
    /// The mean wind at a time \[s\].
    pub fn at(&self, time: f64) -> MeanWind {
        match self {
            Self::Steady(wind) => *wind,
            Self::Table(table) => table.at(time),
            Self::Function(of) => of.at(time),
        }
    }

    /// The first row of the table, or corner of the function, after `time` \[s\]; infinite without
    /// one.
    pub fn next_corner(&self, time: f64) -> f64 {
        match self {
            Self::Steady(_) => f64::INFINITY,
            Self::Table(table) => table.next_row(time),
            Self::Function(of) => of.next_corner(time),
        }
    }
}

impl Default for Mean {
    fn default() -> Self {
        Self::Steady(MeanWind::default())
    }
}

/// Mean wind at ascending times.
#[derive(Debug, Clone, PartialEq)]
pub struct WindTable {
    rows: Vec<(f64, MeanWind)>,
}

impl WindTable {
    /// A table of times \[s\] and winds. Between two rows the direction turns the short way.
    ///
    /// # Errors
    /// No row, times that do not ascend, or different laws of height.
    pub fn new(rows: Vec<(f64, MeanWind)>) -> Result<Self, WindProblem> {
        const HELP: &str = "sort the rows by time, and give each time once";
        if rows.is_empty() {
            let expected = "at least one row";
            return Err(WindProblem::value("rows of the wind", 0.0, expected, HELP));
        }
        for pair in rows.windows(2) {
            let [(before, first), (time, second)] = [pair[0], pair[1]];
            if time.is_nan() || time <= before {
                let expected = format!("a time after {before} s");
                return Err(WindProblem::value(
                    "time of the wind [s]",
                    time,
                    &expected,
                    HELP,
                ));
            }
            if std::mem::discriminant(&first.shear) != std::mem::discriminant(&second.shear) {
                let help = "use the same law of height in all rows";
                return Err(WindProblem::value(
                    "row of the wind [s]",
                    time,
                    "one law",
                    help,
                ));
            }
        }
        if let Some((time, _)) = rows.iter().find(|row| !row.0.is_finite()) {
            let problem = WindProblem::value("time of the wind [s]", *time, "a number", HELP);
            return Err(problem);
        }
        Ok(Self {
            rows: turned_the_short_way(rows),
        })
    }

    /// The mean wind at a time \[s\].
    pub fn at(&self, time: f64) -> MeanWind {
        let next = self.rows.partition_point(|row| row.0 <= time);
        let (Some((t1, first)), Some((t2, second))) = (
            next.checked_sub(1).map(|i| self.rows[i]),
            self.rows.get(next),
        ) else {
            // constant outside the table
            return self.rows[next.saturating_sub(1)].1;
        };
        between(&first, second, (time - t1) / (t2 - t1))
    }

    /// Time of the first row after `time` \[s\]; infinite without one.
    fn next_row(&self, time: f64) -> f64 {
        let next = self.rows.partition_point(|row| row.0 <= time);
        self.rows.get(next).map_or(f64::INFINITY, |row| row.0)
    }

    /// First and last time \[s\].
    pub fn times(&self) -> [f64; 2] {
        [self.rows[0].0, self.rows[self.rows.len() - 1].0]
    }
}

/// The rows with directions that differ by half a turn at most from one row to the next.
fn turned_the_short_way(mut rows: Vec<(f64, MeanWind)>) -> Vec<(f64, MeanWind)> {
    for index in 1..rows.len() {
        let before = rows[index - 1].1.direction;
        let wind = &mut rows[index].1;
        wind.direction -= TAU * ((wind.direction - before) / TAU).round();
    }
    rows
}

/// The wind at the fraction `s` of the way from `a` to `b`.
fn between(a: &MeanWind, b: &MeanWind, s: f64) -> MeanWind {
    let mix = |a: f64, b: f64| a + (b - a) * s;
    let shear = match (a.shear, b.shear) {
        (Shear::Power { exponent: a }, Shear::Power { exponent: b }) => Shear::Power {
            exponent: mix(a, b),
        },
        (Shear::Log { roughness: a }, Shear::Log { roughness: b }) => Shear::Log {
            roughness: mix(a, b),
        },
        _ => a.shear,
    };
    MeanWind {
        speed: mix(a.speed, b.speed),
        reference_height: mix(a.reference_height, b.reference_height),
        shear,
        direction: mix(a.direction, b.direction),
        veer: mix(a.veer, b.veer),
        upflow: mix(a.upflow, b.upflow),
        horizontal_shear: mix(a.horizontal_shear, b.horizontal_shear),
        vertical_shear: mix(a.vertical_shear, b.vertical_shear),
        reference_length: mix(a.reference_length, b.reference_length),
        vertical: mix(a.vertical, b.vertical),
        gust: mix(a.gust, b.gust),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(speed: f64) -> MeanWind {
        MeanWind {
            speed,
            shear: Shear::Power {
                exponent: speed / 100.0,
            },
            ..Default::default()
        }
    }

    #[test]
    fn linear_inside_and_constant_outside() {
        let table = WindTable::new(vec![(1.0, of(8.0)), (3.0, of(10.0))]).unwrap();
        for (time, speed) in [
            (-5.0, 8.0),
            (1.0, 8.0),
            (1.5, 8.5),
            (3.0, 10.0),
            (9.0, 10.0),
        ] {
            let wind = table.at(time);
            assert!((wind.speed - speed).abs() < 1e-14);
            let Shear::Power { exponent } = wind.shear else {
                panic!("a power law")
            };
            assert!((exponent - speed / 100.0).abs() < 1e-15);
        }
        assert_eq!(table.at(f64::NAN), of(8.0));
        assert_eq!(table.times(), [1.0, 3.0]);
    }

    /// From north to 350 degrees, and once around in four rows.
    #[test]
    fn directions_turn_the_short_way() {
        let at = |degrees: f64| MeanWind {
            direction: degrees.to_radians(),
            ..MeanWind::default()
        };
        let table = WindTable::new(vec![(0.0, at(0.0)), (10.0, at(350.0))]).unwrap();
        assert!((table.at(5.0).direction.to_degrees() + 5.0).abs() < 1e-12);
        let rows = [0.0, 120.0, 240.0, 360.0].map(|degrees| (degrees, at(degrees)));
        let table = WindTable::new(rows.to_vec()).unwrap();
        for degrees in [60.0, 180.0, 300.0, 360.0] {
            assert!((table.at(degrees).direction.to_degrees() - degrees).abs() < 1e-12);
        }
    }

    #[test]
    fn wrong_tables_are_refused() {
        assert!(WindTable::new(vec![]).is_err());
        assert!(WindTable::new(vec![(f64::NAN, of(1.0))]).is_err());
        assert!(WindTable::new(vec![(1.0, of(1.0)), (1.0, of(1.0))]).is_err());
        let uniform = MeanWind::default();
        assert!(WindTable::new(vec![(1.0, of(1.0)), (2.0, uniform)]).is_err());
    }
}

//! Modes as seen from the fixed system, and the critical speeds.

use std::f64::consts::TAU;

use super::critical::{CriticalSpeed, crossings};
use super::{Direction, FrequencyTable, ModeBranch, ModeKind, ModePoint, Whirl};
use crate::case::Words;

/// A mode at one speed, in the fixed system.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FixedPoint {
    /// Frequency, negative if the motion runs backward around the rotor [Hz].
    pub signed: f64,
    /// Direction; `None` for collective, differential, axial and torsional motion.
    pub direction: Option<Direction>,
    /// Damping ratio, relative to the frequency in the fixed system [-].
    pub damping_ratio: f64,
    /// Kind at this speed.
    pub kind: ModeKind,
}

/// A mode over the speeds, in the fixed system.
#[derive(Debug, Clone, PartialEq)]
pub struct FixedLine {
    /// Name of the mode in the turning axes, with the pattern of a shaft.
    pub name: String,
    /// Name without the pattern.
    pub stem: String,
    /// Kind of the name.
    pub kind: ModeKind,
    /// Waves around the rotor.
    pub harmonic: i32,
    /// The mode at each speed.
    pub points: Vec<Option<FixedPoint>>,
}

/// Frequencies in the fixed system over rotor speed.
#[derive(Debug, Clone, PartialEq)]
pub struct FixedTable {
    /// Modes with a pattern around the axis.
    pub lines: Vec<FixedLine>,
    /// Critical speeds, ascending, with linear interpolation between the speeds.
    pub critical: Vec<CriticalSpeed>,
}

impl FixedTable {
    /// The modes of `table` that have a pattern around the axis, and their critical speeds for the
    /// multiples `orders`; `None` if no mode has one, or with a single speed.
    pub fn new(table: &FrequencyTable, orders: &[u32]) -> Option<Self> {
        let branches = table.branches.iter();
        let lines = branches.flat_map(|branch| lines(branch, &table.speeds, table.style.words));
        let lines: Vec<_> = lines.collect();
        if lines.is_empty() || table.speeds.len() < 2 {
            return None;
        }
        let mut critical: Vec<_> = lines
            .iter()
            .flat_map(|line| critical(line, &table.speeds, orders))
            .collect();
        critical.sort_by(|a, b| a.speed.total_cmp(&b.speed));
        Some(Self { lines, critical })
    }
}

impl FrequencyTable {
    /// A remark on the modes that the Campbell diagram leaves out because no pattern around the axis
    /// prevails at any speed; `None` if there are none, or with a single speed.
    pub fn mixed_whirls(&self) -> Option<String> {
        let is_mixed = |branch: &&ModeBranch| {
            let mut whirls = branch
                .points
                .iter()
                .flatten()
                .filter_map(|point| point.whirl);
            let is_known = whirls.next().is_some();
            is_known && lines(branch, &self.speeds, self.style.words).is_empty()
        };
        let mixed = self.branches.iter().filter(is_mixed).count();
        if mixed == 0 || self.speeds.len() < 2 {
            return None;
        }
        let of = self.branches.len();
        let diagram = match FixedTable::new(self, &[]) {
            Some(_) => format!("the Campbell diagram leaves out {mixed} of {of} modes"),
            None => "there is no Campbell diagram".to_owned(),
        };
        let have = if mixed == 1 { "mode has" } else { "modes have" };
        Some(format!(
            "{diagram}: {mixed} {have} several patterns around the axis at once, as where stiffness or \
             mass differ around it, and several frequencies in the fixed system"
        ))
    }
}

impl FixedPoint {
    fn new(point: &ModePoint, whirl: Whirl, kind: ModeKind, speed: f64) -> Self {
        let signed = whirl.signed_in_fixed_system(point.frequency, speed / TAU);
        let magnitude = point.growth.hypot(TAU * signed);
        Self {
            signed,
            direction: whirl.in_fixed_system(point.frequency, speed / TAU).1,
            damping_ratio: if magnitude > 0.0 {
                0.0 - point.growth / magnitude
            } else {
                0.0
            },
            kind,
        }
    }

    /// Frequency [Hz].
    pub fn frequency(&self) -> f64 {
        self.signed.abs()
    }
}

impl FixedLine {
    /// Speeds at which the frequency passes through zero, by linear interpolation \[rad/s\].
    pub fn zeros(&self, speeds: &[f64]) -> Vec<f64> {
        let of_zero = critical(self, speeds, &[]);
        of_zero.into_iter().map(|critical| critical.speed).collect()
    }
}

/// The lines of a branch, none if its blades rest. Two blades that move against each other are a wave that runs
/// forward and one that runs backward, of equal size:
///
/// ```text
/// cos(w t) cos psi = cos(w t - psi) / 2 + cos(w t + psi) / 2 ,   seen at w + Omega and at w - Omega
/// ```
fn lines(branch: &ModeBranch, speeds: &[f64], words: Words) -> Vec<FixedLine> {
    let points = branch.points.iter().flatten();
    let mut pure = points.filter_map(|point| point.whirl.filter(Whirl::is_pure));
    let waves: &[Option<i32>] = match pure.any(|whirl| whirl.is_double()) {
        true => &[Some(1), Some(-1)],
        false => &[None],
    };
    let lines = waves
        .iter()
        .map(|wave| line((branch, *wave), speeds, words));
    lines.flatten().collect()
}

/// The line of a branch, or of one of its waves; `None` if its blades rest.
fn line(
    (branch, wave): (&ModeBranch, Option<i32>),
    speeds: &[f64],
    words: Words,
) -> Option<FixedLine> {
    let known = branch
        .points
        .iter()
        .zip(speeds)
        .filter_map(|(point, speed)| {
            let whirl = point.as_ref()?.whirl.filter(Whirl::is_pure)?;
            Some(Seen::new(of_wave(whirl, wave), point.as_ref()?, *speed))
        });
    let pure: Vec<_> = known.collect();
    let named = pure
        .iter()
        .find(|one| branch.harmonic == Some(one.pattern.harmonic));
    let Seen { whirl, pattern, .. } = *named.or(pure.last())?;
    let pattern = Whirl {
        harmonic: wave.unwrap_or(pattern.harmonic),
        ..pattern
    };
    let whirl_at = |point: &ModePoint, speed: f64| {
        let own = point.whirl.filter(Whirl::is_pure);
        own.map(|whirl| of_wave(whirl, wave))
            .unwrap_or_else(|| match whirl.blades {
                0 => nearest(&pure, speed).map_or(whirl, |near| continued(near, point, speed)),
                _ => whirl,
            })
    };
    let points = branch.points.iter().zip(speeds).map(|(point, speed)| {
        let point = point.as_ref()?;
        let whirl = whirl_at(point, *speed);
        Some(FixedPoint::new(point, whirl, branch.kind_at(point), *speed))
    });
    let is_named = wave.is_none() && (branch.harmonic.is_some() || pattern.harmonic == 0);
    Some(FixedLine {
        name: if is_named {
            branch.name.clone()
        } else {
            format!("{} {}", branch.name, pattern.word_in(words))
        },
        stem: branch.stem().to_owned(),
        kind: branch.kind,
        harmonic: if pattern.has_direction() {
            pattern.harmonic
        } else {
            0
        },
        points: points.collect(),
    })
}

/// The pattern of one of the waves of two blades that move against each other, or the pattern itself.
fn of_wave(whirl: Whirl, wave: Option<i32>) -> Whirl {
    match wave.filter(|_| whirl.is_double()) {
        // A pattern of no number of blades has a direction.
        Some(harmonic) => Whirl {
            harmonic,
            blades: 0,
            ..whirl
        },
        None => whirl,
    }
}

/// A pure pattern in the fixed system, at a speed.
#[derive(Debug, Clone, Copy)]
struct Seen {
    /// In the turning axes.
    whirl: Whirl,
    /// Speed \[rad/s\].
    speed: f64,
    /// Frequency, negative if the motion runs backward \[Hz\].
    signed: f64,
    /// The pattern that names it.
    pattern: Whirl,
}

impl Seen {
    fn new(whirl: Whirl, point: &ModePoint, speed: f64) -> Self {
        Self {
            whirl,
            speed,
            pattern: whirl.named(point.frequency, speed / TAU),
            signed: whirl.signed_in_fixed_system(point.frequency, speed / TAU),
        }
    }
}

/// The pure pattern at the speed nearest to another one.
fn nearest(pure: &[Seen], speed: f64) -> Option<&Seen> {
    let off = |one: &&Seen| (one.speed - speed).abs();
    pure.iter().min_by(|a, b| off(a).total_cmp(&off(b)))
}

/// The pattern of a shaft at a point without a pure one, as at rest, where both whirls have one
/// frequency: the direction whose frequency in the fixed system continues `near`.
fn continued(near: &Seen, point: &ModePoint, speed: f64) -> Whirl {
    let whirl = near.whirl;
    let turned = Whirl {
        harmonic: -whirl.harmonic,
        ..whirl
    };
    let off = |whirl: &Whirl| {
        let signed = whirl.signed_in_fixed_system(point.frequency, speed / TAU);
        (signed - near.signed).abs()
    };
    if off(&turned) < off(&whirl) {
        turned
    } else {
        whirl
    }
}

/// The critical speeds of a line.
fn critical(line: &FixedLine, speeds: &[f64], orders: &[u32]) -> Vec<CriticalSpeed> {
    let point = |point: FixedPoint| (point.signed, point.direction.is_some());
    let points: Vec<_> = line.points.iter().map(|p| p.map(point)).collect();
    crossings(&line.name, &points, speeds, orders)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A number without the round-off of units.
    fn rounded(value: f64) -> f64 {
        (1e9 * value).round() / 1e9
    }

    fn whirl(harmonic: i32, blades: usize) -> Whirl {
        Whirl {
            harmonic,
            blades,
            share: 1.0,
        }
    }

    fn point(frequency: f64, growth: f64, whirl: Whirl) -> Option<ModePoint> {
        Some(ModePoint {
            frequency,
            damping_ratio: 0.0,
            growth,
            shares: [0.0, 1.0, 0.0, 0.0],
            lateral: 0.0,
            tower: [0.0; 2],
            whirl: Some(whirl),
            assurance: None,
            shape: None,
        })
    }

    fn table(speeds: &[f64], lines: Vec<(&str, Vec<Option<ModePoint>>)>) -> FrequencyTable {
        let branches = lines.into_iter().map(|(name, points)| ModeBranch {
            name: name.to_owned(),
            kind: ModeKind::Lag,
            harmonic: points
                .iter()
                .flatten()
                .next()
                .and_then(|p| Some(p.whirl?.harmonic)),
            points,
        });
        FrequencyTable {
            name: "made up".to_owned(),
            speeds: speeds.iter().map(|turns| turns * TAU).collect(),
            branches: branches.collect(),
            equilibria: Vec::new(),
            decaying: Vec::new(),
            remarks: Vec::new(),
            style: Default::default(),
            is_single_blade: false,
            blade_files: Vec::new(),
        }
    }

    // A lag mode of 2 Hz at all speeds: the regressive wave is seen at 2 - n Hz, crosses 1P at
    // 1 Hz (2 - n = n), is at rest at 2 Hz and crosses 1P nowhere else; the progressive one at
    // 2 + n Hz meets 3P at 1 Hz; the collective mode meets 1P at 2 Hz.
    #[test]
    fn waves_are_shifted_and_meet_the_multiples() {
        let speeds = [0.0, 1.5, 3.0];
        let line = |h| speeds.map(|_| point(2.0, 0.0, whirl(h, 3))).to_vec();
        let table = table(
            &speeds,
            vec![("c", line(0)), ("p", line(1)), ("r", line(-1))],
        );
        let fixed = FixedTable::new(&table, &[1, 3]).unwrap();
        let seen = |line: usize| -> Vec<f64> {
            let points = fixed.lines[line].points.iter().flatten();
            points.map(|point| rounded(point.signed)).collect()
        };
        assert_eq!(seen(0), [2.0, 2.0, 2.0]);
        assert_eq!(seen(1), [2.0, 3.5, 5.0]);
        assert_eq!(seen(2), [-2.0, -0.5, 1.0]);
        let critical = fixed.critical.iter();
        let found: Vec<_> = critical
            .map(|c| (c.name.as_str(), c.order, c.speed / TAU, c.frequency))
            .collect();
        let expected = [
            ("r", 3, 0.5, 1.5),
            ("c", 3, 2.0 / 3.0, 2.0),
            ("p", 3, 1.0, 3.0),
            ("r", 1, 1.0, 1.0),
            ("c", 1, 2.0, 2.0),
            ("r", 0, 2.0, 0.0),
        ];
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for (name, order, speed, frequency) in expected {
            let is_it = |c: &&(&str, u32, f64, f64)| {
                let near = (c.2 - speed).abs() < 1e-12 && (c.3 - frequency).abs() < 1e-12;
                (c.0, c.1) == (name, order) && near
            };
            assert_eq!(
                found.iter().filter(is_it).count(),
                1,
                "{name} {order} {found:?}"
            );
        }
    }

    // A shaft whose forward whirl is 2 Hz in the fixed system: in the turning axes 2 - n Hz with
    // the rotation, and from 2 Hz on n - 2 Hz against it.
    #[test]
    fn a_whirl_continues_through_its_critical_speed() {
        let speeds = [0.0, 1.0, 3.0, 4.0];
        let seen = [(2.0, 1), (1.0, 1), (1.0, -1), (2.0, -1)];
        let points = seen.map(|(frequency, h)| point(frequency, 0.0, whirl(h, 0)));
        let table = table(&speeds, vec![("forward", points.to_vec())]);
        let fixed = FixedTable::new(&table, &[1, 2]).unwrap();
        assert_eq!(fixed.lines[0].harmonic, 1);
        let points = fixed.lines[0].points.iter().flatten();
        let seen: Vec<_> = points.map(|p| rounded(p.signed)).collect();
        assert_eq!(seen, [2.0; 4]);
        let critical: Vec<_> = fixed
            .critical
            .iter()
            .map(|c| (c.order, rounded(c.speed / TAU)))
            .collect();
        assert_eq!(critical, [(2, 1.0), (1, 2.0)]);
    }

    // As above, with speeds beyond twice the critical one. At rest both whirls have one frequency, and
    // the computed modes are mixtures of them.
    #[test]
    fn whirls_that_are_mixed_at_rest_have_no_other_critical_speeds() {
        let speeds = [0.0, 1.0, 3.0, 5.0, 6.0];
        let mixed = |frequency: f64| {
            point(
                frequency,
                0.0,
                Whirl {
                    share: 0.5,
                    ..whirl(1, 0)
                },
            )
        };
        let turning = |signed: f64| {
            let of = |speed: f64| {
                let seen: f64 = signed - speed;
                let harmonic = if seen < 0.0 { -1 } else { 1 };
                point(seen.abs(), 0.0, whirl(harmonic, 0))
            };
            let at_rest = [mixed(2.0)].into_iter();
            at_rest.chain(speeds[1..].iter().map(|n| of(*n))).collect()
        };
        let mut table = table(&speeds, vec![("a", turning(2.0)), ("b", turning(-2.0))]);
        for branch in &mut table.branches {
            branch.harmonic = None;
        }
        let fixed = FixedTable::new(&table, &[1, 2]).unwrap();
        let found: Vec<_> = fixed
            .critical
            .iter()
            .map(|c| (c.name.as_str(), c.order, rounded(c.speed / TAU)))
            .collect();
        assert_eq!(
            found,
            [
                ("a progressive", 2, 1.0),
                ("b regressive", 2, 1.0),
                ("a progressive", 1, 2.0),
                ("b regressive", 1, 2.0)
            ]
        );
    }

    // Two blades that move against each other at 5 Hz: cos(w t) cos psi = (cos(w t - psi) + cos(w t + psi)) / 2
    // with psi = psi_0 + Omega t of the blade in the fixed system, at 5 + n and at 5 - n Hz. The wave that runs
    // backward stands at 5 revolutions a second, and meets 1P at 2.5; four blades have one frequency.
    #[test]
    fn two_blades_against_each_other_are_two_waves() {
        let speeds = [0.0, 2.0, 6.0];
        let line = |blades| {
            speeds
                .map(|_| point(5.0, 0.0, whirl(blades as i32 / 2, blades)))
                .to_vec()
        };
        let table = |blades| table(&speeds, vec![("flap 1 differential", line(blades))]);
        let fixed = FixedTable::new(&table(2), &[1]).unwrap();
        let seen = fixed.lines.iter().map(|line| {
            let points = line.points.iter().flatten();
            let signed: Vec<_> = points.map(|point| rounded(point.signed)).collect();
            (line.name.as_str(), signed)
        });
        let expected = [
            ("flap 1 differential progressive", vec![5.0, 7.0, 11.0]),
            ("flap 1 differential regressive", vec![-5.0, -3.0, 1.0]),
        ];
        assert_eq!(seen.collect::<Vec<_>>(), expected);
        let found = fixed.critical.iter();
        let found: Vec<_> = found.map(|c| (c.order, rounded(c.speed / TAU))).collect();
        assert_eq!(found, [(1, 2.5), (0, 5.0)]);
        let of_four = FixedTable::new(&table(4), &[1]).unwrap();
        let signed = of_four.lines[0].points.iter().flatten().map(|p| p.signed);
        assert_eq!(signed.collect::<Vec<_>>(), [5.0; 3]);
    }

    // s = -0.3 + 2 pi i 0.4 in the turning axes, seen at 1.4 Hz.
    #[test]
    fn damping_is_relative_to_the_frequency_that_is_seen() {
        let points = vec![point(0.4, -0.3, whirl(1, 3)); 2];
        let table = table(&[1.0, 1.0], vec![("p", points)]);
        let fixed = FixedTable::new(&table, &[]).unwrap();
        let found = fixed.lines[0].points[0].unwrap().damping_ratio;
        assert!((found - 0.3 / 0.3_f64.hypot(TAU * 1.4)).abs() < 1e-15);
        let mut none = table.clone();
        none.branches[0]
            .points
            .iter_mut()
            .flatten()
            .for_each(|p| p.whirl = None);
        assert_eq!(FixedTable::new(&none, &[]), None);
    }
}

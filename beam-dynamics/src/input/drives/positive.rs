//! Whether a drive is above zero in a run.

use super::MOST_CORNERS;
use crate::model::Drive;

/// Number of equal intervals of a run at whose ends a drive is evaluated: a swing below
/// zero that lasts a thousandth of the run is found.
const INTERVALS: u32 = 4000;

/// The first instant of a `run` at which a drive is found to be zero or less, with its
/// value there: at its corners, just before them, and at equal intervals.
pub(super) fn first_below(drive: &Drive, run: [f64; 2]) -> Option<(f64, f64)> {
    let at_corners = corners(drive, run).flat_map(|corner| [corner.next_down(), corner]);
    let mut at_corners = at_corners.filter(|time| (run[0]..=run[1]).contains(time));
    let part = (run[1] - run[0]) / f64::from(INTERVALS);
    let even = (0..INTERVALS).map(|i| run[0] + part * f64::from(i));
    let below = |time: f64| {
        let value = drive.at(time).value;
        (value <= 0.0).then_some((time, value))
    };
    let found = [
        even.chain([run[1]]).find_map(below),
        at_corners.find_map(below),
    ];
    found
        .into_iter()
        .flatten()
        .min_by(|a, b| a.0.total_cmp(&b.0))
}

/// The corners of a drive in a run.
fn corners(drive: &Drive, [from, to]: [f64; 2]) -> impl Iterator<Item = f64> {
    let next = move |time: &f64| {
        let next = drive.next_corner(*time);
        (next > *time && next <= to).then_some(next)
    };
    let before = from.next_down();
    std::iter::successors(next(&before), next).take(MOST_CORNERS)
}

#[cfg(test)]
mod tests {
    use super::first_below;
    use crate::model::{Drive, Harmonic, Ramp, Step};

    const NONE: (f64, f64) = (f64::NAN, f64::NAN);

    fn ramp(from: f64, to: f64) -> Drive {
        Drive::Ramp(Ramp {
            from,
            to,
            start: 0.0,
            end: 1.0,
            smooth: false,
        })
    }

    // 1 - 2 t is zero at 0.5 s, and there is an instant every 0.25 ms.
    #[test]
    fn a_ramp_through_zero_is_seen_where_it_gets_there() {
        let (time, value) = first_below(&ramp(1.0, -1.0), [0.0, 1.0]).unwrap_or(NONE);
        assert!(
            (0.5..0.5003).contains(&time) && value <= 0.0,
            "{time} {value}"
        );
        assert_eq!(first_below(&ramp(1.0, -1.0), [0.0, 0.4]), None);
        assert_eq!(first_below(&ramp(1.0, 0.1), [0.0, 1.0]), None);
        assert!(first_below(&ramp(1.0, 0.0), [0.0, 1.0]).is_some());
    }

    // Below zero only for 1e-7 s: from a step down to the next, and before a step up.
    #[test]
    fn corners_are_looked_at_on_both_sides() {
        let step = |time: f64, from: f64, to: f64| Drive::Step(Step { time, from, to });
        let steps = [step(0.333_111, 1.0, -1.0), step(0.333_111_1, 0.0, 2.0)];
        let both = Drive::Sum(steps.into());
        assert_eq!(first_below(&both, [0.0, 1.0]), Some((0.333_111, -1.0)));
        let peak = Drive::Product([ramp(3.0, -1e-9), step(1.0, 1.0, -1.0)].into());
        let (time, value) = first_below(&peak, [0.0, 2.0]).unwrap_or(NONE);
        assert!(time < 1.0 && value <= 0.0, "{time} {value}");
    }

    // 1 + 1.001 sin(2 pi t) is below zero for 0.014 s about 0.75 s.
    #[test]
    fn a_swing_below_zero_is_seen() {
        let swing = |amplitude: f64| {
            Drive::Harmonic(Harmonic {
                frequency: 1.0,
                amplitude,
                mean: 1.0,
                phase: 0.0,
                start: 0.0,
                cycles: f64::INFINITY,
            })
        };
        let (time, value) = first_below(&swing(1.001), [0.0, 2.0]).unwrap_or(NONE);
        assert!(
            (time - 0.743).abs() < 1e-3 && value <= 0.0,
            "{time} {value}"
        );
        assert_eq!(first_below(&swing(0.999), [0.0, 2.0]), None);
    }
}

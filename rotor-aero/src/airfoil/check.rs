//! Checks of airfoil tables before their evaluation.

use std::f64::consts::PI;

use super::data::{AirfoilData, Curve};
use super::merged::merged;
use super::problem::{AirfoilProblem, AirfoilRemark};

/// Ends nearer to 180 deg than this are moved without a remark: the digits of a file \[rad\].
const ROUNDED_END: f64 = 2e-5;

/// Ends nearer to 180 deg than this are moved with a remark: -3.14 instead of -pi \[rad\].
const NEAR_END: f64 = 5e-3;

/// Ends that differ less than this have no remark: the digits of a file \[-\].
const ROUNDED_VALUE: f64 = 1e-6;

/// Ends that differ more than this are refused \[-\].
const DIFFERENT_VALUE: f64 = 0.05;

/// Steps above this have a remark unless the value is constant \[rad\].
const WIDE_STEP: f64 = PI / 6.0;

/// Steps over the zero angle above this are gaps unless the value is constant: the flow is attached
/// there, and lift rises and falls in between \[rad\].
const GAP: f64 = PI / 7.2;

/// Largest angle, of both signs, at which wide steps have a remark of their own: stall is below it
/// \[rad\].
const STALL: f64 = PI / 9.0;

/// Angles between which rows that are missing among others are looked for \[rad\].
const NEAR_STALL: [f64; 2] = [-PI / 12.0, PI / 9.0];

/// Least step of missing rows \[rad\], and in steps around it \[-\].
const SKIPPED: [f64; 2] = [PI / 32.0, 4.0];

/// Problems and remarks of a table.
#[derive(Debug, Default)]
struct Findings {
    problems: Vec<AirfoilProblem>,
    remarks: Vec<AirfoilRemark>,
}

/// A table whose curves are complete, ascending and closed.
#[derive(Debug)]
pub(super) struct Checked {
    /// The table.
    pub(super) data: AirfoilData,
    /// Peculiarities that are accepted.
    pub(super) remarks: Vec<AirfoilRemark>,
}

/// A coefficient: its name and the values that an airfoil may have.
struct Kind {
    name: &'static str,
    from: f64,
    to: f64,
}

const LIFT: Kind = Kind {
    name: "lift",
    from: -10.0,
    to: 10.0,
};
const DRAG: Kind = Kind {
    name: "drag",
    from: -1.0,
    to: 5.0,
};
const MOMENT: Kind = Kind {
    name: "moment",
    from: -5.0,
    to: 5.0,
};

/// The table made ready for interpolation, or all its problems.
pub(super) fn checked(data: &AirfoilData) -> Result<Checked, Vec<AirfoilProblem>> {
    let mut found = Findings::default();
    let mut clean =
        |kind: &Kind, curves: &[Curve]| coefficient(&data.name, kind, curves, &mut found);
    let checked = AirfoilData {
        lift: clean(&LIFT, &data.lift),
        drag: clean(&DRAG, &data.drag),
        moment: clean(&MOMENT, &data.moment),
        ..data.clone()
    };
    for (curves, coefficient) in [(&data.lift, LIFT.name), (&data.drag, DRAG.name)] {
        if curves.is_empty() {
            let airfoil = data.name.clone();
            found.problems.push(AirfoilProblem::Absent {
                airfoil,
                coefficient,
            });
        }
    }
    if data.moment.is_empty() {
        let airfoil = data.name.clone();
        found.remarks.push(AirfoilRemark::NoMoment { airfoil });
    }
    if found.problems.is_empty() {
        Ok(Checked {
            data: checked,
            remarks: merged(found.remarks),
        })
    } else {
        Err(merged(found.problems))
    }
}

/// The name of a curve in messages.
pub(super) fn label(airfoil: &str, coefficient: &str, curve: &Curve) -> String {
    let mut text = format!("{coefficient} of \"{airfoil}\"");
    if let Some(mach) = curve.mach {
        text += &format!(", Mach {mach}");
    }
    if let Some(reynolds) = curve.reynolds {
        text += &format!(", Re {reynolds}");
    }
    if let Some(flap) = curve.flap {
        text += &format!(", flap {} deg", degrees(flap));
    }
    text
}

/// Degrees with the digits that a file has.
fn degrees(angle: f64) -> f64 {
    (angle.to_degrees() * 1e6).round() / 1e6
}

fn coefficient(airfoil: &str, kind: &Kind, curves: &[Curve], found: &mut Findings) -> Vec<Curve> {
    mixed(airfoil, kind.name, curves, found);
    shared(airfoil, kind.name, curves, found);
    let of_one_mach = match curves {
        [only] => only.mach.is_some(),
        _ => false,
    };
    let check = |curve: &Curve| {
        let name = label(airfoil, kind.name, curve);
        conditions(&name, curve, found);
        if of_one_mach {
            let curve = name.clone();
            found.remarks.push(AirfoilRemark::SingleMach { curve });
        }
        single(&name, kind, curve, found)
    };
    curves.iter().filter_map(check).collect()
}

/// A condition of a curve, if it states it.
type Condition = fn(&Curve) -> Option<f64>;

/// Conditions that only some curves state.
fn mixed(airfoil: &str, coefficient: &str, curves: &[Curve], found: &mut Findings) {
    let variables: [(&'static str, Condition); 3] = [
        ("Mach number", |curve| curve.mach),
        ("Reynolds number", |curve| curve.reynolds),
        ("deflection", |curve| curve.flap),
    ];
    for (variable, value) in variables {
        let given = curves.iter().filter(|curve| value(curve).is_some()).count();
        let absent = curves.len() - given;
        if given > 0 && absent > 0 {
            found.problems.push(AirfoilProblem::Mixed {
                curve: label(airfoil, coefficient, &Curve::default()),
                variable,
                given,
                absent,
            });
        }
    }
}

/// Curves of the same conditions.
fn shared(airfoil: &str, coefficient: &str, curves: &[Curve], found: &mut Findings) {
    let key = |curve: &Curve| [curve.mach, curve.reynolds, curve.flap];
    for (second, curve) in curves.iter().enumerate() {
        let before = &curves[..second];
        if let Some(first) = before.iter().position(|other| key(other) == key(curve)) {
            found.problems.push(AirfoilProblem::Shared {
                curve: label(airfoil, coefficient, curve),
                first: first + 1,
                second: second + 1,
            });
        }
    }
}

/// Conditions out of range.
fn conditions(name: &str, curve: &Curve, found: &mut Findings) {
    let limits = [
        ("Mach number", curve.mach, 0.0, 5.0, "0 to 5"),
        ("Reynolds number", curve.reynolds, 1.0, 1e10, "1 to 1e10"),
        ("deflection in rad", curve.flap, -PI, PI, "-pi to pi"),
    ];
    for (variable, value, from, to, expected) in limits {
        let wrong = value.filter(|value| !(from..=to).contains(value));
        found
            .problems
            .extend(wrong.map(|value| AirfoilProblem::Condition {
                curve: name.to_owned(),
                variable,
                value,
                expected,
            }));
    }
}

/// One curve, cleaned; `None` if it has problems.
fn single(name: &str, kind: &Kind, curve: &Curve, found: &mut Findings) -> Option<Curve> {
    let before = found.problems.len();
    let (angles, values) = (curve.alpha.len(), curve.values.len());
    if angles != values {
        let curve = name.to_owned();
        found.problems.push(AirfoilProblem::Lengths {
            curve,
            angles,
            values,
        });
        return None;
    }
    numbers(name, curve, found);
    if found.problems.len() > before {
        return None;
    }
    let mut clean = ascending(name, curve, found);
    sizes(name, kind, &clean, found);
    if clean.alpha.len() < 2 {
        let (curve, points) = (name.to_owned(), clean.alpha.len());
        found.problems.push(AirfoilProblem::Few { curve, points });
    } else if found.problems.len() == before {
        closed(name, &mut clean, found);
        steps(name, &clean, found);
        if kind.name == LIFT.name {
            found.remarks.extend(skipped(name, &clean));
        }
    }
    (found.problems.len() == before).then_some(clean)
}

/// Numbers that are not finite.
fn numbers(name: &str, curve: &Curve, found: &mut Findings) {
    for (quantity, list) in [("the angle", &curve.alpha), ("the value", &curve.values)] {
        for (i, value) in list
            .iter()
            .enumerate()
            .filter(|(_, value)| !value.is_finite())
        {
            found.problems.push(AirfoilProblem::NotFinite {
                curve: name.to_owned(),
                quantity,
                point: i + 1,
                value: *value,
            });
        }
    }
}

/// The curve without its repeated angle.
fn ascending(name: &str, curve: &Curve, found: &mut Findings) -> Curve {
    let mut clean = Curve {
        alpha: Vec::new(),
        values: Vec::new(),
        ..curve.clone()
    };
    let mut repeated = Vec::new();
    for (i, (angle, value)) in curve.alpha.iter().zip(&curve.values).enumerate() {
        match clean.alpha.last() {
            Some(last) if angle == last => {
                let kept = clean.values.last().copied().unwrap_or(*value);
                repeated.push((*angle, kept, *value));
                continue;
            }
            Some(last) if angle < last => found.problems.push(AirfoilProblem::NotAscending {
                curve: name.to_owned(),
                first_deg: degrees(*last),
                second_deg: degrees(*angle),
                point: i + 1,
            }),
            _ => {}
        }
        clean.alpha.push(*angle);
        clean.values.push(*value);
    }
    match repeated[..] {
        [] => {}
        [(angle, kept, dropped)] => found.remarks.push(AirfoilRemark::Repeated {
            curve: name.to_owned(),
            angle_deg: degrees(angle),
            kept,
            dropped,
        }),
        [first, second, ..] => found.problems.push(AirfoilProblem::Repeated {
            curve: name.to_owned(),
            count: repeated.len(),
            first_deg: degrees(first.0),
            second_deg: degrees(second.0),
        }),
    }
    clean
}

/// Values that no airfoil has, the worst of each curve.
fn sizes(name: &str, kind: &Kind, curve: &Curve, found: &mut Findings) {
    let excess = |value: f64| (kind.from - value).max(value - kind.to);
    let points = curve.alpha.iter().zip(&curve.values);
    let worst = points
        .clone()
        .max_by(|a, b| excess(*a.1).total_cmp(&excess(*b.1)));
    if let Some((angle, value)) = worst.filter(|point| excess(*point.1) > 0.0) {
        found.problems.push(AirfoilProblem::Absurd {
            curve: name.to_owned(),
            value: *value,
            angle_deg: degrees(*angle),
            from: kind.from,
            to: kind.to,
        });
    }
    let least = points.min_by(|a, b| a.1.total_cmp(b.1));
    let negative = least.filter(|point| kind.name == DRAG.name && *point.1 < 0.0);
    found
        .remarks
        .extend(negative.map(|(angle, value)| AirfoilRemark::NegativeDrag {
            curve: name.to_owned(),
            value: *value,
            angle_deg: degrees(*angle),
        }));
}

/// Moves the ends to 180 deg, and makes their values equal.
fn closed(name: &str, curve: &mut Curve, found: &mut Findings) {
    let last = curve.alpha.len() - 1;
    let (from, to) = (curve.alpha[0], curve.alpha[last]);
    let (from_deg, to_deg) = (degrees(from), degrees(to));
    let named = name.to_owned();
    if from > -PI + NEAR_END || to < PI - NEAR_END {
        found.problems.push(AirfoilProblem::Incomplete {
            curve: named,
            from_deg,
            to_deg,
        });
        return;
    }
    if from < -PI - NEAR_END || to > PI + NEAR_END {
        found.problems.push(AirfoilProblem::Beyond {
            curve: named,
            from_deg,
            to_deg,
        });
        return;
    }
    for (i, end) in [(0, -PI), (last, PI)] {
        if (curve.alpha[i] - end).abs() > ROUNDED_END {
            found.remarks.push(AirfoilRemark::Closed {
                curve: name.to_owned(),
                angle_deg: degrees(curve.alpha[i]),
                to_deg: degrees(end),
            });
        }
        curve.alpha[i] = end;
    }
    if curve.alpha[1] <= -PI || curve.alpha[last - 1] >= PI {
        found.problems.push(AirfoilProblem::Beyond {
            curve: named,
            from_deg,
            to_deg,
        });
        return;
    }
    let (low, high) = (curve.values[0], curve.values[last]);
    let difference = (high - low).abs();
    if difference > DIFFERENT_VALUE {
        found.problems.push(AirfoilProblem::EndsDiffer {
            curve: named,
            low,
            high,
        });
    } else if difference > ROUNDED_VALUE {
        found.remarks.push(AirfoilRemark::EndsDiffer {
            curve: named,
            low,
            high,
        });
    }
    let mean = low + (high - low) / 2.0;
    curve.values[0] = mean;
    curve.values[last] = mean;
}

/// Steps between unequal values: gaps at small angles, and the widest.
fn steps(name: &str, curve: &Curve, found: &mut Findings) {
    let pairs = curve.alpha.windows(2).zip(curve.values.windows(2));
    let unequal = pairs.filter(|(_, values)| values[0] != values[1]);
    let steps = unequal.filter_map(|(angles, _)| angles.first_chunk::<2>());
    let width = |step: &[f64; 2]| step[1] - step[0];
    let (mut widest, mut gap) = (None::<&[f64; 2]>, None);
    let (mut wide, mut at_stall) = (0, None);
    for step in steps {
        if widest.is_none_or(|widest| width(step) >= width(widest)) {
            widest = Some(step);
        }
        if step[0] < 0.0 && step[1] > 0.0 && width(step) > GAP {
            gap = Some(step);
        }
        if width(step) > WIDE_STEP {
            wide += 1;
            let is_near = step[0] < STALL && step[1] > -STALL;
            at_stall = at_stall.or(is_near.then_some(step));
        }
    }
    if let Some([from_deg, to_deg]) = gap.map(|step| step.map(degrees)) {
        found.problems.push(AirfoilProblem::Gap {
            curve: name.to_owned(),
            from_deg,
            to_deg,
        });
    } else if let Some(step) = at_stall.or(widest).filter(|_| wide > 0) {
        found.remarks.push(AirfoilRemark::WideStep {
            curve: name.to_owned(),
            from_deg: degrees(step[0]),
            to_deg: degrees(step[1]),
            others: wide - 1,
            at_stall: at_stall.is_some(),
        });
    }
}

/// The widest step at small angles if it is much wider than most others there, as in a polar of which some
/// angles did not converge.
fn skipped(name: &str, curve: &Curve) -> Option<AirfoilRemark> {
    let steps = curve
        .alpha
        .windows(2)
        .filter_map(|step| step.first_chunk::<2>());
    let mut steps: Vec<_> = steps
        .filter(|step| step[0] >= NEAR_STALL[0] && step[1] <= NEAR_STALL[1])
        .collect();
    let width = |step: &[f64; 2]| step[1] - step[0];
    steps.sort_by(|a, b| width(a).total_cmp(&width(b)));
    let (widest, median) = (*steps.last()?, *steps.get(steps.len() / 2)?);
    let is_wide = width(widest) > SKIPPED[0] && width(widest) > SKIPPED[1] * width(median);
    is_wide.then(|| AirfoilRemark::Skipped {
        curve: name.to_owned(),
        from_deg: degrees(widest[0]),
        to_deg: degrees(widest[1]),
        usual_deg: degrees(width(median)),
    })
}

#[cfg(test)]
#[path = "check_tests.rs"]
mod tests;

use std::f64::consts::PI;

use shared_geom::error::Explain;

use super::checked;
use crate::airfoil::{
    Airfoil, AirfoilData, AirfoilProblem, AirfoilRemark, Curve, Flow, Interpolation,
};

fn curve(points: &[(f64, f64)]) -> Curve {
    let (alpha, values) = points.iter().map(|(deg, v)| (deg.to_radians(), *v)).unzip();
    Curve {
        alpha,
        values,
        ..Curve::default()
    }
}

fn plain() -> AirfoilData {
    AirfoilData {
        name: "plain".to_owned(),
        lift: vec![curve(&[
            (-180.0, 0.0),
            (-10.0, -1.0),
            (0.0, 0.0),
            (10.0, 1.0),
            (180.0, 0.0),
        ])],
        drag: vec![curve(&[(-180.0, 0.02), (0.0, 0.01), (180.0, 0.02)])],
        moment: vec![curve(&[(-180.0, 0.0), (180.0, 0.0)])],
        ..AirfoilData::default()
    }
}

fn problems(change: impl Fn(&mut AirfoilData)) -> Vec<AirfoilProblem> {
    let mut data = plain();
    change(&mut data);
    checked(&data).err().unwrap_or_default()
}

fn remarks(change: impl Fn(&mut AirfoilData)) -> Vec<String> {
    let mut data = plain();
    change(&mut data);
    let remarks = checked(&data).unwrap().remarks;
    remarks.iter().map(AirfoilRemark::to_string).collect()
}

/// The wide steps of the plain table are the only remarks.
const WIDE: usize = 2;

/// A polar at each half degree without the angles from 4 to 13 deg, where a solver did not converge; the
/// same with coarse steps of its own is accepted.
#[test]
fn missing_rows_among_others_are_remarked() {
    let polar = |step: f64, leaves: &dyn Fn(f64) -> bool| {
        let count = (30.0 / step) as i32;
        let angles = (-count..=count).map(|k| f64::from(k) * step);
        let ends = [(-180.0, 0.0), (180.0, 0.0)];
        let inner = angles
            .filter(|at| leaves(*at))
            .map(|at| (at, (0.1 * at).sin()));
        let mut points: Vec<_> = ends.into_iter().chain(inner).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        remarks(|data| data.lift[0] = curve(&points))
    };
    let has = |found: &[String]| {
        found
            .iter()
            .any(|it| it.contains("rows seem to be missing"))
    };
    let found = polar(0.5, &|at| !(4.1..12.9).contains(&at));
    assert!(has(&found), "{found:?}");
    assert!(
        found
            .iter()
            .any(|it| it.contains("between 4 and 13 deg, where steps are 0.5 deg"))
    );
    let found = polar(0.5, &|at| !(10.6..16.4).contains(&at));
    assert!(has(&found), "{found:?}");
    for (step, few) in [(0.5, true), (1.0, true), (2.0, true), (5.0, false)] {
        assert!(!has(&polar(step, &|_| true)), "{step}");
        let found = polar(step, &|at| !(0.1..13.9).contains(&at));
        assert_eq!(has(&found), few, "{step} {found:?}");
    }
}

#[test]
fn each_problem_is_named_with_its_numbers() {
    let first = |change: &dyn Fn(&mut AirfoilData)| problems(change)[0].to_string();
    let falling = first(&|data| data.lift[0].alpha[2] = -0.2);
    assert!(
        falling.contains("-11.459156 deg (point 3) follows -10 deg"),
        "{falling}"
    );
    let short = first(&|data| data.lift[0] = curve(&[(-10.0, -1.0), (10.0, 1.0)]));
    assert!(
        short.contains("lift of \"plain\": -10 to 10 deg, expected -180"),
        "{short}"
    );
    let gap = first(&|data| {
        data.lift[0] = curve(&[(-180.0, 0.0), (-60.0, -0.8), (60.0, 0.8), (180.0, 0.0)]);
    });
    assert!(
        gap.contains("lift of \"plain\": no values between -60 and 60 deg"),
        "{gap}"
    );
    // A table from which the angles from -20 to 12.5 degrees were deleted.
    let gap = first(&|data| {
        data.lift[0] = curve(&[
            (-180.0, 0.0),
            (-60.0, -0.8),
            (-20.0, -1.0),
            (12.5, 1.2),
            (20.0, 1.0),
            (180.0, 0.0),
        ]);
    });
    assert!(gap.contains("no values between -20 and 12.5 deg"), "{gap}");
    let ends = first(&|data| data.moment[0].values[0] = 0.4);
    assert!(ends.contains("0.4 at -180 deg and 0 at 180 deg"), "{ends}");
    let number = first(&|data| data.drag[0].values[1] = f64::NAN);
    assert!(number.contains("the value of point 2 is NaN"), "{number}");
    let large = first(&|data| data.lift[0].values[3] = 100.0);
    assert!(
        large.contains("100 at 10 deg, expected -10 to 10"),
        "{large}"
    );
    let degrees = first(&|data| {
        data.lift[0]
            .alpha
            .iter_mut()
            .for_each(|a| *a = a.to_degrees())
    });
    assert!(degrees.contains("exceed -180 to 180 deg"), "{degrees}");
    let count = first(&|data| data.lift[0].values.truncate(2));
    assert!(count.contains("5 angles and 2 values"), "{count}");
    assert!(first(&|data| data.drag.clear()).contains("no drag curve"));
    assert!(first(&|data| data.drag[0].mach = Some(-0.1)).contains("Mach number -0.1"));
    assert!(first(&|data| data.drag[0].reynolds = Some(0.2)).contains("Reynolds number 0.2"));
    assert!(first(&|data| data.drag[0].flap = Some(20.0)).contains("deflection in rad 20"));
}

/// The widest step is named with the number of the others; one at stall before it, with a remedy.
#[test]
fn wide_steps_are_counted_and_named_at_stall() {
    let of = |points: &[(f64, f64)]| {
        let texts = remarks(|data| data.lift[0] = curve(points));
        let is_lift = |text: &&String| text.starts_with("lift");
        texts.iter().find(is_lift).cloned().unwrap_or_default()
    };
    let far = of(&[
        (-180.0, 0.0),
        (-90.0, -0.1),
        (-25.0, -0.8),
        (0.0, 0.0),
        (25.0, 0.8),
        (50.0, 0.9),
        (180.0, 0.0),
    ]);
    let expected =
        "lift of \"plain\": no values between 50 and 180 deg, and 2 more steps above 30 deg";
    assert_eq!(far, expected);
    let stall = of(&[
        (-180.0, 0.0),
        (-20.0, -1.0),
        (0.0, 0.0),
        (16.0, 1.4),
        (90.0, 0.1),
        (180.0, 0.0),
    ]);
    assert!(
        stall.contains("no values between 16 and 90 deg, and 2 more"),
        "{stall}"
    );
    assert!(
        stall.contains("at most 25 deg from -20 to 20 deg"),
        "{stall}"
    );
}

#[test]
fn all_problems_are_reported_with_remedies() {
    let found = problems(|data| {
        data.lift[0].values[3] = 100.0;
        data.drag[0].values[1] = f64::INFINITY;
        data.moment[0] = curve(&[(0.0, 0.0)]);
    });
    assert_eq!(found.len(), 3, "{found:?}");
    assert!(found.iter().all(|problem| problem.help().is_some()));
    assert!(matches!(found[2], AirfoilProblem::Few { points: 1, .. }));
    assert_eq!(problems(|data| *data = AirfoilData::default()).len(), 2);
}

/// Lift, drag and moment of the rows of a polar end at the same angles: this is one fault.
#[test]
fn a_fault_of_all_columns_is_reported_once() {
    let found = problems(|data| {
        for list in [&mut data.lift, &mut data.drag, &mut data.moment] {
            list[0] = curve(&[(-20.0, 0.1), (0.0, 0.2), (20.0, 0.3)]);
            list[0].mach = Some(0.3);
        }
    });
    let shown: Vec<_> = found.iter().map(AirfoilProblem::to_string).collect();
    assert_eq!(
        shown,
        ["lift, drag, moment of \"plain\", Mach 0.3: -20 to 20 deg, expected -180 to 180 deg"]
    );
    let found = problems(|data| {
        data.lift.clear();
        data.drag[0].alpha[0] = -1.0;
        data.moment[0].alpha[0] = -1.0;
    });
    let shown: Vec<_> = found.iter().map(AirfoilProblem::to_string).collect();
    assert_eq!(
        shown,
        [
            "drag, moment of \"plain\": -57.29578 to 180 deg, expected -180 to 180 deg",
            "airfoil \"plain\" has no lift curve",
        ]
    );
}

#[test]
fn curves_must_state_the_same_conditions_and_differ() {
    let twice = |first: Option<f64>, second: Option<f64>| {
        problems(|data| {
            data.lift.push(data.lift[0].clone());
            (data.lift[0].mach, data.lift[1].mach) = (first, second);
        })
    };
    assert!(matches!(
        twice(None, None)[..],
        [AirfoilProblem::Shared {
            first: 1,
            second: 2,
            ..
        }]
    ));
    assert!(matches!(
        twice(Some(0.3), Some(0.3))[..],
        [AirfoilProblem::Shared { .. }]
    ));
    assert!(matches!(
        twice(Some(0.3), None)[..],
        [AirfoilProblem::Mixed {
            variable: "Mach number",
            given: 1,
            absent: 1,
            ..
        }]
    ));
    assert!(twice(Some(0.3), Some(0.4)).is_empty());
}

#[test]
fn peculiarities_are_remarks() {
    assert_eq!(remarks(|_| {}).len(), WIDE);
    let moved = remarks(|data| data.lift[0].alpha[0] = -PI + 1.6e-3);
    assert!(
        moved[0].contains("-179.908327 deg is moved to -180 deg"),
        "{moved:?}"
    );
    assert_eq!(
        remarks(|data| data.lift[0].alpha[0] = -PI + 2.65e-6).len(),
        WIDE
    );
    let ends = remarks(|data| data.drag[0].values[0] = 0.03);
    assert!(
        ends.iter().any(|text| text.contains("the mean is used")),
        "{ends:?}"
    );
    let single = remarks(|data| data.lift[0].mach = Some(0.3));
    assert!(
        single[0].contains("Mach 0.3: the only Mach number"),
        "{single:?}"
    );
    let negative = remarks(|data| data.drag[0].values[1] = -0.001);
    assert!(
        negative[1].contains("the drag coefficient is -0.001 at 0 deg"),
        "{negative:?}"
    );
    let none = remarks(|data| data.moment.clear());
    assert!(
        none.iter().any(|text| text.contains("the moment is zero")),
        "{none:?}"
    );
}

#[test]
fn ends_are_closed_and_equal() {
    let mut data = plain();
    data.lift[0].alpha[0] = -PI + 1.6e-3;
    data.lift[0].values[0] = 0.02;
    let clean = checked(&data).unwrap().data;
    assert_eq!((clean.lift[0].alpha[0], clean.lift[0].alpha[4]), (-PI, PI));
    assert_eq!(
        (clean.lift[0].values[0], clean.lift[0].values[4]),
        (0.01, 0.01)
    );
    // The move must not pass the next angle.
    data.lift[0].alpha[0] = -3.143;
    data.lift[0].alpha[1] = -3.1425;
    assert!(matches!(
        checked(&data).unwrap_err()[..],
        [AirfoilProblem::Beyond { .. }]
    ));
}

/// The table of the NREL 5 MW turbine with this name.
fn nrel(name: &str) -> AirfoilData {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference/aero/nrel5mw/");
    let text = std::fs::read_to_string(format!("{folder}polar_{name}.csv")).unwrap();
    let lines = text.lines().filter(|line| !line.starts_with(['#', 'a']));
    let rows: Vec<Vec<f64>> = lines
        .map(|line| line.split(',').map(|word| word.parse().unwrap()).collect())
        .collect();
    let column = |i: usize| {
        let points: Vec<(f64, f64)> = rows.iter().map(|row| (row[0], row[i])).collect();
        vec![curve(&points)]
    };
    AirfoilData {
        name: name.to_owned(),
        thickness: None,
        lift: column(1),
        drag: column(2),
        moment: column(3),
    }
}

/// All published tables are accepted; DU25 repeats -13 deg, of which the first row is kept.
#[test]
fn published_tables_are_accepted_and_one_repeats_an_angle() {
    let names = "Cylinder1 Cylinder2 DU21_A17 DU25_A17 DU30_A17 DU35_A17 DU40_A17 NACA64_A17";
    for name in names.split(' ') {
        let data = nrel(name);
        let airfoil = Airfoil::new(&data, Interpolation::Monotone).unwrap();
        let expected = if name == "DU25_A17" { 3 } else { 0 };
        assert_eq!(airfoil.remarks().len(), expected, "{:?}", airfoil.remarks());
        for (alpha, value) in data.lift[0].alpha.iter().zip(&data.lift[0].values) {
            let (alpha, mach, reynolds, flap) = (*alpha, 0.1, 1e6, 0.0);
            let lift = airfoil
                .at(&Flow {
                    alpha,
                    mach,
                    reynolds,
                    flap,
                })
                .lift;
            let is_repeated = name == "DU25_A17" && (alpha.to_degrees() + 13.0).abs() < 1e-9;
            assert!(
                (lift - value).abs() < 1e-12 || is_repeated,
                "{name} {alpha}"
            );
        }
    }
    let airfoil = Airfoil::new(&nrel("DU25_A17"), Interpolation::Monotone).unwrap();
    let remark = airfoil.remarks()[0].to_string();
    assert!(remark.contains("-13 deg is repeated"), "{remark}");
}

/// Random damage to a table: no panic, and a table that is accepted gives numbers.
#[test]
fn damaged_tables_do_not_panic() {
    let mut state = 5_u64;
    let mut random = |n: usize| {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (state >> 33) as usize % n
    };
    let odd = [f64::NAN, f64::INFINITY, 0.0, -1e300, 1e-300, PI, -PI, 0.5];
    for _ in 0..2000 {
        let mut data = nrel("Cylinder1");
        let lists = [random(3), random(2)];
        let curves = [&mut data.lift, &mut data.drag, &mut data.moment];
        let Some([curve]) = curves.into_iter().nth(lists[0]).map(Vec::as_mut_slice) else {
            continue;
        };
        let list = if lists[1] == 0 {
            &mut curve.alpha
        } else {
            &mut curve.values
        };
        match random(4) {
            0 => list.truncate(random(3)),
            1 => list.push(odd[random(8)]),
            _ => list[random(3)] = odd[random(8)],
        }
        curve.mach = [None, Some(odd[random(8)])][random(2)];
        if let Ok(airfoil) = Airfoil::new(&data, Interpolation::Monotone) {
            let flow = Flow {
                alpha: 0.3_f64,
                mach: 0.2,
                reynolds: 1e6,
                flap: 0.0,
            };
            assert!(airfoil.at(&flow).lift.is_finite());
        }
    }
}

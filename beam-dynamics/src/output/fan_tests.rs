//! Tests of the fan plot and the Campbell diagram.

use super::*;
use crate::output::samples;
use crate::result::Whirl;

#[test]
fn one_speed_has_no_plot() {
    let mut table = samples::small();
    assert!(FanPlot::new(&table, &Measured::default()).is_some());
    table.speeds.truncate(1);
    assert_eq!(FanPlot::new(&table, &Measured::default()), None);
    table.branches.clear();
    assert_eq!(FanPlot::new(&table, &Measured::default()), None);
}

#[test]
fn the_plot_names_axes_modes_and_multiples() {
    let plot = FanPlot::new(&samples::swept_tip(9), &samples::epps_chandra()).unwrap();
    let text = samples::texts(&plot);
    for expected in [
        "swept tip, 15 deg",
        "rotor speed [rpm]",
        "frequency in the turning axes [Hz]",
        "measured",
        "flap 1",
        "axial 1",
        "coupled 1",
        "1P",
        "10P",
    ] {
        assert!(text.contains(&format!("\n{expected}\n")), "{expected}");
    }
}

// If a measured point lies beyond the last speed, the names are at the ends of the lines within
// the frame; a line from there to the column beyond the frame would look like more of the
// curve.
#[test]
fn no_line_is_drawn_beyond_the_last_speed() {
    let table = samples::swept_tip(3);
    let mut measured = Measured::default();
    let lines = |measured: &Measured| {
        let plot = FanPlot::new(&table, measured).unwrap();
        let drawing = plot.drawing();
        assert!(drawing.texts().any(|text| text == "flap 1"));
        let color = plot.curves[0].color;
        drawing.lines().filter(|line| line.1 == color).count()
    };
    let with_leaders = lines(&measured);
    measured.points.push(crate::result::MeasuredPoint {
        speed: 2.0 * table.speeds[2],
        frequency: 10.0,
        order: None,
    });
    assert!(lines(&measured) < with_leaders);
}

#[test]
fn damping_is_drawn_below_where_there_is_any() {
    let draw = |table: &FrequencyTable| {
        let plot = FanPlot::new(table, &Measured::default()).unwrap();
        samples::texts(&plot)
    };
    let title = "\ndamping ratio [%]\n";
    let damped = draw(&samples::crowded());
    assert!(damped.contains(title));
    assert_eq!(damped.matches("\nrotor speed [rpm]\n").count(), 1);
    assert!(!draw(&samples::swept_tip(3)).contains(title));
}

#[test]
fn a_short_piece_of_a_line_has_no_name() {
    let mut table = samples::swept_tip(9);
    let named = |table: &FrequencyTable| {
        let plot = FanPlot::new(table, &Measured::default()).unwrap();
        let text = samples::texts(&plot);
        text.contains("\naxial 1\n")
    };
    // Five points of nine, then three.
    assert!(named(&table));
    table.branches[9].points[3..].fill(None);
    assert!(!named(&table));
}

// Six modes of each of four kinds: a color for each kind, another pattern for its next mode, and
// another shade for the fifth.
#[test]
fn kinds_have_colors_and_their_modes_patterns() {
    let plot = FanPlot::new(&samples::crowded(), &Measured::default()).unwrap();
    assert_eq!(plot.curves.len(), 24);
    let flap: Vec<_> = plot.curves.iter().step_by(4).collect();
    let patterns: Vec<_> = flap.iter().map(|curve| curve.pattern).collect();
    assert_eq!(patterns, [0, 1, 2, 3, 0, 1]);
    assert!(flap[..4].iter().all(|curve| curve.color == flap[0].color));
    assert_ne!(flap[4].color, flap[0].color);
    let looks: Vec<_> = plot.curves.iter().map(|c| (c.color, c.pattern)).collect();
    for (i, look) in looks.iter().enumerate() {
        assert!(!looks[i + 1..].contains(look), "{i}");
    }
}

// A mode of another kind with the same frequencies covers the first one, which is broader; a
// collective and a differential mode of one frequency are one line of the Campbell diagram.
#[test]
fn lines_that_coincide_are_seen() {
    let mut table = samples::small();
    let mut other = table.branches[0].clone();
    (other.kind, other.name) = (ModeKind::Coupled, "coupled 1".to_owned());
    table.branches.push(other);
    let plot = FanPlot::new(&table, &Measured::default()).unwrap();
    let width = |color| {
        let drawing = plot.drawing();
        let lines = drawing.lines().filter(|line| line.1 == color);
        let widths = lines.map(|line| line.2);
        widths.fold(0.0, f64::max)
    };
    let covering = plot.curves.last().unwrap();
    assert!(width(plot.curves[0].color) > width(covering.color));

    let mut table = samples::waves();
    let mut other = table.branches[0].clone();
    (other.harmonic, other.name) = (Some(0), "lag 1 collective".to_owned());
    for whirl in other
        .points
        .iter_mut()
        .flatten()
        .filter_map(|point| point.whirl.as_mut())
    {
        whirl.harmonic = 0;
    }
    table.branches.push(other.clone());
    other.name = "lag 1 differential".to_owned();
    table.branches.push(other);
    let fixed = FixedTable::new(&table, &table.harmonics()).unwrap();
    let names: Vec<_> = FanPlot::campbell(&table, &fixed).curves;
    let names: Vec<_> = names.iter().map(|curve| curve.name.as_str()).collect();
    let expected = [
        "lag 1 progressive",
        "lag 1 regressive",
        "lag 1 collective, differential",
    ];
    assert_eq!(names, expected);
}

// Of two waves of 2 Hz one line is left in the turning axes, and two in the fixed system.
#[test]
fn waves_coincide_in_the_turning_axes_and_not_in_the_fixed_system() {
    let mut table = samples::waves();
    let fan = FanPlot::new(&table, &Measured::default()).unwrap();
    assert_eq!(fan.curves.len(), 1);
    let text = samples::texts(&fan);
    assert!(text.contains("\nlag 1 progressive, regressive\n"), "{text}");
    let fixed = FixedTable::new(&table, &table.harmonics()).unwrap();
    let plot = FanPlot::campbell(&table, &fixed);
    assert_eq!(plot.curves.len(), 2);
    assert_eq!(plot.curves[1].zeros, [120.0]);
    let text = samples::texts(&plot);
    for expected in [
        "frequency in the fixed system [Hz]",
        "lag 1 progressive",
        "lag 1 regressive",
        "progressive, + 1P",
        "regressive, - 1P",
        "critical speed",
        "1P",
        "3P",
    ] {
        assert!(text.contains(&format!("\n{expected}\n")), "{expected}");
    }
    assert!(!text.contains("\n2P\n"));
    // Both with a third one that differs in frequency: three lines.
    let mut other = table.branches[0].clone();
    other.harmonic = Some(0);
    for point in other.points.iter_mut().flatten() {
        point.frequency = 3.0;
    }
    table.branches.push(other);
    let fan = FanPlot::new(&table, &Measured::default()).unwrap();
    assert_eq!(fan.curves.len(), 2);
}

#[test]
fn all_waves_of_a_rotor_have_one_name_and_units_are_chosen() {
    let mut table = samples::waves();
    let mut other = table.branches[0].clone();
    other.harmonic = Some(0);
    other.name = "lag 1 collective".to_owned();
    table.branches.push(other);
    table.style.unit = FrequencyUnit::PerRevolution;
    let plot = FanPlot::new(&table, &Measured::default()).unwrap();
    assert_eq!(plot.curves[0].name, "lag 1 (3 blades)");
    // 2 Hz at 60 and 180 rpm; 2/rev is beyond 1.6 times the 2/3 of the last speed, but below 1.6.
    let limit = PER_REV_LIMIT * 1.0;
    assert!(2.0 > limit);
    let found = plot.curves[0].frequencies.clone();
    assert_eq!(found[..2], [None, None]);
    assert!((found[2].unwrap() - 2.0 / 3.0).abs() < 1e-12);
    assert!(samples::texts(&plot).contains("\nfrequency in the turning axes [1/rev]\n"));
}

#[test]
fn a_mode_that_is_another_one_at_the_end_is_named_so() {
    let mut table = samples::small();
    if let Some(point) = &mut table.branches[0].points[1] {
        point.shares = [0.1, 0.0, 0.9, 0.0];
    }
    let plot = FanPlot::new(&table, &Measured::default()).unwrap();
    assert_eq!(plot.curves[0].name, "flap 1, now torsion");
    let kinds = [ModeKind::Flap, ModeKind::Torsion].map(Some);
    assert_eq!(plot.curves[0].kinds, kinds);
}

#[test]
fn of_many_critical_speeds_the_ones_of_the_blades_are_marked() {
    let mut table = samples::waves();
    let critical = |count: u32| -> Vec<CriticalSpeed> {
        let order = |k: u32| CriticalSpeed {
            name: "flap 1".to_owned(),
            order: k % 10,
            speed: f64::from(k),
            frequency: 1.0,
        };
        (0..count).map(order).collect()
    };
    let orders = |table: &FrequencyTable, count| {
        let all = critical(count);
        let marked = Marked::new(table, &all);
        let orders = marked.speeds.into_iter().map(|one| one.order);
        (orders.collect::<Vec<_>>(), marked.text)
    };
    assert_eq!(table.blades(), 3);
    let (all, text) = orders(&table, 30);
    assert_eq!((all.len(), text.as_str()), (30, "critical speed"));
    let text = "critical speed at 3P or 6P, and where a whirl reverses".to_owned();
    assert_eq!(orders(&table, 40), ([0, 3, 6].repeat(4), text));
    table.style.harmonics = vec![1, 2];
    let (all, text) = orders(&table, 40);
    assert_eq!((all.len(), text.as_str()), (40, "critical speed"));
}

// 9P at 180 rpm is 27 Hz: a line at 130 Hz is less than five times as high, one at 140 Hz more, and
// both are beyond twice 27 Hz.
#[test]
fn lines_far_above_the_multiples_do_not_press_the_critical_speeds_together() {
    let drawn = |hertz: f64| {
        let mut table = samples::waves();
        let mut other = table.branches[0].clone();
        other.name = "lag 2 collective".to_owned();
        for point in other.points.iter_mut().flatten() {
            point.frequency = hertz;
            point.whirl = point.whirl.map(|whirl| Whirl {
                harmonic: 0,
                ..whirl
            });
        }
        other.harmonic = Some(0);
        table.branches.push(other);
        let fixed = FixedTable::new(&table, &table.harmonics()).unwrap();
        let plot = FanPlot::campbell(&table, &fixed);
        (plot.curves.len(), samples::texts(&plot))
    };
    assert_eq!(drawn(130.0).0, 3);
    let (curves, text) = drawn(140.0);
    assert_eq!(curves, 2);
    assert!(
        text.contains("\n1 line from 140 Hz on not drawn\n"),
        "{text}"
    );
}

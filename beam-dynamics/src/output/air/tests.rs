//! Tables, texts and maps of strips whose quantities are made up.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use nalgebra::Vector3;
use rotor_aero::strip::StripReport;
use shared_geom::figure::Figure;

use super::disk::{DiskPlot, Map};
use super::equal::are_equal;
use super::{air_csv, rotor_text, span_plot};
use crate::elements::{AirState, Definition, RotorAir, RotorMotion, RotorQuantity, StripLocation};
use crate::output::samples::texts;

const RADIUS: f64 = 2.0;
const SPEED: f64 = 50.0;

/// Strip `number` of 4 of a blade at an azimuth, with 10 N up and 2 N against the rotation.
fn strip(blade: &str, number: usize, azimuth: f64) -> AirState {
    let radius = 0.4 * number as f64;
    let (sin, cos) = azimuth.sin_cos();
    let position = radius * Vector3::new(cos, sin, 0.0);
    let force = Vector3::new(2.0 * sin, -2.0 * cos, 10.0);
    AirState {
        location: Arc::new(StripLocation {
            blade: blade.to_owned(),
            number,
            span: radius,
            ..StripLocation::default()
        }),
        radius,
        azimuth,
        position,
        flow: StripReport {
            alpha: (2.0 + radius * azimuth.cos()).to_radians(),
            along_shaft: 10.0,
            ..StripReport::default()
        },
        attached: 1.0,
        tangential: -2.0,
        force,
        moment: position.cross(&force),
        rotor: Some(RotorMotion {
            axis: Vector3::z(),
            turning: SPEED,
            velocity: Vector3::new(3.0, 0.0, 4.0),
            tip_radius: RADIUS,
            density: 1.2,
        }),
    }
}

fn strips() -> Vec<AirState> {
    let blades = [("b 1", 0.3), ("b 2", 0.3 + PI)];
    let blades = blades.into_iter();
    let all = blades.flat_map(|(blade, azimuth)| (1..=4).map(move |n| strip(blade, n, azimuth)));
    all.collect()
}

/// Eight forces of 10 N, and moments of 2 N at 0.4 m to 1.6 m. The coefficients are the ones of
/// `rotor_aero::rotor` written out: C_T = T / (rho A (omega R)^2) of helicopters, T / (rho n^2 D^4)
/// of propellers, 2 T / (rho A V^2) of turbines in a wind of -4 m/s.
#[test]
fn sums_and_coefficients() {
    let rotor = RotorAir::of(&strips()).unwrap();
    assert!((rotor.thrust - 80.0).abs() < 1e-12);
    assert!((rotor.torque + 16.0).abs() < 1e-12);
    assert!((rotor.power() + 16.0 * SPEED).abs() < 1e-10);
    assert_eq!((rotor.climb, rotor.edgewise), (4.0, 3.0));
    let (area, tip) = (PI * RADIUS * RADIUS, SPEED * RADIUS);
    let (n, d) = (SPEED / TAU, 2.0 * RADIUS);
    let [rho, t, q, p] = [1.2, 80.0, 16.0, 16.0 * SPEED];
    let lifting = [t / (rho * area * tip * tip), p / (rho * area * tip.powi(3))];
    let propeller = [
        t / (rho * n * n * d.powi(4)),
        q / (rho * n * n * d.powi(5)),
        p / (rho * n.powi(3) * d.powi(5)),
    ];
    let pressure = 0.5 * rho * area * 16.0;
    for (definition, expected) in [
        (Definition::Rotor, [lifting[0], lifting[1], lifting[1]]),
        (Definition::Propeller, propeller),
        // The speed of the wind is negative: the power of both is.
        (
            Definition::Wind,
            [t / pressure, -q / (pressure * RADIUS), p / (pressure * 4.0)],
        ),
    ] {
        for (found, expected) in rotor.coefficients(definition).iter().zip(expected) {
            assert!((found / expected - 1.0).abs() < 1e-12, "{definition:?}");
        }
    }
    for (quantity, definition, expected) in [
        (
            RotorQuantity::Efficiency,
            Definition::Propeller,
            t * 4.0 / p,
        ),
        (
            RotorQuantity::AdvanceRatio,
            Definition::Propeller,
            4.0 / (n * d),
        ),
        (RotorQuantity::AdvanceRatio, Definition::Rotor, 3.0 / tip),
        (RotorQuantity::TipSpeedRatio, Definition::Wind, -tip / 4.0),
        (RotorQuantity::Power, Definition::Rotor, -p),
    ] {
        let found = rotor.value(quantity, definition);
        assert!((found / expected - 1.0).abs() < 1e-12, "{quantity:?}");
    }
    assert_eq!(RotorAir::of(&[]), None);
}

#[test]
fn tables_have_every_strip_and_sum_to_the_report() {
    let states = strips();
    let groups = [(vec!["0".to_owned()], &states[..])];
    let text = air_csv("time [s]", groups.into_iter());
    let lines: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(lines.len(), 9);
    assert!(lines.iter().all(|line| line.len() == lines[0].len()));
    let column = lines[0]
        .iter()
        .position(|name| *name == "force_z [N]")
        .unwrap();
    let sum: f64 = lines[1..]
        .iter()
        .map(|line| line[column].parse::<f64>().unwrap())
        .sum();
    assert!((sum - 80.0).abs() < 1e-9);
    let moment = lines[0]
        .iter()
        .position(|name| *name == "moment_z [N m]")
        .unwrap();
    let sum: f64 = lines[1..]
        .iter()
        .map(|line| line[moment].parse::<f64>().unwrap())
        .sum();
    assert!((sum + 16.0).abs() < 1e-8);
    assert_eq!(&lines[8][..4], ["0", "rotor", "b 2", "4"]);
    let shown = rotor_text(&states);
    assert!(
        shown.contains("thrust [N]") && shown.contains("80"),
        "{shown}"
    );
    assert!(shown.contains("propeller"), "{shown}");
}

#[test]
fn figures_over_the_span_have_a_curve_for_each_blade() {
    let plot = span_plot("made up", &strips()).unwrap();
    assert_eq!(plot.names, ["b 1", "b 2"]);
    assert_eq!(plot.panels[2].curves[1].len(), 4);
    assert!(texts(&plot).contains("\nradius [m]\n"));
    assert!(span_plot("made up", &[]).is_none());
}

/// A revolution of a field that is linear in x = r cos(azimuth): all cells are drawn.
#[test]
fn maps_of_the_disk() {
    let rows: Vec<Vec<AirState>> = (0..=72)
        .map(|k| {
            (1..=4)
                .map(|n| strip("b 1", n, (f64::from(k) / 72.0 * TAU) % TAU))
                .collect()
        })
        .collect();
    let rows: Vec<Vec<&AirState>> = rows.iter().map(|row| row.iter().collect()).collect();
    let half = rows[..37].to_vec();
    let blades = [("b 1", rows), ("b 2", half)];
    let plot = DiskPlot::new("made up".to_owned(), &blades).unwrap();
    let Map { title, blades, .. } = &plot.maps[0];
    assert_eq!(title, "angle of attack [deg]");
    assert_eq!((blades[0].len(), blades[1].len()), (73, 37));
    for [azimuth, radius, value] in blades.iter().flatten().flatten() {
        assert!((value - 2.0 - radius * azimuth.cos()).abs() < 1e-12);
    }
    let shown = texts(&plot);
    for text in [
        "\n0\n",
        "\n270\n",
        "normal load [N/m]",
        "made up",
        "\nb 1\n",
        "\nb 2\n",
    ] {
        assert!(shown.contains(text), "{shown}");
    }
    let drawing = plot.drawing();
    assert!(drawing.lines().count() > 12);
    assert_eq!(DiskPlot::new(String::new(), &[]), None);
    // Half a revolution is no equal map of a whole one.
    assert!(!are_equal(&plot.maps));
}

/// Two blades of a field that does not turn have one map; a larger load of one of them makes two. Two
/// rotors have the colors of both.
#[test]
fn equal_blades_have_one_map() {
    let rows = |blade: &str, start: f64, more: f64| -> Vec<Vec<AirState>> {
        let row = |k: i32| {
            let azimuth = (start + f64::from(k) / 90.0 * TAU) % TAU;
            let states = (1..=4).map(|n| {
                let mut state = strip(blade, n, azimuth);
                state.flow.along_shaft += more;
                state
            });
            states.collect()
        };
        (0..=90).map(row).collect()
    };
    let plot = |turned: f64, more: f64| {
        let all = [rows("b 1", 0.3, 0.0), rows("b 2", 0.3 + turned, more)];
        let blades: Vec<(&str, Vec<Vec<&AirState>>)> = ["b 1", "b 2"]
            .into_iter()
            .zip(&all)
            .map(|(name, rows)| (name, rows.iter().map(|row| row.iter().collect()).collect()))
            .collect();
        DiskPlot::new("made up".to_owned(), &blades).unwrap()
    };
    // An azimuth between two rows too.
    for turned in [PI, 2.0] {
        let equal = plot(turned, 0.0);
        assert!(are_equal(&equal.maps));
        let equal = equal.of_equal_blades();
        assert_eq!(equal.names, ["b 1 and an equal blade"]);
        assert!(equal.maps.iter().all(|map| map.blades.len() == 1));
        assert!(texts(&equal).contains("\nb 1 and an equal blade\n"));
    }
    let mut plots = [plot(PI, 0.0), plot(PI, 5.0)];
    assert!(!are_equal(&plots[1].maps));
    let own = plots.each_ref().map(|plot| plot.maps[1].range);
    assert!(own[0][1] < own[1][1], "{own:?}");
    DiskPlot::share_colors(&mut plots);
    assert!(
        plots
            .iter()
            .all(|plot| plot.maps[1].range == [own[0][0], own[1][1]])
    );
}

//! Tests of the whole wind: its sum, and its gradient against central differences.

use super::super::event::EventShape;
use super::super::grid::tests::{Lcg, random, small};
use super::super::gust::GustShape;
use super::super::profile::{MeanWind, Shear};
use super::super::table::WindTable;
use super::super::tower::{TowerPotential, TowerShadow};
use super::*;

fn mean(lcg: &mut Lcg) -> MeanWind {
    let kind = (lcg.next() * 3.0) as usize;
    let shear = [
        Shear::Uniform,
        Shear::Power {
            exponent: lcg.between(-0.1, 0.4),
        },
        Shear::Log {
            roughness: lcg.between(0.001, 0.1),
        },
    ][kind];
    MeanWind {
        speed: lcg.between(2.0, 25.0),
        reference_height: 90.0,
        shear,
        direction: lcg.between(-3.0, 3.0),
        veer: lcg.between(-0.002, 0.002),
        upflow: lcg.between(-0.3, 0.3),
        horizontal_shear: lcg.between(-0.3, 0.3),
        vertical_shear: lcg.between(-0.3, 0.3),
        reference_length: 120.0,
        vertical: lcg.between(-1.0, 1.0),
        gust: lcg.between(-1.0, 1.0),
    }
}

fn event(lcg: &mut Lcg) -> Event {
    let amplitude = lcg.between(-6.0, 6.0);
    let [diameter, hub_height] = [120.0, 90.0];
    let shapes = [
        EventShape::OperatingGust { amplitude },
        EventShape::DirectionChange {
            angle: 0.1 * amplitude,
        },
        EventShape::CoherentGust {
            rise: 15.0,
            angle: 0.1 * amplitude,
        },
        EventShape::VerticalShear {
            amplitude,
            diameter,
            hub_height,
        },
        EventShape::HorizontalShear {
            amplitude,
            diameter,
        },
    ];
    Event {
        start: lcg.between(-5.0, 3.0),
        shape: shapes[(lcg.next() * 5.0) as usize],
    }
}

fn gust(lcg: &mut Lcg) -> TravelingGust {
    let length = lcg.between(30.0, 200.0);
    let shapes = [
        GustShape::OneMinusCosine { length },
        GustShape::SharpEdge { ramp: length },
        GustShape::Harmonic { length },
    ];
    let angle = lcg.between(-1.0, 1.0);
    TravelingGust {
        shape: shapes[(lcg.next() * 3.0) as usize],
        velocity: [0; 3].map(|_| lcg.between(-5.0, 5.0)),
        direction: [angle.cos(), 0.6 * angle.sin(), 0.8 * angle.sin()],
        convection: lcg.between(5.0, 20.0),
        front: lcg.between(-100.0, 200.0),
    }
}

fn tower(lcg: &mut Lcg) -> Tower {
    let radii = vec![[0.0, 4.0], [50.0, 3.0], [87.0, 2.0]];
    let potentials = [
        TowerPotential::None,
        TowerPotential::Cylinder,
        TowerPotential::Bak,
    ];
    let intensity = lcg.between(0.05, 0.3);
    let shadows = [
        TowerShadow::None,
        TowerShadow::Powles,
        TowerShadow::Eames { intensity },
    ];
    let potential = potentials[(lcg.next() * 3.0) as usize];
    let shadow = shadows[(lcg.next() * 3.0) as usize];
    let foot = [lcg.between(-3.0, 3.0), lcg.between(-3.0, 3.0)];
    Tower::new(foot, radii, 0.7, potential, shadow).unwrap()
}

fn frame(lcg: &mut Lcg) -> WindFrame {
    let mut vector = || Vector3::from([0; 3].map(|_| lcg.between(-1.0, 1.0)));
    WindFrame::new(vector() * 50.0, vector(), vector()).unwrap()
}

/// A point near the rotor or the tower, in the axes of the wind, as a point of the inertial frame.
fn point(frame: &WindFrame, lcg: &mut Lcg) -> Vector3<f64> {
    let reach = if lcg.next() < 0.5 { 12.0 } else { 60.0 };
    let local = [
        lcg.between(-reach, reach),
        lcg.between(-reach, reach),
        lcg.between(-5.0, 160.0),
    ];
    // the origin of the frame in its own axes is zero
    let origin = frame.point(&[0.0; 3]);
    Vector3::from(frame.vector(&[0, 1, 2].map(|i| local[i] - origin[i])))
}

/// Largest difference of the gradient and central differences, over the size of the gradient;
/// `None` at a kink between the two points: there the one-sided differences do not agree.
fn defect(wind: &Wind, at: &Vector3<f64>, time: f64) -> Option<f64> {
    const STEP: f64 = 1e-5;
    let (velocity, gradient) = wind.sample(at, time).unwrap();
    // `x^p` of a number and of a dual number may differ by rounding
    assert!((velocity - wind.velocity(at, time)).norm() < 1e-12);
    let mut worst = 0.0_f64;
    for j in 0..3 {
        let value = |h: f64| wind.velocity(&(at + Vector3::ith(j, h)), time);
        let [low, high] = [value(-STEP), value(STEP)];
        let [left, right] = [(velocity - low) / STEP, (high - velocity) / STEP];
        if (left - right).norm() > 1e-3 * (1.0 + gradient.norm()) {
            return None;
        }
        let central = (high - low) / (2.0 * STEP);
        worst = worst.max((central - gradient.column(j)).norm());
    }
    Some(worst / (1.0 + gradient.norm()))
}

/// Rounding: 1e-14 of 30 m/s over 2e-5 m; truncation: the third derivatives beside the tower
/// are below 1e2, times 1e-10/6.
const GRADIENT: f64 = 2e-7;

fn compare(build: impl Fn(&mut Lcg) -> Wind, seed: u64, count: usize) {
    let mut lcg = Lcg(seed);
    let (mut kinks, mut compared) = (0, 0);
    for _ in 0..count {
        let wind = build(&mut lcg);
        let at = point(&wind.frame, &mut lcg);
        match defect(&wind, &at, lcg.between(0.0, 10.0)) {
            Some(defect) => {
                assert!(defect < GRADIENT, "{defect} {wind:?} {at}");
                compared += 1;
            }
            None => kinks += 1,
        }
    }
    assert!(compared > 50 * kinks, "{compared} {kinks}");
}

#[test]
fn gradient_of_the_mean_wind_and_events() {
    let build = |lcg: &mut Lcg| Wind {
        frame: frame(lcg),
        mean: Mean::Steady(mean(lcg)),
        events: vec![event(lcg), event(lcg)],
        ..Wind::default()
    };
    compare(build, 1, 600);
}

#[test]
fn gradient_of_gusts() {
    let build = |lcg: &mut Lcg| Wind {
        frame: frame(lcg),
        gusts: vec![gust(lcg)],
        ..Wind::default()
    };
    compare(build, 2, 600);
}

#[test]
fn gradient_of_towers() {
    let build = |lcg: &mut Lcg| Wind {
        frame: frame(lcg),
        mean: Mean::Steady(mean(lcg)),
        towers: vec![tower(lcg)],
        ..Wind::default()
    };
    compare(build, 3, 1000);
}

#[test]
fn gradient_of_boxes_and_of_all_parts() {
    let build = |lcg: &mut Lcg| {
        let seed = (lcg.next() * 1e6) as u64;
        let turbulence = TurbulenceBox::from_values("box", random(small(8, true), seed));
        Wind {
            frame: frame(lcg),
            mean: Mean::Steady(mean(lcg)),
            events: vec![event(lcg)],
            gusts: vec![gust(lcg)],
            boxes: vec![
                turbulence
                    .unwrap()
                    .with_outside(crate::wind::OutsideGrid::Extend),
            ],
            towers: vec![tower(lcg)],
        }
    };
    compare(build, 4, 600);
}

#[test]
fn parts_are_added_in_the_axes_of_the_wind() {
    let steady = MeanWind {
        speed: 10.0,
        ..MeanWind::default()
    };
    let edge = TravelingGust {
        shape: GustShape::SharpEdge { ramp: 0.0 },
        velocity: [0.0, 0.0, 3.0],
        direction: [1.0, 0.0, 0.0],
        convection: 10.0,
        front: 0.0,
    };
    let frame = WindFrame::new(Vector3::zeros(), -Vector3::y(), Vector3::x()).unwrap();
    let wind = Wind {
        frame,
        mean: Mean::Steady(steady),
        events: vec![Event {
            start: 0.0,
            shape: EventShape::CoherentGust {
                rise: 15.0,
                angle: 0.0,
            },
        }],
        gusts: vec![edge],
        ..Wind::default()
    };
    let at = |y: f64, time: f64| wind.velocity(&Vector3::new(0.0, y, 0.0), time);
    assert_eq!(at(0.0, -1.0), Vector3::new(0.0, -10.0, 0.0));
    assert!((at(0.0, 50.0) - Vector3::new(3.0, -25.0, 0.0)).norm() < 1e-13);
    // the front is 500 m downwind after 50 s
    assert_eq!(at(-499.0, 50.0).x, 3.0);
    assert_eq!(at(-501.0, 50.0).x, 0.0);
}

#[test]
fn a_uniform_wind_is_constant() {
    for velocity in [[3.0, -4.0, 1.5], [0.0, 0.0, -2.0], [0.0; 3]] {
        let velocity = Vector3::from(velocity);
        let wind = Wind::uniform(&velocity, Vector3::new(0.0, 1.0, 3.0)).unwrap();
        let constant = wind.constant().unwrap();
        assert!((constant - velocity).norm() < 1e-14);
        let (found, gradient) = wind.velocity_and_gradient(&Vector3::repeat(-7.0), 9.0);
        assert!((found - velocity).norm() < 1e-14 && gradient.norm() == 0.0);
        assert_eq!(wind.next_corner(&velocity, 0.0), f64::INFINITY);
    }
    assert!(Wind::uniform(&Vector3::repeat(f64::NAN), Vector3::z()).is_err());
}

#[test]
fn parts_that_vary_and_their_corners() {
    let mut lcg = Lcg(12);
    let mut wind = Wind {
        mean: Mean::Steady(MeanWind {
            speed: 5.0,
            ..MeanWind::default()
        }),
        ..Wind::default()
    };
    assert_eq!(wind.variation(), None);
    wind.towers.push(tower(&mut lcg));
    assert_eq!(wind.variation(), Some("a tower"));
    wind.gusts.push(TravelingGust {
        shape: GustShape::SharpEdge { ramp: 4.0 },
        velocity: [0.0, 0.0, 1.0],
        direction: [1.0, 0.0, 0.0],
        convection: 2.0,
        front: -10.0,
    });
    assert_eq!(wind.variation(), Some("a gust"));
    wind.events.push(Event {
        start: 1.0,
        shape: EventShape::DirectionChange { angle: 0.1 },
    });
    assert_eq!(wind.variation(), Some("an event"));
    let at = Vector3::new(2.0, 0.0, 0.0);
    let mut corners = vec![0.0];
    while corners[corners.len() - 1] < 100.0 {
        corners.push(wind.next_corner(&at, corners[corners.len() - 1]));
    }
    // the event from 1 s to 7 s in quarters; the gust at 6 s and 8 s
    let expected = [0.0, 1.0, 2.5, 4.0, 5.5, 6.0, 7.0, 8.0, f64::INFINITY];
    assert_eq!(corners, expected);
    wind.mean = Mean::Table(WindTable::new(vec![(3.0, MeanWind::default())]).unwrap());
    assert_eq!(wind.next_corner(&at, 2.5), 3.0);
    assert_eq!(wind.variation(), Some("a table over time"));
}

#[test]
fn a_point_without_wind_is_not_a_number() {
    let values = random(small(8, true), 1);
    let wind = Wind {
        boxes: vec![TurbulenceBox::from_values("box", values).unwrap()],
        ..Wind::default()
    };
    let high = Vector3::new(0.0, 0.0, 500.0);
    assert!(matches!(
        wind.sample(&high, 0.0),
        Err(WindProblem::Outside { .. })
    ));
    let (velocity, gradient) = wind.velocity_and_gradient(&high, 0.0);
    assert!(velocity.iter().chain(gradient.iter()).all(|v| v.is_nan()));
    assert!(wind.velocity(&high, 0.0).iter().all(|v| v.is_nan()));
}

/// Numbers that are not finite give numbers that are not, without panic.
#[test]
fn any_input_is_survived() {
    let mut lcg = Lcg(9);
    for i in 0..400 {
        let turbulence = TurbulenceBox::from_values("box", random(small(8, true), i)).unwrap();
        let wind = Wind {
            frame: WindFrame::default(),
            mean: Mean::Steady(mean(&mut lcg)),
            events: vec![event(&mut lcg)],
            gusts: vec![gust(&mut lcg)],
            boxes: if i % 2 == 0 { vec![turbulence] } else { vec![] },
            towers: vec![tower(&mut lcg)],
        };
        let odd = [
            f64::NAN,
            f64::INFINITY,
            -f64::INFINITY,
            0.0,
            1e300,
            -1e300,
            70.0,
        ];
        let mut any = || odd[(lcg.next() * 7.0) as usize];
        let (at, time) = (Vector3::new(any(), any(), any()), any());
        let _ = wind.velocity_and_gradient(&at, time);
    }
}

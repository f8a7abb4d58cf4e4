//! A strip on a body at rest in a wind that varies: forces of a gust, corners in time, and points
//! without wind.

use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};
use rotor_aero::airfoil::{Section, built_in};
use rotor_aero::strip::{SectionModel, Strip, StripDesign};
use rotor_aero::wind::{
    Atmosphere, BoxGrid, BoxValues, Event, EventShape, GustShape, TravelingGust, TurbulenceBox,
    Wind,
};

use super::{Air, AirStrip, Shaft, StripGeometry, StripRotor, TipRadius};
use crate::elements::{
    Element, Local, LocalJacobian, LocalResidual, LocalSize, Observations, Queries,
};
use crate::model::{Conditions, Equation, Node, NodeMotion, Scalars};

/// Speed of the wind \[m/s\].
const SPEED: f64 = 60.0;
/// Amplitude of the gust \[m/s\].
const GUST: f64 = 1.5;
/// Length of the gust \[m\].
const LENGTH: f64 = 30.0;
const CHORD: f64 = 0.8;
const SPAN: f64 = 1.7;

/// Wind against the leading edge, with a gust upward whose front is 12 m ahead at the time 0.
fn gust() -> Wind {
    let mut wind = Wind::uniform(&Vector3::new(-SPEED, 0.0, 0.0), Vector3::y()).unwrap();
    wind.gusts.push(TravelingGust {
        shape: GustShape::OneMinusCosine { length: LENGTH },
        velocity: [0.0, 0.0, GUST],
        direction: [1.0, 0.0, 0.0],
        convection: SPEED,
        front: -12.0,
    });
    wind
}

/// A strip of a thin airfoil: leading edge along x, span along z, quarter chord 3 m behind the
/// origin.
fn strip(wind: Wind) -> (AirStrip, Node) {
    strip_of(wind, None)
}

/// The same of a rotor.
fn strip_of(wind: Wind, rotor: Option<StripRotor>) -> (AirStrip, Node) {
    made(Air::new(Atmosphere::default(), wind), "thin", rotor)
}

/// A strip of another airfoil in air that refuses Mach numbers beyond its table, or does not.
fn strip_in(wind: Wind, airfoil: &str, refuses: bool) -> (AirStrip, Node) {
    let air = Air::new(Atmosphere::default(), wind);
    let air = if refuses { air.refusing_mach() } else { air };
    made(air, airfoil, None)
}

fn made(air: Air, airfoil: &str, rotor: Option<StripRotor>) -> (AirStrip, Node) {
    let node = Node {
        label: "body".to_owned(),
        position: Vector3::new(-3.0, 0.0, 0.0),
        rotation: Matrix3::identity(),
    };
    let design = StripDesign {
        chord: CHORD,
        section: Section::single(Arc::new(built_in(airfoil).unwrap())),
        model: SectionModel::of_word("quasi_steady").unwrap(),
        inflow: None,
        radial_drag: false,
    };
    let geometry = StripGeometry {
        offset: Vector3::zeros(),
        axes: Matrix3::identity(),
        length: SPAN,
    };
    let air = Arc::new(air);
    let strip = (Arc::new(Strip::new(design)), geometry);
    let placed = (0, &node, Vector3::zeros());
    (AirStrip::on_body("strip", placed, strip, rotor, air), node)
}

/// Calls with the strip at rest at a time.
fn at_rest<T>(strip: &AirStrip, node: &Node, time: f64, call: impl Fn(&Local<'_>) -> T) -> T {
    let mut conditions = Conditions::at_rest();
    conditions.loading.time = time;
    conditions.loading.air = 1.0;
    let motion = [NodeMotion::at_rest(node)];
    let numbers = vec![1.0; strip.scalars().len()];
    call(&Local {
        nodes: &motion,
        multipliers: &[],
        scalars: Scalars {
            values: &numbers,
            rates: &vec![0.0; numbers.len()],
        },
        memory: &[],
        frame: &conditions.frame,
        loading: &conditions.loading,
    })
}

/// The force on the node at a time, and the reason if there is none.
fn force(strip: &AirStrip, node: &Node, time: f64) -> (Vector3<f64>, Option<String>) {
    at_rest(strip, node, time, |at| {
        let size = LocalSize::of(strip);
        let (mut residual, mut jacobian) = (LocalResidual::new(size), LocalJacobian::new(size));
        strip.evaluate(at, &mut residual, Some(&mut jacobian));
        let row = Equation::Force.row();
        let values = &residual.values()[row..row + 3];
        (Vector3::from_row_slice(values), strip.without_value(at))
    })
}

/// In the middle of the gust the flow has the angle `atan(w/U)`; lift and normal load are the force
/// on the node, and the moment about the origin is the one of the force at x = -3 m.
#[test]
fn the_report_has_the_angle_of_the_flow() {
    let shaft = Shaft {
        center: Vector3::zeros(),
        axis: Vector3::y(),
    };
    let rotor = StripRotor {
        shaft,
        hub: None,
        tip_radius: TipRadius::new("tip", (0, Vector3::zeros()), shaft, None)
            .scalar()
            .clone(),
        disk: None,
    };
    let (strip, node) = strip_of(gust(), Some(rotor));
    let (acting, _) = force(&strip, &node, 0.5);
    let state = at_rest(&strip, &node, 0.5, |at| {
        let mut out = Observations::default();
        strip.observe(at, &mut out);
        out.air.remove(0)
    });
    let flow = &state.flow;
    let (angle, speed) = ((GUST / SPEED).atan(), SPEED.hypot(GUST));
    assert!((flow.alpha - angle).abs() < 1e-13);
    // The shaft is along y, the upper surface.
    assert!((flow.inflow_angle + angle).abs() < 1e-13);
    assert!((flow.speed - speed).abs() < 1e-12);
    assert_eq!(flow.induced, [0.0; 2]);
    // Lift of the thin airfoil, 2 pi alpha within alpha^2 / 6 = 1e-4 of it.
    let lift = std::f64::consts::TAU * angle;
    assert!((flow.coefficients[0] / lift - 1.0).abs() < 2e-4);
    assert!(flow.coefficients[1].abs() < 1e-12 && flow.coefficients[2].abs() < 1e-12);
    assert!((state.force - acting).norm() < 1e-12 * acting.norm());
    assert!((state.flow.along_shaft * SPAN - acting.y).abs() < 1e-12 * acting.y);
    let moment = node.position.cross(&acting);
    assert!((state.moment - moment).norm() < 1e-12 * moment.norm());
    assert!((state.radius - 3.0).abs() < 1e-15);
    assert!((state.azimuth - std::f64::consts::PI).abs() < 1e-15);
    assert!((state.rotor.unwrap().velocity.x - SPEED).abs() < 1e-12);
}

/// Lift of thin airfoil theory, `rho U^2/2 2 pi alpha c b` with `alpha = w/U`: for the angle
/// 0.025 the terms of higher order, `(w/U)^2/6`, are below 1.1e-4 of it.
#[test]
fn lift_follows_the_gust() {
    let (strip, node) = strip(gust());
    let density = Atmosphere::default().density;
    let most = density * std::f64::consts::PI * SPEED * GUST * CHORD * SPAN;
    for step in 0..=40 {
        // the front passes the quarter chord when it has traveled 15 m
        let time = 0.02 * f64::from(step);
        let behind = SPEED * time - 15.0;
        let phase = std::f64::consts::TAU * behind / LENGTH;
        let inside = (0.0..LENGTH).contains(&behind);
        let shape = if inside {
            0.5 * (1.0 - phase.cos())
        } else {
            0.0
        };
        let (found, why) = force(&strip, &node, time);
        assert!((found.y - most * shape).abs() < 1.1e-4 * most, "{time}");
        assert!(why.is_none());
    }
    // lift is normal to the flow: a thrust w/U of it in the middle of the gust
    let (found, _) = force(&strip, &node, 0.5);
    assert!((found.x / found.y - GUST / SPEED).abs() < 1e-12);
}

#[test]
fn corners_are_the_times_at_the_strip() {
    let mut wind = gust();
    wind.events.push(Event {
        start: 3.0,
        shape: EventShape::DirectionChange { angle: 0.2 },
    });
    let (strip, _) = strip(wind);
    let mut corners = vec![0.0];
    while corners.len() < 9 {
        corners.push(strip.next_corner(corners[corners.len() - 1]));
    }
    // the gust in 0.25 s to 0.75 s, the event in 3 s to 9 s
    let expected = [0.0, 0.25, 0.5, 0.75, 3.0, 4.5, 6.0, 7.5, 9.0];
    for (corner, expected) in corners.iter().zip(expected) {
        assert!((corner - expected).abs() < 1e-12, "{corners:?}");
    }
    assert_eq!(strip.next_corner(9.0), f64::INFINITY);
}

#[test]
fn outside_a_box_there_is_no_force_but_a_reason() {
    let grid = BoxGrid {
        planes: 4,
        lateral: 3,
        vertical: 3,
        tower: 0,
        time_step: 0.5,
        lateral_step: 10.0,
        vertical_step: 10.0,
        speed: 10.0,
        bottom: -10.0,
        hub_height: 0.0,
        periodic: false,
    };
    let planes = vec![vec![1.0; grid.values()]; grid.planes];
    let values = BoxValues { grid, planes };
    let wind = || Wind {
        boxes: vec![TurbulenceBox::from_values("a.bts", values.clone()).unwrap()],
        ..Wind::default()
    };
    let (inside, node) = strip(wind());
    let (found, why) = force(&inside, &node, 0.0);
    assert!(found.iter().all(|number| number.is_finite()) && why.is_none());
    let (found, why) = force(&inside, &node, 5.0);
    let why = why.unwrap();
    assert!(found.iter().all(|number| number.is_nan()), "{found}");
    assert!(
        why.contains("a.bts: no turbulence at x = -3 m and t = 5 s"),
        "{why}"
    );
    assert!(why.contains("use a longer box"), "{why}");
}

/// The table of NACA 0012 ends at Mach 0.8, which is 272.2 m/s in standard air.
#[test]
fn beyond_a_table_there_is_no_force_but_a_reason() {
    let wind = |speed: f64| Wind::uniform(&Vector3::new(-speed, 0.0, 0.0), Vector3::y()).unwrap();
    let of = |speed: f64, refuses: bool| {
        let (strip, node) = strip_in(wind(speed), "naca0012", refuses);
        force(&strip, &node, 0.0)
    };
    for (speed, refuses) in [(272.0, true), (273.0, false)] {
        let (found, why) = of(speed, refuses);
        assert!(found.iter().all(|number| number.is_finite()) && why.is_none());
    }
    let (found, why) = of(273.0, true);
    assert!(found.iter().all(|number| number.is_nan()), "{found}");
    let why = why.unwrap();
    assert!(
        why.starts_with(
            "the flow has Mach 0.802, and the table of airfoil \"NACA 0012\" is for Mach numbers from \
             0.15 to 0.8; add tables of larger Mach numbers"
        ),
        "{why}"
    );
}

#[test]
fn the_text_of_an_element_has_the_wind() {
    let [one, two] = [gust(), Wind::default()].map(|wind| format!("{:?}", strip(wind).0));
    assert_ne!(one, two);
    // of a fixed length, whatever the wind has
    assert_eq!(one.len(), two.len());
    assert_eq!(one, format!("{:?}", strip(gust()).0));
}

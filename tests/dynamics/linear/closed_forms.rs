//! Systems with transfer functions in closed form.

use nalgebra::Complex;

use super::{direct, linear, off, response};

/// A mass on a radial guide of a hub, on a spring of 900 N/m that is relaxed at 1 m.
const MASS: &str = "[[node]]\nname = \"mass\"\nposition = [1, 0, 0]\n\
    [[body]]\nname = \"mass\"\nnode = \"mass\"\nmass = 2\ninertia = [1, 1, 1]\n\
    [[joint]]\nname = \"guide\"\nkind = \"prismatic\"\nnodes = [\"mass\"]\naxis = [1, 0, 0]\n\
    [[spring]]\nname = \"spring\"\nnode = \"mass\"\nstiffness = [900, 0, 0]\n\
    [sensors.x]\nquantity = \"position\"\nof = \"mass\"\ncomponent = \"x\"\n\
    [[load]]\nnode = \"mass\"\nforce = [1, 0, 0]\n";

// A control of a trim is an input: x/u = 1/(m s^2 + k - m W^2) about x = 1.5 m at 4 rad/s; the reaction
// across the guide is the force of Coriolis, 2 m W s x.
#[test]
fn a_control_of_a_trim() {
    let text = format!(
        "{MASS}drive = \"= pull\"\n[trim]\nmethod = \"equilibrium\"\nspeed = 4\n\
         [[trim.control]]\nname = \"pull\"\nguess = 10\nscale = 100\n\
         [[trim.target]]\nname = \"place\"\nsignal = \"= x\"\nvalue = 1.5\n\
         [sensors.side]\nquantity = \"reaction_force\"\nof = \"guide\"\nnode = \"mass\"\n\
         component = \"y\"\n"
    );
    let model = linear(&text, (&["pull"], &["x", "side"], 0.0));
    assert!((model.inputs[0].value.unwrap() - (450.0 - 48.0)).abs() < 1e-6);
    assert!((model.outputs[0].value.unwrap() - 1.5).abs() < 1e-9);
    let s = Complex::new(0.2, 7.0);
    let x = 1.0 / (s * s * 2.0 + 900.0 - 2.0 * 16.0);
    let found = response(&model, s);
    for (found, expected) in [(found[0], x), (found[1], s * x * 2.0 * 2.0 * 4.0)] {
        assert!(
            (found - expected).norm() < 1e-9 * expected.norm(),
            "{found} {expected}"
        );
    }
}

/// A pendulum of a mass of 2 kg at 0.5 m on an arm of 0.4 m whose angle is driven, with a damper.
const DRIVEN: &str = "[[node]]\nname = \"arm\"\nposition = [0, 0, 0]\n\
    [[node]]\nname = \"bob\"\nposition = [0.4, 0, -0.5]\n\
    [[body]]\nname = \"arm\"\nnode = \"arm\"\nmass = 1\ninertia = [1, 1, 1]\n\
    [[body]]\nname = \"bob\"\nnode = \"bob\"\nmass = 2\ninertia = [0.1, 0.1, 0.1]\n\
    [[joint]]\nname = \"servo\"\nkind = \"revolute\"\nnodes = [\"arm\"]\naxis = [0, 1, 0]\n\
    angle = \"pitch\"\n\
    [[joint]]\nname = \"pin\"\nkind = \"revolute\"\nnodes = [\"arm\", \"bob\"]\nat = [0.4, 0, 0]\n\
    axis = [0, 1, 0]\n\
    [[spring]]\nname = \"damper\"\nnodes = [\"arm\", \"bob\"]\nat = [0.4, 0, 0]\n\
    rotational_damping = [0, 0.3, 0]\n\
    [gravity]\nacceleration = [0, 0, -9.81]\n\
    [drives.pitch]\nkind = \"constant\"\nvalue = 0\n\
    [sensors.swing]\nquantity = \"rotation\"\nof = \"bob\"\ncomponent = \"y\"\n\
    [sensors.moment]\nquantity = \"reaction_moment\"\nof = \"servo\"\nnode = \"arm\"\n\
    component = \"y\"\n";

// The input moves a joint: its second derivative is the input, and it and its rate are states. By hand,
// the bob turns by b about y, the arm by a: (J + m l^2) b'' + c (b' - a') + m g l b = 0 for an arm along
// x, whose end moves vertically.
#[test]
fn an_input_that_moves_a_joint() {
    let asked = (&["pitch"][..], &["swing", "moment"][..], 0.0);
    let model = linear(DRIVEN, asked);
    let names: Vec<_> = model
        .states
        .iter()
        .map(|state| state.name.as_str())
        .collect();
    assert!(
        names.contains(&"pitch") && names.contains(&"rate of pitch"),
        "{names:?}"
    );
    assert_eq!(model.states.len(), 4);
    assert_eq!(model.inputs[0].name, "second derivative of pitch");
    assert_eq!(model.remarks.len(), 1, "{:?}", model.remarks);
    for s in [Complex::new(0.0, 3.0), Complex::new(-0.4, 11.0)] {
        let found = response(&model, s) * (s * s);
        let all = direct(DRIVEN, asked, s);
        assert!(off(&found, &all) < 1e-10, "{found} {all}");
        let swing = s * 0.3 / (s * s * (0.1 + 2.0 * 0.25) + s * 0.3 + 2.0 * 9.81 * 0.5);
        assert!(
            (found[0] - swing).norm() < 1e-9 * swing.norm(),
            "{} {swing}",
            found[0]
        );
    }
}

// The numbers of a drive in degrees are radians as an input.
#[test]
fn a_drive_with_a_unit() {
    let asked = (&["pitch"][..], &["swing"][..], 0.0);
    let in_degrees = DRIVEN.replace("value = 0\n", "value = 0\nunit = \"deg\"\n");
    let [model, other] = [DRIVEN, &in_degrees].map(|text| linear(text, asked));
    assert_eq!(other.inputs[0].unit, "rad/s^2");
    let s = Complex::new(-0.4, 11.0);
    assert!(off(&response(&other, s), &response(&model, s)) < 1e-13);
}

// An actuator of 5 Hz between the input and the joint: two states of its own, and w^2/(s^2 + 2 z w s +
// w^2) of the transfer function of the angle.
#[test]
fn an_actuator_moves_a_joint() {
    let text = DRIVEN.replace("angle = \"pitch\"", "angle = \"servo_angle\"")
        + "[[actuator]]\nname = \"servo_angle\"\ncommand = \"pitch\"\nfrequency = \"5 Hz\"\n";
    let asked = (&["pitch"][..], &["swing", "servo_angle"][..], 0.0);
    let model = linear(&text, asked);
    assert_eq!((model.states.len(), model.remarks.len()), (4, 0));
    let s = Complex::new(-0.4, 11.0);
    let found = response(&model, s);
    let w = 10.0 * std::f64::consts::PI;
    let servo = w * w / (s * s + s * 2.0 * 0.7 * w + w * w);
    let swing = s * 0.3 / (s * s * (0.1 + 2.0 * 0.25) + s * 0.3 + 2.0 * 9.81 * 0.5);
    for (found, expected) in [(found[0], swing * servo), (found[1], servo)] {
        assert!(
            (found - expected).norm() < 1e-8 * expected.norm(),
            "{found} {expected}"
        );
    }
}

/// An elastic cantilever of 2 m with a force at its tip, bent by a quarter of its length.
const BENT: &str = "[properties.strip]\nea = 1e5\ngay = 4e4\ngaz = 4e4\ngj = 20\neiy = 10\neiz = 30\n\
    m = 0.5\niy = 1e-4\niz = 1e-4\n\
    [[blade]]\nname = \"blade\"\nproperties = \"strip\"\npiece = [{ length = 2, elements = 2 }]\n\
    [[load]]\nnode = \"blade/tip\"\nforce = [0, 0, 1]\ndrive = \"force\"\n\
    [drives.force]\nkind = \"constant\"\nvalue = VALUE\n\
    [[output.column]]\nname = \"tip\"\nquantity = \"displacement\"\nof = \"blade/tip\"\n\
    [[output.column]]\nname = \"strain\"\nquantity = \"strain\"\nof = \"blade/beam 1\"\n\
    point = 1\ncomponent = \"bending_y\"\n";

// The gains at rest, D - C A^-1 B, are the differences of equilibria under larger and smaller forces: the
// error of central differences is (h/F)^2 = 1e-6 of the curvature, and the beams are exact.
#[test]
fn gains_at_rest_are_differences_of_equilibria() {
    let of = |force: f64| {
        let text = BENT.replace("VALUE", &format!("{force:?}"));
        let input = super::parsed(&text, (&["force"], &["tip_x", "tip_z", "strain"], 0.0));
        let read = |_: &[(String, f64)]| unreachable!();
        let found = beam_dynamics::analysis::linear::linearize(&input, &read);
        found.unwrap_or_else(|failure| panic!("{failure}"))
    };
    let [below, model, above] = [2.997, 3.0, 3.003].map(of);
    assert!(model.outputs[1].value.unwrap() > 0.5);
    let gain = &model.d - &model.c * model.a.clone().lu().solve(&model.b).unwrap();
    for i in 0..3 {
        let [low, high] = [&below, &above].map(|own| own.outputs[i].value.unwrap());
        let expected = (high - low) / 0.006;
        let found = gain[(i, 0)];
        assert!(
            (found / expected - 1.0).abs() < 1e-5,
            "{i}: {found} {expected}"
        );
    }
    assert_eq!(model.outputs[2].unit, "1/m");
}

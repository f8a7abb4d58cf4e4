//! Statics and modes.

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::analysis::statics::statics;
use beam_dynamics::assembly::System;
use beam_dynamics::case::{Model, ModesSettings, StaticSettings};
use beam_dynamics::elements::beams::{Beam, BeamGeometry, BeamNode};
use beam_dynamics::elements::joints::clamped;
use beam_dynamics::elements::loads::{LoadFactor, NodalForce, NodalLoad, Turning};
use cpu_time::ThreadTime;
use nalgebra::{Matrix6, Rotation3, Vector3, Vector6};

use crate::line::{Inertia, Parts, Section};
use crate::rows::{MS, SPAN, US};
use crate::table::Row;
use crate::yardstick::Yardstick;

const BEAMS: usize = 100;

/// The cantilever bent to 45 degrees of a circle of 100 m, with a load out of its plane.
fn bend() -> Model {
    const RADIUS: f64 = 100.0;
    let mut parts = Parts::default();
    for i in 0..=2 * BEAMS {
        let angle = std::f64::consts::FRAC_PI_4 * i as f64 / (2 * BEAMS) as f64;
        let position = RADIUS * Vector3::new(angle.sin(), 1.0 - angle.cos(), 0.0);
        let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), angle);
        parts.node(position, turn.into_inner());
    }
    let stiffness = Vector6::new(1e7, 5e6, 5e6, 5e6 / 6.0, 1e7 / 12.0, 1e7 / 12.0);
    let stiffness = Matrix6::from_diagonal(&stiffness);
    let geometry = BeamGeometry::new([BeamNode::aligned(); 3]);
    for beam in 0..BEAMS {
        let on = [0, 1, 2].map(|i| 2 * beam + i);
        let at = on.map(|i| &parts.nodes[i]);
        let beam = Beam::elastic("beam", on, geometry, at, [stiffness; 2]);
        parts.add(beam);
    }
    let clamp = clamped("root", 0, &parts.nodes[0]);
    parts.add(clamp);
    let force = NodalForce {
        force: Vector3::new(0.0, 0.0, 600.0),
        moment: Vector3::zeros(),
        offset: Vector3::zeros(),
        turning: Turning::Dead,
        factor: LoadFactor::Proportional,
    };
    let tip = 2 * BEAMS;
    let load = NodalLoad::new("push", tip, &parts.nodes[tip], force);
    parts.add(load);
    Model::new("bend", System::new(parts.nodes, parts.elements))
}

/// Iterations of the bend to 600 N in ten steps, including the rates of the path and the forces in
/// the beams. The reference tip is the exact rod's, `exact_static_beams.json`.
fn iteration(yardstick: &mut Yardstick) -> Option<Row> {
    let model = bend();
    let settings = StaticSettings {
        speed: 0.0,
        to: 1.0,
        steps: Some(10),
        arc_length: false,
        most_steps: 100,
        sweep: None,
    };
    let exact = Vector3::new(47.150_438, 15.684_801, 53.474_859);
    let (mut off, mut iterations) = (f64::INFINITY, 0);
    let time = yardstick.beside(SPAN, || {
        let begin = ThreadTime::now();
        let outcome = statics(&model, &settings);
        let time = begin.elapsed().as_secs_f64();
        let steps = &outcome.result.steps;
        iterations = steps.iter().map(|step| step.iterations).sum();
        off = (steps.last()?.positions.last()? - exact).norm();
        outcome.failure.is_none().then_some(time)
    })? / (BEAMS * iterations) as f64;
    Some(Row {
        name: format!("statics, bend of {BEAMS} beams"),
        ratio: time / yardstick.time(),
        limit: 3.2,
        meaning: "beam and iteration / yardstick",
        time: format!("{:.2} us, {iterations} in the run", time / US),
        accuracy: format!("tip {off:.0e} m off"),
    })
}

/// Twenty modes of a cantilever at rest. Its first frequency is a slender beam's, `3.516015 sqrt(EI
/// / (m L^4))`, except for shear and rotary inertia of about 1e-5 of it.
fn frequencies(yardstick: &mut Yardstick) -> Option<Row> {
    const MODES: usize = 20;
    let mut parts = Parts::default();
    let section = Section {
        stiffness: [1e5, 4e4, 4e4, 1.2, 1.0, 3.0],
        mass: 0.6,
        moments: [2.4e-5, 6e-6, 1.8e-5],
        inertia: Inertia::Lumped,
    };
    let axes = nalgebra::Matrix3::identity();
    let (root, _) = parts.line(Vector3::zeros(), &axes, (1.0, BEAMS), &section);
    let clamp = clamped("root", root, &parts.nodes[root]);
    parts.add(clamp);
    let model = Model::new("modes", System::new(parts.nodes, parts.elements));
    let settings = ModesSettings::new(vec![0.0], MODES);
    let slender = 3.516_015_269 / 0.6_f64.sqrt() / std::f64::consts::TAU;
    let mut off = f64::INFINITY;
    let time = yardstick.beside(SPAN, || {
        let begin = ThreadTime::now();
        let outcome = modes(&model, &settings);
        let time = begin.elapsed().as_secs_f64();
        let first = outcome.table.branches.first()?.points.first()?.as_ref()?;
        off = first.frequency / slender - 1.0;
        outcome.failure.is_none().then_some(time)
    })?;
    Some(Row {
        name: format!("modes, cantilever of {BEAMS} beams"),
        ratio: time / (BEAMS * MODES) as f64 / yardstick.time(),
        limit: 9.0,
        meaning: "beam and mode / yardstick",
        time: format!("{:.1} ms, {MODES} modes", time / MS),
        accuracy: format!("first {off:.0e} from a slender beam"),
    })
}

/// Statics and modes, each of a hundred beams.
pub fn equilibria(yardstick: &mut Yardstick) -> Option<Vec<Row>> {
    Some(vec![iteration(yardstick)?, frequencies(yardstick)?])
}

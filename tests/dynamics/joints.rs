//! Rigid bodies on hinges and on a moving hub, against their equations of motion.

use std::f64::consts::PI;

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::analysis::steady::equilibrium;
use beam_dynamics::assembly::System;
use beam_dynamics::case::{Model, ModesSettings};
use beam_dynamics::elements::bodies::{RigidBody, RigidInertia};
use beam_dynamics::elements::joints::{
    Hinge, HingeSpring, clamped, partly_clamped, rigid_connection,
};
use beam_dynamics::elements::springs::{SupportFrame, SupportLaw, SupportSpring};
use beam_dynamics::elements::{Element, Reaction};
use beam_dynamics::model::{Node, State};
use beam_dynamics::solver::LinearSolver;
use nalgebra::{Complex, DMatrix, Matrix3, Vector2, Vector3};

use crate::record;

fn node(label: &str, position: Vector3<f64>, rotation: Matrix3<f64>) -> Node {
    Node {
        label: label.to_owned(),
        position,
        rotation,
    }
}

/// Eigenvalues with positive imaginary part at a speed, ascending by it.
fn eigenvalues(system: System, speed: f64, count: usize) -> Vec<Complex<f64>> {
    let model = Model::new("joints", system);
    let settings = ModesSettings::new(vec![speed], count);
    let outcome = modes(&model, &settings);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let points = outcome.table.at_speed(0);
    let value = |point: &beam_dynamics::result::ModePoint| {
        let omega = 2.0 * PI * point.frequency;
        let size = omega / (1.0 - point.damping_ratio.powi(2)).sqrt();
        Complex::new(-point.damping_ratio * size, omega)
    };
    points.into_iter().map(|(_, point)| value(point)).collect()
}

/// Checks eigenvalues against expected ones, in any order, each to `tolerance` of its size.
fn check(case: &str, found: &[Complex<f64>], expected: Vec<Complex<f64>>, tolerance: f64) {
    let mut left = found.to_vec();
    assert_eq!(
        found.len(),
        expected.len(),
        "{case}: {found:?} {expected:?}"
    );
    for (i, expected) in expected.iter().enumerate() {
        let off = |s: &Complex<f64>| (s - expected).norm() / expected.norm();
        let nearest = (0..left.len()).min_by(|&a, &b| off(&left[a]).total_cmp(&off(&left[b])));
        let found = left.swap_remove(nearest.unwrap());
        let error = off(&found);
        let quantity = format!("eigenvalue {} [1/s]", i + 1);
        let sizes = [found.norm(), expected.norm()];
        record::value("closed form", case, &quantity, sizes, error, tolerance);
        assert!(error < tolerance, "{case}: {found} against {expected}");
    }
}

/// Mass, distance of the center from the hinge, and offset of the hinge from the axis.
const MASS: f64 = 3.0;
const CENTER: f64 = 2.0;
const OFFSET: f64 = 0.4;
/// Central inertia of a flat blade: z = 0 for all of its mass, as in thin-blade theory, so that
/// `jx + jy = jz`.
const CENTRAL: [f64; 3] = [0.1, 1.5, 1.6];

/// A blade along x on one hinge at the offset, held by the turning frame.
fn hinged(axis: Vector3<f64>, spring: HingeSpring) -> System {
    let identity = Matrix3::identity();
    let hinge = Vector3::new(OFFSET, 0.0, 0.0);
    let nodes = vec![
        node("hub", Vector3::zeros(), identity),
        node("blade", hinge, identity),
    ];
    let central = Matrix3::from_diagonal(&Vector3::from(CENTRAL));
    let body = RigidInertia::about_node(MASS, &Vector3::new(CENTER, 0.0, 0.0), &central);
    let ends = [&nodes[0], &nodes[1]];
    let elements: Vec<Box<dyn Element>> = vec![
        Box::new(clamped("clamp", 0, &nodes[0])),
        Box::new(Hinge::new("hinge", [0, 1], ends, &hinge, &axis, spring)),
        Box::new(RigidBody::new("blade", 1, body)),
    ];
    System::new(nodes, elements)
}

/// `I s^2 + c s + k = 0`, the root with positive imaginary part.
fn oscillator(inertia: f64, damping: f64, stiffness: f64) -> Complex<f64> {
    let half = -0.5 * damping / inertia;
    let root = Complex::from(half * half - stiffness / inertia).sqrt();
    let s = Complex::from(half) + root;
    Complex::new(s.re, s.im.abs())
}

// Flap: omega^2 = Omega^2 (1 + m e x_cg / I_h); lag: Omega^2 m e x_cg / I_h + k / I_h; pitch
// of a flat blade: Omega^2 + k / I_x. Potential energy of the centrifugal force,
// -1/2 Omega^2 int (X^2 + Y^2) dm, to second order in each angle. One degree of freedom
// and properties of order one: 1e-10 is the round-off of the eigenvalue solver.
#[test]
fn rigid_blades_on_flap_lag_and_pitch_hinges() {
    const SPEED: f64 = 7.0;
    let square = SPEED * SPEED;
    let static_moment = MASS * OFFSET * CENTER;
    let [jx, jy, jz] = CENTRAL;
    let about = |central: f64| central + MASS * CENTER * CENTER;
    let cases = [
        ("flap", Vector3::y(), about(jy), about(jy) + static_moment),
        ("lag", Vector3::z(), about(jz), static_moment),
        ("pitch", Vector3::x(), jx, jx),
    ];
    for (stiffness, damping) in [(0.0, 0.0), (90.0, 0.0), (90.0, 2.0), (0.0, 2.0)] {
        for (name, axis, inertia, centrifugal) in cases {
            let spring = HingeSpring {
                stiffness,
                damping: damping * inertia,
                angle: 0.0,
            };
            let found = eigenvalues(hinged(axis, spring), SPEED, 1);
            let total = square * centrifugal + stiffness;
            let expected = oscillator(inertia, damping * inertia, total);
            let case = format!("{name} hinge, spring {stiffness} N m, damper {damping} I");
            check(&case, &found, vec![expected], 1e-10);
        }
    }
}

/// The steady state at a speed, and the reactions of its joints.
fn steady(system: System, speed: f64) -> (Model, State, Vec<Reaction>) {
    let model = Model::new("joints", system);
    let solver = LinearSolver::new(model.system.pattern());
    let [rest, turning] = [0.0, speed].map(|speed| model.conditions(speed, 1.0, 0.0));
    let from = (&rest, &model.system.rest());
    let found = equilibrium(&model, &solver, from, &turning).unwrap();
    let observed = model.system.observe(&found.state, &found.conditions);
    (model, found.state, observed.reactions)
}

// A lag hinge with a spring relaxed at phi_0: the moment k (phi - phi_0) and the moment of the
// centrifugal force, Omega^2 m e x_cg sin(phi), cancel. The reactions are the centripetal force m
// Omega^2 r of the mass center on the blade, the opposite on the hub, with the arm of the offset,
// and the reaction of the clamp. Newton's method ends at 1e-9 of the largest term.
#[test]
fn spring_and_reactions_of_a_turned_lag_hinge() {
    const SPEED: f64 = 7.0;
    let spring = HingeSpring {
        stiffness: 300.0,
        damping: 2.0,
        angle: 0.4,
    };
    let (_, state, reactions) = steady(hinged(Vector3::z(), spring), SPEED);
    let turned = &state.nodes[1].rotation;
    let phi = turned[(1, 0)].atan2(turned[(0, 0)]);
    let square = SPEED * SPEED;
    let spring_moment = spring.stiffness * (phi - spring.angle);
    let balance = spring_moment + square * MASS * OFFSET * CENTER * phi.sin();
    assert!(balance.abs() < 1e-8 * 300.0, "{phi} {balance}");
    assert!(phi > 0.2 && phi < 0.39);

    let radius = Vector3::new(OFFSET + CENTER * phi.cos(), CENTER * phi.sin(), 0.0);
    let on_blade = -MASS * square * radius;
    let find = |joint: &str, node: usize| {
        let mut of = reactions.iter();
        of.find(|r| r.joint == joint && r.node == node).unwrap()
    };
    let arm = Vector3::new(OFFSET, 0.0, 0.0);
    let at_hinge = -spring_moment * Vector3::z();
    let expected = [
        (find("hinge", 1), on_blade, at_hinge),
        (
            find("hinge", 0),
            -on_blade,
            -arm.cross(&on_blade) - at_hinge,
        ),
        (find("clamp", 0), on_blade, arm.cross(&on_blade) + at_hinge),
    ];
    for (found, force, moment) in expected {
        let error = (found.force - force)
            .amax()
            .max((found.moment - moment).amax());
        assert!(error < 1e-8 * on_blade.norm(), "{found:?} {force} {moment}");
    }
}

// A body held by a rigid connection at a distance: its centripetal force, and the moment of
// that force about each node.
#[test]
fn reactions_of_a_rigid_connection() {
    const SPEED: f64 = 7.0;
    let turn = Matrix3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
    let position = Vector3::new(OFFSET, 0.3, 0.2);
    let nodes = vec![
        node("hub", Vector3::zeros(), Matrix3::identity()),
        node("body", position, turn),
    ];
    let body = RigidInertia::about_node(MASS, &Vector3::zeros(), &Matrix3::identity());
    let elements: Vec<Box<dyn Element>> = vec![
        Box::new(clamped("clamp", 0, &nodes[0])),
        Box::new(rigid_connection("rigid", [0, 1], [&nodes[0], &nodes[1]])),
        Box::new(RigidBody::new("body", 1, body)),
    ];
    let (model, state, reactions) = steady(System::new(nodes, elements), SPEED);
    let moved = state.nodes[1].position - model.system.nodes()[1].position;
    assert!(moved.amax() < 1e-14);
    let force = -MASS * SPEED * SPEED * Vector3::new(position.x, position.y, 0.0);
    let [clamp, on_hub, on_body] = [0, 1, 2].map(|i| &reactions[i]);
    let arm = position.cross(&force);
    for (found, force, moment) in [
        (clamp, force, arm),
        (on_hub, -force, -arm),
        (on_body, force, Vector3::zeros()),
    ] {
        let error = (found.force - force)
            .amax()
            .max((found.moment - moment).amax());
        assert!(error < 1e-9 * force.norm(), "{found:?} {force} {moment}");
    }
}

/// A hub of given mass and moments of inertia on a support fixed in the world.
struct Hub {
    mass: f64,
    transverse: f64,
    polar: f64,
    stiffness: [f64; 6],
    damping: [f64; 6],
    held: [bool; 6],
}

impl Hub {
    fn elements(&self, hub: &Node) -> Vec<Box<dyn Element>> {
        let moments = Vector3::new(self.transverse, self.transverse, self.polar);
        let central = Matrix3::from_diagonal(&moments);
        let body = RigidInertia::about_node(self.mass, &Vector3::zeros(), &central);
        let axes = Matrix3::identity();
        let law = SupportLaw::along(&axes, &self.stiffness, &self.damping);
        vec![
            Box::new(partly_clamped("bearing", 0, hub, &axes, self.held)),
            Box::new(SupportSpring::new(
                "support",
                0,
                hub,
                law,
                SupportFrame::World,
            )),
            Box::new(RigidBody::new("hub", 0, body)),
        ]
    }
}

// A mass on an isotropic spring and damper: m s^2 + c s + k = 0 in the world, whose motions in any
// direction are whirls in both senses; in turning axes the two eigenvalues are s +- i Omega. A disk
// on a tilt spring: with w = theta_x + i theta_y, j_t w'' + (c - i j_p Omega) w' + k w = 0, and
// each s - i Omega in turning axes.
#[test]
fn whirl_of_a_damped_hub_in_turning_axes() {
    const SPEED: f64 = 3.0;
    let turn = Complex::new(0.0, SPEED);
    let hub = node("hub", Vector3::zeros(), Matrix3::identity());

    let in_plane = Hub {
        mass: 2.0,
        transverse: 1.0,
        polar: 1.5,
        stiffness: [200.0, 200.0, 0.0, 0.0, 0.0, 0.0],
        damping: [1.7, 1.7, 0.0, 0.0, 0.0, 0.0],
        held: [false, false, true, true, true, true],
    };
    let system = System::new(vec![hub.clone()], in_plane.elements(&hub));
    let s = oscillator(2.0, 1.7, 200.0);
    let found = eigenvalues(system, SPEED, 2);
    check("hub in plane", &found, vec![s + turn, s - turn], 1e-10);

    let tilt = Hub {
        stiffness: [0.0, 0.0, 0.0, 80.0, 80.0, 0.0],
        damping: [0.0, 0.0, 0.0, 0.9, 0.9, 0.0],
        held: [true, true, true, false, false, true],
        ..in_plane
    };
    let system = System::new(vec![hub.clone()], tilt.elements(&hub));
    let (jt, jp) = (tilt.transverse, tilt.polar);
    let half = Complex::new(0.9, -jp * SPEED) / (2.0 * jt);
    let root = (half * half - 80.0 / jt).sqrt();
    let turned = [-half + root, -half - root].map(|s| s - turn);
    let upper = turned.map(|s| Complex::new(s.re, s.im.abs())).to_vec();
    check("hub tilt", &eigenvalues(system, SPEED, 2), upper, 1e-10);
}

/// Lagging blades on a hub that moves in the plane of rotation.
struct Rotor {
    blades: usize,
    hub: Hub,
    lag: HingeSpring,
}

impl Rotor {
    fn azimuth(&self, blade: usize) -> f64 {
        2.0 * PI * blade as f64 / self.blades as f64
    }

    fn system(&self) -> System {
        let mut nodes = vec![node("hub", Vector3::zeros(), Matrix3::identity())];
        let mut elements = self.hub.elements(&nodes[0]);
        let central = Matrix3::from_diagonal(&Vector3::from(CENTRAL));
        let body = RigidInertia::about_node(MASS, &Vector3::new(CENTER, 0.0, 0.0), &central);
        for blade in 0..self.blades {
            let (sine, cosine) = self.azimuth(blade).sin_cos();
            let turn = Matrix3::new(cosine, -sine, 0.0, sine, cosine, 0.0, 0.0, 0.0, 1.0);
            let hinge = OFFSET * turn.column(0).into_owned();
            nodes.push(node(&format!("blade {blade}"), hinge, turn));
            let on = [0, blade + 1];
            let ends = on.map(|i| &nodes[i]);
            let axis = Vector3::z();
            let lag = Hinge::new("lag", on, ends, &hinge, &axis, self.lag);
            elements.push(Box::new(lag));
            elements.push(Box::new(RigidBody::new("blade", on[1], body)));
        }
        System::new(nodes, elements)
    }

    /// Coleman's equations in rotating axes, for the hub at u and the lag angles zeta_k,
    /// with e_r along each blade and e_t across it, `S = m x_cg`, `I` about the hinge:
    ///
    /// ```text
    /// A = u'' + 2 Omega x u' - Omega^2 u
    /// (M + N m) A + S sum_k [ (zeta'' - Omega^2 zeta) e_t - 2 Omega zeta' e_r ]
    ///     + C (u' + Omega x u) + K u = 0
    /// I zeta'' + c zeta' + (k + Omega^2 e S) zeta + S e_t . A = 0
    /// ```
    ///
    /// Coleman and Feingold, NACA report 1351 (1958), for blades of any number.
    fn coleman(&self, speed: f64) -> Vec<Complex<f64>> {
        let n = self.blades + 2;
        let square = speed * speed;
        let (mut m, mut c, mut k) = (
            DMatrix::<f64>::zeros(n, n),
            DMatrix::<f64>::zeros(n, n),
            DMatrix::<f64>::zeros(n, n),
        );
        let total = self.hub.mass + MASS * self.blades as f64;
        // Omega x (x, y) = Omega (-y, x).
        let cross = nalgebra::Matrix2::new(0.0, -speed, speed, 0.0);
        let unit = nalgebra::Matrix2::identity();
        let (spring, damper) = (self.hub.stiffness[0], self.hub.damping[0]);
        let put = |to: &mut DMatrix<f64>, block| to.view_mut((0, 0), (2, 2)).copy_from(&block);
        put(&mut m, unit * total);
        put(&mut c, cross * (2.0 * total) + unit * damper);
        put(&mut k, unit * (spring - total * square) + cross * damper);
        let s = MASS * CENTER;
        let inertia = CENTRAL[2] + MASS * CENTER * CENTER;
        for blade in 0..self.blades {
            let i = blade + 2;
            let (sine, cosine) = self.azimuth(blade).sin_cos();
            let (e_r, e_t) = (Vector2::new(cosine, sine), Vector2::new(-sine, cosine));
            for axis in 0..2 {
                m[(axis, i)] = s * e_t[axis];
                c[(axis, i)] = -2.0 * s * speed * e_r[axis];
                k[(axis, i)] = -s * square * e_t[axis];
                m[(i, axis)] = s * e_t[axis];
                c[(i, axis)] = 2.0 * s * (cross.transpose() * e_t)[axis];
                k[(i, axis)] = -s * square * e_t[axis];
            }
            m[(i, i)] = inertia;
            c[(i, i)] = self.lag.damping;
            k[(i, i)] = self.lag.stiffness + square * OFFSET * s;
        }
        let inverse = m.try_inverse().unwrap();
        let mut first_order = DMatrix::zeros(2 * n, 2 * n);
        first_order.view_mut((0, n), (n, n)).fill_diagonal(1.0);
        let blocks = [(0, -(&inverse * &k)), (n, -(&inverse * &c))];
        for (column, block) in blocks {
            first_order.view_mut((n, column), (n, n)).copy_from(&block);
        }
        let all = first_order.complex_eigenvalues();
        let upper = all.iter().filter(|s| s.im > 0.0);
        upper.map(|s| polished(&first_order, *s)).collect()
    }
}

/// An eigenvalue to all its digits, by inverse iteration from a nearby value: the Schur form loses
/// half of the digits if two eigenvalues are equal.
fn polished(matrix: &DMatrix<f64>, near: Complex<f64>) -> Complex<f64> {
    let n = matrix.nrows();
    let beside = near * (1.0 + 1e-7);
    let shifted = DMatrix::from_fn(n, n, |i, j| {
        let diagonal = if i == j { beside } else { Complex::from(0.0) };
        Complex::from(matrix[(i, j)]) - diagonal
    });
    let inverse = shifted.lu();
    let mut x = DMatrix::from_fn(n, 1, |i, _| Complex::new(1.0 + i as f64, 0.3 * i as f64));
    let mut s = near;
    for _ in 0..8 {
        let next = inverse.solve(&x).unwrap();
        s = beside + Complex::from(x.norm_squared()) / x.dotc(&next);
        x = &next / Complex::from(next.norm());
    }
    s
}

fn rotor(blades: usize, hub_damping: f64, lag_damping: f64) -> Rotor {
    Rotor {
        blades,
        hub: Hub {
            mass: 40.0,
            transverse: 1.0,
            polar: 1.0,
            stiffness: [2500.0, 2500.0, 0.0, 0.0, 0.0, 0.0],
            damping: [hub_damping, hub_damping, 0.0, 0.0, 0.0, 0.0],
            held: [false, false, true, true, true, true],
        },
        lag: HingeSpring {
            stiffness: 60.0,
            damping: lag_damping,
            angle: 0.0,
        },
    }
}

// Both eigenvalues come from matrices of norm 1e3 with round-off 1e-16 each: 1e-8 also if two of
// them are close. (The solver replaces copies within 1e-6 of each other by their mean; no speed has
// two different ones as close as this.)
#[test]
fn ground_resonance_of_four_lagging_blades() {
    let mut unstable = 0;
    for speed in [4.0, 6.0, 8.0, 9.0, 15.0] {
        for (hub, lag) in [(0.0, 0.0), (20.0, 0.0), (20.0, 3.0)] {
            let rotor = rotor(4, hub, lag);
            let expected = rotor.coleman(speed);
            unstable += expected.iter().filter(|s| s.re > 1e-3).count();
            let found = eigenvalues(rotor.system(), speed, 6);
            let case = format!("4 lagging blades at {speed} rad/s, dampers {hub} and {lag}");
            check(&case, &found, expected, 1e-8);
        }
    }
    assert!(unstable > 0, "no speed shows ground resonance");
}

//! Undamped spectra must not grow: eigenvalues of `M^-1 K` at rest and under loads.
//!
//! The free vibrations of an undamped beam at rest, undeformed or in equilibrium under dead forces,
//! are the solutions of `K x = omega^2 M x`. With `s = i omega` a complex or negative eigenvalue is
//! a motion that grows. K and M are taken from the program's tangent; K is not symmetrized. The
//! finite-volume beam fails all of these.

use beam_dynamics::analysis::statics::statics;
use beam_dynamics::assembly::System;
use beam_dynamics::case::Model;
use beam_dynamics::elements::Element;
use beam_dynamics::elements::beams::{
    Beam, BeamGeometry, BeamInertia, BeamNode, MassAlong, lumped_bodies,
};
use beam_dynamics::elements::bodies::{RigidBody, RigidInertia};
use beam_dynamics::elements::joints::clamped;
use beam_dynamics::elements::loads::{NodalForce, NodalLoad};
use beam_dynamics::model::{Conditions, Equation, Node, State, Variable};
use beam_dynamics::solver::eigenvalues_of;
use nalgebra::{DMatrix, Matrix3, Matrix6, Rotation3, Vector3, Vector6};

use super::{mass, matrix, numbers, reference, stiffness, vector};
use crate::chain::{DEAD, up_to};
use crate::effort::cases;
use crate::record;

/// Growth over frequency above which a motion grows: the round-off of eigenvalues, 1e-16 of the
/// largest, is 1e-10 of the ones a thousand times lower in frequency.
const GROWTH: f64 = 1e-9;

/// Uniform numbers in [-1, 1), the same in every run (Knuth's MMIX constants).
pub struct Random(pub u64);

impl Random {
    pub fn number(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    pub fn between(&mut self, from: f64, to: f64) -> f64 {
        from + 0.5 * (to - from) * (1.0 + self.number())
    }

    fn vector(&mut self, size: f64) -> Vector3<f64> {
        size * Vector3::from_fn(|_, _| self.number())
    }

    fn rotation(&mut self, size: f64) -> Matrix3<f64> {
        Rotation3::new(self.vector(size)).into_inner()
    }
}

/// A clamped line of beams.
pub struct Line {
    pub nodes: Vec<Node>,
    pub geometries: Vec<BeamGeometry>,
    pub stiffness: Matrix6<f64>,
    pub mass: Matrix6<f64>,
    pub consistent: bool,
}

impl Line {
    /// Straight along x with aligned sections.
    pub fn straight(
        elements: usize,
        length: f64,
        stiffness: Matrix6<f64>,
        mass: Matrix6<f64>,
    ) -> Self {
        let count = 2 * elements;
        let node = |i: usize| Node {
            label: format!("n{i}"),
            position: Vector3::x() * (length * i as f64 / count as f64),
            rotation: Matrix3::identity(),
        };
        Self {
            nodes: (0..=count).map(node).collect(),
            geometries: vec![BeamGeometry::new([BeamNode::aligned(); 3]); elements],
            stiffness,
            mass,
            consistent: false,
        }
    }

    pub fn parts(&self) -> Vec<Box<dyn Element>> {
        let mut parts: Vec<Box<dyn Element>> = Vec::new();
        for (e, geometry) in self.geometries.iter().enumerate() {
            let on = [2 * e, 2 * e + 1, 2 * e + 2];
            let ends = on.map(|i| &self.nodes[i]);
            let stiffness = [self.stiffness; 2];
            parts.push(Box::new(Beam::elastic(
                "beam", on, *geometry, ends, stiffness,
            )));
            let mass = |_| self.mass;
            let mass = MassAlong::smooth(&mass);
            if self.consistent {
                parts.push(Box::new(BeamInertia::new(
                    "mass", on, *geometry, ends, &mass,
                )));
                continue;
            }
            for (node, body) in on
                .into_iter()
                .zip(lumped_bodies(geometry, ends, &mass).bodies)
            {
                parts.push(Box::new(RigidBody::new("mass", node, body)));
            }
        }
        parts
    }

    fn model(&self, load: Option<Vector3<f64>>) -> Model {
        self.model_of(self.parts(), load)
    }

    fn model_of(&self, mut parts: Vec<Box<dyn Element>>, load: Option<Vector3<f64>>) -> Model {
        parts.push(Box::new(clamped("clamp", 0, &self.nodes[0])));
        let tip = self.nodes.len() - 1;
        if let Some(force) = load {
            let load = NodalForce { force, ..DEAD };
            parts.push(Box::new(NodalLoad::new(
                "load",
                tip,
                &self.nodes[tip],
                load,
            )));
        }
        Model::new("line", System::new(self.nodes.clone(), parts))
    }

    /// Stiffness and mass of the free nodes at a state at rest.
    pub fn matrices(&self, model: &Model, state: &State) -> [DMatrix<f64>; 2] {
        let system = &model.system;
        let tangent = system.tangent(state, &Conditions::at_rest());
        let (force, position) = (Equation::Force.row(), Variable::Position.column());
        let (momentum, speed) = (Equation::Momentum.row(), Variable::Velocity.column());
        let free = 6 * (self.nodes.len() - 1);
        let at = |i: usize, first: usize| system.numbering().node(1 + i / 6) + first + i % 6;
        let of = |matrix: &beam_dynamics::assembly::Sparse, row, column| {
            DMatrix::from_fn(free, free, |i, j| -matrix.entry(at(i, row), at(j, column)))
        };
        [
            of(&tangent.by_unknowns, force, position),
            of(&tangent.by_rates, momentum, speed),
        ]
    }

    /// Angular frequencies in ascending order, and the worst growth over frequency.
    pub fn spectrum(&self, model: &Model, state: &State) -> (Vec<f64>, f64) {
        let [stiffness, mass] = self.matrices(model, state);
        let asymmetry = (&mass - mass.transpose()).amax() / mass.amax();
        assert!(asymmetry < 1e-14, "mass: {asymmetry:e}");
        let factor = mass.cholesky().unwrap().l();
        let half = factor.solve_lower_triangular(&stiffness).unwrap();
        let whole = factor
            .solve_lower_triangular(&half.transpose())
            .unwrap()
            .transpose();
        let (mut omega, mut worst) = (Vec::new(), 0.0_f64);
        for square in eigenvalues_of(whole.as_slice()) {
            // s^2 = - omega^2
            let s = (-square).sqrt();
            worst = worst.max(s.re.abs() / s.norm());
            omega.push(s.norm());
        }
        omega.sort_by(f64::total_cmp);
        (omega, worst)
    }

    fn at_rest(&self) -> (Vec<f64>, f64) {
        let model = self.model(None);
        self.spectrum(&model, &model.system.rest())
    }
}

fn both(mut line: Line, name: &str) {
    for consistent in [false, true] {
        line.consistent = consistent;
        let (_, growth) = line.at_rest();
        assert!(
            growth < GROWTH,
            "{name}, consistent {consistent}: {growth:e}"
        );
    }
}

/// A strip whose finite-volume modes grow by one percent of a radian with 3, 4, 8, 16
/// elements; frequencies as listed, to their digits.
#[test]
fn no_mode_of_a_straight_strip_grows() {
    let file = reference("defect_a_spectrum");
    let diagonal = numbers(&file["input"]["stiffness_diagonal"]);
    let stiffness = Matrix6::from_diagonal(&Vector6::from_column_slice(&diagonal));
    let value = |key: &str| file["input"][key].as_f64().unwrap();
    let inertia = Matrix3::from_diagonal(&Vector3::new(value("ix"), value("iy"), value("iz")));
    let section = mass(value("mass"), &Vector3::zeros(), &inertia);
    for elements in [1, 2, 3, 4, 6, 8, 16] {
        let mut line = Line::straight(elements, value("length"), stiffness, section);
        for (consistent, kind) in [(false, "lobatto"), (true, "var")] {
            line.consistent = consistent;
            let (omega, growth) = line.at_rest();
            let case = format!("strip of {elements} elements, consistent {consistent}");
            record::largest("undamped", &case, "growth over frequency", growth, GROWTH);
            assert!(growth < GROWTH, "{case}: {growth:e}");
            let listed = &file["rows"][format!("{elements} elements var/{kind}")]["omega_first_8"];
            if listed.is_null() {
                continue;
            }
            for (found, expected) in omega.iter().zip(numbers(listed)) {
                let error = (found / expected - 1.0).abs();
                assert!(error < 1e-8, "{case}: {found} {expected}");
            }
        }
    }
}

/// Beams with bodies by Lobatto's rule: the section at each node times the length that the node
/// represents. On straight beams nodal weights are equal to them, on curved ones they differ: they
/// use the sections between the nodes.
fn lobatto(line: &Line, section: f64, moment: &Vector3<f64>, inertia: &Matrix3<f64>) -> Model {
    let slopes = [[-1.5, 2.0, -0.5], [-0.5, 0.0, 0.5], [0.5, -2.0, 1.5]];
    let weights = [1.0 / 3.0, 4.0 / 3.0, 1.0 / 3.0];
    let mut parts: Vec<Box<dyn Element>> = Vec::new();
    for (e, geometry) in line.geometries.iter().enumerate() {
        let on = [2 * e, 2 * e + 1, 2 * e + 2];
        let ends = on.map(|i| &line.nodes[i]);
        let stiffness = [line.stiffness; 2];
        let beam = Beam::elastic("beam", on, *geometry, ends, stiffness);
        parts.push(Box::new(beam));
        for (j, node) in on.into_iter().enumerate() {
            let along = ends
                .iter()
                .zip(slopes[j])
                .map(|(end, slope)| slope * end.position);
            let length = weights[j] * along.sum::<Vector3<f64>>().norm();
            let body = RigidInertia {
                mass: length * section,
                first_moment: length * moment,
                inertia: length * inertia,
            };
            parts.push(Box::new(RigidBody::new("mass", node, body)));
        }
    }
    line.model_of(parts, None)
}

/// Five general beams with all their frequencies: with consistent inertia, and with the bodies of
/// the reference, by Lobatto's rule.
#[test]
fn spectra_of_general_beams() {
    for case in reference("random_beams")["cases"].as_array().unwrap() {
        let positions = case["X"].as_array().unwrap();
        let node = |i: usize| Node {
            label: format!("n{i}"),
            position: vector(&case["X"][i]),
            rotation: matrix(&case["R"][i]),
        };
        let moment = vector(&case["first_moment"]);
        let mut line = Line {
            nodes: (0..positions.len()).map(node).collect(),
            geometries: vec![BeamGeometry::new([BeamNode::aligned(); 3]); positions.len() / 2],
            stiffness: stiffness(&case["stiffness"]),
            mass: mass(
                case["mass"].as_f64().unwrap(),
                &moment,
                &matrix(&case["inertia"]),
            ),
            consistent: false,
        };
        let check = |(omega, growth): (Vec<f64>, f64), key: &str, tolerance: f64| {
            assert!(growth < GROWTH, "{growth:e}");
            for (found, expected) in omega.iter().zip(numbers(&case[key])) {
                let error = (found / expected - 1.0).abs();
                assert!(error < tolerance, "{key}: {found} {expected}");
            }
        };
        let model = lobatto(
            &line,
            case["mass"].as_f64().unwrap(),
            &moment,
            &matrix(&case["inertia"]),
        );
        let found = line.spectrum(&model, &model.system.rest());
        check(found, "omega var/lobatto", 1e-8);
        // Nodal weights, by hat functions if they are not physical bodies: no mode grows.
        assert!(line.at_rest().1 < GROWTH);
        line.consistent = true;
        check(line.at_rest(), "omega var/var", 1e-8);
    }
}

/// Aluminum rectangles, 5 to 60 mm by 1 to 20 mm, slenderness 6 to 100, 2 to 11 elements.
#[test]
fn no_mode_of_random_aluminum_strips_grows() {
    let mut random = Random(1);
    for case in 0..cases(120) {
        let (b, h) = (random.between(5e-3, 0.06), random.between(1e-3, 0.02));
        let area = b * h;
        let [iy, iz] = [b * h.powi(3) / 12.0, h * b.powi(3) / 12.0];
        let long = b.max(h) / b.min(h);
        let torsion = 1.0 / 3.0 - 0.21 / long * (1.0 - (1.0 / long).powi(4) / 12.0);
        let gj = 2.7e10 * torsion * b.max(h) * b.min(h).powi(3);
        let shear = 2.7e10 * area * 5.0 / 6.0;
        let diagonal = Vector6::new(7e10 * area, shear, shear, gj, 7e10 * iy, 7e10 * iz);
        let inertia = Vector3::new(iy + iz, iy, iz) * 2700.0;
        let section = mass(
            2700.0 * area,
            &Vector3::zeros(),
            &Matrix3::from_diagonal(&inertia),
        );
        let elements = random.between(2.0, 12.0) as usize;
        let length = b.max(h) * random.between(6.0, 100.0);
        let stiffness = Matrix6::from_diagonal(&diagonal);
        both(
            Line::straight(elements, length, stiffness, section),
            &format!("strip {case}"),
        );
    }
}

/// Curved, twisted, with offsets, any symmetric positive 6x6 and any mass of a section.
fn general(random: &mut Random) -> Line {
    let elements = random.between(1.0, 4.0) as usize;
    let count = 2 * elements;
    let (curve, twist) = (random.vector(0.8), random.vector(0.5));
    let along = |part: f64| {
        let bend = Vector3::new(0.0, curve.y, curve.z) * (part * part);
        (
            Vector3::x() * part + 0.5 * bend,
            Rotation3::new(twist * part).into_inner(),
        )
    };
    let nodes: Vec<Node> = (0..=count)
        .map(|i| {
            let (position, axes) = along(i as f64 / count as f64);
            Node {
                label: format!("n{i}"),
                position: position + random.vector(0.02 / elements as f64),
                rotation: random.rotation(0.2) * axes,
            }
        })
        .collect();
    let attached: Vec<BeamNode> = nodes
        .iter()
        .map(|node| BeamNode {
            offset: random.vector(0.05),
            orientation: node.rotation.transpose() * random.rotation(0.1),
        })
        .collect();
    let geometry = |e: usize| BeamGeometry::new([0, 1, 2].map(|k| attached[2 * e + k]));
    let any = Matrix6::from_fn(|_, _| random.number());
    let scale = Matrix6::from_diagonal(&Vector6::new(20.0, 8.0, 10.0, 0.5, 0.6, 1.5));
    let (a, s) = (
        Matrix3::from_fn(|_, _| random.number()),
        random.vector(0.05),
    );
    let shift = Matrix3::from_diagonal_element(s.norm_squared()) - s * s.transpose();
    let inertia = 2e-3 * (a * a.transpose() + 0.3 * Matrix3::identity()) + shift;
    Line {
        geometries: (0..elements).map(geometry).collect(),
        nodes,
        stiffness: scale * (any * any.transpose() + Matrix6::identity()) * scale,
        mass: mass(1.0, &s, &inertia),
        consistent: false,
    }
}

#[test]
fn no_mode_of_random_curved_twisted_coupled_beams_grows() {
    let mut random = Random(2);
    for case in 0..cases(200) {
        both(general(&mut random), &format!("beam {case}"));
    }
}

/// Bent by dead forces at the tip; the tangent is symmetric to the residual of the balance, and no
/// mode grows.
#[test]
fn no_mode_of_loaded_beams_grows() {
    let mut random = Random(3);
    let mut bent = 0;
    for case in 0..cases(60) {
        let mut line = general(&mut random);
        let tip = line.stiffness.diagonal().rows(3, 3).min();
        let force = random.vector(0.8 * tip);
        let model = line.model(Some(force));
        let outcome = statics(&model, &up_to(1.0));
        assert!(outcome.failure.is_none(), "{case}: {:?}", outcome.failure);
        let last = outcome.result.last().unwrap();
        let mut state = model.system.rest();
        for (node, (position, rotation)) in state
            .nodes
            .iter_mut()
            .zip(last.positions.iter().zip(&last.rotations))
        {
            (node.position, node.rotation) = (*position, *rotation);
        }
        let end = line.nodes.len() - 1;
        bent += usize::from((last.positions[end] - line.nodes[end].position).norm() > 0.1);
        let [stiffness, _] = line.matrices(&model, &state);
        let asymmetry = (&stiffness - stiffness.transpose()).amax() / stiffness.amax();
        assert!(asymmetry < 1e-10, "{case}: {asymmetry:e}");
        for consistent in [false, true] {
            line.consistent = consistent;
            let (_, growth) = line.spectrum(&line.model(Some(force)), &state);
            assert!(
                growth < GROWTH,
                "{case}, consistent {consistent}: {growth:e}"
            );
        }
    }
    assert!(bent > 30, "{bent} of 60 bend by a tenth of their length");
}

//! Every element's Jacobian against central differences at random states.
//!
//! Step h = 1e-6 of unit-sized variables: truncation h^2 and round-off eps/h of terms of order one
//! (properties are chosen so) give about 1e-9 of the largest entry; 2e-8 allows for the third
//! derivatives.

use nalgebra::{Matrix3, Matrix6, SMatrix, SVector, Vector3, Vector6};
use shared_geom::rotation::parameters::Parametrization;
use shared_geom::rotation::{gibbs, vector};
use shared_geom::section::CubicTable;
use shared_geom::wrench;

use super::beams::{
    Beam, BeamGeometry, BeamInertia, BeamNode, DistributedLoad, Formulation, MassAlong,
};
use super::bodies::{NodeBalance, RigidBody, RigidInertia};
use super::joints::{Hinge, HingeSpring, clamped, partly_clamped, rigid_connection, samples};
use super::laws::{self, Cubic, Driven, Law, LawKind, Term};
use super::loads::{
    Between, ImposedMotion, InternalForce, LoadFactor, NodalForce, NodalLoad, Turning, imposed,
};
use super::springs::{
    End, Measure, Rod, Spring, SpringLaw, SupportFrame, SupportLaw, SupportSpring,
};
use super::{Element, Local, LocalJacobian, LocalResidual, LocalSize, Queries, Signal};
use crate::model::{Conditions, Drive, Loading, Node, NodeMotion, Scalars, TurningFrame, Variable};

mod control;
mod differences;
mod driven;
mod energies;
mod piezo;
mod readings;
mod sensing;
mod strips;

use differences::differences;

const STEP: f64 = 1e-6;
const TOLERANCE: f64 = 2e-8;

/// Deterministic numbers in [-1, 1].
pub(super) struct Random(u64);

impl Random {
    pub(super) fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(super) fn number(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    pub(super) fn vector(&mut self, size: f64) -> Vector3<f64> {
        size * Vector3::new(self.number(), self.number(), self.number())
    }

    pub(super) fn rotation(&mut self, size: f64) -> Matrix3<f64> {
        vector::to_rotation(&self.vector(size))
    }

    /// A symmetric positive definite 6x6 of unit size.
    pub(super) fn stiffness(&mut self) -> Matrix6<f64> {
        let a = Matrix6::from_fn(|_, _| self.number());
        a * a.transpose() + Matrix6::identity()
    }

    /// The mass of a section of unit size with its center off the reference.
    fn mass(&mut self) -> Matrix6<f64> {
        let inertia = Vector3::new(0.5, 0.2, 0.3);
        let mut central = Matrix6::identity();
        central
            .fixed_view_mut::<3, 3>(3, 3)
            .copy_from(&Matrix3::from_diagonal(&inertia));
        let turned = wrench::rotate(&central, &self.rotation(1.0));
        wrench::shift(&turned, &self.vector(0.3))
    }
}

/// Undeformed nodes near x = 0, 1, 2 with arbitrary attitudes.
pub(super) fn nodes(random: &mut Random, count: usize) -> Vec<Node> {
    (0..count)
        .map(|i| Node {
            label: format!("n{i}"),
            position: Vector3::new(i as f64, 0.0, 0.0) + random.vector(0.1),
            rotation: random.rotation(1.0),
        })
        .collect()
}

/// Undeformed nodes of a beam, which no rotation of [`moved`] turns by half a turn relative to each
/// other.
fn beam_nodes(random: &mut Random) -> Vec<Node> {
    let axes = random.rotation(2.0);
    let mut nodes = nodes(random, 3);
    for node in &mut nodes {
        node.rotation = random.rotation(0.4) * axes;
    }
    nodes
}

fn moved(random: &mut Random, node: &Node) -> NodeMotion {
    NodeMotion {
        position: node.position + random.vector(0.2),
        rotation: random.rotation(0.4) * node.rotation,
        momentum: random.vector(1.0),
        angular_momentum: random.vector(1.0),
        velocity: random.vector(1.0),
        angular_velocity: random.vector(1.0),
        momentum_rate: random.vector(1.0),
        angular_momentum_rate: random.vector(1.0),
    }
}

/// One variable of a node, varied by `step` along an axis.
fn vary(node: &mut NodeMotion, variable: Variable, axis: usize, step: f64) {
    let mut by = Vector3::zeros();
    by[axis] = step;
    match variable {
        Variable::Position => node.position += by,
        Variable::Rotation => node.rotation = gibbs::to_rotation(&by) * node.rotation,
        Variable::Momentum => node.momentum += by,
        Variable::AngularMomentum => node.angular_momentum += by,
        Variable::Velocity => node.velocity += by,
        Variable::AngularVelocity => node.angular_velocity += by,
        Variable::MomentumRate => node.momentum_rate += by,
        Variable::AngularMomentumRate => node.angular_momentum_rate += by,
    }
}

fn check(element: &dyn Element, undeformed: &[Node], random: &mut Random) {
    check_within(TOLERANCE, element, undeformed, random);
}

fn check_within(tolerance: f64, element: &dyn Element, undeformed: &[Node], random: &mut Random) {
    check_states(5, tolerance, element, undeformed, random);
}

/// Checks an element in some number of random states.
fn check_states(
    count: usize,
    tolerance: f64,
    element: &dyn Element,
    undeformed: &[Node],
    random: &mut Random,
) {
    for _ in 0..count {
        let motion: Vec<_> = undeformed.iter().map(|node| moved(random, node)).collect();
        let mut numbers = |count: usize| (0..count).map(|_| random.number()).collect();
        let multipliers: Vec<_> = numbers(element.multipliers());
        let count = element.scalars().len();
        let (scalars, scalar_rates) = (numbers(count), numbers(count));
        let memory = numbers(element.memory_size());
        let own = Own {
            multipliers,
            scalars,
            scalar_rates,
            memory,
        };
        let conditions = Conditions {
            frame: TurningFrame {
                angular_velocity: random.vector(1.0),
                center: random.vector(1.0),
            },
            loading: Loading {
                gravity: random.vector(1.0),
                constant: random.number(),
                proportional: random.number(),
                released: random.number(),
                resting: random.number(),
                time: random.number(),
                turns: 1.0,
                voltages: 1.0,
                air: 1.0,
            },
        };
        check_at(tolerance, element, &motion, &own, &conditions);
    }
}

/// Input of an element other than its nodes.
#[derive(Clone)]
struct Own {
    multipliers: Vec<f64>,
    scalars: Vec<f64>,
    scalar_rates: Vec<f64>,
    memory: Vec<f64>,
}

impl Own {
    fn seen<'a>(&'a self, nodes: &'a [NodeMotion], conditions: &'a Conditions) -> Local<'a> {
        Local {
            nodes,
            multipliers: &self.multipliers,
            scalars: Scalars {
                values: &self.scalars,
                rates: &self.scalar_rates,
            },
            memory: &self.memory,
            frame: &conditions.frame,
            loading: &conditions.loading,
        }
    }
}

fn check_at(
    tolerance: f64,
    element: &dyn Element,
    motion: &[NodeMotion],
    own: &Own,
    conditions: &Conditions,
) {
    let mut jacobian = LocalJacobian::new(LocalSize::of(element));
    element.jacobian(&own.seen(motion, conditions), &mut jacobian);
    let [by_unknowns, by_rates] = differences(element, motion, own, conditions);
    for (exact, difference) in [
        (jacobian.by_unknowns(), &by_unknowns),
        (jacobian.by_rates(), &by_rates),
    ] {
        let scale = exact.amax().max(1.0);
        let error = (exact - difference).amax() / scale;
        assert!(error < tolerance, "{}: {error:e}", element.label());
    }
    check_factor(element, motion, own, conditions);
    // Only entries of the declared pattern change.
    let sizes = by_unknowns.abs() + by_rates.abs();
    for (size, touched) in sizes.iter().zip(jacobian.touched()) {
        assert!(
            *touched || *size < TOLERANCE,
            "{}: {size:e}",
            element.label()
        );
    }
}

/// The derivative by the factor of the proportional loads, by central differences.
fn check_factor(element: &dyn Element, motion: &[NodeMotion], own: &Own, conditions: &Conditions) {
    let evaluate = |step: f64, derivative: bool| {
        let mut conditions = *conditions;
        conditions.loading.proportional += step;
        let at = own.seen(motion, &conditions);
        let mut out = LocalResidual::new(LocalSize::of(element));
        if derivative {
            element.by_factor(&at, &mut out)
        } else {
            element.residual(&at, &mut out)
        }
        nalgebra::DVector::from_column_slice(out.values())
    };
    let difference = (evaluate(STEP, false) - evaluate(-STEP, false)) / (2.0 * STEP);
    let exact = evaluate(0.0, true);
    let error = (&exact - difference).amax() / exact.amax().max(1.0);
    assert!(error < TOLERANCE, "{}: {error:e}", element.label());
}

/// Arbitrary attachments, in every formulation.
fn geometries(random: &mut Random) -> [BeamGeometry; 3] {
    let geometry = BeamGeometry::new(std::array::from_fn(|_| BeamNode {
        offset: random.vector(0.1),
        orientation: random.rotation(0.5),
    }));
    let volumes = [Parametrization::Gibbs, Parametrization::RotationVector];
    let volumes = volumes.map(|of| geometry.formulated(Formulation::FiniteVolume(of)));
    [geometry, volumes[0], volumes[1]]
}

#[test]
fn node_balance() {
    let mut random = Random(1);
    let nodes = nodes(&mut random, 1);
    check(&NodeBalance::new("balance", 0), &nodes, &mut random);
}

#[test]
fn rigid_body() {
    let mut random = Random(2);
    let nodes = nodes(&mut random, 1);
    let central = Matrix3::from_diagonal(&Vector3::new(0.5, 0.7, 0.9));
    let inertia = RigidInertia::about_node(1.3, &random.vector(0.5), &central);
    check(&RigidBody::new("body", 0, inertia), &nodes, &mut random);
}

#[test]
fn clamp() {
    let mut random = Random(3);
    let nodes = nodes(&mut random, 1);
    check(&clamped("clamp", 0, &nodes[0]), &nodes, &mut random);
}

#[test]
fn elastic_beam_with_offsets_and_turned_sections() {
    let mut random = Random(4);
    for _ in 0..4 {
        let nodes = beam_nodes(&mut random);
        let stiffness = [random.stiffness(), random.stiffness()];
        let undeformed = [&nodes[0], &nodes[1], &nodes[2]];
        for geometry in geometries(&mut random) {
            let beam = Beam::elastic("beam", [0, 1, 2], geometry, undeformed, stiffness);
            check(&beam, &nodes, &mut random);
        }
    }
}

#[test]
fn consistent_inertia_with_offsets_and_turned_sections() {
    let mut random = Random(5);
    for _ in 0..4 {
        let nodes = beam_nodes(&mut random);
        let [geometry, ..] = geometries(&mut random);
        let (root, tip) = (random.mass(), random.mass());
        let undeformed = [&nodes[0], &nodes[1], &nodes[2]];
        let mass = |xi: f64| 0.5 * (1.0 - xi) * root + 0.5 * (1.0 + xi) * tip;
        let mass = MassAlong::smooth(&mass);
        let inertia = BeamInertia::new("inertia", [0, 1, 2], geometry, undeformed, &mass);
        check(&inertia, &nodes, &mut random);
    }
}

#[test]
fn partial_clamps() {
    let mut random = Random(6);
    let nodes = nodes(&mut random, 1);
    for bits in 0..64_u32 {
        let held = std::array::from_fn(|i| bits >> i & 1 == 1);
        let axes = random.rotation(1.0);
        let clamp = partly_clamped("clamp", 0, &nodes[0], &axes, held);
        assert_eq!(clamp.multipliers() as u32, bits.count_ones());
        check(&clamp, &nodes, &mut random);
    }
}

#[test]
fn rigid_connections() {
    let mut random = Random(7);
    let nodes = nodes(&mut random, 2);
    let rigid = rigid_connection("rigid", [0, 1], [&nodes[0], &nodes[1]]);
    check(&rigid, &nodes, &mut random);
}

#[test]
fn hinge_with_offsets_spring_and_damper() {
    let mut random = Random(8);
    for (stiffness, damping) in [(0.0, 0.0), (1.3, 0.0), (0.0, 0.7), (1.3, 0.7)] {
        let nodes = nodes(&mut random, 2);
        let (position, axis) = (random.vector(1.0), random.vector(1.0));
        let spring = HingeSpring {
            stiffness,
            damping,
            angle: 0.3,
        };
        let undeformed = [&nodes[0], &nodes[1]];
        let hinge = Hinge::new("hinge", [0, 1], undeformed, &position, &axis, spring);
        check(&hinge, &nodes, &mut random);
        let driven = hinge.relaxed_by(samples::drive(0.3));
        check(&driven, &nodes, &mut random);
    }
}

#[test]
fn supports_that_turn_with_the_frame_and_that_are_in_the_world() {
    let mut random = Random(9);
    let nodes = nodes(&mut random, 1);
    let spring = [1.0, 2.0, 3.0, 0.5, 0.7, 0.9];
    for damping in [[0.0; 6], [0.4, 0.3, 0.2, 0.6, 0.5, 0.1]] {
        let law = SupportLaw::along(&random.rotation(1.0), &spring, &damping);
        for support_frame in [SupportFrame::Frame, SupportFrame::World] {
            let support = SupportSpring::new("support", 0, &nodes[0], law, support_frame);
            check(&support, &nodes, &mut random);
        }
    }
}

#[test]
fn viscous_beam_with_offsets_and_turned_sections() {
    let mut random = Random(10);
    for _ in 0..4 {
        let nodes = beam_nodes(&mut random);
        let damping = [random.stiffness(), random.stiffness()];
        let undeformed = [&nodes[0], &nodes[1], &nodes[2]];
        for geometry in geometries(&mut random) {
            let laws = damping.map(|viscosity| LawKind::Viscous { viscosity }.into());
            let beam = Beam::new("beam", [0, 1, 2], geometry, undeformed, laws);
            check(&beam, &nodes, &mut random);
        }
    }
}

/// Dead and follower loads, constant and proportional.
fn kinds() -> [(Turning, LoadFactor); 3] {
    [
        (Turning::Dead, LoadFactor::Proportional),
        (Turning::Follower, LoadFactor::Proportional),
        (Turning::Follower, LoadFactor::Constant),
    ]
}

#[test]
fn loads_on_nodes() {
    let mut random = Random(6);
    let nodes = nodes(&mut random, 1);
    for (turning, factor) in kinds() {
        let load = NodalForce {
            force: random.vector(1.0),
            moment: random.vector(1.0),
            offset: random.vector(0.5),
            turning,
            factor,
        };
        check(
            &NodalLoad::new("load", 0, &nodes[0], load),
            &nodes,
            &mut random,
        );
    }
}

#[test]
fn loads_along_beams_with_offsets_and_turned_sections() {
    let mut random = Random(7);
    for (turning, factor) in kinds() {
        let nodes = beam_nodes(&mut random);
        let undeformed = [&nodes[0], &nodes[1], &nodes[2]];
        let [a, b, c, d] = [(); 4].map(|()| random.vector(1.0));
        let load = |xi: f64| [a + b * xi, c + d * (xi - 0.2).max(0.0)];
        let kind = (turning, factor);
        for geometry in geometries(&mut random) {
            let load =
                DistributedLoad::new("load", [0, 1, 2], geometry, undeformed, kind, &[0.2], load);
            check(&load, &nodes, &mut random);
        }
    }
}

#[test]
fn imposed_motions_of_any_components() {
    let mut random = Random(8);
    let nodes = nodes(&mut random, 1);
    for mask in 1..64_u32 {
        let mut some = |i: u32| (mask >> i & 1 == 1).then(|| random.number());
        let motion = ImposedMotion {
            displacement: [some(0), some(1), some(2)],
            rotation: [some(3), some(4), some(5)],
            axes: random.rotation(1.0),
            factor: LoadFactor::Proportional,
        };
        let imposed = imposed("imposed", 0, &nodes[0], motion);
        assert_eq!(imposed.multipliers(), mask.count_ones() as usize);
        check(&imposed, &nodes, &mut random);
    }
}

/// Elastic, and so that nothing cancels: cubic and viscous, unsymmetric.
fn laws<const N: usize>(random: &mut Random) -> [Law<N>; 2] {
    let cubic = LawKind::Cubic(std::array::from_fn(|i| Cubic {
        first: 1.0 + 0.1 * i as f64,
        second: 0.2,
        third: 0.3,
    }));
    let viscosity = SMatrix::from_fn(|_, _| random.number());
    let sum = vec![cubic.clone().into(), LawKind::Viscous { viscosity }.into()];
    [cubic.into(), Law::sum(sum)]
}

fn by_time(mean: f64) -> Signal {
    samples::drive(mean).into()
}

/// Cubic and viscous, with a prestrain and a prestress that move.
fn driven_law<const N: usize>(random: &mut Random, drive: fn(f64) -> Signal) -> Law<N> {
    let mut driven = || {
        Some(Driven {
            vector: SVector::from_fn(|_, _| 0.5 * random.number()),
            signal: drive(0.3),
        })
    };
    let cubic = Cubic {
        first: 1.1,
        second: 0.2,
        third: 0.3,
    };
    let viscous = LawKind::Viscous {
        viscosity: SMatrix::from_fn(|i, j| if i == j { 0.8 } else { -0.3 }),
    };
    let terms = [LawKind::Cubic([cubic; N]), viscous].map(|kind| Term {
        kind,
        prestrain: driven(),
        prestress: driven(),
    });
    Law::sum(terms.into())
}

#[test]
fn rods_between_nodes_and_from_the_frame() {
    let mut random = Random(11);
    let nodes = nodes(&mut random, 2);
    let end = |node: usize, random: &mut Random| End::Node {
        node,
        offset: random.vector(0.3),
    };
    let position = nodes[0].position + Vector3::new(0.0, 1.0, 0.2);
    let [elastic, viscous] = laws(&mut random);
    for (law, measure) in [
        (elastic, Measure::Strain),
        (viscous, Measure::Elongation),
        (driven_law(&mut random, by_time), Measure::Strain),
        (driven_law(&mut random, by_time), Measure::Elongation),
    ] {
        let law = || (measure, law.clone());
        let between = [end(0, &mut random), end(1, &mut random)];
        for relaxed in [Drive::Constant(0.8), samples::drive(0.8)] {
            let rod = Rod::new("rod", between, &nodes, Some(relaxed.into()), law());
            check(&rod, &nodes, &mut random);
        }
        let frame = End::Frame { position };
        for ends in [[frame, end(0, &mut random)], [end(0, &mut random), frame]] {
            let rod = Rod::new("rod to the frame", ends, &nodes, None, law());
            check(&rod, &nodes[..1], &mut random);
        }
    }
}

#[test]
fn springs_between_nodes_and_from_the_frame() {
    let mut random = Random(12);
    let nodes = nodes(&mut random, 2);
    let three = laws::<3>(&mut random);
    let together = laws::<6>(&mut random).map(SpringLaw::Together);
    let along = three.clone().map(SpringLaw::of_displacement);
    let about = three.clone().map(SpringLaw::of_rotation);
    let [displacement, rotation] = three.map(Some);
    let apart = SpringLaw::Apart {
        displacement,
        rotation,
    };
    let driven = [
        SpringLaw::Together(driven_law(&mut random, by_time)),
        SpringLaw::Apart {
            displacement: Some(driven_law(&mut random, by_time)),
            rotation: Some(driven_law(&mut random, by_time)),
        },
    ];
    let all = together
        .into_iter()
        .chain(along)
        .chain(about)
        .chain([apart])
        .chain(driven);
    for law in all {
        let (position, axes) = (random.vector(1.0), random.rotation(1.0));
        for on in [&[0, 1][..], &[0]] {
            let spring = Spring::new("spring", (on, &nodes), &position, &axes, law.clone());
            check(&spring, &nodes[..on.len()], &mut random);
        }
    }
}

#[test]
fn beams_of_any_law_with_offsets_and_turned_sections() {
    let mut random = Random(13);
    let [elastic, viscous] = laws(&mut random);
    for law in [elastic, viscous, driven_law(&mut random, by_time)] {
        let nodes = beam_nodes(&mut random);
        let undeformed = [&nodes[0], &nodes[1], &nodes[2]];
        let stiff = Law::linear(random.stiffness());
        for geometry in geometries(&mut random) {
            let laws = [law.clone(), stiff.clone()];
            let beam = Beam::new("beam", [0, 1, 2], geometry, undeformed, laws);
            check(&beam, &nodes, &mut random);
        }
    }
}

/// `K psi + 1/2 T q q + sum c_i T_i q`, T of unit size in the components that exist for a section,
/// under two states, and a viscosity.
fn prestressed_law(random: &mut Random, drive: fn(f64) -> Signal) -> Law<6> {
    let table = CubicTable::from_fn(|_| random.number());
    let mut state = |signal: Signal| laws::Imposed {
        free_strain: Vector6::from_fn(|_, _| 0.2 * random.number()),
        change: 0.1 * random.stiffness(),
        signal,
    };
    let imposed = vec![state(drive(0.7)), state(drive(-1.3))];
    Law::sum(vec![
        LawKind::Viscoelastic {
            stiffness: random.stiffness(),
            viscosity: random.stiffness(),
        }
        .into(),
        LawKind::quadratic(&table, imposed).into(),
    ])
}

#[test]
fn beams_of_prestressed_sections() {
    let mut random = Random(21);
    for _ in 0..3 {
        let nodes = beam_nodes(&mut random);
        let [geometry, ..] = geometries(&mut random);
        let undeformed = [&nodes[0], &nodes[1], &nodes[2]];
        let laws =
            [(); 2].map(|()| prestressed_law(&mut random, |value| Drive::Constant(value).into()));
        let beam = Beam::new("beam", [0, 1, 2], geometry, undeformed, laws);
        check(&beam, &nodes, &mut random);
    }
}

#[test]
fn forces_between_nodes() {
    let mut random = Random(14);
    let nodes = nodes(&mut random, 3);
    let offset = random.vector(0.3);
    let line = Between::Line {
        ends: [0, 1].map(|node| End::Node { node, offset }),
        tension: 1.3,
    };
    let axes = Between::Axes {
        nodes: [0, 1],
        offset,
        force: random.vector(1.0),
        moment: random.vector(1.0),
    };
    for between in [line, axes] {
        for factor in [LoadFactor::Constant, LoadFactor::Proportional] {
            let between = between.clone();
            let signal = sensing::sensing();
            let force = InternalForce::new("force", &nodes, between, factor, signal);
            check(&force, &nodes[..2], &mut random);
        }
    }
}

#[test]
fn joints_of_every_kind() {
    let mut random = Random(12);
    let nodes = nodes(&mut random, 2);
    for setting in &samples::settings(&nodes, || random.vector(1.0)) {
        let count = 1 + usize::from(setting.ends.a.is_some());
        for joint in samples::all(setting) {
            check(&joint, &nodes[..count], &mut Random(13));
        }
    }
}

#[test]
fn imposed_motions_times_a_drive() {
    let mut random = Random(14);
    let nodes = nodes(&mut random, 1);
    let motion = ImposedMotion {
        displacement: [Some(0.3), None, Some(-0.2)],
        rotation: [Some(0.5), Some(-0.4), None],
        axes: random.rotation(1.0),
        factor: LoadFactor::Proportional,
    };
    let imposed = imposed("imposed", 0, &nodes[0], motion);
    let imposed = imposed.scaled_by(samples::drive(0.8));
    check(&imposed, &nodes, &mut random);
}

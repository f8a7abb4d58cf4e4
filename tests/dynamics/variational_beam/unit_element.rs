//! One general element: offsets, turned sections, full stiffness, large rotations.

use beam_dynamics::elements::Queries;
use beam_dynamics::elements::beams::{
    Beam, BeamGeometry, BeamInertia, BeamNode, Formulation, MassAlong,
};
use beam_dynamics::elements::laws::{Law, LawKind};
use beam_dynamics::elements::{Element, Local, LocalJacobian, LocalResidual, LocalSize};
use beam_dynamics::model::{
    Conditions, Equation, NODE_UNKNOWNS, Node, NodeMotion, Scalars, Variable,
};
use nalgebra::{DMatrix, DVector, Matrix3, Matrix6, Vector3};
use serde_json::Value;
use shared_geom::rotation::parameters::Parametrization;
use shared_geom::rotation::skew;

use super::{mass, matrix, numbers, reference, stiffness, vector};
use crate::record;

const SOURCE: &str = "second program from the equations, unit_element.json";
/// The reference requires 1e-12 relative.
const TOLERANCE: f64 = 1e-12;

struct Unit {
    file: Value,
    nodes: Vec<Node>,
    geometry: BeamGeometry,
    motion: Vec<NodeMotion>,
}

impl Unit {
    fn new() -> Self {
        let file = reference("unit_element");
        let nodes: Vec<_> = (0..3)
            .map(|j| Node {
                label: format!("n{j}"),
                position: vector(&file["X"][j]),
                rotation: matrix(&file["R_nodes_reference"][j]),
            })
            .collect();
        let geometry = BeamGeometry::new(std::array::from_fn(|j| BeamNode {
            offset: vector(&file["offset_local"][j]),
            orientation: matrix(&file["section_in_node"][j]),
        }));
        let velocity = numbers(&file["velocity"]);
        let part = |first: usize| Vector3::from_column_slice(&velocity[first..first + 3]);
        let motion = (0..3).map(|j| NodeMotion {
            position: vector(&file["x"][j]),
            rotation: matrix(&file["R"][j]),
            velocity: part(6 * j),
            angular_velocity: part(6 * j + 3),
            ..NodeMotion::at_rest(&nodes[j])
        });
        Self {
            motion: motion.collect(),
            file,
            nodes,
            geometry,
        }
    }

    fn ends(&self) -> [&Node; 3] {
        [&self.nodes[0], &self.nodes[1], &self.nodes[2]]
    }

    fn stiffness(&self) -> [Matrix6<f64>; 2] {
        [0, 1].map(|point| stiffness(&self.file["stiffness"][point]))
    }

    fn beam(&self, formulation: Formulation) -> Beam {
        let geometry = self.geometry.formulated(formulation);
        Beam::elastic("beam", [0, 1, 2], geometry, self.ends(), self.stiffness())
    }
}

fn with_local<T>(motion: &[NodeMotion], user: impl FnOnce(&Local<'_>) -> T) -> T {
    let conditions = Conditions::at_rest();
    user(&Local {
        nodes: motion,
        multipliers: &[],
        scalars: Scalars::NONE,
        memory: &[],
        frame: &conditions.frame,
        loading: &conditions.loading,
    })
}

/// Two vector equations of each node.
fn residual(element: &dyn Element, motion: &[NodeMotion], rows: [Equation; 2]) -> DVector<f64> {
    let mut out = LocalResidual::new(LocalSize::without_scalars(3, 0));
    with_local(motion, |at| element.residual(at, &mut out));
    let pick = |i: usize| out.of(i / 6, rows[i % 6 / 3])[i % 3];
    DVector::from_fn(18, |i, _| pick(i))
}

/// Derivatives of two vector equations of each node by two variables.
fn jacobian(
    element: &dyn Element,
    motion: &[NodeMotion],
    rows: [Equation; 2],
    columns: [Variable; 2],
) -> DMatrix<f64> {
    let mut out = LocalJacobian::new(LocalSize::without_scalars(3, 0));
    with_local(motion, |at| element.jacobian(at, &mut out));
    let matrix = if columns[0].is_rate() {
        out.by_rates()
    } else {
        out.by_unknowns()
    };
    let row = |i: usize| NODE_UNKNOWNS * (i / 6) + rows[i % 6 / 3].row() + i % 3;
    let column = |j: usize| NODE_UNKNOWNS * (j / 6) + columns[j % 6 / 3].column() + j % 3;
    DMatrix::from_fn(18, 18, |i, j| matrix[(row(i), column(j))])
}

const FORCES: [Equation; 2] = [Equation::Force, Equation::Moment];
const MOMENTA: [Equation; 2] = [Equation::Momentum, Equation::AngularMomentum];
const DISPLACEMENTS: [Variable; 2] = [Variable::Position, Variable::Rotation];
const VELOCITIES: [Variable; 2] = [Variable::Velocity, Variable::AngularVelocity];

fn check(quantity: &str, found: &[f64], expected: &Value) {
    let expected = numbers(expected);
    assert_eq!(found.len(), expected.len(), "{quantity}");
    let size = expected
        .iter()
        .fold(0.0_f64, |sum, value| sum.max(value.abs()));
    let pairs = found.iter().zip(&expected);
    let error = pairs.fold(0.0_f64, |sum, (a, b)| sum.max((a - b).abs())) / size;
    record::largest(SOURCE, "general element", quantity, error, TOLERANCE);
    assert!(error < TOLERANCE, "{quantity}: {error:e}");
}

#[test]
fn strains_and_their_rates() {
    let unit = Unit::new();
    let beam = unit.beam(Formulation::Variational);
    let concat = |of: [nalgebra::Vector6<f64>; 2]| [of[0].as_slice(), of[1].as_slice()].concat();
    check(
        "strain",
        &concat(beam.strains(&unit.motion)),
        &unit.file["strain"],
    );
    let rates = concat(beam.strain_rates(&unit.motion));
    check("strain rate", &rates, &unit.file["strain_rate"]);
    let forces = with_local(&unit.motion, |at| beam.internal_forces(at));
    check(
        "section force",
        &concat(forces),
        &unit.file["section_force"],
    );
}

#[test]
fn forces_of_every_formulation() {
    let unit = Unit::new();
    for (key, formulation) in [
        ("gradient", Formulation::Variational),
        (
            "gradient_finite_volume_log",
            Formulation::FiniteVolume(Parametrization::RotationVector),
        ),
        (
            "gradient_finite_volume_gibbs",
            Formulation::FiniteVolume(Parametrization::Gibbs),
        ),
    ] {
        let found = -residual(&unit.beam(formulation), &unit.motion, FORCES);
        check(key, found.as_slice(), &unit.file[key]);
    }
}

/// The tangent to round-off; and its skew part, which follows from the moments at the nodes.
#[test]
fn tangent_and_its_symmetry() {
    let unit = Unit::new();
    let beam = unit.beam(Formulation::Variational);
    let tangent = -jacobian(&beam, &unit.motion, FORCES, DISPLACEMENTS);
    check(
        "tangent",
        tangent.transpose().as_slice(),
        &unit.file["tangent"],
    );
    let gradient = -residual(&beam, &unit.motion, FORCES);
    let mut skew_part = &tangent - tangent.transpose();
    for j in 0..3 {
        let moment = gradient.fixed_rows::<3>(6 * j + 3).into_owned();
        let mut block = skew_part.fixed_view_mut::<3, 3>(6 * j + 3, 6 * j + 3);
        block += skew(&moment);
    }
    let error = skew_part.amax() / tangent.amax();
    record::largest(SOURCE, "general element", "H - H^T + [m_j]x", error, 1e-13);
    assert!(error < 1e-13, "{error:e}");
}

#[test]
fn consistent_inertia() {
    let unit = Unit::new();
    let file = &unit.file["inertia_consistent"];
    let moment = vector(&file["first_moment"]);
    let section = mass(
        file["mass"].as_f64().unwrap(),
        &moment,
        &matrix(&file["inertia"]),
    );
    let along = |_| section;
    let along = MassAlong::smooth(&along);
    let inertia = BeamInertia::new("mass", [0, 1, 2], unit.geometry, unit.ends(), &along);
    let momenta = -residual(&inertia, &unit.motion, MOMENTA);
    check("momenta", momenta.as_slice(), &file["momenta"]);
    let moments = residual(&inertia, &unit.motion, FORCES);
    let z: Vec<f64> = (0..3)
        .flat_map(|j| moments.as_slice()[6 * j + 3..6 * j + 6].to_vec())
        .collect();
    check("z", &z, &file["z"]);
    let matrix = -jacobian(&inertia, &unit.motion, MOMENTA, VELOCITIES);
    check("mass", matrix.transpose().as_slice(), &file["mass_matrix"]);
    let kinetic = with_local(&unit.motion, |at| inertia.energy(at)).kinetic;
    check("kinetic energy", &[kinetic], &file["kinetic"]);
}

/// The element numbered from its other end: section axes turned by half a turn about z,
/// and with them the stiffness. Rounding of products of order ten.
#[test]
fn a_reversed_element_has_the_same_forces() {
    let unit = Unit::new();
    let back = Matrix3::from_diagonal(&Vector3::new(-1.0, -1.0, 1.0));
    let mut both = Matrix6::zeros();
    both.fixed_view_mut::<3, 3>(0, 0).copy_from(&back);
    both.fixed_view_mut::<3, 3>(3, 3).copy_from(&back);
    let attached = unit.geometry.nodes;
    let geometry = BeamGeometry::new([2, 1, 0].map(|j| BeamNode {
        offset: attached[j].offset,
        orientation: attached[j].orientation * back,
    }));
    let [first, second] = unit.stiffness().map(|k| both * k * both);
    let [a, b, c] = unit.ends();
    let reversed = Beam::elastic("beam", [2, 1, 0], geometry, [c, b, a], [second, first]);
    let motion: Vec<_> = unit.motion.iter().rev().copied().collect();
    let expected = residual(&unit.beam(Formulation::Variational), &unit.motion, FORCES);
    let found = residual(&reversed, &motion, FORCES);
    for j in 0..3 {
        let difference = found.rows(6 * j, 6) - expected.rows(6 * (2 - j), 6);
        assert!(
            difference.amax() < 1e-13 * expected.amax() * 10.0,
            "{difference}"
        );
    }
}

/// Of the viscous power, `eps.' D eps.` for any symmetric positive D: none of 200 random ones
/// supplies energy. The same for each velocity of the nodes.
#[test]
fn viscous_forces_dissipate_for_any_viscosity() {
    let unit = Unit::new();
    let mut random = super::spectra::Random(71);
    for _ in 0..200 {
        let any = Matrix6::from_fn(|_, _| random.number());
        let viscosity = any * any.transpose();
        let laws: [Law<6>; 2] = [(); 2].map(|()| LawKind::Viscous { viscosity }.into());
        let beam = Beam::new("beam", [0, 1, 2], unit.geometry, unit.ends(), laws);
        let by_rates = -jacobian(&beam, &unit.motion, FORCES, VELOCITIES);
        let symmetric = 0.5 * (&by_rates + by_rates.transpose());
        let asymmetry = (&by_rates - by_rates.transpose()).amax() / by_rates.amax();
        let least = symmetric.symmetric_eigenvalues().min() / by_rates.amax();
        assert!(asymmetry < 1e-14, "{asymmetry:e}");
        assert!(least > -1e-14, "{least:e}");
    }
}

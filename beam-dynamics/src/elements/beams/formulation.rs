//! The two formulations of the three-node beam, each with its test functions.
//!
//! With the section force `q = [F~; M~]` at the evaluation points and W, the strains that
//! the test motion of each formulation makes there, the forces on the nodes are
//!
//! ```text
//! force_j = - sum_points W_j^T q                                             (D-20)
//! ```
//!
//! | formulation | W | bodies | loads |
//! | --- | --- | --- | --- |
//! | variational | J0 B: the variation of the strain | nodal weights N_j | work-equivalent |
//! | finite volume | balance of portions between the points | of portions | resultants on portions |
//!
//! The variational forces are the gradient of the energy `sum J0 W(eps)`, so that the
//! tangent at an equilibrium is symmetric and undamped motion keeps its energy. The
//! finite volumes are those of [Masarati]; their tangent is not symmetric even at rest, and
//! undamped modes that have few elements to a wave can grow. Forces, bodies and loads
//! of the two must not be mixed: each set is consistent in itself.
//!
//! Tangents are `- W^T dq` and the geometric part, by W at fixed forces.

use nalgebra::{Matrix3, SMatrix, Vector3, Vector6};
use shared_geom::rotation::parameters::Parametrization;

use super::strain::{SectionPoint, StrainPoint, Variation};
use super::{portions, variational};
use crate::elements::{LocalJacobian, LocalResidual};
use crate::model::Equation;
use crate::model::Equation::{Force, Moment};
use crate::model::Variable;

/// How the forces of a beam on its nodes follow from those in its sections.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Formulation {
    /// Gradient of the energy, with rotation vectors.
    #[default]
    Variational,
    /// Balance of finite volumes, with the given parameters of rotation.
    FiniteVolume(Parametrization),
}

/// Six equations of each node, by a matrix of columns.
pub(super) type Test = SMatrix<f64, 6, 18>;

/// A force and a moment on the line of a beam, with their variations by the rotations of
/// the nodes, model axes [N, N m].
pub(super) struct LineForce {
    pub force: Vector3<f64>,
    pub moment: Vector3<f64>,
    pub by_rotation: Option<[[Matrix3<f64>; 3]; 2]>,
}

impl Formulation {
    /// How it interpolates rotations.
    pub fn parametrization(self) -> Parametrization {
        match self {
            Self::Variational => Parametrization::RotationVector,
            Self::FiniteVolume(parametrization) => parametrization,
        }
    }

    /// W of the evaluation point number `place`: six strains by displacement and rotation of
    /// each node.
    pub(super) fn test(self, place: usize, at: &StrainPoint<'_>) -> Test {
        match self {
            Self::Variational => at.j0() * at.variation,
            Self::FiniteVolume(_) => portions::test(place, &at.section),
        }
    }

    /// Adds the geometric tangent of the section force `q` at an evaluation point.
    pub(super) fn add_geometric(
        self,
        place: usize,
        at: &StrainPoint<'_>,
        q: &Vector6<f64>,
        out: &mut LocalJacobian,
    ) {
        let [force, moment] = [0, 3].map(|row| q.fixed_rows::<3>(row).into_owned());
        let section = &at.section;
        match self {
            Self::Variational => variational::add_geometric(section, &force, &moment, out),
            Self::FiniteVolume(_) => {
                portions::add_geometric(place, section, &force, &moment, out);
            }
        }
    }

    /// Adds a force and a moment on the line at a point of portion `portion`: `add` takes
    /// what acts on the nodes.
    pub(super) fn add_on_line(
        self,
        portion: usize,
        at: &SectionPoint<'_>,
        load: &LineForce,
        add: impl FnMut(usize, Equation, &Vector3<f64>),
    ) {
        match self {
            Self::Variational => variational::add_on_line(at, load, add),
            Self::FiniteVolume(_) => portions::add_on_line(portion, at, load, add),
        }
    }

    /// Adds the variation of what [`Self::add_on_line`] adds.
    pub(super) fn add_on_line_variation(
        self,
        portion: usize,
        at: &SectionPoint<'_>,
        load: &LineForce,
        out: &mut LocalJacobian,
    ) {
        match self {
            Self::Variational => variational::add_on_line_variation(at, load, out),
            Self::FiniteVolume(_) => portions::add_on_line_variation(portion, at, load, out),
        }
    }
}

/// Adds the forces on the nodes of the section force `q`, by terms of force and of moment.
pub(super) fn add_forces(test: &Test, q: &Vector6<f64>, out: &mut LocalResidual) {
    let parts = [0, 3].map(|row| {
        let rows = test.fixed_rows::<3>(row);
        -rows.tr_mul(&q.fixed_rows::<3>(row))
    });
    for node in 0..3 {
        let of = |part: &SMatrix<f64, 18, 1>, row: usize| {
            part.fixed_rows::<3>(6 * node + row).into_owned()
        };
        out.add(node, Force, &of(&parts[0], 0));
        out.add(node, Moment, &of(&parts[0], 3));
        out.add(node, Moment, &of(&parts[1], 3));
    }
}

/// Adds `- W^T by`, the variation of the forces on the nodes with that of the section force
/// by displacements and rotations, or by their rates.
pub(super) fn add_tangent(test: &Test, by: &Variation, rates: bool, out: &mut LocalJacobian) {
    let variables = match rates {
        true => [Variable::Velocity, Variable::AngularVelocity],
        false => [Variable::Position, Variable::Rotation],
    };
    let product = test.tr_mul(by);
    for (node, row) in (0..3)
        .flat_map(|node| [(node, Force), (node, Moment)])
        .enumerate()
    {
        for (other, variable) in (0..3).flat_map(|k| variables.map(|v| (k, v))).enumerate() {
            let block: Matrix3<f64> = -product.fixed_view::<3, 3>(3 * node, 3 * other);
            out.add(row, variable, &block);
        }
    }
}

/// Adds the variation of the forces on the nodes by a scalar, or its rate, that makes the
/// section force `q` for each unit.
pub(super) fn add_column(
    test: &Test,
    q: &Vector6<f64>,
    column: (usize, bool),
    out: &mut LocalJacobian,
) {
    let forces = -test.tr_mul(q);
    for node in 0..3 {
        for (row, equation) in [(0, Force), (3, Moment)] {
            let force = forces.fixed_rows::<3>(6 * node + row).into_owned();
            out.add_by_scalar((node, equation), column, &force);
        }
    }
}

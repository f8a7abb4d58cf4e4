//! The functions of which laws consist.
//!
//! ```text
//! linear          f = K e                     energy  1/2 e . K e
//! viscous         f = D e'                            none
//! viscoelastic    f = K e + D e'                      1/2 e . K e       (Kelvin, Voigt)
//! quadratic       f_i = 1/2 T_ijk e_j e_k             1/6 T_ijk e_i e_j e_k    see [`Quadratic`]
//! ```
//!
//! and for each component independently
//!
//! ```text
//! cubic           f = k_1 e + k_2 |e| e + k_3 e^3     1/2 k_1 e^2 + 1/3 k_2 |e|^3 + 1/4 k_3 e^4
//! bilinear        see [`Bilinear`]
//! tabulated       f = T(e)                            int_0^e T
//! ```
//!
//! An expression gives each component by all strains, their rates and the time; it has no
//! energy here.

use nalgebra::{SMatrix, SVector};
use shared_geom::section::{CubicTable, PRESTRESS_COMPONENTS};

use super::{Bilinear, Cubic, Curve, ExpressionLaw, Imposed, Quadratic, Response};
use crate::elements::Instant;

/// A function of strain and rate of strain.
#[derive(Debug, Clone, PartialEq)]
pub enum LawKind<const N: usize> {
    /// Force proportional to the strain.
    Linear {
        /// Symmetric stiffness [unit of force / unit of strain].
        stiffness: SMatrix<f64, N, N>,
    },
    /// Force proportional to the rate of strain.
    Viscous {
        /// Viscosity [unit of force s / unit of strain].
        viscosity: SMatrix<f64, N, N>,
    },
    /// Both.
    Viscoelastic {
        /// Symmetric stiffness [unit of force / unit of strain].
        stiffness: SMatrix<f64, N, N>,
        /// Viscosity [unit of force s / unit of strain].
        viscosity: SMatrix<f64, N, N>,
    },
    /// The quadratic force of a cubic energy.
    Quadratic(Quadratic<N>),
    /// A polynomial of each component.
    Cubic([Cubic; N]),
    /// Two slopes of each component.
    Bilinear([Bilinear; N]),
    /// A table of each component; a component without one has no force.
    Table([Option<Curve>; N]),
    /// An expression for each component.
    Expression(ExpressionLaw<N>),
}

impl<const N: usize> LawKind<N> {
    /// Adds force and derivatives.
    pub(super) fn add(
        &self,
        strain: &SVector<f64, N>,
        rate: &SVector<f64, N>,
        now: &Instant<'_>,
        out: &mut Response<N>,
    ) {
        match self {
            Self::Linear { stiffness } => {
                out.force += stiffness * strain;
                out.by_strain += stiffness;
            }
            Self::Viscous { viscosity } => {
                out.force += viscosity * rate;
                out.by_rate += viscosity;
            }
            Self::Viscoelastic {
                stiffness,
                viscosity,
            } => {
                out.force += stiffness * strain + viscosity * rate;
                out.by_strain += stiffness;
                out.by_rate += viscosity;
            }
            Self::Quadratic(law) => law.add(strain, now, out),
            Self::Cubic(of) => add_each(strain, out, |i, e| of[i].at(e)),
            Self::Bilinear(of) => add_each(strain, out, |i, e| of[i].at(e)),
            Self::Table(of) => add_each(strain, out, |i, e| match &of[i] {
                Some(curve) => curve.at(e),
                None => (0.0, 0.0),
            }),
            Self::Expression(law) => law.add(strain, rate, now.time, out),
        }
    }

    /// Elastic energy at an instant; zero for functions without one.
    pub(super) fn energy(&self, strain: &SVector<f64, N>, now: &Instant<'_>) -> f64 {
        let sum = |of: &dyn Fn(usize, f64) -> f64| (0..N).map(|i| of(i, strain[i])).sum();
        match self {
            Self::Linear { stiffness } | Self::Viscoelastic { stiffness, .. } => {
                0.5 * strain.dot(&(stiffness * strain))
            }
            Self::Viscous { .. } | Self::Expression(_) => 0.0,
            Self::Quadratic(law) => law.energy(strain, now),
            Self::Cubic(of) => sum(&|i, e| of[i].energy(e)),
            Self::Bilinear(of) => sum(&|i, e| of[i].energy(e)),
            Self::Table(of) => sum(&|i, e| of[i].as_ref().map_or(0.0, |curve| curve.integral(e))),
        }
    }

    /// Growth of the stiffness with a growth of the strain, of the quadratic force. It is unknown
    /// for the other functions, since their stiffness may jump.
    pub(super) fn add_growth(&self, growth: &SVector<f64, N>, out: &mut SMatrix<f64, N, N>) {
        if let Self::Quadratic(law) = self {
            *out += law.by_strain(growth);
        }
    }

    /// Whether the force may have a kink or a jump: by two slopes, a table, or an expression.
    pub(super) fn has_kinks(&self) -> bool {
        matches!(
            self,
            Self::Bilinear(_) | Self::Table(_) | Self::Expression(_)
        )
    }

    /// Whether the force depends on the rate of strain.
    pub fn is_viscous(&self) -> bool {
        match self {
            Self::Viscous { .. } | Self::Viscoelastic { .. } => true,
            Self::Expression(law) => law.is_viscous(),
            _ => false,
        }
    }
}

impl LawKind<6> {
    /// The quadratic force of a prestressed section under imposed states: its table over
    /// axial, torsion, bending y and bending z, no part of the shears.
    ///
    /// ```text
    /// f_i = 1/2 T_ijk e_j e_k                                              (D-240)
    /// ```
    pub fn quadratic(table: &CubicTable, imposed: Vec<Imposed<6>>) -> Self {
        let slot = |component: usize| {
            let mut known = PRESTRESS_COMPONENTS.into_iter();
            known.position(|index| index == component)
        };
        let entry = |i, j, k| match (slot(i), slot(j), slot(k)) {
            (Some(i), Some(j), Some(k)) => table.at([i, j, k]),
            _ => 0.0,
        };
        let third = std::array::from_fn(|k| SMatrix::from_fn(|i, j| entry(i, j, k)));
        let third = Box::new(third);
        Self::Quadratic(Quadratic { third, imposed })
    }
}

/// Adds force and slope of each component independently.
fn add_each<const N: usize>(
    strain: &SVector<f64, N>,
    out: &mut Response<N>,
    of: impl Fn(usize, f64) -> (f64, f64),
) {
    for i in 0..N {
        let (force, slope) = of(i, strain[i]);
        out.force[i] += force;
        out.by_strain[(i, i)] += slope;
    }
}

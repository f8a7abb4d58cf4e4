//! Failure criteria.
//!
//! Every criterion gives an index, at most one if the material is safe, and a reserve
//! factor: the factor on the load at which the index becomes one. If a criterion is not
//! linear in the load, the reserve factor is not the inverse of the index; of several modes
//! and positions the one with the smallest reserve factor governs.

mod directional;
mod hashin;
mod tsai_wu;
mod uniform;

use nalgebra::Vector6;

use super::state::Tensors;
use crate::material::{MaterialLimits, StrainLimit, Strength};

/// A failure criterion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Criterion {
    /// Each stress against its strength.
    MaxStress,
    /// Each strain against its limit.
    MaxStrain,
    /// The tensor polynomial of Tsai and Wu.
    TsaiWu,
    /// The four modes of Hashin.
    Hashin,
    /// The von Mises stress against the yield stress.
    VonMises,
}

impl Criterion {
    /// All criteria, in the order of reports.
    pub const ALL: [Self; 5] = [
        Self::MaxStress,
        Self::MaxStrain,
        Self::TsaiWu,
        Self::Hashin,
        Self::VonMises,
    ];

    /// Name for reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::MaxStress => "max stress",
            Self::MaxStrain => "max strain",
            Self::TsaiWu => "Tsai-Wu",
            Self::Hashin => "Hashin",
            Self::VonMises => "von Mises",
        }
    }

    /// Name for columns of tables.
    pub fn key(self) -> &'static str {
        match self {
            Self::MaxStress => "max_stress",
            Self::MaxStrain => "max_strain",
            Self::TsaiWu => "tsai_wu",
            Self::Hashin => "hashin",
            Self::VonMises => "von_mises",
        }
    }
}

/// Mode of failure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    /// Tension along an axis of the material, 0 to 2 for 1 to 3.
    Tension(usize),
    /// Compression along an axis of the material, 0 to 2 for 1 to 3.
    Compression(usize),
    /// Shear: 0 for 23, 1 for 13, 2 for 12.
    Shear(usize),
    /// The fiber in tension.
    FiberTension,
    /// The fiber in compression.
    FiberCompression,
    /// The matrix in tension.
    MatrixTension,
    /// The matrix in compression.
    MatrixCompression,
    /// Largest principal value.
    PrincipalTension,
    /// Smallest principal value.
    PrincipalCompression,
    /// Largest shear.
    LargestShear,
    /// Yielding.
    Yielding,
}

impl Mode {
    /// Name for reports and tables.
    pub fn name(self) -> &'static str {
        let of = |names: [&'static str; 3], axis: usize| names[axis % 3];
        match self {
            Self::Tension(axis) => of(["tension 1", "tension 2", "tension 3"], axis),
            Self::Compression(axis) => {
                of(["compression 1", "compression 2", "compression 3"], axis)
            }
            Self::Shear(pair) => of(["shear 23", "shear 13", "shear 12"], pair),
            Self::FiberTension => "fiber tension",
            Self::FiberCompression => "fiber compression",
            Self::MatrixTension => "matrix tension",
            Self::MatrixCompression => "matrix compression",
            Self::PrincipalTension => "tension",
            Self::PrincipalCompression => "compression",
            Self::LargestShear => "shear",
            Self::Yielding => "yielding",
        }
    }
}

/// Result of one criterion at one point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FailureIndex {
    /// The criterion.
    pub criterion: Criterion,
    /// At most one if the material is safe \[-\].
    pub index: f64,
    /// The factor on the load at which the index is one; infinite if there is none \[-\].
    pub reserve_factor: f64,
    /// The governing mode.
    pub mode: Mode,
}

/// The indices of all criteria for which a material has limits, in the order of
/// [`Criterion::ALL`].
pub fn failure_indices(limits: &MaterialLimits, tensors: &Tensors) -> Vec<FailureIndex> {
    let mut indices = Vec::new();
    each_index(limits, tensors, |index| indices.push(index));
    indices
}

/// The index with the smallest reserve factor, if the material has limits.
pub(super) fn worst_index(limits: &MaterialLimits, tensors: &Tensors) -> Option<FailureIndex> {
    let mut worst: Option<FailureIndex> = None;
    each_index(limits, tensors, |index| {
        if worst.is_none_or(|worst| {
            index
                .reserve_factor
                .total_cmp(&worst.reserve_factor)
                .is_lt()
        }) {
            worst = Some(index);
        }
    });
    worst
}

/// The inverse of the smallest reserve factor of all criteria but Hashin, a convex function of the
/// state that is proportional to its size \[-\].
pub(super) fn convex_size(limits: &MaterialLimits, tensors: &Tensors) -> f64 {
    let mut size = f64::NEG_INFINITY;
    each_index(limits, tensors, |index| {
        if index.criterion != Criterion::Hashin {
            size = size.max(1.0 / index.reserve_factor);
        }
    });
    size
}

/// An upper bound of the inverse of the reserve factor by Hashin for all stresses in material axes
/// from `low` to `high`, each component by itself \[-\]; its safe set may have hollows.
pub(super) fn hashin_bound(
    limits: &MaterialLimits,
    low: &Vector6<f64>,
    high: &Vector6<f64>,
) -> f64 {
    match &limits.strength {
        Some(Strength::Ply { limits, .. }) => hashin::bound(limits, low, high),
        Some(Strength::Uniform(_) | Strength::Yield(_)) | None => f64::NEG_INFINITY,
    }
}

/// Calls `see` with the index of each criterion for which a material has limits.
fn each_index(limits: &MaterialLimits, tensors: &Tensors, mut see: impl FnMut(FailureIndex)) {
    let mut add = |criterion, (index, reserve_factor, mode): Verdict| {
        see(FailureIndex {
            criterion,
            index,
            reserve_factor,
            mode,
        });
    };
    let (stress, strain) = (&tensors.material_stress, &tensors.material_strain);
    match &limits.strength {
        Some(Strength::Ply { limits, .. }) => {
            add(Criterion::MaxStress, directional::index(limits, stress));
        }
        Some(Strength::Uniform(limits)) => {
            add(Criterion::MaxStress, uniform::of_stress(limits, stress));
        }
        Some(Strength::Yield(_)) | None => {}
    }
    match &limits.strain {
        Some(StrainLimit::Ply(limits)) => {
            add(Criterion::MaxStrain, directional::index(limits, strain));
        }
        Some(StrainLimit::Uniform(limits)) => {
            add(Criterion::MaxStrain, uniform::of_strain(limits, strain));
        }
        None => {}
    }
    match &limits.strength {
        Some(Strength::Ply {
            limits,
            interaction,
        }) => {
            add(
                Criterion::TsaiWu,
                tsai_wu::index(limits, interaction, stress),
            );
            add(Criterion::Hashin, hashin::index(limits, stress));
        }
        Some(Strength::Yield(limit)) => {
            let index = tensors.von_mises() / limit;
            add(Criterion::VonMises, (index, 1.0 / index, Mode::Yielding));
        }
        Some(Strength::Uniform(_)) | None => {}
    }
}

/// Index, reserve factor, mode.
type Verdict = (f64, f64, Mode);

/// The largest of several linear measures, each at most one if safe.
fn worst_linear(measures: impl IntoIterator<Item = (f64, Mode)>) -> Verdict {
    let measures = measures.into_iter();
    let worst = measures.max_by(|(a, _), (b, _)| a.total_cmp(b));
    let (index, mode) = worst.unwrap_or((0.0, Mode::Yielding));
    (index, 1.0 / index, mode)
}

/// The smallest positive factor at which `a t^2 + b t` is one, for `a >= 0`; infinite if
/// there is none.
///
/// ```text
/// t = 2 / (b + sqrt(b^2 + 4 a))                                                 (S-58)
/// ```
///
/// The form without a difference of nearly equal numbers for b > 0, and with the limit
/// 1/b for a = 0.
fn quadratic_reserve(a: f64, b: f64) -> f64 {
    let root = (b * b + 4.0 * a).sqrt();
    let denominator = b + root;
    if denominator > 0.0 {
        2.0 / denominator
    } else if denominator.is_nan() && (a.is_nan() || b.is_nan()) {
        f64::NAN
    } else {
        f64::INFINITY
    }
}

#[cfg(test)]
#[path = "criteria_tests.rs"]
mod tests;

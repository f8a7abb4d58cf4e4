//! Substitutes for stiffness that a blade does not have.
//!
//! Some programs compute sections without shear stiffness. A beam without shear strain
//! has an infinite one; its substitute is finite, so that matrices stay invertible:
//!
//! ```text
//! GA = 1e6 max(EIy, EIz) / L^2
//! ```
//!
//! of the station, with the length `L` of the blade. The deflection of a cantilever by
//! shear is then 3e-6 of its deflection by bending, and the frequency of mode `n` is lower
//! by about `(n pi)^2 1e-6 / 2` than without shear strain. An element of `L / 30` is about
//! 1e3 times as stiff in shear as in bending, far from round-off. The substitute for an
//! infinite torsional stiffness is 1e3 times the bending stiffness.

use nalgebra::Matrix6;

use super::{Blade, Reading, Station};

/// Stiffness against a force, relative to the bending stiffness over the square of the
/// length of the blade [-].
const FORCE: f64 = 1e6;
/// Stiffness against torsion, relative to the bending stiffness [-].
const TORSION: f64 = 1e3;
/// Components of shear.
const SHEAR: [usize; 2] = [1, 2];

/// Substitute for an infinite stiffness against a force, of a section with this stiffness
/// in a blade of `length` [m]; [N].
pub(crate) fn rigid_force(stiffness: &Matrix6<f64>, length: f64) -> f64 {
    FORCE * stiffness[(4, 4)].max(stiffness[(5, 5)]) / (length * length)
}

/// Substitute for an infinite stiffness against torsion [N m^2].
pub(crate) fn rigid_torsion(stiffness: &Matrix6<f64>) -> f64 {
    TORSION * stiffness[(4, 4)].max(stiffness[(5, 5)])
}

/// Whether a component has no stiffness and no coupling.
fn is_absent(stiffness: &Matrix6<f64>, component: usize) -> bool {
    stiffness.row(component).iter().all(|entry| *entry == 0.0)
        && stiffness.column(component).iter().all(|x| *x == 0.0)
}

impl Blade {
    /// Makes stations without shear stiffness rigid in shear, at the reference point of
    /// the matrices: their zero entries of shear get the substitute above. Other entries
    /// stay. Returns the number of changed stations.
    pub fn make_shear_rigid(&mut self) -> usize {
        let length = self.length();
        let change = |station: &mut Station| {
            let substitute = rigid_force(&station.stiffness, length);
            let absent = SHEAR.map(|i| is_absent(&station.stiffness, i));
            if !(substitute.is_finite() && substitute > 0.0) {
                return false;
            }
            for (i, absent) in SHEAR.into_iter().zip(absent) {
                if absent {
                    station.stiffness[(i, i)] = substitute;
                }
            }
            absent.contains(&true)
        };
        let changed = self.stations.iter_mut().map(change);
        changed.filter(|changed| *changed).count()
    }
}

impl Blade {
    /// As [`Blade::make_shear_rigid`]; a remark on the change.
    pub(crate) fn replace_absent_shear(&mut self) -> String {
        let (changed, all) = (self.make_shear_rigid(), self.stations.len());
        match changed {
            0 => "rigid shear has no effect: no station has zero shear stiffness without coupling"
                .to_owned(),
            _ => format!(
                "rigid in shear: the shear stiffness, which is zero at {changed} of {all} \
                 stations, is replaced by {FORCE:e} max(EIy, EIz) / L^2; sections then twist \
                 about the point of their matrices"
            ),
        }
    }
}

impl Reading {
    /// As [`Blade::make_shear_rigid`]; a remark states the change.
    pub(crate) fn make_shear_rigid(&mut self) {
        let remark = self.blade.replace_absent_shear();
        self.remarks.push(remark);
    }
}

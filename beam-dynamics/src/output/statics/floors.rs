//! Magnitudes of the quantities of an equilibrium below which they are round-off.
//!
//! A moment is the sum of forces on levers up to the length L of the model, so that it contains the
//! round-off of all of these, and a force contains the round-off of moments over L:
//!
//! ```text
//! F_0 = e max(F, M / L)        M_0 = e max(M, F L)        u_0 = e L        theta_0 = e
//! ```
//!
//! with the largest force F and the largest moment M of sections and reactions.

use nalgebra::Vector3;

use crate::result::StaticStep;

/// Part of the related scale below which a number is round-off.
pub(super) const ROUND_OFF: f64 = 1e-12;

/// Sizes up to which quantities are shown as zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Floors {
    /// Of displacements \[m\].
    pub displacement: f64,
    /// Of rotations \[rad\].
    pub rotation: f64,
    /// Of forces \[N\].
    pub force: f64,
    /// Of moments \[N m\].
    pub moment: f64,
}

impl Floors {
    /// The floors of a step of a model of this size \[m\], `part` of each scale.
    pub fn new(step: &StaticStep, size: f64, part: f64) -> Self {
        let (mut force, mut moment) = (0.0_f64, 0.0_f64);
        for section in &step.sections {
            let values = &section.internal_force;
            force = force.max(values.fixed_rows::<3>(0).amax());
            moment = moment.max(values.fixed_rows::<3>(3).amax());
        }
        for reaction in &step.reactions {
            force = force.max(reaction.force.amax());
            moment = moment.max(reaction.moment.amax());
        }
        Self {
            displacement: part * size,
            rotation: part,
            force: part * force.max(moment / size),
            moment: part * moment.max(force * size),
        }
    }

    /// The floor of a component of an internal force.
    pub fn of_component(&self, component: usize) -> f64 {
        match component {
            0..3 => self.force,
            _ => self.moment,
        }
    }
}

/// A value without its round-off.
pub(super) fn clean(value: f64, floor: f64) -> f64 {
    if value.abs() <= floor { 0.0 } else { value }
}

/// A vector whose components have no round-off.
pub(super) fn clean_vector(value: &Vector3<f64>, floor: f64) -> Vector3<f64> {
    value.map(|component| clean(component, floor))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples;

    // The largest force of the sample is 1000 N, the largest moment 10 kN m at the
    // clamp, and 10 m the length: equal scales.
    #[test]
    fn moments_are_measured_with_forces_on_a_lever() {
        let mut step = samples::bent(&[1.0]).steps.remove(0);
        let floors = Floors::new(&step, 10.0, 1e-12);
        assert_eq!((floors.force, floors.moment), (1e-9, 1e-8));
        for section in &mut step.sections {
            section.internal_force.fixed_rows_mut::<3>(3).fill(1e-13);
        }
        step.reactions.clear();
        let floors = Floors::new(&step, 10.0, 1e-12);
        assert_eq!((floors.force, floors.moment), (1e-9, 1e-8));
        assert_eq!(clean(1e-13, floors.of_component(4)), 0.0);
        assert_eq!(clean(-1e-7, floors.of_component(4)), -1e-7);
        assert!(clean(f64::NAN, 1.0).is_nan());
    }
}

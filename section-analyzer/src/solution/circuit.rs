//! Properties of a section for a beam model without its floating electrodes.

use super::{ElectrodeSolution, SectionSolution};
use crate::failure::Failure;
use crate::properties::{Centers, PrincipalAxes, invert_symmetric};
use crate::section::Circuit;
use nalgebra::Vector3;
use shared_geom::wrench;

impl ElectrodeSolution {
    /// Whether its charge per length stays zero and its voltage results from it.
    pub fn is_open(&self) -> bool {
        self.circuit == Circuit::Floating
    }
}

impl SectionSolution {
    /// Whether electrodes are open.
    pub fn has_open_electrodes(&self) -> bool {
        let piezo = self.piezo.as_ref();
        piezo.is_some_and(|piezo| piezo.electrodes.iter().any(ElectrodeSolution::is_open))
    }

    /// The section in its circuit: stiffness, compliance, tension and shear center, and the
    /// principal axes of bending with floating electrodes at zero charge, (S-169). Warping
    /// and the generalized strain of the central solutions remain those at constant voltage.
    ///
    /// # Errors
    /// [`Failure::Undetermined`] if floating electrodes leave a voltage undetermined;
    /// [`Failure::ComplianceNotPositive`].
    pub fn in_circuit(&self) -> Result<Self, Failure> {
        let mut seen = self.clone();
        let Some(piezo) = self.piezo.as_ref().filter(|_| self.has_open_electrodes()) else {
            return Ok(seen);
        };
        let circuit = |electrode: usize| piezo.electrodes[electrode].circuit;
        let found = piezo.in_circuit(&self.stiffness, circuit);
        let found = found.ok_or_else(|| piezo.undetermined())?;
        // near the section, where the coordinates keep their digits
        let [y, z] = self.centers.tension;
        let t = Vector3::new(0.0, y, z);
        let about = wrench::shift(&found.stiffness, &t);
        let compliance = invert_symmetric(&about).ok_or(Failure::ComplianceNotPositive)?;
        let back = wrench::shift_matrix(&t);
        let centers = Centers::new(&compliance, &wrench::shift(&self.mass, &t));
        seen.stiffness = found.stiffness;
        seen.compliance = back.transpose() * compliance * back;
        seen.centers = Centers {
            mass: self.centers.mass,
            ..centers.placed([y, z])
        };
        seen.principal_bending = PrincipalAxes::of_bending(&compliance);
        Ok(seen)
    }
}

#[cfg(test)]
mod tests {
    use crate::analysis::analyze;
    use crate::section::Circuit;
    use crate::section::piezo_samples::{bimorph, k31, layer};
    use crate::solution::SectionSolution;

    /// A layer with its upper face open: `s11D = s11 (1 - k31^2)` gives EA at constant
    /// electric displacement; EIy, whose field is already linear, does not change; the
    /// compliance is the inverse, and the centers remain in the middle. Round-off.
    #[test]
    fn an_open_layer_has_the_stiffness_of_constant_displacement() {
        let mut section = layer();
        for node in &mut section.mesh.nodes {
            *node = [node[0] + 0.01, node[1] - 0.02];
        }
        let held = analyze(&section).unwrap();
        section.electrodes[1].circuit = Circuit::Floating;
        let solution = analyze(&section).unwrap();
        assert_eq!(solution.stiffness, held.stiffness);
        let open = solution.in_circuit().unwrap();
        let ratio = open.stiffness[(0, 0)] / held.stiffness[(0, 0)];
        assert!((ratio * (1.0 - k31()) - 1.0).abs() < 1e-11);
        let unit = open.compliance * open.stiffness;
        // moments about a point 20 sizes away
        assert!((unit - nalgebra::Matrix6::identity()).amax() < 1e-7);
        let [y, z] = open.centers.tension;
        assert!((y - 0.01).abs() < 1e-13 && (z + 0.02).abs() < 1e-13);
        let bending = |s: &SectionSolution| s.principal_bending.first;
        assert!((bending(&open) / bending(&held) - 1.0).abs() < 1e-11);
    }

    /// The bimorph bends with its outer faces open: each layer then stores more energy;
    /// without an electrode at a given voltage the voltages are undetermined.
    #[test]
    fn open_electrodes_stiffen_and_need_one_that_is_held() {
        let mut section = bimorph();
        let held = analyze(&section).unwrap();
        for electrode in &mut section.electrodes[1..] {
            electrode.circuit = Circuit::Floating;
        }
        let open = analyze(&section).unwrap().in_circuit().unwrap();
        assert!(open.stiffness[(4, 4)] > 1.05 * held.stiffness[(4, 4)]);
        let least = (open.stiffness - held.stiffness)
            .symmetric_eigenvalues()
            .min();
        assert!(least > -1e-10 * held.stiffness.amax());
        section.electrodes[0].circuit = Circuit::Floating;
        let found = analyze(&section).unwrap().in_circuit();
        let text = found.unwrap_err().to_string();
        assert_eq!(
            text,
            "the voltages of the open electrodes middle, top, bottom are not determined"
        );
    }
}

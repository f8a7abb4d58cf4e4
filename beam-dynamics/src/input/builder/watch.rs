//! Readings of elements as scalars.

use std::sync::Arc;

use nalgebra::DMatrix;

use super::{ModelBuilder, boxed};
use crate::elements::control::{Matrices, StateSpace};
use crate::elements::{Adapted, Element, EnergyPart, EnergySlope, Reading, Signal};
use crate::model::{Node, NodeMotion, Scalar};

impl ModelBuilder {
    /// Makes a scalar of a reading of the element called `label`.
    pub fn watch(&mut self, label: String, reading: Reading, scalar: Scalar) {
        self.watched.push((label, reading, scalar));
    }

    /// Makes a scalar of a part of the energy of the model, for the sensor `name`.
    ///
    /// # Errors
    ///
    /// The name of an element that has this energy without known derivatives.
    pub fn watch_energy(
        &mut self,
        part: EnergyPart,
        name: &str,
        scalar: &Scalar,
    ) -> Result<(), String> {
        let scalars = self.scalars_of_electrodes();
        let beams = self.beams.iter().enumerate();
        let of_beams = beams.flat_map(|beam| self.beam_elements(beam, &scalars, &mut None));
        let unknown = |element: &dyn Element| {
            let slope = element.energetic().map(|own| own.slope());
            let is_unknown = slope == Some(EnergySlope::Unknown) && EnergySlope::Unknown.has(part);
            is_unknown.then(|| element.label().to_owned())
        };
        let mut circuits = self.circuits(&scalars);
        circuits.extend(of_beams);
        let known = circuits.iter().chain(&self.joints).map(AsRef::as_ref);
        if let Some(label) = known.filter_map(unknown).next() {
            return Err(label);
        }
        // The elements add their shares to this.
        let none = Matrices::gain(DMatrix::zeros(1, 0));
        let own = vec![scalar.clone()];
        self.add_control(boxed(StateSpace::new(name, none, Vec::new(), own, &[])));
        self.watched_energies.push((part, scalar.clone()));
        Ok(())
    }

    /// Makes a scalar of an unknown of the circuit of an electrode, by the indices of both,
    /// for the sensor `name`.
    pub fn watch_electrode(&mut self, index: (usize, usize), name: String, scalar: Scalar) {
        self.watched_electrodes.push((index.into(), name, scalar));
    }

    /// The sensors of unknowns of electrodes, which have the given scalars.
    pub(super) fn electrode_sensors(&self, scalars: &[Vec<Scalar>]) -> Vec<Box<dyn Element>> {
        let sensor = |([electrode, index], name, scalar): &([usize; 2], String, Scalar)| {
            let input = Signal::scalar(scalars[*electrode][*index].clone());
            let gain = Matrices::gain(DMatrix::identity(1, 1));
            boxed(StateSpace::new(
                name,
                gain,
                vec![input],
                vec![scalar.clone()],
                &[],
            ))
        };
        self.watched_electrodes.iter().map(sensor).collect()
    }
}

/// Returns `elements` of a model; those that are read are adapted.
pub(super) fn adapt(
    elements: Vec<Box<dyn Element>>,
    mut watched: Vec<(String, Reading, Scalar)>,
    energies: &[(EnergyPart, Scalar)],
    nodes: &[Node],
) -> Vec<Box<dyn Element>> {
    let adapted = elements.into_iter().map(|element| {
        let slope = element.energetic().map(|own| own.slope());
        let has = |part: EnergyPart| slope.is_some_and(|slope| slope.has(part));
        let shares = energies.iter().filter(|energy| has(energy.0));
        let shares = shares.map(|(part, scalar)| (Reading::Energy(*part), scalar.clone()));
        let mut readings: Vec<_> = shares.collect();
        let rest = element
            .nodes()
            .iter()
            .map(|&node| NodeMotion::at_rest(&nodes[node]));
        let rest: Vec<_> = rest.collect();
        // Another element may have the same name.
        let is_own = |(label, reading, _): &mut (String, Reading, Scalar)| {
            label == element.label() && Adapted::reports(element.as_ref(), reading, &rest)
        };
        let own = watched.extract_if(.., is_own);
        readings.extend(own.map(|(_, reading, scalar)| (reading, scalar)));
        if readings.is_empty() {
            element
        } else {
            boxed(Adapted::read(Arc::from(element), readings))
        }
    });
    adapted.collect()
}

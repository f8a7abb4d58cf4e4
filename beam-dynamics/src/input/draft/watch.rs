//! Readings of elements as scalars.

use std::sync::Arc;

use nalgebra::DMatrix;

use super::{Draft, boxed};
use crate::elements::control::{Matrices, StateSpace};
use crate::elements::{Adapted, Element, Reading, Signal};
use crate::model::{Node, NodeMotion, Scalar};

impl Draft {
    /// Makes a scalar of a reading of the element called `label`.
    pub fn watch(&mut self, label: String, reading: Reading, scalar: Scalar) {
        self.watched.push((label, reading, scalar));
    }

    /// Makes the scalar of the sensor `name` of an unknown of the circuit of an electrode, by
    /// the numbers of both.
    pub fn watch_electrode(&mut self, place: (usize, usize), name: String, scalar: Scalar) {
        self.watched_electrodes.push((place.into(), name, scalar));
    }

    /// The sensors of unknowns of electrodes, which have the given scalars.
    pub(super) fn electrode_sensors(&self, scalars: &[Vec<Scalar>]) -> Vec<Box<dyn Element>> {
        let sensor = |([electrode, place], name, scalar): &([usize; 2], String, Scalar)| {
            let input = Signal::scalar(scalars[*electrode][*place].clone());
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

/// `elements` of a model, those adapted that are read.
pub(super) fn adapt(
    elements: Vec<Box<dyn Element>>,
    mut watched: Vec<(String, Reading, Scalar)>,
    nodes: &[Node],
) -> Vec<Box<dyn Element>> {
    let adapted = elements.into_iter().map(|element| {
        if !watched.iter().any(|(label, ..)| label == element.label()) {
            return element;
        }
        let rest = element
            .nodes()
            .iter()
            .map(|&node| NodeMotion::at_rest(&nodes[node]));
        let rest: Vec<_> = rest.collect();
        // Another element may have the same name.
        let is_own = |(label, reading, _): &mut (String, Reading, Scalar)| {
            label == element.label() && Adapted::reports(element.as_ref(), reading, &rest)
        };
        let own: Vec<_> = watched.extract_if(.., is_own).collect();
        match own.is_empty() {
            true => element,
            false => {
                let readings = own
                    .into_iter()
                    .map(|(_, reading, scalar)| (reading, scalar));
                boxed(Adapted::read(Arc::from(element), readings.collect()))
            }
        }
    });
    adapted.collect()
}

//! Electrodes of the model: beams that have them, and their circuits.

use nalgebra::{DMatrix, Vector6};
use shared_geom::section::Piezo;

use super::{Beam, ModelBuilder, boxed};
use crate::elements::Element;
use crate::elements::beams::{self, BeamElectrode, Potential};
use crate::elements::circuits::{Circuit, Electrode};
use crate::model::Scalar;

/// An electrode as its card defines it.
#[derive(Debug)]
pub(in crate::input) struct ElectrodeCard {
    /// Its name in the model.
    pub label: String,
    /// Indices of its beams, and its column in the property file of each.
    pub on: Vec<(usize, usize)>,
    /// Its circuit.
    pub circuit: Circuit,
    /// Line of the card.
    pub line: usize,
}

impl ElectrodeCard {
    /// Its column on a beam.
    pub(super) fn column(&self, beam: usize) -> Option<usize> {
        let on = self.on.iter().find(|on| on.0 == beam);
        on.map(|on| on.1)
    }
}

impl ModelBuilder {
    /// Electrodes so far.
    pub fn electrodes(&self) -> &[ElectrodeCard] {
        &self.electrodes
    }

    /// Adds an electrode; returns its index.
    pub fn add_electrode(&mut self, card: ElectrodeCard) {
        self.electrodes.push(card);
    }

    /// Charge of an electrode, per volt on another, over all the beams of both \[F\].
    pub fn capacitance(&self, first: &ElectrodeCard, second: &ElectrodeCard) -> f64 {
        let of_beam = |(beam, column): &(usize, usize)| {
            let other = second.column(*beam)?;
            let beam = &self.beams[*beam];
            let piezo = beam.properties.piezo.as_ref()?;
            let per_length = [piezo.capacitance[(*column, other)]; 2];
            let ends = self.ends(beam);
            Some(BeamElectrode::capacitance(&beam.geometry, ends, per_length))
        };
        first.on.iter().filter_map(of_beam).sum()
    }

    /// The unknowns of the circuit of each electrode.
    pub(super) fn scalars_of_electrodes(&self) -> Vec<Vec<Scalar>> {
        let of = |card: &ElectrodeCard| {
            let capacitance = self.capacitance(card, card);
            card.circuit.scalars(&card.label, capacitance)
        };
        self.electrodes.iter().map(of).collect()
    }

    /// The circuits of all electrodes, with their unknowns.
    pub(super) fn circuits(&self, scalars: &[Vec<Scalar>]) -> Vec<Box<dyn Element>> {
        let circuit = |(number, card): (usize, &ElectrodeCard)| {
            let capacitance = self.capacitance(card, card);
            let (circuit, scalars) = (card.circuit.clone(), scalars[number].clone());
            let label = &card.label;
            boxed(Electrode::new(label, number, circuit, scalars, capacitance))
        };
        self.electrodes.iter().enumerate().map(circuit).collect()
    }

    /// The element of beam `index` with its electrodes.
    pub(super) fn with_electrodes(
        &self,
        index: usize,
        element: beams::Beam,
        scalars: &[Vec<Scalar>],
    ) -> beams::Beam {
        let beam = &self.beams[index];
        let cards = self.electrodes.iter().enumerate();
        let on = cards.filter_map(|(number, card)| Some((number, card, card.column(index)?)));
        let on: Vec<_> = on.collect();
        let (Some(piezo), false) = (&beam.properties.piezo, on.is_empty()) else {
            return element;
        };
        let columns: Vec<_> = on.iter().map(|on| on.2).collect();
        let capacitance = DMatrix::from_fn(columns.len(), columns.len(), |i, j| {
            piezo.capacitance[(columns[i], columns[j])]
        });
        let electrodes = on.into_iter().map(|(number, card, column)| BeamElectrode {
            number,
            potential: match &card.circuit {
                Circuit::Held(source) => Potential::Held(source.clone()),
                Circuit::Open { .. } | Circuit::Shunt { .. } => {
                    Potential::Free(scalars[number][0].clone())
                }
            },
            coupling: [Vector6::from_iterator(piezo.coupling.column(column).iter().copied()); 2],
            capacitance: self.capacitance(card, card),
        });
        let capacitance = [capacitance.clone(), capacitance];
        element.with_electrodes(electrodes.collect(), capacitance)
    }
}

/// The electrodes of a beam; empty if it has no electrodes.
pub(in crate::input) fn names(beam: &Beam) -> &[String] {
    let piezo: Option<&Piezo> = beam.properties.piezo.as_ref();
    piezo.map_or(&[], |piezo| &piezo.electrodes)
}

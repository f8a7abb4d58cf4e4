//! Questions to an element, whatever capabilities it has.

use nalgebra::{Matrix3, Vector3};

use super::{
    Along, Charges, ConstraintRates, ConstraintWords, Element, Energy, Exchange, Level, Local,
    LocalJacobian, LocalResidual, Motion, Observations, PlaceJump, Reading, ReadingRow,
    prestress_of_multipliers,
};
use crate::model::{Drive, Loading, NodeMotion, Scalars};

/// Questions to an element. All elements answer them by their capabilities: they cannot be
/// answered otherwise.
pub trait Queries: Element {
    /// Adds the residual alone, see [`Element::evaluate`].
    fn residual(&self, at: &Local<'_>, out: &mut LocalResidual) {
        self.evaluate(at, out, None);
    }

    /// Adds the derivatives alone, see [`Element::evaluate`].
    fn jacobian(&self, at: &Local<'_>, out: &mut LocalJacobian) {
        self.evaluate(at, &mut LocalResidual::ignored(), Some(out));
    }

    /// Number of multipliers (constraint equations) that the element brings.
    fn multipliers(&self) -> usize {
        self.constraints().map_or(0, |own| own.count())
    }

    /// The highest derivative that stands in the constraint number `constraint`.
    fn level(&self, constraint: usize) -> Level {
        self.constraints()
            .map_or(Level::Position, |own| own.level_of(constraint))
    }

    /// The words of the constraint number `constraint` and of its multiplier.
    fn constraint_words(&self, constraint: usize) -> ConstraintWords {
        match self.constraints() {
            Some(own) => own.words_of(constraint),
            None => ConstraintWords::numbered(constraint),
        }
    }

    /// Reports how the constraints change by themselves, which start-up needs to find
    /// velocities and accelerations that agree with them. `false` when the element does not
    /// know.
    fn constraint_rates(&self, at: &Local<'_>, out: &mut ConstraintRates<'_>) -> bool {
        self.constraints().is_none_or(|own| own.add_rates(at, out))
    }

    /// A jump of a place in which its signals hold something, between two instants at the same
    /// scalars: no motion follows that.
    fn jump(&self, between: [&Loading; 2], scalars: Scalars<'_>) -> Option<PlaceJump> {
        self.constraints()?.jump_of_place(between, scalars)
    }

    /// The element with all that it drives by velocities held in the place that it has in the
    /// undeformed model, by as many constraints; `None` when it drives nothing so. Equilibria
    /// are found with it: a velocity says nothing of a state at rest.
    fn held(&self, undeformed: &[NodeMotion]) -> Option<Box<dyn Element>> {
        self.constraints()?.held_in_place(undeformed)
    }

    /// Whether a rotation that it drives is held half a turn off: its constraints are
    /// fulfilled there too.
    fn is_turned_over(&self, at: &Local<'_>) -> bool {
        self.constraints().is_some_and(|own| own.turned_over(at))
    }

    /// The axes (columns) of a joint that turn with its first end and with its second, in the
    /// model's axes; `None` for an element that is no joint.
    fn end_axes(&self, at: &Local<'_>) -> Option<[Matrix3<f64>; 2]> {
        self.constraints()?.axes_of_ends(at)
    }

    /// Number of its numbers of accepted steps.
    fn memory_size(&self) -> usize {
        self.memory().map_or(0, |own| own.size())
    }

    /// All that it is given over time alone.
    fn drives(&self) -> Vec<&Drive> {
        let mut drives = Vec::new();
        self.each_signal(&mut |signal| drives.extend(signal.drive()));
        drives
    }

    /// The first time after `time` at which time alone makes a corner or a jump in a signal of
    /// the element, or at which its memory may change \[s\]; infinite when there is none.
    fn next_corner(&self, time: f64) -> f64 {
        if let Some(memory) = self.memory() {
            return memory.next_change(time);
        }
        let mut first = f64::INFINITY;
        self.each_signal(&mut |signal| first = first.min(signal.next_corner(time)));
        first
    }

    /// The first and the last time at which all drives of the element have a value \[s\].
    fn domain(&self) -> [f64; 2] {
        Drive::common_domain(self.drives().into_iter())
    }

    /// Whether a signal with which it acts depends on scalars.
    fn senses(&self) -> bool {
        let mut senses = false;
        self.each_signal(&mut |signal| senses |= signal.senses());
        senses
    }

    /// Energy of the element.
    fn energy(&self, at: &Local<'_>) -> Energy {
        self.energetic()
            .map_or_else(Energy::default, |own| own.stored(at))
    }

    /// How it exchanges energy with the outside of the model. Gravity does not count, the
    /// power of which follows from the momenta.
    fn exchange(&self) -> Exchange {
        match self.energetic() {
            Some(own) => own.exchanged(),
            None => Exchange::by_signals(self),
        }
    }

    /// Whether its forces without rates are the derivatives of its energy.
    fn keeps_energy(&self) -> bool {
        self.energetic().is_none_or(|own| own.is_conservative())
    }

    /// Adds the derivative of the residual by the factor of the proportional loads.
    fn by_factor(&self, at: &Local<'_>, out: &mut LocalResidual) {
        if let Some(own) = self.growth() {
            own.add_by_factor(at, out);
        }
    }

    /// Adds the growth of the Jacobian with the factor of the proportional loads at
    /// fixed geometry: with the internal forces and multipliers that change `along` a
    /// small motion, and with the loads themselves.
    fn prestress(&self, at: &Local<'_>, along: &Along<'_>, out: &mut LocalJacobian) {
        match self.growth() {
            Some(own) => own.add_prestress(at, along, out),
            None => prestress_of_multipliers(self, at, along, out),
        }
    }

    /// The longest arm from a node to a point at which the element acts in the undeformed
    /// model, or distance between two such points \[m\].
    fn reach(&self) -> f64 {
        self.structure().map_or(0.0, |own| own.arm())
    }

    /// Whether it resists every relative motion of its nodes without constraints, as a beam
    /// does.
    fn joins_nodes(&self) -> bool {
        self.structure().is_some_and(|own| own.is_joining())
    }

    /// Relative motions of its nodes at the undeformed state that the element, beside its
    /// constraints, resists by springs or leaves free on purpose.
    fn motions(&self) -> Vec<Motion> {
        self.structure()
            .map_or_else(Vec::new, |own| own.free_motions())
    }

    /// The rotation by which it is loaded, from where that is relaxed if it counts from there,
    /// and which is known up to whole turns only, where there is one \[rad\]: it must not pass
    /// half a turn.
    fn winding(&self, at: &Local<'_>) -> Option<Vector3<f64>> {
        self.structure()?.loaded_turn(at)
    }

    /// Why it has no value at a state and a time, in words, where it can tell.
    fn without_value(&self, at: &Local<'_>) -> Option<String> {
        self.structure()?.undefined(at)
    }

    /// Reports what the element knows of a state beside its forces on the nodes: strains
    /// and internal forces of sections, reactions of joints.
    fn observe(&self, at: &Local<'_>, out: &mut Observations) {
        if let Some(own) = self.reports() {
            own.report(at, out);
        }
    }

    /// A reading other than a reaction, in SI units, with its derivatives where `row` takes
    /// them; `None` where the element reports nothing of the kind.
    fn read(
        &self,
        reading: &Reading,
        at: &Local<'_>,
        row: Option<&mut ReadingRow<'_>>,
    ) -> Option<f64> {
        self.reports()?.reading(reading, at, row)
    }

    /// Reports what it knows of charges and voltages of electrodes.
    fn charges(&self, at: &Local<'_>, out: &mut Charges) {
        if let Some(own) = self.reports() {
            own.report_charges(at, out);
        }
    }
}

impl<E: Element + ?Sized> Queries for E {}

impl Exchange {
    /// That of an element without energy of its own: it gives and takes by what it is given.
    pub fn by_signals<E: Element + ?Sized>(element: &E) -> Self {
        let drives = element.drives();
        let has_rates = (0..element.multipliers()).any(|i| element.level(i) == Level::Velocity);
        let changes = drives.iter().any(|drive| drive.constant().is_none());
        let is_driven = changes || element.senses() || (has_rates && !drives.is_empty());
        Self::of(false, is_driven)
    }
}

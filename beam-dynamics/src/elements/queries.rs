//! Queries of an element, for any capabilities.

use nalgebra::{Matrix3, Vector3};

use super::{
    Charges, ConstraintRates, ConstraintWords, Element, Energy, Exchange, FixedVector, Level,
    Local, LocalJacobian, LocalResidual, Motion, Observations, PositionJump, Reading, ReadingRow,
    SmallMotion, prestress_of_multipliers,
};
use crate::model::{Drive, Loading, NodeMotion, Scalars};

/// Queries of an element. All elements answer them through their capabilities and cannot override
/// them.
pub trait Queries: Element {
    /// Adds only the residual, see [`Element::evaluate`].
    fn residual(&self, at: &Local<'_>, out: &mut LocalResidual) {
        self.evaluate(at, out, None);
    }

    /// Adds only the derivatives, see [`Element::evaluate`].
    fn jacobian(&self, at: &Local<'_>, out: &mut LocalJacobian) {
        self.evaluate(at, &mut LocalResidual::ignored(), Some(out));
    }

    /// Number of multipliers (constraint equations) of the element.
    fn multipliers(&self) -> usize {
        self.constraints().map_or(0, |own| own.count())
    }

    /// The highest derivative in the constraint `constraint`.
    fn level(&self, constraint: usize) -> Level {
        self.constraints()
            .map_or(Level::Position, |own| own.level_of(constraint))
    }

    /// The texts of the constraint `constraint` and of its multiplier.
    fn constraint_words(&self, constraint: usize) -> ConstraintWords {
        match self.constraints() {
            Some(own) => own.words_of(constraint),
            None => ConstraintWords::numbered(constraint),
        }
    }

    /// Reports the rates of the constraints, from which initialization computes consistent
    /// velocities and accelerations. `false` if the element does not define them.
    fn constraint_rates(&self, at: &Local<'_>, out: &mut ConstraintRates<'_>) -> bool {
        self.constraints().is_none_or(|own| own.add_rates(at, out))
    }

    /// A jump of a position or an attitude prescribed by its signals, between two instants at the
    /// same scalars: no motion can follow it.
    fn jump(&self, between: [&Loading; 2], scalars: Scalars<'_>) -> Option<PositionJump> {
        self.constraints()?.position_jump(between, scalars)
    }

    /// The element with all rotations and displacements that it drives by velocities held at their
    /// values in the undeformed model, by as many constraints; `None` if it drives none by
    /// velocities. Equilibria are computed with it, since velocities do not define a state at rest.
    fn held(&self, undeformed: &[NodeMotion]) -> Option<Box<dyn Element>> {
        self.constraints()?.held_in_place(undeformed)
    }

    /// Whether a driven rotation is settled 180 deg away from its prescribed value, where its
    /// constraints are fulfilled too.
    fn is_turned_over(&self, at: &Local<'_>) -> bool {
        self.constraints().is_some_and(|own| own.turned_over(at))
    }

    /// The axes (columns) of a joint that turn with its first end and with its second, in the
    /// model's axes; `None` for elements other than joints.
    fn end_axes(&self, at: &Local<'_>) -> Option<[Matrix3<f64>; 2]> {
        self.constraints()?.axes_of_ends(at)
    }

    /// The unknowns that are components along fixed axes of vectors that turn with nodes.
    fn fixed_vectors(&self) -> Vec<FixedVector> {
        self.fixed_axes().map_or_else(Vec::new, |own| own.vectors())
    }

    /// Number of its numbers stored at accepted steps.
    fn memory_size(&self) -> usize {
        self.memory().map_or(0, |own| own.size())
    }

    /// All its inputs that depend on time alone.
    fn drives(&self) -> Vec<&Drive> {
        let mut drives = Vec::new();
        self.each_signal(&mut |signal| drives.extend(signal.drive()));
        drives
    }

    /// The first time after `time` at which a signal of the element or the element itself has a
    /// corner or a jump in time, or at which its memory may change \[s\]; infinite if there is none.
    fn next_corner(&self, time: f64) -> f64 {
        let mut first = self.next_own_corner(time);
        if let Some(memory) = self.memory() {
            return first.min(memory.next_change(time));
        }
        self.each_signal(&mut |signal| first = first.min(signal.next_corner(time)));
        first
    }

    /// The first and the last time at which all drives of the element have a value \[s\].
    fn domain(&self) -> [f64; 2] {
        Drive::common_domain(self.drives().into_iter())
    }

    /// Whether one of its signals depends on scalars.
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

    /// Exchange of energy with the outside of the model. Gravity is excluded: its power follows
    /// from the momenta.
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

    /// Adds the growth of the Jacobian with the factor of the proportional loads at fixed geometry:
    /// with the internal forces and multipliers that change `motion` a small motion, and with the
    /// loads.
    fn prestress(&self, at: &Local<'_>, motion: &SmallMotion<'_>, out: &mut LocalJacobian) {
        match self.growth() {
            Some(own) => own.add_prestress(at, motion, out),
            None => prestress_of_multipliers(self, at, motion, out),
        }
    }

    /// The longest arm from a node to a point at which the element acts in the undeformed model, or
    /// the longest distance between two of these points \[m\].
    fn reach(&self) -> f64 {
        self.structure().map_or(0.0, |own| own.arm())
    }

    /// Whether it resists every relative motion of its nodes without constraints, as a beam
    /// does.
    fn joins_nodes(&self) -> bool {
        self.structure().is_some_and(|own| own.is_joining())
    }

    /// Relative motions of its nodes at the undeformed state that the element, apart from its
    /// constraints, resists with springs or leaves free by design.
    fn motions(&self) -> Vec<Motion> {
        self.structure()
            .map_or_else(Vec::new, |own| own.free_motions())
    }

    /// The rotation that determines its moment, relative to its relaxed value if it has one, if
    /// this is known only up to full turns \[rad\]: it must not pass half a turn.
    fn winding(&self, at: &Local<'_>) -> Option<Vector3<f64>> {
        self.structure()?.loaded_turn(at)
    }

    /// Reason why its forces are undefined at a state and a time, as text, if known.
    fn without_value(&self, at: &Local<'_>) -> Option<String> {
        self.structure()?.undefined(at)
    }

    /// Reports observations of a state other than the forces on the nodes: strains and internal
    /// forces of sections, reactions of joints.
    fn observe(&self, at: &Local<'_>, out: &mut Observations) {
        if let Some(own) = self.reports() {
            own.report(at, out);
        }
    }

    /// A reading other than a reaction, in SI units, with its derivatives if `row` takes them;
    /// `None` if the element has no reading of this kind.
    fn read(
        &self,
        reading: &Reading,
        at: &Local<'_>,
        row: Option<&mut ReadingRow<'_>>,
    ) -> Option<f64> {
        self.reports()?.reading(reading, at, row)
    }

    /// Reports its contributions to charges and voltages of electrodes.
    fn charges(&self, at: &Local<'_>, out: &mut Charges) {
        if let Some(own) = self.reports() {
            own.report_charges(at, out);
        }
    }
}

impl<E: Element + ?Sized> Queries for E {}

impl Exchange {
    /// The exchange of an element without energy of its own: through its inputs only.
    pub fn by_signals<E: Element + ?Sized>(element: &E) -> Self {
        let drives = element.drives();
        let has_rates = (0..element.multipliers()).any(|i| element.level(i) == Level::Velocity);
        let changes = drives.iter().any(|drive| drive.constant().is_none());
        let is_driven = changes || element.senses() || (has_rates && !drives.is_empty());
        Self::of(false, is_driven)
    }
}

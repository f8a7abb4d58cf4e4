//! An element without some of its constraints, or with readings as scalars.
//!
//! A removed constraint is replaced by "the multiplier is zero". For each reading q the scalar s
//! has the equation `s - q = 0`; a force or moment that the element exerts on a node is the part of
//! its residual in the equations of that node, along a direction m that may turn with a node c:
//!
//! ```text
//! q = m . F ,      dq = m . dF + ( m x F ) . theta_c
//! ```

use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};

use super::energy_rows::add_slope;
use super::{
    Axes, Charges, ConstraintRates, ConstraintWords, Element, Energy, EnergySlope, Exchange,
    FixedAxes, FixedVector, Level, Local, LocalJacobian, LocalResidual, Motion, Observations, Part,
    PositionJump, Reading, ReadingRow, Signal, SmallMotion,
};
use crate::elements::{
    Constraints, Energetic, Growth, Memory, Queries, Reports, Settling, Structure,
};
use crate::model::{Equation, Loading, NodeMotion, Scalar, Scalars, Variable};

/// Number of multipliers of most elements.
const FEW: usize = 16;

/// An element, adapted.
#[derive(Debug)]
pub struct Adapted {
    element: Arc<dyn Element>,
    removed: Vec<usize>,
    /// Readings; their scalars follow the element's scalars.
    readings: Vec<Reading>,
    scalars: Vec<Scalar>,
}

/// A reaction at a state.
struct Reacting {
    /// Local number of the node, and the equation.
    index: (usize, Equation),
    /// Direction of the part, in the model's axes.
    along: Vector3<f64>,
    /// The local node with which it turns.
    turns_with: Option<usize>,
}

impl Adapted {
    /// `element` without its constraints of the indices `removed`.
    pub fn reduced(element: Arc<dyn Element>, removed: Vec<usize>) -> Self {
        Self {
            removed,
            ..Self::read(element, Vec::new())
        }
    }

    /// `element` with readings, each with its scalar.
    pub fn read(element: Arc<dyn Element>, readings: Vec<(Reading, Scalar)>) -> Self {
        let mut scalars = element.scalars().to_vec();
        let (readings, own): (Vec<_>, Vec<_>) = readings.into_iter().unzip();
        scalars.extend(own);
        Self {
            element,
            removed: Vec::new(),
            readings,
            scalars,
        }
    }

    /// Whether an element reports a reading of one of its nodes, or of its ends.
    pub fn reports(element: &dyn Element, reading: &Reading, undeformed: &[NodeMotion]) -> bool {
        let conditions = crate::model::Conditions::at_rest();
        let zeros = vec![0.0; element.multipliers().max(element.scalars().len())];
        let at = Local {
            nodes: undeformed,
            multipliers: &zeros[..element.multipliers()],
            scalars: Scalars {
                values: &zeros[..element.scalars().len()],
                rates: &zeros[..element.scalars().len()],
            },
            memory: &[],
            frame: &conditions.frame,
            loading: &conditions.loading,
        };
        let mut observed = Observations::default();
        element.observe(&at, &mut observed);
        reading.of(&observed, |_| Matrix3::identity()).is_some()
    }

    /// A reaction `force` at a state: its value.
    fn reacting(
        &self,
        reading: &Reading,
        at: &Local<'_>,
        force: impl Fn(usize, Equation) -> Vector3<f64>,
    ) -> Option<(Reacting, f64)> {
        let Reading::Reaction {
            node,
            moment,
            part,
            axes,
        } = *reading
        else {
            return None;
        };
        let nodes = self.element.nodes();
        let local = |node: usize| nodes.iter().position(|own| *own == node);
        let equation = if moment {
            Equation::Moment
        } else {
            Equation::Force
        };
        let index = (local(node)?, equation);
        let turns_with = match axes {
            Axes::Model | Axes::Fixed(_) => None,
            Axes::Node(node) => local(node),
            Axes::End(end) => (end + nodes.len()).checked_sub(2),
        };
        let axes = match axes {
            Axes::Model => Matrix3::identity(),
            Axes::Fixed(axes) => axes,
            Axes::Node(_) => at.nodes[turns_with?].rotation,
            Axes::End(end) => self.element.end_axes(at)?[end],
        };
        let force = force(index.0, index.1);
        let along = axes * part.slope(&axes.tr_mul(&force));
        let turns_with = turns_with.filter(|_| part != Part::Magnitude);
        let found = Reacting {
            index,
            along,
            turns_with,
        };
        Some((found, part.in_axes(&force, &axes)))
    }

    /// Index of the scalar of the first reading.
    fn first(&self) -> usize {
        self.scalars.len() - self.readings.len()
    }

    /// Calls with the element's input, the multipliers of removed constraints at zero.
    fn with<T>(&self, at: &Local<'_>, call: impl FnOnce(&Local<'_>) -> T) -> T {
        let count = at.multipliers.len();
        let mut few = [0.0; FEW];
        let mut many = Vec::new();
        let kept = if count <= FEW {
            &mut few[..count]
        } else {
            many.resize(count, 0.0);
            &mut many[..]
        };
        kept.copy_from_slice(at.multipliers);
        self.removed.iter().for_each(|&i| kept[i] = 0.0);
        call(&Local {
            multipliers: kept,
            ..*at
        })
    }
}

impl Adapted {
    /// Adds the equations of the readings to the element's residual `acting`.
    fn add_readings(&self, at: &Local<'_>, out: &mut LocalResidual) {
        for (i, reading) in self.readings.iter().enumerate() {
            let scalar = self.first() + i;
            let force = |node, equation| out.of(node, equation);
            let value = match self.reacting(reading, at, force) {
                Some((_, value)) => Some(value),
                None => self.with(at, |at| match reading {
                    Reading::Energy(part) => Some(self.element.energy(at).part(*part)),
                    _ => self.element.read(reading, at, None),
                }),
            };
            if !reading.is_share() {
                out.add_scalar(scalar, at.scalars.values[scalar]);
            }
            out.add_scalar(scalar, -value.unwrap_or(f64::NAN));
        }
    }

    /// Adds the derivatives of these equations; `acting` is the residual of the element.
    fn add_reading_rows(&self, at: &Local<'_>, acting: &LocalResidual, out: &mut LocalJacobian) {
        for (i, reading) in self.readings.iter().enumerate() {
            let scalar = self.first() + i;
            if !reading.is_share() {
                out.add_scalar(scalar, scalar, 1.0, false);
            }
            let force = |node, equation| acting.of(node, equation);
            let reacting = self.reacting(reading, at, force);
            let mut row = ReadingRow::new(scalar, out);
            let Some((reaction, _)) = reacting else {
                self.with(at, |at| match reading {
                    Reading::Energy(part) => {
                        add_slope(self.element.as_ref(), *part, (at, acting), &mut row);
                    }
                    _ => {
                        self.element.read(reading, at, Some(&mut row));
                    }
                });
                continue;
            };
            let (node, equation) = reaction.index;
            row.by_equation(node, equation, &reaction.along);
            if let Some(turning) = reaction.turns_with {
                let slope = reaction.along.cross(&acting.of(node, equation));
                row.by_node(turning, Variable::Rotation, &slope);
            }
        }
    }
}

impl Element for Adapted {
    fn label(&self) -> &str {
        self.element.label()
    }

    fn nodes(&self) -> &[usize] {
        self.element.nodes()
    }

    fn scalars(&self) -> &[Scalar] {
        &self.scalars
    }

    fn has_kinks(&self) -> bool {
        self.element.has_kinks()
    }

    fn acts(&self) -> bool {
        self.element.acts()
    }

    fn each_signal<'a>(&'a self, visit: &mut dyn FnMut(&'a Signal)) {
        self.element.each_signal(visit);
    }

    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        let mut jacobian = jacobian;
        let mut own;
        // Readings of reactions need the residual.
        let out = if out.is_ignored() && !self.readings.is_empty() {
            own = LocalResidual::new(super::LocalSize::of(self));
            &mut own
        } else {
            out
        };
        self.with(at, |at| {
            self.element.evaluate(at, out, jacobian.as_deref_mut())
        });
        if let Some(jacobian) = jacobian.as_deref_mut() {
            self.add_reading_rows(at, out, jacobian);
        }
        self.add_readings(at, out);
        for &constraint in &self.removed {
            out.remove_constraint(constraint, at.multipliers[constraint]);
            if let Some(jacobian) = jacobian.as_deref_mut() {
                jacobian.remove_constraint(constraint);
            }
        }
    }

    fn next_own_corner(&self, time: f64) -> f64 {
        self.element.next_own_corner(time)
    }

    fn constraints(&self) -> Option<&dyn Constraints> {
        self.element.constraints().map(|_| self as &dyn Constraints)
    }

    fn memory(&self) -> Option<&dyn Memory> {
        self.element.memory().map(|_| self as &dyn Memory)
    }

    fn fixed_axes(&self) -> Option<&dyn FixedAxes> {
        self.element.fixed_axes().map(|_| self as &dyn FixedAxes)
    }

    fn settling(&self) -> Option<&dyn Settling> {
        // Its scalars are the first ones.
        self.element.settling()
    }

    fn energetic(&self) -> Option<&dyn Energetic> {
        self.element.energetic().map(|_| self as &dyn Energetic)
    }

    fn growth(&self) -> Option<&dyn Growth> {
        self.element.growth().map(|_| self as &dyn Growth)
    }

    fn structure(&self) -> Option<&dyn Structure> {
        self.element.structure().map(|_| self as &dyn Structure)
    }

    fn reports(&self) -> Option<&dyn Reports> {
        self.element.reports().map(|_| self as &dyn Reports)
    }
}

impl Constraints for Adapted {
    fn count(&self) -> usize {
        self.element.multipliers()
    }

    fn level_of(&self, constraint: usize) -> Level {
        self.element.level(constraint)
    }

    fn words_of(&self, constraint: usize) -> ConstraintWords {
        self.element.constraint_words(constraint)
    }

    fn add_rates(&self, at: &Local<'_>, out: &mut ConstraintRates<'_>) -> bool {
        let knows = self.element.constraint_rates(at, out);
        for &constraint in &self.removed {
            out.by_time[constraint] = 0.0;
            out.convective[constraint] = 0.0;
        }
        knows
    }

    fn position_jump(&self, between: [&Loading; 2], scalars: Scalars<'_>) -> Option<PositionJump> {
        self.element.jump(between, scalars)
    }

    fn held_in_place(&self, undeformed: &[NodeMotion]) -> Option<Box<dyn Element>> {
        let held = self.element.held(undeformed)?;
        let readings = self.readings.iter().copied();
        let own = self.scalars[self.first()..].iter().cloned();
        let held = Self::read(Arc::from(held), readings.zip(own).collect());
        Some(Box::new(Self {
            removed: self.removed.clone(),
            ..held
        }))
    }

    fn turned_over(&self, at: &Local<'_>) -> bool {
        self.element.is_turned_over(at)
    }

    fn axes_of_ends(&self, at: &Local<'_>) -> Option<[Matrix3<f64>; 2]> {
        self.element.end_axes(at)
    }
}

impl FixedAxes for Adapted {
    fn vectors(&self) -> Vec<FixedVector> {
        let mut vectors = self.element.fixed_vectors();
        let is_removed = |first: usize| {
            self.removed
                .iter()
                .any(|it| (first..first + 3).contains(it))
        };
        vectors.retain(|vector| match *vector {
            FixedVector::Constraints { first, .. } => !is_removed(first),
            FixedVector::Scalars { .. } => true,
        });
        vectors
    }
}

impl Memory for Adapted {
    fn size(&self) -> usize {
        self.element.memory_size()
    }

    fn begin(&self, at: &Local<'_>, memory: &mut [f64]) {
        if let Some(own) = self.element.memory() {
            self.with(at, |at| own.begin(at, memory));
        }
    }

    fn accept(&self, at: &Local<'_>, memory: &mut [f64]) {
        if let Some(own) = self.element.memory() {
            self.with(at, |at| own.accept(at, memory));
        }
    }

    fn next_change(&self, time: f64) -> f64 {
        self.element.next_corner(time)
    }
}

impl Energetic for Adapted {
    fn stored(&self, at: &Local<'_>) -> Energy {
        self.with(at, |at| self.element.energy(at))
    }

    fn exchanged(&self) -> Exchange {
        self.element.exchange()
    }

    fn is_conservative(&self) -> bool {
        self.element.keeps_energy()
    }

    fn slope(&self) -> EnergySlope {
        let own = self.element.energetic();
        own.map_or(EnergySlope::Zero, |own| own.slope())
    }
}

impl Growth for Adapted {
    fn add_by_factor(&self, at: &Local<'_>, out: &mut LocalResidual) {
        self.with(at, |at| self.element.by_factor(at, out));
        for &constraint in &self.removed {
            out.remove_constraint(constraint, 0.0);
        }
    }

    fn add_prestress(&self, at: &Local<'_>, motion: &SmallMotion<'_>, out: &mut LocalJacobian) {
        self.with(at, |at| self.element.prestress(at, motion, out));
    }
}

impl Structure for Adapted {
    fn arm(&self) -> f64 {
        self.element.reach()
    }

    fn is_joining(&self) -> bool {
        self.element.joins_nodes()
    }

    fn free_motions(&self) -> Vec<Motion> {
        self.element.motions()
    }

    fn loaded_turn(&self, at: &Local<'_>) -> Option<Vector3<f64>> {
        self.element.winding(at)
    }

    fn undefined(&self, at: &Local<'_>) -> Option<String> {
        self.element.without_value(at)
    }
}

impl Reports for Adapted {
    fn report(&self, at: &Local<'_>, out: &mut Observations) {
        self.with(at, |at| self.element.observe(at, out));
    }

    fn reading(
        &self,
        reading: &Reading,
        at: &Local<'_>,
        row: Option<&mut ReadingRow<'_>>,
    ) -> Option<f64> {
        self.with(at, |at| self.element.read(reading, at, row))
    }

    fn report_charges(&self, at: &Local<'_>, out: &mut Charges) {
        self.with(at, |at| self.element.charges(at, out));
    }
}

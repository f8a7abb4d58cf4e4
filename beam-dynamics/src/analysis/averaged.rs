//! Constant coefficients of rotors in forward flight: the equations of small motions about the periodic
//! motion, in multiblade coordinates, averaged over the period.
//!
//! With the changes d of all unknowns in space and their derivatives along the motion,
//!
//! ```text
//! E(t) d' + A(t) d = 0 ,     d = T(t) eta
//! mean( T^T E T ) eta' + mean( T^T (A T + E T') ) eta = 0                           (D-339)
//! ```
//!
//! Constraints of a joint, in whatever axes it has them, are combined by a rotation that keeps them as
//! constant as possible, and its multipliers with them.
//!
//! Coefficients of equal blades in axial flow are constant in these coordinates, and the averaged
//! equations are exact. In forward flight the harmonics of N per revolution are left out; multipliers
//! of the period have them.
//!
//! References: [ColemanFeingold1958].

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::sync::Arc;

use nalgebra::{DMatrix, Matrix3};

use crate::analysis::multiblade::{Coordinates, FEW, Factors, NoCoordinates, SlotKind};
use crate::analysis::periodic::record;
use crate::analysis::transient::{consistent_rates, independent};
use crate::assembly::{Combination, Pattern, Sparse, System, Tangent, Variation};
use crate::case::{Model, PeriodicSettings};
use crate::model::{Conditions, State};
use crate::result::{AcceptedStep, Recorder};

mod equality;
mod modes;

pub(super) use modes::{AveragedMode, averaged_modes, modes_without_air};

use equality::Equality;

/// Instants of the mean in a turn: harmonics up to their number have no mean.
const INSTANTS: usize = 24;
/// Every third instant is one of the mean without air, which only names modes.
const VACUUM: usize = 3;
/// Part of its terms below which a mean is round-off.
const ROUND_OFF: f64 = 1e-13;
/// Part of the largest singular value below which a combination of constraints is not determined.
const DETERMINED: f64 = 1e-10;

/// Averaged equations of a model.
pub(super) struct Averaged {
    /// The model without redundant constraints.
    pub model: Model,
    /// Derivatives by the multiblade coordinates of all unknowns.
    pub tangent: Tangent,
    /// The same without the forces of the air, if they are requested and act.
    vacuum: Option<Tangent>,
    coordinates: Coordinates,
}

/// The forces of the air in averaged equations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Air {
    /// They act.
    With,
    /// They act, and further equations are without them.
    WithAndWithout,
}

impl Averaged {
    /// The unknown of the first blade of which an unknown is a multiblade coordinate, and the
    /// coordinate as text; `None` for unknowns of other parts.
    pub fn coordinate(&self, unknown: usize) -> Option<(usize, String)> {
        let Coordinates {
            slots,
            slot_of,
            families,
            ..
        } = &self.coordinates;
        let slot = &slots[slot_of[unknown]];
        let (blade, family) = slot.of_blade?;
        let first = slots[*families[family].first()?].first;
        let rotor = self.coordinates.rotor_of(blade);
        let word = rotor.word(blade - rotor.first);
        Some((first + unknown - slot.first, word))
    }
}

/// Whether a model has multiblade coordinates; or the reason why not, with a remedy.
pub(super) fn possible(model: &Model) -> Result<(), [String; 2]> {
    coordinates(model).map(|_| ())
}

/// Multiblade coordinates of rotors of three or more blades each: fewer ones have periodic coefficients also
/// in these.
fn coordinates(model: &Model) -> Result<Coordinates, [String; 2]> {
    let found = Coordinates::new(model).map_err(impossible)?;
    if found.rotors.iter().any(|rotor| rotor.count < 3) {
        return Err(impossible(FEW));
    }
    Ok(found)
}

fn impossible(problem: NoCoordinates) -> [String; 2] {
    [problem.0.to_owned(), USE_FLOQUET.to_owned()]
}

/// Remedy of rotors without averaged equations.
const USE_FLOQUET: &str = "choose by = \"Floquet\", which holds for all rotors";

/// The averaged equations about the periodic motion that begins with a state; or the reason why there
/// are none, with a remedy.
pub(super) fn averaged(
    model: &Model,
    settings: &PeriodicSettings,
    state: &State,
    air: Air,
) -> Result<Averaged, [String; 2]> {
    let shared = independent(model, &settings.start)
        .map_err(|failure| [failure.to_string(), failure.remedy()])?;
    let own = shared.map(|shared| shared.model);
    let own = own.unwrap_or_else(|| model.clone());
    let coordinates = coordinates(&own)?.turning(state, settings.period);
    let mut sum = Sum {
        mean: Mean::new(&coordinates),
        vacuum: (air == Air::WithAndWithout).then(|| Mean::new(&coordinates)),
        system: &own.system,
        stride: stride(settings.steps, &coordinates, settings.period),
    };
    record(model, settings, state, &mut sum)
        .map_err(|failure| [failure.to_string(), failure.remedy()])?;
    if let Some(unknown) = sum.mean.equality.different(&coordinates) {
        let equation = own.system.equation(unknown);
        let reason = format!("the blades differ, mostly in the {equation}");
        let counts = coordinates.rotors.iter().map(|rotor| rotor.count);
        let unequal = counts.filter(|count| !settings.steps.is_multiple_of(*count));
        let remedy = match unequal.max() {
            // The blades pass the same azimuths at different parts of the steps.
            Some(count) => {
                format!("let \"steps\" be a multiple of the {count} blades, or {USE_FLOQUET}")
            }
            None => USE_FLOQUET.to_owned(),
        };
        return Err([reason, remedy]);
    }
    let (tangent, vacuum) = tangents(&sum.mean, sum.vacuum.as_ref());
    Ok(Averaged {
        model: own,
        tangent,
        vacuum,
        coordinates,
    })
}

/// The mean over the states of a period.
struct Sum<'a> {
    mean: Mean<'a>,
    /// Without the forces of the air; `None` if they do not act.
    vacuum: Option<Mean<'a>>,
    system: &'a System,
    /// Distance of the instants in steps.
    stride: usize,
}

impl Recorder for Sum<'_> {
    fn record(&mut self, step: &AcceptedStep<'_>) -> bool {
        if step.step > 0 && step.step.is_multiple_of(self.stride) {
            // Reactions and rates at the end of a step are of a lower order than the motion.
            let exact = consistent_rates(self.system, step.state, step.conditions);
            let state = exact.as_ref().unwrap_or(step.state);
            let factors = self.mean.coordinates.at(step.time, state);
            let [a, e] = linearized(self.system, state, step.conditions);
            self.mean.add(&factors, &a, &e);
            if self.mean.count % VACUUM == 1 {
                self.add_vacuum((state, step.conditions), &factors, [&a, &e]);
            }
        }
        true
    }
}

impl Sum<'_> {
    /// Adds the coefficients without air, which differ from those with air `[A, E]`.
    fn add_vacuum(
        &mut self,
        (state, at): (&State, &Conditions),
        factors: &Factors,
        air: [&Sparse; 2],
    ) {
        let Some(mean) = &mut self.vacuum else { return };
        let mut conditions = *at;
        conditions.loading.air = 0.0;
        let own = linearized(self.system, state, &conditions);
        let is_same = |(own, air): (&Sparse, &Sparse)| own.values() == air.values();
        match own.iter().zip(air).all(is_same) {
            true => self.vacuum = None,
            false => mean.add(factors, &own[0], &own[1]),
        }
    }
}

/// Whether air acts on a state.
fn air_acts(system: &System, state: &State, conditions: &Conditions) -> bool {
    let mut without = *conditions;
    without.loading.air = 0.0;
    let [with, without] = [conditions, &without].map(|at| system.by_unknowns(state, at));
    with.values() != without.values()
}

/// The distance of the instants in steps: a divisor of their number, so that there are enough in a turn of the
/// fastest rotor.
fn stride(steps: usize, coordinates: &Coordinates, period: f64) -> usize {
    let turns = coordinates
        .rotors
        .iter()
        .map(|rotor| (rotor.speed.abs() * period / TAU).round());
    let enough = INSTANTS * (turns.fold(1.0, f64::max) as usize);
    let divisors = (1..=steps).filter(|stride| steps.is_multiple_of(*stride));
    let enough = divisors.filter(|stride| steps / stride >= enough);
    enough.max().unwrap_or(1)
}

/// A and E along a motion: rotations turn the nodes, and their rates are rates of the turning nodes.
fn linearized(system: &System, state: &State, conditions: &Conditions) -> [Sparse; 2] {
    let variation = |node: &crate::model::NodeMotion| Variation {
        turn: Matrix3::identity(),
        rate_by_turn: -node.angular_velocity.cross_matrix(),
        axes: None,
    };
    let variations: Vec<_> = state.nodes.iter().map(variation).collect();
    let [mut by_unknowns, mut by_rates] =
        [(); 2].map(|()| Sparse::zero(Arc::clone(system.pattern())));
    let mut out = [
        Combination::by_unknowns(&mut by_unknowns),
        Combination::by_rates(&mut by_rates),
    ];
    let work = &mut system.workspace();
    system.combine(state, conditions, &variations, (&mut out, None), work);
    [by_unknowns, by_rates]
}

/// Derivatives of the equations of one slot by the unknowns of another: A and E.
type Block = [DMatrix<f64>; 2];
/// Blocks by pairs of slots.
type Blocks = BTreeMap<(usize, usize), Block>;

/// Sums of the coefficients in multiblade coordinates, and of their sizes, by pairs of slots.
struct Mean<'a> {
    coordinates: &'a Coordinates,
    sums: BTreeMap<(usize, usize), [Block; 2]>,
    /// Constraints at the first instant, by families or slots.
    references: BTreeMap<(bool, usize), Constraints>,
    equality: Equality,
    count: usize,
}

impl<'a> Mean<'a> {
    fn new(coordinates: &'a Coordinates) -> Self {
        Self {
            coordinates,
            sums: BTreeMap::new(),
            references: BTreeMap::new(),
            equality: Equality::default(),
            count: 0,
        }
    }

    /// Adds the coefficients at an instant.
    fn add(&mut self, factors: &Factors, by_unknowns: &Sparse, by_rates: &Sparse) {
        self.count += 1;
        let mut blocks = self.blocks([by_unknowns, by_rates]);
        for ((_, column), [a, e]) in &mut blocks {
            if let Some(turn) = factors.turn(&self.coordinates.slots[*column]) {
                let [right, rate] = turn.map(|own| dense(&own));
                *a = &*a * &right + &*e * rate;
                *e = &*e * right;
            }
        }
        let turns = self.turns(&blocks, factors);
        for ((row, column), block) in blocks {
            let block = block.map(|own| {
                let own = turns
                    .get(&row)
                    .map_or_else(|| own.clone(), |left| left * &own);
                let is_turned = self.coordinates.slots[column].kind == SlotKind::Multipliers;
                match turns.get(&column).filter(|_| is_turned) {
                    Some(right) => own * right.transpose(),
                    None => own,
                }
            });
            let slots = [row, column].map(|index| &self.coordinates.slots[index]);
            self.equality.add(slots, self.coordinates, &block);
            self.spread(factors, (row, column), &block);
        }
    }

    /// The matrices by which the equations of the slots are multiplied: equations of vectors of blades are
    /// turned to the axes of the blade, and constraints are combined so that they are as near as
    /// possible to the constraints of the first instant.
    fn turns(&mut self, blocks: &Blocks, factors: &Factors) -> BTreeMap<usize, DMatrix<f64>> {
        let slots = &self.coordinates.slots;
        let mut turns = BTreeMap::new();
        for (index, slot) in slots.iter().enumerate() {
            if let Some([turn, _]) = factors.turn(slot) {
                turns.insert(index, dense(&turn.transpose()));
            }
        }
        for (index, constraints) in constraints(self.coordinates, blocks) {
            let family = slots[index].of_blade.map(|own| own.1);
            let key = family.map_or((false, index), |family| (true, family));
            let reference = self
                .references
                .entry(key)
                .or_insert_with(|| constraints.clone());
            turns.extend(combination(reference, &constraints).map(|turn| (index, turn)));
        }
        turns
    }

    /// The blocks of two matrices by pairs of slots.
    fn blocks(&self, matrices: [&Sparse; 2]) -> Blocks {
        let Coordinates { slots, slot_of, .. } = self.coordinates;
        let mut blocks: Blocks = BTreeMap::new();
        for (number, matrix) in matrices.into_iter().enumerate() {
            for (row, column, value) in matrix.triplets().filter(|entry| entry.2 != 0.0) {
                let pair = (slot_of[row], slot_of[column]);
                let (to, from) = (&slots[pair.0], &slots[pair.1]);
                let zeros = || [(); 2].map(|()| DMatrix::zeros(to.size, from.size));
                let block = blocks.entry(pair).or_insert_with(zeros);
                block[number][(row - to.first, column - from.first)] = value;
            }
        }
        blocks
    }

    /// Adds a block to all coordinates of its slots.
    fn spread(&mut self, factors: &Factors, (row, column): (usize, usize), [a, e]: &Block) {
        for (to, [weight, _]) in self.members(row, factors) {
            for (from, [factor, rate]) in self.members(column, factors) {
                let values = [(a * factor + e * rate) * weight, e * (weight * factor)];
                let zeros = || [(); 2].map(|()| values.clone().map(|own| own * 0.0));
                let [sums, sizes] = self.sums.entry((to, from)).or_insert_with(zeros);
                for ((sum, size), value) in sums.iter_mut().zip(sizes).zip(&values) {
                    *sum += value;
                    *size += value.abs();
                }
            }
        }
    }

    /// The slots that hold the coordinates of a slot, with the factors and their rates.
    fn members(&self, slot: usize, factors: &Factors) -> Vec<(usize, [f64; 2])> {
        match self.coordinates.slots[slot].of_blade {
            None => vec![(slot, [1.0, 0.0])],
            Some((blade, family)) => {
                let members = self.coordinates.families[family].iter().copied();
                members
                    .zip(factors.harmonics[blade].iter().copied())
                    .collect()
            }
        }
    }

    /// Rows, columns and the means there, without those that are round-off of their terms.
    fn entries(&self) -> Vec<(usize, usize, [f64; 2])> {
        let slots = &self.coordinates.slots;
        let count = self.count.max(1) as f64;
        let mut entries = Vec::new();
        for ((row, column), [sums, sizes]) in &self.sums {
            for i in 0..slots[*row].size {
                for j in 0..slots[*column].size {
                    let values = [0, 1].map(|k| {
                        let (sum, size) = (sums[k][(i, j)], sizes[k][(i, j)]);
                        if sum.abs() > ROUND_OFF * size {
                            sum / count
                        } else {
                            0.0
                        }
                    });
                    if values != [0.0; 2] {
                        entries.push((slots[*row].first + i, slots[*column].first + j, values));
                    }
                }
            }
        }
        entries
    }
}

/// The means with and without air, on one pattern.
fn tangents(mean: &Mean<'_>, vacuum: Option<&Mean<'_>>) -> (Tangent, Option<Tangent>) {
    let (own, alone) = (mean.entries(), vacuum.map(Mean::entries));
    let all = own.iter().chain(alone.iter().flatten());
    let indices = all.map(|entry| (entry.0, entry.1)).collect();
    let pattern = Arc::new(Pattern::new(mean.coordinates.slot_of.len(), indices));
    let filled = |entries: Vec<(usize, usize, [f64; 2])>| {
        let [mut by_unknowns, mut by_rates] = [(); 2].map(|()| Sparse::zero(Arc::clone(&pattern)));
        for (row, column, [a, e]) in entries {
            if let Some(index) = pattern.index(row, column) {
                by_unknowns.values_mut()[index] = a;
                by_rates.values_mut()[index] = e;
            }
        }
        Tangent {
            by_unknowns,
            by_rates,
        }
    };
    (filled(own), alone.map(filled))
}

fn dense(matrix: &Matrix3<f64>) -> DMatrix<f64> {
    DMatrix::from_column_slice(3, 3, matrix.as_slice())
}

/// Derivatives of the constraints of an element, by the families or slots of the unknowns.
type Constraints = BTreeMap<usize, Block>;

/// The constraints of each element: of a blade by the unknowns of the blade, of other parts by the
/// unknowns of these.
fn constraints(coordinates: &Coordinates, blocks: &Blocks) -> BTreeMap<usize, Constraints> {
    let slots = &coordinates.slots;
    let mut found: BTreeMap<usize, Constraints> = BTreeMap::new();
    for ((row, column), block) in blocks {
        let (to, from) = (&slots[*row], &slots[*column]);
        let is_motion = from.kind == SlotKind::Vector && to.kind == SlotKind::Multipliers;
        if is_motion && to.of_blade.is_some() == from.of_blade.is_some() {
            let key = from.of_blade.map_or(*column, |own| own.1);
            found.entry(*row).or_default().insert(key, block.clone());
        }
    }
    found
}

/// The rotation Q of constraints C for which Q C is nearest to a reference, `Q = U V^T` with
/// `C_0 C^T = U S V^T`; `None` if it is not determined.
fn combination(reference: &Constraints, own: &Constraints) -> Option<DMatrix<f64>> {
    let size = own.values().next()?[0].nrows();
    let mut product = DMatrix::zeros(size, size);
    for (key, block) in own {
        let known = reference.get(key)?;
        for (known, own) in known.iter().zip(block) {
            product += known * own.transpose();
        }
    }
    if product.iter().any(|value| !value.is_finite()) {
        return None;
    }
    let parts = product.svd(true, true);
    let least = parts.singular_values.min();
    let is_full = least > DETERMINED * parts.singular_values.max();
    is_full.then(|| Some(parts.u? * parts.v_t?))?
}

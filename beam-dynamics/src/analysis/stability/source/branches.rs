//! Modes by eigenvalues at the values of the parameter, each continued to values at which it is not found.
//!
//! Where the air damps an oscillation nearly as much as it can be damped, or changes fast over the
//! parameter, no search without its shape finds it among the slow states of the air. It is continued from
//! the nearest value at which it is known, by inverse iteration from its shape there. The root t with the
//! shape y continues the root s with the shape x if
//!
//! ```text
//! |x^H y| >= 0.95 ,     |t - s| <= 0.25 |s| ,     |x| = |y| = 1                       (D-344)
//! ```
//!
//! Else the interval is halved, and the equilibrium and the mode are found at its middle first.

use super::Source;
use crate::analysis::linearized::Linearized;
use crate::modes::{Eigenpair, is_new};
use crate::solver::LinearSolver;

/// Overlap of the shapes at two values from which a mode is the same, and between the values of the last
/// halving.
const SAME: [f64; 2] = [0.95, 0.5];
/// Halvings of the distance of two values.
const HALVINGS: usize = 5;

/// Modes at a value.
#[derive(Debug, Clone)]
pub(super) struct Found {
    /// By ascending frequency.
    pub oscillations: Vec<Eigenpair>,
    /// Modes that oscillate at other values, slow to fast.
    pub overdamped: Vec<Eigenpair>,
    /// Other real values.
    pub real: Vec<Eigenpair>,
    /// Number of modes that are missing.
    lost: usize,
    /// Highest frequency of the search \[rad/s\].
    highest: f64,
}

impl Found {
    /// The modes of a search.
    pub fn new(oscillations: Vec<Eigenpair>, real: Vec<Eigenpair>, lost: usize) -> Self {
        let frequencies = oscillations.iter().map(|pair| pair.angular_frequency);
        Self {
            highest: frequencies.fold(0.0, f64::max),
            oscillations,
            overdamped: Vec::new(),
            real,
            lost,
        }
    }

    /// Modes that can be continued.
    fn pairs(&self) -> Vec<Eigenpair> {
        let all = self.oscillations.iter().chain(&self.overdamped);
        all.cloned().collect()
    }

    /// Adds a continued mode, if it is missing.
    fn add(&mut self, pair: Eigenpair) {
        if pair.angular_frequency > self.highest || !is_new(&pair, &self.pairs()) {
            return;
        }
        let (list, number): (_, fn(&Eigenpair) -> f64) = match pair.angular_frequency == 0.0 {
            true => (&mut self.overdamped, |own| own.growth.abs()),
            false => (&mut self.oscillations, |own| own.angular_frequency),
        };
        list.push(pair);
        list.sort_by(|a, b| number(a).total_cmp(&number(b)));
        self.lost = self.lost.saturating_sub(1);
    }
}

/// Modes at values.
#[derive(Debug, Default)]
pub(super) struct Branches {
    all: Vec<(f64, Found)>,
}

impl Branches {
    pub fn has(&self, at: f64) -> bool {
        self.at(at).is_some()
    }

    pub fn at(&self, at: f64) -> Option<&Found> {
        self.all.iter().find(|own| own.0 == at).map(|own| &own.1)
    }

    pub fn add(&mut self, at: f64, found: Found) {
        self.all.push((at, found));
    }

    /// The nearest other value.
    fn nearest(&self, at: f64) -> Option<f64> {
        let others = self
            .all
            .iter()
            .map(|own| own.0)
            .filter(|other| *other != at);
        others.min_by(|a, b| (a - at).abs().total_cmp(&(b - at).abs()))
    }
}

impl Source<'_> {
    /// Finds the modes at all requested values, and continues the ones that are missing: first upward,
    /// then downward. Values that fail are left out.
    pub(in super::super) fn prepare(&mut self) {
        let values = self.settings.sweep.values.clone();
        for at in &values {
            let _failed = self.find_modes(*at);
        }
        let ascending = values.windows(2).map(|pair| (pair[0], pair[1]));
        let descending = values.windows(2).rev().map(|pair| (pair[1], pair[0]));
        for (from, to) in ascending.chain(descending) {
            self.complete(from, to);
        }
    }

    /// Continues modes that are missing at a value from the nearest one.
    pub(super) fn complete_from_nearest(&mut self, at: f64) {
        if let Some(from) = self.branches.nearest(at) {
            self.complete(from, at);
        }
    }

    /// Continues modes that are missing at the value `to` from the value `from`.
    fn complete(&mut self, from: f64, to: f64) {
        let is_complete = self.branches.at(to).is_none_or(|found| found.lost == 0);
        let Some(known) = self.branches.at(from).filter(|_| !is_complete) else {
            return;
        };
        let pairs = known.pairs();
        let continued = self.continued(&pairs, (from, to), HALVINGS);
        let found = self.branches.all.iter_mut().find(|own| own.0 == to);
        if let Some((_, found)) = found {
            for pair in continued.into_iter().flatten() {
                found.add(pair);
            }
        }
    }

    /// The modes at the value `to` that continue `pairs` at the value `from`.
    fn continued(
        &mut self,
        pairs: &[Eigenpair],
        (from, to): (f64, f64),
        halvings: usize,
    ) -> Vec<Option<Eigenpair>> {
        let mut found = self.directly(pairs, to, SAME[usize::from(halvings == 0)]);
        let missing: Vec<_> = (0..pairs.len()).filter(|i| found[*i].is_none()).collect();
        if missing.is_empty() || halvings == 0 {
            return found;
        }
        let middle = 0.5 * (from + to);
        let left: Vec<_> = missing.iter().map(|i| pairs[*i].clone()).collect();
        let half = self.continued(&left, (from, middle), halvings - 1);
        let (reached, left): (Vec<_>, Vec<_>) = missing
            .into_iter()
            .zip(half)
            .filter_map(|(i, pair)| Some((i, pair?)))
            .unzip();
        let last = match left.is_empty() {
            true => Vec::new(),
            false => self.continued(&left, (middle, to), halvings - 1),
        };
        for (i, pair) in reached.into_iter().zip(last) {
            let known: Vec<_> = found.iter().flatten().cloned().collect();
            found[i] = pair.filter(|pair| is_new(pair, &known));
        }
        found
    }

    /// The same in one step; all are missing if the model at the value cannot be linearized.
    fn directly(&mut self, pairs: &[Eigenpair], to: f64, least: f64) -> Vec<Option<Eigenpair>> {
        let nothing = vec![None; pairs.len()];
        let Ok((input, steady)) = self.about(to) else {
            return nothing;
        };
        let linearized = Linearized::new(&input.model, &steady);
        let solver = LinearSolver::new(input.model.system.pattern());
        let sizes = pairs
            .iter()
            .map(|pair| pair.growth.hypot(pair.angular_frequency));
        let size = sizes.fold(f64::INFINITY, f64::min);
        let problem = linearized.problem_near(&solver, size);
        problem.map_or(nothing, |problem| problem.continued(pairs, least))
    }
}

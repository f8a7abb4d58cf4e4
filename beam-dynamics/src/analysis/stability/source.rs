//! The roots of the model at a value of the parameter.

use std::f64::consts::TAU;

use nalgebra::Complex;
use shared_geom::error::Diagnostics;

use crate::analysis::averaged::{AveragedMode, averaged_modes, modes_without_air, possible};
use crate::analysis::multiblade::pattern;
use crate::analysis::operation::Operation;
use crate::analysis::periodic::periodic_from;
use crate::analysis::stall::air_at;
use crate::analysis::trim::{Reader, Trimmed, fits, trim_at, unread};
use crate::case::{FloquetSettings, StabilityMethod, StabilitySettings, TrimSettings, Words};
use crate::input::{Input, short_number};
use crate::model::{Conditions, State};
use crate::result::{
    BoundaryKind, FloquetMode, FloquetTable, PeriodicResult, StabilityRoot, Whirl,
};

mod branches;
mod left_out;
mod of_modes;

use super::names::{Vacuum, give_names, named};
use branches::Branches;
use left_out::LeftOut;

/// Multipliers above this size are shown.
const SHOWN: f64 = 0.9;
/// Least number of roots by multipliers.
const LEAST: usize = 10;
/// First and largest number of computed multipliers.
const COMPUTED: [usize; 2] = [20, 400];
/// Growth of an oscillation, relative to its exponent, that is round-off.
const ROUND_OFF: f64 = 1e-8;
/// Growth in estimated errors up to which it is not known.
const DOUBTFUL: f64 = 2.0;

/// A failure: reason and remedy.
type Failed = [String; 2];

/// A solution at a value.
struct Known {
    at: f64,
    state: State,
    /// Values of the controls.
    controls: Vec<f64>,
}

/// The models of all values, with the solutions that are known.
pub(super) struct Source<'a> {
    settings: &'a StabilitySettings,
    trim: Option<&'a TrimSettings>,
    read: Reader<'a>,
    known: Vec<Known>,
    /// Modes by eigenvalues.
    branches: Branches,
    /// Number of multipliers to compute.
    count: usize,
    /// Least frequency up to which the oscillations of averaged equations are complete, if others
    /// may be above it [rad/s].
    complete_to: Option<f64>,
    /// Whether modes in turning axes have patterns of two blades with two frequencies in the fixed frame.
    is_double: bool,
    /// Operating points of the requested values.
    operation: Operation,
    left_out: LeftOut,
}

impl<'a> Source<'a> {
    pub fn new(
        settings: &'a StabilitySettings,
        trim: Option<&'a TrimSettings>,
        read: Reader<'a>,
    ) -> Self {
        Self {
            settings,
            trim,
            read,
            known: Vec::new(),
            branches: Branches::default(),
            count: settings.count.unwrap_or(COMPUTED[0]),
            complete_to: None,
            is_double: false,
            operation: Operation::of_averaged(settings.method == StabilityMethod::Averaged),
            left_out: LeftOut::default(),
        }
    }

    /// Whether modes in turning axes have patterns of two blades with two frequencies in the fixed frame.
    pub fn is_double(&self) -> bool {
        self.is_double
    }

    /// The remarks on operating points, on the bound of the search by averaged equations, and on roots that
    /// the number of roots leaves out.
    pub fn remarks(&self) -> Vec<String> {
        let hertz = self.complete_to.map(|bound| short_number(bound / TAU, 4));
        let bound = hertz.map(|hertz| {
            format!(
                "the oscillations are complete up to {hertz} Hz: a larger \"count\" moves this bound"
            )
        });
        let left_out = self
            .settings
            .count
            .and_then(|count| self.left_out.remark(count));
        let other = bound.filter(|_| left_out.is_none()).into_iter();
        let all = self.operation.remarks().into_iter();
        all.chain(other).chain(left_out).collect()
    }

    /// Notes the operating point of a requested value.
    fn note_operation(
        &mut self,
        at: f64,
        (input, state): (&Input, &State),
        conditions: &Conditions,
    ) {
        if self.is_requested(at) {
            let air = air_at(&input.model.system, state, conditions);
            let place = format!(
                "{} = {}",
                self.settings.sweep.parameter,
                short_number(at, 6)
            );
            self.operation.add(&place, &air, input.model.words);
        }
    }

    /// Values of the controls at a value that was evaluated.
    pub fn controls(&self, at: f64) -> Vec<f64> {
        let known = self.known_at(at);
        known.map_or_else(Vec::new, |known| known.controls.clone())
    }

    /// The result at a value that was evaluated.
    fn known_at(&self, at: f64) -> Option<&Known> {
        self.known.iter().find(|known| known.at == at)
    }

    /// The roots at a value.
    pub fn roots(&mut self, at: f64) -> Result<Vec<StabilityRoot>, Failed> {
        let mut roots = match self.settings.method {
            StabilityMethod::Modes => self.of_modes(at)?,
            StabilityMethod::Floquet => self.of_period(at)?,
            StabilityMethod::Averaged => self.of_averaged(at)?,
        };
        roots.sort_by(|a, b| b.growth().total_cmp(&a.growth()));
        if let Some(count) = self.settings.count {
            let mut sum = 0;
            let (kept, others): (Vec<_>, Vec<_>) = roots.into_iter().partition(|root| {
                sum += root.kind.roots();
                sum <= count.max(root.kind.roots())
            });
            if self.settings.method != StabilityMethod::Floquet && self.is_requested(at) {
                self.left_out.add(&kept, &others);
            }
            roots = kept;
        }
        Ok(roots)
    }

    /// The known solution nearest to a value.
    fn nearest(&self, at: f64) -> Option<&Known> {
        let off = |known: &&Known| (known.at - at).abs();
        let known = self.known.iter();
        known.min_by(|a, b| off(a).total_cmp(&off(b)))
    }

    fn keep(&mut self, at: f64, state: &State, controls: Vec<f64>) {
        if self.known_at(at).is_none() {
            self.known.push(Known {
                at,
                state: state.clone(),
                controls,
            });
        }
    }

    /// The trimmed model at a value, its state and the controls.
    fn trimmed(&mut self, at: f64, trim: &TrimSettings) -> Result<(Input, Trimmed), Failed> {
        let requested = (self.multipliers(), self.is_requested(at));
        let read = |given: &[(String, f64)]| -> Result<Input, Diagnostics> {
            let mut input = (self.read)(given)?;
            analyze_period(&mut input, requested);
            Ok(input)
        };
        let near = self.nearest(at);
        let first = trim.controls.len();
        let parameters = near.map(|near| near.controls.get(first..).unwrap_or(&[]));
        let from = (near.map(|near| &near.state), parameters);
        let given = (self.settings.sweep.parameter.as_str(), at);
        let (point, end) = trim_at((trim, &read), given, from);
        if let Some(failure) = point.failure {
            return Err(failure);
        }
        let end = end.and_then(|end| Some((end.input, end.found?, end.state?)));
        let (input, found, state) = end.ok_or_else(|| nothing("the trim has no solution"))?;
        self.keep(at, &state, point.controls);
        Ok((input, found))
    }

    /// Number of multipliers of a periodic motion that are found.
    fn multipliers(&self) -> Option<usize> {
        matches!(self.settings.method, StabilityMethod::Floquet).then_some(self.count)
    }

    fn is_requested(&self, at: f64) -> bool {
        self.settings.sweep.values.contains(&at)
    }

    fn input(&self, at: f64) -> Result<Input, Failed> {
        (self.read)(&[(self.settings.sweep.parameter.clone(), at)]).map_err(unread)
    }

    /// By the multipliers of the periodic motion, as many as are needed.
    fn of_period(&mut self, at: f64) -> Result<Vec<StabilityRoot>, Failed> {
        loop {
            let result = match self.trim {
                Some(trim) => match self.trimmed(at, trim)?.1 {
                    Trimmed::Periodic(result) => result,
                    Trimmed::Static(_) => return Err(nothing("the trim has no periodic motion")),
                },
                None => self.periodic(at)?,
            };
            let period = result.period;
            let table = result
                .floquet
                .ok_or_else(|| nothing("there are no multipliers"))?;
            let is_complete = self.settings.count.is_some()
                || self.count >= COMPUTED[1]
                || shows_all(&table, self.count);
            if is_complete {
                let input = self.input(at)?;
                self.note_period(at, &input);
                let vacuum = self.vacuum_of_period(at, &input, table.modes.len());
                return Ok(self.shown((&table, vacuum), period, counts_errors(&input)));
            }
            self.count = (2 * self.count).min(COMPUTED[1]);
        }
    }

    /// Notes the operating point of the periodic motion at a value, for which the file has been read.
    fn note_period(&mut self, at: f64, input: &Input) {
        if let Some(state) = self.known_at(at).map(|known| known.state.clone()) {
            let from = input.periodic.as_ref().map_or(0.0, |own| own.start.from);
            let conditions = input.model.conditions_at(from);
            self.note_operation(at, (input, &state), &conditions);
        }
    }

    /// The averaged modes without air about the periodic motion at a value, and whether the air has states.
    fn vacuum_of_period(&self, at: f64, input: &Input, wanted: usize) -> Vacuum {
        let (settings, known) = input.periodic.as_ref().zip(self.known_at(at))?;
        let words = input.words();
        let modes = modes_without_air(&input.model, settings, &known.state, (wanted, words))?;
        let has_states = !input.model.system.scalars().is_empty();
        Some((averaged_roots(&modes, words), has_states))
    }

    /// By the averaged equations about the periodic motion.
    fn of_averaged(&mut self, at: f64) -> Result<Vec<StabilityRoot>, Failed> {
        let mut input = self.input(at)?;
        possible(&input.model)?;
        match self.trim {
            Some(trim) => input = self.trimmed(at, trim)?.0,
            None => drop(self.periodic(at)?),
        }
        let both = input.periodic.as_ref().zip(self.known_at(at));
        let (settings, known) = both.ok_or_else(|| nothing("there is no periodic motion"))?;
        let words = input.words();
        let wanted = COMPUTED[0].max(self.settings.count.unwrap_or(0));
        let found = averaged_modes(&input.model, settings, &known.state, (wanted, words))?;
        self.note_period(at, &input);
        let is_counted = self.settings.count.is_some();
        if let Some(last) = found.complete_to {
            let known = self.complete_to.unwrap_or(f64::INFINITY);
            self.complete_to = Some(known.min(last));
        }
        let mut modes = found.modes;
        modes.retain(|mode| is_counted || mode.named.oscillates || mode.is_slow);
        let has_states = !input.model.system.scalars().is_empty();
        let vacuum = found.vacuum.map(|modes| averaged_roots(&modes, words));
        let vacuum = vacuum.map(|modes| (modes, has_states));
        Ok(named(averaged_roots(&modes, words), vacuum))
    }

    /// The periodic motion from the nearest known one, or from the start of the file.
    fn periodic(&mut self, at: f64) -> Result<PeriodicResult, Failed> {
        let mut input = self.input(at)?;
        let requested = (self.multipliers(), self.is_requested(at));
        analyze_period(&mut input, requested);
        let settings = input
            .periodic
            .as_ref()
            .ok_or_else(|| nothing("[periodic] is missing"))?;
        let near = self.nearest(at).map(|near| &near.state);
        let near = near.filter(|state| fits(state, &input.model));
        let mut outcome = periodic_from(&input.model, settings, near);
        if outcome.failure.is_some() && near.is_some() {
            outcome = periodic_from(&input.model, settings, None);
        }
        match (outcome.failure, outcome.state) {
            (Some(failure), _) => Err([failure.to_string(), failure.remedy()]),
            (None, None) => Err(nothing("there is no periodic motion")),
            (None, Some(state)) => {
                self.keep(at, &state, Vec::new());
                Ok(outcome.result)
            }
        }
    }

    /// The roots of the large multipliers, or all if their number is given.
    fn shown(
        &self,
        (table, vacuum): (&FloquetTable, Vacuum),
        period: f64,
        doubts: bool,
    ) -> Vec<StabilityRoot> {
        let modes = table.modes.iter();
        let mut roots: Vec<_> = modes
            .map(|mode| root_of_period(mode, period, doubts))
            .collect();
        // The shapes for names are in multiblade coordinates.
        let mut shapes: Vec<_> = table
            .modes
            .iter()
            .map(|mode| mode.in_coordinates.clone())
            .collect();
        let exchange = |roots: &mut [StabilityRoot], shapes: &mut [_]| {
            let both = roots.iter_mut().zip(shapes);
            both.for_each(|(root, shape)| std::mem::swap(&mut root.shape, shape));
        };
        exchange(&mut roots, &mut shapes);
        give_names(&mut roots, vacuum);
        exchange(&mut roots, &mut shapes);
        // The table is by falling size.
        roots.sort_by(|a, b| b.growth().total_cmp(&a.growth()));
        let mut sum = 0;
        roots.retain(|root| {
            let size = root.multiplier.map_or(0.0, |own| own.norm());
            let is_shown = self.settings.count.is_some() || sum < LEAST || size > SHOWN;
            sum += root.multiplier.map_or(1, roots_of);
            is_shown
        });
        roots
    }
}

/// Whether errors of multipliers count as doubt of their growth: if the file requests the estimate.
fn counts_errors(input: &Input) -> bool {
    let own = input.periodic.as_ref().and_then(|own| own.floquet.as_ref());
    own.is_some_and(|own| own.estimates_error)
}

/// Requests `count` multipliers of the periodic motion, or none, with errors at requested values unless the
/// file omits them.
fn analyze_period(input: &mut Input, (count, is_requested): (Option<usize>, bool)) {
    let words = input.words();
    if let Some(settings) = &mut input.periodic {
        let own = settings.floquet.take();
        settings.floquet = count.map(|count| FloquetSettings {
            count,
            near: own.as_ref().map_or_else(Vec::new, |own| own.near.clone()),
            estimates_error: own.as_ref().map_or(is_requested, |own| own.estimates_error),
            words,
        });
    }
}

/// Whether no multiplier above the shown size is missing in a table of `count`.
fn shows_all(table: &FloquetTable, count: usize) -> bool {
    let found: usize = table
        .modes
        .iter()
        .map(|mode| roots_of(mode.multiplier))
        .sum();
    let smallest = table.modes.iter().map(|mode| mode.multiplier.norm());
    found < count || smallest.fold(f64::INFINITY, f64::min) < SHOWN
}

/// Roots of a multiplier, with its conjugate.
fn roots_of(multiplier: Complex<f64>) -> usize {
    if multiplier.im == 0.0 { 1 } else { 2 }
}

fn nothing(reason: &str) -> Failed {
    let remedy = "let the cards of the analyses not depend on the parameter";
    [reason.to_owned(), remedy.to_owned()]
}

/// Modes of averaged equations; their frequencies are the ones in the fixed frame.
fn averaged_roots(modes: &[AveragedMode], words: Words) -> Vec<StabilityRoot> {
    let roots = modes.iter().map(|mode| averaged_root(mode, words));
    roots.collect()
}

fn averaged_root(mode: &AveragedMode, words: Words) -> StabilityRoot {
    let named = &mode.named;
    let whirl = named.whirl.filter(Whirl::is_pure);
    let is_real = mode.exponent.im == 0.0;
    StabilityRoot {
        doubt: if is_real {
            0.0
        } else {
            ROUND_OFF * mode.exponent.norm()
        },
        name: named.name.clone(),
        in_blades: named.in_blades,
        pattern: Some(pattern(named.whirl, words)),
        // An overdamped whirl continues either of two conjugate ones.
        waves: whirl.filter(|_| named.oscillates).map(|own| own.harmonic),
        blades: Some(named.whirl.map_or(0, |own| own.blades)),
        shape: mode.motion.parts().map(<[_]>::to_vec),
        ..StabilityRoot::new(mode.exponent)
    }
}

/// A multiplier of the periodic motion; with `doubts` its growth is not known up to its error.
fn root_of_period(mode: &FloquetMode, period: f64, doubts: bool) -> StabilityRoot {
    let kind = match mode.multiplier {
        own if own.im != 0.0 => BoundaryKind::Flutter,
        own if own.re > 0.0 => BoundaryKind::Divergence,
        _ => BoundaryKind::HalfRate,
    };
    let floor = ROUND_OFF * mode.exponent.norm().max(1.0 / period);
    StabilityRoot {
        multiplier: Some(mode.multiplier),
        kind,
        doubt: match mode.error.filter(|_| doubts) {
            Some(error) => floor.max(DOUBTFUL * error),
            None => floor,
        },
        error: mode.error,
        is_neutral: mode.is_neutral,
        share: mode.share,
        fundamental: TAU / period,
        others: mode.others.clone(),
        name: mode.name.clone(),
        in_blades: mode.in_blades,
        pattern: mode.pattern.clone(),
        blades: mode.blades,
        shape: [mode.shape.clone(), mode.shape.clone()],
        ..StabilityRoot::new(mode.exponent)
    }
}

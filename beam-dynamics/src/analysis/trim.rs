//! Trim: numbers that are found so that means of the motion, or quantities of an equilibrium, have given
//! values, and sweeps of them.
//!
//! 1. For each value of the sweep the file is read with this value.
//! 2. Controls that are unknowns of the model are found with its periodic motion or its equilibrium,
//!    from the last solution.
//! 3. Controls that are parameters of the file are found around that, by Broyden's method.

use shared_geom::error::Diagnostics;

use crate::analysis::operation::Operation;
use crate::analysis::periodic::periodic_watched;
use crate::analysis::stall::air_at;
use crate::analysis::statics::{point, static_step};
use crate::case::{Model, Sweep, TrimControl, TrimMethod, TrimSettings};
use crate::elements::AirState;
use crate::input::{Input, short_number};
use crate::model::State;
use crate::result::{PeriodicPass, PeriodicResult, StaticResult, TrimPoint, TrimResult};

mod balanced;
mod broyden;
mod reason;

pub(super) use balanced::small_motions;
use broyden::Range;

/// Reads the file with other values of parameters.
pub type Reader<'a> = &'a dyn Fn(&[(String, f64)]) -> Result<Input, Diagnostics>;

/// The motion or the equilibrium of a trim.
#[derive(Debug)]
pub enum Trimmed {
    /// A motion.
    Periodic(PeriodicResult),
    /// An equilibrium.
    Static(StaticResult),
}

/// The model at the end of a trim, with its state.
#[derive(Debug)]
pub struct TrimEnd {
    /// The input with the parameters at the end.
    pub input: Input,
    /// The first state of the motion, or the equilibrium; the last one that was found.
    pub state: Option<State>,
    /// The motion or the equilibrium; `None` if there is no equilibrium.
    pub found: Option<Trimmed>,
}

impl TrimEnd {
    /// The strips in the air in the equilibrium, or at the start of the period.
    fn air(&self) -> Vec<AirState> {
        let model = &self.input.model;
        let trim = self.input.trim.as_ref();
        let conditions = match (&self.found, &self.input.periodic, trim) {
            (Some(Trimmed::Periodic(_)), Some(periodic), _) => {
                model.conditions_at(periodic.start.from)
            }
            (Some(Trimmed::Static(_)), _, Some(trim)) => balanced::conditions(model, trim),
            _ => return Vec::new(),
        };
        let state = self.state.as_ref();
        state.map_or_else(Vec::new, |state| air_at(&model.system, state, &conditions))
    }
}

/// Result of a trim, and its last model.
#[derive(Debug)]
pub struct TrimOutcome {
    /// The points.
    pub result: TrimResult,
    /// The last model.
    pub end: Option<TrimEnd>,
}

/// The solution of one model with given parameters.
struct Solved {
    end: TrimEnd,
    controls: Vec<f64>,
    /// Values found and required.
    targets: Vec<[f64; 2]>,
    iterations: usize,
    residual: f64,
    failure: Option<[String; 2]>,
}

/// Progress of a trim.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrimProgress {
    /// Number of points that are done, and of all.
    pub points: [usize; 2],
    /// Value of the parameter of the sweep at the present point, if there is one \[its unit\].
    pub at: Option<f64>,
    /// Iterations, or periods, of the present point.
    pub passes: usize,
    /// The last change or error, relative to its size [-].
    pub residual: f64,
}

/// The trim requested by `settings`, of the file that `read` reads.
pub fn trim(name: &str, settings: &TrimSettings, read: Reader<'_>) -> TrimOutcome {
    trim_watched(name, settings, read, &mut |_| {})
}

/// The same; `watch` is called after each iteration or period.
pub fn trim_watched(
    name: &str,
    settings: &TrimSettings,
    read: Reader<'_>,
    watch: &mut dyn FnMut(TrimProgress),
) -> TrimOutcome {
    let sweep = settings.sweep.as_ref();
    let values: Vec<_> = match sweep {
        None => vec![None],
        Some(sweep) => sweep.values.iter().copied().map(Some).collect(),
    };
    let mut result = without_points(name, settings, values.len());
    let mut search = Search {
        settings,
        read,
        given: Vec::new(),
        parameters: None,
        from: None,
    };
    let (mut end, mut operation) = (None, Operation::without_stall());
    let requested = values.len();
    for (done, at) in values.into_iter().enumerate() {
        let mut passes = 0;
        let mut of_point = |pass: &PeriodicPass| {
            passes += 1;
            watch(TrimProgress {
                points: [done, requested],
                at,
                passes,
                residual: pass.residual,
            });
        };
        search.given = sweep
            .zip(at)
            .map(|(sweep, value)| (sweep.parameter.clone(), value))
            .into_iter()
            .collect();
        let (point, last) = search.point(at, &mut of_point);
        let is_met = point.failure.is_none();
        result.remarks.extend(stalled(sweep.zip(at), last.as_ref()));
        if let Some(end) = last.as_ref().filter(|_| is_met) {
            operation.add(&place(sweep.zip(at)), &end.air(), end.input.model.words);
        }
        result.points.push(point);
        end = last.or(end);
        search.from = end.as_ref().and_then(|end| end.state.clone());
        if !is_met {
            break;
        }
    }
    result.remarks.extend(operation.remarks());
    TrimOutcome { result, end }
}

/// Stall at a point, as a remark.
fn stalled(at: Option<(&Sweep, f64)>, end: Option<&TrimEnd>) -> Option<String> {
    let end = end?;
    let (found, when) = match &end.found {
        Some(Trimmed::Periodic(found)) => (found.stall, "over the period"),
        Some(Trimmed::Static(_)) => (balanced::stall(end), "in the equilibrium"),
        None => (None, ""),
    };
    let text = found.filter(|own| own.part > 0.0)?.text(when);
    Some(match at {
        Some(_) => format!("at {}: {text}", place(at)),
        None => text,
    })
}

/// The value of a sweep as text.
fn place(at: Option<(&Sweep, f64)>) -> String {
    at.map_or_else(String::new, |(sweep, value)| {
        format!("{} = {}", sweep.parameter, short_number(value, 9))
    })
}

/// The result of a trim before its first point.
fn without_points(name: &str, settings: &TrimSettings, requested: usize) -> TrimResult {
    let controls = settings.controls.iter().chain(&settings.parameters);
    let targets = settings.targets.iter();
    TrimResult {
        name: name.to_owned(),
        method: match settings.method {
            TrimMethod::Shooting => "periodic motion by shooting",
            TrimMethod::AutoPilot => "periodic motion by an auto-pilot",
            TrimMethod::Equilibrium => "equilibrium in the turning frame",
        },
        sweep: settings.sweep.as_ref().map(|sweep| sweep.parameter.clone()),
        requested,
        controls: controls.map(|control| control.name.clone()).collect(),
        targets: targets.map(|target| target.name.clone()).collect(),
        points: Vec::new(),
        remarks: Vec::new(),
    }
}

/// The trim at one value of a parameter, from a state of a similar model and values of the controls that
/// are parameters, if they are known; and its model unless the file cannot be read.
pub(super) fn trim_at(
    (settings, read): (&TrimSettings, Reader<'_>),
    given: (&str, f64),
    (from, parameters): (Option<&State>, Option<&[f64]>),
) -> (TrimPoint, Option<TrimEnd>) {
    let mut search = Search {
        settings,
        read,
        given: vec![(given.0.to_owned(), given.1)],
        parameters: parameters.map(<[f64]>::to_vec),
        from: from.cloned(),
    };
    search.point(Some(given.1), &mut |_| {})
}

/// The search at one point, with the results of the point before.
struct Search<'a> {
    settings: &'a TrimSettings,
    read: Reader<'a>,
    /// The parameter of the sweep with its value.
    given: Vec<(String, f64)>,
    /// Values of the controls that are parameters.
    parameters: Option<Vec<f64>>,
    /// The last state.
    from: Option<State>,
}

impl Search<'_> {
    /// The point, and its model unless the file cannot be read.
    fn point(
        &mut self,
        at: Option<f64>,
        watch: &mut dyn FnMut(&PeriodicPass),
    ) -> (TrimPoint, Option<TrimEnd>) {
        let (solved, failure, outer) = if self.settings.parameters.is_empty() {
            match self.solved(&[], watch) {
                Ok(solved) => (Some(solved), None, 0),
                Err(failure) => (None, Some(failure), 0),
            }
        } else {
            self.around(watch)
        };
        let empty = TrimPoint {
            at,
            controls: Vec::new(),
            targets: Vec::new(),
            iterations: outer,
            residual: f64::NAN,
            failure: None,
        };
        let Some(solved) = solved else {
            return (TrimPoint { failure, ..empty }, None);
        };
        // The residual of the model does not contain the targets of parameters.
        let errors = self.errors(&solved).into_iter().map(f64::abs);
        let residual = errors.fold(solved.residual, f64::max);
        let mut controls = solved.controls;
        controls.extend(self.parameters.iter().flatten());
        let point = TrimPoint {
            controls,
            targets: solved.targets,
            iterations: outer + solved.iterations,
            residual,
            failure: failure.or(solved.failure),
            ..empty
        };
        (point, Some(solved.end))
    }

    /// Finds the parameters around the solutions of the models.
    fn around(
        &mut self,
        watch: &mut dyn FnMut(&PeriodicPass),
    ) -> (Option<Solved>, Option<[String; 2]>, usize) {
        let parameters = &self.settings.parameters;
        let ranges: Vec<_> = parameters.iter().map(range).collect();
        let begun = match self.parameters.clone() {
            Some(known) => Ok(known),
            None => (self.read)(&self.given)
                .map_err(unread)
                .map(|input| guesses(&input)),
        };
        let mut x = match begun {
            Ok(x) => x,
            Err(failure) => return (None, Some(failure), 0),
        };
        let mut last = None;
        let limits = (self.settings.tolerance, self.settings.iterations);
        let (stop, iterations) = {
            let mut evaluate = |x: &[f64]| {
                let solved = self.solved(x, watch)?;
                if let Some(failure) = &solved.failure {
                    let failure = failure.clone();
                    last = Some(solved);
                    return Err(failure);
                }
                self.from = solved.end.state.clone().or(self.from.take());
                let errors = self.errors(&solved);
                last = Some(solved);
                Ok(errors)
            };
            broyden::solve(&mut evaluate, &mut x, &ranges, limits)
        };
        let errors = last.as_ref().map(|last| self.errors(last));
        let errors = errors.unwrap_or_default();
        let still = || last.as_ref().and_then(|last| at_rest(&last.end.input));
        let failure = reason::of_end(stop, self.settings, (&x, &errors), &still);
        self.parameters = Some(x);
        (last, failure, iterations)
    }

    /// Errors of the targets of the parameters, in their sizes.
    fn errors(&self, solved: &Solved) -> Vec<f64> {
        let first = self.settings.controls.len();
        let own = solved
            .targets
            .iter()
            .zip(&self.settings.targets)
            .skip(first);
        own.map(|([found, required], target)| (found - required) / target.scale)
            .collect()
    }

    /// The solution with given values of the parameters, from the last state, or else from the start of
    /// the file.
    fn solved(
        &self,
        parameters: &[f64],
        watch: &mut dyn FnMut(&PeriodicPass),
    ) -> Result<Solved, [String; 2]> {
        let names = self.settings.parameters.iter().map(|one| one.name.clone());
        let given = self
            .given
            .iter()
            .cloned()
            .chain(names.zip(parameters.iter().copied()));
        let given: Vec<_> = given.collect();
        let again = || (self.read)(&given).map_err(unread);
        let found = solve(again()?, self.from.as_ref(), watch);
        if found.failure.is_some() && self.from.is_some() {
            Ok(solve(again()?, None, watch))
        } else {
            Ok(found)
        }
    }
}

/// Why controls have no effect on the air of a model in equilibrium, as text, if it is at rest.
fn at_rest(input: &Input) -> Option<&'static str> {
    let settings = input.trim.as_ref()?;
    let is_static = settings.method == TrimMethod::Equilibrium;
    is_static.then(|| balanced::at_rest(&input.model, settings))?
}

/// The first guesses of the parameters of a file.
fn guesses(input: &Input) -> Vec<f64> {
    let settings = input.trim.as_ref();
    settings.map_or_else(Vec::new, |settings| settings.guesses.clone())
}

/// Whether a state has the unknowns of a model.
pub(super) fn fits(state: &State, model: &Model) -> bool {
    let system = &model.system;
    state.nodes.len() == system.nodes().len() && state.scalars.len() == system.scalars().len()
}

/// The failure of a file with other parameters.
pub(super) fn unread(problems: Diagnostics) -> [String; 2] {
    let remedy =
        "choose values of the parameters for which the file is sound, or bounds of controls";
    let text = problems.to_string();
    let text = text.strip_prefix("error: ").unwrap_or(&text);
    [text.to_owned(), remedy.to_owned()]
}

fn range(control: &TrimControl) -> Range {
    Range {
        scale: control.scale,
        bounds: control.bounds,
        step: control.step,
    }
}

/// Finds the controls that are unknowns of the model.
fn solve(input: Input, from: Option<&State>, watch: &mut dyn FnMut(&PeriodicPass)) -> Solved {
    let is_static = input
        .trim
        .as_ref()
        .is_some_and(|own| own.method == TrimMethod::Equilibrium);
    let from = from.filter(|state| fits(state, &input.model));
    if is_static {
        in_equilibrium(input, from)
    } else {
        in_motion(input, from, watch)
    }
}

/// By the periodic motion.
fn in_motion(input: Input, from: Option<&State>, watch: &mut dyn FnMut(&PeriodicPass)) -> Solved {
    let mut solved = Solved::nothing(input);
    let end = &mut solved.end;
    let Some(settings) = &end.input.periodic else {
        return solved;
    };
    let outcome = periodic_watched(&end.input.model, settings, from, watch);
    let result = outcome.result;
    solved.controls = result.controls.iter().map(|own| own.1).collect();
    let required = settings.targets.iter().map(|target| target.value);
    let found = result.targets.iter().copied();
    solved.targets = found
        .zip(required)
        .map(|(found, required)| [found, required])
        .collect();
    solved.iterations = result.passes.len().saturating_sub(1);
    // Targets are known if the last pass is of the controls.
    let last = result.passes.last().filter(|_| !result.targets.is_empty());
    solved.residual = last.map_or(f64::NAN, |pass| pass.residual);
    solved.failure = outcome
        .failure
        .map(|failure| [failure.to_string(), failure.remedy()]);
    (end.state, end.found) = (outcome.state, Some(Trimmed::Periodic(result)));
    solved
}

/// By the equilibrium.
fn in_equilibrium(input: Input, from: Option<&State>) -> Solved {
    let mut solved = Solved::nothing(input);
    let end = &mut solved.end;
    let (model, Some(settings)) = (&end.input.model, &end.input.trim) else {
        return solved;
    };
    let told =
        |failure: &balanced::NotBalanced| Some([failure.to_string(), failure.remedy().to_owned()]);
    match balanced::balanced(model, settings, from) {
        Err(failure) => solved.failure = told(&failure),
        Ok(found) => {
            let labels = settings.controls.iter().map(|control| &control.label);
            solved.controls = balanced::values(model, &found.state, labels);
            let labels = settings.targets.iter().map(|target| &target.label);
            let values = balanced::values(model, &found.state, labels).into_iter();
            let required = settings.targets.iter().map(|target| target.value);
            solved.targets = values
                .zip(required)
                .map(|(found, required)| [found, required])
                .collect();
            (solved.iterations, solved.residual) = (found.iterations, found.residual);
            end.state = Some(found.state.clone());
            if let Some(failure) = balanced::beyond_bound(settings, &solved.controls) {
                solved.failure = told(&failure);
                return solved;
            }
            let conditions = balanced::conditions(model, settings);
            let mut result = StaticResult::new(model, settings.speed);
            let step = static_step(model, &conditions, point(&conditions, found));
            result.steps.push(step);
            end.found = Some(Trimmed::Static(result));
        }
    }
    solved
}

impl Solved {
    /// Without a solution.
    fn nothing(input: Input) -> Self {
        Self {
            end: TrimEnd {
                input,
                state: None,
                found: None,
            },
            controls: Vec::new(),
            targets: Vec::new(),
            iterations: 0,
            residual: f64::NAN,
            failure: None,
        }
    }
}

//! Periodic motion, and its stability.
//!
//! 1. The model starts as a run in time does.
//! 2. The motion that repeats after a period is found by marching, or by Newton's method for its
//!    first state with the linearized steps of the period.
//! 3. The period is integrated once more for the recorder.
//! 4. The largest multipliers of the linearized period show its stability.
//!
//! All steps are of Radau IIA: on systems with constraints the map of such a step adds nothing but
//! multipliers of zero; two-step formulas add some that hide true ones.

use crate::analysis::frozen::frozen;
use crate::analysis::operation::Operation;
use crate::analysis::stall::{StallSum, air_at};
use crate::analysis::transient::{Multibody, Started, independent, start};
use crate::case::{FloquetSettings, Model, PeriodicMethod, PeriodicSettings};
use crate::elements::Queries;
use crate::integrator::Dae;
use crate::model::{Conditions, State};
use crate::result::{AcceptedStep, FloquetTable, PeriodicPass, PeriodicResult, Recorder, Stall};
use crate::solver::Largest;

mod approach;
mod border;
mod content;
mod equal;
mod failure;
mod floquet;
mod flow;
mod map;
mod march;
mod passes;
mod pilot;
mod shooting;
mod sizes;
mod step_error;

pub use failure::PeriodicFailure;

use border::Border;
use content::{InBlades, Observer};
use floquet::Monodromy;
use flow::{Flow, Passed};
use passes::Passes;
use shooting::{Orbit, Shooting};

/// Factors of the number of steps with which a period of the start is marched if it fails.
const FINER: [usize; 4] = [2, 4, 8, 16];
/// Periods that are marched before a second search without controls, if the first one does not converge: one
/// period may leave parts far from the motion.
const SETTLED: usize = 5;
/// Least steps of the second analysis for the estimate of errors.
const LEAST_STEPS: usize = 8;

/// Outcome of an analysis; the states of the period are passed to the recorder.
#[derive(Debug)]
pub struct PeriodicOutcome {
    /// The result.
    pub result: PeriodicResult,
    /// The first state of the motion, or the last state of the search.
    pub state: Option<State>,
    /// Reason if no periodic motion was found.
    pub failure: Option<PeriodicFailure>,
}

/// Finds the periodic motion of `model` requested by `settings`, passes the states of a period to
/// `recorder`, and finds its multipliers.
pub fn periodic(
    model: &Model,
    settings: &PeriodicSettings,
    recorder: &mut dyn Recorder,
) -> PeriodicOutcome {
    let mut outcome = periodic_from(model, settings, None);
    let state = outcome.state.as_ref().filter(|_| outcome.failure.is_none());
    if let Some(Err(failure)) = state.map(|state| record(model, settings, state, recorder)) {
        outcome.failure = Some(failure);
    }
    outcome
}

/// The same from a state of the model, if one is given, and without a recorder.
pub fn periodic_from(
    model: &Model,
    settings: &PeriodicSettings,
    from: Option<&State>,
) -> PeriodicOutcome {
    periodic_watched(model, settings, from, &mut |_| {})
}

/// The same; `watch` is called after each iteration or period.
pub(super) fn periodic_watched(
    model: &Model,
    settings: &PeriodicSettings,
    from: Option<&State>,
    watch: &mut dyn FnMut(&PeriodicPass),
) -> PeriodicOutcome {
    let mut result = PeriodicResult {
        name: model.name.clone(),
        period: settings.period,
        steps: settings.steps,
        stages: settings.stages(),
        passes: Vec::new(),
        is_periodic: false,
        periods: 0,
        controls: Vec::new(),
        targets: Vec::new(),
        floquet: None,
        stall: None,
        remarks: Vec::new(),
    };
    let mut state = from.cloned();
    let failure = find((model, settings), &mut state, &mut result, watch).err();
    PeriodicOutcome {
        result,
        state,
        failure,
    }
}

/// Finds the motion from a state, if one is given, and leaves its first state, or the last state of the
/// search, in its place.
fn find(
    (model, settings): (&Model, &PeriodicSettings),
    place: &mut Option<State>,
    result: &mut PeriodicResult,
    watch: &mut dyn FnMut(&PeriodicPass),
) -> Result<(), PeriodicFailure> {
    check_memory(model, settings)?;
    let shared = independent(model, &settings.start)?;
    let model = match &shared {
        None => model,
        Some(shared) => {
            result.remarks.extend(shared.remarks());
            &shared.model
        }
    };
    let is_given = place.is_some();
    if !is_given {
        let Started { state, remarks, .. } = start(model, &settings.start)?;
        result.remarks.extend(remarks);
        *place = Some(state);
    }
    let Some(state) = place.as_mut() else {
        return Ok(());
    };
    let border = Border::new(model, settings)?;
    let mut flow = Flow::new(model, settings, settings.steps, state);
    note_corners(&flow, result);
    let conditions = model.conditions_at(settings.start.from);
    let algebraic = algebraic(model, state);
    let sizes = sizes::sizes(model, (state, &conditions), &algebraic, settings.period);
    let shooting = Shooting {
        model,
        settings,
        border: &border,
        sizes: &sizes,
    };
    let found = search(
        (&shooting, &algebraic),
        &mut flow,
        (state, if is_given { 0 } else { settings.settle }),
        &mut Passes::new(&mut result.passes, watch),
    );
    result.periods = flow.periods;
    let first = found.as_ref().map_or(&*state, Found::first);
    result.controls = controls_at(&border, settings, first);
    let (end, stall) = shown(&mut flow, &shooting, first);
    result.stall = stall;
    let found = found.map_err(|failure| {
        let passes = &mut Passes::new(&mut result.passes, watch);
        result.targets = ended(&shooting, state, (end, &algebraic), passes);
        failure.with_stall(stall)
    })?;
    result.is_periodic = true;
    state.copy_from(found.first());
    result.targets = border.reached(found.end());
    let remarks = operation(model, (state, &conditions), stall);
    result.remarks.extend(remarks);
    result.floquet = stability(&shooting, &mut flow, found)?;
    Ok(())
}

/// Remarks on the operating point of the first instant; with known stall without its own.
fn operation(
    model: &Model,
    (state, conditions): (&State, &Conditions),
    stall: Option<Stall>,
) -> Vec<String> {
    let mut operation = match stall {
        Some(_) => Operation::without_stall(),
        None => Operation::default(),
    };
    let air = air_at(&model.system, state, conditions);
    operation.add("", &air, model.words);
    operation.remarks()
}

/// Finds the motion by the requested method from a state, which becomes the last state of the search,
/// after some periods that are marched.
fn search(
    (shooting, algebraic): (&Shooting<'_>, &[bool]),
    flow: &mut Flow<'_>,
    (state, settle): (&mut State, usize),
    passes: &mut Passes<'_>,
) -> Result<Found, PeriodicFailure> {
    let marched = |ends: [State; 2]| Found::Marched(Box::new(ends));
    let settings = shooting.settings;
    match (settings.method, settings.pilot) {
        (_, Some(own)) => {
            settled(shooting, flow, (state, settle))?;
            pilot::pilot(shooting, flow, (state, own), passes).map(marched)
        }
        (PeriodicMethod::Shooting, None) => {
            let begun = state.clone();
            settled(shooting, flow, (state, settle))?;
            let mut found = approach::approach(shooting, flow, state, passes);
            let is_far = matches!(found, Err(PeriodicFailure::NotConverged { .. }));
            if is_far && shooting.border.count() == 0 && settle < SETTLED {
                let mut later = begun;
                if settled(shooting, flow, (&mut later, SETTLED)).is_ok() {
                    *state = later;
                    found = approach::approach(shooting, flow, state, passes);
                }
            }
            found.map(|orbit| Found::Shot(Box::new(orbit)))
        }
        (PeriodicMethod::March, None) => {
            let at = (state.clone(), algebraic, shooting.sizes);
            march::march(flow, (shooting.model, settings), at, passes).map(marched)
        }
    }
}

/// A periodic motion, by either method.
enum Found {
    Marched(Box<[State; 2]>),
    Shot(Box<Orbit>),
}

impl Found {
    /// Its first state.
    fn first(&self) -> &State {
        match self {
            Self::Marched(ends) => &ends[0],
            Self::Shot(orbit) => &orbit.state,
        }
    }

    /// The state a period later, rates and multipliers included.
    fn end(&self) -> &State {
        match self {
            Self::Marched(ends) => &ends[1],
            Self::Shot(orbit) => &orbit.end,
        }
    }
}

fn check_memory(model: &Model, settings: &PeriodicSettings) -> Result<(), PeriodicFailure> {
    let is_marched = settings.method == PeriodicMethod::March && settings.pilot.is_none();
    let is_linearized = !is_marched || settings.floquet.is_some();
    let mut elements = model.system.elements();
    match elements.find(|element| is_linearized && element.memory_size() > 0) {
        None => Ok(()),
        Some(element) => Err(PeriodicFailure::Memory {
            element: element.label().to_owned(),
        }),
    }
}

/// Notes drives that have corners within steps.
fn note_corners(flow: &Flow<'_>, result: &mut PeriodicResult) {
    let count = flow.corners_in_steps();
    if count > 0 {
        result.remarks.push(format!(
            "drives have corners within {count} of {} steps, where the order of the formula is \
             lower: choose \"steps\" so that steps end at the corners",
            flow.steps()
        ));
    }
}

/// Whether each unknown of the integration has no rate.
fn algebraic(model: &Model, state: &State) -> Vec<bool> {
    let dae = Multibody::new(model, [state.clone(), state.clone()], (1, false));
    dae.algebraic().to_vec()
}

/// Marches some periods from a state, which becomes the last one; a period that fails is marched again
/// with shorter steps, because a start far from the periodic motion moves faster than this.
fn settled(
    shooting: &Shooting<'_>,
    flow: &mut Flow<'_>,
    (state, periods): (&mut State, usize),
) -> Result<(), PeriodicFailure> {
    let settings = shooting.settings;
    for _ in 0..periods {
        let mut found = flow.run(state, &mut |_| true);
        for factor in FINER {
            if found.is_err() {
                let steps = settings.steps * factor;
                let mut finer = Flow::new(shooting.model, settings, steps, state);
                found = finer.run(state, &mut |_| true);
                flow.periods += usize::from(found.is_ok());
            }
        }
        *state = found?;
    }
    Ok(())
}

/// Passes the states of the period that begins at `state` to the recorder: the first is the end of the
/// period before, with its rates.
///
/// # Errors
/// A step that fails, or a recorder that ends the run.
pub fn record(
    model: &Model,
    settings: &PeriodicSettings,
    state: &State,
    recorder: &mut dyn Recorder,
) -> Result<(), PeriodicFailure> {
    let shared = independent(model, &settings.start)?;
    let model = shared.as_ref().map_or(model, |shared| &shared.model);
    let flow = &mut Flow::new(model, settings, settings.steps, state);
    let end = flow.run(state, &mut |_| true)?;
    let mut goes_on = flow.first(&end, &mut |passed| recorder.record(&accepted(passed)));
    if goes_on {
        flow.run(state, &mut |passed| {
            goes_on = recorder.record(&accepted(passed));
            goes_on
        })?;
    }
    if goes_on {
        Ok(())
    } else {
        Err(PeriodicFailure::Recorder)
    }
}

fn accepted<'a>(passed: &Passed<'a>) -> AcceptedStep<'a> {
    AcceptedStep {
        step: passed.step,
        time: passed.time,
        length: passed.length,
        iterations: passed.iterations,
        state: passed.state,
        conditions: passed.conditions,
    }
}

/// Names and values of the controls at a state.
fn controls_at(border: &Border, settings: &PeriodicSettings, state: &State) -> Vec<(String, f64)> {
    let names = settings.controls.iter().map(|control| control.name.clone());
    names.zip(border.values(state)).collect()
}

/// The means in the period from the last state of a search that failed, whose controls are reported, to its end, if
/// there is one; the period becomes the last pass.
fn ended(
    shooting: &Shooting<'_>,
    state: &State,
    (end, algebraic): (Option<State>, &[bool]),
    passes: &mut Passes<'_>,
) -> Vec<f64> {
    let Some(end) = end else {
        return Vec::new();
    };
    let last = shooting.pass(state, (&end, algebraic));
    let reached = last.reached.clone();
    let before = passes.list().last();
    if before.is_none_or(|before| before.reached != reached) {
        passes.push(last);
    }
    reached
}

/// The end of the period that begins with a state, and stall of the blades as far as the period can be
/// integrated, if there are targets.
fn shown(
    flow: &mut Flow<'_>,
    shooting: &Shooting<'_>,
    state: &State,
) -> (Option<State>, Option<Stall>) {
    if shooting.border.unknowns().is_empty() {
        return (None, None);
    }
    let mut sum = StallSum::new(&shooting.model.system);
    let (periods, mut begun) = (flow.periods, state.clone());
    shooting.border.begin(&mut begun);
    // A period that fails has shown the states before.
    let whole = flow.run(&begun, &mut |passed| {
        sum.add(passed.state, passed.conditions);
        true
    });
    flow.periods = periods;
    (whole.ok(), sum.found())
}

/// The multipliers, if they are requested.
fn stability(
    shooting: &Shooting<'_>,
    flow: &mut Flow<'_>,
    found: Found,
) -> Result<Option<FloquetTable>, PeriodicFailure> {
    let Some(settings) = &shooting.settings.floquet else {
        return Ok(None);
    };
    let Shooting {
        model,
        border,
        sizes,
        ..
    } = *shooting;
    let orbit = match found {
        Found::Shot(orbit) => orbit,
        Found::Marched(ends) => {
            let [first, _] = *ends;
            let (end, map) = flow.linearized(&first)?;
            let map = map.ok_or(PeriodicFailure::SingularStep)?;
            Box::new(Orbit {
                state: first,
                end,
                map,
            })
        }
    };
    let conditions = model.conditions_at(shooting.settings.start.from);
    let tangent = model.system.tangent(&orbit.state, &conditions);
    let [by_unknowns, by_rates] = [&tangent.by_unknowns, &tangent.by_rates];
    let mut held = border.unknowns();
    held.extend(frozen(by_unknowns, by_rates, model.system.numbering()));
    let fine = Monodromy {
        map: &orbit.map,
        sizes,
        held: &held,
    };
    let largest =
        floquet::multipliers(&fine, settings.count).ok_or(PeriodicFailure::NoMultipliers)?;
    let (mass, masses) = sizes::masses(model, (&orbit.end, &conditions));
    let observer = Observer {
        model,
        in_blades: InBlades::new(model, (&orbit.end, mass), flow.period()),
        period: flow.period(),
        masses,
        words: settings.words,
    };
    let coarse = coarse(shooting, &fine, (&orbit.state, flow.steps() / 2), settings);
    let coarse = (coarse.as_ref(), shooting.settings.stages());
    Ok(Some(floquet::table(
        (&fine, &largest),
        settings,
        &observer,
        coarse,
    )))
}

/// The multipliers of the periodic motion near the first state `state` in a number of steps, if an
/// estimate of errors is requested.
fn coarse(
    shooting: &Shooting<'_>,
    fine: &Monodromy<'_>,
    (state, steps): (&State, usize),
    settings: &FloquetSettings,
) -> Option<Largest> {
    if !settings.estimates_error || steps < LEAST_STEPS {
        return None;
    }
    let mut flow = Flow::new(shooting.model, shooting.settings, steps, state);
    let orbit = shooting
        .solve(
            &mut flow,
            &mut state.clone(),
            &mut Passes::new(&mut Vec::new(), &mut |_| {}),
        )
        .ok()?;
    let map = &orbit.map;
    floquet::multipliers(&Monodromy { map, ..*fine }, settings.count)
}

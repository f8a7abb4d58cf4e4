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

use crate::analysis::transient::{Multibody, Started, independent, start};
use crate::case::{FloquetSettings, Model, PeriodicMethod, PeriodicSettings};
use crate::elements::Queries;
use crate::integrator::Dae;
use crate::model::State;
use crate::modes::Largest;
use crate::result::{AcceptedStep, FloquetTable, PeriodicPass, PeriodicResult, Recorder};

mod border;
mod content;
mod failure;
mod floquet;
mod flow;
mod map;
mod march;
mod shooting;
mod sizes;

pub use failure::PeriodicFailure;

use border::Border;
use content::Observer;
use floquet::Monodromy;
use flow::{Flow, Passed};
use shooting::{Orbit, Shooting};

/// Least steps of the second analysis for the estimate of errors.
const LEAST_STEPS: usize = 8;

/// Outcome of an analysis; the states of the period are passed to the recorder.
#[derive(Debug)]
pub struct PeriodicOutcome {
    /// The result.
    pub result: PeriodicResult,
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
    let mut result = PeriodicResult {
        name: model.name.clone(),
        period: settings.period,
        steps: settings.steps,
        stages: settings.stages(),
        passes: Vec::new(),
        is_periodic: false,
        periods: 0,
        controls: Vec::new(),
        floquet: None,
        remarks: Vec::new(),
    };
    let failure = find(model, settings, recorder, &mut result).err();
    PeriodicOutcome { result, failure }
}

fn find(
    model: &Model,
    settings: &PeriodicSettings,
    recorder: &mut dyn Recorder,
    result: &mut PeriodicResult,
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
    let Started { state, remarks, .. } = start(model, &settings.start)?;
    result.remarks.extend(remarks);
    let border = Border::new(model, settings)?;
    let mut flow = Flow::new(model, settings, settings.steps, &state);
    note_corners(&flow, result);
    let conditions = model.conditions_at(settings.start.from);
    let algebraic = algebraic(model, &state);
    let sizes = sizes::sizes(model, (&state, &conditions), &algebraic, settings.period);
    let shooting = Shooting {
        model,
        settings,
        border: &border,
        sizes: &sizes,
    };
    let found = match settings.method {
        PeriodicMethod::Shooting => shoot(&shooting, &mut flow, state, &mut result.passes),
        PeriodicMethod::March => {
            let at = (state, &algebraic[..], &sizes[..]);
            march::march(&mut flow, (model, settings), at, &mut result.passes)
                .map(|ends| Found::Marched(Box::new(ends)))
        }
    };
    result.periods = flow.periods;
    let found = found?;
    result.is_periodic = true;
    result.controls = border.values(found.first());
    record(&mut flow, &found, recorder)?;
    result.periods = flow.periods;
    result.floquet = stability(&shooting, &mut flow, found)?;
    Ok(())
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
    let is_linearized = settings.method == PeriodicMethod::Shooting || settings.floquet.is_some();
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

/// Marches some periods, then shoots.
fn shoot(
    shooting: &Shooting<'_>,
    flow: &mut Flow<'_>,
    mut state: State,
    passes: &mut Vec<PeriodicPass>,
) -> Result<Found, PeriodicFailure> {
    for _ in 0..shooting.settings.settle {
        state = flow.run(&state, &mut |_| true)?;
    }
    let orbit = shooting.solve(flow, state, passes)?;
    Ok(Found::Shot(Box::new(orbit)))
}

/// Passes the states of the period to the recorder: the first is the end of the period before.
fn record(
    flow: &mut Flow<'_>,
    found: &Found,
    recorder: &mut dyn Recorder,
) -> Result<(), PeriodicFailure> {
    let mut goes_on = flow.first(found.end(), &mut |passed| {
        recorder.record(&accepted(passed))
    });
    if goes_on {
        flow.run(found.first(), &mut |passed| {
            goes_on = recorder.record(&accepted(passed));
            goes_on
        })?;
    }
    match goes_on {
        true => Ok(()),
        false => Err(PeriodicFailure::Recorder),
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
    let held = border.unknowns();
    let fine = Monodromy {
        map: &orbit.map,
        sizes,
        held: &held,
    };
    let largest =
        floquet::multipliers(&fine, settings.count).ok_or(PeriodicFailure::NoMultipliers)?;
    let conditions = model.conditions_at(shooting.settings.start.from);
    let observer = Observer {
        model,
        speed: shooting.settings.speed,
        period: flow.period(),
        masses: sizes::masses(model, (&orbit.end, &conditions)),
    };
    let coarse = coarse(shooting, &fine, (&orbit.state, flow.steps() / 2), settings);
    // Halved steps have 2^p times the error of the exponents, p = 2 s - 1.
    let factor = (1 << (2 * shooting.settings.stages() - 1)) - 1;
    let coarse = coarse.as_ref().map(|coarse| (coarse, factor));
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
        .solve(&mut flow, state.clone(), &mut Vec::new())
        .ok()?;
    let map = &orbit.map;
    floquet::multipliers(&Monodromy { map, ..*fine }, settings.count)
}

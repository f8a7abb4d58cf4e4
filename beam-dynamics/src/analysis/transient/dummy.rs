//! First rates and multipliers by dummy steps.
//!
//! A few very short steps from the first state damp the errors of its rates, multipliers and
//! scalars; only these are kept, and the run starts from the first state.
//!
//! References: [Masarati], section 4.3.

use crate::case::{Model, TransientSettings};
use crate::integrator::{Integrator, Scheme, Stepping};
use crate::model::State;

use super::failure::TransientFailure;
use super::multibody::Multibody;

/// Number of the steps.
const STEPS: usize = 5;
/// Their length, as a part of the first step of the run.
const PART: f64 = 1e-3;

/// `state` with the rates of momenta and the multipliers of a few very short steps.
pub(super) fn dummy_rates(
    model: &Model,
    settings: &TransientSettings,
    state: &State,
) -> Result<State, TransientFailure> {
    let first = match settings.stepping {
        Stepping::Constant { step } => step,
        Stepping::Variable(control) => control.first,
    };
    let step = PART * first;
    let (scheme, stepping) = (Scheme::Bdf2, Stepping::Constant { step });
    let stages = scheme.formula(1.0).stages;
    let mut dae = Multibody::new(model, [state.clone(), state.clone()], (stages, false));
    let mut integrator = Integrator::new(&dae, scheme, stepping, settings.newton, settings.from);
    let end = settings.from + STEPS as f64 * step;
    // More steps if one had to be cut.
    while integrator.time() < end {
        integrator
            .step(&mut dae, end, &|| 0.0)
            .map_err(|failure| TransientFailure::Dummy(Box::new(failure)))?;
    }
    let mut found = state.clone();
    for (node, after) in found.nodes.iter_mut().zip(&dae.state().nodes) {
        node.momentum_rate = after.momentum_rate;
        node.angular_momentum_rate = after.angular_momentum_rate;
    }
    found.multipliers.copy_from_slice(&dae.state().multipliers);
    found.scalars.copy_from_slice(&dae.state().scalars);
    found
        .scalar_rates
        .copy_from_slice(&dae.state().scalar_rates);
    Ok(found)
}

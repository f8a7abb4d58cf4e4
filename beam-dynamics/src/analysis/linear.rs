//! The linear model of small motions: the minimal form of the linearized equations.
//!
//! About an equilibrium y_0 in the turning frame the changes d of all unknowns fulfill
//!
//! ```text
//! F_y' d' + F_y d + F_u u = 0                                                      (D-333)
//! ```
//!
//! 1. The equilibrium is found, or trimmed.
//! 2. Inputs lose their own equations, which hold them; an input that moves a joint becomes a state, and
//!    so does its rate: the derivative is the input.
//! 3. [`minimal`] finds the states, and all unknowns by states and inputs, of which outputs are rows.

use faer::Mat;
use nalgebra::{Complex, DMatrix};

use crate::analysis::averaged::{Air, Averaged, averaged};
use crate::analysis::periodic::periodic_from;
use crate::analysis::steady::{NoEquilibrium, equilibrium, free_equilibrium, rpm};
use crate::analysis::trim::{Reader, small_motions, trim};
use crate::assembly::{System, redundancy};
use crate::case::{LinearAbout, LinearPort, LinearSettings, Model};
use crate::input::Input;
use crate::model::{Conditions, Name, State};
use crate::modes::highest_of_a_node;
use crate::result::{LinearModel, LinearVariable};
use crate::solver::{DescriptorState, LinearSolver, Minimal, NotMinimal, minimal};

mod inputs;

use inputs::Augmented;

/// Unknowns up to which the equations are solved as a whole: in minutes.
const LARGEST: usize = 4000;
/// Remainder of the equations above which a loss of digits is reported.
const TRUSTED: f64 = 1e-9;

/// Why there is no linear model.
#[derive(Debug, thiserror::Error)]
pub enum LinearFailure {
    /// No linear model was requested with the input.
    #[error("the input was read without the request of a linear model")]
    NotRequested,
    /// No equilibrium.
    #[error(transparent)]
    Equilibrium(#[from] Box<NoEquilibrium>),
    /// The trim failed: reason and remedy.
    #[error("the trim failed: {}", .0[0])]
    Trim([String; 2]),
    /// No averaged equations: reason and remedy.
    #[error("there are no averaged equations: {}", .0[0])]
    Period([String; 2]),
    /// Too many unknowns.
    #[error(
        "the model has {unknowns} unknowns, expected at most {LARGEST}: states are chosen among them \
         by full matrices"
    )]
    Large {
        /// Their number.
        unknowns: usize,
    },
    /// The equations do not determine an unknown.
    #[error("small motions about the equilibrium do not determine {0}")]
    Undetermined(String),
    /// An input acts by more than its second derivative.
    #[error("the input \"{0}\" acts by more than its second derivative")]
    Jump(String),
    /// The derivatives have no value.
    #[error("the derivatives about the equilibrium are not finite")]
    NotFinite,
}

impl LinearFailure {
    /// The likeliest remedy.
    pub fn remedy(&self) -> String {
        let text = match self {
            Self::NotRequested => "read it with inputs and outputs",
            Self::Equilibrium(_) => {
                "give the model an equilibrium: change the loads, the speed, or hold the motion"
            }
            Self::Trim([_, remedy]) | Self::Period([_, remedy]) => return remedy.clone(),
            Self::Large { .. } => {
                "use fewer elements, or one blade; modes and stability have no such limit"
            }
            Self::Undetermined(_) => {
                "give it mass or stiffness, or remove joints that hold the same motion twice"
            }
            Self::Jump(_) => "let an [[actuator]] follow it, and use the name of the actuator",
            Self::NotFinite => "change the laws or the loads so that they have slopes there",
        };
        text.to_owned()
    }
}

/// A point of operation.
struct Operation<'a> {
    model: &'a Model,
    settings: &'a LinearSettings,
    state: &'a State,
    conditions: Conditions,
    about: String,
    /// The equations in multiblade coordinates, in place of those about the state.
    averaged: Option<&'a Averaged>,
}

/// The linear model that was requested with `input`; `read` reads the file again for trims.
///
/// # Errors
/// [`LinearFailure`].
pub fn linearize(input: &Input, read: Reader<'_>) -> Result<LinearModel, LinearFailure> {
    let model = &input.model;
    let settings = input.linear.as_ref().ok_or(LinearFailure::NotRequested)?;
    let (speed, proportional) = match settings.about {
        LinearAbout::Trim => return trimmed(input, read),
        LinearAbout::Period => return of_period(input),
        LinearAbout::Equilibrium {
            speed,
            proportional,
        } => (speed, proportional),
    };
    let conditions = model.conditions(speed, 1.0, proportional);
    let solver = LinearSolver::new(model.system.pattern());
    let rest = (
        &model.conditions(0.0, 1.0, proportional),
        &model.system.rest(),
    );
    let steady = equilibrium(model, &solver, rest, &conditions)
        .or_else(|failure| free_equilibrium(model, &solver, &conditions).ok_or(failure))?;
    of(&Operation {
        model,
        settings,
        state: &steady.state,
        conditions,
        about: format!("the equilibrium at {}", rpm(speed)),
        averaged: None,
    })
}

/// About the equilibrium of the trim.
fn trimmed(input: &Input, read: Reader<'_>) -> Result<LinearModel, LinearFailure> {
    let mut own = input.trim.clone().ok_or(LinearFailure::NotRequested)?;
    own.sweep = None;
    let outcome = trim(&input.model.name, &own, read);
    let failure = outcome
        .result
        .points
        .into_iter()
        .find_map(|point| point.failure);
    if let Some(failure) = failure {
        return Err(LinearFailure::Trim(failure));
    }
    let end = outcome.end.ok_or(LinearFailure::NotRequested)?;
    let (model, state) = (&end.input.model, end.state.as_ref());
    let settings = end.input.linear.as_ref();
    let (conditions, speed) = small_motions(&end.input).ok_or(LinearFailure::NotRequested)?;
    of(&Operation {
        model,
        settings: settings.ok_or(LinearFailure::NotRequested)?,
        state: state.ok_or(LinearFailure::NotRequested)?,
        conditions,
        about: format!("the equilibrium of the trim at {}", rpm(speed)),
        averaged: None,
    })
}

/// About the periodic motion, by averaged multiblade coefficients.
fn of_period(input: &Input) -> Result<LinearModel, LinearFailure> {
    let both = input.periodic.as_ref().zip(input.linear.as_ref());
    let (periodic, settings) = both.ok_or(LinearFailure::NotRequested)?;
    let outcome = periodic_from(&input.model, periodic, None);
    if let Some(failure) = outcome.failure {
        return Err(LinearFailure::Period([
            failure.to_string(),
            failure.remedy(),
        ]));
    }
    let state = outcome.state.ok_or(LinearFailure::NotRequested)?;
    let averaged =
        averaged(&input.model, periodic, &state, Air::With).map_err(LinearFailure::Period)?;
    let speed = periodic.speed.unwrap_or(0.0);
    of(&Operation {
        model: &averaged.model,
        settings,
        state: &state,
        conditions: averaged.model.conditions_at(periodic.start.from),
        about: format!(
            "the periodic motion at {}, in multiblade coordinates averaged over it",
            rpm(speed)
        ),
        averaged: Some(&averaged),
    })
}

/// The linear model about a point of operation.
fn of(at: &Operation<'_>) -> Result<LinearModel, LinearFailure> {
    let (state, conditions) = (at.state, &at.conditions);
    let redundant = match at.averaged {
        None => redundancy::find(&at.model.system, state, conditions),
        Some(_) => Vec::new(),
    };
    let removed: Vec<_> = redundant.iter().map(|found| found.constraint).collect();
    let system = &at.model.system.without(&removed);
    let unknowns = system.numbering().unknowns();
    if unknowns > LARGEST {
        return Err(LinearFailure::Large { unknowns });
    }
    let own;
    let tangent = match at.averaged {
        Some(averaged) => &averaged.tangent,
        None => {
            own = system.tangent(state, conditions);
            &own
        }
    };
    let rate = highest_of_a_node(tangent, system.nodes().len()).unwrap_or(1.0);
    let first = system.numbering().first_scalar();
    let places = at
        .settings
        .inputs
        .iter()
        .map(|port| first + index(system, port));
    let mut augmented = Augmented::new(tangent, unknowns, places.collect());
    let found = loop {
        match minimal(&augmented.descriptor(tangent), rate) {
            Ok(found) => break found,
            Err(NotMinimal::NotFinite) => return Err(LinearFailure::NotFinite),
            Err(NotMinimal::Undetermined(index)) => {
                let name = named(index, &augmented, at, system).to_string();
                return Err(LinearFailure::Undetermined(name));
            }
            Err(NotMinimal::Prescribed(input)) if augmented.integrate(input) => {}
            Err(NotMinimal::Prescribed(input)) => {
                let name = at.settings.inputs[input].name.clone();
                return Err(LinearFailure::Jump(name));
            }
        }
    };
    let mut remarks = remarks(&found, (&augmented, at.settings));
    let without = redundant.iter().map(|one| {
        format!("{one}: its reaction is zero, and the others carry all loads of the loop")
    });
    remarks.extend(without);
    Ok(made(at, system, (&augmented, &found), remarks))
}

/// Index of the scalar of an input or output among the scalars of a system.
fn index(system: &System, port: &LinearPort) -> usize {
    let mut scalars = system.scalars().iter();
    scalars
        .position(|scalar| *scalar == port.scalar)
        .unwrap_or(0)
}

/// The name of an unknown of the augmented equations.
fn named(unknown: usize, augmented: &Augmented, at: &Operation<'_>, system: &System) -> Name {
    match augmented.integral(unknown) {
        Some((input, order)) => {
            let port = &at.settings.inputs[input];
            Name::of_system(
                inputs::words(&port.name, order),
                inputs::unit(&port.unit, order),
            )
        }
        None => {
            let origin = augmented.origin(unknown);
            let coordinate = at.averaged.and_then(|own| own.coordinate(origin));
            match coordinate {
                Some((first, word)) => {
                    let name = system.unknown(first);
                    Name::of_system(format!("{word} of {name}"), name.unit.to_string())
                }
                None => system.unknown(origin),
            }
        }
    }
}

fn remarks(found: &Minimal, (augmented, settings): (&Augmented, &LinearSettings)) -> Vec<String> {
    let degrees = augmented.degrees().iter().zip(&settings.inputs);
    let moving = degrees.filter(|(degree, _)| **degree > 0);
    let of_input = |(degree, port): (&usize, &LinearPort)| {
        let (name, words) = (&port.name, inputs::words(&port.name, *degree));
        let states = match degree {
            1 => "is a state",
            _ => "and its rate are states",
        };
        format!(
            "\"{name}\" moves a joint or acts by its rate: {words} is the input, and {name} {states}"
        )
    };
    let mut remarks: Vec<_> = moving.map(of_input).collect();
    if found.residual > TRUSTED {
        remarks.push(format!(
            "digits are lost (relative residual {:.1e}): stiffnesses, masses or lengths of very \
             different size meet in the model",
            found.residual
        ));
    }
    remarks
}

/// Rows of outputs: unknowns of the system, by states or inputs.
fn rows(
    (augmented, outputs): (&Augmented, &[usize]),
    (by, of_input): (&Mat<f64>, f64),
) -> DMatrix<f64> {
    DMatrix::from_fn(outputs.len(), by.ncols(), |i, j| {
        match augmented.index(outputs[i]) {
            Ok(unknown) => by[(unknown, j)],
            // The output is an input itself.
            Err(input) if input == j => of_input,
            Err(_) => 0.0,
        }
    })
}

/// States, inputs and outputs.
fn variables(
    at: &Operation<'_>,
    system: &System,
    (augmented, states): (&Augmented, &[DescriptorState]),
) -> [Vec<LinearVariable>; 3] {
    let settings = at.settings;
    let value = |port: &LinearPort| at.state.scalars.get(index(system, port)).copied();
    let state = |state: &DescriptorState| {
        let name = named(state.unknown, augmented, at, system);
        let part = if state.is_part {
            "part with rate of "
        } else {
            ""
        };
        LinearVariable {
            unit: name.unit.to_string(),
            name: format!("{part}{name}"),
            value: None,
        }
    };
    let degrees = augmented.degrees().iter();
    let input = |(port, degree): (&LinearPort, &usize)| LinearVariable {
        name: inputs::words(&port.name, *degree),
        unit: inputs::unit(&port.unit, *degree),
        value: match degree {
            0 => value(port),
            _ => Some(0.0),
        },
    };
    let output = |port: &LinearPort| LinearVariable {
        name: port.name.clone(),
        unit: port.unit.clone(),
        value: value(port),
    };
    [
        states.iter().map(state).collect(),
        settings.inputs.iter().zip(degrees).map(input).collect(),
        settings.outputs.iter().map(output).collect(),
    ]
}

fn made(
    at: &Operation<'_>,
    system: &System,
    (augmented, found): (&Augmented, &Minimal),
    remarks: Vec<String>,
) -> LinearModel {
    let first = system.numbering().first_scalar();
    let outputs = at.settings.outputs.iter();
    let unknowns: Vec<_> = outputs.map(|port| first + index(system, port)).collect();
    let [states, inputs, outputs] = variables(at, system, (augmented, &found.states));
    let dense =
        |matrix: &Mat<f64>| DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| matrix[(i, j)]);
    LinearModel {
        name: at.model.name.clone(),
        about: at.about.clone(),
        speed: at.conditions.frame.angular_velocity.norm(),
        states,
        inputs,
        outputs,
        a: dense(&found.a),
        b: dense(&found.b),
        c: rows((augmented, &unknowns), (&found.by_states, 0.0)),
        d: rows((augmented, &unknowns), (&found.by_inputs, 1.0)),
        eigenvalues: found
            .eigenvalues
            .iter()
            .map(|own| Complex::new(own.re, own.im))
            .collect(),
        residual: found.residual,
        remarks,
    }
}

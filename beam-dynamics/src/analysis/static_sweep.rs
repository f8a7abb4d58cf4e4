//! Equilibria over a parameter: the file is read with each value, and the equilibrium is found from
//! the one at the value before, or from rest if that fails.

use super::operation::Operation;
use super::statics::{StaticOutcome, statics_from};
use super::trim::{Reader, fits, unread};
use crate::case::{StaticSettings, Sweep};
use crate::elements::RotorAir;
use crate::input::{Input, short_number};
use crate::model::State;
use crate::result::{StaticSweep, StaticSweepPoint, TipMotion};

/// Equilibria at all values of `sweep`, of the file that `read` reads; `watch` is called before each
/// value with its index.
pub fn static_sweep(
    name: &str,
    sweep: &Sweep,
    read: Reader<'_>,
    watch: &mut dyn FnMut(usize),
) -> StaticSweep {
    let mut last: Option<State> = None;
    let mut operation = Operation::default();
    let mut result = StaticSweep {
        name: name.to_owned(),
        parameter: sweep.parameter.clone(),
        points: Vec::new(),
        remarks: Vec::new(),
    };
    for (index, at) in sweep.values.iter().copied().enumerate() {
        watch(index);
        let given = [(sweep.parameter.clone(), at)];
        let point = match read(&given) {
            Ok(input) => {
                let (point, base) = found(&input, at, last.as_ref());
                last = base.or(last);
                let step = point.path.as_ref().and_then(|path| path.last());
                if let Some(step) = step.filter(|_| point.failure.is_none()) {
                    let place = format!("{} = {}", sweep.parameter, short_number(at, 6));
                    operation.add(&place, &step.air, input.model.words);
                }
                point
            }
            Err(problems) => StaticSweepPoint {
                failure: Some(unread(problems)),
                ..empty(at)
            },
        };
        add_remarks(&mut result, &point);
        result.points.push(point);
    }
    result.remarks.extend(operation.remarks());
    result
}

/// A point without an equilibrium.
fn empty(at: f64) -> StaticSweepPoint {
    StaticSweepPoint {
        at,
        parameters: Vec::new(),
        rotors: Vec::new(),
        tips: Vec::new(),
        path: None,
        failure: None,
    }
}

/// The equilibrium of a model, and the state from which the next one may be found.
fn found(input: &Input, at: f64, from: Option<&State>) -> (StaticSweepPoint, Option<State>) {
    let Some(settings) = &input.statics else {
        let failure = [
            "the file has no [static]",
            "let it not depend on the parameter",
        ];
        let failure = Some(failure.map(str::to_owned));
        return (
            StaticSweepPoint {
                failure,
                ..empty(at)
            },
            None,
        );
    };
    let outcome = nearby(input, settings, from);
    let failure = outcome.failure.as_ref();
    let failure = failure.map(|own| [own.to_string(), own.remedy().to_owned()]);
    let path = outcome.result;
    let axis = input.model.frame_rotation.axis;
    let last = path.last();
    let tips = last.map_or_else(Vec::new, |step| {
        let blades = input.model.blades.iter();
        blades
            .filter_map(|blade| TipMotion::of(blade, (&path, step), &axis))
            .collect()
    });
    let rotors = last.map_or_else(Vec::new, |step| RotorAir::all(&step.air));
    let point = StaticSweepPoint {
        at,
        parameters: input.parameters.clone(),
        rotors,
        tips,
        path: Some(path),
        failure,
    };
    (point, outcome.base)
}

/// The load path from a similar state, or else from rest.
fn nearby(input: &Input, settings: &StaticSettings, from: Option<&State>) -> StaticOutcome {
    let model = &input.model;
    let from = from.filter(|state| fits(state, model));
    let outcome = statics_from(model, settings, from);
    if outcome.base.is_none() && from.is_some() {
        return statics_from(model, settings, None);
    }
    outcome
}

/// Adds the remarks of a point that no point before had.
fn add_remarks(result: &mut StaticSweep, point: &StaticSweepPoint) {
    let known = result.points.iter().flat_map(|own| &own.path);
    let known: Vec<_> = known.flat_map(|own| own.remarks.clone()).collect();
    let own = point.path.iter().flat_map(|own| &own.remarks);
    for remark in own.filter(|remark| !known.contains(remark)) {
        let at = short_number(point.at, 6);
        let text = format!("{} = {at}: {remark}", result.parameter);
        result.remarks.push(text);
    }
}

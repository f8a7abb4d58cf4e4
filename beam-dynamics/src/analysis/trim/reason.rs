//! Reasons of the ends of a search for parameters of the file.

use shared_geom::error::counted;

use super::broyden::Stop;
use crate::analysis::effects;
use crate::case::TrimSettings;
use crate::input::short_number;

/// The reason of an end at numbers `x` with errors of their targets, in the sizes of these, and its remedy;
/// `None` of a solution. `still` is the reason why controls of a model at rest have no effect.
pub(super) fn of_end(
    stop: Stop<[String; 2]>,
    settings: &TrimSettings,
    (x, errors): (&[f64], &[f64]),
    still: &dyn Fn() -> Option<&'static str>,
) -> Option<[String; 2]> {
    let targets = &settings.targets[settings.controls.len()..];
    let worst = || {
        let pairs = errors.iter().zip(targets);
        let worst = pairs.max_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
        worst.map_or_else(String::new, |(error, target)| {
            let off = short_number(error * target.scale, 4);
            format!("\"{}\" is off by {off}", target.name)
        })
    };
    let at = || {
        let names = settings.parameters.iter().zip(x);
        let each = names.map(|(own, x)| format!("{} = {}", own.name, short_number(*x, 6)));
        each.collect::<Vec<_>>().join(", ")
    };
    let text = match stop {
        Stop::Met => return None,
        Stop::Failed(failure) => return Some(failure),
        Stop::Beyond([failure, remedy]) => {
            let text = format!(
                "no trim is found beyond {}, where {}: {failure}",
                at(),
                worst()
            );
            return Some([text, remedy]);
        }
        Stop::Bound(index, bound) => {
            let name = &settings.parameters[index].name;
            format!(
                "the control \"{name}\" reaches its bound {bound}, and {}",
                worst()
            )
        }
        Stop::Singular(response) => {
            let of_parameters = (&response, effects::EXACT);
            let idle = effects::idle(of_parameters, &settings.parameters, targets);
            let idle = idle.map(|idle| idle + still().unwrap_or_default());
            idle.unwrap_or_else(|| format!("the controls do not lead to the targets: {}", worst()))
        }
        Stop::Nearest => format!(
            "no change of the controls comes nearer to the targets than {}: {}",
            at(),
            worst()
        ),
        Stop::Iterations => format!(
            "the targets are not met after {}: {} at {}",
            counted(settings.iterations, "iteration"),
            worst(),
            at()
        ),
    };
    let remedy = "give first guesses nearer to the trim, replace a control, or move its bound";
    Some([text, remedy.to_owned()])
}

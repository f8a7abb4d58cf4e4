//! The last lines of a run: its steps and its times by phase.

use crate::input::short_number;
use crate::output::text::aligned;
use crate::result::Effort;

/// Steps, iterations and times of a run as a table.
pub fn effort_text(effort: &Effort) -> String {
    let each = |count: usize, of: usize| match of {
        0 => String::new(),
        of => format!("{:.2} a step", count as f64 / of as f64),
    };
    let row = |name: &str, value: String, note: String| vec![name.to_owned(), value, note];
    let length = if effort.least_step == effort.most_step {
        seconds(effort.least_step)
    } else {
        format!(
            "{} to {}",
            seconds(effort.least_step),
            seconds(effort.most_step)
        )
    };
    let counts = [
        row("steps", effort.steps.to_string(), format!("of {length}")),
        row(
            "rejected",
            effort.rejected.to_string(),
            "tried again with shorter ones".to_owned(),
        ),
        row(
            "iterations",
            effort.iterations.to_string(),
            each(effort.iterations, effort.steps),
        ),
        row(
            "Jacobians",
            effort.jacobians.to_string(),
            each(effort.jacobians, effort.steps),
        ),
        row(
            "pivotings",
            effort.pivotings.to_string(),
            "factorizations that chose new pivots".to_owned(),
        ),
    ];
    let mut text = String::from("Effort\n\n");
    for [name, value, note] in counts.map(|row| <[String; 3]>::try_from(row).unwrap_or_default()) {
        text.push_str(format!("{name:<10}  {value:>8}  {note}").trim_end());
        text.push('\n');
    }
    text + "\n" + &times(effort)
}

/// Time by phase, with its share and the time per iteration.
fn times(effort: &Effort) -> String {
    let phases = [
        ("prediction", effort.prediction_time),
        ("residuals", effort.residual_time),
        ("Jacobians", effort.jacobian_time),
        ("factorization", effort.factorization_time),
        ("solution", effort.solution_time),
        ("output", effort.output_time),
    ];
    let known: f64 = phases.iter().map(|phase| phase.1).sum();
    let rest = ("all else", (effort.total_time - known).max(0.0));
    let whole = ("whole run", effort.total_time);
    let heading = ["phase", "time [s]", "share [%]", "per iteration [us]"];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    for (name, time) in phases.into_iter().chain([rest, whole]) {
        let share = if effort.total_time > 0.0 {
            format!("{:.1}", 100.0 * time / effort.total_time)
        } else {
            "-".to_owned()
        };
        let each = match effort.iterations {
            0 => "-".to_owned(),
            iterations => format!("{:.1}", 1e6 * time / iterations as f64),
        };
        rows.push(vec![name.to_owned(), format!("{time:.3}"), share, each]);
    }
    aligned(&rows)
}

fn seconds(time: f64) -> String {
    format!("{} s", short_number(time, 4))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_and_times_are_reported() {
        let text = effort_text(&Effort {
            steps: 200,
            rejected: 3,
            iterations: 500,
            jacobians: 400,
            pivotings: 1,
            least_step: 1e-3,
            most_step: 0.02,
            prediction_time: 0.125,
            residual_time: 0.25,
            jacobian_time: 0.375,
            factorization_time: 0.125,
            solution_time: 0.025,
            output_time: 0.05,
            total_time: 1.0,
        });
        for expected in [
            "steps            200  of 0.001 s to 0.02 s\n",
            "rejected           3  tried again",
            "iterations       500  2.50 a step\n",
            "Jacobians        400  2.00 a step\n",
            "prediction        0.125       12.5               250.0\n",
            "residuals         0.250       25.0               500.0\n",
            "all else          0.050        5.0               100.0\n",
            "whole run         1.000      100.0              2000.0\n",
        ] {
            assert!(text.contains(expected), "{expected}\n{text}");
        }
        let text = effort_text(&Effort::default());
        assert!(
            text.contains("whole run         0.000          -"),
            "{text}"
        );
    }
}

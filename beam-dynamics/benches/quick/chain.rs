//! Chains of rigid bodies on spherical joints, as text of input files.

use std::fmt::Write;
use std::path::Path;

use beam_dynamics::input::{self, Input};
use beam_dynamics::model::State;
use cpu_time::ThreadTime;
use nalgebra::Vector3;

/// Length of a body [m].
const LENGTH: f64 = 0.2;

/// A level chain at rest, held at one end, under its weight.
pub fn text(bodies: usize) -> String {
    let mut text = String::from(
        "name = \"chain\"\n\
         units = { length = \"m\", force = \"N\", angle = \"rad\", rotation_speed = \"rad/s\" }\n\
         gravity = { acceleration = [0, 0, -9.81] }\n\
         transient = { to = 1, step = 1e-3 }\n",
    );
    for body in 0..bodies {
        let (center, end) = (LENGTH * (body as f64 + 0.5), LENGTH * body as f64);
        let on = match body {
            0 => String::from("\"n0\""),
            _ => format!("\"n{}\", \"n{body}\"", body - 1),
        };
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "[[node]]\nname = \"n{body}\"\nposition = [{center}, 0, 0]\n\
             [[body]]\nname = \"b{body}\"\nnode = \"n{body}\"\nmass = 0.5\n\
             inertia = [1e-4, 1.7e-3, 1.7e-3]\n\
             [[joint]]\nname = \"j{body}\"\nkind = \"spherical\"\nnodes = [{on}]\n\
             at = [{end}, 0, 0]"
        );
    }
    text
}

/// Reads a file, and returns its processor time [s].
pub fn read(path: &Path) -> Option<(Input, f64)> {
    let begin = ThreadTime::now();
    match input::read(path) {
        Ok(input) => Some((input, begin.elapsed().as_secs_f64())),
        Err(problems) => {
            println!("{problems}");
            None
        }
    }
}

/// Largest gap of a joint of a chain [m].
pub fn gap(state: &State) -> f64 {
    let half = |sign: f64| sign * 0.5 * LENGTH * Vector3::x();
    let mut end = Vector3::zeros();
    state.nodes.iter().fold(0.0, |gap: f64, node| {
        let begin = node.position + node.rotation * half(-1.0);
        let gap = gap.max((begin - end).norm());
        end = node.position + node.rotation * half(1.0);
        gap
    })
}

//! Equal arms of a model without blades: parts of nodes that a turn about the axis of the hub brings
//! to each other.

use nalgebra::Matrix3;
use shared_geom::rotation::vector;

use super::analyses::Analyses;
use super::number::short_number;
use crate::assembly::symmetry::{EqualParts, Symmetry, Unequal};
use crate::case::{Arms, BladeNodes, FrameRotation, Model};
use crate::model::NamingAxes;

/// The model with its equal arms, whose nodes are then named by the axes of the first arm, turned, for
/// analyses that name modes; a model with blades as it is.
pub(super) fn with_arms(mut model: Model, analyses: &Analyses) -> Model {
    let names_modes = analyses.modes.is_some() || analyses.stability.is_some();
    if !names_modes || !model.blades.is_empty() {
        return model;
    }
    let central: Vec<_> = model.naming.iter().map(|axes| axes.is_central).collect();
    let FrameRotation { axis, center } = model.frame_rotation;
    let symmetry = Symmetry::new(&model.system, (center, axis), &central);
    model.arms = match symmetry.highest() {
        Some(parts) => Arms::Equal(arms(&parts)),
        None => match symmetry.parts() {
            0 | 1 => Arms::None,
            count => match symmetry.of_order(count) {
                Ok(parts) => Arms::Equal(arms(&parts)),
                Err(why) => Arms::Unequal(reason(&model, count, &why)),
            },
        },
    };
    if let Arms::Equal(arms) = &model.arms {
        for arm in &arms[1..] {
            let turn = vector::to_rotation(&(axis * arm.azimuth));
            for (first, node) in arms[0].nodes.iter().zip(&arm.nodes) {
                model.naming[*node] = turned(&model.naming[*first], &turn);
            }
        }
    }
    model
}

fn arms(parts: &EqualParts) -> Vec<BladeNodes> {
    let step = std::f64::consts::TAU / parts.len() as f64;
    let numbered = parts.iter().enumerate();
    let arm = |(k, nodes): (usize, &Vec<usize>)| BladeNodes {
        name: format!("arm {}", k + 1),
        azimuth: step * k as f64,
        nodes: nodes.clone(),
        axes: Matrix3::identity(),
        file: None,
    };
    numbered.map(arm).collect()
}

fn turned(axes: &NamingAxes, turn: &Matrix3<f64>) -> NamingAxes {
    NamingAxes {
        blade: turn * axes.blade,
        section: turn * axes.section,
        ..*axes
    }
}

/// Why the parts of a model are not equal.
fn reason(model: &Model, count: usize, why: &Unequal) -> String {
    let label = |node: usize| &model.system.nodes()[node].label;
    let degrees = short_number(360.0 / count as f64, 6);
    let why = match why {
        Unequal::NoImage { node, nearest } => format!(
            "no node is where node \"{}\" would be after a turn of {degrees} deg about the axis; the \
             nearest is {} m away",
            label(*node),
            short_number(*nearest, 3)
        ),
        Unequal::Connected(node) => format!(
            "node \"{}\" is connected with others in another way than the node {degrees} deg on around \
             the axis",
            label(*node)
        ),
        Unequal::Different([a, b]) if a == b => format!(
            "stiffness, mass, damping or joints at node \"{}\" differ from those {degrees} deg \
             on around the axis",
            label(*a)
        ),
        Unequal::Different([a, b]) => format!(
            "stiffness, mass, damping or joints between the nodes \"{}\" and \"{}\" differ from \
             those {degrees} deg on around the axis",
            label(*a),
            label(*b)
        ),
    };
    format!("the {count} arms are not equal: {why}")
}

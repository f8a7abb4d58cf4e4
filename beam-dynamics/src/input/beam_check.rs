//! Whether three nodes can carry a beam.
//!
//! ```text
//! p_j = x_j + R_j f~_j                       t = (p_2 - p_1) . c / c . c ,  c = p_3 - p_1
//! dp/dxi at xi = -1, 0, 1:   -3/2 p_1 + 2 p_2 - 1/2 p_3 ,  c / 2 ,  1/2 p_1 - 2 p_2 + 3/2 p_3
//! ```
//!
//! With t between 0.45 and 0.55 the line moves forward along c all the way, which the
//! interpolation needs, and lengths along the beam are even enough for its two
//! evaluation points.

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::Table;
use shared_geom::rotation::vector;

use super::beam_card::Beam;
use super::problem::InputProblem;
use crate::model::Node;

/// Distances below this part of the largest coordinate or of the beam are treated as zero.
const NO_DISTANCE: f64 = 1e-9;
/// Largest distance of the middle node from the middle, as part of the length.
const OFF_MIDDLE: f64 = 0.05;
/// Largest angle between the section axis x and the line \[deg\]: more is a section
/// of another beam, or a missing orientation.
const ACROSS: f64 = 45.0;
/// Rotation of the section within half a beam above which it is not interpolated well
/// \[deg\].
const WRUNG: f64 = 90.0;

/// A beam as it lies in the model, undeformed.
#[derive(Debug)]
pub(super) struct BeamCheck<'a> {
    /// Description of the beam.
    words: &'a str,
    names: [&'a str; 3],
    /// Points of the reference line at the nodes \[m\].
    points: [Vector3<f64>; 3],
    /// Section axes at the nodes.
    sections: [Matrix3<f64>; 3],
}

impl<'a> BeamCheck<'a> {
    /// `words` describe the beam in messages; `nodes` are all nodes of the model.
    pub fn new(words: &'a str, beam: &Beam, nodes: &'a [Node]) -> Self {
        let nodes = beam.nodes.map(|node| &nodes[node]);
        let ends = &beam.geometry.nodes;
        Self {
            words,
            names: nodes.map(|node| node.label.as_str()),
            points: std::array::from_fn(|j| nodes[j].position + nodes[j].rotation * ends[j].offset),
            sections: std::array::from_fn(|j| nodes[j].rotation * ends[j].orientation),
        }
    }

    /// Notes problems at the line of `key`; returns true if there are none.
    pub fn note_on(&self, table: &Table<'_>, key: &str) -> bool {
        let found = self.of_positions().unwrap_or_else(|| {
            let mut found = self.of_axes();
            found.extend(self.of_turns());
            found
        });
        for problem in &found {
            table.note(key, problem);
        }
        found.is_empty()
    }

    /// Problems of the positions of the nodes, without which the other checks are
    /// meaningless.
    fn of_positions(&self) -> Option<Vec<InputProblem>> {
        let [p1, p2, p3] = self.points;
        let beam = self.words.to_owned();
        let [first, middle, last] = self.names.map(str::to_owned);
        let chord = p3 - p1;
        let size = self.points.iter().map(Vector3::amax).fold(0.0, f64::max);
        let pairs = [(0, 1), (1, 2), (0, 2)];
        let same = |&(i, j): &(usize, usize)| {
            (self.points[i] - self.points[j]).norm() <= NO_DISTANCE * size
        };
        if let Some((i, j)) = pairs.into_iter().find(same) {
            let [first, second] = [i, j].map(|k| self.names[k].to_owned());
            return Some(vec![InputProblem::Coincident {
                beam,
                first,
                second,
            }]);
        }
        let part = (p2 - p1).dot(&chord) / chord.norm_squared();
        if !(0.0..=1.0).contains(&part) {
            return Some(vec![InputProblem::OutOfOrder {
                beam,
                first,
                middle,
                last,
            }]);
        }
        if (part - 0.5).abs() > OFF_MIDDLE * (1.0 + NO_DISTANCE) {
            return Some(vec![InputProblem::OffMiddle {
                beam,
                first,
                middle,
                last,
                part,
            }]);
        }
        None
    }

    /// Section axes that do not follow the line; the worst node.
    fn of_axes(&self) -> Vec<InputProblem> {
        let [p1, p2, p3] = self.points;
        let tangents = [
            -1.5 * p1 + 2.0 * p2 - 0.5 * p3,
            0.5 * (p3 - p1),
            0.5 * p1 - 2.0 * p2 + 1.5 * p3,
        ];
        let off = |j: usize| self.sections[j].column(0).angle(&tangents[j]).to_degrees();
        let worst = (0..3)
            .max_by(|&i, &j| off(i).total_cmp(&off(j)))
            .unwrap_or(0);
        if off(worst) <= ACROSS {
            return Vec::new();
        }
        vec![InputProblem::AcrossLine {
            beam: self.words.to_owned(),
            node: self.names[worst].to_owned(),
            degrees: off(worst),
            limit: ACROSS,
        }]
    }

    /// Section axes that turn too much between the middle and an end.
    fn of_turns(&self) -> Option<InputProblem> {
        let turn = |j: usize| {
            let relative = self.sections[1].transpose() * self.sections[j];
            vector::from_rotation(&relative).norm().to_degrees()
        };
        let j = [0, 2].into_iter().find(|&j| turn(j) >= WRUNG)?;
        Some(InputProblem::Wrung {
            beam: self.words.to_owned(),
            node: self.names[j].to_owned(),
            degrees: turn(j),
            limit: WRUNG,
        })
    }
}

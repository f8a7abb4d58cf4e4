//! Rod: a constitutive law along the line between two points.
//!
//! ```text
//! e = (l - l_0) / s          e' = n . d' / s          T = law(e, e', t)
//! ```
//!
//! with s = l_0, so that e is the strain and a linear law has the stiffness EA, or with
//! s = 1, so that e is the elongation. The pull T along the line is positive in tension.
//! A rod resists no motion across its line but by its tension. Variations (see
//! [`super::line`]), with the slopes C, V of the law:
//!
//! ```text
//! d e  = n . d d / s          d e' = ( d' . (I - n n^T)/l d d + n . d d' ) / s
//! d P  = n (C d e + V d e') + T (I - n n^T)/l d d
//! ```
//!
//! References: [Masarati], rods.

use nalgebra::{Vector1, Vector3};

use super::line::{End, Line, LineState, PullVariation};
use crate::elements::laws::{Law, Response};
use crate::elements::{
    Along, Element, Energy, Local, LocalJacobian, LocalResidual, Motion, Observations, SpringState,
};
use crate::model::{Drive, Node, NodeMotion};

/// What the law of a rod takes for its strain.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measure {
    /// Elongation per relaxed length.
    Strain,
    /// Elongation.
    Elongation,
}

/// A law along the line between two points.
#[derive(Debug, Clone)]
pub struct Rod {
    label: String,
    line: Line,
    undeformed: Vec<NodeMotion>,
    /// Relaxed length `l_0` [m].
    relaxed: f64,
    /// `s` of the equations [m].
    scale: f64,
    law: Law<1>,
}

impl Rod {
    /// A rod between two ends of the undeformed `nodes` of the model. `relaxed` is the
    /// length without strain, by default that of the undeformed model; either must not be
    /// zero.
    pub fn new(
        label: impl Into<String>,
        ends: [End; 2],
        nodes: &[Node],
        relaxed: Option<f64>,
        (measure, law): (Measure, Law<1>),
    ) -> Self {
        let line = Line::new(ends);
        let rest = line
            .nodes()
            .iter()
            .map(|&node| NodeMotion::at_rest(&nodes[node]));
        let undeformed: Vec<_> = rest.collect();
        let relaxed = relaxed.unwrap_or_else(|| line.state(&undeformed).length);
        Self {
            label: label.into(),
            line,
            undeformed,
            relaxed,
            scale: match measure {
                Measure::Strain => relaxed,
                Measure::Elongation => 1.0,
            },
            law,
        }
    }

    /// Length between its ends [m].
    pub fn length(&self, nodes: &[NodeMotion]) -> f64 {
        self.line.state(nodes).length
    }

    fn response(&self, state: &LineState, time: f64) -> Response<1> {
        let strain = (state.length - self.relaxed) / self.scale;
        let rate = state.length_rate() / self.scale;
        self.law
            .at(&Vector1::new(strain), &Vector1::new(rate), time)
    }
}

impl Element for Rod {
    fn label(&self) -> &str {
        &self.label
    }

    fn nodes(&self) -> &[usize] {
        self.line.nodes()
    }

    fn domain(&self) -> [f64; 2] {
        Drive::common_domain(self.law.drives())
    }

    fn next_corner(&self, time: f64) -> f64 {
        self.law.next_corner(time)
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let elongation = self.line.state(at.nodes).length - self.relaxed;
        let strain = Vector1::new(elongation / self.scale);
        Energy {
            elastic: self.law.energy(&strain, at.loading.time) * self.scale,
            ..Energy::default()
        }
    }

    fn residual(&self, at: &Local<'_>, out: &mut LocalResidual) {
        let state = self.line.state(at.nodes);
        let tension = self.response(&state, at.loading.time).force[0];
        state.add_pull(tension, out);
    }

    fn jacobian(&self, at: &Local<'_>, out: &mut LocalJacobian) {
        let state = self.line.state(at.nodes);
        let response = self.response(&state, at.loading.time);
        let tension = response.force[0];
        let along = state.n * state.n.transpose() / self.scale;
        let viscosity = response.by_rate[(0, 0)];
        let turning = state.turning();
        let across = viscosity / self.scale * state.n * (turning * state.d_rate).transpose();
        let by = PullVariation {
            by_d: response.by_strain[(0, 0)] * along + across + tension * turning,
            by_rate: self.law.is_viscous().then(|| viscosity * along),
        };
        state.add_variation(tension, &by, out);
    }

    /// The part that is proportional to the tension, for its growth along the motion.
    fn prestress(&self, at: &Local<'_>, along: &Along<'_>, out: &mut LocalJacobian) {
        let state = self.line.state(at.nodes);
        let slope = self.response(&state, at.loading.time).by_strain[(0, 0)];
        let tension = slope * state.n.dot(&state.growth(along.nodes)) / self.scale;
        let by = PullVariation {
            by_d: tension * state.turning(),
            by_rate: None,
        };
        state.add_variation(tension, &by, out);
    }

    fn motions(&self) -> Vec<Motion> {
        let form = self.line.state(&self.undeformed).form();
        let is_resisted = self.law.stiffness_at_rest()[(0, 0)] != 0.0;
        let motion = is_resisted.then_some(Motion { form, is_resisted });
        motion.into_iter().collect()
    }

    fn observe(&self, at: &Local<'_>, out: &mut Observations) {
        let state = self.line.state(at.nodes);
        let tension = self.response(&state, at.loading.time).force[0];
        out.springs.push(SpringState {
            spring: self.label.clone(),
            axes: state.axes(),
            displacement: Vector3::new(state.length - self.relaxed, 0.0, 0.0),
            rotation: Vector3::zeros(),
            force: Vector3::new(tension, 0.0, 0.0),
            moment: Vector3::zeros(),
        });
    }
}

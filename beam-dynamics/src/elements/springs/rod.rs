//! Rod: a constitutive law along the line between two points.
//!
//! ```text
//! e = (l - l_0(t)) / s     e' = (n . d' - l_0' - e s') / s     T = law(e, e', t)
//! ```
//!
//! with s = l_0, s' = l_0', so that e is the strain and a linear law has the stiffness EA, or with
//! s = 1, s' = 0, so that e is the elongation. The relaxed length must be above zero; if its drive
//! is not, the force is undefined. The pull T along the line is positive in tension. A rod resists
//! motion across its line only through its tension. Variations (see [`super::line`]), with the
//! slopes C, V of the law:
//!
//! ```text
//! d e  = n . d d / s     d e' = ( d' . (I - n n^T)/l d d + n . d d' - s' d e ) / s
//! d P  = n (C d e + V d e') + T (I - n n^T)/l d d
//! ```
//!
//! References: [Masarati], rods.

use nalgebra::{Vector1, Vector3};
use shared_geom::units::rounded;

use super::line::{End, Line, LineState, PullVariation};
use crate::elements::laws::{Law, Response};
use crate::elements::{
    Charges, Element, Energetic, Energy, EnergySlope, Exchange, Growth, Local, LocalJacobian,
    LocalResidual, Motion, Observations, Reading, ReadingRow, Reports, Signal, SmallMotion,
    SpringState, SpringVector, Structure, has,
};
use crate::model::{Drive, Equation, Node, NodeMotion, Scalar, Variable};

/// The strain measure of the law of a rod.
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
    relaxed: Signal,
    measure: Measure,
    law: Law<1>,
    /// The scalars that the relaxed length and the law read.
    scalars: Vec<Scalar>,
}

/// The rod at a state and a time.
struct Strained {
    line: LineState,
    /// Relaxed length [m].
    relaxed: f64,
    /// `s` of the equations [m], and its rate [m/s].
    scale: [f64; 2],
    /// Strain or elongation `e` [-, m], and its rate [1/s, m/s].
    strain: [f64; 2],
    response: Response<1>,
}

impl Rod {
    /// A rod between two ends of the undeformed `nodes` of the model. `relaxed` is the length
    /// without strain [m], by default the undeformed length; either must be above zero.
    pub fn new(
        label: impl Into<String>,
        ends: [End; 2],
        nodes: &[Node],
        relaxed: Option<Signal>,
        (measure, mut law): (Measure, Law<1>),
    ) -> Self {
        let line = Line::new(ends);
        let rest = line
            .nodes()
            .iter()
            .map(|&node| NodeMotion::at_rest(&nodes[node]));
        let undeformed: Vec<_> = rest.collect();
        let relaxed =
            relaxed.unwrap_or_else(|| Drive::Constant(line.state(&undeformed).length).into());
        let mut scalars = Vec::new();
        law.bind(&mut scalars);
        Self {
            label: label.into(),
            line,
            undeformed,
            relaxed: relaxed.bound(&mut scalars),
            measure,
            law,
            scalars,
        }
    }

    /// Length between its ends [m].
    pub fn length(&self, nodes: &[NodeMotion]) -> f64 {
        self.line.state(nodes).length
    }

    fn state(&self, at: &Local<'_>) -> Strained {
        let line = self.line.state(at.nodes);
        let mut relaxed = self.relaxed.at(&at.instant());
        if relaxed.value <= 0.0 {
            relaxed.value = f64::NAN;
        }
        let scale = match self.measure {
            Measure::Strain => [relaxed.value, relaxed.rate],
            Measure::Elongation => [1.0, 0.0],
        };
        let strain = (line.length - relaxed.value) / scale[0];
        let rate = (line.length_rate() - relaxed.rate - strain * scale[1]) / scale[0];
        let [e, e_rate] = [strain, rate].map(Vector1::new);
        Strained {
            line,
            relaxed: relaxed.value,
            scale,
            strain: [strain, rate],
            response: self.law.at(&e, &e_rate, &at.instant()),
        }
    }
}

impl Strained {
    /// Derivatives of `[e, e']` by `l_0` and by its rate:
    ///
    /// ```text
    /// e  = ( l - l_0 ) / s                  e' = ( l' - l_0' - e s' ) / s
    /// ```
    ///
    /// with `s = l_0` of a strain and `s = 1` of an elongation.
    fn by_relaxed(&self, measure: Measure) -> [[f64; 2]; 2] {
        let ([s, s_rate], [e, e_rate]) = (self.scale, self.strain);
        match measure {
            Measure::Elongation => [[-1.0, 0.0], [0.0, -1.0]],
            Measure::Strain => {
                let by_length = -(1.0 + e) / s;
                let of_rate = -(by_length * s_rate + e_rate) / s;
                [[by_length, of_rate], [0.0, by_length]]
            }
        }
    }
}

impl Rod {
    /// Adds the variation of the tension by scalars.
    fn add_by_scalars(&self, at: &Local<'_>, out: &mut LocalJacobian) {
        if self.scalars.is_empty() {
            return;
        }
        let (state, now) = (self.state(at), at.instant());
        let [e, e_rate] = state.strain.map(Vector1::new);
        let mut add = |scalar: usize, tension: f64, of_rate: bool| {
            for (node, [force, moment]) in state.line.pulls(tension) {
                out.add_by_scalar((node, Equation::Force), (scalar, of_rate), &force);
                out.add_by_scalar((node, Equation::Moment), (scalar, of_rate), &moment);
            }
        };
        (self.law).by_scalars(&e, &e_rate, &now, |scalar, tension, of_rate| {
            add(scalar, tension[0], of_rate);
        });
        let Response {
            by_strain, by_rate, ..
        } = &state.response;
        let [by_length, by_growth] = (state.by_relaxed(self.measure))
            .map(|[e, e_rate]| by_strain[(0, 0)] * e + by_rate[(0, 0)] * e_rate);
        self.relaxed
            .gradient(&now, |scalar, slope| add(scalar, by_length * slope, false));
        if self.law.is_viscous() {
            (self.relaxed).gradient_of_rate(&now, |scalar, slope, of_rate| {
                add(scalar, by_growth * slope, of_rate);
            });
        }
    }
}

impl Rod {
    /// Adds `size` times the derivatives of the elongation, or of the tension. A pull T of one is a
    /// force `-dl/dx` on each end; the tension is the force along the line on an end, `dT = -n .
    /// dF`, as n stays of unit length.
    fn add_reading(
        &self,
        state: &Strained,
        vector: SpringVector,
        size: f64,
        (at, row): (&Local<'_>, &mut ReadingRow<'_>),
    ) {
        let mut pulls = state.line.pulls(1.0);
        match vector {
            SpringVector::Displacement => {
                for (node, [force, moment]) in pulls {
                    row.by_node(node, Variable::Position, &(-size * force));
                    row.by_node(node, Variable::Rotation, &(-size * moment));
                }
                self.relaxed.gradient(&at.instant(), |scalar, slope| {
                    row.by_scalar((scalar, false), -size * slope);
                });
            }
            SpringVector::Force => {
                if let Some((node, [force, _])) = pulls.next() {
                    row.by_equation(node, Equation::Force, &(size * force));
                }
            }
            SpringVector::Rotation | SpringVector::Moment => {}
        }
    }
}

impl Element for Rod {
    fn label(&self) -> &str {
        &self.label
    }

    fn nodes(&self) -> &[usize] {
        self.line.nodes()
    }

    fn scalars(&self) -> &[Scalar] {
        &self.scalars
    }

    fn each_signal<'a>(&'a self, visit: &mut dyn FnMut(&'a Signal)) {
        self.law.signals().chain([&self.relaxed]).for_each(visit);
    }

    fn has_kinks(&self) -> bool {
        self.law.has_kinks()
    }

    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        let state = self.state(at);
        state.line.add_pull(state.response.force[0], out);
        let Some(out) = jacobian else { return };
        let Strained {
            line: state,
            scale: [scale, scale_rate],
            response,
            ..
        } = state;
        let tension = response.force[0];
        let along = state.n * state.n.transpose() / scale;
        let viscosity = response.by_rate[(0, 0)];
        let slope = response.by_strain[(0, 0)] - viscosity * scale_rate / scale;
        let turning = state.turning();
        let across = viscosity / scale * state.n * (turning * state.d_rate).transpose();
        let by = PullVariation {
            by_d: slope * along + across + tension * turning,
            by_rate: self.law.is_viscous().then(|| viscosity * along),
        };
        state.add_variation(tension, &by, out);
        self.add_by_scalars(at, out);
    }

    has!(energetic: Energetic, growth: Growth, structure: Structure, reports: Reports);
}

impl Energetic for Rod {
    fn stored(&self, at: &Local<'_>) -> Energy {
        let state = self.state(at);
        let strain = Vector1::new(state.strain[0]);
        Energy {
            elastic: self.law.energy(&strain, &at.instant()) * state.scale[0],
            ..Energy::default()
        }
    }

    fn exchanged(&self) -> Exchange {
        let is_driven = self.relaxed.constant().is_none() || !self.law.keeps_energy();
        Exchange::of(self.law.is_viscous(), is_driven)
    }

    fn is_conservative(&self) -> bool {
        true
    }

    fn slope(&self) -> EnergySlope {
        if self.relaxed.constant().is_some() && self.law.keeps_energy() {
            EnergySlope::Forces
        } else {
            EnergySlope::Unknown
        }
    }
}

impl Growth for Rod {
    fn add_by_factor(&self, _at: &Local<'_>, _out: &mut LocalResidual) {}

    /// The part proportional to the tension, for its growth along the motion.
    fn add_prestress(&self, at: &Local<'_>, motion: &SmallMotion<'_>, out: &mut LocalJacobian) {
        let Strained {
            line: state,
            scale,
            response,
            ..
        } = self.state(at);
        let slope = response.by_strain[(0, 0)];
        let tension = slope * state.n.dot(&state.growth(motion.nodes)) / scale[0];
        let by = PullVariation {
            by_d: tension * state.turning(),
            by_rate: None,
        };
        state.add_variation(tension, &by, out);
    }
}

impl Structure for Rod {
    fn arm(&self) -> f64 {
        let length = self.length(&self.undeformed);
        self.line.reach().max(length)
    }

    fn is_joining(&self) -> bool {
        false
    }

    fn free_motions(&self) -> Vec<Motion> {
        let form = self.line.state(&self.undeformed).form();
        let is_resisted = self.law.stiffness_at_rest()[(0, 0)] != 0.0;
        let motion = is_resisted.then_some(Motion { form, is_resisted });
        motion.into_iter().collect()
    }

    fn loaded_turn(&self, _at: &Local<'_>) -> Option<Vector3<f64>> {
        None
    }

    fn undefined(&self, at: &Local<'_>) -> Option<String> {
        let relaxed = self.relaxed.value(&at.instant());
        (relaxed <= 0.0).then(|| {
            let time = rounded(at.loading.time);
            format!("its relaxed length is zero or less: {relaxed:.3e} m at {time} s")
        })
    }
}

impl Reports for Rod {
    fn report(&self, at: &Local<'_>, out: &mut Observations) {
        let state = self.state(at);
        out.springs.push(SpringState {
            spring: self.label.clone(),
            axes: state.line.axes(),
            displacement: Vector3::new(state.line.length - state.relaxed, 0.0, 0.0),
            rotation: Vector3::zeros(),
            force: Vector3::new(state.response.force[0], 0.0, 0.0),
            moment: Vector3::zeros(),
        });
    }

    fn reading(
        &self,
        reading: &Reading,
        at: &Local<'_>,
        row: Option<&mut ReadingRow<'_>>,
    ) -> Option<f64> {
        let Reading::Spring { vector, part } = *reading else {
            return None;
        };
        let state = self.state(at);
        // Along the line; nothing across it.
        let along = match vector {
            SpringVector::Displacement => state.line.length - state.relaxed,
            SpringVector::Force => state.response.force[0],
            SpringVector::Rotation | SpringVector::Moment => 0.0,
        };
        let w = along * Vector3::x();
        if let Some(row) = row {
            self.add_reading(&state, vector, part.slope(&w).x, (at, row));
        }
        Some(part.of(&w))
    }

    fn report_charges(&self, _at: &Local<'_>, _out: &mut Charges) {}
}

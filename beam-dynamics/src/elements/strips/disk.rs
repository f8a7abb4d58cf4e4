//! The inflow of a rotor as an element: the flow at its hub, the loads of its strips, and the states
//! of a model of the disk are unknowns that its strips share.
//!
//! With the hub's point c, the velocity V(c, t) of the air, and the axes of
//! [`axes`](self::axes):
//!
//! ```text
//! p_i - e_i . (V - v_c) = 0          axial + n . (V - v_c) = 0         Omega - n . omega = 0
//! T - sum F . n = 0                  M_i - sum F . n b_i = 0           g(states, rates) = 0
//! ```
//!
//! The strips add their forces F at the positions b in the disk. The rows g are the rows of
//! [`rotor_aero::inflow::Disk`], with the rates of the gradients in space: the axes turn with the frame
//! at `Omega_f . n`. Above the ground the velocities are multiplied by the factor of
//! [`rotor_aero::inflow::ground_effect`], an unknown too.
//!
//! References: [Masarati], 5.9; [Pitt1981].

use std::sync::Arc;

use nalgebra::{Matrix3, RowVector3, Vector3};
use num_dual::DualSVec64;
use rotor_aero::inflow::{Disk, DiskFlow, DiskLoads, Inflow};
use rotor_aero::real::Real;
use shared_geom::rotation::{skew, skew_skew};

use super::air::Air;
use super::shaft::{Shaft, ShaftState};
use crate::elements::{Element, FixedAxes, Local, LocalJacobian, LocalResidual, has};
use crate::model::{NodeMotion, Quantity, Scalar, ScalarSpec, ScalarStart, Variable};

mod axes;
mod fixed_axes;
mod ground;

pub(super) use axes::DiskAxes;

/// Unknowns of the flow: velocities across and against the shaft, and the rotor speed.
pub(super) const FLOW: usize = 4;
/// Index of the first unknown of the loads: thrust, and two moments.
pub(super) const LOADS: usize = FLOW;
/// Index of the first state.
pub(super) const STATES: usize = LOADS + 3;
/// Most states of a model.
pub(super) const MOST: usize = 3;

/// A rotor's disk, which its strips share.
#[derive(Debug)]
pub struct RotorDisk {
    label: String,
    disk: Disk,
    shaft: Shaft,
    /// A direction across the shaft that is fixed in the frame.
    reference: Vector3<f64>,
    ground: Option<Ground>,
    /// Whether velocities of annuli are distributed by the skew of the wake.
    is_skewed: bool,
    /// The flow, the loads, the states, and the factor of the ground.
    scalars: Vec<Scalar>,
}

/// A level ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ground {
    /// The vertical, a unit vector of the frame \[-\].
    pub up: Vector3<f64>,
    /// Coordinate of the ground along it \[m\].
    pub level: f64,
}

fn scalar(
    owner: &str,
    (name, unit, scale): (&str, &str, f64),
    row: &str,
    has_rate: bool,
) -> Scalar {
    Scalar::new(ScalarSpec {
        owner: owner.to_owned(),
        unknown: Quantity::new(name, unit, scale),
        equation: Quantity::new(format!("equation of {name}"), row, scale),
        has_rate,
        rate: None,
        start: ScalarStart::Settled,
    })
}

impl RotorDisk {
    /// The disk of the rotor `label`, whose shaft has the direction `axis` in the frame before the model
    /// moves.
    pub fn new(
        label: impl Into<String>,
        disk: Disk,
        (shaft, axis): (Shaft, &Vector3<f64>),
        ground: Option<Ground>,
    ) -> Self {
        let label = label.into();
        let own = |what, row, has_rate| scalar(&label, what, row, has_rate);
        let mut scalars = vec![
            own(
                ("first velocity across the shaft", "m/s", 1.0),
                "m/s",
                false,
            ),
            own(
                ("second velocity across the shaft", "m/s", 1.0),
                "m/s",
                false,
            ),
            own(("velocity against the shaft", "m/s", 1.0), "m/s", false),
            own(("rotor speed", "rad/s", 1.0), "rad/s", false),
            own(("thrust", "N", 1.0), "N", false),
            own(("first moment of the thrust", "N m", 1.0), "N m", false),
            own(("second moment of the thrust", "N m", 1.0), "N m", false),
        ];
        let names = [
            "mean induced velocity",
            "first gradient of the induced velocity",
            "second gradient of the induced velocity",
        ];
        let states = names.iter().take(disk.states().len());
        scalars.extend(states.map(|name| own((name, "m/s", 1.0), "m/s^2", true)));
        if ground.is_some() {
            scalars.push(own(("factor of the ground", "-", 1.0), "-", false));
        }
        let smallest = axis.iamin();
        let reference = Vector3::ith(smallest, 1.0);
        Self {
            reference: (reference - axis * axis.dot(&reference)).normalize(),
            label,
            disk,
            shaft,
            ground,
            is_skewed: false,
            scalars,
        }
    }

    /// The same with velocities of annuli that are distributed by the skew of the wake.
    #[must_use]
    pub fn skewed(mut self, is_skewed: bool) -> Self {
        self.is_skewed = is_skewed;
        self
    }

    /// The unknowns that a strip uses.
    pub fn scalars(&self) -> &[Scalar] {
        &self.scalars
    }

    /// Its shaft.
    pub fn shaft(&self) -> &Shaft {
        &self.shaft
    }

    /// The axes at a shaft.
    pub(super) fn axes(&self, shaft: &ShaftState) -> DiskAxes {
        DiskAxes::new(shaft.axis, &self.reference)
    }

    /// Number of its states.
    pub(super) fn state_count(&self) -> usize {
        self.disk.states().len()
    }

    /// The induced velocity at a position in the disk for the values of its unknowns \[m/s\]; of a
    /// strip whose annulus has a mean velocity, this one, or with the skew of the wake.
    pub(super) fn induced(&self, position: &[f64; 2], values: &[f64], mean: Option<f64>) -> f64 {
        let inputs = self.inputs(position, values, mean);
        self.factor(values) * self.at_position(&inputs, mean.is_some())
    }

    /// The same with its derivatives.
    pub(super) fn induced_slopes(
        &self,
        position: &[f64; 2],
        values: &[f64],
        mean: Option<f64>,
    ) -> InducedSlopes {
        let inputs = self.inputs(position, values, mean);
        let of: [_; INDUCED] =
            std::array::from_fn(|i| DualSVec64::<INDUCED>::from_re(inputs[i]).derivative(i));
        let found = self.at_position(&of, mean.is_some());
        let slopes = found.eps.unwrap_generic(nalgebra::Const, nalgebra::Const);
        InducedSlopes {
            by: (slopes * self.factor(values)).into(),
            by_factor: found.re,
        }
    }

    /// The factor of the ground.
    fn factor(&self, values: &[f64]) -> f64 {
        match self.ground {
            Some(_) => values[STATES + self.state_count()],
            None => 1.0,
        }
    }

    /// The inputs of the induced velocity.
    fn inputs(&self, position: &[f64; 2], values: &[f64], mean: Option<f64>) -> [f64; INDUCED] {
        let count = self.state_count();
        let mut inputs = [0.0; INDUCED];
        inputs[..2].copy_from_slice(position);
        inputs[2..2 + FLOW].copy_from_slice(&values[..FLOW]);
        inputs[2 + FLOW..2 + FLOW + count].copy_from_slice(&values[STATES..STATES + count]);
        if let Some(mean) = mean {
            inputs[2 + FLOW] = mean;
        }
        inputs
    }

    /// The induced velocity without the factor of the ground; `has_mean` with the mean velocity of
    /// an annulus.
    fn at_position<T: Real>(&self, of: &[T; INDUCED], has_mean: bool) -> T {
        let (flow, position) = (flow(&of[2..]), [of[0], of[1]]);
        let states = &of[2 + FLOW..2 + FLOW + self.state_count()];
        let found = match (has_mean, self.is_skewed) {
            (true, true) => Some(self.disk.skewed(&flow, of[2 + FLOW], &position)),
            (true, false) => Some(of[2 + FLOW]),
            (false, _) => self.disk.induced(&flow, states, &position),
        };
        found.unwrap_or_else(|| T::from(0.0))
    }
}

/// Inputs of the induced velocity: position, flow, states.
const INDUCED: usize = 2 + FLOW + MOST;

/// Derivatives of an induced velocity.
pub(super) struct InducedSlopes {
    /// By the position (2), the flow (4), and the states or the mean of the annulus.
    pub by: [f64; INDUCED],
    /// By the factor of the ground.
    pub by_factor: f64,
}

impl InducedSlopes {
    /// The derivative by the mean of the annulus.
    pub fn by_mean(&self) -> f64 {
        self.by[2 + FLOW]
    }

    /// The derivative by unknown `index` of the disk.
    pub fn by_scalar(&self, index: usize, states: usize) -> f64 {
        match index {
            0..LOADS => self.by[2 + index],
            LOADS..STATES => 0.0,
            _ if index < STATES + states => self.by[2 + FLOW + index - STATES],
            _ => self.by_factor,
        }
    }
}

/// The flow from its four numbers.
fn flow<T: Copy>(of: &[T]) -> DiskFlow<T> {
    DiskFlow {
        in_plane: [of[0], of[1]],
        axial: of[2],
        speed: of[3],
    }
}

/// The element of a disk.
#[derive(Debug, Clone)]
pub struct DiskInflow {
    disk: Arc<RotorDisk>,
    /// The node that carries the shaft, if it moves.
    nodes: Vec<usize>,
    air: Arc<Air>,
}

/// The hub at a state.
struct Hub {
    shaft: ShaftState,
    axes: DiskAxes,
    /// Velocity of the air against the point of the hub [m/s].
    relative: Vector3<f64>,
    /// Angular velocity in space [rad/s].
    omega: Vector3<f64>,
    /// Derivatives of the velocity by the position of the point [1/s].
    gradient: Matrix3<f64>,
}

/// Inputs of the rows of the states: flow, loads, states, their rates, and the turning of the axes.
const ROWS: usize = FLOW + 3 + 2 * MOST + 1;

impl DiskInflow {
    /// The element of a disk whose shaft the node `hub` carries, or the frame.
    pub fn new(disk: Arc<RotorDisk>, hub: Option<usize>, air: Arc<Air>) -> Self {
        Self {
            disk,
            nodes: hub.into_iter().collect(),
            air,
        }
    }

    fn hub(&self, at: &Local<'_>) -> Hub {
        let node: Option<&NodeMotion> = at.nodes.first();
        let shaft = self.disk.shaft.at(node);
        let own = node.map_or_else(Vector3::zeros, |node| node.angular_velocity);
        let velocity = node.map_or_else(Vector3::zeros, |node| {
            node.velocity + own.cross(&shaft.offset)
        });
        let (wind, by_point) = self.air.motion(&shaft.center, at.loading.time);
        Hub {
            axes: self.disk.axes(&shaft),
            relative: wind - at.frame.velocity(&shaft.center, &velocity),
            omega: own + at.frame.angular_velocity,
            gradient: by_point - at.frame.skew(),
            shaft,
        }
    }

    /// Rows of the states with all derivatives, and the factor of the ground.
    fn rows(&self, at: &Local<'_>, turning: f64) -> ([DualSVec64<ROWS>; MOST], usize) {
        let count = self.disk.state_count();
        let mut inputs = [0.0; ROWS];
        let (values, rates) = (at.scalars.values, at.scalars.rates);
        inputs[..STATES + count].copy_from_slice(&values[..STATES + count]);
        inputs[STATES + MOST..STATES + MOST + count]
            .copy_from_slice(&rates[STATES..STATES + count]);
        inputs[ROWS - 1] = turning;
        let of: [_; ROWS] =
            std::array::from_fn(|i| DualSVec64::<ROWS>::from_re(inputs[i]).derivative(i));
        let states = &of[STATES..STATES + count];
        let mut speeds = [DualSVec64::from_re(0.0); MOST];
        speeds.copy_from_slice(&of[STATES + MOST..STATES + 2 * MOST]);
        if let Some([_, _]) = self.disk.disk.model.gradients() {
            speeds[1] -= of[ROWS - 1] * states[2];
            speeds[2] += of[ROWS - 1] * states[1];
        }
        let mut rows = [DualSVec64::from_re(0.0); MOST];
        if at.loading.air == 0.0 {
            // Without forces there is nothing that the states could lag behind.
            for (row, k) in rows.iter_mut().zip(0..count) {
                *row = states[k] + speeds[k];
            }
            return (rows, count);
        }
        let loads = DiskLoads {
            thrust: of[LOADS],
            moments: [of[LOADS + 1], of[LOADS + 2]],
        };
        // The slices have the length of the list of states.
        let _found = self.disk.disk.rows(
            (&flow(&of), self.air.atmosphere.density),
            &loads,
            (states, &speeds[..count]),
            &mut rows[..count],
        );
        (rows, count)
    }

    fn add_states(
        &self,
        at: &Local<'_>,
        hub: &Hub,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        let frame = at.frame.angular_velocity;
        let (rows, count) = self.rows(at, frame.dot(&hub.axes.shaft));
        let slopes = rows.map(|row| row.eps.unwrap_generic(nalgebra::Const, nalgebra::Const));
        for (k, row) in rows.iter().take(count).enumerate() {
            let terms = |i: usize, value: f64| (slopes[k][i] * value).abs();
            let own = terms(LOADS, at.scalars.values[LOADS]);
            let size = own + terms(STATES + MOST + k, at.scalars.rates[STATES + k]);
            out.add_scalar_sum(STATES + k, row.re, size);
        }
        let Some(out) = jacobian else { return };
        for (k, slopes) in slopes.iter().take(count).enumerate() {
            let row = STATES + k;
            for i in 0..STATES + count {
                out.add_scalar(row, i, slopes[i], false);
            }
            for i in 0..count {
                out.add_scalar(row, STATES + i, slopes[STATES + MOST + i], true);
            }
            if !self.nodes.is_empty() {
                let by_turn = -slopes[ROWS - 1] * frame.transpose() * skew(&hub.axes.shaft);
                out.add_scalar_row(row, (0, Variable::Rotation), &by_turn);
            }
        }
    }

    /// Adds the rows of the flow.
    fn add_flow(
        &self,
        at: &Local<'_>,
        hub: &Hub,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        let [first, second] = hub.axes.across;
        let shaft = hub.axes.shaft;
        let directions = [first, second, -shaft];
        for (row, direction) in directions.iter().enumerate() {
            out.add_scalar(row, at.scalars.values[row]);
            out.add_scalar(row, -direction.dot(&hub.relative));
        }
        out.add_scalar(3, at.scalars.values[3]);
        out.add_scalar(3, -shaft.dot(&hub.omega));
        let Some(out) = jacobian else { return };
        for row in 0..FLOW {
            out.add_scalar(row, row, 1.0, false);
        }
        let Some(node) = at.nodes.first() else { return };
        let offset = skew(&hub.shaft.offset);
        let [by_first, by_second] = hub.axes.by_turn();
        let by_turn = [by_first, by_second, skew(&shaft)];
        // d (V - v_c) by the rotation: through c, and through the arm of the angular velocity.
        let turned = -hub.gradient * offset + skew_skew(&node.angular_velocity, &hub.shaft.offset);
        for (row, direction) in directions.iter().enumerate() {
            let along = direction.transpose();
            let mut add = |variable, slope: RowVector3<f64>| {
                out.add_scalar_row(row, (0, variable), &-slope);
            };
            add(Variable::Position, along * hub.gradient);
            add(Variable::Velocity, -along);
            add(Variable::AngularVelocity, along * offset);
            let own = hub.relative.transpose() * by_turn[row];
            add(Variable::Rotation, along * turned + own);
        }
        out.add_scalar_row(3, (0, Variable::AngularVelocity), &-shaft.transpose());
        let by_turn = hub.omega.transpose() * skew(&shaft);
        out.add_scalar_row(3, (0, Variable::Rotation), &by_turn);
    }
}

impl Element for DiskInflow {
    fn label(&self) -> &str {
        &self.disk.label
    }

    fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    fn scalars(&self) -> &[Scalar] {
        &self.disk.scalars
    }

    fn acts(&self) -> bool {
        false
    }

    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        mut jacobian: Option<&mut LocalJacobian>,
    ) {
        let hub = self.hub(at);
        self.add_flow(at, &hub, out, jacobian.as_deref_mut());
        for row in LOADS..STATES {
            out.add_scalar(row, at.scalars.values[row]);
            if let Some(out) = jacobian.as_deref_mut() {
                out.add_scalar(row, row, 1.0, false);
            }
        }
        self.add_states(at, &hub, out, jacobian.as_deref_mut());
        self.add_ground(at, &hub, out, jacobian);
    }

    has!(fixed_axes: FixedAxes);
}

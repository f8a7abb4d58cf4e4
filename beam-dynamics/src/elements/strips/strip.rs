//! A strip as an element: the flow from the motion of its nodes, and the forces of the air back on
//! them.
//!
//! With the force f and the moment m per length in the airfoil axes (see
//! [`rotor_aero::strip::Strip`]), the length ds of the strip and the part of the air that acts,
//! the carried point gets
//!
//! ```text
//! F   = R_a f ds                                 M   = a x F + R_a e_z m ds
//! d F = -[F]x theta + R_a d f ds                 d M = [a]x d F + [F]x [a]x theta
//!                                                      - [R_a e_z m ds]x theta + R_a e_z d m ds
//! ```
//!
//! References: [Masarati], 5.9.

use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};
use rotor_aero::strip::{
    ActingAir, FLOW as STRIP_FLOW, LOADS, OUTPUTS, STATES, Strip, StripJacobian,
};

use super::air::{Air, LARGER_TABLES};
use super::carrier::{Carrier, CarrierState};
use super::columns::{Columns, FLAP, Loads, OWN, TIP};
use super::disk::RotorDisk;
use super::in_disk::InDisk;
use super::kinematics::{Flow, Mount};
use super::shaft::Shaft;
use crate::elements::beams::{BeamGeometry, LinePoint};
use crate::elements::{
    Element, Energetic, Energy, EnergySlope, Exchange, Local, LocalJacobian, LocalResidual, Motion,
    Reports, Settling, Signal, StripLocation, Structure, has,
};
use crate::model::{Node, NodeMotion, Quantity, Scalar, ScalarSpec, ScalarStart};

/// Geometry of a strip on the section or body that carries it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StripGeometry {
    /// Quarter chord from the carried point, in its axes \[m\].
    pub offset: Vector3<f64>,
    /// Airfoil axes (columns) in the axes of the carried point: x toward the leading edge, y to
    /// the upper surface, z along the span \[-\].
    pub axes: Matrix3<f64>,
    /// Length along the span \[m\].
    pub length: f64,
}

/// The rotor of a strip.
#[derive(Debug, Clone)]
pub struct StripRotor {
    /// Its shaft.
    pub shaft: Shaft,
    /// The node that carries the shaft; the frame if none.
    pub hub: Option<usize>,
    /// The radius of the tip of the blade.
    pub tip_radius: Scalar,
    /// Its disk, if a model of the disk gives the inflow.
    pub disk: Option<Arc<RotorDisk>>,
}

/// A strip in the air.
#[derive(Debug, Clone)]
pub struct AirStrip {
    label: String,
    pub(super) location: Arc<StripLocation>,
    nodes: Vec<usize>,
    pub(super) mount: Mount,
    pub(super) length: f64,
    pub(super) strip: Arc<Strip>,
    pub(super) air: Arc<Air>,
    /// Deflection of its flap, trailing edge down \[rad\].
    flap: Option<Signal>,
    /// Its states, the radius of the tip if it has a rotor, the unknowns of its disk, and the ones
    /// that the deflection reads.
    scalars: Vec<Scalar>,
    /// Its disk.
    in_disk: Option<InDisk>,
    /// The quarter chord in the undeformed model \[m\].
    start: Vector3<f64>,
    /// Its distance there from the nearest node of the carrier \[m\].
    arm: f64,
}

impl AirStrip {
    /// A strip on the line of a beam at xi. Only a strip without an inflow may be without a rotor.
    pub fn on_beam(
        label: impl Into<String>,
        (nodes, geometry, undeformed): ([usize; 3], BeamGeometry, &[&Node; 3]),
        xi: f64,
        strip: (Arc<Strip>, StripGeometry),
        rotor: Option<StripRotor>,
        air: Arc<Air>,
    ) -> Self {
        let point = LinePoint::new(geometry, undeformed, xi);
        let carrier = Carrier::Beam(Box::new(point));
        let start = undeformed.map(NodeMotion::at_rest);
        let carrier = (carrier, nodes.to_vec(), &start[..]);
        Self::new(label.into(), carrier, strip, rotor, air)
    }

    /// A strip on a body: the carried point is at `offset` from the node, with the axes of the
    /// node; `undeformed` is the node itself. Only a strip without an inflow may be without a
    /// rotor.
    pub fn on_body(
        label: impl Into<String>,
        (node, undeformed, offset): (usize, &Node, Vector3<f64>),
        strip: (Arc<Strip>, StripGeometry),
        rotor: Option<StripRotor>,
        air: Arc<Air>,
    ) -> Self {
        let carrier = Carrier::Body(offset, Matrix3::identity());
        let start = [NodeMotion::at_rest(undeformed)];
        let carrier = (carrier, vec![node], &start[..]);
        Self::new(label.into(), carrier, strip, rotor, air)
    }

    /// A strip on a carrier with its nodes, and their motion in the undeformed model.
    fn new(
        label: String,
        (carrier, mut nodes, undeformed): (Carrier, Vec<usize>, &[NodeMotion]),
        (strip, geometry): (Arc<Strip>, StripGeometry),
        rotor: Option<StripRotor>,
        air: Arc<Air>,
    ) -> Self {
        let hub = rotor.as_ref().and_then(|rotor| rotor.hub).map(|hub| {
            nodes.push(hub);
            nodes.len() - 1
        });
        let states = strip.states().iter().map(|state| {
            Scalar::new(ScalarSpec {
                owner: label.clone(),
                unknown: Quantity::new(state.name, state.unit, 1.0),
                equation: Quantity::new(format!("equation of {}", state.name), state.row_unit, 1.0),
                has_rate: state.has_rate,
                rate: None,
                start: ScalarStart::Settled,
            })
        });
        let shaft = rotor.as_ref().map(|rotor| rotor.shaft);
        let disk = rotor.as_ref().and_then(|rotor| rotor.disk.clone());
        let tip = rotor.map(|rotor| rotor.tip_radius);
        let mut scalars: Vec<_> = states.chain(tip).collect();
        let in_disk = disk.clone();
        let in_disk = in_disk.map(|disk| InDisk::new(disk, scalars.len(), geometry.length));
        let of_disk = in_disk.iter().flat_map(InDisk::scalars);
        scalars.extend(of_disk.cloned());
        let mount = Mount {
            carrier,
            offset: geometry.offset,
            axes: geometry.axes,
            shaft,
            hub,
            disk,
        };
        let start = mount.quarter_chord(undeformed);
        let arms = undeformed.iter().map(|node| (start - node.position).norm());
        Self {
            label,
            location: Arc::default(),
            nodes,
            arm: arms.fold(f64::INFINITY, f64::min),
            start,
            mount,
            length: geometry.length,
            strip,
            air,
            flap: None,
            scalars,
            in_disk,
        }
    }

    /// The quarter chord in the undeformed model \[m\].
    pub fn start(&self) -> &Vector3<f64> {
        &self.start
    }

    /// With its location in the model, for reports.
    pub fn placed(self, location: StripLocation) -> Self {
        Self {
            location: Arc::new(location),
            ..self
        }
    }

    /// With a flap, if the strip has one, of a deflection \[rad\], trailing edge down.
    pub fn deflected(mut self, deflection: Signal) -> Self {
        self.flap = Some(deflection.bound(&mut self.scalars));
        self
    }

    /// Number of its states: the scalar after them, if any, is the radius of the tip.
    pub(super) fn states(&self) -> usize {
        self.strip.states().len()
    }

    /// Its carrier at a state.
    pub(super) fn carrier(&self, at: &Local<'_>) -> CarrierState<'_> {
        self.mount.carrier.at(at.nodes)
    }

    /// The flow at a state of its carrier.
    pub(super) fn flow<'a>(&self, carrier: &'a CarrierState<'a>, at: &Local<'_>) -> Flow<'a> {
        let air = |point: &_, time| self.air.motion(point, time);
        self.mount.flow(carrier, at, &air)
    }

    /// The numbers of a flow as the strip takes them.
    pub(super) fn numbers(&self, flow: &Flow<'_>, at: &Local<'_>) -> [f64; STRIP_FLOW] {
        let mut numbers = [0.0; STRIP_FLOW];
        numbers[..OWN].copy_from_slice(&flow.numbers[..OWN]);
        if self.mount.shaft.is_some() {
            numbers[TIP] = at.scalars.values[self.states()];
        }
        if let Some(flap) = &self.flap {
            numbers[FLAP] = flap.value(&at.instant());
        }
        numbers
    }

    /// The air that acts.
    pub(super) fn acting(&self, at: &Local<'_>) -> ActingAir<'_> {
        ActingAir {
            still: &self.air.atmosphere,
            part: at.loading.air,
        }
    }

    /// Loads at the carried point from the numbers of the strip.
    fn loads(&self, flow: &Flow<'_>, values: &[f64; OUTPUTS]) -> Loads {
        let size = self.length;
        let force = flow.axes * (size * Vector3::new(values[0], values[1], values[2]));
        let own = flow.axes.column(2) * (size * values[3]);
        Loads {
            force,
            moment: flow.arm.cross(&force) + own,
            own,
        }
    }

    /// Adds the loads and the rows from the numbers of the strip; returns the loads.
    fn add_residual(
        &self,
        (flow, numbers): (&Flow<'_>, &[f64; STRIP_FLOW]),
        at: &Local<'_>,
        values: &[f64; OUTPUTS],
        out: &mut LocalResidual,
    ) -> Loads {
        let loads = self.loads(flow, values);
        flow.point.add(&loads.force, &loads.moment, out);
        let states = self.states();
        let own = (&at.scalars.values[..states], &at.scalars.rates[..states]);
        let sizes = self.strip.sizes(numbers, own.0, own.1);
        for row in 0..states {
            out.add_scalar_sum(row, values[LOADS + row], sizes[row]);
        }
        if let Some(in_disk) = &self.in_disk {
            in_disk.add(&flow.numbers, at.scalars.values, &values[..LOADS], out);
        }
        loads
    }

    /// Visits the scalars that its kernel depends on: the column of each, the input of the kernel
    /// and its derivative.
    pub(super) fn each_scalar(
        &self,
        at: &Local<'_>,
        mut visit: impl FnMut((usize, bool), usize, f64),
    ) {
        let states = self.strip.states();
        for (k, state) in states.iter().enumerate() {
            visit((k, false), STRIP_FLOW + k, 1.0);
            if state.has_rate {
                visit((k, true), STRIP_FLOW + STATES + k, 1.0);
            }
        }
        if self.mount.shaft.is_some() {
            visit((states.len(), false), TIP, 1.0);
        }
        if let Some(flap) = &self.flap {
            flap.gradient(&at.instant(), |scalar, slope| {
                visit((scalar, false), FLAP, slope);
            });
        }
    }

    /// Adds the derivatives by the states, their rates, the radius of the tip, the scalars that the
    /// deflection of the flap reads, and the unknowns of the disk.
    fn add_scalars(&self, columns: &Columns<'_>, at: &Local<'_>, out: &mut LocalJacobian) {
        self.each_scalar(at, |column, input, slope| {
            columns.add_scalar(column, (input, slope), out);
        });
        if let Some(in_disk) = columns.in_disk {
            in_disk.add_induced(out);
        }
    }
}

impl Element for AirStrip {
    fn label(&self) -> &str {
        &self.label
    }

    fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    fn scalars(&self) -> &[Scalar] {
        &self.scalars
    }

    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        let carrier = self.carrier(at);
        let flow = self.flow(&carrier, at);
        let numbers = self.numbers(&flow, at);
        let states = self.states();
        let (values, rates) = (&at.scalars.values[..states], &at.scalars.rates[..states]);
        let air = self.acting(at);
        // Models of sections may have forces at any speed.
        let is_known = numbers.iter().all(|number| number.is_finite())
            && (!self.air.refuses_mach() || self.strip.is_within_tables(air, &numbers));
        let Some(jacobian) = jacobian else {
            let found = if is_known {
                self.strip.evaluate(air, &numbers, values, rates)
            } else {
                [f64::NAN; OUTPUTS]
            };
            self.add_residual((&flow, &numbers), at, &found, out);
            return;
        };
        let by = if is_known {
            self.strip.linearize(air, &numbers, values, rates)
        } else {
            StripJacobian::of_values([f64::NAN; OUTPUTS])
        };
        let loads = self.add_residual((&flow, &numbers), at, &by.values, out);
        let scalars = at.scalars.values;
        let in_disk = self.in_disk.as_ref();
        let in_disk = in_disk.map(|disk| disk.at(&flow.numbers, scalars, &by.values[..LOADS]));
        flow.state
            .add_variation(&loads.force, &loads.moment, jacobian);
        let columns = Columns {
            flow: &flow,
            loads: &loads,
            by: &by,
            in_disk: in_disk.as_ref(),
            length: self.length,
            states,
        };
        columns.add_nodes(at, self.mount.hub, jacobian);
        self.add_scalars(&columns, at, jacobian);
    }

    fn each_signal<'a>(&'a self, visit: &mut dyn FnMut(&'a Signal)) {
        self.flap.iter().for_each(visit);
    }

    fn next_own_corner(&self, time: f64) -> f64 {
        self.air.wind().next_corner(&self.start, time)
    }

    fn settling(&self) -> Option<&dyn Settling> {
        let strip = &self.strip;
        (strip.needs_start() || strip.has_annulus()).then_some(self as &dyn Settling)
    }

    has!(energetic: Energetic, structure: Structure, reports: Reports);
}

impl Settling for AirStrip {
    fn begin(&self, at: &Local<'_>, scalars: &mut [f64]) {
        let numbers = self.numbers(&self.flow(&self.carrier(at), at), at);
        let states = &mut scalars[..self.states()];
        self.strip.begin(self.acting(at), &numbers, states);
    }

    fn settle(&self, at: &Local<'_>, scalars: &mut [f64]) {
        if !self.strip.needs_start() {
            return;
        }
        let numbers = self.numbers(&self.flow(&self.carrier(at), at), at);
        let states = &mut scalars[..self.states()];
        self.strip.settle(self.acting(at), &numbers, states);
    }
}

impl Structure for AirStrip {
    fn arm(&self) -> f64 {
        self.arm
    }

    fn is_joining(&self) -> bool {
        false
    }

    fn free_motions(&self) -> Vec<Motion> {
        Vec::new()
    }

    fn loaded_turn(&self, _at: &Local<'_>) -> Option<Vector3<f64>> {
        None
    }

    fn undefined(&self, at: &Local<'_>) -> Option<String> {
        let point = self.mount.quarter_chord(at.nodes);
        let of_air = self.air.undefined(&point, at.loading.time);
        of_air.or_else(|| {
            let numbers = self.numbers(&self.flow(&self.carrier(at), at), at);
            let beyond = self.strip.beyond_mach(self.acting(at), &numbers)?;
            let refused = self.air.refuses_mach();
            refused.then(|| format!("{beyond}; {LARGER_TABLES}"))
        })
    }
}

impl Energetic for AirStrip {
    fn stored(&self, _at: &Local<'_>) -> Energy {
        Energy::default()
    }

    fn exchanged(&self) -> Exchange {
        Exchange::Driven
    }

    fn is_conservative(&self) -> bool {
        false
    }

    fn slope(&self) -> EnergySlope {
        EnergySlope::Zero
    }
}

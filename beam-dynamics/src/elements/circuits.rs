//! Electrodes of the model and their circuits.
//!
//! With the charge Q that the beams report ([`super::beams::Beam`]), C the capacitance of the
//! electrode over all beams and E a given voltage, the circuits are
//!
//! ```text
//! held      V = E(t)                        no unknown
//! open      ( Q_0 - Q(y, V) ) / C = 0                                          (D-264)
//! shunted   ( Q - Q(y, V) ) / C   = 0
//!           V - E + R Q'          = 0                                          (D-265)
//! with L    ( Q - Q(y, V) ) / C   = 0
//!           sqrt(L/C) ( Q' - I )  = 0
//!           V - E + R I + L I'    = 0                                          (D-266)
//! ```
//!
//! of the unknowns V, then Q, then I. The part by y and V is added by the beams. A state of rest
//! has no current, so that its voltage is E; in motion the energy changes by the work of the source
//! and the loss of the resistor,
//!
//! ```text
//! d/dt ( kinetic + elastic + 1/2 V C V + 1/2 L I^2 ) = E I - R I^2 + loads     (D-267)
//! ```
//!
//! References: [Masarati], piezoelectric beams; [HagoodFlotow1991], shunts.

use super::{
    Charges, CircuitState, Element, Energy, EnergySlope, Flow, Local, LocalJacobian, LocalResidual,
    Signal,
};
use crate::elements::{Energetic, Exchange, Observations, Reading, ReadingRow, Reports, has};
use crate::model::{Quantity, Scalar, ScalarSpec, ScalarStart};

/// Connection of an electrode.
#[derive(Debug, Clone, PartialEq)]
pub enum Circuit {
    /// A source of voltage [V].
    Held(Signal),
    /// Open: its charge is constant.
    Open {
        /// The charge [C].
        charge: f64,
    },
    /// A source through a resistor and an inductance.
    Shunt {
        /// Voltage of the source [V].
        source: Signal,
        /// Resistance, above zero if there is no inductance [Ohm].
        resistance: f64,
        /// Inductance; zero for none [H].
        inductance: f64,
    },
}

impl Circuit {
    /// The unknowns of the circuit of the electrode `owner` of the given `capacitance` \[F\]:
    /// voltage, charge and current, as far as they exist, in scales of one volt.
    pub fn scalars(&self, owner: &str, capacitance: f64) -> Vec<Scalar> {
        let scalar = |[name, unit]: [&str; 2], size: f64, equation: &str, has_rate: bool| {
            Scalar::new(ScalarSpec {
                owner: owner.to_owned(),
                unknown: Quantity::new(name, unit, size),
                equation: Quantity::new(equation, "V", 1.0),
                has_rate,
                rate: None,
                start: ScalarStart::Settled,
            })
        };
        let voltage = || scalar(["voltage", "V"], 1.0, "charge over capacitance", false);
        let words = "voltages, or rate of charge,";
        let charge = || scalar(["charge", "C"], capacitance, words, true);
        match self {
            Self::Held(_) => Vec::new(),
            Self::Open { .. } => vec![voltage()],
            Self::Shunt { inductance, .. } if *inductance > 0.0 => {
                let size = (capacitance / inductance).sqrt();
                let current = scalar(["current", "A"], size, "voltages", true);
                vec![voltage(), charge(), current]
            }
            Self::Shunt { .. } => vec![voltage(), charge()],
        }
    }

    /// Whether its voltage is unknown.
    pub fn has_unknowns(&self) -> bool {
        !matches!(self, Self::Held(_))
    }

    /// The given voltage.
    fn source(&self) -> Option<&Signal> {
        match self {
            Self::Held(source) | Self::Shunt { source, .. } => Some(source),
            Self::Open { .. } => None,
        }
    }
}

/// An electrode of the model in its circuit.
#[derive(Debug, Clone)]
pub struct Electrode {
    label: String,
    number: usize,
    circuit: Circuit,
    /// Its voltage, charge and current, as far as they are unknown, then the scalars that its
    /// source reads.
    scalars: Vec<Scalar>,
    /// The index of the first of these.
    own: usize,
    /// Capacitance at constant strain [F].
    capacitance: f64,
}

impl Electrode {
    /// Electrode `number` of the given `capacitance` over all its beams \[F\], with the unknowns of
    /// its circuit, see [`Circuit::scalars`].
    pub fn new(
        label: impl Into<String>,
        number: usize,
        mut circuit: Circuit,
        mut scalars: Vec<Scalar>,
        capacitance: f64,
    ) -> Self {
        let own = scalars.len();
        if let Circuit::Held(source) | Circuit::Shunt { source, .. } = &mut circuit {
            source.bind(&mut scalars);
        }
        Self {
            label: label.into(),
            number,
            own,
            scalars,
            circuit,
            capacitance,
        }
    }

    /// `sqrt(L/C)`.
    fn impedance(&self, inductance: f64) -> f64 {
        (inductance / self.capacitance).sqrt()
    }

    fn source(&self, at: &Local<'_>) -> f64 {
        let source = self.circuit.source();
        source.map_or(0.0, |source| {
            at.loading.voltages * source.value(&at.instant())
        })
    }
}

impl Electrode {
    fn add_residual(&self, at: &Local<'_>, out: &mut LocalResidual) {
        match &self.circuit {
            Circuit::Held(_) => {}
            Circuit::Open { charge } => out.add_scalar(0, charge / self.capacitance),
            Circuit::Shunt {
                resistance,
                inductance,
                ..
            } => {
                let [voltage, _] = unknown(0, at);
                let [charge, charge_rate] = unknown(1, at);
                out.add_scalar(0, charge / self.capacitance);
                let last = self.own - 1;
                out.add_scalar(last, voltage);
                out.add_scalar(last, -self.source(at));
                if last == 1 {
                    out.add_scalar(1, resistance * charge_rate);
                    return;
                }
                let [current, current_rate] = unknown(2, at);
                let impedance = self.impedance(*inductance);
                out.add_scalar(1, impedance * charge_rate);
                out.add_scalar(1, -impedance * current);
                out.add_scalar(2, resistance * current);
                out.add_scalar(2, inductance * current_rate);
            }
        }
    }

    fn add_jacobian(&self, at: &Local<'_>, out: &mut LocalJacobian) {
        let Circuit::Shunt {
            source,
            resistance,
            inductance,
        } = &self.circuit
        else {
            return;
        };
        let (resistance, inductance) = (*resistance, *inductance);
        let last = self.own - 1;
        out.add_scalar(0, 1, 1.0 / self.capacitance, false);
        out.add_scalar(last, 0, 1.0, false);
        source.gradient(&at.instant(), |scalar, slope| {
            out.add_scalar(last, scalar, -at.loading.voltages * slope, false);
        });
        if last == 1 {
            out.add_scalar(1, 1, resistance, true);
            return;
        }
        let impedance = self.impedance(inductance);
        out.add_scalar(1, 1, impedance, true);
        out.add_scalar(1, 2, -impedance, false);
        out.add_scalar(2, 2, resistance, false);
        out.add_scalar(2, 2, inductance, true);
    }
}

impl Element for Electrode {
    fn label(&self) -> &str {
        &self.label
    }

    fn nodes(&self) -> &[usize] {
        &[]
    }

    fn scalars(&self) -> &[Scalar] {
        &self.scalars
    }

    fn each_signal<'a>(&'a self, visit: &mut dyn FnMut(&'a Signal)) {
        self.circuit.source().into_iter().for_each(visit);
    }

    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        self.add_residual(at, out);
        if let Some(out) = jacobian {
            self.add_jacobian(at, out);
        }
    }

    has!(energetic: Energetic, reports: Reports);
}

impl Energetic for Electrode {
    fn stored(&self, at: &Local<'_>) -> Energy {
        let electric = match self.circuit {
            Circuit::Shunt { inductance, .. } if inductance > 0.0 => {
                let [current, _] = unknown(2, at);
                0.5 * inductance * current * current
            }
            _ => 0.0,
        };
        Energy {
            electric,
            ..Energy::default()
        }
    }

    fn exchanged(&self) -> Exchange {
        Exchange::by_signals(self)
    }

    fn is_conservative(&self) -> bool {
        true
    }

    fn slope(&self) -> EnergySlope {
        EnergySlope::Unknown
    }
}

impl Reports for Electrode {
    fn report(&self, _at: &Local<'_>, _out: &mut Observations) {}

    fn reading(
        &self,
        _reading: &Reading,
        _at: &Local<'_>,
        _row: Option<&mut ReadingRow<'_>>,
    ) -> Option<f64> {
        None
    }

    fn report_charges(&self, at: &Local<'_>, out: &mut Charges) {
        let (voltage, flow) = match &self.circuit {
            Circuit::Held(source) => {
                let now = source.at(&at.instant());
                (now.value, Flow::Voltage(now.rate))
            }
            Circuit::Open { .. } => (unknown(0, at)[0], Flow::Current(0.0)),
            Circuit::Shunt { resistance, .. } => {
                let [voltage, _] = unknown(0, at);
                let current = match self.own {
                    3 => unknown(2, at)[0],
                    _ => (self.source(at) - voltage) / resistance,
                };
                (voltage, Flow::Current(current))
            }
        };
        out.circuits.push(CircuitState {
            number: self.number,
            name: self.label.clone(),
            voltage,
            flow,
        });
    }
}

/// Value of the unknown `i` of an electrode, and its rate.
fn unknown(i: usize, at: &Local<'_>) -> [f64; 2] {
    [at.scalars.values[i], at.scalars.rates[i]]
}

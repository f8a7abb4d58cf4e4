//! Electrodes of the model and the circuits that they are in.
//!
//! With the charge Q that the beams report ([`super::beams::Beam`]), C the capacitance
//! of the electrode over all beams and E a voltage that is given, the circuits are
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
//! of the unknowns V, then Q, then I. The part by y and V is added by the beams. A state of
//! rest has no current, so that its voltage is E; the energy of a state in motion changes by
//! what the source gives and the resistor takes,
//!
//! ```text
//! d/dt ( kinetic + elastic + 1/2 V C V + 1/2 L I^2 ) = E I - R I^2 + loads     (D-267)
//! ```
//!
//! References: [Masarati], piezoelectric beams; [HagoodFlotow1991], shunts.

use super::{
    Charges, CircuitState, ElectricKind, ElectricUnknown, Element, Energy, Flow, Local,
    LocalJacobian, LocalResidual,
};
use crate::model::Drive;

/// What an electrode is connected to.
#[derive(Debug, Clone, PartialEq)]
pub enum Circuit {
    /// A source of voltage [V].
    Held(Drive),
    /// Nothing: its charge is held.
    Open {
        /// The charge [C].
        charge: f64,
    },
    /// A source through a resistor and an inductance.
    Shunt {
        /// Voltage of the source [V].
        source: Drive,
        /// Resistance, above zero where there is no inductance [Ohm].
        resistance: f64,
        /// Inductance; zero for none [H].
        inductance: f64,
    },
}

impl Circuit {
    /// Number of electric unknowns.
    pub fn unknowns(&self) -> usize {
        match self {
            Self::Held(_) => 0,
            Self::Open { .. } => 1,
            Self::Shunt { inductance, .. } if *inductance > 0.0 => 3,
            Self::Shunt { .. } => 2,
        }
    }

    /// The voltage that is given.
    fn source(&self) -> Option<&Drive> {
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
    /// Its electric unknowns.
    unknowns: Vec<usize>,
    /// Capacitance at constant strain [F].
    capacitance: f64,
}

impl Electrode {
    /// Electrode number `number`, of the given `capacitance` over all its beams \[F\], the
    /// electric unknowns of which are numbered from `first` on.
    pub fn new(
        label: impl Into<String>,
        number: usize,
        circuit: Circuit,
        first: usize,
        capacitance: f64,
    ) -> Self {
        Self {
            label: label.into(),
            number,
            unknowns: (first..first + circuit.unknowns()).collect(),
            circuit,
            capacitance,
        }
    }

    /// Value of its unknown number `i`, and the rate.
    fn unknown(&self, i: usize, at: &Local<'_>) -> [f64; 2] {
        let number = self.unknowns[i];
        [at.electric.values[number], at.electric.rates[number]]
    }

    /// `sqrt(L/C)`.
    fn impedance(&self, inductance: f64) -> f64 {
        (inductance / self.capacitance).sqrt()
    }

    fn source(&self, at: &Local<'_>) -> f64 {
        let source = self.circuit.source();
        source.map_or(0.0, |source| {
            at.loading.voltages * source.at(at.loading.time).value
        })
    }
}

impl Element for Electrode {
    fn label(&self) -> &str {
        &self.label
    }

    fn nodes(&self) -> &[usize] {
        &[]
    }

    fn electric(&self) -> &[usize] {
        &self.unknowns
    }

    fn brings(&self) -> Vec<(usize, ElectricUnknown)> {
        const KINDS: [ElectricKind; 3] = [
            ElectricKind::Voltage,
            ElectricKind::Charge,
            ElectricKind::Current,
        ];
        let unknown = |(number, kind): (&usize, ElectricKind)| {
            let electrode = self.label.clone();
            (*number, ElectricUnknown { electrode, kind })
        };
        self.unknowns.iter().zip(KINDS).map(unknown).collect()
    }

    fn each_drive<'a>(&'a self, visit: &mut dyn FnMut(&'a Drive)) {
        self.circuit.source().into_iter().for_each(visit);
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let electric = match self.circuit {
            Circuit::Shunt { inductance, .. } if inductance > 0.0 => {
                let [current, _] = self.unknown(2, at);
                0.5 * inductance * current * current
            }
            _ => 0.0,
        };
        Energy {
            electric,
            ..Energy::default()
        }
    }

    fn residual(&self, at: &Local<'_>, out: &mut LocalResidual) {
        match &self.circuit {
            Circuit::Held(_) => {}
            Circuit::Open { charge } => out.add_constraint(0, charge / self.capacitance),
            Circuit::Shunt {
                resistance,
                inductance,
                ..
            } => {
                let [voltage, _] = self.unknown(0, at);
                let [charge, charge_rate] = self.unknown(1, at);
                out.add_constraint(0, charge / self.capacitance);
                let last = self.unknowns.len() - 1;
                out.add_constraint(last, voltage);
                out.add_constraint(last, -self.source(at));
                if last == 1 {
                    out.add_constraint(1, resistance * charge_rate);
                    return;
                }
                let [current, current_rate] = self.unknown(2, at);
                let impedance = self.impedance(*inductance);
                out.add_constraint(1, impedance * charge_rate);
                out.add_constraint(1, -impedance * current);
                out.add_constraint(2, resistance * current);
                out.add_constraint(2, inductance * current_rate);
            }
        }
    }

    fn jacobian(&self, _at: &Local<'_>, out: &mut LocalJacobian) {
        let Circuit::Shunt {
            resistance,
            inductance,
            ..
        } = self.circuit
        else {
            return;
        };
        let last = self.unknowns.len() - 1;
        out.add_electric(0, 1, 1.0 / self.capacitance, false);
        out.add_electric(last, 0, 1.0, false);
        if last == 1 {
            out.add_electric(1, 1, resistance, true);
            return;
        }
        let impedance = self.impedance(inductance);
        out.add_electric(1, 1, impedance, true);
        out.add_electric(1, 2, -impedance, false);
        out.add_electric(2, 2, resistance, false);
        out.add_electric(2, 2, inductance, true);
    }

    fn charges(&self, at: &Local<'_>, out: &mut Charges) {
        let (voltage, flow) = match &self.circuit {
            Circuit::Held(source) => {
                let now = source.at(at.loading.time);
                (now.value, Flow::Voltage(now.rate))
            }
            Circuit::Open { .. } => (self.unknown(0, at)[0], Flow::Current(0.0)),
            Circuit::Shunt { resistance, .. } => {
                let [voltage, _] = self.unknown(0, at);
                let current = match self.unknowns.len() {
                    3 => self.unknown(2, at)[0],
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

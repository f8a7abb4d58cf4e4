//! Charges, voltages and currents of electrodes, as the elements report them.

use nalgebra::{DMatrix, DVector};

/// Drive of the charge of an electrode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Flow {
    /// Its voltage is given: its rate [V/s].
    Voltage(f64),
    /// Its current is known [A].
    Current(f64),
}

/// The circuit of an electrode at a state.
#[derive(Debug, Clone, PartialEq)]
pub struct CircuitState {
    /// Index of the electrode.
    pub number: usize,
    /// Its name.
    pub name: String,
    /// Its voltage [V].
    pub voltage: f64,
    /// Drive of its charge.
    pub flow: Flow,
}

/// An electrode at a state.
#[derive(Debug, Clone, PartialEq)]
pub struct ElectrodeState {
    /// Its name.
    pub name: String,
    /// Its voltage relative to ground [V].
    pub voltage: f64,
    /// Its free charge [C].
    pub charge: f64,
    /// The current into it: the rate of the charge [A].
    pub current: f64,
}

/// Contributions of the elements to electrodes, summed.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Charges {
    /// Indices of two electrodes, and a part of the charge of the first per volt on the second [F].
    pub capacitance: Vec<(usize, usize, f64)>,
    /// Index of an electrode, a part of its charge due to strains, and its rate [C, A].
    pub by_strain: Vec<(usize, f64, f64)>,
    /// The circuits.
    pub circuits: Vec<CircuitState>,
}

impl Charges {
    /// The electrodes, in the order of their indices. With s the part of the currents due to rates
    /// of strain, h the electrodes of given voltage and f the others,
    ///
    /// ```text
    /// Q = -Theta' eps + C V          I = s + C V'
    /// C_ff V'_f = I_f - s_f - C_fh V'_h                                        (D-268)
    /// ```
    pub fn electrodes(&self) -> Vec<ElectrodeState> {
        if self.circuits.is_empty() {
            return Vec::new();
        }
        let mut circuits: Vec<_> = self.circuits.iter().collect();
        circuits.sort_by_key(|circuit| circuit.number);
        let index = |number: usize| circuits.iter().position(|own| own.number == number);
        let n = circuits.len();
        let mut capacitance = DMatrix::zeros(n, n);
        for (i, j, part) in &self.capacitance {
            if let (Some(i), Some(j)) = (index(*i), index(*j)) {
                capacitance[(i, j)] += part;
            }
        }
        let (mut by_strain, mut currents) = (DVector::zeros(n), DVector::zeros(n));
        for (i, charge, rate) in &self.by_strain {
            if let Some(i) = index(*i) {
                by_strain[i] += charge;
                currents[i] += rate;
            }
        }
        let voltages = DVector::from_iterator(n, circuits.iter().map(|own| own.voltage));
        let charges = by_strain + &capacitance * voltages;
        let flows: Vec<_> = circuits.iter().map(|circuit| circuit.flow).collect();
        currents += &capacitance * rates(&flows, &capacitance, &currents);
        let of = |(i, circuit): (usize, &&CircuitState)| ElectrodeState {
            name: circuit.name.clone(),
            voltage: circuit.voltage,
            charge: charges[i],
            current: match circuit.flow {
                Flow::Current(current) => current,
                Flow::Voltage(_) => currents[i],
            },
        };
        circuits.iter().enumerate().map(of).collect()
    }
}

/// Rates of all voltages, given the currents `strained` due to rates of strain.
fn rates(flows: &[Flow], capacitance: &DMatrix<f64>, strained: &DVector<f64>) -> DVector<f64> {
    let mut matrix = capacitance.clone();
    let mut right = DVector::zeros(flows.len());
    for (i, flow) in flows.iter().enumerate() {
        match flow {
            Flow::Voltage(rate) => {
                matrix.row_mut(i).fill(0.0);
                matrix[(i, i)] = 1.0;
                right[i] = *rate;
            }
            Flow::Current(current) => right[i] = current - strained[i],
        }
    }
    matrix.lu().solve(&right).unwrap_or(right)
}

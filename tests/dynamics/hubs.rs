//! Hubs of rotors in full models: flapping, stops, links, dampers and the loads on the fixed frame.

use beam_dynamics::analysis::periodic::periodic;
use beam_dynamics::analysis::transient::transient;
use beam_dynamics::input::{self, Input};
use beam_dynamics::result::{AcceptedStep, ColumnValues, Recorder};

mod flapping;
mod links;
mod loads;
mod stops;

/// Radii of root and tip \[m\], mass per length \[kg/m\] of all blades.
const ROOT: f64 = 0.2;
const TIP: f64 = 1.2;
const MASS: f64 = 2.0;

/// Sections without bending: moments of inertia per length \[kg m\].
fn stiff([iy, iz]: [f64; 2]) -> String {
    format!(
        "units = \"SI\"\n[properties.strip]\nea = 7e9\ngay = 2e9\ngaz = 2e9\ngj = 3e7\neiy = 4e7\n\
         eiz = 4e7\nm = {MASS}\niy = {iy:?}\niz = {iz:?}\n"
    )
}

/// A rotor of a kind with slender blades without bending, its keys and further cards.
fn rotor(kind: &str, blades: usize, keys: &str, cards: &str) -> String {
    format!(
        "{}[[rotor]]\nname = \"r\"\nhub = \"{kind}\"\nblades = {blades}\n{keys}\n[rotor.blade]\n\
         hub_radius = {ROOT}\nproperties = \"strip\"\npiece = [{{ length = 1, elements = 1 }}]\n{cards}",
        stiff([1e-5, 1e-5])
    )
}

/// Moment of inertia of a blade about the center \[kg m^2\].
fn inertia() -> f64 {
    MASS * (TIP.powi(3) - ROOT.powi(3)) / 3.0
}

/// The input of a text.
fn parsed(text: &str) -> Input {
    input::parse(text, "hub.dynamics.toml").unwrap_or_else(|problems| panic!("{problems}\n{text}"))
}

/// Values of columns at all steps.
struct Rows<'a> {
    values: ColumnValues<'a>,
    times: Vec<f64>,
    rows: Vec<Vec<f64>>,
}

impl<'a> Rows<'a> {
    fn of(input: &'a Input) -> Self {
        Self {
            values: ColumnValues::new(&input.model, &input.output),
            times: Vec::new(),
            rows: Vec::new(),
        }
    }

    /// Values of the column `index`.
    fn column(&self, index: usize) -> Vec<f64> {
        self.rows.iter().map(|row| row[index]).collect()
    }
}

impl Recorder for Rows<'_> {
    fn record(&mut self, accepted: &AcceptedStep<'_>) -> bool {
        let mut row = vec![0.0; self.values.columns().len()];
        self.values.evaluate(accepted, &mut row);
        self.times.push(accepted.time);
        self.rows.push(row);
        true
    }
}

/// The columns over the period of a periodic motion, the end left out.
fn over_period(input: &Input) -> Rows<'_> {
    let mut rows = Rows::of(input);
    let outcome = periodic(&input.model, input.periodic.as_ref().unwrap(), &mut rows);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    rows.rows.pop();
    rows
}

/// The columns over a run in time.
fn over_time(input: &Input) -> Rows<'_> {
    let mut rows = Rows::of(input);
    let settings = input.transient.as_ref().unwrap();
    let outcome = transient(&input.model, settings, None, &mut rows, &|| 0.0);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    rows
}

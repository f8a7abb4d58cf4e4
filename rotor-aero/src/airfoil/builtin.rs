//! Airfoils that need no file.

use super::cubic::Interpolation;
use super::data::{AirfoilData, Curve, Flow};
use super::evaluated::Airfoil;
use super::formula::{FlatPlate, LinearLift};
use super::naca0012::naca0012;

/// An airfoil that needs no file.
#[derive(Debug, Clone, Copy)]
pub struct BuiltIn {
    /// Name.
    pub name: &'static str,
    /// Content and source, in one line.
    pub description: &'static str,
    make: fn() -> Airfoil,
    /// The table, unless it is a closed form.
    table: Option<fn() -> AirfoilData>,
}

impl BuiltIn {
    /// The airfoil.
    pub fn airfoil(&self) -> Airfoil {
        (self.make)()
    }

    /// Its table; of a closed form the values at each degree.
    pub fn data(&self) -> AirfoilData {
        match self.table {
            Some(table) => table(),
            None => sampled(self.name, &self.airfoil()),
        }
    }
}

/// The table of an airfoil at each degree, for a Mach number of zero.
fn sampled(name: &str, airfoil: &Airfoil) -> AirfoilData {
    let alpha: Vec<f64> = (-180..=180)
        .map(|degree| f64::from(degree).to_radians())
        .collect();
    let flow = |alpha: &f64| Flow {
        alpha: *alpha,
        mach: 0.0,
        reynolds: 1e6,
        flap: 0.0,
    };
    let values: Vec<_> = alpha.iter().map(|alpha| airfoil.at(&flow(alpha))).collect();
    let curve = |values: Vec<f64>| {
        vec![Curve {
            alpha: alpha.clone(),
            values,
            ..Curve::default()
        }]
    };
    AirfoilData {
        name: name.to_owned(),
        thickness: airfoil.thickness(),
        lift: curve(values.iter().map(|at| at.lift).collect()),
        drag: curve(values.iter().map(|at| at.drag).collect()),
        moment: curve(values.iter().map(|at| at.moment).collect()),
    }
}

/// The list of built-in airfoils.
pub const BUILT_IN: [BuiltIn; 3] = [
    BuiltIn {
        name: "naca0012",
        description: "NACA 0012 at all angles, Mach 0.15 (measured) to 0.8 (formulas of separation)",
        make: table_of_naca0012,
        table: Some(naca0012),
    },
    BuiltIn {
        name: "flat_plate",
        description: "flat plate at all angles, fit of Lindenburg",
        make: || Airfoil::flat_plate(FlatPlate::default()),
        table: None,
    },
    BuiltIn {
        name: "thin",
        description: "thin airfoil: lift slope 2 pi, no stall, no drag, no moment",
        make: || Airfoil::linear(LinearLift::default()),
        table: None,
    },
];

/// The built-in airfoil of this name.
pub fn built_in(name: &str) -> Option<Airfoil> {
    let found = BUILT_IN.iter().find(|entry| entry.name == name);
    found.map(BuiltIn::airfoil)
}

fn table_of_naca0012() -> Airfoil {
    Airfoil::new(&naca0012(), Interpolation::Monotone)
        .expect("a test checks that the built-in table has no problems")
}

#[cfg(test)]
mod tests {
    use super::{BUILT_IN, built_in};
    use crate::airfoil::{Airfoil, Flow};

    fn reference(name: &str) -> String {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference/theory-rotor/");
        std::fs::read_to_string(format!("{folder}{name}")).unwrap()
    }

    fn flow(alpha_deg: f64, mach: f64) -> Flow<f64> {
        let (alpha, reynolds, flap) = (alpha_deg.to_radians(), 6e6, 0.0);
        Flow {
            alpha,
            mach,
            reynolds,
            flap,
        }
    }

    fn naca() -> Airfoil {
        built_in("naca0012").unwrap()
    }

    #[test]
    fn names_are_distinct_and_found() {
        for entry in BUILT_IN {
            assert!(built_in(entry.name).is_some());
            assert_eq!(
                BUILT_IN
                    .iter()
                    .filter(|other| other.name == entry.name)
                    .count(),
                1
            );
            assert!(entry.airfoil().remarks().is_empty());
        }
        assert!(built_in("naca0013").is_none());
    }

    /// Below 16 deg the scatter of three grits is 0.012 in lift, and the measured zero lift is at
    /// +0.088 deg, 0.0095 in lift: 0.02 is their sum, rounded. Drag scatters by 0.0012.
    #[test]
    fn naca0012_agrees_with_ladson_below_16_deg() {
        let text = reference("naca0012_ladson_tm4074.csv");
        let mut worst = [0.0_f64; 2];
        for line in text.lines().filter(|line| !line.starts_with(['#', 'g'])) {
            let row: Vec<f64> = line.split(',').map(|word| word.parse().unwrap()).collect();
            let at = naca().at(&flow(row[1], 0.15));
            if row[1] < 16.0 {
                worst[0] = worst[0].max((at.lift - row[2]).abs());
                worst[1] = worst[1].max((at.drag - row[3]).abs());
            }
        }
        assert!(worst[0] < 0.02 && worst[1] < 0.0015, "{worst:?}");
    }

    /// Measurements of Sheldahl and Klimas; the table has them all, but for 65 to 135 deg, where
    /// it has steps of 10 deg: a cubic between them is within 0.01.
    #[test]
    fn naca0012_agrees_with_sheldahl_and_klimas_in_deep_stall() {
        let text = reference("symmetric_section_deep_stall_sand80_2114.csv");
        for line in text.lines().filter(|line| !line.starts_with(['#', 'a'])) {
            let row: Vec<f64> = line.split(',').map(|word| word.parse().unwrap()).collect();
            for sign in [1.0, -1.0] {
                let at = naca().at(&flow(sign * row[0], 0.15));
                assert!((at.lift - sign * row[1]).abs() < 0.011, "{row:?} {at:?}");
                assert!((at.drag - row[2]).abs() < 0.011, "{row:?} {at:?}");
            }
        }
    }
}

//! Propellers by their geometry files and polars of one family.

use std::f64::consts::PI;
use std::sync::Arc;

use rotor_aero::airfoil::{
    Airfoil, AirfoilData, Coefficients, Curve, Flow, Interpolation, Profile,
};
use rotor_aero::real::Real;

use super::{Shared, text};

/// A family of polars with the factor of Prandtl and Glauert on lift.
#[derive(Debug, Clone)]
pub struct Compressible(pub Shared);

impl Profile for Compressible {
    fn at<T: Real>(&self, flow: &Flow<T>) -> Coefficients<T> {
        let found = self.0.at(flow);
        let factor = (-flow.mach * flow.mach + 1.0).sqrt().recip();
        Coefficients {
            lift: found.lift * factor,
            ..found
        }
    }
}

/// A blade as its file gives it: rows of radius, chord \[m\] and twist \[rad\].
pub struct Blade {
    pub radius: f64,
    pub rows: Vec<[f64; 3]>,
}

impl Blade {
    /// A column at a radius, linear between the rows.
    pub fn at(&self, radius: f64, column: usize) -> f64 {
        let after = self.rows.partition_point(|row| row[0] < radius);
        let after = after.clamp(1, self.rows.len() - 1);
        let (low, high) = (self.rows[after - 1], self.rows[after]);
        let share = (radius - low[0]) / (high[0] - low[0]);
        low[column] + share * (high[column] - low[column])
    }
}

/// Reads the rows of 13 numbers, and the radius.
pub fn blade(name: &str) -> Blade {
    let text = text(&format!("aero/propellers/{name}"));
    let inch = 0.0254;
    let mut rows = Vec::new();
    let mut radius = 0.0;
    for line in text.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        let row: Vec<f64> = words.iter().filter_map(|it| it.parse().ok()).collect();
        if row.len() == 13 && words.len() == 13 {
            rows.push([row[0] * inch, row[1] * inch, row[7].to_radians()]);
        }
        if words.first() == Some(&"RADIUS:") {
            radius = row[0] * inch;
        }
    }
    Blade { radius, rows }
}

/// Polars over the Reynolds number, by Viterna's formulas outside their range.
pub fn family(name: &str, ncrit: &str) -> Shared {
    let mut lift = Vec::new();
    let mut drag = Vec::new();
    for reynolds in [
        "0.030", "0.040", "0.060", "0.080", "0.100", "0.130", "0.160", "0.200", "0.300", "0.500",
    ] {
        let label = if name == "CLARK_Y" {
            "CLARK_Y_AIRFOIL"
        } else {
            name
        };
        let path = format!("aero/propellers/{label}_T1_Re{reynolds}_M0.00_{ncrit}.txt");
        let rows = all_angles(&polar(&text(&path)));
        let curve = |column: usize| Curve {
            reynolds: reynolds.parse::<f64>().ok().map(|it| it * 1e6),
            alpha: rows.iter().map(|row| row[0]).collect(),
            values: rows.iter().map(|row| row[column]).collect(),
            ..Curve::default()
        };
        lift.push(curve(1));
        drag.push(curve(2));
    }
    let data = AirfoilData {
        name: name.to_owned(),
        lift,
        drag,
        ..AirfoilData::default()
    };
    Shared(Arc::new(
        Airfoil::new(&data, Interpolation::Linear).expect(name),
    ))
}

fn polar(text: &str) -> Vec<[f64; 3]> {
    let lines = text.lines().skip_while(|line| !line.contains("---"));
    let mut rows: Vec<[f64; 3]> = Vec::new();
    for line in lines.skip(1) {
        let row: Vec<f64> = line
            .split_whitespace()
            .filter_map(|it| it.parse().ok())
            .collect();
        if row.len() > 3 {
            rows.push([row[0].to_radians(), row[1], row[2]]);
        }
    }
    rows
}

/// Viterna's extension to all angles, aspect ratio 10 (Viterna and Janetzke 1982).
fn all_angles(rows: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let (low, high) = (rows[0], rows[rows.len() - 1]);
    let largest = 1.11 + 0.018 * 10.0;
    let (sin, cos) = high[0].sin_cos();
    let a = (high[1] - largest * sin * cos) * sin / (cos * cos);
    let b = (high[2] - largest * sin * sin) / cos;
    let formula = |alpha: f64| {
        let (s, c) = alpha.sin_cos();
        let cl = largest / 2.0 * (2.0 * alpha).sin() + a * c * c / s;
        (cl, (largest * s * s + b * c).max(0.001))
    };
    let value = |alpha: f64| -> (f64, f64) {
        let size = alpha.abs();
        let factor = if alpha < 0.0 { -0.7 } else { 1.0 };
        if size <= PI / 2.0 && size >= high[0] {
            let (cl, cd) = formula(size);
            (factor * cl, cd)
        } else if size <= PI - high[0] {
            let (cl, cd) = formula(PI - size);
            (-0.7 * factor.signum() * cl, cd)
        } else {
            let end = formula(high[0]);
            let share = (PI - size) / high[0];
            let (_, cd) = formula((PI - size).max(1e-3));
            (-0.7 * factor.signum() * end.0 * share, cd)
        }
    };
    let mut all = Vec::new();
    for degree in -180..=180 {
        let alpha = f64::from(degree).to_radians();
        if alpha <= low[0] - 1e-6 || alpha >= high[0] + 1e-6 {
            let (cl, cd) = value(alpha);
            all.push([alpha.clamp(-PI, PI), cl, cd]);
        }
    }
    let before = all.iter().filter(|row| row[0] < low[0]).count();
    all.splice(before..before, rows.iter().copied());
    let last = all.len() - 1;
    all[last] = [PI, all[0][1], all[0][2]];
    all
}

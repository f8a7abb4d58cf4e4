//! Descriptions of distributed loads, in SI units.

use nalgebra::Vector3;

use super::{WrittenDistribution, WrittenLocation, WrittenPart};
use crate::section::{Traction, VolumeForce};

impl WrittenDistribution {
    /// Each part as it was read: `pressure 1000 Pa on curve "top", times 1 - 0.1 x`.
    pub fn words(&self) -> Vec<String> {
        self.parts.iter().filter_map(WrittenPart::words).collect()
    }
}

impl WrittenPart {
    fn words(&self) -> Option<String> {
        let what = match &self.location {
            WrittenLocation::Curve(curve, traction) => {
                let curve = &curve.as_ref()?.text;
                format!("{} on curve \"{curve}\"", of_traction(&(*traction)?))
            }
            WrittenLocation::Region(region, force) => {
                let location = match region.as_ref()? {
                    Some(region) => format!("in region \"{}\"", region.text),
                    None => "everywhere".to_owned(),
                };
                format!("{} {location}", of_volume(&(*force)?))
            }
        };
        let along = self.along.as_ref()?;
        Some(match &along[..] {
            [one] if *one == 1.0 => what,
            along => format!("{what}, times {}", polynomial(along)),
        })
    }
}

fn of_traction(traction: &Traction) -> String {
    match traction {
        Traction::Force(force) => format!("force {} Pa", vector(force)),
        Traction::Pressure(pressure) => format!("pressure {} Pa", number(*pressure)),
        Traction::Tangential(traction) => format!("tangential traction {} Pa", number(*traction)),
    }
}

fn of_volume(force: &VolumeForce) -> String {
    match force {
        VolumeForce::Force(force) => format!("force {} N/m^3", vector(force)),
        VolumeForce::Acceleration(a) => format!("acceleration {} m/s^2", vector(a)),
    }
}

fn vector(v: &Vector3<f64>) -> String {
    let [x, y, z] = [v.x, v.y, v.z].map(number);
    format!("[{x}, {y}, {z}]")
}

/// `1 - 0.1 x + 2 x^3`, x in meters.
fn polynomial(coefficients: &[f64]) -> String {
    let mut words = String::new();
    for (power, c) in coefficients.iter().enumerate() {
        if *c == 0.0 {
            continue;
        }
        words += match (words.is_empty(), *c < 0.0) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        words += &number(c.abs());
        words += &match power {
            0 => String::new(),
            1 => " x".to_owned(),
            power => format!(" x^{power}"),
        };
    }
    words
}

/// At most six digits.
fn number(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    if rounded != 0.0 && !(1e-4..1e7).contains(&rounded.abs()) {
        format!("{rounded:e}")
    } else {
        rounded.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_reported_as_they_are_written() {
        assert_eq!(polynomial(&[0.0, -0.5, 0.0, 2.0]), "-0.5 x + 2 x^3");
        assert_eq!(
            polynomial(&[1.0, 1.0 / 3.0, -2e-9]),
            "1 + 0.333333 x - 2e-9 x^2"
        );
        let force = VolumeForce::Acceleration(Vector3::new(0.0, 0.0, -9.81));
        assert_eq!(of_volume(&force), "acceleration [0, 0, -9.81] m/s^2");
        assert_eq!(
            of_traction(&Traction::Pressure(-2.5e8)),
            "pressure -2.5e8 Pa"
        );
    }
}

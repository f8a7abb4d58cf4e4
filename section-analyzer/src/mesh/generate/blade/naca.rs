//! Four-digit NACA airfoils.
//!
//! ```text
//! z_t = 5 t (a0 sqrt(x) + a1 x + a2 x^2 + a3 x^3 + a4 x^4)
//! z_c = m/p^2 (2 p x - x^2)  up to x = p,    m/(1-p)^2 (1 - 2 p + 2 p x - x^2)  beyond
//! (x, z) = (x -+ z_t sin f, z_c +- z_t cos f),      tan f = dz_c/dx
//! ```
//!
//! # References
//! - [Jacobs1933], section "Profiles".

use std::f64::consts::PI;

use super::problem::BladeProblem;

/// Expected digits.
const FOUR: &str = "four digits, or file = \"airfoil.dat\" with the coordinates of another airfoil";
/// Coefficients of the thickness; with the last one the trailing edge is open by 0.252 %
/// of the chord at a thickness of 12 %.
const OPEN: [f64; 5] = [0.2969, -0.1260, -0.3516, 0.2843, -0.1015];
/// The last coefficient that closes it.
const CLOSING: f64 = -0.1036;
/// Number of points on each surface.
const POINTS: usize = 240;

/// The points of a NACA airfoil: (x/c, z/c) from the trailing edge over the upper surface
/// to the nose and back over the lower one. With `is_closed` the last coefficient of the
/// thickness gives a sharp trailing edge.
///
/// # Errors
/// Digits that are not an airfoil.
pub fn naca(digits: &str, is_closed: bool) -> Result<Vec<[f64; 2]>, BladeProblem> {
    let digit = |letter: char| letter.to_digit(10).map(f64::from);
    let found: Option<Vec<f64>> = digits.chars().map(digit).collect();
    let wrong = |why| BladeProblem::Naca {
        found: digits.to_owned(),
        why,
    };
    let found = found.filter(|found| found.len() == 4);
    let [camber, position, tens, ones] = found.ok_or(wrong(FOUR))?[..] else {
        return Err(wrong(FOUR));
    };
    let (m, p, t) = (0.01 * camber, 0.1 * position, 0.01 * (10.0 * tens + ones));
    if t <= 0.0 {
        return Err(wrong("a thickness, its last two digits, above 00"));
    }
    if (m > 0.0) != (p > 0.0) {
        return Err(wrong(
            "both of the first two digits, camber and its position, or neither",
        ));
    }
    let mut a = OPEN;
    if is_closed {
        a[4] = CLOSING;
    }
    let side = |sign: f64| {
        move |i: usize| {
            let x = 0.5 * (1.0 - (PI * i as f64 / POINTS as f64).cos());
            let half =
                5.0 * t * (a[0] * x.sqrt() + x * (a[1] + x * (a[2] + x * (a[3] + x * a[4]))));
            let (z, slope) = camber_line(m, p, x);
            let f = slope.atan();
            [x - sign * half * f.sin(), z + sign * half * f.cos()]
        }
    };
    let upper = (0..=POINTS).rev().map(side(1.0));
    let lower = (1..=POINTS).map(side(-1.0));
    Ok(upper.chain(lower).collect())
}

/// Height and slope of the camber line.
fn camber_line(m: f64, p: f64, x: f64) -> (f64, f64) {
    if m == 0.0 {
        return (0.0, 0.0);
    }
    if x < p {
        let k = m / (p * p);
        (k * (2.0 * p * x - x * x), 2.0 * k * (p - x))
    } else {
        let k = m / ((1.0 - p) * (1.0 - p));
        (k * (1.0 - 2.0 * p + 2.0 * p * x - x * x), 2.0 * k * (p - x))
    }
}

//! Blades that are valid but suspicious.
//!
//! Stiffness over mass is the square of a speed of sound. Materials have some 3 to 12
//! km/s; blades, which include mass without stiffness, have not much less:
//!
//! ```text
//! c^2 = EA / m        c^2 = (EIy + EIz) / (Iy + Iz)
//! ```
//!
//! With a table of weight instead of mass it is too small by the acceleration of gravity.
//! A solid blade of plastic is as slow; it is recognized by its size, density and modulus
//! (see [`is_solid_plastic`]).

use nalgebra::Matrix6;

use super::{Blade, Interpolation, Station};
use crate::units::rounded;

/// Speed of sound below which the mass is suspect: blades have 3700 at least, and blades
/// with carbon spars, of 7000, have 2240 from their weight in N/m [m/s].
const SLOW: f64 = 2500.0;
/// Speed of sound above which the mass is suspect: no fiber reaches it [m/s].
const FAST: f64 = 20_000.0;
/// Usual speed of sound of a blade: the factor that leads nearest to it is reported
/// [m/s].
const USUAL: f64 = 4000.0;
/// Unfilled and filled plastics: speeds of sound [m/s], densities [kg/m^3] and moduli
/// [Pa]. The slowest, polyethylene of 0.9 GPa and 950 kg/m^3, has 970 m/s; the lightest is
/// a printed one with a third of voids; fluoropolymers have 2200 kg/m^3, filled
/// polyamides 10 GPa. The density is a lower bound, which is 10 to 25 % less than the density
/// of an airfoil.
const PLASTIC_SPEED: f64 = 900.0;
const PLASTIC_DENSITIES: (f64, f64) = (500.0, 2300.0);
const PLASTIC_MODULUS: f64 = 10e9;
/// Largest radius of gyration of a solid plastic blade, a chord of 0.4 m [m]. Larger
/// blades are hollow.
const PLASTIC_RADIUS: f64 = 0.12;
/// Gravity in the units of tables, their unit of length [m], and the unit of the weights.
const GRAVITY: [(f64, f64, &str); 4] = [
    (9.80665, 1.0, "N/m"),
    (9806.65, 1e-3, "N/mm with millimeters and tonnes"),
    (32.174_048_556_430_45, 0.3048, "lbf/ft with slugs"),
    (386.088_582_677_165_4, 0.0254, "lbf/in with inches"),
];
/// A weight is reported if gravity and the factor to the usual speed of sound differ by at
/// most this factor.
const NEAR: f64 = 3.0;
/// A table that ends before this part of the line may be cut short.
const CUT: f64 = 0.9;
/// Modulus of a usual material, to report a density [Pa].
const MODULUS: f64 = 70e9;
/// Relative difference of a polar moment of inertia from the sum of the two others that
/// exceeds the rounding of a table.
const POLAR: f64 = 1e-6;
/// Ratio of flap to chordwise stiffness above which the axes of a blade are likely
/// exchanged.
const EXCHANGED: f64 = 2.0;
/// Part of the length that may lie beyond the stations: round-off of a file.
const BEYOND: f64 = 1e-6;

impl Blade {
    /// Likely mistakes, as text; empty if there are none.
    pub fn remarks(&self) -> Vec<String> {
        self.remarks_of_units(None)
    }

    /// As [`Blade::remarks`], for a file that declares the unit of length `unit` [m].
    pub(super) fn remarks_of_units(&self, unit: Option<f64>) -> Vec<String> {
        let on_line = self.on_line();
        let found = [
            on_line.mass_remark(unit),
            on_line.axes_remark(),
            self.polar_remark(),
            self.ends_remark(),
        ];
        found.into_iter().flatten().collect()
    }

    /// A weight given as a mass, or other inconsistent units.
    fn mass_remark(&self, unit: Option<f64>) -> Option<String> {
        let axial = self.median(|at| axial_square(&at.stiffness, &at.mass));
        let bending = self.median(|at| bending_square(&at.stiffness, &at.mass));
        let squares = Squares::of(axial, bending)?;
        let plastic = self.stations.iter();
        let plastic = plastic.filter(|at| is_solid_plastic(squares.large, &at.stiffness, &at.mass));
        if 2 * plastic.count() > self.stations.len() {
            return None;
        }
        squares.remark("median of the stations, ", unit)
    }

    /// Flap stiffer than lag: another frame or order than declared.
    fn axes_remark(&self) -> Option<String> {
        let ratio = self.median(|at| at.stiffness[(4, 4)] / at.stiffness[(5, 5)])?;
        (ratio > EXCHANGED).then(|| {
            format!(
                "bending about y (flap) is {ratio:.3} times as stiff as about z (lag; median of \
                 the stations): check frame and order"
            )
        })
    }

    fn polar_remark(&self) -> Option<String> {
        let off = |at: &Station| {
            let (polar, sum) = (at.mass[(3, 3)], at.mass[(4, 4)] + at.mass[(5, 5)]);
            (polar - sum).abs() / polar.abs().max(sum.abs()).max(f64::MIN_POSITIVE)
        };
        let count = self.stations.iter().filter(|at| off(at) > POLAR).count();
        let compare = |a: &&Station, b: &&Station| off(a).total_cmp(&off(b));
        let worst = self.stations.iter().max_by(compare)?;
        (count > 0).then(|| {
            format!(
                "the moment of inertia about the line is not the sum of the two others at {count} \
                 of {} stations, most at {} m: {:e} and {:e} kg m; all are used as they are",
                self.stations.len(),
                worst.arc_length,
                worst.mass[(3, 3)],
                worst.mass[(4, 4)] + worst.mass[(5, 5)],
            )
        })
    }

    /// Stations that do not reach the ends of the line.
    fn ends_remark(&self) -> Option<String> {
        let length = self.length();
        let (first, last) = (self.stations.first()?, self.stations.last()?);
        let is_linear = self.interpolation == Interpolation::Linear;
        let before = first.arc_length > BEYOND * length;
        let behind = is_linear && last.arc_length < (1.0 - BEYOND) * length;
        if is_linear && self.stations.len() > 1 && last.arc_length < CUT * length {
            return Some(format!(
                "WARNING: the last of {} stations lies at {} m, the line is {} m long: is \
                 the table of stations cut short? The last {:.1} % of the blade have the \
                 properties of that station",
                self.stations.len(),
                rounded(last.arc_length),
                rounded(length),
                100.0 * (1.0 - last.arc_length / length)
            ));
        }
        (before || behind).then(|| {
            format!(
                "stations from {} m to {} m on a line of {} m: beyond them the properties of the \
                 nearest station are used",
                rounded(first.arc_length),
                rounded(last.arc_length),
                rounded(length)
            )
        })
    }

    /// The median of a positive number over the stations; `None` without any.
    fn median(&self, of: impl Fn(&Station) -> f64) -> Option<f64> {
        let numbers = self.stations.iter().map(of);
        let mut numbers: Vec<_> = numbers.filter(|x| x.is_finite() && *x > 0.0).collect();
        numbers.sort_by(f64::total_cmp);
        numbers.get(numbers.len() / 2).copied()
    }
}

/// Likely mistake in the stiffness and the mass of one section about one point, as text:
/// inconsistent units.
pub fn section_remark(stiffness: &Matrix6<f64>, mass: &Matrix6<f64>) -> Option<String> {
    let squares = Squares::of_section(stiffness, mass)?;
    if is_solid_plastic(squares.large, stiffness, mass) {
        return None;
    }
    squares.remark("", None)
}

/// As [`section_remark`], for numbers that were written for the model itself and in
/// consistent units: soft and rigid ones may be intended, which the remark mentions.
pub fn written_section_remark(stiffness: &Matrix6<f64>, mass: &Matrix6<f64>) -> Option<String> {
    let squares = Squares::of_section(stiffness, mass)?;
    let small = squares.small.filter(|square| square.sqrt() > FAST);
    let (square, of, limit, meant) = if let Some(small) = small {
        (
            small,
            SMALLER,
            format!("below {:.1e}", FAST * FAST),
            "rigid",
        )
    } else if squares.large.sqrt() < SLOW && !is_solid_plastic(squares.large, stiffness, mass) {
        (
            squares.large,
            LARGER,
            format!("above {:.1e}", SLOW * SLOW),
            "soft",
        )
    } else {
        return None;
    };
    Some(format!(
        "stiffness over mass is {square:.3e} m^2/s^2 ({of}), for blades {limit}: ignore this if the \
         model is meant to be {meant}"
    ))
}

/// Names of the two squares.
const LARGER: &str = "the larger of EA / m and EI / I";
const SMALLER: &str = "the smaller of EA / m and EI / I";

/// Squares of the speed of sound [m^2/s^2]. Mass without stiffness makes each of them smaller: the
/// larger one shows whether the mass is too large. A body without much rotary inertia makes the one of
/// bending larger: the smaller one shows whether the mass is too small, which bending alone does not.
#[derive(Clone, Copy)]
struct Squares {
    small: Option<f64>,
    large: f64,
}

impl Squares {
    /// Of the numbers that are finite and positive; `None` without any.
    fn of(axial: Option<f64>, bending: Option<f64>) -> Option<Self> {
        let [axial, bending] =
            [axial, bending].map(|square| square.filter(|x| x.is_finite() && *x > 0.0));
        let both = axial.into_iter().chain(bending);
        Some(Self {
            small: axial.map(|axial| bending.map_or(axial, |bending| axial.min(bending))),
            large: both.reduce(f64::max)?,
        })
    }

    fn of_section(stiffness: &Matrix6<f64>, mass: &Matrix6<f64>) -> Option<Self> {
        Self::of(
            Some(axial_square(stiffness, mass)),
            Some(bending_square(stiffness, mass)),
        )
    }

    /// Remark on a section, or on what `of` describes, in a file that declares the unit of length
    /// `unit` [m].
    fn remark(self, of: &str, unit: Option<f64>) -> Option<String> {
        if let Some(small) = self.small.filter(|square| square.sqrt() > FAST) {
            let implied = implied(small, &format!("{of}{SMALLER}"));
            return Some(format!(
                "{implied}, lighter than any material: check the units of mass and stiffness"
            ));
        }
        slow_remark(self.large, &format!("{of}{LARGER}"), unit)
    }
}

/// The density of a usual material with the square of a speed of sound, as text.
fn implied(square: f64, of: &str) -> String {
    let density = MODULUS / square;
    let density = if density < 10.0 {
        format!("{density:.2}")
    } else {
        format!("{density:.0}")
    };
    format!(
        "stiffness over mass is {square:.3e} m^2/s^2 ({of}): a material of 70 GPa would weigh \
         {density} kg/m^3"
    )
}

/// Whether a section whose square of the speed of sound is `square` [m^2/s^2] can be a solid
/// one of plastic, which is no slower than a heavier material whose mass is a weight.
///
/// The area of a section with given radii of gyration is at most the area of a solid ellipse,
///
/// ```text
/// A <= 4 pi ry rz,    (ry rz)^2 = det(K_bending about the tension center) / EA^2
/// ```
///
/// and an airfoil has 0.75 to 0.9 of it. So mass and stiffness have lower bounds of density
/// and modulus, which are near to the values of a solid section, and far below the values of a
/// thin wall.
fn is_solid_plastic(square: f64, stiffness: &Matrix6<f64>, mass: &Matrix6<f64>) -> bool {
    let ea = stiffness[(0, 0)];
    let about_center =
        |i: usize, j: usize| stiffness[(i, j)] - stiffness[(0, i)] * stiffness[(0, j)] / ea;
    let (y, z, yz) = (about_center(4, 4), about_center(5, 5), about_center(4, 5));
    let area = 4.0 * std::f64::consts::PI * (y * z - yz * yz).sqrt() / ea;
    let radius = ((y + z) / ea).sqrt();
    let (light, heavy) = PLASTIC_DENSITIES;
    square.sqrt() >= PLASTIC_SPEED
        && square.sqrt() < SLOW
        && radius <= PLASTIC_RADIUS
        && (light..=heavy).contains(&(mass[(0, 0)] / area))
        && ea / area <= PLASTIC_MODULUS
}

/// EA / m; not a number if EA is the substitute of a rigid section (see [`super::rigid`]), which is the same
/// as both shear stiffnesses.
fn axial_square(stiffness: &Matrix6<f64>, mass: &Matrix6<f64>) -> f64 {
    let axial = stiffness[(0, 0)];
    if [1, 2].iter().all(|i| stiffness[(*i, *i)] == axial) {
        return f64::NAN;
    }
    axial / mass[(0, 0)]
}

/// (EIy + EIz) / (Iy + Iz).
fn bending_square(stiffness: &Matrix6<f64>, mass: &Matrix6<f64>) -> f64 {
    let sum = |matrix: &Matrix6<f64>| matrix[(4, 4)] + matrix[(5, 5)];
    sum(stiffness) / sum(mass)
}

/// A factor with two digits.
fn two_digits(factor: f64) -> f64 {
    let size = 10.0_f64.powf(factor.log10().floor() - 1.0);
    rounded((factor / size).round() * size)
}

/// Remark on a small square of the speed of sound [m^2/s^2], which `of` describes, in a file that
/// declares the unit of length `unit` [m].
fn slow_remark(square: f64, of: &str, unit: Option<f64>) -> Option<String> {
    if square.sqrt() >= SLOW {
        return None;
    }
    let implied = implied(square, of);
    // Factor by which the mass is too large.
    let excess = USUAL * USUAL / square;
    let soft = format!(
        "the stiffness is some {} times too small (check the moduli and their unit)",
        two_digits(excess)
    );
    let is_unit = |known: f64| unit.is_none_or(|unit| (unit / known - 1.0).abs() < 1e-9);
    let fits = GRAVITY
        .iter()
        .filter(|(factor, length, _)| is_unit(*length) && (excess / factor).ln().abs() < NEAR.ln());
    let weights = fits.map(|(factor, _, weight)| format!("({weight}), {factor:.5} times the mass"));
    let weights: Vec<_> = weights.collect();
    if weights.is_empty() {
        return Some(format!(
            "{implied}, steel weighs 7850: {soft}, or the units of length, force and mass do not fit each \
             other"
        ));
    }
    Some(format!(
        "{implied}, steel weighs 7850: {soft}, or the mass looks like a weight {}; divide it by this factor, \
         or declare the unit of mass that weighs one unit of force (lb for lbf)",
        weights.join(", or ")
    ))
}

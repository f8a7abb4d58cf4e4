//! Initial curvature of a section and of its line.
//!
//! A section that was solved for a curved and twisted beam has matrices of that beam:
//! they contain the effect of its curvature k and the slope l of its line inside of the
//! section. On a line of another curvature they belong to another beam. To first order
//! and relative to `sqrt(Kii Kjj)`, the entries of the stiffness then differ by at most
//!
//! ```text
//! delta = |dk1| (K55 + K66)/sqrt(K11 K44) + |dk2| sqrt(K55/K11) + |dk3| sqrt(K66/K11)
//!         + |dl2| sqrt(K11/K22) + |dl3| sqrt(K11/K33)                         (D-232)
//! ```
//!
//! since twist couples axial force and torque by `K14 = E k1 (Ip - J)`, of which `E Ip`
//! is the larger part and `K55 + K66`; curvature couples axial force and bending by
//! `K15 = E k2 Iy`, `K16 = -E k3 Iz`; and an axial force along a line oblique to the
//! section is a shear force too, `K12 = E A l2`.

use std::fmt;

use nalgebra::{Matrix6, Vector2, Vector3};

use super::{Damping, InitialCurvature, Prestress, SectionProperties, rotation_about_x};
use crate::error::Explain;
use crate::figure::tick_label;

/// Differences up to this part of the effect of the curvature are round-off of files:
/// twist rates are found from angles to a tenth of a degree.
const DIGITS: f64 = 0.01;
/// A difference below this is round-off.
const ROUND_OFF: f64 = 1e-7;
/// Differences up to this part of the effect of the curvature leave a correction of the
/// right size.
const NEAR: f64 = 0.1;
/// A difference that changes no coupling by more than this part of `sqrt(Kii Kjj)` is
/// below the uncertainty of a blade, for any curvature.
const SMALL: f64 = 1e-3;
/// Numbers below this part of the largest entry of a vector are shown as zero.
const SHOWN: f64 = 1e-6;

impl InitialCurvature {
    /// A straight beam, its reference line normal to the section.
    pub const STRAIGHT: Self = Self {
        curvature: Vector3::new(0.0, 0.0, 0.0),
        slope: Vector3::new(1.0, 0.0, 0.0),
    };

    /// Derivative along the beam of the material line through the point (y, z) from the
    /// reference point \[m\], in section axes: `slope + curvature x (0, y, z)` \[-\].
    pub fn tangent_at(&self, y: f64, z: f64) -> Vector3<f64> {
        self.slope + self.curvature.cross(&Vector3::new(0.0, y, z))
    }

    /// Whether this is a straight beam, its reference line normal to the section.
    pub fn is_straight(&self) -> bool {
        *self == Self::STRAIGHT
    }

    /// The same beam by the line through the point moved by `by` = (y, z) [m]. The
    /// parameter stays: `l' = l + k x d`.
    pub fn shifted(&self, by: Vector2<f64>) -> Self {
        Self {
            curvature: self.curvature,
            slope: self.tangent_at(by.x, by.y),
        }
    }

    /// The same beam in axes turned by `angle` about +x [rad].
    pub fn rotated(&self, angle: f64) -> Self {
        let back = rotation_about_x(angle).transpose();
        Self {
            curvature: back * self.curvature,
            slope: back * self.slope,
        }
    }

    /// The same beam by the arc length of its line: `k/|l|` and `l/|l|`. A slope without
    /// length is kept.
    pub fn per_arc_length(&self) -> Self {
        match self.slope.norm() {
            0.0 => *self,
            length => Self {
                curvature: self.curvature / length,
                slope: self.slope / length,
            },
        }
    }
}

impl SectionProperties {
    /// The same properties per arc length of the reference line, with `c = |l|` the
    /// length of the line per unit of its present parameter:
    ///
    /// ```text
    /// psi_s = psi/c ,  1/2 psi_s . K_s psi_s = (1/2 psi . K psi)/c  =>  K_s = c K
    /// m_s = m/c ,  k_s = k/c ,  l_s = l/c                                  (D-231)
    /// ```
    ///
    /// Viscous damping changes as the stiffness, the capacitance of electrodes as the
    /// mass, free strains as psi; forces per kelvin, per volt and of imposed states stay.
    pub fn per_arc_length(&self) -> Self {
        let Some(initial) = &self.initial_curvature else {
            return self.clone();
        };
        let c = initial.slope.norm();
        if c == 1.0 || c <= 0.0 {
            return self.clone();
        }
        let mut result = self.clone();
        result.initial_curvature = Some(initial.per_arc_length());
        result.stiffness *= c;
        result.mass /= c;
        if let Some(Damping::Viscous(matrix)) = &mut result.damping {
            *matrix *= c;
        }
        if let Some(piezo) = &mut result.piezo {
            piezo.capacitance /= c;
        }
        for state in &mut result.imposed {
            state.free_strain /= c;
            state.stiffness_change = state.stiffness_change.map(|change| c * change);
        }
        result.prestress = self.prestress.map(|prestress| Prestress {
            third: prestress.third.times(c * c),
            per_kelvin: prestress.per_kelvin.map(|change| c * change),
            ..prestress
        });
        for stiffness in &mut result.principal_axes.bending_stiffness {
            *stiffness *= c;
        }
        for inertia in &mut result.principal_axes.inertia {
            *inertia /= c;
        }
        result
    }
}

/// Agreement of the curvatures of a section and of its line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Agreement {
    /// Equal within the digits of both.
    Same,
    /// Different, but insignificant or near: to be reported.
    Near(CurvatureMismatch),
    /// Different: the section of another beam.
    Other(CurvatureMismatch),
}

/// A section on a line of another curvature, both by arc length, in the axes of the
/// section and about its reference point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvatureMismatch {
    /// Curvature for which the section was solved.
    pub section: InitialCurvature,
    /// Curvature of the line.
    pub line: InitialCurvature,
    /// Largest difference of a coupling, delta of (D-232), part of `sqrt(Kii Kjj)` [-].
    pub delta: f64,
    /// The same of the curvature of the section as a whole [-].
    pub whole: f64,
}

impl Agreement {
    /// Compares the curvature for which a section with the given 6x6 stiffness
    /// [N, N m, N m^2] was solved with the line's. At the joint of two parts of the line,
    /// `line` has both, and values between them agree as well: a mean of twist rates at a
    /// point at which they change. All are by arc length.
    pub fn of(
        section: &InitialCurvature,
        line: [InitialCurvature; 2],
        stiffness: &Matrix6<f64>,
    ) -> Self {
        let between = |x: f64, ends: [f64; 2]| x.clamp(ends[0].min(ends[1]), ends[0].max(ends[1]));
        let near = |of: fn(&InitialCurvature) -> Vector3<f64>| {
            Vector3::from_fn(|i, _| between(of(section)[i], [of(&line[0])[i], of(&line[1])[i]]))
        };
        let line = InitialCurvature {
            curvature: near(|initial| initial.curvature),
            slope: near(|initial| initial.slope),
        };
        let delta = coupling(section, &line, stiffness);
        let whole = coupling(section, &InitialCurvature::STRAIGHT, stiffness);
        let mismatch = CurvatureMismatch {
            section: *section,
            line,
            delta,
            whole,
        };
        // NaN is no agreement.
        if delta <= (DIGITS * whole).max(ROUND_OFF) {
            Self::Same
        } else if delta <= (NEAR * whole).max(SMALL) {
            Self::Near(mismatch)
        } else {
            Self::Other(mismatch)
        }
    }
}

/// delta of (D-232).
fn coupling(a: &InitialCurvature, b: &InitialCurvature, k: &Matrix6<f64>) -> f64 {
    let dk = (a.curvature - b.curvature).abs();
    let dl = (a.slope - b.slope).abs();
    let ratio = |i: usize, j: usize| (k[(i, i)] / k[(j, j)]).sqrt();
    let twist = (k[(4, 4)] + k[(5, 5)]) / (k[(0, 0)] * k[(3, 3)]).sqrt();
    dk.x * twist + dk.y * ratio(4, 0) + dk.z * ratio(5, 0) + dl.y * ratio(0, 1) + dl.z * ratio(0, 2)
}

impl std::error::Error for CurvatureMismatch {}

impl fmt::Display for CurvatureMismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the section was solved for a beam with {}, and the line has {}",
            words(&self.section),
            words(&self.line)
        )
    }
}

impl CurvatureMismatch {
    /// Size of the difference, as text.
    pub fn size(&self) -> String {
        format!(
            "couplings Kij/sqrt(Kii Kjj) differ by at most {}; the couplings of the section by \
             curvature are up to {}",
            three_digits(self.delta),
            three_digits(self.whole)
        )
    }

    /// The likely cause.
    fn cause(&self) -> Option<&'static str> {
        let (section, line) = (self.section.curvature, self.line.curvature);
        let [size, on_line] = [section.norm(), line.norm()];
        if (section - line).norm() <= NEAR * size {
            return Some(
                "the slopes differ: is the reference point of the section (the origin of its \
                 mesh) on the line?",
            );
        }
        if on_line <= SHOWN * size {
            return Some(
                "the line is straight there: give it the twist and the curvature of the blade, \
                 or take the section without [initial_curvature]",
            );
        }
        let is_about = |factor: f64| {
            let ratio = size / on_line;
            (ratio / factor - 1.0).abs() < NEAR || (ratio * factor - 1.0).abs() < NEAR
        };
        let along = section.dot(&line) / (size * on_line);
        if (-1.0..-0.9).contains(&along) {
            return Some(
                "the signs are opposite: twist is positive nose up, from y toward z, on the way \
                 from the root to the tip",
            );
        }
        if along > 0.9 && is_about(180.0 / std::f64::consts::PI) {
            return Some("the factor is 57.3: degrees for radians");
        }
        if along > 0.9 && [1e3, 0.0254, 0.3048, 1e2].into_iter().any(is_about) {
            return Some("the factor is the ratio of two units of length");
        }
        None
    }
}

impl Explain for CurvatureMismatch {
    fn help(&self) -> Option<String> {
        let cause = self.cause();
        if self.line.is_straight() {
            return Some(
                cause
                    .unwrap_or("a section for this line has no [initial_curvature]")
                    .to_owned(),
            );
        }
        let cause = cause.map_or_else(String::new, |cause| format!("{cause}; "));
        let [k, l] = [degrees(&self.line), self.line.slope].map(|v| list(&v));
        Some(format!(
            "{cause}a section for this line has [initial_curvature] with curvature = {k} in \
             deg/m and slope = {l}"
        ))
    }
}

/// A number with three digits.
fn three_digits(value: f64) -> String {
    let rounded = format!("{value:.2e}").parse().unwrap_or(value);
    tick_label(rounded, 0.0)
}

/// A vector with zeros for round-off relative to its largest entry.
fn list(vector: &Vector3<f64>) -> String {
    let least = SHOWN * vector.amax();
    let shown = |x: &f64| tick_label(if x.abs() <= least { 0.0 } else { *x }, 0.0);
    let shown: Vec<_> = vector.iter().map(shown).collect();
    format!("[{}]", shown.join(", "))
}

/// The curvature in degrees [deg/m].
fn degrees(initial: &InitialCurvature) -> Vector3<f64> {
    initial.curvature.map(f64::to_degrees)
}

/// The curvature, and a slope that differs from the normal.
fn words(initial: &InitialCurvature) -> String {
    let curvature = format!("curvature {} deg/m", list(&degrees(initial)));
    let off = initial.slope - InitialCurvature::STRAIGHT.slope;
    if off.amax() <= SHOWN {
        curvature
    } else {
        format!("{curvature} and slope {}", list(&initial.slope))
    }
}

#[cfg(test)]
#[path = "curvature_tests.rs"]
mod tests;

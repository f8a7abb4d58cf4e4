//! The ring of a rotor at one station, and the switches of annular momentum.
//!
//! ```text
//! W^2 = Ux^2 + Uy^2,  phi = atan2(Ux, Uy),  sigma = B c / (2 pi r)
//! cn = cl cos phi - cd sin phi,  ct = cl sin phi + cd cos phi
//! ```

use std::f64::consts::PI;

use crate::airfoil::Coefficients;
use crate::momentum::induction::HighInduction;
use crate::real::{Real, angle};

/// Distance from an end, over the tip radius, at which a station is at the end: sums of lengths
/// have rounding errors.
pub(crate) const END_MARGIN: f64 = 1e-9;

/// Switches of annular momentum. Loads always contain drag: the switches of drag concern the
/// induction alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Options {
    /// Loss at the tip (Prandtl).
    pub tip_loss: bool,
    /// Loss at the hub (Prandtl).
    pub hub_loss: bool,
    /// Swirl: induced velocity along the motion.
    pub swirl: bool,
    /// Drag in the axial induction.
    pub axial_drag: bool,
    /// Drag in the swirl.
    pub tangential_drag: bool,
    /// Law of highly loaded turbines.
    pub high_induction: HighInduction,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            tip_loss: true,
            hub_loss: true,
            swirl: true,
            axial_drag: true,
            tangential_drag: true,
            high_induction: HighInduction::default(),
        }
    }
}

/// The ring that the blades sweep at one station.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Annulus {
    /// Distance of the section to the shaft \[m\].
    pub radius: f64,
    /// Radius at which the blades begin \[m\].
    pub hub_radius: f64,
    /// Radius at which the blades end \[m\].
    pub tip_radius: f64,
    /// Number of blades.
    pub blades: usize,
    /// Chord, normal to the span \[m\].
    pub chord: f64,
    /// Switches.
    pub options: Options,
}

impl Annulus {
    /// Share of the ring that the chords cover, B c / (2 pi r) \[-\].
    pub fn solidity(&self) -> f64 {
        self.blades as f64 * self.chord / (2.0 * PI * self.radius.abs().max(f64::MIN_POSITIVE))
    }

    /// Whether the station is between hub and tip. At an end with a loss its factor is zero, and so
    /// are the loads: nothing is evaluated there, nor within rounding of it.
    pub fn is_interior(&self) -> bool {
        let margin = END_MARGIN * self.tip_radius.abs();
        let inside =
            |distance: f64, has_loss: bool| distance > if has_loss { margin } else { -margin };
        inside(self.radius - self.hub_radius, self.options.hub_loss)
            && inside(self.tip_radius - self.radius, self.options.tip_loss)
            && self.radius > 0.0
    }

    /// Coefficients normal to the plane of rotation and in it, for the induction: without drag
    /// where it is switched off.
    pub fn induction_coefficients<T: Real>(
        &self,
        sin: T,
        cos: T,
        coefficients: Coefficients<T>,
    ) -> (T, T) {
        let Coefficients { lift, drag, .. } = coefficients;
        let switched = |on: bool, part: T| if on { part } else { T::from(0.0) };
        let normal = lift * cos - switched(self.options.axial_drag, drag * sin);
        let tangential = lift * sin + switched(self.options.tangential_drag, drag * cos);
        (
            normal,
            switched(self.options.swirl, T::from(1.0)) * tangential,
        )
    }
}

/// The flow at a section with induction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SectionFlow<T> {
    /// Speed in the plane of the section \[m/s\].
    pub speed: T,
    /// Angle of the flow to the plane of rotation, positive through the disk \[rad\].
    pub phi: T,
    /// Its sine \[-\].
    pub sin: T,
    /// Its cosine \[-\].
    pub cos: T,
}

impl<T: Real> SectionFlow<T> {
    /// The flow of the components normal to the plane of rotation and in it. At rest the angle is
    /// zero, with derivatives zero.
    pub fn of(axial: T, in_plane: T) -> Self {
        let square = axial * axial + in_plane * in_plane;
        if square.re() < 1e-24 {
            let zero = T::from(0.0);
            return Self {
                speed: zero,
                phi: zero,
                sin: zero,
                cos: T::from(1.0),
            };
        }
        let speed = square.sqrt();
        Self {
            speed,
            phi: angle(axial, in_plane),
            sin: axial / speed,
            cos: in_plane / speed,
        }
    }

    /// Coefficients of the loads normal to the plane of rotation and in it: (cn, ct).
    pub fn load_coefficients(&self, coefficients: Coefficients<T>) -> (T, T) {
        let Coefficients { lift, drag, .. } = coefficients;
        let normal = lift * self.cos - drag * self.sin;
        (normal, lift * self.sin + drag * self.cos)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn annulus() -> Annulus {
        Annulus {
            radius: 2.0,
            hub_radius: 0.5,
            tip_radius: 4.0,
            blades: 3,
            chord: 0.4,
            options: Options::default(),
        }
    }

    #[test]
    fn switches_drop_drag_and_swirl_from_the_induction_alone() {
        let mut ring = annulus();
        let section: Coefficients<f64> = Coefficients {
            lift: 0.8,
            drag: 0.1,
            moment: 0.0,
        };
        let flow = SectionFlow::of(3.0, 4.0);
        let loads = flow.load_coefficients(section);
        assert!((loads.0 - (0.8 * 0.8 - 0.1 * 0.6)).abs() < 1e-15);
        assert_eq!(
            ring.induction_coefficients(flow.sin, flow.cos, section),
            loads
        );
        ring.options.axial_drag = false;
        ring.options.swirl = false;
        let without: (f64, f64) = ring.induction_coefficients(flow.sin, flow.cos, section);
        assert!((without.0 - 0.8 * 0.8).abs() < 1e-15);
        assert_eq!(without.1, 0.0);
    }

    #[test]
    fn solidity_and_ends() {
        let mut ring = annulus();
        assert!((ring.solidity() - 1.2 / (4.0 * PI)).abs() < 1e-15);
        assert!(ring.is_interior());
        for radius in [4.0, 4.0 - 1e-14, 0.5, 0.5 + 1e-14] {
            ring.radius = radius;
            assert!(!ring.is_interior());
        }
        ring.radius = f64::NAN;
        assert!(!ring.is_interior());
        // Without losses the ends have loads.
        (ring.options.tip_loss, ring.options.hub_loss) = (false, false);
        for (radius, is_interior) in [(4.0, true), (0.5, true), (4.001, false), (0.499, false)] {
            ring.radius = radius;
            assert_eq!(ring.is_interior(), is_interior);
        }
    }
}

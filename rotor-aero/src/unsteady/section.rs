//! The flow at a section, its forces, and the interface of the models.

use crate::airfoil::Flow;
use crate::real::Real;

use super::polar::Polar;

/// The flow at a section, as velocities of the section relative to the air in section axes.
///
/// With the velocity `v` of a point relative to the air, `normal = -v_y` at the three-quarter
/// chord: it has the sign of an angle of attack, `U alpha` for small angles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SectionFlow<T> {
    /// Normal velocity at the three-quarter chord, `-v_y` \[m/s\].
    pub normal: T,
    /// Normal velocity at the mid chord, `-v_y` \[m/s\].
    pub normal_mid: T,
    /// Velocity along the chord, `v_x`; positive if the air comes from the leading edge \[m/s\].
    pub tangential: T,
    /// Normal velocity at the three-quarter chord by the camber of a plain flap, see
    /// [`super::Flap`] \[m/s\].
    pub camber: T,
    /// Angular velocity of the section, nose up \[rad/s\].
    pub pitch_rate: T,
    /// Mach number \[-\].
    pub mach: T,
    /// Reynolds number of the chord \[-\].
    pub reynolds: T,
    /// Deflection of the flap, trailing edge down positive \[rad\].
    pub flap: T,
}

impl<T: Real> SectionFlow<T> {
    /// The flow of a rigid section: normal velocity `-v_y` and velocity `v_x` of its quarter
    /// chord, angular velocity and chord; without compressibility, Reynolds number and flap.
    pub fn rigid(normal_quarter: T, tangential: T, pitch_rate: T, chord: f64) -> Self {
        Self {
            normal: normal_quarter + pitch_rate * (0.5 * chord),
            normal_mid: normal_quarter + pitch_rate * (0.25 * chord),
            tangential,
            camber: T::zero(),
            pitch_rate,
            mach: T::zero(),
            reynolds: T::zero(),
            flap: T::zero(),
        }
    }

    /// The flow of the static coefficients at an angle of attack.
    pub(super) fn at(&self, alpha: T) -> Flow<T> {
        Flow {
            alpha,
            mach: self.mach,
            reynolds: self.reynolds,
            flap: self.flap,
        }
    }
}

/// Forces per length of span on the section, at the quarter chord, in section axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SectionForce<T> {
    /// Force along the chord, toward the leading edge \[N/m\].
    pub along: T,
    /// Force normal to the chord, up \[N/m\].
    pub normal: T,
    /// Moment about the quarter chord, nose up \[N\].
    pub moment: T,
}

impl<T: Real> SectionForce<T> {
    /// A part of a force; zero without one.
    pub fn part_of(force: Option<Self>, part: f64) -> Self {
        let scaled = |of: fn(&Self) -> T| match &force {
            Some(force) => of(force) * part,
            None => T::from(0.0),
        };
        Self {
            along: scaled(|force| force.along),
            normal: scaled(|force| force.normal),
            moment: scaled(|force| force.moment),
        }
    }
}

/// The constants of a section that scale its forces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strip {
    /// Chord \[m\].
    pub chord: f64,
    /// Density of the air \[kg/m^3\].
    pub density: f64,
}

impl Strip {
    /// Half the chord \[m\].
    pub(super) fn semichord(&self) -> f64 {
        0.5 * self.chord
    }
}

/// Name of a state, and units of the state and of its row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StateName {
    /// Name, in lower case.
    pub name: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// Unit of its row.
    pub row_unit: &'static str,
}

/// An entry of a list of states.
pub(crate) const fn state(
    name: &'static str,
    unit: &'static str,
    row_unit: &'static str,
) -> StateName {
    StateName {
        name,
        unit,
        row_unit,
    }
}

/// A constant of a model: its name in files of airfoils, and its value.
pub(super) type Constant<'a> = (&'static str, &'a mut f64);

/// Constants that airfoils may state.
pub(super) trait Adjustable {
    /// All of them.
    fn constants(&mut self) -> Vec<Constant<'_>>;
}

/// A model of an unsteady section.
pub trait Model {
    /// Names and units of the states, in their order.
    fn states(&self) -> &'static [StateName];

    /// Whether its rows have no slope far from their solution: Newton's method then finds a steady
    /// flow only from the states of [`Model::start`].
    fn needs_start(&self) -> bool {
        false
    }

    /// Writes the states of a steady flow; their rates are zero.
    ///
    /// Returns `None`, and writes nothing, unless `states` has the length of the list of states.
    fn start<P: Polar>(
        &self,
        strip: &Strip,
        polar: &P,
        flow: &SectionFlow<f64>,
        states: &mut [f64],
    ) -> Option<()>;

    /// Writes the rows of the states, and returns the forces.
    ///
    /// The rows are zero along a motion. Returns `None`, and writes nothing, unless all slices
    /// have the length of the list of states.
    fn evaluate<T: Real, P: Polar>(
        &self,
        strip: &Strip,
        polar: &P,
        flow: &SectionFlow<T>,
        states: &[T],
        rates: &[T],
        rows: &mut [T],
    ) -> Option<SectionForce<T>>;
}

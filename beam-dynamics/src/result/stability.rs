//! Results of stability over a parameter.

use nalgebra::Complex;

use super::SeenFrequency;

/// A root: a mode of small motions with its exponent; of a pair the one with the positive frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct StabilityRoot {
    /// Growth, and frequency as seen from the fixed frame as the imaginary part [1/s].
    pub exponent: Complex<f64>,
    /// The multiplier of a period, if the motion is periodic [-].
    pub multiplier: Option<Complex<f64>>,
    /// The boundary that it passes where its growth changes its sign.
    pub kind: BoundaryKind,
    /// Growth up to which it is treated as zero: round-off and error of the steps [1/s].
    pub doubt: f64,
    /// Estimated error of the exponent by the steps of the period; `None` if there is no estimate
    /// [1/s].
    pub error: Option<f64>,
    /// Whether it is a mode that oscillates in turning axes at other values, and decays without oscillation
    /// here.
    pub is_overdamped: bool,
    /// Whether it is the free choice of the azimuth or of the time.
    pub is_neutral: bool,
    /// Whether its motion has no damping without air.
    pub has_no_structural_damping: bool,
    /// Share of the energy at the frequency [-].
    pub share: f64,
    /// Frequency of the period of the motion, zero about an equilibrium [rad/s].
    pub fundamental: f64,
    /// Other frequencies at which it is seen.
    pub others: Vec<SeenFrequency>,
    /// The motion as text.
    pub name: String,
    /// Frequency in axes that turn with the blades, by which the modes of one name are numbered [rad/s].
    pub in_blades: f64,
    /// The least number of the mode among all modes of its name, from one.
    pub number: usize,
    /// Whether name, number and pattern identify the mode at all values; else modes are followed from value
    /// to value.
    pub is_named: bool,
    /// Difference of the root from the mode without air that gives it its name (D-425); `None` if no mode does \[-\].
    pub unlikeness: Option<f64>,
    /// The pattern of the blades after the name and the number of the mode, perhaps empty; `None`: modes
    /// of one name are numbered behind it.
    pub pattern: Option<String>,
    /// Number of waves around a rotor of blades, if one pattern prevails: modes of different ones are
    /// different modes.
    pub waves: Option<i32>,
    /// Number of blades of the rotor that moves, zero of a part outside the blades; `None` if it is not known.
    pub blades: Option<usize>,
    /// Motion and momentum of the mode, for comparisons; empty if they are not known \[any unit\].
    pub shape: [Vec<Complex<f64>>; 2],
}

impl StabilityRoot {
    /// Part of the critical damping that structures usually have: a root that grows by less may be missing it
    /// [-].
    pub const SLIGHT: f64 = 0.005;
    /// Difference of two growths, as a part of their roots, that is round-off [-].
    const ROUND_OFF: f64 = 1e-6;

    /// A root whose motion is not known: a real one at frequency zero, else a pair.
    pub fn new(exponent: Complex<f64>) -> Self {
        Self {
            exponent,
            multiplier: None,
            kind: if exponent.im == 0.0 {
                BoundaryKind::Divergence
            } else {
                BoundaryKind::Flutter
            },
            doubt: 0.0,
            error: None,
            is_overdamped: false,
            is_neutral: false,
            has_no_structural_damping: false,
            share: 1.0,
            fundamental: 0.0,
            others: Vec::new(),
            name: String::new(),
            in_blades: exponent.im.abs(),
            blades: None,
            number: 1,
            is_named: false,
            unlikeness: None,
            pattern: None,
            waves: None,
            shape: [Vec::new(), Vec::new()],
        }
    }

    /// Growth \[1/s\].
    pub fn growth(&self) -> f64 {
        self.exponent.re
    }

    /// Frequency \[rad/s\].
    pub fn frequency(&self) -> f64 {
        self.exponent.im
    }

    /// Damping ratio; `None` at frequency zero.
    pub fn damping_ratio(&self) -> Option<f64> {
        (self.exponent.im != 0.0).then(|| -self.exponent.re / self.exponent.norm())
    }

    /// Whether its growth is larger than twice its estimated error.
    pub fn is_resolved(&self) -> bool {
        let error = self.error.unwrap_or(0.0);
        self.is_neutral || self.growth().abs() >= 2.0 * error
    }

    /// Whether it grows.
    pub fn is_unstable(&self) -> bool {
        !self.is_neutral && self.growth() > self.doubt
    }

    /// Whether it grows slightly, without structural damping.
    pub fn is_slight(&self) -> bool {
        let ratio = self.damping_ratio();
        let is_small = ratio.is_some_and(|ratio| ratio > -Self::SLIGHT);
        self.is_unstable() && self.has_no_structural_damping && is_small
    }

    /// Number of unstable roots that it represents: two for an unstable pair.
    pub fn unstable(&self) -> usize {
        usize::from(self.is_unstable()) * self.kind.roots()
    }

    /// The modal assurance criterion with another root, of the motion or its conjugate [-]; `None` if a
    /// motion is not known.
    ///
    /// ```text
    /// MAC = |q_a^H p_b| |q_b^H p_a| / (|q_a^H p_a| |q_b^H p_b|)
    /// ```
    pub fn assurance(&self, other: &Self) -> Option<f64> {
        let [a, b] = [&self.shape, &other.shape].map(|shape| [&shape[0][..], &shape[1][..]]);
        assurance(a, b)
    }

    /// As [`Self::assurance`], where `other` is seen at one of its other frequencies.
    pub fn assurance_with(&self, other: &SeenFrequency) -> Option<f64> {
        assurance(self.shape.each_ref().map(Vec::as_slice), [&other.shape; 2])
    }

    /// Shows the root at its other frequency of this index in place of the one that it has.
    pub fn show_at(&mut self, other: usize) {
        if let Some(other) = self.others.get_mut(other) {
            std::mem::swap(&mut self.exponent.im, &mut other.frequency);
            std::mem::swap(&mut self.share, &mut other.share);
            let own = std::mem::replace(&mut self.shape[0], other.shape.clone());
            self.shape[1] = std::mem::replace(&mut other.shape, own);
        }
    }

    /// The frequency that is `distance` fundamental ones from the shown one [rad/s].
    pub(crate) fn shifted(&self, distance: i32) -> f64 {
        (self.frequency() + f64::from(distance) * self.fundamental).abs()
    }

    /// Index of the other frequency that is `frequency` but for the part `same` of the fundamental one.
    fn other_at(&self, frequency: f64, same: f64) -> Option<usize> {
        let is_it = |own: f64| (own - frequency).abs() <= same * self.fundamental;
        self.others.iter().position(|other| is_it(other.frequency))
    }

    /// Share of the energy at a frequency [-]; zero of one that is not listed.
    pub(crate) fn share_at(&self, frequency: f64, same: f64) -> f64 {
        if (frequency - self.frequency()).abs() <= same * self.fundamental {
            return self.share;
        }
        let other = self.other_at(frequency, same);
        other.map_or(0.0, |other| self.others[other].share)
    }

    /// Shows the root at a frequency, where it may have little energy.
    pub(crate) fn show(&mut self, frequency: f64, same: f64) {
        match self.other_at(frequency, same) {
            Some(other) => self.show_at(other),
            None => self.exponent.im = frequency,
        }
    }
}

/// The criterion of [`StabilityRoot::assurance`] of the motions and momenta `a` and `b`.
fn assurance(a: [&[Complex<f64>]; 2], b: [&[Complex<f64>]; 2]) -> Option<f64> {
    let mut lengths = a.iter().chain(&b).map(|part| part.len());
    if a[0].is_empty() || lengths.any(|length| length != a[0].len()) {
        return None;
    }
    let product = |q: &[Complex<f64>], p: &[Complex<f64>], conjugate: bool| {
        let terms = q
            .iter()
            .zip(p)
            .map(|(q, p)| if conjugate { q * p } else { q.conj() * p });
        terms.sum::<Complex<f64>>().norm()
    };
    let own = product(a[0], a[1], false) * product(b[0], b[1], false);
    let cross = |conjugate| product(a[0], b[1], conjugate) * product(b[0], a[1], conjugate) / own;
    (own > 0.0).then(|| f64::max(cross(false), cross(true)))
}

/// The way in which stability is lost.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BoundaryKind {
    /// A pair of roots: an oscillation grows.
    Flutter,
    /// A real root, or a multiplier of one: the motion leaves without oscillation.
    Divergence,
    /// A multiplier of minus one: an oscillation of twice the period.
    HalfRate,
}

impl BoundaryKind {
    /// Number of roots that pass together.
    pub fn roots(self) -> usize {
        match self {
            Self::Flutter => 2,
            Self::Divergence | Self::HalfRate => 1,
        }
    }

    /// As text.
    pub fn word(self) -> &'static str {
        match self {
            Self::Flutter => "flutter",
            Self::Divergence => "divergence",
            Self::HalfRate => "half rate",
        }
    }
}

/// The side of a boundary on which the mode decays.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StableSide {
    /// At smaller values of the parameter.
    Below,
    /// At larger values.
    Above,
    /// At both: the growth touches zero.
    Both,
    /// At none: the growth touches zero from above.
    None,
}

impl StableSide {
    /// As text.
    pub fn word(self) -> &'static str {
        match self {
            Self::Below => "below",
            Self::Above => "above",
            Self::Both => "both, touches",
            Self::None => "none, touches",
        }
    }
}

/// A value of the parameter at which the growth of a mode is zero.
#[derive(Debug, Clone, PartialEq)]
pub struct StabilityBoundary {
    /// The value \[its unit\].
    pub at: f64,
    /// The way in which stability is lost.
    pub kind: BoundaryKind,
    /// Frequency of the mode [rad/s].
    pub frequency: f64,
    /// Growth that is left [1/s].
    pub growth: f64,
    /// Name of the mode.
    pub name: String,
    /// The side on which the mode decays.
    pub stable: StableSide,
    /// Numbers of unstable roots at the last known values below and above.
    pub unstable: [usize; 2],
}

/// The roots at one value of the parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct StabilityPoint {
    /// The value \[its unit\].
    pub at: f64,
    /// Whether the value was requested, not added for the search.
    pub is_requested: bool,
    /// The roots, by falling growth.
    pub roots: Vec<StabilityRoot>,
    /// Index of the mode of each root among [`StabilityResult::modes`].
    pub modes: Vec<usize>,
    /// Values of the controls of the trim \[unit of each\].
    pub controls: Vec<f64>,
}

impl StabilityPoint {
    /// Number of unstable roots, two for a pair.
    pub fn unstable(&self) -> usize {
        self.roots.iter().map(StabilityRoot::unstable).sum()
    }

    /// The root with the largest growth and its mode, without neutral ones: of roots whose growths differ by
    /// round-off the first one in the order of the modes.
    pub fn least_damped(&self) -> Option<(&StabilityRoot, usize)> {
        let pairs = self.roots.iter().zip(self.modes.iter().copied());
        let counted = pairs.filter(|(root, _)| !root.is_neutral);
        let most = |a: f64, (root, _): (&StabilityRoot, usize)| a.max(root.growth());
        let most = counted.clone().fold(f64::NEG_INFINITY, most);
        let is_most = |(root, _): &(&StabilityRoot, usize)| {
            let round_off = StabilityRoot::ROUND_OFF * root.exponent.norm();
            root.growth() >= most - root.doubt.max(round_off)
        };
        counted.filter(is_most).min_by_key(|(_, mode)| *mode)
    }

    /// The root of a mode, if it was found.
    pub fn root_of(&self, mode: usize) -> Option<&StabilityRoot> {
        let index = self.modes.iter().position(|own| *own == mode)?;
        self.roots.get(index)
    }
}

/// Stability over a parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct StabilityResult {
    /// Name of the model.
    pub name: String,
    /// The analysis of each value as text.
    pub method: &'static str,
    /// Name of the parameter.
    pub parameter: String,
    /// Number of requested values.
    pub requested: usize,
    /// Names of the controls of the trim.
    pub controls: Vec<String>,
    /// Names of the modes that were followed.
    pub modes: Vec<String>,
    /// The values that succeeded, ascending.
    pub points: Vec<StabilityPoint>,
    /// The boundaries, ascending.
    pub boundaries: Vec<StabilityBoundary>,
    /// Values that failed \[unit of the parameter\], with the reason and the remedy.
    pub failures: Vec<(f64, [String; 2])>,
    /// Remarks.
    pub remarks: Vec<String>,
}

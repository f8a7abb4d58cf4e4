//! Performance of a rotor at operating points.

use rotor_aero::rotor::Performance;

use crate::case::{Abscissa, MachineKind, OperatingSetting};

/// How an operating point was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PointStatus {
    /// It was given.
    Given,
    /// The speed of rotation follows the law below rated power.
    BelowRated,
    /// The pitch gives rated power.
    Rated,
    /// No pitch gives rated power; the point is at the pitch below rated power.
    NoPitch,
}

impl PointStatus {
    /// The status as text.
    pub fn word(self) -> &'static str {
        match self {
            Self::Given => "given",
            Self::BelowRated => "below rated",
            Self::Rated => "rated",
            Self::NoPitch => "no pitch for rated power",
        }
    }
}

/// An operating point with its performance.
#[derive(Debug, Clone, PartialEq)]
pub struct PerformancePoint {
    /// Performance; its loads along the blade are kept at chosen points alone.
    pub performance: Performance,
    /// How the point was found.
    pub status: PointStatus,
}

impl PerformancePoint {
    /// The operating point.
    pub fn setting(&self) -> OperatingSetting {
        let at = &self.performance.operating;
        OperatingSetting {
            speed: at.speed,
            omega: at.omega,
            pitch: at.pitch,
        }
    }
}

/// The points of one part of the input.
#[derive(Debug, Clone, PartialEq)]
pub struct PerformanceTable {
    /// Name.
    pub name: String,
    /// The quantity over which the points are drawn.
    pub abscissa: Abscissa,
    /// Names of the curves; each has the same number of successive points.
    pub curves: Vec<String>,
    /// Whether the points are a grid of tip speed ratio and pitch.
    pub is_map: bool,
    /// The points.
    pub points: Vec<PerformancePoint>,
}

impl PerformanceTable {
    /// The value of the abscissa at a point, in the unit of its title \[mixed\].
    pub fn at(&self, point: &PerformancePoint) -> f64 {
        let radius = point.performance.disk_radius;
        self.abscissa.of(&point.setting(), radius)
    }

    /// The points of each curve, with its name.
    pub fn curves(&self) -> impl Iterator<Item = (&str, &[PerformancePoint])> {
        let length = self.points.len() / self.curves.len().max(1);
        let names = self.curves.iter().map(String::as_str);
        names.zip(self.points.chunks(length.max(1)))
    }

    /// The points with loads along the blade.
    pub fn loaded(&self) -> impl Iterator<Item = &PerformancePoint> {
        let points = self.points.iter();
        points.filter(|point| !point.performance.sectors.is_empty())
    }

    /// Number of points at which a station has no state in balance.
    pub fn unsolved(&self) -> usize {
        let unsolved = |point: &&PerformancePoint| point.performance.unsolved > 0;
        self.points.iter().filter(unsolved).count()
    }
}

/// The performance of a rotor.
#[derive(Debug, Clone, PartialEq)]
pub struct PerformanceResult {
    /// Name.
    pub name: String,
    /// Kind of machine.
    pub machine: MachineKind,
    /// Number of blades.
    pub blades: usize,
    /// Distance of the tips from the shaft [m].
    pub disk_radius: f64,
    /// Density of the air [kg/m^3].
    pub density: f64,
    /// Tables, in the order of the input.
    pub tables: Vec<PerformanceTable>,
    /// Remarks for the user.
    pub remarks: Vec<String>,
}

//! Measures of the shape of cells: deviation from a square or an equilateral triangle, by
//! region, and the cells with the worst shape.
//!
//! A poor shape makes the result less accurate, but not wrong, so that poor cells are a
//! warning. Cells that are not an image of the reference cell have already been reported
//! as errors of the mesh.

use std::f64::consts::PI;
use std::fmt;

use super::jacobian::Jacobian;
use super::section_mesh::SectionMesh;

mod measures;

use measures::values_of;

/// Number of cells that are named, the worst first.
const NAMED: usize = 5;

/// Least over largest Jacobian determinant below which a cell is poor. The
/// integrals have the Jacobian in the denominator: at a tenth the integration rule
/// of the cell, exact for constant Jacobians, is off by percents.
const POOR_JACOBIAN: f64 = 0.1;
/// Ratio from which a cell is good.
const GOOD_JACOBIAN: f64 = 0.5;
/// Aspect ratio beyond which a cell is poor: the stiffness of a cell along and across
/// differ by its square, so that the solution loses six of its 16 digits. Plies of
/// ordinary meshes have 10 to 50, and coatings of blades some hundred.
const POOR_ASPECT: f64 = 1000.0;
/// Up to this ratio a cell is good.
const GOOD_ASPECT: f64 = 10.0;
/// Corner angle below which a cell is poor \[rad\]: without a large angle it is a
/// stretched triangle, and its cotangent has the effect of an aspect ratio. Triangles in
/// plies and at sharp trailing edges have 3 to 10 degrees.
const POOR_SMALL_ANGLE: f64 = PI / 180.0;
/// Angle from which a cell is good \[rad\].
const GOOD_SMALL_ANGLE: f64 = 15.0 * PI / 180.0;
/// Corner angle beyond which a cell is poor \[rad\]: the error of the strains grows
/// as one over its sine, tenfold at 174 degrees.
const POOR_LARGE_ANGLE: f64 = 170.0 * PI / 180.0;
/// Up to this angle a cell is good \[rad\].
const GOOD_LARGE_ANGLE: f64 = 150.0 * PI / 180.0;
/// Distance of the node in the middle of a side from the middle of its chord,
/// relative to the chord, beyond which a cell is poor. Along the side, the Jacobian
/// falls to zero at 0.25; across, 0.21 is an arc of 90 degrees in one cell.
const POOR_MIDDLE: f64 = 0.2;
/// Up to this distance a cell is good: an arc of 22 degrees.
const GOOD_MIDDLE: f64 = 0.05;

/// Measures of the shape of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ShapeMeasure {
    /// Least over largest Jacobian determinant in the cell.
    Jacobian,
    /// Square of the longest side over the area, relative to the square or the
    /// equilateral triangle: for a rectangle, length over width.
    Aspect,
    /// Smallest angle at a corner, between the tangents of its sides.
    SmallestAngle,
    /// Largest angle at a corner.
    LargestAngle,
    /// Largest distance of the node in the middle of a side from the middle of the
    /// chord, relative to the chord.
    Middle,
}

/// Grade of a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Grade {
    /// Beyond the limit: requires a warning.
    Poor,
    /// Between the limits.
    Fair,
    /// Within the good limit.
    Good,
}

impl ShapeMeasure {
    /// Every measure, in the order of the arrays of values.
    pub const ALL: [Self; 5] = [
        Self::Jacobian,
        Self::Aspect,
        Self::SmallestAngle,
        Self::LargestAngle,
        Self::Middle,
    ];

    /// The limits of poor and of good values \[-\], of angles \[rad\].
    pub fn limits(self) -> [f64; 2] {
        match self {
            Self::Jacobian => [POOR_JACOBIAN, GOOD_JACOBIAN],
            Self::Aspect => [POOR_ASPECT, GOOD_ASPECT],
            Self::SmallestAngle => [POOR_SMALL_ANGLE, GOOD_SMALL_ANGLE],
            Self::LargestAngle => [POOR_LARGE_ANGLE, GOOD_LARGE_ANGLE],
            Self::Middle => [POOR_MIDDLE, GOOD_MIDDLE],
        }
    }

    /// Whether large values are good ones.
    pub fn is_better_large(self) -> bool {
        matches!(self, Self::Jacobian | Self::SmallestAngle)
    }

    /// Grade of a value.
    pub fn grade(self, value: f64) -> Grade {
        let [poor, good] = self.limits();
        let (beyond, within) = if self.is_better_large() {
            (value < poor, value >= good)
        } else {
            (value > poor, value <= good)
        };
        match (beyond, within) {
            (true, _) => Grade::Poor,
            (_, true) => Grade::Good,
            _ => Grade::Fair,
        }
    }

    /// Severity of a value: its grade, 2 if poor and 0 if good, then its nearness to the
    /// limit of poor values, 1 at the limit.
    fn severity(self, value: f64) -> (usize, f64) {
        let [poor, _] = self.limits();
        let nearness = match self {
            Self::Jacobian | Self::SmallestAngle => poor / value,
            Self::Aspect | Self::Middle => value / poor,
            // corners up to 90 degrees have no effect
            Self::LargestAngle => (value - 0.5 * PI).max(0.0) / (poor - 0.5 * PI),
        };
        (Grade::Good as usize - self.grade(value) as usize, nearness)
    }

    fn worse(self, a: f64, b: f64) -> f64 {
        if self.is_better_large() {
            a.min(b)
        } else {
            a.max(b)
        }
    }

    /// Its name in the heading of a column.
    pub fn short_name(self) -> &'static str {
        match self {
            Self::Jacobian => "Jacobian",
            Self::Aspect => "aspect",
            Self::SmallestAngle => "corners from",
            Self::LargestAngle => "corners to",
            Self::Middle => "side middles",
        }
    }

    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Jacobian => "least over largest Jacobian",
            Self::Aspect => "aspect ratio",
            Self::SmallestAngle => "smallest corner angle [deg]",
            Self::LargestAngle => "largest corner angle [deg]",
            Self::Middle => "offset of side middles",
        }
    }
}

/// A value of a measure, as text.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShapeValue {
    /// The measure.
    pub measure: ShapeMeasure,
    /// The value \[-\], of angles \[rad\].
    pub value: f64,
}

impl fmt::Display for ShapeValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let value = self.value;
        let degrees = value.to_degrees();
        match self.measure {
            ShapeMeasure::Jacobian => write!(
                f,
                "least over largest Jacobian {value:.2}, poor below {POOR_JACOBIAN}"
            ),
            ShapeMeasure::Aspect => {
                write!(f, "aspect ratio {value:.1}, poor above {POOR_ASPECT}")
            }
            ShapeMeasure::SmallestAngle => {
                let poor = POOR_SMALL_ANGLE.to_degrees();
                write!(f, "corner of {degrees:.1} deg, poor below {poor:.0}")
            }
            ShapeMeasure::LargestAngle => {
                let poor = POOR_LARGE_ANGLE.to_degrees();
                write!(f, "corner of {degrees:.1} deg, poor above {poor:.0}")
            }
            ShapeMeasure::Middle => write!(
                f,
                "side middle off by {value:.2} of the side, poor above {POOR_MIDDLE}"
            ),
        }
    }
}

/// The cells of one region.
#[derive(Debug, Clone, PartialEq)]
pub struct RegionQuality {
    /// Its physical surface.
    pub group: String,
    /// Number of cells.
    pub cells: usize,
    /// Whether cells have nodes at the middle of their sides.
    pub poor: usize,
    /// Whether cells have nodes in the middle of their sides.
    pub has_middles: bool,
    /// Worst values, in the order of [`ShapeMeasure::ALL`] \[-\], of angles \[rad\].
    pub worst: [f64; 5],
    /// Mean values \[-\], of angles \[rad\].
    pub mean: [f64; 5],
    /// Numbers of poor, fair and good cells by each measure.
    pub grades: [[usize; 3]; 5],
}

/// A cell by its worst measure.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedCell {
    /// Tag of the cell.
    pub cell: u64,
    /// Mean of its corners (y, z) \[m\].
    pub position: [f64; 2],
    /// Its physical surface.
    pub group: String,
    /// Its worst value.
    pub worst: ShapeValue,
    /// Whether this value is poor.
    pub is_poor: bool,
}

/// The shapes of all cells.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MeshQuality {
    /// The regions, in the order of [`SectionMesh::groups`].
    pub regions: Vec<RegionQuality>,
    /// The cells nearest to a limit or farthest beyond, the worst first.
    pub worst: Vec<NamedCell>,
}

impl MeshQuality {
    /// Measures all cells of `mesh`.
    pub fn of(mesh: &SectionMesh) -> Self {
        let jacobian = Jacobian::new();
        let mut regions: Vec<_> = mesh
            .groups
            .iter()
            .map(|group| RegionQuality::empty(group))
            .collect();
        // severity, index of the cell, its worst value
        let mut worst: Vec<((usize, f64), usize, ShapeValue)> = Vec::new();
        for (number, cell) in mesh.cells.iter().enumerate() {
            let mut positions = [[0.0; 2]; 9];
            for (at, of_node) in positions.iter_mut().zip(mesh.positions(cell)) {
                *at = of_node;
            }
            let values = values_of(&jacobian, cell.kind, &positions[..cell.nodes().len()]);
            if let Some(region) = regions.get_mut(cell.group) {
                region.has_middles |= cell.kind.is_quadratic();
                region.add(&values);
            }
            let (severity, value) = worst_of(&values);
            let at = worst.partition_point(|(other, ..)| *other >= severity);
            if at < NAMED {
                worst.truncate(NAMED - 1);
                worst.insert(at, (severity, number, value));
            }
        }
        for region in &mut regions {
            region.finish();
        }
        let named = |(_, number, worst): (_, usize, ShapeValue)| {
            let cell = &mesh.cells[number];
            NamedCell {
                cell: cell.tag,
                position: mesh.middle(cell),
                group: mesh.groups.get(cell.group).cloned().unwrap_or_default(),
                worst,
                is_poor: worst.measure.grade(worst.value) == Grade::Poor,
            }
        };
        Self {
            regions,
            worst: worst.into_iter().map(named).collect(),
        }
    }

    /// Number of cells that are poor by any measure.
    pub fn poor(&self) -> usize {
        self.regions.iter().map(|region| region.poor).sum()
    }

    /// The worst value of a measure in the whole mesh \[-\], of angles \[rad\]; `None` without
    /// cells.
    pub fn worst_value(&self, measure: ShapeMeasure) -> Option<f64> {
        let values = self.regions.iter().filter(|region| region.cells > 0);
        let values = values.map(|region| region.worst[measure as usize]);
        values.reduce(|a, b| measure.worse(a, b))
    }
}

impl RegionQuality {
    fn empty(group: &str) -> Self {
        let start = ShapeMeasure::ALL.map(|measure| {
            if measure.is_better_large() {
                f64::INFINITY
            } else {
                0.0
            }
        });
        Self {
            group: group.to_owned(),
            cells: 0,
            poor: 0,
            has_middles: false,
            worst: start,
            mean: [0.0; 5],
            grades: [[0; 3]; 5],
        }
    }

    /// Adds a cell; `mean` holds the sum until [`RegionQuality::finish`].
    fn add(&mut self, values: &[f64; 5]) {
        self.cells += 1;
        let mut is_poor = false;
        for (i, measure) in ShapeMeasure::ALL.into_iter().enumerate() {
            let grade = measure.grade(values[i]);
            is_poor |= grade == Grade::Poor;
            self.worst[i] = measure.worse(self.worst[i], values[i]);
            self.mean[i] += values[i];
            self.grades[i][grade as usize] += 1;
        }
        self.poor += usize::from(is_poor);
    }

    fn finish(&mut self) {
        let count = self.cells.max(1) as f64;
        self.mean = self.mean.map(|sum| sum / count);
    }
}

/// The worst value: of the worst grade, and among equal grades nearest to its limit or
/// farthest beyond.
fn worst_of(values: &[f64; 5]) -> ((usize, f64), ShapeValue) {
    let mut worst = ((0, f64::NEG_INFINITY), ShapeMeasure::Jacobian, 1.0);
    for (measure, &value) in ShapeMeasure::ALL.into_iter().zip(values) {
        let severity = measure.severity(value);
        if severity > worst.0 {
            worst = (severity, measure, value);
        }
    }
    let (severity, measure, value) = worst;
    (severity, ShapeValue { measure, value })
}

#[cfg(test)]
#[path = "quality/tests.rs"]
mod tests;

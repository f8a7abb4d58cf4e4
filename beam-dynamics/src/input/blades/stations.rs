//! Blades from blade files: stations along a reference line.
//!
//! An element from arc length `s_1` to `s_3` has its nodes on the line, the middle one at
//! half the arc length, and the section axes of the line there; its evaluation points
//! are at
//!
//! ```text
//! s(xi) = s_1 + (1 + xi) (s_3 - s_1)/2
//! ```
//!
//! where stiffness and mass are interpolated. At a jump or a kink each element uses the
//! values on its own side.

use std::path::Path;

use nalgebra::{Matrix6, Vector3};
use shared_geom::blade::{self, Blade, BladeDamping, Side};
use shared_geom::document::Table;
use shared_geom::document::schema::Family;
use shared_geom::document::schema::ValueKind::{Boolean, Count, Positive, Text};
use shared_geom::exchange::{self, Options};
use shared_geom::hash::{fingerprint, sha256_of_file};
use shared_geom::keys;
use shared_geom::line::{Course, Curve};
use shared_geom::section::Damping;
use shared_geom::units::Dimension;

use super::layout::{BladeLayout, LayoutNode};
use super::mesh::Ends;
use super::problem::BladeProblem;
use crate::elements::beams::Beam;
use crate::input::beam_properties::BeamProperties;
use crate::input::builder::ModelBuilder;
use crate::input::damping::{self, OfFile};
use crate::input::heat;

/// A blade of a blade file.
pub(in crate::input) const STATIONS: Family = Family {
    name: "file",
    meaning: "From a blade file.",
    keys: &[
        FILE.schema,
        BODY.schema,
        ELEMENTS.schema,
        LENGTH.schema,
        RIGID_SHEAR.schema,
        damping::KEY_OF_FILE.schema,
    ],
};

keys! {
    /// The blade file, with line, twist and stations, of any known format; a relative path is
    /// relative to the folder of this file.
    FILE: String = "file", [Text], required, "\"nrel5mw.blade.json\"";
    /// Name of the body in an htc file of HAWC2, or `"tower"` of a windIO file, in place of the blade.
    pub(in crate::input) BODY: Option<String> = "body", [Text], optional, "\"tower\"";
    /// Number of elements.
    ELEMENTS: Option<usize> = "elements", [Count(MOST_ELEMENTS)], optional, "30";
    /// Length of a straight blade, for files of sections without a line.
    LENGTH: Option<f64> = "length", [Positive(Dimension::LENGTH)], optional, "61.5";
    /// Whether sections without shear stiffness are rigid in shear.
    RIGID_SHEAR: bool = "rigid_shear", [Boolean], or "false" = false, "true";
}

/// Elements of one blade: more are treated as an error.
const MOST_ELEMENTS: usize = 10_000;
/// Difference of the length of a part and of its file, as part of it: rounded digits.
const SAME_LENGTH: f64 = 0.01;
/// Angle of a kink between straight pieces of the line, at which an element must end
/// \[rad\]: half a degree, as of a curve with 314 points per half turn.
const KINK: f64 = 0.01;
/// A station nearer to an element end than this part of the element is at it.
const AT_END: f64 = 1e-9;

/// Largest number of halvings of the stiffness between two stations that elements follow.
const MOST_HALVINGS: f64 = 8.0;

/// A blade file, and its division into elements.
#[derive(Debug)]
pub(super) struct StationLine {
    blade: Blade,
    curve: Curve,
    /// Name of the file, and the fingerprint of its content.
    file: String,
    /// Number of elements; `None` for element ends at the stations.
    elements: Option<usize>,
}

/// Reads the file named by `file` of a card.
pub(super) fn read(table: &Table<'_>, builder: &mut ModelBuilder) -> Option<StationLine> {
    let (elements, length) = (table.get(&ELEMENTS), table.get(&LENGTH));
    let (rigid_shear, body) = (table.get(&RIGID_SHEAR), table.get(&BODY));
    let damping = damping::read_of_file(table);
    let words = "blade from a file".to_owned();
    heat::refuse_without_properties(table, &words);
    let written = table.get(&FILE)?;
    let document = table.document();
    let path = table.existing(&FILE, &written)?;
    let options = Options {
        length: length?,
        rigid_shear: rigid_shear?,
        body: body?,
    };
    let (_, mut reading) = document.keep(exchange::read_with(&path, &options))?;
    is_of_part(table, (&written, reading.blade.length()), options.length)?;
    // The damping of the card replaces the damping of the file.
    if let Some(damping) = damping? {
        reading.blade.damping = Some(everywhere(damping, reading.blade.stations.len()));
    }
    document.keep(reading.check(&path))?;
    builder.add_remarks(reading.remarks);
    Some(StationLine {
        curve: reading.blade.line.curve(),
        file: named(&path),
        blade: reading.blade,
        elements: elements?,
    })
}

/// The name of a file, with the fingerprint of its content.
fn named(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let hash = sha256_of_file(path).unwrap_or_default();
    format!("{name} {}", fingerprint(&hash))
}

/// Notes a tower or a wing whose file has another line, as of the blade in a file with several bodies.
fn is_of_part(table: &Table<'_>, (file, found): (&str, f64), expected: Option<f64>) -> Option<()> {
    let expected = expected.filter(|_| table.has("part"));
    let Some(expected) = expected.filter(|length| (found - length).abs() > SAME_LENGTH * length)
    else {
        return Some(());
    };
    let file = file.to_owned();
    table.note(
        &FILE,
        &BladeProblem::LengthOfPart {
            file,
            found,
            expected,
        },
    );
    None
}

/// The damping of a card at all stations.
fn everywhere(damping: OfFile, stations: usize) -> BladeDamping {
    match damping {
        OfFile::Times(times) => BladeDamping::Times(times),
        OfFile::Section(own) => match *own {
            Damping::StiffnessProportional(time) => BladeDamping::Proportional(time),
            Damping::Viscous(matrix) => BladeDamping::Viscous(vec![matrix; stations]),
        },
    }
}

/// The eigenvalue of `K_to v = ratio K_from v` with the largest absolute logarithm:
/// independent of axes and reference point. `None` if a stiffness is not positive definite.
fn most_change(from: &Matrix6<f64>, to: &Matrix6<f64>) -> Option<f64> {
    let inverse = from.cholesky()?.l().try_inverse()?;
    let ratios = (inverse * to * inverse.transpose()).symmetric_eigenvalues();
    let size = |ratio: &f64| ratio.ln().abs();
    let sound = ratios.iter().copied().filter(|ratio| *ratio > 0.0);
    sound.max_by(|a, b| size(a).total_cmp(&size(b)))
}

/// Positions inside a span over which a positive quantity changes linearly by a ratio,
/// between which it changes at most by a factor of two.
fn halved(span: [f64; 2], ratio: f64) -> Vec<f64> {
    let pieces = ratio.log2().abs().ceil();
    if !pieces.is_finite() || pieces < 2.0 {
        return Vec::new();
    }
    let pieces = pieces.min(MOST_HALVINGS);
    let part = |k: f64| (ratio.powf(k / pieces) - 1.0) / (ratio - 1.0);
    (1..pieces as usize)
        .map(|k| span[0] + part(k as f64) * (span[1] - span[0]))
        .collect()
}

impl StationLine {
    /// The file, with its fingerprint.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// Arc length of the tip \[m\].
    pub fn length(&self) -> f64 {
        self.curve.length()
    }

    /// Position on the line at an arc length \[m\].
    pub fn position(&self, arc_length: f64) -> Vector3<f64> {
        self.curve.at(arc_length).position
    }

    /// Nodes and beams, with element ends at `masses` too.
    pub fn lay(&self, masses: &[f64], table: &Table<'_>) -> Option<BladeLayout> {
        let ends = self.ends(masses, table)?;
        let mut layout = BladeLayout::default();
        let mut evaluated = Vec::new();
        for pair in ends.windows(2) {
            let span = [pair[0], pair[1]];
            let (properties, positions) = self.properties(span);
            evaluated.extend(positions);
            let middle = 0.5 * (span[0] + span[1]);
            let positions = [
                self.node(span[0], Side::Outer),
                self.node(middle, Side::Outer),
                self.node(span[1], Side::Inner),
            ];
            layout.add(
                positions,
                format!(", from {:.4} to {:.4} m", span[0], span[1]),
                properties,
            );
        }
        // Stations were checked: remaining problems are due to rounding, and the worst is
        // reported.
        let value = |problem: &blade::BladeProblem| match problem {
            blade::BladeProblem::Indefinite { value, .. } => *value,
            _ => f64::NEG_INFINITY,
        };
        let problems = self.blade.problems_at(&evaluated).into_iter();
        if let Some(worst) = problems.min_by(|a, b| value(a).total_cmp(&value(b))) {
            table.note(&FILE, &worst);
            return None;
        }
        Some(layout)
    }

    fn node(&self, arc_length: f64, side: Side) -> LayoutNode {
        let point = self.curve.on(arc_length, side);
        LayoutNode {
            arc_length,
            position: point.position,
            axes: point.axes,
        }
    }

    /// Element ends from the root to the tip.
    fn ends(&self, masses: &[f64], table: &Table<'_>) -> Option<Vec<f64>> {
        let mut fixed = [masses, &self.blade.jumps()].concat();
        let mut wished = self.blade.positions();
        wished.extend(self.steep_positions());
        let known = self.curve.arc_lengths();
        match self.blade.line.course {
            Course::Spline => {}
            Course::Arcs => wished.extend(known),
            Course::Polyline => {
                fixed.extend(known.iter().filter(|position| self.turn(**position) > KINK));
                wished.extend(known);
            }
        }
        let ends = Ends {
            length: self.length(),
            fixed: &fixed,
            stations: &wished,
        };
        let Some(found) = self.elements else {
            return Some(ends.at_stations());
        };
        let number = ends.of_number(found);
        let too_few = |needed| table.note(&ELEMENTS, &BladeProblem::TooFew { found, needed });
        number.map_err(too_few).ok()
    }

    /// Positions between stations at which the stiffness has changed by a factor of two
    /// since the previous position: one element over a tip that is a hundred times softer
    /// at its end than at its beginning would be too stiff there.
    fn steep_positions(&self) -> Vec<f64> {
        let positions = self.blade.positions();
        let spans = positions.windows(2).flat_map(|pair| {
            let inner = self.blade.at(pair[0], Side::Outer).0;
            let outer = self.blade.at(pair[1], Side::Inner).0;
            most_change(&inner, &outer)
                .map_or_else(Vec::new, |ratio| halved([pair[0], pair[1]], ratio))
        });
        spans.collect()
    }

    /// Angle by which the line turns at a position \[rad\].
    fn turn(&self, position: f64) -> f64 {
        let tangent = |side| self.curve.on(position, side).tangent;
        tangent(Side::Inner).angle(&tangent(Side::Outer))
    }

    /// Properties along an element, and the arc lengths of its evaluation points \[m\].
    fn properties(&self, [from, to]: [f64; 2]) -> (BeamProperties, [f64; 2]) {
        let length = to - from;
        let positions = Beam::evaluation_points().map(|xi| from + 0.5 * (1.0 + xi) * length);
        let stiffness = positions.map(|position| self.blade.at(position, Side::Outer).0);
        let mass = |position, side| self.blade.at(position, side).1;
        let mut masses = vec![(-1.0, mass(from, Side::Outer))];
        let near = AT_END * length;
        for position in self.blade.positions() {
            if position > from + near && position < to - near {
                let xi = 2.0 * (position - from) / length - 1.0;
                masses.push((xi, mass(position, Side::Outer)));
            }
        }
        masses.push((1.0, mass(to, Side::Inner)));
        let [first, last] = positions.map(|position| self.blade.damping_at(position, Side::Outer));
        let damping = first.zip(last).map(|(first, last)| [first, last]);
        let properties = BeamProperties::varying(stiffness, masses, length).damped(damping);
        (properties, positions)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // From 8 to 1 over 7 m: 4 at 4 m, 2 at 6 m; a change by less than two has no position.
    #[test]
    fn positions_are_where_a_quantity_has_halved() {
        let found = halved([0.0, 7.0], 1.0 / 8.0);
        assert_eq!(found.len(), 2);
        assert!((found[0] - 4.0).abs() < 1e-14 && (found[1] - 6.0).abs() < 1e-14);
        let rising = halved([0.0, 7.0], 8.0);
        assert!((rising[0] - 1.0).abs() < 1e-14 && (rising[1] - 3.0).abs() < 1e-14);
        assert_eq!(halved([0.0, 7.0], 1.0 / 1.9), Vec::<f64>::new());
        assert_eq!(halved([0.0, 7.0], 1.0), Vec::<f64>::new());
        assert_eq!(halved([0.0, 7.0], 0.0), Vec::<f64>::new());
    }
}

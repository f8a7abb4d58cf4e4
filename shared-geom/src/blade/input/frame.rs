//! The declared axes of a blade file: frame, order of the components, reference point.

use nalgebra::{Matrix3, Matrix6, Vector2, Vector3};

use super::keys::{FRAME, ORDER, REFERENCE_POINT, SECTION_FILE, STATION, TWIST_POSITIVE};
use super::problem::InputProblem;
use super::values::{COMPONENTS, DIRECTIONS, FRAMES};
use crate::document::{DocumentProblem, Table};
use crate::exchange::frame::Convention;
use crate::units::Dimension;
use crate::wrench;

/// The frames, in the order of their names. The twist of BeamDyn is positive about minus its
/// own z.
const NAMED: [Convention; 6] = [
    Convention::Helicoid,
    Convention::BeamDyn,
    Convention::Hawc2,
    Convention::Vabs,
    Convention::Vabs,
    Convention::Anba4,
];
/// The directions that describe axes, in Helicoid's axes, in the order of their words.
const AXES_OF_WORDS: [[f64; 3]; 6] = [
    [1.0, 0.0, 0.0],
    [-1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, -1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.0, 0.0, -1.0],
];
const AXES: [&str; 3] = ["x", "y", "z"];

/// The axes of the numbers of a file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Frame {
    /// Its axes in Helicoid's, as columns.
    axes: Matrix3<f64>,
    /// The component, along and then about its axes, at each index of its six.
    order: [usize; 6],
    /// One if a positive twist is nose up, else minus one.
    nose_up: f64,
}

impl Frame {
    /// Reads `frame`, `order` and `twist_positive` of the file.
    pub fn read(root: &Table<'_>) -> Option<Self> {
        // All of them are known keys, even if others are wrong.
        let given = [FRAME.name(), ORDER.name(), TWIST_POSITIVE.name()].map(|key| root.has(key));
        if given == [false; 3] && has_only_property_files(root) {
            return Some(Self::ours());
        }
        if !given[0] {
            root.note(&FRAME, &InputProblem::FrameUndeclared);
            return None;
        }
        let named = root.is_text(&FRAME);
        let (axes, nose_up) = if named {
            let convention = root.word(FRAME.name(), &FRAMES).map(|index| NAMED[index]);
            let nose_up = match convention {
                Some(Convention::BeamDyn) => -1.0,
                _ => 1.0,
            };
            (convention.map(Convention::axes), nose_up)
        } else {
            let words = root.texts(FRAME.name())?;
            let axes = directions(&words);
            if axes.is_none() {
                root.note(&FRAME, &InputProblem::Directions { found: words });
            }
            (axes, 1.0)
        };
        let order = order(root, named);
        let declared = root.get(&TWIST_POSITIVE);
        Some(Self {
            axes: axes?,
            order: order?,
            nose_up: declared?.map_or(nose_up, |sense| [1.0, -1.0][sense]),
        })
    }

    /// The declaration of the file as text.
    pub fn words(root: &Table<'_>) -> Option<String> {
        if !root.has(&FRAME) {
            return None;
        }
        let axes = root.texts(FRAME.name())?;
        let mut words = match &axes[..] {
            [x, y, z] => format!("x to {x}, y to {y}, z to {z}"),
            _ => axes.join(", "),
        };
        if root.has(&ORDER) {
            words += &format!("; order {}", root.texts(ORDER.name())?.join(", "));
        }
        Some(words)
    }

    /// Helicoid's frame.
    pub fn ours() -> Self {
        Self {
            axes: Matrix3::identity(),
            order: [0, 1, 2, 3, 4, 5],
            nose_up: 1.0,
        }
    }

    /// Whether its axes are Helicoid's.
    pub fn is_ours(&self) -> bool {
        self.axes == Matrix3::identity()
    }

    /// A vector in Helicoid's axes, from its components.
    pub fn vector(&self, components: [f64; 3]) -> Vector3<f64> {
        // Plus zero: no signed zero.
        (self.axes * Vector3::from(components)).add_scalar(0.0)
    }

    /// A twist in its sign convention, as nose up.
    pub fn twist(&self, twist: f64) -> f64 {
        self.nose_up * twist + 0.0
    }

    /// A matrix in Helicoid's axes and order, from its own.
    pub fn matrix(&self, matrix: &Matrix6<f64>) -> Matrix6<f64> {
        let mut natural = Matrix6::zeros();
        for (i, j) in (0..6).flat_map(|i| (0..6).map(move |j| (i, j))) {
            natural[(self.order[i], self.order[j])] = matrix[(i, j)];
        }
        wrench::rotate(&natural, &self.axes.transpose())
    }

    /// Kind of the component at an index of its six: a force (false) or a moment (true).
    pub fn is_moment(&self, index: usize) -> bool {
        self.order[index] >= 3
    }

    /// Six numbers, one for each component, in Helicoid's order, from its own; without
    /// signs.
    pub fn values(&self, values: [f64; 6]) -> [f64; 6] {
        let mut natural = [0.0; 6];
        for (index, value) in self.order.into_iter().zip(values) {
            natural[index] = value;
        }
        let theirs = |ours: usize| (0..3).find(|&j| self.axes[(ours, j)] != 0.0);
        let index = |i: usize| match i {
            0..3 => theirs(i).unwrap_or(i),
            _ => theirs(i - 3).unwrap_or(i - 3) + 3,
        };
        std::array::from_fn(|i| natural[index(i)])
    }

    /// The indices of its two axes in the section.
    fn plane(&self) -> [usize; 2] {
        let along = (0..3).find(|&j| self.axes[(0, j)] != 0.0);
        match along {
            Some(1) => [0, 2],
            Some(2) => [0, 1],
            _ => [1, 2],
        }
    }

    /// The names of its two axes in the section.
    pub fn plane_names(&self) -> [&'static str; 2] {
        self.plane().map(|axis| AXES[axis])
    }

    /// A point of the section, by the coordinates along its two axes there, as (y, z).
    pub fn point(&self, coordinates: [f64; 2]) -> Vector2<f64> {
        let mut components = [0.0; 3];
        for (axis, coordinate) in self.plane().into_iter().zip(coordinates) {
            components[axis] = coordinate;
        }
        let point = self.vector(components);
        // Plus zero: no signed zero.
        Vector2::new(point.y + 0.0, point.z + 0.0)
    }
}

/// The axes of three directions; `None` unless they form a right-handed frame.
fn directions(words: &[String]) -> Option<Matrix3<f64>> {
    let of = |word: &String| {
        let index = DIRECTIONS.iter().position(|known| known == word)?;
        Some(Vector3::from(AXES_OF_WORDS[index]))
    };
    let columns: Option<Vec<_>> = words.iter().map(of).collect();
    let axes = match columns?[..] {
        [x, y, z] => Matrix3::from_columns(&[x, y, z]),
        _ => return None,
    };
    (axes.determinant() == 1.0).then_some(axes)
}

/// The order of the components: declared, or implied by a named frame.
fn order(root: &Table<'_>, named: bool) -> Option<[usize; 6]> {
    if !root.has(&ORDER) {
        if named {
            return Some([0, 1, 2, 3, 4, 5]);
        }
        root.note(&FRAME, &InputProblem::OrderUndeclared);
        return None;
    }
    let words = root.texts(ORDER.name())?;
    let index = |word: &String| COMPONENTS.iter().position(|known| known == word);
    let indices: Option<Vec<_>> = words.iter().map(index).collect();
    let indices: Option<[usize; 6]> = indices.and_then(|indices| indices.try_into().ok());
    let is_complete = |indices: &[usize; 6]| (0..6).all(|i| indices.contains(&i));
    let indices = indices.filter(is_complete);
    if indices.is_none() {
        root.note(&ORDER, &InputProblem::Order { found: words });
    }
    indices
}

/// Whether all stations are property files, which state their axes and their point.
fn has_only_property_files(root: &Table<'_>) -> bool {
    // Other forms of the key are reported by the reader of the stations.
    let stations = if root.is_list(&STATION) {
        root.tables(&STATION)
    } else {
        Vec::new()
    };
    !stations.is_empty() && stations.iter().all(|station| station.has(&SECTION_FILE))
}

/// Reads `reference_point`: the word `"line"`, or two lengths; required, unless all stations
/// are property files.
pub(super) fn reference_point(root: &Table<'_>, frame: Option<&Frame>) -> Option<Vector2<f64>> {
    const KEY: &str = REFERENCE_POINT.name();
    if !root.has(KEY) && has_only_property_files(root) {
        return Some(Vector2::zeros());
    }
    if !root.has(KEY) {
        root.note(KEY, &InputProblem::PointUndeclared);
        return None;
    }
    if root.is_text(KEY) {
        return root.word(KEY, &["line"]).map(|_| Vector2::zeros());
    }
    point(root, KEY, frame)
}

/// Two lengths, a point of the section in the axes of the frame, as (y, z).
pub(super) fn point(
    table: &Table<'_>,
    key: &'static str,
    frame: Option<&Frame>,
) -> Option<Vector2<f64>> {
    let lengths = table.quantities(key, Dimension::LENGTH)?;
    match lengths[..] {
        [a, b] => Some(frame?.point([a, b])),
        _ => {
            let names = frame.map_or(["y", "z"], Frame::plane_names);
            let problem = DocumentProblem::WrongValue {
                key: key.to_owned(),
                found: format!("a list of {}", lengths.len()),
                expected: format!("two lengths, {} and {}", names[0], names[1]),
            };
            table.note(key, &problem);
            None
        }
    }
}

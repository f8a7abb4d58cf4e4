//! Conditions that section properties must satisfy before a computation.

use nalgebra::{DMatrix, Matrix6};

use super::{Change, Damping, PRESTRESS_COMPONENTS, SectionProperties, Step};
use crate::error::Explain;
use crate::wrench::COMPONENTS;

mod imposed;

/// Largest asymmetry accepted, relative to sqrt(Aii Ajj): files written with seven
/// digits pass, a sign error or an exchanged row does not.
const SYMMETRY: f64 = 1e-6;
/// Largest violation accepted of `M11 = M22 = M33` and `M44 = M55 + M66`, relative.
const MASS_STRUCTURE: f64 = 1e-6;
/// Largest magnitude of an entry: squares of larger numbers, and their sums over the
/// components, are close to overflow. No section is so stiff in any unit.
const LARGEST: f64 = 1e100;
/// Smallest eigenvalue of a scaled matrix that is treated as semidefinite: round-off of a
/// file written with seven digits.
const SEMIDEFINITE: f64 = -1e-6;

/// Errors of section properties.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PropertyProblem {
    /// The text is not the JSON of a property file.
    #[error("not a property file: {reason}")]
    Malformed {
        /// The parser's message.
        reason: String,
    },
    /// The file is of a later version of the format.
    #[error("written in version {found} of the property-file format, expected at most {known}")]
    Newer {
        /// The version of the file.
        found: u64,
        /// The version that this program writes.
        known: u64,
    },
    /// The file declares other units.
    #[error("units are \"{found}\", expected \"SI\"")]
    Units {
        /// The word found.
        found: String,
    },
    /// A number that is not finite.
    #[error("{field} holds a number that is not finite")]
    NotFinite {
        /// The field.
        field: &'static str,
    },
    /// A number whose square overflows.
    #[error("{field} holds {found:e}, expected numbers of at most 1e100 in magnitude")]
    TooLarge {
        /// The field.
        field: &'static str,
        /// The number [unit of the field].
        found: f64,
    },
    /// Two imposed states of one name.
    #[error("two imposed states are called \"{name}\", expected one of this name")]
    ImposedTwice {
        /// The name.
        name: String,
    },
    /// A restrained force that does not agree with the free strain.
    #[error(
        "imposed state \"{name}\": \"restrained_force\" is not minus the stiffness times \
         \"free_strain\" (off by {error:.1e} of it)"
    )]
    ImposedForce {
        /// Name of the state.
        name: String,
        /// Relative difference [-].
        error: f64,
    },
    /// A problem of one of the imposed states.
    #[error("imposed state \"{name}\": {problem}")]
    OfState {
        /// Index of the state, from zero.
        index: usize,
        /// Name of the state.
        name: String,
        /// The problem.
        problem: Box<PropertyProblem>,
    },
    /// A list or matrix of another size.
    #[error("{field} is {found}, expected {expected}")]
    Size {
        /// The field.
        field: &'static str,
        /// Size found.
        found: String,
        /// Size expected.
        expected: String,
    },
    /// A matrix that is not symmetric.
    #[error(
        "{field} is not symmetric: entry ({row}, {column}) is {upper:e} and ({column}, {row}) is {lower:e}"
    )]
    Asymmetric {
        /// The field.
        field: &'static str,
        /// Row, from one.
        row: usize,
        /// Column, from one.
        column: usize,
        /// Entry above the diagonal [unit of the matrix].
        upper: f64,
        /// Entry below the diagonal [unit of the matrix].
        lower: f64,
    },
    /// A diagonal entry that must be positive.
    #[error("{field} has {value:e} at ({index}, {index}) ({component}), expected more than zero")]
    Diagonal {
        /// The field.
        field: &'static str,
        /// Row and column, from one.
        index: usize,
        /// Its component.
        component: &'static str,
        /// The entry [unit of the matrix].
        value: f64,
    },
    /// A stiffness without both shear stiffnesses.
    #[error("stiffness has 0 at (2, 2) (shear y) and at (3, 3) (shear z), expected more than zero")]
    NoShear,
    /// A matrix with a negative (or zero) eigenvalue.
    #[error("{field} is not {expected}: its smallest scaled eigenvalue is {value:.3e}")]
    Indefinite {
        /// The field.
        field: &'static str,
        /// The property expected.
        expected: &'static str,
        /// Smallest eigenvalue of the matrix scaled to a unit diagonal [-].
        value: f64,
    },
    /// Translational masses that differ.
    #[error("mass has {found:?} at (1, 1), (2, 2), (3, 3), expected three equal masses")]
    UnequalMass {
        /// The three entries [kg/m].
        found: [f64; 3],
    },
    /// A polar moment of inertia that differs from the sum of the two others.
    #[error("mass has {polar:e} at (4, 4), expected (5, 5) + (6, 6) = {sum:e}")]
    Polar {
        /// Polar moment of inertia per length [kg m].
        polar: f64,
        /// Sum of the two others [kg m].
        sum: f64,
    },
    /// A reference line that does not point out of the section.
    #[error("initial_curvature has the slope {found:?}, expected a first component above zero")]
    Slope {
        /// The slope [-].
        found: [f64; 3],
    },
    /// A table of prestress of a curved beam.
    #[error("prestress is known for straight beams only, and the section has an initial curvature")]
    CurvedPrestress,
    /// A damping factor below zero.
    #[error("damping is {found}, expected zero or more")]
    NegativeDamping {
        /// The factor [s].
        found: f64,
    },
}

impl Explain for PropertyProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::Malformed { .. } => Some(
                "property files are JSON, as section-analyzer writes them; blade files belong to \
                 beam-dynamics"
                    .to_owned(),
            ),
            Self::Newer { .. } => Some("use a newer version of this program".to_owned()),
            Self::Units { .. } => Some("property files are always SI".to_owned()),
            Self::Slope { .. } => Some(
                "the slope is the derivative of the reference line in section axes: [1, 0, 0] \
                 where it is normal to the section"
                    .to_owned(),
            ),
            Self::Asymmetric { field, .. } => order(field),
            Self::Polar { .. } | Self::UnequalMass { .. } => order("mass"),
            Self::OfState { problem, .. } => problem.help(),
            Self::TooLarge { .. } => Some(
                "the number may have lost its decimal point, or have run into another".to_owned(),
            ),
            _ => None,
        }
    }
}

/// The order of the rows of a matrix, as text.
fn order(field: &str) -> Option<String> {
    let names = match field {
        "stiffness" | "mass" | "damping" => COMPONENTS.to_vec(),
        "stiffness_change" | "stiffness_per_kelvin" => {
            PRESTRESS_COMPONENTS.map(|i| COMPONENTS[i]).to_vec()
        }
        _ => return None,
    };
    Some(format!("the order is {}", names.join(", ")))
}

/// Name of the field with the problem, and the problem.
pub(super) type FieldProblem = (&'static str, PropertyProblem);

impl SectionProperties {
    /// All problems of the properties; empty if they are valid: finite, symmetric,
    /// stiffness positive definite, mass positive semidefinite with `M11 = M22 = M33` and
    /// `M44 = M55 + M66`.
    pub fn problems(&self) -> Vec<PropertyProblem> {
        self.field_problems().into_iter().map(|p| p.1).collect()
    }

    pub(super) fn field_problems(&self) -> Vec<FieldProblem> {
        let mut found = Vec::new();
        stiffness(&self.stiffness, &mut found);
        mass(&self.mass, &mut found);
        scalars(self, &mut found);
        imposed::check(self, &mut found);
        slope(self, &mut found);
        piezo(self, &mut found);
        damping(self, &mut found);
        found
    }
}

/// All problems of a stiffness and a mass per length, as [`SectionProperties::problems`].
pub(crate) fn matrix_problems(
    stiffness_matrix: &Matrix6<f64>,
    mass_matrix: &Matrix6<f64>,
) -> Vec<PropertyProblem> {
    let mut found = Vec::new();
    stiffness(stiffness_matrix, &mut found);
    mass(mass_matrix, &mut found);
    found.into_iter().map(|p| p.1).collect()
}

/// A number of a stiffness or a mass per length that no computation can use, not even the
/// check of the matrices.
pub(crate) fn unusable(stiffness: &Matrix6<f64>, mass: &Matrix6<f64>) -> Option<PropertyProblem> {
    let fields = [("stiffness", stiffness), ("mass", mass)];
    fields
        .iter()
        .find_map(|(field, matrix)| unusable_entry(field, matrix.as_slice()))
}

fn unusable_entry(field: &'static str, entries: &[f64]) -> Option<PropertyProblem> {
    let found = entries
        .iter()
        .copied()
        .find(|entry| entry.is_nan() || entry.abs() > LARGEST)?;
    Some(if found.is_finite() {
        PropertyProblem::TooLarge { field, found }
    } else {
        PropertyProblem::NotFinite { field }
    })
}

/// All problems of a mass per length, as [`SectionProperties::problems`].
pub fn mass_problems(matrix: &Matrix6<f64>) -> Vec<PropertyProblem> {
    let mut found = Vec::new();
    mass(matrix, &mut found);
    found.into_iter().map(|p| p.1).collect()
}

/// Smallest eigenvalue of the symmetric part scaled to a unit diagonal [-]; NaN for a
/// matrix that contains one.
pub fn least_eigenvalue(matrix: &Matrix6<f64>) -> f64 {
    if matrix.iter().all(|entry| entry.is_finite()) {
        smallest_scaled_eigenvalue(&dynamic(matrix))
    } else {
        f64::NAN
    }
}

fn stiffness(k: &Matrix6<f64>, found: &mut Vec<FieldProblem>) {
    let field = "stiffness";
    if !symmetric(field, &dynamic(k), found) {
        return;
    }
    if k[(1, 1)] == 0.0 && k[(2, 2)] == 0.0 {
        return found.push((field, PropertyProblem::NoShear));
    }
    for i in 0..6 {
        if k[(i, i)] <= 0.0 {
            let problem = PropertyProblem::Diagonal {
                field,
                index: i + 1,
                component: COMPONENTS[i],
                value: k[(i, i)],
            };
            return found.push((field, problem));
        }
    }
    let value = smallest_scaled_eigenvalue(&dynamic(k));
    if value <= 0.0 {
        let problem = PropertyProblem::Indefinite {
            field,
            expected: "positive definite",
            value,
        };
        found.push((field, problem));
    }
}

fn mass(m: &Matrix6<f64>, found: &mut Vec<FieldProblem>) {
    let field = "mass";
    if !symmetric(field, &dynamic(m), found) {
        return;
    }
    semidefinite(field, &dynamic(m), found);
    let translational = [m[(0, 0)], m[(1, 1)], m[(2, 2)]];
    let spread = |value: f64| (value - translational[0]).abs();
    let limit = MASS_STRUCTURE * translational[0].abs();
    if translational.iter().any(|&value| spread(value) > limit) {
        let found_masses = translational;
        let problem = PropertyProblem::UnequalMass {
            found: found_masses,
        };
        found.push((field, problem));
    }
    let (polar, sum) = (m[(3, 3)], m[(4, 4)] + m[(5, 5)]);
    if (polar - sum).abs() > MASS_STRUCTURE * polar.abs().max(sum.abs()) {
        found.push((field, PropertyProblem::Polar { polar, sum }));
    }
}

/// Finiteness of everything except matrices and optional data with their own checks.
fn scalars(section: &SectionProperties, found: &mut Vec<FieldProblem>) {
    let mut finite = |field, good: bool| {
        if !good {
            found.push((field, PropertyProblem::NotFinite { field }));
        }
    };
    let all = |values: &[f64]| values.iter().all(|value| value.is_finite());
    let centers = section.centers;
    let axes = section.principal_axes;
    finite("reference_point", all(section.reference_point.as_slice()));
    finite(
        "centers",
        [centers.tension, centers.shear, centers.mass]
            .iter()
            .all(|center| all(center.as_slice())),
    );
    finite(
        "principal_axes",
        all(&[axes.bending_angle, axes.inertia_angle])
            && all(&axes.bending_stiffness)
            && all(&axes.inertia),
    );
    let finite_step = |step: &Step| match step.change {
        Change::Shift(by) => all(by.as_slice()),
        Change::Rotate(angle) => angle.is_finite(),
    };
    finite(
        "history",
        section.provenance.history.iter().all(finite_step),
    );
    if let Some(initial) = &section.initial_curvature {
        let good = all(initial.curvature.as_slice()) && all(initial.slope.as_slice());
        finite("initial_curvature", good);
    }
    if let Some(thermal) = &section.thermal_force {
        finite("thermal_force", all(thermal.as_slice()));
    }
    if let Some(prestress) = &section.prestress {
        finite("prestress", prestress.third.is_finite());
        if let Some(change) = &prestress.per_kelvin {
            imposed::change_of_stiffness("stiffness_per_kelvin", section, change, found);
        }
        let mut initial = section.initial_curvature.iter();
        if initial.any(|initial| !initial.is_straight()) {
            found.push(("prestress", PropertyProblem::CurvedPrestress));
        }
    }
}

/// A reference line that points into the section, or along it.
fn slope(section: &SectionProperties, found: &mut Vec<FieldProblem>) {
    let initial = section.initial_curvature.iter();
    // Values that are not finite were reported before.
    let slopes = initial.map(|initial| initial.slope);
    let slopes = slopes.filter(|slope| slope.iter().all(|x| x.is_finite()));
    for slope in slopes.filter(|slope| slope.x <= 0.0) {
        let found_slope = slope.into();
        let problem = PropertyProblem::Slope { found: found_slope };
        found.push(("initial_curvature", problem));
    }
}

fn piezo(section: &SectionProperties, found: &mut Vec<FieldProblem>) {
    let Some(piezo) = &section.piezo else {
        return;
    };
    let n = piezo.electrodes.len();
    let mut size = |field, matrix: &DMatrix<f64>, rows: usize| {
        if matrix.shape() != (rows, n) {
            let problem = PropertyProblem::Size {
                field,
                found: format!("{} x {}", matrix.nrows(), matrix.ncols()),
                expected: format!("{rows} x {n}, one column an electrode"),
            };
            found.push(("piezo", problem));
        } else if matrix.iter().any(|value| !value.is_finite()) {
            found.push(("piezo", PropertyProblem::NotFinite { field }));
        }
    };
    size("piezo coupling", &piezo.coupling, 6);
    size("piezo capacitance", &piezo.capacitance, n);
    if piezo.capacitance.is_square() {
        symmetric("piezo capacitance", &piezo.capacitance, found);
    }
}

fn damping(section: &SectionProperties, found: &mut Vec<FieldProblem>) {
    let field = "damping";
    match &section.damping {
        Some(Damping::StiffnessProportional(time)) if !time.is_finite() => {
            found.push((field, PropertyProblem::NotFinite { field }));
        }
        Some(Damping::StiffnessProportional(time)) if *time < 0.0 => {
            found.push((field, PropertyProblem::NegativeDamping { found: *time }));
        }
        Some(Damping::Viscous(matrix)) if symmetric(field, &dynamic(matrix), found) => {
            semidefinite(field, &dynamic(matrix), found);
        }
        _ => {}
    }
}

fn semidefinite(field: &'static str, matrix: &DMatrix<f64>, found: &mut Vec<FieldProblem>) {
    let value = smallest_scaled_eigenvalue(matrix);
    if value < SEMIDEFINITE {
        let expected = "positive semidefinite";
        found.push((
            field,
            PropertyProblem::Indefinite {
                field,
                expected,
                value,
            },
        ));
    }
}

/// Notes numbers that are not finite and the first asymmetric pair.
fn symmetric(field: &'static str, a: &DMatrix<f64>, found: &mut Vec<FieldProblem>) -> bool {
    if let Some(problem) = unusable_entry(field, a.as_slice()) {
        found.push((field, problem));
        return false;
    }
    for i in 0..a.nrows() {
        for j in i + 1..a.ncols() {
            let scale = (a[(i, i)] * a[(j, j)]).abs().sqrt();
            let (upper, lower) = (a[(i, j)], a[(j, i)]);
            if (upper - lower).abs() > SYMMETRY * scale.max(f64::MIN_POSITIVE) {
                let (row, column) = (i + 1, j + 1);
                let problem = PropertyProblem::Asymmetric {
                    field,
                    row,
                    column,
                    upper,
                    lower,
                };
                found.push((field, problem));
                return false;
            }
        }
    }
    true
}

/// Smallest eigenvalue of `A` scaled to a unit diagonal; a zero diagonal entry with a
/// coupling in its row makes the matrix indefinite.
fn smallest_scaled_eigenvalue(a: &DMatrix<f64>) -> f64 {
    let largest = a.diagonal().amax();
    if largest == 0.0 {
        return -a.amax();
    }
    // A zero on the diagonal keeps its row unscaled, so that a coupling has an effect.
    let scale = a.diagonal().map(|value| {
        if value > 0.0 {
            value.sqrt()
        } else {
            largest.sqrt()
        }
    });
    let scaled = DMatrix::from_fn(a.nrows(), a.ncols(), |i, j| {
        0.5 * (a[(i, j)] + a[(j, i)]) / (scale[i] * scale[j])
    });
    scaled.symmetric_eigenvalues().min()
}

fn dynamic(matrix: &Matrix6<f64>) -> DMatrix<f64> {
    DMatrix::from_column_slice(6, 6, matrix.as_slice())
}

//! Sections that were solved for a curved and twisted beam, on the beams of a model.
//!
//! The undeformed line of a beam carries its curvature in kinematics and equilibrium
//! (D-21), the matrices of the section what it does inside of the section. Nothing is
//! added to either, and both must be those of one beam:
//!
//! ```text
//! k = axial( R_0^T dR_0/ds )        l = R_0^T dp_0/ds                        (D-230)
//! ```
//!
//! of the line are compared with the curvature and the slope of the property file.

use nalgebra::{Matrix6, Vector3};
use shared_geom::document::Table;
use shared_geom::section::{Agreement, CurvatureMismatch, InitialCurvature, SectionProperties};

use super::draft::{Beam, Draft};
use super::problem::InputProblem;
use crate::elements::beams;

/// A length of the slope that differs from one by less is that of digits.
const DIGITS: f64 = 1e-6;

/// What a section was solved for.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Curved {
    /// Name of the properties.
    name: String,
    /// Curvature and slope by arc length.
    initial: InitialCurvature,
    /// 6x6 stiffness \[N, N m, N m^2\].
    stiffness: Matrix6<f64>,
    /// Length of the line per unit of the parameter of the file: c of (D-231) \[-\].
    stretch: f64,
}

impl Curved {
    /// Of the properties of a file; `None` for those of a straight beam.
    pub fn of(name: &str, properties: &SectionProperties) -> Option<Self> {
        let initial = properties.initial_curvature?;
        let stretch = initial.slope.norm();
        (!initial.is_straight()).then(|| Self {
            name: name.to_owned(),
            initial: initial.per_arc_length(),
            stiffness: properties.stiffness * stretch,
            stretch,
        })
    }

    /// That the matrices of the file were those of another parameter, in words; `None`
    /// where it was the arc length.
    pub fn conversion(&self) -> Option<String> {
        ((self.stretch - 1.0).abs() > DIGITS).then(|| {
            format!(
                "the line of the section is {:.6} long per unit of the parameter of its \
                 matrices: stiffness times that and mass divided by it are those per arc length",
                self.stretch
            )
        })
    }

    /// Compares it with a line: notes on `table` that this is another beam, and tells in
    /// `draft` what differs a little. `user` says who uses the properties, and where.
    /// True unless it is another beam.
    fn is_on(
        &self,
        line: &InitialCurvature,
        user: &str,
        (table, key): (&Table<'_>, &str),
        draft: &mut Draft,
    ) -> bool {
        match Agreement::of(&self.initial, [*line; 2], &self.stiffness) {
            Agreement::Same => true,
            Agreement::Near(mismatch) => {
                draft.add_remarks(vec![self.remark(user, &mismatch)]);
                true
            }
            Agreement::Other(mismatch) => {
                let problem = InputProblem::OtherCurvature {
                    user: user.to_owned(),
                    name: self.name.clone(),
                    mismatch: Box::new(mismatch),
                };
                table.note(key, &problem);
                false
            }
        }
    }

    fn remark(&self, user: &str, mismatch: &CurvatureMismatch) -> String {
        format!(
            "{user}, properties \"{}\": {mismatch}; {}, and it is used as it is",
            self.name,
            mismatch.size()
        )
    }
}

/// Whether a straight piece, in words, with a twist that grows by `rate` \[1/m\] has the
/// curvature for which its section was solved.
pub(super) fn suits_piece(
    curved: Option<&Curved>,
    rate: f64,
    words: &str,
    table: &Table<'_>,
    draft: &mut Draft,
) -> bool {
    let line = InitialCurvature {
        curvature: Vector3::new(rate, 0.0, 0.0),
        ..InitialCurvature::STRAIGHT
    };
    curved.is_none_or(|curved| curved.is_on(&line, words, (table, "twist"), draft))
}

/// Whether a beam has the curvature for which its section was solved at both evaluation
/// points.
pub(super) fn suits_beam(beam: &Beam, table: &Table<'_>, draft: &mut Draft) -> bool {
    let Some(curved) = &beam.along.curved else {
        return true;
    };
    let (geometry, names) = (beam.geometry, beam.nodes);
    beams::Beam::evaluation_points().into_iter().all(|xi| {
        let nodes = names.map(|node| &draft.nodes()[node]);
        let line = geometry.initial_curvature(&nodes, xi);
        let (place, length) = (geometry.arc_length(&nodes, xi), geometry.length(&nodes));
        let user = format!("beam \"{}\", {place:.4} m of {length:.4} m", beam.label);
        curved.is_on(&line, &user, (table, "nodes"), draft)
    })
}

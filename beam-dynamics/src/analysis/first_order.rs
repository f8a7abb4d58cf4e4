//! Limits of a table of prestress, which is of first order in the strain.
//!
//! ```text
//! (T q + sum c_i T_i) v = part K v                                         (D-253)
//! ```

use crate::elements::SectionState;

/// Relative change of the stiffness beyond which a remark is given: the neglected terms are of the
/// order of its square.
const SIZABLE: f64 = 0.1;

/// A remark if the strain of `sections` changes a stiffness considerably, or makes it indefinite,
/// at `when` given as text, as in "at the last step".
pub(super) fn first_order(sections: &[SectionState], when: &str) -> Option<String> {
    let changes = || {
        sections.iter().filter_map(|section: &SectionState| {
            section
                .change_of_stiffness
                .map(|change| (change, &section.beam))
        })
    };
    let least = changes().min_by(|a, b| a.0[0].total_cmp(&b.0[0]))?;
    if least.0[0] <= -1.0 {
        return Some(format!(
            "{when} the strain of beam \"{}\" reduces the stiffness of its sections too far: \
             K + T e is not positive definite, and the equilibrium is unstable or outside the \
             range of a table of prestress",
            least.1
        ));
    }
    let size = |change: [f64; 2]| change[1].max(-change[0]);
    let most = changes().max_by(|a, b| size(a.0).total_cmp(&size(b.0)))?;
    let part = size(most.0);
    (part > SIZABLE).then(|| {
        format!(
            "{when} prestress changes the stiffness of beam \"{}\" by up to {:.0} %: the table is of \
             first order in the strain, and errors of the order of the square of this are to be \
             expected, most of all in large twist",
            most.1,
            100.0 * part
        )
    })
}

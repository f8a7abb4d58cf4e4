//! Remarks on motions that nothing resists, and on systems that act only in time.

use crate::assembly::mechanism::Mechanism;
use crate::case::Model;
use crate::elements::Element;

/// Remarks on the parts of a free model that can move; on their absence if there are none.
pub(super) fn free_parts(found: &[Mechanism]) -> Vec<String> {
    if found.is_empty() {
        return vec!["\"free\" of [modes] has no effect: all parts are held".to_owned()];
    }
    let of_zero = |part| format!("{part}: each a mode of frequency zero");
    found.iter().map(of_zero).collect()
}

/// Remark on joints that can move without a spring.
pub(super) fn free_hinges(names: &[String]) -> Option<String> {
    let [first, others @ ..] = names else {
        return None;
    };
    let others = match others.len() {
        0 => String::new(),
        count => format!(" and {count} more"),
    };
    Some(format!(
        "joint \"{first}\"{others} can move freely: at rest this is a motion of frequency zero"
    ))
}

/// Remark on systems that sample, in analyses without time.
pub(super) fn sampled(model: &Model) -> Option<String> {
    let elements = model.system.elements();
    let mut names = elements
        .filter(|one| one.memory().is_some())
        .map(Element::label);
    let first = names.next()?;
    let others = match names.count() {
        0 => String::new(),
        count => format!(" and {count} more"),
    };
    Some(format!(
        "\"{first}\"{others}, which samples, acts only in runs in time: in statics, buckling and \
         modes its outputs are zero"
    ))
}

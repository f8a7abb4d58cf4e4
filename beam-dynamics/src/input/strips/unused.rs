//! Constants of airfoil files that the model of the sections does not use.

use rotor_aero::airfoil::Section;
use rotor_aero::strip::SectionModel;

/// A remark on the constants of airfoils that the model of the strips of `user` does not use, if there
/// are any.
pub(super) fn remark<'a>(
    user: &str,
    model: &SectionModel,
    sections: impl Iterator<Item = &'a Section>,
) -> Option<String> {
    let used = model.used_constants();
    let is_used = |name: &str| used.iter().any(|own| own.eq_ignore_ascii_case(name));
    let mut unused: Vec<&str> = Vec::new();
    for (_, airfoil) in sections.flat_map(Section::parts) {
        for name in airfoil.unsteady().names() {
            if !is_used(name) && !unused.contains(&name) {
                unused.push(name);
            }
        }
    }
    (!unused.is_empty()).then(|| {
        format!(
            "{user}: section = \"{}\" does not use these constants of its airfoils: {}",
            model.word(),
            unused.join(", ")
        )
    })
}

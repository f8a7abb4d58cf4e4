//! Airfoils whose tables end at a Mach number.

use rotor_aero::airfoil::Section;

/// An airfoil whose table ends at a Mach number.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::input) struct MachLimit {
    /// Its name.
    pub airfoil: String,
    /// Largest Mach number of its table \[-\].
    pub largest: f64,
    /// Largest distance from the shaft with this airfoil \[m\].
    pub radius: f64,
}

/// The limits of sections at distances from the shaft \[m\], one for each airfoil with a table over
/// the Mach number.
pub(in crate::input) fn mach_limits<'a>(
    sections: impl Iterator<Item = (f64, &'a Section)>,
) -> Vec<MachLimit> {
    let mut limits: Vec<MachLimit> = Vec::new();
    for (radius, section) in sections {
        for (_, airfoil) in section.parts() {
            let Some([_, largest]) = airfoil.mach_range() else {
                continue;
            };
            let known = limits
                .iter_mut()
                .find(|known| known.airfoil == airfoil.name());
            match known {
                Some(known) => known.radius = known.radius.max(radius),
                None => limits.push(MachLimit {
                    airfoil: airfoil.name().to_owned(),
                    largest,
                    radius,
                }),
            }
        }
    }
    limits
}

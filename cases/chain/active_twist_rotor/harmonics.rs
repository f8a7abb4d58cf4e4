//! Forward flight with a voltage at each harmonic of the revolution: the vibration at the hub over its
//! phase, to first order in the voltage.

use std::path::Path;

use super::Result;
use super::flight::{Condition, Sizes, Vibration, over_phase};
use super::motion::Motion;

/// Harmonics of the revolution.
pub const HARMONICS: [usize; 6] = [1, 2, 3, 4, 5, 6];

/// The vibration at 4/rev over the phase of a voltage at each harmonic, in a condition whose motion without
/// voltage is `from`; `given` are further parameters.
///
/// # Errors
/// A trim that is not found.
pub fn by_harmonic(
    case: &Path,
    given: &[(&str, f64)],
    condition: Condition,
    from: &Motion,
) -> Result<Vec<(usize, Vibration)>> {
    let at = |harmonic: usize| {
        let own = [("harmonic", harmonic as f64)];
        let all: Vec<_> = given.iter().copied().chain(own).collect();
        let (_, vibration) = over_phase(case, &all, condition, Some(from))?;
        Ok((harmonic, vibration))
    };
    HARMONICS.into_iter().map(at).collect()
}

/// Prints them: at the voltage and the phase of the smallest moment, and the largest moment over the phase.
pub fn show(found: &[(usize, Vibration)], Condition { advance, volts, .. }: Condition) {
    println!(
        "\nForward flight, advance ratio {advance}: voltage of the least moment, first order;"
    );
    println!("the last column is the largest moment over the phase at {volts} V\n");
    println!(
        "{:>6}{:>8}{:>13}{:>18}{:>17}{:>17}{:>19}",
        "1/rev",
        "V",
        "phase [deg]",
        "moment [lbf ft]",
        "in plane [lbf]",
        "vertical [lbf]",
        "largest [lbf ft]"
    );
    for (harmonic, vibration) in found {
        let [part, phase] = vibration.optimum();
        let Sizes {
            moment,
            in_plane,
            vertical,
        } = vibration.with(part, phase);
        let largest = (0..360).map(|phase| vibration.at(f64::from(phase)).moment);
        let largest = largest.fold(0.0, f64::max);
        println!(
            "{harmonic:6}{:8.1}{phase:13.0}{moment:18.1}{in_plane:17.1}{vertical:17.1}{largest:19.1}",
            part * volts
        );
    }
}

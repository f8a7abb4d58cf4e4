//! The response of the blade in hover to voltages of all frequencies, from one periodic motion.

use std::path::Path;

use super::Result;
use super::motion::motion;

/// Amplitude of each harmonic of the voltage \[V\], and the largest voltage.
const VOLTS: [f64; 2] = [10.0, 250.0];
/// Harmonics whose phases are in the file, by the parameter `upper`.
const COUNTS: [usize; 2] = [6, 24];

/// The response at a frequency.
#[derive(Debug, Clone, Copy)]
pub struct Response {
    /// Frequency per revolution \[-\].
    pub order: f64,
    /// Amplitude at 250 V and phase against the voltage of the elastic twist \[deg\].
    pub twist: [f64; 2],
    /// The same of the flap hinge \[deg\].
    pub flap: [f64; 2],
}

/// The response at multiples of `spacing` per revolution: six of them, or `all` 24; `given` are
/// further parameters.
///
/// # Errors
/// A motion that is not found.
pub fn response(
    case: &Path,
    (spacing, all): (f64, bool),
    given: &[(&str, f64)],
) -> Result<Vec<Response>> {
    let upper = f64::from(u8::from(all));
    let own = [("spacing", spacing), ("upper", upper), ("volts", VOLTS[0])];
    let given: Vec<_> = own.into_iter().chain(given.iter().copied()).collect();
    let found = motion(
        &case.join("response.dynamics.toml"),
        "coupled",
        &given,
        None,
    )?;
    let mut last = [0.0; 2];
    let curve = |number: usize| {
        let of_column = ["twist", "flap"].map(|name| found.wave(name, number));
        let both = [0, 1].map(|index| {
            let [cosine, sine] = of_column[index];
            // The voltage is cos(k x - p), the response c cos(k x - p - lag).
            let lag = sine.atan2(cosine) - phase(number);
            let continued = unwrapped(-lag.to_degrees(), last[index]);
            last[index] = continued;
            [cosine.hypot(sine) * VOLTS[1] / VOLTS[0], continued]
        });
        Response {
            order: spacing * number as f64,
            twist: both[0],
            flap: both[1],
        }
    };
    Ok((1..=COUNTS[usize::from(all)]).map(curve).collect())
}

/// The phase p of a harmonic of the voltage, as in the file \[rad\].
fn phase(number: usize) -> f64 {
    (number * (number - 1) / 2) as f64 * std::f64::consts::PI / 12.0
}

/// The angle plus full turns that is nearest to another \[deg\].
fn unwrapped(angle: f64, near: f64) -> f64 {
    angle - 360.0 * ((angle - near) / 360.0).round()
}

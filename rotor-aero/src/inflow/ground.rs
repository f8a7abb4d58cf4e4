//! Ground effect on the induced velocity.
//!
//! ```text
//! l_ground / l = 1 - (R / 4 z)^2 / (1 + (mu / l)^2)
//! ```
//!
//! by the image of a source below the ground, at constant thrust ([Cheeseman1955]).

use crate::real::Real;

/// Height over R below which the theory does not apply; the factor stays constant there \[-\].
const LOWEST: f64 = 0.5;
/// Speed that rounds the quotient at no flow, over the tip speed \[-\].
const REST: f64 = 1e-5;

/// The factor of the induced velocity at a height of the rotor above the ground over R.
///
/// `advance` and `induced` are the advance ratio and the mean induced velocity over the tip speed,
/// without the ground.
pub fn ground_effect<T: Real>(height: T, advance: T, induced: T) -> T {
    by_square(height, advance, induced * induced)
}

/// The same by the thrust coefficient of a level rotor, whose mean induced velocity without the ground
/// is the one of uniform inflow in edgewise flow:
///
/// ```text
/// 2 l sqrt(mu^2 + l^2) = CT          l^2 = (sqrt(mu^4 + CT^2) - mu^2) / 2
/// ```
pub fn ground_effect_of_thrust<T: Real>(height: T, advance: T, thrust: T) -> T {
    let square = advance * advance;
    let size = (square * square + thrust * thrust + REST.powi(4)).sqrt();
    by_square(height, advance, (size - square) * 0.5)
}

fn by_square<T: Real>(height: T, advance: T, square: T) -> T {
    let height = if height.re() < LOWEST {
        T::from(LOWEST)
    } else {
        height
    };
    let square = square + REST * REST;
    let hover = square / (square + advance * advance);
    -hover / (height * height * 16.0) + 1.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// At a height of R in hover the factor is 15/16; at an advance ratio of the induced velocity the
    /// effect is half of it.
    #[test]
    fn both_forms_have_the_closed_values() {
        for (advance, part) in [(0.0f64, 1.0), (0.05, 0.5)] {
            let induced = 0.05f64;
            let thrust = 2.0 * induced * advance.hypot(induced);
            let expected = 1.0 - part / 16.0;
            assert!((ground_effect(1.0, advance, induced) - expected).abs() < 1e-8);
            assert!((ground_effect_of_thrust(1.0, advance, thrust) - expected).abs() < 1e-8);
        }
        // Without flow and thrust, and below half a radius.
        assert!((ground_effect_of_thrust(0.2f64, 0.0, 0.0) - 0.75).abs() < 1e-12);
    }
}

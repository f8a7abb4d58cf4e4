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
    let height = if height.re() < LOWEST {
        T::from(LOWEST)
    } else {
        height
    };
    let square = induced * induced + REST * REST;
    let hover = square / (square + advance * advance);
    -hover / (height * height * 16.0) + 1.0
}

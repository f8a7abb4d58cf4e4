//! Ground resonance of a rotor of three lagging blades.
//!
//! Source: `tests/reference/theory-periodic/stability.json`, boundaries of the equations of Coleman of
//! the same rotor in minimal coordinates by Brent's method, and its Floquet multipliers.

use beam_dynamics::result::{BoundaryKind, StableSide};

use super::{analyzed, assert_boundaries};
use crate::periodic::rotor::{ANISOTROPIC, EQUAL, ISOTROPIC, rotor};
use crate::trim::{numbers, reference};

const FLOQUET: &str = "[periodic]\nspeed = \"= om\"\nsteps = 64\n\
                       [parameters]\nom = 20\n";

fn over_speed(support: [f64; 4], [from, to]: [f64; 2], steps: usize) -> String {
    let model = rotor(support, &EQUAL, "= om*t", "om");
    format!(
        "{model}{FLOQUET}[stability]\nby = \"Floquet\"\nparameter = \"om\"\nfrom = {from:?}\n\
         to = {to:?}\nsteps = {steps}\n"
    )
}

// Two unstable bands. The errors of exponents in 64 steps of Radau IIA are below 2e-8 1/s, and the growth
// changes by 0.2 to 0.5 1/s for a rad/s.
#[test]
fn boundaries_of_an_anisotropic_support() {
    let exact = numbers(&reference("theory-periodic/stability.json")["boundary"]["all_8_60"]);
    let result = analyzed(&over_speed(ANISOTROPIC, [20.0, 44.0], 7));
    let sides = [StableSide::Below, StableSide::Above];
    let expected = exact.iter().enumerate();
    let expected = expected.map(|(k, at)| (*at, BoundaryKind::Flutter, sides[k % 2]));
    assert_boundaries(&result, &expected.collect::<Vec<_>>(), 1e-6);
    let requested = result.points.iter().filter(|own| own.is_requested);
    let counts: Vec<_> = requested.map(|own| own.unstable()).collect();
    assert_eq!(counts, [0, 0, 2, 0, 2, 2, 0]);
}

// Two values: the modes at 26 and 38 rad/s both grow, in different bands.
#[test]
fn a_second_band_is_found_between_coarse_values() {
    let result = analyzed(&over_speed(ANISOTROPIC, [26.0, 38.0], 2));
    assert_boundaries(
        &result,
        &[
            (29.922121428279212, BoundaryKind::Flutter, StableSide::Above),
            (33.73329957036614, BoundaryKind::Flutter, StableSide::Below),
        ],
        1e-6,
    );
}

// The modes of the turning frame and the multipliers lose their stability at the same speeds.
#[test]
fn modes_and_multipliers_have_the_same_boundaries() {
    let floquet = analyzed(&over_speed(ISOTROPIC, [20.0, 32.0], 3));
    let model = rotor(ISOTROPIC, &EQUAL, "= 0", "0");
    let modes = analyzed(&format!(
        "{model}[transient]\nto = 1\nstep = 1\n[modes]\nspeeds = [\"= om\"]\ncount = 5\n\
         [parameters]\nom = 20\n[stability]\nparameter = \"om\"\nvalues = [20, 26, 32]\n"
    ));
    assert_eq!(modes.boundaries.len(), 2, "{:#?}", modes.boundaries);
    let expected = modes.boundaries.iter();
    let expected: Vec<_> = expected.map(|own| (own.at, own.kind, own.stable)).collect();
    assert_boundaries(&floquet, &expected, 1e-6);
}

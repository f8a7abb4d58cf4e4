//! Ground resonance of a rotor of three lagging blades.
//!
//! Source: `tests/reference/theory-periodic/stability.json`, boundaries of the equations of Coleman of
//! the same rotor in minimal coordinates by Brent's method, and its Floquet multipliers.

use beam_dynamics::result::{BoundaryKind, StabilityRoot, StableSide};

use super::{analyzed, assert_boundaries};
use crate::effort::is_long;
use crate::periodic::rotor::{ANISOTROPIC, Blades, EQUAL, ISOTROPIC, rotor};
use crate::trim::{numbers, reference};

/// Steps of a revolution, and the distance of boundaries from the exact ones [rad/s]: the growth changes
/// by 0.2 to 0.5 1/s for a rad/s, and exponents are off by 2e-8 1/s in 64 steps.
const STEPS: usize = 64;
const WITHIN: f64 = 1e-6;

/// The rotor by multipliers, with the lines of the values.
fn over_speed(support: [f64; 4], values: &str) -> String {
    let model = rotor(support, &EQUAL, "= om*t", "om");
    format!(
        "{model}[periodic]\nspeed = \"= om\"\nsteps = {STEPS}\n[parameters]\nom = 20\n\
         [stability]\nby = \"Floquet\"\nparameter = \"om\"\ntolerance = 1e-8\n{values}\n"
    )
}

// Growth and frequency of each pair at one value, 26 rad/s, up to whole numbers of speeds: on isotropic and
// anisotropic supports, and without one damper. The prototype has exponents to 1e-7. With 48 steps they are off by
// 1.2e-6 here, which falls with the fifth power of the steps: 64 have 3e-7. The branches of the prototype are the ones of
// multiblade coordinates, which bodies on hinges have not here.
#[test]
fn pairs_have_their_exponents_at_one_value() {
    let one_off = Blades {
        dampers: [400.0, 400.0, 0.0],
        ..EQUAL
    };
    let models = [
        (ISOTROPIC, EQUAL),
        (ANISOTROPIC, EQUAL),
        (ANISOTROPIC, one_off),
    ];
    let published = reference("theory-periodic/stability.json");
    for (k, (support, blades)) in models.iter().enumerate() {
        let model = rotor(*support, blades, "= om*t", "om");
        let result = analyzed(&format!(
            "{model}[periodic]\nspeed = \"= om\"\nsteps = {STEPS}\n[parameters]\nom = 20\n\
             [stability]\nby = \"Floquet\"\nparameter = \"om\"\ncount = 10\nvalues = [26]\n"
        ));
        assert!(result.boundaries.is_empty());
        let roots = &result.points[0].roots;
        let rows = published["branch"][k]["modes"].as_array().unwrap();
        let rows = rows.iter().map(|row| {
            let row = row.as_array().unwrap();
            [0, 1].map(|i| row[i].as_f64().unwrap())
        });
        let pairs: Vec<_> = rows.filter(|row| row[1] > 0.0).collect();
        assert_eq!([roots.len(), pairs.len()], [5, 5]);
        for [growth, frequency] in pairs {
            // The frequency of another branch is a whole number of speeds away, or of the conjugate.
            let apart = |difference: f64| difference - 26.0 * (difference / 26.0).round();
            let off = |own: &StabilityRoot| {
                let [same, conjugate] =
                    [1.0, -1.0].map(|sign| apart(own.frequency() - sign * frequency));
                (own.growth() - growth).hypot(same.abs().min(conjugate.abs()))
            };
            let nearest = roots
                .iter()
                .min_by(|a, b| off(a).total_cmp(&off(b)))
                .unwrap();
            assert!(
                off(nearest) < 1e-6,
                "{k}: {growth} {frequency}, {:e}",
                off(nearest)
            );
        }
    }
}

// Two unstable bands, the first boundary in the short form. The second band is also found between two
// values at which modes of different bands grow.
#[test]
fn boundaries_of_an_anisotropic_support() {
    let exact = numbers(&reference("theory-periodic/stability.json")["boundary"]["all_8_60"]);
    let sides = [StableSide::Below, StableSide::Above];
    let expected = exact.iter().enumerate();
    let expected: Vec<_> = expected
        .map(|(k, at)| (*at, BoundaryKind::Flutter, sides[k % 2]))
        .collect();
    let all = [
        ("values = [24.22, 24.24]", &expected[..1]),
        ("from = 20\nto = 44\nsteps = 7", &expected[..]),
        ("values = [26, 38]", &expected[1..3]),
    ];
    let count = if is_long() { all.len() } else { 1 };
    for (values, expected) in &all[..count] {
        let result = analyzed(&over_speed(ANISOTROPIC, values));
        assert_boundaries(&result, expected, WITHIN);
    }
}

// The multipliers are on the unit circle at the speeds at which modes of the turning frame lose their
// stability.
#[test]
fn modes_and_multipliers_have_the_same_boundaries() {
    let model = rotor(ISOTROPIC, &EQUAL, "= 0", "0");
    let modes = analyzed(&format!(
        "{model}[transient]\nto = 1\nstep = 1\n[modes]\nspeeds = [\"= om\"]\ncount = 5\n\
         [parameters]\nom = 20\n[stability]\nparameter = \"om\"\nvalues = [20, 26, 32]\n"
    ));
    let speeds: Vec<_> = modes.boundaries.iter().map(|own| own.at).collect();
    assert_eq!(speeds.len(), 2, "{:#?}", modes.boundaries);
    let values = format!("values = {speeds:?}\nboundaries = false");
    let floquet = analyzed(&over_speed(ISOTROPIC, &values));
    for point in &floquet.points {
        let growth = point.roots[0].growth();
        assert!(growth.abs() < WITHIN, "{}: {growth:e}", point.at);
    }
}

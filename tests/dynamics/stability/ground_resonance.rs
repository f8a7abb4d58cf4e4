//! Hammond's rotor, from `cases/dynamics/ground_resonance`.
//!
//! Source: C. E. Hammond, An application of Floquet theory to prediction of mechanical instability,
//! Journal of the American Helicopter Society 19(4), 1974: data of the rotor. Boundaries and growth by an
//! independent program (equations in minimal coordinates, Floquet multipliers), of five and three digits.

use beam_dynamics::analysis::stability::stability;
use beam_dynamics::input;
use beam_dynamics::result::{BoundaryKind, StabilityResult, StableSide};

use super::assert_boundaries;
use crate::effort::is_long;

/// The case with the damper of the last blade times a factor, at these values.
fn case(factor: f64, values: &str) -> StabilityResult {
    let folder = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/cases/dynamics/ground_resonance"
    );
    let path = format!("{folder}/ground_resonance.dynamics.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    let mut text = text.replace("last = 0 ", &format!("last = {factor:?} "));
    if !is_long() {
        text = text.replace("steps = 48", "steps = 24");
    }
    let start = text.find("from = 100").unwrap();
    let end = start
        + text[start..]
            .find("boundaries")
            .map_or(text.len() - start, |at| at);
    let text = format!("{}{values}\n{}", &text[..start], &text[end..]);
    let read = |given: &[(String, f64)]| input::parse_with(&text, &path, given);
    let parsed = read(&[]).unwrap_or_else(|problems| panic!("{problems}"));
    stability("rotor", parsed.stability.as_ref().unwrap(), None, &read)
}

// Boundaries of the case within the rounding of the list, found in the long form; and the largest
// growth, at 250 rpm.
#[test]
fn one_damper_is_inoperative() {
    let all = [
        (210.37, BoundaryKind::Flutter, StableSide::Below),
        (307.08, BoundaryKind::Flutter, StableSide::Above),
    ];
    if is_long() {
        let result = case(0.0, "values = [180, 250, 330]");
        assert!(result.failures.is_empty(), "{:?}", result.failures);
        assert_boundaries(&result, &all, 6e-3);
    }
    // The first boundary is between these values.
    let result = case(0.0, "values = [210.36, 210.38]\nboundaries = false");
    let unstable: Vec<_> = result.points.iter().map(|own| own.unstable()).collect();
    assert_eq!(unstable, [0, 2]);
    let largest = case(0.0, "values = [250, 260]").points[0].roots[0].growth();
    assert!((largest - 0.322).abs() < 6e-4, "{largest}");
}

#[test]
fn all_dampers_act() {
    let all = [
        (250.0, -0.330),
        (100.0, -1.871),
        (200.0, -0.992),
        (300.0, -0.735),
        (400.0, -1.315),
    ];
    let count = if is_long() { all.len() } else { 1 };
    for (rpm, expected) in &all[..count] {
        let result = case(1.0, &format!("values = [{rpm}, {}]", rpm + 5.0));
        assert_boundaries(&result, &[], 0.0);
        let found = result.points[0].roots[0].growth();
        // The list has three digits.
        assert!(
            (found - expected).abs() < 1.5e-3,
            "{rpm} {found} {expected}"
        );
    }
}

/// Four blades on lag hinges with nearly rigid beams, on a mast with springs.
const RIGID: &str = "units = { length = \"m\", force = \"N\", angle = \"rad\", rotation_speed = \"rad/s\" }\n\
    [properties.spar]\nea = 5e9\ngay = 5e9\ngaz = 5e9\ngj = 1e8\neiy = 1e9\neiz = 1e9\nm = 13\n\
    iy = 1e-6\niz = 1e-6\n[parameters]\nspeed = 26\n\
    [[node]]\nname = \"mast\"\nposition = [0, 0, 0]\n\
    [[body]]\nname = \"mast\"\nnode = \"mast\"\nmass = 3000\ninertia = [1000, 1000, 1000]\n\
    [[joint]]\nname = \"guide\"\nkind = \"total\"\nnodes = [\"mast\"]\n\
    locked = [\"z\", \"about x\", \"about y\", \"about z\"]\n\
    [[spring]]\nname = \"gear\"\nnode = \"mast\"\nstiffness = [1.2e6, 1.2e6, 0]\ndamping = [12e3, 12e3, 0]\n\
    [[rotor]]\nname = \"r\"\nhub = \"hingeless\"\nnode = \"mast\"\nblades = 4\nspeed = \"= speed\"\n\
    mass = 500\ninertia = [50, 50, 100]\n\
    [rotor.blade]\nhub_radius = 0.4\nproperties = \"spar\"\npiece = [{ length = 7.8, elements = 1 }]\n\
    [[rotor.hinge]]\nkind = \"lag\"\noffset = 0.4\ndamping = 2000\nstiffness = 0\n\
    [periodic]\nsteps = 24\n\
    [stability]\nby = \"averaged\"\nparameter = \"speed\"\nvalues = [20, 26]\nboundaries = false\n";

// Coleman's equations of rigid blades [ColemanFeingold1958] in complex coordinates: with the mass M of all, the static
// moment S and the inertia I of a blade about its hinge at e,
// (M s^2 + c s + k) (I (s - i W)^2 + c_l (s - i W) + e S W^2) = (N/2) S^2 s^4. The beams bend: their
// first bending has 60 times the frequency of the lag, whose square, 2.5e-4, bounds the change of a root.
#[test]
fn nearly_rigid_blades_are_equal_and_have_the_roots_of_coleman() {
    use nalgebra::Complex;
    let read = |given: &[(String, f64)]| input::parse_with(RIGID, "rigid.dynamics.toml", given);
    let parsed = read(&[]).unwrap_or_else(|problems| panic!("{problems}"));
    let result = stability("rotor", parsed.stability.as_ref().unwrap(), None, &read);
    assert!(result.failures.is_empty(), "{:?}", result.failures);
    let (length, offset, mass) = (7.8, 0.4, 13.0);
    let [static_moment, inertia] = [
        mass * length * length / 2.0,
        mass * f64::powi(length, 3) / 3.0,
    ];
    let total = 3000.0 + 500.0 + 4.0 * mass * length;
    for (point, speed) in result.points.iter().zip([20.0, 26.0]) {
        let polynomial = |s: Complex<f64>| {
            let turned = s - Complex::new(0.0, speed);
            let support = s * s * total + s * 12e3 + 1.2e6;
            let lag =
                turned * turned * inertia + turned * 2e3 + offset * static_moment * speed * speed;
            support * lag - s.powi(4) * 2.0 * static_moment * static_moment
        };
        let off = |s: Complex<f64>| {
            let h = 1e-5 * s.norm();
            (polynomial(s) * 2.0 * h / (polynomial(s + h) - polynomial(s - h))).norm() / s.norm()
        };
        let unstable: Vec<_> = point
            .roots
            .iter()
            .filter(|root| root.growth() > 0.1)
            .collect();
        assert_eq!(unstable.len(), 1, "{:?}", point.roots);
        let own = unstable[0].exponent;
        let least = off(own).min(off(own.conj()));
        assert!(least < 2.5e-4, "{speed} {own} {least:e}");
    }
}

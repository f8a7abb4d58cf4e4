//! Tilt of teetering and gimballed hubs by cyclic pitch.

use beam_dynamics::result::Harmonics;
use nalgebra::Complex;

use super::{ROOT, TIP, inertia, over_period, parsed, rotor};

/// Speed \[rad/s\]: 300 rpm.
const OMEGA: f64 = 10.0 * std::f64::consts::PI;
/// Chord \[m\], so narrow that the velocity of pitching does not count.
const CHORD: f64 = 1e-4;
/// Slope of lift \[1/rad\].
const SLOPE: f64 = 6.0;
/// Cyclic pitch, cosine and sine \[deg\].
const CYCLIC: [f64; 2] = [0.08, -0.05];

/// A rotor in hover without thrust with the damping `n` of the flapping per radian of azimuth.
fn text(kind: &str, (n, stiffness, delta_3): (f64, f64, f64)) -> String {
    let blades = if kind == "teetering" { 2 } else { 3 };
    let link = if kind == "teetering" {
        ""
    } else {
        "link = 0.1\n"
    };
    let keys = format!(
        "speed = 300\n{link}[rotor.tilt]\nstiffness = {stiffness:?}\n[rotor.swashplate]\n\
         cosine = {:?}\nsine = {:?}\n[rotor.pitch_link]\nstiffness = 1e5\ndelta_3 = {delta_3:?}\n",
        CYCLIC[0], CYCLIC[1]
    );
    // n = rho a c A / (2 I) with A the integral of r^3.
    let third = 0.25 * (TIP.powi(4) - ROOT.powi(4));
    let density = 2.0 * n * inertia() / (SLOPE * CHORD * third);
    let cards = format!(
        "[rotor.blade.aerodynamics]\nsection = \"quasi_steady\"\nstrips = 4\nstations = [\n\
         {{ at = 0, chord = {CHORD:?}, airfoil = \"line\" }},\n\
         {{ at = 1, chord = {CHORD:?}, airfoil = \"line\" }},\n]\n\
         [airfoils.line]\nslope = {SLOPE:?}\ndrag = 0\n[air]\ndensity = {density:?}\n\
         [periodic]\nspeed = 300\nsteps = 12\n[output]\n[[output.column]]\nname = \"z\"\n\
         quantity = \"position\"\nof = \"r 1/tip\"\ncomponent = \"z\"\n"
    );
    rotor(kind, blades, &keys, &cards)
}

// In axes that turn, a rigid rotor without offset of its flapping axis has, per radian of azimuth, with the part
// k = K / (I_r Omega^2) of the spring on the moment of inertia I_r about a diameter,
//
//     b'' + n b' + (1 + k + n tan(delta_3)) b = n (theta_c cos psi + theta_s sin psi)
//
// so that b = theta / (tan(delta_3) + k / n + i) in complex amplitudes: without spring the flapping follows the
// pitch by 90 deg - delta_3 with cos(delta_3) of its size, whatever the damping n. The velocity of pitching at the
// chord's three quarters is 1e-4 of the incidence, and the blades bend by 1e-4.
#[test]
fn tilts_follow_cyclic_pitch_by_the_angle_of_precession() {
    for (kind, part) in [("teetering", 2.0), ("gimballed", 1.5)] {
        for (n, stiffness, delta_3) in [
            (0.8, 0.0, 0.0),
            (0.8, 0.0, 30.0),
            (1.5, 0.0, -15.0),
            (0.8, 600.0, 20.0),
        ] {
            let input = parsed(&text(kind, (n, stiffness, delta_3)));
            let rows = over_period(&input);
            let angles: Vec<_> = rows.column(0).iter().map(|z| (z / TIP).asin()).collect();
            let found = Harmonics::of(&angles, 3);
            let k = stiffness / (part * inertia() * OMEGA * OMEGA);
            let [cosine, sine] = CYCLIC.map(f64::to_radians);
            let pitch = Complex::new(cosine, -sine);
            let tangent = delta_3.to_radians().tan();
            let expected = pitch / Complex::new(tangent + k / n, 1.0);
            let [cosine, sine] = found.parts[0];
            let off = (Complex::new(cosine, -sine) / expected - 1.0).norm();
            assert!(off < 5e-4, "{kind} {n} {stiffness} {delta_3}: {off:e}");
            if stiffness == 0.0 {
                let ratio = pitch / Complex::new(cosine, -sine);
                let lag = ratio.arg().to_degrees();
                assert!((lag - (90.0 - delta_3)).abs() < 0.03, "{kind}: {lag}");
                let size = ratio.norm() * delta_3.to_radians().cos();
                assert!((size - 1.0).abs() < 5e-4, "{kind}: {size}");
            }
            let rest = found.mean.abs() + found.parts[1][0].hypot(found.parts[1][1]);
            assert!(rest < 1e-5 * expected.norm(), "{kind} {delta_3}: {rest:e}");
        }
    }
}

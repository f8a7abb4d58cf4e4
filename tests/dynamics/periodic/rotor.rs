//! A hub on springs with three lagging blades: ground resonance.
//!
//! Source: exponents of the ordinary differential equations of the same rotor in minimal coordinates
//! by an independent integration (relative tolerance 1e-11), Hammond's model: three blades of 40 kg,
//! static moment 96 kg m and moment of inertia 300 kg m^2 about hinges at 0.35 m, hub of 3200 kg.

use std::f64::consts::TAU;

use beam_dynamics::analysis::modes::modes as frame_modes;
use nalgebra::Complex;

use super::{analyzed, farthest, modes, multipliers};
use crate::effort::is_long;
use crate::trim::{numbers, reference};

/// Masses of the blades, their lag dampers, and their lag springs [kg, N m s, N m].
#[derive(Clone, Copy)]
pub struct Blades {
    pub masses: [f64; 3],
    pub dampers: [f64; 3],
    pub springs: [f64; 3],
}

pub const EQUAL: Blades = Blades {
    masses: [40.0; 3],
    dampers: [400.0; 3],
    springs: [0.0; 3],
};
pub const ISOTROPIC: [f64; 4] = [1.1e6, 1.1e6, 3000.0, 3000.0];
pub const ANISOTROPIC: [f64; 4] = [1.1e6, 2.0e6, 3000.0, 3800.0];

/// The rotor with the speed of an expression, zero in the axes of the cards; `angle` is the prescribed
/// rotation of the hub.
pub fn rotor([kx, ky, cx, cy]: [f64; 4], blades: &Blades, angle: &str, speed: &str) -> String {
    // The frame of a run in time does not turn, the frame of the modes does.
    let fixed = if speed == "0" { "world" } else { "frame" };
    let mut text = format!(
        "[[node]]\nname = \"mast\"\nposition = [0, 0, 0]\n\
         [[node]]\nname = \"hub\"\nposition = [0, 0, 0]\nangular_velocity = [0, 0, \"= {speed}\"]\n\
         [[body]]\nname = \"mast\"\nnode = \"mast\"\nmass = 3199\ninertia = [9, 9, 9]\n\
         [[body]]\nname = \"hub\"\nnode = \"hub\"\nmass = 1\ninertia = [1, 1, 1]\n\
         [[joint]]\nname = \"support\"\nkind = \"total\"\nnodes = [\"mast\"]\n\
         locked = [\"z\", \"about x\", \"about y\", \"about z\"]\n\
         [[joint]]\nname = \"shaft\"\nkind = \"revolute\"\nnodes = [\"mast\", \"hub\"]\n\
         axis = [0, 0, 1]\nangle = \"{angle}\"\n\
         [[spring]]\nname = \"tower\"\nnode = \"mast\"\nfixed_to = \"{fixed}\"\n\
         stiffness = [{kx:?}, {ky:?}, 0]\ndamping = [{cx:?}, {cy:?}, 0]\n"
    );
    for k in 0..3 {
        let (y, x) = (TAU * k as f64 / 3.0).sin_cos();
        let (mass, damper, spring) = (blades.masses[k], blades.dampers[k], blades.springs[k]);
        // In proportion to the mass: 300 kg m^2 about the hinge, 2.4 m from the center, of 40 kg.
        let inertia = mass * (300.0 / 40.0 - 2.4 * 2.4);
        let (name, hinge, center) = (format!("blade {k}"), 0.35, 2.75);
        text += &format!(
            "[[node]]\nname = \"{name}\"\nposition = [{:?}, {:?}, 0]\n\
             velocity = [\"= {:?}*{speed}\", \"= {:?}*{speed}\", 0]\nangular_velocity = [0, 0, \"= {speed}\"]\n\
             [[body]]\nname = \"{name}\"\nnode = \"{name}\"\nmass = {mass:?}\n\
             inertia = [{inertia:?}, {inertia:?}, {inertia:?}]\n\
             [[joint]]\nname = \"lag {k}\"\nkind = \"revolute\"\nnodes = [\"hub\", \"{name}\"]\n\
             at = [{:?}, {:?}, 0]\naxis = [0, 0, 1]\n\
             [[spring]]\nname = \"damper {k}\"\nnodes = [\"hub\", \"{name}\"]\n\
             at = [{:?}, {:?}, 0]\nrotational_damping = [0, 0, {damper:?}]\n\
             rotational_stiffness = [0, 0, {spring:?}]\n",
            center * x,
            center * y,
            -center * y,
            center * x,
            hinge * x,
            hinge * y,
            hinge * x,
            hinge * y,
        );
    }
    text
}

pub fn turning(support: [f64; 4], blades: &Blades, speed: f64, settings: &str) -> String {
    let text = rotor(
        support,
        blades,
        &format!("= {speed:?}*t"),
        &format!("{speed:?}"),
    );
    format!("{text}[periodic]\nspeed = {speed:?}\n{settings}")
}

/// Exponents `[re, im]` of one of each pair.
fn multipliers_of(exponents: &[[f64; 2]], speed: f64) -> Vec<Complex<f64>> {
    let period = TAU / speed;
    let mu = |[re, im]: &[f64; 2]| (Complex::new(*re, *im) * period).exp();
    exponents
        .iter()
        .flat_map(|s| [mu(s), mu(s).conj()])
        .collect()
}

/// Exponents `[re, im]` of a reference, both of each pair, as multipliers.
fn listed(exponents: &serde_json::Value, speed: f64) -> Vec<Complex<f64>> {
    let pairs = exponents.as_array().unwrap().iter().map(numbers);
    let mu = |own: Vec<f64>| (Complex::new(own[0], own[1]) * (TAU / speed)).exp();
    pairs.map(mu).collect()
}

// All ten exponents of three rotors at 12 to 40 rad/s to 1e-6 (`theory-periodic/rotor_exponents.json`).
// The short form has three rows, one of each rotor.
#[test]
fn all_exponents_over_speed() {
    let open = Blades {
        dampers: [400.0, 400.0, 0.0],
        ..EQUAL
    };
    let rows = reference("theory-periodic/rotor_exponents.json")["rows"].clone();
    let (mut count, short) = (
        0,
        [
            ("isotropic", 12.0),
            ("anisotropic", 26.0),
            ("dissimilar_damper", 40.0),
        ],
    );
    for row in rows.as_array().unwrap() {
        let (case, speed) = (
            row["case"].as_str().unwrap(),
            row["Omega"].as_f64().unwrap(),
        );
        if !is_long() && !short.contains(&(case, speed)) {
            continue;
        }
        let (support, blades) = match case {
            "isotropic" => (ISOTROPIC, EQUAL),
            "anisotropic" => (ANISOTROPIC, EQUAL),
            _ => (ANISOTROPIC, open),
        };
        let settings = "[periodic.floquet]\nerror_estimate = false\n";
        let (outcome, _) = analyzed(&turning(support, &blades, speed, settings));
        let expected = listed(&row["exponents_ode"], speed);
        let off = farthest(&multipliers(&outcome), &expected);
        assert!(off < 1e-6 * TAU / speed, "{case} {speed}: {off:e}");
        let table = outcome.result.floquet.as_ref().unwrap();
        assert!(table.states.is_some() && table.products <= 20, "{table:?}");
        // Five freedoms: no root beyond their ten, of twenty that are requested.
        assert_eq!(multipliers(&outcome).len(), 10, "{table:?}");
        for mode in modes(&outcome) {
            assert!(mode.residual < 1e-9, "{mode:?}");
        }
        count += 1;
    }
    assert_eq!(count, if is_long() { 15 } else { 3 });
}

// The modes in the turning frame and the multipliers of a revolution: exp(s T), to 1e-6 of s. In the
// turning frame the frequencies differ by multiples of the speed. The short form has the unstable speed.
#[test]
fn modes_and_multipliers_of_an_isotropic_hub_are_the_same() {
    let count = if is_long() { 3 } else { 1 };
    for speed in [26.0, 20.0, 12.0].into_iter().take(count) {
        let settings = "[periodic.floquet]\nerror_estimate = false\n";
        let (outcome, _) = analyzed(&turning(ISOTROPIC, &EQUAL, speed, settings));
        let text = format!(
            "[units]\nangle = \"rad\"\nrotation_speed = \"rad/s\"\n{}[transient]\nto = 1\nstep = 1\n\
             [modes]\nspeeds = [{speed:?}]\ncount = 5\n",
            rotor(ISOTROPIC, &EQUAL, "= 0", "0")
        );
        let input = beam_dynamics::input::parse(&text, "rotor.dynamics.toml")
            .unwrap_or_else(|problems| panic!("{problems}"));
        let table = frame_modes(&input.model, input.modes.as_ref().unwrap()).table;
        let exponents = table.branches.iter().map(|branch| {
            let point = branch.points[0].as_ref().unwrap();
            let (frequency, ratio) = (TAU * point.frequency, point.damping_ratio);
            let growth = -ratio * frequency / (1.0 - ratio * ratio).sqrt();
            [growth, frequency]
        });
        let exponents: Vec<_> = exponents.collect();
        assert_eq!(exponents.len(), 5);
        let expected = multipliers_of(&exponents, speed);
        let off = farthest(&multipliers(&outcome), &expected);
        assert!(off < 1e-6 * TAU / speed, "{speed}: {off:e}");
    }
}

// Gravity in the plane of the rotor, unequal blades (`theory-periodic/shooting_rotor.json`): all ten
// exponents to 1e-6, in at most five iterations of eleven products. The
// second motion is unstable, no march leads to it; the third would take 2500 revolutions. The short form
// has the second.
#[test]
fn unequal_blades_under_gravity() {
    let all = reference("theory-periodic/shooting_rotor.json");
    let names = ["light_lag_damping", "dissimilar", "lag_damping_low_stable"];
    let count = if is_long() { 3 } else { 1 };
    for name in names.into_iter().take(count) {
        let it = &all[name];
        let own = |key: &str| numbers(&it["blades"][key]).try_into().unwrap();
        let blades = Blades {
            masses: own("mb"),
            dampers: own("cz"),
            springs: it["blades"].get("kz").map_or([0.0; 3], |_| own("kz")),
        };
        let of = |key: &str| it["parameters"][key].as_f64().unwrap();
        let support = [of("kx"), of("ky"), of("cx"), of("cy")];
        let speed = it["Omega"].as_f64().unwrap();
        let settings = "[periodic.floquet]\nerror_estimate = false\n\
                        [gravity]\nacceleration = [0, -9.81, 0]\n";
        let (outcome, _) = analyzed(&turning(support, &blades, speed, settings));
        let passes = &outcome.result.passes;
        assert!(passes.len() <= 5, "{passes:#?}");
        assert!(passes.iter().all(|pass| pass.products <= 12), "{passes:#?}");
        let off = farthest(&multipliers(&outcome), &listed(&it["exponents_ode"], speed));
        assert!(off < 1e-6 * TAU / speed, "{name}: {off:e}");
    }
}

// Weak dampers: an unstable periodic motion, to which no march leads.
#[test]
fn an_unstable_periodic_motion() {
    let blades = Blades {
        masses: [40.0; 3],
        dampers: [20.0; 3],
        ..EQUAL
    };
    let settings = "[periodic.floquet]\nerror_estimate = false\n\
                    [gravity]\nacceleration = [0, -9.81, 0]\n";
    let (outcome, _) = analyzed(&turning(ISOTROPIC, &blades, 26.0, settings));
    assert!(
        outcome.result.passes.len() <= 5,
        "{:#?}",
        outcome.result.passes
    );
    assert_eq!(modes(&outcome)[0].stability().word(), "unstable");
}

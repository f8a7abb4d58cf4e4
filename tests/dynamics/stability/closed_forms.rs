//! Boundaries that are known in closed form.

use beam_dynamics::result::{BoundaryKind, StableSide};

use super::{analyzed, assert_boundaries};
use crate::periodic::mathieu::bar_of;
use crate::trim::reference;

// Abramowitz, Stegun, Handbook of Mathematical Functions, 20.2.25: a_1(q), and b_1(q) = a_1(-q), of
// x'' + (a - 2 q cos 2 tau) x = 0; with t = 2 tau, delta = a/4 and epsilon = -q/2. The next terms are
// below 1e-8 at q = 0.4.
fn first_tongue(q: f64) -> f64 {
    let factors = [
        1.0,
        1.0,
        -1.0 / 8.0,
        -1.0 / 64.0,
        -1.0 / 1536.0,
        11.0 / 36864.0,
        49.0 / 589_824.0,
        55.0 / 9_437_184.0,
        -83.0 / 35_389_440.0,
    ];
    0.25 * factors
        .iter()
        .rev()
        .fold(0.0, |sum, factor| sum * q + factor)
}

// No damping: the growth is zero up to the boundary, and a square root beyond it. The errors of 128
// steps shift it by less than 1e-8.
#[test]
fn the_first_tongue_of_the_equation_of_mathieu() {
    let settings = "steps = 128\n[parameters]\ndelta = 0.1\n[stability]\nby = \"Floquet\"\n\
                    parameter = \"delta\"\nfrom = 0.1\nto = 0.4\nsteps = 4\n";
    let result = analyzed(&bar_of("delta", 0.2, settings));
    assert_boundaries(
        &result,
        &[
            (
                first_tongue(-0.4),
                BoundaryKind::HalfRate,
                StableSide::Below,
            ),
            (first_tongue(0.4), BoundaryKind::HalfRate, StableSide::Above),
        ],
        1e-7,
    );
}

// Characteristic values of Mathieu functions at epsilon = 0.5 (`theory-periodic/mathieu.json`), where
// both multipliers are one.
#[test]
fn the_second_tongue_of_the_equation_of_mathieu() {
    let tables = reference("theory-periodic/mathieu.json")["boundaries"].clone();
    let is_half = |table: &&serde_json::Value| table["epsilon"].as_f64() == Some(0.5);
    let table = tables.as_array().unwrap().iter().find(is_half).unwrap();
    let [lower, upper] = ["b2", "a2"].map(|name| table["boundaries_delta"][name].as_f64().unwrap());
    let settings = "steps = 128\n[parameters]\ndelta = 0.1\n[stability]\nby = \"Floquet\"\n\
                    parameter = \"delta\"\nfrom = 0.85\nto = 1.3\nsteps = 4\n";
    let result = analyzed(&bar_of("delta", 0.5, settings));
    assert_boundaries(
        &result,
        &[
            (lower, BoundaryKind::Divergence, StableSide::Below),
            (upper, BoundaryKind::Divergence, StableSide::Above),
        ],
        1e-7,
    );
}

/// A bar of mass one above its hinge, 0.5 m below its center, with a rotational spring `k` and a
/// damper; beside it a mass of 2 kg on springs of 50 N/m.
fn standing(settings: &str) -> String {
    format!(
        "[[node]]\nname = \"bar\"\nposition = [0, 0, 0.5]\n\
         [[body]]\nname = \"bar\"\nnode = \"bar\"\nmass = 1\ninertia = [0.5, 0.75, 0.5]\n\
         [[joint]]\nname = \"hinge\"\nkind = \"revolute\"\nnodes = [\"bar\"]\nat = [0, 0, 0]\n\
         axis = [0, 1, 0]\n\
         [[spring]]\nname = \"hold\"\nnode = \"bar\"\nstiffness = [0, 0, 0]\n\
         rotational_stiffness = [0, \"= k\", 0]\nrotational_damping = [0, 0.3, 0]\n\
         [[node]]\nname = \"mass\"\nposition = [1, 0, 0]\n\
         [[body]]\nname = \"mass\"\nnode = \"mass\"\nmass = 2\ninertia = [1, 1, 1]\n\
         [[spring]]\nname = \"spring\"\nnode = \"mass\"\nstiffness = [50, 70, 90]\n\
         rotational_stiffness = [3, 4, 5]\ndamping = [4, 4, 4]\nrotational_damping = [1, 1, 1]\n\
         [gravity]\nacceleration = [0, 0, -9.81]\n[parameters]\nk = 3\n{settings}"
    )
}

// I q'' + c q' + (k - m g l) q = 0: divergence at k = m g l. Below it the upright bar is unstable.
#[test]
fn divergence_of_a_standing_bar() {
    let text = standing(
        "[modes]\nspeeds = [0]\ncount = 7\n[stability]\nparameter = \"k\"\nfrom = 3\nto = 8\n\
         steps = 6\n",
    );
    let result = analyzed(&text);
    let expected = [(9.81 * 0.5, BoundaryKind::Divergence, StableSide::Above)];
    assert_boundaries(&result, &expected, 1e-7);
}

// The bar with k = 20 and a moment c q', which takes its damping away: I q'' + (0.3 - c) q' + .. = 0. The
// mass is pushed by the control of a trim to a place that depends on c.
#[test]
fn modes_of_a_trimmed_equilibrium() {
    let text = standing(
        "c = 0.1\n[sensors.rate]\nquantity = \"angular_velocity\"\nof = \"bar\"\ncomponent = \"y\"\n\
         unit = \"rad/s\"\n[[load]]\nnode = \"bar\"\nmoment = [0, 1, 0]\ndrive = \"= c*rate\"\n\
         [sensors.place]\nquantity = \"position\"\nof = \"mass\"\ncomponent = \"x\"\nunit = \"m\"\n\
         [[load]]\nnode = \"mass\"\nforce = [1, 0, 0]\ndrive = \"= push\"\n\
         [trim]\nmethod = \"equilibrium\"\n[[trim.control]]\nname = \"push\"\n\
         [[trim.target]]\nname = \"place\"\nsignal = \"place\"\nvalue = \"= 1 + c/10\"\n\
         [modes]\nspeeds = [0]\ncount = 7\n\
         [stability]\nparameter = \"c\"\nvalues = [0.1, 0.2, 0.4]\n",
    );
    let result = analyzed(&text.replace("\"= k\"", "20"));
    let expected = [(0.3, BoundaryKind::Flutter, StableSide::Below)];
    assert_boundaries(&result, &expected, 1e-7);
    // The place is 1 + c/10, 50 N/m times the distance of c/10 from the undeformed one.
    for point in &result.points {
        let expected = 5.0 * point.at;
        assert!((point.controls[0] - expected).abs() < 1e-9, "{point:?}");
    }
    // The mass on its spring is not held by the control: 2 s^2 + 4 s + 50 = 0.
    let frequency = (25.0_f64 - 1.0).sqrt();
    let is_it = |root: &beam_dynamics::result::StabilityRoot| {
        (root.growth() + 1.0).abs() < 1e-9 && (root.frequency() - frequency).abs() < 1e-9
    };
    assert!(
        result
            .points
            .iter()
            .all(|point| point.roots.iter().any(is_it))
    );
}

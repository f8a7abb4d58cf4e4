//! Rotors of several equal blades, from `cases/dynamics/four_blades`, compared with theory.
//!
//! For equal blades, equally spaced on a hub that is the same in all directions about the axis, the
//! motions decouple by the motion of blade k, `exp(-i h psi_k)` times the first (Coleman and
//! Feingold, NACA 1351; Johnson, *Helicopter Theory*, section 8.3): h = 0 moves the hub along and
//! about its axis only, h = +-1 across the axis and in tilt only, others not at all. The loads of N
//! blades on the hub add up to N for h = 0 and N/2 for h = +-1.

use std::f64::consts::TAU;

use beam_dynamics::result::FrequencyTable;

use crate::case_files::{Case, frequency};
use crate::record;

const ROTOR: &str = "rotor.dynamics.toml";
const SOURCE: &str = "Multiblade coordinates, the same blades in another rotor";

/// Values within 1e-6 of each other are treated as one multiple value; the names of their modes may
/// be exchanged.
const COPIES: f64 = 1e-6;
/// Round-off of the eigenvalues of two models of different size.
const ROUND_OFF: f64 = 1e-8;

fn case() -> Case {
    Case::new("four_blades")
}

/// The rotor of the case with other blades, hub and support.
struct Changed<'a> {
    blades: usize,
    /// Factor of mass, moments of inertia and springs of the hub.
    hub: f64,
    /// Springs of the hub; directions without one are held.
    support: &'a [(&'a str, f64)],
}

/// Springs of the case.
const SUPPORT: [(&str, f64); 4] = [
    ("in_plane", 2e6),
    ("axial", 1e6),
    ("tilt", 2e5),
    ("torsion", 4e5),
];

impl Changed<'_> {
    fn modes(&self, count: usize) -> FrequencyTable {
        self.of(&case(), count)
    }

    fn at_three_speeds(&self, count: usize) -> FrequencyTable {
        let case = case();
        case.replace(ROTOR, "steps = 9", "steps = 3");
        self.of(&case, count)
    }

    fn of(&self, case: &Case, count: usize) -> FrequencyTable {
        let springs: String = SUPPORT
            .iter()
            .map(|(word, k)| format!("{word} = {}\n", short(*k)))
            .collect();
        let wanted = self
            .support
            .iter()
            .map(|(word, k)| format!("{word} = {:e}\n", k * self.hub));
        case.replace(ROTOR, &springs, &wanted.collect::<String>());
        case.replace(ROTOR, "mass = 60", &format!("mass = {:e}", 60.0 * self.hub));
        let moments = [5.0, 5.0, 10.0]
            .map(|moment| format!("{:e}", moment * self.hub))
            .join(", ");
        case.replace(ROTOR, "[5, 5, 10]", &format!("[{moments}]"));
        case.replace(ROTOR, "count = 4", &format!("count = {}", self.blades));
        case.replace(ROTOR, "count = 24", &format!("count = {count}"));
        case.modes(ROTOR)
    }
}

/// As written in the file of the case, `2e6`.
fn short(number: f64) -> String {
    format!("{number:e}")
}

/// Frequencies at a speed of the modes whose blades move together as `harmonic`,
/// ascending \[Hz\].
fn with_harmonic(table: &FrequencyTable, speed: usize, harmonic: i32) -> Vec<f64> {
    let modes = table.at_speed(speed).into_iter();
    let like = modes.filter(|mode| mode.1.whirl.is_some_and(|whirl| whirl.harmonic == harmonic));
    like.map(|mode| mode.1.frequency).collect()
}

/// All frequencies at a speed, ascending \[Hz\].
fn all(table: &FrequencyTable, speed: usize) -> Vec<f64> {
    let modes = table.at_speed(speed).into_iter();
    modes.map(|mode| mode.1.frequency).collect()
}

/// Finds each of the first `count` of `expected` among all frequencies of `table` at a speed, and
/// at its index among the frequencies of a pattern of motion, `named`.
fn compare(
    case: &str,
    (table, speed): (&FrequencyTable, usize),
    named: &[f64],
    expected: &[f64],
    count: usize,
) {
    assert!(
        named.len() >= count && expected.len() >= count,
        "{case}: {named:?} {expected:?}"
    );
    let found = all(table, speed);
    for (k, (named, expected)) in named.iter().zip(expected).take(count).enumerate() {
        let apart = |f: &f64| (f / expected - 1.0).abs();
        let nearest = found.iter().min_by(|a, b| apart(a).total_cmp(&apart(b)));
        let nearest = nearest.unwrap();
        let error = apart(nearest);
        let quantity = format!("mode {} [Hz]", k + 1);
        record::value(
            SOURCE,
            case,
            &quantity,
            [*nearest, *expected],
            error,
            ROUND_OFF,
        );
        assert!(error < ROUND_OFF, "{case}, mode {k}: {found:?} {expected}");
        assert!(
            apart(named) < COPIES,
            "{case}, mode {k}: {named} {expected}"
        );
    }
}

/// On a rigid hub the blades are uncoupled: the fan of one blade, four times, as collective,
/// progressive, regressive and differential.
#[test]
fn a_rigid_hub_gives_the_fan_of_one_blade_four_times() {
    let case = case();
    let [one, four] =
        ["one_blade", "rigid_hub"].map(|name| case.modes(&format!("{name}.dynamics.toml")));
    assert_eq!((one.speeds.len(), &one.speeds), (9, &four.speeds));
    // The moments of straight blades are round-off, which is no loss of digits.
    assert_eq!(four.remarks, Vec::<String>::new());
    for speed in 0..9 {
        let single = all(&one, speed);
        for (k, found) in all(&four, speed).iter().take(24).enumerate() {
            assert!(
                (found / single[k / 4] - 1.0).abs() < ROUND_OFF,
                "{k} {found}"
            );
        }
        for harmonic in [-1, 0, 1, 2] {
            let way = with_harmonic(&four, speed, harmonic);
            compare("four blades, rigid hub", (&four, speed), &way, &single, 6);
        }
    }
    // A branch is one mode at all speeds, named by the blade's and the rotor's motion.
    for branch in &one.branches[..6] {
        for way in ["collective", "progressive", "regressive", "differential"] {
            let name = format!("{} {way}", branch.name);
            for speed in 0..9 {
                let [found, expected] =
                    [(&four, &name), (&one, &branch.name)].map(|(t, n)| frequency(t, n, speed));
                assert!((found / expected - 1.0).abs() < ROUND_OFF, "{name}");
            }
            let named = four.branches.iter().find(|branch| branch.name == name);
            for point in named.unwrap().points.iter().flatten() {
                let whirl = point.whirl.unwrap();
                assert_eq!(Some(whirl.harmonic), named.unwrap().harmonic, "{name}");
                assert!(whirl.share > 0.999, "{name} {}", whirl.share);
            }
        }
    }
}

/// Differential modes do not move the hub: they are the modes of one clamped blade, for any hub.
/// Collective modes are the modes of one blade on a quarter of the hub, which moves along and about
/// its axis.
#[test]
fn a_flexible_hub_leaves_differential_modes_and_quarters_for_collective_ones() {
    let case = case();
    let one = case.modes("one_blade.dynamics.toml");
    let rotor = case.modes(ROTOR);
    let quarter = Changed {
        blades: 1,
        hub: 0.25,
        support: &[SUPPORT[1], SUPPORT[3]],
    };
    let quarter = quarter.modes(8);
    for speed in 0..9 {
        let differential = with_harmonic(&rotor, speed, 2);
        compare(
            "four blades, flexible hub, differential",
            (&rotor, speed),
            &differential,
            &all(&one, speed),
            5,
        );
        let collective = with_harmonic(&rotor, speed, 0);
        compare(
            "four blades, flexible hub, collective",
            (&rotor, speed),
            &collective,
            &all(&quarter, speed),
            5,
        );
    }
    // The hub has an effect.
    let [hub, clamped] =
        [(&rotor, "lag 1 collective"), (&one, "lag 1")].map(|(t, name)| frequency(t, name, 0));
    assert!(hub < 0.9 * clamped);
}

/// Cyclic modes of three, four and five blades are the same on hubs of three, four and
/// five quarters.
#[test]
fn cyclic_modes_depend_on_the_hub_for_each_blade_alone() {
    let four = Changed {
        blades: 4,
        hub: 1.0,
        support: &SUPPORT,
    };
    let four = four.at_three_speeds(24);
    for blades in [3, 5] {
        let other = Changed {
            blades,
            hub: blades as f64 / 4.0,
            support: &SUPPORT,
        };
        let other = other.at_three_speeds(6 * blades);
        for speed in 0..3 {
            for (harmonic, word) in [(1, "progressive"), (-1, "regressive")] {
                let [found, expected] =
                    [&four, &other].map(|table| with_harmonic(table, speed, harmonic));
                let case = format!("four blades compared with {blades}, {word}");
                compare(&case, (&four, speed), &found, &expected, 4);
            }
        }
    }
}

/// At rest the modes in which the hub only moves along its axis or across it have a frequency
/// equation in closed form: the force that the root of a clamped Euler-Bernoulli beam requires for
/// a motion up and down with unit amplitude is
///
/// ```text
/// -E I beta^3 (sin b cosh b + cos b sinh b) / (1 + cos b cosh b),   b = beta L,  beta^4 = m omega^2 / E I
/// ```
///
/// so that `k - M omega^2` is balanced by four of them along the axis, and across it by two, in
/// lag, with two blades that move along as masses `m L` (E A is large).
#[test]
fn a_hub_at_rest_follows_the_frequency_equation() {
    let axial = slender();
    axial.replace(ROTOR, "in_plane = 2e6\n", "");
    axial.replace(ROTOR, "tilt = 2e5\ntorsion = 4e5\n", "");
    let across = slender();
    across.replace(ROTOR, "axial = 1e6\ntilt = 2e5\ntorsion = 4e5\n", "");
    // Bending stiffness, number of bending beams, number of beams that move along, spring,
    // harmonic.
    for (word, case, [ei, bent, along, spring], harmonic) in [
        ("axial", axial, [9e3, 4.0, 0.0, 1e6], 0),
        ("in plane", across, [1.2e5, 2.0, 2.0, 2e6], 1),
    ] {
        let equation = |hz: f64| frequency_equation(hz, [ei, bent, along, spring]);
        let found = with_harmonic(&case.modes(ROTOR), 0, harmonic);
        // Lag of the collective and flap of the cyclic modes are clamped and lie in between.
        for (k, expected) in roots(equation, 40.0).iter().take(3).enumerate() {
            let apart = |f: &f64| (f / expected - 1.0).abs();
            let nearest = found.iter().min_by(|a, b| apart(a).total_cmp(&apart(b)));
            let nearest = nearest.unwrap();
            record::value(
                "Euler-Bernoulli beams on a moving hub, closed form",
                "four blades at rest",
                &format!("{word}, mode {} [Hz]", k + 1),
                [*nearest, *expected],
                apart(nearest),
                1e-5,
            );
            assert!(apart(nearest) < 1e-5, "{word}: {expected} not in {found:?}");
        }
    }
}

/// Length of the slender blades, from the axis \[m\].
const LENGTH: f64 = 4.612;

/// The case at rest, its blades without rotatory inertia and hub radius, and with a high stiffness
/// in shear and extension: for frequencies up to 27 Hz the effect of shear is `E I k^2 / 2 G A`,
/// 2e-6 with k = 7.9 / L in lag, and of extension less than `(omega L)^2 m / 6 E A`, 5e-6. The
/// error of forty elements is about `(k h)^4 / 720`, less than either.
fn slender() -> Case {
    let case = case();
    for (old, new) in [
        ("ea = 1e8", "ea = 1e11"),
        ("gay = 3e7", "gay = 1e11"),
        ("gaz = 3e7", "gaz = 1e11"),
        ("gj = 5e3", "gj = 5e2"),
        ("iy = 0.002", "iy = 1e-6"),
        ("iz = 0.078", "iz = 1e-6"),
        ("elements = 6", "elements = 40"),
        ("count = 24", "count = 40"),
        ("hub_radius = 0.3", "hub_radius = 0"),
        ("speeds = { from = 0, to = 424, steps = 9 }", "speeds = [0]"),
    ] {
        case.replace(ROTOR, old, new);
    }
    case
}

/// The equation of the hub at a frequency, without poles.
fn frequency_equation(hz: f64, [ei, bent, along, spring]: [f64; 4]) -> f64 {
    let omega = TAU * hz;
    let beta = (5.5 * omega * omega / ei).powf(0.25);
    let b = beta * LENGTH;
    let (sin, cos) = b.sin_cos();
    let root = ei * beta.powi(3) * (sin * b.cosh() + cos * b.sinh());
    let mass = 60.0 + along * 5.5 * LENGTH;
    (spring - mass * omega * omega) * (1.0 + cos * b.cosh()) - bent * root
}

/// Zeros of a function below `to`, by sign changes on a fine grid and bisection.
fn roots(function: impl Fn(f64) -> f64, to: f64) -> Vec<f64> {
    let step = 1e-3;
    let mut roots = Vec::new();
    let mut low = step;
    while low < to {
        let (mut a, mut b) = (low, low + step);
        if function(a) * function(b) < 0.0 {
            for _ in 0..60 {
                let middle = 0.5 * (a + b);
                if function(a) * function(middle) < 0.0 {
                    b = middle
                } else {
                    a = middle
                }
            }
            roots.push(0.5 * (a + b));
        }
        low += step;
    }
    roots
}

/// Motions mostly of the hub are named by the pattern of the blades, each mode uniquely: at rest
/// motions along and about the axis are collective, motions across it a pair of both senses, pure
/// like all others.
#[test]
fn modes_of_the_hub_are_named_like_those_of_blades() {
    let table = Changed {
        blades: 4,
        hub: 1.0,
        support: &SUPPORT,
    }
    .modes(24);
    let names: Vec<_> = table.branches.iter().map(|branch| &branch.name).collect();
    for (k, name) in names.iter().enumerate() {
        assert!(!names[k + 1..].contains(name), "{names:?}");
    }
    let at_rest = table.at_speed(0);
    for (branch, mode) in at_rest.iter().take(24) {
        let whirl = mode.whirl.unwrap();
        // Round-off of vectors of copies, and the weight of the hub when they are separated.
        assert!(whirl.share > 1.0 - 1e-4, "{}: {whirl:?}", branch.name);
        assert_eq!(branch.harmonic, Some(whirl.harmonic), "{}", branch.name);
    }
    let count = |harmonic| {
        let of = |mode: &&(_, &beam_dynamics::result::ModePoint)| {
            mode.1.whirl.is_some_and(|whirl| whirl.harmonic == harmonic)
        };
        at_rest.iter().take(23).filter(of).count()
    };
    println!("{names:?}");
    assert!(count(1).abs_diff(count(-1)) <= 1, "{names:?}");
}

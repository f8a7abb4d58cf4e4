//! Modes with air that no search finds at a value of the parameter, continued from another value.

use std::f64::consts::TAU;

use beam_dynamics::analysis::linear::linearize;
use beam_dynamics::analysis::stability::stability;
use beam_dynamics::input::{self, LinearRequest};
use beam_dynamics::result::StabilityRoot;
use nalgebra::Complex;
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};

use crate::effort::{cases, is_long};
use crate::turbine_modes::{FILE, SPEED, over, root, text};

/// The rotor with blades of half the mass and a tenth of the bending stiffness or less.
fn light(section: &str, count: usize, stiffness: &str) -> String {
    let text = text("frozen", section).replace("count = 6", &format!("count = {count}"));
    text.replace("m = 10\niy = 0.2\niz = 1", "m = 5\niy = 0.06\niz = 0.3")
        .replace("eiy = 3e5", &format!("eiy = {stiffness}"))
}

/// All eigenvalues of the rotor in turning axes at a density, by the linear model of its states.
fn eigenvalues(text: &str, density: f64) -> Vec<Complex<f64>> {
    let text = format!(
        "{text}[[load]]\nnode = \"blade 1/tip\"\nforce = [0, 0, 1]\ndrive = \"push\"\n\
         [drives.push]\nkind = \"constant\"\nvalue = 0\n[sensors.thrust]\nquantity = \"thrust\"\n\
         of = \"rotor\"\n"
    );
    let owned = |name: &str| vec![name.to_owned()];
    let request = LinearRequest {
        inputs: owned("push"),
        outputs: owned("thrust"),
        speed: Some(SPEED),
        about: None,
    };
    let read = |given: &[(String, f64)]| input::parse_linear(&text, FILE, &request, given);
    let input = read(&[("density".to_owned(), density)]);
    let input = input.unwrap_or_else(|problems| panic!("{problems}"));
    let found = linearize(&input, &read);
    found
        .unwrap_or_else(|failure| panic!("{failure}"))
        .eigenvalues
}

/// The distance of a root from the nearest eigenvalue, relative to its size.
fn distance(all: &[Complex<f64>], root: Complex<f64>) -> f64 {
    let off = all.iter().map(|other| (other - root).norm());
    off.fold(f64::INFINITY, f64::min) / root.norm()
}

const FLAP: [&str; 3] = ["flap 1 backward", "flap 1 collective", "flap 1 forward"];

// Every oscillation of the complete linear model is found, at one value alone: flexible and light to stiff and heavy
// blades of each section model with states, in thin to dense air. The eigenvalues below 0.95 of the critical
// damping and the size of the highest listed one are all among the roots: to 1e-3, as the equilibria begin at other
// states.
#[test]
fn no_oscillation_is_lost() {
    let mut random = Pcg64Mcg::seed_from_u64(29);
    let mut missed = Vec::new();
    for case in 0..cases(6) {
        let mut draw = |from: f64, to: f64| {
            let part = f64::from(random.next_u32()) / f64::from(u32::MAX);
            from * (to / from).powf(part)
        };
        let section = ["hgm", "separation_lag"][case % 2];
        let (density, stiffness, mass) = (draw(0.05, 2.0), draw(1e4, 3e5), draw(3.0, 12.0));
        let text = super::turbine_modes::text("frozen", section)
            .replace("m = 10\n", &format!("m = {mass}\n"))
            .replace("eiy = 3e5", &format!("eiy = {stiffness}"));
        let result = over(
            &text,
            "density",
            &format!("[{density}, {}]", 1.01 * density),
        );
        let roots = &result.points[0].roots;
        let own = |root: &StabilityRoot| Complex::new(root.growth(), root.in_blades);
        let oscillates = |s: Complex<f64>| s.im > 0.31 * s.norm();
        let listed: Vec<_> = roots.iter().map(own).filter(|s| oscillates(*s)).collect();
        let highest = listed.iter().map(|s| s.norm()).fold(0.0, f64::max);
        let all = eigenvalues(&text, density);
        let within = |s: &Complex<f64>| oscillates(*s) && s.norm() < 0.999 * highest;
        for s in all.into_iter().filter(within) {
            let is_near = |own: &Complex<f64>| (own - s).norm() < 1e-3 * s.norm();
            if !listed.iter().any(is_near) {
                missed.push(format!(
                    "{section} {density} {stiffness} {mass}: {s} among {listed:?}"
                ));
            }
        }
    }
    assert!(missed.is_empty(), "{missed:#?}");
}

// Blades so soft that the air damps their first flap mode nearly critically: at 0.6 and 1.2 kg/m^3 no search
// finds it, and it is continued from the values between. Its growth falls from value to value; and the
// complete linear model, whose states are other ones, has it as an eigenvalue: to 1e-10 of it at 0.1 and 0.6,
// to 5e-5 at 0.8 and 1.2, since the equilibria of both begin at other states.
#[test]
fn lost_modes_are_continued() {
    let text = light("hgm", 12, "3e4");
    let values = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.2];
    let result = over(&text, "density", &format!("{values:?}"));
    for name in FLAP {
        let growth: Vec<_> = (0..values.len())
            .map(|index| root(&result, index, name).growth())
            .collect();
        let falls = growth.windows(2).all(|pair| pair[1] < pair[0]);
        assert!(falls, "{name}: {growth:?}");
    }
    for index in [0, 5, 6, 7] {
        let all = eigenvalues(&text, values[index]);
        let off = distance(&all, root(&result, index, FLAP[1]).exponent);
        println!("{} {off:e}", values[index]);
        assert!(off < 1e-4, "{} {off:e}", values[index]);
    }
}

// The same blades with quasi-steady sections have s^2 + 2 d s + w^2 = 0 with d in proportion to the density,
// and no oscillation above a density where d = w: the slower root is then -d + sqrt(d^2 - w^2), an
// eigenvalue of the complete linear model, too. The coefficients are the ones at 0.2 kg/m^3; the loads bend
// the blade, by which the damping grows 1.5 % more than in proportion, and the root 7 %. In the fixed frame
// the whirls turn with the rotor.
#[test]
fn overdamped_modes_are_named_as_such() {
    let text = light("quasi_steady", 6, "1e4");
    let result = over(&text, "density", "[0.1, 0.2, 0.3, 0.4, 0.6, 0.8]");
    let of = root(&result, 1, FLAP[1]).exponent;
    let [damping, square] = [-of.re / 0.2, of.norm_sqr()];
    for (index, density) in [(4, 0.6), (5, 0.8)] {
        let all = eigenvalues(&text, density);
        let own = Complex::from(root(&result, index, FLAP[1]).growth());
        println!("{density} {:e}", distance(&all, own));
        assert!(distance(&all, own) < 1e-6, "{density}");
        for name in FLAP {
            let found = root(&result, index, name);
            let d = damping * density;
            let expected = -d + (d * d - square).sqrt();
            assert!(found.is_overdamped, "{name} {found:?}");
            let off = (found.growth() / expected - 1.0).abs();
            assert!(off < 0.1, "{name} {density}: {} {expected}", found.growth());
            let turns = if name == FLAP[1] { 0.0 } else { SPEED };
            assert!((found.frequency() - turns).abs() < 1e-9, "{name} {found:?}");
        }
    }
    let remark = "\"flap 1 collective\" is overdamped, without oscillation of the blades, at density = 0.4, 0.6";
    assert!(
        result.remarks.iter().any(|own| own.contains(remark)),
        "{:?}",
        result.remarks
    );
}

// The rotor of the IEA 15 MW turbine from 4 to 25 m/s: three modes of each of six shapes at each wind. The
// third flap mode, of 60 % of the critical damping at 12 m/s, is not found from 12 to 18 m/s otherwise. The
// short form has 11 and 12 m/s.
#[test]
fn all_modes_of_a_turbine_over_the_wind() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/cases/dynamics/turbine_modes/iea15.dynamics.toml"
    );
    let mut text = std::fs::read_to_string(path).unwrap();
    if !is_long() {
        text = text.replace("from = 4\nto = 25\nsteps = 22", "values = [11, 12]");
    }
    let read = |given: &[(String, f64)]| input::parse_with(&text, path, given);
    let input = read(&[]).unwrap_or_else(|problems| panic!("{problems}"));
    let result = stability("turbine", &input.stability.unwrap(), None, &read);
    assert!(result.failures.is_empty(), "{:#?}", result.failures);
    assert_eq!(result.points.len(), if is_long() { 22 } else { 2 });
    assert_eq!(result.modes.len(), 18, "{:?}", result.modes);
    for point in &result.points {
        assert_eq!(point.roots.len(), 18, "{}", point.at);
    }
    // One wind alone has the same modes. At 24 and 25 m/s alone torsion 1 is called edge 3, with which it has exchanged
    // much of its shape; the other winds decide in the sweep.
    let winds: Vec<_> = result.points.iter().map(|point| point.at).collect();
    let alone = if is_long() { &winds[..20] } else { &winds[1..] };
    for wind in alone {
        let (model, _) = text.split_once("[stability]").unwrap();
        let stability_alone = "[stability]\nparameter = \"wind\"\nboundaries = false\n";
        let text = format!(
            "{model}{stability_alone}values = [{wind}, {}]\n",
            wind + 0.01
        );
        let read = |given: &[(String, f64)]| input::parse_with(&text, path, given);
        let input = read(&[]).unwrap_or_else(|problems| panic!("{problems}"));
        let alone = stability("turbine", &input.stability.unwrap(), None, &read);
        assert_eq!(alone.modes.len(), 18, "{:?}", alone.modes);
        let index = winds.iter().position(|own| own == wind).unwrap();
        for name in &alone.modes {
            let [a, b] =
                [(&alone, 0), (&result, index)].map(|(of, at)| root(of, at, name).exponent);
            assert!((a - b).norm() < 1e-6 * a.norm(), "{wind} {name}: {a} {b}");
        }
    }
    for pair in result.points.windows(2) {
        for mode in 0..18 {
            let [a, b] = [&pair[0], &pair[1]].map(|point| point.root_of(mode).unwrap().exponent);
            // Its frequency changes by less than 0.5 Hz for a meter per second.
            assert!((a - b).norm() < 0.5 * TAU, "{} {a} {b}", result.modes[mode]);
        }
    }
}

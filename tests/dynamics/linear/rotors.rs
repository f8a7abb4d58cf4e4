//! Eigenvalues of linear models of rotors against modes, and outputs of the air.

use std::f64::consts::TAU;

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::input;
use nalgebra::Complex;

use super::{direct, linear, off, response, text};
use crate::periodic::rotor::{EQUAL, ISOTROPIC, rotor};
use crate::trim::{numbers, reference};

/// Growth and frequency of the oscillations of `[modes]` [1/s].
fn oscillations(cards: &str) -> Vec<Complex<f64>> {
    let input = input::parse(&text(cards), "model.dynamics.toml");
    let input = input.unwrap_or_else(|problems| panic!("{problems}"));
    let outcome = modes(&input.model, input.modes.as_ref().unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let points = outcome
        .table
        .branches
        .iter()
        .map(|branch| branch.points[0].as_ref());
    let points = points.map(|point| point.unwrap());
    points
        .map(|point| Complex::new(point.growth, TAU * point.frequency))
        .collect()
}

/// The largest distance of one of the modes from the nearest eigenvalue, relative to its size.
fn farthest(modes: &[Complex<f64>], eigenvalues: &[Complex<f64>]) -> f64 {
    let nearest = |mode: &Complex<f64>| {
        let distances = eigenvalues.iter().map(|own| (own - mode).norm());
        distances.fold(f64::INFINITY, f64::min) / mode.norm()
    };
    modes.iter().map(nearest).fold(0.0, f64::max)
}

// Ten states of the hub and the lagging blades; the growths are the ones of Coleman's equations in
// `stability.json`, and all modes the ones of [modes], which have eight digits.
#[test]
fn ground_resonance() {
    let hub = rotor(ISOTROPIC, &EQUAL, "= 0", "0");
    let cards = format!(
        "{hub}[transient]\nto = 1\nstep = 1\n[modes]\nspeeds = [26]\ncount = 5\n\
         [[load]]\nnode = \"mast\"\nforce = [1, 0, 0]\ndrive = \"shaker\"\n\
         [drives.shaker]\nkind = \"constant\"\nvalue = 0\n\
         [sensors.hub]\nquantity = \"displacement\"\nof = \"hub\"\ncomponent = \"x\"\n\
         [sensors.shaft]\nquantity = \"reaction_moment\"\nof = \"shaft\"\nnode = \"hub\"\n\
         component = \"z\"\n"
    );
    let asked = (&["shaker"][..], &["hub", "shaft"][..], 0.0);
    let model = linear(&cards, asked);
    assert_eq!(model.states.len(), 10);
    let rows = reference("theory-periodic/stability.json")["branch"][0]["coleman"].clone();
    let mut growths: Vec<_> = rows
        .as_array()
        .unwrap()
        .iter()
        .map(|row| numbers(row)[0])
        .collect();
    let mut own: Vec<_> = model.eigenvalues.iter().map(|own| own.re).collect();
    assert_eq!(growths.len(), own.len());
    growths.sort_by(f64::total_cmp);
    own.sort_by(f64::total_cmp);
    for (found, expected) in own.iter().zip(&growths) {
        assert!((found - expected).abs() < 1e-9, "{found} {expected}");
    }
    let found = oscillations(&cards);
    assert_eq!(found.len(), 5);
    let off_by = farthest(&found, &model.eigenvalues);
    assert!(off_by < 1e-6, "{off_by:e}");
    let s = Complex::new(0.1, 14.0);
    // Unscaled equations of springs of 1e6 N/m and angles.
    let off_by = off(&response(&model, s), &direct(&cards, asked, s));
    assert!(off_by < 1e-7, "{off_by:e}");
}

/// An elastic blade on a hub, with a dynamic wake and delayed separation, in wind.
const BLADE: &str = "[properties.blade]\nea = 4e8\ngay = 1e8\ngaz = 1e8\ngj = 4e5\neiy = 3e5\n\
    eiz = 8e5\nm = 10\niy = 0.2\niz = 1\n\
    [air]\ndensity = 1.225\nwind = [0, 0, 8]\n\
    [[inflow]]\nname = \"rotor\"\nblades = 3\nwake = \"dynamic\"\n\
    [[blade]]\nname = \"blade\"\nhub_radius = 1\nproperties = \"blade\"\n\
    piece = [{ length = 10, elements = 2 }]\n\
    [blade.aerodynamics]\ninflow = \"rotor\"\nsection = \"separation_lag\"\nstrips = 3\n\
    stations = [\n\
    { at = 1, chord = 1, twist = -0.07, airfoil = \"naca0012\" },\n\
    { at = 10, chord = 1, airfoil = \"naca0012\" },\n]\n\
    [[load]]\nnode = \"blade/tip\"\nforce = [0, 0, 1]\ndrive = \"push\"\n\
    [drives.push]\nkind = \"constant\"\nvalue = 0\n\
    [sensors.thrust]\nquantity = \"thrust\"\nof = \"rotor\"\n\
    [[output.column]]\nname = \"tip\"\nquantity = \"displacement\"\nof = \"blade/tip\"\n\
    [modes]\nspeeds = [6.28]\ncount = 6\n";

// The frequencies of an elastic blade differ by four orders of magnitude: the lowest has a relative error
// of 1e-16 times the square of their ratio, 1e-8.
#[test]
fn a_blade_in_the_air() {
    let asked = (&["push"][..], &["thrust", "tip_z"][..], 0.0);
    let model = linear(BLADE, asked);
    let found = oscillations(BLADE);
    assert_eq!(found.len(), 6);
    let off_by = farthest(&found, &model.eigenvalues);
    assert!(
        off_by < 1e-7,
        "{off_by:e} {found:?} {:?}",
        model.eigenvalues
    );
    // More states than positions and momenta: the ones of the air.
    let others = model
        .states
        .iter()
        .filter(|state| !state.name.contains("of node"));
    assert!(others.count() > 10, "{:?}", model.states);
    let s = Complex::new(-0.2, 9.0);
    let off_by = off(&response(&model, s), &direct(BLADE, asked, s));
    assert!(off_by < 1e-7, "{off_by:e}");
}

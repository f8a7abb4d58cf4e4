//! Stability of a periodic motion: multipliers of the linearized period, exponents, frequencies.
//!
//! ```text
//! M v = mu v ,     s = ln(mu)/T + i m 2 pi/T                                       (D-448)
//! ```
//!
//! The branch m has the largest content of the mode in the fixed frame, or the nearest to
//! given frequencies. Multipliers of the constraints are zero and not shown.
//!
//! References: [Floquet1883].

use std::f64::consts::TAU;

use faer::{Mat, c64};
use nalgebra::{Complex, Vector3};

use super::content::{Motion, Observer};
use super::equal::separate;
use super::map::PeriodMap;
use super::step_error::step_error;
use crate::case::FloquetSettings;
use crate::model::NODE_UNKNOWNS;
use crate::result::{FloquetMode, FloquetTable, SeenFrequency};
use crate::solver::{Largest, LinearMap, Ritz, largest};

/// Multipliers below this are round-off [-].
const ROUND_OFF: f64 = 1e-11;
/// Largest dimension of the space of products.
const MOST: usize = 400;
/// Distance from one within which a multiplier is the free choice of the azimuth: a double one is
/// known to the square root of round-off [-].
const NEUTRAL: f64 = 1e-6;
/// Part of the energy above which another frequency is listed [-].
const LISTED: f64 = 0.05;

/// The linearized period in sizes of the unknowns, without the unknowns `held`.
#[derive(Clone, Copy)]
pub(super) struct Monodromy<'a> {
    pub map: &'a PeriodMap,
    pub sizes: &'a [f64],
    pub held: &'a [usize],
}

impl Monodromy<'_> {
    fn apply_by(&self, x: &mut [f64], apply: impl Fn(&mut [f64]) -> Option<()>) -> Option<()> {
        x.iter_mut()
            .zip(self.sizes)
            .for_each(|(x, size)| *x *= size);
        self.held.iter().for_each(|i| x[*i] = 0.0);
        apply(x)?;
        self.held.iter().for_each(|i| x[*i] = 0.0);
        x.iter_mut()
            .zip(self.sizes)
            .for_each(|(x, size)| *x /= size);
        Some(())
    }
}

impl LinearMap for Monodromy<'_> {
    fn size(&self) -> usize {
        self.map.size()
    }

    fn apply(&self, x: &mut [f64]) -> Option<()> {
        self.apply_by(x, |d| self.map.apply(d))
    }

    fn project(&self, x: &mut [f64]) -> Option<()> {
        self.apply_by(x, |d| self.map.project(d))
    }
}

/// The largest multipliers with their vectors.
pub(super) fn multipliers(monodromy: &Monodromy<'_>, count: usize) -> Option<Largest> {
    let mut found = largest(monodromy, count, MOST)?;
    found.pairs.retain(|pair| pair.value.norm() > ROUND_OFF);
    Some(found)
}

/// The table of the multipliers `found`.
pub(super) fn table(
    (monodromy, found): (&Monodromy<'_>, &Largest),
    settings: &FloquetSettings,
    observer: &Observer<'_>,
    (coarse, stages): (Option<&Largest>, usize),
) -> FloquetTable {
    let mut pure = found.clone();
    separate(&mut pure, observer, monodromy.sizes);
    let modes = pure.pairs.iter().map(|pair| {
        let mut mode = mode((monodromy, pair), settings, observer);
        if settings.estimates_error {
            // Halved steps have 2^p times the error of the exponents, p = 2 s - 1.
            let factor = f64::from((1 << (2 * stages - 1)) - 1);
            let step = observer.period / monodromy.map.steps() as f64;
            let least = step_error(mode.in_blades, step, stages);
            let found = coarse.and_then(|coarse| error(pair, coarse, observer.period));
            mode.error = Some(found.map_or(least, |off| (off / factor).max(least)));
        }
        mode
    });
    FloquetTable {
        modes: modes.collect(),
        products: found.products,
        states: found.dimension,
    }
}

/// Change of the exponent to the nearest one of an analysis with half the steps \[1/s\].
fn error(pair: &Ritz, coarse: &Largest, period: f64) -> Option<f64> {
    let distance = |other: &&Ritz| (other.value - pair.value).norm();
    let nearest = coarse
        .pairs
        .iter()
        .min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
    let ratio = pair.value / nearest.value;
    Some(Complex::new(ratio.re, ratio.im).ln().norm() / period)
}

/// The branch of a principal frequency and the fundamental one that is nearest to one of the given frequencies, all
/// in rad/s.
fn near_branch(near: &[f64], (principal, base): (f64, f64)) -> Option<i32> {
    let off = |m: i32, near: f64| ((principal + f64::from(m) * base).abs() - near).abs();
    let nearest = |near: &f64| {
        let [m, other] = [*near, -near].map(|own| ((own - principal) / base).round() as i32);
        let [first, second] = [m, other].map(|m| off(m, *near));
        if first <= second {
            (m, first)
        } else {
            (other, second)
        }
    };
    let found = near.iter().map(nearest);
    found.min_by(|a, b| a.1.total_cmp(&b.1)).map(|own| own.0)
}

fn mode(
    (monodromy, pair): (&Monodromy<'_>, &Ritz),
    settings: &FloquetSettings,
    observer: &Observer<'_>,
) -> FloquetMode {
    let multiplier = Complex::new(pair.value.re, pair.value.im);
    let principal = multiplier.ln() / observer.period;
    let (motion, residual) = follow(monodromy, pair, principal, observer.period);
    let content = observer.content(&motion, multiplier.im == 0.0 && multiplier.re > 0.0);
    let base = TAU / observer.period;
    let frequency = |m: i32| (principal.im + f64::from(m) * base).abs();
    let by_content = content.shares.first().map_or(0, |first| first.0);
    let branch = near_branch(&settings.near, (principal.im, base)).unwrap_or(by_content);
    let chosen = content.shares.iter().find(|own| own.0 == branch);
    let others = content
        .shares
        .iter()
        .filter(|own| own.0 != branch && own.1 > LISTED);
    let shape = |m: i32| {
        let mut shape = content.shape(m);
        if principal.im + f64::from(m) * base < 0.0 {
            shape.iter_mut().for_each(|entry| *entry = entry.conj());
        }
        shape
    };
    let seen = |own: &(i32, f64, String)| SeenFrequency {
        frequency: frequency(own.0),
        share: own.1,
        shape: shape(own.0),
    };
    let exponent = Complex::new(principal.re, principal.im + f64::from(branch) * base);
    let named = observer.named(&content, branch, exponent);
    let in_coordinates = named.as_ref().map(|own| own.2.parts().map(<[_]>::to_vec));
    let (named, pattern) = named.map_or((None, None), |own| (Some(own.0), Some(own.1)));
    let of_whirl = named.as_ref().map(|named| named.whirl);
    let blades = of_whirl.map(|whirl| whirl.map_or(0, |own| own.blades));
    let largest = chosen.or(content.shares.first());
    FloquetMode {
        multiplier,
        exponent: Complex::new(principal.re, frequency(branch)),
        branch,
        share: chosen.map_or(0.0, |own| own.1),
        others: others.map(seen).collect(),
        residual,
        error: None,
        in_coordinates: in_coordinates.unwrap_or_default(),
        in_blades: named
            .as_ref()
            .map_or(frequency(branch), |own| own.in_blades),
        name: named.map_or_else(
            || largest.map_or_else(String::new, |own| own.2.clone()),
            |own| own.name,
        ),
        pattern,
        blades,
        shape: shape(branch),
        is_neutral: (multiplier - 1.0).norm() < NEUTRAL,
    }
}

/// Position and rotation of each node in the periodic part of a mode at the steps of a period, and
/// the residual of its multiplier.
fn follow(
    monodromy: &Monodromy<'_>,
    pair: &Ritz,
    principal: Complex<f64>,
    period: f64,
) -> (Vec<Motions>, f64) {
    let n = monodromy.map.size();
    let start = Mat::from_fn(n, 2, |i, part| pair.vector[part][i] * monodromy.sizes[i]);
    let mut d = start.clone();
    let steps = monodromy.map.steps();
    let nodes = monodromy.map.nodes();
    let mut motion = vec![motions(&start, nodes, Complex::new(1.0, 0.0))];
    let finite = monodromy.map.follow(&mut d, &mut |step, d| {
        if step < steps {
            let decayed = (-principal * period * step as f64 / steps as f64).exp();
            motion.push(motions(d, nodes, decayed));
        }
    });
    let mut off = [0.0; 2];
    for i in (0..n).filter(|i| !monodromy.held.contains(i)) {
        let part = |of: &Mat<f64>| c64::new(of[(i, 0)], of[(i, 1)]) / monodromy.sizes[i];
        let image = part(&start) * pair.value;
        off[0] += (part(&d) - image).norm_sqr();
        off[1] += image.norm_sqr();
    }
    let residual = match finite {
        Some(()) => (off[0] / off[1]).sqrt(),
        None => f64::INFINITY,
    };
    (motion, residual)
}

/// Position and rotation of each node in a complex variation.
type Motions = Vec<[Motion; 2]>;

/// The motions of a variation, times a factor.
fn motions(d: &Mat<f64>, nodes: usize, factor: Complex<f64>) -> Motions {
    let value = |i: usize| Complex::new(d[(i, 0)], d[(i, 1)]) * factor;
    let vector = |i: usize| Vector3::new(value(i), value(i + 1), value(i + 2));
    (0..nodes)
        .map(|node| [0, 3].map(|first| vector(NODE_UNKNOWNS * node + first)))
        .collect()
}

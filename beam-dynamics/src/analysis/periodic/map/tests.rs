//! The map of a period of equal blades as the power of a part of it.

use std::f64::consts::TAU;

use nalgebra::Complex;

use super::PeriodMap;
use crate::analysis::periodic::flow::Flow;
use crate::analysis::periodic::{algebraic, periodic_from, sizes};
use crate::model::NODE_UNKNOWNS;
use crate::solver::{LinearMap, largest};

/// Blades of the rotor.
const BLADES: usize = 3;
/// Nodes before the ones of the blades.
const BEFORE: usize = 2;

/// Blades on lag hinges with dampers on a hub, on springs with the stiffnesses and dampings of two directions; gravity
/// along the shaft. Blades, in the order of the azimuth, are the last nodes.
fn rotor([kx, ky, cx, cy]: [f64; 4], speed: f64) -> String {
    let mut text = format!(
        "[units]\nangle = \"rad\"\nrotation_speed = \"rad/s\"\n[gravity]\nacceleration = [0, 0, -9.81]\n\
         [[node]]\nname = \"mast\"\nposition = [0, 0, 0]\n\
         [[node]]\nname = \"hub\"\nposition = [0, 0, 0]\nangular_velocity = [0, 0, {speed:?}]\n\
         [[body]]\nname = \"mast\"\nnode = \"mast\"\nmass = 3199\ninertia = [9, 9, 9]\n\
         [[body]]\nname = \"hub\"\nnode = \"hub\"\nmass = 1\ninertia = [1, 1, 1]\n\
         [[joint]]\nname = \"support\"\nkind = \"total\"\nnodes = [\"mast\"]\n\
         locked = [\"z\", \"about x\", \"about y\", \"about z\"]\n\
         [[joint]]\nname = \"shaft\"\nkind = \"revolute\"\nnodes = [\"mast\", \"hub\"]\naxis = [0, 0, 1]\n\
         angle = \"= {speed:?}*t\"\n\
         [[spring]]\nname = \"tower\"\nnode = \"mast\"\nfixed_to = \"frame\"\nstiffness = [{kx:?}, {ky:?}, 0]\n\
         damping = [{cx:?}, {cy:?}, 0]\n"
    );
    for k in 0..BLADES {
        let (y, x) = (TAU * k as f64 / BLADES as f64).sin_cos();
        text += &format!(
            "[[node]]\nname = \"blade {k}\"\nposition = [{:?}, {:?}, 0]\nvelocity = [{:?}, {:?}, 0]\n\
             angular_velocity = [0, 0, {speed:?}]\n\
             [[body]]\nname = \"blade {k}\"\nnode = \"blade {k}\"\nmass = 40\ninertia = [69, 69, 69]\n\
             [[joint]]\nname = \"lag {k}\"\nkind = \"revolute\"\nnodes = [\"hub\", \"blade {k}\"]\n\
             at = [{:?}, {:?}, 0]\naxis = [0, 0, 1]\n\
             [[spring]]\nname = \"damper {k}\"\nnodes = [\"hub\", \"blade {k}\"]\nat = [{:?}, {:?}, 0]\n\
             rotational_damping = [0, 0, 400]\n",
            2.75 * x,
            2.75 * y,
            -2.75 * speed * y,
            2.75 * speed * x,
            0.35 * x,
            0.35 * y,
            0.35 * x,
            0.35 * y,
        );
    }
    text + &format!("[periodic]\nspeed = {speed:?}\nsteps = 12\ntolerance = 1e-11\n")
}

/// The first part of a period, after which each blade is in the place of the next one.
struct Part<'a> {
    map: &'a PeriodMap,
    sizes: &'a [f64],
    /// Steps, and whether the blades change places.
    steps: usize,
    permutes: bool,
}

impl Part<'_> {
    fn scaled(&self, x: &mut [f64], apply: impl Fn(&mut [f64]) -> Option<()>) -> Option<()> {
        x.iter_mut()
            .zip(self.sizes)
            .for_each(|(x, size)| *x *= size);
        apply(x)?;
        x.iter_mut()
            .zip(self.sizes)
            .for_each(|(x, size)| *x /= size);
        Some(())
    }
}

impl LinearMap for Part<'_> {
    fn size(&self) -> usize {
        self.map.size()
    }

    fn apply(&self, x: &mut [f64]) -> Option<()> {
        self.scaled(x, |d| {
            let mut columns = faer::Mat::from_fn(d.len(), 1, |i, _| d[i]);
            for step in &self.map.steps[..self.steps] {
                step.apply(&self.map.algebraic, &mut columns)?;
            }
            d.copy_from_slice(columns.col_as_slice(0));
            if self.permutes {
                let blades = BEFORE * NODE_UNKNOWNS..(BEFORE + BLADES) * NODE_UNKNOWNS;
                d[blades].rotate_right(NODE_UNKNOWNS);
            }
            Some(())
        })
    }

    fn project(&self, x: &mut [f64]) -> Option<()> {
        self.scaled(x, |d| self.map.project(d))
    }
}

// With equal blades, whatever the support in the ground is, the map of a revolution is the third power of the one of a
// third of it, in which blade k takes the place of blade k + 1; hub and mast stay. The multipliers are nu^3 = mu, to
// 1e-9, and as many: two for each of five freedoms. This is so for any number of steps; the zeros of the constraints
// are double, so that few steps show them as 1e-6.
#[test]
fn a_revolution_of_equal_blades_is_the_power_of_a_part() {
    for (support, speed) in [
        ([1.1e6, 1.1e6, 3000.0, 3000.0], 20.0),
        ([1.1e6, 2.0e6, 3000.0, 3800.0], 32.0),
    ] {
        let input = crate::input::parse(&rotor(support, speed), "r.dynamics.toml").unwrap();
        let (model, settings) = (&input.model, input.periodic.as_ref().unwrap());
        let outcome = periodic_from(model, settings, None);
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        let first = outcome.state.unwrap();
        assert_eq!(model.system.nodes()[BEFORE].label, "blade 0");
        let mut flow = Flow::new(model, settings, settings.steps, &first);
        let (_, map) = flow.linearized(&first).unwrap();
        let map = map.unwrap();
        let conditions = model.conditions_at(0.0);
        let free = algebraic(model, &first);
        let sizes = sizes::sizes(model, (&first, &conditions), &free, settings.period);
        assert_eq!(model.system.nodes().len(), BEFORE + BLADES);
        let of = |steps: usize, permutes: bool| {
            let part = Part {
                map: &map,
                sizes: &sizes,
                steps,
                permutes,
            };
            let found = largest(&part, 20, 400).unwrap().pairs;
            let values = found
                .iter()
                .map(|pair| Complex::new(pair.value.re, pair.value.im));
            let values: Vec<_> = values.filter(|value| value.norm() > 1e-3).collect();
            let both = values
                .iter()
                .map(|value| if value.im == 0.0 { 1 } else { 2 });
            assert_eq!(both.sum::<usize>(), 10, "{values:?}");
            values
        };
        let whole = of(12, false);
        for nu in of(4, true) {
            let mu = nu.powi(3);
            let off = |other: &Complex<f64>| (other - mu).norm().min((other.conj() - mu).norm());
            let nearest = whole.iter().map(off).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-9, "{speed}: {nu} {mu} {nearest:e}");
        }
    }
}

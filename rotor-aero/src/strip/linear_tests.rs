//! Derivatives by parts compared with dual numbers through the whole strip.

use std::sync::Arc;

use num_dual::DualSVec64;

use super::super::{
    ActingAir, AnnularInflow, FLOW, Flap, INPUTS, OUTPUTS, STATES, SectionModel, Strip,
    StripDesign, StripFlow, StripInflow, Wake,
};
use crate::airfoil::{PlainFlap, Section, built_in};
use crate::momentum::{HighInduction, Options};
use crate::wake::{Forcing, TimeScale};
use crate::wind::Atmosphere;

/// Every inflow: none, of a disk, of annuli in equilibrium and with dynamic wakes, and distributed; with
/// and without drag.
fn inflows() -> Vec<Option<StripInflow>> {
    let annular = |wake, high_induction| AnnularInflow {
        blades: 3,
        hub_radius: 0.1,
        options: Options {
            high_induction,
            ..Options::default()
        },
        wake,
    };
    let steady = annular(Wake::Equilibrium, HighInduction::Buhl);
    let dynamic = annular(
        Wake::Dynamic(TimeScale::Turbine, Forcing::Lagged),
        HighInduction::BuhlOutside,
    );
    let forced = annular(
        Wake::Dynamic(TimeScale::Turbine, Forcing::Steady),
        HighInduction::Buhl,
    );
    let without_drag = |mut inflow: AnnularInflow, axial_drag: bool| {
        inflow.options.axial_drag = axial_drag;
        inflow.options.tangential_drag = false;
        inflow
    };
    vec![
        Some(StripInflow::Annular(without_drag(dynamic, true))),
        Some(StripInflow::Distributed(without_drag(steady, false))),
        Some(StripInflow::Distributed(without_drag(forced, false))),
        None,
        Some(StripInflow::Disk),
        Some(StripInflow::Annular(steady)),
        Some(StripInflow::Annular(dynamic)),
        Some(StripInflow::Distributed(steady)),
        Some(StripInflow::Distributed(dynamic)),
        Some(StripInflow::Annular(forced)),
        Some(StripInflow::Distributed(forced)),
    ]
}

/// Numbers between -1 and 1 without a pattern (the golden ratio and its relatives).
struct Scattered(f64);

impl Scattered {
    fn next(&mut self) -> f64 {
        self.0 += 1.0;
        2.0 * (self.0 * 0.754_877_666_246_693).fract() - 1.0
    }
}

/// Loads and rows with derivatives, by dual numbers of all inputs at once.
fn at_once(
    strip: &Strip,
    air: ActingAir<'_>,
    flow: &[f64; FLOW],
    states: &[f64],
    rates: &[f64],
) -> [DualSVec64<INPUTS>; OUTPUTS] {
    let of = |value: f64, i: usize| DualSVec64::<INPUTS>::from_re(value).derivative(i);
    let flow = std::array::from_fn(|i| of(flow[i], i));
    let own = |values: &[f64], first: usize| -> Vec<_> {
        let numbered = values.iter().enumerate();
        numbered.map(|(k, value)| of(*value, first + k)).collect()
    };
    let (states, rates) = (own(states, FLOW), own(rates, FLOW + STATES));
    strip.outputs(air, &StripFlow::from_numbers(&flow), &states, &rates)
}

/// All models and inflows at forty random flows each, with the wake of each inflow in and out of
/// high induction, with flaps and without. Both are exact up to the round-off of some hundred operations.
#[test]
fn parts_have_the_derivatives_of_the_whole() {
    let still = Atmosphere::default();
    let mut random = Scattered(0.0);
    for word in SectionModel::WORDS {
        for (number, inflow) in inflows().into_iter().enumerate() {
            let mut strip = Strip::new(StripDesign {
                chord: 0.5,
                section: Section::single(Arc::new(built_in("naca0012").unwrap())),
                model: SectionModel::of_word(word).unwrap(),
                inflow,
                radial_drag: number % 2 == 0,
            });
            if number % 3 != 2 {
                strip = strip.with_flap(Flap::Plain(PlainFlap::new(0.25).unwrap()));
            }
            for case in 0..40 {
                let mut next = |size: f64| size * random.next();
                let flow = [
                    40.0 + next(30.0),
                    next(20.0),
                    next(10.0),
                    next(3.0),
                    next(0.3),
                    1.0 + next(0.3),
                    next(0.2),
                    2.0 + next(1.0),
                    4.0,
                    next(0.2),
                ];
                let states: Vec<_> = strip.states().iter().map(|_| next(3.0)).collect();
                let rates: Vec<_> = states.iter().map(|_| next(10.0)).collect();
                let air = ActingAir {
                    still: &still,
                    part: if case == 0 { 0.0 } else { 0.7 },
                };
                let found = strip.linearize(air, &flow, &states, &rates);
                let values = strip.evaluate(air, &flow, &states, &rates);
                let expected = at_once(&strip, air, &flow, &states, &rates);
                for (i, expected) in expected.iter().enumerate() {
                    let near = |a: f64, b: f64, scale: f64| (a - b).abs() <= 1e-10 * (1.0 + scale);
                    assert!(near(found.values[i], values[i], values[i].abs()));
                    let slopes = expected
                        .eps
                        .unwrap_generic(nalgebra::Const, nalgebra::Const);
                    for k in 0..INPUTS {
                        let (a, b) = (found.by[i][k], slopes[k]);
                        let words = format!("{word}, inflow {number}, output {i}, input {k}");
                        assert!(near(a, b, slopes.amax()), "{words}: {a} {b}");
                    }
                }
            }
        }
    }
}

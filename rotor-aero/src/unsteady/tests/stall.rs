//! Dynamic stall of NACA 0012 against measured and calculated loops.

use std::f64::consts::TAU;

use serde_json::Value;

use super::march::March;
use super::polars::Naca0012;
use crate::unsteady::{
    DynamicStall, Hgm, Lags, Model, Oye, SectionFlow, SectionForce, SeparationLag, Strip,
};

const STRIP: Strip = Strip {
    chord: 2.0,
    density: 1.2,
};
const SPEED: f64 = 50.0;
const STEPS: usize = 720;

fn read(path: &str) -> Vec<Vec<f64>> {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference/");
    let text = std::fs::read_to_string(format!("{root}{path}")).unwrap();
    let file: Value = serde_json::from_str(&text).unwrap();
    let numbers = |row: &Value| {
        row.as_array()
            .unwrap()
            .iter()
            .map(|it| it.as_f64().unwrap())
            .collect()
    };
    file["rows"]
        .as_array()
        .unwrap()
        .iter()
        .map(numbers)
        .collect()
}

/// A pitching motion about the quarter chord.
struct Motion {
    mean: f64,
    amplitude: f64,
    frequency: f64,
    mach: f64,
}

impl Motion {
    fn angle(&self, time: f64) -> f64 {
        self.mean + self.amplitude * (self.frequency * time).sin()
    }

    fn flow(&self, time: f64) -> SectionFlow<f64> {
        let (sin, cos) = self.angle(time).sin_cos();
        let rate = self.amplitude * self.frequency * (self.frequency * time).cos();
        let flow = SectionFlow::rigid(SPEED * sin, SPEED * cos, rate, STRIP.chord);
        SectionFlow {
            mach: self.mach,
            ..flow
        }
    }

    /// Largest and smallest lift coefficient, and smallest moment coefficient, in cycle 4.
    fn extremes<M: Model>(&self, model: &M, polar: &Naca0012) -> [f64; 3] {
        let step = TAU / self.frequency / STEPS as f64;
        let march = March {
            model,
            polar,
            strip: STRIP,
            step,
        };
        let forces = march.run(|time| self.flow(time), 4 * STEPS);
        let load = 0.5 * STRIP.density * SPEED * SPEED * STRIP.chord;
        let lift = |i: usize| {
            let force: &SectionForce<f64> = &forces[i];
            let (sin, cos) = self.angle((i + 1) as f64 * step).sin_cos();
            (force.normal * cos + force.along * sin) / load
        };
        let last = 3 * STEPS..4 * STEPS;
        let most = last.clone().map(lift).fold(f64::MIN, f64::max);
        let least = last.clone().map(lift).fold(f64::MAX, f64::min);
        let moment = last.map(|i| forces[i].moment / load / STRIP.chord);
        [most, least, moment.fold(f64::MAX, f64::min)]
    }
}

fn motion(mean: f64, amplitude: f64, k: f64, mach: f64) -> Motion {
    Motion {
        mean: mean.to_radians(),
        amplitude: amplitude.to_radians(),
        frequency: k * SPEED,
        mach,
    }
}

#[test]
fn oye_and_hgm_give_the_calculated_loops() {
    let polar = Naca0012 {
        from_lift: true,
        least_drag: 0.0081,
    };
    let long = Oye {
        separation_time: 6.0,
    };
    let short = Oye {
        separation_time: 3.0,
    };
    let jones = Hgm {
        lags: Lags::JONES,
        pressure_time: 1.7,
        separation_time: 6.0,
    };
    for row in read("aero/theory/unsteady_simple.json") {
        let motion = motion(row[0], row[1], row[2], 0.0);
        let found = [
            motion.extremes(&long, &polar)[0],
            motion.extremes(&short, &polar)[0],
            motion.extremes(&Hgm::COMMON, &polar)[0],
            motion.extremes(&jones, &polar)[0],
        ];
        let deepest = row[1] == 9.9;
        for (i, (found, listed)) in found.iter().zip(&row[4..]).enumerate() {
            // The same equations by an independent script, with lags of angles instead of
            // velocities, and lift normal to the effective flow: 1 % but for the deepest stall
            // (1.1 %), where the drag that this turns into lift is large.
            let limit = if deepest { 0.012 } else { 0.01 };
            assert!((found - listed).abs() < limit * listed, "{row:?}: {found}");
            // Measured loops (NASA TM 84245): 12 %, but for the short lag of separation in the
            // deepest stall (13.4 %).
            let limit = if deepest && i == 1 { 0.14 } else { 0.12 };
            assert!((found - row[3]).abs() < limit * row[3], "{row:?}: {found}");
        }
    }
}

#[test]
fn dynamic_stall_and_lag_of_separation_reach_the_measured_lift() {
    let vortex = Naca0012 {
        from_lift: false,
        least_drag: 0.005,
    };
    let lagged = Naca0012 {
        from_lift: true,
        least_drag: 0.0081,
    };
    for row in read("theory-rotor/dynamic_stall.json") {
        let motion = motion(row[1], row[2], row[3], row[4]);
        let stall = motion.extremes(&DynamicStall::default(), &vortex);
        let lag = motion.extremes(&SeparationLag::default(), &lagged);
        let measured = row[5];
        let error = |found: &[f64; 3]| (found[0] / measured - 1.0).abs();
        // 10 % (vortex: 5 % in the deepest stall), but for attached flow at k = .198, where the
        // measured amplitude exceeds thin-airfoil theory (independent script: 13 %).
        let limit = if row[3] > 0.15 { 0.12 } else { 0.1 };
        let deep = if row[2] == 9.9 { 0.05 } else { limit };
        assert!(error(&stall) < deep, "{row:?}: {stall:?}");
        assert!(error(&lag) < limit, "{row:?}: {lag:?}");
        // The independent script, with switches instead of gates and impulsive lift: 2.1 %.
        assert!(
            (stall[0] / row[7] - 1.0).abs() < 0.021,
            "{row:?}: {stall:?}"
        );
    }
}

//! A rigid flapping blade of quasi-steady sections in uniform inflow.

use std::f64::consts::TAU;

use crate::inflow::steady_uniform;
use crate::inflow::tests::rotor::reference;
use crate::unsteady::tests::polars::Linear;
use crate::unsteady::{Model, QuasiSteady, SectionFlow, Strip};

const STEPS: u32 = 72;
const STRIPS: u32 = 24;
/// Speed of the tip, so large that the rest speed of sections has no effect [m/s].
const TIP: f64 = 200.0;

/// Inputs of a flapping blade, in rad.
struct Blade {
    lock: f64,
    pitch: [f64; 3],
    twist: f64,
    inflow: f64,
    advance: f64,
}

impl Blade {
    /// Thrust of a blade and its moment about the hinge, both over a constant, at an azimuth.
    fn loads(&self, azimuth: f64, [flap, rate]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = azimuth.sin_cos();
        let root = self.pitch[0] + self.pitch[1] * cos + self.pitch[2] * sin;
        let strip = Strip {
            chord: 1.0,
            density: 2.0 / TIP / TIP,
        };
        let mut sum = [0.0; 2];
        for i in 0..STRIPS {
            // Two Gauss points per strip.
            for side in [-1.0, 1.0] {
                let radius = (f64::from(i) + 0.5 + side / 12.0_f64.sqrt()) / f64::from(STRIPS);
                let tangential = radius + self.advance * sin;
                let through = self.inflow + radius * rate + self.advance * flap * cos;
                let normal = (root + self.twist * radius) * tangential - through;
                let flow = SectionFlow::rigid(TIP * normal, TIP * tangential, 0.0, 1.0);
                let polar = Linear { slope: 1.0 };
                let force = QuasiSteady.evaluate(&strip, &polar, &flow, &[], &[], &mut []);
                let lift = force.unwrap().normal / f64::from(2 * STRIPS);
                sum[0] += lift;
                sum[1] += lift * radius;
            }
        }
        sum
    }

    fn slope(&self, azimuth: f64, [flap, rate]: [f64; 2]) -> [f64; 2] {
        let moment = self.loads(azimuth, [flap, rate])[1];
        [rate, -flap + 0.5 * self.lock * moment]
    }

    fn step(&self, azimuth: f64, x: [f64; 2]) -> [f64; 2] {
        let h = TAU / f64::from(STEPS);
        let add = |k: [f64; 2], s: f64| [x[0] + s * k[0], x[1] + s * k[1]];
        let k1 = self.slope(azimuth, x);
        let k2 = self.slope(azimuth + h / 2.0, add(k1, h / 2.0));
        let k3 = self.slope(azimuth + h / 2.0, add(k2, h / 2.0));
        let k4 = self.slope(azimuth + h, add(k3, h));
        let mean = |i: usize| (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]) / 6.0;
        add([mean(0), mean(1)], h)
    }

    /// Coning and first harmonics in deg, and CT over solidity and slope, after 10 revolutions.
    fn periodic(&self) -> [f64; 4] {
        let mut x = [0.0_f64; 2];
        let mut sum = [0.0; 4];
        for i in 0..10 * STEPS {
            let azimuth = TAU * f64::from(i) / f64::from(STEPS);
            if i >= 9 * STEPS {
                let (sin, cos) = azimuth.sin_cos();
                let share = 1.0 / f64::from(STEPS);
                let flap = x[0].to_degrees() * share;
                sum[0] += flap;
                sum[1] += 2.0 * flap * cos;
                sum[2] += 2.0 * flap * sin;
                sum[3] += 0.5 * self.loads(azimuth, x)[0] * share;
            }
            x = self.step(azimuth, x);
        }
        sum
    }
}

fn rows(it: &serde_json::Value) -> Vec<Vec<f64>> {
    let numbers = |row: &serde_json::Value| {
        row.as_array()
            .unwrap()
            .iter()
            .map(|it| it.as_f64().unwrap())
            .collect()
    };
    it.as_array().unwrap().iter().map(numbers).collect()
}

#[test]
fn flapping_is_the_listed_periodic_response() {
    let it = reference("theory-rotor/flap_closed_form.json");
    for row in rows(&it["rows"]) {
        let blade = Blade {
            lock: 8.0,
            pitch: [10.0_f64, 1.5, -4.0].map(f64::to_radians),
            twist: (-8.0_f64).to_radians(),
            inflow: 0.02,
            advance: row[0],
        };
        let found = blade.periodic();
        // Four decimals of a degree are listed; in hover the closed form is exact.
        let limit = if row[0] == 0.0 { 1e-4 } else { 1e-3 };
        for i in 0..3 {
            assert!((found[i] - row[4 + i]).abs() < limit, "{row:?}: {found:?}");
        }
        assert!((found[3] - row[8]).abs() < 2e-6, "{row:?}: {found:?}");
    }
}

#[test]
fn the_listed_trim_has_the_thrust_and_no_flapping() {
    let it = reference("theory-rotor/flap_closed_form.json");
    for row in rows(&it["trim"]["rows"]) {
        let advance = row[0];
        let axial = advance * (5.0_f64 * advance / 0.3).to_radians().tan();
        let inflow = axial + steady_uniform(0.0064, advance, axial);
        assert!((inflow - row[8]).abs() < 6e-6, "{row:?}: {inflow}");
        let blade = Blade {
            lock: 8.0,
            pitch: [row[1], row[2], row[3]].map(f64::to_radians),
            twist: (-8.0_f64).to_radians(),
            inflow,
            advance,
        };
        let found = blade.periodic();
        // Controls are listed with four decimals of a degree: flapping to about 1e-3 deg.
        assert!(
            found[1].abs() < 1e-3 && found[2].abs() < 1e-3,
            "{row:?}: {found:?}"
        );
        assert!((found[0] - row[7]).abs() < 1e-3, "{row:?}: {found:?}");
        assert!(
            (found[3] * 0.08 * 5.73 - 0.0064).abs() < 1e-6,
            "{row:?}: {found:?}"
        );
    }
}

//! The disk in velocities against the models over the tip speed, in turned axes and for both senses
//! of rotation.

use std::f64::consts::PI;

use super::polar;
use crate::inflow::{Disk, DiskFlow, DiskLoads, Inflow, InflowModel, RotorFlow, RotorLoads};

/// Deterministic numbers in [-1, 1].
struct Random(u64);

impl Random {
    fn number(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

const DENSITY: f64 = 1.1;
const RADIUS: f64 = 4.5;

/// The tip speed is rounded by .1 m/s: 1e-6 of it at 100 m/s, and the direction of the flow by 1e-6
/// m/s of 10 m/s.
const WITHIN: f64 = 3e-6;

/// A model at a state over the tip speed.
struct Sample {
    model: InflowModel,
    flow: RotorFlow<f64>,
    loads: RotorLoads<f64>,
    states: Vec<f64>,
    rates: Vec<f64>,
    /// Radius over R, and azimuth.
    place: [f64; 2],
}

fn sample(model: InflowModel, random: &mut Random) -> Sample {
    let count = model.states().len();
    Sample {
        model,
        flow: RotorFlow {
            advance: 0.2 + 0.1 * random.number(),
            axial: 0.05 * random.number(),
            speed: 30.0 + 8.0 * random.number(),
        },
        loads: RotorLoads {
            thrust: 0.01 * (1.0 + random.number()),
            sine: 0.001 * random.number(),
            cosine: 0.001 * random.number(),
        },
        states: (0..count).map(|_| 0.05 * random.number()).collect(),
        rates: (0..count).map(|_| 0.5 * random.number()).collect(),
        place: [0.6 + 0.3 * random.number(), PI * random.number()],
    }
}

/// Axes with aft at `angle` from e_1, and the advancing side by the sense.
struct Axes {
    aft: [f64; 2],
    advancing: [f64; 2],
}

impl Axes {
    fn new(angle: f64, sense: f64) -> Self {
        let aft = [angle.cos(), angle.sin()];
        Self {
            advancing: [-sense * aft[1], sense * aft[0]],
            aft,
        }
    }

    fn along(&self, [sine, cosine]: [f64; 2], size: f64) -> [f64; 2] {
        [0, 1].map(|i| size * (sine * self.advancing[i] + cosine * self.aft[i]))
    }

    fn turned(&self, of: &[f64], size: f64) -> Vec<f64> {
        let mut out: Vec<f64> = of.iter().map(|value| value * size).collect();
        if let [_, sine, cosine] = *of {
            [out[1], out[2]] = self.along([sine, cosine], size);
        }
        out
    }
}

/// The rows of a disk and its induced velocity at a sample, with a sense of rotation.
fn in_velocities(of: &Sample, axes: &Axes, sense: f64) -> (Vec<f64>, f64) {
    let tip = of.flow.speed * RADIUS;
    let size = DENSITY * PI * RADIUS * RADIUS * tip * tip;
    let disk = Disk {
        model: of.model,
        radius: RADIUS,
    };
    let flow = DiskFlow {
        in_plane: axes.aft.map(|part| part * of.flow.advance * tip),
        axial: of.flow.axial * tip,
        speed: sense * of.flow.speed,
    };
    let loads = DiskLoads {
        thrust: of.loads.thrust * size,
        moments: axes.along([of.loads.sine, of.loads.cosine], size * RADIUS),
    };
    let states = axes.turned(&of.states, tip);
    let rates = axes.turned(&of.rates, tip);
    let mut rows = vec![0.0; states.len()];
    disk.rows((&flow, DENSITY), &loads, (&states, &rates), &mut rows)
        .unwrap();
    let (sine, cosine) = of.place[1].sin_cos();
    let position = axes.along([sine, cosine], of.place[0] * RADIUS);
    (rows, disk.induced(&flow, &states, &position).unwrap())
}

#[test]
fn velocities_follow_the_coefficients_in_any_axes() {
    let mut random = Random(5);
    for case in 0..300 {
        let sense = if case % 2 == 0 { 1.0 } else { -1.0 };
        for word in InflowModel::WORDS {
            let of = sample(InflowModel::of_word(word).unwrap(), &mut random);
            let mut expected = vec![0.0; of.states.len()];
            of.model
                .rows(&of.flow, &of.loads, &of.states, &of.rates, &mut expected)
                .unwrap();
            let [radius, azimuth] = of.place;
            let induced = of
                .model
                .induced(&of.flow, &of.states, &polar(radius, azimuth));
            let axes = Axes::new(PI * random.number(), sense);
            let (rows, found) = in_velocities(&of, &axes, sense);
            let tip = of.flow.speed * RADIUS;
            for (row, expected) in rows.iter().zip(axes.turned(&expected, tip)) {
                let off = (row - expected).abs();
                assert!(off < WITHIN * 50.0 * tip, "{word} {row} {expected}");
            }
            let off = (found - induced.unwrap() * tip).abs();
            assert!(off < WITHIN * tip, "{word} {found}");
        }
    }
}

/// Momentum theory of a hovering rotor: `T = 2 rho pi R^2 u^2`, at any speed of rotation, also none.
#[test]
fn hover_has_the_velocity_of_momentum_theory() {
    for speed in [0.0, 0.01, 20.0, -40.0] {
        let flow = DiskFlow {
            in_plane: [0.0, 0.0],
            axial: 0.0,
            speed,
        };
        for word in ["uniform", "drees", "mangler_squire", "pitt_peters"] {
            let disk = Disk {
                model: InflowModel::of_word(word).unwrap(),
                radius: RADIUS,
            };
            let mut states = vec![0.0; disk.states().len()];
            states[0] = 11.0;
            let loads = DiskLoads {
                thrust: 2.0 * DENSITY * PI * RADIUS * RADIUS * 121.0,
                moments: [0.0, 0.0],
            };
            let steady = disk.steady(&flow, loads.thrust, DENSITY);
            let mut rows = vec![1.0; states.len()];
            let rates = vec![0.0; states.len()];
            disk.rows((&flow, DENSITY), &loads, (&states, &rates), &mut rows)
                .unwrap();
            for (state, expected) in steady.iter().zip(&states) {
                // The slow reference of a rotor at rest rounds the mass flow by 1e-5.
                assert!((state - expected).abs() < 1e-5, "{word} {speed} {steady:?}");
            }
            // Rows over the rate of their equation, 2 u / R.
            let off = rows[0].abs() / (2.0 * 11.0 * 11.0 / RADIUS);
            assert!(off < 1e-6, "{word} {speed} {rows:?}");
        }
    }
}

/// A turbine with the induction .3, whose wind is along its shaft: a blade that points downwind has more
/// induction, and the mean over the azimuth is the mean of the annulus. The velocity along the shaft is
/// rounded by a part of 2e-4 times the square of the tangent of the yaw. At 5 degrees the skew is
/// Burton's `1.18 chi_0` but for a third of its square, .3 %, and the square of .18, 3 %.
#[test]
fn yaw_skews_the_velocity_of_an_annulus() {
    let disk = Disk {
        model: InflowModel::of_word("none").unwrap(),
        radius: RADIUS,
    };
    let wind = 10.0;
    for (sense, turn, yaw) in [(1.0, 0.0, 20f64), (-1.0, 2.1, 20.0), (1.0, 1.0, 5.0)] {
        let yaw = yaw.to_radians();
        let flow = DiskFlow {
            in_plane: [
                wind * yaw.sin() * f64::cos(turn),
                wind * yaw.sin() * f64::sin(turn),
            ],
            axial: -wind * yaw.cos(),
            speed: 1.2 * sense,
        };
        let mean = 0.3 * wind * yaw.cos();
        let skew = (yaw.sin() / (yaw.cos() * (1.0 - 0.6 * 0.3))).atan();
        assert!((skew / (1.18 * yaw) - 1.0).abs() < 0.04 || yaw > 0.1);
        let amplitude = 15.0 * PI / 32.0 * (0.5 * skew).tan() * 0.7;
        let mut sum = 0.0;
        for step in 0..36 {
            let psi = PI * f64::from(step) / 18.0;
            let at = [f64::cos(turn + psi), f64::sin(turn + psi)].map(|part| part * 0.7 * RADIUS);
            let found = disk.skewed(&flow, mean, &at);
            let expected = mean * (1.0 + amplitude * psi.cos());
            assert!(
                (found - expected).abs() < 5e-5 * mean,
                "{psi} {found} {expected}"
            );
            sum += found / 36.0;
        }
        assert!((sum - mean).abs() < 1e-12 * mean);
    }
}

//! Rotors in time with the dynamic wake: the lagged form of annular momentum, strip by strip.
//!
//! The rotor is marched by a simple rule: within a step the quasi-steady velocity is constant,
//! and the filter follows by the trapezoidal rule.

use crate::support::apc::Compressible;
use crate::support::{Shared, json, nrel5mw, number};
use rotor_aero::airfoil::{Coefficients, Flow, Profile};
use rotor_aero::momentum::{Ambient, Annulus, HighInduction, induced_flow};
use rotor_aero::wake::{FilterState, Forcing, TimeScale, disk_mean, forcing, rates};

/// A strip of a blade with its wake.
struct Strip<S> {
    annulus: Annulus,
    twist: f64,
    section: S,
    wake: [FilterState<f64>; 2],
}

/// A rotor in axial flow, without shear.
struct Rotor<S> {
    strips: Vec<Strip<S>>,
    /// Turbines have their airfoils upside down.
    turbine: bool,
    scale: TimeScale,
    school: Forcing,
    omega: f64,
}

impl Rotor<Shared> {
    fn nrel(rpm: f64, school: Forcing) -> Self {
        let rotor = nrel5mw();
        let strips = rotor.stations.iter().map(|station| Strip {
            annulus: Annulus {
                radius: station.radius,
                hub_radius: rotor.hub_radius,
                tip_radius: rotor.tip_radius,
                blades: 3,
                chord: station.chord,
                options: rotor.options,
            },
            twist: station.twist,
            section: station.section.clone(),
            wake: [FilterState::default(); 2],
        });
        Self {
            strips: strips.collect(),
            turbine: true,
            scale: TimeScale::Turbine,
            school,
            omega: rpm * std::f64::consts::PI / 30.0,
        }
    }
}

impl<S: Profile> Rotor<S> {
    fn coefficients(&self, strip: &Strip<S>, alpha: f64, speed: f64) -> Coefficients<f64> {
        let sign = if self.turbine { -1.0 } else { 1.0 };
        let flow = Flow {
            alpha: sign * alpha,
            mach: speed / 340.0,
            reynolds: 1.225 * speed * strip.annulus.chord / 1.81e-5,
            flap: 0.0,
        };
        let found = strip.section.at(&flow);
        Coefficients {
            lift: sign * found.lift,
            ..found
        }
    }

    fn ambient(&self, strip: &Strip<S>, speed: f64) -> Ambient<f64> {
        Ambient {
            axial: speed,
            rotation: self.omega * strip.annulus.radius,
            skew: 0.0,
        }
    }

    /// Quasi-steady velocities of all strips.
    fn quasi_steady(&self, speed: f64, pitch: f64) -> Vec<(f64, f64)> {
        let of = |strip: &Strip<S>| {
            let ambient = self.ambient(strip, speed);
            let total = speed.hypot(ambient.rotation);
            let section = |alpha: f64| self.coefficients(strip, alpha, total);
            let [u, v] = strip.wake.map(|wake| wake.induced);
            let pitch = strip.twist + pitch;
            forcing(
                self.school,
                &strip.annulus,
                &ambient,
                pitch,
                (u, v),
                section,
            )
        };
        self.strips.iter().map(of).collect()
    }

    fn mean_induced(&self) -> f64 {
        let rings = self.strips.iter();
        disk_mean(rings.map(|it| (it.annulus.radius, it.wake[0].induced)))
    }

    fn step(&mut self, speed: f64, pitch: f64, dt: f64) {
        let targets = self.quasi_steady(speed, pitch);
        let mean = self.mean_induced();
        let hover = matches!(self.scale, TimeScale::Hover { .. });
        let through = if hover { speed + mean } else { speed };
        let scale = self.scale;
        for (strip, target) in self.strips.iter_mut().zip(targets) {
            let ring = strip.annulus;
            let ratio = ring.radius / ring.tip_radius;
            let constants = scale.constants(ring.tip_radius, ratio, through, -mean / speed);
            strip.wake[0] = trapezoid(strip.wake[0], target.0, dt, constants);
            strip.wake[1] = trapezoid(strip.wake[1], target.1, dt, constants);
        }
    }

    /// Starts at rest of the filter, at the steady state.
    fn settle(&mut self, speed: f64, pitch: f64) {
        let school = std::mem::replace(&mut self.school, Forcing::Steady);
        let steady = self.quasi_steady(speed, pitch);
        self.school = school;
        for (strip, (u, v)) in self.strips.iter_mut().zip(steady) {
            strip.wake = [FilterState::steady(u), FilterState::steady(v)];
        }
    }

    /// Loads of all blades per length, along the thrust and along the torque of a propeller.
    fn loads(&self, speed: f64, pitch: f64) -> Vec<(f64, f64)> {
        let of = |strip: &Strip<S>| {
            let ambient = self.ambient(strip, speed);
            let [u, v] = strip.wake.map(|wake| wake.induced);
            let flow = induced_flow(&ambient, u, v);
            let alpha = strip.twist + pitch - flow.phi;
            let total = speed.hypot(ambient.rotation);
            let (normal, tangential) =
                flow.load_coefficients(self.coefficients(strip, alpha, total));
            let blades = strip.annulus.blades as f64;
            let pressure = 0.5 * 1.225 * flow.speed.powi(2) * strip.annulus.chord * blades;
            (normal * pressure, tangential * pressure)
        };
        self.strips.iter().map(of).collect()
    }

    /// Thrust and power of a turbine: the trapezoidal rule with zeros at hub and tip.
    fn turbine_sums(&self, speed: f64, pitch: f64) -> (f64, f64) {
        let ring = self.strips[0].annulus;
        let mut points = vec![(ring.hub_radius, 0.0, 0.0)];
        for (strip, load) in self.strips.iter().zip(self.loads(speed, pitch)) {
            let radius = strip.annulus.radius;
            points.push((radius, -load.0, -load.1 * radius * self.omega));
        }
        points.push((ring.tip_radius, 0.0, 0.0));
        let sum = |value: fn(&(f64, f64, f64)) -> f64| -> f64 {
            let pairs = points.windows(2);
            let area = |it: &[(f64, f64, f64)]| {
                0.5 * (it[1].0 - it[0].0) * (value(&it[0]) + value(&it[1]))
            };
            pairs.map(area).sum()
        };
        (sum(|it| it.1), sum(|it| it.2))
    }
}

fn trapezoid(
    state: FilterState<f64>,
    target: f64,
    dt: f64,
    constants: (f64, f64),
) -> FilterState<f64> {
    let now = rates(&state, target, constants);
    let (one, two) = (0.5 * dt / constants.0, 0.5 * dt / constants.1);
    let rest = FilterState::steady(target);
    let first = (state.first + 0.5 * dt * now.first + one * rest.first) / (1.0 + one);
    let drive = first + target - rest.first;
    FilterState {
        first,
        induced: (state.induced + 0.5 * dt * now.induced + two * drive) / (1.0 + two),
    }
}

/// Thrust and power before, just after and long after a step of the pitch by 3.7 degrees to
/// feather at 8 m/s, and the time in which the thrust recovers to 1/e.
fn pitch_step(school: Forcing, dt: f64) -> ([(f64, f64); 3], f64) {
    let pitch = 3.7f64.to_radians();
    let mut rotor = Rotor::nrel(9.156, school);
    rotor.settle(8.0, 0.0);
    let before = rotor.turbine_sums(8.0, 0.0);
    let dip = rotor.turbine_sums(8.0, pitch);
    let mut history = vec![dip.0];
    for _ in 0..(100.0 / dt) as usize {
        rotor.step(8.0, pitch, dt);
        history.push(rotor.turbine_sums(8.0, pitch).0);
    }
    let after = rotor.turbine_sums(8.0, pitch);
    let level = after.0 + (dip.0 - after.0) / std::f64::consts::E;
    let time = dt * history.iter().take_while(|it| **it < level).count() as f64;
    ([before, dip, after], time)
}

/// Before and after are the steady states, equal to the digits listed; the overshoot is 63 % beyond
/// the change of thrust. An independent script gave the numbers: 1 % for the dip. Its 4.7 s are of
/// the induction factor by the thrust coefficient (5 %), its 7.55 s of the steady school (2 %); the
/// velocity form takes 6.05 s, since the mass flow follows the lagged velocity too.
#[test]
fn thrust_overshoots_after_a_step_of_pitch() {
    let data = &json("aero/theory/dynamic_inflow.json")["pitch_step"];
    let listed = number(&data["time_to_1_over_e_s"]);
    for (school, expected, tolerance) in [
        (Forcing::Lagged, 6.05, 0.02),
        (Forcing::Thrust, listed, 0.05),
        (Forcing::Steady, 7.55, 0.02),
    ] {
        let (states, time) = pitch_step(school, 0.05);
        println!("{school:?} {states:?} {time}");
        assert!(
            (time / expected - 1.0).abs() < tolerance,
            "{school:?} {time}"
        );
        for (state, key) in states.iter().zip(["before", "just_after", "after"]) {
            let tolerance = if key == "just_after" { 0.01 } else { 1e-4 };
            let thrust = state.0 / 1e3 / number(&data["T_kN"][key]);
            let power = state.1 / 1e6 / number(&data["P_MW"][key]);
            assert!((thrust - 1.0).abs() < tolerance, "{key}");
            assert!((power - 1.0).abs() < tolerance, "{key}");
        }
    }
}

/// Wind 12, 3 and 12 m/s: through the turbulent wake (a = 1.1) and back without a switch. An
/// independent script gave the numbers: 1e-3 where the thrust is steady.
#[test]
fn a_turbine_passes_the_turbulent_wake() {
    let data = &json("aero/theory/velocity_form.json")["nrel5mw"];
    let mut rotor = Rotor::nrel(12.1, Forcing::Lagged);
    let mut worst = 0.0f64;
    for step in 0..2400 {
        let time = 0.05 * f64::from(step);
        let wind = |time: f64| {
            if (39.99..79.99).contains(&time) {
                3.0
            } else {
                12.0
            }
        };
        let speed = wind(time);
        for (key, expected) in data["T_kN"].as_object().expect("times") {
            let at: f64 = key.parse().expect("a time");
            if (at - time).abs() < 0.024 {
                let found = rotor.turbine_sums(speed, 0.0).0 / 1e3;
                let error = (found - number(expected)) / 787.2;
                println!("{key}: {found} {expected} {error}");
                worst = worst.max(error.abs());
            }
        }
        rotor.step(speed, 0.0, 0.05);
        assert!(rotor.mean_induced().is_finite());
    }
    let end = rotor.turbine_sums(12.0, 0.0).0 / 1e3;
    assert!((end / 787.2 - 1.0).abs() < 1e-3, "{end}");
    assert!(worst < 1e-4, "{worst}");
}

/// The propeller APC 10x7SF from still air, at speeds from climb to descent: the wake settles to a
/// steady state where Newton's method from rest fails. An independent script gave the numbers.
#[test]
fn a_propeller_settles_in_hover_and_descent() {
    let data = &json("aero/theory/velocity_form.json")["apc"];
    let blade = crate::support::apc::blade("10x7SF-PERF.PE0");
    let section = Compressible(crate::support::apc::family("NACA_4412", "N6.0"));
    for law in [HighInduction::Buhl, HighInduction::BuhlOutside] {
        for (index, ratio) in crate::support::numbers(&data["J"]).into_iter().enumerate() {
            let expected = number(&data["CT_end"][index]);
            let mut rotor = propeller(&blade, &section, law);
            let n = rotor.omega / std::f64::consts::TAU;
            let diameter = 2.0 * blade.radius;
            let speed = ratio * n * diameter;
            for _ in 0..1200 {
                rotor.step(speed, 0.0, 1.0 / (20.0 * n));
            }
            let width = (blade.radius - blade.rows[0][0]) / 20.0;
            let coefficient = |rotor: &Rotor<Compressible>| {
                let loads = rotor.loads(speed, 0.0).into_iter();
                let thrust: f64 = loads.map(|it| it.0 * width).sum();
                thrust / (1.225 * n * n * diameter.powi(4))
            };
            let ct = coefficient(&rotor);
            let targets = rotor.quasi_steady(speed, 0.0);
            let pairs = rotor.strips.iter().zip(targets);
            let rest = pairs.map(|(strip, it)| (strip.wake[0].induced - it.0).abs());
            let rest = rest.fold(0.0, f64::max);
            let error = (ct / expected - 1.0).abs();
            // The tolerance of the reference for steady values; the script has the law of Buhl, from
            // which the other one differs in descent alone, where annuli are highly loaded.
            let within = match law {
                HighInduction::Buhl => 1e-3,
                _ => 0.05,
            };
            assert!(error < within, "{law:?} {ratio}: {ct} {expected}");
            assert!(rest < 1e-6, "{law:?} {ratio}: {rest:e}");
            // In descent the steady state is the one of the same relation.
            if ratio < 0.0 {
                rotor.settle(speed, 0.0);
                let steady = coefficient(&rotor);
                assert!((steady / ct - 1.0).abs() < 1e-4, "{law:?}: {steady} {ct}");
            }
        }
    }
}

fn propeller(
    blade: &crate::support::apc::Blade,
    section: &Compressible,
    law: HighInduction,
) -> Rotor<Compressible> {
    let start = blade.rows[0][0];
    let width = (blade.radius - start) / 20.0;
    let strips = (0..20).map(|panel| {
        let radius = start + width * (f64::from(panel) + 0.5);
        Strip {
            annulus: Annulus {
                radius,
                hub_radius: start,
                tip_radius: blade.radius,
                blades: 2,
                chord: blade.at(radius, 1),
                options: crate::support::law(law),
            },
            twist: blade.at(radius, 2),
            section: section.clone(),
            wake: [FilterState::default(); 2],
        }
    });
    Rotor {
        strips: strips.collect(),
        turbine: false,
        scale: TimeScale::Hover {
            least_speed: 0.5,
            cap: 0.5,
        },
        school: Forcing::Lagged,
        omega: 5000.0 * std::f64::consts::PI / 30.0,
    }
}

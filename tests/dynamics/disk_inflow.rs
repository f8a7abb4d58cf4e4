//! Rotors with the inflow of a disk in the complete model, at rest in the turning frame and in time.
//!
//! Blades of linear lift are beams so stiff that they do not bend: reference values are sums over rigid
//! blades, by Gauss points, and momentum theory.

use std::f64::consts::PI;

use beam_dynamics::analysis::statics::statics;
use beam_dynamics::input;

use crate::in_time::Run;
use crate::record;

const DENSITY: f64 = 1.225;
const RADIUS: f64 = 5.0;
const SLOPE: f64 = 5.73;
const SOLIDITY: f64 = 0.06213;
/// Rotor speed [rad/s].
const SPEED: f64 = 30.0;

/// A rotor of `tests/reference/theory-rotor/aero_hover.json` with its angles and its solidity divided
/// by `scale`: the induced velocity over the tip speed is divided by it, and the thrust by its square.
#[derive(Clone, Copy)]
struct Rotor<'a> {
    kind: &'a str,
    scale: f64,
    pitch: f64,
    root: f64,
    /// Further lines of `[[inflow]]` and of `[[blade]]`.
    inflow: &'a str,
    blade: &'a str,
    /// Other tables.
    tables: &'a str,
    /// Mass of the blades [kg/m].
    mass: f64,
    /// Further lines of `[transient]`.
    settings: &'a str,
}

impl Default for Rotor<'_> {
    fn default() -> Self {
        Self {
            kind: "uniform",
            scale: 1.0,
            pitch: 8.0,
            root: 0.0,
            inflow: "",
            blade: "",
            tables: "",
            mass: 11.0,
            settings: "",
        }
    }
}

impl Rotor<'_> {
    fn chord(&self) -> f64 {
        SOLIDITY * PI * RADIUS / 4.0 / self.scale
    }

    /// Angle of the chord at a radius, nose up [rad].
    fn angle(&self, radius: f64) -> f64 {
        ((self.pitch - 8.0 * (radius / RADIUS - 0.75)) / self.scale).to_radians()
    }

    fn text(&self) -> String {
        let station = |radius: f64| {
            format!(
                "{{ at = {radius}, chord = {}, twist = {}, airfoil = \"linear\" }}",
                self.chord(),
                self.angle(radius).to_degrees()
            )
        };
        format!(
            "units = \"SI\"\n[properties.p]\nea = 7e13\ngay = 9e12\ngaz = 9e12\ngj = 8e12\n\
             eiy = 7e12\neiz = 7e12\nm = {:?}\niy = 0.001\niz = 0.001\n[airfoils.linear]\n\
             slope = {SLOPE}\n[[inflow]]\nname = \"rotor\"\nkind = \"{}\"\n{}\n[[blade]]\n\
             name = \"b\"\ncount = 4\nproperties = \"p\"\n{}\npiece = [{{ length = 5, \
             elements = 4 }}]\n[blade.aerodynamics]\ninflow = \"rotor\"\n\
             section = \"quasi_steady\"\nstrips = 4\nstations = [{}, {}]\n{}\n",
            self.mass,
            self.kind,
            self.inflow,
            self.blade,
            station(self.root),
            station(RADIUS),
            self.tables,
        )
    }

    /// Thrust of the equilibrium in the turning frame \[N\], from the reactions of the clamps.
    fn thrust(&self) -> f64 {
        let text = self.text() + "[static]\nspeed = \"30 rad/s\"\n";
        let input = input::parse(&text, "disk.dynamics.toml").unwrap_or_else(|all| panic!("{all}"));
        let outcome = statics(&input.model, &input.statics.unwrap());
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        let reactions = outcome.result.steps[0].reactions.iter();
        -reactions.map(|reaction| reaction.force.z).sum::<f64>()
    }

    /// Thrust by blade elements and `T = 2 rho pi R^2 u^2`, with a factor on the velocity at the blades
    /// and lift to a part of the radius.
    fn momentum(&self, factor: f64, end: f64) -> f64 {
        let disk = 2.0 * DENSITY * PI * RADIUS * RADIUS;
        let blades = |u: f64| {
            let (count, length) = (400, end * RADIUS - self.root);
            let gauss = 0.5 / 3f64.sqrt();
            let points = (0..count).flat_map(|cell| {
                [-gauss, gauss].map(|at| (f64::from(cell) + 0.5 + at) / f64::from(count))
            });
            let sum = points.map(|at| {
                let radius = self.root + length * at;
                let (through, around) = (factor * u, SPEED * radius);
                let flow = through.atan2(around);
                let lift = SLOPE * (self.angle(radius) - flow);
                (through * through + around * around) * lift * flow.cos()
            });
            let area = self.chord() * length / f64::from(2 * count);
            4.0 * 0.5 * DENSITY * area * sum.sum::<f64>()
        };
        let (mut low, mut high) = (0.0, SPEED * RADIUS);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if blades(middle) > disk * middle * middle {
                low = middle
            } else {
                high = middle
            }
        }
        disk * low * low
    }
}

/// The listed thrusts belong to small angles. With all angles divided by 20 the squares of angles are
/// 2e-3 / 400; the mass flow is rounded by 1e-5 of the tip speed, 1e-5 of the thrust. Listed values have
/// six digits after the point: .9e-3 of the smallest.
#[test]
fn hover_has_the_thrust_of_the_closed_form() {
    let path = "/tests/reference/theory-rotor/aero_hover.json";
    let text = std::fs::read_to_string(format!("{}{path}", env!("CARGO_MANIFEST_DIR"))).unwrap();
    let it: serde_json::Value = serde_json::from_str(&text).unwrap();
    let size = DENSITY * PI * RADIUS.powi(2) * (SPEED * RADIUS).powi(2);
    let scale = 20.0;
    for (pitch, listed) in it["uniform_inflow_rotor"]["CT"].as_object().unwrap() {
        let pitch: f64 = pitch.parse().unwrap();
        let (b, listed) = (0.5 * SOLIDITY * SLOPE, listed.as_f64().unwrap());
        let lambda = (-b / 2.0 + (b * b / 4.0 + 8.0 * b * pitch.to_radians() / 3.0).sqrt()) / 4.0;
        let exact = 2.0 * lambda * lambda;
        assert!((exact - listed).abs() < 6e-7, "{exact} {listed}");
        for kind in ["uniform", "Drees", "Pitt-Peters"] {
            let rotor = Rotor {
                kind,
                scale,
                pitch,
                ..Rotor::default()
            };
            let found = rotor.thrust() / size * scale * scale;
            let error = (found / exact - 1.0).abs();
            let case = format!("rotor in hover, pitch {pitch} deg, {kind}");
            let source = "blade elements and momentum theory";
            record::value(source, &case, "CT [-]", [found, exact], error, 1e-4);
            assert!(error < 1e-4, "{case}: {found} {exact}");
        }
    }
}

/// The rotor with the active twist at the listed pitches at three quarters of the radius: thrusts
/// in pounds with half of one as their last digit, 1.4e-4 of the smallest; and the pitches for 5133 pounds
/// with the root of the blades at a fifth or at .027 of the radius, of which half of the last digit,
/// 5e-4 degrees, is 1.3e-4 of the thrust. Angles are divided by 20, as above.
#[test]
fn hover_of_the_active_twist_rotor_has_the_listed_thrusts() {
    let path = "/tests/reference/theory-rotor/aero_hover.json";
    let text = std::fs::read_to_string(format!("{}{path}", env!("CARGO_MANIFEST_DIR"))).unwrap();
    let it: serde_json::Value = serde_json::from_str(&text).unwrap();
    let it = &it["atr"];
    let list = |value: &serde_json::Value| -> Vec<f64> {
        let items = value.as_array().unwrap().iter();
        items.map(|item| item.as_f64().unwrap()).collect()
    };
    let listed = it["thrust_lb_theta75"].as_object().unwrap().iter();
    let listed =
        listed.map(|(pitch, thrust)| (pitch.parse().unwrap(), 0.0, thrust.as_f64().unwrap()));
    let hover = &it["hover_with_thrust_5133"];
    let needed = list(&hover["theta75_deg"]);
    let needed = needed.into_iter().zip(list(&hover["root_cutout"]));
    let target = it["thesis_thrust"].as_f64().unwrap();
    let rows: Vec<(f64, f64, f64)> = listed
        .chain(needed.map(|(pitch, root)| (pitch, root, target)))
        .collect();
    // Slugs per cubic foot, feet, and radians per second.
    let (density, radius, speed) = (it["rho_air"].as_f64().unwrap(), 28.0, 22.25);
    let pounds = density * PI * f64::powi(radius, 2) * f64::powi(speed * radius, 2);
    let size = DENSITY * PI * RADIUS.powi(2) * (SPEED * RADIUS).powi(2);
    let scale = 20.0;
    for (pitch, root, expected) in rows {
        let rotor = Rotor {
            scale,
            pitch,
            root: root * RADIUS,
            ..Rotor::default()
        };
        let found = rotor.thrust() / size * scale * scale * pounds;
        let error = (found / expected - 1.0).abs();
        let case = format!("active-twist rotor in hover, pitch {pitch} deg, root at {root} R");
        let source = "independent program (aero_hover.json)";
        record::value(source, &case, "thrust [lb]", [found, expected], error, 3e-4);
        assert!(error < 3e-4, "{case}: {found} {expected}");
    }
    // Annuli with the loss at the tip, with the angles as they are (hover_atr.json).
    let rotor = Rotor {
        kind: "annular momentum",
        pitch: 4.0,
        root: 0.027 * RADIUS,
        inflow: "hub_loss = false\nswirl = false\n",
        ..Rotor::default()
    };
    let (found, expected) = (rotor.thrust() / size * pounds, 3679.0);
    let error: f64 = (found / expected - 1.0).abs();
    let case = "active-twist rotor in hover, pitch 4 deg, annuli with the loss at the tip";
    let source = "independent program (hover_atr.json)";
    record::value(source, case, "thrust [lb]", [found, expected], error, 5e-3);
    assert!(error < 5e-3, "{case}: {found} {expected}");
}

/// With the angles as they are, the thrust of the strips is the momentum of the disk: Gauss points of
/// the strips and of the reference differ by less than 1e-9; the mass flow is rounded by 1e-5 of the tip
/// speed, of an induced velocity of .045 of it: 2.5e-8.
#[test]
fn thrust_is_the_momentum_of_the_disk() {
    let ground = |height: f64| 1.0 - (RADIUS / (4.0 * height)).powi(2);
    for (rotor, factor, end) in [
        (Rotor::default(), 1.0, 1.0),
        (
            Rotor {
                inflow: "effective_radius = 0.97\n",
                ..Rotor::default()
            },
            1.0,
            0.97,
        ),
        (
            Rotor {
                inflow: "ground = -4\n",
                ..Rotor::default()
            },
            ground(4.0),
            1.0,
        ),
    ] {
        let rotor = Rotor { root: 1.0, ..rotor };
        let (found, expected) = (rotor.thrust(), rotor.momentum(factor, end));
        let error = (found / expected - 1.0).abs();
        let case = format!("rotor in hover, {}", rotor.inflow.trim());
        let source = "momentum theory";
        record::value(source, &case, "thrust [N]", [found, expected], error, 1e-6);
        assert!(error < 1e-6, "{case}: {found} {expected}");
    }
}

/// Momentum of each annulus without losses and swirl, with the factor k of the ground on the velocity at
/// the blades: `4 pi r rho u^2 = B l cos(phi)`, `tan(phi) = k u / (Omega r)`. The mass flow is rounded
/// by 1e-3 m/s, of 2 m/s and more.
#[test]
fn annuli_above_the_ground_have_its_factor() {
    let root = 0.5;
    for (inflow, factor) in [("", 1.0), ("ground = -4\n", 1.0 - (RADIUS / 16.0).powi(2))] {
        let rotor = Rotor {
            kind: "annular momentum",
            root,
            inflow: &format!("{inflow}tip_loss = false\nhub_loss = false\nswirl = false\n"),
            ..Rotor::default()
        };
        let cells = 1000;
        let width = (RADIUS - root) / f64::from(cells);
        let sum = (0..cells).map(|cell| {
            let radius = root + width * (f64::from(cell) + 0.5);
            let lift = |u: f64| {
                let (through, around) = (factor * u, SPEED * radius);
                let flow = through.atan2(around);
                let pressure = 0.5 * DENSITY * (through * through + around * around);
                4.0 * pressure * rotor.chord() * SLOPE * (rotor.angle(radius) - flow) * flow.cos()
            };
            let (mut low, mut high) = (0.0, SPEED * RADIUS);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if lift(middle) > 4.0 * PI * radius * DENSITY * middle * middle {
                    low = middle
                } else {
                    high = middle
                }
            }
            lift(low) * width
        });
        let (found, expected) = (rotor.thrust(), sum.sum::<f64>());
        let error = (found / expected - 1.0).abs();
        let case = format!("annuli in hover, {}", inflow.trim());
        let source = "momentum of annuli";
        record::value(source, &case, "thrust [N]", [found, expected], error, 1e-5);
        assert!(error < 1e-5, "{case}: {found} {expected}");
    }
}

/// Two rotors on one shaft, each with its own inflow, have the thrust of each alone.
#[test]
fn each_rotor_has_its_own_inflow() {
    let half = Rotor {
        blade: "azimuths = [0, 180]\n",
        root: 0.5,
        ..Rotor::default()
    };
    let text = half.text().replace("count = 4\n", "");
    let one = |text: &str| {
        let text = text.to_owned() + "[static]\nspeed = \"30 rad/s\"\n";
        let input = input::parse(&text, "disk.dynamics.toml").unwrap_or_else(|all| panic!("{all}"));
        let outcome = statics(&input.model, &input.statics.unwrap());
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        let reactions = outcome.result.steps[0].reactions.iter();
        -reactions.map(|reaction| reaction.force.z).sum::<f64>()
    };
    let alone = one(&text);
    let blade = text.find("[[blade]]").unwrap();
    let second = text[blade..]
        .replace("name = \"b\"", "name = \"c\"")
        .replace("[0, 180]", "[90, 270]")
        .replace("inflow = \"rotor\"", "inflow = \"lower\"");
    let lower = "[[inflow]]\nname = \"lower\"\nkind = \"uniform\"\n";
    let both = one(&format!(
        "{}{lower}{}{second}",
        &text[..blade],
        &text[blade..]
    ));
    assert!((both / alone - 2.0).abs() < 1e-9, "{both} {alone}");
    // All four in one disk have less thrust each.
    let shared = one(&(text.clone() + &second.replace("\"lower\"", "\"rotor\"")));
    assert!(shared < 1.8 * alone, "{shared} {alone}");
}

/// A hub with a bearing that a joint turns at the speed of the run.
const DRIVEN: &str = "[hub]\nmass = 10\ninertia = [1, 1, 1]\nsupport = { torsion = 0 }\n[[joint]]\n\
    name = \"drive\"\nkind = \"spin\"\nnodes = [\"hub\"]\naxis = [0, 0, 1]\nangle = \"= 1800 * t\"\n";

/// Speed of the run in time [rad/s].
const TURN: f64 = 10.0 * PI;

/// Index of the thrust and of the first state among the unknowns of the disk, which come first.
const THRUST: usize = 4;
const MEAN: usize = 7;

fn in_time(rotor: Rotor<'_>, (end, step): (f64, f64), start: &str) -> Run {
    let text = rotor.text()
        + DRIVEN
        + &format!("[transient]\nto = {end}\nstep = {step}\nstart = \"{start}\"\nspeed = 300\n")
        + rotor.settings;
    let input = input::parse(&text, "disk.dynamics.toml").unwrap_or_else(|all| panic!("{all}"));
    let run = Run::of(input.model, &input.transient.unwrap(), 1);
    run.check_end();
    run
}

/// An articulated rotor stays in hover: the thrust of the strips is the momentum of the disk in every
/// step, to the residual at which the iteration ends (1.5e-8 of the thrust seen), and both have
/// the value of the closed form. 600 steps a revolution: the error of the two-step formula is a part of `(Omega h)^2`, 1.1e-4, in velocities.
#[test]
fn an_articulated_rotor_stays_in_hover() {
    for kind in ["uniform", "Pitt-Peters"] {
        let rotor = Rotor {
            kind,
            scale: 20.0,
            blade: "hinges = [{ kind = \"flap\", offset = 0 }]",
            ..Rotor::default()
        };
        let run = in_time(rotor, (0.1, 1.0 / 3000.0), "rotating");
        let b = 0.5 * SOLIDITY * SLOPE;
        let theta = 8f64.to_radians();
        let lambda = (-b / 2.0 + (b * b / 4.0 + 8.0 * b * theta / 3.0).sqrt()) / 4.0 / 20.0;
        let disk = 2.0 * DENSITY * PI * RADIUS * RADIUS;
        let expected = disk * (lambda * TURN * RADIUS).powi(2);
        let mut errors = [0.0f64; 2];
        for (_, state) in &run.instants {
            let (thrust, mean) = (state.scalars[THRUST], state.scalars[MEAN]);
            errors[0] = errors[0].max((thrust / expected - 1.0).abs());
            // Momentum, with the rounding of the mass flow, 1e-5 of the tip speed.
            let flow = mean.hypot(1e-5 * TURN * RADIUS);
            let rate = state.scalar_rates[MEAN];
            let lag = 8.0 / (3.0 * PI) * DENSITY * PI * RADIUS.powi(3) * rate;
            errors[1] = errors[1].max(((disk * mean * flow + lag) / thrust - 1.0).abs());
        }
        let case = format!("articulated rotor in hover in time, {kind}");
        let source = "closed form of hover";
        for (name, error, limit) in [
            ("thrust, relative", errors[0], 1e-4),
            ("thrust of the strips over momentum", errors[1], 1e-7),
        ] {
            record::largest(source, &case, name, error, limit);
            assert!(error < limit, "{case}: {name} {error:e}");
        }
    }
}

/// Hover in time by the closed form to 1e-6 (found: 6e-7). All angles are divided by 100, so that their
/// squares are below 2e-6 (of the flow over the blade: 2e-7), and the rounding of the mass flow, 1e-5 of
/// the tip speed, is in the equation, `2 l sqrt(l^2 + 1e-10) = B (theta/3 - l/2)`. Heavy blades hardly
/// cone: the rotation of a coned section about its span is not in the closed form, and changes it by some
/// 1e-7, as does the stretch of the blades. The velocities of Radau IIA under the constraint of the drive
/// are of second order, .35 (Omega h)^2: 2.7e-7 with 7200 steps a revolution, of which 20 are done.
#[test]
fn an_articulated_rotor_has_the_thrust_of_the_closed_form() {
    for (kind, pitch) in [("uniform", 4.0f64), ("uniform", 8.0), ("Pitt-Peters", 8.0)] {
        let rotor = Rotor {
            kind,
            pitch,
            scale: 100.0,
            mass: 1e3,
            blade: "hinges = [{ kind = \"flap\", offset = 0 }]",
            settings: "scheme = \"radau-iia\"\nnewton.tolerance = 1e-12\n",
            ..Rotor::default()
        };
        let run = in_time(rotor, (1.0 / 1800.0, 1.0 / 36000.0), "rotating");
        let (b, theta) = (0.5 * SOLIDITY * SLOPE / 100.0, pitch.to_radians() / 100.0);
        let mut lambda = (-b / 2.0 + (b * b / 4.0 + 8.0 * b * theta / 3.0).sqrt()) / 4.0;
        for _ in 0..20 {
            let flow = lambda.hypot(1e-5);
            let excess = 2.0 * lambda * flow - b * (theta / 3.0 - 0.5 * lambda);
            lambda -= excess / (2.0 * flow + 2.0 * lambda * lambda / flow + 0.5 * b);
        }
        let tip = TURN * RADIUS;
        let thrust = DENSITY * PI * (RADIUS * tip).powi(2) * b * (theta / 3.0 - 0.5 * lambda);
        let case = format!("articulated rotor in hover in time, {kind}, pitch {pitch} deg, small");
        for (name, index, expected) in [
            ("thrust, relative", THRUST, thrust),
            ("induced velocity, relative", MEAN, lambda * tip),
        ] {
            let errors = run.instants.iter();
            let errors = errors.map(|(_, state)| (state.scalars[index] / expected - 1.0).abs());
            let error = errors.fold(0.0, f64::max);
            record::largest("closed form of hover", &case, name, error, 1e-6);
            assert!(error < 1e-6, "{case}: {name} {error:e}");
        }
    }
}

/// Three states of the inflow in forward flight at mu = .2, hingeless blades (`aero_hover.json`, an
/// independent program with small angles and 60 explicit steps a revolution). Its angles reach .2 rad at
/// the roots: .5 %.
#[test]
fn three_states_in_forward_flight() {
    let speed = 0.2 * TURN * RADIUS;
    let tables = format!("[air]\nwind = [{speed}, 0, 0]\n");
    let rotor = Rotor {
        kind: "Pitt-Peters",
        tables: &tables,
        ..Rotor::default()
    };
    let run = in_time(rotor, (0.8, 1.0 / 300.0), "rotating");
    let last = &run.instants[run.instants.len() - 60..];
    let mean = |index: usize| {
        last.iter()
            .map(|(_, state)| state.scalars[index])
            .sum::<f64>()
            / last.len() as f64
    };
    let tip = TURN * RADIUS;
    let size = DENSITY * PI * RADIUS.powi(2) * tip * tip;
    // The axes of the disk: e_1 is along x, downwind, so that e_2 is the advancing side.
    for (name, found, expected) in [
        ("CT [-]", mean(THRUST) / size, 0.00700486),
        ("mean inflow [-]", mean(MEAN) / tip, 0.01908491),
        (
            "inflow, advancing side [-]",
            mean(MEAN + 2) / tip,
            0.01914706,
        ),
        ("inflow, aft [-]", mean(MEAN + 1) / tip, 0.02248267),
    ] {
        let error = (found / expected - 1.0).abs();
        let source = "independent program (aero_hover.json)";
        let case = "rigid rotor in forward flight in time";
        record::value(source, case, name, [found, expected], error, 1e-2);
        assert!(error < 1e-2, "{name}: {found} {expected}");
    }
}

/// In axial flow the skew changes nothing but for a flow across the shaft of 1e-6 m/s, by which the
/// direction of the wake is defined: 1e-6 of an induced velocity of 6 m/s; in yaw the side to which the wake leaves has more induced
/// velocity and less thrust.
#[test]
fn yaw_moves_the_thrust_to_the_windward_side() {
    let rotor = |inflow| Rotor {
        kind: "annular momentum",
        root: 0.5,
        inflow,
        ..Rotor::default()
    };
    let (plain, skewed) = (rotor("").thrust(), rotor("skew = true").thrust());
    assert!((plain / skewed - 1.0).abs() < 1e-6, "{plain} {skewed}");
    let tables = "[air]\nwind = [4, 0, -4]\n";
    let rotor = Rotor {
        tables,
        pitch: 12.0,
        ..rotor("skew = true")
    };
    let run = in_time(rotor, (0.1, 1.0 / 600.0), "rotating");
    let last = &run.instants[run.instants.len() - 15..];
    let aft: f64 = last
        .iter()
        .map(|(_, state)| state.scalars[THRUST + 1])
        .sum();
    let thrust: f64 = last.iter().map(|(_, state)| state.scalars[THRUST]).sum();
    let arm = aft / thrust / RADIUS;
    assert!((-0.2..-0.01).contains(&arm), "{arm}");
}

/// Asserts that a line of an inflow of a kind is refused with some words.
fn assert_refused(lines: &[[&str; 3]]) {
    for [kind, line, expected] in lines {
        let rotor = Rotor {
            kind,
            inflow: line,
            ..Rotor::default()
        };
        let problems = input::parse(&rotor.text(), "disk.dynamics.toml").unwrap_err();
        let text = problems.to_string();
        assert!(text.contains(expected), "{kind} {line}: {text}");
    }
}

#[test]
fn keys_of_other_kinds_are_refused() {
    assert_refused(&[
        [
            "uniform",
            "tip_loss = true",
            "\"tip_loss\", which belongs to kind = \"annular momentum\"",
        ],
        [
            "annular momentum",
            "radius = 4",
            "\"radius\", which belongs to a model of the disk",
        ],
        [
            "annular momentum",
            "ground = 0.5",
            "has its ground at 0.5 m along the vertical, and the center of the rotor is at 0 m",
        ],
        [
            "annular momentum",
            "forcing = \"steady\"",
            "\"forcing\", which belongs to wake = \"dynamic\" or \"hover\"",
        ],
        [
            "annular momentum",
            "wake = \"frozen\"\nforcing = \"lagged\"",
            "\"forcing\", which belongs to wake = \"dynamic\" or \"hover\"",
        ],
        [
            "Drees",
            "forcing = \"steady\"",
            "\"forcing\", which belongs to kind = \"annular momentum\"",
        ],
        [
            "annular momentum",
            "hub_loss = false\nhub_radius = 0.5",
            "\"hub_radius\", which belongs to hub_loss = true",
        ],
        [
            "annular momentum",
            "swirl = false\ntangential_drag = false",
            "\"tangential_drag\", which belongs to swirl = true",
        ],
    ]);
}

#[test]
fn wrong_values_of_inflows_are_refused() {
    assert_refused(&[
        ["Drees", "effective_radius = 1.2", "expected at most 1"],
        [
            "uniform",
            "hub = \"masts\"",
            "unknown node \"masts\" in inflow \"rotor\"",
        ],
        [
            "uniform",
            "axis = [0, 0, 1]",
            "\"axis\", which belongs to a \"hub\"",
        ],
        [
            "uniform",
            "ground = 4.5",
            "has its ground at 4.5 m along the vertical, and the center of the rotor is at 0 m",
        ],
        ["Drees", "ground = 0", "is a coordinate, not a height"],
        ["dress", "", "did you mean \"Drees\""],
    ]);
}

/// Rotors in wind across the shaft start with every model of sections: the momentum of an added mass
/// follows from the motion and the inflow. After half a turn the blades flap as with steady sections to
/// 7 %: at the reduced frequency 0.3/(2 x 3.75) of a revolution Theodorsen's function is 0.93.
#[test]
fn sections_with_states_start_in_the_inflow_of_a_disk() {
    let file = "cases/dynamics/rotor_trim/rotor_trim.dynamics.toml";
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    let text = std::fs::read_to_string(&path).unwrap();
    let (model, _) = text.split_once("[periodic]").unwrap();
    let (model, _) = model.split_once("[sensors.flap]").unwrap();
    let settings = "\n[drives]\ncollective = { kind = \"constant\", value = 3 }\n\
                    cosine = { kind = \"constant\", value = 0 }\n\
                    sine = { kind = \"constant\", value = 0 }\n\
                    [transient]\nto = 0.1\nstep = 0.0025\n";
    let flapped = |section: &str, kind: &str| {
        let text = model.replace("\"quasi_steady\"", &format!("\"{section}\""));
        let text = text.replace("kind = \"uniform\"", &format!("kind = \"{kind}\""));
        let input = input::parse(&(text + settings), &path).unwrap_or_else(|e| panic!("{e}"));
        let run = Run::of(input.model, &input.transient.unwrap(), 1);
        run.check_end();
        run.motion("main 1/tip", 0.1).position.z
    };
    for kind in ["uniform", "Drees", "Pitt-Peters"] {
        let steady = flapped("quasi_steady", kind);
        for section in ["lagged", "separation_lag", "dynamic_stall"] {
            let found = flapped(section, kind);
            println!("{kind}, {section}: {found} m, {steady} m");
            assert!((found / steady - 1.0).abs() < 0.07, "{found} {steady}");
        }
    }
}

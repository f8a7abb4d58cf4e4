//! Piezoelectric beams against closed forms: voltages that bend, twist and stretch, charges,
//! open circuits, shunts, in statics, modes, time and rotation.
//!
//! A rod of length L along x with stiffness EA, mass m per length, coupling theta (force per volt)
//! and capacitance c per length, electrode over the whole length, clamped at x = 0 and free at x =
//! L, has with `N = EA u' + theta V`, `Q = -theta u(L) + c L V`, `N(L) = 0` and `u = sinh(g x)
//! exp(s t)`, `g = s sqrt(m/EA)`, the eigenvalues s of
//!
//! ```text
//! EA g cosh(g L) + theta V(s) / u0 = 0         u0 the amplitude of u(L) / sinh(g L)
//! short circuit    V = 0
//! open circuit     V = theta u(L) / (c L)
//! shunt            V = s Z theta u(L) / (1 + c L s Z),   Z = R + s L_coil
//! ```

use beam_dynamics::analysis::buckling::buckling;
use beam_dynamics::analysis::modes::modes;
use beam_dynamics::analysis::statics::statics;
use beam_dynamics::case::Model;
use beam_dynamics::elements::ElectrodeState;
use beam_dynamics::input::{self, Input};
use beam_dynamics::model::{Conditions, State};
use beam_dynamics::result::{ModePoint, StaticStep};
use nalgebra::{Complex, DMatrix, Matrix3x6, Matrix6, Vector2, Vector3, Vector6};
use shared_geom::rotation::vector;
use shared_geom::section::{self, Centers, Engineering, Piezo, Provenance, SectionProperties};
use tempfile::TempDir;

use crate::in_time::Run;
use crate::record;

const CLOSED: &str = "Piezoelectric beams, closed forms";

/// `[EA, GAy, GAz, GJ, EIy, EIz]` of a soft beam.
const SOFT: [f64; 6] = [2.4e5, 9e4, 8e4, 0.3, 0.5, 20.0];
/// Of a rod whose lowest modes are axial.
const ROD: [f64; 6] = [2.4e5, 1e7, 1e7, 1e6, 1e6, 1e6];
/// Axial force per volt [N/V], and capacitance per length [F/m]: `theta^2 / EA c` is 0.3025.
const PULL: f64 = -0.33;
const CAPACITANCE: f64 = 1.5e-6;
/// Moment about y [N m/V], and twisting moment.
const BEND: f64 = 2e-4;
const TWIST: f64 = -1.2e-4;
const LENGTH: f64 = 1.0;
const MASS: f64 = 0.05;

fn section(stiffness: [f64; 6], mass: [f64; 3]) -> SectionProperties {
    let written = Engineering {
        stiffness,
        mass,
        centers: Centers {
            tension: Vector2::zeros(),
            shear: Vector2::zeros(),
            mass: Vector2::zeros(),
        },
        stiffness_angle: 0.0,
        inertia_angle: 0.0,
    };
    let column = |component: usize, value: f64| {
        let mut column = Vector6::zeros();
        column[component] = value;
        column
    };
    let columns = [column(0, PULL), column(4, BEND), column(3, TWIST)];
    SectionProperties {
        piezo: Some(Piezo {
            electrodes: ["pull", "bend", "twist"].map(str::to_owned).to_vec(),
            coupling: DMatrix::from_fn(6, 3, |i, j| columns[j][i]),
            capacitance: DMatrix::from_diagonal_element(3, 3, CAPACITANCE),
        }),
        ..written.section("beam", Provenance::default())
    }
}

fn soft() -> SectionProperties {
    section(SOFT, [MASS, 1e-6, 2e-5])
}

fn rod() -> SectionProperties {
    section(ROD, [MASS, 1e-6, 1e-6])
}

/// Stiffness, coupling and capacitance with all their entries, of different sizes.
fn coupled() -> SectionProperties {
    let mut section = soft();
    let sizes = Vector6::from(SOFT).map(f64::sqrt);
    let wave = |i: usize| (1.7 + 2.3 * i as f64).sin();
    let unit = Matrix6::from_fn(|i, j| wave(6 * i + j));
    let unit = Matrix6::identity() + 0.08 * (unit + unit.transpose());
    section.stiffness = Matrix6::from_fn(|i, j| sizes[i] * unit[(i, j)] * sizes[j]);
    let coupling = DMatrix::from_fn(6, 3, |i, j| 3e-4 * sizes[i] * wave(40 + 6 * j + i));
    let capacitance = [
        [1.5e-6, -2e-7, 1e-7],
        [-2e-7, 2e-6, 3e-7],
        [1e-7, 3e-7, 1e-6],
    ];
    section.piezo = Some(Piezo {
        electrodes: ["pull", "bend", "twist"].map(str::to_owned).to_vec(),
        coupling,
        capacitance: DMatrix::from_fn(3, 3, |i, j| capacitance[i][j]),
    });
    section
}

/// A blade of the section in a separate folder, with further cards.
fn folder(section: &SectionProperties, elements: usize, cards: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("beam.properties.json");
    std::fs::write(file, section::write(section)).unwrap();
    let text = format!(
        r#"
units = "SI"
[properties.beam]
file = "beam.properties.json"
[[blade]]
name = "beam"
properties = "beam"
[[blade.piece]]
length = {LENGTH}
elements = {elements}
{cards}"#
    );
    std::fs::write(folder.path().join("a.dynamics.toml"), text).unwrap();
    folder
}

fn read(section: &SectionProperties, elements: usize, cards: &str) -> Input {
    let folder = folder(section, elements, cards);
    let file = folder.path().join("a.dynamics.toml");
    input::read(&file).unwrap_or_else(|problems| panic!("{problems}"))
}

/// A card of an electrode of the property file.
fn electrode(name: &str, circuit: &str) -> String {
    format!("[[electrode]]\nname = \"{name}\"\nblade = \"beam\"\n{circuit}\n")
}

fn equilibrium(section: &SectionProperties, elements: usize, cards: &str) -> StaticStep {
    let input = read(section, elements, &format!("{cards}[static]\n"));
    let outcome = statics(&input.model, &input.statics.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    outcome.result.last().unwrap().clone()
}

fn check(case: &str, quantity: &str, pair: [f64; 2], tolerance: f64) {
    let error = (pair[0] / pair[1] - 1.0).abs();
    println!("{case}, {quantity}: {pair:?} {error:e}");
    record::value(CLOSED, case, quantity, pair, error, tolerance);
    assert!(error < tolerance, "{case}, {quantity}: {pair:?} {error:e}");
}

/// A voltage on the bending electrode bends the cantilever into a circle of curvature `-theta V /
/// EI`, without internal force (EA times round-off of strains), and the charge of the electrode is
/// `(c + theta^2 / EI) V L`. Strains of a beam without loads do not change along it, and such a
/// beam is exact up to the fourth power of the angle of an element, 0.04/12.
#[test]
fn a_voltage_bends_a_cantilever_to_a_circle() {
    let volts = 100.0;
    let step = equilibrium(&soft(), 12, &electrode("bend", "voltage = 100"));
    let curvature = -BEND * volts / SOFT[4];
    let angle = curvature * LENGTH;
    let tip = step.positions.last().unwrap();
    let case = "cantilever bent by 100 V";
    let height = -(1.0 - angle.cos()) / curvature;
    check(case, "tip deflection [m]", [tip.z, height], 1e-9);
    // M V L^2 / 2EI, of small angles: relative to it (kappa L)^2 / 12
    let small = -0.5 * curvature * LENGTH * LENGTH;
    assert!((tip.z / small - 1.0).abs() < angle * angle / 11.0);
    let turn = vector::from_rotation(step.rotations.last().unwrap());
    check(case, "tip rotation [rad]", [turn.y, angle], 1e-11);
    let charge = (CAPACITANCE + BEND * BEND / SOFT[4]) * volts * LENGTH;
    check(
        case,
        "charge [C]",
        [step.electrodes[0].charge, charge],
        1e-11,
    );
    assert_eq!(step.electrodes[0].voltage, volts);
    for section in &step.sections {
        assert!(
            section.internal_force.amax() < 1e-8,
            "{}",
            section.internal_force
        );
    }
}

/// A voltage that bends the cantilever to a quarter of a circle: its equilibrium is far from the
/// undeformed beam, and is found by raising the voltage. Error: the fourth power of the angle of an
/// element, 0.2, over some hundreds.
#[test]
fn a_voltage_bends_a_cantilever_to_a_quarter_of_a_circle() {
    let angle = std::f64::consts::FRAC_PI_2;
    let volts = -angle / LENGTH * SOFT[4] / BEND;
    let card = electrode("bend", &format!("voltage = {volts}"));
    let step = equilibrium(&soft(), 8, &card);
    let turn = vector::from_rotation(step.rotations.last().unwrap());
    let case = "cantilever bent to a quarter of a circle";
    check(case, "tip rotation [rad]", [turn.y, angle], 1e-6);
    let tip = step.positions.last().unwrap();
    let height = -(1.0 - angle.cos()) * LENGTH / angle;
    check(case, "tip deflection [m]", [tip.z, height], 1e-5);
}

/// Free twist `-theta V / GJ`, and with full coupling the strain `-K^-1 theta V` at every point and
/// its twist along the blade, from several electrodes at once.
#[test]
fn free_strains_are_those_of_the_section() {
    let step = equilibrium(&soft(), 8, &electrode("twist", "voltage = 250"));
    let turn = vector::from_rotation(step.rotations.last().unwrap());
    let twist = -TWIST * 250.0 * LENGTH / SOFT[3];
    check(
        "blade twisted by 250 V",
        "tip twist [rad]",
        [turn.x, twist],
        1e-11,
    );

    let section = coupled();
    let cards = [("pull", 60.0), ("bend", -40.0), ("twist", 30.0)];
    let written = cards.map(|(name, volts)| electrode(name, &format!("voltage = {volts}")));
    let step = equilibrium(&section, 8, &written.concat());
    let coupling = &section.piezo.as_ref().unwrap().coupling;
    let volts = nalgebra::DVector::from_iterator(3, cards.iter().map(|card| card.1));
    let force = Vector6::from_column_slice((coupling * volts).as_slice());
    let free = -section.stiffness.try_inverse().unwrap() * force;
    assert!(free[3].abs() > 1e-3, "{free}");
    // relative to the largest of its kind: strain, curvature
    let mut worst = 0.0_f64;
    for found in &step.sections {
        let difference = found.strain - free;
        let part = |first: usize| {
            let size = free.fixed_rows::<3>(first).amax();
            difference.fixed_rows::<3>(first).amax() / size
        };
        worst = worst.max(part(0)).max(part(3));
    }
    println!("{worst:e}");
    assert!(worst < 1e-9, "{worst:e}");
    let case = "coupled blade, three electrodes";
    record::largest(CLOSED, case, "free strain", worst, 1e-9);
    // both evaluation points of an element represent a half of it
    let half = 0.5 * LENGTH / 8.0;
    let sum: f64 = step
        .sections
        .iter()
        .map(|found| half * found.strain[3])
        .sum();
    check(case, "twist along it [rad]", [sum, free[3] * LENGTH], 1e-9);
}

/// A rod that is pulled at constant charge is stiffer by `theta^2 / c`, and its voltage shows the
/// pull, `theta e / c`; with a charge it is longer without a pull.
#[test]
fn an_open_rod_is_stiffer() {
    const TOLERANCE: f64 = 1e-11;
    let stiffer = ROD[0] + PULL * PULL / CAPACITANCE;
    let load = "[[load]]\nnode = \"beam/tip\"\nforce = [24, 0, 0]\n";
    for (case, circuit, load, force) in [
        ("pulled open rod", "charge = 0", load, 24.0),
        (
            "open rod with 200 uC",
            "charge = \"200 uC\"",
            "",
            -PULL * 2e-4 / (CAPACITANCE * LENGTH),
        ),
    ] {
        let cards = [&electrode("pull", circuit), load].concat();
        let step = equilibrium(&rod(), 4, &cards);
        let strain = force / stiffer;
        let tip = step.positions.last().unwrap().x - LENGTH;
        check(case, "elongation [m]", [tip, strain * LENGTH], TOLERANCE);
        let ElectrodeState {
            voltage, charge, ..
        } = &step.electrodes[0];
        let held = if load.is_empty() { 2e-4 } else { 0.0 };
        let expected = (held / LENGTH + PULL * strain) / CAPACITANCE;
        check(case, "voltage [V]", [*voltage, expected], TOLERANCE);
        // round-off of terms of about 1e-4 C
        assert!((charge - held).abs() < 1e-16, "{charge:e}");
    }
}

/// Axial modes of the rod with a circuit, the lowest first.
fn axial_modes(elements: usize, circuit: &str, count: usize) -> Vec<ModePoint> {
    let cards = electrode("pull", circuit) + "[modes]\nspeeds = [0]\ncount = 8\n";
    let input = read(&rod(), elements, &cards);
    let outcome = modes(&input.model, &input.modes.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let points = outcome.table.branches.into_iter();
    let points = points.filter_map(|mut branch| branch.points.swap_remove(0));
    let axial = points.filter(|point| point.shares[3] > 0.9);
    axial.take(count).collect()
}

/// The eigenvalue near `guess` of the rod in a circuit of the impedance `Z(s)`; `None` for
/// an open one.
fn eigenvalue(guess: Complex<f64>, impedance: Option<[f64; 2]>) -> Complex<f64> {
    let lack = |s: Complex<f64>| {
        let g = s * (MASS / ROD[0]).sqrt();
        let u = (g * LENGTH).sinh();
        let volts = match impedance {
            None => PULL / (CAPACITANCE * LENGTH) * u,
            Some([resistance, inductance]) => {
                let z = s * (resistance + s * inductance);
                z * PULL * u / (z * CAPACITANCE * LENGTH + 1.0)
            }
        };
        ROD[0] * g * (g * LENGTH).cosh() + PULL * volts
    };
    let mut s = guess;
    for _ in 0..60 {
        let h = 1e-6 * s.norm();
        let slope = (lack(s + h) - lack(s - h)) / (2.0 * h);
        s -= lack(s) / slope;
    }
    s
}

fn wave() -> f64 {
    (ROD[0] / MASS).sqrt() / LENGTH
}

/// Axial frequencies at short and at open circuit: for elements with a middle node they converge
/// with the fourth power of their length, by 16 with twice the elements. The second mode has seven
/// elements in a quarter wave: (pi/2/8)^4/720 is 2e-6.
#[test]
fn axial_modes_at_short_and_open_circuit() {
    const TOLERANCE: f64 = 2e-6;
    let quarter = 0.5 * std::f64::consts::PI;
    for (case, circuit, impedance) in [
        ("rod at short circuit", "voltage = 0", Some([0.0; 2])),
        ("rod at open circuit", "charge = 0", None),
    ] {
        let pair = [12, 24].map(|elements| axial_modes(elements, circuit, 2));
        for mode in 0..2 {
            let guess = wave() * quarter * (2.0 * mode as f64 + 1.15);
            let exact = eigenvalue(Complex::new(0.0, guess), impedance);
            let exact = exact.im / (2.0 * std::f64::consts::PI);
            let errors = pair
                .each_ref()
                .map(|found| found[mode].frequency / exact - 1.0);
            println!("{case} {mode} {exact} {errors:?}");
            let quantity = format!("axial frequency {} [Hz]", mode + 1);
            check(case, &quantity, [pair[1][mode].frequency, exact], TOLERANCE);
            let order = (errors[0] / errors[1]).log2();
            record::order(
                CLOSED,
                case,
                &format!("order, mode {}", mode + 1),
                order,
                3.9,
            );
            assert!(order > 3.9, "{order}");
        }
    }
}

/// Damped modes with a resistor of maximum dissipation, about `R c L w = 1`, and with a resonant
/// shunt, which splits the mode in two. As exact as the frequencies at short circuit.
#[test]
fn shunts_damp_the_modes() {
    const TOLERANCE: f64 = 1e-6;
    let w = wave() * 1.7;
    let capacitance = CAPACITANCE * LENGTH;
    let resistance = 1.0 / (capacitance * w);
    let coil = 1.0 / (capacitance * w * w);
    for (case, shunt, guesses) in [
        (
            "rod with a resistor",
            [resistance, 0.0],
            vec![Complex::new(-0.1 * w, w)],
        ),
        (
            "rod with a resonant shunt",
            [0.2 * resistance, coil],
            vec![
                Complex::new(-0.05 * w, 0.75 * w),
                Complex::new(-0.05 * w, 1.3 * w),
            ],
        ),
    ] {
        let circuit = format!("resistance = {}\ninductance = {}", shunt[0], shunt[1]);
        let circuit = if shunt[1] > 0.0 {
            circuit
        } else {
            circuit.split('\n').next().unwrap().to_owned()
        };
        let found = axial_modes(24, &circuit, guesses.len());
        assert_eq!(found.len(), guesses.len());
        for (guess, point) in guesses.into_iter().zip(found) {
            let exact = eigenvalue(guess, Some(shunt));
            assert!(exact.re < -0.01 * w, "{exact}");
            let found = Complex::new(point.growth, 2.0 * std::f64::consts::PI * point.frequency);
            let error = (found - exact).norm() / exact.norm();
            println!("{case}: {found} {exact} {error:e}");
            let ratio = [point.damping_ratio, -exact.re / exact.norm()];
            record::value(CLOSED, case, "damping ratio [-]", ratio, error, TOLERANCE);
            assert!(error < TOLERANCE, "{case}: {found} {exact}");
        }
    }
}

fn electrodes_at(run: &Run, time: f64, state: &State) -> Vec<ElectrodeState> {
    run.model
        .system
        .electrodes(state, &run.model.conditions_at(time))
}

fn run(section: &SectionProperties, elements: usize, cards: &str) -> Run {
    let folder = folder(section, elements, cards);
    let run = Run::of_file(&folder.path().join("a.dynamics.toml"), 1, |_| {});
    run.check_end();
    let balance = run.outcome.energy;
    let apart = balance.growth - balance.put_in + balance.taken_out;
    let size = balance.start.max(balance.put_in);
    println!("{balance:?}: {apart:e}");
    assert!(apart.abs() < 1e-4 * size, "{balance:?}");
    run
}

fn energy(run: &Run, time: f64, state: &State) -> f64 {
    let energy = run
        .model
        .system
        .energy(state, &run.model.conditions_at(time));
    energy.kinetic + energy.elastic + energy.electric
}

/// A source that falls from 100 V to zero discharges a held rod, which cannot move, through a
/// resistor with `exp(-t / R c L)`, and a free one, which is much faster, with the capacitance `c +
/// theta^2 / EA`. The energy loss of both is the dissipation of the resistor.
///
/// The error of the two-step scheme is about (h / tau)^2 / 12 of the voltage for steps h = tau /
/// 400, 5e-7, and of the sum of V^2 / R by trapezoids about as much. The jump of the slope shakes
/// the free rod: with k^2 = theta^2 / EA c its first wave, of angular frequency w, is k^2 / (1 +
/// k^2) / (w tau) = 1.6e-3 of the voltage.
#[test]
fn a_resistor_discharges_the_electrode() {
    const TOLERANCE: f64 = 1e-5;
    let tau = 0.04;
    let held = "[[clamp]]\nnode = \"beam/tip\"\n";
    for (case, clamp, capacitance, limit) in [
        ("held rod discharged", held, CAPACITANCE, 1e-6),
        (
            "free rod discharged",
            "",
            CAPACITANCE + PULL * PULL / ROD[0],
            2e-3,
        ),
    ] {
        let resistance = tau / (capacitance * LENGTH);
        let source = "voltage = { kind = \"step\", from = 100, to = 0, time = 0.01 }";
        let circuit = format!("{source}\nresistance = {resistance}");
        let time = "[transient]\nto = 0.11\nstep = 1e-4\nstart = \"equilibrium\"\n";
        let cards = [&electrode("pull", &circuit), clamp, time].concat();
        let run = run(&rod(), 4, &cards);
        let (mut worst, mut taken, mut last) = (0.0_f64, 0.0, (0.01, 100.0));
        let mut before = None;
        for (time, state) in &run.instants {
            let found = &electrodes_at(&run, *time, state)[0];
            if *time <= 0.01 + 1e-9 {
                assert!(
                    (found.voltage - 100.0).abs() < 1e-9,
                    "{time} {}",
                    found.voltage
                );
                before = Some(energy(&run, *time, state));
                continue;
            }
            let expected = 100.0 * (-(time - 0.01) / tau).exp();
            worst = worst.max((found.voltage - expected).abs() / 100.0);
            assert!((found.current + found.voltage / resistance).abs() < 1e-12);
            let step = time - last.0;
            taken += 0.5 * step * (last.1 * last.1 + found.voltage.powi(2)) / resistance;
            last = (*time, found.voltage);
        }
        let (time, state) = run.instants.last().unwrap();
        let lost = before.unwrap() - energy(&run, *time, state);
        println!("{case}: {worst:e} {lost} {taken}");
        record::largest(CLOSED, case, "voltage", worst, limit);
        assert!(worst < limit, "{case}: {worst:e}");
        let energies = [lost, taken];
        let error = (lost / taken - 1.0).abs();
        record::value(CLOSED, case, "energy lost [J]", energies, error, TOLERANCE);
        assert!(error < TOLERANCE, "{case}: {energies:?}");
    }
}

/// In a beam that is bent and twisted at once by varying loads, the current to an electrode sums up
/// to its charge: by trapezoids of steps h to (w h)^2 / 12, 1.3e-5 with the w of the drives. Steps
/// are short compared with all waves that a start from equilibrium excites.
#[test]
fn currents_add_up_to_charges() {
    const TOLERANCE: f64 = 2e-5;
    let cards = [
        electrode("bend", "voltage = \"= 40*(1 - cos(628.3185307179586*t))\""),
        electrode("pull", "charge = \"1 uC\""),
        electrode("twist", "resistance = \"20 kOhm\""),
        "[[load]]\nnode = \"beam/tip\"\nmoment = [0.01, 0, 0]\n\
         drive = \"= 1 - cos(628.3185307179586*t)\"\n[transient]\nto = 0.02\nstep = 2e-5\nstart = \"equilibrium\"\n"
            .to_owned(),
    ];
    let run = run(&coupled(), 6, &cards.concat());
    let mut last: Option<(f64, Vec<ElectrodeState>)> = None;
    let mut flown = [0.0; 3];
    let (mut worst, mut largest) = ([0.0_f64; 3], [0.0_f64; 3]);
    let mut first = [0.0; 3];
    for (time, state) in &run.instants {
        let now = electrodes_at(&run, *time, state);
        for k in 0..3 {
            match &last {
                None => first[k] = now[k].charge,
                Some((before, then)) => {
                    flown[k] += 0.5 * (time - before) * (then[k].current + now[k].current);
                }
            }
            worst[k] = worst[k].max((now[k].charge - first[k] - flown[k]).abs());
            largest[k] = largest[k].max(now[k].charge.abs());
        }
        last = Some((*time, now));
    }
    for (k, name) in ["bend", "pull", "twist"].into_iter().enumerate() {
        let error = worst[k] / largest[k];
        println!("{name}: {error:e} of {:e} C", largest[k]);
        assert!(error < TOLERANCE, "{name}: {error:e}");
        let case = "coupled blade in time";
        let quantity = format!("charge of {name} against its current");
        record::largest(CLOSED, case, &quantity, error, TOLERANCE);
    }
    // The constant charge.
    assert!(last.is_some_and(|(_, now)| (now[1].charge - 1e-6).abs() < 1e-15));
}

/// A rigid rotation and displacement of any size causes no charge in a beam: round-off of
/// coordinates of some meters, 1e-15, times the coupling.
#[test]
fn rigid_motions_bring_no_charge() {
    let cards = ["pull", "bend", "twist"].map(|name| electrode(name, "voltage = 0"));
    let model: Model = read(&coupled(), 5, &(cards.concat() + "[static]\n")).model;
    let coupling = coupled().piezo.unwrap().coupling.amax();
    for turn in [[0.3, -0.2, 0.5], [2.9, 0.4, -0.6], [-1.0, 2.0, 1.5]] {
        let turn = vector::to_rotation(&Vector3::from(turn));
        let mut state = model.system.rest();
        for node in &mut state.nodes {
            node.position = turn * node.position + Vector3::new(1.0, -2.0, 0.7);
            node.rotation = turn * node.rotation;
        }
        for found in model.system.electrodes(&state, &Conditions::at_rest()) {
            assert!(found.charge.abs() < 1e-13 * coupling, "{found:?}");
        }
    }
}

/// Charge by a small load at the tip, at voltages of zero, and displacement at the tip by a small
/// voltage are one number, `dQ/dF = du/dV`: strains of a voltage do not change along the beam,
/// strains of loads at the tip are linear, and two points integrate both exactly. Central differences
/// by a force of 1e-3 N have the error of the square of its part of the buckling load 1.2 N, 1e-6,
/// and 1e-15 of round-off compared with strains of 4e-9 as much.
#[test]
fn charges_by_loads_are_displacements_by_voltages() {
    const TOLERANCE: f64 = 1e-5;
    let section = coupled();
    const NAMES: [&str; 3] = ["pull", "bend", "twist"];
    let step = |elements: usize, volts: [f64; 3], load: [f64; 6]| {
        let cards = NAMES.into_iter().zip(volts);
        let cards = cards.map(|(name, v)| electrode(name, &format!("voltage = {v}")));
        let (force, moment) = load.split_at(3);
        let load =
            format!("[[load]]\nnode = \"beam/tip\"\nforce = {force:?}\nmoment = {moment:?}\n");
        equilibrium(&section, elements, &(cards.collect::<String>() + &load))
    };
    let asymmetry = |elements: usize| -> f64 {
        let by_load = Matrix3x6::from_columns(&[0, 1, 2, 3, 4, 5].map(|j| {
            let mut load = [0.0; 6];
            load[j] = [1e-3, 1e-4, 1e-4, 1e-4, 1e-4, 1e-4][j];
            let charges = |sign: f64| {
                let step = step(elements, [0.0; 3], load.map(|part| sign * part));
                Vector3::from_iterator(step.electrodes.iter().map(|found| found.charge))
            };
            (charges(1.0) - charges(-1.0)) / (2.0 * load[j])
        }));
        let by_voltage = Matrix3x6::from_rows(&[0, 1, 2].map(|k| {
            let mut volts = [0.0; 3];
            volts[k] = 0.1;
            let moved = |sign: f64| {
                let step = step(elements, volts.map(|part| sign * part), [0.0; 6]);
                let moved = step.positions.last().unwrap() - Vector3::new(LENGTH, 0.0, 0.0);
                let turned = vector::from_rotation(step.rotations.last().unwrap());
                Vector6::from_iterator(moved.iter().chain(turned.iter()).copied())
            };
            ((moved(1.0) - moved(-1.0)) / (2.0 * volts[k])).transpose()
        }));
        let worst = (0..6).map(|j| {
            let difference = (by_load.column(j) - by_voltage.column(j)).amax();
            difference / by_voltage.column(j).amax()
        });
        worst.fold(0.0, f64::max)
    };
    let found = asymmetry(4);
    println!("{found:e}");
    let case = "coupled blade, loads against voltages";
    record::largest(CLOSED, case, "all loads at the tip", found, TOLERANCE);
    assert!(found < TOLERANCE, "{found:e}");
}

/// A clamped column buckles at `pi^2 EI / 4 L^2` for any connection of the axial electrode: at open
/// circuit its voltage carries `k^2 / (1 + k^2)` of the load, a quarter, which would be missing if
/// the forces of voltages did not turn. The effect of shear is P/GA, 1.5e-5, and of eight elements
/// less.
#[test]
fn an_open_column_buckles_as_a_plain_one() {
    const TOLERANCE: f64 = 1e-4;
    let expected = std::f64::consts::PI.powi(2) * SOFT[4] / (4.0 * LENGTH * LENGTH);
    for (case, circuit) in [
        ("column at short circuit", "voltage = 0"),
        ("column at open circuit", "charge = 0"),
    ] {
        let load = "[[load]]\nnode = \"beam/tip\"\nforce = [-1, 0, 0]\n[buckling]\ncount = 1\n";
        let input = read(&soft(), 8, &(electrode("pull", circuit) + load));
        let outcome = buckling(&input.model, &input.buckling.unwrap());
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        let found = outcome.result.modes[0].factor;
        check(case, "critical load [N]", [found, expected], TOLERANCE);
    }
}

/// A rod that turns about an axis through its root: with `y = x + u`, `l = W sqrt(m/EA)`, `y = A
/// sin(l x)` and `EA (y' - 1) + theta V = 0` at the tip, at a given voltage and at open circuit.
/// The error of finite volumes is (l L)^4 times a part of the square of the element.
#[test]
fn a_turning_rod_with_a_circuit() {
    const TOLERANCE: f64 = 1e-6;
    let rpm = 6000.0;
    let l = rpm * std::f64::consts::PI / 30.0 / wave() / LENGTH;
    let (s, c) = ((l * LENGTH).sin(), (l * LENGTH).cos());
    let (ea, per_length) = (ROD[0], PULL * PULL / (CAPACITANCE * LENGTH));
    for (case, circuit, amplitude) in [
        (
            "turning rod, 200 V",
            "voltage = 200",
            (1.0 - PULL * 200.0 / ea) / (l * c),
        ),
        (
            "turning open rod",
            "charge = 0",
            (ea + per_length * LENGTH) / (ea * l * c + per_length * s),
        ),
    ] {
        let cards = format!("[modes]\nspeeds = [0, {rpm}]\ncount = 2\n");
        let input = read(&rod(), 24, &(electrode("pull", circuit) + &cards));
        let outcome = modes(&input.model, &input.modes.unwrap());
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        let tip = Vector3::from(*outcome.table.equilibria[1].positions.last().unwrap()).norm();
        let expected = amplitude * s;
        let grown = [tip - LENGTH, expected - LENGTH];
        let error = (tip - expected).abs() / (expected - LENGTH).abs();
        println!("{case}: {grown:?} {error:e}");
        record::value(CLOSED, case, "elongation [m]", grown, error, TOLERANCE);
        assert!(error < TOLERANCE, "{case}: {grown:?}");
    }
}

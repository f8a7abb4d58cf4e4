//! Beams with a light or heavy body at their tip, free or held by some freedoms of their root: the
//! number of motions without stiffness follows from the joint, and all frequencies equal the frequencies of the dense symmetric problem of the same stiffness and mass.

use std::fmt::Write;

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::assembly::{System, Tangent};
use beam_dynamics::input;
use beam_dynamics::model::Conditions;
use beam_dynamics::result::{ModeBranch, ModeKind};
use nalgebra::DMatrix;
use proptest::prelude::{Strategy, prop};
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

use crate::effort::cases;
use crate::record;

const FREEDOMS: [&str; 6] = ["x", "y", "z", "about x", "about y", "about z"];
const CASES: usize = 80;
const FREE_CASES: usize = 120;
/// Frequencies over the lowest beyond which stiffnesses have lost their digits: round-off of
/// 1e-16 is then 1e-4 of the lowest stiffness.
const KNOWN: f64 = 1e6;

/// A beam, in powers of ten where sizes differ much.
#[derive(Debug, Clone)]
struct Setting {
    elements: usize,
    length: f64,
    bending: f64,
    /// GA L^2 / EI.
    slenderness: f64,
    mass: f64,
    tip: f64,
    /// Radius of inertia of the tip in parts of the length.
    size: f64,
    offset: f64,
    locked: u32,
    count: usize,
}

fn setting() -> impl Strategy<Value = Setting> {
    let log = |a: f64, b: f64| (a..b).prop_map(|power| 10_f64.powf(power));
    let beam = (1_usize..7, log(-0.5, 1.5), log(0.0, 6.0), log(2.0, 7.0));
    let masses = (log(-1.0, 2.0), log(-2.0, 5.0), log(-3.0, 0.0), 0.0..1.0_f64);
    let requested = (1_u32..64, prop::sample::select(vec![8_usize, 9, 11, 13]));
    (beam, masses, requested).prop_map(|(beam, masses, requested)| Setting {
        elements: beam.0,
        length: beam.1,
        bending: beam.2,
        slenderness: beam.3,
        mass: masses.0,
        tip: masses.1,
        size: masses.2,
        offset: masses.3,
        locked: requested.0,
        count: requested.1,
    })
}

impl Setting {
    fn text(&self) -> String {
        let (length, bending) = (self.length, self.bending);
        let shear = self.slenderness * bending / length.powi(2);
        let m = self.mass / length;
        let turning = 2.0 * m * bending / shear;
        let mut text = format!(
            "units = \"SI\"\n[properties.p]\nea = {:e}\ngay = {shear:e}\ngaz = {shear:e}\n\
             gj = {bending:e}\neiy = {bending:e}\neiz = {:e}\nm = {m:e}\niy = {turning:e}\n\
             iz = {:e}\n",
            3.0 * shear,
            4.0 * bending,
            3.0 * turning
        );
        let last = 2 * self.elements;
        for i in 0..=last {
            let x = length * i as f64 / last as f64;
            writeln!(text, "[[node]]\nname = \"n{i}\"\nposition = [{x:e}, 0, 0]").unwrap();
        }
        for i in (0..last).step_by(2) {
            let nodes = format!("[\"n{i}\", \"n{}\", \"n{}\"]", i + 1, i + 2);
            writeln!(text, "[[beam]]\nnodes = {nodes}\nproperties = \"p\"").unwrap();
        }
        let radius = self.size * length;
        let inertia = self.tip * radius * radius;
        let locked: Vec<_> = (0..6).filter(|i| self.locked >> i & 1 == 1).collect();
        let locked: Vec<_> = locked.into_iter().map(|i| FREEDOMS[i]).collect();
        if !locked.is_empty() {
            let joint = "[[joint]]\nkind = \"total\"\nnodes = [\"n0\"]\nlocked";
            writeln!(text, "{joint} = {locked:?}").unwrap();
        }
        text + &format!(
            "[[body]]\nnode = \"n{last}\"\nmass = {:e}\noffset = [{:e}, {:e}, 0]\n\
             inertia = [{inertia:e}, {:e}, {:e}]\n[modes]\nspeeds = [0]\ncount = {}\n\
             free = {}\n",
            self.tip,
            radius * self.offset,
            radius * (1.0 - self.offset),
            1.3 * inertia,
            1.6 * inertia,
            self.count,
            locked.is_empty()
        )
    }
}

/// All squares of frequencies, ascending: of the stiffness over the roots of the masses, on
/// the motions that the constraints allow.
fn squares(system: &System) -> Vec<f64> {
    let Tangent {
        by_unknowns,
        by_rates,
    } = system.tangent(&system.rest(), &Conditions::at_rest());
    let (nodes, all) = (system.nodes().len(), by_unknowns.pattern().size());
    let (n, held) = (6 * nodes, all - 12 * nodes);
    let at = |k: usize| 12 * (k / 6) + k % 6;
    let mass = DMatrix::from_fn(n, n, |i, j| -by_rates.entry(at(i), at(j)));
    let stiffness = DMatrix::from_fn(n, n, |i, j| -by_unknowns.entry(at(i) + 6, at(j)));
    let inverse = mass.cholesky().unwrap().l().try_inverse().unwrap();
    let stiffness = &inverse * stiffness * inverse.transpose();
    let stiffness = 0.5 * (&stiffness + stiffness.transpose());
    // The columns of Q after the columns of the constraints span the motions that they allow.
    let entry = |i: usize, j: usize| by_unknowns.entry(12 * nodes + j, at(i));
    let mut wide = DMatrix::zeros(n, n + held);
    let constraints = DMatrix::from_fn(n, held, entry);
    wide.columns_mut(0, held)
        .copy_from(&(inverse * constraints));
    wide.columns_mut(held, n).fill_with_identity();
    let q = wide.qr().q();
    let allowed = q.columns(held, n - held);
    let reduced = allowed.transpose() * stiffness * allowed;
    let mut squares: Vec<_> = reduced.symmetric_eigenvalues().iter().copied().collect();
    squares.sort_by(f64::total_cmp);
    squares
}

#[test]
fn motions_without_stiffness_are_counted_beside_any_tip() {
    let (looked_at, largest) = compared(29, cases(CASES), setting());
    record(
        &format!("{looked_at} beams with a body at the tip"),
        largest,
    );
    assert!(looked_at > cases(CASES) / 3, "{looked_at}");
}

// Bodies up to a hundred times as heavy as the beam: with 1e4 times, one in some hundred free
// beams has an elastic mode below the round-off of its six rigid modes.
#[test]
fn free_beams_with_a_tip_have_six_rigid_modes() {
    let free = setting().prop_map(|setting| Setting {
        locked: 0,
        tip: setting.tip.min(100.0 * setting.mass),
        ..setting
    });
    let (looked_at, largest) = compared(31, cases(FREE_CASES), free);
    record(&format!("{looked_at} free beams with a body"), largest);
    assert!(looked_at > cases(FREE_CASES) / 3, "{looked_at}");
}

fn record(case: &str, largest: f64) {
    record::largest(
        "dense symmetric eigenvalues",
        case,
        "error of the squares of frequencies, over the error by round-off",
        largest,
        1.0,
    );
}

/// Compares `count` random beams: the number of those whose reference has digits, and the largest
/// error. Round-off of the reference is 1e-16 of its largest value, and some of that more; the
/// solver is near to it.
fn compared(seed: u8, count: usize, of: impl Strategy<Value = Setting>) -> (usize, f64) {
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &[seed; 32]);
    let mut runner = TestRunner::new_with_rng(Config::default(), rng);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.dynamics.toml");
    let (mut looked_at, mut largest) = (0, 0.0_f64);
    for _ in 0..count {
        let setting = of.new_tree(&mut runner).unwrap().current();
        std::fs::write(&path, setting.text()).unwrap();
        let input = input::read(&path).unwrap_or_else(|problems| panic!("{problems}"));
        let squares = squares(&input.model.system);
        let free = 6 - setting.locked.count_ones() as usize;
        let highest = squares.last().copied().unwrap_or(0.0);
        if highest > KNOWN.powi(2) * squares[free] {
            continue;
        }
        looked_at += 1;
        let outcome = modes(&input.model, &input.modes.unwrap());
        let table = &outcome.table;
        let points = table.at_speed(0).into_iter();
        let mut found: Vec<_> = points
            .map(|(_, point)| point.frequency * std::f64::consts::TAU)
            .collect();
        found.sort_by(f64::total_cmp);
        let is_rigid = |branch: &&ModeBranch| branch.kind == ModeKind::Rigid;
        let rigid = table.branches.iter().filter(is_rigid).count();
        assert_eq!(rigid, if setting.locked == 0 { 6 } else { 0 });
        let reported = format!("{setting:?} {found:?} {:?}", outcome.table.remarks);
        assert_eq!(
            found.iter().filter(|f| **f == 0.0).count(),
            free,
            "{reported}"
        );
        assert!(
            found.len() >= setting.count.min(squares.len()),
            "{reported}"
        );
        for (frequency, square) in found.iter().zip(&squares).skip(free) {
            let error = (frequency.powi(2) / square - 1.0).abs();
            largest = largest.max(error / (1e-6 + 1e-13 * highest / square));
            assert!(largest < 1.0, "{frequency} {square} {reported}");
        }
    }
    (looked_at, largest)
}

//! Modes as seen from the fixed system: a disk on equal bearings in the ground.

use std::f64::consts::TAU;

use beam_dynamics::result::{Direction, FixedTable, FrequencyTable, ModeKind};

use super::case_files;
use super::effort::cases;
use super::variational_beam::spectra::Random;

/// A disk of 10 kg on 40 kN/m in all directions across the axis and 90 kN/m along it.
const DISK: &str = "units = \"SI\"\n[[node]]\nname = \"disk\"\nposition = [0, 0, 0]\n\
    [[body]]\nnode = \"disk\"\nmass = 10\ninertia = [1, 1, 2]\n\
    [[spring]]\nnode = \"disk\"\nstiffness = [4e4, 4e4, 9e4]\n\
    rotational_stiffness = [1e6, 1e6, 1e6]\nfixed_to = \"world\"\n\
    [modes]\nspeeds = [0, 200, 400, 700, 900]\ncount = 3\nname_at = 200\n";

fn table(model: &str) -> FrequencyTable {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("disk.dynamics.toml");
    std::fs::write(&file, model).unwrap();
    case_files::table(&file)
}

// f = sqrt(k / m) / 2 pi at all speeds, forward and backward, and along the axis; so the disk is
// critical at the speed f. In the turning axes the forward whirl is at |f - n|, through zero.
// Frequencies are exact but for the eigenvalue solver (1e-8), and constant lines have exact
// intersections.
#[test]
fn a_disk_whirls_at_one_frequency_and_is_critical_there() {
    let table = table(DISK);
    let named = |name: &str| table.branches.iter().any(|branch| branch.name == name);
    assert!(named("lateral 1 progressive"), "{:?}", table.branches);
    assert!(named("lateral 1 regressive") && named("axial 1"));
    // The progressive whirl has the frequency zero in the turning axes at 604 rpm, and keeps its name.
    assert_eq!(table.branches.len(), 3, "{:?}", table.branches);
    let fixed = FixedTable::new(&table, &[1]).unwrap();
    let [across, along] = [4e4_f64, 9e4].map(|k| (k / 10.0).sqrt() / TAU);
    assert_eq!(fixed.lines.len(), 3, "{:?}", fixed.lines);
    for line in &fixed.lines {
        let (expected, direction) = match line.harmonic {
            0 => (along, None),
            1 => (across, Some(Direction::Forward)),
            _ => (across, Some(Direction::Backward)),
        };
        for point in &line.points {
            let point = point.as_ref().unwrap();
            assert!(
                (point.frequency() / expected - 1.0).abs() < 1e-8,
                "{line:?}"
            );
            assert_eq!(point.direction, direction);
        }
    }
    let forward = fixed
        .critical
        .iter()
        .find(|c| c.name.contains("progressive"));
    let forward = forward.unwrap();
    assert!(
        (forward.speed / TAU / across - 1.0).abs() < 1e-8,
        "{forward:?}"
    );
    let kinds = table.branches.iter().map(|branch| branch.kind);
    assert_eq!(kinds.filter(|kind| *kind == ModeKind::Lateral).count(), 2);
}

// Whatever the distance of the speeds, both whirls, forward and backward, meet the speed at f, and
// no other crossing is listed. Beyond f the forward whirl has the shape of the backward one in the
// turning axes. Half of the lists begin at rest, where the modes are mixtures of both whirls.
#[test]
fn critical_speeds_do_not_depend_on_the_speeds_of_the_list() {
    let critical = (4e4_f64 / 10.0).sqrt();
    let rpm = TAU / 60.0;
    let mut random = Random(11);
    let mut crossed = 0;
    for number in 0..cases(100) {
        let first = random.between(0.0, 400.0);
        let mut speed = if number % 2 == 0 { 0.0 } else { first };
        let mut speeds = vec![speed];
        for _ in 0..random.between(2.0, 5.0) as usize {
            speed += random.between(20.0, 620.0);
            speeds.push(speed);
        }
        let list = format!("speeds = {speeds:?}");
        let given = "speeds = [0, 200, 400, 700, 900]";
        let model = DISK.replace(given, &list).replace("name_at = 200\n", "");
        let table = table(&model);
        let fixed = FixedTable::new(&table, &[1]).unwrap();
        let of_whirls = fixed.critical.iter().filter(|c| c.name.contains("lateral"));
        let found: Vec<_> = of_whirls.collect();
        let crosses = speeds[0] * rpm < critical && critical < speed * rpm;
        crossed += usize::from(crosses);
        assert_eq!(table.branches.len(), 3, "{list} {:?}", table.branches);
        assert_eq!(found.len(), if crosses { 2 } else { 0 }, "{list} {found:?}");
        for one in &found {
            assert!((one.speed / critical - 1.0).abs() < 1e-8, "{list} {one:?}");
        }
        let direction = |word: &str| found.iter().filter(|one| one.name.contains(word)).count();
        let both = usize::from(crosses);
        assert_eq!(direction("progressive"), both, "{list} {found:?}");
        assert_eq!(direction("regressive"), both, "{list} {found:?}");
    }
    assert!(2 * crossed > cases(100), "{crossed}");
}

// One blade: the frequencies of its table in the turning axes, as straight lines between the speeds,
// meet n times the speed where `f_a + x (f_b - f_a) = n (Omega_a + x (Omega_b - Omega_a)) / 2 pi`.
#[test]
fn a_single_blade_is_critical_where_its_frequency_is_a_multiple_of_the_speed() {
    let speeds = "speeds = [0, 40, 80, 120]";
    let model = format!(
        "units = \"SI\"\n[properties.p]\nea = 1e9\ngay = 1e9\ngaz = 1e9\ngj = 1e6\neiy = 1e5\n\
         eiz = 4e5\nm = 10\niy = 0.1\niz = 0.1\n[[blade]]\nname = \"b\"\nroot = [0.5, 0, 0]\nproperties = \"p\"\n\
         [[blade.piece]]\nlength = 10\nelements = 4\n[modes]\n{speeds}\ncount = 3\n"
    );
    let table = table(&model);
    assert!(FixedTable::new(&table, &[1]).is_none());
    let critical = table.critical_of_blade(&table.harmonics());
    assert!(critical.len() > 2, "{critical:?}");
    for one in &critical {
        let turns = one.speed / TAU;
        let expected = f64::from(one.order) * turns;
        assert!((one.frequency / expected - 1.0).abs() < 1e-12, "{one:?}");
        let branch = table.branches.iter().find(|b| b.name == one.name).unwrap();
        let k = table.speeds.iter().rposition(|s| *s <= one.speed).unwrap();
        let [a, b] = [k, k + 1].map(|k| branch.points[k].as_ref().unwrap().frequency);
        let part = (one.speed - table.speeds[k]) / (table.speeds[k + 1] - table.speeds[k]);
        assert!((a + part * (b - a) - one.frequency).abs() < 1e-9, "{one:?}");
    }
}

//! Damage of bars by hand, and against the count of all points and components.

use super::*;
use crate::analysis::analyze;
use crate::material::{DEFAULT_INTERACTION, Fatigue};
use crate::recovery::Recoverer;
use crate::section::samples::{Random, coupled_rectangle, strip_of};
use shared_geom::mesh::CellKind;

/// A bar, 1.6 m wide and 1 m high, with the axes of the material along the axes of the section.
fn bar() -> Section {
    let mut section = strip_of(1.6, 1.0, [3, 2], CellKind::Quadrilateral8);
    for cell in &mut section.cells {
        (cell.fiber_angle, cell.plane_angle) = (0.0, 0.0);
    }
    section
}

fn points(section: &Section) -> Vec<UnitPoint> {
    let solution = analyze(section).unwrap();
    Recoverer::new(section, &solution).unit_points().unwrap()
}

fn limits(section: &Section, one: MaterialLimits) -> Vec<MaterialLimits> {
    vec![one; section.materials.len()]
}

/// Tension 400 and compression 300 MPa, slope 5.
fn metal(section: &Section) -> Vec<MaterialLimits> {
    let strength = Strength::Uniform(UniformLimits {
        tension: 400e6,
        compression: 300e6,
        shear: 200e6,
    });
    let slopes = Slopes {
        fiber: Some(5.0),
        matrix: 5.0,
    };
    let one = MaterialLimits {
        strength: Some(strength),
        fatigue: Fatigue {
            stress: Some(slopes),
            strain: None,
        },
        ..MaterialLimits::default()
    };
    limits(section, one)
}

/// `count` cycles of a component of force from `low` to `high`, and the return to `low`.
fn block(component: usize, count: usize, [low, high]: [f64; 2]) -> Vec<Vector6<f64>> {
    let of = |value| Vector6::ith(component, value);
    let mut forces: Vec<_> = (0..count).flat_map(|_| [of(low), of(high)]).collect();
    forces.push(of(low));
    forces
}

/// The largest damage of all regions.
fn most(found: &[RegionDamage]) -> RegionDamage {
    let most = found.iter().max_by(|a, b| a.damage.total_cmp(&b.damage));
    *most.unwrap()
}

/// The axial stress N/A has 20 cycles from 20 to 120 MPa: amplitude 50 about 70, where
/// min(400 - 70, 300 + 70) = 330 is allowed, N = (330/50)^5. Then 30 cycles, in a second history
/// that occurs 1000 times, from -160 to -40 MPa: 60 about -100, 200 allowed.
#[test]
fn blocks_of_axial_cycles_add_up() {
    let section = bar();
    let (points, limits) = (points(&section), metal(&section));
    let area = 1.6;
    let first = LoadHistory {
        forces: block(0, 20, [20e6 * area, 120e6 * area]),
        repetitions: 1.0,
    };
    let second = LoadHistory {
        forces: block(0, 30, [-160e6 * area, -40e6 * area]),
        repetitions: 1000.0,
    };
    let [one, two] = [20.0 / 6.6_f64.powi(5), 30_000.0 * 0.3_f64.powi(5)];
    for (histories, damage, cycles) in [
        (vec![first.clone()], one, 20.0),
        (vec![first, second], one + two, 30_020.0),
    ] {
        let found = most(&region_damages(&section, &limits, &points, &histories));
        assert_eq!(found.component.name(), "stress 11 [Pa]");
        assert!(
            (found.damage / damage - 1.0).abs() < 1e-8,
            "{found:?} {damage}"
        );
        assert_eq!(found.cycles, cycles);
    }
}

/// Bending about y: the stress M z/I at the governing point, which is the outermost one, has the
/// damage n/N with the amplitude M z/I about zero, `S = 300 MPa`; the factor on the loads is
/// (N/n)^(1/5).
#[test]
fn bending_governs_at_the_outermost_point() {
    let section = bar();
    let (points, limits) = (points(&section), metal(&section));
    let inertia = 1.6 / 12.0;
    let history = LoadHistory {
        forces: block(4, 50, [-8e6, 8e6]),
        repetitions: 1.0,
    };
    let found = most(&region_damages(&section, &limits, &points, &[history]));
    let highest = points.iter().map(|point| point.position[1].abs());
    let highest = highest.fold(0.0, f64::max);
    assert!((found.position[1].abs() / highest - 1.0).abs() < 1e-12);
    let stress = 8e6 * found.position[1].abs() / inertia;
    let damage = 50.0 * (stress / 300e6).powi(5);
    assert!(
        (found.damage / damage - 1.0).abs() < 1e-8,
        "{found:?} {damage}"
    );
    assert!((found.reserve_factor / damage.powf(-0.2) - 1.0).abs() < 1e-7);
    assert!((found.largest.range / (2.0 * stress) - 1.0).abs() < 1e-9);
    assert!(found.largest.mean.abs() < 1e-9 * stress);
}

/// Random histories of a section of plies with couplings, stresses and strains: the largest of the
/// damages of all points and components.
#[test]
fn the_bounds_leave_out_nothing_that_governs() {
    let section = coupled_rectangle(CellKind::Quadrilateral8);
    let points = points(&section);
    let limits_of = |size: f64| DirectionalLimits {
        tension: [9.0 * size, 3.0 * size, 2.0 * size],
        compression: [6.0 * size, 5.0 * size, 4.0 * size],
        shear: [2.0 * size, 3.0 * size, 4.0 * size],
    };
    let slopes = Slopes {
        fiber: Some(10.0),
        matrix: 7.0,
    };
    let ply = MaterialLimits {
        strength: Some(Strength::Ply {
            limits: limits_of(1.0),
            interaction: [DEFAULT_INTERACTION; 3],
        }),
        strain: Some(StrainLimit::Ply(limits_of(0.8))),
        fatigue: Fatigue {
            stress: Some(slopes),
            strain: Some(slopes),
        },
    };
    let limits = limits(&section, ply);
    let mut random = Random(11);
    for size in [0.01, 0.05, 0.4] {
        let mut history = |repetitions| LoadHistory {
            forces: (0..60)
                .map(|_| Vector6::from_fn(|_, _| size * random.next()))
                .collect(),
            repetitions,
        };
        let histories = [history(1.0), history(3.5)];
        let found = region_damages(&section, &limits, &points, &histories);
        for region in &found {
            let own = points
                .iter()
                .filter(|point| section.mesh.cells[point.cell].group == region.group);
            let all = own.flat_map(|point| {
                let damages = measures(&ply).into_iter().map(|(component, life)| {
                    let cycles = LoadHistory::cycles(&histories, &component.row(point));
                    (life.damage(&cycles), life.reserve_factor(&cycles))
                });
                damages.collect::<Vec<_>>()
            });
            let most =
                |worst: (f64, f64), one: (f64, f64)| (worst.0.max(one.0), worst.1.min(one.1));
            let (damage, factor) = all.fold((0.0, f64::INFINITY), most);
            assert_eq!(region.damage, damage);
            assert_eq!(region.reserve_factor, factor);
        }
        assert!(!found.is_empty());
    }
}

/// A history that does not occur has no effect, though it is beyond the strengths; a constant force
/// has the factor at which its stress reaches the strength, and beyond it an infinite damage.
#[test]
fn forces_without_cycles_and_without_occurrence() {
    let section = bar();
    let (points, limits) = (points(&section), metal(&section));
    let of = |forces: Vec<Vector6<f64>>, repetitions: f64| LoadHistory {
        forces,
        repetitions,
    };
    let damages = |histories: &[LoadHistory]| {
        let found = most(&region_damages(&section, &limits, &points, histories));
        (found.damage, found.reserve_factor, found.cycles)
    };
    let usual = of(block(4, 5, [-1e6, 2e6]), 3.0);
    let beyond = of(block(4, 5, [-9e8, 9e8]), 0.0);
    assert_eq!(
        damages(&[usual.clone(), beyond]),
        damages(std::slice::from_ref(&usual))
    );
    // the axial stresses are 100 and -500 MPa
    let (damage, factor, cycles) = damages(&[of(vec![Vector6::ith(0, 160e6); 3], 1.0)]);
    assert_eq!((damage, cycles), (0.0, 0.0));
    assert!((factor / 4.0 - 1.0).abs() < 1e-9, "{factor}");
    let (damage, factor, _) = damages(&[of(vec![Vector6::ith(0, -800e6); 3], 1.0)]);
    assert_eq!(damage, f64::INFINITY);
    assert!((factor / 0.6 - 1.0).abs() < 1e-9, "{factor}");
}

/// A ply of 100 MPa in every direction, with the slope 2 across the fiber.
fn ply(fiber: Option<f64>) -> MaterialLimits {
    let strength = Strength::Ply {
        limits: DirectionalLimits {
            tension: [100e6; 3],
            compression: [100e6; 3],
            shear: [100e6; 3],
        },
        interaction: [DEFAULT_INTERACTION; 3],
    };
    let slopes = Slopes { fiber, matrix: 2.0 };
    MaterialLimits {
        strength: Some(strength),
        fatigue: Fatigue {
            stress: Some(slopes),
            strain: None,
        },
        ..MaterialLimits::default()
    }
}

/// Two components with slopes of 20 and 2: the one with the larger damage has the larger factor.
#[test]
fn the_factor_is_the_smallest_of_all_components() {
    let section = bar();
    let points = points(&section);
    let limits = limits(&section, ply(Some(20.0)));
    let both = |axial: f64, torsion: f64| LoadHistory {
        forces: [1.0, -1.0, 1.0, -1.0, 1.0]
            .map(|sign| sign * Vector6::new(axial, 0.0, 0.0, torsion, 0.0, 0.0))
            .to_vec(),
        repetitions: 1.0,
    };
    let found = |axial, torsion| {
        most(&region_damages(
            &section,
            &limits,
            &points,
            &[both(axial, torsion)],
        ))
    };
    // alone: 80 MPa in axial direction, 2 cycles; and torsion
    let (axial, torsion) = (found(128e6, 0.0), found(0.0, 11e6));
    let together = found(128e6, 11e6);
    assert!((axial.reserve_factor - 1.25 / 2f64.powf(0.05)).abs() < 1e-9);
    assert!(torsion.damage > axial.damage && torsion.reserve_factor > axial.reserve_factor);
    assert!((together.damage / torsion.damage - 1.0).abs() < 1e-9);
    assert!((together.reserve_factor / axial.reserve_factor - 1.0).abs() < 1e-9);
    // without a slope along the fiber its stress has no damage
    let across = self::limits(&section, ply(None));
    let loads = [both(128e6, 11e6)];
    let found = most(&region_damages(&section, &across, &points, &loads));
    assert!(found.component.index != 0);
    assert!((found.reserve_factor / torsion.reserve_factor - 1.0).abs() < 1e-9);
}

//! Made-up results for the tests of output.

use std::path::PathBuf;

use nalgebra::{Matrix3, Vector3};
use shared_geom::figure::Figure;

use super::Written;
use super::text::RPM;
use crate::model::Node;
use crate::result::{
    EquilibriumReport, FrequencyTable, Measured, MeasuredPoint, ModeBranch, ModeKind, ModePoint,
    Shares, Whirl,
};

mod fields;
mod shapes;
mod statics;

/// The texts of a figure, each on a line of its own between other lines.
pub fn texts(figure: &impl Figure) -> String {
    let drawing = figure.drawing();
    let texts = drawing.texts().map(|text| format!("\n{text}\n"));
    texts.collect()
}

pub use fields::{read_back, values};
pub use shapes::{shaped, tip_motion};
#[cfg(test)]
pub use statics::torsion;
pub use statics::{bent, column};

/// Names of the written files.
pub(super) fn names(written: &Written) -> Vec<String> {
    let name = |path: &PathBuf| {
        path.file_name()
            .expect("a file has a name")
            .to_string_lossy()
            .into_owned()
    };
    written.files.iter().map(name).collect()
}

/// Nodes `n0`, `n1`, ... at these positions, their axes along the axes of the model.
pub(super) fn nodes_at(positions: &[[f64; 3]]) -> Vec<Node> {
    let node = |(k, point): (usize, &[f64; 3])| Node {
        label: format!("n{k}"),
        position: Vector3::from(*point),
        rotation: Matrix3::identity(),
    };
    positions.iter().enumerate().map(node).collect()
}

fn point(frequency: f64, shares: Shares, assurance: Option<f64>) -> Option<ModePoint> {
    Some(ModePoint {
        frequency,
        damping_ratio: 0.0,
        growth: 0.0,
        shares,
        lateral: 0.0,
        tower: [0.0; 2],
        whirl: None,
        assurance,
        shape: None,
    })
}

fn branch(name: &str, kind: ModeKind, points: Vec<Option<ModePoint>>) -> ModeBranch {
    ModeBranch {
        name: name.to_owned(),
        kind,
        harmonic: None,
        points,
    }
}

fn report(iterations: usize, residual: f64) -> EquilibriumReport {
    EquilibriumReport {
        iterations,
        residual,
        positions: vec![[0.0; 3]],
        rotations: vec![Matrix3::identity()],
    }
}

/// Three modes at 0 and 600 rpm, one of them at the second only.
pub(super) fn small() -> FrequencyTable {
    let (flap, lag, torsion) = (
        [0.99, 0.01, 0.0, 0.0],
        [0.01, 0.98, 0.01, 0.0],
        [0.0, 0.0, 1.0, 0.0],
    );
    FrequencyTable {
        name: "two speeds".to_owned(),
        speeds: vec![0.0, 600.0 / RPM],
        branches: vec![
            branch(
                "flap 1",
                ModeKind::Flap,
                vec![point(1.4, flap, None), point(12.5, flap, Some(0.999))],
            ),
            branch(
                "lag 1",
                ModeKind::Lag,
                vec![point(22.25, lag, None), point(23.333, lag, Some(0.998))],
            ),
            branch(
                "torsion 1",
                ModeKind::Torsion,
                vec![None, point(99.5, torsion, None)],
            ),
        ],
        equilibria: vec![report(1, 1.0), report(4, 2e-13)],
        decaying: Vec::new(),
        remarks: vec!["made up".to_owned()],
        style: Default::default(),
        is_single_blade: false,
        blade_files: Vec::new(),
    }
}

/// The two lag waves of a rotor of three blades, of 2 Hz in the turning axes at 0, 60 and 180 rpm.
pub(super) fn waves() -> FrequencyTable {
    let speeds = [0.0, 60.0, 180.0].map(|rpm| rpm / RPM).to_vec();
    let wave = |name: &str, harmonic: i32| {
        let points = speeds.iter().map(|_| {
            let mut point = point(2.0, [0.0, 1.0, 0.0, 0.0], None);
            if let Some(point) = &mut point {
                point.whirl = Some(Whirl {
                    harmonic,
                    blades: 3,
                    share: 1.0,
                });
            }
            point
        });
        ModeBranch {
            harmonic: Some(harmonic),
            ..branch(name, ModeKind::Lag, points.collect())
        }
    };
    FrequencyTable {
        name: "waves".to_owned(),
        branches: vec![wave("lag 1 progressive", 1), wave("lag 1 regressive", -1)],
        equilibria: vec![report(3, 1e-12); speeds.len()],
        speeds,
        decaying: Vec::new(),
        remarks: Vec::new(),
        style: Default::default(),
        is_single_blade: false,
        blade_files: Vec::new(),
    }
}

/// Measurements for [`small`], without lag: two that match, one without an order, one at another
/// speed, one of too high an order.
pub(super) fn measured() -> Measured {
    let point = |rpm: f64, frequency, order| MeasuredPoint {
        speed: rpm / RPM,
        frequency,
        order,
    };
    Measured {
        points: vec![
            point(0.0, 1.5, Some(1)),
            point(600.0, 99.0, Some(2)),
            point(300.0, 5.0, None),
            point(300.0, 6.0, Some(1)),
            point(600.0, 300.0, Some(9)),
        ],
        leave_out: vec![ModeKind::Lag],
    }
}

/// A table similar to a swept tip at `count` speeds from 0 to 750 rpm, with crossing modes, a
/// branch that begins late and one that ends early: `f^2 = f0^2 + K (Omega / 2 pi)^2`.
pub(super) fn swept_tip(count: usize) -> FrequencyTable {
    let modes: [(&str, ModeKind, f64, f64); 10] = [
        ("flap 1", ModeKind::Flap, 1.4, 1.4),
        ("flap 2", ModeKind::Flap, 10.3, 7.5),
        ("lag 1", ModeKind::Lag, 22.0, 0.35),
        ("flap 3", ModeKind::Flap, 27.6, 19.0),
        ("flap 4", ModeKind::Flap, 54.0, 36.0),
        ("flap 5", ModeKind::Flap, 89.0, 62.0),
        ("torsion 1", ModeKind::Torsion, 98.0, 4.0),
        ("coupled 1", ModeKind::Coupled, 103.0, 12.0),
        ("lag 2", ModeKind::Lag, 139.0, 5.0),
        ("axial 1", ModeKind::Axial, 160.0, 0.0),
    ];
    let last = (count.max(2) - 1) as f64;
    let speeds: Vec<_> = (0..count).map(|k| 750.0 / RPM * k as f64 / last).collect();
    let branches = modes
        .into_iter()
        .enumerate()
        .map(|(i, (name, kind, rest, slope))| {
            let points = speeds.iter().enumerate().map(|(k, speed)| {
                let turns = speed / (2.0 * std::f64::consts::PI);
                let frequency = (rest * rest + slope * turns * turns).sqrt();
                let hidden = (i == 9 && 2 * k > count) || (i == 7 && 4 * k < count && k > 0);
                if hidden {
                    None
                } else {
                    point(frequency, [0.25; 4], (k > 0).then_some(0.99))
                }
            });
            branch(name, kind, points.collect())
        });
    FrequencyTable {
        name: "swept tip, 15 deg".to_owned(),
        branches: branches.collect(),
        equilibria: vec![report(3, 1e-12); count],
        speeds,
        decaying: Vec::new(),
        remarks: Vec::new(),
        style: Default::default(),
        is_single_blade: false,
        blade_files: Vec::new(),
    }
}

/// Twenty-four damped modes at eleven speeds: four families of kinds whose frequencies
/// rise at different rates.
pub(super) fn crowded() -> FrequencyTable {
    let speeds: Vec<_> = (0..11).map(|k| 3.0 * f64::from(k) / RPM).collect();
    let kinds = [
        ("flap", ModeKind::Flap, 0.6, 1.9),
        ("lag", ModeKind::Lag, 0.8, 0.6),
        ("torsion", ModeKind::Torsion, 6.0, 0.1),
        ("coupled", ModeKind::Coupled, 3.0, 1.2),
    ];
    let branches = (0..24_usize).map(|i| {
        let (word, kind, first, slope) = kinds[i % 4];
        let number = (i / 4 + 1) as f64;
        let points = speeds.iter().map(|speed| {
            let rest = first * number.powf(1.4);
            let mut point = point(
                (rest * rest + slope * speed * speed).sqrt(),
                [0.25; 4],
                None,
            );
            if let Some(point) = &mut point {
                point.damping_ratio = 0.003 * number + 0.004 * slope * speed;
                point.growth = -point.damping_ratio * point.frequency;
            }
            point
        });
        branch(&format!("{word} {}", i / 4 + 1), kind, points.collect())
    });
    FrequencyTable {
        name: "crowded rotor".to_owned(),
        branches: branches.collect(),
        equilibria: vec![report(3, 1e-12); speeds.len()],
        speeds,
        decaying: Vec::new(),
        remarks: Vec::new(),
        style: Default::default(),
        is_single_blade: false,
        blade_files: Vec::new(),
    }
}

/// Measurements by Epps and Chandra (1996) on a strip with a tip swept by 15 degrees (in
/// `tests/reference/rotors`).
pub(super) fn epps_chandra() -> Measured {
    let rows: [(f64, &[f64]); 3] = [
        (0.0, &[1.8, 10.2, 27.2]),
        (500.0, &[10.1, 25.2, 44.4]),
        (750.0, &[14.4, 34.8, 55.9, 87.5, 120.1, 147.3]),
    ];
    let points = rows.into_iter().flat_map(|(rpm, frequencies)| {
        frequencies
            .iter()
            .enumerate()
            .map(move |(i, &frequency)| MeasuredPoint {
                speed: rpm / RPM,
                frequency,
                order: Some(i + 1),
            })
    });
    Measured {
        points: points.collect(),
        leave_out: vec![ModeKind::Lag],
    }
}

//! Critical speeds: rotor speeds at which a frequency is a multiple of the speed.

use std::f64::consts::TAU;

use super::FrequencyTable;

/// A speed at which a frequency is a multiple of the speed: a frequency in the fixed system or, of a
/// single blade, in the turning axes.
#[derive(Debug, Clone, PartialEq)]
pub struct CriticalSpeed {
    /// Name of the mode.
    pub name: String,
    /// Multiple of the rotor speed; zero where the frequency in the fixed system passes through
    /// zero, and the whirl changes its direction.
    pub order: u32,
    /// Rotor speed [rad/s].
    pub speed: f64,
    /// Frequency [Hz].
    pub frequency: f64,
}

impl FrequencyTable {
    /// The critical speeds of a single blade, ascending, at which a frequency in the turning axes is
    /// one of the multiples `orders` of the speed: there the forces of a steady wind or of gravity,
    /// which repeat every revolution, excite the mode. Empty for other models.
    pub fn critical_of_blade(&self, orders: &[u32]) -> Vec<CriticalSpeed> {
        if !self.is_single_blade {
            return Vec::new();
        }
        let of_branch = |branch: &super::ModeBranch| {
            let points = branch.points.iter();
            let points: Vec<_> = points
                .map(|point| Some((point.as_ref()?.frequency, false)))
                .collect();
            crossings(&branch.name, &points, &self.speeds, orders)
        };
        let mut found: Vec<_> = self.branches.iter().flat_map(of_branch).collect();
        found.sort_by(|a, b| a.speed.total_cmp(&b.speed));
        found
    }
}

/// The critical speeds of a mode by linear interpolation: the signed frequency \[Hz\] at each of the
/// `speeds` \[rad/s\], and whether it runs around the rotor; such a mode meets the multiples in both
/// directions, and zero.
pub(super) fn crossings(
    name: &str,
    points: &[Option<(f64, bool)>],
    speeds: &[f64],
    orders: &[u32],
) -> Vec<CriticalSpeed> {
    let mut found = Vec::new();
    for k in 1..speeds.len().min(points.len()) {
        let (Some((a, a_runs)), Some((b, b_runs))) = (points[k - 1], points[k]) else {
            continue;
        };
        let runs = a_runs || b_runs;
        let zero = runs.then_some(0);
        for order in zero.into_iter().chain(orders.iter().copied()) {
            let signs: &[f64] = if order > 0 && runs {
                &[1.0, -1.0]
            } else {
                &[1.0]
            };
            for sign in signs {
                let turns = |speed: f64| sign * f64::from(order) * speed / TAU;
                let gaps = [a - turns(speeds[k - 1]), b - turns(speeds[k])];
                // At rest all multiples are zero.
                let crosses = gaps[1] == 0.0 || (gaps[0] > 0.0) != (gaps[1] > 0.0);
                if gaps[0] == 0.0 || !crosses {
                    continue;
                }
                let part = gaps[0] / (gaps[0] - gaps[1]);
                found.push(CriticalSpeed {
                    name: name.to_owned(),
                    order,
                    speed: speeds[k - 1] + part * (speeds[k] - speeds[k - 1]),
                    frequency: match order {
                        0 => 0.0,
                        _ => (a + part * (b - a)).abs(),
                    },
                });
            }
        }
    }
    found
}

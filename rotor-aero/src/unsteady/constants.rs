//! Constants of dynamic stall, for the model with a vortex.

use super::section::Constant;

/// Constants of the model of Beddoes and Leishman for one airfoil at one Mach number.
///
/// Times are in semichords travelled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StallConstants {
    /// Time constant of leading-edge pressure, T_p \[-\].
    pub pressure_time: f64,
    /// Time constant of separation, T_f \[-\].
    pub separation_time: f64,
    /// Time constant of the decay of vortex lift, T_v \[-\].
    pub vortex_time: f64,
    /// Time of the vortex from the leading to the trailing edge, T_vl \[-\].
    pub passage_time: f64,
    /// Normal coefficient of delayed pressure at which the vortex is shed, C_N1 \[-\].
    pub critical_normal: f64,
    /// Offset of the aerodynamic center from the quarter chord, K_0 \[-\].
    pub center: f64,
    /// Shift of the center of pressure with separation, K_1 \[-\].
    pub center_shift: f64,
    /// Depth of the moment break, K_2 \[-\].
    pub moment_break: f64,
    /// Recovery of leading-edge suction, eta \[-\].
    pub suction: f64,
}

/// Mach numbers of the published constants.
const MACH: [f64; 7] = [0.3, 0.4, 0.5, 0.6, 0.7, 0.75, 0.8];

/// Rows T_p, T_f, T_v, T_vl, C_N1, K_0, K_1, K_2, eta of NACA 0012 [Leishman1989].
const NACA0012: [[f64; 7]; 9] = [
    [1.7, 1.8, 2.0, 2.5, 3.0, 3.3, 4.3],
    [3.0, 2.5, 2.2, 2.0, 2.0, 2.0, 2.0],
    [6.0, 6.0, 6.0, 6.0, 6.0, 6.0, 4.0],
    [7.0, 9.0, 9.0, 9.0, 9.0, 9.0, 9.0],
    [1.45, 1.2, 1.05, 0.92, 0.68, 0.5, 0.18],
    [0.0025, 0.006, 0.02, 0.038, 0.03, 0.001, -0.01],
    [-0.135, -0.135, -0.125, -0.12, -0.09, -0.13, 0.02],
    [0.04, 0.05, 0.04, 0.04, 0.15, -0.02, -0.01],
    [0.965, 0.96, 0.96, 0.96, 0.96, 0.955, 0.955],
];

impl StallConstants {
    /// All by their names in files; K_0, K_1 and K_2 are of this model alone.
    pub(super) fn named(&mut self) -> [Constant<'_>; 9] {
        [
            ("T_p", &mut self.pressure_time),
            ("T_f0", &mut self.separation_time),
            ("T_V0", &mut self.vortex_time),
            ("T_VL", &mut self.passage_time),
            ("Cn1", &mut self.critical_normal),
            ("K_0", &mut self.center),
            ("K_1", &mut self.center_shift),
            ("K_2", &mut self.moment_break),
            ("eta_e", &mut self.suction),
        ]
    }

    /// All with their names in files.
    pub fn values(mut self) -> [(&'static str, f64); 9] {
        self.named().map(|(name, value)| (name, *value))
    }

    /// The published constants of NACA 0012, linear between Mach numbers .3 to .8, constant
    /// outside.
    pub fn naca0012(mach: f64) -> Self {
        let it = NACA0012.map(|row| between(&row, mach));
        Self {
            pressure_time: it[0],
            separation_time: it[1],
            vortex_time: it[2],
            passage_time: it[3],
            critical_normal: it[4],
            center: it[5],
            center_shift: it[6],
            moment_break: it[7],
            suction: it[8],
        }
    }
}

/// A row of constants at a Mach number.
fn between(row: &[f64; 7], mach: f64) -> f64 {
    let last = MACH.len() - 1;
    if mach >= MACH[last] {
        return row[last];
    }
    let next = MACH.iter().position(|&it| mach < it).unwrap_or(last);
    if next == 0 {
        return row[0];
    }
    let weight = (mach - MACH[next - 1]) / (MACH[next] - MACH[next - 1]);
    row[next - 1] + weight * (row[next] - row[next - 1])
}

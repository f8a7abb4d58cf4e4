//! The position of the plate of a swashplate for a pitch of the blades, and the lengths of its
//! actuators.
//!
//! The plate is at the height h above its position without pitch and turned by the rotation vector
//! `(a_x, a_y, 0)`; the end of a link on it is ahead of the blade by the angle d, at the radius r.
//! With the horn ahead of the pitch axis by y,
//!
//! ```text
//! h = y theta0        a_x = y/r (y/r theta1c + x/r theta1s)        a_y = y/r (y/r theta1s - x/r theta1c)
//! ```
//!
//! for small angles, x = r cos d, y = r sin d. Exactly, the pitch of a blade keeps the length of its
//! link; its mean and first harmonics are corrected by the linear relation until they are the
//! commanded ones.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::vector;
use std::f64::consts::TAU;

/// Azimuths at which the pitch is evaluated.
const AZIMUTHS: usize = 36;
/// Most iterations of the pitch, and of the position of the plate.
const ITERATIONS: usize = 60;
/// Remaining error of the pitch \[rad\].
const TOLERANCE: f64 = 1e-13;

/// The links of a swashplate.
#[derive(Debug, Clone, Copy)]
pub(super) struct Links {
    /// Distance of the plate below the center of the hub \[m\].
    pub below: f64,
    /// Ends of the links along the blade and ahead of its pitch axis \[m\].
    pub horn: [f64; 2],
    /// Cone angle of the blades \[rad\].
    pub precone: f64,
    /// Distance of the cone of the blades below the center of the hub \[m\].
    pub undersling: f64,
}

/// Height \[m\] and rotation about both axes \[rad\] of the plate.
pub(super) type Position = [f64; 3];

impl Links {
    /// The end of a link on the blade at an azimuth and a pitch \[rad\], from the center of the hub
    /// \[m\].
    pub fn top(&self, azimuth: f64, pitch: f64) -> Vector3<f64> {
        let [x, y] = self.horn;
        let of_blade = Vector3::new(x, y * pitch.cos(), y * pitch.sin());
        let cone = vector::to_rotation(&(Vector3::y() * -self.precone));
        let turn = vector::to_rotation(&(Vector3::z() * azimuth));
        turn * (cone * of_blade - Vector3::z() * self.undersling)
    }

    /// The end of the link on the plate in the undeformed model \[m\].
    pub fn bottom(&self, azimuth: f64) -> Vector3<f64> {
        let top = self.top(azimuth, 0.0);
        Vector3::new(top.x, top.y, -self.below)
    }

    /// Heights of the plate and tilts, linear, from `(theta0, theta1c, theta1s)`: the factors of
    /// each.
    pub fn linear(&self) -> Matrix3<f64> {
        let [x, y] = self.horn;
        let square = x * x + y * y;
        let [same, other] = [y * y / square, x * y / square];
        Matrix3::new(y, 0.0, 0.0, 0.0, same, other, 0.0, -other, same)
    }

    /// The position of the plate that gives the mean and first harmonics of the pitch exactly.
    ///
    /// # Errors
    /// The remaining error as a height at the horn \[m\], if there is no such position.
    pub fn exact(&self, wanted: [f64; 3]) -> Result<Position, f64> {
        let (linear, wanted) = (self.linear(), Vector3::from(wanted));
        let mut position = linear * wanted;
        let mut off = f64::INFINITY;
        for _ in 0..ITERATIONS {
            let Some(found) = self.harmonics(&position.into()) else {
                break;
            };
            let error = wanted - found;
            off = error.amax() * self.horn[1].abs();
            if error.amax() < TOLERANCE {
                return Ok(position.into());
            }
            position += linear * error;
        }
        Err(off)
    }

    /// Mean and first harmonics of the pitch \[rad\].
    pub fn harmonics(&self, position: &Position) -> Option<Vector3<f64>> {
        let mut sum = Vector3::zeros();
        for k in 0..AZIMUTHS {
            let azimuth = TAU * k as f64 / AZIMUTHS as f64;
            let pitch = self.pitch(position, azimuth)?;
            let (sin, cos) = azimuth.sin_cos();
            sum += Vector3::new(1.0, 2.0 * cos, 2.0 * sin) * pitch;
        }
        Some(sum / AZIMUTHS as f64)
    }

    /// The pitch of a blade at an azimuth: its link has the undeformed length. `None` if it
    /// cannot.
    pub fn pitch(&self, position: &Position, azimuth: f64) -> Option<f64> {
        let [height, x, y] = *position;
        let plate = Vector3::z() * -self.below;
        let turn = vector::to_rotation(&Vector3::new(x, y, 0.0));
        let bottom = plate + Vector3::z() * height + turn * (self.bottom(azimuth) - plate);
        let length = (self.top(azimuth, 0.0) - self.bottom(azimuth)).norm_squared();
        let mut pitch = 0.0;
        for _ in 0..ITERATIONS {
            let link = self.top(azimuth, pitch) - bottom;
            // The rate of the top by the pitch is the top of a quarter turn more, about the span.
            let rate = self.top(azimuth, pitch + TAU / 4.0) - self.span(azimuth);
            let step = (link.norm_squared() - length) / (2.0 * link.dot(&rate));
            pitch -= step;
            if step.abs() < TOLERANCE * 1e-2 {
                return Some(pitch);
            }
            if step.is_nan() || step.abs() >= TAU {
                return None;
            }
        }
        None
    }

    /// The point of the pitch axis beside the horn \[m\].
    fn span(&self, azimuth: f64) -> Vector3<f64> {
        let on_axis = Self {
            horn: [self.horn[0], 0.0],
            ..*self
        };
        on_axis.top(azimuth, 0.0)
    }
}

/// Actuators between mast and plate.
#[derive(Debug, Clone)]
pub(super) struct Actuators {
    /// Radius of their ends on the plate \[m\].
    pub radius: f64,
    /// Radius of their bases \[m\].
    pub base_radius: f64,
    /// Distance of the bases below the plate without pitch \[m\].
    pub base_below: f64,
    /// Azimuths of the three \[rad\].
    pub azimuths: Vec<f64>,
}

impl Actuators {
    /// The end on the plate without pitch, and the base, from the center of the plate \[m\].
    pub fn ends(&self, azimuth: f64) -> [Vector3<f64>; 2] {
        let (sin, cos) = azimuth.sin_cos();
        [
            Vector3::new(self.radius * cos, self.radius * sin, 0.0),
            Vector3::new(
                self.base_radius * cos,
                self.base_radius * sin,
                -self.base_below,
            ),
        ]
    }

    /// The length at an azimuth for a position of the plate \[m\]. The plate is held in its rotation
    /// by scissors in the plane of azimuth zero.
    pub fn length(&self, azimuth: f64, [height, x, y]: Position) -> f64 {
        let turn = vector::to_rotation(&Vector3::new(x, y, 0.0));
        // The point of azimuth zero stays in the plane of the mast and azimuth zero.
        let spin = (-turn[(1, 0)]).atan2(turn[(1, 1)]);
        let turn = turn * vector::to_rotation(&(Vector3::z() * spin));
        let [end, base] = self.ends(azimuth);
        (Vector3::z() * height + turn * end - base).norm()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of `tests/reference/theory-rotor/gimbal_swashplate.json`, an independent prototype:
    /// controls \[deg\], position of the plate, lengths of the actuators.
    const CASES: [([f64; 3], [f64; 6]); 3] = [
        (
            [4.0, 0.0, 0.0],
            [
                0.013476654091008452,
                0.0,
                0.0,
                0.31347665409100844,
                0.31347665409100844,
                0.31347665409100844,
            ],
        ),
        (
            [8.0, 2.0, -4.0],
            [
                0.02686476497651336,
                0.014999645207983907,
                -0.07328679439339682,
                0.3298619159616099,
                0.3126848396380534,
                0.3380482676774483,
            ],
        ),
        (
            [12.0, 2.0, -7.0],
            [
                0.040108813696139445,
                0.0020099597772707018,
                -0.1208125555268511,
                0.3405098290681362,
                0.31903638507367216,
                0.36078494195229754,
            ],
        ),
    ];

    fn links(precone: f64) -> Links {
        let (sin, cos) = 75.0_f64.to_radians().sin_cos();
        Links {
            below: 0.15,
            horn: [0.2 * cos, 0.2 * sin],
            precone,
            undersling: 0.0,
        }
    }

    // The prototype has the same plate; its lengths are the lengths for a plate without scissors, whose
    // rotation vector is in its plane. The tolerance is the round-off of its iteration.
    #[test]
    fn positions_of_the_plate_are_those_of_the_prototype() {
        let actuators = [90.0_f64, 210.0, 330.0].map(f64::to_radians);
        for (wanted, expected) in CASES {
            let found = links(0.0).exact(wanted.map(f64::to_radians)).unwrap();
            for i in 0..3 {
                assert!(
                    (found[i] - expected[i]).abs() < 1e-11,
                    "{wanted:?} {found:?}"
                );
            }
            let turn = vector::to_rotation(&Vector3::new(found[1], found[2], 0.0));
            for (azimuth, expected) in actuators.into_iter().zip(&expected[3..]) {
                let (sin, cos) = azimuth.sin_cos();
                let rim = Vector3::new(0.2 * cos, 0.2 * sin, 0.0);
                let length = (turn * rim - rim + Vector3::z() * (0.3 + found[0])).norm();
                assert!((length - expected).abs() < 1e-11, "{wanted:?} {length}");
            }
        }
    }

    // The prototype's pitch for given positions, to the digits that it lists \[deg\].
    #[test]
    fn harmonics_are_those_of_the_prototype() {
        for (position, expected) in [
            ([0.02, 0.0, 0.0], [5.9413, 0.0, 0.0]),
            ([0.01, 0.05, -0.04], [2.9701, 3.4828, -1.5259]),
            ([0.02, 0.1, 0.1], [5.9686, 4.2119, 7.2937]),
        ] {
            let found = links(0.0)
                .harmonics(&position)
                .unwrap()
                .map(f64::to_degrees);
            assert!((found - Vector3::from(expected)).amax() < 6e-5, "{found}");
        }
    }

    // For small angles the exact position is the linear one, to second order, also with precone up
    // to the cosine of the cone; an impossible pitch is an error.
    #[test]
    fn small_angles_are_linear_and_large_ones_are_refused() {
        for scale in [1e-3, 1e-4] {
            let wanted = [scale, 0.5 * scale, -scale];
            let found = Vector3::from(links(0.0).exact(wanted).unwrap());
            let linear = links(0.0).linear() * Vector3::from(wanted);
            assert!((found - linear).amax() < scale * scale, "{found} {linear}");
        }
        let coned = links(0.05);
        let found = coned.exact([0.1, 0.02, -0.05]).unwrap();
        let back = coned.harmonics(&found).unwrap();
        assert!((back - Vector3::new(0.1, 0.02, -0.05)).amax() < 1e-12);
        assert!(links(0.0).exact([2.5, 0.0, 0.0]).is_err());
    }

    // A pitch keeps the length of the link, and scissors turn the plate in its plane only: the
    // lengths of both differ by the square of the tilt times the radius at most.
    #[test]
    fn random_positions_keep_the_length_of_links() {
        let actuators = Actuators {
            radius: 0.2,
            base_radius: 0.22,
            base_below: 0.3,
            azimuths: Vec::new(),
        };
        let mut seed = 1_u64;
        let mut random = || {
            seed = seed
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        for _ in 0..300 {
            let position = [0.04 * random(), 0.3 * random(), 0.3 * random()];
            let azimuth = TAU * random();
            let links = links(0.1 * random());
            let pitch = links.pitch(&position, azimuth).unwrap();
            let plate = Vector3::z() * -links.below;
            let turn = vector::to_rotation(&Vector3::new(position[1], position[2], 0.0));
            let bottom =
                plate + Vector3::z() * position[0] + turn * (links.bottom(azimuth) - plate);
            let length = (links.top(azimuth, pitch) - bottom).norm();
            let rest = (links.top(azimuth, 0.0) - links.bottom(azimuth)).norm();
            assert!((length - rest).abs() < 1e-12);
            let [end, base] = actuators.ends(azimuth);
            let free = (turn * end + Vector3::z() * position[0] - base).norm();
            let tilt = position[1].hypot(position[2]);
            assert!((actuators.length(azimuth, position) - free).abs() < 0.2 * tilt * tilt);
        }
    }
}

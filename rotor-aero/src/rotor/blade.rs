//! The rigid rotor and the shape of its blades.
//!
//! In the plane of shaft and blade, with `x` along the wind and `z` away from the shaft, the
//! station at the distance `s` along the axis of the blade, with the prebend `p`, is at
//!
//! ```text
//! x = -s sin cone + p cos cone,  z = s cos cone + p sin cone
//! ```
//!
//! and the span leans by `kappa = atan(-dx / dz)`.

use crate::momentum::{END_MARGIN, Options};

/// The border between the signs of the core and the signs of a machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Machine {
    /// Power is positive if the wind drives the rotor, thrust is along the wind, twist and pitch
    /// are positive towards feather, the suction side is downwind.
    #[default]
    Turbine,
    /// Power is positive if the shaft drives the rotor, thrust is against the wind, twist and
    /// pitch are positive nose up. Lifting rotors too, in axial flight.
    Propeller,
}

/// The radius of a station in solidity and losses. On straight blades without cone both agree.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum AnnulusRadius {
    /// The distance from the shaft: the ring that momentum describes.
    #[default]
    ToShaft,
    /// The distance along the axis of the blade, for comparisons with programs that use it
    /// (CCBlade): .1 % of power at a cone of 2.5 degrees.
    AlongBlade,
}

/// A station of a blade.
#[derive(Debug, Clone, PartialEq)]
pub struct Station<S> {
    /// Distance from the shaft along the axis of the blade \[m\].
    pub radius: f64,
    /// Chord \[m\].
    pub chord: f64,
    /// Angle of the chord to the plane of rotation at zero pitch; its sign is of the machine
    /// \[rad\].
    pub twist: f64,
    /// Offset from the axis of the blade, downwind positive \[m\].
    pub prebend: f64,
    /// Airfoil.
    pub section: S,
}

/// A rotor with rigid blades. Stations ascend from hub to tip; a station at the hub or the tip
/// has no load, and gives the prebend there.
#[derive(Debug, Clone, PartialEq)]
pub struct RigidRotor<S> {
    /// Signs.
    pub machine: Machine,
    /// Number of blades.
    pub blades: usize,
    /// Distance from the shaft at which the blades begin, along their axis \[m\].
    pub hub_radius: f64,
    /// Distance from the shaft at which the blades end, along their axis \[m\].
    pub tip_radius: f64,
    /// Angle of the blades to the plane of rotation, tips upwind positive \[rad\].
    pub precone: f64,
    /// Angle of the shaft to the horizon, upwind end up positive \[rad\].
    pub tilt: f64,
    /// Angle of the shaft to the wind about the vertical axis \[rad\].
    pub yaw: f64,
    /// Height of the hub above the ground, for shear \[m\].
    pub hub_height: f64,
    /// Stations.
    pub stations: Vec<Station<S>>,
    /// Switches of annular momentum.
    pub options: Options,
    /// Radius in solidity and losses.
    pub annulus_radius: AnnulusRadius,
    /// Whether the induced velocity varies over the azimuth with the skew of the wake.
    pub skewed_wake: bool,
    /// Number of azimuths, from the blade up; one if the flow is axial.
    pub sectors: usize,
}

/// A point of the axis of a blade, in the plane of shaft and blade.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Point {
    /// Along the wind.
    pub x: f64,
    /// Distance from the shaft.
    pub z: f64,
    /// Radius in solidity and losses.
    pub annulus: f64,
    /// Length along the blade from the hub.
    pub arc: f64,
    /// Lean of the span out of the plane of rotation, upwind positive.
    pub lean: f64,
    /// Index of the station; absent at an end without one.
    pub station: Option<usize>,
}

impl<S> RigidRotor<S> {
    /// Largest distance of the blades from the shaft, at their tip: the radius of the disk \[m\].
    pub fn disk_radius(&self) -> f64 {
        self.points().last().map_or(self.tip_radius, |tip| tip.z)
    }

    /// Points from hub to tip, both included.
    pub(crate) fn points(&self) -> Vec<Point> {
        let (sin, cos) = self.precone.sin_cos();
        let point = |offset: Offset| {
            let z = offset.radius * cos + offset.prebend * sin;
            Point {
                x: offset.prebend * cos - offset.radius * sin,
                z,
                annulus: match self.annulus_radius {
                    AnnulusRadius::ToShaft => z,
                    AnnulusRadius::AlongBlade => offset.radius,
                },
                arc: 0.0,
                lean: 0.0,
                station: offset.station,
            }
        };
        let mut points: Vec<Point> = self.offsets().into_iter().map(point).collect();
        measure(&mut points);
        points
    }

    /// Stations, with hub and tip if they have no station: there the prebend is extrapolated along
    /// the nearest two stations.
    fn offsets(&self) -> Vec<Offset> {
        let stations = self.stations.iter().enumerate();
        let mut offsets: Vec<Offset> = stations
            .map(|(index, station)| Offset {
                radius: station.radius,
                prebend: station.prebend,
                station: Some(index),
            })
            .collect();
        let mut ends = offsets.iter();
        let hub = extrapolated(self.hub_radius, ends.next(), ends.next());
        let mut ends = offsets.iter().rev();
        let tip = extrapolated(self.tip_radius, ends.next(), ends.next());
        let margin = END_MARGIN * self.tip_radius.abs();
        if offsets
            .first()
            .is_none_or(|it| it.radius > hub.radius + margin)
        {
            offsets.insert(0, hub);
        }
        if offsets
            .last()
            .is_none_or(|it| it.radius < tip.radius - margin)
        {
            offsets.push(tip);
        }
        offsets
    }
}

/// A point of the blade before its cone.
#[derive(Debug, Clone, Copy)]
struct Offset {
    radius: f64,
    prebend: f64,
    station: Option<usize>,
}

/// The offset at a radius, on the line through the nearest two.
fn extrapolated(radius: f64, near: Option<&Offset>, next: Option<&Offset>) -> Offset {
    let prebend = match (near, next) {
        (Some(near), Some(next)) if near.radius != next.radius => {
            let slope = (next.prebend - near.prebend) / (next.radius - near.radius);
            near.prebend + slope * (radius - near.radius)
        }
        (near, _) => near.map_or(0.0, |near| near.prebend),
    };
    Offset {
        radius,
        prebend,
        station: None,
    }
}

/// Lengths along the blade, and its lean as the mean of both neighboring pieces.
fn measure(points: &mut [Point]) {
    let pieces: Vec<(f64, f64)> = points
        .windows(2)
        .map(|pair| {
            let (dx, dz) = (pair[1].x - pair[0].x, pair[1].z - pair[0].z);
            (dx.hypot(dz), (-dx).atan2(dz))
        })
        .collect();
    let mut arc = 0.0;
    for (index, point) in points.iter_mut().enumerate() {
        let before = index.checked_sub(1).and_then(|it| pieces.get(it));
        let after = pieces.get(index);
        arc += before.map_or(0.0, |piece| piece.0);
        point.arc = arc;
        point.lean = match (before, after) {
            (Some(one), Some(other)) => 0.5 * (one.1 + other.1),
            (Some(one), None) | (None, Some(one)) => one.1,
            (None, None) => 0.0,
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rotor(prebend: fn(f64) -> f64) -> RigidRotor<()> {
        let station = |radius: f64| Station {
            radius,
            chord: 1.0,
            twist: 0.0,
            prebend: prebend(radius),
            section: (),
        };
        RigidRotor {
            machine: Machine::Turbine,
            blades: 3,
            hub_radius: 1.0,
            tip_radius: 11.0,
            precone: 0.1,
            tilt: 0.0,
            yaw: 0.0,
            hub_height: 0.0,
            stations: [2.0, 5.0, 9.0].map(station).to_vec(),
            options: Options::default(),
            annulus_radius: AnnulusRadius::ToShaft,
            skewed_wake: false,
            sectors: 1,
        }
    }

    #[test]
    fn a_straight_blade_leans_by_its_cone() {
        let points = rotor(|_| 0.0).points();
        assert_eq!(points.len(), 5);
        for point in &points {
            assert!((point.lean - 0.1).abs() < 1e-14);
            assert!((point.z - point.arc * 0.1f64.cos() - 0.1f64.cos()).abs() < 1e-13);
        }
        assert!((points[4].arc - 10.0).abs() < 1e-13);
        assert!((rotor(|_| 0.0).disk_radius() - 11.0 * 0.1f64.cos()).abs() < 1e-13);
    }

    /// A linear prebend upwind is an additional cone.
    #[test]
    fn linear_prebend_is_cone() {
        let points = rotor(|radius| -0.2 * radius).points();
        let expected = 0.1 + 0.2f64.atan();
        for point in &points {
            assert!((point.lean - expected).abs() < 1e-13, "{point:?}");
        }
        let tip = points[4];
        assert!((tip.x + 11.0 * 1.04f64.sqrt() * expected.sin()).abs() < 1e-12);
    }

    #[test]
    fn no_stations_are_no_panic() {
        let mut empty = rotor(|_| 0.0);
        empty.stations.clear();
        assert_eq!(empty.points().len(), 2);
    }
}

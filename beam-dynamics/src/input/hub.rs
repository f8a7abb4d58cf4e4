//! The hub: axis of rotation, direction of azimuth zero, and support.

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::schema::ValueKind::{NotNegative, Table as OneTable, Vector};
use shared_geom::document::{Key, Nested, Table};
use shared_geom::keys;
use shared_geom::rotation::vector;
use shared_geom::units::Dimension;

use super::misplaced_keys;
use super::moments::{INERTIA, moments};
use super::problem::InputProblem;
use crate::case::FrameRotation;
use crate::elements::bodies::RigidInertia;

keys! {
    /// Rotation of the model, and the support of the hub.
    pub(super) CARD = "[hub]";
    /// Axis of rotation, of any length.
    AXIS: Vector3<f64> = "axis", [Vector(3, Dimension::NUMBER)], or "[0, 0, 1]" = Vector3::z(),
        "[0, 0, -1]";
    /// A point on the axis, the center of the hub.
    CENTER: Vector3<f64> = "center", [Vector(3, Dimension::LENGTH)],
        or "[0, 0, 0]" = Vector3::zeros(), "[0, 0, 80]";
    /// Stiffnesses of the support; the hub is then the node `hub`. Directions that are not named
    /// are fixed.
    SUPPORT: Nested = "support", [OneTable(&SUPPORT_TABLE)], optional, "";
    /// Dampers of the support.
    SUPPORT_DAMPING: Nested = "support_damping", [OneTable(&DAMPING_TABLE)], optional, "";
    /// Mass of the hub; only with `support`.
    MASS: f64 = "mass", [NotNegative(Dimension::MASS)], or "0" = 0.0, "2500";
    with INERTIA.schema;
}

keys! {
    /// Stiffness in each direction.
    SUPPORT_TABLE = "support = { ... }";
    /// Across the axis.
    IN_PLANE: Option<f64> = "in_plane", [NotNegative(Dimension::SPRING_STIFFNESS)], or "fixed", "4e6";
    /// Along the axis.
    AXIAL: Option<f64> = "axial", [NotNegative(Dimension::SPRING_STIFFNESS)], or "fixed", "9e6";
    /// About the diameters, moment per radian.
    TILT: Option<f64> = "tilt", [NotNegative(Dimension::MOMENT)], or "fixed", "2e7";
    /// About the axis, moment per radian.
    TORSION: Option<f64> = "torsion", [NotNegative(Dimension::MOMENT)], or "fixed", "2e7";
}

keys! {
    /// Damping in each direction that the support has.
    DAMPING_TABLE = "support_damping = { ... }";
    /// Across the axis.
    IN_PLANE_DAMPER: Option<f64> = "in_plane", [NotNegative(Dimension::DAMPER)], or "0", "3e4";
    /// Along the axis.
    AXIAL_DAMPER: Option<f64> = "axial", [NotNegative(Dimension::DAMPER)], or "0", "3e4";
    /// About the diameters.
    TILT_DAMPER: Option<f64> = "tilt", [NotNegative(Dimension::TURNING_DAMPER)], or "0", "1e4";
    /// About the axis.
    TORSION_DAMPER: Option<f64> = "torsion", [NotNegative(Dimension::TURNING_DAMPER)], or "0", "1e4";
}

/// Name of the node of a hub that moves.
pub(super) const HUB: &str = "hub";
/// Smallest sine of the angle between the axis and x for which the direction of azimuth
/// zero is defined: a twentieth of a degree.
const SMALLEST_SINE: f64 = 1e-3;

/// Mass and support of a hub.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct MovingHub {
    /// Mass and moments of inertia about the center of the hub.
    pub inertia: RigidInertia,
    /// Stiffness in each direction; `None` if the hub is held \[N/m, N m\].
    pub stiffness: [Option<f64>; 4],
    /// Damping in each direction \[N s/m, N m s\].
    pub damping: [f64; 4],
}

/// Axis and center of rotation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Hub {
    axis: Vector3<f64>,
    center: Vector3<f64>,
    /// Direction whose part across the axis is azimuth zero.
    zero: Vector3<f64>,
    /// Its support; `None` for a hub that is held by the frame.
    moving: Option<MovingHub>,
}

/// Reads `[hub]`; `None` if it is wrong, the z axis through the origin if absent.
pub(super) fn read(root: &Table<'_>) -> Option<Hub> {
    let default = FrameRotation::default();
    let mut hub = Hub {
        axis: default.axis,
        center: default.center,
        zero: Vector3::x(),
        moving: None,
    };
    if !root.has("hub") {
        return Some(hub);
    }
    let table = root.table("hub")?;
    let axis = table.get(&AXIS).and_then(|axis| unit(&table, axis));
    let center = table.get(&CENTER);
    let moving = MovingHub::read(&table);
    table.finish_beside(&misplaced_keys::OF_HUB);
    (hub.axis, hub.center, hub.moving) = (axis?, center?, moving?);
    Some(hub)
}

fn unit(table: &Table<'_>, axis: Vector3<f64>) -> Option<Vector3<f64>> {
    // Scaled first, so that very small and very large components keep their digits.
    let largest = axis.amax();
    if largest == 0.0 {
        table.note(&AXIS, &InputProblem::NoAxis);
        return None;
    }
    Some((axis / largest).normalize())
}

impl Hub {
    /// A hub that is held at the origin of a frame, with the axis z and azimuth zero along x of its
    /// axes (columns).
    pub fn in_frame(origin: Vector3<f64>, axes: &Matrix3<f64>) -> Self {
        Self {
            axis: axes.column(2).into_owned(),
            center: origin,
            zero: axes.column(0).into_owned(),
            moving: None,
        }
    }

    /// Axis and center, in the form of the case.
    pub fn frame_rotation(&self) -> FrameRotation {
        FrameRotation {
            axis: self.axis,
            center: self.center,
        }
    }

    /// The support of the hub; `None` if the frame holds it.
    pub fn moving(&self) -> Option<&MovingHub> {
        self.moving.as_ref()
    }

    /// Axes of the hub (columns): the axes of a blade at azimuth zero if they exist, always
    /// with z along the axis.
    pub fn axes(&self) -> Matrix3<f64> {
        self.blade_axes(0.0).unwrap_or_else(|| {
            let across = Vector3::y() - self.axis * self.axis.y;
            let x = across.normalize();
            Matrix3::from_columns(&[x, self.axis.cross(&x), self.axis])
        })
    }

    /// Axes of a blade (columns) at `azimuth` \[rad\]: x out along the span, z along
    /// the axis, y = z x x in the direction of motion.
    ///
    /// At azimuth zero x is the projection of the model's x, or of x of the frame of the hub; `None`
    /// if the axis points along it.
    pub fn blade_axes(&self, azimuth: f64) -> Option<Matrix3<f64>> {
        let across = self.zero - self.axis * self.axis.dot(&self.zero);
        if across.norm() < SMALLEST_SINE {
            return None;
        }
        let span = across.normalize();
        let at_zero = Matrix3::from_columns(&[span, self.axis.cross(&span), self.axis]);
        Some(self.turn(azimuth) * at_zero)
    }

    /// The point at `azimuth` \[rad\] that is at `position` for azimuth zero \[m\].
    pub fn at_azimuth(&self, position: Vector3<f64>, azimuth: f64) -> Vector3<f64> {
        self.center + self.turn(azimuth) * (position - self.center)
    }

    /// Axes for naming if no blade gives them, of a span that begins `at` a point: x along the span, y
    /// in the direction of motion, z = x x y, along the axis if the span is in the plane of rotation; if
    /// the span is along the axis of rotation itself, the model's axes.
    pub fn naming_axes(&self, span: &Vector3<f64>, at: &Vector3<f64>) -> Matrix3<f64> {
        let mut motion = self.axis.cross(span);
        if motion.norm() < SMALLEST_SINE * span.norm() {
            motion = self.axis.cross(&(at - self.center));
        }
        if motion.norm() == 0.0 {
            return Matrix3::identity();
        }
        let x = span.normalize();
        // The direction of motion is across a span that is nearly along the axis, too.
        let y = (motion - x * x.dot(&motion)).normalize();
        Matrix3::from_columns(&[x, y, x.cross(&y)])
    }

    /// Axes of a shaft (columns): x along the axis of rotation.
    pub fn shaft_axes(&self) -> Matrix3<f64> {
        let axes = self.axes();
        Matrix3::from_columns(&[axes.column(2), axes.column(0), axes.column(1)])
    }

    /// Distance of a point from the axis of rotation \[m\].
    pub fn distance(&self, position: &Vector3<f64>) -> f64 {
        self.axis.cross(&(position - self.center)).norm()
    }

    fn turn(&self, azimuth: f64) -> Matrix3<f64> {
        vector::to_rotation(&(self.axis * azimuth))
    }
}

impl MovingHub {
    /// Reads the support in `[hub]`: `None` if it is wrong, `Some(None)` if the frame holds
    /// the hub.
    fn read(table: &Table<'_>) -> Option<Option<Self>> {
        if !table.has(&SUPPORT) {
            let useless = [MASS.name(), INERTIA.name(), SUPPORT_DAMPING.name()];
            let useless: Vec<_> = useless.into_iter().filter(|key| table.has(key)).collect();
            for key in &useless {
                table.note(key, &InputProblem::HeldHub { key });
            }
            return useless.is_empty().then_some(None);
        }
        let mass = table.get(&MASS);
        let moments = moments(table, HUB);
        let stiffness = [&IN_PLANE, &AXIAL, &TILT, &TORSION];
        let stiffness = directions(table, &SUPPORT, stiffness);
        let damping = [
            &IN_PLANE_DAMPER,
            &AXIAL_DAMPER,
            &TILT_DAMPER,
            &TORSION_DAMPER,
        ];
        let damping = directions(table, &SUPPORT_DAMPING, damping);
        let (stiffness, damping) = (stiffness?, damping?);
        let held = (0..4).find(|&i| damping[i].is_some() && stiffness[i].is_none());
        if let Some(i) = held {
            let direction = [&IN_PLANE, &AXIAL, &TILT, &TORSION][i].name();
            table.note(&SUPPORT_DAMPING, &InputProblem::DampedClamp { direction });
            return None;
        }
        let central = Matrix3::from_diagonal(&moments?);
        Some(Some(Self {
            inertia: RigidInertia::about_node(mass?, &Vector3::zeros(), &central),
            stiffness,
            damping: damping.map(|damping| damping.unwrap_or(0.0)),
        }))
    }
}

/// A number for each direction in the table under `key`: across the axis, along it, about the
/// diameters, about it.
fn directions(
    table: &Table<'_>,
    key: &Key<Nested>,
    of: [&Key<Option<f64>>; 4],
) -> Option<[Option<f64>; 4]> {
    let found = table.nested(key, |table| {
        let [a, b, c, d] = of.map(|key| table.get(key));
        Some([a?, b?, c?, d?])
    });
    found.map(Option::unwrap_or_default)
}

#[cfg(test)]
mod tests {
    use super::*;
    use shared_geom::document::Document;
    use std::f64::consts::FRAC_PI_2;

    fn hub(text: &str) -> Result<Hub, String> {
        let document = Document::parse(text, "a.toml").unwrap();
        let hub = read(&document.root());
        document
            .finish(hub)
            .map_err(|problems| problems.to_string())
    }

    #[test]
    fn axes_are_normalized_and_zero_is_refused() {
        let found = hub("[hub]\naxis = [0, 0, -1e-200]\ncenter = [1, 2, 3]\n").unwrap();
        assert_eq!(found.axis, -Vector3::z());
        assert_eq!(found.center, Vector3::new(1.0, 2.0, 3.0));
        assert_eq!(hub("").unwrap().frame_rotation(), FrameRotation::default());
        let shown = hub("[hub]\naxis = [0, 0, 0]\ncentre = [1, 1, 1]\n").unwrap_err();
        assert!(
            shown.contains("a.toml:2: \"axis\" has no direction"),
            "{shown}"
        );
        assert!(shown.contains("did you mean \"center\"?"), "{shown}");
    }

    // Right-hand rotation about +z: a blade at azimuth 90 degrees is along +y and moves
    // toward -x.
    #[test]
    fn azimuth_turns_about_the_axis_through_the_center() {
        let hub = Hub {
            axis: Vector3::z(),
            center: Vector3::new(1.0, 0.0, 0.0),
            zero: Vector3::x(),
            moving: None,
        };
        let axes = hub.blade_axes(FRAC_PI_2).unwrap();
        let expected = Matrix3::from_columns(&[Vector3::y(), -Vector3::x(), Vector3::z()]);
        assert!((axes - expected).amax() < 1e-15);
        let moved = hub.at_azimuth(Vector3::new(3.0, 0.0, 5.0), FRAC_PI_2);
        assert!((moved - Vector3::new(1.0, 2.0, 5.0)).amax() < 1e-15);
    }

    #[test]
    fn an_axis_along_x_has_no_azimuth() {
        let hub = Hub {
            axis: -Vector3::x(),
            center: Vector3::zeros(),
            zero: Vector3::x(),
            moving: None,
        };
        assert_eq!(hub.blade_axes(0.0), None);
        let own = Matrix3::from_columns(&[Vector3::y(), -Vector3::z(), -Vector3::x()]);
        assert_eq!(hub.axes(), own);
        let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
        assert_eq!(hub.naming_axes(&x, &x), Matrix3::identity());
        // A span along the axis: at y = 1 it moves toward -z.
        let aside = Matrix3::from_columns(&[x, -z, y]);
        assert_eq!(hub.naming_axes(&x, &y), aside);
        // A cone of 60 degrees: flap is across the span.
        let (s, c) = std::f64::consts::FRAC_PI_3.sin_cos();
        let coned = hub.naming_axes(&(-x * s + y * c), &y);
        let expected = Matrix3::from_columns(&[-x * s + y * c, -z, -x * c - y * s]);
        assert!((coned - expected).amax() < 1e-15);
    }
}

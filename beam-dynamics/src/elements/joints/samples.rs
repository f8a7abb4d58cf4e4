//! One joint of every kind, with every way to drive it, for tests.

use nalgebra::{Matrix3, Vector3};
use shared_geom::expression::{Expression, Names};

use super::{ConstraintJoint, Freedom, JointEnds, Placing, Turning, axes_along};
use crate::elements::{Input, Signal};
use crate::model::{Drive, Harmonic, Node, Quantity, Scalar, ScalarSpec, ScalarStart};

/// A drive with three derivatives of order one.
pub(in crate::elements) fn drive(mean: f64) -> Drive {
    Drive::Harmonic(Harmonic {
        frequency: 0.3,
        amplitude: 0.4,
        mean,
        phase: 0.7,
        start: -10.0,
        cycles: f64::INFINITY,
    })
}

/// A scalar with a rate, which is the scalar `rate` if there is one.
fn scalar(rate: Option<Scalar>) -> Scalar {
    let quantity = Quantity::new("place", "m", 1.0);
    Scalar::new(ScalarSpec {
        owner: "actuator".to_owned(),
        unknown: quantity.clone(),
        equation: quantity,
        has_rate: true,
        rate,
        start: ScalarStart::Settled,
    })
}

/// A signal of time and two scalars whose rates are scalars, with derivatives of order one.
pub(in crate::elements) fn signal(mean: f64) -> Signal {
    let inputs = [0.5, 0.8].map(|unit| Input {
        scalar: scalar(Some(scalar(None))),
        unit,
    });
    let names = Names {
        variables: &["t", "a", "b"],
        constants: &[],
    };
    let text = format!("{mean} + (0.2*sin(a) + 0.1*b*cos(a))/(5 + t)");
    let expression = Expression::parse(&text, &names).expect("a sum of known names");
    Signal::sensing(expression, inputs.into(), [0.3, 0.7])
}

/// Geometry and drives of the joints of [`all`].
pub(in crate::elements) struct Setting<'a> {
    pub ends: JointEnds<'a>,
    /// The point and the axes that the ends share.
    pub point: Vector3<f64>,
    pub axes: Matrix3<f64>,
    /// A further point, on a.
    pub other: Vector3<f64>,
    /// A further axis, on b.
    pub second_axis: Vector3<f64>,
    /// The driving signal, by its mean.
    pub drive: fn(f64) -> Signal,
}

impl Setting<'_> {
    pub fn placing(&self) -> Placing {
        Placing::at(&self.point, &self.axes)
    }

    /// With different points.
    pub(super) fn apart(&self) -> Placing {
        Placing {
            points: [self.other, self.point],
            ..self.placing()
        }
    }

    pub fn universal(&self) -> Placing {
        Placing {
            axes: [self.axes, axes_along(&self.second_axis)],
            ..self.placing()
        }
    }
}

/// Freedoms of a total joint: bits for held ones; every second of them driven, if by anything.
pub(in crate::elements) fn freedoms(bits: u32, drive: Option<fn(f64) -> Signal>) -> [Freedom; 6] {
    std::array::from_fn(
        |i| match (bits >> i & 1 == 1, drive.filter(|_| i % 2 == 1)) {
            (false, _) => Freedom::Free,
            (true, None) => Freedom::Locked,
            (true, Some(drive)) => Freedom::Driven(drive(0.1)),
        },
    )
}

/// Every kind of joint.
pub(in crate::elements) fn all(setting: &Setting<'_>) -> Vec<ConstraintJoint> {
    use ConstraintJoint as Joint;
    let (ends, drive) = (&setting.ends, setting.drive);
    let (at, apart) = (setting.placing(), setting.apart());
    let angle = || Some(Turning::Angle(drive(2.0)));
    let speed = || Some(Turning::Speed(drive(2.0)));
    let slide = || Freedom::Driven(drive(0.1));
    let rates = |bits: u32| std::array::from_fn(|i| (bits >> i & 1 == 1).then(|| drive(0.3)));
    let mut joints = vec![
        Joint::clamp("clamp", ends, &at),
        Joint::spherical("spherical", ends, &at),
        Joint::revolute("revolute", ends, &at, None),
        Joint::revolute("revolute by angle", ends, &at, angle()),
        Joint::revolute("revolute by speed", ends, &at, speed()),
        Joint::cylindrical("cylindrical", ends, &at, Freedom::Free, None),
        Joint::cylindrical("driven cylindrical", ends, &apart, slide(), angle()),
        Joint::universal("universal", ends, &setting.universal()),
        Joint::prismatic("prismatic", ends, &at, Freedom::Free),
        Joint::prismatic("driven prismatic", ends, &apart, slide()),
        Joint::in_line("in-line", ends, &apart),
        Joint::in_plane("in-plane", ends, &apart, None),
        Joint::in_plane("driven in-plane", ends, &at, Some(drive(0.2))),
        Joint::plane_rotation("plane rotation", ends, &at, None),
        Joint::plane_rotation("driven plane rotation", ends, &at, angle()),
        Joint::distance("distance", ends, &apart, Drive::Constant(1.3)),
        Joint::distance("driven distance", ends, &apart, drive(1.3)),
        Joint::spin("spin by speed", ends, &at, Turning::Speed(drive(2.0))),
        Joint::spin("spin by angle", ends, &at, Turning::Angle(drive(2.0))),
        Joint::velocity("velocity", ends, &at, rates(0b000_111)),
        Joint::velocity("velocities", ends, &apart, rates(0b101_101)),
    ];
    for bits in 1..64 {
        joints.push(Joint::total("total", ends, &at, freedoms(bits, None)));
        let driven = freedoms(bits, Some(drive));
        joints.push(Joint::total("driven total", ends, &apart, driven));
    }
    joints
}

/// Settings with two nodes and with one, at the given undeformed nodes.
pub(in crate::elements) fn settings<'a>(
    nodes: &'a [Node],
    mut vector: impl FnMut() -> Vector3<f64>,
) -> [Setting<'a>; 2] {
    let b = (1, &nodes[1]);
    let alone = (0, &nodes[0]);
    [(Some((0, &nodes[0])), b), (None, alone)].map(|(a, b)| Setting {
        ends: JointEnds { a, b },
        point: b.1.position + 0.4 * vector(),
        axes: axes_along(&vector()),
        other: b.1.position - Vector3::new(1.2, 0.0, 0.0) + 0.2 * vector(),
        second_axis: vector(),
        drive: |mean| drive(mean).into(),
    })
}

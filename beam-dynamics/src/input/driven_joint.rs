//! Driven joints, and how the modes of a model show them.

use super::number::short_number;
use crate::elements::Signal;

/// Digits of speeds.
const DIGITS: usize = 6;

/// A joint whose motion changes in time.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum DrivenJoint {
    /// A position, an angle or a length that is a drive.
    Position {
        /// Name of the joint.
        name: String,
    },
    /// A speed that is not zero at the time zero \[m/s or rad/s\].
    Speed {
        /// Name of the joint.
        name: String,
        /// The speed.
        speed: f64,
    },
}

impl DrivenJoint {
    /// The joint `name` with the signals of its positions and of its speeds; `None` if these do not
    /// change in time, or by sensors only, which act in modes.
    pub fn new(name: &str, positions: &[&Signal], speeds: &[&Signal]) -> Option<Self> {
        let name = name.to_owned();
        let speeds = speeds.iter().filter_map(|speed| speed.drive());
        let mut moving = speeds.map(|drive| drive.at(0.0).value);
        if let Some(speed) = moving.find(|speed| *speed != 0.0) {
            return Some(Self::Speed { name, speed });
        }
        let mut drives = positions.iter().filter_map(|position| position.drive());
        let changes = drives.any(|drive| drive.constant().is_none());
        changes.then_some(Self::Position { name })
    }
}

/// Remarks on modes with driven joints.
pub(super) fn remarks(joints: &[DrivenJoint]) -> Vec<String> {
    let mut positions = Vec::new();
    let mut speeds = Vec::new();
    for joint in joints {
        match joint {
            DrivenJoint::Position { name } => positions.push(format!("\"{name}\"")),
            DrivenJoint::Speed { name, speed } => {
                let speed = short_number(*speed, DIGITS);
                speeds.push(format!("\"{name}\" ({speed} in SI units)"));
            }
        }
    }
    let held = listed(&positions).map(|names| {
        format!(
            "driven joints are held in modes where their drives are at the time zero, so that their \
             own motion is no mode: {names}; to see that mode leave out the drive, and give the joint \
             the stiffness of its drive train by a [[spring]]"
        )
    });
    let moving = listed(&speeds).map(|names| {
        format!(
            "joints move with a speed at the time zero, where a model in motion has no equilibrium \
             and no modes: {names}; leave out the speed, which for a rotor is \"speeds\" of [modes]"
        )
    });
    held.into_iter().chain(moving).collect()
}

/// The first names, and the number of the others; `None` without any.
fn listed(names: &[String]) -> Option<String> {
    const MOST: usize = 3;
    let shown = names.get(..MOST.min(names.len()))?.join(", ");
    match names.len() {
        0 => None,
        count if count > MOST => Some(format!("{shown} and {} more", count - MOST)),
        _ => Some(shown),
    }
}

#[cfg(test)]
mod tests {
    use crate::input;

    const MODEL: &str = "units = \"SI\"\n[[node]]\nname = \"arm\"\nposition = [1, 0, 0]\n[[body]]\n\
        node = \"arm\"\nmass = 1\ninertia = [1, 1, 1]\n[modes]\nspeeds = 0\n[[joint]]\n\
        name = \"motor\"\nkind = \"revolute\"\nnodes = [\"arm\"]\nat = [0, 0, 0]\naxis = [0, 0, 1]\n";

    fn remarks(drive: &str) -> Vec<String> {
        let input = input::parse(&format!("{MODEL}{drive}\n"), "a.dynamics.toml");
        let remarks = input
            .unwrap_or_else(|problems| panic!("{problems}"))
            .remarks;
        let of_joint = |remark: &String| remark.contains("\"motor\"") && !remark.contains("freely");
        remarks.into_iter().filter(of_joint).collect()
    }

    #[test]
    fn modes_teach_what_they_show_of_a_driven_joint() {
        assert_eq!(
            remarks("angle = \"= 10*sin(t)\""),
            [
                "driven joints are held in modes where their drives are at the time zero, so that their \
              own motion is no mode: \"motor\"; to see that mode leave out the drive, and give the \
              joint the stiffness of its drive train by a [[spring]]"
            ]
        );
        assert_eq!(
            remarks("speed = \"10 rad/s\""),
            [
                "joints move with a speed at the time zero, where a model in motion has no equilibrium \
              and no modes: \"motor\" (10 in SI units); leave out the speed, which for a rotor is \
              \"speeds\" of [modes]"
            ]
        );
        for still in ["angle = 10", "speed = 0", ""] {
            assert!(remarks(still).is_empty(), "{still}");
        }
    }

    #[test]
    fn few_of_many_names_are_listed() {
        let names = ["a", "b", "c", "d", "e"].map(str::to_owned);
        assert_eq!(super::listed(&[]), None);
        assert_eq!(super::listed(&names[..3]).unwrap(), "a, b, c");
        assert_eq!(super::listed(&names).unwrap(), "a, b, c and 2 more");
    }
}

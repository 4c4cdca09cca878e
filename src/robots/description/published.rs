//! Arms whose Denavit-Hartenberg parameters their makers publish. A table may
//! belong to another arm by mistake.

use crate::{SerialJoint, TableConvention};

/// A published table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PublishedArm {
    /// Short name: `ur5e`.
    pub name: &'static str,
    /// Name of the maker and the robot.
    pub title: &'static str,
    /// Convention of the rows.
    pub convention: TableConvention,
    /// Parameters alpha (deg), a (mm), theta (deg) and d (mm) of each joint.
    pub rows: &'static [[f64; 4]],
}

/// Published tables. Sources: Universal Robots, DH parameters for calculations of kinematics and
/// dynamics (universal-robots.com/articles); Franka Robotics, FCI documentation,
/// Denavit-Hartenberg parameters.
pub const PUBLISHED: [PublishedArm; 9] = [
    PublishedArm {
        name: "ur3",
        title: "Universal Robots UR3",
        convention: TableConvention::Standard,
        rows: &[
            [90.0, 0.0, 0.0, 151.9],
            [0.0, -243.65, 0.0, 0.0],
            [0.0, -213.25, 0.0, 0.0],
            [90.0, 0.0, 0.0, 112.35],
            [-90.0, 0.0, 0.0, 85.35],
            [0.0, 0.0, 0.0, 81.9],
        ],
    },
    PublishedArm {
        name: "ur5",
        title: "Universal Robots UR5",
        convention: TableConvention::Standard,
        rows: &[
            [90.0, 0.0, 0.0, 89.159],
            [0.0, -425.0, 0.0, 0.0],
            [0.0, -392.25, 0.0, 0.0],
            [90.0, 0.0, 0.0, 109.15],
            [-90.0, 0.0, 0.0, 94.65],
            [0.0, 0.0, 0.0, 82.3],
        ],
    },
    PublishedArm {
        name: "ur10",
        title: "Universal Robots UR10",
        convention: TableConvention::Standard,
        rows: &[
            [90.0, 0.0, 0.0, 127.3],
            [0.0, -612.0, 0.0, 0.0],
            [0.0, -572.3, 0.0, 0.0],
            [90.0, 0.0, 0.0, 163.941],
            [-90.0, 0.0, 0.0, 115.7],
            [0.0, 0.0, 0.0, 92.2],
        ],
    },
    PublishedArm {
        name: "ur3e",
        title: "Universal Robots UR3e",
        convention: TableConvention::Standard,
        rows: &[
            [90.0, 0.0, 0.0, 151.85],
            [0.0, -243.55, 0.0, 0.0],
            [0.0, -213.2, 0.0, 0.0],
            [90.0, 0.0, 0.0, 131.05],
            [-90.0, 0.0, 0.0, 85.35],
            [0.0, 0.0, 0.0, 92.1],
        ],
    },
    PublishedArm {
        name: "ur5e",
        title: "Universal Robots UR5e",
        convention: TableConvention::Standard,
        rows: &[
            [90.0, 0.0, 0.0, 162.5],
            [0.0, -425.0, 0.0, 0.0],
            [0.0, -392.2, 0.0, 0.0],
            [90.0, 0.0, 0.0, 133.3],
            [-90.0, 0.0, 0.0, 99.7],
            [0.0, 0.0, 0.0, 99.6],
        ],
    },
    PublishedArm {
        name: "ur10e",
        title: "Universal Robots UR10e",
        convention: TableConvention::Standard,
        rows: &[
            [90.0, 0.0, 0.0, 180.7],
            [0.0, -612.7, 0.0, 0.0],
            [0.0, -571.55, 0.0, 0.0],
            [90.0, 0.0, 0.0, 174.15],
            [-90.0, 0.0, 0.0, 119.85],
            [0.0, 0.0, 0.0, 116.55],
        ],
    },
    PublishedArm {
        name: "ur16e",
        title: "Universal Robots UR16e",
        convention: TableConvention::Standard,
        rows: &[
            [90.0, 0.0, 0.0, 180.7],
            [0.0, -478.4, 0.0, 0.0],
            [0.0, -360.0, 0.0, 0.0],
            [90.0, 0.0, 0.0, 174.15],
            [-90.0, 0.0, 0.0, 119.85],
            [0.0, 0.0, 0.0, 116.55],
        ],
    },
    PublishedArm {
        name: "ur20",
        title: "Universal Robots UR20",
        convention: TableConvention::Standard,
        rows: &[
            [90.0, 0.0, 0.0, 236.3],
            [0.0, -862.0, 0.0, 0.0],
            [0.0, -728.7, 0.0, 0.0],
            [90.0, 0.0, 0.0, 201.0],
            [-90.0, 0.0, 0.0, 159.3],
            [0.0, 0.0, 0.0, 154.3],
        ],
    },
    PublishedArm {
        name: "panda",
        title: "Franka Emika Panda / Franka Research 3",
        convention: TableConvention::Modified,
        rows: &[
            [0.0, 0.0, 0.0, 333.0],
            [-90.0, 0.0, 0.0, 0.0],
            [90.0, 0.0, 0.0, 316.0],
            [90.0, 82.5, 0.0, 0.0],
            [-90.0, -82.5, 0.0, 384.0],
            [90.0, 0.0, 0.0, 0.0],
            [90.0, 88.0, 0.0, 0.0],
        ],
    },
];

/// Twists (rad) and lengths (mm) within which two tables are alike.
const SAME_RAD: f64 = 0.01;
const SAME_MM: f64 = 1.0;

impl PublishedArm {
    /// Returns the joints of this arm, if a table of the same twists and motions with other lengths
    /// is `stated`.
    pub(crate) fn instead(&self, convention: TableConvention, stated: &[SerialJoint]) -> Option<Vec<SerialJoint>> {
        if self.convention != convention || self.rows.len() != stated.len() {
            return None;
        }
        let joint = |(&[alpha, a_mm, theta, d_mm], stated): (&[f64; 4], &SerialJoint)| SerialJoint {
            alpha_rad: alpha.to_radians(),
            a_mm,
            theta_rad: theta.to_radians(),
            d_mm,
            ..*stated
        };
        let joints: Vec<SerialJoint> = self.rows.iter().zip(stated).map(joint).collect();
        let pairs = || joints.iter().zip(stated);
        let is_alike = pairs().all(|(a, b)| {
            let turns = [a.alpha_rad - b.alpha_rad, a.theta_rad - b.theta_rad];
            !b.prismatic && turns.iter().all(|by| by.abs() < SAME_RAD)
        });
        let is_same = pairs().all(|(a, b)| (a.a_mm - b.a_mm).abs() < SAME_MM && (a.d_mm - b.d_mm).abs() < SAME_MM);
        (is_alike && !is_same).then_some(joints)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Robot, Serial};

    /// A UR5e may be any of the other seven arms of its maker, and no other arm.
    #[test]
    fn an_arm_may_be_another_of_its_family() {
        let ur5e = PUBLISHED.iter().find(|arm| arm.name == "ur5e").unwrap();
        let joint = |&[alpha, a_mm, theta, d_mm]: &[f64; 4]| SerialJoint {
            alpha_rad: alpha.to_radians(),
            a_mm,
            theta_rad: theta.to_radians(),
            d_mm,
            prismatic: false,
            parallel: alpha == 0.0,
        };
        let joints: Vec<SerialJoint> = ur5e.rows.iter().map(joint).collect();
        let may_be = |joints: &[SerialJoint]| {
            let others = PUBLISHED.iter().filter(|arm| arm.instead(TableConvention::Standard, joints).is_some());
            others.map(|arm| arm.name).collect::<Vec<_>>()
        };
        assert_eq!(may_be(&joints), ["ur3", "ur5", "ur10", "ur3e", "ur10e", "ur16e", "ur20"]);
        assert!(may_be(&joints[..5]).is_empty());
        let arm = Serial::from_axis_table(TableConvention::Standard, &joints, &["T".to_owned()]);
        // the other convention, and seven arms with the same parameters
        let others = arm.alternatives();
        assert_eq!(others.len(), 8);
        let names = |robot: &dyn Robot| robot.parameters().iter().map(|p| p.name.clone()).collect::<Vec<_>>();
        assert!(others[1..].iter().all(|(_, other)| names(other.as_ref()) == names(&arm)));
    }
}

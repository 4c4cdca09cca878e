//! Document forms of the roles and effects of parameters.

use crate::mirror::mirror;

mirror! {
    /// Owner of a parameter, which decides whether it is fitted before the calibration.
    #[serde(rename_all = "snake_case")]
    #[derive(Default)]
    enum Role of etalon_robots::Role {
        /// Pose of the base in the world.
        Base,
        /// Positions of the targets on the moving part.
        Target,
        /// Points and planes fixed in the world that targets touch or are measured from.
        Fixture,
        /// Geometry, joint offsets, gains and compliance of the robot itself.
        #[default]
        Robot,
    }
}

mirror! {
    /// Effect that a parameter of the robot itself describes.
    #[derive(clap::ValueEnum)]
    #[serde(rename_all = "snake_case")]
    enum Effect of etalon_robots::Effect {
        /// Zeros of the joints.
        Zeros,
        /// Lengths and angles of the parts.
        Geometry,
        /// Gains: leads and transmission ratios.
        Gains,
        /// Harmonics of the transmissions.
        Harmonics,
        /// Backlash of the joints.
        Backlash,
        /// Coupling between joints.
        Coupling,
        /// Bending of joints and links under their own loads.
        Bending,
        /// Bending of joints under a payload that each reading gives.
        Payload,
        /// Bending of joints under their torques, which each reading gives.
        Torque,
        /// Common expansion of all lengths with the temperature that each reading gives.
        Expansion,
        /// Drift of the zeros of joints with the temperature that each reading gives.
        Drift,
        /// Tilt of revolute joints across their axes under the moment of masses and payload.
        Lateral,
        /// Tilt and torsion of the base under the moment of masses and payload.
        Pedestal,
    }
}

//! Roles and effects of parameters, as documents spell them.

use crate::mirror::mirror;

mirror! {
    /// What a parameter describes: decides what is fitted "before" the calibration.
    #[serde(rename_all = "snake_case")]
    #[derive(Default)]
    enum Role of etalon_robots::Role {
        /// Pose of the base in the world.
        Base,
        /// Places of the targets on the moving part.
        Target,
        /// What targets touch or are measured from: points and planes that are fixed in the world.
        Fixture,
        /// Geometry, joint offsets, gains and compliance of the robot itself.
        #[default]
        Robot,
    }
}

mirror! {
    /// What a parameter of the robot itself describes.
    #[derive(clap::ValueEnum)]
    #[serde(rename_all = "snake_case")]
    enum Effect of etalon_robots::Effect {
        /// Zeros of the joints.
        Zeros,
        /// Lengths and angles of the parts.
        Geometry,
        /// Gains: leads, ratios of the transmissions.
        Gains,
        /// Harmonics of the transmissions.
        Harmonics,
        /// Backlash of the joints.
        Backlash,
        /// Coupling of one joint to another.
        Coupling,
        /// Bending of joints and links under loads.
        Bending,
    }
}

//! Properties of a file that a robot shows: directions, branches, kinematics, motion.

pub(super) mod against;
pub(super) mod branches;
pub(super) mod kinematics;
pub(super) mod motion;
pub(super) mod turned;

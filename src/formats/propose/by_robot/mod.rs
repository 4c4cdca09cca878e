//! What a robot shows of a file: directions, branches, kinematics, motion.

pub(super) mod against;
pub(super) mod branches;
pub(super) mod kinematics;
pub(super) mod motion;
pub(super) mod turned;

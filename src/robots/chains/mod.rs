//! Serial chains: motion, conventions, inverse kinematics, branches.

pub(super) mod arm_kinematics;
pub(super) mod branches;
pub(super) mod chain;
pub(super) mod compensation;
pub(super) mod conventions;
pub(super) mod inverse;

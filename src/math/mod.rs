//! Mathematics, without files and campaigns: least squares, fits of elements, kinematics, identification, the geometric
//! method and the choice of poses.

pub mod axis;
pub mod fit;
pub mod geometric;
pub mod identify;
pub mod plan;
pub mod robots;
pub mod solve;

//! Exchangeability E (ISO 9283:1998 7.7, unverified against a bought copy): five robots with the
//! same programme and mounting.

use crate::iso9283::pose::directions::farthest;
use crate::iso9283::pose::test::PoseTest;
use crate::iso9283::statistics::sample::mean_position;
use etalon_base::error;
use etalon_base::message::{Result, one_line};
use etalon_base::pose::{Vector, minus, norm};

/// Differences between the mean poses of robots of one type.
#[derive(Clone, Debug, PartialEq)]
pub struct Exchangeability {
    /// E: largest distance between the barycentres of two robots at any pose.
    pub e_mm: f64,
    /// Largest distance at each pose.
    pub poses_mm: Vec<f64>,
}

/// Evaluates `attained_mm[robot][pose]`: positions of at least two robots at the same poses.
pub fn exchangeability(attained_mm: &[Vec<Vec<Vector>>]) -> Result<Exchangeability> {
    let poses = attained_mm.first().map_or(0, Vec::len);
    if attained_mm.len() < 2 || poses == 0 || attained_mm.iter().any(|robot| robot.len() != poses) {
        return Err(error!("robots-at-other-poses").into());
    }
    for points in attained_mm.iter().flatten() {
        crate::iso9283::statistics::sample::positions(points, 1, "exchangeability")?;
    }
    let apart = |pose: usize| {
        let means: Vec<Vector> = attained_mm.iter().map(|robot| mean_position(&robot[pose])).collect();
        farthest(means.len(), |h, k| norm(minus(means[h], means[k]))).0
    };
    let poses_mm: Vec<f64> = (0..poses).map(apart).collect();
    Ok(Exchangeability { e_mm: poses_mm.iter().fold(0.0, |m, e| m.max(*e)), poses_mm })
}

/// E of the robots of a test; `None` with a single one.
pub fn exchanged(test: &PoseTest) -> Result<Option<f64>> {
    let robots = test.robots();
    if robots.len() < 2 {
        return Ok(None);
    }
    let lacks = |robot: &&str| test.poses.iter().find(|p| p.attained.iter().all(|v| v.robot != *robot)).map(|p| p.pose);
    if let Some((robot, pose)) = robots.iter().find_map(|robot| Some((robot, lacks(robot)?))) {
        return Err(error!("robot-without-pose", robot = one_line(robot), pose).into());
    }
    let of = |robot: &&str| test.poses.iter().map(|p| p.positions_mm(|v| v.robot == *robot)).collect::<Vec<_>>();
    let attained: Vec<Vec<Vec<Vector>>> = robots.iter().map(of).collect();
    Ok(Some(exchangeability(&attained)?.e_mm))
}

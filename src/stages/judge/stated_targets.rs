//! Targets whose identified position is far from the given one: another flange or tool link, or
//! another target, than the one that the position belongs to.

use etalon_base::message::Message;
use etalon_base::pose::{minus, norm};
use etalon_base::warning;
use etalon_identify::Identification;
use etalon_robots::{Robot, Role};

/// Distance (mm) of an identified target from its given position that a drawing of a tool explains.
const DRAWN_MM: f64 = 10.0;
/// Standard uncertainties of the identified position within which it is not far.
const CERTAIN: f64 = 3.0;

/// Warnings of targets that are far from their given positions. A target at the origin of the
/// flange has no given position.
pub(crate) fn far_targets(robot: &dyn Robot, found: &Identification) -> Vec<Message> {
    let parameters = robot.parameters();
    let target = |target: &String| {
        let index = |axis: &str| robot.index(&format!("{target}_{axis}"));
        let axes = [index("x")?, index("y")?, index("z")?];
        if robot.free_base().is_none() || axes.iter().any(|&i| parameters[i].role != Role::Target) {
            return None;
        }
        let (stated, identified) = (axes.map(|i| parameters[i].nominal), axes.map(|i| found.values[i]));
        let uncertainty = norm(axes.map(|i| found.standard_uncertainty(i).unwrap_or(0.0)));
        let distance_mm = norm(minus(identified, stated));
        let is_far = norm(stated) > 0.0 && distance_mm > DRAWN_MM.max(CERTAIN * uncertainty);
        let ([x_mm, y_mm, z_mm], [sx_mm, sy_mm, sz_mm]) = (identified, stated);
        is_far.then(|| warning!("target-far-from-given", target, distance_mm, x_mm, y_mm, z_mm, sx_mm, sy_mm, sz_mm))
    };
    robot.targets().iter().filter_map(target).collect()
}

//! Kinematics component of LinuxCNC for `halcompile --install`: recorded equations with all
//! identified parameters.
//!
//! Planar robots move in the world, including base and target: x and y of a five-bar; for a PreXYT
//! x, y of ball K and the direction c to ball L (thesis, eq. 3.17 to 3.19). Spatial arms move their
//! flange in the base frame by x, y, z and c, b, a about z, y, x.

use super::code::{formulas, functions};
use super::template::render;
use super::{About, ExportInput, Exporter, is_in_code, value};
use etalon_base::expression::Formula;
use etalon_base::message::Result;
use etalon_base::pose::Pose;
use etalon_base::{error, phrase};
use etalon_robots::{Joint, Quantity, Robot};
use minijinja::context;
use minijinja::value::Serde;

/// Source code of a component.
pub(super) struct LinuxCncComponent;

/// Maximum number of joints in LinuxCNC.
const MOST_JOINTS: usize = 9;

impl Exporter for LinuxCncComponent {
    fn about(&self) -> About<'_> {
        About {
            frame: "the world of LinuxCNC is the world of the campaign for planar robots, otherwise the base of the robot",
            holds: is_in_code,
            ..About::controller("linuxcnc-component", "etalonkins.comp")
        }
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let (robot, values) = given.robot()?;
        let formulas = formulas(given)?;
        let format = "linuxcnc-component";
        let other = || super::other_robot(format, robot, phrase!("kind-planar-or-serial"));
        let arm = robot.kinematics().ok_or_else(other)?;
        let joints = arm.joints().len();
        if joints > MOST_JOINTS {
            return Err(error!("format-too-many-joints", format, joints, most = MOST_JOINTS).into());
        }
        let planar = arm.dimension() == 2;
        if !planar && formulas.iter().all(|formula| formula.name != "linearised") {
            return Err(other().into());
        }
        let direct = &formulas[0];
        let modes = |formula: &Formula, first: usize| formula.inputs.get(first..).unwrap_or_default().to_vec();
        let pose = if planar { direct.outputs.len() } else { 12 };
        let inverse = formulas.iter().find(|formula| formula.name == "inverse");
        let back = inverse.map(|formula| modes(formula, pose)).unwrap_or_default();
        let forth = modes(direct, joints);

        let degrees = |joint: &Joint| if joint.quantity == Quantity::Angle { "DEGREE" } else { "1.0" };
        let units: Vec<&str> = arm.joints().iter().map(degrees).collect();
        let constants = Serde(if planar { constants(robot, &values)? } else { Vec::new() });
        let (header, functions) = (given.header_of_code("mm, deg")?, functions(&formulas)?);
        let values = context! { header, functions, planar, forth, back, pose, units, constants };
        render(include_str!("templates/etalonkins.comp.j2"), values).map(String::into_bytes)
    }
}

/// Base and tool of a planar robot.
fn constants(robot: &dyn Robot, values: &[f64]) -> Result<Vec<(&'static str, f64)>> {
    let base = robot.kinematics().and_then(|arm| arm.base_in_world(values)).unwrap_or(Pose::identity());
    let tool = |name: &str| if robot.index(name).is_some() { value(robot, values, name) } else { Ok(0.0) };
    Ok(vec![
        ("BASE_X", base.translation_mm[0]),
        ("BASE_Y", base.translation_mm[1]),
        ("BASE_C", base.rotation[1][0].atan2(base.rotation[0][0])),
        ("TOOL_X", -tool("x_c")?),
        ("TOOL_Y", -tool("y_c")?),
        ("TOOL_C", tool("epsilon_theta")?),
    ])
}

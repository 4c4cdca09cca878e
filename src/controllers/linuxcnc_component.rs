//! A kinematics component of LinuxCNC, for `halcompile --install`: the recorded equations with all identified parameters.
//!
//! Planar robots move in the world, base and target included: x and y of a five-bar; x, y and c of a PreXYT's ball K and of the direction to
//! ball L (thesis eq. 3.17 to 3.19). Arms in space move their flange in the base frame; x, y, z and c, b, a turn about z, y, x.

use super::code::{formulas, functions, parenthesised};
use super::{Exporter, Given, value};
use etalon_base::expression::Formula;
use etalon_base::message::{Message, Result};
use etalon_base::pose::Pose;
use etalon_robots::{Quantity, Role};
use std::fmt::Write;

/// Source of a component.
pub(super) struct LinuxCncComponent;

/// Joints of LinuxCNC.
const MOST_JOINTS: usize = 9;

const PLANAR_FORWARD: &str = "    c = at[THETA] + TOOL_C;
    world->tran.x = BASE_X + cos(BASE_C) * at[0] - sin(BASE_C) * at[1] + TOOL_X * cos(c + BASE_C) - TOOL_Y * sin(c + BASE_C);
    world->tran.y = BASE_Y + sin(BASE_C) * at[0] + cos(BASE_C) * at[1] + TOOL_X * sin(c + BASE_C) + TOOL_Y * cos(c + BASE_C);
    world->tran.z = world->a = world->b = 0.0;
    world->c = (c + BASE_C) / DEGREE;
";
const PLANAR_INVERSE: &str = "    c = world->c * DEGREE;
    x = world->tran.x - BASE_X - TOOL_X * cos(c) + TOOL_Y * sin(c);
    y = world->tran.y - BASE_Y - TOOL_X * sin(c) - TOOL_Y * cos(c);
    at[0] = cos(BASE_C) * x + sin(BASE_C) * y;
    at[1] = cos(BASE_C) * y - sin(BASE_C) * x;
";
const SPATIAL_FORWARD: &str = "    world->tran.x = at[0];
    world->tran.y = at[1];
    world->tran.z = at[2];
    world->c = atan2(at[6], at[3]) / DEGREE;
    world->b = atan2(-at[9], cos(world->c * DEGREE) * at[3] + sin(world->c * DEGREE) * at[6]) / DEGREE;
    world->a = atan2(sin(world->c * DEGREE) * at[5] - cos(world->c * DEGREE) * at[8],
                     cos(world->c * DEGREE) * at[7] - sin(world->c * DEGREE) * at[4]) / DEGREE;
";
const SPATIAL_INVERSE: &str = "    sa = sin(world->a * DEGREE); ca = cos(world->a * DEGREE);
    sb = sin(world->b * DEGREE); cb = cos(world->b * DEGREE);
    sc = sin(world->c * DEGREE); cc = cos(world->c * DEGREE);
    at[0] = world->tran.x; at[1] = world->tran.y; at[2] = world->tran.z;
    at[3] = cc * cb; at[4] = cc * sb * sa - sc * ca; at[5] = cc * sb * ca + sc * sa;
    at[6] = sc * cb; at[7] = sc * sb * sa + cc * ca; at[8] = sc * sb * ca - cc * sa;
    at[9] = -sb; at[10] = cb * sa; at[11] = cb * ca;
    for (i = 0; i < JOINTS; i++) {
        q[i] = joint[i] * unit[i];
    }
    if (!etalon_inverse(at, q)) {
        return -1;
    }
";
/// An angle goes on from where the joint is; a pose out of reach is refused.
const JOINTS_OUT: &str = "    for (i = 0; i < JOINTS; i++) {
        if (!(fabs(q[i]) < 1e9)) {
            return -1;
        }
        q[i] /= unit[i];
        joint[i] = unit[i] == 1.0 ? q[i] : q[i] + 360.0 * floor((joint[i] - q[i]) / 360.0 + 0.5);
    }
    return 0;
}
";
const FORWARD: &str = "int kinematicsForward(const double *joint, EmcPose *world, const KINEMATICS_FORWARD_FLAGS *fflags, KINEMATICS_INVERSE_FLAGS *iflags)\n{\n";
const INVERSE: &str = "int kinematicsInverse(const EmcPose *world, double *joint, const KINEMATICS_INVERSE_FLAGS *iflags, KINEMATICS_FORWARD_FLAGS *fflags)\n{\n";

impl Exporter for LinuxCncComponent {
    fn file_name(&self) -> &'static str {
        "etalonkins.comp"
    }

    fn bytes(&self, given: &Given) -> Result<Vec<u8>> {
        let (robot, mut values) = given.robot()?;
        let formulas = formulas(given)?;
        let arm = robot.kinematics().filter(|arm| arm.joints().len() <= MOST_JOINTS);
        let arm = arm.ok_or_else(|| Message::error("LinuxCNC moves nine joints at most"))?;
        let planar = arm.dimension() == 2;
        if !planar && formulas.iter().all(|formula| formula.name != "linearised") {
            let message = Message::error("the component is for planar robots and serial arms");
            return Err(message.hint("use linuxcnc-hexapod or linuxcnc-delta").into());
        }
        // a planar robot has its base and its target in the component
        for (value, p) in values.iter_mut().zip(robot.parameters()).filter(|(_, p)| p.role != Role::Robot) {
            let entry = given.parameters.parameters.iter().find(|entry| entry.name == p.name);
            *value = entry.map_or(*value, |entry| p.quantity.inward(entry.value));
        }
        let joints = arm.joints().len();
        let direct = &formulas[0];
        let modes = |formula: &Formula, first: usize| formula.inputs.get(first..).unwrap_or_default().to_vec();
        let pose = if planar { direct.outputs.len() } else { 12 };
        let inverse = formulas.iter().find(|formula| formula.name == "inverse");
        let back = inverse.map(|formula| modes(formula, pose)).unwrap_or_default();
        let forth = modes(direct, joints);

        let mut out: String = given.header_of_code("mm, deg")?.iter().map(|line| format!("// {line}\n")).collect();
        out += "component etalonkins \"Kinematics with identified parameters\";\npin out bit dummy;\n";
        for mode in forth.iter().chain(&back) {
            let _ = writeln!(out, "modparam int {mode} = 1 \"1 or -1: assembly mode, branch of the working mode\";");
        }
        out += "license \"GPL\";\n;;\n#include <rtapi_math.h>\n#include <kinematics.h>\n";
        out += &functions(&formulas);
        let _ = write!(out, "\n#define JOINTS {joints}\n#define DEGREE 0.017453292519943295\n");
        if planar {
            let base = arm.base_in_world(&values).unwrap_or(Pose::identity());
            let turn = base.rotation[1][0].atan2(base.rotation[0][0]);
            let tool = |name: &str| if robot.index(name).is_some() { value(robot, &values, name) } else { Ok(0.0) };
            let constants = [
                ("BASE_X", base.translation_mm[0]),
                ("BASE_Y", base.translation_mm[1]),
                ("BASE_C", turn),
                ("TOOL_X", -tool("x_c")?),
                ("TOOL_Y", -tool("y_c")?),
                ("TOOL_C", tool("epsilon_theta")?),
            ];
            for (name, value) in constants {
                let _ = writeln!(out, "#define {name} {}", parenthesised(value));
            }
        }
        let units = arm.joints().iter().map(|joint| if joint.quantity == Quantity::Angle { "DEGREE" } else { "1.0" });
        let _ = write!(out, "\nstatic const double unit[JOINTS] = {{ {} }};\n", units.collect::<Vec<_>>().join(", "));
        out += "KINEMATICS_TYPE kinematicsType(void) { return KINEMATICS_BOTH; }\nKINS_NOT_SWITCHABLE\n";
        out +=
            "EXPORT_SYMBOL(kinematicsType);\nEXPORT_SYMBOL(kinematicsForward);\nEXPORT_SYMBOL(kinematicsInverse);\n\n";
        let c = if planar { "    double c;\n" } else { "" };
        let _ = write!(out, "{FORWARD}    double q[{}], at[{pose}];\n{c}    int i;\n", direct.inputs.len());
        out += "    for (i = 0; i < JOINTS; i++) {\n        q[i] = joint[i] * unit[i];\n    }\n";
        for (i, mode) in forth.iter().enumerate() {
            let _ = writeln!(out, "    q[{}] = {mode};", joints + i);
        }
        out += "    etalon_direct(q, at);\n    if (!(fabs(at[0]) < 1e9)) {\n        return -1;\n    }\n";
        // a five-bar's tool does not turn
        let theta = if pose == 3 { "at[2]" } else { "-BASE_C" };
        out += &if planar { PLANAR_FORWARD.replace("at[THETA]", theta) } else { SPATIAL_FORWARD.to_owned() };
        let _ =
            write!(out, "    return 0;\n}}\n\n{INVERSE}    double q[JOINTS], at[{}];\n    int i;\n", pose + back.len());
        if planar {
            let _ = write!(out, "    double c, x, y;\n{PLANAR_INVERSE}");
            if pose == 3 {
                out += "    at[2] = c - BASE_C - TOOL_C;\n";
            }
            for (i, mode) in back.iter().enumerate() {
                let _ = writeln!(out, "    at[{}] = {mode};", pose + i);
            }
            out += "    etalon_inverse(at, q);\n";
        } else {
            let _ = write!(out, "    double sa, ca, sb, cb, sc, cc;\n{SPATIAL_INVERSE}");
        }
        Ok((out + JOINTS_OUT).into_bytes())
    }
}

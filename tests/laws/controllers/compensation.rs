//! Pseudo-poses: a simulated true robot whose controller computes with nominal geometry lands on random targets of each model: 200, or
//! as many as `ETALON_TARGETS` says.

use crate::robots::conventions;
use crate::support::arms::SIX_AXES;
use crate::support::root;
use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, minus, norm};
use etalon::campaign::read_robot;
use etalon::robots::{Calibrated, Kinematics, Quantity, Robot, Role};

/// Where a robot is, by formulas of this test; `None` for models that it has none for.
type Direct = fn(&dyn Robot, &[f64], &[f64]) -> Option<[f64; 3]>;

/// C is where the line through revolute joints 2 and 3 meets that of actuator 1 (thesis, figure 3.4).
fn prexyt(_: &dyn Robot, p: &[f64], rho: &[f64]) -> Option<[f64; 3]> {
    let y2 = p[11] * rho[1];
    let (x3, y3) = (p[3] - p[12] * rho[2] * p[0].sin() - p[4] * p[0].tan(), p[12] * rho[2] * p[0].cos() + p[4]);
    // y = y2 + m x and x = c + y tan γ
    let (m, c) = ((y3 - y2) / x3, p[10] * rho[0] + p[5]);
    let y = (y2 + m * c) / (1.0 - m * p[1].tan());
    Some([c + y * p[1].tan(), y, 0.0])
}

/// C is where two circles about the elbows meet (law of cosines), E a fixed triangle beside it.
fn five_bar(_: &dyn Robot, p: &[f64], q: &[f64]) -> Option<[f64; 3]> {
    let elbow = |side: f64, l: f64, a: f64| [side * p[4] / 2.0 + l * a.cos(), l * a.sin()];
    let (b1, b2) = (elbow(-1.0, p[0], q[0] + p[7]), elbow(1.0, p[2], q[1] + p[8]));
    let (dx, dy) = (b2[0] - b1[0], b2[1] - b1[1]);
    let length = dx.hypot(dy);
    let opening = ((p[1] * p[1] + length * length - p[3] * p[3]) / (2.0 * p[1] * length)).acos();
    let direction = dy.atan2(dx) + q[2] * opening;
    let c = [b1[0] + p[1] * direction.cos(), b1[1] + p[1] * direction.sin()];
    let tool = (c[1] - b2[1]).atan2(c[0] - b2[0]) + p[6];
    Some([b2[0] + p[5] * tool.cos(), b2[1] + p[5] * tool.sin(), 0.0])
}

/// Rx(alpha) Tx(a) [Ry(beta)] Rz(theta + gain q) Tz(d) (Craig, Hayati); nothing bends, gravity does not matter.
fn modified_denavit_hartenberg(robot: &dyn Robot, p: &[f64], q: &[f64]) -> Option<[f64; 3]> {
    let value = |name: String| robot.index(&name).map(|i| p[i]);
    let link = |pose: Pose, (i, q): (usize, &f64)| {
        let drawn = SIX_AXES[i - 1][3];
        let of = |name: &str| value(format!("{name}_{i}"));
        let turned = pose.turn_x(of("alpha").unwrap()).shift(0, of("a").unwrap()).turn_y(of("beta").unwrap_or(0.0));
        turned.turn_z(of("theta").unwrap() + of("gain").unwrap() * q).shift(2, of("d").unwrap_or(drawn))
    };
    Some((1..).zip(q).fold(Pose::identity(), link).translation_mm)
}

/// The library's positions of a target at the flange, in the frame of the base.
fn arm(robot: &dyn Robot, p: &[f64], q: &[f64]) -> Option<[f64; 3]> {
    Some(robot.position(p, q, 0))
}

fn range(robot: &dyn Kinematics, joint: usize) -> [f64; 2] {
    match (robot.model(), &robot.joints()[joint]) {
        ("prexyt", _) => [20.0, 160.0],
        ("hexapod", _) => [30.0, 120.0],
        ("delta_linear", _) => [300.0, 420.0],
        ("delta", _) => [-0.3, 1.2],
        (_, joint) if joint.quantity == Quantity::Length => [50.0, 750.0],
        ("five_bar", _) => [0.3, 2.8],
        _ => [-1.9, 1.9],
    }
}

#[test]
fn pseudo_poses_land_on_their_targets() {
    let wanted: usize = std::env::var("ETALON_TARGETS").ok().and_then(|n| n.parse().ok()).unwrap_or(200);
    let of_file = |file: &str| {
        let path = root().join(file);
        read_robot(&path).unwrap().build(&["tool".to_owned()]).unwrap()
    };
    let cases: [(&str, Box<dyn Robot>, Direct); 11] = [
        ("prexyt", of_file("samples/prexyt-cmm/robot.toml"), prexyt),
        ("five-bar", of_file("samples/dextar/robot.toml"), five_bar),
        ("mdh without effects", conventions::robot("mdh", ""), modified_denavit_hartenberg),
        ("mdh", conventions::robot("mdh", conventions::EFFECTS), arm),
        ("dh", conventions::robot("dh", conventions::EFFECTS), arm),
        ("poe", conventions::robot("poe", conventions::EFFECTS), arm),
        ("urdf", conventions::robot("urdf", ""), arm),
        ("urdf of seven joints", of_file("samples/column-arm/robot.toml"), arm),
        ("hexapod", of_file("samples/hexapod/robot.toml"), arm),
        ("delta", of_file("samples/delta/robot.toml"), arm),
        ("delta with towers", of_file("docs/keys/robot-delta_linear.toml"), arm),
    ];
    for (file, robot, direct) in cases {
        let arm = robot.kinematics().unwrap();
        let mut noise = Noise::new(193, 1);
        let real = |p: &etalon::robots::Parameter, noise: &mut Noise| match p.quantity {
            _ if p.role != Role::Robot => p.nominal,
            Quantity::Length => p.nominal + noise.uniform(0.5),
            Quantity::Angle => p.nominal + noise.uniform(2e-3),
            Quantity::Ratio => p.nominal + noise.uniform(1e-3),
        };
        let identified: Vec<f64> = robot.parameters().iter().map(|p| real(p, &mut noise)).collect();
        let calibrated = Calibrated { arm, nominal: arm.nominal(), identified: identified.clone(), field: None };
        let (mut done, mut refused, mut worst) = (0, 0, 0.0f64);
        while done < wanted && refused < wanted {
            let mut q: Vec<f64> = (0..arm.joints().len())
                .map(|i| range(arm, i))
                .map(|[low, high]| 0.5 * (low + high) + noise.uniform(0.5 * (high - low)))
                .collect();
            q.extend(arm.has_assembly_modes().then_some(1.0));
            let target = arm.tool_pose(&calibrated.nominal, &q);
            let Some(target) = target.filter(|_| arm.limit_violation(&calibrated.nominal, &q).is_none()) else {
                continue;
            };
            let Ok(found) = calibrated.compensate(&target, &q) else {
                refused += 1;
                continue;
            };
            // a singularity between: the program says so
            if !calibrated.same_configuration(&q, &found.joints) {
                refused += 1;
                continue;
            }
            // the controller goes to the command by its own inverse, the true robot follows its joints; of more than six joints a
            // pose leaves some free
            let away = if arm.joints().len() > 6 { 0.0 } else { 1e-3 };
            let near: Vec<f64> = found.joints.iter().map(|q| if q.abs() == 1.0 { *q } else { q + away }).collect();
            // a limit that the command itself comes too near to
            let Ok(commanded) = arm.nearest_joints(&calibrated.nominal, &found.command, &near) else {
                refused += 1;
                continue;
            };
            let at = direct(robot.as_ref(), &identified, &commanded).unwrap();
            worst = worst.max(norm(minus(at, target.translation_mm)));
            let turned = arm.tool_pose(&identified, &commanded).unwrap().inverse().then(&target);
            assert!(turned.angle_rad() < 1e-9, "{file}: {} rad at {commanded:?}, {found:?}", turned.angle_rad());
            done += 1;
        }
        println!("{file}: {done} targets, {worst:.1e} mm at most, {refused} refused");
        assert!(worst < 1e-6, "{file}: {worst} mm");
        // near the edge of the workspace and of limits the true robot does not reach what the nominal one does
        assert!(refused * 20 < wanted, "{file}: {refused} of {wanted} refused");
        // outside of it all are refused
        let far = Pose { translation_mm: [4000.0, 3000.0, 0.0], ..Pose::identity() };
        let zero = vec![0.5; arm.joints().len() + usize::from(arm.has_assembly_modes())];
        assert!(calibrated.compensate(&far, &zero).is_err(), "{file}");
    }
}

//! Conventions of controllers for orientations, from manuals and public pages: the orders of angles that `--orientation` and the
//! key `orientation` state.

use etalon::base::angle_order::AngleOrder;
use etalon::base::pose::Pose;

const ANGLES: [[f64; 3]; 5] =
    [[30.0, 0.0, 0.0], [-110.0, 35.0, 80.0], [12.0, -64.0, 170.0], [175.0, 80.0, -33.0], [-5.0, 3.0, 1.0]];

/// Quaternion (w, x, y, z) of r_z(a) r_y(b) r_x(c) by the formulas of the pages on pose formats.
fn cardan([z, y, x]: [f64; 3]) -> [f64; 4] {
    let [(sz, cz), (sy, cy), (sx, cx)] = [z, y, x].map(|v: f64| (v.to_radians() / 2.0).sin_cos());
    [cz * cy * cx + sz * sy * sx, cz * cy * sx - sz * sy * cx, cz * sy * cx + sz * cy * sx, sz * cy * cx - cz * sy * sx]
}

/// Quaternion (w, x, y, z) of r_z(O) r_y(A) r_z(T) by the formulas of the same pages.
fn euler([o, a, t]: [f64; 3]) -> [f64; 4] {
    let [(so, co), (sa, ca), (st, ct)] = [o, a, t].map(|v: f64| (v.to_radians() / 2.0).sin_cos());
    [co * ca * ct - so * ca * st, co * sa * st - so * sa * ct, co * sa * ct + so * sa * st, so * ca * ct + co * ca * st]
}

/// Formula of a source.
type Formula = fn([f64; 3]) -> [f64; 4];

/// Maker, order of its three angles, formula of the source, source.
const MAKERS: [(&str, &str, Formula, &str); 8] = [
    ("KUKA A B C", "zyx", cardan, "docs.baslerweb.com/stereovisard/rc_cube/en/pose_format_kuka: r_z(A) r_y(B) r_x(C)"),
    (
        "FANUC W P R",
        "fixed xyz",
        |[w, p, r]| cardan([r, p, w]),
        "docs.baslerweb.com .. pose_format_fanuc: r_z(R) r_y(P) r_x(W)",
    ),
    (
        "Yaskawa Rx Ry Rz",
        "fixed xyz",
        |[x, y, z]| cardan([z, y, x]),
        "docs.baslerweb.com .. pose_format_yaskawa: r_z(Rz) r_y(Ry) r_x(Rx)",
    ),
    ("Kawasaki O A T", "zyz", euler, "docs.baslerweb.com .. pose_format_kawasaki: r_z(O) r_y(A) r_z(T)"),
    (
        "Mitsubishi A B C",
        "fixed xyz",
        |[a, b, c]| cardan([c, b, a]),
        "docs.baslerweb.com .. pose_format_mitsubishi: r_z(C) r_y(B) r_x(A)",
    ),
    (
        "Franka x y z",
        "fixed xyz",
        |[x, y, z]| cardan([z, y, x]),
        "docs.baslerweb.com .. pose_format_franka_emika: r_z(z) r_y(y) r_x(x)",
    ),
    (
        "UFACTORY roll pitch yaw",
        "fixed xyz",
        |[r, p, y]| cardan([y, p, r]),
        "UFACTORY Lite 6 user manual, p. 95: R_Z(alpha) R_Y(beta) R_X(gamma)",
    ),
    ("Omron V+ yaw pitch roll", "zyz", euler, "V+ Language User's Guide v17.0, p. 168: ZYZ' Euler values"),
];

#[test]
fn orders_of_makers_are_those_of_their_manuals() {
    for (maker, order, formula, source) in MAKERS {
        let order: AngleOrder = order.parse().unwrap();
        for angles in ANGLES {
            let pose = order.pose(angles.map(f64::to_radians));
            let off = pose.inverse().then(&Pose::from_quaternion(formula(angles))).angle_rad();
            assert!(off < 1e-12, "{maker} {angles:?}: {off} ({source})");
        }
    }
    // the other order gives another orientation: the test can fail
    let other: AngleOrder = "xyz".parse().unwrap();
    assert!(
        other
            .pose(ANGLES[1].map(f64::to_radians))
            .inverse()
            .then(&Pose::from_quaternion(cardan(ANGLES[1])))
            .angle_rad()
            > 0.1
    );
}

/// Numbers that sources print.
#[test]
fn examples_of_sources_are_reproduced() {
    let quarter = std::f64::consts::FRAC_PI_2;
    let near = |pose: &Pose, rows: [[f64; 3]; 3], tolerance: f64| {
        (0..9).all(|k| (pose.rotation[k / 3][k % 3] - rows[k / 3][k % 3]).abs() < tolerance)
    };
    // MathWorks, eul2rotm (R2021a): [0 pi/2 0] in the order ZYX, and [0 pi/2 pi/2] in the order ZYZ
    let zyx: AngleOrder = "zyx".parse().unwrap();
    assert!(near(&zyx.pose([0.0, quarter, 0.0]), [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]], 1e-12));
    let zyz: AngleOrder = "zyz".parse().unwrap();
    assert!(near(&zyz.pose([0.0, quarter, quarter]), [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], 1e-12));
    // Omron V+ Language User's Guide v17.0, p. 168: yaw 30 turns about z
    let [c, s] = [30f64.to_radians().cos(), 0.5];
    let yaw = zyz.pose([30f64.to_radians(), 0.0, 0.0]);
    assert!(near(&yaw, [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]], 1e-12));
    // UFACTORY xArm 6 user manual, p. 12: axis [0.707, 0.707, 0] and 90 degrees is [0.707 pi/2, 0.707 pi/2, 0]
    let vector = Pose::from_rotation_vector([0.707 * quarter, 0.707 * quarter, 0.0]);
    let expected = Pose::from_quaternion([(quarter / 2.0).cos(), 0.5, 0.5, 0.0]);
    assert!(vector.inverse().then(&expected).angle_rad() < 1e-3);
    // Universal Robots (docs.baslerweb.com .. pose_format_ur): x = RX sin(θ/2) / θ, w = cos(θ/2)
    let v: [f64; 3] = [1.1, -2.0, 0.4];
    let angle = v.iter().map(|v| v * v).sum::<f64>().sqrt();
    let [x, y, z] = v.map(|v| v * (angle / 2.0).sin() / angle);
    let expected = Pose::from_quaternion([(angle / 2.0).cos(), x, y, z]);
    assert!(Pose::from_rotation_vector(v).inverse().then(&expected).angle_rad() < 1e-12);
    // ABB: an unturned tool is [1,0,0,0], the scalar first (DanielPaans/SMR1, CalibData.mod: `tooldata Gripper`)
    assert!(Pose::from_quaternion([1.0, 0.0, 0.0, 0.0]).angle_rad() == 0.0);
}

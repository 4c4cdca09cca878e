//! Every model: direct(inverse(pose)) = pose, and Jacobian = numeric derivative.

use etalon::base::pose::{Pose, minus, norm};
use etalon::robots::{FiveBar, PlanarPose, Platform, Prexyt, Robot, Serial, SerialJoint};

/// Parameters away from nominal, so that no term of a model is multiplied by zero or one.
fn disturbed(robot: &dyn Robot) -> Vec<f64> {
    robot
        .nominal()
        .iter()
        .enumerate()
        .map(|(i, v)| v * (1.0 + 1e-3 * (i % 5) as f64) + 0.01 * ((i * 7) % 11) as f64 - 0.05)
        .collect()
}

pub fn jacobian_is_the_numeric_derivative(robot: &dyn Robot, q: &[f64]) {
    let p = disturbed(robot);
    let rows = robot.dimension() * robot.targets().len();
    let mut analytic = vec![0.0; rows * p.len()];
    robot.jacobian(&p, q, &mut analytic);
    let at = |p: &[f64]| {
        let mut out = vec![0.0; rows];
        robot.positions(p, q, &mut out);
        out
    };
    for j in 0..p.len() {
        let h = 1e-4;
        let shifted = |k: f64| {
            let mut x = p.clone();
            x[j] += k * h;
            at(&x)
        };
        // fourth-order central difference
        let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(shifted);
        for i in 0..rows {
            let numeric = (a[i] - 8.0 * b[i] + 8.0 * c[i] - d[i]) / (12.0 * h);
            let error = (analytic[i * p.len() + j] - numeric).abs();
            assert!(
                error < 1e-7,
                "{} {}: row {i} {} {numeric}",
                robot.model(),
                robot.parameters()[j].name,
                analytic[i * p.len() + j]
            );
        }
    }
}

/// Rows of the modified table of an IRB 120: alpha (deg), a (mm), theta (deg), d (mm).
const IRB120: [(f64, f64, f64, f64); 6] = [
    (0.0, 0.0, 0.0, 290.0),
    (-90.0, 0.0, -90.0, 0.0),
    (0.0, 270.0, 0.0, 0.0),
    (-90.0, 70.0, 0.0, 302.0),
    (90.0, 0.0, 0.0, 0.0),
    (-90.0, 0.0, 180.0, 72.0),
];

fn irb120() -> Serial {
    let joints: Vec<SerialJoint> = IRB120
        .iter()
        .enumerate()
        .map(|(i, &(alpha, a, theta, d))| SerialJoint {
            alpha_rad: f64::to_radians(alpha),
            a_mm: a,
            theta_rad: f64::to_radians(theta),
            d_mm: d,
            prismatic: false,
            parallel: i == 2,
        })
        .collect();
    let targets: Vec<String> = ["a", "b", "c"].map(String::from).into();
    Serial::new(&joints, &targets, [0.0, 0.0, -1.0], &[2, 3], &[(5, 4), (6, 4), (6, 5)])
}

#[test]
fn jacobians_by_joint_values() {
    let robots: [(Box<dyn Robot>, &[f64]); 4] = [
        (Box::new(Prexyt::new(true)), &[85.0, 150.0, 170.0]),
        (Box::new(FiveBar::default()), &[0.3, -2.5]),
        (Box::new(FiveBar::default()), &[1.6, 1.4]),
        (Box::new(irb120()), &[0.1, -0.5, 0.3, 1.0, -0.7, 2.0]),
    ];
    for (robot, q) in robots {
        joint_jacobian_is_the_numeric_derivative(robot.as_ref(), q);
    }
}

pub fn joint_jacobian_is_the_numeric_derivative(robot: &dyn Robot, q: &[f64]) {
    let mut p = disturbed(robot);
    // bending is that of the joint values themselves
    let bends = |name: &str| name.starts_with("compliance");
    robot.parameters().iter().zip(&mut p).filter(|(a, _)| bends(&a.name)).for_each(|(_, v)| *v = 0.0);
    let (rows, n) = (robot.dimension() * robot.targets().len(), q.len());
    let at = |j: usize, h: f64| {
        let mut q = q.to_vec();
        q[j] += h;
        q.extend(robot.has_assembly_modes().then_some(-1.0));
        q
    };
    let mut exact = vec![0.0; rows * n];
    robot.joint_jacobian(&p, &at(0, 0.0), &mut exact);
    for j in 0..n {
        let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|k| {
            let mut out = vec![0.0; rows];
            robot.positions(&p, &at(j, k * 1e-4), &mut out);
            out
        });
        for i in 0..rows {
            let numeric = (a[i] - 8.0 * b[i] + 8.0 * c[i] - d[i]) / 12e-4;
            assert!((exact[i * n + j] - numeric).abs() < 1e-7, "{} joint {j}: {numeric}", robot.model());
        }
    }
}

#[test]
fn jacobians() {
    for q in [[0.0, 10.0, 44.0], [85.0, 150.0, 170.0], [170.0, 300.0, 255.0]] {
        jacobian_is_the_numeric_derivative(&Prexyt::new(false), &q);
        jacobian_is_the_numeric_derivative(&Prexyt::new(true), &q);
    }
    for q in [[1.6, 1.4, 1.0], [1.6, 1.4, -1.0], [0.3, -2.5, 1.0], [-1.2, -2.0, -1.0]] {
        jacobian_is_the_numeric_derivative(&FiveBar::default(), &q);
    }
    for q in [[0.1, -0.5, 0.3, 1.0, -0.7, 2.0], [-2.0, 0.8, -1.1, -0.4, 1.2, -0.3]] {
        jacobian_is_the_numeric_derivative(&irb120(), &q);
    }
}

#[test]
fn jacobian_of_pose_residuals() {
    let robot = Prexyt::new(true);
    let p = disturbed(&robot);
    let (q, k, l) = ([80.0, 120.0, 170.0], [150.0, 130.0], [290.0, 160.0]);
    let by_parameters = robot.pose_error_jacobian(&p, &q, [k, l]);
    let by_balls = robot.pose_error_by_targets(&p, [k, l]);
    let h = 1e-5;
    for j in 0..p.len() {
        let shifted = |s: f64| {
            let mut x = p.clone();
            x[j] += s;
            robot.pose_residual(&x, &q, k, l)
        };
        let (plus, minus) = (shifted(h), shifted(-h));
        for i in 0..3 {
            let numeric = (plus[i] - minus[i]) / (2.0 * h);
            assert!((by_parameters[i * p.len() + j] - numeric).abs() < 1e-6, "{i} {j}");
        }
    }
    for j in 0..4 {
        let shifted = |s: f64| {
            let mut b = [k[0], k[1], l[0], l[1]];
            b[j] += s;
            robot.pose_residual(&p, &q, [b[0], b[1]], [b[2], b[3]])
        };
        let (plus, minus) = (shifted(h), shifted(-h));
        for i in 0..3 {
            assert!((by_balls[i][j] - (plus[i] - minus[i]) / (2.0 * h)).abs() < 1e-6);
        }
    }
}

#[test]
fn prexyt_inverse_undoes_direct() {
    for full in [false, true] {
        let robot = Prexyt::new(full);
        let p = disturbed(&robot);
        for x in [120.0, 201.0, 280.0] {
            for y in [30.0, 137.5, 250.0] {
                for theta_rad in [-0.5, -0.2, 0.0, 0.3, 0.55] {
                    let pose = PlanarPose { x_mm: x, y_mm: y, theta_rad };
                    let back = robot.direct(&p, &robot.inverse(&p, pose));
                    assert!((back.x_mm - x).abs() < 1e-9 && (back.y_mm - y).abs() < 1e-9, "{back:?} {pose:?}");
                    assert!((back.theta_rad - theta_rad).abs() < 1e-12);
                }
            }
        }
    }
}

#[test]
fn full_prexyt_is_where_the_drawing_of_section_3_4_puts_it() {
    // carriage 1 runs along (cos alpha, sin alpha) = (0.8, 0.6), past height h at x = d1; the guide leans by tan gamma = 0.1;
    // C lies on it at y = 0: x = 116 + 100 * 0.8 - (20 + 100 * 0.6) * 0.1
    let robot = Prexyt::new(true);
    let mut p = robot.nominal();
    for (name, value) in [("gamma", 0.1f64.atan()), ("alpha", 0.6f64.atan2(0.8)), ("h", 20.0), ("d1", 116.0)] {
        p[robot.index(name).unwrap()] = value;
    }
    let pose = robot.direct(&p, &[100.0, 0.0, 0.0]);
    assert!((pose.x_mm - 188.0).abs() < 1e-12 && pose.y_mm.abs() < 1e-12 && pose.theta_rad.abs() < 1e-12, "{pose:?}");
    let back = robot.inverse(&p, PlanarPose { x_mm: 188.0, y_mm: 0.0, theta_rad: 0.0 });
    assert!((back[0] - 100.0).abs() < 1e-12, "{back:?}");
}

#[test]
fn prexyt_balls_measure_the_pose() {
    let robot = Prexyt::new(false);
    let p = disturbed(&robot);
    let q = [60.0, 110.0, 190.0];
    let [k, l] = robot.balls(&p, &q);
    assert!(robot.pose_residual(&p, &q, k, l).iter().all(|r| r.abs() < 1e-12));
}

#[test]
fn serial_inverse_undoes_direct() {
    let robot = irb120();
    let p = disturbed(&robot);
    let q = [0.3, -0.4, 0.5, 0.9, -0.8, 1.5];
    let pose = robot.direct(&p, &q);
    let near: Vec<f64> = q.iter().map(|q| q + 0.1).collect();
    let found = robot.inverse(&p, &pose, &near).expect("reachable");
    assert!(found.iter().zip(&q).all(|(f, q)| (f - q).abs() < 1e-9), "{found:?}");
    let far = Pose { translation_mm: [5000.0, 0.0, 0.0], ..pose };
    assert!(robot.inverse(&p, &far, &near).is_none());
}

#[test]
fn serial_nominal_is_the_product_of_craigs_matrices() {
    // an independent product of 4x4 matrices for the IRB 120 at one pose
    let robot = irb120();
    let q: [f64; 6] = [0.2, -0.3, 0.4, 0.5, -0.6, 0.7];
    let mut t = nalgebra::Matrix4::<f64>::identity();
    for ((alpha, a, theta, d), q) in IRB120.into_iter().zip(q) {
        let (sa, ca) = f64::to_radians(alpha).sin_cos();
        let (st, ct) = (f64::to_radians(theta) + q).sin_cos();
        // Craig, eq. 3.6
        t *= nalgebra::Matrix4::new(
            ct,
            -st,
            0.0,
            a,
            st * ca,
            ct * ca,
            -sa,
            -sa * d,
            st * sa,
            ct * sa,
            ca,
            ca * d,
            0.0,
            0.0,
            0.0,
            1.0,
        );
    }
    let mut bent = robot.nominal();
    let reached = robot.direct(&bent, &q);
    let expected = [t[(0, 3)], t[(1, 3)], t[(2, 3)]];
    assert!(norm(minus(reached.translation_mm, expected)) < 1e-10);
    // a level forearm bends joint 3 by its whole compliance and lowers the wrist
    let k = robot.index("compliance_3_3").unwrap();
    bent[k] = 1e-3;
    let level = [0.0, 0.0, (70.0f64 / 302.0).atan(), 0.0, 0.0, 0.0];
    let (straight, low) = (robot.direct(&robot.nominal(), &level), robot.direct(&bent, &level));
    let drop = straight.translation_mm[2] - low.translation_mm[2];
    let reach = straight.translation_mm[0];
    assert!((drop / reach - 1e-3).abs() < 1e-5, "{drop} {reach}");
}

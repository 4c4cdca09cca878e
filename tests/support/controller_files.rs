//! Readers of controller files, by the formulas of the controllers' own sources.

use etalon::base::pose::{Pose, Vector, minus, norm};
use std::collections::BTreeMap;

/// The number behind a text.
pub fn after(text: &str, key: &str) -> f64 {
    let rest = text.split_once(key).unwrap_or_else(|| panic!("{key}: {text}")).1;
    rest.split(|c: char| !"0123456789.-+e".contains(c)).find(|v| !v.is_empty()).unwrap().parse().unwrap()
}

/// Numbers of a letter of a line of G-code, between colons.
pub fn letter(text: &str, code: &str, letter: char) -> Vec<f64> {
    let line = text.lines().find(|l| l.starts_with(code)).unwrap();
    let word = line.split(' ').skip(1).find(|w| w.starts_with(letter)).unwrap();
    word[1..].split(':').map(|v| v.parse().unwrap()).collect()
}

/// The flange of six joints by a calibration of Universal Robots in the base of the robot file: the maker's chain between the base and the
/// flange that the header states.
pub fn universal_robots(yaml: &str, q: &[f64]) -> Pose {
    let stated = |name: &str| framed(yaml, name).unwrap_or(Pose::identity());
    let flange = stated("flange in the frame of wrist_3");
    stated("base of this file in the base of the robot file").then(&makers_arm(yaml, q)).then(&flange)
}

/// The frame of wrist_3 in the base of the maker (ur_description: frames of `xyz` in m and `rpy`, each joint about z).
pub fn makers_arm(yaml: &str, q: &[f64]) -> Pose {
    let numbers: Vec<f64> =
        yaml.lines().filter_map(|line| line.strip_prefix("    ")?.split_once(": ")?.1.parse().ok()).collect();
    assert_eq!((numbers.len(), q.len()), (36, 6), "{yaml}");
    let joint = |pose: Pose, (f, q): (&[f64], &f64)| {
        pose.then(&Pose::from_xyz_rpy([f[0], f[1], f[2]].map(|m| 1000.0 * m), [f[3], f[4], f[5]])).turn_z(*q)
    };
    numbers.chunks_exact(6).zip(q).fold(Pose::identity(), joint)
}

/// The pose in a comment: `# NAME: xyz ... mm, rpy ... deg`.
pub fn framed(text: &str, name: &str) -> Option<Pose> {
    let line = text.lines().find(|l| l.starts_with(&format!("# {name}: ")))?;
    let v: Vec<f64> = line.split([' ', ',']).filter_map(|v| v.parse().ok()).collect();
    Some(Pose::from_xyz_rpy([v[0], v[1], v[2]], [v[3], v[4], v[5]].map(f64::to_radians)))
}

/// The flange by genserkins: Rx(ALPHA) Tx(A) Rz(theta) Tz(D).
pub fn genserkins(hal: &str, q: &[f64]) -> Pose {
    let set = |name: &str, i: usize| after(hal, &format!("setp genserkins.{name}-{i} "));
    let theta = |i: usize| after(hal, &format!("# joint {i}: at its zero genserkins has ")).to_radians();
    let framed = |name: &str| framed(hal, name).unwrap();
    let link = |pose: Pose, i: usize| {
        pose.turn_x(set("ALPHA", i)).shift(0, set("A", i)).turn_z(theta(i) + q[i]).shift(2, set("D", i))
    };
    (0..6).fold(framed("first frame in the base"), link).then(&framed("flange in the last frame"))
}

/// Joint values by genhexkins: |t + R platform - base|, less what LinuxCNC adds to them.
pub fn genhexkins(hal: &str, pose: &Pose) -> Vec<f64> {
    let joint = |leg: usize| {
        let end = |end: &str| ["x", "y", "z"].map(|axis| after(hal, &format!("setp genhexkins.{end}.{leg}.{axis} ")));
        let strut = norm(minus(pose.apply(end("platform")), end("base")));
        strut - after(hal, &format!("# joint {leg}: its position in LinuxCNC is the joint value + "))
    };
    (0..6).map(joint).collect()
}

/// Joint values (rad) of a delta whose first arm is in direction x, by rotarydeltakins-common.h: the thigh of joint 0 swings in its YZ
/// plane towards -y, the rod of joint 1 is there when the tool is turned by 120 deg, and that of joint 2 by -120 deg.
pub fn rotarydeltakins(hal: &str, [x, y, z]: Vector) -> Vec<f64> {
    let pin = |name: &str| after(hal, &format!("setp rotarydeltakins.{name} "));
    let (hip, thigh, shin, foot) = (pin("platformradius"), pin("thighlength"), pin("shinlength"), pin("footradius"));
    assert!(hal.contains("joint 0 is in direction -y, joints 1 and 2 are 120 and 240 deg clockwise from it"), "{hal}");
    let joint = |turned: f64| {
        let (sin, cos) = turned.to_radians().sin_cos();
        // our x is -y there
        let (x, y) = (y * cos + x * sin, y * sin - x * cos);
        // the foot as seen from the hip, outwards and up; the knee is a thigh from the hip and a shin from the foot
        let (out, up) = (-y + foot - hip, z);
        let k = (x * x + out * out + up * up + thigh * thigh - shin * shin) / (2.0 * thigh);
        let across = (out * out + up * up - k * k).sqrt().atan2(k);
        -across - up.atan2(out)
    };
    // clockwise: our second arm is its joint 2
    let [first, second, third] = [joint(0.0), joint(120.0), joint(-120.0)];
    [first, third, second].map(|q| q - (q / std::f64::consts::TAU).round() * std::f64::consts::TAU).to_vec()
}

/// Joint values (mm) of a linear delta whose first tower is in direction x, by lineardeltakins-common.h: towers in directions 90, 210 and
/// 330 deg, carriages at z + √(L² − level distance²).
pub fn lineardeltakins(hal: &str, [x, y, z]: Vector) -> Vec<f64> {
    let pin = |name: &str| after(hal, &format!("setp lineardeltakins.{name} "));
    assert!(hal.contains("joint 0 is in direction y, joints 1 and 2 are 120 and 240 deg counterclockwise"), "{hal}");
    // our x is y there
    let (x, y) = (-y, x);
    let carriage = |direction: f64| {
        let (sin, cos) = direction.to_radians().sin_cos();
        let level = (pin("R") * cos - x).powi(2) + (pin("R") * sin - y).powi(2);
        z + (pin("L").powi(2) - level).sqrt()
    };
    [90.0, 210.0, 330.0].map(carriage).to_vec()
}

/// Upright towers of a firmware.
pub struct Towers {
    radius: f64,
    directions_deg: Vec<f64>,
    rods: Vec<f64>,
    heights: Vec<f64>,
    /// Frame of the firmware in the base: x, y, turned by (rad).
    frame: [f64; 3],
}

impl Towers {
    /// Klipper's `[printer]` and `[stepper_*]`.
    pub fn klipper(text: &str) -> Self {
        let sections: Vec<&str> = text.split("[stepper_").skip(1).collect();
        let all = |key: &str| sections.iter().map(|s| after(s, key)).collect();
        Self {
            radius: after(text, "delta_radius: "),
            directions_deg: all("angle: "),
            rods: all("arm_length: "),
            heights: all("position_endstop: "),
            frame: Self::frame(text),
        }
    }

    /// RepRapFirmware's `M665` and `M666`.
    pub fn reprap(text: &str) -> Self {
        let number = |code, l| letter(text, code, l)[0];
        let mean = after(text, "homed height (H): ");
        Self {
            radius: number("M665", 'R'),
            directions_deg: [(210.0, 'X'), (330.0, 'Y'), (90.0, 'Z')].map(|(d, l)| d + number("M665", l)).to_vec(),
            rods: letter(text, "M665", 'L'),
            heights: ['X', 'Y', 'Z'].map(|l| mean + number("M666", l)).to_vec(),
            frame: Self::frame(text),
        }
    }

    fn frame(text: &str) -> [f64; 3] {
        [after(text, "in the base: x "), after(text, " mm, y "), after(text, "turned by ").to_radians()]
    }

    /// Carriages above their zeros: z + √(L² − level distance²), as `delta.py` and `LinearDeltaKinematics.cpp` have them.
    pub fn joints(&self, [x, y, z]: Vector) -> Vec<f64> {
        let [x0, y0, turned] = self.frame;
        let (sin, cos) = turned.sin_cos();
        let (x, y) = (cos * (x - x0) + sin * (y - y0), cos * (y - y0) - sin * (x - x0));
        let carriage = |i: usize| {
            let (sin, cos) = self.directions_deg[i].to_radians().sin_cos();
            let level = (x - self.radius * cos).powi(2) + (y - self.radius * sin).powi(2);
            let zero = self.heights[i] + (self.rods[i].powi(2) - self.radius.powi(2)).sqrt();
            z + (self.rods[i].powi(2) - level).sqrt() - zero
        };
        (0..3).map(carriage).collect()
    }
}

/// Tool of a five-bar in the world by `M669 K9`, as `FiveBarScaraKinematics.cpp` has it; on the left of the line of the elbows for `side` = +1,
/// which is the only side that the firmware knows. The switches are at the encoders' zeros.
pub fn five_bar(text: &str, q: &[f64], side: f64) -> Vector {
    let of = |l: char| letter(text, "M669", l);
    let (x, y, p, d, home) = (of('X'), of('Y'), of('P'), of('D'), of('B'));
    let elbow = |i: usize| {
        let (sin, cos) = (q[i] + home[i].to_radians()).sin_cos();
        [x[i] + p[i] * cos, y[i] + p[i] * sin]
    };
    let (a, b) = (elbow(0), elbow(1));
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let square = dx * dx + dy * dy;
    let along = (d[0] * d[0] - d[1] * d[1] + square) / (2.0 * square);
    let across = side * (d[0] * d[0] / square - along * along).sqrt();
    let meet = [a[0] + along * dx - across * dy, a[1] + along * dy + across * dx];
    let [x, y] = [0, 1].map(|i| b[i] + (meet[i] - b[i]) * (d[1] + d[3]) / d[1]);
    [x, y, 0.0]
}

/// Numbers of a Galil controller: multiples of 1/65536, four bytes before the point; what is behind the last bit is cut or rounded.
struct Dmc<'a> {
    rest: &'a str,
    known: &'a BTreeMap<String, i128>,
    round: bool,
}

impl Dmc<'_> {
    fn held(&self, numerator: i128, denominator: i128) -> i128 {
        let half = if self.round { denominator.abs() / 2 } else { 0 };
        let value = (numerator * denominator.signum() + half).div_euclid(denominator.abs());
        assert!(value.abs() < 1 << 47, "overflow before {}", self.rest);
        value
    }

    fn operand(&mut self) -> i128 {
        if let Some(inside) = self.rest.strip_prefix("@ABS[") {
            self.rest = inside;
            let value = self.expression().abs();
            self.rest = self.rest.strip_prefix(']').unwrap();
            return value;
        }
        if let Some(inside) = self.rest.strip_prefix('(') {
            self.rest = inside;
            let value = self.expression();
            self.rest = self.rest.strip_prefix(')').unwrap();
            return value;
        }
        let end = self.rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '.')).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        let literal = || (word.parse::<f64>().unwrap() * 65_536.0).round() as i128;
        self.known.get(word).copied().unwrap_or_else(literal)
    }

    /// Strictly from left to right.
    fn expression(&mut self) -> i128 {
        let mut value = if let Some(rest) = self.rest.strip_prefix('-') {
            self.rest = rest;
            -self.operand()
        } else {
            self.operand()
        };
        while let Some(sign) = self.rest.chars().next().filter(|c| "+-*/".contains(*c)) {
            self.rest = &self.rest[1..];
            let other = self.operand();
            value = match sign {
                '+' => value + other,
                '-' => value - other,
                '*' => self.held(value * other, 65_536),
                _ => self.held(value * 65_536, other),
            };
        }
        value
    }
}

/// Joint values (mm) of a PreXYT at a pose (mm, mm, rad), by the subroutines of a Galil program; `None` where it says that there are none.
pub fn galil_prexyt(text: &str, [x, y, theta]: Vector, round: bool) -> Option<Vec<f64>> {
    let body = |label: &str| {
        let from = text.split(&format!("\n#{label}\n")).nth(1).unwrap().split("\nEN\n").next().unwrap();
        from.lines().filter(|line| !line.starts_with("REM "))
    };
    let mut known: BTreeMap<String, i128> = BTreeMap::new();
    for (name, value) in [("KWX", x * 1e3), ("KWY", y * 1e3), ("KWT", theta.to_degrees() * 1e6)] {
        known.insert(name.to_owned(), (value * 65_536.0).round() as i128);
    }
    let mut within = true;
    for line in body("PRXCON").chain(body("PREXYT")) {
        assert!(line.split('=').next().unwrap().len() <= 8 || line.starts_with("IF "), "{line}");
        let dmc = |rest| Dmc { rest, known: &known, round };
        if let Some((left, right)) = line.strip_prefix("IF (").and_then(|rest| rest.strip_suffix(')')?.split_once("<="))
        {
            within = dmc(left).expression() <= dmc(right).expression();
        } else if line == "ENDIF" {
            within = true;
        } else if within {
            let (name, expression) = line.split_once('=').unwrap();
            let value = dmc(expression).expression();
            known.insert(name.to_owned(), value);
        }
    }
    let joints = ["KWR1", "KWR2", "KWR3"].map(|name| known[name] as f64 / 65_536e3);
    (known["KWOK"] == 65_536).then(|| joints.to_vec())
}

//! What a five-bar reaches: singularities and the distance to them, joint limits, links that are in each other's way.

use super::five_bar::{FiveBar, Linkage, WORKING_MODES};
use std::f64::consts::PI;

/// Limits of a five-bar.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach {
    /// Least and greatest encoder angles.
    pub limits_rad: [[f64; 2]; 2],
    /// The centre lines of the proximal link of one arm and the distal link of the other, A1B1 and B2C or A2B2 and B1C, stay
    /// farther apart than this; 0 forbids that they cross. `None`: all links pass over each other.
    pub clearance_mm: Option<f64>,
    /// Least angle between the links of an arm when stretched or folded (type 1).
    pub type1_margin_rad: f64,
    /// Least angle between the distal links when in line (type 2).
    pub type2_margin_rad: f64,
}

impl Default for Reach {
    /// No limits but being away from singularities by more than rounding.
    fn default() -> Self {
        Self { limits_rad: [[-PI, PI]; 2], clearance_mm: None, type1_margin_rad: 1e-6, type2_margin_rad: 1e-6 }
    }
}

/// Distance to singularities as angles: how far two links are from being in line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SingularityDistance {
    /// Type 1, where an arm is stretched or folded: arm 1 (A1B1 and B1C), arm 2 (A2B2 and B2E).
    pub type1_rad: [f64; 2],
    /// Type 2, where the distal links B1C and B2C are in line: the tool moves with locked joints.
    pub type2_rad: f64,
}

/// One way to bring the tool to a position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Configuration {
    /// Working mode: the branch indices ζ1, ζ2.
    pub branches: [f64; 2],
    /// Encoder angles in (−π, π].
    pub joints_rad: [f64; 2],
    /// Assembly mode ξ that this working mode has here.
    pub assembly: f64,
}

impl FiveBar {
    /// How far from singularities a configuration is.
    pub fn singularity_distance(&self, p: &[f64], at: &Linkage) -> SingularityDistance {
        let half = 0.5 * p[4];
        let (arm1, arm2) = (from([-half, 0.0], at.b1), from([half, 0.0], at.b2));
        SingularityDistance {
            type1_rad: [from_line(arm1, from(at.b1, at.c)), from_line(arm2, from(at.b2, at.e))],
            type2_rad: from_line(from(at.b1, at.c), from(at.b2, at.c)),
        }
    }

    /// Which of reach, joint limits, margins and clearance forbids a configuration, if one does.
    pub fn forbidden(&self, p: &[f64], q: [f64; 2], at: &Linkage) -> Option<String> {
        let Reach { limits_rad, clearance_mm, type1_margin_rad, type2_margin_rad } = self.reach;
        if !at.e.iter().all(|v| v.is_finite()) {
            return Some("the arms do not meet".to_owned());
        }
        let outside = |(_, (q, [least, greatest])): &(usize, (f64, [f64; 2]))| !(*least..=*greatest).contains(q);
        if let Some((i, (q, ends))) = q.into_iter().zip(limits_rad).enumerate().find(outside) {
            let [q, least, greatest] = [q, ends[0], ends[1]].map(f64::to_degrees);
            return Some(format!("theta{} = {q:.3} deg, its limits are {least} to {greatest} deg", i + 1));
        }
        let far = self.singularity_distance(p, at);
        let type1_rad = far.type1_rad[0].min(far.type1_rad[1]);
        for (name, found, margin) in [
            ("type 1 (an arm stretched or folded)", type1_rad, type1_margin_rad),
            ("type 2 (the distal links in line)", far.type2_rad, type2_margin_rad),
        ] {
            if found.is_nan() || found < margin {
                let [found, margin] = [found, margin].map(f64::to_degrees);
                return Some(format!(
                    "{found:.3} deg from the singularity of {name}, at least {margin} deg are asked for"
                ));
            }
        }
        let least = clearance_mm?;
        let found = self.clearance_mm(p, at);
        (found.is_nan() || found <= least)
            .then(|| format!("links {found:.3} mm apart, more than {least} mm are asked for"))
    }

    /// Least distance between the proximal link of one arm and the distal link of the other.
    pub fn clearance_mm(&self, p: &[f64], at: &Linkage) -> f64 {
        let half = 0.5 * p[4];
        let (a1, a2) = ([-half, 0.0], [half, 0.0]);
        let pairs = [[a1, at.b1, at.b2, at.c], [a2, at.b2, at.b1, at.c]];
        pairs.into_iter().map(|[a, b, c, d]| segment_distance(a, b, c, d)).fold(f64::INFINITY, f64::min)
    }

    /// The working modes that reach `e` (base frame, mm).
    pub fn reached(&self, p: &[f64], e: [f64; 2]) -> Vec<Configuration> {
        let configuration = |branches: [f64; 2]| {
            let joints_rad = self.inverse(p, e, branches);
            let assembly = self.assembly_at(p, joints_rad, e);
            let at = self.direct(p, joints_rad, assembly);
            self.forbidden(p, joints_rad, &at).is_none().then_some(Configuration { branches, joints_rad, assembly })
        };
        WORKING_MODES.into_iter().filter_map(configuration).collect()
    }
}

fn from(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [b[0] - a[0], b[1] - a[1]]
}

/// Angle by which two directions miss being in line.
fn from_line(a: [f64; 2], b: [f64; 2]) -> f64 {
    let cross = a[0] * b[1] - a[1] * b[0];
    let along = a[0] * b[0] + a[1] * b[1];
    cross.abs().atan2(along.abs())
}

/// Least distance between two segments; zero where they cross.
fn segment_distance(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> f64 {
    let side = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
        let (u, v) = (from(p, q), from(p, r));
        u[0] * v[1] - u[1] * v[0]
    };
    if side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0 {
        return 0.0;
    }
    let to = |p: [f64; 2], a: [f64; 2], b: [f64; 2]| {
        let (u, v) = (from(a, b), from(a, p));
        let t = ((u[0] * v[0] + u[1] * v[1]) / (u[0] * u[0] + u[1] * u[1])).clamp(0.0, 1.0);
        (v[0] - t * u[0]).hypot(v[1] - t * u[1])
    };
    to(c, a, b).min(to(d, a, b)).min(to(a, c, d)).min(to(b, c, d))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_of_segments() {
        let far = segment_distance([0.0, 0.0], [10.0, 0.0], [3.0, 4.0], [3.0, 9.0]);
        assert_eq!(far, 4.0);
        assert_eq!(segment_distance([0.0, 0.0], [10.0, 0.0], [3.0, -4.0], [3.0, 9.0]), 0.0);
        assert_eq!(segment_distance([0.0, 0.0], [10.0, 0.0], [13.0, 4.0], [20.0, 9.0]), 5.0);
    }

    #[test]
    fn stretched_and_in_line_is_singular() {
        let robot = FiveBar::default();
        let p = crate::math::robots::Robot::nominal(&robot);
        // elbows 460 mm apart: the distal links are one line (type 2); 1e-4 rad inside they nearly are
        let q = (92.5f64 / 230.0).acos();
        let at = robot.direct(&p, [PI - q - 1e-4, q + 1e-4], 1.0);
        assert!(robot.singularity_distance(&p, &at).type2_rad < 0.03);
        // arm 2 along the line to the tool (type 1)
        let at = Linkage { e: [137.5 + 2.0 * (at.b2[0] - 137.5), 2.0 * at.b2[1]], ..at };
        assert!(robot.singularity_distance(&p, &at).type1_rad[1] < 1e-12);
    }
}

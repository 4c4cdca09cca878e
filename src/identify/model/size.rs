//! Size of a robot whose observations contain no length.
//!
//! Where targets touch, or hold bars of unknown lengths, a robot of twice the size closes as well,
//! and its gaps are twice as long. Least squares of the gaps prefer smaller robots. The joint
//! values are observed, not the gaps: the density of the joint values is the density of the gaps
//! times the determinant of the derivatives of the gaps, which grows with the size as the gaps do
//! (change of variables). Gaps relative to the size are independent of the size, and nominal
//! lengths determine it.

use crate::model::kinds::Condition;
use etalon_base::pose::{Vector, centroid, minus};
use etalon_robots::Robot;
use std::collections::BTreeSet;

/// Number of conditions that is sufficient for a size.
const CONDITIONS: usize = 24;
/// Minimum size (mm): targets that only touch each other have none.
const LEAST_MM: f64 = 1.0;

/// Size of a robot at its conditions, with its derivatives.
pub(crate) struct Size {
    /// Root mean square distance (mm).
    pub mm: f64,
    /// Derivatives of its logarithm with respect to all parameters.
    pub relative: Vec<f64>,
}

impl Size {
    /// Root mean square distance between targets of both branches of each condition or, without
    /// branches, of the targets from their mean. Both are independent of the frame in which the
    /// robot stands. `None` if there are no such distances.
    pub fn new(robot: &dyn Robot, conditions: &[Condition], values: &[f64]) -> Option<Self> {
        robot.free_base()?;
        let between = conditions.iter().any(|c| c.kind.other_target().is_some());
        let fits = |c: &&Condition| match between {
            true => c.kind.other_target().is_some(),
            false => c.kind.equation().depends_on_target(),
        };
        let fitting: Vec<&Condition> = conditions.iter().filter(fits).collect();
        let targets = fitting.iter().flat_map(|c| [Some(c.target), c.kind.other_target()]).flatten();
        let seen: BTreeSet<usize> = targets.collect();
        let on = |branch: usize| seen.iter().copied().filter(move |&k| robot.target_branch(k) == branch);
        let mut places: Vec<Moved> = Vec::new();
        for c in fitting.iter().step_by(fitting.len().div_ceil(CONDITIONS).max(1)) {
            let at = Moved::all(robot, values, &c.joints);
            match c.kind.other_target() {
                Some(other) => places.extend(
                    on(robot.target_branch(other))
                        .flat_map(|from| on(robot.target_branch(c.target)).map(move |to| (from, to)))
                        .map(|(from, to)| at[to].less(&at[from])),
                ),
                None => places.push(at[c.target].clone()),
            }
        }
        let mean = centroid(&places.iter().map(|p| p.at).collect::<Vec<_>>()).filter(|_| !between).unwrap_or_default();
        let (mut sum, mut relative) = (0.0, vec![0.0; values.len()]);
        for place in &places {
            let apart = minus(place.at, mean);
            sum += apart.iter().map(|v| v * v).sum::<f64>();
            for (i, row) in place.by.chunks_exact(values.len()).enumerate() {
                relative.iter_mut().zip(row).for_each(|(sum, by)| *sum += apart[i] * by);
            }
        }
        relative.iter_mut().for_each(|derivative| *derivative /= sum);
        let mm = (sum / places.len() as f64).sqrt();
        (mm > LEAST_MM).then_some(Self { mm, relative })
    }
}

/// A position with its derivatives with respect to all parameters, three rows.
#[derive(Clone)]
struct Moved {
    at: Vector,
    by: Vec<f64>,
}

impl Moved {
    /// All targets at joint values.
    fn all(robot: &dyn Robot, values: &[f64], joints: &[f64]) -> Vec<Self> {
        let mut positions = vec![0.0; 3 * robot.targets().len()];
        let mut jacobian = vec![0.0; positions.len() * values.len()];
        robot.positions(values, joints, &mut positions);
        robot.jacobian(values, joints, &mut jacobian);
        let rows = jacobian.chunks_exact(3 * values.len());
        positions
            .chunks_exact(3)
            .zip(rows)
            .map(|(at, by)| Self { at: [at[0], at[1], at[2]], by: by.to_vec() })
            .collect()
    }

    fn less(&self, other: &Self) -> Self {
        let by = self.by.iter().zip(&other.by).map(|(a, b)| a - b).collect();
        Self { at: minus(self.at, other.at), by }
    }
}

#[cfg(test)]
mod tests {
    use crate::model::kinds::{Between, Condition, Contact, Kind, Separation};
    use crate::model::residuals::Residuals;
    use crate::{Fixture, Settings};
    use etalon_base::noise::Noise;
    use etalon_math::Problem;
    use etalon_robots::{Parameter, Quantity, Robot, Serial, SerialJoint};

    /// Contacts of a target with a socket, and of both targets of an arm with each other, at drawn
    /// joints.
    fn campaign(noise: &mut Noise, between: bool) -> (Serial, Settings, Vec<f64>) {
        let joint = |&[alpha_rad, a_mm, theta_rad, d_mm]: &[f64; 4]| SerialJoint {
            alpha_rad,
            a_mm,
            theta_rad,
            d_mm,
            prismatic: false,
            parallel: false,
        };
        let table = [[0.0, 0.0, 0.0, 290.0], [-1.5, 0.0, -1.5, 0.0], [0.4, 270.0, 0.0, 0.0], [-1.5, 70.0, 0.0, 302.0]];
        let joints: Vec<SerialJoint> = table.iter().map(joint).collect();
        let mut robot = Serial::new(&joints, &["ball", "end"].map(str::to_owned), [0.0, 0.0, -1.0], &[], &[]);
        let socket = Fixture::Point("s").add_to(&mut robot);
        let random =
            |p: &Parameter| p.nominal + if p.quantity == Quantity::Length { 40.0 } else { 0.2 } * noise.uniform(1.0);
        let mut values: Vec<f64> = robot.parameters().iter().map(random).collect();
        // the robot stands in its own world
        values[..6].fill(0.0);
        let kind = match between {
            true => Kind::Between(Between { other: 1, apart: Separation::Touching }),
            false => Kind::Contact(Contact { socket }),
        };
        let condition = |k: i64| {
            let joints = (0..4).map(|_| noise.uniform(1.5)).collect();
            Condition { pose: k.into(), cycle: 1, joints, target: 0, kind, standard_uncertainty: 0.5 }
        };
        let conditions = (1..9).map(condition).collect();
        (robot, Settings { standard_uncertainty_mm: Some(0.5), conditions, ..Settings::default() }, values)
    }

    #[test]
    fn gaps_relative_to_the_size_have_exact_derivatives_and_no_scale() {
        for between in [false, true] {
            let (robot, settings, values) = campaign(&mut Noise::new(45, 30), between);
            let free: Vec<usize> = (6..values.len()).collect();
            let problem = Residuals::new(&robot, &[], &settings, &free, &values).unwrap();
            let (x, rows) = (values[6..].to_vec(), problem.residual_count());
            let left = |x: &[f64]| {
                let mut left = vec![0.0; rows];
                problem.residuals(x, &mut left);
                left
            };
            let mut exact = vec![0.0; rows * free.len()];
            problem.jacobian(&x, &mut exact);
            for (j, &i) in free.iter().enumerate() {
                let h = if robot.parameters()[i].quantity == Quantity::Length { 1e-3 } else { 1e-6 };
                let moved = |by: f64| {
                    let mut x = x.clone();
                    x[j] += by;
                    left(&x)
                };
                for (k, (plus, minus)) in moved(h).into_iter().zip(moved(-h)).enumerate() {
                    let numeric = (plus - minus) / (2.0 * h);
                    let off = (exact[k * free.len() + j] - numeric).abs();
                    assert!(off < 1e-5 * (1.0 + numeric.abs()), "{} {numeric}", robot.parameters()[i].name);
                }
            }
            // all lengths three times as long
            let is_length = |i: &usize| robot.parameters()[*i].quantity == Quantity::Length;
            let long: Vec<f64> =
                free.iter().map(|i| if is_length(i) { 3.0 * values[*i] } else { values[*i] }).collect();
            for (a, b) in left(&x).into_iter().zip(left(&long)) {
                assert!((a - b).abs() < 1e-9 * (1.0 + a.abs()), "{a} {b}");
            }
        }
    }
}

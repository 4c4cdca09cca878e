//! Test of a proposal against the nominal robot: order, unit and sign of the joints, unit of the
//! coordinates, and the column of targets with which its kinematics reproduce the coordinates.

use etalon_base::pose::{Pose, cross, dot, norm};
use etalon_math::Factor;
use etalon_robots::{Quantity, Robot};
use std::collections::BTreeMap;

/// Minimum number of rows: base and target are 15 unknowns.
pub(crate) const FEWEST: usize = 15;
/// Minimum number of joints that move: the motion of two joints fits many orders and targets.
const FEWEST_MOVING: usize = 3;
/// Smallest range of a moving joint, in units of the file; a recording at rest has less.
const MOVES: f64 = 5e-3;
/// Residual (mm) of a nominal robot up to which a measurement is implausible.
const NO_MEASUREMENT_MM: f64 = 0.005;
/// Number of rows with which orders and signs are ranked.
const RANKED: usize = 24;
/// Maximum number of rows of the final residual.
const MOST: usize = 2000;
/// Maximum number of targets, those with the most rows: few show where the base is.
const MOST_TARGETS: usize = 12;
/// Upper limit for the residual of an accepted interpretation, relative to the spread of the
/// coordinates.
const ACCEPTED: f64 = 0.03;
/// Factor by which the residual of the next interpretation must be larger.
const DISTINCT: f64 = 3.0;
/// Residuals (mm) that count as equal.
const SAME_MM: f64 = 1e-3;
/// Maximum number of interpretations that are compared with all rows.
const NEAR: usize = 64;
/// Maximum step (mm) of rounded coordinates that tells computed from measured ones.
const FINE_MM: f64 = 0.1;
/// Allowance for base and target, which are fitted to rounded coordinates.
const ALLOWANCE: f64 = 1.2;
/// Root mean square residual of rounded coordinates, relative to half a step (its expectation), up
/// to which nothing but rounding is in the residuals.
const EXCESS: f64 = 1.15;
/// Difference (mm) of computed coordinates that are not rounded.
const COMPUTED_MM: f64 = 1e-6;
/// Weight per row of the shortest solution, where base and target are not separable.
const RIDGE: f64 = 1e-11;
/// Units of lengths, and their sizes in mm.
const LENGTHS: [(&str, f64); 5] = [("mm", 1.0), ("m", 1000.0), ("cm", 10.0), ("inch", 25.4), ("um", 0.001)];

/// Rows of joint values and points, column by column.
pub(crate) struct Sample {
    /// Columns of joint values in the unit of the file; at least as many as the robot has joints.
    pub joints: Vec<Vec<f64>>,
    /// Units that the headings of these columns give.
    pub stated: Vec<Option<&'static str>>,
    /// Columns x, y, z in the unit of the file.
    pub points: [Vec<f64>; 3],
    /// Number of the target of each row.
    pub targets: Vec<usize>,
}

/// Interpretation of the joint columns, with its residual.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Reading {
    /// For each joint of the robot the index of its column.
    pub order: Vec<usize>,
    /// For each joint `true` if the column counts in the opposite direction.
    pub reversed: Vec<bool>,
    /// For each joint the unit of its column.
    pub units: Vec<&'static str>,
    /// Unit of the coordinates.
    pub unit: &'static str,
    /// Root mean square of the residual distances (mm).
    pub rms_mm: f64,
    /// Number of rows.
    pub rows: usize,
    /// Origin of the coordinates.
    pub origin: Origin,
    /// Rotation from the frame of the coordinates to the base.
    pub base_R_world: [[f64; 3]; 3],
}

/// Origin of coordinates, by their residuals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Origin {
    Measured,
    /// The nominal robot computes them to their rounding.
    Commanded,
    /// Coarse rounding leaves both possible.
    Undecided,
}

/// Result of the test.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Outcome {
    /// One interpretation reproduces the coordinates.
    Reproduced(Reading),
    /// Several interpretations reproduce the coordinates about equally well.
    Ambiguous(Reading, Reading),
    /// No interpretation reproduces the coordinates; contains the residual (mm) of the best one, if
    /// there is one.
    Contradicted(Option<f64>),
    /// Too few rows, or points in one plane.
    Untested,
}

impl Sample {
    fn rows(&self) -> usize {
        self.targets.len()
    }

    /// Returns the sample of about `count` rows, evenly spread.
    fn thinned(&self, count: usize) -> Self {
        let rows = self.rows();
        let count = count.min(rows);
        let at: Vec<usize> = (0..count).map(|i| i * rows / count.max(1)).collect();
        self.rows_at(&at)
    }

    /// Returns the sample of these rows.
    fn rows_at(&self, at: &[usize]) -> Self {
        let pick = |column: &Vec<f64>| at.iter().map(|i| column[*i]).collect::<Vec<f64>>();
        Self {
            joints: self.joints.iter().map(pick).collect(),
            stated: self.stated.clone(),
            points: self.points.each_ref().map(pick),
            targets: at.iter().map(|i| self.targets[*i]).collect(),
        }
    }

    /// Returns the rows of the [`MOST_TARGETS`] targets with the most rows.
    fn with_few_targets(&self) -> Self {
        let mut rows: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        self.targets.iter().enumerate().for_each(|(i, target)| rows.entry(*target).or_default().push(i));
        let mut rows: Vec<Vec<usize>> = rows.into_values().collect();
        rows.sort_by_key(|rows| std::cmp::Reverse(rows.len()));
        rows.truncate(MOST_TARGETS);
        let mut at: Vec<(usize, usize)> =
            rows.iter().enumerate().flat_map(|(target, rows)| rows.iter().map(move |i| (*i, target))).collect();
        at.sort_unstable();
        let kept: Vec<usize> = at.iter().map(|(i, _)| *i).collect();
        Self { targets: at.into_iter().map(|(_, target)| target).collect(), ..self.rows_at(&kept) }
    }

    /// Returns the rows in which every value is finite.
    pub fn finite(self) -> Self {
        let keep: Vec<usize> = (0..self.rows())
            .filter(|i| self.joints.iter().chain(&self.points).all(|c| c.get(*i).is_some_and(|v| v.is_finite())))
            .collect();
        self.rows_at(&keep)
    }

    /// Number of columns of joints that move.
    fn moving_joints(&self) -> usize {
        let range = |column: &&Vec<f64>| {
            let (low, high) =
                column.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(*v), h.max(*v)));
            high - low > MOVES
        };
        self.joints.iter().filter(range).count()
    }

    /// Mean and spread (root mean square distance from the mean) of the points.
    fn spread(&self) -> ([f64; 3], f64) {
        let n = self.rows().max(1) as f64;
        let mean = self.points.each_ref().map(|c| c.iter().sum::<f64>() / n);
        let square = (0..3).map(|a| self.points[a].iter().map(|v| (v - mean[a]).powi(2)).sum::<f64>()).sum::<f64>();
        (mean, (square / n).sqrt())
    }

    /// `true` if the points span space, not a plane or a line.
    fn spans_space(&self) -> bool {
        let (mean, spread) = self.spread();
        let n = self.rows().max(1) as f64;
        let c = |a: usize, b: usize| {
            let of = |i: usize| (self.points[a][i] - mean[a]) * (self.points[b][i] - mean[b]);
            (0..self.rows()).map(of).sum::<f64>() / n / spread.powi(2)
        };
        let determinant = c(0, 0) * (c(1, 1) * c(2, 2) - c(1, 2).powi(2))
            - c(0, 1) * (c(0, 1) * c(2, 2) - c(1, 2) * c(0, 2))
            + c(0, 2) * (c(0, 1) * c(1, 2) - c(1, 1) * c(0, 2));
        spread > 0.0 && determinant > 1e-6
    }
}

/// Hypothesis: the column, direction and unit of each joint.
#[derive(Clone, Debug)]
struct Hypothesis {
    order: Vec<usize>,
    reversed: Vec<bool>,
    units: Vec<&'static str>,
}

/// Residual of a hypothesis.
struct Residual {
    /// Root mean square of the residual distances (mm), with base and targets fitted.
    rms_mm: f64,
    largest_mm: f64,
    unit: &'static str,
    unit_mm: f64,
    base_R_world: [[f64; 3]; 3],
}

/// Tests the columns of joints against the coordinates. A thorough test also tries orders and
/// directions other than the directions of the file.
pub(crate) fn test(robot: &dyn Robot, sample: &Sample, thorough: bool) -> Outcome {
    let count = robot.joints().len();
    // points of several branches do not belong to one chain
    let is_chain = robot.free_base().is_some() && robot.branches().is_empty();
    if !is_chain || sample.joints.len() < count || count < 2 || !sample.spans_space() {
        return Outcome::Untested;
    }
    if sample.moving_joints() < FEWEST_MOVING {
        return Outcome::Untested;
    }
    let sample = &sample.with_few_targets();
    let targets = sample.targets.iter().max().map_or(1, |most| most + 1);
    if sample.rows() < FEWEST + 3 * (targets - 1) {
        return Outcome::Untested;
    }
    let few = sample.thinned(RANKED + 6 * (targets - 1));
    let all = if thorough { hypotheses(robot, sample) } else { as_they_are(robot, sample) };
    let rank = |h: &Hypothesis| affine(robot, &few, h).map_or(f64::INFINITY, |found| found.rms_mm);
    let mut ranked: Vec<(f64, usize)> = all.iter().enumerate().map(|(i, h)| (rank(h), i)).collect();
    ranked.sort_by(|a, b| a.0.total_cmp(&b.0));
    let near = ranked.first().map_or(0.0, |(best, _)| (DISTINCT * best).max(SAME_MM));
    let many = sample.thinned(MOST);
    // where the best is far off, the others are as well
    let spread_mm = |h: &Hypothesis| affine(robot, &few, h).map_or(0.0, |found| few.spread().1 * found.unit_mm);
    let is_open = ranked.first().is_some_and(|(best, i)| *best <= 2.0 * ACCEPTED * spread_mm(&all[*i]));
    let mut found: Vec<(Residual, usize)> = ranked
        .iter()
        .take_while(|(rms, _)| *rms <= near && rms.is_finite())
        .take(if is_open { NEAR } else { 1 })
        .filter_map(|(_, i)| Some((residual(robot, &many, &all[*i])?, *i)))
        .collect();
    found.sort_by(|a, b| a.0.rms_mm.total_cmp(&b.0.rms_mm));
    let Some((best, _)) = found.first() else { return Outcome::Contradicted(None) };
    if best.rms_mm > ACCEPTED * many.spread().1 * best.unit_mm {
        return Outcome::Contradicted(Some(best.rms_mm));
    }
    let near = (DISTINCT * best.rms_mm).max(SAME_MM);
    found.retain(|(residual, _)| residual.rms_mm <= near);
    // of equally good interpretations, the first changes least
    found.sort_by_key(|(_, i)| *i);
    let mut readings = found.into_iter().map(|(residual, i)| Reading {
        origin: origin(robot, &many, &residual),
        order: all[i].order.clone(),
        reversed: all[i].reversed.clone(),
        units: all[i].units.clone(),
        unit: residual.unit,
        rms_mm: residual.rms_mm,
        rows: many.rows(),
        base_R_world: residual.base_R_world,
    });
    match (readings.next(), readings.next()) {
        (Some(first), Some(second)) => Outcome::Ambiguous(first, second),
        (Some(first), None) => Outcome::Reproduced(first),
        (None, _) => Outcome::Contradicted(None),
    }
}

/// Returns an interpretation with its residual at other points, if it reproduces these too.
pub(crate) fn confirmed(robot: &dyn Robot, sample: &Sample, reading: &Reading) -> Option<Reading> {
    if sample.rows() < FEWEST || !sample.spans_space() {
        return None;
    }
    let Reading { order, reversed, units, .. } = reading.clone();
    let many = sample.with_few_targets().thinned(MOST);
    let residual = residual(robot, &many, &Hypothesis { order, reversed, units })?;
    (residual.rms_mm <= ACCEPTED * many.spread().1 * residual.unit_mm).then(|| Reading {
        origin: origin(robot, &many, &residual),
        unit: residual.unit,
        rms_mm: residual.rms_mm,
        rows: many.rows(),
        base_R_world: residual.base_R_world,
        ..reading.clone()
    })
}

/// Returns the hypotheses without exchange and reversal.
fn as_they_are(robot: &dyn Robot, sample: &Sample) -> Vec<Hypothesis> {
    let count = robot.joints().len();
    let windows = 0..=sample.joints.len() - count;
    let tried: Vec<Tried> = windows.map(|from| ((from..from + count).collect(), vec![false; count])).collect();
    in_units(robot, sample, &tried)
}

/// Returns the hypotheses that are tried: the order of the columns with all directions, every pair
/// swapped with all directions, and every order with the directions of the columns.
fn hypotheses(robot: &dyn Robot, sample: &Sample) -> Vec<Hypothesis> {
    let count = robot.joints().len();
    let plain: Vec<usize> = (0..count).collect();
    let signs = |order: &Vec<usize>| {
        let all = 0..1usize << count.min(8);
        all.map(|bits| (order.clone(), (0..count).map(|k| bits >> k & 1 == 1).collect())).collect::<Vec<_>>()
    };
    let mut tried: Vec<Tried> = Vec::new();
    for from in 0..=sample.joints.len() - count {
        let window: Vec<usize> = plain.iter().map(|k| k + from).collect();
        tried.extend(signs(&window));
        for a in 0..count {
            for b in a + 1..count {
                let mut order = window.clone();
                order.swap(a, b);
                tried.extend(signs(&order));
            }
        }
        if count <= 6 {
            let mut all = Vec::new();
            permutations(&mut window.clone(), 0, &mut all);
            // the window and its swapped pairs are among the others
            let moved = |order: &Vec<usize>| order.iter().zip(&window).filter(|(a, b)| a != b).count() > 2;
            tried.extend(all.into_iter().filter(moved).map(|order| (order, vec![false; count])));
        }
    }
    in_units(robot, sample, &tried)
}

/// Order and directions of the columns.
type Tried = (Vec<usize>, Vec<bool>);

/// Returns the hypotheses with each pair of units that the headings allow.
fn in_units(robot: &dyn Robot, sample: &Sample, tried: &[Tried]) -> Vec<Hypothesis> {
    let count = robot.joints().len();
    let mut found: Vec<Hypothesis> = Vec::new();
    for (angle, length) in [("deg", "mm"), ("rad", "mm"), ("deg", "m"), ("rad", "m")] {
        let unit = |k: usize| if robot.joints()[k].quantity == Quantity::Angle { angle } else { length };
        let units: Vec<&'static str> = (0..count).map(unit).collect();
        let same = |h: &Hypothesis| h.units == units;
        if found.iter().any(same) {
            continue;
        }
        let fits = |order: &[usize]| {
            order.iter().zip(&units).all(|(column, unit)| sample.stated[*column].is_none_or(|stated| stated == *unit))
        };
        let of = tried.iter().filter(|(order, _)| fits(order));
        found.extend(of.map(|(order, reversed)| Hypothesis {
            order: order.clone(),
            reversed: reversed.clone(),
            units: units.clone(),
        }));
    }
    found
}

fn permutations(order: &mut Vec<usize>, from: usize, all: &mut Vec<Vec<usize>>) {
    if from == order.len() {
        return all.push(order.clone());
    }
    for i in from..order.len() {
        order.swap(from, i);
        permutations(order, from + 1, all);
        order.swap(from, i);
    }
}

/// Returns the factor from a unit of joints to mm or rad.
pub(crate) fn factor(unit: &str) -> f64 {
    match unit {
        "deg" => 1f64.to_radians(),
        "m" => 1000.0,
        _ => 1.0,
    }
}

/// Rows of a hypothesis: the flange at each row of the sample.
struct Flanges {
    poses: Vec<Pose>,
    targets: usize,
}

impl Flanges {
    fn new(robot: &dyn Robot, sample: &Sample, of: &Hypothesis) -> Option<Self> {
        let (arm, nominal) = (robot.free_base()?, robot.nominal());
        let flange = |i: usize| -> Pose {
            let joint = |k: usize| {
                let value = sample.joints[of.order[k]][i] * factor(of.units[k]);
                if of.reversed[k] { -value } else { value }
            };
            arm.flange(&nominal, &(0..of.order.len()).map(joint).collect::<Vec<f64>>(), 0)
        };
        let targets = sample.targets.iter().max().map_or(1, |most| most + 1);
        Some(Self { poses: (0..sample.rows()).map(flange).collect(), targets })
    }

    /// Least-squares solution of rows of coefficients and right sides, three to a row of the
    /// sample. A small ridge makes the solution unique where base and target are not separable.
    fn solve(&self, unknowns: usize, equation: impl Fn(usize, usize) -> (Vec<f64>, f64)) -> Option<Vec<f64>> {
        let mut normal = vec![0.0; unknowns * unknowns];
        let mut right = vec![0.0; unknowns];
        for (i, axis) in (0..self.poses.len()).flat_map(|i| (0..3).map(move |axis| (i, axis))) {
            let (row, value) = equation(i, axis);
            let used: Vec<usize> = (0..unknowns).filter(|j| row[*j] != 0.0).collect();
            for &j in &used {
                right[j] += row[j] * value;
                used.iter().for_each(|&k| normal[j * unknowns + k] += row[j] * row[k]);
            }
        }
        (0..unknowns).for_each(|j| normal[j * unknowns + j] += RIDGE * self.poses.len() as f64);
        // sums of squares are computed row by row
        Factor::from_normal(&normal, &right, 0.0, &vec![1.0; unknowns], f64::MIN_POSITIVE)?.solve()
    }

    /// Root mean square and largest of the lengths of residual vectors.
    fn size(&self, residual: impl Fn(usize, usize) -> f64) -> (f64, f64) {
        let square = |i: usize| (0..3).map(|axis| residual(i, axis).powi(2)).sum::<f64>();
        let squares: Vec<f64> = (0..self.poses.len()).map(square).collect();
        let rms = (squares.iter().sum::<f64>() / squares.len().max(1) as f64).sqrt();
        (rms, squares.iter().copied().fold(0.0, f64::max).sqrt())
    }
}

/// Returns the residual of a hypothesis with an affine world, or `None` if the world is then
/// mirrored, distorted, or of a scale that is no unit of length.
///
/// The flange f(q) with rotation R(q) carries the target at c; the world has a position t and the
/// matrix M of a rotation times the unit: M·p = f + R·c + t is linear in M, c and t. Six more
/// unknowns than base and targets have make the residual smaller: it ranks hypotheses, and starts
/// [`residual`].
fn affine(robot: &dyn Robot, sample: &Sample, of: &Hypothesis) -> Option<Residual> {
    let flanges = Flanges::new(robot, sample, of)?;
    let (mean, spread) = sample.spread();
    let unknowns = 12 + 3 * flanges.targets;
    let equation = |i: usize, axis: usize| {
        let pose = &flanges.poses[i];
        let mut row = vec![0.0; unknowns];
        for b in 0..3 {
            row[3 * axis + b] = (sample.points[b][i] - mean[b]) / spread;
            row[12 + 3 * sample.targets[i] + b] = -pose.rotation[axis][b];
        }
        row[9 + axis] = -1.0;
        (row, pose.translation_mm[axis])
    };
    let x = flanges.solve(unknowns, equation)?;
    let m: [[f64; 3]; 3] = std::array::from_fn(|a| std::array::from_fn(|b| x[3 * a + b] / spread));
    let (unit, unit_mm) = length_unit(&m)?;
    let (rms_mm, largest_mm) = flanges.size(|i, axis| {
        let (row, value) = equation(i, axis);
        row.iter().zip(&x).map(|(a, x)| a * x).sum::<f64>() - value
    });
    Some(Residual { rms_mm, largest_mm, unit, unit_mm, base_R_world: m.map(|row| row.map(|v| v / unit_mm)) })
}

/// Maximum number of Gauss-Newton steps of base and targets.
const STEPS: usize = 20;
/// Length of a step of the rotation (rad) that ends the iteration.
const SETTLED_RAD: f64 = 1e-10;

/// Returns the residual of a hypothesis with base and targets fitted, and nothing else: the world
/// is rotated and shifted, and its scale follows from the unit. `None` as for [`affine`].
///
/// Gauss-Newton steps from the affine world: R·p = f + R(q)·c + t, with a small rotation of R about
/// the axes of the base.
fn residual(robot: &dyn Robot, sample: &Sample, of: &Hypothesis) -> Option<Residual> {
    let found = affine(robot, sample, of)?;
    let flanges = Flanges::new(robot, sample, of)?;
    let (mean, spread) = sample.spread();
    let unknowns = 6 + 3 * flanges.targets;
    let lever_mm = spread * found.unit_mm;
    let mut world = nearest_rotation(&found.base_R_world)?;
    let seen = |world: &Pose, i: usize| -> [f64; 3] {
        world.rotate([0, 1, 2].map(|b| (sample.points[b][i] - mean[b]) * found.unit_mm))
    };
    let equation = |world: &Pose, i: usize, axis: usize| {
        let (pose, p) = (&flanges.poses[i], seen(world, i));
        let mut row = vec![0.0; unknowns];
        for k in 0..3 {
            // the small rotation, times the lever so that all unknowns are lengths
            let mut about = [0.0; 3];
            about[k] = 1.0;
            row[k] = cross(about, p)[axis] / lever_mm;
            row[6 + 3 * sample.targets[i] + k] = -pose.rotation[axis][k];
        }
        row[3 + axis] = -1.0;
        (row, pose.translation_mm[axis] - p[axis])
    };
    for _ in 0..STEPS {
        let x = flanges.solve(unknowns, |i, axis| equation(&world, i, axis))?;
        let turn = [0, 1, 2].map(|k| x[k] / lever_mm);
        world = Pose::from_rotation_vector(turn).then(&world);
        if norm(turn) < SETTLED_RAD {
            break;
        }
    }
    let x = flanges.solve(unknowns, |i, axis| equation(&world, i, axis))?;
    let (rms_mm, largest_mm) = flanges.size(|i, axis| {
        let (row, value) = equation(&world, i, axis);
        row.iter().zip(&x).map(|(a, x)| a * x).sum::<f64>() - value
    });
    Some(Residual { rms_mm, largest_mm, base_R_world: world.rotation, ..found })
}

/// Rotation nearest to a matrix (Newton's iteration of the polar decomposition: Higham 1986).
fn nearest_rotation(matrix: &[[f64; 3]; 3]) -> Option<Pose> {
    let mut m = *matrix;
    for _ in 0..STEPS {
        let cofactors = [cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])];
        let determinant = dot(m[0], cofactors[0]);
        if !(determinant.abs() > 1e-9 && determinant.is_finite()) {
            return None;
        }
        m = std::array::from_fn(|a| std::array::from_fn(|b| 0.5 * (m[a][b] + cofactors[a][b] / determinant)));
    }
    Some(Pose { rotation: m, translation_mm: [0.0; 3] })
}

/// Returns the unit of lengths whose size (mm) is the scale of a rotation matrix.
fn length_unit(m: &[[f64; 3]; 3]) -> Option<(&'static str, f64)> {
    let determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
        - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
        + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    let scale = determinant.cbrt();
    let (unit, size) = LENGTHS.into_iter().find(|(_, size)| (scale / size - 1.0).abs() < 0.05)?;
    let product = |a: usize, b: usize| (0..3).map(|k| m[a][k] * m[b][k]).sum::<f64>() / (size * size);
    let orthogonal = |a: usize, b: usize| (product(a, b) - f64::from(u8::from(a == b))).abs() < 0.15;
    (0..3).all(|a| (a..3).all(|b| orthogonal(a, b))).then_some((unit, size))
}

/// Returns half a unit of the last digit of values.
fn half_step(values: &[f64]) -> f64 {
    let rounded = |digits: &i32| {
        let step = 10f64.powi(-digits);
        values.iter().all(|v| (v / step - (v / step).round()).abs() < 1e-4)
    };
    (0..=9).find(rounded).map_or(0.0, |digits| 0.5 * 10f64.powi(-digits))
}

/// Returns the origin of coordinates with this residual.
fn origin(robot: &dyn Robot, sample: &Sample, residual: &Residual) -> Origin {
    let half = sample.points.iter().map(|column| half_step(column)).fold(0.0, f64::max) * residual.unit_mm;
    let rounding_mm = ALLOWANCE * (3f64.sqrt() * half).max(COMPUTED_MM);
    // joints that are rounded move the computed point, at most by the spread times the angle
    let reach_mm = 2.0 * sample.spread().1 * residual.unit_mm;
    let joints: f64 = sample.joints.iter().map(|column| half_step(column)).fold(0.0, f64::max);
    let angular = robot.joints().iter().any(|joint| joint.quantity == Quantity::Angle);
    let in_rad =
        joints.min(1.0) * if sample.joints.iter().flatten().any(|v| v.abs() > 7.0) { factor("deg") } else { 1.0 };
    let of_joints_mm = if angular { in_rad * reach_mm } else { joints };
    // rounding to a step leaves step/√12 in each coordinate
    let by_rounding_mm = EXCESS * half.max(COMPUTED_MM) + COMPUTED_MM;
    match residual.largest_mm {
        largest if largest <= rounding_mm && residual.rms_mm <= by_rounding_mm && 2.0 * half <= FINE_MM => {
            Origin::Commanded
        }
        largest if largest <= rounding_mm + of_joints_mm => Origin::Undecided,
        _ if residual.rms_mm < NO_MEASUREMENT_MM => Origin::Undecided,
        _ => Origin::Measured,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::noise::Noise;
    use etalon_robots::{Serial, SerialJoint, TableConvention};

    fn arm() -> Serial {
        let joint = |(alpha, a_mm, theta, d_mm): (f64, f64, f64, f64)| SerialJoint {
            alpha_rad: alpha.to_radians(),
            a_mm,
            theta_rad: theta.to_radians(),
            d_mm,
            prismatic: false,
            parallel: false,
        };
        let rows = [
            (0.0, 0.0, 0.0, 290.0),
            (-90.0, 0.0, -90.0, 0.0),
            (0.0, 270.0, 0.0, 0.0),
            (-90.0, 70.0, 0.0, 302.0),
            (90.0, 0.0, 0.0, 0.0),
            (-90.0, 0.0, 180.0, 72.0),
        ];
        Serial::from_axis_table(TableConvention::Modified, &rows.map(joint), &["T".to_owned()])
    }

    /// Rows of drawn joints (deg), and points of a target in a turned world, multiplied by `scale`
    /// and rounded to `step_mm`.
    fn sample(arm: &Serial, rows: usize, scale: f64, step_mm: f64) -> Sample {
        let mut noise = Noise::new(17, rows as u64);
        let world = Pose { translation_mm: [900.0, -300.0, 150.0], ..Pose::from_rotation_vector([0.1, -0.3, 1.2]) };
        let (mut joints, mut points) = (vec![Vec::new(); 6], [Vec::new(), Vec::new(), Vec::new()]);
        for _ in 0..rows {
            let deg = [0; 6].map(|_| noise.uniform(60.0));
            let q = deg.map(f64::to_radians);
            let flange = arm.free_base().expect("an arm").flange(&arm.nominal(), &q, 0);
            let at = world.apply(flange.apply([30.0, -20.0, 85.0]));
            joints.iter_mut().zip(deg).for_each(|(column, v)| column.push(v));
            points.iter_mut().zip(at).for_each(|(column, v)| column.push((scale * v / step_mm).round() * step_mm));
        }
        Sample { joints, stated: vec![Some("deg"); 6], points, targets: vec![0; rows] }
    }

    fn reading(outcome: Outcome) -> Reading {
        match outcome {
            Outcome::Reproduced(reading) | Outcome::Ambiguous(reading, _) => reading,
            other => panic!("{other:?}"),
        }
    }

    /// An affine world takes up a scale; base and target do not.
    #[test]
    fn the_residual_is_that_of_base_and_target_alone() {
        let arm = arm();
        let scaled = sample(&arm, 40, 1.0005, 1e-6);
        let plain = Hypothesis { order: (0..6).collect(), reversed: vec![false; 6], units: vec!["deg"; 6] };
        assert!(affine(&arm, &scaled, &plain).expect("a world").rms_mm < 1e-5);
        let found = reading(test(&arm, &scaled, false));
        let by_scale_mm = 0.0005 * scaled.spread().1;
        assert!((0.5..1.0).contains(&(found.rms_mm / by_scale_mm)), "{} of {by_scale_mm}", found.rms_mm);
        assert_eq!(found.origin, Origin::Measured);
        // computed points are reproduced to their rounding
        assert!(reading(test(&arm, &sample(&arm, 40, 1.0, 1e-6), false)).rms_mm < 1e-5);
    }

    /// Few measured points, rounded to 0.1 mm, are not commanded ones because many unknowns fit
    /// them.
    #[test]
    fn few_measured_points_are_not_taken_for_commanded_ones() {
        let arm = arm();
        for rows in [15, 18, 24] {
            let measured = reading(test(&arm, &sample(&arm, rows, 1.0006, 0.1), false));
            assert_ne!(measured.origin, Origin::Commanded, "{rows}: {}", measured.rms_mm);
            let computed = reading(test(&arm, &sample(&arm, rows, 1.0, 0.1), false));
            assert_eq!(computed.origin, Origin::Commanded, "{rows}: {}", computed.rms_mm);
        }
    }
}

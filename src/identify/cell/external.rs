//! External axes from points at values of the axis: a linear axis, and a rotary axis (positioner).

use super::solve::{CellModel, Equation, UNIT, columns, moved, solve};
use super::{CellFault, CellFrame, Measure, Quality, Stated, part};
use etalon_base::pose::{Pose, Vector, centroid, cross, dot, minus, norm, unit};
use nalgebra::{DMatrix, Matrix3};

/// Measured point at a value of an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisReading {
    /// Index of the target, which the axis carries.
    pub target: usize,
    /// Value of the axis (mm or rad).
    pub value: f64,
    /// Measured position (mm).
    pub position_mm: Vector,
}

/// Linear axis.
#[derive(Clone, Debug, PartialEq)]
pub struct LinearAxis {
    /// Unit direction of positive motion.
    pub direction: Vector,
    /// Covariance of the direction.
    pub direction_covariance: [[f64; 3]; 3],
    /// Motion per unit of the axis value.
    pub scale: f64,
    /// Standard uncertainty of the scale.
    pub scale_standard_uncertainty: f64,
    /// Residuals.
    pub quality: Quality,
}

/// Rotary axis.
#[derive(Clone, Debug, PartialEq)]
pub struct RotaryAxis {
    /// Frame of the axis: z along positive rotation, origin at the foot of the first target on the
    /// axis, x towards this target at axis value zero.
    pub frame: CellFrame,
    /// Rotation per unit of the axis value.
    pub ratio: f64,
    /// Standard uncertainty of the ratio.
    pub ratio_standard_uncertainty: f64,
    /// Radius of the first target (mm).
    pub radius_mm: f64,
    /// Residuals.
    pub quality: Quality,
}

fn targets(readings: &[AxisReading]) -> usize {
    readings.iter().map(|r| r.target + 1).max().unwrap_or(0)
}

#[derive(Clone)]
struct Line<'a> {
    readings: &'a [AxisReading],
    stated: &'a Stated,
    /// Motion per unit of the axis value.
    motion: Vector,
    /// Positions of the targets at axis value zero (mm).
    zero: Vec<Vector>,
}

impl CellModel for Line<'_> {
    fn parameters(&self) -> usize {
        3 + 3 * self.zero.len()
    }

    fn equations(&self) -> Vec<Equation> {
        let equation = |(reading, r): (usize, &AxisReading)| {
            let predicted = [0, 1, 2].map(|k| self.zero[r.target][k] + r.value * self.motion[k]);
            let of_motion = columns(0, |k| UNIT[k].map(|v| v * r.value));
            Equation {
                reading,
                measure: Measure::Position,
                residual: minus(r.position_mm, predicted),
                columns: of_motion.chain(columns(3 + 3 * r.target, |k| UNIT[k])).collect(),
                covariance: self.stated.position(reading),
            }
        };
        self.readings.iter().enumerate().map(equation).collect()
    }

    fn moved(&self, step: &[f64]) -> Self {
        let add = |v: &Vector, first: usize| [0, 1, 2].map(|k| v[k] + step[first + k]);
        let zero = self.zero.iter().enumerate().map(|(t, v)| add(v, 3 + 3 * t)).collect();
        Self { motion: add(&self.motion, 0), zero, ..*self }
    }
}

/// Spread of the values of an axis: the largest over targets.
fn spread(readings: &[AxisReading]) -> f64 {
    let of = |t: usize| {
        let own = || readings.iter().filter(move |r| r.target == t).map(|r| r.value);
        own().fold(f64::MIN, f64::max) - own().fold(f64::MAX, f64::min)
    };
    (0..targets(readings)).map(of).fold(0.0, f64::max)
}

/// Checks that the axis moves between readings of one target.
fn check_motion(readings: &[AxisReading]) -> Result<(), CellFault> {
    let repeated = readings.len() > targets(readings);
    let at_rest = repeated && spread(readings) <= 0.0;
    if at_rest { Err(CellFault::AtRest { readings: readings.len() }) } else { Ok(()) }
}

/// Direction and scale of a linear axis.
///
/// # Errors
/// Fails with too few readings, if the axis is at rest, and if the targets do not move.
pub fn linear_axis(readings: &[AxisReading], stated: &Stated) -> Result<LinearAxis, CellFault> {
    let zero = vec![[0.0; 3]; targets(readings)];
    check_motion(readings)?;
    if readings.len() < zero.len() + 1 {
        return Err(CellFault::TooFew { needed: zero.len() + 1, readings: readings.len() });
    }
    let solved = solve(Line { readings, stated, motion: [0.0; 3], zero }, stated).ok_or(CellFault::Undetermined)?;
    let motion = solved.model.motion;
    let (scale, direction) = (norm(motion), unit(motion).ok_or(CellFault::Coincident)?);
    let own = Matrix3::from_fn(|i, j| solved.covariance[(i, j)]);
    let d = nalgebra::Vector3::from(direction);
    let across = (Matrix3::identity() - d * d.transpose()) / scale;
    let turned = across * own * across.transpose();
    Ok(LinearAxis {
        direction,
        direction_covariance: std::array::from_fn(|i| std::array::from_fn(|j| turned[(i, j)])),
        scale,
        scale_standard_uncertainty: (d.transpose() * own * d)[(0, 0)].max(0.0).sqrt(),
        quality: solved.quality,
    })
}

/// Positions `axis · Rz(ratio · value) · place`, the place of each target in cylinder coordinates.
#[derive(Clone)]
struct Turn<'a> {
    readings: &'a [AxisReading],
    stated: &'a Stated,
    /// z along the axis.
    axis: Pose,
    ratio: f64,
    /// Places of the targets in the frame of the axis at axis value zero (mm). The first one has
    /// y = z = 0.
    places: Vec<Vector>,
}

/// Parameters of the axis and the ratio.
const OF_AXIS: usize = 7;

impl Turn<'_> {
    /// Index of the first parameter of a place; the first target has one, others have three.
    fn first(target: usize) -> usize {
        if target == 0 { OF_AXIS } else { OF_AXIS + 1 + 3 * (target - 1) }
    }
}

impl CellModel for Turn<'_> {
    fn parameters(&self) -> usize {
        OF_AXIS + 1 + 3 * (self.places.len() - 1)
    }

    fn equations(&self) -> Vec<Equation> {
        let equation = |(reading, r): (usize, &AxisReading)| {
            let turned = self.axis.turn_z(self.ratio * r.value);
            let lever = turned.rotate(self.places[r.target]);
            let of_ratio = cross(self.axis.axis(2), lever).map(|v| v * r.value);
            let mut all: Vec<(usize, Vector)> =
                columns(0, |k| UNIT[k]).chain(columns(3, |k| cross(UNIT[k], lever))).collect();
            all.push((6, of_ratio));
            let own = if r.target == 0 { 1 } else { 3 };
            all.extend((0..own).map(|k| (Self::first(r.target) + k, turned.axis(k))));
            Equation {
                reading,
                measure: Measure::Position,
                residual: minus(r.position_mm, turned.apply(self.places[r.target])),
                columns: all,
                covariance: self.stated.position(reading),
            }
        };
        self.readings.iter().enumerate().map(equation).collect()
    }

    fn moved(&self, step: &[f64]) -> Self {
        let mut places = self.places.clone();
        for (t, place) in places.iter_mut().enumerate() {
            let own = if t == 0 { 1 } else { 3 };
            (0..own).for_each(|k| place[k] += step[Self::first(t) + k]);
        }
        Self { axis: moved(&self.axis, &step[..3], &step[3..6]), ratio: self.ratio + step[6], places, ..*self }
    }
}

/// Frame and ratio of a rotary axis; the first target defines the x axis.
///
/// # Errors
/// Fails with fewer than three readings of the first target, if the axis is at rest, and if they do
/// not determine a circle.
pub fn rotary_axis(readings: &[AxisReading], stated: &Stated) -> Result<RotaryAxis, CellFault> {
    let own: Vec<&AxisReading> = readings.iter().filter(|r| r.target == 0).collect();
    let count = targets(readings);
    if own.len() < 3 {
        return Err(CellFault::TooFew { needed: 3, readings: own.len() });
    }
    check_motion(readings)?;
    let points: Vec<Vector> = own.iter().map(|r| r.position_mm).collect();
    super::check_points(&points)?;
    let start = start(readings, &own, count).ok_or(CellFault::Undetermined)?;
    let start = Turn { stated, ..start };
    let solved = solve(start, stated).ok_or(CellFault::Undetermined)?;
    let mut covariance: DMatrix<f64> = solved.covariance;
    let mut axis = solved.model.axis;
    let mut radius = solved.model.places[0][0];
    if radius < 0.0 {
        // half a turn about z, which leaves the axes of the covariance
        axis = axis.turn_z(std::f64::consts::PI);
        radius = -radius;
    }
    let ratio = solved.model.ratio;
    if ratio < 0.0 {
        // half a turn about x
        axis = axis.turn_x(std::f64::consts::PI);
        covariance[(6, 6)] = covariance[(6, 6)].abs();
    }
    Ok(RotaryAxis {
        frame: CellFrame { pose: axis, covariance: part(&covariance, [0, 1, 2, 3, 4, 5]) },
        ratio: ratio.abs(),
        ratio_standard_uncertainty: covariance[(6, 6)].max(0.0).sqrt(),
        radius_mm: radius,
        quality: solved.quality,
    })
}

/// Start of a rotary axis: the normal of the plane of the first target, the circle by its chords,
/// and the sign of the better fit.
fn start<'a>(readings: &'a [AxisReading], own: &[&AxisReading], count: usize) -> Option<Turn<'a>> {
    let points: Vec<Vector> = own.iter().map(|r| r.position_mm).collect();
    let centre = centroid(&points)?;
    let mut scatter = [[0.0; 3]; 3];
    for p in &points {
        let d = minus(*p, centre);
        (0..9).for_each(|k| scatter[k / 3][k % 3] += d[k / 3] * d[k % 3]);
    }
    let (_, vectors) = etalon_math::symmetric_eigen(scatter);
    let [z, _, x] = vectors;
    let y = cross(z, x);
    // circle in the plane: u² + v² = 2 a u + 2 b v + c
    let (mut rows, mut right) = (Vec::new(), Vec::new());
    for p in &points {
        let d = minus(*p, centre);
        let (u, v) = (dot(d, x), dot(d, y));
        rows.extend([u, v, 1.0]);
        right.push(0.5 * (u * u + v * v));
    }
    let norms = etalon_math::column_norms(&rows, 3);
    let solution = etalon_math::Factor::new(&rows, &right, &norms).solve()?;
    let (a, b) = (solution[0] / norms[0], solution[1] / norms[1]);
    let origin = [0, 1, 2].map(|k| centre[k] + a * x[k] + b * y[k]);
    let mut best: Option<(f64, Turn)> = None;
    for (sign, ratio) in [1.0, -1.0].into_iter().flat_map(|sign| RATIOS.map(|ratio| (sign, ratio))) {
        let z = z.map(|v| v * sign);
        let reference = unit(cross(if z[0].abs() < 0.9 { UNIT[0] } else { UNIT[1] }, z))?;
        let side = cross(z, reference);
        let rotation = [0, 1, 2].map(|i| [reference[i], side[i], z[i]]);
        let turn = turned_back(readings, count, Pose { rotation, translation_mm: origin }, ratio)?;
        let at = |r: &AxisReading| turn.axis.turn_z(ratio * r.value).apply(turn.places[r.target]);
        let cost: f64 = readings.iter().map(|r| norm(minus(r.position_mm, at(r))).powi(2)).sum();
        if best.as_ref().is_none_or(|b| cost < b.0) {
            best = Some((cost, turn));
        }
    }
    best.map(|b| b.1)
}

/// Ratios of starts: values in their unit, and degrees and radians swapped.
const RATIOS: [f64; 3] = [1.0, 180.0 / std::f64::consts::PI, std::f64::consts::PI / 180.0];
/// Nothing is given.
const NOTHING: &Stated = &Stated { position_mm: None, rotation_rad: None, measured_mm: Vec::new() };

/// Places of the targets by readings that are turned back to axis value zero, about the z axis of
/// `base`.
fn turned_back<'a>(readings: &'a [AxisReading], count: usize, base: Pose, ratio: f64) -> Option<Turn<'a>> {
    let back = |r: &AxisReading| base.turn_z(ratio * r.value).inverse().apply(r.position_mm);
    let of = |t: usize| centroid(&readings.iter().filter(|r| r.target == t).map(back).collect::<Vec<_>>());
    let first = of(0)?;
    let axis = base.turn_z(first[1].atan2(first[0])).shift(2, first[2]);
    let inside = |t: usize| Some(axis.inverse().apply(base.apply(of(t)?)));
    let mut places = (0..count).map(inside).collect::<Option<Vec<Vector>>>()?;
    places[0] = [first[0].hypot(first[1]), 0.0, 0.0];
    Some(Turn { readings, stated: NOTHING, axis, ratio, places })
}

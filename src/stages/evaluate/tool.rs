//! The expected error at the tool point.

use crate::stages::evaluate::accuracy::summarise;
use crate::stages::evaluate::field::FieldSearch;
use crate::stages::evaluate::sets::Sets;
use crate::stages::remedies::remedied;
use etalon_base::catalogue::Phrase;
use etalon_base::message::Result;
use etalon_base::phrase;
use etalon_base::pose::{Pose, Vector, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_documents::{AccuracyDocument, FieldHeldOut, MapNode, PredictionMap, Statistics, ToolAccuracy};
use etalon_identify::{JointField, Settings, ToolError, ToolFrame, ToolPrediction, UncertaintyFrom};
use etalon_robots::{Correction, Kinematics};
use nalgebra::Matrix3;
use rayon::prelude::*;
use statrs::distribution::{Continuous, ContinuousCDF, Gamma, Normal};
use std::collections::{BTreeMap, BTreeSet};

/// Coverage factor of an expanded uncertainty (GUM 6.3.3).
const COVERAGE: f64 = 2.0;

/// The expected error of the controller at a point with the identified parameters. Its variance is
/// the sum of the variances of the predicted position, of parameters that the data do not
/// determine, of the model error, and of the position of the point.
pub struct Expected<'a> {
    prediction: ToolPrediction<'a>,
    model_mm: f64,
    place_mm: f64,
    instrument_mm: f64,
    /// Residual field, and the model error with it.
    field: Option<(&'a JointField, f64)>,
}

impl<'a> Expected<'a> {
    /// The error from a prediction, and from the excess of the measured accuracy over the
    /// instrument's uncertainty in `settings`.
    pub fn new(prediction: ToolPrediction<'a>, settings: &Settings, accuracy: &AccuracyDocument) -> Self {
        let dimension = prediction.robot.dimension() as f64;
        // the measured error beyond the error of the instrument, if the residuals show one
        let position = accuracy.sets.last().and_then(|set| set.leading());
        let measured = position.map_or(0.0, |e| e.after.rms);
        let instrument = dimension * settings.coordinate_uncertainty_mm().powi(2);
        let model_mm = match prediction.found.uncertainty.from {
            UncertaintyFrom::Instrument => 0.0,
            _ => (measured.powi(2) - instrument).max(0.0).sqrt(),
        };
        let place_mm = dimension.sqrt() * prediction.point.standard_uncertainty_mm;
        Self { prediction, model_mm, place_mm, instrument_mm: instrument.sqrt(), field: None }
    }

    /// Adds a residual field, whose model error is that at held-out poses.
    pub fn with_field(self, search: Option<&'a FieldSearch>) -> Self {
        let left = |held: &FieldHeldOut| (held.with_mm.powi(2) - self.instrument_mm.powi(2)).max(0.0).sqrt();
        let proved = |search: &'a FieldSearch| Some((search.field.as_ref()?, search.summary.held_out.as_ref()?));
        Self { field: search.and_then(proved).map(|(field, held)| (field, left(held))), ..self }
    }

    /// Expected size of the error with the field at joint values (mm).
    fn with_field_mm(&self, error: &ToolError, joints: &[f64]) -> Option<f64> {
        let (field, left_mm) = self.field?;
        let share = field.share(joints);
        let model = share * left_mm.powi(2) + (1.0 - share) * self.model_mm.powi(2);
        Some(error.parameters_mm.hypot(error.held_mm).hypot(model.sqrt()).hypot(self.place_mm))
    }

    fn at(&self, joints: &[f64]) -> Result<Option<ToolError>> {
        self.prediction.error(joints).map_err(remedied)
    }

    /// Standard uncertainty of the position (k = 1), mm.
    fn total_mm(&self, error: &ToolError) -> f64 {
        error.parameters_mm.hypot(error.held_mm).hypot(self.model_mm).hypot(self.place_mm)
    }

    /// Over the judged poses; `None` without a covariance.
    pub fn accuracy(&self, sets: &Sets, accuracy: &AccuracyDocument) -> Result<Option<ToolAccuracy>> {
        let Some(judged) = accuracy.sets.last() else { return Ok(None) };
        let (observations, _) = sets.observations_and_conditions(judged.name);
        let count = observations.len() as f64;
        let (mut sizes_before, mut sizes) = (Vec::new(), Vec::new());
        let (mut of_parameters, mut of_held) = (0.0, 0.0);
        // repeats of a pose mostly have its joint values
        let mut of_poses: BTreeMap<PoseName, (&[f64], ToolError)> = BTreeMap::new();
        for o in observations {
            let error = match of_poses.get(&o.pose) {
                Some((joints, error)) if *joints == &o.joints[..] => *error,
                _ => {
                    let Some(error) = self.at(&o.joints)? else { return Ok(None) };
                    of_poses.insert(o.pose, (&o.joints, error));
                    error
                }
            };
            sizes_before.push(norm(error.before_mm));
            sizes.push(self.total_mm(&error));
            of_parameters += error.parameters_mm.powi(2) / count;
            of_held += error.held_mm.powi(2) / count;
        }
        let after: Statistics = summarise(sizes);
        let definition = phrase!("tool-error-definition", error = self.error());
        Ok(Some(ToolAccuracy {
            definition: definition.into(),
            point_mm: self.prediction.point.point_mm,
            frame: self.prediction.point.frame.into(),
            set: judged.name,
            poses: observations.iter().map(|o| o.pose).collect::<BTreeSet<PoseName>>().len(),
            before: summarise(sizes_before),
            after,
            expanded_max_mm: COVERAGE * after.max,
            parameters_mm: of_parameters.sqrt(),
            held_mm: of_held.sqrt(),
            model_mm: self.model_mm,
            place_mm: self.place_mm,
        }))
    }

    /// Description of the error.
    fn error(&self) -> Phrase {
        let place = self.prediction.point.point_mm;
        let point = match self.prediction.point.frame {
            ToolFrame::Platform if place == [0.0; 3] => phrase!("platform-centre"),
            ToolFrame::Targets if place == [0.0; 3] => {
                phrase!("target-named", target = self.prediction.robot.targets()[0])
            }
            ToolFrame::Platform => phrase!("point-in-platform", point = format!("{place:?}")),
            ToolFrame::Flange => phrase!("point-in-flange", point = format!("{place:?}")),
            ToolFrame::Targets => phrase!("point-in-targets", point = format!("{place:?}")),
        };
        phrase!("error-of-tool", point)
    }

    /// On a grid of the workspace that the calibration poses span; `None` without a covariance or
    /// inverse kinematics.
    pub fn map(&self, sets: &Sets) -> Result<Option<PredictionMap>> {
        let Some(kinematics) = self.prediction.robot.kinematics() else { return Ok(None) };
        let values = &self.prediction.found.values;
        let mut poses = Vec::new();
        for o in &sets.calibration {
            let at_mm = self.prediction.point.in_base(self.prediction.robot, values, &o.joints).map_err(remedied)?;
            if let Some(tool) = kinematics.tool_pose(values, &o.joints).filter(|_| at_mm.iter().all(|v| v.is_finite()))
            {
                poses.push(Spanning { at_mm, tool, joints: &o.joints });
            }
        }
        let (places, spacing_mm) = grid(&poses);
        let nodes = places.par_iter().map(|at| self.node(kinematics, &poses, *at)).collect::<Result<Vec<_>>>()?;
        let nodes: Vec<MapNode> = nodes.into_iter().flatten().collect();
        Ok((nodes.len() >= FEWEST_NODES).then(|| PredictionMap {
            definition: phrase!("prediction-map-definition", error = self.error()).to_string(),
            point_mm: self.prediction.point.point_mm,
            frame: self.prediction.point.frame.into(),
            spacing_mm,
            nodes,
        }))
    }

    /// A node, if the robot reaches it with joint values within the range of the calibration.
    fn node(&self, kinematics: &dyn Kinematics, poses: &[Spanning], at_mm: Vector) -> Result<Option<MapNode>> {
        let distance = |pose: &&Spanning| norm(minus(pose.at_mm, at_mm));
        let Some(near) = poses.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))) else { return Ok(None) };
        // in the same orientation the tool is as far from the point
        let lever = minus(near.at_mm, near.tool.translation_mm);
        let target = Pose { translation_mm: minus(at_mm, lever), ..near.tool };
        let Ok(joints) = kinematics.nearest_joints(&self.prediction.found.values, &target, near.joints) else {
            return Ok(None);
        };
        let within = |k: usize| {
            let all = || poses.iter().map(|pose| pose.joints[k]);
            all().any(|q| q <= joints[k] + SAME) && all().any(|q| q >= joints[k] - SAME)
        };
        if !(0..joints.len()).all(within) {
            return Ok(None);
        }
        let Some(error) = self.at(&joints)? else { return Ok(None) };
        let d = self.prediction.robot.dimension();
        let others = (self.model_mm.powi(2) + self.place_mm.powi(2)) / d as f64;
        let mut covariance = error.covariance_mm2;
        (0..d).for_each(|i| covariance[(i, i)] += others);
        let joint = self.prediction.robot.joints().iter().zip(&joints);
        Ok(Some(MapNode {
            at_mm,
            joints: joint.map(|(joint, q)| joint.quantity.outward(*q)).collect(),
            before_mm: norm(error.before_mm),
            parameters_mm: error.parameters_mm,
            standard_uncertainty_mm: self.total_mm(&error),
            with_field_mm: self.with_field_mm(&error, &joints),
            p95_mm: p95(&covariance),
        }))
    }
}

/// Maximum excess of joint values over the range of the calibration (mm or rad).
const SAME: f64 = 1e-9;
/// Minimum number of nodes of a map; fewer do not represent the workspace.
const FEWEST_NODES: usize = 10;
/// Maximum number of nodes of a map.
const MOST_NODES: usize = 300;

/// Relative step with which the search of a quantile ends; its error is of the order of the square.
const CONVERGED: f64 = 1e-8;
/// Maximum number of steps of that search.
const STEPS: usize = 10;

/// A pose of the calibration.
struct Spanning<'a> {
    at_mm: Vector,
    tool: Pose,
    joints: &'a [f64],
}

/// Returns the positions of a grid over the box of these poses, and its spacing: the smallest of 1,
/// 2, 5, 10 ... that makes few enough nodes. Along an axis in which the poses differ by less than
/// the spacing, the middle.
fn grid(poses: &[Spanning]) -> (Vec<Vector>, f64) {
    let bounds: [[f64; 2]; 3] = std::array::from_fn(|axis| {
        let of = |pick: fn(f64, f64) -> f64| poses.iter().map(|p| p.at_mm[axis]).reduce(pick).unwrap_or(0.0);
        [of(f64::min), of(f64::max)]
    });
    let along = |[lower, upper]: [f64; 2], step: f64| -> Vec<f64> {
        let (first, last) = ((lower / step).ceil() as i64, (upper / step).floor() as i64);
        if last <= first { vec![0.5 * (lower + upper)] } else { (first..=last).map(|i| i as f64 * step).collect() }
    };
    let steps = (-2..9).flat_map(|power| [1.0, 2.0, 5.0].map(|digit| digit * 10f64.powi(power)));
    let few =
        |step: &f64| bounds.iter().map(|[l, u]| ((u - l) / step + 1.0).floor()).product::<f64>() <= MOST_NODES as f64;
    let spacing = { steps }.find(few).unwrap_or(f64::MAX);
    let [x, y, z] = bounds.map(|b| along(b, spacing));
    let yz = |&x: &f64| y.iter().flat_map(|&y| z.iter().map(move |&z| [x, y, z])).collect::<Vec<_>>();
    (x.iter().flat_map(yz).collect(), spacing)
}

/// Returns the size that a normal error of this covariance exceeds with a probability of 5 %: the
/// sum of squares has nearly the distribution g χ²(ν) with the same mean and variance (Box 1954,
/// Ann. Math. Statist. 25, 290, theorem 3.1).
fn p95(covariance: &Matrix3<f64>) -> f64 {
    let (trace, of_square) = (covariance.trace(), (covariance * covariance).trace());
    match Gamma::new(0.5 * trace.powi(2) / of_square, 0.5 * trace / of_square) {
        Ok(distribution) => quantile(&distribution, 0.95).sqrt(),
        Err(_) => 0.0,
    }
}

/// Quantile by Newton's method from the approximation of Wilson and Hilferty (1931, Proc. Natl.
/// Acad. Sci. 17, 684): a quarter of the time of a search by bisection.
fn quantile(distribution: &Gamma, probability: f64) -> f64 {
    let (shape, rate) = (distribution.shape(), distribution.rate());
    let variance = 1.0 / (9.0 * shape);
    let root = 1.0 - variance + Normal::standard().inverse_cdf(probability) * variance.sqrt();
    let mut x = shape * root.powi(3) / rate;
    for _ in 0..STEPS {
        let step = (distribution.cdf(x) - probability) / distribution.pdf(x);
        x -= step;
        if step.abs() <= CONVERGED * x {
            return x;
        }
    }
    distribution.inverse_cdf(probability)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_tables() {
        // chi-square with 1, 2 and 3 degrees of freedom, 95 %
        for (degrees, expected) in
            [(1.0, 3.841_458_820_694_124), (2.0, -2.0 * 0.05f64.ln()), (3.0, 7.814_727_903_251_179)]
        {
            let found = quantile(&Gamma::new(0.5 * degrees, 0.5).unwrap(), 0.95);
            assert!((found / expected - 1.0).abs() < 1e-12, "{degrees}: {found}");
        }
        // an error along one axis: 1.96 standard uncertainties
        let along_x = Matrix3::from_diagonal(&nalgebra::Vector3::new(4.0, 0.0, 0.0));
        assert!((p95(&along_x) - 2.0 * 1.959_963_984_540_054).abs() < 1e-12);
    }
}

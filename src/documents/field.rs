//! `field.json`: the residual field of a robot, and its summary in other documents.

use super::{Provenance, Role};
use crate::worded::worded;
use etalon_base::catalogue::Phrase;
use etalon_base::message::Message;
use etalon_base::pose_name::PoseName;
use etalon_base::worded::Worded;
use etalon_base::{error, phrase};
use etalon_identify::{Component, FieldInput, FieldRefusal, FieldTrial, HeldOut, JointField};
use etalon_robots::{Quantity, Robot};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Errors of joints that the parameters do not describe, as functions of the joint values. The
/// robot is at the position of its model with the parameters in `parameters` and the joint values
/// q + δq(q).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FieldDocument {
    /// Schema and version: `etalon/field/1`.
    pub schema: String,
    /// Model of the robot.
    pub robot: String,
    /// SHA-256 of the `parameters.json` to which the field belongs.
    pub parameters_sha256: String,
    /// Joints of the robot, named as columns: `q1_deg`.
    pub joints: Vec<String>,
    /// Components; the errors of a joint add up.
    pub components: Vec<FieldComponent>,
    /// Parameters that belong to the field: the parameters of `parameters.json`, estimated again
    /// with the field. Beyond the measured poses they fade to the values of `parameters.json`, as
    /// δq fades to 0.
    pub parameters: Vec<FieldParameter>,
    /// Covariance of the parameters in `covariance_of`, followed by the weights of the components,
    /// in their units.
    pub covariance: Vec<Vec<f64>>,
    /// Names of the parameters in `covariance`.
    pub covariance_of: Vec<String>,
    /// Factor of standard uncertainties from `covariance`, with which they agree with the errors at
    /// held-out poses; beyond the poses at least 1.
    pub factor: f64,
    /// Standard deviation of a measured coordinate without the field's error (mm).
    pub noise_mm: f64,
    /// Explanation of synthetic data, as the campaign gives it; absent for measured data.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub synthetic: Option<String>,
    /// Origin of the numbers.
    pub provenance: Provenance,
}

/// Error of one joint as a function of one or two joints: the sum over `centres` of weight · φ(d)
/// with φ(d) = (1 − d)⁴ (4 d + 1) for d < 1, otherwise 0; d² = Σ ((q − at) / (scale · radius))².
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FieldComponent {
    /// Joint that is off, named as a column: `q2_deg`.
    pub joint: String,
    /// Joints on which the error depends.
    pub inputs: Vec<FieldInputEntry>,
    /// Radius beyond which a centre has no effect, in units of `scale`.
    pub radius: f64,
    /// Standard deviation of the error without knowledge (mm or deg).
    pub prior: f64,
    /// Centres with their weights.
    pub centres: Vec<FieldCentre>,
}

/// Joint on which a component depends.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FieldInputEntry {
    /// Joint, named as a column: `q2_deg`.
    pub joint: String,
    /// Length of one unit of distance (mm or deg).
    pub scale: f64,
    /// Range of the measured poses (mm or deg).
    pub range: [f64; 2],
    /// Width beyond the range in which the field fades out (mm or deg).
    pub fade: f64,
}

/// Centre of a component.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FieldCentre {
    /// Joint values (mm or deg), in the order of the inputs.
    pub at: Vec<f64>,
    /// Weight (mm or deg of the joint that is off).
    pub weight: f64,
}

/// Parameter that belongs to the field.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FieldParameter {
    /// Name.
    pub name: String,
    /// `mm`, `deg` or `1`.
    pub unit: String,
    /// Owner of the parameter. Programs without the measured targets omit the parameters of
    /// targets.
    pub role: Role,
    /// Value with the field.
    pub value: f64,
    /// Change from `parameters.json`.
    pub shift: f64,
}

/// Search for a residual field, and its result at held-out poses.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FieldSummary {
    /// `true` if held-out poses prove the field: it is in `field.json`.
    pub accepted: bool,
    /// Reason for the refusal; absent if accepted.
    #[serde(flatten, with = "FieldSummaryReason")]
    pub reason: Option<Worded>,
    /// Errors at held-out poses; absent if no field was tried there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub held_out: Option<FieldHeldOut>,
    /// Dependences of an accepted field.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub components: Vec<FieldDependence>,
}

worded! {
    /// Reason for the refusal; absent if accepted.
    option FieldSummaryReason: reason, reason_phrase
}

/// Errors at poses that were held out: parameters and field are from the other poses.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FieldHeldOut {
    /// Root mean square position error without the field (mm).
    pub without_mm: f64,
    /// Root mean square position error with the field (mm).
    pub with_mm: f64,
    /// Decrease of the mean square error over its standard uncertainty.
    pub gain_over_u: f64,
    /// Share of coordinates within 1.96 predicted standard uncertainties.
    pub coverage: f64,
    /// Factor of the field's standard uncertainty with which the errors agree with it.
    pub factor: f64,
    /// Errors of each pose.
    pub poses: Vec<FieldPose>,
}

/// Errors of a held-out pose.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FieldPose {
    /// Pose.
    pub pose: PoseName,
    /// Root mean square position error without the field (mm).
    pub without_mm: f64,
    /// Root mean square position error with the field (mm).
    pub with_mm: f64,
}

/// Dependence of a joint's error on joints.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FieldDependence {
    /// Joint that is off.
    pub joint: String,
    /// Joints on which the error depends, with the measured range (mm or deg).
    pub inputs: Vec<FieldRange>,
    /// Standard deviation of the error (mm or deg).
    pub prior: f64,
}

/// Measured range of a joint.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FieldRange {
    /// Joint.
    pub joint: String,
    /// Lower and upper end (mm or deg).
    pub range: [f64; 2],
}

impl FieldDocument {
    /// Value of `schema`.
    pub const SCHEMA: &str = "etalon/field/1";
    /// Name of the file.
    pub const NAME: &str = "field.json";

    /// Document of a field with the identified values of the parameters.
    pub fn new(robot: &dyn Robot, values: &[f64], field: &JointField, parameters_sha256: String) -> Self {
        let unit = |joint: usize| robot.joints()[joint].quantity.outward(1.0);
        let column = |joint: usize| robot.joints()[joint].column();
        let input = |i: &FieldInput| FieldInputEntry {
            joint: column(i.joint),
            scale: unit(i.joint) * i.scale,
            range: i.range.map(|q| unit(i.joint) * q),
            fade: unit(i.joint) * i.fade,
        };
        let component = |c: &Component| FieldComponent {
            joint: column(c.joint),
            inputs: c.inputs.iter().map(input).collect(),
            radius: c.radius,
            prior: unit(c.joint) * c.prior,
            centres: c
                .centres
                .iter()
                .zip(&c.weights)
                .map(|(at, weight)| FieldCentre {
                    at: at.iter().zip(&c.inputs).map(|(q, i)| unit(i.joint) * q).collect(),
                    weight: unit(c.joint) * weight,
                })
                .collect(),
        };
        let parameters = robot.parameters().iter().zip(values).zip(&field.shift);
        let units = units(robot, field);
        let size = units.len();
        let row = |i: usize| (0..size).map(|j| units[i] * units[j] * field.covariance[i * size + j]).collect();
        Self {
            schema: Self::SCHEMA.to_owned(),
            robot: robot.model().to_owned(),
            parameters_sha256,
            joints: robot.joints().iter().map(|joint| joint.column()).collect(),
            components: field.components.iter().map(component).collect(),
            parameters: parameters
                .map(|((p, value), shift)| FieldParameter {
                    name: p.name.clone(),
                    unit: p.quantity.unit().to_owned(),
                    role: p.role.into(),
                    value: p.quantity.outward(value + shift),
                    shift: p.quantity.outward(*shift),
                })
                .collect(),
            covariance: (0..size).map(row).collect(),
            covariance_of: field.free.iter().map(|&i| robot.parameters()[i].name.clone()).collect(),
            factor: field.factor,
            noise_mm: field.noise_mm,
            synthetic: None,
            provenance: Provenance {
                version: env!("CARGO_PKG_VERSION").to_owned(),
                inputs: Default::default(),
                seed: None,
            },
        }
    }

    /// Returns the field of this document for a robot.
    ///
    /// # Errors
    /// Fails if the document is of another robot, or inconsistent.
    pub fn field(&self, robot: &dyn Robot) -> Result<JointField, Message> {
        let other = |name: &str| error!("field-of-other-robot", name);
        let joint =
            |name: &String| robot.joints().iter().position(|joint| joint.column() == *name).ok_or_else(|| other(name));
        // a compensated program has other targets than the measured ones
        let of_target = |name: &String| self.parameters.iter().any(|p| p.name == *name && p.role == Role::Target);
        let parameter = |name: &String| match robot.index(name) {
            None if !of_target(name) => Err(other(name)),
            found => Ok(found),
        };
        if self.schema != Self::SCHEMA || self.robot != robot.model() {
            return Err(other(&self.robot));
        }
        let mut components = Vec::new();
        for c in &self.components {
            let quantity = |joint: usize| -> Quantity { robot.joints()[joint].quantity };
            let of = joint(&c.joint)?;
            let mut inputs = Vec::new();
            for i in &c.inputs {
                let joint = joint(&i.joint)?;
                let inward = |q: f64| quantity(joint).inward(q);
                let range = i.range.map(inward);
                inputs.push(FieldInput { joint, scale: inward(i.scale), range, fade: inward(i.fade) });
            }
            let at = |centre: &FieldCentre| -> Vec<f64> {
                centre.at.iter().zip(&inputs).map(|(q, i)| quantity(i.joint).inward(*q)).collect()
            };
            components.push(Component {
                joint: of,
                centres: c.centres.iter().map(at).collect(),
                weights: c.centres.iter().map(|centre| quantity(of).inward(centre.weight)).collect(),
                radius: c.radius,
                prior: quantity(of).inward(c.prior),
                inputs,
            });
        }
        let mut shift = vec![0.0; robot.parameters().len()];
        for p in &self.parameters {
            let Some(i) = parameter(&p.name)? else { continue };
            shift[i] = robot.parameters()[i].quantity.inward(p.shift);
        }
        let stated = self.covariance_of.iter().map(parameter).collect::<Result<Vec<_>, _>>()?;
        let free: Vec<usize> = stated.iter().copied().flatten().collect();
        let (factor, noise_mm) = (self.factor, self.noise_mm);
        let mut field = JointField { components, shift, free, covariance: Vec::new(), factor, noise_mm };
        let units = units(robot, &field);
        let size = units.len() + stated.len() - field.free.len();
        let square = self.covariance.len() == size && self.covariance.iter().all(|row| row.len() == size);
        if !square || !self.is_sound() {
            return Err(error!("field-inconsistent"));
        }
        let kept = |i: &usize| stated.get(*i).is_none_or(Option::is_some);
        let kept: Vec<usize> = (0..size).filter(kept).collect();
        let rows = kept.iter().zip(&units);
        let row = |(i, a): (&usize, &f64)| -> Vec<f64> {
            kept.iter().zip(&units).map(|(j, b)| self.covariance[*i][*j] / (a * b)).collect()
        };
        field.covariance = rows.flat_map(row).collect();
        Ok(field)
    }

    /// `true` if all numbers are finite, and lengths positive.
    fn is_sound(&self) -> bool {
        let positive = |v: f64| v.is_finite() && v > 0.0;
        let centre = |c: &FieldCentre, inputs: usize| {
            c.at.len() == inputs && c.at.iter().chain([&c.weight]).all(|v| v.is_finite())
        };
        let component = |c: &FieldComponent| {
            (1..=2).contains(&c.inputs.len())
                && positive(c.radius)
                && c.prior.is_finite()
                && c.inputs.iter().all(|i| positive(i.scale) && positive(i.fade) && i.range[0] < i.range[1])
                && c.centres.iter().all(|centre_| centre(centre_, c.inputs.len()))
        };
        let numbers = self.covariance.iter().flatten().chain([&self.factor, &self.noise_mm]);
        self.components.iter().all(component) && numbers.into_iter().all(|v| v.is_finite())
    }
}

/// Units of the covariance: of its parameters and of the weights.
fn units(robot: &dyn Robot, field: &JointField) -> Vec<f64> {
    let of_parameters = field.free.iter().map(|&i| robot.parameters()[i].quantity.outward(1.0));
    let of_weights = field
        .components
        .iter()
        .flat_map(|c| std::iter::repeat_n(robot.joints()[c.joint].quantity.outward(1.0), c.weights.len()));
    of_parameters.chain(of_weights).collect()
}

impl FieldSummary {
    /// Summary of a search.
    pub fn new(robot: &dyn Robot, trial: &FieldTrial) -> Self {
        let components = trial.field.iter().flat_map(|field| &field.components);
        let reason = trial.refusal.map(|refusal| reason(refusal, trial.held_out.as_ref()));
        Self {
            accepted: trial.field.is_some(),
            reason: reason.map(Worded::from),
            held_out: trial.held_out.as_ref().map(FieldHeldOut::new),
            components: components.map(|c| dependence(robot, c)).collect(),
        }
    }

    /// Summary of a field that was identified elsewhere.
    pub fn from_field(robot: &dyn Robot, field: &JointField) -> Self {
        let components = field.components.iter().map(|c| dependence(robot, c)).collect();
        Self { accepted: true, reason: None, held_out: None, components }
    }

    /// Summary of a field that is not searched, with the reason.
    pub fn refused(reason: Phrase) -> Self {
        Self { accepted: false, reason: Some(reason.into()), held_out: None, components: Vec::new() }
    }
}

fn dependence(robot: &dyn Robot, c: &Component) -> FieldDependence {
    let outward = |joint: usize, v: f64| robot.joints()[joint].quantity.outward(v);
    let input = |i: &FieldInput| FieldRange {
        joint: robot.joints()[i.joint].column(),
        range: i.range.map(|q| outward(i.joint, q)),
    };
    FieldDependence {
        joint: robot.joints()[c.joint].column(),
        inputs: c.inputs.iter().map(input).collect(),
        prior: outward(c.joint, c.prior),
    }
}

/// Reason for a refusal in words.
fn reason(refusal: FieldRefusal, held_out: Option<&HeldOut>) -> Phrase {
    match refusal {
        FieldRefusal::NotPositions => phrase!("field-needs-positions"),
        FieldRefusal::TooFewPoses(poses, needed) => phrase!("field-needs-poses", poses, needed),
        FieldRefusal::Undetermined => phrase!("field-undetermined"),
        FieldRefusal::NothingShown(rise, threshold) => phrase!("field-not-shown", rise, threshold),
        FieldRefusal::Suspect(pose, error_mm) => phrase!("field-readings-suspect", pose, error_mm),
        FieldRefusal::NotProven => {
            let [without_mm, with_mm] = held_out.map_or([0.0; 2], |held| held.rms_mm);
            let gain = held_out.map_or(0.0, |held| held.gain_over_u);
            phrase!("field-not-proven", without_mm, with_mm, gain)
        }
    }
}

impl FieldHeldOut {
    fn new(held: &HeldOut) -> Self {
        let pose = |(pose, [without_mm, with_mm]): &(PoseName, [f64; 2])| FieldPose {
            pose: *pose,
            without_mm: *without_mm,
            with_mm: *with_mm,
        };
        Self {
            without_mm: held.rms_mm[0],
            with_mm: held.rms_mm[1],
            gain_over_u: held.gain_over_u,
            coverage: held.coverage,
            factor: held.factor,
            poses: held.poses.iter().map(pose).collect(),
        }
    }
}

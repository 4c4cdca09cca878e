//! Answer to the question of which values a controller should load. A run decides once, from its
//! documents; next steps and `etalon recommend` repeat this answer.

use crate::{AccuracyDocument, ControllerErrors, Effect, EffectProof, FigureBudget, PositionErrors};
use crate::{
    CampaignSummary, ControllerFiles, ControllersDocument, FieldHeldOut, Figure, Judged, Reason, VerdictDocument,
    WrittenFile,
};
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::pose_name::PoseName;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Maximum permissible ratio: the error of a set of parameters at held-out poses over the smallest
/// such error of any set.
pub const LOADING_RATIO: f64 = 1.05;

/// Parameters that a controller should load.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Loading {
    /// Answer.
    pub answer: LoadAnswer,
    /// Best controller file, relative to the output folder; absent unless the answer is `load`, or
    /// if no file for a controller was written.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// Further files with the same errors.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub alternatives: Vec<String>,
    /// `false` for files that programs of a laboratory read, and no controller loads.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub is_for_controllers: Option<bool>,
    /// Errors of the file at the deciding poses; absent unless the answer is `load`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub errors: Option<ControllerErrors>,
    /// Effects to identify first, if the answer is `identify_further`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub effects: Vec<Effect>,
}

/// Answer to the question of which values a controller should load.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LoadAnswer {
    /// Load the identified parameters.
    Load,
    /// Keep the nominal parameters: the identified ones are not clearly better.
    KeepNominal,
    /// Identify further effects first: with them, errors at held-out poses are more than 5 %
    /// smaller.
    IdentifyFurther,
    /// Load nothing yet: the verdict of the run allows no file to be loaded.
    Resolve,
}

/// Pose on the display of a controller at joint values that were measured: before and after a file
/// is loaded.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LoadingCheck {
    /// Measured pose at which the file changes the displayed position most.
    pub pose: PoseName,
    /// Link whose pose is compared, for a robot with several branches.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub link: Option<String>,
    /// Joints, named as columns: `q1_deg`; the assembly mode of a five-bar.
    pub joints: Vec<String>,
    /// Joint values (mm or deg) before loading.
    pub joint_values: Vec<f64>,
    /// Pose with nominal parameters.
    pub before: DisplayedPose,
    /// Pose with the values of the file.
    pub after: DisplayedPose,
    /// Joint values (mm or deg) on the display after loading the file as mastering values, without
    /// motion. Empty if the file changes more than joint zeros.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub mastered_joint_values: Vec<f64>,
    /// Largest difference (mm) between a displayed and an announced position that rounding
    /// explains; absent in output folders of earlier versions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tolerance_mm: Option<f64>,
    /// Pose with the inputs of a reading, if the values of the file depend on inputs in addition to
    /// joint values.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub with_inputs: Option<InputsCheck>,
}

/// Pose with the values of a file and all inputs of a reading: software that ignores the inputs
/// gives another pose.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct InputsCheck {
    /// Measured pose at which the inputs change the position most.
    pub pose: PoseName,
    /// Joint values (mm or deg), in the order of the joints of the check.
    pub joint_values: Vec<f64>,
    /// Inputs, named as columns: `load_kg`, `q2_direction`.
    pub inputs: BTreeMap<String, f64>,
    /// Pose with the values of the file.
    pub after: DisplayedPose,
    /// Distance (mm) from the pose without the inputs.
    pub effect_mm: f64,
}

impl LoadingCheck {
    /// Decimals of announced joint values (mm or deg).
    pub const JOINT_DECIMALS: usize = 3;
    /// Decimals of positions (mm) on the display of a controller.
    pub const DISPLAY_DECIMALS: usize = 2;

    /// Distance (mm) between the positions before and after loading.
    pub fn change_mm(&self) -> f64 {
        norm(minus(self.after.xyz_mm, self.before.xyz_mm))
    }
}

/// Pose of flange, tool link or platform in the base frame of the robot.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DisplayedPose {
    /// Position (mm).
    pub xyz_mm: Vector,
    /// Orientation as a unit quaternion: w, x, y, z.
    pub quaternion: [f64; 4],
}

impl Loading {
    /// Decides for an identified robot; `None` without an identification, or without a measured
    /// error.
    pub fn new(judged: &Judged, campaign: &CampaignSummary, verdict: &VerdictDocument) -> Option<Self> {
        let (accuracy, parameters) = (judged.accuracy?, judged.parameters?);
        let empty = |answer| Self {
            answer,
            file: None,
            alternatives: Vec::new(),
            is_for_controllers: None,
            errors: None,
            effects: Vec::new(),
        };
        let set = accuracy.sets.iter().rfind(|s| s.count > 0)?;
        let whole = ControllerErrors::new(set, None)?;
        if !parameters.is_plausible() {
            return Some(empty(LoadAnswer::Resolve));
        }
        let field_mm = accepted_field(accuracy).map_or(f64::INFINITY, |field| field.with_mm);
        let better: Vec<_> = further_effects(accuracy).filter(|proof| proof.with_mm < field_mm).collect();
        let further =
            Self { effects: better.iter().map(|proof| proof.effect).collect(), ..empty(LoadAnswer::IdentifyFurther) };
        // further effects may show errors that are unknown without them
        let is_blocked = verdict.reasons.iter().any(Reason::blocks_effects);
        if hardly_better(accuracy).is_some() {
            let improves = better.iter().any(|proof| improves_on_nominal(accuracy, proof));
            return Some(if improves && !is_blocked { further } else { empty(LoadAnswer::KeepNominal) });
        }
        let files = better_files(&whole, &campaign.controller_files, judged.controllers);
        if files.is_empty() && !campaign.controller_files.is_empty() {
            return Some(empty(LoadAnswer::KeepNominal));
        }
        if !is_blocked && !further.effects.is_empty() {
            return Some(further);
        }
        if !verdict.passes() {
            return Some(empty(LoadAnswer::Resolve));
        }
        let Some(first) = files.first() else {
            return Some(Self { errors: Some(whole), ..empty(LoadAnswer::Load) });
        };
        Some(Self {
            answer: LoadAnswer::Load,
            file: Some(first.file.file.clone()),
            alternatives: files[1..].iter().map(|other| other.file.file.clone()).collect(),
            is_for_controllers: Some(first.file.is_for_controllers),
            errors: Some(first.errors.clone()),
            effects: Vec::new(),
        })
    }
}

impl Loading {
    /// Reason for loading nothing, without an instruction; `None` if the answer is to load.
    pub fn reason(&self) -> Option<Phrase> {
        let answer = match self.answer {
            LoadAnswer::Load => return None,
            LoadAnswer::KeepNominal => "keep_nominal",
            LoadAnswer::IdentifyFurther => "identify_further",
            LoadAnswer::Resolve => "resolve",
        };
        Some(phrase!("nothing-to-load", answer))
    }

    /// Instruction to load nothing, with its reason; `None` if the answer is to load.
    pub fn withheld(&self) -> Option<Phrase> {
        let effects = || self.effects.iter().map(|effect| effect.phrase()).collect::<Vec<_>>();
        match self.answer {
            LoadAnswer::Load => None,
            LoadAnswer::KeepNominal => Some(phrase!("recommend-nominal")),
            LoadAnswer::IdentifyFurther => Some(phrase!("recommend-further", effects = effects())),
            LoadAnswer::Resolve => Some(phrase!("recommend-resolve")),
        }
    }
}

/// Controller file with its errors at the deciding poses.
#[derive(Clone)]
struct KnownFile<'a> {
    file: &'a WrittenFile,
    errors: ControllerErrors,
    /// Values of the file, if they differ from the identified ones.
    values: Option<&'a ControllerFiles>,
}

/// Controller files whose errors are known.
fn known_files<'a>(
    whole: &ControllerErrors,
    files: &'a [WrittenFile],
    controllers: Option<&'a ControllersDocument>,
) -> Vec<KnownFile<'a>> {
    let known = |file: &'a WrittenFile| {
        let of_format = |c: &&ControllerFiles| c.formats.contains(&file.format);
        let values = controllers.and_then(|c| c.files.iter().find(of_format));
        let errors = values.map_or_else(|| Some(whole.clone()), |c| c.deciding().cloned())?;
        Some(KnownFile { file, errors, values })
    };
    files.iter().filter_map(known).collect()
}

/// Files with the smallest error; files that a controller loads precede files of laboratories.
fn best(mut known: Vec<KnownFile>) -> Vec<KnownFile> {
    let of_controllers = known.iter().any(|k| k.file.is_for_controllers);
    known.retain(|k| k.file.is_for_controllers || !of_controllers);
    let best = known.iter().map(|k| k.errors.written).min_by(|a, b| a.rms_mm.total_cmp(&b.rms_mm));
    known.retain(|k| Some(k.errors.written) == best);
    known
}

/// The best of the controller files that are clearly better than nominal parameters.
fn better_files<'a>(
    whole: &ControllerErrors,
    files: &'a [WrittenFile],
    controllers: Option<&'a ControllersDocument>,
) -> Vec<KnownFile<'a>> {
    let better = |k: &KnownFile| !k.errors.is_hardly_better_than_nominal();
    best(known_files(whole, files, controllers).into_iter().filter(better).collect())
}

/// Controller file that a run judges, with its values: the file to load, or the best one if none is
/// clearly better than nominal parameters. `None` if it contains the identified values.
pub(crate) fn judged_file<'a>(
    accuracy: &AccuracyDocument,
    files: &'a [WrittenFile],
    controllers: Option<&'a ControllersDocument>,
) -> Option<(&'a WrittenFile, &'a ControllerFiles)> {
    let set = accuracy.sets.iter().rfind(|s| s.count > 0)?;
    let whole = ControllerErrors::new(set, None)?;
    let better = better_files(&whole, files, controllers);
    let all = if better.is_empty() { best(known_files(&whole, files, controllers)) } else { better };
    let first = all.first()?;
    // output folders of earlier versions do not contain the errors of all quantities
    Some((first.file, first.values.filter(|values| values.deciding_set.is_some())?))
}

/// Errors at held-out poses of a residual field that corrects programs, if it is more than 5 %
/// better than the parameters alone.
pub(crate) fn accepted_field(accuracy: &AccuracyDocument) -> Option<&FieldHeldOut> {
    let found = accuracy.field.as_ref().filter(|field| field.accepted)?.held_out.as_ref();
    found.filter(|field| field.without_mm > LOADING_RATIO * field.with_mm)
}

/// Effects that are not identified, and without which errors at held-out poses are more than 5 %
/// larger.
pub(crate) fn further_effects(accuracy: &AccuracyDocument) -> impl Iterator<Item = &EffectProof> {
    accuracy.effects.iter().filter(|e| !e.is_identified && e.without_mm > LOADING_RATIO * e.with_mm)
}

/// `true` if errors at held-out poses are more than 5 % smaller with a further effect than with
/// nominal parameters.
fn improves_on_nominal(accuracy: &AccuracyDocument, proof: &EffectProof) -> bool {
    accuracy.left_out.as_ref().is_some_and(|left_out| left_out.nominal.rms > LOADING_RATIO * proof.with_mm)
}

/// Errors with nominal and with all identified parameters, if the identified ones are not clearly
/// better at the deciding poses or at held-out poses: the improvement must exceed the uncertainty
/// of the error.
pub(crate) fn hardly_better(accuracy: &AccuracyDocument) -> Option<[PositionErrors; 2]> {
    let set = accuracy.sets.last()?;
    let leading = set.leading()?;
    let errors = ControllerErrors::new(set, None)?;
    let figure = |b: &&FigureBudget| b.quantity == leading.quantity && b.figure == Figure::Rms;
    let u_mm = accuracy.budget.iter().find(figure).map_or(0.0, |b| b.standard_uncertainty_mm);
    let ControllerErrors { nominal, written, .. } = errors;
    if errors.is_hardly_better_than_nominal() || nominal.rms_mm - written.rms_mm <= 2.0 * u_mm {
        return Some([nominal, written]);
    }
    let left_out = accuracy.left_out.as_ref()?;
    let [nominal, identified] = [&left_out.nominal, &left_out.identified].map(PositionErrors::from);
    (nominal.rms_mm < LOADING_RATIO * identified.rms_mm).then_some([nominal, identified])
}

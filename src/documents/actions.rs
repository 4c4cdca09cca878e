//! Next steps for the person who loads or repeats a calibration, each with its reason, from the
//! documents of a campaign.

use crate::loading::accepted_field;
use crate::worded::worded;
use crate::{
    AccuracyDocument, CampaignSummary, Effect, EffectProof, ErrorQuantity, FieldDocument, Figure, FileInput, Judged,
    LOADING_RATIO, LimitQuantity, LimitVerdict, LoadAnswer, Loading, LoadingCheck, PointError, PoseSet, PositionErrors,
    ReadingQuantity, Reason, UncertaintySource, VerdictDocument,
};
use etalon_base::catalogue::Phrase;
use etalon_base::message::{AnsweredBy, Message, Rank, Severity};
use etalon_base::phrase;
use etalon_base::pose::norm;
use etalon_base::pose_name::PoseName;
use etalon_base::worded::Worded;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// Maximum number of actions.
pub const MOST: usize = 5;
/// Maximum number of poses in one action.
const POSES: usize = 5;
/// Maximum share of the calibration poses that are measured again.
const MOST_AGAIN: f64 = 0.1;
/// Maximum number of readings, in multiples of the present ones, that is advised for a decision.
const MOST_REPEATS: f64 = 25.0;

/// Next step with its reason.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Action {
    /// Kind of the step.
    pub action: ActionKind,
    /// Instruction, in English.
    #[serde(flatten, with = "ActionWhat")]
    pub what: Worded,
    /// Reason, in English.
    #[serde(flatten, with = "ActionReason")]
    pub reason: Worded,
    /// Warning whose hint is the instruction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub message: Option<Box<Message>>,
    /// File to load, or to change, relative to the output folder or the folder of the campaign.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// Lines to add to `file`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub line: Option<String>,
    /// Command to run in the folder of the campaign.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub command: Option<String>,
    /// Expected decrease of the error (mm), which determines the order of actions; absent if
    /// unknown.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gain_mm: Option<f64>,
}

worded! {
    /// Instruction, in English.
    text ActionWhat: what,
    /// Text of the catalogue that is `what` in English; absent if `message` has the text.
    what_phrase
}

worded! {
    /// Reason, in English.
    text ActionReason: reason,
    /// Text of the catalogue that is `reason` in English; absent if `message` has the text.
    reason_phrase
}

/// Kind of a next step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ActionKind {
    /// Load a controller file.
    Load,
    /// Correct programs by the residual field, in addition to the loaded parameters.
    Compensate,
    /// Compare a few poses with the loaded parameters, and go back if they contradict. If
    /// nothing is to be loaded: run again, and restore what was loaded before.
    Verify,
    /// Keep the nominal parameters: a controller file is hardly better than nominal.
    KeepNominal,
    /// Measure poses again that disagree with the others.
    MeasureAgain,
    /// Identify a further effect of the robot.
    AddEffect,
    /// Find the cause of errors beyond a limit.
    MeetLimit,
    /// Warm the robot up before the test.
    WarmUp,
    /// Measure with a smaller uncertainty.
    ReduceUncertainty,
    /// Measure the quantity of a limit.
    MeasureQuantity,
    /// Visit poses more often.
    AddCycles,
    /// Measure poses that validate the parameters.
    AddValidation,
    /// Decide on a warning.
    Resolve,
    /// State limits.
    StateLimits,
}

/// Controller file that a run wrote.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WrittenFile {
    /// Name of the format.
    pub format: String,
    /// Name of the file in the output folder.
    pub file: String,
    /// `false` for a file that programs of a laboratory read, and no controller loads.
    #[serde(default = "is_loaded")]
    pub is_for_controllers: bool,
    /// SHA-256 of the file; absent in output folders of earlier versions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sha256: Option<String>,
    /// Effects that the format cannot contain; absent in output folders of earlier versions.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub omitted_effects: Vec<Effect>,
    /// Inputs in addition to joint values, on which effects in the file depend; empty if joint
    /// values determine them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub inputs: Vec<FileInput>,
    /// Pose on the display of the controller, before and after loading; absent in output folders of
    /// earlier versions, and for robots without kinematics of a whole pose.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub check: Option<LoadingCheck>,
}

/// Files of output folders that do not give it were said to be for controllers.
fn is_loaded() -> bool {
    true
}

/// Documents from which actions are derived.
#[derive(Clone)]
pub struct Evidence<'a> {
    /// Documents that are judged.
    pub judged: Judged<'a>,
    /// Data of the campaign.
    pub campaign: &'a CampaignSummary,
    /// Errors of single points.
    pub errors: &'a [PointError],
}

impl Action {
    fn new(action: ActionKind, what: Phrase, reason: Phrase) -> Self {
        Self {
            action,
            what: what.into(),
            reason: reason.into(),
            message: None,
            file: None,
            line: None,
            command: None,
            gain_mm: None,
        }
    }

    fn file(self, file: impl Into<String>) -> Self {
        Self { file: Some(file.into()), ..self }
    }

    fn line(self, line: impl Into<String>) -> Self {
        Self { line: Some(line.into()), ..self }
    }

    fn command(self, command: impl Into<String>) -> Self {
        Self { command: Some(command.into()), ..self }
    }

    fn gain(self, gain_mm: Option<f64>) -> Self {
        Self { gain_mm: gain_mm.filter(|g| g.is_finite() && *g > 0.0), ..self }
    }
}

/// Length with three significant digits, in µm below 0.1 mm.
fn length(mm: f64) -> String {
    let [text] = lengths([mm]);
    text
}

/// Lengths that are compared, in one unit: µm if the smallest is below 0.1 mm and the largest below
/// 1 mm.
fn lengths<const N: usize>(mm: [f64; N]) -> [String; N] {
    let (smallest, largest) = mm.iter().fold((f64::INFINITY, 0.0f64), |(a, b), v| (a.min(v.abs()), b.max(v.abs())));
    let (factor, unit) = if smallest < 0.1 && largest < 1.0 { (1e3, "µm") } else { (1.0, "mm") };
    mm.map(|v| {
        let value = factor * v;
        let before = if value.abs() > 0.0 { value.abs().log10().floor() as i32 } else { -1 };
        format!("{value:.*} {unit}", (2 - before).clamp(0, 5) as usize)
    })
}

fn listed(poses: &[PoseName]) -> String {
    poses.iter().take(POSES).map(PoseName::to_string).collect::<Vec<_>>().join(", ")
}

/// Values of a limit in its unit.
fn in_unit(value: f64, limit: &LimitVerdict) -> String {
    if limit.unit == "mm" { length(value) } else { format!("{value:.4} {}", limit.unit) }
}

impl Evidence<'_> {
    /// Verdict with the next steps.
    pub fn verdict(&self) -> VerdictDocument {
        let verdict = self.judged.verdict();
        let loading = Loading::new(&self.judged, self.campaign, &verdict);
        let verdict = VerdictDocument { loading, ..verdict };
        VerdictDocument { actions: self.actions(&verdict), ..verdict }
    }

    /// Next steps: missing limits, then the steps with the largest gain.
    fn actions(&self, verdict: &VerdictDocument) -> Vec<Action> {
        let loading = verdict.loading.as_ref();
        let mut all: Vec<Action> = loading.and_then(|l| self.load(l)).into_iter().chain(self.measure_again()).collect();
        all.extend(loading.and_then(|loading| self.compensate(loading)));
        let effects = self.judged.accuracy.into_iter().flat_map(|a| &a.effects);
        let is_first = loading.is_some_and(|loading| loading.answer == LoadAnswer::IdentifyFurther);
        all.extend(effects.filter(|e| !e.is_identified).map(|proof| self.add_effect(proof, is_first)));
        all.extend(verdict.reasons.iter().filter_map(|reason| self.remedy(reason, verdict)));
        all.extend(self.add_validation(&verdict.reasons));
        all.extend(self.judged.messages.iter().filter_map(|m| resolve(m)));
        let judges = self.judged.accuracy.is_some() || self.judged.tested.poses.is_some();
        if verdict.limits.is_empty() && judges {
            let what = phrase!("action-state-limits");
            let reason = match verdict.verdict {
                Some(_) => phrase!("action-state-limits-to-accept"),
                None => phrase!("action-state-limits-reason"),
            };
            let action = Action::new(ActionKind::StateLimits, what, reason);
            all.push(action.file("campaign.toml"));
        }
        // stable: steps without a known gain keep the order of the verdict
        all.sort_by(|a, b| b.gain_mm.unwrap_or(0.0).total_cmp(&a.gain_mm.unwrap_or(0.0)));
        // an implausible result comes first, then readings that decide the file to load; without
        // limits nothing decides whether a file may be loaded
        all.sort_by_key(|action| match (&action.message, action.action) {
            (Some(message), _) if message.severity == Severity::Error => 0,
            (_, ActionKind::MeasureAgain) if self.readings_decide() => 1,
            (_, ActionKind::StateLimits) => 2,
            _ => 3,
        });
        // the step that closes the loop follows what changes the robot
        let changes = |action: &Action| matches!(action.action, ActionKind::Load | ActionKind::Compensate);
        match all.iter().rposition(changes) {
            Some(last) => all.insert(last + 1, self.verify(loading)),
            None if loading.is_some_and(|loading| loading.answer != LoadAnswer::Load) => {
                all.truncate(MOST - 1);
                all.push(self.run_again());
            }
            None => {}
        }
        all.truncate(MOST);
        all
    }

    /// The controller file to load.
    fn load(&self, loading: &Loading) -> Option<Action> {
        let set = self.judged.accuracy?.sets.iter().rfind(|s| s.count > 0)?;
        let (file, errors) = (loading.file.as_deref()?, loading.errors.as_ref()?);
        let (count, others) = (loading.alternatives.len(), loading.alternatives.join(", "));
        let leading = set.leading()?;
        let [poses, _] = set.counts(leading);
        let is_read = loading.is_for_controllers == Some(true);
        let what = match (self.campaign.measurements.synthetic.is_some(), is_read) {
            (true, true) => phrase!("action-load-synthetic", file, count, others),
            (true, false) => phrase!("action-load-synthetic-software", file, count, others),
            (false, true) => phrase!("action-load", file, count, others),
            (false, false) => phrase!("action-load-or-compensate", file, count, others),
        };
        let what = match self.inputs(file) {
            inputs if inputs.is_empty() => what,
            inputs => phrase!("action-load-with-inputs", action = what, inputs),
        };
        // errors at calibration poses are smaller than at other poses
        let held_out = self.judged.accuracy?.left_out.as_ref().filter(|_| {
            let is_whole = errors.written == PositionErrors::from(&leading.after);
            set.name == PoseSet::Calibration && leading.quantity == ErrorQuantity::Position && is_whole
        });
        let (count, set, rms_mm) = match held_out {
            Some(found) => (found.poses, "held-out", [found.identified.rms, found.nominal.rms]),
            None => (poses, set.name.name(), [errors.written.rms_mm, errors.nominal.rms_mm]),
        };
        let ([expected, nominal], quantity) = (lengths(rms_mm), leading.quantity.phrase());
        let reason = phrase!("action-load-reason", expected, nominal, quantity, count, set);
        Some(Action::new(ActionKind::Load, what, reason).file(file).gain(Some(rms_mm[1] - rms_mm[0])))
    }

    /// Inputs of a controller file in addition to joint values, each quantity once.
    fn inputs(&self, file: &str) -> Vec<Phrase> {
        let written = self.campaign.controller_files.iter().filter(|written| written.file == file);
        let mut quantities: Vec<_> = written.flat_map(|written| &written.inputs).map(|i| i.quantity).collect();
        quantities.dedup();
        let named = |q: ReadingQuantity| phrase!("reading-in-unit", quantity = q.phrase(), unit = q.unit());
        quantities.into_iter().map(named).collect()
    }

    /// Correction of programs by the residual field, in addition to the loaded parameters.
    fn compensate(&self, loading: &Loading) -> Option<Action> {
        let accuracy = self.judged.accuracy?;
        let field = accepted_field(accuracy)?;
        let nominal_mm = accuracy.left_out.as_ref().map_or(field.without_mm, |left_out| left_out.nominal.rms);
        match loading.answer {
            LoadAnswer::Load => {}
            // programs may be corrected although no file is worth loading
            LoadAnswer::KeepNominal if nominal_mm > LOADING_RATIO * field.with_mm => {}
            _ => return None,
        }
        let [without, with] = lengths([field.without_mm, field.with_mm]);
        let what = phrase!("action-compensate", file = FieldDocument::NAME);
        let reason = phrase!("action-compensate-reason", without, with, count = field.poses.len());
        let action = Action::new(ActionKind::Compensate, what, reason).file(FieldDocument::NAME);
        Some(action.gain(Some(field.without_mm - field.with_mm)))
    }

    /// Calibration poses that a robust fit finds to disagree with the others. If they are many, the
    /// model is incomplete, and further measurements of these poses do not help.
    fn measure_again(&self) -> Option<Action> {
        let robust = self.judged.parameters?.robust.as_ref()?;
        let calibration = self.errors.iter().filter(|e| e.set == PoseSet::Calibration);
        let all: BTreeSet<PoseName> = calibration.map(|e| e.pose).collect();
        if robust.disagreeing as f64 > (MOST_AGAIN * all.len() as f64).max(1.0) {
            return None;
        }
        let mut poses: Vec<_> =
            robust.poses.iter().filter(|p| p.residual_over_sigma > robust.critical_residual).collect();
        poses.sort_by(|a, b| b.residual_over_sigma.total_cmp(&a.residual_over_sigma));
        let worst = poses.first()?;
        let names: Vec<PoseName> = poses.iter().map(|p| p.pose).collect();
        // a fit names its worst poses only
        let more = robust.disagreeing.max(names.len()) - names.len().min(POSES);
        // the error of this pose in the table of errors
        let after = self.errors.iter().filter(|e| e.set == PoseSet::Calibration && e.pose == worst.pose);
        let largest = after.map(|e| norm(e.after_mm)).max_by(f64::total_cmp);
        let error_mm = largest.unwrap_or(worst.residual_over_sigma * robust.sigma_mm);
        let what = phrase!("action-measure-again", count = names.len().min(POSES), poses = listed(&names), more);
        let reason = phrase!(
            "action-measure-again-reason",
            pose = worst.pose,
            error = length(error_mm),
            times = format!("{:.1}", worst.residual_over_sigma)
        );
        Some(Action::new(ActionKind::MeasureAgain, what, reason).gain(self.without(&names)))
    }

    /// `true` if a fit with small weights of outliers has significantly different parameters.
    fn readings_decide(&self) -> bool {
        let robust = self.judged.parameters.and_then(|parameters| parameters.robust.as_ref());
        robust.is_some_and(|robust| robust.parameters.iter().any(|p| p.difference_over_u.abs() > robust.critical))
    }

    /// Decrease of the root mean square error of the calibration if these poses are omitted.
    fn without(&self, poses: &[PoseName]) -> Option<f64> {
        let all = self.errors.iter().filter(|e| e.set == PoseSet::Calibration);
        let rms = |sizes: Vec<f64>| (sizes.iter().map(|s| s * s).sum::<f64>() / sizes.len() as f64).sqrt();
        let size = |e: &PointError| norm(e.after_mm);
        let kept = rms(all.clone().filter(|e| !poses.contains(&e.pose)).map(size).collect());
        Some(rms(all.map(size).collect()) - kept).filter(|gain| gain.is_finite())
    }

    /// Step that removes a reason of the verdict.
    fn remedy(&self, reason: &Reason, verdict: &VerdictDocument) -> Option<Action> {
        let limit = |name: &LimitQuantity| verdict.limits.iter().find(|l| l.name == *name);
        match reason {
            Reason::LimitNotMet { limit: name } => {
                let limit = limit(name)?;
                self.use_all_parameters(limit).or_else(|| self.search_cause(limit))
            }
            Reason::LimitUndecided { limit: name } => {
                let limit = limit(name)?;
                self.use_all_parameters(limit).or_else(|| self.decide(limit))
            }
            Reason::NotAssessable { limit: name } => {
                let what = phrase!("action-measure-quantity", limit = name.to_string());
                let reason = phrase!("action-measure-quantity-reason");
                Some(Action::new(ActionKind::MeasureQuantity, what, reason).file("campaign.toml"))
            }
            Reason::InstrumentTooCoarse { poses } => self.finer_instrument(poses),
            // the drift of a cold robot has one remedy
            Reason::NoWarmUp if !verdict.reasons.iter().any(|r| matches!(r, Reason::DriftNotSettled { .. })) => {
                let (what, reason) = (phrase!("action-warm-up"), phrase!("action-warm-up-cold"));
                Some(Action::new(ActionKind::WarmUp, what, reason))
            }
            Reason::DriftNotSettled { .. } => {
                let drifts = self.judged.tested.poses.as_ref()?.drifts.iter().filter(|d| d.is_unsettled());
                let largest = drifts.max_by(|a, b| a.dap_mm.total_cmp(&b.dap_mm))?;
                let (pose, change, sets) = (largest.pose, length(largest.dap_mm), largest.ap_mm.len());
                let reason = phrase!("action-warm-up-drift", pose, change, sets);
                Some(Action::new(ActionKind::WarmUp, phrase!("action-warm-up"), reason).gain(Some(largest.dap_mm)))
            }
            Reason::FewCycles { poses, required } => {
                let what = phrase!("action-add-cycles", count = poses.len(), poses = listed(poses), required);
                let least = self.judged.tested.poses.as_ref()?.poses.iter().map(|p| p.cycles).min()?;
                Some(Action::new(ActionKind::AddCycles, what, phrase!("action-add-cycles-reason", least)))
            }
            Reason::HardlyBetter { formats, nominal, written } => {
                let what = phrase!("action-keep-nominal", count = formats.len(), formats = formats.join(", "));
                let compared = [written.rms_mm, written.max_mm, nominal.rms_mm, nominal.max_mm];
                let [rms, max, nominal_rms, nominal_max] = lengths(compared);
                let reason = phrase!("action-keep-nominal-reason", rms, max, nominal_rms, nominal_max);
                Some(Action::new(ActionKind::KeepNominal, what, reason).command("etalon recommend ."))
            }
            _ => None,
        }
    }

    /// Search for the cause of errors beyond a limit, which begins at the worst pose.
    fn search_cause(&self, limit: &LimitVerdict) -> Option<Action> {
        let (value, beyond) = (limit.value?, limit.value? - limit.limit);
        let worst = limit.name.limited_error().and_then(|(quantity, _)| {
            let deciding = self.judged.accuracy?.sets.iter().rfind(|s| s.count > 0)?.name;
            let all = self.errors.iter().filter(|e| e.set == deciding && e.quantity == quantity);
            all.max_by(|a, b| norm(a.after_mm).total_cmp(&norm(b.after_mm)))
        });
        let name = limit.name.phrase();
        let what = match worst {
            Some(worst) => phrase!("action-meet-limit-at-pose", limit = name, pose = worst.pose),
            None => phrase!("action-meet-limit", limit = name),
        };
        let reason = phrase!(
            "action-meet-limit-reason",
            value = in_unit(value, limit),
            limit = in_unit(limit.limit, limit),
            beyond = in_unit(beyond, limit)
        );
        let action = Action::new(ActionKind::MeetLimit, what, reason);
        // parameters of effects are chosen at poses that are excluded
        Some(if self.judged.parameters.is_some() { action.command("etalon recommend .") } else { action })
    }

    /// Another way to the controller than the file to load, if a limit is met with all identified
    /// parameters and not with the values of this file.
    fn use_all_parameters(&self, limit: &LimitVerdict) -> Option<Action> {
        self.judged.loaded?;
        let met = self.judged.accuracy?.limits.iter().find(|l| l.name == limit.name && l.acceptance.is_accepted())?;
        let compared = [limit.value?, met.value?, limit.limit];
        let what = phrase!("action-use-all-parameters", limit = limit.name.phrase());
        let [value, whole, limit] = match limit.unit.as_str() {
            "mm" => lengths(compared),
            _ => compared.map(|v| in_unit(v, limit)),
        };
        let reason = phrase!("action-use-all-parameters-reason", value, whole, limit);
        Some(Action::new(ActionKind::MeetLimit, what, reason))
    }

    /// Uncertainty at which a limit can be decided, and its largest source; a decision rule, if so
    /// small an uncertainty is out of reach.
    fn decide(&self, limit: &LimitVerdict) -> Option<Action> {
        let (value, u) = (limit.value?, limit.expanded_uncertainty?);
        let enough = (limit.limit - value).abs();
        let (present, required) = (in_unit(u, limit), in_unit(enough, limit));
        let times = (u / enough).powi(2);
        if times > MOST_REPEATS {
            let what = phrase!("action-agree-rule", limit = limit.name.phrase());
            let times = format!("{times:.0}");
            let reason = phrase!("action-agree-rule-reason", present, required, times);
            return Some(Action::new(ActionKind::ReduceUncertainty, what, reason).file("campaign.toml"));
        }
        let what = phrase!("action-reduce-uncertainty", limit = limit.name.phrase());
        let source = limit
            .name
            .limited_error()
            .and_then(|(quantity, figure)| largest_source(self.judged.accuracy?, quantity, figure));
        let reason = match source {
            Some((source, share)) => phrase!(
                "action-reduce-uncertainty-by-source",
                present,
                required,
                source = source.phrase(),
                percent = format!("{:.0}", 100.0 * share)
            ),
            None => phrase!("action-reduce-uncertainty-reason", present, required),
        };
        Some(Action::new(ActionKind::ReduceUncertainty, what, reason))
    }

    /// Uncertainty of the instrument that the 25 % rule requires (ISO 9283:1998, 6).
    fn finer_instrument(&self, coarse: &[PoseName]) -> Option<Action> {
        let poses = self.judged.tested.poses.as_ref()?.poses.iter().filter(|p| coarse.contains(&p.pose));
        // U over the characteristic, with U and the pose
        let ratios = poses.flat_map(|p| {
            let expanded_mm = p.expanded_uncertainty_mm();
            [p.uncertainty_over_rp, p.uncertainty_over_ap].map(|ratio| Some((ratio?, expanded_mm?, p.pose)))
        });
        let known = ratios.flatten().filter(|r| r.0 > 0.25);
        let (ratio, expanded_mm, pose) = known.max_by(|a, b| a.0.total_cmp(&b.0))?;
        let what = phrase!("action-finer-instrument", uncertainty = length(0.25 * expanded_mm / ratio));
        let reason = phrase!(
            "action-finer-instrument-reason",
            pose,
            count = coarse.len(),
            poses = listed(coarse),
            uncertainty = length(expanded_mm),
            percent = format!("{:.0}", 100.0 * ratio)
        );
        Some(Action::new(ActionKind::ReduceUncertainty, what, reason))
    }

    /// Effect that improves the errors at poses that are excluded from the identification; if it
    /// `is_first`, nothing is loaded without it. If no controller file can contain it, programs are
    /// corrected.
    fn add_effect(&self, proof: &EffectProof, is_first: bool) -> Action {
        let [without, with] = lengths([proof.without_mm, proof.with_mm]);
        // output folders of earlier versions do not contain the line
        let of_campaign = || proof.campaign_line.clone().unwrap_or_else(|| "effects = \"proven\"".to_owned());
        let (file, line) = match &proof.robot_key {
            Some(key) => ("robot.toml", key.clone()),
            None => ("campaign.toml", of_campaign()),
        };
        let what = match (&proof.robot_key, is_first) {
            (Some(key), false) => phrase!("action-add-effect", line = key),
            (Some(key), true) => phrase!("action-add-effect-first", line = key),
            (None, false) => phrase!("action-prove-effects", line = line.clone()),
            (None, true) => phrase!("action-prove-effects-first", line = line.clone()),
        };
        let reason = match self.is_omitted(proof.effect) {
            true => phrase!("action-add-effect-not-in-file", without, with, effect = proof.effect.phrase()),
            false => phrase!("action-add-effect-reason", without, with),
        };
        let gain = Some(proof.without_mm - proof.with_mm);
        Action::new(ActionKind::AddEffect, what, reason).file(file).line(line).gain(gain)
    }

    /// `true` if no file for a controller can contain an effect; without such files, no other file.
    fn is_omitted(&self, effect: Effect) -> bool {
        let files = &self.campaign.controller_files;
        let is_of_controllers = files.iter().any(|file| file.is_for_controllers);
        let mut loaded = files.iter().filter(|file| file.is_for_controllers == is_of_controllers).peekable();
        loaded.peek().is_some() && loaded.all(|file| file.omitted_effects.contains(&effect))
    }

    /// Test of the loaded file at a pose, and the way back.
    fn verify(&self, loading: Option<&Loading>) -> Action {
        let name = loading.and_then(|loading| loading.file.as_ref());
        let file = name.and_then(|name| self.campaign.controller_files.iter().find(|file| file.file == *name));
        let check = file.and_then(|file| file.check.as_ref());
        let links = self.judged.parameters.and_then(|parameters| parameters.links.as_ref());
        let is_displayed = !links.is_some_and(|links| links.base_moves);
        let what = match check {
            Some(check) if is_displayed && file.is_some_and(|file| file.is_for_controllers) => {
                phrase!("action-verify-at-pose", pose = check.pose)
            }
            Some(check) => phrase!("action-verify-software-at-pose", pose = check.pose),
            None => phrase!("action-verify"),
        };
        let backup = self.campaign.conditions.robot.controller_backup.as_deref();
        let (count, file) = (usize::from(backup.is_some()), backup.unwrap_or_default());
        let reason = match check {
            Some(check) => {
                phrase!("action-verify-moved", change = length(check.change_mm()), pose = check.pose, count, file)
            }
            None if count == 1 => phrase!("action-verify-backup", file),
            None => phrase!("action-verify-reason"),
        };
        Action::new(ActionKind::Verify, what, reason)
    }

    /// The next run, if nothing is loaded, and the way back for values that are loaded already.
    fn run_again(&self) -> Action {
        let reason = match &self.campaign.conditions.robot.controller_backup {
            Some(backup) => phrase!("action-run-again-backup", file = backup),
            None => phrase!("action-run-again-reason"),
        };
        Action::new(ActionKind::Verify, phrase!("action-run-again"), reason)
    }

    /// Validation, without which errors are too small or, for one of the `reasons`, unknown.
    fn add_validation(&self, reasons: &[Reason]) -> Option<Action> {
        let sets = &self.judged.accuracy.filter(|a| a.given.is_none())?.sets;
        let counted = |name| sets.iter().any(|s| s.name == name && s.count > 0);
        (counted(PoseSet::Calibration) && !counted(PoseSet::Validation)).then(|| {
            let unknown = reasons.iter().find_map(|reason| match reason {
                Reason::ErrorsUnknown { calibration_mm, left_out_mm } => Some(lengths([*calibration_mm, *left_out_mm])),
                _ => None,
            });
            let reason = match unknown {
                Some([calibration, left_out]) => phrase!("action-add-validation-unknown", calibration, left_out),
                None => phrase!("action-add-validation-reason"),
            };
            let what = phrase!("action-add-validation");
            Action::new(ActionKind::AddValidation, what, reason).file("campaign.toml")
        })
    }
}

/// Source with the largest share of the variance of a figure.
fn largest_source(
    accuracy: &AccuracyDocument,
    quantity: crate::ErrorQuantity,
    figure: Figure,
) -> Option<(UncertaintySource, f64)> {
    let budget = accuracy.budget.iter().find(|b| b.quantity == quantity && b.figure == figure)?;
    let square = |u: f64| u * u;
    let whole: f64 = budget.contributions.iter().map(|c| square(c.standard_uncertainty_mm)).sum();
    let of = |c: &crate::FigureContribution| (c.source, square(c.standard_uncertainty_mm) / whole);
    budget.contributions.iter().map(of).filter(|(_, s)| s.is_finite()).max_by(|a, b| a.1.total_cmp(&b.1))
}

/// Warning on which somebody has to decide.
fn resolve(message: &Message) -> Option<Action> {
    if message.rank != Rank::Decide || message.id.is_empty() || message.answered_by == AnsweredBy::NextStep {
        return None;
    }
    let what = message.hint.clone().map_or_else(|| phrase!("action-resolve").into(), Worded::from);
    Some(Action {
        action: ActionKind::Resolve,
        what,
        reason: message.what.clone().into(),
        message: Some(Box::new(message.clone())),
        file: message.place.as_ref().map(|p| p.file.clone()),
        line: None,
        command: Some(format!("etalon explain {}", message.id)),
        gain_mm: None,
    })
}

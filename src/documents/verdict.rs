//! Verdict on everything that a report judges, with its reasons.

use crate::loading::hardly_better;
use crate::{
    Acceptance, AccuracyDocument, AccuracySet, Action, Characteristics, Conditions, Conformity, ControllerErrors,
    ControllerFiles, ControllersDocument, ErrorQuantity, Iso9283Document, LeftOutErrors, LimitQuantity, LimitVerdict,
    Loading, ParametersDocument, PoseCharacteristic, PoseSet, PositionErrors, UntestedMistake,
};
use etalon_base::message::Message;
use etalon_base::pose_name::PoseName;
use etalon_standards::iso9283::pose::CYCLES;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// `verdict.json`: verdict of a run, with its reasons.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VerdictDocument {
    /// Schema and version: `etalon/verdict/1`.
    pub schema: String,
    /// Verdict; null if nothing was judged, because no limit is given.
    pub verdict: Option<Acceptance>,
    /// Exit code of the run: 0 if the answer may be loaded, otherwise 1.
    pub exit_code: u8,
    /// Reasons why the verdict is not `pass`, the worst first. Without limits: reservations about
    /// the results.
    pub reasons: Vec<Reason>,
    /// All limits with their verdicts.
    pub limits: Vec<LimitVerdict>,
    /// Controller file with whose values the limits of errors are judged; absent if its values are
    /// the identified ones, or if no file is written.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub judged_file: Option<String>,
    /// Answer to the question of which values a controller should load; absent without identified
    /// parameters.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loading: Option<Loading>,
    /// Next steps, at most five: missing limits, then the steps with the largest gain.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub actions: Vec<Action>,
}

/// Reason why a verdict is not `pass`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "reason", rename_all = "snake_case", deny_unknown_fields)]
pub enum Reason {
    /// The solver did not converge.
    NotConverged,
    /// The identified parameters cannot belong to the robot.
    Implausible,
    /// The given parameters are worse than nominal ones, or belong to another robot.
    GivenRefused,
    /// A controller file was not written.
    FileRefused,
    /// A limit is not met.
    LimitNotMet {
        /// Limit.
        #[schemars(with = "String")]
        limit: LimitQuantity,
    },
    /// Poses do not conform.
    PosesNotConforming {
        /// Poses.
        poses: Vec<PoseName>,
    },
    /// A limit is within the uncertainty of its value.
    LimitUndecided {
        /// Limit.
        #[schemars(with = "String")]
        limit: LimitQuantity,
    },
    /// Poses are undecided.
    PosesUndecided {
        /// Poses.
        poses: Vec<PoseName>,
    },
    /// The quantity of a limit was not measured.
    NotAssessable {
        /// Limit.
        #[schemars(with = "String")]
        limit: LimitQuantity,
    },
    /// A value was accepted although its limit is within the guard band.
    WithinGuardBand {
        /// Limit.
        #[schemars(with = "String")]
        limit: LimitQuantity,
        /// Risk of a false acceptance (JCGM 106:2012, 9.3.2); absent if the uncertainty is unknown.
        risk: Option<f64>,
    },
    /// The uncertainty of the instrument exceeds 25 % of a characteristic (ISO 9283, clause 6).
    InstrumentTooCoarse {
        /// Poses.
        poses: Vec<PoseName>,
    },
    /// The robot was tested cold (ISO 9283, clause 6).
    NoWarmUp,
    /// The accuracy drifted during the test, and has not settled (ISO 9283, 7.6).
    DriftNotSettled {
        /// Poses.
        poses: Vec<PoseName>,
        /// Largest change of AP (mm).
        dap_mm: f64,
    },
    /// Poses were visited in fewer cycles than the standard requires (ISO 9283, 7.2).
    FewCycles {
        /// Poses.
        poses: Vec<PoseName>,
        /// Required number of cycles.
        required: usize,
    },
    /// Warnings question the data, and nobody has resolved them.
    OpenWarnings {
        /// Ids of the warnings.
        ids: Vec<String>,
    },
    /// Residuals of the calibration are several times the uncertainty of the instrument: the model
    /// is incomplete, or readings or joint values are wrong.
    ModelDoesNotFit {
        /// Residuals over the standard uncertainty of the instrument.
        times: f64,
        /// Poses whose errors apply; absent in output folders of earlier versions.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schemars(with = "Option<String>")]
        set: Option<PoseSet>,
    },
    /// Calibration poses decide and do not show the errors at other poses: the model does not fit,
    /// and its parameters absorb errors of the model; or errors at calibration poses that were
    /// excluded from the identification are beyond a limit.
    ErrorsUnknown {
        /// Root mean square of the position error at calibration poses (mm).
        calibration_mm: f64,
        /// Root mean square of the position error at excluded calibration poses (mm).
        left_out_mm: f64,
    },
    /// The measurements cannot show some mistakes of the set-up: with one of them, the tool is
    /// beyond a limit.
    SetUpUntested {
        /// Number of mistakes.
        count: usize,
        /// Largest change of the position of the flange (mm).
        flange_mm: f64,
        /// Largest change of the orientation of the flange (deg).
        flange_deg: f64,
    },
    /// A controller file is hardly better than nominal parameters: at the deciding poses or at
    /// excluded calibration poses, its largest error is larger, or its root mean square decreases
    /// by less than 5 % or by less than its uncertainty.
    HardlyBetter {
        /// Formats of the file; empty for files with all identified parameters.
        formats: Vec<String>,
        /// Errors with nominal parameters.
        nominal: PositionErrors,
        /// Errors with the values of the file.
        written: PositionErrors,
    },
}

/// Residuals over the uncertainty of the instrument beyond which the model does not fit. Models of
/// real robots omit friction, temperature and the compliance of links, and exceed it if the
/// instrument is accurate. Their errors at validation poses are true nevertheless.
const MISFIT: f64 = 3.0;

/// Ratio of the errors at excluded poses to the errors at calibration poses, over the same ratio of
/// nominal parameters, beyond which parameters of the robot absorb errors of the model. Base and
/// targets, which both fits contain, cancel. A correct model with n parameters from N coordinates
/// has the ratio √((1 + n/N) / (1 − n/N)) (Seber & Lee, Linear Regression Analysis).
const ABSORBED: f64 = 1.5;

/// Documents that are judged together.
#[derive(Clone, Copy)]
pub struct Judged<'a> {
    /// Parameters that were identified.
    pub parameters: Option<&'a ParametersDocument>,
    /// Errors of identified or given parameters.
    pub accuracy: Option<&'a AccuracyDocument>,
    /// Characteristics of ISO 9283.
    pub tested: &'a Characteristics,
    /// Controller files.
    pub controllers: Option<&'a ControllersDocument>,
    /// Values of the controller file to load, if they differ from the identified ones.
    pub loaded: Option<&'a ControllerFiles>,
    /// Given conditions of the measurements.
    pub conditions: Option<&'a Conditions>,
    /// Messages of all documents.
    pub messages: &'a [&'a Message],
}

/// Set of poses whose errors decide.
fn deciding_set(accuracy: &AccuracyDocument) -> Option<&AccuracySet> {
    accuracy.sets.iter().rfind(|set| set.count > 0)
}

impl Reason {
    /// Verdict that the reason alone gives.
    pub fn acceptance(&self) -> Acceptance {
        match self {
            Self::NotConverged
            | Self::Implausible
            | Self::GivenRefused
            | Self::FileRefused
            | Self::LimitNotMet { .. }
            | Self::PosesNotConforming { .. } => Acceptance::Fail,
            Self::LimitUndecided { .. }
            | Self::PosesUndecided { .. }
            | Self::NotAssessable { .. }
            | Self::ErrorsUnknown { .. } => Acceptance::Undecided,
            Self::WithinGuardBand { .. }
            | Self::InstrumentTooCoarse { .. }
            | Self::NoWarmUp
            | Self::DriftNotSettled { .. }
            | Self::FewCycles { .. }
            | Self::OpenWarnings { .. }
            | Self::ModelDoesNotFit { .. }
            | Self::SetUpUntested { .. }
            | Self::HardlyBetter { .. } => Acceptance::Conditional,
        }
    }

    /// `true` if the verdict fails or is open for a reason that further effects do not remove.
    pub(crate) fn blocks_effects(&self) -> bool {
        !self.acceptance().is_accepted() && !matches!(self, Self::ErrorsUnknown { .. })
    }

    /// Reason by which a limit is not simply passed.
    fn from_limit(l: &LimitVerdict) -> Option<Self> {
        let limit = l.name;
        match (l.conformity, l.acceptance) {
            (Conformity::NotAssessable, _) => Some(Self::NotAssessable { limit }),
            (_, Acceptance::Fail) => Some(Self::LimitNotMet { limit }),
            (_, Acceptance::Undecided) => Some(Self::LimitUndecided { limit }),
            (_, Acceptance::Conditional) => Some(Self::WithinGuardBand { limit, risk: l.risk() }),
            (_, Acceptance::Pass) => None,
        }
    }

    /// Preconditions of a test to ISO 9283 that are not fulfilled.
    fn from_test(document: &Iso9283Document, conditions: Option<&Conditions>) -> Vec<Self> {
        let mut all = Vec::new();
        let poses = document.poses.iter();
        let coarse: Vec<PoseName> =
            poses.clone().filter(|p| p.quarter_rule_met == Some(false)).map(|p| p.pose).collect();
        if !coarse.is_empty() {
            all.push(Self::InstrumentTooCoarse { poses: coarse });
        }
        if conditions.and_then(|c| c.warm_up_minutes) == Some(0.0) {
            all.push(Self::NoWarmUp);
        }
        let unsettled = || document.drifts.iter().filter(|d| d.is_unsettled());
        let poses_of_drift: Vec<PoseName> = unsettled().map(|d| d.pose).collect();
        if !poses_of_drift.is_empty() {
            let dap_mm = unsettled().map(|d| d.dap_mm).fold(0.0, f64::max);
            all.push(Self::DriftNotSettled { poses: poses_of_drift, dap_mm });
        }
        let few: Vec<PoseName> = poses.filter(|p| p.cycles < CYCLES).map(|p| p.pose).collect();
        if !few.is_empty() {
            all.push(Self::FewCycles { poses: few, required: CYCLES });
        }
        all
    }

    /// Warnings on which somebody has to decide.
    fn from_messages(messages: &[&Message]) -> Option<Self> {
        let open: BTreeSet<&str> = messages.iter().filter(|m| m.is_open_decision()).map(|m| &*m.id).collect();
        (!open.is_empty()).then(|| Self::OpenWarnings { ids: open.into_iter().map(str::to_owned).collect() })
    }

    /// Conformities of single poses that no limit of the document combines.
    fn from_poses(document: &Iso9283Document) -> Vec<Self> {
        let poses = |wanted: Conformity| -> Vec<PoseName> {
            let has = |c: &PoseCharacteristic, p| {
                (c.conformity)(p) == Some(wanted) && document.limits.iter().all(|l| l.name != c.limit)
            };
            document
                .poses
                .iter()
                .filter(|p| PoseCharacteristic::ALL.iter().any(|c| has(c, p)))
                .map(|p| p.pose)
                .collect()
        };
        let (not, open) = (poses(Conformity::NotConforming), poses(Conformity::Neither));
        let not = (!not.is_empty()).then_some(Self::PosesNotConforming { poses: not });
        not.into_iter().chain((!open.is_empty()).then_some(Self::PosesUndecided { poses: open })).collect()
    }

    /// Model that leaves residuals several times the uncertainty of the instrument.
    fn from_residuals(parameters: &ParametersDocument, accuracy: Option<&AccuracyDocument>) -> Option<Self> {
        let residuals = &parameters.residuals;
        let times = residuals.times_uncertainty().filter(|_| residuals.test.chi_square_rejected)?;
        let set = accuracy.and_then(deciding_set).map(|set| set.name);
        (times > MISFIT).then_some(Self::ModelDoesNotFit { times, set })
    }

    /// Errors at other poses that are unknown, if calibration poses decide: parameters absorb
    /// errors of a model that does not fit, or errors at held-out poses are beyond one of the
    /// `limits` that calibration poses meet.
    fn from_left_out(accuracy: &AccuracyDocument, limits: &[&LimitVerdict], is_misfit: bool) -> Option<Self> {
        let set = deciding_set(accuracy).filter(|set| set.name == PoseSet::Calibration)?;
        let errors = set.error_statistics(ErrorQuantity::Position)?;
        let LeftOutErrors { nominal, identified: left_out, .. } = accuracy.left_out.as_ref()?;
        // nominal parameters with fitted base and targets, and identified ones
        let [before, after] = [nominal.rms / errors.before.rms, left_out.rms / errors.after.rms];
        let absorbs = is_misfit && after > ABSORBED * before;
        let is_beyond = |limit: &&LimitVerdict| match limit.name.limited_error() {
            Some((ErrorQuantity::Position, figure)) => limit.met && figure.value_in(left_out) > limit.limit,
            _ => false,
        };
        let (calibration_mm, left_out_mm) = (errors.after.rms, left_out.rms);
        let is_unknown = absorbs || limits.iter().any(is_beyond);
        is_unknown.then_some(Self::ErrorsUnknown { calibration_mm, left_out_mm })
    }

    /// Mistakes of the set-up that the measurements cannot show, and that move the tool beyond one
    /// of the `limits`; without limits, all of them.
    fn from_untested(parameters: &ParametersDocument, limits: &[&LimitVerdict]) -> Option<Self> {
        let largest = |unit: &str, size: &dyn Fn(&UntestedMistake) -> f64| {
            let least = limits.iter().filter(|l| l.name.unit() == unit).map(|l| l.limit).fold(f64::INFINITY, f64::min);
            let beyond = move |v: f64| limits.is_empty() || v > least;
            (beyond, parameters.untested.iter().map(size).fold(0.0, f64::max))
        };
        let (beyond_mm, flange_mm) = largest("mm", &|m| m.flange_mm);
        let (beyond_deg, flange_deg) = largest("deg", &|m| m.flange_deg);
        let is_beyond = |m: &&UntestedMistake| beyond_mm(m.flange_mm) || beyond_deg(m.flange_deg);
        let count = parameters.untested.iter().filter(is_beyond).count();
        (count > 0).then_some(Self::SetUpUntested { count, flange_mm, flange_deg })
    }

    /// Controller files that are hardly better than nominal parameters.
    fn from_controller_files(accuracy: &AccuracyDocument, controllers: Option<&ControllersDocument>) -> Vec<Self> {
        let of = |formats: &[String], errors: &ControllerErrors| {
            let ControllerErrors { nominal, written, .. } = *errors;
            errors.is_hardly_better_than_nominal().then(|| Self::HardlyBetter {
                formats: formats.to_vec(),
                nominal,
                written,
            })
        };
        let whole = hardly_better(accuracy).map(|[nominal, written]| Self::HardlyBetter {
            formats: Vec::new(),
            nominal,
            written,
        });
        let files = controllers.into_iter().flat_map(|c| &c.files);
        let files = files.filter_map(|f| of(&f.formats, f.deciding()?));
        whole.into_iter().chain(files).collect()
    }
}

impl<'a> Judged<'a> {
    /// Test to ISO 9283 alone.
    pub fn tested(tested: &'a Characteristics) -> Self {
        Self {
            parameters: None,
            accuracy: None,
            tested,
            controllers: None,
            loaded: None,
            conditions: None,
            messages: &[],
        }
    }

    /// All limits; limits of errors apply to the values of the file to load.
    pub fn limits(&self) -> impl Iterator<Item = &LimitVerdict> {
        let of_errors = match self.loaded {
            Some(loaded) => Some(&loaded.limits),
            None => self.accuracy.map(|accuracy| &accuracy.limits),
        };
        of_errors.into_iter().flatten().chain(self.tested.limits())
    }

    /// Verdict with its reasons.
    pub fn verdict(&self) -> VerdictDocument {
        let mut reasons = Vec::new();
        if let Some(parameters) = self.parameters {
            if !parameters.solver.termination.is_success() {
                reasons.push(Reason::NotConverged);
            } else if !parameters.is_plausible() {
                reasons.push(Reason::Implausible);
            }
        }
        let given = self.accuracy.and_then(|accuracy| accuracy.given.as_ref());
        reasons.extend(given.is_some_and(|given| given.refused).then_some(Reason::GivenRefused));
        reasons.extend(self.controllers.is_some_and(|c| !c.is_complete()).then_some(Reason::FileRefused));
        reasons.extend(self.limits().filter_map(Reason::from_limit));
        if let Some(document) = &self.tested.poses {
            reasons.extend(Reason::from_poses(document));
            reasons.extend(Reason::from_test(document, self.conditions));
        }
        let plausible = self.parameters.filter(|p| p.is_plausible());
        let misfit = plausible.and_then(|parameters| Reason::from_residuals(parameters, self.accuracy));
        let limits: Vec<&LimitVerdict> = self.limits().collect();
        if let (Some(accuracy), Some(_)) = (self.accuracy, plausible) {
            reasons.extend(Reason::from_left_out(accuracy, &limits, misfit.is_some()));
        }
        reasons.extend(misfit);
        reasons.extend(plausible.and_then(|parameters| Reason::from_untested(parameters, &limits)));
        reasons.extend(Reason::from_messages(self.messages));
        if let (Some(accuracy), Some(_)) = (self.accuracy, plausible) {
            reasons.extend(Reason::from_controller_files(accuracy, self.controllers));
        }
        // stable: reasons of one verdict stay in their order
        reasons.sort_by_key(|reason| std::cmp::Reverse(reason.acceptance()));
        let limits: Vec<LimitVerdict> = self.limits().cloned().collect();
        let worst = reasons.first().map_or(Acceptance::Pass, Reason::acceptance);
        // reservations about results that no limit judges give no verdict
        let verdict = (!limits.is_empty() || !worst.is_accepted()).then_some(worst);
        let exit_code = u8::from(verdict.is_some_and(|verdict| !verdict.is_accepted()));
        VerdictDocument { exit_code, verdict, reasons, limits, ..VerdictDocument::default() }
    }
}

/// Verdict without limits and reservations: nothing was judged.
impl Default for VerdictDocument {
    fn default() -> Self {
        Self {
            schema: "etalon/verdict/1".to_owned(),
            verdict: None,
            exit_code: 0,
            reasons: Vec::new(),
            limits: Vec::new(),
            judged_file: None,
            loading: None,
            actions: Vec::new(),
        }
    }
}

impl VerdictDocument {
    /// `true` if the answer may be loaded, or nothing was judged.
    pub fn passes(&self) -> bool {
        self.exit_code == 0
    }
}

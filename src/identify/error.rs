//! Reasons for a missing result. They contain neither keys nor options: the caller knows the origin
//! of a value and adds the remedy.

use crate::judge::{ReadingSlips, WrongCoordinate};
use crate::warning::{SetUpError, Warning};
use etalon_base::catalogue::{Argument, IntoArgument, Phrase};
use etalon_base::message::{Message, Problems};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase};
use etalon_math::Termination;
use std::collections::BTreeSet;
use std::fmt;

/// Reason for a missing result. Not a [`std::error::Error`], so that no caller passes it on by `?`
/// without its remedy.
#[derive(Clone, Debug)]
pub enum Error {
    /// Residuals of the pose mix mm and rad, and no standard uncertainty of a coordinate is given.
    PoseWithoutUncertainty,
    /// A common uncertainty is given without an independent one for each observation, or for
    /// residuals of the pose.
    CommonUncertaintyAlone,
    /// A parameter to hold does not exist in the robot.
    UnknownParameter {
        /// The name, in which `*` stands for any text.
        pattern: String,
        /// Names of the robot's parameters.
        names: Vec<String>,
    },
    /// Observations other than coordinates need an arm.
    NotAnArm {
        /// Model of the robot.
        model: String,
    },
    /// Observations of several kinds have no common scale without the standard uncertainty of a
    /// coordinate.
    KindsWithoutUncertainty,
    /// Readings with their own uncertainties are poses, or have another uncertainty in common.
    OwnUncertainties,
    /// Some readings have no uncertainty.
    ReadingsWithoutUncertainty {
        /// Number of readings without an uncertainty.
        without: usize,
        /// Number of all readings.
        readings: usize,
    },
    /// Residuals of the pose are for planar robots.
    NotPlanar {
        /// Model of the robot.
        model: String,
    },
    /// The robot does not have the part in whose frame the tool point is given.
    NoSuchPart {
        /// Model of the robot.
        model: String,
        /// The part.
        part: &'static str,
    },
    /// The poses of a plan do not determine the parameters.
    TooFewPoses {
        /// Number of poses.
        poses: usize,
        /// Number of parameters.
        parameters: usize,
    },
    /// Every parameter is held, or the data depend on none.
    NothingLeft {
        /// Cause, if the observations show it.
        cause: Option<Cause>,
        /// Change of the set-up that explains the observations, if one exists.
        set_up: Option<SetUpError>,
    },
    /// The observations determine fewer parameters than are free.
    Undetermined {
        /// Number of residuals, of poses, of independent residuals and of parameters.
        counts: [usize; 4],
        /// Each undetermined parameter, with the parameters that have the same effect.
        groups: Vec<(String, Vec<String>)>,
    },
    /// The set of separately identifiable parameters changes from step to step.
    Unsteady,
    /// The solver ended without a result.
    Failed {
        /// Termination of the solver.
        termination: Termination,
        /// Cause, if the observations show it.
        cause: Option<Cause>,
        /// Change of the set-up that explains the observations, if one exists.
        set_up: Option<SetUpError>,
    },
    /// The robot or its set-up does not explain the observations.
    Unexplained(Box<Warning>),
    /// Any other problem, with its remedy.
    Other(Problems),
}

/// Cause of a failed identification that the observations show.
#[derive(Clone, Debug)]
pub enum Cause {
    /// The nominal robot cannot reach these poses.
    Unreachable(BTreeSet<PoseName>),
    /// Measured and predicted points differ in their extent (mm).
    Extent {
        /// Extent of the measured points.
        measured_mm: f64,
        /// Extent of the points of the model.
        model_mm: f64,
    },
    /// The tool contradicts the given assembly mode.
    AssemblyMode {
        /// Poses with the contradiction.
        poses: BTreeSet<PoseName>,
        /// Pose with the largest deviation.
        worst: PoseName,
        /// Given mode of this pose, 1 or -1.
        mode: f64,
        /// Distances (mm) of the model from the measured position, in the given mode and in the
        /// other mode.
        left_mm: [f64; 2],
    },
    /// Most readings fit, and the readings of a few poses do not.
    Readings {
        /// Poses with these readings.
        poses: BTreeSet<PoseName>,
        /// Mistakes that explain the readings.
        slips: ReadingSlips,
    },
}

/// Maximum number of poses that a message names.
const NAMED_POSES: usize = 8;

fn named_poses(poses: &BTreeSet<PoseName>) -> Phrase {
    let mut names: Vec<String> = poses.iter().take(NAMED_POSES).map(PoseName::to_string).collect();
    if poses.len() > NAMED_POSES {
        names.push("...".to_owned());
    }
    phrase!("named-poses", count = poses.len(), poses = names)
}

impl Cause {
    /// Text of the catalogue.
    pub fn phrase(&self) -> Phrase {
        match self {
            Self::Unreachable(unreachable) => phrase!("poses-unreachable", poses = named_poses(unreachable)),
            Self::Extent { measured_mm, model_mm } => phrase!("extents-differ", measured_mm, model_mm),
            Self::AssemblyMode { poses, worst, mode, left_mm: [stated_mm, other_mm] } => {
                let (stated, other) = (format!("{mode:+}"), format!("{:+}", -mode));
                let poses = named_poses(poses);
                phrase!("assembly-mode-contradicted", poses, worst, stated, stated_mm, other, other_mm)
            }
            Self::Readings { poses, slips } => {
                let pair = |[first, second]: &[PoseName; 2]| phrase!("pair-of-poses", first, second);
                let pairs: Vec<Phrase> = slips.exchanged.iter().take(NAMED_POSES).map(pair).collect();
                let coordinates = slips.coordinates.iter().take(NAMED_POSES).map(WrongCoordinate::phrase);
                let (count, coordinates): (_, Vec<Phrase>) = (pairs.len(), coordinates.collect());
                let (poses, wrong) = (named_poses(poses), coordinates.len());
                phrase!("readings-contradict", poses, count, pairs, wrong, coordinates)
            }
        }
    }
}

/// Text of the catalogue for the termination of a solver without a result.
fn ended(termination: Termination) -> Phrase {
    let termination = match termination {
        Termination::IterationLimit => "iteration-limit",
        Termination::NotANumber => "not-a-number",
        Termination::RankDeficient => "rank-deficient",
        Termination::TooFewEquations => "too-few-equations",
        _ => "converged",
    };
    phrase!("solver-ended", termination)
}

/// Cause of a failure as an argument of its message.
fn cause_argument(cause: Option<&Cause>) -> Argument {
    cause.map_or_else(|| "none".argument(), |cause| cause.phrase().argument())
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let messages = self.clone().messages();
        f.write_str(messages.first().map_or("", |message| &message.what))
    }
}

impl Error {
    /// Messages without a remedy that names a key or an option: the error first, then its details.
    pub fn messages(self) -> Vec<Message> {
        let message = match self {
            Self::PoseWithoutUncertainty => error!("pose-residuals-without-uncertainty"),
            Self::CommonUncertaintyAlone => error!("common-uncertainty-alone"),
            Self::UnknownParameter { pattern, .. } => error!("parameter-unknown", pattern),
            Self::NotAnArm { model } => error!("observations-need-arm", model),
            Self::KindsWithoutUncertainty => error!("kinds-without-uncertainty"),
            Self::OwnUncertainties => error!("own-uncertainties-unusable"),
            Self::ReadingsWithoutUncertainty { without, readings } => {
                error!("readings-without-uncertainty", without, readings)
            }
            Self::NotPlanar { model } => error!("pose-residuals-not-planar", model),
            Self::NoSuchPart { model, part } => error!("tool-part-missing", model, part),
            Self::TooFewPoses { poses, parameters } => error!("too-few-poses-planned", poses, parameters),
            Self::NothingLeft { cause, .. } => error!("nothing-to-identify", cause = cause_argument(cause.as_ref())),
            Self::Undetermined { counts, groups } => return undetermined(counts, &groups),
            Self::Unsteady => {
                error!("identification-without-result", reason = phrase!("solver-ended", termination = "unsteady"))
            }
            Self::Failed { termination, cause, .. } => {
                let reason = cause.as_ref().map_or_else(|| ended(termination), Cause::phrase);
                error!("identification-without-result", reason)
            }
            Self::Unexplained(warning) => warning.message,
            Self::Other(problems) => return problems.0,
        };
        vec![message]
    }
}

/// Messages for undetermined parameters: the counts first, then each parameter.
fn undetermined(
    [residuals, poses, independent, parameters]: [usize; 4],
    groups: &[(String, Vec<String>)],
) -> Vec<Message> {
    let first = error!("parameters-undetermined", residuals, poses, independent, parameters);
    let details = groups.iter().map(|(parameter, with)| match with.is_empty() {
        true => error!("parameter-without-effect", parameter),
        false => error!("parameters-inseparable", parameter, others = quoted(with)),
    });
    std::iter::once(first).chain(details).collect()
}

/// Names of parameters in backticks.
pub(crate) fn quoted(names: &[impl fmt::Display]) -> Vec<String> {
    names.iter().map(|name| format!("`{name}`")).collect()
}

impl From<Problems> for Error {
    fn from(problems: Problems) -> Self {
        Self::Other(problems)
    }
}

impl From<Warning> for Error {
    fn from(warning: Warning) -> Self {
        Self::Unexplained(Box::new(warning))
    }
}

impl From<Message> for Error {
    fn from(message: Message) -> Self {
        Self::Other(message.into())
    }
}

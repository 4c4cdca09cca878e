//! Reasons why there is no result. They name neither keys nor options: who knows where a value was stated adds the remedy.

use crate::warning::{SetUpError, Warning};
use etalon_base::message::{Message, Problems, count};
use etalon_base::pose_name::PoseName;
use etalon_math::Termination;
use std::collections::BTreeSet;
use std::fmt;

/// Reason why there is no result. Not a [`std::error::Error`], so that no caller passes it on by `?` without its remedy.
#[derive(Clone, Debug)]
pub enum Error {
    /// Residuals of the pose mix mm and rad, and no standard uncertainty of a coordinate is stated.
    PoseWithoutUncertainty,
    /// A common uncertainty is stated without one that each observation has of its own, or for residuals of the pose.
    CommonUncertaintyAlone,
    /// A name of a parameter to hold is none of the robot's.
    UnknownParameter {
        /// The name, in which `*` stands for any text.
        pattern: String,
        /// Names of the robot's parameters.
        names: Vec<String>,
    },
    /// Observations other than coordinates are for arms.
    NotAnArm {
        /// Model of the robot.
        model: String,
    },
    /// Observations of several kinds have no common scale without the standard uncertainty of a coordinate.
    KindsWithoutUncertainty,
    /// Readings with an uncertainty of their own are poses, or have another uncertainty in common.
    OwnUncertainties,
    /// Some readings have no uncertainty.
    ReadingsWithoutUncertainty {
        /// Number of readings without one.
        without: usize,
        /// Number of all readings.
        readings: usize,
    },
    /// Residuals of the pose are for planar robots.
    NotPlanar {
        /// Model of the robot.
        model: String,
    },
    /// The robot has no such part to state a tool point on.
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
    /// Base and targets cannot be placed from the poses.
    BaseNotFound,
    /// Every parameter is held, or the data depend on none.
    NothingLeft {
        /// Why, where the observations show it.
        cause: Option<Cause>,
        /// The change of the set-up that explains the observations, where there is one.
        set_up: Option<SetUpError>,
    },
    /// The observations determine fewer parameters than are wanted.
    Undetermined {
        /// Number of residuals, of poses, of independent residuals and of parameters.
        counts: [usize; 4],
        /// Each undetermined parameter, with the parameters that act alike.
        groups: Vec<(String, Vec<String>)>,
    },
    /// Which parameters are separately identifiable changes from step to step.
    Unsteady,
    /// The solver ended without a result.
    Failed {
        /// How it ended.
        termination: Termination,
        /// Why, where the observations show it.
        cause: Option<Cause>,
        /// The change of the set-up that explains the observations, where there is one.
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
    /// The tool is not where the stated assembly mode puts it.
    AssemblyMode {
        /// The poses of which this is true.
        poses: BTreeSet<PoseName>,
        /// The pose that is farthest off.
        worst: PoseName,
        /// Its stated mode, 1 or -1.
        mode: f64,
        /// Distances (mm) of the model from the measured position, in the stated mode and in the other one.
        left_mm: [f64; 2],
    },
}

/// Poses that a message names.
const NAMED_POSES: usize = 8;

fn poses(numbers: &BTreeSet<PoseName>) -> String {
    let shown: Vec<String> = numbers.iter().take(NAMED_POSES).map(PoseName::to_string).collect();
    match numbers.len() {
        1 => format!("pose {}", shown.join("")),
        n if n > NAMED_POSES => format!("{n} poses ({}, ...)", shown.join(", ")),
        n => format!("{n} poses ({})", shown.join(", ")),
    }
}

impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unreachable(unreachable) => {
                write!(f, "the nominal robot cannot be where the joints put it in {}", poses(unreachable))
            }
            Self::Extent { measured_mm, model_mm } => {
                write!(f, "measured points spread over {measured_mm:.0} mm, the model's over {model_mm:.0} mm")
            }
            Self::AssemblyMode { poses: wrong, worst, mode, left_mm: [stated, other] } => write!(
                f,
                "the tool is not where the assembly mode puts it in {}: pose {worst} is stated in mode {mode:+}, where the model is \
                 {stated:.1} mm from the measured position, in mode {:+} {other:.1} mm",
                poses(wrong),
                -mode,
            ),
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let because = |cause: &Option<Cause>| cause.as_ref().map_or(String::new(), |cause| format!(": {cause}"));
        match self {
            Self::PoseWithoutUncertainty => {
                f.write_str("pose residuals mix mm and rad: they need the standard uncertainty of a coordinate")
            }
            Self::CommonUncertaintyAlone => f.write_str(
                "an uncertainty common to several observations is for residuals of targets, beside one that each has of its own",
            ),
            Self::UnknownParameter { pattern, .. } => write!(f, "`{pattern}` is not a parameter of this robot"),
            Self::NotAnArm { model } => write!(
                f,
                "orientations, distances, contacts, surfaces and joints are for arms in space, not for `{model}`"
            ),
            Self::KindsWithoutUncertainty => {
                f.write_str("observations of several kinds need the standard uncertainty of a coordinate")
            }
            Self::OwnUncertainties => f.write_str(
                "readings with an uncertainty of their own weigh residuals of targets, without an uncertainty that rows have in common",
            ),
            Self::ReadingsWithoutUncertainty { without, readings } => {
                write!(f, "{without} of {readings} readings state no uncertainty, and none is stated for them")
            }
            Self::NotPlanar { model } => write!(f, "residuals of the pose are for planar robots, not for `{model}`"),
            Self::NoSuchPart { model, part } => {
                write!(f, "a tool point in the frame of the {part}: `{model}` has no {part}")
            }
            Self::TooFewPoses { poses, parameters } => {
                write!(f, "{poses} poses do not suffice to identify {parameters} parameters")
            }
            Self::BaseNotFound => f.write_str("base and targets cannot be found from these poses"),
            Self::NothingLeft { cause, .. } => write!(f, "no parameter is left to identify{}", because(cause)),
            Self::Undetermined { counts: [residuals, poses, independent, parameters], .. } => write!(
                f,
                "{} from {}, {independent} of them independent, do not determine {}",
                count(*residuals, "residual"),
                count(*poses, "pose"),
                count(*parameters, "parameter"),
            ),
            Self::Unsteady => f.write_str("which parameters are separately identifiable changes from step to step"),
            Self::Failed { termination, cause, .. } => {
                let why = cause.as_ref().map_or_else(|| termination.to_string(), Cause::to_string);
                write!(f, "the identification ended without a result: {why}")
            }
            Self::Unexplained(warning) => warning.fmt(f),
            Self::Other(problems) => problems.fmt(f),
        }
    }
}

impl Error {
    /// Messages without a remedy that names a key or an option: the error first, then its details.
    pub fn messages(self) -> Vec<Message> {
        let message = Message::error(self.to_string());
        match self {
            Self::Unexplained(warning) => vec![warning.message],
            Self::Other(problems) => problems.0,
            Self::BaseNotFound => {
                vec![message.expected("at least four poses in which the arm moves in all directions")]
            }
            Self::Undetermined { groups, .. } => {
                let details = groups.iter().map(|(held, with)| match &with[..] {
                    [] => format!("the data do not depend on `{held}`"),
                    with => format!("`{held}` is not separately identifiable from `{}`", with.join("`, `")),
                });
                std::iter::once(message).chain(details.map(Message::error)).collect()
            }
            _ => vec![message],
        }
    }
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

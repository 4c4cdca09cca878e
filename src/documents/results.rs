//! Document forms of mathematical results. Renaming a variant or field of the mathematics fails to
//! compile here instead of changing documents.

use crate::mirror::mirror;
use etalon_base::catalogue::Phrase;
use etalon_identify as identify;
use std::fmt;

mirror! {
    /// Reason of a solver's termination.
    #[serde(rename_all = "snake_case")]
    enum Termination of etalon_math::Termination {
        /// Converged: the last step did not change the parameters.
        StepVanished,
        /// Converged to a stationary point: the residuals are orthogonal to every column of the
        /// Jacobian.
        GradientVanished,
        /// Converged: the residuals are zero to rounding.
        ResidualsZero,
        /// Converged to rounding: no shorter step lowers the sum of squares.
        NoImprovementPossible,
        /// Iteration limit reached.
        #[serde(rename = "lost_patience")]
        IterationLimit,
        /// A residual or derivative is not finite, at the start or on the way.
        NotANumber,
        /// Rank-deficient Jacobian: not all parameters are separately identifiable.
        RankDeficient,
        /// Fewer equations than parameters.
        TooFewEquations,
    }
}

impl Termination {
    /// `true` if the parameters may be used.
    pub fn is_success(self) -> bool {
        etalon_math::Termination::from(self).is_success()
    }

    /// The reason in words.
    pub fn phrase(self) -> Phrase {
        etalon_math::Termination::from(self).phrase()
    }
}

impl fmt::Display for Termination {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        etalon_math::Termination::from(*self).fmt(f)
    }
}

mirror! {
    /// Quantity whose residuals are minimised.
    #[serde(rename_all = "snake_case")]
    #[derive(Default)]
    enum ResidualKind of identify::ResidualKind {
        /// Coordinates of each target, weighted by the instrument's uncertainty.
        #[default]
        Targets,
        /// Coordinates x, y and theta of the platform, where 1 rad weighs as 1 mm (thesis, eq.
        /// 3.26). Planar robots only.
        Pose,
    }
}

mirror! {
    /// Basis of the standard uncertainties.
    #[serde(rename_all = "snake_case")]
    enum UncertaintyFrom of identify::UncertaintyFrom {
        /// Given uncertainty of the instrument; chi-square does not reject the model.
        Instrument,
        /// Residuals, assumed to be independent.
        Residuals,
        /// Residuals grouped by pose: errors of the robot are common to all targets and repeats of
        /// a pose (cluster-robust covariance, Liang & Zeger 1986).
        ResidualsByPose,
        /// Residuals grouped by region of joint space, because unmodelled errors are alike at
        /// neighbouring poses: uncertainty of effective parameters, from leaving out each of eight
        /// regions, averaged over eight divisions (delete-a-group jackknife, Bell & McCaffrey
        /// 2002).
        ResidualsByRegion,
        /// No basis: there is no redundancy, and no uncertainty is given.
        Nothing,
    }
}

mirror! {
    /// A source of uncertainty.
    #[serde(rename_all = "snake_case")]
    enum UncertaintySource of identify::UncertaintySource {
        /// Instrument, by its given uncertainty or the uncertainties of the readings.
        Instrument,
        /// Contact with a socket, a surface or a measured point, by its stated uncertainty.
        Contact,
        /// Readings of single coordinates, for example of a dial gauge.
        SingleCoordinates,
        /// Readings of encoders at the links.
        Encoders,
        /// Stated shape of rigid parts.
        RigidParts,
        /// Given positions and lengths of sockets and other fixed points.
        KnownPoints,
        /// Nominal values, by their tolerances.
        NominalValues,
        /// Scatter of repeats beyond the instrument's uncertainty.
        Repeatability,
        /// Unmodelled errors of the robot: residuals beyond all other sources.
        Model,
        /// Residuals, if no uncertainty is given.
        Residuals,
        /// World frame, common to all poses.
        Frame,
        /// Frame that was measured again at each pose.
        FrameOfPoses,
        /// Scale of the measuring system, common to all lengths.
        Scale,
        /// Temperature, by the expansion of robot and part.
        Temperature,
        /// Joint values set by homing, common to the campaign.
        Homing,
    }
}

mirror! {
    /// Statistic of the position errors of an identification.
    #[serde(rename_all = "snake_case")]
    enum Figure of identify::Figure {
        /// Mean size.
        Mean,
        /// Root mean square.
        Rms,
        /// Largest size.
        Max,
    }
}

mirror! {
    /// Part to which a tool point is attached.
    #[serde(rename_all = "snake_case")]
    enum ToolFrame of identify::ToolFrame {
        /// Flange of an arm.
        Flange,
        /// Platform, with the origin at its centre C.
        Platform,
        /// Identified targets: origin at the first target, x axis towards the second, the third in
        /// the xy plane.
        Targets,
    }
}

mirror! {
    /// Scatter of repeats against the other residuals (Draper & Smith, Applied Regression Analysis,
    /// 2.1).
    #[derive(Copy)]
    struct Replicates of identify::Replicates {
        /// Standard deviation of a coordinate among repeats of a pose (mm).
        repeats_mm: f64,
        /// Degrees of freedom of the scatter of repeats.
        degrees_of_freedom: usize,
        /// Standard deviation of the model error of a coordinate at a pose, without the scatter of
        /// repeats (mm).
        lack_of_fit_mm: f64,
        /// Probability of residuals at least this large if the model is right (F test of lack of
        /// fit).
        p_value: f64,
    }
}

mirror! {
    /// Reliability of a reading, as controlled by the other readings: worst of its coordinates.
    #[derive(Copy)]
    struct ReadingReliability of identify::ReadingReliability {
        /// Redundancy number r = 1 − h: share of an error that its residual shows, from 0
        /// (uncontrolled) to 1.
        redundancy: f64,
        /// Largest residual over its standard deviation σ √r.
        w: f64,
        /// Smallest error of a coordinate that is detected with a power of 80 % at a significance
        /// level of 0.1 %: 4.13 σ / √r (mm).
        detectable_mm: f64,
    }
}

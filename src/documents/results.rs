//! Results of the mathematics as documents spell them. A variant or field that is renamed there does not compile here: no document changes by it.

use crate::mirror::mirror;
use etalon_identify as identify;
use std::fmt;

mirror! {
    /// Why the solver stopped.
    #[serde(rename_all = "snake_case")]
    enum Termination of etalon_math::Termination {
        /// The last step no longer changed the parameters.
        StepVanished,
        /// The residuals are orthogonal to every column of the Jacobian: a stationary point.
        GradientVanished,
        /// The residuals are zero to rounding.
        ResidualsZero,
        /// No shorter step lowers the sum of squares: rounding limits the result.
        NoImprovementPossible,
        /// The iterations allowed were used up.
        LostPatience,
        /// A residual or derivative is not a number at the start or on the way.
        NotANumber,
        /// The Jacobian has dependent columns: not all parameters are separately identifiable.
        RankDeficient,
        /// There are fewer equations than parameters.
        TooFewEquations,
    }
}

impl Termination {
    /// `true` if the parameters may be used.
    pub fn is_success(self) -> bool {
        etalon_math::Termination::from(self).is_success()
    }
}

impl fmt::Display for Termination {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        etalon_math::Termination::from(*self).fmt(f)
    }
}

mirror! {
    /// What is compared.
    #[serde(rename_all = "snake_case")]
    #[derive(Default)]
    enum ResidualKind of identify::ResidualKind {
        /// Coordinates of each target, weighted by the instrument's uncertainty.
        #[default]
        Targets,
        /// x, y and theta of the platform (eq. 3.26): a radian weighs as a millimetre. Planar robots only.
        Pose,
    }
}

mirror! {
    /// What standard uncertainties rest on.
    #[serde(rename_all = "snake_case")]
    enum UncertaintyFrom of identify::UncertaintyFrom {
        /// The stated uncertainty of the instrument: chi-square does not reject the model.
        Instrument,
        /// The residuals, each taken as independent of the others.
        Residuals,
        /// The residuals, those of one pose taken together: errors of the robot are common to all targets and repeats of a
        /// pose (cluster-robust covariance, Liang & Zeger 1986).
        ResidualsByPose,
        /// The residuals, those of one region of the joints taken together: what the model leaves out is common to neighbouring poses
        /// (Conley 1999 for errors that are correlated in space; clusters as above).
        ResidualsByRegion,
        /// Nothing: there are as many equations as parameters, and no uncertainty is stated.
        Nothing,
    }
}

mirror! {
    /// A source of uncertainty.
    #[serde(rename_all = "snake_case")]
    enum UncertaintySource of identify::UncertaintySource {
        /// The instrument: its stated uncertainty, or that which readings state of themselves.
        Instrument,
        /// How well the robot finds a measured point again, as stated.
        Contact,
        /// Stated shapes of rigid parts.
        RigidParts,
        /// Stated places and lengths of sockets and other fixed points.
        KnownPoints,
        /// Nominal values, by their tolerances.
        NominalValues,
        /// What repeats of a pose scatter beyond the instrument.
        Repeatability,
        /// What residuals exceed all this by: errors of the robot that the model does not describe.
        Model,
        /// Residuals, where no uncertainty is stated.
        Residuals,
        /// The world frame, common to all poses.
        Frame,
        /// The frame that was measured again at each pose.
        FrameOfPoses,
        /// The scale of the measuring system, common to all lengths.
        Scale,
        /// The temperature, by the expansion of robot and part.
        Temperature,
        /// The joint values that homing sets, common to the campaign.
        Homing,
    }
}

mirror! {
    /// A figure made of the position errors of an identification: its derivatives by each of them.
    #[serde(rename_all = "snake_case")]
    enum Figure of identify::Figure {
        /// Their mean size.
        Mean,
        /// Their root mean square.
        Rms,
        /// The largest.
        Max,
    }
}

mirror! {
    /// The part in whose frame a tool point is stated.
    #[serde(rename_all = "snake_case")]
    enum ToolFrame of identify::ToolFrame {
        /// The flange of an arm.
        Flange,
        /// A platform, at its centre C.
        Platform,
        /// The targets as identified: origin at the first, x axis to the second, the third in the xy plane.
        Targets,
    }
}

mirror! {
    /// Scatter of repeats against the rest of the residuals (Draper & Smith, Applied Regression Analysis, 2.1).
    #[derive(Copy)]
    struct Replicates of identify::Replicates {
        /// Standard deviation of a coordinate among repeats of a pose, mm.
        repeats_mm: f64,
        /// Its degrees of freedom.
        degrees_of_freedom: usize,
        /// Standard deviation of a coordinate that the model leaves at a pose, without the scatter of repeats, mm.
        lack_of_fit_mm: f64,
        /// Probability of residuals as large as these if the model were right (F test of lack of fit).
        p_value: f64,
    }
}

mirror! {
    /// How well a reading is controlled by the others: of its coordinates the worst.
    #[derive(Copy)]
    struct ReadingReliability of identify::ReadingReliability {
        /// Redundancy number r = 1 - h, from 0 (nothing controls it) to 1: the share of an error that its residual shows.
        redundancy: f64,
        /// Largest residual over its standard deviation σ √r.
        w: f64,
        /// Least error of a coordinate that is detected with a power of 80 % (significance level 0.1 %): 4.13 σ / √r, mm.
        detectable_mm: f64,
    }
}

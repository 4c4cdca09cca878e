//! `[geometric]`: assignment of labels to the steps of the geometric calibration (thesis, chapter
//! 2).

use crate::StatedPoses;
use schemars::JsonSchema;
use serde::Deserialize;
use toml::Spanned;

/// Steps of the geometric calibration. Leads, scale bars, single balls and the workspace can be
/// used alone. Four steps determine parameters: `arc` (origin O of the base), `turn` (centre C of
/// the platform), `shaft` (length s) and `offsets` (lengths d1 and d3). `arc` and `turn` need the
/// world frame; `shaft` also needs `arc`. `offsets` needs `arc`, `turn`, `shaft` and
/// `mid_travel_mm`. The world frame determines the xy plane of the base frame, the position of ball
/// R and the side of actuator 3.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GeometricDefinition {
    /// Pattern of the labels of ball N on its arc.
    #[schemars(with = "Option<String>")]
    pub arc: Option<Spanned<String>>,
    /// Pattern of the labels of balls K, L and the ball on the tapered block while the platform
    /// rotates.
    #[schemars(with = "Option<String>")]
    pub turn: Option<Spanned<String>>,
    /// Name of the ball on the tapered block.
    #[serde(default = "ball_i")]
    pub turn_ball: String,
    /// Pattern of the labels of all points on the shaft; poses 1 and 2 are the two positions, the
    /// cycle is the repeat.
    #[schemars(with = "Option<String>")]
    pub shaft: Option<Spanned<String>>,
    /// Pattern of the labels of balls K and L. At pose 1, actuator 1 is at home; at pose 2 (K
    /// alone), it is at its end.
    #[schemars(with = "Option<String>")]
    pub offsets: Option<Spanned<String>>,
    /// Commanded displacement of actuators 2 and 3 for the offsets.
    pub mid_travel_mm: Option<f64>,
    /// Leads of the screws.
    #[serde(default)]
    pub lead: Vec<LeadDefinition>,
    /// Scale bars.
    #[serde(default)]
    pub scale_bar: Vec<ScaleBarDefinition>,
    /// Single balls, measured repeatedly while the robot does not move (thesis, 2.6).
    #[serde(default)]
    pub ball: Vec<BallDefinition>,
    /// Tables of errors by pose (thesis, 2.7).
    #[serde(default)]
    pub table: Vec<TableDefinition>,
    /// Workspace to report.
    pub workspace: Option<WorkspaceDefinition>,
}

fn ball_i() -> String {
    "I".to_owned()
}

/// A ball on a carriage, measured along the travel.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LeadDefinition {
    /// Number of the actuator, 1 to 3.
    #[schemars(with = "usize")]
    pub actuator: Spanned<usize>,
    /// Pattern of the labels; the pose is the number of the position, the cycle the number of the
    /// pass.
    #[schemars(with = "String")]
    pub label: Spanned<String>,
    /// Commanded displacements of the positions.
    pub positions_mm: Vec<f64>,
    /// Nominal lead of the screw.
    pub lead_mm: f64,
}

/// A scale bar in one position.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ScaleBarDefinition {
    /// Name for the report.
    pub name: String,
    /// Pattern of the labels; the target is `A` or `B`, the cycle is the repeat.
    #[schemars(with = "String")]
    pub label: Spanned<String>,
    /// Calibrated distance of the balls.
    pub length_mm: f64,
    /// Expanded uncertainty (k = 2) of the calibrated length, from the certificate of the bar.
    pub length_uncertainty_um: Option<f64>,
    /// Maximum permissible error of the instrument for a distance. By default it is computed from
    /// the stated uncertainty of two points. The largest error of all measured distances then
    /// exceeds it with a probability of 5 %.
    pub permissible_error_um: Option<f64>,
}

/// A stationary ball.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BallDefinition {
    /// Name for the report.
    pub name: String,
    /// Pattern of the labels; the cycle is the repeat.
    #[schemars(with = "String")]
    pub label: Spanned<String>,
}

/// Table of mean errors of selected poses.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TableDefinition {
    /// Title of the table.
    pub title: String,
    /// Poses of the table, in the notation of `[identify]`.
    #[schemars(with = "StatedPoses")]
    pub poses: Spanned<StatedPoses>,
}

/// Orientations that must all be reached; the travel of the actuators is given in robot.toml.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WorkspaceDefinition {
    /// Largest angle of rotation of the platform in both directions.
    pub theta_deg: f64,
}

impl GeometricDefinition {
    /// All patterns of labels.
    pub fn patterns(&self) -> impl Iterator<Item = &Spanned<String>> {
        let leads = self.lead.iter().map(|l| &l.label);
        let bars = self.scale_bar.iter().map(|b| &b.label);
        let balls = self.ball.iter().map(|b| &b.label);
        let robot = [&self.arc, &self.turn, &self.shaft, &self.offsets].into_iter().flatten();
        robot.chain(leads).chain(bars).chain(balls)
    }

    /// `true` if all steps that determine the robot are given.
    pub fn is_whole(&self) -> bool {
        self.arc.is_some() && self.turn.is_some() && self.shaft.is_some() && self.offsets.is_some()
    }

    /// Missing keys, each with the key that needs it.
    pub fn missing(&self) -> Vec<(&'static str, &'static str)> {
        let [arc, turn, shaft, offsets] = [&self.arc, &self.turn, &self.shaft, &self.offsets].map(Option::is_some);
        let mid_travel = self.mid_travel_mm.is_some();
        [
            ("arc", "shaft", shaft && !arc),
            ("arc", "offsets", offsets && !arc),
            ("turn", "offsets", offsets && !turn),
            ("shaft", "offsets", offsets && !shaft),
            ("mid_travel_mm", "offsets", offsets && !mid_travel),
            ("offsets", "mid_travel_mm", mid_travel && !offsets),
        ]
        .into_iter()
        .filter(|(.., missing)| *missing)
        .map(|(key, by, _)| (key, by))
        .collect()
    }
}

//! `[geometric]`: which labels are which step of the geometric calibration (thesis, chapter 2).

use serde::Deserialize;
use toml::Spanned;

/// Steps of the geometric calibration. The base frame's plane, ball R and the side of actuator 3 are those of the
/// world frame.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GeometricDefinition {
    /// Ball N on its arc, e.g. `N_{pose}`.
    pub arc: Spanned<String>,
    /// Balls K, L and the one on the tapered block while the platform turns, e.g. `{target}_turn_{pose}`.
    pub turn: Spanned<String>,
    /// Name of the ball on the tapered block.
    #[serde(default = "ball_i")]
    pub turn_ball: String,
    /// All points on the shaft; pose 1 and 2 are the two positions, cycle the repeat: `shaft{pose}_{cycle}`.
    pub shaft: Spanned<String>,
    /// Balls K and L with actuator 1 homed (pose 1), K with it at its end (pose 2), cycle the repeat.
    pub offsets: Spanned<String>,
    /// Commanded displacement of actuators 2 and 3 for the offsets.
    pub mid_travel_mm: f64,
    /// Leads.
    #[serde(default)]
    pub lead: Vec<LeadDefinition>,
    /// Scale bars.
    #[serde(default)]
    pub scale_bar: Vec<ScaleBarDefinition>,
    /// Single balls, measured again and again while the robot stands still (2.6).
    #[serde(default)]
    pub ball: Vec<BallDefinition>,
    /// Tables of errors by pose (2.7).
    #[serde(default)]
    pub table: Vec<TableDefinition>,
    /// What of the workspace is told.
    pub workspace: Option<WorkspaceDefinition>,
}

fn ball_i() -> String {
    "I".to_owned()
}

/// A ball on a carriage, measured along the travel.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LeadDefinition {
    /// Number of the actuator, 1 to 3.
    pub actuator: Spanned<usize>,
    /// Its labels; pose is the number of the position, cycle that of the pass.
    pub label: Spanned<String>,
    /// Commanded displacement of each position.
    pub positions_mm: Vec<f64>,
    /// Nominal lead of the screw.
    pub lead_mm: f64,
}

/// A scale bar in one position.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ScaleBarDefinition {
    /// Name for the report.
    pub name: String,
    /// Its labels; target is `A` or `B`, cycle the repeat.
    pub label: Spanned<String>,
    /// Calibrated distance of its balls.
    pub length_mm: f64,
}

/// A ball that does not move.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BallDefinition {
    /// Name for the report.
    pub name: String,
    /// Its labels; cycle is the repeat.
    pub label: Spanned<String>,
}

/// Poses whose mean errors make a table.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TableDefinition {
    /// Its title.
    pub title: String,
    /// Its poses, e.g. `"9-13"`.
    pub poses: Spanned<String>,
}

/// The interval of orientations that shall all be reached; how far the actuators go says the robot.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WorkspaceDefinition {
    /// Orientations from minus to plus this.
    pub theta_deg: f64,
}

impl GeometricDefinition {
    /// Every pattern of labels.
    pub fn patterns(&self) -> impl Iterator<Item = &Spanned<String>> {
        let leads = self.lead.iter().map(|l| &l.label);
        let bars = self.scale_bar.iter().map(|b| &b.label);
        let balls = self.ball.iter().map(|b| &b.label);
        [&self.arc, &self.turn, &self.shaft, &self.offsets].into_iter().chain(leads).chain(bars).chain(balls)
    }
}

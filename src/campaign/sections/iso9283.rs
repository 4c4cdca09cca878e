//! `[repeatability]`, `[poses]`, `[compliance]` and `[[stream]]`: tests of ISO 9283.

use crate::{Campaign, TableDefinition};
use etalon_base::error;
use etalon_base::message::Problems;
use etalon_base::pose_name::PoseName;
use etalon_formats::dialect::Unit;
use etalon_formats::{Format, TableReading};
use etalon_tables::{Encoding, Form, TableLayout};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use toml::Spanned;

/// A test of repeatability along one trajectory, from labelled points.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RepeatabilityDefinition {
    /// Pattern of the labels, with `{pose}` and `{cycle}`. Attained poses with equal pose and cycle
    /// share a label, in their order.
    #[schemars(with = "String")]
    pub label: Spanned<String>,
    /// Numbers or names of the poses in the order of one cycle; the previous pose is the approach.
    #[schemars(with = "Vec<PoseName>")]
    pub trajectory: Spanned<Vec<PoseName>>,
    /// Four poses whose mean positions are tested for coplanarity.
    #[schemars(with = "Option<[PoseName; 4]>")]
    pub coplanar: Option<Spanned<[PoseName; 4]>>,
    /// Pattern of the labels of the home position, each measured after homing.
    #[schemars(with = "Option<String>")]
    pub homing: Option<Spanned<String>>,
    /// Table of commanded poses in the world frame: `pose,x_mm,y_mm[,z_mm]`. Accuracy, distance and
    /// drift require this table.
    pub commanded: Option<TableDefinition>,
    /// Number of cycles in one set of a drift test; without it drift is not evaluated.
    #[schemars(with = "Option<usize>")]
    pub drift_set: Option<Spanned<usize>>,
}

impl RepeatabilityDefinition {
    /// All patterns of labels.
    pub fn patterns(&self) -> impl Iterator<Item = &Spanned<String>> {
        std::iter::once(&self.label).chain(&self.homing)
    }
}

/// A test of poses from tables, in its own frame.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[schemars(deny_unknown_fields, transform = etalon_tables::schema::accept_topic)]
pub struct PosesDefinition {
    /// Table of attained poses:
    /// `pose,cycle,x_mm,y_mm[,z_mm][,a_deg][,b_deg][,c_deg][,approach][,robot][,reading]`.
    pub attained: TableDefinition,
    /// Table of commanded poses: the same columns without `cycle`.
    pub commanded: TableDefinition,
    /// Table of stationary reference targets that are measured from time to time:
    /// `cycle,target,x_mm,y_mm[,z_mm]`.
    pub reference: Option<TableDefinition>,
    /// Form and columns of the tables; a table without a given heading is read without the column.
    /// Filters, constant columns and `pose` are the same as for the attained poses.
    #[serde(flatten)]
    pub layout: TableLayout,
    /// Number of cycles in one set of a drift test; without it drift is not evaluated.
    #[schemars(with = "Option<usize>")]
    pub drift_set: Option<Spanned<usize>>,
    /// Order of the rotations a, b, c; if given, reference targets also compensate orientations.
    pub rotation_order: Option<String>,
    /// Seed of the bootstrap intervals.
    #[serde(default = "seed")]
    pub seed: u64,
}

impl PosesDefinition {
    /// Table to read that gives no form of its own; filters, constants and `pose` come from the
    /// attained poses.
    pub fn reading(&self, attained: bool) -> TableReading {
        let mut layout = self.layout.clone();
        if !attained {
            let form = Form { only: BTreeMap::new(), without: BTreeMap::new(), ..layout.form };
            layout = TableLayout { form, columns: layout.columns, ..TableLayout::default() };
        }
        TableReading { lenient: true, ..TableReading::any(layout) }
    }
}

fn seed() -> u64 {
    1
}

/// A recorded motion. Recording, path and commanded poses are in the frame of the recording.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StreamDefinition {
    /// Unique name for the report.
    #[schemars(with = "String")]
    pub name: Spanned<String>,
    /// Recording: `time_s,x_mm,y_mm[,z_mm][,a_deg][,b_deg][,c_deg]`, or any text with given
    /// `format` and `unit`.
    #[schemars(with = "String")]
    pub file: Spanned<String>,
    /// Format of the recording, as for an export; by default the table of the key `file`.
    pub format: Option<Format>,
    /// Length unit of the recording; required with `format`.
    pub unit: Option<Unit>,
    /// Character encoding of the recording, if no byte-order mark gives it.
    #[schemars(extend("default" = "utf-8"))]
    pub encoding: Option<Encoding>,
    /// Sampling rate, which replaces time stamps.
    pub rate_hz: Option<f64>,
    /// Upper limit for the distance of positions from their mean during a standstill.
    #[serde(default = "still_mm")]
    pub still_mm: f64,
    /// Minimum duration of a standstill.
    #[serde(default = "still_s")]
    pub still_s: f64,
    /// Upper limit for the distance of a standstill from its pose, and of an attained path from the
    /// commanded path.
    #[serde(default = "near_mm")]
    pub near_mm: f64,
    /// Limit band for stabilisation time, overshoot and posing time.
    pub band_mm: Option<f64>,
    /// Table of commanded poses: `pose,x_mm,y_mm[,z_mm]...`
    pub commanded: Option<TableDefinition>,
    /// Table of the commanded path: the columns of the recording without time, with one row per
    /// point.
    pub path: Option<TableDefinition>,
    /// Number of command points on the path.
    #[serde(default = "path_points")]
    pub path_points: usize,
    /// Commanded velocity on the path.
    pub velocity_mm_s: Option<f64>,
    /// Central part of the path in which velocities are evaluated.
    #[serde(default = "central_percent")]
    pub central_percent: f64,
    /// Stroke of a weave from side to side; the path is then its centre line.
    pub weave_stroke_mm: Option<f64>,
    /// Frequency of the weave in full swings.
    pub weave_hz: Option<f64>,
    /// Direction of the weave: x, y and z.
    #[serde(default)]
    pub weave_across: Vec<f64>,
}

fn still_mm() -> f64 {
    0.1
}

fn still_s() -> f64 {
    0.2
}

fn near_mm() -> f64 {
    10.0
}

fn path_points() -> usize {
    50
}

fn central_percent() -> f64 {
    50.0
}

impl StreamDefinition {
    /// Reports a file whose units are missing, or given twice.
    pub fn problems(&self, campaign: &Campaign) -> Problems {
        if self.format.is_some() == self.unit.is_some() {
            return Problems::default();
        }
        error!("recording-unit").at(campaign.place(&self.name)).into()
    }
}

//! `etalon iso9283`

mod plan;
mod stream;

use super::table_file::TableFile;
use super::{Verdict, answer, remark};
use crate::base::message::{Message, Problems};
use crate::document::{Characteristics, to_json};
use crate::iso9283::pose::{DRAWS, Settings};
use crate::report::Faces;
use crate::stages::iso9283::load;
use crate::stages::iso9283::pose::PoseTables;
use plan::PlanOptions;
use std::path::{Path, PathBuf};
use stream::StreamOptions;

/// Evaluate accuracy, repeatability and other characteristics by ISO 9283
///
/// Tables are CSV: pose,cycle,x_mm,y_mm[,z_mm][,a_deg][,b_deg][,c_deg], rows in the order of recording; planar robots
/// leave out z_mm. A column `approach` names directions of approach (without it, the previous pose), a column `robot` several
/// robots, a column `reading` several readings of one attained pose.
///
/// A recorded motion (--stream) gives standstills, stabilisation, and with --path the characteristics of a path. --compliance
/// evaluates static compliance. --plan lays out a test.
#[derive(Debug, clap::Args)]
#[command(group(clap::ArgGroup::new("what").required(true).args(["poses", "stream", "compliance", "plan"])))]
pub struct Iso9283 {
    /// Attained poses
    poses: Option<PathBuf>,
    /// Commanded poses: the same columns without cycle
    #[arg(long, required_unless_present_any = ["stream", "compliance", "plan"])]
    commanded: Option<PathBuf>,
    /// Expanded uncertainty of a measured position in micrometres, for the intervals and the 25 % rule
    #[arg(long, value_name = "UM")]
    expanded_uncertainty_um: Option<f64>,
    /// Limit of AP, decided by its interval: conforming, not conforming or undecided; exit code 1 unless conforming
    #[arg(long, value_name = "MM", requires = "poses")]
    ap_limit_mm: Option<f64>,
    /// Limit of RP, decided in the same way
    #[arg(long, value_name = "MM", requires = "poses")]
    rp_limit_mm: Option<f64>,
    /// Reference targets, which do not move: cycle,target,x_mm,y_mm[,z_mm], measured from time to time. Positions, and angles
    /// whose order is stated, are compensated to the first time
    #[arg(long, value_name = "FILE", requires = "poses")]
    reference: Option<PathBuf>,
    /// Cycles of one set of a drift test, e.g. 10
    #[arg(long, value_name = "CYCLES")]
    drift_set: Option<usize>,
    /// Order of the rotations a, b, c, e.g. "Rz(c) Ry(b) Rx(a)": recorded, and with --reference used to compensate angles
    #[arg(long, value_name = "TEXT")]
    rotation_order: Option<String>,
    /// Seed of the bootstrap intervals
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Distances, approaches, drift, exchangeability and coplanarity as well; with --json one object instead of a list
    #[arg(long)]
    all: bool,
    /// Print JSON: a list with one object per pose; one object for all else
    #[arg(long)]
    json: bool,
    /// Static compliance: direction,cycle,force_n,x_mm,y_mm[,z_mm]; direction +x to -z, in each cycle a row of force 0
    #[arg(long, value_name = "FILE")]
    compliance: Option<PathBuf>,
    #[command(flatten)]
    stream: StreamOptions,
    #[command(flatten)]
    plan: PlanOptions,
}

impl Iso9283 {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        if self.plan.plan {
            return self.plan.run(self.json);
        }
        if let Some(table) = &self.compliance {
            return compliance(table, self.json);
        }
        match (&self.stream.stream, &self.poses, &self.commanded) {
            (Some(stream), _, commanded) => self.stream.run(stream, commanded.as_deref(), self.seed, self.json),
            (None, Some(poses), Some(commanded)) => self.poses(poses, commanded),
            _ => Err(Problems::from(Message::error("nothing to evaluate is stated")).into()),
        }
    }

    /// Characteristics of poses.
    fn poses(&self, poses: &Path, commanded: &Path) -> anyhow::Result<Verdict> {
        if self.expanded_uncertainty_um.is_some_and(|u| !(u > 0.0 && u.is_finite())) {
            return Err(Problems::from(Message::error("--expanded-uncertainty-um must be positive")).into());
        }
        for (option, limit) in [("--ap-limit-mm", self.ap_limit_mm), ("--rp-limit-mm", self.rp_limit_mm)] {
            if limit.is_some_and(|limit| !(limit > 0.0 && limit.is_finite())) {
                return Err(Problems::from(Message::error(format!("{option} must be positive"))).into());
            }
        }
        if self.drift_set.is_some_and(|size| size < 2) {
            return Err(Problems::from(Message::error("--drift-set must be at least 2")).into());
        }
        let tables = PoseTables::read(poses, commanded, self.reference.as_deref())?;
        let document = tables.test(self.rotation_order.as_deref())?.evaluate(&Settings {
            expanded_uncertainty_mm: self.expanded_uncertainty_um.map(|u| u / 1000.0),
            drift_set: self.drift_set,
            rotation_order: self.rotation_order.clone(),
            seed: self.seed,
            draws: DRAWS,
            ap_limit_mm: self.ap_limit_mm,
            rp_limit_mm: self.rp_limit_mm,
        })?;
        remark(&document.messages);
        let all = self.all || self.drift_set.is_some();
        let json = match all {
            true => to_json(&document)?,
            false => to_json(&document.poses)?,
        };
        let poses = Some(if all { document } else { document.of_poses() });
        answer(&Faces::test(&Characteristics { poses, ..Characteristics::default() }), self.json.then_some(json))
    }
}

/// Static compliance from a table of loads.
fn compliance(path: &Path, json: bool) -> anyhow::Result<Verdict> {
    let table = TableFile::read(path)?;
    let document = load::evaluate(table.named()).map_err(|p| table.place(p))?;
    remark(&document.messages);
    let json = json.then(|| to_json(&document)).transpose()?;
    answer(&Faces::test(&Characteristics { compliance: Some(document), ..Characteristics::default() }), json)
}

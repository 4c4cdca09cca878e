//! Command `etalon iso9283`.

mod plan;
mod stream;

use super::inputs::Table;
use super::table_file::TableFile;
use super::text_format::TableFormat;
use super::{Verdict, answer, check_positive, remark};
use crate::stages::iso9283::pose::PoseTables;
use crate::stages::iso9283::{limits, load};
use etalon_base::message::Problems;
use etalon_base::{error, warning};
use etalon_campaign::Limits;
use etalon_documents::{Characteristics, DecisionRule, Iso9283Document, Iso9283StreamDocument, to_json};
use etalon_report::Renderer;
use etalon_standards::iso9283::pose::{DRAWS, PoseTestSettings};
use plan::PlanOptions;
use std::path::{Path, PathBuf};
use stream::StreamOptions;

/// Evaluate accuracy, repeatability and other characteristics by ISO 9283.
///
/// `pose` evaluates attained poses, `path` a recorded motion, `compliance` a table of loads; `plan`
/// lays out a test. Tables are CSV, as described in the help of each subcommand. Without a
/// subcommand a table of attained poses is evaluated, with --commanded.
#[derive(Debug, clap::Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub struct Iso9283 {
    #[command(subcommand)]
    test: Option<Test>,
    #[command(flatten)]
    by_options: ByOptions,
}

/// Kind of a test.
#[derive(Debug, clap::Subcommand)]
enum Test {
    /// Accuracy and repeatability of poses.
    ///
    /// Tables are CSV: pose,cycle,x_mm,y_mm[,z_mm][,a_deg][,b_deg][,c_deg], with rows in the order
    /// of recording; planar robots omit z_mm. A column `approach` names directions of approach (by
    /// default the previous pose), a column `robot` several robots, a column `reading` several
    /// readings of one attained pose.
    Pose {
        /// Attained poses.
        poses: PathBuf,
        /// Commanded poses: the same columns without cycle. Without them only repeatability is
        /// evaluated.
        #[arg(long, value_name = "FILE")]
        commanded: Option<PathBuf>,
        #[command(flatten)]
        options: PoseOptions,
        #[command(flatten)]
        format: TableFormat,
        /// Seed of the bootstrap intervals.
        #[arg(long, default_value_t = 1)]
        seed: u64,
        /// Print JSON: a list with one object per pose, or one object for all other tests.
        #[arg(long)]
        json: bool,
    },
    /// Recorded motion: standstills, stabilisation, and with --path the characteristics of a path.
    Path {
        /// Recorded motion: time_s,x_mm,y_mm[,z_mm][,a_deg][,b_deg][,c_deg], or any text with
        /// stated --columns and --unit.
        stream: PathBuf,
        /// Commanded poses at the standstills.
        #[arg(long, value_name = "FILE")]
        commanded: Option<PathBuf>,
        #[command(flatten)]
        options: StreamOptions,
        /// Seed of the bootstrap intervals.
        #[arg(long, default_value_t = 1)]
        seed: u64,
        /// Print JSON.
        #[arg(long)]
        json: bool,
    },
    /// Static compliance.
    Compliance {
        /// Loads: direction,cycle,force_n,x_mm,y_mm[,z_mm]; direction +x to -z, with a row of force
        /// 0 in each cycle.
        table: PathBuf,
        #[command(flatten)]
        format: TableFormat,
        /// Print JSON.
        #[arg(long)]
        json: bool,
    },
    /// Lay out a test: cube, test plane, poses, paths, cycles.
    Plan {
        #[command(flatten)]
        options: PlanOptions,
        /// Print JSON.
        #[arg(long)]
        json: bool,
    },
}

/// Tests selected by options instead of subcommands.
#[derive(Debug, clap::Args)]
#[command(group(clap::ArgGroup::new("what").required(true).args(["poses", "stream", "compliance", "plan"])))]
struct ByOptions {
    /// Attained poses, as for `pose`.
    #[arg(conflicts_with = "workspace_mm")]
    poses: Option<PathBuf>,
    /// Commanded poses: the same columns without cycle.
    #[arg(long, value_name = "FILE")]
    commanded: Option<PathBuf>,
    #[command(flatten)]
    pose: PoseOptions,
    /// Seed of the bootstrap intervals.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Print JSON: a list with one object per pose, or one object for all other tests.
    #[arg(long)]
    json: bool,
    /// Static compliance, as for `compliance`.
    #[arg(long, value_name = "FILE")]
    compliance: Option<PathBuf>,
    /// Recorded motion, as for `path`.
    #[arg(long, value_name = "FILE")]
    stream: Option<PathBuf>,
    #[command(flatten)]
    motion: StreamOptions,
    /// Lay out a test, as for `plan`.
    #[arg(long, requires = "workspace_mm")]
    plan: bool,
    #[command(flatten)]
    layout: PlanOptions,
}

/// Options of a test of poses.
#[derive(Debug, clap::Args)]
struct PoseOptions {
    /// Expanded uncertainty (k = 2) of a measured coordinate in micrometres, for the intervals and,
    /// as that of a position, for the 25 % rule.
    #[arg(long, value_name = "UM")]
    expanded_uncertainty_um: Option<f64>,
    /// Limit of AP: conforming, not conforming or undecided by the decision rule; exit code 1
    /// unless conforming.
    #[arg(long, value_name = "MM", requires_all = ["poses", "commanded"])]
    ap_limit_mm: Option<f64>,
    /// Limit of RP, decided like that of AP.
    #[arg(long, value_name = "MM", requires = "poses")]
    rp_limit_mm: Option<f64>,
    /// Decision rule for limits.
    #[arg(long, value_enum, default_value_t, value_name = "RULE", requires = "poses")]
    decision_rule: DecisionRule,
    /// Stationary reference targets: cycle,target,x_mm,y_mm[,z_mm], measured from time to time.
    /// Positions, and angles of stated order, are compensated for drift.
    #[arg(long, value_name = "FILE", requires = "poses")]
    reference: Option<PathBuf>,
    /// Number of cycles in one set of a drift test, e.g. 10.
    #[arg(long, value_name = "CYCLES")]
    drift_set: Option<usize>,
    /// Order of the rotations a, b, c, e.g. "Rz(c) Ry(b) Rx(a)": recorded, and with --reference
    /// used to compensate angles.
    #[arg(long, value_name = "TEXT")]
    rotation_order: Option<String>,
    /// Evaluate distances, approaches, drift, exchangeability and coplanarity too; with --json one
    /// object instead of a list.
    #[arg(long)]
    all: bool,
}

impl Iso9283 {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        let by_options = self.by_options;
        match self.test {
            Some(Test::Pose { poses, commanded, options, format, seed, json }) => {
                let read = |path: &Path| format.read_poses(path);
                options.run(PoseFiles { poses: &poses, commanded: commanded.as_deref() }, &read, seed, json)
            }
            Some(Test::Path { stream, commanded, options, seed, json }) => {
                options.run(&stream, commanded.as_deref(), seed, json)
            }
            Some(Test::Compliance { table, format, json }) => compliance(format.read_other(&table)?, json),
            Some(Test::Plan { options, json }) => options.run(json),
            None => by_options.run(),
        }
    }
}

impl ByOptions {
    fn run(self) -> anyhow::Result<Verdict> {
        let commanded = self.commanded.as_deref();
        match (&self.stream, &self.compliance, &self.poses) {
            _ if self.plan => self.layout.run(self.json),
            (_, Some(table), _) => compliance(self.motion.form().read(table)?, self.json),
            (Some(stream), ..) => self.motion.run(stream, commanded, self.seed, self.json),
            (.., poses) => {
                let poses = poses.as_deref().unwrap_or(Path::new("")); // clap requires one of these
                let read = |path: &Path| self.motion.form().read(path);
                self.pose.run(PoseFiles { poses, commanded }, &read, self.seed, self.json)
            }
        }
    }
}

/// Tables of a test of poses.
struct PoseFiles<'a> {
    /// Attained poses.
    poses: &'a Path,
    /// Commanded poses.
    commanded: Option<&'a Path>,
}

impl PoseOptions {
    /// Characteristics of poses.
    fn run(
        &self,
        files: PoseFiles,
        read: &dyn Fn(&Path) -> Result<TableFile, Problems>,
        seed: u64,
        json: bool,
    ) -> anyhow::Result<Verdict> {
        let PoseFiles { poses, commanded } = files;
        self.check()?;
        let tables = PoseTables::read([Some(poses), commanded, self.reference.as_deref()], read)?;
        let document = self.evaluate(&tables, commanded.is_some(), seed)?;
        remark(&document.messages);
        let all = self.all || self.drift_set.is_some();
        let data = match all {
            true => to_json(&document)?,
            false => to_json(&document.poses)?,
        };
        let poses = Some(if all { document } else { document.keep_pose_characteristics() });
        answer(&Renderer::test(&Characteristics { poses, ..Characteristics::default() }), json.then_some(data))
    }

    fn check(&self) -> Result<(), Problems> {
        check_positive("--expanded-uncertainty-um", self.expanded_uncertainty_um)?;
        check_positive("--ap-limit-mm", self.ap_limit_mm)?;
        check_positive("--rp-limit-mm", self.rp_limit_mm)?;
        if self.drift_set.is_some_and(|size| size < 2) {
            return Err(error!("drift-set-too-small", option = "--drift-set").into());
        }
        Ok(())
    }

    /// The answer from tables that are read.
    fn evaluate(&self, tables: &PoseTables, commanded: bool, seed: u64) -> Result<Iso9283Document, Problems> {
        let mut document = tables.test(self.rotation_order.as_deref())?.evaluate(&PoseTestSettings {
            expanded_uncertainty_mm: self.expanded_uncertainty_um.map(|u| u / 1000.0),
            drift_set: self.drift_set,
            rotation_order: self.rotation_order.clone(),
            seed,
            draws: DRAWS,
            ap_limit_mm: self.ap_limit_mm,
            rp_limit_mm: self.rp_limit_mm,
            position_uncertainty_mm: None,
            decision_rule: self.decision_rule.into(),
        })?;
        let stated = Limits {
            accuracy_max_mm: self.ap_limit_mm,
            repeatability_max_mm: self.rp_limit_mm,
            decision_rule: Some(self.decision_rule),
            ..Limits::default()
        };
        // a pose without such a value is undecided
        document.limits = limits(&stated, &document.poses).unwrap_or_default();
        if !commanded {
            document.messages.push(warning!("commanded-missing"));
        }
        Ok(document)
    }
}

impl Iso9283 {
    /// Evaluates `pose` from tables in memory: attained poses, commanded poses, reference targets.
    pub(super) fn poses_in_memory(
        &self,
        attained: &Table,
        commanded: Option<&Table>,
        reference: Option<&Table>,
    ) -> Result<Iso9283Document, Problems> {
        let ByOptions { pose, seed, .. } = &self.by_options;
        pose.check()?;
        let parse = |table: Option<&Table>| table.map(Table::parse).transpose();
        let tables = PoseTables::new(attained.parse()?, parse(commanded)?, parse(reference)?);
        pose.evaluate(&tables, commanded.is_some(), *seed)
    }

    /// The answer of `path` from tables in memory: a recording, commanded poses, a commanded path.
    pub(super) fn path_in_memory(
        &self,
        recording: &Table,
        commanded: Option<&Table>,
        path: Option<&Table>,
    ) -> Result<Iso9283StreamDocument, Problems> {
        let ByOptions { motion, seed, .. } = &self.by_options;
        motion.in_memory(recording, commanded, path, *seed)
    }
}

/// Evaluates static compliance from a table of loads.
fn compliance(table: TableFile, json: bool) -> anyhow::Result<Verdict> {
    let document = load::evaluate(&table.table).map_err(|p| table.place(p))?;
    remark(&document.messages);
    let json = json.then(|| to_json(&document)).transpose()?;
    answer(&Renderer::test(&Characteristics { compliance: Some(document), ..Characteristics::default() }), json)
}

//! Command `etalon iso9283`.

mod plan;
mod stream;

use super::{Output, Verdict};
use crate::stages::iso9283::load;
use crate::stages::table_file::TableFile;
use crate::tasks::{PoseOptions, Table, TableFormat, TestTables, iso9283};
use etalon_base::message::Message;
use etalon_documents::{Characteristics, to_json};
use etalon_report::Renderer;
use plan::PlanOptions;
use std::path::{Path, PathBuf};
use stream::Motion;

/// Evaluate accuracy, repeatability and other characteristics to ISO 9283.
///
/// `pose` evaluates attained poses, `path` a recorded motion, `compliance` a table of loads; `plan`
/// creates a test. Tables are CSV, as described in the help of each subcommand. Without a
/// subcommand, a table of attained poses is evaluated with --commanded.
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
    /// of recording; planar robots omit z_mm. A column `approach` contains the direction of
    /// approach; by default the direction is the previous pose. A column `robot` distinguishes
    /// several robots, a column `reading` several readings of one attained pose.
    Pose {
        /// Attained poses.
        poses: PathBuf,
        /// Commanded poses: the same columns without cycle. Without them only repeatability is
        /// evaluated.
        #[arg(long, value_name = "FILE")]
        commanded: Option<PathBuf>,
        #[command(flatten)]
        test: PoseTest,
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
        /// --columns, and with --unit if the file does not contain its unit.
        stream: PathBuf,
        /// Commanded poses at the standstills.
        #[arg(long, value_name = "FILE")]
        commanded: Option<PathBuf>,
        #[command(flatten)]
        motion: Motion,
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
    pose: PoseTest,
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
    motion: Motion,
    /// Lay out a test, as for `plan`.
    #[arg(long, requires = "workspace_mm")]
    plan: bool,
    #[command(flatten)]
    layout: PlanOptions,
}

/// Options and files of a test of poses.
#[derive(Debug, clap::Args)]
struct PoseTest {
    #[command(flatten)]
    options: PoseOptions,
    /// Stationary reference targets: cycle,target,x_mm,y_mm[,z_mm], measured from time to time.
    /// Positions are compensated for drift, and so are angles if their order is given.
    #[arg(long, value_name = "FILE", requires = "poses")]
    reference: Option<PathBuf>,
    /// Evaluate distances, approaches, drift, exchangeability and coplanarity too; with --json one
    /// object instead of a list.
    #[arg(long)]
    all: bool,
}

impl Iso9283 {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        let by_options = self.by_options;
        match self.test {
            Some(Test::Pose { poses, commanded, test, format, seed, json }) => {
                let files = PoseFiles { poses: &poses, commanded: commanded.as_deref() };
                test.evaluate(files, &format, seed)?.print(json, out)
            }
            Some(Test::Path { stream, commanded, motion, seed, json }) => {
                motion.evaluate(&stream, commanded.as_deref(), seed)?.print(json, out)
            }
            Some(Test::Compliance { table, format, json }) => {
                compliance(format.read_other(Table::File(&table))?)?.print(json, out)
            }
            Some(Test::Plan { options, json }) => options.run(json, out),
            None => by_options.run(out),
        }
    }
}

impl ByOptions {
    fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        if self.plan {
            return self.layout.run(self.json, out);
        }
        let (form, commanded) = (self.motion.options.text.form(), self.commanded.as_deref());
        let evaluated = match (&self.stream, &self.compliance, &self.poses) {
            (_, Some(table), _) => compliance(form.read(Table::File(table))?)?,
            (Some(stream), ..) => self.motion.evaluate(stream, commanded, self.seed)?,
            (.., poses) => {
                let poses = poses.as_deref().unwrap_or(Path::new("")); // clap requires one of these
                self.pose.evaluate(PoseFiles { poses, commanded }, &form.into(), self.seed)?
            }
        };
        evaluated.print(self.json, out)
    }
}

/// Characteristics of a test.
struct Evaluated {
    messages: Vec<Message>,
    tested: Characteristics,
    json: Vec<u8>,
}

impl Evaluated {
    fn print(self, json: bool, out: &Output) -> anyhow::Result<Verdict> {
        out.remark(&self.messages);
        out.answer(&Renderer::test(&self.tested), json.then_some(self.json))
    }
}

impl PoseTest {
    /// Characteristics of poses.
    fn evaluate(&self, files: PoseFiles, format: &TableFormat, seed: u64) -> anyhow::Result<Evaluated> {
        let tables = TestTables {
            attained: Table::File(files.poses),
            commanded: files.commanded.map(Table::File),
            reference: self.reference.as_deref().map(Table::File),
        };
        let document = iso9283(&tables, format, &self.options, seed)?;
        let messages = document.messages.clone();
        let all = self.all || self.options.drift_set.is_some();
        let json = match all {
            true => to_json(&document)?,
            false => to_json(&document.poses)?,
        };
        let poses = Some(if all { document } else { document.keep_pose_characteristics() });
        Ok(Evaluated { messages, tested: Characteristics { poses, ..Characteristics::default() }, json })
    }
}

/// Files of a test of poses.
struct PoseFiles<'a> {
    /// Attained poses.
    poses: &'a Path,
    /// Commanded poses.
    commanded: Option<&'a Path>,
}

/// Evaluates static compliance from a table of loads.
fn compliance(table: TableFile) -> anyhow::Result<Evaluated> {
    let document = load::evaluate(&table.table).map_err(|p| table.place(p))?;
    let (messages, json) = (document.messages.clone(), to_json(&document)?);
    Ok(Evaluated {
        messages,
        tested: Characteristics { compliance: Some(document), ..Characteristics::default() },
        json,
    })
}

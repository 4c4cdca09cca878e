//! Command `etalon benchmark`.

use super::kinematics::cell;
use super::{Output, Verdict};
use crate::run::documents::read_parameters;
use crate::tasks::benchmark::TURN;
use crate::tasks::{Inputs, Table, predict, score};
use etalon_base::catalogue::Phrase;
use etalon_base::files;
use etalon_base::phrase;
use etalon_campaign::read_robot;
use etalon_documents::{BenchmarkScoreDocument, PredictionsDocument, QuantityScore, to_json};
use etalon_formats::table::{COVARIANCES, QUATERNION, XYZ};
use std::path::PathBuf;

/// Predict measurements with identified parameters, and score the predictions of any program.
///
/// A benchmark of robot calibration compares programs on poses that none of them has seen:
/// docs/benchmark.md.
#[derive(Debug, clap::Args)]
pub struct Benchmark {
    #[command(subcommand)]
    command: Step,
}

#[derive(Debug, clap::Subcommand)]
enum Step {
    Predict(Predict),
    Score(Score),
}

/// Predict the measurements at joint values, with their covariance.
#[derive(Debug, clap::Args)]
#[command(after_help = "Table: pose, target and the joints (q1_deg or q1_rad, lift_m ...)

Answer:
  pose, target, x_mm, y_mm, z_mm   predicted position in the world of the calibration
  cxx_mm2 to czz_mm2               covariance of the difference from a measured position: parameters, model, instrument
  qw, qx, qy, qz                   orientation, if the calibration observed orientations
  urot_deg                         standard uncertainty of the difference from a measured orientation about any axis

Beyond the measured values of a joint, covariances grow with the distance.")]
struct Predict {
    /// Table of joint values (CSV).
    table: PathBuf,
    /// Robot file.
    #[arg(long, value_name = "FILE")]
    robot: PathBuf,
    /// Identified parameters.
    #[arg(long, value_name = "FILE")]
    parameters: PathBuf,
    /// Print the answer as JSON.
    #[arg(long)]
    json: bool,
}

/// Score predictions against measured values.
#[derive(Debug, clap::Args)]
#[command(after_help = "Tables: pose, target, x_mm, y_mm, z_mm, and qw, qx, qy, qz if the orientation is measured.
Predictions may state uncertainties of the difference from a measured value:
  cxx_mm2, cxy_mm2, cxz_mm2, cyy_mm2, cyz_mm2, czz_mm2   covariance of the position
  ux_mm, uy_mm, uz_mm, or u_mm                           standard uncertainties of the coordinates
  x_low_mm, x_high_mm, y_low_mm ... z_high_mm            ends of 95 % intervals
  urot_deg                                               standard uncertainty of the orientation about any axis

Errors: mean, root mean square, 95th percentile, maximum.
Intervals (95 %): share of measured values inside, mean width, and mean interval score (Gneiting & Raftery 2007).
A smaller score is better. `--json` adds the standard uncertainty of the share, from pose to pose, and its exact interval.")]
struct Score {
    /// Predictions (CSV).
    predictions: PathBuf,
    /// Measured values (CSV).
    #[arg(long, value_name = "FILE")]
    truth: PathBuf,
    /// Print the answer as JSON.
    #[arg(long)]
    json: bool,
}

impl Benchmark {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        match self.command {
            Step::Predict(command) => command.run(out),
            Step::Score(command) => command.run(out),
        }
    }
}

impl Predict {
    fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        let robot = &read_robot(&self.robot)?;
        let document = read_parameters(&self.parameters)?;
        let inputs = Inputs { robot, stated: Table::File(&self.robot), table: Table::File(&self.table) };
        let mut found = predict(&inputs, &document)?;
        found.provenance.inputs.extend(files::sha256_by_name([&self.parameters])?);
        out.print(if self.json { to_json(&found)? } else { table(&found).into_bytes() })?;
        Ok(Verdict::Met)
    }
}

/// Predictions as a table that `score` reads.
fn table(document: &PredictionsDocument) -> String {
    let is_turned = document.predictions.iter().any(|p| p.orientation.is_some());
    let turned = QUATERNION.into_iter().chain([TURN]).filter(|_| is_turned);
    let names = ["pose", "target"].into_iter().chain(XYZ).chain(COVARIANCES).chain(turned);
    let mut out = names.collect::<Vec<_>>().join(",") + "\n";
    for p in &document.predictions {
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = p.covariance_mm2;
        let body = p.orientation.map(|body| [&body.quaternion[..], &[body.standard_uncertainty_deg]].concat());
        out += &format!("{},{}", cell(&p.pose.to_string()), cell(&p.target));
        let values = [&p.xyz_mm[..], &[xx, xy, xz, yy, yz, zz], body.as_deref().unwrap_or_default()].concat();
        values.iter().for_each(|v| out += &format!(",{v:?}"));
        out.push('\n');
    }
    out
}

impl Score {
    fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        let found = score(Table::File(&self.predictions), Table::File(&self.truth))?;
        out.print(if self.json { to_json(&found)? } else { text(&found).into_bytes() })?;
        Ok(Verdict::Met)
    }
}

fn text(document: &BenchmarkScoreDocument) -> String {
    let heads = [
        phrase!("benchmark-mean"),
        phrase!("benchmark-rms"),
        phrase!("benchmark-p95"),
        phrase!("benchmark-max"),
        phrase!("benchmark-coverage"),
        phrase!("benchmark-width"),
        phrase!("benchmark-score"),
    ];
    let mut out = format!("{:<16}", phrase!("benchmark-counts", poses = document.poses).to_string());
    heads.into_iter().for_each(|head| out += &format!("{:>12}", head.to_string()));
    out.push('\n');
    let position = (phrase!("benchmark-position"), &document.position);
    let orientation = document.orientation.as_ref().map(|found| (phrase!("benchmark-orientation"), found));
    for (name, found) in [position].into_iter().chain(orientation) {
        out += &row(&name, found);
    }
    out
}

fn row(name: &Phrase, found: &QuantityScore) -> String {
    let errors = found.errors;
    let mut out = format!("{:<16}", format!("{name}, {}", found.unit));
    [errors.mean, errors.rms, errors.p95, errors.max].into_iter().for_each(|v| out += &format!("{v:>12.4}"));
    if let Some(i) = found.intervals {
        out += &format!("{:>10.1} %{:>12.4}{:>12.4}", 100.0 * i.coverage, i.mean_width, i.mean_score);
    }
    out + "\n"
}

//! `etalon iso9283`

mod plan;
mod stream;

use super::table_file::TableFile;
use super::{Verdict, print, say};
use crate::base::message::{Message, Problems};
use crate::document::{Iso9283ComplianceDocument, Iso9283Conformity, Iso9283Document, Iso9283Interval, Iso9283Pose};
use crate::iso9283::pose::{DRAWS, Settings};
use crate::run::output;
use crate::stages::iso9283::load;
use crate::stages::iso9283::pose::PoseTables;
use plan::PlanOptions;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use stream::StreamOptions;
pub(super) use stream::as_text as stream_as_text;

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
    /// Expanded uncertainty of a measured position in micrometres, for the 25 % rule; exit code 1 if it is not met
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
            (Some(stream), _, commanded) => self.stream.run(stream, commanded.as_deref(), (self.seed, self.json)),
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
        for message in &document.messages {
            say(format_args!("{message}\n"));
        }
        match (self.json, self.all || self.drift_set.is_some()) {
            (true, true) => print(output::to_json(&document)?)?,
            (true, false) => print(output::to_json(&document.poses)?)?,
            (false, all) => print(as_text(&document, all))?,
        }
        let proved = |c: Option<Iso9283Conformity>| c.is_none_or(|c| c == Iso9283Conformity::Conforming);
        let met =
            |p: &Iso9283Pose| p.quarter_rule_met != Some(false) && proved(p.ap_conformity) && proved(p.rp_conformity);
        let met = document.poses.iter().all(met);
        Ok(if met { Verdict::Met } else { Verdict::LimitNotMet })
    }
}

/// A table of the poses; with `all`, the other characteristics.
pub(super) fn as_text(document: &Iso9283Document, all: bool) -> String {
    let interval = |i: &Option<Iso9283Interval>| i.map(|i| format!(" [{:.4}, {:.4}]", i.low_mm, i.high_mm));
    let number = |v: Option<f64>| v.map_or_else(|| "-".to_owned(), |v| format!("{v:.4}"));
    let mut text = format!(
        "{:>5} {:>6} {:>28} {:>28} {:>9} {:>9} {:>9}\n",
        "pose", "cycles", "AP mm [95 %]", "RP mm [95 %]", "mean l", "sd l", "enclosing"
    );
    for p in &document.poses {
        let ap = number(p.ap_mm) + &interval(&p.ap_interval).unwrap_or_default();
        let rp = number(p.rp_mm) + &interval(&p.rp_interval).unwrap_or_default();
        let (mean, sd, ball) = (number(p.mean_radius_mm), number(p.sd_radius_mm), number(p.enclosing_radius_mm));
        let _ = writeln!(text, "{:>5} {:>6} {ap:>28} {rp:>28} {mean:>9} {sd:>9} {ball:>9}", p.pose, p.cycles);
        for (name, proved) in [("AP", p.ap_conformity), ("RP", p.rp_conformity)] {
            let words = match proved {
                None => continue,
                Some(Iso9283Conformity::Conforming) => "conforming",
                Some(Iso9283Conformity::NotConforming) => "not conforming",
                Some(Iso9283Conformity::Neither) => "undecided: the limit is within the interval",
            };
            let _ = writeln!(text, "      {name} against its limit: {words}");
        }
        if let Some(rp) = p.rp_without_noise_mm {
            let _ = writeln!(text, "      RP without the instrument's noise {rp:.4} mm");
        }
        if let Some(met) = p.quarter_rule_met {
            let (ap, rp) = (number(p.uncertainty_over_ap), number(p.uncertainty_over_rp));
            let verdict = if met { "met" } else { "not met" };
            let _ = writeln!(text, "      25 % rule {verdict}: uncertainty over AP {ap}, over RP {rp}");
        }
    }
    if !all {
        return text;
    }
    for d in &document.distances {
        let _ = writeln!(text, "distance {} to {}: AD {:.4}, RD {:.4} mm", d.poses[0], d.poses[1], d.ad_mm, d.rd_mm);
    }
    for v in &document.approaches {
        let [a, b] = &v.between;
        let _ = writeln!(text, "pose {} by approach: vAP {:.4} mm, between `{a}` and `{b}`", v.pose, v.vap_mm);
    }
    for d in &document.drifts {
        let _ = writeln!(
            text,
            "pose {} drift: dAP {:.4}, dRP {:.4} mm in {} sets",
            d.pose,
            d.dap_mm,
            d.drp_mm,
            d.ap_mm.len()
        );
    }
    for p in &document.coplanarity_of_four {
        let _ = writeln!(text, "pose {} is {:.4} mm out of the plane of the other three", p.pose, p.distance_mm);
    }
    if let Some(homing) = &document.homing {
        let _ = writeln!(text, "homing, {} times: RP {} mm", homing.cycles, number(homing.rp_mm));
    }
    for e in &document.reference {
        let _ = writeln!(
            text,
            "reference targets of cycle {}: moved by {:.4} mm, {:.4} mm left",
            e.cycle, e.moved_mm, e.rms_mm
        );
    }
    for (name, value) in
        [("exchangeability", document.exchangeability_mm), ("coplanarity of means", document.coplanarity_mm)]
    {
        if let Some(value) = value {
            let _ = writeln!(text, "{name}: {value:.4} mm");
        }
    }
    text
}

/// Static compliance from a table of loads.
fn compliance(path: &Path, json: bool) -> anyhow::Result<Verdict> {
    let table = TableFile::read(path)?;
    let document = load::evaluate(table.named()).map_err(|p| table.place(p))?;
    for message in &document.messages {
        say(format_args!("{message}\n"));
    }
    print(if json { output::to_json(&document)? } else { compliance_as_text(&document).into_bytes() })?;
    Ok(Verdict::Met)
}

/// A line for each direction.
pub(super) fn compliance_as_text(document: &Iso9283ComplianceDocument) -> String {
    let mut text = String::new();
    for d in &document.directions {
        let u = d.standard_uncertainty_mm_n.map(|u| format!(" (u = {u:.1e})")).unwrap_or_default();
        let _ = writeln!(
            text,
            "{}: {:.6} mm/N{u} up to {} N, off the line {:.4} mm, {} readings in {} cycles",
            d.direction, d.compliance_mm_n, d.force_n, d.off_line_mm, d.readings, d.cycles
        );
    }
    text
}

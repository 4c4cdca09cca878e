//! Task of `etalon iso9283 pose`.

use super::checks::{check_expanded, check_positive, needs};
use super::inputs::Table;
use super::text_format::TableFormat;
use crate::stages::iso9283::assessed_limits;
use crate::stages::iso9283::pose::{PoseTables, parse_order};
use etalon_base::message::Result;
use etalon_base::{error, warning};
use etalon_campaign::Limits;
use etalon_documents::{DecisionRule, Iso9283Document};
use etalon_standards::iso9283::pose::{DRAWS, PoseTestSettings};
use serde::Deserialize;

/// Options of a test of poses.
#[derive(Clone, Debug, Default, clap::Args, Deserialize)]
#[serde(default)]
pub struct PoseOptions {
    /// Expanded uncertainty (k = 2) of a measured coordinate in micrometres, for the intervals, and
    /// for the 25 % rule as the uncertainty of a position.
    #[arg(long, value_name = "UM")]
    pub expanded_uncertainty_um: Option<f64>,
    /// Limit of AP: conforming, not conforming or undecided by the decision rule; exit code 1
    /// unless conforming.
    #[arg(long, value_name = "MM", requires_all = ["poses", "commanded"])]
    pub ap_limit_mm: Option<f64>,
    /// Limit of RP, decided like the limit of AP.
    #[arg(long, value_name = "MM", requires = "poses")]
    pub rp_limit_mm: Option<f64>,
    /// Decision rule for limits.
    #[arg(long, value_enum, default_value_t, value_name = "RULE", requires = "poses")]
    pub decision_rule: DecisionRule,
    /// Number of cycles in one set of a drift test, e.g. 10.
    #[arg(long, value_name = "CYCLES")]
    pub drift_set: Option<usize>,
    /// Order of the rotations a, b, c, e.g. "Rz(c) Ry(b) Rx(a)", multiplied from left to right:
    /// angles that are not separable become rotation vectors; --reference also compensates angles.
    #[arg(long, value_name = "TEXT")]
    pub rotation_order: Option<String>,
}

/// Tables of a test of poses.
#[derive(Clone, Copy, Debug)]
pub struct TestTables<'a> {
    /// Attained poses.
    pub attained: Table<'a>,
    /// Commanded poses; without them only repeatability is evaluated.
    pub commanded: Option<Table<'a>>,
    /// Stationary reference targets.
    pub reference: Option<Table<'a>>,
}

/// Evaluates attained poses (ISO 9283); `seed` is the seed of the bootstrap intervals.
///
/// # Errors
/// Fails if the tables do not belong together.
pub fn iso9283(tables: &TestTables, format: &TableFormat, options: &PoseOptions, seed: u64) -> Result<Iso9283Document> {
    options.check(tables)?;
    let [commanded, reference] =
        [tables.commanded, tables.reference].map(|table| table.map(|table| format.read_beside(table)).transpose());
    let (commanded, reference) = (commanded?, reference?);
    let read = PoseTables::new(format.read_poses(tables.attained)?, commanded, reference);
    let order = options.rotation_order.as_deref().map(parse_order).transpose()?;
    let mut document = read.test(order)?.evaluate(&PoseTestSettings {
        expanded_uncertainty_mm: options.expanded_uncertainty_um.map(|u| u / 1000.0),
        drift_set: options.drift_set,
        rotation_order: options.rotation_order.clone(),
        seed,
        draws: DRAWS,
        ap_limit_mm: options.ap_limit_mm,
        rp_limit_mm: options.rp_limit_mm,
        position_uncertainty_mm: None,
        decision_rule: options.decision_rule.into(),
    })?;
    let stated = Limits {
        accuracy_max_mm: options.ap_limit_mm,
        repeatability_max_mm: options.rp_limit_mm,
        decision_rule: Some(options.decision_rule),
        ..Limits::default()
    };
    document.limits = assessed_limits(&stated, &document.poses);
    if tables.commanded.is_none() {
        document.messages.push(warning!("commanded-missing"));
    }
    Ok(document)
}

impl PoseOptions {
    fn check(&self, tables: &TestTables) -> Result<()> {
        check_positive("--expanded-uncertainty-um", self.expanded_uncertainty_um)?;
        check_expanded("--expanded-uncertainty-um", self.expanded_uncertainty_um)?;
        check_positive("--ap-limit-mm", self.ap_limit_mm)?;
        check_positive("--rp-limit-mm", self.rp_limit_mm)?;
        if self.ap_limit_mm.is_some() && tables.commanded.is_none() {
            return Err(needs("ap_limit_mm", "commanded"));
        }
        if self.drift_set.is_some_and(|size| size < 2) {
            return Err(error!("drift-set-too-small", option = "--drift-set").into());
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_documents::{Acceptance, Conformity, LimitQuantity};

    const COMMANDED: Table = Table::Text {
        name: "commanded",
        text: "pose,x_mm,y_mm,z_mm\n1,400,100,350\n2,500,200,450\n3,300,250,250\n4,350,-80,300\n",
    };

    fn evaluated(attained: Table, options: &PoseOptions) -> Result<Iso9283Document> {
        let tables = TestTables { attained, commanded: Some(COMMANDED), reference: None };
        iso9283(&tables, &TableFormat::default(), options, 1)
    }

    #[test]
    fn headings_of_one_table_do_not_apply_to_the_other() {
        let text = "pose,cycle,x_mm,y_mm,z_mm\n1,1,0.4001,0.1,0.35\n2,1,0.5001,0.2,0.45\n3,1,0.3001,0.25,0.25\n4,1,0.3501,-0.08,0.3\n";
        let table = Table::Text { name: "attained", text };
        let refused = evaluated(table, &PoseOptions::default()).unwrap_err();
        assert!(refused.0[0].is("positions-in-other-unit", &[("table", &"attained"), ("unit", &"m")]), "{refused}");
        let columns = ["x_m=x_mm", "y_m=y_mm", "z_m=z_mm"].map(str::to_owned);
        let headed = Table::Headed { table: &table, columns: &columns };
        let found = evaluated(headed, &PoseOptions::default()).unwrap();
        assert!(found.poses.iter().all(|p| (p.ap_mm.unwrap() - 0.1).abs() < 1e-9), "{:?}", found.poses);
        assert_eq!(headed.name(), "attained");
    }

    #[test]
    fn a_limit_without_a_value_is_undecided() {
        let text =
            "pose,cycle,x_mm,y_mm,z_mm\n1,1,400.1,100,350\n2,1,500.1,200,450\n3,1,300.1,250,250\n4,1,350.1,-80,300\n";
        let options = PoseOptions { ap_limit_mm: Some(0.5), rp_limit_mm: Some(0.01), ..PoseOptions::default() };
        let found = evaluated(Table::Text { name: "attained", text }, &options).unwrap();
        let by_name = |name| found.limits.iter().find(|limit| limit.name == name).unwrap();
        let (ap, rp) = (by_name(LimitQuantity::AccuracyMaxMm), by_name(LimitQuantity::RepeatabilityMaxMm));
        assert_eq!((rp.conformity, rp.value), (Conformity::NotAssessable, None));
        // one cycle has no interval
        assert_eq!((ap.conformity, ap.acceptance), (Conformity::Neither, Acceptance::Undecided));
        let warned = |message: &etalon_base::message::Message| message.is("limits-without-instrument", &[]);
        assert!(found.messages.iter().any(warned));
    }
}

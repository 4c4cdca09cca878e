//! Tests of a campaign to ISO 9283: from tables, labelled points and recorded motions to
//! characteristics.

pub mod load;
pub mod pose;
pub mod repeatability;
pub mod stated;
mod streams;

use crate::stages::gather::Gathered;
use crate::stages::table_file::CampaignTables;
use etalon_base::error;
use etalon_base::message::{Problems, Result};
use etalon_base::phrase;
use etalon_base::pose::Pose;
use etalon_campaign::{Campaign, Limits, PosesDefinition, TableDefinition};
use etalon_documents::*;
use etalon_standards::iso9283::pose::{DRAWS, PoseTestSettings};
use pose::{PoseTables, PreparedTest, parse_order};
use repeatability::Commanded;
use toml::Spanned;

/// Coverage factor of the expanded uncertainty in the 25 % rule.
pub(crate) const COVERAGE_FACTOR: f64 = 2.0;
/// Default seed of the bootstrap: intervals are the same on every run.
const SEED: u64 = 1;

/// Tables and recordings of the tests of a campaign, read once.
#[derive(Clone, Debug, Default)]
pub struct TestData {
    /// `[poses]`.
    poses: Option<PreparedTest>,
    /// `commanded` of `[repeatability]`.
    commanded: Option<Commanded>,
    /// `[[stream]]`, in their order.
    streams: Vec<streams::Ready>,
    /// `[compliance]`, evaluated.
    compliance: Option<Iso9283ComplianceDocument>,
    /// The files that were read.
    pub sources: Vec<Source>,
}

/// Reads the tables and recordings of all tests, and reports all errors in them and in their
/// statements. Labels are not checked.
pub fn read(campaign: &Campaign) -> (TestData, Problems) {
    let file = &campaign.file;
    let mut problems = drift_sets(campaign);
    let mut files = CampaignTables { campaign, sources: Vec::new() };
    let mut data = TestData::default();
    if let Some(commanded) = file.repeatability.as_ref().and_then(|labelled| labelled.commanded.as_ref()) {
        data.commanded = problems.keep(Commanded::read(&mut files, commanded));
    }
    // a file that is not named is reported already
    let named = |definition: &&PosesDefinition| {
        [&definition.attained, &definition.commanded].into_iter().all(TableDefinition::is_named)
    };
    if let Some(definition) = file.poses.as_ref().filter(named) {
        data.poses = problems.keep(read_poses(&mut files, definition));
    }
    let (streams, more) = streams::read(&mut files);
    problems.0.extend(more.0);
    data.streams = streams;
    if let Some(definition) = file.compliance.as_ref().filter(|definition| definition.is_named()) {
        let table = files.read(definition, SourceKind::Table, phrase!("table-of-compliance"));
        let found = table.and_then(|table| load::evaluate(&table.table).map_err(|p| table.place(p)));
        data.compliance = problems.keep(found);
    }
    data.sources = files.sources;
    (data, problems)
}

/// Evaluates all tests of a campaign.
pub fn evaluate(
    campaign: &Campaign,
    data: &TestData,
    gathered: &Gathered,
    frames: &FramesDocument,
) -> Result<Characteristics> {
    let mut poses = match (&data.poses, &campaign.file.poses, &campaign.file.repeatability) {
        (Some(attained), Some(definition), _) => Some(evaluate_prepared(attained, definition, settings(campaign))?),
        (None, _, Some(labelled)) => {
            Some(repeatability::evaluate(campaign, labelled, &gathered.points, data.commanded.as_ref(), frames)?)
        }
        _ => None,
    };
    if let Some(document) = &mut poses {
        document.limits = judged(campaign, &document.poses)?;
    }
    let streams = streams::evaluate_all(campaign, &data.streams)?;
    Ok(Characteristics { poses, streams, compliance: data.compliance.clone() })
}

/// Errors of the labels of `[repeatability]`; they do not depend on the world frame.
pub fn label_problems(campaign: &Campaign, data: &TestData, gathered: &Gathered) -> Problems {
    let Some(labelled) = &campaign.file.repeatability else { return Problems::default() };
    let commanded = data.commanded.as_ref();
    let found = repeatability::gather(campaign, labelled, &gathered.points, commanded, &Pose::identity());
    found.err().unwrap_or_default()
}

/// Errors in the statements on drift.
fn drift_sets(campaign: &Campaign) -> Problems {
    let file = &campaign.file;
    let mut problems = Problems::default();
    let mut check = |size: &Option<Spanned<usize>>, commanded: bool| {
        let Some(size) = size else { return };
        if *size.get_ref() < 2 {
            problems.0.push(error!("drift-set-too-small", option = "`drift_set`").at(campaign.place(size)));
        }
        if !commanded {
            problems.0.push(error!("drift-without-commanded").at(campaign.place(size)));
        }
    };
    if let Some(labelled) = &file.repeatability {
        check(&labelled.drift_set, labelled.commanded.is_some());
    }
    if let Some(definition) = &file.poses {
        check(&definition.drift_set, true);
        if file.repeatability.is_some() {
            problems.0.push(error!("attained-poses-twice").at(campaign.place(definition.attained.first())));
        }
    }
    problems
}

/// The attained poses of `[poses]`, and whether they can be evaluated and judged.
fn read_poses(files: &mut CampaignTables, definition: &PosesDefinition) -> Result<PreparedTest> {
    let campaign = files.campaign;
    let order = definition.rotation_order.as_deref().map(parse_order).transpose();
    let order = order.map_err(|problems| problems.at(&campaign.key_place(&["poses", "rotation_order"])))?;
    let attained = PoseTables::from_campaign(files, definition)?.test(order)?;
    // a set of one cycle is an error of its own
    if let Some(set) = definition.drift_set.as_ref().filter(|set| *set.get_ref() > 1) {
        attained.drifts(*set.get_ref()).map_err(|more| more.at(&campaign.place(set)))?;
    }
    let found = evaluate_prepared(&attained, definition, PoseTestSettings { draws: 0, ..settings(campaign) })?;
    judged(campaign, &found.poses)?;
    Ok(attained)
}

fn evaluate_prepared(
    attained: &PreparedTest,
    definition: &PosesDefinition,
    settings: PoseTestSettings,
) -> Result<Iso9283Document> {
    let mut document = attained.evaluate(&PoseTestSettings {
        drift_set: definition.drift_set.as_ref().map(|set| *set.get_ref()),
        rotation_order: definition.rotation_order.clone(),
        seed: definition.seed,
        ..settings
    })?;
    document.agree(phrase!("convention-tables", k = COVERAGE_FACTOR));
    document.recorded.visits = attained.visits();
    Ok(document)
}

/// Settings of the campaign for all tests of poses.
fn settings(campaign: &Campaign) -> PoseTestSettings {
    let instrument = &campaign.file.instrument;
    PoseTestSettings {
        expanded_uncertainty_mm: Some(COVERAGE_FACTOR * instrument.standard_uncertainty_mm()),
        position_uncertainty_mm: instrument.position_uncertainty_mm().map(|u| COVERAGE_FACTOR * u),
        drift_set: None,
        rotation_order: None,
        seed: SEED,
        draws: DRAWS,
        ap_limit_mm: campaign.file.limits.accuracy_max_mm,
        rp_limit_mm: campaign.file.limits.repeatability_max_mm,
        decision_rule: campaign.file.limits.decision_rule.unwrap_or_default().into(),
    }
}

/// The limits of the campaign, judged.
fn judged(campaign: &Campaign, poses: &[Iso9283Pose]) -> Result<Vec<LimitVerdict>> {
    limits(&campaign.file.limits, poses).map_err(|problems| problems.at(&campaign.key_place(&["limits"])))
}

/// Limits of the largest values: the decision of the rule on every pose.
///
/// # Errors
/// Fails if a pose has no value of a limited characteristic.
fn limits(limits: &Limits, poses: &[Iso9283Pose]) -> Result<Vec<LimitVerdict>> {
    PoseCharacteristic::ALL.iter().filter_map(|of| verdict(of, limits, poses)).collect()
}

/// Limits of the largest values; a limit without a value at some pose is not assessable.
pub fn assessed_limits(limits: &Limits, poses: &[Iso9283Pose]) -> Vec<LimitVerdict> {
    let rule = limits.decision_rule.unwrap_or_default();
    let assessed = |of: &PoseCharacteristic| {
        let found = verdict(of, limits, poses)?;
        Some(found.unwrap_or_else(|_| {
            LimitVerdict::not_assessable(of.limit, limits.limit(of.limit).unwrap_or(f64::NAN), rule)
        }))
    };
    PoseCharacteristic::ALL.iter().filter_map(assessed).collect()
}

/// Verdict on the limit of a characteristic, if it has one and a pose was measured.
fn verdict(of: &PoseCharacteristic, limits: &Limits, poses: &[Iso9283Pose]) -> Option<Result<LimitVerdict>> {
    let (name, rule) = (of.limit, limits.decision_rule.unwrap_or_default());
    let limit = limits.limit(name)?;
    if let Some(without) = poses.iter().find(|p| (of.value)(p).is_none()) {
        let message = error!("limit-without-value", limit = name.to_string(), pose = without.pose);
        return Some(Err(message.into()));
    }
    let largest = |p: &&Iso9283Pose| (of.value)(p).unwrap_or(0.0);
    let worst = poses.iter().max_by(|a, b| largest(a).total_cmp(&largest(b)))?;
    let value = largest(&worst);
    let interval = (of.interval)(worst);
    let expanded = interval.map(|i| i.high_mm - value);
    let conformity = Conformity::combine(poses.iter().filter_map(of.conformity));
    let judged = LimitVerdict::judge(name, limit, value, expanded, rule).with(conformity);
    let judged = match interval {
        Some(interval) => judged.within_interval(interval.low_mm, interval.high_mm),
        None => judged,
    };
    // no probability follows from an interval that contains a drift
    Some(Ok(if (of.drifts)(worst) { judged.without_coverage() } else { judged }))
}

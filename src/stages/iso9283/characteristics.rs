//! What a campaign tests by ISO 9283: poses, recorded motions, a loaded robot.

use crate::base::message::{Message, Problems, Result};
use crate::campaign::{Campaign, ComplianceDefinition, PosesDefinition};
use crate::document::*;
use crate::import;
use crate::stages::gather::Gathered;
use crate::stages::iso9283::COVERAGE_FACTOR;
use crate::stages::iso9283::load;
use crate::stages::iso9283::pose::Settings;
use crate::stages::iso9283::pose_tables::PoseTables;
use crate::stages::iso9283::repeatability;
use crate::stages::iso9283::streams;
use crate::stages::table_file::TableFile;
use toml::Spanned;

/// Seed of the bootstrap where the campaign states none: intervals are the same on every run.
const SEED: u64 = 1;

/// Evaluates all tests of a campaign; files that they are in become sources of `imported`.
pub fn evaluate(campaign: &Campaign, imported: &mut Gathered, frames: &FramesDocument) -> Result<Characteristics> {
    let (mut found, mut sources) = (Characteristics::default(), Vec::new());
    if let Some((document, more)) = poses(campaign, imported, frames)? {
        found.poses = Some(Iso9283Document { limits: limits(campaign, &document.poses)?, ..document });
        sources.extend(more);
    }
    if let Some((document, more)) = streams::evaluate_all(campaign)? {
        found.streams = Some(document);
        sources.extend(more);
    }
    if let Some((document, source)) = compliance(campaign)? {
        found.compliance = Some(document);
        sources.push(source);
    }
    imported.document.sources.extend(sources);
    Ok(found)
}

/// Everything that is wrong with the tables of these tests and with what is stated of them. Labels are not looked at.
pub fn problems(campaign: &Campaign) -> Problems {
    let file = &campaign.file;
    let mut problems = Problems::default();
    let mut set = |size: &Option<Spanned<usize>>, commanded: bool| {
        let Some(size) = size else { return };
        if *size.get_ref() < 2 {
            problems.0.push(Message::error("`drift_set` must be at least 2").at(campaign.place(size)));
        }
        if !commanded {
            let message = Message::error("`drift_set` needs commanded poses").at(campaign.place(size));
            problems.0.push(message.hint("state them: `commanded = \"commanded.csv\"`"));
        }
    };
    if let Some(labelled) = &file.repeatability {
        set(&labelled.drift_set, labelled.commanded.is_some());
    }
    if let Some(definition) = &file.poses {
        set(&definition.drift_set, true);
        if file.repeatability.is_some() {
            let message = Message::error("[poses] and [repeatability] both tell of visited poses");
            let hint = "state the one that the measurements are in: labels, or a table";
            problems.0.push(message.at(campaign.place(&definition.attained)).hint(hint));
        }
        problems.0.extend(table_problems(campaign, definition).0);
    }
    problems.0.extend(streams::read(campaign).err().into_iter().flat_map(|p| p.0));
    problems.0.extend(compliance(campaign).err().into_iter().flat_map(|p| p.0));
    problems
}

/// What is wrong with the tables of [poses]; a file that is not named is told already.
fn table_problems(campaign: &Campaign, definition: &PosesDefinition) -> Problems {
    if [&definition.attained, &definition.commanded].into_iter().any(|file| file.get_ref().is_empty()) {
        return Problems::default();
    }
    let tested = of_tables(campaign, definition).and_then(|(found, _)| limits(campaign, &found.poses));
    tested.err().unwrap_or_default()
}

/// Visited poses: of labels, or of tables.
fn poses(
    campaign: &Campaign,
    imported: &Gathered,
    frames: &FramesDocument,
) -> Result<Option<(Iso9283Document, Vec<Source>)>> {
    match (&campaign.file.poses, &campaign.file.repeatability) {
        (Some(tables), _) => of_tables(campaign, tables).map(Some),
        (None, Some(labelled)) => {
            let drift_set = labelled.drift_set.as_ref().map(|s| *s.get_ref());
            let settings = Settings { drift_set, ..settings(campaign) };
            repeatability::evaluate(campaign, labelled, &imported.points, frames, &settings).map(Some)
        }
        (None, None) => Ok(None),
    }
}

fn of_tables(campaign: &Campaign, definition: &PosesDefinition) -> Result<(Iso9283Document, Vec<Source>)> {
    let (tables, sources) = PoseTables::of_campaign(campaign, definition)?;
    let visits = tables.visits(definition.rotation_order.as_deref())?;
    // a set of one cycle is told of by itself
    if let Some(set) = definition.drift_set.as_ref().filter(|set| *set.get_ref() > 1) {
        visits.drifts(*set.get_ref()).map_err(|more| more.at(&campaign.place(set)))?;
    }
    let mut document = visits.evaluate(&Settings {
        drift_set: definition.drift_set.as_ref().map(|s| *s.get_ref()),
        rotation_order: definition.rotation_order.clone(),
        seed: definition.seed,
        ..settings(campaign)
    })?;
    document
        .conventions
        .push(format!("the 25 % rule with U at k = {COVERAGE_FACTOR}; positions in the frame of the tables"));
    document.visits = visits.told();
    Ok((document, sources))
}

/// What the campaign states for either.
fn settings(campaign: &Campaign) -> Settings {
    Settings {
        expanded_uncertainty_mm: Some(COVERAGE_FACTOR * campaign.file.instrument.standard_uncertainty_mm()),
        drift_set: None,
        rotation_order: None,
        seed: SEED,
        ap_limit_mm: campaign.file.limits.accuracy_max_mm,
        rp_limit_mm: campaign.file.limits.repeatability_max_mm,
    }
}

fn compliance(campaign: &Campaign) -> Result<Option<(Iso9283ComplianceDocument, Source)>> {
    let named = |d: &&ComplianceDefinition| !d.file.get_ref().is_empty();
    let Some(definition) = campaign.file.compliance.as_ref().filter(named) else { return Ok(None) };
    let kind = ("table", "static compliance");
    let (table, source) = TableFile::of_campaign(campaign, &definition.file, kind, import::observations)?;
    Ok(Some((load::evaluate(table.named()).map_err(|p| table.place(p))?, source)))
}

/// Limits of the largest values; what the intervals prove of each pose stands with the pose.
fn limits(campaign: &Campaign, poses: &[Iso9283Pose]) -> Result<Vec<LimitVerdict>> {
    let limits = &campaign.file.limits;
    // or the pose that has none
    let largest = |value: fn(&Iso9283Pose) -> Option<f64>| {
        let mut all = poses.iter().map(|p| value(p).ok_or(p.pose));
        all.try_fold(0.0, |largest, value| value.map(|value| f64::max(largest, value)))
    };
    let stated = [
        ("accuracy_max_mm", limits.accuracy_max_mm, largest(|p| p.ap_mm)),
        ("repeatability_max_mm", limits.repeatability_max_mm, largest(|p| p.rp_mm)),
    ];
    let mut judged = Vec::new();
    for (name, limit, value) in stated {
        let Some(limit) = limit else { continue };
        let value = value.map_err(|pose| {
            let message =
                Message::error(format!("the limit `{name}` cannot be judged: pose {pose} tells no such value"));
            message.at(campaign.place_of(&["limits", name])).hint("visit every pose twice or more, and command it")
        })?;
        judged.push(LimitVerdict { name: name.to_owned(), unit: "mm".to_owned(), limit, value, met: value <= limit });
    }
    Ok(judged)
}

//! Recorded motions of a campaign: from files to characteristics of ISO 9283.

use super::stated::TestStatement;
use crate::stages::table_file::CampaignTables;
use etalon_base::message::{Problems, Result};
use etalon_base::{error, phrase};
use etalon_campaign::{Campaign, StreamDefinition};
use etalon_documents::{Iso9283NamedStream, Iso9283StreamDocument, Iso9283StreamsDocument, SourceKind};
use etalon_formats::tables::recording::{commanded_path, commanded_poses, recording};
use etalon_standards::iso9283::motion::MotionSettings;
use etalon_standards::iso9283::motion::stream::Recording;
use std::collections::BTreeSet;

/// Seed of the bootstrap: intervals are the same on every run.
const SEED: u64 = 1;

/// A recording and its evaluation.
#[derive(Clone, Debug)]
pub(super) struct Ready {
    recording: Recording,
    settings: MotionSettings,
}

/// Reads all recordings with their commanded poses and paths; reports all errors in them.
pub(super) fn read(files: &mut CampaignTables) -> (Vec<Ready>, Problems) {
    let campaign = files.campaign;
    let mut problems = Problems::default();
    let mut names = BTreeSet::new();
    let mut all = Vec::new();
    for stream in &campaign.file.streams {
        if !names.insert(stream.name.get_ref()) {
            problems.0.push(error!("stream-twice", stream = stream.name.get_ref()).at(campaign.place(&stream.name)));
        }
        let mut wrong = stream.problems(campaign);
        if let Err(more) = stated(stream).check(|key| format!("`{key}`")) {
            wrong.0.extend(more.at(&campaign.place(&stream.name)).0);
        }
        match wrong.0.is_empty() {
            false => problems.0.extend(wrong.0),
            true => match ready(files, stream) {
                Ok(ready) => all.push(ready),
                Err(more) => problems.0.extend(more.0),
            },
        }
    }
    (all, problems)
}

/// Evaluates all recordings; `None` if the campaign has no `[[stream]]`.
pub(super) fn evaluate_all(campaign: &Campaign, ready: &[Ready]) -> Result<Option<Iso9283StreamsDocument>> {
    if campaign.file.streams.is_empty() {
        return Ok(None);
    }
    let mut streams = Vec::new();
    for (definition, ready) in campaign.file.streams.iter().zip(ready) {
        let found = Iso9283StreamDocument::evaluate(&ready.recording, &ready.settings);
        streams.push(Iso9283NamedStream {
            name: definition.name.get_ref().clone(),
            file: definition.file.get_ref().clone(),
            band_mm: definition.band_mm,
            stream: found.map_err(|more| more.at(&campaign.place(&definition.file)))?,
        });
    }
    Ok(Some(Iso9283StreamsDocument { schema: "etalon/iso9283-streams/1".to_owned(), streams }))
}

fn ready(files: &mut CampaignTables, stream: &StreamDefinition) -> Result<Ready> {
    let recorded = files.recording(stream)?;
    let recording = recording(&recorded.table, stream.rate_hz).map_err(|p| recorded.place(p))?;
    let poses = match &stream.commanded {
        None => None,
        Some(commanded) => {
            let table = files.read(commanded, SourceKind::Stream, phrase!("table-of-commanded-poses"))?;
            Some(commanded_poses(&table.table).map_err(|p| table.place(p))?)
        }
    };
    let path = match &stream.path {
        None => None,
        Some(path) => {
            let table = files.read(path, SourceKind::Stream, phrase!("table-of-commanded-path"))?;
            Some(commanded_path(&table.table, &recorded.name, &recording).map_err(|p| table.place(p))?)
        }
    };
    let settings = stated(stream).settings(poses, path, SEED);
    Ok(Ready { recording, settings })
}

/// Data of the campaign about a motion.
fn stated(stream: &StreamDefinition) -> TestStatement<'_> {
    TestStatement {
        rate_hz: stream.rate_hz,
        still_mm: stream.still_mm,
        still_s: stream.still_s,
        near_mm: stream.near_mm,
        band_mm: stream.band_mm,
        path: stream.path.is_some(),
        path_points: stream.path_points,
        velocity_mm_s: stream.velocity_mm_s,
        central_percent: stream.central_percent,
        weave_stroke_mm: stream.weave_stroke_mm,
        weave_hz: stream.weave_hz,
        weave_across: &stream.weave_across,
    }
}

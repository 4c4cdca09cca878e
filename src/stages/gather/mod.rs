//! Gather: the exports and logs of a campaign become points and joint values.
//!
//! No input is repaired without a message: a row that means "not measured" is rejected by rule and
//! listed, anything else that does not read as given is an error with its place, and one run
//! reports all of them.

mod blunders;
mod decimals;
mod excluded;
mod mislabelling;
mod points;
mod rounding;
mod temperature;

pub(crate) use points::used_labels;
pub use temperature::range as temperature_range;

use crate::stages::table_file::{CampaignTables, TableFile};
use etalon_base::files::Stamp;
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_base::pose_name::two_spellings;
use etalon_base::worded::Worded;
use etalon_base::{phrase, warning};
use etalon_campaign::Campaign;
use etalon_documents::{ImportDocument, Source, SourceKind};
use etalon_formats::{Export, JointLog, Line, Log, LogFile, LogRow, Point, SharedText};
use points::PointColumns;
pub use points::Stationed;
use std::collections::BTreeMap;

/// Points, joint values and tables of a campaign's files.
#[derive(Clone, Debug, Default)]
pub struct Gathered {
    /// Every measured point.
    pub points: Vec<Point>,
    /// Points of further stations of the instrument, in the frames of the stations.
    pub stationed: Vec<Stationed>,
    /// Joint values of each log.
    pub logs: Vec<JointLog>,
    /// The table of observations, if the campaign has one.
    pub(crate) observations: Option<TableFile>,
    /// `true` if rows of a target are omitted because they have no pose.
    pub(crate) has_rows_without_pose: bool,
    /// Targets of rigid parts whose rows are all rejected.
    pub(crate) refused_targets: Vec<String>,
    /// Files that were read, and rows that were rejected.
    pub document: ImportDocument,
}

impl Gathered {
    /// Points of all stations.
    pub fn all_points(&self) -> impl Iterator<Item = &Point> {
        self.points.iter().chain(self.stationed.iter().map(|of| &of.point))
    }
}

/// Reads all exports and logs of a campaign.
pub fn gather(campaign: &Campaign) -> Result<Gathered> {
    let (imported, problems) = recover(campaign);
    problems.check()?;
    Ok(imported)
}

/// Remarks on the points that remain.
fn remarks(campaign: &Campaign, points: &[Point]) -> Vec<Message> {
    let mut messages = Vec::from_iter(mislabelling::misplaced(campaign, points));
    messages.extend(mislabelling::drifting(campaign, points));
    messages.extend(decimals::misplaced_marks(points));
    messages.extend(temperature::contradicted(campaign, points));
    messages
}

/// Reads all readable rows of the exports and logs of a campaign, and reports all errors. Points
/// with an unreadable coordinate are kept without it.
pub fn recover(campaign: &Campaign) -> (Gathered, Problems) {
    let mut problems = Problems::default();
    let stated = statement(SourceKind::Campaign, campaign.file_name(), &campaign.stamps[0]);
    let mut sources = vec![Source { sha256_without_backup: campaign.sha256_without_backup(), ..stated }];
    if campaign.file.states_robot() {
        sources.push(statement(SourceKind::Robot, campaign.file.robot.get_ref(), &campaign.stamps[1]));
    }
    let described = campaign.robot_description();
    sources.extend(described.map(|(file, stamp)| statement(SourceKind::Robot, &file, stamp)));
    let mut columns = PointColumns::default();
    let mut frames = Vec::new();
    let exports = &campaign.file.exports;
    // bytes of files that a later export names again
    let mut opened: BTreeMap<&str, Vec<u8>> = BTreeMap::new();
    for (i, export) in exports.iter().enumerate() {
        let file = export.file.get_ref().as_str();
        if file.is_empty() {
            continue;
        }
        let later = exports[i + 1..].iter().any(|later| later.file.get_ref() == file);
        let read = campaign.resolve(&export.file).and_then(|path| {
            let bytes = opened.remove(file).map_or_else(|| etalon_formats::read_bytes(&path), Ok)?;
            if later {
                opened.insert(file, bytes.clone());
            }
            let stamp = Stamp::new(&bytes);
            let text = etalon_formats::into_text(&path, bytes, export.encoding, &export.format)?;
            Ok((SharedText::from(text), stamp))
        });
        match read.map_err(|problems| problems.at(&campaign.place(&export.file))) {
            // what it states of itself is reported already
            Ok(_) if !campaign.export_reads(i) => {}
            Ok((text, stamp)) => {
                let mut source = statement(SourceKind::Export, file, &stamp);
                let read = phrase!("read-in-unit", format = export.format.title(), unit = export.unit.name());
                problems.0.extend(columns.read(campaign, export, &text, &mut source).0);
                let read = match export.columns_not_read(&text) {
                    Some([unread, all]) if unread > 0 => phrase!("read-without-columns", read, unread, all),
                    _ => read,
                };
                let frame = export.format.frame(&text);
                source.read_as(match frame {
                    Some(frame) => phrase!("read-in-frame", read, frame),
                    None => read,
                });
                frames.extend(frame.map(|frame| (campaign.place(&export.file), frame.to_owned())));
                sources.push(source);
            }
            Err(more) => problems.0.extend(more.0),
        }
    }
    let mut tables = CampaignTables { campaign, sources: Vec::new() };
    let observations = problems.keep(tables.all_observations(&campaign.file.observations)).flatten();
    sources.append(&mut tables.sources);
    let (logs, said) = logs(campaign, &mut sources, &mut problems);
    let left_out = problems.keep(excluded::leave_out(campaign, &mut columns, &mut sources)).unwrap_or_default();
    problems.0.extend(columns.measured_twice(campaign));
    problems.0.extend(other_spelling(&columns.points, &logs));
    problems.0.extend(blunders::check(campaign).0);
    problems.0.extend(mislabelling::check(campaign).0);
    let (mut messages, unmatched) = columns.unused_labels(campaign);
    messages.extend(said);
    messages.extend(left_out);
    messages.append(&mut columns.remarks);
    messages.extend(frames_differ(&frames));
    if problems.0.is_empty() && campaign.unread.is_empty() {
        match blunders::refuse(campaign, &mut columns, &mut sources) {
            Ok(said) => messages.splice(0..0, said).for_each(drop),
            Err(more) => problems.0.extend(more.0),
        }
        forget_lines(&mut columns.points, &sources);
        messages.extend(remarks(campaign, &columns.points));
    }
    let document = ImportDocument {
        schema: "etalon/import/1".to_owned(),
        campaign: campaign.file.name.clone(),
        sources,
        messages: Problems(messages).grouped().0,
        unmatched,
    };
    let PointColumns { points, stationed, has_rows_without_pose, refused_targets, .. } = columns;
    (Gathered { points, stationed, logs, observations, has_rows_without_pose, refused_targets, document }, problems)
}

/// Size of an export (bytes) above which its text is released once it is read: later messages name
/// the line without its text.
const LARGE: usize = 16 << 20;

/// Releases the texts of large exports.
fn forget_lines(points: &mut [Point], sources: &[Source]) {
    let large = sources.iter().filter(|source| source.kind == SourceKind::Export && source.bytes > LARGE);
    let large: Vec<&str> = large.map(|source| source.file.as_str()).collect();
    if !large.is_empty() {
        points.iter_mut().filter(|p| large.contains(&&*p.export)).for_each(|p| p.text = Line::default());
    }
}

/// Reads all readable rows of all logs, with remarks.
fn logs(campaign: &Campaign, sources: &mut Vec<Source>, problems: &mut Problems) -> (Vec<JointLog>, Vec<Message>) {
    let (mut logs, mut said) = (Vec::new(), Vec::new());
    for stated in campaign.file.logs.iter().filter(|log| !log.file.get_ref().is_empty()) {
        let here = campaign.place(&stated.file);
        let read = campaign.resolve(&stated.file).and_then(|path| stated.load(&path).map_err(|more| more.at(&here)));
        match read.and_then(|file| {
            if campaign.unread.affects(&["log"]) {
                return Ok(None);
            }
            let mut sources = log_sources(stated.file.get_ref(), &file);
            let table = etalon_formats::log(campaign.stated(), stated, &file.text, &mut sources[0])?;
            Ok(Some((sources, table)))
        }) {
            Ok(None) => {}
            Ok(Some((read, (table, more)))) => {
                sources.extend(read);
                logs.push(table);
                said.extend(more);
            }
            Err(more) => problems.0.extend(more.0),
        }
    }
    let mixed = campaign.file.exports.iter().any(|export| !export.joints.is_empty());
    (if mixed && logs.len() > 1 { vec![together(logs)] } else { logs }, said)
}

/// Statements of the file of a log, and of the files beside it that contain its numbers.
fn log_sources(name: &str, file: &LogFile) -> Vec<Source> {
    let folder = name.rfind('/').map_or("", |end| &name[..=end]);
    let beside = file.beside.iter().map(|(name, bytes)| (format!("{folder}{name}"), bytes));
    let all = std::iter::once((name.to_owned(), &file.bytes)).chain(beside);
    all.map(|(name, bytes)| statement(SourceKind::Log, &name, &Stamp::new(bytes))).collect()
}

/// One log of the joints of several exports, whose rows keep their numbers in their files.
fn together(logs: Vec<JointLog>) -> JointLog {
    let mut all = JointLog::default();
    for (log, number) in logs.into_iter().zip(1..) {
        // joints of a file may be in another order
        let order: Vec<Option<usize>> = match all.joints.is_empty() {
            true => (0..log.joints.len()).map(Some).collect(),
            false => all.joints.iter().map(|name| log.joints.iter().position(|other| other == name)).collect(),
        };
        if all.rows.is_empty() {
            all = JointLog { rows: Vec::new(), ..log.clone() };
        }
        all.files.push(log.file);
        all.rows.extend(log.rows.into_iter().map(|row| LogRow {
            file: Some(number),
            joints: order.iter().map(|k| k.and_then(|k| row.joints.get(k).copied()).unwrap_or(f64::NAN)).collect(),
            ..row
        }));
    }
    all
}

/// Returns the points of an export with this text, before the rules about blunders.
pub(crate) fn parse_points(campaign: &Campaign, export: &Export, text: &str) -> Result<Vec<Point>> {
    let mut columns = PointColumns::default();
    columns
        .read(
            campaign,
            export,
            &text.into(),
            &mut statement(SourceKind::Export, export.file.get_ref(), &Stamp::default()),
        )
        .check()?;
    Ok(columns.points)
}

/// The table of a log if this is its text.
pub(crate) fn parse_log(campaign: &Campaign, stated: &Log, text: &str) -> Result<JointLog> {
    etalon_formats::log(
        campaign.stated(),
        stated,
        text,
        &mut statement(SourceKind::Log, stated.file.get_ref(), &Stamp::default()),
    )
    .map(|(table, _)| table)
}

/// Returns an error if rows of exports and logs name a pose in two spellings.
fn other_spelling(points: &[Point], logs: &[JointLog]) -> Option<Message> {
    let logged = || logs.iter().flat_map(|log| log.rows.iter().map(move |row| (log, row)));
    let names = points.iter().map(|point| point.pose).chain(logged().map(|(_, row)| row.pose));
    let (message, at) = two_spellings(names)?;
    let of_log = |(log, row): (&JointLog, &LogRow)| Place { line: Some(row.line), ..Place::file(&log.file) };
    let place = points.get(at).map(|point| point.place());
    Some(message.at(place.or_else(|| logged().nth(at - points.len()).map(of_log)).unwrap_or_default()))
}

fn statement(kind: SourceKind, file: &str, stamp: &Stamp) -> Source {
    Source {
        file: file.to_owned(),
        sha256: stamp.sha256.clone(),
        sha256_without_backup: None,
        bytes: stamp.size,
        kind,
        dialect: match kind {
            SourceKind::Export | SourceKind::Log => Worded::default(),
            _ => "TOML".into(),
        },
        rows_read: 0,
        refused: Vec::new(),
        standstills: Vec::new(),
    }
}

/// Returns a warning if the exports of a campaign, each with its place, are relative to several
/// frames.
pub(crate) fn frames_differ(frames: &[(Place, String)]) -> Option<Message> {
    let (_, first) = frames.first()?;
    let (place, other) = frames.iter().find(|(_, frame)| frame != first)?;
    Some(warning!("frames-differ", first, second = other).at(place.clone()))
}

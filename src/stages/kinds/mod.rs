//! Tables of observations of several kinds: positions, poses, distances, contacts, surfaces and
//! joints, a row each.
//!
//! The column `kind` names them; rows without a pose are about fixed points alone: their places and
//! distances.

mod bar;
mod cells;
mod contact;
mod distance;
mod joints;
mod kind;
mod measured;
mod point;
mod pose;
mod row;
mod surface;

#[cfg(feature = "schemas")]
pub use cells::stated_schema;
pub use cells::{ByColumn, Cell, Cells, Others, names, text};
pub use kind::{Facts, Measurement, RowKind, Simulated, no_known};
pub use measured::unmeasured_rows;
pub use row::{Row, columns, numbers, target_index};

use crate::stages::observe::conventions;
use crate::stages::observe::positions;
use crate::stages::observe::resolution;
use crate::stages::orientations::{self, AngleOrder, Written, unstated};
use cells::STATION;
use etalon_base::message::{Message, Place, Problems, Result, nearest};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase, warning};
use etalon_formats::table::{ASSEMBLY, COVARIANCES, LABEL, TEXTS, TIME, Table, UNCERTAINTIES, XYZ};
use etalon_formats::tables::joints::stated_columns;
use etalon_identify::{Measured, Observation, Settings};
use etalon_robots::Robot;
use measured::measured_rows;
use row::{RowError, fixed_rows, partial_rows};
use std::collections::{BTreeMap, BTreeSet};

/// The kinds of rows. To add one: its module with a [`RowKind`], and its line here; a new column of
/// names also in [`TEXTS`].
const KINDS: [&dyn RowKind; 9] = [
    &point::Point,
    &pose::Body,
    &distance::Distance,
    &bar::Bar,
    &contact::Contact,
    &surface::PLANE,
    &surface::LINE,
    &surface::SPHERE,
    &joints::Joints,
];

/// Returns the kind of this name.
///
/// # Errors
/// Fails if no kind has this name.
pub fn kind(name: &str) -> Result<&'static dyn RowKind> {
    let found = KINDS.into_iter().find(|kind| kind.facts().name == name);
    Ok(found.ok_or_else(|| {
        let names = KINDS.iter().map(|kind| kind.facts().name);
        error!("kind-unknown", name).hint_names(name, names)
    })?)
}

/// Minimum number of poses at which the station of the world observes the robot.
const FEWEST_SEEN: usize = 3;
/// Statements on all rows: standard uncertainties of rows without their own, and the order of
/// angles.
#[derive(Clone, Copy, Debug, Default)]
pub struct RowDefaults {
    /// Standard uncertainty of a coordinate, a distance or a contact (mm).
    pub length_mm: Option<f64>,
    /// Standard uncertainty of a rotation about any axis (rad).
    pub rotation_rad: Option<f64>,
    /// The order of three angles of an orientation.
    pub order: Option<AngleOrder>,
}

/// Observations, and the settings of their identification.
#[derive(Clone, Debug)]
pub struct Observed {
    /// Positions of targets.
    pub observations: Vec<Observation>,
    /// The settings, with all conditions.
    pub settings: Settings,
}

impl Observed {
    /// Names of the poses.
    pub fn poses(&self) -> BTreeSet<PoseName> {
        let conditions = self.settings.conditions.iter().map(|c| c.pose);
        self.observations.iter().map(|o| o.pose).chain(conditions).collect()
    }
}

/// The names of rows with a pose that are on the robot: names in the column `target`, and targets
/// of `branches` that another target refers to. Each once, in their order.
pub fn targets(table: &Table, branches: &[Vec<String>]) -> Result<Vec<String>> {
    let mut targets: Vec<String> = Vec::new();
    let fixed = fixed_rows(table)?;
    let columns = OTHERS.into_iter().filter(|column| table.has(column));
    for column in std::iter::once("target").chain(columns) {
        for (name, _) in table.texts(column)?.into_iter().zip(&fixed).filter(|(_, fixed)| !**fixed) {
            let is_on_robot = column == "target" || branches.iter().flatten().any(|target| *target == name);
            // the value of a joint is of no target
            if !name.is_empty() && is_on_robot && targets.iter().all(|target| *target != name) {
                targets.push(name.into_owned());
            }
        }
    }
    Ok(targets)
}

/// Columns that may name a target of another branch.
pub const OTHERS: [&str; 2] = ["other", "socket"];

/// The poses of a table.
pub fn poses(table: &Table) -> Result<BTreeSet<PoseName>> {
    Ok(table.optional_poses()?.into_iter().flatten().collect())
}

/// Columns of shared names, and the maximum number of rows that determine only the position of
/// their own item.
const SHARED: [(&str, usize); 7] =
    [("target", 1), ("socket", 1), ("other", 2), ("plane", 2), ("line_name", 2), ("sphere", 2), (STATION, 2)];
/// Minimum number of rows with a name before it is suggested as a correction.
const MEANT_ROWS: usize = 6;

/// Errors about names in one or two rows that are spelt almost like a name in many rows: the named
/// item would be identified from these rows alone, which then contribute nothing to the robot.
/// Names that differ in a counter (`P1` and `P2`, `anchor A` and `anchor B`) are different.
fn misspelt(table: &Table) -> Result<Problems> {
    let mut problems = Problems::default();
    let fixed = fixed_rows(table)?;
    for (column, most) in SHARED.into_iter().filter(|(name, _)| table.has(name)) {
        let names: Vec<&str> = (0..table.height()).map(|row| table.text(row, column).unwrap_or_default()).collect();
        problems.0.extend(misspelt_names(&names, most, |row| fixed[row], |row| table.place(row)));
    }
    Ok(problems)
}

/// Columns of every observation, of any kind.
const OF_OBSERVATIONS: [&str; 5] = ["pose", "cycle", LABEL, TIME, ASSEMBLY];

/// Columns that are read: columns of observations of any kind, and columns of the joints of the
/// robot. Reading has converted lengths to mm.
fn read_columns(robot: &dyn Robot, table: &Table) -> BTreeSet<String> {
    let of_joint = |name: &&str| {
        robot.joints().iter().any(|joint| joint.factor(name).is_some() || joint.direction_column() == *name)
    };
    let own = OF_OBSERVATIONS.into_iter().chain(TEXTS).chain(columns()).chain(orientations::columns());
    let positions = XYZ.into_iter().chain(UNCERTAINTIES).chain(COVARIANCES);
    let joints = table.names().filter(of_joint).map(str::to_owned);
    own.chain(positions).map(str::to_owned).chain(joints).chain(stated_columns(robot)).collect()
}

/// Columns of a table of observations that are not read.
pub fn unread_columns(robot: &dyn Robot, table: &Table) -> Vec<String> {
    let read = read_columns(robot, table);
    table.names().filter(|name| !read.contains(*name)).map(str::to_owned).collect()
}

/// Warning about columns that are not read.
fn unread(robot: &dyn Robot, table: &Table) -> Option<Message> {
    let unread = unread_columns(robot, table);
    let first = unread.first()?;
    let columns: Vec<String> = unread.iter().map(|name| format!("`{name}`")).collect();
    let message = warning!("columns-not-read", count = columns.len(), columns).routine();
    let message = message.at(Place::file(table.file()));
    let read = read_columns(robot, table);
    let own = || read.iter().map(String::as_str);
    Some(if nearest(first, own()).is_some() { message.hint_names(first, own()) } else { message })
}

/// Returns an error if a target of measured positions is misspelt, as for a table.
pub(super) fn misspelt_targets(measured: &[Measured], targets: &[String]) -> Result<()> {
    let names: Vec<&str> = measured.iter().map(|m| targets[m.target].as_str()).collect();
    Problems(misspelt_names(&names, SHARED[0].1, |_| false, |_| Place::default())).check().map(drop)
}

/// Errors about names in at most `most` rows; `fixed` rows contain a position, and need no more
/// rows.
fn misspelt_names(
    names: &[&str],
    most: usize,
    fixed: impl Fn(usize) -> bool,
    place: impl Fn(usize) -> Place,
) -> Vec<Message> {
    let mut rows: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    let named = names.iter().enumerate().filter(|(_, name)| !name.is_empty());
    named.for_each(|(row, name)| rows.entry(name).or_default().push(row));
    let few = rows.iter().filter(|(_, rows)| rows.len() <= most && !rows.iter().any(|&row| fixed(row)));
    let error = |(name, own): (&&str, &Vec<usize>)| {
        let many = rows.iter().filter(|(_, rows)| rows.len() >= MEANT_ROWS).map(|(name, _)| *name);
        let (_, meant) = many.filter_map(|meant| Some((letters_wrong(name, meant)?, meant))).min()?;
        let message = error!("name-on-few-rows", name, count = own.len(), meant, meant_count = rows[meant].len());
        Some(message.at(place(own[0])))
    };
    few.filter_map(error).collect()
}

/// Number of wrong letters in a name that resembles another; `None` where more letters or a counter
/// differ.
fn letters_wrong(name: &str, meant: &str) -> Option<usize> {
    let wrong = strsim::damerau_levenshtein(&name.to_lowercase(), &meant.to_lowercase());
    let words = |name: &str| -> Vec<String> {
        let words = name.split(|c: char| !c.is_alphabetic());
        words.filter(|word| word.chars().count() > 1).map(str::to_owned).collect()
    };
    // few letters are many names
    let most = if meant.chars().count() < 6 { 1 } else { 2 };
    (wrong == 0 || wrong <= most && words(name) != words(meant)).then_some(wrong)
}

/// Returns a warning if an instrument measured positions and joints move the base of the chain.
pub(super) fn moving_base(robot: &dyn Robot) -> Option<Message> {
    let joints = robot.joints_of_base();
    (!joints.is_empty()).then(|| warning!("base-moves", joints).to_decide())
}

/// Rows without the standard uncertainty that they need, by the column of the uncertainty.
#[derive(Default)]
struct Unstated<'a>(BTreeMap<&'static str, Vec<&'a Row<'a>>>);

impl<'a> Unstated<'a> {
    /// One message for each column, with the number of rows and the first three; rows without some
    /// of their coordinates are named as such.
    fn messages(&self, table: &Table) -> Vec<Message> {
        let of_column = |(column, rows): (&&'static str, &Vec<&'a Row>)| {
            let mut by_missing: BTreeMap<Vec<&str>, Vec<&Row>> = BTreeMap::new();
            rows.iter().for_each(|row| by_missing.entry(row.missing_axes()).or_default().push(row));
            let message = |(axes, rows): (Vec<&str>, Vec<&Row>)| {
                let NamedRows { by, rows: named, more } =
                    NamedRows::new(table, rows.iter().map(|row| (row.index, row.pose)));
                let place = rows.first().map(|row| table.place(row.index)).unwrap_or_default();
                let (count, missing) = (rows.len(), axes.len());
                match axes.is_empty() {
                    true => error!("uncertainty-missing", column = *column, count, by, rows = named, more),
                    false => error!("coordinates-of-rows-missing", axes, missing, by, rows = named, more),
                }
                .at(place)
            };
            by_missing.into_iter().map(message).collect::<Vec<_>>()
        };
        self.0.iter().flat_map(of_column).collect()
    }
}

/// The first rows of several, by their lines, or by their poses if lines are unknown.
struct NamedRows {
    by: &'static str,
    rows: Vec<String>,
    more: usize,
}

impl NamedRows {
    /// Rows of a table with their poses. Lines name them only in the first file.
    fn new(table: &Table, rows: impl Iterator<Item = (usize, Option<PoseName>)> + Clone) -> Self {
        let by = if rows.clone().all(|(row, _)| table.is_in_first_file(row)) { "line" } else { "pose" };
        let name = |(row, pose): (usize, Option<PoseName>)| match by {
            "line" => table.line(row).map(|line| line.to_string()),
            _ => pose.map(|pose| pose.to_string()),
        };
        let mut named: Vec<String> = rows.filter_map(name).collect();
        named.dedup();
        let more = named.len().saturating_sub(FIRST_ROWS);
        named.truncate(FIRST_ROWS);
        Self { by, rows: named, more }
    }
}

/// Remark on rows with single coordinates of a target; a warning if they are few among rows with
/// whole positions, which are then more probably gaps.
fn partial_remark(table: &Table, rows: &[Row]) -> Option<Message> {
    let partial = rows.iter().filter(|row| row.is_partial);
    let (count, whole) = (partial.clone().count(), rows.iter().filter(|row| row.has_position()).count());
    if count == 0 {
        return None;
    }
    let NamedRows { by, rows, more } = NamedRows::new(table, partial.map(|row| (row.index, row.pose)));
    let message = warning!("partial-coordinates", count, by, rows, more);
    Some(if FEW_AMONG * count > whole { message.routine() } else { message })
}

/// Rows with whole positions for each row with single coordinates that is probably a gap.
const FEW_AMONG: usize = 10;

/// Number of rows that a message about rows of one cause names.
const FIRST_ROWS: usize = 3;

/// Observations of `robot` from a table of any kinds; fixed points and surfaces are added to its
/// parameters, and observations other than positions of targets to `settings`. Values derived from
/// the measurement are in `messages`.
pub fn observed(
    robot: &mut dyn Robot,
    table: &Table,
    without: RowDefaults,
    mut settings: Settings,
    messages: &mut Vec<Message>,
) -> Result<Observed> {
    misspelt(table)?.check()?;
    messages.extend(unread(robot, table));
    let table = &*measured_rows(robot, table, messages)?;
    let table = &*resolution::replace_table_zeros(table, messages)?;
    if !partial_rows(robot, table)?.contains(&true)
        && !table.has("kind")
        && !table.has(STATION)
        && !orientations::are_in(table)
        && !fixed_rows(table)?.contains(&true)
    {
        messages.extend(moving_base(robot));
        return Ok(Observed { observations: positions::observations(robot, table, messages)?, settings });
    }
    let rows = Row::read(robot, table, without)?;
    let mut problems = Problems::default();
    problems.0.extend(unnamed_station(table, &rows));
    let mut written = Vec::new();
    let mut without_uncertainty = Unstated::default();
    for row in &rows {
        let before = settings.conditions.len();
        match row.add_to(&mut settings, robot) {
            Ok(()) => {}
            Err(RowError::Unstated(column)) => without_uncertainty.0.entry(column).or_default().push(row),
            Err(RowError::Wrong(more)) => problems.0.extend(more.at(&table.place(row.index)).0),
        }
        let added = settings.conditions[before..].iter().filter(|c| c.kind.is_orientation());
        let orientation = Written { order: row.order, ..row.orientation };
        written.extend(added.map(|c| (c.kind.is_world_orientation(), orientation)));
    }
    problems.0.extend(without_uncertainty.messages(table));
    problems.check()?;
    let names = robot.parameters();
    if let Some((_, p)) = names.iter().enumerate().find(|(i, p)| names[..*i].iter().any(|other| other.name == p.name)) {
        return Err(error!("parameter-name-doubled", name = p.name).hint(phrase!("names-of-fixed-things")).into());
    }
    messages.extend(partial_remark(table, &rows));
    let has_position: Vec<bool> = rows.iter().map(Row::has_position).collect();
    let observations = match has_position.contains(&true) {
        true => {
            messages.extend(moving_base(robot));
            positions::observations(robot, &table.rows(|row| has_position[row]), messages)?
        }
        false => Vec::new(),
    };
    let is_open = |row: &Written| row.angles().is_some() && row.order.or(without.order).is_none();
    let is_any_open = written.iter().any(|(_, row)| is_open(row));
    let first_open = rows.iter().find(|row| is_open(&Written { order: row.order, ..row.orientation }));
    // the nominal robot shows the orientations of the world alone
    let written: Vec<Written> = written.into_iter().filter(|(in_world, _)| *in_world).map(|(_, row)| row).collect();
    if is_any_open {
        let angles: Vec<[f64; 3]> = written.iter().filter_map(Written::angles).collect();
        let header = first_open.map_or_else(|| table.header(), |row| table.header_above(row.index));
        return Err(unstated(robot, &observations, &settings, &angles).at(header).into());
    }
    let observed = Observed { observations, settings };
    match conventions::wrong(robot, &observed.observations, &observed.settings, &written) {
        Some(wrong) => Err(wrong.at(table.header()).into()),
        None => Ok(observed),
    }
}

/// Returns an error if a few rows have no station and many have one.
fn unnamed_station(table: &Table, rows: &[Row]) -> Option<Message> {
    let points = rows
        .iter()
        .filter(|row| row.pose.is_some() && kind(&row.cells.kind).is_ok_and(|kind| kind.facts().has_stations));
    let (named, unnamed): (Vec<&Row>, Vec<&Row>) = points.partition(|row| row.cells.station.is_some());
    let poses = |rows: &[&Row]| rows.iter().map(|row| row.pose).collect::<BTreeSet<_>>().len();
    let all_stated = unnamed.iter().all(|row| row.cells.text(STATION).is_some());
    if all_stated || poses(&unnamed) >= FEWEST_SEEN || poses(&named) < FEWEST_SEEN {
        return None;
    }
    Some(error!("station-missing", least = FEWEST_SEEN).at(table.place(unnamed[0].index)))
}

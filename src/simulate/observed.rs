//! Observations of the truth: rows of a table of observations, by kind, and the fixed objects to
//! which they refer.

use super::Truth;
use crate::stages::kinds::{self, ByColumn, Cell, Cells, Others, Simulated, text};
use etalon_base::message::{Problems, Result};
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase};
use etalon_campaign::{Selection, StatedPoses};
use etalon_robots::Robot;
use schemars::JsonSchema;
use serde::Deserialize;

/// `[[observe]]` of a truth: one row at each of its poses and in each round. Keys are the columns
/// of the table.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Observe {
    /// `point`, `pose`, `distance`, `contact`, `plane`, `line`, `sphere` or `joints`.
    pub kind: String,
    /// Name of the target; not needed for `joints`.
    #[serde(default)]
    pub target: String,
    /// Poses, e.g. `"1-20"`; all poses if absent.
    pub poses: Option<StatedPoses>,
    /// Objects to which the kind refers, by column.
    #[serde(flatten)]
    #[schemars(schema_with = "kinds::stated_schema")]
    pub to: ByColumn,
    /// For a `point`: measured coordinates, e.g. `"z"` for a dial gauge; all coordinates if absent.
    pub coordinates: Option<String>,
    /// Standard uncertainty of a length, written into the row; the instrument's uncertainty if
    /// absent.
    pub u_um: Option<f64>,
    /// Standard uncertainty of an angle, written into the row; the instrument's uncertainty if
    /// absent.
    pub urot_deg: Option<f64>,
}

/// `[[known]]` of a truth: one row without a pose, about fixed objects only.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct KnownRow {
    /// `point`, `distance`, `plane`, `line` or `sphere`.
    pub kind: String,
    /// Name of the fixed point, or of the point on a surface.
    pub target: String,
    /// Objects to which the kind refers, by column.
    #[serde(flatten)]
    #[schemars(schema_with = "kinds::stated_schema")]
    pub to: ByColumn,
    /// Approximate position of a point on a surface, from which the true position follows.
    pub near_mm: Option<Vector>,
    /// Standard uncertainty, written into the row.
    pub u_um: f64,
}

/// An `[[observe]]` or `[[known]]` in its simulated form.
pub(super) struct Item {
    pub cells: Cells<'static>,
    pub simulated: Simulated,
    /// Index of the observed target.
    pub target: usize,
    poses: Option<Selection>,
    /// Standard uncertainties that the row contains.
    pub u_um: Option<f64>,
    pub urot_deg: Option<f64>,
}

impl Item {
    /// `true` if the item is observed at a pose.
    pub(super) fn is_at(&self, pose: i64) -> bool {
        self.poses.as_ref().is_none_or(|poses| poses.contains(PoseName::from(pose), pose as usize - 1, false))
    }
}

/// Observed targets, and targets of `branches` to which they refer, each once.
pub(super) fn targets(truth: &Truth, branches: &[Vec<String>]) -> Vec<String> {
    let mut targets: Vec<String> = Vec::new();
    let observed = truth.observe.iter().map(|observe| observe.target.as_str());
    let others = truth.observe.iter().flat_map(|observe| kinds::OTHERS.map(|column| kinds::text(&observe.to, column)));
    let is_on_robot = |name: &&str| branches.iter().flatten().any(|target| target == name);
    for name in observed.chain(others.flatten().filter(is_on_robot)) {
        if !name.is_empty() && targets.iter().all(|known| known != name) {
            targets.push(name.to_owned());
        }
    }
    targets
}

/// Observations of `truth` at poses; the objects to which they refer are added to the parameters of
/// `robot`.
///
/// # Errors
///
/// Reports unknown kinds, targets and joints, and kinds with missing references.
pub(super) fn items(truth: &Truth, robot: &mut dyn Robot) -> Result<Vec<Item>> {
    let world = world_station(truth)?;
    let mut items = Vec::new();
    for (number, stated) in (1..).zip(&truth.observe) {
        let item = (|| {
            let kind = kinds::kind(&stated.kind)?;
            let mut to = stated.to.clone();
            if let Some(coordinates) = &stated.coordinates {
                if !kind.facts().is_position || text(&to, "station").is_some() {
                    return Err(error!("coordinates-of-other-kind").into());
                }
                to.insert("coordinates".to_owned(), Cell::Text(coordinates.clone()));
            }
            let cells = cells(&stated.kind, &stated.target, to, &world);
            let simulated = kind.simulated(&cells, robot)?;
            let target = kinds::target_index(kind, &stated.target, robot)?;
            let poses = stated.poses.as_ref().map(Selection::parse).transpose()?;
            let (u_um, urot_deg) = (stated.u_um, stated.urot_deg);
            Ok(Item { cells, simulated, target, poses, u_um, urot_deg })
        })();
        items.push(item.map_err(|problems| within("observe", number, problems))?);
    }
    Ok(items)
}

/// Statements of `truth` about fixed objects; the objects are added to the parameters of `robot`.
///
/// # Errors
///
/// Reports kinds that state nothing about fixed objects, and kinds with missing references.
pub(super) fn known(truth: &Truth, robot: &mut dyn Robot) -> Result<Vec<Item>> {
    let world = world_station(truth)?;
    let mut known = Vec::new();
    for (number, stated) in (1..).zip(&truth.known) {
        let cells = cells(&stated.kind, &stated.target, stated.to.clone(), &world);
        let simulated = match kinds::kind(&stated.kind) {
            Ok(kind) => kind.known_simulated(&cells, stated.near_mm, robot),
            Err(_) => Err(kinds::no_known(&stated.kind).into()),
        };
        let simulated = simulated.map_err(|problems| within("known", number, problems))?;
        known.push(Item { cells, simulated, target: 0, poses: None, u_um: Some(stated.u_um), urot_deg: None });
    }
    Ok(known)
}

/// Cells of a row; a station is given only if its frame is not the world.
fn cells(kind: &str, target: &str, to: ByColumn, world: &str) -> Cells<'static> {
    let station = text(&to, "station").filter(|name| *name != world).map(str::to_owned);
    Cells { kind: kind.to_owned(), target: target.to_owned(), station, others: Others::Truth(to) }
}

/// Station whose frame is the world when the table is read: no station if something is measured
/// without a station, otherwise the first.
fn world_station(truth: &Truth) -> Result<String> {
    let measured = truth.observe.iter().filter(|o| kinds::kind(&o.kind).is_ok_and(|kind| kind.facts().has_position));
    let fixed = truth
        .known
        .iter()
        .filter(|k| kinds::kind(&k.kind).is_ok_and(|kind| kind.facts().is_position) || k.near_mm.is_some());
    let without = measured.clone().any(|o| text(&o.to, "station").is_none())
        || fixed.clone().any(|k| text(&k.to, "station").is_none());
    let mut first: Option<(usize, &Observe)> = None;
    for observe in measured {
        let poses = observe.poses.as_ref().map(Selection::parse).transpose()?;
        let holds = |pose: &usize| {
            poses.as_ref().is_none_or(|poses| poses.contains(PoseName::from(*pose as i64 + 1), *pose, false))
        };
        let pose = (0..truth.pose_count()).find(holds).unwrap_or(usize::MAX);
        if first.is_none_or(|(earlier, _)| pose < earlier) {
            first = Some((pose, observe));
        }
    }
    let first =
        first.map(|(_, observe)| text(&observe.to, "station")).or_else(|| fixed.map(|k| text(&k.to, "station")).next());
    Ok(first.flatten().filter(|_| !without).unwrap_or_default().to_owned())
}

fn within(table: &str, number: usize, problems: Problems) -> Problems {
    problems.within(&phrase!("in-numbered-table", table, number))
}

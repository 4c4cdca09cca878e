//! Simulated table of observations of all kinds, in the layout that the campaign contains.

use super::observed::Item;
use super::{Scene, Turn};
use crate::stages::calibrate::selection::Input;
use crate::stages::join::Observations;
use crate::stages::kinds::{self, Measurement};
use crate::stages::orientations::{AngleOrder, ROTATION_VECTOR, state_order};
use etalon_base::message::{Message, Result};
use etalon_base::noise::Noise;
use etalon_base::pose::{Vector, minus};
use etalon_base::{error, phrase};
use etalon_campaign::ObservationsDefinition;
use etalon_formats::log_column;
use etalon_formats::table::{ASSEMBLY, XYZ};
use etalon_formats::tables::joints::stated_columns;
use etalon_identify::Kind;
use etalon_math::Factor;
use etalon_robots::Quantity;
use etalon_tables::{ColumnSource, Decimal, Delimiter, Encoding, Header, TableLayout};
use std::collections::BTreeMap;

/// Streams of the noise of the table and of the drawn poses at contacts, distinct from the streams
/// of exports.
const TABLE: u64 = 1 << 36;
const TOUCHED: u64 = 1 << 37;
/// Maximum number of Newton steps, and their convergence tolerance (mm).
const STEPS: usize = 60;
const TOUCHES_MM: f64 = 1e-10;
/// Maximum rotation of a joint in a step (rad); for sliding joints one metre counts as one radian.
const STEP_RAD: f64 = 0.3;
const RADIAN_MM: f64 = 1000.0;
/// Maximum number of draws for joints that do not reach a contact.
const ATTEMPTS: u64 = 500;

/// Cells of a row, by the name of the column in mm or deg.
type Written = BTreeMap<String, String>;

/// Text of the table of observed and known quantities; an error if it cannot be read back as
/// simulated.
pub(super) fn write(scene: &Scene, stated: &ObservationsDefinition, items: &[Item], known: &[Item]) -> Result<String> {
    writable(scene, stated)?;
    let order: Option<AngleOrder> = match &stated.orientation {
        Some(text) => Some(text.get_ref().parse().map_err(|m: Message| m.at(scene.campaign.place(text)))?),
        None => None,
    };
    let mut table = Table { scene, stated, order, noise: Noise::new(scene.truth.seed, TABLE), rows: Vec::new() };
    for turn in scene.turns(scene.truth.cycles) {
        let here: Vec<&Item> = items.iter().filter(|item| item.is_at(turn.pose)).collect();
        if here.is_empty() {
            continue;
        }
        let joints = touching(scene, turn, &here)?;
        for item in here {
            table.add(item, Some((turn, &joints)))?;
        }
    }
    known.iter().try_for_each(|item| table.add(item, None))?;
    let text = table.text();
    read_back(scene, stated, &text)?;
    Ok(text)
}

/// Rejects table formats that cannot be written.
fn writable(scene: &Scene, stated: &ObservationsDefinition) -> Result<()> {
    let TableLayout { form, columns, constants, .. } = &stated.layout;
    let kind = if form.sheet.is_some() {
        "workbook-sheet"
    } else if form.encoding.is_some_and(|encoding| encoding != Encoding::Utf8) {
        "encoding"
    } else if form.delimiter() == Delimiter::Blank || !form.widths.is_empty() {
        "blank-columns"
    } else if form.header() != Header::Rows(1)
        || stated.coverage_factor.is_some()
        || stated.kind.is_some()
        || !constants.is_empty()
        || form.is_filtered()
        || columns.values().any(|source| !matches!(source, ColumnSource::Heading(_)))
    {
        "computed-columns"
    } else if scene.truth.unmodelled.is_some() {
        "unmodelled"
    } else if !scene.robot.approached().is_empty() {
        "backlash"
    } else {
        return Ok(());
    };
    let message = error!("simulate-not-written", what = phrase!("simulated-kind", kind));
    Err(message.at(scene.campaign.place(&stated.file)).into())
}

/// Joint values of a measurement at which targets are in contact: the joint values of the truth,
/// values near them, or newly drawn values.
fn touching(scene: &Scene, turn: Turn, items: &[&Item]) -> Result<Vec<f64>> {
    let touched: Vec<(&Item, &Kind)> =
        items.iter().filter_map(|item| Some((*item, item.simulated.touches.as_ref()?))).collect();
    let pose = turn.pose as usize - 1;
    if touched.is_empty() {
        return Ok(scene.joints[pose].clone());
    }
    let mut noise = Noise::new(scene.truth.seed, TOUCHED + turn.number as u64);
    let mut touch = |item: &Item| [0; 3].map(|_| noise.gaussian(scene.u_mm(item.u_um)));
    let left: Vec<Vector> = touched.iter().map(|(item, _)| touch(item)).collect();
    let last = if scene.truth.is_drawn(pose) { ATTEMPTS } else { 1 };
    for attempt in 0..last {
        let start = match attempt {
            0 => scene.joints[pose].clone(),
            _ => scene.truth.drawn(scene.robot, pose, attempt)?,
        };
        let found = touched_from(scene, start, &touched, &left);
        let within = |q: &Vec<f64>| scene.robot.limit_violation(&scene.values, q).is_none();
        if let Some(q) = found.filter(within)
            && (last == 1 || scene.truth.is_within(scene.robot, pose, &q))
        {
            return Ok(q);
        }
    }
    Err(error!("truth-not-touching", pose = turn.pose).into())
}

/// Newton's method with minimum-norm steps from `q`.
fn touched_from(scene: &Scene, mut q: Vec<f64>, items: &[(&Item, &Kind)], left: &[Vector]) -> Option<Vec<f64>> {
    let (robot, values) = (scene.robot, &scene.values);
    let n = robot.joints().len();
    let weights: Vec<f64> =
        robot.joints().iter().map(|j| if j.quantity == Quantity::Length { RADIAN_MM } else { 1.0 }).collect();
    for _ in 0..STEPS {
        let mut by_joints = vec![0.0; 3 * robot.targets().len() * n];
        robot.joint_jacobian(values, &q, &mut by_joints);
        let (mut rows, mut rest) = (Vec::new(), Vec::new());
        for ((item, touches), left) in items.iter().zip(left) {
            let (mut p, mut own) = (robot.position(values, &q, item.target), by_joints[3 * item.target * n..].to_vec());
            if let Some(other) = touches.other_target() {
                p = minus(p, robot.position(values, &q, other));
                own.iter_mut().zip(&by_joints[3 * other * n..]).take(3 * n).for_each(|(own, by)| *own -= by);
            }
            for (normal, distance) in touches.gaps(values, p, *left) {
                rest.push(distance);
                rows.extend((0..n).map(|j| weights[j] * (0..3).map(|i| normal[i] * own[i * n + j]).sum::<f64>()));
            }
        }
        if !rest.iter().all(|v| v.is_finite()) {
            return None;
        }
        let m = rest.len();
        if rest.iter().all(|v| v.abs() < TOUCHES_MM) {
            return Some(q);
        }
        let of = |i: usize, k: usize| (0..n).map(|j| rows[i * n + j] * rows[k * n + j]).sum::<f64>();
        let square: Vec<f64> = (0..m * m).map(|at| of(at / m, at % m)).collect();
        let by = Factor::new(&square, &rest, &vec![1.0; m]).solve()?;
        let step: Vec<f64> = (0..n).map(|j| (0..m).map(|i| rows[i * n + j] * by[i]).sum()).collect();
        let longest = step.iter().fold(0.0f64, |a, b| a.max(b.abs()));
        let shorten = (STEP_RAD / longest).min(1.0);
        (0..n).for_each(|j| q[j] -= shorten * weights[j] * step[j]);
    }
    None
}

/// Rows of a table during writing.
struct Table<'a> {
    scene: &'a Scene<'a>,
    stated: &'a ObservationsDefinition,
    /// Order of the three angles of an orientation.
    order: Option<AngleOrder>,
    noise: Noise,
    rows: Vec<Written>,
}

impl Table<'_> {
    /// Writes a number in the unit of the column in the file.
    fn set(&self, row: &mut Written, column: &str, value: f64) {
        let text = format!("{:.*}", self.scene.truth.decimals, value / self.heading(column).1);
        let text = if self.stated.layout.form.decimal() == Decimal::Comma { text.replace('.', ",") } else { text };
        row.insert(column.to_owned(), text);
    }

    /// Heading of a column in the file, and factor that converts its values to mm or deg.
    fn heading(&self, column: &str) -> (String, f64) {
        let renamed = self.stated.layout.columns.iter().find_map(|(name, heading)| {
            let (canonical, factor) = log_column(name).unwrap_or_else(|| (name.clone(), 1.0));
            let ColumnSource::Heading(heading) = heading else { return None };
            (canonical == column || name == column).then(|| (heading.clone(), factor))
        });
        renamed.unwrap_or_else(|| (column.to_owned(), 1.0))
    }

    /// Adds a row of a measurement with its joint values, or of a known quantity without joint
    /// values.
    fn add(&mut self, item: &Item, measurement: Option<(Turn, &[f64])>) -> Result<()> {
        let scene = self.scene;
        let named = kinds::names().filter_map(|column| Some((column, item.cells.text(column)?)));
        let names = [("kind", item.cells.kind.as_str()), ("target", &item.cells.target)].into_iter().chain(named);
        let mut row: Written = names.map(|(column, name)| (column.to_owned(), name.to_owned())).collect();
        let (mut at, mut position) = (&[][..], [0.0; 3]);
        if let Some((turn, joints)) = measurement {
            row.insert("pose".to_owned(), turn.pose.to_string());
            row.insert("cycle".to_owned(), turn.cycle.to_string());
            for (joint, q) in scene.robot.joints().iter().zip(joints) {
                self.set(&mut row, &joint.column(), joint.quantity.outward(*q));
            }
            for (value, column) in scene.stated(turn, joints).into_iter().zip(stated_columns(scene.robot)) {
                self.set(&mut row, &column, value);
            }
            if let (true, Some(mode)) = (scene.robot.has_assembly_modes(), joints.last()) {
                row.insert(ASSEMBLY.to_owned(), format!("{mode:+.0}"));
            }
            (at, position) = (joints, scene.robot.position(&scene.values, joints, item.target));
        }
        let numbers = (item.simulated.numbers)(&mut Measurement {
            robot: scene.robot,
            values: &scene.values,
            joints: at,
            target: item.target,
            position,
            sigma_mm: scene.u_mm(item.u_um),
            sigma_rad: scene.u_rad(item.urot_deg),
            order: self.order,
            is_vector: ROTATION_VECTOR.iter().any(|column| self.heading(column).0 != *column),
            noise: &mut self.noise,
        })?;
        let stated = [("u_mm", item.u_um.map(|um| um / 1000.0)), ("urot_deg", item.urot_deg)];
        let stated = stated.into_iter().filter_map(|(column, u)| Some((column, u?)));
        numbers.into_iter().chain(stated).for_each(|(column, value)| self.set(&mut row, column, value));
        self.rows.push(row);
        Ok(())
    }

    /// Text of the table, without columns that no row needs and columns that the campaign contains
    /// instead.
    fn text(&self) -> String {
        let layout = &self.stated.layout;
        let joints = self.scene.robot.joints().iter().map(|joint| joint.column());
        let joints = joints.chain(stated_columns(self.scene.robot));
        let columns = ["kind", "pose", "cycle", "target"].map(str::to_owned).into_iter().chain(joints);
        let more = [ASSEMBLY].into_iter().chain(kinds::names()).chain(XYZ).chain(kinds::numbers());
        let columns = columns.chain(more.chain(["u_mm", "urot_deg"]).map(str::to_owned));
        let is_stated = |column: &str| match column {
            "target" => self.stated.target.is_some(),
            "pose" => layout.pose.is_some(),
            "kind" => self.rows.iter().all(|row| kinds::kind(&row["kind"]).is_ok_and(|kind| kind.facts().has_position)),
            "cycle" => self.scene.truth.cycles == 1,
            _ => false,
        };
        let filled = |column: &String| self.rows.iter().any(|row| row.get(column).is_some_and(|cell| !cell.is_empty()));
        let columns: Vec<String> = columns.filter(|column| filled(column) && !is_stated(column)).collect();
        let separator = layout.form.delimiter().byte().map(char::from).unwrap_or(' ').to_string();
        let line = |cells: Vec<String>| cells.join(&separator) + "\n";
        let header = line(columns.iter().map(|column| self.heading(column).0).collect());
        let row = |row: &Written| line(columns.iter().map(|c| row.get(c).cloned().unwrap_or_default()).collect());
        header + &self.rows.iter().map(row).collect::<String>()
    }
}

impl Scene<'_> {
    /// Standard deviation of a length (mm), from the uncertainty given in the row or otherwise the
    /// instrument's. The ratio of `noise_um` to the instrument's uncertainty scales all rows.
    fn u_mm(&self, stated_um: Option<f64>) -> f64 {
        let instrument = self.campaign.file.instrument.standard_uncertainty_mm();
        stated_um.map_or(instrument, |um| um / 1000.0) * self.noise_scale()
    }

    /// Standard deviation of an angle (rad), from the uncertainty given in the row or otherwise
    /// the instrument's.
    fn u_rad(&self, stated_deg: Option<f64>) -> std::result::Result<f64, Message> {
        let instrument = self.campaign.file.instrument.rotation_uncertainty_rad();
        let stated = stated_deg.map(f64::to_radians).or(instrument);
        let stated = stated.ok_or_else(|| error!("angle-uncertainty-missing"))?;
        Ok(stated * self.noise_scale())
    }

    fn noise_scale(&self) -> f64 {
        let instrument = self.campaign.file.instrument.standard_uncertainty_mm();
        self.truth.noise_um.map_or(1.0, |um| um / 1000.0 / instrument)
    }
}

/// Checks that the table reads back: a heading that the form gives to two columns is an error.
fn read_back(scene: &Scene, stated: &ObservationsDefinition, text: &str) -> Result<()> {
    let (campaign, file) = (scene.campaign, stated.file.get_ref());
    let here = || campaign.place(&stated.file);
    let mut table =
        etalon_formats::observations_with(file, text, &stated.reading()).map_err(|more| more.at(&here()))?;
    if let Some(order) = &stated.orientation {
        state_order(&mut table, order.get_ref());
    }
    let Some(identify) = &campaign.file.identify else { return Ok(()) };
    let mut robot = campaign.build_robot_with(&kinds::targets(&table, &campaign.robot.branches())?)?;
    let table = Observations::Table(table);
    Input::new(campaign, identify, &table)?.read(robot.as_mut(), &mut Vec::new()).map(|_| ())
}

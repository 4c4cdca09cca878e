//! A table of observations of every kind, in the layout that the campaign states.

use super::observed::{Item, What};
use super::{Scene, Turn};
use crate::stages::identification::Input;
use crate::stages::join::Observations;
use crate::stages::kinds;
use crate::stages::orientations::{ANGLES, AngleOrder, ROTATION_VECTOR};
use etalon_base::message::{Message, Result};
use etalon_base::noise::Noise;
use etalon_base::pose::{Pose, Vector, minus, norm};
use etalon_campaign::ObservationsDefinition;
use etalon_formats::dialect::{Decimal, Delimiter, Encoding};
use etalon_formats::log_column;
use etalon_formats::table::{ASSEMBLY, QUATERNION, XYZ};
use etalon_math::Factor;
use etalon_robots::Quantity;
use std::collections::BTreeMap;

/// Streams of the noise of the table, and of what joints touch: no export has them.
const TABLE: u64 = 1 << 36;
const TOUCHED: u64 = 1 << 37;
/// Steps of Newton's method, and how near they have to come, mm.
const STEPS: usize = 60;
const TOUCHES_MM: f64 = 1e-10;
/// A step turns no joint further than this, rad; of joints that slide a metre counts as much as a radian.
const STEP_RAD: f64 = 0.3;
const RADIAN_MM: f64 = 1000.0;
/// How often joints are drawn again that do not come to what they touch.
const ATTEMPTS: u64 = 500;
/// What is read may be this many standard uncertainties from what is meant.
const FAR: f64 = 8.0;

/// Cells of a row by the column in mm or deg.
type Cells = BTreeMap<String, String>;

/// The text of the table; an error where it would not be read as it is meant.
pub(super) fn write(scene: &Scene, stated: &ObservationsDefinition, items: &[Item]) -> Result<String> {
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
            table.observe(turn, &joints, item)?;
        }
    }
    table.known();
    let text = table.text();
    read_back(scene, stated, &text)?;
    Ok(text)
}

/// An error about a table that is not written.
fn writable(scene: &Scene, stated: &ObservationsDefinition) -> Result<()> {
    let what = if stated.sheet.is_some() {
        "a sheet of a workbook"
    } else if stated.encoding.is_some_and(|encoding| encoding != Encoding::Utf8) {
        "a table in another encoding than UTF-8"
    } else if stated.layout().delimiter == Delimiter::Blank {
        "a table of observations with blanks between columns: cells that a row does not need are empty"
    } else if scene.truth.unmodelled.is_some() {
        "a table of observations with errors of [unmodelled]"
    } else if !scene.robot.approached().is_empty() {
        "a table of observations of a robot with backlash"
    } else {
        return Ok(());
    };
    Err(Message::error(format!("simulate does not write {what}")).at(scene.campaign.place(&stated.file)).into())
}

/// Joint values of a measurement: those of the truth, or those near them, or drawn again, at which targets are where they touch.
fn touching(scene: &Scene, turn: Turn, items: &[&Item]) -> Result<Vec<f64>> {
    let touched: Vec<&&Item> = items.iter().filter(|item| item.what.constrains()).collect();
    let pose = turn.pose as usize - 1;
    if touched.is_empty() {
        return Ok(scene.joints[pose].clone());
    }
    let mut noise = Noise::new(scene.truth.seed, TOUCHED + turn.number as u64);
    let mut touch = |item: &Item| [0; 3].map(|_| noise.gaussian(scene.u_mm(item.stated.u_um)));
    let left: Vec<Vector> = touched.iter().map(|item| touch(item)).collect();
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
    let message =
        Message::error(format!("pose {}: no joint values near those of the truth touch what they should", turn.pose));
    Err(message.hint("state joint values that come near to it, or a wider range of drawn ones").into())
}

/// Newton's method with steps of least norm, from `q`.
fn touched_from(scene: &Scene, mut q: Vec<f64>, items: &[&&Item], left: &[Vector]) -> Option<Vec<f64>> {
    let (robot, values) = (scene.robot, &scene.values);
    let n = robot.joints().len();
    let weights: Vec<f64> =
        robot.joints().iter().map(|j| if j.quantity == Quantity::Length { RADIAN_MM } else { 1.0 }).collect();
    for _ in 0..STEPS {
        let mut by_joints = vec![0.0; 3 * robot.targets().len() * n];
        robot.joint_jacobian(values, &q, &mut by_joints);
        let (mut rows, mut rest) = (Vec::new(), Vec::new());
        for (item, left) in items.iter().zip(left) {
            let p = robot.position(values, &q, item.target);
            for (normal, distance) in gaps(item.what, values, p, *left) {
                rest.push(distance);
                let own = &by_joints[3 * item.target * n..];
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

/// How far the target at `p` is from where it should be, and along what that is measured.
fn gaps(what: What, values: &[f64], p: Vector, left: Vector) -> Vec<(Vector, f64)> {
    match what {
        What::Contact(socket) => {
            let axis = |k: usize| [0, 1, 2].map(|i| if i == k { 1.0 } else { 0.0 });
            (0..3).map(|k| (axis(k), p[k] - values[socket + k] - left[k])).collect()
        }
        What::On(surface, unknowns, offset_mm) => {
            let unknowns = unknowns.map(|i| values[i]);
            let (distances, by) = (surface.residuals(p, unknowns), surface.gradients(p, unknowns));
            let row = |k: usize| ([by[k][0], by[k][1], by[k][2]], distances[k] - offset_mm - left[k]);
            (0..surface.rows()).map(row).collect()
        }
        _ => Vec::new(),
    }
}

/// The rows of a table while it is written.
struct Table<'a> {
    scene: &'a Scene<'a>,
    stated: &'a ObservationsDefinition,
    /// The order of three angles of an orientation.
    order: Option<AngleOrder>,
    noise: Noise,
    rows: Vec<Cells>,
}

impl Table<'_> {
    /// The first three parameters of a fixed thing.
    fn point(&self, first: usize) -> Vector {
        [0, 1, 2].map(|i| self.scene.values[first + i])
    }

    /// A point as a station measures it, before noise.
    fn seen_from(&self, station: usize, p: Vector) -> Vector {
        let turned = Pose::from_rotation_vector(self.point(station + 3));
        Pose { translation_mm: self.point(station), ..turned }.inverse().apply(p)
    }

    fn add_noise(&mut self, p: Vector, sigma_mm: f64) -> Vector {
        p.map(|v| v + self.noise.gaussian(sigma_mm))
    }

    fn set(&self, row: &mut Cells, column: &str, value: f64) {
        row.insert(column.to_owned(), self.number(column, value));
    }

    /// A number in the unit that the column has in the file.
    fn number(&self, column: &str, value: f64) -> String {
        let text = format!("{:.*}", self.scene.truth.decimals, value / self.heading(column).1);
        if self.stated.layout().decimal == Decimal::Comma { text.replace('.', ",") } else { text }
    }

    /// The heading of a column in the file, and what takes its values to mm or deg.
    fn heading(&self, column: &str) -> (String, f64) {
        let renamed = self.stated.columns.iter().find_map(|(name, heading)| {
            let (canonical, factor) = log_column(name).unwrap_or_else(|| (name.clone(), 1.0));
            (canonical == column || name == column).then(|| (heading.clone(), factor))
        });
        renamed.unwrap_or_else(|| (column.to_owned(), 1.0))
    }

    /// Adds a row of what is observed at a pose.
    fn observe(&mut self, turn: Turn, joints: &[f64], item: &Item) -> Result<()> {
        let (scene, stated) = (self.scene, item.stated);
        let mut row = texts(&stated.kind, &stated.target, &stated.to);
        row.insert("pose".to_owned(), turn.pose.to_string());
        row.insert("cycle".to_owned(), turn.cycle.to_string());
        for (joint, q) in scene.robot.joints().iter().zip(joints) {
            self.set(&mut row, &joint.column(), joint.quantity.outward(*q));
        }
        if let (true, Some(mode)) = (scene.robot.has_assembly_modes(), joints.last()) {
            row.insert(ASSEMBLY.to_owned(), format!("{mode:+.0}"));
        }
        let sigma_mm = scene.u_mm(stated.u_um);
        let p = scene.robot.position(&scene.values, joints, item.target);
        match item.what {
            What::Point(which) => {
                let seen = self.add_noise(p, sigma_mm);
                let dimension = scene.robot.dimension();
                for axis in (0..dimension).filter(|&axis| which[axis]) {
                    self.set(&mut row, XYZ[axis], seen[axis]);
                }
            }
            What::Station(station) => {
                let seen = self.add_noise(self.seen_from(station, p), sigma_mm);
                (0..3).for_each(|axis| self.set(&mut row, XYZ[axis], seen[axis]));
            }
            What::Body(mounting) => {
                let seen = self.add_noise(p, sigma_mm);
                (0..3).for_each(|axis| self.set(&mut row, XYZ[axis], seen[axis]));
                let arm = scene.robot.free_base().ok_or_else(|| not_of("poses", scene.robot.model()))?;
                let body = arm.flange(&scene.values, joints).then(&Pose::from_rotation_vector(self.point(mounting)));
                let off = self.add_noise([0.0; 3], scene.u_rad(stated.urot_deg)?);
                self.orientation(&mut row, &Pose::from_rotation_vector(off).then(&body));
            }
            What::Distance(to) => {
                let distance = norm(minus(p, self.point(to))) + self.noise.gaussian(sigma_mm);
                self.set(&mut row, "distance_mm", distance);
            }
            What::Joint(joint) => {
                let arm = scene.robot.free_base();
                let value = arm.and_then(|arm| arm.joint_value(&scene.values, joints, joint, &mut |_, _| ()));
                let value = value.ok_or_else(|| not_of("values of joints", scene.robot.model()))?;
                let quantity = scene.robot.joints()[joint].quantity;
                let sigma = if quantity == Quantity::Angle { scene.u_rad(stated.urot_deg)? } else { sigma_mm };
                let value = quantity.outward(value + self.noise.gaussian(sigma));
                self.set(&mut row, if quantity == Quantity::Angle { "value_deg" } else { "value_mm" }, value);
            }
            What::On(_, _, offset_mm) if stated.kind != "line" => self.set(&mut row, "offset_mm", offset_mm),
            What::Contact(_) | What::On(..) | What::Radius(_) => {}
        }
        self.uncertainty(&mut row, "u_mm", stated.u_um.map(|um| um / 1000.0));
        self.uncertainty(&mut row, "urot_deg", stated.urot_deg);
        self.rows.push(row);
        Ok(())
    }

    fn uncertainty(&self, row: &mut Cells, column: &str, value: Option<f64>) {
        if let Some(value) = value {
            row.insert(column.to_owned(), self.number(column, value));
        }
    }

    /// The orientation of a body: angles where the campaign states their order, a rotation vector where it names its columns, or a quaternion.
    fn orientation(&self, row: &mut Cells, body: &Pose) {
        let is_vector = ROTATION_VECTOR.iter().any(|column| self.heading(column).0 != *column);
        let (columns, values) = match self.order {
            Some(order) => (&ANGLES[..], order.angles(body).map(f64::to_degrees).to_vec()),
            None if is_vector => (&ROTATION_VECTOR[..], body.rotation_vector_rad().map(f64::to_degrees).to_vec()),
            None => (&QUATERNION[..], body.quaternion().to_vec()),
        };
        columns.iter().zip(values).for_each(|(column, value)| self.set(row, column, value));
    }

    /// Adds the rows about fixed things.
    fn known(&mut self) {
        for (stated, what, point) in &self.scene.known {
            let mut row = texts(&stated.kind, &stated.target, &stated.to);
            let sigma_mm = self.scene.u_mm(Some(stated.u_um));
            match *what {
                What::Distance(to) => {
                    let distance = norm(minus(self.point(*point), self.point(to))) + self.noise.gaussian(sigma_mm);
                    self.set(&mut row, "distance_mm", distance);
                }
                What::Radius(radius) => {
                    let length = self.scene.values[radius] + self.noise.gaussian(sigma_mm);
                    self.set(&mut row, "distance_mm", length);
                }
                What::On(..) => {
                    let left = self.add_noise([0.0; 3], sigma_mm);
                    let place = self.scene.on_surface(*what, stated.near_mm.unwrap_or_default(), left);
                    (0..3).for_each(|axis| self.set(&mut row, XYZ[axis], place[axis]));
                }
                _ => {
                    let place = match *what {
                        What::Station(station) => self.seen_from(station, self.point(*point)),
                        _ => self.point(*point),
                    };
                    let place = self.add_noise(place, sigma_mm);
                    (0..3).for_each(|axis| self.set(&mut row, XYZ[axis], place[axis]));
                }
            }
            self.uncertainty(&mut row, "u_mm", Some(stated.u_um / 1000.0));
            self.rows.push(row);
        }
    }

    /// The table: columns that no row needs are left out, and those that the campaign states in their place.
    fn text(&self) -> String {
        let layout = self.stated.layout();
        let joints = self.scene.robot.joints().iter().map(|joint| joint.column());
        let texts = ["socket", "other", "plane", "line_name", "sphere", "axis", "station", "joint"].map(str::to_owned);
        let numbers = ["offset_mm", "distance_mm", "value_deg", "value_mm"].map(str::to_owned);
        let first = ["kind", "pose", "cycle", "target"].map(str::to_owned).into_iter();
        let orientations = QUATERNION.into_iter().chain(ROTATION_VECTOR).chain(ANGLES).map(str::to_owned);
        let columns = first.chain(joints).chain([ASSEMBLY.to_owned()]).chain(texts);
        let columns = columns.chain(XYZ.map(str::to_owned)).chain(orientations).chain(numbers);
        let columns = columns.chain(["u_mm", "urot_deg"].map(str::to_owned));
        let is_stated = |column: &str| match column {
            "target" => layout.target.is_some(),
            "pose" => layout.pose.is_some(),
            "kind" => self.rows.iter().all(|row| row["kind"] == "point" || row["kind"] == "pose"),
            "cycle" => self.scene.truth.cycles == 1,
            _ => false,
        };
        let filled = |column: &String| self.rows.iter().any(|row| row.get(column).is_some_and(|cell| !cell.is_empty()));
        let columns: Vec<String> = columns.filter(|column| filled(column) && !is_stated(column)).collect();
        let separator = layout.delimiter.byte().map(char::from).unwrap_or(' ').to_string();
        let line = |cells: Vec<String>| cells.join(&separator) + "\n";
        let header = line(columns.iter().map(|column| self.heading(column).0).collect());
        let row = |row: &Cells| line(columns.iter().map(|c| row.get(c).cloned().unwrap_or_default()).collect());
        header + &self.rows.iter().map(row).collect::<String>()
    }
}

/// The names in a row.
fn texts(kind: &str, target: &str, to: &super::To) -> Cells {
    let names = [
        ("other", &to.other),
        ("socket", &to.socket),
        ("plane", &to.plane),
        ("line_name", &to.line_name),
        ("sphere", &to.sphere),
        ("station", &to.station),
        ("joint", &to.joint),
        ("axis", &to.axis),
    ];
    let named = names.into_iter().filter_map(|(column, name)| Some((column.to_owned(), name.clone()?)));
    let first = [("kind".to_owned(), kind.to_owned()), ("target".to_owned(), target.to_owned())];
    first.into_iter().chain(named).collect()
}

fn not_of(what: &str, model: &str) -> Message {
    Message::error(format!("{what} are for arms in space, not for `{model}`"))
}

impl Scene<'_> {
    /// Standard deviation of a length, of a row that states its uncertainty or not, mm: `noise_um` over the instrument's uncertainty scales all.
    fn u_mm(&self, stated_um: Option<f64>) -> f64 {
        let instrument = self.campaign.file.instrument.standard_uncertainty_mm();
        stated_um.map_or(instrument, |um| um / 1000.0) * self.noise_scale()
    }

    /// The same of an angle, rad.
    fn u_rad(&self, stated_deg: Option<f64>) -> Result<f64> {
        let instrument = self.campaign.file.instrument.rotation_uncertainty_rad();
        let stated = stated_deg.map(f64::to_radians).or(instrument).ok_or_else(|| {
            Message::error("the uncertainty of an angle is not stated")
                .hint("state `expanded_rotation_uncertainty_deg` in [instrument], or `urot_deg` in the [[observe]]")
        })?;
        Ok(stated * self.noise_scale())
    }

    fn noise_scale(&self) -> f64 {
        let instrument = self.campaign.file.instrument.standard_uncertainty_mm();
        self.truth.noise_um.map_or(1.0, |um| um / 1000.0 / instrument)
    }

    /// The place on a surface that is nearest to `p`, or off it by `left`.
    fn on_surface(&self, what: What, mut p: Vector, left: Vector) -> Vector {
        for _ in 0..STEPS {
            for (normal, distance) in gaps(what, &self.values, p, left) {
                let square = normal.iter().map(|v| v * v).sum::<f64>();
                (0..3).for_each(|i| p[i] -= distance * normal[i] / square);
            }
        }
        p
    }
}

/// An error where the table is not read as it is meant: other poses, or measurements far from those of the truth.
fn read_back(scene: &Scene, stated: &ObservationsDefinition, text: &str) -> Result<()> {
    let (campaign, file) = (scene.campaign, stated.file.get_ref());
    let here = || campaign.place(&stated.file);
    let table = etalon_formats::observations_with(file, text, &stated.layout()).map_err(|more| more.at(&here()))?;
    let Some(identify) = &campaign.file.identify else { return Ok(()) };
    let mut robot = campaign.build_robot_with(&kinds::targets(&table)?)?;
    let table = Observations::Table(table);
    let read = Input::of(campaign, identify, &table)?.read(robot.as_mut(), &mut Vec::new())?;
    let value = |p: &etalon_robots::Parameter| scene.robot.index(&p.name).map_or(p.nominal, |i| scene.values[i]);
    let values: Vec<f64> = robot.parameters().iter().map(value).collect();
    let instrument = campaign.file.instrument.standard_uncertainty_mm();
    let rounding = 10f64.powi(-(scene.truth.decimals as i32)) * 1e3;
    let largest_u_mm =
        scene.truth.observe.iter().filter_map(|o| o.u_um).map(|um| um / 1000.0).fold(instrument, f64::max);
    let points = read
        .observations
        .iter()
        .flat_map(|o| o.misses(robot.as_ref(), &values).map(|(_, miss)| (o.pose, norm(miss), largest_u_mm)));
    let others = read.settings.conditions.iter();
    let others = others.map(|c| (c.pose, norm(c.error(robot.as_ref(), &values)), c.standard_uncertainty));
    let far = points.chain(others).find(|(_, off, u)| *off > FAR * u * scene.noise_scale().max(1.0) + rounding);
    let Some((pose, off, _)) = far else { return Ok(()) };
    let what = format!(
        "`{file}` would not be read as it is meant: an observation of pose {pose} is off by {off:.3} mm or rad"
    );
    let hint = "`pose = \"row\"` and `target` of [observations] are for one target and one row a pose";
    Err(Message::error(what).at(here()).hint(hint).into())
}

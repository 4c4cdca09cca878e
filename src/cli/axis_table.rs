//! Command `etalon axis-table`.

use super::export::Exported;
use super::kinematics::joint_names;
use super::{Output, Verdict};
use crate::run::documents::Documents;
use crate::stages::table_file::TableFile;
use crate::tasks::kinematics::identified;
use crate::tasks::whole_pose;
use etalon_base::catalogue::Phrase;
use etalon_base::files;
use etalon_base::message::{Place, Problems, Result, Severity};
use etalon_base::pose::Pose;
use etalon_base::{error, phrase, warning};
use etalon_controllers::axis_tables::{self, Deviation, MachineAxes, Plane, Sign};
use etalon_documents::{CampaignSummary, GeometricDocument, LeadResult};
use etalon_formats::table::{QUATERNION, XYZ};
use etalon_robots::{Calibrated, Kinematics, Quantity};
use std::cmp::Ordering;
use std::path::{Path, PathBuf};

/// Compensation table of an axis, or of a plane, from identified parameters, from leads, or from
/// measured errors.
#[derive(Debug, clap::Args)]
#[command(after_help = "Sources:
  parameters.json  one joint: its own error (lead, gain, zero, harmonics, backlash); two prismatic joints: the error of the tool;
                   x, y, z: the error of a robot whose controller computes with nominal geometry
  geometric.json   lead and linearity of an actuator: rho1_mm, rho2_mm or rho3_mm
  table (CSV)      measured errors: a column for each base axis, and `deviation` (attained minus programmed), or `forward` and
                   `backward` for each direction of motion

Example:
  etalon axis-table out/parameters.json --robot robot.toml --axis x=0:300:25 --axis y=0:200:25 --corrected y --to beckhoff-plane --sign add")]
pub struct AxisTable {
    /// File parameters.json, geometric.json or a table of measured errors.
    source: PathBuf,
    /// Robot file, for parameters.json.
    #[arg(long, value_name = "FILE")]
    robot: Option<PathBuf>,
    /// Base axis with its positions (mm or deg): x_mm, y_mm, z_mm (or x, y, z) or the column of a
    /// joint; twice for a plane. A table of measured errors contains its positions already.
    #[arg(long = "axis", value_name = "NAME[=FROM:TO:STEP]", required = true, value_parser = base_axis)]
    axes: Vec<BaseAxis>,
    /// Corrected axis; the first base axis by default.
    #[arg(long, value_name = "NAME")]
    corrected: Option<String>,
    /// Values of other axes: x, y, z, qw, qx, qy, qz or joints; zero by default.
    #[arg(long, value_name = "NAME=VALUE,...", value_delimiter = ',', value_parser = assignment)]
    at: Vec<(String, f64)>,
    /// Positions of the base axes at which the table is zero, such as the reference point.
    #[arg(long, value_name = "N,N", value_delimiter = ',', allow_hyphen_values = true)]
    zero_at: Vec<f64>,
    /// Format to write.
    #[arg(long, value_enum, default_value = "csv")]
    to: Controller,
    /// Sign of the values: the control adds or subtracts them. For tables without a published sign.
    #[arg(long, value_enum)]
    sign: Option<Sign>,
    /// Numbers of the axes in the control: base axes, then the corrected axis if it is another.
    #[arg(long, value_name = "N,N", value_delimiter = ',', default_values_t = [1, 2, 3])]
    numbers: Vec<usize>,
    /// Number of the table in the control, for `sinumerik-cec`.
    #[arg(long, value_name = "N", default_value_t = 0)]
    table: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Controller {
    /// Base axes and `deviation`; of an axis with backlash `forward` and `backward`.
    Csv,
    /// LinuxCNC: COMP_FILE with COMP_FILE_TYPE = 0.
    Linuxcnc,
    /// Beckhoff CNC: kw.ssfk.
    Beckhoff,
    /// Beckhoff CNC: kw.crosscomp2 over two axes; needs --sign.
    BeckhoffPlane,
    /// SINUMERIK: $AA_ENC_COMP.
    Sinumerik,
    /// SINUMERIK: $AN_CEC, one axis by another or by itself; needs --sign.
    SinumerikCec,
}

impl Controller {
    /// `true` for tables with a value for each direction of motion.
    fn has_directions(self) -> bool {
        matches!(self, Self::Csv | Self::Linuxcnc | Self::Beckhoff)
    }
}

/// Column of errors that are equal in both directions of motion.
const DEVIATION: &str = "deviation";
/// Columns of errors in positive and in negative direction of motion.
const BOTH: [&str; 2] = ["forward", "backward"];

/// A base axis with its positions, if given.
#[derive(Clone, Debug)]
struct BaseAxis {
    name: String,
    positions: Vec<f64>,
}

/// Maximum number of positions in a table.
const MOST_POSITIONS: usize = 100_000;

/// Parses NAME or NAME=FROM:TO:STEP.
fn base_axis(text: &str) -> std::result::Result<BaseAxis, String> {
    let (name, range) = text.split_once('=').map_or((text, None), |(name, range)| (name, Some(range)));
    let name = if XYZ.iter().any(|known| known.strip_suffix("_mm") == Some(name)) {
        format!("{name}_mm")
    } else {
        name.to_owned()
    };
    let Some(range) = range else { return Ok(BaseAxis { name, positions: Vec::new() }) };
    let numbers: Vec<f64> = range.split(':').filter_map(|v| v.trim().parse().ok()).collect();
    let [from, to, step] = numbers[..] else { return Err("expected NAME=FROM:TO:STEP".to_owned()) };
    let intervals = ((to - from) / step).round();
    if !(intervals >= 1.0
        && intervals < MOST_POSITIONS as f64
        && (from + intervals * step - to).abs() < 1e-9 * step.abs())
    {
        return Err(phrase!("axis-steps-not-whole", from, to, step).to_string());
    }
    Ok(BaseAxis { name, positions: (0..=intervals as usize).map(|i| from + i as f64 * step).collect() })
}

fn assignment(text: &str) -> std::result::Result<(String, f64), String> {
    let (name, value) = text.split_once('=').ok_or("expected NAME=VALUE")?;
    let value = value.trim().parse::<f64>().ok().filter(|v| v.is_finite());
    Ok((base_axis(name)?.name, value.ok_or_else(|| phrase!("assignment-without-number", name).to_string())?))
}

/// Deviations in positive and in negative direction of the corrected axis; equal without backlash.
type Both = [f64; 2];

/// Source of deviations.
enum Deviations<'a> {
    Joint {
        robot: &'a Calibrated<'a>,
        joints: Vec<f64>,
        bases: Vec<usize>,
        corrected: usize,
    },
    Pose {
        robot: &'a Calibrated<'a>,
        at: Pose,
        bases: Vec<usize>,
        corrected: usize,
    },
    Lead(&'a LeadResult),
    /// Measured errors by position.
    Measured(Vec<(Vec<f64>, Both)>),
}

impl Deviations<'_> {
    /// Attained minus programmed position of the corrected axis at positions of the base axes (mm
    /// or deg); `near` holds the joint values before the motion.
    fn deviation(&self, positions: &[f64], near: &mut Vec<f64>) -> std::result::Result<Both, Phrase> {
        let one = |deviation: f64| [deviation; 2];
        match self {
            Self::Joint { robot, joints, bases, corrected } => {
                let (all, mut q) = (robot.arm.joints(), joints.clone());
                bases.iter().zip(positions).for_each(|(&joint, v)| q[joint] = all[joint].quantity.inward(*v));
                let of = |direction: f64| {
                    let q = approached(robot.arm, &q, *corrected, direction);
                    let deviation = if bases == &[*corrected] {
                        robot.joint_deviation(&q, *corrected)
                    } else {
                        let moved = moved(bases, *corrected);
                        let index = moved.iter().position(|joint| joint == corrected).unwrap_or_default();
                        robot.joint_deviations(&q, &moved).map(|all| all[index])
                    };
                    Ok(all[*corrected].quantity.outward(deviation.ok_or_else(|| phrase!("axis-without-errors"))?))
                };
                Ok([of(1.0)?, of(-1.0)?])
            }
            Self::Pose { robot, at, bases, corrected } => {
                let mut wanted = *at;
                bases.iter().zip(positions).for_each(|(&axis, v)| wanted.translation_mm[axis] = *v);
                let moved = moved(bases, *corrected);
                Ok(one(robot.position_deviation(&wanted, &moved, near)?[*corrected]))
            }
            Self::Lead(lead) => {
                let rows = &lead.linearity;
                let within =
                    rows.windows(2).find(|pair| (pair[0].commanded_mm..=pair[1].commanded_mm).contains(&positions[0]));
                let [a, b] = within.ok_or_else(|| phrase!("lead-not-measured-there"))? else {
                    return Err(phrase!("lead-not-measured-there"));
                };
                let part = (positions[0] - a.commanded_mm) / (b.commanded_mm - a.commanded_mm);
                Ok(one(lead.error * positions[0] + a.deviation_mm + part * (b.deviation_mm - a.deviation_mm)))
            }
            Self::Measured(rows) => {
                let order = |at: &[f64]| at.partial_cmp(positions).unwrap_or(Ordering::Less);
                let row = rows.binary_search_by(|(at, _)| order(at));
                row.map(|row| rows[row].1).map_err(|_| phrase!("table-without-row"))
            }
        }
    }
}

/// Joint values, followed by the direction of approach of each joint with backlash: the given one
/// for `joint`, the middle of the backlash for all others.
fn approached(arm: &dyn Kinematics, q: &[f64], joint: usize, direction: f64) -> Vec<f64> {
    let directions = arm.approached().iter().map(|other| if *other == joint { direction } else { 0.0 });
    q.iter().copied().chain(directions).collect()
}

/// Axes that a table can move: the base axes and the corrected axis.
fn moved(bases: &[usize], corrected: usize) -> Vec<usize> {
    bases.iter().copied().chain((!bases.contains(&corrected)).then_some(corrected)).collect()
}

/// Source in memory.
enum Read {
    Parameters(Box<Exported>),
    Leads(Box<GeometricDocument>),
    Measured(TableFile),
}

impl AxisTable {
    pub(super) fn run(mut self, out: &Output) -> anyhow::Result<Verdict> {
        self.consistent()?;
        let (read, header) = self.read(out)?;
        let calibrated;
        let source = match &read {
            Read::Parameters(exported) => {
                let given = exported.input(false);
                let arm = given.robot.map_or_else(|| Err(error!("robot-option-missing").into()), whole_pose)?;
                let identified = identified(arm, given.parameters, &self.source)?;
                calibrated = Calibrated { arm, nominal: arm.nominal(), identified, field: None };
                self.robot_deviations(&calibrated)?
            }
            Read::Leads(geometric) => self.lead_deviations(geometric)?,
            Read::Measured(file) => self.table_deviations(file)?,
        };
        let rows = self.rows(&source)?;
        let largest = rows.iter().flatten().flatten().fold(0.0, |most: f64, v| most.max(v.abs()));
        let count = rows.iter().map(Vec::len).sum::<usize>();
        let unit = unit(self.corrected());
        out.say(phrase!("axis-table-largest", count, largest, unit));
        let backlash = rows.iter().flatten().map(|[forward, backward]| backward - forward);
        let backlash = backlash.fold(0.0, |most: f64, b| if b.abs() > most.abs() { b } else { most });
        if backlash != 0.0 && !self.to.has_directions() {
            out.remark(&[warning!("backlash-not-in-table", axis = self.corrected(), backlash, unit)]);
        }
        out.print(self.text(rows, &header)?)?;
        Ok(Verdict::Met)
    }

    fn corrected(&self) -> &str {
        self.corrected.as_deref().unwrap_or(&self.axes[0].name)
    }

    /// Rejects contradictory options.
    fn consistent(&mut self) -> Result<()> {
        self.corrected = self.corrected.take().map(|name| base_axis(&name).map_or(name, |axis| axis.name));
        let planes = self.to == Controller::BeckhoffPlane;
        let signed = planes || self.to == Controller::SinumerikCec;
        let own = self.axes.len() == 1 && self.corrected() == self.axes[0].name;
        let positions: usize = self.axes.iter().map(|axis| axis.positions.len().max(1)).product();
        let fault = match self.to {
            _ if self.axes.len() > 2 || (self.axes.len() == 2 && self.axes[0].name == self.axes[1].name) => "axes",
            _ if positions > MOST_POSITIONS => "positions",
            _ if !self.zero_at.is_empty() && self.zero_at.len() != self.axes.len() => "zero",
            _ if self.numbers.len() < 3 && self.numbers.len() <= self.axes.len() - usize::from(self.is_base()) => {
                "numbers"
            }
            _ if signed && self.sign.is_none() => "sign-missing",
            _ if !signed && self.sign.is_some() => "sign-known",
            Controller::BeckhoffPlane if self.axes.len() != 2 => "plane",
            Controller::SinumerikCec if self.axes.len() != 1 => "one-axis",
            Controller::Linuxcnc | Controller::Beckhoff | Controller::Sinumerik if !own => "own-axis",
            _ => return Ok(()),
        };
        Err(error!("table-options-refused", fault, most = MOST_POSITIONS).into())
    }

    fn is_base(&self) -> bool {
        self.axes.iter().any(|axis| axis.name == self.corrected())
    }

    /// Reads the source, and creates the header of its table.
    fn read(&self, out: &Output) -> Result<(Read, Vec<String>)> {
        let units = unit_words(self.to);
        if self.source.extension().is_some_and(|ending| ending == "csv") {
            let file = TableFile::read(&self.source)?;
            let header = axis_tables::header([], units, "the measured errors", file.text().as_bytes());
            return Ok((Read::Measured(file), header));
        }
        let bytes = files::read(&self.source)?;
        if let Ok(geometric) = serde_json::from_slice::<GeometricDocument>(&bytes) {
            let failed = geometric.messages.iter().filter(|m| m.severity == Severity::Error).cloned().collect();
            Problems(failed).check()?;
            let header = axis_tables::header(self.about(), units, "geometric.json", &bytes);
            return Ok((Read::Leads(Box::new(geometric)), header));
        }
        let exported = Exported::read(&self.source, self.robot.as_deref(), false, out)?;
        let given = exported.input(false);
        given.check()?;
        let header = given.header(units)?;
        Ok((Read::Parameters(Box::new(exported)), header))
    }

    /// Campaign and robot of a source in the output folder of a campaign.
    fn about(&self) -> impl Iterator<Item = String> {
        let folder = Documents::open(self.source.parent().unwrap_or(Path::new(""))).ok();
        let summary = folder.and_then(|folder| folder.json::<CampaignSummary>("campaign.json").ok());
        let names = summary.map(|summary| {
            let robot = summary.robot.map(|robot| format!("robot: {robot}"));
            let synthetic =
                summary.measurements.synthetic.map(|why| format!("SYNTHETIC DATA, not of a measured robot: {why}"));
            [synthetic, Some(format!("campaign: {}", summary.name)), robot]
        });
        names.into_iter().flatten().flatten()
    }

    fn robot_deviations<'a>(&self, robot: &'a Calibrated<'a>) -> Result<Deviations<'a>> {
        let cartesian = |name: &str| XYZ.iter().position(|known| *known == name);
        let joints = robot.arm.joints();
        let joint = |name: &str| joints.iter().position(|joint| joint.column() == name);
        let names = || self.axes.iter().map(|axis| axis.name.as_str()).chain([self.corrected()]);
        let mut near: Vec<f64> = vec![0.0; joint_names(robot.arm).len()];
        let mut at = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
        for (name, value) in &self.at {
            let coordinate = XYZ.iter().chain(&QUATERNION).position(|known| known == name);
            match (coordinate, joint(name)) {
                (Some(i), _) => at[i] = *value,
                (None, Some(i)) => near[i] = joints[i].quantity.inward(*value),
                _ => return Err(error!("axis-unknown", axis = name).into()),
            }
        }
        let [x, y, z, q @ ..] = at;
        let at = Pose { translation_mm: [x, y, z], ..Pose::from_quaternion(q) };
        if let Some(all) = names().map(cartesian).collect::<Option<Vec<_>>>() {
            let (bases, corrected) = (all[..self.axes.len()].to_vec(), all[self.axes.len()]);
            return Ok(Deviations::Pose { robot, at, bases, corrected });
        }
        let Some(all) = names().map(joint).collect::<Option<Vec<_>>>() else {
            let joints: Vec<String> = joints.iter().map(|joint| joint.column()).collect();
            return Err(error!("axes-mixed", joints).into());
        };
        let (bases, corrected) = (all[..self.axes.len()].to_vec(), all[self.axes.len()]);
        let chain = robot.arm.joint_chain(&robot.nominal);
        let slides =
            |&joint: &usize| chain.as_ref().is_some_and(|chain| chain.joints.get(joint).is_some_and(|j| j.prismatic));
        if bases != [corrected] && !all.iter().all(slides) {
            return Err(error!("table-of-turning-joints").into());
        }
        Ok(Deviations::Joint { robot, joints: near, bases, corrected })
    }

    fn lead_deviations<'a>(&self, geometric: &'a GeometricDocument) -> Result<Deviations<'a>> {
        let name = &self.axes[0].name;
        let lead = geometric.leads.iter().find(|lead| *name == format!("rho{}_mm", lead.actuator));
        let missing = || {
            let measured = geometric.leads.iter().map(|lead| format!("rho{}_mm", lead.actuator)).collect::<Vec<_>>();
            error!("lead-not-measured", axis = name, measured)
        };
        if self.axes.len() != 1 || self.corrected() != name {
            return Err(error!("lead-of-one-axis").into());
        }
        Ok(Deviations::Lead(lead.ok_or_else(missing)?))
    }

    /// Measured errors of a table, whose positions become the positions of the base axes.
    fn table_deviations<'a>(&mut self, file: &TableFile) -> Result<Deviations<'a>> {
        let both = BOTH.iter().any(|name| file.table.has(name)) && !file.table.has(DEVIATION);
        let errors = if both { &BOTH[..] } else { &[DEVIATION] };
        let errors = errors.iter().map(|name| (*name).to_owned());
        let names: Vec<String> = self.axes.iter().map(|axis| axis.name.clone()).chain(errors).collect();
        let directions = names.last().is_some_and(|name| *name == BOTH[1]);
        let columns = || -> Result<Vec<Vec<f64>>> {
            file.table.require(&names)?;
            names.iter().map(|name| file.table.numbers(name)).collect()
        };
        let mut columns = columns().map_err(|problems| file.place(problems))?;
        if columns.iter().flatten().any(|v| !v.is_finite()) {
            let place = Place::file(file.name.clone());
            return Err(error!("table-value-missing").at(place).into());
        }
        let backward = columns.pop().unwrap_or_default();
        let forward = if directions { columns.pop().unwrap_or_default() } else { backward.clone() };
        for (axis, positions) in self.axes.iter_mut().zip(&columns) {
            axis.positions.clone_from(positions);
            axis.positions.sort_by(f64::total_cmp);
            axis.positions.dedup();
        }
        let at = |row: usize| columns.iter().map(|column| column[row]).collect::<Vec<_>>();
        let both = forward.iter().zip(&backward).map(|(forward, backward)| [*forward, *backward]);
        let mut rows: Vec<(Vec<f64>, Both)> = both.enumerate().map(|(row, both)| (at(row), both)).collect();
        if rows.len() != self.axes.iter().map(|axis| axis.positions.len()).product::<usize>() {
            return Err(error!("not-a-grid").at(Place::file(file.name.clone())).into());
        }
        // finite numbers, sorted for fast search
        rows.sort_by(|(a, _), (b, _)| a.partial_cmp(b).unwrap_or(Ordering::Equal));
        Ok(Deviations::Measured(rows))
    }

    /// Deviations along the first axis, one row per position of the second.
    fn rows(&self, source: &Deviations) -> Result<Vec<Vec<Both>>> {
        let mut near = match source {
            Deviations::Pose { robot, .. } => vec![0.0; joint_names(robot.arm).len()],
            _ => Vec::new(),
        };
        let mut deviation = |at: &[f64]| {
            let position: Vec<String> =
                self.axes.iter().zip(at).map(|(axis, v)| format!("{} = {v}", axis.name)).collect();
            let deviation = source.deviation(at, &mut near);
            deviation.map_err(|reason| error!("deviation-unknown", position, reason))
        };
        if let Some(axis) = self.axes.iter().find(|axis| axis.positions.is_empty()) {
            return Err(error!("axis-without-positions", axis = axis.name).into());
        }
        // half of a backlash remains on either side of the zero
        let zero = if self.zero_at.is_empty() { 0.0 } else { mean(&deviation(&self.zero_at)?) };
        let seconds: Vec<Vec<f64>> = match self.axes.get(1) {
            Some(axis) => axis.positions.iter().map(|v| vec![*v]).collect(),
            None => vec![Vec::new()],
        };
        let mut row = |second: &Vec<f64>| -> Result<Vec<Both>> {
            let at = |first: &f64| [std::slice::from_ref(first), second].concat();
            self.axes[0].positions.iter().map(|first| Ok(deviation(&at(first))?.map(|d| d - zero))).collect()
        };
        seconds.iter().map(&mut row).collect()
    }

    fn text(&self, rows: Vec<Vec<Both>>, header: &[String]) -> Result<String> {
        let first = &self.axes[0].positions;
        let along = |&position: &f64, &[forward, backward]: &Both| Deviation { position, forward, backward };
        let line = |row: &Vec<Both>| first.iter().zip(row).map(|(position, d)| along(position, d)).collect::<Vec<_>>();
        rows.iter().try_for_each(|row| axis_tables::plausible(&line(row)))?;
        let line = line(&rows[0]);
        let of_base = self.axes.iter().position(|axis| axis.name == self.corrected()).unwrap_or(self.axes.len());
        let number = |i: usize| self.numbers.get(i).copied().unwrap_or(i + 1);
        let axes = MachineAxes { base: [number(0), number(1)], corrected: number(of_base) };
        let name = self.corrected().rsplit_once('_').map_or(self.corrected(), |(name, _)| name).to_uppercase();
        let name: String = name.chars().filter(char::is_ascii_alphanumeric).collect();
        let sign = self.sign.unwrap_or(Sign::Add);
        match self.to {
            Controller::Csv => Ok(self.csv(&rows)),
            Controller::Linuxcnc => axis_tables::linuxcnc(&line),
            Controller::Beckhoff => Ok(axis_tables::beckhoff(&line, &name, header)),
            Controller::Sinumerik => axis_tables::sinumerik(&line, &format!("AX{}", axes.corrected), header),
            Controller::SinumerikCec => axis_tables::sinumerik_cec(&line, axes, self.table, sign, header),
            Controller::BeckhoffPlane => {
                let ends =
                    [0, 1].map(|i| (self.axes[i].positions[0], self.axes[i].positions[1] - self.axes[i].positions[0]));
                let rows = rows.iter().map(|row| row.iter().map(mean).collect()).collect();
                let plane = Plane { start: ends.map(|end| end.0), step: ends.map(|end| end.1), rows };
                axis_tables::beckhoff_plane(&plane, axes, &name, sign, header)
            }
        }
    }

    fn csv(&self, rows: &[Vec<Both>]) -> String {
        let names: Vec<&str> = self.axes.iter().map(|axis| axis.name.as_str()).collect();
        let both = rows.iter().flatten().any(|[forward, backward]| forward != backward);
        let mut out = format!("{},{}\n", names.join(","), if both { BOTH.join(",") } else { DEVIATION.to_owned() });
        for (j, row) in rows.iter().enumerate() {
            let second = self.axes.get(1).map(|axis| format!("{:?},", axis.positions[j])).unwrap_or_default();
            for (position, [forward, backward]) in self.axes[0].positions.iter().zip(row) {
                let backward = if both { format!(",{backward:?}") } else { String::new() };
                out += &format!("{position:?},{second}{forward:?}{backward}\n");
            }
        }
        out
    }
}

/// Mean of both directions.
fn mean([forward, backward]: &Both) -> f64 {
    0.5 * (forward + backward)
}

/// Unit of a joint's column, or of a coordinate.
fn unit(name: &str) -> &'static str {
    if name.ends_with("_deg") { Quantity::Angle.unit() } else { Quantity::Length.unit() }
}

fn unit_words(to: Controller) -> &'static str {
    match to {
        Controller::Beckhoff | Controller::BeckhoffPlane => "0.1 um or 0.0001 deg",
        _ => "mm or deg",
    }
}

//! Tables of observations of several kinds: positions, poses, distances, contacts, surfaces and joints, a row each.
//!
//! The column `kind` names them; rows without a pose are about fixed points alone: their places and distances.

use crate::stages::orientations::{AngleOrder, Orientations, unstated};
use crate::stages::positions;
use etalon_base::message::{Message, Place, Problems, Result, count};
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_formats::table;
use etalon_formats::tables::joints::joint_values;
use etalon_identify::{
    Condition, Contact, Coordinate, Distance, Fixture, JointValue, Kind, Known, Measured, Observation, On, Orientation,
    Seen, Settings, Surface,
};
use etalon_robots::{Joint, Quantity, Robot};
use polars::prelude::{BooleanChunked, DataFrame, NewChunkedArray};
use std::collections::{BTreeMap, BTreeSet};

/// Kinds of rows.
const KINDS: [&str; 8] = ["point", "pose", "distance", "contact", "plane", "line", "sphere", "joints"];
/// Columns of numbers of all kinds beside those of positions.
const NUMBERS: [&str; 22] = [
    "qw",
    "qx",
    "qy",
    "qz",
    "rx_deg",
    "ry_deg",
    "rz_deg",
    "rx_rad",
    "ry_rad",
    "rz_rad",
    "a_deg",
    "b_deg",
    "c_deg",
    "a_rad",
    "b_rad",
    "c_rad",
    "value_deg",
    "value_mm",
    "distance_mm",
    "offset_mm",
    "u_mm",
    "urot_deg",
];
/// Column of the name of a line: `line` are the lines of the file.
const LINE: &str = "line_name";
/// Column of the name of the station of the instrument that measured a point.
const STATION: &str = "station";
/// Poses at which the station of the world sees the robot, at least.
const FEWEST_SEEN: usize = 3;
/// Axes of the world.
const AXES: [&str; 3] = ["x", "y", "z"];

/// Columns of all kinds beside those of positions, to which the target belongs.
pub fn columns<'a>() -> impl Iterator<Item = &'a str> {
    table::TEXTS.into_iter().filter(|name| *name != "target").chain(NUMBERS)
}

/// What is stated of all rows: standard uncertainties of those that have none, and the order of angles.
#[derive(Clone, Copy, Debug, Default)]
pub struct Stated {
    /// Of a coordinate, a distance, a contact, mm.
    pub length_mm: Option<f64>,
    /// Of a rotation about any axis, rad.
    pub rotation_rad: Option<f64>,
    /// The order of three angles of an orientation.
    pub order: Option<AngleOrder>,
}

/// What was observed, and what is identified from it.
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

/// The names in the column `target` that are on the robot, each once, in their order: those of rows with a pose.
pub fn targets(observations: &DataFrame) -> Result<Vec<String>> {
    let mut targets: Vec<String> = Vec::new();
    let fixed = fixed_rows(observations)?;
    for (name, _) in table::texts(observations, "target")?.into_iter().zip(fixed).filter(|(_, fixed)| !fixed) {
        // the value of a joint is of no target
        if !name.is_empty() && !targets.contains(&name) {
            targets.push(name);
        }
    }
    Ok(targets)
}

/// Rows that give some coordinates of a target, and not all.
fn partial_rows(robot: &dyn Robot, observations: &DataFrame) -> Result<Vec<bool>> {
    let columns = table::XYZ[..robot.dimension()].iter().filter(|name| observations.column(name).is_ok());
    let columns = columns.map(|name| table::numbers(observations, name)).collect::<Result<Vec<_>>>()?;
    let given = |row: usize| columns.iter().filter(|column| !column[row].is_nan()).count();
    // a column that is missing is a mistake
    let whole = columns.len() == robot.dimension();
    Ok((0..observations.height()).map(|row| whole && (1..robot.dimension()).contains(&given(row))).collect())
}

/// The poses of a table.
pub fn poses(observations: &DataFrame) -> Result<BTreeSet<PoseName>> {
    let named = row_poses(observations)?.into_iter().zip(fixed_rows(observations)?);
    Ok(named.filter(|(_, fixed)| !fixed).map(|(pose, _)| pose).collect())
}

/// Rows without a pose.
fn fixed_rows(observations: &DataFrame) -> Result<Vec<bool>> {
    let Ok(poses) = observations.column("pose") else { return Ok(vec![false; observations.height()]) };
    Ok(poses.is_null().iter().map(|null| null == Some(true)).collect())
}

/// Columns of names of what many rows share, and the most rows that do not determine more than a place of their own.
const SHARED: [(&str, usize); 7] =
    [("target", 1), ("socket", 1), ("other", 2), ("plane", 2), (LINE, 2), ("sphere", 2), (STATION, 2)];
/// Rows of the name that is meant, at least.
const MEANT_ROWS: usize = 6;

/// Errors about names that a row or two bear, and that are spelt almost as one of many rows: what they name would be identified from these
/// rows alone, which then say nothing of the robot. Names that differ in a counter (`P1` and `P2`, `anchor A` and `anchor B`) are different.
fn misspelt(observations: &DataFrame) -> Result<Problems> {
    let mut problems = Problems::default();
    let lines = observations.column("line").is_ok().then(|| table::integers(observations, "line")).transpose()?;
    let line = |row: usize| lines.as_ref().map(|lines| lines[row] as usize);
    let fixed = fixed_rows(observations)?;
    for (column, most) in SHARED.into_iter().filter(|(name, _)| observations.column(name).is_ok()) {
        let names = table::texts(observations, column)?;
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        problems.0.extend(misspelt_names(&names, most, |row| fixed[row], line));
    }
    Ok(problems)
}

/// An error where a target of measured positions is misspelt, as of a table.
pub(super) fn misspelt_targets(measured: &[Measured], targets: &[String]) -> Result<()> {
    let names: Vec<&str> = measured.iter().map(|m| targets[m.target].as_str()).collect();
    Problems(misspelt_names(&names, SHARED[0].1, |_| false, |_| None)).check().map(drop)
}

/// Errors about the names of rows that at most `most` rows bear; those of `fixed` rows state a place, and need no more rows.
fn misspelt_names(
    names: &[&str],
    most: usize,
    fixed: impl Fn(usize) -> bool,
    line: impl Fn(usize) -> Option<usize>,
) -> Vec<Message> {
    let mut rows: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    let named = names.iter().enumerate().filter(|(_, name)| !name.is_empty());
    named.for_each(|(row, name)| rows.entry(name).or_default().push(row));
    let few = rows.iter().filter(|(_, rows)| rows.len() <= most && !rows.iter().any(|&row| fixed(row)));
    let error = |(name, own): (&&str, &Vec<usize>)| {
        let many = rows.iter().filter(|(_, rows)| rows.len() >= MEANT_ROWS).map(|(name, _)| *name);
        let (_, meant) = many.filter_map(|meant| Some((letters_wrong(name, meant)?, meant))).min()?;
        let (alone, others) = (count(own.len(), "row"), rows[meant].len());
        let what = format!("`{name}` is named in {alone} only, and `{meant}` in {others}");
        let message = Message::error(what).at(Place { line: line(own[0]), ..Place::default() });
        Some(message.hint(format!(
            "did you mean `{meant}`? else leave the rows of `{name}` out: they do not determine where it is"
        )))
    };
    few.filter_map(error).collect()
}

/// How many letters are wrong in a name that is another one but for these, a few that are no counter.
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

/// A warning where an instrument measured positions, and joints move the base of the chain.
pub(super) fn moving_base(robot: &dyn Robot) -> Option<Message> {
    let names = robot.joints_of_base().join(", ");
    let what = format!(
        "`base_link` is moved by the joints {names}: positions are taken as measured in a frame that moves with it"
    );
    let hint = "if the instrument is fixed in the room, let `base_link` be the root of the URDF";
    (!names.is_empty()).then(|| Message::warning(what).to_decide().hint(hint))
}

/// Observations of `robot` from a table of any kinds; what they refer to is added to its parameters, and what is not the position of
/// a target to `settings`. What was taken from the measurement is in `messages`.
pub fn observed(
    robot: &mut dyn Robot,
    observations: &DataFrame,
    without: Stated,
    mut settings: Settings,
    messages: &mut Vec<Message>,
) -> Result<Observed> {
    misspelt(observations)?.check()?;
    let of_kinds = |name: &str| observations.column(name).is_ok();
    if !partial_rows(robot, observations)?.contains(&true)
        && !of_kinds("kind")
        && !of_kinds(STATION)
        && !Orientations::are_in(observations)
        && !fixed_rows(observations)?.contains(&true)
    {
        messages.extend(moving_base(robot));
        return Ok(Observed { observations: positions::observations(robot, observations, messages)?, settings });
    }
    let rows = Rows::new(robot, observations, without)?;
    let mut problems = Problems::default();
    problems.0.extend(rows.unnamed_station());
    let mut angles = Vec::new();
    for row in 0..observations.height() {
        let before = settings.conditions.len();
        if let Err(more) = rows.condition(row, robot, &mut settings) {
            problems.0.extend(more.at(&rows.place(row)).0);
        }
        let added = settings.conditions[before..].iter().filter(|c| c.kind.is_orientation());
        angles.extend(added.filter_map(|_| rows.orientations.angles(row)));
    }
    problems.check()?;
    let names = robot.parameters();
    if let Some((_, p)) = names.iter().enumerate().find(|(i, p)| names[..*i].iter().any(|other| other.name == p.name)) {
        let what = format!("`{}` would be the name of two parameters", p.name);
        return Err(Message::error(what).hint("give targets, points and planes names of their own").into());
    }
    let partial = rows.partial.iter().filter(|partial| **partial).count();
    if partial > 0 {
        let what = format!(
            "{} give one or two coordinates of their targets, which count by themselves",
            count(partial, "row")
        );
        messages.push(Message::warning(what).routine());
    }
    let has_position: BooleanChunked = BooleanChunked::from_iter_values(
        "position".into(),
        (0..observations.height()).map(|row| rows.has_position(row)),
    );
    let observations = match has_position.any() {
        true => {
            messages.extend(moving_base(robot));
            positions::observations(robot, &observations.filter(&has_position).map_err(table::failed)?, messages)?
        }
        false => Vec::new(),
    };
    if !angles.is_empty() && without.order.is_none() {
        return Err(unstated(robot, &observations, &settings, &angles).at(header()).into());
    }
    Ok(Observed { observations, settings })
}

/// The columns of a table of several kinds.
struct Rows {
    kinds: Vec<String>,
    fixed: Vec<bool>,
    /// empty cells are named 0: of rows about fixed points alone
    poses: Vec<PoseName>,
    cycles: Vec<i64>,
    targets: Vec<String>,
    robot_targets: Vec<String>,
    xyz: Vec<Vector>,
    orientations: Orientations,
    joints: Vec<Vec<f64>>,
    /// Stations other than the one whose frame is the world.
    stations: Vec<Option<String>>,
    /// Rows that name their station.
    has_station: Vec<bool>,
    sockets: Vec<String>,
    others: Vec<String>,
    /// Names of planes, lines and spheres.
    surfaces: [Vec<String>; 3],
    axes: Vec<String>,
    joint_names: Vec<String>,
    robot_joints: Vec<Joint>,
    /// Values of joints, rad or mm.
    values: [Vec<f64>; 2],
    distances_mm: Vec<f64>,
    offsets_mm: Vec<f64>,
    u_mm: Vec<f64>,
    u_axes_mm: [Vec<f64>; 3],
    partial: Vec<bool>,
    /// Rows that state a covariance.
    covariant: Vec<bool>,
    u_rotation_rad: Vec<f64>,
    lines: Vec<i64>,
    without: Stated,
}

impl Rows {
    fn new(robot: &dyn Robot, observations: &DataFrame, without: Stated) -> Result<Self> {
        let height = observations.height();
        let has = |name: &str| observations.column(name).is_ok();
        let numbers = |name: &str, default: f64| match has(name) {
            true => table::numbers(observations, name),
            false => Ok(vec![default; height]),
        };
        let texts = |name: &str| match has(name) {
            true => table::texts(observations, name),
            false => Ok(vec![String::new(); height]),
        };
        let coordinates = table::XYZ.map(|name| numbers(name, f64::NAN));
        let [x, y, z] = coordinates;
        let (x, y, z) = (x?, y?, z?);
        let column = if has("u_mm") { "u_mm" } else { "ux_mm" };
        let [ux, uy, uz] = table::UNCERTAINTIES.map(|name| numbers(name, f64::NAN));
        let covariances =
            table::COVARIANCES.map(|name| numbers(name, f64::NAN)).into_iter().collect::<Result<Vec<_>>>()?;
        Ok(Self {
            kinds: texts("kind")?,
            fixed: fixed_rows(observations)?,
            poses: row_poses(observations)?,
            cycles: if has("cycle") {
                table::optional_integers(observations, "cycle")?.into_iter().map(|c| c.unwrap_or(1)).collect()
            } else {
                vec![1; height]
            },
            targets: table::texts(observations, "target")?,
            robot_targets: robot.targets().to_vec(),
            xyz: (0..height).map(|i| [x[i], y[i], z[i]]).collect(),
            orientations: Orientations::new(observations)?,
            joints: joint_values(robot, observations, &[])?,
            has_station: texts(STATION)?.iter().map(|name| !name.is_empty()).collect(),
            stations: other_stations(texts(STATION)?, &x),
            sockets: texts("socket")?,
            others: texts("other")?,
            surfaces: [texts("plane")?, texts(LINE)?, texts("sphere")?],
            axes: texts("axis")?,
            joint_names: texts("joint")?,
            robot_joints: robot.joints().to_vec(),
            values: [
                numbers("value_deg", f64::NAN)?.into_iter().map(f64::to_radians).collect(),
                numbers("value_mm", f64::NAN)?,
            ],
            distances_mm: numbers("distance_mm", f64::NAN)?,
            offsets_mm: numbers("offset_mm", 0.0)?,
            u_mm: numbers(column, f64::NAN)?,
            u_axes_mm: [ux?, uy?, uz?],
            partial: partial_rows(robot, observations)?,
            covariant: (0..height).map(|row| covariances.iter().any(|c| !c[row].is_nan())).collect(),
            u_rotation_rad: numbers("urot_deg", f64::NAN)?.into_iter().map(f64::to_radians).collect(),
            lines: if has("line") { table::integers(observations, "line")? } else { Vec::new() },
            without,
        })
    }

    /// An error about a few rows without a station, which would be the world, beside many that have one.
    fn unnamed_station(&self) -> Option<Message> {
        let points = (0..self.fixed.len()).filter(|&row| !self.fixed[row] && self.kind(row) == "point");
        let (named, unnamed): (Vec<usize>, Vec<usize>) = points.partition(|&row| self.stations[row].is_some());
        let poses = |rows: &[usize]| rows.iter().map(|&row| self.poses[row]).collect::<BTreeSet<_>>().len();
        let all_stated = unnamed.iter().all(|&row| self.has_station[row]);
        if all_stated || poses(&unnamed) >= FEWEST_SEEN || poses(&named) < FEWEST_SEEN {
            return None;
        }
        let message =
            Message::error("the column `station` is empty here, and other points have one").at(self.place(unnamed[0]));
        Some(message.hint(
            "rows without a station would be those of the world, which has to see the robot at three poses at least",
        ))
    }

    fn place(&self, row: usize) -> Place {
        Place { line: self.lines.get(row).map(|line| *line as usize), ..Place::default() }
    }

    /// The kind of a row: a point with an orientation is a pose.
    fn kind(&self, row: usize) -> &str {
        match self.kinds[row].as_str() {
            "" if self.orientations.is_given(row) => "pose",
            "" => "point",
            kind => kind,
        }
    }

    fn has_position(&self, row: usize) -> bool {
        !self.fixed[row]
            && !self.partial[row]
            && self.stations[row].is_none()
            && matches!(self.kind(row), "point" | "pose")
            && self.xyz[row].iter().any(|v| !v.is_nan())
    }

    /// Adds what a row states to `settings`, unless it is the position of a target alone.
    fn condition(&self, row: usize, robot: &mut dyn Robot, settings: &mut Settings) -> Result<()> {
        let kind = self.kind(row);
        if !KINDS.contains(&kind) {
            return Err(Message::error(format!("`{kind}` is not a kind of observation"))
                .hint_names(kind, KINDS)
                .into());
        }
        if let Some(name) = &self.stations[row] {
            self.seen_whole(row, kind, name)?;
        }
        if self.fixed[row] {
            settings.known.push(self.known(row, kind, robot)?);
            return Ok(());
        }
        let kind = match kind {
            "pose" => {
                let mounting = Fixture::Mounting(&self.targets[row]).add_to(robot);
                Kind::Orientation(Orientation {
                    world_T_body: self.orientations.pose(row, self.without.order)?,
                    mounting,
                })
            }
            "distance" => {
                let to = self.fixture(row, "other", &self.others, robot)?;
                Kind::Distance(Distance { to, distance_mm: self.distance(row)? })
            }
            "contact" => Kind::Contact(Contact { socket: self.fixture(row, "socket", &self.sockets, robot)? }),
            "plane" | "line" | "sphere" => {
                let (surface, unknowns) = self.surface(row, kind, robot)?;
                let offset_mm = match self.offsets_mm[row] {
                    offset if kind == "line" && offset.is_nan() => 0.0,
                    offset if kind == "line" && offset != 0.0 => {
                        return Err(Message::error("`offset_mm` is of planes and spheres, not of a line").into());
                    }
                    offset if !offset.is_finite() => {
                        return Err(Message::error("`offset_mm` is missing or not a number")
                            .expected("how far the target is from the plane along that axis, or outside of the sphere: the radius of a ball, or 0")
                            .into());
                    }
                    offset => offset,
                };
                Kind::On(On { surface, unknowns, offset_mm })
            }
            "joints" => self.joint(row, robot)?,
            "point" if self.partial[row] => {
                for axis in (0..3).filter(|&axis| !self.xyz[row][axis].is_nan()) {
                    let kind = Kind::Coordinate(Coordinate { axis, at_mm: self.xyz[row][axis] });
                    self.add(row, kind, self.u_axes_mm[axis][row], settings)?;
                }
                return Ok(());
            }
            _ => match &self.stations[row] {
                Some(name) => Kind::Seen(Seen { station: self.station(name, robot)?, at_mm: self.xyz[row] }),
                None => return Ok(()),
            },
        };
        let stated = if kind.is_angle() { self.u_rotation_rad[row] } else { self.u_mm[row] };
        self.add(row, kind, stated, settings)
    }

    /// Adds a condition with the uncertainty that its row states, or that of rows that state none.
    fn add(&self, row: usize, kind: Kind, stated: f64, settings: &mut Settings) -> Result<()> {
        let stated = if stated.is_nan() && !kind.is_angle() { self.u_mm[row] } else { stated };
        let default = if kind.is_angle() { self.without.rotation_rad } else { self.without.length_mm };
        let standard_uncertainty = Some(stated).filter(|u| !u.is_nan()).or(default);
        let joints = self.joints[row].clone();
        if joints.iter().any(|q| !q.is_finite()) {
            return Err(Message::error("a joint value is missing or not a number").into());
        }
        settings.conditions.push(Condition {
            pose: self.poses[row],
            cycle: self.cycles[row],
            joints,
            target: match kind {
                Kind::Joint(_) if self.targets[row].is_empty() => 0,
                _ => self.target(row)?,
            },
            standard_uncertainty: positive(standard_uncertainty, kind.is_angle())?,
            kind,
        });
        Ok(())
    }

    fn target(&self, row: usize) -> Result<usize> {
        let name = &self.targets[row];
        let found = self.robot_targets.iter().position(|target| target == name);
        Ok(found.ok_or_else(|| Message::error(format!("`{name}` is not a target of this robot")))?)
    }

    /// What a row without a pose states of fixed points.
    fn known(&self, row: usize, kind: &str, robot: &mut dyn Robot) -> Result<Known> {
        let name = named("target", &self.targets[row])?;
        self.is_fixed_name(name)?;
        let standard_uncertainty_mm = Some(self.u_mm[row]).filter(|u| !u.is_nan()).or(self.without.length_mm);
        let standard_uncertainty_mm = positive(standard_uncertainty_mm, false)?;
        if kind == "sphere" && self.xyz[row].iter().all(|v| v.is_nan()) {
            let parameter = Fixture::Radius(name).add_to(robot);
            return Ok(Known::Length { parameter, length_mm: self.distance(row)?, standard_uncertainty_mm });
        }
        if matches!(kind, "plane" | "line" | "sphere") {
            let (surface, unknowns) = self.surface(row, kind, robot)?;
            let place_mm = self.xyz[row];
            if place_mm.iter().any(|v| !v.is_finite()) {
                return Err(Message::error(format!("the place of `{name}` is missing or not a number")).into());
            }
            return Ok(Known::On { surface, unknowns, place_mm, standard_uncertainty_mm });
        }
        let point = Fixture::Point(name).add_to(robot);
        match kind {
            "point" if self.xyz[row].iter().all(|v| v.is_finite()) => {
                if let Some(name) = &self.stations[row] {
                    let (station, at_mm) = (self.station(name, robot)?, self.xyz[row]);
                    return Ok(Known::Seen { station, point, at_mm, standard_uncertainty_mm });
                }
                Ok(Known::Place { point, place_mm: self.xyz[row], standard_uncertainty_mm })
            }
            "point" => Err(Message::error(format!("the place of `{name}` is missing or not a number")).into()),
            "distance" => {
                let to = self.fixture(row, "other", &self.others, robot)?;
                if to == point {
                    return Err(Message::error(format!("a distance from `{name}` to itself")).into());
                }
                Ok(Known::Distance { from: point, to, distance_mm: self.distance(row)?, standard_uncertainty_mm })
            }
            kind => Err(Message::error(format!("a row of kind `{kind}` has no pose"))
                .hint("rows without a pose state places (`point`) and distances (`distance`) of fixed points, and places on a `plane`, `line` or `sphere`")
                .into()),
        }
    }

    /// An error where a row of another station is not a point with all coordinates and one uncertainty.
    fn seen_whole(&self, row: usize, kind: &str, station: &str) -> Result<()> {
        let us = [0, 1, 2].map(|i| self.u_axes_mm[i][row]);
        let what = match self.xyz[row].iter().all(|v| v.is_finite()) {
            _ if kind != "point" => format!("a row of kind `{kind}` states the station `{station}`"),
            false => format!("a coordinate of what station `{station}` measured is missing or not a number"),
            true if self.covariant[row] => format!("what station `{station}` measured states a covariance"),
            true if us[1..].iter().any(|u| u.to_bits() != us[0].to_bits()) => {
                format!("the coordinates that station `{station}` measured have uncertainties of their own")
            }
            true => return Ok(()),
        };
        let expected =
            "rows of kind `point` with x_mm, y_mm, z_mm and one uncertainty `u_mm`, for stations other than the first";
        Err(Message::error(what).expected(expected).into())
    }

    /// The first parameter of a station.
    fn station(&self, name: &str, robot: &mut dyn Robot) -> Result<usize> {
        self.is_fixed_name(name)?;
        Ok(Fixture::Station(name).add_to(robot))
    }

    /// The plane, line or sphere of a row, and its parameters.
    fn surface(&self, row: usize, kind: &str, robot: &mut dyn Robot) -> Result<(Surface, [usize; 4])> {
        let [planes, lines, spheres] = &self.surfaces;
        if kind == "sphere" {
            let name = named("sphere", &spheres[row])?;
            self.is_fixed_name(name)?;
            let (first, radius) = (Fixture::Point(name).add_to(robot), Fixture::Radius(name).add_to(robot));
            return Ok((Surface::Sphere, [first, first + 1, first + 2, radius]));
        }
        let name = match kind {
            "plane" => named(kind, &planes[row])?,
            _ => named(LINE, &lines[row])?,
        };
        let axis = AXES.iter().position(|axis| *axis == self.axes[row]).ok_or_else(|| match kind {
            "plane" => {
                Message::error(format!("the plane `{name}` needs the axis of the world that is nearest to its normal"))
                    .expected("x, y or z in the column `axis`: z for a table, x or y for a wall")
            }
            _ => Message::error(format!("the line `{name}` needs the axis of the world that is nearest to it"))
                .expected("x, y or z in the column `axis`"),
        })?;
        Ok(match kind {
            "plane" => {
                let first = Fixture::Plane(name, axis).add_to(robot);
                (Surface::Plane { axis }, [first, first + 1, first + 2, first + 2])
            }
            _ => {
                let first = Fixture::Line(name, axis).add_to(robot);
                (Surface::Line { axis }, [first, first + 1, first + 2, first + 3])
            }
        })
    }

    /// The value of a joint as it is.
    fn joint(&self, row: usize, robot: &dyn Robot) -> Result<Kind> {
        let name = named("joint", &self.joint_names[row])?;
        let names = || self.robot_joints.iter().map(|j| j.name.as_str());
        let Some(joint) = names().position(|other| other == name) else {
            let what = format!("`{name}` is not a joint of this robot");
            return Err(Message::error(what).hint_names(name, names()).into());
        };
        let modelled = robot.free_base().and_then(|arm| {
            arm.joint_value(&robot.nominal(), &vec![0.0; self.robot_joints.len()], joint, &mut |_, _| ())
        });
        if modelled.is_none() {
            let what = format!("values of joints are for arms in space, not for `{}`", robot.model());
            return Err(Message::error(what).into());
        }
        let is_angle = self.robot_joints[joint].quantity == Quantity::Angle;
        let value = self.values[usize::from(!is_angle)][row];
        if !value.is_finite() {
            let column = if is_angle { "value_deg" } else { "value_mm" };
            return Err(Message::error(format!("`{column}` is missing or not a number"))
                .expected("the value of the joint by the switch or second encoder")
                .into());
        }
        Ok(Kind::Joint(JointValue { joint, value, is_angle }))
    }

    fn distance(&self, row: usize) -> Result<f64> {
        let d = self.distances_mm[row];
        match d.is_finite() && d > 0.0 {
            true => Ok(d),
            false => {
                Err(Message::error("`distance_mm` is missing or not a length").expected("a length above 0").into())
            }
        }
    }

    /// The first parameter of the fixed point that a column names.
    fn fixture(&self, row: usize, column: &str, names: &[String], robot: &mut dyn Robot) -> Result<usize> {
        let name = named(column, &names[row])?;
        self.is_fixed_name(name)?;
        Ok(Fixture::Point(name).add_to(robot))
    }

    fn is_fixed_name(&self, name: &str) -> Result<()> {
        match self.robot_targets.iter().any(|target| target == name) || name == "base" {
            true => Err(Message::error(format!("`{name}` is a target on the robot, not a fixed point"))
                .hint("give fixed points names of their own; rows about them alone have no pose")
                .into()),
            false => Ok(()),
        }
    }
}

/// The stations of rows that are not in the frame of the world: that of coordinates without a station, or else of the first with one.
fn other_stations(stations: Vec<String>, x_mm: &[f64]) -> Vec<Option<String>> {
    let of_points = || stations.iter().zip(x_mm).filter(|(_, x)| !x.is_nan()).map(|(name, _)| name);
    let world = of_points().find(|name| name.is_empty()).or_else(|| of_points().next()).cloned().unwrap_or_default();
    stations.into_iter().map(|name| Some(name).filter(|name| !name.is_empty() && *name != world)).collect()
}

/// The name of the pose of each row; 0 where there is none.
fn row_poses(observations: &DataFrame) -> Result<Vec<PoseName>> {
    let name = |name: String| match name.as_str() {
        "" => Ok(PoseName::from(0)),
        name => PoseName::new(name).map_err(Problems::from),
    };
    table::texts(observations, "pose")?.into_iter().map(name).collect()
}

fn header() -> Place {
    Place { line: Some(1), ..Place::default() }
}

fn named<'a>(column: &str, name: &'a str) -> Result<&'a str> {
    match name.is_empty() {
        true => Err(Message::error(format!("the column `{column}` is empty or missing")).into()),
        false => Ok(name),
    }
}

fn positive(standard_uncertainty: Option<f64>, is_angle: bool) -> Result<f64> {
    let (column, option) = match is_angle {
        true => ("urot_deg", "--rotation-uncertainty-deg"),
        false => ("u_mm", "--standard-uncertainty-um"),
    };
    match standard_uncertainty {
        Some(u) if u > 0.0 && u.is_finite() => Ok(u),
        Some(u) => Err(Message::error(format!("`{column}` = {u} is not a standard uncertainty")).into()),
        None => Err(Message::error("the row has no standard uncertainty")
            .hint(format!("state {option}, or a column `{column}`"))
            .into()),
    }
}

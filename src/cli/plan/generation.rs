//! Options of generated candidates: ranges of joints, box, reflectors, instrument.

use etalon_base::bounds::option_at_most;
use etalon_base::catalogue::{Argument, IntoArgument};
use etalon_base::message::{Problems, Result};
use etalon_base::pose::{Vector, norm};
use etalon_base::{error, phrase, warning};
use etalon_campaign::RobotFile;
use etalon_documents::{GeneratedCandidates, PlannedObstacle, PlannedReflector};
use etalon_identify::plan::candidates::Candidates;
use etalon_identify::plan::generate::{Domain, Generated, Reflector, Sight, generate};
use etalon_identify::plan::obstacles::Obstacle;
use etalon_robots::{JointRange, Robot};
use std::result::Result as Parsed;

mod obstacles;

use obstacles::{StatedLink, StatedObstacle};

const AXES: [&str; 3] = ["x", "y", "z"];

/// Options of generated candidates.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Generated candidates")]
pub(super) struct Generation {
    /// Draw this number of candidates within the limits of the joints, instead of reading a table.
    #[arg(long, value_name = "N", value_parser = option_at_most::<100_000>, conflicts_with = "target")]
    generate: Option<usize>,
    /// Range of a joint by its column, such as q2_deg=-60:45: replaces wider or missing limits of
    /// the robot file; may be repeated.
    #[arg(long = "range", value_name = "COLUMN=FROM:TO", value_parser = named_range, requires = "generate")]
    ranges: Vec<(String, [f64; 2])>,
    /// Box (mm) in the base of the robot that contains all targets, such as
    /// x=200:600,y=-300:300,z=0:500; an axis without a range is unlimited.
    #[arg(long = "box", value_name = "x=FROM:TO,...", value_parser = named_range, value_delimiter = ',', requires = "generate")]
    box_mm: Vec<(String, [f64; 2])>,
    /// Reflector of an arm, delta or hexapod; may be repeated.
    ///
    /// NAME for the position in the robot file, NAME=X,Y,Z (mm in the flange), or
    /// NAME=X,Y,Z,I,J,K,ANGLE with its outward axis in the flange and its acceptance half-angle
    /// (deg).
    #[arg(long = "reflector", value_name = "NAME=X,Y,Z[,I,J,K,ANGLE]", value_parser = reflector, requires = "generate")]
    reflectors: Vec<StatedReflector>,
    /// Position X,Y,Z (mm) of the instrument in the base of the robot: reflectors with an axis face
    /// it in every candidate.
    #[arg(long, value_name = "X,Y,Z", value_parser = position, allow_hyphen_values = true, requires = "generate")]
    instrument: Option<Position>,
    /// Body in the base of the robot (mm) that blocks the view of the instrument; may be repeated.
    ///
    /// NAME=cylinder:RADIUS,X,Y,Z,X,Y,Z by the centres of both ends, or
    /// NAME=box:DX,DY,DZ,X,Y,Z[,DEG] by its edges, its centre and its rotation about z.
    #[arg(long = "obstacle", value_name = "NAME=SHAPE:NUMBERS", value_parser = obstacles::obstacle, requires = "instrument")]
    obstacles: Vec<StatedObstacle>,
    /// Link that a joint moves, as a capsule that blocks the view; may be repeated.
    ///
    /// JOINT=RADIUS (mm): from the origin of the joint's frame to the origin of the next joint, or
    /// of the flange. JOINT=RADIUS,X,Y,Z,X,Y,Z: by both ends in the base of the robot at joint
    /// values zero.
    #[arg(long = "link", value_name = "JOINT=RADIUS[,X,Y,Z,X,Y,Z]", value_parser = obstacles::link, requires = "instrument")]
    links: Vec<StatedLink>,
}

/// A reflector of the option.
#[derive(Clone, Debug)]
struct StatedReflector {
    name: String,
    at_mm: Option<Vector>,
    /// Axis and acceptance half-angle (deg).
    front: Option<(Vector, f64)>,
}

/// A position (mm).
#[derive(Clone, Copy, Debug)]
struct Position(Vector);

/// Robot with its targets, candidates, and how they were drawn.
pub(super) type Drawn = (Box<dyn Robot>, Candidates, Option<GeneratedCandidates>);

impl Generation {
    /// Draws candidates, if this is asked for.
    ///
    /// # Errors
    /// Reports joints without limits, options that do not fit the robot, and constraints that no
    /// draw obeys.
    pub(super) fn candidates(&self, file: &RobotFile, seed: u64) -> Result<Option<Drawn>> {
        let Some(wanted) = self.generate else { return Ok(None) };
        let robot = self.robot(file)?;
        let robot_ref = robot.as_ref();
        let domain = Domain {
            ranges: self.ranges(robot_ref)?,
            region_mm: self.region(robot_ref)?,
            sight: self.sight(robot_ref)?,
        };
        let found = generate(robot_ref, &domain, wanted, seed);
        if found.poses == 0 {
            return Err(error!("no-candidate-generated", draws = found.draws, counts = counts(&found, &domain)).into());
        }
        let few = || {
            let (found, draws, counts) = (found.poses, found.draws, counts(&found, &domain));
            warning!("few-candidates-generated", found, wanted, draws, counts)
        };
        let limit_violations = (found.poses < wanted).then(few);
        let generated = self.document(robot_ref, &domain, wanted, &found);
        Ok(Some((robot, Candidates { observations: found.observations, limit_violations }, Some(generated))))
    }

    /// The robot with the reflectors of the options.
    fn robot(&self, file: &RobotFile) -> Result<Box<dyn Robot>> {
        let mut names: Vec<String> = Vec::new();
        for reflector in &self.reflectors {
            if names.contains(&reflector.name) {
                return Err(error!("reflector-twice", name = &reflector.name).into());
            }
            names.push(reflector.name.clone());
        }
        let stated = !names.is_empty();
        if !stated {
            names.push("A".to_owned());
        }
        let mut robot = file.build(&names)?;
        match (robot.free_base().is_some(), stated) {
            (true, false) => return Err(error!("reflector-missing").into()),
            (false, true) => return Err(error!("reflector-of-own-targets", model = robot.model()).into()),
            _ => {}
        }
        let mut nominal = robot.nominal();
        if let Some(arm) = robot.free_base() {
            for (target, reflector) in self.reflectors.iter().enumerate() {
                let first = arm.target_place(target);
                reflector.at_mm.iter().for_each(|at| nominal[first..first + 3].copy_from_slice(at));
            }
        }
        robot.definition_mut().set_nominal(&nominal);
        Ok(robot)
    }

    /// Range of each joint in logged values (mm or rad).
    fn ranges(&self, robot: &dyn Robot) -> Result<Vec<[f64; 2]>> {
        let mut problems = Problems::default();
        let columns: Vec<String> = robot.joints().iter().map(|joint| joint.column()).collect();
        for (column, _) in &self.ranges {
            if robot.joints().iter().all(|joint| joint.factor(column).is_none()) {
                let message = error!("range-joint-unknown", column);
                problems.0.push(message.hint_names(column, columns.iter().map(String::as_str)));
            }
        }
        let mut ranges = Vec::new();
        for (k, joint) in robot.joints().iter().enumerate() {
            let gain = Some(robot.nominal_gain(k)).filter(|gain| gain.is_normal()).unwrap_or(1.0);
            let limits = match robot.joint_range(k) {
                JointRange::Limits(ends) => Some(sorted(ends.map(|end| end / gain))),
                JointRange::Endless | JointRange::Unstated => None,
            };
            let stated = self.ranges.iter().filter_map(|(column, ends)| {
                let factor = joint.factor(column)?;
                Some(ends.map(|end| end * factor))
            });
            let narrowed = limits.into_iter().chain(stated).reduce(|a, b| [a[0].max(b[0]), a[1].min(b[1])]);
            match narrowed {
                Some([lower, upper]) if lower >= upper => {
                    let [from, to] = limits.unwrap_or_default().map(|end| joint.quantity.outward(end));
                    problems.0.push(error!(
                        "range-outside-limits",
                        joint = &joint.name,
                        from,
                        to,
                        unit = joint.quantity.unit()
                    ));
                }
                Some(range) => ranges.push(range),
                None if robot.has_assembly_modes() => ranges.push([f64::NEG_INFINITY, f64::INFINITY]),
                None => problems.0.push(error!("joint-range-missing", joint = &joint.name, column = &columns[k])),
            }
        }
        problems.check().map(|_| ranges)
    }

    /// The box, with infinite ends of axes without a range.
    fn region(&self, robot: &dyn Robot) -> Result<Option<[[f64; 2]; 3]>> {
        let mut region = [[f64::NEG_INFINITY, f64::INFINITY]; 3];
        for (name, ends) in &self.box_mm {
            let axis = AXES.iter().position(|axis| axis == name || name.strip_suffix("_mm") == Some(axis));
            let Some(axis) = axis.filter(|axis| *axis < robot.dimension()) else {
                return Err(error!("box-axis-unknown", name, dimension = robot.dimension()).into());
            };
            region[axis] = [region[axis][0].max(ends[0]), region[axis][1].min(ends[1])];
        }
        if robot.has_assembly_modes() && region[..2].iter().flatten().any(|end| end.is_infinite()) {
            return Err(error!("box-missing", model = robot.model()).into());
        }
        Ok((!self.box_mm.is_empty()).then_some(region))
    }

    fn sight(&self, robot: &dyn Robot) -> Result<Option<Sight>> {
        let front = |(target, stated): (usize, &StatedReflector)| {
            let (axis, deg) = stated.front?;
            Some(Reflector { target, axis, acceptance_rad: deg.to_radians() })
        };
        let reflectors: Vec<Reflector> = self.reflectors.iter().enumerate().filter_map(front).collect();
        let is_hidden_by = !(self.obstacles.is_empty() && self.links.is_empty());
        match (self.instrument, reflectors.is_empty() && !(is_hidden_by && robot.free_base().is_some())) {
            (Some(Position(instrument_mm)), false) => {
                let obstacles = self.obstacles(robot, instrument_mm)?;
                Ok(Some(Sight { instrument_mm, reflectors, obstacles }))
            }
            (None, true) => Ok(None),
            (Some(_), true) if robot.free_base().is_none() => {
                Err(error!("reflector-of-own-targets", model = robot.model()).into())
            }
            (Some(_), true) => Err(error!("sight-incomplete", missing = "axis").into()),
            (None, false) => Err(error!("sight-incomplete", missing = "instrument").into()),
        }
    }

    fn document(&self, robot: &dyn Robot, domain: &Domain, wanted: usize, found: &Generated) -> GeneratedCandidates {
        let nominal = robot.nominal();
        let is_finite = |ends: &[f64; 2]| ends.iter().all(|end| end.is_finite());
        let ranges = robot.joints().iter().zip(&domain.ranges).filter(|(_, ends)| is_finite(ends));
        let reflector = |(target, stated): (usize, &StatedReflector)| PlannedReflector {
            name: stated.name.clone(),
            at_mm: robot
                .free_base()
                .map_or([0.0; 3], |arm| std::array::from_fn(|i| nominal[arm.target_place(target) + i])),
            axis: stated.front.map(|(axis, _)| axis),
            acceptance_deg: stated.front.map(|(_, angle)| angle),
        };
        let region = AXES.iter().zip(domain.region_mm.iter().flatten()).filter(|(_, ends)| is_finite(ends));
        GeneratedCandidates {
            wanted,
            draws: found.draws,
            beyond_limits: found.losses.limits,
            outside_box: found.losses.region,
            facing_away: found.losses.sight,
            obstacles: self.planned_obstacles(found),
            ranges: ranges.map(|(joint, ends)| (joint.column(), ends.map(|end| joint.quantity.outward(end)))).collect(),
            box_mm: region.map(|(axis, ends)| ((*axis).to_owned(), *ends)).collect(),
            instrument_mm: self.instrument.map(|Position(at)| at),
            reflectors: self.reflectors.iter().enumerate().map(reflector).collect(),
        }
    }
}

/// Numbers of draws lost, by reason.
fn counts(found: &Generated, domain: &Domain) -> Vec<Argument> {
    let losses = &found.losses;
    let limits = (losses.limits > 0).then(|| phrase!("draws-beyond-limits", count = losses.limits).argument());
    let region = (losses.region > 0).then(|| {
        let [[x0, x1], [y0, y1], [z0, z1]] = found.reached_mm;
        phrase!("draws-outside-box", count = losses.region, x0, x1, y0, y1, z0, z1).argument()
    });
    let (count, reversed) = (losses.sight, losses.reversed);
    let sight = (count > 0).then(|| phrase!("draws-facing-away", count, reversed).argument());
    let names = domain.sight.iter().flat_map(|sight| &sight.obstacles);
    let hidden = names.zip(&losses.hidden).filter(|(_, count)| **count > 0);
    let hidden = hidden.map(|(o, count)| phrase!("draws-hidden", count = *count, obstacle = &o.name).argument());
    [limits, region, sight].into_iter().flatten().chain(hidden).collect()
}

/// Parses NAME=FROM:TO.
fn named_range(text: &str) -> Parsed<(String, [f64; 2]), String> {
    let expected = || "expected NAME=FROM:TO with FROM below TO".to_owned();
    let (name, ends) = text.split_once('=').ok_or_else(expected)?;
    let (from, to) = ends.split_once(':').ok_or_else(expected)?;
    let [Some(from), Some(to)] = [from, to].map(number) else { return Err(expected()) };
    if from < to { Ok((name.trim().to_owned(), [from, to])) } else { Err(expected()) }
}

/// Parses NAME, NAME=X,Y,Z or NAME=X,Y,Z,I,J,K,ANGLE.
fn reflector(text: &str) -> Parsed<StatedReflector, String> {
    let (name, numbers) = text.split_once('=').map_or((text, None), |(name, numbers)| (name, Some(numbers)));
    let name = name.trim().to_owned();
    let numbers: Option<Vec<f64>> = numbers.map_or(Some(Vec::new()), |all| all.split(',').map(number).collect());
    let (at_mm, front) = match numbers.as_deref() {
        Some([]) => (None, None),
        Some(&[x, y, z]) => (Some([x, y, z]), None),
        Some(&[x, y, z, i, j, k, angle]) if norm([i, j, k]) > 0.0 && angle > 0.0 && angle <= 180.0 => {
            (Some([x, y, z]), Some(([i, j, k], angle)))
        }
        _ => return Err("expected NAME=X,Y,Z or NAME=X,Y,Z,I,J,K,ANGLE with an axis and an angle up to 180".to_owned()),
    };
    if name.is_empty() { Err("expected a name".to_owned()) } else { Ok(StatedReflector { name, at_mm, front }) }
}

/// Parses X,Y,Z.
fn position(text: &str) -> Parsed<Position, String> {
    let numbers: Option<Vec<f64>> = text.split(',').map(number).collect();
    match numbers.as_deref() {
        Some(&[x, y, z]) => Ok(Position([x, y, z])),
        _ => Err("expected X,Y,Z".to_owned()),
    }
}

/// A finite number.
fn number(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|value: &f64| value.is_finite())
}

fn sorted(mut ends: [f64; 2]) -> [f64; 2] {
    ends.sort_by(f64::total_cmp);
    ends
}

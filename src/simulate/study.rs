//! Studies: agreement of identified parameters and tool poses with a known truth, for different
//! measurements (thesis, 3.7 and 4.6).

use super::truth::{Circle, stated_joints, true_values};
use crate::stages::candidates::configurations;
use crate::stages::remedies::remedied;
use crate::stages::table_file::TableFile;
use etalon_base::angle::Turn;
use etalon_base::bounds::{MOST, at_most, product_at_most};
use etalon_base::catalogue::Phrase;
use etalon_base::files;
use etalon_base::message::{Place, Problems, Result};
use etalon_base::noise::Noise;
use etalon_base::pose::{Pose, Vector, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase};
use etalon_campaign::{parse, schema};
use etalon_documents::{DesignError, DesignParameter, ResidualKind, Spread, StudiedDesign};
use etalon_identify::{Observation, Settings, identify_from};
use etalon_math::statistics::rms;
use etalon_robots::{Kinematics, Parameter, PlanarPose, Quantity, Robot};
use rayon::prelude::*;
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::path::Path;

/// Maximum number of poses of a set, or of the workspace.
const MOST_POSES: u64 = 100_000;
/// Maximum number of errors evaluated at once.
const MOST_ERRORS: u64 = 5_000_000;

/// Simulated calibrations of one robot.
pub struct Study<'a> {
    /// Robot with its nominal parameters.
    pub robot: &'a dyn Robot,
    /// True parameters (mm, rad or 1).
    pub truth: &'a [f64],
    /// Settings of the identification.
    pub settings: Settings,
    /// Number of calibrations whose mean is evaluated.
    pub runs: u64,
    /// Seed of the noise.
    pub seed: u64,
}

/// Several calibrations with independent noise.
#[derive(Clone, Debug)]
pub struct Draw {
    /// Mean of the identified parameters (mm, rad or 1).
    pub mean: Vec<f64>,
    /// Standard deviation of the identified parameters; zero for a single calibration.
    pub standard_deviation: Vec<f64>,
}

impl Study<'_> {
    /// Simulates calibrations from the targets in `observations`, with Gaussian noise of this
    /// standard deviation on each coordinate.
    ///
    /// # Errors
    ///
    /// Fails if the identification fails, or if the poses do not determine all parameters.
    pub fn draw(&self, observations: &[Observation], noise_mm: f64, draw: u64) -> Result<Draw> {
        let n = self.truth.len();
        let (mut mean, mut squares) = (vec![0.0; n], vec![0.0; n]);
        for run in 0..self.runs {
            let mut noise = Noise::new(self.seed, draw * self.runs + run);
            let measured: Vec<Observation> =
                observations.iter().map(|o| self.measured(o, noise_mm, &mut noise)).collect();
            let found =
                identify_from(self.robot, &measured, &self.settings, &self.robot.nominal()).map_err(remedied)?;
            if found.identifiability.groups.iter().any(|g| g.useless_uncertainty.is_some()) {
                return Err(error!("study-too-few-poses").into());
            }
            for ((mean, square), value) in mean.iter_mut().zip(&mut squares).zip(&found.values) {
                let before = value - *mean;
                *mean += before / (run + 1) as f64;
                *square += before * (value - *mean);
            }
        }
        let standard_deviation = squares.iter().map(|s| (s / self.runs.saturating_sub(1).max(1) as f64).sqrt());
        Ok(Draw { standard_deviation: standard_deviation.collect(), mean })
    }

    /// Simulates several draws on all threads.
    ///
    /// # Errors
    ///
    /// Fails like [`Self::draw`].
    pub fn draws(&self, observations: &[Observation], noise_mm: f64, draws: u64) -> Result<Vec<Draw>> {
        (0..draws).into_par_iter().map(|draw| self.draw(observations, noise_mm, draw)).collect()
    }

    fn measured(&self, o: &Observation, noise_mm: f64, noise: &mut Noise) -> Observation {
        let mut seen = |(target, at): (usize, &Option<Vector>)| {
            at.as_ref()?;
            let mut p = self.robot.position(self.truth, &o.joints, target);
            p[..self.robot.dimension()].iter_mut().for_each(|v| *v += noise.gaussian(noise_mm));
            Some(p)
        };
        Observation { targets: o.targets.iter().enumerate().map(&mut seen).collect(), ..o.clone() }
    }
}

/// Frame in which poses are commanded and errors are evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Frame {
    /// Base of the robot: the base in the world and the targets cancel.
    Base,
    /// World: an error of the base in the world is an error of the tool.
    World,
}

impl Frame {
    /// Definition of the error, in words.
    pub fn error(self) -> Phrase {
        match self {
            Self::Base => phrase!("study-error-in-base"),
            Self::World => phrase!("study-error-in-world"),
        }
    }
}

/// A commanded pose of the tool, and the deviation of the robot from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Landing {
    /// Commanded pose.
    pub commanded: Pose,
    /// True minus commanded position (mm).
    pub error_mm: Vector,
    /// Rotation from the commanded to the true orientation (rad).
    pub rotation_rad: Vector,
}

impl Landing {
    /// Attained pose of a robot with the parameters `truth` if its controller, which computes with
    /// `identified`, is commanded the pose of the nominal robot at `joints`; the working mode is
    /// kept. `None` if one of the robots cannot attain the pose.
    pub fn new(
        robot: &dyn Kinematics,
        truth: &[f64],
        identified: &[f64],
        frame: Frame,
        joints: &[f64],
    ) -> Option<Self> {
        let base = |p: &[f64]| match frame {
            Frame::Base => Some(Pose::identity()),
            Frame::World => robot.base_in_world(p),
        };
        let nominal = robot.nominal();
        let commanded = base(&nominal)?.then(&robot.tool_pose(&nominal, joints)?);
        let ways = robot.all_joints(identified, &base(identified)?.inverse().then(&commanded));
        let turned = |(a, b): (&f64, &f64)| Turn::RADIANS.difference(*a, *b);
        let off = |q: &Vec<f64>| {
            let joints = q.iter().zip(joints).zip(robot.joints());
            joints
                .map(
                    |(pair, joint)| {
                        if joint.quantity == Quantity::Angle { turned(pair).abs() } else { (pair.0 - pair.1).abs() }
                    },
                )
                .sum::<f64>()
        };
        let driven = ways.into_iter().min_by(|a, b| off(a).total_cmp(&off(b)))?;
        let attained = base(truth)?.then(&robot.tool_pose(truth, &driven)?);
        let rotation_rad = commanded.rotate(commanded.inverse().then(&attained).rotation_vector_rad());
        Some(Self { commanded, error_mm: minus(attained.translation_mm, commanded.translation_mm), rotation_rad })
    }
}

/// `study.toml`: comparison of sets of poses for measurement.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StudyFile {
    /// Robot file, relative to this file.
    pub robot: String,
    /// Seed of the noise.
    pub seed: u64,
    /// Number of calibrations whose mean and three standard deviations are evaluated.
    #[serde(default = "five", deserialize_with = "at_most::<_, _, MOST>")]
    pub runs: u64,
    /// Number of draws for intervals.
    #[serde(default = "hundred", deserialize_with = "at_most::<_, _, MOST>")]
    pub draws: u64,
    /// Noise of one coordinate (one standard deviation); several values compare instruments.
    pub noise_um: Vec<f64>,
    /// Basis of the identification: targets, or the pose (thesis, eq. 3.26).
    #[serde(default)]
    pub residuals: ResidualKind,
    /// Names of the targets, for a robot without targets of its own.
    #[serde(default)]
    pub targets: Vec<String>,
    /// Parameters held at their nominal values; `*` stands for any text.
    #[serde(default)]
    pub hold: Vec<String>,
    /// Frame in which poses are commanded and errors are evaluated.
    pub frame: Frame,
    /// True parameters by name (mm, deg or 1); other parameters are nominal.
    pub parameters: BTreeMap<String, f64>,
    /// Poses at which errors are evaluated.
    pub workspace: Vec<Places>,
    /// Sets of poses.
    #[serde(rename = "set")]
    pub sets: Vec<Set>,
}

fn five() -> u64 {
    5
}

fn hundred() -> u64 {
    100
}

/// A named set of poses.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Set {
    /// Name of the set.
    pub name: String,
    /// Poses of the set.
    pub poses: Vec<Places>,
}

/// Poses from a table, by joint values, or on circles, discs and grids. Positions of the platform
/// in the base frame, or of the only target in the world, in all working modes within the limits.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Places {
    /// Table of poses relative to this file, in the form of the candidates of `etalon plan`.
    pub file: Option<String>,
    /// Joint values (mm or deg), followed by the assembly mode.
    pub joints: Vec<Vec<f64>>,
    /// Positions.
    pub positions_mm: Vec<[f64; 2]>,
    /// Circles with evenly spread positions.
    pub circles: Vec<Circle>,
    /// Discs with evenly spread positions (Vogel 1979).
    pub discs: Vec<Circle>,
    /// Grids of positions.
    pub grids: Vec<Grid>,
    /// Orientations of a platform at each position; 0 by default.
    pub theta_deg: Vec<f64>,
}

/// A rectangular grid of positions.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Grid {
    /// One corner.
    pub from_mm: [f64; 2],
    /// Opposite corner.
    pub to_mm: [f64; 2],
    /// Number of positions along x and y, including both ends.
    pub count: [usize; 2],
}

impl Grid {
    fn positions(self) -> impl Iterator<Item = [f64; 2]> {
        let at = move |k: usize, i: usize| {
            self.from_mm[k]
                + (self.to_mm[k] - self.from_mm[k]) * i as f64 / self.count[k].saturating_sub(1).max(1) as f64
        };
        (0..self.count[0]).flat_map(move |i| (0..self.count[1]).map(move |j| [at(0, i), at(1, j)]))
    }
}

impl Circle {
    fn in_disc(self) -> impl Iterator<Item = [f64; 2]> {
        let golden = PI * (3.0 - 5f64.sqrt());
        (0..self.count).map(move |i| {
            let radius = 0.5 * self.diameter_mm * ((i as f64 + 0.5) / self.count as f64).sqrt();
            let (sin, cos) = (golden * i as f64).sin_cos();
            [self.center_mm[0] + radius * cos, self.center_mm[1] + radius * sin]
        })
    }
}

/// Poses of `robot` as observations of all targets, without measurements; tables are read from
/// `folder`.
///
/// # Errors
///
/// Reports unreadable tables, positions that do not apply to the robot, and missing poses.
pub fn observations(places: &[Places], robot: &dyn Robot, folder: &Path) -> Result<Vec<Observation>> {
    let mut all: Vec<(PoseName, Vec<f64>)> = Vec::new();
    for one in places {
        one.add(robot, folder, &mut all)?;
    }
    if all.is_empty() {
        return Err(error!("study-set-empty").into());
    }
    let targets = vec![Some([0.0; 3]); robot.targets().len()];
    let observe = |(k, (pose, joints)): (usize, (PoseName, Vec<f64>))| Observation {
        pose,
        cycle: k as i64 + 1,
        joints,
        targets: targets.clone(),
        ..Observation::default()
    };
    Ok(all.into_iter().enumerate().map(observe).collect())
}

impl Places {
    /// Number of given poses, without poses from tables; working modes do not count.
    fn count(&self) -> u64 {
        let thetas = self.theta_deg.len().max(1) as u64;
        let circles = self.circles.iter().chain(&self.discs).map(|circle| circle.count as u64);
        let grids = self.grids.iter().map(|grid| (grid.count[0] as u64).saturating_mul(grid.count[1] as u64));
        let positions = circles.chain(grids).fold(self.positions_mm.len() as u64, u64::saturating_add);
        positions.saturating_mul(thetas).saturating_add(self.joints.len() as u64)
    }

    fn add(&self, robot: &dyn Robot, folder: &Path, all: &mut Vec<(PoseName, Vec<f64>)>) -> Result<()> {
        let nominal = robot.nominal();
        if let Some(file) = &self.file {
            let table = TableFile::read(&folder.join(file))?;
            let found = configurations(robot, &table.table).map_err(|problems| table.place(problems))?;
            all.extend(found.observations.into_iter().map(|o| (o.pose, o.joints)));
        }
        let mut next = all.len() as i64;
        let mut name = || {
            next += 1;
            PoseName::from(next)
        };
        for q in &self.joints {
            all.push((name(), stated_joints(robot, q)?));
        }
        let circles = self.circles.iter().flat_map(|c| c.positions());
        let placed = self.positions_mm.iter().copied().chain(circles);
        let placed = placed
            .chain(self.discs.iter().flat_map(|d| d.in_disc()))
            .chain(self.grids.iter().flat_map(|g| g.positions()));
        let thetas = if self.theta_deg.is_empty() { &[0.0][..] } else { &self.theta_deg };
        for [x_mm, y_mm] in placed {
            if let Some(platform) = robot.platform() {
                for theta in thetas {
                    let pose = PlanarPose { x_mm, y_mm, theta_rad: theta.to_radians() };
                    all.push((name(), platform.joints_at(&nominal, pose)));
                }
                continue;
            }
            let ways = robot.inverse_all(&nominal, [x_mm, y_mm, 0.0]);
            let ways = ways.ok_or_else(|| error!("study-not-by-position", model = robot.model()))?;
            let pose = name();
            all.extend(ways.into_iter().map(|q| (pose, q)));
        }
        Ok(())
    }
}

impl StudyFile {
    /// Reads `study.toml`.
    ///
    /// # Errors
    ///
    /// Reports errors of the file.
    pub fn read(path: &Path) -> Result<Self> {
        let file = path.display().to_string();
        let study: Self = parse(&file, &files::read_text(path)?, &schema("study.toml", super::SCHEMAS))?;
        study.bounded().map_err(|problems| problems.at(&Place::file(file)))?;
        Ok(study)
    }

    /// Checks that sets, draws and the workspace are not too large.
    fn bounded(&self) -> Result<()> {
        let count = |places: &[Places]| places.iter().map(Places::count).fold(0u64, u64::saturating_add);
        for set in &self.sets {
            let (of, poses) = (phrase!("poses-in-set", set = set.name), count(&set.poses));
            product_at_most(of, &[("poses", poses)], MOST_POSES)?;
        }
        let workspace = count(&self.workspace);
        product_at_most(phrase!("positions-in-workspace"), &[("poses", workspace)], MOST_POSES)?;
        product_at_most(phrase!("counted-calibrations"), &[("draws", self.draws), ("runs", self.runs)], MOST)?;
        product_at_most(phrase!("errors-to-evaluate"), &[("draws", self.draws), ("poses", workspace)], MOST_ERRORS)
    }

    /// Names of the tables of all sets.
    pub fn tables(&self) -> impl Iterator<Item = &String> {
        self.sets.iter().flat_map(|set| &set.poses).chain(&self.workspace).filter_map(|places| places.file.as_ref())
    }

    /// Evaluates every set with every noise; `progress` is called with the name of each before it
    /// is computed.
    ///
    /// # Errors
    ///
    /// Reports poses out of reach, parameters that a set does not determine, and robots without a
    /// tool pose.
    pub fn run(&self, robot: &dyn Robot, folder: &Path, mut progress: impl FnMut(&str)) -> Result<Vec<StudiedDesign>> {
        let arm = robot.kinematics().ok_or_else(|| error!("no-whole-pose", model = robot.model()))?;
        let truth = true_values(robot, &self.parameters)?;
        let commands = observations(&self.workspace, robot, folder)?;
        let mut designs = Vec::new();
        for set in &self.sets {
            let poses = observations(&set.poses, robot, folder)?;
            for &noise_um in &self.noise_um {
                progress(&format!("{}, {noise_um} um", set.name));
                let settings = Settings {
                    kind: self.residuals.into(),
                    standard_uncertainty_mm: Some(noise_um / 1e3),
                    hold: self.hold.clone(),
                    ..Settings::default()
                };
                let study = Study { robot, truth: &truth, settings, runs: self.runs.max(1), seed: self.seed };
                let at_set = |problems: Problems| problems.within(&phrase!("in-set", set = set.name));
                let draws = study.draws(&poses, noise_um / 1e3, self.draws.max(1)).map_err(at_set)?;
                let landings = |p: &[f64]| {
                    commands.iter().filter_map(|o| Landing::new(arm, &truth, p, self.frame, &o.joints)).collect()
                };
                let errors: Vec<Vec<Landing>> = draws.par_iter().map(|d| landings(&d.mean)).collect();
                designs.push(StudiedDesign {
                    name: set.name.clone(),
                    noise_um,
                    configurations: poses.len(),
                    parameters: parameters(robot, &truth, &draws),
                    before: error_spreads(&[landings(&robot.nominal())]),
                    after: error_spreads(&errors),
                });
            }
        }
        Ok(designs)
    }
}

/// Mean and three standard deviations of every parameter over the draws.
fn parameters(robot: &dyn Robot, truth: &[f64], draws: &[Draw]) -> Vec<DesignParameter> {
    let one = |(i, p): (usize, &Parameter)| DesignParameter {
        name: p.name.clone(),
        unit: p.quantity.unit().to_owned(),
        nominal: p.quantity.outward(p.nominal),
        actual: p.quantity.outward(truth[i]),
        mean: Spread::new(draws.iter().map(|d| p.quantity.outward(d.mean[i]))),
        three_standard_deviations: Spread::new(draws.iter().map(|d| 3.0 * p.quantity.outward(d.standard_deviation[i]))),
    };
    robot.parameters().iter().enumerate().map(one).collect()
}

/// Largest and root-mean-square error of position, of each coordinate and of orientation, over the
/// draws.
fn error_spreads(draws: &[Vec<Landing>]) -> Vec<DesignError> {
    type Size = fn(&Landing) -> f64;
    let quantities: [(&str, &str, Size); 5] = [
        ("position", "mm", |l| norm(l.error_mm)),
        ("x", "mm", |l| l.error_mm[0]),
        ("y", "mm", |l| l.error_mm[1]),
        ("z", "mm", |l| l.error_mm[2]),
        ("orientation", "deg", |l| norm(l.rotation_rad).to_degrees()),
    ];
    let one = |(quantity, unit, size): (&str, &str, Size)| {
        let largest = |all: &Vec<Landing>| all.iter().map(|l| size(l).abs()).fold(0.0, f64::max);
        let rms = |all: &Vec<Landing>| rms(all.iter().map(size));
        DesignError {
            quantity: quantity.to_owned(),
            unit: unit.to_owned(),
            rms: Spread::new(draws.iter().map(rms)),
            max: Spread::new(draws.iter().map(largest)),
        }
    };
    let all = quantities.map(one);
    all.into_iter().filter(|e| e.max.high > 0.0).collect()
}

//! A campaign as the page shows it: read, joined and identified, without the judgement of a run.

use crate::run::walk::{Observed, observed};
use crate::session::meshes::Meshes;
use crate::session::scene::{UM, scene};
use crate::session::visits::{Base, Visit};
use crate::stages::calibrate::identification::{Unjudged, identify_unjudged};
use crate::stages::calibrate::selection::{CampaignData, Input};
use crate::stages::gather::Gathered;
use crate::stages::kinds;
use etalon_base::catalogue::Phrase;
use etalon_base::error;
use etalon_base::message::{Message, Result};
use etalon_base::pose::norm;
use etalon_base::pose_name::PoseName;
use etalon_campaign::Campaign;
use etalon_documents::{ErrorQuantity, Figure, PointError, warning_messages};
use etalon_identify::{Identification, Observation, RobustFit, Status};
use etalon_robots::{Robot, Role};
use etalon_view::{LargestError, Parameter, Scene, Split};
use std::collections::BTreeSet;

/// A campaign, its observations, and its identification.
pub(super) struct Opened {
    pub campaign: Campaign,
    pub observed: Observed,
    /// The robot with the fixtures of the observations.
    pub robot: Box<dyn Robot>,
    /// The identification.
    pub found: Unjudged,
    /// Visits of poses, in the order of the scene.
    pub visits: Vec<Visit>,
    /// All observations, the excluded ones too, in the same order.
    pub observations: Vec<Observation>,
    pub scene: Scene,
    pub meshes: Meshes,
}

/// The robot of a campaign, with the targets that its observations name.
pub(super) fn robot(campaign: &Campaign, gathered: &Gathered) -> Result<Box<dyn Robot>> {
    let branches = campaign.robot.branches();
    let targets = gathered.observations.as_ref();
    let targets = targets.map(|t| kinds::targets(&t.table, &branches).map_err(|more| t.place(more))).transpose()?;
    campaign.build_robot_with(&targets.unwrap_or_default())
}

impl Opened {
    /// Reads and identifies a campaign; a robust fit finds outliers if they are asked for.
    ///
    /// # Errors
    /// Fails like a run, as far as the identification.
    pub fn new(campaign: &Campaign, with_outliers: bool) -> Result<Self> {
        Self::with(campaign, with_outliers, |observed, robot| identified(campaign, observed, robot))
    }

    /// Reads a campaign, with the identification of its `earlier` poses.
    ///
    /// # Errors
    /// Fails like a run, as far as the observations.
    pub fn by_earlier(campaign: &Campaign, earlier: &Self) -> Result<Self> {
        Self::with(campaign, false, |_, _| Ok(earlier.found.clone()))
    }

    fn with(
        campaign: &Campaign,
        with_outliers: bool,
        identified: impl FnOnce(&Observed, &mut dyn Robot) -> Result<Unjudged>,
    ) -> Result<Self> {
        let observed = observed(campaign)?;
        let mut robot = robot(campaign, &observed.gathered)?;
        let found = identified(&observed, robot.as_mut())?;
        let (visits, observations) = all_observations(campaign, &observed)?;
        let times = observed.joined.observations.first().map_or_else(|| Ok(Vec::new()), |(_, first)| first.times())?;
        let outliers = if with_outliers { outliers(robot.as_ref(), &found, &visits) } else { BTreeSet::new() };
        let base = Base {
            campaign,
            robot: robot.as_ref(),
            found: &found,
            frames: &observed.frames,
            visits: &visits,
            observations: &observations,
            times: &times,
        };
        let meshes = Meshes::new(campaign, robot.as_ref(), &found.solution.found.values);
        let scene = scene(&base, &outliers, meshes.parts());
        Ok(Self { campaign: campaign.clone(), observed, robot, found, visits, observations, scene, meshes })
    }

    /// Identifies these observations with the settings of another campaign.
    ///
    /// # Errors
    /// Fails like [`Opened::new`].
    pub fn again(&self, campaign: &Campaign) -> Result<(Box<dyn Robot>, Unjudged)> {
        let mut robot = robot(campaign, &self.observed.gathered)?;
        let found = identified(campaign, &self.observed, robot.as_mut())?;
        Ok((robot, found))
    }

    /// Messages of reading, joining, selecting and solving.
    pub fn messages(&self) -> Vec<Message> {
        let read = self.observed.gathered.document.messages.iter().cloned();
        let solver = warning_messages(&self.found.solution.found.warnings);
        solver.into_iter().chain(self.found.messages.iter().cloned()).chain(read).collect()
    }

    /// Parameters of the identification.
    pub fn parameters(&self, language: &str) -> Vec<Parameter> {
        parameters(self.robot.as_ref(), &self.found.solution.found, language)
    }

    /// Largest position error at the deciding poses.
    pub fn maximum(&self) -> Option<LargestError> {
        let set = self.found.accuracy.sets.last()?;
        let statistics = set.error_statistics(ErrorQuantity::Position)?;
        let of_set = |e: &&PointError| e.set == set.name && e.quantity == ErrorQuantity::Position;
        let errors = self.found.errors.iter().filter(of_set);
        let largest = errors.max_by(|a, b| norm(a.after_mm).total_cmp(&norm(b.after_mm)))?;
        let (value_um, uncertainty_um) = Self::largest_um(&self.found);
        let visit = Visit { pose: largest.pose, cycle: largest.cycle };
        let limit = self.campaign.file.limits.position_max_mm;
        Some(LargestError {
            set: set.name.to_string(),
            pose: visit.id(Visit::have_cycles(&self.visits)),
            target: Some(largest.target.clone()),
            value_um,
            uncertainty_um,
            limit_um: limit.map(|mm| mm * UM),
            before_um: Some(statistics.before.max * UM),
        })
    }

    /// Selections of poses.
    pub fn split(&self) -> Option<Split> {
        let identify = self.campaign.file.identify.as_ref()?;
        let validation = identify.validation.as_ref().map(|poses| poses.get_ref().to_string());
        Some(Split {
            calibration: identify.calibration.get_ref().to_string(),
            validation: validation.unwrap_or_default(),
        })
    }

    /// Largest position error (µm) at the deciding poses, and its expanded uncertainty.
    pub fn largest_um(found: &Unjudged) -> (f64, Option<f64>) {
        let set = found.accuracy.sets.last();
        let largest = set.and_then(|set| set.error_statistics(ErrorQuantity::Position)).map(|e| e.after.max);
        let of_maximum =
            |b: &&etalon_documents::FigureBudget| b.quantity == ErrorQuantity::Position && b.figure == Figure::Max;
        let budget = found.accuracy.budget.iter().find(of_maximum);
        (UM * largest.unwrap_or(0.0), budget.map(|b| 2.0 * UM * b.standard_uncertainty_mm))
    }
}

/// Identifies the observations of a campaign.
fn identified(campaign: &Campaign, observed: &Observed, robot: &mut dyn Robot) -> Result<Unjudged> {
    let stated = campaign.file.identify.as_ref().filter(|_| !observed.joined.observations.is_empty());
    let Some(stated) = stated else { return Err(error!("view-not-identified").into()) };
    identify_unjudged(CampaignData { campaign, stated, joined: &observed.joined, frames: &observed.frames }, robot)
}

/// Visits and observations before any exclusion, in the order of the measurement's poses.
fn all_observations(campaign: &Campaign, observed: &Observed) -> Result<(Vec<Visit>, Vec<Observation>)> {
    let (Some(stated), Some((_, first))) = (&campaign.file.identify, observed.joined.observations.first()) else {
        return Ok((Vec::new(), Vec::new()));
    };
    let mut robot = robot(campaign, &observed.gathered)?;
    let read = Input::new(campaign, stated, first)?.read(robot.as_mut(), &mut Vec::new())?;
    let mut observations = read.observations;
    // visits that measured no position have conditions alone
    let conditions = read.settings.conditions.iter().map(|c| Observation {
        pose: c.pose,
        cycle: c.cycle,
        joints: c.joints.clone(),
        targets: vec![None; robot.targets().len()],
        ..Observation::default()
    });
    observations.extend(conditions);
    let visit = |o: &Observation| Visit { pose: o.pose, cycle: o.cycle };
    observations.sort_by_key(visit);
    observations.dedup_by(|later, first| visit(later) == visit(first));
    Ok((observations.iter().map(visit).collect(), observations))
}

/// Outlying readings: index of the visit, and target.
fn outliers(robot: &dyn Robot, found: &Unjudged, visits: &[Visit]) -> BTreeSet<(usize, usize)> {
    let basis = &found.solution.basis;
    let fit = RobustFit::new(robot, &basis.sets.calibration, &basis.settings, &found.solution.found);
    let index = |pose: PoseName, cycle: i64| visits.binary_search(&Visit { pose, cycle }).ok();
    let fit = fit.iter().flat_map(RobustFit::outliers);
    fit.filter_map(|reading| Some((index(reading.pose, reading.cycle)?, reading.target))).collect()
}

/// Parameters of an identification, in the units of documents.
pub(super) fn parameters(robot: &dyn Robot, found: &Identification, language: &str) -> Vec<Parameter> {
    let parameter = |(i, p): (usize, &etalon_robots::Parameter)| Parameter {
        name: p.name.clone(),
        unit: p.quantity.unit().to_owned(),
        nominal: p.quantity.outward(p.nominal),
        identified: p.quantity.outward(found.values[i]),
        uncertainty: found.standard_uncertainty(i).map(|u| p.quantity.outward(u)).filter(|u| u.is_finite()),
        held: found.status[i] != Status::Identified,
        role: match p.role {
            Role::Robot => "robot",
            Role::Base => "base",
            Role::Target => "target",
            Role::Fixture => "fixture",
        },
        meaning: Some(p.meaning).filter(|id| !id.is_empty()).map(|id| Phrase::new(id).text(language)),
    };
    let finite = |p: &Parameter| p.nominal.is_finite() && p.identified.is_finite();
    robot.parameters().iter().enumerate().map(parameter).filter(finite).collect()
}

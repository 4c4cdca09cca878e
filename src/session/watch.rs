//! A measurement in progress: each new pose against the poses so far, and what the remaining poses
//! add.

use crate::session::changes::without_visits;
use crate::session::covariance::{place_covariances, rows, squared_distance, updated};
use crate::session::opened::Opened;
use crate::session::scene::UM;
use crate::session::visits::Visit;
use crate::session::{Contents, Depth, Session};
use crate::stages::calibrate::identification::Unjudged;
use crate::stages::candidates::configurations;
use crate::stages::evaluate::errors::position_rms_mm;
use crate::tasks::{Table, TableFormat};
use etalon_base::message::{AnsweredBy, Message, Result};
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::{error, phrase};
use etalon_campaign::Campaign;
use etalon_documents::{Conformity, LimitQuantity};
use etalon_identify::Observation;
use etalon_robots::Robot;
use etalon_view::{Desk, Event, Latest, Next, ParameterNow, ShownMessage, Stop, Tone, Watch};
use nalgebra::{DMatrix, Matrix3};
use statrs::distribution::{ChiSquared, ContinuousCDF};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;
use std::sync::{Arc, Weak};
use std::time::{Duration, SystemTime};

/// Time between two looks at the files. Network drives report no changes, so that they are looked
/// at; a look is a call of the system per file.
const LOOK: Duration = Duration::from_millis(250);
/// Looks after which a file that cannot be read is reported: an instrument may be writing it.
const PATIENCE: usize = 4;
/// Looks for which files may go on growing before they are read: a pose is read when it is written.
const SETTLING: usize = 3;
/// Probability of a good reading within its expected error: one false alarm in a thousand.
const EXPECTED: f64 = 0.999;
/// Share of the poses at which a target has to be measured to be missed at another one.
const USUAL: f64 = 0.5;
/// Poses that a message names.
const SHOWN: usize = 12;
/// Pairs of labels, and poses, that are tried to explain a disagreement.
const TRIED: usize = 200;

/// Poses to be measured.
#[derive(Clone, Debug)]
pub(crate) struct Planned {
    /// Table with `pose` and the joints.
    pub file: PathBuf,
    /// `true` if the rows are in the order of measurement; otherwise they are candidates.
    pub in_order: bool,
}

/// Sizes and times of files; none of a file that is missing.
type Stamps = BTreeMap<PathBuf, Option<(u64, SystemTime)>>;

/// The measurement as it was at the last look.
#[derive(Default)]
struct Watched {
    /// Files as they were read.
    stamps: Stamps,
    /// Files as they were seen since, and the number of looks at which they differed.
    growing: (Stamps, usize),
    opened: Option<Arc<Opened>>,
    /// Visits that disagreed, and identify nothing.
    disagreeing: BTreeSet<Visit>,
    failures: usize,
}

impl Session {
    /// Follows the files of the campaign while they grow, until the session ends.
    pub(crate) fn follow(self: &Arc<Self>, planned: Option<Planned>) {
        self.watching.store(true, Ordering::SeqCst);
        let session = Arc::downgrade(self);
        let opened = self.shown().opened.clone();
        let first = self.watch(&mut Watched { opened: None, ..Watched::default() }, opened.as_ref(), planned.as_ref());
        self.events.send(&Event::Watch(Box::new(first)));
        let work = move || follow(&session, opened, planned.as_ref());
        drop(std::thread::Builder::new().name("watch".to_owned()).spawn(work));
    }

    /// The state of the measurement with the campaign as read now.
    fn watch(&self, watched: &mut Watched, now: Option<&Arc<Opened>>, planned: Option<&Planned>) -> Watch {
        let language = self.language();
        match now {
            Some(now) => Comparison { language, watched, now, planned }.watch(),
            None => waiting(&self.shown().messages, language),
        }
    }

    /// The state with the identification of the earlier poses, if the newest pose contradicts it:
    /// one such pose may leave an identification without a result.
    fn by_earlier(
        &self,
        read: &Contents,
        watched: &mut Watched,
        planned: Option<&Planned>,
    ) -> Option<(Arc<Opened>, Watch)> {
        let now = Arc::new(Opened::by_earlier(read.campaign.as_ref()?, watched.opened.as_ref()?).ok()?);
        let told = self.watch(watched, Some(&now), planned);
        (told.tone == Tone::Bad).then_some((now, told))
    }
}

/// State without an identification.
fn waiting(messages: &[Message], language: &str) -> Watch {
    let wrong = messages.iter().find(|message| message.severity == etalon_base::message::Severity::Error);
    // before the first pose of a selection nothing is wrong
    match wrong.filter(|message| message.answered_by != AnsweredBy::Measurements) {
        Some(message) => {
            let message = ShownMessage::new(message, language);
            Watch {
                line: message.text.clone(),
                tone: Tone::Wait,
                latest: Some(Latest { message: Some(message), ..Latest::default() }),
                ..Watch::default()
            }
        }
        None => Watch { line: phrase!("watch-waiting").text(language), ..Watch::default() },
    }
}

/// Looks at the files until the session ends.
fn follow(session: &Weak<Session>, opened: Option<Arc<Opened>>, planned: Option<&Planned>) {
    let mut watched = Watched { opened, ..Watched::default() };
    loop {
        std::thread::sleep(LOOK);
        let Some(session) = session.upgrade() else { return };
        look(&session, &mut watched, planned);
    }
}

/// Looks at the files, and tells the page what is new.
fn look(session: &Session, watched: &mut Watched, planned: Option<&Planned>) {
    let stamps = stamps(&session.folder, session.shown().campaign.as_deref());
    if stamps == watched.stamps && watched.failures == 0 {
        return;
    }
    if stamps != watched.growing.0 && watched.growing.1 < SETTLING {
        watched.growing = (stamps, watched.growing.1 + 1);
        return;
    }
    watched.growing.1 = 0;
    let read = Contents::read(&session.folder, Depth::Quick);
    let (now, told) = match &read.opened {
        Some(now) => (Some(now.clone()), Some(session.watch(watched, Some(now), planned))),
        None => session.by_earlier(&read, watched, planned).unzip(),
    };
    let (Some(now), Some(told)) = (now, told) else {
        watched.stamps = stamps;
        watched.failures += 1;
        if watched.failures == PATIENCE {
            // the results so far stay
            let line = waiting(&read.messages, session.language());
            session.shown().messages = read.messages;
            session.tell();
            session.events.send(&Event::Watch(Box::new(Watch { tone: Tone::Bad, ..line })));
        }
        if watched.failures >= PATIENCE {
            watched.failures = PATIENCE + 1;
        }
        return;
    };
    (watched.stamps, watched.failures) = (stamps, 0);
    watched.opened = Some(now.clone());
    {
        let mut shown = session.shown();
        (shown.campaign, shown.opened, shown.ran) = (read.campaign, Some(now), read.ran);
        shown.messages = read.messages;
    }
    session.tell();
    session.events.send(&Event::Watch(Box::new(told)));
}

/// Sizes and times of the files of a campaign.
fn stamps(folder: &Path, campaign: Option<&Campaign>) -> Stamps {
    let stated = folder.join("campaign.toml");
    // files of an instrument that writes a file for each pose come while it measures
    let inputs = campaign.into_iter().flat_map(Campaign::present_inputs);
    let stamp = |path: PathBuf| {
        let found = std::fs::metadata(&path).ok().and_then(|file| Some((file.len(), file.modified().ok()?)));
        (path, found)
    };
    std::iter::once(stated).chain(inputs).map(stamp).collect()
}

/// Campaign as read now, compared with the last look.
struct Comparison<'a> {
    language: &'a str,
    watched: &'a mut Watched,
    now: &'a Opened,
    planned: Option<&'a Planned>,
}

impl Comparison<'_> {
    fn watch(mut self) -> Watch {
        let language = self.language;
        let received = self.now.visits.len();
        let newest = self.newest();
        let latest = match newest.and_then(|at| self.judge(at)) {
            Some(latest) if !latest.agrees => Some(latest),
            latest => self.gone().or(latest),
        };
        let (robot, found) = self.model();
        let (robot, found): (&dyn Robot, &Unjudged) = match &robot {
            Some(robot) => (robot.as_ref(), &found),
            None => (self.now.robot.as_ref(), &self.now.found),
        };
        let candidates = self.planned.and_then(|planned| self.candidates(planned).ok());
        let remaining: Vec<&Observation> = candidates.iter().flatten().filter(|o| !self.is_measured(o)).collect();
        let stop = stop(found, language);
        let parameters = parameters(robot, found, candidates.is_some().then_some(&remaining));
        let next = self.planned.and_then(|planned| next(robot, found, &remaining, planned.in_order, language));
        let disagrees = latest.as_ref().filter(|latest| !latest.agrees);
        let line = match (disagrees.and_then(|latest| latest.message.as_ref()), &latest, &stop) {
            (Some(message), ..) => message.text.clone(),
            (None, _, Stop { met: true, text }) => text.clone(),
            (None, Some(Latest { pose, error_um: Some(error_um), expected_um: Some(expected_um), .. }), _) => {
                phrase!("watch-agrees", pose, error_um, expected_um).text(language)
            }
            _ if Prediction::new(robot, found).is_none() => phrase!("watch-few", received).text(language),
            _ => phrase!("watch-first", received).text(language),
        };
        Watch {
            received,
            planned: candidates.as_ref().map(|all| all.iter().map(|o| o.pose).collect::<BTreeSet<_>>().len()),
            line,
            tone: if disagrees.is_some() { Tone::Bad } else { Tone::Good },
            latest,
            parameters: Some(parameters),
            next,
            stop: Some(stop),
            scene: None,
        }
    }

    /// Index of the newest visit since the last look.
    fn newest(&self) -> Option<usize> {
        let before = self.watched.opened.as_ref()?;
        let is_new = |(visit, observation): &(&Visit, &Observation)| {
            let earlier = before.visits.binary_search(visit).ok();
            earlier.is_none_or(|at| before.observations[at].targets != observation.targets)
        };
        let new: Vec<usize> = (0..self.now.visits.len())
            .filter(|at| is_new(&(&self.now.visits[*at], &self.now.observations[*at])))
            .collect();
        // of several, the one that disagrees most is found by its time or, without, its order
        let time = |at: &usize| self.now.scene.poses.get(*at).and_then(|pose| pose.time_s).unwrap_or(f64::NEG_INFINITY);
        new.into_iter().max_by(|a, b| time(a).total_cmp(&time(b)).then(a.cmp(b)))
    }

    /// Visits of the last look whose readings are gone: a file vanished, or lost its last rows.
    fn gone(&self) -> Option<Latest> {
        let before = self.watched.opened.as_ref()?;
        let several = Visit::have_cycles(&before.visits);
        let gone = before.visits.iter().filter(|visit| self.now.visits.binary_search(visit).is_err());
        let poses: Vec<String> = gone.map(|visit| visit.id(several)).collect();
        let shown: Vec<&String> = poses.iter().take(SHOWN).collect();
        let message = error!("watch-poses-gone", count = poses.len(), poses = shown);
        let pose = poses.last()?.clone();
        let message = Some(ShownMessage::new(&message, self.language));
        Some(Latest { pose, message, ..Latest::default() })
    }

    /// The identification without the visits that disagreed; no robot if all agreed.
    fn model(&self) -> (Option<Box<dyn Robot>>, Unjudged) {
        let is_there = |visit: &Visit| self.now.visits.binary_search(visit).is_ok();
        let out: Vec<Visit> = self.watched.disagreeing.iter().copied().filter(is_there).collect();
        let again = || -> Result<(Box<dyn Robot>, Unjudged)> { self.now.again(&without_visits(self.now, &out)?) };
        match (!out.is_empty()).then(again) {
            Some(Ok((robot, found))) => (Some(robot), found),
            _ => (None, self.now.found.clone()),
        }
    }

    /// Compares a visit with the prediction of the earlier ones.
    fn judge(&mut self, at: usize) -> Option<Latest> {
        let before = self.watched.opened.clone()?;
        let several = Visit::have_cycles(&self.now.visits);
        let visit = self.now.visits[at];
        let pose = visit.id(several);
        let out: Vec<Visit> = self.watched.disagreeing.iter().copied().filter(|v| before.visits.contains(v)).collect();
        let again = (!out.is_empty()).then(|| before.again(&without_visits(&before, &out).ok()?).ok()).flatten();
        let (robot, found) = match &again {
            Some((robot, found)) => (robot.as_ref(), found),
            None => (before.robot.as_ref(), &before.found),
        };
        let test = Prediction::new(robot, found)?;
        let observation = &self.now.observations[at];
        let errors = test.errors(observation, &observation.joints)?;
        let worst = errors.iter().max_by(|a, b| a.squared.total_cmp(&b.squared))?;
        let agrees = errors.iter().all(|error| error.squared <= test.bound);
        if agrees {
            self.watched.disagreeing.remove(&visit);
        } else {
            self.watched.disagreeing.insert(visit);
        }
        let (error_um, expected_um) = (UM * norm(worst.mm), UM * worst.expected_mm);
        let target = robot.targets().get(worst.target).cloned().unwrap_or_default();
        let message = match agrees {
            true => missing(&before, observation, robot, &pose),
            false => Some(
                test.exchanged(observation, robot, &pose)
                    .or_else(|| test.joints_elsewhere(observation, &before, &pose))
                    .unwrap_or_else(|| {
                        error!("watch-disagrees", pose = &pose, error_um, target = &target, expected_um)
                    }),
            ),
        };
        Some(Latest {
            pose,
            target: Some(target),
            error_um: Some(error_um),
            expected_um: Some(expected_um),
            agrees: agrees && message.is_none(),
            message: message.map(|message| ShownMessage::new(&message, self.language)),
        })
    }

    /// The planned poses, each with the targets that are usually measured.
    fn candidates(&self, planned: &Planned) -> Result<Vec<Observation>> {
        let file = TableFormat::default().read_poses(Table::File(&planned.file))?;
        let candidates = configurations(self.now.robot.as_ref(), &file.table).map_err(|more| file.place(more))?;
        let usual = usual_targets(self.now);
        let all = candidates.observations.into_iter().map(|o| Observation { targets: usual.clone(), ..o });
        Ok(all.collect())
    }

    fn is_measured(&self, planned: &Observation) -> bool {
        self.now.visits.iter().any(|visit| visit.pose == planned.pose && !self.watched.disagreeing.contains(visit))
    }
}

/// Targets that are measured at most poses.
fn usual_targets(opened: &Opened) -> Vec<Option<Vector>> {
    let count = |k: usize| opened.observations.iter().filter(|o| o.targets.get(k).is_some_and(Option::is_some)).count();
    let least = USUAL * opened.observations.len() as f64;
    (0..opened.robot.targets().len()).map(|k| (count(k) as f64 >= least).then_some([0.0; 3])).collect()
}

/// Warning about a target that the visit does not have.
fn missing(before: &Opened, observation: &Observation, robot: &dyn Robot, pose: &str) -> Option<Message> {
    let usual = usual_targets(before);
    let lacks = |k: &usize| usual[*k].is_some() && observation.targets.get(*k).is_some_and(Option::is_none);
    let targets: Vec<&String> = (0..usual.len()).filter(lacks).filter_map(|k| robot.targets().get(k)).collect();
    (!targets.is_empty()).then(|| error!("watch-target-missing", pose, targets))
}

/// Prediction of places by an identification.
struct Prediction<'a> {
    robot: &'a dyn Robot,
    found: &'a Unjudged,
    /// Variance of a measured coordinate (mm²): given, or as the residuals show.
    variance_mm2: f64,
    /// Bound on the squared distance of a reading.
    bound: f64,
}

/// Error of a reading.
struct PlaceError {
    target: usize,
    mm: Vector,
    /// Squared distance under the covariance of reading and prediction.
    squared: f64,
    /// Error (mm) that reading and prediction permit along the error.
    expected_mm: f64,
}

impl<'a> Prediction<'a> {
    /// `None` without degrees of freedom.
    fn new(robot: &'a dyn Robot, found: &'a Unjudged) -> Option<Self> {
        let solution = &found.solution;
        let (sets, settings) = (&solution.basis.sets, &solution.basis.settings);
        let dimension = robot.dimension();
        (solution.found.residuals.degrees_of_freedom > 0).then_some(())?;
        let stated = settings.coordinate_uncertainty_mm();
        let rms = position_rms_mm(robot, &sets.calibration, &solution.found.values).unwrap_or(0.0);
        let per_coordinate = rms / (dimension as f64).sqrt();
        let bound = ChiSquared::new(dimension as f64).ok()?.inverse_cdf(EXPECTED);
        let variance_mm2 = stated.max(per_coordinate).powi(2);
        (variance_mm2 > 0.0).then_some(Self { robot, found, variance_mm2, bound })
    }

    /// Errors of the measured targets, if the robot were at these joint values.
    fn errors(&self, observation: &Observation, joints: &[f64]) -> Option<Vec<PlaceError>> {
        let Self { robot, found, variance_mm2, bound } = self;
        let identified = &found.solution.found;
        let covariances = place_covariances(*robot, identified, joints)?;
        let mut all = Vec::new();
        for (target, measured) in observation.targets.iter().enumerate() {
            let Some(measured) = measured else { continue };
            let mm = minus(*measured, robot.position(&identified.values, joints, target));
            let covariance = covariances[target] + Matrix3::identity() * *variance_mm2;
            let squared = squared_distance(mm, &covariance, robot.dimension())?;
            let expected_mm = norm(mm) * (bound / squared.max(f64::MIN_POSITIVE)).sqrt();
            all.push(PlaceError { target, mm, squared, expected_mm });
        }
        (!all.is_empty() && all.iter().all(|error| error.squared.is_finite())).then_some(all)
    }

    fn agrees(&self, observation: &Observation, joints: &[f64]) -> bool {
        let errors = self.errors(observation, joints);
        errors.is_some_and(|errors| errors.iter().all(|error| error.squared <= self.bound))
    }

    /// Message if the reading agrees with two of its targets swapped.
    fn exchanged(&self, observation: &Observation, robot: &dyn Robot, pose: &str) -> Option<Message> {
        let measured: Vec<usize> =
            (0..observation.targets.len()).filter(|k| observation.targets[*k].is_some()).collect();
        let pairs = measured.iter().flat_map(|a| measured.iter().filter(move |b| a < *b).map(move |b| (*a, *b)));
        let fits = |(a, b): &(usize, usize)| {
            let mut other = observation.clone();
            other.targets.swap(*a, *b);
            self.agrees(&other, &observation.joints)
        };
        let (a, b) = pairs.take(TRIED).find(fits)?;
        let (first, second) = (robot.targets().get(a)?, robot.targets().get(b)?);
        Some(error!("watch-labels-exchanged", pose, first, second))
    }

    /// Message if the reading agrees with the joint values of another pose: the latest first.
    fn joints_elsewhere(&self, observation: &Observation, before: &Opened, pose: &str) -> Option<Message> {
        let several = Visit::have_cycles(&before.visits);
        let others = before.visits.iter().zip(&before.observations).rev().take(TRIED);
        let moved = others.filter(|(_, other)| other.joints != observation.joints);
        let (other, _) = moved.into_iter().find(|(_, other)| self.agrees(observation, &other.joints))?;
        Some(error!("watch-joints-of-other-pose", pose, other = other.id(several)))
    }
}

/// State of the limit of the largest position error.
fn stop(found: &Unjudged, language: &str) -> Stop {
    let limit = found.accuracy.limits.iter().find(|limit| limit.name == LimitQuantity::PositionMaxMm);
    let known = limit.and_then(|limit| Some((limit, limit.value?)));
    let Some((limit, value)) = known else {
        return Stop { met: false, text: phrase!("watch-stop-no-limit").text(language) };
    };
    let (value_um, limit_um) = (UM * value, UM * limit.limit);
    let expanded_um = UM * limit.expanded_uncertainty.unwrap_or(0.0);
    // met with its guard band, independent of the rule of the campaign
    let met = limit.conformity == Conformity::Conforming && value_um + expanded_um <= limit_um;
    let text = match met {
        true => phrase!("watch-stop-met", value_um, expanded_um, limit_um),
        false => phrase!("watch-stop-open", value_um, expanded_um, limit_um),
    };
    Stop { met, text: text.text(language) }
}

/// Covariance of the identified parameters.
fn covariance(found: &Unjudged) -> Option<DMatrix<f64>> {
    let identified = &found.solution.found;
    let n = identified.free.len();
    let covariance = identified.uncertainty.covariance.as_ref().filter(|c| c.len() == n * n && n > 0)?;
    Some(DMatrix::from_row_slice(n, n, covariance))
}

/// Parameters of the robot with their uncertainties now and after the remaining poses.
fn parameters(robot: &dyn Robot, found: &Unjudged, remaining: Option<&Vec<&Observation>>) -> Vec<ParameterNow> {
    let identified = &found.solution.found;
    let variance = Prediction::new(robot, found).map(|prediction| prediction.variance_mm2);
    let end = remaining.zip(variance).zip(covariance(found)).map(|((remaining, variance), mut covariance)| {
        for planned in remaining {
            covariance = updated(&covariance, &rows(robot, identified, planned), variance).unwrap_or(covariance);
        }
        covariance
    });
    let parameter = |(k, &i): (usize, &usize)| {
        let p = &robot.parameters()[i];
        let u_now = p.quantity.outward(identified.standard_uncertainty(i)?);
        let u_end = end.as_ref().map(|end| p.quantity.outward(end[(k, k)].max(0.0).sqrt()));
        let (name, unit) = (p.name.clone(), p.quantity.unit().to_owned());
        let value = p.quantity.outward(identified.values[i]);
        u_now.is_finite().then_some(ParameterNow { name, unit, value, u_now, u_end })
    };
    identified.free.iter().enumerate().filter_map(parameter).collect()
}

/// Pose to measure next: the next of the plan, or the pose with the most information (D-optimality:
/// the largest decrease of the determinant of the covariance).
fn next(
    robot: &dyn Robot,
    found: &Unjudged,
    remaining: &[&Observation],
    in_order: bool,
    language: &str,
) -> Option<Next> {
    let shown = |o: &Observation, reason: String| Next {
        pose: o.pose.to_string(),
        joints: robot.joints().iter().zip(&o.joints).map(|(joint, q)| joint.quantity.outward(*q)).collect(),
        reason,
    };
    if in_order {
        return remaining.first().map(|o| shown(o, phrase!("watch-next-of-plan").text(language)));
    }
    let (covariance, variance) = (covariance(found)?, Prediction::new(robot, found)?.variance_mm2);
    let gain = |o: &&&Observation| {
        let by = rows(robot, &found.solution.found, o);
        let information = DMatrix::identity(by.nrows(), by.nrows()) + &by * &covariance * by.transpose() / variance;
        information.cholesky().map_or(f64::NEG_INFINITY, |factor| factor.ln_determinant())
    };
    let best = remaining.iter().max_by(|a, b| gain(a).total_cmp(&gain(b)))?;
    Some(shown(best, phrase!("watch-next-of-most-information").text(language)))
}

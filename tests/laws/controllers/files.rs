//! Controller files of drawn arms and of the other kinds of robots: read back by a reader of this test and evaluated at the validation poses, a
//! file has the error that it states, and is not worse than nominal. The data are synthetic. `ETALON_ARMS` is the number of arms.

use super::drawn::{drawn, scara};
use super::readers::read_back;
use crate::support::documents_of;
use crate::support::scratch::{Scratch, copy_sample};
use etalon::base::message::Problems;
use etalon::campaign::Campaign;
use etalon::controllers::{self, Description, ExportInput, Exporter};
use etalon::documents::{CampaignSummary, ControllersDocument, IdentifiedDocuments};
use etalon::robots::Robot;
use etalon::run::pipeline::Outcome;
use etalon::stages::calibrate::controller_files::identify_again;
use etalon::stages::calibrate::identification::IdentifiedSolution;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Largest relative difference of the error that a file states and that of its reader.
const AGREES: f64 = 0.02;
/// Refusals of a format that cannot hold a robot, or not as accurately as it was identified.
const REFUSALS: [&str; 6] = [
    "format-for-other-robots",
    "format-too-many-joints",
    "file-worse-than-nominal",
    "formulas-missing",
    "parameter-names-collide",
    "positions-not-measured",
];

fn number(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|value| value.parse().ok()).unwrap_or(default)
}

/// A campaign that was run.
pub struct Ran {
    pub name: String,
    pub scratch: Scratch,
    campaign: Campaign,
    pub robot: Box<dyn Robot>,
    description: Option<(String, String)>,
    /// Statements of the campaign, with a date, which a certificate needs.
    summary: CampaignSummary,
    outcome: Outcome,
}

impl Ran {
    fn new(name: impl Into<String>, scratch: Scratch) -> Self {
        let name = name.into();
        let campaign = Campaign::read(&scratch.path()).unwrap();
        let outcome = documents_of(&campaign).unwrap_or_else(|problems| panic!("{name}: {problems}"));
        // where joined exports name none, targets are those whose places were found
        let found = &outcome.results.identified.as_ref().unwrap().parameters.parameters;
        let of_targets = found.iter().filter(|p| p.role == etalon::documents::Role::Target);
        let named = !campaign.file.observations.is_empty();
        let targets: Vec<String> =
            of_targets.filter_map(|p| Some(p.name.strip_suffix("_x")?.to_owned())).filter(|_| named).collect();
        let robot = campaign.build_robot_with(&targets).unwrap();
        let description = campaign.robot.description().map(|(file, text)| (file.to_owned(), text.to_owned()));
        let mut summary = outcome.results.campaign.clone();
        summary.measurements.date = Some("2026-03-02".to_owned());
        Self { name, scratch, campaign, robot, description, summary, outcome }
    }

    pub fn found(&self) -> &IdentifiedDocuments {
        self.outcome.results.identified.as_ref().unwrap()
    }

    pub fn solution(&self) -> &IdentifiedSolution {
        self.outcome.solution.as_ref().unwrap()
    }

    fn given<'a>(&'a self, controllers: Option<&'a ControllersDocument>) -> ExportInput<'a> {
        let found = self.found();
        ExportInput {
            summary: Some(&self.summary),
            robot: Some(self.robot.as_ref()),
            description: self.description.as_ref().map(|(file, text)| Description { file, text }),
            accuracy: Some(&found.accuracy),
            controllers,
            ..ExportInput::parameters(&found.parameters)
        }
    }

    /// The file of a format with the values that it holds (all parameters; base and targets as fitted to them) and its stated error.
    fn file(&self, format: &str) -> Result<File<'_>, Problems> {
        let exporter: &dyn Exporter = controllers::by_name(format).unwrap();
        let (given, robot) = (self.given(None), self.robot.as_ref());
        let again = identify_again(&self.campaign, &given, robot, self.solution(), &[(format, exporter)]);
        let given = self.given(again.as_ref());
        let statement = given.statement(exporter)?;
        let bytes = exporter.write(&given)?;
        let file = again.as_ref().and_then(|document| document.files.first());
        let own = |p: &etalon::robots::Parameter| {
            let entry = || self.found().parameters.parameters.iter().find(|e| e.name == p.name).map(|e| e.value);
            let held = file.map(|file| file.values.iter().find(|v| v.name == p.name).unwrap().value);
            p.quantity.inward(held.or_else(entry).unwrap_or(p.nominal))
        };
        let values = self.robot.parameters().iter().map(own).collect();
        let errors = statement.errors.unwrap_or_else(|| panic!("{}: {format} states no error", self.name));
        let name = exporter.file_name();
        Ok(File { ran: self, name, bytes, values, stated: errors.written.rms_mm, nominal: errors.nominal.rms_mm })
    }
}

/// A controller file.
pub struct File<'a> {
    pub ran: &'a Ran,
    name: &'static str,
    bytes: Vec<u8>,
    pub values: Vec<f64>,
    /// Root mean squares (mm) at the validation poses, stated for the file and for nominal values.
    stated: f64,
    nominal: f64,
}

impl File<'_> {
    pub fn text(&self) -> String {
        String::from_utf8(self.bytes.clone()).unwrap()
    }

    /// Writes the file where programs find it, and returns its name.
    pub fn write(&self) -> String {
        std::fs::write(self.ran.scratch.root().join(self.name), &self.bytes).unwrap();
        self.name.to_owned()
    }

    /// Number of inputs of code: joint values, and the assembly mode of robots that have several.
    pub fn coded(&self) -> usize {
        self.ran.robot.joints().len() + usize::from(self.ran.robot.has_assembly_modes())
    }
}

/// Files by format: readings, and refusals.
#[derive(Default)]
struct Tally {
    read: BTreeMap<&'static str, usize>,
    refused: BTreeMap<(&'static str, String), usize>,
    wrong: Vec<String>,
}

impl Tally {
    fn add(mut self, other: Self) -> Self {
        other.read.into_iter().for_each(|(k, n)| *self.read.entry(k).or_default() += n);
        other.refused.into_iter().for_each(|(k, n)| *self.refused.entry(k).or_default() += n);
        self.wrong.extend(other.wrong);
        self
    }

    /// Reads the files of all formats of a campaign, or of those for all robots.
    fn of(ran: &Ran) -> Self {
        let mut tally = Self::default();
        for format in controllers::names() {
            let file = match ran.file(format) {
                Ok(file) => file,
                Err(problems) => {
                    let id = problems.0.first().map(|m| m.id.to_string()).unwrap_or_default();
                    if !REFUSALS.contains(&id.as_str()) {
                        tally.wrong.push(format!("{}: {format} is refused: {problems}", ran.name));
                    }
                    *tally.refused.entry((format, id)).or_default() += 1;
                    continue;
                }
            };
            for read in read_back(format, &file) {
                *tally.read.entry(format).or_default() += 1;
                let (stated, nominal) = (file.stated, file.nominal);
                if (read / stated - 1.0).abs() > AGREES || read.is_nan() {
                    tally.wrong.push(format!("{}: {format} states {stated:.6} mm, and has {read:.6} mm", ran.name));
                }
                if read > nominal {
                    tally.wrong.push(format!("{}: {format} has {read:.6} mm, nominal {nominal:.6} mm", ran.name));
                }
            }
        }
        tally
    }

    fn judge(&self) {
        println!("read back: {:?}\nrefused: {:?}", self.read, self.refused);
        let [read, refused] = [self.read.values().sum::<usize>(), self.refused.values().sum()];
        println!("{read} readings, {refused} files refused or not for the robot, {} wrong", self.wrong.len());
        assert!(self.wrong.is_empty(), "{:#?}", self.wrong);
        assert!(read > 0);
    }
}

#[test]
#[ignore = "a long law: make laws"]
fn files_of_drawn_arms_are_as_accurate_as_they_say() {
    let arms = number("ETALON_ARMS", 8);
    let of_arm = |seed: u64| Tally::of(&Ran::new(format!("arm {seed}"), drawn(seed)));
    (0..arms).into_par_iter().map(of_arm).reduce(Tally::default, Tally::add).judge();
}

#[test]
#[ignore = "a long law: make laws"]
fn files_of_other_robots_are_as_accurate_as_they_say() {
    let samples =
        ["prexyt-cmm", "prexyt-faroarm", "dextar", "hexapod", "delta", "linear-delta", "column-arm", "rail-arm"];
    let sample = |name: &&str| Tally::of(&Ran::new(*name, copy_sample(name)));
    let scara = Tally::of(&Ran::new("SCARA", scara()));
    let all = samples.par_iter().map(sample).reduce(Tally::default, Tally::add).add(scara);
    all.judge();
    // every format is for one of these robots, except the formats for six revolute joints
    let unread: Vec<&str> = controllers::names().filter(|format| !all.read.contains_key(format)).collect();
    println!("read of no robot here: {unread:?}");
}

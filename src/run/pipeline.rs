//! The hallway: every stage is a function from the documents before it to the document after it.

use crate::base::message::{Message, Place, Problems, Result};
use crate::campaign::Campaign;
use crate::document::*;
use crate::export;
use crate::import;
use crate::math::identify::{self, Identification, Observation};
use crate::math::robots::Robot;
use crate::report;
use crate::run::check::{check, selections};
use crate::run::output::Output;
use crate::run::summary::summary;
use crate::stages::evaluate::{self, Sets};
use crate::stages::frames;
use crate::stages::geometric;
use crate::stages::iso9283::characteristics;
use crate::stages::join;
use crate::stages::parameters::parameters_document;
use crate::stages::plausible::doubts;

/// What a run found, for the one who called it.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Identified parameters.
    pub parameters: ParametersDocument,
    /// Errors before and after.
    pub accuracy: AccuracyDocument,
    /// Characteristics of ISO 9283, where the campaign tests any.
    pub tested: Characteristics,
    /// Whether every limit is met, and the result can be that of a robot.
    pub met: bool,
    /// Everything that the report warns of.
    pub messages: Vec<Message>,
    /// Files written, in order.
    pub written: Vec<String>,
}

/// Runs a campaign from its exports to the report. Nothing is written before all of it is computed.
/// Where a stage fails, the warnings of those before it come first: they may tell why.
pub fn run(campaign: &Campaign) -> Result<Outcome> {
    if !campaign.identifies() {
        let message = Message::error("the campaign identifies nothing").at(Place::file(campaign.path.as_str()));
        return Err(message.expected("[log], [join], [frame] and [identify]").into());
    }
    let mut warnings = Vec::new();
    stages(campaign, &mut warnings).map_err(|problems| {
        let told = |message: &Message| problems.0.contains(message);
        Problems(warnings.iter().filter(|m| !told(m)).chain(&problems.0).cloned().collect())
    })
}

fn stages(campaign: &Campaign, warnings: &mut Vec<Message>) -> Result<Outcome> {
    let mut out = Output::new(campaign.output()?);

    // import: exports and logs become points and joint values
    let mut imported = check(campaign)?;
    warnings.clone_from(&imported.document.messages);
    let robot = campaign.build_robot()?;

    // fit: points become features
    let features = frames::fit_features(campaign, &imported.points)?;

    // frames: features and targets become the world
    let frames = frames::make_frames(campaign, &imported.points, &features, robot.dimension() == 2)?;

    // tests: visits of poses, recorded motions and loads become characteristics of ISO 9283
    let tested = characteristics::evaluate(campaign, &mut imported, &frames)?;

    // join: measurements meet joint values
    let joined = join::join(campaign, &imported, &frames, robot.as_ref())?;
    imported.document.messages.extend(features.messages.clone());
    imported.document.messages.extend(joined.messages.clone());
    imported.document.unmatched = joined.unmatched;
    warnings.clone_from(&imported.document.messages);

    // identify: observations become parameters
    let (calibration, validation) = campaign.selections()?;
    let mut messages = Vec::new();
    let observations = Observation::from_table(robot.as_ref(), &joined.observations[0].1, &mut messages)?;
    let poses = evaluate::poses(&observations);
    let sets = evaluate::split(&observations, &poses, &calibration, validation.as_ref());
    selections(campaign, &poses)?;
    let settings = campaign.settings();
    let before = identify::fit_frames(robot.as_ref(), &sets.calibration, &settings)?;
    let mut found = identify::identify_from(robot.as_ref(), &sets.calibration, &settings, &before)?;
    for (name, table) in joined.observations.iter().skip(1) {
        let observations = Observation::from_table(robot.as_ref(), table, &mut messages)?;
        let others = evaluate::split(&observations, &poses, &calibration, validation.as_ref());
        let used = campaign.file.logs[0].name.as_str();
        let theirs = identify::identify(robot.as_ref(), &others.calibration, &settings)?;
        let (this, that) = ((used, &sets, &found), (name.as_str(), &others, &theirs));
        let said = [compare_logs(robot.as_ref(), this, that, used), compare_logs(robot.as_ref(), that, this, used)];
        found.warnings.extend(said.into_iter().flatten());
    }
    found.warnings.splice(0..0, messages);
    // evaluate: errors before and after
    let errors = evaluate::errors(robot.as_ref(), &sets, &before, &found.values);
    let doubts = doubts(robot.as_ref(), &sets.calibration, &settings, &found, &errors);
    found.warnings.splice(0..0, doubts);
    let parameters = parameters_document(robot.as_ref(), &settings, &before, &found, &imported.document.inputs());
    let accuracy = evaluate::evaluate(robot.as_ref(), &errors, &campaign.file.limits)?;

    // geometry: what balls, a shaft and an arm tell, side by side with that
    let geometric = geometric::calibrate(campaign, robot.as_ref(), &imported.points, &sets, &found)?;

    // report and export, from the documents alone
    let summary = summary(campaign)?;
    let report = report::Report {
        campaign: &summary,
        import: &imported.document,
        features: &features,
        frames: &frames,
        identified: Some(report::Identified {
            parameters: &parameters,
            accuracy: &accuracy,
            errors: &errors,
            geometric: geometric.as_ref(),
        }),
        tested: &tested,
    };
    let (met, reports) = (report.is_met(), report::files(&report)?);
    out.table("points", &mut import::table(&imported.points)?)?;
    for log in &imported.logs {
        out.table(&Output::numbered("joints", &log.name, campaign), &mut log.table()?)?;
    }
    out.json("campaign.json", &summary)?;
    out.json("import.json", &imported.document)?;
    out.json("features.json", &features)?;
    out.json("frames.json", &frames)?;
    for (name, mut observations) in joined.observations {
        let stem = Output::numbered("observations", &name, campaign);
        out.table(&stem, &mut observations)?;
        out.csv(&stem, &mut observations)?;
    }
    out.json("parameters.json", &parameters)?;
    out.table("residuals", &mut evaluate::to_table(&errors)?)?;
    out.json("accuracy.json", &accuracy)?;
    out.optional("geometric.json", geometric.as_ref())?;
    write_tested(&tested, &mut out)?;
    for exporter in exporters(campaign) {
        match parameters.is_plausible() {
            true => out.bytes(exporter.file_name(), exporter.write(&parameters)?),
            false => out.remove(exporter.file_name()),
        }
    }
    add(&mut out, reports);
    let messages = imported.document.messages.iter().chain(&parameters.messages);
    let messages = messages.chain(geometric.iter().flat_map(|g| &g.messages));
    let messages = messages.chain(tested.messages()).cloned().collect();
    Ok(Outcome { written: out.write()?, parameters, accuracy, tested, met, messages })
}

/// What a test by ISO 9283 found, for the one who called it.
#[derive(Clone, Debug)]
pub struct Tested {
    /// Its characteristics.
    pub found: Characteristics,
    /// Whether every limit is met.
    pub met: bool,
    /// Everything that the report warns of.
    pub messages: Vec<Message>,
    /// Files written, in order.
    pub written: Vec<String>,
}

/// Runs a campaign that identifies nothing ([`Campaign::identifies`]): import, features and frames as ever, then its tests by
/// ISO 9283. Nothing is written before all of it is computed.
pub fn test(campaign: &Campaign) -> Result<Tested> {
    let mut out = Output::new(campaign.output()?);
    let mut imported = check(campaign)?;
    let features = frames::fit_features(campaign, &imported.points)?;
    imported.document.messages.extend(features.messages.clone());
    let planar = campaign.build_robot()?.dimension() == 2;
    let frames = frames::make_frames(campaign, &imported.points, &features, planar)?;
    let found = characteristics::evaluate(campaign, &mut imported, &frames)?;
    let summary = summary(campaign)?;
    let report = report::Report {
        campaign: &summary,
        import: &imported.document,
        features: &features,
        frames: &frames,
        identified: None,
        tested: &found,
    };
    let (met, reports) = (report.is_met(), report::files(&report)?);
    // an earlier run may have identified
    ["parameters.json", "accuracy.json", "residuals.parquet", "geometric.json"].into_iter().for_each(|n| out.remove(n));
    out.table("points", &mut import::table(&imported.points)?)?;
    out.json("campaign.json", &summary)?;
    out.json("import.json", &imported.document)?;
    out.json("features.json", &features)?;
    out.json("frames.json", &frames)?;
    write_tested(&found, &mut out)?;
    add(&mut out, reports);
    let messages = imported.document.messages.iter().chain(found.messages()).cloned().collect();
    Ok(Tested { written: out.write()?, found, met, messages })
}

/// The controller formats that the campaign names, or all of them.
fn exporters(campaign: &Campaign) -> Vec<&'static dyn export::Exporter> {
    match &campaign.file.controllers {
        Some(names) => names.iter().filter_map(|name| export::by_name(name.get_ref())).collect(),
        None => export::names().filter_map(export::by_name).collect(),
    }
}

/// Adds the files of a report; a program without PDF leaves none of an earlier run.
fn add(out: &mut Output, reports: Vec<report::File>) {
    if !cfg!(feature = "pdf") {
        out.remove("report.pdf");
    }
    reports.into_iter().for_each(|(name, bytes)| out.bytes(name, bytes));
}

/// Adds the documents of tests by ISO 9283 to the output folder; one that an earlier run left goes.
fn write_tested(found: &Characteristics, out: &mut Output) -> Result<()> {
    out.optional("iso9283.json", found.poses.as_ref())?;
    out.optional("iso9283-streams.json", found.streams.as_ref())?;
    out.optional("iso9283-compliance.json", found.compliance.as_ref())
}

/// A log by its name, its observations and what they identify.
type Logged<'a> = (&'a str, &'a Sets, &'a Identification);

/// Says so when residuals with one log correlate with its difference from another; `used` is the campaign's choice.
fn compare_logs(robot: &dyn Robot, this: Logged, that: Logged, used: &str) -> Option<Message> {
    let (name, here, found) = this;
    let (other, there, others) = that;
    let compared = identify::compare_logs(robot, &found.values, &here.calibration, &there.calibration)?;
    if compared.correlation <= 0.3 {
        return None;
    }
    let what = format!(
        "with log `{name}`, residuals correlate with the difference of the two logs, r = {:.2}: their root mean square \
         is {:.3} mm, with log `{other}` {:.3} mm",
        compared.correlation, found.rms, others.rms
    );
    let hint = if name == used {
        format!("identify with log `{other}`: name it first")
    } else {
        format!("log `{other}` is the one to use, as this campaign does")
    };
    Some(Message::warning(what).hint(hint))
}

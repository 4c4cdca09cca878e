//! The hallway: every stage is a function from the documents before it to the document after it.

use crate::campaign::{Campaign, check};
use crate::document::*;
use crate::evaluate::{self, Sets};
use crate::identify::{self, Observation, Settings};
use crate::message::{Message, Result};
use crate::output::Output;
use crate::parameters::parameters_document;
use crate::robots::Robot;
use crate::{export, frames, join, report};

/// What a run found, for the one who called it.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Identified parameters.
    pub parameters: ParametersDocument,
    /// Errors before and after.
    pub accuracy: AccuracyDocument,
    /// Everything that the report warns of.
    pub messages: Vec<Message>,
    /// Files written, in order.
    pub written: Vec<String>,
}

/// Runs a campaign from its exports to the report. Nothing is written before all of it is computed.
pub fn run(campaign: &Campaign) -> Result<Outcome> {
    let mut out = Output::new(campaign.output()?);

    // import: exports and logs become points and joint values
    let mut imported = check(campaign)?;
    let robot = campaign.build_robot()?;

    // fit: points become features
    let features = frames::fit_features(campaign, &imported.points)?;

    // frames: features and targets become the world
    let frames = frames::make_frames(campaign, &imported.points, &features, robot.dimension() == 2)?;

    // join: measurements meet joint values
    let joined = join::join(campaign, &imported, &frames, robot.as_ref())?;
    imported.document.messages.extend(features.messages.clone());
    imported.document.messages.extend(joined.messages.clone());

    // identify: observations become parameters
    let (calibration, validation) = campaign.selections()?;
    let sets_of = |table| -> Result<Sets> {
        let observations = Observation::from_table(robot.as_ref(), table)?;
        Ok(evaluate::split(&observations, &calibration, validation.as_ref()))
    };
    let sets = sets_of(&joined.observations[0].1)?;
    campaign.refuse_empty(&sets)?;
    let settings = campaign.settings();
    let before = identify::fit_frames(robot.as_ref(), &sets.calibration, &settings)?;
    let mut found = identify::identify(robot.as_ref(), &sets.calibration, &settings)?;
    for (name, table) in joined.observations.iter().skip(1) {
        let others = sets_of(table)?;
        found.warnings.extend(compare_logs(campaign, robot.as_ref(), &settings, &sets, (name, &others))?);
    }
    let parameters = parameters_document(robot.as_ref(), &settings, &before, &found, &imported.document.inputs());

    // evaluate: errors before and after
    let errors = evaluate::errors(robot.as_ref(), &sets, &before, &found.values);
    let accuracy = evaluate::evaluate(robot.as_ref(), &errors, &campaign.file.limits)?;

    // report and export, from the documents alone
    let summary = campaign.summary();
    let html = report::html(&report::Report {
        campaign: &summary,
        import: &imported.document,
        features: &features,
        frames: &frames,
        parameters: &parameters,
        accuracy: &accuracy,
        errors: &errors,
    })?;
    out.table("points", &mut imported.points)?;
    for (name, log) in &mut imported.logs {
        out.table(&Output::numbered("joints", name, campaign), log)?;
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
    for name in &campaign.file.controllers {
        if let Some(exporter) = export::by_name(name.get_ref()) {
            out.bytes(exporter.file_name(), exporter.write(&parameters)?);
        }
    }
    out.bytes("report.html", html.into_bytes());
    let messages = imported.document.messages.iter().chain(&parameters.messages).cloned().collect();
    Ok(Outcome { written: out.write()?, parameters, accuracy, messages })
}

/// Says so when another log explains the residuals of this one, or the other way round.
fn compare_logs(
    campaign: &Campaign,
    robot: &dyn Robot,
    settings: &Settings,
    sets: &Sets,
    (name, others): (&str, &Sets),
) -> Result<Vec<Message>> {
    let used = &campaign.file.logs[0].name;
    let mut messages = Vec::new();
    for (this, here, that, there) in [(used.as_str(), sets, name, others), (name, others, used.as_str(), sets)] {
        let found = identify::identify(robot, &here.calibration, settings)?;
        let compared = identify::compare_logs(robot, &found.values, &here.calibration, &there.calibration);
        let Some(compared) = compared.filter(|c| c.correlation > 0.3) else { continue };
        let other = identify::identify(robot, &there.calibration, settings)?;
        let what = format!(
            "with log `{this}`, residuals correlate with the difference of the two logs, r = {:.2}: their root mean square is \
             {:.3} mm, with log `{that}` {:.3} mm",
            compared.correlation, found.rms, other.rms
        );
        let hint = if this == used {
            format!("identify with log `{that}`: name it first")
        } else {
            format!("log `{that}` is the one to use, as this campaign does")
        };
        messages.push(Message::warning(what).hint(hint));
    }
    Ok(messages)
}

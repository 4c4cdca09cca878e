//! A campaign from its exports to its output folder.

use crate::run::controller_formats::ControllerFormats;
use crate::run::output::Output;
use crate::run::results;
use crate::run::summary::summary;
use crate::run::walk::{Inputs, Mode, Walk};
use crate::stages::calibrate::controller_files as written_values;
use crate::stages::calibrate::identification::{Identified, IdentifiedSolution};
use crate::stages::calibrate::loading_check::{file_inputs, loading_check};
use crate::stages::gather::{self, Gathered};
use crate::stages::join::Joined;
use crate::stages::kinds;
use crate::stages::table_file::TableFile;
use crate::stages::verify::earlier_parameters::robot_values;
use etalon_base::files;
use etalon_base::folder::Durability;
use etalon_base::message::{Problems, Result};
use etalon_campaign::Campaign;
use etalon_controllers::{Description, ExportInput, Exporter};
use etalon_documents::{
    CampaignSummary, ControllersDocument, FieldDocument, IdentifiedDocuments, Loading, Results, VerdictDocument,
    WrittenFile, to_json,
};
use etalon_report::Renderer;
use etalon_robots::{Effect, Parameter, Quantity, Robot, Role};

/// Files that a run writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// Documents, controller files and the reports.
    Reports,
    /// No reports: `etalon report` can write them. Nor tables of points, joint values and
    /// observations, which reports are not made of.
    Documents,
}

/// Results of a run, written to its output folder.
#[derive(Debug)]
pub struct Outcome {
    /// Results.
    pub results: Results,
    /// Solution of the identification, if the campaign identifies parameters.
    pub solution: Option<IdentifiedSolution>,
    /// The report, if requested.
    pub renderer: Option<Renderer>,
    /// Files written, in order.
    pub written: Vec<String>,
}

/// Results of a run before any of them is written, with the data of its other files.
pub struct Evaluated {
    /// Results.
    pub results: Results,
    /// Solution of the identification, if the campaign identifies parameters.
    pub solution: Option<IdentifiedSolution>,
    gathered: Gathered,
    joined: Option<Joined>,
    formats: ControllerFormats,
}

/// Runs a campaign from its exports to the report. Nothing is written until all results are
/// computed. If a stage fails, the warnings of previous stages come first, because they may explain
/// the failure.
pub fn run(campaign: &Campaign) -> Result<Outcome> {
    run_for(campaign, Wanted::Reports, Durability::Now)
}

/// [`run`] for all of its files or some, which are on the disk at once or later.
pub fn run_for(campaign: &Campaign, wanted: Wanted, durability: Durability) -> Result<Outcome> {
    let out = Output::new(campaign.written_output()?);
    write(campaign, wanted, durability, evaluate(campaign)?, out)
}

/// Runs a campaign without writing anything.
pub fn evaluate(campaign: &Campaign) -> Result<Evaluated> {
    let mut walk = Walk::sound(campaign, Mode::Run)?;
    walk.on(campaign).map_err(|problems| {
        let first = walk.inputs.gathered.document.messages.iter().filter(|m| !problems.0.contains(m));
        Problems(first.chain(&problems.0).cloned().collect())
    })?;
    let Walk { problems, inputs, robot, features, frames, joined, geometric, identified, tested, .. } = walk;
    let Inputs { mut gathered, mut formats, presentation, .. } = inputs;
    let (Some(features), Some(frames), Some(presentation)) = (features, frames, presentation) else {
        return Err(problems);
    };
    let robot = robot.as_deref();
    if robot.is_none() && campaign.file.states_robot() {
        return Err(problems);
    }
    gathered.document.sources.append(&mut formats.sources);
    // formats that omit parameters contain the values that are identified without them
    let mut summary = summary(campaign, presentation);
    summary.temperature.range_c = gather::temperature_range(&gathered.points);
    let again = |(found, robot)| identified_again(campaign, robot, found, &summary, &formats.all());
    let controllers = identified.as_ref().zip(robot).and_then(again);
    let (identified, solution) = identified.map(|found| (found.documents, found.solution)).unzip();
    let mut results = Results {
        campaign: summary,
        import: std::mem::take(&mut gathered.document),
        features,
        frames,
        identified: identified.map(with_hash).transpose()?,
        geometric,
        controllers,
        tested,
        verdict: VerdictDocument::default(),
    };
    results.campaign.controller_files = match robot.zip(solution.as_ref()) {
        Some((robot, solution)) => written(campaign, robot, solution, &results, &formats),
        None => Vec::new(),
    };
    Ok(Evaluated { results: results.judged(), solution, gathered, joined, formats })
}

/// Adds the hash of its parameters to the residual field.
fn with_hash(mut found: IdentifiedDocuments) -> Result<IdentifiedDocuments> {
    if let Some(field) = found.field {
        let parameters_sha256 = files::sha256(&to_json(&found.parameters)?);
        found.field = Some(FieldDocument { parameters_sha256, synthetic: found.parameters.synthetic.clone(), ..field });
    }
    Ok(found)
}

/// Contents of the files of these formats instead of the identified parameters: identified again
/// from the data of the campaign, for parameters that may be written.
pub(super) fn identified_again(
    campaign: &Campaign,
    robot: &dyn Robot,
    found: &Identified,
    summary: &CampaignSummary,
    formats: &[(&str, &dyn Exporter)],
) -> Option<ControllersDocument> {
    let input = export_input(campaign, robot, &found.documents, summary);
    let is_plausible = found.documents.parameters.is_plausible();
    is_plausible.then(|| written_values::identify_again(campaign, &input, robot, &found.solution, formats)).flatten()
}

/// Controller files that are not rejected.
fn written(
    campaign: &Campaign,
    robot: &dyn Robot,
    solution: &IdentifiedSolution,
    results: &Results,
    formats: &ControllerFormats,
) -> Vec<WrittenFile> {
    let Some(found) = results.plausible() else { return Vec::new() };
    let input = ExportInput {
        controllers: results.controllers.as_ref(),
        ..export_input(campaign, robot, found, &results.campaign)
    };
    let positions = solution.sets.calibration.iter().map(|o| o.joints.as_slice());
    let joints = positions.chain(solution.settings.conditions.iter().map(|c| c.joints.as_slice()));
    let effects = etalon_identify::effects(robot, joints);
    let file = |(name, exporter): (&str, &dyn Exporter)| {
        let statement = input.statement(exporter).ok().filter(|statement| statement.refusal(name).is_none())?;
        let parameters = statement.parameters.as_ref().unwrap_or(&found.parameters);
        let values = robot_values(robot, parameters, &[Role::Robot]).ok();
        Some(WrittenFile {
            format: name.to_owned(),
            file: exporter.file_name().to_owned(),
            is_for_controllers: exporter.about().is_for_controllers,
            sha256: None,
            omitted_effects: omitted_effects(robot, &effects, &input, exporter),
            inputs: values.as_ref().map_or_else(Vec::new, |values| file_inputs(robot, values)),
            check: values.and_then(|values| loading_check(robot, solution, &values)),
        })
    };
    formats.all().into_iter().filter_map(file).collect()
}

/// Effects of which a format contains no parameter, even if the robot has no such parameters;
/// `effects` contains the effect of each parameter.
fn omitted_effects(
    robot: &dyn Robot,
    effects: &[Option<Effect>],
    input: &ExportInput,
    exporter: &dyn Exporter,
) -> Vec<etalon_documents::Effect> {
    let described = |effect: Effect| {
        robot.parameters().iter().zip(effects).filter(move |(_, own)| **own == Some(effect)).map(|(p, _)| p)
    };
    let holds = |effect: Effect| match described(effect).next() {
        Some(_) => described(effect).any(|p| exporter.holds(p, input)),
        None => {
            let other = Parameter { effect, ..Parameter::new("", Quantity::Ratio, Role::Robot, 0.0) };
            exporter.holds(&other, input)
        }
    };
    Effect::ALL.into_iter().filter(|effect| !holds(*effect)).map(Into::into).collect()
}

/// Writes what [`evaluate`] computed to the output folder of the campaign.
///
/// # Errors
/// Fails like [`run`].
pub fn write_evaluated(campaign: &Campaign, found: Evaluated) -> Result<Outcome> {
    write(campaign, Wanted::Reports, Durability::Now, found, Output::new(campaign.written_output()?))
}

/// Writes every document, the report and the files for controllers.
fn write(
    campaign: &Campaign,
    wanted: Wanted,
    durability: Durability,
    found: Evaluated,
    mut out: Output,
) -> Result<Outcome> {
    let Evaluated { mut results, solution, mut gathered, joined, formats } = found;
    let exported = controller_files(campaign, &results, gathered.observations.as_ref(), &formats)?;
    for written in &mut results.campaign.controller_files {
        let file = exported.iter().find(|(name, _)| *name == written.file);
        written.sha256 = file.map(|(_, bytes)| files::sha256(bytes));
    }
    let renderer = (wanted == Wanted::Reports).then(|| Renderer::campaign(&results)).transpose()?;
    if wanted == Wanted::Reports {
        out.gathered(campaign, &mut gathered)?;
        out.observations(campaign, joined)?;
    }
    results::write(&results, &mut out)?;
    exported.into_iter().for_each(|(name, bytes)| out.bytes(&name, bytes));
    let renderer = renderer.map(|renderer| {
        renderer.with_certificate(etalon_controllers::CERTIFICATE, out.file(etalon_controllers::CERTIFICATE))
    });
    if let Some(renderer) = &renderer {
        out.reports(renderer.files()?);
    }
    let written = out.write(campaign, &results.import.sources, durability)?;
    Ok(Outcome { results, solution, renderer, written })
}

/// Names and bytes of the controller files that are not rejected.
fn controller_files(
    campaign: &Campaign,
    results: &Results,
    observations: Option<&TableFile>,
    formats: &ControllerFormats,
) -> Result<Vec<(String, Vec<u8>)>> {
    let Some(found) = results.plausible() else { return Ok(Vec::new()) };
    let targets = |table: &TableFile| kinds::targets(&table.table, &campaign.robot.branches());
    let targets = observations.map(targets).transpose()?;
    let robot = campaign.build_robot_with(&targets.unwrap_or_default())?;
    let sha256 = files::sha256(&to_json(&found.parameters)?);
    let input = ExportInput {
        controllers: results.controllers.as_ref(),
        parameters_sha256: Some(&sha256),
        ..export_input(campaign, robot.as_ref(), found, &results.campaign)
    };
    let withheld = results.verdict.loading.as_ref().and_then(Loading::reason);
    let mut all = Vec::new();
    for (name, exporter) in formats.all() {
        // rejected files are among the messages
        let Ok(statement) = input.statement(exporter) else { continue };
        let statement = statement.withheld(withheld.clone());
        if statement.refusal(name).is_none() {
            input.check()?;
            all.push((exporter.file_name().to_owned(), exporter.write_stated(&input, &statement)?));
        }
    }
    Ok(all)
}

/// Input of controller files before parameters are identified again for them.
fn export_input<'a>(
    campaign: &'a Campaign,
    robot: &'a dyn Robot,
    found: &'a IdentifiedDocuments,
    summary: &'a CampaignSummary,
) -> ExportInput<'a> {
    ExportInput {
        summary: Some(summary),
        name: summary.robot.as_deref(),
        robot: Some(robot),
        description: campaign.robot.description().map(|(file, text)| Description { file, text }),
        accuracy: Some(&found.accuracy),
        errors: Some(&found.errors),
        ..ExportInput::parameters(&found.parameters)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::files::{self, record_opened};
    use std::path::{Path, PathBuf};

    /// A copy of a sample in a folder of its own, with more in its `campaign.toml`, and other
    /// files.
    fn copy(sample: &str, more: &str, others: &[(&str, &str)]) -> tempfile::TempDir {
        fn copy_all(from: &Path, to: &Path) {
            for entry in std::fs::read_dir(from).unwrap().flatten() {
                let (path, to) = (entry.path(), to.join(entry.file_name()));
                match path.is_dir() {
                    true if path.ends_with("out") => {}
                    true => copy_all(&path, &to),
                    false => files::write(&to, &std::fs::read(&path).unwrap()).unwrap(),
                }
            }
        }
        let folder = tempfile::tempdir().unwrap();
        copy_all(
            &PathBuf::from(std::env::var_os("CARGO_MANIFEST_DIR").unwrap()).join("samples").join(sample),
            folder.path(),
        );
        let text = std::fs::read_to_string(folder.path().join("campaign.toml")).unwrap();
        std::fs::write(folder.path().join("campaign.toml"), text + more).unwrap();
        for (name, text) in others {
            std::fs::write(folder.path().join(name), text).unwrap();
        }
        folder
    }

    #[test]
    fn exports_that_share_a_file_open_it_once() {
        let again = "\n[[export]]\nfile = \"exports/world.txt\"\nformat = \"polyworks\"\nunit = \"mm\"\n";
        let folder = copy("prexyt-cmm", again, &[]);
        let campaign = Campaign::read(folder.path()).unwrap();
        let ((gathered, _), opened) = record_opened(|| crate::stages::gather::recover(&campaign));
        let opened = opened.into_iter().filter(|path| path.ends_with("exports/world.txt")).count();
        let listed = gathered.document.sources.iter().filter(|source| source.file == "exports/world.txt").count();
        assert_eq!((opened, listed), (1, 2));
    }

    #[test]
    fn a_run_opens_every_input_once() {
        let stream = "\n[[stream]]\nname = \"s\"\nfile = \"s.csv\"\ncommanded = \"s_poses.csv\"\n\
            [compliance]\nfile = \"load.csv\"\n[report]\nlogo = \"logo.svg\"\n";
        let moved = |i: i32| if (40..60).contains(&i) { i - 40 } else { 20 * i32::from(i >= 60) };
        let recording: String = (0..100).map(|i| format!("{},{},0,0\n", f64::from(i) / 20.0, moved(i))).collect();
        let recording = format!("time_s,x_mm,y_mm,z_mm\n{recording}");
        let load = "direction,cycle,force_n,x_mm,y_mm,z_mm\n+x,1,0,0,0,0\n+x,1,10,0.1,0,0\n+x,1,20,0.2,0,0\n";
        let others = [
            ("s.csv", recording.as_str()),
            ("s_poses.csv", "pose,x_mm,y_mm,z_mm\n1,0,0,0\n2,20,0,0\n"),
            ("load.csv", load),
            (
                "logo.svg",
                "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1 1\"><rect width=\"1\" height=\"1\"/></svg>",
            ),
        ];
        for (sample, more, others) in
            [("prexyt-geometric", stream, &others[..]), ("prexyt-repeatability", "", &[]), ("pose-test", "", &[])]
        {
            let folder = copy(sample, more, others);
            let (campaign, mut opened) = record_opened(|| {
                let campaign = Campaign::read(folder.path()).unwrap();
                run(&campaign).unwrap();
                campaign
            });
            let file = &campaign.file;
            let mut inputs: Vec<PathBuf> = file
                .inputs()
                .chain([&file.robot])
                .chain(&file.report.logo)
                .map(|f| campaign.resolve(f).unwrap())
                .collect();
            inputs.push(folder.path().join("campaign.toml"));
            inputs.sort();
            opened.sort();
            assert_eq!(opened, inputs, "{sample}");
        }
    }
}

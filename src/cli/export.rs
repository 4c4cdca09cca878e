//! Command `etalon export`.

use super::{Output, Verdict, lines, progress};
use crate::run::controller_formats::template_format;
use crate::run::documents::{Documents, read_parameters_and_run};
use crate::run::validation::{Recommended, identify_recommended};
use crate::stages::verify::earlier_parameters::{check_described, check_geometry, other_nominal, unknown_geometry};
use crate::tasks::validity;
use etalon_base::files;
use etalon_base::message::{Message, Place, Problems};
use etalon_base::{error, phrase, warning};
use etalon_campaign::{Campaign, RobotFile, read_robot};
use etalon_controllers::{Description, ExportInput, Exporter, Statement, TemplateFormat};
use etalon_documents::{
    AccuracyDocument, CampaignSummary, ControllersDocument, Loading, ParametersDocument, PointError, VerdictDocument,
    WrittenController, WrittenDocument, to_json,
};
use etalon_robots::Robot;
use std::path::{Path, PathBuf};

/// Write identified parameters as a file for a controller or another program.
#[derive(Debug, clap::Args)]
pub struct ExportCommand {
    /// File parameters.json of a run; with `--parameters recommended` the folder of the campaign,
    /// or its campaign.toml.
    #[arg(value_name = "PARAMETERS")]
    source: PathBuf,
    /// Parameters to write: all of the file, or the parameters recommended for a campaign (`etalon
    /// recommend`), which are identified again with all others at nominal.
    #[arg(long, value_name = "WHICH", value_enum, default_value = "identified")]
    parameters: Which,
    /// Name of a format.
    #[arg(long, value_name = "NAME", help = format_help())]
    format: Vec<String>,
    /// Template of a format of your own, NAME.j2, which writes NAME; may be repeated.
    #[arg(long, value_name = "FILE")]
    template: Vec<PathBuf>,
    /// Robot file, for formats that need the robot.
    #[arg(long, value_name = "FILE")]
    robot: Option<PathBuf>,
    /// Folder to write to; by default the folder of parameters.json.
    #[arg(long, value_name = "FOLDER", required_if_eq("parameters", "recommended"))]
    to: Option<PathBuf>,
    /// Hash that the robot shows (`calib_...`), for formats that contain it (universal-robots); by
    /// default etalon's hash.
    #[arg(long, value_name = "HASH", value_parser = controller_hash)]
    controller_hash: Option<String>,
    /// Write parameters that failed their checks, and files that are worse than nominal; their
    /// headers say so.
    #[arg(long)]
    force: bool,
    /// Print the names of the files written, and the errors with them, as JSON.
    #[arg(long)]
    json: bool,
}

/// Help of `--format`, with the names of all formats.
fn format_help() -> String {
    let names: Vec<&str> = etalon_controllers::names().collect();
    format!("Format: {}; json, csv and c-header by default; may be repeated", names.join(", "))
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Which {
    Identified,
    Recommended,
}

impl ExportCommand {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        let folder = self.source.parent().unwrap_or(Path::new("")).to_owned();
        let to = self.to.unwrap_or(folder);
        // before the parameters are read, so that a concurrent run is noticed
        let run = Documents::open(&to).ok();
        let own = self.template.iter().map(|path| template(path, run.as_ref(), &to)).collect::<Result<Vec<_>, _>>()?;
        let exporters = exporters(&self.format, &own)?;
        let with_errors = exporters.iter().any(|exporter| exporter.about().shows_errors);
        let exported = match self.parameters {
            Which::Identified => Exported::read(&self.source, self.robot.as_deref(), with_errors, out)?,
            Which::Recommended => Exported::recommended(&self.source, &exporters, out)?,
        };
        let hash = self.controller_hash.as_deref();
        if hash.is_some() && !exporters.iter().any(|exporter| exporter.about().states_controller_hash) {
            let formats = etalon_controllers::with_controller_hash();
            return Err(Problems::from(error!("hash-of-other-format", formats)).into());
        }
        let given = ExportInput { controller_hash: hash, ..exported.input(self.force) };
        given.check()?;
        let withheld = exported.loading.as_ref().and_then(Loading::reason);
        let of_format = |e: &&dyn Exporter| {
            let statement = given.statement(*e)?.withheld(withheld.clone());
            let file = (e.file_name().to_owned(), e.write_stated(&given, &statement)?);
            let near = statement.warning(&[e.name()]);
            let Statement { left_out, errors, .. } = statement;
            let format = e.name().to_owned();
            let mut written = WrittenController { format, left_out, errors, messages: Vec::new() };
            written.messages = e.cautions(&given).into_iter().chain(not_measured(&written)).chain(near).collect();
            Ok((file, written))
        };
        let written = exporters.iter().map(of_format).collect::<Result<Vec<_>, Problems>>()?;
        let (files, controllers): (Vec<_>, Vec<_>) = written.into_iter().unzip();
        let written = match run {
            Some(run) => run.write(files)?,
            None => beside_no_run(&to, &files)?,
        };
        out.remark(withheld.map(|reason| warning!("nothing-to-load-by-run", reason)).as_slice());
        out.remark(&controllers.iter().flat_map(|file| &file.messages).cloned().collect::<Vec<_>>());
        let loading = exported.loading.as_ref().map(|loading| loading.answer);
        let data = match self.json {
            true => to_json(&WrittenDocument { controllers, loading, ..WrittenDocument::new(written) })?,
            false => lines(&written).into_bytes(),
        };
        Ok(out.print_after_writing(data, Verdict::Met))
    }
}

/// The named formats and the user's own; without any, the usual formats.
fn exporters<'a>(names: &[String], own: &'a [TemplateFormat]) -> Result<Vec<&'a dyn Exporter>, Problems> {
    if names.is_empty() && own.is_empty() {
        return Ok(etalon_controllers::usual().map(|exporter| exporter as &dyn Exporter).collect());
    }
    let named = names.iter().map(|name| etalon_controllers::by_name(name).map(|exporter| exporter as &dyn Exporter));
    Ok(named.chain(own.iter().map(|format| Ok(format as &dyn Exporter))).collect::<Result<_, Message>>()?)
}

/// Reads a template whose file replaces no document of a run, and no file in the folder of a run.
fn template(path: &Path, run: Option<&Documents>, to: &Path) -> Result<TemplateFormat, Problems> {
    let named = path.display().to_string();
    let (format, _) = template_format(path, &named, Place::file(&*named))?;
    let file = format.file_name();
    let written = to.join(file);
    let taken = match run {
        Some(run) => written.exists() && !run.manifest.files.contains_key(file),
        None => written.exists(),
    };
    match taken {
        true => Err(error!("file-exists", file = written.display().to_string()).into()),
        false => Ok(format),
    }
}

/// Warning about a file that was made from the covariance only.
fn not_measured(file: &WrittenController) -> Option<Message> {
    let message = || warning!("controller-error-not-measured", format = file.format, parameters = file.left_out);
    (file.errors.is_none() && !file.left_out.is_empty()).then(message)
}

/// Parses the hash of a calibration as shown by a robot of Universal Robots.
fn controller_hash(text: &str) -> Result<String, String> {
    let digits = text.strip_prefix("calib_").unwrap_or_default();
    let is_hash = !digits.is_empty() && digits.chars().all(|c| c.is_ascii_alphanumeric());
    if is_hash { Ok(text.to_owned()) } else { Err("expected `calib_` and digits".to_owned()) }
}

/// Writes files into a folder that contained no run when the parameters were read.
fn beside_no_run(to: &Path, files: &[(String, Vec<u8>)]) -> Result<Vec<String>, Problems> {
    let no_run = || match Documents::open(to) {
        Err(_) => Ok(()),
        Ok(_) => Err(Problems::from(error!("run-while-exporting", folder = to.display().to_string()))),
    };
    no_run()?;
    let written = files::write_all(to, files)?;
    no_run().map(|()| written)
}

/// Source data of a controller file.
pub(super) struct Exported {
    pub parameters: ParametersDocument,
    file: Option<RobotFile>,
    robot: Option<Box<dyn Robot>>,
    summary: Option<CampaignSummary>,
    accuracy: Option<AccuracyDocument>,
    errors: Option<Vec<PointError>>,
    controllers: Option<ControllersDocument>,
    /// Answer of the run of these parameters.
    loading: Option<Loading>,
}

impl Exported {
    /// Reads parameters, their campaign, robot.toml if named, and the errors of the points if asked
    /// for.
    pub fn read(parameters: &Path, robot: Option<&Path>, with_errors: bool, out: &Output) -> Result<Self, Problems> {
        let (document, run) = read_parameters_and_run(parameters)?;
        let file = robot.map(read_robot).transpose()?;
        if let Some(robot) = robot {
            out.remark(unknown_geometry(&document, &files::sha256(&files::read(robot)?)).as_slice());
        }
        let mut exported = Self::new(document, file, None)?;
        if let Some(run) = run {
            exported.summary = run.optional("campaign.json")?;
            if parameters.ends_with("parameters.json") {
                exported.accuracy = run.optional("accuracy.json")?;
                exported.controllers = run.optional("controllers.json")?;
                let verdict: Option<VerdictDocument> = run.optional("verdict.json")?;
                exported.loading = verdict.and_then(|verdict| verdict.loading);
                let accuracy = exported.accuracy.as_ref().filter(|_| with_errors);
                exported.errors = accuracy.map(|accuracy| run.errors(accuracy)).transpose()?;
            }
        }
        out.remark(validity::expired(&exported.parameters, exported.summary.as_ref()).as_slice());
        Ok(exported)
    }

    /// Identifies the recommended parameters of a campaign, for these formats.
    fn recommended(campaign: &Path, exporters: &[&dyn Exporter], out: &Output) -> Result<Self, Problems> {
        let campaign = Campaign::read(campaign)?;
        let formats: Vec<(&str, &dyn Exporter)> = exporters.iter().map(|&e| (e.name(), e)).collect();
        let Recommended { found, controllers, summary, messages } =
            identify_recommended(&campaign, &formats, &mut progress)?;
        out.remark(&messages);
        let exported = Self::new(found.parameters, Some(campaign.robot), Some(summary))?;
        Ok(Self { accuracy: Some(found.accuracy), errors: Some(found.errors), controllers, ..exported })
    }

    fn new(
        parameters: ParametersDocument,
        file: Option<RobotFile>,
        summary: Option<CampaignSummary>,
    ) -> Result<Self, Problems> {
        // the model needs a target; no format contains its position
        let robot = file.as_ref().map(|file| file.build(&file.targets_or("tool"))).transpose()?;
        if let Some(robot) = &robot {
            check_described(robot.as_ref(), &parameters)?;
        }
        if let Some(stale) = robot.as_deref().and_then(|robot| other_nominal(robot, &parameters)) {
            let hint = phrase!("robot-file-of-run");
            return Err(stale.hint(hint).into());
        }
        if let Some(robot) = &robot {
            check_geometry(robot.as_ref(), &parameters)?;
        }
        Ok(Self { parameters, file, robot, summary, accuracy: None, errors: None, controllers: None, loading: None })
    }

    pub fn input(&self, force: bool) -> ExportInput<'_> {
        let description = self.file.as_ref().and_then(|robot| robot.description());
        ExportInput {
            summary: self.summary.as_ref(),
            name: self.file.as_ref().and_then(|robot| robot.name.as_deref()),
            robot: self.robot.as_deref(),
            description: description.map(|(file, text)| Description { file, text }),
            accuracy: self.accuracy.as_ref(),
            errors: self.errors.as_deref(),
            controllers: self.controllers.as_ref(),
            force,
            ..ExportInput::parameters(&self.parameters)
        }
    }
}

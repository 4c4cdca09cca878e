//! The output folder of a run for readers: every document is the one that the run wrote, or the
//! folder is rejected.

use crate::stages::evaluate::error_table;
use etalon_base::catalogue::IntoArgument;
use etalon_base::error;
use etalon_base::files;
use etalon_base::folder::{Durability, FolderLock};
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_campaign::Campaign;
use etalon_documents::to_json;
use etalon_documents::{
    AccuracyDocument, CampaignSummary, CellDocument, ControllerFiles, ControllersDocument, FieldDocument,
    ManifestDocument, ParametersDocument, PointError, WrittenFile,
};
use etalon_formats::parquet;
use serde::de::DeserializeOwned;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

pub(super) const PARAMETERS: &str = "parameters.json";

/// An output folder and its manifest.
#[derive(Debug)]
pub struct Documents {
    folder: PathBuf,
    /// The files of the run.
    pub manifest: ManifestDocument,
}

/// Files that a run writes except controller files, by their names up to the first `.` or `-`.
const OF_RUN: [&str; 19] = [
    "accuracy",
    "campaign",
    "controllers",
    "etalon_field",
    "features",
    "field",
    "frames",
    "geometric",
    "import",
    "iso9283",
    "joints",
    "manifest",
    "observations",
    "parameters",
    "points",
    "recommendation",
    "report",
    "residuals",
    "verdict",
];

/// `true` if a run may write a file of this name.
pub fn is_file_of_run(name: &str) -> bool {
    let stem = name.split(['.', '-']).next().unwrap_or_default();
    OF_RUN.contains(&stem) || etalon_controllers::file_names().any(|file| file == name)
}

/// The output folder that is named: itself, or by its campaign.
///
/// # Errors
/// Fails if the campaign cannot be read.
pub fn output_folder(named: &Path) -> Result<PathBuf> {
    match named.join("campaign.toml").is_file() || named.is_file() {
        true => {
            let (campaign, problems) = Campaign::recover(named)?;
            campaign.ok_or(problems)?.output()
        }
        false => Ok(named.to_owned()),
    }
}

impl Documents {
    /// The output folder of a run.
    ///
    /// # Errors
    /// Fails if the folder has no manifest.
    pub fn open(folder: &Path) -> Result<Self> {
        let path = folder.join(ManifestDocument::NAME);
        if !path.is_file() {
            return Err(error!("not-an-output-folder", folder = folder.display().to_string()).into());
        }
        let manifest = parse(&path, &files::read(&path)?, "manifest")?;
        Ok(Self { folder: folder.to_owned(), manifest })
    }

    /// The path of a file.
    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }

    /// Time at which the folder was written.
    pub fn written(&self) -> std::io::Result<SystemTime> {
        std::fs::metadata(self.path(ManifestDocument::NAME))?.modified()
    }

    /// A file as the run wrote it.
    ///
    /// # Errors
    /// Fails if the run wrote no document of this name, or if the file has changed since the run.
    pub fn bytes(&self, name: &str) -> Result<Vec<u8>> {
        let path = self.path(name);
        let Some(sha256) = self.manifest.files.get(name) else {
            return Err(error!("file-not-of-run", file = path.display().to_string()).into());
        };
        let read = files::read(&path);
        if !read.as_ref().is_ok_and(|bytes| files::sha256(bytes) == *sha256) {
            self.unchanged()?;
        }
        let bytes = read?;
        if files::sha256(&bytes) != *sha256 {
            return Err(error!("file-changed-since-run", file = path.display().to_string(), sha256).into());
        }
        Ok(bytes)
    }

    /// A document of the run.
    pub fn json<T: DeserializeOwned>(&self, name: &str) -> Result<T> {
        parse(&self.path(name), &self.bytes(name)?, name.trim_end_matches(".json"))
    }

    /// A document that not every run writes.
    pub fn optional<T: DeserializeOwned>(&self, name: &str) -> Result<Option<T>> {
        self.manifest.files.contains_key(name).then(|| self.json(name)).transpose()
    }

    /// The identified parameters, of a run that identifies any.
    pub fn parameters(&self) -> Result<Option<ParametersDocument>> {
        let named = self.manifest.files.contains_key(PARAMETERS);
        named.then(|| checked(&self.path(PARAMETERS), &self.bytes(PARAMETERS)?)).transpose()
    }

    /// Identified parameters with the values of a controller file of the run.
    ///
    /// # Errors
    /// Fails if the run wrote no such file.
    pub fn parameters_in_file(&self, identified: &ParametersDocument, file: &Path) -> Result<ParametersDocument> {
        let campaign: CampaignSummary = self.json("campaign.json")?;
        let written = self.controller_file(&campaign, file)?;
        let controllers: Option<ControllersDocument> = self.optional("controllers.json")?;
        let of_format = |values: &ControllerFiles| values.formats.contains(&written.format);
        let values = controllers.and_then(|document| document.files.into_iter().find(of_format));
        Ok(values.map_or_else(|| identified.clone(), |values| values.applied_to(identified)))
    }

    /// Controller file of the run with the contents of `file`, whatever its name. A name without a
    /// file in reach is the name in the output folder.
    fn controller_file<'c>(&self, campaign: &'c CampaignSummary, file: &Path) -> Result<&'c WrittenFile> {
        let sha256 = file.exists().then(|| files::read(file)).transpose()?.map(|bytes| files::sha256(&bytes));
        let is_meant = |written: &&WrittenFile| match &sha256 {
            Some(sha256) => self.manifest.files.get(&written.file) == Some(sha256),
            None => file.as_os_str() == written.file.as_str(),
        };
        let written = campaign.controller_files.iter().find(is_meant);
        Ok(written.ok_or_else(|| error!("file-not-of-run", file = file.display().to_string()))?)
    }

    /// Errors of the measured points of a run with this accuracy.
    pub fn errors(&self, accuracy: &AccuracyDocument) -> Result<Vec<PointError>> {
        let name = "residuals.parquet";
        let rows = accuracy.sets.iter().map(|set| set.count).fold(0, usize::saturating_add);
        let residuals = parquet::from_parquet(self.bytes(name)?, rows);
        let place = Place::file(self.path(name).display().to_string());
        residuals.and_then(|table| error_table::from_table(&table)).map_err(|more| more.at(&place))
    }

    /// Writes files into the folder of the run, where they may replace others; returns their paths.
    ///
    /// # Errors
    /// Fails if another run has written the folder since: the files were made from the earlier run.
    pub fn write(self, added: Vec<(String, Vec<u8>)>) -> Result<Vec<String>> {
        let held = FolderLock::take(&self.folder)?;
        self.unchanged()?;
        let names = added.iter().map(|(name, _)| name.as_str());
        refuse_foreign(&self.folder, names.filter(|name| !self.manifest.files.contains_key(*name)))?;
        let paths = added.iter().map(|(name, _)| self.path(name).display().to_string()).collect();
        let mut listed = self.manifest.files;
        listed.extend(added.iter().map(|(name, bytes)| (name.clone(), files::sha256(bytes))));
        let files = with_manifest(listed, added)?;
        held.replace(&files, |name| !holds(&files, name), || Ok(()), Durability::Now)?;
        Ok(paths)
    }

    /// An error if the folder is of another run by now.
    fn unchanged(&self) -> Result<()> {
        match Self::open(&self.folder) {
            Ok(now) if now.manifest == self.manifest => Ok(()),
            _ => Err(error!("folder-replaced", folder = self.folder.display().to_string()).into()),
        }
    }
}

/// Files of an output folder, by name.
type Files = Vec<(String, Vec<u8>)>;

/// These files and the manifest, with the hash of each file of the folder in `listed`.
pub(super) fn with_manifest(listed: BTreeMap<String, String>, mut files: Files) -> Result<Files> {
    files.push((ManifestDocument::NAME.to_owned(), to_json(&ManifestDocument::new(listed))?));
    Ok(files)
}

/// Reports the files in a folder whose names are to be written although no run wrote them.
pub(super) fn refuse_foreign<'a>(folder: &Path, names: impl Iterator<Item = &'a str>) -> Result<()> {
    let foreign = names.map(|name| folder.join(name)).filter(|path| path.symlink_metadata().is_ok());
    let problems = foreign.map(|path| error!("foreign-file", file = path.display().to_string()));
    Problems(problems.collect()).check().map(drop)
}

/// `true` if a file of this name is among `files`.
pub(super) fn holds(files: &[(String, Vec<u8>)], name: &str) -> bool {
    files.iter().any(|(file, _)| file == name)
}

/// Reads `parameters.json`, wherever it is: in the output folder of a run, as that run wrote it.
pub fn read_parameters(path: &Path) -> Result<ParametersDocument> {
    Ok(read_parameters_and_run(path)?.0)
}

/// Reads the text of a `parameters.json`; `name` stands for its file.
pub fn parse_parameters(name: &str, text: &str) -> Result<ParametersDocument> {
    checked(Path::new(name), text.as_bytes())
}

/// Reads `parameters.json` with the documents of its folder, all of one run.
pub fn read_parameters_and_run(path: &Path) -> Result<(ParametersDocument, Option<Documents>)> {
    let run = Documents::open(path.parent().unwrap_or(Path::new(""))).ok();
    let bytes = match &run {
        Some(run) if path.ends_with(PARAMETERS) => run.bytes(PARAMETERS)?,
        _ => files::read(path)?,
    };
    Ok((checked(path, &bytes)?, run))
}

/// Reads `parameters.json`; with a controller file of its run, the parameters with its values.
///
/// # Errors
/// Fails if the parameters are not in the output folder of a run that wrote this file.
pub fn read_loaded_parameters(path: &Path, file: Option<&Path>) -> Result<ParametersDocument> {
    let (document, run) = read_parameters_and_run(path)?;
    match (file, run) {
        (None, _) => Ok(document),
        (Some(file), Some(run)) => run.parameters_in_file(&document, file),
        (Some(_), None) => {
            let folder = path.parent().unwrap_or(Path::new("")).display().to_string();
            Err(error!("not-an-output-folder", folder).into())
        }
    }
}

/// Reads the answer of `etalon cell --json`.
pub fn read_cell(path: &Path) -> Result<CellDocument> {
    parse(path, &files::read(path)?, "cell")
}

/// Reads a `field.json` that belongs to the parameters in the file `parameters`.
pub fn read_field(path: &Path, parameters: &Path) -> Result<FieldDocument> {
    parse_field(path, &files::read(path)?, parameters, &files::sha256(&files::read(parameters)?))
}

/// Reads the bytes of a `field.json` that belongs to the parameters with this hash.
pub fn parse_field(path: &Path, bytes: &[u8], parameters: &Path, sha256: &str) -> Result<FieldDocument> {
    let field: FieldDocument = parse(path, bytes, "field")?;
    if field.parameters_sha256 != sha256 {
        let (field, parameters) = (path.display().to_string(), parameters.display().to_string());
        return Err(error!("field-of-other-parameters", field, parameters).into());
    }
    Ok(field)
}

/// Parameters whose parts belong together.
fn checked(path: &Path, bytes: &[u8]) -> Result<ParametersDocument> {
    let document: ParametersDocument = parse(path, bytes, "parameters")?;
    document.check().map_err(|reason| unreadable(path, &reason))?;
    Ok(document)
}

/// Returns a document of this name and of the version that this program writes; `campaign` gives
/// none.
fn parse<T: DeserializeOwned>(path: &Path, bytes: &[u8], name: &str) -> Result<T> {
    let value: serde_json::Value = serde_json::from_slice(bytes).map_err(|e| unreadable(path, &e.to_string()))?;
    let schema = value.get("schema").and_then(|schema| schema.as_str()).unwrap_or("none");
    let wanted = if name == "parameters" { ParametersDocument::SCHEMA.to_owned() } else { format!("etalon/{name}/1") };
    if name != "campaign" && schema != wanted {
        return Err(error!("document-schema-other", file = path.display().to_string(), schema, wanted).into());
    }
    Ok(serde_json::from_value(value).map_err(|e| unreadable(path, &e.to_string()))?)
}

fn unreadable(path: &Path, reason: &impl IntoArgument) -> Message {
    error!("document-unreadable", file = path.display().to_string(), reason)
}

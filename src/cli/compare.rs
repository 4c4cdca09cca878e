//! `etalon compare`

use super::report::Dressed;
use super::{Verdict, answer, remark};
use crate::base::files;
use crate::base::message::{Message, Problems, Result};
use crate::campaign::Campaign;
use crate::compare::{Compared, compare};
use crate::report::{self, Faces};
use crate::run::output;
use serde::de::DeserializeOwned;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Compare campaigns of one robot: what changed, and what is chance
///
/// Each folder is that of a campaign, or the output folder of `etalon run`; the oldest first. Parameters, errors, AP, RP and
/// mean positions are compared with the first campaign and with the previous one.
#[derive(Debug, clap::Args)]
pub struct Compare {
    /// Folders of campaigns, or their output folders, in the order of time
    #[arg(required = true, num_args = 2..)]
    folders: Vec<PathBuf>,
    /// Write a report, by the ending of its name: .html, .pdf or .xlsx; may be repeated
    #[arg(long, value_name = "FILE")]
    report: Vec<PathBuf>,
    #[command(flatten)]
    dressed: Dressed,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

impl Compare {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        let mut problems = Problems::default();
        let mut kinds = Vec::new();
        for path in &self.report {
            match kind(path) {
                Ok(kind) => kinds.push((path, kind)),
                Err(more) => problems.0.extend(more.0),
            }
        }
        let (mut all, mut places) = (Vec::new(), BTreeSet::new());
        for folder in &self.folders {
            match read(folder) {
                // under another name it is the same folder
                Ok((place, read)) => match places.insert(place) {
                    true => all.push(read),
                    false => problems.0.push(Message::error(format!("`{}` is named twice", read.folder))),
                },
                Err(more) => problems.0.extend(more.0),
            }
        }
        problems.check()?;
        let document = compare(&all)?;
        remark(&document.messages);
        let campaign = all.into_iter().next().map(|first| first.campaign.report).unwrap_or_default();
        let faces = Faces::comparison(&document, self.dressed.over(campaign)?)?;
        for (path, kind) in kinds {
            files::write(path, &faces.file(&kind)?)?;
        }
        answer(&faces, self.json.then(|| output::to_json(&document)).transpose()?)
    }
}

/// The kind of report that the ending of its file names.
fn kind(path: &Path) -> Result<String> {
    let ending = path.extension().and_then(|e| e.to_str()).map(str::to_lowercase).unwrap_or_default();
    if report::kinds().any(|kind| kind == ending) {
        return Ok(ending);
    }
    let kinds: Vec<String> = report::kinds().map(|kind| format!(".{kind}")).collect();
    let message = Message::error(format!("`{}` does not end like a report", path.display()));
    Err(message.expected(format!("a file that ends in {}", kinds.join(", "))).into())
}

/// A campaign's output folder and its documents.
fn read(named: &Path) -> Result<(PathBuf, Compared)> {
    let folder = match named.join("campaign.toml").is_file() || named.is_file() {
        true => {
            let (campaign, problems) = Campaign::recover(named)?;
            campaign.ok_or(problems)?.output()?
        }
        false => named.to_owned(),
    };
    let place = folder.canonicalize().unwrap_or_else(|_| folder.clone());
    let mut folder = Folder { named: named.display().to_string(), folder, inputs: BTreeMap::new() };
    let campaign = folder.document("campaign.json", None)?.ok_or_else(|| folder.missing("campaign.json"))?;
    let parameters = folder.document("parameters.json", Some("etalon/parameters/1"))?;
    let accuracy = folder.document("accuracy.json", Some("etalon/accuracy/1"))?;
    let identified = match (parameters, accuracy) {
        (Some(parameters), Some(accuracy)) => Some((parameters, accuracy)),
        (None, None) => None,
        (Some(_), None) => return Err(folder.missing("accuracy.json")),
        (None, Some(_)) => return Err(folder.missing("parameters.json")),
    };
    let iso9283 = folder.document("iso9283.json", Some("etalon/iso9283/1"))?;
    let streams = folder.document("iso9283-streams.json", Some("etalon/iso9283-streams/1"))?;
    Ok((place, Compared { folder: folder.named, campaign, identified, iso9283, streams, inputs: folder.inputs }))
}

struct Folder {
    named: String,
    folder: PathBuf,
    inputs: BTreeMap<String, String>,
}

impl Folder {
    fn missing(&self, name: &str) -> Problems {
        let message = Message::error(format!("there is no file `{}`", self.folder.join(name).display()));
        message.hint("name a folder that `etalon run` wrote, or a campaign that was run").into()
    }

    /// A document, if it is there, of the version that this program writes.
    fn document<T: DeserializeOwned>(&mut self, name: &str, schema: Option<&str>) -> Result<Option<T>> {
        let path = self.folder.join(name);
        if !path.is_file() {
            return Ok(None);
        }
        let bytes = files::read(&path)?;
        let wrong = |what: String| {
            let message =
                Message::error(format!("`{}` is not the document that this version writes: {what}", path.display()));
            message.hint("run the campaign again with this version: `etalon run CAMPAIGN`")
        };
        let value: serde_json::Value = serde_json::from_slice(&bytes).map_err(|e| wrong(e.to_string()))?;
        let found = value.get("schema").and_then(|s| s.as_str()).unwrap_or("none");
        if let Some(schema) = schema.filter(|s| *s != found) {
            return Err(wrong(format!("its schema is {found:?}")).expected(format!("{schema:?}")).into());
        }
        let document = serde_json::from_value(value).map_err(|e| wrong(e.to_string()))?;
        self.inputs.insert(path.display().to_string(), files::sha256(&bytes));
        Ok(Some(document))
    }
}

//! Command `etalon compare`.

use super::report::Reports;
use super::{Output, Verdict};
use crate::run::documents::{self, Documents};
use etalon_base::error;
use etalon_base::message::{Problems, Result};
use etalon_compare::{Compared, compare};
use etalon_documents::to_json;
use etalon_report::Renderer;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Compare campaigns of one robot, and find significant changes.
///
/// Give the folder of each campaign, or the output folder of its `etalon run`, the oldest first.
/// Parameters, errors, AP, RP and mean positions are compared with the first and with the previous
/// campaign.
#[derive(Debug, clap::Args)]
pub struct Compare {
    /// Folders of campaigns, or their output folders, in the order of time.
    #[arg(required = true, num_args = 2..)]
    folders: Vec<PathBuf>,
    #[command(flatten)]
    reports: Reports,
    /// Print JSON.
    #[arg(long)]
    json: bool,
}

impl Compare {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        let mut problems = Problems::default();
        if let Err(more) = self.reports.check([]) {
            problems.0.extend(more.0);
        }
        let (mut all, mut places) = (Vec::new(), BTreeSet::new());
        for folder in &self.folders {
            match read(folder) {
                // the same folder under another name
                Ok((place, read)) => match places.insert(place) {
                    true => all.push(read),
                    false => problems.0.push(error!("campaign-twice", folder = read.folder)),
                },
                Err(more) => problems.0.extend(more.0),
            }
        }
        problems.check()?;
        let document = compare(&all)?;
        out.remark(&document.messages);
        let campaign = all.into_iter().next().map(|first| first.campaign.report).unwrap_or_default();
        let renderer = Renderer::comparison(&document, self.reports.over(campaign)?)?;
        self.reports.write(&renderer)?;
        out.answer(&renderer, self.json.then(|| to_json(&document)).transpose()?)
    }
}

/// Compared documents of a run.
const COMPARED: [&str; 5] =
    ["campaign.json", "parameters.json", "accuracy.json", "iso9283.json", "iso9283-streams.json"];

/// Files of the readings, of which a run writes at least one.
const READINGS: [&str; 2] = ["observations.csv", "points.parquet"];

/// Reads a campaign's output folder and its documents.
fn read(named: &Path) -> Result<(PathBuf, Compared)> {
    let folder = documents::output_folder(named)?;
    let place = folder.canonicalize().unwrap_or_else(|_| folder.clone());
    let documents = Documents::open(&folder)?;
    let mut inputs = BTreeMap::new();
    let mut listed = |name: &str| {
        let sha256 = documents.manifest.files.get(name).cloned();
        inputs.extend(sha256.map(|sha256| (documents.path(name).display().to_string(), sha256)));
    };
    COMPARED.into_iter().for_each(&mut listed);
    let identified = match documents.parameters()? {
        Some(parameters) => Some((parameters, documents.json("accuracy.json")?)),
        None => None,
    };
    let readings = READINGS.iter().find_map(|name| documents.manifest.files.get(*name).cloned());
    let compared = Compared {
        folder: named.display().to_string(),
        campaign: documents.json("campaign.json")?,
        identified,
        iso9283: documents.optional("iso9283.json")?,
        streams: documents.optional("iso9283-streams.json")?,
        inputs,
        readings,
    };
    Ok((place, compared))
}

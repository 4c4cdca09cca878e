//! The output folder of a campaign: documents are collected first and written when all of them are
//! whole.

use crate::run::documents::{self, Documents};
use crate::stages::gather::Gathered;
use crate::stages::join::Joined;
use etalon_base::error;
use etalon_base::files;
use etalon_base::folder::{Durability, FolderLock};
use etalon_base::message::Result;
use etalon_campaign::Campaign;
use etalon_documents::{ImportDocument, ManifestDocument, Source, SourceKind, to_json};
use etalon_formats::parquet;
use etalon_formats::table::Table;
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

/// Documents on their way to the output folder.
#[derive(Debug)]
pub struct Output {
    folder: PathBuf,
    files: Vec<(String, Vec<u8>)>,
    /// SHA-256 of the files.
    hashes: BTreeMap<String, String>,
}

impl Output {
    /// Nothing yet for `folder`.
    pub fn new(folder: PathBuf) -> Self {
        Self { folder, files: Vec::new(), hashes: BTreeMap::new() }
    }

    /// Adds a file.
    pub fn bytes(&mut self, name: &str, bytes: Vec<u8>) {
        self.hashes.insert(name.to_owned(), files::sha256(&bytes));
        self.files.push((name.to_owned(), bytes));
    }

    /// Adds a file whose name no template of a campaign may use.
    pub(super) fn add_reserved(&mut self, name: &str, bytes: Vec<u8>) {
        debug_assert!(documents::is_file_of_run(name), "{name} is missing in the files of a run");
        self.bytes(name, bytes);
    }

    /// A file that was added.
    pub fn file(&self, name: &str) -> Option<&[u8]> {
        self.files.iter().find(|(added, _)| added == name).map(|(_, bytes)| bytes.as_slice())
    }

    /// SHA-256 of a file that was added.
    pub fn sha256(&self, name: &str) -> Option<&str> {
        self.hashes.get(name).map(String::as_str)
    }

    /// Adds a document.
    pub fn json<T: Serialize>(&mut self, name: &str, document: &T) -> Result<()> {
        let bytes = to_json(document)?;
        self.add_reserved(name, bytes);
        Ok(())
    }

    /// Adds a document, if there is one.
    pub fn optional<T: Serialize>(&mut self, name: &str, document: Option<&T>) -> Result<()> {
        document.map_or(Ok(()), |document| self.json(name, document))
    }

    /// Adds a table as Parquet.
    pub fn table(&mut self, stem: &str, table: Table) -> Result<()> {
        let bytes = parquet::to_parquet(table)?;
        self.add_reserved(&format!("{stem}.parquet"), bytes);
        Ok(())
    }

    /// Adds the tables of points and joint values; the points are given up.
    pub fn gathered(&mut self, campaign: &Campaign, gathered: &mut Gathered) -> Result<()> {
        self.add_reserved("points.parquet", etalon_formats::to_parquet(std::mem::take(&mut gathered.points))?);
        for log in &gathered.logs {
            self.table(&Self::numbered("joints", &log.name, campaign), log.table())?;
        }
        Ok(())
    }

    /// Adds the observations of each log, as Parquet and as CSV.
    pub fn observations(&mut self, campaign: &Campaign, joined: Option<Joined>) -> Result<()> {
        for (name, observations) in joined.into_iter().flat_map(|joined| joined.observations) {
            let stem = Self::numbered("observations", &name, campaign);
            let table = observations.into_table();
            let csv = table.to_csv()?;
            self.table(&stem, table)?;
            self.add_reserved(&format!("{stem}.csv"), csv);
        }
        Ok(())
    }

    /// Adds the files of a report.
    pub fn reports(&mut self, files: Vec<etalon_report::File>) {
        files.into_iter().for_each(|(name, bytes)| self.add_reserved(name, bytes));
    }

    /// `stem`, or `stem-name` if the campaign has several logs and this is not the first.
    fn numbered(stem: &str, name: &str, campaign: &Campaign) -> String {
        let first = campaign.file.logs.first().is_none_or(|log| log.name == name);
        if first { stem.to_owned() } else { format!("{stem}-{name}") }
    }

    /// Replaces the folder by one with these files and with the files of others in the old one;
    /// returns the names of the files written. Fails if the contents of an input have changed since
    /// it was read, or if a file of others has the same name.
    pub fn write(self, campaign: &Campaign, sources: &[Source], durability: Durability) -> Result<Vec<String>> {
        let names: Vec<String> = self.files.iter().map(|(name, _)| name.clone()).collect();
        // no other process replaces the folder from here on
        let held = FolderLock::take(&self.folder)?;
        let earlier = self.earlier();
        if let Some(earlier) = &earlier {
            let written = names.iter().map(String::as_str).chain([ManifestDocument::NAME]);
            documents::refuse_foreign(&self.folder, written.filter(|name| !earlier.contains(*name)))?;
        }
        let ours = |name: &str| match &earlier {
            Some(files) => files.contains(name),
            None => etalon_controllers::file_names().any(|file| file == name),
        };
        let files = documents::with_manifest(self.hashes, self.files)?;
        let keeps = |name: &str| !ours(name) && !documents::holds(&files, name);
        held.replace(&files, keeps, || unchanged(campaign, sources), durability)?;
        Ok(names)
    }

    /// Names of the files that an earlier run wrote: none in a folder of others; `None` if a power
    /// failure truncated the manifest.
    fn earlier(&self) -> Option<BTreeSet<String>> {
        if let Ok(earlier) = Documents::open(&self.folder) {
            return Some(earlier.manifest.files.into_keys().chain([ManifestDocument::NAME.to_owned()]).collect());
        }
        let manifest = files::read(&self.folder.join(ManifestDocument::NAME));
        let cut_off = |bytes: Vec<u8>| serde_json::from_slice::<serde_json::Value>(&bytes).is_err();
        if manifest.is_ok_and(cut_off) { None } else { Some(BTreeSet::new()) }
    }
}

/// The campaign's output folder, if it holds the results of the current files of the campaign by
/// this version: with `file`, and undamaged.
pub fn current(campaign: &Campaign, file: &str) -> Option<Documents> {
    let documents = Documents::open(&campaign.output().ok()?).ok()?;
    let ManifestDocument { version, files, .. } = &documents.manifest;
    if version != env!("CARGO_PKG_VERSION") || !files.contains_key(file) {
        return None;
    }
    let import: ImportDocument = documents.json("import.json").ok()?;
    let whole = files.keys().all(|name| documents.bytes(name).is_ok());
    (whole && unchanged(campaign, &import.sources).is_ok()).then_some(documents)
}

/// Inputs that changed after the run of these documents, if their campaign is in a folder above the
/// output folder. Files that cannot be read are not compared.
pub fn changed_inputs(documents: &Documents) -> Result<Vec<String>> {
    let ImportDocument { sources, .. } = documents.json("import.json")?;
    let stated = sources.iter().find(|source| source.kind == SourceKind::Campaign);
    let (Some(stated), Ok(folder)) = (stated, documents.path("").canonicalize()) else { return Ok(Vec::new()) };
    let path = folder.ancestors().skip(1).map(|above| above.join(&stated.file)).find(|path| path.is_file());
    let Some(path) = path else { return Ok(Vec::new()) };
    let Ok((Some(campaign), _)) = Campaign::recover(&path) else { return Ok(vec![stated.file.clone()]) };
    let is_output = campaign.output().is_ok_and(|output| output.canonicalize().is_ok_and(|output| output == folder));
    let sha256 = |source: &Source| files::sha256_of_file(&campaign.source(source).ok()?).ok();
    let has_changed = |source: &&Source| sha256(source).is_some_and(|now| now != source.sha256);
    Ok(sources.iter().filter(|_| is_output).filter(has_changed).map(|source| source.file.clone()).collect())
}

/// An error if an input holds other bytes by now.
fn unchanged(campaign: &Campaign, sources: &[Source]) -> Result<()> {
    for source in sources {
        let now = campaign.source(source).ok().and_then(|path| files::sha256_of_file(&path).ok());
        if now.as_ref() != Some(&source.sha256) {
            return Err(error!("input-changed", file = source.file).into());
        }
    }
    Ok(())
}

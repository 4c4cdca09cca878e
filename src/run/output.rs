//! The output folder of a campaign: documents are collected first and written when all of them are whole.

use crate::base::files;
use crate::base::message::{Message, Result};
use crate::base::table;
use crate::campaign::Campaign;
use crate::import;
use crate::report;
use crate::stages::evaluate;
use crate::stages::gather::Gathered;
use crate::stages::identification::Identified;
use crate::stages::join::Joined;
use polars::prelude::DataFrame;
use serde::Serialize;
use std::path::PathBuf;

/// Documents on their way to the output folder.
#[derive(Debug)]
pub struct Output {
    folder: PathBuf,
    /// name and bytes; without bytes the file is removed
    files: Vec<(String, Option<Vec<u8>>)>,
}

/// A document as JSON text with a line end.
pub fn to_json<T: Serialize>(document: &T) -> Result<Vec<u8>> {
    let mut bytes = serde_json::to_vec_pretty(document)
        .map_err(|e| Message::error(format!("a document cannot be written as JSON: {e}")))?;
    bytes.push(b'\n');
    Ok(bytes)
}

impl Output {
    /// Nothing yet for `folder`.
    pub fn new(folder: PathBuf) -> Self {
        Self { folder, files: Vec::new() }
    }

    /// Adds a file.
    pub fn bytes(&mut self, name: &str, bytes: Vec<u8>) {
        self.files.push((name.to_owned(), Some(bytes)));
    }

    /// Removes a file of an earlier run.
    pub fn remove(&mut self, name: &str) {
        self.files.push((name.to_owned(), None));
    }

    /// Adds a document.
    pub fn json<T: Serialize>(&mut self, name: &str, document: &T) -> Result<()> {
        let bytes = to_json(document)?;
        self.bytes(name, bytes);
        Ok(())
    }

    /// Adds a document, or removes that of an earlier run.
    pub fn optional<T: Serialize>(&mut self, name: &str, document: Option<&T>) -> Result<()> {
        match document {
            Some(document) => self.json(name, document)?,
            None => self.remove(name),
        }
        Ok(())
    }

    /// Adds a table as Parquet.
    pub fn table(&mut self, stem: &str, table: &mut DataFrame) -> Result<()> {
        let bytes = table::to_parquet(table)?;
        self.bytes(&format!("{stem}.parquet"), bytes);
        Ok(())
    }

    /// Adds the tables of points and joint values.
    pub fn gathered(&mut self, campaign: &Campaign, gathered: &Gathered) -> Result<()> {
        self.table("points", &mut import::table(&gathered.points)?)?;
        for log in &gathered.logs {
            self.table(&Self::numbered("joints", &log.name, campaign), &mut log.table()?)?;
        }
        Ok(())
    }

    /// Adds the observations of each log, as Parquet and as CSV.
    pub fn observations(&mut self, campaign: &Campaign, joined: Option<Joined>) -> Result<()> {
        for (name, mut observations) in joined.into_iter().flat_map(|joined| joined.observations) {
            let stem = Self::numbered("observations", &name, campaign);
            self.table(&stem, &mut observations)?;
            let bytes = table::to_csv(&observations)?;
            self.bytes(&format!("{stem}.csv"), bytes);
        }
        Ok(())
    }

    /// Adds parameters and errors, or removes those of an earlier run.
    pub fn identified(&mut self, found: Option<&Identified>) -> Result<()> {
        self.optional("parameters.json", found.map(|found| &found.parameters))?;
        match found {
            Some(found) => self.table("residuals", &mut evaluate::to_table(&found.errors)?)?,
            None => self.remove("residuals.parquet"),
        }
        self.optional("accuracy.json", found.map(|found| &found.accuracy))
    }

    /// Adds the files of a report; a program without PDF leaves none of an earlier run.
    pub fn reports(&mut self, files: Vec<report::File>) {
        if !cfg!(feature = "pdf") {
            self.remove("report.pdf");
        }
        files.into_iter().for_each(|(name, bytes)| self.bytes(name, bytes));
    }

    /// `stem`, or `stem-name` where the campaign has several logs and this is not the first.
    fn numbered(stem: &str, name: &str, campaign: &Campaign) -> String {
        let first = campaign.file.logs.first().is_some_and(|log| log.name == name);
        if first { stem.to_owned() } else { format!("{stem}-{name}") }
    }

    /// Writes all files, each whole or not at all, and removes what is to go; gives the names of those written.
    pub fn write(self) -> Result<Vec<String>> {
        let mut written = Vec::new();
        for (name, bytes) in self.files {
            let path = self.folder.join(&name);
            match bytes {
                Some(bytes) => {
                    files::write(&path, &bytes)?;
                    written.push(name);
                }
                None => files::remove(&path)?,
            }
        }
        Ok(written)
    }
}

//! Writes parameters as a CSV table for spreadsheets and small scripts. Programs that read tables
//! do not accept comments, so additional columns replace the header lines of other formats.

use super::{About, ExportInput, Exporter, status_word};
use etalon_base::cell::without_formula as text;
use etalon_base::error;
use etalon_base::message::Result;

/// CSV with one parameter per row.
pub(super) struct Csv;

const HEADER: [&str; 10] = [
    "name",
    "unit",
    "nominal",
    "value",
    "standard_uncertainty",
    "status",
    "etalon",
    "campaign",
    "robot",
    "parameters_sha256",
];

impl Exporter for Csv {
    fn about(&self) -> About<'_> {
        About::laboratory("csv", "controller.csv")
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let document = given.parameters;
        let mut writer = csv::Writer::from_writer(Vec::new());
        let fail = |e: &dyn std::fmt::Display| error!("cannot-encode", format = "CSV", reason = e.to_string());
        let (warning, synthetic) = (given.caution(), given.synthetic().map(|why| text(&why)));
        let campaign = given.summary.map_or("", |summary| summary.name.as_str());
        let about = [&document.provenance.version, campaign, given.robot_name()].map(text);
        let about = [&about[..], &[given.sha256()?]].concat();
        let has_full_units = document.parameters.iter().any(|p| p.full_unit.is_some());
        let header = HEADER.into_iter().chain(warning.is_some().then_some("warning"));
        let header = header.chain(synthetic.is_some().then_some("synthetic"));
        let header = header.chain(has_full_units.then_some("full_unit"));
        writer.write_record(header).map_err(|e| fail(&e))?;
        for p in &document.parameters {
            let u = p.standard_uncertainty.map_or_else(String::new, digits);
            let row = [text(&p.name), text(&p.unit), digits(p.nominal), digits(p.value), u, status_word(p).to_owned()];
            let full_unit = has_full_units.then(|| text(p.printed_unit()));
            let cells = row.iter().chain(&about).chain(&warning).chain(&synthetic).chain(&full_unit);
            writer.write_record(cells).map_err(|e| fail(&e))?;
        }
        Ok(writer.into_inner().map_err(|e| fail(&e))?)
    }
}

/// Shortest decimal that reads back bit for bit.
fn digits(value: f64) -> String {
    format!("{value:?}")
}

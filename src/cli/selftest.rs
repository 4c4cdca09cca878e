//! Command `etalon selftest`.

use super::report::Reports;
use super::{Output, Verdict, progress};
use crate::run::selftest::{performance, selftest};
use etalon_base::phrase;
use etalon_documents::{Presentation, to_json};
use etalon_report::Renderer;
use std::path::PathBuf;

/// Validate this installation (ISO/IEC 17025:2017, 7.11.2), without a network.
///
/// The program compares itself with reference values that it contains. They cover geometric
/// elements, solver, frames, kinematics, identification, uncertainties, ISO 9283, ISO 230-2,
/// coverage, formats of exports and controllers, and the number of threads. Each comparison is
/// repeated with faults in the reference values, which it must detect. Data of NIST are compared if
/// ETALON_REFERENCE contains them.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  etalon selftest --report record.pdf
  etalon selftest --program-sha256 $(cut -d' ' -f1 etalon.sha256)
  etalon selftest --campaign frozen --expected frozen-parameters.json

Exit codes: 0 everything passed; 1 something failed, or a value of the campaign moved; 2 not run.")]
pub struct Selftest {
    /// Expected SHA-256 of the program file; another hash fails.
    #[arg(long, value_name = "HEX", value_parser = sha256)]
    program_sha256: Option<String>,
    /// Folder of a frozen campaign of the laboratory, which is run again. Nothing is written to it.
    #[arg(long, value_name = "FOLDER", requires = "expected")]
    campaign: Option<PathBuf>,
    /// Stored parameters.json of this campaign; every value that has changed fails.
    #[arg(long, value_name = "FILE", requires = "campaign")]
    expected: Option<PathBuf>,
    #[command(flatten)]
    reports: Reports,
    /// Print the answer as JSON.
    #[arg(long)]
    json: bool,
}

/// Checks that a text is a SHA-256.
fn sha256(text: &str) -> Result<String, String> {
    let is_hash = text.len() == 64 && text.bytes().all(|b| b.is_ascii_hexdigit());
    is_hash.then(|| text.to_owned()).ok_or_else(|| phrase!("selftest-hash-expected").to_string())
}

impl Selftest {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        self.reports.check(self.expected.as_ref())?;
        let performance = match (&self.campaign, &self.expected) {
            (Some(campaign), Some(expected)) => Some(performance::performance(campaign, expected)?),
            _ => None,
        };
        let mut document = selftest(self.program_sha256.as_deref(), &mut progress)?;
        document.pass &= performance.as_ref().is_none_or(|p| p.pass);
        document.performance = performance;
        let json = if self.json { Some(to_json(&document)?) } else { None };
        let renderer = Renderer::selftest(&document, self.reports.over(Presentation::default())?)?;
        self.reports.write(&renderer)?;
        out.answer(&renderer, json)
    }
}

//! Command `etalon run`.

use super::{Output, Verdict, shell_word};
use crate::run::documents::Documents;
use crate::run::pipeline::Wanted;
use crate::tasks::{self, Ran};
use etalon_base::message::printable;
use etalon_base::{phrase, warning};
use etalon_campaign::Campaign;
use etalon_documents::{Loading, Results, to_json};
use std::path::PathBuf;

/// Run a campaign from its exports to the report.
#[derive(Debug, clap::Args)]
pub struct Run {
    /// Folder of the campaign, or its campaign.toml.
    campaign: PathBuf,
    /// Print accuracy.json (for a test to ISO 9283 alone iso9283.json, or the document in its
    /// place) instead of a summary.
    #[arg(long)]
    json: bool,
    /// Skip a campaign if an environment variable for its data is unset.
    #[arg(long)]
    skip_missing: bool,
}

impl Run {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        let (campaign, problems) = Campaign::recover(&self.campaign)?;
        let Some(campaign) = campaign else { return Err(problems.into()) };
        if let Some(name) = campaign.missing_variable().filter(|_| self.skip_missing && problems.0.is_empty()) {
            out.say(phrase!("run-skipped", campaign = printable(&campaign.path), name));
            return Ok(Verdict::Met);
        }
        match problems.check().and_then(|_| tasks::run(&campaign, Wanted::Reports)) {
            Ok(ran) => self.answer(ran, out),
            Err(problems) => {
                let earlier = campaign.output().and_then(|folder| Documents::open(&folder)).ok();
                let report = earlier.map(|earlier| earlier.path("report.html"));
                if let Some(report) = report.filter(|report| report.is_file()) {
                    out.remark(&[warning!("earlier-run-left", report = report.display().to_string())]);
                }
                Err(problems.into())
            }
        }
    }

    fn answer(&self, ran: Ran, out: &Output) -> anyhow::Result<Verdict> {
        let Ran { folder, results, renderer, messages } = ran;
        let language = results.campaign.report.language;
        out.remark_in(language, &messages);
        let Results { identified, tested, verdict, .. } = &results;
        if identified.as_ref().is_some_and(|found| !found.parameters.is_plausible()) {
            out.say(phrase!("no-controller-files").text(language.code()));
        }
        let next = identified.as_ref().map(|_| {
            let command = format!("`etalon recommend {}`", shell_word(&self.campaign));
            let withheld = usize::from(verdict.loading.as_ref().and_then(Loading::reason).is_some());
            phrase!("next-recommend", command, withheld).text(language.code())
        });
        let data = match (self.json, identified, &tested.poses, &tested.streams) {
            (false, ..) => {
                let report = folder.join("report.html");
                let shown = renderer.map_or_else(String::new, |renderer| renderer.terminal());
                format!("{shown}\nreport: {}\n", printable(&report.display().to_string())).into_bytes()
            }
            (true, Some(found), ..) => to_json(&found.accuracy)?,
            (true, None, Some(poses), _) => to_json(poses)?,
            (true, None, None, Some(streams)) => to_json(streams)?,
            (true, None, None, None) => to_json(&tested.compliance)?,
        };
        let met = verdict.passes();
        let verdict = out.print_after_writing(data, Verdict::new(met));
        next.filter(|_| met).inspect(|next| out.next_step(self.json, next));
        Ok(verdict)
    }
}

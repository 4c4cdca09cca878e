//! Report of a campaign.

use super::Attachment;
use crate::model::{Contents, Dates, Layout};
use crate::sections;
use crate::words::{Words, isolated, tr};
use etalon_base::message::{Result, one_line};
use etalon_documents::{Characteristics, ParametersDocument, Results};

/// Sections with title, verdict and further contents.
pub(super) fn contents(results: &Results, words: &Words) -> Contents {
    let campaign = &results.campaign;
    Contents {
        title: campaign.name.clone(),
        subtitle: subtitle(results, words),
        synthetic: campaign.measurements.synthetic.iter().cloned().collect(),
        dates: Dates { date: campaign.measurements.date.clone(), issued: campaign.issue.issued.clone(), built: None },
        draft: sections::checklist::mark(results, words),
        version: results.provenance().version,
        verdict: sections::verdict::verdict(results, words),
        sections: sections::all(results, words),
        number: campaign.issue.number.clone(),
        statement: tr!(words, "results-relate-to-item"),
        layout: Layout { signed: true, compact: false, brief: true },
    }
}

fn subtitle(results: &Results, words: &Words) -> String {
    match &results.identified {
        Some(i) => match sections::conditions::robot_name(results) {
            Some(name) => tr!(words, "calibration-report-of-robot", robot = isolated(&one_line(&name))),
            None => model_title(&i.parameters, words),
        },
        None if results.tested.is_empty() && results.geometric.is_some() => tr!(words, "geometry-alone-title"),
        None => sections::verdict::title(&results.tested, words),
    }
}

/// Title of the calibration of a robot without a name.
pub(super) fn model_title(document: &ParametersDocument, words: &Words) -> String {
    tr!(words, "calibration-report-of-model", model = words.model(&document.robot))
}

/// Documents attached to the PDF.
pub(super) fn attachments(results: &Results, words: &Words) -> Result<Vec<Attachment>> {
    let mut all = Vec::new();
    if let Some(i) = &results.identified {
        let description = tr!(words, "attached-parameters");
        all.push(Attachment::new("parameters.json", "data", description, &i.parameters));
        all.push(Attachment::new("accuracy.json", "data", tr!(words, "attached-accuracy"), &i.accuracy));
    }
    let geometric = results.geometric.as_ref();
    all.extend(geometric.map(|d| Attachment::new("geometric.json", "data", tr!(words, "attached-geometric"), d)));
    let controllers = results.controllers.as_ref();
    all.extend(controllers.map(|d| Attachment::new("controllers.json", "data", tr!(words, "attached-controllers"), d)));
    let Characteristics { poses, streams, compliance } = &results.tested;
    all.extend(
        poses.as_ref().map(|d| Attachment::new("iso9283.json", "data", tr!(words, "attached-characteristics"), d)),
    );
    all.extend(
        streams.as_ref().map(|d| Attachment::new("iso9283-streams.json", "data", tr!(words, "attached-streams"), d)),
    );
    all.extend(
        compliance
            .as_ref()
            .map(|d| Attachment::new("iso9283-compliance.json", "data", tr!(words, "attached-compliance"), d)),
    );
    all.push(Attachment::new("campaign.json", "source", tr!(words, "attached-campaign"), &results.campaign));
    all.into_iter().collect()
}

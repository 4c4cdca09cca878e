//! Results of a run as the documents of its output folder: written, and read back.

use crate::run::documents::{Documents, PARAMETERS};
use crate::run::output::Output;
use crate::stages::evaluate::error_table;
use etalon_base::catalogue::Phrase;
use etalon_base::message::Result;
use etalon_documents::{
    AccuracyDocument, ActionKind, Characteristics, FieldDocument, IdentifiedDocuments, Loading, ParametersDocument,
    Results, VerdictDocument,
};

/// Adds the documents of the results to an output folder.
///
/// # Errors
/// Fails if a document cannot be encoded.
pub(super) fn write(results: &Results, out: &mut Output) -> Result<()> {
    out.json("campaign.json", &results.campaign)?;
    out.json("import.json", &results.import)?;
    out.json("features.json", &results.features)?;
    out.json("frames.json", &results.frames)?;
    if let Some(identified) = &results.identified {
        // programs may be corrected by the field, although no file is worth loading
        let is_used = results.verdict.actions.iter().any(|a| a.action == ActionKind::Compensate);
        let withheld = results.verdict.loading.as_ref().and_then(Loading::reason).filter(|_| !is_used);
        write_identified(identified, withheld.as_ref(), out)?;
    }
    out.json("verdict.json", &results.verdict)?;
    out.optional("geometric.json", results.geometric.as_ref())?;
    out.optional("controllers.json", results.controllers.as_ref())?;
    let Characteristics { poses, streams, compliance } = &results.tested;
    out.optional("iso9283.json", poses.as_ref())?;
    out.optional("iso9283-streams.json", streams.as_ref())?;
    out.optional("iso9283-compliance.json", compliance.as_ref())
}

/// Adds parameters, field and errors; `withheld` is the reason for loading nothing.
fn write_identified(found: &IdentifiedDocuments, withheld: Option<&Phrase>, out: &mut Output) -> Result<()> {
    out.json(PARAMETERS, &found.parameters)?;
    if let Some(field) = &found.field {
        out.json(FieldDocument::NAME, field)?;
        for (name, bytes) in etalon_controllers::field_code(field, withheld)? {
            out.add_reserved(name, bytes);
        }
    }
    out.table("residuals", error_table::to_table(&found.errors, &found.accuracy.joints))?;
    out.json("accuracy.json", &found.accuracy)
}

/// Reads the results of a run back from its output folder.
///
/// # Errors
/// Fails if a document is missing, or has changed since the run.
pub fn read(documents: &Documents) -> Result<Results> {
    let identified = |parameters: ParametersDocument| -> Result<IdentifiedDocuments> {
        let accuracy: AccuracyDocument = documents.json("accuracy.json")?;
        let errors = documents.errors(&accuracy)?;
        Ok(IdentifiedDocuments { parameters, accuracy, errors, field: documents.optional(FieldDocument::NAME)? })
    };
    let verdict: Option<VerdictDocument> = documents.optional("verdict.json")?;
    let is_judged = verdict.is_some();
    let results = Results {
        campaign: documents.json("campaign.json")?,
        import: documents.json("import.json")?,
        features: documents.json("features.json")?,
        frames: documents.json("frames.json")?,
        // a campaign that only tests has none
        identified: documents.parameters()?.map(identified).transpose()?,
        geometric: documents.optional("geometric.json")?,
        controllers: documents.optional("controllers.json")?,
        tested: Characteristics {
            poses: documents.optional("iso9283.json")?,
            streams: documents.optional("iso9283-streams.json")?,
            compliance: documents.optional("iso9283-compliance.json")?,
        },
        verdict: verdict.unwrap_or_default(),
    };
    // the first versions wrote no verdict
    Ok(if is_judged { results } else { results.judged() })
}

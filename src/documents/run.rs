//! Results of a run: filled once, stored in the documents of its output folder, and read back as
//! the same type.

use crate::loading::judged_file;
use crate::{
    AccuracyDocument, CampaignSummary, Characteristics, ControllerFiles, ControllersDocument, Evidence,
    FeaturesDocument, FieldDocument, FramesDocument, GeometricDocument, ImportDocument, Judged, ParametersDocument,
    PointError, Provenance, VerdictDocument, WrittenFile,
};
use etalon_base::message::Message;

/// Results of a run: everything that its report, its controller files and its exit code derive
/// from.
#[derive(Clone, Debug, PartialEq)]
pub struct Results {
    /// Administrative data of the campaign: campaign.json.
    pub campaign: CampaignSummary,
    /// Imported and rejected rows: import.json.
    pub import: ImportDocument,
    /// Fitted elements: features.json.
    pub features: FeaturesDocument,
    /// Frames made from the elements: frames.json.
    pub frames: FramesDocument,
    /// Identification; absent if a campaign only tests to ISO 9283.
    pub identified: Option<IdentifiedDocuments>,
    /// Results of the geometric method, if requested by the campaign: geometric.json.
    pub geometric: Option<GeometricDocument>,
    /// Controller files in formats that omit identified parameters: controllers.json.
    pub controllers: Option<ControllersDocument>,
    /// Characteristics of ISO 9283.
    pub tested: Characteristics,
    /// Verdict on all other documents: verdict.json. [`Results::judged`] fills it.
    pub verdict: VerdictDocument,
}

/// Documents of an identification.
#[derive(Clone, Debug, PartialEq)]
pub struct IdentifiedDocuments {
    /// Identified parameters: parameters.json.
    pub parameters: ParametersDocument,
    /// Errors before and after calibration, summarised: accuracy.json.
    pub accuracy: AccuracyDocument,
    /// Errors of every observation: residuals.parquet.
    pub errors: Vec<PointError>,
    /// Residual field, if requested and significant: field.json.
    pub field: Option<FieldDocument>,
}

impl Results {
    /// Fills the verdict with its reasons and next steps, from all other documents.
    pub fn judged(mut self) -> Self {
        let identified = self.identified.as_ref();
        let file = self.judged_file();
        let messages: Vec<&Message> = self.messages().collect();
        let judged = Judged {
            parameters: identified.map(|i| &i.parameters),
            accuracy: identified.map(|i| &i.accuracy),
            tested: &self.tested,
            controllers: self.controllers.as_ref(),
            loaded: file.map(|(_, values)| values),
            conditions: Some(&self.campaign.conditions),
            messages: &messages,
        };
        let errors = identified.map_or(&[][..], |i| &i.errors);
        let judged_file = file.map(|(written, _)| written.file.clone());
        let verdict = Evidence { judged, campaign: &self.campaign, errors }.verdict();
        self.verdict = VerdictDocument { judged_file, ..verdict };
        self
    }

    /// Controller file with whose values the limits are judged; `None` if its values are the
    /// identified ones.
    pub fn judged_file(&self) -> Option<(&WrittenFile, &ControllerFiles)> {
        let accuracy = &self.plausible()?.accuracy;
        judged_file(accuracy, &self.campaign.controller_files, self.controllers.as_ref())
    }

    /// Warnings and errors of all documents, in the order of the report.
    pub fn messages(&self) -> impl Iterator<Item = &Message> {
        let identified = self.identified.iter().flat_map(|i| &i.parameters.messages);
        let controllers = self.controllers.iter().flat_map(|c| &c.messages);
        let geometric = self.geometric.iter().flat_map(|g| &g.messages);
        let messages = identified.chain(controllers).chain(&self.import.messages);
        messages.chain(geometric).chain(self.tested.messages())
    }

    /// Origin of the numbers.
    pub fn provenance(&self) -> Provenance {
        let imported = || {
            let version = env!("CARGO_PKG_VERSION").to_owned();
            Provenance { version, inputs: self.import.inputs(), seed: None }
        };
        self.identified.as_ref().map_or_else(imported, |i| i.parameters.provenance.clone())
    }

    /// Identified parameters that may be written to controller files; `None` if they cannot be the
    /// parameters of a robot.
    pub fn plausible(&self) -> Option<&IdentifiedDocuments> {
        self.identified.as_ref().filter(|i| i.parameters.is_plausible())
    }
}

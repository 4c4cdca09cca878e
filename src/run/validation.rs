//! The pipeline as far as the observations, to judge parameters on them.

use super::pipeline::{evaluate, identified_again};
use super::summary::summary;
use super::walk::{self, Observed};
use crate::stages::calibrate::identification::{identify, identify_chosen};
use crate::stages::calibrate::recommendation;
use crate::stages::calibrate::selection::{CampaignData, select};
use crate::stages::judge::set_up::check_set_up;
use crate::stages::uncertainty::monte_carlo::{Draws, Trials};
use crate::stages::verify::validation::{self, Validated, Validation};
use etalon_base::error;
use etalon_base::message::{Message, Place, Result};
use etalon_campaign::{Campaign, Identify};
use etalon_controllers::Exporter;
use etalon_documents::{
    CampaignReference, CampaignSummary, ControllersDocument, IdentifiedDocuments, LoadAnswer, ParameterStatus,
    Presentation, Provenance, RecommendationDocument, UncertaintyDocument,
};

/// Judges the parameters of a document, or nominal ones, on the data of a campaign. Nothing is
/// written.
pub fn validate(campaign: &Campaign, judged: Validation) -> Result<Validated> {
    let (stated, Observed { gathered, mut robot, frames, joined }) = observed(campaign)?;
    let selected = select(CampaignData { campaign, stated, joined: &joined, frames: &frames }, robot.as_mut())?;
    let mut found = validation::validate(campaign, selected, robot.as_mut(), judged)?;
    found.accuracy.campaign = Some(reference(campaign));
    let (version, inputs) = (env!("CARGO_PKG_VERSION").to_owned(), gathered.document.inputs());
    found.accuracy.provenance = Some(Provenance { version, inputs, seed: None });
    found.messages.splice(0..0, gathered.document.messages);
    Ok(found)
}

/// Explains which parameters of a campaign to load: the answer of its run; `report` is called with
/// the choices that were tried and the most that may be. Nothing is written.
pub fn recommend(campaign: &Campaign, report: &mut dyn FnMut(usize, usize)) -> Result<RecommendationDocument> {
    let (stated, Observed { gathered, mut robot, frames, joined }) = observed(campaign)?;
    let selected = select(CampaignData { campaign, stated, joined: &joined, frames: &frames }, robot.as_mut())?;
    let basis = &selected.basis;
    let wrong = check_set_up(robot.as_ref(), &basis.sets.calibration, &basis.settings)?;
    let run = evaluate(campaign)?;
    let mut found = recommendation::recommend(robot.as_ref(), selected, &run.results, report)?;
    found.messages.splice(0..0, wrong);
    found.campaign = Some(reference(campaign));
    found.recommended.valid_until = campaign.file.valid_until();
    found.recommended.synthetic = campaign.file.synthetic.clone();
    found.messages.splice(0..0, gathered.document.messages);
    Ok(found)
}

/// The recommended parameters of a campaign, identified like the parameters of a run.
pub struct Recommended {
    /// Parameters with their errors; parameters that are not recommended are at nominal.
    pub found: IdentifiedDocuments,
    /// Contents of formats instead of these parameters.
    pub controllers: Option<ControllersDocument>,
    /// Administrative data of the campaign.
    pub summary: CampaignSummary,
    /// Warnings of the recommendation.
    pub messages: Vec<Message>,
}

/// Identifies the recommended parameters of a campaign, and again for each format that cannot
/// contain all of them, as a run does. Nothing is written.
pub fn identify_recommended(
    campaign: &Campaign,
    formats: &[(&str, &dyn Exporter)],
    report: &mut dyn FnMut(usize, usize),
) -> Result<Recommended> {
    let RecommendationDocument { loading, recommended, messages, .. } = recommend(campaign, report)?;
    let (stated, Observed { gathered, mut robot, frames, joined }) = observed(campaign)?;
    let data = CampaignData { campaign, stated, joined: &joined, frames: &frames };
    let mut found = match loading.map(|loading| loading.answer) {
        Some(LoadAnswer::Load | LoadAnswer::Resolve) => identify(data, robot.as_mut())?,
        _ => {
            let fixed = recommended.parameters.into_iter().filter(|p| p.status == ParameterStatus::Fixed);
            identify_chosen(data, robot.as_mut(), fixed.map(|p| p.name))?
        }
    };
    found.documents.parameters.provenance.inputs = gathered.document.inputs();
    let summary = summary(campaign, Presentation::default());
    let controllers = identified_again(campaign, robot.as_ref(), &found, &summary, formats);
    Ok(Recommended { found: found.documents, controllers, summary, messages })
}

/// Distributions of the results of a campaign; `report` is called with the draws made and the most
/// that may be. Nothing is written.
pub fn uncertainty(
    campaign: &Campaign,
    draws: Draws,
    report: &mut dyn FnMut(usize, usize),
) -> Result<UncertaintyDocument> {
    let (stated, Observed { gathered, mut robot, frames, joined }) = observed(campaign)?;
    let data = CampaignData { campaign, stated, joined: &joined, frames: &frames };
    let identified = identify(data, robot.as_mut())?;
    let trials = Trials::new(campaign, robot.as_ref(), &gathered.points, &frames, &identified);
    let mut found = trials.distributions(draws, report)?;
    found.campaign = Some(reference(campaign));
    found.provenance.inputs = gathered.document.inputs();
    found.messages.splice(0..0, gathered.document.messages);
    Ok(found)
}

/// The campaign in the head of an answer.
fn reference(campaign: &Campaign) -> CampaignReference {
    let file = &campaign.file;
    CampaignReference {
        name: file.name.clone(),
        robot: campaign.robot.name.clone(),
        date: file.date.clone(),
        instrument: Some(file.instrument.name.clone()),
        synthetic: file.synthetic.clone(),
    }
}

fn observed(campaign: &Campaign) -> Result<(&Identify, Observed)> {
    let Some(stated) = &campaign.file.identify else {
        return Err(error!("identify-missing").at(Place::file(campaign.path.as_str())).into());
    };
    Ok((stated, walk::observed(campaign)?))
}

//! What a report says about its campaign.

use crate::base::message::{Problems, Result};
use crate::campaign::Campaign;
use crate::document::{CampaignSummary, ContactSummary, Presentation};
use crate::report::branding;
use toml::Spanned;

/// What a report says about the campaign.
pub fn summary(campaign: &Campaign) -> Result<CampaignSummary> {
    let file = &campaign.file;
    Ok(CampaignSummary {
        name: file.name.clone(),
        robot: campaign.robot.name.clone(),
        synthetic: file.synthetic.clone(),
        notes: file.notes.clone(),
        date: file.date.clone(),
        operator: file.operator.clone(),
        instrument: Some(file.instrument.name.clone()),
        expanded_uncertainty_um: Some(file.instrument.expanded_uncertainty_um),
        coverage_factor: Some(file.instrument.coverage_factor),
        contact: file
            .contact
            .map(|c| ContactSummary { repeatability_um: c.repeatability_um, coverage_factor: c.coverage_factor }),
        temperature_c: file.temperature_c,
        conditions: file.conditions.clone(),
        report: presentation(campaign)?,
    })
}

/// How the report is dressed, with logo and templates read.
pub fn presentation(campaign: &Campaign) -> Result<Presentation> {
    let stated = &campaign.file.report;
    let read = |file: &Spanned<String>| Ok::<_, Problems>((campaign.resolve(file)?, campaign.place(file)));
    let logo = stated.logo.as_ref().map(read).transpose()?;
    let templates = stated.templates.as_ref().map(read).transpose()?;
    let logo = logo.map(|(path, place)| branding::logo(&path).map_err(|p| p.at(&place))).transpose()?;
    let templates = templates.map(|(path, place)| branding::templates(&path).map_err(|p| p.at(&place))).transpose()?;
    Ok(Presentation { language: stated.language, logo, templates: templates.unwrap_or_default() })
}

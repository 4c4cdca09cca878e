//! The campaign as in its report.

use etalon_campaign::{Campaign, ReportDefinition};
use etalon_documents::{
    CampaignSummary, ContactSummary, InstrumentSummary, Issue, LimitsSummary, MeasurementSummary, Presentation,
    TemperatureSummary,
};

/// The campaign as its report gives it, before its files are read.
pub fn summary(campaign: &Campaign, report: Presentation) -> CampaignSummary {
    let file = &campaign.file;
    CampaignSummary {
        name: file.name.clone(),
        robot: campaign.robot.name.clone(),
        measurements: MeasurementSummary {
            synthetic: file.synthetic.clone(),
            notes: file.notes.clone(),
            date: file.date.clone(),
            operator: file.operator.clone(),
        },
        instrument: InstrumentSummary {
            name: Some(file.instrument.name.clone()),
            expanded_uncertainty_um: Some(file.instrument.expanded_uncertainty_um),
            coverage_factor: Some(file.instrument.coverage_factor),
            expanded_position_uncertainty_um: file.instrument.expanded_position_uncertainty_um,
        },
        limits: LimitsSummary {
            decision_rule: file.limits.decision_rule,
            specification: file.limits.specification.clone(),
        },
        contact: file
            .contact
            .map(|c| ContactSummary { repeatability_um: c.repeatability_um, coverage_factor: c.coverage_factor }),
        temperature: TemperatureSummary { stated_c: file.temperature_c, range_c: None },
        conditions: file.conditions.clone(),
        valid_until: file.valid_until(),
        controller_files: Vec::new(),
        issue: issue(&file.report),
        report,
    }
}

fn issue(stated: &ReportDefinition) -> Issue {
    let ReportDefinition { number, amends, customer, country, issued, authorised_by, external_results, .. } =
        stated.clone();
    Issue { number, amends, customer, country, issued, authorised_by, external_results }
}

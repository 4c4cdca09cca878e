//! The report as an Excel workbook: one sheet for each table, every number with all its digits.

mod accuracy;
mod compare;
mod geometric;
mod import;
mod iso9283;
mod parameters;
mod places;
mod sheet;
mod streams;
mod summary;
#[cfg(test)]
mod tests;
#[cfg(test)]
pub(super) use tests::only_texts_and_numbers;

use super::words::Words;
use super::{Identified, Report, verdict};
use crate::base::message::Result;
use crate::document::{Characteristics, CompareDocument, Presentation};

/// All tables of a report as a workbook (.xlsx).
pub fn workbook(report: &Report) -> Result<Vec<u8>> {
    let words = &Words::of(report.campaign.report.language)?;
    let first = match &report.identified {
        Some(identified) => summary::calibration(report, identified, words),
        None => summary::test(report, words),
    };
    let mut sheets = vec![first, summary::limits(&report.limits())];
    sheets.extend(report.identified.iter().flat_map(|i| accuracy::sheets(i.accuracy, i.errors)));
    sheets.extend(tested(report.tested));
    sheets.extend(report.identified.iter().flat_map(|i| parameters::sheets(i.parameters)));
    sheets.extend(report.identified.iter().filter_map(|i| i.geometric).flat_map(geometric::sheets));
    sheets.extend(places::sheets(report.features, &report.frames.world));
    let read = report.import.inputs();
    let inputs = report.identified.map_or(&read, |i| &i.parameters.provenance.inputs);
    sheets.extend(import::sheets(report.import, inputs));
    sheets.push(summary::messages(&report.messages()));
    sheet::write(&report.campaign.name, &sheets)
}

/// All tables of a comparison of campaigns as a workbook (.xlsx).
pub(super) fn compare_workbook(document: &CompareDocument, presentation: &Presentation) -> Result<Vec<u8>> {
    let words = &Words::of(presentation.language)?;
    sheet::write(&words.say("What changed"), &compare::sheets(document, words))
}

fn tested(found: &Characteristics) -> Vec<sheet::Sheet> {
    let poses = found.poses.iter().flat_map(iso9283::sheets);
    let streams = found.streams.iter().flat_map(streams::sheets);
    poses.chain(streams).chain(found.compliance.iter().map(iso9283::compliance)).collect()
}

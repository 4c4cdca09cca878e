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
use super::{Report, TestReport, messages, test_messages, verdict};
use crate::base::message::Result;
use crate::document::{Characteristics, CompareDocument, Presentation};

/// All tables of a calibration as a workbook (.xlsx).
pub fn workbook(report: &Report) -> Result<Vec<u8>> {
    let words = &Words::of(report.campaign.report.language)?;
    let mut sheets = vec![summary::calibration(report, words), summary::limits(&limits(report))];
    sheets.extend(accuracy::sheets(report.accuracy, report.errors));
    sheets.extend(tested(report.tested));
    sheets.extend(parameters::sheets(report.parameters));
    sheets.extend(report.geometric.iter().flat_map(|d| geometric::sheets(d)));
    sheets.extend(places::sheets(report.features, &report.frames.world));
    sheets.extend(import::sheets(report.import, &report.parameters.provenance.inputs));
    sheets.push(summary::messages(&messages(report)));
    sheet::write(&report.campaign.name, &sheets)
}

/// All tables of a test by ISO 9283 as a workbook (.xlsx).
pub fn test_workbook(report: &TestReport) -> Result<Vec<u8>> {
    let words = &Words::of(report.campaign.report.language)?;
    let mut sheets = vec![summary::test(report, words), summary::limits(&report.tested.limits().collect::<Vec<_>>())];
    sheets.extend(tested(report.tested));
    sheets.extend(places::sheets(report.features, &report.frames.world));
    sheets.extend(import::sheets(report.import, &report.import.inputs()));
    sheets.push(summary::messages(&test_messages(report)));
    sheet::write(&report.campaign.name, &sheets)
}

/// All tables of a comparison of campaigns as a workbook (.xlsx).
pub(super) fn compare_workbook(document: &CompareDocument, presentation: &Presentation) -> Result<Vec<u8>> {
    let words = &Words::of(presentation.language)?;
    sheet::write(&words.say("What changed"), &compare::sheets(document, words))
}

fn limits<'a>(report: &Report<'a>) -> Vec<&'a crate::document::LimitVerdict> {
    report.accuracy.limits.iter().chain(report.tested.limits()).collect()
}

fn tested(found: &Characteristics) -> Vec<sheet::Sheet> {
    let poses = found.poses.iter().flat_map(iso9283::sheets);
    let streams = found.streams.iter().flat_map(streams::sheets);
    poses.chain(streams).chain(found.compliance.iter().map(iso9283::compliance)).collect()
}

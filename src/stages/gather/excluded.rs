//! Rows of exports that a campaign excludes by their numbers.

use super::points::PointColumns;
use crate::stages::observe::exclusions::excluded_rows;
use etalon_base::message::{Message, Problems, Result};
use etalon_base::{error, phrase, warning};
use etalon_campaign::Campaign;
use etalon_documents::{Refused, Source, SourceKind};

/// Excludes the rows that `[[identify.exclude]]` names: they are listed among the rejected rows,
/// with their reasons.
pub(super) fn leave_out(
    campaign: &Campaign,
    columns: &mut PointColumns,
    sources: &mut [Source],
) -> Result<Vec<Message>> {
    let mut problems = Problems::default();
    for stated in campaign.file.identify.iter().flat_map(|identify| &identify.exclude) {
        let rule = stated.get_ref();
        let place = || campaign.place(stated);
        let (rows, file) = match (&rule.poses, &rule.rows, &rule.file) {
            (Some(_), None, None) => continue,
            (None, Some(rows), Some(file)) if rule.cycle.is_none() && rule.target.is_none() => (rows, file),
            _ => {
                problems.0.push(error!("exclusion-mixed").at(place()));
                continue;
            }
        };
        let all = || columns.points.iter().chain(columns.stationed.iter().map(|of| &of.point));
        let of_file = all().filter(|point| *point.export == **file);
        if of_file.clone().next().is_none() {
            let names = campaign.file.exports.iter().map(|export| export.file.get_ref().as_str());
            problems.0.push(error!("exclusion-file-unknown", file).at(place()).hint_names(file, names));
            continue;
        }
        let excluded = match excluded_rows(rows, &rule.reason, of_file.map(|point| point.row.into())) {
            Ok(excluded) => excluded,
            Err(message) => {
                problems.0.push(message.at(place()));
                continue;
            }
        };
        let reason = phrase!("row-excluded", reason = rule.reason);
        if let Some(source) =
            sources.iter_mut().find(|source| source.file == *file && source.kind == SourceKind::Export)
        {
            let left_out = all().filter(|point| *point.export == **file && excluded.contains(&point.row.into()));
            let refused = |p: &etalon_formats::Point| Refused::new(p.line as usize, &p.text, reason.clone());
            source.refused.extend(left_out.map(refused));
            source.refused.sort_by_key(|refused| refused.line);
        }
        let stays = |point: &etalon_formats::Point| *point.export != **file || !excluded.contains(&point.row.into());
        columns.points.retain(stays);
        columns.stationed.retain(|of| stays(&of.point));
        let message = warning!("excluded-rows", count = excluded.len(), rows = rows.to_string(), reason = rule.reason);
        problems.0.push(message.within(phrase!("of-name", name = file)).routine());
    }
    problems.check()
}

//! Exports with joint values in addition to the points: each row is joined with itself.

use crate::{CampaignFile, Join, JoinBy};
use etalon_base::error;
use etalon_base::message::{Message, SourceText};
use etalon_formats::dialect::{Column, ColumnRole};
use etalon_formats::{Export, Log, LogKind};
use etalon_tables::Form;
use etalon_tables::FromRow;
use toml::Spanned;

impl CampaignFile {
    /// Adds a log for each file whose exports contain `joints`, and the join by rows, if neither is
    /// given; returns errors if joints cannot be read.
    pub(crate) fn add_joints_of_exports(&mut self, stated: SourceText) -> Vec<Message> {
        if !self.logs.is_empty() || self.exports.iter().all(|export| export.joints.is_empty()) {
            return Vec::new();
        }
        let mut wrong = Vec::new();
        for export in self.exports.iter_mut().filter(|export| !export.joints.is_empty()) {
            let dialect = &export.format.dialect;
            if dialect.form.delimiter.is_none() && dialect.form.sheet.is_none() {
                wrong.push(error!("joints-need-delimited-text").at(stated.place(&export.file)));
                continue;
            }
            let named = |role| export.format.dialect.columns.contains(role);
            let in_label = export.label.as_ref().is_some_and(|label| label.get_ref().contains("{pose}"));
            let is_named = named(ColumnRole::Pose) || in_label || export.from_name.pose.is_some();
            if export.pose.is_none() && !is_named {
                export.pose = Some(FromRow::default());
            }
            // several points of a row share the joints of the row
            if self.logs.iter().all(|log| log.file.get_ref() != export.file.get_ref()) {
                let mut log = log_from_export(export);
                if !self.logs.is_empty() {
                    log.name = format!("log-{}", self.logs.len() + 1);
                }
                self.logs.push(log);
            }
        }
        let by_row = Join {
            by: JoinBy::Row,
            targets: None,
            clock_offset_s: None,
            clock_rate: None,
            tolerance_s: None,
            interpolate: false,
        };
        self.join.get_or_insert(by_row);
        wrong
    }

    /// Contradiction to an export with `joints`, with the text that gives it.
    pub fn joints_stated_twice(&self) -> Option<(Message, &Spanned<String>)> {
        let mut mixed = self.exports.iter().filter(|export| !export.joints.is_empty());
        let export = mixed.next()?;
        let of_exports = |log: &&Log| self.exports.iter().any(|e| e.file.span() == log.file.span());
        if let Some(log) = self.logs.iter().find(|log| !of_exports(log)) {
            return Some((error!("joints-twice", file = export.file.get_ref()), &log.file));
        }
        let columns = |export: &Export| -> Vec<(String, Column)> {
            export.joints.iter().map(|(key, column)| (key.get_ref().clone(), column.clone())).collect()
        };
        for (i, export) in self.exports.iter().enumerate().filter(|(_, export)| !export.joints.is_empty()) {
            let same = |other: &&Export| !other.joints.is_empty() && other.file.get_ref() == export.file.get_ref();
            if self.exports[..i].iter().find(same).is_some_and(|other| columns(other) != columns(export)) {
                return Some((error!("joints-differ", file = export.file.get_ref()), &export.file));
            }
        }
        (self.join_by() != Some(JoinBy::Row)).then(|| (error!("joints-joined-by-row"), &export.file))
    }

    /// Targets that exports contain for all their rows and that have no other use; these are the
    /// robot's targets if `[join]` names none.
    pub fn stated_targets(&self) -> Vec<String> {
        let mixed = self.exports.iter().any(|export| !export.joints.is_empty());
        let of_world = self.frame.iter().flat_map(|frame| frame.world.targets.iter().flatten());
        let fixed = self.fixed.iter().flat_map(|fixed| &fixed.targets);
        let claimed: Vec<&str> = of_world.chain(fixed).map(|name| name.get_ref().as_str()).collect();
        let mut targets: Vec<String> = Vec::new();
        for export in self.exports.iter().filter(|export| !mixed || !export.joints.is_empty()) {
            let new = |target: &&String| !claimed.contains(&target.as_str()) && !targets.contains(*target);
            let target = export.target.iter().find(new).cloned();
            targets.extend(target);
        }
        targets
    }
}

fn log_from_export(export: &Export) -> Log {
    let dialect = &export.format.dialect;
    let (encoding, header) = (export.encoding.or(dialect.form.encoding), Some(dialect.header()));
    Log {
        name: "log".to_owned(),
        file: export.file.clone(),
        format: LogKind::default(),
        form: Form { encoding, header, ..dialect.form.clone() },
        columns: export.joints.clone(),
        constants: Default::default(),
        pose: None,
        period_s: None,
        values: None,
        standstill: None,
    }
}

//! Exports with joint values beside the points: each row is joined with itself.

use super::{CampaignFile, Join, JoinBy};
use etalon_base::message::{Message, SourceText};
use etalon_formats::dialect::{ColumnRole, Delimiter, FromRow, Header};
use etalon_formats::{Export, Log, LogKind};
use toml::Spanned;

impl CampaignFile {
    /// Adds the log that an export with `joints` contains, and the join by its rows, if neither is
    /// stated; returns an error if its joints cannot be read.
    pub(super) fn add_joints_of_exports(&mut self, stated: SourceText) -> Option<Message> {
        let export = self.exports.iter_mut().find(|export| !export.joints.is_empty())?;
        if !self.logs.is_empty() {
            return None;
        }
        let dialect = &export.format.dialect;
        let header = match dialect.header {
            Header::Rows(0) => Some(false),
            Header::Rows(1) => Some(true),
            _ => None,
        };
        let (Some(delimiter), Some(header), None) = (dialect.delimiter, header, &dialect.comment) else {
            let message = Message::error("`joints` are read of delimited text with one row of names at most")
                .at(stated.place(&export.file));
            let hint = "state `format = { delimiter = .., header = 1, columns = .. }`; of other files name the joints in a [log]";
            return Some(message.hint(hint));
        };
        self.logs.push(log_of(export, delimiter, header));
        let named = |role| export.format.dialect.columns.contains(role);
        let in_label = export.label.as_ref().is_some_and(|label| label.get_ref().contains("{pose}"));
        if export.pose.is_none() && !named(ColumnRole::Pose) && !in_label {
            export.pose = Some(FromRow::default());
        }
        let by_row =
            Join { by: JoinBy::Row, targets: None, clock_offset_s: None, tolerance_s: None, interpolate: false };
        self.join.get_or_insert(by_row);
        None
    }

    /// Contradiction to an export with `joints`, with the text that states it.
    pub fn joints_stated_twice(&self) -> Option<(Message, &Spanned<String>)> {
        let mut mixed = self.exports.iter().filter(|export| !export.joints.is_empty());
        let export = mixed.next()?;
        if let Some(other) = mixed.next() {
            let message = Message::error("two exports carry joints, and a campaign has one such file");
            return Some((message.hint("put their rows into one file"), &other.file));
        }
        if let Some(log) = self.logs.iter().find(|log| log.file.span() != export.file.span()) {
            let what = format!("the joints are stated twice: in `joints` of `{}` and in [log]", export.file.get_ref());
            return Some((Message::error(what).hint("leave one of them out"), &log.file));
        }
        (self.join_by() != Some(JoinBy::Row)).then(|| {
            let message = Message::error("an export with `joints` is joined by its rows");
            (message.hint("state `by = \"row\"` in [join], or leave [join] out"), &export.file)
        })
    }
}

fn log_of(export: &Export, delimiter: Delimiter, header: bool) -> Log {
    Log {
        name: "log".to_owned(),
        file: export.file.clone(),
        encoding: export.encoding,
        format: LogKind::default(),
        delimiter: Some(delimiter),
        decimal: export.format.dialect.decimal,
        header,
        columns: export.joints.clone(),
        pose: None,
        period_s: None,
        values: None,
        standstill: None,
    }
}

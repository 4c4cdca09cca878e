//! Records of a DMIS file: a line each, unless it ends in `$` and goes on in the next; `$$` begins a comment.

use super::Text;
use crate::base::message::Place;

/// A record: `label = MAJOR/field, field, ...`.
#[derive(Debug, Default)]
pub(super) struct Record {
    text: String,
    /// Where pieces of it stand: byte of the record, line, byte of the line.
    pieces: Vec<(usize, usize, usize)>,
}

/// A part of a record, with the byte at which it begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Part<'a> {
    pub text: &'a str,
    at: usize,
}

impl Part<'_> {
    fn trimmed(text: &str, at: usize) -> Part<'_> {
        Part { text: text.trim(), at: at + text.len() - text.trim_start().len() }
    }
}

/// All records of a file.
pub(super) fn records(text: &Text) -> Vec<Record> {
    let mut all = Vec::new();
    let mut open = Record::default();
    for (i, line) in text.lines.iter().enumerate() {
        if line.trim_start().starts_with("$$") {
            continue;
        }
        let end = line.trim_end();
        let goes_on = end.strip_suffix('$');
        open.pieces.push((open.text.len(), i + 1, 0));
        open.text.push_str(goes_on.unwrap_or(end));
        if goes_on.is_none() {
            all.extend(Some(std::mem::take(&mut open)).filter(|record| !record.text.trim().is_empty()));
        }
    }
    all.extend(Some(open).filter(|record| !record.text.trim().is_empty()));
    all
}

impl Record {
    /// First line of the record.
    pub fn line(&self) -> usize {
        self.pieces.first().map_or(1, |piece| piece.1)
    }

    /// Label (as it stands before `=`), major word and fields.
    pub fn parts(&self) -> (Option<Part<'_>>, &str, Vec<Part<'_>>) {
        let slash = self.text.find('/').unwrap_or(self.text.len());
        let (head, tail) = self.text.split_at(slash);
        let (label, major) = match head.split_once('=') {
            Some((label, major)) => (Some(Part::trimmed(label, 0)), major),
            None => (None, head),
        };
        let fields = tail.strip_prefix('/').map_or(Vec::new(), |fields| split(fields, slash + 1));
        (label, major.trim(), fields)
    }

    /// Where a part stands.
    pub fn place(&self, text: &Text, part: &Part) -> Place {
        let before = self.pieces.partition_point(|piece| piece.0 <= part.at);
        let (start, line, byte) = self.pieces.get(before.saturating_sub(1)).copied().unwrap_or((0, 1, 0));
        text.part(line, byte + part.at - start.min(part.at), part.text.chars().count())
    }
}

/// Fields between commas that stand outside quotes.
fn split(text: &str, at: usize) -> Vec<Part<'_>> {
    let (mut fields, mut start, mut quoted) = (Vec::new(), 0, false);
    for (i, c) in text.char_indices() {
        match c {
            '\'' => quoted = !quoted,
            ',' if !quoted => {
                fields.push(Part::trimmed(&text[start..i], at + start));
                start = i + 1;
            }
            _ => {}
        }
    }
    fields.push(Part::trimmed(&text[start..], at + start));
    fields
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn records_go_on_over_lines_and_know_where_their_fields_stand() {
        let lines = vec!["$$ FA(X)=1/2 $", "FA(A 1) = FEAT/CIRCLE, 'a,b', $", "  50.5,$", "-1", "", "ENDFIL"];
        let text = Text { file: "f", lines };
        let all = records(&text);
        assert_eq!(all.len(), 2);
        let (label, major, fields) = all[0].parts();
        assert_eq!((label.map(|l| l.text), major), (Some("FA(A 1)"), "FEAT"));
        assert_eq!(fields.iter().map(|f| f.text).collect::<Vec<_>>(), ["CIRCLE", "'a,b'", "50.5", "-1"]);
        let place = all[0].place(&text, &fields[2]);
        assert_eq!((place.line, place.column, place.width), (Some(3), Some(3), 4));
        assert_eq!(all[1].parts().1, "ENDFIL");
    }
}

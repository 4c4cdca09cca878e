//! What was read: every input with its checksum, and every row that was refused or met no partner.

use super::sheet::Sheet;
use crate::document::{ImportDocument, Refused, Source};
use std::collections::BTreeMap;

/// `inputs` are the checksums of all that the numbers come from.
pub(super) fn sheets(document: &ImportDocument, inputs: &BTreeMap<String, String>) -> Vec<Sheet> {
    let refused: Vec<(&Source, &Refused)> =
        document.sources.iter().flat_map(|s| s.refused.iter().map(move |r| (s, r))).collect();
    let others = [
        Sheet::of(
            "Refused rows",
            &refused,
            &[
                ("file", "", |(s, _)| s.file.as_str().into()),
                ("line", "", |(_, r)| r.line.into()),
                ("reason", "", |(_, r)| r.reason.as_str().into()),
                ("text", "", |(_, r)| r.text.as_str().into()),
            ],
        ),
        Sheet::of(
            "Without partner",
            &document.unmatched,
            &[
                ("file", "", |u| u.file.as_str().into()),
                ("line", "", |u| u.line.into()),
                ("key", "", |u| u.key.as_str().into()),
                ("reason", "", |u| u.reason.as_str().into()),
            ],
        ),
    ];
    let mut sheets = vec![files(document, inputs)];
    sheets.extend(others.into_iter().filter(|s| !s.rows.is_empty()));
    sheets
}

/// Checksums alone.
pub(super) fn checksums(inputs: &BTreeMap<String, String>) -> Sheet {
    let rows: Vec<(&String, &String)> = inputs.iter().collect();
    Sheet::of("Inputs", &rows, &[("file", "", |r| r.0.as_str().into()), ("SHA-256", "", |r| r.1.as_str().into())])
}

fn files(document: &ImportDocument, inputs: &BTreeMap<String, String>) -> Sheet {
    let source = |name: &str| document.sources.iter().find(|s| s.file == name);
    let rows: Vec<(&str, &str, Option<&Source>)> =
        inputs.iter().map(|(name, sha256)| (name.as_str(), sha256.as_str(), source(name))).collect();
    Sheet::of(
        "Inputs",
        &rows,
        &[
            ("file", "", |r| r.0.into()),
            ("SHA-256", "", |r| r.1.into()),
            ("kind", "", |r| r.2.map(|s| s.kind.as_str()).into()),
            ("bytes", "", |r| r.2.map(|s| s.bytes).into()),
            ("read as", "", |r| r.2.map(|s| s.dialect.as_str()).into()),
            ("rows", "", |r| r.2.map(|s| s.rows_read).into()),
            ("refused", "", |r| r.2.map(|s| s.refused.len()).into()),
        ],
    )
}

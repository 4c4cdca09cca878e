//! Recorded motions: characteristics in tables, and their pictures.

use super::paper::{Block, Section};
use crate::document::Iso9283StreamsDocument;
use crate::report::streams;
use crate::report::words::Words;

pub(super) fn section(document: &Iso9283StreamsDocument, words: &Words) -> Option<Section> {
    let mut blocks = Vec::new();
    for stream in streams::sections(document, words) {
        blocks.push(Block::heading(stream.name));
        blocks.push(Block::Facts { rows: stream.facts });
        if !stream.settling.is_empty() {
            let titles = ["#pose", "#arrivals", "#stabilisation time, s", "#overshoot, µm"];
            blocks.push(Block::table(words, &titles, stream.settling));
        }
        if !stream.corners.is_empty() {
            let titles = ["corner, mm", "#round-off CR, µm", "#overshoot CO, µm"];
            blocks.push(Block::table(words, &titles, stream.corners));
        }
        blocks.extend(Block::pictures(stream.pictures));
        blocks.push(Block::note(format!("{}.", stream.conventions.join("; "))));
    }
    Section::of("streams", words.say("Recorded motion"), blocks)
}

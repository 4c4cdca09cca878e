//! Repeatability: table 2.1 of the thesis, the quarter rule, approaches, poses, coplanarity and pictures.

use super::paper::{Block, Section};
use crate::document::Iso9283Document;
use crate::report::iso9283;
use crate::report::words::Words;

pub(super) fn section(document: &Iso9283Document, words: &Words) -> Option<Section> {
    let found = iso9283::section(document, words);
    let titles = ["#pose", "#visits", "#sphere x, y, z", "#circle x, y", "#x, y, z (RP)", "#x, y", "#x", "#y", "#z"];
    let groups =
        [("", 2), ("smallest that holds all, radius in µm", 2), ("mean + 3 s of the distance from the mean, µm", 5)];
    let source = words.say("Thesis, table 2.1 (eq. 2.7 to 2.10).");
    let note = format!("{source} {}.", document.conventions.join("; "));
    let mut blocks = vec![Block::grouped(words, &groups, &titles, found.rows), Block::note(note)];
    if !found.quarter.is_empty() {
        blocks.push(Block::heading(words.say("Is the instrument good enough?")));
        blocks.push(Block::strong(found.quarter_sentence));
        blocks.push(Block::note(
            words.say("ISO 9283: its expanded uncertainty may be at most a quarter of what it verifies."),
        ));
        let rows = found.quarter.into_iter().map(|[pose, ratio, met]| [pose, ratio, words.say(&met)]);
        blocks.push(Block::table(words, &["#pose", "#U over RP", "25 % rule"], rows));
    }
    if !found.approaches.is_empty() {
        blocks.push(Block::heading(words.say("By approach")));
        blocks.extend(found.between.into_iter().map(Block::text));
        let groups = [("", 3), ("its mean from that of all, µm", 3), ("", 2)];
        let titles = ["#pose", "approached", "#visits", "#x", "#y", "#z", "#RP, µm", "#sphere, µm"];
        blocks.push(Block::grouped(words, &groups, &titles, found.approaches));
    }
    if !found.places.is_empty() {
        blocks.push(Block::heading(words.say("Poses")));
        let note = words.say("Mean of the attained positions in the world frame. The campaign commands no positions: accuracy (AP) is not tested.");
        blocks.push(Block::note(note));
        blocks.push(Block::table(words, &["#pose", "#visits", "#x, mm", "#y, mm", "#z, mm"], found.places));
    }
    blocks.extend(Block::pictures(found.pictures));
    if !found.coplanar.is_empty() {
        blocks.push(Block::heading(words.say("Coplanarity")));
        let titles = ["#pose", "#mean position from the plane of the other three, µm"];
        blocks.push(Block::table(words, &titles, found.coplanar));
    }
    Section::of("repeatability", words.say("Repeatability"), blocks)
}

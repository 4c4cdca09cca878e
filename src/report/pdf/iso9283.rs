//! Tests by ISO 9283: accuracy, table 2.1 of the thesis, the quarter rule, approaches, poses, drift, compliance.

use super::paper::{Block, Section};
use crate::document::{Characteristics, Iso9283Document};
use crate::report::iso9283;
use crate::report::part::Part;
use crate::report::words::Words;

/// Its sections, in the order of reading; recorded motions stand between them and static compliance.
pub(super) fn sections(tested: &Characteristics, words: &Words) -> Vec<Section> {
    let poses = tested.poses.iter().flat_map(|d| poses(d, words));
    let streams = tested.streams.iter().filter_map(|d| super::streams::section(d, words));
    let loads = iso9283::compliance(tested.compliance.as_ref(), words);
    let loads = Section::of("compliance", words.say("Static compliance"), blocks(loads));
    poses.chain(streams).chain(loads).collect()
}

fn poses(document: &Iso9283Document, words: &Words) -> Vec<Section> {
    let mut found = iso9283::section(document, words);
    let (accuracy, drift) = (std::mem::take(&mut found.accuracy), std::mem::take(&mut found.drift));
    let sections = [
        Section::of("accuracy", words.say("Accuracy"), blocks(accuracy)),
        Section::of("repeatability", words.say("Repeatability"), repeatability(found, words)),
        Section::of("drift", words.say("Drift"), blocks(drift)),
    ];
    sections.into_iter().flatten().collect()
}

fn blocks(parts: Vec<Part>) -> Vec<Block> {
    parts.into_iter().flat_map(Block::part).collect()
}

fn repeatability(found: iso9283::Section, words: &Words) -> Vec<Block> {
    let titles = ["#pose", "#visits", "#sphere x, y, z", "#circle x, y", "#x, y, z (RP)", "#x, y", "#x", "#y", "#z"];
    let groups =
        [("", 2), ("smallest that holds all, radius in µm", 2), ("mean + 3 s of the distance from the mean, µm", 5)];
    let source = words.say("Thesis, table 2.1 (eq. 2.7 to 2.10).");
    let note = format!("{source} {}.", found.document.conventions.join("; "));
    let mut blocks = vec![Block::grouped(words, &groups, &titles, found.rows), Block::note(note)];
    blocks.extend(self::blocks(found.judged));
    if !found.approaches.is_empty() {
        blocks.push(Block::heading(words.say("By approach")));
        blocks.push(Block::note(
            words.say("vAP: largest distance between the means of two approaches (ISO 9283:1998, 7.2.3)."),
        ));
        blocks.extend(found.between.into_iter().map(Block::text));
        let groups = [("", 3), ("its mean from that of all, µm", 3), ("", 2)];
        let titles = ["#pose", "approached", "#visits", "#x", "#y", "#z", "#RP, µm", "#sphere, µm"];
        blocks.push(Block::grouped(words, &groups, &titles, found.approaches));
        blocks.extend(self::blocks(found.turned));
    }
    if !found.places.is_empty() {
        blocks.push(Block::heading(words.say("Poses")));
        blocks.push(Block::note(found.places_note));
        blocks.push(Block::table(words, &["#pose", "#visits", "#x, mm", "#y, mm", "#z, mm"], found.places));
    }
    blocks.extend(Block::pictures(found.pictures));
    if !found.coplanar.is_empty() {
        blocks.push(Block::heading(words.say("Coplanarity")));
        let titles = ["#pose", "#mean position from the plane of the other three, µm"];
        blocks.push(Block::table(words, &titles, found.coplanar));
    }
    blocks
}

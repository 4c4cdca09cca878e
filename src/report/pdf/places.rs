//! The world frame and the features that it is made from.

use super::paper::{Block, Section};
use crate::base::pose::Vector;
use crate::document::{Feature, FeaturesDocument, WorldFrame};
use crate::report::number::{fixed, significant};
use crate::report::words::Words;

pub(super) fn section(features: &FeaturesDocument, world: &WorldFrame, words: &Words) -> Option<Section> {
    let facts = Block::Facts { rows: frame(world, words) };
    let mut blocks = vec![Block::heading(words.say("World frame")), facts, Block::heading(words.say("Features"))];
    let titles =
        ["name", "element", "#points", "#point in mm", "#direction", "#radius, mm", "#RMS, mm", "#max, mm", "#u, mm"];
    blocks.push(match features.features.is_empty() {
        true => Block::text(words.say("The campaign fits no features.")),
        false => Block::table(words, &titles, features.features.iter().map(|f| feature(f, words))),
    });
    Section::of("frames", words.say("Frames and features"), blocks)
}

fn frame(world: &WorldFrame, words: &Words) -> Vec<[String; 2]> {
    let seen = if world.planar { words.say("projected into the xy plane") } else { words.say("in space") };
    let mut facts = vec![[words.say("definition"), world.definition.clone()], [words.say("observations"), seen]];
    let mm = |v: f64| format!("{} mm", significant(v, 3));
    facts.extend(world.rms_mm.map(|v| [words.say("targets from their places"), format!("RMS {}", mm(v))]));
    facts.extend(world.max_mm.map(|v| [words.say("largest distance"), mm(v)]));
    facts.push(match &world.poses[..] {
        [only] => [words.say("origin in the exports"), format!("{} mm", triple(only.export_T_world.translation_mm, 4))],
        poses => [words.say("measured"), words.fill("{0} times, once for each pose and cycle", &[&poses.len()])],
    });
    facts
}

fn feature(f: &Feature, words: &Words) -> [String; 9] {
    [
        f.name.clone(),
        words.say(&f.element),
        f.points.to_string(),
        triple(f.point_mm, 4),
        triple(f.direction, 6),
        f.radius_mm.map_or_else(String::new, |r| fixed(r, 4)),
        significant(f.rms_mm, 3),
        significant(f.max_mm, 3),
        f.standard_uncertainty_mm.map_or_else(String::new, |u| significant(u, 2)),
    ]
}

fn triple(v: Vector, decimals: usize) -> String {
    v.map(|v| fixed(v, decimals)).join(", ")
}

//! The report of a comparison of campaigns.

use super::paper::{Block, Labels, Paper, Section, Verdict};
use super::stated;
use crate::base::message::{Message, one_line};
use crate::document::{CompareDocument, Presentation};
use crate::report::compare::{self, Family};
use crate::report::words::Words;

/// Rows of a table that are printed: nobody reads more on paper, and the attached document has all.
const LIMIT: usize = 200;
/// Campaigns whose values stand beside each other.
const BESIDE: usize = 5;

/// What stands in it, in the order of reading.
pub(super) fn paper(document: &CompareDocument, presentation: &Presentation, words: &Words) -> Paper {
    let found = compare::contents(document, words);
    let (messages, more) = stated::messages(&document.messages.iter().collect::<Vec<&Message>>(), words);
    let titles = ["#number", "campaign", "date", "instrument", "folder"];
    let campaigns = vec![Block::table(words, &titles, found.campaigns)];
    let mut rules: Vec<Block> = found.together.into_iter().map(Block::text).collect();
    rules.extend(document.conventions.iter().map(Block::note));
    let mut sections = vec![
        Section::of("campaigns", words.say("Campaigns"), campaigns),
        Section::of("rules", words.say("How changes are judged"), rules),
        messages,
    ];
    sections.extend(found.families.into_iter().map(|family| quantities(family, words)));
    if found.undrawn > 0 {
        let told = words.fill("{0} more quantities have no picture: the tables have them all.", &[&found.undrawn]);
        sections.push(Section::of("undrawn", words.say("Pictures"), vec![Block::note(told)]));
    }
    let inputs = vec![stated::checksums(&document.provenance.inputs, words)];
    sections.push(Section::of("inputs", words.say("Inputs"), inputs));
    let synthetic: Vec<String> =
        found.synthetic.iter().map(|[folder, why]| format!("{}: {why}", one_line(folder))).collect();
    Paper {
        title: words.say("What changed"),
        subtitle: found.lead,
        synthetic: (!synthetic.is_empty()).then(|| synthetic.join("; ")),
        date: document.campaigns.iter().rev().find_map(|c| c.date.clone()),
        version: document.provenance.version.clone(),
        labels: Labels::of(presentation, words),
        verdict: Verdict {
            class: found.class,
            sentences: vec![found.sentence],
            about: String::new(),
            headlines: vec![],
        },
        sections: sections.into_iter().flatten().collect(),
        annexes: more.into_iter().collect(),
    }
}

/// Changes, pictures, and the values of every campaign.
fn quantities(family: Family, words: &Words) -> Option<Section> {
    let left_out = |rows: usize| {
        let more = rows.saturating_sub(LIMIT);
        (more > 0).then(|| {
            Block::note(words.fill("{0} more rows are left out: the attached compare.json has all.", &[&more]))
        })
    };
    let titles = ["quantity", "campaign", "#change", "#95 % interval", "#p", "#p by Holm", "verdict"];
    let mut blocks = vec![Block::heading(words.say("Changes"))];
    blocks.extend(left_out(family.changes.len()));
    blocks.push(Block::table(words, &titles, family.changes.into_iter().take(LIMIT)));
    blocks.extend(Block::pictures(family.pictures));
    blocks.push(Block::heading(words.say("Values of every campaign")));
    blocks.extend(left_out(family.values.len()));
    let campaigns = family.values.first().map_or(0, |row| row.len().saturating_sub(2));
    for from in (0..campaigns).step_by(BESIDE) {
        let to = campaigns.min(from + BESIDE);
        let numbered: Vec<String> = (from..to).map(|i| format!("#{} [95 %]", i + 1)).collect();
        let titles: Vec<&str> = ["quantity", "unit"].into_iter().chain(numbered.iter().map(String::as_str)).collect();
        let row = |row: &Vec<String>| -> Vec<String> {
            row.iter().take(2).chain(row.iter().skip(2 + from).take(to - from)).cloned().collect()
        };
        blocks.push(Block::table(words, &titles, family.values.iter().take(LIMIT).map(row)));
    }
    Section::of("quantities", family.name, blocks)
}

//! Recognition of tables that etalon writes or documents, by the names of their columns.

use super::lines::Proposal;
use super::statements::{Line, Lines};
use crate::dialect::quoted;
use crate::logs::meaning;
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_tables::{Decimal, Delimiter};

/// Table of etalon, with the proposed lines.
pub(super) struct NativeTable {
    pub kind: &'static str,
    pub what: Phrase,
    pub lines: Lines,
    pub question: Option<Phrase>,
}

/// Lines of the tables of a test that another file contains.
const ATTAINED: &str = "attained = \"?\"             # the table of attained poses\n";
const COMMANDED: &str = "commanded = \"?\"            # the table of commanded poses\n";
/// Columns of positions and angles in tests of poses.
const POSITION: [&str; 6] = ["x_mm", "y_mm", "z_mm", "a_deg", "b_deg", "c_deg"];

/// Returns the table with these columns.
pub(super) fn recognise(proposal: &Proposal, joints: &[usize]) -> Option<NativeTable> {
    let names: Vec<&str> = proposal.table.columns.iter().map(|c| c.name.as_deref()).collect::<Option<_>>()?;
    let has = |name: &str| names.contains(&name);
    let only = |known: &[&str]| names.iter().all(|name| known.contains(name) || POSITION.contains(name));
    let placed = has("x_mm") && has("y_mm");
    let file = quoted(proposal.file);
    let read = Line::File(proposal.file.to_owned());
    let form = &proposal.best.form;
    let plain =
        form.delimiter == Some(Delimiter::Comma) && form.decimal() == Decimal::Point && form.thousands.is_none();
    let thousands = form.thousands.map_or(String::new(), |mark| format!("thousands = {:?}\n", mark.name()));
    let native =
        |kind: &'static str, what: Phrase, lines: Lines| Some(NativeTable { kind, what, lines, question: None });
    let joint = |i: &usize| meaning(names[*i]).is_some() && names[*i].rsplit_once('_').is_some();
    let observed = placed || has("distance_mm") || has("socket") || has("kind");
    if joints.len() >= 2 && joints.iter().all(joint) && observed && (has("pose") || has("kind")) && has("target") {
        let state = match (&form.sheet, plain) {
            (Some(sheet), _) => format!("sheet = {}\n", quoted(sheet)),
            (None, true) => String::new(),
            (None, false) => format!(
                "delimiter = {:?}\ndecimal = {:?}\n{thousands}",
                form.delimiter.map_or(",", Delimiter::name),
                form.decimal().name()
            ),
        };
        let angles = has("a_deg") || has("a_rad");
        let order = if angles { "orientation = \"?\"          # the order of the angles, e.g. \"zyx\"\n" } else { "" };
        return native(
            "observations",
            phrase!("is-observations"),
            Lines::section("observations").with(read).with_text(state).with_text(order),
        );
    }
    if !plain || !joints.is_empty() || !placed {
        return None;
    }
    if has("force_n") && has("direction") && only(&["direction", "cycle", "force_n"]) {
        return native("loads", phrase!("is-compliance-test"), Lines::section("compliance").with(read));
    }
    if has("time_s") && only(&["time_s"]) {
        let mut recording = native(
            "recording",
            phrase!("is-recorded-motion"),
            Lines::element("stream").with_text("name = \"motion\"\n").with(read),
        )?;
        recording.question = Some(phrase!("ask-recorded-motion"));
        return Some(recording);
    }
    if has("pose") && has("cycle") && only(&["pose", "cycle", "approach", "robot", "reading"]) {
        let lines = Lines::section("poses").with_text(format!("attained = {file}\n{COMMANDED}"));
        return native("poses", phrase!("is-attained-poses"), lines);
    }
    if has("pose") && only(&["pose"]) {
        let lines = Lines::section("poses").with_text(format!("{ATTAINED}commanded = {file}\n"));
        return native("commanded", phrase!("is-commanded-poses"), lines);
    }
    if has("cycle") && has("target") && only(&["cycle", "target"]) {
        let lines = Lines::section("poses").with_text(format!("{ATTAINED}{COMMANDED}reference = {file}\n"));
        return native("reference", phrase!("is-reference-targets"), lines);
    }
    None
}

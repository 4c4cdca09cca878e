//! Test of a loaded controller file at one pose, and the way back to the file before.

use crate::model::{Block, Columns, Section, Table, Text, fixed};
use crate::number::{self, derived};
use crate::words::{Words, tr};
use etalon_base::phrase;
use etalon_documents::{
    DisplayedPose, FileInput, InputsCheck, LoadingCheck, ReadingQuantity, Results, RobotLinks, Source, SourceKind,
    WrittenFile,
};

/// Decimals of positions (mm).
const DECIMALS: usize = 3;

/// A displayed pose with its name.
struct Row {
    name: String,
    pose: DisplayedPose,
}

/// Section for the file to load; `None` without such a file.
pub(super) fn section(results: &Results, words: &Words) -> Option<Section> {
    let name = results.verdict.loading.as_ref()?.file.as_ref()?;
    let file = results.campaign.controller_files.iter().find(|written| written.file == *name)?;
    let mut section = Section::new("way-back", tr!(words, "way-back-title"));
    let moved = file.check.as_ref().map(|check| {
        let change = words.fixed(check.change_mm(), DECIMALS);
        (tr!(words, "way-back-moved"), tr!(words, "way-back-moved-by", change, pose = check.pose).into())
    });
    let facts = [
        (tr!(words, "way-back-file"), backup(results, words).into()),
        (tr!(words, "way-back-loaded"), loaded(file).into()),
    ];
    section.push(Block::facts(facts.into_iter().chain(moved).collect()));
    if backup_source(results).is_some() {
        section.push(Block::text(tr!(words, "way-back-unread")));
    }
    match &file.check {
        Some(check) => at_pose(&mut section, Shown { check, file, links: links(results) }, words),
        None => section.push(Block::text(tr!(words, "way-back-without-display"))),
    }
    section.push(Block::text(tr!(words, "way-back-verify")));
    if file.check.as_ref().is_some_and(|check| !check.mastered_joint_values.is_empty()) {
        section.push(Block::text(tr!(words, "way-back-verify-mastered", file = file.file)));
    }
    section.whole()
}

/// Links at base and ends of the chain.
fn links(results: &Results) -> Option<&RobotLinks> {
    results.identified.as_ref()?.parameters.links.as_ref()
}

/// File of the controller before loading, whose values are not read.
fn backup_source(results: &Results) -> Option<&Source> {
    results.import.sources.iter().find(|source| source.kind == SourceKind::Backup)
}

/// File of the controller before loading, with its checksum.
fn backup(results: &Results, words: &Words) -> String {
    match backup_source(results) {
        Some(source) => tr!(words, "file-with-hash", file = source.file, sha256 = source.sha256),
        None => tr!(words, "way-back-not-stated"),
    }
}

/// File to load, with its checksum.
fn loaded(file: &WrittenFile) -> String {
    file.sha256.iter().fold(file.file.clone(), |name, sha256| format!("{name}, SHA-256 {sha256}"))
}

/// Pose before and after loading a file, with the links between which it is.
#[derive(Clone, Copy)]
struct Shown<'a> {
    check: &'a LoadingCheck,
    file: &'a WrittenFile,
    links: Option<&'a RobotLinks>,
}

impl Shown<'_> {
    /// `true` if a controller displays the pose: the file is for one, and its base stands still.
    fn is_on_display(self) -> bool {
        self.file.is_for_controllers && !self.links.is_some_and(|links| links.base_moves)
    }

    /// Sentences on the links of base frame and flange, and on a base that moves.
    fn frames(self, words: &Words) -> Vec<String> {
        let Some(RobotLinks { base, ends, base_moves }) = self.links else { return Vec::new() };
        let link = self.check.link.as_ref().or(ends.first());
        let named = link.map(|link| tr!(words, "way-back-links", base, link));
        named.into_iter().chain(base_moves.then(|| tr!(words, "way-back-base-moves", base))).collect()
    }
}

/// Value of an input at which the announced poses are computed.
fn neutral(input: &FileInput, words: &Words) -> String {
    let value = words.unrounded(input.neutral);
    format!("{} {value} {}", words.tr(&input.quantity.phrase()), input.quantity.unit())
}

/// Sentence on the pose with all inputs of a reading.
fn evaluated(check: &LoadingCheck, found: &InputsCheck, words: &Words) -> String {
    let decimals = LoadingCheck::JOINT_DECIMALS;
    let shown = |value: f64, decimals: usize| words.decimal(format!("{value:.decimals$}"));
    let joints = check.joints.iter().zip(&found.joint_values);
    let joints: Vec<String> = joints.map(|(name, value)| format!("{name} = {}", shown(*value, decimals))).collect();
    let inputs = found.inputs.iter().map(|(name, value)| format!("{name} = {}", words.decimal(derived(*value))));
    let [x, y, z] = found.after.xyz_mm.map(|v| shown(v, DECIMALS));
    let inputs = inputs.collect::<Vec<_>>().join("; ");
    let effect = number::fixed(found.effect_mm, 2);
    tr!(words, "way-back-evaluated", pose = found.pose, joints = joints.join("; "), inputs, x, y, z, effect)
}

/// Adds the pose on the display before and after loading.
fn at_pose(section: &mut Section, shown: Shown, words: &Words) {
    let Shown { check, file, links } = shown;
    let decimals = LoadingCheck::JOINT_DECIMALS;
    let joint = |(name, value): (&String, &f64)| format!("{name} = {}", words.decimal(format!("{value:.decimals$}")));
    let listed = |values: &[f64]| check.joints.iter().zip(values).map(joint).collect::<Vec<_>>().join("; ");
    let joints = listed(&check.joint_values);
    section.push(Block::text(match shown.is_on_display() {
        true => tr!(words, "way-back-test", pose = check.pose, joints),
        false => tr!(words, "way-back-test-software", pose = check.pose, joints),
    }));
    shown.frames(words).into_iter().for_each(|text| section.push(Block::text(text)));
    let rows = [
        Row { name: tr!(words, "way-back-before"), pose: check.before },
        Row { name: tr!(words, "way-back-after"), pose: check.after },
    ];
    let columns = Columns::<Row>::new().both(phrase!("way-back-display"), "", |r| Text::from(r.name.clone()));
    let columns = ["x", "y", "z"]
        .into_iter()
        .enumerate()
        .fold(columns, |columns, (axis, name)| columns.both(name, "mm", move |r| fixed(r.pose.xyz_mm[axis], DECIMALS)));
    let columns = ["qw", "qx", "qy", "qz"]
        .into_iter()
        .enumerate()
        .fold(columns, |columns, (part, name)| columns.both(name, "", move |r| fixed(r.pose.quaternion[part], 6)));
    section.push(Block::Table(Table::new(words, &rows, columns).on(phrase!("sheet-way-back"))));
    // without mass, its centre has no effect
    let inputs = file.inputs.iter().filter(|input| input.quantity != ReadingQuantity::PayloadCentre);
    let mut inputs: Vec<String> = inputs.map(|input| neutral(input, words)).collect();
    inputs.dedup();
    if !inputs.is_empty() {
        section.push(Block::text(tr!(words, "way-back-inputs", inputs = inputs.join(", "))));
    }
    if let Some(found) = &check.with_inputs {
        section.push(Block::text(evaluated(check, found, words)));
    }
    if !check.mastered_joint_values.is_empty() {
        let joints = listed(&check.mastered_joint_values);
        section.push(Block::text(tr!(words, "way-back-mastered", joints)));
    }
    // programs of poses are corrected for one chain on a base that stands still
    if !file.is_for_controllers && check.link.is_none() && !links.is_some_and(|links| links.base_moves) {
        section.push(Block::text(tr!(words, "way-back-compensated")));
    }
    if let Some(mm) = check.tolerance_mm {
        let [tolerance, change] = [mm, check.change_mm()].map(|mm| words.fixed(mm, 2));
        section.push(Block::text(match check.change_mm() > 2.0 * mm {
            true => tr!(words, "way-back-tolerance", tolerance),
            false => tr!(words, "way-back-change-too-small", tolerance, change),
        }));
    }
    section.push(Block::text(tr!(words, "way-back-restore")));
    if check.link.is_none() {
        section.push(Block::text(tr!(words, "way-back-other-poses", file = file.file)));
    }
}

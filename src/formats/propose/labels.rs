//! Form of the labels of an export: which part names the target, the pose and the cycle.

use super::headings::{Word, stands_for};
use crate::export::Pattern;
use etalon_base::pose_name::PoseName;
use std::collections::{BTreeMap, BTreeSet};

/// Forms of labels that are tried.
const LABELS: [&str; 8] = [
    "{target}_{pose}_{cycle}",
    "{target}-{pose}-{cycle}",
    "{target}_{pose}",
    "{target}-{pose}",
    "{pose}_{target}",
    "P{pose}_{target}",
    "{target}{pose}",
    "P{pose}",
];
/// Form of a label that is the number of its pose.
pub(super) const NUMBER: &str = "{pose}";
/// Form of labels that name a target and no pose.
pub(super) const ALONE: &str = "{target}";
/// Maximum number of targets that labels name without a pose, and of stationary points.
pub(super) const MOST_TARGETS: usize = 12;
/// Points that do not move with the robot have fewer names that could be poses than this part of
/// the poses of the others.
pub(super) const FEWER: usize = 5;
/// Abbreviations of "pose" in labels, which are too short for a heading.
const POSES: [&str; 4] = ["p", "pos", "position", "posn"];
/// Abbreviations of "cycle" in labels. A letter alone may name a target.
const CYCLES: [&str; 2] = ["wdh", "cyc"];

/// Form of labels, the targets that they name, and the labels of stationary points among them.
pub(super) struct Labels {
    pub form: String,
    pub targets: Vec<String>,
    pub still: Vec<String>,
}

impl Labels {
    /// Finds the form of all labels, or of all except the labels of a few points; a target that few
    /// poses name is stationary.
    pub fn new(labels: &[String]) -> Option<Self> {
        if let Some((form, targets)) = label_form(labels) {
            return Some(Self::with_form(labels, form, targets));
        }
        LABELS.iter().filter(|form| form.contains("{pose}")).find_map(|form| {
            let pattern = Pattern::parse(form).ok()?;
            let (of_form, others): (Vec<String>, Vec<String>) =
                labels.iter().cloned().partition(|label| pattern.read(label, |_| false).is_some());
            let still: BTreeSet<String> = others.into_iter().collect();
            let (found, targets) =
                label_form(&of_form).filter(|_| of_form.len() * FEWER > labels.len() * (FEWER - 1))?;
            (found == *form && still.len() <= MOST_TARGETS).then(|| {
                let all = Self::with_form(&of_form, found, targets);
                Self { still: still.into_iter().chain(all.still).collect(), ..all }
            })
        })
    }

    fn with_form(labels: &[String], form: String, targets: Vec<String>) -> Self {
        let mut poses: BTreeMap<String, BTreeSet<PoseName>> = BTreeMap::new();
        let pattern = Pattern::parse(&form).ok();
        let read = |label: &String| pattern.as_ref().and_then(|pattern| pattern.read(label, |_| false));
        for named in labels.iter().filter_map(read) {
            poses.entry(named.target.unwrap_or_default()).or_default().extend(named.pose);
        }
        let most = poses.values().map(BTreeSet::len).max().unwrap_or(0);
        let is_still = |target: &String| poses.get(target).is_some_and(|of| !of.is_empty() && of.len() * FEWER <= most);
        let (at_rest, targets): (Vec<String>, Vec<String>) = targets.into_iter().partition(is_still);
        let of_rest =
            |label: &&String| read(label).and_then(|named| named.target).is_some_and(|t| at_rest.contains(&t));
        let still: BTreeSet<String> = labels.iter().filter(of_rest).cloned().collect();
        Self { form, targets, still: still.into_iter().collect() }
    }
}

/// Returns the form that all labels have, and the targets that they name.
///
/// A word for the pose beside a number (`Ball1@Pos3`) decides; labels without such a word have the
/// first usual form that fits.
pub fn label_form(labels: &[impl AsRef<str>]) -> Option<(String, Vec<String>)> {
    let of = |form: &str| {
        let pattern = Pattern::parse(form).ok()?;
        let named: Vec<_> =
            labels.iter().map(|label| pattern.read(label.as_ref(), |_| false)).collect::<Option<_>>()?;
        let targets: BTreeSet<String> = named.iter().filter_map(|named| named.target.clone()).collect();
        let poses: BTreeSet<_> = named.iter().filter_map(|named| named.pose).collect();
        let few = poses.len() * 2 < labels.len() / targets.len().max(1) && !form.contains("{cycle}");
        // a number of many rows names a point or a cycle
        let again = form == NUMBER && poses.len() < labels.len();
        (!few && !again && targets.len() * 3 <= labels.len()).then(|| (form.to_owned(), targets.into_iter().collect()))
    };
    let by_word = by_words(labels);
    if let Some(form) = &by_word {
        return of(form);
    }
    let forms = if are_numbers(labels) { &[NUMBER][..] } else { &LABELS[..] };
    forms.iter().copied().find_map(of).or_else(|| targets_alone(labels))
}

/// Part of a label: letters, digits, or marks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Letters,
    Digits,
    Marks,
}

/// Parts of a label.
fn parts(label: &str) -> Vec<(Kind, &str)> {
    let kind = |c: char| match () {
        () if c.is_ascii_digit() => Kind::Digits,
        () if c.is_alphabetic() => Kind::Letters,
        () => Kind::Marks,
    };
    let mut all: Vec<(Kind, &str)> = Vec::new();
    let mut from = 0;
    let mut last: Option<Kind> = None;
    for (at, c) in label.char_indices() {
        if let Some(before) = last.filter(|before| *before != kind(c)) {
            all.push((before, &label[from..at]));
            from = at;
        }
        last = Some(kind(c));
    }
    all.extend(last.map(|kind| (kind, &label[from..])));
    all
}

/// Returns the form of labels of equal parts in which one word before a number stands for the pose.
/// The other parts that vary name the target; a number alone between marks is the cycle.
fn by_words(labels: &[impl AsRef<str>]) -> Option<String> {
    let all: Vec<Vec<(Kind, &str)>> = labels.iter().map(|label| parts(label.as_ref())).collect();
    let first = all.first().filter(|_| all.len() > 2)?;
    let alike = |other: &Vec<(Kind, &str)>| {
        other.len() == first.len()
            && other.iter().zip(first).all(|(a, b)| a.0 == b.0 && (a.0 != Kind::Marks || a.1 == b.1))
    };
    if !all.iter().all(alike) {
        return None;
    }
    let varies = |at: usize| all.iter().any(|label| label[at].1 != first[at].1);
    let is_word = |at: usize, meaning: Word, short: &[&str]| {
        let word = first[at].1.to_lowercase();
        first[at].0 == Kind::Letters && !varies(at) && (short.contains(&&*word) || stands_for(&word, meaning))
    };
    // the word before a number, perhaps with marks between them
    let word_before = |at: usize| {
        let before = at.checked_sub(1)?;
        if first[before].0 == Kind::Marks { before.checked_sub(1) } else { Some(before) }
    };
    let numbered = |meaning: Word, short: &[&str]| {
        let fits =
            |at: &usize| first[*at].0 == Kind::Digits && word_before(*at).is_some_and(|w| is_word(w, meaning, short));
        (0..first.len()).filter(fits).collect::<Vec<usize>>()
    };
    let [pose] = numbered(Word::Pose, &POSES)[..] else { return None };
    let mut cycle = numbered(Word::Cycle, &CYCLES).into_iter().find(|at| *at != pose);
    let words: Vec<usize> = [Some(pose), cycle].into_iter().flatten().filter_map(word_before).collect();
    let is_free = |at: usize, cycle: Option<usize>| {
        at != pose && Some(at) != cycle && !words.contains(&at) && first[at].0 != Kind::Marks
    };
    let has_letters = (0..first.len()).any(|at| first[at].0 == Kind::Letters && is_free(at, cycle));
    let beside = |at: usize, kind: Kind| {
        let neighbours = [at.checked_sub(1), Some(at + 1)].into_iter().flatten();
        neighbours.filter_map(|at| first.get(at)).any(|part| part.0 == kind)
    };
    let stands_alone = |at: usize| first[at].0 == Kind::Digits && !beside(at, Kind::Letters);
    let lone = (0..first.len()).filter(|at| is_free(*at, cycle) && varies(*at) && stands_alone(*at));
    if cycle.is_none() && has_letters {
        let lone: Vec<usize> = lone.collect();
        cycle = lone.first().copied().filter(|_| lone.len() == 1);
    }
    let free: Vec<usize> = (0..first.len()).filter(|at| is_free(*at, cycle)).collect();
    let varying: Vec<usize> = free.iter().copied().filter(|at| varies(*at)).collect();
    let named = if varying.is_empty() { free } else { varying };
    let target = named.first().copied().zip(named.last().copied()).map(|(from, to)| {
        // letters and digits beside belong to the name
        let from = (0..from).rev().take_while(|at| is_free(*at, cycle)).last().unwrap_or(from);
        let to = (to + 1..first.len()).take_while(|at| is_free(*at, cycle)).last().unwrap_or(to);
        (from, to)
    });
    let within = |at: usize| target.is_some_and(|(from, to)| (from..=to).contains(&at));
    let crosses = within(pose) || cycle.is_some_and(within) || words.iter().any(|at| within(*at));
    // a short word alone may name a point
    let unsure = target.is_none() && first[word_before(pose)?].1.chars().count() < 3;
    if crosses || unsure {
        return None;
    }
    let part = |at: usize| match () {
        () if at == pose => "{pose}",
        () if Some(at) == cycle => "{cycle}",
        () if target.is_some_and(|(from, _)| from == at) => "{target}",
        () if within(at) => "",
        () => first[at].1,
    };
    Some((0..first.len()).map(part).collect())
}

/// `true` if all labels are whole numbers.
pub(super) fn are_numbers(labels: &[impl AsRef<str>]) -> bool {
    let is_number = |label: &str| !label.is_empty() && label.bytes().all(|byte| byte.is_ascii_digit());
    labels.iter().all(|label| is_number(label.as_ref()))
}

/// Returns the form of labels that name a target and nothing else: few labels, each of many rows.
fn targets_alone(labels: &[impl AsRef<str>]) -> Option<(String, Vec<String>)> {
    let targets: BTreeSet<&str> = labels.iter().map(AsRef::as_ref).collect();
    let is_name = |name: &&str| name.starts_with(char::is_alphabetic);
    let few = targets.len() <= MOST_TARGETS && targets.len() * 3 <= labels.len();
    (few && targets.iter().all(is_name)).then(|| (ALONE.to_owned(), targets.into_iter().map(str::to_owned).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Labels of three targets at eight poses, and in two cycles.
    fn written(label: impl Fn(usize, usize, usize) -> String) -> Vec<String> {
        (0..48).map(|i| label(i % 3 + 1, i / 3 % 8 + 1, i / 24 + 1)).collect()
    }

    #[test]
    fn a_word_beside_a_number_tells_the_pose_from_the_target() {
        let of = |labels: &[String]| label_form(labels).map(|(form, targets)| (form, targets.join(" ")));
        let found = |form: &str, targets: &str| Some((form.to_owned(), targets.to_owned()));
        let once = |label: &dyn Fn(usize, usize) -> String| written(|t, p, _| label(t, p))[..24].to_vec();
        assert_eq!(of(&once(&|t, p| format!("Ball{t}@Pos{p}"))), found("{target}@Pos{pose}", "Ball1 Ball2 Ball3"));
        assert_eq!(of(&once(&|t, p| format!("Pos{p}:Ball{t}"))), found("Pos{pose}:{target}", "Ball1 Ball2 Ball3"));
        assert_eq!(of(&once(&|t, p| format!("SMR{t}.P{p:03}"))), found("{target}.P{pose}", "SMR1 SMR2 SMR3"));
        assert_eq!(of(&once(&|t, p| format!("Lage {p} / K{t}"))), found("Lage {pose} / {target}", "K1 K2 K3"));
        assert_eq!(of(&once(&|t, p| format!("位姿{p}靶球{t}"))), found("位姿{pose}{target}", "靶球1 靶球2 靶球3"));
        assert_eq!(
            of(&written(|t, p, c| format!("K{t}_Pose{p}_{c}"))),
            found("{target}_Pose{pose}_{cycle}", "K1 K2 K3")
        );
        assert_eq!(
            of(&written(|t, p, c| format!("run{c}-pose{p}-{}", ["A", "B", "C"][t - 1]))),
            found("run{cycle}-pose{pose}-{target}", "A B C")
        );
        let alone: Vec<String> = (1..20).map(|p| format!("Pose {p}")).collect();
        assert_eq!(of(&alone), found("Pose {pose}", ""));
        // no word: the usual forms
        assert_eq!(of(&written(|t, p, c| format!("K{t}_{p}_{c}"))), found("{target}_{pose}_{cycle}", "K1 K2 K3"));
    }
}

//! Visited poses of a campaign: accuracy and what hangs on it, table 2.1 of the thesis and its figure 2.7 for every pose, drift.

mod accuracy;
mod compliance;
mod drift;
mod verdict;
mod visits;

pub(super) use compliance::compliance;
pub(super) use verdict::{Verdict, title, verdict};

use super::facts;
use super::number;
use super::part::{Part, number as numbers, text};
use super::points::Picture;
use super::words::{Words, isolated};
use crate::base::pose::{Vector, centroid, minus};
use crate::document::{Iso9283Conformity, Iso9283Document, Iso9283Interval, Iso9283Pose, Iso9283Visit};
use serde::Serialize;

#[derive(Debug, Serialize)]
pub(super) struct Section<'a> {
    pub document: &'a Iso9283Document,
    /// pose, visits, mean of x, y and z, in mm
    pub places: Vec<[String; 5]>,
    pub places_note: String,
    /// accuracy, distances, exchangeability; empty where no position is commanded
    pub accuracy: Vec<Part>,
    /// table 2.1, in µm
    pub rows: Vec<[String; 9]>,
    /// RP with its interval, and whether the instrument is good enough
    pub judged: Vec<Part>,
    /// what changed in the course of the test
    pub drift: Vec<Part>,
    /// pose, approach, visits, mean from that of all (x, y, z), RP, sphere, in µm
    pub approaches: Vec<Vec<String>>,
    /// pose, the two farthest apart, µm
    pub between: Vec<String>,
    /// vAP of angles
    pub turned: Vec<Part>,
    pub coplanar: Vec<[String; 2]>,
    pub pictures: Vec<Picture>,
}

pub(super) fn section<'a>(document: &'a Iso9283Document, words: &Words) -> Section<'a> {
    let mut judged = vec![intervals(document, words), quarter(document, words)];
    judged.retain(Part::has_rows);
    Section {
        document,
        places: facts::places(document),
        places_note: places_note(document, words),
        accuracy: accuracy::parts(document, words),
        rows: named(document, words).map(|(name, p)| row(name, p)).collect(),
        judged,
        drift: drift::parts(document, words),
        approaches: approaches(document, words),
        between: document.approaches.iter().map(|v| between(v, words)).collect(),
        turned: turned(document, words),
        coplanar: document.coplanarity_of_four.iter().map(|p| [p.pose.to_string(), um(Some(p.distance_mm))]).collect(),
        pictures: visits::pictures(document, words),
    }
}

fn um(mm: Option<f64>) -> String {
    mm.map_or_else(String::new, |mm| number::fixed(1e3 * mm, 1))
}

fn ratio(of: Option<f64>) -> String {
    of.map_or_else(String::new, |r| number::fixed(r, 2))
}

fn interval(of: Option<Iso9283Interval>, words: &Words) -> String {
    of.map_or_else(String::new, |i| words.fill("{0} to {1}", &[&um(Some(i.low_mm)), &um(Some(i.high_mm))]))
}

/// What the interval proves about a stated limit.
fn conformity(of: Option<Iso9283Conformity>, words: &Words) -> String {
    match of {
        None => String::new(),
        Some(Iso9283Conformity::Conforming) => words.say("conforming"),
        Some(Iso9283Conformity::NotConforming) => words.say("not conforming"),
        Some(Iso9283Conformity::Neither) => words.say("neither proved"),
    }
}

/// Every pose with its number, and homing by its name.
fn named<'a>(document: &'a Iso9283Document, words: &Words) -> impl Iterator<Item = (String, &'a Iso9283Pose)> {
    let homing = document.homing.iter().map(|p| (words.say("homing"), p)).collect::<Vec<_>>();
    document.poses.iter().map(|p| (p.pose.to_string(), p)).chain(homing)
}

fn row(name: String, p: &Iso9283Pose) -> [String; 9] {
    let values = [p.enclosing_radius_mm, p.enclosing_circle_radius_mm, p.rp_mm, p.rp_xy_mm];
    let [sphere, circle, rp, xy] = values.map(um);
    let [x, y, z] = [p.rp_along_x_mm, p.rp_along_y_mm, p.rp_along_z_mm].map(um);
    [name, p.cycles.to_string(), sphere, circle, rp, xy, x, y, z]
}

/// RP with what is known of it beside its value.
fn intervals(document: &Iso9283Document, words: &Words) -> Part {
    let row = |(name, p): (String, &Iso9283Pose)| {
        p.rp_interval?;
        let axes = p.ellipsoid.map_or_else(String::new, |e| e.semi_axes_mm.map(|v| um(Some(v))).join(" × "));
        let proved = conformity(p.rp_conformity, words);
        Some(vec![name, um(p.rp_mm), interval(p.rp_interval, words), um(p.rp_without_noise_mm), axes, proved])
    };
    let columns = vec![
        numbers(words.say("pose")),
        numbers("RP, µm"),
        numbers("95 %, µm"),
        numbers(words.say("RP without noise, µm")),
        numbers(words.say("ellipsoid, semi-axes, µm")),
        text(words.say("verdict (ISO 14253-1)")),
    ];
    let note = words.say("RP: ISO 9283:1998, 7.2.2. Not of the standard: RP without the instrument's noise, where visits were read several times, and the ellipsoid that holds the next position with 95 % probability.");
    let rows = named(document, words).filter_map(row).collect();
    Part::table(words.say("How well RP is known"), note, columns, rows).without_empty_columns()
}

/// Whether the instrument is good enough, pose by pose.
fn quarter(document: &Iso9283Document, words: &Words) -> Part {
    let row = |(name, p): (String, &Iso9283Pose)| {
        let met = words.say(if p.quarter_rule_met? { "met" } else { "not met" });
        let over = |of: Option<f64>| of.map_or_else(|| words.say("nothing to verify"), |r| number::fixed(r, 2));
        let ap = p.ap_mm.map_or_else(String::new, |_| over(p.uncertainty_over_ap));
        Some(vec![name, ap, over(p.uncertainty_over_rp), met])
    };
    let columns = vec![
        numbers(words.say("pose")),
        numbers(words.say("U over AP")),
        numbers(words.say("U over RP")),
        text(words.say("25 % rule")),
    ];
    let note = words.say("ISO 9283: its expanded uncertainty may be at most a quarter of what it verifies.");
    let rows = named(document, words).filter_map(row).collect();
    let part = Part::table(words.say("Is the instrument good enough?"), note, columns, rows).without_empty_columns();
    Part { strong: quarter_sentence(document, words), ..part }
}

fn places_note(document: &Iso9283Document, words: &Words) -> String {
    let means = words.say("Mean of the attained positions.");
    match document.poses.iter().any(|p| p.ap_mm.is_some()) {
        true => means,
        false => format!("{means} {}", words.say("The campaign commands no positions: accuracy (AP) is not tested.")),
    }
}

/// vAP of the angles, where there are any.
fn turned(document: &Iso9283Document, words: &Words) -> Vec<Part> {
    let named = accuracy::angles(document);
    let row = |v: &crate::document::Iso9283Variation| {
        let values = v.vap_angles_deg.iter().map(|v| number::fixed(*v, 4));
        std::iter::once(v.pose.to_string()).chain(values).collect()
    };
    let titles = named.iter().map(|a| numbers(format!("vAP {a}, deg")));
    let columns = std::iter::once(numbers(words.say("pose"))).chain(titles).collect();
    let rows = if named.is_empty() { Vec::new() } else { document.approaches.iter().map(row).collect() };
    let mut parts = vec![Part::table(String::new(), String::new(), columns, rows)];
    parts.retain(Part::has_rows);
    parts
}

/// Whether the instrument is good enough.
fn quarter_sentence(document: &Iso9283Document, words: &Words) -> String {
    let of =
        |met: bool| document.poses.iter().filter(move |p| p.quarter_rule_met == Some(met)).map(|p| p.pose.to_string());
    let (met, missed): (Vec<String>, Vec<String>) = (of(true).collect(), of(false).collect());
    match (met.is_empty(), missed.is_empty()) {
        (true, true) => String::new(),
        (_, true) => words.say("The instrument is good enough for every pose."),
        (true, _) => {
            words.say("The instrument is good enough for no pose: the values are upper bounds of the robot's.")
        }
        _ => words.fill(
            "The instrument is good enough for pose {0}, and not for pose {1}: there the values are upper bounds of the robot's.",
            &[&met.join(", "), &missed.join(", ")],
        ),
    }
}

fn approaches(document: &Iso9283Document, words: &Words) -> Vec<Vec<String>> {
    let mut rows = Vec::new();
    for v in &document.approaches {
        let all: Vec<Vector> = of_pose(document, v.pose).map(|v| v.attained_mm).collect();
        let middle = centroid(&all).unwrap_or_default();
        let spatial = document.poses.iter().any(|p| p.pose == v.pose && p.rp_z_mm.is_some());
        for a in &v.approaches {
            let mut cells = vec![v.pose.to_string(), approach(&a.name, words), a.cycles.to_string()];
            let [x, y, z] = minus(a.mean_mm, middle).map(Some);
            cells.extend([x, y, z.filter(|_| spatial)].map(um));
            cells.extend([a.rp_mm, a.enclosing_radius_mm].map(um));
            rows.push(cells);
        }
    }
    rows
}

/// How a pose was approached: the program's own words are translated, those of a table are not.
fn approach(name: &str, words: &Words) -> String {
    match name.strip_prefix("from pose ") {
        Some(pose) => words.fill("from pose {0}", &[&pose]),
        None => name.to_owned(),
    }
}

fn between(v: &crate::document::Iso9283Variation, words: &Words) -> String {
    let [a, b] = &v.between;
    let named = |name: &str| isolated(&approach(name, words));
    words.fill(
        "Pose {0}: the means {1} and {2} lie {3} µm apart, the farthest of all approaches.",
        &[&v.pose, &named(a), &named(b), &um(Some(v.vap_mm))],
    )
}

fn of_pose(document: &Iso9283Document, pose: i64) -> impl Iterator<Item = &Iso9283Visit> {
    document.visits.iter().filter(move |v| v.pose == pose)
}

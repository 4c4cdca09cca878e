//! What commanded poses add: accuracy of position and orientation, distances; and the exchangeability of robots.

use super::repeatability::{angles, conformity, interval};
use crate::model::{Block, Columns, Section, Table, fixed, um};
use crate::number;
use crate::words::Words;
use etalon_documents::{Characteristics, Iso9283Distance, Iso9283Document, Iso9283Pose};

/// Distances that a page shows; the workbook has all.
const DISTANCES: usize = 60;

pub(super) fn section(tested: &Characteristics, words: &Words) -> Option<Section> {
    let document = tested.poses.as_ref()?;
    let mut section = Section::new("accuracy", words.say("Accuracy"));
    let note =
        words.say("AP: distance of the mean from the commanded position, and its coordinates (ISO 9283:1998, 7.2.1).");
    section.table(words.say("Accuracy of position"), note, positions(document, words));
    let note = words.say("AP: mean minus commanded angle; RP: three standard deviations; each angle alone (ISO 9283:1998, 7.2.1 and 7.2.2).");
    section.table(words.say("Orientation"), note, orientation(document, words));
    section.on_terminal().whole()
}

/// Distances between poses (7.3).
pub(super) fn distances(tested: &Characteristics, words: &Words) -> Option<Section> {
    let document = tested.poses.as_ref()?;
    let mut section = Section::new("distances", words.say("Distances between poses"));
    let note = words.say("AD: mean attained minus commanded distance; RD: three standard deviations of the attained one (ISO 9283:1998, 7.3).");
    section.table("", note, between_poses(document, words));
    section.table("", "", turned(document, words).detail());
    section.on_terminal().whole()
}

/// How far robots of one kind differ (7.7).
pub(super) fn exchangeability(tested: &Characteristics, words: &Words) -> Option<Section> {
    let um = number::fixed(1e3 * tested.poses.as_ref()?.exchangeability_mm?, 1);
    let mut section = Section::new("exchangeability", words.say("Exchangeability"));
    section.push(Block::text(words.fill(
        "E = {0} µm: the largest distance between the mean positions of two robots at one pose (ISO 9283:1998, 7.7).",
        &[&um],
    )));
    section.on_terminal().whole()
}

fn positions(document: &Iso9283Document, words: &Words) -> Table {
    let columns = Columns::<&Iso9283Pose>::new()
        .page("pose", "", |p| p.pose)
        .page("visits", "", |p| p.cycles)
        .page("AP", "µm", |p| um(p.ap_mm))
        .page("95 %", "µm", |p| interval(p.ap_interval, words))
        .page("AP x", "µm", |p| um(p.ap_x_mm))
        .page("AP y", "µm", |p| um(p.ap_y_mm))
        .page("AP z", "µm", |p| um(p.ap_z_mm))
        .page("U/AP", "", |p| fixed(p.uncertainty_over_ap, 2))
        .page("verdict", "", |p| conformity(p.ap_conformity, words));
    let commanded: Vec<&Iso9283Pose> = document.poses.iter().filter(|p| p.ap_mm.is_some()).collect();
    Table::of(words, &commanded, columns).without_empty_columns()
}

fn orientation(document: &Iso9283Document, words: &Words) -> Table {
    let angles = |p: &Iso9283Pose| [p.ap_a_deg, p.ap_b_deg, p.ap_c_deg, p.rp_a_deg, p.rp_b_deg, p.rp_c_deg];
    let columns = Columns::<&Iso9283Pose>::new()
        .page("pose", "", |p| p.pose)
        .page("AP a", "deg", |p| fixed(p.ap_a_deg, 4))
        .page("AP b", "deg", |p| fixed(p.ap_b_deg, 4))
        .page("AP c", "deg", |p| fixed(p.ap_c_deg, 4))
        .page("RP a", "deg", |p| fixed(p.rp_a_deg, 4))
        .page("RP b", "deg", |p| fixed(p.rp_b_deg, 4))
        .page("RP c", "deg", |p| fixed(p.rp_c_deg, 4));
    let turned: Vec<&Iso9283Pose> = document.poses.iter().filter(|p| angles(p).iter().any(Option::is_some)).collect();
    Table::of(words, &turned, columns).without_empty_columns()
}

fn between_poses(document: &Iso9283Document, words: &Words) -> Table {
    let axis = |values: &[f64], k: usize| um(values.get(k).copied());
    let columns = Columns::<Iso9283Distance>::new()
        .page("between poses", "", between)
        .sheet("pose", "", |d| d.poses[0])
        .sheet("other pose", "", |d| d.poses[1])
        .both("cycles", "", |d| d.cycles)
        .micrometres("AD", |d| d.ad_mm)
        .both("AD x", "mm", move |d| axis(&d.ad_axes_mm, 0))
        .shown_in("µm")
        .both("AD y", "mm", move |d| axis(&d.ad_axes_mm, 1))
        .shown_in("µm")
        .both("AD z", "mm", move |d| axis(&d.ad_axes_mm, 2))
        .shown_in("µm")
        .micrometres("RD", |d| d.rd_mm)
        .both("RD x", "mm", move |d| axis(&d.rd_axes_mm, 0))
        .shown_in("µm")
        .both("RD y", "mm", move |d| axis(&d.rd_axes_mm, 1))
        .shown_in("µm")
        .both("RD z", "mm", move |d| axis(&d.rd_axes_mm, 2))
        .shown_in("µm")
        .sheet_xyz(["AD of the first angle", "AD of the second angle", "AD of the third angle"], "deg", |d| {
            &d.ad_angles_deg
        })
        .sheet_xyz(["RD of the first angle", "RD of the second angle", "RD of the third angle"], "deg", |d| {
            &d.rd_angles_deg
        });
    let table = Table::of(words, &document.distances, columns).without_empty_columns();
    table.showing(DISTANCES).on("ISO 9283 distances")
}

fn between(d: &Iso9283Distance) -> String {
    format!("{} – {}", d.poses[0], d.poses[1])
}

/// The same of the angles.
fn turned(document: &Iso9283Document, words: &Words) -> Table {
    let names = angles(document);
    if names.is_empty() {
        return Table::default();
    }
    let title = |of: &str| names.iter().map(|a| format!("{of} {a}")).collect::<Vec<_>>();
    let (ad, rd) = (title("AD"), title("RD"));
    let first = Columns::<Iso9283Distance>::new().page("between poses", "", between).page("cycles", "", |d| d.cycles);
    let with_ad = ad.iter().enumerate().fold(first, |columns, (k, title)| {
        columns.page(title, "deg", move |d| fixed(d.ad_angles_deg.get(k).copied(), 4))
    });
    let columns = rd.iter().enumerate().fold(with_ad, |columns, (k, title)| {
        columns.page(title, "deg", move |d| fixed(d.rd_angles_deg.get(k).copied(), 4))
    });
    Table::of(words, &document.distances, columns).showing(DISTANCES)
}

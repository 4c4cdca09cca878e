//! Results for commanded poses: accuracy of position and orientation, distances, and
//! exchangeability of robots.

use super::repeatability::{Named, angles, columns, conformity, interval, named};
use crate::model::{Block, Columns, Section, Table, fixed, um};
use crate::number;
use crate::words::{Words, tr};
use etalon_base::phrase;
use etalon_documents::{Characteristics, Iso9283Distance, Iso9283Document, Iso9283Pose};

/// Maximum number of distances on a page; the workbook contains all.
const DISTANCES: usize = 60;

pub(super) fn section(tested: &Characteristics, words: &Words) -> Option<Section> {
    let poses = named(tested.poses.as_ref()?, words);
    let mut section = Section::new("accuracy", tr!(words, "accuracy"));
    let note = tr!(words, "definition-ap");
    section.table(tr!(words, "accuracy-of-position"), note, positions(&poses, words));
    section.blocks.extend(drifting(tested.poses.as_ref()?, words));
    let note = tr!(words, "definition-ap-rp-of-angles");
    section.table(tr!(words, "orientation-title"), note, orientation(&poses, words));
    section.on_terminal().whole()
}

/// Note on intervals of AP if AP drifted significantly.
pub(super) fn drifting(document: &Iso9283Document, words: &Words) -> Option<Block> {
    let drifted: Vec<String> =
        document.drifts.iter().filter(|d| d.is_significant).map(|d| d.pose.to_string()).collect();
    let (count, poses) = (drifted.len(), drifted.join(", "));
    (count > 0).then(|| Block::text(tr!(words, "accuracy-drifts", count, poses)))
}

/// Distances between poses (7.3).
pub(super) fn distances(tested: &Characteristics, words: &Words) -> Option<Section> {
    let document = tested.poses.as_ref()?;
    let mut section = Section::new("distances", tr!(words, "distances-between-poses"));
    let note = tr!(words, "definition-ad-rd");
    section.table("", note, between_poses(document, words));
    section.table("", "", turned(document, words).detail());
    section.on_terminal().whole()
}

/// Differences between robots of one type (7.7).
pub(super) fn exchangeability(tested: &Characteristics, words: &Words) -> Option<Section> {
    let um = number::fixed(1e3 * tested.poses.as_ref()?.robot.exchangeability_mm?, 1);
    let mut section = Section::new("exchangeability", tr!(words, "exchangeability"));
    section.push(Block::text(tr!(words, "exchangeability-between-robots", distance = um)));
    section.on_terminal().whole()
}

/// Expanded uncertainty of a position over AP of the judged visits.
fn ratio(n: &Named) -> Option<f64> {
    Some(n.pose.expanded_uncertainty_mm()? / n.ap.value_mm.filter(|mm| *mm > 0.0)?)
}

/// Accuracy of position of each pose.
pub(super) fn positions(poses: &[Named], words: &Words) -> Table {
    let columns = Columns::<Named>::new()
        .page(phrase!("pose"), "", |n| n.name.clone())
        .page(phrase!("approached"), "", |n| n.ap.approach())
        .page(phrase!("visits"), "", |n| n.ap.visits)
        .page("AP", "µm", |n| um(n.ap.value_mm))
        .page("95 %", "µm", |n| interval(n.pose.ap_interval, words))
        .page("AP x", "µm", |n| um(n.ap.deviation_mm[0]))
        .page("AP y", "µm", |n| um(n.ap.deviation_mm[1]))
        .page("AP z", "µm", |n| um(n.ap.deviation_mm[2]))
        .page("U/AP", "", |n| fixed(ratio(n), 2))
        .page(phrase!("verdict"), "", |n| conformity(n.pose.ap_conformity, words))
        .decisive();
    let commanded = poses.iter().filter(|n| n.pose.ap_mm.is_some());
    Table::new(words, commanded, columns).without_empty_columns()
}

/// Accuracy and repeatability of the orientation of each pose.
pub(super) fn orientation(poses: &[Named], words: &Words) -> Table {
    let angles = |p: &Iso9283Pose| [p.ap_a_deg, p.ap_b_deg, p.ap_c_deg, p.rp_a_deg, p.rp_b_deg, p.rp_c_deg];
    let rotations = |p: &Iso9283Pose| p.ap_rotation_deg.or(p.rp_rotation_deg).is_some();
    let mut shown = vec!["pose", "AP a", "AP b", "AP c", "RP a", "RP b", "RP c"];
    shown.extend(["AP rx", "AP ry", "AP rz", "RP rx", "RP ry", "RP rz"]);
    let turned = poses.iter().filter(|n| rotations(n.pose) || angles(n.pose).iter().any(Option::is_some));
    Table::new(words, turned, Columns::new().page_columns(columns(words), &shown)).without_empty_columns()
}

fn between_poses(document: &Iso9283Document, words: &Words) -> Table {
    let columns = Columns::<Iso9283Distance>::new()
        .page(phrase!("between-poses"), "", between)
        .sheet(phrase!("pose"), "", |d| d.poses[0])
        .sheet(phrase!("other-pose"), "", |d| d.poses[1])
        .both(phrase!("cycles"), "", |d| d.cycles)
        .micrometres("AD", |d| d.ad_mm)
        .micrometres("AD x", |d| d.ad_axes_mm.first().copied())
        .micrometres("AD y", |d| d.ad_axes_mm.get(1).copied())
        .micrometres("AD z", |d| d.ad_axes_mm.get(2).copied())
        .micrometres("RD", |d| d.rd_mm)
        .micrometres("RD x", |d| d.rd_axes_mm.first().copied())
        .micrometres("RD y", |d| d.rd_axes_mm.get(1).copied())
        .micrometres("RD z", |d| d.rd_axes_mm.get(2).copied())
        .sheet_xyz(["a", "b", "c"].map(|axis| phrase!("angle-ad", axis)), "deg", |d| &d.ad_angles_deg)
        .sheet_xyz(["a", "b", "c"].map(|axis| phrase!("angle-rd", axis)), "deg", |d| &d.rd_angles_deg)
        .both("AD r", "deg", |d| fixed(d.ad_rotation_deg, 4))
        .both("RD r", "deg", |d| fixed(d.rd_rotation_deg, 4));
    let table = Table::new(words, &document.distances, columns).without_empty_columns();
    table.showing(DISTANCES).on(phrase!("sheet-iso9283-distances"))
}

fn between(d: &Iso9283Distance) -> String {
    format!("{} – {}", d.poses[0], d.poses[1])
}

/// Table of the angles.
fn turned(document: &Iso9283Document, words: &Words) -> Table {
    let names = angles(document);
    if names.is_empty() {
        return Table::default();
    }
    let title = |of: &str| names.iter().map(|a| format!("{of} {a}")).collect::<Vec<_>>();
    let (ad, rd) = (title("AD"), title("RD"));
    let first = Columns::<Iso9283Distance>::new().page(phrase!("between-poses"), "", between).page(
        phrase!("cycles"),
        "",
        |d| d.cycles,
    );
    let columns = first.page_angles(&ad, |d| &d.ad_angles_deg).page_angles(&rd, |d| &d.rd_angles_deg);
    Table::new(words, &document.distances, columns).showing(DISTANCES)
}

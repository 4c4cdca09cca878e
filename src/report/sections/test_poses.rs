//! Poses of a test with their figure, and the cube of ISO 9283:1998, 6, if they lie in one.

use crate::model::{Columns, Section, Table, fixed};
use crate::plots::cube;
use crate::words::{Words, tr};
use etalon_base::phrase;
use etalon_base::pose::{Vector, centroid};
use etalon_base::pose_name::PoseName;
use etalon_documents::{Characteristics, Iso9283Document};
use std::collections::BTreeMap;

pub(super) fn section(tested: &Characteristics, words: &Words) -> Option<Section> {
    let document = tested.poses.as_ref().filter(|document| !document.recorded.visits.is_empty())?;
    let mut section = Section::new("poses", tr!(words, "poses-title"));
    section.table("", places_note(document, words), places(document, words).detail());
    section.figures(cube::picture(document, words));
    section.on_terminal().whole()
}

fn places_note(document: &Iso9283Document, words: &Words) -> String {
    let means = tr!(words, "mean-of-attained-positions");
    match document.poses.iter().any(|p| p.ap_mm.is_some()) {
        true => means,
        false => format!("{means} {}", tr!(words, "accuracy-not-tested")),
    }
}

/// Positions of the poses: means of the attained positions.
fn places(document: &Iso9283Document, words: &Words) -> Table {
    let mut by_pose: BTreeMap<PoseName, Vec<Vector>> = BTreeMap::new();
    for visit in &document.recorded.visits {
        by_pose.entry(visit.pose).or_default().push(visit.attained_mm);
    }
    let rows: Vec<(PoseName, usize, Vector)> =
        by_pose.into_iter().filter_map(|(pose, places)| Some((pose, places.len(), centroid(&places)?))).collect();
    let columns = Columns::<(PoseName, usize, Vector)>::new()
        .both(phrase!("pose"), "", |(pose, ..)| *pose)
        .both(phrase!("visits"), "", |(_, visits, _)| *visits)
        .both("x", "mm", |(.., mean)| fixed(mean[0], 3))
        .both("y", "mm", |(.., mean)| fixed(mean[1], 3))
        .both("z", "mm", |(.., mean)| fixed(mean[2], 3));
    Table::new(words, &rows, columns).on(phrase!("sheet-iso9283-places"))
}

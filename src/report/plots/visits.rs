//! Visits of a pose by approach, in each plane (thesis, fig. 2.7).

use super::layer::*;
use etalon_base::catalogue::Phrase;
use etalon_documents::{Iso9283Document, Iso9283Pose, Iso9283Visit};
use std::collections::BTreeMap;

/// Style of a visit without recorded approach.
const UNKNOWN: Look<'static> = Look { shape: Shape::Circle, class: "map", fill: "#ffffff" };
/// Maximum distance from the mean that is drawn (µm); larger ones are blunders.
const DRAWABLE_UM: f64 = 1e9;

/// Names of approaches in the language of a report; names that a table contains are kept.
#[derive(Clone, Copy)]
pub(crate) struct Approaches<'a> {
    phrases: &'a BTreeMap<String, Phrase>,
    words: &'a Words,
}

impl<'a> Approaches<'a> {
    pub fn new(document: &'a Iso9283Document, words: &'a Words) -> Self {
        Self { phrases: &document.approach_phrases, words }
    }

    pub fn name(self, name: &str) -> String {
        self.phrases.get(name).map_or_else(|| name.to_owned(), |phrase| self.words.tr(phrase))
    }

    fn name_or_unknown(self, name: Option<&str>) -> String {
        name.map_or_else(|| tr!(self.words, "approach-not-known"), |name| self.name(name))
    }
}

/// Visits of a pose.
pub(crate) fn pose_visits(document: &Iso9283Document, pose: PoseName) -> impl Iterator<Item = &Iso9283Visit> {
    document.recorded.visits.iter().filter(move |v| v.pose == pose)
}

/// Commanded position of a pose relative to the mean of its visits (µm); `None` without one.
fn commanded_um(pose: &Iso9283Pose) -> Option<Vector> {
    let at = [pose.ap_x_mm?, pose.ap_y_mm?, pose.ap_z_mm.unwrap_or(0.0)].map(|v| -1e3 * v);
    at.iter().all(|v| v.abs() < DRAWABLE_UM).then_some(at)
}

/// One figure for each pose with visits, and for each plane with scatter.
pub(crate) fn pictures(document: &Iso9283Document, words: &Words) -> Vec<Figure> {
    let of_one = |p: &Iso9283Pose| {
        let visits: Vec<&Iso9283Visit> = pose_visits(document, p.pose).collect();
        let planar = visits.iter().all(|v| v.attained_mm[2] == visits[0].attained_mm[2]);
        Seen::planes(planar)
            .iter()
            .filter_map(|seen| picture(p, &visits, *seen, Approaches::new(document, words)))
            .collect::<Vec<_>>()
    };
    document.poses.iter().flat_map(of_one).collect()
}

/// Draws the commanded point: a cross, or an arrow in its direction if it is outside the figure.
/// The long text has a row of its own below.
fn commanded(map: &mut Workspace, p: Vector, words: &Words) {
    let hollow = |shape| Look::new(shape, "before");
    let [dx, dy, dz] = p.map(|v| number::fixed(v, 1));
    let tip = tr!(words, "commanded-tooltip", x = dx, y = dy, z = dz);
    match map.towards(p) {
        None => {
            let at = map.at(p).at;
            map.svg.cross("commanded", at, 6.0);
            map.svg.mark(hollow(Shape::Circle), at, 2.4, &tip);
        }
        Some(arrow) => {
            map.svg.arrows("commanded", &[arrow]);
            map.svg.mark(hollow(Shape::Square), arrow[1], 2.4, &tip);
        }
    }
    let y = map.svg.row();
    map.svg.cross("commanded", (30.0, y), 4.5);
    let name = tr!(words, "commanded-away", distance = number::fixed(norm(p), 1));
    map.svg.text("start", (40.0, y + 4.0), &name);
}

/// Visits of a pose in a plane, by approach, with their means and the commanded point.
fn picture(of: &Iso9283Pose, visits: &[&Iso9283Visit], seen: Seen, approaches: Approaches) -> Option<Figure> {
    let (pose, words) = (of.pose, approaches.words);
    let middle = centroid(&visits.iter().map(|v| v.attained_mm).collect::<Vec<_>>())?;
    let from_middle = |v: &&Iso9283Visit| minus(v.attained_mm, middle).map(|d| 1e3 * d);
    let places: Vec<Vector> = visits.iter().map(from_middle).collect();
    if !places.iter().flatten().all(|v| v.abs() < DRAWABLE_UM) {
        return None;
    }
    let mut groups: BTreeMap<Option<&str>, Vec<Vector>> = BTreeMap::new();
    for (visit, place) in visits.iter().zip(&places) {
        groups.entry(visit.approach.as_deref()).or_default().push(*place);
    }
    let known: Vec<&str> = groups.keys().flatten().copied().collect();
    let look = |name: Option<&str>| known.iter().position(|n| Some(*n) == name).map_or(UNKNOWN, Look::group);
    let mut map = Workspace::with_unit(seen, &places, "µm", words);
    let xyz = |place: Vector| place.map(|v| words.fixed(v, 1));
    for (visit, place) in visits.iter().zip(&places) {
        let (from, [x, y, z]) = (approaches.name_or_unknown(visit.approach.as_deref()), xyz(*place));
        let tip = tr!(words, "visit-tooltip", pose, cycle = visit.cycle, approach = from, x, y, z);
        map.svg.mark(look(visit.approach.as_deref()), map.at(*place), 3.0, &tip);
    }
    for (name, places) in &groups {
        if let Some(from) = name {
            let mean = centroid(places)?;
            let [x, y, z] = xyz(mean);
            let tip = tr!(words, "mean-tooltip", approach = approaches.name(from), x, y, z);
            map.svg.mark(Look { class: "mean", ..look(*name) }, map.at(mean), 6.5, &tip);
        }
        map.svg.legend(look(*name), &format!("{} ({})", approaches.name_or_unknown(*name), places.len()));
    }
    if let Some(p) = commanded_um(of) {
        commanded(&mut map, p, words);
    }
    let row = |(visit, place): (&&Iso9283Visit, &Vector)| {
        let first = [visit.cycle.to_string(), approaches.name_or_unknown(visit.approach.as_deref())];
        first.into_iter().chain(xyz(*place)).collect()
    };
    let name = seen.name();
    let title = tr!(words, "visits-of-pose-title", pose, plane = name);
    let description = tr!(words, "visits-by-approach", visits = visits.len());
    let unknown = groups.get(&None).map_or(0, Vec::len);
    let caption = match known.len() {
        0 => tr!(words, "visits-from-unknown-poses", visits = visits.len()),
        1 => tr!(words, "visits-from-one-pose", visits = visits.len(), unknown),
        _ => tr!(words, "visits-by-approach-in-space", visits = visits.len()),
    };
    Some(Figure {
        caption,
        table_title: tr!(words, "numbers-of-this-picture"),
        header: [tr!(words, "cycle"), tr!(words, "approached")]
            .into_iter()
            .chain(["x", "y", "z"].map(|axis| format!("{axis}, µm")))
            .collect(),
        // the numbers of all planes are equal
        rows: visits.iter().zip(&places).map(row).take(if seen == XY { usize::MAX } else { 0 }).collect(),
        ..map.figure(&format!("visits-{pose}-{name}"), title, description)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo_iso9283::iso9283;

    fn captions(document: &Iso9283Document) -> Vec<String> {
        pictures(document, &Words::default()).into_iter().map(|figure| figure.caption).collect()
    }

    /// The visits of the demo come from the other pose, except the first one.
    #[test]
    fn visits_without_approach_are_no_visits_by_one_approach() {
        let (mut document, words) = (iso9283(), Words::default());
        let all_but = |unknown| tr!(words, "visits-from-one-pose", visits = 30, unknown);
        let found = captions(&document);
        assert!(found[0] == all_but(1) && found[found.len() - 1] == all_but(0), "{found:?}");
        document.recorded.visits.iter_mut().for_each(|v| v.approach = None);
        assert_eq!(captions(&document)[0], tr!(words, "visits-from-unknown-poses", visits = 30));
    }
}

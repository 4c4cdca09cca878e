//! Visits of all poses of a test as small multiples on one scale, coloured by cycle, with the
//! circle of RP (ISO 9283:1998, 7.2).

use super::layer::*;
use super::visits::pose_visits;
use etalon_documents::{Iso9283Document, Iso9283Pose};

/// Maximum number of poses; the poses with the largest RP are drawn.
const POSES: usize = 10;
/// Number of poses in a row.
const COLUMNS: usize = 5;
/// Number of colours of cycles.
const SHADES: usize = 16;

/// Name of the plane, with the frame of the positions if it is known.
fn plane(document: &Iso9283Document, words: &Words) -> String {
    let plane = tr!(words, "plane-named", plane = XY.name());
    match &document.frame {
        Some(frame) => format!("{plane} ({})", words.worded(frame)),
        None => plane,
    }
}

/// Small multiples in the xy plane; `None` without scatter.
pub(crate) fn picture(document: &Iso9283Document, words: &Words) -> Option<Figure> {
    let mut poses: Vec<&Iso9283Pose> = document.poses.iter().filter(|p| p.rp_mm.is_some()).collect();
    poses.sort_by(|a, b| b.rp_mm.unwrap_or(0.0).total_cmp(&a.rp_mm.unwrap_or(0.0)));
    poses.truncate(POSES);
    poses.sort_by_key(|p| p.pose);
    let places = |p: &Iso9283Pose| -> Option<Vec<(i64, Vector)>> {
        let all: Vec<Vector> = pose_visits(document, p.pose).map(|v| v.attained_mm).collect();
        let middle = centroid(&all)?;
        Some(pose_visits(document, p.pose).map(|v| (v.cycle, minus(v.attained_mm, middle))).collect())
    };
    let drawn: Vec<_> = poses.iter().filter_map(|p| Some((*p, places(p)?))).collect();
    let distances = drawn.iter().flat_map(|(_, all)| all.iter().map(|(_, v)| v[0].hypot(v[1])));
    let reach = largest(distances.chain(drawn.iter().filter_map(|(p, _)| p.rp_mm)));
    if drawn.is_empty() || reach <= 0.0 || !drawable(1e3 * reach) {
        return None;
    }
    let columns = COLUMNS.min(drawn.len());
    let cell = WIDE / COLUMNS as f64;
    let (rows, radius) = (drawn.len().div_ceil(COLUMNS), 0.5 * cell - 8.0);
    let mut svg = Svg::new(words, WIDE, rows as f64 * (cell + 36.0));
    let left = 0.5 * (WIDE - columns as f64 * cell);
    let scale = radius / (1.05 * reach);
    for (i, (p, all)) in drawn.iter().enumerate() {
        let middle =
            (left + ((i % COLUMNS) as f64 + 0.5) * cell, (i / COLUMNS) as f64 * (cell + 36.0) + 18.0 + 0.5 * cell);
        let cycles = range(all.iter().map(|(cycle, _)| *cycle as f64))?;
        svg.cross("grid", middle, radius);
        let rp = p.rp_mm.unwrap_or(0.0);
        let shown = words.fixed(1e3 * rp, 1);
        // visits from several approaches have no common RP
        let text = match p.rp_approach {
            Some(_) => tr!(words, "scatter-of-all-visits", distance = shown),
            None => format!("RP {shown} µm"),
        };
        let tip = tr!(words, "rp-circle-tooltip", pose = p.pose, text);
        svg.mark(Look::new(Shape::Circle, "ring"), middle, scale * rp, &tip);
        for (cycle, v) in all {
            let share = (*cycle as f64 - cycles[0]) / (cycles[1] - cycles[0]).max(1.0);
            let class = format!("map o{}", (share * (SHADES - 1) as f64).round() as usize);
            let [x, y] = [0, 1].map(|axis| number::fixed(1e3 * v[axis], 1));
            let tip = tr!(words, "visit-of-cycle-tooltip", pose = p.pose, cycle, x, y);
            let at = (middle.0 + scale * v[0], middle.1 - scale * v[1]);
            svg.mark(Look::new(Shape::Circle, &class), at, 2.6, &tip);
        }
        svg.text("mid name-of", (middle.0, middle.1 - 0.5 * cell - 4.0), &tr!(words, "pose-named", pose = p.pose));
        svg.text("mid", (middle.0, middle.1 + 0.5 * cell + 10.0), &text);
    }
    svg.legend(Look::new(Shape::Circle, "map o0"), &tr!(words, "first-cycle"));
    svg.legend(Look::new(Shape::Circle, "map o15"), &tr!(words, "last-cycle"));
    svg.legend(Look::new(Shape::Circle, "ring"), &tr!(words, "rp-circle"));
    let title = tr!(words, "multiples-title");
    let half = number::fixed(1e3 * 1.05 * reach, 0);
    let (count, total) = (drawn.len(), document.poses.len());
    let plane = plane(document, words);
    let description = tr!(words, "multiples-description", plane, half, count, total);
    Some(svg.figure("visits-all", title, description))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo_iso9283;

    #[test]
    fn a_plane_is_named_with_its_frame() {
        let (mut document, words) = (demo_iso9283::iso9283(), Words::default());
        assert_eq!(plane(&document, &words), "xy plane (frame of the table)");
        document.frame = None;
        assert_eq!(plane(&document, &words), "xy plane");
    }

    #[test]
    fn every_pose_has_its_circle_and_all_its_visits_on_one_scale() {
        let tested = demo_iso9283::whole();
        let document = tested.poses.as_ref().unwrap();
        let svg = picture(document, &Words::default()).unwrap().svg;
        let poses = document.poses.iter().filter(|p| p.rp_mm.is_some()).count();
        // the legend has a circle too
        assert_eq!(svg.matches("class=\"ring\"").count(), poses + 1, "{svg}");
        let radius = |line: &str| line.split(" r=\"").nth(1).unwrap().split('"').next().unwrap().parse::<f64>();
        let radii: Vec<f64> = svg.lines().filter(|l| l.contains("\"ring\"")).map(|l| radius(l).unwrap()).collect();
        let rp: Vec<f64> = document.poses.iter().filter_map(|p| p.rp_mm).collect();
        assert!((radii[0] / radii[1] - rp[0] / rp[1]).abs() < 0.01, "{radii:?} {rp:?}");
    }
}

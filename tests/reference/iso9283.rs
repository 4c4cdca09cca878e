//! Pose repeatability against a laser-tracker exercise whose authors printed their results (KIT, winter 2024/25).

use etalon::iso9283::repeatability::pose_repeatability;
use etalon::pose::{Vector, centroid};
use std::path::Path;

/// Positions of the three reflectors, ten visits each.
fn visits(path: &Path) -> [Vec<Vector>; 3] {
    let mut targets: [Vec<Vector>; 3] = Default::default();
    for line in std::fs::read_to_string(path).unwrap().lines() {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.trim().parse().unwrap()).collect();
        targets[cells[0] as usize - 1].push([cells[1], cells[2], cells[3]]);
    }
    targets
}

/// The numbers of a results file that stand before `mm` in the part on ISO 9283.
fn published(path: &Path) -> Vec<String> {
    let text = std::fs::read_to_string(path).unwrap();
    let iso = text.lines().filter(|line| line.starts_with("Pos. repeat."));
    iso.map(|line| line.split(':').nth(1).unwrap().trim().trim_end_matches(" mm").to_owned()).collect()
}

#[test]
fn repeatability_agrees_with_kit_to_every_printed_digit() {
    let Some(folder) = crate::reference_data("robots/kit_iso9283_tracker") else { return };
    let mut compared = 0;
    for (name, expected) in [("pose1", "0.0120"), ("pose2", "0.0134"), ("anfahrt_pose1", "0.4085")] {
        let targets = visits(&folder.join(format!("tracker/{name}.txt")));
        assert!(targets.iter().all(|t| t.len() == 10), "{name}");
        let middle = (0..10).map(|j| centroid(&[targets[0][j], targets[1][j], targets[2][j]]).unwrap()).collect();
        let published = published(&folder.join(format!("results/{name}_results.txt")));
        assert_eq!((published.len(), published[0].as_str()), (4, expected));
        let [a, b, c] = targets;
        for (points, printed) in [middle, a, b, c].iter().zip(&published) {
            let found = pose_repeatability(points).unwrap();
            assert_eq!(&format!("{:.4}", found.rp_mm), printed, "{name}");
            // mean + 3 s holds every visit here, and no ball is larger than the farthest from the mean
            assert!(found.enclosing_radius_mm < found.rp_mm && found.enclosing_radius_mm > found.mean_radius_mm);
            compared += 1;
        }
    }
    assert_eq!(compared, 12);
}

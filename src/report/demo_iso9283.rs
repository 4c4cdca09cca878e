//! A test of repeatability to try the report on: two poses, thirty visits each, synthetic.

use crate::document::{Iso9283Approach, Iso9283Document, Iso9283Pose, Iso9283Variation, Iso9283Visit};
use crate::noise::Noise;

pub(super) fn iso9283() -> Iso9283Document {
    let mut noise = Noise::new(7, 1);
    let mut visits = vec![];
    for (i, pose) in (1..=30).flat_map(|_| [1, 2]).enumerate() {
        let approach = (i > 0).then(|| format!("from pose {}", 3 - pose));
        let x_mm = 100.0 * f64::from(pose) + noise.gaussian(0.003);
        let attained_mm = [x_mm, 50.0 + noise.gaussian(0.006), noise.gaussian(0.002)];
        visits.push(Iso9283Visit { pose: pose.into(), cycle: 1 + i as i64 / 2, approach, attained_mm });
    }
    let pose = |pose| Iso9283Pose {
        pose,
        cycles: 30,
        rp_mm: Some(0.0217),
        enclosing_radius_mm: Some(0.0173),
        uncertainty_over_rp: Some(0.124),
        quarter_rule_met: Some(true),
        ..Iso9283Pose::default()
    };
    let approach = |name: &str, mean_mm| Iso9283Approach {
        name: name.to_owned(),
        cycles: 15,
        mean_mm,
        deviation_mm: None,
        rp_mm: Some(0.0111),
        enclosing_radius_mm: Some(0.0098),
    };
    Iso9283Document {
        schema: "etalon/iso9283/1".to_owned(),
        conventions: vec!["positions alone".to_owned()],
        poses: vec![pose(1), pose(2)],
        distances: vec![],
        approaches: vec![Iso9283Variation {
            pose: 1,
            vap_mm: 0.0123,
            between: ["from pose 2".to_owned(), "from pose 3".to_owned()],
            vap_angles_deg: vec![],
            approaches: vec![
                approach("from pose 2", [100.0, 50.006, 0.0]),
                approach("from pose 3", [100.0, 49.994, 0.0]),
            ],
        }],
        drifts: vec![],
        exchangeability_mm: None,
        coplanarity_mm: None,
        coplanarity_of_four: vec![],
        homing: None,
        visits,
        limits: vec![],
        reference: vec![],
        messages: vec![],
    }
}

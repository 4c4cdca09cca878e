//! Repeatability test for trying the report: two poses with thirty visits each, synthetic.

use etalon_base::noise::Noise;
use etalon_base::phrase;
use etalon_base::pose::Vector;
use etalon_documents::*;

/// Axes of an ellipsoid that is longest along y.
const AXES: [Vector; 3] = [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];

/// Repeatability test alone.
pub(crate) fn tested() -> Characteristics {
    Characteristics { poses: Some(iso9283()), ..Characteristics::default() }
}

/// Test with commanded poses, sets, reference targets, robots and loads.
pub(crate) fn whole() -> Characteristics {
    let mut poses = iso9283();
    let interval = |low_mm, high_mm| Some(Iso9283Interval { low_mm, high_mm });
    for p in &mut poses.poses {
        (p.ap_mm, p.ap_x_mm, p.ap_y_mm, p.ap_z_mm) = (Some(0.0512), Some(0.03), Some(-0.04), Some(0.01));
        (p.ap_c_deg, p.rp_c_deg, p.uncertainty_over_ap) = (Some(-0.0123), Some(0.0045), Some(0.05));
        (p.ap_interval, p.rp_interval) = (interval(0.0489, 0.0536), interval(0.018, 0.0261));
        (p.ap_conformity, p.rp_conformity) = (Some(Conformity::Neither), Some(Conformity::Conforming));
        p.rp_without_noise_mm = Some(0.0201);
        p.ellipsoid = Some(Iso9283Ellipsoid { semi_axes_mm: [0.017, 0.009, 0.006], axes: AXES });
    }
    poses.distances = vec![Iso9283Distance {
        poses: [1.into(), 2.into()],
        cycles: 30,
        ad_mm: -0.0212,
        ad_axes_mm: vec![-0.02, 0.003, 0.001],
        rd_mm: 0.0151,
        rd_axes_mm: vec![0.015, 0.02, 0.008],
        ad_angles_deg: vec![0.001],
        rd_angles_deg: vec![0.006],
        ..Iso9283Distance::default()
    }];
    poses.approaches[0].vap_angles_deg = vec![0.0021];
    poses.drifts = vec![Iso9283Drift {
        is_significant: false,
        pose: 1.into(),
        ap_mm: vec![0.04, 0.05, 0.056],
        rp_mm: vec![0.02, 0.021, 0.02],
        dap_mm: 0.016,
        dap_expanded_uncertainty_mm: Some(0.0042),
        drp_mm: 0.0,
        settled_after: None,
    }];
    poses.robot.exchangeability_mm = Some(0.0321);
    let epoch = |cycle, moved_mm| Iso9283Epoch { cycle, moved_mm, rms_mm: 0.1 * moved_mm };
    poses.recorded.reference = vec![epoch(1, 0.0), epoch(11, 0.012), epoch(21, 0.019)];
    let limit = |name, limit, value, conformity| {
        LimitVerdict::judge(name, limit, value, Some(0.0053), DecisionRule::Guarded).with(conformity)
    };
    poses.limits = vec![
        limit(LimitQuantity::AccuracyMaxMm, 0.052, 0.0512, Conformity::Neither),
        limit(LimitQuantity::RepeatabilityMaxMm, 0.03, 0.0217, Conformity::Conforming),
    ];
    let direction = Iso9283Compliance {
        direction: "+x".to_owned(),
        readings: 30,
        cycles: 3,
        force_n: 50.0,
        compliance_mm_n: 0.0021,
        standard_uncertainty_mm_n: Some(1.3e-5),
        largest_mm: 0.107,
        off_line_mm: 0.006,
    };
    let compliance = Iso9283ComplianceDocument {
        schema: "etalon/iso9283-compliance/1".to_owned(),
        conventions: vec!["least squares".into()],
        directions: vec![direction],
        messages: vec![],
    };
    Characteristics { poses: Some(poses), compliance: Some(compliance), ..Characteristics::default() }
}

pub(crate) fn iso9283() -> Iso9283Document {
    let mut noise = Noise::new(7, 1);
    let mut visits = vec![];
    for (i, pose) in (1..=30).flat_map(|_| [1_i32, 2]).enumerate() {
        let approach = (i > 0).then(|| format!("from pose {}", 3 - pose));
        let x_mm = 100.0 * f64::from(pose) + noise.gaussian(0.003);
        let attained_mm = [x_mm, 50.0 + noise.gaussian(0.006), noise.gaussian(0.002)];
        visits.push(Iso9283Visit { pose: i64::from(pose).into(), cycle: 1 + i as i64 / 2, approach, attained_mm });
    }
    let pose = |pose: i64| Iso9283Pose {
        pose: pose.into(),
        cycles: 30,
        rp_mm: Some(0.0217),
        enclosing_radius_mm: Some(0.0173),
        uncertainty_over_rp: Some(0.124),
        quarter_rule_met: Some(true),
        ..Iso9283Pose::default()
    };
    let of_approach = |name: &str, value_mm| Iso9283JudgedApproach {
        name: name.to_owned(),
        cycles: 15,
        value_mm,
        ellipsoid: Some(Iso9283Ellipsoid { semi_axes_mm: [0.0142, 0.0083, 0.0055], axes: AXES }),
        rp_without_noise_mm: Some(0.0107),
    };
    let approached = Iso9283Pose {
        rp_approach: Some(of_approach("from pose 2", 0.0111)),
        rp_smallest_approach: Some(of_approach("from pose 3", 0.0109)),
        position_uncertainty_mm: Some(0.0027),
        // 2.7 µm over 10.9 µm
        uncertainty_over_rp: Some(0.248),
        ..pose(1)
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
        conventions: vec!["positions alone".into()],
        frame: Some("frame of the table".into()),
        poses: vec![approached, pose(2)],
        distances: vec![],
        approaches: vec![Iso9283Variation {
            pose: 1.into(),
            mean_mm: Some([100.0, 50.0, 0.0]),
            vap_mm: 0.0123,
            between: ["from pose 2".to_owned(), "from pose 3".to_owned()],
            vap_angles_deg: vec![],
            vap_rotation_deg: None,
            approaches: vec![
                approach("from pose 2", [100.0, 50.006, 0.0]),
                approach("from pose 3", [100.0, 49.994, 0.0]),
            ],
        }],
        approach_phrases: [2, 3]
            .map(|pose| (format!("from pose {pose}"), phrase!("from-pose-named", pose)))
            .into_iter()
            .collect(),
        drifts: vec![],
        robot: Default::default(),
        recorded: Iso9283Recorded { visits, ..Iso9283Recorded::default() },
        limits: vec![],
        messages: vec![],
    }
}

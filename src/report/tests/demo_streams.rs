//! Recorded motions for trying the report: a path with a corner and a weave, synthetic.

use etalon_documents::*;

pub(crate) fn streams() -> Iso9283StreamsDocument {
    let stream = |name: &str, stream| Iso9283NamedStream {
        name: name.to_owned(),
        file: "motion.csv".to_owned(),
        band_mm: Some(0.05),
        stream,
    };
    let path = Iso9283StreamDocument { path: Some(path()), ..standing() };
    let weave = Iso9283StreamDocument { weaving: Some(weaving()), ..standing() };
    Iso9283StreamsDocument {
        schema: "etalon/iso9283-streams/1".to_owned(),
        streams: vec![stream("square", path), stream("seam", weave)],
    }
}

/// Three visits of two poses.
fn standing() -> Iso9283StreamDocument {
    let standstill = |i: i64| Iso9283Standstill {
        pose: Some((1 + i % 2).into()),
        cycle: Some(1 + i / 2),
        from_s: 5.0 * i as f64,
        to_s: 5.0 * i as f64 + 2.0,
        samples: 200,
        mean_mm: vec![100.0 + 0.001 * i as f64, 50.0, 0.0],
        mean_deg: vec![],
        noise_mm: Some(0.004),
        stabilisation_s: Some(0.31),
        overshoot_mm: Some(0.021),
        posing_s: Some(2.9),
    };
    Iso9283StreamDocument {
        schema: "etalon/iso9283-stream/1".to_owned(),
        conventions: vec!["times: as stamped in the recording".into()],
        samples: 3000,
        left_out: vec![],
        duration_s: 30.0,
        standstills: (0..6).map(standstill).collect(),
        settling: vec![Iso9283Settling {
            pose: 1.into(),
            arrivals: 3,
            stabilisation_s: 0.31,
            stabilisation_expanded_uncertainty_s: Some(0.052),
            overshoot_mm: 0.021,
            overshoot_expanded_uncertainty_mm: Some(0.006),
        }],
        arrivals: vec![Iso9283Arrival {
            pose: 1.into(),
            cycle: 1,
            time_s: vec![0.0, 0.1, 0.2, 0.3],
            away_mm: vec![0.05, 0.02, 0.06, 0.01],
        }],
        posing: vec![],
        path: None,
        weaving: None,
        messages: vec![],
    }
}

fn path() -> Iso9283Path {
    let point = |i: u32| Iso9283PathPoint {
        along_mm: 10.0 * f64::from(i),
        commanded_mm: vec![10.0 * f64::from(i), 0.0],
        mean_mm: vec![10.0 * f64::from(i), 0.02],
        deviation_mm: 0.02 + 0.001 * f64::from(i),
        rt_mm: Some(0.05 - 0.001 * f64::from(i)),
    };
    Iso9283Path {
        passes: 10,
        incomplete: 1,
        length_mm: 200.0,
        reorientation: false,
        at_mm: 0.04,
        at_interval: Some(Iso9283Interval { low_mm: 0.035, high_mm: 0.046 }),
        at_along_mm: 200.0,
        at_angles_deg: vec![],
        rt_mm: Some(0.05),
        rt_interval: Some(Iso9283Interval { low_mm: 0.038, high_mm: 0.061 }),
        rt_along_mm: Some(0.0),
        rt_angles_deg: vec![],
        velocity: Some(Iso9283Velocity {
            commanded_mm_s: 100.0,
            mean_mm_s: 99.2,
            av_percent: -0.8,
            rv_percent: Some(0.31),
            fv_mm_s: 1.7,
        }),
        corners: vec![Iso9283Corner {
            position_mm: vec![100.0, 0.0],
            cr_mm: 0.31,
            co_mm: 0.02,
            stabilisation_mm: Some(7.5),
        }],
        points: (0..=20).map(point).collect(),
    }
}

fn weaving() -> Iso9283Weaving {
    Iso9283Weaving {
        passes: 3,
        turns: 57,
        commanded_stroke_mm: 4.0,
        stroke_mm: 3.9,
        commanded_frequency_hz: 2.0,
        frequency_hz: 2.01,
        ws_percent: -2.5,
        wf_percent: 0.5,
    }
}

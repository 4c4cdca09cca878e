//! ISO 9283 against an independent program with 60 digits (`tests/selftest/make.py`), and ISO 230-2
//! against the report of another program on a measured axis (Paul Scherrer Institute, ecmccfg).

use crate::run::selftest::data::{Data, Slip};
use crate::run::selftest::row::{Rows, Subject, not_made};
use etalon_base::message::Result;
use etalon_base::phrase;
use etalon_base::pose::Vector;
use etalon_standards::iso230::{Approach, AxisPosition, AxisPositioning};
use etalon_standards::iso9283::load::{Loaded, compliance};
use etalon_standards::iso9283::motion::stream::Stream;
use etalon_standards::iso9283::path::accuracy::path_accuracy;
use etalon_standards::iso9283::path::commanded::CommandPoint;
use etalon_standards::iso9283::path::passes::{Pass, passes};
use etalon_standards::iso9283::path::repeatability::path_repeatability;
use etalon_standards::iso9283::path::velocity::path_velocity;
use etalon_standards::iso9283::pose::accuracy::{angle_accuracy_rad, pose_accuracy};
use etalon_standards::iso9283::pose::directions::variation;
use etalon_standards::iso9283::pose::distance::distance;
use etalon_standards::iso9283::pose::drift::drift;
use etalon_standards::iso9283::pose::exchangeability::exchangeability;
use etalon_standards::iso9283::pose::repeatability::{angle_repeatability_rad, pose_repeatability};

pub(crate) const SUBJECT: Subject = Subject {
    id: "standards",
    requirement: || phrase!("selftest-standards"),
    rows,
    slips: &[
        Slip::Digit("/published/iso230/forward_nm/0/0", 3),
        Slip::Swap("/iso9283/clouds_mm/0/0/0", "/iso9283/clouds_mm/0/0/1"),
        Slip::Swap("/published/iso230/forward_nm/2", "/published/iso230/backward_nm/2"),
        Slip::Unit("/iso9283/at_mm", 1.0 / 25.4),
    ],
};

fn rows(data: &Data) -> Vec<Rows> {
    let iso9283 = data.at("/iso9283");
    let mut rows = Rows::new("ISO 9283:1998");
    if let Err(problems) = poses(&iso9283, &mut rows).and_then(|()| path(&iso9283, &mut rows)) {
        rows.failed(not_made("ISO 9283", &problems));
    }
    vec![rows, axis(&data.at("/published/iso230"))]
}

/// A point of the reference data.
fn point(data: &Data, name: &str) -> Vector {
    data.points(name).first().copied().unwrap_or([f64::NAN; 3])
}

/// Characteristics of poses.
fn poses(data: &Data, rows: &mut Rows) -> Result<()> {
    let (at, other) = (point(data, "/at_mm"), point(data, "/other_mm"));
    let clouds: Vec<Vec<Vector>> = data.at("/clouds_mm").items().iter().map(|points| points.points("")).collect();
    let cloud = |i: usize| clouds.get(i).map_or(&[][..], Vec::as_slice);
    let angles = data.numbers("/angles_rad");
    let mut add = |name: &'static str, unit: &'static str, found: f64| {
        let expected = data.number(&format!("/expected/{name}"));
        rows.add(phrase!("selftest-characteristic", name), unit, [expected, found], 1e-9);
    };
    let accuracy = pose_accuracy(cloud(0), at)?;
    add("AP", "mm", accuracy.ap_mm);
    add("AP_x", "mm", accuracy.deviation_mm[0]);
    let repeatability = pose_repeatability(cloud(0))?;
    add("RP", "mm", repeatability.rp_mm);
    add("RP_y", "mm", repeatability.axis_mm[1]);
    add("AP_a", "rad", angle_accuracy_rad(&angles, data.number("/commanded_rad")));
    add("RP_a", "rad", angle_repeatability_rad(&angles));
    add("vAP", "mm", variation(clouds.get(..3).unwrap_or_default())?.vap_mm);
    let driven = distance(cloud(0), cloud(3), [at, other])?;
    add("AD", "mm", driven.ad_mm);
    add("RD", "mm", driven.rd_mm);
    add("AD_y", "mm", driven.ad_axis_mm[1]);
    let sets: Vec<Vec<Vector>> = cloud(0).chunks(10).map(<[Vector]>::to_vec).collect();
    let drifted = drift(1.into(), &sets, at)?;
    add("dAP", "mm", drifted.dap_mm);
    add("dRP", "mm", drifted.drp_mm);
    add("E", "mm", exchangeability(&[vec![cloud(0).to_vec()], vec![cloud(1).to_vec()]])?.e_mm);
    let forces = data.numbers("/forces_n");
    let loaded =
        |(force_n, position_mm): (&f64, Vector)| Loaded { force_n: *force_n, position_mm, unloaded_mm: [0.0; 3] };
    let readings: Vec<Loaded> = forces.iter().zip(data.points("/displacements_mm")).map(loaded).collect();
    add("compliance", "mm/N", compliance(&readings, [0.0, 0.0, -1.0])?.compliance_mm_n);
    Ok(())
}

/// Characteristics of a path.
fn path(data: &Data, rows: &mut Rows) -> Result<()> {
    let commands: Vec<CommandPoint> = data.points("/command_mm").into_iter().map(command).collect();
    let passes = driven(data, &commands)?;
    let velocity = path_velocity(&passes, &commands, data.number("/commanded_mm_s"), 1.0)?;
    let mut add = |name: &'static str, unit: &'static str, found: f64, permissible: f64| {
        let expected = data.number(&format!("/expected/{name}"));
        rows.add(phrase!("selftest-characteristic", name), unit, [expected, found], permissible);
    };
    add("AT", "mm", path_accuracy(&passes, &commands)?.at_mm, 1e-9);
    add("RT", "mm", path_repeatability(&passes, &commands)?.rt_mm, 1e-9);
    add("AV", "%", velocity.av_percent, 1e-6);
    add("RV", "%", velocity.rv_percent, 1e-6);
    add("FV", "mm/s", velocity.fv_mm_s, 1e-6);
    Ok(())
}

fn command(position_mm: Vector) -> CommandPoint {
    CommandPoint { along_mm: position_mm[0], position_mm, tangent: [1.0, 0.0, 0.0], angles_rad: Vec::new() }
}

/// A recording that crosses the plane of each command point where and when the reference data say,
/// and returns far away from the path.
fn driven(data: &Data, commands: &[CommandPoint]) -> Result<Vec<Pass>> {
    let (positions, times) = (data.points("/passes_mm"), data.numbers("/times_s"));
    let (mut time_s, mut at_mm) = (Vec::new(), Vec::new());
    let mut add = |time: f64, position: Vector| {
        time_s.push(time);
        at_mm.push(position);
    };
    let count = commands.len().max(1);
    for (k, (pass, times)) in positions.chunks_exact(count).zip(times.chunks_exact(count)).enumerate() {
        let begin = 10.0 * k as f64;
        for (p, t) in pass.iter().zip(times) {
            add(begin + t - 0.01, [p[0] - 2.0, p[1], p[2]]);
            add(begin + t + 0.01, [p[0] + 2.0, p[1], p[2]]);
        }
        for (after, x) in [(3.0, 200.0), (5.0, 200.0), (7.0, -100.0)] {
            add(begin + after, [x, if after < 4.0 { 0.0 } else { 500.0 }, 0.0]);
        }
        add(begin + 9.0, [-100.0, 0.0, 0.0]);
    }
    let stream = Stream::new(time_s, at_mm, &[])?;
    Ok(passes(&stream, commands, 5.0)?.complete)
}

/// Positioning of a measured axis.
fn axis(data: &Data) -> Rows {
    let mut rows = Rows::new("ISO 230-2:2014");
    let runs = |name: &str| -> Vec<Option<Approach>> {
        let of = |runs: &Data| Approach::new(&runs.numbers("").iter().map(|nm| nm * 1e-6).collect::<Vec<_>>());
        data.at(name).items().iter().map(of).collect()
    };
    let both = runs("/forward_nm").into_iter().zip(runs("/backward_nm"));
    let position = |(at, (forward, backward)): (f64, (Option<Approach>, Option<Approach>))| {
        Some(AxisPosition::new(at, forward?, backward?))
    };
    let positions: Vec<AxisPosition> =
        data.numbers("/positions_mm").into_iter().zip(both).filter_map(position).collect();
    let mut add = |name: &'static str, found: Vec<f64>| {
        let expected = data.numbers(&format!("/expected/{name}"));
        let found: Vec<f64> = found.iter().map(|mm| mm * 1e6).collect();
        // half a unit of the last published digit, and rounding
        rows.add_all(phrase!("selftest-characteristic", name), "nm", [&expected, &found], 0.0051);
    };
    let of = |value: fn(&AxisPosition) -> f64| positions.iter().map(value).collect::<Vec<f64>>();
    add("means_nm", of(|p| p.mean_mm));
    add("reversals_nm", of(|p| p.reversal_mm));
    add("r_forward_nm", of(|p| p.forward.repeatability_mm));
    add("r_backward_nm", of(|p| p.backward.repeatability_mm));
    add("r_both_nm", of(|p| p.repeatability_mm));
    let axis = AxisPositioning::new(&positions);
    let whole = [
        axis.reversal_mm,
        axis.mean_reversal_mm,
        axis.repeatability.forward_mm,
        axis.repeatability.backward_mm,
        axis.systematic.forward_mm,
        axis.systematic.backward_mm,
        axis.mean_systematic_mm,
        axis.accuracy.forward_mm,
        axis.accuracy.backward_mm,
    ];
    add("axis_nm", whole.to_vec());
    rows
}

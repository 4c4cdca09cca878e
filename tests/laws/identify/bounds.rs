//! Answers within their bounds are near the truth, in drawn cells from good to degenerate
//! (synthetic).

use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, minus, norm};
use etalon::identify::cell::{
    AxisReading, CellFrame, Measure, Stated, ThreePointRole, rotary_axis, three_points, tool_point,
};
use etalon::identify::{Extent, UncertaintyBound};
use etalon::robots::Quantity;

/// Errors beyond this multiple of the bound are what no accepted answer may have: U = 2 u is at most
/// the bound, and an error of 5 u does not occur in these draws.
const MOST: f64 = 2.5;

/// Counts of answers: accepted, refused.
#[derive(Default)]
struct Judged {
    accepted: usize,
    refused: usize,
}

impl Judged {
    /// Judges an answer whose errors (mm, rad) are known.
    fn add(&mut self, errors: &[(f64, Quantity)], covariance: &[f64], extent: &Extent) {
        let quantities: Vec<Quantity> = errors.iter().map(|e| e.1).collect();
        let bound = UncertaintyBound::default();
        if bound.exceeded(&quantities, covariance, extent).is_some() {
            self.refused += 1;
            return;
        }
        self.accepted += 1;
        for (error, quantity) in errors {
            let (limit, _) = bound.bound(*quantity, extent);
            assert!(error.abs() <= MOST * limit, "{error} beyond {limit}: {covariance:?}");
        }
    }
}

fn frame_errors(frame: &CellFrame, truth: &Pose) -> Vec<(f64, Quantity)> {
    let shift = minus(frame.pose.translation_mm, truth.translation_mm);
    let turn = frame.pose.then(&truth.inverse()).rotation_vector_rad();
    let lengths = shift.into_iter().map(|v| (v, Quantity::Length));
    lengths.chain(turn.into_iter().map(|v| (v, Quantity::Angle))).collect()
}

fn noisy(noise: &mut Noise, p: Vector, u_mm: f64) -> Vector {
    p.map(|v| v + noise.gaussian(u_mm))
}

/// A number between 10^from and 10^to, evenly in its logarithm.
fn drawn(noise: &mut Noise, from: f64, to: f64) -> f64 {
    let middle = 0.5 * (from + to);
    10f64.powf(middle + noise.uniform(0.5 * (to - from)))
}

#[test]
fn accepted_tool_points_are_within_their_bounds() {
    let (mut noise, mut judged) = (Noise::new(201, 0), Judged::default());
    for _ in 0..400 {
        let (turn, u_mm) = (drawn(&mut noise, -4.0, 0.0), drawn(&mut noise, -3.0, 0.0));
        let (tool, fixed) = ([30.0, -20.0, 180.0], [800.0, 100.0, 300.0]);
        let poses: Vec<Pose> = (0..8)
            .map(|_| {
                let turned = Pose::from_rotation_vector([0; 3].map(|_| noise.uniform(turn)));
                Pose { translation_mm: noisy(&mut noise, minus(fixed, turned.rotate(tool)), u_mm), ..turned }
            })
            .collect();
        let stated = Stated { position_mm: Some(u_mm), ..Stated::default() };
        let Ok(found) = tool_point(&poses, &stated) else {
            judged.refused += 1;
            continue;
        };
        let positions: Vec<Vector> = poses.iter().map(|p| p.translation_mm).collect();
        let spread =
            Extent::of_points(&positions, found.quality.standard_uncertainty(Measure::Position, &stated).unwrap());
        let extent = Extent { length_mm: spread.length_mm.max(norm(found.tool.at_mm)), ..spread };
        let errors = minus(found.tool.at_mm, tool).map(|v| (v, Quantity::Length));
        judged.add(&errors, found.tool.covariance_mm2.as_flattened(), &extent);
    }
    assert!(judged.accepted > 80 && judged.refused > 80, "{} {}", judged.accepted, judged.refused);
}

#[test]
fn accepted_frames_of_three_points_are_within_their_bounds() {
    let (mut noise, mut judged) = (Noise::new(202, 0), Judged::default());
    for _ in 0..600 {
        let truth = Pose { translation_mm: [200.0, -100.0, 50.0], ..Pose::from_rotation_vector([0.4, -0.2, 0.7]) };
        let (length, height) = (drawn(&mut noise, -2.0, 3.0), drawn(&mut noise, -2.0, 3.0));
        let u_mm = drawn(&mut noise, -3.0, 0.0);
        let touched = [[0.0; 3], [length, 0.0, 0.0], [0.3 * length, height, 0.0]]
            .map(|p| [noisy(&mut noise, truth.apply(p), u_mm)]);
        let of = |k: usize| &touched[k][..];
        let Ok(found) = three_points([of(0), of(1), of(2)], ThreePointRole::OriginXPlane, Some(u_mm)) else {
            judged.refused += 1;
            continue;
        };
        let extent = Extent::of_points(touched.as_flattened(), u_mm);
        judged.add(&frame_errors(&found.frame, &truth), found.frame.covariance.as_flattened(), &extent);
    }
    assert!(judged.accepted > 100 && judged.refused > 100, "{} {}", judged.accepted, judged.refused);
}

#[test]
fn accepted_rotary_axes_are_within_their_bounds() {
    let (mut noise, mut judged) = (Noise::new(203, 0), Judged::default());
    for _ in 0..300 {
        let truth = Pose { translation_mm: [600.0, -200.0, 110.0], ..Pose::from_rotation_vector([0.2, 0.1, -0.4]) };
        let (radius, arc) = (drawn(&mut noise, -2.5, 2.5), drawn(&mut noise, -1.0, 0.8));
        let u_mm = drawn(&mut noise, -3.0, -1.0);
        let readings: Vec<AxisReading> = (0..12)
            .map(|i| {
                let value = arc * (f64::from(i) / 11.0 - 0.5);
                let at = truth.turn_z(value).apply([radius, 0.0, 0.0]);
                AxisReading { target: 0, value, position_mm: noisy(&mut noise, at, u_mm) }
            })
            .collect();
        let stated = Stated { position_mm: Some(u_mm), ..Stated::default() };
        let Ok(found) = rotary_axis(&readings, &stated) else {
            judged.refused += 1;
            continue;
        };
        let points: Vec<Vector> = readings.iter().map(|r| r.position_mm).collect();
        let u_mm = found.quality.standard_uncertainty(Measure::Position, &stated).unwrap();
        let extent = Extent::of_points(&points, u_mm);
        judged.add(&frame_errors(&found.frame, &truth), found.frame.covariance.as_flattened(), &extent);
    }
    assert!(judged.accepted > 50 && judged.refused > 50, "{} {}", judged.accepted, judged.refused);
}

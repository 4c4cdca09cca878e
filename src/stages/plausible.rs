//! Whether a result can be a robot at all: what must never reach a controller, however well it converged.

use crate::base::message::Message;
use crate::base::pose::{centroid, minus, norm};
use crate::document::PointError;
use crate::math::identify::{Identification, Observation, Settings, chi_square_exceeds, outliers};
use crate::math::robots::{Parameter, Quantity, Robot, Role};

/// Gains and couplings further than this from nominal are not errors of a transmission.
const RATIO: f64 = 0.1;
/// A calibrated model leaves thousandths of the workspace; more than this share of it is another robot.
const LEFT: f64 = 0.02;
/// Errors after over errors before beyond which it is not noise that makes an already good robot look no better.
const WORSE: f64 = 1.1;

/// Messages about `found` and the errors that it leaves: errors where it can be no robot, and which of the observations to
/// look at first where they do not fit.
pub fn doubts(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    found: &Identification,
    errors: &[PointError],
) -> Vec<Message> {
    let mut messages = implausible(robot, &found.values, errors);
    let misfit = match found.chi_square {
        Some(chi_square) => chi_square_exceeds(chi_square, found.degrees_of_freedom),
        None => !messages.is_empty(),
    };
    if misfit {
        messages.extend(outliers(robot, observations, settings, found));
    }
    messages
}

/// Errors about the parameters `values` and the errors that they leave; empty where the result is plausible.
fn implausible(robot: &dyn Robot, values: &[f64], errors: &[PointError]) -> Vec<Message> {
    let mut messages = Vec::new();
    if let Some((p, value)) = exchanged(robot, values) {
        let what = format!("K and L are exchanged: `{}`, their distance, is {value:.3} {}", p.name, p.quantity.unit());
        return vec![Message::error(what).hint("exchange the names of the two targets in the labels of the export")];
    }
    for (p, value) in robot.parameters().iter().zip(values) {
        if p.role == Role::Robot && p.quantity == Quantity::Ratio && (value - p.nominal).abs() > RATIO {
            messages.push(
                Message::error(format!("`{}` = {value:.4} is not plausible: its nominal value is {}", p.name, p.nominal))
                    .hint("check sign and unit of the joint in the log, and whether the world frame is right-handed (`towards`)"),
            );
        }
    }
    for set in ["calibration", "validation"] {
        let of = || errors.iter().filter(|e| e.set == set);
        let rms = |size: &dyn Fn(&PointError) -> f64| {
            (of().map(|e| size(e).powi(2)).sum::<f64>() / of().count().max(1) as f64).sqrt()
        };
        let (before, after) = (rms(&|e| norm(e.before_mm)), rms(&|e| norm(e.after_mm)));
        let all: Vec<_> = of().map(|e| e.at_mm).collect();
        let middle = centroid(&all).unwrap_or_default();
        let spread = rms(&|e| norm(minus(e.at_mm, middle)));
        if after > LEFT * spread && of().count() > 1 {
            messages.push(
                Message::error(format!(
                    "the model does not describe this robot: on the {set} poses {after:.3} mm are left (root mean square) of \
                     positions that spread over {spread:.1} mm"
                ))
                .hint("check units, order and signs of the joints, the nominal parameters, and how log and points are joined"),
            );
        } else if after > WORSE * before {
            messages.push(
                Message::error(format!(
                    "on the {set} poses the identified robot is worse than the nominal one: {before:.4} mm before, {after:.4} mm \
                     after (root mean square)"
                ))
                .hint("measure more poses, spread over the workspace, or hold parameters that they do not determine"),
            );
        }
    }
    messages
}

/// The distance of K and L where it came out negative: each was measured where the other is.
fn exchanged<'r>(robot: &'r dyn Robot, values: &[f64]) -> Option<(&'r Parameter, f64)> {
    let i = robot.platform()?.target_distance();
    let p = &robot.parameters()[i];
    (values[i] * p.nominal < 0.0).then_some((p, values[i]))
}

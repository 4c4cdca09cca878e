//! With nominal values as readings every problem has a solution, and the solver finds it: drawn robots, excitations and measurements
//! (synthetic). `ETALON_PROBLEMS` states how many, `ETALON_FIRST` the first of them.

use crate::identify::drawn::{Drawn, drawn_problem, number};
use etalon::base::message::Severity;
use etalon::identify::{Prior, fit_frames, identify_from};
use etalon::robots::Quantity;
use rayon::prelude::*;

/// Residuals over noise, root mean square, beyond which a solution of data without model errors is another minimum.
const MUCH: f64 = 3.0;

/// What is wrong with the identification of a problem; `None` where nothing is.
fn fault(problem: &Drawn) -> Option<String> {
    let settings = problem.settings(Prior::TOLERANCES);
    let robot = problem.robot.as_ref();
    let before = match fit_frames(robot, &problem.calibration, &settings) {
        Ok(before) => before,
        Err(error) => return Some(format!("base and targets: {error:?}")),
    };
    let found = match identify_from(robot, &problem.calibration, &settings, &before) {
        Ok(found) => found,
        Err(error) => return Some(format!("{error:?}")),
    };
    if !found.termination.is_success() {
        return Some(found.termination.to_string());
    }
    if let Some(error) = found.warnings.iter().find(|w| w.severity == Severity::Error) {
        return Some(error.what.clone());
    }
    if !problem.bends && found.rms > MUCH * problem.noise_mm {
        return Some(format!("{:.4} mm are left of noise of {:.4} mm", found.rms, problem.noise_mm));
    }
    // no uncertainty exceeds what was known before by more than rounding
    let known = |i: usize| match robot.parameters()[i].quantity {
        Quantity::Length => 2000.0,
        Quantity::Angle => 4.0,
        Quantity::Ratio => 0.1,
    };
    let uncertainties = found.free.iter().map(|&i| (i, found.standard_uncertainty(i).unwrap_or(0.0)));
    let weak = found.weak.iter().flat_map(|w| w.parameters.iter().copied().zip(w.standard_uncertainties.clone()));
    let absurd = uncertainties.chain(weak).find(|&(i, u)| !(u <= known(i)));
    absurd.map(|(i, u)| format!("u({}) = {u:.3e}", robot.parameters()[i].name))
}

#[test]
fn every_problem_converges() {
    let (first, count) = (number("ETALON_FIRST", 0), number("ETALON_PROBLEMS", 60));
    let faults: Vec<String> = (first..first + count)
        .into_par_iter()
        .filter_map(|seed| {
            let problem = drawn_problem(seed);
            Some(format!("{}: {}", problem.what, fault(&problem)?))
        })
        .collect();
    faults.iter().for_each(|fault| println!("{fault}"));
    println!("{} of {count} drawn problems (synthetic) end without a solution", faults.len());
    assert!(faults.is_empty(), "{faults:#?}");
}

//! With nominal values as readings every problem has a solution, and the solver finds it: drawn robots, excitations and measurements
//! (synthetic). `ETALON_PROBLEMS` states how many, `ETALON_FIRST` the first of them.

use crate::identify::drawn::{Drawn, drawn_problem, number};
use etalon::base::message::Severity;
use etalon::identify::{Prior, fit_frames, identify_from};
use etalon::robots::Quantity;
use rayon::prelude::*;

/// Residuals over noise, root mean square, beyond which a solution of data without model errors is another minimum.
const MUCH: f64 = 3.0;
/// Problems of thousand that may end there: a few poses along a short line leave several places of the base.
const OTHER_MINIMA: usize = 5;

/// How an identification failed.
enum Fault {
    /// It ended without a solution, or with one that says nothing.
    Unsolved(String),
    /// It ended at another minimum than that of the true robot.
    OtherMinimum(String),
}

/// What is wrong with the identification of a problem; `None` where nothing is.
fn fault(problem: &Drawn) -> Option<Fault> {
    let settings = problem.settings(Prior::TOLERANCES);
    let robot = problem.robot.as_ref();
    let unsolved = |what: String| Some(Fault::Unsolved(format!("{}: {what}", problem.what)));
    let before = match fit_frames(robot, &problem.calibration, &settings) {
        Ok(before) => before,
        Err(error) => return unsolved(format!("base and targets: {error:?}")),
    };
    let found = match identify_from(robot, &problem.calibration, &settings, &before) {
        Ok(found) => found,
        Err(error) => return unsolved(format!("{error:?}")),
    };
    if !found.termination.is_success() {
        return unsolved(found.termination.to_string());
    }
    if let Some(error) = found.warnings.iter().find(|w| w.severity == Severity::Error) {
        return unsolved(error.what.clone());
    }
    // no uncertainty exceeds what was known before
    let known = |i: usize| match robot.parameters()[i].quantity {
        Quantity::Length => 2000.0,
        Quantity::Angle => 4.0,
        Quantity::Ratio => 0.1,
    };
    let uncertainties = found.free.iter().map(|&i| (i, found.standard_uncertainty(i).unwrap_or(0.0)));
    let weak = found
        .identifiability
        .weak
        .iter()
        .flat_map(|w| w.parameters.iter().copied().zip(w.standard_uncertainties.clone()));
    if let Some((i, u)) = uncertainties.chain(weak).find(|&(i, u)| u.is_nan() || u > known(i)) {
        return unsolved(format!("u({}) = {u:.3e}", robot.parameters()[i].name));
    }
    (!problem.bends && found.residuals.rms > MUCH * problem.noise_mm).then(|| {
        let left =
            format!("{}: {:.4} mm are left of noise of {:.4} mm", problem.what, found.residuals.rms, problem.noise_mm);
        Fault::OtherMinimum(left)
    })
}

#[test]
fn every_problem_converges() {
    let (first, count) = (number("ETALON_FIRST", 0), number("ETALON_PROBLEMS", 60));
    let all: Vec<Fault> =
        (first..first + count).into_par_iter().filter_map(|seed| fault(&drawn_problem(seed))).collect();
    let (mut unsolved, mut others) = (Vec::new(), Vec::new());
    for fault in all {
        match fault {
            Fault::Unsolved(text) => unsolved.push(text),
            Fault::OtherMinimum(text) => others.push(text),
        }
    }
    println!(
        "of {count} drawn problems (synthetic) {} end without a solution, {} at another minimum: {unsolved:#?} {others:#?}",
        unsolved.len(),
        others.len()
    );
    assert!(unsolved.is_empty(), "{unsolved:#?}");
    assert!(1000 * others.len() <= OTHER_MINIMA * count as usize, "{others:#?}");
}

//! Remedies for identifications without a result and for wrong readings, in keys of campaign.toml,
//! columns of tables and options of the command line.

use crate::stages::truncated;
use etalon_base::catalogue::{Argument, Phrase};
use etalon_base::message::{AnsweredBy, Message, Problems};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase, warning};
use etalon_documents::{ErrorQuantity, set_up_hint, warning_message};
use etalon_identify::{Cause, Error, ErrorKind, Reading, RobustFit};
use etalon_robots::Robot;

/// The messages of an error of [`etalon_identify`] with the remedy as the hint of the first.
pub fn remedied(error: Error) -> Problems {
    let remedy = match &error {
        Error::Other(_) => None,
        Error::PoseWithoutUncertainty => Some("pose-uncertainty"),
        Error::CommonUncertaintyAlone => Some("contact-uncertainty"),
        Error::UnknownParameter { pattern, names } => {
            let message = error!("parameter-unknown", pattern);
            return message.hint_names(pattern, names.iter().map(String::as_str)).into();
        }
        Error::NotAnArm { .. } => Some("targets"),
        Error::KindsWithoutUncertainty => Some("uncertainty"),
        Error::OwnUncertainties => Some("own-uncertainties"),
        Error::ReadingsWithoutUncertainty { .. } => Some("row-uncertainty"),
        Error::NotPlanar { .. } => Some("compare-targets"),
        Error::NoSuchPart { .. } => Some("part"),
        Error::TooFewPoses { .. } => Some("positions"),
        Error::Unexplained(warning) => return warning_message(warning).into(),
        Error::NothingLeft { set_up: Some(found), .. } | Error::Failed { set_up: Some(found), .. } => {
            let hint = set_up_hint(found);
            let mut messages = error.messages();
            messages.iter_mut().take(1).for_each(|first| first.hint = Some(hint.clone()));
            return Problems(messages);
        }
        Error::NothingLeft { cause: Some(cause), .. } | Error::Failed { cause: Some(cause), .. } => Some(check(cause)),
        Error::NothingLeft { .. } => Some("hold-fewer"),
        Error::Undetermined { .. } => Some("more-poses"),
        Error::Unsteady => Some("hold"),
        Error::Failed { .. } => Some("joints"),
    };
    let mut messages = error.messages();
    if let (Some(remedy), false) = (remedy, messages.is_empty()) {
        let first = messages.remove(0).hint(phrase!("remedy", remedy));
        messages.insert(0, first);
    }
    Problems(messages)
}

/// Returns the name of the remedy for a cause in the text `remedy`.
fn check(cause: &Cause) -> &'static str {
    match cause {
        Cause::Unreachable(_) => "unreachable",
        Cause::Extent { .. } => "extent",
        Cause::AssemblyMode { .. } => "assembly",
        Cause::Readings { .. } => "readings",
    }
}

/// Size of an error with its reading.
pub(super) fn reading(off_mm: f64, target: &str, pose: PoseName, cycle: i64) -> Phrase {
    phrase!("reading-off", off_mm, target, pose, cycle)
}
/// Number of readings that are named without outliers.
const NAMED: usize = 3;
/// Maximum number of named outliers.
const NAMED_OUTLIERS: usize = 40;

/// Readings to check first if residuals exceed the instrument's uncertainty: the outliers, or the
/// largest residuals.
pub(super) fn readings_to_check(robust: &RobustFit, robot: &dyn Robot) -> Message {
    match robust.outliers().is_empty() {
        true => {
            warning!("largest-residuals", readings = named(&robust.readings, NAMED.min(robust.readings.len()), robot))
        }
        false => warning!("outliers", outliers = outliers(robust, robot))
            .to_decide()
            .answered_by(AnsweredBy::NextStep)
            .hint(phrase!("check-readings")),
    }
}

/// Outliers that were excluded from the identification.
pub(super) fn outliers_excluded(robust: &RobustFit, robot: &dyn Robot) -> Message {
    warning!("outliers-excluded", outliers = outliers(robust, robot))
}

fn outliers(robust: &RobustFit, robot: &dyn Robot) -> Phrase {
    let outliers = robust.outliers();
    let (count, total) = (outliers.len(), robust.readings.len());
    let is_concerned = |quantity: &Option<ErrorKind>| outliers.iter().any(|r| r.quantity == *quantity);
    let times = outliers.iter().map(|r| robust.limit(r.quantity)).fold(f64::INFINITY, f64::min);
    let times = (10.0 * times).round() / 10.0;
    let scales = robust.scales.iter().filter(|(quantity, _)| is_concerned(quantity));
    let scales: Vec<Phrase> = scales.map(|(quantity, scale)| standard_deviation(*quantity, *scale)).collect();
    phrase!("outlier-readings", count, total, times, scales, readings = named(outliers, NAMED_OUTLIERS, robot))
}

/// Standard deviation (mm, rad) of a quantity, with the name of the quantity.
fn standard_deviation(quantity: Option<ErrorKind>, deviation: f64) -> Phrase {
    match quantity.map(ErrorQuantity::from) {
        None => phrase!("deviation-of-angles", deviation_deg = deviation.to_degrees()),
        Some(quantity) => phrase!("deviation-of-lengths", deviation_mm = deviation, quantity = quantity.phrase()),
    }
}

fn named(readings: &[Reading], most: usize, robot: &dyn Robot) -> Vec<Argument> {
    let text = |r: &Reading| {
        let (target, pose, cycle) = (&robot.targets()[r.target], r.pose, r.cycle);
        match r.quantity {
            None => phrase!("orientation-off", off_deg = r.left.to_degrees(), target, pose, cycle),
            Some(ErrorKind::Position) => reading(r.left, target, pose, cycle),
            Some(kind) => {
                let quantity = ErrorQuantity::from(kind).phrase();
                phrase!("quantity-off", off_mm = r.left, quantity, target, pose, cycle)
            }
        }
    };
    truncated(readings.iter().map(text), most)
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::catalogue::IntoArgument;
    use etalon_base::phrase;
    use etalon_identify::{Origin, SetUpError};

    #[test]
    fn a_change_of_the_set_up_comes_before_the_remedy_for_the_cause() {
        let cause = Cause::Extent { measured_mm: 20.0, model_mm: 508.0 };
        let hint = |set_up| {
            let error = Error::NothingLeft { cause: Some(cause.clone()), set_up };
            remedied(error).0.remove(0).hint.unwrap()
        };
        let inches = phrase!("slip-unit", quantity = "points", slip = "inch-mm");
        let changes = vec![(inches, Origin::Unit), (phrase!("slip-reversed", joint = "`q1`"), Origin::Named)];
        let set_up = SetUpError { changes, stated_mm: 9.0, changed_mm: 1.0, angles_rad: [0.0; 2] };
        let expected = etalon_documents::set_up_hint(&set_up);
        let found = hint(Some(set_up));
        for part in ["(`unit` of the export)", "`q1` reversed", "9.000 mm", "1.000 mm"] {
            assert!(found.contains(part), "{found}");
        }
        assert_eq!(found, expected);
        assert_eq!(hint(None), phrase!("remedy", remedy = check(&cause)).to_string());
    }

    #[test]
    fn undetermined_parameters_are_named_one_by_one() {
        let groups = vec![("a".to_owned(), Vec::new()), ("b".to_owned(), vec!["c".to_owned(), "d".to_owned()])];
        let messages = remedied(Error::Undetermined { counts: [6, 1, 4, 6], groups }).0;
        let counts: [(&str, &dyn IntoArgument); 4] =
            [("residuals", &6), ("poses", &1), ("independent", &4), ("parameters", &6)];
        assert!(messages[0].is("parameters-undetermined", &counts), "{}", messages[0]);
        assert!(messages[1].is("parameter-without-effect", &[("parameter", &"a")]), "{}", messages[1]);
        let of_b: [(&str, &dyn IntoArgument); 2] = [("parameter", &"b"), ("others", &["`c`", "`d`"])];
        assert!(messages[2].is("parameters-inseparable", &of_b), "{}", messages[2]);
        assert!(messages[0].hint.is_some() && messages[1].hint.is_none());
    }
}

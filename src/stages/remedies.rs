//! Remedies for identifications without a result and for wrong readings, in keys of campaign.toml, columns of tables and options of the command line.

use etalon_base::message::{Message, Problems};
use etalon_documents::{set_up_hint, warning_message};
use etalon_identify::{Cause, Error, OUTLIER, Reading, RobustFit};
use etalon_robots::Robot;

/// The messages of an error of [`etalon_identify`] with the remedy as the hint of the first.
pub fn remedied(error: Error) -> Problems {
    let set_up;
    let hint = match &error {
        Error::Other(_) => None,
        Error::PoseWithoutUncertainty => Some("state it (--standard-uncertainty-um), or compare targets"),
        Error::CommonUncertaintyAlone => {
            Some("state the repeatability of the contact (--standard-uncertainty-um) too, and compare targets")
        }
        Error::UnknownParameter { pattern, names } => {
            let what = format!("`hold` names `{pattern}`, which is not a parameter of this robot");
            return Message::error(what).hint_names(pattern, names.iter().map(String::as_str)).into();
        }
        Error::NotAnArm { .. } => Some("give positions of its targets: rows of kind `point`"),
        Error::KindsWithoutUncertainty => Some("state it (--standard-uncertainty-um)"),
        Error::OwnUncertainties => Some("compare targets, or leave the columns of uncertainties out"),
        Error::ReadingsWithoutUncertainty { .. } => Some("state it in every row, or with --standard-uncertainty-um"),
        Error::NotPlanar { model } => {
            let what = format!("`residuals = \"pose\"` is for planar robots, not for `{model}`");
            return Message::error(what).hint("use `residuals = \"targets\"`").into();
        }
        Error::NoSuchPart { .. } => {
            Some("`frame` is `flange` for an arm, `platform` for a PreXYT, `targets` for any robot")
        }
        Error::TooFewPoses { .. } => Some("choose more positions, or hold parameters with `--hold`"),
        Error::BaseNotFound => {
            Some("measure more poses, or state base_x .. base_rz and the targets under [nominal] in the robot file")
        }
        Error::Unexplained(warning) => return warning_message(warning).into(),
        Error::NothingLeft { set_up: Some(found), .. } | Error::Failed { set_up: Some(found), .. } => {
            set_up = set_up_hint(found);
            Some(&*set_up)
        }
        Error::NothingLeft { cause: Some(cause), .. } | Error::Failed { cause: Some(cause), .. } => Some(check(cause)),
        Error::NothingLeft { .. } => Some("hold fewer parameters, and measure more poses"),
        Error::Undetermined { .. } => Some(
            "measure more poses (repeats of a pose add nothing), or hold parameters with `hold` in [identify] or --hold",
        ),
        Error::Unsteady => Some("hold parameters in [identify], or measure more poses"),
        Error::Failed { .. } => Some(
            "check units, order and signs of the joints and the nominal parameters; `hold` in [identify] holds parameters",
        ),
    };
    let hint = hint.map(str::to_owned);
    let mut messages = error.messages();
    if let (Some(first), Some(hint)) = (messages.first_mut(), hint) {
        first.hint = Some(hint);
    }
    Problems(messages)
}

/// The remedy for a cause.
fn check(cause: &Cause) -> &'static str {
    match cause {
        Cause::Unreachable(_) => {
            "check unit (degrees or radians), sign and offset of the joints, and the nominal parameters"
        }
        Cause::Extent { .. } => {
            "check `unit` of the exports, the units of the joints in the log, and the lengths of the robot"
        }
        Cause::AssemblyMode { .. } => {
            "correct the column `assembly` of these poses, or leave it empty: the mode is then taken from the measurement"
        }
    }
}

/// Remedy for readings that others contradict.
pub(super) const WRONG_READINGS: &str = "look there for exchanged labels and wrong readings; measure them again, or leave them out with `exclude` in [identify]";
/// Number of readings that are named where none is an outlier.
const NAMED: usize = 3;
/// Largest number of outliers that are named.
const NAMED_OUTLIERS: usize = 40;

/// Readings to look at first where the instrument does not explain the residuals: the outliers, or the largest residuals.
pub(super) fn readings_to_check(robust: &RobustFit, robot: &dyn Robot) -> Message {
    let named = |readings: &[Reading]| -> String {
        let target = |r: &Reading| robot.targets()[r.target].as_str();
        let text = |r: &Reading| format!("{:.4} mm ({}, pose {}, cycle {})", r.left_mm, target(r), r.pose, r.cycle);
        readings.iter().map(text).collect::<Vec<_>>().join(", ")
    };
    let outliers = robust.outliers();
    if outliers.is_empty() {
        let largest = &robust.readings[..robust.readings.len().min(NAMED)];
        let hint =
            "look there first for exchanged labels and wrong readings; errors of the robot are spread over all poses";
        return Message::warning(format!("largest residuals of a robust fit: {}", named(largest))).hint(hint);
    }
    let more = if outliers.len() > NAMED_OUTLIERS { ", ..." } else { "" };
    let what = format!(
        "{} of {} readings {}, more than {OUTLIER:.0} times {:.4} mm, the standard deviation of the others in a robust \
         fit: {}{more}",
        outliers.len(),
        robust.readings.len(),
        if outliers.len() == 1 { "is an outlier" } else { "are outliers" },
        robust.scale_mm,
        named(&outliers[..outliers.len().min(NAMED_OUTLIERS)]),
    );
    Message::warning(what).to_decide().hint(WRONG_READINGS)
}

#[cfg(test)]
mod tests {
    use super::*;
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
        let found = hint(Some(SetUpError { changes, stated_mm: 9.0, changed_mm: 1.0 }));
        let expected = "with the measured points in inches instead of millimetres (`unit` of the export) (as well with `q1` \
                        reversed), an identification leaves 1.000 mm";
        assert!(found.starts_with(expected), "{found}");
        assert_eq!(hint(None), check(&cause));
    }

    #[test]
    fn undetermined_parameters_are_named_one_by_one() {
        let groups = vec![("a".to_owned(), Vec::new()), ("b".to_owned(), vec!["c".to_owned(), "d".to_owned()])];
        let messages = remedied(Error::Undetermined { counts: [6, 1, 4, 6], groups }).0;
        assert_eq!(messages[0].what, "6 residuals from 1 pose, 4 of them independent, do not determine 6 parameters");
        assert_eq!(messages[1].what, "the data do not depend on `a`");
        assert_eq!(messages[2].what, "`b` is not separately identifiable from `c`, `d`");
        assert!(messages[0].hint.is_some() && messages[1].hint.is_none());
    }
}

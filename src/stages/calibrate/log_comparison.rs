//! Comparison of the identified log with the other logs of a campaign.

use crate::stages::calibrate::selection::{CampaignData, Division};
use crate::stages::calibrate::solution::Solution;
use crate::stages::evaluate::sets::{Sets, split};
use crate::stages::kinds::Observed;
use crate::stages::observe::exclusions::{Exclusion, exclude};
use crate::stages::remedies::remedied;
use etalon_base::message::{Message, Result};
use etalon_base::{phrase, warning};
use etalon_identify::Fitted;
use etalon_robots::Robot;

/// Minimum correlation of residuals with the difference from another log that is reported.
const CORRELATED: f64 = 0.3;

/// Messages of the comparison of logs.
#[derive(Default)]
pub(crate) struct LogComparison {
    /// Remarks on the observations of the other logs.
    pub observations: Vec<Message>,
    /// Warnings about correlations.
    pub correlations: Vec<Message>,
}

/// A log, its observations, and the parameters that they give.
struct LogFit<'a> {
    name: &'a str,
    sets: &'a Sets,
    values: &'a [f64],
    /// Root mean square of the residuals (mm).
    rms_mm: f64,
}

/// Compares the solution from the first log with each other log.
///
/// # Errors
/// Fails if another log cannot be read, or if its fit fails.
pub(crate) fn compare_logs(
    data: CampaignData,
    robot: &dyn Robot,
    division: &Division,
    solution: &Solution,
) -> Result<LogComparison> {
    let CampaignData { campaign, stated, joined, .. } = data;
    let Solution { basis, found, .. } = solution;
    let mut comparison = LogComparison::default();
    for (name, log) in joined.observations.iter().skip(1) {
        let observations = log.positions(robot, &mut comparison.observations)?;
        let mut theirs = Observed { observations, settings: campaign.settings(stated) };
        exclude(&Exclusion::from_campaign(campaign, stated), robot, &mut theirs)?;
        let others = split(&theirs, &division.measured, &division.selections);
        let Fitted { values, rms } = Fitted::new(robot, &others.calibration, &basis.settings).map_err(remedied)?;
        let used = &campaign.file.logs[0].name;
        let first = LogFit { name: used, sets: &basis.sets, values: &found.values, rms_mm: found.residuals.rms };
        let other = LogFit { name, sets: &others, values: &values, rms_mm: rms };
        comparison.correlations.extend(correlation(robot, &first, &other, used));
        comparison.correlations.extend(correlation(robot, &other, &first, used));
    }
    Ok(comparison)
}

/// Returns a warning if the residuals with one log correlate with its difference from another log;
/// `used` is the campaign's choice.
fn correlation(robot: &dyn Robot, this: &LogFit, that: &LogFit, used: &str) -> Option<Message> {
    let compared = etalon_identify::compare_logs(robot, this.values, &this.sets.calibration, &that.sets.calibration)?;
    if compared.correlation <= CORRELATED {
        return None;
    }
    let of_position = (robot.dimension() as f64).sqrt();
    let message = |log: &LogFit, hint| {
        warning!(
            "log-correlates",
            log = this.name,
            correlation = compared.correlation,
            rms_mm = of_position * this.rms_mm,
            other = that.name,
            other_rms_mm = of_position * that.rms_mm
        )
        .hint(phrase!("use-log", log = log.name, hint))
    };
    Some(match this.name == used {
        true => message(that, "name-first").to_decide(),
        false => message(that, "is-used").routine(),
    })
}

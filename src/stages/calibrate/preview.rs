//! Preview of an identification, before the solver.

use crate::stages::calibrate::selection::{Input, indices, uncalibrated_series};
use crate::stages::evaluate::sets::split;
use crate::stages::join::Joined;
use crate::stages::judge::circumstances::{contradicted_load, hold_constant};
use crate::stages::judge::excitation::{still_joints, travels, unmoved};
use crate::stages::judge::readings::check_readings;
use crate::stages::judge::set_up::check_set_up;
use crate::stages::observe::exclusions::exclude;
use crate::stages::observe::repeats::stale;
use etalon_base::message::{Message, Result, Severity};
use etalon_campaign::Campaign;
use etalon_documents::JointTravel;
use etalon_identify::Settings;
use etalon_robots::Robot;

/// Signs of a wrong set-up of the first log before an identification: repeated readings, or a
/// nominal robot far from the measurements.
pub fn preview(campaign: &Campaign, robot: &mut dyn Robot, joined: &Joined) -> Result<Preview> {
    let (Some(stated), Some((_, observations))) = (&campaign.file.identify, joined.observations.first()) else {
        return Ok(Preview::default());
    };
    let mut messages = Vec::new();
    let input = Input::new(campaign, stated, observations)?;
    let mut observed = input.read(robot, &mut messages)?;
    let measured = observed.poses();
    messages.extend(exclude(&input.exclusions, robot, &mut observed)?);
    messages.extend(stale(robot, &observed.observations));
    match check_set_up(robot, &observed.observations, &observed.settings) {
        Ok(remarks) => {
            messages.extend(remarks);
            messages.extend(check_readings(robot, &observed.observations, &observed.settings));
        }
        Err(problems) => messages.extend(problems.0),
    }
    // selections that do not read are reported with the statements
    let Ok(selections) = campaign.selections(stated) else { return Ok(Preview { messages, ..Preview::default() }) };
    let poses = observed.poses();
    messages.extend(uncalibrated_series(stated, &selections.calibration_series(indices(&poses, &measured))));
    let sets = split(&observed, &measured, &selections);
    let mut settings = Settings { conditions: sets.calibration_conditions.clone(), ..observed.settings };
    messages.extend(hold_constant(robot, &sets, &mut settings));
    messages.extend(contradicted_load(campaign, robot, &sets));
    if messages.iter().all(|message| message.severity != Severity::Error) {
        messages.extend(unmoved(robot, &sets.calibration, &settings, None).err().unwrap_or_default().0);
        messages.extend(still_joints(robot, &sets.calibration, &settings));
    }
    let joints = travels(robot, &sets.calibration, &settings);
    Ok(Preview { messages, joints })
}

/// Findings of a check of observations.
#[derive(Default)]
pub struct Preview {
    /// Errors and warnings.
    pub messages: Vec<Message>,
    /// Ranges of the joints in the calibration poses.
    pub joints: Vec<JointTravel>,
}

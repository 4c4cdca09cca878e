//! `etalon identify`

use super::table_file::TableFile;
use super::{Verdict, answer, remark};
use crate::base::files;
use crate::base::message::{Message, Problems};
use crate::campaign::read_robot;
use crate::document::to_json;
use crate::math::identify::{ResidualKind, Settings, fit_frames, identify_from};
use crate::report::Faces;
use crate::stages::evaluate::{self, Sets};
use crate::stages::kinds::{self, Uncertainties};
use crate::stages::parameters::parameters_document;
use crate::stages::plausible::plausibility;
use crate::stages::repeats::stale;
use std::path::PathBuf;

/// Standard uncertainties of a coordinate; beyond them the unit is another.
const PLAUSIBLE_UM: std::ops::RangeInclusive<f64> = 0.02..=1e5;

/// Identify the parameters of a robot from a table of observations, without a campaign
#[derive(Debug, clap::Args)]
pub struct Identify {
    /// Robot file
    #[arg(long)]
    robot: PathBuf,
    /// Observations: CSV with pose,cycle,target,x_mm,y_mm[,z_mm] and one column per joint with its unit; with the column
    /// `kind` also poses, distances, contacts and planes (docs/observations.md)
    #[arg(long)]
    observations: PathBuf,
    /// Standard uncertainty (k = 1) of one measured coordinate in micrometres; without it, it is taken from the residuals
    #[arg(long, value_name = "UM")]
    standard_uncertainty_um: Option<f64>,
    /// Standard uncertainty (k = 1) of a coordinate in micrometres that is common to all rows with the same
    /// coordinates: a ball measured once and touched in several working modes. The other is then that of the contact
    #[arg(long, value_name = "UM", requires = "standard_uncertainty_um")]
    common_uncertainty_um: Option<f64>,
    /// Standard uncertainty (k = 1) of a measured orientation about any axis in degrees, where the table has no `urot_deg`
    #[arg(long, value_name = "DEG")]
    rotation_uncertainty_deg: Option<f64>,
    /// Compare poses as in eq. 3.26 instead of targets (planar robots)
    #[arg(long)]
    pose_residuals: bool,
    /// Hold a parameter at its nominal value; `*` replaces any text; may be repeated
    #[arg(long, value_name = "NAME")]
    hold: Vec<String>,
    /// Print parameters.json instead of a table
    #[arg(long)]
    json: bool,
}

impl Identify {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        for (name, stated) in [
            ("--standard-uncertainty-um", self.standard_uncertainty_um),
            ("--common-uncertainty-um", self.common_uncertainty_um),
        ] {
            if stated.is_some_and(|u| !PLAUSIBLE_UM.contains(&u)) {
                let message = Message::error(format!("{name} is not an uncertainty of a coordinate in micrometres"));
                let hint = "expanded uncertainty over coverage factor, per coordinate: 0.0027 mm is 2.7 um";
                return Err(Problems::from(message.hint(hint)).into());
            }
        }
        let robot_file = read_robot(&self.robot)?;
        let observed = TableFile::read(&self.observations)?;
        let here = |problems: Problems| observed.place(problems);
        let mut robot = robot_file.build(&kinds::targets(&observed.table).map_err(here)?).map_err(here)?;
        let mut messages = Vec::new();
        let mut settings = Settings {
            kind: if self.pose_residuals { ResidualKind::Pose } else { ResidualKind::Targets },
            standard_uncertainty_mm: self.standard_uncertainty_um.map(|u| u / 1000.0),
            common_uncertainty_mm: self.common_uncertainty_um.map(|u| u / 1000.0),
            hold: self.hold,
            ..Settings::default()
        };
        let without = Uncertainties {
            length_mm: settings.standard_uncertainty_mm,
            rotation_rad: self.rotation_uncertainty_deg.map(f64::to_radians),
        };
        let observations =
            kinds::observed(robot.as_mut(), &observed.table, without, &mut settings, &mut messages).map_err(here)?;
        messages.extend(stale(robot.as_ref(), &observations));
        let before = fit_frames(robot.as_ref(), &observations, &settings)?;
        let mut found = identify_from(robot.as_ref(), &observations, &settings, &before)?;
        found.warnings.splice(0..0, messages);
        let sets = Sets { calibration: observations, validation: Vec::new() };
        let errors = evaluate::errors(robot.as_ref(), &sets, &before, &found.values);
        let messages = plausibility(robot.as_ref(), &sets.calibration, &settings, &before, &found, &errors);
        found.warnings.splice(0..0, messages);
        let described = robot_file.description_path();
        let inputs = files::sha256_of([&self.robot, &self.observations].into_iter().chain(&described))?;
        let document = parameters_document(robot.as_ref(), &settings, &before, &found, &inputs);
        let faces = Faces::identification(&document);
        if self.json {
            return answer(&faces, Some(to_json(&document)?));
        }
        remark(&document.messages);
        answer(&faces, None)
    }
}

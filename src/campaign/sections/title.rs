//! Title of a campaign that states none: its kind, its robot and its date.

use crate::types::CampaignFile;
use etalon_base::phrase;
use std::path::Path;

/// Title in the language of the report. Without a name of the robot and without a date, the name of
/// the folder.
pub(crate) fn composed(file: &CampaignFile, robot: Option<&str>, folder: &Path) -> String {
    let stated = |text: Option<&str>| text.map(str::trim).filter(|text| !text.is_empty()).map(str::to_owned);
    let robot = stated(robot).or_else(|| stated(file.conditions.robot.description.as_deref()));
    let date = stated(file.date.as_deref());
    let folder = || {
        let folder = std::path::absolute(folder).unwrap_or_default();
        folder.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
    };
    let kind = match () {
        () if file.identify.is_some() => "calibration",
        () if file.geometric.is_some() => "geometry",
        () => "test",
    };
    let language = file.report.language.code();
    match (robot, date) {
        (None, None) => folder(),
        (Some(robot), Some(date)) => phrase!("campaign-title-dated", kind, robot, date).text(language),
        (Some(robot), None) => phrase!("campaign-title", kind, robot).text(language),
        (None, Some(date)) => phrase!("campaign-title-dated", kind, robot = folder(), date).text(language),
    }
}

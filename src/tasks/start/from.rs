//! A whole campaign from files of measurements and logs.

use super::DescribedRobot;
use etalon_base::message::{Problems, Result, printable};
use etalon_base::{error, files, phrase};
use etalon_campaign::{RobotFile, parse_robot};
use etalon_documents::FormatsDocument;
use etalon_formats::{
    FilesProposal, Format, JOINTS_REMARK, files_beside, heading_without_unit, propose_files, world_lines,
};
use etalon_robots::Robot;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Files of a robot, and the keys of its joints with their units.
pub(crate) struct RobotFiles {
    /// Names and contents, robot.toml first.
    pub files: Vec<(String, Vec<u8>)>,
    /// Path that stands for robot.toml: a URDF is in the same folder.
    pub path: PathBuf,
    /// `q1_deg`, `lift_m` ...
    pub joints: Vec<String>,
    /// Targets that belong to the robot model or to its branches.
    pub targets: Vec<String>,
    /// As the campaign contains them.
    pub controllers: &'static str,
    /// The user's own robot file.
    pub own: Option<RobotFile>,
}

/// Sections of tests that need no robot.
const WITHOUT_ROBOT: [&str; 3] = ["poses", "stream", "compliance"];

/// Poses from which on some are kept for the validation.
const ENOUGH: usize = 30;

/// A campaign that is proposed from files.
pub(crate) struct Started {
    /// Interpretation of each file.
    pub documents: Vec<FormatsDocument>,
    /// campaign.toml, and the files of the robot.
    pub written: Vec<(String, Vec<u8>)>,
    /// The files themselves.
    pub copied: Vec<(String, Vec<u8>)>,
}

/// Proposes a campaign from files of measurements and logs.
pub(super) fn campaign(paths: &[PathBuf], robot: RobotFiles) -> anyhow::Result<Started> {
    let beside: Vec<PathBuf> = paths.iter().flat_map(|path| files_beside(path)).collect();
    let missing = beside.iter().filter(|path| !paths.iter().any(|other| file_name(other) == file_name(path)));
    let copies: Vec<&PathBuf> = paths.iter().chain(missing).collect();
    let names: Vec<String> = paths.iter().map(|path| file_name(path)).collect();
    for (i, name) in names.iter().enumerate() {
        if names[..i].contains(name) {
            return Err(Problems::from(error!("two-files-of-one-name", name)).into());
        }
    }
    let built = robot.built();
    let FilesProposal { documents, toml, .. } = propose_files(paths, built.as_deref())?;
    let mut lines = toml;
    for document in &documents {
        let own = joints_named(document.toml.clone(), document, &robot);
        lines = lines.replacen(&document.toml, &own, 1);
    }
    let quoted = |text: &str| toml::Value::from(text).to_string();
    for document in &documents {
        let (path, name) = (&document.file, file_name(Path::new(&document.file)));
        if !toml::from_str::<toml::Table>(&document.toml).is_ok_and(|stated| !stated.is_empty()) {
            return Err(Problems::from(error!("nothing-recognised", name, path)).into());
        }
        lines = lines.replace(&quoted(path), &quoted(&name));
        lines = lines.replace(&format!("`{path}"), &format!("`{name}"));
    }
    let lines = directions_asked(lines);
    let stated: toml::Table = toml::from_str(&lines)
        .map_err(|e| Problems::from(error!("proposal-not-toml", name = names.join(" "), error = e.to_string())))?;
    let needs_none = stated.keys().all(|key| WITHOUT_ROBOT.contains(&key.as_str()));
    if robot.files.is_empty() && !needs_none {
        return Err(Problems::from(error!("from-needs-robot")).into());
    }
    let controllers = (!robot.files.is_empty()).then(|| robot.controllers_lines(built.as_deref()));
    let mut text = head(&names, &lines, controllers.as_deref()) + "\n" + &lines;
    let is_one_table = documents.iter().any(|document| document.kind == "export with joints");
    let has_branches = built.as_ref().is_some_and(|robot| !robot.branches().is_empty());
    if has_branches && is_one_table && !stated.contains_key("join") {
        let _ = writeln!(text, "\n[join]\nby = \"row\"\ntargets = {:?}", robot.targets);
    }
    text += &identification(&documents, &stated, built.as_deref());
    let mut written = vec![("campaign.toml".to_owned(), text.into_bytes())];
    written.extend(robot.files);
    let copied = copies.into_iter().map(|path| Ok((file_name(path), files::read(path)?)));
    Ok(Started { documents, written, copied: copied.collect::<Result<_>>()? })
}

/// Asks for the direction of each joint that counts in the opposite direction by the points: the
/// log or robot.toml may be wrong.
fn directions_asked(lines: String) -> String {
    let asked = |line: &str| {
        if line.trim_start().starts_with('#') {
            return line.to_owned();
        }
        let mut asked = line.replace("per_count = -1 ", "per_count = \"?\" ");
        if asked != line {
            return format!("{asked}   # {}", printable(&phrase!("ask-direction").to_string()));
        }
        let mut columns: Vec<String> = Vec::new();
        while let Some((before, behind)) = asked.split_once("= \"-1 * ")
            && let Some((name, rest)) = behind.split_once('"')
        {
            columns.push(format!("\"-1 * {name}\""));
            asked = format!("{before}= \"?\"{rest}");
        }
        match columns.is_empty() {
            true => asked,
            false => format!("{asked}   # {}", printable(&phrase!("ask-direction-of-columns", columns).to_string())),
        }
    };
    lines.lines().map(|line| asked(line) + "\n").collect()
}

fn file_name(path: &Path) -> String {
    path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
}

impl RobotFiles {
    /// Files of the robot in a URDF file.
    pub fn from_urdf(path: &Path, described: DescribedRobot) -> Self {
        let DescribedRobot { name, robot, text, joints, targets } = described;
        Self {
            files: vec![("robot.toml".to_owned(), robot), (name, text)],
            path: path.with_file_name("robot.toml"),
            joints,
            targets,
            controllers: "[\"json\", \"urdf\"]",
            own: None,
        }
    }

    /// No robot: tests of poses need none.
    pub fn none() -> Self {
        Self {
            files: Vec::new(),
            path: PathBuf::new(),
            joints: Vec::new(),
            targets: Vec::new(),
            controllers: "[]",
            own: None,
        }
    }

    /// The nominal robot, whose kinematics test the proposal.
    pub fn built(&self) -> Option<Box<dyn Robot>> {
        let (_, text) = self.files.first()?;
        let parsed = || parse_robot(&self.path, &String::from_utf8_lossy(text)).ok();
        let robot = self.own.clone().or_else(parsed)?;
        let targets = if self.targets.is_empty() { vec!["target".to_owned()] } else { self.targets.clone() };
        // targets of a platform belong to its model
        robot.build(&targets).or_else(|_| robot.build(&[])).ok()
    }

    /// Line `controllers` of a campaign, below a comment with the formats for a controller of this
    /// robot.
    pub fn controllers_lines(&self, robot: Option<&dyn Robot>) -> String {
        let names = robot.map(|robot| etalon_controllers::names_for_controllers(robot).collect::<Vec<_>>());
        let formats = match names.as_deref() {
            None | Some([]) => String::new(),
            Some(names) => {
                format!("# Formats for a controller of this robot: {}.\n", names.join(", "))
            }
        };
        format!(
            "{formats}# For other controllers, `etalon compensate` corrects programs, and a template writes joint zeros.\n\
             controllers = {}",
            self.controllers
        )
    }
}

/// World and selections, where the files identify a robot.
fn identification(documents: &[FormatsDocument], stated: &toml::Table, robot: Option<&dyn Robot>) -> String {
    let is = |kind: &str| documents.iter().any(|document| document.kind == kind);
    if !(is("export with joints") || is("observations") || stated.contains_key("join")) {
        return String::new();
    }
    let mut text = String::new();
    if !is("observations") && !stated.contains_key("frame") {
        text += &world_lines(robot, &[]);
    }
    let rows = documents.iter().filter(|document| document.kind != "log").map(|document| document.rows).sum::<usize>();
    let targets = stated.get("join").and_then(|join| join.get("targets")?.as_array()).map_or(1, Vec::len);
    text + &split(rows / targets.max(1))
}

/// Name, robot and instrument; without controllers there is no robot.
fn head(names: &[String], lines: &str, controllers: Option<&str>) -> String {
    let robot = controllers.map_or_else(String::new, |controllers| format!("robot = \"robot.toml\"\n{controllers}\n"));
    format!(
        "# Proposed by `etalon init --from {}`. `etalon check` lists each `\"?\"` and UNIT to complete.\n\
         # Lengths are in mm, angles in degrees, unless a key states another unit.\n\n\
         name = \"First campaign\"\n{robot}\n\
         [instrument]                                  # from the calibration certificate\n\
         name = \"?\"                                    # name of the instrument\n\
         expanded_uncertainty_um = \"?\"                 # of one coordinate, a number without quotes\n\
         coverage_factor = 2\n{}",
        names.join(" "),
        match has_orientations(lines) {
            true =>
                "expanded_rotation_uncertainty_deg = \"?\"       # of a measured orientation, a number without quotes\n",
            false => "",
        }
    )
}

/// `true` if the rows or the format of a file state orientations.
fn has_orientations(lines: &str) -> bool {
    let oriented = |name: &str| {
        Format::named(name)
            .is_some_and(|format| format.dialect.columns.roles().iter().any(|role| role.is_orientation()))
    };
    let of_format = lines.lines().filter_map(|line| line.strip_prefix("format = \"")?.split('"').next()).any(oriented);
    let of_columns = |line: &str| !line.starts_with('#') && ["qw", "r11", "rx_"].iter().any(|name| line.contains(name));
    of_format || lines.lines().any(of_columns)
}

/// Lines that split the poses into calibration and validation.
fn split(poses: usize) -> String {
    match poses >= ENOUGH {
        true => format!(
            "\n[identify]\ncalibration = \"index mod 10 < 7\"              # {poses} poses or readings: seven of ten identify, the others validate\n\
             validation = \"rest\"\n"
        ),
        false => format!(
            "\n[identify]\ncalibration = \"all\"                           # {poses} poses or readings are few: none is left for a validation\n"
        ),
    }
}

/// Names the joints of the lines as the robot does: by their headings, otherwise in the order of
/// the file.
fn joints_named(mut lines: String, document: &FormatsDocument, robot: &RobotFiles) -> String {
    let columns =
        document.columns.iter().filter_map(|column| Some((column.joint?, column.heading.clone().unwrap_or_default())));
    let mut columns: Vec<(usize, String)> = columns.collect();
    // without a tool link the joints of the robot are open
    if columns.is_empty() || robot.joints.is_empty() {
        return lines;
    }
    let in_order = columns.is_sorted_by_key(|(number, _)| *number);
    columns.sort_unstable();
    let stems: Vec<&str> =
        robot.joints.iter().map(|key| key.rsplit_once('_').map_or(key.as_str(), |(stem, _)| stem)).collect();
    let by_name: Option<Vec<usize>> = columns
        .iter()
        .map(|(_, heading)| stems.iter().position(|stem| heading_without_unit(heading) == *stem))
        .collect();
    let named = by_name.is_some();
    let order = by_name.unwrap_or_else(|| (0..columns.len()).collect());
    // one name after the other, by names that no file has
    for (number, _) in &columns {
        lines = lines.replace(&format!(" q{number}_"), &format!(" \u{1}{number}\u{1}_"));
    }
    for ((number, _), at) in columns.iter().zip(order) {
        let fallback = format!("q{number}");
        let stem = stems.get(at).copied().unwrap_or(&fallback);
        lines = lines.replace(&format!(" \u{1}{number}\u{1}_"), &format!(" {stem}_"));
    }
    let mut remarks = String::new();
    if columns.len() != stems.len() {
        let question = phrase!("from-other-joints", columns = columns.len(), joints = stems.len());
        let _ = writeln!(remarks, "# QUESTION: {question}");
    } else if !named && in_order {
        let _ = writeln!(remarks, "# {}", phrase!("from-joints-in-order"));
    }
    let unit = if lines.contains("_UNIT") { format!("# {}\n", phrase!("from-unit-of-joints")) } else { String::new() };
    remarks + &lines.replace(JOINTS_REMARK, &unit)
}

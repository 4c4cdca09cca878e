//! `etalon init --from`: a whole campaign from files of measurements and logs.

use etalon_base::message::Problems;
use etalon_base::{error, files};
use etalon_documents::FormatsDocument;
use etalon_formats::{Export, Format, label_form, propose_file, read_file};
use serde::Deserialize;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Files of a robot, and the keys of its joints with their units.
pub(super) struct RobotFiles {
    /// Names and contents, robot.toml first.
    pub files: Vec<(String, Vec<u8>)>,
    /// `q1_deg`, `lift_m` ...
    pub joints: Vec<String>,
    /// Targets that belong to the robot model.
    pub targets: Vec<String>,
    /// As the campaign states them.
    pub controllers: &'static str,
}

/// A file and its proposal.
struct Part {
    path: PathBuf,
    name: String,
    document: FormatsDocument,
    /// Lines of the campaign.
    lines: String,
    /// Keys and values of the lines.
    stated: toml::Table,
}

/// Poses from which on some are kept for the validation.
const ENOUGH: usize = 30;

/// campaign.toml, the robot's files and the files themselves.
pub(super) fn campaign(paths: &[PathBuf], robot: RobotFiles) -> anyhow::Result<Vec<(String, Vec<u8>)>> {
    let mut parts = paths.iter().map(|path| Part::of(path, &robot)).collect::<Result<Vec<_>, Problems>>()?;
    for (i, part) in parts.iter().enumerate() {
        if parts[..i].iter().any(|other| other.name == part.name) {
            return Err(Problems::from(error!("two-files-of-one-name", name = part.name)).into());
        }
    }
    let mut targets: Vec<String> = robot.targets.clone();
    for part in &mut parts {
        part.name_targets(&mut targets);
    }
    let mut text = head(&parts, robot.controllers);
    for part in &parts {
        let _ = write!(text, "\n{}", part.lines);
    }
    let logs: Vec<&Part> = parts.iter().filter(|part| part.stated.contains_key("log")).collect();
    let exports: Vec<&Part> = parts.iter().filter(|part| part.document.kind == "export").collect();
    if let (Some(log), false) = (logs.first(), exports.is_empty()) {
        text += &join(log, &exports, &targets);
    }
    let identifies =
        parts.iter().any(|part| ["export with joints", "observations"].contains(&part.document.kind.as_str()));
    if identifies || !logs.is_empty() && !exports.is_empty() {
        let observed = parts.iter().any(|part| part.document.kind == "observations");
        if !observed {
            text += "\n[frame.world]\nas_exported = true          # the base is found in the frame of the instrument; or targets that stay\n";
        }
        let rows =
            parts.iter().filter(|part| part.document.kind != "log").map(|part| part.document.rows).sum::<usize>();
        let poses = rows / targets.len().max(1);
        text += &split(poses);
    }
    let mut all = vec![("campaign.toml".to_owned(), text.into_bytes())];
    all.extend(robot.files);
    for part in &parts {
        all.push((part.name.clone(), files::read(&part.path)?));
    }
    Ok(all)
}

/// Name, robot and instrument.
fn head(parts: &[Part], controllers: &str) -> String {
    let names: Vec<&str> = parts.iter().map(|part| part.name.as_str()).collect();
    format!(
        "# Proposed by `etalon init --from {}`. `etalon check` asks for each `\"?\"` and UNIT, one after the other.\n\
         # Lengths are in mm, angles in degrees, unless a key states another unit.\n\n\
         name = \"First campaign\"\nrobot = \"robot.toml\"\ncontrollers = {controllers}\n\n\
         [instrument]                                  # from the calibration certificate\n\
         name = \"?\"                                    # name of the instrument\n\
         expanded_uncertainty_um = \"?\"                 # of one coordinate, a number without quotes\n\
         coverage_factor = 2\n{}",
        names.join(" "),
        match parts.iter().any(Part::has_orientations) {
            true =>
                "expanded_rotation_uncertainty_deg = \"?\"       # of a measured orientation, a number without quotes\n",
            false => "",
        }
    )
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

/// Lines that join the exports with the log.
fn join(log: &Part, exports: &[&Part], targets: &[String]) -> String {
    let logged = |key: &str| log.columns().iter().any(|name| name.starts_with(key));
    let measured = |of: &str| exports.iter().all(|part| part.names(of));
    let rows: Vec<usize> = exports.iter().map(|part| part.document.rows).collect();
    let same = rows.iter().all(|rows| *rows == log.document.rows);
    let by_row = exports.iter().all(|part| part.lines.contains("pose = \"row\""));
    let (by, why, more) = match () {
        () if logged("pose") && measured("pose") && logged("cycle") && measured("cycle") => {
            ("[\"pose\", \"cycle\"]", "both name poses and repeats".to_owned(), "")
        }
        () if logged("pose") && (measured("pose") || by_row) => ("[\"pose\"]", "both name poses".to_owned(), ""),
        () if logged("label") => ("\"label\"", "the log names the points that the robot touches".to_owned(), ""),
        () if same => ("\"row\"", format!("all have {} rows", log.document.rows), ""),
        () if logged("time") && measured("time") => (
            "\"time\"",
            "both have times and different numbers of rows".to_owned(),
            "clock_offset_s = \"?\"      # time of the measurement minus time of the log, a number without quotes\n\
             tolerance_s = \"?\"         # a number without quotes\n",
        ),
        () => (
            "\"?\"",
            format!(
                "nothing joins them: {} rows of the log, {rows:?} of the exports; [\"pose\"], \"row\", \"time\" or \"label\"",
                log.document.rows
            ),
            "",
        ),
    };
    format!("\n[join]\nby = {by}                # {why}\n{more}targets = {targets:?}\n")
}

#[derive(Deserialize)]
struct Exports {
    #[serde(default)]
    export: Vec<Export>,
}

impl Part {
    fn of(path: &Path, robot: &RobotFiles) -> Result<Self, Problems> {
        let document = propose_file(path)?;
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let quoted = |text: &str| toml::Value::from(text).to_string();
        let lines =
            document.toml.replace(&format!("file = {}", quoted(&document.file)), &format!("file = {}", quoted(&name)));
        let lines = joints_named(lines, &document, robot);
        let stated: toml::Table =
            toml::from_str(&lines).map_err(|e| error!("proposal-not-toml", name, error = e.to_string()))?;
        if stated.is_empty() {
            return Err(error!("nothing-recognised", name, path = path.display().to_string()).into());
        }
        Ok(Self { path: path.to_owned(), name, document, lines, stated })
    }

    /// `true` if the rows or the format of the file state orientations.
    fn has_orientations(&self) -> bool {
        let named = self.document.format.as_deref().and_then(Format::named);
        let of_format =
            named.is_some_and(|format| format.dialect.columns.roles().iter().any(|role| role.is_orientation()));
        of_format || ["qw", "r11", "rx_"].iter().any(|name| self.lines.contains(name))
    }

    /// Keys or contents of the columns that the lines state.
    fn columns(&self) -> Vec<String> {
        let tables = ["export", "log", "observations"].iter().filter_map(|key| self.stated.get(*key));
        let tables = tables.flat_map(|value| value.as_array().cloned().unwrap_or_else(|| vec![value.clone()]));
        let mut names = Vec::new();
        for table in tables {
            let columns = table.get("columns").or_else(|| table.get("format")?.get("columns")).cloned();
            match columns {
                Some(toml::Value::Table(columns)) => names.extend(columns.keys().cloned()),
                Some(toml::Value::Array(columns)) => {
                    names.extend(columns.iter().filter_map(|c| c.as_str().map(str::to_owned)))
                }
                _ => {}
            }
        }
        names
    }

    /// `true` if the rows of the file name `of`, in a column or in their labels.
    fn names(&self, of: &str) -> bool {
        self.columns().iter().any(|name| name.starts_with(of)) || self.lines.contains(&format!("{{{of}}}"))
    }

    /// Completes the unknown parts of a proposal about targets: a name, or the form of the labels.
    fn name_targets(&mut self, targets: &mut Vec<String>) {
        let mut add = |name: String| {
            if !targets.contains(&name) {
                targets.push(name);
            }
        };
        if self.lines.contains("target = \"?\"") {
            let stem: String = self
                .name
                .split('.')
                .next()
                .unwrap_or("target")
                .chars()
                .filter(|c| c.is_alphanumeric() || *c == '_')
                .collect();
            let stem = if stem.is_empty() || stem == "base" { "reflector".to_owned() } else { stem };
            let line = "target = \"?\"               # which target the rows are of\n";
            self.lines = self.lines.replace(
                line,
                &format!("target = \"{stem}\"           # named after the file: the file names no target\n"),
            );
            add(stem);
        }
        for export in self.stated.get("export").and_then(toml::Value::as_array).into_iter().flatten() {
            let stated = export.get("target").and_then(toml::Value::as_str).filter(|name| *name != "?");
            stated.map(str::to_owned).into_iter().for_each(&mut add);
        }
        const PROPOSED: &str =
            "label = \"{target}_{pose}_{cycle}\"   # how a label names target, pose and repeat, if it does\n";
        if self.lines.contains(PROPOSED) {
            let (line, found) = self.labels();
            self.lines = self.lines.replace(PROPOSED, &line);
            found.into_iter().for_each(add);
        }
    }

    /// The line that states the form of the labels, and the targets that they name.
    fn labels(&self) -> (String, Vec<String>) {
        let open = || {
            ("label = \"?\"                # the form of the labels, with {target}, {pose} and {cycle}: none is found\n".to_owned(), Vec::new())
        };
        let text = self.lines.replace("unit = \"?\"", "unit = \"mm\"");
        let Some(export) = toml::from_str::<Exports>(&text).ok().and_then(|all| all.export.into_iter().next()) else {
            return open();
        };
        let Ok(points) = read_file(&self.path, export.encoding, &export.format, export.unit) else { return open() };
        let labels: Vec<&str> = points.iter().map(|point| &*point.label).collect();
        let Some((form, mut targets)) = label_form(&labels) else { return open() };
        let mut line = format!("label = \"{form}\"   # all {} labels have this form\n", labels.len());
        if targets.is_empty() {
            targets.push("reflector".to_owned());
            line += "target = \"reflector\"        # the labels name no target\n";
        }
        (line, targets)
    }
}

/// Names the joints of the lines as the robot does: by their headings, otherwise in the order of
/// the file.
fn joints_named(mut lines: String, document: &FormatsDocument, robot: &RobotFiles) -> String {
    let columns = document.columns.iter().filter_map(|column| {
        let number: usize = column.taken_for.strip_prefix("joint ")?.parse().ok()?;
        Some((number, column.heading.clone().unwrap_or_default()))
    });
    let mut columns: Vec<(usize, String)> = columns.collect();
    columns.sort_unstable();
    if columns.is_empty() {
        return lines;
    }
    let stems: Vec<&str> =
        robot.joints.iter().map(|key| key.rsplit_once('_').map_or(key.as_str(), |(stem, _)| stem)).collect();
    let by_name: Option<Vec<usize>> =
        columns.iter().map(|(_, heading)| stems.iter().position(|stem| heading.trim() == *stem)).collect();
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
        let _ = writeln!(
            remarks,
            "# QUESTION: the file has {} columns of joints, and the robot {} joints: leave out those that it does not have",
            columns.len(),
            stems.len()
        );
    } else if !named {
        remarks += "# the joints are those of robot.toml in the order of the file\n";
    }
    remarks + &lines
}

//! A campaign proposed from the files of a page, with questions for what the files do not contain.

use crate::session::changes::difference;
use crate::session::files;
use crate::tasks::known_names;
use crate::tasks::start::{NamedRobot, Question as Open, Started, answered, described_by, open_questions, start};
use etalon_base::catalogue::Phrase;
use etalon_base::error;
use etalon_base::files::{read, write_new};
use etalon_base::message::{Problems, Result};
use etalon_base::phrase;
use etalon_documents::FormatsDocument;
use etalon_formats::mesh::is_mesh;
use etalon_formats::propose_files;
use etalon_view::{Asked, ColumnRead, FileProposal, Place, Proposal, Question, QuestionOption, Severity, ShownMessage};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Rows and characters of a file that the page shows.
const ROWS: usize = 8;
const CHARACTERS: usize = 400;
/// Bytes from which the first rows of a file are shown.
const HEAD: usize = 64 << 10;
/// Units of lengths, and of joints, that a campaign may contain.
const LENGTHS: [&str; 5] = ["mm", "m", "cm", "um", "inch"];
const JOINTS: [&str; 5] = ["deg", "rad", "mm", "m", "um"];
/// Units of times.
const TIMES: [&str; 4] = ["s", "ms", "us", "ns"];
/// Begins the ids of questions of robot.toml.
const ROBOT: &str = "robot.toml:";

/// Files of a folder by their use for a proposal.
struct Inputs {
    measured: Vec<PathBuf>,
    /// URDF files and robot.toml.
    robots: Vec<PathBuf>,
}

fn name(path: &Path) -> String {
    path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
}

impl Inputs {
    fn new(folder: &Path, dropped: &files::Dropped) -> Self {
        let is_robot = |path: &PathBuf| {
            let end = path.extension().map(|end| end.to_string_lossy().to_ascii_lowercase());
            matches!(end.as_deref(), Some("urdf" | "xacro")) || name(path) == "robot.toml"
        };
        let all = files::inputs(folder, dropped).into_iter().filter(|path| name(path) != "campaign.toml");
        let (robots, mut measured): (Vec<PathBuf>, Vec<PathBuf>) = all.partition(is_robot);
        // meshes of the robot are drawn, not measured
        let described: Vec<Vec<u8>> = robots.iter().filter_map(|path| read(path).ok()).collect();
        let described: Vec<_> = described.iter().map(|bytes| String::from_utf8_lossy(bytes)).collect();
        measured.retain(|path| !is_mesh(&name(path)) || described.iter().all(|text| !text.contains(&name(path))));
        Self { measured, robots }
    }

    /// The robot that is asked for, or the only one among the files. Names of other files are not
    /// taken: they may lie outside the folder.
    fn robot(&self, asked: Option<&str>) -> Result<Option<Chosen>> {
        let file = |path: &PathBuf| Chosen { name: name(path), path: Some(path.clone()) };
        let Some(asked) = asked.filter(|asked| !asked.is_empty()) else {
            return Ok(if let [only] = &self.robots[..] { Some(file(only)) } else { None });
        };
        if let Some(path) = self.robots.iter().find(|path| name(path) == asked) {
            return Ok(Some(file(path)));
        }
        let names = known_names()?;
        match names.iter().any(|known| known == asked) {
            true => Ok(Some(Chosen { name: asked.to_owned(), path: None })),
            false => Err(error!("robot-not-in-table", name = asked, names).into()),
        }
    }
}

/// Robot of a proposal.
struct Chosen {
    name: String,
    /// File of the robot; none for a known robot.
    path: Option<PathBuf>,
}

impl Chosen {
    fn start(&self, measured: &[PathBuf]) -> Result<Started> {
        let own = self.path.as_ref().map(|path| path.display().to_string());
        let is_toml = self.name.ends_with(".toml");
        let urdf = self.path.as_deref().filter(|_| !is_toml);
        let name = if urdf.is_some() { None } else { Some(own.as_deref().unwrap_or(&self.name)) };
        start(measured, NamedRobot { urdf, name }).map_err(|error| match error.downcast::<Problems>() {
            Ok(problems) => problems,
            Err(error) => error!("proposal-not-toml", name = &self.name, error = format!("{error:#}")).into(),
        })
    }
}

/// A proposal with its texts, before and after the answers.
struct Drafted {
    started: Started,
    /// campaign.toml and robot.toml as proposed.
    texts: [String; 2],
    /// Both texts with the answers.
    answered: [String; 2],
}

impl Drafted {
    fn new(chosen: &Chosen, measured: &[PathBuf], answers: &BTreeMap<String, String>) -> Result<Self> {
        let started = chosen.start(measured)?;
        let text = |file: &str| {
            let found = started.written.iter().find(|(name, _)| name == file);
            found.map(|(_, text)| String::from_utf8_lossy(text).into_owned()).unwrap_or_default()
        };
        let texts = [text("campaign.toml"), text("robot.toml")];
        let of_robot =
            answers.iter().filter_map(|(id, answer)| Some((id.strip_prefix(ROBOT)?.to_owned(), answer.clone())));
        let answered = [answered(&texts[0], answers), answered(&texts[1], &of_robot.collect())];
        Ok(Self { started, texts, answered })
    }

    /// Open questions of both texts, with their ids.
    fn questions(texts: &[String; 2]) -> Vec<(String, Open)> {
        let campaign = open_questions(&texts[0]).into_iter().map(|open| (open.id.clone(), open));
        let robot = open_questions(&texts[1]).into_iter().map(|open| (format!("{ROBOT}{}", open.id), open));
        campaign.chain(robot).collect()
    }
}

/// Proposes a campaign.
///
/// # Errors
/// Fails without measurements, and for files that hold none.
pub(super) fn propose(folder: &Path, dropped: &files::Dropped, asked: &Asked, language: &str) -> Result<Proposal> {
    let inputs = Inputs::new(folder, dropped);
    if inputs.measured.is_empty() {
        return Err(error!("view-nothing-dropped").into());
    }
    let robot = robot_question(&inputs, language)?;
    let Some(chosen) = inputs.robot(asked.robot.as_deref())? else {
        let read = propose_files(&inputs.measured, None)?;
        let (files, messages) = read_as(&read.documents, language);
        return Ok(Proposal { campaign: read.toml, files, questions: vec![robot], messages, ..Proposal::default() });
    };
    let drafted = Drafted::new(&chosen, &inputs.measured, &asked.answers)?;
    let (files, messages) = read_as(&drafted.started.documents, language);
    let asked_for = Drafted::questions(&drafted.texts);
    let questions = asked_for.into_iter().map(|(id, open)| question(id, &open, language));
    let [before, after] = [&drafted.texts[0], &drafted.answered[0]];
    Ok(Proposal {
        difference: (before != after).then(|| difference(before, after)),
        campaign: after.clone(),
        robot: Some(chosen.name),
        files,
        questions: std::iter::once(robot).chain(questions).collect(),
        messages,
    })
}

/// Writes the campaign with these answers into the folder.
///
/// # Errors
/// Fails like [`propose`], with open questions, and if the folder has a campaign.
pub(super) fn accept(folder: &Path, dropped: &files::Dropped, asked: &Asked) -> Result<()> {
    if folder.join("campaign.toml").exists() {
        return Err(error!("view-campaign-exists").into());
    }
    let inputs = Inputs::new(folder, dropped);
    if inputs.measured.is_empty() {
        return Err(error!("view-nothing-dropped").into());
    }
    let Some(chosen) = inputs.robot(asked.robot.as_deref())? else { return Err(error!("from-needs-robot").into()) };
    let Drafted { started, answered, .. } = Drafted::new(&chosen, &inputs.measured, &asked.answers)?;
    let open = Drafted::questions(&answered)
        .into_iter()
        .map(|(_, open)| error!("key-open", key = open.key, remark = open.remark.unwrap_or_default()));
    Problems(open.collect()).check()?;
    let [campaign, robot] = answered;
    let mut written = started.written;
    for (name, text) in &mut written {
        match name.as_str() {
            "campaign.toml" => *text = campaign.clone().into_bytes(),
            "robot.toml" => *text = robot.clone().into_bytes(),
            _ => {}
        }
    }
    // the user's own robot.toml and URDF are in the folder already
    let mut files = described_by(written);
    files.retain(|(name, _)| !folder.join(name).exists());
    write_new(folder, &files)?;
    Ok(())
}

/// Interpretation of each file with its first rows, and doubts about the interpretation.
fn read_as(documents: &[FormatsDocument], language: &str) -> (Vec<FileProposal>, Vec<ShownMessage>) {
    let (mut files, mut messages) = (Vec::new(), Vec::new());
    for document in documents {
        let path = Path::new(&document.file);
        let column = |column: &etalon_documents::FormatsColumn| ColumnRead {
            heading: column.heading.clone().unwrap_or_else(|| format!("${}", column.number)),
            taken_for: Some(column.taken_for.text(language)).filter(|text| !text.is_empty()),
            why: Some(column.why.text(language)).filter(|text| !text.is_empty()),
        };
        let columns: Vec<ColumnRead> = document.columns.iter().map(column).collect();
        let (rows, lines) = first_rows(path, columns.len());
        files.push(FileProposal { name: name(path), columns, rows, lines });
        messages.extend(document.doubts.iter().map(|doubt| ShownMessage {
            id: doubt.phrase().map(|phrase| phrase.id.clone().into_owned()).unwrap_or_default(),
            severity: Severity::Warning,
            text: doubt.text(language),
            hint: None,
            place: Some(Place { file: Some(name(path)), ..Place::default() }),
        }));
    }
    (files, messages)
}

/// Returns the first rows of a table with this many columns, and the first lines of any other text.
fn first_rows(path: &Path, columns: usize) -> (Vec<Vec<String>>, Vec<String>) {
    let bytes = read(path).unwrap_or_default();
    let head = &bytes[..bytes.len().min(HEAD)];
    if head.contains(&0) {
        return (Vec::new(), Vec::new());
    }
    let text = String::from_utf8_lossy(head);
    let short = |cell: &str| cell.trim().chars().take(CHARACTERS).collect::<String>();
    let split = |line: &str, by: char| -> Vec<String> {
        match by {
            ' ' => line.split_whitespace().map(short).collect(),
            by => line.split(by).map(short).collect(),
        }
    };
    let rows = |by: char| -> Vec<Vec<String>> {
        let lines = text.lines().map(|line| split(line, by));
        let rows = lines.filter(|cells| cells.len() == columns && cells.iter().any(|cell| cell.parse::<f64>().is_ok()));
        rows.take(ROWS).collect()
    };
    let best = ['\t', ';', ',', '|', ' '].map(rows).into_iter().max_by_key(Vec::len).unwrap_or_default();
    let lines = if best.is_empty() || columns == 0 { text.lines().take(ROWS).map(short).collect() } else { Vec::new() };
    (if columns == 0 { Vec::new() } else { best }, lines)
}

/// Question about the robot: one of the files, or a known one.
fn robot_question(inputs: &Inputs, language: &str) -> Result<Question> {
    let own = inputs.robots.iter().map(|path| name(path));
    let options = own.chain(known_names()?).map(|name| QuestionOption { value: name.clone(), label: name });
    let text = phrase!("view-question-robot").text(language);
    Ok(Question { id: "robot".to_owned(), text, options: options.collect(), doubt: None })
}

/// An open key as a question.
fn question(id: String, open: &Open, language: &str) -> Question {
    let file = open.file.clone().unwrap_or_default();
    let (text, options): (Phrase, &[&str]) = match (open.section.as_str(), open.key.as_str()) {
        ("instrument", "name") => (phrase!("view-question-instrument"), &[]),
        ("instrument", "expanded_uncertainty_um") => (phrase!("view-question-uncertainty"), &[]),
        ("instrument", "expanded_rotation_uncertainty_deg") => (phrase!("view-question-rotation"), &[]),
        (_, "unit") => (phrase!("view-question-unit", file), &LENGTHS),
        (_, "UNIT") => (phrase!("view-question-joint-unit", file), &JOINTS),
        (_, "time_UNIT") => (phrase!("view-question-time-unit", file), &TIMES),
        (_, "rx_UNIT") => (phrase!("view-question-angle-unit", file), &JOINTS[..2]),
        (_, "rotation") => (phrase!("view-question-rotation-order", file), &[]),
        (_, "as_exported") => (phrase!("view-question-world"), &["true"]),
        (section, key) => (phrase!("view-question-key", key, section), &[]),
    };
    let option = |value: &&str| QuestionOption { value: (*value).to_owned(), label: (*value).to_owned() };
    let options = options.iter().map(option).collect();
    // the question itself says what the remark of the line does
    let doubt = open.remark.clone().filter(|_| open.section != "instrument");
    Question { id, text: text.text(language), options, doubt }
}

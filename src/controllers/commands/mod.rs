//! Poses to command in the languages of controllers, either as a list or instead of the targets of
//! an existing program.
//!
//! A program is a sequence of bytes: everything except targets is preserved, independent of its
//! encoding and line ends.

mod galil;
mod gcode;
mod krl;
mod mecaprol;
mod rapid;
mod urscript;

pub use galil::Galil;

use super::ExportInput;
use super::decimals::fixed;
use etalon_base::error;
use etalon_base::message::{Message, Problems, Result};
use etalon_base::pose::Pose;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// Default number of decimals of a length in mm; other numbers have more or fewer decimals for the
/// same resolution.
pub const DECIMALS: usize = 6;

/// Degrees of freedom of a robot's pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Freedoms {
    /// Position in the plane.
    Point,
    /// Position and orientation in the plane.
    Plane,
    /// Position and orientation in space.
    Space,
}

/// A pose to command.
#[derive(Clone, Debug, PartialEq)]
pub struct Command {
    /// Name of the target.
    pub name: String,
    /// Pose.
    pub pose: Pose,
}

/// A language in which poses are commanded.
pub trait CommandLanguage: Sync {
    /// Character that begins a comment.
    fn comment_mark(&self) -> char;

    /// Units of the numbers.
    fn units(&self) -> &'static str;

    /// Numbers of a pose in the order of the language.
    fn numbers(&self, pose: &Pose, freedoms: Freedoms) -> Vec<f64>;

    /// Pose of numbers in the order of the language.
    fn pose(&self, numbers: &[f64], freedoms: Freedoms) -> Pose;

    /// Number of decimals of each number for [`DECIMALS`] decimals of a length in mm.
    fn decimals(&self, freedoms: Freedoms) -> Vec<usize>;

    /// List of poses with numbers that are already formatted.
    fn list(&self, header: &[String], commands: &[(String, Vec<String>)], freedoms: Freedoms) -> String;

    /// Targets of a program.
    ///
    /// # Errors
    ///
    /// Reports targets that cannot be compensated individually.
    fn targets(&self, program: &[u8], freedoms: Freedoms) -> Result<Program>;

    /// `true` if controllers of this language compute with the factory calibration of their own
    /// arm instead of nominal values.
    fn is_calibrated(&self) -> bool {
        false
    }
}

/// Contents of a program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Program {
    /// Targets in the order of writing.
    pub targets: Vec<ProgramTarget>,
    /// Number of targets that are joint values.
    pub joint_targets: usize,
    /// Named tools other than the flange.
    pub tools: BTreeSet<String>,
    /// Named frames other than the base.
    pub objects: BTreeSet<String>,
    /// Poses of those tools and frames that the program gives.
    pub known: BTreeMap<String, Pose>,
    /// Expressions that compute poses at run time, which are left unchanged.
    pub computed: BTreeSet<String>,
}

/// A target of a program.
#[derive(Clone, Debug, PartialEq)]
pub struct ProgramTarget {
    /// Name of the target, or its line.
    pub name: String,
    /// Line of the target, from 1.
    pub line: usize,
    /// Numbers of the target.
    pub numbers: Vec<f64>,
    /// Position of each number.
    pub slots: Vec<Slot>,
    /// Requested configuration.
    pub configuration: Option<Configuration>,
}

impl ProgramTarget {
    /// Target whose numbers are in the program.
    fn new(name: String, line: usize, numbers: &[Number]) -> Self {
        let slots = numbers.iter().map(|n| Slot { range: n.range.clone(), prefix: "" }).collect();
        Self { name, line, numbers: numbers.iter().map(|n| n.value).collect(), slots, configuration: None }
    }
}

/// Position of a number in a program.
#[derive(Clone, Debug, PartialEq)]
pub struct Slot {
    /// Byte range; empty if the number is to be added.
    pub range: Range<usize>,
    /// Text before an added number.
    pub prefix: &'static str,
}

/// Rounding of joint values (deg) at the border of a configuration.
const ROUNDING_DEG: f64 = 1e-9;

/// Configuration data of a target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Configuration {
    /// Quarter turns of joints 1, 4 and 6 (RAPID, `confdata`).
    Quadrants([i64; 3]),
    /// Bit i is set if joint i is negative (KRL, `Turn`).
    Negative(i64),
}

impl Configuration {
    /// `true` if joint values (deg) have this configuration. On a border both sides fit.
    pub fn fits(&self, joints_deg: &[f64]) -> bool {
        let either = |q: f64, fits: &dyn Fn(f64) -> bool| fits(q - ROUNDING_DEG) || fits(q + ROUNDING_DEG);
        match *self {
            Self::Quadrants(quadrants) => [0, 3, 5].iter().zip(quadrants).all(|(&i, wanted)| {
                let fits = |q: f64| ((q / 90.0).floor() as i64 - wanted).rem_euclid(4) == 0;
                joints_deg.get(i).is_none_or(|q| either(*q, &fits))
            }),
            Self::Negative(bits) => joints_deg
                .iter()
                .enumerate()
                .take(6)
                .all(|(i, q)| either(*q, &|q: f64| (bits >> i & 1 == 1) == (q < 0.0))),
        }
    }
}

/// Languages by name, with file extensions.
const LANGUAGES: [(&str, &dyn CommandLanguage, &[&str]); 5] = [
    ("rapid", &rapid::Rapid, &["mod", "modx", "prg", "sys"]),
    ("krl", &krl::Krl, &["src", "dat"]),
    ("urscript", &urscript::UrScript, &["script", "urscript"]),
    ("gcode", &gcode::Gcode, &["ngc", "nc", "gcode", "tap"]),
    ("mecaprol", &mecaprol::Mecaprol, &["mp"]),
];

/// Returns the language with this name.
pub fn language(name: &str) -> Option<(&'static str, &'static dyn CommandLanguage)> {
    LANGUAGES.iter().find(|(known, ..)| *known == name).map(|(name, language, _)| (*name, *language))
}

/// Returns the language of programs with this file extension.
pub fn language_by_extension(ending: &str) -> Option<(&'static str, &'static dyn CommandLanguage)> {
    let ending = ending.to_ascii_lowercase();
    let found = LANGUAGES.iter().find(|(.., endings)| endings.contains(&ending.as_str()));
    found.map(|(name, language, _)| (*name, *language))
}

/// Returns the formatted numbers of a pose, with this many decimals of a length in mm.
pub fn written(language: &dyn CommandLanguage, pose: &Pose, freedoms: Freedoms, decimals: usize) -> Vec<String> {
    let number = |(v, d): (f64, usize)| number_text(v, (d + decimals).saturating_sub(DECIMALS));
    language.numbers(pose, freedoms).into_iter().zip(language.decimals(freedoms)).map(number).collect()
}

/// Pose of formatted numbers.
pub fn stated(language: &dyn CommandLanguage, numbers: &[String], freedoms: Freedoms) -> Pose {
    let numbers: Vec<f64> = numbers.iter().map(|text| text.parse().unwrap_or(f64::NAN)).collect();
    language.pose(&numbers, freedoms)
}

/// List of poses with its header.
///
/// # Errors
///
/// Fails if the header cannot be written.
pub fn list(
    language: &dyn CommandLanguage,
    given: &ExportInput,
    commands: &[Command],
    freedoms: Freedoms,
    decimals: usize,
) -> Result<String> {
    let cells = |command: &Command| (command.name.clone(), written(language, &command.pose, freedoms, decimals));
    let header = given.header(language.units())?;
    Ok(language.list(&header, &commands.iter().map(cells).collect::<Vec<_>>(), freedoms))
}

/// Program with new numbers in its targets, and nothing else changed.
pub fn rewritten(program: &[u8], targets: &[ProgramTarget], numbers: &[Vec<String>]) -> Vec<u8> {
    let slots = targets.iter().zip(numbers).flat_map(|(target, numbers)| target.slots.iter().zip(numbers));
    let mut slots: Vec<(&Slot, &String)> = slots.collect();
    slots.sort_by_key(|(slot, _)| slot.range.start);
    let (mut out, mut at) = (Vec::with_capacity(program.len()), 0);
    for (slot, number) in slots {
        out.extend_from_slice(&program[at..slot.range.start]);
        out.extend_from_slice(slot.prefix.as_bytes());
        out.extend_from_slice(number.as_bytes());
        at = slot.range.end;
    }
    out.extend_from_slice(&program[at..]);
    out
}

/// Program with a comment before its first line; header lines of a file (`%`, `&ACCESS`, and
/// RAPID's lines between `%%%`) remain the first ones.
pub fn with_comment(program: &[u8], mark: char, comment: &str) -> Vec<u8> {
    let (mut at, mut in_header) = (if program.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 }, false);
    for line in program[at..].split_inclusive(|b| *b == b'\n') {
        let is_fence = line.starts_with(b"%%%");
        if !(is_fence || in_header || line.starts_with(b"%") || line.starts_with(b"&")) {
            break;
        }
        in_header ^= is_fence;
        at += line.len();
    }
    let first_end = program.iter().position(|b| *b == b'\n');
    let is_crlf = first_end.and_then(|end| program.get(end.checked_sub(1)?)) == Some(&b'\r');
    let line = format!("{mark} {}{}", super::comment(comment), if is_crlf { "\r\n" } else { "\n" });
    [&program[..at], line.as_bytes(), &program[at..]].concat()
}

/// Decimal text without exponent, trailing zeros and negative zero.
pub(crate) fn number_text(value: f64, decimals: usize) -> String {
    let text = fixed(value, decimals);
    let short = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    match short {
        "0" => "0.0".to_owned(),
        whole if !whole.contains('.') && decimals > 0 => format!("{whole}.0"),
        other => other.to_owned(),
    }
}

/// Letters, digits and underscores of a name, starting with a letter.
pub(crate) fn identifier(name: &str, longest: usize) -> String {
    let safe = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let begins = name.starts_with(|c: char| c.is_ascii_alphabetic());
    let text: String = if begins { String::new() } else { "P".to_owned() };
    (text + &name.chars().map(safe).collect::<String>()).chars().take(longest).collect()
}

/// Program with blanks instead of strings and comments, byte by byte. Comments run from `comment`
/// to the end of the line.
fn masked(program: &[u8], comment: u8) -> Vec<u8> {
    let (mut inside, mut out) = (None, Vec::with_capacity(program.len()));
    for &byte in program {
        match (inside, byte) {
            (_, b'\n' | b'\r') => inside = None,
            (None, b'"') => inside = Some(b'"'),
            (None, _) if byte == comment => inside = Some(comment),
            (Some(b'"'), b'"') => inside = None,
            _ => {}
        }
        let blank = inside.is_some() || byte == b'"';
        out.push(if blank && !matches!(byte, b'\n' | b'\r') { b' ' } else { byte });
    }
    out
}

/// Position after blanks and line ends.
fn skip_blanks(text: &[u8], mut at: usize) -> usize {
    while text.get(at).is_some_and(u8::is_ascii_whitespace) {
        at += 1;
    }
    at
}

/// A number of a program.
#[derive(Clone, Debug)]
struct Number {
    range: Range<usize>,
    value: f64,
}

/// Number that starts at a position, after blanks.
fn number(text: &[u8], at: usize) -> Option<Number> {
    let start = skip_blanks(text, at);
    let mut end = start;
    while let Some(&byte) = text.get(end) {
        let sign = matches!(byte, b'+' | b'-');
        let exponent = end > start && matches!(text[end - 1], b'e' | b'E');
        let letter = matches!(byte, b'e' | b'E') && text[start..end].iter().any(u8::is_ascii_digit);
        if !(byte.is_ascii_digit() || byte == b'.' || letter || (sign && (end == start || exponent))) {
            break;
        }
        end += 1;
    }
    let value = std::str::from_utf8(&text[start..end]).ok()?.parse::<f64>().ok()?;
    value.is_finite().then_some(Number { range: start..end, value })
}

/// Consecutive numbers in brackets, and the position after them.
fn bracketed(text: &[u8], at: usize) -> Option<(Vec<Number>, usize)> {
    let mut at = skip_blanks(text, at);
    if text.get(at) != Some(&b'[') {
        return None;
    }
    let mut all = Vec::new();
    loop {
        let next = number(text, at + 1)?;
        at = skip_blanks(text, next.range.end);
        all.push(next);
        match text.get(at)? {
            b',' => {}
            b']' => return Some((all, at + 1)),
            _ => return None,
        }
    }
}

/// Line number of a byte.
fn line_number(text: &[u8], at: usize) -> usize {
    1 + text[..at].iter().filter(|b| **b == b'\n').count()
}

/// Word that ends at a position, before blanks.
fn word_before(text: &[u8], at: usize) -> &str {
    let is_name = |b: &u8| b.is_ascii_alphanumeric() || matches!(b, b'_' | b'$');
    let end = text[..at].iter().rposition(|b| !b.is_ascii_whitespace()).map_or(0, |i| i + 1);
    let start = text[..end].iter().rposition(|b| !is_name(b)).map_or(0, |i| i + 1);
    std::str::from_utf8(&text[start..end]).unwrap_or_default()
}

/// Name to which the value at a position is assigned by `sign`, or the line.
fn assigned_name(text: &[u8], at: usize, sign: &str) -> String {
    let before = text[..at].trim_ascii_end();
    let assigned = before.strip_suffix(sign.as_bytes()).map(|before| word_before(before, before.len()));
    let name = assigned.filter(|name| !name.is_empty()).map(str::to_owned);
    name.unwrap_or_else(|| format!("line {}", line_number(text, at)))
}

/// Error at a line of a program.
fn at_line(line: usize, message: Message) -> Message {
    message.at(etalon_base::message::Place { line: Some(line), ..Default::default() })
}

/// Errors for words that command an arc or a relative movement, in a program without comments.
fn refused_movements<'a>(text: &'a [u8], is_refused: impl Fn(&str) -> bool + 'a) -> impl Iterator<Item = Message> + 'a {
    let is_word = |b: &u8| b.is_ascii_alphanumeric() || matches!(b, b'_' | b'$');
    text.split(|b| *b == b'\n').enumerate().filter_map(move |(i, line)| {
        let words = line.split(|b| !is_word(b)).map(|word| std::str::from_utf8(word).unwrap_or_default());
        let command = words.into_iter().find(|word| is_refused(word))?;
        Some(at_line(i + 1, error!("movement-not-compensated", command)))
    })
}

/// Returns the errors, if any.
fn none(problems: Vec<Message>) -> Result<()> {
    Problems(problems).check().map(|_| ())
}

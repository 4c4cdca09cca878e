//! xacro with properties, arguments and includes only, expanded to plain URDF. For other constructs
//! (macros, conditions, YAML) the error names the command that expands them.
//!
//! Source: the documentation and the source text of xacro 2 (ROS 2), which define the order of
//! evaluation, the types of values and the escapes `$${` and `$$(`.

use crate::xml::Elements;
use etalon_base::files::{self, Stamp};
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_base::{error, phrase};
use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::{self, Display, Write};
use std::ops::Range;
use std::path::{Component, Path, PathBuf};

/// Maximum size of an expanded text (bytes).
const LARGEST: usize = 64 << 20;
/// Maximum length of one value (bytes).
const LONGEST_VALUE: usize = 64 << 10;
/// Maximum number of files, and maximum depth of includes.
const MOST_FILES: usize = 256;
/// Maximum depth of parentheses, and of properties that refer to other properties.
const DEEPEST: usize = 32;
/// Number of folders above a file in which a package is searched for.
const FOLDERS_ABOVE: usize = 4;

/// Text of a URDF without xacro.
#[derive(Clone, Debug, Default)]
pub struct Expanded {
    /// Name of the file, for messages.
    pub name: String,
    /// Expanded text; the text of the file if it contains no xacro.
    pub text: String,
    /// Included files and their stamps, each once.
    pub included: Vec<(PathBuf, Stamp)>,
    /// File and line of each line of the text; empty if the text is that of the file.
    lines: Vec<(usize, usize)>,
    /// Names of the files.
    names: Vec<String>,
}

impl Expanded {
    /// `true` if the file held xacro.
    pub fn is_expanded(&self) -> bool {
        !self.lines.is_empty()
    }

    /// Converts places in the text to places in the files that the text comes from.
    pub fn relocate(&self, problems: Problems) -> Problems {
        let relocated = |mut message: Message| {
            message.place = message.place.map(|place| Box::new(self.place(*place)));
            message
        };
        Problems(problems.0.into_iter().map(relocated).collect())
    }

    /// Converts a place in the text to a place in its file.
    pub fn place(&self, place: Place) -> Place {
        let line = place.line.and_then(|line| self.lines.get(line.checked_sub(1)?));
        let Some(&(file, line)) = line.filter(|_| place.file == self.name) else { return place };
        Place { file: self.names[file].clone(), line: Some(line), ..place }
    }
}

/// Expands a text; `path` is its file, beside which included files are searched for. `arguments`
/// have the form of xacro: `NAME:=VALUE`. Elements that `skipped` names, with their contents, are
/// expanded as far as possible; the rest is left unchanged.
///
/// # Errors
/// Fails if the text contains constructs that are not expanded here, if an argument has no value,
/// or if an included file cannot be read.
pub fn expand(path: &Path, text: String, arguments: &[String], skipped: fn(&str) -> bool) -> Result<Expanded> {
    let name = path.display().to_string();
    let stated: Vec<(String, String)> = arguments.iter().map(|text| argument(text)).collect::<Result<_>>()?;
    if !["<xacro:", "${", "$("].iter().any(|sign| text.contains(sign)) && stated.is_empty() {
        return Ok(Expanded { name, text, ..Expanded::default() });
    }
    let mut expander = Expander { skipped, stated: stated.into_iter().collect(), ..Expander::new(&name) };
    expander.file(path, &text)?;
    let unknown = expander.stated.keys().find(|name| !expander.declared.contains(*name));
    if let Some(argument) = unknown {
        let message = error!("xacro-argument-unknown", argument, file = name).at(Place::file(name.as_str()));
        return Err(message.hint_names(argument, expander.declared.iter().map(String::as_str)).into());
    }
    let Expander { out, lines, names, included, .. } = expander;
    Ok(Expanded { name, text: out, included, lines, names })
}

/// Name of the URDF to which an expanded file is written: `arm.urdf` for `arm.urdf.xacro`.
pub fn plain_name(name: &str) -> String {
    let stem = name.strip_suffix(".xacro").unwrap_or(name);
    let plain = format!("{}.urdf", stem.strip_suffix(".urdf").or(stem.strip_suffix(".xml")).unwrap_or(stem));
    if plain == name { plain.replace(".urdf", "-expanded.urdf") } else { plain }
}

/// Name and value of an argument.
fn argument(text: &str) -> Result<(String, String)> {
    let (name, value) = text.split_once(":=").ok_or_else(|| error!("xacro-argument-form", argument = text))?;
    match name.is_empty() || name.contains(char::is_whitespace) {
        true => Err(error!("xacro-argument-form", argument = text).into()),
        false => Ok((name.to_owned(), value.to_owned())),
    }
}

/// Reason why a value cannot be computed.
enum Stop {
    /// An expression or a substitution that is not expanded here.
    Construct(String),
    /// A name that is neither a property nor a constant.
    Undefined(String),
    /// An argument without a value.
    Argument(String),
    /// A property that is defined by itself.
    Recursion(String),
    /// A value that is too long.
    TooLong,
    /// A reason in the value of a property, and its place.
    Within(Box<Place>, Box<Stop>),
}

/// Value of an expression.
#[derive(Clone, Debug, PartialEq)]
enum Value {
    Whole(i64),
    Number(f64),
    Flag(bool),
    Text(String),
}

impl Value {
    /// Value of a literal, as a property has it.
    fn literal(text: String) -> Self {
        if let Some(quoted) = text.strip_prefix('\'').and_then(|rest| rest.strip_suffix('\'')) {
            return Self::Text(quoted.to_owned());
        }
        let word = text.trim();
        if text.contains('_') || word.is_empty() {
            return Self::Text(text);
        }
        let number = || word.parse().ok().filter(|v: &f64| v.is_finite()).map(Self::Number);
        let flag = || match word {
            "true" | "True" => Some(Self::Flag(true)),
            "false" | "False" => Some(Self::Flag(false)),
            _ => None,
        };
        word.parse().ok().map(Self::Whole).or_else(number).or_else(flag).unwrap_or(Self::Text(text))
    }

    fn number(&self) -> Option<f64> {
        match self {
            Self::Whole(v) => Some(*v as f64),
            Self::Number(v) => Some(*v),
            _ => None,
        }
    }
}

/// As Python's `str` writes a value.
impl Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Whole(v) => write!(f, "{v}"),
            Self::Number(v) => {
                let text = format!("{v:?}");
                match text.split_once('e').map(|(digits, power)| (digits, power.parse::<i32>().unwrap_or_default())) {
                    Some((digits, power)) => {
                        let sign = if power < 0 { '-' } else { '+' };
                        write!(f, "{digits}e{sign}{:02}", power.abs())
                    }
                    None => f.write_str(&text),
                }
            }
            Self::Flag(v) => f.write_str(if *v { "True" } else { "False" }),
            Self::Text(v) => f.write_str(v),
        }
    }
}

/// A property, which is evaluated at its first use.
#[derive(Clone)]
enum Property {
    Stated(String, Place),
    Evaluating,
    Known(Value),
}

/// Expansion of a file and the files that it includes.
struct Expander {
    /// Name of the first file.
    name: String,
    skipped: fn(&str) -> bool,
    /// Arguments that the user states.
    stated: BTreeMap<String, String>,
    /// Arguments that the files declare.
    declared: BTreeSet<String>,
    arguments: BTreeMap<String, String>,
    properties: BTreeMap<String, Property>,
    /// Files that are being read, the innermost last.
    open: Vec<PathBuf>,
    /// Number of files read.
    read: usize,
    included: Vec<(PathBuf, Stamp)>,
    out: String,
    lines: Vec<(usize, usize)>,
    names: Vec<String>,
}

/// A file that is being expanded.
struct Source<'a> {
    path: &'a Path,
    /// Index of its name.
    index: usize,
    text: &'a str,
    xml: Elements<'a>,
    outermost: bool,
}

impl Source<'_> {
    fn line(&self, at: usize) -> usize {
        self.xml.place(at).line.unwrap_or(1)
    }
}

/// Treatment of an element.
enum Element {
    /// Written, with its values expanded.
    Written,
    /// Written, with its values expanded as far as possible.
    Lenient,
    /// Left out with all that it holds.
    Dropped,
}

impl Expander {
    fn new(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            skipped: |_| false,
            stated: BTreeMap::new(),
            declared: BTreeSet::new(),
            arguments: BTreeMap::new(),
            properties: BTreeMap::new(),
            open: Vec::new(),
            read: 0,
            included: Vec::new(),
            out: String::new(),
            lines: vec![(0, 1)],
            names: Vec::new(),
        }
    }

    /// Appends the expansion of a file.
    fn file(&mut self, path: &Path, text: &str) -> Result<()> {
        let name = path.display().to_string();
        let xml = Elements::read(&name, text, |_| false)?;
        let source = Source { path, index: self.names.len(), text, xml, outermost: self.open.is_empty() };
        self.names.push(name.clone());
        self.open.push(path.to_owned());
        let done = self.events(&source);
        self.open.pop();
        done
    }

    fn events(&mut self, source: &Source) -> Result<()> {
        let mut reader = Reader::from_str(source.text);
        // depths of open elements: all, within a lenient one, within a dropped one
        let (mut depth, mut lenient, mut dropped) = (0usize, 0usize, 0usize);
        loop {
            let start = reader.buffer_position() as usize;
            let event = reader
                .read_event()
                .map_err(|e| error!("xml-malformed", reason = e.to_string()).at(source.xml.place(start)))?;
            let range = start..reader.buffer_position() as usize;
            // the document element of an included file is left out
            let shown = source.outermost || depth > 0;
            match event {
                Event::Eof => return Ok(()),
                Event::Start(_) if dropped > 0 => dropped += 1,
                Event::End(_) if dropped > 0 => dropped -= 1,
                _ if dropped > 0 => {}
                Event::Start(_) | Event::Empty(_) => {
                    let empty = matches!(event, Event::Empty(_));
                    let (Event::Start(tag) | Event::Empty(tag)) = event else { continue };
                    let treatment = if lenient > 0 { Element::Lenient } else { self.element(source, &tag, start)? };
                    let open = usize::from(!empty);
                    match treatment {
                        Element::Dropped => dropped += open,
                        Element::Lenient => {
                            lenient += open;
                            self.tag(source, &tag, range, true)?;
                        }
                        Element::Written => {
                            depth += open;
                            if shown {
                                self.tag(source, &tag, range, false)?;
                            }
                        }
                    }
                }
                Event::End(_) => {
                    if lenient > 0 {
                        lenient -= 1;
                    } else {
                        depth = depth.saturating_sub(1);
                    }
                    if source.outermost || depth > 0 {
                        self.write(source, range)?;
                    }
                }
                Event::Text(_) if source.text.get(range.clone()).is_some_and(|text| text.contains('$')) => {
                    let text = source.text.get(range.clone()).unwrap_or_default();
                    let expanded = self.lenient(source.path, text)?;
                    self.push(&expanded, source.index, source.line(start))?;
                }
                Event::Decl(_) | Event::PI(_) if !source.outermost => {}
                _ if shown => self.write(source, range)?,
                _ => {}
            }
        }
    }

    /// Processes an element of xacro, and returns the treatment of the element.
    fn element(&mut self, source: &Source, tag: &BytesStart, start: usize) -> Result<Element> {
        let name = tag.name().into_inner();
        let Some(directive) = name.strip_prefix("xacro:") else {
            let is_lenient = (self.skipped)(tag.local_name().into_inner());
            return Ok(if is_lenient { Element::Lenient } else { Element::Written });
        };
        let place = source.xml.place(start);
        let here = |message: Message| Problems::from(message.at(place.clone()));
        match directive {
            // its calls are refused
            "macro" => {}
            "arg" => {
                let Some(argument) = attribute(tag, "name") else { return Err(self.refused(name, &place).into()) };
                let value = match (self.stated.get(&argument), attribute(tag, "default")) {
                    (Some(stated), _) => Some(stated.clone()),
                    (None, Some(default)) => {
                        Some(self.text(source.path, &default).map_err(|stop| self.stopped(stop, &place))?)
                    }
                    _ => None,
                };
                self.declared.insert(argument.clone());
                if let Some(value) = value {
                    self.arguments.entry(argument).or_insert(value);
                }
            }
            "property" => self.property(source, tag, &place)?,
            "include" if attribute(tag, "ns").is_none() => {
                let file = attribute(tag, "filename").ok_or_else(|| self.refused(name, &place))?;
                let file = self.text(source.path, &file).map_err(|stop| self.stopped(stop, &place))?;
                let optional =
                    attribute(tag, "optional").is_some_and(|value| ["true", "True", "1"].contains(&value.trim()));
                self.include(source, &file, optional).map_err(|problems| match problems {
                    Included::Message(message) => here(*message),
                    Included::Inside(problems) => problems,
                })?;
            }
            _ => return Err(self.refused(&format!("<{name}>"), &place).into()),
        }
        Ok(Element::Dropped)
    }

    fn property(&mut self, source: &Source, tag: &BytesStart, place: &Place) -> Result<()> {
        let name = attribute(tag, "name").ok_or_else(|| self.refused("<xacro:property>", place))?;
        let is_true =
            |key: &str, absent| attribute(tag, key).map_or(absent, |v| ["true", "True", "1"].contains(&v.trim()));
        if is_true("remove", false) {
            self.properties.remove(&name);
            return Ok(());
        }
        let stated = attribute(tag, "value");
        let default = attribute(tag, "default").filter(|_| stated.is_none());
        if default.is_some() && self.properties.contains_key(&name) {
            return Ok(());
        }
        // a block of elements, of use to macros alone
        let Some(value) = stated.or(default) else { return Ok(()) };
        let property = match is_true("lazy_eval", true) {
            true => Property::Stated(value, place.clone()),
            false => {
                let value = self.evaluated(source.path, &value, 0).map_err(|stop| self.stopped(stop, place))?;
                Property::Known(value)
            }
        };
        self.properties.insert(name, property);
        Ok(())
    }

    /// Appends an included file.
    fn include(&mut self, source: &Source, file: &str, optional: bool) -> std::result::Result<(), Included> {
        let command = self.command();
        let with_hint = |message: Message| message.hint(phrase!("expand-xacro", command));
        let folder = source.path.parent().unwrap_or(Path::new(""));
        let path = match file.strip_prefix("package://").map(|file| file.split_once('/').unwrap_or((file, ""))) {
            None => normal(&folder.join(file)),
            Some((package, file)) => {
                let found = package_folder(package, folder);
                found.ok_or_else(|| with_hint(error!("xacro-package", package)))?.join(file)
            }
        };
        if self.open.iter().any(|open| normal(open) == path) {
            return Err(error!("xacro-include-loop", file).into());
        }
        self.read += 1;
        if self.read > MOST_FILES || self.open.len() >= DEEPEST {
            return Err(error!("xacro-too-many-files", most_files = MOST_FILES, most_depth = DEEPEST).into());
        }
        if optional && !path.exists() {
            return Ok(());
        }
        let (text, stamp) = files::read_statement(&path).map_err(|Problems(all)| {
            let reason = all.first().map_or_else(String::new, |message| message.what.clone());
            with_hint(error!("xacro-include-unreadable", reason))
        })?;
        if self.included.iter().all(|(known, _)| *known != path) {
            self.included.push((path.clone(), stamp));
        }
        self.file(&path, &text).map_err(Included::Inside)
    }

    /// Appends a tag with its values expanded.
    fn tag(&mut self, source: &Source, tag: &BytesStart, range: Range<usize>, lenient: bool) -> Result<()> {
        let raw = source.text.get(range.clone()).unwrap_or_default();
        if !raw.contains('$') {
            return self.write(source, range);
        }
        let mut written = format!("<{}", tag.name().into_inner());
        for attribute in tag.attributes().with_checks(false).flatten() {
            let place = || source.xml.place(range.start);
            let malformed = || error!("xml-malformed", reason = phrase!("attribute-malformed")).at(place());
            let value = attribute.normalized_value(XmlVersion::Implicit1_0).map_err(|_| malformed())?;
            let value = match (value.contains('$'), lenient) {
                (false, _) => value.into_owned(),
                (true, true) => self.lenient(source.path, &value)?,
                (true, false) => self.text(source.path, &value).map_err(|stop| self.stopped(stop, &place()))?,
            };
            let _ = write!(written, " {}=\"{}\"", attribute.key.into_inner(), quick_xml::escape::escape(value));
        }
        written.push_str(if raw.ends_with("/>") { "/>" } else { ">" });
        self.push(&written, source.index, source.line(range.start))
    }

    /// Appends a part of a file as it is.
    fn write(&mut self, source: &Source, range: Range<usize>) -> Result<()> {
        let line = source.line(range.start);
        self.push(source.text.get(range).unwrap_or_default(), source.index, line)
    }

    fn push(&mut self, text: &str, file: usize, line: usize) -> Result<()> {
        if self.out.len() + text.len() > LARGEST {
            return Err(error!("xacro-too-large", most_mib = LARGEST >> 20).at(Place::file(self.name.as_str())).into());
        }
        let begins = self.out.bytes().rev().take_while(|b| *b != b'\n').all(|b| b.is_ascii_whitespace());
        if let Some(last) = self.lines.last_mut().filter(|_| begins) {
            *last = (file, line);
        }
        let breaks = text.bytes().filter(|b| *b == b'\n').count();
        self.lines.extend((1..=breaks).map(|i| (file, line + i)));
        self.out.push_str(text);
        Ok(())
    }

    /// Text with its expressions expanded where they can be, for elements without kinematics.
    fn lenient(&mut self, path: &Path, text: &str) -> Result<String> {
        let mut out = String::new();
        for piece in pieces(text) {
            match self.piece(path, &piece, 0) {
                Ok(value) => out += &value.to_string(),
                Err(_) => out += piece.text(),
            }
        }
        Ok(out.replace("file://package://", "package://"))
    }

    /// Value of a text as a text.
    fn text(&mut self, path: &Path, text: &str) -> std::result::Result<String, Stop> {
        self.value(path, text, 0).map(|value| value.to_string())
    }

    /// Value of a text: that of its only expression, or the text.
    fn value(&mut self, path: &Path, text: &str, depth: usize) -> std::result::Result<Value, Stop> {
        let mut all = Vec::new();
        for piece in pieces(text) {
            all.push(self.piece(path, &piece, depth)?);
        }
        if let [only] = &all[..] {
            return Ok(only.clone());
        }
        let text: String = all.iter().map(Value::to_string).collect();
        if text.len() > LONGEST_VALUE { Err(Stop::TooLong) } else { Ok(Value::Text(text)) }
    }

    /// Value of a text as a property has it.
    fn evaluated(&mut self, path: &Path, text: &str, depth: usize) -> std::result::Result<Value, Stop> {
        Ok(match self.value(path, text, depth)? {
            Value::Text(text) => Value::literal(text),
            value => value,
        })
    }

    fn piece(&mut self, path: &Path, piece: &Piece, depth: usize) -> std::result::Result<Value, Stop> {
        match piece {
            Piece::Plain(text) => Ok(Value::Text((*text).to_owned())),
            Piece::Expression(whole) => {
                let inside = &whole[2..whole.len() - 1];
                let mut parser = Parser { expander: self, path, whole, rest: inside, depth };
                let value = parser.sum()?;
                if parser.rest.trim().is_empty() { Ok(value) } else { Err(parser.construct()) }
            }
            Piece::Substitution(whole) => {
                let inside = self.value(path, &whole[2..whole.len() - 1], depth)?.to_string();
                let words: Vec<&str> = inside.split_whitespace().collect();
                let value = match words[..] {
                    ["arg", name] => {
                        self.arguments.get(name).cloned().ok_or_else(|| Stop::Argument(name.to_owned()))?
                    }
                    // as URDF names a file of a package
                    ["find", package] => format!("package://{package}"),
                    ["dirname"] => path.parent().unwrap_or(Path::new(".")).display().to_string(),
                    _ => return Err(Stop::Construct((*whole).to_owned())),
                };
                Ok(Value::Text(value))
            }
        }
    }

    /// Value of a property.
    fn get(&mut self, path: &Path, name: &str, depth: usize) -> std::result::Result<Option<Value>, Stop> {
        let Some(property) = self.properties.get_mut(name) else { return Ok(None) };
        let stated = match property {
            Property::Known(value) => return Ok(Some(value.clone())),
            Property::Evaluating => return Err(Stop::Recursion(name.to_owned())),
            Property::Stated(..) if depth >= DEEPEST => return Err(Stop::TooLong),
            Property::Stated(text, place) => (std::mem::take(text), place.clone()),
        };
        *property = Property::Evaluating;
        let (text, place) = stated;
        let value = self.evaluated(path, &text, depth + 1);
        let kept = value.as_ref().map_or(Property::Stated(text, place.clone()), |value| Property::Known(value.clone()));
        self.properties.insert(name.to_owned(), kept);
        value.map(Some).map_err(|stop| match stop {
            Stop::Within(..) => stop,
            stop => Stop::Within(Box::new(place), Box::new(stop)),
        })
    }

    /// Message about what is not expanded.
    fn refused(&self, construct: &str, place: &Place) -> Message {
        let hint = phrase!("expand-xacro", command = self.command());
        error!("xacro-construct", construct).at(place.clone()).hint(hint)
    }

    fn stopped(&self, stop: Stop, place: &Place) -> Message {
        let message = match stop {
            Stop::Construct(construct) => return self.refused(&construct, place),
            Stop::Undefined(name) => {
                error!("xacro-undefined", name).hint_names(&name, self.properties.keys().map(String::as_str))
            }
            Stop::Argument(argument) => error!("xacro-argument-missing", argument),
            Stop::Within(place, stop) => return self.stopped(*stop, &place),
            Stop::Recursion(name) => error!("xacro-recursion", name),
            Stop::TooLong => error!("xacro-value-too-long", most_bytes = LONGEST_VALUE, most_depth = DEEPEST),
        };
        message.at(place.clone())
    }

    /// Command that expands the file.
    fn command(&self) -> String {
        let word = |text: &str| match text.chars().all(|c| c.is_alphanumeric() || "/._-+,@:=".contains(c)) {
            true => text.to_owned(),
            false => format!("'{}'", text.replace('\'', "'\\''")),
        };
        let missing = self.declared.iter().filter(|name| !self.arguments.contains_key(*name));
        let missing = missing.filter(|name| !self.stated.contains_key(*name)).map(|name| format!("{name}:=VALUE"));
        let stated = self.stated.iter().map(|(name, value)| word(&format!("{name}:={value}")));
        let words: Vec<String> = std::iter::once(word(&self.name)).chain(stated).chain(missing).collect();
        format!("xacro {} > {}", words.join(" "), word(&plain_name(&self.name)))
    }
}

/// Failure of an include: of the element itself, or within the file.
enum Included {
    Message(Box<Message>),
    Inside(Problems),
}

impl From<Message> for Included {
    fn from(message: Message) -> Self {
        Self::Message(Box::new(message))
    }
}

fn attribute(tag: &BytesStart, name: &str) -> Option<String> {
    let found = tag.attributes().with_checks(false).flatten().find(|a| a.key.into_inner() == name)?;
    found.normalized_value(XmlVersion::Implicit1_0).ok().map(|value| value.into_owned())
}

/// Path without `.`, and without `..` if its folder is known.
fn normal(path: &Path) -> PathBuf {
    let mut out = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir if matches!(out.components().next_back(), Some(Component::Normal(_))) => {
                out.pop();
            }
            other => out.push(other),
        }
    }
    out
}

/// Folder of a package: a folder of this name above the file in `folder`, or beside one of those
/// folders. The path begins with the folder as the user names it.
fn package_folder(package: &str, folder: &Path) -> Option<PathBuf> {
    if package.is_empty() || package.contains(['/', '\\']) || package.starts_with('.') {
        return None;
    }
    let absolute = std::path::absolute(if folder.as_os_str().is_empty() { Path::new(".") } else { folder }).ok()?;
    let above = |count: usize| normal(&(0..count).fold(folder.to_owned(), |path, _| path.join("..")));
    let mut ancestors = absolute.ancestors().take(FOLDERS_ABOVE + 1).enumerate();
    ancestors.find_map(|(count, ancestor)| {
        let is_package = ancestor.file_name().is_some_and(|name| name == package);
        let beside = || ancestor.join(package).is_dir().then(|| above(count).join(package));
        if is_package { Some(above(count)) } else { beside() }
    })
}

/// A part of a text.
enum Piece<'a> {
    Plain(&'a str),
    /// Content of `${...}`.
    Expression(&'a str),
    /// Content of `$(...)`.
    Substitution(&'a str),
}

impl<'a> Piece<'a> {
    fn text(&self) -> &'a str {
        let (Self::Plain(text) | Self::Expression(text) | Self::Substitution(text)) = self;
        text
    }
}

/// Parts of a text; one dollar of `$${` and `$$(` is an escape.
fn pieces(text: &str) -> Vec<Piece<'_>> {
    let mut all = Vec::new();
    let (mut from, mut at) = (0, 0);
    while let Some(found) = text[at..].find('$') {
        let start = at + found;
        let dollars = text[start..].bytes().take_while(|b| *b == b'$').count();
        let open = start + dollars;
        let close = match text.as_bytes().get(open) {
            Some(b'{') => '}',
            Some(b'(') => ')',
            _ => {
                at = open;
                continue;
            }
        };
        let end = text[open..].find(close).map(|end| open + end + 1);
        if dollars == 1 && end.is_none() {
            at = open;
            continue;
        }
        all.extend((from < start).then(|| Piece::Plain(&text[from..start])));
        match (dollars, end) {
            (1, Some(end)) => {
                let whole = &text[start..end];
                all.push(if close == '}' { Piece::Expression(whole) } else { Piece::Substitution(whole) });
                (from, at) = (end, end);
            }
            _ => {
                from = start + 1;
                at = open + 1;
            }
        }
    }
    all.extend((from < text.len()).then(|| Piece::Plain(&text[from..])));
    all
}

/// Evaluates an expression: numbers, texts and properties with + − * / **, parentheses and
/// functions of numbers.
struct Parser<'e, 'a> {
    expander: &'e mut Expander,
    path: &'a Path,
    /// The whole expression, for messages.
    whole: &'a str,
    rest: &'a str,
    depth: usize,
}

type Computed = std::result::Result<Value, Stop>;

impl<'a> Parser<'_, 'a> {
    fn construct(&self) -> Stop {
        Stop::Construct(self.whole.to_owned())
    }

    fn take(&mut self, sign: &str) -> bool {
        let rest = self.rest.trim_start().strip_prefix(sign);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }

    fn sum(&mut self) -> Computed {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(Stop::TooLong);
        }
        let mut value = self.product()?;
        loop {
            value = match (self.take("+"), &value) {
                (true, Value::Text(text)) => match self.product()? {
                    Value::Text(more) if text.len() + more.len() <= LONGEST_VALUE => {
                        Value::Text(format!("{text}{more}"))
                    }
                    Value::Text(_) => return Err(Stop::TooLong),
                    _ => return Err(self.construct()),
                },
                (true, _) => {
                    let other = self.product()?;
                    self.arithmetic(&value, &other, i64::checked_add, |a, b| a + b)?
                }
                _ if self.take("-") => {
                    let other = self.product()?;
                    self.arithmetic(&value, &other, i64::checked_sub, |a, b| a - b)?
                }
                _ => break,
            };
        }
        self.depth -= 1;
        Ok(value)
    }

    fn product(&mut self) -> Computed {
        let mut value = self.sign()?;
        loop {
            let start = self.rest;
            if self.take("**") || self.take("//") {
                self.rest = start;
                return Err(self.construct());
            }
            value = if self.take("*") {
                let other = self.sign()?;
                self.arithmetic(&value, &other, i64::checked_mul, |a, b| a * b)?
            } else if self.take("/") {
                let other = self.sign()?;
                self.arithmetic(&value, &other, |_, _| None, |a, b| a / b)?
            } else {
                return Ok(value);
            };
        }
    }

    fn sign(&mut self) -> Computed {
        // a sign takes the power that follows it: -2**2 is -4
        let mut negative = false;
        loop {
            if self.take("-") {
                negative = !negative;
            } else if !self.take("+") {
                break;
            }
        }
        let value = self.power()?;
        if negative { self.arithmetic(&Value::Whole(0), &value, i64::checked_sub, |_, b| -b) } else { Ok(value) }
    }

    fn power(&mut self) -> Computed {
        let base = self.atom()?;
        if !self.take("**") {
            return Ok(base);
        }
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(Stop::TooLong);
        }
        let exponent = self.sign()?;
        self.depth -= 1;
        let whole = |a: i64, b: i64| u32::try_from(b).ok().and_then(|b| a.checked_pow(b));
        self.arithmetic(&base, &exponent, whole, f64::powf)
    }

    /// Result of an operation: a whole number if the operation on whole numbers yields one.
    fn arithmetic(
        &self,
        a: &Value,
        b: &Value,
        whole: impl Fn(i64, i64) -> Option<i64>,
        number: impl Fn(f64, f64) -> f64,
    ) -> Computed {
        let of_whole = if let (Value::Whole(a), Value::Whole(b)) = (a, b) { whole(*a, *b) } else { None };
        let (Some(x), Some(y)) = (a.number(), b.number()) else { return Err(self.construct()) };
        let result = of_whole.map_or_else(|| Value::Number(number(x, y)), Value::Whole);
        if result.number().is_some_and(f64::is_finite) { Ok(result) } else { Err(self.construct()) }
    }

    fn atom(&mut self) -> Computed {
        let rest = self.rest.trim_start();
        let first = rest.chars().next().ok_or_else(|| self.construct())?;
        if self.take("(") {
            let value = self.sum()?;
            return if self.take(")") { Ok(value) } else { Err(self.construct()) };
        }
        if first == '\'' || first == '"' {
            let end = rest[1..].find(first).ok_or_else(|| self.construct())?;
            let text = &rest[1..=end];
            self.rest = &rest[end + 2..];
            return if text.contains('\\') { Err(self.construct()) } else { Ok(Value::Text(text.to_owned())) };
        }
        if first.is_ascii_digit() || first == '.' {
            return self.literal(rest);
        }
        let length = rest.find(|c: char| !(c.is_alphanumeric() || c == '_' || c == '.')).unwrap_or(rest.len());
        let name = &rest[..length];
        if name.is_empty() {
            return Err(self.construct());
        }
        self.rest = &rest[length..];
        if self.rest.trim_start().starts_with('(') {
            return self.call(name);
        }
        if let Some(value) = self.expander.get(self.path, name, self.depth)? {
            return Ok(value);
        }
        match name.strip_prefix("math.").unwrap_or(name) {
            "pi" => Ok(Value::Number(std::f64::consts::PI)),
            "tau" => Ok(Value::Number(std::f64::consts::TAU)),
            "e" => Ok(Value::Number(std::f64::consts::E)),
            "True" | "False" => Ok(Value::Flag(name == "True")),
            // words of Python
            "if" | "else" | "and" | "or" | "not" | "None" | "for" | "in" | "lambda" => Err(self.construct()),
            _ if name.contains('.') => Err(self.construct()),
            _ => Err(Stop::Undefined(name.to_owned())),
        }
    }

    fn literal(&mut self, rest: &'a str) -> Computed {
        let digits = rest.find(|c: char| !(c.is_ascii_digit() || c == '.')).unwrap_or(rest.len());
        let exponent = rest[digits..].strip_prefix(['e', 'E']).map_or(0, |tail| {
            let sign = usize::from(tail.starts_with(['+', '-']));
            let count = tail[sign..].bytes().take_while(u8::is_ascii_digit).count();
            if count == 0 { 0 } else { 1 + sign + count }
        });
        let (number, tail) = rest.split_at(digits + exponent);
        self.rest = tail;
        match Value::literal(number.to_owned()) {
            value @ (Value::Whole(_) | Value::Number(_)) => Ok(value),
            _ => Err(self.construct()),
        }
    }

    /// Value of a function of numbers.
    fn call(&mut self, name: &str) -> Computed {
        self.take("(");
        let mut all = vec![self.sum()?];
        while self.take(",") {
            all.push(self.sum()?);
        }
        if !self.take(")") {
            return Err(self.construct());
        }
        let numbers: Option<Vec<f64>> = all.iter().map(Value::number).collect();
        let numbers = numbers.ok_or_else(|| self.construct())?;
        let value = match (name.strip_prefix("math.").unwrap_or(name), &numbers[..]) {
            ("sin", [v]) => v.sin(),
            ("cos", [v]) => v.cos(),
            ("tan", [v]) => v.tan(),
            ("asin", [v]) => v.asin(),
            ("acos", [v]) => v.acos(),
            ("atan", [v]) => v.atan(),
            ("atan2", [y, x]) => y.atan2(*x),
            ("sqrt", [v]) => v.sqrt(),
            ("hypot", [x, y]) => x.hypot(*y),
            ("radians", [v]) => v.to_radians(),
            ("degrees", [v]) => v.to_degrees(),
            ("pow", [a, b]) => a.powf(*b),
            ("fabs", [v]) => v.abs(),
            ("float", [v]) => *v,
            _ => return Err(self.construct()),
        };
        if value.is_finite() { Ok(Value::Number(value)) } else { Err(self.construct()) }
    }
}

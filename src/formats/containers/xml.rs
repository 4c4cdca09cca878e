//! A small XML tree for untrusted files: no document types, no custom entities, bounded depth and
//! size.

use etalon_base::message::{Message, Place, Result};
use etalon_base::{error, phrase};
use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use std::borrow::Cow;

/// Maximum nesting depth.
const DEEPEST: usize = 64;
/// Maximum number of elements; 2²² take half a gigabyte at most.
const MOST_ELEMENTS: usize = 1 << 22;
/// Maximum length of a line that a message shows (bytes).
const LONGEST_LINE: usize = 200;

/// The elements of a file that are of interest, in document order.
pub struct Elements<'a> {
    file: &'a str,
    text: &'a str,
    /// Beginning of each line (bytes), for fast lookup of a place.
    lines: Vec<usize>,
    elements: Vec<Element<'a>>,
}

struct Element<'a> {
    /// Name without its prefix.
    name: &'a str,
    attributes: &'a str,
    /// Beginning in the file (bytes).
    start: usize,
    /// The element after its last descendant.
    after: usize,
    text: Cow<'a, str>,
}

/// One element of a [`Elements`].
#[derive(Clone, Copy)]
pub struct Node<'t, 'a> {
    tree: &'t Elements<'a>,
    index: usize,
}

impl<'a> Elements<'a> {
    /// Reads a text. `skipped` gives the elements that are omitted with their contents.
    ///
    /// # Errors
    /// Fails if the text is not well-formed XML, or if it declares a document type.
    pub fn read(file: &'a str, text: &'a str, skipped: impl Fn(&str) -> bool) -> Result<Self> {
        let breaks = text.bytes().enumerate().filter(|(_, b)| *b == b'\n').map(|(i, _)| i + 1);
        let mut tree = Self { file, text, lines: std::iter::once(0).chain(breaks).collect(), elements: Vec::new() };
        if let Some(at) = text.find('\0') {
            let place = tree.place(at);
            return Err(error!("nul-byte", line = place.line.unwrap_or(1)).at(place).into());
        }
        let mut reader = Reader::from_str(text);
        let mut open: Vec<usize> = Vec::new();
        let mut left_out = 0usize;
        loop {
            let start = reader.buffer_position() as usize;
            let event = reader.read_event().map_err(|e| {
                let at = reader.error_position() as usize;
                error!("xml-malformed", reason = e.to_string()).at(tree.place(at))
            })?;
            match event {
                Event::Start(tag) if left_out > 0 || skipped(local(&tag)) => {
                    left_out += 1;
                    tree.shallow(open.len() + left_out, start, &tag)?;
                }
                Event::Start(tag) => {
                    tree.shallow(open.len() + 1, start, &tag)?;
                    tree.add(start, &tag, open.is_empty())?;
                    open.push(tree.elements.len() - 1);
                }
                Event::Empty(tag) if left_out == 0 && !skipped(local(&tag)) => {
                    tree.add(start, &tag, open.is_empty())?
                }
                Event::End(_) if left_out > 0 => left_out -= 1,
                Event::End(_) => {
                    let after = tree.elements.len();
                    if let Some(element) = open.pop().and_then(|i| tree.elements.get_mut(i)) {
                        element.after = after;
                    }
                }
                Event::DocType(_) => {
                    return Err(error!("xml-doctype").at(tree.place(start)).into());
                }
                // also within an element that is omitted
                Event::Eof => break,
                _ if left_out > 0 => {}
                Event::Text(piece) => tree.append(&open, piece.into_inner()),
                Event::CData(piece) => tree.append(&open, piece.into_inner()),
                Event::GeneralRef(reference) => {
                    let character = match &*reference {
                        "lt" => Some('<'),
                        "gt" => Some('>'),
                        "amp" => Some('&'),
                        "apos" => Some('\''),
                        "quot" => Some('"'),
                        _ => reference.resolve_char_ref().ok().flatten(),
                    };
                    let reason = || phrase!("entity-unknown", name = reference.to_string());
                    let unknown = || error!("xml-malformed", reason = reason()).at(tree.place(start));
                    let character = character.ok_or_else(unknown)?;
                    tree.append(&open, Cow::Owned(character.to_string()));
                }
                _ => {}
            }
        }
        match open.last().and_then(|&i| tree.elements.get(i)) {
            Some(e) => {
                let missing = format!("`</{}>`", e.name);
                Err(error!("file-cut-off", missing).at(tree.place(e.start)).into())
            }
            None => Ok(tree),
        }
    }

    fn shallow(&self, depth: usize, start: usize, tag: &BytesStart) -> Result<()> {
        if depth <= DEEPEST {
            return Ok(());
        }
        let message = error!("nested-too-deep", name = local(tag), depth, most = DEEPEST);
        Err(message.at(self.place(start)).into())
    }

    fn add(&mut self, start: usize, tag: &BytesStart, outermost: bool) -> Result<()> {
        if outermost && !self.elements.is_empty() {
            let reason = phrase!("second-root-element");
            return Err(error!("xml-malformed", reason).at(self.place(start)).into());
        }
        if self.elements.len() >= MOST_ELEMENTS {
            let message = error!("file-too-many-items", items = "elements", most = MOST_ELEMENTS);
            return Err(message.at(self.place(start)).into());
        }
        // the tag begins with `<` and the name
        let inside = self.text.get(start + 1..).unwrap_or("");
        let name = inside.get(..tag.name().as_ref().len()).unwrap_or("");
        let attributes = inside.get(name.len()..tag.len()).unwrap_or("");
        let name = name.rsplit(':').next().unwrap_or("");
        let after = self.elements.len() + 1;
        self.elements.push(Element { name, attributes, start, after, text: Cow::Borrowed("") });
        Ok(())
    }

    fn append(&mut self, open: &[usize], piece: Cow<'a, str>) {
        let Some(element) = open.last().and_then(|&i| self.elements.get_mut(i)) else { return };
        match element.text.is_empty() {
            // blanks between elements are not text
            true if piece.trim().is_empty() => {}
            true => element.text = piece,
            false => element.text.to_mut().push_str(&piece),
        }
    }

    /// The document element; `None` for an empty file.
    pub fn root(&self) -> Option<Node<'_, 'a>> {
        (!self.elements.is_empty()).then_some(Node { tree: self, index: 0 })
    }

    /// Line of the byte `at`.
    pub fn place(&self, at: usize) -> Place {
        let number = self.lines.partition_point(|start| *start <= at).max(1);
        let start = self.lines.get(number - 1).copied().unwrap_or(0);
        let end = self.lines.get(number).copied().unwrap_or(self.text.len());
        if end - start > LONGEST_LINE {
            return Place::line(self.file, number, "");
        }
        let line = self.text.get(start..end).unwrap_or("");
        let column = line.get(..at.saturating_sub(start)).unwrap_or("").chars().count() + 1;
        Place::line(self.file, number, line.trim_end_matches(['\r', '\n'])).at(column, 1)
    }
}

fn local<'t>(tag: &'t BytesStart) -> &'t str {
    tag.local_name().into_inner()
}

impl<'t, 'a> Node<'t, 'a> {
    fn element(self) -> &'t Element<'a> {
        &self.tree.elements[self.index]
    }

    /// Name without prefix.
    pub fn name(self) -> &'a str {
        self.element().name
    }

    /// `true` if the name has this prefix.
    pub fn has_prefix(self, prefix: &str) -> bool {
        let name = self.tree.text.get(self.element().start + 1..).and_then(|tag| tag.strip_prefix(prefix));
        name.is_some_and(|rest| rest.starts_with(':'))
    }

    /// Text of the element itself, without blanks around it.
    pub fn text(self) -> &'t str {
        self.element().text.trim()
    }

    /// Line of the file, from 1, and the beginning of the element for a message.
    pub fn place(self) -> Place {
        self.tree.place(self.element().start)
    }

    /// Elements directly within.
    pub fn children(self) -> impl Iterator<Item = Node<'t, 'a>> {
        let end = self.element().after;
        let mut next = self.index + 1;
        std::iter::from_fn(move || {
            let index = (next < end).then_some(next)?;
            next = self.tree.elements[index].after;
            Some(Node { tree: self.tree, index })
        })
    }

    /// Returns the first direct child of this name.
    pub fn child(self, name: &str) -> Option<Node<'t, 'a>> {
        self.children().find(|c| c.name() == name)
    }

    /// The element itself and all descendants, in document order.
    pub fn all(self) -> impl Iterator<Item = Node<'t, 'a>> {
        (self.index..self.element().after).map(move |index| Node { tree: self.tree, index })
    }

    /// Value of an attribute; `None` if it is missing or malformed.
    pub fn attribute(self, name: &str) -> Option<Cow<'a, str>> {
        let mut attributes = quick_xml::events::attributes::Attributes::new(self.element().attributes, 0);
        // looking for attributes given twice takes time in the square of their number
        let found = attributes.with_checks(false).flatten().find(|a| a.key.local_name().into_inner() == name)?;
        found.normalized_value(quick_xml::XmlVersion::Implicit1_0).ok()
    }

    /// Value of `id`; `None` if it is missing or needs decoding.
    pub fn id(self) -> Option<&'t str> {
        match self.attribute("id")? {
            Cow::Borrowed(id) => Some(id),
            Cow::Owned(_) => None,
        }
    }

    /// The numbers in the text, separated by blanks.
    pub fn numbers(self) -> std::result::Result<Vec<f64>, Message> {
        let number = |field: &str| {
            etalon_tables::lexer::number(field, etalon_tables::Decimal::Point).map_err(|m| m.at(self.place()))
        };
        self.text().split_ascii_whitespace().map(number).collect()
    }
}

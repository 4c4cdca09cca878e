//! XML elements as values, for XML formats.

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesEnd, BytesStart, BytesText, Event};

/// An element with its attributes and content.
#[derive(Clone)]
pub(super) struct Element {
    name: &'static str,
    attributes: Vec<(&'static str, String)>,
    text: Option<String>,
    elements: Vec<Element>,
}

/// Creates an element with child elements.
pub(super) fn element(name: &'static str, elements: impl IntoIterator<Item = Element>) -> Element {
    Element { name, attributes: Vec::new(), text: None, elements: elements.into_iter().collect() }
}

/// Creates an element with text. Characters that XML forbids are replaced, surrounding white space
/// is removed.
pub(super) fn leaf(name: &'static str, text: impl std::fmt::Display) -> Element {
    Element { name, attributes: Vec::new(), text: Some(printable(&text.to_string())), elements: Vec::new() }
}

/// Creates an element with several lines of text.
pub(super) fn block(name: &'static str, lines: &str) -> Element {
    Element { name, attributes: Vec::new(), text: Some(lines.to_owned()), elements: Vec::new() }
}

fn printable(text: &str) -> String {
    let legal = |c: char| if c.is_control() || ('\u{fffe}'..='\u{ffff}').contains(&c) { ' ' } else { c };
    text.chars().map(legal).collect::<String>().split_whitespace().collect::<Vec<_>>().join(" ")
}

impl Element {
    /// Adds an attribute.
    pub fn with(mut self, name: &'static str, value: impl std::fmt::Display) -> Self {
        self.attributes.push((name, printable(&value.to_string())));
        self
    }

    /// Returns the document with this root element, preceded by a comment with these lines.
    pub fn document(&self, header: &[String]) -> std::io::Result<Vec<u8>> {
        let mut out = Writer::new_with_indent(Vec::new(), b' ', 1);
        out.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
        let header = header.join("\n  ").replace("--", "__");
        out.write_event(Event::Comment(BytesText::from_escaped(format!("\n  {header}\n"))))?;
        self.write(&mut out)?;
        let mut bytes = out.into_inner();
        bytes.push(b'\n');
        Ok(bytes)
    }

    fn write(&self, out: &mut Writer<Vec<u8>>) -> std::io::Result<()> {
        let mut start = BytesStart::new(self.name);
        for (name, value) in &self.attributes {
            start.push_attribute((*name, value.as_str()));
        }
        if self.text.is_none() && self.elements.is_empty() {
            return out.write_event(Event::Empty(start));
        }
        out.write_event(Event::Start(start))?;
        if let Some(text) = &self.text {
            out.write_event(Event::Text(BytesText::new(text)))?;
        }
        for element in &self.elements {
            element.write(out)?;
        }
        out.write_event(Event::End(BytesEnd::new(self.name)))
    }
}

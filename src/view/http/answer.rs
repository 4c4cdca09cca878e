//! Answers of HTTP/1.1.

use crate::contract::ShownMessage;
use serde::Serialize;
use std::fmt::Write as _;
use std::io::{self, Write};

/// Answer to a request. Every connection ends with its answer.
#[derive(Clone, Debug)]
pub(crate) struct Answer {
    pub status: u16,
    kind: &'static str,
    /// Further fields.
    fields: Vec<(&'static str, String)>,
    body: Vec<u8>,
}

/// Text of a status (RFC 9110, 15).
fn reason(status: u16) -> &'static str {
    match status {
        200 => "OK",
        202 => "Accepted",
        400 => "Bad Request",
        403 => "Forbidden",
        404 => "Not Found",
        405 => "Method Not Allowed",
        408 => "Request Timeout",
        411 => "Length Required",
        413 => "Content Too Large",
        421 => "Misdirected Request",
        431 => "Request Header Fields Too Large",
        503 => "Service Unavailable",
        _ => "Internal Server Error",
    }
}

impl Answer {
    pub fn new(status: u16, kind: &'static str, body: Vec<u8>) -> Self {
        Self { status, kind, fields: Vec::new(), body }
    }

    /// A document as JSON.
    pub fn json(status: u16, document: &impl Serialize) -> Self {
        match serde_json::to_vec(document) {
            Ok(body) => Self::new(status, "application/json", body),
            Err(_) => Self::new(500, "application/json", b"{\"messages\":[]}".to_vec()),
        }
    }

    /// Messages as JSON.
    pub fn messages(status: u16, messages: &[ShownMessage]) -> Self {
        #[derive(Serialize)]
        struct Messages<'a> {
            messages: &'a [ShownMessage],
        }
        Self::json(status, &Messages { messages })
    }

    /// Adds a field. Its value is ours, or has no control characters.
    pub fn with(mut self, name: &'static str, value: impl Into<String>) -> Self {
        self.fields.push((name, value.into()));
        self
    }

    /// Lines of the head, up to the empty line.
    fn head(&self, length: Option<usize>) -> String {
        let mut head = format!("HTTP/1.1 {} {}\r\nContent-Type: {}\r\n", self.status, reason(self.status), self.kind);
        if let Some(length) = length {
            let _ = write!(head, "Content-Length: {length}\r\n");
        }
        let always = [
            ("Connection", "close"),
            ("Cache-Control", "no-store"),
            ("X-Content-Type-Options", "nosniff"),
            ("Referrer-Policy", "no-referrer"),
            ("Cross-Origin-Resource-Policy", "same-origin"),
            ("Cross-Origin-Opener-Policy", "same-origin"),
            ("X-Frame-Options", "DENY"),
        ];
        for (name, value) in always.into_iter().chain(self.fields.iter().map(|(n, v)| (*n, v.as_str()))) {
            let _ = write!(head, "{name}: {value}\r\n");
        }
        if self.fields.iter().all(|(name, _)| *name != "Content-Security-Policy") {
            head += "Content-Security-Policy: default-src 'none'; sandbox\r\n";
        }
        head + "\r\n"
    }

    pub fn write(&self, stream: &mut impl Write) -> io::Result<()> {
        stream.write_all(self.head(Some(self.body.len())).as_bytes())?;
        stream.write_all(&self.body)?;
        stream.flush()
    }

    /// Writes the head of a stream of events, whose length is open.
    pub fn begin_events(stream: &mut impl Write) -> io::Result<()> {
        stream.write_all(Self::new(200, "text/event-stream", Vec::new()).head(None).as_bytes())?;
        stream.write_all(b"retry: 1000\n\n")?;
        stream.flush()
    }
}

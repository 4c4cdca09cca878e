//! Requests of HTTP/1.1 (RFC 9112), with bounds on every part.

use std::io::{ErrorKind, Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

/// Maximum size of the head of a request (bytes), and maximum number of its fields.
const HEAD: usize = 16 << 10;
const FIELDS: usize = 64;

/// Request without a body that is not read yet.
#[derive(Clone, Debug, Default)]
pub(crate) struct Request {
    pub method: String,
    /// Path without query, as sent.
    pub path: String,
    /// Query, as sent.
    pub query: String,
    /// Names in small letters, with their values.
    fields: Vec<(String, String)>,
    /// Beginning of the body that came with the head.
    begun: Vec<u8>,
}

/// Request that cannot be read, by the status of its answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unreadable {
    /// The connection is closed or silent: nobody waits for an answer.
    Silent,
    /// 400: no request of HTTP/1.1.
    Malformed,
    /// 408: the sender takes too long.
    Slow,
    /// 411: a body of unknown length.
    WithoutLength,
    /// 413: a body beyond the bound.
    TooLarge,
    /// 431: a head beyond the bound.
    HeadTooLarge,
}

impl Request {
    /// Reads the head of a request.
    pub fn read(stream: &mut TcpStream, within: Duration) -> Result<Self, Unreadable> {
        let until = Instant::now() + within;
        let mut bytes = Vec::new();
        loop {
            if let Some(request) = Self::parse(&bytes)? {
                return Ok(request);
            }
            if bytes.len() >= HEAD {
                return Err(Unreadable::HeadTooLarge);
            }
            let mut part = [0; 4096];
            match read_some(stream, &mut part, until)? {
                0 if bytes.is_empty() => return Err(Unreadable::Silent),
                0 => return Err(Unreadable::Malformed),
                n => bytes.extend_from_slice(&part[..n]),
            }
        }
    }

    /// Returns the request at the beginning of these bytes; `None` if its head is incomplete.
    fn parse(bytes: &[u8]) -> Result<Option<Self>, Unreadable> {
        let mut fields = [httparse::EMPTY_HEADER; FIELDS];
        let mut parsed = httparse::Request::new(&mut fields);
        let head = match parsed.parse(bytes) {
            Ok(httparse::Status::Complete(head)) => head,
            Ok(httparse::Status::Partial) => return Ok(None),
            Err(httparse::Error::TooManyHeaders) => return Err(Unreadable::HeadTooLarge),
            Err(_) => return Err(Unreadable::Malformed),
        };
        let (Some(method), Some(target), Some(1)) = (parsed.method, parsed.path, parsed.version) else {
            return Err(Unreadable::Malformed);
        };
        let field = |field: &httparse::Header| {
            let value = std::str::from_utf8(field.value).map_err(|_| Unreadable::Malformed)?;
            Ok((field.name.to_ascii_lowercase(), value.to_owned()))
        };
        let (path, query) = target.split_once('?').unwrap_or((target, ""));
        Ok(Some(Self {
            method: method.to_owned(),
            path: path.to_owned(),
            query: query.to_owned(),
            fields: parsed.headers.iter().map(field).collect::<Result<_, _>>()?,
            begun: bytes[head..].to_vec(),
        }))
    }

    /// Value of a field; `Err` if it is sent more than once.
    pub fn field(&self, name: &str) -> Result<Option<&str>, Unreadable> {
        let mut values = self.fields.iter().filter(|(field, _)| field == name).map(|(_, value)| value.as_str());
        let first = values.next();
        if values.next().is_some() { Err(Unreadable::Malformed) } else { Ok(first) }
    }

    /// Value of a key of the query, decoded; `None` if it is missing or no UTF-8.
    pub fn value(&self, key: &str) -> Option<String> {
        let pairs = self.query.split('&').map(|pair| pair.split_once('=').unwrap_or((pair, "")));
        let (_, value) = pairs.into_iter().find(|(name, _)| *name == key)?;
        let value = value.replace('+', " ");
        Some(percent_encoding::percent_decode_str(&value).decode_utf8().ok()?.into_owned())
    }

    /// Reads the body, of at most `most` bytes.
    pub fn body(mut self, stream: &mut TcpStream, most: usize, within: Duration) -> Result<Vec<u8>, Unreadable> {
        if self.field("transfer-encoding")?.is_some() {
            return Err(Unreadable::WithoutLength);
        }
        let Some(length) = self.field("content-length")? else { return Err(Unreadable::WithoutLength) };
        let digits = !length.is_empty() && length.bytes().all(|b| b.is_ascii_digit());
        let length =
            if digits { length.parse::<usize>().unwrap_or(usize::MAX) } else { return Err(Unreadable::Malformed) };
        if length > most {
            return Err(Unreadable::TooLarge);
        }
        if self.field("expect")?.is_some_and(|expect| expect.eq_ignore_ascii_case("100-continue")) {
            let _ = stream.write_all(b"HTTP/1.1 100 Continue\r\n\r\n");
        }
        let mut body = std::mem::take(&mut self.begun);
        let until = Instant::now() + within;
        let mut part = vec![0; 64 << 10];
        while body.len() < length {
            match read_some(stream, &mut part, until)? {
                0 => return Err(Unreadable::Malformed),
                n => body.extend_from_slice(&part[..n]),
            }
        }
        // what follows would be another request, and every connection has one
        body.truncate(length);
        Ok(body)
    }
}

/// Reads the received bytes, and waits for them until a time.
fn read_some(stream: &mut TcpStream, part: &mut [u8], until: Instant) -> Result<usize, Unreadable> {
    loop {
        let left = until.saturating_duration_since(Instant::now());
        if left.is_zero() || stream.set_read_timeout(Some(left)).is_err() {
            return Err(Unreadable::Slow);
        }
        match stream.read(part) {
            Ok(n) => return Ok(n),
            Err(e) if e.kind() == ErrorKind::Interrupted => {}
            Err(e) if matches!(e.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut) => return Err(Unreadable::Slow),
            Err(_) => return Err(Unreadable::Silent),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(text: &str) -> Result<Option<Request>, Unreadable> {
        Request::parse(text.as_bytes())
    }

    #[test]
    fn a_request_is_read_with_its_fields_and_the_beginning_of_its_body() {
        let text =
            "POST /api/files?name=a%20b%2Fc.csv&x HTTP/1.1\r\nHost: 127.0.0.1:7\r\nX-Etalon-Token: t\r\n\r\nbody";
        let request = parsed(text).unwrap().unwrap();
        assert_eq!((request.method.as_str(), request.path.as_str()), ("POST", "/api/files"));
        assert_eq!(request.value("name").as_deref(), Some("a b/c.csv"));
        assert_eq!((request.value("x").as_deref(), request.value("y")), (Some(""), None));
        assert_eq!(request.field("x-etalon-token"), Ok(Some("t")));
        assert_eq!(request.begun, b"body");
        assert!(parsed(&text[..40]).unwrap().is_none(), "a head that is incomplete");
    }

    #[test]
    fn what_is_no_request_is_refused() {
        assert_eq!(parsed("GET / HTTP/1.0\r\n\r\n").unwrap_err(), Unreadable::Malformed);
        assert_eq!(parsed("\u{16}\u{3}\u{1}\r\n\r\n").unwrap_err(), Unreadable::Malformed);
        let many: String = (0..FIELDS + 1).map(|i| format!("a{i}: b\r\n")).collect();
        assert_eq!(parsed(&format!("GET / HTTP/1.1\r\n{many}\r\n")).unwrap_err(), Unreadable::HeadTooLarge);
        let twice = parsed("GET / HTTP/1.1\r\nHost: a\r\nhost: b\r\n\r\n").unwrap().unwrap();
        assert_eq!(twice.field("host"), Err(Unreadable::Malformed));
        assert_eq!(parsed("GET /?name=%ff HTTP/1.1\r\n\r\n").unwrap().unwrap().value("name"), None);
    }
}

//! Requests of the page, and the calls of the desk that answer them.

use crate::answer::Answer;
use crate::contract::{Asked, Keep, State, WhatIfAsked};
use crate::desk::{Answered, Refusal};
use crate::page;
use crate::refusals::{refusal, unreadable_answer};
use crate::request::Request;
use crate::shared::{Shared, random};
use etalon_base::error;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::net::TcpStream;

/// Longest name of a file (bytes).
const LONGEST_NAME: usize = 200;

/// Names of devices of Windows: with any extension, they name no file there.
const DEVICES: [&str; 6] = ["con", "prn", "aux", "nul", "com", "lpt"];

/// `true` if a name is the name of a file in a folder on every system.
fn is_file_name(name: &str) -> bool {
    let stem = name.split('.').next().unwrap_or_default().to_ascii_lowercase();
    let device = |device: &&str| {
        let number = stem.strip_prefix(*device);
        number.is_some_and(|number| match number.len() {
            0 => device.len() == 3,
            1 => number.bytes().all(|b| b.is_ascii_digit()),
            _ => false,
        })
    };
    let plain = |c: char| !c.is_control() && !"/\\:*?\"<>|".contains(c);
    // marks of direction and the like disguise a name
    let visible = |c: char| !matches!(c, '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2060}'..='\u{2069}' | '\u{feff}');
    let edges = name.starts_with(['.', ' ', '-']) || name.ends_with(['.', ' ']);
    !name.is_empty()
        && name.len() <= LONGEST_NAME
        && !edges
        && name.chars().all(|c| plain(c) && visible(c))
        && !DEVICES.iter().any(device)
}

/// Answers a permitted request.
pub(crate) fn answer(shared: &Shared, request: Request, stream: &mut TcpStream) -> Answer {
    let desk = &*shared.desk;
    match (request.method.as_str(), request.path.as_str()) {
        ("GET", "/") => match random() {
            Ok(nonce) => {
                let (page, policy) = page::served(&nonce);
                Answer::new(200, "text/html; charset=utf-8", page.into_bytes()).with("Content-Security-Policy", policy)
            }
            Err(_) => Answer::messages(500, &[]),
        },
        ("GET", "/api/state") => Answer::json(200, &desk.state()),
        ("GET", "/api/meshes") => Answer::json(200, &desk.meshes()),
        ("GET", "/api/download") => download(shared, &request),
        ("GET", "/api/export") => match page::exported(&State { meshes: desk.meshes(), ..desk.state() }) {
            Ok(page) => Answer::new(200, "text/html; charset=utf-8", page.into_bytes())
                .with("Content-Disposition", "attachment; filename=\"view.html\""),
            Err(_) => Answer::messages(500, &[]),
        },
        ("POST", "/api/files") => with_name(shared, &request.clone(), |name| {
            match request.body(stream, shared.limits.file_bytes, shared.limits.body) {
                Ok(bytes) => answered(desk.add_file(name, &bytes)),
                Err(unreadable) => unreadable_answer(shared, unreadable),
            }
        }),
        ("DELETE", "/api/files") => with_name(shared, &request, |name| answered(desk.remove_file(name))),
        ("POST", "/api/check") => Answer::messages(200, &desk.check()),
        ("POST", "/api/run") => match desk.run() {
            Ok(()) => Answer::messages(202, &[]),
            Err(Refusal(messages)) => Answer::messages(400, &messages),
        },
        ("POST", "/api/propose") => read(shared, request, stream, |asked: Asked| answered(desk.propose(&asked))),
        ("POST", "/api/accept") => read(shared, request, stream, |asked: Asked| answered(desk.accept(&asked))),
        ("POST", "/api/whatif") => read(shared, request, stream, |asked: WhatIfAsked| answered(desk.what_if(&asked))),
        ("POST", "/api/keep") => read(shared, request, stream, |Keep { asked, reason }| {
            #[derive(Serialize)]
            struct Difference {
                difference: String,
            }
            answered(desk.keep(&asked, &reason).map(|difference| Difference { difference }))
        }),
        _ => refusal(shared, 404, error!("view-request-unknown")),
    }
}

/// Answer of the desk as JSON.
fn answered(answer: Answered<impl Serialize>) -> Answer {
    match answer {
        Ok(document) => Answer::json(200, &document),
        Err(Refusal(messages)) => Answer::messages(400, &messages),
    }
}

/// Calls with the name of a file, if it is one.
fn with_name(shared: &Shared, request: &Request, call: impl FnOnce(&str) -> Answer) -> Answer {
    match request.value("name").filter(|name| is_file_name(name)) {
        Some(name) => call(&name),
        None => refusal(shared, 400, error!("view-file-name")),
    }
}

/// Calls with the document of the body.
fn read<T: DeserializeOwned>(
    shared: &Shared,
    request: Request,
    stream: &mut TcpStream,
    call: impl FnOnce(T) -> Answer,
) -> Answer {
    let bytes = match request.body(stream, shared.limits.request_bytes, shared.limits.body) {
        Ok(bytes) => bytes,
        Err(unreadable) => return unreadable_answer(shared, unreadable),
    };
    match serde_json::from_slice(if bytes.is_empty() { b"{}" } else { &bytes }) {
        Ok(document) => call(document),
        Err(_) => refusal(shared, 400, error!("view-request-malformed")),
    }
}

/// A file of the output folder.
fn download(shared: &Shared, request: &Request) -> Answer {
    let name = request.value("name").filter(|name| is_file_name(name));
    let found = name.and_then(|name| Some((shared.desk.download(&name)?, name)));
    let Some((bytes, name)) = found else { return refusal(shared, 404, error!("view-download-unknown")) };
    let kind = match name.rsplit('.').next() {
        Some("html") => "text/html; charset=utf-8",
        Some("pdf") => "application/pdf",
        Some("json") => "application/json",
        _ => "application/octet-stream",
    };
    let encoded = percent_encoding::utf8_percent_encode(&name, percent_encoding::NON_ALPHANUMERIC);
    Answer::new(200, kind, bytes).with("Content-Disposition", format!("attachment; filename*=UTF-8''{encoded}"))
}

#[cfg(test)]
mod tests {
    use super::is_file_name;

    #[test]
    fn names_that_leave_the_folder_or_are_none_are_refused() {
        for name in ["points.csv", "Messung 1 (äöü).txt", "log_2024-01-01.tar.gz", "console.csv", "com10.txt", "a..b"]
        {
            assert!(is_file_name(name), "{name}");
        }
        let long = "a".repeat(201);
        let hostile = [
            "",
            ".",
            "..",
            "../x",
            "a/b",
            "a\\b",
            "/etc/passwd",
            "C:x",
            "x:stream",
            ".env",
            "-rf",
            "a\0b",
            "a\nb",
            "nul",
            "CON.csv",
            "com1",
            "LPT9.txt",
            "<img src=x>",
            "x ",
            "x.",
            "a\u{202e}gpj.exe",
            &long,
        ];
        for name in hostile {
            assert!(!is_file_name(name), "{name:?}");
        }
    }
}

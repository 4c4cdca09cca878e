//! Limits of templates that a person writes: nesting of the source, instructions, widths, size of
//! the result, time and memory. A template beyond a limit is rejected with its name and the limit.

use crate::message::Result;
use crate::{error, phrase};
use minijinja::value::{Rest, ValueOrKwargs};
use minijinja::{Environment, Error, ErrorKind, State, Template, Value};
use std::error::Error as _;
use std::io::{self, Write};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::{Duration, Instant};

/// Limit of time; pages take a second, the largest reports with thousands of poses several.
const LONGEST: Duration = Duration::from_secs(60);
/// Limit of memory growth of the process (bytes).
const LARGEST: u64 = 2 << 30;
/// Stack size (bytes), as templates may be deeply nested.
const STACK: usize = 64 << 20;
/// Limit of the levels of brackets, operators and blocks within each other.
const DEEPEST: usize = 250;
/// Limit of the width of a field, of an indentation and of a row (characters, items).
const WIDEST: usize = 10_000;
/// Limit of the size of a file, and of a text that a filter makes (bytes).
const LONGEST_TEXT: usize = 64 << 20;

/// Checks the nesting of a template before it is parsed: parsers call themselves at each level.
///
/// # Errors
/// Fails if brackets, operators and blocks are nested too deeply.
pub fn check_nesting(name: &str, text: &str) -> Result<()> {
    match too_deep(text) {
        Some(line) => Err(error!("template-too-nested", template = name, line, most = DEEPEST).into()),
        None => Ok(()),
    }
}

/// Checks the brackets of a document whose text is code (`report.typ`).
///
/// # Errors
/// Fails if brackets are nested too deeply.
pub fn check_brackets(name: &str, text: &str) -> Result<()> {
    let mut depth = 0_usize;
    for (at, byte) in text.bytes().enumerate() {
        match byte {
            b'(' | b'[' | b'{' => depth += 1,
            b')' | b']' | b'}' => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth > DEEPEST {
            let line = line(text, at);
            return Err(error!("template-too-nested", template = name, line, most = DEEPEST).into());
        }
    }
    Ok(())
}

/// Line of the first tag that is nested too deeply.
fn too_deep(text: &str) -> Option<usize> {
    // levels of each open block: one, and one more for each `elif`
    let mut blocks: Vec<usize> = Vec::new();
    let mut at = 0;
    while let Some(start) = text[at..].find('{').map(|found| at + found) {
        let close = match text.as_bytes().get(start + 1) {
            Some(b'{') => "}}",
            Some(b'%') => "%}",
            Some(b'#') => {
                at = text[start..].find("#}").map_or(text.len(), |end| start + end + 2);
                continue;
            }
            _ => {
                at = start + 1;
                continue;
            }
        };
        let inside = &text[start + 2..];
        let (end, depth) = expression(inside, close);
        if close == "%}" {
            block(&inside[..end], &mut blocks);
        }
        if depth.max(blocks.iter().sum()) > DEEPEST {
            return Some(line(text, start));
        }
        at = (start + 2 + end + 2).min(text.len());
        while !text.is_char_boundary(at) {
            at += 1;
        }
    }
    None
}

fn line(text: &str, at: usize) -> usize {
    text.as_bytes()[..at].iter().filter(|byte| **byte == b'\n').count() + 1
}

/// Opens or closes the block of a tag.
fn block(tag: &str, blocks: &mut Vec<usize>) {
    let word = tag.trim_start_matches(['-', '+']).split_whitespace().next().unwrap_or_default();
    match word {
        "elif" => blocks.iter_mut().last().map_or((), |levels| *levels += 1),
        "if" | "for" | "macro" | "block" | "call" | "filter" | "with" | "autoescape" => blocks.push(1),
        "set" if !tag.contains('=') => blocks.push(1),
        word if word.starts_with("end") => drop(blocks.pop()),
        _ => {}
    }
}

/// Length of the content of a tag, and the most levels of brackets and operators in it. A comma
/// ends the operators of its level.
fn expression(text: &str, close: &str) -> (usize, usize) {
    let bytes = text.as_bytes();
    let (mut levels, mut depth, mut deepest, mut at) = (vec![1_usize], 1, 1, 0);
    while at < bytes.len() && !(levels.len() == 1 && bytes[at..].starts_with(close.as_bytes())) {
        let added = match bytes[at] {
            quote @ (b'"' | b'\'') => {
                at += string(&bytes[at + 1..], quote);
                0
            }
            b'(' | b'[' | b'{' => {
                levels.push(0);
                1
            }
            b')' | b']' | b'}' => {
                depth -= if levels.len() > 1 { levels.pop().unwrap_or_default() } else { 0 };
                0
            }
            b',' => {
                let level = levels.last_mut();
                depth -= level.map(|level| std::mem::replace(level, 1) - 1).unwrap_or_default();
                0
            }
            b'|' | b'.' | b'+' | b'-' | b'*' | b'/' | b'%' | b'~' | b'<' | b'>' | b'=' | b'!' => 1,
            byte if byte.is_ascii_alphabetic() => {
                let word = bytes[at..].iter().take_while(|b| b.is_ascii_alphanumeric() || **b == b'_').count();
                let is_operator =
                    matches!(&bytes[at..at + word], b"not" | b"and" | b"or" | b"in" | b"is" | b"if" | b"else");
                at += word - 1;
                usize::from(is_operator)
            }
            _ => 0,
        };
        if let Some(level) = levels.last_mut() {
            *level += added;
        }
        depth += added;
        deepest = deepest.max(depth);
        at += 1;
    }
    (at.min(bytes.len()), deepest)
}

/// Length of a string behind its opening quote, with the closing one.
fn string(bytes: &[u8], quote: u8) -> usize {
    let mut at = 0;
    while at < bytes.len() && bytes[at] != quote {
        at += if bytes[at] == b'\\' { 2 } else { 1 };
    }
    (at + 1).min(bytes.len())
}

/// Bounds the instructions of templates and the widths and sizes that filters make.
pub fn bound(environment: &mut Environment, instructions: u64) {
    environment.set_fuel(Some(instructions));
    environment.add_filter(BUILT_IN[0], minijinja::filters::indent);
    environment.add_filter("indent", |state: &mut State, args: Rest<ValueOrKwargs>| {
        let args = args.into_values();
        check_widths(&args)?;
        let lines = args.first().and_then(|text| Some(text.as_str()?.matches('\n').count() + 1)).unwrap_or(0);
        check_length(lines.saturating_mul(args.iter().skip(1).filter_map(width).max().unwrap_or(4)))?;
        state.apply_filter(BUILT_IN[0], &args)
    });
    environment.add_filter(BUILT_IN[1], minijinja::filters::format);
    environment.add_filter("format", |state: &mut State, args: Rest<ValueOrKwargs>| {
        let args = args.into_values();
        let text = args.first().and_then(Value::as_str).unwrap_or_default();
        let stated = text.split(|c: char| !c.is_ascii_digit()).filter(|digits| !digits.is_empty());
        // a width of `*` is an argument
        let starred = text.contains('*').then(|| args.iter().skip(1).filter_map(width)).into_iter().flatten();
        let mut widths = stated.map(|digits| digits.parse().unwrap_or(usize::MAX)).chain(starred);
        if text.contains('%') && widths.any(|width| width > WIDEST) {
            return Err(too_wide());
        }
        state.apply_filter(BUILT_IN[1], &args)
    });
    environment.add_filter(BUILT_IN[2], minijinja::filters::replace);
    environment.add_filter("replace", |state: &mut State, args: Rest<ValueOrKwargs>| {
        let args = args.into_values();
        if let [Some(text), Some(from), Some(to)] = [0, 1, 2].map(|i| args.get(i).and_then(Value::as_str)) {
            let count = if from.is_empty() { text.len() + 1 } else { text.matches(from).count() };
            check_length(count.saturating_mul(to.len()).saturating_add(text.len()))?;
        }
        state.apply_filter(BUILT_IN[2], &args)
    });
    environment.add_filter(BUILT_IN[3], minijinja::filters::batch);
    environment.add_filter(BUILT_IN[4], minijinja::filters::slice);
    for (name, built_in) in ["batch", "slice"].into_iter().zip(&BUILT_IN[3..]) {
        environment.add_filter(name, |state: &mut State, args: Rest<ValueOrKwargs>| {
            let args = args.into_values();
            check_widths(&args)?;
            state.apply_filter(built_in, &args)
        });
    }
}

/// Names under which templates cannot reach the filters that have no bounds.
const BUILT_IN: [&str; 5] =
    ["built-in indent", "built-in format", "built-in replace", "built-in batch", "built-in slice"];

/// Width that an argument of a filter gives.
fn width(value: &Value) -> Option<usize> {
    let named = || value.get_attr("width").ok()?.as_usize();
    value.as_usize().or_else(named)
}

fn check_widths(args: &[Value]) -> std::result::Result<(), Error> {
    args.iter().skip(1).filter_map(width).try_for_each(check_width)
}

/// Checks the width or the number of decimals that a template gives.
///
/// # Errors
/// Fails beyond 10,000.
pub fn check_width(width: usize) -> std::result::Result<(), Error> {
    if width > WIDEST { Err(too_wide()) } else { Ok(()) }
}

fn too_wide() -> Error {
    Error::new(ErrorKind::InvalidOperation, phrase!("template-width", most = WIDEST).to_string())
}

fn check_length(bytes: usize) -> std::result::Result<(), Error> {
    if bytes > LONGEST_TEXT { Err(too_long()) } else { Ok(()) }
}

fn too_long() -> Error {
    Error::new(ErrorKind::InvalidOperation, phrase!("template-size", most_mib = LONGEST_TEXT >> 20).to_string())
}

/// Fills a template whose result is bounded.
///
/// # Errors
/// Fails if the template does, or if its result is longer than 64 MiB.
pub fn fill(template: &Template, values: Value) -> std::result::Result<String, Error> {
    let mut text = Bounded { bytes: Vec::new(), is_full: false };
    let filled = template.render_captured_to(values, &mut text).map(drop);
    if text.is_full {
        return Err(too_long());
    }
    filled.map(|()| String::from_utf8_lossy(&text.bytes).into_owned())
}

/// Text up to a size.
struct Bounded {
    bytes: Vec<u8>,
    is_full: bool,
}

impl Write for Bounded {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.bytes.len() + bytes.len() > LONGEST_TEXT {
            self.is_full = true;
            return Err(io::ErrorKind::FileTooLarge.into());
        }
        self.bytes.extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Innermost error of nested templates: the line that is wrong.
pub fn innermost(error: &Error) -> &Error {
    error.source().and_then(|inner| inner.downcast_ref()).map_or(error, innermost)
}

/// Reason of an error; the limit of instructions is part of it.
pub fn reason(error: &Error, instructions: u64) -> String {
    match error.detail() {
        _ if error.kind() == ErrorKind::OutOfFuel => phrase!("template-instructions", most = instructions).to_string(),
        Some(detail) => format!("{}: {detail}", error.kind()),
        None => error.kind().to_string(),
    }
}

/// Runs `work` with the template `name` on a thread of its own, whose stack is large.
///
/// # Errors
/// Fails after a minute or beyond 2 GiB. The template continues until the process ends, which
/// follows an error.
pub fn supervised<T: Send + 'static>(name: &str, work: impl FnOnce() -> Result<T> + Send + 'static) -> Result<T> {
    let fail = |fault: &str| error!("template-failed", template = name, fault);
    let (sender, receiver) = channel();
    let thread = std::thread::Builder::new().stack_size(STACK).spawn(move || drop(sender.send(work())));
    thread.map_err(|e| fail(&e.to_string()))?;
    let (begun, before) = (Instant::now(), resident());
    loop {
        match receiver.recv_timeout(Duration::from_millis(10)) {
            Ok(made) => return made,
            Err(RecvTimeoutError::Disconnected) => return Err(fail("ended").into()),
            Err(RecvTimeoutError::Timeout) if begun.elapsed() > LONGEST => {
                return Err(fail("time").into());
            }
            Err(RecvTimeoutError::Timeout) if resident().saturating_sub(before) > LARGEST => {
                return Err(fail("memory").into());
            }
            Err(RecvTimeoutError::Timeout) => {}
        }
    }
}

/// Resident memory of the process (bytes); 0 if the system does not report it.
fn resident() -> u64 {
    let pages = std::fs::read_to_string("/proc/self/statm").ok();
    let pages = pages.and_then(|text| text.split_whitespace().nth(1)?.parse::<u64>().ok());
    pages.unwrap_or(0) * 4096
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nesting_is_counted_and_long_lists_are_not_nested() {
        let is_deep = |text: String| too_deep(&text).is_some();
        for level in ["(", "[", "{", "not ", "-", "x+", "x~", "x|upper|", "x.", "1 if x else ", "x and "] {
            assert!(is_deep(format!("{{{{ {} }}}}", level.repeat(300))), "{level}");
            assert!(!is_deep(format!("{{{{ {} }}}}", level.repeat(20))), "{level}");
        }
        assert!(is_deep("{% if x %}".repeat(300)) && is_deep("{% if x %}".to_owned() + &"{% elif x %}".repeat(300)));
        assert!(!is_deep("{% if x %}{% for i in y %}{{ i }}{% endfor %}{% endif %}".repeat(500)));
        assert!(!is_deep("{% set x = 1 %}{{ x + 1 }}".repeat(500)));
        assert!(!is_deep(format!("{{{{ [{}] }}}}", "-1.5, ".repeat(2000))));
        assert!(!is_deep(format!("{{{{ \"{}\" }}}} {{# {} #}}", "((((".repeat(500), "{{ (".repeat(500))));
        // the line of the first tag that is too deep
        assert_eq!(too_deep(&format!("a\n{{{{ x }}}}\n{{{{ {} }}}}", "(".repeat(300))), Some(3));
        for odd in ["{", "{{", "{%", "{#", "{{ \"", "{{ 'é", "{{ é }}", "{% raw %}", "}}", "{{ ) ) , }}", "{{ \"\\"] {
            assert!(!is_deep(odd.to_owned()), "{odd}");
        }
    }

    /// Result of a template with bounds, or the reason of its error.
    fn filled(text: &str) -> std::result::Result<String, String> {
        let mut environment = Environment::new();
        bound(&mut environment, 100_000);
        let template = environment.template_from_str(text).unwrap();
        fill(&template, Value::from(())).map_err(|e| reason(innermost(&e), 100_000))
    }

    #[test]
    fn filters_work_within_their_limits_and_name_them_beyond() {
        let done = [
            ("{{ 'a\nb'|indent(2) }}", "a\n  b"),
            ("{{ 'a\nb'|indent(width=1, first=true) }}", " a\n b"),
            ("{{ '%05.2f'|format(1.5) }}", "01.50"),
            ("{{ 'aa'|replace('a', 'bc') }}", "bcbc"),
            ("{{ [1, 2, 3]|batch(2)|list|length }}", "2"),
        ];
        done.into_iter().for_each(|(text, made)| assert_eq!(filled(text).as_deref(), Ok(made), "{text}"));
        let wide = phrase!("template-width", most = WIDEST).to_string();
        let size = phrase!("template-size", most_mib = LONGEST_TEXT >> 20).to_string();
        let steps = phrase!("template-instructions", most = 100_000).to_string();
        let grown = |times: usize| format!("{{{{ 'aaaaaaaaaa'{} }}}}", "|replace('a', 'aaaaaaaaaa')".repeat(times));
        for (text, limit) in [
            ("{{ 'a\nb'|indent(99999999999999999) }}", &wide),
            ("{{ 'a\nb'|indent(width=999999999) }}", &wide),
            ("{{ '%999999999d'|format(1) }}", &wide),
            ("{{ '%99999999999999999999999d'|format(1) }}", &wide),
            ("{{ '%.999999999f'|format(1) }}", &wide),
            ("{{ '%*d'|format(999999999, 1) }}", &wide),
            ("{{ [1]|batch(999999999, 0) }}", &wide),
            (&grown(12), &size),
            ("{% for i in range(90000) %}{{ 'x' * 10000 }}{% endfor %}", &size),
            ("{% for i in range(9000) %}{% for j in range(9000) %}{% endfor %}{% endfor %}", &steps),
        ] {
            let reason = filled(text).unwrap_err();
            assert!(reason.contains(limit.as_str()), "{text}: {reason}");
        }
    }
}

//! One connection: a request that is allowed, and its answer.

use crate::answer::Answer;
use crate::refusals::{refusal, refusal_to_read, unreadable_answer};
use crate::request::{Request, Unreadable};
use crate::routes;
use crate::shared::{Counted, Shared};
use etalon_base::error;
use std::io::{Read, Write};
use std::net::{Shutdown, TcpStream};
use std::sync::mpsc::RecvTimeoutError;
use std::time::{Duration, Instant};

/// Time between two signs of life on a stream of events.
const HEARTBEAT: Duration = Duration::from_millis(1000);

/// Answers the request of a connection.
pub(crate) fn answer(shared: &Shared, stream: &mut TcpStream) {
    let answer = match Request::read(stream, shared.limits.head) {
        Ok(request) => match permitted(shared, &request) {
            Ok(()) if request.path == "/api/events" => return follow(shared, stream),
            Ok(()) => routes::answer(shared, request, stream),
            Err(refused) => refused,
        },
        Err(Unreadable::Silent) => return,
        Err(unreadable) => unreadable_answer(shared, unreadable),
    };
    finish(stream, &answer);
}

/// Rejects a connection beyond the bound.
pub(crate) fn refuse_busy(shared: &Shared, stream: &mut TcpStream) {
    // nothing is waited for: the server goes on to the next connection at once
    let busy = refusal(shared, 503, error!("view-busy", most = shared.limits.connections));
    if busy.write(stream).is_ok() && stream.set_nonblocking(true).is_ok() {
        // received bytes are read: otherwise the closing connection loses its answer
        drop(stream.read(&mut [0; 4096]));
    }
}

/// Writes an answer, and reads the rest of the request: if the connection closed earlier, the
/// sender would lose the answer.
fn finish(stream: &mut TcpStream, answer: &Answer) {
    if answer.write(stream).is_err() || stream.shutdown(Shutdown::Write).is_err() {
        return;
    }
    let (mut left, until) = ([0; 16 << 10], Instant::now() + Duration::from_secs(1));
    let refused = answer.status >= 400 && stream.set_read_timeout(Some(Duration::from_millis(300))).is_ok();
    while refused && Instant::now() < until && matches!(stream.read(&mut left), Ok(1..)) {}
}

/// Allows a request of this page: by the name of the server, the origin and the token.
fn permitted(shared: &Shared, request: &Request) -> Result<(), Answer> {
    let malformed = |unreadable| unreadable_answer(shared, unreadable);
    let names = [format!("127.0.0.1:{}", shared.port), format!("localhost:{}", shared.port)];
    // another name for 127.0.0.1 is an attack by DNS rebinding
    let host = request.field("host").map_err(malformed)?;
    if !host.is_some_and(|host| names.iter().any(|name| host.eq_ignore_ascii_case(name))) {
        return Err(refusal(shared, 421, error!("view-other-host", name = &names[0])));
    }
    let origin = request.field("origin").map_err(malformed)?;
    let own = |origin: &str| names.iter().any(|name| origin.strip_prefix("http://") == Some(name));
    if origin.is_some_and(|origin| !own(origin)) {
        return Err(refusal(shared, 403, error!("view-other-origin")));
    }
    let sent = match request.field("x-etalon-token").map_err(malformed)? {
        Some(token) => Some(token.to_owned()),
        // a link and a stream of events have no fields of their own
        None if request.method == "GET" => request.value("token"),
        None => None,
    };
    match sent.is_some_and(|sent| is_same(sent.as_bytes(), shared.token.as_bytes())) {
        true => Ok(()),
        // an address that was typed without its token
        false if request.path == "/" => Err(refusal_to_read(shared, 403, &error!("view-token-missing"))),
        false => Err(refusal(shared, 403, error!("view-token-missing"))),
    }
}

/// Compares in a time that does not depend on the contents.
fn is_same(a: &[u8], b: &[u8]) -> bool {
    a.len() == b.len() && a.iter().zip(b).fold(0, |all, (a, b)| all | (a ^ b)) == 0
}

/// Sends events until the page is closed.
fn follow(shared: &Shared, stream: &mut TcpStream) {
    let Some(_page) = Counted::new(&shared.pages, shared.limits.pages) else {
        return finish(stream, &refusal(shared, 503, error!("view-busy", most = shared.limits.pages)));
    };
    shared.note_page();
    let events = shared.events.listen();
    let mut alive = Answer::begin_events(stream).is_ok();
    while alive {
        alive = match events.recv_timeout(HEARTBEAT) {
            Ok(text) => stream.write_all(text.as_bytes()).and_then(|()| stream.flush()).is_ok(),
            Err(RecvTimeoutError::Timeout) => stream.write_all(b":\n\n").and_then(|()| stream.flush()).is_ok(),
            Err(RecvTimeoutError::Disconnected) => false,
        };
        shared.note_page();
    }
}

//! Tests of the server with a desk that has nothing to show.

use crate::contract::{Asked, Mesh, Proposal, ShownMessage, State, WhatIf, WhatIfAsked};
use crate::desk::{Answered, Desk, Refusal};
use crate::events::{Event, Events};
use crate::server::Server;
use crate::shared::Limits;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::sync::Arc;
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

struct Nothing;

impl Desk for Nothing {
    fn state(&self) -> State {
        State::default()
    }
    fn meshes(&self) -> Vec<Mesh> {
        Vec::new()
    }
    fn add_file(&self, _name: &str, _bytes: &[u8]) -> Answered<State> {
        Err(Refusal(Vec::new()))
    }
    fn remove_file(&self, _name: &str) -> Answered<State> {
        Err(Refusal(Vec::new()))
    }
    fn propose(&self, _asked: &Asked) -> Answered<Proposal> {
        Err(Refusal(Vec::new()))
    }
    fn accept(&self, _asked: &Asked) -> Answered<State> {
        Err(Refusal(Vec::new()))
    }
    fn check(&self) -> Vec<ShownMessage> {
        Vec::new()
    }
    fn run(&self) -> Answered<()> {
        Ok(())
    }
    fn what_if(&self, _asked: &WhatIfAsked) -> Answered<WhatIf> {
        Err(Refusal(Vec::new()))
    }
    fn keep(&self, _asked: &WhatIfAsked, _reason: &str) -> Answered<String> {
        Err(Refusal(Vec::new()))
    }
    fn download(&self, _name: &str) -> Option<Vec<u8>> {
        None
    }
    fn language(&self) -> &'static str {
        "en"
    }
}

/// A server in a thread.
struct Served {
    url: String,
    events: Events,
    thread: JoinHandle<std::io::Result<()>>,
}

impl Served {
    fn new(limits: Limits) -> Self {
        let server = Server::listen(0, limits).unwrap();
        let (url, events) = (server.url(), Events::default());
        let own = events.clone();
        let thread = std::thread::spawn(move || server.serve(Arc::new(Nothing), own));
        Self { url, events, thread }
    }

    fn address(&self) -> &str {
        self.url.strip_prefix("http://").unwrap().split('/').next().unwrap()
    }

    fn connect(&self, path: &str) -> TcpStream {
        let mut stream = TcpStream::connect(self.address()).unwrap();
        let token = self.url.split('=').nth(1).unwrap();
        write!(stream, "GET {path}?token={token} HTTP/1.1\r\nHost: {}\r\n\r\n", self.address()).unwrap();
        stream
    }

    fn status(&self, path: &str) -> String {
        let mut text = String::new();
        let mut stream = self.connect(path);
        // a rejected connection may end before its answer is read
        drop(stream.read_to_string(&mut text));
        text.split(' ').nth(1).unwrap_or_default().to_owned()
    }
}

#[test]
fn the_server_ends_when_the_page_has_been_closed_for_a_while() {
    let closed = Duration::from_millis(400);
    let served = Served::new(Limits { closed, ..Limits::default() });
    std::thread::sleep(2 * closed);
    assert_eq!(served.status("/api/state"), "200", "it waits for the first page");
    let mut page = BufReader::new(served.connect("/api/events"));
    std::thread::sleep(3 * closed);
    served.events.send(&Event::State { version: 7 });
    let mut line = String::new();
    while !line.contains("\"version\":7") {
        line.clear();
        assert!(page.read_line(&mut line).unwrap() > 0, "a page that is open keeps it alive");
    }
    drop(page);
    let begun = Instant::now();
    while !served.thread.is_finished() && begun.elapsed() < Duration::from_secs(60) {
        std::thread::sleep(Duration::from_millis(20));
    }
    assert!(served.thread.is_finished() && begun.elapsed() >= closed);
}

#[test]
fn connections_beyond_the_bound_are_refused_and_others_answered() {
    let served = Served::new(Limits { connections: 3, head: Duration::from_secs(20), ..Limits::default() });
    let idle: Vec<TcpStream> = (0..3).map(|_| TcpStream::connect(served.address()).unwrap()).collect();
    let begun = Instant::now();
    while served.status("/api/state") != "503" {
        assert!(begun.elapsed() < Duration::from_secs(10));
    }
    drop(idle);
    while served.status("/api/state") != "200" {
        assert!(begun.elapsed() < Duration::from_secs(15), "closed connections make room");
    }
}

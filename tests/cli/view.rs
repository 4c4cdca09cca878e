//! `etalon view`: the server against hostile requests, the state of every model, and identifications of the page against runs.

use crate::support::documents_of;
use crate::support::scratch::{Scratch, copy_sample};
use etalon::campaign::Campaign;
use etalon::session::Session;
use etalon::view::{Desk, WhatIfAsked};
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// Longest wait for the program, which is not optimised and shares the machine.
const PATIENCE: Duration = Duration::from_secs(120);

/// A running `etalon view`.
struct Page {
    child: Child,
    port: u16,
    token: String,
}

impl Drop for Page {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Answer of the server.
#[derive(Debug)]
struct Answer {
    status: u16,
    head: String,
    body: Vec<u8>,
}

impl Answer {
    fn json(&self) -> Value {
        serde_json::from_slice(&self.body).unwrap_or_else(|e| panic!("{e}: {}", String::from_utf8_lossy(&self.body)))
    }

    /// Ids of the messages.
    fn ids(&self) -> Vec<String> {
        let json = self.json();
        json["messages"].as_array().unwrap().iter().map(|m| m["id"].as_str().unwrap().to_owned()).collect()
    }
}

impl Page {
    fn open(arguments: &[&str], folder: &Path) -> Self {
        let mut child = Command::new(crate::support::program())
            .arg("view")
            .args(arguments)
            .arg("--no-open")
            .current_dir(folder)
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let mut line = String::new();
        BufReader::new(child.stdout.take().unwrap()).read_line(&mut line).unwrap();
        let address = line.trim().split("http://127.0.0.1:").nth(1).unwrap_or_else(|| panic!("{line:?}"));
        let (port, token) = address.split_once("/?token=").unwrap();
        Self { child, port: port.parse().unwrap(), token: token.to_owned() }
    }

    fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        stream.set_read_timeout(Some(PATIENCE)).unwrap();
        stream
    }

    /// Sends bytes and reads to the end.
    fn send(&self, bytes: &[u8]) -> Answer {
        let mut stream = self.connect();
        let _ = stream.write_all(bytes);
        let mut all = Vec::new();
        let _ = stream.read_to_end(&mut all);
        let end = all
            .windows(4)
            .position(|four| four == b"\r\n\r\n")
            .unwrap_or_else(|| panic!("no answer to {:?}", String::from_utf8_lossy(&bytes[..bytes.len().min(200)])));
        let head = String::from_utf8(all[..end].to_vec()).unwrap();
        let status = head.split(' ').nth(1).unwrap().parse().unwrap();
        Answer { status, head, body: all[end + 4..].to_vec() }
    }

    /// A request with these fields in place of the usual ones.
    fn request(&self, line: &str, fields: &[(&str, &str)], body: &[u8]) -> Answer {
        let mut head = format!("{line} HTTP/1.1\r\n");
        fields.iter().for_each(|(name, value)| _ = write!(head, "{name}: {value}\r\n"));
        self.send(&[head.as_bytes(), b"\r\n", body].concat())
    }

    fn host(&self) -> String {
        format!("127.0.0.1:{}", self.port)
    }

    fn get(&self, path: &str) -> Answer {
        self.request(&format!("GET {path}"), &[("Host", &self.host()), ("X-Etalon-Token", &self.token)], b"")
    }

    fn post(&self, path: &str, body: &[u8]) -> Answer {
        let length = body.len().to_string();
        let fields = [("Host", &*self.host()), ("X-Etalon-Token", &self.token), ("Content-Length", &length)];
        self.request(&format!("POST {path}"), &fields, body)
    }

    fn post_json(&self, path: &str, body: &Value) -> Answer {
        self.post(path, body.to_string().as_bytes())
    }

    fn state(&self) -> Value {
        let answer = self.get("/api/state");
        assert_eq!(answer.status, 200, "{answer:?}");
        answer.json()
    }

    /// Events from now on.
    fn events(&self) -> Events {
        let mut stream = self.connect();
        write!(stream, "GET /api/events?token={} HTTP/1.1\r\nHost: {}\r\n\r\n", self.token, self.host()).unwrap();
        let mut lines = BufReader::new(stream);
        let mut line = String::new();
        while lines.read_line(&mut line).unwrap() > 0 && line != "\r\n" {
            assert!(!line.starts_with("HTTP/1.1 ") || line.contains(" 200 "), "{line}");
            line.clear();
        }
        Events(lines)
    }
}

/// Stream of events.
struct Events(BufReader<TcpStream>);

impl Events {
    /// Data of the next event of this name that is as wanted.
    fn next(&mut self, name: &str, wanted: impl Fn(&Value) -> bool) -> Value {
        let (begun, mut line, mut event) = (Instant::now(), String::new(), String::new());
        loop {
            line.clear();
            assert!(self.0.read_line(&mut line).unwrap() > 0 && begun.elapsed() < PATIENCE, "no event `{name}`");
            if let Some(name) = line.strip_prefix("event: ") {
                event = name.trim().to_owned();
            } else if let Some(data) = line.strip_prefix("data: ").filter(|_| event == name) {
                let data: Value = serde_json::from_str(data).unwrap();
                if wanted(&data) {
                    return data;
                }
            }
        }
    }
}

fn samples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("samples")
}

#[test]
fn the_page_is_for_its_own_user_alone() {
    let folder = tempfile::tempdir().unwrap();
    let page = Page::open(&[], folder.path());
    let (host, token) = (page.host(), page.token.clone());
    let shown = page.request(&format!("GET /?token={token}"), &[("Host", &host)], b"");
    assert_eq!(shown.status, 200);
    let policy = shown.head.lines().find(|line| line.starts_with("Content-Security-Policy: ")).unwrap();
    let nonce = policy.split("script-src 'nonce-").nth(1).unwrap().split('\'').next().unwrap();
    assert!(policy.contains("default-src 'none'") && policy.contains("frame-ancestors 'none'"), "{policy}");
    assert!(String::from_utf8_lossy(&shown.body).contains(nonce));
    // the nonce is another one each time
    assert!(!page.request(&format!("GET /?token={token}"), &[("Host", &host)], b"").head.contains(nonce));
    assert_eq!(page.get("/api/state").json()["mode"], "empty");

    let refused = |line: &str, fields: &[(&str, &str)], status: u16, id: &str| {
        let answer = page.request(line, fields, b"");
        assert_eq!((answer.status, answer.ids()), (status, vec![id.to_owned()]), "{line} {fields:?}");
    };
    let with = |value: &str| format!("GET /?token={value}");
    // a person reads why: these answers are texts
    for line in ["GET /", &with(&"0".repeat(32)), &with(&token[..31])] {
        let answer = page.request(line, &[("Host", &host)], b"");
        let text = String::from_utf8(answer.body).unwrap();
        assert_eq!((answer.status, text.contains("[view-token-missing]")), (403, true), "{line}: {text}");
        assert!(answer.head.contains("text/plain") && !text.contains(&token), "{line}");
    }
    refused("GET /api/state", &[("Host", &host), ("X-Etalon-Token", "")], 403, "view-token-missing");
    // a form of another page has no fields of its own
    refused(&format!("POST /api/run?token={token}"), &[("Host", &host)], 403, "view-token-missing");
    let own = [("X-Etalon-Token", token.as_str())];
    // another name of 127.0.0.1: DNS rebinding
    for other in ["evil.example", "127.0.0.1", "127.0.0.1:1", "127.0.0.1.evil.example:80", ""] {
        refused("GET /api/state", &[own[0], ("Host", other)], 421, "view-other-host");
    }
    refused("GET /api/state", &own, 421, "view-other-host");
    for other in ["https://evil.example", "null", &format!("https://{host}"), "http://127.0.0.1:1"] {
        refused("GET /api/state", &[own[0], ("Host", &host), ("Origin", other)], 403, "view-other-origin");
    }
    let origin = format!("http://localhost:{}", page.port);
    let allowed = page.request("GET /api/state", &[own[0], ("Host", &host), ("Origin", &origin)], b"");
    assert_eq!(allowed.status, 200);
    let twice = [own[0], ("Host", &host), ("Host", "evil.example")];
    refused("GET /api/state", &twice, 400, "view-request-malformed");
    refused("GET /favicon.ico", &[own[0], ("Host", &host)], 404, "view-request-unknown");
    refused("GET /../../etc/passwd", &[own[0], ("Host", &host)], 404, "view-request-unknown");
    for name in ["..%2Fcampaign.toml", "%2Fetc%2Fpasswd", "campaign.toml", ""] {
        refused(&format!("GET /api/download?name={name}"), &[own[0], ("Host", &host)], 404, "view-download-unknown");
    }
}

#[test]
fn hostile_uploads_are_refused_and_nothing_is_overwritten() {
    let root = tempfile::tempdir().unwrap();
    let folder = root.path().join("campaign");
    std::fs::create_dir(&folder).unwrap();
    std::fs::write(folder.join("notes.txt"), "mine").unwrap();
    let page = Page::open(&["campaign"], root.path());
    for name in [
        "..%2Fx.csv",
        "a%2Fb.csv",
        "a%5Cb.csv",
        "%2e%2e",
        "",
        "%3Cimg%20src%3Dx%20onerror%3Dalert(1)%3E",
        "nul.csv",
        "a%00b",
    ] {
        let answer = page.post(&format!("/api/files?name={name}"), b"1,2,3\n");
        assert_eq!((answer.status, answer.ids()), (400, vec!["view-file-name".to_owned()]), "{name}");
    }
    let stored = page.post("/api/files?name=a%20%26%20b.csv", b"1,2,3\n");
    assert_eq!((stored.status, &stored.json()["mode"]), (200, &json!("proposed")));
    assert_eq!(std::fs::read(folder.join("a & b.csv")).unwrap(), b"1,2,3\n");
    for name in ["a%20%26%20b.csv", "notes.txt"] {
        let again = page.post(&format!("/api/files?name={name}"), b"other");
        assert_eq!((again.status, again.ids()), (400, vec!["view-file-exists".to_owned()]));
    }
    let own = [("Host", page.host()), ("X-Etalon-Token", page.token.clone())];
    let own: Vec<(&str, &str)> = own.iter().map(|(name, value)| (*name, value.as_str())).collect();
    let removed = page.request("DELETE /api/files?name=notes.txt", &own, b"");
    assert_eq!((removed.status, removed.ids()), (400, vec!["view-file-not-dropped".to_owned()]));
    assert_eq!(std::fs::read(folder.join("notes.txt")).unwrap(), b"mine");
    assert_eq!(page.request("DELETE /api/files?name=a%20%26%20b.csv", &own, b"").status, 200);
    assert!(!folder.join("a & b.csv").exists() && root.path().read_dir().unwrap().count() == 1);

    let sized = |length: &'static str| [&own[..], &[("Content-Length", length)]].concat();
    let post = "POST /api/files?name=c.csv";
    let answer = page.request(post, &sized("999999999999999999999999"), b"");
    assert_eq!((answer.status, answer.ids()), (413, vec!["view-request-too-large".to_owned()]));
    let answer = page.request(post, &sized("-1"), b"");
    assert_eq!((answer.status, answer.ids()), (400, vec!["view-request-malformed".to_owned()]));
    let chunked = [&own[..], &[("Transfer-Encoding", "chunked")]].concat();
    let answer = page.request(post, &chunked, b"5\r\nhello\r\n0\r\n\r\n");
    assert_eq!((answer.status, answer.ids()), (411, vec!["view-request-without-length".to_owned()]));
    assert!(!folder.join("c.csv").exists());
    // half a head, then silence
    let answer = page.send(b"GET /api/state HTTP/1.1\r\nHost:");
    assert_eq!((answer.status, answer.ids()), (408, vec!["view-request-slow".to_owned()]));
    assert_eq!(page.send(&[b'a'; 100_000]).status, 431);
    assert_eq!(page.send(b"GET / HTTP/1.0\r\n\r\n").status, 400);
    let huge = format!("GET /api/state HTTP/1.1\r\nX: {}\r\n\r\n", "a".repeat(100_000));
    assert_eq!(page.send(huge.as_bytes()).status, 431);
    for (path, body) in [("/api/whatif", "[1"), ("/api/keep", "{}"), ("/api/whatif", "{\"unknown\":1}")] {
        let answer = page.post(path, body.as_bytes());
        assert_eq!((answer.status, answer.ids()), (400, vec!["view-request-malformed".to_owned()]), "{path} {body}");
    }
    for (path, id) in [("/api/run", "view-without-campaign"), ("/api/whatif", "view-not-identified")] {
        let answer = page.post(path, b"{}");
        assert_eq!((answer.status, answer.ids()), (400, vec![id.to_owned()]));
    }
    assert_eq!(page.post("/api/check", b"").ids(), ["view-without-campaign"]);
    assert_eq!(page.post("/api/accept", b"{}").status, 400);
}

#[test]
fn a_thousand_connections_leave_the_server_alive() {
    let folder = tempfile::tempdir().unwrap();
    let page = Page::open(&[], folder.path());
    let mut idle = Vec::new();
    let mut refused = 0;
    for _ in 0..1000 {
        // what the system does not permit is not held
        match TcpStream::connect(("127.0.0.1", page.port)) {
            Ok(stream) => idle.push(stream),
            Err(_) => idle.truncate(idle.len() / 2),
        }
    }
    // the refusals arrive; a connection that was accepted answers nothing yet
    std::thread::sleep(Duration::from_millis(500));
    for stream in &mut idle {
        stream.set_nonblocking(true).unwrap();
        let mut begun = [0; 12];
        refused += usize::from(stream.read_exact(&mut begun).is_ok() && begun == *b"HTTP/1.1 503");
    }
    assert!(refused > 10, "connections beyond the bound are refused at once: `view-busy`");
    drop(idle);
    let begun = Instant::now();
    // the connections that were answered end after their time for a head
    while begun.elapsed() < PATIENCE {
        let answer = page.get("/api/state");
        if answer.status == 200 {
            return;
        }
        assert_eq!((answer.status, answer.ids()), (503, vec!["view-busy".to_owned()]));
        std::thread::sleep(Duration::from_millis(200));
    }
    panic!("the server answers no more");
}

#[test]
fn a_port_that_is_in_use_and_an_empty_folder_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    let taken = std::net::TcpListener::bind(("127.0.0.1", 0)).unwrap();
    let port = taken.local_addr().unwrap().port().to_string();
    let view = |arguments: &[&str]| super::etalon(folder.path(), &[&["view"], arguments].concat());
    let ended = view(&["--no-open", "--port", &port]);
    assert_eq!(ended.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&ended.stderr).contains("[view-port-unavailable]"));
    let ended = view(&["--export", "page.html"]);
    assert_eq!(ended.status.code(), Some(2));
    assert!(!folder.path().join("page.html").exists());
}

#[test]
fn without_a_browser_the_address_is_printed() {
    let folder = tempfile::tempdir().unwrap();
    let mut child = Command::new(crate::support::program())
        .arg("view")
        .env("PATH", "")
        .current_dir(folder.path())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let lines = BufReader::new(child.stderr.take().unwrap()).lines().map_while(Result::ok);
    let found = lines.take(20).any(|line| line.contains("[view-browser-not-opened]"));
    let _ = child.kill();
    let _ = child.wait();
    assert!(found);
}

/// `true` if all numbers of a document are there: what is not finite is written as null.
fn is_whole(value: &Value) -> bool {
    match value {
        Value::Null => false,
        Value::Array(all) => all.iter().all(is_whole),
        Value::Object(all) => all.values().all(is_whole),
        _ => true,
    }
}

/// Samples of every model: chains, a rail, screws, platforms, two branches, a turntable.
const MODELS: [&str; 12] = [
    "column-arm",
    "rail-arm",
    "probe-poses",
    "two-hands",
    "two-arms",
    "turntable",
    "prexyt-cmm",
    "dextar",
    "hexapod",
    "delta",
    "linear-delta",
    "draw-wire",
];

#[test]
fn every_model_is_drawn_at_its_measured_poses() {
    for name in MODELS {
        let state = serde_json::to_value(Session::open(&samples().join(name)).state()).unwrap();
        assert_eq!(state["mode"], "campaign", "{name}");
        assert!(is_whole(&state), "{name}: a key is null");
        let scene = &state["scene"];
        assert!(scene.is_object(), "{name}: {}", state["messages"]);
        let poses = scene["poses"].as_array().unwrap();
        let (joints, bodies) = (scene["joints"].as_array().unwrap().len(), scene["bodies"].as_array().unwrap().len());
        assert!(poses.len() > 5 && joints > 1 && bodies > 1, "{name}");
        for pose in poses {
            assert_eq!(pose["joints"].as_array().unwrap().len(), joints, "{name}");
            let strokes = pose["strokes"].as_array().unwrap();
            assert!(strokes.iter().any(|stroke| stroke["kind"] == "link"), "{name} {}", pose["id"]);
            assert!(strokes.iter().all(|stroke| (stroke["body"].as_u64().unwrap() as usize) < bodies), "{name}");
        }
        let points = scene["points"].as_array().unwrap();
        assert!(!points.is_empty(), "{name}");
        for point in points.iter().filter(|point| point["kind"] == "position") {
            // the drawing ends at the target: the error is all that lies between
            let strokes = poses[point["pose"].as_u64().unwrap() as usize]["strokes"].as_array().unwrap();
            let ends = strokes.iter().flat_map(|stroke| stroke["points"].as_array().unwrap());
            let far = |end: &Value| {
                let by = |i: usize| {
                    point["measured"][i].as_f64().unwrap()
                        - point["after"][i].as_f64().unwrap() / 1000.0
                        - end[i].as_f64().unwrap()
                };
                (0..3).map(|i| by(i).powi(2)).sum::<f64>().sqrt()
            };
            let nearest = ends.map(far).fold(f64::INFINITY, f64::min);
            assert!(nearest < 0.002, "{name}: {nearest} mm beside the computed place of {point}");
        }
    }
}

fn ask(opened: &Session, asked: &Value) -> Value {
    let asked: WhatIfAsked = serde_json::from_value(asked.clone()).unwrap();
    serde_json::to_value(opened.what_if(&asked).unwrap()).unwrap()
}

/// Parameters of a run by name: value, and standard uncertainty if identified.
fn run(folder: &Path) -> (Vec<(String, f64, Option<f64>)>, f64) {
    let outcome = documents_of(&Campaign::read(folder).unwrap()).unwrap();
    let identified = outcome.results.identified.unwrap();
    let parameters = identified.parameters.parameters.iter();
    let parameters = parameters.map(|p| (p.name.clone(), p.value, p.standard_uncertainty)).collect();
    let set = identified.accuracy.sets.last().unwrap();
    let position = set.errors.iter().find(|e| serde_json::to_value(e.quantity).unwrap() == "position").unwrap();
    (parameters, 1000.0 * position.after.max)
}

fn assert_same(shown: &Value, maximum_um: f64, folder: &Path, name: &str) {
    let (expected, largest_um) = run(folder);
    let shown = shown.as_array().unwrap();
    assert_eq!(shown.len(), expected.len(), "{name}");
    for (shown, (parameter, value, u)) in shown.iter().zip(&expected) {
        assert_eq!(shown["name"], *parameter, "{name}");
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b.abs().max(1.0);
        assert!(near(shown["identified"].as_f64().unwrap(), *value), "{name}: {shown} {value}");
        if let (Some(shown_u), Some(u)) = (shown["uncertainty"].as_f64(), u) {
            assert!(near(shown_u, *u), "{name}: {shown} {u}");
        }
    }
    assert!((maximum_um - largest_um).abs() < 1e-6 * largest_um, "{name}: {maximum_um} {largest_um}");
}

/// The same numbers as `etalon run` of the campaign that is written, whatever is left out, held or freed.
#[test]
fn what_if_is_a_run_of_the_campaign_that_it_writes() {
    let cases = [
        ("prexyt-cmm", json!({"leave_out_poses": ["3/1", "3/2", "12/4"], "limit_um": 30.0})),
        ("hexapod", json!({"leave_out_targets": ["SMR_2"], "leave_out_poses": ["7", "31"]})),
        ("rail-arm", json!({"hold": ["d_3"]})),
        ("hexapod", json!({"calibration": "1-25, 31-35", "validation": "36-60"})),
    ];
    for (name, asked) in cases {
        let scratch = copy_sample(name);
        let session = Session::open(&scratch.path());
        let first = serde_json::to_value(session.state()).unwrap();
        let mut asked = asked;
        if let Some(hold) = asked.get_mut("hold").and_then(Value::as_array_mut) {
            // a parameter of the robot that is identified
            let own = first["parameters"].as_array().unwrap().iter().rev().find(|p| p["held"] == false).unwrap();
            *hold = vec![own["name"].clone()];
        }
        let shown = ask(&session, &asked);
        assert!(is_whole(&shown), "{name}");
        let before = std::fs::read_to_string(scratch.path().join("campaign.toml")).unwrap();
        let wanted: WhatIfAsked = serde_json::from_value(asked.clone()).unwrap();
        let reason = "the \"nest\" was dirty \\ wiped";
        let difference = session.keep(&wanted, reason).unwrap();
        let after = std::fs::read_to_string(scratch.path().join("campaign.toml")).unwrap();
        assert!(before != after && difference.lines().any(|line| line.starts_with('+')), "{name}: {difference}");
        assert_same(&shown["parameters"], shown["maximum_um"]["now"].as_f64().unwrap(), &scratch.path(), name);
        // what is kept is what the page shows
        let state = serde_json::to_value(session.state()).unwrap();
        assert_eq!(state["parameters"], shown["parameters"], "{name}");
        // and freed again it is the first result
        if asked.get("hold").is_some() {
            let back = ask(&session, &json!({"free": asked["hold"]}));
            assert_eq!(back["parameters"], first["parameters"], "{name}");
        }
        if asked.get("leave_out_poses").is_some() {
            assert!(after.contains("nest") && Campaign::read(&scratch.path()).is_ok(), "{name}: {after}");
        }
    }
}

#[test]
fn a_change_needs_a_reason_and_a_name_that_exists() {
    let scratch = copy_sample("hexapod");
    let page = Page::open(&["."], &scratch.path());
    let text = || std::fs::read_to_string(scratch.path().join("campaign.toml")).unwrap();
    let before = text();
    let refused = |path: &str, body: Value, id: &str| {
        let answer = page.post_json(path, &body);
        assert_eq!((answer.status, answer.ids()), (400, vec![id.to_owned()]), "{body}");
    };
    refused("/api/whatif", json!({"leave_out_poses": ["9999"]}), "view-pose-unknown");
    refused("/api/whatif", json!({"leave_out_targets": ["<b>"]}), "not-of-this-robot");
    refused("/api/whatif", json!({"hold": ["delta_99"]}), "parameter-unknown");
    refused("/api/whatif", json!({"free": ["leg1_l0"]}), "view-parameter-stays-held");
    refused("/api/keep", json!({"asked": {"leave_out_poses": ["3"]}, "reason": " \n"}), "view-reason-missing");
    refused("/api/keep", json!({"asked": {}, "reason": "why not"}), "view-nothing-asked");
    let all: Vec<String> = (1..=60).map(|pose| pose.to_string()).collect();
    let answer = page.post_json("/api/whatif", &json!({"leave_out_poses": all}));
    assert_eq!(answer.status, 400, "nothing is left: {:?}", answer.ids());
    assert_eq!(text(), before);
    let kept =
        page.post_json("/api/keep", &json!({"asked": {"leave_out_poses": ["3"]}, "reason": "touched the cable"}));
    assert_eq!(kept.status, 200, "{:?}", String::from_utf8_lossy(&kept.body));
    assert!(text().starts_with(&before) && text().contains("touched the cable"));
    let state = page.state();
    let pose = state["scene"]["poses"].as_array().unwrap().iter().find(|pose| pose["id"] == "3").unwrap();
    assert_eq!(pose["set"], "left_out");
}

#[test]
fn a_run_from_the_page_is_the_run_of_the_command() {
    let scratch = copy_sample("dextar");
    let page = Page::open(&["campaign"], scratch.root());
    let mut events = page.events();
    assert_eq!(page.post("/api/run", b"").status, 202);
    let second = page.post("/api/run", b"");
    assert!(second.status == 202 || second.ids() == ["view-run-in-progress"], "{second:?}");
    events.next("progress", |progress| progress["text"].is_string());
    let begun = Instant::now();
    let state = loop {
        events.next("state", |_| true);
        let state = page.state();
        if state["verdict"].is_object() {
            break state;
        }
        assert!(begun.elapsed() < PATIENCE, "{}", state["messages"]);
    };
    let verdict: Value = scratch.document("verdict.json");
    assert_eq!(state["verdict"]["status"], verdict["verdict"]);
    let report = page.get(&format!("/api/download?name=report.html&token={}", page.token));
    assert_eq!(report.body, std::fs::read(scratch.path().join("out/report.html")).unwrap());
    assert!(report.head.contains("Content-Disposition: attachment") && report.head.contains("sandbox"));
    assert_eq!(page.get("/api/download?name=manifest.json").ids(), ["view-download-unknown"]);
    let exported = page.get("/api/export");
    assert!(String::from_utf8_lossy(&exported.body).contains("id=\"state\""));
    drop(page);
    // the stored results are shown at the next start
    let ended = super::etalon(scratch.root(), &["view", "campaign", "--export", "page.html"]);
    assert_eq!(ended.status.code(), Some(0), "{}", String::from_utf8_lossy(&ended.stderr));
    let written = std::fs::read_to_string(scratch.root().join("page.html")).unwrap();
    let (_, json) = written.split_once("id=\"state\"").unwrap();
    let json = &json[json.find('>').unwrap() + 1..json.find("</script>").unwrap()];
    let read: Value = serde_json::from_str(json).unwrap();
    assert_eq!(read["verdict"], state["verdict"]);
    assert_eq!(read["scene"], state["scene"]);
    let over = super::etalon(scratch.root(), &["view", "campaign", "--export", "campaign/robot.toml"]);
    assert_eq!(over.status.code(), Some(2), "an input is not overwritten");
}

/// Export and log of the hexapod, without its campaign.
fn measured() -> (Scratch, [String; 2]) {
    let scratch = copy_sample("hexapod");
    let read = |name: &str| std::fs::read_to_string(scratch.path().join(name)).unwrap();
    let files = [read("exports/poses.txt"), read("encoders.csv")];
    (scratch, files)
}

#[test]
fn dropped_files_become_the_campaign_that_init_proposes() {
    let scratch = copy_sample("prexyt-cmm");
    let read = |name: &str| std::fs::read_to_string(scratch.path().join(name)).unwrap();
    let [export, log] = [read("exports/poses.txt"), read("encoders.csv")];
    let folder = tempfile::tempdir().unwrap();
    let page = Page::open(&[], folder.path());
    assert_eq!(page.post("/api/propose", b"{}").ids(), ["view-nothing-dropped"]);
    let robot = std::fs::read_to_string(scratch.path().join("robot.toml")).unwrap();
    for (name, text) in [("poses.txt", &export), ("encoders.csv", &log), ("robot.toml", &robot)] {
        assert_eq!(page.post(&format!("/api/files?name={name}"), text.as_bytes()).status, 200);
    }
    let proposed = page.post("/api/propose", b"{}");
    assert_eq!(proposed.status, 200, "{}", String::from_utf8_lossy(&proposed.body));
    let proposal = proposed.json();
    assert_eq!((&proposal["robot"], proposal["files"].as_array().unwrap().len()), (&json!("robot.toml"), 2));
    let encoders = proposal["files"].as_array().unwrap().iter().find(|file| file["name"] == "encoders.csv").unwrap();
    assert_eq!(encoders["columns"].as_array().unwrap().len(), encoders["rows"][0].as_array().unwrap().len());
    assert!(encoders["columns"][0]["taken_for"].is_string());
    // a robot outside the folder is not read
    let outside = page.post_json("/api/propose", &json!({"robot": scratch.path().join("robot.toml")}));
    assert_eq!(outside.ids(), ["robot-not-in-table"]);
    assert_eq!(page.post("/api/accept", b"{}").status, 400, "questions are open");
    let mut answers = serde_json::Map::new();
    for question in proposal["questions"].as_array().unwrap().iter().filter(|question| question["id"] != "robot") {
        let id = question["id"].as_str().unwrap();
        let answer = match id.rsplit('.').next().unwrap() {
            "name" => "Tracker",
            "expanded_uncertainty_um" => "20",
            "unit" | "UNIT" => "mm",
            "as_exported" => "true",
            _ => panic!("{question}"),
        };
        answers.insert(id.to_owned(), json!(answer));
    }
    let asked = json!({"answers": answers});
    let answered = page.post_json("/api/propose", &asked).json();
    assert!(answered["difference"].as_str().unwrap().contains("+expanded_uncertainty_um = 20"), "{answered}");
    let accepted = page.post_json("/api/accept", &asked);
    assert_eq!(accepted.status, 200, "{}", String::from_utf8_lossy(&accepted.body));
    let state = accepted.json();
    assert_eq!(state["mode"], "campaign");
    let messages = state["messages"].as_array().unwrap();
    assert!(
        messages.iter().all(|message| message["id"] != "key-open" && message["id"] != "joint-unit-open"),
        "{messages:?}"
    );
    assert_eq!(page.post_json("/api/accept", &asked).ids(), ["view-campaign-exists"]);
    // the command proposes the same lines
    let name = folder.path().file_name().unwrap().to_str().unwrap();
    let there = tempfile::tempdir().unwrap();
    let from = |file: &str| folder.path().join(file).display().to_string();
    let (poses, encoders, robot) = (from("poses.txt"), from("encoders.csv"), from("robot.toml"));
    let arguments = ["init", name, "--from", &encoders, &poses, "--robot", &robot];
    assert_eq!(super::etalon(there.path(), &arguments).status.code(), Some(0));
    let by_command = std::fs::read_to_string(there.path().join(name).join("campaign.toml")).unwrap();
    let by_page = std::fs::read_to_string(folder.path().join("campaign.toml")).unwrap();
    let differing: Vec<&str> =
        by_page.lines().zip(by_command.lines()).filter(|(a, b)| a != b).map(|(_, command)| command).collect();
    assert_eq!(by_page.lines().count(), by_command.lines().count());
    assert!(differing.iter().all(|line| line.contains("\"?\"") || line.contains("_UNIT")), "{differing:?}");
}

/// The hexapod's files with the first poses alone, and the rest of their lines by pose.
fn begun(poses: usize) -> (Scratch, Vec<[String; 2]>) {
    let (scratch, [export, log]) = measured();
    let is_of =
        |line: &str, pose: usize| line.split(',').next().is_some_and(|label| label.contains(&format!("_{pose}_")));
    let later: Vec<[String; 2]> = (poses + 1..=60)
        .map(|pose| {
            let points = export.lines().filter(|line| is_of(line, pose)).map(|line| format!("{line}\n")).collect();
            let logged =
                log.lines().filter(|line| line.ends_with(&format!(",{pose}"))).map(|l| format!("{l}\n")).collect();
            [points, logged]
        })
        .collect();
    assert!(later.iter().all(|[points, logged]| points.lines().count() == 3 && logged.lines().count() == 1));
    let without = |text: &str, at: usize| -> String {
        let later: std::collections::BTreeSet<&str> = later.iter().flat_map(|lines| lines[at].lines()).collect();
        text.lines().filter(|line| !later.contains(line)).map(|line| format!("{line}\n")).collect()
    };
    std::fs::write(scratch.path().join("exports/poses.txt"), without(&export, 0)).unwrap();
    std::fs::write(scratch.path().join("encoders.csv"), without(&log, 1)).unwrap();
    scratch.replace("campaign.toml", "calibration = \"1-40\"", "calibration = \"all\"");
    scratch.replace("campaign.toml", "validation = \"41-60\"\n", "");
    (scratch, later)
}

fn append(scratch: &Scratch, file: &str, text: &str) {
    let mut file = std::fs::OpenOptions::new().append(true).open(scratch.path().join(file)).unwrap();
    file.write_all(text.as_bytes()).unwrap();
}

#[test]
fn a_measurement_is_followed_pose_by_pose() {
    let (scratch, later) = begun(20);
    let plan: String = std::iter::once("pose,leg1_mm,leg2_mm,leg3_mm,leg4_mm,leg5_mm,leg6_mm\n".to_owned())
        .chain((21..=30).map(|pose: usize| {
            let cells: Vec<&str> = later[pose - 21][1].trim().split(',').collect();
            format!("{pose},{}\n", cells[1..7].join(","))
        }))
        .collect();
    std::fs::write(scratch.root().join("plan.csv"), plan).unwrap();
    let page = Page::open(&["campaign", "--watch", "--plan", "plan.csv"], scratch.root());
    let mut events = page.events();
    let first = events.next("watch", |_| true);
    assert_eq!((&first["received"], &first["planned"], &first["next"]["pose"]), (&json!(20), &json!(10), &json!("21")));
    let u = |watch: &Value, key: &str| -> f64 {
        watch["parameters"].as_array().unwrap().iter().map(|p| p[key].as_f64().unwrap()).sum()
    };
    assert!(u(&first, "u_end") < u(&first, "u_now"));

    // a good pose: the log comes a moment later than the export
    append(&scratch, "exports/poses.txt", &later[0][0]);
    std::thread::sleep(Duration::from_millis(100));
    append(&scratch, "encoders.csv", &later[0][1]);
    let good = events.next("watch", |watch| watch["received"] == 21);
    assert_eq!((&good["tone"], &good["latest"]["agrees"]), (&json!("good"), &json!(true)), "{good}");
    assert_eq!((&good["latest"]["pose"], &good["next"]["pose"]), (&json!("21"), &json!("22")));

    // two labels exchanged
    let exchanged = later[1][0].replace("SMR_1", "SMR_x").replace("SMR_2", "SMR_1").replace("SMR_x", "SMR_2");
    append(&scratch, "encoders.csv", &later[1][1]);
    append(&scratch, "exports/poses.txt", &exchanged);
    let bad = events.next("watch", |watch| watch["latest"]["pose"] == "22");
    assert_eq!(
        (&bad["tone"], &bad["latest"]["message"]["id"]),
        (&json!("bad"), &json!("watch-labels-exchanged")),
        "{bad}"
    );
    let mend = |wrong: &str, right: &str| {
        let path = scratch.path().join("exports/poses.txt");
        std::fs::write(&path, std::fs::read_to_string(&path).unwrap().replace(wrong, right)).unwrap();
    };
    mend(&exchanged, &later[1][0]);
    let again = events.next("watch", |watch| watch["latest"]["pose"] == "22" && watch["tone"] == "good");
    assert_eq!(again["latest"]["agrees"], true);

    // the robot moved on after the tracker measured pose 22 once more: pose 23 has its points
    let again = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        let x: f64 = cells[1].parse().unwrap();
        format!("{},{:.6},{},{}\n", cells[0].replace("_22_", "_23_"), x + 0.004, cells[2], cells[3])
    };
    let moved: String = later[1][0].lines().map(again).collect();
    append(&scratch, "encoders.csv", &later[2][1]);
    append(&scratch, "exports/poses.txt", &moved);
    let other = events.next("watch", |watch| watch["latest"]["pose"] == "23");
    assert_eq!(other["latest"]["message"]["id"], "watch-joints-of-other-pose", "{other}");
    mend(&moved, &later[2][0]);
    events.next("watch", |watch| watch["latest"]["pose"] == "23" && watch["tone"] == "good");

    // joint values that no row explains
    let joints = later[1][1].trim().rsplit_once(',').unwrap().0;
    let wrong = format!("{joints},24\n");
    append(&scratch, "encoders.csv", &wrong);
    append(&scratch, "exports/poses.txt", &later[3][0]);
    let late = events.next("watch", |watch| watch["latest"]["pose"] == "24");
    assert_eq!((&late["tone"], &late["latest"]["agrees"]), (&json!("bad"), &json!(false)), "{late}");
    assert_eq!(late["latest"]["message"]["id"], "watch-disagrees");
    let log = std::fs::read_to_string(scratch.path().join("encoders.csv")).unwrap().replace(&wrong, &later[3][1]);
    std::fs::write(scratch.path().join("encoders.csv"), log).unwrap();

    // a target that is not seen
    let unseen: String = later[4][0].lines().take(2).map(|line| format!("{line}\n")).collect();
    append(&scratch, "encoders.csv", &later[4][1]);
    append(&scratch, "exports/poses.txt", &unseen);
    let missing = events.next("watch", |watch| watch["latest"]["pose"] == "25");
    assert_eq!(
        (&missing["tone"], &missing["latest"]["message"]["id"]),
        (&json!("bad"), &json!("watch-target-missing"))
    );
    assert_eq!(page.state()["scene"]["poses"].as_array().unwrap().len(), 25);

    // a file that vanishes is reported, and what was shown stays; when it is back, the page goes on
    let kept = std::fs::read(scratch.path().join("encoders.csv")).unwrap();
    std::fs::remove_file(scratch.path().join("encoders.csv")).unwrap();
    let gone = events.next("watch", |watch| watch["received"] == 0);
    assert_eq!(gone["tone"], "bad");
    assert!(page.state()["scene"].is_object());
    std::fs::write(scratch.path().join("encoders.csv"), &kept[..kept.len() / 2]).unwrap();
    std::thread::sleep(Duration::from_millis(600));
    std::fs::write(scratch.path().join("encoders.csv"), kept).unwrap();
    events.next("watch", |watch| watch["received"] == 25);
}

#[test]
fn of_candidates_the_pose_of_most_information_is_next() {
    let (scratch, later) = begun(20);
    // pose 21 twenty times, and one pose elsewhere: what is measured already tells nothing new
    let near: Vec<&str> = later[0][1].trim().split(',').collect();
    let measured = std::fs::read_to_string(scratch.path().join("encoders.csv")).unwrap();
    let same: Vec<&str> = measured.lines().nth(5).unwrap().split(',').collect();
    let row = |pose: usize, cells: &[&str]| format!("{pose},{}\n", cells[1..7].join(","));
    let head = "pose,leg1_mm,leg2_mm,leg3_mm,leg4_mm,leg5_mm,leg6_mm\n";
    let table = head.to_owned() + &row(101, &same) + &row(102, &near) + &row(103, &same);
    std::fs::write(scratch.root().join("candidates.csv"), table).unwrap();
    let page = Page::open(&["campaign", "--watch", "--candidates", "candidates.csv"], scratch.root());
    let watch = page.events().next("watch", |_| true);
    assert_eq!(watch["next"]["pose"], "102", "{watch}");
}

/// Label and pose of a line of the hexapod's export: `SMR_1_12_1,..` is `SMR_1_1,..` of pose 12.
fn without_pose(line: &str) -> (usize, String) {
    let (label, rest) = line.split_once(',').unwrap();
    let [name, target, pose, cycle] = label.split('_').collect::<Vec<_>>()[..] else { panic!("{line}") };
    (pose.parse().unwrap(), format!("{name}_{target}_{cycle},{rest}\n"))
}

#[test]
fn a_folder_with_a_file_for_each_pose_is_followed() {
    let (scratch, [export, log]) = measured();
    let path = |file: &str| scratch.path().join(file);
    let mut poses = std::collections::BTreeMap::<usize, String>::new();
    for (pose, line) in export.lines().map(without_pose) {
        *poses.entry(pose).or_default() += &line;
    }
    let write = |pose: usize| std::fs::write(path(&format!("scans/P{pose}.txt")), &poses[&pose]).unwrap();
    std::fs::create_dir(path("scans")).unwrap();
    std::fs::remove_file(path("exports/poses.txt")).unwrap();
    scratch.replace("campaign.toml", "exports/poses.txt", "scans/P{pose}.txt");
    scratch.replace("campaign.toml", "label = \"{target}_{pose}_{cycle}\"", "label = \"{target}_{cycle}\"");
    scratch.replace("campaign.toml", "calibration = \"1-40\"", "calibration = \"all\"");
    scratch.replace("campaign.toml", "validation = \"41-60\"\n", "");
    let head = log.lines().next().unwrap();
    let logged = |poses: usize| -> String {
        std::iter::once(head).chain(log.lines().skip(1).take(poses)).map(|line| format!("{line}\n")).collect()
    };
    std::fs::write(path("encoders.csv"), logged(20)).unwrap();
    // nothing is measured yet
    let page = Page::open(&["campaign", "--watch"], scratch.root());
    let mut events = page.events();
    let first = events.next("watch", |_| true);
    assert_eq!((&first["received"], &first["tone"]), (&json!(0), &json!("wait")), "{first}");
    assert!(page.state()["messages"].as_array().unwrap().iter().any(|m| m["id"] == "export-files-missing"));
    (1..=20).for_each(write);
    events.next("watch", |watch| watch["received"] == 20);

    // the instrument writes a file row by row, and another program leaves one of its own
    std::fs::write(path("scans/P21.txt.part"), "not yet").unwrap();
    let rows: Vec<&str> = poses[&21].lines().collect();
    for count in 1..=rows.len() {
        std::fs::write(path("scans/P21.txt"), rows[..count].join("\n") + "\n").unwrap();
        std::thread::sleep(Duration::from_millis(60));
    }
    std::fs::write(path("encoders.csv"), logged(21)).unwrap();
    let good = events.next("watch", |watch| watch["received"] == 21);
    assert_eq!((&good["latest"]["pose"], &good["latest"]["agrees"]), (&json!("21"), &json!(true)), "{good}");

    // a file that vanishes takes its pose with it, and the page says so
    std::fs::remove_file(path("scans/P7.txt")).unwrap();
    let gone = events.next("watch", |watch| watch["received"] == 20);
    assert_eq!((&gone["tone"], &gone["latest"]["pose"]), (&json!("bad"), &json!("7")), "{gone}");
    assert_eq!(gone["latest"]["message"]["id"], "watch-poses-gone");
    write(7);
    let back = events.next("watch", |watch| watch["received"] == 21);
    assert_eq!((&back["tone"], &back["latest"]["pose"]), (&json!("good"), &json!("7")), "{back}");

    // a file that is emptied is reported, and what was shown stays until it is whole again
    std::fs::write(path("scans/P21.txt"), "").unwrap();
    let emptied = events.next("watch", |watch| watch["tone"] == "bad");
    assert_eq!(emptied["latest"]["message"]["id"], "export-empty", "{emptied}");
    assert_eq!(page.state()["scene"]["poses"].as_array().unwrap().len(), 21);
    write(21);
    events.next("watch", |watch| watch["received"] == 21 && watch["tone"] == "good");
    drop(page);
    // a run reads the same files
    std::fs::remove_file(path("scans/P21.txt.part")).unwrap();
    std::fs::write(path("encoders.csv"), log).unwrap();
    (1..=60).for_each(write);
    let (parameters, _) = run(&scratch.path());
    let whole = copy_sample("hexapod");
    whole.replace("campaign.toml", "calibration = \"1-40\"", "calibration = \"all\"");
    whole.replace("campaign.toml", "validation = \"41-60\"\n", "");
    assert_eq!(parameters, run(&whole.path()).0);
}

/// A solid of one triangle at the origin of its link (m).
const TRIANGLE: &str = "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0.2 0 0\nvertex 0 0.1 0\nendloop\n\
    endfacet\nendsolid t\n";

#[test]
fn meshes_of_a_urdf_are_drawn_where_its_links_are() {
    let scratch = copy_sample("column-arm");
    let visual = |file: &str, place: &str| {
        format!("<visual><origin {place}/><geometry><mesh filename=\"{file}\"/></geometry></visual>")
    };
    std::fs::create_dir_all(scratch.path().join("arm_description/meshes")).unwrap();
    std::fs::write(scratch.path().join("arm_description/meshes/tool.stl"), TRIANGLE).unwrap();
    std::fs::write(scratch.path().join("base.obj"), "v 0 0 0\nv 0 1 0\nv 0 0 0.5\nf 1 2 3\n").unwrap();
    // one beside the campaign, and one that is no mesh
    std::fs::write(scratch.root().join("outside.stl"), TRIANGLE).unwrap();
    std::fs::write(scratch.path().join("broken.stl"), "solid nothing").unwrap();
    let urdf = std::fs::read_to_string(scratch.path().join("arm.urdf")).unwrap();
    let within = |urdf: &str, link: &str, visual: &str| {
        let head = format!("<link name=\"{link}\"");
        let at = urdf.find(&head).unwrap_or_else(|| panic!("no link {link}"));
        let end = at + urdf[at..].find('>').unwrap();
        match urdf[..end].ends_with('/') {
            true => format!("{}>{visual}</link>{}", &urdf[..end - 1], &urdf[end + 1..]),
            false => format!("{}>{visual}{}", &urdf[..end], &urdf[end + 1..]),
        }
    };
    let tool = visual("package://arm_description/meshes/tool.stl", "xyz=\"0 0 0\"");
    let base = visual("base.obj", "xyz=\"0.3 0 0\"") + &visual("../outside.stl", "") + &visual("broken.stl", "");
    let urdf = within(&within(&urdf, "tool", &tool), "base_link", &base);
    std::fs::write(scratch.path().join("arm.urdf"), urdf).unwrap();
    let page = Page::open(&["campaign"], scratch.root());
    let state = page.state();
    assert!(is_whole(&state) && state.get("meshes").is_none());
    let scene = &state["scene"];
    let parts: Vec<&str> = scene["parts"].as_array().unwrap().iter().map(|part| part.as_str().unwrap()).collect();
    assert_eq!((parts.len(), parts[0]), (2, "base"), "{parts:?}");
    let meshes = page.get("/api/meshes").json();
    let numbers = |text: &Value| -> Vec<u16> {
        let bytes = base64::Engine::decode(&base64::engine::general_purpose::STANDARD, text.as_str().unwrap()).unwrap();
        bytes.chunks_exact(2).map(|two| u16::from_le_bytes([two[0], two[1]])).collect()
    };
    // corners (mm) of a part's triangles in the world at a pose
    let corners = |part: usize, pose: &Value| -> Vec<[f64; 3]> {
        let (mesh, frame) = (&meshes[part], pose["parts"][part].as_array().unwrap());
        assert_eq!(mesh["part"], parts[part]);
        assert_eq!(numbers(&mesh["triangles"]), [0, 1, 2]);
        let size = mesh["size"].as_f64().unwrap() / 65_535.0;
        let point = |p: &[u16]| {
            let own = [0, 1, 2].map(|i| mesh["low"][i].as_f64().unwrap() + f64::from(p[i]) * size);
            let row =
                |i: usize| (0..4).map(|k| frame[4 * i + k].as_f64().unwrap() * if k < 3 { own[k] } else { 1.0 }).sum();
            [row(0), row(1), row(2)]
        };
        numbers(&mesh["points"]).chunks_exact(3).map(point).collect()
    };
    let far = |a: [f64; 3], b: [f64; 3]| (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt();
    // a point of a frame, whose 16 numbers are row by row
    let moved = |frame: &Value, p: [f64; 3]| {
        [0, 1, 2].map(|i| {
            (0..3).map(|k| frame[4 * i + k].as_f64().unwrap() * p[k]).sum::<f64>() + frame[4 * i + 3].as_f64().unwrap()
        })
    };
    let frames = scene["frames"].as_array().unwrap();
    let base = &frames.iter().find(|frame| frame["name"] == "base").unwrap()["pose"];
    for pose in scene["poses"].as_array().unwrap() {
        // the flange of the chain is the frame of its last link
        for (found, own) in corners(1, pose).into_iter().zip([[0.0; 3], [200.0, 0.0, 0.0], [0.0, 100.0, 0.0]]) {
            assert!(far(found, moved(&pose["tool"], own)) < 0.05, "{found:?} {}", pose["id"]);
        }
        for (found, own) in
            corners(0, pose).into_iter().zip([[300.0, 0.0, 0.0], [300.0, 1000.0, 0.0], [300.0, 0.0, 500.0]])
        {
            assert!(far(found, moved(base, own)) < 0.05, "{found:?} {}", pose["id"]);
        }
    }
    let without = page.request("GET /api/meshes", &[("Host", &page.host())], b"");
    assert_eq!(without.ids(), ["view-token-missing"]);
    let exported = page.get("/api/export");
    let text = String::from_utf8(exported.body).unwrap();
    assert!(exported.head.contains("view.html") && text.contains(meshes[1]["points"].as_str().unwrap()));
}

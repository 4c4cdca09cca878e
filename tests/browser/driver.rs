//! Chromium without a window, spoken to over two pipes: JSON messages that end with a zero byte.

use serde_json::{Value, json};
use std::fs::File;
use std::io::{BufRead, BufReader, Write};
use std::os::unix::process::CommandExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// A browser that hangs is ended after this many seconds, and the test fails.
const PATIENCE_S: u32 = 1500;
/// A page that does not do what is waited for in this time fails the test.
const WAIT: Duration = Duration::from_secs(180);

/// One page in one browser.
pub struct Browser {
    child: Child,
    to: File,
    from: BufReader<File>,
    asked: u64,
    session: Option<String>,
    /// Addresses of everything that the page asked for since it was opened.
    pub requests: Vec<String>,
    /// What is loaded, by the name that the browser gave the loading.
    loaded: Vec<Value>,
    _profile: tempfile::TempDir,
}

impl Browser {
    /// Whether there is a browser to start.
    pub fn is_there() -> bool {
        Command::new("chromium").arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status().is_ok()
    }

    /// A browser without a page.
    pub fn start() -> Self {
        Self::start_with("--disable-gpu")
    }

    /// A browser that draws in three dimensions by the processor.
    pub fn start_with_space() -> Self {
        Self::start_with("--use-angle=swiftshader --enable-unsafe-swiftshader")
    }

    fn start_with(drawing: &str) -> Self {
        let profile = tempfile::tempdir().unwrap();
        let pipe = |name: &str| {
            let path = profile.path().join(name);
            assert!(Command::new("mkfifo").arg(&path).status().unwrap().success());
            path
        };
        let (to, from) = (pipe("to"), pipe("from"));
        let script = format!(
            "exec timeout {PATIENCE_S} chromium --headless --no-sandbox {drawing} --disable-quic --no-first-run \
             --disable-background-networking --disable-component-update --disable-sync --remote-debugging-pipe \
             --user-data-dir=\"$2\" about:blank 3<\"$0\" 4>\"$1\""
        );
        let child = Command::new("sh")
            .arg("-c")
            .arg(script)
            .args([&to, &from])
            .arg(profile.path().join("profile"))
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .process_group(0)
            .spawn()
            .unwrap();
        // a named pipe opens when both ends do: in the order of the shell
        let to = File::options().write(true).open(to).unwrap();
        let from = BufReader::new(File::open(from).unwrap());
        let mut browser = Self {
            child,
            to,
            from,
            asked: 0,
            session: None,
            requests: Vec::new(),
            loaded: Vec::new(),
            _profile: profile,
        };
        let target = browser.call("Target.createTarget", json!({ "url": "about:blank" }))["targetId"].clone();
        let attached = browser.call("Target.attachToTarget", json!({ "targetId": target, "flatten": true }));
        browser.session = attached["sessionId"].as_str().map(str::to_owned);
        for domain in ["Page.enable", "Network.enable", "Runtime.enable"] {
            browser.call(domain, json!({}));
        }
        browser.call("Page.setLifecycleEventsEnabled", json!({ "enabled": true }));
        browser
    }

    /// Opens a file and waits until it is loaded.
    pub fn open(&mut self, page: &Path) {
        self.open_address(&format!("file://{}", page.display()));
    }

    /// Opens an address and waits until the page is loaded.
    pub fn open_address(&mut self, address: &str) {
        self.requests.clear();
        let navigated = self.call("Page.navigate", json!({ "url": address }));
        assert!(navigated.get("errorText").is_none(), "{address}: {navigated}");
        let loader = navigated["loaderId"].clone();
        while !self.loaded.contains(&loader) {
            self.message();
        }
    }

    /// The width of the window, and its height.
    pub fn size(&mut self, width: u32, height: u32) {
        let metrics = json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": false });
        self.call("Emulation.setDeviceMetricsOverride", metrics);
    }

    /// Shows the page as on another medium. Contents of annexes are laid out with the next frame.
    pub fn media(&mut self, media: &str) {
        self.call("Emulation.setEmulatedMedia", json!({ "media": media }));
        self.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))");
    }

    /// Waits until an expression is true in the page.
    pub fn wait(&mut self, expression: &str) {
        let begun = Instant::now();
        while self.evaluate(&format!("Boolean({expression})")) != true {
            assert!(begun.elapsed() < WAIT, "never true: {expression}");
            std::thread::sleep(Duration::from_millis(100));
        }
    }

    /// Chooses files as a person does in the dialog of a file button.
    pub fn choose_files(&mut self, input: &str, files: &[PathBuf]) {
        let document = self.call("DOM.getDocument", json!({}))["root"]["nodeId"].clone();
        let found = self.call("DOM.querySelector", json!({ "nodeId": document, "selector": input }));
        self.call("DOM.setFileInputFiles", json!({ "nodeId": found["nodeId"], "files": files }));
    }

    /// What an expression comes to in the page.
    pub fn evaluate(&mut self, expression: &str) -> Value {
        let asked = json!({ "expression": expression, "returnByValue": true, "awaitPromise": true });
        let answer = self.call("Runtime.evaluate", asked);
        assert!(answer.get("exceptionDetails").is_none(), "{expression}: {answer}");
        answer["result"]["value"].clone()
    }

    /// Asks for something and waits for its answer.
    pub fn call(&mut self, method: &str, parameters: Value) -> Value {
        self.asked += 1;
        let mut message = json!({ "id": self.asked, "method": method, "params": parameters });
        if let Some(session) = &self.session {
            message["sessionId"] = json!(session);
        }
        self.to.write_all(format!("{message}\0").as_bytes()).unwrap();
        loop {
            let mut answer = self.message();
            if answer["id"] == self.asked {
                assert!(answer.get("error").is_none(), "{method}: {answer}");
                return answer["result"].take();
            }
        }
    }

    /// The next message: an answer, or an event.
    fn message(&mut self) -> Value {
        let mut bytes = Vec::new();
        let count = self.from.read_until(0, &mut bytes).unwrap();
        assert!(count > 0, "the browser went away");
        let message: Value = serde_json::from_slice(&bytes[..count - 1]).unwrap();
        if message["method"] == "Network.requestWillBeSent" {
            self.requests.extend(message["params"]["request"]["url"].as_str().map(str::to_owned));
        }
        if message["method"] == "Page.lifecycleEvent" && message["params"]["name"] == "load" {
            self.loaded.push(message["params"]["loaderId"].clone());
        }
        message
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

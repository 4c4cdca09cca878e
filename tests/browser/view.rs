//! The page of `etalon view` in a browser: exported and opened without the server, and served.

use super::driver::Browser;
use super::pages::{make_hostile, run};
use super::{OVERFLOW, axe, list};
use crate::support::scratch::{Scratch, copy_sample};
use serde_json::json;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

/// A served page, which ends with the test.
struct Served {
    child: Child,
    address: String,
}

impl Served {
    fn start(arguments: &[&str], folder: &Path) -> Self {
        let mut command = Command::new(crate::support::program());
        command.args(["view", "--no-open"]).args(arguments).arg(folder);
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::null()).stdin(Stdio::null()).spawn().unwrap();
        let mut lines = BufReader::new(child.stdout.take().unwrap()).lines().map(Result::unwrap);
        let address = lines.find_map(|line| {
            line.split_whitespace().find(|word| word.starts_with("http://127.0.0.1:")).map(str::to_owned)
        });
        let address = address.expect("an address");
        Self { child, address }
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The page of a campaign as one file.
fn exported(scratch: &Scratch, name: &str) -> PathBuf {
    let page = scratch.root().join(name);
    let mut command = Command::new(crate::support::program());
    let output = command.arg("view").arg(scratch.path()).arg("--export").arg(&page).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    page
}

/// Presses the button of this text.
fn press(browser: &mut Browser, within: &str, text: &str) {
    let button =
        format!("[...document.querySelectorAll('{within} button')].find(b => b.textContent.includes({text:?}))");
    browser.wait(&button);
    browser.evaluate(&format!("{button}.click()"));
}

fn tab(browser: &mut Browser, name: &str) {
    browser.evaluate(&format!("document.getElementById('tab-{name}').click()"));
    // a table sees its width in the next picture
    browser.evaluate("new Promise(next => requestAnimationFrame(() => requestAnimationFrame(() => next(0))))");
}

fn drawn(browser: &mut Browser) -> u64 {
    browser.evaluate("Number(document.querySelector('.stage canvas').dataset.frames)").as_u64().unwrap()
}

/// Pose that table, panel and slider show.
fn selected(browser: &mut Browser) -> [String; 3] {
    let shown = "[document.querySelector('.errors tr.chosen th').textContent, \
        document.querySelector('.selected h2').firstChild.textContent, document.querySelector('.player output').textContent]";
    list(&browser.evaluate(shown)).try_into().unwrap()
}

#[test]
fn an_exported_page_needs_no_server_and_a_pose_is_selected_everywhere() {
    if !Browser::is_there() {
        crate::support::skipped("chromium");
        return;
    }
    let scratch = copy_sample("hexapod");
    run(&scratch);
    let page = exported(&scratch, "page.html");
    let mut browser = Browser::start_with_space();
    browser.size(1280, 800);
    browser.open(&page);
    browser.wait("document.querySelector('.stage canvas').dataset.frames > 0");
    assert_eq!(browser.evaluate("document.querySelector('.badge').className"), "badge conditional");
    let error = browser.evaluate("document.querySelector('.largest b').textContent");
    let error = error.as_str().unwrap();
    assert!(error.contains('±') && (error.contains("µm") || error.contains("mm")), "{error}");
    assert_eq!(browser.evaluate("document.getElementById('run')?.checkVisibility() ?? false"), false);
    // from the table
    tab(&mut browser, "errors");
    browser.evaluate("document.querySelectorAll('.errors .pick')[7].click()");
    let id = selected(&mut browser)[0].clone();
    assert_eq!(selected(&mut browser)[1], format!("Pose {id}"));
    assert!(selected(&mut browser)[2].starts_with(&format!("Pose {id},")));
    // from the slider, by the keyboard
    let before = drawn(&mut browser);
    browser.evaluate("document.getElementById('pose').focus()");
    browser.call(
        "Input.dispatchKeyEvent",
        json!({ "type": "keyDown", "key": "ArrowRight", "code": "ArrowRight", "windowsVirtualKeyCode": 39 }),
    );
    browser.wait(&format!("document.querySelector('.errors tr.chosen th').textContent !== {id:?}"));
    let next = selected(&mut browser);
    assert_eq!(next[1], format!("Pose {}", next[0]));
    // space is drawn again, then rests
    browser.wait(&format!("Number(document.querySelector('.stage canvas').dataset.frames) > {before}"));
    browser.evaluate("new Promise(done => setTimeout(done, 1500))");
    let rests = drawn(&mut browser);
    browser.evaluate("new Promise(done => setTimeout(done, 700))");
    assert_eq!(drawn(&mut browser), rests, "pictures are drawn on demand");
    let itself = format!("file://{}", page.display());
    let others: Vec<_> = browser.requests.iter().filter(|r| **r != itself && !r.starts_with("data:")).collect();
    assert!(others.is_empty(), "{others:?}");
}

#[test]
fn the_page_is_accessible_narrow_and_dark_and_names_are_text() {
    if !Browser::is_there() {
        crate::support::skipped("chromium");
        return;
    }
    let scratch = copy_sample("prexyt-cmm");
    make_hostile(&scratch);
    run(&scratch);
    let page = exported(&scratch, "hostile.html");
    let mut browser = Browser::start();
    let axe = axe();
    if axe.is_none() {
        crate::support::skipped("axe-core");
    }
    for scheme in ["light", "dark"] {
        let feature = json!([{ "name": "prefers-color-scheme", "value": scheme }]);
        browser.call("Emulation.setEmulatedMedia", json!({ "features": feature }));
        for (width, height) in [(390, 844), (1280, 800)] {
            browser.size(width, height);
            browser.open(&page);
            browser.wait("document.querySelector('footer')");
            assert_eq!(browser.evaluate("window.owned ?? null"), json!(null));
            assert_eq!(browser.evaluate("document.querySelectorAll('img, iframe, object').length"), 0);
            for name in ["result", "errors", "parameters", "messages"] {
                tab(&mut browser, name);
                let found = list(&browser.evaluate(OVERFLOW));
                assert!(found.is_empty(), "{name} at {width} px: {found:#?}");
                let Some(axe) = &axe else { continue };
                browser.evaluate(&format!("{axe}; 0"));
                let found = "axe.run({ resultTypes: ['violations'] }).then(r => r.violations.map(v => v.id + ': ' + v.nodes.slice(0, 3).map(n => n.html.slice(0, 200) + n.failureSummary).join(' | ')))";
                let violations = list(&browser.evaluate(found));
                assert!(violations.is_empty(), "{name}, {scheme}, {width} px: {violations:#?}");
            }
        }
    }
}

/// Answers the first question without an answer: with its first option, or as a certificate would.
const ANSWER: &str = "(() => {
    const open = [...document.querySelectorAll('.question')].find(question =>
        question.querySelector('.option') ? !question.querySelector('[aria-pressed=true]') : !question.querySelector('input').value);
    if (!open) return false;
    const option = open.querySelector('button.option');
    if (option) return option.click(), true;
    const input = open.querySelector('input');
    input.value = input.id.includes('name') ? 'Laser tracker' : '20';
    open.querySelector('form button').click();
    return true })()";

/// Drops files of a sample, answers every question, accepts, runs.
fn drop_and_run(browser: &mut Browser, files: &[PathBuf]) {
    let folder = tempfile::tempdir().unwrap();
    let served = Served::start(&[], folder.path());
    browser.size(1280, 800);
    browser.open_address(&served.address);
    browser.wait("document.querySelector('.drop')");
    browser.choose_files("#files", files);
    browser.wait("document.querySelector('.first-rows')");
    let idle = "document.querySelector('.start > [role=status]').textContent === ''";
    browser.wait(idle);
    let taken = browser.evaluate("document.querySelectorAll('.taken td b').length");
    assert!(taken.as_u64() > Some(0), "no column is taken for anything");
    for asked in 0.. {
        assert!(asked < 20, "questions without end");
        if browser.evaluate(ANSWER) != true {
            break;
        }
        browser.wait(idle);
    }
    let text = browser.evaluate("document.querySelector('.written .difference').textContent");
    assert!(text.as_str().unwrap().contains("+unit = \"mm\""), "{text}");
    browser.evaluate("document.querySelector('[data-key=accept]').click()");
    browser.wait("document.body.classList.contains('campaign')");
    assert!(folder.path().join("campaign.toml").is_file());
    press(browser, ".head", "Run");
    browser.wait("document.querySelector('.errors') && document.querySelector('.badge')");
    let verdict = browser.evaluate("document.querySelector('.verdict').textContent");
    assert!(verdict.as_str().unwrap().contains("µm"), "{verdict}");
}

#[test]
fn dropped_files_become_a_campaign_with_a_verdict() {
    if !Browser::is_there() {
        crate::support::skipped("chromium");
        return;
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/hexapod");
    let files = ["robot.toml", "encoders.csv", "exports/world.txt", "exports/poses.txt"];
    drop_and_run(&mut Browser::start(), &files.map(|file| folder.join(file)));
}

#[test]
fn a_pose_is_left_out_and_written_with_its_reason() {
    if !Browser::is_there() {
        crate::support::skipped("chromium");
        return;
    }
    let scratch = copy_sample("hexapod");
    run(&scratch);
    let served = Served::start(&[], &scratch.path());
    let mut browser = Browser::start();
    browser.size(1280, 800);
    browser.open_address(&served.address);
    browser.wait("document.querySelector('#tab-whatif')");
    // a reload shows the page again
    browser.evaluate("window.before = true");
    browser.call("Page.reload", json!({}));
    browser.wait("window.before !== true && document.querySelector('#tab-whatif')");
    browser.evaluate("document.querySelector('[data-key=out]').click()");
    tab(&mut browser, "whatif");
    browser.wait("document.querySelector('.beside tbody tr')");
    assert_eq!(browser.evaluate("document.querySelectorAll('.beside thead th').length"), 2);
    press(&mut browser, ".keep", "Write it to the campaign");
    let refused = "document.querySelector('.keep .problem').textContent";
    assert_ne!(browser.evaluate(refused), "", "an exclusion without a reason is refused");
    let text = || std::fs::read_to_string(scratch.path().join("campaign.toml")).unwrap();
    let before = text();
    browser.evaluate("document.getElementById('reason').value = 'reflector touched'");
    press(&mut browser, ".keep", "Write it to the campaign");
    browser.wait("document.querySelector('.keep .difference .added')");
    assert!(text() != before && text().contains("reflector touched"), "{}", text());
}

/// Poses that are there when the measurement is first looked at.
const BEGUN: usize = 20;

#[test]
fn forty_poses_are_followed_while_they_arrive() {
    if !Browser::is_there() {
        crate::support::skipped("chromium");
        return;
    }
    let scratch = copy_sample("hexapod");
    scratch.replace("campaign.toml", "calibration = \"1-40\"", "calibration = \"all\"");
    scratch.replace("campaign.toml", "validation = \"41-60\"\n", "");
    let [points, log] = ["exports/poses.txt", "encoders.csv"].map(|file| scratch.path().join(file));
    let whole = [&points, &log].map(|file| std::fs::read_to_string(file).unwrap());
    let [measured, logged] = whole.each_ref().map(|text| text.lines().collect::<Vec<_>>());
    let write = |file: &Path, lines: &[&str]| std::fs::write(file, lines.join("\n") + "\n").unwrap();
    write(&points, &measured[..3 * BEGUN]);
    write(&log, &logged[..=BEGUN]);
    let served = Served::start(&["--watch"], &scratch.path());
    let mut browser = Browser::start();
    browser.size(1280, 800);
    browser.open_address(&served.address);
    let received = |count: usize| format!("document.querySelector('.watch h3')?.textContent.includes(': {count}')");
    browser.wait(&received(BEGUN));
    let height = "parseFloat(getComputedStyle(document.querySelector('.spoken')).fontSize)";
    assert!(browser.evaluate(height).as_f64().unwrap() > 60.0, "readable from three metres");
    let append = |file: &Path, line: &str| {
        let mut file = std::fs::File::options().append(true).open(file).unwrap();
        writeln!(file, "{line}").unwrap();
    };
    for pose in BEGUN..BEGUN + 40 {
        append(&log, logged[1 + pose]);
        for target in 0..3 {
            append(&points, measured[3 * pose + target]);
        }
        browser.wait(&received(pose + 1));
    }
    // the newest pose is selected, and the line speaks of it
    browser.wait("document.querySelector('.selected h2')?.firstChild.textContent === 'Pose 60'");
    assert_ne!(browser.evaluate("document.querySelector('.spoken').textContent"), "");
    browser.wait("document.querySelectorAll('.watch tbody tr').length > 0");
}

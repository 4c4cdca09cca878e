//! The page of `etalon view` in a browser: exported and opened without the server, and served.

use super::builds;
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
    assert_eq!(browser.evaluate("document.querySelector('.badge').className"), "badge pass");
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

/// Drops files, answers every question, accepts, runs; returns the largest error as shown.
fn drop_and_run(browser: &mut Browser, files: &[PathBuf]) -> String {
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
    assert!(text.as_str().unwrap().contains("+expanded_uncertainty_um = 20"), "{text}");
    browser.evaluate("document.querySelector('[data-key=accept]').click()");
    browser.wait("document.body.classList.contains('campaign')");
    assert!(folder.path().join("campaign.toml").is_file());
    press(browser, ".head", "Run");
    browser.wait("document.querySelector('.errors') && document.querySelector('.badge')");
    let largest = browser.evaluate("document.querySelector('.largest b').textContent");
    let largest = largest.as_str().unwrap().to_owned();
    assert!(largest.contains("µm") && largest.contains('±'), "{largest}");
    largest
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

/// The same measurement, whatever program wrote its files: one result.
#[test]
fn files_of_three_builds_give_one_result() {
    if !Browser::is_there() {
        crate::support::skipped("chromium");
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let mut browser = Browser::start();
    let found: Vec<String> =
        builds::write(folder.path()).iter().map(|files| drop_and_run(&mut browser, files)).collect();
    assert!(found.iter().all(|error| *error == found[0]), "{found:?}");
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
    another_split_is_tried_and_taken_back(&mut browser);
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

/// Poses exchange their sets beside the pose that is left out: the errors of other poses decide.
fn another_split_is_tried_and_taken_back(browser: &mut Browser) {
    let largest = "document.querySelector('.largest b').textContent";
    let type_in = |browser: &mut Browser, set: &str, poses: &str| {
        browser.evaluate(&format!(
            "(input => {{ input.value = '{poses}'; input.dispatchEvent(new Event('change')) }})(document.getElementById('split-{set}'))"
        ));
    };
    let first = browser.evaluate(largest);
    type_in(browser, "calibration", "21-60");
    type_in(browser, "validation", "1-20");
    browser.wait(&format!("{largest} !== {first}"));
    type_in(browser, "calibration", "");
    type_in(browser, "validation", "");
    browser.wait(&format!("{largest} === {first}"));
    // poses that do not exist are refused, with their reason beside the question
    type_in(browser, "validation", "999");
    browser.wait("document.querySelector('.whatif .answer .message.error')");
    type_in(browser, "validation", "");
    browser.wait(&format!("!document.querySelector('.whatif .answer .message.error') && {largest} === {first}"));
}

#[test]
fn meshes_of_a_urdf_are_in_the_picture() {
    if !Browser::is_there() {
        crate::support::skipped("chromium");
        return;
    }
    let scratch = copy_sample("column-arm");
    let corner = |[x, y, z]: [f64; 3]| format!("v {x} {y} {z}\n");
    let corners: String =
        (0..8).map(|i| corner([i & 1, i >> 1 & 1, i >> 2].map(|side| f64::from(side) * 0.3 - 0.15))).collect();
    let faces = "f 1 2 4 3\nf 5 6 8 7\nf 1 2 6 5\nf 3 4 8 7\nf 1 3 7 5\nf 2 4 8 6\n";
    std::fs::write(scratch.path().join("box.obj"), corners + faces).unwrap();
    let visual = "<visual><geometry><mesh filename=\"package://arm/box.obj\"/></geometry></visual>";
    for link in ["arm_base", "forearm_link"] {
        let head = format!("<link name=\"{link}\">");
        scratch.replace("arm.urdf", &head, &format!("{head}{visual}"));
    }
    let page = exported(&scratch, "page.html");
    let mut browser = Browser::start_with_space();
    browser.size(1280, 800);
    browser.open(&page);
    browser.wait("document.querySelector('.stage').dataset.meshes === '2'");
    // without its meshes the picture of the robot is another one
    let space = browser.evaluate("(({ x, y, width, height }) => ({ x, y, width, height, scale: 1 }))(document.querySelector('.stage').getBoundingClientRect())");
    let picture =
        |browser: &mut Browser| browser.call("Page.captureScreenshot", json!({ "clip": space }))["data"].clone();
    let still = "new Promise(done => setTimeout(done, 1500))";
    browser.evaluate(still);
    let with = picture(&mut browser);
    browser.evaluate(
        "[...document.querySelectorAll('.checks label')].find(l => l.textContent.includes('meshes')).click()",
    );
    browser.evaluate(still);
    assert_ne!(picture(&mut browser), with);
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

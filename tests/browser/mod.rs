//! Reports as a browser shows and prints them. Skipped, saying so, where there is no `chromium`.

mod builds;
mod driver;
mod pages;
mod samples;
mod view;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use driver::Browser;
use pages::{Pages, all, hostile};
use serde_json::{Value, json};
use std::process::{Command, Stdio};

const OVERFLOW: &str = include_str!("overflow.js");

fn list(value: &Value) -> Vec<String> {
    value.as_array().unwrap().iter().map(|v| v.as_str().unwrap().to_owned()).collect()
}

type Check = fn(&mut Browser, &Pages);

#[test]
fn reports_are_shown_and_printed_as_they_are_meant() {
    if !Browser::is_there() {
        crate::support::skipped("chromium");
        return;
    }
    let reports = all();
    let checks: [(&str, Check); 10] = [
        ("widths", nothing_overflows_on_a_phone_a_tablet_and_a_wide_screen),
        ("requests", a_page_asks_for_nothing_but_itself_and_hostile_names_do_nothing),
        ("marks", marks_answer_to_the_pointer_and_to_the_keyboard),
        ("switch", before_and_after_are_switched_without_a_script),
        ("batch", the_page_over_all_campaigns_is_sorted_filtered_and_drawn),
        ("print", printing_cuts_no_figure_and_no_row),
        ("verdicts", verdicts_are_on_a_narrow_screen),
        ("files", tables_are_saved_with_whole_heads_and_their_names),
        ("comfort", tables_are_sorted_and_filtered_and_space_turns),
        ("axe", every_page_is_accessible_in_light_and_dark),
    ];
    for (name, check) in checks {
        println!("{name}");
        check(&mut Browser::start(), &reports);
    }
}

fn the_page_over_all_campaigns_is_sorted_filtered_and_drawn(browser: &mut Browser, reports: &Pages) {
    browser.open(&reports.batch);
    // campaign, verdict, cause, checks, robot
    let heads = "[...document.querySelectorAll('#campaigns thead th')].map(head => head.textContent)";
    let column = list(&browser.evaluate(heads)).iter().position(|head| head == "Robot").unwrap();
    let robots = "[...document.querySelectorAll('#campaigns tbody tr')].map(row => row.cells[ROBOT].textContent)"
        .replace("ROBOT", &column.to_string());
    let all = list(&browser.evaluate(&robots));
    assert_eq!(all.len(), 3);
    let sorted = |down: bool| {
        let mut sorted = all.clone();
        sorted.sort();
        if down {
            sorted.reverse();
        }
        sorted
    };
    let click = format!("document.querySelectorAll('#campaigns thead button')[{column}].click(); ");
    assert_eq!(list(&browser.evaluate(&format!("{click}{robots}"))), sorted(false));
    assert_eq!(list(&browser.evaluate(&format!("{click}{robots}"))), sorted(true));
    let marks = "document.querySelectorAll('#trend .robot').length";
    assert_eq!(browser.evaluate(marks), 2, "two campaigns have errors after calibration");
    let forms = "new Set([...document.querySelectorAll('#trend .key path')].map(mark => mark.getAttribute('d'))).size";
    let keys = "document.querySelectorAll('#trend .key').length";
    assert_eq!(browser.evaluate(forms), browser.evaluate(keys), "robots differ by more than their colour");
    let choose = "(quantity => { quantity.value = [...quantity.options].find(o => o.text.startsWith('AP')).value; \
        quantity.dispatchEvent(new Event('change')) })(document.getElementById('quantity')); ";
    assert_eq!(browser.evaluate(&format!("{choose}{marks}")), 1, "one campaign has AP and RP");
    let filter = "document.getElementById('filter').value = 'campaign/no such'; \
        document.getElementById('filter').dispatchEvent(new Event('input')); ";
    assert_eq!(list(&browser.evaluate(&format!("{filter}{robots}"))), Vec::<String>::new());
}

/// The verdict of each limit is on a phone's screen.
fn verdicts_are_on_a_narrow_screen(browser: &mut Browser, reports: &Pages) {
    browser.size(390, 844);
    browser.open(&reports.pages[0]);
    let right = "Math.max(...[...document.querySelectorAll('#limits tbody tr')].map(row => row.cells[1].getBoundingClientRect().right))";
    let right = browser.evaluate(right).as_f64().unwrap();
    assert!(right > 0.0 && right < 390.0, "{right}");
    browser.open(&reports.batch);
    let right =
        browser.evaluate("document.querySelector('#campaigns tbody tr').cells[1].getBoundingClientRect().right");
    assert!(right.as_f64().unwrap() < 390.0, "{right}");
}

/// Name and contents of the file that a table is saved as.
fn saved(browser: &mut Browser, table: &str) -> (String, Vec<Vec<String>>) {
    let script = format!(
        "(async () => {{ let blob, name; URL.createObjectURL = b => {{ blob = b; return '#' }}; \
         HTMLAnchorElement.prototype.click = function () {{ name = this.download }}; \
         const tools = {table}.parentNode.previousElementSibling.classList.contains('tools') ? {table}.parentNode.previousElementSibling \
         : {table}.parentNode.previousElementSibling.previousElementSibling; \
         [...tools.querySelectorAll('button')].pop().click(); return [name, await blob.text()] }})()"
    );
    let [name, text] = list(&browser.evaluate(&script)).try_into().unwrap();
    let rows = csv::ReaderBuilder::new().has_headers(false).from_reader(text.as_bytes()).into_records();
    (name, rows.map(|row| row.unwrap().iter().map(str::to_owned).collect()).collect())
}

fn tables_are_saved_with_whole_heads_and_their_names(browser: &mut Browser, reports: &Pages) {
    browser.size(1024, 768);
    browser.open(&reports.pages[0]);
    let table = "[...document.querySelectorAll('#errors table')].find(t => t.tHead.rows.length > 1 && t.tBodies[0].rows.length > 2)";
    let (name, rows) = saved(browser, table);
    let heads = &rows[0];
    assert!(heads.contains(&"before: RMS".to_owned()) && heads.contains(&"after: RMS".to_owned()), "{heads:?}");
    assert_eq!(heads.iter().collect::<std::collections::BTreeSet<_>>().len(), heads.len(), "{heads:?}");
    assert!(name.starts_with("errors-before-and-after-validation-") && name.ends_with(".csv"), "{name}");
    let all = "[...document.querySelectorAll('.scroll > table')].filter(t => t.tHead && t.tBodies[0].rows.length > 2)";
    let count = browser.evaluate(&format!("{all}.length")).as_u64().unwrap();
    let names: Vec<String> = (0..count).map(|i| saved(browser, &format!("{all}[{i}]")).0).collect();
    let different: std::collections::BTreeSet<_> = names.iter().collect();
    assert!(different.len() == names.len() && !names.iter().any(|n| n.starts_with("table")), "{names:?}");
    // cells without a number are last, whichever way
    let first = format!("{all}.find(t => t.tBodies[0].rows.length > 10)");
    let column = format!(
        "(t => {{ [...t.tBodies[0].rows].slice(0, 2).forEach(r => {{ r.cells[1].textContent = '' }}); \
         t.tHead.rows[t.tHead.rows.length - 1].cells[1].querySelector('button').click(); \
         return [...t.tBodies[0].rows].map(r => r.cells[1].textContent) }})({first})"
    );
    for way in ["ascending", "descending"] {
        let cells = list(&browser.evaluate(&column));
        let blanks = cells.iter().rev().take_while(|c| c.is_empty()).count();
        assert!(blanks >= 2 && blanks == cells.iter().filter(|c| c.is_empty()).count(), "{way}: {cells:?}");
    }
}

fn tables_are_sorted_and_filtered_and_space_turns(browser: &mut Browser, reports: &Pages) {
    browser.size(1024, 768);
    browser.open(&reports.pages[0]);
    let table = "[...document.querySelectorAll('#errors details table, #parameters .scroll > table')].find(t => t.tBodies[0].rows.length > 10)";
    let first = format!("[...{table}.tBodies[0].rows].filter(r => !r.hidden).map(r => r.cells[0].textContent.trim())");
    let before = list(&browser.evaluate(&first));
    browser.evaluate(&format!(
        "{table}.querySelector('thead button').click(); {table}.querySelector('thead button').click()"
    ));
    let sorted = list(&browser.evaluate(&first));
    assert_ne!(before, sorted);
    assert_eq!(
        browser.evaluate(&format!("{table}.querySelector('[aria-sort]').getAttribute('aria-sort')")),
        "descending"
    );
    browser.evaluate(&format!(
        "(input => {{ input.value = 'no such row'; input.dispatchEvent(new Event('input')) }})({table}.parentNode.previousElementSibling.querySelector('input'))"
    ));
    assert_eq!(list(&browser.evaluate(&first)), Vec::<String>::new());
    // one scale of colours for before and after, or one of each picture
    let fill = "getComputedStyle(document.querySelector('.side-after .w15')).fill";
    let own = browser.evaluate(fill);
    browser.evaluate("document.querySelector('.switch input[value=common]').checked = true");
    assert_ne!(browser.evaluate(fill), own);
    let contents = "(() => { scrollTo(0, 3000); return document.querySelector('nav').getBoundingClientRect().top })()";
    assert_eq!(browser.evaluate(contents), 0, "the contents stay in sight");
    let Some(spatial) = &reports.spatial else { return };
    browser.open(spatial);
    let mark = "document.querySelector('svg[data-turn] circle[data-at]').getBoundingClientRect().left";
    let before = browser.evaluate(mark);
    browser.evaluate("document.querySelector('svg[data-turn]').dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowLeft', shiftKey: true }))");
    assert_ne!(browser.evaluate(mark), before);
    view_presets_look_along_an_axis(browser);
}

/// Along z, the picture shows x to the right and y upwards, at one scale; the last button shows the picture as drawn.
fn view_presets_look_along_an_axis(browser: &mut Browser) {
    let press = |text: &str| {
        format!("[...document.querySelectorAll('.tools button')].find(b => b.textContent === '{text}').click()")
    };
    let places = "(() => { const at = [...document.querySelectorAll('svg[data-turn] circle[data-at]')].slice(0, 9); \
        return at.map(c => [...c.dataset.at.split(' ').map(Number), c.getBoundingClientRect().left, c.getBoundingClientRect().top]) })()";
    let read = |browser: &mut Browser| -> Vec<Vec<f64>> {
        let rows = browser.evaluate(places);
        rows.as_array()
            .unwrap()
            .iter()
            .map(|r| r.as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect())
            .collect()
    };
    browser.evaluate(&press("Vue initiale"));
    let drawn = read(browser);
    for (button, right, up) in [("x-y", 0, 1), ("x-z", 0, 2), ("y-z", 1, 2)] {
        browser.evaluate(&press(button));
        let marks = read(browser);
        let (first, last) = (
            &marks[0],
            marks
                .iter()
                .max_by(|a, b| {
                    let far = |m: &[f64]| (m[right] - marks[0][right]).hypot(m[up] - marks[0][up]);
                    far(a).total_cmp(&far(b))
                })
                .unwrap(),
        );
        let scale =
            (last[3] - first[3]).hypot(last[4] - first[4]) / (last[right] - first[right]).hypot(last[up] - first[up]);
        for mark in &marks {
            let [x, y] = [mark[3] - first[3], first[4] - mark[4]];
            let shown = [scale * (mark[right] - first[right]), scale * (mark[up] - first[up])];
            assert!((x - shown[0]).abs() < 1.5 && (y - shown[1]).abs() < 1.5, "{button}: {x} {y} {shown:?}");
        }
    }
    browser.evaluate(&press("Vue initiale"));
    assert_eq!(read(browser), drawn);
}

/// axe-core from the npm registry, in the folder of the build; none where it cannot be had.
fn axe() -> Option<String> {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("axe");
    let script = folder.join("node_modules/axe-core/axe.min.js");
    if !script.exists() {
        std::fs::create_dir_all(&folder).ok()?;
        let arguments = ["install", "--ignore-scripts", "--no-audit", "--no-fund", "--prefix", ".", "axe-core@4.10.3"];
        let mut command = Command::new("npm");
        command.args(arguments).current_dir(&folder).stdout(Stdio::null()).stderr(Stdio::null()).status().ok()?;
    }
    std::fs::read_to_string(script).ok()
}

fn every_page_is_accessible_in_light_and_dark(browser: &mut Browser, reports: &Pages) {
    let Some(axe) = axe() else {
        crate::support::skipped("axe-core");
        return;
    };
    browser.size(1024, 768);
    for page in reports.pages.iter().chain(&reports.spatial).chain([&reports.comparison, &reports.batch]) {
        // colours do not depend on the language
        let translated = ["-fr.html", "-de.html"].iter().any(|end| page.to_string_lossy().ends_with(end));
        for scheme in ["light", "dark"].into_iter().take(if translated { 1 } else { 2 }) {
            let feature = json!([{ "name": "prefers-color-scheme", "value": scheme }]);
            browser.call("Emulation.setEmulatedMedia", json!({ "features": feature }));
            browser.open(page);
            browser.evaluate("document.querySelectorAll('details').forEach(d => d.open = true)");
            browser.evaluate(&format!("{axe}; 0"));
            // what depends on the scheme, and what does not
            let rules = match (translated, scheme) {
                (true, _) => ", rules: { 'color-contrast': { enabled: false } }",
                (_, "dark") => ", runOnly: ['color-contrast', 'link-in-text-block']",
                _ => "",
            };
            let found = format!(
                "axe.run({{ resultTypes: ['violations']{rules} }}).then(r => r.violations.map(v => v.id + ': ' + v.nodes.slice(0, 3).map(n => n.html.slice(0, 200) + n.failureSummary).join(' | ')))"
            );
            let violations = list(&browser.evaluate(&found));
            assert!(violations.is_empty(), "{} in {scheme}: {violations:#?}", page.display());
        }
    }
}

fn nothing_overflows_on_a_phone_a_tablet_and_a_wide_screen(browser: &mut Browser, reports: &Pages) {
    for page in reports.pages.iter().chain(&reports.spatial).chain([&reports.comparison, &reports.batch]) {
        for (width, height) in [(390, 844), (1024, 768), (1920, 1080)] {
            browser.size(width, height);
            browser.open(page);
            let found = list(&browser.evaluate(OVERFLOW));
            assert!(found.is_empty(), "{} at {width} px: {found:#?}", page.display());
        }
    }
}

fn a_page_asks_for_nothing_but_itself_and_hostile_names_do_nothing(browser: &mut Browser, reports: &Pages) {
    for page in reports.pages.iter().chain(&reports.spatial).chain([&reports.comparison, &reports.batch]) {
        browser.open(page);
        // whatever a name might start is given the time to do so
        browser.evaluate("new Promise(done => setTimeout(done, 200))");
        let itself = format!("file://{}", page.display());
        let beside: Vec<_> = browser.requests.iter().filter(|r| **r != itself && !r.starts_with("data:")).collect();
        assert!(beside.is_empty(), "{}: {beside:?}", page.display());
        let strange = browser.evaluate(
            "[window.owned, [...document.scripts].filter(s => s.type != 'application/json').length, document.querySelectorAll('img:not(.logo), iframe, object, link, a[href^=http]').length]",
        );
        assert_eq!(strange, json!([null, 1, 0]), "{}", page.display());
    }
}

fn marks_answer_to_the_pointer_and_to_the_keyboard(browser: &mut Browser, reports: &Pages) {
    browser.size(1024, 768);
    for page in &reports.pages {
        browser.open(page);
        let at = browser.evaluate(
            "(() => { const mark = [...document.querySelectorAll('.figures svg circle.map, .figures svg circle.cal')].find(m => {
                 // one that no other mark or name covers
                 m.scrollIntoView({ block: 'center' });
                 const box = m.getBoundingClientRect();
                 const top = document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2);
                 return top === m && (m.querySelector('title') || m.dataset.i) });
               const box = mark.getBoundingClientRect();
               return [box.left + box.width / 2, box.top + box.height / 2] })()",
        );
        browser.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))");
        browser.call("Input.dispatchMouseEvent", json!({ "type": "mouseMoved", "x": at[0], "y": at[1] }));
        let tip = "document.getElementById('tip').hidden ? '' : document.getElementById('tip').textContent";
        let said = browser.evaluate(tip).as_str().unwrap().to_owned();
        let numbers = said.split(|c: char| !c.is_ascii_digit()).filter(|n| !n.is_empty()).count();
        assert!(
            numbers >= 4 && said.to_lowercase().contains("pose") && (said.contains("µm") || said.contains("mm")),
            "{}: {said:?}",
            page.display()
        );
        a_click_marks_the_pose_everywhere(browser, &at, page);
        // away from it, and on with the keys
        browser.call("Input.dispatchMouseEvent", json!({ "type": "mouseMoved", "x": 1, "y": 1 }));
        assert_eq!(browser.evaluate(tip), "", "{}", page.display());
        browser.evaluate("document.querySelector('.figures svg[tabindex]').focus()");
        let press = |browser: &mut Browser| {
            browser.call(
                "Input.dispatchKeyEvent",
                json!({ "type": "keyDown", "key": "ArrowRight", "code": "ArrowRight" }),
            );
            browser.evaluate(tip).as_str().unwrap().to_owned()
        };
        let (first, second) = (press(browser), press(browser));
        assert!(!first.is_empty() && first != second, "{}: {first:?}, {second:?}", page.display());
    }
}

/// The pose of a mark stays marked in all figures after a click, and no other pose with it.
fn a_click_marks_the_pose_everywhere(browser: &mut Browser, at: &Value, page: &std::path::Path) {
    let click = |browser: &mut Browser| {
        for kind in ["mousePressed", "mouseReleased"] {
            let event = json!({ "type": kind, "x": at[0], "y": at[1], "button": "left", "clickCount": 1 });
            browser.call("Input.dispatchMouseEvent", event);
        }
        browser.call("Input.dispatchMouseEvent", json!({ "type": "mouseMoved", "x": 1, "y": 1 }));
    };
    click(browser);
    let marked = "(() => {
        const texts = (document.getElementById('texts') || { content: { textContent: '' } }).content.textContent.split('\\n');
        const pose = mark => (/^pose ([^,:]+)/i.exec(mark.dataset.text || texts[mark.dataset.i] || '') || [])[1];
        const all = [...document.querySelectorAll('svg [data-i], svg [data-text]')], linked = all.filter(m => m.classList.contains('linked'));
        const of = linked.length && pose(linked[0]).trim();
        return [linked.length, new Set(linked.map(m => m.closest('svg'))).size,
            all.filter(m => (pose(m) || '').trim() === of).length === linked.length] })()";
    let found = browser.evaluate(marked);
    assert!(found[0].as_u64() > Some(1) && found[1].as_u64() > Some(1), "{}: {found}", page.display());
    assert_eq!(found[2], true, "{}: {found}", page.display());
    // the same pose again: unmarked
    browser.call("Input.dispatchMouseEvent", json!({ "type": "mouseMoved", "x": at[0], "y": at[1] }));
    click(browser);
    assert_eq!(browser.evaluate(marked)[0], 0, "{}", page.display());
    browser.call("Input.dispatchMouseEvent", json!({ "type": "mouseMoved", "x": at[0], "y": at[1] }));
}

fn before_and_after_are_switched_without_a_script(browser: &mut Browser, reports: &Pages) {
    browser.open(&reports.pages[0]);
    let shown = "[...document.querySelector('.pair').querySelectorAll('figure')].map(f => f.checkVisibility())";
    assert_eq!(browser.evaluate(shown), json!([true, true]));
    for (side, expected) in [("before", [true, false]), ("after", [false, true]), ("both", [true, true])] {
        browser.evaluate(&format!("document.querySelector('.switch input[value={side}]').checked = true"));
        assert_eq!(browser.evaluate(shown), json!(expected), "{side}");
    }
    browser.evaluate("document.querySelector('.switch input[value=after]').checked = true");
    browser.media("print");
    assert_eq!(browser.evaluate(shown), json!([true, true]));
    browser.media("");
    // what was chosen is chosen in the next report
    browser.evaluate("document.querySelector('.switch input[value=before]').click()");
    browser.open(&reports.pages[1]);
    assert_eq!(browser.evaluate(shown), json!([true, false]));
    browser.evaluate("document.querySelector('.switch input[value=both]').click()");
    browser.open(&reports.pages[0]);
    assert_eq!(browser.evaluate(shown), json!([true, true]));
}

/// Whitespace is where a printer breaks lines; marks of direction are not printed.
fn letters(text: &str) -> String {
    text.chars().filter(|c| !c.is_whitespace() && !('\u{2066}'..='\u{2069}').contains(c)).collect()
}

fn printing_cuts_no_figure_and_no_row(browser: &mut Browser, reports: &Pages) {
    if Command::new("pdftotext").arg("-v").stderr(Stdio::null()).status().is_err() {
        crate::support::skipped("pdftotext");
        return;
    }
    for page in reports.pages.iter().filter(|page| **page != hostile(&reports.folder)) {
        browser.open(page);
        browser.media("print");
        // letters with a rim are printed twice, as rim and as letters
        browser.evaluate("document.querySelectorAll('.over').forEach(letters => letters.style.stroke = 'none')");
        let whole = list(&browser.evaluate(
            "[...document.querySelectorAll('tr, figure, .signatures')].filter(e => e.checkVisibility()).map(e =>
               e.tagName === 'FIGURE' ? e.querySelector('figcaption').innerText + [...e.querySelectorAll('svg text')].filter(t => t.getBoundingClientRect().width).map(t => t.textContent).join('') : e.textContent)",
        ));
        let printed = browser.call(
            "Page.printToPDF",
            json!({ "paperWidth": 8.27, "paperHeight": 11.69, "printBackground": true, "preferCSSPageSize": true }),
        );
        let path = reports.folder.path().join("printed.pdf");
        std::fs::write(&path, STANDARD.decode(printed["data"].as_str().unwrap()).unwrap()).unwrap();
        let text = Command::new("pdftotext").args(["-raw".as_ref(), path.as_os_str(), "-".as_ref()]).output().unwrap();
        let text = String::from_utf8_lossy(&text.stdout).into_owned();
        let sheets: Vec<String> = text.split('\u{c}').map(letters).filter(|sheet| !sheet.is_empty()).collect();
        assert!(whole.len() > 20 && sheets.len() > 2, "{}: {} sheets", page.display(), sheets.len());
        let on_one_sheet = |text: &String| sheets.iter().any(|sheet| sheet.contains(&letters(text)));
        let cut: Vec<_> = whole.iter().filter(|text| !on_one_sheet(text)).collect();
        assert!(cut.is_empty(), "{}: {cut:#?}", page.display());
        browser.media("");
    }
}

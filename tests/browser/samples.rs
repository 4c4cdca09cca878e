//! Reports of all samples in a browser: page one and the evidence are short, annexes are folded and
//! printed.

use super::driver::Browser;
use crate::support::samples::ran;

/// Height (px) of the evidence: six screens of 900 px.
const EVIDENCE: u64 = 5400;
/// Size (bytes) of the page of 982 poses.
const SIZE: u64 = 1_200_000;

#[test]
fn the_evidence_of_every_sample_fits_on_six_screens_and_annexes_are_folded() {
    if !Browser::is_there() {
        crate::support::skipped("chromium");
        return;
    }
    let mut browser = Browser::start();
    let mut wrong = Vec::new();
    for sample in ran() {
        let page = sample.folder.join("out/report.html");
        let bytes = std::fs::metadata(&page).unwrap().len();
        browser.size(1440, 900);
        browser.open(&page);
        // the first annex, or the end of the page
        let height = browser.evaluate(
            "Math.ceil((document.querySelector('.annex') || document.querySelector('.end')).getBoundingClientRect().top + scrollY)",
        );
        let height = height.as_u64().unwrap();
        println!("{}: {height} px, {bytes} bytes", sample.name);
        let folded = "[...document.querySelectorAll('.annex > details')].every(d => !d.open)";
        assert_eq!(browser.evaluate(folded), true, "{}", sample.name);
        // contents of annexes that take up space
        let shown = "[...document.querySelectorAll('.annex > details > :not(summary)')].some(c => \
            c.checkVisibility({ contentVisibilityAuto: true }) && c.getBoundingClientRect().height > 0)";
        assert_eq!(browser.evaluate(shown), false, "{}", sample.name);
        browser.media("print");
        assert_eq!(browser.evaluate(shown), true, "{}: annexes are printed", sample.name);
        browser.media("");
        // an annex opens where it is named
        browser.evaluate("location.hash = '#provenance'");
        browser.evaluate("new Promise(done => setTimeout(done, 50))");
        assert_eq!(browser.evaluate("document.querySelector('#provenance > details').open"), true, "{}", sample.name);
        if height > EVIDENCE || bytes > SIZE {
            wrong.push(format!("{}: {height} px, {bytes} bytes", sample.name));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

//! Overview page of all campaigns of a batch: a table to sort and filter, trends, and outliers. The
//! rows are data that a script draws, because a page with ten thousand rows is unusable; without a
//! script the page shows the worst campaigns as a plain table.

use super::html;
use super::number::{decimals, distinct_from_limit, quantile, significant, stated, with_uncertainty};
use super::words::{Words, names, tr};
use etalon_base::message::one_line;
use etalon_documents::{
    Acceptance, BatchCheck, BatchDocument, BatchEnd, BatchEntry, BatchFigures, BatchQuantity, BatchValue,
    LimitQuantity, Presentation,
};
use serde::Serialize;
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::io::Write;
use std::path::{Component, Path};

/// Number of rows of the plain table.
const WORST: usize = 200;
/// Minimum number of campaigns of a robot for comparisons within the robot; otherwise robots of one
/// kind are compared, if they have as many campaigns.
const FEWEST: usize = 8;
/// Modified z-score of an outlier (B. Iglewicz and D. C. Hoaglin, How to Detect and Handle
/// Outliers, ASQC, 1993, 3.5).
const OUTLIER: f64 = 3.5;
/// Median absolute deviation of a normal distribution, in standard deviations.
const MAD_NORMAL: f64 = 0.674_490;
/// Maximum length of a message (characters).
const LONGEST: usize = 300;
/// Placeholder of the data in the template; the data are too long for a template engine.
const DATA: &str = "{data}";

/// Values of the template.
#[derive(Serialize)]
struct Page<'a> {
    version: &'static str,
    title: String,
    subtitle: String,
    class: &'static str,
    checks: Vec<String>,
    counted: Vec<Counted>,
    headings: Vec<String>,
    worst: Vec<Plain<'a>>,
    left_out: usize,
    /// Remark on campaigns of synthetic data.
    synthetic: Option<String>,
}

/// A row of the plain table.
#[derive(Serialize)]
struct Plain<'a> {
    campaign: &'a str,
    report: Option<&'a str>,
    robot: &'a str,
    date: &'a str,
    valid_until: &'a str,
    ended: String,
    grade: &'static str,
    cause: String,
    checks: Vec<Checked>,
    figures: Vec<Figure>,
}

/// Verdict on a check; empty if the campaign does not have the check.
#[derive(Clone, Default, Serialize)]
struct Checked {
    said: String,
    grade: &'static str,
}

/// Number of campaigns with each verdict on a check: pass, conditional, undecided, fail.
#[derive(Serialize)]
struct Counted {
    check: String,
    counts: [usize; 4],
}

#[derive(Clone, Default, Serialize)]
struct Figure {
    shown: String,
    outlier: bool,
}

/// A campaign on the page.
struct Row<'a> {
    entry: &'a BatchEntry,
    report: Option<String>,
    /// Reason of a failure, or checks that are not passed.
    cause: String,
    /// Value and modified z-score of each quantity.
    figures: Vec<Option<(BatchValue, f64)>>,
}

/// Writes the page for `folder`.
///
/// # Errors
///
/// Fails if a template is invalid, or if the page cannot be written.
pub fn write(
    document: &BatchDocument,
    figures: &BatchFigures,
    folder: &Path,
    presentation: &Presentation,
    into: &mut impl Write,
) -> anyhow::Result<()> {
    let words = Words::new(presentation.language);
    let rows = rows(document, figures, folder, &words);
    let (order, checks) = (order(figures), check_names(document));
    let page = html::batch(&contents(document, figures, &rows, &words), presentation, &words)?;
    let (before, after) = page.rsplit_once(DATA).unwrap_or((&page, ""));
    into.write_all(before.as_bytes())?;
    let quantities: Vec<Value> = order
        .iter()
        .filter_map(|i| figures.quantities.get_index(*i))
        .map(|q| json!([named(q, &words), q.unit]))
        .collect();
    write!(into, "{{\"quantities\":{},\"rows\":[", script_safe(&quantities)?)?;
    for (i, row) in rows.iter().enumerate() {
        let entry = row.entry;
        let values: Vec<_> = order.iter().map(|k| row.figures[*k].map(|(v, _)| digits(v))).collect();
        let outliers: Vec<_> = (0..values.len()).filter(|&k| row.is_outlier(order[k])).collect();
        let checked: Vec<_> = checks.iter().map(|name| checked(entry, name, &words)).collect();
        let data = json!([
            entry.campaign,
            row.report,
            entry.robot,
            entry.date,
            [ended(entry, &words), grade(entry)],
            row.cause,
            values,
            outliers,
            row.badness(),
            checked.into_iter().map(|c| [c.said, c.grade.to_owned()]).collect::<Vec<_>>(),
            entry.valid_until,
            limits_by_column(row, &order, figures),
        ]);
        write!(into, "{}{}", if i > 0 { ",\n" } else { "" }, script_safe(&data)?)?;
    }
    write!(into, "]}}{after}")?;
    Ok(())
}

/// Converts data to JSON that cannot end a script element.
fn script_safe<T: Serialize>(data: &T) -> serde_json::Result<String> {
    Ok(serde_json::to_string(data)?.replace('<', "\\u003c"))
}

/// Verdict on a campaign: the verdict on its result, with a reservation if a check of the program
/// is not passed, as a warning that needs a decision.
fn verdict(entry: &BatchEntry) -> Option<Acceptance> {
    let worst = entry.checks.iter().map(|c| c.verdict).max();
    match entry.ended {
        BatchEnd::Done => entry.verdict.max(worst).or(Some(Acceptance::Pass)),
        BatchEnd::NotMet => entry.verdict.max(worst).or(Some(Acceptance::Fail)),
        BatchEnd::Failed | BatchEnd::Skipped => None,
    }
}

fn ended(entry: &BatchEntry, words: &Words) -> String {
    match (verdict(entry), entry.ended) {
        (Some(verdict), _) => said(verdict, words),
        (None, BatchEnd::Skipped) => tr!(words, "skipped"),
        (None, _) => tr!(words, "not-run"),
    }
}

fn said(verdict: Acceptance, words: &Words) -> String {
    match verdict {
        Acceptance::Pass => tr!(words, "pass"),
        Acceptance::Conditional => tr!(words, "conditional"),
        Acceptance::Undecided => tr!(words, "undecided"),
        Acceptance::Fail => tr!(words, "fail"),
    }
}

/// Style of a verdict.
fn verdict_grade(verdict: Acceptance) -> &'static str {
    match verdict {
        Acceptance::Pass => "good",
        Acceptance::Conditional => "warning",
        Acceptance::Undecided => "open",
        Acceptance::Fail => "bad",
    }
}

fn grade(entry: &BatchEntry) -> &'static str {
    match (verdict(entry), entry.ended) {
        (Some(verdict), _) => verdict_grade(verdict),
        (None, BatchEnd::Skipped) => "open",
        (None, _) => "bad",
    }
}

/// Names of all checks, in the order of their first occurrence.
fn check_names(document: &BatchDocument) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for check in document.campaigns.iter().flat_map(|c| &c.checks) {
        if !names.contains(&check.name.as_str()) {
            names.push(&check.name);
        }
    }
    names
}

/// Name of a check in words.
fn check_name(name: &str, words: &Words) -> String {
    match name {
        "solver" => tr!(words, "solver"),
        "robot" => tr!(words, "parameters-title"),
        "preconditions" => tr!(words, "preconditions-column"),
        "warnings" => tr!(words, "decide-now"),
        limit => {
            let found = LimitQuantity::ALL.iter().find(|q| q.to_string() == limit);
            found.map_or_else(|| limit.to_owned(), |q| words.tr(&names::limit(*q)))
        }
    }
}

fn checked(entry: &BatchEntry, name: &str, words: &Words) -> Checked {
    let check = entry.checks.iter().find(|c| c.name == name);
    check.map_or_else(Checked::default, |c| Checked { said: said(c.verdict, words), grade: verdict_grade(c.verdict) })
}

/// Verdicts on each check, counted over all campaigns.
fn counted(document: &BatchDocument, checks: &[&str], words: &Words) -> Vec<Counted> {
    const ORDER: [Acceptance; 4] = [Acceptance::Pass, Acceptance::Conditional, Acceptance::Undecided, Acceptance::Fail];
    let all = |name: &str| -> Vec<Acceptance> {
        let found = document.campaigns.iter().flat_map(|c| &c.checks).filter(|c| c.name == name);
        found.map(|c| c.verdict).collect()
    };
    let of = |name: &&str| {
        let found = all(name);
        let counts = ORDER.map(|verdict| found.iter().filter(|v| **v == verdict).count());
        Counted { check: check_name(name, words), counts }
    };
    checks.iter().map(of).collect()
}

/// Limits of a campaign by the column of their quantity: of the validation poses if these have a
/// value, otherwise of the calibration poses.
fn limits_by_column(row: &Row, order: &[usize], figures: &BatchFigures) -> Vec<(usize, f64)> {
    let column = |name: &str| {
        let named = |k: &usize| figures.quantities.get_index(order[*k]).is_some_and(|q| q.name.english() == name);
        (0..order.len()).filter(|k| row.figures[order[*k]].is_some()).find(named)
    };
    let of = |check: &BatchCheck| {
        let limit = check.limit?;
        let quantity = LimitQuantity::ALL.iter().find(|q| q.to_string() == check.name)?;
        let place = match (quantity.limited_error(), quantity) {
            (Some((errors, figure)), _) => {
                let statistic = match figure {
                    etalon_documents::Figure::Max => "max",
                    etalon_documents::Figure::Rms => "RMS",
                    etalon_documents::Figure::Mean => return None,
                };
                let of_set = |set: &str| column(&format!("{set} {errors} {statistic}"));
                of_set("validation").or_else(|| of_set("calibration"))
            }
            (None, LimitQuantity::AccuracyMaxMm) => column("AP"),
            (None, _) => column("RP"),
        };
        Some((place?, limit))
    };
    row.entry.checks.iter().filter_map(of).collect()
}

/// Reason of a failure, or checks that are not passed, the worst first.
fn cause(entry: &BatchEntry, words: &Words) -> String {
    let mut open: Vec<&BatchCheck> = entry.checks.iter().filter(|c| c.verdict != Acceptance::Pass).collect();
    open.sort_by_key(|c| std::cmp::Reverse(c.verdict));
    let text = |c: &&BatchCheck| {
        let name = check_name(&c.name, words);
        let unit = c.unit.as_deref().unwrap_or_default();
        match (c.value, c.limit) {
            (Some(value), Some(limit)) => {
                let value = distinct_from_limit(value, limit, decimals(limit, 3).unwrap_or(4));
                tr!(words, "value-and-limit", quantity = name, value, limit = stated(limit), unit)
            }
            (Some(count), None) => format!("{name}: {count}"),
            _ => format!("{name}: {}", said(c.verdict, words)),
        }
    };
    let of_checks: Vec<String> = open.iter().map(text).collect();
    let message = entry.message.as_deref().map(one_line);
    message.into_iter().chain(of_checks).collect::<Vec<_>>().join("; ").chars().take(LONGEST).collect()
}

/// Columns of the quantities: errors of validation poses, characteristics, errors of calibration
/// poses, parameters.
fn order(figures: &BatchFigures) -> Vec<usize> {
    let rank = |name: &str| match name.split(' ').next() {
        Some("validation") => 0,
        Some("AP" | "RP") => 1,
        Some("calibration") => 2,
        _ => 3,
    };
    let mut order: Vec<usize> = (0..figures.quantities.len()).collect();
    order.sort_by_key(|i| figures.quantities.get_index(*i).map(|q| rank(q.name.english())));
    order
}

/// Value to the second digit of its uncertainty; errors, which have no given uncertainty, with
/// four digits.
fn digits(value: BatchValue) -> String {
    match value.standard_uncertainty {
        Some(u) if u > 0.0 => with_uncertainty(value.value, Some(u)),
        _ => significant(value.value, 4),
    }
}

/// Name of a quantity.
fn named(quantity: &BatchQuantity, words: &Words) -> String {
    words.worded(&quantity.name)
}

impl Row<'_> {
    fn is_outlier(&self, quantity: usize) -> bool {
        self.figures[quantity].is_some_and(|(_, score)| score > OUTLIER)
    }

    /// Order of the rows: campaigns that did not run, then by verdict, then by the largest outlier.
    fn badness(&self) -> f64 {
        let end = match (self.entry.ended, verdict(self.entry)) {
            (BatchEnd::Failed, _) => 3e9,
            (_, Some(Acceptance::Fail)) => 2e9,
            (_, Some(Acceptance::Undecided)) => 1e9,
            (_, Some(Acceptance::Conditional)) => 5e8,
            _ => 0.0,
        };
        // rounded for shorter JSON
        end + self.figures.iter().flatten().map(|f| f.1.min(1e6)).fold(0.0, f64::max).round()
    }
}

fn rows<'a>(document: &'a BatchDocument, figures: &BatchFigures, folder: &Path, words: &Words) -> Vec<Row<'a>> {
    let quantities = figures.quantities.len();
    let row = |(entry, values): (&'a BatchEntry, &Vec<BatchValue>)| {
        let mut figures = vec![None; quantities];
        values.iter().for_each(|&value| figures[value.quantity] = Some((value, 0.0)));
        let report = entry.output.as_ref().map(|output| Path::new(output).join("report.html"));
        Row {
            entry,
            report: report.filter(|path| path.is_file()).map(|path| link(folder, &path)),
            cause: cause(entry, words),
            figures,
        }
    };
    let mut rows: Vec<Row> = document.campaigns.iter().zip(&figures.values).map(row).collect();
    let mut by_robot: BTreeMap<Option<&str>, Vec<usize>> = BTreeMap::new();
    for (i, row) in rows.iter().enumerate().filter(|(_, row)| row.figures.iter().any(Option::is_some)) {
        by_robot.entry(row.entry.robot.as_deref()).or_default().push(i);
    }
    // a robot with many campaigns is compared with itself, others with robots of their kind alone
    let (many, few): (Vec<_>, Vec<_>) = by_robot.into_values().partition(|group| group.len() >= FEWEST);
    let mut alike: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    for i in few.concat() {
        if let Some(kind) = rows[i].entry.alike.as_deref() {
            alike.entry(kind).or_default().push(i);
        }
    }
    for group in many.into_iter().chain(alike.into_values()) {
        (0..quantities).for_each(|quantity| score(&mut rows, &group, quantity));
    }
    rows
}

/// Computes the modified z-scores of a quantity in a group of campaigns.
fn score(rows: &mut [Row], group: &[usize], quantity: usize) {
    let values = || group.iter().filter_map(|&i| Some(rows[i].figures[quantity]?.0.value));
    let median = quantile(values(), 0.5);
    let mad = quantile(values().map(|v| (v - median).abs()), 0.5);
    let scored = values().count() >= FEWEST && mad > 0.0;
    for &i in group.iter().filter(|_| scored) {
        if let Some((value, score)) = &mut rows[i].figures[quantity] {
            *score = MAD_NORMAL * (value.value - median).abs() / mad;
        }
    }
}

fn contents<'a>(document: &BatchDocument, figures: &BatchFigures, rows: &'a [Row], words: &Words) -> Page<'a> {
    let BatchDocument { failed, skipped, campaigns, .. } = document;
    let mut worst: Vec<&Row> = rows.iter().collect();
    worst.sort_by(|a, b| b.badness().total_cmp(&a.badness()));
    worst.truncate(WORST);
    let robots: BTreeSet<_> = campaigns.iter().filter_map(|c| c.robot.as_ref()).collect();
    let (order, checks) = (order(figures), check_names(document));
    let figure = |row: &Row, quantity: usize| Figure {
        shown: row.figures[quantity].map_or_else(String::new, |(value, _)| words.decimal(digits(value))),
        outlier: row.is_outlier(quantity),
    };
    let plain = |row: &&'a Row| Plain {
        campaign: &row.entry.campaign,
        report: row.report.as_deref(),
        robot: row.entry.robot.as_deref().unwrap_or_default(),
        date: row.entry.date.as_deref().unwrap_or_default(),
        valid_until: row.entry.valid_until.as_deref().unwrap_or_default(),
        ended: ended(row.entry, words),
        grade: grade(row.entry),
        cause: row.cause.clone(),
        checks: checks.iter().map(|name| checked(row.entry, name, words)).collect(),
        figures: order.iter().map(|quantity| figure(row, *quantity)).collect(),
    };
    let count = |verdict| campaigns.iter().filter(|c| self::verdict(c) == Some(verdict)).count();
    let synthetic = campaigns.iter().filter(|c| c.synthetic).count();
    let counts = [Acceptance::Pass, Acceptance::Conditional, Acceptance::Undecided, Acceptance::Fail].map(count);
    let [pass, conditional, undecided, fail] = counts;
    let heading = |i: &usize| {
        figures.quantities.get_index(*i).map_or_else(String::new, |q| format!("{} [{}]", named(q, words), q.unit))
    };
    Page {
        version: env!("CARGO_PKG_VERSION"),
        title: tr!(words, "campaigns-of-robots", campaigns = campaigns.len(), robots = robots.len()),
        subtitle: tr!(words, "batch-ends", pass, conditional, undecided, fail, failed, skipped),
        class: match (failed + fail + undecided, conditional) {
            (0, 0) => "good",
            (0, _) => "warning",
            _ => "bad",
        },
        checks: checks.iter().map(|name| check_name(name, words)).collect(),
        counted: counted(document, &checks, words),
        headings: order.iter().map(heading).collect(),
        worst: worst.iter().map(plain).collect(),
        left_out: rows.len().saturating_sub(WORST),
        synthetic: (synthetic > 0).then(|| tr!(words, "batch-synthetic", count = synthetic)),
    }
}

/// Address of a file relative to a page in `folder`.
fn link(folder: &Path, file: &Path) -> String {
    let whole = |path: &Path| path.canonicalize().unwrap_or_else(|_| path.to_owned());
    let (folder, file) = (whole(folder), whole(file));
    let common = folder.components().zip(file.components()).take_while(|(a, b)| a == b).count();
    let up = folder.components().skip(common).map(|_| "..".to_owned());
    let down = file.components().skip(common).map(|part| match part {
        Component::Normal(name) => encoded(&name.to_string_lossy()),
        other => other.as_os_str().to_string_lossy().into_owned(),
    });
    up.chain(down).collect::<Vec<_>>().join("/")
}

/// Encodes a name for an address (RFC 3986, 2.1 and 2.3).
pub(crate) fn encoded(name: &str) -> String {
    let byte = |b: u8| match b {
        b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' => char::from(b).to_string(),
        _ => format!("%{b:02X}"),
    };
    name.bytes().map(byte).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_documents::Language;

    /// A hundred campaigns of two robots with one outlier and one failure; names resemble markup.
    fn figure(name: &str, value: f64) -> (BatchQuantity, f64, Option<f64>) {
        let quantity = BatchQuantity { name: name.into(), unit: "mm".to_owned() };
        (quantity, value, None)
    }

    fn batch() -> (BatchDocument, BatchFigures) {
        let mut figures = BatchFigures::default();
        let campaigns = (0..100).map(|i| {
            let ended = if i == 7 { BatchEnd::Failed } else { BatchEnd::Done };
            let value = if i == 42 { 9.0 } else { f64::from(i % 10) / 100.0 };
            figures.add([figure("validation position max", value)].into_iter().filter(|_| i != 7));
            BatchEntry {
                campaign: format!("c{i}</script><b>"),
                robot: Some(format!("R{}", i % 2)),
                date: Some(format!("2026-01-{:02}", i % 28 + 1)),
                ended,
                message: (i == 7).then(|| "error: <i>no</i>\nsecond line".to_owned()),
                ..BatchEntry::default()
            }
        });
        (BatchDocument::new(campaigns.collect()), figures)
    }

    fn page(document: &BatchDocument, figures: &BatchFigures, language: Language) -> String {
        let mut bytes = Vec::new();
        let presentation = Presentation { language, ..Presentation::default() };
        write(document, figures, Path::new("."), &presentation, &mut bytes).unwrap();
        String::from_utf8(bytes).unwrap()
    }

    /// Counts of the campaigns by how they ended, none skipped.
    fn ends([pass, conditional, undecided, fail, failed]: [usize; 5]) -> String {
        tr!(Words::default(), "batch-ends", pass, conditional, undecided, fail, failed, skipped = 0)
    }

    #[test]
    fn the_page_has_every_campaign_as_data_and_the_worst_as_a_table() {
        let (document, figures) = batch();
        let page = page(&document, &figures, Language::En);
        let data = page.split("id=\"data\">").nth(1).unwrap().split("</script>").next().unwrap();
        let data: Value = serde_json::from_str(data).unwrap();
        let rows = data["rows"].as_array().unwrap();
        assert_eq!(rows.len(), 100);
        assert_eq!(rows[42][0], "c42</script><b>");
        let outliers: Vec<usize> = (0..100).filter(|&i| rows[i][7] == json!([0])).collect();
        assert_eq!(outliers, [42]);
        // the plain table has the failed campaign first, then the outlier, and no markup from names
        let plain = page.split("<tbody>").nth(1).unwrap();
        let first = plain.split("</tr>").next().unwrap();
        assert!(first.contains("c7&lt;") && first.contains("not run") && first.contains("&lt;i&gt;no"), "{first}");
        let second = plain.split("</tr>").nth(1).unwrap();
        assert!(second.contains("c42&lt;") && second.contains("outlier"), "{second}");
        assert!(!page.contains("<i>") && !page.contains("src=\"http"), "markup or an address");
        assert!(page.contains(&tr!(Words::default(), "campaigns-of-robots", campaigns = 100, robots = 2)));
        assert!(page.contains(&ends([99, 0, 0, 0, 1])), "{page}");
    }

    #[test]
    fn every_check_has_a_column_the_cause_is_beside_the_verdict_and_validation_comes_first() {
        let mut figures = BatchFigures::default();
        let errors = || [figure("calibration position max", 0.1), figure("validation position max", 0.2)];
        figures.add([figure("d_1", 1.0)].into_iter().chain(errors()));
        figures.add(errors().into_iter());
        let check = |name: &str, verdict, value, limit| BatchCheck {
            name: name.to_owned(),
            verdict,
            value,
            limit,
            unit: limit.map(|_| "mm".to_owned()),
        };
        let entry = |ended, checks: &[BatchCheck]| BatchEntry {
            ended,
            checks: checks.to_vec(),
            valid_until: Some("2027-03-02".to_owned()),
            ..BatchEntry::default()
        };
        let undecided = check("position_max_mm", Acceptance::Conditional, Some(0.2), Some(0.21));
        let failed = check("position_rms_mm", Acceptance::Fail, Some(0.1368), Some(0.1));
        let document = BatchDocument::new(vec![
            entry(BatchEnd::NotMet, std::slice::from_ref(&undecided)),
            entry(BatchEnd::NotMet, &[undecided, failed, check("solver", Acceptance::Pass, None, None)]),
        ]);
        let page = page(&document, &figures, Language::En);
        assert!(page.contains(&ends([0, 1, 0, 1, 0])), "{page}");
        let heads: Vec<&str> = page
            .split("id=\"campaigns\"")
            .nth(1)
            .unwrap()
            .split("<th")
            .skip(2)
            .map(|h| h.split_once('>').unwrap().1.split('<').next().unwrap())
            .collect();
        let place =
            |head: &str| heads.iter().position(|h| h.starts_with(head)).unwrap_or_else(|| panic!("{head}: {heads:?}"));
        assert_eq!((place("Campaign"), place("Verdict"), place("Cause")), (0, 1, 2));
        assert!(place("Cause") < place("largest position") && place("RMS position") < place("Robot"), "{heads:?}");
        assert!(place("validation") < place("calibration") && place("calibration") < place("d_1"), "{heads:?}");
        let worst = page.split("<tbody>").nth(2).unwrap().split("</tr>").next().unwrap();
        let [verdict, cause] = [0, 1].map(|i| worst.split("<td").nth(i + 1).unwrap());
        assert!(
            verdict.contains(">fail<")
                && cause.contains("RMS position error 0.137 mm, limit 0.1 mm; largest position error"),
            "{worst}"
        );
        assert!(!page.contains("position_max"), "keys are no labels");
        // a row of the first table: pass, conditional, undecided, fail
        let counts = page.split("id=\"counts\"").nth(1).unwrap();
        let of = |check: &str| -> Vec<&str> {
            let row = counts.split(&format!(">{check}</th>")).nth(1).unwrap().split("</tr>").next().unwrap();
            row.split("<td class=\"num\">").skip(1).map(|cell| cell.split('<').next().unwrap()).collect()
        };
        assert_eq!(of("largest position error"), ["0", "2", "0", "0"]);
        assert_eq!(of("RMS position error"), ["0", "0", "0", "1"]);
        // the limit is drawn over the validation poses
        let data: Value =
            serde_json::from_str(page.split("id=\"data\">").nth(1).unwrap().split("</script>").next().unwrap())
                .unwrap();
        let column = data["quantities"]
            .as_array()
            .unwrap()
            .iter()
            .position(|q| q[0].as_str().unwrap().contains("validation") && q[0].as_str().unwrap().contains("max"));
        assert_eq!(data["rows"][0][11], json!([[column.unwrap(), 0.21]]));
        assert_eq!(data["rows"][0][10], "2027-03-02");
    }

    #[test]
    fn outliers_are_judged_among_robots_of_one_kind() {
        let mut figures = BatchFigures::default();
        // twenty robots with a campaign each: nineteen small ones and a large one
        let entry = |i: u32, alike: &str| BatchEntry {
            robot: Some(format!("R{i}")),
            alike: Some(alike.to_owned()),
            ended: BatchEnd::Done,
            ..BatchEntry::default()
        };
        (0..20).for_each(|i| {
            let value = if i == 7 { 3.0 } else { 0.1 + 0.001 * f64::from(i) };
            figures.add([figure("validation position max", value)].into_iter());
        });
        let outliers = |large: &str| {
            let campaigns = (0..20).map(|i| entry(i, if i == 7 { large } else { "small" })).collect();
            let document = BatchDocument::new(campaigns);
            rows(&document, &figures, Path::new("."), &Words::default()).iter().filter(|r| r.is_outlier(0)).count()
        };
        assert_eq!((outliers("small"), outliers("large")), (1, 0));
    }

    #[test]
    fn ten_thousand_campaigns_are_a_page_of_some_megabytes() {
        let mut figures = BatchFigures::default();
        let names: Vec<String> = (0..30).map(|k| format!("quantity {k}")).collect();
        let campaigns = (0..10_000u32).map(|i| {
            figures.add(names.iter().zip(0u32..).map(|(name, k)| figure(name, f64::from(i * 31 + k).sin())));
            BatchEntry { campaign: format!("campaigns/{i}"), ended: BatchEnd::Done, ..BatchEntry::default() }
        });
        let document = BatchDocument::new(campaigns.collect());
        let page = page(&document, &figures, Language::De);
        assert!(page.len() < 5_000_000, "{}", page.len());
        assert_eq!(page.matches("<tr>").count(), 1 + WORST);
        assert!(page.contains("9800"), "how many are left out");
    }

    #[test]
    fn addresses_are_relative_and_encoded() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        std::fs::create_dir_all(at("a b#/out")).unwrap();
        std::fs::create_dir_all(at("pages/x")).unwrap();
        std::fs::write(at("a b#/out/report.html"), "").unwrap();
        assert_eq!(link(&at("pages/x"), &at("a b#/out/report.html")), "../../a%20b%23/out/report.html");
        assert_eq!(link(folder.path(), &at("a b#/out/report.html")), "a%20b%23/out/report.html");
    }
}

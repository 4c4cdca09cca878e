//! What the page is made of: entries with printed and computed values side by side, drawn as Markdown and as HTML.

pub use etalon::documents::Spread;
use std::fmt::Write;

/// Share of the values outside their intervals up to which an entry agrees: 95 % intervals leave one in twenty to chance.
const OUTSIDE: f64 = 0.1;

/// A value that is not drawn.
pub fn exactly(value: f64) -> Spread {
    Spread { low: value, median: value, high: value }
}

/// A printed value beside ours.
#[derive(Clone, Debug)]
pub struct Compared {
    pub printed: Option<f64>,
    pub ours: Spread,
    pub digits: usize,
}

impl Compared {
    /// Whether the printed value, up to its rounding, is in the interval.
    fn agrees(&self) -> Option<bool> {
        let half = 0.500_001 * 10f64.powi(-(self.digits as i32));
        self.printed.map(|p| p >= self.ours.low - half && p <= self.ours.high + half)
    }

    fn text(&self, judged: bool) -> String {
        let digits = self.digits;
        let number = |v: f64| format!("{v:.digits$}");
        let Spread { low, median, high } = self.ours;
        let interval = if low == high { String::new() } else { format!(" [{}, {}]", number(low), number(high)) };
        let printed = self.printed.map_or("–".to_owned(), number);
        let mark = if judged && self.agrees() == Some(false) { " ✗" } else { "" };
        format!("{printed} | {}{interval}{mark}", number(median))
    }
}

/// A table of printed values beside ours.
#[derive(Clone, Debug, Default)]
pub struct Comparison {
    pub caption: String,
    pub columns: Vec<String>,
    pub rows: Vec<(String, Vec<Compared>)>,
    /// Whether the verdict rests on it.
    pub judged: bool,
}

/// What is expected of an entry; the page is wrong where it is not so.
#[derive(Clone, Debug)]
pub enum Verdict {
    Agrees,
    /// Why.
    Differs(&'static str),
    /// Why.
    NotReproducible(&'static str),
}

/// One table or figure of the thesis.
#[derive(Clone, Debug)]
pub struct Entry {
    pub title: &'static str,
    /// What was computed, how, and which error it is.
    pub how: String,
    pub comparisons: Vec<Comparison>,
    /// SVG.
    pub figures: Vec<String>,
    /// Statements of the text that hold or do not.
    pub statements: Vec<(String, bool)>,
    pub expected: Verdict,
}

impl Entry {
    /// Values and statements that were judged, and how many of them agree.
    fn judged(&self) -> (usize, usize) {
        let cells = self.comparisons.iter().filter(|c| c.judged).flat_map(|c| &c.rows).flat_map(|(_, cells)| cells);
        let judged = cells.filter_map(Compared::agrees).chain(self.statements.iter().map(|(_, holds)| *holds));
        judged.fold((0, 0), |(all, good), agrees| (all + 1, good + usize::from(agrees)))
    }

    /// Whether what was computed agrees with the thesis.
    pub fn agrees(&self) -> bool {
        let (all, good) = self.judged();
        all > 0 && (all - good) as f64 <= OUTSIDE * all as f64
    }

    /// Whether the verdict is the expected one.
    pub fn as_expected(&self) -> bool {
        match self.expected {
            Verdict::Agrees => self.agrees(),
            Verdict::Differs(_) => !self.agrees(),
            Verdict::NotReproducible(_) => true,
        }
    }

    fn verdict(&self) -> String {
        let (all, good) = self.judged();
        let counted = format!("{good} of {all} printed values");
        match (&self.expected, self.agrees()) {
            (Verdict::NotReproducible(why), _) => format!("not reproducible because {why}"),
            (_, true) => format!("agrees ({counted})"),
            (Verdict::Differs(why), false) => format!("differs ({counted} agree) because {why}"),
            (Verdict::Agrees, false) => format!("DIFFERS, unexplained ({counted} agree)"),
        }
    }

    fn anchor(&self) -> String {
        let name = self.title.split(',').next().unwrap_or_default();
        name.to_lowercase().chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect()
    }
}

/// What the page says of itself.
pub struct Head {
    pub draws: u64,
    pub version: &'static str,
}

const TITLE: &str = "The thesis on one page";
const SOURCE: &str =
    "A. Joubair, “Contribution à l'amélioration de la précision absolue des robots parallèles”, ÉTS Montréal, 2012";
const LEGEND: &str = "In every cell the printed value is before the bar, ours behind it: the median of the draws and in brackets the interval that holds \
    95 % of them. ✗ marks a printed value that is outside of it by more than its rounding, in the tables that the verdict rests on. An entry agrees where at most one value in ten is \
    outside. Nobody has the measurements of the thesis: what is called synthetic comes from simulated campaigns whose truth are the printed \
    parameters. Poses that only the figures show are ours.";

/// The page as Markdown; pictures are in the HTML.
pub fn markdown(entries: &[Entry], head: &Head) -> String {
    let mut out =
        format!("# {TITLE}\n\n{SOURCE}, beside etalon {}; {} draws.\n\n{LEGEND}\n\n", head.version, head.draws);
    out += "| table or figure | verdict |\n| --- | --- |\n";
    for entry in entries {
        let _ = writeln!(out, "| [{}](#{}) | {} |", entry.title, entry.anchor(), entry.verdict());
    }
    for entry in entries {
        let _ = write!(
            out,
            "\n<a id=\"{}\"></a>\n\n## {}\n\n{}\n\n{}.\n",
            entry.anchor(),
            entry.title,
            entry.how,
            sentence(&entry.verdict())
        );
        for (statement, holds) in &entry.statements {
            let _ = write!(out, "\n- {statement}: {}", yes(*holds));
        }
        out += if entry.statements.is_empty() { "" } else { "\n" };
        for table in &entry.comparisons {
            let caption = if table.caption.is_empty() { "Printed | ours" } else { &table.caption };
            let _ = write!(
                out,
                "\n{}\n\n| | {} |\n|{}\n",
                caption.replace('|', "\\|"),
                table.columns.join(" | "),
                " --- |".repeat(table.columns.len() + 1)
            );
            for (name, cells) in &table.rows {
                let cells: Vec<String> = cells.iter().map(|c| c.text(table.judged).replace('|', "\\|")).collect();
                let _ = writeln!(out, "| {name} | {} |", cells.join(" | "));
            }
        }
    }
    out
}

const STYLE: &str = "body{font:15px/1.45 system-ui,sans-serif;max-width:72rem;margin:2rem auto;padding:0 1rem;color:#1a1a1a}\
    table{border-collapse:collapse;margin:1rem 0;font-variant-numeric:tabular-nums;display:block;overflow-x:auto}\
    td,th{border-bottom:1px solid #ddd;padding:.2rem .7rem;text-align:right;white-space:nowrap}td:first-child,th:first-child{text-align:left}\
    .words td{white-space:normal;text-align:left}.off{background:#fbe3e0}svg{max-width:100%;height:auto;display:block;margin:1rem 0}\
    caption{text-align:left;padding:.3rem 0;font-weight:600}h2{margin-top:2.5rem;border-top:1px solid #bbb;padding-top:1rem}\
    svg text{font:12px system-ui,sans-serif}.grid{stroke:#e3e3e3}.axis{stroke:#777}";

/// The page as one HTML file.
pub fn html(entries: &[Entry], head: &Head) -> String {
    let mut out = format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\">\
         <title>{TITLE}</title><style>{STYLE}</style></head><body>\n<h1>{TITLE}</h1>\n<p>{SOURCE}, beside etalon {}; {} draws.</p>\n\
         <p>{LEGEND}</p>\n<table class=\"words\"><tr><th>table or figure</th><th>verdict</th></tr>\n",
        head.version, head.draws
    );
    for entry in entries {
        let class = if entry.agrees() { "" } else { " class=\"off\"" };
        let _ = writeln!(
            out,
            "<tr{class}><td><a href=\"#{}\">{}</a></td><td>{}</td></tr>",
            entry.anchor(),
            escape(entry.title),
            escape(&entry.verdict())
        );
    }
    out += "</table>\n";
    for entry in entries {
        let _ =
            writeln!(out, "<h2 id=\"{}\">{}</h2>\n<p>{}</p>", entry.anchor(), escape(entry.title), escape(&entry.how));
        let _ = writeln!(out, "<p><strong>{}.</strong></p>", escape(&sentence(&entry.verdict())));
        if !entry.statements.is_empty() {
            let items = entry.statements.iter().map(|(s, holds)| format!("<li>{}: {}</li>", escape(s), yes(*holds)));
            let _ = writeln!(out, "<ul>{}</ul>", items.collect::<String>());
        }
        entry.comparisons.iter().for_each(|table| out += &html_table(table));
        entry.figures.iter().for_each(|svg| out += svg);
    }
    out + "</body></html>\n"
}

fn html_table(table: &Comparison) -> String {
    let header: String = table.columns.iter().map(|c| format!("<th>{}</th>", escape(c))).collect();
    let caption = if table.caption.is_empty() { "Printed | ours" } else { &table.caption };
    let mut out = format!("<table><caption>{}</caption><tr><th></th>{header}</tr>\n", escape(caption));
    for (name, cells) in &table.rows {
        let cell = |c: &Compared| {
            let class = if table.judged && c.agrees() == Some(false) { " class=\"off\"" } else { "" };
            format!("<td{class}>{}</td>", c.text(table.judged))
        };
        let _ = writeln!(out, "<tr><td>{}</td>{}</tr>", escape(name), cells.iter().map(cell).collect::<String>());
    }
    out + "</table>\n"
}

fn yes(holds: bool) -> &'static str {
    if holds { "yes" } else { "no" }
}

fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default()
}

/// Text between tags.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

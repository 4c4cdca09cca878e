//! Significant changes between campaigns: a section for each family of quantities.

use super::provenance::{Evaluated, section_from_provenance};
use crate::model::{
    Block, Cell, Columns, Grade, Section, Table, Text, Verdict, numbers, significant, strong_term, term, yes_no,
};
use crate::number::{self, stated};
use crate::plots::trend;
use crate::words::comparison::{Change, change, family, quantity, unit, value};
use crate::words::{Words, isolated, tr};
use etalon_base::message::one_line;
use etalon_base::phrase;
use etalon_base::worded::Worded;
use etalon_documents::{
    CompareBetween, CompareChange, CompareDocument, CompareFamily, CompareTogether, CompareTrend, CompareValue,
    ComparedCampaign,
};

/// Maximum number of figures.
const PICTURES: usize = 60;

/// Sections on campaigns, rules for judging changes, and all families.
pub(crate) fn sections(compare: &CompareDocument, words: &Words) -> Vec<Section> {
    let mut all = vec![campaigns(compare, words), rules(compare, words)];
    all.push(super::messages::section_from_messages(&compare.messages.iter().collect::<Vec<_>>(), words));
    let mut drawn = 0;
    let mut trends = compare.trends.iter().enumerate().peekable();
    while let Some((_, first)) = trends.peek().copied() {
        let mut of_family = Vec::new();
        while let Some(next) = trends.next_if(|(_, t)| t.family == first.family) {
            of_family.push(next);
        }
        let mut figures = figures(compare, &of_family, words);
        let room = PICTURES.saturating_sub(drawn);
        let undrawn = figures.len().saturating_sub(room);
        figures.truncate(room);
        drawn += figures.len();
        let trends: Vec<&CompareTrend> = of_family.into_iter().map(|(_, t)| t).collect();
        let id = format!("family-{}", all.len() - 2);
        let mut section = Section::new(id, family(first.family, words));
        section.table(tr!(words, "changes"), "", changes(&trends, words));
        section.figures(figures);
        if undrawn > 0 {
            let note = tr!(words, "more-without-picture", count = undrawn);
            section.push(Block::note(note));
        }
        let title = tr!(words, "values-of-every-campaign");
        section.push(Block::Aside { title, blocks: vec![Block::Table(values(compare, &trends, words))] });
        section.push(Block::Table(all_values(&trends, words)));
        all.push(section.on_terminal());
    }
    all.push(section_from_provenance(&compare.provenance, Evaluated::ANY, &[], words));
    all
}

fn figures(compare: &CompareDocument, trends: &[(usize, &CompareTrend)], words: &Words) -> Vec<crate::model::Figure> {
    let label = |date: Option<&String>| date.filter(|d| d.chars().count() <= 12).cloned().unwrap_or_default();
    let labels: Vec<String> = compare.campaigns.iter().map(|c| label(c.date.as_ref())).collect();
    trends.iter().filter_map(|(i, t)| trend::picture(t, *i, &labels, words)).collect()
}

/// Number of campaigns, and robot.
pub(crate) fn lead(compare: &CompareDocument, words: &Words) -> String {
    let count = compare.campaigns.len();
    match compare.campaigns.iter().find_map(|c| c.robot.as_ref()) {
        Some(robot) => {
            tr!(words, "campaigns-of-robot", count, robot = isolated(&one_line(robot)))
        }
        None => tr!(words, "campaigns-in-order", count),
    }
}

/// Instrument and its uncertainty.
fn instrument(c: &ComparedCampaign) -> String {
    let k = c.coverage_factor.map(|k| format!(" (k = {})", stated(k))).unwrap_or_default();
    let u = c.expanded_uncertainty_um.map(|u| format!("U = {} µm{k}", stated(u)));
    c.instrument.as_deref().map(one_line).into_iter().chain(u).collect::<Vec<_>>().join(", ")
}

/// Differences between the campaigns other than the robot: instrument, set-up, and identified
/// parameters.
fn differences(compare: &CompareDocument, words: &Words) -> Vec<String> {
    // each value once, in the order of the campaigns; a single value is no difference
    let differing = |of: &dyn Fn(&ComparedCampaign) -> Option<String>| -> Option<Vec<String>> {
        let mut all: Vec<String> = Vec::new();
        compare.campaigns.iter().filter_map(of).for_each(|v| {
            if !all.contains(&v) {
                all.push(v)
            }
        });
        (all.len() > 1).then_some(all)
    };
    let listed = |all: Vec<String>| all.iter().map(|v| isolated(v)).collect::<Vec<_>>().join("; ");
    let instruments = differing(&|c| Some(instrument(c)).filter(|text| !text.is_empty()))
        .map(|all| tr!(words, "different-instruments", instruments = listed(all)));
    type Stated = fn(&ComparedCampaign) -> Option<String>;
    let kinds: [(String, Stated); 4] = [
        (tr!(words, "mounting"), |c| c.conditions.robot.mounting.clone()),
        (tr!(words, "measurement-point"), |c| c.conditions.measurement_point.clone()),
        (tr!(words, "load"), |c| c.conditions.motion.load_kg.map(|kg| format!("{kg} kg"))),
        (tr!(words, "controller"), |c| c.conditions.robot.controller.clone()),
    ];
    let set_ups: Vec<String> =
        kinds.iter().filter_map(|(what, of)| Some(format!("{what}: {}", listed(differing(of)?)))).collect();
    let set_ups = (!set_ups.is_empty()).then(|| tr!(words, "different-set-ups", differences = set_ups.join("; ")));
    let identified = |c: &ComparedCampaign| (!c.identified.is_empty()).then(|| c.identified.join(", "));
    let counts =
        || compare.campaigns.iter().filter(|c| !c.identified.is_empty()).map(|c| c.identified.len().to_string());
    let models = differing(&identified).map(|_| {
        let counts = counts().collect::<Vec<_>>().join(", ");
        tr!(words, "different-models", counts)
    });
    instruments.into_iter().chain(set_ups).chain(models).collect()
}

fn campaigns(compare: &CompareDocument, words: &Words) -> Section {
    let rows: Vec<(usize, &ComparedCampaign)> = (1..).zip(&compare.campaigns).collect();
    let date = |c: &ComparedCampaign| c.date.as_deref().map_or_else(|| term(words, phrase!("not-stated")), Cell::from);
    let columns = Columns::<(usize, &ComparedCampaign)>::new()
        .both(phrase!("number"), "", |(i, _)| *i)
        .both(phrase!("campaign"), "", |(_, c)| c.name.as_str())
        .page(phrase!("date"), "", move |(_, c)| date(c))
        .sheet(phrase!("date"), "", |(_, c)| c.date.as_deref())
        .page(phrase!("instrument"), "", move |(_, c)| instrument(c))
        .sheet(phrase!("instrument"), "", |(_, c)| c.instrument.as_deref())
        .sheet(phrase!("head-expanded-uncertainty"), "µm", |(_, c)| c.expanded_uncertainty_um)
        .sheet(phrase!("coverage-factor"), "", |(_, c)| c.coverage_factor)
        .sheet(phrase!("synthetic-data"), "", |(_, c)| c.synthetic.as_deref())
        .sheet(phrase!("degrees-of-freedom"), "", |(_, c)| c.degrees_of_freedom)
        .both(phrase!("folder"), "", |(_, c)| c.folder.as_str());
    let mut section = Section::new("campaigns", tr!(words, "campaigns"));
    section.summarise(tr!(words, "model-of-the-robot"), compare.robot.as_deref(), "");
    let conventions: Vec<&str> = compare.conventions.iter().map(Worded::english).collect();
    section.summarise(tr!(words, "conventions"), conventions.join("; "), "");
    section.push(Block::Table(Table::new(words, &rows, columns).on(phrase!("campaigns"))));
    section.on_terminal()
}

fn rules(compare: &CompareDocument, words: &Words) -> Section {
    let columns = Columns::<CompareTogether>::new()
        .sheet(phrase!("campaign"), "", |t| t.to)
        .sheet(phrase!("against"), "", |t| t.from)
        .sheet(phrase!("parameters"), "", |t| t.parameters)
        .sheet("F", "", |t| t.f)
        .sheet(phrase!("degrees-of-freedom"), "", |t| t.degrees_of_freedom)
        .sheet("p", "", |t| t.p)
        .sheet(phrase!("changed"), "", |t| yes_no(words, t.significant));
    let mut section = Section::new("rules", tr!(words, "how-changes-are-judged"));
    compare.together.iter().for_each(|t| section.push(Block::text(together(t, words))));
    for convention in &compare.conventions {
        section.push(Block::text(Text::worded(convention, words)));
    }
    section.push(Block::Table(Table::new(words, &compare.together, columns).on(phrase!("sheet-all-together"))));
    let columns = Columns::<CompareBetween>::new()
        .page(phrase!("campaign"), "", |b| format!("{} – {}", b.from, b.to))
        .sheet(phrase!("campaign"), "", |b| b.to)
        .sheet(phrase!("against"), "", |b| b.from)
        .both(phrase!("parameters"), "", |b| b.parameters)
        .page(phrase!("birge-ratio"), "", |b| significant(Some(b.birge_ratio), 3))
        .sheet(phrase!("birge-ratio"), "", |b| b.birge_ratio);
    let between = Table::new(words, &compare.between_series, columns).on(phrase!("sheet-between-series"));
    if !compare.between_series.is_empty() {
        section.table(tr!(words, "what-differs-between-series"), "", between);
    }
    section.on_terminal()
}

fn changes(trends: &[&CompareTrend], words: &Words) -> Table {
    type Row<'a> = (&'a CompareTrend, &'a CompareChange, Change);
    let rows: Vec<Row> =
        trends.iter().flat_map(|t| t.changes.iter().map(move |c| (*t, c, change(t, c, words)))).collect();
    let judged = |c: &CompareChange| match c.significant {
        Some(true) => strong_term(words, phrase!("changed")),
        Some(false) => term(words, phrase!("no-significant-change")),
        None if c.low.is_some() => term(words, phrase!("not-judged-by-misfit")),
        None => term(words, phrase!("no-uncertainty-is-known")),
    };
    let columns = Columns::<Row>::new()
        .sheet(phrase!("head-family"), "", |(t, ..)| family(t.family, words))
        .page(phrase!("quantity"), "", |(t, ..)| quantity(t, words))
        .sheet(phrase!("quantity"), "", |(t, ..)| t.name.english())
        .sheet(phrase!("unit"), "", |(t, ..)| t.unit.as_str())
        .page(phrase!("campaign"), "", |(.., w)| Text::from(w.pair.clone()))
        .sheet(phrase!("campaign"), "", |(_, c, _)| c.to)
        .sheet(phrase!("against"), "", |(_, c, _)| c.from)
        .page(phrase!("change"), "", |(.., w)| numbers(w.change.clone()))
        .sheet(phrase!("change"), "", |(_, c, _)| c.change)
        .sheet(phrase!("ratio"), "", |(_, c, _)| c.ratio)
        .page(phrase!("interval-95"), "", |(.., w)| numbers(w.interval.clone()))
        .sheet(phrase!("interval-from"), "", |(_, c, _)| c.low)
        .sheet(phrase!("interval-to"), "", |(_, c, _)| c.high)
        .sheet(phrase!("interval-of"), "", |(_, c, _)| {
            term(words, if c.ratio.is_some() { phrase!("ratio") } else { phrase!("change") })
        })
        .page("p", "", |(.., w)| numbers(w.p.clone()))
        .sheet("p", "", |(_, c, _)| c.p)
        .page(phrase!("p-of-family"), "", |(.., w)| numbers(w.p_family.clone()))
        .sheet(phrase!("p-of-family"), "", |(_, c, _)| c.p_family)
        .sheet(phrase!("changed"), "", |(_, c, _)| c.significant.map(|yes| yes_no(words, yes)))
        .page(phrase!("verdict"), "", move |(_, c, _)| judged(c))
        .decisive();
    Table::new(words, &rows, columns).on(phrase!("changes"))
}

/// One column for each campaign.
fn values(compare: &CompareDocument, trends: &[&CompareTrend], words: &Words) -> Table {
    let titles: Vec<String> = (1..=compare.campaigns.len()).map(|i| format!("{i} [95 %]")).collect();
    let first = Columns::<&CompareTrend>::new().page(phrase!("quantity"), "", |t| quantity(t, words)).page(
        phrase!("unit"),
        "",
        |t| unit(&t.unit),
    );
    let columns = titles.iter().enumerate().fold(first, |columns, (i, title)| {
        columns.page(title.as_str(), "", move |t| numbers(t.values.get(i).map(|v| value(v, words))))
    });
    Table::new(words, trends, columns).repeating(2)
}

fn all_values(trends: &[&CompareTrend], words: &Words) -> Table {
    type Row<'a> = (&'a CompareTrend, usize, &'a CompareValue);
    let rows: Vec<Row> =
        trends.iter().flat_map(|t| t.values.iter().enumerate().map(move |(i, v)| (*t, i + 1, v))).collect();
    let columns = Columns::<Row>::new()
        .sheet(phrase!("head-family"), "", |(t, ..)| family(t.family, words))
        .sheet(phrase!("quantity"), "", |(t, ..)| t.name.english())
        .sheet(phrase!("unit"), "", |(t, ..)| t.unit.as_str())
        .sheet(phrase!("campaign"), "", |(_, i, _)| *i)
        .sheet(phrase!("value"), "", |(.., v)| v.value)
        .sheet("u (k = 1)", "", |(.., v)| v.standard_uncertainty)
        .sheet(phrase!("interval-from"), "", |(.., v)| v.low)
        .sheet(phrase!("interval-to"), "", |(.., v)| v.high);
    Table::new(words, &rows, columns).on(phrase!("sheet-values"))
}

/// First box: style and sentence.
pub(crate) fn verdict(compare: &CompareDocument, words: &Words) -> Verdict {
    const NAMED: usize = 6;
    // mean positions also move when a frame is measured again, so that they do not belong to the
    // robot alone
    let robot = |t: &&CompareTrend| !matches!(t.family, CompareFamily::SetUp | CompareFamily::MeanPosition);
    let of = |t: &CompareTrend| t.changes.iter().any(|c| c.significant == Some(true));
    let name = |t: &CompareTrend| isolated(&quantity(t, words));
    let changed: Vec<String> = compare.trends.iter().filter(robot).filter(|t| of(t)).map(name).collect();
    let judged = |t: &&CompareTrend| t.changes.iter().any(|c| c.significant.is_some());
    let all = compare.trends.iter().filter(robot).filter(judged).count();
    let (class, found) = match (changed.is_empty(), compare.together.iter().any(|t| t.significant)) {
        (true, false) => (Grade::Good, tr!(words, "no-quantity-changed", total = all)),
        (true, true) => (Grade::Open, tr!(words, "robot-changed-as-a-whole")),
        (false, _) => {
            let first = changed.iter().take(NAMED).cloned().collect::<Vec<_>>().join(", ");
            let more = if changed.len() > NAMED { ", ..." } else { "" };
            let named = format!("{first}{more}");
            (Grade::Open, tr!(words, "quantities-changed", changed = changed.len(), total = all, names = named))
        }
    };
    let known = |t: &&CompareTrend| t.changes.iter().any(|c| c.low.is_some());
    let unjudged = || compare.trends.iter().filter(robot).filter(|t| !judged(t));
    let (misfits, unjudged) = (unjudged().filter(known).count(), unjudged().filter(|t| !known(t)).count());
    let unknown = tr!(words, "unjudged-without-uncertainty", count = unjudged);
    let misfit = tr!(words, "unjudged-by-misfit", count = misfits);
    let moved = compare.trends.iter().any(|t| t.family == CompareFamily::MeanPosition && of(t));
    let elsewhere = tr!(words, "mean-positions-changed");
    let more: Vec<String> = [(unjudged > 0, unknown), (misfits > 0, misfit), (moved, elsewhere)]
        .into_iter()
        .filter(|m| m.0)
        .map(|m| m.1)
        .collect();
    let class = if more.is_empty() { class } else { Grade::Open };
    let sentence = std::iter::once(found).chain(more).collect::<Vec<_>>().join(" ");
    let frames = || compare.trends.iter().filter(|t| t.family == CompareFamily::SetUp).filter(judged);
    let frames_changed = frames().filter(|t| of(t)).count();
    let frames =
        (frames_changed > 0).then(|| tr!(words, "set-up-changes", changed = frames_changed, total = frames().count()));
    let mut sentences = differences(compare, words);
    sentences.push(sentence);
    sentences.extend(frames);
    Verdict { class, met: true, sentences, ..Verdict::default() }
}

fn together(t: &CompareTogether, words: &Words) -> String {
    let degrees = t.degrees_of_freedom.map_or_else(|| "∞".to_owned(), |d| number::significant(d, 3));
    let (f, p) = (number::significant(t.f, 3), number::p_value(t.p));
    match t.significant {
        true => tr!(
            words,
            "robot-changed-together",
            to = t.to,
            from = t.from,
            parameters = t.parameters,
            f,
            degrees_of_freedom = degrees,
            probability = p
        ),
        false => tr!(
            words,
            "robot-unchanged-together",
            to = t.to,
            from = t.from,
            parameters = t.parameters,
            f,
            degrees_of_freedom = degrees,
            probability = p
        ),
    }
}

//! Plan: poses to measure, shortfall from the optimum, and expected results of a calibration with
//! them.

use super::provenance::{Evaluated, section_from_provenance};
use crate::model::{
    Block, Cell, Columns, Grade, Section, Table, Text, Verdict, fixed, number_cell, significant as digits, term,
};
use crate::number::{self, significant, stated};
use crate::plots::{chosen, curve, map, parameter_errors, points};
use crate::words::{Words, tr};
use etalon_base::phrase;
use etalon_base::pose_name::PoseName;
use etalon_documents::{
    PlanDocument, PlannedParameter, PointError, PoseSet, StudiedParameter, StudiedPlace, StudyDocument, StudyStep,
};
use std::collections::BTreeMap;

/// Quality of the choice.
pub(crate) fn verdict(plan: &PlanDocument, words: &Words) -> Verdict {
    let chosen = plan.choice.chosen.len();
    let (class, sentence) = match plan.optimality.at_most_below_percent {
        _ if plan.optimality.proven_optimal => {
            (Grade::Good, tr!(words, "choice-proven", chosen, candidates = plan.choice.candidates, index = plan.index))
        }
        Some(below) => (
            Grade::Open,
            tr!(
                words,
                "choice-within-percent",
                index = plan.index,
                percent = significant(below, 2),
                chosen,
                candidates = plan.choice.candidates
            ),
        ),
        None => (Grade::Open, tr!(words, "choice-without-bound", index = plan.index)),
    };
    Verdict { class, met: true, sentences: vec![sentence], ..Verdict::default() }
}

/// Sections in the order of reading.
pub(crate) fn sections(plan: &PlanDocument, words: &Words) -> Vec<Section> {
    let mut chosen = Section::new("chosen", tr!(words, "choice"));
    chosen.push(Block::facts(facts(plan, words)));
    let mut pictures = Section::new("pictures", tr!(words, "how-many-and-where"));
    pictures.figures(curve::curve(plan, words).into_iter().chain(chosen::map(plan, words)));
    let mut parameters = Section::new("parameters", tr!(words, "predicted-uncertainty-title"));
    parameters.push(Block::Table(predicted(plan, words)));
    let parameters = parameters.on_terminal();
    let mut all = vec![
        chosen.on_terminal(),
        super::messages::section_from_messages(&plan.messages.iter().collect::<Vec<_>>(), words),
    ];
    all.extend([pictures, poses(plan, words), parameters].into_iter().filter_map(Section::whole));
    all.extend(plan.study.as_ref().map(|s| study(s, words)));
    all.push(section_from_provenance(&plan.provenance, Evaluated::IDENTIFICATION, &[], words));
    all.push(super::operator_sheet::section(plan, words));
    all
}

fn facts(plan: &PlanDocument, words: &Words) -> Vec<(String, Cell)> {
    let list = |poses: &[PoseName]| poses.iter().map(PoseName::to_string).collect::<Vec<_>>().join(", ");
    let configurations: usize = plan.choice.chosen.iter().map(|p| p.configurations.len()).sum();
    let chosen = match plan.grouped {
        true => tr!(words, "chosen-with-all-modes", poses = plan.choice.chosen.len(), configurations),
        false => tr!(words, "chosen-one-by-one", poses = plan.choice.chosen.len(), configurations),
    };
    let relaxed = plan.optimality.at_most_below_percent_by_relaxation;
    let compared = plan.optimality.compared.as_ref().map(|c| {
        let (value, better) = (significant(c.value, 6), significant(c.better_by_percent, 3));
        tr!(words, "plan-better-than", poses = list(&c.poses), value, percent = better)
    });
    let um = |mm: f64| significant(1e3 * mm, 3);
    let workspace = plan
        .prediction
        .workspace
        .as_ref()
        .map(|w| tr!(words, "rms-and-largest", rms = um(w.rms_mm), largest = um(w.max_mm)));
    let greedy = &plan.optimality.greedy;
    let order = plan.choice.order.as_ref().map(|order| {
        let poses = list(&plan.in_order().iter().map(|p| p.pose).collect::<Vec<_>>());
        let percent = significant(100.0 * order.motion / order.motion_as_listed, 3);
        tr!(words, "order-of-poses", poses, percent)
    });
    let order = order.filter(|_| plan.choice.order.as_ref().is_some_and(|order| order.motion_as_listed > 0.0));
    let generated = plan.choice.generated.as_ref().map(|g| {
        let (limits, region, sight) = (g.beyond_limits, g.outside_box, g.facing_away);
        let drawn =
            tr!(words, "candidates-drawn", candidates = plan.choice.candidates, draws = g.draws, limits, region, sight);
        let hidden = g.obstacles.iter().map(|o| tr!(words, "candidates-hidden", count = o.hidden, obstacle = &o.name));
        std::iter::once(drawn).chain(hidden).collect::<Vec<_>>().join(", ")
    });
    vec![
        (tr!(words, "index"), format!("{} = {}", plan.index, significant(plan.optimality.value, 6)).into()),
        (tr!(words, "definition"), Text::worded(&plan.definition, words).into()),
        (tr!(words, "chosen"), chosen.into()),
        (tr!(words, "report-poses"), list(&plan.choice.chosen.iter().map(|p| p.pose).collect::<Vec<_>>()).into()),
        (
            tr!(words, "candidates"),
            tr!(
                words,
                "candidates-and-configurations",
                candidates = plan.choice.candidates,
                configurations = plan.choice.configurations
            )
            .into(),
        ),
        (tr!(words, "generated-candidates"), generated.into()),
        (tr!(words, "measuring-order"), order.into()),
        (
            tr!(words, "relaxation-alone"),
            relaxed
                .map(|r| match significant(r, 3).as_str() {
                    "0" => tr!(words, "best-possible-choice"),
                    below => tr!(words, "choice-gap", percent = below),
                })
                .into(),
        ),
        (tr!(words, "branch-and-bound-nodes"), relaxed.map(|_| plan.optimality.nodes.to_string()).into()),
        (
            tr!(words, "one-after-the-other"),
            tr!(
                words,
                "index-value-of-poses",
                index = plan.index,
                value = significant(greedy.value, 6),
                poses = list(&greedy.poses)
            )
            .into(),
        ),
        (tr!(words, "compared-with"), compared.into()),
        (tr!(words, "condition-number"), digits(plan.prediction.observability.as_ref().map(|o| o.condition), 4)),
        (tr!(words, "predicted-target-uncertainty"), workspace.into()),
    ]
}

fn poses(plan: &PlanDocument, words: &Words) -> Section {
    type Row<'a> = (PoseName, &'a BTreeMap<String, f64>);
    let in_order = plan.in_order().into_iter();
    let rows: Vec<Row> = in_order.flat_map(|p| p.configurations.iter().map(move |c| (p.pose, c))).collect();
    let joints: Vec<&str> = rows.iter().take(1).flat_map(|(_, c)| c.keys().map(String::as_str)).collect();
    // assembly modes are integers
    let cell = |v: &f64| fixed(*v, if v.fract() == 0.0 { 0 } else { 4 });
    let first = Columns::<Row>::new().both(phrase!("pose"), "", |(pose, _)| *pose);
    let columns =
        joints.iter().fold(first, |columns, joint| columns.both(*joint, "", move |(_, c)| c.get(*joint).map(cell)));
    let mut section = Section::new("poses", tr!(words, "chosen-poses"));
    section.push(Block::Table(Table::new(words, &rows, columns).on(phrase!("chosen-poses"))));
    section
}

fn predicted(plan: &PlanDocument, words: &Words) -> Table {
    let u = |p: &PlannedParameter| match p.standard_uncertainty {
        _ if !p.identifiable => term(words, phrase!("not-identifiable")),
        Some(u) => digits(u, 3),
        None => term(words, phrase!("no-noise-stated")),
    };
    let columns = Columns::<PlannedParameter>::new()
        .both(phrase!("name"), "", |p| p.name.as_str())
        .both(phrase!("unit"), "", |p| p.unit.as_str())
        .both(phrase!("predicted-u"), "", u)
        .both(phrase!("correlated-with"), "", |p| p.confounded_with.join(", "));
    Table::new(words, &plan.prediction.parameters, columns).on(phrase!("parameters-title"))
}

fn study(document: &StudyDocument, words: &Words) -> Section {
    let mut section = Section::new("study", tr!(words, "simulated-calibration-title"));
    section.push(Block::note(tr!(
        words,
        "simulated-calibration-note",
        noise = stated(document.noise_um),
        identifications = document.runs,
        medians = document.draws,
        configurations = document.configurations,
        point = words.worded(&document.point)
    )));
    let columns = Columns::<StudiedParameter>::new()
        .both(phrase!("name"), "", |p| p.name.as_str())
        .both(phrase!("unit"), "", |p| p.unit.as_str())
        .both(phrase!("nominal"), "", |p| fixed(p.nominal, 4))
        .both(phrase!("true"), "", |p| fixed(p.actual, 4))
        .both(phrase!("identified"), "", |p| fixed(p.identified, 4))
        .both(phrase!("identified-minus-true"), "", |p| fixed(p.identified - p.actual, 5));
    let table = Table::new(words, &document.parameters, columns).on(phrase!("sheet-study-parameters"));
    section.table(tr!(words, "parameters-title"), "", table);
    let um = |mm: f64| number_cell(mm, |mm| number::fixed(1e3 * mm, 2));
    let columns = Columns::<StudyStep>::new()
        .both(phrase!("positions"), "", |s| s.positions)
        .both(phrase!("configurations"), "", |s| s.configurations)
        .both(phrase!("rms-before"), "mm", |s| fixed(s.rms_before_mm, 3))
        .both(phrase!("max-before"), "mm", |s| fixed(s.max_before_mm, 3))
        .both(phrase!("rms-after"), "mm", move |s| um(s.rms_mm))
        .in_unit("µm")
        .both(phrase!("max-after"), "mm", move |s| um(s.max_mm))
        .in_unit("µm");
    let table = Table::new(words, &document.steps, columns).on(phrase!("sheet-study-positions"));
    section.table(tr!(words, "errors-by-number-of-positions"), "", table);
    let errors: Vec<PointError> = document.places.iter().map(|place| error(place, words)).collect();
    let drawable = points::drawable(&errors);
    let planar = errors.iter().all(|e| e.at_mm[2] == 0.0);
    let mut figures = parameter_errors::pictures(document, words);
    if !drawable.is_empty() {
        figures.extend(map::maps(&drawable, planar, words).into_iter().flatten());
    }
    section.push(Block::heading(tr!(words, "pictures-of-thesis")));
    section.figures(figures);
    section
}

/// Largest error of a place as a mark of a map.
fn error(place: &StudiedPlace, words: &Words) -> PointError {
    PointError {
        quantity: Default::default(),
        set: PoseSet::Validation,
        pose: place.pose,
        cycle: 1,
        target: tr!(words, "largest-of-all-modes"),
        at_mm: place.at_mm,
        before_mm: [place.max_before_mm, 0.0, 0.0],
        after_mm: [place.max_mm, 0.0, 0.0],
        before_deg: None,
        after_deg: None,
        joints: Vec::new(),
        control: Default::default(),
    }
}

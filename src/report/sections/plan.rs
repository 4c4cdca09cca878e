//! Plan: poses to measure, shortfall from the optimum, and expected results of a calibration with
//! them.

use crate::model::{
    Block, Cell, Columns, Grade, Section, Table, Text, Verdict, fixed, shown, significant as digits, term,
};
use crate::number::{self, significant, stated};
use crate::plots::{chosen, curve, map, parameter_errors, points};
use crate::words::Words;
use etalon_base::pose_name::PoseName;
use etalon_documents::{
    PlanDocument, PlannedParameter, PointError, PoseSet, StudiedParameter, StudiedPlace, StudyDocument, StudyStep,
};
use std::collections::BTreeMap;

/// Quality of the choice.
pub(crate) fn verdict(plan: &PlanDocument, words: &Words) -> Verdict {
    let chosen = plan.chosen.len();
    let (class, sentence) = match plan.at_most_below_percent {
        _ if plan.proven_optimal => (
            Grade::Good,
            words.fill(
                "Proven: no other choice of {0} of {1} candidates has a larger {2}",
                &[&chosen, &plan.candidates, &plan.index],
            ),
        ),
        Some(below) => (
            Grade::Open,
            words.fill(
                "{0} is at most {1} % below the best possible choice of {2} of {3} candidates",
                &[&plan.index, &significant(below, 2), &chosen, &plan.candidates],
            ),
        ),
        None => (Grade::Open, words.fill("No bound is known for {0}: another choice may be better", &[&plan.index])),
    };
    Verdict { class, met: true, sentences: vec![sentence], ..Verdict::default() }
}

/// Sections in the order of reading.
pub(crate) fn sections(plan: &PlanDocument, words: &Words) -> Vec<Section> {
    let mut chosen = Section::new("chosen", words.say("Choice"));
    chosen.push(Block::facts(facts(plan, words)));
    let mut pictures = Section::new("pictures", words.say("How many, and where"));
    pictures.figures(curve::curve(plan, words).into_iter().chain(chosen::map(plan, words)));
    let mut parameters = Section::new("parameters", words.say("Predicted uncertainty of the parameters"));
    parameters.push(Block::Table(predicted(plan, words)));
    let parameters = parameters.on_terminal();
    let mut all = vec![chosen.on_terminal(), super::messages::of(&plan.messages.iter().collect::<Vec<_>>(), words)];
    all.extend([pictures, poses(plan, words), parameters].into_iter().filter_map(Section::whole));
    all.extend(plan.study.as_ref().map(|s| study(s, words)));
    all.push(super::provenance::of(&plan.provenance, &[], words));
    all
}

fn facts(plan: &PlanDocument, words: &Words) -> Vec<(String, Cell)> {
    let list = |poses: &[PoseName]| poses.iter().map(PoseName::to_string).collect::<Vec<_>>().join(", ");
    let configurations: usize = plan.chosen.iter().map(|p| p.configurations.len()).sum();
    let count: [&dyn std::fmt::Display; 2] = [&plan.chosen.len(), &configurations];
    let chosen = match plan.grouped {
        true => words.fill("{0} poses, {1} configurations, all working modes of a pose together", &count),
        false => words.fill("{0} poses, {1} configurations, one by one", &count),
    };
    let relaxed = plan.at_most_below_percent_by_relaxation;
    let compared = plan.compared.as_ref().map(|c| {
        let (value, better) = (significant(c.value, 6), significant(c.better_by_percent, 3));
        words.fill("poses {0}: {1}, the plan is {2} % better", &[&list(&c.poses), &value, &better])
    });
    let um = |mm: f64| significant(1e3 * mm, 3);
    let workspace = plan
        .workspace
        .as_ref()
        .map(|w| words.fill("root mean square {0} µm, largest {1} µm", &[&um(w.rms_mm), &um(w.max_mm)]));
    let greedy = &plan.greedy;
    vec![
        (words.say("index"), format!("{} = {}", plan.index, significant(plan.value, 6)).into()),
        (words.say("definition"), Text::document(&plan.definition, words).into()),
        (words.say("chosen"), chosen.into()),
        (words.say("poses"), list(&plan.chosen.iter().map(|p| p.pose).collect::<Vec<_>>()).into()),
        (
            words.say("candidates"),
            words.fill("{0}, {1} configurations", &[&plan.candidates, &plan.configurations]).into(),
        ),
        (
            words.say("relaxation alone"),
            relaxed
                .map(|r| match significant(r, 3).as_str() {
                    "0" => words.say("the best possible choice"),
                    below => words.fill("at most {0} % below the best possible choice", &[&below]),
                })
                .into(),
        ),
        (words.say("nodes of branch and bound"), relaxed.map(|_| plan.nodes.to_string()).into()),
        (
            words.say("one after the other"),
            words
                .fill("{0} = {1}, poses {2}", &[&plan.index, &significant(greedy.value, 6), &list(&greedy.poses)])
                .into(),
        ),
        (words.say("compared with"), compared.into()),
        (words.say("condition number"), digits(plan.observability.as_ref().map(|o| o.condition), 4)),
        (words.say("predicted uncertainty of the targets over the candidates (k = 1)"), workspace.into()),
    ]
}

fn poses(plan: &PlanDocument, words: &Words) -> Section {
    type Row<'a> = (PoseName, &'a BTreeMap<String, f64>);
    let rows: Vec<Row> = plan.chosen.iter().flat_map(|p| p.configurations.iter().map(move |c| (p.pose, c))).collect();
    let joints: Vec<&str> = rows.iter().take(1).flat_map(|(_, c)| c.keys().map(String::as_str)).collect();
    // assembly modes are integers
    let cell = |v: &f64| fixed(*v, if v.fract() == 0.0 { 0 } else { 4 });
    let first = Columns::<Row>::new().both("pose", "", |(pose, _)| *pose);
    let columns =
        joints.iter().fold(first, |columns, joint| columns.both(joint, "", move |(_, c)| c.get(*joint).map(cell)));
    let mut section = Section::new("poses", words.say("Chosen poses"));
    section.push(Block::Table(Table::of(words, &rows, columns).on("Chosen poses")));
    section
}

fn predicted(plan: &PlanDocument, words: &Words) -> Table {
    let u = |p: &PlannedParameter| match p.standard_uncertainty {
        _ if !p.identifiable => term(words, "not identifiable"),
        Some(u) => digits(u, 3),
        None => term(words, "no noise stated"),
    };
    let columns = Columns::<PlannedParameter>::new()
        .both("name", "", |p| p.name.as_str())
        .both("unit", "", |p| p.unit.as_str())
        .both("predicted u (k = 1)", "", u)
        .both("correlated with", "", |p| p.confounded_with.join(", "));
    Table::of(words, &plan.parameters, columns).on("Parameters")
}

fn study(document: &StudyDocument, words: &Words) -> Section {
    let mut section = Section::new("study", words.say("A simulated calibration"));
    section.push(Block::note(words.fill("Synthetic: Gaussian noise of {0} µm on every coordinate, mean of {1} identifications; parameters and pictures are of one such mean, errors by the number of positions are medians of {2}; errors are those of {4}, evaluated over {3} configurations.", &[&stated(document.noise_um), &document.runs, &document.draws, &document.configurations, &words.say(&document.point)])));
    let columns = Columns::<StudiedParameter>::new()
        .both("name", "", |p| p.name.as_str())
        .both("unit", "", |p| p.unit.as_str())
        .both("nominal", "", |p| fixed(p.nominal, 4))
        .both("true", "", |p| fixed(p.actual, 4))
        .both("identified", "", |p| fixed(p.identified, 4))
        .both("identified − true", "", |p| fixed(p.identified - p.actual, 5));
    let table = Table::of(words, &document.parameters, columns).on("Study, parameters");
    section.table(words.say("Parameters"), "", table);
    let um = |mm: f64| shown(mm, |mm| number::fixed(1e3 * mm, 2));
    let columns = Columns::<StudyStep>::new()
        .both("positions", "", |s| s.positions)
        .both("configurations", "", |s| s.configurations)
        .both("RMS before", "mm", |s| fixed(s.rms_before_mm, 3))
        .both("max before", "mm", |s| fixed(s.max_before_mm, 3))
        .both("RMS after", "mm", move |s| um(s.rms_mm))
        .shown_in("µm")
        .both("max after", "mm", move |s| um(s.max_mm))
        .shown_in("µm");
    let table = Table::of(words, &document.steps, columns).on("Study, positions");
    section.table(words.say("Errors of position by the number of positions"), "", table);
    let errors: Vec<PointError> = document.places.iter().map(|place| error(place, words)).collect();
    let drawable = points::drawable(&errors);
    let planar = errors.iter().all(|e| e.at_mm[2] == 0.0);
    let mut figures = parameter_errors::pictures(document, words);
    if !drawable.is_empty() {
        figures.extend(map::maps(&drawable, planar, words));
    }
    section.push(Block::heading(words.say("Pictures (figures 4.8 and 4.9)")));
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
        target: words.say("largest of all working modes"),
        at_mm: place.at_mm,
        before_mm: [place.max_before_mm, 0.0, 0.0],
        after_mm: [place.max_mm, 0.0, 0.0],
        before_deg: None,
        after_deg: None,
        joints: Vec::new(),
        reliability: None,
        own_redundancy: None,
    }
}

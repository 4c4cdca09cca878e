//! Errors before and after calibration: by set of poses, by pose, by point, and in figures.

use super::{region, relative};
use crate::coverage;
use crate::model::{
    Block, Columns, Figure, PAPER_ROWS, Section, Table, Text, fixed, number_cell, significant, term, yes_no,
};
use crate::number::{self, DisplayUnit};
use crate::plots::points::{self, after_mm, before_mm};
use crate::plots::{against, arrows, by_pose, histogram, map, overlay, prediction};
use crate::words::{Words, tr};
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_documents::{
    AccuracyDocument, AccuracySet, EffectProof, ErrorQuantity, ErrorStatistics, IdentifiedDocuments, MapNode,
    ParametersDocument, PointError, PoseSet, Results, SelfLocated, Statistics, ToolAccuracy,
};
use std::collections::BTreeMap;

pub(super) fn section(results: &Results, words: &Words) -> Option<Section> {
    let IdentifiedDocuments { accuracy, errors, parameters, .. } = results.identified.as_ref()?;
    let robust = parameters.robust.as_ref();
    let outliers = robust.map(|found| (&found.poses[..], found.critical_residual));
    let flagged = outliers.into_iter().flat_map(|(poses, critical)| {
        poses.iter().filter(move |p| p.residual_over_sigma > critical).map(|p| (p.pose, p.residual_over_sigma))
    });
    let mut section = with_flagged(accuracy, false, errors, &flagged.collect(), words);
    insert_file_errors(&mut section, results, words);
    section.whole()
}

/// Inserts the errors with the values of the file that is judged, before those with all identified
/// parameters.
pub(super) fn insert_file_errors(section: &mut Section, results: &Results, words: &Words) {
    let Some((file, values)) = results.judged_file() else { return };
    let (Some(identified), Some(set)) = (&results.identified, &values.deciding_set) else { return };
    let name = words.tr(&set.name.phrase());
    let names = [phrase!("before"), phrase!("after")];
    section.begin(Block::heading(tr!(words, "errors-with-all-parameters")));
    section.begin(Block::Table(statistics(&identified.accuracy, set, set.name.name(), names, words)));
    section.begin(Block::heading(tr!(words, "errors-with-file", file = file.file, set = name, poses = set.poses)));
}

/// Returns the section of these errors.
pub(crate) fn section_from_errors(accuracy: &AccuracyDocument, errors: &[PointError], words: &Words) -> Section {
    with_flagged(accuracy, true, errors, &Flagged::new(), words)
}

/// Calibration poses that disagree with the others, with their residual over σ.
type Flagged = BTreeMap<PoseName, f64>;

/// Section of the errors, of all sets if `whole`, otherwise of the set that decides.
fn with_flagged(
    accuracy: &AccuracyDocument,
    whole: bool,
    errors: &[PointError],
    flagged: &Flagged,
    words: &Words,
) -> Section {
    let mut section = Section::new("errors", tr!(words, "errors-before-and-after"));
    section.summarise(tr!(words, "definition-of-errors"), Text::worded(&accuracy.definition, words), "");
    section.push(Block::detail(Text::worded(&accuracy.definition, words)));
    if accuracy.sets.is_empty() {
        section.push(Block::text(tr!(words, "no-errors-are-given")));
    }
    for set in accuracy.sets.iter().filter(|set| whole || is_deciding(accuracy, set)) {
        push_set(&mut section, accuracy, set, words);
    }
    if let Some(set) = accuracy.sets.last() {
        section.push(Block::note(coverage::sentences(accuracy, set, words)));
    }
    if !accuracy.placed_apart.is_empty() {
        section.push(Block::text(placed_by_validation(&accuracy.placed_apart, words)));
    }
    if !accuracy.effects.is_empty() {
        section.push(Block::heading(tr!(words, "proven-effects")));
        section.push(Block::Table(effects(&accuracy.effects, words)));
    }
    if let Some(p) = accuracy.given.as_ref().and_then(|given| given.p_value) {
        let p = number::p_value(p);
        section.push(Block::text(tr!(words, "probability-of-errors", probability = p)));
    }
    if let Some(distance) = &accuracy.validation_distance {
        section.push(Block::text(region::validation_region(distance, words)));
        section.push(Block::text(region::readings_sentence(accuracy, words)));
    }
    if let Some(relative) = &accuracy.relative {
        relative::push(&mut section, relative, words);
    }
    if let Some(tool) = accuracy.tool.as_ref().filter(|_| whole) {
        push_tool(&mut section, accuracy, tool, words);
    }
    let table = poses(errors, flagged, words);
    if !table.is_empty() {
        let title = match table.rows.len() > PAPER_ROWS {
            true if flagged.is_empty() => tr!(words, "largest-errors-of-poses"),
            true => tr!(words, "outliers-then-largest-errors"),
            false => tr!(words, "errors-of-each-pose"),
        };
        section.push(Block::Aside { title, blocks: vec![Block::Table(table)] });
    }
    section.push(Block::Table(residuals(errors, words)));
    section.push(Block::Table(nodes(accuracy, words)));
    section.on_terminal()
}

/// `true` for the set whose errors decide: the last one.
fn is_deciding(accuracy: &AccuracyDocument, set: &AccuracySet) -> bool {
    accuracy.sets.last().is_some_and(|last| last.name == set.name)
}

/// Adds the errors of a set.
fn push_set(section: &mut Section, accuracy: &AccuracyDocument, set: &AccuracySet, words: &Words) {
    section.push(Block::heading(heading(accuracy, set, words)));
    let names = [phrase!("before"), phrase!("after")];
    section.push(Block::Table(statistics(accuracy, set, set.name.name(), names, words).on(phrase!("sheet-errors"))));
}

/// Annex with the errors of the sets that do not decide, and at the tool point.
pub(super) fn other_sets(results: &Results, words: &Words) -> Option<Section> {
    let accuracy = &results.identified.as_ref()?.accuracy;
    let mut section = Section::new("other-errors", tr!(words, "errors-that-do-not-decide"));
    for set in accuracy.sets.iter().filter(|set| !is_deciding(accuracy, set)) {
        push_set(&mut section, accuracy, set, words);
    }
    if let Some(tool) = &accuracy.tool {
        push_tool(&mut section, accuracy, tool, words);
    }
    section.on_terminal().whole()
}

/// Heading of the errors of a set.
fn heading(accuracy: &AccuracyDocument, set: &AccuracySet, words: &Words) -> String {
    let name = words.tr(&set.name.phrase());
    match accuracy.point.english() {
        "" => tr!(words, "set-summary", set = name, poses = set.poses, errors = set.count),
        _ => {
            let point = words.worded(&accuracy.point);
            tr!(words, "set-summary-of", set = name, poses = set.poses, errors = set.count, point)
        }
    }
}

/// Sentence on targets that are located by validation poses alone.
fn placed_by_validation(placed: &[SelfLocated], words: &Words) -> String {
    let of = |p: &SelfLocated| match p.is_assessed {
        true => tr!(
            words,
            "readings-redundancy",
            target = p.name,
            readings = p.readings,
            redundancy = number::fixed(p.redundancy, 2)
        ),
        false => tr!(
            words,
            "readings-not-judged",
            target = p.name,
            readings = p.readings,
            redundancy = number::fixed(p.redundancy, 2)
        ),
    };
    let all: Vec<String> = placed.iter().map(of).collect();
    tr!(words, "targets-placed-by-validation", targets = all.join(", "))
}

/// Adds the errors at the tool point.
fn push_tool(section: &mut Section, accuracy: &AccuracyDocument, tool: &ToolAccuracy, words: &Words) {
    section.push(Block::heading(tr!(words, "at-tool-point", count = tool.poses)));
    let of_tool = ErrorStatistics {
        quantity: ErrorQuantity::Position,
        count: tool.poses,
        poses: tool.poses,
        unit: "mm".to_owned(),
        before: tool.before,
        after: tool.after,
        expanded_uncertainty: None,
    };
    let set = AccuracySet {
        name: tool.set,
        poses: tool.poses,
        count: tool.poses,
        errors: vec![of_tool],
        readings: Vec::new(),
    };
    // the base has no effect here: these errors differ from the errors of the sets before and
    // after calibration
    let names = [phrase!("nominal-minus-identified"), phrase!("expected")];
    section.push(Block::Table(statistics(accuracy, &set, "tool point", names, words).on(phrase!("sheet-tool-point"))));
    let um = |mm: f64| number::significant(1e3 * mm, 3);
    section.push(Block::text(tr!(
        words,
        "tool-point-expected",
        parameters = um(tool.parameters_mm),
        model = um(tool.model_mm),
        point = um(tool.place_mm),
        largest = um(tool.expanded_max_mm),
        undetermined = um(tool.held_mm),
    )));
    section.push(Block::detail(Text::worded(&tool.definition, words)));
}

/// Maximum number of trends in addition to the other figures, the most significant first.
const TRENDS: usize = 1;

/// Figures of the errors.
pub(super) fn pictures(results: &Results, words: &Words) -> Option<Section> {
    let identified = results.identified.as_ref()?;
    let errors = identified.errors.as_slice();
    let mut section = Section::new("pictures", tr!(words, "pictures"));
    let drawable = points::drawable(errors);
    let planar = points::planar(&drawable, results.frames.world.planar);
    if drawable.is_empty() {
        section.push(Block::text(tr!(words, "no-error-to-draw")));
        return section.whole();
    }
    let selection = (drawable.len() > points::MARKS).then(|| tr!(words, "picture-selection"));
    let notes = [Some(tr!(words, "picture-marks")), selection, Some(tr!(words, "picture-page-command"))];
    section.push(Block::note(notes.into_iter().flatten().collect::<Vec<_>>().join(" ")));
    let undrawn = errors.len() - drawable.len();
    if undrawn > 0 {
        let note = tr!(words, "errors-not-drawn", count = undrawn);
        section.push(Block::note(note));
    }
    let accuracy = &identified.accuracy;
    let maps = map::maps(&drawable, planar, words);
    let expected = accuracy.map.iter().flat_map(|map| prediction::pictures(map, planar, words)).collect();
    let vectors = arrows::arrows(&drawable, planar, words);
    // space, or the first plane, of the first quantity; the other views are folded
    let (mut figures, mut more) = (Vec::new(), Vec::new());
    let mut maps = maps.into_iter();
    let first = maps.next().unwrap_or_default();
    for (views, first) in [(first, !planar), (vectors, false)] {
        let shown = if first { views.len().saturating_sub(2) } else { 0 };
        for (i, figure) in views.into_iter().enumerate() {
            if (shown..shown + 2).contains(&i) { figures.push(figure) } else { more.push(figure) }
        }
    }
    more.extend(maps.flatten());
    more.extend::<Vec<Figure>>(expected);
    let at = figures.len().min(2);
    // the first quantity that was measured; others are folded
    let mut overlaid = overlay::pictures(&drawable, &accuracy.limits, words).into_iter();
    figures.splice(at..at, overlaid.next());
    let mut more_of_errors: Vec<Figure> = overlaid.collect();
    more_of_errors.extend(histogram::histograms(&drawable, &accuracy.limits, words));
    more_of_errors.extend(by_pose::pictures(&drawable, &accuracy.limits, words));
    let data = against::Data {
        errors: &drawable,
        joints: &accuracy.joints,
        base_mm: base_mm(&identified.parameters),
        limits: &accuracy.limits,
        trends: &accuracy.trends,
    };
    let [mut significant, insignificant] = against::pictures(&data, words);
    let others = if significant.is_empty() { "no" } else { "yes" };
    let weaker = significant.split_off(significant.len().min(TRENDS));
    figures.extend(significant);
    section.figures(figures);
    let folded = |figures| vec![Block::Figures { figures }];
    section.push(Block::Aside { title: tr!(words, "other-planes"), blocks: folded(more) });
    section.push(Block::Aside { title: tr!(words, "errors-by-set-and-pose"), blocks: folded(more_of_errors) });
    section.push(Block::Aside { title: tr!(words, "weaker-trends"), blocks: folded(weaker) });
    section.push(Block::Aside { title: tr!(words, "no-trend-pictures", others), blocks: folded(insignificant) });
    section.whole()
}

/// Origin of the base in the frame of the errors, if its parameters place a base in the world.
fn base_mm(parameters: &ParametersDocument) -> Option<Vector> {
    let value = |name: &str| parameters.parameters.iter().find(|p| p.name == name).map(|p| p.value);
    Some([value("base_x")?, value("base_y")?, value("base_z")?])
}

/// Table of mean, RMS, 95 % and maximum of all quantities of a set. `called` is the name of the set
/// in the workbook, `names` are the names of the two errors.
fn statistics(
    accuracy: &AccuracyDocument,
    set: &AccuracySet,
    called: &str,
    [before, after]: [Phrase; 2],
    words: &Words,
) -> Table {
    // a common unit for all lengths makes rows and sets comparable
    let lengths = accuracy.sets.iter().flat_map(|s| &s.errors).filter(|e| e.unit == "mm");
    let largest_mm = lengths.map(|e| e.before.max.max(e.after.max)).fold(0.0, f64::max);
    let cell = move |e: &ErrorStatistics, value: f64| {
        let factor = number::display_unit(&e.unit, largest_mm).factor;
        number_cell(value, |v| number::fixed(v * factor, decimals(accuracy, &e.unit, largest_mm)))
    };
    let unit = move |e: &ErrorStatistics| {
        let DisplayUnit { unit, .. } = number::display_unit(&e.unit, largest_mm);
        if unit.is_empty() { e.unit.clone() } else { unit.to_owned() }
    };
    let ratio = |e: &ErrorStatistics| {
        let ratio = e.before.rms / e.after.rms;
        ratio.is_finite().then(|| number_cell(ratio, |r| number::significant(r, 2)))
    };
    // some quantities rest on a part of the readings
    let differs = set.errors.iter().any(|e| e.count != set.count);
    let columns = Columns::<ErrorStatistics>::new()
        .sheet(phrase!("set"), "", |_| called)
        .sheet(phrase!("report-poses"), "", |e| set.counts(e)[0])
        .sheet(phrase!("errors"), "", |e| e.count)
        .sheet(phrase!("quantity"), "", |e| e.quantity.as_ref())
        .sheet(phrase!("unit"), "", |e| e.unit.as_str())
        .page(phrase!("error"), "", |e| Text::name(&words.tr(&e.quantity.phrase())))
        .page(phrase!("unit"), "", unit);
    let columns = match differs {
        true => {
            columns.page(phrase!("report-poses"), "", |e| set.counts(e)[0]).page(phrase!("errors"), "", |e| e.count)
        }
        false => columns,
    };
    let columns = columns
        .both(phrase!("mean"), "", move |e| cell(e, e.before.mean))
        .both(phrase!("rms"), "", move |e| cell(e, e.before.rms))
        .both("95 %", "", move |e| cell(e, e.before.p95))
        .both(phrase!("max"), "", move |e| cell(e, e.before.max))
        .below(4, before)
        .both(phrase!("mean"), "", move |e| cell(e, e.after.mean))
        .both(phrase!("rms"), "", move |e| cell(e, e.after.rms))
        .both("95 %", "", move |e| cell(e, e.after.p95))
        .both(phrase!("max"), "", move |e| cell(e, e.after.max))
        .below(4, after)
        .both(phrase!("rms-ratio"), "", ratio);
    Table::new(words, &set.errors, columns)
}

/// Benefit of each effect at held-out poses.
fn effects(all: &[EffectProof], words: &Words) -> Table {
    let columns = Columns::<EffectProof>::new()
        .both(phrase!("effect"), "", |e| term(words, e.effect.phrase()))
        .both(phrase!("joints"), "", |e| Text::name(&e.joints.join(", ")))
        .both(phrase!("rms-without-it"), "mm", |e| fixed(e.without_mm, 4))
        .both(phrase!("rms-with-it"), "mm", |e| fixed(e.with_mm, 4))
        .both(phrase!("gain-over-u"), "", |e| fixed(e.gain_over_u, 1))
        .both(phrase!("identified"), "", |e| yes_no(words, e.is_identified));
    Table::new(words, all, columns).on(phrase!("sheet-proven-effects"))
}

/// Number of decimals in `unit`: two digits of the smallest uncertainty or, if unknown, three
/// digits of the smallest non-zero error after calibration.
fn decimals(accuracy: &AccuracyDocument, unit: &str, largest_mm: f64) -> usize {
    let factor = number::display_unit(unit, largest_mm).factor;
    let errors = accuracy.sets.iter().flat_map(|s| &s.errors).filter(|e| e.unit == unit);
    let expanded = errors.clone().filter_map(|e| e.expanded_uncertainty).map(|u| u * factor).reduce(f64::min);
    if let Some(decimals) = expanded.and_then(|u| number::decimals(u, 2)) {
        return decimals.min(6);
    }
    let all = |s: &Statistics| [s.mean, s.rms, s.p95, s.max];
    let after = errors.flat_map(|e| all(&e.after)).map(|v| v * factor).filter(|&v| v > 0.0);
    number::decimals(after.fold(f64::INFINITY, f64::min), 3).unwrap_or(1).clamp(1, 5)
}

/// Errors of a pose.
struct OfPose<'a> {
    set: PoseSet,
    pose: PoseName,
    errors: Vec<&'a PointError>,
}

impl OfPose<'_> {
    fn mean(&self, size: fn(&PointError) -> f64) -> f64 {
        self.errors.iter().map(|p| size(p)).sum::<f64>() / self.errors.len() as f64
    }

    fn largest(&self, size: fn(&PointError) -> Option<f64>) -> Option<f64> {
        // unlike `f64::max`, keeps NaN
        self.errors.iter().filter_map(|p| size(p)).map(f64::abs).max_by(f64::total_cmp)
    }
}

/// Mean and largest error of every pose; if not all fit on paper, outliers and then the largest
/// errors first, independent of their set.
fn poses(errors: &[PointError], flagged: &Flagged, words: &Words) -> Table {
    let mut by_pose: BTreeMap<(PoseSet, PoseName), Vec<&PointError>> = BTreeMap::new();
    for p in errors {
        by_pose.entry((p.set, p.pose)).or_default().push(p);
    }
    let mut rows: Vec<OfPose> = by_pose.into_iter().map(|((set, pose), errors)| OfPose { set, pose, errors }).collect();
    // a pose that was excluded from the fit cannot disagree with it
    let over_sigma = |row: &OfPose| flagged.get(&row.pose).copied().filter(|_| row.set == PoseSet::Calibration);
    if rows.len() > PAPER_ROWS {
        let largest = |row: &OfPose| row.largest(|p| Some(after_mm(p))).unwrap_or(0.0);
        let order = |row: &OfPose| (over_sigma(row).unwrap_or(0.0), largest(row));
        rows.sort_by(|a, b| {
            let (a, b) = (order(a), order(b));
            b.0.total_cmp(&a.0).then(b.1.total_cmp(&a.1))
        });
    }
    let largest = errors.iter().flat_map(|p| [before_mm(p), after_mm(p)]).fold(0.0, f64::max);
    let DisplayUnit { unit, factor } = number::display_unit("mm", largest);
    let length = move |v: Option<f64>| number_cell(v, |v| number::significant(v * factor, 3));
    let angle = |v: Option<f64>| number_cell(v, |v| number::significant(v, 3));
    // distances from sockets, wires or surfaces are no positions
    let [before_mean, before_max, after_mean, after_max] =
        match errors.iter().all(|p| p.quantity == ErrorQuantity::Position) {
            true => [
                phrase!("position-before-mean"),
                phrase!("position-before-max"),
                phrase!("position-after-mean"),
                phrase!("position-after-max"),
            ],
            false => [
                phrase!("error-before-mean"),
                phrase!("error-before-max"),
                phrase!("error-after-mean"),
                phrase!("error-after-max"),
            ],
        };
    let columns = Columns::<OfPose>::new()
        .sheet(phrase!("set"), "", |r| r.set.name())
        .both(phrase!("pose"), "", |r| r.pose)
        .page(phrase!("set"), "", |r| Text::name(&words.tr(&r.set.phrase())))
        .both(phrase!("errors"), "", |r| r.errors.len())
        .sheet(before_mean, "mm", |r| r.mean(before_mm))
        .both(before_max, "mm", move |r| length(r.largest(|p| Some(before_mm(p)))))
        .in_unit(unit)
        .sheet(after_mean, "mm", |r| r.mean(after_mm))
        .both(after_max, "mm", move |r| length(r.largest(|p| Some(after_mm(p)))))
        .in_unit(unit)
        .both(phrase!("orientation-before-max"), "deg", move |r| angle(r.largest(|p| p.before_deg)))
        .both(phrase!("orientation-after-max"), "deg", move |r| angle(r.largest(|p| p.after_deg)))
        .both(phrase!("residual-over"), "", move |r| significant(over_sigma(r), 2));
    Table::new(words, &rows, columns).on(phrase!("errors-of-each-pose")).without_empty_columns()
}

fn residuals(errors: &[PointError], words: &Words) -> Table {
    let columns = Columns::<PointError>::new()
        .sheet(phrase!("set"), "", |p| p.set.name())
        .sheet(phrase!("pose"), "", |p| p.pose)
        .sheet(phrase!("cycle"), "", |p| p.cycle)
        .sheet(phrase!("target"), "", |p| p.target.as_str())
        .sheet_xyz(["x", "y", "z"], "mm", |p| &p.at_mm)
        .sheet_xyz(["x", "y", "z"].map(|axis| phrase!("axis-before", axis)), "mm", |p| &p.before_mm)
        .sheet_xyz(["x", "y", "z"].map(|axis| phrase!("axis-after", axis)), "mm", |p| &p.after_mm)
        .sheet(phrase!("orientation-before"), "deg", |p| p.before_deg)
        .sheet(phrase!("orientation-after"), "deg", |p| p.after_deg);
    Table::new(words, errors, columns).on(phrase!("residuals-title"))
}

/// Map of the expected error for the workbook.
fn nodes(accuracy: &AccuracyDocument, words: &Words) -> Table {
    let columns = Columns::<MapNode>::new()
        .sheet_xyz(["x", "y", "z"], "mm", |n| &n.at_mm)
        .sheet(phrase!("nominal-minus-identified"), "mm", |n| n.before_mm)
        .sheet(phrase!("expected-of-parameters"), "mm", |n| n.parameters_mm)
        .sheet(phrase!("expected-standard"), "mm", |n| n.standard_uncertainty_mm)
        .sheet("95 %", "mm", |n| n.p95_mm);
    Table::new(words, accuracy.map.iter().flat_map(|map| &map.nodes), columns).on(phrase!("sheet-predicted-errors"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::point;
    use etalon_base::worded::Worded;

    fn set(name: PoseSet, errors: Vec<ErrorStatistics>) -> AccuracySet {
        AccuracySet { name, poses: 1, count: 1, errors, readings: Vec::new() }
    }

    fn errors(quantity: ErrorQuantity, before_mm: f64, after_mm: f64) -> ErrorStatistics {
        let of = |size: f64| Statistics { mean: 0.8 * size, rms: size, p95: 1.8 * size, max: 2.0 * size };
        let unit = "mm".to_owned();
        ErrorStatistics {
            quantity,
            count: 1,
            poses: 1,
            unit,
            before: of(before_mm),
            after: of(after_mm),
            expanded_uncertainty: None,
        }
    }

    /// Rows of a set's table as shown on a page.
    fn set_rows(all: Vec<ErrorStatistics>) -> Vec<Vec<String>> {
        let set = set(PoseSet::Validation, all);
        let document = AccuracyDocument {
            field: None,
            given: None,
            campaign: None,
            provenance: None,
            joints: vec![],
            trends: vec![],
            parameter_influences: vec![],
            schema: String::new(),
            point: Worded::default(),
            definition: Worded::default(),
            sets: vec![set.clone()],
            placed_apart: Vec::new(),
            effects: Vec::new(),
            left_out: None,
            validation_distance: None,
            relative: None,
            budget: Vec::new(),
            orientation_budget: None,
            limits: vec![],
            tool: None,
            map: None,
        };
        page_rows(&statistics(&document, &set, "validation", [phrase!("before"), phrase!("after")], &Words::default()))
    }

    fn page_rows(table: &Table) -> Vec<Vec<String>> {
        let page = serde_json::to_value(table).unwrap();
        let cell = |c: &serde_json::Value| c["text"][0]["text"].as_str().unwrap_or_default().to_owned();
        page["rows"].as_array().unwrap().iter().map(|r| r.as_array().unwrap().iter().map(cell).collect()).collect()
    }

    #[test]
    fn small_lengths_are_in_micrometres_with_the_digits_of_the_smallest() {
        let small = &set_rows(vec![errors(ErrorQuantity::Position, 0.4, 0.008)])[0];
        let expected =
            ["position", "µm", "320.00", "400.00", "720.00", "800.00", "6.40", "8.00", "14.40", "16.00", "50"];
        assert_eq!(small[..], expected);
        let large = &set_rows(vec![errors(ErrorQuantity::Position, 4.0, 0.008)])[0];
        assert_eq!((large[7].as_str(), large[1].as_str()), ("0.00800", "mm"));
        assert_eq!(set_rows(vec![errors(ErrorQuantity::Position, 0.4, 0.0)])[0][10], "");
    }

    #[test]
    fn numbers_in_one_unit_have_the_same_decimals_and_three_digits_after() {
        // a robot with a smaller error along x than in total: 0.1366 against a limit of 0.137
        let rows = set_rows(vec![errors(ErrorQuantity::Position, 2.0, 0.1366), errors(ErrorQuantity::X, 1.0, 0.0747)]);
        assert_eq!((rows[0][7].as_str(), rows[1][7].as_str()), ("0.1366", "0.0747"));
        assert_eq!(rows[0][3], "2.0000");
    }

    #[test]
    fn a_pose_has_the_largest_of_its_errors_and_long_tables_are_cut() {
        let two = [point(1, [0.0; 3], [0.3, 0.0, 0.0], [0.02, 0.0, 0.0]), point(1, [0.0; 3], [0.2; 3], [0.01; 3])];
        assert_eq!(
            page_rows(&poses(&two, &Flagged::new(), &Words::default())),
            [["1", "calibration", "2", "346", "20.0"]]
        );
        let many: Vec<_> =
            (0..600u32).map(|i| point(i64::from(i), [0.0; 3], [0.1; 3], [1e-5 * f64::from(i); 3])).collect();
        let table = poses(&many, &Flagged::new(), &Words::default());
        let page = serde_json::to_value(&table).unwrap();
        assert_eq!((table.rows.len(), page_rows(&table).len(), page["left_out"].as_u64()), (600, 500, Some(100)));
        let [first, last] = [0, 499].map(|i: usize| page_rows(&table)[i][0].clone());
        assert_eq!((first.as_str(), last.as_str()), ("599", "100"), "the largest are shown");
        assert!(poses(&[], &Flagged::new(), &Words::default()).is_empty());
    }
}

//! Verdict at the start of a report: compliance with the limits, and improvement of the robot.

use super::fit::criterion;
use super::limits::{judged, name, reached_within};
use super::repeatability::quarter_sentence;
use super::{clauses, page_one};
use crate::model::{Grade, Headline, Verdict, sentence};
use crate::number::{self, DisplayUnit};
use crate::words::{Words, names, tr};
use etalon_base::pose_name::PoseName;
use etalon_documents::{
    Acceptance, AccuracyDocument, AccuracySet, Characteristics, Conformity, ControllerErrors, ControllerFiles,
    DecisionRule, ErrorQuantity, Figure, IdentifiedDocuments, Iso9283Document, Iso9283Variation, Judged, LimitVerdict,
    Loading, ModelFit, ParametersDocument, PoseCharacteristic, PoseSet, Reason, Results, SeriesScatter, ToolAccuracy,
    ToolFrame, VerdictDocument, WrittenFile,
};

/// Title of the report: the tested characteristics.
pub(crate) fn title(tested: &Characteristics, words: &Words) -> String {
    let characteristics = clauses::tested_characteristics(tested, words);
    match characteristics.is_empty() {
        true => tr!(words, "iso9283-characteristics"),
        false => tr!(words, "iso9283-report", characteristics),
    }
}

/// Verdict on all judged items: plausibility of the result, characteristics of ISO 9283,
/// instrument, and all limits of the campaign.
pub(crate) fn verdict(results: &Results, words: &Words) -> Verdict {
    let (identified, tested) = (results.identified.as_ref(), &results.tested);
    let judgement = &results.verdict;
    let limits: Vec<&LimitVerdict> = judgement.limits.iter().collect();
    let judged_file = results.judged_file();
    let set_of_file = judged_file.and_then(|(_, values)| values.deciding_set.as_ref());
    let set = set_of_file.or_else(|| identified.and_then(|i| headline_set(&i.accuracy)));
    let mut sentences: Vec<String> = identified.and_then(|i| alarm(&i.parameters, words)).into_iter().collect();
    sentences.extend(named(judgement, words));
    let withheld = judgement.loading.as_ref().and_then(Loading::withheld);
    sentences.extend(withheld.map(|answer| sentence(&words.tr(&answer))));
    sentences.extend((limits.is_empty() && judgement.verdict.is_none()).then(|| counted(&limits, words)));
    sentences.extend(judged_file.and_then(|(file, values)| file_sentence(file, values, words)));
    sentences.extend(files_beyond_limits(results, words));
    sentences.extend(set.into_iter().flat_map(|set| errors(&limits, set, words)));
    // the reservation gives the ratio of the residuals
    let is_reserved = judgement.reasons.iter().any(|reason| matches!(reason, Reason::ModelDoesNotFit { .. }));
    sentences.extend(identified.and_then(|i| unexplained(i, is_reserved, words)));
    sentences.extend(identified.and_then(|i| Some(series(i.parameters.residuals.between_series?, words))));
    sentences.extend(characteristics(tested, words));
    // in a test alone, the sentences on characteristics state whether a limit is met
    sentences.extend((identified.is_some() && !limits.is_empty()).then(|| counted(&limits, words)));
    sentences.extend(reservations(judgement, words));
    let point = identified.map(|i| words.worded(&i.accuracy.point)).filter(|point| !point.is_empty());
    let about = set.map(|s| match &point {
        Some(point) => {
            tr!(words, "errors-before-after-of", point, set = words.tr(&s.name.phrase()))
        }
        None => tr!(words, "errors-before-after", set = words.tr(&s.name.phrase())),
    });
    // a platform without a given point has its centre, which nobody measured
    let is_stated = |tool: &&ToolAccuracy| tool.frame != ToolFrame::Platform || tool.point_mm != [0.0; 3];
    let tool = identified.and_then(|i| i.accuracy.tool.as_ref()).filter(is_stated);
    // all identified parameters give the expected error at the tool point
    let tool = tool.filter(|_| judged_file.is_none());
    let tool = tool.map(|tool| at_tool(tool, words));
    let shown = set.map_or_else(Vec::new, |set| before_after(&limits, set, words));
    let verdict = Verdict {
        class: Grade::from_verdict(judgement.verdict),
        met: judgement.passes(),
        sentences,
        about: about.unwrap_or_default(),
        headlines: headlines(shown.into_iter().chain(tool).collect()),
        ..Verdict::default()
    };
    page_one::complete(results, verdict, words)
}

/// The verdict by its name; `None` if nothing was judged.
fn named(judgement: &VerdictDocument, words: &Words) -> Option<String> {
    Some(match judgement.verdict? {
        Acceptance::Pass => tr!(words, "verdict-pass"),
        Acceptance::Conditional => tr!(words, "verdict-conditional"),
        Acceptance::Undecided => tr!(words, "verdict-undecided"),
        Acceptance::Fail => tr!(words, "verdict-fail"),
    })
}

/// Reservations under which a verdict applies.
fn reservations(judgement: &VerdictDocument, words: &Words) -> Option<String> {
    let all: Vec<String> = judgement.reasons.iter().filter_map(|r| reservation(r, words)).collect();
    (!all.is_empty()).then(|| tr!(words, "reservations", reasons = all.join("; ")))
}

/// Reservation in words; `None` for reasons that other sentences state.
fn reservation(reason: &Reason, words: &Words) -> Option<String> {
    let list = |poses: &[PoseName]| poses.iter().map(PoseName::to_string).collect::<Vec<_>>().join(", ");
    Some(match reason {
        Reason::GivenRefused => tr!(words, "reservation-given-refused"),
        Reason::FileRefused => tr!(words, "reservation-file-not-written"),
        Reason::InstrumentTooCoarse { poses } => {
            tr!(words, "reservation-instrument-too-coarse", count = poses.len(), poses = list(poses))
        }
        Reason::OpenWarnings { ids } => {
            let warnings = ids.iter().map(|id| format!("`{id}`")).collect::<Vec<_>>().join(", ");
            tr!(words, "reservation-open-warnings", count = ids.len(), warnings)
        }
        Reason::ModelDoesNotFit { times, set } => {
            // output folders of earlier versions do not contain the set
            let set = set.unwrap_or(PoseSet::Validation).name();
            tr!(words, "reservation-model-does-not-fit", times = number::significant(*times, 3), set)
        }
        Reason::ErrorsUnknown { calibration_mm, left_out_mm } => {
            let DisplayUnit { unit, factor } = number::display_unit("mm", *calibration_mm);
            let [calibration, left_out] =
                [calibration_mm, left_out_mm].map(|mm| format!("{} {unit}", number::significant(mm * factor, 3)));
            tr!(words, "reservation-errors-unknown", calibration, left_out)
        }
        Reason::SetUpUntested { count, flange_mm, flange_deg } => tr!(
            words,
            "reservation-set-up-untested",
            count,
            flange_mm = number::significant(*flange_mm, 2),
            flange_deg = number::significant(*flange_deg, 2)
        ),
        Reason::NoWarmUp => tr!(words, "reservation-no-warm-up"),
        Reason::DriftNotSettled { poses, dap_mm } => tr!(
            words,
            "reservation-drift",
            change = number::fixed(1e3 * dap_mm, 0),
            count = poses.len(),
            poses = list(poses)
        ),
        Reason::FewCycles { poses, required } => {
            tr!(words, "reservation-few-cycles", required, count = poses.len(), poses = list(poses))
        }
        Reason::HardlyBetter { formats, nominal, written } => {
            let [rms, max, of_rms, of_max] =
                [written.rms_mm, written.max_mm, nominal.rms_mm, nominal.max_mm].map(|mm| number::significant(mm, 3));
            match formats.is_empty() {
                true => tr!(words, "reservation-hardly-better", rms, max, nominal_rms = of_rms, nominal_max = of_max),
                false => tr!(
                    words,
                    "reservation-file-hardly-better",
                    formats = formats.join(", "),
                    rms,
                    max,
                    nominal_rms = of_rms,
                    nominal_max = of_max
                ),
            }
        }
        _ => return None,
    })
}

/// Number of limits met, undecided limits, and decision rule.
fn counted(limits: &[&LimitVerdict], words: &Words) -> String {
    let missed = limits.iter().filter(|l| l.acceptance == Acceptance::Fail).count();
    let undecided: Vec<String> = limits
        .iter()
        .filter(|l| l.conformity == Conformity::Neither)
        .map(|l| words.tr(&names::limit(l.name)))
        .collect();
    let not_measured: Vec<String> = limits
        .iter()
        .filter(|l| l.conformity == Conformity::NotAssessable)
        .map(|l| words.tr(&names::limit(l.name)))
        .collect();
    let sentence = match (limits.len(), missed) {
        (0, _) => return tr!(words, "the-campaign-states-no-limits"),
        (_, 0) if !undecided.is_empty() || !not_measured.is_empty() => String::new(),
        (1, 0) => tr!(words, "limit-met-sentence"),
        (2, 0) => tr!(words, "limits-both-met"),
        (n, 0) => tr!(words, "limits-all-met", count = n),
        (1, _) => tr!(words, "limit-not-met-sentence"),
        (n, m) => tr!(words, "limits-not-met", count = m, total = n),
    };
    let open = (!undecided.is_empty()).then(|| tr!(words, "limits-undecided", limits = undecided.join(", ")));
    let without =
        (!not_measured.is_empty()).then(|| tr!(words, "limits-not-assessable", limits = not_measured.join(", ")));
    let rule = limits.first().map(|l| tr!(words, "decision-rule-named", rule = name(l.decision_rule, words)));
    let said = [Some(sentence), open, without, rule];
    said.into_iter().flatten().filter(|s| !s.is_empty()).collect::<Vec<_>>().join(" ")
}

/// Controller file that the other sentences describe, with its error beside the error with all
/// identified parameters.
fn file_sentence(file: &WrittenFile, values: &ControllerFiles, words: &Words) -> Option<String> {
    let ControllerErrors { written, identified, .. } = values.deciding()?;
    let DisplayUnit { unit, factor } = number::display_unit("mm", written.rms_mm);
    let [rms, whole] = [written, identified].map(|e| number::significant(e.rms_mm * factor, 3));
    let count = values.left_out.len();
    Some(tr!(words, "verdict-is-of-file", file = file.file, count, rms, whole, unit))
}

/// Controller files with whose values a limit is not met, other than the file of the verdict.
pub(super) fn files_beyond_limits(results: &Results, words: &Words) -> Option<String> {
    let judged = results.judged_file().map(|(_, values)| &values.formats);
    let others = results.controllers.iter().flat_map(|c| &c.files).filter(|values| Some(&values.formats) != judged);
    let beyond = others.filter(|values| values.limits.iter().any(|l| !l.acceptance.is_accepted()));
    let is_beyond: Vec<&String> = beyond.flat_map(|values| &values.formats).collect();
    let files = results.campaign.controller_files.iter().filter(|file| is_beyond.contains(&&file.format));
    let names: Vec<String> = files.map(|file| format!("`{}`", file.file)).collect();
    (!names.is_empty()).then(|| tr!(words, "files-beyond-limits", count = names.len(), files = names.join(", ")))
}

/// Sentences on the limited errors; without limits, on the largest leading error.
fn errors(limits: &[&LimitVerdict], set: &AccuracySet, words: &Words) -> Vec<String> {
    let mut of_errors = limits.iter().filter(|l| l.name.limited_error().is_some()).peekable();
    match of_errors.peek() {
        Some(_) => of_errors.filter_map(|l| limited(l, set, words)).collect(),
        None => largest_error(set, words).into_iter().collect(),
    }
}

/// A limited error with its uncertainty, its value before calibration, its limit and verdict.
fn limited(l: &LimitVerdict, set: &AccuracySet, words: &Words) -> Option<String> {
    let (of, figure) = l.name.limited_error()?;
    let (e, after) = (set.error_statistics(of)?, l.value?);
    let before = figure.value_in(&e.before);
    let DisplayUnit { unit, factor } = number::display_unit(&e.unit, before);
    let u = l.expanded_uncertainty.map(|u| u * factor);
    let decimals = u.and_then(|u| number::decimals(u, 2)).or(number::decimals(after * factor, 3)).unwrap_or(1);
    let reached = reached_within(l, after, factor, words);
    let allowed = number::stated((1e9 * l.limit * factor).round() / 1e9);
    let judged = judged(l, words).display().plain();
    let [count, readings] = set.counts(e);
    let sentence = tr!(
        words,
        "limited-error",
        quantity = words.tr(&names::limit(l.name)),
        count,
        readings,
        set = words.tr(&set.name.phrase()),
        before = number::fixed(before * factor, decimals),
        after = reached,
        unit,
        limit = allowed,
        verdict = judged
    );
    let is_near = l.acceptance.is_accepted() && l.is_within_guard_band();
    let reservation = is_near.then(|| margin(l, factor, unit, words));
    Some(reservation.map_or_else(|| format!("{sentence}."), |more| format!("{sentence}, {more}.")))
}

/// Margin to a limit, with the risk of a false acceptance.
fn margin(l: &LimitVerdict, factor: f64, unit: &str, words: &Words) -> String {
    let margin = l.margin.map_or_else(String::new, |m| number::significant(m * factor, 2));
    match l.risk() {
        Some(risk) => tr!(words, "limit-margin", margin, unit, risk = number::percent(100.0 * risk)),
        None => tr!(words, "limit-margin-without-uncertainty", margin, unit),
    }
}

/// Change of the largest error, with its uncertainty.
fn largest_error(set: &AccuracySet, words: &Words) -> Option<String> {
    let e = set.leading()?;
    let DisplayUnit { unit, factor } = number::display_unit(&e.unit, e.before.max);
    let u = e.expanded_uncertainty.map(|u| u * factor);
    let (before, after) = (e.before.max * factor, e.after.max * factor);
    let decimals = u.and_then(|u| number::decimals(u, 2)).or(number::decimals(after, 3)).unwrap_or(1);
    let reached = number::fixed(after, decimals);
    let reached = u.map_or(reached.clone(), |u| format!("{reached} ± {}", number::fixed(u, decimals)));
    let [count, readings] = set.counts(e);
    Some(tr!(
        words,
        "error-at-poses",
        quantity = words.tr(&names::error(e.quantity, Figure::Max)),
        count,
        readings,
        set = words.tr(&set.name.phrase()),
        before = number::fixed(before, decimals),
        after = reached,
        unit
    ))
}

/// Size of the residuals, and their ratio to the measurement uncertainty unless a reservation gives
/// it.
fn unexplained(of: &IdentifiedDocuments, is_reserved: bool, words: &Words) -> Option<String> {
    let r = &of.parameters.residuals;
    let ratio = r.times_uncertainty()?;
    let times = number::significant(ratio, 3);
    let by = match r.test.common_standard_uncertainty_mm {
        Some(_) => tr!(words, "uncertainty-of-instrument-and-contact"),
        None if !r.conditions.is_empty() => tr!(words, "uncertainty-of-readings"),
        None => tr!(words, "uncertainty-of-instrument"),
    };
    let numbers = r.position.position_rms_mm.filter(|_| ratio > 0.0 && r.conditions.is_empty()).map(|rms_mm| {
        let DisplayUnit { unit, factor } = number::display_unit("mm", rms_mm);
        let [rms, expected] = [rms_mm, rms_mm / ratio].map(|mm| number::significant(mm * factor, 3));
        tr!(words, "position-residuals-explained", rms, expected, unit)
    });
    if is_reserved {
        return numbers;
    }
    let lacks_effect = of.accuracy.effects.iter().any(|proof| !proof.is_identified);
    let fit = match r.model_fit()? {
        ModelFit::Incomplete => "incomplete",
        ModelFit::Correlated => "correlated",
        ModelFit::Doubtful => "doubtful",
        ModelFit::Fits if lacks_effect => "lacking",
        ModelFit::Fits => "fits",
    };
    let sentence =
        tr!(words, "model-and-residuals", ratio = times, uncertainty = by, fit, criterion = criterion(r, words)?);
    Some(numbers.map_or(sentence.clone(), |numbers| format!("{numbers} {sentence}")))
}

/// Share of the scatter between series.
fn series(scatter: SeriesScatter, words: &Words) -> String {
    match (100.0 * scatter.share).round() as usize {
        0 => tr!(words, "series-agree", series = scatter.series),
        percent => tr!(words, "series-differ", series = scatter.series, percent),
    }
}

/// Verdict on given parameters, judged on the data of a campaign.
pub(crate) fn validation_verdict(accuracy: &AccuracyDocument, words: &Words) -> Verdict {
    let tested = Characteristics::default();
    let judged = Judged { accuracy: Some(accuracy), ..Judged::tested(&tested) };
    let judgement = judged.verdict();
    let limits: Vec<&LimitVerdict> = accuracy.limits.iter().collect();
    let errors = headline_set(accuracy).map_or_else(Vec::new, |set| errors(&limits, set, words));
    let withheld = (!judgement.passes()).then(|| tr!(words, "given-not-loaded"));
    let sentences = named(&judgement, words).into_iter().chain(withheld).chain(errors);
    let sentences = sentences.chain([counted(&limits, words)]);
    let sentences = sentences.chain(reservations(&judgement, words));
    let verdict = Verdict {
        met: judgement.passes(),
        class: Grade::from_verdict(judgement.verdict),
        sentences: sentences.collect(),
        ..Verdict::default()
    };
    page_one::with_figures(verdict, &limits, words)
}

/// Verdict of a test without a campaign.
pub(crate) fn test_verdict(tested: &Characteristics, words: &Words) -> Verdict {
    let judgement = Judged::tested(tested).verdict();
    let sentences = named(&judgement, words).into_iter().chain(characteristics(tested, words));
    let verdict = Verdict {
        met: judgement.passes(),
        class: Grade::from_verdict(judgement.verdict),
        sentences: sentences.chain(reservations(&judgement, words)).collect(),
        ..Verdict::default()
    };
    page_one::with_figures(verdict, &judgement.limits.iter().collect::<Vec<_>>(), words)
}

/// Verdict of an identification without a campaign.
pub(crate) fn identification_verdict(document: &ParametersDocument, words: &Words) -> Verdict {
    let sentences = alarm(document, words).into_iter().collect();
    Verdict { met: document.is_plausible(), sentences, ..Verdict::default() }
}

/// Reason why the numbers must not be used.
fn alarm(document: &ParametersDocument, words: &Words) -> Option<String> {
    let termination = document.solver.termination;
    match termination.is_success() {
        true if document.is_plausible() => None,
        true => Some(tr!(words, "parameters-implausible")),
        false => Some(tr!(words, "identification-ended", reason = termination.phrase())),
    }
}

/// Set of the headlines: validation poses, which were not used in the fit, are decisive if there
/// are any.
fn headline_set(accuracy: &AccuracyDocument) -> Option<&AccuracySet> {
    let counted = || accuracy.sets.iter().filter(|s| s.count > 0);
    counted().find(|s| s.name == PoseSet::Validation).or_else(|| counted().next())
}

/// Error before and after calibration (mm or deg) for a headline.
struct BeforeAfter {
    what: String,
    unit: &'static str,
    values: [f64; 2],
    expanded_uncertainty: Option<f64>,
}

/// Limited errors; without limits, maximum and RMS of the leading error and of orientations.
fn before_after(limits: &[&LimitVerdict], set: &AccuracySet, words: &Words) -> Vec<BeforeAfter> {
    let of = |quantity: ErrorQuantity, figure: Figure| {
        let errors = set.error_statistics(quantity)?;
        let what = match (quantity, figure) {
            (ErrorQuantity::Position, _) | (_, Figure::Max) => words.tr(&names::error(quantity, figure)),
            (_, Figure::Mean) => tr!(words, "mean-of", quantity = words.tr(&quantity.phrase())),
            (_, Figure::Rms) => tr!(words, "rms-of", quantity = words.tr(&quantity.phrase())),
        };
        Some(BeforeAfter {
            what,
            unit: if errors.unit == "deg" { "deg" } else { "mm" },
            values: [figure.value_in(&errors.before), figure.value_in(&errors.after)],
            expanded_uncertainty: errors.expanded_uncertainty,
        })
    };
    let limited: Vec<_> =
        limits.iter().filter_map(|l| l.name.limited_error()).filter_map(|(q, figure)| of(q, figure)).collect();
    if !limited.is_empty() {
        return limited;
    }
    let kinds = set.leading().map(|e| e.quantity).into_iter().chain([ErrorQuantity::Orientation]);
    kinds.flat_map(|q| [of(q, Figure::Max), of(q, Figure::Rms)]).flatten().collect()
}

/// Expected error at the tool point.
fn at_tool(tool: &ToolAccuracy, words: &Words) -> BeforeAfter {
    BeforeAfter {
        what: tr!(words, "tool-point-headline"),
        unit: "mm",
        values: [tool.before.rms, tool.after.rms],
        expanded_uncertainty: None,
    }
}

/// Headlines; headlines on one axis have the unit of the axis.
fn headlines(all: Vec<BeforeAfter>) -> Vec<Headline> {
    let largest = ["mm", "deg"].map(|unit| {
        let of_unit = all.iter().filter(|e| e.unit == unit).flat_map(|e| e.values);
        number::display_unit(unit, of_unit.fold(0.0, f64::max))
    });
    let headline = |e: BeforeAfter| {
        let DisplayUnit { unit, factor } = largest[usize::from(e.unit == "deg")];
        let by_uncertainty = e.expanded_uncertainty.and_then(|u| number::decimals(u * factor, 2));
        let [before, after] = e.values.map(|v| match by_uncertainty {
            Some(decimals) => number::fixed(v * factor, decimals),
            None => number::significant(v * factor, 3),
        });
        Headline { what: e.what, before, after, unit, in_documents: (e.unit, e.values) }
    };
    all.into_iter().map(headline).collect()
}

/// Sentences on the worst accuracy and repeatability: their limits, the evidence of their
/// intervals, and the sufficiency of the instrument.
fn characteristics(tested: &Characteristics, words: &Words) -> Vec<String> {
    let Some(document) = &tested.poses else { return Vec::new() };
    let of = |of: PoseCharacteristic, sentence: fn(&str, &PoseName, &Words) -> String| {
        let all = document.poses.iter().filter_map(|p| Some(((of.value)(p)?, p.pose)));
        let (mm, pose) = all.max_by(|a, b| a.0.total_cmp(&b.0))?;
        let limit = document.limits.iter().find(|l| l.name == of.limit);
        // with the decisive digits, even close to the limit
        let apart_um = limit.map(|l| 1e3 * (l.limit - mm).abs());
        let digits = apart_um.and_then(|apart| number::decimals(apart, 2)).unwrap_or(1).clamp(1, 6);
        let um = |mm: f64| number::fixed(1e3 * mm, digits);
        let within = limit.map(|l| within(l.conformity, &um(l.limit), words));
        let said = [Some(sentence(&um(mm), &pose, words)), within, conformity(document, of, words)];
        Some(said.into_iter().flatten().collect::<Vec<_>>().join(" "))
    };
    let accuracy = of(PoseCharacteristic::AP, |accuracy, pose, words| tr!(words, "accuracy-at-pose", accuracy, pose));
    let repeatability = of(PoseCharacteristic::RP, |repeatability, pose, words| {
        tr!(words, "repeatability-at-pose", repeatability, pose)
    });
    let by_approach = pooled(document, words);
    let instrument = Some(quarter_sentence(document, words)).filter(|sentence| !sentence.is_empty());
    [accuracy, by_approach, repeatability, instrument].into_iter().flatten().collect()
}

/// RP of each approach, if a pose has several, because ISO 9283 visits a pose from one direction.
fn pooled(document: &Iso9283Document, words: &Words) -> Option<String> {
    let several = document.approaches.iter().filter(|v| v.approaches.len() > 1);
    let of_pose = |v: &Iso9283Variation| {
        let all: Vec<f64> = v.approaches.iter().filter_map(|a| a.rp_mm).collect();
        let pooled = document.poses.iter().find(|p| p.pose == v.pose)?.rp_mm?;
        let (low, high) = all.iter().fold((f64::INFINITY, 0.0f64), |(a, b), v| (a.min(*v), b.max(*v)));
        (!all.is_empty()).then_some((v.pose, all.len(), low, high, pooled))
    };
    let (pose, count, low, high, pooled) = several.filter_map(of_pose).max_by(|a, b| a.3.total_cmp(&b.3))?;
    let um = |mm: f64| number::fixed(1e3 * mm, 1);
    Some(tr!(
        words,
        "repeatability-from-one-approach",
        smallest = um(low),
        largest = um(high),
        pose,
        approaches = count,
        together = um(pooled)
    ))
}

fn within(conformity: Conformity, allowed: &str, words: &Words) -> String {
    match conformity {
        Conformity::Conforming => tr!(words, "limit-kept-sentence", limit = allowed),
        Conformity::NotConforming => tr!(words, "limit-exceeded-sentence", limit = allowed),
        Conformity::Neither | Conformity::NotAssessable => tr!(words, "limit-undecided-sentence", limit = allowed),
    }
}

/// Conformity of the poses by guarded acceptance, if a limit is given.
fn conformity(document: &Iso9283Document, of: PoseCharacteristic, words: &Words) -> Option<String> {
    let poses = |what| -> Vec<String> {
        document.poses.iter().filter(|p| (of.conformity)(p) == Some(what)).map(|p| p.pose.to_string()).collect()
    };
    let conforming = poses(Conformity::Conforming);
    let (not, neither) = (poses(Conformity::NotConforming), poses(Conformity::Neither));
    let all = conforming.len() + not.len() + neither.len();
    let first = match conforming.len() {
        0 => None,
        1 if all == 1 => Some(tr!(words, "pose-conforms", pose = conforming[0])),
        n if n == all => Some(tr!(words, "all-poses-conform", count = all)),
        n => Some(tr!(words, "poses-conform", count = n, total = all)),
    };
    let second =
        (!not.is_empty()).then(|| tr!(words, "poses-not-conforming", count = not.len(), poses = not.join(", ")));
    let third =
        (!neither.is_empty()).then(|| tr!(words, "poses-undecided", count = neither.len(), poses = neither.join(", ")));
    let said: Vec<String> = [first, second, third].into_iter().flatten().collect();
    let rule = document.limits.first().map_or_else(DecisionRule::default, |l| l.decision_rule);
    (all > 0).then(|| tr!(words, "conformity-by-rule", rule = name(rule, words), results = said.join("; ")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::Documents;
    use crate::tests::demo_iso9283::whole;
    use etalon_base::catalogue::Phrase;
    use etalon_base::phrase;
    use etalon_documents::LimitQuantity;
    use etalon_documents::Termination;

    fn report_verdict(documents: &Documents) -> Verdict {
        let results = documents.results();
        verdict(&results, &Words::default())
    }

    /// Sentence on the fit of the model, with the probability of chi-square.
    fn fit_sentence(ratio: &'static str, fit: &'static str, p: &'static str) -> String {
        let (words, uncertainty) = (&Words::default(), phrase!("uncertainty-of-instrument"));
        let criterion = tr!(words, "model-criterion", p, limit = "0.001");
        tr!(words, "model-and-residuals", ratio, uncertainty, fit, criterion)
    }

    /// Chi-square of 149 degrees of freedom: 160 has p = 0.25, 180 has p = 0.042 (incomplete
    /// gamma function).
    #[test]
    fn a_model_fits_only_without_a_contradiction() {
        let mut documents = Documents::demo();
        let said = |documents: &Documents, sentence: String| {
            let all = report_verdict(documents).sentences;
            assert!(all.iter().any(|s| s.ends_with(&sentence)), "{sentence}: {all:?}");
        };
        let test = &mut documents.parameters.residuals.test;
        (test.chi_square, test.chi_square_rejected) = (Some(160.0), false);
        said(&documents, fit_sentence("1.04", "fits", "p = 0.25"));
        documents.parameters.residuals.uncertainties_from = etalon_documents::UncertaintyFrom::ResidualsByRegion;
        said(&documents, fit_sentence("1.04", "correlated", "p = 0.25"));
        documents.parameters.residuals.uncertainties_from = etalon_documents::UncertaintyFrom::Instrument;
        documents.parameters.residuals.test.chi_square = Some(180.0);
        said(&documents, fit_sentence("1.10", "doubtful", "p = 0.042"));
    }

    /// Name of the rule of the limits.
    fn guarded() -> String {
        tr!(Words::default(), "decision-rule-named", rule = phrase!("guarded-acceptance"))
    }

    /// Sentence on a limited error that passes: poses and readings of the validation; before,
    /// after, limit and unit.
    fn stated(limit: &'static str, [count, readings]: [usize; 2], numbers: [&str; 4]) -> String {
        let [before, after, allowed, unit] = numbers;
        let words = &Words::default();
        let sentence = tr!(
            words,
            "limited-error",
            quantity = Phrase::new(limit),
            count,
            readings,
            set = PoseSet::Validation.phrase(),
            before,
            after,
            unit,
            limit = allowed,
            verdict = phrase!("pass")
        );
        format!("{sentence}.")
    }

    #[test]
    fn limits_are_judged_as_stated() {
        let mut documents = Documents::demo();
        let good = report_verdict(&documents);
        let words = &Words::default();
        let expected = [
            tr!(words, "verdict-pass"),
            stated("limit-position-max", [51, 255], ["2.0895", "0.0442 ± 0.0038", "0.05", "mm"]),
            stated("limit-orientation-max", [51, 255], ["0.1759", "0.0056 ± 0.0038", "0.01", "deg"]),
            [
                tr!(words, "position-residuals-explained", rms = "26.0", expected = "21.8", unit = "µm"),
                fit_sentence("1.19", "incomplete", "p < 0.001"),
            ]
            .join(" "),
            tr!(words, "limits-both-met") + " " + &guarded(),
        ];
        assert_eq!((good.class, &good.sentences[..]), (Grade::Good, &expected[..]));
        let limit = |u| LimitVerdict::judge(LimitQuantity::PositionMaxMm, 0.05, 0.0442, u, DecisionRule::Guarded);
        documents.accuracy.limits[0] = limit(Some(0.038));
        let open = report_verdict(&documents);
        assert!(
            open.class == Grade::Open && !open.met && open.sentences[2].ends_with("limit 0.05 mm: undecided."),
            "{open:?}"
        );
        let nothing = sentence(&tr!(words, "recommend-resolve"));
        assert_eq!(open.sentences[..2], [tr!(words, "verdict-undecided"), nothing]);
        let undecided = tr!(words, "limits-undecided", limits = phrase!("limit-position-max"));
        assert!(open.sentences[5].starts_with(&undecided), "{open:?}");
        let simple = LimitVerdict::judge(
            LimitQuantity::PositionMaxMm,
            0.05,
            0.0442,
            Some(0.038),
            DecisionRule::SimpleAcceptance,
        );
        documents.accuracy.limits[0] = simple;
        let simple = report_verdict(&documents);
        assert_eq!((simple.class, simple.met), (Grade::Good, true));
        // Φ(0.0058/0.019) = 0.62
        let margin = tr!(words, "limit-margin", margin = "0.0058", unit = "mm", risk = "38");
        assert!(simple.sentences[1].ends_with(&format!("{margin}.")), "{simple:?}");
        documents.accuracy.limits[0] =
            LimitVerdict::not_assessable(LimitQuantity::DistanceMaxMm, 0.05, DecisionRule::Guarded);
        let open = report_verdict(&documents);
        assert_eq!((open.class, open.met), (Grade::Open, false));
        let not_measured = tr!(words, "limits-not-assessable", limits = phrase!("limit-distance-max"));
        assert!(open.sentences.iter().any(|s| s.starts_with(&not_measured)), "{open:?}");
        documents.accuracy.limits[0] = LimitVerdict { limit: 0.04, ..limit(None) }.with(Conformity::NotConforming);
        let bad = report_verdict(&documents);
        assert_eq!(bad.class, Grade::Bad);
        assert_eq!(bad.sentences[5], tr!(words, "limits-not-met", count = 1, total = 2) + " " + &guarded());
        documents.accuracy.limits.clear();
        let without = report_verdict(&documents);
        assert!(without.class == Grade::Open && without.met, "{without:?}");
    }

    #[test]
    fn an_error_is_stated_with_its_own_poses_and_readings() {
        let mut documents = Documents::demo();
        let sentence = |documents: &Documents| report_verdict(documents).sentences[1].clone();
        let position = |documents: &mut Documents, poses, count| {
            let set = documents.accuracy.sets.last_mut().unwrap();
            (set.errors[0].poses, set.errors[0].count) = (poses, count);
        };
        // earlier documents contain no poses of a quantity
        for (poses, count, shown) in [(5, 5, [5, 0]), (5, 7, [5, 7]), (0, 51, [51, 0])] {
            position(&mut documents, poses, count);
            let numbers = ["2.0895", "0.0442 ± 0.0038", "0.05", "mm"];
            assert_eq!(sentence(&documents), stated("limit-position-max", shown, numbers));
        }
    }

    #[test]
    fn every_verdict_counts_beside_an_identification() {
        let mut documents = Documents::demo();
        documents.tested = whole();
        let open = report_verdict(&documents);
        let words = &Words::default();
        let by_rule = |results: Phrase| tr!(words, "conformity-by-rule", rule = phrase!("guarded-acceptance"), results);
        let expected = [
            [
                tr!(words, "accuracy-at-pose", accuracy = "51.20", pose = "2"),
                tr!(words, "limit-undecided-sentence", limit = "52.00"),
                by_rule(phrase!("poses-undecided", count = 2, poses = "1, 2")),
            ]
            .join(" "),
            tr!(
                words,
                "repeatability-from-one-approach",
                smallest = "11.1",
                largest = "11.1",
                pose = "1",
                approaches = 2,
                together = "21.7"
            ),
            [
                tr!(words, "repeatability-at-pose", repeatability = "21.7", pose = "2"),
                tr!(words, "limit-kept-sentence", limit = "30.0"),
                by_rule(phrase!("all-poses-conform", count = 2)),
            ]
            .join(" "),
            tr!(words, "instrument-good-for-all", tested = "accuracy"),
            tr!(words, "limits-undecided", limits = phrase!("limit-accuracy-max")) + " " + &guarded(),
        ];
        assert_eq!((open.class, open.met, &open.sentences[5..]), (Grade::Open, false, &expected[..]));
        let poses = documents.tested.poses.as_mut().unwrap();
        poses.poses[0].ap_conformity = Some(Conformity::Conforming);
        poses.limits[0] = poses.limits[0].clone().with(Conformity::Conforming);
        poses.limits[1] = LimitVerdict { limit: 0.02, ..poses.limits[1].clone() }.with(Conformity::NotConforming);
        poses.poses[1].rp_conformity = Some(Conformity::NotConforming);
        let bad = report_verdict(&documents);
        assert_eq!((bad.class, bad.met), (Grade::Bad, false));
        assert!(bad.sentences[9].starts_with(&tr!(words, "limits-not-met", count = 1, total = 4)), "{bad:?}");
        let one = tr!(words, "poses-conform", count = 1, total = 2);
        for (sentence, other) in [
            (&bad.sentences[5], tr!(words, "poses-undecided", count = 1, poses = "2")),
            (&bad.sentences[7], tr!(words, "poses-not-conforming", count = 1, poses = "2")),
        ] {
            assert!(sentence.ends_with(&format!("{one}; {other}.")), "{bad:?}");
        }
    }

    #[test]
    fn given_parameters_that_do_not_pass_are_not_loaded() {
        let (mut documents, words) = (Documents::demo(), Words::default());
        let said = |documents: &Documents| validation_verdict(&documents.accuracy, &words).sentences;
        let nothing = tr!(words, "given-not-loaded");
        assert!(!said(&documents).contains(&nothing));
        let limit = documents.accuracy.limits[0].clone();
        documents.accuracy.limits[0] = LimitVerdict { limit: 0.04, ..limit }.with(Conformity::NotConforming);
        assert_eq!(said(&documents)[1], nothing);
    }

    #[test]
    fn a_solver_that_failed_is_never_good() {
        let mut documents = Documents::demo();
        documents.parameters.solver.termination = Termination::IterationLimit;
        let verdict = report_verdict(&documents);
        assert!(verdict.class == Grade::Bad && verdict.sentences[0].contains("not converged"), "{verdict:?}");
    }

    #[test]
    fn headlines_have_the_unit_of_their_axis() {
        let of = |unit, before, after| BeforeAfter {
            what: String::new(),
            unit,
            values: [before, after],
            expanded_uncertainty: Some(0.016),
        };
        let all = headlines(vec![of("mm", 0.472, 0.0252), of("deg", 0.03, 0.01), of("mm", 1.35, 0.0103)]);
        let shown: Vec<_> = all.iter().map(|h| format!("{} → {} {}", h.before, h.after, h.unit)).collect();
        assert_eq!(shown, ["0.472 → 0.025 mm", "0.030 → 0.010 deg", "1.350 → 0.010 mm"]);
    }

    #[test]
    fn headlines_are_from_validation_where_there_is_any() {
        let mut documents = Documents::demo();
        assert!(report_verdict(&documents).about.contains("validation poses"));
        documents.accuracy.sets.iter_mut().for_each(|s| s.count *= usize::from(s.name == PoseSet::Calibration));
        assert!(report_verdict(&documents).about.contains("calibration poses"));
        documents.accuracy.sets.clear();
        assert!(report_verdict(&documents).headlines.is_empty());
    }
}

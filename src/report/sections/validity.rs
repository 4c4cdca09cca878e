//! Validity of existing parameters: whether they still apply, and which of them should be loaded.

use super::messages;
use crate::model::{
    Block, Columns, Grade, Section, Step, Table, Text, Verdict, fixed, number_cell, numbers, sentence, significant,
    term,
};
use crate::number::{self, DisplayUnit};
use crate::words::{Words, names, tr};
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Rank, Severity};
use etalon_base::phrase;
use etalon_documents::{
    ChangeEvidence, CrossValidationExtent, EffectStep, HeldOutErrors, LeastDetectable, LoadVerdict, MovementValue,
    ParameterVerdict, RecommendationDocument, Statistics, SumOfSquares, VerificationDocument, VerificationPlanDocument,
    VerificationVerdict,
};

/// Verdict on whether the parameters still apply.
pub(crate) fn still_valid(document: &VerificationDocument, words: &Words) -> Verdict {
    let is_valid = document.verdict == VerificationVerdict::Valid && !document.is_refused();
    // copies confirm nothing
    let met = is_valid && document.residuals.copies == 0;
    let class = if is_valid && !met { Grade::Open } else { Grade::from_met(met) };
    let sentences = vec![Text::worded(&document.meaning, words).plain()];
    Verdict { met, class, sentences, steps: steps(document, words), ..Verdict::default() }
}

/// Next steps after a verification. Of a result that is refused, the messages say what to do.
fn steps(document: &VerificationDocument, words: &Words) -> Vec<Step> {
    let step = |what: String, reason: String| {
        let [what, reason] = [what, reason].map(|text| Text::from(sentence(&text)));
        Step { what, reason, command: None, file: None }
    };
    if document.is_refused() {
        return Vec::new();
    }
    let ChangeEvidence { moved, alike, .. } = &document.evidence;
    let mut all = Vec::new();
    if document.residuals.copies > 0 {
        let reason = tr!(words, "verify-step-new-reason", count = document.residuals.copies);
        all.push(step(tr!(words, "verify-step-new"), reason));
    }
    if !alike.is_empty() {
        let named = moved.iter().map(|m| &m.name).chain(alike).map(|name| moving(name, words));
        let motions = named.collect::<Vec<_>>().join(", ");
        all.push(step(tr!(words, "verify-step-apart", motions), tr!(words, "verify-step-apart-reason")));
    }
    all.push(match (document.verdict, moved) {
        (VerificationVerdict::Valid, _) => {
            let keep = step(tr!(words, "verify-step-keep"), tr!(words, "verify-step-keep-reason"));
            // copies confirm nothing
            return if all.is_empty() { vec![keep] } else { all };
        }
        (VerificationVerdict::BaseMoved, _) => {
            step(tr!(words, "verify-step-base"), tr!(words, "verify-step-base-reason"))
        }
        (VerificationVerdict::Joint, Some(m)) => {
            let by = |v: &MovementValue| words.decimal(format!("{:+.4} {}", v.value, v.unit));
            let by = m.by.iter().map(by).collect::<Vec<_>>().join(", ");
            step(tr!(words, "verify-step-joint", joint = m.name, by), tr!(words, "verify-step-joint-reason"))
        }
        (VerificationVerdict::Other, Some(m)) => {
            step(tr!(words, "verify-step-target", target = m.name), tr!(words, "verify-step-target-reason"))
        }
        (VerificationVerdict::Joint | VerificationVerdict::Other, None) => {
            step(tr!(words, "verify-step-other"), tr!(words, "verify-step-other-reason"))
        }
    });
    all.push(step(tr!(words, "verify-step-verify"), tr!(words, "verify-step-verify-reason")));
    all
}

/// Name of a motion in the language of the report.
fn moving(name: &str, words: &Words) -> String {
    if name == "base" { tr!(words, "moved-base") } else { format!("`{name}`") }
}

/// Sections on the probability of the verdict, and on the detectable changes.
pub(crate) fn verification(document: &VerificationDocument, words: &Words) -> Vec<Section> {
    let mut judged = Section::new("judged", tr!(words, "how-changes-are-judged")).on_terminal();
    let p = words.decimal(number::p_value(document.evidence.p_value));
    let limit = tr!(words, "changed-below", significance = number::stated(document.evidence.significance));
    let compared = [document.residuals.position_rms_mm, document.residuals.expected_position_rms_mm];
    let DisplayUnit { unit, factor } = number::display_unit("mm", compared.into_iter().fold(0.0, f64::max));
    let [rms, expected] = compared.map(|mm| number::significant(mm * factor, 3));
    let count = document.evidence.of_changes.degrees_of_freedom + document.evidence.of_rest.degrees_of_freedom;
    let tested = |test: &SumOfSquares| {
        let (sum, degrees) = (words.fixed(test.value, 1), test.degrees_of_freedom);
        let p = words.decimal(number::p_value(test.p_value));
        tr!(words, "sum-of-squares-tested", sum, degrees, p)
    };
    let mut facts = vec![
        (tr!(words, "probability-by-chance"), format!("{p}; {limit}").into()),
        (tr!(words, "test-of-changes"), tested(&document.evidence.of_changes).into()),
        (tr!(words, "test-of-rest"), tested(&document.evidence.of_rest).into()),
    ];
    if document.residuals.points > 0 {
        let value = tr!(words, "rms-expected", value = rms, expected, unit);
        facts.push((tr!(words, "position-residuals-rms"), value.into()));
    }
    for found in &document.residuals.conditions {
        let DisplayUnit { unit, factor } = number::display_unit(&found.unit, found.rms.max(found.expected_rms));
        let [rms, expected] = [found.rms, found.expected_rms].map(|v| number::significant(v * factor, 3));
        let value = tr!(words, "rms-expected", value = rms, expected, unit);
        facts.push((tr!(words, "rms-of", quantity = words.tr(&found.quantity.phrase())), value.into()));
    }
    let counted = if document.residuals.conditions.is_empty() { phrase!("coordinates") } else { phrase!("residuals") };
    facts.push((words.tr(&counted), tr!(words, "count-at-poses", count, poses = document.residuals.poses).into()));
    judged.push(Block::facts(facts));
    let power = &document.evidence.power;
    let known: Vec<&Message> = document.messages.iter().filter(|m| m.rank != Rank::Routine).collect();
    let warnings = (!known.is_empty()).then(|| messages::section_from_messages(&known, words));
    let detected = detected(&power.least, power.probability, power.naming, words);
    [judged, detected].into_iter().chain(warnings).collect()
}

/// Smallest detectable movements.
fn detected(all: &[LeastDetectable], probability: f64, naming: f64, words: &Words) -> Section {
    let percent = |p: f64| number::fixed(100.0 * p, 0);
    let title = tr!(words, "detected-with-probability", percent = percent(probability));
    let mut power = Section::new("power", title).on_terminal();
    let unit = |l: &LeastDetectable| number::display_unit(&l.unit, l.value.or(l.named).unwrap_or(0.0));
    let least = |l: &LeastDetectable, v: Option<f64>| {
        let shown = |v: f64| number::significant(v * unit(l).factor, 3);
        numbers(v.map_or_else(|| tr!(words, "not-by-these-poses"), shown))
    };
    let joint = |l: &LeastDetectable| !l.name.starts_with("base ");
    let columns = Columns::<LeastDetectable>::new()
        .both(phrase!("motion"), "", |l| {
            names::movement(&l.name).map_or_else(|| Text::name(&l.name), |p| Text::name(&words.tr(&p)))
        })
        .both(phrase!("detected-from"), "", |l| least(l, l.value))
        .both(phrase!("named-from"), "", |l| joint(l).then(|| least(l, l.named)))
        .both(phrase!("unit"), "", |l| if unit(l).unit.is_empty() { l.unit.as_str() } else { unit(l).unit });
    power.push(Block::Table(Table::new(words, all, columns).on(phrase!("sheet-detectable"))));
    power.push(Block::note(tr!(words, "naming-probability", percent = percent(naming))));
    power
}

/// Verdict on the chosen poses.
pub(crate) fn chosen(document: &VerificationPlanDocument, words: &Words) -> Verdict {
    let names: Vec<String> = document.steps.iter().map(|step| step.pose.to_string()).collect();
    let sentences = vec![tr!(words, "poses-to-measure-named", poses = names.join(", "))];
    let met = document.messages.iter().all(|message| message.severity != Severity::Error);
    Verdict { met, sentences, ..Verdict::default() }
}

/// Sections on the changes that the chosen poses detect.
pub(crate) fn poses_to_verify(document: &VerificationPlanDocument, words: &Words) -> Vec<Section> {
    let last = document.steps.last();
    last.map(|step| detected(&step.least, document.probability, document.naming, words)).into_iter().collect()
}

/// Recommendation in sentences.
pub(crate) fn recommended(document: &RecommendationDocument, words: &Words) -> Verdict {
    let met = document.recommended.is_plausible();
    let sentences = document.meaning.iter().map(|sentence| Text::worded(sentence, words).plain()).collect();
    Verdict { met, class: Grade::from_met(met), sentences, ..Verdict::default() }
}

/// Errors at held-out poses with each set of parameters.
fn left_out(document: &RecommendationDocument, words: &Words) -> Section {
    let HeldOutErrors { none, all, recommended } = document.held_out;
    let sets = [
        (phrase!("nominal-parameters"), none),
        (phrase!("parameters-of-the-run"), all),
        (phrase!("parameters-of-the-answer"), recommended),
    ];
    let columns = Columns::<(Phrase, Statistics)>::new()
        .both(phrase!("parameters-title"), "", |(name, _)| Text::name(&words.tr(name)))
        .both(phrase!("mean"), "mm", |(_, e)| fixed(e.mean, 4))
        .both(phrase!("rms"), "mm", |(_, e)| fixed(e.rms, 4))
        .both("95 %", "mm", |(_, e)| fixed(e.p95, 4))
        .both(phrase!("max"), "mm", |(_, e)| fixed(e.max, 4));
    let mut section = Section::new("left-out", tr!(words, "left-out-errors")).on_terminal();
    section.push(Block::Table(Table::new(words, &sets, columns).on(phrase!("left-out-errors"))));
    section
}

/// Sections on effects in the order of trial, and on the evidence for each parameter.
pub(crate) fn recommendation(document: &RecommendationDocument, words: &Words) -> Vec<Section> {
    let p = |p: Option<f64>| numbers(p.map(number::probability));
    let CrossValidationExtent { poses, folds, repeats } = document.extent;
    let title = tr!(words, "effects-cross-validated", poses, folds, repeats);
    let mut effects = Section::new("effects", title).on_terminal();
    let name = |s: &EffectStep| match s.effect {
        Some(effect) => format!("+ {}", words.tr(&effect.phrase())),
        None => tr!(words, "base-and-targets"),
    };
    let columns = Columns::<EffectStep>::new()
        .both(phrase!("effect"), "", name)
        .both(phrase!("identified"), "", |s| s.identified)
        .both(phrase!("rms"), "mm", |s| fixed(s.rms_mm, 4))
        .both(phrase!("left-out-rms"), "mm", |s| fixed(s.held_out_rms_mm, 4))
        .both(phrase!("gain-over-u"), "", |s| fixed(s.gain_over_u, 1))
        .both("p", "", move |s| p(s.p_value))
        .both(phrase!("verdict"), "", |s| match s.accepted {
            true => term(words, phrase!("accepted")),
            false => term(words, phrase!("not-accepted")),
        })
        .decisive();
    effects.push(Block::Table(Table::new(words, &document.steps, columns).on(phrase!("effects-section"))));
    let mut parameters = Section::new("parameters", tr!(words, "parameters-title")).on_terminal();
    // nothing is loaded before the next steps of the run
    let is_withheld = document.loading.as_ref().is_some_and(|loading| loading.withheld().is_some());
    let change = |p: &ParameterVerdict| {
        let u = (p.change / p.change_over_u).abs();
        number_cell(p.change, |v| (if v > 0.0 { "+" } else { "" }).to_owned() + &number::with_uncertainty(v, Some(u)))
    };
    let columns = Columns::<ParameterVerdict>::new()
        .both(phrase!("name"), "", |p| p.name.as_str())
        .both(phrase!("change"), "", change)
        .both(phrase!("unit"), "", |p| document.recommended.printed_unit(&p.name, &p.unit).to_owned())
        .micrometres(phrase!("largest-displacement"), |p| p.displacement_mm)
        .both(phrase!("change-over-u"), "", |p| fixed(p.change_over_u, 1))
        .both("p", "", move |v| p(Some(v.p_value)))
        .both(phrase!("folds-over-u"), "", |p| significant(p.fold_sd_over_u, 2))
        .both(phrase!("stability"), "", |p| fixed(p.part_change_over_sd, 1))
        .both(phrase!("limit"), "", |p| fixed(p.part_change_limit, 1))
        .both(phrase!("verdict"), "", move |p| match p.verdict {
            LoadVerdict::Load if is_withheld => term(words, phrase!("to-load-later")),
            LoadVerdict::Load => term(words, phrase!("to-load")),
            LoadVerdict::Hold => term(words, phrase!("to-hold")),
        })
        .decisive();
    let table = Table::new(words, &document.parameters, columns).on(phrase!("parameters-title"));
    parameters.push(Block::Table(table));
    let known: Vec<&Message> = document.messages.iter().filter(|m| m.rank != Rank::Routine).collect();
    let warnings = (!known.is_empty()).then(|| messages::section_from_messages(&known, words));
    [left_out(document, words), effects, parameters].into_iter().chain(warnings).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::Documents;
    use etalon_base::warning;
    use etalon_documents::{DetectionPower, Movement, MovementKind, Provenance, VerifiedResiduals};

    #[test]
    fn a_recommendation_names_unstable_parameters_in_its_report() {
        let words = Words::default();
        let errors = |rms: f64| Statistics { mean: rms, rms, p95: rms, max: rms };
        let document = |messages: Vec<Message>| RecommendationDocument {
            schema: "etalon/recommendation/1".to_owned(),
            robot: "prexyt".to_owned(),
            campaign: None,
            loading: None,
            meaning: Vec::new(),
            extent: CrossValidationExtent { poses: 8, folds: 5, repeats: 1 },
            steps: Vec::new(),
            parameters: Vec::new(),
            held_out: HeldOutErrors { none: errors(0.9), all: errors(0.1), recommended: errors(0.1) },
            recommended: Documents::demo().parameters,
            messages,
        };
        let said = |document: &RecommendationDocument| {
            let sections = recommendation(document, &words);
            sections.iter().any(|s| serde_json::to_string(s).unwrap().contains("theta_4"))
        };
        let parameters = vec![phrase!("unstable-parameter", parameter = "theta_4", over_sd = 4.9, limit = 4.1)];
        assert!(said(&document(vec![warning!("parameters-unstable", parameters)])));
        assert!(!said(&document(Vec::new())));
    }

    /// A verification whose zero of a joint has moved, or that is valid.
    fn verified(is_moved: bool, alike: &[&str], copies: usize, messages: Vec<Message>) -> VerificationDocument {
        let value = MovementValue {
            name: "q1".to_owned(),
            unit: "deg".to_owned(),
            value: -0.0992,
            standard_uncertainty: Some(0.001),
        };
        let moved = Movement {
            name: "q1".to_owned(),
            kind: MovementKind::Joint,
            by: vec![value],
            p_left: 0.4,
            explained_share: 0.9,
        };
        let test = SumOfSquares { value: 30.0, degrees_of_freedom: 10, p_value: 0.001 };
        VerificationDocument {
            schema: "etalon/verification/1".to_owned(),
            robot: "serial".to_owned(),
            calibration: None,
            verdict: if is_moved { VerificationVerdict::Joint } else { VerificationVerdict::Valid },
            meaning: phrase!("parameters-still-valid").into(),
            evidence: ChangeEvidence {
                p_value: 0.001,
                significance: 0.05,
                moved: is_moved.then_some(moved),
                alike: alike.iter().map(|name| (*name).to_owned()).collect(),
                explanations: Vec::new(),
                power: DetectionPower { probability: 0.95, naming: 0.9, least: Vec::new() },
                of_changes: test,
                of_rest: test,
            },
            residuals: VerifiedResiduals {
                poses: 8,
                points: 0,
                copies,
                rms_mm: 0.0,
                expected_rms_mm: 0.0,
                position_rms_mm: 0.0,
                expected_position_rms_mm: 0.0,
                conditions: Vec::new(),
                standard_uncertainty_mm: 0.01,
                model_mm: 0.0,
            },
            messages,
            provenance: Provenance {
                version: "0.1.0".to_owned(),
                inputs: std::collections::BTreeMap::new(),
                seed: None,
            },
        }
    }

    /// Warnings of the terminal are in the page too, and a step follows from them.
    #[test]
    fn a_verification_says_what_to_do() {
        let words = Words::default();
        let warning = warning!("motions-alike", count = 1, motions = ["base"]);
        let moved = verified(true, &["base"], 0, vec![warning]);
        let steps = |document: &VerificationDocument| -> Vec<String> {
            still_valid(document, &words).steps.iter().map(|step| step.what.plain()).collect()
        };
        let [apart, joint, again] = &steps(&moved)[..] else { panic!("{:?}", steps(&moved)) };
        assert!(apart.contains("q1") && apart.contains("base"), "{apart}");
        assert!(joint.contains("q1") && joint.contains("-0.0992 deg"), "{joint}");
        assert!(again.contains("etalon verify"), "{again}");
        let sections = serde_json::to_string(&verification(&moved, &words)).unwrap();
        assert!(sections.contains("motions-alike"), "{sections}");
        // without positions there are no residuals of positions
        assert!(!sections.contains(&tr!(words, "position-residuals-rms")), "{sections}");
        let copy = still_valid(&verified(false, &[], 24, Vec::new()), &words);
        assert!(!copy.met && copy.class == Grade::Open && copy.steps.len() == 1);
        let valid = still_valid(&verified(false, &[], 0, Vec::new()), &words);
        assert!(valid.met && valid.class == Grade::Good && valid.steps.len() == 1);
    }
}

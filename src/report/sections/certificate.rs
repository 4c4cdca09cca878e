//! Certificate: results for the customer (ISO/IEC 17025:2017, 7.8.4), from the facts, the verdict
//! and the results of the report. Until all fields are given it is a draft; results of synthetic
//! data cannot be certified.

use super::{
    accuracy, budget, checklist, clauses, conditions, errors, fit, limits, messages, parameters, provenance, region,
    repeatability,
};
use crate::model::{
    Block, Cell, Columns, Contents, Layout, Section, Table, Text, Verdict, numbers, sentence, significant, term,
    with_uncertainty,
};
use crate::words::{Words, isolated, names, tr};
use crate::{coverage, number};
use etalon_base::message::{Message, Rank, one_line};
use etalon_base::{files, phrase};
use etalon_documents::{
    AccuracyDocument, AccuracySet, ErrorQuantity, ErrorStatistics, Figure, Loading, ParameterEntry, Results, Source,
    SourceKind, WrittenFile,
};

/// Identifiers of sections of characteristics whose results the certificate has in its own tables.
const PRINTED: [&str; 3] = ["accuracy", "repeatability", "poses"];

/// Contents of the certificate, from the contents of the report.
pub(crate) fn contents(results: &Results, whole: Contents, words: &Words) -> Contents {
    let missing = checklist::missing(results, words);
    let is_draft = !missing.is_empty();
    let (title, draft) =
        match (results.identified.is_some(), results.campaign.measurements.synthetic.is_some(), is_draft) {
            (true, true, _) => (tr!(words, "calibration-of-synthetic-data"), Some(tr!(words, "synthetic-mark"))),
            (false, true, _) => (tr!(words, "test-of-synthetic-data"), Some(tr!(words, "synthetic-mark"))),
            (true, false, true) => (tr!(words, "calibration-certificate-draft"), Some(tr!(words, "draft-mark"))),
            (false, false, true) => (tr!(words, "test-certificate-draft"), Some(tr!(words, "draft-mark"))),
            (true, false, false) => (tr!(words, "calibration-certificate"), None),
            (false, false, false) => (tr!(words, "test-certificate"), None),
        };
    let mut facts = Section::new("conditions", tr!(words, "item-customer-traceability"));
    facts.push(Block::facts(conditions::certificate_facts(results, words)));
    let sections = [
        checklist::section_from_missing(&missing, words),
        Some(facts),
        clauses::section(&results.tested, words),
        errors_section(results, words),
        region::section(results, words),
        characteristics_section(results, words),
        limits::section(results, words),
        parameters_section(results, words),
        Some(warnings(results, words)),
        loaded_section(results, words),
        provenance::section(results, words),
    ];
    // what the title and the table of clauses claim is printed
    let further = super::characteristics(&results.tested, words).filter(|s| !PRINTED.contains(&s.id.as_str()));
    let mut sections: Vec<Section> = sections.into_iter().flatten().collect();
    let place = sections.iter().position(|s| s.id == "characteristics").map_or(sections.len(), |i| i + 1);
    let printed = further.map(|mut section| {
        section.push(Block::note(tr!(words, "certificate-without-uncertainty")));
        Section { annex: false, ..super::with_measurement_point(section, results, words) }
    });
    sections.splice(place..place, printed);
    let sentences = verdict_sentences(results, whole.verdict.sentences, words);
    // the subtitle of a report calls it a report
    let subject = match (&results.identified, conditions::robot_name(results)) {
        (Some(_), Some(name)) => tr!(words, "robot-of-name", name = isolated(&one_line(&name))),
        (Some(identified), None) => tr!(words, "robot-of-model", model = words.model(&identified.parameters.robot)),
        (None, _) => whole.subtitle,
    };
    Contents {
        subtitle: format!("{}. {subject}", whole.title),
        title,
        draft,
        sections,
        statement: format!("{} {}", whole.statement, tr!(words, "certificate-reproduction")),
        // the table contains the headlines; next steps are opinions that a laboratory gives by
        // itself (ISO/IEC 17025:2017, 7.8.7), and the checklist follows
        verdict: Verdict {
            sentences,
            about: String::new(),
            headlines: Vec::new(),
            steps: Vec::new(),
            to_complete: None,
            ..whole.verdict
        },
        layout: Layout { compact: true, ..whole.layout },
        ..whole
    }
}

/// Sentences on the origin of the errors before and after calibration.
fn computed(results: &Results, words: &Words) -> String {
    let is_backup = |source: &&Source| source.kind == SourceKind::Backup;
    let backup = results.import.sources.iter().find(is_backup);
    let controller = match backup {
        Some(source) => tr!(words, "certificate-controller-before", file = source.file, sha256 = source.sha256),
        None => tr!(words, "certificate-controller-unknown"),
    };
    format!("{} {controller}", tr!(words, "certificate-computed"))
}

/// Errors before and after at the deciding poses.
fn errors_section(results: &Results, words: &Words) -> Option<Section> {
    let identified = results.identified.as_ref()?;
    let set = identified.accuracy.sets.iter().rfind(|s| s.count > 0)?;
    let accuracy = AccuracyDocument {
        sets: vec![set.clone()],
        tool: None,
        map: None,
        placed_apart: Vec::new(),
        effects: Vec::new(),
        left_out: None,
        validation_distance: None,
        relative: None,
        ..identified.accuracy.clone()
    };
    // the region has its own section
    let mut section = errors::section_from_errors(&accuracy, &[], words);
    errors::insert_file_errors(&mut section, results, words);
    section.title = tr!(words, "results-before-and-after");
    let judged = results.judged_file().and_then(|(_, values)| values.deciding_set.as_ref());
    let with_uncertainty = uncertain_errors(&accuracy, judged.unwrap_or(set), words);
    section.table(tr!(words, "results-with-uncertainty"), tr!(words, "certificate-interval"), with_uncertainty);
    section.push(Block::note(tr!(words, "certificate-without-uncertainty")));
    section.push(Block::heading(tr!(words, "residuals-title")));
    section.push(Block::facts(fit::residuals_and_expected(&identified.parameters.residuals, words)));
    fit::insert_readings(&mut section, &identified.parameters, words);
    Some(section)
}

/// Error with its expanded uncertainty.
struct UncertainError<'a> {
    errors: &'a ErrorStatistics,
    figure: Figure,
    expanded_uncertainty: f64,
}

/// Errors of a set whose uncertainty is known.
fn uncertain_errors(accuracy: &AccuracyDocument, set: &AccuracySet, words: &Words) -> Table {
    let lengths = budget::named(accuracy).into_iter().map(|b| (b.quantity, b.figure, b.standard_uncertainty_mm));
    let angles = accuracy.orientation_budget.iter().map(|b| b.standard_uncertainty_deg);
    let all = lengths.chain(angles.map(|u| (ErrorQuantity::Orientation, Figure::Max, u)));
    let rows: Vec<UncertainError> = all
        .filter_map(|(quantity, figure, u)| {
            Some(UncertainError { errors: set.error_statistics(quantity)?, figure, expanded_uncertainty: 2.0 * u })
        })
        .collect();
    let number = |value: f64, row: &UncertainError| with_uncertainty(value, Some(row.expanded_uncertainty));
    let without_noise = |row: &UncertainError| {
        let ends = coverage::interval(accuracy, row.errors, row.figure, row.expanded_uncertainty)?;
        let [from, to] = ends.map(|end| number::with_uncertainty(end, Some(row.expanded_uncertainty)));
        Some(tr!(words, "range", from, to))
    };
    let columns = Columns::<UncertainError>::new()
        .page(phrase!("error"), "", |r| term(words, names::error(r.errors.quantity, r.figure)))
        .page(phrase!("unit"), "", |r| r.errors.unit.as_str())
        .page(phrase!("report-poses"), "", |r| set.counts(r.errors)[0])
        .page(phrase!("errors"), "", |r| r.errors.count)
        .page(phrase!("before"), "", move |r| number(r.figure.value_in(&r.errors.before), r))
        .page(phrase!("after"), "", move |r| number(r.figure.value_in(&r.errors.after), r))
        .page("U (k = 2)", "", |r| significant(r.expanded_uncertainty, 2))
        .page(phrase!("head-without-noise"), "", move |r| numbers(without_noise(r)));
    Table::new(words, &rows, columns)
}

/// Parameters with their expanded uncertainties and status, and the checksum of their document.
fn parameters_section(results: &Results, words: &Words) -> Option<Section> {
    let identified = results.identified.as_ref()?;
    let document = &identified.parameters;
    let mut section = Section::new("parameters", tr!(words, "certificate-parameters"));
    // a value and its expanded uncertainty end at the same digit
    let expanded = |p: &ParameterEntry| p.standard_uncertainty.map(|u| 2.0 * u);
    for (title, group) in &parameters::groups(&document.parameters, words) {
        let columns = Columns::<&ParameterEntry>::new()
            .both(phrase!("name"), "", |p| p.name.as_str())
            .both(phrase!("unit"), "", |p| p.printed_unit())
            .both(phrase!("value"), "", |p| with_uncertainty(p.value, expanded(p)))
            .both("U (k = 2)", "", |p| significant(expanded(p), 2))
            .both(phrase!("from-data"), "%", |p| parameters::share_of_data(p))
            .both(phrase!("status"), "", |p| parameters::status(p, words));
        section.table(title, "", Table::new(words, group, columns).without_empty_columns());
    }
    section.push(Block::note(tr!(words, "certificate-coverage")));
    section.push(Block::note(parameters::links(document, words)));
    section.blocks.extend(parameters::information(document, words));
    section.push(Block::note(budget::left_out(results, words)));
    if document.parameters.iter().any(|p| p.standard_uncertainty.is_none()) {
        section.push(Block::note(tr!(words, "certificate-held")));
    }
    let sha256 = etalon_documents::to_json(document).ok().map(|bytes| files::sha256(&bytes));
    section.push(Block::facts(vec![(tr!(words, "certificate-parameters-hash"), sha256.into())]));
    section.whole()
}

/// Controller files to load with their checksums; without such a file, the reason.
fn loaded_section(results: &Results, words: &Words) -> Option<Section> {
    // output folders of earlier versions do not contain the answer
    let Some(loading) = &results.verdict.loading else { return files_section(results, words) };
    let Some(withheld) = withheld(loading, words) else {
        let is_loaded = |f: &WrittenFile| loading.file.iter().chain(&loading.alternatives).any(|name| *name == f.file);
        return checksums(results, is_loaded, words);
    };
    let mut section = Section::new("loaded-files", tr!(words, "checksums-of-files"));
    section.push(Block::strong(withheld));
    section.whole()
}

/// Statement that no file is to be loaded, with the reason; `None` if the answer is to load.
fn withheld(loading: &Loading, words: &Words) -> Option<String> {
    Some(tr!(words, "certificate-no-file", reason = loading.reason()?))
}

/// Sentences of the verdict; an instruction to load nothing becomes a statement, because next steps
/// are opinions (ISO/IEC 17025:2017, 7.8.7).
fn verdict_sentences(results: &Results, sentences: Vec<String>, words: &Words) -> Vec<String> {
    let loading = results.verdict.loading.as_ref();
    let instruction = loading.and_then(Loading::withheld).map(|answer| sentence(&words.tr(&answer)));
    let state = |said: String| match loading.filter(|_| instruction.as_ref() == Some(&said)) {
        Some(loading) => withheld(loading, words).unwrap_or(said),
        None => said,
    };
    let computed = results.identified.is_some().then(|| computed(results, words));
    // files that are not to be loaded are not listed
    let beyond = super::verdict::files_beyond_limits(results, words);
    sentences.into_iter().filter(|said| beyond.as_ref() != Some(said)).map(state).chain(computed).collect()
}

/// All controller files with their checksums.
pub(super) fn files_section(results: &Results, words: &Words) -> Option<Section> {
    checksums(results, |_| true, words)
}

/// Chosen controller files with their checksums.
fn checksums(results: &Results, chosen: impl Fn(&WrittenFile) -> bool, words: &Words) -> Option<Section> {
    let known = results.campaign.controller_files.iter().filter(|f| f.sha256.is_some() && chosen(f));
    let files: Vec<&WrittenFile> = known.collect();
    let columns = Columns::<&WrittenFile>::new()
        .both(phrase!("file"), "", |f| Cell::from(&f.file))
        .both(phrase!("formats"), "", |f| Text::name(&f.format))
        .both("SHA-256", "", |f| f.sha256.as_deref().map(Text::code));
    let mut section = Section::new("loaded-files", tr!(words, "checksums-of-files"));
    if !files.is_empty() {
        section.push(Block::Table(Table::new(words, &files, columns)));
    }
    section.whole()
}

/// AP and RP of each pose, with measurement point, load and velocity.
fn characteristics_section(results: &Results, words: &Words) -> Option<Section> {
    let document = results.tested.poses.as_ref()?;
    let poses = repeatability::named(document, words);
    let mut section = Section::new("characteristics", tr!(words, "iso9283-characteristics"));
    section.table(tr!(words, "accuracy-of-position"), "", accuracy::positions(&poses, words));
    section.blocks.extend(accuracy::drifting(document, words));
    section.table(tr!(words, "repeatability-title"), "", repeatability::intervals(&poses, words));
    section.blocks.extend(repeatability::unknown_approaches(document, words));
    section.table(tr!(words, "orientation-title"), "", accuracy::orientation(&poses, words));
    section.table("vAP", tr!(words, "definition-vap"), repeatability::variation(document, words));
    repeatability::approach_tables(document, words).into_iter().for_each(|block| section.push(block));
    let note = tr!(words, "definition-quarter-rule");
    section.table(tr!(words, "instrument-good-enough"), note, repeatability::quarter_rule(&poses, words));
    section.table(tr!(words, "coplanarity"), "", repeatability::coplanarity(document, words));
    section.push(Block::note(Text::conventions(&document.conventions, words)));
    section.push(Block::note(tr!(words, "certificate-without-uncertainty")));
    section.whole().map(|section| super::with_measurement_point(section, results, words))
}

/// Warnings that a reader of the results should know.
fn warnings(results: &Results, words: &Words) -> Section {
    let known: Vec<&Message> = results.messages().filter(|m| m.rank != Rank::Routine).collect();
    messages::facts(&known, results.messages().count() - known.len(), words)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::Documents;
    use crate::tests::demo_iso9283;
    use etalon_base::warning;

    fn certificate_contents(documents: &Documents) -> Contents {
        let (words, results) = (Words::default(), documents.results());
        contents(&results, crate::campaign::contents(&results, &words), &words)
    }

    /// Documents with every field.
    fn complete() -> Documents {
        let mut documents = Documents::demo();
        let c = &mut documents.campaign;
        let text = || Some("stated".to_owned());
        (c.measurements.synthetic, c.limits.decision_rule) = (None, Some(etalon_documents::DecisionRule::Guarded));
        c.limits.specification = text();
        let issue = &mut c.issue;
        (issue.number, issue.customer, issue.issued, issue.authorised_by) = (text(), text(), text(), text());
        let given = &mut c.conditions;
        (given.laboratory, given.robot.maker, given.robot.model) = (text(), text(), text());
        (given.robot.serial_number, given.robot.state) = (text(), text());
        (given.instrument_calibration, given.traceability) = (text(), text());
        given.deviations = Some(Vec::new());
        given.robot.controller = text();
        (given.motion.load_kg, given.warm_up_minutes) = (Some(0.0), Some(30.0));
        documents
    }

    #[test]
    fn a_certificate_is_a_draft_until_every_field_is_stated() {
        let whole = certificate_contents(&complete());
        assert_eq!((whole.title.as_str(), &whole.draft), ("Calibration certificate", &None));
        assert!(whole.sections.iter().all(|s| s.id != "checklist"));
        let mut documents = complete();
        documents.campaign.conditions.traceability = None;
        let draft = certificate_contents(&documents);
        assert_eq!(draft.draft.as_deref(), Some("DRAFT"));
        assert!(draft.title.starts_with("Draft"), "{}", draft.title);
        let list = serde_json::to_string(&draft.sections[0]).unwrap();
        assert!(draft.sections[0].id == "checklist" && list.contains("conditions.traceability"), "{list}");
        assert!(!list.contains("conditions.laboratory"), "{list}");
        // blanks state nothing
        documents.campaign.conditions.traceability = Some(" ".to_owned());
        assert!(certificate_contents(&documents).draft.is_some());
    }

    /// Adds a controller file, and returns its checksum.
    fn with_controller_file(documents: &mut Documents) -> String {
        let sha256 = files::sha256(b"a controller file");
        documents.campaign.controller_files = vec![WrittenFile {
            format: "json".to_owned(),
            file: "controller.json".to_owned(),
            is_for_controllers: false,
            sha256: Some(sha256.clone()),
            omitted_effects: Vec::new(),
            inputs: Vec::new(),
            check: None,
        }];
        sha256
    }

    #[test]
    fn a_certificate_is_tied_to_its_inputs_parameters_and_files() {
        let mut documents = complete();
        let sha256 = with_controller_file(&mut documents);
        let results = documents.results();
        let identified = &results.identified.as_ref().unwrap().parameters;
        let parameters = files::sha256(&etalon_documents::to_json(identified).unwrap());
        let text = serde_json::to_string(&certificate_contents(&documents).sections).unwrap();
        let (_, input) = identified.provenance.inputs.first_key_value().unwrap();
        for hash in [&sha256, &parameters, input] {
            assert!(text.contains(hash.as_str()), "{hash}");
        }
        for p in &identified.parameters {
            assert!(text.contains(&p.name), "{}", p.name);
        }
    }

    #[test]
    fn a_certificate_lists_no_file_that_should_not_be_loaded() {
        let (mut documents, words) = (complete(), Words::default());
        let sha256 = with_controller_file(&mut documents);
        let section =
            |documents: &Documents| serde_json::to_string(&loaded_section(&documents.results(), &words)).unwrap();
        assert!(section(&documents).contains(&sha256));
        documents.accuracy.limits[0].acceptance = etalon_documents::Acceptance::Fail;
        let withheld = section(&documents);
        let reason = tr!(words, "certificate-no-file", reason = phrase!("nothing-to-load", answer = "resolve"));
        assert!(!withheld.contains(&sha256) && withheld.contains(&reason), "{withheld}");
    }

    #[test]
    fn a_certificate_says_that_errors_after_calibration_are_computed() {
        let (mut documents, words) = (complete(), Words::default());
        let last = |documents: &Documents| certificate_contents(documents).verdict.sentences.pop().unwrap();
        let computed = tr!(words, "certificate-computed");
        let unknown = tr!(words, "certificate-controller-unknown");
        assert_eq!(last(&documents), format!("{computed} {unknown}"));
        let backup =
            Source { file: "before.bak".to_owned(), kind: SourceKind::Backup, ..documents.import.sources[0].clone() };
        let known = tr!(words, "certificate-controller-before", file = backup.file, sha256 = backup.sha256);
        documents.import.sources.push(backup);
        assert_eq!(last(&documents), format!("{computed} {known}"));
    }

    #[test]
    fn errors_have_their_uncertainty_and_residuals_their_expected_size() {
        let mut documents = complete();
        let errors = |documents: &Documents| {
            let whole = certificate_contents(documents);
            serde_json::to_string(whole.sections.iter().find(|s| s.id == "errors").unwrap()).unwrap()
        };
        assert!(!errors(&documents).contains("0.0038"));
        documents.accuracy.budget = vec![etalon_documents::FigureBudget {
            quantity: ErrorQuantity::Position,
            figure: Figure::Max,
            standard_uncertainty_mm: 0.0019,
            contributions: Vec::new(),
        }];
        // 2 × 0.0019 mm, √(212.4/149) and 0.026 mm over this ratio; 0.0442 mm − 0.0019 mm × √9.348
        // (chi-square of 3 degrees of freedom, 97.5 %), 0.0442 mm + 0.0038 mm
        let text = errors(&documents);
        for number in ["0.0038", "1.19", "0.0218 mm", "0.0384 to 0.0480", "p < 0.001"] {
            assert!(text.contains(number), "{number}: {text}");
        }
    }

    #[test]
    fn sources_are_named_for_what_was_evaluated() {
        let provenance = |documents: &Documents| {
            let whole = certificate_contents(documents);
            let section = whole.sections.iter().find(|s| s.id == "provenance");
            serde_json::to_string(section.unwrap()).unwrap()
        };
        let calibrated = provenance(&complete());
        assert!(calibrated.contains("thesis") && !calibrated.contains("ISO 9283"), "{calibrated}");
        let mut results = complete().results();
        (results.identified, results.geometric) = (None, None);
        results.tested = demo_iso9283::whole();
        let words = Words::default();
        let tested = serde_json::to_string(&provenance::section(&results, &words)).unwrap();
        assert!(tested.contains("ISO 9283") && !tested.contains("thesis"), "{tested}");
    }

    /// The demo gives no scale and no expansion.
    #[test]
    fn what_u_does_not_include_is_on_the_certificate() {
        let section = |results: &Results| {
            let words = Words::default();
            serde_json::to_string(&parameters_section(results, &words)).unwrap()
        };
        let mut results = complete().results();
        let without = section(&results);
        assert!(
            without.contains("expanded_scale_uncertainty_um_per_m") && without.contains("[expansion]"),
            "{without}"
        );
        let budget = &mut results.identified.as_mut().unwrap().parameters.budget;
        budget[0].source = etalon_documents::UncertaintySource::Scale;
        let with = section(&results);
        assert!(!with.contains("expanded_scale_uncertainty_um_per_m") && with.contains("[expansion]"), "{with}");
        let budget = &mut results.identified.as_mut().unwrap().parameters.budget;
        budget[1].source = etalon_documents::UncertaintySource::Temperature;
        assert!(!section(&results).contains("[expansion]"));
    }

    #[test]
    fn synthetic_data_make_no_certificate() {
        let mut documents = complete();
        documents.campaign.measurements.synthetic = Some("made with seed 7".to_owned());
        let whole = certificate_contents(&documents);
        assert!(whole.draft.is_some() && !whole.title.to_lowercase().starts_with("calibration certificate"));
        assert_eq!(whole.title, tr!(Words::default(), "calibration-of-synthetic-data"));
    }

    #[test]
    fn warnings_and_characteristics_of_each_pose_are_on_the_certificate() {
        let mut documents = complete();
        documents.tested = demo_iso9283::whole();
        documents.campaign.conditions.motion.load_kg = Some(2.5);
        documents.campaign.conditions.motion.velocities_percent = Some(vec![100.0]);
        let mut warning = Message::warning("the beam was broken".to_owned());
        warning.rank = Rank::Decide;
        let few = warning!("few-cycles", least = 30, count = 1, poses = 3).hint(phrase!("measure-cycles"));
        documents.import.messages = vec![warning.hint("measure again"), few.to_decide()];
        let whole = certificate_contents(&documents);
        let section = |id: &str| {
            let found = whole.sections.iter().find(|s| s.id == id);
            serde_json::to_string(found.unwrap_or_else(|| panic!("no section {id}"))).unwrap()
        };
        // a warning says what it affects, and gives no advice
        let warnings = section("messages");
        for (text, is_printed) in
            [("the beam was broken", true), ("measure", false), ("intervals of AP and RP are wider", true)]
        {
            assert_eq!(warnings.contains(text), is_printed, "{text}: {warnings}");
        }
        let tested = section("characteristics");
        for text in [
            "Load: 2.5 kg.",
            "Velocity: 100 % of the rated velocity.",
            "Frame of the positions: frame of the table.",
            "AP",
            "RP",
            "AP c",
            "RP c",
        ] {
            assert!(tested.contains(text), "{text}: {tested}");
        }
        let point = section("checklist");
        assert!(point.contains("conditions.measurement_point") && !point.contains("conditions.load_kg"), "{point}");
    }
}

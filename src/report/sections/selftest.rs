//! Record of `etalon selftest`: program and machine with the verdict on the first page, which is
//! signed; tests, seeded faults, stored values and packages follow.

use crate::model::{Block, Cell, Columns, Grade, Section, Table, Text, Verdict, fixed, significant, strong_term, term};
use crate::words::{Words, isolated, tr};
use etalon_base::message::one_line;
use etalon_base::phrase;
use etalon_documents::{
    LockedPackage, MovedValue, ReferenceFile, SelftestCheck, SelftestDocument, SelftestMustFail, SelftestPerformance,
    SelftestRequirement,
};

/// Everything that passed, or everything that failed.
pub(crate) fn verdict(document: &SelftestDocument, words: &Words) -> Verdict {
    let checks = || document.requirements.iter().flat_map(|r| &r.checks);
    let (count, failed) = (checks().count(), checks().filter(|c| !c.pass).count());
    let (slips, missed) = (document.must_fail.len(), document.must_fail.iter().filter(|m| !m.pass).count());
    let mut sentences = Vec::new();
    if failed > 0 {
        sentences.push(tr!(words, "selftest-failed", failed, checks = count));
    }
    if missed > 0 {
        sentences.push(tr!(words, "selftest-slips-missed", missed, slips));
    }
    if document.program.sha256.is_none() {
        sentences.push(tr!(words, "selftest-program-unreadable"));
    } else if !document.program.pass {
        sentences.push(tr!(words, "selftest-program-changed"));
    }
    let changed: Vec<String> = document.reference.iter().filter(|f| !f.pass).map(|f| f.name.clone()).collect();
    if !changed.is_empty() {
        sentences.push(tr!(words, "selftest-reference-changed", files = changed));
    }
    if sentences.is_empty() {
        let requirements = document.requirements.len();
        sentences.push(tr!(words, "selftest-passed", checks = count, requirements, slips));
    }
    if let Some(p) = &document.performance {
        let campaign = isolated(&one_line(&p.campaign));
        sentences.push(match p.moved.len() {
            0 => tr!(words, "selftest-values-same", campaign, compared = p.compared),
            moved => tr!(words, "selftest-values-moved", campaign, moved),
        });
    }
    Verdict { class: Grade::from_met(document.pass), met: document.pass, sentences, ..Verdict::default() }
}

/// First page, then the annexes.
pub(crate) fn sections(document: &SelftestDocument, words: &Words) -> Vec<Section> {
    let performance = document.performance.as_ref().map(|p| performance(p, words));
    let all = [
        Some(overview(document, words)),
        failed(document, words),
        performance,
        Some(installation(document, words).annex()),
        Some(operation(document, words).annex()),
        Some(slips(&document.must_fail, words).annex()),
    ];
    all.into_iter().flatten().filter_map(Section::whole).collect()
}

/// Program, machine, and the requirements with their verdicts.
fn overview(document: &SelftestDocument, words: &Words) -> Section {
    let mut section = Section::new("requirements", tr!(words, "selftest-overview"));
    let machine = &document.machine;
    let nist = match document.reference_folder {
        true => tr!(words, "selftest-nist-present"),
        false => tr!(words, "selftest-nist-absent"),
    };
    section.push(Block::facts(vec![
        (tr!(words, "selftest-program-hash"), document.program.sha256.as_deref().map(Text::code).into()),
        (tr!(words, "selftest-stated-hash"), document.program.expected_sha256.as_deref().map(Text::code).into()),
        (tr!(words, "selftest-system"), format!("{} {}", machine.system, machine.architecture).into()),
        (tr!(words, "selftest-threads-offered"), machine.threads.into()),
        (tr!(words, "selftest-packages"), document.packages.len().into()),
    ]));
    section.push(Block::note(nist));
    let requirement = |r: &SelftestRequirement| Text::worded(&r.requirement, words);
    let failed = |r: &SelftestRequirement| r.checks.iter().filter(|c| !c.pass).count();
    let columns = Columns::<SelftestRequirement>::new()
        .both(phrase!("selftest-requirement"), "", requirement)
        .both(phrase!("selftest-tests"), "", |r| r.checks.len())
        .both(phrase!("selftest-tests-failed"), "", failed)
        .both(phrase!("selftest-result"), "", |r| result(r.pass, words));
    section.push(Block::Table(Table::new(words, &document.requirements, columns).on(phrase!("sheet-requirements"))));
    section.on_terminal()
}

fn result(pass: bool, words: &Words) -> Cell {
    match pass {
        true => term(words, phrase!("selftest-result-pass")),
        false => strong_term(words, phrase!("selftest-result-fail")),
    }
}

/// Tests that failed.
fn failed(document: &SelftestDocument, words: &Words) -> Option<Section> {
    let checks: Vec<&SelftestCheck> =
        document.requirements.iter().flat_map(|r| &r.checks).filter(|check| !check.pass).collect();
    let missed: Vec<&SelftestMustFail> = document.must_fail.iter().filter(|m| !m.pass).collect();
    if checks.is_empty() && missed.is_empty() {
        return None;
    }
    let mut section = Section::new("failed", tr!(words, "selftest-failed-tests"));
    section.push(Block::Table(tests(checks, words)));
    section.push(Block::Table(slip_table(missed, words)));
    Some(section.on_terminal())
}

/// Tests with their values.
fn tests<'a>(checks: impl IntoIterator<Item = &'a SelftestCheck>, words: &'a Words) -> Table {
    let number = |value: Option<f64>| significant(value, 10);
    let columns = Columns::<SelftestCheck>::new()
        .both(phrase!("selftest-test"), "", |c| Text::worded(&c.test, words))
        .both(phrase!("selftest-source"), "", |c| c.source.as_str())
        .both(phrase!("unit"), "", |c| Some(c.unit.as_str()).filter(|unit| !unit.is_empty()))
        .both(phrase!("selftest-expected"), "", move |c| number(c.expected))
        .both(phrase!("selftest-found"), "", move |c| number(c.found))
        .both(phrase!("selftest-deviation"), "", |c| significant(c.deviation, 2))
        .both(phrase!("selftest-permissible"), "", |c| significant(c.permissible, 2))
        .both(phrase!("selftest-result"), "", |c| result(c.pass, words));
    Table::new(words, checks, columns)
}

/// Program and reference data (IQ).
fn installation(document: &SelftestDocument, words: &Words) -> Section {
    let mut section = Section::new("installation", tr!(words, "selftest-installation"));
    let columns = Columns::<ReferenceFile>::new()
        .both(phrase!("file"), "", |f| f.name.as_str())
        .both("SHA-256", "", |f| Text::code(&f.sha256))
        .both(phrase!("selftest-result"), "", |f| result(f.pass, words));
    let files = Table::new(words, &document.reference, columns).on(phrase!("sheet-reference-data"));
    section.table(tr!(words, "selftest-reference-data"), "", files);
    let columns = Columns::<LockedPackage>::new()
        .both(phrase!("selftest-package"), "", |p| p.name.as_str())
        .both(phrase!("selftest-version"), "", |p| p.version.as_str())
        .sheet("SHA-256", "", |p| p.sha256.as_deref().map(Text::code));
    let packages = Table::new(words, &document.packages, columns).on(phrase!("sheet-packages"));
    section.table(tr!(words, "selftest-packages"), tr!(words, "selftest-packages-note"), packages);
    section
}

/// Tests of each requirement (OQ).
fn operation(document: &SelftestDocument, words: &Words) -> Section {
    let mut section = Section::new("operation", tr!(words, "selftest-operation"));
    for r in &document.requirements {
        let heading = Text::worded(&r.requirement, words).plain();
        section.table(heading, "", tests(&r.checks, words).on(phrase!("sheet-tests")));
    }
    section
}

/// Seeded faults that must be noticed.
fn slips(all: &[SelftestMustFail], words: &Words) -> Section {
    let mut section = Section::new("slips", tr!(words, "selftest-slips"));
    section.push(Block::Table(slip_table(all, words).on(phrase!("sheet-slips"))));
    section
}

fn slip_table<'a>(all: impl IntoIterator<Item = &'a SelftestMustFail>, words: &'a Words) -> Table {
    let verdict = |m: &SelftestMustFail| match m.pass {
        true => term(words, phrase!("selftest-as-it-must")),
        false => strong_term(words, phrase!("selftest-missed")),
    };
    let columns = Columns::<SelftestMustFail>::new()
        .both(phrase!("selftest-requirement"), "", |m| m.id.as_str())
        .both(phrase!("selftest-slip"), "", |m| Text::worded(&m.slip, words))
        .both(phrase!("selftest-tests"), "", |m| m.checks)
        .both(phrase!("selftest-tests-failed"), "", |m| m.failed)
        .both(phrase!("selftest-result"), "", verdict);
    Table::new(words, all, columns)
}

/// Values of the laboratory's own campaign (PQ).
fn performance(document: &SelftestPerformance, words: &Words) -> Section {
    let mut section = Section::new("performance", tr!(words, "selftest-performance"));
    let (of_uncertainty, relative) = (document.tolerance_of_uncertainty, document.relative_tolerance);
    section.push(Block::note(tr!(words, "selftest-tolerance", of_uncertainty, relative)));
    let columns = Columns::<MovedValue>::new()
        .both(phrase!("parameter"), "", |m| Some(m.parameter.as_str()).filter(|name| !name.is_empty()))
        .both(phrase!("selftest-quantity"), "", |m| m.quantity.as_str())
        .both(phrase!("unit"), "", |m| m.unit.as_str())
        .both(phrase!("before"), "", |m| significant(m.before, 15))
        .both(phrase!("after"), "", |m| significant(m.after, 15))
        .both(phrase!("selftest-over-u"), "", |m| fixed(m.over_uncertainty, 6));
    section.push(Block::Table(Table::new(words, &document.moved, columns).on(phrase!("sheet-moved-values"))));
    for cause in &document.causes {
        let cause = Text::worded(cause, words).plain();
        section.push(Block::text(tr!(words, "selftest-cause", cause)));
    }
    if document.causes.is_empty() && !document.pass {
        section.push(Block::text(tr!(words, "selftest-cause-unknown")));
    }
    section.on_terminal()
}

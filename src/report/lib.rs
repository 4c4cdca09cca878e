//! Reports. Sections are created once from the documents, and rendered as a page
//! without network access, as a PDF to be signed, as a workbook, and on the terminal.
//!
//! Every renderer is a pure function: it reads only its arguments and writes equal bytes for equal
//! documents. A new section needs a file in `sections`, a line in
//! `sections/mod.rs`, and its texts in `src/base/messages/*/report.ftl`.
#![allow(non_snake_case)] // frames in names, such as `world_T_base`

pub mod batch;
pub mod branding;
mod campaign;
mod coverage;
mod html;
mod model;
pub(crate) mod number;
#[cfg(feature = "pdf")]
mod pdf;
mod plots;
mod sections;
mod terminal;
#[cfg(test)]
mod tests;
pub(crate) mod words;
mod workbook;

use etalon_base::date::source_date_epoch;
use etalon_base::error;
use etalon_base::message::{Message, Result, one_line};
use etalon_documents::{
    AccuracyDocument, CampaignReference, CellDocument, Characteristics, CompareDocument, ParametersDocument,
    PlanDocument, Presentation, Provenance, RecommendationDocument, Results, SelftestDocument, UncertaintyDocument,
    VerificationDocument, VerificationPlanDocument,
};
use model::{Contents, Dates, Layout, Section, Verdict};
use sections::provenance::Evaluated;
use serde::Serialize;
use words::{Words, isolated, tr};

/// Template of report.pdf for typst.
const TYPESET: (&str, &str) = ("report.typ", include_str!("pdf/report.typ"));

/// Lines for a controller in the report of a cell.
#[derive(Clone, Copy, Debug)]
pub struct CellLines<'a> {
    /// Name of the format.
    pub maker: &'a str,
    /// Lines.
    pub text: &'a str,
    /// Warnings about them.
    pub messages: &'a [Message],
}

/// Campaign to which an answer refers.
struct Head<'a> {
    label: String,
    campaign: Option<&'a CampaignReference>,
}

impl Head<'_> {
    /// Adds date, synthetic mark, campaign and files to the contents of an answer.
    fn on(self, mut contents: Contents, provenance: Option<&Provenance>, words: &Words) -> Contents {
        let Self { label, campaign } = self;
        contents.dates.date = campaign.and_then(|c| c.date.clone());
        contents.synthetic = campaign.and_then(|c| c.synthetic.clone()).into_iter().collect();
        let mut origin = match provenance {
            Some(provenance) => {
                sections::provenance::section_from_provenance(provenance, Evaluated::IDENTIFICATION, &[], words)
            }
            None => Section::new("provenance", tr!(words, "provenance")),
        };
        if let Some(c) = campaign {
            origin.begin(model::Block::facts(vec![
                (label, c.name.as_str().into()),
                (tr!(words, "robot"), c.robot.as_ref().into()),
                (tr!(words, "date"), c.date.as_ref().into()),
                (tr!(words, "instrument"), c.instrument.as_ref().into()),
            ]));
        }
        contents.sections.extend(origin.whole());
        contents
    }
}

/// Subject of an answer.
fn named(robot: &str, words: &Words) -> String {
    tr!(words, "robot-of-model", model = words.model(robot))
}

/// A document attached to a PDF.
#[derive(Debug, Serialize)]
struct Attachment {
    name: &'static str,
    /// Relationship to the report (ISO 19005-3, 6.8).
    relationship: &'static str,
    description: String,
    mime: &'static str,
    text: String,
}

impl Attachment {
    fn new<T: Serialize>(
        name: &'static str,
        relationship: &'static str,
        description: String,
        document: &T,
    ) -> Result<Self> {
        let text = serde_json::to_string_pretty(document)
            .map_err(|e| error!("cannot-encode", format = "JSON", reason = e.to_string()))?;
        Ok(Self { name, relationship, description, mime: "application/json", text: text + "\n" })
    }
}

/// Name and bytes of a file.
pub type File = (&'static str, Vec<u8>);

/// Files of a report by file extension.
const FILES: &[(&str, &str)] = &[
    ("html", "report.html"),
    #[cfg(feature = "pdf")]
    ("pdf", "report.pdf"),
    ("xlsx", "report.xlsx"),
];

/// Files of a certificate by file extension.
const CERTIFICATE: &[(&str, &str)] = &[
    ("html", "certificate.html"),
    #[cfg(feature = "pdf")]
    ("pdf", "certificate.pdf"),
];

/// Verdict of a run in words, as page one of its report contains it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct VerdictInWords {
    /// Sentences.
    pub sentences: Vec<String>,
    /// Next steps with their reasons.
    pub steps: Vec<String>,
}

/// Verdict of a run in the language of its report.
pub fn verdict_in_words(results: &Results) -> VerdictInWords {
    let verdict = sections::verdict::verdict(results, &Words::new(results.campaign.report.language));
    let plain = |text: &str| text.replace(['\u{2068}', '\u{2069}'], "");
    let step = |step: &model::Step| {
        let command = step.command.as_ref().map_or_else(String::new, |command| format!(" `{command}`"));
        plain(&format!("{} {}{command}", step.what.plain(), step.reason.plain()))
    };
    VerdictInWords {
        sentences: verdict.sentences.iter().map(|sentence| plain(sentence)).collect(),
        steps: verdict.steps.iter().map(step).collect(),
    }
}

/// Kinds of report files, by file extension.
pub fn kinds() -> impl Iterator<Item = &'static str> {
    FILES.iter().map(|(kind, _)| *kind)
}

/// A report created once from its documents, to be rendered to files and on the terminal.
#[derive(Debug)]
pub struct Renderer {
    contents: Contents,
    /// Attached to the PDF only.
    attachments: Vec<Attachment>,
    presentation: Presentation,
    words: Words,
}

impl Renderer {
    fn new(contents: Contents, attachments: Vec<Attachment>, presentation: Presentation, words: Words) -> Self {
        // commands reject another value of the variable
        let built = source_date_epoch().unwrap_or_default();
        let mut contents = contents.explained(&words).in_language(&words);
        contents.dates.built = built;
        Self { contents, attachments, presentation, words }
    }

    /// Creates the report of a campaign.
    pub fn campaign(results: &Results) -> Result<Self> {
        let presentation = results.campaign.report.clone();
        let words = Words::new(presentation.language);
        let contents = campaign::contents(results, &words);
        Ok(Self::new(contents, campaign::attachments(results, &words)?, presentation, words))
    }

    /// Creates the report of a comparison of campaigns.
    pub fn comparison(document: &CompareDocument, presentation: Presentation) -> Result<Self> {
        use sections::changes::{lead, sections, verdict};
        let words = Words::new(presentation.language);
        let synthetic = document
            .campaigns
            .iter()
            .filter_map(|c| Some(format!("{}: {}", one_line(&c.folder), c.synthetic.as_ref()?)));
        let contents = Contents {
            title: tr!(words, "what-changed"),
            subtitle: lead(document, &words),
            synthetic: synthetic.collect(),
            dates: Dates { date: document.campaigns.iter().rev().find_map(|c| c.date.clone()), ..Dates::default() },
            version: document.provenance.version.clone(),
            verdict: verdict(document, &words),
            sections: sections(document, &words),
            ..Contents::default()
        };
        let attachments = vec![Attachment::new("compare.json", "data", tr!(words, "attached-changes"), document)?];
        Ok(Self::new(contents, attachments, presentation, words))
    }

    /// Creates the report of a plan.
    pub fn plan(document: &PlanDocument, presentation: Presentation) -> Result<Self> {
        use sections::plan::{sections, verdict};
        let words = Words::new(presentation.language);
        let robot = words.model(&document.robot);
        let contents = Contents {
            title: tr!(words, "poses-to-measure"),
            subtitle: tr!(words, "plan-for-model", model = robot),
            version: document.provenance.version.clone(),
            verdict: verdict(document, &words),
            sections: sections(document, &words),
            ..Contents::default()
        };
        let attachments = vec![Attachment::new("plan.json", "data", tr!(words, "attached-plan"), document)?];
        Ok(Self::new(contents, attachments, presentation, words))
    }

    /// Creates the report of a frame of a robot cell, with the lines for a controller.
    pub fn cell(document: &CellDocument, lines: Option<CellLines>, presentation: Presentation) -> Result<Self> {
        use sections::cell::{sections, verdict};
        let words = Words::new(presentation.language);
        let evaluated = Evaluated::IDENTIFICATION;
        let origin = sections::provenance::section_from_provenance(&document.provenance, evaluated, &[], &words);
        let mut sections = sections(document, lines, &words);
        sections.extend(origin.whole());
        let contents = Contents {
            title: tr!(words, "cell-title", solve = document.solve),
            subtitle: tr!(words, "cell-subtitle", readings = document.readings),
            verdict: verdict(document, lines, &words),
            sections,
            ..Contents::default()
        };
        let attached = Attachment::new("cell.json", "data", tr!(words, "attached-cell"), document)?;
        Ok(Self::answer(contents, attached, presentation, words))
    }

    /// Creates the report of ISO 9283 characteristics without a campaign.
    pub fn test(tested: &Characteristics) -> Self {
        let words = Words::default();
        let title = sections::verdict::title(tested, &words);
        let verdict = sections::verdict::test_verdict(tested, &words);
        Self::without_campaign(title, verdict, sections::tested(tested, &words), words)
    }

    /// Creates the report of given parameters that were judged on the data of a campaign.
    pub fn validation(document: &AccuracyDocument, presentation: Presentation) -> Result<Self> {
        let words = Words::new(presentation.language);
        let verdict = sections::verdict::validation_verdict(document, &words);
        let limits: Vec<_> = document.limits.iter().collect();
        let limits = sections::limits::section_from_verdicts(&limits, false, &words);
        let errors = sections::errors::section_from_errors(document, &[], &words);
        let field = document.field.as_ref().and_then(|field| sections::field::section_from_summary(field, &words));
        let sections = limits.into_iter().chain([errors]).chain(field).collect();
        let title = tr!(words, "validation-of-given-parameters");
        let attached = Attachment::new("accuracy.json", "data", tr!(words, "attached-validation"), document)?;
        let subtitle = document.campaign.as_ref().map(|c| isolated(&one_line(&c.name))).unwrap_or_default();
        let contents = Contents { title, subtitle, verdict, sections, ..Contents::default() };
        let head = Head { label: tr!(words, "campaign"), campaign: document.campaign.as_ref() };
        let contents = head.on(contents, document.provenance.as_ref(), &words);
        Ok(Self::answer(contents, attached, presentation, words))
    }

    /// Creates the report on whether given parameters still apply.
    pub fn verification(document: &VerificationDocument, presentation: Presentation) -> Result<Self> {
        use sections::validity::{still_valid, verification};
        let words = Words::new(presentation.language);
        let contents = Contents {
            title: tr!(words, "verification-of-identified-parameters"),
            subtitle: named(&document.robot, &words),
            verdict: still_valid(document, &words),
            sections: verification(document, &words),
            ..Contents::default()
        };
        let head = Head { label: tr!(words, "campaign-of-parameters"), campaign: document.calibration.as_ref() };
        let contents = head.on(contents, Some(&document.provenance), &words);
        let attached = Attachment::new("verification.json", "data", tr!(words, "attached-verified"), document)?;
        Ok(Self::answer(contents, attached, presentation, words))
    }

    /// Creates the report of poses that verify parameters.
    pub fn verification_plan(document: &VerificationPlanDocument, presentation: Presentation) -> Result<Self> {
        use sections::validity::{chosen, poses_to_verify};
        let words = Words::new(presentation.language);
        let contents = Contents {
            title: tr!(words, "poses-to-verify-identified-parameters"),
            subtitle: named(&document.robot, &words),
            verdict: chosen(document, &words),
            sections: poses_to_verify(document, &words),
            ..Contents::default()
        };
        let attached =
            Attachment::new("verification-plan.json", "data", tr!(words, "attached-verification"), document)?;
        Ok(Self::answer(contents, attached, presentation, words))
    }

    /// Creates the report of recommended parameters.
    pub fn recommendation(document: &RecommendationDocument, presentation: Presentation) -> Result<Self> {
        use sections::validity::{recommendation, recommended};
        let words = Words::new(presentation.language);
        let contents = Contents {
            title: tr!(words, "recommendation-title"),
            subtitle: named(&document.robot, &words),
            verdict: recommended(document, &words),
            sections: recommendation(document, &words),
            ..Contents::default()
        };
        let head = Head { label: tr!(words, "campaign"), campaign: document.campaign.as_ref() };
        let contents = head.on(contents, Some(&document.recommended.provenance), &words);
        let attached = Attachment::new("recommendation.json", "data", tr!(words, "attached-recommendation"), document)?;
        Ok(Self::answer(contents, attached, presentation, words))
    }

    /// Report of a command's answer.
    fn answer(contents: Contents, attached: Attachment, presentation: Presentation, words: Words) -> Self {
        let version = env!("CARGO_PKG_VERSION").to_owned();
        Self::new(Contents { version, ..contents }, vec![attached], presentation, words)
    }

    /// Creates the certificate of a campaign for the customer: a draft until all fields are given.
    pub fn certificate(results: &Results) -> Result<Self> {
        let presentation = results.campaign.report.clone();
        let words = Words::new(presentation.language);
        let contents = sections::certificate::contents(results, campaign::contents(results, &words), &words);
        Ok(Self::new(contents, campaign::attachments(results, &words)?, presentation, words))
    }

    /// Creates the report of an identification without a campaign.
    pub fn identification(document: &ParametersDocument) -> Self {
        let words = Words::default();
        let title = campaign::model_title(document, &words);
        let verdict = sections::verdict::identification_verdict(document, &words);
        let parameters = sections::parameters::section_from_document(document, &words);
        let sections = vec![
            parameters.on_terminal(),
            sections::fit::section_from_document(document, Vec::new(), &words).on_terminal(),
        ];
        Self::without_campaign(title, verdict, sections, words)
    }

    /// Creates the report of distributions of a campaign's results.
    pub fn uncertainty(document: &UncertaintyDocument, presentation: Presentation) -> Result<Self> {
        use sections::distributions::{sections, verdict};
        let words = Words::new(presentation.language);
        let contents = Contents {
            title: tr!(words, "uncertainties-of-robot", robot = isolated(&one_line(&document.robot))),
            verdict: verdict(document, &words),
            sections: sections(document, &words),
            ..Contents::default()
        };
        let head = Head { label: tr!(words, "campaign"), campaign: document.campaign.as_ref() };
        let contents = head.on(contents, Some(&document.provenance), &words);
        let attached = Attachment::new("uncertainty.json", "data", tr!(words, "attached-distributions"), document)?;
        Ok(Self::answer(contents, attached, presentation, words))
    }

    /// Creates the record of the validation of an installation.
    pub fn selftest(document: &SelftestDocument, presentation: Presentation) -> Result<Self> {
        use sections::selftest::{sections, verdict};
        let words = Words::new(presentation.language);
        let machine = &document.machine;
        let (version, system) = (&document.program.version, &machine.system);
        let contents = Contents {
            title: tr!(words, "selftest-title"),
            subtitle: tr!(words, "selftest-subtitle", version, system, architecture = machine.architecture),
            verdict: verdict(document, &words),
            sections: sections(document, &words),
            statement: tr!(words, "selftest-statement"),
            layout: Layout { signed: true, ..Layout::default() },
            ..Contents::default()
        };
        let attached = Attachment::new("selftest.json", "data", tr!(words, "attached-selftest"), document)?;
        Ok(Self::answer(contents, attached, presentation, words))
    }

    fn without_campaign(title: String, verdict: Verdict, sections: Vec<Section>, words: Words) -> Self {
        let contents = Contents { title, verdict, sections, ..Contents::default() };
        Self { contents, attachments: Vec::new(), presentation: Presentation::default(), words }
    }

    /// `true` if all limits are met and the result is plausible.
    pub fn passes(&self) -> bool {
        self.contents.verdict.met
    }

    /// Attaches the digital calibration certificate of the same results, an XML file, to the PDF.
    pub fn with_certificate(mut self, name: &'static str, xml: Option<&[u8]>) -> Self {
        let attached = |xml| Attachment {
            name,
            relationship: "alternative",
            description: tr!(self.words, "attached-certificate"),
            mime: "application/xml",
            text: String::from_utf8_lossy(xml).into_owned(),
        };
        self.attachments.extend(xml.map(attached));
        self
    }

    /// Text for the terminal.
    pub fn terminal(&self) -> String {
        terminal::terminal(&self.contents, &self.words)
    }

    /// Files of the certificate.
    pub fn certificate_files(&self) -> Result<Vec<File>> {
        CERTIFICATE.iter().map(|(kind, name)| Ok((*name, self.file(kind)?))).collect()
    }

    /// Files of the report.
    pub fn files(&self) -> Result<Vec<File>> {
        FILES.iter().map(|(kind, name)| Ok((*name, self.file(kind)?))).collect()
    }

    /// File of one of the [`kinds`].
    pub fn file(&self, kind: &str) -> Result<Vec<u8>> {
        match kind {
            "xlsx" => workbook::workbook(&self.contents, &self.words),
            #[cfg(feature = "pdf")]
            "pdf" => pdf::pdf(&self.contents, &self.attachments, &self.presentation, &self.words),
            _ => Ok(html::html(&self.contents, &self.presentation, &self.words)?.into_bytes()),
        }
    }
}

/// Built-in templates by file name.
pub fn templates() -> impl Iterator<Item = (&'static str, &'static str)> {
    html::BUILT_IN.into_iter().chain([TYPESET])
}

/// Checks the syntax of the laboratory's templates without a report.
pub fn check_templates(presentation: &Presentation) -> Result<()> {
    if presentation.templates.is_empty() {
        return Ok(());
    }
    html::check(presentation)?;
    #[cfg(feature = "pdf")]
    presentation.templates.get(TYPESET.0).map_or(Ok(()), |text| pdf::check(text))?;
    Ok(())
}

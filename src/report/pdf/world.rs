//! Environment of a typst template: given files and fonts of the program, without disk, network or
//! clock.

use etalon_base::date::Date;
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_base::{error, phrase};
use std::collections::BTreeMap;
use std::sync::OnceLock;
use typst::diag::{FileError, FileResult, SourceDiagnostic};
use typst::foundations::{Bytes, Datetime, Duration, Smart};
use typst::syntax::{FileId, RootedPath, Source, VirtualPath, VirtualRoot};
use typst::text::{Font, FontBook};
use typst::utils::LazyHash;
use typst::{Library, LibraryExt, World, WorldExt};
use typst_layout::PagedDocument;
use typst_pdf::{PdfOptions, PdfStandard, PdfStandards, Timestamp};

/// Main file; attachments come first, so that no template can omit them.
const MAIN: &str = "main.typ";
const START: &str = "#for file in json(\"attachments.json\") {\n  \
    pdf.attach(file.name, bytes(file.text), relationship: file.relationship, mime-type: file.mime, \
    description: file.description)\n}\n#include \"report.typ\"\n";

/// Number of documents after which typst forgets unused results.
const REMEMBERED: usize = 1;

/// Files, fonts and current date.
pub(super) struct Desk {
    library: LazyHash<Library>,
    main: FileId,
    files: BTreeMap<String, Bytes>,
    date: Datetime,
}

impl Desk {
    /// Creates the environment. `files` by name: `report.typ` and the files that it reads.
    pub fn new(mut files: BTreeMap<String, Bytes>, date: Date) -> Result<Self> {
        files.insert(MAIN.to_owned(), Bytes::from_string(START));
        let date =
            Datetime::from_ymd(date.year, date.month, date.day).ok_or_else(|| error!("date-invalid", key = "date"))?;
        Ok(Self { library: LazyHash::new(Library::default()), main: id(MAIN)?, files, date })
    }

    /// Checks the syntax of a file.
    pub fn check(&self, name: &str) -> Result<()> {
        let source =
            self.source(id(name)?).map_err(|e| error!("typesetting-failed", reason = format!("{name}: {e}")))?;
        let (errors, _) = source.root().errors_and_warnings();
        let wrong = errors.into_iter().map(|e| self.message(&SourceDiagnostic::from(e)));
        Problems(wrong.collect()).check().map(|_| ())
    }

    /// Typeset document as PDF/A-3a, identified by `ident`.
    pub fn pdf(&self, ident: &str) -> Result<Vec<u8>> {
        let made = self.typeset(ident);
        // typst remembers all results; common ones were used in this document
        comemo::evict(REMEMBERED);
        made
    }

    fn typeset(&self, ident: &str) -> Result<Vec<u8>> {
        let problems =
            |diagnostics: &[SourceDiagnostic]| Problems(diagnostics.iter().map(|d| self.message(d)).collect());
        let document = typst::compile::<PagedDocument>(self).output.map_err(|e| problems(&e))?;
        let standards = PdfStandards::new(&[PdfStandard::A_3a])
            .map_err(|e| error!("typesetting-failed", reason = e.message().as_str()))?;
        let options = PdfOptions {
            ident: Smart::Custom(ident.to_owned()),
            creator: Smart::Custom(Some(concat!("etalon ", env!("CARGO_PKG_VERSION")).to_owned())),
            timestamp: Some(Timestamp::new_utc(self.date)),
            standards,
            ..PdfOptions::default()
        };
        typst_pdf::pdf(&document, &options).map_err(|e| problems(&e))
    }

    /// Converts a diagnostic to a message with its place in the template.
    fn message(&self, diagnostic: &SourceDiagnostic) -> Message {
        let message = error!("typesetting-failed", reason = diagnostic.message.as_str());
        let place = diagnostic.span.id().and_then(|id| {
            let (source, span) = (self.source(id).ok()?, self.range(diagnostic.span)?);
            Some(Place::span(id.vpath().get_without_slash(), source.text(), span))
        });
        let message = place.map_or(message.clone(), |place| message.at(place));
        match diagnostic.hints.first() {
            Some(hint) => message.hint(phrase!("own-hint", text = hint.v.as_str())),
            None => message,
        }
    }
}

fn id(name: &str) -> Result<FileId> {
    let path = VirtualPath::new(name).map_err(|e| error!("typesetting-failed", reason = format!("{name}: {e:?}")))?;
    Ok(RootedPath::new(VirtualRoot::Project, path).intern())
}

impl World for Desk {
    fn library(&self) -> &LazyHash<Library> {
        &self.library
    }

    fn book(&self) -> &LazyHash<FontBook> {
        &fonts().1
    }

    fn main(&self) -> FileId {
        self.main
    }

    fn source(&self, id: FileId) -> FileResult<Source> {
        let bytes = self.file(id)?;
        let text = std::str::from_utf8(&bytes).map_err(|_| FileError::InvalidUtf8)?;
        Ok(Source::new(id, text.to_owned()))
    }

    fn file(&self, id: FileId) -> FileResult<Bytes> {
        let name = id.vpath().get_without_slash();
        let here = matches!(id.root(), VirtualRoot::Project);
        let file = self.files.get(name).filter(|_| here);
        file.cloned().ok_or_else(|| FileError::NotFound(name.into()))
    }

    fn font(&self, index: usize) -> Option<Font> {
        fonts().0.get(index).cloned()
    }

    fn today(&self, _: Option<Duration>) -> Option<Datetime> {
        Some(self.date)
    }
}

/// Fonts of the program, loaded once. Typst has further fonts, but not all have a suitable licence.
pub(super) fn fonts() -> &'static (Vec<Font>, LazyHash<FontBook>) {
    static FONTS: OnceLock<(Vec<Font>, LazyHash<FontBook>)> = OnceLock::new();
    const FILES: [&[u8]; 4] = [
        include_bytes!("fonts/LibertinusSerif-Regular.otf"),
        include_bytes!("fonts/LibertinusSerif-Bold.otf"),
        include_bytes!("fonts/LibertinusSerif-Italic.otf"),
        include_bytes!("fonts/DejaVuSansMono.ttf"),
    ];
    FONTS.get_or_init(|| {
        let fonts: Vec<Font> = FILES.into_iter().flat_map(|data| Font::iter(Bytes::new(data))).collect();
        let book = LazyHash::new(FontBook::from_fonts(&fonts));
        (fonts, book)
    })
}

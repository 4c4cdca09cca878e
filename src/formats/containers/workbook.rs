//! Sheets of an Excel workbook (.xlsx) as rows of text: cells separated by tabs, with the row
//! numbers of the sheet.

use crate::unpack::Budget;
use calamine::{DataRef, Reader, Xlsx};
use etalon_base::catalogue::{IntoArgument, Phrase};
use etalon_base::message::Message;
use etalon_base::{error, phrase};
use etalon_tables::Decimal;
use etalon_tables::lexer::written_out;
use std::collections::BTreeMap;
use std::io::{Cursor, Read};

/// Maximum unpacked size (bytes); a larger workbook is rejected.
const LARGEST: u64 = 64 << 20;
/// Maximum index of a column.
const MOST_COLUMNS: u32 = 1024;
/// Maximum number of rows, as in Excel.
const MOST_ROWS: u32 = 1 << 20;

/// `true` if the bytes begin like a workbook.
pub(crate) fn is_workbook(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PK\x03\x04")
}

/// Workbook whose size is checked once.
pub(crate) struct Workbook<'a> {
    book: Xlsx<Cursor<&'a [u8]>>,
    /// Texts of cells: many cells may repeat one long text.
    texts: Budget,
}

impl<'a> Workbook<'a> {
    /// Opens a workbook.
    ///
    /// # Errors
    /// Fails if the bytes are no workbook, or unpack to more than 64 MiB.
    pub fn open(bytes: &'a [u8]) -> Result<Self, Message> {
        let mut budget = Budget::new(KIND, bytes.len(), LARGEST);
        let mut archive = budget.open(bytes, |reason| unreadable(&reason))?;
        for i in 0..archive.len() {
            let entry = archive.by_index(i).map_err(|e| unreadable(&e.to_string()))?;
            // the sizes that an archive declares may be wrong
            let mut unpacked = entry.take(LARGEST + 1);
            let size = std::io::copy(&mut unpacked, &mut std::io::sink()).map_err(|e| unreadable(&e.to_string()))?;
            budget.take(size)?;
        }
        let book = Xlsx::new(Cursor::new(bytes)).map_err(|e| unreadable(&e.to_string()))?;
        Ok(Self { book, texts: Budget::new(KIND, bytes.len(), LARGEST) })
    }

    /// Names of the sheets.
    pub fn sheets(&self) -> Vec<String> {
        self.book.sheet_names()
    }

    /// Cells of a sheet as text. Numbers have all their digits and this decimal mark, like cells
    /// that are texts; a line break within a cell is a blank.
    pub fn text(&mut self, sheet: &str, decimal: Decimal) -> Result<String, Message> {
        let names = self.sheets();
        if !names.iter().any(|name| name == sheet) {
            return Err(error!("sheet-missing", sheet).hint_names(sheet, names.iter().map(String::as_str)));
        }
        let mut cells = self.book.worksheet_cells_reader(sheet).map_err(|e| unreadable(&e.to_string()))?;
        let mut text = String::new();
        let (mut row, mut column) = (0, 0);
        let mut empty: BTreeMap<(u32, u32), usize> = BTreeMap::new();
        while let Some(cell) = cells.next_cell().map_err(|e| unreadable(&e.to_string()))? {
            let (r, c) = cell.get_position();
            if r < row || (r == row && c < column) {
                return Err(unreadable(&phrase!("cells-unordered", sheet, row = u64::from(r) + 1)));
            }
            if c > MOST_COLUMNS || r >= MOST_ROWS {
                let (column, row) = (u64::from(c) + 1, u64::from(r) + 1);
                return Err(error!("sheet-too-large", sheet, column, row, columns = MOST_COLUMNS, rows = MOST_ROWS));
            }
            let before = text.len();
            if r > row {
                text.extend(std::iter::repeat_n('\n', (r - row) as usize));
                (row, column) = (r, 0);
            }
            text.extend(std::iter::repeat_n('\t', (c - column) as usize));
            column = c;
            if *cell.get_value() == DataRef::Empty {
                empty.insert((r, c), text.len());
            }
            text.push_str(&field(cell.get_value(), decimal));
            self.texts.take((text.len() - before) as u64)?;
        }
        drop(cells);
        text.push('\n');
        self.with_formulas(sheet, text, &empty)
    }

    /// The text of a sheet with the formulas of cells that have no value, which are not empty;
    /// `empty` has the places of cells without a value in the text.
    fn with_formulas(
        &mut self,
        sheet: &str,
        text: String,
        empty: &BTreeMap<(u32, u32), usize>,
    ) -> Result<String, Message> {
        if empty.is_empty() {
            return Ok(text);
        }
        let mut formulas = self.book.worksheet_cells_reader(sheet).map_err(|e| unreadable(&e.to_string()))?;
        let (mut whole, mut done) = (String::new(), 0);
        while let Some(cell) = formulas.next_formula().map_err(|e| unreadable(&e.to_string()))? {
            let Some(at) = empty.get(&cell.get_position()).filter(|at| **at >= done) else { continue };
            whole.push_str(&text[done..*at]);
            done = *at;
            if !cell.get_value().is_empty() {
                let formula = field(&DataRef::String(format!("={}", cell.get_value())), Decimal::Point);
                self.texts.take(formula.len() as u64)?;
                whole.push_str(&formula);
            }
        }
        Ok(whole + &text[done..])
    }
}

/// Kind of the file in messages.
const KIND: &str = "workbook";

/// Cells of a sheet as text, like [`Workbook::text`].
pub(crate) fn text(bytes: &[u8], sheet: &str, decimal: Decimal) -> Result<String, Message> {
    Workbook::open(bytes)?.text(sheet, decimal)
}

fn unreadable(reason: &impl IntoArgument) -> Message {
    error!("workbook-unreadable", reason)
}

/// A cell as a field between tabs.
fn field(value: &DataRef, decimal: Decimal) -> String {
    let text = match value {
        DataRef::Empty => String::new(),
        DataRef::Int(v) => v.to_string(),
        DataRef::Float(v) => written_out(*v, decimal),
        DataRef::String(text) => text.clone(),
        DataRef::SharedString(text) => (*text).to_owned(),
        DataRef::Bool(v) => v.to_string(),
        // Excel makes a date of a label like 1-2: `date ...` is not mistaken for a label
        DataRef::DateTime(date) => {
            let (year, month, day, hour, minute, second, _) = date.to_ymd_hms_milli();
            format!("date {year:04}-{month:02}-{day:02} {hour:02}:{minute:02}:{second:02}")
        }
        DataRef::DateTimeIso(text) | DataRef::DurationIso(text) => format!("date {text}"),
        DataRef::Error(e) => e.to_string(),
    };
    let text = text.replace(['\r', '\n', '\0'], " ");
    match text.contains(['\t', '"']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text,
    }
}

/// Remark of a proposal about the other sheets of a workbook.
pub(crate) fn others(names: &[String], taken: &str) -> Option<Phrase> {
    let others: Vec<&str> = names.iter().map(String::as_str).filter(|name| *name != taken).collect();
    (!others.is_empty()).then(|| phrase!("doubt-other-sheets", count = others.len(), sheets = others))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write;
    use zip::write::SimpleFileOptions;

    const MAIN: &str = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
    const RELATED: &str = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";

    /// Returns a workbook with one sheet of these rows, as the standard (ECMA-376) wants it at
    /// least.
    fn workbook(sheet: &str, rows: &str) -> Vec<u8> {
        workbook_with(sheet, rows, None)
    }

    /// A workbook with texts that cells share.
    fn workbook_with(sheet: &str, rows: &str, shared: Option<&str>) -> Vec<u8> {
        let mut zip = zip::ZipWriter::new(Cursor::new(Vec::new()));
        let options = SimpleFileOptions::default().compression_method(zip::CompressionMethod::Deflated);
        let office = "application/vnd.openxmlformats-officedocument.spreadsheetml";
        let files = [
            (
                "[Content_Types].xml",
                format!(
                    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\
                     <Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\
                     <Override PartName=\"/xl/workbook.xml\" ContentType=\"{office}.sheet.main+xml\"/>\
                     <Override PartName=\"/xl/worksheets/sheet1.xml\" ContentType=\"{office}.worksheet+xml\"/></Types>"
                ),
            ),
            (
                "_rels/.rels",
                format!(
                    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\
                     <Relationship Id=\"r1\" Type=\"{RELATED}/officeDocument\" Target=\"xl/workbook.xml\"/></Relationships>"
                ),
            ),
            (
                "xl/workbook.xml",
                format!(
                    "<workbook xmlns=\"{MAIN}\" xmlns:r=\"{RELATED}\"><sheets>\
                     <sheet name=\"{sheet}\" sheetId=\"1\" r:id=\"r1\"/></sheets></workbook>"
                ),
            ),
            (
                "xl/_rels/workbook.xml.rels",
                format!(
                    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\
                     <Relationship Id=\"r1\" Type=\"{RELATED}/worksheet\" Target=\"worksheets/sheet1.xml\"/></Relationships>"
                ),
            ),
            (
                "xl/worksheets/sheet1.xml",
                format!("<worksheet xmlns=\"{MAIN}\"><sheetData>{rows}</sheetData></worksheet>"),
            ),
        ];
        let shared = shared.map(|strings| ("xl/sharedStrings.xml", strings.to_owned()));
        for (name, content) in files.into_iter().chain(shared) {
            zip.start_file(name, options).unwrap();
            zip.write_all(content.as_bytes()).unwrap();
        }
        zip.finish().unwrap().into_inner()
    }

    fn text(bytes: &[u8], sheet: &str) -> Result<String, Message> {
        super::text(bytes, sheet, Decimal::Point)
    }

    fn word(place: &str, text: &str) -> String {
        format!("<c r=\"{place}\" t=\"inlineStr\"><is><t>{text}</t></is></c>")
    }

    #[test]
    fn cells_keep_their_lines_and_all_their_digits() {
        let head = word("B3", "X\n[mm]") + &word("D3", "a \"b\"");
        let data = word("A5", "P 1")
            + "<c r=\"B5\"><v>0.30000000000000004</v></c><c r=\"C5\"><v>-1234567.5</v></c>\
                   <c r=\"D5\" t=\"e\"><v>#N/A</v></c>";
        let bytes = workbook("CMM 1", &format!("<row r=\"3\">{head}</row><row r=\"5\">{data}</row>"));
        assert_eq!(Workbook::open(&bytes).unwrap().sheets(), ["CMM 1"]);
        assert_eq!(
            text(&bytes, "CMM 1").unwrap(),
            "\n\n\tX [mm]\t\t\"a \"\"b\"\"\"\n\nP 1\t0.30000000000000004\t-1234567.5\t#N/A\n"
        );
        let hint = phrase!("did-you-mean", name = "CMM 1");
        assert!(text(&bytes, "CMM").unwrap_err().is("sheet-missing", &[("sheet", &"CMM"), ("hint", &hint)]));
    }

    #[test]
    fn a_cell_in_the_last_corner_and_a_sheet_that_unpacks_without_end_are_errors() {
        let begun = std::time::Instant::now();
        let corner = workbook(
            "S",
            "<row r=\"1\"><c r=\"A1\"><v>1</v></c></row><row r=\"1048576\"><c r=\"XFD1048576\"><v>1</v></c></row>",
        );
        let place: [(&str, &dyn IntoArgument); 2] = [("column", &16384), ("row", &1_048_576)];
        assert!(text(&corner, "S").unwrap_err().is("sheet-too-large", &place));
        // more than numbers hold: wherever it wraps to, no row is as far down
        let far = workbook(
            "S",
            "<row r=\"1\"><c r=\"A1\"><v>1</v></c></row><row r=\"9\"><c r=\"A4000000000\"><v>1</v></c></row>",
        );
        assert!(text(&far, "S").unwrap_err().is("sheet-too-large", &[("rows", &1_048_576)]));
        assert!(begun.elapsed().as_secs() < 60);
        let bomb = workbook("S", &" ".repeat(LARGEST as usize + 1));
        assert!(bomb.len() < 1 << 20);
        let begun = std::time::Instant::now();
        assert!(text(&bomb, "S").unwrap_err().is("unpacked-too-large", &[("kind", &"workbook"), ("most_mib", &64)]));
        println!("a bomb is reported after {:.2} s", begun.elapsed().as_secs_f64());
        // many cells of one long text
        let rows: String =
            (1..=9).map(|r| format!("<row r=\"{r}\">{}</row>", word(&format!("A{r}"), &"x".repeat(7 << 20)))).collect();
        assert!(text(&workbook("S", &rows), "S").is_ok());
        let shared: String =
            (1..=100_000).map(|r| format!("<row r=\"{r}\"><c r=\"A{r}\" t=\"s\"><v>0</v></c></row>")).collect();
        let strings =
            format!("<sst xmlns=\"{MAIN}\" count=\"1\" uniqueCount=\"1\"><si><t>{}</t></si></sst>", "x".repeat(30_000));
        let bomb = workbook_with("S", &shared, Some(&strings));
        assert!(text(&bomb, "S").unwrap_err().is("unpacked-too-large", &[("most_mib", &64)]));
    }

    #[test]
    fn damaged_workbooks_are_errors_and_no_panics() {
        let bytes = workbook("S", "<row r=\"1\"><c r=\"A1\"><v>1</v></c></row>");
        for cut in (0..bytes.len()).step_by(7) {
            assert!(text(&bytes[..cut], "S").is_err(), "{cut}");
        }
        for at in 0..bytes.len() {
            let mut broken = bytes.clone();
            broken[at] ^= 0x55;
            let _ = text(&broken, "S");
        }
        let backwards =
            workbook("S", "<row r=\"2\"><c r=\"A2\"><v>1</v></c></row><row r=\"1\"><c r=\"A1\"><v>1</v></c></row>");
        let reason = phrase!("cells-unordered", sheet = "S", row = 1);
        assert!(text(&backwards, "S").unwrap_err().is("workbook-unreadable", &[("reason", &reason)]));
    }
}

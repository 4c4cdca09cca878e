//! Report as an Excel workbook: the verdict with its numbers first, then a sheet for each kind of
//! table, with all digits of every number.

use super::model::{Block, Cell, Columns, Contents, Fact, Table};
use super::number;
use super::words::{Words, tr};
use etalon_base::catalogue::Phrase;
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::phrase;
use rust_xlsxwriter::{Chart, ChartType, Color, Format, FormatAlign, FormatBorder, Workbook, Worksheet, XlsxError};

/// Maximum number of rows of a sheet, without the header and a line on omitted rows.
const ROWS: usize = 1_048_574;
/// Maximum length of a cell (UTF-16 units).
const CELL: usize = 32_767;
/// Largest exact integer in Excel; larger ones would be altered.
const WHOLE: u64 = 1 << 53;
const WIDTH: std::ops::RangeInclusive<usize> = 8..=60;
/// Number of rows that determine the width of a column.
const LOOKED_AT: usize = 1000;

/// Colours of verdicts by their English terms.
const VERDICTS: [(&str, u32); 7] = [
    ("pass", 0x00C6_EFCE),
    ("met", 0x00C6_EFCE),
    ("conditional", 0x00FF_EB9C),
    ("undecided", 0x00FF_EB9C),
    ("not assessable", 0x00FF_EB9C),
    ("not met", 0x00FF_C7CE),
    ("fail", 0x00FF_C7CE),
];

/// Chart beside the table of a sheet; columns are named by their English titles.
struct Plot {
    sheet: &'static str,
    kind: ChartType,
    title: Phrase,
    across: &'static str,
    up: &'static [&'static str],
}

fn plots() -> [Plot; 3] {
    [
        Plot {
            sheet: "errors-of-each-pose",
            kind: ChartType::Line,
            title: phrase!("plot-errors-by-pose"),
            across: "pose",
            up: &["position before, max [mm]", "position after, max [mm]"],
        },
        Plot {
            sheet: "parameters-title",
            kind: ChartType::Column,
            title: phrase!("plot-changes"),
            across: "name",
            up: &["change/u"],
        },
        Plot {
            sheet: "sheet-iso9283-poses",
            kind: ChartType::Column,
            title: phrase!("plot-ap-rp"),
            across: "pose",
            up: &["AP [mm]", "RP [mm]"],
        },
    ]
}

/// A sheet: titles, English titles and units of its columns, and its rows.
struct Sheet<'a> {
    name: &'a Phrase,
    /// Number of sheets of this name before this one.
    alike: usize,
    columns: Vec<[&'a str; 3]>,
    rows: Vec<Vec<&'a Cell>>,
}

/// All tables as a workbook (.xlsx); the bytes depend on nothing else.
pub(super) fn workbook(contents: &Contents, words: &Words) -> Result<Vec<u8>> {
    let fail = |e: XlsxError| error!("cannot-encode", format = "XLSX", reason = e.to_string());
    let mut workbook = Workbook::new();
    let created = rust_xlsxwriter::ExcelDateTime::from_ymd(1980, 1, 1).map_err(fail)?;
    let properties = rust_xlsxwriter::DocProperties::new().set_creation_datetime(&created);
    workbook.set_properties(
        &properties.set_title(printable(&contents.title)).set_comment(concat!("etalon ", env!("CARGO_PKG_VERSION"))),
    );
    let summary = summary(contents, words);
    for sheet in sheets(&summary, contents) {
        fill(workbook.add_worksheet(), &sheet, words).map_err(fail)?;
    }
    Ok(workbook.save_to_buffer().map_err(fail)?)
}

/// First sheet: verdict, and summary lines of all sections.
fn summary(contents: &Contents, words: &Words) -> Table {
    let line = |what: String, said: &str| Fact { what, said: said.into(), unit: "" };
    let mut lines = vec![line(tr!(words, "verdict"), &contents.verdict.sentences.join(" "))];
    lines.push(line(tr!(words, "report"), &contents.title));
    for (i, step) in contents.verdict.steps.iter().enumerate() {
        let command = step.command.as_ref().map_or_else(String::new, |c| format!(" `{c}`"));
        let said = format!("{} {}{command}", step.what.plain(), step.reason.plain());
        lines.push(line(tr!(words, "next-step", number = i + 1), &said));
    }
    let fields = contents.verdict.to_complete.iter();
    lines.extend(fields.map(|fields| line(fields.title.clone(), &fields.fields.join(", "))));
    lines.extend(contents.synthetic.iter().map(|why| line(tr!(words, "synthetic-data"), why)));
    let facts = lines.iter().chain(contents.sections.iter().flat_map(|s| &s.summary));
    let version = line(tr!(words, "written-by"), &format!("etalon {}", contents.version));
    let stated = facts.chain([&version]).filter(|f| !f.said.is_missing());
    let columns = Columns::<Fact>::new()
        .sheet(phrase!("head-what"), "", |f| f.what.as_str())
        .sheet(phrase!("value"), "", |f| f.said.clone())
        .sheet(phrase!("unit"), "", |f| f.unit);
    Table::new(words, stated, columns).on(phrase!("sheet-summary"))
}

fn sheet<'a>(name: &'a Phrase, table: &'a Table) -> Sheet<'a> {
    let columns = table.sheet_columns();
    let row = |row: &'a Vec<Cell>| columns.iter().map(|(i, _)| &row[*i]).collect();
    let rows = table.rows.iter().map(row).collect();
    Sheet { name, alike: 0, columns: columns.iter().map(|(_, titles)| *titles).collect(), rows }
}

/// The summary and all tables with a sheet; tables of one sheet are placed below each other.
fn sheets<'a>(summary: &'a Table, contents: &'a Contents) -> Vec<Sheet<'a>> {
    let mut all: Vec<Sheet> = Vec::new();
    let of_sections = contents.sections.iter().flat_map(|s| tables(&s.blocks).into_iter().chain(&s.data));
    for table in std::iter::once(summary).chain(of_sections) {
        let Some(name) = table.sheet.as_ref().filter(|_| !table.rows.is_empty()) else { continue };
        let more = sheet(name, table);
        let alike = all.iter().filter(|s| s.name == more.name).count();
        match all.iter_mut().find(|s| s.name == more.name && s.columns == more.columns) {
            Some(sheet) => sheet.rows.extend(more.rows),
            None => all.push(Sheet { alike, ..more }),
        }
    }
    all
}

fn tables(blocks: &[Block]) -> Vec<&Table> {
    blocks
        .iter()
        .flat_map(|block| match block {
            Block::Table(table) => vec![table],
            Block::Aside { blocks, .. } => tables(blocks),
            _ => vec![],
        })
        .collect()
}

fn fill(page: &mut Worksheet, sheet: &Sheet, words: &Words) -> std::result::Result<(), XlsxError> {
    let head =
        Format::new().set_bold().set_background_color(Color::RGB(0x00F3_F5F8)).set_border_bottom(FormatBorder::Thin);
    let text = Format::new().set_num_format("@").set_align(FormatAlign::Top);
    // Excel rejects two sheets of one name
    let name = name(sheet, words);
    page.set_name(&name)?;
    let last = sheet.columns.len().saturating_sub(1) as u16;
    for (i, [title, _, unit]) in (0u16..).zip(&sheet.columns) {
        page.write_string_with_format(0, i, printable(title), &head)?;
        page.set_column_width(i, width(sheet, usize::from(i)) as f64)?;
        let format = number_format(sheet.rows.iter().map(|row| row[usize::from(i)]), unit);
        // numbers have the format of their column
        page.set_column_format(i, &Format::new().set_num_format(format).set_align(FormatAlign::Top))?;
    }
    for (i, row) in (1u32..).zip(sheet.rows.iter().take(ROWS)) {
        for (j, cell) in (0u16..).zip(row) {
            match cell {
                Cell::Missing => continue,
                Cell::Number { value, .. } if value.is_finite() => page.write_number(i, j, *value)?,
                Cell::Number { .. } => page.write_string_with_format(i, j, tr!(words, "sheet-not-a-number"), &text)?,
                Cell::Count(count) if count.unsigned_abs() <= WHOLE => page.write_number(i, j, *count as f64)?,
                Cell::Term { english, shown, .. } => {
                    let colour = VERDICTS.iter().find(|(verdict, _)| verdict == english).map(|v| Color::RGB(v.1));
                    let format = text.clone();
                    let format = colour.map_or(format.clone(), |colour| format.set_background_color(colour));
                    page.write_string_with_format(i, j, printable(shown), &format)?
                }
                // texts stay texts, even if they look like a formula, a number or a link
                cell => page.write_string_with_format(i, j, printable(&cell.plain()), &text)?,
            };
        }
    }
    let written = sheet.rows.len().min(ROWS) as u32;
    if let Some(left_out) = sheet.rows.len().checked_sub(ROWS).filter(|n| *n > 0) {
        page.write_string(written + 1, 0, tr!(words, "sheet-rows-left-out", count = left_out))?;
    }
    page.set_freeze_panes(1, 0)?;
    page.autofilter(0, 0, written, last)?;
    page.set_landscape().set_print_fit_to_pages(1, 0).set_repeat_rows(0, 0)?;
    draw(page, sheet, words, written)
}

/// Name of a sheet in a language, with a number if others have the same name.
fn name(sheet: &Sheet, words: &Words) -> String {
    let name = words.tr(sheet.name);
    match sheet.alike {
        0 => name,
        n => format!("{name} {}", n + 1),
    }
}

/// Draws the chart of a sheet beside its table.
fn draw(page: &mut Worksheet, sheet: &Sheet, words: &Words, rows: u32) -> std::result::Result<(), XlsxError> {
    let first = sheet.alike == 0 && rows > 0;
    let Some(plot) = plots().into_iter().find(|p| p.sheet == sheet.name.id && first) else { return Ok(()) };
    let column = |title: &str| (0u16..).zip(&sheet.columns).find(|(_, c)| c[1] == title).map(|(i, _)| i);
    let up: Vec<u16> = plot.up.iter().filter_map(|title| column(title)).collect();
    // a table of other columns on a sheet of this name, such as a plan, has no chart: Excel
    // rejects a chart without series
    let Some(across) = column(plot.across).filter(|_| !up.is_empty()) else { return Ok(()) };
    let name = name(sheet, words);
    let mut chart = Chart::new(plot.kind);
    for up in up {
        let series = chart.add_series().set_name((name.as_str(), 0, up));
        series.set_categories((name.as_str(), 1, across, rows, across)).set_values((name.as_str(), 1, up, rows, up));
    }
    chart.title().set_name(words.tr(&plot.title).as_str());
    chart.set_width(720).set_height(360);
    page.insert_chart(1, sheet.columns.len() as u16 + 1, &chart)?;
    Ok(())
}

/// Number of characters that column `i` needs.
fn width(sheet: &Sheet, i: usize) -> usize {
    let shown = |cell: &Cell| match cell {
        Cell::Missing => 0,
        Cell::Number { .. } | Cell::Count(_) => 11,
        cell => cell.plain().lines().map(|l| l.chars().count()).max().unwrap_or(0),
    };
    let rows = sheet.rows.iter().take(LOOKED_AT).map(|row| shown(row[i])).max().unwrap_or(0);
    // room for the filter button
    rows.max(sheet.columns[i][0].chars().count() + 3).clamp(*WIDTH.start(), *WIDTH.end())
}

/// Significant digits of the largest number in a column without a unit.
const DIGITS: usize = 6;

/// Number format with legible digits and a common notation per column; cells contain all digits.
fn number_format<'a>(cells: impl Iterator<Item = &'a Cell>, unit: &str) -> String {
    let largest = || {
        let values =
            cells.filter_map(|cell| if let Cell::Number { value, .. } = cell { Some(value.abs()) } else { None });
        values.filter(|v| v.is_finite() && *v > 0.0).max_by(f64::total_cmp)
    };
    let decimals = match unit {
        "mm" => 5,
        "deg" => 6,
        "µm" => 2,
        _ => match largest() {
            Some(v) if (1e-4..1e9).contains(&v) => number::decimals(v, DIGITS).unwrap_or(0),
            Some(_) => return format!("0.{}E+00", "0".repeat(DIGITS - 1)),
            None => return "General".to_owned(),
        },
    };
    if decimals == 0 { "0".to_owned() } else { format!("0.{}", "0".repeat(decimals)) }
}

/// Text without characters that XML forbids, cut to the size of a cell.
fn printable(text: &str) -> String {
    let allowed = |c: char| match c {
        '\n' | '\t' => c,
        '\u{fffe}' | '\u{ffff}' => '\u{fffd}',
        c if c.is_control() => '\u{fffd}',
        c => c,
    };
    let mut units = 0;
    let fits = |c: &char| {
        units += c.len_utf16();
        units <= CELL
    };
    text.chars().map(allowed).take_while(fits).collect()
}

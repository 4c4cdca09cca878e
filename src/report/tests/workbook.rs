//! Workbook with unusual input.

use super::demo::Documents;
use super::page::with_text;
use crate::campaign::contents;
use crate::*;
use calamine::{Data, Reader, Xlsx};
use etalon_base::phrase;
use etalon_documents::Language;
use std::io::Cursor;

fn book(documents: &Documents) -> Vec<u8> {
    let words = Words::default();
    super::super::workbook::workbook(&contents(&documents.results(), &words), &words).unwrap()
}

fn read(documents: &Documents) -> Xlsx<Cursor<Vec<u8>>> {
    let bytes = book(documents);
    assert!(bytes == book(documents));
    calamine::open_workbook_from_rs(Cursor::new(bytes)).unwrap()
}

/// Checks that a workbook contains no formula, whatever its texts look like.
pub(crate) fn only_texts_and_numbers(bytes: Vec<u8>) -> Xlsx<Cursor<Vec<u8>>> {
    let mut book: Xlsx<_> = calamine::open_workbook_from_rs(Cursor::new(bytes)).unwrap();
    for sheet in book.sheet_names() {
        assert!(book.worksheet_formula(&sheet).unwrap().is_empty(), "{sheet}");
        for (row, column, cell) in book.worksheet_range(&sheet).unwrap().used_cells() {
            assert!(matches!(cell, Data::String(_) | Data::Float(_)), "{sheet} {row} {column}: {cell:?}");
        }
    }
    book
}

#[test]
fn hostile_names_are_texts() {
    let texts = [
        "<script>alert(1)</script>&\"'",
        "=HYPERLINK(\"http://192.0.2.1\")",
        "+1",
        "{=1+1}",
        "http://192.0.2.1",
        "#import \"x\"",
        "_x0041_",
        "\u{202e}\u{5e8}\u{5d5}",
        "1.5",
    ];
    for text in texts {
        let mut book = only_texts_and_numbers(book(&with_text(text)));
        let names = book.worksheet_range("Parameters").unwrap();
        assert_eq!(names.get((1, 0)), Some(&Data::String(text.to_owned())));
    }
}

#[test]
fn what_a_cell_cannot_hold_is_cut_or_replaced() {
    let mut documents = Documents::demo();
    documents.campaign.measurements.notes = Some("ü".repeat(40_000));
    documents.campaign.measurements.operator = Some("a\0b\u{fffe}c".to_owned());
    documents.parameters.parameters[0].value = f64::NAN;
    documents.parameters.parameters[1].value = f64::INFINITY;
    documents.errors[0].pose = i64::MAX.into();
    let mut book = read(&documents);
    let summary = book.worksheet_range("Summary").unwrap();
    let cells: Vec<String> = summary.rows().map(|row| row[1].to_string()).collect();
    assert!(cells.contains(&"a\u{fffd}b\u{fffd}c".to_owned()) && cells.contains(&"ü".repeat(32_767)));
    let parameters = book.worksheet_range("Parameters").unwrap();
    assert_eq!(parameters.get((1, 4)), Some(&Data::String("not a number".to_owned())));
    let residuals = book.worksheet_range("Residuals").unwrap();
    assert_eq!(residuals.get((1, 1)), Some(&Data::String(i64::MAX.to_string())));
}

/// A plan has a sheet "Parameters" without changes, and Excel rejects a chart without series and
/// two sheets of one name.
#[test]
fn sheets_of_one_name_with_other_columns_are_written() {
    use crate::model::{Block, Columns, Contents, Section, Table};
    let (words, names) = (Words::default(), ["a".to_owned(), "b".to_owned()]);
    let table = |title| {
        let columns = Columns::<String>::new().both("name", "", |n| n.as_str()).both(title, "", |n| n.len());
        Block::Table(Table::new(&words, &names, columns).on(phrase!("parameters-title")))
    };
    let mut section = Section::new("parameters", "Parameters");
    ["predicted u", "identified", "predicted u"].into_iter().for_each(|title| section.push(table(title)));
    let contents = Contents { sections: vec![section], ..Contents::default() };
    let mut book = only_texts_and_numbers(super::super::workbook::workbook(&contents, &words).unwrap());
    assert_eq!(book.sheet_names(), ["Summary", "Parameters", "Parameters 2"]);
    assert_eq!(book.worksheet_range("Parameters").unwrap().height(), 1 + 2 * names.len());
}

/// A workbook has the language of its report; Excel rejects sheet names above 31 characters, with
/// one of `[]:*?/\\`, or alike but for upper and lower case.
#[test]
fn a_workbook_has_the_language_of_its_report() {
    let sheets = |language: Language| {
        let words = Words::new(language);
        let bytes = super::super::workbook::workbook(&contents(&Documents::demo().results(), &words), &words).unwrap();
        let mut book = only_texts_and_numbers(bytes);
        let head = book.worksheet_range(&book.sheet_names()[1]).unwrap();
        let names: Vec<String> = book.sheet_names();
        (names, head.rows().next().unwrap().iter().map(ToString::to_string).collect::<Vec<_>>())
    };
    let (english, _) = sheets(Language::En);
    for language in [Language::Fr, Language::De] {
        let (names, heads) = sheets(language);
        assert_eq!(names.len(), english.len());
        assert!(names[0] != english[0] && names.iter().all(|n| n.chars().count() <= 31), "{names:?} {heads:?}");
    }
}

//! One form for every table: the same cells give the same numbers, and the same refusals at the same places, in an export, a log and a table
//! of observations.

use super::source;
use etalon::base::message::{Problems, SourceText};
use etalon::formats::table::{integers, numbers};
use etalon::formats::{Export, Format, Log, TableLayout, log, observations_with};

/// What a reader makes of a column: numbers with their lines, or ids of errors with their lines.
#[derive(Clone, Debug, PartialEq)]
enum Read {
    Numbers(Vec<(usize, f64)>),
    Refused(Vec<(String, Option<usize>)>),
}

/// Problems of a cell; a mistake of the whole table is placed by its section.
fn refused(problems: &Problems) -> Read {
    let one = |m: &etalon::base::message::Message| {
        (m.id.to_string(), m.place.as_ref().filter(|p| p.file == "t.csv").and_then(|p| p.line))
    };
    Read::Refused(problems.0.iter().map(one).collect())
}

fn of_export(text: &str, keys: &str) -> Read {
    let stated = format!(
        "file = \"t.csv\"\nunit = \"mm\"\nformat = {{ {}, columns = {{ x = \"A\", y = \"B\", z = \"C\" }} }}",
        keys.replace('\n', ", ")
    );
    let stated: Export = match toml::from_str(&stated) {
        Ok(stated) => stated,
        Err(error) => panic!("{keys}: {error}"),
    };
    let format: &Format = &stated.format;
    let (points, problems) = format.read("t.csv", &text.into(), stated.unit);
    if !problems.0.is_empty() {
        return refused(&problems);
    }
    let measured = points.iter().filter(|p| p.refused.is_none());
    Read::Numbers(measured.map(|p| (p.line as usize, p.xyz_mm[0])).collect())
}

fn of_log(text: &str, keys: &str) -> Read {
    let stated = format!("file = \"t.csv\"\n{keys}\ncolumns = {{ rho1_mm = \"A\", rho2_mm = \"B\", rho3_mm = \"C\" }}");
    let definition: Log = toml::from_str(&stated).unwrap_or_else(|error| panic!("{keys}: {error}"));
    let place = SourceText { name: "campaign.toml", text: &stated };
    match log(place, &definition, text, &mut source()) {
        Ok((read, _)) => Read::Numbers(read.rows.iter().map(|row| (row.line, row.joints[0])).collect()),
        Err(problems) => refused(&problems),
    }
}

fn of_observations(text: &str, keys: &str) -> Read {
    let columns = "columns = { x_mm = \"A\", y_mm = \"B\", z_mm = \"C\" }\npose = \"row\"\ntarget = \"K\"";
    let stated: etalon::campaign::ObservationsDefinition =
        toml::from_str(&format!("file = \"t.csv\"\n{keys}\n{columns}"))
            .unwrap_or_else(|error| panic!("{keys}: {error}"));
    let layout: TableLayout = stated.layout();
    match observations_with("t.csv", text, &layout) {
        Ok(table) => {
            let lines = integers(&table, "line").unwrap();
            let all = lines.iter().map(|line| *line as usize).zip(numbers(&table, "x_mm").unwrap());
            Read::Numbers(all.filter(|(_, x)| !x.is_nan()).collect())
        }
        Err(problems) => refused(&problems),
    }
}

/// Reads a table of three columns and two rows, of which the second begins with `cell`.
fn same(name: &str, keys: &str, delimiter: &str, before: &str, cell: &str) {
    let rows = [["A", "B", "C"], ["0", "1", "2"], [cell, "1", "2"], ["3", "4", "5"]];
    let text = before.to_owned() + &rows.map(|row| row.join(delimiter) + "\n").concat();
    let all = [of_export(&text, keys), of_log(&text, keys), of_observations(&text, keys)];
    assert!(all.iter().all(|read| *read == all[0]), "{name} {cell:?}: {all:#?}");
}

#[test]
fn cells_mean_the_same_in_every_table() {
    let plain = "delimiter = \",\"\nheader = 1";
    for cell in [
        "12.5", " 12.5 ", "+12.5", "1.25e1", "12.5 mm", "\"12.5\"", "−12.5", ".5", "5.", "1_2", "inf", "1d1", "0x10",
        "12.5\t", // not measured
        "nan", "N/A", "*", "****", "-", "", "#N/A", "NaN", "None", "null", " ", "---",
    ] {
        same("plain", plain, ",", "", cell);
    }
    for cell in ["12,5", "1.012,5", "1.2.5", "12.5", "1012", "1.012", "1 012,5", "1.01,5"] {
        same("thousands", "delimiter = \";\"\ndecimal = \",\"\nthousands = \".\"\nheader = 1", ";", "", cell);
    }
    for cell in ["-99", "", "-", "nan"] {
        same("missing", "delimiter = \",\"\nheader = 1\nmissing = [\"-99\"]", ",", "", cell);
    }
    same("decimal alone", "delimiter = \";\"\ndecimal = \",\"\nheader = 1", ";", "", "1.012");
    same("commas between thousands", "delimiter = \";\"\nthousands = \",\"\nheader = 1", ";", "", "1,012.5");
}

#[test]
fn rows_before_the_data_mean_the_same_in_every_table() {
    for (keys, delimiter, before) in [
        ("delimiter = \",\"\nheader = 1\ncomment = \"#\"", ",", "# a\n"),
        ("delimiter = \",\"\nheader = 2", ",", "title,a,b\n"),
        ("delimiter = \",\"\nheader = 2", ",", "title\n"),
        ("delimiter = \",\"\nheader = 2", ",", "title\n\n"),
        ("delimiter = \",\"\nheader = [\"A\", \"B\"]", ",", "title\nsecond\n"),
        ("delimiter = \",\"\nheader = [\"A\", \"D\"]", ",", ""),
        ("delimiter = \" \"\nheader = 1", " ", ""),
        ("delimiter = \"tab\"\nheader = 1", "\t", ""),
        ("delimiter = \",\"\nheader = 1\nonly = { A = [\"0\", \"3.0\"] }", ",", ""),
        ("delimiter = \",\"\nheader = 1\nwithout = { B = 4 }", ",", ""),
        ("delimiter = \",\"\nheader = 1\nwithout = { D = 4 }", ",", ""),
        ("delimiter = \",\"\nheader = 1\nonly = { A = 77 }", ",", ""),
    ] {
        same(keys, keys, delimiter, before, "12.5");
    }
}

#[test]
fn filters_compare_numbers_in_the_marks_of_every_table() {
    let keys = "delimiter = \";\"\ndecimal = \",\"\nthousands = \".\"\nheader = 1\nwithout = { A = \"1,234\" }";
    for cell in ["1.234", "1,234", "1,2340"] {
        same("filter", keys, ";", "", cell);
    }
}

#[test]
fn ambiguous_marks_are_refused_in_every_table() {
    let text = "A;B;C\n1,5;0;0\n";
    for keys in [
        "delimiter = \";\"\ndecimal = \",\"\nthousands = \",\"\nheader = 1",
        "delimiter = \",\"\nthousands = \",\"\nheader = 1",
        "delimiter = \" \"\nthousands = \" \"\nheader = 1",
    ] {
        for read in [of_export(text, keys), of_log(text, keys), of_observations(text, keys)] {
            assert_eq!(read, Read::Refused(vec![("thousands-mark-ambiguous".to_owned(), None)]), "{keys}");
        }
    }
}

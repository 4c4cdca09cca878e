//! One form for every table: the same cells give the same numbers, and the same refusals at the same places, in an export, a log and a table
//! of observations.

use super::recordings::{Cdr, mat, npy, recording, variable};
use super::source;
use etalon::base::message::{Problems, SourceText};
use etalon::campaign::TableDefinition;
use etalon::formats::{Export, Format, Log, TableReading, file_text, log, observations_with};
use etalon::tables::Form;
use std::io::Write as _;
use std::path::Path;

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

/// Headings of three columns of lengths, and their unit.
#[derive(Clone, Copy)]
struct Columns {
    names: [&'static str; 3],
    unit: &'static str,
}

/// Columns of the tables that are written here.
const LETTERS: Columns = Columns { names: ["A", "B", "C"], unit: "mm" };
/// Columns of a topic of points (`geometry_msgs/PointStamped`, REP 103).
const POINT: Columns = Columns { names: ["point.x", "point.y", "point.z"], unit: "m" };

fn of_export(text: &str, keys: &str, Columns { names: [x, y, z], unit }: Columns) -> Read {
    let stated = format!(
        "file = \"t.csv\"\nunit = \"{unit}\"\n\
         format = {{ {}, columns = {{ x = \"{x}\", y = \"{y}\", z = \"{z}\" }} }}",
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

fn of_log(text: &str, keys: &str, Columns { names: [x, y, z], unit }: Columns) -> Read {
    let columns = format!("columns = {{ rho1_{unit} = \"{x}\", rho2_{unit} = \"{y}\", rho3_{unit} = \"{z}\" }}");
    let stated = format!("file = \"t.csv\"\n{keys}\n{columns}");
    let definition: Log = toml::from_str(&stated).unwrap_or_else(|error| panic!("{keys}: {error}"));
    let place = SourceText { name: "campaign.toml", text: &stated };
    match log(place, &definition, text, &mut source()) {
        Ok((read, _)) => Read::Numbers(read.rows.iter().map(|row| (row.line, row.joints[0])).collect()),
        Err(problems) => refused(&problems),
    }
}

fn of_observations(text: &str, keys: &str, Columns { names: [x, y, z], unit }: Columns) -> Read {
    let columns = format!("columns = {{ x_{unit} = \"{x}\", y_{unit} = \"{y}\", z_{unit} = \"{z}\" }}");
    let columns = format!("{columns}\npose = \"row\"\ntarget = \"K\"");
    let stated: etalon::campaign::ObservationsDefinition =
        toml::from_str(&format!("file = \"t.csv\"\n{keys}\n{columns}"))
            .unwrap_or_else(|error| panic!("{keys}: {error}"));
    of_reading(text, &stated.reading())
}

/// A table of poses or of loads.
fn of_table(text: &str, keys: &str, Columns { names: [x, y, z], unit }: Columns) -> Read {
    let columns = format!("columns = {{ x_{unit} = \"{x}\", y_{unit} = \"{y}\", z_{unit} = \"{z}\" }}");
    let stated: TableDefinition = toml::from_str(&format!("file = \"t.csv\"\n{keys}\n{columns}"))
        .unwrap_or_else(|error| panic!("{keys}: {error}"));
    of_reading(text, &TableReading::any(stated.keys().unwrap().layout.clone()))
}

fn of_reading(text: &str, reading: &TableReading) -> Read {
    match observations_with("t.csv", text, reading) {
        Ok(table) => {
            let lines = (0..).map_while(|row| table.line(row));
            let all = lines.zip(table.numbers("x_mm").unwrap());
            Read::Numbers(all.filter(|(_, x)| !x.is_nan()).collect())
        }
        Err(problems) => refused(&problems),
    }
}

/// Reads a text in every section that takes a table.
fn all(text: &str, keys: &str, columns: Columns) -> [Read; 4] {
    [of_export, of_log, of_observations, of_table].map(|section| section(text, keys, columns))
}

/// Reads a table of three columns and two rows, of which the second begins with `cell`.
fn same(name: &str, keys: &str, delimiter: &str, before: &str, cell: &str) {
    let rows = [["A", "B", "C"], ["0", "1", "2"], [cell, "1", "2"], ["3", "4", "5"]];
    let text = before.to_owned() + &rows.map(|row| row.join(delimiter) + "\n").concat();
    let all = all(&text, keys, LETTERS);
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
        ("delimiter = \",\"\nheader = 3", ",", "title\n\n"),
        ("delimiter = \",\"\nheader = 2", ",", ""),
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
        for read in all(text, keys, LETTERS) {
            assert_eq!(read, Read::Refused(vec![("thousands-mark-ambiguous".to_owned(), None)]), "{keys}");
        }
    }
}

/// Rows of three numbers, of which the first may not have been measured.
type Numbers = [[Option<f64>; 3]];

/// A workbook with one sheet of number cells, as the standard (ECMA-376) wants it at least.
fn workbook(rows: &Numbers) -> Vec<u8> {
    let main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
    let related = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
    let packaged = "http://schemas.openxmlformats.org/package/2006";
    let office = "application/vnd.openxmlformats-officedocument.spreadsheetml";
    let word = |(place, name)| format!("<c r=\"{place}1\" t=\"inlineStr\"><is><t>{name}</t></is></c>");
    let mut cells = format!("<row r=\"1\">{}</row>", [("A", "A"), ("B", "B"), ("C", "C")].map(word).concat());
    for (line, row) in (2..).zip(rows) {
        let cell = |(place, value): (&str, &Option<f64>)| {
            value.map_or(String::new(), |value| format!("<c r=\"{place}{line}\"><v>{value}</v></c>"))
        };
        cells +=
            &format!("<row r=\"{line}\">{}</row>", ["A", "B", "C"].into_iter().zip(row).map(cell).collect::<String>());
    }
    let relation = |kind: &str, target: &str| {
        format!(
            "<Relationships xmlns=\"{packaged}/relationships\">\
             <Relationship Id=\"r1\" Type=\"{related}/{kind}\" Target=\"{target}\"/></Relationships>"
        )
    };
    let files = [
        (
            "[Content_Types].xml",
            format!(
                "<Types xmlns=\"{packaged}/content-types\">\
                 <Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\
                 <Override PartName=\"/xl/workbook.xml\" ContentType=\"{office}.sheet.main+xml\"/>\
                 <Override PartName=\"/xl/worksheets/sheet1.xml\" ContentType=\"{office}.worksheet+xml\"/></Types>"
            ),
        ),
        ("_rels/.rels", relation("officeDocument", "xl/workbook.xml")),
        (
            "xl/workbook.xml",
            format!(
                "<workbook xmlns=\"{main}\" xmlns:r=\"{related}\"><sheets>\
                 <sheet name=\"A\" sheetId=\"1\" r:id=\"r1\"/></sheets></workbook>"
            ),
        ),
        ("xl/_rels/workbook.xml.rels", relation("worksheet", "worksheets/sheet1.xml")),
        ("xl/worksheets/sheet1.xml", format!("<worksheet xmlns=\"{main}\"><sheetData>{cells}</sheetData></worksheet>")),
    ];
    packed(files.map(|(name, text)| (name.to_owned(), text.into_bytes())))
}

/// An archive of these files.
fn packed(files: impl IntoIterator<Item = (String, Vec<u8>)>) -> Vec<u8> {
    let mut archive = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    for (name, bytes) in files {
        archive.start_file(name, zip::write::SimpleFileOptions::default()).unwrap();
        archive.write_all(&bytes).unwrap();
    }
    archive.finish().unwrap().into_inner()
}

/// The file of a program with the key that names its table.
struct File {
    keys: &'static str,
    columns: Columns,
    bytes: Vec<u8>,
}

/// The same numbers as files of other programs; arrays mark with NaN what was not measured.
fn files(rows: &Numbers) -> Vec<File> {
    let column = |at: usize| rows.iter().map(|row| row[at].unwrap_or(f64::NAN)).collect::<Vec<f64>>();
    let names = ["A", "B", "C"];
    let bytes = |at: usize| column(at).iter().flat_map(|v| v.to_le_bytes()).collect::<Vec<u8>>();
    let array = |at: usize| (format!("{}.npy", names[at]), npy("<f8", &format!("({},)", rows.len()), &bytes(at)));
    let variables: Vec<Vec<u8>> = (0..3).map(|at| variable(names[at], rows.len() as u32, 1, &column(at))).collect();
    let cell = |value: &Option<f64>| value.map_or(String::new(), |value| value.to_string());
    let line = |row: &[Option<f64>; 3]| row.each_ref().map(cell).join(",") + "\n";
    let text = "A,B,C\n".to_owned() + &rows.iter().map(line).collect::<String>();
    let sheet = |bytes| File { keys: "sheet = \"A\"", columns: LETTERS, bytes };
    vec![
        File { keys: "delimiter = \",\"", columns: LETTERS, bytes: text.into_bytes() },
        sheet(packed((0..3).map(array))),
        sheet(mat(&variables)),
        sheet(workbook(rows)),
    ]
}

/// Messages with these numbers (m) in a recording. A message definition has no mark of a missing value.
fn topic(rows: &[[f64; 3]]) -> File {
    let message = |(i, row): (i32, &[f64; 3])| ("/points", "geometry_msgs/msg/PointStamped", Cdr::point((i, 0), *row));
    let messages: Vec<_> = (1..).zip(rows).map(message).collect();
    File { keys: "topic = \"/points\"", columns: POINT, bytes: recording(&messages) }
}

/// Reads a file in every section that takes a table.
fn in_every_section(File { keys, columns, bytes }: &File) -> [Read; 4] {
    let form: Form = toml::from_str(keys).unwrap();
    let text =
        file_text(Path::new("t.csv"), bytes, None, &Format::from(form)).unwrap_or_else(|e| panic!("{keys}: {e}"));
    all(&text, &format!("{keys}\nheader = 1"), *columns)
}

/// The file reads as these numbers (mm), bit for bit.
fn reads_as(file: &File, numbers: impl Iterator<Item = f64>) {
    let right: Vec<(usize, u64)> = (2..).zip(numbers.map(f64::to_bits)).collect();
    for read in in_every_section(file) {
        let Read::Numbers(read) = &read else { panic!("{}: {read:?}", file.keys) };
        let bits: Vec<(usize, u64)> = read.iter().map(|(line, value)| (*line, value.to_bits())).collect();
        assert_eq!(bits, right, "{}", file.keys);
    }
}

#[test]
fn numbers_are_the_same_from_every_kind_of_file() {
    let numbers =
        [0.1 + 0.2, -1.0 / 3.0, 1e-300, 5e-324, -1.797e308, 123_456_789.123_456_79, 9_007_199_254_740_993.0, -0.0, 3.0];
    let rows: Vec<[Option<f64>; 3]> = numbers.iter().map(|value| [Some(*value), Some(1.0), Some(2.5)]).collect();
    files(&rows).iter().for_each(|file| reads_as(file, numbers.into_iter()));
    // in mm, the largest number would be infinite
    let numbers = numbers.into_iter().filter(|value| (1000.0 * value).is_finite());
    let rows: Vec<[f64; 3]> = numbers.clone().map(|value| [value, 1.0, 2.5]).collect();
    reads_as(&topic(&rows), numbers.map(|value| 1000.0 * value));
}

#[test]
fn rows_without_a_value_are_left_out_from_every_kind_of_file() {
    let rows = [[Some(1.5), Some(1.0), Some(2.0)], [None, Some(1.0), Some(2.0)], [Some(2.5), Some(1.0), Some(2.0)]];
    for file in files(&rows) {
        for read in in_every_section(&file) {
            assert_eq!(read, Read::Numbers(vec![(2, 1.5), (4, 2.5)]), "{}", file.keys);
        }
    }
}

#[test]
fn numbers_that_are_not_finite_are_refused_in_every_kind_of_file() {
    let rows = [[Some(1.5), Some(1.0), Some(2.0)], [Some(f64::INFINITY), Some(1.0), Some(2.0)]];
    let topic = topic(&rows.map(|row| row.map(|value| value.unwrap_or(f64::NAN))));
    for file in files(&rows).into_iter().take(3).chain([topic]) {
        for read in in_every_section(&file) {
            assert_eq!(read, Read::Refused(vec![("not-a-number".to_owned(), Some(3))]), "{}", file.keys);
        }
    }
}

//! The same data in every delimiter, mark, encoding and line end are the same points, bit for bit.

use etalon::base::noise::Noise;
use etalon::formats::Format;
use etalon::formats::dialect::Unit;
use etalon::formats::read_file;
use etalon::tables::Encoding;

const DELIMITERS: [(&str, &str); 5] = [("blank", "  "), ("tab", "\t"), (",", ","), (";", ";"), ("|", "|")];
const LINE_ENDS: [&str; 3] = ["\n", "\r\n", "\r"];

/// How a text becomes bytes, and what the campaign states of it: written here without the program's own tables.
type Written = (&'static str, fn(&str) -> Vec<u8>, Option<Encoding>);

const ENCODINGS: [Written; 7] = [
    ("UTF-8", |t| t.as_bytes().to_vec(), None),
    ("UTF-8 with a mark", |t| [b"\xef\xbb\xbf", t.as_bytes()].concat(), None),
    ("UTF-16LE with a mark", |t| pairs(&format!("\u{feff}{t}"), u16::to_le_bytes), None),
    ("UTF-16BE with a mark", |t| pairs(&format!("\u{feff}{t}"), u16::to_be_bytes), None),
    ("UTF-16LE", |t| pairs(t, u16::to_le_bytes), Some(Encoding::Utf16Le)),
    ("UTF-16BE", |t| pairs(t, u16::to_be_bytes), Some(Encoding::Utf16Be)),
    // the letters used are in Latin-1, which windows-1252 shares
    ("windows-1252", |t| t.chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect(), Some(Encoding::Windows1252)),
];

fn pairs(text: &str, bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
    text.encode_utf16().flat_map(bytes).collect()
}

/// Numbers of every size and sign, labels with letters beyond ASCII.
fn data() -> Vec<(String, [f64; 3])> {
    let mut noise = Noise::new(7, 1);
    let mut number = |i: i32| (noise.gaussian(1.0) * 10f64.powi(i % 13 - 4)).max(-9e5);
    (0..40).map(|i| (format!("Kügelchen_{i}µ"), [number(i), number(i + 1), number(i + 2)])).collect()
}

#[derive(serde::Deserialize)]
struct Stated {
    format: Format,
}

fn stated(format: &str) -> Format {
    toml::from_str::<Stated>(&format!("format = {format}")).unwrap().format
}

/// Reads bytes in a format; the points must equal the points of `data`, bit for bit.
fn same(name: &str, bytes: &[u8], encoding: Option<Encoding>, format: &str) {
    let file = tempfile::NamedTempFile::new().unwrap();
    std::fs::write(file.path(), bytes).unwrap();
    let read =
        read_file(file.path(), encoding, &stated(format), Unit::Millimetre).unwrap_or_else(|e| panic!("{name}: {e}"));
    let bits = |xyz: [f64; 3]| xyz.map(f64::to_bits);
    let read: Vec<(String, [u64; 3])> = read.into_iter().map(|p| (p.label.to_string(), bits(p.xyz_mm))).collect();
    let expected: Vec<(String, [u64; 3])> = data().into_iter().map(|(label, xyz)| (label, bits(xyz))).collect();
    assert_eq!(read, expected, "{name}");
}

#[test]
fn every_delimiter_mark_encoding_and_line_end_gives_the_same_points() {
    let mut tried = 0;
    for (delimiter, separator) in DELIMITERS {
        for decimal in [".", ","].into_iter().filter(|decimal| (delimiter, *decimal) != (",", ",")) {
            for end in LINE_ENDS {
                let number = |v: f64| format!("{v:?}").replace('.', decimal);
                let row = |(label, xyz): &(String, [f64; 3])| {
                    [&[label.clone()][..], &xyz.map(number)].concat().join(separator) + end
                };
                let text = format!("name{separator}x{separator}y{separator}z{end}{end}")
                    + &data().iter().map(row).collect::<String>();
                let format = format!(
                    "{{ delimiter = {delimiter:?}, decimal = {decimal:?}, header = 1, columns = [\"label\", \"x\", \"y\", \"z\"] }}"
                );
                for (encoding, bytes, stated) in ENCODINGS {
                    let name = format!("{format} {encoding} {end:?}");
                    same(&name, &bytes(&text), stated, &format);
                    // the last line need not end
                    same(&name, &bytes(text.trim_end()), stated, &format);
                    tried += 1;
                }
            }
        }
    }
    assert_eq!(tried, 9 * 3 * 7);
}

#[test]
fn a_polyworks_report_in_every_encoding_gives_the_same_points() {
    let control = |(label, [x, y, z]): (String, [f64; 3])| {
        [("X", x), ("Y", y), ("Z", z)].map(|(axis, v)| format!("{label},{axis},{v:?},{v:?},±1.5,0,Pass,\n")).concat()
    };
    let text = "Part: Gehäuse\nName,Control,Nom,Meas,Tol,Dev,Test,Out Tol\n".to_owned()
        + &data().into_iter().map(control).collect::<String>();
    for (encoding, bytes, stated) in ENCODINGS {
        for end in LINE_ENDS {
            same(&format!("{encoding} {end:?}"), &bytes(&text.replace('\n', end)), stated, "\"polyworks_report\"");
        }
    }
}

#[test]
fn fixed_widths_and_columns_by_name_give_the_same_points() {
    let rows = data();
    let fixed = |(label, [x, y, z]): &(String, [f64; 3])| format!("{label:<20}{x:>26?}{y:>26?}{z:>26?}\n");
    let text = format!("Plate 7\n\n{:<20}{:>26}{:>26}{:>26}\n", "the name", "Meas X", "Meas Y", "Meas Z")
        + &rows.iter().map(fixed).collect::<String>();
    let widths = "widths = [20, 26, 26, 26], header = \"Meas X\"";
    for columns in [
        "[\"label\", \"x\", \"y\", \"z\"]",
        "{ z = \"Meas Z\", label = \"the name\", y = \"Meas Y\", x = \"Meas X\" }",
        "{ z = 4, label = 1, y = \"Meas Y\", x = 2 }",
    ] {
        same(columns, text.as_bytes(), None, &format!("{{ {widths}, columns = {columns} }}"));
    }
}

#[test]
fn groups_of_digits_unicode_minus_and_fortran_exponents_are_the_same_numbers() {
    let grouped = |value: f64, mark: &str, decimal: &str| {
        let text = format!("{value:?}").replace('-', "\u{2212}");
        let (whole, rest) = text.split_once(['.', 'e']).unwrap_or((&text, ""));
        if text.contains('e') {
            return text.replace('e', "D").replace('.', decimal);
        }
        let digits: Vec<char> = whole.chars().collect();
        let group = |(i, c): (usize, &char)| {
            let left = digits.len() - i;
            let sep = i > 0 && left.is_multiple_of(3) && digits[i - 1].is_ascii_digit();
            format!("{}{c}", if sep { mark } else { "" })
        };
        digits.iter().enumerate().map(group).collect::<String>() + decimal + rest
    };
    for (mark, thousands, decimal) in [
        (",", ",", "."),
        (".", ".", ","),
        ("'", "'", "."),
        (" ", " ", ","),
        ("\u{a0}", " ", "."),
        ("\u{202f}", " ", ","),
    ] {
        let row = |(label, xyz): &(String, [f64; 3])| {
            [&[label.clone()][..], &xyz.map(|v| grouped(v, mark, decimal))].concat().join(";") + "\n"
        };
        let text: String = data().iter().map(row).collect();
        assert!(text.contains(mark) && text.contains('\u{2212}'));
        let format = format!(
            "{{ delimiter = \";\", decimal = {decimal:?}, thousands = {thousands:?}, columns = [\"label\", \"x\", \"y\", \"z\"] }}"
        );
        same(&format, text.as_bytes(), None, &format);
    }
}

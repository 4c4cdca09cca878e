//! Exports in formats that have a reader of their own, as plain as their rules allow.

use super::text;
use crate::base::message::Message;
use crate::base::pose::Vector;
use crate::import::format::Decimal;
use crate::import::format::Delimiter;
use crate::import::format::Reader;
use crate::import::format::Unit;

/// A text of labelled points in the unit of the export.
pub(super) fn write(
    reader: Reader,
    decimal: Decimal,
    unit: Unit,
    decimals: usize,
    rows: &[(&str, Vector)],
) -> Result<String, Message> {
    let number = |value: f64| text::number(value, decimals, decimal);
    let list = |xyz: &Vector, separator: &str| xyz.map(&number).join(separator);
    let one_of = |known: &[(Unit, &'static str)]| {
        let words = known.iter().find(|(u, _)| *u == unit).map(|(_, words)| *words);
        words.ok_or_else(|| {
            let names: Vec<&str> = known.iter().map(|(unit, _)| unit.name()).collect();
            Message::error(format!("{} is never in {}", reader.in_words(), unit.name())).expected(names.join(" or "))
        })
    };
    let each = |line: &dyn Fn(usize, &str, &Vector) -> String| -> String {
        rows.iter().enumerate().map(|(i, (label, xyz))| line(i, label, xyz)).collect()
    };
    Ok(match reader {
        Reader::PolyworksReport => report(decimal, rows, &number)?,
        Reader::PolyworksProject => {
            let object = |i: usize, label: &str, xyz: &Vector| {
                let (name, point) = (utf_16(label), list(xyz, "\t"));
                format!(
                    "BEGIN OBJECT {i}\nCLASS\t=\tPrimitive\nTYPE\t=\tPoint\nNAME\t=\t{name}\nPOINT\t=\t{point}\nEND OBJECT {i}\n\n"
                )
            };
            format!("# === PolyWorks|Inspector project description file ===\n\n{}", each(&object))
        }
        Reader::Calypso => {
            let unit = unit.name();
            let rows = |_: usize, label: &str, xyz: &Vector| -> String {
                let row = |(axis, value): (&str, &f64)| {
                    format!("simulated\t1\t{label}_{axis}\t{axis}Value\t{}\t{label}\t{unit}\n", number(*value))
                };
                ["x", "y", "z"].into_iter().zip(xyz).map(row).collect()
            };
            format!("planid\tpartnb\tid\tidsymbol\tactual\tfeatureid\tunit\tgroup1\t\n{}END\n", each(&rows))
        }
        Reader::Dmis | Reader::GeopakDmis => {
            let length = one_of(&[(Unit::Millimetre, "MM"), (Unit::Metre, "M"), (Unit::Inch, "INCH")])?;
            // upwards
            let direction = if reader == Reader::Dmis { "0, 0, 1" } else { "90, 90, 0" };
            let feature = |_: usize, label: &str, xyz: &Vector| {
                format!("FA({label}) = FEAT/POINT, CART, $\n  {}, {direction}\n", list(xyz, ", "))
            };
            format!("FILNAM/'simulated'\nUNITS/{length}, ANGDEC\n{}ENDFIL\n", each(&feature))
        }
        Reader::PcdmisXyz => {
            let head = one_of(&[(Unit::Millimetre, "XYZIJK    METRIC"), (Unit::Inch, "XYZIJK")])?;
            format!("{head}\n{}", each(&|_, _, xyz| list(xyz, ",") + "\n"))
        }
        Reader::GeopakGws => {
            let length = one_of(&[(Unit::Millimetre, "MM"), (Unit::Inch, "Inch")])?;
            let points = each(&|_, label, xyz| format!("#02:{label}\n#03: {}\n", list(xyz, " ")));
            format!("#00:GEOPAK-WIN Scanning\n#04:XY(Z)\n#05:Opn\n#06:{length}\n{points}")
        }
        Reader::Inspec => each(&|_, label, xyz| format!("\"{label}: 3D MCS Points\",{}\n", list(xyz, ","))),
        Reader::VdaFs => {
            let points = each(&|_, label, xyz| format!("{label} = POINT / {}\n", list(xyz, ", ")));
            format!("SIMULATED = HEADER / 0\n{points}SIMULATED = END\n")
        }
        Reader::Ply => {
            let count = rows.len();
            let properties = "property double x\nproperty double y\nproperty double z\n";
            let vertices = each(&|_, _, xyz| list(xyz, " ") + "\n");
            format!("ply\nformat ascii 1.0\nelement vertex {count}\n{properties}end_header\n{vertices}")
        }
    })
}

/// A PolyWorks report: three controls a point. A decimal comma goes with semicolons.
fn report(decimal: Decimal, rows: &[(&str, Vector)], number: &dyn Fn(f64) -> String) -> Result<String, Message> {
    let delimiter = if decimal == Decimal::Comma { Delimiter::Semicolon } else { Delimiter::Comma };
    let line = |fields: [&str; 8]| text::line(&fields.map(str::to_owned), delimiter, None);
    let mut all = line(["Name", "Control", "Nom", "Meas", "Tol", "Dev", "Test", "Out Tol"])?;
    for (label, xyz) in rows {
        for (axis, value) in ["X", "Y", "Z"].into_iter().zip(xyz) {
            all += &line([label, axis, "", &number(*value), "±1", "", "", ""])?;
        }
    }
    Ok(all)
}

/// A name as PolyWorks writes it: code units in hexadecimal where it is not ASCII.
fn utf_16(label: &str) -> String {
    if label.is_ascii() {
        return label.to_owned();
    }
    let units: String = label.encode_utf16().map(|unit| format!("{unit:04X}")).collect();
    format!("UNICODE( {units} )")
}

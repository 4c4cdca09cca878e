//! Text report of PC-DMIS: a block for each dimension, with its name and unit, the heading `AX` and
//! a row for each axis. The order of the columns is a setting; `MEAS` is read.
//!
//! A dimension without all of X, Y and Z is no point. Source: PC-DMIS 2022.1, "Dimension Format"
//! and "Dimension Output Format".

use super::pivot::{Pivot, Said};
use super::{About, ExportFormat, ExportRow, Recognised, Text, WriteError, Writing, unit_agrees};
use crate::Point;
use crate::dialect::{Dialect, Unit};
use etalon_base::message::Problems;
use etalon_base::{error, phrase};
use etalon_tables::Decimal;
use etalon_tables::lexer::{Row as Fields, number};

/// Text reports of PC-DMIS.
pub(super) struct PcdmisReport;

impl ExportFormat for PcdmisReport {
    fn about(&self) -> About {
        About { name: "pcdmis_report", title: "PC-DMIS report", decimal_comma: true, ..About::default() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        let found = Recognised::by(text.lines().take(400).any(is_heading), 0.9, phrase!("is-pcdmis-report"))?;
        let unit = text.lines().filter_map(stated_unit).map(Unit::name).next();
        Some(Recognised { unit, ..found })
    }

    fn read(&self, text: &Text, dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        rows(text, dialect.form.decimal(), unit)
    }

    /// Deviations and tolerances are zero.
    fn write(&self, rows: &[ExportRow], how: &Writing) -> Result<String, WriteError> {
        let unit = how.unit_in(&[(Unit::Millimetre, "MM"), (Unit::Inch, "IN")])?;
        let zero = how.number(0.0);
        let axis = |(axis, value): (&str, &f64)| {
            let value = how.number(*value);
            format!("{axis} {value} {zero} {zero} {value} {zero} {zero}\n")
        };
        let block = |(i, row): (usize, &ExportRow)| {
            let head = format!("DIM LOC{}= LOCATION OF POINT {}  UNITS={unit}\n", i + 1, row.label);
            let axes: String = ["X", "Y", "Z"].into_iter().zip(&row.xyz).map(axis).collect();
            format!("{head}AX NOMINAL +TOL -TOL MEAS DEV OUTTOL\n{axes}END OF DIMENSION LOC{}\n", i + 1)
        };
        Ok(rows.iter().enumerate().map(block).collect())
    }
}

/// `true` for the heading of the rows of a dimension.
fn is_heading(line: &str) -> bool {
    let mut words = line.split_whitespace();
    words.next() == Some("AX") && words.any(|word| word == "MEAS")
}

/// Unit that the first line of a dimension gives: `UNITS=MM`, or `MM` as its first word.
fn stated_unit(line: &str) -> Option<Unit> {
    let word = match line.split_once("UNITS=") {
        Some((_, rest)) => rest.split([',', ' ', '\t', '$']).next()?,
        None => line.split_whitespace().next()?,
    };
    match word.trim() {
        "MM" => Some(Unit::Millimetre),
        "IN" | "INCH" => Some(Unit::Inch),
        _ => None,
    }
}

/// Name of the feature of a dimension: the words behind its kind (`LOCATION OF SPHERE SPH1`), the
/// word behind a dash (`MM  LOC1 - CIR1`), or the name of the dimension.
fn feature(line: &str) -> String {
    let head = line.split("UNITS=").next().unwrap_or(line).trim();
    if let Some((_, behind)) = head.split_once(" OF ") {
        let name: Vec<&str> = behind.split_whitespace().skip(1).collect();
        return if name.is_empty() { behind.trim().to_owned() } else { name.join(" ") };
    }
    if let Some((_, name)) = head.split_once(" - ") {
        return name.split_whitespace().next().unwrap_or(name).to_owned();
    }
    let name = head.strip_prefix("DIM ").unwrap_or(head);
    name.split(['=', ' ']).next().unwrap_or(name).trim().to_owned()
}

/// The measured points.
fn rows(text: &Text, decimal: Decimal, unit: Unit) -> (Vec<Point>, Problems) {
    let (mut problems, mut points) = (Problems::default(), Pivot::default());
    // the feature of the block, and the place of its measured value
    let (mut head, mut block) = (None::<usize>, None::<(String, usize)>);
    for (i, line) in text.lines.iter().enumerate().filter(|(_, line)| !line.trim().is_empty()) {
        let row = Fields::new(i + 1, line, line.split_whitespace());
        if is_heading(line) {
            let measured = row.fields.iter().position(|field| field == "MEAS");
            block = measured.map(|at| (head.map_or_else(String::new, |at| feature(text.line_text(at))), at));
            continue;
        }
        let axis = ["X", "Y", "Z"].iter().position(|axis| row.field(0) == *axis);
        let (Some(axis), Some((label, at))) = (axis, &block) else {
            let is_other = block.is_some() && row.fields.len() > 3 && row.field(0).len() <= 2;
            if !is_other {
                (head, block) = (Some(i + 1), None);
                let stated = stated_unit(line).map(|of_file| unit_agrees(unit, of_file, &"UNITS", text.place(i + 1)));
                problems.0.extend(stated.and_then(Result::err));
            } else if let Some((label, _)) = &block {
                points.add(i + 1, label, "", Said::Other(row.field(0).to_owned()));
            }
            continue;
        };
        if row.fields.len() <= *at {
            let expected = phrase!("fields-of-columns", count = at + 1);
            problems.0.push(error!("row-field-count", fields = row.fields.len(), expected).at(text.place(i + 1)));
            continue;
        }
        match number(row.field(*at), decimal) {
            Ok(value) => points.add(i + 1, label, "", Said::Coordinate(axis, value)),
            Err(message) => problems.0.push(message.at(row.cell(text.file, *at))),
        }
    }
    (points.rows(text, unit), problems)
}

#[cfg(test)]
mod tests {
    use crate::Format;
    use crate::dialect::Unit;

    const REPORT: &str = "PART NAME  : PLATE\nDIM LOC1= LOCATION OF SPHERE SPH1  UNITS=MM\n\
        AX    NOMINAL       +TOL       -TOL       MEAS        DEV     OUTTOL\n\
        X     1273.019      0.200      0.200   1272.619     -0.400      0.000 ----#----\n\
        Y     -345.678      0.200      0.200   -345.678      0.000      0.000 ----#----\n\
        Z       92.617      0.200      0.200     90.917     -1.700      1.500 -------->\n\
        D       38.100      0.100      0.100     38.102      0.002      0.000 ----#----\n\
        DIM LOC2= LOCATION OF CIRCLE CIR2  UNITS=MM ,$\nGRAPH=OFF  TEXT=OFF\n\
        AX    NOMINAL       MEAS       +TOL       -TOL\nX 25.000 25.002 0.010 0.010\n";

    #[test]
    fn the_measured_values_are_read_in_any_order_of_the_columns() {
        let format = Format::named("pcdmis_report").unwrap();
        let (points, problems) = format.read("r.txt", &REPORT.into(), Unit::Millimetre);
        assert!(problems.0.is_empty(), "{problems:?}");
        assert_eq!((&*points[0].label, points[0].xyz_mm), ("SPH1", [1272.619, -345.678, 90.917]));
        // a circle without Y and Z is no point
        assert!(points.len() == 2 && points[1].refused.as_ref().is_some_and(|reason| reason.id == "point-incomplete"));
        let (_, problems) = format.read("r.txt", &REPORT.into(), Unit::Inch);
        assert!(problems.0[0].is("unit-differs", &[("of_file", &"mm"), ("stated", &"inch")]), "{problems:?}");
        let document = crate::propose("r.txt", REPORT);
        assert_eq!((document.format.as_deref(), document.rows), (Some("pcdmis_report"), 2));
        assert!(document.toml.contains("unit = \"mm\""), "{}", document.toml);
    }
}

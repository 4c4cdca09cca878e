//! SpatialAnalyzer's ASCII points: `[[collection,] group,] target, x, y, z` after comments that may
//! state axes, unit, working frame and columns. The label is `collection::group::target`: one
//! target name may occur in several groups.

use super::delimited::point_rows;
use super::stamps::seconds;
use super::{About, ExportFormat, ExportRow, Recognised, Text, WriteError, Writing};
use crate::dialect::{ColumnRole, Dialect, Unit};
use crate::{Point, SharedText};
use etalon_base::message::{Message, Place, Problems};
use etalon_base::{error, phrase};
use etalon_tables::lexer::parsed;
use etalon_tables::{Decimal, Delimiter, Form};

/// ASCII points of SpatialAnalyzer.
pub(super) struct SpatialAnalyzer;

impl ExportFormat for SpatialAnalyzer {
    fn about(&self) -> About {
        About { name: "spatialanalyzer", title: "SpatialAnalyzer ASCII", ..About::default() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        let mark = |l: &str| l.starts_with("// SpatialAnalyzer") || l.starts_with("// AXES =");
        let what = phrase!("is-spatialanalyzer");
        let found = Recognised::by(text.lines().take(20).any(mark), 0.9, what)?;
        let mut stated = text.lines().filter_map(|line| line.trim_start().strip_prefix(COMMENT).and_then(stated_unit));
        Some(Recognised { unit: stated.next().and_then(|(_, word)| unit_name(word)), ..found })
    }

    fn read(&self, text: &Text, _dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        rows(text.file, text.whole, unit)
    }

    fn write(&self, rows: &[ExportRow], how: &Writing) -> Result<String, WriteError> {
        // label parts between `::` are collection and group
        let head = format!("// AXES = CARTESIAN: X,  Y,  Z ({})\n", how.unit.name());
        let line = |row: &ExportRow| format!("{},  {}\n", row.label.replace("::", ",  "), how.list(row, ",  "));
        Ok(head + &rows.iter().map(line).collect::<String>())
    }

    /// The working frame, which an option of the export omits.
    fn frame<'t>(&self, text: &'t str) -> Option<&'t str> {
        let comments = text.lines().filter_map(|line| line.trim_start().strip_prefix(COMMENT));
        let mut frames = comments.filter_map(|c| c.trim().strip_prefix("Points Relative to Coordinate Frame"));
        frames.next().map(|frame| frame.trim().trim_matches('\''))
    }
}

const COMMENT: &str = "//";

/// Points of the text, with their problems. If the file contains its unit, the unit of the campaign
/// must be the same.
fn rows(file: &str, text: &SharedText, unit: Unit) -> (Vec<Point>, Problems) {
    let mut problems = Problems::default();
    let mut columns = None;
    for (i, line) in text.lines().enumerate() {
        let Some(comment) = line.trim_start().strip_prefix(COMMENT) else { continue };
        let at = || Place::line(file, i + 1, line);
        if let Some(axes) = comment.trim().strip_prefix("AXES =") {
            problems.0.extend(not_cartesian(axes.trim()).map(|m| m.at(at())));
        }
        if let Some((how, of_file)) = stated_unit(comment)
            && unit_name(of_file) != Some(unit.name())
        {
            problems.0.push(error!("unit-differs", of_file, how, stated = unit.name()).at(at()));
        }
        columns = columns.or_else(|| named(comment));
    }
    let mut data =
        text.lines().enumerate().filter(|(_, l)| !l.trim().is_empty() && !l.trim_start().starts_with(COMMENT));
    let columns = match (columns, data.next()) {
        (_, None) => return (Vec::new(), problems),
        (Some(columns), _) => columns,
        (None, Some((i, line))) => match counted(line) {
            Ok(columns) => columns,
            Err(message) => {
                problems.0.push(message.at(Place::line(file, i + 1, line)));
                return (Vec::new(), problems);
            }
        },
    };
    let dialect = Dialect {
        form: Form { comment: Some(COMMENT.to_owned()), ..Form::delimited(Delimiter::Comma) },
        columns: columns.into(),
        ..Dialect::default()
    };
    let (mut points, more) = point_rows(file, text, &dialect, unit);
    problems.0.extend(more.0);
    add_times(&mut points);
    (points, problems)
}

/// Adds the times of day of stamps at the ends of the rows, if all are of one day. Their date, in
/// which day and month may be swapped, is not read.
fn add_times(points: &mut [Point]) {
    let stamp = |point: &Point| {
        let (date, time) = point.text.rsplit(',').next()?.trim().split_once(' ')?;
        Some((date.to_owned(), seconds("", time).ok()?))
    };
    let Some(stamps) = points.iter().map(stamp).collect::<Option<Vec<(String, f64)>>>() else { return };
    if stamps.windows(2).all(|pair| pair[0].0 == pair[1].0) {
        for (point, (_, time)) in points.iter_mut().zip(stamps) {
            point.time_s = Some(time);
        }
    }
}

/// Error if the coordinates of a statement `CARTESIAN: X,  Y,  Z (mm)` are of another type.
fn not_cartesian(axes: &str) -> Option<Message> {
    let kind = axes.split_once(':').map_or(axes, |(kind, _)| kind).trim();
    (kind != "CARTESIAN").then(|| {
        let message = error!("coordinates-not-cartesian", found = kind, cartesian = "CARTESIAN");
        let columns = "\"label\", \"radius\", \"azimuth\", \"z\"";
        message.hint(phrase!("export-cartesian-or-columns", columns))
    })
}

/// Returns the keyword and the unit of a comment: `AXES = CARTESIAN: X, Y, Z (mm)`, `Units: mm`.
fn stated_unit(comment: &str) -> Option<(&'static str, &str)> {
    if let Some(axes) = comment.trim().strip_prefix("AXES =") {
        let (_, rest) = axes.split_once('(')?;
        return Some(("AXES", rest.split_once(')')?.0.trim()));
    }
    let at = comment.to_ascii_lowercase().find("unit")?;
    let rest = comment[at + "unit".len()..].trim_start_matches(['s', 'S']).trim_start();
    let word = rest.strip_prefix([':', '='])?.trim_start().split(|c: char| !c.is_alphabetic()).next()?;
    // other words are no units of lengths
    unit_name(word).map(|_| ("Units", word))
}

/// Name of a unit of lengths in a campaign.
fn unit_name(stated: &str) -> Option<&'static str> {
    match stated.to_ascii_lowercase().as_str() {
        "mm" | "millimeters" | "millimetres" | "millimeter" | "millimetre" => Some("mm"),
        "m" | "meters" | "metres" | "meter" | "metre" => Some("m"),
        "in" | "inch" | "inches" => Some("inch"),
        _ => None,
    }
}

/// Columns by the comment that names them: `Collection,  Group,  Point,  X,  Y,  Z`.
fn named(comment: &str) -> Option<Vec<ColumnRole>> {
    let names: Vec<&str> = comment.split(',').map(str::trim).collect();
    let x = names.windows(3).position(|w| w == ["X", "Y", "Z"]).filter(|x| *x <= 3)?;
    let known = ["Collection", "Group", "Point", "Target"];
    let label = names[..x].iter().all(|name| known.contains(name));
    label.then(|| {
        let role = |i: usize| match i.checked_sub(x) {
            None => ColumnRole::Label,
            Some(0) => ColumnRole::X,
            Some(1) => ColumnRole::Y,
            Some(2) => ColumnRole::Z,
            Some(_) => ColumnRole::Skip,
        };
        (0..names.len()).map(role).collect()
    })
}

/// Columns by their count, without a comment that names them: up to three columns of the name, then
/// x, y, z, and texts behind them such as the time of the measurement.
fn counted(line: &str) -> Result<Vec<ColumnRole>, Message> {
    let cells: Vec<&str> = line.split(',').map(str::trim).collect();
    let fields = cells.len();
    let is_number = |cell: &&str| parsed(cell, Decimal::Point, None).is_some();
    let behind = cells.iter().rev().take_while(|cell| !is_number(cell)).count();
    let read = if cells.iter().any(is_number) { fields - behind } else { fields };
    match read {
        3..=6 => {
            let xyz = [ColumnRole::X, ColumnRole::Y, ColumnRole::Z];
            Ok([&vec![ColumnRole::Label; read - 3][..], &xyz, &vec![ColumnRole::Skip; fields - read]].concat())
        }
        _ => {
            let message = error!("row-field-count", fields = fields, expected = phrase!("spatialanalyzer-fields"));
            let (delimiter, columns) = match fields {
                1 => ("blank", "\"label\", \"x\", \"y\", \"z\""),
                _ => (",", "\"label\", \"label\", \"label\", \"x\", \"y\", \"z\", \"-\""),
            };
            Err(message.hint(phrase!("state-columns", delimiter, columns)))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEAD: &str = "// SpatialAnalyzer SA 2022\n// Points Relative to Coordinate Frame 'A::WORLD'\n// AXES = CARTESIAN: X,  Y,  Z (mm)\n";

    fn read(text: &str) -> Vec<(String, [f64; 3])> {
        let (points, problems) = rows("f", &text.into(), Unit::Millimetre);
        assert!(problems.0.is_empty(), "{problems}");
        points.into_iter().map(|p| (p.label.to_string(), p.xyz_mm)).collect()
    }

    #[test]
    fn the_name_has_up_to_three_parts_and_the_key_is_all_of_them() {
        let xyz = [1.5, -2.0, 3.0];
        for (name, label) in
            [("", ""), ("P 1,  ", "P 1"), ("G (+),  P 1,  ", "G (+)::P 1"), ("C, G[1], P*, ", "C::G[1]::P*")]
        {
            assert_eq!(read(&format!("{HEAD}{name}1.5,  -2.000000,  3.0\n")), [(label.to_owned(), xyz)]);
        }
        let named = format!("{HEAD}// Group,  Point,  X,  Y,  Z,  RMS\n\nG, 7, 1.5, -2, 3.0, 0.01\n");
        assert_eq!(read(&named), [("G::7".to_owned(), xyz)]);
        assert_eq!(SpatialAnalyzer.frame(&named), Some("A::WORLD"));
        let stamped = format!("{HEAD}C,  G,  0,  1.5,  -2.0,  3.0,  02/12/25 16:42:11\n");
        assert_eq!(read(&stamped), [("C::G::0".to_owned(), xyz)]);
        let (points, _) = rows("f", &stamped.as_str().into(), Unit::Millimetre);
        assert_eq!(points[0].time_s, Some(16.0 * 3600.0 + 42.0 * 60.0 + 11.0));
    }

    #[test]
    fn another_unit_other_axes_or_columns_that_nothing_names_are_refused() {
        let error = |text: &str, unit| rows("f", &text.into(), unit).1.0.remove(0);
        let differs = error(&format!("{HEAD}1,2,3\n"), Unit::Inch);
        assert!(differs.is("unit-differs", &[("of_file", &"mm"), ("stated", &"inch")]), "{differs}");
        // a line of its own, or behind other words
        for head in ["// Units: inches\n", "// SpatialAnalyzer export, Unit = in\n"] {
            let differs = error(&format!("{head}1,2,3\n"), Unit::Millimetre);
            assert!(differs.is("unit-differs", &[("how", &"Units"), ("stated", &"mm")]), "{differs}");
            assert_eq!(SpatialAnalyzer.recognise(&format!("// SpatialAnalyzer\n{head}")).unwrap().unit, Some("inch"));
            assert!(rows("f", &format!("{head}1,2,3\n").as_str().into(), Unit::Inch).1.0.is_empty());
        }
        let spherical = error("// AXES = SPHERICAL: R, T, P\n1,2,3\n", Unit::Millimetre);
        assert!(spherical.is("coordinates-not-cartesian", &[("found", &"SPHERICAL")]), "{spherical}");
        for (row, found) in [("C, G, 0, 1, 2, 3, 0.01\n", 7), ("C G P 1 2 3\n", 1)] {
            assert!(error(row, Unit::Millimetre).is("row-field-count", &[("fields", &found)]), "{row}");
        }
    }
}

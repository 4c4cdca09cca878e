//! FANUC TP programs as text (`.ls`): the positions of the section `/POS` in millimetres, in the
//! user frame that each position gives. They are taught or computed, not measured.
//!
//! W, P and R are angles about the fixed axes x, y and z in this order. A position in joint values
//! has no coordinates. Source: FANUC, "R-30iB operator's manual", position data.

use super::{About, ExportFormat, ExportRow, Recognised, Text, WriteError, Writing, unit_agrees};
use crate::Point;
use crate::dialect::{Dialect, Unit};
use etalon_base::message::{Message, Problems};
use etalon_base::pose::Pose;
use etalon_base::{error, phrase, warning};
use etalon_tables::Decimal;
use etalon_tables::lexer::parsed;
use std::fmt::Write as _;

/// Positions of a TP program.
pub(super) struct FanucLs;

impl ExportFormat for FanucLs {
    fn about(&self) -> About {
        About { name: "fanuc_ls", title: "FANUC LS", ..About::default() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        let mut lines = text.lines().filter(|line| !line.trim().is_empty());
        let is_program = lines.next().is_some_and(|line| line.trim_start().starts_with("/PROG"));
        let found = Recognised::by(is_program, 1.0, phrase!("is-fanuc-ls"))?;
        Some(Recognised { unit: Some("mm"), ..found })
    }

    fn caution(&self) -> Option<Message> {
        Some(warning!("positions-of-program"))
    }

    fn read(&self, text: &Text, _dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        let (mut points, mut problems) = (Vec::new(), Problems::default());
        let mut open: Option<Position> = None;
        let positions = text.lines.iter().enumerate().skip_while(|(_, line)| line.trim() != "/POS").skip(1);
        for (i, line) in positions.take_while(|(_, line)| line.trim() != "/END") {
            let line = line.trim();
            if line.starts_with("P[") {
                open = Position::new(i + 1, line);
                if open.is_none() {
                    let valid = "P[1]{";
                    problems
                        .0
                        .push(error!("record-invalid", text = line, format = "fanuc_ls", valid).at(text.place(i + 1)));
                }
            }
            let Some(position) = &mut open else { continue };
            position.add(line);
            if line.starts_with('}') {
                points.extend(open.take().map(|position| position.point(text)));
            }
        }
        if open.is_some() {
            problems.0.push(error!("file-cut-off", missing = "`};`").at(text.place(text.lines.len())));
        }
        if let Some(first) = points.first() {
            let agrees = unit_agrees(unit, Unit::Millimetre, &"/POS", text.place(first.line as usize));
            problems.0.extend(agrees.err());
        }
        (points, problems)
    }

    fn write(&self, rows: &[ExportRow], how: &Writing) -> Result<String, WriteError> {
        how.unit_in(&[(Unit::Millimetre, "mm")])?;
        let mut out = "/PROG ETALON\n/ATTR\n/MN\n/POS\n".to_owned();
        for (i, row) in rows.iter().enumerate() {
            let [x, y, z] = row.xyz.map(|value| how.number(value));
            let _ = write!(
                out,
                "P[{}:\"{}\"]{{\n   GP1:\n\tUF : 0, UT : 1,\t\tCONFIG : 'N U T, 0, 0, 0',\n\
                 \tX = {x} mm,\tY = {y} mm,\tZ = {z} mm,\n\tW = 0.000 deg,\tP = 0.000 deg,\tR = 0.000 deg\n}};\n",
                i + 1,
                row.label
            );
        }
        Ok(out + "/END\n")
    }
}

/// A position that is read line by line.
struct Position {
    line: usize,
    name: String,
    /// Number of a position without a name, which is its pose.
    pose: Option<i64>,
    /// X, Y, Z (mm) and W, P, R (deg).
    values: [Option<f64>; 6],
    /// `true` behind the values of the first group of axes.
    is_behind: bool,
}

impl Position {
    /// Begins a position: `P[1]{` or `P[1:"name"]{`.
    fn new(line: usize, text: &str) -> Option<Self> {
        let (index, _) = text.strip_prefix("P[")?.split_once(']')?;
        let (number, name) = index.split_once(':').unwrap_or((index, ""));
        let number: i64 = number.trim().parse().ok()?;
        let name = name.trim().trim_matches('"');
        let (name, pose) = match name {
            "" => (format!("P[{number}]"), Some(number)),
            name => (name.to_owned(), None),
        };
        Some(Self { line, name, pose, values: [None; 6], is_behind: false })
    }

    /// Adds the values of a line: `X = 1680.081 mm, Y = -315.778 mm`.
    fn add(&mut self, line: &str) {
        self.is_behind |= line.starts_with("GP") && !line.starts_with("GP1");
        for (name, value) in line.split(',').filter_map(|part| part.split_once('=')).filter(|_| !self.is_behind) {
            let at = ["X", "Y", "Z", "W", "P", "R"].iter().position(|axis| *axis == name.trim());
            let value = value.split_whitespace().next().and_then(|word| parsed(word, Decimal::Point, None));
            if let Some(at) = at {
                self.values[at] = value;
            }
        }
    }

    fn point(self, text: &Text) -> Point {
        let [Some(x), Some(y), Some(z), turned @ ..] = self.values else {
            return text.no_point(self.line, &self.name, phrase!("row-without-coordinates"));
        };
        let mut point = text.point(self.line, &self.name, [x, y, z], Unit::Millimetre);
        if let Some(pose) = self.pose {
            point.pose = Some(pose.into());
        }
        if let [Some(w), Some(p), Some(r)] = turned {
            let turned: Pose<f64> = Pose::from_xyz_rpy([0.0; 3], [w, p, r].map(f64::to_radians));
            point.orientation = Some(turned.quaternion());
        }
        point
    }
}

#[cfg(test)]
mod tests {
    use crate::Format;
    use crate::dialect::Unit;

    const PROGRAM: &str = "/PROG  SURFACE\n/ATTR\nOWNER\t= MNEDITOR;\n/MN\n   1:J P[1] 100% FINE ;\n/POS\n\
        P[1]{\n   GP1:\n\tUF : 0, UT : 1,\t\tCONFIG : 'F U T, 0, 0, 0',\n\
        \tX =  1680.082  mm,\tY =  -315.778  mm,\tZ =   423.048  mm,\n\
        \tW =   180.000 deg,\tP =     0.000 deg,\tR =    90.000 deg\n};\n\
        P[2:\"gripper\"]{\n   GP1:\n\tUF : 0, UT : 1,\n\tJ1=     0.000 deg,\tJ2=    10.000 deg,\tJ3=   -20.000 deg\n};\n\
        P[3:\"weld\"]{\n   GP1:\n\tUF : 0, UT : 1,\t\tCONFIG : 'N U T, 0, 0, 0',\n\
        \tX =  1.500  mm,\tY =  2.500  mm,\tZ =   3.500  mm,\n   GP2:\n\tUF : 0, UT : 1,\n\tX =  7.000  mm\n};\n/END\n";

    #[test]
    fn positions_of_a_program_are_points_and_poses_in_doubt() {
        let format = Format::named("fanuc_ls").unwrap();
        let (points, problems) = format.read("s.ls", &PROGRAM.into(), Unit::Millimetre);
        assert!(problems.0.is_empty(), "{problems:?}");
        assert_eq!((&*points[0].label, points[0].xyz_mm), ("P[1]", [1680.082, -315.778, 423.048]));
        // a half turn about x, then a quarter turn about z: the axis is half between x and y
        let half = 0.5f64.sqrt();
        let [w, x, y, z] = points[0].orientation.unwrap();
        let sign = x.signum();
        for (found, right) in [w, x, y, z].into_iter().zip([0.0, half, half, 0.0]) {
            assert!((sign * found - right).abs() < 1e-9, "{:?}", points[0].orientation);
        }
        assert!(points[1].refused.as_ref().is_some_and(|reason| reason.id == "row-without-coordinates"));
        assert_eq!((&*points[2].label, points[2].xyz_mm), ("weld", [1.5, 2.5, 3.5]));
        assert_eq!((points[0].pose, points[2].pose), (Some(1.into()), None));
        let document = crate::propose("s.ls", PROGRAM);
        assert_eq!(document.format.as_deref(), Some("fanuc_ls"), "{}", document.toml);
        let doubts = || document.doubts.iter().filter_map(|doubt| doubt.phrase());
        assert!(doubts().any(|doubt| doubt.id == "positions-of-program"), "{}", document.toml);
        let (_, problems) = format.read("s.ls", &PROGRAM.into(), Unit::Inch);
        assert!(problems.0[0].is("unit-differs", &[("of_file", &"mm"), ("stated", &"inch")]), "{problems:?}");
        let cut = &PROGRAM[..PROGRAM.find("};").unwrap()];
        assert!(format.read("s.ls", &cut.into(), Unit::Millimetre).1.0[0].is("file-cut-off", &[]));
        let wrong = PROGRAM.replace("P[3:", "P[c:");
        assert!(format.read("s.ls", &wrong.as_str().into(), Unit::Millimetre).1.0[0].is("record-invalid", &[]));
    }
}

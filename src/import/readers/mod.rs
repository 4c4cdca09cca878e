//! Exports that say themselves where their points are: one file a format.
//!
//! A reader gives rows for a campaign. A file that states its unit must state the campaign's; one that does not is read
//! in the campaign's.

pub mod calypso;
pub mod dmis;
mod dmis_records;
mod geopak_gws;
mod inspec;
mod pcdmis_xyz;
mod pivot;
mod ply;
mod ply_header;
mod polyworks_project;
pub mod polyworks_report;
mod vda_fs;

use super::points::Point;
use crate::base::message::{Message, Place, Problems};
use crate::base::pose::Vector;
use crate::import::format::Decimal;
use crate::import::format::Reader;
use crate::import::format::Unit;

/// Points of an export, and what does not read.
pub(super) fn rows(reader: Reader, file: &str, text: &str, decimal: Decimal, unit: Unit) -> (Vec<Point>, Problems) {
    let source = Text { file, lines: text.lines().collect() };
    match reader {
        Reader::PolyworksReport => polyworks_report::rows(&source, text, decimal, unit),
        Reader::PolyworksProject => polyworks_project::rows(&source, unit),
        Reader::Calypso => calypso::rows(&source, decimal, unit),
        Reader::Dmis => dmis::rows(&source, dmis::Directions::Vectors, unit),
        Reader::GeopakDmis => dmis::rows(&source, dmis::Directions::Angles, unit),
        Reader::PcdmisXyz => pcdmis_xyz::rows(&source, unit),
        Reader::GeopakGws => geopak_gws::rows(&source, text, unit),
        Reader::Inspec => inspec::rows(&source, unit),
        Reader::VdaFs => vda_fs::rows(&source, unit),
        Reader::Ply => ply::rows(&source, text, unit),
    }
}

/// The text of an export by lines.
struct Text<'a> {
    file: &'a str,
    lines: Vec<&'a str>,
}

impl Text<'_> {
    /// A line, from 1.
    fn place(&self, line: usize) -> Place {
        Place::line(self.file, line, self.shown(line))
    }

    /// A part of a line, which starts at a byte of it.
    fn part(&self, line: usize, byte: usize, width: usize) -> Place {
        let shown = self.shown(line);
        let before = shown.get(..byte.min(shown.len())).unwrap_or("");
        self.place(line).at(before.chars().count() + 1, width)
    }

    fn shown(&self, line: usize) -> &str {
        line.checked_sub(1).and_then(|i| self.lines.get(i)).copied().unwrap_or("")
    }

    /// A row at a line, in millimetres.
    fn point(&self, line: usize, label: &str, xyz: Vector, unit: Unit) -> Point {
        Point {
            line,
            text: self.shown(line).to_owned(),
            label: label.to_owned(),
            xyz_mm: xyz.map(|v| v * unit.in_mm()),
            ..Point::default()
        }
    }

    /// A row at a line that is no point, with the rule that says so.
    fn no_point(&self, line: usize, label: &str, reason: impl Into<String>) -> Point {
        Point { refused: Some(reason.into()), ..self.point(line, label, [0.0; 3], Unit::Millimetre) }
    }
}

/// An error where the file states another unit than the campaign.
fn unit_agrees(stated: Unit, of_file: Unit, how: &str, place: Place) -> Result<(), Message> {
    if stated == of_file {
        return Ok(());
    }
    let what = format!("the file is in {} ({how}), and the campaign states {}", of_file.name(), stated.name());
    Err(Message::error(what).at(place).hint(format!("state `unit = \"{}\"` for this export", of_file.name())))
}

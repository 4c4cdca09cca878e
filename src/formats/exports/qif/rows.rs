//! A QIF file as rows of a campaign's export.

use super::{MeasuredFeature, Touch};
use crate::dialect::Unit;
use crate::{Point, Stated};
use etalon_base::catalogue::Phrase;
use etalon_base::message::Problems;
use etalon_base::phrase;
use etalon_base::pose::Vector;

/// Rows of a QIF file, with their problems; the given unit must be the unit of the file.
///
/// A feature with a centre or a place (point, circle, sphere, torus) is one row with its given
/// location; another feature has one row for each point. The label is the name of the feature.
/// Probe centres are rejected: they are not on the feature. Each warning is a rejected row.
pub(super) fn rows(file: &str, text: &str, unit: Unit) -> (Vec<Point>, Problems) {
    let read = match super::read(file, text, Some(unit.in_mm())) {
        Ok(read) => read,
        Err(problems) => return (Vec::new(), problems),
    };
    let rows = read.features.iter().flat_map(|feature| {
        let place = &feature.place;
        let row = |xyz_mm: Vector, refused: Option<Phrase>| Point {
            line: place.line.unwrap_or(0) as u32,
            text: place.text.clone().unwrap_or_default().into(),
            label: feature.label().into(),
            xyz_mm,
            more: Stated { refused: refused.map(Box::new), ..Stated::default() }.boxed(),
            ..Point::default()
        };
        match located(feature) {
            Some(location) => vec![row(location, None)],
            None => {
                let centre = feature.touch != Touch::Contact;
                let refused = centre.then(|| phrase!("probe-centre-no-point"));
                feature.points_mm.iter().map(|&p| row(p, refused.clone())).collect()
            }
        }
    });
    // last, so that they do not move the number of a row
    let said = read.messages.iter().map(|message| {
        let place = message.place.as_deref().cloned().unwrap_or_default();
        let (line, text) = (place.line.unwrap_or(0), place.text.unwrap_or_default());
        let more = Stated { refused: Some(Box::new(message.phrase())), ..Stated::default() }.boxed();
        Point { line: line as u32, text: text.into(), more, ..Point::default() }
    });
    (rows.chain(said).collect(), Problems::default())
}

/// The given location of a feature.
fn located(feature: &MeasuredFeature) -> Option<Vector> {
    let kinds =
        ["Point", "EdgePoint", "Circle", "CircularArc", "Sphere", "SphericalSegment", "Torus", "ToroidalSegment"];
    feature.stated.point_mm.filter(|_| kinds.contains(&feature.kind.as_str()))
}

//! The report of a plan: which poses, how good, how far from the best, and what a calibration with them would come to.

mod chosen;
mod curve;
mod parameter_errors;

use super::points::Picture;
use super::words::Words;
use super::{map, number, templates};
use crate::base::message::Result;
use crate::document::{PlanDocument, PointError, Presentation, StudyDocument};
use serde::Serialize;

/// What the template sees.
#[derive(Serialize)]
struct Page<'a> {
    plan: &'a PlanDocument,
    configurations: usize,
    columns: Vec<&'a str>,
    poses: Vec<(i64, Vec<String>)>,
    pictures: Vec<Picture>,
    study: Option<Study<'a>>,
}

/// A simulated calibration, ready to print.
#[derive(Serialize)]
struct Study<'a> {
    document: &'a StudyDocument,
    pictures: Vec<Picture>,
}

/// The report as one HTML page, from the document alone.
pub fn html(plan: &PlanDocument, presentation: &Presentation) -> Result<String> {
    let words = &Words::of(presentation.language)?;
    let columns = plan.chosen.iter().flat_map(|p| &p.configurations).next();
    let columns: Vec<&str> = columns.iter().flat_map(|c| c.keys().map(String::as_str)).collect();
    let cells = |configuration: &std::collections::BTreeMap<String, f64>| {
        // assembly modes are whole
        let cell = |v: &f64| number::fixed(*v, if v.fract() == 0.0 { 0 } else { 4 });
        columns.iter().map(|c| configuration.get(*c).map_or_else(String::new, cell)).collect()
    };
    let rows = plan.chosen.iter().flat_map(|p| p.configurations.iter().map(move |c| (p.pose, c)));
    let poses = rows.map(|(pose, c)| (pose, cells(c))).collect();
    let pictures = [curve::curve(plan, words), chosen::map(plan, words)].into_iter().flatten().collect();
    let study = plan.study.as_ref().map(|document| {
        let errors: Vec<PointError> = document.places.iter().map(|place| error(place, words)).collect();
        let drawable = super::points::drawable(&errors);
        let planar = errors.iter().all(|e| e.at_mm[2] == 0.0);
        let mut pictures = parameter_errors::pictures(document, words);
        if !drawable.is_empty() {
            pictures.extend(map::maps(&drawable, planar, words));
        }
        Study { document, pictures }
    });
    let configurations = plan.chosen.iter().map(|p| p.configurations.len()).sum();
    let page = Page { plan, configurations, columns, poses, pictures, study };
    templates::render("plan.html", presentation, words, page)
}

/// The largest error of a place as a mark of a map.
fn error(place: &crate::document::StudiedPlace, words: &Words) -> PointError {
    PointError {
        set: "validation".to_owned(),
        pose: place.pose,
        cycle: 1,
        target: words.say("largest of all working modes"),
        at_mm: place.at_mm,
        before_mm: [place.max_before_mm, 0.0, 0.0],
        after_mm: [place.max_mm, 0.0, 0.0],
        before_deg: None,
        after_deg: None,
    }
}

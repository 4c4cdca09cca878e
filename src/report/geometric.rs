//! The geometric calibration beside the identification: what the technician's way finds, and what it costs.

use super::number;
use super::plane::{Plane, WIDTH};
use super::svg::Svg;
use super::words::Words;
use crate::document::{GeometricDocument, GeometricQuantity, MeanError, PoseRow};
use serde::Serialize;

#[derive(Debug, Serialize)]
pub(super) struct Section<'a> {
    pub document: &'a GeometricDocument,
    pub sentence: String,
    pub quantities: Vec<[String; 10]>,
    pub leads: Vec<[String; 6]>,
    pub tables: Vec<Table>,
    pub drawing: Option<String>,
}

#[derive(Debug, Serialize)]
pub(super) struct Table {
    pub title: String,
    /// pose, command, four errors of each method, standard deviation
    pub rows: Vec<Vec<String>>,
}

pub(super) fn section<'a>(document: &'a GeometricDocument, words: &Words) -> Section<'a> {
    Section {
        document,
        sentence: sentence(document, words),
        quantities: document.quantities.iter().map(quantity).collect(),
        leads: leads(document),
        tables: document
            .tables
            .iter()
            .map(|t| Table { title: t.title.clone(), rows: t.rows.iter().map(row).collect() })
            .collect(),
        drawing: drawing(document, words),
    }
}

/// What the technician's way costs in accuracy.
fn sentence(document: &GeometricDocument, words: &Words) -> String {
    let largest = |name: &str| document.methods.iter().find(|m| m.name == name).map(|m| m.position_max_mm);
    let (Some(before), Some(geometric), Some(identified)) =
        (largest("before"), largest("geometric"), largest("identified"))
    else {
        return String::new();
    };
    let mm = |v: f64| number::significant(v, 3);
    let times = |a: f64, b: f64| number::significant(a / b, 2);
    let values: [&dyn std::fmt::Display; 5] =
        [&mm(before), &mm(geometric), &times(before, geometric), &mm(identified), &times(geometric, identified)];
    let alone = words.fill(
        "The largest mean position error falls from {0} mm to {1} mm by geometry alone, {2} times less.",
        &values,
    );
    let beside = words.fill(
        "Identification of all parameters from the same campaign brings it to {3} mm: the technician's way leaves {4} times as much.",
        &values,
    );
    format!("{alone} {beside}")
}

fn quantity(q: &GeometricQuantity) -> [String; 10] {
    let u = Some(q.standard_uncertainty);
    let small = |v: f64| number::significant(v, 2);
    let repeats = q.repeats.as_ref();
    let difference = q.identified - q.value;
    [
        q.name.clone(),
        q.unit.clone(),
        number::with_uncertainty(q.nominal, u),
        number::with_uncertainty(q.value, u),
        small(q.standard_uncertainty),
        repeats.map_or_else(String::new, |r| r.count.to_string()),
        repeats.map_or_else(String::new, |r| small(r.standard_deviation)),
        repeats.map_or_else(String::new, |r| small(r.expected)),
        number::with_uncertainty(q.identified, q.identified_standard_uncertainty),
        number::with_uncertainty(difference, u),
    ]
}

fn leads(document: &GeometricDocument) -> Vec<[String; 6]> {
    let lead = |l: &crate::document::LeadResult| {
        let off = l.linearity.iter().fold(0.0f64, |m, p| m.max(p.deviation_mm.abs()));
        [
            l.actuator.to_string(),
            number::fixed(l.nominal_lead_mm, 3),
            number::with_uncertainty(l.actual_lead_mm, Some(l.standard_uncertainty * l.nominal_lead_mm)),
            number::significant(1e3 * l.error, 3),
            number::significant(1e3 * l.standard_uncertainty, 2),
            number::significant(1e3 * off, 2),
        ]
    };
    document.leads.iter().map(lead).collect()
}

fn row(r: &PoseRow) -> Vec<String> {
    let [x, y] = r.command_mm;
    let command =
        format!("{}, {} mm, {} deg", number::fixed(x, 3), number::fixed(y, 3), number::fixed(r.command_deg, 2));
    let errors = |e: &MeanError| {
        [e.x_mm, e.y_mm, e.position_mm, e.orientation_deg].map(|v| number::fixed(v, 3)).into_iter().collect::<Vec<_>>()
    };
    let mut cells = vec![r.pose.to_string(), command];
    for method in [&r.before, &r.geometric, &r.identified] {
        cells.extend(errors(method));
    }
    cells.push(number::fixed(r.standard_deviation_mm, 3));
    cells
}

/// Outlines of the regions, the last one (every orientation) heavier.
fn drawing(document: &GeometricDocument, words: &Words) -> Option<String> {
    let regions: Vec<_> = document.workspace.iter().filter(|r| r.corners_mm.len() > 2).collect();
    let corners: Vec<_> = regions.iter().flat_map(|r| &r.corners_mm).copied().collect();
    if corners.is_empty() || !corners.iter().flatten().all(|v| v.abs() < 1e7) {
        return None;
    }
    let plane = Plane::around((0, 1), &corners);
    let title = words.fill("Workspace of the platform's centre C, {0} plane", &[&"xy"]);
    let names = regions.iter().map(|r| format!("{}: {} mm²", r.name, number::fixed(r.area_mm2, 0)));
    let mut svg = Svg::new("workspace", WIDTH, plane.height(), &title, &names.collect::<Vec<_>>().join("; "));
    plane.draw(&mut svg, words);
    for region in &regions {
        let last = document.workspace.last().is_some_and(|l| l.name == region.name);
        for (a, b) in region.corners_mm.iter().zip(region.corners_mm.iter().cycle().skip(1)) {
            svg.line(if last { "arrow-scale" } else { "arrow-cal" }, plane.at(*a), plane.at(*b));
        }
    }
    Some(svg.finish())
}

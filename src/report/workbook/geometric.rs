//! The geometric calibration: quantities beside the identified ones, errors by pose, and what they were made from.

use super::sheet::Sheet;
use crate::document::{GeometricDocument, LeadResult, Linearity, PoseRow, PoseTable};

pub(super) fn sheets(document: &GeometricDocument) -> Vec<Sheet> {
    let sheets = [
        quantities(document),
        poses(document),
        Sheet::of(
            "Geometry, methods",
            &document.methods,
            &[
                ("method", "", |m| m.name.as_str().into()),
                ("position, max", "mm", |m| m.position_max_mm.into()),
                ("position, RMS", "mm", |m| m.position_rms_mm.into()),
                ("orientation, max", "deg", |m| m.orientation_max_deg.into()),
            ],
        ),
        leads(document),
        Sheet::of(
            "Geometry, scale bars",
            &document.scale_bars,
            &[
                ("position", "", |b| b.name.as_str().into()),
                ("length", "mm", |b| b.length_mm.into()),
                ("distances", "", |b| b.count.into()),
                ("mean error", "mm", |b| b.mean_error_mm.into()),
                ("standard deviation", "mm", |b| b.standard_deviation_mm.into()),
            ],
        ),
        Sheet::of(
            "Geometry, balls",
            &document.balls,
            &[
                ("ball", "", |b| b.name.as_str().into()),
                ("readings", "", |b| b.count.into()),
                ("mean distance from their mean", "mm", |b| b.mean_mm.into()),
                ("standard deviation", "mm", |b| b.standard_deviation_mm.into()),
                ("mean + 3 s", "mm", |b| b.repeatability_mm.into()),
            ],
        ),
        Sheet::of(
            "Geometry, fits",
            &document.steps,
            &[
                ("fit", "", |s| s.name.as_str().into()),
                ("residuals", "", |s| s.count.into()),
                ("standard deviation", "mm", |s| s.standard_deviation_mm.into()),
                ("expected", "mm", |s| s.expected_mm.into()),
                ("max", "mm", |s| s.max_mm.into()),
                ("norm", "mm", |s| s.norm_mm.into()),
                ("arc", "deg", |s| s.coverage_deg.into()),
                ("uncertainties enlarged by", "", |s| s.enlarged_by.into()),
            ],
        ),
        Sheet::of(
            "Geometry, workspace",
            &document.workspace,
            &[
                ("region", "", |r| r.name.as_str().into()),
                ("area", "mm²", |r| r.area_mm2.into()),
                ("corners", "", |r| r.corners_mm.len().into()),
            ],
        ),
    ];
    sheets.into_iter().filter(|s| !s.rows.is_empty()).collect()
}

fn quantities(document: &GeometricDocument) -> Sheet {
    Sheet::of(
        "Geometry, quantities",
        &document.quantities,
        &[
            ("name", "", |q| q.name.as_str().into()),
            ("unit", "", |q| q.unit.as_str().into()),
            ("nominal", "", |q| q.nominal.into()),
            ("geometric", "", |q| q.value.into()),
            ("u (k = 1)", "", |q| q.standard_uncertainty.into()),
            ("repeats", "", |q| q.repeats.as_ref().map(|r| r.count).into()),
            ("their standard deviation", "", |q| q.repeats.as_ref().map(|r| r.standard_deviation).into()),
            ("expected from the points", "", |q| q.repeats.as_ref().map(|r| r.expected).into()),
            ("identified", "", |q| q.identified.into()),
            ("u of identified", "", |q| q.identified_standard_uncertainty.into()),
        ],
    )
}

fn poses(document: &GeometricDocument) -> Sheet {
    let rows: Vec<(&PoseTable, &PoseRow)> =
        document.tables.iter().flat_map(|t| t.rows.iter().map(move |r| (t, r))).collect();
    Sheet::of(
        "Geometry, poses",
        &rows,
        &[
            ("table", "", |(t, _)| t.title.as_str().into()),
            ("pose", "", |(_, r)| r.pose.into()),
            ("command x", "mm", |(_, r)| r.command_mm[0].into()),
            ("command y", "mm", |(_, r)| r.command_mm[1].into()),
            ("command θ", "deg", |(_, r)| r.command_deg.into()),
            ("visits", "", |(_, r)| r.count.into()),
            ("before, x", "mm", |(_, r)| r.before.x_mm.into()),
            ("before, y", "mm", |(_, r)| r.before.y_mm.into()),
            ("before, x y", "mm", |(_, r)| r.before.position_mm.into()),
            ("before, θ", "deg", |(_, r)| r.before.orientation_deg.into()),
            ("geometric, x", "mm", |(_, r)| r.geometric.x_mm.into()),
            ("geometric, y", "mm", |(_, r)| r.geometric.y_mm.into()),
            ("geometric, x y", "mm", |(_, r)| r.geometric.position_mm.into()),
            ("geometric, θ", "deg", |(_, r)| r.geometric.orientation_deg.into()),
            ("identified, x", "mm", |(_, r)| r.identified.x_mm.into()),
            ("identified, y", "mm", |(_, r)| r.identified.y_mm.into()),
            ("identified, x y", "mm", |(_, r)| r.identified.position_mm.into()),
            ("identified, θ", "deg", |(_, r)| r.identified.orientation_deg.into()),
            ("standard deviation", "mm", |(_, r)| r.standard_deviation_mm.into()),
        ],
    )
}

fn leads(document: &GeometricDocument) -> Sheet {
    let rows: Vec<(&LeadResult, &Linearity)> =
        document.leads.iter().flat_map(|l| l.linearity.iter().map(move |p| (l, p))).collect();
    Sheet::of(
        "Geometry, leads",
        &rows,
        &[
            ("actuator", "", |(l, _)| l.actuator.into()),
            ("nominal lead", "mm", |(l, _)| l.nominal_lead_mm.into()),
            ("actual lead", "mm", |(l, _)| l.actual_lead_mm.into()),
            ("relative error", "", |(l, _)| l.error.into()),
            ("u of it (k = 1)", "", |(l, _)| l.standard_uncertainty.into()),
            ("commanded", "mm", |(_, p)| p.commanded_mm.into()),
            ("mean deviation from linear", "mm", |(_, p)| p.deviation_mm.into()),
        ],
    )
}

//! Characteristics of ISO 9283, one kind on a sheet; kinds that the document has none of are left out.

use super::sheet::{Cell, Field, Sheet};
use crate::document::{
    Iso9283Approach, Iso9283ComplianceDocument, Iso9283Conformity, Iso9283Distance, Iso9283Document, Iso9283Drift,
    Iso9283Epoch, Iso9283Pose, Iso9283Variation, Iso9283Visit,
};

pub(super) fn sheets(document: &Iso9283Document) -> Vec<Sheet> {
    let mut sheets = vec![poses(document)];
    let others = [
        without_empty_columns(Sheet::of("ISO 9283 distances", &document.distances, DISTANCE)),
        without_empty_columns(Sheet::of("ISO 9283 variation", &document.approaches, VARIATION)),
        approaches(&document.approaches),
        drifts(&document.drifts),
        Sheet::of("ISO 9283 reference targets", &document.reference, REFERENCE),
        whole(document),
        Sheet::of("ISO 9283 visits", &document.visits, VISIT),
    ];
    sheets.extend(others.into_iter().filter(|s| !s.rows.is_empty()));
    sheets
}

/// Static compliance.
pub(super) fn compliance(document: &Iso9283ComplianceDocument) -> Sheet {
    Sheet::of(
        "ISO 9283 compliance",
        &document.directions,
        &[
            ("direction", "", |d| d.direction.as_str().into()),
            ("compliance", "mm/N", |d| d.compliance_mm_n.into()),
            ("its u (k = 1)", "mm/N", |d| d.standard_uncertainty_mm_n.into()),
            ("largest force", "N", |d| d.force_n.into()),
            ("largest displacement", "mm", |d| d.largest_mm.into()),
            ("off the line", "mm", |d| d.off_line_mm.into()),
            ("readings", "", |d| d.readings.into()),
            ("cycles", "", |d| d.cycles.into()),
        ],
    )
}

fn poses(document: &Iso9283Document) -> Sheet {
    let mut sheet = Sheet::of("ISO 9283 poses", document.poses.iter().chain(&document.homing), POSE);
    for row in sheet.rows.iter_mut().skip(document.poses.len()) {
        row[0] = "homing".into();
    }
    without_empty_columns(sheet)
}

/// Columns without any value are left out: angles of a robot that has none, limits that nobody states.
fn without_empty_columns(mut sheet: Sheet) -> Sheet {
    let used = |i: usize| sheet.rows.iter().any(|row| row[i] != Cell::Empty);
    let keep: Vec<usize> = (0..sheet.columns.len()).filter(|&i| used(i)).collect();
    sheet.columns = keep.iter().map(|&i| sheet.columns[i].clone()).collect();
    sheet.rows = sheet.rows.iter().map(|row| keep.iter().map(|&i| row[i].clone()).collect()).collect();
    sheet
}

const POSE: &[Field<Iso9283Pose>] = &[
    ("pose", "", |p| p.pose.into()),
    ("visits", "", |p| p.cycles.into()),
    ("AP", "mm", |p| p.ap_mm.into()),
    ("AP x", "mm", |p| p.ap_x_mm.into()),
    ("AP y", "mm", |p| p.ap_y_mm.into()),
    ("AP z", "mm", |p| p.ap_z_mm.into()),
    ("RP", "mm", |p| p.rp_mm.into()),
    ("RP, 95 % from", "mm", |p| p.rp_interval.map(|i| i.low_mm).into()),
    ("RP, 95 % to", "mm", |p| p.rp_interval.map(|i| i.high_mm).into()),
    ("RP without noise", "mm", |p| p.rp_without_noise_mm.into()),
    ("RP in x, y", "mm", |p| p.rp_xy_mm.into()),
    ("RP along x", "mm", |p| p.rp_along_x_mm.into()),
    ("RP along y", "mm", |p| p.rp_along_y_mm.into()),
    ("RP along z", "mm", |p| p.rp_along_z_mm.into()),
    ("3 s of x", "mm", |p| p.rp_x_mm.into()),
    ("3 s of y", "mm", |p| p.rp_y_mm.into()),
    ("3 s of z", "mm", |p| p.rp_z_mm.into()),
    ("mean distance from the barycentre", "mm", |p| p.mean_radius_mm.into()),
    ("its standard deviation", "mm", |p| p.sd_radius_mm.into()),
    ("enclosing sphere, radius", "mm", |p| p.enclosing_radius_mm.into()),
    ("enclosing circle in x, y, radius", "mm", |p| p.enclosing_circle_radius_mm.into()),
    ("AP, 95 % from", "mm", |p| p.ap_interval.map(|i| i.low_mm).into()),
    ("AP, 95 % to", "mm", |p| p.ap_interval.map(|i| i.high_mm).into()),
    ("AP a", "deg", |p| p.ap_a_deg.into()),
    ("AP b", "deg", |p| p.ap_b_deg.into()),
    ("AP c", "deg", |p| p.ap_c_deg.into()),
    ("RP a", "deg", |p| p.rp_a_deg.into()),
    ("RP b", "deg", |p| p.rp_b_deg.into()),
    ("RP c", "deg", |p| p.rp_c_deg.into()),
    ("noise of a reading, x", "mm", |p| p.noise_mm.map(|n| n[0]).into()),
    ("noise of a reading, y", "mm", |p| p.noise_mm.map(|n| n[1]).into()),
    ("noise of a reading, z", "mm", |p| p.noise_mm.map(|n| n[2]).into()),
    ("ellipsoid, semi-axis 1", "mm", |p| p.ellipsoid.map(|e| e.semi_axes_mm[0]).into()),
    ("ellipsoid, semi-axis 2", "mm", |p| p.ellipsoid.map(|e| e.semi_axes_mm[1]).into()),
    ("ellipsoid, semi-axis 3", "mm", |p| p.ellipsoid.map(|e| e.semi_axes_mm[2]).into()),
    ("AP within its limit", "", |p| p.ap_conformity.map(conformity).into()),
    ("RP within its limit", "", |p| p.rp_conformity.map(conformity).into()),
    ("U over AP", "", |p| p.uncertainty_over_ap.into()),
    ("U over RP", "", |p| p.uncertainty_over_rp.into()),
    ("25 % rule", "", |p| p.quarter_rule_met.map(|met| if met { "met" } else { "not met" }).into()),
];

fn conformity(conformity: Iso9283Conformity) -> &'static str {
    match conformity {
        Iso9283Conformity::Conforming => "proved",
        Iso9283Conformity::NotConforming => "disproved",
        Iso9283Conformity::Neither => "neither proved nor disproved",
    }
}

const DISTANCE: &[Field<Iso9283Distance>] = &[
    ("pose", "", |d| d.poses[0].into()),
    ("other pose", "", |d| d.poses[1].into()),
    ("cycles", "", |d| d.cycles.into()),
    ("AD", "mm", |d| d.ad_mm.into()),
    ("AD x", "mm", |d| d.ad_axes_mm.first().copied().into()),
    ("AD y", "mm", |d| d.ad_axes_mm.get(1).copied().into()),
    ("AD z", "mm", |d| d.ad_axes_mm.get(2).copied().into()),
    ("RD", "mm", |d| d.rd_mm.into()),
    ("RD x", "mm", |d| d.rd_axes_mm.first().copied().into()),
    ("RD y", "mm", |d| d.rd_axes_mm.get(1).copied().into()),
    ("RD z", "mm", |d| d.rd_axes_mm.get(2).copied().into()),
    ("AD of the first angle", "deg", |d| d.ad_angles_deg.first().copied().into()),
    ("AD of the second angle", "deg", |d| d.ad_angles_deg.get(1).copied().into()),
    ("AD of the third angle", "deg", |d| d.ad_angles_deg.get(2).copied().into()),
    ("RD of the first angle", "deg", |d| d.rd_angles_deg.first().copied().into()),
    ("RD of the second angle", "deg", |d| d.rd_angles_deg.get(1).copied().into()),
    ("RD of the third angle", "deg", |d| d.rd_angles_deg.get(2).copied().into()),
];

const REFERENCE: &[Field<Iso9283Epoch>] = &[
    ("from cycle on", "", |e| e.cycle.into()),
    ("moved", "mm", |e| e.moved_mm.into()),
    ("left, RMS", "mm", |e| e.rms_mm.into()),
];

const VARIATION: &[Field<Iso9283Variation>] = &[
    ("pose", "", |v| v.pose.into()),
    ("vAP", "mm", |v| v.vap_mm.into()),
    ("between", "", |v| v.between[0].as_str().into()),
    ("and", "", |v| v.between[1].as_str().into()),
    ("vAP of the first angle", "deg", |v| v.vap_angles_deg.first().copied().into()),
    ("vAP of the second angle", "deg", |v| v.vap_angles_deg.get(1).copied().into()),
    ("vAP of the third angle", "deg", |v| v.vap_angles_deg.get(2).copied().into()),
];

const VISIT: &[Field<Iso9283Visit>] = &[
    ("pose", "", |v| v.pose.into()),
    ("cycle", "", |v| v.cycle.into()),
    ("approached", "", |v| v.approach.as_deref().into()),
    ("x", "mm", |v| v.attained_mm[0].into()),
    ("y", "mm", |v| v.attained_mm[1].into()),
    ("z", "mm", |v| v.attained_mm[2].into()),
];

/// One row for each set of each pose.
fn drifts(drifts: &[Iso9283Drift]) -> Sheet {
    let rows: Vec<(&Iso9283Drift, usize)> =
        drifts.iter().flat_map(|d| (0..d.ap_mm.len().max(d.rp_mm.len())).map(move |i| (d, i))).collect();
    Sheet::of(
        "ISO 9283 drift",
        &rows,
        &[
            ("pose", "", |(d, _)| d.pose.into()),
            ("set", "", |(_, i)| (i + 1).into()),
            ("AP", "mm", |(d, i)| d.ap_mm.get(*i).copied().into()),
            ("RP", "mm", |(d, i)| d.rp_mm.get(*i).copied().into()),
            ("dAP", "mm", |(d, _)| d.dap_mm.into()),
            ("dRP", "mm", |(d, _)| d.drp_mm.into()),
            ("settled after set", "", |(d, _)| d.settled_after.into()),
        ],
    )
}

/// Characteristics of the whole robot.
fn whole(document: &Iso9283Document) -> Sheet {
    let one = |what: &str, pose: Option<i64>, value: f64| (what.to_owned(), pose, value);
    let mut rows = Vec::new();
    rows.extend(document.exchangeability_mm.map(|v| one("exchangeability", None, v)));
    rows.extend(document.coplanarity_mm.map(|v| one("coplanarity, peak to valley", None, v)));
    let four = document.coplanarity_of_four.iter();
    rows.extend(four.map(|p| one("mean position from the plane of the other three", Some(p.pose), p.distance_mm)));
    Sheet::of(
        "ISO 9283 robot",
        &rows,
        &[
            ("characteristic", "", |r| r.0.as_str().into()),
            ("pose", "", |r| r.1.into()),
            ("value", "mm", |r| r.2.into()),
        ],
    )
}

/// One row for each approach of each pose.
fn approaches(variations: &[Iso9283Variation]) -> Sheet {
    let rows: Vec<(&Iso9283Variation, &Iso9283Approach)> =
        variations.iter().flat_map(|v| v.approaches.iter().map(move |a| (v, a))).collect();
    Sheet::of(
        "ISO 9283 approaches",
        &rows,
        &[
            ("pose", "", |(v, _)| v.pose.into()),
            ("approached", "", |(_, a)| a.name.as_str().into()),
            ("visits", "", |(_, a)| a.cycles.into()),
            ("mean x", "mm", |(_, a)| a.mean_mm[0].into()),
            ("mean y", "mm", |(_, a)| a.mean_mm[1].into()),
            ("mean z", "mm", |(_, a)| a.mean_mm[2].into()),
            ("RP", "mm", |(_, a)| a.rp_mm.into()),
            ("enclosing sphere, radius", "mm", |(_, a)| a.enclosing_radius_mm.into()),
        ],
    )
}

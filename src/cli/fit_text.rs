//! A fit as text.

use etalon_base::pose::Vector;
use etalon_documents::{FitDocument, FitStated, ZoneProof};
use std::fmt::Write;

/// Lines that describe a fit.
pub(super) fn as_text(document: &FitDocument) -> String {
    let mut text = String::new();
    let vector = |v: &Vector| format!("{:.6} {:.6} {:.6}", v[0], v[1], v[2]);
    let label = document.label.as_deref().map(|l| format!(" `{l}`")).unwrap_or_default();
    let _ = writeln!(text, "{}{label}: {} points", document.element, document.points);
    let u = document.standard_uncertainty.as_ref();
    let mut line = |name: &str, value: Option<String>, unit: &str, u: Option<f64>| {
        if let Some(value) = value {
            let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
            let u = u.map(|u| format!("  (u = {}{unit})", small(u))).unwrap_or_default();
            let _ = writeln!(text, "  {name:<12} {value}{unit}{u}");
        }
    };
    let point = document.center_mm.as_ref().or(document.point_mm.as_ref());
    let point_name = if document.center_mm.is_some() { "center" } else { "point" };
    line(point_name, point.map(vector), "mm", u.map(|u| u.point_mm));
    line("normal", document.normal.as_ref().map(vector), "", None);
    line("axis", document.axis.as_ref().map(vector), "", None);
    line("radius", document.radius_mm.map(|r| format!("{r:.6}")), "mm", u.and_then(|u| u.radius_mm));
    line("minor radius", document.minor_radius_mm.map(|r| format!("{r:.6}")), "mm", u.and_then(|u| u.minor_radius_mm));
    line("apex angle", document.apex_angle_deg.map(|a| format!("{a:.6}")), "deg", u.and_then(|u| u.apex_angle_deg));
    let spread = format!("rms {:.6}, max {:.6}, form {:.6}", document.rms_mm, document.max_mm, document.form_mm);
    line("residuals", Some(spread), "mm", None);
    line("flatness", document.flatness.as_ref().map(|f| format!("{:.6}", f.flatness_mm)), "mm", None);
    if let Some(contacts) = &document.contacts {
        let numbers = |points: &[usize]| points.iter().map(usize::to_string).collect::<Vec<_>>().join(" ");
        let held = format!("points {} and {}", numbers(&contacts.upper), numbers(&contacts.lower));
        line("held by", Some(held), "", None);
        let proof = match contacts.proof {
            ZoneProof::Global => "no other zone is narrower",
            ZoneProof::Local => "no neighbouring zone is narrower",
            ZoneProof::None => "none",
        };
        line("proof", Some(proof.to_owned()), "", None);
    }
    if let Some(probe) = &document.probe {
        let towards = probe.towards.as_ref().map(|d| format!(" {}", vector(d))).unwrap_or_default();
        let from = probe.side_from.as_deref().map(|f| format!(", {f}")).unwrap_or_default();
        line("probe", Some(format!("{:.6} mm {}{towards}{from}", probe.radius_mm, probe.side)), "", None);
        line("probe center", Some(vector(&probe.uncompensated_point_mm)), "mm", None);
        let radius = probe.uncompensated_minor_radius_mm.or(probe.uncompensated_radius_mm);
        line("its radius", radius.map(|r| format!("{r:.6}")), "mm", None);
    }
    if let Some(stated) = &document.stated {
        stated_lines(stated, line);
    }
    text
}

/// Lines that compare stated and fitted values.
fn stated_lines(stated: &FitStated, mut line: impl FnMut(&str, Option<String>, &str, Option<f64>)) {
    let vector = |v: &Vector| format!("{:.6} {:.6} {:.6}", v[0], v[1], v[2]);
    let off = |value: Option<f64>, unit: &str| {
        value.map(|v| format!(" {unit}, fitted {v:+.2e} {unit}")).unwrap_or_else(|| format!(" {unit}"))
    };
    let apart = |value: Option<f64>, unit: &str| {
        value.map(|v| format!(" {unit}, fitted {v:.2e} {unit} apart")).unwrap_or_else(|| format!(" {unit}"))
    };
    let number = |n: f64| format!("{n:.6}");
    line("stated point", stated.point_mm.as_ref().map(|p| vector(p) + &apart(stated.point_apart_mm, "mm")), "", None);
    let direction = stated.direction.as_ref().map(|d| {
        let apart = stated.direction_apart_deg.map(|a| format!(", fitted {a:.2e} deg apart")).unwrap_or_default();
        vector(d) + &apart
    });
    line("  direction", direction, "", None);
    line("  radius", stated.radius_mm.map(|r| number(r) + &off(stated.radius_less_stated_mm, "mm")), "", None);
    let minor = stated.minor_radius_mm.map(|r| number(r) + &off(stated.minor_radius_less_stated_mm, "mm"));
    line("  minor radius", minor, "", None);
    let apex = stated.apex_angle_deg.map(|a| number(a) + &off(stated.apex_angle_less_stated_deg, "deg"));
    line("  apex angle", apex, "", None);
}

/// An uncertainty with three digits, as a power of ten only if very small.
fn small(u: f64) -> String {
    let decimals = 2 - u.log10().floor().clamp(-4.0, 2.0) as i32;
    if u >= 1e-4 && u.is_finite() { format!("{u:.*}", decimals.max(0) as usize) } else { format!("{u:.2e}") }
}

//! A fit as text.

use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_base::pose::Vector;
use etalon_documents::{FitDocument, FitStated, ZoneProof};
use std::fmt::Write;

/// Lines that describe a fit.
pub(super) fn as_text(document: &FitDocument) -> String {
    let mut text = String::new();
    let vector = |v: &Vector| format!("{:.6} {:.6} {:.6}", v[0], v[1], v[2]);
    let label = document.label.as_deref().map(|l| format!(" `{l}`")).unwrap_or_default();
    let element = format!("{}{label}", document.element);
    let _ = writeln!(text, "{}", phrase!("fit-head", element, count = document.points));
    let u = document.standard_uncertainty.as_ref();
    let mut line = |name: Phrase, value: Option<String>, unit: &str, u: Option<f64>| {
        if let Some(value) = value {
            let name = name.to_string();
            // a direction is a unit vector, its uncertainty an angle
            let unit_of_u = if unit.is_empty() { "deg" } else { unit };
            let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
            let u = u.map(|u| format!("  (u = {} {unit_of_u})", small(u))).unwrap_or_default();
            let _ = writeln!(text, "  {name:<12} {value}{unit}{u}");
        }
    };
    let point = document.geometry.center_mm.as_ref().or(document.geometry.point_mm.as_ref());
    let point_name = if document.geometry.center_mm.is_some() { phrase!("fit-center") } else { phrase!("fit-point") };
    line(point_name, point.map(vector), "mm", u.map(|u| u.point_mm));
    let direction_u = u.and_then(|u| u.direction_deg);
    line(phrase!("fit-normal"), document.geometry.normal.as_ref().map(vector), "", direction_u);
    line(phrase!("fit-axis"), document.geometry.axis.as_ref().map(vector), "", direction_u);
    let fixed = |value: f64| format!("{value:.6}");
    let geometry = &document.geometry;
    line(phrase!("fit-radius"), geometry.radius_mm.map(fixed), "mm", u.and_then(|u| u.radius_mm));
    line(phrase!("fit-minor-radius"), geometry.minor_radius_mm.map(fixed), "mm", u.and_then(|u| u.minor_radius_mm));
    line(phrase!("fit-apex-angle"), geometry.apex_angle_deg.map(fixed), "deg", u.and_then(|u| u.apex_angle_deg));
    let deviations = &document.deviations;
    let [rms, max, form] = [deviations.rms_mm, deviations.max_mm, deviations.form_mm].map(fixed);
    let spread = phrase!("fit-spread", rms, max, form).to_string();
    line(phrase!("fit-residuals"), Some(spread), "mm", None);
    line(phrase!("fit-flatness"), deviations.flatness.as_ref().map(|f| fixed(f.flatness_mm)), "mm", None);
    if let Some(contacts) = &document.deviations.contacts {
        let numbers = |points: &[usize]| points.iter().map(usize::to_string).collect::<Vec<_>>().join(" ");
        let held =
            phrase!("fit-held-points", upper = numbers(&contacts.upper), lower = numbers(&contacts.lower)).to_string();
        line(phrase!("fit-held-by"), Some(held), "", None);
        let proof = match contacts.proof {
            ZoneProof::Global => phrase!("fit-proof-global"),
            ZoneProof::Local => phrase!("fit-proof-local"),
            ZoneProof::None => phrase!("fit-proof-none"),
        };
        line(phrase!("fit-proof"), Some(proof.to_string()), "", None);
    }
    if let Some(probe) = &document.probe {
        let towards = probe.towards.as_ref().map(|d| format!(" {}", vector(d))).unwrap_or_default();
        let from = probe.side_from.as_ref().map(|f| format!(", {f}")).unwrap_or_default();
        line(phrase!("fit-probe"), Some(format!("{:.6} mm {}{towards}{from}", probe.radius_mm, probe.side)), "", None);
        line(phrase!("fit-probe-center"), Some(vector(&probe.uncompensated_point_mm)), "mm", None);
        let radius = probe.uncompensated_minor_radius_mm.or(probe.uncompensated_radius_mm);
        line(phrase!("fit-its-radius"), radius.map(|r| format!("{r:.6}")), "mm", None);
    }
    if let Some(stated) = &document.stated {
        stated_lines(stated, line);
    }
    text
}

/// Lines that compare the values of the file with the fitted values.
fn stated_lines(stated: &FitStated, mut line: impl FnMut(Phrase, Option<String>, &str, Option<f64>)) {
    let vector = |v: &Vector| format!("{:.6} {:.6} {:.6}", v[0], v[1], v[2]);
    let off = |value: Option<f64>, off: Option<f64>, unit: &str| {
        let value = format!("{:.6}", value?);
        Some(match off {
            Some(off) => phrase!("fit-off", value, unit, off = format!("{off:+.2e}")).to_string(),
            None => format!("{value} {unit}"),
        })
    };
    let apart = |value: Option<&Vector>, apart: Option<f64>, unit: &str, else_unit: &str| {
        let value = vector(value?) + else_unit;
        Some(match apart {
            Some(apart) => phrase!("fit-apart", value, apart = format!("{apart:.2e}"), unit).to_string(),
            None => value,
        })
    };
    let point = apart(stated.point_mm.as_ref(), stated.point_apart_mm, "mm", " mm");
    line(phrase!("fit-stated-point"), point, "", None);
    let direction = apart(stated.direction.as_ref(), stated.direction_apart_deg, "deg", "");
    line(phrase!("fit-stated-direction"), direction, "", None);
    line(phrase!("fit-stated-radius"), off(stated.radius_mm, stated.radius_less_stated_mm, "mm"), "", None);
    let minor = off(stated.minor_radius_mm, stated.minor_radius_less_stated_mm, "mm");
    line(phrase!("fit-stated-minor-radius"), minor, "", None);
    let apex = off(stated.apex_angle_deg, stated.apex_angle_less_stated_deg, "deg");
    line(phrase!("fit-stated-apex-angle"), apex, "", None);
}

/// An uncertainty with three digits, as a power of ten only if very small.
fn small(u: f64) -> String {
    let decimals = 2 - u.log10().floor().clamp(-4.0, 2.0) as i32;
    if u >= 1e-4 && u.is_finite() { format!("{u:.*}", decimals.max(0) as usize) } else { format!("{u:.2e}") }
}

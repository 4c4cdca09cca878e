//! Fits of measured features of a QIF file, compared with the values given in the file.

use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Problems, Result};
use etalon_base::pose::{Vector, cross, dot, minus, norm};
use etalon_base::worded::Worded;
use etalon_base::{error, phrase};
use etalon_documents::{FitDocument, FitStated};
use etalon_fit::{Element, Fit, FitSettings, Probe, Side, Source};
use etalon_formats::qif::{FeatureGeometry, MeasuredFeature, Touch};

/// Data of the probe from the user, which replace the data of the file.
#[derive(Clone, Copy, Debug, Default)]
pub struct ProbeStated {
    /// Its radius.
    pub radius_mm: Option<f64>,
    /// Its side.
    pub side: Option<Side>,
}

/// Fits a measured feature to its points by `settings` (without probe), compensates it if the
/// points are probe centres, and compares it with the values of the file; `None` if it has no
/// points or is not an element.
///
/// A circle whose given normal is exactly an axis of coordinates is fitted in that plane: no
/// measured normal is.
///
/// # Errors
/// Fails if the points do not determine the element, or if they are probe centres and neither the
/// file nor the user gives the size and side of the probe.
pub fn refit(feature: &MeasuredFeature, settings: &FitSettings, probe: ProbeStated) -> Result<Option<FitDocument>> {
    let Some(element) = feature.element().filter(|_| !feature.points_mm.is_empty()) else { return Ok(None) };
    let label = feature.label();
    let named = |problems: Problems| {
        let what = |m: Message| m.within(phrase!("of-name", name = label)).at(feature.place.clone());
        Problems(problems.0.into_iter().map(what).collect())
    };
    let in_plane = feature.stated.direction.filter(|d| element == Element::Circle3d && is_coordinate_axis(*d));
    let settings = FitSettings { axis: settings.axis.or(in_plane), probe: None, ..*settings };
    let centres = etalon_fit::element(element, &feature.points_mm, &settings).map_err(named)?;
    let messages = etalon_fit::warnings(&centres, &Source::from(&feature.points_mm), &settings);
    let (probe, side_from) = probe_and_source(feature, &centres, probe)?.unzip();
    let fit = centres.compensated(probe).map_err(named)?;
    let mut document = FitDocument { label: Some(label.to_owned()), ..FitDocument::new(&fit).with_messages(messages) };
    if let Some(probe) = &mut document.probe {
        probe.side_from = side_from.map(Worded::from);
    }
    document.stated = Some(against(feature, &fit));
    Ok(Some(document))
}

fn is_coordinate_axis(d: Vector) -> bool {
    d.iter().filter(|x| **x == 0.0).count() == 2
}

/// The probe whose centres the points are, and the source of its side; `None` for contact points.
fn probe_and_source(feature: &MeasuredFeature, centres: &Fit, stated: ProbeStated) -> Result<Option<(Probe, Phrase)>> {
    let Touch::Centre { radius_mm } = feature.touch else { return Ok(None) };
    let label = feature.label();
    let missing =
        |missing: &str| error!("probe-of-feature-unknown", feature = label, missing).at(feature.place.clone());
    let radius_mm = stated.radius_mm.or(radius_mm);
    let radius_mm = radius_mm.ok_or_else(|| missing("radius"))?;
    let (side, from) = match stated.side {
        Some(side) => (side, phrase!("side-stated")),
        None => side_and_source(feature, centres, radius_mm).ok_or_else(|| missing("side"))?,
    };
    Ok(Some((Probe { radius_mm, side }, from)))
}

/// The side of the probe, if the file contains it, and its source.
fn side_and_source(feature: &MeasuredFeature, centres: &Fit, probe_mm: f64) -> Option<(Side, Phrase)> {
    let known = [(&feature.nominal, "nominal"), (&feature.stated, "stated")];
    let first = |side: &dyn Fn(&FeatureGeometry) -> Option<Side>, of: &str| {
        known.iter().find_map(|(values, name)| Some((side(values)?, phrase!("side-from-values", values = name, of))))
    };
    match centres.element {
        Element::Plane => first(&|values| values.direction.map(Side::Towards), "normal"),
        // the centres lie about a probe radius from where the line is meant to be
        Element::Line | Element::Line2d => first(
            &|values| {
                let away = from_axis(centres.geometry.point_mm, values.point_mm?, centres.geometry.direction?);
                (norm(away) > 0.5 * probe_mm).then_some(Side::Towards(away))
            },
            "location",
        ),
        element => {
            let side = |inside: bool| if inside { Side::Inside } else { Side::Outside };
            if let Some(inside) = feature.internal {
                let stated = if inside { "INTERNAL" } else { "EXTERNAL" };
                return Some((side(inside), phrase!("side-from-key", value = stated)));
            }
            let by_size = |values: &FeatureGeometry| {
                let (size, found) = match element {
                    Element::Torus => (values.minor_radius_mm?, centres.geometry.minor_radius_mm?),
                    Element::Cone => return None,
                    _ => (values.radius_mm?, centres.geometry.radius_mm?),
                };
                ((size - found).abs() > 0.5 * probe_mm).then_some(side(found < size))
            };
            first(&by_size, "diameter")
        }
    }
}

/// Vector from the line through `axis_point` along `d` to `p`, perpendicular to the line.
fn from_axis(p: Vector, axis_point: Vector, d: Vector) -> Vector {
    let w = minus(p, axis_point);
    let along = dot(w, d);
    std::array::from_fn(|k| w[k] - along * d[k])
}

/// The given values, and the deviations of the fit from them.
fn against(feature: &MeasuredFeature, fit: &Fit) -> FitStated {
    let stated = &feature.stated;
    let apart = |p: Vector| match (fit.element, fit.geometry.direction) {
        (Element::Plane, Some(n)) => dot(minus(p, fit.geometry.point_mm), n).abs(),
        (Element::Line | Element::Cylinder | Element::Cone, Some(d)) => norm(from_axis(p, fit.geometry.point_mm, d)),
        _ => norm(minus(p, fit.geometry.point_mm)),
    };
    let angle_deg = |(a, b): (Vector, Vector)| norm(cross(a, b)).atan2(dot(a, b).abs()).to_degrees();
    let less = |fitted: Option<f64>, stated: Option<f64>| Some(fitted? - stated?);
    // the radius of a cone is given at a point of the file's choice
    let radius_mm = fit.geometry.radius_mm.filter(|_| fit.element != Element::Cone);
    FitStated {
        id: feature.id.clone(),
        point_mm: stated.point_mm,
        direction: stated.direction,
        radius_mm: stated.radius_mm,
        minor_radius_mm: stated.minor_radius_mm,
        apex_angle_deg: stated.apex_angle_rad.map(f64::to_degrees),
        point_apart_mm: stated.point_mm.map(apart),
        direction_apart_deg: fit.geometry.direction.zip(stated.direction).map(angle_deg),
        radius_less_stated_mm: less(radius_mm, stated.radius_mm),
        minor_radius_less_stated_mm: less(fit.geometry.minor_radius_mm, stated.minor_radius_mm),
        apex_angle_less_stated_deg: less(fit.geometry.apex_angle_rad, stated.apex_angle_rad).map(f64::to_degrees),
    }
}

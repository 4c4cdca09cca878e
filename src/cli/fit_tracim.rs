//! Answers to tests of TraCIM.

use super::Output;
use etalon_base::message::{Place, Problems};
use etalon_base::{error, files, phrase, warning};
use etalon_fit::{CircleMethod, Element, Fit, FitSettings, MinimumZone, Source};
use etalon_formats::tracim::{DataSet, Package, Quantities, Request};
use std::path::Path;

/// Answer to the test data in a file, as XML.
///
/// # Errors
/// Fails if the file is not a test, or if an element is unknown or cannot be fitted.
pub(super) fn answer(path: &Path, customer: Option<&str>, out: &Output) -> Result<String, Problems> {
    let name = path.display().to_string();
    let request = Request::read(&name, &files::read_text(path)?)?;
    let mut problems = Problems::default();
    let fitted = |set: &DataSet| {
        fit(request.package, set).map_err(|m| problems.0.extend(m.at(&Place::file(name.as_str())).0)).ok()
    };
    let results: Vec<Quantities> = request.sets.iter().filter_map(fitted).collect();
    problems.check()?;
    if customer.is_none() {
        out.say_message(&warning!("tracim-customer-missing"));
    }
    if request.package == Package::Chebyshev {
        out.say_message(&warning!("tracim-form-name"));
    }
    Ok(request.answer(customer.unwrap_or_default(), env!("CARGO_PKG_VERSION"), &results))
}

/// Element of a name of TraCIM in a test.
fn element(package: Package, object: &str) -> Option<Element> {
    match (package, object) {
        (Package::Gauss, "LINE_3D") => Some(Element::Line),
        (Package::Gauss, "CIRCLE" | "CIRCLE_3D") => Some(Element::Circle3d),
        (Package::Gauss, "CONE") => Some(Element::Cone),
        (Package::Chebyshev, "LINE_2D") => Some(Element::Line2d),
        (Package::Chebyshev, "CIRCLE_2D") => Some(Element::Circle2d),
        (_, "PLANE") => Some(Element::Plane),
        (_, "SPHERE") => Some(Element::Sphere),
        (_, "CYLINDER") => Some(Element::Cylinder),
        _ => None,
    }
}

fn fit(package: Package, set: &DataSet) -> Result<Quantities, Problems> {
    let unknown = || error!("tracim-object-unknown", id = set.id, object = set.object);
    let element = element(package, &set.object).ok_or_else(unknown)?;
    let within = |problems: Problems| -> Problems {
        Problems(problems.0.into_iter().map(|message| message.within(phrase!("in-feature", name = set.id))).collect())
    };
    match package {
        Package::Gauss => {
            // distances of the points from the element (manual, appendix)
            let settings = FitSettings { circle: CircleMethod::Orthogonal, ..FitSettings::default() };
            let fit = etalon_fit::element(element, Source::from(&set.points_mm), &settings).map_err(within)?;
            Ok(fit_quantities(&fit))
        }
        Package::Chebyshev => Ok(zone_quantities(&etalon_fit::minimum_zone(element, &set.points_mm).map_err(within)?)),
    }
}

fn fit_quantities(fit: &Fit) -> Quantities {
    // axes of cones point towards decreasing radii (manual, table 2), ours towards larger ones
    let sign = if fit.element == Element::Cone { -1.0 } else { 1.0 };
    Quantities {
        position_mm: fit.geometry.point_mm,
        orientation: fit.geometry.direction.map(|direction| direction.map(|v| sign * v)),
        radius_mm: fit.geometry.radius_mm,
        angle_deg: fit.geometry.apex_angle_rad.map(f64::to_degrees),
        form_mm: None,
    }
}

fn zone_quantities(zone: &MinimumZone) -> Quantities {
    Quantities {
        position_mm: zone.geometry.point_mm,
        // as in the public sample data
        orientation: zone.geometry.direction.or((zone.element == Element::Sphere).then_some([0.0; 3])),
        radius_mm: zone.geometry.radius_mm,
        angle_deg: None,
        form_mm: Some(zone.form_mm),
    }
}

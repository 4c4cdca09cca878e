//! Geometric elements of points: least squares, robust, minimum zone, or smallest enclosing.

use etalon_base::message::{Problems, Result};
use etalon_base::pose::Vector;
use etalon_base::{error, phrase};
use etalon_documents::FitDocument;
use etalon_fit::{Element, Fit, FitSettings, Probe, Side, Source};
use std::str::FromStr;

/// Element or smallest enclosing figure of points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Figure {
    /// Element of a fit.
    Element(Element),
    /// Smallest enclosing circle of the points in the plane z = 0.
    EnclosingCircle,
    /// Smallest enclosing sphere.
    EnclosingSphere,
}

impl Figure {
    const ENCLOSING: [Self; 2] = [Self::EnclosingCircle, Self::EnclosingSphere];

    /// Name in options and documents.
    pub fn name(self) -> &'static str {
        match self {
            Self::Element(element) => element.name(),
            Self::EnclosingCircle => "enclosing-circle",
            Self::EnclosingSphere => "enclosing-sphere",
        }
    }
}

impl FromStr for Figure {
    type Err = Problems;

    fn from_str(name: &str) -> Result<Self> {
        let enclosing = Self::ENCLOSING.into_iter().find(|figure| figure.name() == name);
        enclosing.map_or_else(|| name.parse().map(Self::Element), Ok)
    }
}

/// Criterion of a fit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Criterion {
    /// Least squares of all points.
    #[default]
    LeastSquares,
    /// Least squares without points that are far from the element of all others.
    Robust,
    /// Minimum zone (Chebyshev).
    MinimumZone,
}

/// Document of a fit.
#[derive(Debug)]
pub struct Fitted {
    /// The document.
    pub document: FitDocument,
    /// Fit by least squares; `None` for other criteria and for enclosing figures.
    pub fit: Option<Fit>,
}

impl From<FitDocument> for Fitted {
    fn from(document: FitDocument) -> Self {
        Self { document, fit: None }
    }
}

/// Returns the probe whose centres are the points, if any.
///
/// # Errors
/// Rejects a radius without a side, and a side without a radius.
pub fn stated_probe(radius_mm: Option<f64>, side: Option<Side>) -> Result<Option<Probe>> {
    match (radius_mm, side) {
        (None, None) => Ok(None),
        (Some(radius_mm), Some(side)) => Ok(Some(Probe { radius_mm, side })),
        (Some(_), None) => Err(error!("probe-side-missing").into()),
        (None, Some(_)) => Err(error!("probe-radius-missing").into()),
    }
}

/// Returns the side of a probe with this name.
///
/// # Errors
/// Rejects names other than `inside` and `outside`.
pub fn named_side(name: &str) -> Result<Side> {
    match name {
        "inside" => Ok(Side::Inside),
        "outside" => Ok(Side::Outside),
        text => Err(error!("probe-side-unknown", text).into()),
    }
}

/// Fits a figure to points.
///
/// # Errors
/// Fails if the points do not determine the figure, or if a setting does not apply to it.
pub fn fit(figure: Figure, criterion: Criterion, points: &Source, settings: &FitSettings) -> Result<Fitted> {
    let Figure::Element(element) = figure else {
        return enclose(figure, criterion, points, settings).map(Fitted::from);
    };
    match criterion {
        Criterion::MinimumZone => {
            let zone = etalon_fit::minimum_zone(element, &points.in_space());
            let zone = zone.map_err(|problems| by_least_squares(element, problems))?;
            Ok(FitDocument::minimum_zone(&zone).into())
        }
        Criterion::Robust => {
            let found = etalon_fit::robust_element(element, &points.in_space(), settings)?;
            Ok(Fitted { document: FitDocument::robust(&found), fit: Some(found.fit) })
        }
        Criterion::LeastSquares => {
            let fit = etalon_fit::element(element, points.clone(), settings)?;
            let messages = etalon_fit::warnings(&fit, points, settings);
            Ok(Fitted { document: FitDocument::new(&fit).with_messages(messages), fit: Some(fit) })
        }
    }
}

/// Returns the smallest circle or sphere around the points, which has no other criterion.
fn enclose(figure: Figure, criterion: Criterion, points: &Source, settings: &FitSettings) -> Result<FitDocument> {
    let element = figure.name();
    match criterion {
        Criterion::Robust => return Err(error!("enclosing-robust", element).into()),
        _ if settings.probe.is_some() => return Err(error!("enclosing-with-probe", element).into()),
        Criterion::MinimumZone => return Err(error!("enclosing-minimum-zone", element).into()),
        Criterion::LeastSquares => {}
    }
    let points = points.in_space();
    if figure == Figure::EnclosingSphere {
        return Ok(FitDocument::enclosing(element, &points, &etalon_fit::enclosing_sphere(&points)?));
    }
    let plane: Vec<[f64; 2]> = points.iter().map(|[x, y, _]| [*x, *y]).collect();
    let flat: Vec<Vector> = plane.iter().map(|[x, y]| [*x, *y, 0.0]).collect();
    Ok(FitDocument::enclosing(element, &flat, &etalon_fit::enclosing_circle(&plane)?))
}

/// Adds the hint to the refusal of an element without minimum zone.
fn by_least_squares(element: Element, mut problems: Problems) -> Problems {
    if let Some(first) = problems.0.first_mut().filter(|_| !element.has_minimum_zone()) {
        *first = first.clone().hint(phrase!("zone-by-least-squares"));
    }
    problems
}

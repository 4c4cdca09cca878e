//! Geometric elements of points, without a copy of the array.

use crate::computing::compute;
use crate::errors::{json, refused};
use etalon_base::message::Message;
use etalon_base::pose::Vector;
use etalon_documents::FitDocument;
use etalon_fit::{CircleMethod, Element, Fit, FitSettings, Probe, Side, Source};
use numpy::{
    IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods,
};
use pyo3::prelude::*;
use rayon::prelude::*;

/// Number of points for which another thread is worth its start.
const BLOCK: usize = 4096;

/// Options of a fit, a dictionary in Python.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Options<'py> {
    weights: Option<PyReadonlyArray1<'py, f64>>,
    radius_mm: Option<f64>,
    standard_uncertainty_mm: Option<f64>,
    axis: Option<Vector>,
    orthogonal: bool,
    probe_radius_mm: Option<f64>,
    probe_side: Option<ProbeSide>,
    minimum_zone: bool,
    robust: bool,
}

/// Where the probe was.
#[derive(FromPyObject)]
pub enum ProbeSide {
    /// "inside" or "outside".
    Word(String),
    /// The direction to the probe.
    Towards(Vector),
}

/// The rows of an array `(n, 3)`, which lie one behind the other.
pub fn rows<'a, const N: usize>(array: &'a PyReadonlyArray2<f64>) -> PyResult<&'a [[f64; N]]> {
    let shape = array.shape();
    // a slice in Fortran order has its columns one behind the other
    let flat = array.as_slice().ok().filter(|_| shape[1] == N && array.is_c_contiguous());
    flat.map(|flat| flat.as_chunks().0).ok_or_else(|| {
        let what = format!("an array of shape ({}, {}) was given", shape[0], shape[1]);
        refused(Message::error(what).expected(format!("(n, {N}), float64, in C order")).into())
    })
}

/// A fit by least squares.
#[pyclass(frozen, module = "etalon._etalon")]
pub struct Fitted(Fit);

#[pymethods]
impl Fitted {
    /// Signed distances (n,) of points (n, 3) from the element, mm.
    fn residuals<'py>(
        &self,
        py: Python<'py>,
        points: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let points = rows::<3>(&points)?;
        let all = points.par_iter().with_min_len(BLOCK);
        let residuals: Vec<f64> = compute(py, || all.map(|p| self.0.residual_mm(*p)).collect())?;
        Ok(residuals.into_pyarray(py))
    }
}

/// Fits an element; returns the document, and by least squares the fit.
#[pyfunction]
pub fn fit(
    py: Python<'_>,
    element: &str,
    points: PyReadonlyArray2<f64>,
    options: Options<'_>,
) -> PyResult<(String, Option<Fitted>)> {
    let element: Element = element.parse().map_err(refused)?;
    let points = rows::<3>(&points)?;
    if options.minimum_zone {
        let zone = compute(py, || etalon_fit::minimum_zone(element, points))?.map_err(refused)?;
        return Ok((json(&FitDocument::minimum_zone(None, &zone))?, None));
    }
    let probe = options.probe()?;
    let weights = options.weights.as_ref().map(|weights| weights.as_slice()).transpose()?;
    let circle = if options.orthogonal { CircleMethod::Orthogonal } else { CircleMethod::Projected };
    let Options { radius_mm, standard_uncertainty_mm, axis, .. } = options;
    let settings = FitSettings { weights, radius_mm, axis, circle, probe, standard_uncertainty_mm };
    let fitted = compute(py, || {
        if options.robust {
            let found = etalon_fit::robust_element(element, points, &settings)?;
            return Ok((FitDocument::robust(None, &found), found.fit));
        }
        let found = etalon_fit::element(element, points, &settings)?;
        let messages = etalon_fit::warnings(&found, &Source::from(points), &settings);
        Ok((FitDocument::new(None, &found).with_messages(messages), found))
    });
    let (document, found) = fitted?.map_err(refused)?;
    Ok((json(&document)?, Some(Fitted(found))))
}

impl Options<'_> {
    fn probe(&self) -> PyResult<Option<Probe>> {
        let side = match &self.probe_side {
            None => None,
            Some(ProbeSide::Towards(direction)) => Some(Side::Towards(*direction)),
            Some(ProbeSide::Word(word)) if word == "inside" => Some(Side::Inside),
            Some(ProbeSide::Word(word)) if word == "outside" => Some(Side::Outside),
            Some(ProbeSide::Word(word)) => {
                let message = Message::error(format!("`{word}` is not a side of the probe"));
                return Err(refused(message.expected("\"inside\", \"outside\" or a direction (x, y, z)").into()));
            }
        };
        match (self.probe_radius_mm, side) {
            (None, None) => Ok(None),
            (Some(radius_mm), Some(side)) => Ok(Some(Probe { radius_mm, side })),
            _ => {
                let message = Message::error("a probe has a radius and a side");
                Err(refused(message.hint("state `probe_radius_mm` and `probe_side`, or neither").into()))
            }
        }
    }
}

/// The smallest circle or sphere that encloses the points.
#[pyfunction]
pub fn enclosing(py: Python<'_>, sphere: bool, points: PyReadonlyArray2<f64>) -> PyResult<String> {
    let points = rows::<3>(&points)?;
    let document = compute(py, || {
        if sphere {
            let found = etalon_fit::enclosing_sphere(points)?;
            return Ok(FitDocument::enclosing("enclosing-sphere", None, points, &found));
        }
        let plane: Vec<[f64; 2]> = points.iter().map(|p| [p[0], p[1]]).collect();
        let flat: Vec<Vector> = plane.iter().map(|p| [p[0], p[1], 0.0]).collect();
        Ok(FitDocument::enclosing("enclosing-circle", None, &flat, &etalon_fit::enclosing_circle(&plane)?))
    });
    json(&document?.map_err(refused)?)
}

/// A rigid transform: the matrix (4, 4), the residuals (n, 3) and its uncertainties.
type Rigid<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<f64>>, f64, f64);

/// Fits the rigid transform that carries points onto others.
#[pyfunction]
pub fn rigid<'py>(
    py: Python<'py>,
    moved: PyReadonlyArray2<'py, f64>,
    onto: PyReadonlyArray2<'py, f64>,
) -> PyResult<Rigid<'py>> {
    let (moved, onto) = (rows::<3>(&moved)?, rows::<3>(&onto)?);
    let found = compute(py, || etalon_fit::rigid(moved, onto))?.map_err(refused)?;
    let residuals = found.residuals_mm.as_flattened().to_vec().into_pyarray(py);
    Ok((
        matrix(&found.to_T_from).to_vec().into_pyarray(py).reshape([4, 4])?,
        residuals.reshape([moved.len(), 3])?,
        found.centroid_uncertainty_mm,
        found.rotation_uncertainty_rad.to_degrees(),
    ))
}

/// A pose as the rows of a homogeneous matrix.
fn matrix(pose: &etalon_base::pose::Pose) -> [f64; 16] {
    let [x, y, z] = [0, 1, 2].map(|k| pose.axis(k));
    let t = pose.translation_mm;
    let row = |i: usize| [x[i], y[i], z[i], t[i]];
    let mut all = [0.0; 16];
    for (to, from) in all.iter_mut().zip([row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]].as_flattened()) {
        *to = *from;
    }
    all
}

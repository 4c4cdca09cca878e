//! Geometric elements of points, without a copy of the array.

use crate::computing::compute;
use crate::errors::{json, refused};
use etalon::tasks::{self, Criterion, Figure};
use etalon_base::message::{Message, Problems};
use etalon_base::pose::Vector;
use etalon_fit::{CircleMethod, Element, Fit, FitSettings, Side, Source};
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
    let weights = options.weights.as_ref().map(|weights| weights.as_slice()).transpose()?;
    let settings = options.settings(weights).map_err(refused)?;
    let criterion = options.criterion();
    let figure = Figure::Element(element);
    let fitted = compute(py, || tasks::fit(figure, criterion, &Source::from(points), &settings))?;
    let tasks::Fitted { document, fit } = fitted.map_err(refused)?;
    Ok((json(&document)?, fit.map(Fitted)))
}

impl Options<'_> {
    fn criterion(&self) -> Criterion {
        match (self.minimum_zone, self.robust) {
            (true, _) => Criterion::MinimumZone,
            (_, true) => Criterion::Robust,
            _ => Criterion::LeastSquares,
        }
    }

    fn settings<'a>(&self, weights: Option<&'a [f64]>) -> Result<FitSettings<'a>, Problems> {
        let side = match &self.probe_side {
            None => None,
            Some(ProbeSide::Towards(direction)) => Some(Side::Towards(*direction)),
            Some(ProbeSide::Word(word)) => Some(tasks::named_side(word)?),
        };
        let probe = tasks::stated_probe(self.probe_radius_mm, side)?;
        let circle = if self.orthogonal { CircleMethod::Orthogonal } else { CircleMethod::Projected };
        let Self { radius_mm, standard_uncertainty_mm, axis, .. } = *self;
        Ok(FitSettings { weights, radius_mm, axis, circle, probe, standard_uncertainty_mm })
    }
}

/// The smallest circle or sphere that encloses the points: `enclosing-circle`, `enclosing-sphere`.
#[pyfunction]
pub fn enclosing(py: Python<'_>, figure: &str, points: PyReadonlyArray2<f64>) -> PyResult<String> {
    let figure: Figure = figure.parse().map_err(refused)?;
    let points = rows::<3>(&points)?;
    let settings = FitSettings::default();
    let found = compute(py, || tasks::fit(figure, Criterion::LeastSquares, &Source::from(points), &settings))?;
    json(&found.map_err(refused)?.document)
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

//! Residuals between model and measurement, as a least-squares problem in the free parameters.

mod columns;
mod conditions;
mod coordinates;
mod counts;
mod priors;
mod sensitivities;
mod whitening;

use crate::model::elimination::Layout;
use crate::model::kinds::{Condition, Kind, Known, has_length};
use crate::model::prior::Nominal;
use crate::model::rigid_part::{At, Shape};
use crate::model::size::Size;
use crate::model::weights::Weights;
use crate::{Error, Result};
use crate::{Observation, Settings};
use columns::Columns;
use conditions::Conditions;
use coordinates::{CHUNK, Coordinates};
use etalon_base::{error, phrase};
use etalon_math::{Blocks, Problem, Rows};
use etalon_robots::{Loads, Robot};
use nalgebra::DMatrix;
use priors::Priors;
use rayon::prelude::*;
use std::ops::Range;
use std::sync::Arc;
pub(crate) use whitening::{Common, Whitening};

/// Quantity that is compared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ResidualKind {
    /// Coordinates of each target, weighted by the instrument's uncertainty.
    #[default]
    Targets,
    /// x, y and theta of the platform (eq. 3.26): a radian has the weight of a millimetre. Planar
    /// robots only.
    Pose,
}

/// Standard deviation of normal residuals over their median size.
pub const OF_MEDIAN: f64 = 1.4826;

/// Residuals of the observations as a function of the free parameters: rows of coordinates, then of
/// conditions, then of given values.
pub(crate) struct Residuals<'a> {
    pub robot: &'a dyn Robot,
    pub free: Vec<usize>,
    /// All parameters; the free ones are replaced.
    values: Vec<f64>,
    /// Unknowns on which few residuals depend.
    pub layout: Option<Layout>,
    /// Scale (mm) of the residuals.
    pub unit: f64,
    /// Standard deviation of a scaled residual according to the instrument.
    stated_noise: Option<f64>,
    coordinates: Coordinates<'a>,
    /// Whitening of the coordinates.
    pub whitening: Whitening,
    conditions: Conditions<'a>,
    priors: Priors<'a>,
    /// Scaled errors of the rows after the coordinates; empty if none are drawn.
    pub drawn: Vec<f64>,
}

impl<'a> Residuals<'a> {
    pub fn new(
        robot: &'a dyn Robot,
        observations: &'a [Observation],
        settings: &'a Settings,
        free: &[usize],
        values: &[f64],
    ) -> Result<Self> {
        let all = |loads: Loads| observations.par_iter().with_min_len(CHUNK).map(|o| loads(&o.joints)).collect();
        let loads: Vec<Vec<f64>> = robot.loads().map_or_else(Vec::new, all);
        Ok(Self::unloaded(robot, observations, settings, free, values)?.under(loads.into()))
    }

    /// Returns these residuals with other values of the parameters that are not free; nominal
    /// values are unchanged.
    pub fn holding(mut self, values: &[f64]) -> Self {
        self.values = values.to_vec();
        self.conditions.reference_mm = self.size(values).map(|size| size.mm);
        self
    }

    /// Residuals of these observations with another set of free parameters.
    pub fn with_free_parameters(&self, settings: &'a Settings, free: &[usize], values: &[f64]) -> Result<Self> {
        let observations = self.coordinates.observations;
        let loads = self.coordinates.loads.clone();
        Ok(Self::unloaded(self.robot, observations, settings, free, values)?.under(loads))
    }

    /// Returns these residuals with `loads` at each observation.
    fn under(self, loads: Arc<[Vec<f64>]>) -> Self {
        Self { coordinates: Coordinates { loads, ..self.coordinates }, ..self }
    }

    fn unloaded(
        robot: &'a dyn Robot,
        observations: &'a [Observation],
        settings: &'a Settings,
        free: &[usize],
        values: &[f64],
    ) -> Result<Self> {
        if free.is_empty() {
            return Err(error!("nothing-to-identify", cause = "none").hint(phrase!("hold-fewer-parameters")).into());
        }
        let platform = match settings.kind {
            ResidualKind::Targets => None,
            ResidualKind::Pose => {
                Some(robot.platform().ok_or_else(|| Error::NotPlanar { model: robot.model().to_owned() })?)
            }
        };
        let rows = observations.iter().map(|o| {
            let measured = o.targets.iter().flatten().count();
            if platform.is_some() { 3 * usize::from(measured == 2) } else { robot.dimension() * measured }
        });
        let unit = if platform.is_some() { 1.0 } else { settings.standard_uncertainty_mm.unwrap_or(1.0) };
        let layout = Layout::new(robot, free, observations, settings).filter(|_| platform.is_none());
        let is_relative = layout.is_none() && !settings.conditions.is_empty() && !has_length(observations, settings);
        let size = is_relative.then(|| Size::new(robot, &settings.conditions, values)).flatten();
        let weights = Weights::new(observations, robot.dimension(), unit)
            .filter(|_| platform.is_none() && settings.standard_uncertainty_mm.is_some());
        Ok(Self {
            robot,
            free: free.to_vec(),
            values: values.to_vec(),
            layout,
            unit,
            stated_noise: settings.standard_uncertainty_mm.map(|u| u / unit),
            coordinates: Coordinates { robot, observations, loads: Arc::new([]), platform, rows: rows.collect(), unit },
            whitening: Whitening { common: Common::new(observations, settings, robot.dimension()), weights },
            conditions: Conditions { robot, items: &settings.conditions, reference_mm: size.map(|size| size.mm) },
            priors: Priors {
                shapes: match platform {
                    None => settings.rigid.iter().filter_map(|part| Shape::new(robot, part)).collect(),
                    Some(_) => Vec::new(),
                },
                known: &settings.known,
                nominals: Nominal::rows(robot, settings.prior, free, values),
                weight: settings.prior.weight(),
            },
            drawn: Vec::new(),
        })
    }

    /// Standard deviations of the rows after the coordinates: conditions, given shapes, known
    /// points and nominal values.
    pub fn stated(&self) -> Vec<f64> {
        let first = self.coordinate_count();
        let mut stated = vec![1.0; self.residual_count() - first];
        self.shapes().for_each(|(row, shape)| stated[row - first..][..shape.rows()].fill(shape.variance().sqrt()));
        self.nominal_rows().for_each(|row| stated[row - first] = self.priors.weight);
        stated
    }

    /// Number of residuals of measured coordinates; the residuals of conditions follow.
    pub fn coordinate_count(&self) -> usize {
        self.coordinates.count()
    }

    /// Number of residuals of coordinates and conditions; residuals of given shapes and known
    /// points follow.
    pub fn measured_count(&self) -> usize {
        self.coordinate_count() + self.conditions.count()
    }

    /// Rows of measured values: of all coordinates, then of each condition with its kind.
    pub fn measured_rows(&self) -> impl Iterator<Item = (Option<&Kind>, Range<usize>)> {
        let coordinates = (None, self.coordinate_count());
        let conditions = self.conditions.items.iter().map(|c| (Some(&c.kind), c.kind.rows()));
        let mut next = 0;
        std::iter::once(coordinates).chain(conditions).map(move |(kind, count)| {
            next += count;
            (kind, next - count..next)
        })
    }

    /// Factor from scaled residuals to lengths; `None` for angles.
    pub fn sizes(&self) -> impl Iterator<Item = Option<f64>> {
        let size = |c: &Condition| {
            let size = (!c.kind.is_angle()).then_some(c.standard_uncertainty / self.unit);
            std::iter::repeat_n(size, c.kind.rows())
        };
        std::iter::repeat_n(Some(1.0), self.coordinate_count()).chain(self.conditions.items.iter().flat_map(size))
    }

    /// The given shapes, each with its first row.
    pub fn shapes(&self) -> impl Iterator<Item = (usize, &Shape)> {
        self.priors.shapes(self.measured_count())
    }

    /// Knowledge of fixed points, each with its first row.
    pub fn known(&self) -> impl Iterator<Item = (usize, &Known)> {
        self.priors.known(self.measured_count())
    }

    /// All parameters of the robot with the free ones at `x`.
    pub fn all(&self, x: &[f64]) -> Vec<f64> {
        let mut values = self.values.clone();
        for (&i, &x) in self.free.iter().zip(x) {
            values[i] = x;
        }
        values
    }

    /// Size of the robot at `values`, where the observations contain no length.
    pub fn size(&self, values: &[f64]) -> Option<Size> {
        self.conditions.size(values)
    }

    /// `true` if all residuals are coordinates of targets, except the residuals of given values.
    pub fn is_coordinates(&self) -> bool {
        self.coordinates.platform.is_none() && self.conditions.items.is_empty()
    }

    /// The robot with all parameters `values`.
    pub fn at<'v>(&'v self, values: &'v [f64]) -> At<'v> {
        let joints = self.joints().next().unwrap_or_default();
        At { robot: self.robot, values, free: &self.free, joints }
    }

    /// `true` if residuals and Jacobian are whitened, so that an element no longer belongs to one
    /// observation.
    pub fn is_whitened(&self) -> bool {
        self.whitening.common.is_some()
    }

    /// `true` if some readings have their own covariance.
    pub fn is_weighted(&self) -> bool {
        self.whitening.weights.is_some()
    }

    /// Columns of the Jacobian.
    fn columns(&self) -> Columns<'_> {
        Columns { free: &self.free, layout: self.layout.as_ref() }
    }

    /// Number of elements of a row of the Jacobian.
    pub fn width(&self) -> usize {
        self.columns().width()
    }

    /// The Jacobian at `x`, in the layout of [`Problem::jacobian`].
    pub fn jacobian_at(&self, x: &[f64]) -> Vec<f64> {
        let mut jacobian = vec![0.0; self.residual_count() * self.width()];
        self.jacobian(x, &mut jacobian);
        jacobian
    }

    /// The Jacobian at `x` of residuals without a layout.
    pub fn matrix_at(&self, x: &[f64]) -> DMatrix<f64> {
        DMatrix::from_row_slice(self.residual_count(), x.len(), &self.jacobian_at(x))
    }

    /// A Jacobian with its columns.
    pub fn jacobian_rows<'j>(&'j self, jacobian: &'j [f64]) -> Rows<'j> {
        Rows { numbers: jacobian, n: self.free.len(), blocks: Problem::blocks(self) }
    }

    /// First row of the nominal values, which are the last rows.
    pub fn nominal_rows(&self) -> Range<usize> {
        let all = self.residual_count();
        all - self.priors.nominals.len()..all
    }

    /// Variance of a row of a nominal value.
    pub fn nominal_variance(&self) -> f64 {
        self.priors.weight.powi(2)
    }

    /// Makes rows of `width` numbers, divided by the unit, independent and of equal variance.
    pub fn whiten(&self, rows: &mut [f64], width: usize) {
        self.whitening.whiten(rows, width);
    }

    /// Residuals before whitening.
    pub fn plain_residuals(&self, x: &[f64], r: &mut [f64]) {
        let all = self.all(x);
        self.conditions.residuals(&all, &mut r[self.coordinate_count()..]);
        self.coordinates.residuals(&all, r);
    }

    /// Jacobian before whitening.
    pub fn plain_jacobian(&self, x: &[f64], jacobian: &mut [f64]) {
        let (all, first, columns) = (self.all(x), self.coordinate_count(), self.columns());
        self.conditions.jacobian(&all, columns, first, &mut jacobian[first * columns.width()..]);
        self.coordinates.jacobian(&all, columns, jacobian);
    }
}

impl Problem for Residuals<'_> {
    fn residual_count(&self) -> usize {
        self.measured_count() + self.prior_count()
    }

    fn prior_count(&self) -> usize {
        self.priors.count()
    }

    fn residuals(&self, x: &[f64], r: &mut [f64]) {
        self.plain_residuals(x, r);
        self.whiten(r, 1);
        self.priors.residuals(&self.at(&self.all(x)), self.measured_count(), r);
        r[self.coordinate_count()..].iter_mut().zip(&self.drawn).for_each(|(row, error)| *row -= error);
    }

    fn jacobian(&self, x: &[f64], jacobian: &mut [f64]) {
        self.plain_jacobian(x, jacobian);
        self.whiten(jacobian, self.width());
        self.priors.jacobian(&self.at(&self.all(x)), self.columns(), self.measured_count(), jacobian);
    }

    fn blocks(&self) -> Option<&Blocks> {
        self.layout.as_ref().map(|layout| &layout.blocks)
    }
}

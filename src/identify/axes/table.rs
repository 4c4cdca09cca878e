//! Parameters of a robot from sweeps, with their covariance, as prior information of an
//! identification: Denavit-Hartenberg parameters, or small errors of screw axes.

use super::AxesModel;
use etalon_base::angle::Turn;
use etalon_robots::{AxisTable, Effect, Parameter, Quantity, Robot, Role, Serial, TableConvention};
use nalgebra::{DMatrix, SymmetricEigen};

/// Parameters of a robot that the axes determine, and parameters that a convention fixes: base
/// against the first axes, flange of a table against the last.
#[derive(Clone, Debug, PartialEq)]
pub struct DerivedParameters {
    /// Names as in the robot's model.
    pub names: Vec<String>,
    /// Quantity of each parameter.
    pub quantities: Vec<Quantity>,
    /// Values (mm, rad). Hayati's angle is zero in a table: its uncertainty has the measured angle.
    pub values: Vec<f64>,
    /// Covariance in the order of the names (mm, rad).
    pub covariance: DMatrix<f64>,
    /// Parameters that a convention fixes, with their values (mm, rad).
    pub fixed: Vec<(String, Quantity, f64)>,
}

/// Standard uncertainty (mm, rad) below which a convention fixes a parameter.
const FIXED: [f64; 2] = [1e-6, 1e-8];

impl AxesModel {
    /// Parameters of the table in a convention; `None` without joints.
    pub fn table_parameters(&self, convention: TableConvention) -> Option<DerivedParameters> {
        let table = convention.table(&self.axes, &self.flange);
        if table.joints.is_empty() {
            return None;
        }
        let robot = Serial::from_axis_table(convention, &table.joints, &["target".to_owned()]);
        let listed: Vec<usize> =
            (0..robot.parameters().len()).filter(|&i| is_of_axes(&robot.parameters()[i])).collect();
        let values: Vec<f64> = listed.iter().map(|&i| robot.parameters()[i].nominal).collect();
        let mut all = self.covariance_of_table(convention, &table, &listed, &values);
        for tilt in &table.tilts {
            // the link of a row is before its axis in modified convention, otherwise behind it
            let ends = match convention {
                TableConvention::Modified => [tilt.row.wrapping_sub(1), tilt.row],
                TableConvention::Standard => [tilt.row, tilt.row + 1],
            };
            let u = ends.iter().filter_map(|end| self.uncertainties.get(*end)).map(|u| u[0].powi(2)).sum::<f64>();
            let name = format!("beta_{}", tilt.row + 1);
            if let Some(k) = listed.iter().position(|&i| robot.parameters()[i].name == name) {
                all[(k, k)] = u + tilt.angle_rad.powi(2);
            }
        }
        let listed: Vec<&Parameter> = listed.iter().map(|&i| &robot.parameters()[i]).collect();
        Some(DerivedParameters::new(&listed, &values, &all))
    }

    /// Small errors of the screw axes, which are zero in the robot of the sweeps. Axes 1 and 2 are
    /// in the base as its rule places them: their other errors are fixed.
    pub fn screw_parameters(&self) -> DerivedParameters {
        let robot = Serial::from_axes(&self.axes, &self.flange, &["target".to_owned()]);
        let of_joint = |p: &&Parameter| is_of_axes(p);
        // in the order of the joints, as the errors of each axis are
        let listed: Vec<&Parameter> = robot.parameters().iter().filter(of_joint).collect();
        let all = self.covariance_of_axes(&|axes, _| {
            self.axes.iter().zip(axes).flat_map(|(axis, changed)| axis.errors_to(changed)).collect()
        });
        DerivedParameters::new(&listed, &vec![0.0; listed.len()], &all)
    }

    /// Covariance of the parameters `listed` about their values.
    fn covariance_of_table(
        &self,
        convention: TableConvention,
        table: &AxisTable,
        listed: &[usize],
        values: &[f64],
    ) -> DMatrix<f64> {
        self.covariance_of_axes(&|axes, flange| {
            let mut changed = convention.table(axes, flange);
            // a change does not decide what is near-parallel
            changed.joints.iter_mut().zip(&table.joints).for_each(|(row, of)| row.parallel = of.parallel);
            let robot = Serial::from_axis_table(convention, &changed.joints, &["target".to_owned()]);
            let parameters = robot.parameters();
            let difference = |(&i, value): (&usize, &f64)| {
                let changed = parameters[i].nominal;
                // angles about half a turn
                match parameters[i].quantity {
                    Quantity::Angle => Turn::RADIANS.difference(changed, *value),
                    _ => changed - value,
                }
            };
            listed.iter().zip(values).map(difference).collect()
        })
    }
}

/// `true` for zeros and geometry of the arm.
fn is_of_axes(p: &Parameter) -> bool {
    p.role == Role::Robot && matches!(p.effect, Effect::Zeros | Effect::Geometry)
}

impl DerivedParameters {
    /// Parameters with their values and covariance, divided into parameters that the axes determine
    /// and parameters that a convention fixes.
    fn new(listed: &[&Parameter], values: &[f64], all: &DMatrix<f64>) -> Self {
        let least = |k: &usize| FIXED[usize::from(listed[*k].quantity == Quantity::Angle)];
        let (known, fixed): (Vec<usize>, Vec<usize>) =
            (0..listed.len()).partition(|k| all[(*k, *k)] > least(k).powi(2));
        let fixed = fixed.iter().map(|&k| (listed[k].name.clone(), listed[k].quantity, values[k]));
        Self {
            fixed: fixed.collect(),
            names: known.iter().map(|&k| listed[k].name.clone()).collect(),
            quantities: known.iter().map(|&k| listed[k].quantity).collect(),
            values: known.iter().map(|&k| values[k]).collect(),
            covariance: DMatrix::from_fn(known.len(), known.len(), |i, j| all[(known[i], known[j])]),
        }
    }

    /// Standard uncertainties (mm, rad) for parameters without correlations: with them, no
    /// combination of parameters is more certain than by the covariance. Each is the standard
    /// uncertainty of the parameter, times the root of the largest eigenvalue of the correlations.
    pub fn independent_uncertainties(&self) -> Vec<f64> {
        let u: Vec<f64> = (0..self.names.len()).map(|k| self.covariance[(k, k)].sqrt()).collect();
        let n = u.len();
        if n == 0 {
            return u;
        }
        let correlations = DMatrix::from_fn(n, n, |i, j| self.covariance[(i, j)] / (u[i] * u[j]));
        let largest = SymmetricEigen::new(correlations).eigenvalues.iter().copied().fold(1.0, f64::max);
        u.into_iter().map(|u| u * largest.sqrt()).collect()
    }
}

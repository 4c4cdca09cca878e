//! The native part of the Python module `etalon`: arrays and texts in, documents as JSON out. The package in
//! `python/etalon` makes objects of them.

mod campaigns;
mod computing;
mod errors;
mod fit;
mod kinematics;
mod robot;
mod tables;
mod tasks;

use pyo3::prelude::*;

/// Runs the program with the arguments of a command line, the first of which is its name; returns the exit code.
#[pyfunction]
fn main(py: Python<'_>, arguments: Vec<String>) -> u8 {
    py.detach(|| etalon::cli::main(arguments.into_iter().map(Into::into)))
}

#[pymodule]
mod _etalon {
    use pyo3::prelude::*;

    #[pymodule_export]
    use super::campaigns::{batch, check, recommend, residuals, run, uncertainty, validate};
    #[pymodule_export]
    use super::fit::{Fitted, enclosing, fit, rigid};
    #[pymodule_export]
    use super::kinematics::{direct, inverse, jacobian, predict, sensitivity};
    #[pymodule_export]
    use super::main;
    #[pymodule_export]
    use super::robot::{Robot, robot_names};
    #[pymodule_export]
    use super::tables::csv;
    #[pymodule_export]
    use super::tasks::{axes, cell, command, explain, identify, iso230, iso9283, iso9283_path, plan, schema, verify};
    #[pymodule_init]
    fn init(_module: &Bound<'_, PyModule>) -> PyResult<()> {
        super::computing::remember_process();
        Ok(())
    }

    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");
}

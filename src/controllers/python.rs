//! Parameters as a Python module without dependencies; `numpy.array(covariance)` converts its
//! covariance.

use super::template::render;
use super::{About, ExportInput, Exporter};
use etalon_base::message::Result;
use minijinja::context;
use minijinja::value::Serde;

/// Python with dictionaries by parameter name.
pub(super) struct Python;

impl Exporter for Python {
    fn about(&self) -> About<'_> {
        About::laboratory("python", "etalon_parameters.py")
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let document = given.parameters;
        let identified: Vec<String> = document.identified().map(|p| p.name.clone()).collect();
        let (parameters, covariance) = (Serde(&document.parameters), Serde(&document.covariance));
        let values = context! { header => given.header("mm, deg, 1")?, parameters, identified, covariance };
        render(include_str!("templates/python.py.j2"), values).map(String::into_bytes)
    }
}

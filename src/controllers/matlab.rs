//! Parameters as a MATLAB function, which Octave reads too.

use super::template::render;
use super::{About, ExportInput, Exporter};
use etalon_base::message::Result;
use minijinja::context;
use minijinja::value::Serde;

/// Function that returns a struct with a field for each parameter, and the covariance of the
/// identified parameters.
pub(super) struct Matlab;

/// Maximum length of a name in MATLAB (`namelengthmax`).
const LONGEST: usize = 63;

impl Exporter for Matlab {
    fn about(&self) -> About<'_> {
        About::laboratory("matlab", "etalon_parameters.m")
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let document = given.parameters;
        let names = given.names("MATLAB", |p| identifier(&p.name))?;
        let identified: Vec<String> = document.identified().map(|p| format!("'{}'", identifier(&p.name))).collect();
        let (parameters, covariance) = (Serde(&document.parameters), Serde(&document.covariance));
        let values = context! { header => given.header("mm, deg, 1")?, names, parameters, identified, covariance };
        render(include_str!("templates/matlab.m.j2"), values).map(String::into_bytes)
    }
}

/// Letters, digits and underscores, starting with a letter.
fn identifier(name: &str) -> String {
    let safe = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let mut all: String = name.chars().map(safe).collect();
    if !all.starts_with(|c: char| c.is_ascii_alphabetic()) {
        all.insert_str(0, "p_");
    }
    all.truncate(LONGEST);
    all
}

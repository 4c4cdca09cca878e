//! Parameters as a C header (C99 and C++), for compiled controllers.

use super::template::{identifier, render};
use super::{About, ExportInput, Exporter};
use etalon_base::message::Result;
use minijinja::context;
use minijinja::value::Serde;

/// C header with one macro per parameter; angles are in degrees and in radians.
pub(super) struct CHeader;

impl Exporter for CHeader {
    fn about(&self) -> About<'_> {
        About::laboratory("c-header", "etalon_parameters.h")
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let document = given.parameters;
        let robot = identifier(&document.robot);
        given.names("C", |p| {
            let unit = if p.unit == "1" { "RATIO".to_owned() } else { identifier(&p.unit) };
            format!("ETALON_{robot}_{}_{unit}", identifier(&p.name))
        })?;
        let header = given.header("mm, deg and rad, 1; u is the standard uncertainty (k = 1)")?;
        let values = context! { header, robot, parameters => Serde(&document.parameters) };
        render(include_str!("templates/c_header.h.j2"), values).map(String::into_bytes)
    }
}

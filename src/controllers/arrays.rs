//! Parameters as arrays: NumPy's `.npz`, and MATLAB's `.mat` (level 5, uncompressed), which Octave
//! and SciPy read too.
//!
//! Both formats contain `about` (the header lines of a file), `name`, `unit`, `value` and `nominal`
//! of all parameters, `standard_uncertainty` of the parameters whose indices are in `identified`,
//! and `covariance` of the parameters in `covariance_of`. Indices start at 0 in NumPy and at 1 in
//! MATLAB.

use super::{About, ExportInput, Exporter};
use etalon_base::error;
use etalon_base::message::Result;
use etalon_formats::arrays::{Content, NewArray};
use etalon_formats::{matlab, numpy};

/// NumPy's `.npz`, an archive of `.npy`.
pub(super) struct Npz;

/// MATLAB's `.mat` of level 5.
pub(super) struct Mat;

/// Arrays of the parameters, whose indices start at `first`.
fn arrays(given: &ExportInput, first: u64) -> Result<Vec<NewArray>> {
    let document = given.parameters;
    let all = &document.parameters;
    let places = |wanted: &dyn Fn(&str) -> bool| {
        Content::Counts((first..).zip(all).filter(|(_, p)| wanted(&p.name)).map(|(i, _)| i).collect())
    };
    let in_covariance: Vec<&str> = match document.covariance.as_slice() {
        [] => Vec::new(),
        _ => document.identified().map(|p| p.name.as_str()).collect(),
    };
    let identified: Vec<&str> =
        all.iter().filter(|p| p.standard_uncertainty.is_some()).map(|p| p.name.as_str()).collect();
    let array = |name, content| NewArray { name, content };
    Ok(vec![
        array("about", Content::Texts(given.header("mm, deg, 1")?)),
        array("name", Content::Texts(all.iter().map(|p| p.name.clone()).collect())),
        array("unit", Content::Texts(all.iter().map(|p| p.unit.clone()).collect())),
        array("value", Content::Numbers(all.iter().map(|p| p.value).collect())),
        array("nominal", Content::Numbers(all.iter().map(|p| p.nominal).collect())),
        array("identified", places(&|name| identified.contains(&name))),
        array("standard_uncertainty", Content::Numbers(all.iter().filter_map(|p| p.standard_uncertainty).collect())),
        array("covariance_of", places(&|name| in_covariance.contains(&name))),
        array("covariance", Content::Matrix(document.covariance.clone())),
    ])
}

impl Exporter for Npz {
    fn about(&self) -> About<'_> {
        About::laboratory("numpy", "etalon_parameters.npz")
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let bytes = numpy::write(&arrays(given, 0)?);
        bytes.map_err(|e| error!("cannot-encode", format = "NPZ", reason = e.to_string()).into())
    }
}

impl Exporter for Mat {
    fn about(&self) -> About<'_> {
        About::laboratory("mat", "etalon_parameters.mat")
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let version = super::comment(&given.parameters.provenance.version);
        Ok(matlab::write(&format!("written by etalon {version}"), &arrays(given, 1)?))
    }
}

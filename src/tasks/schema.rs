//! JSON Schemas of input files and documents.

use etalon_base::error;
use etalon_base::message::{Problems, Result};

/// Returns the JSON Schema of an input file or of a document.
///
/// # Errors
/// Fails if no input file and no document has this name.
pub fn schema(name: &str) -> Result<&'static str> {
    let all = [etalon_campaign::SCHEMAS, crate::simulate::SCHEMAS, etalon_documents::schema::SCHEMAS].concat();
    let found = all.iter().find(|(known, _)| *known == name).ok_or_else(|| {
        Problems::from(error!("schema-unknown", name).hint_names(name, all.iter().map(|(known, _)| *known)))
    })?;
    Ok(found.1)
}

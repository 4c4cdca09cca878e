//! Residual field as code: C99, Python and Structured Text. Each has a table of centres and
//! weights, and a function that corrects joint values in place (mm, deg) and returns the share of
//! the field: 1 where poses were measured, 0 beyond.

use super::statement::not_to_be_loaded;
use super::template::render;
use etalon_base::catalogue::Phrase;
use etalon_base::message::Result;
use etalon_documents::{FieldDocument, FieldParameter};
use minijinja::context;
use minijinja::value::Serde;
use serde::Serialize;

/// Names and templates of the files.
const FILES: [(&str, &str); 3] = [
    ("etalon_field.c", include_str!("templates/field.c.j2")),
    ("etalon_field.py", include_str!("templates/field.py.j2")),
    ("etalon_field.st", include_str!("templates/field.st.j2")),
];

/// A centre of a component; a component of one joint has the second input with scale 0.
#[derive(Serialize)]
struct Centre {
    joint: usize,
    inputs: [usize; 2],
    at: [f64; 2],
    /// 1 / (scale · radius), 0 for a missing input.
    inverse: [f64; 2],
    weight: f64,
}

/// Range of an input.
#[derive(Serialize)]
struct Range {
    joint: usize,
    lower: f64,
    upper: f64,
    fade: f64,
}

/// Files of code for a field, with the reason for loading nothing of the run.
///
/// # Errors
///
/// Fails if a template is invalid.
pub fn field_code(field: &FieldDocument, withheld: Option<&Phrase>) -> Result<Vec<(&'static str, Vec<u8>)>> {
    let index = |name: &String| field.joints.iter().position(|joint| joint == name).unwrap_or_default();
    let (mut centres, mut ranges) = (Vec::new(), Vec::new());
    for component in &field.components {
        for centre in &component.centres {
            let mut entry = Centre {
                joint: index(&component.joint),
                inputs: [0; 2],
                at: [0.0; 2],
                inverse: [0.0; 2],
                weight: centre.weight,
            };
            for (k, (input, at)) in component.inputs.iter().zip(&centre.at).enumerate().take(2) {
                entry.inputs[k] = index(&input.joint);
                (entry.at[k], entry.inverse[k]) = (*at, 1.0 / (input.scale * component.radius));
            }
            centres.push(entry);
        }
        ranges.extend(component.inputs.iter().map(|input| Range {
            joint: index(&input.joint),
            lower: input.range[0],
            upper: input.range[1],
            fade: input.fade,
        }));
    }
    let moved: Vec<&FieldParameter> = field.parameters.iter().filter(|p| p.shift != 0.0).collect();
    let render = |(name, template): (&'static str, &str)| {
        let values = context! {
            version => field.provenance.version.as_str(),
            withheld => withheld.map(not_to_be_loaded),
            synthetic => field.synthetic.as_deref().map(crate::synthetic_notice),
            sha256 => field.parameters_sha256.as_str(),
            joints => Serde(&field.joints),
            parameters => Serde(&moved),
            centres => Serde(&centres),
            ranges => Serde(&ranges),
        };
        Ok((name, render(template, values)?.into_bytes()))
    };
    FILES.into_iter().map(render).collect()
}

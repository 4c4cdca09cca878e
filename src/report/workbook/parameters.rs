//! Parameters with their uncertainties, covariances and correlations.

use super::sheet::{Cell, Sheet};
use crate::document::{ObservabilitySummary, ParameterEntry, ParameterStatus, ParametersDocument, SingularValueEntry};
use crate::report::parameters::status;
use crate::report::words::Words;

pub(super) fn sheets(document: &ParametersDocument) -> [Sheet; 4] {
    [
        parameters(document),
        matrix("Covariance", document, |c, i, j| c[i][j]),
        matrix("Correlation", document, correlation),
        singular_values(document.observability.as_ref()),
    ]
}

fn parameters(document: &ParametersDocument) -> Sheet {
    Sheet::of(
        "Parameters",
        &document.parameters,
        &[
            ("name", "", |p| p.name.as_str().into()),
            ("unit", "", |p| p.unit.as_str().into()),
            ("nominal", "", |p| p.nominal.into()),
            ("before", "", |p| p.before.into()),
            ("identified", "", |p| p.value.into()),
            ("change", "", |p| (p.value - p.nominal).into()),
            ("u (k = 1)", "", |p| p.standard_uncertainty.into()),
            ("U = 2u", "", |p| p.standard_uncertainty.map(|u| 2.0 * u).into()),
            ("status", "", |p| status(p.status, &Words::default()).into()),
            ("confounded with", "", |p| p.confounded_with.join(", ").into()),
        ],
    )
}

/// Singular values in their order, those of what is held behind; no columns where the document has none.
fn singular_values(observability: Option<&ObservabilitySummary>) -> Sheet {
    let Some(o) = observability.filter(|o| !o.singular_values.is_empty()) else {
        return Sheet { name: "Singular values", columns: vec![], rows: vec![] };
    };
    let told = o.singular_values.iter().map(|s| (s, "identified"));
    let rows: Vec<(usize, (&SingularValueEntry, &str))> =
        (1..).zip(told.chain(o.held_singular_values.iter().map(|s| (s, "held")))).collect();
    Sheet::of(
        "Singular values",
        &rows,
        &[
            ("number", "", |(i, _)| (*i).into()),
            ("singular value (columns divided by their norms)", "", |(_, (s, _))| s.value.into()),
            ("direction", "", |(_, (_, what))| (*what).into()),
            ("parameters", "", |(_, (s, _))| s.parameters.join(", ").into()),
        ],
    )
}

/// A matrix of the identified parameters, with their names on two sides; no columns where there is none.
fn matrix(name: &'static str, document: &ParametersDocument, entry: fn(&[Vec<f64>], usize, usize) -> f64) -> Sheet {
    let covariance = &document.covariance;
    let identified: Vec<&ParameterEntry> =
        document.parameters.iter().filter(|p| p.status == ParameterStatus::Identified).collect();
    let size = identified.len();
    let fits = size > 0 && covariance.len() == size && covariance.iter().all(|row| row.len() == size);
    if !fits {
        return Sheet { name, columns: vec![], rows: vec![] };
    }
    let columns = ["name", "unit"].into_iter().chain(identified.iter().map(|p| p.name.as_str()));
    let row = |(i, p): (usize, &&ParameterEntry)| {
        let names: [Cell; 2] = [p.name.as_str().into(), p.unit.as_str().into()];
        names.into_iter().chain((0..size).map(|j| entry(covariance, i, j).into())).collect()
    };
    Sheet {
        name,
        columns: columns.map(|title| (title.to_owned(), String::new())).collect(),
        rows: identified.iter().enumerate().map(row).collect(),
    }
}

fn correlation(covariance: &[Vec<f64>], i: usize, j: usize) -> f64 {
    covariance[i][j] / (covariance[i][i] * covariance[j][j]).sqrt()
}

//! Parameters: each number with the digits that its uncertainty allows, covariances and correlations.

use crate::document::{ParameterEntry, ParameterStatus, ParametersDocument};
use crate::report::Report;
use crate::report::model::{Block, Cell, Columns, Section, Table, Text, shown, significant, term, with_uncertainty};
use crate::report::number;
use crate::report::plots::{correlation, intervals};
use crate::report::words::Words;

pub(super) fn section(report: &Report, words: &Words) -> Option<Section> {
    Some(of(report.identified?.parameters, words))
}

/// The section of these parameters.
pub(in crate::report) fn of(document: &ParametersDocument, words: &Words) -> Section {
    let mut section = Section::new("parameters", words.say("Parameters"));
    let note = words.say("u is the standard uncertainty (k = 1), U = 2u the expanded one; numbers are shown to the second digit of u. “Before” is with only base and targets fitted. The change is from nominal to identified.");
    section.push(Block::note(note));
    section.push(Block::Table(table(&document.parameters, words)));
    section.push(Block::Table(matrix("Covariance", document, words, |c, i, j| c[i][j])));
    let correlated = |c: &[Vec<f64>], i: usize, j: usize| c[i][j] / (c[i][i] * c[j][j]).sqrt();
    section.push(Block::Table(matrix("Correlation", document, words, correlated)));
    let mut figures = intervals::pictures(&document.parameters, words);
    figures.extend(correlation::picture(document, words));
    section.figures(figures);
    section
}

fn table(parameters: &[ParameterEntry], words: &Words) -> Table {
    let change = |p: &ParameterEntry| {
        let sign = if p.value > p.nominal { "+" } else { "" };
        shown(p.value - p.nominal, |v| sign.to_owned() + &number::with_uncertainty(v, p.standard_uncertainty))
    };
    let columns = Columns::<ParameterEntry>::new()
        .both("name", "", |p| p.name.as_str())
        .both("unit", "", |p| p.unit.as_str())
        .both("nominal", "", |p| with_uncertainty(p.nominal, p.standard_uncertainty))
        .both("before", "", |p| with_uncertainty(p.before, p.standard_uncertainty))
        .both("identified", "", |p| with_uncertainty(p.value, p.standard_uncertainty))
        .both("change", "", change)
        .both("u (k = 1)", "", |p| significant(p.standard_uncertainty, 2))
        .both("U = 2u", "", |p| significant(p.standard_uncertainty.map(|u| 2.0 * u), 2))
        .both("status", "", |p| status(p.status, words))
        .both("confounded with", "", |p| Text::name(&p.confounded_with.join(", ")));
    let table = Table::of(words, parameters, columns).on("Parameters");
    let confounded = parameters.iter().any(|p| !p.confounded_with.is_empty());
    if confounded || parameters.is_empty() { table } else { table.without_empty_columns() }
}

/// Why a parameter has its value, in words.
fn status(status: ParameterStatus, words: &Words) -> Cell {
    match status {
        ParameterStatus::Identified => term(words, "identified"),
        ParameterStatus::Fixed => term(words, "held by the campaign"),
        ParameterStatus::NotIdentifiable => term(words, "held: not separately identifiable"),
    }
}

/// A matrix of the identified parameters, with their names on two sides; no columns where there is none.
fn matrix(
    name: &'static str,
    document: &ParametersDocument,
    words: &Words,
    entry: fn(&[Vec<f64>], usize, usize) -> f64,
) -> Table {
    let covariance = &document.covariance;
    let identified: Vec<(usize, &ParameterEntry)> = document.identified().enumerate().collect();
    let size = identified.len();
    let fits = size > 0 && covariance.len() == size && covariance.iter().all(|row| row.len() == size);
    if !fits {
        return Table::default();
    }
    let named = Columns::<(usize, &ParameterEntry)>::new().sheet("name", "", |(_, p)| p.name.as_str()).sheet(
        "unit",
        "",
        |(_, p)| p.unit.as_str(),
    );
    let columns = identified
        .iter()
        .fold(named, |columns, (j, p)| columns.sheet(&p.name, "", move |(i, _)| entry(covariance, *i, *j)));
    Table::of(words, &identified, columns).on(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_follow_the_uncertainty() {
        let mut p = ParameterEntry {
            name: "d".into(),
            unit: "mm".into(),
            nominal: 300.0,
            before: 300.0,
            value: 299.123_456_789,
            standard_uncertainty: Some(0.001_49),
            degrees_of_freedom: None,
            status: ParameterStatus::Identified,
            confounded_with: vec![],
        };
        let row = |p: &ParameterEntry| {
            let table = table(std::slice::from_ref(p), &Words::default());
            table.rows[0].iter().map(Cell::plain).collect::<Vec<_>>()
        };
        assert_eq!(row(&p)[4..], ["299.1235", "-0.8765", "0.0015", "0.0030", "identified"]);
        (p.standard_uncertainty, p.status) = (None, ParameterStatus::NotIdentifiable);
        assert_eq!(row(&p)[4..], ["299.1235", "-0.8765", "held: not separately identifiable"]);
    }
}

//! What a delimited text could be: a proposal with its reasons and its questions, to paste into a campaign.

use super::delimited::{number, rows};
use crate::campaign::{Decimal, Delimiter};
use crate::document::{FormatsDocument, Reading};
use std::fmt::Write;

/// How a file could be read.
struct Guess {
    delimiter: Delimiter,
    decimal: Decimal,
    header: usize,
    columns: usize,
    /// share of data rows that this reading explains
    share: f64,
    /// per column: share of numbers
    numeric: Vec<bool>,
}

/// Proposes readings of a delimited text, the first also as `[[export]]` lines. What the file cannot say is asked.
pub fn propose(file: &str, text: &str) -> FormatsDocument {
    let mut guesses: Vec<Guess> = [Delimiter::Tab, Delimiter::Semicolon, Delimiter::Comma, Delimiter::Blank]
        .into_iter()
        .flat_map(|delimiter| [Decimal::Point, Decimal::Comma].map(|decimal| guess(file, text, delimiter, decimal)))
        .flatten()
        .collect();
    guesses.sort_by(|a, b| b.share.total_cmp(&a.share));
    let best = guesses.first().map_or(0.0, |g| g.share);
    guesses.retain(|g| g.share > 0.99 * best);
    FormatsDocument {
        schema: "etalon/formats/1".to_owned(),
        file: file.to_owned(),
        readings: guesses.iter().map(reading).collect(),
        toml: to_toml(file, &guesses),
    }
}

fn reading(guess: &Guess) -> Reading {
    Reading {
        delimiter: guess.delimiter.name().to_owned(),
        decimal: guess.decimal.name().to_owned(),
        header: guess.header,
        columns: roles(guess).into_iter().map(str::to_owned).collect(),
        share: guess.share,
    }
}

/// The best reading as TOML, with comments on the others.
fn to_toml(file: &str, guesses: &[Guess]) -> String {
    let mut out = String::new();
    let Some(best) = guesses.first() else {
        return format!("# `{file}`: no reading as delimited text gives rows with two or more numbers\n");
    };
    let _ = writeln!(
        out,
        "# proposed for `{file}`: {:.0} % of its rows read this way, {} columns",
        100.0 * best.share,
        best.columns
    );
    if guesses.len() > 1 {
        let _ = writeln!(out, "# DOUBT: {} other readings explain it as well; check a row by eye:", guesses.len() - 1);
        for g in guesses.iter().skip(1) {
            let _ = writeln!(
                out,
                "#   delimiter \"{}\", decimal \"{}\", {} columns",
                g.delimiter.name(),
                g.decimal.name(),
                g.columns
            );
        }
    }
    let _ = writeln!(out, "[[export]]\nfile = {file:?}");
    let _ = writeln!(
        out,
        "format = {{ delimiter = {:?}, decimal = {:?}, header = {}, columns = [{}] }}",
        best.delimiter.name(),
        best.decimal.name(),
        best.header,
        roles(best).iter().map(|role| format!("{role:?}")).collect::<Vec<_>>().join(", ")
    );
    out.push_str("# the file cannot say these; they are never guessed:\n");
    out.push_str("unit = \"?\"                 # mm, m, um or inch\n");
    out.push_str("# are the columns x, y, z in this order, and Cartesian?\n");
    if best.numeric.first() == Some(&false) {
        out.push_str("label = \"{target}_{pose}_{cycle}\"   # how a label names target, pose and repeat, if it does\n");
    } else {
        out.push_str("target = \"?\"               # which target the rows are of\npose = \"row\"               # if the number of the row is the number of the pose\n");
    }
    out
}

fn guess(file: &str, text: &str, delimiter: Delimiter, decimal: Decimal) -> Option<Guess> {
    let all = rows(file, text, delimiter, None).ok()?;
    let is_number = |field: &String| number(field, decimal).is_ok();
    let numbers = |fields: &[String]| fields.iter().filter(|f| is_number(f)).count();
    let header = all.iter().position(|r| numbers(&r.fields) >= 2)?;
    let data = &all[header..];
    let columns = data.first()?.fields.len();
    let good: Vec<_> = data.iter().filter(|r| r.fields.len() == columns && numbers(&r.fields) >= 2).collect();
    let used: usize = good.iter().map(|r| numbers(&r.fields)).sum();
    // a reading that splits decimal numbers in two has whole numbers everywhere: prefer more digits per field
    let fractions = good.iter().flat_map(|r| &r.fields).filter(|f| is_number(f) && f.contains([',', '.'])).count();
    let share = good.len() as f64 / data.len() as f64 * (0.5 + 0.5 * fractions as f64 / used.max(1) as f64);
    let numeric = (0..columns).map(|c| good.iter().all(|r| is_number(&r.fields[c]))).collect();
    (!good.is_empty()).then_some(Guess { delimiter, decimal, header, columns, share, numeric })
}

/// Roles by position: a leading text is the label, the first numbers after it x, y, z.
fn roles(guess: &Guess) -> Vec<&'static str> {
    let mut axes = ["x", "y", "z"].into_iter();
    let mut labelled = false;
    guess
        .numeric
        .iter()
        .map(|numeric| match numeric {
            true => axes.next().unwrap_or("-"),
            false if !std::mem::replace(&mut labelled, true) => "label",
            false => "-",
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn delimiter_and_decimal_are_proposed_and_the_unit_is_asked() {
        let text = propose("p.txt", "Name;X;Y;Z\nA;1,25;2,5;-3,75\nB;4,125;5,5;6,25\n").toml;
        assert!(
            text.contains("delimiter = \";\", decimal = \",\", header = 1, columns = [\"label\", \"x\", \"y\", \"z\"]"),
            "{text}"
        );
        assert!(text.contains("unit = \"?\""));
        let text = propose("p.txt", "1.25 2.5 3.5\n4.5 5.5 6.5\n").toml;
        assert!(
            text.contains("delimiter = \"blank\", decimal = \".\", header = 0, columns = [\"x\", \"y\", \"z\"]"),
            "{text}"
        );
    }

    #[test]
    fn comma_and_comma_is_a_doubt() {
        let text = propose("p.txt", "1,25\t2,50\t3,75\n").toml;
        assert!(text.contains("decimal = \",\""), "{text}");
        assert!(propose("p.txt", "no numbers here\n").toml.contains("no reading"));
    }
}

//! Limits of the campaign, what was reached, and whether they are met.

use crate::document::{Characteristics, LimitVerdict};
use crate::report::model::{Cell, Columns, Section, Table, strong_term, term};
use crate::report::number;
use crate::report::words::Words;
use crate::report::{Identified, Report};

pub(super) fn section(report: &Report, words: &Words) -> Option<Section> {
    let columns = Columns::<LimitVerdict>::new()
        .both("limit", "", |l| l.name.as_str())
        .both("allowed", "", |l| Cell::Number { value: l.limit, shown: l.limit.to_string() })
        .both("reached", "", |l| Cell::Number { value: l.value, shown: reached(l) })
        .both("unit", "", |l| l.unit.as_str())
        .both("verdict", "", |l| if l.met { term(words, "met") } else { strong_term(words, "not met") });
    let mut section = Section::new("limits", words.say("Limits"));
    section.table("", "", Table::of(words, limits(report.identified.as_ref(), report.tested), columns).on("Limits"));
    section.on_terminal().whole()
}

/// Every limit that the campaign states, judged.
pub(super) fn limits<'a>(identified: Option<&'a Identified>, tested: &'a Characteristics) -> Vec<&'a LimitVerdict> {
    identified.iter().flat_map(|i| &i.accuracy.limits).chain(tested.limits()).collect()
}

/// The value with the digits that decide, also where it is close to the limit.
fn reached(l: &LimitVerdict) -> String {
    let decisive = number::decimals((l.limit - l.value).abs(), 2).unwrap_or(0);
    number::fixed(l.value, decisive.max(number::decimals(l.limit, 3).unwrap_or(4)).min(9))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_just_over_its_limit_does_not_look_equal_to_it() {
        let close = LimitVerdict { name: "p".into(), unit: "mm".into(), limit: 0.05, value: 0.050_000_4, met: false };
        assert_eq!(reached(&close), "0.05000040");
    }
}

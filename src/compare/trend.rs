//! Quantities over campaigns, of any kind.

use super::significance::{Difference, Estimate, LEVEL, holm, step_down};
use etalon_base::catalogue::{IntoArgument, Phrase};
use etalon_base::phrase;
use etalon_documents::{CompareChange, CompareFamily, CompareTrend, CompareValue};
use nalgebra::DMatrix;
use std::collections::BTreeMap;

/// Compared pairs of campaigns, from 0: each with the first and with the previous one.
pub(super) fn pairs(count: usize) -> Vec<[usize; 2]> {
    let with_first = (1..count).map(|to| [0, to]);
    let mut all: Vec<[usize; 2]> = with_first.chain((2..count).map(|to| [to - 1, to])).collect();
    all.sort_unstable_by_key(|&[from, to]| [to, from]);
    all
}

/// Name of a quantity.
pub(super) enum TrendName {
    /// Name of a parameter.
    Parameter(String),
    /// Quantity in words.
    Words(Phrase),
}

impl TrendName {
    /// Characteristic at a pose or along a path.
    pub fn at(quantity: impl IntoArgument, place: &impl IntoArgument) -> Self {
        Self::Words(phrase!("quantity-at", quantity, place))
    }

    /// Document form of the quantity.
    pub fn trend(
        self,
        family: CompareFamily,
        unit: &str,
        values: Vec<CompareValue>,
        changes: Vec<CompareChange>,
    ) -> CompareTrend {
        let name = match self {
            Self::Parameter(name) => name.into(),
            Self::Words(phrase) => phrase.into(),
        };
        CompareTrend { family, name, unit: unit.to_owned(), values, changes }
    }
}

/// A quantity with standard uncertainties.
pub(super) fn trend_from_estimates(
    family: CompareFamily,
    name: TrendName,
    unit: &str,
    estimates: &[Option<Estimate>],
) -> CompareTrend {
    let value = |e: &Option<Estimate>| e.as_ref().map(estimated).unwrap_or_default();
    let change = |[from, to]: [usize; 2]| {
        let found = estimates[from]?.change_to(estimates[to].as_ref()?);
        Some(changed([from, to], &found, None))
    };
    let values = estimates.iter().map(value).collect();
    let changes = pairs(estimates.len()).into_iter().filter_map(change).collect();
    name.trend(family, unit, values, changes)
}

fn estimated(e: &Estimate) -> CompareValue {
    let (low, high) = e.interval();
    let known = |v: f64| Some(v).filter(|v| v.is_finite());
    CompareValue {
        value: Some(e.value),
        standard_uncertainty: known(e.standard_uncertainty),
        low: known(low),
        high: known(high),
    }
}

/// Document form of a change before it is judged; `difference` is given if `found` is a ratio.
pub(super) fn changed([from, to]: [usize; 2], found: &Difference, difference: Option<f64>) -> CompareChange {
    let known = |v: f64| Some(v).filter(|v| v.is_finite());
    CompareChange {
        from: from + 1,
        to: to + 1,
        change: difference.unwrap_or(found.change),
        ratio: difference.map(|_| found.change),
        low: known(found.low),
        high: known(found.high),
        p: known(found.p),
        p_family: None,
        significant: None,
    }
}

/// A change with the name of its quantity.
type Named<'a> = (&'a str, &'a mut CompareChange);

/// Judges the significance of changes, for each family and each pair of campaigns separately.
/// `correlation` returns the correlation of the changes of the named quantities between two
/// campaigns, if known.
pub(super) fn judge(trends: &mut [CompareTrend], correlation: impl Fn(&[&str], [usize; 2]) -> Option<DMatrix<f64>>) {
    let mut families: BTreeMap<(CompareFamily, usize, usize), Vec<Named>> = BTreeMap::new();
    for CompareTrend { family, name, changes, .. } in trends {
        for change in changes.iter_mut().filter(|c| c.p.is_some()) {
            families.entry((*family, change.from, change.to)).or_default().push((name.english(), change));
        }
    }
    for ((family, from, to), changes) in families {
        let (names, changes): (Vec<&str>, Vec<&mut CompareChange>) = changes.into_iter().unzip();
        let p: Vec<f64> = changes.iter().filter_map(|c| c.p).collect();
        let parameters = matches!(family, CompareFamily::Robot | CompareFamily::SetUp);
        let known = parameters.then(|| correlation(&names, [from - 1, to - 1])).flatten();
        let corrected = known.and_then(|known| step_down(&p, known)).unwrap_or_else(|| holm(&p));
        for (change, corrected) in changes.into_iter().zip(corrected) {
            change.p_family = Some(corrected);
            change.significant = Some(corrected < LEVEL);
        }
    }
}

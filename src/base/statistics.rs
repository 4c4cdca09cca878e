//! Order statistics that several rooms use.

/// The two middle values in order, one and the same of an odd number of values; `None` of none.
pub fn middle_pair(values: impl IntoIterator<Item = f64>) -> Option<[f64; 2]> {
    let mut values: Vec<f64> = values.into_iter().collect();
    values.sort_by(f64::total_cmp);
    Some([*values.get(values.len().saturating_sub(1) / 2)?, *values.get(values.len() / 2)?])
}

/// The median, which is one of the values: of an even number the larger of the middle pair.
pub fn median(values: impl IntoIterator<Item = f64>) -> Option<f64> {
    middle_pair(values).map(|[_, upper]| upper)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians_by_hand() {
        assert_eq!((middle_pair([]), median([])), (None, None));
        assert_eq!((middle_pair([3.0]), median([3.0, 1.0, 2.0])), (Some([3.0, 3.0]), Some(2.0)));
        assert_eq!((middle_pair([4.0, 1.0, 3.0, 2.0]), median([4.0, 1.0, 3.0, 2.0])), (Some([2.0, 3.0]), Some(3.0)));
    }
}

//! Patterns of names.

/// `true` if `name` matches `pattern`, in which a single `*` stands for any text.
pub fn matches_pattern(pattern: &str, name: &str) -> bool {
    match pattern.split_once('*') {
        Some((head, tail)) => name.len() >= head.len() + tail.len() && name.starts_with(head) && name.ends_with(tail),
        None => pattern == name,
    }
}

#[cfg(test)]
mod tests {
    use super::matches_pattern;

    #[test]
    fn patterns() {
        assert!(matches_pattern("gain_*", "gain_3") && matches_pattern("d", "d") && matches_pattern("*_x", "SMR_1_x"));
        assert!(
            !matches_pattern("gain_*", "again_3") && !matches_pattern("d", "d3") && !matches_pattern("ab*ba", "aba")
        );
    }
}

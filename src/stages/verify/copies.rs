//! Readings of a verification that are the readings of the calibration: exports or logs that were
//! not replaced.

use etalon_formats::table::{LABEL, TIME, Table, UNCERTAINTIES, Values};

/// Difference of two numbers of which one was rounded to six decimals.
const ROUNDED: f64 = 1e-6;
/// Minimum share of copies. Few readings may agree by chance: coarse values at programmed joint
/// values.
const LEAST_SHARE: f64 = 0.5;

/// Columns that name or describe a reading.
const NOT_MEASURED: [&str; 8] = ["pose", "cycle", "line", "u_mm", "urot_deg", "assembly", LABEL, TIME];

/// Number of rows of `table` whose numbers, joint values and measured ones, are all equal to the
/// numbers of a row of `calibration` with the same target; zero if they are fewer than half of the
/// rows.
pub fn copies(table: &Table, calibration: &Table) -> usize {
    let is_number = |values: &Values| matches!(values, Values::Numbers(_) | Values::Whole(_));
    let shared = table.names().filter(|name| !NOT_MEASURED.contains(name) && !UNCERTAINTIES.contains(name));
    let shared = shared.filter_map(|name| Some([table.values(name)?, calibration.values(name)?]));
    let shared: Vec<[&Values; 2]> = shared.filter(|both| both.iter().all(|values| is_number(values))).collect();
    let of_row = |which: usize, row: usize| -> Vec<f64> { shared.iter().map(|both| both[which].number(row)).collect() };
    let target = |table: &Table, row: usize| table.text(row, "target").unwrap_or_default().to_owned();
    let mut earlier: Vec<(String, Vec<f64>)> =
        (0..calibration.height()).map(|row| (target(calibration, row), of_row(1, row))).collect();
    let first = |numbers: &[f64]| numbers.iter().copied().find(|v| !v.is_nan());
    earlier.retain(|(_, numbers)| first(numbers).is_some());
    let order = |name: &str, numbers: &[f64]| (name.to_owned(), first(numbers).unwrap_or(f64::INFINITY));
    let before = |a: &(String, f64), b: &(String, f64)| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1));
    earlier.sort_by(|a, b| before(&order(&a.0, &a.1), &order(&b.0, &b.1)));
    let near = |a: &f64, b: &f64| (a - b).abs() <= ROUNDED || a.is_nan() && b.is_nan();
    let is_copy = |row: &usize| {
        let (name, numbers) = (target(table, *row), of_row(0, *row));
        let Some(least) = first(&numbers).map(|v| v - ROUNDED) else { return false };
        let start = earlier.partition_point(|e| before(&order(&e.0, &e.1), &(name.clone(), least)).is_lt());
        let mut candidates = earlier[start..].iter().take_while(|(other, numbers)| {
            *other == name && first(numbers).is_some_and(|v| v <= least + 2.0 * ROUNDED)
        });
        candidates.any(|(_, other)| numbers.iter().zip(other).all(|(a, b)| near(a, b)))
    };
    let count = (0..table.height()).filter(is_copy).count();
    if count as f64 >= LEAST_SHARE * table.height() as f64 { count } else { 0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(rows: &str) -> Table {
        etalon_formats::observations("t.csv", &format!("pose,target,q1_deg,x_mm,y_mm,u_mm\n{rows}")).expect("a table")
    }

    #[test]
    fn copies_are_counted_whatever_their_pose_and_rounding() {
        let earlier = table("1,A,10.5,100.123456,20,\n2,A,11,101,21,\n2,B,11,201,22,\n");
        let renamed = table("7,A,10.5,100.1234561,20,0.01\n8,B,11,201,22,0.01\n");
        assert_eq!(copies(&renamed, &earlier), 2);
        // measured anew at the same joint values, and of another target
        let anew = table("1,A,10.5,100.124456,20.001,\n2,B,11,101,21,\n");
        assert_eq!(copies(&anew, &earlier), 0);
        // one of three agrees by chance
        let one = table("1,A,10.5,100.123456,20,\n2,A,11,101.001,21,\n2,B,11,201.001,22,\n");
        assert_eq!(copies(&one, &earlier), 0);
    }
}

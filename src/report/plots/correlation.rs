//! Correlations of all pairs of identified parameters; strongly correlated parameters are hardly
//! separable.

use super::intervals::shortened;
use super::layer::*;
use etalon_documents::ParametersDocument;

/// Number of parameters above which the figure occupies the whole width.
const FEW: usize = 14;
/// Number of parameters above which every second name is shown; every third at twice the number.
const LETTERED: usize = 48;
/// Minimum absolute correlation of pairs that are named.
const STRONG: f64 = 0.9;
/// Minimum absolute correlation with a text for pointers in a large matrix; the workbook has all.
const TOLD: f64 = 0.5;
const TOP: f64 = 4.0;

/// Correlation matrix; `None` without a covariance of the identified parameters.
pub(crate) fn picture(document: &ParametersDocument, words: &Words) -> Option<Figure> {
    let names: Vec<&str> = document.identified().map(|p| p.name.as_str()).collect();
    let (covariance, n) = (&document.covariance, names.len());
    if n < 2 || covariance.len() != n || covariance.iter().any(|row| row.len() != n) {
        return None;
    }
    let r = |i: usize, j: usize| {
        if i == j { 1.0 } else { covariance[i][j] / (covariance[i][i] * covariance[j][j]).sqrt() }
    };
    let pairs = || (0..n).flat_map(|i| (0..i).map(move |j| (i, j)));
    if pairs().any(|(i, j)| !r(i, j).is_finite()) {
        return None;
    }
    let letters: Vec<String> = names.iter().map(|name| shortened(name)).collect();
    let margin = 12.0 + widest(letters.iter().map(String::as_str));
    let width = if n > FEW { WIDE } else { NARROW };
    let cell = (width - margin - 4.0) / n as f64;
    let mut svg = Svg::new(words, width, TOP + cell * n as f64 + margin);
    for (i, name) in names.iter().enumerate() {
        for (j, other) in names.iter().enumerate().take(i + 1) {
            let at = (margin + cell * j as f64, TOP + cell * i as f64);
            let correlation = r(i, j);
            let told = correlation.abs() >= TOLD || n <= FEW;
            let correlation_text = number::fixed(correlation, 3);
            let tip = match told {
                true => {
                    tr!(words, "correlation-tooltip", first = name, second = other, correlation = correlation_text)
                }
                false => String::new(),
            };
            svg.rect(Look::colour(&colour(r(i, j))), at, (cell - 1.0, cell - 1.0), &tip);
        }
        if i.is_multiple_of(n.div_ceil(LETTERED)) {
            let middle = cell * (i as f64 + 0.5) + 4.0;
            svg.text("end", (margin - 6.0, TOP + middle), &letters[i]);
            svg.text_upwards("end", (margin + middle, TOP + cell * n as f64 + 6.0), &letters[i]);
        }
    }
    scale(&mut svg, words);
    let mut strong: Vec<(usize, usize)> = pairs().filter(|&(i, j)| r(i, j).abs() >= STRONG).collect();
    strong.sort_by(|a, b| r(b.0, b.1).abs().total_cmp(&r(a.0, a.1).abs()));
    let said = |&(i, j): &(usize, usize)| format!("{} – {} {}", names[j], names[i], words.fixed(r(i, j), 3));
    let listed = strong.iter().take(6).map(said).collect::<Vec<_>>().join(", ");
    let caption = match strong.len() {
        0 => tr!(words, "no-correlated-pairs"),
        1..=6 => tr!(words, "correlated-pairs", pairs = listed),
        n => tr!(words, "correlated-pairs-strongest", count = n, pairs = listed),
    };
    let title = tr!(words, "correlation-title");
    let description = tr!(words, "correlation-description");
    let number = |i: usize, j: usize| words.fixed(r(i, j), 3);
    let row = |i: usize| std::iter::once(names[i].to_owned()).chain((0..n).map(|j| number(i, j))).collect();
    Some(Figure {
        caption: format!("{description} {caption}"),
        table_title: tr!(words, "numbers-of-this-picture"),
        header: std::iter::once(tr!(words, "name")).chain(names.iter().map(|name| (*name).to_owned())).collect(),
        // with many parameters, the numbers are in the workbook
        rows: if n > FEW { Vec::new() } else { (0..n).map(row).collect() },
        ..svg.figure("correlation", title, description)
    })
}

/// Draws the colour scale in the free triangle.
fn scale(svg: &mut Svg, words: &Words) {
    for (i, r) in [1.0, 0.5, 0.0, -0.5, -1.0].into_iter().enumerate() {
        let (right, y, fill) = (svg.width, TOP + 16.0 * i as f64, colour(r));
        let edge = Look { class: "axis", ..Look::colour(&fill) };
        svg.rect(edge, (right - 58.0, y), (13.0, 13.0), "");
        svg.text("end", (right - 6.0, y + 11.0), &words.fixed(r, 1));
    }
}

/// White at zero, blue at one, orange at minus one; both ends are dark enough for colour-blind
/// readers.
fn colour(r: f64) -> String {
    let end = if r > 0.0 { [0.0, 90.0, 160.0] } else { [200.0, 90.0, 0.0] };
    let [red, green, blue] = end.map(|c| (255.0 + r.abs().min(1.0) * (c - 255.0)).round() as u8);
    format!("#{red:02x}{green:02x}{blue:02x}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::Documents;

    #[test]
    fn correlations_are_those_of_the_covariance() {
        let mut document = Documents::demo().parameters;
        document.parameters.retain(|p| ["beta", "gamma", "s"].contains(&p.name.as_str()));
        document.covariance = vec![vec![4.0, 3.0, 0.0], vec![3.0, 9.0, -2.91], vec![0.0, -2.91, 1.0]];
        let picture = picture(&document, &Words::default()).unwrap();
        // 3 / (2 * 3), -2.91 / (3 * 1)
        assert!(picture.svg.contains("gamma and beta: 0.500") && picture.svg.contains("s and gamma: -0.970"));
        let pairs = tr!(Words::default(), "correlated-pairs", pairs = "gamma – s -0.970");
        assert!(picture.caption.ends_with(&pairs), "{}", picture.caption);
        assert_eq!(picture.rows[2], ["s", "0.000", "-0.970", "1.000"]);
        assert_eq!(colour(1.0), "#005aa0");
        assert!([">1.0<", ">0.0<", ">-1.0<"].iter().all(|label| picture.svg.contains(label)), "{}", picture.svg);
    }

    #[test]
    fn a_matrix_of_many_parameters_has_letters_too() {
        let mut document = Documents::demo().parameters;
        let first = document.parameters[0].clone();
        let of = |i: usize| etalon_documents::ParameterEntry { name: format!("p{i}"), ..first.clone() };
        for (n, lettered) in [(45, 45), (60, 30)] {
            document.parameters = (0..n).map(of).collect();
            document.covariance = (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect();
            let picture = picture(&document, &Words::default()).unwrap();
            // at the side, below, and at the scale
            assert_eq!(picture.svg.matches("class=\"end\"").count(), 2 * lettered + 5);
        }
    }

    #[test]
    fn a_covariance_that_is_none_is_not_drawn() {
        let mut document = Documents::demo().parameters;
        assert!(picture(&document, &Words::default()).is_none());
        document.parameters.truncate(2);
        for odd in [0.0, -1.0, f64::NAN] {
            document.covariance = vec![vec![odd, 0.1], vec![0.1, 1.0]];
            assert!(picture(&document, &Words::default()).is_none());
        }
    }
}

//! Contributions of the sources to the variance of each figure of the errors, as bars.

use super::layer::*;
use etalon_documents::{FigureBudget, UncertaintySource};

/// Minimum share whose number is shown.
const WRITTEN: f64 = 0.08;
/// Minimum share that is visible as a bar.
const DRAWN: f64 = 0.001;
/// Minimum share of a second source that is worth a figure.
const VISIBLE: f64 = 0.01;

/// One bar for each figure, with sources by name; `None` if only one source is visible.
pub(crate) fn picture(budget: &[FigureBudget], name_of: fn(&FigureBudget) -> Phrase, words: &Words) -> Option<Figure> {
    let mut sources: Vec<_> = budget.iter().flat_map(|f| &f.contributions).map(|c| c.source).collect();
    sources.sort_unstable();
    sources.dedup();
    let share = |f: &FigureBudget, source: UncertaintySource| {
        let square = |u: f64| u * u;
        let whole: f64 = f.contributions.iter().map(|c| square(c.standard_uncertainty_mm)).sum();
        let of = f.contributions.iter().filter(|c| c.source == source);
        of.map(|c| square(c.standard_uncertainty_mm)).sum::<f64>() / whole
    };
    // the legend contains only the sources in the figure
    sources.retain(|source| budget.iter().any(|f| share(f, *source) >= DRAWN));
    let parts = |f: &FigureBudget| sources.iter().filter(|s| share(f, **s) >= VISIBLE).count();
    if sources.len() > COLOURS.len() || !budget.iter().any(|f| parts(f) > 1) {
        return None;
    }
    let labels = budget.iter().enumerate().map(|(i, f)| (i as f64, words.tr(&name_of(f)))).collect();
    let axes = [Axis::linear(0.0, 100.0), Axis::rows(budget.len(), labels, 0.5)];
    let mut chart = Chart::new(words, WIDE, axes, ["%", ""]);
    for (i, f) in budget.iter().enumerate() {
        let mut from = 0.0;
        for (j, source) in sources.iter().enumerate().filter(|(_, s)| share(f, **s) > 0.0) {
            let share = share(f, *source);
            let (middle, right) = (from + 50.0 * share, from + 100.0 * share);
            let percent = format!("{:.0} %", 100.0 * share);
            let tip = format!("{}: {} {percent}", words.tr(&name_of(f)), words.tr(&names::source(*source)));
            chart.bar_along(Look::colour(COLOURS[j]), i, [from, right], &tip);
            if share >= WRITTEN {
                let (x, y) = chart.at(middle, i as f64);
                chart.svg.text("over mid", (x, y + 4.0), &percent);
            }
            from = right;
        }
    }
    for (j, source) in sources.iter().enumerate() {
        chart.svg.legend(Look::colour(COLOURS[j]), &words.tr(&names::source(*source)));
    }
    let title = tr!(words, "budget-shares-title");
    let description = tr!(words, "budget-shares-description");
    Some(chart.figure("shares", title, description))
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_documents::{Figure as Statistic, FigureContribution};

    fn figure(figure: Statistic, parts: &[(UncertaintySource, f64)]) -> FigureBudget {
        let part = |&(source, standard_uncertainty_mm): &(UncertaintySource, f64)| FigureContribution {
            source,
            standard_uncertainty_mm,
        };
        let contributions = parts.iter().map(part).collect();
        FigureBudget { quantity: ErrorQuantity::Position, figure, standard_uncertainty_mm: 0.0, contributions }
    }

    #[test]
    fn bars_show_every_figure_where_there_is_something_to_see() {
        use UncertaintySource::{Instrument, Model};
        let draw = |all: &[FigureBudget]| picture(all, |_| etalon_base::phrase!("position"), &Words::default());
        // 3² and 4² of 5²
        let mixed = [
            figure(Statistic::Mean, &[(Instrument, 0.003), (Model, 0.004)]),
            figure(Statistic::Max, &[(Instrument, 0.0), (Model, 0.004)]),
        ];
        let svg = draw(&mixed).unwrap().svg;
        assert!(svg.contains(">36 %<") && svg.contains(">64 %<") && svg.contains(">100 %<"), "{svg}");
        assert_eq!(svg.matches("<rect").count(), 3);
        let unseen = figure(Statistic::Rms, &[(Instrument, 0.003), (Model, 0.004), (UncertaintySource::Frame, 1e-6)]);
        let svg = draw(&[unseen]).unwrap().svg;
        assert!(svg.contains(">model<") && !svg.contains(">world frame<"), "{svg}");
        assert!(draw(&mixed[1..]).is_none(), "a bar of one source says nothing");
        assert!(draw(&[]).is_none());
    }
}

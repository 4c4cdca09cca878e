//! Errors after calibration against joint values and distance from the base.

use super::layer::*;

/// Quantity of a pose.
type Quantity<'a> = Box<dyn Fn(&PointError) -> Option<f64> + 'a>;

/// Quantity on the horizontal axis.
struct Along<'a> {
    id: String,
    name: String,
    of: Quantity<'a>,
}

/// One figure for each joint, and one for the distance from the base.
pub(crate) fn pictures(
    errors: &[&PointError],
    joints: &[String],
    base_mm: Option<Vector>,
    limits: &[LimitVerdict],
    words: &Words,
) -> Vec<Figure> {
    let of_joint = |(k, column): (usize, &String)| {
        let (name, unit) = column.rsplit_once('_').unwrap_or((column, ""));
        let name = tr!(words, "quantity-in-unit", quantity = name, unit);
        Along { id: format!("joint-{k}"), name, of: Box::new(move |p| p.joints.get(k).copied()) }
    };
    let reach = base_mm.map(|base| Along {
        id: "reach".to_owned(),
        name: tr!(words, "distance-from-base-in-mm"),
        of: Box::new(move |p| Some(norm(minus(p.at_mm, base)))),
    });
    let all = joints.iter().enumerate().map(of_joint).chain(reach);
    all.filter_map(|along| picture(errors, &along, limits, words)).collect()
}

fn picture(errors: &[&PointError], along: &Along, limits: &[LimitVerdict], words: &Words) -> Option<Figure> {
    let known: Vec<&PointError> =
        errors.iter().copied().filter(|p| (along.of)(p).is_some_and(f64::is_finite)).collect();
    let drawn = points::readable(&known);
    let ends = range(drawn.iter().filter_map(|p| (along.of)(p))).filter(|(low, high)| high > low)?;
    let up = Axis::from_zero("mm", largest(drawn.iter().map(|p| points::after_mm(p))));
    let name = tr!(words, "position-error-in", unit = up.shown().unit);
    let mut chart = Chart::new(NARROW, [Axis::over("", ends, 0.02), up], [along.name.clone(), name]);
    for p in &drawn {
        let at = chart.at((along.of)(p)?, points::after_mm(p));
        chart.svg.mark(points::look(p), at, 2.4, &points::tooltip(p, words));
    }
    points::legend(&mut chart.svg, &drawn, words);
    chart.limits(limits, ErrorQuantity::Position, false);
    let title = tr!(words, "position-error-against", quantity = along.name);
    let description = tr!(words, "errors-against-description");
    let caption = description.clone() + &points::how_many(drawn.len(), known.len(), words);
    Some(Figure { caption, ..chart.figure(&format!("against-{}", along.id), title, description) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::point;

    #[test]
    fn every_joint_that_moves_and_the_distance_from_the_base_have_a_picture() {
        let mut errors: Vec<_> = (0..9).map(|i| point(i, [30.0 * i as f64, 40.0, 0.0], [0.1; 3], [0.01; 3])).collect();
        errors.iter_mut().enumerate().for_each(|(i, p)| p.joints = vec![i as f64, 5.0]);
        let all: Vec<_> = errors.iter().collect();
        let joints = ["q1_deg", "q2_deg"].map(str::to_owned);
        let figures = pictures(&all, &joints, Some([0.0; 3]), &[], &Words::default());
        let titles: Vec<&str> = figures.iter().map(|f| f.title.as_str()).collect();
        assert_eq!(titles.len(), 2, "a joint that stands still explains nothing: {titles:?}");
        assert!(titles[0].ends_with("against q1 in deg") && titles[1].ends_with("distance from the base in mm"));
        assert_eq!(figures[0].svg.matches("<circle").count(), 9 + 1);
        assert!(pictures(&all, &[], None, &[], &Words::default()).is_empty());
    }
}

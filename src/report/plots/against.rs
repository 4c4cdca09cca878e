//! Errors after calibration against joint values and distance from the base.

use super::layer::*;
use etalon_documents::ResidualTrend;

/// Quantity of a pose.
type Quantity<'a> = Box<dyn Fn(&PointError) -> Option<f64> + 'a>;

/// Quantity on the horizontal axis.
struct Along<'a> {
    id: String,
    /// Name in the tests of trends.
    key: &'a str,
    name: String,
    of: Quantity<'a>,
}

/// Significance level of a trend.
pub(crate) const SIGNIFICANCE: f64 = 0.05;

/// Errors of a campaign with the quantities against which they are drawn.
pub(crate) struct Data<'a> {
    pub errors: &'a [&'a PointError],
    /// Names of the joints' columns.
    pub joints: &'a [String],
    pub base_mm: Option<Vector>,
    pub limits: &'a [LimitVerdict],
    /// Tests of the errors against joints and distance.
    pub trends: &'a [ResidualTrend],
}

/// One figure for each joint, and one for the distance from the base, with one scale of errors:
/// figures with a significant trend, the most significant first, and the others.
pub(crate) fn pictures(data: &Data, words: &Words) -> [Vec<Figure>; 2] {
    let of_joint = |(k, column): (usize, &'_ String)| {
        let (name, unit) = column.rsplit_once('_').unwrap_or((column, ""));
        let name = tr!(words, "quantity-in-unit", quantity = name, unit);
        (format!("joint-{k}"), name, k)
    };
    let joints = data.joints.iter().enumerate().map(|joint| {
        let (id, name, k) = of_joint(joint);
        let of: Quantity = Box::new(move |p| p.joints.get(k).copied());
        Along { id, key: joint.1, name, of }
    });
    let reach = data.base_mm.map(|base| Along {
        id: "reach".to_owned(),
        key: "reach_mm",
        name: tr!(words, "distance-from-base-in-mm"),
        of: Box::new(move |p| Some(norm(minus(p.at_mm, base)))),
    });
    let quantities = points::by_quantity(data.errors);
    let single = quantities.len() == 1;
    let drawn: Vec<OfQuantity> =
        quantities.into_iter().map(|(quantity, errors)| OfQuantity::new(quantity, errors, single)).collect();
    let trend = |along: &Along| {
        data.trends.iter().find(|t| t.against == along.key && t.p_value < SIGNIFICANCE).map(|t| t.p_value)
    };
    let (mut significant, mut others) = (Vec::new(), Vec::new());
    for along in joints.chain(reach) {
        let p = trend(&along);
        let figures = drawn.iter().filter_map(|of| picture(data, &along, of, p, words));
        match p {
            Some(p) => significant.extend(figures.map(|figure| (p, figure))),
            None => others.extend(figures),
        }
    }
    significant.sort_by(|a, b| a.0.total_cmp(&b.0));
    [significant.into_iter().map(|(_, figure)| figure).collect(), others]
}

/// Errors of one quantity with their axis.
struct OfQuantity<'a> {
    quantity: ErrorQuantity,
    errors: Vec<&'a PointError>,
    up: Axis,
    /// `true` if the trends belong to this quantity alone.
    single: bool,
}

impl<'a> OfQuantity<'a> {
    fn new(quantity: ErrorQuantity, errors: Vec<&'a PointError>, single: bool) -> Self {
        let up = Axis::from_zero("mm", largest(points::readable(&errors).into_iter().map(points::after_mm)));
        Self { quantity, errors, up, single }
    }
}

fn picture(data: &Data, along: &Along, of: &OfQuantity, p: Option<f64>, words: &Words) -> Option<Figure> {
    let OfQuantity { quantity, errors, up, single } = of;
    let known: Vec<&PointError> =
        errors.iter().copied().filter(|p| (along.of)(p).is_some_and(f64::is_finite)).collect();
    // many figures: half of the marks of others
    let drawn = points::thin(&points::readable(&known), points::MARKS / 2, points::after_mm);
    let ends = range(drawn.iter().filter_map(|p| (along.of)(p))).filter(|[low, high]| high > low)?;
    let (unit, of, against) = (up.display_unit().unit, words.tr(&quantity.phrase()), along.name.clone());
    let (title, name) = match quantity {
        ErrorQuantity::Position => {
            (tr!(words, "position-error-against", quantity = against), tr!(words, "position-error-in", unit))
        }
        _ => (tr!(words, "error-against", quantity = of, against), tr!(words, "error-in-unit", unit)),
    };
    let mut chart = Chart::new(words, NARROW, [Axis::over("", ends, 0.02), up.clone()], [along.name.clone(), name]);
    for p in &drawn {
        let at = chart.at((along.of)(p)?, points::after_mm(p));
        chart.svg.mark(points::look(p), at, 2.4, &points::tooltip(p, words));
    }
    points::legend(&mut chart.svg, &drawn, words);
    chart.limit(data.limits, *quantity, false, words);
    let description = tr!(words, "errors-against-description");
    let judged = match p.map(number::p_value) {
        Some(probability) if *single => format!(" {}", tr!(words, "trend-in-picture", probability)),
        Some(probability) => format!(" {}", tr!(words, "trend-of-all-quantities", probability)),
        None => String::new(),
    };
    let caption = description.clone() + &judged + &points::how_many(drawn.len(), known.len(), words);
    let id = format!("against-{}", points::quantity_key(*quantity, &along.id));
    Some(Figure { caption, ..chart.figure(&id, title, description) })
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
        let mut data = Data { errors: &all, joints: &joints, base_mm: Some([0.0; 3]), limits: &[], trends: &[] };
        let [significant, others] = pictures(&data, &Words::default());
        let titles: Vec<&str> = others.iter().map(|f| f.title.as_str()).collect();
        assert_eq!((significant.len(), titles.len()), (0, 2), "a joint that stands still explains nothing: {titles:?}");
        assert!(titles[0].ends_with("versus q1 (deg)") && titles[1].ends_with("distance from the base (mm)"));
        assert_eq!(others[0].svg.matches("<circle").count(), 9 + 1);
        let trend =
            |against: &str, p_value| ResidualTrend { against: against.to_owned(), explained_mm: 0.01, f: 9.0, p_value };
        let trends = [trend("q1_deg", 0.2), trend("reach_mm", 0.003)];
        data.trends = &trends;
        let [significant, others] = pictures(&data, &Words::default());
        assert_eq!((significant.len(), others.len()), (1, 1));
        let unmodelled = tr!(Words::default(), "trend-in-picture", probability = "p = 0.0030");
        assert!(significant[0].caption.contains(&unmodelled), "{}", significant[0].caption);
        (data.joints, data.base_mm) = (&[], None);
        assert!(pictures(&data, &Words::default()).iter().all(Vec::is_empty));
    }

    #[test]
    fn quantities_are_separate_and_a_trend_is_that_of_all_together() {
        let mut errors: Vec<_> = (0..18).map(|i| point(i, [0.0; 3], [0.1; 3], [0.01; 3])).collect();
        for (i, p) in errors.iter_mut().enumerate() {
            p.joints = vec![i as f64];
            p.quantity = if i < 9 { ErrorQuantity::Distance } else { ErrorQuantity::Surface };
        }
        let all: Vec<_> = errors.iter().collect();
        let trend = ResidualTrend { against: "q1_deg".to_owned(), explained_mm: 0.01, f: 9.0, p_value: 0.003 };
        let trends = [trend];
        let joints = ["q1_deg".to_owned()];
        let data = Data { errors: &all, joints: &joints, base_mm: None, limits: &[], trends: &trends };
        let [significant, _] = pictures(&data, &Words::default());
        let titles: Vec<&str> = significant.iter().map(|f| f.title.as_str()).collect();
        let title = |of: &str| format!("Error after calibration: {of}, versus q1 (deg)");
        assert_eq!(titles, [title("distance"), title("surface")]);
        let together = tr!(Words::default(), "trend-of-all-quantities", probability = "p = 0.0030");
        assert!(significant[0].caption.contains(&together), "{}", significant[0].caption);
        assert!(!significant[0].svg.contains("position error"));
    }

    #[test]
    fn all_pictures_have_one_scale() {
        let mut errors: Vec<_> = (0..9).map(|i| point(i, [0.0; 3], [0.1; 3], [0.01 * i as f64, 0.0, 0.0])).collect();
        // the largest errors lack the second joint
        errors.iter_mut().enumerate().for_each(|(i, p)| p.joints = vec![i as f64, i as f64]);
        errors[8].joints.pop();
        let all: Vec<_> = errors.iter().collect();
        let joints = ["q1_deg", "q2_deg"].map(str::to_owned);
        let data = Data { errors: &all, joints: &joints, base_mm: None, limits: &[], trends: &[] };
        let [_, others] = pictures(&data, &Words::default());
        let labels = |figure: &Figure| {
            let texts = figure.svg.lines().filter(|l| l.starts_with("<text class=\"end\""));
            texts.map(str::to_owned).collect::<Vec<_>>()
        };
        assert!(labels(&others[0]).len() > 3);
        assert_eq!(labels(&others[0]), labels(&others[1]));
    }
}

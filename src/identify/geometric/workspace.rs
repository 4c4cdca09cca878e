//! Area that the platform's centre C reaches (thesis 2.2.2).

use etalon_robots::{PlanarPose, RailTable};

/// A polygon with counterclockwise corners; empty if nothing is reachable.
pub type Polygon = Vec<[f64; 2]>;

/// A robot with the travel of its actuators.
#[derive(Clone, Copy)]
pub struct Workspace<'a> {
    robot: &'a dyn RailTable,
    parameters: &'a [f64],
    travel_mm: [f64; 3],
}

/// Half the side (mm) of the initial square from which the reachable region is cut.
const FAR_MM: f64 = 1e4;

impl<'a> Workspace<'a> {
    /// Returns the workspace of a robot with these parameters; `None` if the travel of its
    /// actuators is not given.
    pub fn new(robot: &'a dyn RailTable, parameters: &'a [f64]) -> Option<Self> {
        Some(Self { robot, parameters, travel_mm: robot.travel_mm()? })
    }

    /// `true` if the actuators reach a pose of the platform in the base frame.
    pub fn contains(&self, pose: PlanarPose) -> bool {
        self.robot.limit_violation(self.parameters, &self.robot.joints_at(self.parameters, pose)).is_none()
    }

    /// Positions reached with the orientation `theta_rad`, in the base frame (mm).
    pub fn at(&self, theta_rad: f64) -> Polygon {
        self.cut(vec![[-FAR_MM, -FAR_MM], [FAR_MM, -FAR_MM], [FAR_MM, FAR_MM], [-FAR_MM, FAR_MM]], theta_rad)
    }

    /// Positions reached with every orientation from −`theta_rad` to `theta_rad`: the hexagon of
    /// figure 2.4.
    ///
    /// With t = tan θ, eq. 3.12 to 3.14 limit x and y by what is linear in t: what holds at both
    /// ends holds between.
    pub fn within(&self, theta_rad: f64) -> Polygon {
        self.cut(self.at(-theta_rad), theta_rad)
    }

    /// Part of a polygon within the travel of every actuator: at one orientation, displacements are
    /// linear in x and y.
    fn cut(&self, mut polygon: Polygon, theta_rad: f64) -> Polygon {
        let at = |x_mm: f64, y_mm: f64| self.robot.joints_at(self.parameters, PlanarPose { x_mm, y_mm, theta_rad });
        let (origin, along_x, along_y) = (at(0.0, 0.0), at(1e3, 0.0), at(0.0, 1e3));
        for (i, end) in self.travel_mm.into_iter().enumerate() {
            let (a, b) = ((along_x[i] - origin[i]) / 1e3, (along_y[i] - origin[i]) / 1e3);
            let rho = |p: [f64; 2]| origin[i] + a * p[0] + b * p[1];
            polygon = clip(&polygon, rho);
            polygon = clip(&polygon, |p| end - rho(p));
        }
        polygon
    }
}

/// Part of a convex polygon in which a linear function is non-negative (Sutherland & Hodgman 1974,
/// CACM 17, 32).
fn clip(polygon: &[[f64; 2]], inside: impl Fn([f64; 2]) -> f64) -> Polygon {
    let mut kept = Vec::new();
    for (&a, &b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let (at_a, at_b) = (inside(a), inside(b));
        if at_a >= 0.0 {
            kept.push(a);
        }
        if (at_a > 0.0 && at_b < 0.0) || (at_a < 0.0 && at_b > 0.0) {
            let part = at_a / (at_a - at_b);
            kept.push([a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])]);
        }
    }
    kept
}

/// Area of a polygon, positive for counterclockwise corners.
pub fn area_mm2(polygon: &[[f64; 2]]) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    0.5 * polygon.iter().zip(next).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_robots::{Prexyt, Robot};

    const TRAVEL_MM: [f64; 3] = [170.0, 300.0, 300.0];

    fn pose(x_mm: f64, y_mm: f64, theta_deg: f64) -> PlanarPose {
        PlanarPose { x_mm, y_mm, theta_rad: theta_deg.to_radians() }
    }

    #[test]
    fn at_zero_degrees_it_is_the_rectangle_of_the_travels() {
        let robot = Prexyt::default().with_travel(Some(TRAVEL_MM));
        let nominal = robot.nominal();
        let workspace = Workspace::new(&robot, &nominal).unwrap();
        let polygon = workspace.at(0.0);
        assert_eq!(polygon.len(), 4);
        assert!((area_mm2(&polygon) - 170.0 * 300.0).abs() < 1e-6, "{polygon:?}");
    }

    /// d1 = 115 mm as in section 2.6.4: the largest disk is 169.93 mm.
    #[test]
    fn a_disk_of_170_mm_is_reached_with_every_orientation_up_to_17_degrees_as_the_thesis_says() {
        let robot = Prexyt::default().with_travel(Some(TRAVEL_MM));
        let mut nominal = robot.nominal();
        nominal[5] = 115.0;
        let workspace = Workspace::new(&robot, &nominal).unwrap();
        assert_eq!(workspace.within(17f64.to_radians()).len(), 6);
        let on_disk = |diameter_mm: f64, deg: i32, theta_deg: f64| {
            let (sin, cos) = f64::from(deg).to_radians().sin_cos();
            workspace.contains(pose(200.0 + 0.5 * diameter_mm * cos, 150.0 + 0.5 * diameter_mm * sin, theta_deg))
        };
        let reached = |diameter_mm: f64| {
            (0..360).all(|deg| [-17.0, -8.0, 0.0, 5.0, 17.0].iter().all(|&theta| on_disk(diameter_mm, deg, theta)))
        };
        assert!(reached(169.5) && !reached(170.5));
    }

    /// Inside a polygon by its edges, against membership by the actuators, with all thirteen
    /// errors.
    #[test]
    fn polygons_are_the_workspace_of_the_actuators() {
        let robot = Prexyt::default().with_travel(Some(TRAVEL_MM));
        let mut p = robot.nominal();
        (p[0], p[1], p[3], p[4], p[5]) = (-0.02, 0.03, 393.9, 0.7, 116.1);
        let workspace = Workspace::new(&robot, &p).unwrap();
        let inside = |polygon: &[[f64; 2]], q: [f64; 2]| {
            let next = polygon.iter().cycle().skip(1);
            let left = |(a, b): (&[f64; 2], &[f64; 2])| (b[0] - a[0]) * (q[1] - a[1]) - (b[1] - a[1]) * (q[0] - a[0]);
            !polygon.is_empty() && polygon.iter().zip(next).map(left).all(|side| side >= 0.0)
        };
        let (one, all) = (workspace.at(0.2), workspace.within(0.25));
        let (mut reached, mut always) = (0, 0);
        for (i, j) in (0..60).flat_map(|i| (0..60).map(move |j| (i, j))) {
            let (x, y) = (80.3 + 4.1 * f64::from(i), -60.7 + 7.3 * f64::from(j));
            let with = |theta_rad| workspace.contains(PlanarPose { x_mm: x, y_mm: y, theta_rad });
            assert_eq!(inside(&one, [x, y]), with(0.2), "{x} {y}");
            let every = (-50..=50).all(|k| with(0.005 * f64::from(k)));
            assert_eq!(inside(&all, [x, y]), every, "{x} {y}");
            reached += usize::from(with(0.2));
            always += usize::from(every);
        }
        // areas by counting, a cell is 4.1 mm × 7.3 mm
        assert!((f64::from(reached as u32) * 4.1 * 7.3 / area_mm2(&one) - 1.0).abs() < 0.03);
        assert!((f64::from(always as u32) * 4.1 * 7.3 / area_mm2(&all) - 1.0).abs() < 0.03);
    }

    #[test]
    fn what_cannot_be_reached_is_empty() {
        let robot = Prexyt::default().with_travel(Some(TRAVEL_MM));
        let nominal = robot.nominal();
        let workspace = Workspace::new(&robot, &nominal).unwrap();
        assert!(workspace.at(60f64.to_radians()).is_empty());
        assert_eq!(area_mm2(&[]), 0.0);
    }
}

//! Names of the parameters that conditions add to the parameters of a robot.

use etalon_robots::{Parameter, Quantity, Robot, Role, meaning};

/// Parameters that conditions add to the parameters of a robot, by name.
#[derive(Clone, Copy, Debug)]
pub enum Fixture<'a> {
    /// A point that is fixed in the world: a socket, the end of a ball bar. Parameters `NAME_x`,
    /// `NAME_y`, `NAME_z`.
    Point(&'a str),
    /// The orientation on the flange of the body that carries a target: `TARGET_rx`, `TARGET_ry`,
    /// `TARGET_rz`, a rotation vector.
    Mounting(&'a str),
    /// A plane, with its axis. For the z axis: `NAME_slope_x`, `NAME_slope_y`, angles of its traces
    /// in the planes through z, and `NAME_z`, its intersection with z. Cyclic for the others.
    Plane(&'a str, usize),
    /// A line, with its axis. For the z axis: `NAME_slope_x`, `NAME_slope_y`, its angles against z
    /// in the planes through z, and `NAME_x`, `NAME_y`, its intersection with z = 0.
    Line(&'a str, usize),
    /// The pose in the world of another station of the instrument: `NAME_x`, `NAME_y`, `NAME_z`,
    /// and a rotation vector `NAME_rx`, `NAME_ry`, `NAME_rz`.
    Station(&'a str),
    /// The radius of a sphere: `NAME_radius`. Its centre is a point.
    Radius(&'a str),
    /// The length of a bar between two targets: `bar_TARGET_OTHER`.
    Bar([&'a str; 2]),
}

const STATION: &str = meaning("meaning-station-pose");
const BAR: &str = meaning("meaning-bar-length");

impl Fixture<'_> {
    /// Adds its parameters to the parameters of `robot`, unless they exist, and returns the index
    /// of the first.
    pub fn add_to(self, robot: &mut dyn Robot) -> usize {
        const AXES: [&str; 3] = ["x", "y", "z"];
        use Quantity::{Angle, Length};
        let slope = |name, axis, k: usize| (format!("{name}_slope_{}", AXES[(axis + k) % 3]), Angle, Role::Fixture);
        let along = |name, axis: usize| (format!("{name}_{}", AXES[axis % 3]), Length, Role::Fixture);
        let names = match self {
            Self::Point(name) => (0..3).map(|axis| along(name, axis)).collect(),
            Self::Mounting(target) => AXES.map(|axis| (format!("{target}_r{axis}"), Angle, Role::Target)).to_vec(),
            Self::Plane(name, axis) => vec![slope(name, axis, 1), slope(name, axis, 2), along(name, axis)],
            Self::Line(name, axis) => {
                vec![slope(name, axis, 1), slope(name, axis, 2), along(name, axis + 1), along(name, axis + 2)]
            }
            Self::Station(name) => {
                let turns = AXES.map(|axis| (format!("{name}_r{axis}"), Angle, Role::Fixture));
                (0..3).map(|axis| along(name, axis)).chain(turns).collect()
            }
            Self::Radius(name) => vec![(format!("{name}_radius"), Length, Role::Fixture)],
            Self::Bar([a, b]) => {
                // a bar is the same from either end
                let [there, back] = [[a, b], [b, a]].map(|[a, b]| format!("bar_{a}_{b}"));
                let name = if robot.index(&back).is_some() { back } else { there };
                vec![(name, Length, Role::Fixture)]
            }
        };
        if let Some(first) = robot.index(&names[0].0) {
            return first;
        }
        let all = &mut robot.definition_mut().parameters;
        let first = all.len();
        all.extend(names.into_iter().map(|(name, quantity, role)| Parameter {
            tolerance: f64::INFINITY,
            ..Parameter::new(name, quantity, role, 0.0)
        }));
        match self {
            Self::Station(_) => all[first..].iter_mut().for_each(|p| p.meaning = STATION),
            Self::Bar(_) => all[first..].iter_mut().for_each(|p| p.meaning = BAR),
            _ => {}
        }
        first
    }
}

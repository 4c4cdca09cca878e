//! A target on a plane, line or sphere, or a fixed point there; the radius of a sphere.

use super::cells::check_fixed;
use super::kind::xyz;
use super::{Cells, Facts, Measurement, Row, RowKind, Simulated};
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::Vector;
use etalon_identify::{Fixture, Kind, Known, On, Surface};
use etalon_robots::Robot;

/// A surface and its parameters.
type Unknowns = (Surface, [usize; 4]);

pub(super) struct OnSurface {
    name: &'static str,
    /// `true` if a target may be off the surface: outside a sphere.
    has_offset: bool,
    /// `true` if its radius may be known.
    has_radius: bool,
    /// The surface that the cells name.
    surface: fn(&Cells, &mut dyn Robot) -> Result<Unknowns>,
}

pub(super) const PLANE: OnSurface = OnSurface { name: "plane", has_offset: true, has_radius: false, surface: plane };
pub(super) const LINE: OnSurface = OnSurface { name: "line", has_offset: false, has_radius: false, surface: line };
pub(super) const SPHERE: OnSurface = OnSurface { name: "sphere", has_offset: true, has_radius: true, surface: sphere };

fn plane(cells: &Cells, robot: &mut dyn Robot) -> Result<Unknowns> {
    let name = cells.name("plane")?;
    let axis = cells.axis(|| error!("surface-axis-missing", kind = "plane", name))?;
    let first = Fixture::Plane(name, axis).add_to(robot);
    Ok((Surface::Plane { axis }, [first, first + 1, first + 2, first + 2]))
}

fn line(cells: &Cells, robot: &mut dyn Robot) -> Result<Unknowns> {
    // `line` are the lines of the file
    let name = cells.name("line_name")?;
    let axis = cells.axis(|| error!("surface-axis-missing", kind = "line", name))?;
    let first = Fixture::Line(name, axis).add_to(robot);
    Ok((Surface::Line { axis }, [first, first + 1, first + 2, first + 3]))
}

fn sphere(cells: &Cells, robot: &mut dyn Robot) -> Result<Unknowns> {
    let name = cells.name("sphere")?;
    check_fixed(name, robot)?;
    let (first, radius) = (Fixture::Point(name).add_to(robot), Fixture::Radius(name).add_to(robot));
    Ok((Surface::Sphere, [first, first + 1, first + 2, radius]))
}

impl OnSurface {
    /// The condition that a target is on the surface that the cells name.
    fn on(&self, cells: &Cells, robot: &mut dyn Robot) -> Result<On> {
        let (surface, unknowns) = (self.surface)(cells, robot)?;
        let offset_mm = match cells.number("offset_mm").unwrap_or(0.0) {
            offset if !self.has_offset && offset.is_nan() => 0.0,
            offset if !self.has_offset && offset != 0.0 => {
                return Err(error!("offset-of-line").into());
            }
            offset if !offset.is_finite() => {
                return Err(error!("number-missing", column = "offset_mm").into());
            }
            offset => offset,
        };
        Ok(On { surface, unknowns, offset_mm })
    }
}

impl RowKind for OnSurface {
    fn facts(&self) -> Facts {
        let numbers = if self.has_radius { vec!["offset_mm", "distance_mm"] } else { vec!["offset_mm"] };
        Facts { name: self.name, numbers, stated: &["offset_mm"], ..Facts::default() }
    }

    fn observed(&self, row: &Row, robot: &mut dyn Robot) -> Result<Vec<(Kind, f64)>> {
        Ok(vec![(Kind::On(self.on(&row.cells, robot)?), f64::NAN)])
    }

    fn known(&self, row: &Row, standard_uncertainty_mm: f64, robot: &mut dyn Robot) -> Result<Known> {
        if self.has_radius && row.xyz_mm.iter().all(|v| v.is_nan()) {
            let parameter = Fixture::Radius(&row.cells.target).add_to(robot);
            return Ok(Known::Length { parameter, length_mm: row.cells.distance()?, standard_uncertainty_mm });
        }
        let (surface, unknowns) = (self.surface)(&row.cells, robot)?;
        Ok(Known::On { surface, unknowns, place_mm: row.fixed_place()?, standard_uncertainty_mm })
    }

    fn simulated(&self, cells: &Cells, robot: &mut dyn Robot) -> Result<Simulated> {
        let (on, has_offset) = (self.on(cells, robot)?, self.has_offset);
        let numbers =
            move |_: &mut Measurement| Ok(has_offset.then_some(("offset_mm", on.offset_mm)).into_iter().collect());
        Ok(Simulated { touches: Some(Kind::On(on)), ..Simulated::anywhere(numbers) })
    }

    fn known_simulated(&self, cells: &Cells, near_mm: Option<Vector>, robot: &mut dyn Robot) -> Result<Simulated> {
        let Some(near_mm) = near_mm else {
            if !self.has_radius {
                return Err(error!("near-missing", kind = self.name).into());
            }
            let radius = Fixture::Radius(&cells.target).add_to(robot);
            return Ok(Simulated::anywhere(move |at| Ok(vec![("distance_mm", at.length(at.values[radius]))])));
        };
        let on = self.on(cells, robot)?;
        Ok(Simulated::anywhere(move |at| {
            let left = at.place([0.0; 3]);
            Ok(xyz(on.nearest(at.values, near_mm, left)))
        }))
    }
}

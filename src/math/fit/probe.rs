//! Probe compensation: what a ball's centres lie on is parallel to what the ball touched.
//!
//! The centres of a probe that touches a surface lie on its parallel surface x + r n (do Carmo 1976, "Differential
//! geometry of curves and surfaces", section 3.5, exercise 11), and orthogonal distances to parallel surfaces differ
//! by the constant r. So the element is fitted to the centres as they are, and then moved by r: no point is moved,
//! residuals and their variance stay, and the answer is that of a fit to the contact points.

use super::element::{Element, Settings, refuse};
use super::result::{Covariance, Fit, QUANTITIES};
use crate::base::message::Result;
use crate::base::pose::{Vector, dot, norm, unit};

/// A probe whose centre was measured instead of what it touched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Probe {
    /// Effective (qualified) radius of the ball.
    pub radius_mm: f64,
    /// Where the ball was.
    pub side: Side,
}

/// The side of the element on which the probe was.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Side {
    /// Within a circle, sphere, cylinder, cone or the tube of a torus: a bore.
    Inside,
    /// Around it: a shaft, a ball.
    Outside,
    /// For a plane or line: the direction from what was touched to the probe. Of a plane only its sign counts, of a
    /// line what is square to it.
    Towards(Vector),
}

/// What was fitted to the probe centres before compensation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compensation {
    /// The probe.
    pub probe: Probe,
    /// Point of the uncompensated fit.
    pub point_mm: Vector,
    /// Radius of the uncompensated fit.
    pub radius_mm: Option<f64>,
    /// Minor radius of the uncompensated fit.
    pub minor_radius_mm: Option<f64>,
}

/// A direction that makes less than 5 degrees with a plane (or with a line) does not say on which side of it a probe was.
const LEAST_SINE: f64 = 0.087;

impl Probe {
    /// Refuses a radius that is none, and a side that `element` does not have.
    pub(super) fn check(&self, element: Element) -> Result<()> {
        let radius = self.radius_mm;
        if !(radius.is_finite() && radius > 0.0) {
            let hint = "state the qualified radius of the probe, not its diameter; leave it out for contact points";
            return Err(refuse(format!("the probe radius is {radius} mm"), "a positive number", hint));
        }
        let straight = matches!(element, Element::Plane | Element::Line | Element::Line2d);
        match self.side {
            Side::Inside | Side::Outside if straight => Err(refuse(
                format!("a {element} has no inside: the side of the probe is not stated"),
                format!("the direction from the {element} to the probe"),
                "state it as three numbers, e.g. 0,0,1 for a probe above",
            )),
            Side::Towards(_) if !straight => Err(refuse(
                format!("the side of the probe is stated by a direction, but a {element} has an inside"),
                "inside (a bore) or outside (a shaft)",
                "state where the ball was: inside or outside",
            )),
            Side::Towards(d) if unit(d).is_none() => Err(refuse(
                format!("the direction {d:?} to the probe is none"),
                "three finite numbers, not all zero",
                "state the direction from what was touched to the probe",
            )),
            _ => Ok(()),
        }
    }

    /// How far the centres lie outside: the radius, negative for a probe inside.
    fn outwards_mm(&self) -> f64 {
        if self.side == Side::Inside { -self.radius_mm } else { self.radius_mm }
    }
}

impl Settings<'_> {
    /// The radius to hold in a fit of the points as they are: that of the probe centres where there is a probe.
    pub(super) fn held_radius_mm(&self) -> Option<f64> {
        self.radius_mm.map(|r| r + self.probe.map_or(0.0, |p| p.outwards_mm()))
    }
}

impl Fit {
    /// The element that was touched, from the fit to the centres of the probe; the same fit without a probe.
    ///
    /// # Errors
    /// If the side does not fit the element, or the probe would not fit on it.
    pub fn compensated(mut self, probe: Option<Probe>) -> Result<Self> {
        let Some(probe) = probe else { return Ok(self) };
        probe.check(self.element)?;
        if self.compensation.is_some() {
            return Err(refuse("the fit is compensated already", "a fit to probe centres", "compensate once"));
        }
        let (point_mm, radius_mm, minor_radius_mm) = (self.point_mm, self.radius_mm, self.minor_radius_mm);
        let moves = self.moves(&probe)?;
        if let Some(Covariance(c)) = &mut self.covariance {
            *c = product(&moves, &product(c, &transposed(&moves)));
        }
        self.compensation = Some(Compensation { probe, point_mm, radius_mm, minor_radius_mm });
        Ok(self)
    }

    /// Moves the element by the probe, and gives the derivative of its quantities by those of the uncompensated one.
    fn moves(&mut self, probe: &Probe) -> Result<[[f64; QUANTITIES]; QUANTITIES]> {
        let mut derivative = identity();
        let outwards = probe.outwards_mm();
        match (self.element, probe.side, self.direction) {
            (Element::Plane, Side::Towards(to), Some(normal)) => {
                let along = unit(to).map_or(0.0, |to| dot(to, normal));
                if along.abs() < LEAST_SINE {
                    return Err(no_side(self.element, to));
                }
                // p' = p - r n, the normal towards the probe
                let back = -probe.radius_mm.copysign(along);
                for k in 0..3 {
                    self.point_mm[k] += back * normal[k];
                    derivative[k][3 + k] += back;
                }
            }
            (Element::Line | Element::Line2d, Side::Towards(to), Some(d)) => {
                let to = if self.element == Element::Line2d { [to[0], to[1], 0.0] } else { to };
                let to = unit(to).unwrap_or_default();
                let along = dot(to, d);
                let across: Vector = std::array::from_fn(|k| to[k] - along * d[k]);
                let sine = norm(across);
                if sine < LEAST_SINE {
                    return Err(no_side(self.element, to));
                }
                // p' = p - r w, w the part of the direction that is square to the line:
                // dw = -(1 - w wᵀ)((d to) dd + d (to dd)) / |across|
                let w = across.map(|x| x / sine);
                for k in 0..3 {
                    self.point_mm[k] -= probe.radius_mm * w[k];
                    for (j, column) in (3..6).enumerate() {
                        let square = f64::from(k == j) - w[k] * w[j];
                        derivative[k][column] += probe.radius_mm * (along * square + d[k] * to[j]) / sine;
                    }
                }
            }
            (Element::Cone, _, Some(d)) => {
                // the apex moves by r / sin ψ; the point to the foot of the contact points, where the radius is R - r cos ψ
                let (sin, cos) = (self.apex_angle_rad.unwrap_or_default() / 2.0).sin_cos();
                for k in 0..3 {
                    self.point_mm[k] += outwards * sin * d[k];
                    derivative[k][3 + k] += outwards * sin;
                    derivative[k][8] += 0.5 * outwards * cos * d[k];
                }
                self.radius_mm = Some(larger_than_nothing(self.element, probe, self.radius_mm, outwards * cos)?);
                derivative[6][8] += 0.5 * outwards * sin;
            }
            (Element::Torus, ..) => {
                self.minor_radius_mm = Some(larger_than_nothing(self.element, probe, self.minor_radius_mm, outwards)?);
            }
            _ => self.radius_mm = Some(larger_than_nothing(self.element, probe, self.radius_mm, outwards)?),
        }
        Ok(derivative)
    }
}

/// The radius less what the probe adds, which must leave something.
fn larger_than_nothing(element: Element, probe: &Probe, radius_mm: Option<f64>, less_mm: f64) -> Result<f64> {
    let centres = radius_mm.unwrap_or_default();
    let radius = centres - less_mm;
    if radius > 0.0 {
        return Ok(radius);
    }
    Err(refuse(
        format!("a probe of radius {} mm cannot have touched the {element} from outside", probe.radius_mm),
        format!("centres farther out than the probe radius; theirs is {centres:.6} mm"),
        "state the other side: the probe was inside",
    ))
}

fn no_side(element: Element, to: Vector) -> crate::base::message::Problems {
    refuse(
        format!("the direction {to:?} to the probe runs along the {element} and does not give a side"),
        format!("a direction away from the {element}"),
        "state the direction from what was touched to the probe",
    )
}

type Matrix = [[f64; QUANTITIES]; QUANTITIES];

fn identity() -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| f64::from(i == j)))
}

fn transposed(a: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..QUANTITIES).map(|k| a[i][k] * b[k][j]).sum()))
}

//! What `etalon fit` answers: an element, the probe, and the values that a file states.

use super::Termination;
use etalon_base::message::Message;
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::warning;
use etalon_fit::{Compensation, Element, Enclosing, Fit, MinimumZone, Side};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// One fitted element.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FitDocument {
    /// `etalon/fit/1`
    pub schema: String,
    /// Name of the element.
    pub element: String,
    /// Label of its points, where there is one fit for each.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub label: Option<String>,
    /// Number of points.
    pub points: usize,
    /// Centre of a circle, sphere or torus.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub center_mm: Option<Vector>,
    /// Point of a line, plane, cylinder or cone: the foot of the centroid.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub point_mm: Option<Vector>,
    /// Apex of a cone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub apex_mm: Option<Vector>,
    /// Unit normal of a plane, circle or torus.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub normal: Option<Vector>,
    /// Unit axis of a line, cylinder or cone (a cone's towards increasing radius).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axis: Option<Vector>,
    /// Radius; of a cone at its point, of a torus the one of its centre line.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radius_mm: Option<f64>,
    /// Radius of the tube of a torus.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub minor_radius_mm: Option<f64>,
    /// Full angle of a cone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub apex_angle_deg: Option<f64>,
    /// Root mean square of the orthogonal distances.
    pub rms_mm: f64,
    /// Largest orthogonal distance.
    pub max_mm: f64,
    /// Peak to valley.
    pub form_mm: f64,
    /// How much of the circumference has points.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub coverage_deg: Option<f64>,
    /// The points that hold a minimum zone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contacts: Option<FitContacts>,
    /// Of a circle in space by minimum zone: the plane that its roundness is measured in.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flatness: Option<FitFlatness>,
    /// From the residuals; absent without redundancy.
    pub standard_uncertainty: Option<FitUncertainty>,
    /// Where the points are probe centres: the probe, and the fit before compensation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub probe: Option<FitProbe>,
    /// What the file states of the feature.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stated: Option<FitStated>,
    /// How it was found.
    pub solver: FitSolver,
    /// Warnings with what to do.
    pub messages: Vec<Message>,
}

/// Standard uncertainties (k = 1) of the quantities of a fit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FitUncertainty {
    /// Of the point or centre, in its most uncertain direction.
    pub point_mm: f64,
    /// Of the normal or axis, about its most uncertain direction.
    pub direction_deg: Option<f64>,
    /// Of the radius.
    pub radius_mm: Option<f64>,
    /// Of the radius of the tube.
    pub minor_radius_mm: Option<f64>,
    /// Of the full angle of a cone.
    pub apex_angle_deg: Option<f64>,
}

/// The points that hold a minimum zone, numbered from 1 in the order they were read.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FitContacts {
    /// On the side of the normal, to the left of a line, or on the outer circle, sphere, cylinder or cone.
    pub upper: Vec<usize>,
    /// On the other side, or on the inner one.
    pub lower: Vec<usize>,
    /// Whether it was proved that no other place has a narrower zone.
    pub verified: bool,
    /// What was proved: `global` (no other element of the kind has a narrower zone), `local` (no neighbouring one has) or
    /// `none`.
    pub proof: ZoneProof,
    /// Of a sphere, cylinder or cone: Lagrange multipliers of `upper` and `lower`, in their order. They are positive (zero for a
    /// contact that is not needed), one in sum on each side, and the mean gradients of the distance by the parameters
    /// of the element agree (Karush-Kuhn-Tucker).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub multipliers: Option<FitMultipliers>,
}

/// What was proved of a minimum zone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ZoneProof {
    /// No other element of the kind has a narrower zone.
    Global,
    /// No neighbouring element has a narrower zone.
    Local,
    /// Nothing.
    None,
}

/// Lagrange multipliers of contact points.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FitMultipliers {
    /// Of the upper or outer points.
    pub upper: Vec<f64>,
    /// Of the lower or inner points.
    pub lower: Vec<f64>,
}

/// The minimum zone of the plane that a circle in space lies in.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FitFlatness {
    /// Its width.
    pub flatness_mm: f64,
    /// The points that hold it.
    pub contacts: FitContacts,
}

impl FitContacts {
    fn new(found: &MinimumZone) -> Self {
        let numbered = |points: &[usize]| points.iter().map(|i| i + 1).collect();
        let proof = match (found.verified, &found.multipliers) {
            (true, _) => ZoneProof::Global,
            (false, Some(_)) => ZoneProof::Local,
            (false, None) => ZoneProof::None,
        };
        let multipliers =
            found.multipliers.as_ref().map(|m| FitMultipliers { upper: m.upper.clone(), lower: m.lower.clone() });
        Self {
            upper: numbered(&found.upper),
            lower: numbered(&found.lower),
            verified: found.verified,
            proof,
            multipliers,
        }
    }
}

/// How a fit was found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FitSolver {
    /// Algorithm.
    pub method: String,
    /// Steps taken; 0 where the solution is closed.
    pub iterations: usize,
    /// Why it stopped.
    pub termination: Termination,
    /// Equations minus parameters.
    pub degrees_of_freedom: usize,
    /// Condition number of the Jacobian with columns of length one.
    pub condition: Option<f64>,
}

impl FitDocument {
    /// What a least-squares fit found.
    pub fn new(label: Option<String>, fit: &Fit) -> Self {
        let centred = matches!(fit.element, Element::Circle2d | Element::Circle3d | Element::Sphere | Element::Torus);
        let has_normal = matches!(fit.element, Element::Plane | Element::Circle3d | Element::Torus);
        let uncertainty = fit.standard_uncertainty().map(|u| FitUncertainty {
            point_mm: u.point_largest_mm,
            direction_deg: u.direction_rad.map(f64::to_degrees),
            radius_mm: u.radius_mm,
            minor_radius_mm: u.minor_radius_mm,
            apex_angle_deg: u.apex_angle_rad.map(f64::to_degrees),
        });
        Self {
            schema: "etalon/fit/1".to_owned(),
            element: fit.element.name().to_owned(),
            label,
            points: fit.points,
            center_mm: centred.then_some(fit.point_mm),
            point_mm: (!centred).then_some(fit.point_mm),
            apex_mm: fit.apex_mm(),
            normal: fit.direction.filter(|_| has_normal),
            axis: fit.direction.filter(|_| !has_normal),
            radius_mm: fit.radius_mm,
            minor_radius_mm: fit.minor_radius_mm,
            apex_angle_deg: fit.apex_angle_rad.map(f64::to_degrees),
            rms_mm: fit.rms_mm(),
            max_mm: fit.max_mm(),
            form_mm: fit.form_mm(),
            coverage_deg: fit.coverage_deg(),
            contacts: None,
            flatness: None,
            standard_uncertainty: uncertainty,
            probe: fit.compensation.as_ref().map(FitProbe::new),
            stated: None,
            solver: FitSolver {
                method: fit.method.to_owned(),
                iterations: fit.iterations,
                termination: fit.termination.into(),
                degrees_of_freedom: fit.degrees_of_freedom,
                condition: Some(fit.condition).filter(|c| c.is_finite()),
            },
            messages: fit.warnings.clone(),
        }
    }

    /// A smallest enclosing circle or sphere: its residuals are distances from the centre minus the radius.
    pub fn enclosing(element: &str, label: Option<String>, points: &[Vector], found: &Enclosing) -> Self {
        let residuals: Vec<f64> = points.iter().map(|p| norm(minus(*p, found.center_mm)) - found.radius_mm).collect();
        let depth = -residuals.iter().fold(0.0f64, |m, r| m.min(*r));
        let method = format!("smallest enclosing, held by {} points", found.support.len());
        Self {
            center_mm: Some(found.center_mm),
            radius_mm: Some(found.radius_mm),
            // rounding of the distance of the farthest point is not a form deviation
            max_mm: depth,
            form_mm: depth,
            ..Self::of_extremes(element, label, &residuals, method, found.iterations)
        }
    }

    /// A minimum zone: its residuals are distances from the middle of the zone.
    pub fn minimum_zone(label: Option<String>, found: &MinimumZone) -> Self {
        use Element::{Circle2d, Circle3d, Plane, Sphere};
        let centred = matches!(found.element, Circle2d | Circle3d | Sphere);
        let has_normal = matches!(found.element, Plane | Circle3d);
        let contacts = FitContacts::new(found);
        let unproved = || {
            let element = found.element;
            match contacts.proof {
                ZoneProof::Local => warning!("zone-proved-locally", element),
                _ => warning!("zone-unproved", element),
            }
        };
        Self {
            center_mm: centred.then_some(found.point_mm),
            point_mm: (!centred).then_some(found.point_mm),
            apex_mm: found.apex_mm(),
            normal: found.direction.filter(|_| has_normal),
            axis: found.direction.filter(|_| !has_normal),
            radius_mm: found.radius_mm,
            apex_angle_deg: found.apex_angle_rad.map(f64::to_degrees),
            form_mm: found.form_mm,
            flatness: found
                .plane
                .as_deref()
                .map(|plane| FitFlatness { flatness_mm: plane.form_mm, contacts: FitContacts::new(plane) }),
            messages: (!found.verified).then(unproved).into_iter().collect(),
            contacts: Some(contacts),
            ..Self::of_extremes(
                found.element.name(),
                label,
                &found.residuals_mm,
                "minimum zone (Chebyshev)".to_owned(),
                found.iterations,
            )
        }
    }

    /// An element that few extreme points hold: without uncertainty from the scatter of the others.
    fn of_extremes(element: &str, label: Option<String>, residuals: &[f64], method: String, iterations: usize) -> Self {
        let (low, high) = residuals.iter().fold((0.0f64, 0.0f64), |(low, high), r| (low.min(*r), high.max(*r)));
        let squares: f64 = residuals.iter().map(|r| r * r).sum();
        Self {
            schema: "etalon/fit/1".to_owned(),
            element: element.to_owned(),
            label,
            points: residuals.len(),
            center_mm: None,
            point_mm: None,
            apex_mm: None,
            normal: None,
            axis: None,
            radius_mm: None,
            minor_radius_mm: None,
            apex_angle_deg: None,
            rms_mm: (squares / residuals.len().max(1) as f64).sqrt(),
            max_mm: high.max(-low),
            form_mm: high - low,
            coverage_deg: None,
            contacts: None,
            flatness: None,
            standard_uncertainty: None,
            probe: None,
            stated: None,
            solver: FitSolver {
                method,
                iterations,
                termination: Termination::StepVanished,
                degrees_of_freedom: 0,
                condition: None,
            },
            messages: Vec::new(),
        }
    }
}

/// The probe whose centres were fitted, and the fit before compensation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FitProbe {
    /// Radius of the probe.
    pub radius_mm: f64,
    /// `inside`, `outside` or `towards`.
    pub side: String,
    /// For a plane or line the direction from it to the probe.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub towards: Option<Vector>,
    /// What the side was derived from, where the file states it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub side_from: Option<String>,
    /// Point or centre before compensation.
    pub uncompensated_point_mm: Vector,
    /// Radius before compensation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub uncompensated_radius_mm: Option<f64>,
    /// Radius of the tube of a torus before compensation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub uncompensated_minor_radius_mm: Option<f64>,
}

impl FitProbe {
    /// What a fit was compensated by.
    pub fn new(compensation: &Compensation) -> Self {
        let (side, towards) = match compensation.probe.side {
            Side::Inside => ("inside", None),
            Side::Outside => ("outside", None),
            Side::Towards(d) => ("towards", Some(d)),
        };
        Self {
            radius_mm: compensation.probe.radius_mm,
            side: side.to_owned(),
            towards,
            side_from: None,
            uncompensated_point_mm: compensation.point_mm,
            uncompensated_radius_mm: compensation.radius_mm,
            uncompensated_minor_radius_mm: compensation.minor_radius_mm,
        }
    }
}

/// What a file states of a feature, and how far the fit is from it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FitStated {
    /// Id of the feature in the file.
    pub id: String,
    /// Stated location or point of the axis.
    pub point_mm: Option<Vector>,
    /// Stated normal or direction.
    pub direction: Option<Vector>,
    /// Stated radius.
    pub radius_mm: Option<f64>,
    /// Stated radius of the tube of a torus.
    pub minor_radius_mm: Option<f64>,
    /// Stated full angle of a cone.
    pub apex_angle_deg: Option<f64>,
    /// Distance of the stated point from the fitted centre, axis, line or plane.
    pub point_apart_mm: Option<f64>,
    /// Angle between stated and fitted direction.
    pub direction_apart_deg: Option<f64>,
    /// Fitted less stated radius.
    pub radius_less_stated_mm: Option<f64>,
    /// Fitted less stated radius of the tube.
    pub minor_radius_less_stated_mm: Option<f64>,
    /// Fitted less stated full angle.
    pub apex_angle_less_stated_deg: Option<f64>,
}

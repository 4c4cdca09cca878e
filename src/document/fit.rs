//! What `etalon fit` answers.

use super::{FitProbe, FitStated};
use crate::fit::{Element, Enclosing, Fit};
use crate::message::Message;
use crate::pose::{Vector, minus, norm};
use crate::solve::Termination;
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
            standard_uncertainty: uncertainty,
            probe: fit.compensation.as_ref().map(FitProbe::new),
            stated: None,
            solver: FitSolver {
                method: fit.method.to_owned(),
                iterations: fit.iterations,
                termination: fit.termination,
                degrees_of_freedom: fit.degrees_of_freedom,
                condition: Some(fit.condition).filter(|c| c.is_finite()),
            },
            messages: fit.warnings.clone(),
        }
    }

    /// A smallest enclosing circle or sphere: its residuals are distances from the centre minus the radius.
    pub fn enclosing(element: &str, label: Option<String>, points: &[Vector], found: &Enclosing) -> Self {
        let residuals: Vec<f64> = points.iter().map(|p| norm(minus(*p, found.center_mm)) - found.radius_mm).collect();
        let smallest = residuals.iter().fold(0.0f64, |m, r| m.min(*r));
        let squares: f64 = residuals.iter().map(|r| r * r).sum();
        Self {
            schema: "etalon/fit/1".to_owned(),
            element: element.to_owned(),
            label,
            points: points.len(),
            center_mm: Some(found.center_mm),
            point_mm: None,
            apex_mm: None,
            normal: None,
            axis: None,
            radius_mm: Some(found.radius_mm),
            minor_radius_mm: None,
            apex_angle_deg: None,
            rms_mm: (squares / points.len().max(1) as f64).sqrt(),
            max_mm: -smallest,
            form_mm: -smallest,
            coverage_deg: None,
            standard_uncertainty: None,
            probe: None,
            stated: None,
            solver: FitSolver {
                method: format!("smallest enclosing, held by {} points", found.support.len()),
                iterations: found.iterations,
                termination: Termination::StepVanished,
                degrees_of_freedom: 0,
                condition: None,
            },
            messages: Vec::new(),
        }
    }
}

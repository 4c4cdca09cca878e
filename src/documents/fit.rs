//! Answer of `etalon fit`: an element, the probe, and the values that a file contains.

use super::Termination;
use crate::worded::worded;
use etalon_base::catalogue::Phrase;
use etalon_base::message::Message;
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::worded::Worded;
use etalon_base::{phrase, warning};
use etalon_fit::{Compensation, Element, ElementGeometry, Enclosing, Fit, MinimumZone, RobustElement, Side};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// One fitted element.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FitDocument {
    /// Schema and version: `etalon/fit/1`.
    pub schema: String,
    /// Name of the element.
    pub element: String,
    /// Label of the points, if each label is fitted separately.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub label: Option<String>,
    /// Number of points.
    pub points: usize,
    /// Position, direction and size of the element.
    #[serde(flatten)]
    pub geometry: FitGeometry,
    /// Distances of the points from the element.
    #[serde(flatten)]
    pub deviations: FitDeviations,
    /// Numbers of the points that a robust fit excludes, from 1; absent without `--robust`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub set_aside: Option<Vec<usize>>,
    /// Standard uncertainties from the residuals or from the stated uncertainty of the points;
    /// absent without redundancy.
    pub standard_uncertainty: Option<FitUncertainty>,
    /// Probe and fit before compensation, if the points are probe centres.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub probe: Option<FitProbe>,
    /// Values that the file contains for the feature.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stated: Option<FitStated>,
    /// Solver and its termination.
    pub solver: FitSolver,
    /// Warnings with hints.
    pub messages: Vec<Message>,
}

/// Position, direction and size of an element; values that its kind does not have are absent.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FitGeometry {
    /// Centre of a circle, sphere or torus.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub center_mm: Option<Vector>,
    /// Point of a line, plane, cylinder or cone: foot of the perpendicular from the centroid.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub point_mm: Option<Vector>,
    /// Apex of a cone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub apex_mm: Option<Vector>,
    /// Unit normal of a plane, circle or torus.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub normal: Option<Vector>,
    /// Unit axis of a line, cylinder or cone. The axis of a cone points towards increasing radius.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axis: Option<Vector>,
    /// Radius. For a cone the radius at `point_mm`, for a torus the radius of the centre line.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radius_mm: Option<f64>,
    /// Radius of the tube of a torus.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub minor_radius_mm: Option<f64>,
    /// Full angle of a cone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub apex_angle_deg: Option<f64>,
}

impl FitGeometry {
    fn new(element: Element, geometry: &ElementGeometry) -> Self {
        let centred = matches!(element, Element::Circle2d | Element::Circle3d | Element::Sphere | Element::Torus);
        let has_normal = matches!(element, Element::Plane | Element::Circle3d | Element::Torus);
        Self {
            center_mm: centred.then_some(geometry.point_mm),
            point_mm: (!centred).then_some(geometry.point_mm),
            apex_mm: geometry.apex_mm(),
            normal: geometry.direction.filter(|_| has_normal),
            axis: geometry.direction.filter(|_| !has_normal),
            radius_mm: geometry.radius_mm,
            minor_radius_mm: geometry.minor_radius_mm,
            apex_angle_deg: geometry.apex_angle_rad.map(f64::to_degrees),
        }
    }
}

/// Distances of the points from an element.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FitDeviations {
    /// Root mean square of the orthogonal distances; for a circle in space by projection, of the
    /// distances within its plane.
    pub rms_mm: f64,
    /// Largest of these distances.
    pub max_mm: f64,
    /// Form deviation, peak to valley; for a line in space, or a circle by orthogonal distances,
    /// the diameter of the enclosing tube.
    pub form_mm: f64,
    /// Arc of the circumference that is covered by points.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub coverage_deg: Option<f64>,
    /// Contact points of a minimum zone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contacts: Option<FitContacts>,
    /// For a minimum-zone circle in space: flatness of the plane in which roundness is measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flatness: Option<FitFlatness>,
}

/// Standard uncertainties (k = 1) of the quantities of a fit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FitUncertainty {
    /// Standard uncertainty of the point or centre in its most uncertain direction.
    pub point_mm: f64,
    /// Standard uncertainty of the normal or axis about its most uncertain direction.
    pub direction_deg: Option<f64>,
    /// Standard uncertainty of the radius.
    pub radius_mm: Option<f64>,
    /// Standard uncertainty of the radius of the tube.
    pub minor_radius_mm: Option<f64>,
    /// Standard uncertainty of the full angle of a cone.
    pub apex_angle_deg: Option<f64>,
    /// Coverage factor of the expanded uncertainties (95 %): Student's t with the degrees of
    /// freedom (GUM G.3), 2 for a stated uncertainty of the points.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coverage_factor: Option<f64>,
}

/// Contact points of a minimum zone, numbered from 1 in the order of reading.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FitContacts {
    /// Contacts on the side of the normal, to the left of a line, or on the outer circle, sphere,
    /// cylinder or cone.
    pub upper: Vec<usize>,
    /// Contacts on the opposite side, or on the inner element.
    pub lower: Vec<usize>,
    /// `true` if the zone is proved to be the narrowest of all.
    pub verified: bool,
    /// Extent of the proof: `global` (narrowest of all elements of the kind), `local` (narrowest
    /// among neighbouring elements) or `none`.
    pub proof: ZoneProof,
    /// For a sphere, cylinder or cone: Lagrange multipliers of `upper` and `lower`, in the same
    /// order. They are non-negative (zero for a redundant contact) and sum to one on each side; the
    /// weighted gradients of the distance with respect to the element's parameters are equal on
    /// both sides (Karush-Kuhn-Tucker).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub multipliers: Option<FitMultipliers>,
}

/// Extent of the proof of a minimum zone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ZoneProof {
    /// The zone is the narrowest of all elements of the kind.
    Global,
    /// The zone is the narrowest among neighbouring elements.
    Local,
    /// Nothing was proved.
    None,
}

/// Lagrange multipliers of contact points.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FitMultipliers {
    /// Multipliers of the upper or outer points.
    pub upper: Vec<f64>,
    /// Multipliers of the lower or inner points.
    pub lower: Vec<f64>,
}

/// Minimum zone of the plane of a circle in space.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FitFlatness {
    /// Width of the zone.
    pub flatness_mm: f64,
    /// Contact points of the zone.
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

/// Solver of a fit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FitSolver {
    /// Algorithm.
    #[serde(flatten, with = "FitSolverMethod")]
    pub method: Worded,
    /// Number of steps; 0 for closed-form solutions.
    pub iterations: usize,
    /// Reason of the termination.
    pub termination: Termination,
    /// Equations minus parameters.
    pub degrees_of_freedom: usize,
    /// Condition number of the Jacobian with columns scaled to unit length.
    pub condition: Option<f64>,
}

worded! {
    /// Algorithm.
    text FitSolverMethod: method, method_phrase
}

impl FitDocument {
    /// Creates the document of a least-squares fit.
    pub fn new(fit: &Fit) -> Self {
        let uncertainty = fit.standard_uncertainty().map(|u| FitUncertainty {
            point_mm: u.point_largest_mm,
            direction_deg: u.direction_rad.map(f64::to_degrees),
            radius_mm: u.radius_mm,
            minor_radius_mm: u.minor_radius_mm,
            apex_angle_deg: u.apex_angle_rad.map(f64::to_degrees),
            coverage_factor: fit.precision.coverage_factor(),
        });
        Self {
            schema: "etalon/fit/1".to_owned(),
            element: fit.element.name().to_owned(),
            label: None,
            points: fit.points,
            geometry: FitGeometry::new(fit.element, &fit.geometry),
            deviations: FitDeviations {
                rms_mm: fit.rms_mm(),
                max_mm: fit.max_mm(),
                form_mm: fit.form_mm(),
                coverage_deg: fit.coverage_deg(),
                ..FitDeviations::default()
            },
            set_aside: None,
            standard_uncertainty: uncertainty,
            probe: fit.compensation.as_ref().map(FitProbe::new),
            stated: None,
            solver: FitSolver {
                method: fit.solver.method.clone().into(),
                iterations: fit.solver.iterations,
                termination: fit.solver.termination.into(),
                degrees_of_freedom: fit.precision.degrees_of_freedom,
                condition: Some(fit.condition).filter(|c| c.is_finite()),
            },
            messages: fit.warnings.clone(),
        }
    }

    /// Creates the document of a least-squares fit without outliers; `points` is the number of all
    /// points.
    pub fn robust(found: &RobustElement) -> Self {
        let numbers: Vec<usize> = found.set_aside.iter().map(|i| i + 1).collect();
        let mut document = Self::new(&found.fit);
        document.points += numbers.len();
        document.messages.extend(found.warning());
        document.set_aside = Some(numbers);
        document
    }

    /// Replaces the warnings by all warnings about the points and the element.
    pub fn with_messages(self, messages: Vec<Message>) -> Self {
        Self { messages, ..self }
    }

    /// Creates the document of a smallest enclosing circle or sphere. Residuals are distances from
    /// the centre minus the radius.
    pub fn enclosing(element: &str, points: &[Vector], found: &Enclosing) -> Self {
        let residuals: Vec<f64> = points.iter().map(|p| norm(minus(*p, found.center_mm)) - found.radius_mm).collect();
        let depth = -residuals.iter().fold(0.0f64, |m, r| m.min(*r));
        let method = phrase!("method-enclosing", points = found.support.len());
        let document = Self::from_extremes(element, &residuals, method, found.iterations);
        Self {
            geometry: FitGeometry {
                center_mm: Some(found.center_mm),
                radius_mm: Some(found.radius_mm),
                ..FitGeometry::default()
            },
            // rounding at the farthest point is not a form deviation
            deviations: FitDeviations { max_mm: depth, form_mm: depth, ..document.deviations },
            ..document
        }
    }

    /// Creates the document of a minimum zone. Residuals are distances from the middle of the zone.
    pub fn minimum_zone(found: &MinimumZone) -> Self {
        let contacts = FitContacts::new(found);
        let unproved = || {
            let element = found.element;
            match contacts.proof {
                ZoneProof::Local => warning!("zone-proved-locally", element),
                _ => warning!("zone-unproved", element),
            }
        };
        let (element, method) = (found.element.name(), phrase!("method-minimum-zone"));
        let document = Self::from_extremes(element, &found.residuals_mm, method, found.iterations);
        let flatness =
            |plane: &MinimumZone| FitFlatness { flatness_mm: plane.form_mm, contacts: FitContacts::new(plane) };
        Self {
            geometry: FitGeometry::new(found.element, &found.geometry),
            messages: found.warnings.iter().cloned().chain((!found.verified).then(unproved)).collect(),
            deviations: FitDeviations {
                form_mm: found.form_mm,
                flatness: found.plane.as_deref().map(flatness),
                contacts: Some(contacts),
                ..document.deviations
            },
            ..document
        }
    }

    /// Document of an element that is defined by a few extreme points; their scatter yields no
    /// uncertainty.
    fn from_extremes(element: &str, residuals: &[f64], method: Phrase, iterations: usize) -> Self {
        let (low, high) = residuals.iter().fold((0.0f64, 0.0f64), |(low, high), r| (low.min(*r), high.max(*r)));
        let squares: f64 = residuals.iter().map(|r| r * r).sum();
        Self {
            schema: "etalon/fit/1".to_owned(),
            element: element.to_owned(),
            label: None,
            points: residuals.len(),
            geometry: FitGeometry::default(),
            deviations: FitDeviations {
                rms_mm: (squares / residuals.len().max(1) as f64).sqrt(),
                max_mm: high.max(-low),
                form_mm: high - low,
                ..FitDeviations::default()
            },
            set_aside: None,
            standard_uncertainty: None,
            probe: None,
            stated: None,
            solver: FitSolver {
                method: method.into(),
                iterations,
                termination: Termination::StepVanished,
                degrees_of_freedom: 0,
                condition: None,
            },
            messages: Vec::new(),
        }
    }
}

/// Probe whose centres were fitted, and the fit before compensation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FitProbe {
    /// Radius of the probe.
    pub radius_mm: f64,
    /// `inside`, `outside` or `towards`.
    pub side: String,
    /// For a plane or line: direction from the element to the probe.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub towards: Option<Vector>,
    /// Statement of the file from which the side was derived.
    #[serde(flatten, with = "FitProbeSideFrom")]
    pub side_from: Option<Worded>,
    /// Point or centre before compensation.
    pub uncompensated_point_mm: Vector,
    /// Radius before compensation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub uncompensated_radius_mm: Option<f64>,
    /// Radius of the tube of a torus before compensation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub uncompensated_minor_radius_mm: Option<f64>,
}

worded! {
    /// Statement of the file from which the side was derived.
    option FitProbeSideFrom: side_from, side_from_phrase
}

impl FitProbe {
    /// Describes the compensation of a fit.
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

/// Values that a file contains for a feature, and their differences from the fit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FitStated {
    /// Id of the feature in the file.
    pub id: String,
    /// Given location or point of the axis.
    pub point_mm: Option<Vector>,
    /// Given normal or direction.
    pub direction: Option<Vector>,
    /// Given radius.
    pub radius_mm: Option<f64>,
    /// Given radius of the tube of a torus.
    pub minor_radius_mm: Option<f64>,
    /// Given full angle of a cone.
    pub apex_angle_deg: Option<f64>,
    /// Distance between the given point and the fitted centre, axis, line or plane.
    pub point_apart_mm: Option<f64>,
    /// Angle between the given and the fitted direction.
    pub direction_apart_deg: Option<f64>,
    /// Fitted minus given radius.
    pub radius_less_stated_mm: Option<f64>,
    /// Fitted minus given radius of the tube.
    pub minor_radius_less_stated_mm: Option<f64>,
    /// Fitted minus given full angle.
    pub apex_angle_less_stated_deg: Option<f64>,
}

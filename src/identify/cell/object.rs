//! Work object or base frame from points with known coordinates in it.

use super::slips::{AlternativeFit, explained};
use super::solve::{CellModel, Equation, UNIT, columns, moved, solve};
use super::{CellFault, CellFrame, Measure, Quality, Stated, check_points, part};
use etalon_base::pose::{Pose, Vector, centroid, cross, minus};
use etalon_fit::rotation_onto;

/// Frame of points with known coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct ObjectFrame {
    /// Frame in the frame of the measured points.
    pub frame: CellFrame,
    /// Residuals of the measured points.
    pub quality: Quality,
}

/// Change of the points that explains them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ObjectSlip {
    /// Factor of measured coordinates that are in another unit.
    Unit(f64),
    /// One coordinate (0, 1, 2) of the known points has the other sign.
    Mirrored(usize),
    /// Two points are swapped.
    Exchanged([usize; 2]),
}

#[derive(Clone)]
struct Rigid<'a> {
    known: &'a [Vector],
    measured: &'a [Vector],
    stated: &'a Stated,
    frame: Pose,
}

impl CellModel for Rigid<'_> {
    fn parameters(&self) -> usize {
        6
    }

    fn equations(&self) -> Vec<Equation> {
        let equation = |(reading, (known, measured)): (usize, (&Vector, &Vector))| {
            let lever = self.frame.rotate(*known);
            Equation {
                reading,
                measure: Measure::Position,
                residual: minus(*measured, self.frame.apply(*known)),
                columns: columns(0, |k| UNIT[k]).chain(columns(3, |k| cross(UNIT[k], lever))).collect(),
                covariance: self.stated.position(reading),
            }
        };
        self.known.iter().zip(self.measured).enumerate().map(equation).collect()
    }

    fn moved(&self, step: &[f64]) -> Self {
        Self { frame: moved(&self.frame, &step[..3], &step[3..]), ..*self }
    }
}

/// Frame that maps known points onto measured ones.
///
/// # Errors
/// Fails with fewer than three points, or points on a line.
pub fn object_frame(known: &[Vector], measured: &[Vector], stated: &Stated) -> Result<ObjectFrame, CellFault> {
    if known.len() < 3 {
        return Err(CellFault::TooFew { needed: 3, readings: known.len() });
    }
    check_points(known)?;
    check_points(measured)?;
    let (Some(from), Some(to)) = (centroid(known), centroid(measured)) else { return Err(CellFault::Undetermined) };
    let pairs = known.iter().zip(measured).map(|(a, b)| (minus(*a, from), minus(*b, to)));
    let turn = Pose { rotation: rotation_onto(pairs), translation_mm: [0.0; 3] };
    let frame = Pose { translation_mm: minus(to, turn.rotate(from)), ..turn };
    let solved = solve(Rigid { known, measured, stated, frame }, stated).ok_or(CellFault::Undetermined)?;
    let covariance = part(&solved.covariance, [0, 1, 2, 3, 4, 5]);
    Ok(ObjectFrame { frame: CellFrame { pose: solved.model.frame, covariance }, quality: solved.quality })
}

/// Factors between units that may be confused: metres, inches and micrometres taken for
/// millimetres, and millimetres taken for inches.
const UNITS: [f64; 4] = [1e3, 25.4, 1e-3, 1.0 / 25.4];
/// Maximum number of points whose exchange is tried.
const EXCHANGED: usize = 40;

/// Changes of the points that explain them, best first.
pub fn object_slips(
    known: &[Vector],
    measured: &[Vector],
    stated: &Stated,
    found: &Quality,
) -> Vec<AlternativeFit<ObjectSlip>> {
    let mut all = Vec::new();
    let mut add = |change: ObjectSlip, known: &[Vector], measured: &[Vector]| {
        if let Ok(fit) = object_frame(known, measured, stated) {
            let factor = if let ObjectSlip::Unit(factor) = change { factor } else { 1.0 };
            all.push(AlternativeFit { change, quality: fit.quality.in_unit(factor) });
        }
    };
    for factor in UNITS {
        let scaled: Vec<Vector> = measured.iter().map(|p| p.map(|v| v * factor)).collect();
        add(ObjectSlip::Unit(factor), known, &scaled);
    }
    // mirror images in any coordinate plane are equal up to a rotation
    let mirrored: Vec<Vector> = known.iter().map(|p| [p[0], p[1], -p[2]]).collect();
    add(ObjectSlip::Mirrored(2), &mirrored, measured);
    if known.len() <= EXCHANGED {
        for (a, b) in (0..known.len()).flat_map(|a| (0..a).map(move |b| (b, a))) {
            let mut exchanged = known.to_vec();
            exchanged.swap(a, b);
            add(ObjectSlip::Exchanged([a, b]), &exchanged, measured);
        }
    }
    explained(found, all)
}

//! Dependence of the attained pose on the direction of approach: multi-directional pose accuracy
//! variation vAP (ISO 9283:1998 7.2.3, unverified against a bought copy), and variation by the
//! preceding pose (not in the standard).

use crate::iso9283::pose::repeatability::{PoseRepeatability, pose_repeatability};
use crate::iso9283::pose::test::{PoseTest, TestedPose};
use crate::iso9283::statistics::sample::{mean_position, spread, unwrapped, wrapped};
use etalon_base::message::Result;
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase};

/// Variation of one pose over its approaches.
#[derive(Clone, Debug, PartialEq)]
pub struct Variation {
    /// vAP_p: largest distance between two barycentres.
    pub vap_mm: f64,
    /// Indices of the approaches with the largest distance.
    pub between: (usize, usize),
    /// Barycentre of each approach.
    pub means_mm: Vec<Vector>,
    /// Repeatability within each approach; absent with a single visit.
    pub within: Vec<Option<PoseRepeatability>>,
}

/// A pose of a test that was approached in several ways.
#[derive(Clone, Debug, PartialEq)]
pub struct PoseVariation {
    /// Name of the pose.
    pub pose: PoseName,
    /// Barycentre of all visits of the pose.
    pub mean_mm: Vector,
    /// vAP_p.
    pub vap_mm: f64,
    /// Approaches with the largest distance.
    pub between: [String; 2],
    /// vAP of each angle of the test; empty if they are not separable.
    pub angles_rad: Vec<f64>,
    /// vAP of the orientation, if angles are not separable and their order is given.
    pub rotation_rad: Option<f64>,
    /// Characteristics of each approach.
    pub approaches: Vec<Approach>,
}

/// Visits by one approach.
#[derive(Clone, Debug, PartialEq)]
pub struct Approach {
    /// Name of the approach.
    pub name: String,
    /// Number of visits.
    pub cycles: usize,
    /// Barycentre.
    pub mean_mm: Vector,
    /// Barycentre minus commanded position; absent if no position was commanded.
    pub deviation_mm: Option<Vector>,
    /// RP within this approach; absent with a single visit.
    pub rp_mm: Option<f64>,
    /// Radius of the smallest sphere (planar robots: circle) that encloses the positions; absent
    /// with a single visit.
    pub enclosing_radius_mm: Option<f64>,
}

/// Variation of all poses of a test that were approached in at least two ways.
pub fn variations(test: &PoseTest) -> Result<Vec<PoseVariation>> {
    let of_pose = |p: &TestedPose| -> Result<PoseVariation> {
        let names: Vec<String> = p.approaches().into_keys().map(str::to_owned).collect();
        let by = |name: &String| p.positions_mm(|v| v.approach.as_ref() == Some(name));
        let groups: Vec<Vec<Vector>> = names.iter().map(by).collect();
        let found = variation(&groups)?;
        let is_inseparable = test.inseparable(p).is_some();
        let turned = (0..if is_inseparable { 0 } else { test.angles.len() }).map(|k| {
            let by = |name: &String| p.angles_rad(k, |v| v.approach.as_ref() == Some(name));
            angle_variation_rad(&names.iter().map(by).collect::<Vec<_>>())
        });
        let approach = |(i, name): (usize, &String)| Approach {
            name: name.clone(),
            cycles: groups[i].len(),
            mean_mm: found.means_mm[i],
            deviation_mm: p.commanded_mm.map(|commanded| minus(found.means_mm[i], commanded)),
            rp_mm: found.within[i].map(|w| w.rp_mm),
            enclosing_radius_mm: found.within[i].map(|w| w.enclosing_radius_mm),
        };
        Ok(PoseVariation {
            pose: p.pose,
            mean_mm: mean_position(&p.positions_mm(|_| true)),
            vap_mm: found.vap_mm,
            between: [names[found.between.0].clone(), names[found.between.1].clone()],
            angles_rad: turned.collect(),
            rotation_rad: is_inseparable.then(|| test.rotation_variation_rad(p, &names)).flatten(),
            approaches: names.iter().enumerate().map(approach).collect(),
        })
    };
    test.poses.iter().filter(|p| p.approaches().len() > 1).map(of_pose).collect()
}

/// Variation over at least two approaches, each with at least one position (the standard has three
/// approaches at right angles with 30 cycles each).
pub fn variation(approaches_mm: &[Vec<Vector>]) -> Result<Variation> {
    if approaches_mm.len() < 2 {
        let of = phrase!("characteristic", name = "variation");
        return Err(
            error!("too-few-of", of, sets = phrase!("approaches", count = approaches_mm.len()), least = 2).into()
        );
    }
    for points in approaches_mm {
        crate::iso9283::statistics::sample::positions(points, 1, "variation")?;
    }
    let means_mm: Vec<Vector> = approaches_mm.iter().map(|points| mean_position(points)).collect();
    let (vap_mm, between) = farthest(means_mm.len(), |h, k| norm(minus(means_mm[h], means_mm[k])));
    let within = approaches_mm.iter().map(|points| match points.len() {
        1 => Ok(None),
        _ => pose_repeatability(points).map(Some),
    });
    Ok(Variation { vap_mm, between, within: within.collect::<Result<_>>()?, means_mm })
}

/// vAP_a, vAP_b or vAP_c (rad).
pub fn angle_variation_rad(approaches_rad: &[Vec<f64>]) -> f64 {
    let means: Vec<f64> = approaches_rad.iter().map(|angles| spread(&unwrapped(angles)).mean).collect();
    farthest(means.len(), |h, k| wrapped(means[h] - means[k]).abs()).0
}

/// Largest value of `distance(h, k)` over all pairs, and the first pair with that value.
pub(crate) fn farthest(count: usize, distance: impl Fn(usize, usize) -> f64) -> (f64, (usize, usize)) {
    let pairs = (0..count).flat_map(|h| (h + 1..count).map(move |k| (h, k)));
    pairs.map(|(h, k)| (distance(h, k), (h, k))).fold((0.0, (0, 0)), |a, b| if b.0 > a.0 { b } else { a })
}

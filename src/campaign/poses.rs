//! `[poses]` and `[compliance]`: tests of ISO 9283 whose measurements come as tables, as `etalon iso9283` takes them.

use serde::Deserialize;
use toml::Spanned;

/// Attained and commanded poses. All tables are in one frame of their own.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PosesDefinition {
    /// Attained poses: `pose,cycle,x_mm,y_mm[,z_mm][,a_deg][,b_deg][,c_deg][,approach][,robot][,reading]`.
    pub attained: Spanned<String>,
    /// Commanded poses: the same coordinates without `cycle`.
    pub commanded: Spanned<String>,
    /// Reference targets that stand still, measured from time to time: `cycle,target,x_mm,y_mm[,z_mm]`.
    pub reference: Option<Spanned<String>>,
    /// Cycles of one set of a drift test.
    pub drift_set: Option<Spanned<usize>>,
    /// Order of the rotations a, b, c, e.g. `Rz(c) Ry(b) Rx(a)`.
    pub rotation_order: Option<String>,
    /// Seed of the bootstrap intervals.
    #[serde(default = "seed")]
    pub seed: u64,
}

fn seed() -> u64 {
    1
}

/// A loaded robot.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ComplianceDefinition {
    /// `direction,cycle,force_n,x_mm,y_mm[,z_mm]`, in each direction and cycle a row of force 0.
    pub file: Spanned<String>,
}

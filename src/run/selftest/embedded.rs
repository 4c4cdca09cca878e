//! Reference data and campaigns that are part of the program.

/// Names and texts of the reference values.
pub(super) const FILES: [(&str, &str); 4] = [
    ("fits", include_str!("data/fits.json")),
    ("iso9283", include_str!("data/iso9283.json")),
    ("kinematics", include_str!("data/kinematics.json")),
    ("published", include_str!("data/published.json")),
];

/// SHA-256 of all embedded files by name.
pub(super) const SHA256: &str = include_str!("data/sha256.txt");

macro_rules! sample {
    ($($name:literal),*) => {
        [$(($name, include_str!(concat!("../../../samples/prexyt-cmm/", $name)))),*]
    };
}

/// Files of the embedded campaign (synthetic, thesis table 3.3).
pub(super) const SAMPLE: [(&str, &str); 6] =
    sample!["campaign.toml", "encoders.csv", "robot.toml", "truth.toml", "exports/poses.txt", "exports/world.txt"];

macro_rules! campaigns {
    ($($name:literal: $($more:literal),*;)*) => {
        [$((
            $name,
            include_str!(concat!("../../../samples/reference/", $name, "/certified.json")),
            &[
                ("campaign.toml", include_str!(concat!("../../../samples/reference/", $name, "/campaign.toml"))),
                ("observations.csv", include_str!(concat!("../../../samples/reference/", $name, "/observations.csv"))),
                ("robot.toml", include_str!(concat!("../../../samples/reference/", $name, "/robot.toml"))),
                $(($more, include_str!(concat!("../../../samples/reference/", $name, "/", $more))),)*
            ]
        )),*]
    };
}

/// A campaign: name, certified values, files.
type Campaign = (&'static str, &'static str, &'static [(&'static str, &'static str)]);

/// The embedded campaigns.
pub(super) const CAMPAIGNS: &[Campaign] = &campaigns![
    "delta":;
    "five-bar":;
    "hexapod":;
    "prexyt-clean":;
    "prexyt-priors":;
    "prexyt-rank-deficient":;
    "serial-dh":;
    "serial-dh-priors":;
    "serial-mdh-blunder":;
    "serial-mdh-contacts":;
    "serial-poe-distances":;
    "urdf-poses": "arm.urdf";
];

//! What parameters mean: every model explains and draws its own.

use crate::support::root;
use etalon::campaign::read_robot;
use etalon::robots::{Quantity, Role};

#[test]
fn every_parameter_has_a_meaning_and_every_length_that_is_drawn_is_in_a_sketch() {
    let root = root();
    for (file, apart) in [
        ("samples/prexyt-cmm/robot.toml", false),
        ("samples/dextar/robot.toml", false),
        ("samples/hexapod/robot.toml", true),
        ("samples/delta/robot.toml", true),
        ("samples/abb-irb120/robot.toml", false),
        ("samples/column-arm/robot.toml", true),
    ] {
        let robot = read_robot(&root.join(file)).unwrap().build(&["T".to_owned()]).unwrap();
        let without: Vec<_> = robot.parameters().iter().filter(|p| p.meaning.is_empty()).map(|p| &p.name).collect();
        assert!(without.is_empty(), "{file}: {without:?}");
        let sketches = robot.sketches();
        let places = sketches.iter().flat_map(|s| &s.strokes).flat_map(|s| &s.points_mm).flatten();
        assert!(!sketches.is_empty() && places.clone().count() > 20 && places.clone().all(|v| v.is_finite()), "{file}");
        let named =
            |name: &str| sketches.iter().flat_map(|s| &s.strokes).any(|s| s.name.split(" + ").any(|n| n == name));
        // legs are alike: the first is drawn for all
        let drawn = |name: &str| !apart || name.ends_with("_1") || name.starts_with("leg1_");
        let lengths = robot
            .parameters()
            .iter()
            .filter(|p| p.quantity == Quantity::Length && p.role == Role::Robot && p.nominal != 0.0 && drawn(&p.name));
        let missing: Vec<_> = lengths.filter(|p| !named(&p.name)).map(|p| &p.name).collect();
        assert!(missing.is_empty(), "{file}: {missing:?}");
    }
}

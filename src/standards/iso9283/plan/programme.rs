//! Test programme: poses, loads, velocities and cycles for each characteristic (ISO 9283:1998 6 and
//! table 7).

/// One line of the test programme.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// Tested characteristic.
    pub characteristic: String,
    /// Clause of the standard.
    pub clause: String,
    /// Poses of a cycle in order, or the path.
    pub visits: String,
    /// Velocities (% of the rated velocity).
    pub velocities_percent: Vec<u32>,
    /// Number of cycles for each velocity.
    pub cycles: u32,
    /// `true` if the line was verified against the standard's text, `false` if it is general
    /// knowledge.
    pub read: bool,
}

/// Loads (% of the rated load): the first is mandatory, the second optional (read).
pub const LOADS_PERCENT: [u32; 2] = [100, 10];

/// Test programme; drift takes eight hours, in sets of ten cycles.
pub fn programme() -> Vec<Item> {
    let item = |characteristic: &str, clause: &str, visits: &str, cycles: u32, read: bool| Item {
        characteristic: characteristic.to_owned(),
        clause: clause.to_owned(),
        visits: visits.to_owned(),
        velocities_percent: vec![100, 50, 10],
        cycles,
        read,
    };
    vec![
        item("pose accuracy AP and repeatability RP", "7.2.1, 7.2.2", "P5 P4 P3 P2 P1", 30, true),
        item("multi-directional pose accuracy variation vAP", "7.2.3", "P4 P2 P1, from three directions", 30, false),
        item("distance accuracy AD and repeatability RD", "7.3", "P4 P2", 30, false),
        item("position stabilisation time, overshoot OV", "7.4, 7.5", "P5 P4 P3 P2 P1", 3, false),
        Item { velocities_percent: vec![100], ..item("drift dAP, dRP", "7.6", "P2 P1, sets of 10 for 8 h", 10, false) },
        Item {
            velocities_percent: vec![100],
            ..item("exchangeability E", "7.7", "P5 P4 P3 P2 P1, five robots", 30, false)
        },
        item("path accuracy AT and repeatability RT", "8.2, 8.3", "linear, circle-large, circle-small", 10, false),
        item("path accuracy on reorientation", "8.4", "reorientation", 10, false),
        item("cornering CR, CO", "8.5", "rectangle", 3, false),
        item("path velocity AV, RV, FV", "8.6", "linear", 10, false),
        item("minimum posing time", "9", "posing", 3, false),
        Item {
            velocities_percent: Vec::new(),
            ..item("static compliance", "10", "P1, ±x ±y ±z, steps of 10 % load", 3, false)
        },
        item("weaving WS, WF", "11", "in the test plane", 3, false),
    ]
}

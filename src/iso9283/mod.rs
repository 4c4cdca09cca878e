//! Characteristics of ISO 9283:1998, one a file, each with its clause. Plain positions and angles come in; nothing here
//! knows a file, a campaign or a column.
//!
//! What each formula rests on. *Read*: in an excerpt of the standard and reproduced from data that others evaluated.
//! *Unverified*: general knowledge of the standard, to be compared with a bought copy before anybody claims conformity.
//!
//! | characteristic | clause | file | rests on |
//! | --- | --- | --- | --- |
//! | pose accuracy AP | 7.2.1 | [`accuracy`] | thesis eq. 1.1 to 1.6; clause unverified |
//! | pose repeatability RP | 7.2.2 | [`repeatability`] | read; thesis eq. 1.7 to 1.12 |
//! | multi-directional pose accuracy variation vAP | 7.2.3 | [`directions`] | unverified |
//! | distance accuracy AD and repeatability RD | 7.3 | [`distance`] | unverified |
//! | position stabilisation time | 7.4 | [`stabilisation`] | unverified |
//! | position overshoot OV | 7.5 | [`overshoot`] | unverified |
//! | drift dAP, dRP | 7.6 | [`drift`] | unverified |
//! | exchangeability E | 7.7 | [`exchangeability`] | unverified |
//! | path accuracy AT, on reorientation | 8.2, 8.4 | [`path_accuracy`] | unverified |
//! | path repeatability RT | 8.3 | [`path_repeatability`] | unverified |
//! | cornering CR, CO | 8.5 | [`cornering`] | unverified |
//! | path velocity AV, RV, FV | 8.6 | [`path_velocity`] | unverified |
//! | minimum posing time | 9 | [`posing_time`] | unverified |
//! | static compliance | 10 | [`compliance`] | unverified |
//! | weaving WS, WF | 11 | [`weaving`] | unverified |
//! | cube, test plane, poses, paths, cycles | 6 | [`layout`], [`programme`] | poses, loads, velocities and 30 cycles read |
//! | uncertainty at most 25 % of the characteristic | 6 | [`uncertainty_ratio`] | unverified |
//!
//! Not of the standard: smallest enclosing sphere and circle beside mean + 3 s ([`repeatability`]), intervals of AP and RP
//! ([`interval`], [`bootstrap`]) and of AT and RT ([`path_bootstrap`]), conformity with a limit ([`conformity`]), the ellipsoid of the next position
//! ([`ellipsoid`]), RP without the instrument's noise ([`noise_free`]), drift of the set-up by reference targets
//! ([`mod@reference`], [`rotations`]), spread by the pose approached from ([`directions`]), coplanarity of mean positions ([`coplanarity`],
//! thesis 2.4).
//!
//! Recorded motions ([`stream`]) are cut into standstills ([`standstill`]) and passes of a commanded path ([`path`],
//! [`passes`]).
//!
//! A planar robot has z = 0 throughout. Angles are rotations about a, b, c in an order that the caller states; the
//! formulas treat each alone. They are unwrapped about their first value, so a test may straddle ±180°.

pub mod accuracy;
pub mod bootstrap;
pub mod compliance;
pub mod conformity;
pub mod coplanarity;
pub mod cornering;
pub mod directions;
pub mod distance;
pub mod drift;
pub mod ellipsoid;
pub mod exchangeability;
pub mod interval;
pub mod layout;
pub mod noise_free;
pub mod overshoot;
pub mod passes;
pub mod path;
pub mod path_accuracy;
pub mod path_bootstrap;
pub mod path_repeatability;
pub mod path_velocity;
pub mod pose_test;
pub mod posing_time;
pub mod programme;
pub mod reference;
pub mod repeatability;
pub mod rotations;
mod sample;
mod scatter;
pub mod stabilisation;
pub mod standstill;
pub mod stream;
pub mod uncertainty_ratio;
pub mod weaving;

use crate::base::message::{Message, Result};
use crate::base::pose::{Vector, norm};

pub use sample::{Spread, spread, unwrapped, wrapped};

/// Refuses fewer than `least` positions, or one that is not finite.
fn positions(points: &[Vector], least: usize, what: &str) -> Result<()> {
    if points.len() < least {
        let message = Message::error(format!("{what}: {} attained positions", points.len()));
        return Err(message.expected(format!("at least {least}")).into());
    }
    match points.iter().position(|&p| !norm(p).is_finite()) {
        Some(i) => Err(Message::error(format!("{what}: position {} is not finite", i + 1)).into()),
        None => Ok(()),
    }
}

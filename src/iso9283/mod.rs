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
//! | drift dAP, dRP | 7.6 | [`drift`] | unverified |
//! | exchangeability E | 7.7 | [`exchangeability`] | unverified |
//! | uncertainty at most 25 % of the characteristic | 6 | [`quarter`] | unverified |
//!
//! Not of the standard: smallest enclosing sphere and circle beside mean + 3 s ([`repeatability`]), intervals of AP and RP
//! ([`interval`], [`bootstrap`]), spread by the pose approached from ([`directions`]), coplanarity of mean positions
//! ([`coplanarity`], thesis 2.4).
//!
//! A planar robot has z = 0 throughout. Angles are rotations about a, b, c in an order that the caller states; the
//! formulas treat each alone. They are unwrapped about their first value, so a test may straddle ±180°.

pub mod accuracy;
pub mod bootstrap;
pub mod coplanarity;
pub mod directions;
pub mod distance;
pub mod drift;
pub mod exchangeability;
pub mod interval;
pub mod quarter;
pub mod repeatability;
mod sample;
mod scatter;

use crate::message::{Message, Result};
use crate::pose::{Vector, norm};

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

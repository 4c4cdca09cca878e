//! Characteristics of ISO 9283:1998, one a file, each with its clause. Plain positions and angles
//! come in, plain results in millimetres and radians go out; their words and their form in
//! documents are those of another crate.
//!
//! What each formula rests on. *Read*: in an excerpt of the standard and reproduced from data that others evaluated.
//! *Unverified*: general knowledge of the standard, to be compared with a bought copy before anybody claims conformity.
//!
//! | characteristic | clause | file | rests on |
//! | --- | --- | --- | --- |
//! | pose accuracy AP | 7.2.1 | [`pose::accuracy`] | thesis eq. 1.9 to 1.12; clause unverified |
//! | pose repeatability RP | 7.2.2 | [`pose::repeatability`] | read; thesis eq. 1.1 to 1.8 |
//! | multi-directional pose accuracy variation vAP | 7.2.3 | [`pose::directions`] | unverified |
//! | distance accuracy AD and repeatability RD | 7.3 | [`pose::distance`] | unverified |
//! | position stabilisation time | 7.4 | [`motion::stabilisation`] | unverified |
//! | position overshoot OV | 7.5 | [`motion::overshoot`] | unverified |
//! | drift dAP, dRP | 7.6 | [`pose::drift`] | unverified |
//! | exchangeability E | 7.7 | [`pose::exchangeability`] | unverified |
//! | path accuracy AT, on reorientation | 8.2, 8.4 | [`path::accuracy`] | unverified |
//! | path repeatability RT | 8.3 | [`path::repeatability`] | unverified |
//! | cornering CR, CO | 8.5 | [`path::cornering`] | unverified |
//! | path velocity AV, RV, FV | 8.6 | [`path::velocity`] | unverified |
//! | minimum posing time | 9 | [`motion::posing_time`] | unverified |
//! | static compliance | 10 | [`load`] | unverified |
//! | weaving WS, WF | 11 | [`path::weaving`] | unverified |
//! | cube, test plane, poses, paths, cycles | 6 | [`plan::layout`], [`plan::programme`] | poses, loads, velocities and 30 cycles read |
//! | uncertainty at most 25 % of the characteristic | 6 | [`statistics::uncertainty_ratio`] | unverified |
//!
//! Not of the standard: smallest enclosing sphere and circle beside mean + 3 s
//! ([`pose::repeatability`]), intervals of AP and RP ([`statistics::interval`],
//! [`statistics::bootstrap`]) and of AT and RT ([`path::bootstrap`]), conformity with a limit
//! ([`crate::decision`]), the ellipsoid of the next position ([`pose::ellipsoid`]), RP without the
//! instrument's noise ([`pose::noise_free`]), drift of the set-up by reference targets
//! ([`pose::reference`], [`pose::rotations`]), spread by the pose approached from
//! ([`pose::directions`]), coplanarity of mean positions ([`pose::coplanarity`], thesis 2.4).
//!
//! Recorded motions ([`motion::stream`]) are cut into standstills ([`motion::standstill`]) and passes of a commanded path ([`path::commanded`],
//! [`path::passes`]).
//!
//! A planar robot has z = 0 throughout. Angles are rotations about a, b, c in an order that the caller states; the
//! formulas treat each alone. They are unwrapped about their first value, so a test may straddle ±180°.

pub mod load;
pub mod motion;
pub mod path;
pub mod plan;
pub mod pose;
pub mod statistics;

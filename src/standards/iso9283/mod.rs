//! Characteristics of ISO 9283:1998, one per file, each with its clause. Inputs are plain positions
//! and angles, results are in millimetres and radians; wording and documents belong to another
//! crate.
//!
//! Basis of each formula. *Read*: in an excerpt of the standard, and reproduced from data that
//! others evaluated. *Unverified*: general knowledge of the standard, to be compared with a bought
//! copy before conformity is claimed.
//!
//! | characteristic | clause | file | basis |
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
//! | cube, test plane, poses | 6 | [`plan::layout`] | poses read, others unverified |
//! | paths, loads, cycles | 6 | [`plan::programme`] | loads, velocities, 30 cycles read |
//! | uncertainty at most 25 % | 6 | [`statistics::uncertainty_ratio`] | unverified |
//!
//! Beyond the standard: smallest enclosing sphere and circle in addition to mean + 3 s
//! ([`pose::repeatability`]), intervals of AP and RP ([`statistics::interval`],
//! [`statistics::bootstrap`]) and of AT and RT ([`path::bootstrap`]), conformity with a limit
//! ([`crate::decision`]), ellipsoid of the next position ([`pose::ellipsoid`]), RP without the
//! instrument's noise ([`pose::noise_free`]), drift of the set-up by reference targets
//! ([`pose::reference`], [`pose::rotations`]), variation by the preceding pose
//! ([`pose::directions`]), coplanarity of mean positions ([`pose::coplanarity`], thesis 2.4).
//!
//! Recorded motions ([`motion::stream`]) are divided into standstills ([`motion::standstill`]) and
//! passes of a commanded path ([`path::commanded`], [`path::passes`]).
//!
//! Planar robots have z = 0 throughout. Angles are rotations a, b, c in an order that the caller
//! gives; each angle is evaluated separately. Angles are unwrapped about their first value, so a
//! test may straddle ±180°.

pub mod load;
pub mod misplacement;
pub mod motion;
pub mod path;
pub mod plan;
pub mod pose;
pub mod statistics;

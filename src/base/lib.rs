//! Common basis of all crates: messages, files, patterns of names, poses, numbers with derivatives,
//! random numbers, dates, line drawings.
#![allow(non_snake_case)] // frames in names, such as `world_T_base`

#[cfg(not(feature = "schemas"))]
extern crate etalon_schemaless as schemars;

pub mod bounds;
pub mod cell;
pub mod date;
pub mod expression;
mod geometry;
pub mod noise;
pub mod pose_name;
mod system;
mod text;

pub use geometry::{angle, angle_order, pose, scalar, sketch};
pub use system::{files, folder, fork, interruption};
pub use text::{catalogue, country, message, pattern, template, worded};

/// Implements `JsonSchema` by hand for a type: its name and its schema. Only builds with the
/// feature `schemas` of the calling crate contain it; `inline` puts the schema where it is used.
#[macro_export]
macro_rules! schema_by_hand {
    (inline $type:ident, $generator:pat_param => $schema:expr) => {
        $crate::schema_by_hand!(@ $type, stringify!($type), true, $generator => $schema);
    };
    ($type:ident, $generator:pat_param => $schema:expr) => {
        $crate::schema_by_hand!(@ $type, stringify!($type), false, $generator => $schema);
    };
    (@ $type:ident, $name:expr, $inline:literal, $generator:pat_param => $schema:expr) => {
        #[cfg(feature = "schemas")]
        impl schemars::JsonSchema for $type {
            fn inline_schema() -> bool {
                $inline
            }

            fn schema_name() -> std::borrow::Cow<'static, str> {
                $name.into()
            }

            fn json_schema($generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
                $schema
            }
        }
    };
}

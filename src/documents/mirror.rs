//! Document forms of plain types of other crates.

/// Defines the document form of a plain struct or enum, with equal fields or variants that are
/// converted by `Into`. A missing field or a field of another type does not compile. With
/// `of Plain as p`, a field that the document spells differently is followed by its value:
/// `name: Type = p.value`.
macro_rules! mirror {
    (@value $plain:ident $field:ident) => { $plain.$field.into() };
    (@value $plain:ident $field:ident $value:expr) => { $value };
    ($(#[$meta:meta])* struct $name:ident of $plain:ty { $($fields:tt)* }) => {
        mirror! { $(#[$meta])* struct $name of $plain as plain { $($fields)* } }
    };
    ($(#[$meta:meta])* struct $name:ident of $plain:ty as $value_of:ident {
        $($(#[$inner:meta])* $field:ident: $type:ty $(= $value:expr)?,)*
    }) => {
        #[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
        #[serde(deny_unknown_fields)]
        $(#[$meta])*
        pub struct $name { $($(#[$inner])* pub $field: $type,)* }

        impl From<$plain> for $name {
            #[allow(clippy::useless_conversion)] // most fields have the same type
            fn from($value_of: $plain) -> Self {
                Self { $($field: mirror!(@value $value_of $field $($value)?),)* }
            }
        }
    };
    ($(#[$meta:meta])* enum $name:ident of $plain:ty { $($(#[$inner:meta])* $variant:ident,)* }) => {
        #[derive(
            Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, serde::Serialize, serde::Deserialize, schemars::JsonSchema,
        )]
        $(#[$meta])*
        pub enum $name { $($(#[$inner])* $variant,)* }

        impl From<$plain> for $name {
            fn from(plain: $plain) -> Self {
                match plain { $(<$plain>::$variant => Self::$variant,)* }
            }
        }

        impl From<$name> for $plain {
            fn from(document: $name) -> Self {
                match document { $($name::$variant => Self::$variant,)* }
            }
        }
    };
}

pub(crate) use mirror;

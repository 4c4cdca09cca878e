//! A derive of `JsonSchema` without effect. The program contains its schemas as files; only tests,
//! with the feature `schemas`, derive them from the types.

use proc_macro::TokenStream;

/// Derives nothing, and accepts the attributes of the derive with an effect.
#[proc_macro_derive(JsonSchema, attributes(schemars))]
pub fn json_schema(_: TokenStream) -> TokenStream {
    TokenStream::new()
}

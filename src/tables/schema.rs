//! JSON Schemas of keys that have several spellings.

use schemars::Schema;
use serde_json::Value;

/// Makes the schema of a choice accept the spellings that its values list as `aliases`.
pub fn accept_aliases(schema: &mut Schema) {
    let choices = schema.get_mut("oneOf").and_then(Value::as_array_mut);
    for choice in choices.into_iter().flatten().filter_map(Value::as_object_mut) {
        if let Some(Value::Array(mut aliases)) = choice.remove("aliases") {
            aliases.splice(0..0, choice.remove("const"));
            choice.insert("enum".to_owned(), Value::Array(aliases));
        }
    }
}

/// Adds the key `topic`, which is another name of `sheet` for a topic of a recording.
pub fn accept_topic(schema: &mut Schema) {
    let properties = schema.get_mut("properties").and_then(Value::as_object_mut);
    if let Some((properties, mut sheet)) =
        properties.and_then(|all| all.get("sheet").cloned().map(|sheet| (all, sheet)))
    {
        if let Some(topic) = sheet.as_object_mut() {
            let description = "Name of the topic of a recording (MCAP) instead of `sheet`: `/joint_states`.";
            topic.insert("description".to_owned(), description.into());
        }
        properties.insert("topic".to_owned(), sheet);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Decimal, Delimiter, Encoding, Thousands};
    use schemars::{JsonSchema, schema_for};
    use serde::de::DeserializeOwned;

    fn spellings<T: JsonSchema + DeserializeOwned + PartialEq + std::fmt::Debug>(count: usize) {
        let schema = schema_for!(T);
        let choices = schema.get("oneOf").unwrap().as_array().unwrap();
        let all: Vec<&Vec<Value>> = choices.iter().filter_map(|choice| choice.get("enum")?.as_array()).collect();
        assert_eq!(all.iter().map(|same| same.len()).sum::<usize>(), count, "{schema:?}");
        let read = |value: &Value| serde_json::from_value::<T>(value.clone()).unwrap();
        all.iter().for_each(|same| same.iter().for_each(|value| assert_eq!(read(value), read(&same[0]))));
    }

    #[test]
    fn a_schema_accepts_every_spelling_that_reads() {
        spellings::<Delimiter>(10);
        spellings::<Decimal>(4);
        spellings::<Thousands>(8);
        spellings::<Encoding>(19);
    }
}

//! Options of a call by a program: a JSON object.

use clap::Args;
use etalon_base::bounds::option_at_most;
use etalon_base::error;
use etalon_base::message::Result;
use etalon_tables::Constant;
use serde::de::{Deserialize, DeserializeOwned, Deserializer, Error};
use serde_json::{Map, Value};
use std::collections::BTreeMap;

/// Options of a task from a JSON object: `{"standard_uncertainty_um": 15, "hold": ["a_3"]}`. Its
/// keys are the names of the options on the command line, with underscores.
///
/// # Errors
/// Fails for an unknown option and for a value of another type; the message names the valid ones.
pub fn parse_options<T: Args + DeserializeOwned>(json: &str) -> Result<T> {
    read(json).map_err(|reason| error!("option-of-call-refused", reason).into())
}

fn read<T: Args + DeserializeOwned>(json: &str) -> std::result::Result<T, String> {
    let stated: Map<String, Value> = serde_json::from_str(json).map_err(|error| error.to_string())?;
    let known = names::<T>();
    if let Some(unknown) = stated.keys().find(|name| !known.contains(name)) {
        return Err(format!("unknown option `{unknown}`, expected one of {}", known.join(", ")));
    }
    let typed =
        |stated: Map<String, Value>| T::deserialize(Value::Object(stated)).map_err(|error| plain(&error.to_string()));
    typed(stated.clone()).map_err(|reason| {
        // the option without which the reason is another, last a mandatory one
        let without = |name: &String| {
            let mut others = stated.clone();
            others.remove(name);
            typed(others).err().unwrap_or_default()
        };
        let is_other = |name: &&String| without(name) != reason;
        let is_optional = |name: &&String| !without(name).starts_with("missing field");
        let mut names = stated.keys().filter(is_other);
        let cause = names.clone().find(is_optional).or_else(|| names.next());
        cause.map_or(reason.clone(), |name| format!("`{name}`: {reason}"))
    })
}

/// Reason with the types of the reader's language.
fn plain(reason: &str) -> String {
    let types = [("usize", "a whole number from 0"), ("u64", "a whole number from 0"), ("f64", "a number")];
    types.iter().fold(reason.to_owned(), |text, (own, words)| {
        text.replace(&format!("expected {own}"), &format!("expected {words}"))
    })
}

/// Names of the options of a task.
fn names<T: Args>() -> Vec<String> {
    let command = T::augment_args(clap::Command::new("call"));
    command.get_arguments().filter_map(|option| Some(option.get_long()?.replace('-', "_"))).collect()
}

/// Pairs `NAME=VALUE` of a repeated option, which are an object in a call.
pub(super) fn pairs<'de, D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Vec<String>, D::Error> {
    let pairs = BTreeMap::<String, Constant>::deserialize(deserializer)?;
    Ok(pairs.into_iter().map(|(name, value)| format!("{name}={}", value.cell())).collect())
}

/// A bounded number, as [`option_at_most`] parses it from a command line.
pub(super) fn at_most<'de, const MOST: usize, D: Deserializer<'de>>(
    deserializer: D,
) -> std::result::Result<Option<usize>, D::Error> {
    let stated = Option::<usize>::deserialize(deserializer)?;
    stated.map(|number| option_at_most::<MOST>(&number.to_string())).transpose().map_err(D::Error::custom)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tasks::*;
    use serde_json::json;
    use std::fmt::Debug;

    /// Every option is read from a call, and has the default of the command line.
    fn check<T: Args + DeserializeOwned + Debug>(required: &[(&str, &str)]) {
        let stated: Map<String, Value> =
            required.iter().map(|(name, value)| ((*name).to_owned(), serde_json::from_str(value).unwrap())).collect();
        let words = required.iter().map(|(name, value)| format!("--{name}={}", value.trim_matches('"')));
        let words = std::iter::once("etalon".to_owned()).chain(words);
        // tables of a test, which its options name
        let tables = ["poses", "commanded", "stream", "path"].map(|name| clap::Arg::new(name).long(name));
        let matches = T::augment_args(clap::Command::new("etalon").args(tables)).get_matches_from(words);
        let parsed = T::from_arg_matches(&matches).unwrap();
        let read: T = parse_options(&Value::Object(stated.clone()).to_string()).unwrap();
        assert_eq!(format!("{read:?}"), format!("{parsed:?}"));
        for name in names::<T>() {
            let mut wrong = stated.clone();
            wrong.insert(name.clone(), json!([[[]]]));
            let reason = super::read::<T>(&Value::Object(wrong).to_string()).unwrap_err();
            assert!(reason.starts_with(&format!("`{name}`: ")), "{reason}");
        }
    }

    #[test]
    fn a_call_has_the_options_and_defaults_of_the_command_line() {
        check::<IdentifyOptions>(&[]);
        check::<PlanOptions>(&[("positions", "12")]);
        check::<VerifyOptions>(&[]);
        check::<AxesOptions>(&[]);
        check::<CellOptions>(&[("solve", "\"hand-eye\"")]);
        check::<PoseOptions>(&[]);
        check::<StreamOptions>(&[]);
        check::<ValidateOptions>(&[]);
    }

    #[test]
    fn values_of_a_call_are_typed() {
        let options: IdentifyOptions = parse_options(
            r#"{"effects": ["zeros", "gains"], "prior": "none", "column": {"q1_deg": "J1", "x_mm": 3}, "hold": ["a_*"]}"#,
        )
        .unwrap();
        let shown = format!("{options:?}");
        for part in ["Zeros", "Gains", "prior: None", "\"q1_deg=J1\", \"x_mm=3\"", "hold: [\"a_*\"]"] {
            assert!(shown.contains(part), "{part}: {shown}");
        }
    }

    #[test]
    fn a_wrong_option_is_named_with_the_valid_ones() {
        let refused = |json: &str| read::<PlanOptions>(json).unwrap_err();
        assert!(refused(r#"{"position": 3}"#).contains("unknown option `position`, expected one of"));
        assert!(refused(r#"{"positions": 3, "prior": "no"}"#).contains("`prior`: unknown variant `no`, expected"));
        assert!(refused(r#"{"positions": 3, "index": "O9"}"#).contains("`index`: "));
        assert!(refused(r#"{"positions": 3, "effects": "zeros,nonsense"}"#).contains("one of `zeros`"));
        assert!(refused(r#"{"positions": 3, "starts": 100001}"#).contains("`starts`: "));
        assert!(refused(r#"{"positions": -1}"#).ends_with("expected a whole number from 0"));
        assert!(refused(r#"{"positions": 3, "standard_uncertainty_um": "x"}"#).ends_with("expected a number"));
    }
}

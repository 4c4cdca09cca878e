//! Options of the identified parameters.

use etalon_documents::Effect;
use etalon_identify::{Effects, Prior, Settings};
use serde::Deserialize;
use serde::de::value::StrDeserializer;
use serde::de::{Deserializer, Error};

/// Options of the identified parameters.
#[derive(Clone, Debug, clap::Args, Deserialize)]
#[serde(default)]
pub struct ModelOptions {
    /// Hold a parameter at its nominal value; `*` stands for any text; may be repeated.
    #[arg(long, value_name = "NAME")]
    pub hold: Vec<String>,
    /// Use of nominal values: as observations with their tolerances, or as starting values of plain
    /// least squares.
    #[arg(long, value_enum, default_value_t)]
    pub prior: PriorOption,
    /// Effects to identify: `all`, or a list of zeros, geometry, gains, harmonics, backlash,
    /// coupling, bending, payload, torque, expansion, drift, lateral, pedestal; by default all
    /// effects in the robot file except gains of revolute joints of arms and payload to
    /// pedestal.
    #[arg(long, value_parser = parse_effects, value_name = "EFFECTS", default_value = "usual")]
    #[serde(deserialize_with = "effects")]
    pub effects: Effects,
}

impl Default for ModelOptions {
    fn default() -> Self {
        Self { hold: Vec::new(), prior: PriorOption::default(), effects: Effects::Usual }
    }
}

impl ModelOptions {
    /// Settings of an identification.
    pub(super) fn settings(&self, standard_uncertainty_um: Option<f64>) -> Settings {
        Settings {
            standard_uncertainty_mm: standard_uncertainty_um.map(|u| u / 1000.0),
            hold: self.hold.clone(),
            prior: self.prior.into(),
            effects: self.effects.clone(),
            ..Settings::default()
        }
    }
}

/// Use of nominal values.
#[derive(Clone, Copy, Debug, Default, clap::ValueEnum, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PriorOption {
    /// Observations with the standard uncertainty t/√3 of their tolerance t.
    #[default]
    Tolerances,
    /// Starting values only.
    None,
}

impl From<PriorOption> for Prior {
    fn from(option: PriorOption) -> Self {
        match option {
            PriorOption::Tolerances => Self::TOLERANCES,
            PriorOption::None => Self::None,
        }
    }
}

/// Parses the effects of an option.
fn parse_effects(text: &str) -> Result<Effects, serde::de::value::Error> {
    let one = |name: &str| Effect::deserialize(StrDeserializer::new(name.trim())).map(Into::into);
    match text {
        "usual" => Ok(Effects::Usual),
        "all" => Ok(Effects::All),
        list => Ok(Effects::These(list.split(',').map(one).collect::<Result<_, _>>()?)),
    }
}

/// Effects of a call: as on the command line, or a list.
fn effects<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Effects, D::Error> {
    #[derive(Deserialize)]
    #[serde(untagged)]
    enum Stated {
        Text(String),
        List(Vec<String>),
    }
    let text = match Stated::deserialize(deserializer)? {
        Stated::Text(text) => text,
        Stated::List(names) => names.join(","),
    };
    parse_effects(&text).map_err(D::Error::custom)
}

//! QIF 3.0 Results (ISO 23952:2020): each parameter as a user-defined characteristic with nominal
//! value, measured value and combined standard uncertainty. QIF has no element for covariances.

use super::xml::{Element, element, leaf};
use super::{About, ExportInput, Exporter};
use etalon_base::error;
use etalon_base::message::Result;
use etalon_documents::{ParameterEntry, ParametersDocument};

/// XML with a characteristic for each parameter.
pub(super) struct Qif;

/// Identifier of the standard that defines the characteristics.
const STANDARD: usize = 1;
/// Identifier of the measurement results.
const RESULTS: usize = 2;
/// Identifier of the place of measurement.
const PLACE: usize = 3;
/// Placeholder for the limit that characteristics of a user-defined unit require.
const NO_LIMIT: &str = "No limit is stated: the schema requires one, -1E6.";

impl Exporter for Qif {
    fn about(&self) -> About<'_> {
        About::laboratory("qif", "parameters.qif")
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let parameters = &given.parameters.parameters;
        let identifier = given.identifier()?;
        let application =
            element("Application", [leaf("Name", format!("etalon {}", given.parameters.provenance.version))]);
        let scope = given.warning().unwrap_or_else(|| {
            "Identified kinematic parameters, standard uncertainties (k = 1); QIF holds no covariance".to_owned()
        });
        let organization = element("Organization", [leaf("OtherStandardsOrganization", "etalon")]);
        let standard = [organization, leaf("Designator", format!("parameters.json, {}", ParametersDocument::SCHEMA))];
        let standard = element("Standard", standard).with("id", STANDARD);
        let root = element(
            "QIFDocument",
            [
                leaf("QPId", identifier),
                element("Header", [application, leaf("Scope", scope)]),
                element("StandardsDefinitions", [standard]).with("n", 1),
                units(parameters),
                characteristics(parameters),
                results(given),
            ],
        )
        .with("xmlns", "http://qifstandards.org/xsd/qif3")
        .with("versionQIF", "3.0.0")
        .with("idMax", id(parameters.len(), Aspect::Definition) - 1);
        let document = root.document(&given.header("mm, deg, 1")?);
        document.map_err(|e| error!("cannot-encode", format = "QIF", reason = e.to_string()).into())
    }
}

/// Elements of a characteristic.
#[derive(Clone, Copy)]
enum Aspect {
    Definition,
    Nominal,
    Item,
    Measurement,
}

fn id(index: usize, aspect: Aspect) -> usize {
    PLACE + 1 + 4 * index + aspect as usize
}

fn units(parameters: &[ParameterEntry]) -> Element {
    let unit = |name, si, unit, factor: f64| {
        let conversion = element("UnitConversion", [leaf("Factor", factor)]);
        element(name, [leaf("SIUnitName", si), leaf("UnitName", unit), conversion])
    };
    let primary = [unit("AngularUnit", "radian", "degree", 1f64.to_radians()), unit("LinearUnit", "meter", "mm", 1e-3)];
    let mut all = vec![element("PrimaryUnits", primary)];
    if parameters.iter().any(|p| names(p).definition.contains("Unit")) {
        let ratio = element("UserDefinedUnit", [leaf("WhatIsMeasured", "a ratio"), leaf("UnitName", "1")]);
        all.push(element("UserDefinedUnits", [ratio]).with("n", 1));
    }
    element("FileUnits", all)
}

/// Names of the elements of a characteristic.
struct Names {
    definition: &'static str,
    nominal: &'static str,
    item: &'static str,
    measurement: &'static str,
}

macro_rules! names {
    ($kind:literal) => {
        Names {
            definition: concat!("UserDefined", $kind, "CharacteristicDefinition"),
            nominal: concat!("UserDefined", $kind, "CharacteristicNominal"),
            item: concat!("UserDefined", $kind, "CharacteristicItem"),
            measurement: concat!("UserDefined", $kind, "CharacteristicMeasurement"),
        }
    };
}

fn names(p: &ParameterEntry) -> Names {
    match p.unit.as_str() {
        "mm" => names!("Linear"),
        "deg" => names!("Angular"),
        _ => names!("Unit"),
    }
}

/// A number without exponent for `xs:decimal`, to 24 decimals, which readers must accept.
fn decimal(value: f64) -> String {
    let text = value.to_string();
    let decimals = text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    if decimals > 24 { format!("{value:.24}") } else { text }
}

/// Value of a parameter; a ratio has the name of its unit.
fn value(p: &ParameterEntry, name: &'static str, value: f64) -> Element {
    let value = leaf(name, decimal(value));
    if matches!(p.unit.as_str(), "mm" | "deg") { value } else { value.with("unitName", "1") }
}

fn characteristics(parameters: &[ParameterEntry]) -> Element {
    let each = |name, one: &dyn Fn(usize, &ParameterEntry) -> Element| {
        element(name, parameters.iter().enumerate().map(|(i, p)| one(i, p))).with("n", parameters.len())
    };
    let definition = |i, p: &ParameterEntry| {
        let parts = match p.unit.as_str() {
            "mm" | "deg" => {
                vec![leaf("Name", &p.name), leaf("NonTolerance", "MEASURED"), leaf("WhatToMeasure", &p.name)]
            }
            _ => vec![leaf("Description", NO_LIMIT), leaf("Name", &p.name)],
        };
        element(names(p).definition, parts).with("id", id(i, Aspect::Definition))
    };
    let nominal = |i, p: &ParameterEntry| {
        let mut parts = vec![
            leaf("CharacteristicDefinitionId", id(i, Aspect::Definition)),
            leaf("Name", &p.name),
            value(p, "TargetValue", p.nominal),
        ];
        if !matches!(p.unit.as_str(), "mm" | "deg") {
            parts.extend([value(p, "MinValue", -1e6), leaf("DefinedAsLimit", true)]);
        }
        element(names(p).nominal, parts).with("id", id(i, Aspect::Nominal))
    };
    let item = |i, p: &ParameterEntry| {
        let parts = [leaf("Name", &p.name), leaf("CharacteristicNominalId", id(i, Aspect::Nominal))];
        element(names(p).item, parts).with("id", id(i, Aspect::Item))
    };
    element(
        "Characteristics",
        [
            leaf("FormalStandardId", STANDARD),
            each("CharacteristicDefinitions", &definition),
            each("CharacteristicNominals", &nominal),
            each("CharacteristicItems", &item),
        ],
    )
}

fn results(given: &ExportInput) -> Element {
    let parameters = &given.parameters.parameters;
    let measured = parameters.iter().enumerate().map(|(i, p)| {
        let mut found = value(p, "Value", p.value);
        if let Some(u) = p.standard_uncertainty {
            found = found.with("combinedUncertainty", decimal(u));
        }
        let parts = [
            leaf("Description", super::status_word(p)),
            element("Status", [leaf("CharacteristicStatusEnum", "NOT_ANALYZED")]),
            leaf("CharacteristicItemId", id(i, Aspect::Item)),
            found,
        ];
        element(names(p).measurement, parts).with("id", id(i, Aspect::Measurement))
    });
    let measured = element("CharacteristicMeasurements", measured).with("n", parameters.len());
    let stated = given.summary;
    let laboratory = stated.and_then(|s| s.conditions.laboratory.as_ref());
    let number = stated.and_then(|s| s.issue.number.as_ref());
    let place = stated.and_then(|s| s.conditions.place.as_ref());
    let traceability = [
        laboratory.map(|name| element("InspectingOrganization", [leaf("Name", name)])),
        number.map(|number| leaf("ReportNumber", number)),
        stated
            .and_then(|s| s.measurements.operator.as_ref())
            .map(|name| element("InspectionOperator", [leaf("Name", name)])),
        place.map(|place| element("PlantLocation", [leaf("LocationDescription", place)]).with("id", PLACE)),
    ];
    let results = [
        element("InspectionTraceability", traceability.into_iter().flatten()),
        element("MeasuredCharacteristics", [measured]),
        element("InspectionStatus", [leaf("InspectionStatusEnum", "NOT_CALCULATED")]),
    ];
    let results = element("MeasurementResults", results).with("id", RESULTS);
    element("Results", [element("MeasurementResultsSet", [results]).with("n", 1)])
}

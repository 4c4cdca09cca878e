//! Draft of a digital calibration certificate: PTB's DCC 3.3.0 with D-SI 2.2.1
//! (`https://ptb.de/dcc/v3.3.0`).
//!
//! The draft is neither signed nor issued by an accredited laboratory, and says so. Elements that
//! the schema requires and the campaign does not contain are marked as not given.

use super::xml::{Element, element, leaf};
use super::{About, ExportInput, Exporter};
use etalon_base::country::Country;
use etalon_base::date::date;
use etalon_base::error;
use etalon_base::message::Result;
use etalon_documents::{CampaignSummary, Conditions, Issue, ParameterEntry, TestedRobot};
use statrs::distribution::{ChiSquared, ContinuousCDF, FisherSnedecor};

/// XML with parameters and their covariance.
pub(super) struct Dcc;

/// File name.
pub const FILE: &str = "calibration_certificate_draft.xml";
/// Coverage probability of the region of all identified parameters.
const PROBABILITY: f64 = 0.95;

/// Description of the region that contains all parameters with a probability of 95 %.
const REGION: &str = "The ellipsoidal region has a coverage probability of 95 % for all identified parameters together \
                      (JCGM 102:2011, 6.5.2); their standard uncertainties are the square roots of the diagonal.";

impl Exporter for Dcc {
    fn about(&self) -> About<'_> {
        About::laboratory("dcc", FILE)
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let stated = Stated::new(given)?;
        let root = element("dcc:digitalCalibrationCertificate", [stated.administration(), results(given, &stated)])
            .with("xmlns:dcc", "https://ptb.de/dcc")
            .with("xmlns:si", "https://ptb.de/si")
            .with("schemaVersion", "3.3.0");
        let header = given.header("D-SI units: mm, deg, 1")?;
        root.document(&header).map_err(|e| error!("cannot-encode", format = "DCC", reason = e.to_string()).into())
    }
}

/// Data of the campaign, with substitutes for missing ones.
struct Stated<'a> {
    given: &'a ExportInput<'a>,
    conditions: Conditions,
    identifier: String,
    begin: String,
    end: String,
}

const NOT_STATED: &str = "not stated";
/// Country code that ISO 3166-1 leaves to its users.
const NO_COUNTRY: &str = "ZZ";

impl<'a> Stated<'a> {
    fn new(given: &'a ExportInput<'a>) -> Result<Self> {
        let summary = given.summary;
        let dates: Vec<String> = summary
            .and_then(|summary| summary.measurements.date.as_deref())
            .into_iter()
            .flat_map(str::split_whitespace)
            .filter(|word| word.len() == 10 && date(word).is_some())
            .map(str::to_owned)
            .collect();
        let begin = dates.first().ok_or_else(|| error!("certificate-date-missing"))?.clone();
        let end = dates.get(1).unwrap_or(&begin).clone();
        let hash = given.sha256()?;
        let identifier = format!("draft-{}", hash.get(..32).unwrap_or_default());
        let conditions = summary.map(|summary| summary.conditions.clone()).unwrap_or_default();
        Ok(Self { given, conditions, identifier, begin, end })
    }

    fn summary(&self, value: impl Fn(&'a CampaignSummary) -> Option<&'a String>) -> &'a str {
        self.given.summary.and_then(value).map_or(NOT_STATED, String::as_str)
    }

    fn issue(&self) -> Issue {
        self.given.summary.map(|summary| summary.issue.clone()).unwrap_or_default()
    }

    fn robot(&self) -> &str {
        self.conditions.robot.description.as_deref().unwrap_or(self.given.robot_name())
    }

    fn core_data(&self) -> Element {
        let (Conditions { robot, .. }, issue) = (&self.conditions, self.issue());
        let number =
            issue.number.as_ref().map(|number| identification("calibrationLaboratory", number, "Report number"));
        let core = [
            Some(leaf("dcc:countryCodeISO3166_1", issue.country.as_ref().map_or(NO_COUNTRY, Country::code))),
            Some(leaf("dcc:usedLangCodeISO639_1", "en")),
            Some(leaf("dcc:mandatoryLangCodeISO639_1", "en")),
            Some(leaf("dcc:uniqueIdentifier", &self.identifier)),
            number.map(|number| element("dcc:identifications", [number])),
            robot.received.as_deref().and_then(day).map(|day| leaf("dcc:receiptDate", day)),
            Some(leaf("dcc:beginPerformanceDate", &self.begin)),
            Some(leaf("dcc:endPerformanceDate", &self.end)),
            Some(leaf("dcc:performanceLocation", self.location())),
            issue.issued.as_deref().and_then(day).map(|day| leaf("dcc:issueDate", day)),
        ];
        element("dcc:coreData", core.into_iter().flatten())
    }

    /// Place of the measurements as DCC 3.3.0 lists places: the laboratory unless another place is
    /// given.
    fn location(&self) -> &'static str {
        let Conditions { place, laboratory, .. } = &self.conditions;
        let contains = |name: &Option<String>| {
            let name = name.as_deref().map(|name| name.trim().to_lowercase()).filter(|name| !name.is_empty());
            name.is_some_and(|name| place.as_ref().is_some_and(|place| place.to_lowercase().contains(&name)))
        };
        match (place, laboratory) {
            (None, Some(_)) => "laboratory",
            (Some(_), _) if contains(&self.issue().customer) => "customer",
            (Some(_), _) if contains(laboratory) => "laboratory",
            _ => "other",
        }
    }

    fn administration(&self) -> Element {
        let TestedRobot { maker, model, serial_number, .. } = &self.conditions.robot;
        let issue = self.issue();
        let software = [
            text("dcc:name", "etalon"),
            leaf("dcc:release", &self.given.parameters.provenance.version),
            leaf("dcc:type", "application"),
        ];
        let serial_number = serial_number.iter().map(|n| identification("manufacturer", n, "Serial number"));
        let named = identification("other", self.robot(), "Robot as the campaign names it");
        let identifications = serial_number.chain([named]);
        let item = [
            Some(text("dcc:name", self.robot())),
            maker.as_ref().map(|maker| element("dcc:manufacturer", [text("dcc:name", maker)])),
            model.as_ref().map(|model| leaf("dcc:model", model)),
            Some(element("dcc:identifications", identifications)),
        ];
        let item = item.into_iter().flatten();
        let laboratory = self.conditions.laboratory.as_deref().unwrap_or(NOT_STATED);
        let person = |who: &str, role| {
            let person = element("dcc:person", [text("dcc:name", who)]);
            element("dcc:respPerson", [person, leaf("dcc:role", role)])
        };
        let operator = person(self.summary(|s| s.measurements.operator.as_ref()), "operator");
        let authorised = issue.authorised_by.iter().map(|who| person(who, "authorises the report"));
        element(
            "dcc:administrativeData",
            [
                element("dcc:dccSoftware", [element("dcc:software", software)]),
                self.core_data(),
                element("dcc:items", [element("dcc:item", item)]),
                element("dcc:calibrationLaboratory", [contact("dcc:contact", laboratory)]),
                element("dcc:respPersons", [operator].into_iter().chain(authorised)),
                contact("dcc:customer", issue.customer.as_deref().unwrap_or(NOT_STATED)),
                element("dcc:statements", self.statements()),
            ],
        )
    }

    fn statements(&self) -> Vec<Element> {
        let (issue, conditions) = (self.issue(), &self.conditions);
        let statement =
            |name: &str, what: &str| element("dcc:statement", [text("dcc:name", name), text("dcc:declaration", what)]);
        let missing = [
            ("country (ZZ)", issue.country.is_none()),
            ("customer", issue.customer.is_none()),
            ("laboratory", self.conditions.laboratory.is_none()),
            ("place of the measurements", conditions.place.is_none() && conditions.laboratory.is_none()),
            ("responsible person", self.summary(|s| s.measurements.operator.as_ref()) == NOT_STATED),
            ("instrument", self.summary(|s| s.instrument.name.as_ref()) == NOT_STATED),
            ("calibration of the instrument", self.conditions.instrument_calibration.is_none()),
            ("temperature", self.given.summary.is_none_or(|s| s.temperature.stated_c.is_none())),
        ];
        let missing: Vec<&str> = missing.iter().filter(|(_, missing)| *missing).map(|(what, _)| *what).collect();
        let mut all = vec![
            statement("Draft", "This is a draft: it is neither signed nor a certificate of an accredited laboratory."),
            statement("Item", "The results relate only to the item calibrated."),
            statement("Not stated", &missing.join(", ")),
        ];
        let stated = [
            ("Place", &conditions.place),
            ("Amends", &issue.amends),
            ("Results of external providers", &issue.external_results),
            ("Metrological traceability", &conditions.traceability),
            ("State of the robot", &conditions.robot.state),
            ("Environment", &conditions.environment),
        ];
        all.extend(stated.into_iter().filter_map(|(name, what)| Some(statement(name, what.as_ref()?))));
        all.extend(self.given.warning().map(|warning| statement("Failed checks", &warning)));
        let withheld = self.given.file.and_then(|(file, _)| file.not_to_be_loaded());
        all.extend(withheld.map(|reason| statement("Controller files", &reason)));
        all.extend(
            self.given
                .summary
                .and_then(|s| s.measurements.synthetic.as_deref())
                .map(|what| statement("Synthetic data", what)),
        );
        all
    }
}

/// Date at the start of a text.
fn day(stated: &str) -> Option<&str> {
    date(stated).and_then(|_| stated.get(..10))
}

fn identification(issuer: &str, value: &str, name: &str) -> Element {
    element("dcc:identification", [leaf("dcc:issuer", issuer), leaf("dcc:value", value), text("dcc:name", name)])
}

fn text(name: &'static str, content: &str) -> Element {
    element(name, [leaf("dcc:content", content)])
}

fn contact(name: &'static str, who: &str) -> Element {
    element(name, [text("dcc:name", who), element("dcc:location", [text("dcc:further", NOT_STATED)])])
}

fn results(given: &ExportInput, stated: &Stated) -> Element {
    let method = element(
        "dcc:usedMethod",
        [
            text("dcc:name", "Identification of kinematic parameters by weighted least squares"),
            leaf("dcc:norm", "JCGM 100:2008"),
        ],
    );
    let equipment = element(
        "dcc:measuringEquipment",
        [
            text("dcc:name", stated.summary(|s| s.instrument.name.as_ref())),
            text("dcc:description", stated.conditions.instrument_calibration.as_deref().unwrap_or(NOT_STATED)),
        ],
    );
    let mut parts = vec![
        text("dcc:name", "Kinematic parameters"),
        element("dcc:usedMethods", [method]),
        element("dcc:measuringEquipments", [equipment]),
    ];
    parts.extend(given.summary.and_then(|s| s.temperature.stated_c).map(|temperature| {
        let real =
            element("si:real", [leaf("si:value", format!("{temperature:?}")), leaf("si:unit", r"\degreecelsius")]);
        let data = element("dcc:data", [element("dcc:quantity", [real])]);
        let condition = element("dcc:influenceCondition", [text("dcc:name", "Temperature"), data]);
        element("dcc:influenceConditions", [condition])
    }));
    let all = &given.parameters.parameters;
    let in_matrix: Vec<&ParameterEntry> = match given.parameters.covariance.as_slice() {
        [] => Vec::new(),
        _ => given.parameters.identified().collect(),
    };
    let apart = |p: &&ParameterEntry| !in_matrix.iter().any(|known| known.name == p.name);
    let (alone, held): (Vec<_>, Vec<_>) = all.iter().filter(apart).partition(|p| p.standard_uncertainty.is_some());
    let references: Vec<String> = given.references().iter().map(|line| format!("Values {line}.")).collect();
    let groups = [
        ("Identified parameters", REGION, list(&in_matrix, Some(&given.parameters.covariance))),
        ("Identified parameters without stated covariance", "Standard uncertainties.", list(&alone, None)),
        ("Parameters that are held", "Not identified: held parameters have no uncertainty here.", list(&held, None)),
    ];
    let results = groups.into_iter().filter_map(|(name, description, values)| {
        let quantity = element("dcc:quantity", [values?]);
        let description = [description].into_iter().chain(references.iter().map(String::as_str)).collect::<Vec<_>>();
        let description = text("dcc:description", &description.join(" "));
        let parts = [text("dcc:name", name), description, element("dcc:data", [quantity])];
        Some(element("dcc:result", parts))
    });
    parts.push(element("dcc:results", results));
    element("dcc:measurementResults", [element("dcc:measurementResult", parts)])
}

/// Values with their covariance or standard uncertainties; `None` without parameters.
fn list(parameters: &[&ParameterEntry], covariance: Option<&Vec<Vec<f64>>>) -> Option<Element> {
    if parameters.is_empty() {
        return None;
    }
    let join =
        |words: &dyn Fn(&ParameterEntry) -> String| parameters.iter().map(|p| words(p)).collect::<Vec<_>>().join(" ");
    let mut parts = vec![
        leaf("si:labelXMLList", join(&|p| p.name.split_whitespace().collect::<Vec<_>>().join("_"))),
        leaf("si:valueXMLList", join(&|p| format!("{:?}", p.value))),
        leaf("si:unitXMLList", join(&|p| unit(p.printed_unit()).to_owned())),
    ];
    if let Some(covariance) = covariance {
        let columns = parameters.iter().enumerate().map(|(j, column)| {
            let values = covariance.iter().filter_map(|row| Some(format!("{:?}", row.get(j)?)));
            let covariance = [
                leaf("si:valueXMLList", values.collect::<Vec<_>>().join(" ")),
                leaf("si:unitXMLList", join(&|row| product(row.printed_unit(), column.printed_unit()))),
            ];
            element("si:columnXMLList", [element("si:covarianceXMLList", covariance)])
        });
        let region = [
            element("si:covarianceMatrixXMLList", columns),
            leaf("si:coverageFactorXMLList", format!("{:?}", factor(parameters))),
            leaf("si:coverageProbabilityXMLList", PROBABILITY),
        ];
        let region = element("si:ellipsoidalRegionMUXMLList", region);
        parts.push(element("si:measurementUncertaintyMultivariateXMLList", [region]));
    } else if parameters.iter().all(|p| p.standard_uncertainty.is_some()) {
        let u = join(&|p| format!("{:?}", p.standard_uncertainty.unwrap_or_default()));
        let u = element("si:standardMUXMLList", [leaf("si:valueStandardMUXMLList", u)]);
        parts.push(element("si:measurementUncertaintyUnivariateXMLList", [u]));
    }
    Some(element("si:realListXMLList", parts))
}

/// Factor of the ellipsoid that contains `m` parameters with a probability of 95 %: √χ²(m) (JCGM
/// 102:2011, 6.5.2), or √(m F(m, ν)) if uncertainties are estimated with ν degrees of freedom.
fn factor(parameters: &[&ParameterEntry]) -> f64 {
    let m = parameters.len() as f64;
    let estimated = parameters.iter().filter_map(|p| p.degrees_of_freedom).reduce(f64::min);
    let square = match estimated {
        Some(dof) => FisherSnedecor::new(m, dof).ok().map(|d| m * d.inverse_cdf(PROBABILITY)),
        None => ChiSquared::new(m).ok().map(|d| d.inverse_cdf(PROBABILITY)),
    };
    square.map_or(1.0, |square| square.sqrt().max(1.0))
}

/// Unit in the notation of D-SI.
fn unit(unit: &str) -> &'static str {
    match unit {
        "mm/(m·K)" => r"\milli\metre\per\metre\per\kelvin",
        // the description gives the load or temperature
        unit if unit.starts_with("deg") => r"\degree",
        unit if unit.starts_with("mm") => r"\milli\metre",
        _ => r"\one",
    }
}

/// Unit of a covariance.
fn product(one: &str, other: &str) -> String {
    match (unit(one), unit(other)) {
        (one, other) if one == other && one == r"\one" => one.to_owned(),
        (one, other) if one == other => format!(r"{one}\tothe{{2}}"),
        (r"\one", unit) | (unit, r"\one") => unit.to_owned(),
        (one, other) => format!("{one}{other}"),
    }
}

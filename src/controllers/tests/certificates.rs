//! Certificates validated with the schemas of PTB and DMSC, and read back by Python.

use super::*;
use std::path::Path;

/// Parameters with all units, a full covariance and texts that are hostile to XML.
fn certified() -> ParametersDocument {
    let hostile = "<!-- ]]> & \" \u{1} -- é";
    let mut document = document(vec![
        parameter("l11", "mm", 300.000_000_000_000_06),
        parameter("gamma", "deg", -1.0 / 3.0),
        parameter("delta2", "1", 1.000_023_1),
        parameter(hostile, "mm", 1.234_567_890_123_456_7e-9),
        parameter("d", "mm", 90.0),
        parameter("ratio", "1", 1.0),
    ]);
    for p in &mut document.parameters[4..] {
        (p.status, p.standard_uncertainty) = (ParameterStatus::Fixed, None);
    }
    document.covariance = (0..4).map(|i| (0..4).map(|j| if i == j { 1e-14 } else { 1e-15 / 3.0 }).collect()).collect();
    document
}

pub(super) fn summary() -> CampaignSummary {
    let stated = serde_json::json!({
        "name": "--> <x/> spring check", "robot": null, "synthetic": null, "notes": null, "date": "2026-03-02 to 2026-03-04",
        "operator": "A. \u{2}B.", "instrument": "CMM", "expanded_uncertainty_um": 2.7, "coverage_factor": 2.0, "contact": null,
        "temperature_c": 20.1,
        "conditions": {
            "robot": "maker, type, 17", "robot_maker": "maker", "robot_type": "type", "robot_serial_number": "17",
            "robot_received": "2026-03-01", "laboratory": "Laboratory, Street 1", "place": "hall 3", "traceability": "to SI, by PTB"
        },
        "issue": {
            "number": "R-17 <a>", "customer": "Customer, City", "country": "CA", "issued": "2026-03-09", "authorised_by": "B. C., head",
            "amends": "R-16 of 2026-03-08: a temperature", "external_results": "none"
        }
    });
    serde_json::from_value(stated).unwrap()
}

fn written(format: &str) -> String {
    let (document, summary) = (certified(), summary());
    let given = ExportInput { summary: Some(&summary), ..ExportInput::parameters(&document) };
    String::from_utf8(by_name(format).unwrap().write(&given).unwrap()).unwrap()
}

/// Errors that `xmllint` reports for a text by a schema of the reference, empty if valid; `None`
/// without the schema or `xmllint`.
fn valid(text: &str, schema: &str) -> Option<String> {
    let schema = Path::new(&std::env::var_os("ETALON_REFERENCE").unwrap_or_default()).join("xsd").join(schema);
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("document.xml");
    std::fs::write(&file, text).unwrap();
    let run = Command::new("xmllint").args(["--nonet", "--noout", "--schema"]).arg(&schema).arg(&file).output();
    match run {
        Ok(output) if schema.is_file() => {
            let said = String::from_utf8_lossy(&output.stderr).into_owned();
            Some(if output.status.success() { String::new() } else { said })
        }
        _ => {
            skipped("xmllint");
            None
        }
    }
}

/// Places that DCC 3.3.0 lists (`performanceLocation`).
#[test]
fn the_place_of_the_measurements_is_one_of_the_schema() {
    let location = |place: Option<&str>, laboratory: Option<&str>| {
        let (document, mut summary) = (certified(), summary());
        summary.conditions.place = place.map(str::to_owned);
        summary.conditions.laboratory = laboratory.map(str::to_owned);
        let given = ExportInput { summary: Some(&summary), ..ExportInput::parameters(&document) };
        let text = String::from_utf8(by_name("dcc").unwrap().write(&given).unwrap()).unwrap();
        let (_, rest) = text.split_once("<dcc:performanceLocation>").unwrap();
        (rest.split_once('<').unwrap().0.to_owned(), text.contains("place of the measurements"))
    };
    let laboratory = Some("Laboratory, Street 1");
    for (place, laboratory, expected, is_missing) in [
        (None, laboratory, "laboratory", false),
        (Some("hall 3"), laboratory, "other", false),
        (Some("at customer, city, hall 3"), laboratory, "customer", false),
        (Some("Laboratory, Street 1, room 4"), laboratory, "laboratory", false),
        (None, None, "other", true),
    ] {
        assert_eq!(location(place, laboratory), (expected.to_owned(), is_missing), "{place:?}");
    }
}

const DCC: &str = "dcc/v3.3.0/dcc.xsd";
const QIF: &str = "qif-3.0/QIFApplications/QIFDocument_bindings_variant.xsd";

#[test]
fn certificates_are_valid_and_a_decimal_comma_is_not() {
    for (format, schema, number) in [("dcc", DCC, "1.0000231"), ("qif", QIF, "1.0000231")] {
        let text = written(format);
        // data of the campaign about the report are in their elements
        let places: &[&str] = match format {
            "dcc" => &[
                "<dcc:value>R-17 &lt;a&gt;</dcc:value>",
                "<dcc:receiptDate>2026-03-01</dcc:receiptDate>",
                "<dcc:issueDate>2026-03-09</dcc:issueDate>",
                "<dcc:performanceLocation>other</dcc:performanceLocation>",
                "<dcc:model>type</dcc:model>",
                "<dcc:content>Customer, City</dcc:content>",
                "<dcc:content>B. C., head</dcc:content>",
                "<dcc:content>R-16 of 2026-03-08: a temperature</dcc:content>",
                "<dcc:content>hall 3</dcc:content>",
                "<dcc:countryCodeISO3166_1>CA</dcc:countryCodeISO3166_1>",
                "<dcc:content>calibration of the instrument</dcc:content>",
            ],
            _ => &["<ReportNumber>R-17 &lt;a&gt;</ReportNumber>", "<LocationDescription>hall 3</LocationDescription>"],
        };
        assert!(places.iter().all(|place| text.contains(place)), "{text}");
        if let Some(answer) = valid(&text, schema) {
            assert_eq!(answer, "", "{text}");
            assert!(text.contains(number));
            let comma = valid(&text.replace(number, &number.replace('.', ",")), schema).unwrap();
            assert!(comma.contains("1,0000231"), "{format}");
        }
        // parameters only, without a covariance: missing statements are marked
        let (mut bare, mut summary) = (certified(), summary());
        bare.covariance.clear();
        (summary.measurements.operator, summary.instrument.name, summary.temperature.stated_c) = (None, None, None);
        (summary.conditions, summary.issue) = Default::default();
        let given = ExportInput { summary: Some(&summary), ..ExportInput::parameters(&bare) };
        let text = String::from_utf8(by_name(format).unwrap().write(&given).unwrap()).unwrap();
        assert!(valid(&text, schema).is_none_or(|answer| answer.is_empty()), "{text}");
        let named = "country (ZZ), customer, laboratory, place of the measurements, responsible person, instrument, calibration of the instrument, temperature";
        assert!(format != "dcc" || text.contains(named), "{text}");
    }
}

#[test]
fn a_certificate_needs_the_date_of_the_measurements() {
    let mut summary = summary();
    summary.measurements.date = Some("in spring".to_owned());
    let document = certified();
    for summary in [Some(&summary), None] {
        let given = ExportInput { summary, ..ExportInput::parameters(&document) };
        let refused = by_name("dcc").unwrap().write(&given).unwrap_err();
        assert!(refused.0[0].is("certificate-date-missing", &[]), "{refused}");
    }
}

/// Python's own reader of XML, which knows neither schema, reads values, uncertainties and
/// covariances bit for bit.
#[test]
fn certificates_read_back_bit_for_bit() {
    let folder = tempfile::tempdir().unwrap();
    for format in ["dcc", "qif"] {
        std::fs::write(folder.path().join(format), written(format)).unwrap();
    }
    let script = r#"
import xml.etree.ElementTree as E
si = '{https://ptb.de/si}'
for quantities in E.parse('dcc').getroot().iter(si + 'realListXMLList'):
    values = quantities.find(si + 'valueXMLList').text.split()
    units = quantities.find(si + 'unitXMLList').text.split()
    names = quantities.find(si + 'labelXMLList').text.split()
    assert len(values) == len(units)
    print(*zip(values, units))
    columns = list(quantities.iter(si + 'columnXMLList'))
    for column in columns:
        row = column.find('.//' + si + 'valueXMLList').text.split()
        assert len(row) == len(columns) == len(values) == len(column.find('.//' + si + 'unitXMLList').text.split())
        print('covariance', *row)
    for factor in quantities.iter(si + 'coverageFactorXMLList'): print('factor', factor.text)
q = '{http://qifstandards.org/xsd/qif3}'
root = E.parse('qif').getroot()
byid = {e.get('id'): e for e in root.iter() if e.get('id')}
assert int(root.get('idMax')) == max(map(int, byid))
for measured in root.find('.//' + q + 'CharacteristicMeasurements'):
    nominal = byid[byid[measured.find(q + 'CharacteristicItemId').text].find(q + 'CharacteristicNominalId').text]
    value = measured.find(q + 'Value')
    print('qif', nominal.find(q + 'Name').text.encode('ascii', 'replace').decode(), nominal.find(q + 'TargetValue').text, value.text, value.get('combinedUncertainty'))
"#;
    let Ok(output) = Command::new("python3").args(["-c", script]).current_dir(folder.path()).output() else {
        return skipped("python3");
    };
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let read = String::from_utf8(output.stdout).unwrap();
    let document = certified();
    let lists: Vec<&str> = read.lines().filter(|line| line.starts_with("('")).collect();
    let dsi = |unit: &str| match unit {
        "mm" => r"'\\milli\\metre'",
        "deg" => r"'\\degree'",
        _ => r"'\\one'",
    };
    let expected = |parameters: &[ParameterEntry]| {
        parameters.iter().map(|p| format!("('{:?}', {})", p.value, dsi(&p.unit))).collect::<Vec<_>>().join(" ")
    };
    assert_eq!(lists, [expected(&document.parameters[..4]), expected(&document.parameters[4..])]);
    let rows = read.lines().filter_map(|line| line.strip_prefix("covariance "));
    let rows: Vec<Vec<f64>> = rows.map(|row| row.split(' ').map(|v| v.parse().unwrap()).collect()).collect();
    assert_eq!(rows, document.covariance);
    // χ² of four degrees of freedom at 95 %: 9.4877 in every table
    let factor: f64 = read.lines().find_map(|line| line.strip_prefix("factor ")).unwrap().parse().unwrap();
    assert!((factor - 9.487_729_036_781_154_f64.sqrt()).abs() < 1e-9, "{factor}");
    let qif: Vec<Vec<&str>> =
        read.lines().filter_map(|line| line.strip_prefix("qif ")).map(|line| line.rsplitn(4, ' ').collect()).collect();
    for (fields, p) in qif.iter().zip(&document.parameters) {
        // a decimal has 24 decimals
        let same = |read: &str, value: f64| {
            (read.parse::<f64>().unwrap() - value).abs() <= if value.abs() < 1e-8 { 1e-24 } else { 0.0 }
        };
        assert!(same(fields[1], p.value) && same(fields[2], p.nominal), "{fields:?}");
        assert_eq!(fields[0].parse::<f64>().ok(), p.standard_uncertainty);
    }
    assert_eq!(qif.len(), document.parameters.len());
}

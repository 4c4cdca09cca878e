//! Damaged and hostile QIF files: an error with its place, never a panic, never more memory or time than the file is worth.

use crate::support::said::Says;
use etalon::formats::qif;

const HEAD: &str = "<QIFDocument versionQIF=\"3.0.0\"><FileUnits><PrimaryUnits><LinearUnit><UnitName>mm</UnitName>\
                    <UnitConversion><Factor>0.001</Factor></UnitConversion></LinearUnit></PrimaryUnits></FileUnits>\n";

/// A file with one plane of three points, in the units of `HEAD`.
fn plane(list: &str, set: &str) -> String {
    format!(
        "{HEAD}<Results><MeasuredFeatures n=\"1\"><PlaneFeatureMeasurement id=\"1\">\n<PointList n=\"1\">{list}</PointList>\
         </PlaneFeatureMeasurement></MeasuredFeatures>\n{set}</Results></QIFDocument>"
    )
}

const WHOLE: &str = "<WholePointSetId>2</WholePointSetId>";
const SET: &str = "<MeasuredPointSet id=\"2\" count=\"3\"><Points>0 0 0 1 0 0 <!-- here --> 0 1 0</Points>\
                   <Compensated>true</Compensated></MeasuredPointSet>";

/// A file that reads.
pub fn sound() -> String {
    plane(WHOLE, SET)
}

fn error(text: &str, parts: &[&str]) {
    let said = qif::read("f.qif", text, None).expect_err(parts[0]).to_string();
    for part in parts {
        assert!(said.says(part), "{part:?} is not said:\n{said}");
    }
    assert!(said.contains("f.qif:"), "no place:\n{said}");
    assert!(said.len() < 20_000, "{} bytes of message", said.len());
}

/// Reads it, and gives the points of its feature and what was said.
fn read(text: &str) -> (usize, String) {
    let read = qif::read("f.qif", text, None).unwrap_or_else(|e| panic!("{e}"));
    let said: Vec<String> = read.messages.iter().map(ToString::to_string).collect();
    assert!(said.iter().all(|m| m.contains("f.qif:")), "no place: {said:?}");
    (read.features[0].points_mm.len(), said.join("\n"))
}

#[test]
fn the_base_is_sound() {
    assert_eq!(read(&sound()), (3, String::new()));
}

#[test]
fn entity_bombs_and_document_types_are_refused() {
    let bomb =
        "<?xml version=\"1.0\"?>\n<!DOCTYPE lolz [<!ENTITY a \"lol\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;&a;\">]>\n";
    error(&format!("{bomb}{}", plane(WHOLE, SET)), &["[xml-doctype]", "f.qif:2", "hint:"]);
    error(&plane(WHOLE, &SET.replace("0 0 0", "&b; 0 0")), &["[xml-malformed]", "`&b;`", "f.qif:4"]);
    let external = "<!DOCTYPE q SYSTEM \"file:///etc/passwd\">";
    error(&format!("{external}{}", plane(WHOLE, SET)), &["[xml-doctype]"]);
}

#[test]
fn deep_nesting_ends_at_once() {
    let deep = "<a>".repeat(1_000_000);
    error(&format!("{HEAD}{deep}"), &["[nested-too-deep]", "65 levels"]);
    error(&format!("{HEAD}<Product>{deep}"), &["[nested-too-deep]", "65 levels"]);
}

#[test]
fn every_truncation_is_an_error_and_none_panics() {
    let whole = plane(WHOLE, SET);
    for end in 0..whole.len() {
        let cut = &whole[..end];
        if let Err(problems) = qif::read("f.qif", cut, None) {
            assert!(!problems.to_string().is_empty());
        } else {
            panic!("cut at {end} of {} it was read", whole.len());
        }
    }
    error(&whole[..whole.len() - "</QIFDocument>".len()], &["[file-cut-off]", "`</QIFDocument>`", "hint:"]);
    // within an element that is not read
    let product = whole.replacen("<Results>", "<Product><Part>1 2 3</Part></Product><Results>", 1);
    let end = product.find("</Part>").unwrap();
    (product.find("<Product>").unwrap() + 9..end + 20).for_each(|end| drop(qif::read("f.qif", &product[..end], None)));
    error(&product[..end], &["[file-cut-off]", "`</QIFDocument>`"]);
}

#[test]
fn every_byte_may_be_damaged() {
    let whole = plane(WHOLE, SET);
    for at in 0..whole.len() {
        for byte in [b'<', b'>', b'&', b'"', b'9', b'-', b' ', b'e', 0, 0x1b] {
            let mut bytes = whole.clone().into_bytes();
            bytes[at] = byte;
            let text = String::from_utf8(bytes).unwrap();
            if let Ok(read) = qif::read("f.qif", &text, None) {
                let finite = read.features.iter().flat_map(|f| &f.points_mm).flatten().all(|x| x.is_finite());
                assert!(finite, "{text}");
            }
        }
    }
    error(&whole.replace("0 1 0", "0 \0 0"), &["[nul-byte]", "f.qif:4"]);
}

#[test]
fn numbers_that_are_none_are_errors_with_their_line() {
    for wrong in ["nan", "INF", "1,5", "1e999", "0x10", "1.2.3", "--1"] {
        error(&plane(WHOLE, &SET.replace("1 0 0", &format!("{wrong} 0 0"))), &[wrong, "[not-a-number]", "f.qif:4"]);
    }
}

#[test]
fn units_are_never_guessed() {
    let text = plane(WHOLE, SET);
    let without = text.replace("LinearUnit>", "AreaUnit>");
    error(&without, &["[file-unit-missing]", "unit of length", "--unit"]);
    // stated by the user, or by the point set itself
    let inches = qif::read("f.qif", &without, Some(25.4)).unwrap();
    assert_eq!(inches.features[0].points_mm[1], [25.4, 0.0, 0.0]);
    let own = "<Units><LinearUnit><UnitName>in</UnitName><UnitConversion><Factor>0.0254</Factor></UnitConversion></LinearUnit></Units>";
    let own = without.replace("<Points>", &format!("{own}<Points>"));
    assert_eq!(qif::read("f.qif", &own, None).unwrap().features[0].points_mm[2], [0.0, 25.4, 0.0]);
    let contradicted = qif::read("f.qif", &text, Some(25.4)).unwrap_err().to_string();
    assert!(contradicted.says("[unit-differs] of_file=mm how=FileUnits"), "{contradicted}");
    for (from, to, said) in [
        ("<Factor>0.001</Factor>", "<Factor>0</Factor>", "[unit-factor-invalid]"),
        ("<Factor>0.001</Factor>", "<Factor>0.001</Factor><Offset>1</Offset>", "offset 1"),
        ("<UnitConversion><Factor>0.001</Factor></UnitConversion>", "", "[record-missing]"),
        ("<UnitName>mm", "<SIUnitName>foot</SIUnitName><UnitName>mm", "[unit-unknown]: `foot`"),
    ] {
        error(&text.replace(from, to), &[said]);
    }
}

#[test]
fn a_value_may_bear_its_own_unit() {
    let other = "</PrimaryUnits><OtherUnits><LinearUnit><UnitName>inch</UnitName><UnitConversion><Factor>0.0254</Factor>\
                 </UnitConversion></LinearUnit></OtherUnits>";
    let sphere = "<Results><SphereFeatureMeasurement id=\"1\"><Location>1 2 3</Location>\
                  <Diameter linearUnit=\"inch\">2</Diameter></SphereFeatureMeasurement></Results></QIFDocument>";
    let text = HEAD.replace("</PrimaryUnits>", other) + sphere;
    let stated = qif::read("f.qif", &text, None).unwrap().features[0].stated;
    assert_eq!((stated.point_mm, stated.radius_mm), (Some([1.0, 2.0, 3.0]), Some(25.4)));
    error(&text.replace("\"inch\"", "\"cubit\""), &["[unit-unknown]: `cubit`", "inch, mm"]);
}

#[test]
fn references_and_ranges_that_lead_nowhere_are_reported() {
    let range = |text: &str| format!("<RangePointSetId range=\"{text}\">2</RangePointSetId>");
    assert_eq!(read(&plane(&range("2 3"), SET)), (2, String::new()));
    assert_eq!(read(&plane("<SinglePointSetId index=\"1\">2</SinglePointSetId>", SET)).0, 1);
    for wrong in ["0 2", "1 4", "3 2", "-1 2", "", "1 2 3", "99999999999999999999 1", "a b"] {
        let (points, said) = read(&plane(&range(wrong), SET));
        assert_eq!(points, 0, "{wrong}");
        assert!(
            said.contains("[point-range-invalid]") && said.contains("point set 2") && said.contains("f.qif:3"),
            "{wrong}: {said}"
        );
    }
    let (points, said) = read(&plane("<WholePointSetId>3</WholePointSetId>", SET));
    assert!(
        points == 0
            && said.contains("[reference-broken]")
            && said.contains("`WholePointSetId` refers to 3")
            && said.has_phrase("did-you-mean name=2"),
        "{said}"
    );
    let (points, said) = read(&plane("<WholePointSetId xId=\"7\">2</WholePointSetId>", SET));
    assert!(points == 0 && said.contains("[reference-external]"), "{said}");
    let item = "<PointList n=\"1\">";
    let (_, said) = read(&plane(WHOLE, SET).replace(item, &format!("<FeatureItemId>9</FeatureItemId>{item}")));
    assert!(said.says("[reference-broken] name=FeatureItemId id=9"), "{said}");
    let (_, said) = read(&plane(WHOLE, &SET.repeat(2)));
    assert!(said.says("[id-repeated] id=2"), "{said}");
}

#[test]
fn point_sets_that_contradict_themselves_give_no_points() {
    for (from, to, expected) in [
        ("count=\"3\"", "count=\"4\"", "[stated-count-differs] name=Points found=9"),
        ("count=\"3\"", "count=\"99999999999999999999\"", ""),
        ("count=\"3\"", "count=\"6148914691236517206\"", "[stated-count-differs] name=Points found=9"),
        ("0 1 0</", "0 1</", "`Points` has 8 values"),
        ("<Compensated>true</Compensated>", "", "[record-missing]"),
        ("<Compensated>true", "<Compensated>maybe", "`maybe`"),
        ("<Compensated>true</Compensated>", "<Compensations>true true</Compensations>", "`Compensations` has 2 values"),
        ("<Compensated>true</Compensated>", "<Compensations>true true false</Compensations>", "[compensation-mixed]"),
        ("<Points>", "<TranformId>5</TranformId><Points>", "[element-unsupported]"),
        ("<Points>", "<BinaryPoints/><Points>", "[element-unsupported]"),
    ] {
        let (points, said) = read(&plane(WHOLE, &SET.replace(from, to)));
        let sound = expected.is_empty();
        assert!(said.says(expected) && (points == 0) != sound, "{to}: {points} points, {said}");
    }
    let (points, said) = read(&plane(WHOLE, SET).replace("<PointList n=\"1\">", "<PointList n=\"2\">"));
    assert!(
        points == 0 && said.contains("[stated-count-differs]") && said.contains("`PointList` has 1 value"),
        "{said}"
    );
    let empty = "<MeasuredPointSet id=\"2\" count=\"0\"><Points/><Compensations/><ProbeRadii/></MeasuredPointSet>";
    assert_eq!(read(&plane(WHOLE, empty)).0, 0);
}

#[test]
fn one_set_that_many_features_share_does_not_fill_the_memory() {
    let set = format!(
        "<MeasuredPointSet id=\"2\" count=\"10000\"><Points>{}</Points><Compensated>true</Compensated></MeasuredPointSet>",
        "1 2 3 ".repeat(10_000)
    );
    let features =
        format!("<PlaneFeatureMeasurement id=\"1\"><PointList n=\"1\">{WHOLE}</PointList></PlaneFeatureMeasurement>");
    let text = format!("{HEAD}<Results>{}{set}</Results></QIFDocument>", features.repeat(2000));
    let read = qif::read("f.qif", &text, None).unwrap();
    let points: usize = read.features.iter().map(|f| f.points_mm.len()).sum();
    assert!(points <= 1 << 23, "{points}");
    assert!(read.messages.len() <= 51, "{}", read.messages.len());
}

#[test]
fn other_documents_are_told_apart() {
    error("<html/>", &["[format-differs]", "`QIFDocument`"]);
    error("", &["[format-differs]"]);
    error(&plane(WHOLE, SET).replace("3.0.0", "4.0.0"), &["[version-unsupported]", "`4.0.0`"]);
    error(&format!("{}<b></b>", plane(WHOLE, SET)), &["[xml-malformed]", "second root element"]);
    error(&format!("{}<b/>", plane(WHOLE, SET)), &["[xml-malformed]", "second root element"]);
}

#[test]
fn time_grows_with_the_file_and_not_with_its_square() {
    // each is an answer within a second, and on a busy machine within a minute; in the square of the size it would be hours
    let quick = |text: String| {
        let start = std::time::Instant::now();
        let read = qif::read("f.qif", &text, None).unwrap();
        assert!(start.elapsed().as_secs() < 60, "{:?}", start.elapsed());
        read
    };
    let astray = "<PlaneFeatureMeasurement id=\"9\"><FeatureItemId>7</FeatureItemId><PointList n=\"1\"><WholePointSetId>3\
                  </WholePointSetId></PointList></PlaneFeatureMeasurement>\n";
    let sets: String = (0..20_000).map(|i| format!("<MeasuredPointSet id=\"s{i}\"/>\n")).collect();
    let read = quick(format!("{HEAD}<Results>{}{sets}</Results></QIFDocument>", astray.repeat(50_000)));
    assert!(read.messages.len() <= 51);
    let attributes: String = (0..200_000).map(|i| format!(" a{i}=\"\"")).collect();
    quick(format!("{HEAD}<Results{attributes}/></QIFDocument>"));
    let pieces = format!("<Results>{}x{}</Results>", " ".repeat(1_000_000), "<!---->y".repeat(200_000));
    quick(format!("{HEAD}{pieces}</QIFDocument>"));
}

//! Real exports of measuring systems: read with the counts and units that their READMEs state, or refused with the reason
//! that they give. Numbers that are expected stand in the files themselves.

use crate::support::said::Says;
use crate::support::scratch::copy_sample;
use etalon::base::phrase;
use etalon::base::pose::Vector;
use etalon::campaign::Campaign;
use etalon::documents::Source;
use etalon::formats::Format;
use etalon::formats::dialect::Unit;
use etalon::formats::exports::{dmis, polyworks_report};
use etalon::formats::labelled_points;
use etalon::stages::gather::gather;
use etalon::tables::Decimal;

/// Labels and points in mm, and the file with what of it was refused; or what is said against it.
fn read(file: &str, format: &str, unit: &str) -> Result<(Vec<(String, Vector)>, Source), String> {
    let scratch = copy_sample("prexyt-cmm");
    let text = format!(
        "name = \"l\"\nrobot = \"robot.toml\"\nlog = []\n[instrument]\nname = \"i\"\nexpanded_uncertainty_um = 2\n\
         coverage_factor = 2\n[[export]]\nfile = \"$ETALON_REFERENCE/{file}\"\nformat = {format}\nunit = \"{unit}\"\n\
         [join]\nby = \"row\"\n[frame.world]\nas_exported = true\n[identify]\ncalibration = \"all\"\n"
    );
    std::fs::write(scratch.path().join("campaign.toml"), text).unwrap();
    let campaign = Campaign::read(&scratch.path()).unwrap_or_else(|e| panic!("{e}"));
    let imported = gather(&campaign).map_err(|e| e.to_string())?;
    let points = imported.points.into_iter().map(|p| (p.label.to_string(), p.xyz_mm)).collect();
    Ok((points, imported.document.sources.into_iter().find(|s| s.kind.name() == "export").unwrap()))
}

/// What is said against a file, which must hold all these parts.
fn refused(file: &str, format: &str, unit: &str, parts: &[&str]) {
    let said = read(file, format, unit).expect_err(file);
    for part in parts {
        assert!(said.says(part), "{file}: {part:?} is not said:\n{said}");
    }
}

fn there(folder: &str) -> bool {
    crate::reference_data(folder).is_some()
}

fn text(file: &str) -> String {
    std::fs::read_to_string(format!("{}/{file}", std::env::var("ETALON_REFERENCE").unwrap())).unwrap()
}

#[test]
fn calypso_characteristics_of_one_feature_without_z_are_told() {
    if !there("exports/calypso") {
        return;
    }
    // three rows of one feature: xValue, yValue, diameter
    let (points, source) = read("exports/calypso/excerpt_chr.txt", "\"calypso\"", "mm").unwrap();
    assert!(points.is_empty());
    let told: Vec<_> = source.refused.iter().map(|r| (r.line, r.reason.english())).collect();
    assert_eq!(told, [(2, "not a point: X, Y, diameter without Z")]);
    // the column `unit` says mm
    refused(
        "exports/calypso/excerpt_chr.txt",
        "\"calypso\"",
        "inch",
        &["[unit-differs] of_file=mm how=unit", "_chr.txt:2:"],
    );
}

#[test]
fn dmis_output_of_nist_has_one_circle_and_its_programs_nothing_measured() {
    if !there("exports/dmis") {
        return;
    }
    let (points, source) = read("exports/dmis/output.dms", "\"dmis\"", "mm").unwrap();
    assert_eq!(points, [("A_CIRCLE".to_owned(), [50.0, 50.0, 40.0])]);
    assert!(source.refused.is_empty());
    let circle =
        &dmis::features("f", &text("exports/dmis/output.dms"), dmis::DirectionNotation::Vectors, Unit::Millimetre)
            .unwrap()[0];
    assert_eq!((circle.direction, circle.diameter_mm), (Some([0.0, 0.0, 1.0]), Some(50.0)));
    refused("exports/dmis/output.dms", "\"dmis\"", "inch", &["[unit-differs]", "mm (UNITS)", "output.dms:2:7"]);
    for program in ["simple_in.dms", "IMTS_M_clean.dmi"] {
        refused(&format!("exports/dmis/{program}"), "\"dmis\"", "mm", &["[no-measured-points]", "a measuring program"]);
    }
}

#[test]
fn trap_13_and_17_geopak_writes_angles_under_the_name_of_iges() {
    if !there("exports/dmis") {
        return;
    }
    let file = "exports/dmis/geopak_dmis_excerpt.igs";
    // no UNITS in the file: inch, as its README says (0.4375 = 7/16 inch), because the campaign states it
    let (points, source) = read(file, "\"geopak_dmis\"", "inch").unwrap();
    let labels: Vec<&str> = points.iter().map(|(label, _)| label.as_str()).collect();
    assert_eq!(labels, ["FeatureID_2", "FeatureID_3"]);
    assert_eq!(points[1].1, [3.349968393187 * 25.4, -1.313496902315 * 25.4, -1.431274697897 * 25.4]);
    let told: Vec<usize> = source.refused.iter().map(|r| r.line).collect();
    let reason = phrase!("feature-of-no-point", kind = "PLANE");
    assert_eq!((told, source.refused[0].reason.phrase()), (vec![4, 11, 14], Some(&reason)));
    let features = dmis::features("f", &text(file), dmis::DirectionNotation::Angles, Unit::Inch).unwrap();
    let kinds: Vec<&str> = features.iter().map(|f| f.kind.as_str()).collect();
    assert_eq!(kinds, ["PLANE", "CIRCLE", "POINT", "LINE", "CYLNDR"]);
    for feature in features.iter().filter(|f| f.kind != "POINT") {
        let length = feature.direction.unwrap().iter().map(|c| c * c).sum::<f64>().sqrt();
        assert!((length - 1.0).abs() < 1e-6, "{feature:?}");
    }
    assert!(features[2].direction.is_none());
    assert!((features[1].diameter_mm.unwrap() / 25.4 - 7.0 / 16.0).abs() < 1e-4);
    refused(
        file,
        "\"dmis\"",
        "inch",
        &["[direction-notation-differs]", "`format = \"geopak_dmis\"`", "excerpt.igs:6:1"],
    );
    refused(
        "exports/dmis/output.dms",
        "\"geopak_dmis\"",
        "mm",
        &["[direction-notation-differs]", "`format = \"dmis\"`"],
    );
}

#[test]
fn trap_14_a_scan_in_the_plane_yz_has_its_coordinates_in_the_order_y_z_x() {
    if !there("exports/geopak_mitutoyo") {
        return;
    }
    let (points, _) = read("exports/geopak_mitutoyo/doc_example1.gws", "\"geopak_gws\"", "mm").unwrap();
    let expected = [[100.0, 1.0, 105.0], [110.0, 11.0, 105.0], [115.0, 22.0, 105.0]];
    assert_eq!(points, expected.map(|p| ("Gap1-2".to_owned(), p)));
    let (points, _) = read("exports/geopak_mitutoyo/doc_example2_inch.gws", "\"geopak_gws\"", "inch").unwrap();
    let second = [[97.19450, 102.28550], [96.99757, 102.11020], [96.99757, 102.11020], [96.93384, 102.05040]];
    let expected = second.map(|[y, z]| (String::new(), [0.0, y * 25.4, z * 25.4]));
    assert_eq!(points, expected);
    refused(
        "exports/geopak_mitutoyo/doc_example2_inch.gws",
        "\"geopak_gws\"",
        "mm",
        &["the file is in inch (#06)", ":4:1"],
    );
}

#[test]
fn polyworks_report_has_one_control_which_is_no_point() {
    if !there("exports/polyworks") {
        return;
    }
    let file = "exports/polyworks/excerpt_report.csv";
    let controls = polyworks_report::controls("f", &text(file), Decimal::Point).unwrap();
    assert_eq!(controls.len(), 1);
    let control = &controls[0];
    assert_eq!((control.name.as_str(), control.control.as_str()), ("A5 distance", "Y Distance"));
    assert_eq!((control.nominal, control.measured, control.tolerance), (Some(95.0), Some(120.007), Some((2.0, -2.0))));
    let (points, source) = read(file, "\"polyworks_report\"", "mm").unwrap();
    assert!(points.is_empty());
    assert_eq!(source.refused[0].reason.english(), "not a point: Y Distance without X, Y, Z");
}

#[test]
fn inspec_reads_every_measured_point_of_the_optics_run_under_its_feature() {
    if !there("exports/microvu_inspec") {
        return;
    }
    let file = "exports/microvu_inspec/inspec_export.csv";
    let (points, source) = read(file, "\"inspec\"", "mm").unwrap();
    let all = text(file);
    let unlabelled =
        |commas: usize| all.lines().filter(|l| !l.starts_with('"') && l.matches(',').count() == commas).count();
    let measured = unlabelled(2) + all.matches("3D MCS Points\",").count();
    let computed = all.matches(": Location X\"").count() + all.matches(": Center X\"").count();
    assert_eq!((measured, points.len(), source.refused.len()), (19474, measured + computed, 2));
    // two values without a label
    assert_eq!(source.refused.iter().map(|r| r.text.as_str()).collect::<Vec<_>>(), ["1.3000", "-0.0030"]);
    let of = |label: &str| points.iter().filter(|(l, _)| l == label).map(|(_, p)| *p).collect::<Vec<Vector>>();
    assert_eq!(of("Point 8"), [[142.9663, 233.9892, 37.7155]]);
    assert_eq!(of("Point 8: Location"), of("Point 8"));
    assert_eq!(of("Line 10"), [[142.9663, 233.9892, 37.7155], [143.0290, 232.3502, 37.4685]]);
    assert_eq!(of("Circle OD: Center"), [[143.1233, 233.0849, 40.1423]]);
    assert_eq!(of("Circle OD")[0], [114.0700, 282.6330, 39.7045]);
}

#[test]
fn trap_20_vda_fs_files_without_measured_points_or_without_the_end_of_the_norm_are_refused() {
    if !there("exports/vda_fs") {
        return;
    }
    // two of the three lack `NAME = END`
    for (file, entity, ended) in
        [("CURVE_SP1", "1 CURVE", false), ("FC267", "CONS", true), ("SURF_FLAE0001", "1 SURF", false)]
    {
        let file = format!("exports/vda_fs/{file}.vda");
        refused(&file, "\"vda_fs\"", "mm", &["[no-measured-points]", entity, "`POINT, PSET, MDI`"]);
        let said = read(&file, "\"vda_fs\"", "mm").unwrap_err();
        assert_eq!(!said.contains("[file-cut-off]"), ended, "{said}");
    }
}

#[test]
fn the_project_description_of_polyworks_has_56_points() {
    if !there("robots/qkm_polyworks") {
        return;
    }
    let folder = "robots/qkm_polyworks";
    let (points, source) =
        read(&format!("{folder}/polyworks_inspector_project_description.txt"), "\"polyworks_project\"", "mm").unwrap();
    assert_eq!((points.len(), source.refused.len()), (56, 0));
    assert_eq!(points[0], ("ref_1 -meas-".to_owned(), [3498.663330078125, 628.228759765625, -618.720703125]));
    assert_eq!(points.iter().filter(|(label, _)| label.starts_with("pos")).count(), 50);
    refused(&format!("{folder}/workspace1.pwk"), "\"polyworks_project\"", "mm", &["[format-differs]", ".pwk:1"]);
    refused(&format!("{folder}/polyworks_objectmodel.xml.gz"), "\"polyworks_project\"", "mm", &["objectmodel.xml.gz"]);
}

#[test]
fn the_points_of_the_hl6_are_read_with_their_counts_and_its_mixed_separators_refused() {
    if !there("robots/qkm_polyworks") {
        return;
    }
    let blank = "{ delimiter = \"blank\", columns = [\"x\", \"y\", \"z\"] }";
    for (file, count) in [
        ("data_points_cali__c_poses", 46),
        ("data_points_cali__re_ref", 3),
        ("data_points_cali__re_smr", 3),
        ("data_points_cali__re_poses", 50),
        ("2020-01-19__re_poses", 50),
        ("data_pose_cali__POSES", 30),
        ("data_pose_cali__ref", 3),
        ("data_pose_cali__init_SMRs", 3),
    ] {
        let (points, source) = read(&format!("robots/qkm_polyworks/{file}.txt"), blank, "mm").unwrap();
        assert_eq!((points.len(), source.refused.len()), (count, 0), "{file}");
    }
    refused("robots/qkm_polyworks/data_points_cali__test_poses.txt", blank, "mm", &["[row-field-count]", "1 field"]);
    let comma = "{ delimiter = \",\", columns = [\"x\", \"y\", \"z\"] }";
    assert_eq!(read("robots/qkm_polyworks/data_points_cali__test_poses.txt", comma, "mm").unwrap().0.len(), 9);
    // the controller's program is no table
    refused(
        "robots/qkm_polyworks/2020-01-19__angle_info.txt",
        blank,
        "mm",
        &[
            "angle_info.txt:1\n",
            "9 fields; also in lines 2, 3 and 503 more rows",
            "1 field; also in lines 26, 35 and 60 more rows",
        ],
    );
}

#[test]
fn the_yaml_and_xml_of_the_positioner_are_refused() {
    if !there("robots/rct_two_axis_positioner") {
        return;
    }
    let folder = "robots/rct_two_axis_positioner";
    for file in ["positioner_kinematic_measurements.yaml", "initial_guess.launch.xml"] {
        refused(&format!("{folder}/{file}"), "\"polyworks\"", "m", &[&format!("{file}:1")]);
    }
}

#[test]
fn the_68_columns_of_a_calypso_head_hold_its_unit_and_temperature_and_no_points() {
    if !there("exports/calypso") {
        return;
    }
    let names = text("exports/calypso/hdr_column_names.txt");
    let names: Vec<&str> = names.split_whitespace().collect();
    assert_eq!(names.len(), 68);
    // a row that is made up, under the names that were published
    let value = |name: &&str| match *name {
        "lengthunit" => "mm",
        "temperatureworkpiece" => "20.7",
        _ => "",
    };
    let row: Vec<&str> = names.iter().map(value).collect();
    let head = format!("{}\n{}\nEND\n", names.join("\t"), row.join("\t"));
    let format = Format::named("calypso").unwrap();
    let said = labelled_points("hdr.txt", &head, &format, Unit::Millimetre).unwrap_err().to_string();
    for part in ["[no-measured-points]", "`mm`", "20.7 °C", "hdr.txt:1"] {
        assert!(said.says(part), "{part}: {said}");
    }
}

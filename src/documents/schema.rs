//! JSON Schemas of documents and input files: the committed files of `schemas/`. Tests with the
//! feature `schemas` derive them from the types.

/// Defines a list of names and JSON Schemas, and the test that derives the schemas from the types.
#[macro_export]
macro_rules! schemas {
    ($(#[$doc:meta])* $all:ident in $folder:literal: $($name:literal $type:ty,)*) => {
        $(#[$doc])*
        pub const $all: &[(&str, &str)] =
            &[$(($name, include_str!(concat!($folder, "/", $name, ".schema.json"))),)*];

        #[cfg(all(test, feature = "schemas"))]
        #[test]
        fn committed_schemas_are_current() {
            $($crate::schema::compare::<$type>($name);)*
        }
    };
}

schemas! {
    /// Name and schema of every document.
    SCHEMAS in "../../schemas":
    "accuracy" AccuracyDocument,
    "axes" AxesDocument,
    "batch" BatchDocument,
    "benchmark-score" BenchmarkScoreDocument,
    "campaign" CampaignSummary,
    "cell" CellDocument,
    "check" CheckDocument,
    "compare" CompareDocument,
    "compensation" CompensationDocument,
    "controllers" ControllersDocument,
    "explanation" ExplanationDocument,
    "features" FeaturesDocument,
    "field" FieldDocument,
    "fit" FitDocument,
    "formats" FormatsDocument,
    "frames" FramesDocument,
    "geometric" GeometricDocument,
    "import" ImportDocument,
    "iso230" AxisDocument,
    "iso9283" Iso9283Document,
    "iso9283-compliance" Iso9283ComplianceDocument,
    "iso9283-plan" Iso9283PlanDocument,
    "iso9283-stream" Iso9283StreamDocument,
    "iso9283-streams" Iso9283StreamsDocument,
    "kinematics" KinematicsDocument,
    "manifest" ManifestDocument,
    "parameters" ParametersDocument,
    "plan" PlanDocument,
    "predictions" PredictionsDocument,
    "recommendation" RecommendationDocument,
    "selftest" SelftestDocument,
    "study" StudiesDocument,
    "uncertainty" UncertaintyDocument,
    "verdict" VerdictDocument,
    "verification" VerificationDocument,
    "verification-plan" VerificationPlanDocument,
    "written" WrittenDocument,
}

#[cfg(all(test, feature = "schemas"))]
use crate::*;

/// Compares the schema of a type with the committed file; `ETALON_UPDATE=1` writes the file.
///
/// # Panics
/// Panics if the two differ.
#[cfg(feature = "schemas")]
pub fn compare<T: schemars::JsonSchema>(name: &str) {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../schemas");
    let path = folder.join(format!("{name}.schema.json"));
    let derived = serde_json::to_string_pretty(&schemars::schema_for!(T)).unwrap_or_default() + "\n";
    if std::env::var_os("ETALON_UPDATE").is_some() {
        let _ = std::fs::write(&path, &derived);
    }
    let committed = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(committed == derived, "{} is not current: run with ETALON_UPDATE=1", path.display());
}

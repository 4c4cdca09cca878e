//! JSON Schema of every document, generated from its type.

use crate::*;
use schemars::JsonSchema;

/// Name and schema of every document, as in `schemas/`.
pub fn all() -> Vec<(&'static str, String)> {
    vec![
        ("accuracy", schema::<AccuracyDocument>()),
        ("axes", schema::<AxesDocument>()),
        ("batch", schema::<BatchDocument>()),
        ("benchmark-score", schema::<BenchmarkScoreDocument>()),
        ("campaign", schema::<CampaignSummary>()),
        ("cell", schema::<CellDocument>()),
        ("check", schema::<CheckDocument>()),
        ("compare", schema::<CompareDocument>()),
        ("compensation", schema::<CompensationDocument>()),
        ("controllers", schema::<ControllersDocument>()),
        ("explanation", schema::<ExplanationDocument>()),
        ("field", schema::<FieldDocument>()),
        ("fit", schema::<FitDocument>()),
        ("features", schema::<FeaturesDocument>()),
        ("formats", schema::<FormatsDocument>()),
        ("frames", schema::<FramesDocument>()),
        ("geometric", schema::<GeometricDocument>()),
        ("import", schema::<ImportDocument>()),
        ("iso230", schema::<AxisDocument>()),
        ("iso9283", schema::<Iso9283Document>()),
        ("iso9283-compliance", schema::<Iso9283ComplianceDocument>()),
        ("iso9283-plan", schema::<Iso9283PlanDocument>()),
        ("iso9283-stream", schema::<Iso9283StreamDocument>()),
        ("iso9283-streams", schema::<Iso9283StreamsDocument>()),
        ("kinematics", schema::<KinematicsDocument>()),
        ("manifest", schema::<ManifestDocument>()),
        ("parameters", schema::<ParametersDocument>()),
        ("plan", schema::<PlanDocument>()),
        ("predictions", schema::<PredictionsDocument>()),
        ("recommendation", schema::<RecommendationDocument>()),
        ("selftest", schema::<SelftestDocument>()),
        ("study", schema::<StudiesDocument>()),
        ("uncertainty", schema::<UncertaintyDocument>()),
        ("verdict", schema::<VerdictDocument>()),
        ("verification", schema::<VerificationDocument>()),
        ("verification-plan", schema::<VerificationPlanDocument>()),
        ("written", schema::<WrittenDocument>()),
    ]
}

/// Returns the schema of a type as text.
pub fn schema<T: JsonSchema>() -> String {
    // a schema is plain JSON, which can always be written
    serde_json::to_string_pretty(&schemars::schema_for!(T)).unwrap_or_default() + "\n"
}

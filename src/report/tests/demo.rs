//! Documents for trying the report: a campaign like the thesis', with synthetic errors.

use etalon_base::message::{Message, Place};
use etalon_base::noise::Noise;
use etalon_base::pose::{Pose, Vector};
use etalon_base::worded::Worded;
use etalon_documents::ResidualKind;
use etalon_documents::Termination;
use etalon_documents::*;

/// Error of pose `pose`, cycle 1, target K, calibration.
pub(crate) fn point(pose: i64, at_mm: Vector, before_mm: Vector, after_mm: Vector) -> PointError {
    let (set, target) = (PoseSet::Calibration, "K".to_owned());
    PointError {
        set,
        pose: pose.into(),
        cycle: 1,
        target,
        quantity: ErrorQuantity::Position,
        at_mm,
        before_mm,
        after_mm,
        before_deg: None,
        after_deg: None,
        joints: vec![],
        control: Default::default(),
    }
}

/// Documents of a report.
pub(crate) struct Documents {
    pub campaign: CampaignSummary,
    pub import: ImportDocument,
    pub features: FeaturesDocument,
    pub frames: FramesDocument,
    pub parameters: ParametersDocument,
    pub accuracy: AccuracyDocument,
    pub errors: Vec<PointError>,
    pub tested: Characteristics,
}

impl Documents {
    pub fn results(&self) -> Results {
        let results = Results {
            campaign: self.campaign.clone(),
            import: self.import.clone(),
            features: self.features.clone(),
            frames: self.frames.clone(),
            identified: Some(self.identified()),
            geometric: None,
            controllers: None,
            tested: self.tested.clone(),
            verdict: VerdictDocument::default(),
        };
        results.judged()
    }

    pub fn identified(&self) -> IdentifiedDocuments {
        IdentifiedDocuments {
            parameters: self.parameters.clone(),
            accuracy: self.accuracy.clone(),
            errors: self.errors.clone(),
            field: None,
        }
    }

    /// A campaign like the thesis': 59 poses on two circles, 5 cycles, errors of the size of table
    /// 3.4.
    pub fn demo() -> Self {
        let errors = errors();
        let statistics =
            |factor: f64| Statistics { mean: 0.9 * factor, rms: factor, p95: 1.4 * factor, max: 1.7 * factor };
        let error = |quantity, unit: &str, before: f64, after: f64| ErrorStatistics {
            quantity,
            count: 255,
            poses: 51,
            unit: unit.to_owned(),
            before: statistics(before),
            after: statistics(after),
            expanded_uncertainty: (quantity == ErrorQuantity::Position).then_some(0.0038),
        };
        let set = |name, poses: usize| AccuracySet {
            name,
            poses,
            count: 5 * poses,
            errors: vec![
                error(ErrorQuantity::Position, "mm", 1.2291, 0.0260),
                error(ErrorQuantity::X, "mm", 1.2245, 0.0188),
                error(ErrorQuantity::Y, "mm", 0.1063, 0.0180),
                error(ErrorQuantity::Orientation, "deg", 0.1035, 0.0033),
            ],
            readings: Vec::new(),
        };
        let limit =
            |name, limit: f64, value: f64| LimitVerdict::judge(name, limit, value, Some(0.0038), DecisionRule::Guarded);
        Self {
            tested: Characteristics::default(),
            campaign: campaign(),
            import: import(),
            features: features(),
            frames: frames(),
            parameters: parameters(),
            accuracy: AccuracyDocument {
                campaign: None,
                provenance: None,
                field: None,
                given: None,
                joints: vec![],
                trends: vec![],
                parameter_influences: Vec::new(),
                schema: "etalon/accuracy/1".to_owned(),
                point: Worded::stored(
                    "platform centre (from the balls)".to_owned(),
                    Some(etalon_base::phrase!("platform-as-measured")),
                ),
                definition: "Error: measured minus predicted. Before: nominal parameters, base and targets fitted."
                    .into(),
                sets: vec![set(PoseSet::Calibration, 8), set(PoseSet::Validation, 51)],
                placed_apart: Vec::new(),
                effects: Vec::new(),
                left_out: None,
                validation_distance: Some(ValidationDistance { median: 0.62, largest: 0.81, poses: 51, outside: 3 }),
                relative: Some(relative()),
                budget: Vec::new(),
                orientation_budget: None,
                limits: vec![
                    limit(LimitQuantity::PositionMaxMm, 0.050, 0.0442),
                    limit(LimitQuantity::OrientationMaxDeg, 0.010, 0.0056),
                ],
                tool: None,
                map: None,
            },
            errors,
        }
    }
}

fn errors() -> Vec<PointError> {
    let mut noise = Noise::new(7, 0);
    let mut errors = vec![];
    for pose in 1..=59_i32 {
        let (ring, turn) = (pose % 3, f64::from(pose) * 2.399_963);
        let radius = [0.0, 42.5, 85.0][ring as usize];
        let (x, y) = (150.0 + radius * turn.cos(), 120.0 + radius * turn.sin());
        for cycle in 1..=5 {
            let mut draw = || noise.gaussian(0.003);
            let bend = 0.02 * (y - 120.0) / 85.0;
            errors.push(PointError {
                set: if pose <= 8 { PoseSet::Calibration } else { PoseSet::Validation },
                pose: i64::from(pose).into(),
                cycle,
                target: "C".to_owned(),
                quantity: ErrorQuantity::Position,
                at_mm: [x, y, 0.0],
                before_mm: [1.2 + 0.0022 * (x - 150.0) + draw(), 0.1 + 0.0012 * (y - 120.0) + draw(), 0.0],
                after_mm: [bend + draw(), 0.008 * (x - 150.0) / 85.0 + draw(), 0.0],
                before_deg: Some(0.1 + draw()),
                after_deg: Some(draw()),
                joints: vec![],
                control: Default::default(),
            });
        }
    }
    errors
}

/// Summary of the campaign.
fn campaign() -> CampaignSummary {
    CampaignSummary {
        name: "PreXYT, CMM, spring check".to_owned(),
        robot: None,
        measurements: MeasurementSummary {
            synthetic: Some("made by `etalon simulate` with seed 7".to_owned()),
            notes: None,
            date: Some("2011-05-12".to_owned()),
            operator: Some("N. N.".to_owned()),
        },
        instrument: InstrumentSummary {
            name: Some("Mitutoyo BRIGHT-STRATO 7106".to_owned()),
            expanded_uncertainty_um: Some(2.7),
            coverage_factor: Some(2.0),
            expanded_position_uncertainty_um: None,
        },
        limits: LimitsSummary::default(),
        contact: None,
        temperature: TemperatureSummary { stated_c: Some(20.1), range_c: None },
        conditions: Conditions::default(),
        valid_until: None,
        controller_files: Vec::new(),
        issue: Issue::default(),
        report: Presentation::default(),
    }
}

fn import() -> ImportDocument {
    let source = |file: &str, kind, dialect: &str, refused: Vec<Refused>| Source {
        file: file.to_owned(),
        sha256: etalon_base::files::sha256(file.as_bytes()),
        sha256_without_backup: None,
        bytes: 48_211,
        kind,
        dialect: dialect.into(),
        rows_read: 590,
        refused,
        standstills: Vec::new(),
    };
    let refused = Refused {
        line: 17,
        text: "K_12_3;412,331;n/a;20,001".to_owned(),
        reason: "`n/a` is not a number (column y)".into(),
    };
    ImportDocument {
        schema: "etalon/import/1".to_owned(),
        campaign: "PreXYT, CMM, spring check".to_owned(),
        sources: vec![
            source("exports/poses.txt", SourceKind::Export, "delimited by `;`, decimal comma, mm", vec![refused]),
            source("encoders.csv", SourceKind::Log, "delimited by `,`, decimal point", vec![]),
        ],
        messages: vec![
            Message::warning("pose 12, cycle 3: target K has no measurement")
                .at(Place::line("exports/poses.txt", 17, "K_12_3;412,331;n/a;20,001"))
                .hint("measure the pose again, or leave it out"),
        ],
        unmatched: vec![],
    }
}

fn features() -> FeaturesDocument {
    let feature = |name: &str, element: &str, radius_mm: Option<f64>| Feature {
        name: name.to_owned(),
        element: element.to_owned(),
        labels: vec!["rail2_a".to_owned()],
        points: 24,
        point_mm: [412.301_24, 310.885_12, -12.000_4],
        direction: [0.000_012, -0.000_304, 1.0],
        radius_mm,
        rms_mm: 0.0031,
        max_mm: 0.0077,
        standard_uncertainty_mm: Some(0.0006),
    };
    let features = vec![feature("rails", "plane", None), feature("R_home", "circle", Some(19.05))];
    FeaturesDocument { schema: "etalon/features/1".to_owned(), features, messages: Vec::new() }
}

fn frames() -> FramesDocument {
    let export_T_world = Pose::from_xyz_rpy([412.3, 310.9, -12.0], [0.0, 0.0, 0.1]);
    FramesDocument {
        schema: "etalon/frames/1".to_owned(),
        world: WorldFrame {
            definition: "plane rails, origin R_home, y axis from R_home to R_end".into(),
            planar: true,
            poses: vec![FramePose { pose: None, cycle: None, export_T_world, covariance: None }],
            common_covariance: None,
            rms_mm: None,
            max_mm: None,
            reference_mm: vec![],
        },
        not_controlled: vec![],
    }
}

fn parameters() -> ParametersDocument {
    let names = "beta gamma epsilon_theta s d3 d x_c y_c x_o y_o delta delta2 delta3";
    let entry = |(i, name): (usize, &str)| {
        let (unit, nominal) = match i {
            0..=2 => ("deg", [90.0, 90.0, 0.0][i]),
            3..=9 => ("mm", 50.0 * (i - 3) as f64),
            _ => ("1", 1.0),
        };
        let status = match i {
            5 => ParameterStatus::Fixed,
            10 => ParameterStatus::NotIdentifiable,
            _ => ParameterStatus::Identified,
        };
        let value = nominal + if status == ParameterStatus::Identified { 0.123_456_789 - 0.03 * i as f64 } else { 0.0 };
        ParameterEntry {
            name: name.to_owned(),
            unit: unit.to_owned(),
            full_unit: None,
            role: Default::default(),
            meaning: String::new(),
            meaning_id: None,
            tolerance: None,
            nominal,
            before: nominal,
            value,
            standard_uncertainty: (status == ParameterStatus::Identified).then_some(0.000_37 * (1 + i * i) as f64),
            determined: None,
            degrees_of_freedom: None,
            status,
            confounded_with: if i == 10 { vec!["delta2".to_owned(), "d".to_owned()] } else { vec![] },
        }
    };
    let termination = Termination::StepVanished;
    let parameters: Vec<ParameterEntry> = names.split(' ').enumerate().map(entry).collect();
    let contribution = |source, share: f64| BudgetSource {
        source,
        standard_uncertainties: parameters.iter().filter_map(|p| Some(share * p.standard_uncertainty?)).collect(),
        nominal: None,
    };
    let budget = vec![contribution(UncertaintySource::Instrument, 0.8), contribution(UncertaintySource::Frame, 0.6)];
    ParametersDocument {
        schema: ParametersDocument::SCHEMA.to_owned(),
        robot: "prexyt".to_owned(),
        valid_until: None,
        synthetic: None,
        links: None,
        parameters,
        reference_temperature_c: None,
        reference_poses: Vec::new(),
        sketches: vec![],
        covariance: vec![],
        covariance_without: vec![],
        budget,
        residuals: residuals(),
        known: Vec::new(),
        reliability: None,
        robust: Some(robust()),
        observability: Some(observability()),
        untested: Vec::new(),
        solver: SolverSummary {
            method: "Levenberg-Marquardt".into(),
            iterations: 6,
            termination,
            meaning: termination.to_string(),
        },
        messages: vec![
            Message::warning("the residuals are larger than the instrument's uncertainty explains (p = 0.0004)")
                .hint("uncertainties are enlarged by 1.19; look at the residual arrows for a pattern"),
        ],
        provenance: Provenance {
            version: "0.1.0".to_owned(),
            inputs: ["campaign.toml", "robot.toml", "exports/poses.txt"]
                .map(|f| (f.to_owned(), etalon_base::files::sha256(f.as_bytes())))
                .into(),
            seed: Some(7),
        },
    }
}

fn observability() -> ObservabilitySummary {
    ObservabilitySummary {
        o1: 12.31,
        o2: 0.0213,
        o3: 0.801,
        o4: 0.0171,
        o5: 0.114,
        condition: 46.9,
        rank: 11,
        scaling: "columns in mm and degrees, as the parameters are".into(),
        singular_values: singular_values(),
        held_singular_values: vec![SingularValueEntry { value: 3e-13, parameters: vec!["x_c".to_owned()] }],
        rank_cut: 1e-9,
    }
}

fn residuals() -> ResidualSummary {
    ResidualSummary {
        position: etalon_documents::PositionResiduals { position_rms_mm: Some(0.026), ..Default::default() },
        kind: ResidualKind::Targets,
        count: 160,
        rms: 0.0162,
        max: 0.0431,
        degrees_of_freedom: 149,
        effective_degrees_of_freedom: None,
        test: etalon_documents::ResidualTest {
            stated_standard_uncertainty_mm: Some(0.001_35),
            common_standard_uncertainty_mm: None,
            joint_value_standard_uncertainty_deg: None,
            chi_square: Some(212.4),
            chi_square_rejected: true,
            stated_values: 0,
            determined_parameters: None,
            repeats: Some(Replicates {
                repeats_mm: 0.0031,
                degrees_of_freedom: 96,
                lack_of_fit_mm: 0.014,
                p_value: 2e-9,
            }),
        },
        uncertainties_from: etalon_documents::UncertaintyFrom::Instrument,
        uncertainties_enlarged_by: 1.194,
        conditions: Vec::new(),
        between_series: None,
    }
}

/// Eleven values for a condition number of 46.9.
fn singular_values() -> Vec<SingularValueEntry> {
    let value = |i: i32| 2.345 * 46.9f64.powf(-f64::from(i) / 10.0);
    let parameters = |i: i32| if i == 10 { vec!["beta".to_owned(), "x_o".to_owned()] } else { vec![] };
    (0..11).map(|i| SingularValueEntry { value: value(i), parameters: parameters(i) }).collect()
}

fn robust() -> RobustSummary {
    let parameter = |name: &str, difference: f64| RobustParameter {
        name: name.to_owned(),
        unit: "mm".to_owned(),
        value: 116.234_4 + difference,
        difference,
        difference_over_u: difference.abs() / 0.000_085,
    };
    RobustSummary {
        constant: 2.385,
        sigma_mm: 0.001_35,
        parameters: vec![parameter("d", 0.000_41), parameter("s", -0.000_02)],
        critical: 3.2,
        poses: vec![RobustPose { pose: 7.into(), weight: 0.02, residual_over_sigma: 16.7 }],
        critical_residual: 4.1,
        disagreeing: 1,
    }
}

/// Errors of distances that grow with the distance.
pub(crate) fn relative() -> RelativeAccuracy {
    let of = |from_mm: f64, to_mm: f64, pairs: usize, size: f64| {
        let sizes = |rms: f64| Statistics { mean: 0.8 * rms, rms, p95: 2.0 * rms, max: 3.0 * rms };
        let (before, after) = (sizes(10.0 * size), sizes(size));
        let expanded = Some(1e-3);
        let (expanded_rms_mm, expanded_p95_mm, expanded_max_mm) = (expanded, expanded, expanded);
        DistanceStatistics { from_mm, to_mm, pairs, before, after, expanded_rms_mm, expanded_p95_mm, expanded_max_mm }
    };
    let steps = vec![of(0.0, 100.0, 400, 0.012), of(100.0, 200.0, 700, 0.018), of(200.0, 300.0, 175, 0.025)];
    RelativeAccuracy { set: PoseSet::Validation, available: 1275, all: of(0.0, 300.0, 1275, 0.017), steps }
}

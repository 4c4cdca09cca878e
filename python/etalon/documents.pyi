"""Classes of the documents; written by generate_stubs.py from the JSON schemas."""

from collections.abc import Iterator, Mapping
from typing import Any

class Record(Mapping[str, Any]):
    """A JSON object whose members are attributes too; a member that the document leaves out raises AttributeError."""

    def __init__(self, members: dict[str, Any]) -> None: ...
    def __getattr__(self, name: str) -> Any: ...
    def __getitem__(self, name: str) -> Any: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    def to_dict(self) -> dict[str, Any]:
        """Return a copy as dictionaries, lists, numbers and texts."""
    def to_json(self, indent: int | None = None) -> str:
        """Return the document as JSON text, which the program reads."""
    def _repr_html_(self) -> str: ...

class Document(Record):
    """A document with a schema, as ``--json`` of the program prints it."""

def load(text: str) -> Document:
    """Return the document in a JSON text, of the class that its schema names."""

class AccuracySet(Record):
    """Errors over one set of poses."""
    count: int
    """Points or poses whose errors are counted."""
    errors: list[ErrorStatistics]
    """One per quantity: position, x, y, z, orientation."""
    name: str
    """`calibration` or `validation`."""
    poses: int
    """Poses in it."""

class Approach(Record):
    """The runs to one position from one side."""
    estimator_mm: float
    """Estimator of the unidirectional positioning repeatability si, with n − 1."""
    mean_mm: float
    """Mean unidirectional positioning deviation x̄i."""
    repeatability_mm: float
    """Unidirectional positioning repeatability Ri = 4 si."""
    runs: int
    """Runs, n."""

class AxisPosition(Record):
    """One position of the axis, approached from both sides."""
    backward: "Approach"
    """In negative direction (↓)."""
    forward: "Approach"
    """In positive direction (↑)."""
    mean_mm: float
    """Mean bidirectional positioning deviation x̄i = (x̄i↑ + x̄i↓) / 2."""
    position_mm: float
    """Programmed position."""
    repeatability_mm: float
    """Bidirectional positioning repeatability Ri = max(2 si↑ + 2 si↓ + |Bi|, Ri↑, Ri↓)."""
    reversal_mm: float
    """Reversal error Bi = x̄i↑ − x̄i↓."""

class AxisPositioning(Record):
    """Positioning of an axis."""
    accuracy: "Directions"
    """Positioning accuracy A = max (x̄i + 2 si) − min (x̄i − 2 si), of both directions together over ↑ and ↓."""
    mean_reversal_mm: float
    """Mean reversal error B̄, the mean of all Bi."""
    mean_systematic_mm: float
    """Mean bidirectional systematic positioning error M = max x̄i − min x̄i of the bidirectional means."""
    repeatability: "Directions"
    """Positioning repeatability R = max Ri."""
    reversal_mm: float
    """Reversal error B = max |Bi|."""
    systematic: "Directions"
    """Systematic positioning error E = max x̄i − min x̄i, of both directions together over all x̄i↑ and x̄i↓."""

class BallResult(Record):
    """One ball that does not move, measured repeatedly: distances of the readings from their mean (thesis, eq. 2.7
    to 2.10).
    """
    count: int
    """Readings."""
    mean_mm: float
    """Mean distance."""
    name: str
    """Its name."""
    repeatability_mm: float
    """Mean plus three standard deviations."""
    standard_deviation_mm: float
    """Standard deviation of the distance."""

class BatchEntry(Record):
    """One campaign of a batch."""
    campaign: str
    """The folder as the user named it."""
    computed: bool
    """Whether it was run; else nothing of it has changed since its last run."""
    date: str | None
    """When it was measured."""
    ended: Any
    """How it ended."""
    message: str | None
    """Why it failed or was skipped."""
    name: str
    """The campaign's name."""
    output: str | None
    """Its output folder."""
    robot: str | None
    """Name of the robot, or of its model."""

class BudgetSource(Record):
    """What one source contributes to the standard uncertainties."""
    source: Any
    """The source."""
    standard_uncertainties: list[float]
    """Its contribution to the standard uncertainty of each parameter, in the order and units of the covariance:
    their squares add up.
    """

class CandidatePlace(Record):
    """One candidate on the map of figure 4.7."""
    at_mm: list[float]
    """Where the first target of the nominal robot is in its first configuration."""
    chosen: bool
    """Whether it was chosen."""
    configurations: int
    """Number of configurations."""
    pose: int | str
    """Name of the pose."""

class CompareChange(Record):
    """How a quantity changed between two campaigns."""
    change: float
    """Later minus earlier."""
    high: float | None
    """Upper end."""
    low: float | None
    """Lower end of the 95 % interval of the change, or of the ratio where there is one; null where there is none."""
    p: float | None
    """Probability of a change at least as large where nothing changed; null without uncertainties."""
    p_family: float | None
    """The same, corrected for the number of quantities in the family (parameters: Westfall & Young; others: Holm)."""
    ratio: float | None
    """Later over earlier, for quantities whose intervals are those of the ratio (RP, and RT, of which it is that of
    the middles of both intervals); null for others.
    """
    significant: bool | None
    """Whether the corrected probability is below 5 %."""
    to: int
    """Number of the later one."""

class CompareTogether(Record):
    """All robot parameters of two campaigns together."""
    degrees_of_freedom: float | None
    """Degrees of freedom of the covariances; null where they are stated and not estimated."""
    f: float
    """Δᵀ (C₁ + C₂)⁻¹ Δ over the number of parameters: about 1 where nothing changed."""
    p: float
    """Probability of a value at least as large where nothing changed."""
    parameters: int
    """Parameters that both identified."""
    significant: bool
    """Whether that is below 5 %."""
    to: int
    """Number of the later one."""

class CompareTrend(Record):
    """One quantity over the campaigns."""
    changes: list[CompareChange]
    """Every campaign against the first and against the previous one, where both have the quantity."""
    family: Any
    """With which others it is tested."""
    name: str
    """Name of the parameter, or the quantity in words."""
    unit: str
    """`mm`, `deg` or `1`."""
    values: list[CompareValue]
    """One for each campaign."""

class CompareValue(Record):
    """The quantity in one campaign; null where it has none."""
    high: float | None
    """Upper end of the 95 % interval."""
    low: float | None
    """Lower end of the 95 % interval."""
    standard_uncertainty: float | None
    """Its standard uncertainty (k = 1); null where there is only an interval."""
    value: float | None
    """The value."""

class ComparedCampaign(Record):
    """One campaign."""
    conditions: "Conditions"
    """Conditions as stated."""
    coverage_factor: float | None
    """Its coverage factor."""
    date: str | None
    """Date as stated."""
    degrees_of_freedom: float | None
    """Degrees of freedom of these; null where they are stated and not estimated."""
    expanded_uncertainty_um: float | None
    """Expanded uncertainty of one coordinate."""
    folder: str
    """Folder as the user named it."""
    identified: list[str]
    """Parameters of the robot that were identified."""
    instrument: str | None
    """Measuring instrument."""
    name: str
    """Name of the campaign."""
    robot: str | None
    """Name of the robot, where its file states one."""
    synthetic: str | None
    """Whether its data are synthetic."""
    uncertainties_from: Any
    """What standard uncertainties of parameters rest on."""

class ComparedPoses(Record):
    """Other poses and their index."""
    better_by_percent: float
    """By how many per cent the chosen poses are better."""
    poses: list[int | str]
    """The poses."""
    value: float
    """Their index."""

class CompensatedTarget(Record):
    """A target and what to command for it."""
    command_quaternion: list[float]
    """Orientation to command: unit quaternion w, x, y, z."""
    command_xyz_mm: list[float]
    """Position to command, mm."""
    joints: list[float]
    """Joint values of the command in mm and deg, in the order of the columns."""
    quaternion: list[float]
    """Orientation that is wanted: unit quaternion w, x, y, z."""
    residual_deg: float
    """Angle of its orientation from the one that is wanted, deg."""
    residual_mm: float
    """Position of the identified robot there, with the command as it is written, minus the one that is wanted, mm."""
    same_configuration: bool
    """The command is in the configuration (working mode, assembly mode, configuration data) that the target has
    without compensation.
    """
    target: str
    """Name of the target."""
    xyz_mm: list[float]
    """Position that is wanted, mm."""

class Conditions(Record):
    """Conditions of a test (ISO 9283:1998, 6 and 12). A report lists what is absent as "not stated"."""
    controller: str | None
    """Make, type and software version of the controller."""
    deviations: list[str] | None
    """Deviations from the standard; an empty list states that there are none."""
    environment: str | None
    """Room, air, vibrations, electromagnetic fields."""
    humidity_percent: float | None
    """Relative humidity."""
    instrument_calibration: str | None
    """Certificate of the instrument's calibration, and its date."""
    laboratory: str | None
    """Name and address of the laboratory."""
    load_centre_mm: list[float] | None
    """Centre of mass of the load from the mechanical interface."""
    load_kg: float | None
    """Mass of the load at the mechanical interface."""
    measurement_point: str | None
    """The point of robot or tool that was measured."""
    mounting: str | None
    """How and on what the robot is mounted."""
    place: str | None
    """Where the measurements were made, if not in the laboratory."""
    robot: str | None
    """The robot in words."""
    robot_maker: str | None
    """Its manufacturer."""
    robot_received: str | None
    """Date on which it was received for the test."""
    robot_serial_number: str | None
    """Its serial number."""
    robot_state: str | None
    """Its state: repaired, adjusted, as found."""
    robot_type: str | None
    """Its type."""
    traceability: str | None
    """To which standards the instrument's calibration is traceable, and through which laboratory."""
    velocities_mm_s: list[float] | None
    """Path velocities of the test."""
    velocities_percent: list[float] | None
    """Velocities of the test in per cent of the rated velocity."""
    warm_up_minutes: float | None
    """Duration of motion before the test."""

class ContactSummary(Record):
    """How well the robot finds a measured point again."""
    coverage_factor: float
    """The half width in standard deviations."""
    repeatability_um: float
    """Half width of the interval within which one coordinate repeats."""

class ControllerErrors(Record):
    """Position errors at one set of poses."""
    identified: "PositionErrors"
    """With all identified parameters."""
    nominal: "PositionErrors"
    """With nominal parameters of the robot."""
    set: str
    """`calibration` or `validation`."""
    written: "PositionErrors"
    """With the values that are written."""

class ControllerFiles(Record):
    """Values that files of one or more formats hold."""
    errors: list[ControllerErrors]
    """Position errors, one entry for each set of poses: `calibration`, `validation`."""
    formats: list[str]
    """Names of the formats."""
    left_out: list[str]
    """Identified parameters that the formats do not hold; they were at nominal when the others were identified
    again.
    """
    values: list[WrittenParameter]
    """All parameters as the files hold them."""

class CurvePoint(Record):
    """One point of the curve."""
    condition: float
    """Condition number with columns divided by their norms."""
    configurations: int
    """Configurations in them."""
    positions: int
    """Candidates chosen."""
    value: float
    """The index."""

class DesignError(Record):
    """Error of one quantity over the workspace."""
    max: "Spread"
    """Largest."""
    quantity: str
    """`position`, `x`, `y`, `z` or `orientation`."""
    rms: "Spread"
    """Root mean square."""
    unit: str
    """`mm` or `deg`."""

class DesignParameter(Record):
    """A parameter as repeated calibrations identify it."""
    actual: float
    """True value."""
    mean: "Spread"
    """Mean over the runs of a draw."""
    name: str
    """Name."""
    nominal: float
    """Nominal value."""
    three_standard_deviations: "Spread"
    """Three standard deviations over the runs of a draw."""
    unit: str
    """`mm`, `deg` or `1`."""

class DetectionPower(Record):
    """The least motions that the observations would have detected."""
    least: list[LeastDetectable]
    """One each: `shift` and `rotation` of the base in the direction that shows least, and every joint."""
    naming: float
    """The probability with which the right joint is named."""
    probability: float
    """The probability with which they would."""

class Directions(Record):
    """A quantity of both directions together, and of each."""
    backward_mm: float
    """Unidirectional, in negative direction (↓)."""
    both_mm: float
    """Bidirectional."""
    forward_mm: float
    """Unidirectional, in positive direction (↑)."""

class DistributionEntry(Record):
    """The distribution of one result."""
    agrees: bool | None
    """Whether value ± 1.96 times the linear uncertainty has the same ends, to half of its second digit (JCGM 101,
    8.1) and twice the standard deviation of an end by so many draws.
    """
    bootstrap: float | None
    """Standard deviation over the resamples; absent where there are none."""
    interval_95: list[float] | None
    """2.5 % of the draws are below, 2.5 % above; absent for errors."""
    linear: float | None
    """Standard uncertainty by linear propagation of what is stated: what the draws are compared with."""
    mean: float | None
    """Mean of the draws; absent for errors, which are sizes: draws add their scatter to the readings', and sizes
    grow by it.
    """
    name: str
    """Name of the parameter or figure."""
    standard_deviation: float
    """Their standard deviation."""
    standard_uncertainty: float | None
    """Standard uncertainty that the report states, which contains what the model leaves out."""
    unit: str
    """`mm`, `deg` or `1`."""
    value: float
    """The result of the campaign."""

class EffectStep(Record):
    """An effect that was tried beside those accepted before it."""
    accepted: bool
    """Whether it is part of the recommended model."""
    effect: Any
    """The effect; absent of base and targets alone, with which it begins."""
    f: float | None
    """F statistic of what it explains more than the step before."""
    gain_over_u: float | None
    """By how much their mean square became smaller, over its standard uncertainty."""
    held_out_rms_mm: float
    """Root mean square position error at poses that were left out, mm."""
    identified: int
    """Parameters that are identified with it."""
    p_value: float | None
    """Its p value, if residuals were independent."""
    rms_mm: float
    """Root mean square of the residuals of all calibration poses, mm."""

class ErrorStatistics(Record):
    """Statistics of one error before and after."""
    after: "Statistics"
    """With the identified parameters."""
    before: "Statistics"
    """With nominal parameters and only base and targets fitted."""
    expanded_uncertainty: float | None
    """Expanded uncertainty (k = 2) of one error, by what the instrument measures; absent where it is not known."""
    quantity: str
    """`position`, `x`, `y`, `z` or `orientation`."""
    unit: str
    """`mm` or `deg`."""

class Feature(Record):
    """One fitted element, in the coordinates of the exports."""
    direction: list[float]
    """Normal of a plane or circle, axis of a line or cylinder; a unit vector."""
    element: str
    """`plane`, `line`, `circle` or `cylinder`."""
    labels: list[str]
    """Labels of its points."""
    max_mm: float
    """Largest orthogonal distance."""
    name: str
    """Name in the campaign."""
    point_mm: list[float]
    """A point of the element: centroid, or centre of the circle."""
    points: int
    """Number of points."""
    radius_mm: float | None
    """Radius of a circle or cylinder."""
    rms_mm: float
    """Root mean square of the orthogonal distances."""
    standard_uncertainty_mm: float | None
    """Standard uncertainty of the radius, or of the point along the normal of a plane, from the residuals."""

class FigureBudget(Record):
    """The standard uncertainty of a figure, and what it is made of (GUM 5.1.2)."""
    contributions: list[FigureContribution]
    """What each source contributes: squares add up."""
    figure: Any
    """Which."""
    standard_uncertainty_mm: float
    """Its standard uncertainty (k = 1), mm."""

class FigureContribution(Record):
    """What a source contributes to the standard uncertainty of a figure."""
    source: Any
    """The source."""
    standard_uncertainty_mm: float
    """Its contribution, mm."""

class Finding(Record):
    """One error or warning. What does not apply is null."""
    column: int | None
    """At which character of the line, from 1."""
    expected: str | None
    """What was expected there."""
    file: str | None
    """In which file."""
    hint: str | None
    """What to do."""
    line: int | None
    """In which line, from 1."""
    text: str | None
    """The line itself."""
    what: str
    """What is wrong, in one sentence."""

class FitContacts(Record):
    """The points that hold a minimum zone, numbered from 1 in the order they were read."""
    lower: list[int]
    """On the other side, or on the inner one."""
    multipliers: FitMultipliers | None
    """Of a sphere, cylinder or cone: Lagrange multipliers of `upper` and `lower`, in their order. They are positive
    (zero for a contact that is not needed), one in sum on each side, and the mean gradients of the distance by
    the parameters of the element agree (Karush-Kuhn-Tucker).
    """
    proof: Any
    """What was proved: `global` (no other element of the kind has a narrower zone), `local` (no neighbouring one
    has) or `none`.
    """
    upper: list[int]
    """On the side of the normal, to the left of a line, or on the outer circle, sphere, cylinder or cone."""
    verified: bool
    """Whether it was proved that no other place has a narrower zone."""

class FitFlatness(Record):
    """The minimum zone of the plane that a circle in space lies in."""
    contacts: "FitContacts"
    """The points that hold it."""
    flatness_mm: float
    """Its width."""

class FitMultipliers(Record):
    """Lagrange multipliers of contact points."""
    lower: list[float]
    """Of the lower or inner points."""
    upper: list[float]
    """Of the upper or outer points."""

class FitProbe(Record):
    """The probe whose centres were fitted, and the fit before compensation."""
    radius_mm: float
    """Radius of the probe."""
    side: str
    """`inside`, `outside` or `towards`."""
    side_from: str | None
    """What the side was derived from, where the file states it."""
    towards: list[float] | None
    """For a plane or line the direction from it to the probe."""
    uncompensated_minor_radius_mm: float | None
    """Radius of the tube of a torus before compensation."""
    uncompensated_point_mm: list[float]
    """Point or centre before compensation."""
    uncompensated_radius_mm: float | None
    """Radius before compensation."""

class FitSolver(Record):
    """How a fit was found."""
    condition: float | None
    """Condition number of the Jacobian with columns of length one."""
    degrees_of_freedom: int
    """Equations minus parameters."""
    iterations: int
    """Steps taken; 0 where the solution is closed."""
    method: str
    """Algorithm."""
    termination: Any
    """Why it stopped."""

class FitStated(Record):
    """What a file states of a feature, and how far the fit is from it."""
    apex_angle_deg: float | None
    """Stated full angle of a cone."""
    apex_angle_less_stated_deg: float | None
    """Fitted less stated full angle."""
    direction: list[float] | None
    """Stated normal or direction."""
    direction_apart_deg: float | None
    """Angle between stated and fitted direction."""
    id: str
    """Id of the feature in the file."""
    minor_radius_less_stated_mm: float | None
    """Fitted less stated radius of the tube."""
    minor_radius_mm: float | None
    """Stated radius of the tube of a torus."""
    point_apart_mm: float | None
    """Distance of the stated point from the fitted centre, axis, line or plane."""
    point_mm: list[float] | None
    """Stated location or point of the axis."""
    radius_less_stated_mm: float | None
    """Fitted less stated radius."""
    radius_mm: float | None
    """Stated radius."""

class FitUncertainty(Record):
    """Standard uncertainties (k = 1) of the quantities of a fit."""
    apex_angle_deg: float | None
    """Of the full angle of a cone."""
    direction_deg: float | None
    """Of the normal or axis, about its most uncertain direction."""
    minor_radius_mm: float | None
    """Of the radius of the tube."""
    point_mm: float
    """Of the point or centre, in its most uncertain direction."""
    radius_mm: float | None
    """Of the radius."""

class FramePose(Record):
    """Pose of a frame in the coordinates of the exports."""
    covariance: list[list[float]] | None
    """Covariance, from the uncertainty of the points that make the frame, of a small shift along (mm) and then a
    small rotation about (rad) the axes of the world; of a planar world the shift is that at the height of the
    targets. Absent where the exports state the frame.
    """
    cycle: int | None
    """Cycle number; absent where the frame holds for all."""
    export_T_world: "Pose"
    """`export_T_world`."""
    pose: int | str | None
    """Name of the pose; absent where the frame holds for all."""

class GeometricQuantity(Record):
    """One quantity, found from points that were measured for it."""
    identified: float | None
    """Value that the identification of the same campaign found, where there is one."""
    identified_standard_uncertainty: float | None
    """Its standard uncertainty; absent where it was held."""
    name: str
    """Name of the parameter."""
    nominal: float
    """Nominal value."""
    repeats: RepeatStatistics | None
    """How repeats scatter, where there are any."""
    standard_uncertainty: float
    """Standard uncertainty (k = 1) of `value`, frames included."""
    unit: str
    """`mm` or `1`."""
    value: float
    """Value found; the mean of repeats."""

class GeometricStep(Record):
    """Residuals of one fit."""
    count: int
    """Residuals."""
    coverage_deg: float | None
    """Arc that has points, of circles."""
    enlarged_by: float
    """By how much points' uncertainties were enlarged because residuals scatter more than expected; else 1."""
    expected_mm: float
    """What the instrument's stated uncertainty makes of it."""
    max_mm: float
    """Largest residual."""
    name: str
    """What was fitted."""
    norm_mm: float
    """Root of the sum of squares."""
    standard_deviation_mm: float
    """Standard deviation of a residual."""

class GivenSummary(Record):
    """How given parameters were judged."""
    frames: Any
    """Whether base and targets were given too."""
    p_value: float | None
    """Probability of errors as large as these, if parameters, base and targets are what they were given as, within
    their uncertainty and that of the measurement; absent where base and targets were fitted.
    """

class GreedySummary(Record):
    """The thesis' way."""
    curve: list[CurvePoint]
    """Index and condition while candidates are added, beyond the number asked for."""
    knee_configurations: int | None
    """Configurations from which on the index hardly grows: where the curve is farthest above its chord."""
    poses: list[int | str]
    """Poses in the order of choosing."""
    value: float
    """Their index."""

class HeldOutErrors(Record):
    """Errors at poses that were left out of the identification, which chose its parameters without them."""
    all: "Statistics"
    """With all parameters."""
    none: "Statistics"
    """With nominal parameters, base and targets fitted."""
    recommended: "Statistics"
    """With those that are recommended."""

class InfluenceEntry(Record):
    """What the identification would change by without a pose."""
    change_over_u: float
    """Its change, over that."""
    cooks_distance: float | None
    """Cook's distance of all its readings; absent where the other poses do not determine all parameters."""
    parameter: str
    """The parameter that changes most over its standard uncertainty by the residuals."""
    pose: int | str
    """The pose."""

class Iso9283Approach(Record):
    """Visits by one approach."""
    cycles: int
    """Visits."""
    deviation_mm: list[float] | None
    """Barycentre minus commanded position; null where none was commanded."""
    enclosing_radius_mm: float | None
    """Radius of the smallest sphere (planar robots: circle) that holds its positions."""
    mean_mm: list[float]
    """Barycentre."""
    name: str
    """The column `approach`, or the previous pose."""
    rp_mm: float | None
    """RP within this approach; null with a single visit."""

class Iso9283Arrival(Record):
    """One arrival, from the first entry into the limit band on."""
    away_mm: list[float]
    """Distances from the standstill."""
    cycle: int
    """Which visit of that pose it is, from 1."""
    pose: int | str
    """Name of the pose."""
    time_s: list[float]
    """Times since the entry."""

class Iso9283Compliance(Record):
    """Compliance in one direction."""
    compliance_mm_n: float
    """Displacement along the force by force."""
    cycles: int
    """Repeats."""
    direction: str
    """`+x`, `-x` ..."""
    force_n: float
    """Largest force."""
    largest_mm: float
    """Largest displacement along the force."""
    off_line_mm: float
    """Largest distance of a reading from the line."""
    readings: int
    """Readings under load."""
    standard_uncertainty_mm_n: float | None
    """Its standard uncertainty from the scatter about the line; null with a single reading."""

class Iso9283Corner(Record):
    """A corner of the commanded path (8.5)."""
    co_mm: float
    """CO: overshoot."""
    cr_mm: float
    """CR: round-off."""
    position_mm: list[float]
    """The commanded corner: x, y and, where there is one, z."""
    stabilisation_mm: float | None
    """Length along the second leg until it is kept within the limit band; null without a band, and where it is not."""

class Iso9283Distance(Record):
    """Distance between two poses (7.3)."""
    ad_angles_deg: list[float]
    """AD of the angles that exist, in the order a, b, c."""
    ad_axes_mm: list[float]
    """AD_x, AD_y and, where there is one, AD_z."""
    ad_mm: float
    """AD_p: mean attained minus commanded distance."""
    cycles: int
    """Cycles that have both."""
    poses: list[int | str]
    """The two poses."""
    rd_angles_deg: list[float]
    """RD of the angles that exist."""
    rd_axes_mm: list[float]
    """RD_x, RD_y and, where there is one, RD_z."""
    rd_mm: float
    """RD_p: three standard deviations."""

class Iso9283Drift(Record):
    """Drift of one pose (7.6)."""
    ap_mm: list[float]
    """AP of each set."""
    dap_mm: float
    """|AP at the start - AP at the end|."""
    drp_mm: float
    """|RP at the start - RP at the end|."""
    pose: int | str
    """Name of the pose."""
    rp_mm: list[float]
    """RP of each set."""
    settled_after: int | None
    """Number of sets after which AP had settled."""

class Iso9283Ellipsoid(Record):
    """Ellipsoid about the mean position, flat in directions without scatter."""
    axes: list[list[float]]
    """Their unit vectors."""
    semi_axes_mm: list[float]
    """Semi-axes, the longest first."""

class Iso9283Epoch(Record):
    """One measurement of the reference targets."""
    cycle: int
    """Cycle from which on it holds."""
    moved_mm: float
    """Largest movement of a target since the first."""
    rms_mm: float
    """Root mean square distance that is left when the targets are carried back."""

class Iso9283Interval(Record):
    """Two-sided interval of 95 %."""
    high_mm: float
    """Upper end."""
    low_mm: float
    """Lower end."""

class Iso9283Item(Record):
    """One line of the programme."""
    characteristic: str
    """What is tested."""
    clause: str
    """Clause."""
    cycles: int
    """Cycles for each velocity."""
    read: bool
    """Whether the line was read in the standard's text; otherwise it is general knowledge."""
    velocities_percent: list[int]
    """Per cent of the rated velocity."""
    visits: str
    """Poses of a cycle in order, or the path."""

class Iso9283NamedStream(Record):
    """One of them."""
    band_mm: float | None
    """Limit band, where one is stated."""
    file: str
    """File as the campaign names it."""
    name: str
    """Name in the campaign."""
    stream: "Iso9283StreamDocument"
    """The characteristics of the recording."""

class Iso9283OutOfPlane(Record):
    """A pose whose mean lies out of the plane of three others (thesis 2.4)."""
    distance_mm: float
    """Distance from the plane."""
    pose: int | str
    """Name of the pose."""

class Iso9283Path(Record):
    """A commanded path and its passes (8)."""
    at_along_mm: float
    """Where on the path AT_p is attained."""
    at_angles_deg: list[float]
    """AT of the angles that exist, in the order a, b, c."""
    at_interval: Iso9283Interval | None
    """95 % interval of AT_p by parametric bootstrap over the passes; null with fewer than three."""
    at_mm: float
    """AT_p (8.2): largest distance of the mean path from the commanded one."""
    corners: list[Iso9283Corner]
    """Corners of the commanded path."""
    incomplete: int
    """Passes that were begun and not ended."""
    length_mm: float
    """Length of the commanded path."""
    passes: int
    """Passes through all command points."""
    points: list[Iso9283PathPoint]
    """The command points."""
    reorientation: bool
    """Whether commanded angles change along it: AT is then that of 8.4."""
    rt_along_mm: float | None
    """Where on the path RT_p is attained."""
    rt_angles_deg: list[float]
    """RT of the angles that exist; empty with a single pass."""
    rt_interval: Iso9283Interval | None
    """95 % interval of the RT_p of infinitely many passes. RT_p may be above it: the largest of many values that
    scatter is too large.
    """
    rt_mm: float | None
    """RT_p (8.3): largest mean radius + 3 s; null with a single pass."""
    velocity: Iso9283Velocity | None
    """Velocity, where the commanded one is stated."""

class Iso9283PathPoint(Record):
    """One command point."""
    along_mm: float
    """Length of the path up to here."""
    commanded_mm: list[float]
    """Commanded position: x, y and, where there is one, z."""
    deviation_mm: float
    """Distance between the two."""
    mean_mm: list[float]
    """Mean attained position in its normal plane."""
    rt_mm: float | None
    """Mean radius + 3 s of the passes; null with a single one."""

class Iso9283Places(Record):
    """Poses, or a path."""
    joints: list[Record | None]
    """Joint values of each, where a robot is stated; null where it does not get there."""
    name: str
    """Name of the list, and of the files that hold it."""
    points: list[Record]
    """`x_mm`, `y_mm` and, where they exist, `z_mm`, `a_deg`, `b_deg`, `c_deg` of each, numbered from 1."""
    purpose: str
    """What it is for."""

class Iso9283Pose(Record):
    """Accuracy and repeatability of one pose. Coordinates that the robot does not have are absent."""
    ap_a_deg: float | None
    """AP_a."""
    ap_b_deg: float | None
    """AP_b."""
    ap_c_deg: float | None
    """AP_c."""
    ap_conformity: Any
    """AP judged by the stated limit."""
    ap_interval: Iso9283Interval | None
    """95 % interval of AP by parametric bootstrap, and with the instrument's uncertainty where that is stated; null
    with fewer than three visits.
    """
    ap_interval_analytic: Iso9283Interval | None
    """95 % interval of AP in closed form, of the sampling alone."""
    ap_mm: float | None
    """AP_p (7.2.1); null where no position was commanded, as its coordinates."""
    ap_x_mm: float | None
    """AP_x: mean minus commanded."""
    ap_y_mm: float | None
    """AP_y."""
    ap_z_mm: float | None
    """AP_z."""
    cycles: int
    """Visits counted."""
    ellipsoid: Iso9283Ellipsoid | None
    """Where the next position lies with 95 % probability; null with fewer than five visits (planar robots: four)."""
    enclosing_circle_radius_mm: float | None
    """Radius of the smallest circle that holds their projections into xy."""
    enclosing_radius_mm: float | None
    """Radius of the smallest sphere (planar robots: circle) that holds all positions."""
    mean_radius_mm: float | None
    """Mean distance from the barycentre."""
    noise_mm: list[float] | None
    """Standard deviation of one reading, by coordinate."""
    pose: int | str
    """Name of the pose."""
    quarter_rule_met: bool | None
    """Whether both are at most a quarter (clause 6)."""
    rp_a_deg: float | None
    """RP_a: three standard deviations."""
    rp_along_x_mm: float | None
    """The same of x alone."""
    rp_along_y_mm: float | None
    """The same of y alone."""
    rp_along_z_mm: float | None
    """The same of z alone."""
    rp_b_deg: float | None
    """RP_b."""
    rp_c_deg: float | None
    """RP_c."""
    rp_conformity: Any
    """RP likewise."""
    rp_interval: Iso9283Interval | None
    """95 % interval of RP, likewise."""
    rp_interval_analytic: Iso9283Interval | None
    """95 % interval of RP in closed form, of the sampling alone."""
    rp_mm: float | None
    """RP_l (7.2.2): mean radius and three standard deviations; null with a single visit, as all that follows."""
    rp_without_noise_mm: float | None
    """RP without the instrument's noise, where visits were read several times."""
    rp_x_mm: float | None
    """RP_x: three standard deviations."""
    rp_xy_mm: float | None
    """The same of the projections into xy (thesis, table 2.1)."""
    rp_y_mm: float | None
    """RP_y."""
    rp_z_mm: float | None
    """RP_z."""
    sd_radius_mm: float | None
    """Standard deviation of that distance."""
    uncertainty_over_ap: float | None
    """The instrument's expanded uncertainty of a position (k = 2) over AP, where it is stated."""
    uncertainty_over_rp: float | None
    """The instrument's expanded uncertainty over RP."""

class Iso9283Posing(Record):
    """Moves from one pose to another (9)."""
    distance_mm: float
    """Mean attained distance."""
    moves: int
    """How many."""
    posing_s: float
    """Mean posing time."""
    to: int | str
    """Where they end."""

class Iso9283Settling(Record):
    """Arrivals at one pose (7.4, 7.5)."""
    arrivals: int
    """Arrivals that settled."""
    overshoot_mm: float
    """Largest overshoot; zero where no arrival left the limit band again."""
    pose: int | str
    """Name of the pose."""
    stabilisation_s: float
    """Mean stabilisation time."""

class Iso9283Standstill(Record):
    """A standstill."""
    cycle: int | None
    """Which visit of that pose it is, from 1."""
    from_s: float
    """First sample."""
    mean_deg: list[float]
    """Means of the angles that exist, in the order a, b, c."""
    mean_mm: list[float]
    """Mean position of the middle half: x, y and, where there is one, z."""
    noise_mm: float | None
    """Mean radius and three standard deviations of the samples of the middle half: noise of instrument and hold."""
    overshoot_mm: float | None
    """Overshoot of the arrival (7.5); null without a limit band."""
    pose: int | str | None
    """Number of the pose that is visited; null where it is near none."""
    posing_s: float | None
    """Posing time from the previous standstill (9); null without a limit band."""
    samples: int
    """Samples."""
    stabilisation_s: float | None
    """Stabilisation time of the arrival (7.4); null without a limit band, and where the band is never entered or
    kept.
    """
    to_s: float
    """Last sample."""

class Iso9283Unreached(Record):
    """A place that the stated robot does not reach."""
    places: str
    """Name of the list."""
    point: int
    """Number of the point in it, from 1."""
    reason: str
    """Why."""

class Iso9283Variation(Record):
    """One pose approached in several ways (7.2.3)."""
    approaches: list[Iso9283Approach]
    """Every approach by itself."""
    between: list[str]
    """The two that are farthest apart."""
    pose: int | str
    """Name of the pose."""
    vap_angles_deg: list[float]
    """vAP of the angles that exist, in the order a, b, c."""
    vap_mm: float
    """vAP_p: largest distance between barycentres of two approaches."""

class Iso9283Velocity(Record):
    """Velocity over the central part of the path (8.6)."""
    av_percent: float
    """AV."""
    commanded_mm_s: float
    """Commanded."""
    fv_mm_s: float
    """FV: what the instrument's noise makes of it is in it."""
    mean_mm_s: float
    """Mean over all passes."""
    rv_percent: float | None
    """RV; null with a single pass."""

class Iso9283Visit(Record):
    """One visit of one pose."""
    approach: str | None
    """How the pose was approached; null for the first visit of all."""
    attained_mm: list[float]
    """Attained position."""
    cycle: int
    """Number of the cycle."""
    pose: int | str
    """Name of the pose."""

class Iso9283Weaving(Record):
    """A weave (11), mean of all passes."""
    commanded_frequency_hz: float
    """Commanded frequency: swings there and back by second."""
    commanded_stroke_mm: float
    """Commanded stroke, from side to side."""
    frequency_hz: float
    """Attained frequency."""
    passes: int
    """Passes of the centre line."""
    stroke_mm: float
    """Attained stroke."""
    turns: int
    """Turns that were counted in all of them."""
    wf_percent: float
    """WF, of the frequency."""
    ws_percent: float
    """WS: attained minus commanded stroke, in per cent of the commanded one."""

class Issue(Record):
    """What identifies a report (ISO/IEC 17025:2017, 7.8.2.1). A report lists what is absent as "not stated"."""
    amends: str | None
    """Number and date of the report that this one amends or replaces, and the reason."""
    authorised_by: str | None
    """Who authorises the report: name and function."""
    country: Any
    """Country in which the calibration was made, by ISO 3166-1."""
    customer: str | None
    """Name and contact of the customer."""
    external_results: str | None
    """Results that an external provider obtained, and which."""
    issued: str | None
    """Date of issue."""
    number: str | None
    """Number of the report, unique in the laboratory."""

class KinematicsEntry(Record):
    """A pose of the tool in the base frame with joint values."""
    joints: list[float]
    """Joint values in mm and deg, in the order of the columns."""
    pose: int | str
    """Name of the pose."""
    quaternion: list[float]
    """Orientation: unit quaternion w, x, y, z."""
    xyz_mm: list[float]
    """Position, mm."""

class LeadResult(Record):
    """The lead of an actuator."""
    actual_lead_mm: float
    """Actual lead."""
    actuator: int
    """Number of the actuator."""
    error: float
    """Actual over nominal displacement, less one."""
    linearity: list[Linearity]
    """Mean deviation from linear travel, by position."""
    nominal_lead_mm: float
    """Nominal lead of its screw."""
    standard_uncertainty: float
    """Standard uncertainty of `error`."""

class LeastDetectable(Record):
    """The least motion of one kind that would have been detected."""
    name: str
    """`base shift`, `base rotation`, or the name of a joint."""
    named: float | None
    """The least motion of a joint that is detected and attributed to this joint with the probability `naming`;
    absent where another joint moves all targets alike.
    """
    unit: str
    """`mm` or `deg`."""
    value: float | None
    """The motion; absent where the observations do not show it."""

class LimitVerdict(Record):
    """One limit of the campaign."""
    conformity: Any
    """What the rule says."""
    decision_rule: Any
    """The rule by which it is judged."""
    expanded_uncertainty: float | None
    """Expanded uncertainty of the value (k = 2); null where it is not known."""
    limit: float
    """What the campaign allows."""
    met: bool
    """Whether the limit is met by the rule."""
    name: str
    """Name of the limit in the campaign."""
    unit: str
    """Unit of the numbers."""
    value: float
    """What was reached, on the validation poses if there are any."""

class Linearity(Record):
    """Deviation from linear travel at one position."""
    commanded_mm: float
    """Commanded displacement."""
    deviation_mm: float
    """Mean deviation of all passes."""

class MapNode(Record):
    """The error to expect at one place."""
    at_mm: list[float]
    """The place in the base frame."""
    before_mm: float
    """Size of the error before: predicted with the parameters before minus predicted with the identified ones, mm."""
    joints: list[float]
    """Values of the joints there in mm or deg, as [`AccuracyDocument::joints`] names them: in the orientation of the
    nearest calibration pose.
    """
    p95_mm: float
    """95 % of the errors are at most this, mm."""
    parameters_mm: float
    """Standard uncertainty (k = 1) of the predicted position by the identified parameters, mm."""
    standard_uncertainty_mm: float
    """The same with all else that contributes: the expected size of the error (root mean square), mm."""

class MeanError(Record):
    """Mean error of a pose: measured minus predicted."""
    orientation_deg: float
    """Orientation."""
    position_mm: float
    """Length of both."""
    x_mm: float
    """x."""
    y_mm: float
    """y."""

class Message(Record):
    """One thing to say to the user."""
    expected: str | None
    """What was expected there."""
    hint: str | None
    """What to do."""
    place: Place | None
    """Where."""
    rank: Any
    """How much a reader has to care."""
    severity: Any
    """Error or warning."""
    what: str
    """What is wrong, in one sentence without a full stop."""

class MethodErrors(Record):
    """Largest and root mean square of the mean errors."""
    name: str
    """`nominal`, `geometric` or `identified`."""
    orientation_max_deg: float
    """Largest orientation error."""
    position_max_mm: float
    """Largest position error."""
    position_rms_mm: float
    """Root mean square position error."""

class Movement(Record):
    """A motion, and what it leaves."""
    by: list[MovementValue]
    """By how much: of the base a shift at its origin and a rotation vector in the world, of a joint its value, of a
    target a shift on the moving part.
    """
    kind: Any
    """What it is."""
    name: str
    """`base`, or the name of the joint or of the target."""
    p_left: float
    """Probability of residuals as large as those that it leaves."""

class MovementValue(Record):
    """One number of a motion."""
    name: str
    """`x`, `y`, `z`, `rx`, `ry`, `rz`, or the name of a joint."""
    standard_uncertainty: float | None
    """Standard uncertainty (k = 1); absent where the observations do not show it."""
    unit: str
    """`mm` or `deg`."""
    value: float
    """Its value."""

class ObservabilitySummary(Record):
    """Observability of the parameters from the poses."""
    condition: float
    """Condition number with columns divided by their norms."""
    held_singular_values: list[SingularValueEntry]
    """Of the same Jacobian with all parameters that were to be identified the smallest, as many as are held because
    the data do not determine them, or hardly; empty in a plan.
    """
    o1: float
    """O1 = (σ1…σm)^(1/m) / √n, m parameters and n poses (Sun & Hollerbach 2008)."""
    o2: float
    """O2 = σmin / σmax (eq. 1.20)."""
    o3: float
    """O3 = σmin (eq. 1.22)."""
    o4: float
    """O4 = σmin² / σmax (eq. 1.23)."""
    o5: float
    """O5 = 1 / Σ 1/σ (eq. 1.25)."""
    rank: int
    """Number of separately identifiable parameters."""
    rank_cut: float
    """A column that lies this near to the span of those before it, for a norm of 1, is cut: its parameter is held."""
    scaling: str
    """Which scaling the indices have."""
    singular_values: list[SingularValueEntry]
    """Singular values behind the condition number, descending: of the Jacobian at the solution, its columns divided
    by their norms, as the identification uses it. Their squares add up to the number of parameters.
    """

class ParameterEntry(Record):
    """One parameter."""
    before: float
    """Value with only base and targets fitted: the robot before its calibration."""
    confounded_with: list[str]
    """Parameters that are not separately identifiable from this one; where they are more than 99, the one that is
    held.
    """
    degrees_of_freedom: float | None
    """Effective degrees of freedom of that (GUM G.4.1), where it is estimated from residuals."""
    determined: float | None
    """Share of the value that the data determined: 1 − (u/s)², s the standard uncertainty of the nominal value by
    its tolerance; absent where nominal values were no readings.
    """
    meaning: str
    """What it is and which sign it has, in words."""
    name: str
    """Name as in the thesis."""
    nominal: float
    """Nominal value."""
    role: Any
    """Whether it belongs to the robot, its base, a target or a fixture."""
    standard_uncertainty: float | None
    """Standard uncertainty (k = 1); absent where not identified."""
    status: Any
    """Identified, fixed or not identifiable."""
    tolerance: float | None
    """How far from nominal it may be by the robot's file, where that states it."""
    unit: str
    """`mm`, `deg` or `1`."""
    value: float
    """Identified value, or the value at which it is held."""

class ParameterVerdict(Record):
    """Whether a parameter deserves to be loaded."""
    change: float
    """Identified minus nominal value, with all parameters."""
    change_over_u: float
    """The change over its standard uncertainty."""
    effect: Any
    """What it describes."""
    fold_sd_over_u: float
    """Standard deviation over the folds, over the standard uncertainty that a fold has."""
    name: str
    """Its name."""
    p_value: float
    """Probability of such a change of a parameter that has its nominal value, corrected for their number (Holm
    1979).
    """
    part_change_limit: float | None
    """What chance explains of that, with a probability of 99 % for all parameters together: beyond it the parameter
    is not stable.
    """
    part_change_over_sd: float | None
    """Value by part of the poses minus value by all, over the standard deviation that chance gives it (√(u_part² −
    u_all²)), without sign: the largest of the parts; absent outside the recommended model, and where no part
    determines the parameter.
    """
    unit: str
    """Its unit."""
    verdict: Any
    """Load or hold."""

class Place(Record):
    """Where a message points: a file, perhaps a line, perhaps columns of it."""
    column: int | None
    """Column in characters, from 1."""
    file: str
    """File as the campaign names it."""
    line: int | None
    """Line, from 1."""
    text: str | None
    """The line itself."""

class PlannedParameter(Record):
    """One parameter and its predicted uncertainty."""
    confounded_with: list[str]
    """Parameters that are not, or hardly, separable from this one by the chosen poses."""
    identifiable: bool
    """Whether it is identifiable from the candidates."""
    name: str
    """Name as in the thesis."""
    standard_uncertainty: float | None
    """Predicted standard uncertainty; absent where the uncertainty of the instrument is not stated."""
    unit: str
    """`mm`, `deg` or `1`."""

class PlannedPose(Record):
    """One pose to measure."""
    configurations: list[Record]
    """Joint values of each configuration, by column."""
    pose: int | str
    """Number of the pose in the candidates."""

class Pose(Record):
    """A rigid transform: rotation matrix (rows) and translation in millimetres."""
    rotation: list[list[float]]
    """Rotation matrix, row by row."""
    translation_mm: list[float]
    """Translation in millimetres."""

class PoseRow(Record):
    """Mean errors of one pose."""
    command_deg: float
    """Commanded orientation."""
    command_mm: list[float]
    """Commanded position of C in the base frame: what the nominal model makes of the joints."""
    count: int
    """Repeats."""
    geometric: "MeanError"
    """With the geometric parameters."""
    identified: "MeanError"
    """With the identified parameters."""
    nominal: "MeanError"
    """With nominal parameters in the geometric base frame."""
    pose: int | str
    """Name of the pose."""
    standard_deviation_mm: float
    """Standard deviation of x or y over the repeats, the larger."""

class PoseTable(Record):
    """Mean errors of some poses (thesis, tables 2.2 to 2.4)."""
    rows: list[PoseRow]
    """One row a pose."""
    title: str
    """Title."""

class PositionErrors(Record):
    """Root mean square and maximum of position errors."""
    max_mm: float
    """Maximum, mm."""
    rms_mm: float
    """Root mean square, mm."""

class PredictionMap(Record):
    """The error to expect at the tool point with the identified parameters, on a grid of the workspace that the
    calibration poses span: places between theirs at which no joint leaves its range in the calibration.
    """
    definition: str
    """What the numbers of a node mean, in words."""
    frame: Any
    """The part in whose frame it is stated."""
    nodes: list[MapNode]
    """The nodes by x, y and z."""
    point_mm: list[float]
    """Place of the point in `frame`."""
    spacing_mm: float
    """Distance of neighbouring nodes, mm."""

class Presentation(Record):
    """Presentation of a report, complete, so that the output folder alone is enough to write it again."""
    language: Any
    """Its language."""
    logo: str | None
    """The laboratory's logo as a data URI (SVG or PNG)."""
    templates: Record
    """Text of the laboratory's own templates by the name of the file."""

class Provenance(Record):
    """Where numbers come from."""
    inputs: Record
    """SHA-256 of every input, by name."""
    seed: int | None
    """Seed of random numbers, where any were drawn."""
    version: str
    """Version of etalon."""

class Reading(Record):
    """One reading of a delimited text. The unit of lengths is not part of it."""
    columns: list[str]
    """As `columns` states them."""
    decimal: str
    """As `decimal` states it."""
    delimiter: str
    """As `delimiter` states it in the campaign."""
    header: int
    """Rows before the data."""
    share: float
    """Share of the rows looked at that have as many fields as most, two of them numbers; from 0 to 1."""
    thousands: str | None
    """As `thousands` states it, where numbers have groups of digits."""

class Refused(Record):
    """A row that was refused."""
    line: int
    """Line in the file, from 1."""
    reason: str
    """The rule that refused it."""
    text: str
    """The line itself."""

class Region(Record):
    """A region of the workspace."""
    area_mm2: float
    """Its area."""
    corners_mm: list[list[float]]
    """Its corners in the base frame, counterclockwise; z is zero."""
    name: str
    """Which."""

class ReliabilitySummary(Record):
    """How well the readings control each other (Baarda 1968), and which poses decide (Cook 1977)."""
    beyond: int
    """Readings beyond it."""
    critical_w: float
    """Residual over its standard deviation σ √r beyond which a reading is an outlier."""
    influential: float
    """Cook's distance beyond which a pose is influential: the median of F."""
    largest_detectable_mm: float | None
    """The largest; absent where nothing controls a reading, mm."""
    least_redundancy: float
    """Least redundancy number r of a coordinate: the share of its error that its residual shows, from 0 to 1."""
    median_detectable_mm: float | None
    """Least error of a coordinate that is detected, 4.13 σ / √r: median over the readings, mm."""
    poses: list[InfluenceEntry]
    """The poses without which the parameters would change most."""
    power: float
    """Power β0 with which an error is detected that is called detectable."""
    readings: int
    """Measured positions."""
    sigma_mm: float
    """Standard deviation σ of a coordinate: the stated one where that explains the residuals, or theirs, mm."""
    significance: float
    """Significance level α0 of the test of one residual."""

class RepeatStatistics(Record):
    """Scatter of repeated determinations."""
    count: int
    """Their number."""
    enlarged: bool
    """Whether the repeats scatter more than that (chi-square, once in a thousand), and enlarged the uncertainty."""
    expected: float
    """What the points' own uncertainties make of it; frames that all repeats share cancel."""
    standard_deviation: float
    """Standard deviation of one determination."""

class Replicates(Record):
    """Scatter of repeats against the rest of the residuals (Draper & Smith, Applied Regression Analysis, 2.1)."""
    degrees_of_freedom: int
    """Its degrees of freedom."""
    lack_of_fit_mm: float
    """Standard deviation of a coordinate that the model leaves at a pose, without the scatter of repeats, mm."""
    p_value: float
    """Probability of residuals as large as these if the model were right (F test of lack of fit)."""
    repeats_mm: float
    """Standard deviation of a coordinate among repeats of a pose, mm."""

class ResidualSummary(Record):
    """Residuals of the identification."""
    chi_square: float | None
    """Chi-square against both."""
    chi_square_rejected: bool
    """Whether chi-square rejects that the measurement explains the residuals: a right model is rejected once in a
    thousand times.
    """
    common_standard_uncertainty_mm: float | None
    """Standard uncertainty in mm that observations of the very same coordinates have in common beside that: the
    instrument's, where the contact's is stated apart.
    """
    count: int
    """Number of residuals."""
    degrees_of_freedom: int
    """Residuals minus identified parameters."""
    kind: Any
    """Residuals of targets or of the pose."""
    max: float
    """Largest."""
    repeats: Replicates | None
    """Scatter of repeats against the rest; absent where no pose was repeated."""
    rms: float
    """Root mean square in mm (pose residuals: mm and rad mixed, eq. 3.26)."""
    stated_standard_uncertainty_mm: float | None
    """Standard uncertainty of one coordinate that is stated, in mm: the instrument's, or the contact's where that is
    stated apart.
    """
    uncertainties_enlarged_by: float
    """By how much standard uncertainties are larger than the instrument's alone makes them (median); 1 where chi-
    square does not reject the model, or no uncertainty is stated.
    """
    uncertainties_from: Any
    """What standard uncertainties rest on."""

class ResidualTrend(Record):
    """An F test of errors after identification: of a parabola of one quantity against a constant, all coordinates of
    the poses' means together.
    """
    against: str
    """The quantity: a joint as columns name it, `reach_mm` (distance from the base) or `order` (of the measurement)."""
    explained_mm: float
    """Root mean square of what the parabola explains, mm."""
    f: float
    """F statistic."""
    p_value: float
    """Probability of such a trend of a right model, corrected for the number of tests (Holm 1979)."""

class RobustParameter(Record):
    """A parameter by the plain fit and by the robust one."""
    difference: float
    """Robust minus plain value."""
    difference_over_u: float
    """The difference over its standard uncertainty where no reading is wrong: of normal residuals √(1/0.95 − 1) =
    0.23 of that of the parameter.
    """
    name: str
    """Its name."""
    unit: str
    """`mm`, `deg` or `1`."""
    value: float
    """Value by the robust fit."""

class RobustPose(Record):
    """What the robust fit makes of a pose."""
    pose: int | str
    """The pose."""
    residual_over_sigma: float
    """The residual that has it, over σ."""
    weight: float
    """Least weight of its residuals, 1 / (1 + (r / c σ)²), from 0 to 1."""

class RobustSummary(Record):
    """A fit in which readings far from the others weigh little (M-estimator with the Cauchy loss, from the plain
    optimum), beside the plain one.
    """
    constant: float
    """Constant c of the loss c² ln(1 + (r / c σ)²): with 2.385 the variance of parameters is 5 % more where
    residuals are normal.
    """
    critical: float
    """A difference over its standard uncertainty that none of them exceeds with a probability of 99 %, where no
    reading is wrong.
    """
    critical_residual: float
    """A residual over σ that none of them all exceeds with a probability of 99 %, where no reading is wrong."""
    disagreeing: int
    """Poses with a residual beyond it."""
    parameters: list[RobustParameter]
    """The identified parameters in both fits."""
    poses: list[RobustPose]
    """The poses of the least weight, the least first."""
    sigma_mm: float
    """Standard deviation σ of a coordinate by the median residual, or the stated one where that is more, mm."""

class ScaleBarResult(Record):
    """Distance errors of a scale bar."""
    count: int
    """Distances measured."""
    largest_error_mm: float
    """Largest error of a single distance."""
    length_mm: float
    """Calibrated length."""
    length_uncertainty_mm: float | None
    """Expanded uncertainty (k = 2) of the calibrated length, from the certificate."""
    mean_error_mm: float
    """Mean of measured minus calibrated length."""
    name: str
    """Name of its position."""
    permissible_error_mm: float
    """Largest error of a distance that the instrument may have."""
    standard_deviation_mm: float
    """Standard deviation of the distances."""
    uncertainty_ratio: float | None
    """That over the certificate's uncertainty; at least 4 is asked for."""
    verdict: Any
    """What the bar proves of the instrument."""

class SingularValueEntry(Record):
    """How strongly the residuals answer to one direction of the parameters: small where it is badly observable."""
    parameters: list[str]
    """Parameters with a share of more than 0.3 in its right singular vector, the largest first; empty where the
    direction is spread over many.
    """
    value: float
    """The singular value, without unit."""

class Sketch(Record):
    """A drawing; lengths in mm."""
    planar: bool
    """It lies in the plane z = 0."""
    strokes: list[Stroke]
    """Its lines."""
    title: str
    """What it shows, in words."""

class SolverSummary(Record):
    """How the solver ended."""
    iterations: int
    """Steps taken."""
    meaning: str
    """The same in words."""
    method: str
    """Algorithm."""
    termination: Any
    """Why it stopped."""

class Source(Record):
    """One file that was read."""
    bytes: int
    """Its size."""
    dialect: str
    """How it was read: format, delimiter, decimal mark, unit."""
    file: str
    """File as the campaign names it."""
    kind: str
    """`export`, `log`, `campaign` or `robot`."""
    refused: list[Refused]
    """Rows that were refused."""
    rows_read: int
    """Rows that hold data."""
    sha256: str
    """SHA-256 of its bytes, as `sha256sum` prints it."""
    standstills: list[StandingInterval]
    """Standstills of a log recorded during motion, one row of the joint values each."""

class Spread(Record):
    """Median of the draws, and the interval that holds 95 % of them."""
    high: float
    """2.5 % are above."""
    low: float
    """2.5 % of the draws are below."""
    median: float
    """Median."""

class StandingInterval(Record):
    """A standstill in a log, by the limits of the campaign."""
    from_s: float
    """Time of its first sample by the log's clock."""
    joints: list[StandingJoint]
    """The joints."""
    line: int
    """Line of its first sample, from 1."""
    samples: int
    """How many samples."""
    to_s: float
    """Time of its last sample."""

class StandingJoint(Record):
    """A joint in a standstill, in the unit of its column."""
    column: str
    """Its column in the table of joint values."""
    mean: float
    """Mean of the samples: the joint value used."""
    range: float
    """Largest minus smallest."""
    standard_deviation: float
    """Standard deviation of the samples."""

class Statistics(Record):
    """Statistics of errors by size."""
    max: float
    """Largest."""
    mean: float
    """Mean size."""
    p95: float
    """95 % of the errors are at most this."""
    rms: float
    """Root mean square."""

class Stroke(Record):
    """A line of a drawing, through these points."""
    kind: Any
    """What it represents."""
    name: str
    """Its name: that of a parameter, a joint or a frame; empty without one."""
    points_mm: list[list[float]]
    """Places in mm, two or more."""

class StudiedDesign(Record):
    """A set of poses measured with one noise."""
    after: list[DesignError]
    """Errors with the identified parameters."""
    before: list[DesignError]
    """Errors with nominal parameters."""
    configurations: int
    """Configurations measured."""
    name: str
    """Name of the set."""
    noise_um: float
    """Standard deviation of the Gaussian noise of one coordinate."""
    parameters: list[DesignParameter]
    """Parameters."""

class StudiedParameter(Record):
    """One parameter of a simulated calibration."""
    actual: float
    """True value."""
    identified: float
    """Mean of the values identified."""
    name: str
    """Name as in the thesis."""
    nominal: float
    """Nominal value."""
    unit: str
    """`mm`, `deg` or `1`."""

class StudiedPlace(Record):
    """Errors of position at one place."""
    at_mm: list[float]
    """Where the first target is, nominal."""
    max_before_mm: float
    """Largest among its configurations and targets, nominal."""
    max_mm: float
    """Largest with the identified parameters."""
    pose: int | str
    """Name of the pose."""

class StudyDocument(Record):
    """A simulated calibration: tables 4.1 to 4.3, figures 4.8 and 4.9."""
    configurations: int
    """Configurations at which errors are evaluated."""
    draws: int
    """Such means, of whose errors the median is reported; parameters and places are those of the first."""
    noise_um: float
    """Standard deviation of the Gaussian noise of one coordinate."""
    parameters: list[StudiedParameter]
    """Nominal, true and identified parameters with all positions (table 4.1, figure 4.8)."""
    places: list[StudiedPlace]
    """Largest error of each pose with all positions measured (figure 4.9)."""
    point: str
    """The point whose errors of position these are, in words."""
    runs: int
    """Identifications whose mean is evaluated."""
    steps: list[StudyStep]
    """Errors of position by the number of positions measured; the last is the plan (tables 4.2 and 4.3)."""

class StudyStep(Record):
    """Errors of position after a simulated calibration."""
    configurations: int
    """Configurations in them."""
    max_before_mm: float
    """Largest with nominal parameters."""
    max_mm: float
    """Largest with the identified ones, median of the draws."""
    positions: int
    """Positions measured."""
    rms_before_mm: float
    """Root mean square with nominal parameters."""
    rms_mm: float
    """Root mean square with the identified ones, median of the draws."""

class SumOfSquares(Record):
    """A sum of squares of residuals over their variance."""
    degrees_of_freedom: int
    """Its degrees of freedom."""
    p_value: float
    """Probability of a larger one if nothing has changed."""
    value: float
    """The sum."""

class ToolAccuracy(Record):
    """The error that the controller will make at the tool point: its true place in the base frame minus the one that
    the parameters predict.
    """
    after: "Statistics"
    """Expected with the identified parameters (k = 1), mm."""
    before: "Statistics"
    """Predicted with the parameters before minus predicted with the identified ones, mm."""
    definition: str
    """What "before" and "after" mean here, in words."""
    expanded_max_mm: float
    """The largest of these with k = 2, mm."""
    frame: Any
    """The part in whose frame it is stated."""
    held_mm: float
    """Share of parameters that are held because the data do not determine them, with their tolerances, root mean
    square, mm.
    """
    model_mm: float
    """Share of what the model leaves out: measured errors beyond what the instrument explains, root mean square, mm."""
    parameters_mm: float
    """Share of the parameters' covariance, root mean square, mm."""
    place_mm: float
    """Share of the uncertainty of the point's place on the tool, mm."""
    point_mm: list[float]
    """Place of the point in `frame`."""
    poses: int
    """How many."""
    set: str
    """The poses: `validation`, or `calibration` where there are no others."""

class Unmatched(Record):
    """A row without a partner in the join, or with more than one."""
    file: str
    """Its file, as the campaign names it."""
    key: str
    """Its key in words: pose and cycle, row, or time."""
    line: int
    """Line in the file, from 1."""
    reason: str
    """What it has no partner in, or how many partners it has."""

class UnreachablePose(Record):
    """A pose that no joint values lead to."""
    pose: int | str
    """Name of the pose."""
    reason: str
    """Which limit forbids it, or that it is out of reach."""

class UnreachableTarget(Record):
    """A target that cannot be commanded."""
    reason: str
    """Which limit forbids it, or that it is out of reach."""
    target: str
    """Name of the target."""

class ValidationDistance(Record):
    """Distances from validation poses to the nearest calibration pose, over the calibration poses' spacing: the
    median of their distances to the nearest of each other. Distances are those of joint values, each over its
    range in the calibration (root of the sum of squares).
    """
    largest: float
    """Of all validation poses at most this."""
    median: float
    """Of half of the validation poses at most this: about 1 where both sets are spread alike."""
    outside: int
    """Those with a joint outside of its range in the calibration."""
    poses: int
    """Validation poses, each set of joint values counted once."""

class VerificationStep(Record):
    """A pose that was chosen."""
    least: list[LeastDetectable]
    """What it would detect together with those before it."""
    pose: int | str
    """The pose."""

class WorkspaceUncertainty(Record):
    """Uncertainty of position over the candidates."""
    max_mm: float
    """Largest."""
    rms_mm: float
    """Root mean square."""

class WorldFrame(Record):
    """The world frame in the coordinates of the exports."""
    common_covariance: list[list[float]] | None
    """What the covariances of all poses have in common, where the frame is measured again at each: that of the mean
    places of the targets, which define it.
    """
    definition: str
    """How it is defined, in words."""
    max_mm: float | None
    """Largest such distance."""
    planar: bool
    """Drop z: observations are projected into the xy plane of the world."""
    poses: list[FramePose]
    """One entry for all poses (without `pose` and `cycle`), or one for each pose and cycle."""
    reference_mm: list[list[float]]
    """Best-fit places of the targets in the world, in the order of the definition."""
    rms_mm: float | None
    """Root mean square distance of the targets from their best-fit places; absent for 3-2-1 frames."""

class WrittenController(Record):
    """A controller file that was written."""
    errors: ControllerErrors | None
    """Errors at validation poses, otherwise at calibration poses; null if they were not measured."""
    format: str
    """Name of the format."""
    left_out: list[str]
    """Identified parameters that the format does not hold."""

class WrittenParameter(Record):
    """A parameter as a file holds it."""
    name: str
    """Name."""
    standard_uncertainty: float | None
    """Standard uncertainty (k = 1); absent where the value was not identified, or where the format changes it."""
    unit: str
    """`mm`, `deg` or `1`."""
    value: float
    """Value."""

class AccuracyDocument(Document):
    """Errors before and after, on calibration and validation poses apart."""
    budget: list[FigureBudget]
    """Standard uncertainties of the position errors of the validation poses after calibration; empty without a
    validation or a covariance.
    """
    definition: str
    """What "before" and "error" mean here, in words."""
    given: GivenSummary | None
    """What is given, where the parameters were not identified from these data."""
    joints: list[str]
    """Joints of the robot as columns name them: `q1_deg`."""
    limits: list[LimitVerdict]
    """Limits that the campaign states, and whether they are met."""
    map: PredictionMap | None
    """The same over the workspace; absent also where the model has no inverse kinematics, or few places between the
    poses are reached.
    """
    point: str
    """The point whose errors `sets` holds, in words."""
    schema: str
    """`etalon/accuracy/1`"""
    sets: list[AccuracySet]
    """One per set of poses: `calibration`, `validation`."""
    tool: ToolAccuracy | None
    """The error to expect at the tool point; absent where there is none, or no covariance."""
    trends: list[ResidualTrend]
    """How the mean errors of the calibration poses after identification depend on joints, reach and time; empty with
    fewer than ten poses.
    """
    validation_distance: ValidationDistance | None
    """How far the validation poses lie from those of the calibration: the errors hold among poses like these."""

class AxisDocument(Document):
    """Positioning of a linear axis (ISO 230-2:2014)."""
    axis: "AxisPositioning"
    """The axis."""
    positions: list[AxisPosition]
    """Its positions, ascending."""
    schema: str
    """`etalon/iso230/1`"""

class BatchDocument(Document):
    """How the campaigns of a batch ended."""
    campaigns: list[BatchEntry]
    """One each, in the order in which they were named."""
    done: int
    """Campaigns whose limits are met, or that state none."""
    failed: int
    """Campaigns that did not run."""
    not_met: int
    """Campaigns with a limit that is not met, or a result that cannot be the robot."""
    schema: str
    """`etalon/batch/1`"""
    skipped: int
    """Campaigns whose data are not there, by a variable of the environment."""

class CampaignSummary(Document):
    """What the campaign states about itself, for the head of a report."""
    conditions: "Conditions"
    """Conditions of a test."""
    contact: ContactSummary | None
    """How well the robot finds a measured point again, where stated."""
    coverage_factor: float | None
    """Its coverage factor."""
    date: str | None
    """Date as stated."""
    decision_rule: Any
    """Decision rule for limits as stated."""
    expanded_position_uncertainty_um: float | None
    """Expanded uncertainty of a position, where it is stated."""
    expanded_uncertainty_um: float | None
    """Expanded uncertainty of one coordinate."""
    instrument: str | None
    """Measuring instrument."""
    issue: "Issue"
    """What identifies the report."""
    name: str
    """Name of the campaign."""
    notes: str | None
    """Remarks."""
    operator: str | None
    """Operator as stated."""
    report: "Presentation"
    """Presentation of the report."""
    robot: str | None
    """Name of the robot, where its file states one."""
    synthetic: str | None
    """Whether its data are synthetic, and what that means; absent for measured data."""
    temperature_c: float | None
    """Temperature during the campaign."""

class CheckDocument(Document):
    """What `etalon check` found. Without errors the exit code is 0, with any it is 2."""
    campaign: str
    """The campaign as the user named it."""
    errors: list[Finding]
    """What must be put right before the campaign can run."""
    schema: str
    """`etalon/check/1`"""
    sources: list[Source]
    """Files that were read, and the rows refused by rule; empty where reading found errors."""
    warnings: list[Finding]
    """What a report would warn of."""

class CompareDocument(Document):
    """Several campaigns of one robot side by side, in the order in which they were named."""
    campaigns: list[ComparedCampaign]
    """The campaigns."""
    conventions: list[str]
    """By which rules changes are judged, and their limitations, in words."""
    messages: list[Message]
    """Remarks and warnings."""
    provenance: "Provenance"
    """Version, and the documents that were compared."""
    robot: str | None
    """Model of the robot; null where none of the campaigns identifies."""
    schema: str
    """`etalon/compare/1`"""
    together: list[CompareTogether]
    """Whether the robot's parameters changed at all, all of them together, for each pair of campaigns."""
    trends: list[CompareTrend]
    """Every quantity over the campaigns."""

class CompensationDocument(Document):
    """What to command so that the identified robot comes to its targets although its controller computes with
    nominal geometry.
    """
    joint_targets: int
    """Targets of a program that are joint values: they stay as they are."""
    joints: list[str]
    """Names of the columns of joints: with their units, and the assembly mode where there are several."""
    robot: str
    """Model of the robot."""
    schema: str
    """`etalon/compensation/1`"""
    targets: list[CompensatedTarget]
    """One for each target that can be commanded."""
    unreachable: list[UnreachableTarget]
    """Targets that are out of reach, or that a limit forbids."""

class ControllersDocument(Document):
    """Controller files of formats that leave identified parameters out."""
    files: list[ControllerFiles]
    """One entry for each distinct set of values that is written."""
    messages: list[Message]
    """Files that were not written, and parameters that could not be identified again."""
    schema: str
    """`etalon/controllers/1`"""

class FeaturesDocument(Document):
    """Fitted elements."""
    features: list[Feature]
    """One per feature of the campaign."""
    messages: list[Message]
    """Warnings of the fits."""
    schema: str
    """`etalon/features/1`"""

class FitDocument(Document):
    """One fitted element."""
    apex_angle_deg: float | None
    """Full angle of a cone."""
    apex_mm: list[float] | None
    """Apex of a cone."""
    axis: list[float] | None
    """Unit axis of a line, cylinder or cone (a cone's towards increasing radius)."""
    center_mm: list[float] | None
    """Centre of a circle, sphere or torus."""
    contacts: FitContacts | None
    """The points that hold a minimum zone."""
    coverage_deg: float | None
    """How much of the circumference has points."""
    element: str
    """Name of the element."""
    flatness: FitFlatness | None
    """Of a circle in space by minimum zone: the plane that its roundness is measured in."""
    form_mm: float
    """Peak to valley."""
    label: str | None
    """Label of its points, where there is one fit for each."""
    max_mm: float
    """Largest orthogonal distance."""
    messages: list[Message]
    """Warnings with what to do."""
    minor_radius_mm: float | None
    """Radius of the tube of a torus."""
    normal: list[float] | None
    """Unit normal of a plane, circle or torus."""
    point_mm: list[float] | None
    """Point of a line, plane, cylinder or cone: the foot of the centroid."""
    points: int
    """Number of points."""
    probe: FitProbe | None
    """Where the points are probe centres: the probe, and the fit before compensation."""
    radius_mm: float | None
    """Radius; of a cone at its point, of a torus the one of its centre line."""
    rms_mm: float
    """Root mean square of the orthogonal distances."""
    schema: str
    """`etalon/fit/1`"""
    solver: "FitSolver"
    """How it was found."""
    standard_uncertainty: FitUncertainty | None
    """From the residuals; absent without redundancy."""
    stated: FitStated | None
    """What the file states of the feature."""

class FormatsDocument(Document):
    """How a delimited text could be read: what `etalon formats` proposes."""
    doubts: list[str]
    """Doubts about it."""
    file: str
    """The file as the user named it."""
    format: str | None
    """Name of the format, where the file states it; it needs no reading then."""
    questions: list[str]
    """What the file cannot state, and the campaign must."""
    readings: list[Reading]
    """The reading that is proposed, then others that explain the file as well."""
    reasons: list[str]
    """Why the first is proposed."""
    schema: str
    """`etalon/formats/1`"""
    toml: str
    """The proposal as lines for campaign.toml, with all that as comments."""

class FramesDocument(Document):
    """Frames made from features and targets."""
    schema: str
    """`etalon/frames/1`"""
    world: "WorldFrame"
    """The world frame; `export_T_world` for every pose where it is measured again at each."""

class GeometricDocument(Document):
    """The geometric calibration (thesis, chapter 2)."""
    balls: list[BallResult]
    """Single balls, measured repeatedly."""
    covariance: list[list[float]]
    """Covariance of `value` of all quantities, in their order and units."""
    definition: str
    """What was taken for what, in words."""
    leads: list[LeadResult]
    """Leads of the screws."""
    messages: list[Message]
    """What a reader must know."""
    methods: list[MethodErrors]
    """Largest mean errors over all tables, by method."""
    quantities: list[GeometricQuantity]
    """One per quantity, with the identified value of the same parameter."""
    scale_bars: list[ScaleBarResult]
    """Scale bars."""
    schema: str
    """`etalon/geometric/1`"""
    steps: list[GeometricStep]
    """Residuals of every fit."""
    tables: list[PoseTable]
    """Mean errors by pose."""
    workspace: list[Region]
    """Regions of the workspace, with the geometric parameters."""

class ImportDocument(Document):
    """What was read, what was refused and why."""
    campaign: str
    """Name of the campaign."""
    messages: list[Message]
    """What blunder rules found, and other messages."""
    schema: str
    """`etalon/import/1`"""
    sources: list[Source]
    """Every file that was read."""
    unmatched: list[Unmatched]
    """Rows that the join of points and logs found no partner for, or more than one."""

class Iso9283ComplianceDocument(Document):
    """Static compliance (10)."""
    conventions: list[str]
    """How it is computed, and that the clause is not verified."""
    directions: list[Iso9283Compliance]
    """One per direction, in the order of the table."""
    messages: list[Message]
    """Remarks and warnings."""
    schema: str
    """`etalon/iso9283-compliance/1`"""

class Iso9283Document(Document):
    """Characteristics of ISO 9283:1998 of one test."""
    approaches: list[Iso9283Variation]
    """One per pose that was approached in at least two ways."""
    conventions: list[str]
    """What angles mean, which cycles count, and what is not verified against the standard, in words."""
    coplanarity_mm: float | None
    """Peak to valley of the mean positions about their plane; four poses or more, with z."""
    coplanarity_of_four: list[Iso9283OutOfPlane]
    """Distance of the mean position of each of four poses from the plane of the other three, where a campaign names
    them.
    """
    distances: list[Iso9283Distance]
    """One per pair of poses that were visited in the same cycles."""
    drifts: list[Iso9283Drift]
    """Drift of each pose, where sets are stated."""
    exchangeability_mm: float | None
    """Largest distance between barycentres of two robots at any pose, where there are several robots."""
    homing: Iso9283Pose | None
    """Homings as visits of one pose, number 0, where a campaign has them."""
    limits: list[LimitVerdict]
    """Limits that the campaign states."""
    messages: list[Message]
    """Remarks and warnings."""
    poses: list[Iso9283Pose]
    """One per pose, in the order of the commanded poses."""
    reference: list[Iso9283Epoch]
    """Measurements of the reference targets by which positions were carried back, where there are any."""
    schema: str
    """`etalon/iso9283/1`"""
    visits: list[Iso9283Visit]
    """Every visit of a campaign, those of one pose in the order of recording."""

class Iso9283PlanDocument(Document):
    """A test by ISO 9283:1998 laid into a workspace."""
    conventions: list[str]
    """What was chosen how, and what is not verified against the standard, in words."""
    corners_mm: list[list[float]]
    """Corners C1 to C8, of planar robots C1 to C4."""
    loads_percent: list[int]
    """Loads in per cent of the rated one; the first is mandatory."""
    places: list[Iso9283Places]
    """Places to visit in order, each list with its name: `poses` (P1 to P5), `linear`, `circle-large`, ..."""
    programme: list[Iso9283Item]
    """Which characteristic is tested how."""
    schema: str
    """`etalon/iso9283-plan/1`"""
    side_mm: float
    """Side of the cube, of planar robots the square."""
    test_plane: str
    """Corners of the test plane."""
    unreached: list[Iso9283Unreached]
    """Places that the robot does not reach, where one is stated."""

class Iso9283StreamDocument(Document):
    """Characteristics of ISO 9283:1998 of a recorded motion."""
    arrivals: list[Iso9283Arrival]
    """Stabilisation: the first arrivals at each pose; empty without a limit band."""
    conventions: list[str]
    """Thresholds, where times come from, and what is not verified against the standard, in words."""
    duration_s: float
    """From the first sample to the last."""
    left_out: list[int]
    """Lines of samples that no robot reaches from the one before, and that do not count."""
    messages: list[Message]
    """Remarks and warnings."""
    path: Iso9283Path | None
    """The commanded path, where one is stated and it is not a weave."""
    posing: list[Iso9283Posing]
    """Moves between poses; empty without a limit band."""
    samples: int
    """Samples that count."""
    schema: str
    """`etalon/iso9283-stream/1`"""
    settling: list[Iso9283Settling]
    """Arrivals by pose; empty without a limit band."""
    standstills: list[Iso9283Standstill]
    """Every standstill, in the order of time."""
    weaving: Iso9283Weaving | None
    """The weave, where one is stated."""

class Iso9283StreamsDocument(Document):
    """Recorded motions of a campaign."""
    schema: str
    """`etalon/iso9283-streams/1`"""
    streams: list[Iso9283NamedStream]
    """One per `[[stream]]`."""

class KinematicsDocument(Document):
    """Poses and joint values that belong together."""
    joints: list[str]
    """Names of the columns of joints: with their units, and the assembly mode where there are several."""
    poses: list[KinematicsEntry]
    """One for each row of the table, or for each solution."""
    robot: str
    """Model of the robot."""
    schema: str
    """`etalon/kinematics/1`"""
    unreachable: list[UnreachablePose]
    """Poses that the robot does not reach."""

class ManifestDocument(Document):
    """The files of an output folder, all of one run."""
    files: Record
    """SHA-256 of every file, by its name."""
    schema: str
    """`etalon/manifest/1`"""
    version: str
    """Version of etalon."""

class ParametersDocument(Document):
    """Identified parameters with all that is needed to trust them."""
    budget: list[BudgetSource]
    """What the standard uncertainties of these parameters are made of, source by source (GUM 5.1.2)."""
    covariance: list[list[float]]
    """Covariance of the identified parameters, in their order and units; empty where there is none."""
    covariance_without: list[str]
    """Identified parameters of points (targets, sockets, planes) of which the covariance is left out, because they
    are many: 24 points and more. Each has its standard uncertainty.
    """
    messages: list[Message]
    """Rules and remarks that a reader must know: which parameters were held and why, warnings with remedies."""
    observability: ObservabilitySummary | None
    """Observability; absent where it is not a number."""
    parameters: list[ParameterEntry]
    """All parameters of the model."""
    provenance: "Provenance"
    """Where the numbers come from."""
    reliability: ReliabilitySummary | None
    """How well readings control each other, and which poses decide; absent where readings are weighted by
    covariances of their own, have errors in common, are poses instead of positions, or unknown points are many.
    """
    residuals: "ResidualSummary"
    """How well they fit."""
    robot: str
    """Model of the robot."""
    robust: RobustSummary | None
    """A robust fit beside the plain one; absent where readings have errors in common, are poses instead of
    positions, unknown points are many, or nothing is left over.
    """
    schema: str
    """`etalon/parameters/2`"""
    sketches: list[Sketch]
    """Drawings of the model with its parameters; absent where the model has none."""
    solver: "SolverSummary"
    """How the solver ended."""

class PlanDocument(Document):
    """Which poses to measure, and how good that is."""
    at_most_below_percent: float | None
    """By how many per cent at most the choice is below the best possible."""
    at_most_below_percent_by_relaxation: float | None
    """By how many per cent at most it is below, by the continuous relaxation alone."""
    bound: float | None
    """No choice of as many candidates has a larger index; absent where there is no bound (O4)."""
    candidates: int
    """Number of candidates."""
    chosen: list[PlannedPose]
    """What to measure."""
    compared: ComparedPoses | None
    """Poses to compare with, where any were stated."""
    configurations: int
    """Number of configurations in them."""
    definition: str
    """What the index is, with the scaling of the Jacobian; larger is better."""
    greedy: "GreedySummary"
    """The thesis' way: candidates added one after the other."""
    grouped: bool
    """All configurations of a pose come together; otherwise one by one."""
    index: str
    """`O1` to `O5`, `D`, `A`, `E` or `I`."""
    messages: list[Message]
    """Parameters that are not separately identifiable, and other messages."""
    nodes: int
    """Nodes of branch and bound that were looked at."""
    observability: ObservabilitySummary | None
    """Observability of the chosen poses; absent where it is not a number."""
    parameters: list[PlannedParameter]
    """Parameters, with their predicted uncertainties from the chosen poses."""
    places: list[CandidatePlace]
    """Where the candidates are (figure 4.7)."""
    proven_optimal: bool
    """Whether the choice is proven to be the best possible."""
    provenance: "Provenance"
    """Where the numbers come from."""
    robot: str
    """Model of the robot."""
    schema: str
    """`etalon/plan/1`"""
    study: StudyDocument | None
    """A simulated calibration with the chosen poses, where a truth is given (section 4.6)."""
    value: float
    """The index of the chosen poses."""
    workspace: WorkspaceUncertainty | None
    """Standard uncertainty of position over all candidates that the parameters would leave; absent where the
    uncertainty of the instrument is not stated.
    """

class RecommendationDocument(Document):
    """Which of the parameters that a campaign can identify make the robot better at poses that were not used."""
    folds: int
    """Parts into which they are cut: each is predicted from the others."""
    held_out: "HeldOutErrors"
    """Position errors at poses that were left out, mm."""
    meaning: list[str]
    """The recommendation in words."""
    messages: list[Message]
    """Warnings, with remedies."""
    parameters: list[ParameterVerdict]
    """Every identified parameter of the robot itself."""
    poses: int
    """Calibration poses."""
    recommended: "ParametersDocument"
    """The recommended parameters, identified again with all others at their nominal values."""
    repeats: int
    """How often, with other parts."""
    robot: str
    """Model of the robot."""
    schema: str
    """`etalon/recommendation/1`"""
    steps: list[EffectStep]
    """Effects in the order in which they were tried; those that were accepted are in every later one."""

class StudiesDocument(Document):
    """Sets of poses side by side, under stated noise."""
    designs: list[StudiedDesign]
    """One for each set and noise."""
    draws: int
    """Draws of that, over which intervals are taken."""
    error: str
    """Which error `before` and `after` are, in words."""
    provenance: "Provenance"
    """What the numbers come from."""
    robot: str
    """Model of the robot."""
    runs: int
    """Calibrations whose mean is evaluated."""
    schema: str
    """`etalon/study/1`"""

class UncertaintyDocument(Document):
    """Distributions by Monte Carlo (JCGM 101) and bootstrap beside the linear uncertainties."""
    draws: int
    """Draws of the whole campaign: frames, readings, what they have in common."""
    errors: list[DistributionEntry]
    """Mean, root mean square and largest position error of the validation poses (`mean`, `rms`, `max`)."""
    messages: list[Message]
    """Warnings of the identification."""
    parameters: list[DistributionEntry]
    """The identified parameters."""
    provenance: "Provenance"
    """Where the numbers come from; seed of the draws."""
    resamples: int
    """Resamples of poses and cycles; 0 where these do not determine the parameters."""
    robot: str
    """Model of the robot."""
    schema: str
    """`etalon/uncertainty/1`"""
    two_digits_reached: bool
    """Whether two digits of every standard uncertainty and of the ends of the intervals are reached (JCGM 101,
    7.9.4).
    """
    uncertainties_from: Any
    """What the standard uncertainties of the identification rest on. Draws contain what is stated, not what the
    model leaves out.
    """

class VerificationDocument(Document):
    """Whether parameters that were identified before explain observations of today."""
    expected_rms_mm: float
    """What is expected of it if nothing has changed, mm."""
    explanations: list[Movement]
    """Each thing that may have moved, were it this alone; the best explanation first."""
    meaning: str
    """The same in words."""
    messages: list[Message]
    """Warnings, with remedies."""
    model_mm: float
    """What the calibrated model leaves unexplained of a coordinate beside that (standard deviation), mm."""
    moved: Movement | None
    """What has moved and by how much, where one thing explains the residuals."""
    of_changes: "SumOfSquares"
    """Residuals that a motion of base and joints can make."""
    of_rest: "SumOfSquares"
    """All other residuals."""
    p_value: float
    """Probability of residuals as large as these, if nothing has changed."""
    points: int
    """Measured positions."""
    poses: int
    """Poses of the observations."""
    power: "DetectionPower"
    """What these observations would have detected."""
    provenance: "Provenance"
    """Where the numbers come from."""
    rms_mm: float
    """Root mean square of a coordinate's residual, mm."""
    robot: str
    """Model of the robot."""
    schema: str
    """`etalon/verification/1`"""
    significance: float
    """Below this p value the robot is called changed."""
    standard_uncertainty_mm: float
    """Standard uncertainty of a measured coordinate, mm."""
    verdict: Any
    """What the observations prove."""

class VerificationPlanDocument(Document):
    """Which of some candidates to measure, so that `etalon verify` detects the least changes."""
    messages: list[Message]
    """Warnings, with remedies."""
    model_mm: float
    """What the calibrated model leaves unexplained of a coordinate beside that (standard deviation), mm."""
    naming: float
    """The probability with which the right joint is named."""
    probability: float
    """The probability with which changes are detected."""
    provenance: "Provenance"
    """Where the numbers come from."""
    robot: str
    """Model of the robot."""
    schema: str
    """`etalon/verification-plan/1`"""
    standard_uncertainty_mm: float
    """Standard uncertainty of a measured coordinate, mm."""
    steps: list[VerificationStep]
    """The poses in the order of their choice."""

class WrittenDocument(Document):
    """Files that a command wrote: report, export, simulate and init."""
    controllers: list[WrittenController]
    """Position errors with the controller files that `etalon export` wrote, as far as the run measured them."""
    files: list[str]
    """Files in the order in which they were written."""
    schema: str
    """`etalon/written/1`"""

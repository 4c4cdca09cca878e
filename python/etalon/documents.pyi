"""Classes of the documents; written by generate_stubs.py from the JSON schemas."""

from collections.abc import Iterator
from typing import Any, SupportsIndex, TypeVar, overload

import numpy as np
from numpy.typing import NDArray

_T = TypeVar("_T")

class Record:
    """A JSON object whose members are attributes and items; an optional member that is absent is None, an absent list is empty."""

    _members: dict[str, Any]

    def __init__(self, members: dict[str, Any]) -> None: ...
    def __getitem__(self, name: str) -> Any: ...
    def __contains__(self, name: object) -> bool: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    def get(self, name: str, default: Any = None) -> Any:
        """Return the member with this name of the schema, or the default if it is absent."""
    def to_dict(self) -> dict[str, Any]:
        """Return a copy as dictionaries, lists, numbers and texts."""
    def to_json(self, indent: int | None = None) -> str:
        """Return the document as JSON text, which the program reads."""
    def describe(self) -> Records[Record]:
        """Return the members as a table: name, type, and meaning with its unit, as in the JSON schema."""
    def _repr_html_(self) -> str: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

class Document(Record):
    """A document with a schema, as ``--json`` of the program prints it."""

class Records(list[_T]):
    """A list of records, which is also a table; a part of it is one too."""

    @overload
    def __getitem__(self, at: SupportsIndex, /) -> _T: ...
    @overload
    def __getitem__(self, at: slice[Any, Any, Any], /) -> Records[_T]: ...
    @overload
    def __getitem__(self, at: str, /) -> _T: ...
    def column(self, name: str) -> list[Any]:
        """Return the values of a member of all records; None where it is absent."""
    def to_dict(self) -> dict[str, list[Any]]:
        """Return the table as columns; None where a record has no value."""
    def to_pandas(self, *, flat: bool = False) -> Any:
        """Return the table as a DataFrame of pandas. ``flat`` gives members of members columns of their own: ``interval.low_mm``."""
    def to_polars(self) -> Any:
        """Return the table as a DataFrame of polars."""
    def to_arrow(self) -> Any:
        """Return the table as a table of pyarrow."""
    def _repr_html_(self) -> str: ...

def load(text: str) -> Document:
    """Return the document in a JSON text, of the class that its schema names."""

def _table(rows: list[dict[str, Any]]) -> str: ...

_CLASSES: dict[str, str]

class AccuracySet(Record):
    """Errors over one set of poses."""
    count: int
    """Number of points or poses whose errors are counted."""
    errors: Records[ErrorStatistics]
    """One per quantity that was measured: position, x, y, z, orientation; distance, surface, contact, coordinate."""
    name: str
    """`calibration` or `validation`."""
    poses: int
    """Number of poses."""
    readings: Records[ReadingValues]
    """Values of the readings in addition to joint values, one entry per column; empty if the robot has no effects of
    load, torques or temperature.
    """

class Action(Record):
    """Next step with its reason."""
    action: str
    """Kind of the step."""
    command: str | None
    """Command to run in the folder of the campaign."""
    file: str | None
    """File to load, or to change, relative to the output folder or the folder of the campaign."""
    gain_mm: float | None
    """Expected decrease of the error (mm), which determines the order of actions; absent if unknown."""
    line: str | None
    """Lines to add to `file`."""
    message: Message | None
    """Warning whose hint is the instruction."""
    reason: str
    """Reason, in English."""
    reason_phrase: Phrase | None
    """Text of the catalogue that is `reason` in English; absent if `message` has the text."""
    what: str
    """Instruction, in English."""
    what_phrase: Phrase | None
    """Text of the catalogue that is `what` in English; absent if `message` has the text."""

class Approach(Record):
    """Runs to one position from one direction."""
    estimator_mm: float
    """Estimator of the unidirectional positioning repeatability si, with n − 1."""
    mean_mm: float
    """Mean unidirectional positioning deviation x̄i."""
    repeatability_mm: float
    """Unidirectional positioning repeatability Ri = 4 si."""
    runs: int
    """Number of runs n."""

class AxesCheck(Record):
    """Comparison of a reading with the position of the robot at its joint values."""
    distance_mm: float
    """Distance of the reading from the predicted position."""
    line: int
    """Line of the reading."""
    standard_uncertainty_mm: float
    """Standard uncertainty of a component of the difference."""
    target: str
    """Name of the target."""

class AxesParameter(Record):
    """Parameter of the robot with its uncertainty by the sweeps."""
    name: str
    """Name in the robot's model."""
    standard_uncertainty: float
    """Standard uncertainty (k = 1); 0 for a parameter that a convention fixes."""
    tolerance: float | None
    """Tolerance in `robot.toml`: the half-width of a rectangular distribution whose standard deviation covers the
    correlations, at least 4.3 standard uncertainties. Absent where the default tolerance of the model is smaller.
    """
    unit: str
    """`mm` or `deg`."""
    value: float
    """Value."""

class AxesRobot(Record):
    """Robot from its axes alone."""
    axes: Records[ZeroAxis]
    """Axes at joint values zero in the base."""
    base_quaternion: NDArray[np.float64]
    """Orientation of the base in the frame of the measurements: unit quaternion w, x, y, z."""
    base_rule: str
    """Rule of the base: `common-normal`, `meeting`, `parallel`, `sliding` or `target`."""
    base_xyz_mm: NDArray[np.float64]
    """Position of the base in the frame of the measurements."""
    convention: str
    """Convention of the robot file: `poe`, `dh` or `mdh`."""
    covariance: NDArray[np.float64]
    """Covariance of the parameters that the axes determine, in their order and units."""
    flange_quaternion: NDArray[np.float64]
    """Orientation of the flange at joint values zero in the base: unit quaternion w, x, y, z."""
    flange_xyz_mm: NDArray[np.float64]
    """Position of the flange at joint values zero in the base."""
    parameters: Records[AxesParameter]
    """Parameters that the axes determine, then parameters that a convention fixes: base on the first axes, flange of
    `dh` and `mdh` on the last.
    """
    robot_toml: str
    """Text of robot.toml."""
    targets: Records[AxesTarget]
    """Targets in the frame of the flange."""

class AxesTarget(Record):
    """Target on the flange."""
    standard_uncertainty_mm: NDArray[np.float64]
    """Standard uncertainties of the components."""
    target: str
    """Name of the target."""
    xyz_mm: NDArray[np.float64]
    """Position in the frame of the flange."""

class AxisEntry(Record):
    """Axis of one joint in the frame of the measurements, at the pose of its sweep."""
    axial_by_noise: MotionByNoise | None
    """Axial error motion (mm) that noise alone gives."""
    axial_error_motion_mm: float | None
    """Axial error motion (ISO 230-7), peak to valley; from three targets."""
    coordinate_standard_uncertainty_mm: float
    """Standard uncertainty of a coordinate: as given, or from the residuals."""
    covariance: NDArray[np.float64]
    """Covariance of point (mm) and direction, 6 × 6, in this order."""
    degrees_of_freedom: int | None
    """Degrees of freedom of that uncertainty, effective ones where deviations are smooth; absent if it is given."""
    direction: NDArray[np.float64]
    """Unit direction of positive motion."""
    direction_standard_uncertainty_deg: float
    """Standard uncertainty of the direction: the larger of those about two perpendicular axes."""
    joint: str
    """Name of the joint."""
    motion_rms: float | None
    """Root mean square of motion minus joint value (deg or mm); absent without joint values."""
    paths: Records[AxisPath]
    """Paths of the targets."""
    point_mm: NDArray[np.float64]
    """Point of the axis nearest to the centroid of the readings; for a prismatic joint the centroid."""
    point_standard_uncertainty_mm: float | None
    """Standard uncertainty of the point across the axis: the larger of two perpendicular directions; absent for a
    prismatic joint.
    """
    prismatic: bool
    """`true` if the joint slides."""
    ratio: float | None
    """Motion per unit of the joint value; absent without joint values."""
    ratio_standard_uncertainty: float | None
    """Standard uncertainty of the ratio; absent without joint values."""
    readings: int
    """Number of readings."""
    set_aside: list[int]
    """Lines of readings that are excluded."""
    tilt_by_noise: MotionByNoise | None
    """Tilt error motion (deg) that noise alone gives."""
    tilt_error_motion_deg: float | None
    """Tilt error motion (ISO 230-7), largest angle from the mean axis; from three targets."""

class AxisPath(Record):
    """Path of a target about or along an axis."""
    arc_deg: float | None
    """Arc that the readings cover; absent for a prismatic joint."""
    by_noise: MotionByNoise | None
    """Radial and face error motion (mm) that noise alone gives."""
    face_error_motion_mm: float
    """Face error motion (ISO 230-7) at this radius, peak to valley, including the noise of the measuring system. For
    a prismatic joint: straightness in the other transverse direction.
    """
    height_mm: float | None
    """Height relative to the point of the axis; absent for a prismatic joint."""
    length_mm: float | None
    """Length that the readings cover; absent for a revolute joint."""
    radial_error_motion_mm: float
    """Radial error motion (ISO 230-7) at this target, peak to valley, including the noise of the measuring system.
    For a prismatic joint: straightness in one transverse direction.
    """
    radius_mm: float | None
    """Radius; absent for a sliding joint."""
    radius_standard_uncertainty_mm: float | None
    """Standard uncertainty of the radius."""
    readings: int
    """Number of readings used."""
    target: str
    """Name of the target."""

class AxisPosition(Record):
    """One position of the axis, approached from both directions."""
    backward: Approach
    """Approach in negative direction (↓)."""
    forward: Approach
    """Approach in positive direction (↑)."""
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
    accuracy: Directions
    """Positioning accuracy A = max (x̄i + 2 si) − min (x̄i − 2 si); the bidirectional value is over ↑ and ↓."""
    mean_reversal_mm: float
    """Mean reversal error B̄, the mean of all Bi."""
    mean_systematic_mm: float
    """Mean bidirectional systematic positioning error M = max x̄i − min x̄i of the bidirectional means."""
    repeatability: Directions
    """Positioning repeatability R = max Ri."""
    reversal_mm: float
    """Reversal error B = max |Bi|."""
    systematic: Directions
    """Systematic positioning error E = max x̄i − min x̄i; the bidirectional value is over all x̄i↑ and x̄i↓."""

class BallResult(Record):
    """A stationary ball that is measured repeatedly: distances of the readings from their mean (thesis, eq. 2.7 to
    2.10).
    """
    count: int
    """Number of readings."""
    mean_mm: float
    """Mean distance."""
    name: str
    """Name of the ball."""
    repeatability_mm: float
    """Mean plus three standard deviations."""
    standard_deviation_mm: float
    """Standard deviation of the distance."""

class BatchCheck(Record):
    """A check of a campaign's result."""
    limit: float | None
    """Largest permissible value."""
    name: str
    """`solver` (convergence), `robot` (plausible parameters), `preconditions` (of the verdict), `warnings` (warnings
    that need a decision), or the name of a limit in campaigns.
    """
    unit: str | None
    """Unit of value and limit."""
    value: float | None
    """Value in the unit of the limit, or number of warnings."""
    verdict: str
    """Verdict."""

class BatchEntry(Record):
    """One campaign of a batch."""
    alike: str | None
    """Robots that are alike have the same text: type as given, otherwise model and nominal parameters. Results are
    compared among robots that are alike.
    """
    campaign: str
    """Folder, as the user named it."""
    checks: Records[BatchCheck]
    """Checks of the result: solver, robot, warnings, and each limit."""
    computed: bool
    """`true` if the campaign was run; `false` if nothing has changed since its last run."""
    date: str | None
    """Date of the measurement."""
    ended: str
    """Outcome."""
    message: str | None
    """Reason of a failure or omission."""
    name: str
    """Name of the campaign."""
    output: str | None
    """Output folder of the campaign."""
    robot: str | None
    """Name of the robot, or of its model."""
    synthetic: bool
    """`true` if the data are synthetic."""
    valid_until: str | None
    """Last day on which the calibration is valid, as given: year-month-day."""
    verdict: str | None
    """Verdict on the result; null if it was not judged or the campaign did not run."""

class BudgetSource(Record):
    """Contribution of one source to the standard uncertainties."""
    nominal: NominalUncertainties | None
    """Basis of the contributions, for the source `nominal_values`."""
    source: str
    """Source."""
    standard_uncertainties: NDArray[np.float64]
    """Contributions to the standard uncertainty of each parameter, in the order and units of the covariance; the
    squares add up over all sources.
    """

class CampaignReference(Record):
    """Campaign to which an answer refers."""
    date: str | None
    """Date as given."""
    instrument: str | None
    """Measuring instrument."""
    name: str
    """Name of the campaign."""
    robot: str | None
    """Name of the robot, if its file contains one."""
    synthetic: str | None
    """Explanation of synthetic data; absent for measured data."""

class CandidatePlace(Record):
    """One candidate on the map (thesis, fig. 4.7)."""
    at_mm: NDArray[np.float64]
    """Position of the first target of the nominal robot in the first configuration."""
    chosen: bool
    """`true` if the candidate was chosen."""
    configurations: int
    """Number of configurations."""
    pose: int | str
    """Name of the pose."""

class CellAxisEntry(Record):
    """External axis."""
    direction: NDArray[np.float64]
    """Unit direction of positive motion in the frame of the measured points."""
    direction_covariance: NDArray[np.float64] | None
    """Covariance of the direction, 3 × 3."""
    prismatic: bool
    """`true` if the axis slides."""
    radius_mm: float | None
    """Radius of the first target (mm); absent for a prismatic axis."""
    scale: float
    """Motion per unit of the axis value."""
    scale_standard_uncertainty: float | None
    """Standard uncertainty of the scale."""

class CellFrameEntry(Record):
    """Frame in its reference frame."""
    covariance: NDArray[np.float64] | None
    """Covariance of the position (mm) and of a small rotation (rad) about the axes of the reference frame, 6 × 6, in
    this order.
    """
    name: str
    """Name: `tool`, `sensor`, `object`, `base`, `world`, `target` or `axis`."""
    quaternion: NDArray[np.float64]
    """Orientation: unit quaternion w, x, y, z."""
    reference: str
    """Reference frame: `flange`, `base`, `world` or `points` (the frame of the measured points)."""
    standard_uncertainty_deg: NDArray[np.float64] | None
    """Standard uncertainties of a small rotation about the axes of the reference frame (deg)."""
    standard_uncertainty_mm: NDArray[np.float64] | None
    """Standard uncertainties of the position; absent without redundancy or given uncertainty."""
    xyz_mm: NDArray[np.float64]
    """Position (mm)."""

class CellNoise(Record):
    """Standard deviation of positions or orientations."""
    equations: int
    """Number of equations."""
    measure: str
    """`position` (mm) or `orientation` (deg)."""
    redundancy: float
    """Equations minus the parameters that they determine."""
    standard_deviation: float | None
    """Standard deviation of the residuals (mm or deg); absent without redundancy."""
    uncertainties_from: str
    """Source of the uncertainties: `stated`, or `residuals`."""

class CellPointEntry(Record):
    """Point in its reference frame."""
    covariance_mm2: NDArray[np.float64] | None
    """Covariance (mm²), 3 × 3."""
    name: str
    """Name: `tool` or `fixed`."""
    reference: str
    """Reference frame: `flange` or `base`."""
    standard_uncertainty_mm: NDArray[np.float64] | None
    """Standard uncertainties; absent without redundancy or given uncertainty."""
    xyz_mm: NDArray[np.float64]
    """Position (mm)."""

class CellResidualEntry(Record):
    """Residual of a reading."""
    length: float
    """Length of the residual."""
    line: int
    """Line of the reading."""
    measure: str
    """`position` (mm) or `orientation` (deg)."""
    probability: float | None
    """Probability of a residual at least as large by noise; absent without redundancy."""
    residual: NDArray[np.float64]
    """Measured minus predicted; for orientations a rotation vector."""

class CompareBetween(Record):
    """Between-series component of two campaigns in which the model misfits."""
    birge_ratio: float
    """Birge ratio √(Δᵀ (C₁ + C₂)⁻¹ Δ / m) for m parameters, at least 1, by which intervals of changes of parameters
    are enlarged.
    """
    from_: int
    """Number of the earlier campaign, from 1."""
    parameters: int
    """Number of robot parameters that both campaigns identified."""
    to: int
    """Number of the later campaign."""

class CompareChange(Record):
    """Change of a quantity between two campaigns."""
    change: float
    """Later minus earlier value."""
    from_: int
    """Number of the earlier campaign, from 1."""
    high: float | None
    """Upper end of the interval."""
    low: float | None
    """Lower end of the 95 % interval of the ratio, or of the change if there is no ratio; null if unknown."""
    p: float | None
    """Probability of a change at least this large if nothing changed; null without uncertainties."""
    p_family: float | None
    """Probability `p`, corrected for the number of quantities in the family (parameters: Westfall & Young; others:
    Holm).
    """
    ratio: float | None
    """Later over earlier value, for quantities with an interval for the ratio (RP and RT; for RT the ratio of the
    interval midpoints). Null for other quantities.
    """
    significant: bool | None
    """`true` if the corrected probability is below 5 %."""
    to: int
    """Number of the later campaign."""

class CompareTogether(Record):
    """Joint test of all robot parameters of two campaigns."""
    degrees_of_freedom: float | None
    """Degrees of freedom of the covariances; null if the uncertainties are given rather than estimated."""
    f: float
    """Δᵀ (C₁ + C₂)⁻¹ Δ divided by the number of parameters; about 1 if nothing changed."""
    from_: int
    """Number of the earlier campaign, from 1."""
    p: float
    """Probability of a value at least this large if nothing changed."""
    parameters: int
    """Number of parameters that both campaigns identified."""
    significant: bool
    """`true` if `p` is below 5 %."""
    to: int
    """Number of the later campaign."""

class CompareTrend(Record):
    """One quantity over the campaigns."""
    changes: Records[CompareChange]
    """Changes of every campaign from the first and from the previous campaign, where both have the quantity."""
    family: str
    """Family with which the quantity is tested."""
    name: str
    """Name of the parameter, or the quantity in words."""
    name_phrase: Phrase | None
    """Text of the catalogue that is `name` in English; absent for a parameter."""
    unit: str
    """`mm`, `deg` or `1`."""
    values: Records[CompareValue]
    """One value per campaign."""

class CompareValue(Record):
    """Value of the quantity in one campaign; null if absent."""
    high: float | None
    """Upper end of the 95 % interval."""
    low: float | None
    """Lower end of the 95 % interval."""
    standard_uncertainty: float | None
    """Standard uncertainty (k = 1); null if only an interval is known."""
    value: float | None
    """Value."""

class ComparedCampaign(Record):
    """One campaign."""
    conditions: Conditions
    """Conditions as given."""
    coverage_factor: float | None
    """Coverage factor of `expanded_uncertainty_um`."""
    date: str | None
    """Date as given."""
    degrees_of_freedom: float | None
    """Degrees of freedom of the standard uncertainties; null if the uncertainties are given rather than estimated."""
    expanded_uncertainty_um: float | None
    """Expanded uncertainty of one coordinate."""
    folder: str
    """Folder as the user named it."""
    identified: list[str]
    """Identified parameters of the robot."""
    instrument: str | None
    """Measuring instrument."""
    name: str
    """Name of the campaign."""
    robot: str | None
    """Name of the robot, if its file contains one."""
    synthetic: str | None
    """Explanation of synthetic data; absent for measured data."""
    uncertainties_from: str | None
    """Basis of the standard uncertainties of the parameters."""

class ComparedPoses(Record):
    """Poses for comparison, and their index."""
    better_by_percent: float
    """Improvement of the chosen poses over these poses (%)."""
    poses: list[int | str]
    """Poses."""
    value: float
    """Index of the poses."""

class CompensatedTarget(Record):
    """A target and the command that reaches it."""
    command_quaternion: NDArray[np.float64]
    """Orientation to command: unit quaternion w, x, y, z."""
    command_xyz_mm: NDArray[np.float64]
    """Position to command (mm)."""
    joints: NDArray[np.float64]
    """Joint values of the command (mm or deg), in the order of the columns."""
    quaternion: NDArray[np.float64]
    """Desired orientation: unit quaternion w, x, y, z."""
    residual_deg: float
    """Remaining orientation error (deg)."""
    residual_mm: float
    """Remaining position error (mm): position of the identified robot with the command as written minus the desired
    position.
    """
    same_configuration: bool
    """`true` if the command has the configuration of the uncompensated target: working mode, assembly mode or
    configuration data.
    """
    target: str
    """Name of the target."""
    xyz_mm: NDArray[np.float64]
    """Desired position (mm)."""

class Conditions(Record):
    """Conditions of a test (ISO 9283:1998, 6 and 12). A report shows missing entries as "not stated"."""
    controller: str | None
    """Make, type and software version of the controller."""
    controller_backup: str | None
    """File that the controller has before the calibration is loaded. The report gives its SHA-256: the way back."""
    deviations: list[str] | None
    """Deviations from the standard; an empty list says that there were no deviations."""
    environment: str | None
    """Room, air, vibrations, electromagnetic fields."""
    humidity_percent: float | None
    """Relative humidity."""
    instrument_calibration: str | None
    """Certificate of the instrument's calibration, and its date."""
    laboratory: str | None
    """Name and address of the laboratory."""
    load_centre_mm: NDArray[np.float64] | None
    """Centre of mass of the load, relative to the mechanical interface."""
    load_kg: float | None
    """Mass of the load at the mechanical interface."""
    measurement_point: str | None
    """Measured point of the robot or tool."""
    mounting: str | None
    """Mounting of the robot."""
    place: str | None
    """Place of the measurements, if outside the laboratory."""
    robot: str | None
    """Description of the robot."""
    robot_maker: str | None
    """Manufacturer of the robot."""
    robot_received: str | None
    """Date on which the robot was received for the test."""
    robot_serial_number: str | None
    """Serial number of the robot."""
    robot_state: str | None
    """State of the robot: repaired, adjusted, as found."""
    robot_type: str | None
    """Type of the robot."""
    traceability: str | None
    """Standards to which the instrument's calibration is traceable, and the laboratory that establishes
    traceability.
    """
    velocities_mm_s: NDArray[np.float64] | None
    """Path velocities of the test."""
    velocities_percent: NDArray[np.float64] | None
    """Velocities of the test (% of the rated velocity)."""
    warm_up_minutes: float | None
    """Duration of motion before the test."""

class ContactSummary(Record):
    """Repeatability of the robot in returning to a measured point."""
    coverage_factor: float
    """Half-width in standard deviations."""
    repeatability_um: float
    """Half-width of the interval within which one coordinate repeats."""

class ControllerErrors(Record):
    """Position errors at one set of poses."""
    identified: PositionErrors
    """Errors with all identified parameters."""
    nominal: PositionErrors
    """Errors with nominal parameters of the robot."""
    set: str
    """`calibration` or `validation`."""
    written: PositionErrors
    """Errors with the written values."""

class ControllerFiles(Record):
    """Values in the files of one or more formats."""
    deciding_set: AccuracySet | None
    """Errors of all quantities at the deciding poses, with nominal and with the written values; absent in output
    folders of earlier versions.
    """
    errors: Records[ControllerErrors]
    """Position errors, one entry per set of poses: `calibration`, `validation`."""
    formats: list[str]
    """Names of the formats."""
    left_out: list[str]
    """Identified parameters that the formats cannot contain. They were at nominal when the others were identified
    again.
    """
    limits: Records[LimitVerdict]
    """Limits of errors, judged with the written values."""
    values: Records[WrittenParameter]
    """All parameters with their values in the files."""

class CurvePoint(Record):
    """One point of the curve."""
    condition: float
    """Condition number with columns scaled to unit length."""
    configurations: int
    """Number of configurations of these candidates."""
    positions: int
    """Number of candidates chosen."""
    value: float
    """Index."""

class DesignError(Record):
    """Error of one quantity over the workspace."""
    max: Spread
    """Largest."""
    quantity: str
    """`position`, `x`, `y`, `z` or `orientation`."""
    rms: Spread
    """Root mean square."""
    unit: str
    """`mm` or `deg`."""

class DesignParameter(Record):
    """A parameter in repeated calibrations."""
    actual: float
    """True value."""
    mean: Spread
    """Mean over the runs of a draw."""
    name: str
    """Name of the parameter."""
    nominal: float
    """Nominal value."""
    three_standard_deviations: Spread
    """Three standard deviations over the runs of a draw."""
    unit: str
    """`mm`, `deg` or `1`."""

class DetectionPower(Record):
    """Smallest movements that the observations can detect."""
    least: Records[LeastDetectable]
    """One entry each for `shift` and `rotation` of the base in the least observable direction, and for every joint."""
    naming: float
    """Probability with which the right joint is named."""
    probability: float
    """Probability of detection."""

class Directions(Record):
    """A quantity of both directions together, and of each direction."""
    backward_mm: float
    """Unidirectional value in negative direction (↓)."""
    both_mm: float
    """Bidirectional value."""
    forward_mm: float
    """Unidirectional value in positive direction (↑)."""

class DisplayedPose(Record):
    """Pose of flange, tool link or platform in the base frame of the robot."""
    quaternion: NDArray[np.float64]
    """Orientation as a unit quaternion: w, x, y, z."""
    xyz_mm: NDArray[np.float64]
    """Position (mm)."""

class DistanceStatistics(Record):
    """Errors of the distances within a range."""
    after: Statistics
    """Sizes of the errors with the judged parameters (mm)."""
    before: Statistics
    """Sizes of the errors with nominal parameters (mm)."""
    expanded_max_mm: float | None
    """Expanded uncertainty (mm, k = 2) of `after.max`."""
    expanded_p95_mm: float | None
    """Expanded uncertainty (mm, k = 2) of `after.p95`."""
    expanded_rms_mm: float | None
    """Expanded uncertainty (mm, k = 2) of `after.rms` by instrument, frames and base; the judged parameters do not
    contribute. Absent without a given uncertainty.
    """
    from_mm: float
    """Shortest measured distance of the range (mm)."""
    pairs: int
    """Number of pairs that are counted."""
    to_mm: float
    """End of the range (mm), which is not part of it."""

class DistributionEntry(Record):
    """Distribution of one result."""
    agrees: bool | None
    """`true` if value ± 1.96 linear uncertainties agrees with the interval of the draws. The tolerance is half of
    the second significant digit (JCGM 101, 8.1) plus twice the standard deviation of an interval end. Of an
    error, `true` if the draws do not have the larger standard uncertainty, within this tolerance. Otherwise the
    draws decide (JCGM 101, clause 8).
    """
    bootstrap: float | None
    """Standard deviation over the resamples; absent without resamples."""
    interval_95: NDArray[np.float64] | None
    """2.5th and 97.5th percentiles of the draws; absent for errors."""
    linear: float | None
    """Standard uncertainty by linear propagation of the same contributions as in the draws, for comparison."""
    mean: float | None
    """Mean of the draws. Absent for errors: draws add scatter to the scatter of the readings, which increases sizes."""
    name: str
    """Name of the parameter or statistic."""
    quantity: str | None
    """Quantity of an error; absent for parameters."""
    standard_deviation: float
    """Standard deviation of the draws."""
    standard_uncertainty: float | None
    """Standard uncertainty in the report, including unmodelled errors."""
    unit: str
    """`mm`, `deg` or `1`."""
    value: float
    """Result of the campaign."""

class EffectProof(Record):
    """Benefit of an effect of the robot at calibration poses that are excluded from the identification."""
    campaign_line: str | None
    """Line of `[identify]` that adds the effect to the identified ones; absent if the effect is identified, or if
    robot.toml does not contain it.
    """
    effect: str
    """Effect."""
    gain_over_u: float | None
    """Decrease of the mean square error over its standard uncertainty."""
    is_identified: bool
    """`true` if the effect is identified; `false` if its benefit is proved, but it is not identified."""
    joints: list[str]
    """Joints of the effect's parameters."""
    p_value: float | None
    """Probability of the F statistic of the effect."""
    robot_key: str | None
    """Line of robot.toml that describes the effect; absent if robot.toml contains it."""
    with_mm: float
    """Root-mean-square position error at poses that were excluded, with the effect (mm)."""
    without_mm: float
    """Root-mean-square position error at poses that were excluded, without the effect (mm)."""

class EffectStep(Record):
    """Trial of an effect in addition to the effects accepted before."""
    accepted: bool
    """`true` if the effect is part of the recommended model."""
    effect: str | None
    """Effect; absent in the first step, with base and targets alone."""
    f: float | None
    """F statistic of the improvement over the previous step."""
    gain_over_u: float | None
    """Decrease of the mean square error at poses that were excluded, over its standard uncertainty."""
    held_out_rms_mm: float
    """Root-mean-square position error at poses that were excluded (mm)."""
    identified: int
    """Number of identified parameters in this step."""
    p_value: float | None
    """Probability of the F statistic if residuals were independent."""
    rms_mm: float
    """Root-mean-square position error of the calibration poses, all of which are used for identification (mm);
    comparable with `held_out_rms_mm`.
    """

class ErrorStatistics(Record):
    """Statistics of one error before and after calibration."""
    after: Statistics
    """Errors with the identified parameters."""
    before: Statistics
    """Errors with nominal parameters; only base and targets are fitted."""
    count: int
    """Number of errors."""
    expanded_uncertainty: float | None
    """Expanded uncertainty (k = 2) of the largest error after calibration, by instrument and frames; absent if
    unknown.
    """
    poses: int
    """Number of poses with such an error; 0 in documents of earlier versions."""
    quantity: str
    """`position`, `x`, `y`, `z`, `orientation`, `distance`, `surface`, `contact` or `coordinate`."""
    unit: str
    """`mm` or `deg`."""

class Explanation(Record):
    """Explanation of one message."""
    action: str
    """Next action."""
    example: str
    """Input that causes the message."""
    expected: str | None
    """Expected value or state; null if the text contains it."""
    hint: str | None
    """Hint of the message; null if the message has no hint."""
    id: str
    """Id of the message."""
    meaning: str
    """Meaning of the message."""
    reason: str
    """Consequence of the message."""
    text: str
    """English text; arguments are in braces."""

class Feature(Record):
    """One fitted element, in the coordinates of the exports."""
    direction: NDArray[np.float64]
    """Normal of a plane or circle, axis of a line or cylinder; a unit vector."""
    element: str
    """`plane`, `line`, `circle` or `cylinder`."""
    labels: list[str]
    """Labels of its points."""
    max_mm: float
    """Largest orthogonal distance."""
    name: str
    """Name in the campaign."""
    point_mm: NDArray[np.float64]
    """Point of the element: centroid, or centre of a circle."""
    points: int
    """Number of points."""
    radius_mm: float | None
    """Radius of a circle or cylinder."""
    rms_mm: float
    """Root mean square of the orthogonal distances."""
    standard_uncertainty_mm: float | None
    """Standard uncertainty from the residuals: of the radius, or of the point along the normal of a plane."""

class FieldCentre(Record):
    """Centre of a component."""
    at: NDArray[np.float64]
    """Joint values (mm or deg), in the order of the inputs."""
    weight: float
    """Weight (mm or deg of the joint that is off)."""

class FieldComponent(Record):
    """Error of one joint as a function of one or two joints: the sum over `centres` of weight · φ(d) with φ(d) = (1
    − d)⁴ (4 d + 1) for d < 1, otherwise 0; d² = Σ ((q − at) / (scale · radius))².
    """
    centres: Records[FieldCentre]
    """Centres with their weights."""
    inputs: Records[FieldInputEntry]
    """Joints on which the error depends."""
    joint: str
    """Joint that is off, named as a column: `q2_deg`."""
    prior: float
    """Standard deviation of the error without knowledge (mm or deg)."""
    radius: float
    """Radius beyond which a centre has no effect, in units of `scale`."""

class FieldDependence(Record):
    """Dependence of a joint's error on joints."""
    inputs: Records[FieldRange]
    """Joints on which the error depends, with the measured range (mm or deg)."""
    joint: str
    """Joint that is off."""
    prior: float
    """Standard deviation of the error (mm or deg)."""

class FieldHeldOut(Record):
    """Errors at poses that were held out: parameters and field are from the other poses."""
    coverage: float
    """Share of coordinates within 1.96 predicted standard uncertainties."""
    factor: float
    """Factor of the field's standard uncertainty with which the errors agree with it."""
    gain_over_u: float
    """Decrease of the mean square error over its standard uncertainty."""
    poses: Records[FieldPose]
    """Errors of each pose."""
    with_mm: float
    """Root mean square position error with the field (mm)."""
    without_mm: float
    """Root mean square position error without the field (mm)."""

class FieldInputEntry(Record):
    """Joint on which a component depends."""
    fade: float
    """Width beyond the range in which the field fades out (mm or deg)."""
    joint: str
    """Joint, named as a column: `q2_deg`."""
    range: NDArray[np.float64]
    """Range of the measured poses (mm or deg)."""
    scale: float
    """Length of one unit of distance (mm or deg)."""

class FieldParameter(Record):
    """Parameter that belongs to the field."""
    name: str
    """Name."""
    role: str
    """Owner of the parameter. Programs without the measured targets omit the parameters of targets."""
    shift: float
    """Change from `parameters.json`."""
    unit: str
    """`mm`, `deg` or `1`."""
    value: float
    """Value with the field."""

class FieldPose(Record):
    """Errors of a held-out pose."""
    pose: int | str
    """Pose."""
    with_mm: float
    """Root mean square position error with the field (mm)."""
    without_mm: float
    """Root mean square position error without the field (mm)."""

class FieldRange(Record):
    """Measured range of a joint."""
    joint: str
    """Joint."""
    range: NDArray[np.float64]
    """Lower and upper end (mm or deg)."""

class FieldSummary(Record):
    """Search for a residual field, and its result at held-out poses."""
    accepted: bool
    """`true` if held-out poses prove the field: it is in `field.json`."""
    components: Records[FieldDependence]
    """Dependences of an accepted field."""
    held_out: FieldHeldOut | None
    """Errors at held-out poses; absent if no field was tried there."""
    reason: str | None
    """Reason for the refusal; absent if accepted."""
    reason_phrase: Phrase | None
    """Text of the catalogue that is `reason` in English."""

class FigureBudget(Record):
    """Standard uncertainty of a figure, and its contributions (GUM 5.1.2)."""
    contributions: Records[FigureContribution]
    """Contribution of each source; the squares add up."""
    figure: str
    """Figure."""
    quantity: str
    """Quantity of the errors."""
    standard_uncertainty_mm: float
    """Standard uncertainty of the figure (mm, k = 1)."""

class FigureContribution(Record):
    """Contribution of one source to the standard uncertainty of a figure."""
    source: str
    """Source."""
    standard_uncertainty_mm: float
    """Contribution (mm)."""

class FileInput(Record):
    """Input of a controller file in addition to joint values: effects in the file depend on it."""
    column: str
    """Column of the readings, which names the unit: `load_kg`."""
    neutral: float
    """Value without effect, at which the announced poses are computed: no payload, no torque, the reference
    temperature.
    """
    quantity: str
    """Quantity of the column."""

class Finding(Record):
    """One error or warning. Members that do not apply are null."""
    arguments: Record
    """Arguments of the text in the catalogue."""
    column: int | None
    """Column of the problem in the line (characters, from 1)."""
    expected: str | None
    """Expected content at this place."""
    file: str | None
    """File of the problem."""
    hint: str | None
    """Next action."""
    id: str
    """Id in the catalogue of messages; `etalon explain ID` explains it."""
    line: int | None
    """Line of the problem, from 1."""
    text: str | None
    """Text of the line."""
    what: str
    """Problem, in one English sentence."""

class FitContacts(Record):
    """Contact points of a minimum zone, numbered from 1 in the order of reading."""
    lower: list[int]
    """Contacts on the opposite side, or on the inner element."""
    multipliers: FitMultipliers | None
    """For a sphere, cylinder or cone: Lagrange multipliers of `upper` and `lower`, in the same order. They are non-
    negative (zero for a redundant contact) and sum to one on each side; the weighted gradients of the distance
    with respect to the element's parameters are equal on both sides (Karush-Kuhn-Tucker).
    """
    proof: str
    """Extent of the proof: `global` (narrowest of all elements of the kind), `local` (narrowest among neighbouring
    elements) or `none`.
    """
    upper: list[int]
    """Contacts on the side of the normal, to the left of a line, or on the outer circle, sphere, cylinder or cone."""
    verified: bool
    """`true` if the zone is proved to be the narrowest of all."""

class FitFlatness(Record):
    """Minimum zone of the plane of a circle in space."""
    contacts: FitContacts
    """Contact points of the zone."""
    flatness_mm: float
    """Width of the zone."""

class FitMultipliers(Record):
    """Lagrange multipliers of contact points."""
    lower: NDArray[np.float64]
    """Multipliers of the lower or inner points."""
    upper: NDArray[np.float64]
    """Multipliers of the upper or outer points."""

class FitProbe(Record):
    """Probe whose centres were fitted, and the fit before compensation."""
    radius_mm: float
    """Radius of the probe."""
    side: str
    """`inside`, `outside` or `towards`."""
    side_from: str | None
    """Statement of the file from which the side was derived."""
    side_from_phrase: Phrase | None
    """Text of the catalogue that is `side_from` in English."""
    towards: NDArray[np.float64] | None
    """For a plane or line: direction from the element to the probe."""
    uncompensated_minor_radius_mm: float | None
    """Radius of the tube of a torus before compensation."""
    uncompensated_point_mm: NDArray[np.float64]
    """Point or centre before compensation."""
    uncompensated_radius_mm: float | None
    """Radius before compensation."""

class FitSolver(Record):
    """Solver of a fit."""
    condition: float | None
    """Condition number of the Jacobian with columns scaled to unit length."""
    degrees_of_freedom: int
    """Equations minus parameters."""
    iterations: int
    """Number of steps; 0 for closed-form solutions."""
    method: str
    """Algorithm."""
    method_phrase: Phrase | None
    """Text of the catalogue that is `method` in English."""
    termination: str
    """Reason of the termination."""

class FitStated(Record):
    """Values that a file contains for a feature, and their differences from the fit."""
    apex_angle_deg: float | None
    """Given full angle of a cone."""
    apex_angle_less_stated_deg: float | None
    """Fitted minus given full angle."""
    direction: NDArray[np.float64] | None
    """Given normal or direction."""
    direction_apart_deg: float | None
    """Angle between the given and the fitted direction."""
    id: str
    """Id of the feature in the file."""
    minor_radius_less_stated_mm: float | None
    """Fitted minus given radius of the tube."""
    minor_radius_mm: float | None
    """Given radius of the tube of a torus."""
    point_apart_mm: float | None
    """Distance between the given point and the fitted centre, axis, line or plane."""
    point_mm: NDArray[np.float64] | None
    """Given location or point of the axis."""
    radius_less_stated_mm: float | None
    """Fitted minus given radius."""
    radius_mm: float | None
    """Given radius."""

class FitUncertainty(Record):
    """Standard uncertainties (k = 1) of the quantities of a fit."""
    apex_angle_deg: float | None
    """Standard uncertainty of the full angle of a cone."""
    coverage_factor: float | None
    """Coverage factor of the expanded uncertainties (95 %): Student's t with the degrees of freedom (GUM G.3), 2 for
    a stated uncertainty of the points.
    """
    direction_deg: float | None
    """Standard uncertainty of the normal or axis about its most uncertain direction."""
    minor_radius_mm: float | None
    """Standard uncertainty of the radius of the tube."""
    point_mm: float
    """Standard uncertainty of the point or centre in its most uncertain direction."""
    radius_mm: float | None
    """Standard uncertainty of the radius."""

class FormatsColumn(Record):
    """A column and its proposed contents."""
    heading: str | None
    """Heading in the file."""
    number: int
    """Number of the column, from 1."""
    taken_for: str
    """Proposed contents of the column."""
    taken_for_phrase: Phrase | None
    """Text of the catalogue that is `taken_for` in English."""
    unit: str | None
    """Unit in the heading."""
    why: str
    """Evidence for the contents."""
    why_phrase: Phrase | None
    """Text of the catalogue that is `why` in English."""

class FormatsJoin(Record):
    """Proposed join of an export with a log."""
    by: str
    """Key of the join: `pose`, `pose, cycle`, `label`, `row` or `time`."""
    keys: int
    """Number of rows of the export."""
    log: str
    """File of the log."""
    matching: int
    """Number of these rows with a row of the log."""

class FramePose(Record):
    """Pose of a frame in the coordinates of the exports."""
    covariance: NDArray[np.float64] | None
    """Covariance from the uncertainty of the points that define the frame: of a small shift along the axes of the
    world (mm), followed by a small rotation about them (rad). In a planar world the shift is that at the height
    of the targets. Absent if the exports contain the frame.
    """
    cycle: int | None
    """Cycle number; absent if the frame applies to all cycles."""
    export_T_world: Pose
    """Pose of the world in the coordinates of the exports."""
    pose: int | str | None
    """Name of the pose; absent if the frame applies to all poses."""

class GeneratedCandidates(Record):
    """Candidates drawn within limits, and numbers of rejected draws by reason."""
    beyond_limits: int
    """Draws beyond limits of joints or links, or without a pose."""
    box_mm: Record
    """Box of the targets in the base of the robot: smallest and largest `x`, `y`, `z` as given."""
    draws: int
    """Number of draws."""
    facing_away: int
    """Draws with a reflector that faces away from the instrument."""
    instrument_mm: NDArray[np.float64] | None
    """Position of the instrument in the base of the robot."""
    obstacles: Records[PlannedObstacle]
    """Bodies in the way of the instrument, with the draws that each hides first."""
    outside_box: int
    """Draws with a target outside the box."""
    ranges: Record
    """Smallest and largest value of each joint, by column."""
    reflectors: Records[PlannedReflector]
    """Reflectors on the flange."""
    wanted: int
    """Number of wanted poses."""

class GeometricQuantity(Record):
    """One quantity, determined from points that were measured for it."""
    identified: float | None
    """Value from the identification of the same campaign, if available."""
    identified_standard_uncertainty: float | None
    """Standard uncertainty of the identified value; absent if the parameter was held."""
    name: str
    """Name of the parameter."""
    nominal: float
    """Nominal value."""
    repeats: RepeatStatistics | None
    """Scatter of repeats, if there are any."""
    standard_uncertainty: float
    """Standard uncertainty of `value` (k = 1), including frames and `uncertainty_by_angles`."""
    uncertainty_by_angles: float | None
    """Part of the standard uncertainty by `beta`, `gamma` and `epsilon_theta`, which are taken as zero: their
    identified values, or stated tolerances. Absent if these are unknown (the part is then missing), and for
    quantities that do not depend on them.
    """
    unit: str
    """`mm` or `1`."""
    value: float
    """Measured value; the mean of repeats."""

class GeometricStep(Record):
    """Residuals of one fit."""
    count: int
    """Number of residuals."""
    coverage_deg: float | None
    """For a circle: arc that is covered by points."""
    enlarged_by: float
    """Factor by which the points' uncertainties were increased because residuals scatter more than expected;
    otherwise 1.
    """
    expected_mm: float
    """Standard deviation expected from the instrument's given uncertainty."""
    max_mm: float
    """Largest residual."""
    name: str
    """Fitted feature."""
    name_phrase: Phrase | None
    """Text of the catalogue that is `name` in English."""
    norm_mm: float
    """Root of the sum of squared residuals."""
    standard_deviation_mm: float
    """Standard deviation of a residual."""

class GivenSummary(Record):
    """Judgement of given parameters."""
    frames: str
    """Origin of base and targets."""
    p_value: float | None
    """Probability of errors at least this large if the given parameters, base and targets are right within their
    uncertainty and the uncertainty of the measurement. Absent if base and targets were fitted.
    """
    refused: bool
    """`true` if the parameters must not be used on this robot: errors with them are larger than with nominal
    parameters by more than noise, or they were identified with other nominal values.
    """

class GreedySummary(Record):
    """Greedy choice of the thesis."""
    curve: Records[CurvePoint]
    """Index and condition number while candidates are added, beyond the required number."""
    knee_configurations: int | None
    """Number of configurations at the knee of the curve, where it is farthest above its chord."""
    poses: list[int | str]
    """Poses in the order of the choice."""
    value: float
    """Index of the poses."""

class HeldOutErrors(Record):
    """Errors at poses that were excluded from the identification of parameters."""
    all: Statistics
    """Errors with all parameters that the run identifies."""
    none: Statistics
    """Errors with nominal parameters; base and targets are fitted."""
    recommended: Statistics
    """Errors with the recommended parameters."""

class InfluenceEntry(Record):
    """Change of the identification if a pose is omitted."""
    change_over_u: float
    """Change of the parameter over its standard uncertainty."""
    cooks_distance: float | None
    """Cook's distance of all readings of the pose; absent if the other poses do not determine all parameters."""
    parameter: str
    """Parameter with the largest change relative to its standard uncertainty from the residuals."""
    pose: int | str
    """Pose."""

class InputsCheck(Record):
    """Pose with the values of a file and all inputs of a reading: software that ignores the inputs gives another
    pose.
    """
    after: DisplayedPose
    """Pose with the values of the file."""
    effect_mm: float
    """Distance (mm) from the pose without the inputs."""
    inputs: Record
    """Inputs, named as columns: `load_kg`, `q2_direction`."""
    joint_values: NDArray[np.float64]
    """Joint values (mm or deg), in the order of the joints of the check."""
    pose: int | str
    """Measured pose at which the inputs change the position most."""

class IntervalScore(Record):
    """Score of prediction intervals."""
    count: int
    """Number of intervals."""
    coverage: float
    """Share of measured values within their intervals."""
    coverage_interval: NDArray[np.float64] | None
    """Exact interval of the coverage at the same probability (Clopper & Pearson 1934). Each pose counts as one
    trial: the values of one pose share its error.
    """
    coverage_standard_uncertainty: float | None
    """Standard uncertainty of the coverage from the scatter between poses; absent with fewer than two poses."""
    mean_score: float
    """Mean interval score (Gneiting & Raftery 2007, eq. 43): width, and 2 / α times the distance of a value outside.
    A smaller score is better.
    """
    mean_width: float
    """Mean width."""
    probability: float
    """Probability of the intervals."""

class Iso9283Approach(Record):
    """Visits by one approach."""
    cycles: int
    """Number of visits."""
    deviation_mm: NDArray[np.float64] | None
    """Barycentre minus commanded position; null if no position was commanded."""
    enclosing_radius_mm: float | None
    """Radius of the smallest sphere (planar robots: circle) that encloses the positions of this approach."""
    mean_mm: NDArray[np.float64]
    """Barycentre."""
    name: str
    """Value of the column `approach`, or the previous pose of the path."""
    rp_mm: float | None
    """RP within this approach; null with a single visit."""

class Iso9283Arrival(Record):
    """One arrival, from the first entry into the limit band."""
    away_mm: NDArray[np.float64]
    """Distances from the standstill."""
    cycle: int
    """Number of the visit of that pose, from 1."""
    pose: int | str
    """Name of the pose."""
    time_s: NDArray[np.float64]
    """Times since the entry."""

class Iso9283Compliance(Record):
    """Compliance in one direction."""
    compliance_mm_n: float
    """Slope of the displacement along the force over the force."""
    cycles: int
    """Number of repeats."""
    direction: str
    """`+x`, `-x` ..."""
    force_n: float
    """Largest force."""
    largest_mm: float
    """Largest displacement along the force."""
    off_line_mm: float
    """Largest distance of a reading from the line."""
    readings: int
    """Number of readings under load."""
    standard_uncertainty_mm_n: float | None
    """Standard uncertainty of the compliance from the scatter about the line; null with a single reading."""

class Iso9283Corner(Record):
    """A corner of the commanded path (8.5)."""
    co_mm: float
    """CO: overshoot."""
    cr_mm: float
    """CR: round-off."""
    position_mm: NDArray[np.float64]
    """Commanded corner: x, y and, if spatial, z."""
    stabilisation_mm: float | None
    """Length along the second leg until the path stays within the limit band; null without a band, and if the path
    never stays within it.
    """

class Iso9283Distance(Record):
    """Distance between two poses (7.3)."""
    ad_angles_deg: NDArray[np.float64]
    """AD of the measured angles, in the order a, b, c; empty if the angles of a pose are not separable."""
    ad_axes_mm: NDArray[np.float64]
    """AD_x, AD_y and, if spatial, AD_z."""
    ad_mm: float
    """AD_p: mean attained minus commanded distance."""
    ad_rotation_deg: float | None
    """AD of the angle between the two orientations, where angles are not separable and their order is given."""
    cycles: int
    """Number of cycles with both poses."""
    poses: list[int | str]
    """The two poses."""
    rd_angles_deg: NDArray[np.float64]
    """RD of the measured angles."""
    rd_axes_mm: NDArray[np.float64]
    """RD_x, RD_y and, if spatial, RD_z."""
    rd_mm: float
    """RD_p: three standard deviations."""
    rd_rotation_deg: float | None
    """RD of this angle."""

class Iso9283Drift(Record):
    """Drift of one pose (7.6)."""
    ap_mm: NDArray[np.float64]
    """AP of each set."""
    dap_expanded_uncertainty_mm: float | None
    """Expanded uncertainty of `dap_mm`: scatter within the sets."""
    dap_mm: float
    """|AP at the start − AP at the end|."""
    drp_mm: float
    """|RP at the start − RP at the end|."""
    is_significant: bool
    """`true` if dAP exceeds the scatter within the sets, at a significance level of 0.1 %."""
    pose: int | str
    """Name of the pose."""
    rp_mm: NDArray[np.float64]
    """RP of each set."""
    settled_after: int | None
    """Number of sets until AP settled."""

class Iso9283Ellipsoid(Record):
    """Ellipsoid about the mean position; flat in directions without scatter."""
    axes: NDArray[np.float64]
    """Unit vectors of the semi-axes."""
    semi_axes_mm: NDArray[np.float64]
    """Semi-axes, descending."""

class Iso9283Epoch(Record):
    """One measurement of the reference targets."""
    cycle: int
    """First cycle to which the measurement applies."""
    moved_mm: float
    """Largest displacement of a target since the first measurement."""
    rms_mm: float
    """Root mean square distance of the targets after drift compensation."""

class Iso9283Interval(Record):
    """Two-sided 95 % interval."""
    high_mm: float
    """Upper end."""
    low_mm: float
    """Lower end."""

class Iso9283Item(Record):
    """One line of the test programme."""
    characteristic: str
    """Tested characteristic."""
    clause: str
    """Clause of the standard."""
    cycles: int
    """Number of cycles for each velocity."""
    read: bool
    """`true` if the line was verified against the standard's text, `false` if it is general knowledge."""
    velocities_percent: list[int]
    """Velocities (% of the rated velocity)."""
    visits: str
    """Poses of a cycle in order, or the path."""

class Iso9283JudgedApproach(Record):
    """Approach of a pose whose visits come from several approaches: the judged approach has the worst decision and,
    among these, the largest value.
    """
    cycles: int
    """Number of visits."""
    ellipsoid: Iso9283Ellipsoid | None
    """Ellipsoid that contains the next position by this approach with a probability of 95 %; null with fewer than
    five visits (planar robots: four).
    """
    name: str
    """Value of the column `approach`, or the previous pose of the path."""
    rp_without_noise_mm: float | None
    """RP of these visits without the instrument's noise, if visits were read several times."""
    value_mm: float
    """AP or RP of these visits."""

class Iso9283NamedStream(Record):
    """A recorded motion."""
    band_mm: float | None
    """Limit band, if given."""
    file: str
    """File, as in the campaign."""
    name: str
    """Name in the campaign."""
    stream: Iso9283StreamDocument
    """Characteristics of the recording."""

class Iso9283OutOfPlane(Record):
    """A pose and its distance from the plane of three other poses (thesis, 2.4)."""
    distance_mm: float
    """Distance from the plane."""
    pose: int | str
    """Name of the pose."""

class Iso9283Path(Record):
    """A commanded path and its passes (8)."""
    at_along_mm: float
    """Position of AT_p along the path."""
    at_angles_deg: NDArray[np.float64]
    """AT of the measured angles, in the order a, b, c; empty if two of them are not separable."""
    at_interval: Iso9283Interval | None
    """95 % interval of AT_p by parametric bootstrap over the passes; null with fewer than three."""
    at_mm: float
    """AT_p (8.2): largest distance between the mean path and the commanded path."""
    corners: Records[Iso9283Corner]
    """Corners of the commanded path."""
    incomplete: int
    """Number of unfinished passes."""
    length_mm: float
    """Length of the commanded path."""
    passes: int
    """Number of passes through all command points."""
    points: Records[Iso9283PathPoint]
    """Command points."""
    reorientation: bool
    """`true` if commanded angles change along the path; AT is then evaluated by 8.4."""
    rt_along_mm: float | None
    """Position of RT_p along the path."""
    rt_angles_deg: NDArray[np.float64]
    """RT of the measured angles; empty with a single pass, and if two of them are not separable."""
    rt_interval: Iso9283Interval | None
    """95 % interval of the RT_p of infinitely many passes. RT_p may exceed it, because the largest of many scattered
    values is biased upwards.
    """
    rt_mm: float | None
    """RT_p (8.3): largest mean radius plus three standard deviations; null with a single pass."""
    velocity: Iso9283Velocity | None
    """Velocity, if the commanded velocity is given."""

class Iso9283PathPoint(Record):
    """One command point."""
    along_mm: float
    """Length of the path up to this point."""
    commanded_mm: NDArray[np.float64]
    """Commanded position: x, y and, if spatial, z."""
    deviation_mm: float
    """Distance between mean attained and commanded position."""
    mean_mm: NDArray[np.float64]
    """Mean attained position in the normal plane of the point."""
    rt_mm: float | None
    """Mean radius plus three standard deviations of the passes; null with a single pass."""

class Iso9283Places(Record):
    """A list of poses, or a path."""
    joints: list[Record | None]
    """Joint values at each place if a robot is given; null if out of reach."""
    name: str
    """Name of the list, and of its files."""
    points: list[Record]
    """Coordinates of each place, numbered from 1: `x_mm`, `y_mm` and, if applicable, `z_mm`, `a_deg`, `b_deg`,
    `c_deg`.
    """
    purpose: str
    """Purpose of the list."""

class Iso9283Pose(Record):
    """Accuracy and repeatability of one pose. Coordinates that the robot does not have are absent."""
    ap_a_deg: float | None
    """AP_a."""
    ap_approach: Iso9283JudgedApproach | None
    """Approach to which interval and verdict of AP apply, if visits come from several: ISO 9283 defines AP for one
    approach.
    """
    ap_b_deg: float | None
    """AP_b."""
    ap_c_deg: float | None
    """AP_c."""
    ap_conformity: str | None
    """Conformity of AP with the given limit."""
    ap_interval: Iso9283Interval | None
    """95 % interval of AP by parametric bootstrap, including the instrument's uncertainty if given; null with fewer
    than three visits. If AP drifts significantly, the interval contains AP of every set of cycles.
    """
    ap_interval_analytic: Iso9283Interval | None
    """95 % interval of AP in closed form, from the sampling alone."""
    ap_interval_contains_sets: bool
    """`true` if the interval of AP contains AP of every set of cycles: it is then no coverage interval."""
    ap_mm: float | None
    """AP_p (7.2.1); this and its coordinates are null if no position was commanded."""
    ap_rotation_deg: NDArray[np.float64] | None
    """Rotation from the commanded to the mean orientation about x, y and z of the table, as a rotation vector. It
    replaces AP_a, AP_b and AP_c if two rotations have nearly the same axis and their order is given.
    """
    ap_smallest_approach: Iso9283JudgedApproach | None
    """Approach with the smallest AP, to which the 25 % rule applies, if visits come from several."""
    ap_x_mm: float | None
    """AP_x: mean minus commanded position."""
    ap_y_mm: float | None
    """AP_y."""
    ap_z_mm: float | None
    """AP_z."""
    cycles: int
    """Number of evaluated visits."""
    ellipsoid: Iso9283Ellipsoid | None
    """Ellipsoid of all visits that contains the next position with a probability of 95 %; null with fewer than five
    visits (planar robots: four).
    """
    enclosing_circle_radius_mm: float | None
    """Radius of the smallest circle that encloses the projections onto the xy plane."""
    enclosing_radius_mm: float | None
    """Radius of the smallest sphere (planar robots: circle) that encloses all positions."""
    mean_radius_mm: float | None
    """Mean distance from the barycentre."""
    noise_mm: NDArray[np.float64] | None
    """Standard deviation of one reading along each coordinate."""
    pose: int | str
    """Name of the pose."""
    position_uncertainty_mm: float | None
    """Expanded uncertainty of the instrument for a position (k = 2), if given."""
    quarter_rule_met: bool | None
    """`true` if both ratios are at most a quarter (clause 6)."""
    rp_a_deg: float | None
    """RP_a: three standard deviations."""
    rp_along_x_mm: float | None
    """RP along x alone."""
    rp_along_y_mm: float | None
    """RP along y alone."""
    rp_along_z_mm: float | None
    """RP along z alone."""
    rp_approach: Iso9283JudgedApproach | None
    """Approach to which interval and verdict of RP apply, if visits come from several: ISO 9283 defines RP for one
    approach.
    """
    rp_b_deg: float | None
    """RP_b."""
    rp_c_deg: float | None
    """RP_c."""
    rp_conformity: str | None
    """Conformity of RP with the given limit."""
    rp_interval: Iso9283Interval | None
    """95 % interval of RP by parametric bootstrap, including the instrument's uncertainty if given; null with fewer
    than three visits.
    """
    rp_interval_analytic: Iso9283Interval | None
    """95 % interval of RP in closed form, from the sampling alone."""
    rp_mm: float | None
    """RP_l (7.2.2): mean radius plus three standard deviations; this and all further values are null with a single
    visit.
    """
    rp_rotation_deg: NDArray[np.float64] | None
    """Three standard deviations of the rotations from the mean orientation about x, y and z of the table, instead of
    RP_a, RP_b and RP_c.
    """
    rp_smallest_approach: Iso9283JudgedApproach | None
    """Approach with the smallest RP, to which the 25 % rule applies, if visits come from several."""
    rp_without_noise_mm: float | None
    """RP of all visits without the instrument's noise, if visits were read several times."""
    rp_x_mm: float | None
    """RP_x: three standard deviations."""
    rp_xy_mm: float | None
    """RP of the projections onto the xy plane (thesis, table 2.1)."""
    rp_y_mm: float | None
    """RP_y."""
    rp_z_mm: float | None
    """RP_z."""
    sd_radius_mm: float | None
    """Standard deviation of the distance from the barycentre."""
    uncertainty_over_ap: float | None
    """Expanded uncertainty of the instrument for a position (k = 2) over AP, if given; the largest ratio of all
    approaches.
    """
    uncertainty_over_rp: float | None
    """Expanded uncertainty of the instrument over RP; the largest ratio of all approaches."""

class Iso9283Posing(Record):
    """Moves from one pose to another (9)."""
    distance_mm: float
    """Mean straight distance between the standstills."""
    from_: int | str
    """Pose at the start."""
    moves: int
    """Number of moves."""
    path_mm: float | None
    """Mean length of the attained path, in steps longer than the limit band; absent in documents of earlier
    programs.
    """
    posing_expanded_uncertainty_s: float | None
    """Expanded uncertainty of this time: scatter of the moves, and sampling interval."""
    posing_s: float
    """Mean posing time."""
    to: int | str
    """Pose at the end."""

class Iso9283Settling(Record):
    """Arrivals at one pose (7.4, 7.5)."""
    arrivals: int
    """Number of arrivals that settled."""
    overshoot_expanded_uncertainty_mm: float | None
    """Expanded uncertainty of this overshoot: scatter of a sample about the standstill."""
    overshoot_mm: float
    """Largest overshoot; zero if no arrival left the limit band again."""
    pose: int | str
    """Name of the pose."""
    stabilisation_expanded_uncertainty_s: float | None
    """Expanded uncertainty of this time: scatter of the arrivals, and sampling interval."""
    stabilisation_s: float
    """Mean stabilisation time."""

class Iso9283Standstill(Record):
    """A standstill."""
    cycle: int | None
    """Number of the visit of that pose, from 1."""
    from_s: float
    """Time of the first sample."""
    mean_deg: NDArray[np.float64]
    """Means of the measured angles, in the order a, b, c; angles of the middle sample if two of them are not
    separable.
    """
    mean_mm: NDArray[np.float64]
    """Mean position of the middle half: x, y and, if measured, z."""
    noise_mm: float | None
    """Noise of the instrument and of the robot at standstill: mean radius plus three standard deviations of the
    samples of the middle half.
    """
    overshoot_mm: float | None
    """Overshoot of the arrival (7.5); null without a limit band."""
    pose: int | str | None
    """Name of the visited pose; null if no pose is near."""
    posing_s: float | None
    """Posing time from the previous standstill (9); null without a limit band."""
    samples: int
    """Number of samples."""
    stabilisation_s: float | None
    """Stabilisation time of the arrival (7.4); null without a limit band, and if the position does not enter or stay
    within the band.
    """
    to_s: float
    """Time of the last sample."""

class Iso9283Unreached(Record):
    """A place that the given robot does not reach."""
    places: str
    """Name of the list."""
    point: int
    """Number of the point in the list, from 1."""
    reason: str
    """Reason."""
    reason_phrase: Phrase | None
    """Text of the catalogue that is `reason` in English."""

class Iso9283Variation(Record):
    """A pose that was approached in several ways (7.2.3)."""
    approaches: Records[Iso9283Approach]
    """Characteristics of each approach."""
    between: list[str]
    """Approaches with the largest distance."""
    mean_mm: NDArray[np.float64] | None
    """Barycentre of all visits of the pose; absent in documents of earlier programs."""
    pose: int | str
    """Name of the pose."""
    vap_angles_deg: NDArray[np.float64]
    """vAP of the measured angles, in the order a, b, c; empty if they are not separable."""
    vap_mm: float
    """vAP_p: largest distance between the barycentres of two approaches."""
    vap_rotation_deg: float | None
    """Largest angle between the mean orientations of two approaches, where angles are not separable and their order
    is given.
    """

class Iso9283Velocity(Record):
    """Velocity over the central part of the path (8.6)."""
    av_percent: float
    """AV: path velocity accuracy."""
    commanded_mm_s: float
    """Commanded velocity."""
    fv_mm_s: float
    """FV: path velocity fluctuation, including the instrument's noise."""
    mean_mm_s: float
    """Mean velocity of all passes."""
    rv_percent: float | None
    """RV: path velocity repeatability; null with a single pass."""

class Iso9283Visit(Record):
    """One visit of one pose."""
    approach: str | None
    """Approach to the pose; null if unknown: for the very first visit, or where the reading of the previous pose is
    missing.
    """
    attained_mm: NDArray[np.float64]
    """Attained position."""
    cycle: int
    """Number of the cycle."""
    pose: int | str
    """Name of the pose."""

class Iso9283Weaving(Record):
    """A weave (11): means of all passes."""
    commanded_frequency_hz: float
    """Commanded frequency: full swings per second."""
    commanded_stroke_mm: float
    """Commanded stroke from side to side."""
    frequency_hz: float
    """Attained frequency."""
    passes: int
    """Number of passes of the centre line."""
    stroke_mm: float
    """Attained stroke."""
    turns: int
    """Number of turns counted in all passes."""
    wf_percent: float
    """WF: attained minus commanded frequency (% of the commanded frequency)."""
    ws_percent: float
    """WS: attained minus commanded stroke (% of the commanded stroke)."""

class Issue(Record):
    """Identification of a report (ISO/IEC 17025:2017, 7.8.2.1). A report shows missing entries as "not given"."""
    amends: str | None
    """Number and date of the report that this report amends or replaces, and the reason."""
    authorised_by: str | None
    """Person who authorises the report: name and function."""
    country: Any
    """Country in which the calibration was made (ISO 3166-1)."""
    customer: str | None
    """Name and contact of the customer."""
    external_results: str | None
    """Results that an external provider obtained."""
    issued: str | None
    """Date of issue."""
    number: str | None
    """Number of the report, unique in the laboratory."""

class JointExtrapolation(Record):
    """Growth of the errors of predictions beyond the measured values of a joint. It is estimated by predicting one
    half of the joint's values from the other half.
    """
    distance: float
    """Distance beyond these values at which the excess variances apply. Their square roots grow with the distance."""
    high: float
    """Largest measured value."""
    joint: str
    """Joint, named as a column with its unit: `q2_deg`."""
    low: float
    """Smallest measured value (unit of the joint)."""
    orientation: float
    """Excess variance of an orientation, relative to the residual variance of an orientation."""
    position: float
    """Excess variance of a coordinate, relative to the residual variance of a coordinate."""

class JointTravel(Record):
    """Smallest and largest value of a joint."""
    column: str
    """Column of the joint with its unit: `q1_deg`, `rho1_mm`."""
    highest: float
    """Largest value."""
    lowest: float
    """Smallest value."""

class KinematicsEntry(Record):
    """A pose of the tool in the base frame with joint values."""
    free_joints: list[str]
    """Joints that can move without moving the tool, at a singular pose; of all solutions, the joint values are then
    the nearest to the start.
    """
    joints: NDArray[np.float64]
    """Joint values (mm or deg), in the order of the columns."""
    pose: int | str
    """Name of the pose."""
    quaternion: NDArray[np.float64]
    """Orientation: unit quaternion w, x, y, z."""
    xyz_mm: NDArray[np.float64]
    """Position (mm)."""

class KnownValue(Record):
    """Known length or position that counts like a measured value."""
    name: str
    """Two points, the parameter, or the surface."""
    place_mm: NDArray[np.float64] | None
    """Position (mm) of a point of a surface."""
    quantity: str
    """`distance`, `coordinate` or `surface`."""
    residual_mm: float
    """Identified minus stated value (mm)."""
    standard_uncertainty_mm: float
    """Standard uncertainty (mm)."""
    stated_mm: float | None
    """Stated value (mm); absent for a point of a surface."""

class LeadResult(Record):
    """Lead of an actuator."""
    actual_lead_mm: float
    """Actual lead."""
    actuator: int
    """Number of the actuator."""
    error: float
    """Actual displacement over nominal displacement, minus one."""
    linearity: Records[Linearity]
    """Mean deviation from linear travel at each position."""
    nominal_lead_mm: float
    """Nominal lead of its screw."""
    standard_uncertainty: float
    """Standard uncertainty of `error`."""

class LeastDetectable(Record):
    """Smallest detectable movement of one kind."""
    name: str
    """`base shift`, `base rotation`, or the name of a joint."""
    named: float | None
    """Smallest movement of a joint that is detected and attributed to the right joint with the probability `naming`;
    absent if another joint moves all targets equally.
    """
    unit: str
    """`mm` or `deg`."""
    value: float | None
    """Smallest detectable movement; absent if the observations cannot show it."""

class LeftOutErrors(Record):
    """Position errors (mm) at calibration poses, each predicted from the other folds: one value for each pose, the
    root mean square over its readings.
    """
    folds: int
    """Number of folds; each is predicted from the others."""
    identified: Statistics
    """Errors with the identified parameters."""
    nominal: Statistics
    """Errors with nominal parameters; base and targets are fitted."""
    poses: int
    """Number of poses, at most 200."""

class LimitVerdict(Record):
    """A limit of the campaign and its verdict."""
    acceptance: str
    """Verdict: the conformity, with a reservation if the value was accepted within its guard band."""
    conformity: str
    """Decision by the rule."""
    conformity_probability: float | None
    """Probability that the true value is within the limit, by the value with its uncertainty (JCGM 106:2012, 7.2);
    the risk of a false acceptance is the complement. Absent if the uncertainty is unknown, and if the interval of
    the value is no coverage interval because AP drifts.
    """
    decision_rule: str
    """Decision rule."""
    expanded_uncertainty: float | None
    """Expanded uncertainty of the value (k = 2); null if unknown. If `interval` is given, the distance from the
    value to its upper end.
    """
    interval: NDArray[np.float64] | None
    """Ends of the 95 % interval of the value, if they are not symmetric to it; absent otherwise."""
    limit: float
    """Largest permissible value."""
    margin: float | None
    """Limit minus value; absent without a value."""
    met: bool
    """`true` if the limit is met by the rule."""
    name: str
    """Name of the limit in the campaign."""
    unit: str
    """Unit of the numbers."""
    value: float | None
    """Measured value, at the validation poses if there are any; null if the quantity was not measured."""

class Linearity(Record):
    """Deviation from linear travel at one position."""
    commanded_mm: float
    """Commanded displacement."""
    deviation_mm: float
    """Mean deviation of all passes."""

class Loading(Record):
    """Parameters that a controller should load."""
    alternatives: list[str]
    """Further files with the same errors."""
    answer: str
    """Answer."""
    effects: list[str]
    """Effects to identify first, if the answer is `identify_further`."""
    errors: ControllerErrors | None
    """Errors of the file at the deciding poses; absent unless the answer is `load`."""
    file: str | None
    """Best controller file, relative to the output folder; absent unless the answer is `load`, or if no file for a
    controller was written.
    """
    is_for_controllers: bool | None
    """`false` for files that programs of a laboratory read, and no controller loads."""

class LoadingCheck(Record):
    """Pose on the display of a controller at joint values that were measured: before and after a file is loaded."""
    after: DisplayedPose
    """Pose with the values of the file."""
    before: DisplayedPose
    """Pose with nominal parameters."""
    joint_values: NDArray[np.float64]
    """Joint values (mm or deg) before loading."""
    joints: list[str]
    """Joints, named as columns: `q1_deg`; the assembly mode of a five-bar."""
    link: str | None
    """Link whose pose is compared, for a robot with several branches."""
    mastered_joint_values: NDArray[np.float64]
    """Joint values (mm or deg) on the display after loading the file as mastering values, without motion. Empty if
    the file changes more than joint zeros.
    """
    pose: int | str
    """Measured pose at which the file changes the displayed position most."""
    tolerance_mm: float | None
    """Largest difference (mm) between a displayed and an announced position that rounding explains; absent in output
    folders of earlier versions.
    """
    with_inputs: InputsCheck | None
    """Pose with the inputs of a reading, if the values of the file depend on inputs in addition to joint values."""

class LockedPackage(Record):
    """A package in Cargo.lock."""
    name: str
    """Name of the package."""
    sha256: str | None
    """SHA-256 of the package's archive; null for the crates of etalon."""
    version: str
    """Version."""

class Machine(Record):
    """Machine on which a program runs."""
    architecture: str
    """Architecture of the processor: `x86_64`, `aarch64` ..."""
    system: str
    """Operating system: `linux`, `windows`, `macos` ..."""
    threads: int
    """Number of threads that the system offers."""

class MapNode(Record):
    """Expected error at one node of the grid."""
    at_mm: NDArray[np.float64]
    """Position of the node in the base frame."""
    before_mm: float
    """Size of the error before calibration: position predicted with the parameters before calibration minus position
    predicted with the identified parameters (mm).
    """
    joints: NDArray[np.float64]
    """Joint values at the node (mm or deg) in the order of [`AccuracyDocument::joints`], for the orientation of the
    nearest calibration pose.
    """
    p95_mm: float
    """95th percentile of the size of the error (mm)."""
    parameters_mm: float
    """Standard uncertainty of the predicted position due to the identified parameters (mm, k = 1)."""
    standard_uncertainty_mm: float
    """Expected size of the error from all sources, root mean square (mm)."""
    with_field_mm: float | None
    """Expected size of the error with the residual field, root mean square (mm); absent without a field."""

class MeanError(Record):
    """Mean error of a pose: measured minus predicted."""
    orientation_deg: float
    """Orientation error."""
    position_mm: float
    """Size of the position error."""
    x_mm: float
    """Error along x."""
    y_mm: float
    """Error along y."""

class MeasuringOrder(Record):
    """Order in which poses are measured: nearest neighbour and swaps of legs (2-opt)."""
    indices: list[int]
    """Indices of `chosen`, from 0, in the order of measurement."""
    motion: float
    """Length of the motion: sum over the legs of the largest motion of a joint, as a share of the joint's span over
    all candidates.
    """
    motion_as_listed: float
    """Length of the motion in the order of `chosen`."""

class Message(Record):
    """One error or warning: id and arguments of its text in the catalogue, the English texts, and its place."""
    arguments: Record
    """Arguments of the texts. `expected` and `hint` are texts of the catalogue that replace the message's own."""
    around: Records[Phrase]
    """Texts around the message, from inside: each has the message as its argument `message`."""
    expected: str | None
    """Expected value."""
    hint: str | None
    """Next action."""
    id: str
    """Id in the catalogue; `etalon explain ID` explains it."""
    place: Place | None
    """Place of the problem."""
    rank: str
    """Importance for a reader."""
    severity: str
    """Error or warning."""
    what: str
    """Error or remark, in one English sentence without a full stop."""

class MethodErrors(Record):
    """Largest and root-mean-square mean errors."""
    name: str
    """`nominal`, `geometric` or `identified`."""
    orientation_max_deg: float
    """Largest orientation error."""
    position_max_mm: float
    """Largest position error."""
    position_rms_mm: float
    """Root mean square position error."""

class MotionByNoise(Record):
    """Error motion of a perfect axis, by the noise of the measuring system."""
    expected: float
    """Expected value."""
    standard_uncertainty: float
    """Standard uncertainty of the measured value by noise."""

class MovedValue(Record):
    """A value that differs from its stored value."""
    after: float | None
    """Value now; null if this program gives no value."""
    before: float | None
    """Stored value; null if the document has none."""
    over_uncertainty: float | None
    """Absolute difference over the stored standard uncertainty; null without an uncertainty."""
    parameter: str
    """Name of the parameter; empty for a value of the whole identification."""
    quantity: str
    """`value`, `standard_uncertainty` or `rms`."""
    unit: str
    """Unit."""

class Movement(Record):
    """A movement, and the remaining residuals."""
    by: Records[MovementValue]
    """Displacement. Base: shift of its origin and rotation vector, in the world. Joint: change of its zero. Target:
    shift on the moving part.
    """
    explained_share: float
    """Share of the weighted sum of squared residuals that the movement explains."""
    kind: str
    """Kind of the moved object."""
    name: str
    """`base`, or the name of the joint or of the target."""
    p_left: float
    """Probability of residuals at least as large as those left after the movement."""

class MovementValue(Record):
    """One component of a movement."""
    name: str
    """`x`, `y`, `z`, `rx`, `ry`, `rz`, or the name of a joint."""
    standard_uncertainty: float | None
    """Standard uncertainty (k = 1); absent if the observations do not determine the component."""
    unit: str
    """`mm` or `deg`."""
    value: float
    """Value of the component."""

class NominalUncertainties(Record):
    """Standard uncertainties of nominal values before the measurements."""
    standard_uncertainties: list[float | None]
    """Standard uncertainty of the nominal value of each parameter: its tolerance / √3 (rectangular distribution, GUM
    4.3.7), with a default tolerance multiplied by `tolerance_factor`. `null` for parameters without a nominal
    value.
    """
    tolerance_factor: float
    """Factor of default tolerances, at most 1: the data may show a more accurately built robot."""

class ObservabilitySummary(Record):
    """Observability of the parameters from the poses."""
    condition: float
    """Condition number with columns scaled to unit length."""
    held_singular_values: Records[SingularValueEntry]
    """Smallest singular values of the Jacobian with all parameters that were to be identified. There is one for each
    parameter that is held because the data determine it poorly or not at all; empty in a plan.
    """
    o1: float
    """O1 = (σ1…σm)^(1/m) / √n for m parameters and n poses (Sun & Hollerbach 2008)."""
    o2: float
    """O2 = σmin / σmax (thesis, eq. 1.20)."""
    o3: float
    """O3 = σmin (thesis, eq. 1.22)."""
    o4: float
    """O4 = σmin² / σmax (thesis, eq. 1.23)."""
    o5: float
    """O5 = 1 / Σ 1/σ (thesis, eq. 1.25)."""
    rank: int
    """Number of separately identifiable parameters."""
    rank_cut: float
    """Rank tolerance: a parameter is held if its column, scaled to unit length, is closer than this to the span of
    the columns before it.
    """
    scaling: str
    """Scaling of the indices."""
    scaling_phrase: Phrase | None
    """Text of the catalogue that is `scaling` in English."""
    singular_values: Records[SingularValueEntry]
    """Singular values of the Jacobian at the solution, descending, with columns scaled to unit length. The ratio of
    the largest to the smallest is the condition number; the squares add up to the number of parameters.
    """

class OrientationBudget(Record):
    """Standard uncertainty of an orientation error."""
    contributions: Records[OrientationContribution]
    """Contribution of each source; the squares add up."""
    standard_uncertainty_deg: float
    """Standard uncertainty (deg, k = 1)."""

class OrientationContribution(Record):
    """Contribution of one source to the standard uncertainty of an orientation error."""
    source: str
    """Source."""
    standard_uncertainty_deg: float
    """Contribution (deg)."""

class ParameterEntry(Record):
    """One parameter."""
    before: float
    """Value before calibration, with only base and targets fitted."""
    confounded_with: list[str]
    """Parameters that cannot be separated from this parameter; if there are more than 99, the held one alone."""
    degrees_of_freedom: float | None
    """Effective degrees of freedom of the standard uncertainty (GUM G.4.1), if it is estimated from residuals."""
    determined: float | None
    """Share of the value that the data determined: 1 − (u/s)², where s is the standard uncertainty of the nominal
    value from its tolerance. Absent if nominal values are not used as observations.
    """
    full_unit: str | None
    """Unit with the load or temperature to which the value refers: `deg/(100 N·m)`; absent if the value refers to
    neither.
    """
    meaning: str
    """Meaning and sign of the parameter, in words."""
    meaning_id: str | None
    """Id of the meaning in the catalogue of texts."""
    name: str
    """Name as in the thesis."""
    nominal: float
    """Nominal value."""
    role: str
    """Owner of the parameter: robot, base, target or fixture."""
    standard_uncertainty: float | None
    """Standard uncertainty (k = 1); absent if not identified."""
    status: str
    """Identified, fixed or not identifiable."""
    tolerance: float | None
    """Tolerance about the nominal value, if the robot's file contains one."""
    unit: str
    """`mm`, `deg` or `1`."""
    value: float
    """Identified value, or value at which the parameter is held."""

class ParameterInfluence(Record):
    """Effect of a parameter at the measured point that it moves most, with all other parameters, base and targets
    unchanged.
    """
    change_mm: float
    """Displacement of the point by identified minus nominal value (mm), with the sign of the change."""
    name: str
    """Name of the parameter."""
    pose: int | str
    """Pose of the point."""
    standard_uncertainty_mm: float | None
    """Displacement of the point by the standard uncertainty of the parameter (mm, k = 1)."""
    tolerance_mm: float | None
    """Displacement of the point by the given tolerance of the parameter (mm)."""

class ParameterVerdict(Record):
    """Part of a parameter in the answer, and the evidence for its change."""
    change: float
    """Identified minus nominal value, in the model with all parameters."""
    change_over_u: float
    """Change over its standard uncertainty."""
    displacement_mm: float | None
    """Displacement by the change (mm) of the measured point that it moves most; absent if the run does not identify
    the parameter.
    """
    effect: str
    """Effect that the parameter describes."""
    fold_sd_over_u: float
    """Standard deviation over the folds, relative to the standard uncertainty of one fold."""
    name: str
    """Name of the parameter."""
    p_value: float
    """Probability of such a change if the true value is nominal, corrected for the number of parameters (Holm 1979)."""
    part_change_limit: float | None
    """Limit of `part_change_over_sd` by chance, with a probability of 99 % for all parameters together; beyond it
    the parameter is unstable.
    """
    part_change_over_sd: float | None
    """Largest absolute difference between the value from part of the poses and the value from all poses, over its
    standard deviation by chance √(u_part² − u_all²). Absent outside the recommended model, and if no part
    determines the parameter.
    """
    unit: str
    """Unit of the parameter."""
    verdict: str
    """Verdict: load the parameters, or do not load them."""

class Phrase(Record):
    """Text of the catalogue with its arguments."""
    arguments: Record
    """Arguments of the text."""
    id: str
    """Id in the catalogue."""

class Place(Record):
    """Place of a message: a file, optionally a line and columns."""
    column: int | None
    """Column in characters, from 1."""
    file: str
    """File as in the campaign."""
    line: int | None
    """Line, from 1."""
    text: str | None
    """The line itself."""

class PlacedApart(Record):
    """A target or fixture that is placed by its own readings at validation poses. The placement reduces the errors
    of these readings, so that each is divided by √r in the statistics; without redundancy it does not count.
    """
    is_assessed: bool
    """`true` if errors of the readings count: r is at least 0.1 for at least one reading."""
    name: str
    """Name of the target or fixture."""
    readings: int
    """Number of readings that locate the target."""
    redundancy: float
    """Mean redundancy number r of the readings: the share of an error that its reading shows. For n positions of a
    target, r = 1 − 1/n.
    """

class PlannedObstacle(Record):
    """A body in the way of the instrument."""
    hidden: int
    """Draws in which the body hides a reflector, and no earlier one in the list does."""
    is_link: bool
    """`true` if the body is a link of the arm, which moves with the joint of this name."""
    name: str
    """Name; for a link, the name of its joint."""
    stated: str
    """Shape and size (mm), as given."""

class PlannedParameter(Record):
    """One parameter and its predicted uncertainty."""
    confounded_with: list[str]
    """Parameters that the chosen poses separate from this parameter poorly or not at all."""
    identifiable: bool
    """`true` if the parameter is identifiable from the candidates."""
    name: str
    """Name as in the thesis."""
    standard_uncertainty: float | None
    """Predicted standard uncertainty; absent if the instrument's uncertainty is not given."""
    unit: str
    """`mm`, `deg` or `1`."""

class PlannedPose(Record):
    """One pose to measure."""
    configurations: list[Record]
    """Joint values of each configuration, by column."""
    pose: int | str
    """Number of the pose in the candidates."""

class PlannedProgram(Record):
    """A program that drives to the chosen poses."""
    dwell_s: float
    """Waiting time at each pose."""
    file: str
    """Name of the file."""
    language: str
    """Language."""
    trigger: str | None
    """Digital output that is on during the second half of the waiting time, if given."""

class PlannedReflector(Record):
    """A reflector on the flange."""
    acceptance_deg: float | None
    """Largest angle between the axis and the direction to the instrument, if given."""
    at_mm: NDArray[np.float64]
    """Nominal position in the frame of the flange."""
    axis: NDArray[np.float64] | None
    """Outward axis in the frame of the flange, if given."""
    name: str
    """Name of the target."""

class Pose(Record):
    """A rigid transform: rotation matrix and translation."""
    rotation: NDArray[np.float64]
    """Rotation matrix, row by row."""
    translation_mm: NDArray[np.float64]
    """Translation (mm)."""

class PoseRow(Record):
    """Mean errors of one pose."""
    command_deg: float
    """Commanded orientation."""
    command_mm: NDArray[np.float64]
    """Commanded position of C in the base frame: prediction of the nominal model from the joints."""
    count: int
    """Number of repeats."""
    geometric: MeanError
    """Error with the geometric parameters."""
    identified: MeanError
    """Error with the identified parameters."""
    nominal: MeanError
    """Error with nominal parameters in the geometric base frame."""
    pose: int | str
    """Name of the pose."""
    standard_deviation_mm: float
    """Standard deviation over the repeats: the larger of x and y."""

class PoseTable(Record):
    """Mean errors of some poses (thesis, tables 2.2 to 2.4)."""
    rows: Records[PoseRow]
    """One row per pose."""
    title: str
    """Title."""

class PositionErrors(Record):
    """Root mean square and maximum of position errors."""
    max_mm: float
    """Maximum (mm)."""
    rms_mm: float
    """Root mean square (mm)."""

class PredictedBody(Record):
    """Predicted orientation of the body that carries a target."""
    quaternion: NDArray[np.float64]
    """Orientation in the world: unit quaternion w, x, y, z."""
    standard_uncertainty_deg: float
    """Standard uncertainty (deg) of the difference from a measured orientation about any axis."""

class PredictedMeasurement(Record):
    """Predicted measurement of a target."""
    covariance_mm2: NDArray[np.float64]
    """Covariance (mm²) of the difference from a measured position: parameters, model and instrument."""
    orientation: PredictedBody | None
    """Orientation of the body that carries the target; absent if the calibration observed none."""
    pose: int | str
    """Name of the pose."""
    target: str
    """Name of the target."""
    xyz_mm: NDArray[np.float64]
    """Position (mm) in the world."""

class PredictionMap(Record):
    """Expected error at the tool point with the identified parameters, on a grid. The grid covers places between the
    calibration poses that the robot reaches without a joint leaving its range in the calibration.
    """
    definition: str
    """Definition of the numbers of a node, in words."""
    frame: str
    """Part to which the point is attached."""
    nodes: Records[MapNode]
    """Nodes in the order of x, y and z."""
    point_mm: NDArray[np.float64]
    """Position of the point in `frame`."""
    spacing_mm: float
    """Distance between neighbouring nodes (mm)."""

class Presentation(Record):
    """Complete presentation of a report: the output folder suffices to write the report again."""
    language: str
    """Language of the report."""
    logo: str | None
    """The laboratory's logo as a data URI (SVG or PNG)."""
    templates: Record
    """The laboratory's own templates: texts by file name."""

class Provenance(Record):
    """Origin of numbers."""
    inputs: Record
    """SHA-256 of every input, by file name."""
    seed: int | None
    """Seed of random numbers, if any were drawn."""
    version: str
    """Version of etalon."""

class QuantityResiduals(Record):
    """Residuals of the observations of one quantity."""
    count: int
    """Number of residuals."""
    quantity: str
    """`position`, `orientation`, `distance`, `surface`, `contact`, `coordinate` or `joint`."""
    rms: float
    """Root mean square of the residuals."""
    standard_uncertainty: float
    """Root mean square of the standard uncertainties of the observed values."""
    unit: str
    """Unit of the residuals: `mm` or `deg`."""

class QuantityScore(Record):
    """Score of the predicted positions or orientations."""
    ellipsoid_coverage: float | None
    """Share of positions within the ellipsoid of `probability`; absent without covariances that are positive
    definite.
    """
    errors: Statistics
    """Distances of predicted from measured positions, or angles between orientations."""
    intervals: IntervalScore | None
    """Intervals of coordinates, or of rotations about the axes of the world; absent if the predictions give none."""
    unit: str
    """Unit of errors and widths: mm or deg."""

class Reading(Record):
    """Interpretation of a delimited text, without the unit of lengths."""
    columns: list[str]
    """Value of the campaign's key `columns`."""
    decimal: str
    """Value of the campaign's key `decimal`."""
    delimiter: str | None
    """Value of the campaign's key `delimiter`; absent for a sheet of a workbook."""
    header: int
    """Number of rows before the data."""
    share: float
    """Share of the examined rows that have the most frequent number of fields, at least two of them numbers (0 to
    1).
    """
    sheet: str | None
    """Value of the campaign's key `sheet`, for a workbook."""
    thousands: str | None
    """Value of the campaign's key `thousands`, if digits are grouped."""

class ReadingValues(Record):
    """Values of one column at the poses of a set."""
    column: str
    """Column of the readings, which names the unit: `load_kg`."""
    distinct: NDArray[np.float64]
    """Distinct values in ascending order; absent if there are more than five."""
    highest: float
    """Highest value."""
    lowest: float
    """Lowest value."""
    quantity: str
    """Quantity of the column."""

class ReferenceFile(Record):
    """File of the reference data."""
    expected_sha256: str
    """SHA-256 that the program gives."""
    name: str
    """Name of the file."""
    pass_: bool
    """`true` if both agree."""
    sha256: str
    """SHA-256 of the file in the program."""

class ReferencePose(Record):
    """Three points of the flange at joint values, in the frame of the base, by the nominal geometry."""
    branch: str | None
    """Link at the end of the branch, for a robot with several branches."""
    joints: NDArray[np.float64]
    """Joint values (mm or deg), in the order of the joints."""
    nominal_mm: NDArray[np.float64]
    """Flange origin, and the points 100 mm along its x and y axes, at nominal parameters (mm)."""
    varied_mm: NDArray[np.float64]
    """These points with each parameter of the robot 0.1 mm, 0.1 deg or 0.0001 above its nominal value (mm): this
    shows effects whose nominal values are zero.
    """

class Refused(Record):
    """A rejected row."""
    line: int
    """Line in the file, from 1."""
    reason: str
    """Rule that rejected the row."""
    reason_phrase: Phrase | None
    """Text of the catalogue that is `reason` in English."""
    text: str
    """Text of the line."""

class Region(Record):
    """A region of the workspace."""
    area_mm2: float
    """Area of the region."""
    corners_mm: NDArray[np.float64]
    """Corners of the region in the base frame, counterclockwise; z is zero."""
    name: str
    """Name of the region."""
    name_phrase: Phrase | None
    """Text of the catalogue that is `name` in English."""

class RelativeAccuracy(Record):
    """Errors of the distances between poses: predicted minus measured distance of one target (or the centre of a
    platform) at two different poses. The base has no effect on them; the target has none where both poses have
    the same orientation.
    """
    all: DistanceStatistics
    """All distances."""
    available: int
    """Number of pairs of readings of one target at different poses. Of more than 100 000 pairs an even selection is
    counted: `all.pairs`; the largest error is the largest in the selection.
    """
    set: str
    """Set of poses: `validation`, or `calibration` in a campaign without validation poses."""
    steps: Records[DistanceStatistics]
    """Distances by steps; steps without a pair are omitted."""

class ReliabilitySummary(Record):
    """Reliability of the readings (Baarda 1968), and influence of the poses (Cook 1977)."""
    beyond: int
    """Number of readings beyond `critical_w`."""
    critical_w: float
    """Normalised residual (residual over its standard deviation σ √r) beyond which a reading is an outlier."""
    influential: float
    """Cook's distance beyond which a pose is influential: the median of the F distribution."""
    largest_detectable_mm: float | None
    """Largest of the smallest detectable errors (mm); absent if a reading is uncontrolled."""
    least_redundancy: float
    """Smallest redundancy number r of a coordinate: share of an error of the coordinate that its residual shows (0
    to 1).
    """
    median_detectable_mm: float | None
    """Smallest detectable error of a coordinate, 4.13 σ / √r (mm): median over the readings."""
    poses: Records[InfluenceEntry]
    """Poses whose omission changes the parameters most."""
    power: float
    """Power β0 with which an error of detectable size is detected."""
    readings: int
    """Number of measured positions."""
    sigma_mm: float
    """Standard deviation σ of a coordinate (mm): the given one if it explains the residuals, otherwise estimated
    from the residuals.
    """
    significance: float
    """Significance level α0 of the test of one residual."""

class RepeatStatistics(Record):
    """Scatter of repeated determinations."""
    count: int
    """Number of determinations."""
    enlarged: bool
    """`true` if the repeats scatter more than expected (chi-square test at 0.1 %), so that the uncertainty was
    increased.
    """
    expected: float
    """Standard deviation expected from the points' uncertainties. Frames that all repeats share cancel."""
    standard_deviation: float
    """Standard deviation of one determination."""

class Replicates(Record):
    """Scatter of repeats against the other residuals (Draper & Smith, Applied Regression Analysis, 2.1)."""
    degrees_of_freedom: int
    """Degrees of freedom of the scatter of repeats."""
    lack_of_fit_mm: float
    """Standard deviation of the model error of a coordinate at a pose, without the scatter of repeats (mm)."""
    p_value: float
    """Probability of residuals at least this large if the model is right (F test of lack of fit)."""
    repeats_mm: float
    """Standard deviation of a coordinate among repeats of a pose (mm)."""

class ResidualSummary(Record):
    """Residuals of the identification."""
    between_series: SeriesScatter | None
    """Scatter of the parameters between the series of the campaign (`series` in campaign.toml), beyond the scatter
    between regions of the workspace. Absent for one series.
    """
    chi_square: float | None
    """Chi-square with both stated uncertainties."""
    chi_square_rejected: bool
    """`true` if chi-square rejects the hypothesis that measurement noise explains the residuals, at a significance
    level of 0.1 %.
    """
    common_standard_uncertainty_mm: float | None
    """Standard uncertainty common to all observations of the same coordinates (mm): of the instrument, if the
    uncertainty of the contact is given separately.
    """
    conditions: Records[QuantityResiduals]
    """Residuals of each quantity other than coordinates of targets."""
    coordinates: QuantityResiduals | None
    """Residuals of the coordinates of targets with their stated uncertainty; absent without coordinates or a stated
    uncertainty, and in documents of earlier versions.
    """
    count: int
    """Number of residuals: of measured values, one for each coordinate, distance or angle."""
    degrees_of_freedom: int
    """Degrees of freedom: `count` plus `stated_values` minus `determined_parameters`, rounded."""
    determined_parameters: float | None
    """Number of identified parameters that the data determine: each counts by the share that its tolerance leaves to
    the data. Absent in documents of earlier versions.
    """
    effective_degrees_of_freedom: float | None
    """Effective degrees of freedom of the residual variance, by the scatter of the squares from pose to pose.
    Squares of a smooth misfit scatter more than squares of noise.
    """
    extrapolation: Records[JointExtrapolation]
    """Growth of the errors of predictions beyond the measured values of joints. Empty if the instrument explains the
    residuals, and with fewer than 16 poses.
    """
    joint_value_standard_uncertainty_deg: float | None
    """Given standard uncertainty (deg) of observed values of revolute joints, such as values of second encoders;
    absent without such observations.
    """
    kind: str
    """Residuals of targets or of the pose."""
    max: float
    """Largest absolute residual."""
    position_rms_before_mm: float | None
    """Root mean square of the position residuals before identification (mm): nominal parameters, with only base and
    targets fitted. Absent like `position_rms_mm`.
    """
    position_rms_mm: float | None
    """Root mean square of the position residuals of targets (mm); absent without positions of targets, and for pose
    residuals.
    """
    repeats: Replicates | None
    """Scatter of repeats against the other residuals; absent without repeated poses."""
    rms: float
    """Root mean square (mm). Pose residuals mix mm and rad (thesis, eq. 3.26)."""
    stated_standard_uncertainty_mm: float | None
    """Given standard uncertainty of one coordinate (mm): of the contact if given separately, otherwise of the
    instrument.
    """
    stated_values: int
    """Number of stated values that count like measured values: shapes of rigid parts, and positions and lengths of
    fixed points.
    """
    uncertainties_enlarged_by: float
    """Median ratio of the standard uncertainties to the uncertainties from the instrument alone. Without a given
    uncertainty of the instrument, to the uncertainties from independent residuals.
    """
    uncertainties_from: str
    """Basis of the standard uncertainties."""
    within_poses_rms_mm: float | None
    """Root mean square (mm) of a coordinate's residual from the mean over the targets of its pose, n − 1 for n
    targets. Absent where no pose shows several targets.
    """

class ResidualTrend(Record):
    """F test of a trend in the errors after identification: a parabola in one quantity against a constant. All
    coordinates of the poses' mean errors are tested together.
    """
    against: str
    """Independent quantity: a joint by the name of its column, `reach_mm` (distance from the base) or `order` (of
    the measurement).
    """
    explained_mm: float
    """Root mean square of the errors that the parabola explains (mm)."""
    f: float
    """F statistic."""
    p_value: float
    """Probability of such a trend if the model is right, corrected for the number of tests (Holm 1979)."""

class RobotLinks(Record):
    """Links of a URDF between which the parameters describe a kinematic chain."""
    base: str
    """Link of the base frame."""
    base_moves: bool
    """`true` if joints move the link of the base frame: a hand of a robot with two arms, for example."""
    ends: list[str]
    """Link at the end of the chain, or of each branch."""

class RobustParameter(Record):
    """A parameter in the least-squares fit and in the robust fit."""
    difference: float
    """Robust minus least-squares value."""
    difference_over_u: float
    """Difference over its standard uncertainty if all readings are correct. For normal residuals that is √(1/0.95 −
    1) = 0.23 of the standard uncertainty of the parameter.
    """
    name: str
    """Name of the parameter."""
    unit: str
    """`mm`, `deg` or `1`."""
    value: float
    """Value of the robust fit."""

class RobustPose(Record):
    """Weight of a pose in the robust fit."""
    pose: int | str
    """Pose."""
    residual_over_sigma: float
    """Residual of smallest weight, over σ."""
    weight: float
    """Smallest weight of the pose's residuals, 1 / (1 + (r / c σ)²) (0 to 1)."""

class RobustSummary(Record):
    """Robust fit in addition to the least-squares fit: an M-estimator with Cauchy loss that starts at the least-
    squares optimum.
    """
    constant: float
    """Constant c of the loss c² ln(1 + (r / c σ)²). With c = 2.385 the variance of parameters is 5 % larger than by
    least squares if residuals are normal.
    """
    critical: float
    """Critical value of `difference_over_u`: with a probability of 99 % no parameter exceeds this value if all
    readings are correct.
    """
    critical_residual: float
    """Critical value of a residual over σ: with a probability of 99 % no residual exceeds this value if all readings
    are correct.
    """
    disagreeing: int
    """Number of poses with a residual beyond the critical value."""
    parameters: Records[RobustParameter]
    """Identified parameters in both fits."""
    poses: Records[RobustPose]
    """Poses of smallest weight, ascending."""
    sigma_mm: float
    """Standard deviation σ of a coordinate (mm): from the median residual, but at least the given one."""

class ScaleBarResult(Record):
    """Distance errors of a scale bar."""
    count: int
    """Number of measured distances."""
    largest_error_mm: float
    """Largest error of a single distance."""
    length_mm: float
    """Calibrated length."""
    length_uncertainty_mm: float | None
    """Expanded uncertainty (k = 2) of the calibrated length, from the certificate."""
    mean_error_mm: float
    """Mean of measured minus calibrated length."""
    name: str
    """Name of the bar's position."""
    permissible_error_mm: float
    """Maximum permissible error of the instrument for this distance. By default the largest of the distances exceeds
    it with a probability of 5 %.
    """
    standard_deviation_mm: float
    """Standard deviation of the distances."""
    uncertainty_ratio: float | None
    """Maximum permissible error over the certificate's uncertainty; at least 4 is required."""
    verdict: str
    """Verdict on the instrument."""

class SelftestCheck(Record):
    """Comparison of a value with its reference. Of several values, the one with the largest deviation is listed."""
    deviation: float | None
    """`found` minus `expected`."""
    expected: float | None
    """Reference value; null if the test could not be made."""
    found: float | None
    """Value of this installation; null if it is not finite."""
    pass_: bool
    """`true` if the deviation is permissible."""
    permissible: float
    """Largest permissible absolute deviation."""
    source: str
    """Source of the reference value."""
    test: str
    """Test, in English."""
    test_phrase: Phrase
    """Text of the catalogue that is `test` in English."""
    unit: str
    """Unit of the values; empty for pure numbers."""

class SelftestMustFail(Record):
    """A seeded fault in the reference data, with which the tests of a requirement were repeated."""
    checks: int
    """Number of tests."""
    failed: int
    """Number of tests that failed."""
    id: str
    """Name of the requirement."""
    pass_: bool
    """`true` if at least one test failed, as it must."""
    slip: str
    """Seeded fault, in English."""
    slip_phrase: Phrase
    """Text of the catalogue that is `slip` in English."""

class SelftestPerformance(Record):
    """Comparison of a campaign with its stored `parameters.json`."""
    campaign: str
    """Name of the campaign."""
    cause_phrases: Records[Phrase]
    """Texts of the catalogue that are `causes` in English."""
    causes: list[str]
    """Known differences between the documents that may be the cause, in English."""
    compared: int
    """Number of compared parameters."""
    expected: str
    """Stored document."""
    moved: Records[MovedValue]
    """Values that moved by more than rounding."""
    pass_: bool
    """`true` if nothing moved."""
    relative_tolerance: float
    """Permissible relative difference of a value without uncertainty."""
    tolerance_of_uncertainty: float
    """Permissible difference of a value in its standard uncertainty, and relative difference of a standard
    uncertainty.
    """

class SelftestProgram(Record):
    """Program file."""
    expected_sha256: str | None
    """Given SHA-256 (`--program-sha256`); null if none was given."""
    pass_: bool
    """`true` if the file could be read and has the given hash."""
    sha256: str | None
    """SHA-256 of the program file; null if the file cannot be read."""
    version: str
    """Version of etalon."""

class SelftestRequirement(Record):
    """A requirement with its tests."""
    checks: Records[SelftestCheck]
    """Tests."""
    id: str
    """Name of the requirement: `fits`, `solver`, `frames` ..."""
    pass_: bool
    """`true` if there are tests, and all passed."""
    requirement: str
    """Requirement, in English."""
    requirement_phrase: Phrase
    """Text of the catalogue that is `requirement` in English."""

class SeriesScatter(Record):
    """Scatter between series."""
    series: int
    """Number of series."""
    share: float
    """Share of the variances of the parameters, in the mean."""

class SingularValueEntry(Record):
    """Sensitivity of the residuals to one direction of the parameters; small if the direction is poorly observable."""
    parameters: list[str]
    """Parameters with a component above 0.3 in the right singular vector, the largest first; empty if the direction
    is spread over many parameters.
    """
    value: float
    """Singular value (dimensionless)."""

class Sketch(Record):
    """A drawing with lengths in mm."""
    planar: bool
    """`true` if the drawing lies in the plane z = 0."""
    strokes: Records[Stroke]
    """Lines of the drawing."""
    title: str
    """Title of the drawing."""
    title_id: str | None
    """Id of the title in the catalogue of texts."""

class SolverSummary(Record):
    """Solver and its termination."""
    iterations: int
    """Number of steps."""
    meaning: str
    """Reason of the termination in words."""
    method: str
    """Algorithm."""
    method_phrase: Phrase | None
    """Text of the catalogue that is `method` in English."""
    termination: str
    """Reason of the termination."""

class Source(Record):
    """A file that was read."""
    bytes: int
    """Size of the file."""
    dialect: str
    """Dialect of the file: format, delimiter, decimal mark, unit."""
    dialect_phrase: Phrase | None
    """Text of the catalogue that is `dialect` in English."""
    file: str
    """File, as in the campaign."""
    kind: str
    """`export`, `log`, `campaign` or `robot`."""
    refused: Records[Refused]
    """Rejected rows."""
    rows_read: int
    """Number of data rows."""
    sha256: str
    """SHA-256 of the file, as `sha256sum` prints it."""
    sha256_without_backup: str | None
    """SHA-256 of the campaign without its line `controller_backup`; absent without this line. Results refer to this
    hash, because the way back does not change them.
    """
    standstills: Records[StandingInterval]
    """Standstills of a log that was recorded during motion; each yields one row of joint values."""

class Spread(Record):
    """Median of the draws and the interval that contains 95 % of them."""
    high: float
    """97.5th percentile."""
    low: float
    """2.5th percentile."""
    median: float
    """Median."""

class StandingInterval(Record):
    """A standstill in a log, by the limits of the campaign."""
    from_s: float
    """Time of the first sample, by the log's clock."""
    joints: Records[StandingJoint]
    """Joints during the standstill."""
    line: int
    """Line of the first sample, from 1."""
    samples: int
    """Number of samples."""
    to_s: float
    """Time of the last sample."""

class StandingJoint(Record):
    """A joint during a standstill, in the unit of its column."""
    column: str
    """Column in the table of joint values."""
    mean: float
    """Mean of the samples, which is used as the joint value."""
    range: float
    """Largest minus smallest sample."""
    standard_deviation: float
    """Standard deviation of the samples."""

class Statistics(Record):
    """Statistics of errors by size."""
    max: float
    """Largest size."""
    mean: float
    """Mean size."""
    p95: float
    """95th percentile."""
    rms: float
    """Root mean square."""

class Stroke(Record):
    """A polyline of a drawing."""
    kind: str
    """Meaning of the line."""
    name: str
    """Name of a parameter, joint or frame; empty if unnamed."""
    points_mm: NDArray[np.float64]
    """At least two points (mm)."""

class StudiedDesign(Record):
    """A set of poses measured with one noise."""
    after: Records[DesignError]
    """Errors with the identified parameters."""
    before: Records[DesignError]
    """Errors with nominal parameters."""
    configurations: int
    """Number of measured configurations."""
    name: str
    """Name of the set."""
    noise_um: float
    """Standard deviation of the Gaussian noise of one coordinate."""
    parameters: Records[DesignParameter]
    """Parameters."""

class StudiedParameter(Record):
    """One parameter of a simulated calibration."""
    actual: float
    """True value."""
    identified: float
    """Mean of the identified values."""
    name: str
    """Name as in the thesis."""
    nominal: float
    """Nominal value."""
    unit: str
    """`mm`, `deg` or `1`."""

class StudiedPlace(Record):
    """Position errors at one place."""
    at_mm: NDArray[np.float64]
    """Nominal position of the first target."""
    max_before_mm: float
    """Largest nominal error over all configurations and targets of the pose."""
    max_mm: float
    """Largest error with the identified parameters."""
    pose: int | str
    """Name of the pose."""

class StudyDocument(Record):
    """Simulated calibration (thesis, tables 4.1 to 4.3, figs. 4.8 and 4.9)."""
    configurations: int
    """Number of configurations at which errors are evaluated."""
    draws: int
    """Number of such means. The median of their errors is reported; `parameters` and `places` are from the first."""
    noise_um: float
    """Standard deviation of the Gaussian noise of one coordinate."""
    parameters: Records[StudiedParameter]
    """Nominal, true and identified parameters with all positions (thesis, table 4.1, fig. 4.8)."""
    places: Records[StudiedPlace]
    """Largest error of each pose with all positions measured (thesis, fig. 4.9)."""
    point: str
    """Point whose position errors are evaluated, in words."""
    point_phrase: Phrase | None
    """Text of the catalogue that is `point` in English."""
    runs: int
    """Number of identifications whose mean is evaluated."""
    steps: Records[StudyStep]
    """Position errors by the number of measured positions; the last entry is the plan (thesis, tables 4.2 and 4.3)."""

class StudyStep(Record):
    """Position errors after a simulated calibration."""
    configurations: int
    """Number of configurations of these positions."""
    max_before_mm: float
    """Largest error with nominal parameters."""
    max_mm: float
    """Largest error with the identified parameters, median of the draws."""
    positions: int
    """Number of positions measured."""
    rms_before_mm: float
    """Root mean square with nominal parameters."""
    rms_mm: float
    """Root mean square with the identified parameters, median of the draws."""

class SumOfSquares(Record):
    """Weighted sum of squared residuals."""
    degrees_of_freedom: int
    """Degrees of freedom."""
    p_value: float
    """Probability of a larger sum if nothing has changed."""
    value: float
    """Sum."""

class ToolAccuracy(Record):
    """Error of the controller at the tool point: true position in the base frame minus the position predicted by the
    parameters.
    """
    after: Statistics
    """Expected error with the identified parameters (mm, k = 1)."""
    before: Statistics
    """Position predicted with the parameters before calibration minus position predicted with the identified
    parameters (mm).
    """
    definition: str
    """Definition of "before" and "after" in this object, in words."""
    definition_phrase: Phrase | None
    """Text of the catalogue that is `definition` in English."""
    expanded_max_mm: float
    """Largest expected error with the identified parameters (mm, k = 2)."""
    frame: str
    """Part to which the point is attached."""
    held_mm: float
    """Contribution of the tolerances of parameters that are held because the data do not determine them, root mean
    square (mm).
    """
    model_mm: float
    """Contribution of effects outside the model: measured errors beyond the instrument's uncertainty, root mean
    square (mm).
    """
    parameters_mm: float
    """Contribution of the parameters' covariance, root mean square (mm)."""
    place_mm: float
    """Contribution of the uncertainty of the point's position on the tool (mm)."""
    point_mm: NDArray[np.float64]
    """Position of the point in `frame`."""
    poses: int
    """Number of poses."""
    set: str
    """Set of poses: `validation`, or `calibration` in a campaign without validation poses."""

class Uncontrolled(Record):
    """An error that no reading can show."""
    keys: list[str]
    """Keys of measurements that can show the error."""
    points: list[str]
    """Labels, features or targets with the error; empty if it concerns all readings."""
    what: str
    """Description of the error."""
    what_phrase: Phrase | None
    """Text of the catalogue that is `what` in English."""

class Unmatched(Record):
    """A row without a partner in the join, or with more than one; or a point that nothing uses."""
    file: str
    """File, as in the campaign."""
    key: str
    """Join key of the row in words: pose and cycle, row, or time; the label of a point."""
    line: int
    """Line in the file, from 1."""
    reason: str
    """Reason: the table without a partner, the number of partners, or that nothing uses the point."""
    reason_phrase: Phrase | None
    """Text of the catalogue that is `reason` in English."""

class UnreachablePose(Record):
    """A pose without solution."""
    pose: int | str
    """Name of the pose."""
    reason: str
    """Limit that forbids the pose, or that the pose is out of reach."""
    reason_phrase: Phrase | None
    """Text of the catalogue that is `reason` in English."""

class UnreachableTarget(Record):
    """A target that cannot be commanded."""
    reason: str
    """Limit that forbids the target, or that the target is out of reach."""
    reason_phrase: Phrase | None
    """Text of the catalogue that is `reason` in English."""
    target: str
    """Name of the target."""

class UntestedMistake(Record):
    """Mistake of the set-up that the measurements do not show: a robot within its tolerances explains them with this
    change too.
    """
    change: str
    """Change of the set-up, in English."""
    change_phrase: Phrase | None
    """Text of the catalogue that is `change` in English."""
    changed_mm: float
    """Standard deviation of a residual with the change (mm)."""
    flange_deg: float
    """Largest change of the orientation of the flange at these poses (deg)."""
    flange_mm: float
    """Largest change of the position of the flange at poses around the measured ones (mm)."""
    stated_mm: float
    """Standard deviation of a residual with the set-up as given (mm)."""

class ValidationDistance(Record):
    """Distances from the validation poses to their nearest calibration poses, relative to the spacing of the
    calibration poses (median distance to the nearest neighbour). A distance is the root of the sum of squared
    differences of joint values, each divided by the range of the joint in the calibration.
    """
    largest: float
    """Largest relative distance."""
    median: float
    """Median; about 1 if both sets cover the same region equally."""
    outside: int
    """Number of validation poses with a joint outside its range in the calibration."""
    poses: int
    """Number of validation poses; repeated joint values count once."""

class VerificationStep(Record):
    """A chosen pose."""
    least: Records[LeastDetectable]
    """Smallest changes that this pose and the poses before it detect together."""
    pose: int | str
    """Pose."""

class VerifiedQuantity(Record):
    """Residuals of the observations of one quantity."""
    count: int
    """Number of residuals."""
    expected_rms: float
    """Expected root mean square if nothing has changed, by the uncertainty of the observed values and the model
    error of the calibration.
    """
    quantity: str
    """`position`, `orientation`, `distance`, `surface`, `contact` or `coordinate`."""
    rms: float
    """Root mean square of the residuals."""
    unit: str
    """Unit of the residuals: `mm` or `deg`."""

class WorkspaceUncertainty(Record):
    """Uncertainty of position over the candidates."""
    max_mm: float
    """Largest."""
    rms_mm: float
    """Root mean square."""

class WorldFrame(Record):
    """The world frame in the coordinates of the exports."""
    common_covariance: NDArray[np.float64] | None
    """Covariance common to all poses if the frame is measured again at each pose: the covariance of the mean
    positions of the targets, which define the frame.
    """
    definition: str
    """Definition of the frame, in words."""
    definition_phrase: Phrase | None
    """Text of the catalogue that is `definition` in English."""
    max_mm: float | None
    """Largest distance of a target from its best-fit position."""
    planar: bool
    """`true` if z is dropped: observations are projected onto the xy plane of the world."""
    poses: Records[FramePose]
    """One entry for all poses (without `pose` and `cycle`), or one entry per pose and cycle."""
    reference_mm: NDArray[np.float64]
    """Best-fit positions of the targets in the world, in the order of the definition."""
    rms_mm: float | None
    """Root mean square distance of the targets from their best-fit positions; absent for 3-2-1 frames, and for
    targets that were measured once.
    """

class WrittenController(Record):
    """One controller file."""
    errors: ControllerErrors | None
    """Errors at validation poses, or at calibration poses in a campaign without validation; null if they were not
    measured.
    """
    format: str
    """Name of the format."""
    left_out: list[str]
    """Identified parameters that the format cannot contain."""
    messages: Records[Message]
    """Warnings about this file."""

class WrittenFile(Record):
    """Controller file that a run wrote."""
    check: LoadingCheck | None
    """Pose on the display of the controller, before and after loading; absent in output folders of earlier versions,
    and for robots without kinematics of a whole pose.
    """
    file: str
    """Name of the file in the output folder."""
    format: str
    """Name of the format."""
    inputs: Records[FileInput]
    """Inputs in addition to joint values, on which effects in the file depend; empty if joint values determine them."""
    is_for_controllers: bool
    """`false` for a file that programs of a laboratory read, and no controller loads."""
    omitted_effects: list[str]
    """Effects that the format cannot contain; absent in output folders of earlier versions."""
    sha256: str | None
    """SHA-256 of the file; absent in output folders of earlier versions."""

class WrittenParameter(Record):
    """A parameter as written to a file."""
    name: str
    """Name of the parameter."""
    standard_uncertainty: float | None
    """Standard uncertainty (k = 1); absent if the value was not identified, or if the format changes it."""
    unit: str
    """`mm`, `deg` or `1`."""
    value: float
    """Value."""

class ZeroAxis(Record):
    """Axis in the base at joint values zero."""
    direction: NDArray[np.float64]
    """Unit direction of positive motion."""
    direction_standard_uncertainty_deg: float
    """Standard uncertainty of the direction: root of the sum of squares of its components."""
    joint: str
    """Name of the joint."""
    point_mm: NDArray[np.float64] | None
    """Point of the axis nearest to the origin of the base; absent for a prismatic joint."""
    point_standard_uncertainty_mm: float | None
    """Standard uncertainty of the point: root of the sum of squares of its components."""

class AccuracyDocument(Document):
    """Errors before and after calibration, separately for calibration and validation poses."""
    budget: Records[FigureBudget]
    """Standard uncertainties of the limited errors after calibration: of the validation poses, or of the calibration
    poses in a campaign without validation. The parameters are under test and contribute nothing. Empty if no
    uncertainty is given.
    """
    campaign: CampaignReference | None
    """Campaign whose data judge given parameters; absent in the output folder of a run."""
    definition: str
    """Definition of "before" and of "error" in this document, in words."""
    definition_phrase: Phrase | None
    """Text of the catalogue that is `definition` in English."""
    effects: Records[EffectProof]
    """Effects of the robot that are proved by poses excluded from the identification: effects chosen by `effects =
    "proven"`, and effects that are not identified.
    """
    field: FieldSummary | None
    """Search for a residual field; absent if the campaign asks for none."""
    given: GivenSummary | None
    """Origin and judgement of parameters that were given instead of being identified from these data."""
    joints: list[str]
    """Joints of the robot, named as columns: `q1_deg`."""
    left_out: LeftOutErrors | None
    """Errors at calibration poses that are excluded from the identification, with nominal and with identified
    parameters; absent with fewer than three poses, or without measured positions.
    """
    limits: Records[LimitVerdict]
    """Limits that the campaign contains, with their verdicts."""
    map: PredictionMap | None
    """Expected error at the tool point over the workspace. Absent without `tool`, without inverse kinematics, or if
    the robot reaches too few places between the poses.
    """
    orientation_budget: OrientationBudget | None
    """Standard uncertainty of an orientation error, by source; absent if no orientation was measured or its
    uncertainty is unknown.
    """
    parameter_influences: Records[ParameterInfluence]
    """Effects of the identified parameters of the robot at the measured points, the largest change first."""
    placed_apart: Records[PlacedApart]
    """Targets and fixtures that no calibration pose shows. They are placed by their own readings at validation
    poses, with all identified parameters held.
    """
    point: str
    """Point whose errors are in `sets`, in words."""
    point_phrase: Phrase | None
    """Text of the catalogue that is `point` in English."""
    provenance: Provenance | None
    """Origin of the numbers of given parameters; absent in the output folder of a run."""
    relative: RelativeAccuracy | None
    """Errors of the distances between poses, independent of the base. Absent without two poses of one target."""
    schema: str
    """Schema and version: `etalon/accuracy/1`."""
    sets: Records[AccuracySet]
    """One entry per set of poses: `calibration`, `validation`."""
    tool: ToolAccuracy | None
    """Expected error at the tool point; absent without a tool point or a covariance."""
    trends: Records[ResidualTrend]
    """Dependence of the mean errors of the calibration poses after identification on joints, reach and time; empty
    with fewer than ten poses.
    """
    validation_distance: ValidationDistance | None
    """Distances of the validation poses from the calibration poses. The errors apply within the region that these
    poses cover.
    """

class AxesDocument(Document):
    """Axes of joints from sweeps of one joint at a time (circle-point analysis)."""
    axes: Records[AxisEntry]
    """One axis for each joint, in the order of the joints."""
    checks: Records[AxesCheck]
    """Readings that belong to no sweep, compared with the robot."""
    joint_values: bool
    """`true` if joint values are known; otherwise joint values zero are the start of the sweeps."""
    messages: Records[Message]
    """Warnings."""
    provenance: Provenance
    """Version and inputs."""
    robot: AxesRobot | None
    """Robot that follows from the axes; absent if joints have no sweep, or if a message of severity error says that
    it must not be used.
    """
    schema: str
    """Schema and version: `etalon/axes/1`."""

class AxisDocument(Document):
    """Positioning of a linear axis (ISO 230-2:2014)."""
    axis: AxisPositioning
    """Positioning of the axis."""
    messages: Records[Message]
    """Warnings."""
    positions: Records[AxisPosition]
    """Positions of the axis, ascending."""
    schema: str
    """Schema and version: `etalon/iso230/1`."""

class BatchDocument(Document):
    """Outcome of the campaigns of a batch."""
    campaigns: Records[BatchEntry]
    """One entry per campaign, in the order of the command line."""
    done: int
    """Number of campaigns that meet all limits or have none."""
    failed: int
    """Number of campaigns that did not run."""
    not_met: int
    """Number of campaigns that fail a limit, or whose result is implausible."""
    schema: str
    """Schema and version: `etalon/batch/1`."""
    skipped: int
    """Number of campaigns that were skipped because an environment variable for their data is unset."""

class BenchmarkScoreDocument(Document):
    """Score of predicted measurements against measured values."""
    orientation: QuantityScore | None
    """Score of the orientations; absent if no orientation is measured and predicted."""
    poses: int
    """Number of poses."""
    position: QuantityScore
    """Score of the positions."""
    provenance: Provenance
    """Origin of the numbers."""
    rows: int
    """Number of measured rows."""
    schema: str
    """Schema and version: `etalon/benchmark-score/1`."""

class CampaignSummary(Document):
    """Administrative data of the campaign, for the head of a report."""
    conditions: Conditions
    """Conditions of a test."""
    contact: ContactSummary | None
    """Repeatability of the robot in returning to a measured point, if given."""
    controller_files: Records[WrittenFile]
    """Controller files that the run wrote."""
    coverage_factor: float | None
    """Coverage factor of `expanded_uncertainty_um`."""
    date: str | None
    """Date as given."""
    decision_rule: str | None
    """Decision rule for limits, as given."""
    expanded_position_uncertainty_um: float | None
    """Expanded uncertainty of a position, if given."""
    expanded_uncertainty_um: float | None
    """Expanded uncertainty of one coordinate."""
    instrument: str | None
    """Measuring instrument."""
    issue: Issue
    """Identification of the report."""
    limits_specification: str | None
    """Specification, drawing or agreement that the limits come from, as given."""
    name: str
    """Name of the campaign."""
    notes: str | None
    """Remarks."""
    operator: str | None
    """Operator as given."""
    report: Presentation
    """Presentation of the report."""
    robot: str | None
    """Name of the robot, if its file contains one."""
    synthetic: str | None
    """Explanation of synthetic data; absent for measured data."""
    temperature_c: float | None
    """Temperature during the campaign."""
    temperature_range_c: NDArray[np.float64] | None
    """Lowest and highest temperature (°C) that rows of the exports contain."""
    valid_until: str | None
    """Last day on which the calibration is valid, as given: year-month-day."""

class CellDocument(Document):
    """Frames and points of a robot cell from controller poses and measurements."""
    axis: CellAxisEntry | None
    """Identified external axis."""
    frames: Records[CellFrameEntry]
    """Identified frames; the first one is the answer."""
    messages: Records[Message]
    """Warnings, and errors for which the answer must not be loaded."""
    noise: Records[CellNoise]
    """Standard deviations of the residuals: positions, then orientations."""
    points: Records[CellPointEntry]
    """Identified points; without frames the first one is the answer."""
    provenance: Provenance
    """Version and inputs."""
    readings: int
    """Number of readings."""
    residuals: Records[CellResidualEntry]
    """Residuals in the order of the rows."""
    schema: str
    """Schema and version: `etalon/cell/1`."""
    solve: str
    """Problem that is solved: `tool-point`, `tool-reflector`, `tool-axes`, `hand-eye`, `object`, `three-points`,
    `linear-axis` or `rotary-axis`.
    """

class CheckDocument(Document):
    """Findings of `etalon check`. The exit code is 2 if there are errors, otherwise 0."""
    campaign: str
    """The campaign as the user named it."""
    errors: Records[Finding]
    """Errors that prevent the campaign from running."""
    joints: Records[JointTravel]
    """Travel of the joints in the calibration poses; empty if the poses are unknown."""
    not_controlled: Records[Uncontrolled]
    """Errors that no reading of the campaign can show."""
    schema: str
    """Schema and version: `etalon/check/1`."""
    sources: Records[Source]
    """Files read, and rows rejected by a rule; empty if reading found errors."""
    warnings: Records[Finding]
    """Warnings of a report."""

class CompareDocument(Document):
    """Comparison of several campaigns of one robot, in the order of the command line."""
    between_series: Records[CompareBetween]
    """Between-series components for each pair of campaigns with a misfit in at least one."""
    campaigns: Records[ComparedCampaign]
    """Compared campaigns."""
    convention_phrases: Records[Phrase]
    """Texts of the catalogue that are `conventions` in English."""
    conventions: list[str]
    """Rules for judging changes, and their limitations, in words."""
    messages: Records[Message]
    """Remarks and warnings."""
    provenance: Provenance
    """Version, and the compared documents."""
    robot: str | None
    """Model of the robot; null if no campaign identifies parameters."""
    schema: str
    """Schema and version: `etalon/compare/1`."""
    together: Records[CompareTogether]
    """Joint test of all robot parameters for each pair of campaigns."""
    trends: Records[CompareTrend]
    """Every quantity over the campaigns."""

class CompensationDocument(Document):
    """Commands with which the identified robot reaches its targets although its controller computes with nominal
    geometry.
    """
    joint_targets: int
    """Number of targets of a program that are joint values; they are left unchanged."""
    joints: list[str]
    """Column names of the joints with their units, and of the assembly mode if there are several."""
    robot: str
    """Model of the robot."""
    schema: str
    """Schema and version: `etalon/compensation/1`."""
    targets: Records[CompensatedTarget]
    """One entry for each reachable target."""
    unreachable: Records[UnreachableTarget]
    """Targets that are out of reach or beyond a limit."""

class ControllersDocument(Document):
    """Controller files of formats that leave identified parameters out."""
    files: Records[ControllerFiles]
    """One entry for each distinct set of written values."""
    messages: Records[Message]
    """Files that were not written or are not clearly better than nominal, and parameters that could not be
    identified again.
    """
    schema: str
    """Schema and version: `etalon/controllers/1`."""

class ExplanationDocument(Document):
    """Answer of `etalon explain`: explanations of messages."""
    messages: Records[Explanation]
    """Requested message, or all messages."""
    schema: str
    """Schema and version: `etalon/explanation/1`."""

class FeaturesDocument(Document):
    """Fitted elements."""
    features: Records[Feature]
    """One entry per feature of the campaign."""
    messages: Records[Message]
    """Warnings of the fits."""
    schema: str
    """Schema and version: `etalon/features/1`."""

class FieldDocument(Document):
    """Errors of joints that the parameters do not describe, as functions of the joint values. The robot is at the
    position of its model with the parameters in `parameters` and the joint values q + δq(q).
    """
    components: Records[FieldComponent]
    """Components; the errors of a joint add up."""
    covariance: NDArray[np.float64]
    """Covariance of the parameters in `covariance_of`, followed by the weights of the components, in their units."""
    covariance_of: list[str]
    """Names of the parameters in `covariance`."""
    factor: float
    """Factor of standard uncertainties from `covariance`, with which they agree with the errors at held-out poses;
    beyond the poses at least 1.
    """
    joints: list[str]
    """Joints of the robot, named as columns: `q1_deg`."""
    noise_mm: float
    """Standard deviation of a measured coordinate without the field's error (mm)."""
    parameters: Records[FieldParameter]
    """Parameters that belong to the field: the parameters of `parameters.json`, estimated again with the field.
    Beyond the measured poses they fade to the values of `parameters.json`, as δq fades to 0.
    """
    parameters_sha256: str
    """SHA-256 of the `parameters.json` to which the field belongs."""
    provenance: Provenance
    """Origin of the numbers."""
    robot: str
    """Model of the robot."""
    schema: str
    """Schema and version: `etalon/field/1`."""
    synthetic: str | None
    """Explanation of synthetic data, as the campaign gives it; absent for measured data."""

class FitDocument(Document):
    """One fitted element."""
    apex_angle_deg: float | None
    """Full angle of a cone."""
    apex_mm: NDArray[np.float64] | None
    """Apex of a cone."""
    axis: NDArray[np.float64] | None
    """Unit axis of a line, cylinder or cone. The axis of a cone points towards increasing radius."""
    center_mm: NDArray[np.float64] | None
    """Centre of a circle, sphere or torus."""
    contacts: FitContacts | None
    """Contact points of a minimum zone."""
    coverage_deg: float | None
    """Arc of the circumference that is covered by points."""
    element: str
    """Name of the element."""
    flatness: FitFlatness | None
    """For a minimum-zone circle in space: flatness of the plane in which roundness is measured."""
    form_mm: float
    """Form deviation, peak to valley; for a line in space, or a circle by orthogonal distances, the diameter of the
    enclosing tube.
    """
    label: str | None
    """Label of the points, if each label is fitted separately."""
    max_mm: float
    """Largest of these distances."""
    messages: Records[Message]
    """Warnings with hints."""
    minor_radius_mm: float | None
    """Radius of the tube of a torus."""
    normal: NDArray[np.float64] | None
    """Unit normal of a plane, circle or torus."""
    point_mm: NDArray[np.float64] | None
    """Point of a line, plane, cylinder or cone: foot of the perpendicular from the centroid."""
    points: int
    """Number of points."""
    probe: FitProbe | None
    """Probe and fit before compensation, if the points are probe centres."""
    radius_mm: float | None
    """Radius. For a cone the radius at `point_mm`, for a torus the radius of the centre line."""
    rms_mm: float
    """Root mean square of the orthogonal distances; for a circle in space by projection, of the distances within its
    plane.
    """
    schema: str
    """Schema and version: `etalon/fit/1`."""
    set_aside: list[int] | None
    """Numbers of the points that a robust fit excludes, from 1; absent without `--robust`."""
    solver: FitSolver
    """Solver and its termination."""
    standard_uncertainty: FitUncertainty | None
    """Standard uncertainties from the residuals or from the stated uncertainty of the points; absent without
    redundancy.
    """
    stated: FitStated | None
    """Values that the file contains for the feature."""

class FormatsDocument(Document):
    """Proposals of `etalon formats` for reading a file."""
    columns: Records[FormatsColumn]
    """Proposed contents of each column of the first reading, with reasons."""
    doubt_phrases: Records[Phrase]
    """Texts of the catalogue that are `doubts` in English."""
    doubts: list[str]
    """Doubts about the first proposal."""
    file: str
    """The file as the user named it."""
    format: str | None
    """Name of the format, if the file contains one. Such a file needs no proposal."""
    join: FormatsJoin | None
    """Join with a log, if several files were named."""
    kind: str
    """Proposed use of the file: `export`, `export with joints`, `log`, `observations`, `poses`, `commanded`,
    `recording` ...
    """
    question_phrases: Records[Phrase]
    """Texts of the catalogue that are `questions` in English."""
    questions: list[str]
    """Facts that the file cannot give and the campaign must."""
    readings: Records[Reading]
    """Readings that explain the file, the proposed one first."""
    reason_phrases: Records[Phrase]
    """Texts of the catalogue that are `reasons` in English."""
    reasons: list[str]
    """Reasons for the first proposal."""
    rows: int
    """Number of examined data rows."""
    schema: str
    """Schema and version: `etalon/formats/1`."""
    toml: str
    """Proposal as lines for campaign.toml, with reasons, doubts and questions as comments."""

class FramesDocument(Document):
    """Frames made from features and targets."""
    not_controlled: Records[Uncontrolled]
    """Errors that no reading of the campaign can show, with the keys of measurements that can show them."""
    schema: str
    """Schema and version: `etalon/frames/1`."""
    world: WorldFrame
    """World frame. If the frame is measured again at each pose, `export_T_world` is given for every pose."""

class GeometricDocument(Document):
    """Geometric calibration (thesis, chapter 2)."""
    balls: Records[BallResult]
    """Single balls, measured repeatedly."""
    covariance: NDArray[np.float64]
    """Covariance of the values of all quantities, in their order and units."""
    definition: str
    """Assignment of the measured features to geometric quantities, in words."""
    definition_phrase: Phrase | None
    """Text of the catalogue that is `definition` in English."""
    leads: Records[LeadResult]
    """Leads of the screws."""
    messages: Records[Message]
    """Remarks and warnings for the reader."""
    methods: Records[MethodErrors]
    """Largest mean errors over all tables, by method."""
    quantities: Records[GeometricQuantity]
    """One entry per quantity, with the identified value of the same parameter."""
    scale_bars: Records[ScaleBarResult]
    """Scale bars."""
    schema: str
    """Schema and version: `etalon/geometric/1`."""
    steps: Records[GeometricStep]
    """Residuals of all fits."""
    tables: Records[PoseTable]
    """Mean errors by pose."""
    workspace: Records[Region]
    """Regions of the workspace, with the geometric parameters."""

class ImportDocument(Document):
    """Rows that were read, and rows that were rejected with the reasons."""
    campaign: str
    """Name of the campaign."""
    messages: Records[Message]
    """Findings of the blunder rules, and other messages."""
    schema: str
    """Schema and version: `etalon/import/1`."""
    sources: Records[Source]
    """All files read."""
    unmatched: Records[Unmatched]
    """Rows without a partner in the join of points and logs, or with more than one, and points that no target,
    feature or frame uses.
    """

class Iso9283ComplianceDocument(Document):
    """Static compliance (10)."""
    convention_phrases: Records[Phrase]
    """Texts of the catalogue that are `conventions` in English."""
    conventions: list[str]
    """Method, and the statement that the clause is not verified against the standard."""
    directions: Records[Iso9283Compliance]
    """One per direction, in the order of the table."""
    messages: Records[Message]
    """Remarks and warnings."""
    schema: str
    """Schema and version: `etalon/iso9283-compliance/1`."""

class Iso9283Document(Document):
    """Characteristics of ISO 9283:1998 of one test."""
    approach_phrases: Record
    """Texts of the catalogue that are names of approaches in English; names that a table contains are absent."""
    approaches: Records[Iso9283Variation]
    """One entry per pose that was approached in at least two ways."""
    convention_phrases: Records[Phrase]
    """Texts of the catalogue that are `conventions` in English."""
    conventions: list[str]
    """Meaning of angles, evaluated cycles, and clauses that are not verified against the standard, in words."""
    coplanarity_mm: float | None
    """Peak to valley of the mean positions about their plane, with z and at least four poses."""
    coplanarity_of_four: Records[Iso9283OutOfPlane]
    """Distances of the mean positions of four poses, each from the plane of the other three, if a campaign names
    four poses.
    """
    distances: Records[Iso9283Distance]
    """One entry per pair of poses that were visited in the same cycles."""
    drifts: Records[Iso9283Drift]
    """Drift of each pose, if sets are given."""
    exchangeability_mm: float | None
    """Largest distance between the barycentres of two robots at any pose, with several robots."""
    frame: str | None
    """Frame of the positions, in words; absent in documents of earlier programs."""
    frame_phrase: Phrase | None
    """Text of the catalogue that is `frame` in English."""
    homing: Iso9283Pose | None
    """Homings as visits of one pose with number 0, if a campaign has homings."""
    limits: Records[LimitVerdict]
    """Limits that the campaign contains."""
    messages: Records[Message]
    """Remarks and warnings."""
    poses: Records[Iso9283Pose]
    """One entry per pose, in the order of the commanded poses."""
    reference: Records[Iso9283Epoch]
    """Measurements of the reference targets for drift compensation, if any."""
    schema: str
    """Schema and version: `etalon/iso9283/1`."""
    visits: Records[Iso9283Visit]
    """All visits of a campaign; visits of one pose are in the order of recording."""

class Iso9283PlanDocument(Document):
    """Layout of a test to ISO 9283:1998 in a workspace."""
    convention_phrases: Records[Phrase]
    """Texts of the catalogue that are `conventions` in English."""
    conventions: list[str]
    """Choices made, and clauses that are not verified against the standard, in words."""
    corners_mm: NDArray[np.float64]
    """Corners C1 to C8; for planar robots, C1 to C4."""
    loads_percent: list[int]
    """Loads (% of the rated load); the first is mandatory."""
    places: Records[Iso9283Places]
    """Named lists of places to visit in order: `poses` (P1 to P5), `linear`, `circle-large`, ..."""
    programme: Records[Iso9283Item]
    """Test programme: one line for each characteristic."""
    schema: str
    """Schema and version: `etalon/iso9283-plan/1`."""
    side_mm: float
    """Side of the cube; for planar robots, of the square."""
    test_plane: str
    """Corners of the test plane."""
    unreached: Records[Iso9283Unreached]
    """Places that the given robot does not reach."""

class Iso9283StreamDocument(Document):
    """Characteristics of ISO 9283:1998 of a recorded motion."""
    arrivals: Records[Iso9283Arrival]
    """First arrivals at each pose, for the chart of stabilisation; empty without a limit band."""
    convention_phrases: Records[Phrase]
    """Texts of the catalogue that are `conventions` in English."""
    conventions: list[str]
    """Thresholds, origin of times, and clauses that are not verified against the standard, in words."""
    duration_s: float
    """Time from the first to the last sample."""
    left_out: list[int]
    """Lines of samples that are omitted because no robot moves there from the previous sample in time."""
    messages: Records[Message]
    """Remarks and warnings."""
    path: Iso9283Path | None
    """Characteristics of the commanded path, if a path without weaving is given."""
    posing: Records[Iso9283Posing]
    """Moves between poses; empty without a limit band."""
    samples: int
    """Number of evaluated samples."""
    schema: str
    """Schema and version: `etalon/iso9283-stream/1`."""
    settling: Records[Iso9283Settling]
    """Arrivals by pose; empty without a limit band."""
    standstills: Records[Iso9283Standstill]
    """All standstills in the order of time."""
    weaving: Iso9283Weaving | None
    """Characteristics of the weave, if given."""

class Iso9283StreamsDocument(Document):
    """Recorded motions of a campaign."""
    schema: str
    """Schema and version: `etalon/iso9283-streams/1`."""
    streams: Records[Iso9283NamedStream]
    """One per `[[stream]]`."""

class KinematicsDocument(Document):
    """Poses with their joint values."""
    joints: list[str]
    """Column names of the joints with their units, and of the assembly mode if there are several."""
    poses: Records[KinematicsEntry]
    """One entry for each row of the table, or for each solution."""
    robot: str
    """Model of the robot."""
    schema: str
    """Schema and version: `etalon/kinematics/1`."""
    unreachable: Records[UnreachablePose]
    """Poses that the robot cannot reach."""

class ManifestDocument(Document):
    """Files of an output folder, all of one run."""
    files: Record
    """SHA-256 of every file, by file name."""
    schema: str
    """Schema and version: `etalon/manifest/1`."""
    version: str
    """Version of etalon."""

class ParametersDocument(Document):
    """Identified parameters with the evidence for them."""
    budget: Records[BudgetSource]
    """Contributions of each source to the standard uncertainties of these parameters (GUM 5.1.2)."""
    covariance: NDArray[np.float64]
    """Covariance of the identified parameters, in their order and units; empty if unknown."""
    covariance_without: list[str]
    """Identified parameters of points (targets, sockets, planes) that `covariance` omits because there are 24 points
    or more. Each has its standard uncertainty.
    """
    known: Records[KnownValue]
    """Known lengths and positions of fixed points and rigid parts, with their residuals. Absent in documents of
    earlier versions.
    """
    links: RobotLinks | None
    """Links at base and ends of the kinematic chain; absent for a robot without a URDF, and in documents of earlier
    versions.
    """
    messages: Records[Message]
    """Messages for the reader: held parameters with the reasons, warnings with remedies."""
    observability: ObservabilitySummary | None
    """Observability; absent if not finite."""
    parameters: Records[ParameterEntry]
    """All parameters of the model."""
    provenance: Provenance
    """Origin of the numbers."""
    reference_poses: Records[ReferencePose]
    """Positions of the flange by the nominal geometry, which are compared with a robot file that is given together
    with these parameters; absent in documents of earlier versions.
    """
    reference_temperature_c: float | None
    """Temperature (°C) to which lengths and zeros refer; absent if the model has no effects of the temperature."""
    reliability: ReliabilitySummary | None
    """Reliability of readings, and influence of poses. Absent if readings have covariances of their own or common
    errors, if readings are poses instead of positions, or if there are many unknown points.
    """
    residuals: ResidualSummary
    """Goodness of fit."""
    robot: str
    """Model of the robot."""
    robust: RobustSummary | None
    """Robust fit in addition to the least-squares fit. Absent if readings have common errors, if readings are poses
    instead of positions, if there are many unknown points, or without redundancy.
    """
    schema: str
    """Schema and version: `etalon/parameters/2`."""
    sketches: Records[Sketch]
    """Drawings of the model with its parameters; absent if the model provides none."""
    solver: SolverSummary
    """Solver and its termination."""
    synthetic: str | None
    """Explanation of synthetic data, as the campaign gives it; absent for measured data."""
    untested: Records[UntestedMistake]
    """Mistakes of the set-up that the measurements do not show."""
    valid_until: str | None
    """Last day on which the parameters are valid, as the campaign gives it: year-month-day."""

class PlanDocument(Document):
    """Poses to measure, and quality of the choice."""
    at_most_below_percent: float | None
    """Largest possible shortfall of the choice from the optimum (%)."""
    at_most_below_percent_by_relaxation: float | None
    """Largest possible shortfall from the optimum by the continuous relaxation alone (%)."""
    bound: float | None
    """Upper bound of the index for any choice of as many candidates; absent for O4, which has no bound."""
    candidates: int
    """Number of candidates."""
    chosen: Records[PlannedPose]
    """Poses to measure."""
    compared: ComparedPoses | None
    """Poses for comparison, if given."""
    configurations: int
    """Number of configurations of all candidates."""
    definition: str
    """Definition of the index, with the scaling of the Jacobian; larger is better."""
    definition_phrase: Phrase | None
    """Text of the catalogue that is `definition` in English."""
    generated: GeneratedCandidates | None
    """Limits within which the candidates were drawn, if they were generated."""
    greedy: GreedySummary
    """Greedy choice of the thesis: candidates are added one after the other."""
    grouped: bool
    """`true` if the configurations of a pose are chosen together, `false` if one by one."""
    index: str
    """`O1` to `O5`, `D`, `A`, `E` or `I`."""
    messages: Records[Message]
    """Parameters that are not separately identifiable, and other messages."""
    nodes: int
    """Number of nodes examined by branch and bound."""
    observability: ObservabilitySummary | None
    """Observability of the chosen poses; absent if not finite."""
    order: MeasuringOrder | None
    """Order of `chosen` that shortens the motion of the joints."""
    parameters: Records[PlannedParameter]
    """Parameters, with their predicted uncertainties from the chosen poses."""
    places: Records[CandidatePlace]
    """Positions of the candidates (thesis, fig. 4.7)."""
    program: PlannedProgram | None
    """Measuring program, if one is written. `chosen` contains the joint values that it commands."""
    proven_optimal: bool
    """`true` if the choice is proved to be optimal."""
    provenance: Provenance
    """Origin of the numbers."""
    robot: str
    """Model of the robot."""
    schema: str
    """Schema and version: `etalon/plan/1`."""
    study: StudyDocument | None
    """Simulated calibration with the chosen poses, if true parameters are given (thesis, section 4.6)."""
    value: float
    """Index of the chosen poses."""
    workspace: WorkspaceUncertainty | None
    """Predicted standard uncertainty of position over all candidates; absent if the instrument's uncertainty is not
    given.
    """

class PredictionsDocument(Document):
    """Measurements that identified parameters predict."""
    predictions: Records[PredictedMeasurement]
    """One entry for each row of the table of joint values."""
    provenance: Provenance
    """Origin of the numbers."""
    robot: str
    """Model of the robot."""
    schema: str
    """Schema and version: `etalon/predictions/1`."""

class RecommendationDocument(Document):
    """Parameters whose identification makes the robot more accurate at poses that were not used."""
    campaign: CampaignReference | None
    """Campaign whose data recommend the parameters."""
    folds: int
    """Number of folds; each is predicted from the others."""
    held_out: HeldOutErrors
    """Position errors at poses that were excluded from the identification (mm)."""
    loading: Loading | None
    """Answer of the run to what a controller should load."""
    meaning: list[str]
    """Recommendation in words."""
    meaning_phrases: Records[Phrase]
    """Texts of the catalogue that are `meaning` in English."""
    messages: Records[Message]
    """Warnings, with remedies."""
    parameters: Records[ParameterVerdict]
    """Every identified parameter of the robot itself."""
    poses: int
    """Number of calibration poses."""
    recommended: ParametersDocument
    """Parameters of the answer: the parameters of the run; with further effects, if these are to be identified
    first; or nominal ones.
    """
    repeats: int
    """Number of repetitions with other folds."""
    robot: str
    """Model of the robot."""
    schema: str
    """Schema and version: `etalon/recommendation/1`."""
    steps: Records[EffectStep]
    """Effects in the order of trial. Accepted effects are part of every later step."""

class SelftestDocument(Document):
    """Validation of an installation: the program and its machine, comparisons with reference values, and seeded
    faults that the comparisons must notice.
    """
    machine: Machine
    """The machine."""
    must_fail: Records[SelftestMustFail]
    """Seeded faults in the reference data, each of which must fail a comparison."""
    packages: Records[LockedPackage]
    """Packages of which program, build scripts and tests are built (Cargo.lock)."""
    pass_: bool
    """`true` if everything passed."""
    performance: SelftestPerformance | None
    """Comparison of the laboratory's own campaign with its stored result; null if none was given."""
    program: SelftestProgram
    """The program."""
    provenance: Provenance
    """Origin of the numbers."""
    reference: Records[ReferenceFile]
    """Files of the reference data in the program, with their hashes."""
    reference_folder: bool
    """`true` if the reference data of NIST are present in the folder `ETALON_REFERENCE`."""
    requirements: Records[SelftestRequirement]
    """Requirements with their tests."""
    schema: str
    """Schema and version: `etalon/selftest/1`."""

class StudiesDocument(Document):
    """Comparison of sets of poses under given noise."""
    designs: Records[StudiedDesign]
    """One entry for each set and noise."""
    draws: int
    """Number of such means, over which intervals are taken."""
    error: str
    """Definition of the errors `before` and `after`, in words."""
    error_phrase: Phrase | None
    """Text of the catalogue that is `error` in English."""
    provenance: Provenance
    """Origin of the numbers."""
    robot: str
    """Model of the robot."""
    runs: int
    """Number of calibrations whose mean is evaluated."""
    schema: str
    """Schema and version: `etalon/study/1`."""

class UncertaintyDocument(Document):
    """Distributions by Monte Carlo (JCGM 101) and bootstrap, in addition to the linear uncertainties."""
    campaign: CampaignReference | None
    """The campaign."""
    draws: int
    """Number of Monte Carlo draws of the whole campaign: frames, readings, common errors."""
    errors: Records[DistributionEntry]
    """Mean, root-mean-square and largest error of the validation poses (`mean`, `rms`, `max`), of each quantity that
    was measured.
    """
    messages: Records[Message]
    """Warnings of the identification."""
    parameters: Records[DistributionEntry]
    """Identified parameters."""
    provenance: Provenance
    """Origin of the numbers, and seed of the draws."""
    resamples: int
    """Number of bootstrap resamples of poses and cycles; 0 if resamples do not determine the parameters."""
    robot: str
    """Model of the robot."""
    schema: str
    """Schema and version: `etalon/uncertainty/1`."""
    two_digits_reached: bool
    """`true` if two significant digits of all standard uncertainties and interval ends are stable (JCGM 101, 7.9.4)."""
    uncertainties_from: str
    """Basis of the standard uncertainties of the identification. Draws of parameters contain the given uncertainties
    and the model error; draws of errors contain the given uncertainties.
    """

class VerdictDocument(Document):
    """`verdict.json`: verdict of a run, with its reasons."""
    actions: Records[Action]
    """Next steps, at most five: missing limits, then the steps with the largest gain."""
    exit_code: int
    """Exit code of the run: 0 if the answer may be loaded, otherwise 1."""
    judged_file: str | None
    """Controller file with whose values the limits of errors are judged; absent if its values are the identified
    ones, or if no file is written.
    """
    limits: Records[LimitVerdict]
    """All limits with their verdicts."""
    loading: Loading | None
    """Answer to the question of which values a controller should load; absent without identified parameters."""
    reasons: list[Any]
    """Reasons why the verdict is not `pass`, the worst first. Without limits: reservations about the results."""
    schema: str
    """Schema and version: `etalon/verdict/1`."""
    verdict: str | None
    """Verdict; null if nothing was judged, because no limit is given."""

class VerificationDocument(Document):
    """Test of whether previously identified parameters explain today's observations."""
    alike: list[str]
    """Names of the other movements that explain the residuals about as well as `moved`."""
    calibration: CampaignReference | None
    """Campaign that identified the parameters; absent if their folder does not contain `campaign.json`."""
    conditions: Records[VerifiedQuantity]
    """Residuals of each quantity other than positions of targets."""
    copies: int | None
    """Number of rows whose values are equal to values of the calibration: a copy of its readings verifies nothing."""
    expected_position_rms_mm: float
    """Expected root-mean-square residual of a position if nothing has changed (mm)."""
    expected_rms_mm: float
    """Expected root-mean-square residual if nothing has changed (mm)."""
    explanations: Records[Movement]
    """All single movements that may explain the residuals, the best explanation first."""
    meaning: str
    """Verdict in words."""
    meaning_phrase: Phrase | None
    """Text of the catalogue that is `meaning` in English."""
    messages: Records[Message]
    """Warnings, with remedies."""
    model_mm: float
    """Standard deviation of the calibrated model's error of a coordinate, in addition to the measurement (mm)."""
    moved: Movement | None
    """Object that has moved, with its displacement, if a single movement explains the residuals."""
    of_changes: SumOfSquares
    """Residuals that a movement of base and joints can produce."""
    of_rest: SumOfSquares
    """All other residuals."""
    p_value: float
    """Probability of residuals at least this large if nothing has changed."""
    points: int
    """Number of measured positions."""
    poses: int
    """Number of observed poses."""
    position_rms_mm: float
    """Root-mean-square residual of a position (mm)."""
    power: DetectionPower
    """Detection power of these observations."""
    provenance: Provenance
    """Origin of the numbers."""
    rms_mm: float
    """Root-mean-square residual of a coordinate (mm); zero without positions."""
    robot: str
    """Model of the robot."""
    schema: str
    """Schema and version: `etalon/verification/1`."""
    significance: float
    """Significance level: the robot counts as changed if the p-value is below it."""
    standard_uncertainty_mm: float
    """Standard uncertainty of a measured coordinate (mm)."""
    verdict: str
    """Verdict on the parameters."""

class VerificationPlanDocument(Document):
    """Candidates to measure so that `etalon verify` detects the smallest possible changes."""
    messages: Records[Message]
    """Warnings, with remedies."""
    model_mm: float
    """Standard deviation of the calibrated model's error of a coordinate, in addition to the measurement (mm)."""
    naming: float
    """Probability with which the right joint is named."""
    probability: float
    """Probability with which changes are detected."""
    provenance: Provenance
    """Origin of the numbers."""
    robot: str
    """Model of the robot."""
    schema: str
    """Schema and version: `etalon/verification-plan/1`."""
    standard_uncertainty_mm: float
    """Standard uncertainty of a measured coordinate (mm)."""
    steps: Records[VerificationStep]
    """Poses in the order of the choice."""

class WrittenDocument(Document):
    """Files that a command wrote: report, export, simulate and init."""
    controllers: Records[WrittenController]
    """Position errors with the controller files that `etalon export` wrote, if the run measured them."""
    files: list[str]
    """Files in the order of writing."""
    loading: str | None
    """Answer of the run to the question of what a controller should load; absent without a run."""
    schema: str
    """Schema and version: `etalon/written/1`."""

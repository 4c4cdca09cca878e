### Texts of reports: titles, heads of tables, captions, terms and sentences. Numbers come with their digits.

accepted = accepted
accuracy = Accuracy
accuracy-at-pose = Largest pose accuracy AP: { $accuracy } µm, at pose { $pose }.
accuracy-not-tested = The campaign has no commanded positions: pose accuracy (AP) is not tested.
accuracy-drifts = AP changes significantly during the test at { $count ->
        [one] pose { $poses }
       *[other] poses { $poses }
    }. The interval there contains AP of every set of cycles: it is not the coverage interval of a stable robot.
accuracy-of-position = Positioning accuracy
accuracy-over-cycles = Pose accuracy of each pose during the test.
action-label = what to do:
actual-lead = actual lead
actuator = actuator
after = after
after-named = { $name }, after
against = against
agree = agree
all-distances = all
all-poses-conform = all { $count } poses conform
all-tables = All tables
allowed = permitted
along-path-in-mm = along the path (mm)
amends-report = amends report
and-more = and { $count } more
angle-ad = AD of the angle { $axis }
angle-rd = RD of the angle { $axis }
angle-vap = vAP of the angle { $axis }
ap-by-set = AP by set
ap-interval-from = AP, 95 % from
ap-interval-to = AP, 95 % to
ap-of-judged-approach = AP of the judged approach
ap-within-limit = AP within its limit
approach-not-known = approach unknown
approaches-unknown = Pose { $pose }: no recorded pose precedes { $count ->
        [one] one visit
       *[other] { $count } visits
    } (cycle { $cycles }), so the approach is unknown. Values of one approach do not contain { $count ->
        [one] this visit.
       *[other] these visits.
    }
approached = approached
approved-by = Approved by
arc = arc
area = area
arrivals = arrivals
arrivals-title = Arrivals
arrows-common = Arrows magnified { $factor } times, before and after; longest error: { $longest }.
arrows-description = One arrow per measured position: measured minus predicted, magnified { $factor } times.
arrows-longest = Arrows magnified { $factor } times; longest error: { $longest }.
at-interval-from = AT, 95 % from
at-interval-to = AT, 95 % to
at-location = AT at
at-of-angles = AT of the angles (deg)
at-position = { $value }, at { $position } mm
at-rt-diamonds = Diamonds: largest AT and largest RT, with their intervals. The maximum of many scattered values is biased upwards, so the largest RT may lie above its interval (which is for infinitely many passes).
at-tool-point = At the tool point: { $count } poses
attached-accuracy = Errors before and after
attached-campaign = Contents of the campaign
attached-cell = Frames of the cell
attached-certificate = Digital calibration certificate (DCC), draft
attached-changes = Changes between campaigns
attached-characteristics = Characteristics of ISO 9283
attached-compliance = Static compliance
attached-controllers = Controller files
attached-distributions = Distributions of results
attached-geometric = Geometric calibration
attached-parameters = Identified parameters, covariance, provenance
attached-plan = Chosen poses
attached-recommendation = Recommendation
attached-selftest = Validation of the installation
attached-streams = Recorded motions
attached-validation = Errors of given parameters
attached-verification = Poses to verify
attached-verified = Verification
authorised-by = authorised by
axis-after = after, { $axis }
axis-before = before, { $axis }
axis-commanded = commanded { $axis }
axis-direction = direction { $axis }
axis-mean = mean { $axis }
axis-origin = origin { $axis }
axis-point = point { $axis }
axis-x = x
axis-y = y
axis-z = z
ball = ball
bar-too-uncertain = the uncertainty of the bar is too large (4:1 required)
base-and-targets = base and targets
base-motion-explains-most = the parameters are no longer valid: a movement of the base by { $by } (k = 2) explains { $percent } % of the deviation; the remaining residuals are larger than expected
base-moved = the base has moved by { $by } (k = 2, in the world frame)
base-rotation = base rotation
base-shift = base shift
batch-ends = { $pass } pass, { $conditional } conditional, { $undecided } undecided, { $fail } fail, { $failed } not run, { $skipped } skipped
batch-synthetic = { $count ->
    [one] 1 campaign is
   *[other] { $count } campaigns are
} based on synthetic data, not on measurements of a robot.
before = before
before-after-description = Errors with nominal parameters and after calibration, on one axis.
before-named = { $name }, before
best-possible-choice = the best possible choice
between-poses = between poses
birge-ratio = Birge ratio
bootstrap-resamples = Bootstrap: { $count } resamples of poses and cycles.
bootstrap-without-tolerances = The bootstrap keeps the nominal values and omits their tolerances. Its u is less than half of the linear one for { $count ->
        [one] 1 parameter, which the data alone determine
       *[other] { $count } parameters, which the data alone determine
    } poorly; the linear value applies.
both = both
box-of-poses = The box encloses the poses; its edges are parallel to the axes.
branch-and-bound-nodes = branch-and-bound nodes
budget-left-out = U does not include, because the campaign gives no values: { $sources }.
budget-note = Contributions to the standard uncertainties (k = 1), in the unit of each row. The last column is the root sum of squares. Effects common to several readings are treated as correlated.
budget-of-default-tolerances = Default tolerances are multiplied by { $factor }, the factor that agrees best with the data.
budget-of-errors-note = Measurement uncertainty of the errors in this table: readings, frames, and fitted base and targets. The identified parameters are under test, so their uncertainty is not included. The limits are judged with the expanded uncertainty, twice these values (k = 2).
budget-of-nominal-values = Standard uncertainty of a nominal value: tolerance / √3, for a rectangular distribution (GUM 4.3.7).
budget-of-parameters = Uncertainty budget of the parameters
budget-shares-description = One bar per result: squared contributions in percent of the variance.
budget-shares-title = Shares of the uncertainty sources in the variance
bullet-accepted = accepted
bullet-beyond = beyond the limit
bullet-description = Each value divided by its limit, with { $drawn ->
        [interval] the ends of its interval. The guard band is as wide as the distance from the value to the upper end.
        [both] U (k = 2) or the ends of its interval. The guard band is as wide as the distance from the value to the upper end.
       *[uncertainty] U (k = 2). The width of the guard band is U.
    }
bullet-description-accepted = Each value divided by its limit, with { $drawn ->
        [interval] the ends of its interval.
        [both] U (k = 2) or the ends of its interval.
       *[uncertainty] U (k = 2).
    }
bullet-guard-band = guard band
bullet-within-u = accepted, within U of the limit: see its risk
bullet-not-measured = not measured, limit { $limit } { $unit }
bullet-value = value
bullet-value-limit = { $value } { $unit }, limit { $limit } { $unit }
bullet-value-limit-drift = { $value } { $unit }, limit { $limit } { $unit }, AP drifts
bullet-value-limit-risk = { $value } { $unit }, limit { $limit } { $unit }, risk { $risk } %
by-approach = By approach
bytes = bytes
calibration = calibration
calibration-certificate = Calibration certificate
calibration-certificate-draft = Draft calibration certificate
calibration-of-synthetic-data = Calibration with synthetic data, not a certificate
calibration-report-of-model = Calibration report: { $model }
calibration-report-of-robot = Calibration report of robot { $robot }
campaign = campaign
campaign-as-named = Campaign, in the order given
campaign-column = Campaign
campaign-from = { $to } from { $from }
campaign-of-parameters = campaign of the parameters
campaign-value = campaign { $campaign }: { $value } { $unit }
campaigns = Campaigns
campaigns-in-order = { $count } campaigns, in the order given
campaigns-of-robot = { $count } campaigns of robot { $robot }, in the order given
campaigns-of-robots = { $campaigns } campaigns of { $robots } robots
campaigns-shown = { $shown } of { $total } campaigns
candidate-tooltip = pose { $pose }, { $configurations } configurations: x { $x }, y { $y } mm
candidates = candidates
candidates-and-chosen-positions = Candidates and chosen positions
candidates-and-configurations = { $candidates }, { $configurations } configurations
candidates-chosen = { $chosen } of { $candidates } candidates are chosen. The size of a mark shows how many configurations reach the position.
candidates-drawn = { $candidates } of { $draws } random poses; excluded: { $limits } beyond limits, { $region } outside the box, { $sight } facing away
candidates-hidden = { $count } hidden by { $obstacle }
cause-column = Cause
cell-controller-lines = Lines for { $maker }
cell-controller-written = Printed by `--controller { $maker }`; the numbers are the same as in the tables.
cell-frames = Frames and points
cell-frames-note = U: expanded uncertainty (k = 2) of each coordinate, and of a small rotation about x, y and z of the reference frame.
cell-head-frame = frame
cell-head-length = length
cell-head-measure = quantity
cell-measure-orientation = orientation
cell-measure-position = position
cell-motion-by-value = motion by axis value
cell-residuals-note = Measured minus predicted; orientations as rotation vectors. p: probability that noise alone causes a residual at least as large.
cell-residuals-title = Residuals of the readings
cell-step-choose = Print the lines for the controller: repeat the command with `--controller NAME`.
cell-step-choose-reason = `etalon cell --help` lists the controllers; each has its own units and order of angles.
cell-step-load = Load the lines for { $maker }.
cell-step-load-reason = Before production, check a reading that is not in the table.
cell-step-measure = Measure more readings.
cell-step-measure-reason = The readings have no redundancy, so nothing checks the answer.
cell-step-messages = Clear the warnings first.
cell-step-messages-reason = Each warning explains what it affects.
cell-subtitle = Robot cell, { $readings ->
        [one] one reading
       *[other] { $readings } readings
    }
cell-title = { $solve ->
        [tool-point] Tool centre point
        [tool-reflector] Reflector on the tool
        [tool-axes] Tool frame
        [hand-eye] Camera (hand-eye)
        [object] Work object
        [three-points] Work object from three points
        [linear-axis] Linear axis
       *[rotary-axis] Rotary axis
    }
cell-verdict-axis = scale { $scale } ± { $u } (k = 2)
cell-verdict-known = { $frame }: U = { $um } µm along x, y, z{ $turned ->
        [no] {""}
       *[yes] {" "}and { $deg } deg about x, y, z
    } (k = 2)
cell-verdict-unknown = { $frame }: the uncertainty is unknown
cell-verdict-warnings = { $count ->
        [one] one warning limits the answer
       *[other] { $count } warnings limit the answer
    }
certificate-coverage = U: expanded uncertainty, coverage factor k = 2, coverage probability about 95 % for a normal distribution.
certificate-computed = “After” is computed with the identified parameters from the joint values of the campaign; the robot was not measured with a file loaded. “Before” is computed with the nominal parameters of the robot; base, targets and fixtures are fitted as far as the campaign leaves them free.
certificate-controller-before = The controller had the values of `{ $file }` (SHA-256 { $sha256 }), which may differ from the nominal ones.
certificate-controller-unknown = The values in the controller are not given, and may differ from the nominal ones.
certificate-held = The values apply as one set. U assumes that the held values are exact. A single value is not the dimension of a part of the robot.
certificate-interval = U: expanded uncertainty of the value, coverage factor k = 2. Last column: error of the robot without the noise of the readings, coverage probability at least 95 %.
certificate-no-file = This certificate lists no file to load: { $reason }.
certificate-parameters = Parameters, identified and held
certificate-parameters-hash = parameters.json, SHA-256
certificate-reproduction = This document shall be reproduced only in full.
certificate-without-uncertainty = Values without U or interval are for information: their uncertainty was not evaluated.
chain-of-links = The parameters describe the chain from link `{ $base }`, the base frame, to { $ends }.{ $count ->
        [0] {""}
       *[other] {" "}Joints move link `{ $base }`: it is not the base of a controller.
    }
change = change
change-by-u = change/u
change-over-u = change over u
change-with-interval = change ± U (k = 2)
changed = changed
changed-below = reported as changed below { $significance }
changes = Changes
check-column = Check
checklist-clause = clause
checklist-field = field
checklist-key = key
checklist-keys = Keys and clauses
checklist-note = { $count ->
    [one] A field is missing. Add it to campaign.toml and run the campaign again.
   *[other] { $count } fields are missing. Add them to campaign.toml and run the campaign again.
}
checklist-title = To complete before signing
checks-of-the-model = Model checks
checksums-of-files = Controller files and their checksums
chi-square = chi-square
choice = Choice
choice-gap = at most { $percent } % below the best possible choice
choice-proven = Shown: no other choice of { $chosen } of { $candidates } candidates has a larger { $index }
choice-within-percent = { $index } is at most { $percent } % below the best possible choice of { $chosen } of { $candidates } candidates
choice-without-bound = There is no upper bound for { $index }: a better choice may exist
chosen = chosen
chosen-candidate-tooltip = pose { $pose }, { $configurations } configurations, chosen: x { $x }, y { $y } mm
chosen-candidates-marks = Hollow marks: candidates; filled marks with the number of their pose: chosen.
chosen-one-by-one = { $poses } poses, { $configurations } configurations, one by one
chosen-poses = Chosen poses
chosen-with-all-modes = { $poses } poses, { $configurations } configurations, all working modes of a pose together
circle = circle
circle-x-y = circle x, y
clause-compliance = static compliance
clause-cornering = cornering deviations
clause-directions = multi-directional pose accuracy variation
clause-distances = distance accuracy and distance repeatability
clause-drift = drift of pose characteristics
clause-exchangeability = exchangeability
clause-not-tested = not tested
clause-overshoot = position overshoot
clause-path-accuracy = path accuracy
clause-path-repeatability = path repeatability
clause-pose-accuracy = pose accuracy
clause-pose-repeatability = pose repeatability
clause-posing-time = minimum posing time
clause-reorientation = path accuracy on reorientation
clause-stabilisation = position stabilisation time
clause-tested = tested
clause-velocity = path velocity characteristics
clause-weaving = weaving deviations
clauses-evidence = Clauses of ISO 9283:1998: tested, not tested, and verification of the evaluation
clauses-note = The report makes statements about the tested clauses only. `etalon selftest` repeats the comparisons with the independent program.
clauses-summary = Tested clauses of ISO 9283:1998: { $tested }. Not tested: { $untested }.
clauses-title = Clauses of ISO 9283:1998
colours = Colours
command = command
command-theta = command θ
command-x = command x
command-y = command y
commanded-away = commanded position, { $distance } µm away
commanded-frequency = commanded frequency
commanded-velocity = commanded velocity
commanded-stroke = commanded stroke
commanded-tooltip = commanded position: x { $x }, y { $y }, z { $z } µm from the mean
compared-with = compared with
compliance = compliance
condition = condition
condition-number = condition number
conditional = conditional
conditions = Conditions
configurations = configurations
conforming = conforming
conformity-by-rule = According to { $rule }: { $results }.
conformity-disproved = disproved
conformity-neither = neither proved nor disproved
conformity-proved = proved
confounded-with = confounded with
contact = contact
encoders = encoders
contents = Contents
controlled-by = controlled by
controller = controller
controller-files = Controller files
convention-angles = angles a, b, c are unwrapped and evaluated separately; order of rotations: { $order }
convention-angles-not-drift-compensated = drift of positions is compensated by reference targets; drift of angles is not
convention-angles-of-motion = angles { $angles } are unwrapped along the motion and evaluated separately
convention-angles-of-unknown-order = angles a, b, c are unwrapped and evaluated separately; order of rotations: not stated
convention-ap-interval = AP: interval of the difference recovered from both intervals (MOVER, Zou & Donner 2008)
convention-ap-rp = AP: mean minus commanded; RP: mean radius + 3 s, s with n - 1; intervals 95 %, Gaussian scatter
convention-approach = approach: the previous pose of the trajectory; the 25 % rule with U at k = { $k }; positions in the world frame ({ $frame })
convention-at-rt = AT: interval of the difference recovered from both intervals, as for AP; RT: the same method on the logarithmic scale about the centres of both intervals, which estimate RT of infinitely many passes; in simulated tests of ten passes, bootstrap intervals contain the true value in 90 % to 98 % of tests, depending on the kind of scatter, instead of 95 %
convention-birge = model error: the intervals of changes of parameters are multiplied by the Birge ratio (at least 1) of all robot parameters of both campaigns, because parameters absorb model error at the measured poses
convention-change-of-parameters = parameters: change over the square root of u1² + u2²; Student's t distribution with Welch's degrees of freedom if uncertainties are estimated from residuals; both campaigns are assumed independent
convention-compared-with = each campaign is compared with the first and with the previous one, in the given order
convention-compliance = compliance: displacement along the force per force, by least squares through the unloaded position
convention-compliance-clause = clause 10 was not compared with a purchased copy of the standard
convention-different-instruments = the campaigns used different instruments: a systematic difference between instruments is not visible in the scatter, and appears as a change of the robot
convention-drift-compensated = drift of positions and orientations is compensated by reference targets
convention-f-test = all parameters together: F test; it is approximate if uncertainties are estimated from pose errors, and then too often significant if only one or two coordinates of a pose were measured
convention-first-robot = { $count } robots: all results except exchangeability refer to `{ $robot }`
convention-guarded-acceptance = conformity: guarded acceptance (ILAC-G8:09/2019, 4.2.3): a decision is made only if the whole 95 % interval lies on one side of the limit
convention-interval-of-sets = AP drifts significantly at { $count ->
        [one] pose { $poses }
       *[other] poses { $poses }
    }: the interval there contains AP of every set of cycles
convention-intervals-instrument = intervals include sampling and the instrument's expanded uncertainty of a coordinate, { $uncertainty_um } µm (k = 2)
convention-intervals-sampling = intervals include sampling only: no uncertainty of the instrument is given
convention-limit-band = limit band: { $band } mm about the mean of the standstill
convention-mean-errors = mean errors: Welch's t test with one error for each pose; conservative (too rarely significant) if both campaigns measured the same poses
convention-mean-positions = mean positions: Welch's t test of each coordinate from the scatter of visits; the uncertainty of the measurement frames is not included
convention-motion-clauses = clauses 7.4, 7.5, 8, 9 and 11 were not compared with a purchased copy of the standard
convention-no-commanded-poses = no commanded poses: AP, distances and drift are not determined (null)
convention-path = path: normal planes at { $points } commanded points, the centres of equal parts; the last crossing of each plane within { $near } mm
convention-path-corners = no plane within { $near } mm of a corner (at most a quarter of its leg); corners are reported separately
convention-path-intervals = AT and RT: intervals for infinitely many passes by parametric bootstrap over the passes; in simulated tests of ten passes they contain the true value in 90 % to 98 % of tests, depending on the kind of scatter
convention-path-velocities = velocities between the planes in the central { $percent } %
convention-planar = commanded positions have no z: all characteristics except coplanarity are evaluated in the xy plane
convention-positions-drift-compensated = drift of positions is compensated by reference targets
convention-readings-averaged = readings of one visit are averaged; their scatter is the instrument's noise
convention-rotation-vectors = AP rx to rz: rotation vector from the commanded to the mean orientation about x, y, z of the table; RP rx to rz: three standard deviations of the rotations from the mean orientation; AD r, RD r, vAP r: angles between orientations
convention-rp-clause = RP follows the text of the standard (7.2.2); the other clauses were not compared with a purchased copy
convention-rp-ratio = RP: F test of the ratio, with the degrees of freedom of the interval in closed form (Gaussian scatter)
convention-set-up = parameters of base and targets change with every set-up: their change does not show a change of the robot
convention-shared-instrument = all campaigns used the instrument { $instrument }: its constant errors cancel in changes. If u contains these errors, the uncertainties of changes are too large. Drift of the instrument between campaigns appears as a change of the robot
convention-shared-risk = conformity: shared risk (JCGM 106:2012, 8.2.1): a decision is made if the expanded uncertainty is at most a quarter of the limit
convention-significance = a change is significant if its p-value, corrected for the number of quantities of its family in one pair of campaigns, is below 5 %; parameters: correction by the distribution of the largest change, with covariances (Westfall & Young 1993); other quantities: correction by Holm (1979); intervals of 95 % are not corrected
convention-simple-acceptance = conformity: simple acceptance (ILAC-G8:09/2019, 4.2.1)
convention-standing = standstill: within { $radius } mm of the mean for { $duration } s or longer; a standstill within { $near } mm of a pose is a visit of this pose; attained position: mean of the middle half of the standstill
convention-tables = the 25 % rule with U at k = { $k }; positions in the frame of the tables
convention-times-as-stamped = times: time stamps of the recording
convention-times-by-rate = times: computed from the given sampling rate of { $rate } Hz
conventions = conventions
conventions-and-drift = Conventions, drift of the recording
cooks-distance = Cook's distance
cooks-distance-description = One bar per pose of the table; poses above the line are influential.
cooks-distance-note = Cook's distance: change of the parameters when the pose is omitted, relative to their covariance. A pose above { $limit } is influential (median of F; Cook 1977).
cooks-distance-of-poses = Cook's distance of the poses
cooks-distance-tooltip = pose { $pose }: Cook's distance { $distance }
coordinate = coordinate
coordinates-of-targets = coordinates of targets
coordinate-uncertainty = { $uncertainty } mm (k = 1) per coordinate
coordinate-uncertainty-in-common = { $uncertainty } mm (k = 1) per coordinate, independent for each observation, and { $common } mm common to all observations of a measured point
coordinates = coordinates
coplanarity = Coplanarity
coplanarity-of-pose = distance of the mean position from the plane of the other three
coplanarity-peak-to-valley = coplanarity, peak to valley
copy = Copy
corner = corner
corners = corners
correlated-pairs = Correlation of 0.9 or more: { $pairs }.
correlated-pairs-strongest = { $count } pairs have a correlation of 0.9 or more. Strongest: { $pairs }.
correlated-with = correlated with
correlation-description = One cell per pair: blue for positive, orange for negative correlation.
correlation-title = Correlation of the identified parameters
correlation-tooltip = { $first } and { $second }: { $correlation }
count-at-poses = { $count } at { $poses } poses
count-of-set = { $count } points of { $set }
coverage-factor = coverage factor
curve = curve
curve-caption = The best position is added one at a time, with all its configurations.
curve-description = Circles: index, left axis. Diamonds: condition number, right axis.
curve-point-tooltip = { $curve }: { $value } at { $at }
curve-singular = { $count ->
    [one] The first choice is singular: its condition number is not drawn.
   *[other] The first { $count } choices are singular: their condition numbers are not drawn.
}
curve-title = { $index } and condition number versus number of positions
curve-tooltip = { $positions } positions, { $configurations } configurations: { $index } { $value }, condition { $condition }
customer = customer
cycle = cycle
cycles = cycles
cylinder = cylinder
date = date
date-column = Date
date-not-stated = date: not stated
date-of-issue = date of issue
date-of-receipt = date of receipt
decide-now = Decide now
decision-rule = decision rule
decision-rule-by-default = The campaign states no decision rule; this default applies.
decision-rule-explained = Decision rule: { $rule }: { $explanation }.
decision-rule-named = Decision rule: { $rule }.
definition = definition
definition-ad-rd = AD: mean attained distance minus commanded distance; RD: three standard deviations of the attained distance (ISO 9283:1998, 7.3).
definition-ap = AP: distance between the mean attained position and the commanded position, with its components (ISO 9283:1998, 7.2.1).
definition-ap-rp-of-angles = AP: mean attained angle minus commanded angle; RP: three standard deviations; evaluated for each angle (ISO 9283:1998, 7.2.1 and 7.2.2).
definition-compliance = Displacement along the force per unit force: slope of the line fitted through the unloaded position (ISO 9283:1998, 10).
definition-drift = dAP and dRP: absolute difference between the first set and the last set (ISO 9283:1998, 7.6). U of dAP contains the scatter within the sets; errors that the instrument repeats cancel. AP has stabilised after five successive changes of at most 10 % of the largest change: this takes at least seven sets.
definition-of-errors = definition of errors
definition-posing-time = Time from departure from a pose to the end of stabilisation at the next pose (ISO 9283:1998, 9). U contains the scatter of the moves and the sampling interval. The straight distance lies between the two standstills; the path length follows the attained path.
definition-quarter-rule = ISO 9283: the expanded measurement uncertainty must not exceed 25 % of the characteristic under test. U is the expanded uncertainty of a position (k = 2). If visits come from several approaches, each row gives the approach with the smallest value.
definition-rp = RP: ISO 9283:1998, 7.2.2. Each row contains only its own visits. In addition to the standard: RP without the instrument's noise (if visits have repeated readings), and the ellipsoid that contains the next position with a probability of 95 %.
definition-stabilisation = Time from the first entry into the limit band until the robot stays within it (ISO 9283:1998, 7.4 and 7.5). U contains the scatter of the arrivals and the sampling interval; U of an overshoot contains the scatter at standstill.
definition-standstill-distance = Distance of the mean of each standstill from the first standstill at the same pose. A growing distance indicates drift, a constant one repeatability.
definition-target-displacement = Displacement of the fixed targets since their first measurement, and the remaining displacement after correction of the positions (not part of the standard).
definition-vap = vAP: largest distance between the mean positions of two approaches (ISO 9283:1998, 7.2.3).
degrees-of-freedom = degrees of freedom
degrees-of-freedom-sum = { $degrees } = { $residuals } residuals + { $stated } stated values − { $determined } parameters that the data determine
detected-from = detected from
detected-with-probability = Probability of detection: { $percent } %
deviation = deviation
deviation-along-path = Deviation along the path
deviation-of-mean-value = its standard deviation
deviation-of-the-mean-path = mean path deviation
deviations-from-the-method = deviations from the method
difference = difference
difference-over-u = difference over u
different-instruments = Different instruments: { $instruments }. Systematic differences between them appear as changes.
different-models = Different models: { $counts } parameters were identified. Parameters held in one model affect the others.
different-set-ups = Different set-ups: { $differences }.
differs = differs
direction = direction
disagrees = disagrees
displacement-up-to = displacement up to
distance = distance
distance-after-entry = Distance from the attained pose after the first entry into the limit band: first arrivals at each pose.
distance-between-poses-in-mm = distance between poses (mm)
distance-error-tooltip = { $name }: { $value } µm; { $from } to { $to } mm, { $pairs } pairs
distance-error-tooltip-u = { $name }: { $value } µm ± { $u } µm (k = 2); { $from } to { $to } mm, { $pairs } pairs
distance-from-base-in-mm = distance from the base (mm)
distance-from-the-base = distance from the base
distance-in-mm = distance (mm)
distances = distances
distances-between-poses = Distances between poses
distances-by-distance-description = Size of the errors of { $pairs } distances, by steps of the distance; logarithmic axis. Intervals are expanded uncertainties (k = 2).
distances-by-distance-title = Errors of distances between poses, by distance
distances-from-to = { $from } to { $to }
distances-max = distances, max
distances-rms = distances, RMS
distributions-of-errors = Distributions of the errors at the validation poses
distributions-of-parameters = Distributions of the parameters
download-csv = Download CSV
download-svg = Download SVG
draft-mark = DRAFT
draws-agree = Linear propagation agrees with { $draws } Monte Carlo draws for all { $parameters } parameters.
draws-differ = Linear propagation and { $draws } Monte Carlo draws differ for { $differing } of { $parameters } parameters (by more than half a unit in the second digit of the standard uncertainty).
draws-of-stated = The draws include the given uncertainties, but not the model error.
draws-too-few = Too few draws for two digits of every standard uncertainty: increase their number.
draws-without-model-bootstrap = The bootstrap includes the model error. The draws of a parameter include it if they agree with the bootstrap. The draws of the errors include the given uncertainties only.
draws-without-model-both = The standard uncertainties of the report and the bootstrap include the model error. The draws of a parameter include it if they agree with the report. The draws of the errors include the given uncertainties only.
draws-without-model-report = The standard uncertainties of the report include the model error. The draws of a parameter include it if they agree with the report. The draws of the errors include the given uncertainties only.
drift = Drift
drift-title = Drift of accuracy and repeatability
effect = effect
effect-at-worst-pose = displacement at the worst pose ({ $unit })
effect-tooltip = { $name }: { $value } ± { $half } { $unit } at pose { $pose }
effective-parameters = Effective, not physical parameters: { $names }. The residuals exceed the instrument's uncertainty, and most of the uncertainty of these values comes from model error. They fit the measured poses, but may differ from the dimensions of the robot.
effects-cross-validated = Effects: { $folds }-fold cross-validation of { $poses } poses, repeats: { $repeats }
effects-description = Each bar: displacement of the measured point that moves most if only this parameter changes from its nominal to its identified value. { $count } of { $total } parameters.
effects-of-all = Effects of all parameters
effects-reduce-errors = effects that reduce the errors at held-out poses: { $effects }
effects-section = Parameters by their effect
effects-title = Effects of the parameters
ellipsoid-semi-axes = ellipsoid, semi-axes
ellipsoid-semi-axis-1 = ellipsoid, semi-axis 1
ellipsoid-semi-axis-2 = ellipsoid, semi-axis 2
ellipsoid-semi-axis-3 = ellipsoid, semi-axis 3
enclosing-circle-radius = enclosing circle in x, y, radius
enclosing-sphere-radius = enclosing sphere, radius
end-of-report = End of report
environment = environment
error = error
error-after-in-plane = Error after calibration: { $quantity }, { $plane }
error-after-max = error after, max
error-after-mean = error after, mean
error-against = Error after calibration: { $quantity }, versus { $against }
error-at-poses = { $quantity } at { $count } { $set } poses{ $readings ->
        [0] {""}
       *[other] {" "}({ $readings } readings)
    }: { $before } → { $after } { $unit }.
error-axis-linear = The error axis is linear: the largest error before is at most { $factor } times the median after.
error-axis-logarithmic = The error axis is logarithmic: the largest error before exceeds { $factor } times the median after.
error-before-in-plane = Error before calibration: { $quantity }, { $plane }
error-before-max = error before, max
error-before-mean = error before, mean
error-definition = error: { $error }; { $values }; statistics: of magnitudes, counting each repeat
error-in = { $quantity } error ({ $unit })
error-by-pose = Errors by pose: { $quantity }
error-in-unit = error ({ $unit })
error-log = error ({ $unit }), logarithmic
error-left-out = RMS error at held-out poses: { $nominal } mm with the nominal parameters, { $all } mm with all parameters, { $recommended } mm with the recommended parameters
error-map-description = Marks at the measured positions: colour and size from 0 to { $top }, same scale before and after; largest error { $largest }.
error-map-own-scale = Marks at the measured positions: colour and size from 0 to { $top }, scale of this figure only; largest error { $largest }.
error-of-platform = measured pose of the platform centre C (from the balls) minus the pose predicted from the joint values; positions: C in the base frame
error-of-positions = measured minus predicted position of each target, predicted from the joint values; positions: targets in the world frame
error-of-quantities = measured minus predicted value of each measured quantity (distance, distance from a surface or a socket, single coordinate), predicted from the joint values
error-of-targets = measured minus predicted position of each target, predicted from the joint values; orientation: rotation between the measured and the predicted targets; positions: targets in the world frame
error-of-tool = error: true position of { $point } in the base frame minus the position computed by the controller
error-sizes-after = Distribution of the errors after calibration: { $quantity }
error-sizes-before = Distribution of the errors before calibration: { $quantity }
error-tooltip = pose { $pose }, cycle { $cycle }, { $target } ({ $set }): { $before } before, { $after } after
error-vectors-after = Error vectors after calibration, { $plane } plane
error-vectors-before = Error vectors before calibration, { $plane } plane
errors = errors
errors-against-description = One mark per error: circles for calibration poses, diamonds for validation poses.
errors-before-after = Errors before → after calibration, { $set } poses:
errors-before-after-of = Errors of { $point } before → after calibration, { $set } poses:
errors-before-and-after = Errors before and after
errors-below-axis = { $count ->
    [one] 1 smaller error is drawn at the lower edge.
   *[other] { $count } smaller errors are drawn at the lower edge.
}
errors-by-number-of-positions = Position errors versus number of positions
errors-by-pose-linear = One mark per pose, cycle and target; linear axis ({ $unit }).
errors-by-pose-logarithmic = One mark per pose, cycle and target; logarithmic axis ({ $unit }).
errors-by-set-and-pose = Errors by set and by pose
errors-contain-noise = An error is the deviation of a reading and contains its noise, which increases mean, RMS and maximum. The error of the robot without noise is below value + U with a probability of at least 95 %. Value ± U is not its coverage interval.
errors-draws-confirm = The draws confirm the reported uncertainty of the { $errors } errors in the table of errors.
errors-draws-larger = For { $differing } of { $errors } errors at the validation poses, the draws give the larger uncertainty (JCGM 101:2008, clause 8). The linear value in the report is too small.
errors-hold-among = { $region ->
        [beyond] Some validation poses are outside the measured region; their errors are included
       *[within] These figures apply within the measured region
    }: the distance from a validation pose to the nearest calibration pose is { $ratio } × the spacing of the calibration poses (median; maximum { $largest } ×). Distinct validation positions with a joint outside its calibration range: { $outside } of { $total }.
errors-not-drawn = { $count } errors with a non-finite position or value are not drawn.
errors-of-each-pose = Errors by pose
errors-of-noise-alone = Noise alone can explain the largest error of these quantities: { $quantities }. The value is then mostly noise.
errors-of-poses-drawn = { $drawn } of { $total } errors are plotted.
errors-overlaid-description = Shares of { $count } points of { $set }; logarithmic axis.
errors-overlaid-title = Errors before and after: { $quantity }
errors-that-do-not-decide = Further errors
errors-with-all-parameters = With all identified parameters
errors-with-file = With the values of `{ $file }`: { $set }, { $poses } poses
example-label = example:
exchangeability = Exchangeability
exchangeability-between-robots = Exchangeability E = { $distance } µm: largest distance between the mean positions of two robots at one pose (ISO 9283:1998, 7.7).
expanded-of = U of { $figure }
expected = expected
expected-from-the-points = expected from the points
expected-label = expected:
expected-of-parameters = expected, parameters (k = 1)
expected-standard = expected (k = 1)
expected-value = { $value }, expected { $expected }
expected-value-judged = { $value }, expected { $expected } ({ $criterion })
expanded-uncertainty-of-quantity = { $quantity }: U = { $uncertainty } { $unit } per component of a reading (k = 2)
expired = expired
explained = explained
explanations-of-messages = Explanations of these messages
export = export
fail = fail
features = Features
field-components = Components of the field and their uncertainty
field-deviation = standard deviation
field-gain = At held-out poses, with parameters and field from the other poses, the position error (root mean square) falls from { $without } to { $with } µm. The field describes { $share } % of the mean square error; the gain is { $gain } times its standard uncertainty.
field-held-out-caption = Each pose is predicted with the parameters and the field of the other poses (five parts).
field-held-out-description = Position errors of held-out poses without and with the residual field.
field-held-out-title = Position error of held-out poses, without and with the field
field-inputs = depends on, with the measured range
field-note = The field describes errors of the joints that the parameters do not describe. Beyond the measured ranges it fades out, and only the parameters remain.
field-refused-because = No residual field is used: { $reason }.
field-uncertainty = { $coverage } % of the coordinates of held-out poses are within 1.96 predicted standard uncertainties. The standard uncertainty of the field is multiplied by { $factor } to agree with these errors.
figure = result
figure-of-set = { $set } { $quantity } { $figure }
figures-of-measurement-point = All values refer to the measurement point: { $point }.
figures-with-field = The errors after calibration include the field.
figures-without-field = The other results of this report do not include the field.
file = file
file-with-hash = { $file }, SHA-256 { $sha256 }
filter = Filter
filter-rows = Filter rows
first-cycle = first cycle
fit = fit
fit-and-observability = Fit and observability
first-set = { $symbol }, first set
fits = Fits
fixed-in-the-world = Elements fixed in the world frame
folder = folder
folds-over-u = SD between folds / u
force-up-to = force up to
formats = formats
formats-without-all-parameters = These formats cannot hold all identified parameters. Their files contain a second identification with the remaining parameters held at their nominal values. Position errors: RMS and maximum.
formulas-of-characteristics = characteristics: by ISO 9283:1998; only clause 7.2.2 was compared with the text of the standard
formulas-of-identification = frames and identification: weighted least squares, compared with the tables of a thesis on a PreXYT table and a five-bar robot (A. Joubair, ÉTS Montréal 2012, chapters 1 to 4)
formulas-of-uncertainties = uncertainties: after JCGM 100:2008 and JCGM 101:2008
frame-as-exported = the coordinates of the exports are in the world frame
frame-from-plane = xy plane: feature `{ $plane }`; origin: `{ $origin }`; { $axis } axis: `{ $from }` to `{ $to }`; other axis towards `{ $towards }`
frame-of-recording = frame of the recording
frame-of-reference-targets = frame of the tables at the first measurement of the reference targets
frame-of-tables = frame of the tables
frame-sentence = Frame of the positions: { $frame }.
frame-from-targets = best fit of the targets { $targets }: origin at the first target, x axis to the second, third in the xy plane
frame-from-targets-each = best fit of the targets { $targets }, measured again at every pose: origin at the first target, x axis to the second, third in the xy plane
frames-and-features = Frames and features
frames-of-poses = frames of poses
from = from
from-cycle-on = from cycle on
from-data = from the data
from-distance = from
from-in-unit = from ({ $unit })
from-nominal-value = mostly from the nominal value
from-pose = from pose
from-pose-named = from pose { $pose }
from-residuals = from the residuals (treated as independent)
from-residuals-by-pose = from the residuals, grouped by pose
from-residuals-by-region = of effective parameters, from the scatter between regions of the workspace{ $series ->
        [0] ; differences between set-ups are not included
       *[other] { " " }and between { $series } series; { $percent ->
            [0] no further difference is significant
           *[other] these contribute { $percent } % of the variances
        }
    }
from-the-instrument = from the stated uncertainty
gain-over-u = gain over u
generated-candidates = generated candidates
geometric = geometric
geometric-definition = thesis, chapter 2: each quantity is fitted to the points measured for it, without optimising the robot model; gamma, beta and epsilon_theta are set to zero; d3 is corrected for the leads of actuators 2 and 3. Uncertainties: computed from the points and propagated through all fits and frames; computed from the residuals if their scatter exceeds the instrument's given uncertainty. Errors: means of measured minus predicted pose, nominal and geometric, in the geometrically determined base frame
geometric-u-note = u (k = 1) includes the uncertainty of the base frame. All repeats share it, so their standard deviation excludes it.
geometric-u-without-angles = gamma, beta and epsilon_theta are taken as zero. u of s, d and d3 does not contain the shifts that these angles cause: they are neither identified, nor do all have a stated tolerance.
geometric-u-with-angles = gamma, beta and epsilon_theta are taken as zero. u of s, d and d3 contains the shifts that their identified values or stated tolerances cause (GUM F.2.4.5).
geometry-alone = Geometry alone
geometry-alone-title = Measurements of the geometric calibration
geometry-beside-identification = Geometric calibration compared with the identification
geometry-improvement = The largest mean position error decreases from { $nominal } mm to { $geometric } mm by geometry alone: a factor of { $improvement }.
guarded-acceptance = guarded acceptance (ILAC-G8:09/2019, 4.2.3)
guarded-acceptance-explained = pass if the value plus its expanded uncertainty U is within the limit; fail if the value minus U exceeds the limit; otherwise undecided
head-along = along
head-and = and
head-between = between
head-characteristic = characteristic
head-clause = clause
head-column = column
head-commanded = commanded
head-duration = duration
head-exchangeability = exchangeability
head-expanded-uncertainty = expanded uncertainty
head-family = family
head-frequency = frequency
head-hint = hint
head-labels = labels
head-meaning = meaning
head-passes = passes
head-refused = rejected
head-samples = samples
head-severity = severity
head-stroke = stroke
hash-without-backup = SHA-256 of `{ $file }` without its line `controller_backup`: the way back does not change the results.
head-u-by-angles = of which by angles
head-residual-over-u = residual over u
head-identified-minus-stated = identified minus stated
head-stated-value = stated value
head-stated-u = stated u (k = 1)
head-values = values
head-symbols = symbols
head-tested = this report
head-u-nominal = u of the nominal value
head-without-noise = without noise, 95 %
head-verified = evaluation verified by
head-what = what
held = held
held-by-the-campaign = held by the campaign
held-not-identifiable = held: not separately identifiable
held-singular-values = Diamonds: the { $count } smallest singular values with all parameters; the same number of parameters is held. Directions at or below the line ({ $cut } times the largest) are unobservable; directions slightly above it are hardly observable.
hint-label = hint:
histogram-description = Share of the points of each set in steps of { $step }.
histogram-shares = Share of each set in steps of { $step }: { $totals }.
histogram-tooltip = { $from } to { $to } { $unit }: { $points } points of { $set }, { $percent } %
how-changes-are-judged = Decision rule for changes
how-many-and-where = Number and locations of the positions
identification-against-geometry = With the same campaign, the identification of all parameters reduces the error to { $identified } mm; after the geometric calibration alone it is { $ratio } times as large.
identification-ended = The identification failed: { $reason }.
identified = identified
identified-max = identified, max
identified-minus-geometric = identified − geometric
identified-minus-nominal = identified minus nominal
identified-minus-nominal-in = identified minus nominal ({ $unit })
identified-minus-true = identified − true
identified-minus-true-in = identified minus true ({ $unit })
identified-rms = identified, RMS
import = Import
in-space = in space
index = index
index-value-of-poses = { $index } = { $value }, poses { $poses }
influential = influential
instrument = instrument
instrument-calibration = instrument's calibration
instrument-expanded-uncertainty = instrument's expanded uncertainty
instrument-good-enough = Suitability of the instrument
instrument-good-for-all = Suitable: the measurement uncertainty of positions is within 25 % of { $tested ->
        [repeatability] RP
       *[accuracy] AP and RP
    } at every pose.
instrument-good-for-none = Measurement uncertainty exceeds 25 % of { $tested ->
        [repeatability] RP at every pose: RP contains
       *[accuracy] AP or RP at every pose: where it exceeds 25 % of RP, RP contains
    } much noise of the instrument.
in-the-laboratory = in the laboratory
instrument-good-for-some = Measurement uncertainty exceeds 25 % of { $tested ->
        [repeatability] RP
       *[accuracy] AP or RP
    } at poses { $poor }; where it exceeds 25 % of RP, RP contains much noise of the instrument. Suitable at poses: { $good }.
left-out-feature = feature `{ $feature }`, measured without a redundant point
left-out-scale = scale of the measuring system (`expanded_scale_uncertainty_um_per_m`)
left-out-temperature = thermal expansion of robot and part ([expansion])
left-out-temperature-of-part = thermal expansion of the reference of the coordinates ([expansion])
moved-base = base
orientations-without-quarter-rule = The measurement uncertainty of orientations is not evaluated.
instrument-uncertainty = instrument's uncertainty
instrument-uncertainty-of-position = U = { $uncertainty } µm for a position
instrument-uncertainty-with-k = U = { $uncertainty } µm per coordinate (k = { $k })
instrument-uncertainty-without-k = U = { $uncertainty } µm per coordinate (coverage factor not given)
interval-95 = 95 % interval
interval-from = 95 % from
interval-of = interval of
interval-to = 95 % to
intervals-caption = Identified minus nominal. The line through a mark is ± 2u, often narrower than the mark. Values: see the table above.
intervals-description = One mark per identified parameter: identified minus nominal; line: ± 2u.
intervals-of-95 = 95 % intervals.
intervals-of-ratios-title = { $group }: change of the ratios, ± 2u
intervals-title = { $group }: change ({ $unit }), ± 2u
iso9283-characteristics = Results: performance characteristics (ISO 9283)
iso9283-report = Test report according to ISO 9283:1998: { $characteristics }
item-customer-traceability = Item, customer, traceability
joint-motion-explains-most = the parameters are no longer valid: a zero offset of { $by } (k = 2) at joint { $joint } explains { $percent } % of the deviation; the remaining residuals are larger than expected
joint-zero-moved = the zero of joint { $joint } has moved: true value minus logged value { $by } (k = 2)
joints = joints
kind = kind
knee-at = knee: { $count }
knee-caption = Knee: point of the curve with the largest height above the line from its first to its last value.
known-points = known points
known-values-note = Each counts like a reading. If no coordinate is measured, the lengths determine the scale.
known-values-title = Known lengths and positions
joint-value = joint value
laboratory = laboratory
lack-of-fit = Scatter of repeats: { $repeats } µm per coordinate ({ $degrees_of_freedom } degrees of freedom). Model error in addition to it: { $model } µm per pose (F test of lack of fit: { $probability }).
largest = largest
largest-displacement = largest displacement
largest-distance = largest distance
largest-error = largest error
largest-error-drawn = `max` is the error of the reading with the largest error. Each draw measures this reading again. The column "agree" contains "no" if the draws give the larger uncertainty.
largest-errors-drawn = The largest error at each of { $places } positions is drawn (total { $total } errors).
largest-errors-of-poses = Errors by pose, largest first
largest-mean-deviation-from-linear = largest mean deviation from linearity
largest-of-all-modes = largest of all working modes
largest-residual-of-a-coordinate = largest residual of a coordinate
last-set = { $symbol }, last set
last-cycle = last cycle
leads = Leads
left = remaining
left-out-errors = Errors at held-out poses
left-out-rms = held out, RMS
left-rms = remaining, RMS
length = length
limit = limit
limit-accuracy-max = largest pose accuracy AP
limit-band-value = The limit band is { $value } µm.
limit-contact-max = largest distance from a socket
limit-coordinate-max = largest coordinate error
limit-distance-max = largest distance error
limit-exceeded-sentence = Limit { $limit } µm exceeded.
limit-kept-sentence = Within the limit of { $limit } µm.
limit-margin = margin { $margin } { $unit }, risk of false acceptance { $risk } %
limit-margin-without-uncertainty = margin { $margin } { $unit }, uncertainty unknown
limit-met-sentence = The limit of the campaign is met.
limit-not-met-sentence = The limit of the campaign is not met.
limit-of = limit: { $quantity } { $value } { $unit }
limit-orientation-max = largest orientation error
limit-position-max = largest position error
limit-position-mean = mean position error
limit-position-rms = RMS position error
limit-repeatability-max = largest pose repeatability RP
limit-surface-max = largest distance from a surface
limit-undecided-sentence = Limit: { $limit } µm.
limited-error = { $quantity } at { $count } { $set } poses{ $readings ->
        [0] {""}
       *[other] {" "}({ $readings } readings)
    }: { $before } → { $after } { $unit }, limit { $limit } { $unit }: { $verdict }
limits = Limits
limits-all-met = All { $count } limits of the campaign are met.
limits-are-of-file = Judged with the values of `{ $file }`.
limits-by-interval = A value with an interval is judged by the ends of the interval instead of U.
limits-both-met = Both limits of the campaign are met.
limits-not-assessable = Not assessable (quantity not measured): { $limits }.
limits-not-met = { $count ->
    [one] 1 of { $total } limits of the campaign is not met.
   *[other] { $count } of { $total } limits of the campaign are not met.
}
limits-specification = specification of the limits
limits-undecided = Undecided (limit within the uncertainty): { $limits }.
line = line
line-number = line { $line }
load = load
load-centre = load centre (from the mechanical interface)
load-sentence = Load: { $load } kg.
log = log
logo-of-the-laboratory = Logo of the laboratory
manufacturer = manufacturer
margin = margin
max = max
max-after = max after
max-before = max before
mean = mean
mean-deviation-from-linear = mean deviation from linearity
mean-distance-from-barycentre = mean distance from the centroid
mean-distance-from-mean = mean distance from the mean position
mean-error = mean error
mean-error-named = Mean error: { $name }
mean-error-of-set = { $quantity } of { $set } poses, { $when }
mean-from-overall-mean = distance from the overall mean (µm)
mean-from-plane = mean position from the plane of the other three
mean-of = { $quantity } mean
mean-of-attained-positions = Mean of the attained positions.
mean-of-axis = mean { $axis }
mean-of-identifications = Mean of { $runs } identifications. Values: see the table above.
mean-plus-3s = mean + 3 s
mean-plus-3s-of-distance = mean + 3 s of the distance from the mean position (µm)
mean-positions = Mean positions
mean-positions-changed = The mean positions have changed. The cause is the robot or the determination of its frame.
mean-radius-plus-3s = mean radius + 3 s of the passes
mean-radius-three-s = mean radius + 3 s
mean-tooltip = mean { $approach }: x { $x }, y { $y }, z { $z } µm
mean-velocity = mean velocity
meaning-and-sign = meaning and sign
meanings-title = What the parameters mean
measured = measured
measured-minus-predicted-in = measured minus predicted ({ $unit })
measured-values = { $count } measured values (mm)
measurement-dates = date of the measurements
measurement-place = place of the measurements
measurement-point = measurement point
measuring-order = order of measurement
met = met
method = method
method-identification = identification of the kinematic parameters ({ $model }) by least squares
method-iso9283 = performance test according to ISO 9283:1998
method-iterations = { $method }, { $iterations } iterations;
minimum-posing-time = Minimum posing time
mode-count = { $count ->
    [one] 1 mode
   *[other] { $count } modes
}
model = model
model-and-residuals = Residuals are { $ratio } × the value expected from { $uncertainty }: { $fit ->
        [incomplete] the model is incomplete
        [correlated] the model leaves errors that readings of one pose share
        [doubtful] the model may be incomplete
        [lacking] the model lacks an effect that held-out poses confirm
       *[fits] the model fits
    } ({ $criterion }).
model-criterion = chi-square: { $p }, limit { $limit }
model-delta = delta robot
model-delta-linear = linear delta robot
model-five-bar = five-bar
model-hexapod = hexapod
model-of-the-robot = model of the robot
model-prexyt = PreXYT table
model-serial = serial arm
model-urdf = arm from a URDF file
more-in-annex = { $count ->
    [one] 1 further message: see the annex.
   *[other] { $count } further messages: see the annex.
}
more-warnings-and-remarks = More warnings and remarks
more-without-picture = { $count ->
    [one] 1 further quantity has no figure: see the tables.
   *[other] { $count } further quantities have no figure: see the tables.
}
motion = motion
mounting = mounting
moved = moved
movement = movement
movement-of-the-set-up = Movement of the set-up
moves = moves
multiples-description = { $plane }, about the centroid; the scale is the same for all poses (half width { $half } µm). { $count } of { $total } poses.
multiples-title = Visits of the poses
name = name
name-date-signature = name, date, signature
named-from = named from
naming-probability = Probability that the moved joint is identified: { $percent } %.
needed = needed
next-step = next step { $number }
next-steps = Next steps
no = no
no-certificate-stated = no certificate is given
no-correlated-pairs = No pair has a correlation of 0.9 or more.
no-error-to-draw = No errors to plot.
no-errors-are-given = The document contains no errors.
no-messages = None.
no-messages-but-routine = None that limits the results. The annex of the report contains { $count ->
        [one] one further remark
       *[other] { $count } further remarks
    }.
no-noise-stated = no noise given
no-quantity-changed = Significant changes: 0 of { $total } quantities of the robot.
no-significant-change = no significant change
no-significant-change-sentence = No significant change.
no-trend-pictures = { $others ->
        [yes] Errors versus the other joint values and distances
       *[no] Errors versus joint values and distance
    }: no significant trend
no-uncertainty-is-known = the uncertainty is unknown
noise = noise
noise-of-reading-x = noise of a reading, x
noise-of-reading-y = noise of a reading, y
noise-of-reading-z = noise of a reading, z
nominal = nominal
nominal-lead = nominal lead
nominal-max = nominal, max
nominal-minus-identified = nominal minus identified
nominal-parameters = nominal
nominal-rms = nominal, RMS
nominal-values = nominal values
none = none
norm = norm
normal-quantile = quantile of the normal distribution
not-accepted = not accepted
not-assessable = not assessable
not-by-these-poses = not observable with these poses
not-conforming = not conforming
not-controlled-by-the-data = Errors that the data cannot detect
not-detectable = not detectable
not-identifiable = not identifiable
not-judged-by-misfit = not judged: the model does not fit
not-known = unknown
not-met = not met
not-run = not run
not-stated = not stated
nothing-to-load = { $answer ->
        [keep_nominal] the identified parameters are not clearly better than the nominal ones
        [identify_further] with further effects, errors at held-out poses are more than 5 % smaller
       *[resolve] the verdict allows no file to be loaded
    }
not-stated-items = Not stated, besides the fields to complete before signing: { $items }.
notes = notes
nothing-held = No parameter is held: the distance of each column from the span of the others exceeds the rank cut of { $cut }.
nothing-to-verify = nothing to verify
number = number
numbers-of-arrows = Values of the { $count } arrows
numbers-of-the-curve = Values of the curve
numbers-of-this-picture = Values of this figure
observability = Observability
observability-scaling = O1 to O5: unweighted Jacobian (mm per mm, rad and 1); condition number: columns scaled to unit norm
observability-scaling-eliminated = O1 to O5: unweighted Jacobian (mm per mm, rad and 1); condition number: columns scaled to unit norm; { $parameters } parameters, after elimination of the { $coordinates } coordinates of unknown points
observations = observations
off-the-line = distance from the line
one-after-the-other = one after the other
one-scale = common scale
operator = operator
operator-sheet = Operator’s sheet
operator-sheet-before = Before the first pose
operator-sheet-note = Joint values are in the units of the controller (deg, mm). Tick each pose when its points are stored under its label.
operator-sheet-poses = Poses in the order of measurement
order-of-poses = { $poses } ({ $percent } % of the joint motion needed for the order of their names)
order-of-the-measurement = order of measurement
orientation = orientation
orientation-after = after, orientation
orientation-after-max = orientation after, max
orientation-before = before, orientation
orientation-before-max = orientation before, max
orientation-error-by-pose = Orientation error by pose, before and after calibration
orientation-error-in = orientation error ({ $unit })
orientation-max = orientation, max
orientation-title = Orientation
origin-in-the-exports = origin in the exports
other-planes = Further views
other-pose = other pose
outliers-note = Coloured numbers: outliers (modified z-score above 3.5; Iglewicz and Hoaglin, 1993). Reference: the campaigns of the same robot, or of robots of the same kind if the robot has fewer than eight.
outliers-then-largest-errors = Errors by pose: outliers first, then the largest
overshoot = overshoot
overshoot-co = overshoot CO
own-scale-of-each = individual scales
p-of-family = p of the family
p-value = p value
page-of = page { $page } of { $total }
pairs = pairs
parameter = parameter
parameter-errors-description = One bar per parameter: identified minus true.
parameter-errors-title = Errors of the identified parameters ({ $unit })
parameter-named = Parameter { $name }
parameters = parameters
parameters-implausible = These parameters are implausible for the robot: do not load them.
parameters-left-out = omitted parameters
one-pose-deviates = one pose contradicts the parameters (`{ $pose }`); without it they are valid
parameters-no-longer-valid = the parameters are no longer valid; no motion of the base, of a single joint or of a single target explains the deviation
parameters-note = u: standard uncertainty (k = 1); U = 2u: expanded uncertainty. Values are rounded to the second digit of u. “Before”: only base and targets are fitted. Change: identified minus nominal.
parameters-of-robot = Parameters of the robot
parameters-of-set-up = Parameters of base and targets
parameters-of-the-answer = of the answer
parameters-of-the-run = of the run
parameters-still-valid = the parameters are still valid for these poses
parameters-title = Parameters
pass = pass
path = path
path-accuracy-at = path accuracy AT
path-accuracy-at-reorientation = path accuracy AT on reorientation
path-accuracy-title = Path accuracy AT
path-passes = { $length } mm, { $passes } passes
path-passes-incomplete = { $length } mm, { $passes } passes, { $incomplete } incomplete
path-repeatability-rt = path repeatability RT
path-repeatability-title = Path repeatability RT
path-velocity = path velocity
path-length = path length
percent-of-rated = { $percent } % of the rated velocity
perhaps-changed = uncertain, measure again: residuals of an unchanged robot are as large in { FIXED($percent, 1) } % of all verifications. Best explanation: { $meaning }
permissible = permissible
permissible-over-certificate = permissible / certificate uncertainty
picture-marks = Circles: calibration poses; diamonds: validation poses. Point at a mark to read its pose, cycle, target and error; a click marks the pose in all figures. Values: see the tables.
picture-page-command = `etalon view FOLDER --export view.html` writes a page that shows the errors in three dimensions and opens without the program.
picture-selection = Of many errors, figures show the largest of each pose after calibration: validation poses first, and an even selection of calibration poses.
pictures = Figures
pictures-of-thesis = Figures (thesis, figures 4.8 and 4.9)
place-of-the-base = Position of the base
placed-by-validation-poses = located by validation poses
places-of-the-targets = Positions of the targets
plan-better-than = poses { $poses }: { $value } (the plan is { $percent } % better)
plan-for-model = Calibration plan: { $model }
plane = plane
plane-named = { $plane } plane
platform-as-measured = platform centre (from the balls)
platform-centre = platform centre C
platform-in-base = the platform centre C in the base frame
plot-ap-rp = AP and RP of each pose in mm
plot-changes = Change of each parameter over its standard uncertainty
plot-errors-by-pose = Largest position error of each pose in mm
point = point
point-error-in-common = the instrument's error at a point is common to all observations of the point
point-in-flange = the point { $point } mm in the flange frame
point-in-platform = the point { $point } mm in the platform frame
point-in-targets = the point { $point } mm in the target frame
points = points
points-drawn = { $drawn } of { $total } points are drawn: an even selection that includes the largest error in this plane.
points-of = { $set } points
pose = pose
pose-accuracy-ap = Pose accuracy AP
pose-and-visit = pose { $pose }, visit { $visit }
pose-conforms = pose { $pose } conforms
pose-coordinates = { $count } pose coordinates (mm and rad)
pose-named = pose { $pose }
pose-repeatability-rp = Pose repeatability RP
pose-tooltip = pose { $pose }: x { $x }, y { $y }, z { $z } mm
poses-and-cycles = poses and cycles
poses-and-visits = { $poses } poses, { $visits } visits each
poses-conform = { $count ->
    [one] 1 of { $total } poses conforms
   *[other] { $count } of { $total } poses conform
}
poses-not-conforming = { $count ->
    [one] pose { $poses } does not conform
   *[other] poses { $poses } do not conform
}
poses-of-the-test = Test poses
poses-that-decide = Decisive poses
poses-title = Poses
poses-to-measure = Poses to measure
poses-to-measure-named = Poses to measure: { $poses }.
poses-to-verify-identified-parameters = Poses for the verification of identified parameters
poses-undecided = { $count ->
    [one] pose { $poses } is undecided
   *[other] poses { $poses } are undecided
}
posing-time = posing time
position = position
position-after-max = position after, max
position-after-mean = position after, mean
position-before-max = position before, max
position-before-mean = position before, mean
position-error-after = Position error after calibration, { $plane }
position-error-against = Position error after calibration versus { $quantity }
position-error-before = Position error before calibration, { $plane }
position-error-by-pose = Position error by pose, before and after calibration
position-error-in = position error ({ $unit })
position-max = position, max
position-residuals-before-rms = position residuals before identification, RMS
position-residuals-expected-rms = position residuals expected from the stated uncertainties, RMS
position-residuals-explained = Position residuals: RMS { $rms } { $unit }; expected from the stated uncertainties: { $expected } { $unit }.
position-residuals-rms = position residuals, RMS
position-rms = position, RMS
positions = positions
preconditions-column = Reservations
predicted-target-uncertainty = predicted uncertainty of the target positions over the candidates (k = 1)
predicted-u = predicted u (k = 1)
predicted-uncertainty-title = Predicted uncertainty of the parameters
prediction-behind = If cells overlap, the cell with the largest value is drawn.
prediction-description = One cell every { $spacing } mm in the base frame, within the region of the calibration poses. Colour from 0 to { $colour }, same scale for both figures; largest value { $largest }.
prediction-difference-title = Tool point: nominal minus identified model, { $plane } plane
prediction-expected-title = Tool point: expected error with the identified parameters, { $plane } plane
prediction-map-definition = { $error }; nominal minus identified: difference between the positions predicted by the two parameter sets; expected: magnitude (k = 1) from the covariance of the parameters, the tolerance of parameters that the data cannot determine, the model error beyond the instrument's uncertainty, and the position of the point on the tool; p95_mm: upper limit of 95 % of the errors at a node, for normally distributed errors (Box 1954)
prediction-own-scale = One cell every { $spacing } mm in the base frame, within the region of the calibration poses. Colour from 0 to { $colour }, scale of this figure only; largest value { $largest }.
prediction-tooltip = x { $x }, y { $y }, z { $z } mm: nominal minus identified { $difference }; expected { $expected } (k = 1), 95 % within { $largest }
probability-by-chance = p value
probability-of-errors = Probability of errors this large, given the uncertainty of parameters and measurement: { $probability }.
projected-into-xy = projected into the xy plane
proven-effects = Effects confirmed at held-out poses
provenance = Provenance
quantile-95 = 95 %
quantiles-description = Sorted residuals against the quantiles of a normal distribution; line: normal noise.
quantities-changed = Significant changes: { $changed } of { $total } quantities of the robot: { $names }.
quantity = quantity
quantity-at = { $quantity }, { $place }
quantity-in-unit = { $quantity } ({ $unit })
quarter-rule = 25 % rule
radius = radius
range = { $from } to { $to }
readings-give = readings: { $values }
readings-of-set-give = { $set ->
        [validation] validation
       *[calibration] calibration
    } readings: { $values }
reference-temperature = model refers to { $value } °C
rank = rank
rank-cut = rank cut { $value }
ratio = ratio
reached = reached
read-as = read as
reading-uncertainty = { $uncertainty } mm (k = 1) per reading
reading-uncertainty-with-k = U = { $uncertainty } µm per reading (k = { $k })
reading-uncertainty-without-k = U = { $uncertainty } µm per reading (coverage factor not given)
readings = readings
readings-not-judged = { $target } ({ $readings } readings, redundancy { $redundancy }: not judged)
readings-redundancy = { $target } ({ $readings } readings, redundancy { $redundancy })
readings-scatter-more = the readings scatter { FIXED($ratio, 2) } times as much as expected; no motion of the base, of a single joint or of a single target explains this
reason = reason
recommend-file = load `{ $file }` of the run: { $load } of { $count } parameters, with their identified values; the others stay at nominal
recommend-further = load nothing yet: first identify { $effects }, which reduce the errors at held-out poses
recommend-nominal = load nothing: keep the nominal parameters. At new poses, the identified ones are not clearly better
recommend-parameters = load the identified parameters of the run: { $load } of { $count }; the others stay at nominal
recommend-resolve = load nothing yet: the verdict allows no file to be loaded. Follow the next steps of the run first
recommendation-title = Recommendation of parameters to load
recorded = recorded
recorded-motion = Recorded motion
recording-begins-at-pose = The recording begins at pose { $pose }: its first standstill has no arrival and no move.
reference-targets = Reference targets
refused = rejected
refused-rows = { $refused } of { $total } rows rejected
region-note = Ranges of the values at the measured poses. The results apply within the ranges of the calibration.
region-of-c = region of C, in the base frame
region-of-orientation = orientation { $orientation } deg
region-of-orientations = every orientation from { $from } to { $to } deg
region-of-readings = The errors apply to these values of the calibration readings: { $values }.
region-of-validity = Region of validity
relative-accuracy = Relative accuracy: distances between { $set } poses
relative-accuracy-note = Predicted minus measured distance of one target between two poses. The base has no effect on these errors; the target has none if both poses have the same orientation. U (k = 2): instrument, frames and targets. The parameters are under test, so their uncertainty is not included.
relative-accuracy-selection = The statistics use an even selection of { $pairs } of { $available } pairs; the maximum is the maximum of this selection.
relative-error = relative error
relative-humidity = relative humidity
relaxation-alone = relaxation alone
reliability-note = Reliability (Baarda 1968; significance level { $significance } %, power { $power } %). Smallest detectable error of a coordinate: median { $median }, worst reading { $largest }; smallest redundancy { $redundancy }. Readings with a residual above { $factor } standard deviations: { $beyond } of { $readings }.
repeatability = repeatability
repeatability-at-pose = Largest pose repeatability RP: { $repeatability } µm, at pose { $pose }.
repeatability-from-one-approach = { $approaches ->
        [one] Repeatability for the only approach of pose { $pose } that has several visits: { $largest } µm; all approaches together: { $together } µm.
       *[other] Repeatability for a single approach at pose { $pose } ({ $approaches } approaches): { $smallest } to { $largest } µm; all approaches together: { $together } µm.
    }
repeatability-over-cycles = Pose repeatability of each pose during the test.
repeatability-title = Repeatability
repeats = repeats
report = report
report-element = element
report-homing = homing
report-number = report number
report-poses = poses
reservation-drift = AP changed by up to { $change } µm from the first to the last set, and stabilisation is not shown at { $count ->
        [one] pose { $poses }
       *[other] poses { $poses }
    } (ISO 9283, 7.6)
reservation-few-cycles = fewer than { $required } cycles at { $count ->
        [one] pose { $poses }
       *[other] poses { $poses }
    }
reservation-errors-unknown = root-mean-square position error { $calibration } at calibration poses, { $left_out } at held-out ones: calibration poses do not show the errors at other poses
reservation-file-hardly-better = the controller file for { $formats } brings no significant improvement over the nominal parameters: RMS { $rms } mm (nominal { $nominal_rms } mm), largest error { $max } mm (nominal { $nominal_max } mm)
reservation-file-not-written = at least one controller file was not written (see the messages)
reservation-given-refused = the parameters must not be used: they are worse than nominal parameters at the measured poses, or belong to another robot
reservation-hardly-better = the identified parameters are not significantly better than nominal parameters: RMS { $rms } mm (nominal { $nominal_rms } mm), largest error { $max } mm (nominal { $nominal_max } mm)
reservation-instrument-too-coarse = the measurement uncertainty exceeds 25 % of the verified value at { $count ->
        [one] pose { $poses }
       *[other] poses { $poses }
    } (ISO 9283, clause 6)
reservation-model-does-not-fit = residuals are { $times } × the stated uncertainty of the readings: the model does not fit, and { $set ->
        [calibration] errors at other poses may be larger than at the calibration poses
       *[validation] the errors at the validation poses apply
    }
reservation-set-up-untested = { $count ->
        [one] one mistake of the set-up is
       *[other] { $count } mistakes of the set-up are
    } not tested by the measurements, and could change the position of the flange by up to { $flange_mm } mm and { $flange_deg } deg
reservation-no-warm-up = the robot was not warmed up before the test
reservation-open-warnings =
    { $count ->
        [one] a warning is unresolved: { $warnings }
       *[other] warnings are unresolved: { $warnings }
    }
reservations = Reservations: { $reasons }.
residual-field = Residual field
residual-over = residual over σ
residuals = residuals
residuals-against-normal = Residuals of the calibration poses against a normal distribution
residuals-by-pose = Residuals by pose after calibration
residuals-by-pose-description = One mark per pose, cycle, target and axis.
residuals-max = residuals, max
residuals-over-uncertainty = residuals over their stated uncertainty, √(χ²/ν)
residuals-pattern = Residuals with a pattern are not noise: the model is incomplete.
residuals-rms = residuals, RMS
residuals-summary = { $count } residuals, mean { $mean }, standard deviation { $deviation }; line: noise alone.
residuals-title = Residuals
results-before-and-after = Results: errors before and after
results-of-external-providers = results of external providers
results-relate-to-item = These results relate only to the item tested.
results-with-uncertainty = Errors after calibration with their uncertainty
rigid-parts = rigid parts
risk = risk
risk-without-coverage = The risk of false acceptance is not given for AP: AP drifts, so its interval is not a coverage interval.
rms = RMS
rms-after = RMS after
rms-and-largest = RMS { $rms } µm, largest { $largest } µm
rms-and-max = RMS and max
rms-and-max-values = { $rms } and { $max }
rms-before = RMS before
rms-expected = { $value } { $unit }, expected from instrument, parameters and model error { $expected } { $unit }
rms-of = { $quantity } RMS
rms-ratio = RMS ratio
rms-with-it = RMS with the effect
rms-without-it = RMS without the effect
robot = robot
robot-changed-as-a-whole = The robot's parameters changed significantly as a whole; no single quantity changed significantly.
robot-changed-together = Campaign { $to } versus { $from }: the { $parameters } parameters of the robot changed significantly as a whole (F = { $f } with { $parameters } and { $degrees_of_freedom } degrees of freedom, { $probability }).
robot-column = Robot
robot-instrument-conditions = Robot, instrument, conditions
robot-of-model = Robot: { $model }
robot-of-name = Robot { $name }
robot-unchanged-together = Campaign { $to } versus { $from }: the { $parameters } parameters of the robot did not change significantly as a whole (F = { $f } with { $parameters } and { $degrees_of_freedom } degrees of freedom, { $probability }).
robust = robust
robust-fit = Robust fit
robust-fit-agrees = The robust fit agrees with the least-squares fit. Largest difference: { $parameter }, { $difference } standard uncertainties of the difference (expected by chance: { $chance }).
robust-fit-difference = The robust fit differs from the least-squares fit. Largest difference: { $parameter }, { $difference } standard uncertainties of the difference (expected by chance: { $chance }).
robust-fit-note = Readings far from the others have a low weight (Cauchy loss, c = { $c } σ with σ = { $sigma } µm; Holland & Welsch 1977). Difference: robust minus least-squares value. Its standard uncertainty is the larger of two estimates: from normal residuals, and from the scatter of the poses. The table lists the parameters with the largest differences.
robust-fit-poses = Poses with a residual above { $factor } σ, inconsistent with the others: { $poses }.
round-off-cr = round-off CR
routine-remarks = Further remarks
rows = rows
rows-in-frame = { $count } rows: scroll in the table.
rows-in-workbook = { $count } more rows: see the workbook.
rp-along-x = RP along x
rp-along-y = RP along y
rp-along-z = RP along z
rp-by-set = RP by set
rp-circle = radius: mean distance + 3 s
rp-circle-tooltip = pose { $pose }: { $text }
rp-in-plane = RP in x, y
rp-of-judged-approach = RP of the judged approach
scatter-of-all-visits = all visits: { $distance } µm
rp-interval-from = RP, 95 % from
rp-interval-to = RP, 95 % to
rp-within-limit = RP within its limit
rp-without-noise = RP without noise
rt-interval-from = RT, 95 % from
rt-interval-to = RT, 95 % to
rt-location = RT at
rt-of-angles = RT of the angles (deg)
rule-not-stated = { $rule } (default; the campaign states no rule)
samples-in-seconds = { $samples } samples in { $seconds } s
scale = scale
scale-bars = Scale bars
scaling-label = Scaling:
seed = seed
serial-number = serial number
series-agree = With these poses, the differences between the { $series } series are not significant.
series-differ = On average, differences between the { $series } series contribute { $percent } % of the variances of the parameters.
set = set
set-of-cycles = set of cycles
set-summary = { $set }: { $poses } poses, { $errors } errors
set-summary-of = { $set }: { $poses } poses, { $errors } errors of { $point }
set-up-changes = Base and targets: { $changed } of { $total } quantities changed (expected for a new set-up).
set-up-corrected = The set-up moved by up to { $moved } (largest displacement of a fixed target since its first measurement). Positions were corrected in { $steps ->
        [one] one step
       *[other] { $steps } steps
    }; the remaining displacement of the targets is at most { $left } (RMS).
set-up-parameter-named = Parameter { $name } (base or target)
sets = sets
settled-after-set = stabilised after set
severity-error = error
severity-warning = warning
share-of-points = share (%)
share-of-set = share of the set (%)
shared-risk = shared risk (JCGM 106:2012, 8.2.1)
shared-risk-explained = pass if the value is within the limit; undecided if U exceeds a quarter of the limit
sheet-all-together = All together
sheet-approach = approach from
sheet-approach-above = { $joint } above
sheet-approach-below = { $joint } below
sheet-between-series = Between series
sheet-budget-of-errors = Budget of errors
sheet-budget-of-orientations = Budget of orientations
sheet-cell-frames = Frames
sheet-cell-residuals = Cell residuals
sheet-clauses = ISO 9283 clauses
sheet-controller-values = Controller values
sheet-corners = Corners
sheet-correlation = Correlation
sheet-covariance = Covariance
sheet-detectable = Detectable changes
sheet-distributions = Distributions
sheet-distributions-of-errors = Distributions of errors
sheet-done = done
sheet-errors = Errors
sheet-frames = Frames
sheet-geometry-balls = Geometry, balls
sheet-geometry-fits = Geometry, fits
sheet-geometry-leads = Geometry, leads
sheet-geometry-methods = Geometry, methods
sheet-geometry-poses = Geometry, poses
sheet-geometry-quantities = Geometry, quantities
sheet-geometry-scale-bars = Geometry, scale bars
sheet-geometry-workspace = Geometry, workspace
sheet-influence-of-poses = Influence of poses
sheet-inputs = Inputs
sheet-instrument-at = instrument at (mm, base of the robot)
sheet-iso9283-approaches = ISO 9283 approaches
sheet-iso9283-compliance = ISO 9283 compliance
sheet-iso9283-distances = ISO 9283 distances
sheet-iso9283-drift = ISO 9283 drift
sheet-iso9283-places = ISO 9283 mean positions
sheet-iso9283-poses = ISO 9283 poses
sheet-iso9283-reference-targets = ISO 9283 reference targets
sheet-iso9283-robot = ISO 9283 robot
sheet-iso9283-variation = ISO 9283 variation
sheet-iso9283-visits = ISO 9283 visits
sheet-label = label
sheet-known-values = Known values
sheet-messages = Messages
sheet-moved-values = Moved values
sheet-not-a-number = not a number
sheet-not-controlled = Undetectable
sheet-number = no.
sheet-operator-date = date, operator
sheet-packages = Packages
sheet-parameter-effects = Parameter effects
sheet-path = Path
sheet-posing = Posing
sheet-predicted-errors = Predicted errors
sheet-program = program
sheet-program-value = { $file } ({ $language })
sheet-proven-effects = Supported effects
sheet-reference-data = Reference data
sheet-reflector-at = reflector { $name } at (mm, flange)
sheet-reflector-axis = { $at }; axis { $axis }, within { $angle }° of the instrument
sheet-refused-rows = Rejected rows
sheet-readings = Readings
sheet-relative-accuracy = Relative accuracy
sheet-requirements = Requirements
sheet-robust-fit-poses = Robust fit, poses
sheet-rows-left-out = { $count ->
    [one] 1 more row is not shown: the documents contain it
   *[other] { $count } more rows are not shown: the documents contain all rows
}
sheet-singular-values = Singular values
sheet-slips = Seeded faults
sheet-stabilisation = Stabilisation
sheet-standstills = Standstills
sheet-step = step
sheet-step-frame = The points of the world frame and of the reference targets are measured. They are measured again after the last pose.
sheet-step-instrument = The instrument is warmed up, levelled and checked as its manufacturer requires. Its position agrees with the position above.
sheet-step-reflectors = The reflectors are at their positions, tight, and clean.
sheet-step-slow = All poses were reached once at low speed: there are no collisions, the cables are long enough, and the line of sight is free.
sheet-step-zero = On the display of the controller, the joint values of the first pose agree with this sheet.
sheet-streams = Streams
sheet-study-parameters = Study, parameters
sheet-study-positions = Study, positions
sheet-summary = Summary
sheet-temperature = air temperature at start and end (°C)
sheet-tests = Tests
sheet-tool-point = Tool point
sheet-trends-of-residuals = Trends of residuals
sheet-values = Values
sheet-wait = waiting time at each pose
sheet-wait-seconds = { $seconds } s
sheet-wait-trigger = { $seconds } s; output { $output } is on during the second half
sheet-way-back = Test after loading
sheet-without-partner = Without partner
should-know = Should know
show = Show
show-all-rows = Show all rows
show-more = Show more
signatures = Signatures
significant-changes = Significant: { $campaigns }.
simple-acceptance = simple acceptance (ILAC-G8:09/2019, 4.2.1)
simple-acceptance-explained = pass if the value is within the limit; the risk of a false acceptance is shared, and given for each limit
simulated-calibration-note = Synthetic: Gaussian noise of { $noise } µm on each coordinate; mean of { $identifications } identifications. Parameters and figures show one of these means. Errors by number of positions are medians of { $medians }. Errors refer to { $point }, evaluated over { $configurations } configurations.
simulated-calibration-title = Simulated calibration
single-balls = Single balls, measured repeatedly
singular-value = singular value
singular-value-number = number of the singular value
singular-value-scaled = singular value (columns divided by their norms)
singular-values-caption = Singular values of the Jacobian at the solution, columns scaled to unit norm as in the identification: rank { $rank }, condition number { $condition } (largest over smallest circle).
singular-values-description = One mark per singular value, in descending order, on a logarithmic axis. Large: well observable; small: poorly observable.
singular-values-title = Singular values of the identification
sketch-title = The model and its parameters
skipped = skipped
smallest-sphere-and-circle = radius of the smallest enclosing sphere and circle (µm)
solver = Solver
solver-gradient-vanished = converged: the residuals are orthogonal to the Jacobian
solver-iteration-limit = not converged within the permitted iterations: check the starting values
solver-no-start = no starting value of the search led to an element
solver-not-finite = stopped: a residual is non-finite; check the starting values and the data
solver-rank-deficient = stopped: some parameters are not separately identifiable; hold one of them
solver-residuals-zero = converged: the residuals are zero within rounding
solver-rounding = converged to rounding: no shorter step reduces the residuals
solver-step-vanished = converged: the last step left the parameters unchanged
solver-too-few-equations = stopped: fewer equations than parameters; measure more poses or hold parameters
source-backup = controller file before loading
source-contact-meaning = stated uncertainty of a contact with a socket, a surface or a measured point
source-encoders-meaning = stated uncertainty of encoders at the links
source-frame-meaning = points that define the world frame (common to all poses)
source-frame-of-poses-meaning = points of the frame that is measured again at each pose
source-homing-meaning = joint values after homing (common to all poses)
source-instrument-meaning = stated uncertainty of each reading of the instrument
source-single-coordinates-meaning = stated uncertainty of readings of one coordinate, such as readings of a dial gauge
single-coordinates = single coordinates
source-known-points-meaning = given positions and lengths of fixed points
source-model-meaning = model error: part of the residuals that no other source describes
source-nominal-values-meaning = tolerances of the nominal parameter values
source-repeatability-meaning = scatter of the repeats of a pose in excess of the instrument's uncertainty
source-residuals-meaning = scatter of the residuals (no uncertainty is given)
source-rigid-parts-meaning = given shapes of the parts that carry targets
source-scale-meaning = scale of the measuring system (common to all lengths)
source-temperature-meaning = thermal expansion of robot and part (common to all lengths)
sources-of-the-formulas = Sources of the formulas
sphere-x-y-z = sphere x, y, z
spheres-and-conventions = Enclosing spheres and conventions
stabilisation-and-overshoot = Stabilisation and overshoot
stabilisation-path-length = stabilisation path length
stabilisation-time = stabilisation time
straight-distance = straight distance
stability = stability
standard-deviation = standard deviation
standstills = standstills
state-of-the-robot = state of the robot
stated-tolerance = stated tolerance
stated-uncertainty = stated uncertainty
static-compliance = Static compliance
status = status
step-arc = arc of ball { $ball } about { $about }
step-plane-of-rails = plane of the rails
step-shaft = shaft, repeat { $repeat }, position { $position }
step-travel = travel of actuator { $actuator }
stream = stream

sum-of-squares-tested = χ² = { $sum } at { $degrees } degrees of freedom, { $p }

template = template

surface = surface
synthetic-data = synthetic data
synthetic-data-label = Synthetic data:
synthetic-mark = SYNTHETIC DATA
table = table
target = target
target-coordinates = { $count } target coordinates (mm)
target-motion-explains-most = the parameters are no longer valid: a movement of target { $target } by { $by } (k = 2) explains { $percent } % of the deviation; the remaining residuals are larger than expected
target-moved = target { $target } has moved on its part by { $by } (k = 2)
target-movement-caption = Largest movement of a target since its first measurement, and RMS of the remaining displacement.
target-named = the target { $target }
targets-as-measured = measured targets
targets-from-their-places = distance of the targets from their reference positions
targets-in-world = the targets in the world
targets-placed-by-validation = No calibration pose measures { $targets }. Its position is computed from readings at the validation poses, with the identified parameters of the robot held. Each of these errors is divided by √r (r: redundancy). U is computed from the other readings.
temperature = temperature
temperature-range = { $lowest } °C to { $highest } °C in the exports
temperature-of-robot = temperature of the robot
torques-of-joints = torques of the joints
test-certificate = Test certificate
test-certificate-draft = Draft of a test certificate
test-cube = P1 is the centre of a cube of { $size } mm, P2 to P5 are on the diagonals of the test plane (ISO 9283:1998, 6).
test-of-changes = residuals that base or joints can cause
test-of-rest = all other residuals
test-of-synthetic-data = Test with synthetic data, not a certificate
test-square = P1 is the centre of a square of { $size } mm, P2 to P5 are on its diagonals (ISO 9283:1998, 6).
tested-by = Tested by
text = text
texts-of-campaign-note = Texts from the campaign are not translated.
the-campaign-fits-no-features = The campaign has no fitted features.
the-campaign-states-no-limits = There are no limits, so no verdict is possible.
their-standard-deviation = standard deviation
this-file-max = this file, max
this-file-rms = this file, RMS
three-s-of-x = 3 s of x
three-s-of-y = 3 s of y
three-s-of-z = 3 s of z
time-in-s = time (s)
time-since-entry = time since entry (s)
times-for-each-cycle = { $count } times, once per pose and cycle
to = to
to-complete-count = To complete before signing: { $count ->
        [one] one field
       *[other] { $count } fields
    }
to-distance = to
to-hold = to hold
to-load = to load
to-load-later = to load later
to-pose = to pose
tolerance = tolerance
tool-error-definition = { $error }; nominal minus identified: difference between the positions predicted by the two parameter sets; expected: magnitude (k = 1) from the covariance of the parameters, the tolerance of parameters that the data cannot determine, the model error beyond the instrument's uncertainty, and the position of the point on the tool; the target errors exclude parameters that shift targets and tool alike
tool-point-expected = Expected error, RMS (k = 1): parameters { $parameters } µm; parameters that the data cannot determine (tolerance) { $undetermined } µm; model error { $model } µm; position of the point on the tool { $point } µm. Largest expanded uncertainty of a pose (k = 2): { $largest } µm.
tool-point-headline = tool point, RMS: nominal minus identified → expected
traceability = traceability
trend = trend
trend-description = One mark per campaign with its 95 % interval; diamonds: significant change.
trend-in-picture = Unmodelled trend ({ $probability }).
trend-of = Trend of
trend-of-all-quantities = Unmodelled trend of all measured quantities together ({ $probability }).
trends-note = F tests of the mean errors of the calibration poses after identification: parabola versus constant; p values corrected for multiple tests (Holm 1979). A trend is an error that the model does not describe.
trends-of-the-residuals = Trends of the residuals
trends-suggest-field = The residuals still show a trend: `field = true` in [identify] searches for a residual field.
true = true
turn-down = Turn down
turn-left = Turn left
turn-right = Turn right
turn-up = Turn up
type = type
u-allowed = U allowed
u-bootstrap = u, bootstrap
u-draws = u, draws
u-linear = u, linear
u-of-deviation = u of the deviation (k = 1)
u-of-identified = u of identified
u-of-position = U of a position
u-over-ap = U over AP
u-over-rp = U over RP
u-over-value = U over value
u-report = u, report
uncertainties = uncertainties
uncertainties-enlarged-by = uncertainty inflation factor
uncertainties-of-robot = Uncertainties of robot { $robot }
uncertainty-by-default-tolerances = For these, the program uses its default tolerance, multiplied by { $factor }, the factor that agrees best with the data.
uncertainty-by-tolerances = Values whose remaining uncertainty comes mostly from tolerances of nominal values, their own or others ({ $count }): { $names }. Tolerances among them that are defaults of the model: { $default }.
uncertainty-budget = Uncertainty budget
uncertainty-for-outliers = ± { $uncertainty } µm per coordinate ({ $factor } standard deviations), independent for each observation
uncertainty-inflation = { $factor } × the value from { $beside ->
        [instrument] the stated uncertainty alone
       *[residuals] independent residuals
    } (median)
uncertainty-of-instrument = the instrument's standard uncertainty
uncertainty-of-instrument-and-contact = the standard uncertainty of instrument and contact
uncertainty-of-readings = the stated standard uncertainty of the readings
uncertainty-of-rp = Uncertainty of RP
undecided = undecided
unit = unit
unjudged-by-misfit = Not judged because the model does not fit: { $count }.
unjudged-without-uncertainty = Not judged because the uncertainty is unknown: { $count }.
unknown-without-redundancy = unknown (equal numbers of equations and parameters)
unshown-frame-points = errors of the points that define the world frame: without redundancy, they only move the frame
unshown-frame-targets = position errors of the targets that define the world frame: their measured positions are the reference
unshown-scale = a common factor of all measured lengths: absorbed by the lengths of the robot
unshown-shift = a shift or rotation common to all readings: absorbed by the base
valid-until = valid until
valid-until-agreed = valid until, as agreed with the customer
valid-until-column = Valid until
validation = validation
validation-of-given-parameters = Validation of given parameters
value = value
value-and-limit = { $quantity } { $value } { $unit }, limit { $limit } { $unit }
value-tooltip = { $name }: { $value } ± { $uncertainty } { $unit }
value-with-interval = { $value } µm (95 %: { $low } to { $high })
values-by-nominal = { $count ->
        [one] 1 value comes mostly from its nominal value, because the data hardly determine it: { $names }.
       *[other] { $count } values come mostly from their nominal values, because the data hardly determine them: { $names }.
    }
values-given = before: nominal robot parameters, with the base and targets that the earlier calibration fitted to them; after: all parameters as given, including base and targets; nothing is fitted to these data
values-given-prior = before: nominal robot parameters, with base and targets fitted to the calibration poses; after: all parameters as given, with base and targets estimated from their given covariance and the calibration poses (most probable values)
values-given-refit = before: nominal robot parameters; after: given parameters; both with base and targets fitted to the calibration poses
values-nominal = before and after: nominal parameters, including base and targets; nothing is fitted to these data
values-nominal-refit = before and after: nominal robot parameters, with base and targets fitted to the calibration poses
values-of-every-campaign = Values by campaign
values-of-identification = before: nominal robot parameters, with only base and targets fitted to the calibration poses; after: all identified parameters
velocities = velocities
velocity-of-poses = { $velocity } (poses)
velocity-of-recording = { $value } mm/s ({ $name })
velocity-sentence = Velocity: { $velocity }.
verdict = verdict
files-beyond-limits = Do not load { $files }: with the values of { $count ->
        [one] this file
       *[other] these files
    }, a limit is not met.
given-not-loaded = Do not load the given parameters. If they are loaded, restore the previous file of the controller.
verdict-conditional = Verdict: pass with reservations.
verdict-fail = Verdict: fail.
verdict-is-of-file = These errors apply to `{ $file }`{ $count ->
        [0] {""}
        [one] , which omits one identified parameter
       *[other] , which omits { $count } identified parameters
    }: RMS { $rms } { $unit }; with all parameters { $whole } { $unit }.
verdict-pass = Verdict: pass.
verdict-title = Verdict
verdict-undecided = Verdict: undecided.
verification-of-identified-parameters = Verification of identified parameters
verified-by-copies = nothing new was measured: { $count } of { $rows } readings are readings of the calibration
verified-by-program = an independent program; not compared with a purchased copy of the standard
verified-by-simulation = simulated motions; not compared with a purchased copy of the standard
verified-by-text = text of the standard, a published data set and an independent program
verify-step-apart = measure poses that tell these motions apart: { $motions }
verify-step-apart-reason = they explain the residuals equally well; `etalon verify --candidates` chooses poses
verify-step-base = check the fixing of the base, and the reference points of the world frame
verify-step-base-reason = a motion of the base changes no parameter of the robot itself
verify-step-joint = master joint { $joint } again, or add { $by } to its joint values
verify-step-joint-reason = the joint truly stands at its logged value plus this change
verify-step-keep = keep the loaded file
verify-step-keep-reason = no change is significant; the smallest changes that these poses detect are listed below
verify-step-new = measure the poses again, and replace exports and logs
verify-step-new-reason = { $count } rows are copies of readings of the calibration
verify-step-other = measure again at other poses; if the deviation remains, calibrate again
verify-step-other-reason = no single motion explains it; if it began when a file was loaded, restore the previous file
verify-step-target = check the mounting of target { $target }
verify-step-target-reason = the parameters of the robot itself are not contradicted
verify-step-verify = then run `etalon verify` again
verify-step-verify-reason = only new readings show that the change is corrected
view-as-drawn = As drawn
view-xy = x-y
view-xz = x-z
view-yz = y-z
visit-of-cycle-tooltip = pose { $pose }, cycle { $cycle }: x { $x }, y { $y } µm
visit-tooltip = pose { $pose }, cycle { $cycle }, { $approach }: x { $x }, y { $y }, z { $z } µm from the mean
visits = visits
visits-by-approach = { $visits } visits about their mean, by approach; large marks: means.
visits-by-approach-in-space = { $visits } visits about their mean; colour and shape: approach; large marks: means.
visits-by-plane = Visits of each pose by plane
visits-from-one-pose = { $visits } visits about their mean, { $unknown ->
        [0] all by one approach; large mark: mean.
        [one] all but one by one approach; the approach of one visit is unknown, because no pose was recorded before it. Large mark: mean of the other visits.
       *[other] all but { $unknown } by one approach; the approach of { $unknown } visits is unknown, because no pose was recorded before them. Large mark: mean of the other visits.
    }
visits-from-unknown-poses = { $visits } visits about their mean; their approaches are unknown.
visits-of-pose-title = Pose { $pose }, { $plane } plane
visits-over-time = Visits over time
warm-up-before-the-test = warm-up before the test
warnings-and-remarks = Warnings and remarks
way-back-after = after loading
way-back-before = before loading
way-back-display = pose on the display
way-back-evaluated = With the inputs of pose { $pose } ({ $inputs }) and its joint values ({ $joints }), the file gives x = { $x }, y = { $y }, z = { $z } mm. Software that ignores the inputs is off by { $effect } mm there.
way-back-file = file before loading
way-back-base-moves = Joints move link `{ $base }`, so no controller displays these poses. Software that computes the chain gives them, for example `etalon kinematics direct`.
way-back-links = Base frame: link `{ $base }`. Flange: link `{ $link }`.
way-back-inputs = Both rows are computed with { $inputs }. With other values the second row differs.
way-back-loaded = file to load
way-back-moved = largest change of a taught position
way-back-moved-by = { $change } mm in the base frame, at pose { $pose }
way-back-not-stated = not stated: save it, and name it as `controller_backup` in [conditions]
way-back-other-poses = The display at other poses, from the joint values before loading: `etalon kinematics direct JOINTS.csv --robot robot.toml --parameters out/parameters.json --loaded { $file }`.
way-back-restore = Way back: load the saved file again. It is restored if the display shows the same pose as before loading.
way-back-test = Move to pose { $pose } before loading: { $joints }. Load without moving the robot. The display must change from the first row to the second. It shows the flange in the base frame, without tool and work object. The first row is for nominal values: if the controller has others, note its display instead.
way-back-title = Test after loading, and way back
way-back-unread = The values of this file are not read: “before” is the robot with nominal parameters.
way-back-change-too-small = Rounding of the joint values and of the display explains differences up to { $tolerance } mm; the file changes this pose by { $change } mm. Test it by a measurement instead.
way-back-compensated = If you correct programs with `etalon compensate` instead, load no file. A target at the second row is then commanded as the first row, and the display must show the joint values above.
way-back-tolerance = Tolerance of the comparison: { $tolerance } mm. Rounding of the joint values and of the display explains no larger difference.
way-back-without-display = The model has no pose of a flange that a display shows. Test the file by a measurement: command a few poses with it, and measure them. Way back: load the saved file again.
way-back-verify = Later, measure a few poses, and put the new files into a copy of the campaign. Then run `etalon verify COPY --robot robot.toml --parameters out/parameters.json`.
way-back-verify-mastered = If the joint values of the controller contain the loaded zeros (mastering), add `--mastered { $file }`.
weaker-trends = Further significant trends
weave = weave
way-back-mastered = If the controller takes the file as mastering values, its joint values must change to: { $joints }.
weave-passes = { $passes } passes, { $turns } turns
weaving = Weaving
weaving-frequency = weaving frequency
weaving-frequency-measured = { $measured } Hz, commanded { $commanded } Hz: WF { $ratio } %
way-back-test-software = At pose { $pose }, compute the pose of the flange at these joint values: { $joints }. With nominal parameters your software must give the first row, with the file the second. Both rows are in the base frame, without tool and work object.
weaving-passes = weaving, passes
weaving-stroke = weaving stroke
weaving-stroke-measured = { $measured } mm, commanded { $commanded } mm: WS { $ratio } %
weaving-turns = weaving, turns
weight = weight
what-changed = Changes between campaigns
what-differs-between-series = Differences between the series
what-no-reading-shows = undetectable errors
wider-than-window = Wider than the window: scroll sideways.
with-colon = { $label }:
with-field = with the field
without-field = without the field
workspace = Workspace
workspace-outlines = Outlines of these regions; thick outline: reachable with every orientation.
workspace-plane = Workspace of the platform centre C, { $plane } plane
world-frame = world frame
world-frame-title = World frame
worst-campaigns = The { $worst } worst campaigns are shown. With scripts enabled, the page shows { $left_out } more; batch.parquet contains all campaigns.
written-by = written by
x-y-z-rp = x, y, z (RP)
yes = yes

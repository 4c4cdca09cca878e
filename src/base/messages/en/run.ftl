### Messages of run. Above each message: its explanation (see CONTRIBUTING.md, "A message").

# Means: [contact] is given beside `residuals = "pose"`.
# Matters: The repeatability of the contact is a weight for positions of targets. Residuals of the
# pose do not use it.
# Do: Compare targets, or remove [contact].
# Example: [contact] and `residuals = "pose"` in [identify]
contact-without-targets = [contact] has no effect on residuals of the pose
    .hint = set `residuals = "targets"`, or remove [contact]

uncertainty-source = { $section ->
        [instrument] take it from the instrument's calibration certificate
        [tool] give the uncertainty of the point on the tool
       *[contact] touch one point repeatedly and use the scatter of the encoder readings
    }

# Means: The uncertainty of a coordinate is smaller than that of an interferometer or larger than
# that of a camera.
# Matters: It is usually stated in another unit. All results would be weighted wrongly.
# Do: Give the expanded uncertainty of one coordinate in micrometres.
# Example: `expanded_uncertainty_um = 0.0027` for 2.7 µm
key-uncertainty-implausible = `{ $key }` = { $value } cannot be the uncertainty of a measured coordinate in micrometres
    .expected = a value from { $least } to { $most }
    .hint = check the unit: 0.0027 mm is 2.7 µm

# Means: A target is named twice in `targets`.
# Matters: One of the two names is probably a misspelling of another target.
# Do: Name each target once.
# Example: `targets = ["ball", "ball"]`
target-named-twice = target `{ $target }` is named twice
    .hint = name each target once

# Means: A limit is given for a quantity that the campaign does not determine.
# Matters: The limit would never be judged, and the report would show no verdict for it.
# Do: Remove the limit, or add the section that determines the quantity.
# Example: `accuracy_max_mm` without commanded positions
limit-without-result = the limit `{ $limit }` needs { $needs ->
        [identify] {"["}identify]
        [commanded] {"["}repeatability] with `commanded`, or [poses]
       *[repeatability] {"["}repeatability] or [poses]
    }
    .hint = remove the limit, or add the section that determines the quantity

# Means: Exports, logs or a join are given together with a table of observations.
# Matters: A table of observations already holds measured values and joint values. It is undefined
# which values apply.
# Do: Give either [observations], or [[export]], [[log]] and [join].
# Example: [observations] and [[log]] in one campaign.toml
section-beside-observations = `{ $section }` is given beside [observations]
    .hint = state either [observations], or [[export]], [[log]] and [join]

# Means: A join by time has no clock offset or no tolerance.
# Matters: Measured points and joint values are matched by their times. Without the offset of the
# clocks they would be matched wrongly.
# Do: Set `clock_offset_s` and `tolerance_s`.
# Example: `by = "time"` without `clock_offset_s`
join-clock-missing = a join by time needs { $keys }
    .hint = add to [join] { $lines }: the offset is the time of the measurement minus the time of the log. If the clocks differ, set `clock_offset_s = "standstills"`, and in [log] `{ $standstill }`

# Means: `clock_offset_s = "standstills"` is given, but a log has no [log.standstill].
# Matters: The clock offset is estimated from the times of the standstills.
# Do: Describe the standstills, or give the clock offset as a number.
# Example: `clock_offset_s = "standstills"` and a [[log]] without [log.standstill]
standstills-missing = the clock offset cannot be estimated: log `{ $log }` has no [log.standstill]
    .hint = add to [log] `{ $standstill }` (`within_mm` for prismatic joints), or set `clock_offset_s` as a number

# Means: `interpolate` is given for a log with standstills.
# Matters: Each point belongs to the standstill that contains its time. Joint values between
# standstills are not used.
# Do: Remove `interpolate`.
# Example: `interpolate = true` and [log.standstill]
interpolate-with-standstills = `interpolate` has no effect: log `{ $log }` has [log.standstill]
    .hint = remove `interpolate`: each point is joined to the standstill that contains its time

# Means: A key belongs to another kind of join.
# Matters: It would have no effect, so the join is probably not the intended one.
# Do: Remove the key, or give the join to which it belongs.
# Example: `tolerance_s` with `by = "row"`
key-of-other-join = `{ $key }` has no effect in this join
    .hint = remove it, or set `by = "{ $by }"`

# Means: A key that needs zero or a positive number has a negative one.
# Matters: The value has no meaning.
# Do: Correct the value.
# Example: `tolerance_s = -0.1`
key-negative = `{ $key }` is negative
    .expected = zero or a positive number

# Means: A value exceeds the largest possible value of its key.
# Matters: The value has no meaning.
# Do: Correct the value or its unit.
# Example: `humidity_percent = 450`
key-above-maximum = `{ $key }` exceeds { $most }
    .hint = check the value and its unit

# Means: A join by label has a log without the label of the touched point.
# Matters: Points and joint values are matched by this label.
# Do: Name the column of the log that holds the label.
# Example: `by = "label"` and a [[log]] whose `columns` lack `label`
join-label-missing = a join by label needs the label of the point in log `{ $log }`
    .hint = add `label` to its `columns`, with the name or the number of the column

# Means: Pose or target of an export is given by a key and by a column of the same export.
# Matters: It is undefined which of the two applies.
# Do: Remove one of them.
# Example: `pose = 3` in an [[export]] whose `columns` have `pose`
key-and-column = `{ $key }` is given twice: as a key of the export and as one of its columns
    .hint = remove one of them

# Means: The output folder contains a file that the campaign reads.
# Matters: The output folder is replaced as a whole: the input would be lost.
# Do: Name another output folder.
# Example: `output = "exports"` with the measurements in `exports`
input-in-output-folder = the output folder contains the input `{ $input }`
    .expected = a folder without inputs: a run replaces the folder as a whole
    .hint = name another folder, or remove `output`: the default is `out`

# Means: A feature gives no element, or more than one.
# Matters: It is undefined which element is fitted to the points.
# Do: Give one element with the labels of its points.
# Example: [feature.base] with `plane` and `line`
feature-element = feature `{ $feature }` is not exactly one element
    .expected = one of `plane`, `line`, `circle`, `cylinder` with the labels of its points

# Means: A feature names a label of its points twice.
# Matters: One of the two is probably a misspelling of another label.
# Do: Name each label once.
# Example: `plane = ["P1", "P2", "P2"]`
feature-label-twice = feature `{ $feature }` names `{ $label }` twice
    .hint = name each label once

# Means: Only one of `nominal_mm` and `tolerance_mm` of the world frame is given.
# Matters: Measured points are compared with their nominal positions within the tolerance.
# Do: Give both, or neither.
# Example: `nominal_mm` without `tolerance_mm`
nominal-without-tolerance = `nominal_mm` and `tolerance_mm` of the world frame belong together
    .hint = give the positions from the drawing and the largest allowed distance of a point from them

# Means: The world frame is defined in no way or in several ways.
# Matters: Every position is a position in this frame.
# Do: Give one definition.
# Example: `targets` and `as_exported = true` together
world-frame-definition = the world frame must be defined in exactly one way
    .expected = `plane` with `origin` and an axis, or `targets`, or `as_exported = true`

# Means: A key of the world frame belongs to another definition of it.
# Matters: It would have no effect, so the definition is probably not the intended one.
# Do: Remove the key, or give the definition to which it belongs.
# Example: `origin` together with `targets`
key-of-other-frame = `{ $key }` has no effect in this world frame
    .hint = remove it, or define the frame by `{ $definition }`

# Means: `x_axis` or `y_axis` of the world frame names one point, more than two labels, two points
# in one place, or a direction perpendicular to the plane.
# Matters: The axis has no direction in the plane.
# Do: Name two labels (from, to), or one feature with a direction.
# Example: `x_axis = ["P1"]`
frame-axis-without-direction = the axis of the world frame has no direction
    .expected = two labels (from, to), or one feature with a direction

# Means: A world frame from a plane lacks its origin, its axis or the side of its normal, or gives
# two axes.
# Matters: A plane alone does not determine origin, rotation and the sign of z.
# Do: Set `origin`, one of `x_axis` and `y_axis`, and `towards`.
# Example: `plane = "table"` without `towards`
plane-frame-incomplete = a world frame from a plane needs `origin`, one of `x_axis` and `y_axis`, and `towards`
    .hint = state as `towards` a label on the positive side of the other axis; it determines the direction of z

# Means: A key that names a file has an empty text.
# Matters: No file can be read.
# Do: Give the file, or remove the key.
# Example: `file = ""`
file-name-empty = the name of the file is empty
    .hint = give the file in the folder of the campaign

# Means: `date` does not begin with a calendar date.
# Matters: Reports and comparisons of campaigns order results by this date.
# Do: Give year, month and day (ISO 8601).
# Example: `date = "31.2.2026"`
date-invalid = `date` does not begin with a calendar date
    .expected = year-month-day (ISO 8601), for example 2026-01-31

# Means: `temperature_c` is outside the temperatures of workshops and climatic chambers.
# Matters: It is usually stated in another unit.
# Do: Give the temperature in degrees Celsius.
# Example: `temperature_c = 293.15`
temperature-implausible = `temperature_c` = { $value } is not a temperature of a robot in degrees Celsius
    .expected = a value from { $least } to { $most }
    .hint = check the unit: 293.15 K is 20 °C

# Means: A step of [geometric] needs another step that is not given.
# Matters: The dimensions of the step cannot be determined alone.
# Do: Give the missing step, or remove the step that needs it.
# Example: `shaft` without `arc`
geometric-step-missing = [geometric] lacks `{ $missing }`, which `{ $step }` needs
    .hint = add it; s needs `shaft` and `arc`; d1 and d3 need `offsets`, `mid_travel_mm`, `arc`, `turn` and `shaft`; O needs `arc`; C needs `turn`

# Means: A table of errors is given without a complete geometric calibration and [identify].
# Matters: The table compares the geometric calibration with the identified parameters.
# Do: Give all steps of [geometric], and [identify]; or remove the table.
# Example: [[geometric.table]] without [identify]
errors-table-incomplete = a table of errors needs the complete geometric calibration and [identify]
    .hint = give all steps of [geometric] and [identify], or remove the table

# Means: An uncertainty, a coefficient of thermal expansion or a coverage factor is outside its
# plausible values.
# Matters: It is usually stated in another unit, and would falsify the uncertainty of every result.
# Do: Check the value and its unit.
# Example: `robot_per_c = 11.5` for 11.5e-6
key-out-of-range = `{ $key }` = { $value } is outside { $least } to { $most }

plausible-value = { $quantity ->
        [scale] check the unit: 1 µm/m is 1 ppm
        [polar] check the unit: 10 ppm are 10 µm/m, 1 arc second is 4.85 µm/m
        [expansion] check the unit: steel expands by 11.5e-6 per degree, aluminium by 23.5e-6
        [temperature] give it in degrees Celsius
        [coverage] give the coverage factor: 2 is a level of confidence of about 95 %
       *[homing] home the robot repeatedly and use the scatter of a joint at its switch
    }

# Means: [homing] gives no uncertainty for joints of one kind.
# Matters: The uncertainty of these joints at their switches would be missing from the results.
# Do: Give it, or state 0 if homing adds no error.
# Example: `expanded_uncertainty_um` alone for a robot with revolute joints
homing-incomplete = [homing] lacks `{ $key }` for joint `{ $joint }` (values in { $unit })
    .hint = give it, or state 0 if homing adds no error

# Means: `polar` of the instrument is given for a table of observations.
# Matters: Uncertainties of range and angle need the position of the instrument, which the table
# does not hold.
# Do: Give the covariance of each row in the table.
# Example: [instrument.polar] and [observations] in one campaign.toml
polar-with-observations = `polar` needs exports: a table of observations does not hold the position of the instrument
    .hint = give the covariance of each row (`cxx_mm2` to `czz_mm2`) in the table

# Means: An uncertainty of identified parameters is given in a campaign that identifies none.
# Matters: It would have no effect.
# Do: Remove the section, or add [identify].
# Example: [expansion] without [identify]
section-without-identify = [{ $section }] has no effect: the campaign has no [identify]
    .hint = remove [{ $section }], or add [identify]

# Means: A feature names a label that no point has.
# Matters: The feature cannot be fitted to the intended points.
# Do: Use a label of the exports.
# Example: `plane = ["P1", "P2", "P9"]` where the exports have P1 to P4
label-unknown = no point has the label `{ $label }`

# Means: `plane` of the world frame names a feature that the campaign does not define.
# Matters: The world frame cannot be determined.
# Do: Define [feature.NAME], or use the name of a defined feature.
# Example: `plane = "tabel"` beside [feature.table]
feature-unknown = unknown feature `{ $feature }`

# Means: The world frame names a point or feature that does not exist.
# Matters: The world frame cannot be determined.
# Do: Use a label of the exports or the name of a feature.
# Example: `origin = "P9"` where the exports have P1 to P4
point-or-feature-unknown = unknown point or feature `{ $name }`

# Means: No export contains measurements of a target.
# Matters: The target cannot be used: its positions are unknown.
# Do: Use the name that the exports have, or add the export with this target.
# Example: `targets = ["balls"]` where the labels name the target `ball`
target-not-exported = no export contains the target `{ $target }`

# Means: Labels or targets of the campaign are not in the exports that could be read.
# Matters: They may be in the exports that could not be read.
# Do: Correct the other errors first, then check these names.
# Example: a label of an export whose file is missing
names-unchecked = no readable export contains { $names }
    .hint = check these names when all exports can be read

# Means: [join] names a target that the robot model lacks.
# Matters: Its positions cannot be predicted.
# Do: Use a target of the robot.
# Example: `targets = ["K"]` for a robot with the target `tcp`
target-not-of-robot = `{ $target }` is not a target of this robot

# Means: `targets` of [join] omits a target of the robot.
# Matters: All targets of this robot model are needed.
# Do: Name all targets, or remove `targets`.
# Example: `targets = ["K"]` for a PreXYT with K and L
targets-incomplete = `targets` omits `{ $target }`
    .expected = all targets of this robot

# Means: [geometric.workspace] is given, and robot.toml has no travel of the actuators.
# Matters: The workspace is the area that the actuators reach within their travel.
# Do: Add [reach] in robot.toml.
# Example: [geometric.workspace] without `travel_mm`
travel-missing = the workspace needs the travel of the actuators
    .hint = set `travel_mm` of the three actuators in [reach] of robot.toml

# Means: The export of a spatial robot has no z coordinate.
# Matters: Positions in space have three coordinates.
# Do: Name the column of z.
# Example: `columns = { x = "X", y = "Y" }` for a serial arm
z-column-missing = `columns` has no z, which a spatial robot needs
    .hint = add `z`, with the name or the number of the column

# Means: The name of a log is empty, is used twice or has other characters than letters, digits, `_`
# and `-`.
# Matters: Names of output files contain the name of the log.
# Do: Give each log its own name.
# Example: two [[log]] with `name = "a"`
log-name-invalid = `{ $name }` cannot be the name of this log
    .expected = letters, digits, `_` and `-`; a different name for each log

# Means: `columns` of a log names a joint that the robot lacks.
# Matters: Its values would have no effect.
# Do: Use the joints of the robot.
# Example: `q9_deg = "J9"` for a robot of six joints
log-joint-unknown = `{ $key }` is not a joint of this robot
    .hint = use one of { $joints }, or one of them with another unit

# Means: `columns` of a log has no column for a joint of the robot.
# Matters: The pose of the robot is unknown without all joint values.
# Do: Name the column of the joint.
# Example: `q1_deg` to `q5_deg` for a robot of six joints
log-joint-missing = log `{ $log }` has no column for joint `{ $joint }`
    .hint = add `{ $column }` to its `columns`, with the name or the number of the column

# Means: No label of an export has the form that `label` gives.
# Matters: Target, pose and cycle of its points are unknown.
# Do: Give the form of the labels.
# Example: `label = "{target}_{pose}"` for labels like `12-K`
label-form-differs = no label of `{ $file }` has the form `{ $form }`
    .hint = give the form of its labels with {"{"}target{"}"}, {"{"}pose{"}"} and {"{"}cycle{"}"}; the first is `{ $first }`

# Means: The operating system did not confirm that the results of a batch are on the disk.
# Matters: A power failure may lose some of them; the next run then repeats these campaigns.
# Do: Check the disk and its free space, then run the batch again.
# Example: a network drive that is disconnected during the run
results-not-synced = the results cannot be written to the disk: { $reason }
    .hint = check the disk, then run the batch again

# Means: A thread of the batch could not be started, or ended without a result.
# Matters: Some campaigns were not run.
# Do: Run the batch again with fewer threads.
# Example: a limit of the operating system on the number of threads
threads-failed = the campaigns cannot be run in parallel: { $reason ->
        [ended] a thread ended without a result
       *[other] { $reason }
    }
    .hint = run again with fewer threads: `RAYON_NUM_THREADS=1`

data-elsewhere = its data are in the folder ${ $name }, and this environment variable is not set

# Means: A folder has no manifest, so it is not the output folder of a run.
# Matters: Results are read only from folders that `etalon run` wrote.
# Do: Name the output folder, or the campaign after it was run.
# Example: `etalon report exports`
not-an-output-folder = `{ $folder }` is not the output folder of a run: its manifest.json is missing
    .hint = name a folder that `etalon run` wrote, or a campaign that was run

# Means: The manifest of an output folder does not list a file.
# Matters: The run did not write it, so it may belong to another campaign.
# Do: Run the campaign again.
# Example: a manifest.json that lacks `residuals.parquet`
file-not-of-run = the run did not write `{ $file }`
    .hint = run the campaign again: `etalon run CAMPAIGN`

# Means: The content of a file in the output folder changed after the run.
# Matters: Results of one run belong together; a changed file would mix them with others.
# Do: Run the campaign again.
# Example: a value edited by hand in parameters.json
file-changed-since-run = `{ $file }` was changed after the run
    .expected = the SHA-256 { $sha256 } of manifest.json
    .hint = run the campaign again: `etalon run CAMPAIGN`

# Means: Another process wrote the output folder while this command read it.
# Matters: Files of two runs would be mixed.
# Do: Repeat the command when the other process has ended.
# Example: `etalon report` during `etalon run` of the same campaign
folder-replaced = another process replaced `{ $folder }` while it was read
    .hint = repeat the command when the other process has ended

# Means: A JSON document is damaged, or its parts contradict each other.
# Matters: Its results cannot be used.
# Do: Run the campaign again with this version.
# Example: a parameters.json that was cut off
document-unreadable = `{ $file }` is not a document of this version: { $reason }
    .hint = run the campaign again with this version: `etalon run CAMPAIGN`

# Means: The schema of a JSON document is not the one that the command reads.
# Matters: It is another document, or the document of another version.
# Do: Name the right document, or run the campaign again with this version.
# Example: accuracy.json where parameters.json is read
document-schema-other = `{ $file }` has { $schema ->
        [none] no schema
       *[other] the schema `{ $schema }`
    }
    .expected = the schema `{ $wanted }`
    .hint = run the campaign again with this version: `etalon run CAMPAIGN`

# Means: The run would overwrite a file in the output folder that no run wrote.
# Matters: etalon never replaces the files of others.
# Do: Move the file, or give another output folder.
# Example: a `report.html` copied into `out` by hand
foreign-file = `{ $file }` would be overwritten, but no run wrote it
    .hint = move it to another folder, or give another `output` in campaign.toml

# Means: An input file changed while the campaign was run.
# Matters: Results would combine two states of the file. Nothing is written.
# Do: Run the campaign again when the file is complete.
# Example: an export that the measuring program writes during the run
input-changed = `{ $file }` changed while the campaign was run
    .hint = run the campaign again when the file is complete

# Means: A command that judges parameters is applied to a campaign without [identify].
# Matters: [identify] names the poses on which parameters are judged.
# Do: Set `calibration` and `validation` in [identify].
# Example: `etalon validate` on a campaign that tests repeatability only
identify-missing = the campaign has no [identify], which names the poses for judging parameters
    .hint = set `calibration` and `validation` in [identify]

# Means: `clock_rate` is given, and `clock_offset_s` is a number or another word.
# Matters: Offset and rate are determined from the same standstills, or from the same motion.
# Do: Give both with the same word, or omit `clock_rate`.
# Example: `clock_offset_s = 1.5` with `clock_rate = "standstills"`
clock-rate-without-offset = `clock_rate` needs `clock_offset_s` with the same word: `standstills` or `motion`
    .hint = set `clock_offset_s` with the same word, or omit `clock_rate`
# Means: The labels of an export name targets of the robot, and the campaign gives no form of
# labels.
# Matters: Without targets and poses the points are not joined.
# Do: Give the form of the labels.
# Example: labels `K_12_3` and no key `label`
label-form-missing = the labels of `{ $file }` name targets, and no form of labels is given
    .hint = set `label = "{ $form }"` in this [[export]]: all its labels have this form

state-targets = set `targets = { $targets }` in [join]: the labels name these targets
# Means: `valid_until` is not a date of the form year-month-day.
# Matters: Reports and batches compare this day with other dates.
# Do: Give the last day of validity as 2027-03-02.
# Example: `valid_until = "next year"`
valid-until-no-date = `valid_until` is not a date: "{ $date }"
    .expected = the last day of validity in quotation marks, as "2027-03-02"

# Means: The last day of validity is before the date of the measurements.
# Matters: The calibration would never have been valid.
# Do: Correct `valid_until` or `date`.
# Example: `date = "2026-03-02"` with `valid_until = "2025-03-02"`
valid-until-before-measurements = `valid_until` ({ $date }) is before the measurements ({ $measured })
    .hint = correct `valid_until` or `date`

# Means: A template would write a file with the name of a document of a run.
# Matters: The document would be lost.
# Do: Rename the template.
# Example: a template `parameters.json.j2`
template-name-reserved = a run writes `{ $file }` itself
    .hint = rename the template

controller-template = template of a controller format

# Means: The field was estimated with other parameters than the given ones.
# Matters: A field describes what one set of parameters leaves; with others it adds errors.
# Do: Give the parameters.json and the field.json of one run.
# Example: `--field old/field.json --parameters out/parameters.json`
field-of-other-parameters = `{ $field }` does not belong to `{ $parameters }`: the hash of the parameters differs
    .hint = give both files of one run
# Means: The last day of validity is given as a day and as a number of months.
# Matters: The two may differ.
# Do: Give one of them.
# Example: `valid_until = "2027-03-02"` with `valid_for_months = 12`
valid-stated-twice = `valid_until` and `valid_for_months` are both stated
    .hint = omit one of them

# Means: `valid_for_months` counts from the date of the measurements. `date` is missing or malformed.
# Matters: The last day of validity is unknown.
# Do: Set `date` as 2026-03-02, or `valid_until`.
# Example: `valid_for_months = 12` without `date`
valid-months-without-date = `valid_for_months` needs the `date` of the measurements
    .hint = set `date = "2026-03-02"`, or the last day as `valid_until`

# Means: The number of months of validity is zero, or beyond ten years.
# Matters: Reports and commands compare the last day of validity with other dates.
# Do: Give the interval in months.
# Example: `valid_for_months = 365`
valid-months-implausible = `valid_for_months` is { $months }
    .expected = 1 to { $most } months

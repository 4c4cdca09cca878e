### Messages of run. Above each message: its explanation (see CONTRIBUTING.md, "A message").

# Means: [contact] is given together with `residuals = "pose"`.
# Matters: The repeatability of the contact weights positions of targets. Residuals of the pose do
# not use it.
# Do: Set `residuals = "targets"`, or remove [contact].
# Example: [contact] and `residuals = "pose"` in [identify]
contact-without-targets = [contact] has no effect on residuals of the pose
    .hint = set `residuals = "targets"`, or remove [contact]

uncertainty-source = { $section ->
        [instrument] take it from the instrument's calibration certificate
        [tool] use the uncertainty of the point on the tool
       *[contact] touch one point repeatedly and use the scatter of the encoder readings
    }

# Means: The uncertainty of a coordinate is smaller than for any interferometer, or larger than for
# any camera.
# Matters: The value is probably in another unit. All results have wrong weights.
# Do: Convert the expanded uncertainty of one coordinate to micrometres.
# Example: `expanded_uncertainty_um = 0.0027` for 2.7 µm
key-uncertainty-implausible = `{ $key }` = { $value } cannot be the uncertainty of a measured coordinate in micrometres
    .expected = a value from { $least } to { $most }
    .hint = check the unit: 0.0027 mm is 2.7 µm

# Means: `targets` contains a target twice.
# Matters: One of the two is probably a wrong spelling of another target.
# Do: List each target once.
# Example: `targets = ["ball", "ball"]`
target-named-twice = target `{ $target }` is listed twice
    .hint = list each target once

# Means: A limit is given for a quantity that the campaign does not determine.
# Matters: No result could be compared with the limit, so the report would show no verdict for it.
# Do: Remove the limit, or add the section that determines the quantity.
# Example: `accuracy_max_mm` without commanded positions
limit-without-result = the limit `{ $limit }` needs { $needs ->
        [identify] {"["}identify]
        [commanded] {"["}repeatability] with `commanded`, or [poses]
       *[repeatability] {"["}repeatability] or [poses]
    }
    .hint = remove the limit, or add the section that determines the quantity

# Means: Exports, logs or a join are given together with a table of observations.
# Matters: A table of observations already contains measured values and joint values. It is
# undefined which values apply.
# Do: Keep either [observations], or [[export]], [[log]] and [join].
# Example: [observations] and [[log]] in one campaign.toml
section-beside-observations = `{ $section }` cannot be combined with [observations]
    .hint = keep either [observations], or [[export]], [[log]] and [join]

# Means: A join by time has no clock offset or no tolerance.
# Matters: Measured points and joint values are matched by their times. If the offset of the clocks
# is unknown, they are matched wrongly.
# Do: Add `clock_offset_s` and `tolerance_s` to [join].
# Example: `by = "time"` without `clock_offset_s`
join-clock-missing = a join by time needs { $keys }
    .hint = add to [join] { $lines }: the offset is the time of the measurement minus the time of the log. If the clocks differ, set `clock_offset_s = "standstills"`, and in [log] `{ $standstill }`

# Means: `clock_offset_s = "standstills"` is given, but a log has no [log.standstill].
# Matters: The clock offset is estimated from the times of the standstills.
# Do: Add [log.standstill] to each log, or set the clock offset as a number.
# Example: `clock_offset_s = "standstills"` and a [[log]] without [log.standstill]
standstills-missing = the clock offset cannot be estimated: log `{ $log }` has no [log.standstill]
    .hint = add to [log] `{ $standstill }` (`within_mm` for prismatic joints), or set `clock_offset_s` as a number

# Means: `interpolate` is given for a log with standstills.
# Matters: Each point belongs to the standstill that contains its time, so no joint values between
# standstills are needed.
# Do: Remove `interpolate`, or remove [log.standstill].
# Example: `interpolate = true` and [log.standstill]
interpolate-with-standstills = `interpolate` has no effect: log `{ $log }` has [log.standstill]
    .hint = remove `interpolate`: each point is joined to the standstill that contains its time

# Means: A key does not belong to this kind of join.
# Matters: The key has no effect, so the join is probably not the intended one.
# Do: Remove the key, or set `by` to the kind of join that uses it.
# Example: `tolerance_s` with `by = "row"`
key-of-other-join = `{ $key }` has no effect in this join
    .hint = remove it, or set `by = "{ $by }"`

# Means: A key has a negative value, but needs zero or a positive number.
# Matters: No such quantity can be negative.
# Do: Correct the value.
# Example: `tolerance_s = -0.1`
key-negative = `{ $key }` is negative
    .expected = zero or a positive number

# Means: A value exceeds the largest possible value of its key.
# Matters: No such quantity can be so large.
# Do: Correct the value, or convert it to the unit in the name of the key.
# Example: `humidity_percent = 450`
key-above-maximum = `{ $key }` is larger than { $most }
    .hint = check the value and its unit

# Means: In a join by label, a log has no column with the label of the touched point.
# Matters: Points and joint values are matched by this label.
# Do: Add the column with the label to `columns` of the log.
# Example: `by = "label"` and a [[log]] without `label` in `columns`
join-label-missing = a join by label needs the label of the point in log `{ $log }`
    .hint = add `label` to its `columns`, with the name or the number of the column

# Means: The pose or the target of an export is given twice: by a key, and by a column.
# Matters: It is undefined which of the two applies.
# Do: Remove the key, or remove the column from `columns`.
# Example: `pose = 3` in an [[export]] with `pose` in `columns`
key-and-column = `{ $key }` is given twice: as a key of the export and as one of its columns
    .hint = remove one of them

# Means: The name of an export states pose, target or cycle, and so does a key, a column or the label.
# Matters: It is undefined which of the two applies.
# Do: Remove one of them.
# Example: `file = "scans/{pose}.txt"` with `label = "{target}_{pose}"`
key-and-file-name = `{ $key }` is stated twice: by the name of the file, and by a key, a column or the label
    .hint = remove one of them

# Means: The output folder contains a file that the campaign reads.
# Matters: A run replaces the whole output folder, including the input.
# Do: Use another folder, or remove `output` to use the default `out`.
# Example: `output = "exports"` with the measurements in `exports`
input-in-output-folder = the output folder contains the input `{ $input }`
    .expected = a folder without inputs: a run replaces the whole folder
    .hint = use another folder, or remove `output`: the default is `out`

# Means: A feature contains no element, or more than one.
# Matters: It is undefined which element is fitted to the points.
# Do: Use exactly one of the four keys.
# Example: [feature.base] with `plane` and `line`
feature-element = feature `{ $feature }` must contain exactly one element
    .expected = one of `plane`, `line`, `circle`, `cylinder` with the labels of its points

# Means: A feature contains the label of a point twice.
# Matters: One of the two is probably a wrong spelling of another label.
# Do: List each label once.
# Example: `plane = ["P1", "P2", "P2"]`
feature-label-twice = feature `{ $feature }` contains `{ $label }` twice
    .hint = list each label once

# Means: The world frame has only one of `nominal_mm` and `tolerance_mm`.
# Matters: The tolerance limits the distance between a measured point and its nominal position.
# Do: Set both keys, or neither.
# Example: `nominal_mm` without `tolerance_mm`
nominal-without-tolerance = `nominal_mm` and `tolerance_mm` of the world frame belong together
    .hint = set both: the positions of the drawing, and the largest allowed distance of a point from them

# Means: The world frame has no definition, or several.
# Matters: Every position is a position in this frame.
# Do: Keep one of the three definitions.
# Example: `targets` and `as_exported = true` together
world-frame-definition = the world frame must be defined in exactly one way
    .expected = `plane` with `origin` and an axis, or `targets`, or `as_exported = true`

# Means: A key does not belong to this definition of the world frame.
# Matters: The key has no effect, so the definition is probably not the intended one.
# Do: Remove the key, or use the definition to which it belongs.
# Example: `origin` together with `targets`
key-of-other-frame = `{ $key }` has no effect in this world frame
    .hint = remove it, or define the frame by `{ $definition }`

# Means: `x_axis` or `y_axis` of the world frame has no direction in the plane. It contains one
# point, more than two labels, two points at one position, or a direction perpendicular to the
# plane.
# Matters: The orientation of the frame in the plane is unknown.
# Do: Give two labels (from, to), or one feature with a direction.
# Example: `x_axis = ["P1"]`
frame-axis-without-direction = the axis of the world frame has no direction
    .expected = two labels (from, to), or one feature with a direction

# Means: A world frame from a plane has no origin, no axis, no side of its normal, or two axes.
# Matters: The plane alone does not determine the origin, the rotation and the sign of z.
# Do: Set `origin`, one of `x_axis` and `y_axis`, and `towards`.
# Example: `plane = "table"` without `towards`
plane-frame-incomplete = a world frame from a plane needs `origin`, one of `x_axis` and `y_axis`, and `towards`
    .hint = set `towards` to a point whose coordinate along the other axis is positive; it determines the direction of z

# Means: A key for a file contains an empty text.
# Matters: No file can be read.
# Do: Write the name of the file, or remove the key.
# Example: `file = ""`
file-name-empty = the name of the file is empty
    .hint = write the name of a file in the folder of the campaign

# Means: A date does not begin with a day that the calendar has.
# Matters: Reports and comparisons of campaigns order results by `date`, and certificates print it.
# Do: Write year, month and day (ISO 8601): `date = "2026-01-31"`.
# Example: `date = "31.2.2026"`
date-invalid = `{ $key }` does not begin with a calendar date
    .expected = year-month-day (ISO 8601), for example 2026-01-31

# Means: Two dates of the campaign contradict each other: a report is issued before the
# measurements, or the robot is received after them.
# Matters: One of the dates is wrong, and the certificate would print it.
# Do: Correct the wrong date.
# Example: `date = "2026-03-02"` with `issued = "2026-02-27"` in [report]
dates-out-of-order = `{ $later }` ({ $second }) is before `{ $earlier }` ({ $first })
    .hint = correct one of the dates

# Means: `temperature_c` is outside the range of workshops and climatic chambers.
# Matters: The value is probably in another unit.
# Do: Convert the temperature to degrees Celsius.
# Example: `temperature_c = 293.15`
temperature-implausible = `temperature_c` = { $value } is not a temperature of a robot in degrees Celsius
    .expected = a value from { $least } to { $most }
    .hint = check the unit: 293.15 K is 20 °C

# Means: A step of [geometric] needs another step that is missing.
# Matters: The dimensions of the step cannot be computed without it.
# Do: Add the missing step, or remove the step that needs it.
# Example: `shaft` without `arc`
geometric-step-missing = [geometric] does not contain `{ $missing }`, which `{ $step }` needs
    .hint = add it; s needs `shaft` and `arc`; d1 and d3 need `offsets`, `mid_travel_mm`, `arc`, `turn` and `shaft`; O needs `arc`; C needs `turn`

# Means: A table of errors is requested, but the geometric calibration or [identify] is incomplete.
# Matters: The table compares the geometric calibration with the identified parameters.
# Do: Add the missing steps of [geometric] and the section [identify], or remove the table.
# Example: [[geometric.table]] without [identify]
errors-table-incomplete = a table of errors needs the complete geometric calibration and [identify]
    .hint = add all steps of [geometric] and [identify], or remove the table

# Means: An uncertainty, a coefficient of thermal expansion or a coverage factor has an implausible
# value.
# Matters: The value is probably in another unit. The uncertainty of every result is wrong.
# Do: Convert the value to the unit in the name of the key.
# Example: `robot_per_c = 11.5` for 11.5e-6
key-out-of-range = `{ $key }` = { $value } is outside { $least } to { $most }

plausible-value = { $quantity ->
        [scale] check the unit: 1 µm/m is 1 ppm
        [polar] check the unit: 10 ppm are 10 µm/m, 1 arc second is 4.85 µm/m
        [expansion] check the unit: steel expands by 11.5e-6 per degree, aluminium by 23.5e-6
        [temperature] convert it to degrees Celsius
        [coverage] use the coverage factor, for example 2 for a level of confidence of about 95 %
       *[homing] home the robot repeatedly, and use the scatter of a joint at its switch
    }

# Means: [homing] gives no uncertainty for joints of one kind.
# Matters: The results do not include the uncertainty of these joints at their switches.
# Do: Add the key. If homing adds no error, set it to 0.
# Example: `expanded_uncertainty_um` alone for a robot with revolute joints
homing-incomplete = [homing] does not contain `{ $key }` for joint `{ $joint }` (values in { $unit })
    .hint = add it; if homing adds no error, set it to 0

# Means: `polar` of the instrument is given for a table of observations.
# Matters: Uncertainties of range and angle depend on the position of the instrument, which the
# table does not contain.
# Do: Remove `polar`, and give the covariance of each row in the table.
# Example: [instrument.polar] and [observations] in one campaign.toml
polar-with-observations = `polar` needs exports: a table of observations does not contain the position of the instrument
    .hint = give the covariance of each row (`cxx_mm2` to `czz_mm2`) in the table

# Means: The section gives an uncertainty of identified parameters, but the campaign identifies
# none.
# Matters: The section has no effect.
# Do: Remove the section, or add [identify].
# Example: [expansion] without [identify]
section-without-identify = [{ $section }] has no effect: the campaign has no [identify]
    .hint = remove [{ $section }], or add [identify]

# Means: A feature contains a label that no point has.
# Matters: The feature cannot be fitted to the intended points.
# Do: Use a label of the exports; the message proposes similar labels.
# Example: `plane = ["P1", "P2", "P9"]`, but the exports contain P1 to P4
label-unknown = no point has the label `{ $label }`

# Means: `plane` of the world frame refers to a feature that the campaign does not define.
# Matters: The world frame cannot be determined.
# Do: Define [feature.NAME], or use the name of a defined feature.
# Example: `plane = "tabel"` and a section [feature.table]
feature-unknown = unknown feature `{ $feature }`

# Means: The world frame refers to a point or feature that does not exist.
# Matters: The world frame cannot be determined.
# Do: Use a label of the exports or the name of a feature.
# Example: `origin = "P9"`, but the exports contain P1 to P4
point-or-feature-unknown = unknown point or feature `{ $name }`

# Means: No export contains measurements of a target.
# Matters: The positions of the target are unknown.
# Do: Correct the name of the target, or add the export that contains it.
# Example: `targets = ["balls"]`, but the labels contain the target `ball`
target-not-exported = no export contains the target `{ $target }`

# Means: Some labels or targets are missing in the readable exports.
# Matters: They may be in the exports that cannot be read.
# Do: Correct the other errors first, then check these names.
# Example: a label of an export whose file is missing
names-unchecked = no readable export contains { $names }
    .hint = check these names after the other errors

# Means: [join] contains a target that the robot model does not have.
# Matters: Its positions cannot be computed.
# Do: Use a target of the robot.
# Example: `targets = ["K"]` for a robot with the target `tcp`
target-not-of-robot = `{ $target }` is not a target of this robot

# Means: `targets` of [join] does not contain all targets of the robot.
# Matters: This robot model needs all its targets.
# Do: Add the missing targets, or remove `targets`.
# Example: `targets = ["K"]` for a PreXYT with K and L
targets-incomplete = `targets` does not contain `{ $target }`
    .expected = all targets of this robot

# Means: [geometric.workspace] is given, but robot.toml does not contain the travel of the
# actuators.
# Matters: The workspace is the area that the actuators reach within their travel.
# Do: Add [reach] with `travel_mm` to robot.toml.
# Example: [geometric.workspace] without `travel_mm`
travel-missing = the workspace needs the travel of the actuators
    .hint = set `travel_mm` of the three actuators in [reach] of robot.toml

# Means: The export of a spatial robot has no z coordinate.
# Matters: Positions in space need three coordinates.
# Do: Add the column of z to `columns`.
# Example: `columns = { x = "X", y = "Y" }` for a serial arm
z-column-missing = `columns` has no z, which a spatial robot needs
    .hint = add `z`, with the name or the number of the column

# Means: The name of a log is empty, is used twice, or contains other characters than letters,
# digits, `_` and `-`.
# Matters: Names of output files contain the name of the log.
# Do: Give each log a different name of letters, digits, `_` and `-`.
# Example: two [[log]] with `name = "a"`
log-name-invalid = `{ $name }` cannot be the name of this log
    .expected = letters, digits, `_` and `-`; a different name for each log

# Means: `columns` of a log contains a joint that the robot does not have.
# Matters: The values of this column have no effect.
# Do: Use the names of the robot's joints.
# Example: `q9_deg = "J9"` for a robot of six joints
log-joint-unknown = `{ $key }` is not a joint of this robot
    .hint = use one of { $joints }, or one of them with another unit

# Means: `columns` of a log has no column for a joint of the robot.
# Matters: Without all joint values, the pose of the robot is unknown.
# Do: Add the column of this joint to `columns`.
# Example: columns `q1_deg` to `q5_deg` for a robot with six joints
log-joint-missing = log `{ $log }` has no column for joint `{ $joint }`
    .hint = add `{ $column }` to its `columns`, with the name or the number of the column

# Means: No label of an export has the form of `label`.
# Matters: The target, pose and cycle of its points are unknown.
# Do: Describe the form of the labels in `label`.
# Example: `label = "{target}_{pose}"` for labels like `12-K`
label-form-differs = no label of `{ $file }` has the form `{ $form }`
    .hint = describe the form of its labels with {"{"}target{"}"}, {"{"}pose{"}"} and {"{"}cycle{"}"}; the first label is `{ $first }`

# Means: The operating system did not confirm that the results of a batch are on the disk.
# Matters: If the power fails, some results may be lost; the next run then repeats these campaigns.
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

# Means: A folder has no manifest.json, so no run wrote it.
# Matters: Results are read only from folders that `etalon run` wrote.
# Do: Give a folder that `etalon run` wrote, or run the campaign first.
# Example: `etalon report exports`
not-an-output-folder = `{ $folder }` is not the output folder of a run: its manifest.json is missing
    .hint = give a folder that `etalon run` wrote, or a campaign that was run

# Means: The manifest of an output folder does not contain this file.
# Matters: The run did not write this file; it may belong to another campaign.
# Do: Run the campaign again to write its own files.
# Example: a manifest.json without `residuals.parquet`
file-not-of-run = the run did not write `{ $file }`
    .hint = run the campaign again: `etalon run CAMPAIGN`

# Means: A file in the output folder was changed after the run.
# Matters: The results of one run belong together; with a changed file they may contradict each
# other.
# Do: Run the campaign again; do not edit files in the output folder.
# Example: a value edited by hand in parameters.json
file-changed-since-run = `{ $file }` was changed after the run
    .expected = the SHA-256 { $sha256 } of manifest.json
    .hint = run the campaign again: `etalon run CAMPAIGN`

# Means: Another process replaced the output folder while this command read it.
# Matters: The result could mix files of two runs.
# Do: Wait until the other process has ended, and repeat the command.
# Example: `etalon report` during `etalon run` of the same campaign
folder-replaced = another process replaced `{ $folder }` while it was read
    .hint = repeat the command when the other process has ended

# Means: A JSON document is damaged, or its parts contradict each other.
# Matters: Its results cannot be used.
# Do: Run the campaign again with this version to write a new document.
# Example: a parameters.json without its end
document-unreadable = `{ $file }` is not a document of this version: { $reason }
    .hint = run the campaign again with this version: `etalon run CAMPAIGN`

# Means: The schema of a JSON document is not the expected one.
# Matters: It is another document, or another version of etalon wrote it.
# Do: Give the right document, or run the campaign again with this version.
# Example: accuracy.json instead of parameters.json
document-schema-other = `{ $file }` has { $schema ->
        [none] no schema
       *[other] the schema `{ $schema }`
    }
    .expected = the schema `{ $wanted }`
    .hint = run the campaign again with this version: `etalon run CAMPAIGN`

# Means: The run would overwrite a file in the output folder that no run wrote.
# Matters: etalon never replaces files that it did not write.
# Do: Move the file to another folder, or set another `output`.
# Example: a `report.html` copied into `out` by hand
foreign-file = `{ $file }` would be overwritten, but no run wrote it
    .hint = move it to another folder, or set another `output` in campaign.toml

# Means: An input file changed during the run of the campaign.
# Matters: The results could combine two versions of the file. Nothing is written.
# Do: Wait until the file is complete, then run the campaign again.
# Example: an export that the measuring program writes during the run
input-changed = `{ $file }` changed during the run
    .hint = run the campaign again when the file is complete

# Means: The command judges parameters, but the campaign has no [identify].
# Matters: [identify] gives the poses with which parameters are judged.
# Do: Add [identify] with `calibration` and `validation`.
# Example: `etalon validate` on a campaign that tests repeatability only
identify-missing = the campaign has no [identify], which selects the poses for judging parameters
    .hint = add [identify] with `calibration` and `validation`

# Means: `clock_rate` contains a word, but `clock_offset_s` contains a number or another word.
# Matters: The offset and the rate are computed from the same standstills, or from the same motion.
# Do: Set both keys to the same word, or omit `clock_rate`.
# Example: `clock_offset_s = 1.5` with `clock_rate = "standstills"`
clock-rate-without-offset = `clock_rate` needs `clock_offset_s` with the same word: `standstills` or `motion`
    .hint = set `clock_offset_s` to the same word, or omit `clock_rate`
# Means: The labels of an export contain targets of the robot, but the campaign does not give the
# form of the labels.
# Matters: Without targets and poses, the points cannot be joined.
# Do: Set `label` to the form of the labels.
# Example: labels such as `K_12_3`, and no key `label`
label-form-missing = the labels of `{ $file }` contain targets, but the form of the labels is not given
    .hint = set `label = "{ $form }"` in this [[export]]: all its labels have this form

state-targets = set `targets = { $targets }` in [join]: the labels contain these targets
# Means: `valid_until` is not a date in the form year-month-day.
# Matters: Reports and batches compare this day with the current date.
# Do: Write the last day of validity in quotation marks: `valid_until = "2027-03-02"`.
# Example: `valid_until = "next year"`
valid-until-no-date = `valid_until` is not a date: "{ $date }"
    .expected = the last day of validity in quotation marks, such as "2027-03-02"

# Means: The last day of validity is before the date of the measurements.
# Matters: On the day of the measurements, the calibration was already invalid.
# Do: Correct the year of `valid_until` or of `date`.
# Example: `date = "2026-03-02"` with `valid_until = "2025-03-02"`
valid-until-before-measurements = `valid_until` ({ $date }) is before the measurements ({ $measured })
    .hint = correct `valid_until` or `date`

# Means: A template would write a file that a run also writes.
# Matters: The file of the template and the document of the run cannot both exist.
# Do: Give the template another name.
# Example: a template `parameters.json.j2`
template-name-reserved = a run writes its own `{ $file }`
    .hint = give the template another name

controller-template = template of a controller format

# Means: The residual field was computed with other parameters than the given ones.
# Matters: A field describes the errors that remain with one set of parameters. With other
# parameters it adds errors.
# Do: Use the parameters.json and the field.json of the same run.
# Example: `--field old/field.json --parameters out/parameters.json`
field-of-other-parameters = `{ $field }` does not belong to `{ $parameters }`: the hash of the parameters differs
    .hint = use both files of the same run
# Means: Both `valid_until` and `valid_for_months` are given.
# Matters: The two may give different days.
# Do: Remove one of the two keys.
# Example: `valid_until = "2027-03-02"` with `valid_for_months = 12`
valid-stated-twice = both `valid_until` and `valid_for_months` are given
    .hint = remove one of the two

# Means: `valid_for_months` counts from `date`, which is missing or is not a date.
# Matters: The last day of validity is unknown.
# Do: Set `date`, for example "2026-03-02", or use `valid_until`.
# Example: `valid_for_months = 12` without `date`
valid-months-without-date = `valid_for_months` needs the `date` of the measurements
    .hint = set `date = "2026-03-02"`, or give the last day as `valid_until`

# Means: `valid_for_months` is zero, or more than ten years.
# Matters: Reports and commands compare the last day of validity with the current date.
# Do: Give the interval in months, not in days.
# Example: `valid_for_months = 365`
valid-months-implausible = `valid_for_months` is { $months }
    .expected = 1 to { $most } months

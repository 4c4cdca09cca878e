### Messages of formats. Above each message: its explanation (see CONTRIBUTING.md, "A message").

column-without-place = a column needs either a `name` or a `number` from 1
column-wrong-occurrence = `occurrence` counts from 1, and `per_count` is not 0
# Means: `columns` of a format contains two forms of the orientation, or two forms of the
# uncertainties.
# Matters: Only one form can be read; the other could contradict it.
# Do: Keep the form that the file really contains, and remove the other.
# Example: `columns = ["x", "y", "z", "qw", "qx", "qy", "qz", "rx_deg", "ry_deg", "rz_deg"]`
columns-in-two-forms = `columns` contains { $quantity ->
        [orientation] two forms of the orientation
       *[uncertainty] standard and expanded uncertainties
    }
    .hint = remove the columns of one form

# Means: `columns` contains only some of the columns that belong together.
# Matters: A quaternion, a rotation matrix and a direction need all their numbers.
# Do: List all columns of the group, or none.
# Example: `columns = ["x", "y", "z", "i", "j"]`: the column `k` is missing
column-group-incomplete = `columns` contains only some of { $names }
    .hint = list all of them, or none

header-without-words = `header` is empty, expected a word of the row before the data
# Means: A key of a format describes columns that `columns` does not contain.
# Matters: The key has no effect, so the name of a column is probably wrong.
# Do: Add these columns to `columns`, or remove the key.
# Example: `rotation = "zyx"` for columns x, y, z without angles
key-needs-columns = `{ $key }` needs the columns { $columns }
    .hint = add these columns to `columns`, or remove `{ $key }`

# Means: The columns u95x, u95y, u95z contain expanded uncertainties, and their coverage factor is
# unknown.
# Matters: The standard uncertainty is the expanded uncertainty divided by the coverage factor (GUM
# 6.2).
# Do: Copy the factor from the certificate or the manual of the instrument.
# Example: a column `u95x` in `format` without `coverage_factor`
coverage-factor-missing = expanded uncertainties need their `coverage_factor`
    .hint = add it to `format`, for example `coverage_factor = 2`

row-number-unknown = `{ $stated }` is unknown; expected `row`, or `row + 100` for a second file
# Means: Some coordinates of a row have an uncertainty, and others have none.
# Matters: Observations are weighted by their uncertainties; a missing uncertainty is not zero.
# Do: List one column of uncertainties for each coordinate, or none.
# Example: `columns = ["x", "y", "z", "u1", "u2"]`
uncertainty-column-count = `columns` contains { $stated ->
        [one] 1 uncertainty
       *[other] { $stated } uncertainties
    } for { $coordinates ->
        [one] 1 coordinate
       *[other] { $coordinates } coordinates
    }
    .expected = one for each coordinate ({ $names }), or none

# Means: The format of delimited text does not give exactly one way to separate the columns.
# Matters: The way to separate columns is never guessed.
# Do: Keep one of the three keys.
# Example: `format = { columns = ["x", "y", "z"] }`
column-separation-unclear = the format gives { $stated ->
        [0] no way to separate columns
       *[other] { $stated } ways to separate columns
    }
    .expected = one of `delimiter`, `widths` and `sheet`
    .hint = `etalon formats FILE` proposes how to read the file

# Means: `widths` contains a width of zero.
# Matters: The column is empty.
# Do: Count the characters of each column, and write their numbers in `widths`.
# Example: `widths = [8, 0, 10]`
column-width-zero = a column of `widths` is 0 characters wide
    .hint = give the number of characters of each column

# Means: `columns` contains more columns than `widths`.
# Matters: The position of the last columns is unknown.
# Do: Write one width for each column.
# Example: `widths = [8, 10]` with `columns = ["x", "y", "z"]`
more-columns-than-widths = `columns` contains { $columns } columns, `widths` { $widths }
    .hint = write one width for each column

# Means: The comma is both the delimiter and the decimal mark.
# Matters: `1,25` could be one number or two.
# Do: Export the file with semicolons or tabs, or with decimal points.
# Example: `delimiter = ","` with `decimal = ","`
comma-ambiguous = a comma cannot be both the delimiter and the decimal mark: `1,25` could be one number or two
    .hint = export the file with semicolons or tabs, or with a decimal point

# Means: The thousands mark is also the decimal mark or the delimiter.
# Matters: `1.234` could be 1234 or 1.234.
# Do: Remove `thousands`, or set it to the mark in the file.
# Example: `thousands = "."` with `decimal = "."`
thousands-mark-ambiguous = the thousands mark `{ $mark }` is also the { $other ->
        [decimal] decimal mark
       *[delimiter] delimiter
    }
    .hint = remove or correct `thousands`

# Means: `columns` contains the same role twice.
# Matters: One of the two columns is ignored.
# Do: Correct the role. If a column is not needed, give it the role `-`.
# Example: `columns = ["label", "x", "y", "y"]`
column-role-twice = `columns` contains `{ $role }` twice
    .hint = correct one of them; a column with the role `-` is not read

# Means: `columns` contains coordinates of a fixed kind, and also c1, c2, c3, whose kind each row
# gives.
# Matters: Each row gives two positions.
# Do: Use either x, y, z (or angles and distances), or c1, c2, c3.
# Example: `columns = ["type", "x", "y", "c3"]`
coordinates-of-two-kinds = `columns` contains both coordinates of a fixed kind and c1, c2, c3
    .expected = either x, y, z or angles and distances, or c1, c2, c3

# Means: The meaning of the columns c1, c2, c3 is unknown.
# Matters: Each row contains a coordinate type. The table `types` gives the meaning of its numbers.
# Do: Add a column `type`, and list the coordinates of each type in `types`.
# Example: `columns = ["label", "c1", "c2", "c3"]` without `types`
row-types-missing = columns c1, c2, c3 need a column `type` and the key `types`
    .hint = for example `types = {"{"} 0 = ["x", "y", "z"], 7 = ["azimuth", "zenith", "distance"] {"}"}`

# Means: A coordinate type does not have three coordinates.
# Matters: Each of c1, c2 and c3 needs a meaning.
# Do: List three coordinates for each type, and add c1, c2 and c3 to `columns`.
# Example: `types = { 0 = ["x", "y"] }`
row-type-incomplete = `{ $key }` does not give the meaning of c1, c2 and c3
    .expected = three coordinates, and c1, c2, c3 in `columns`

# Means: The columns do not form the coordinates of one point.
# Matters: The position of a point is undefined.
# Do: Use Cartesian, cylindrical or spherical coordinates.
# Example: `columns = ["label", "x", "z"]`
not-coordinates = `{ $key }` contains { $count ->
        [0] no coordinates
       *[other] { $names }, which are not the coordinates of one point
    }
    .expected = x and y, and z in space; radius, azimuth and z; or azimuth, zenith or elevation, and distance

# Means: The format contains angles, but not their unit.
# Matters: 1 rad is 57.3 deg or 63.7 gon; the unit is never guessed.
# Do: Look at the largest angle in the file, and set `angle_unit` in the format.
# Example: `columns = ["azimuth", "zenith", "distance"]` without `angle_unit`
angle-unit-missing = `{ $key }` contains angles without a unit
    .hint = set `angle_unit` (option `--angle-unit`): "deg", "rad" or "gon"

# Means: `coordinates` gives another coordinate type than the columns.
# Matters: One of the two is wrong.
# Do: Compare a few rows with known points, then correct `coordinates` or `columns`.
# Example: `coordinates = "spherical"` with columns x, y, z
coordinate-type-differs = `coordinates` gives { $stated ->
        [cartesian] Cartesian
        [cylindrical] cylindrical
       *[spherical] spherical
    }, but `{ $key }` contains { $named ->
        [cartesian] Cartesian
        [cylindrical] cylindrical
       *[spherical] spherical
    } coordinates
    .hint = correct one of them

# Means: A column is given by its heading, but the format has no header row.
# Matters: The column cannot be found.
# Do: Set `header = 1`, or give the number of the column.
# Example: `columns = { x = "X" }` without `header`
header-not-stated = `columns` contains the heading `{ $column }`, but the format has no header row
    .hint = set `header = 1`, or give the number of the column

# Means: The last header row contains numbers in the columns of coordinates.
# Matters: The first measured point is lost, and all later rows have a wrong number.
# Do: Reduce `header` by one. Empty lines and comments do not count as rows.
# Example: `header = 1` for a file whose first line is a point
header-is-data = header row { $rows } contains numbers in the columns of coordinates
    .hint = empty lines and comments are not rows: set `header = { $fewer }`

# Means: The expression of a computed column is incomplete, or contains an unknown sign.
# Matters: The column cannot be computed.
# Do: Use headings, numbers of columns, numbers, the operators + - * / and brackets.
# Example: `x_mm = "x_t -"`
expression-malformed = cannot read the expression `{ $expression }`: { $fault ->
        [too-long] it is longer than 1000 characters
        [left-over] `{ $rest }` at the end is not expected
        [brackets-too-deep] its brackets are nested too deeply
        [too-many-signs] it has too many operators
        [bracket-open] a bracket is not closed
        [column-number] `$` is not followed by the number of a column, from 1
       *[incomplete] a column or a number is missing
    }
    .expected = headings, `$3` for the third column, and numbers, with + - * / and brackets between them

# Means: The file has no column with this name.
# Matters: The values of this column are needed.
# Do: Copy the name from the header of the file.
# Example: `columns = { rho3_mm = "RP33" }` for a header with RP1, RP2 and RP3
column-unknown = column `{ $column }` is missing

# Means: A table could not be built or written.
# Matters: This is a defect of the program, not of your files.
# Do: Report the error as a defect of etalon.
# Example: two columns of different lengths
table-failed = cannot build the table: { $reason }

# Means: A cell contains another value, but its column needs whole numbers.
# Matters: Rows are matched by these numbers.
# Do: Correct the cell, or read another column.
# Example: `1.5` in the column `cycle`
not-whole-number = `{ $value }` in the column `{ $column }` is not a whole number

# Means: A table in the output folder was changed or damaged after the run.
# Matters: Results computed from it are wrong.
# Do: Run the campaign again; do not edit files in the output folder.
# Example: `observations.parquet` of another run, copied into the output folder
stored-table-damaged = the stored table is damaged: { $reason }
    .hint = run the campaign again: `etalon run CAMPAIGN`

stored-row-count = it has { $found ->
        [one] 1 row
       *[other] { $found } rows
    } instead of { $rows }

# Means: A row of the file contains no measured point.
# Matters: This command needs a point in every row.
# Do: Remove the row, or measure the point again.
# Example: a row with empty coordinates in a table of balls
row-without-point = the row contains no point: { $reason }
    .hint = remove the row from the file

# Means: Some rows of the file contain no measured point. They are excluded.
# Matters: The result depends on the other rows only.
# Do: Check the first of these rows.
# Example: a QIF file with a feature that was not measured
rows-left-out = { $count ->
        [one] 1 row
       *[other] { $count } rows
    } excluded; the first: { $reason }

# Means: A joint is read from Galil arrays, but the value of one encoder count is unknown.
# Matters: The arrays contain encoder counts, not mm or deg.
# Do: Set `per_count` to the motion of one count, in the unit of the key.
# Example: `columns = { q1_mm = "one" }` for `format = "galil"`
count-value-missing = `{ $key }` does not give the value of one count: Galil arrays contain encoder counts
    .expected = `{ $key } = {"{"} name = "...", per_count = 0.001 {"}"}`, per_count in the unit of the key

# Means: An array of a Galil controller has an empty cell before its end.
# Matters: An array can be shorter than others, but has no gaps: the upload is damaged.
# Do: Upload the array again from the controller.
# Example: an empty cell in row 3 of 10
galil-array-hole = the array of `{ $column }` has an empty cell before its end
    .hint = upload the array again

galil-array-ended = no count: the array of { $columns } is shorter

# Means: An array of a Galil controller is empty.
# Matters: The joint of this array has no values.
# Do: Wait until the recording has ended, then upload the arrays again.
# Example: a heading without any count below it
galil-array-empty = one of the arrays is empty
    .hint = upload the arrays again after the recording has ended

# Means: A value of an array is not a 32-bit integer.
# Matters: A Galil controller records encoder counts. These values were scaled, or another program
# wrote the file.
# Do: If the values are scaled, omit `format = "galil"` and read the file as delimited text.
# Example: `3.5` in an array
not-a-count = { $value } is not an encoder count
    .expected = a 32-bit integer
    .hint = if the values are scaled, omit `format = "galil"`

# Means: A counter jumped by more than half of its range.
# Matters: The counter has overflowed: the joint values before and after the jump do not belong
# together.
# Do: Set the encoder to zero before the recording, and record again.
# Example: a count of 2147483647 followed by -2147483648
counter-wrapped = the counter has overflowed: { $to } follows { $from }
    .hint = set the encoder to zero before the recording

# Means: The cycle counter IPOC of a KUKA RSI recording skips cycles.
# Matters: Samples are missing, because telegrams were lost.
# Do: If the gaps are in an evaluated motion, record again with a faster computer.
# Example: IPOC 12, 16, 24 for a cycle of 4 ms
rsi-cycles-missing = { $count ->
        [one] 1 row
       *[other] { $count } rows
    } in which `IPOC` does not increase by { $step_ms } ms
    .hint = telegrams were lost, because the recording computer was too slow; if the gaps matter, record again

# Means: The order of the joint names changes between the rows of a ROS recording.
# Matters: Two publishers use the same topic, so a column contains values of two joints.
# Do: Record each publisher in a separate file.
# Example: `field.name0` is `shoulder` in one row and `elbow` in another
ros-joints-change = joint { $number } is `{ $found }` in this row and `{ $first }` in the first row
    .hint = two publishers use the same topic: record each in a separate file

# Means: A key of `columns` is neither a column of logs nor a joint with its unit.
# Matters: The unit of the values is unknown.
# Do: Write the name of the joint with its unit, for example `q1_deg`.
# Example: `columns = { q1 = "RP1" }`
log-column-unknown = `{ $key }` is not a column of a log
    .expected = `pose`, `cycle`, `time_s`, `label`, or a joint with its unit such as `q1_deg`, `q1_rad`, `rho1_mm`

# Means: Two keys give the same quantity of a log.
# Matters: The two could contradict each other.
# Do: Remove the key that you do not need.
# Example: `columns = { q1_deg = "J1", q1_rad = "J2" }`, or a column `time_s` together with
# `period_s`
log-column-twice = `{ $key }` gives `{ $name }` a second time
    .hint = remove one of them; `pose = "row"` replaces the column of the pose, `period_s` the column of the time

# Means: A key does not apply to this column or this log.
# Matters: The key has no effect. Probably the log is of another kind than the campaign says.
# Do: Remove the key, or correct `format`.
# Example: `values = "raw"` for a log that is not a TwinCAT export
log-key-inapplicable = `{ $key }` does not apply to { $column ->
        [none] this log
       *[other] `{ $column }`
    }
    .hint = { $key ->
        [per_count] `per_count` is the value of one encoder count of a joint: remove it
        [values] `values` belongs to `format = "twincat"`: remove it
        [comment] arrays are not text: remove `{ $key }`
        [decimal] arrays are not text: remove `{ $key }`
        [delimiter] arrays are not text: remove `{ $key }`
        [encoding] arrays are not text: remove `{ $key }`
        [sheet] arrays are not text: remove `{ $key }`
        [header] a TwinCAT export contains the names of its channels: remove `header`
       *[other] channels of a TwinCAT export have their own times: remove `{ $key }`
    }

# Means: The unit in the key of a column is not the unit that the controller writes.
# Matters: Joint values are wrong by the factor between the two units.
# Do: Change the unit in the key, for example from `q1_deg` to `q1_rad`.
# Example: `q1_deg = "actual_q_0"` for UR RTDE, which records rad
column-unit-differs = `{ $key }` gives { $stated }, but `{ $column }` is in { $known ->
        [wall-clock] whole seconds of the time of day; the clock of this log is `IPOC`
       *[other] { $known }
    }

write-column = write `{ $key } = "{ $column }"`

column-in-unit = a column in { $unit }

# Means: No line of the file contains all words of `header`.
# Matters: The data begin after this line, so they cannot be found.
# Do: Copy the words from the header row of the file.
# Example: `header = ["Meas Q"]` for a file with `Meas X`
header-words-missing = no line contains the words of the header: { $words }
    .hint = copy the words from the header row of the file

# Means: The file has no row of values after its header.
# Matters: There are no values to read.
# Do: Record or export the file again.
# Example: a file with a row of names alone
data-rows-missing = the file has no data rows
    .hint = export it again; if its only row contains values, set `header = false`

# Means: The number of fields in a row differs from the other rows, the columns or the format.
# Matters: Values are read from the wrong columns.
# Do: Correct the row. A missing delimiter or a decimal comma changes the number of fields; so does
# a file without its end.
# Example: `1;2;3` below the header `a;b`
row-field-count = the row has { $fields ->
        [one] 1 field
       *[other] { $fields } fields
    }
    .expected = { $expected }
    .hint = check delimiter, decimal mark and quotation marks: a decimal comma adds a field; in a file without its end, fields are missing

fields-like = { $like ->
        [header] { $width }, as in the header
        [first-row] { $width }, as in the first row
       *[names] at most { $width }, as in the row of names
    }

# Means: The rows do not contain the given delimiter.
# Matters: Each row is a single field.
# Do: Set `delimiter` and `decimal` to the marks in the file.
# Example: a file separated by semicolons, read with the default delimiter `,`
delimiter-does-not-split = the rows do not contain the delimiter `{ $delimiter }`

state-delimiter = set `delimiter = "{ $delimiter }"` and `decimal = "{ $decimal }"` (options --delimiter and --decimal)

state-delimiter-of-rows = set `delimiter` and `decimal` to the marks in the rows

# Means: The row that should contain the names of the columns contains numbers.
# Matters: If the file has no header, its first row of values would be lost.
# Do: Set `header = false`, and give the columns by their numbers.
# Example: a log whose first line is `1,0.5,0.7`
header-holds-numbers = the header row contains numbers instead of names
    .hint = if the file has no header, set `header = false` and give the columns by their numbers

# Means: A column is given by its number, but this number differs between files of this format.
# Matters: Another joint could be read without a message.
# Do: Give the column by its name.
# Example: `q1_mm = { number = 1, per_count = 0.001 }` for `format = "galil"`
column-by-number = a column of this format cannot be given by its number: { $format ->
        [galil] arrays are in alphabetical order, not in the order of joints
        [ros] the order of joints is arbitrary
       *[twincat] the order of channels differs between exports
    }
    .hint = give the column by its name

# Means: A column is given by a number that is larger than the number of columns.
# Matters: There is no such column.
# Do: Count the columns of the file from 1, and correct the number.
# Example: `q5_deg = 9` for a file with five columns
column-number-unknown = column { $number } does not exist
    .expected = a number from 1 to { $columns }

# Means: Several columns have the same heading, and the campaign does not say which one to read.
# Matters: These columns contain different values.
# Do: Add `occurrence`: 1 is the first column with this heading.
# Example: `target_current_0` in a UR RTDE recording, which has it twice
heading-repeated = the header has { $times ->
        [one] 1 column
       *[other] { $times } columns
    } `{ $column }`
    .expected = an `occurrence` from 1 to { $times }
    .hint = add its number: `{"{"} name = "{ $column }", occurrence = 1 {"}"}`

log-row-needs-values = read the log from the controller again, or remove the row: every row needs its values

# Means: The assembly mode of a row is neither 1 nor -1.
# Matters: The assembly mode selects one of the solutions of the direct kinematics.
# Do: Correct the cell. If you do not know the mode, omit the column: the nearer solution is then
# used.
# Example: 0 in the column `assembly`
assembly-mode-invalid = the assembly mode is { $value }
    .expected = 1 or -1
    .hint = correct it; if you do not know the mode, omit the column `assembly`

# Means: The log contains no time span in which all joints stay within the limits long enough.
# Matters: Without standstills, no joint values can be assigned to measured points.
# Do: Compare the limits with the noise of the encoders, and `at_least_s` with the dwell time of the
# program.
# Example: `at_least_s = 5` for a program that waits 2 s
standstill-missing = the robot of log `{ $log }` is never at a standstill for { $at_least_s } s
    .hint = its longest standstill within the limits lasts { FIXED($longest_s, 3) } s: check `at_least_s` and the limits

# Means: The search for standstills needs times, and the log has none.
# Matters: The duration of a standstill is unknown.
# Do: Read the column with the time, or set the period of the log.
# Example: [log.standstill] without `time_s` in `columns`
standstill-time-missing = [log.standstill] needs the time of each row
    .hint = set `time_s`, `time_ms` or `time_ns` in `columns`, or `period_s`

# Means: [log.standstill] contains no limit for this kind of joint.
# Matters: The limit decides whether the joint stands still.
# Do: Look up how much the encoder value varies at a standstill, and set the limit slightly above.
# Example: a log with `q1_deg`, and [log.standstill] without `within_deg`
standstill-limit-missing = [log.standstill] contains no limit for `{ $column }`
    .hint = set `{ $key }`: the largest difference of two values at a standstill

# Means: The pose, cycle, label or assembly mode changes during a standstill.
# Matters: It is unknown which of the values belongs to the joint values.
# Do: Omit the column. If the robot moved, reduce the limits of [log.standstill].
# Example: pose 3 and pose 4 within one standstill
changes-at-standstill = `{ $column }` changes from { $from } to { $to } during a standstill
    .hint = omit the column, or reduce the limits of [log.standstill]

# Means: In the log to simulate, two keys of `columns` use the same column, or a column number is
# too large.
# Matters: A column contains a single quantity.
# Do: Use a different column for each key.
# Example: `columns = { q1_deg = 1, q2_deg = 1 }`
simulated-column-clash = the column of `{ $key }` cannot be written
    .expected = one column for each key, at most { $most } columns

# Means: `columns` contains a quantity that the simulation does not produce.
# Matters: The log cannot be written.
# Do: Remove the key from the campaign before you simulate it.
# Example: `columns = { q7_deg = "J7" }` for a robot with six joints
simulated-column-unknown = `{ $key }` cannot be simulated
    .expected = `pose`, `cycle`, `time_s` and the joints with their units

# Means: `columns` contains no channel of a TwinCAT export.
# Matters: Nothing is read.
# Do: List the channels of the joints in `columns`.
# Example: `format = "twincat"` with `columns = {}`
log-columns-missing = `columns` of this log contains no channel

# Means: Both a channel and its unit have a scale factor or offset, and the values are raw.
# Matters: It is not documented in which order the two apply.
# Do: Change the export to scaled values, and set `values = "scaled"`.
# Example: `ScaleFactor` 0.001 and `Unit ScaleFactor` 1000 with `values = "raw"`
twincat-two-scales = both channel `{ $channel }` and its unit have a scale
    .hint = export scaled values and set `values = "scaled"`

# Means: A channel has a scale factor or offset, and the file does not say whether the values are
# already scaled.
# Matters: Joint values could be wrong by this factor.
# Do: Look up the option of the export, and set `values` accordingly.
# Example: `ScaleFactor` 0.001 in the head of the export, and no `values` in [log]
twincat-scale-undecided = channel `{ $channel }` has a scale (factor and offset { $scale }; its unit { $unit_scale }): it is unknown whether the values are scaled
    .hint = set `values = "raw"` or `values = "scaled"`, according to the option of the export

# Means: A channel has values again after an empty cell.
# Matters: In a TwinCAT export, a channel ends only once: the file was edited or damaged.
# Do: Export the recording again without editing it.
# Example: an empty cell in the middle of a channel
channel-resumes = channel `{ $channel }` continues after its end
    .hint = export the recording again

# Means: The selected channels have no time in common.
# Matters: A row of the log needs the values of all joints at one time. etalon does not interpolate.
# Do: Export channels of one task with the same sample time.
# Example: channels sampled at 0, 2, 4 ms and at 1, 3, 5 ms
channels-without-common-time = these channels have no time in common
    .hint = export channels of one task with the same sample time

# Means: A channel has samples at times at which another channel has none.
# Matters: These samples are excluded, because etalon does not interpolate.
# Do: Nothing, if the remaining samples are dense enough. Otherwise export channels with the same
# sample time.
# Example: a channel with 1 ms and a channel with 2 ms
channel-samples-unused = channel `{ $channel }`: { $count ->
        [one] 1 sample
       *[other] { $count } samples
    } excluded, because another channel has none at these times

# Means: The file does not begin with the head of a TwinCAT 3 Scope export.
# Matters: The head contains the names of the channels and their units.
# Do: Export the recording as CSV, or give another `format`.
# Example: a CSV file of another program with `format = "twincat"`
twincat-head-malformed = this is not a TwinCAT 3 Scope export: { $part ->
        [first-line] its first line does not begin with `Name` and a separator
        [names] no row of its head contains the names of the channels
       *[end] no empty line follows its head
    }
    .hint = export the recording as CSV again, or give another `format`

# Means: A row of the head and the row of names have different numbers of fields.
# Matters: The separator also occurs as the decimal mark, or in a name.
# Do: Export the recording again with tabs or semicolons as separator.
# Example: an export separated by commas on a computer with decimal comma
twincat-head-ragged = row `{ $row }` of the head has { $fields } fields, the row of names has { $width }: the separator also occurs in values or names
    .hint = export it again with tabs or semicolons as separator

# Means: The separator of a TwinCAT export is a blank.
# Matters: Blanks also mean missing values, and occur in names.
# Do: Export the recording again with tabs or semicolons as separator.
# Example: a first line `Name scope`
twincat-separated-by-blanks = the separator of the export is a blank, but blanks also mean missing values and occur in names
    .hint = export it again with tabs or semicolons as separator

# Means: A scale factor or offset in the head of a TwinCAT export is not a number.
# Matters: The values of the channel cannot be scaled.
# Do: Export the recording again; the head was edited or damaged.
# Example: `ScaleFactor` with the value `x`
channel-scale-not-number = `{ $key }` of channel `{ $channel }` is `{ $value }`, not a number
    .hint = export the recording again

# Means: The delimiter of the campaign is not the delimiter of the export.
# Matters: The rows could not be split into columns.
# Do: Remove `delimiter` from this log.
# Example: `delimiter = ";"` for an export separated by tabs
delimiter-differs = the delimiter of the export is { $separator }
    .hint = remove `delimiter` from this log: the program finds it in the export

# Means: Two tables have different coordinates: one of them has no z, or no angle.
# Matters: An error is the difference of two positions, so both need the same coordinates.
# Do: Give both tables the same coordinates. For a planar robot, omit z in both.
# Example: attained poses with x, y, z and commanded poses with x, y
coordinates-differ = attained and commanded positions have different coordinates
    .expected = the coordinates of `{ $file }`
    .hint = for a planar robot, omit `z_mm` in both tables

# Means: A coordinate or an angle in a row is empty, infinite or not a number.
# Matters: The pose of this row is unknown.
# Do: Complete the cell, or remove the row.
# Example: an empty cell in the column `x_mm`
coordinate-missing = a coordinate is missing or non-finite
    .hint = complete the cell, or remove the row

# Means: The table contains columns that this command does not use.
# Matters: They have no effect. If a name is misspelled, its column has no effect either.
# Do: Check the spelling of these names.
# Example: a column `aproach`
columns-not-read = not read: { $count ->
        [one] column
       *[other] columns
    } { $columns }

# Means: robot.toml contains backlash of a joint, but the table does not contain its direction of
# approach.
# Matters: The sign of the backlash depends on the direction of approach.
# Do: Add the column. From a log with times, a campaign computes the direction itself.
# Example: `backlash = ["q2"]` and a table without `q2_direction`
joint-direction-missing = `backlash` of joint `{ $joint }` needs the direction of approach of the joint
    .expected = a column `{ $column }`: +1 from below, -1 from above
    .hint = use a log with times, or remove the joint from `backlash` of the robot file

# Means: The direction of approach of a joint is neither +1 nor -1.
# Matters: The sign of the backlash depends on the direction of approach.
# Do: Write +1 for an approach from below, and -1 for an approach from above.
# Example: 0 in the column `q2_direction`
joint-direction-invalid = `{ $column }` is { $value ->
        [missing] missing
       *[other] { $value }
    }
    .expected = +1 if `{ $joint }` approached from below, -1 from above

# Means: The table contains one joint in two columns with different units.
# Matters: The two columns could contradict each other.
# Do: Remove the column that you do not trust.
# Example: columns `q1_deg` and `q1_rad`
joint-column-twice = the table contains joint `{ $joint }` twice: `{ $first }` and `{ $second }`
    .hint = remove one of the columns

in-row = row { $row }: { $message }

# Means: The table of commanded poses contains a pose twice.
# Matters: It is unknown which position was commanded.
# Do: Remove the wrong row, or give one of the two poses another name.
# Example: two rows with the pose 1
pose-commanded-twice = pose { $pose } is commanded twice
    .hint = remove or rename one of the rows

# Means: An attained pose is missing in the table of commanded poses.
# Matters: Its accuracy is undefined.
# Do: Add the pose to the table of commanded poses, or correct its name.
# Example: pose 7 attained, poses 1 to 5 commanded
pose-not-commanded = pose { $pose } is not among the commanded poses
    .hint = add it to `{ $file }`, or correct its name

# Means: The table contains a pose twice in one cycle.
# Matters: Several visits could count as one visit, or several readings of one visit as several
# visits.
# Do: Number the cycles. If the pose has several approaches, name them in `approach`. If a visit has
# several readings, number them in `reading`.
# Example: two rows with pose 1 and cycle 1
pose-attained-twice = pose { $pose } was attained twice in cycle { $cycle }
    .hint = number the cycles, name approaches in `approach`, or number readings of one visit in `reading`

# Means: A commanded pose was not measured.
# Matters: The characteristics are computed from the other poses.
# Do: Measure the pose, or remove it from the commanded poses.
# Example: poses 1 to 5 commanded, poses 1 to 4 measured
commanded-pose-not-measured = pose { $pose } is a commanded pose but was not measured

# Means: The table contains no measured pose.
# Matters: There is nothing to evaluate.
# Do: Compare the names of the poses in both tables.
# Example: attained poses whose names are all missing in the table of commanded poses
no-pose-measured = no pose was measured
    .hint = compare the names of the poses in both tables

# Means: A recorded motion has no time stamps.
# Matters: Velocities and passes need the time of each sample.
# Do: Add the sampling rate of the instrument, or record with time stamps.
# Example: a recording with x, y, z alone
recording-time-missing = the recording has no time column
    .expected = a column `time_s`, or the sampling rate
    .hint = add the sampling rate of the instrument: `--rate-hz 1000`, in a campaign `rate_hz = 1000`

row-repeats = remove this row: it has the coordinates of line { $line }, digit for digit

state-sampling-rate = add the sampling rate (`--rate-hz`): the time stamps are coarser than the sampling

# Means: The duration of the samples at the given sampling rate differs from the duration in their
# time stamps.
# Matters: All velocities are wrong by the ratio of the two durations.
# Do: Correct the sampling rate. If the time stamps are wrong, omit their column.
# Example: `--rate-hz 1000` for a recording that was sampled at 200 Hz
rate-contradicts-stamps = { $samples } samples at { $rate_hz } Hz take { FIXED($by_rate_s, 2) } s; their time stamps span { FIXED($stamped_s, 2) } s
    .hint = correct the sampling rate, or omit the column of time stamps

# Means: More than 1 % of the samples are faster than 20 m/s.
# Matters: No industrial robot is so fast: the sampling rate, the unit or the order of the samples
# is wrong.
# Do: Check the sampling rate, the unit, and the order of the samples.
# Example: a recording in m that is read in inches
recording-implausible = { $count } of { $samples } samples are faster than 20 m/s: no robot moves so fast
    .hint = check the sampling rate, the unit and the order of the samples

# Means: The drift of positions is compensated with the reference targets, but the drift of angles
# is not.
# Matters: The orientation errors contain the rotation of the set-up.
# Do: Give all three angles, and the order of their rotations.
# Example: a table with `c_deg` alone for a spatial robot
angles-not-compensated = the reference targets do not compensate the drift of the angles
    .expected = all of a_deg, b_deg, c_deg (for a planar robot c_deg) and the order of their rotations
    .hint = add the order: `--rotation-order "Rz(c) Ry(b) Rx(a)"`, in a campaign `rotation_order`

# Means: A cycle was measured before the first measurement of the reference targets.
# Matters: Its drift is unknown.
# Do: Start the test with a measurement of the reference targets, or exclude these cycles.
# Example: cycles from 1 and reference targets from cycle 2
cycle-before-reference-targets = cycle { $cycle } was measured before any reference target
    .hint = measure the reference targets before the test; their first measurement is in cycle { $first }

# Means: A reference target has two positions in one cycle.
# Matters: It is unknown which of the two positions is right.
# Do: Remove the wrong row, or correct the name of the target.
# Example: two rows with target `a` and cycle 1
reference-target-twice = the reference target `{ $target }` was measured twice in cycle { $cycle }
    .hint = remove one of the rows, or correct its name

# Means: The reference targets of a cycle are not the same as in the first cycle.
# Matters: The drift is computed from the same targets in all cycles.
# Do: Measure all reference targets each time.
# Example: targets a, b, c in cycle 1, and a, b in cycle 3
reference-targets-differ = the reference targets of cycle { $cycle } differ from the first ones
    .expected = { $targets }

# Means: `columns` contains a quantity that a table of observations does not have.
# Matters: The column is ignored.
# Do: Choose a name from docs/observations.md. The names of coordinates and joints end with their
# unit.
# Example: `columns = { x = "X" }`
observation-column-unknown = `{ $column }` is not a column of observations
    .hint = the names of coordinates and joints end with their unit: x_mm, q1_deg; docs/observations.md lists all columns

# Means: `columns` gives headings of the table as names, and names of etalon as headings.
# Matters: No column can be read.
# Do: Write the name of etalon first, then the heading of the table.
# Example: `columns = { J1 = "q1_deg" }` instead of `columns = { q1_deg = "J1" }`
columns-inverted = `columns` is inverted: it gives headings of the table as names of columns

# Means: Two quantities have the same column of the file.
# Matters: At least one of the two is wrong.
# Do: Correct the column of one quantity.
# Example: `columns = { q1_deg = "J1", q2_deg = "J1" }`
column-stated-twice = both `{ $first }` and `{ $second }` have the column `{ $column }`
    .hint = correct one of them

# Means: Several columns have the same heading.
# Matters: It is unknown which of these columns is meant.
# Do: Rename or remove one of the columns, or give the column by its number.
# Example: a header `pose,rho1_mm,rho1_mm`
heading-twice = the header contains `{ $column }` more than once
    .hint = rename or remove one of the columns

# Means: A quantity is given for all rows, but the table also has a column for it.
# Matters: The two could contradict each other.
# Do: Remove the key, or skip the column.
# Example: `target = "ball"` for a table with a column `target`
stated-and-in-table = `{ $key }` is given, but the table also has a column with this name
    .hint = remove one of them

# Means: No row passes the filters `only` and `without`.
# Matters: There are no values to read.
# Do: Compare the cells in the filters with the cells of the file: spelling, capital letters,
# blanks.
# Example: `only = { device = "T1" }` for a file with `T-1`
no-row-selected = no row passes `only` and `without`
    .hint = compare their cells with the cells of the file

# Means: A column of the log has no value in any row: its cells are empty or mean "not measured".
# Matters: No row of the log has the values of all joints.
# Do: Correct the name or number of the column, or list in `missing` which cells mean "not
# measured".
# Example: a channel that was selected and not recorded
log-without-values = no row of the log has a value in `{ $column }`
    .hint = correct the column, or list other cells in `missing`

# Means: A constant of `[log]` has a wrong value for its column, for example a text instead of a
# number, or a fraction for a cycle. `cycle = "visit"` needs the column `pose`.
# Matters: The rows of the log cannot have this value.
# Do: Correct the constant.
# Example: `constants = { q7_mm = "zero" }`
log-constant-invalid = the constant { $value } cannot be the column `{ $column }` of a log
    .hint = { $column ->
        [cycle] use a whole number, or "visit" in a log with poses
        [assembly] use 1 or -1
        [pose] use a number or a name
       *[other] use a number
    }

# Means: A computed column has an infinite or undefined value in a row.
# Matters: The value cannot be used.
# Do: Look for a division by zero in the expression.
# Example: `x_mm = "a / b"` for a row with b = 0
computed-not-finite = the computed value of `{ $column }` is { $value }
    .hint = check the expression: it divides by zero or overflows

# Means: A name begins like a formula of a spreadsheet.
# Matters: etalon writes the name to other tables, and a spreadsheet runs it as a formula.
# Do: Rename it.
# Example: `=1+1` in the column `target`
name-is-formula = a spreadsheet would read the name `{ $name }` in the column `{ $column }` as a formula
    .hint = use a name that does not begin with = + - or @

# Means: The file contains no bytes.
# Matters: There is nothing to read.
# Do: Check whether the export has ended, and export the file again.
# Example: an export that was interrupted
file-empty = the file is empty
    .hint = export it again

# Means: The file is a known kind of document, but contains no measured points or joint values.
# Matters: There is nothing to propose for it.
# Do: Export the points, or write the numbers as CSV: one row for each point or pose, below a row
# with the names of the columns.
# Example: `etalon formats robot.yaml`
file-without-points = this is { $kind ->
        [json] a JSON document
        [yaml] a YAML document
        [toml] a TOML or INI document
        [certificate] a digital calibration certificate: it contains results, but no measured points
        [sdr33] a file of observations of a Sokkia total station (SDR33)
        [m5] a file of observations of a Zeiss or Trimble total station (M5)
        [south] a file of observations of a South total station
        [mesh] a mesh (OBJ, OFF, VRML or VTK): its vertices are not measured points of a robot
        [las] a scan in the LAS format
        [urscript] a program of a Universal Robots controller: it contains commanded poses, no measured ones
        [krl] a program of a KUKA controller: it contains commanded poses, no measured ones
        [gcode] a program of a machine tool (G-code): it contains commanded positions, no measured ones
        [cad] a CAD model (STEP or DXF): its points are nominal
        [roughness] a file of roughness parameters of a Mitutoyo SJ-410 without coordinates
       *[xml] an XML document of an unknown kind
    }
    .expected = measured points or a log, as a table of text or a workbook
    .hint = { $kind ->
        [certificate] give the file with the measured points
        [roughness] give the file with the measured points
        [sdr33] export the coordinates of the points as text, one row for each point
        [m5] export the coordinates of the points as text, one row for each point
        [south] export the coordinates of the points as text, one row for each point
        [mesh] give the file with the measured points; a robot's meshes belong to its URDF
        [las] export the points as text, PLY or E57
        [urscript] give the file with the measured points
        [krl] give the file with the measured points
        [gcode] give the file with the measured points
        [cad] give the file with the measured points
       *[other] write the numbers as CSV: one row for each point or pose, below a row with the names of the columns
    }

# Means: A file of a total station contains directions and distances from two set-ups.
# Matters: Each set-up has its own origin and its own zero direction, so that the points would not
# belong together.
# Do: Export the coordinates of the points, or one file for each set-up.
# Example: Leica GSI with a second line of words 84, 85, 86 before words 21, 22, 31
stations-several = the instrument was set up again at line { $line }: directions and distances of two set-ups have no common frame
    .hint = export the coordinates of the points (words 81, 82, 83), or one file for each set-up

# Means: The file contains 4×4 matrices, each in four rows of four numbers.
# Matters: Each row would be read as a point, and the poses would be lost.
# Do: Write each matrix in one row of 16 numbers, row by row, for example by
# `numpy.savetxt(file, poses.reshape(-1, 16))`.
# Example: a matrix in four rows, with `0 0 0 1` in the last one
matrices-in-blocks = the rows are 4×4 matrices, one below the other
    .expected = a row for each point or pose
    .hint = write each matrix in one row of 16 numbers, row by row

# Means: A GSI file contains lengths in feet.
# Matters: The file does not state whether these are international feet or US survey feet; the two
# differ by 2 µm per metre.
# Do: Export the points in metres.
# Example: `31..07+0000000000241118`
gsi-feet = the length is in feet, and GSI does not state which foot
    .expected = lengths in metres
    .hint = export the points in metres

# Means: Each number has its name in front, as a program prints values for people.
# Matters: A name and its number are one text, so that the number cannot be given a meaning.
# Do: Write one number per column, below a row with the names.
# Example: `point x:428.031 y:-37.130 z:431.590`
numbers-behind-names = the numbers are behind their names, such as `x:428.031`
    .expected = one number per column
    .hint = write the names once as a row of headings, and the numbers below it

# Means: The numbers are in lists with brackets, as Python prints them.
# Matters: A list is one text, so that its numbers cannot be given a meaning.
# Do: Write one number per column, for example by `numpy.savetxt` or `pandas.DataFrame.to_csv`.
# Example: `P1: [0.10, 0.25, 0.40]`
numbers-in-brackets = the numbers are in lists with brackets
    .expected = one number per column
    .hint = write the numbers without brackets, for example by `numpy.savetxt`

# Means: A cell contains several numbers: one mark divides the cells of a row, and another mark
# divides the numbers of a cell.
# Matters: The file does not tell which numbers belong to one quantity.
# Do: Write one number per column.
# Example: `0.01;512.5,-20.3,300.5,0,0,0,1`
numbers-in-cells = the cells contain lists of numbers: two delimiters divide the numbers of a row
    .expected = one number per column
    .hint = write one number per column, with one delimiter

# Means: Whatever the delimiter and the decimal mark, the rows of the file contain fewer than two
# numbers.
# Matters: The file contains neither points nor joint values in a form that etalon can read.
# Do: Export the points as text, with one row for each point.
# Example: `etalon formats letter.txt`
no-rows-of-numbers = { $file ->
        [workbook] no sheet of the workbook has
        [arrays] no array of the file is of joint values or points, with
       *[text] no reading as delimited text gives
    } rows with two or more numbers
    .hint = export the points as text, with one row for each point

robot-does-not-test = the nominal robot of the model `{ $model }` cannot test the proposal, because its flange does not move freely in space

robot-not-tested = the nominal robot cannot test the proposal: at least { $fewest } rows are needed in which three joints move, with coordinates that span space; `etalon axes` evaluates sweeps of one joint at a time

robot-contradicts = the nominal robot does not reproduce { $points } with any of the tried orders, directions and units of the joints{ $known ->
        [yes] ; the smallest residual is { FIXED($rms_mm, 2) } mm (root mean square)
       *[no] {""}
    }

robot-ambiguous = the data do not determine order and direction of { $joints }: with another choice the residual is { FIXED($rms_mm, 3) } mm (root mean square)

robot-units-ambiguous = the data do not determine the units of the joints: with another unit the residual is { FIXED($rms_mm, 3) } mm (root mean square)

robot-finds-targets = the nominal robot reproduces the coordinates if each value of { $column } is a separate target

robot-contradicts-unit = the heading of { $column } gives { $stated }, but the kinematics of the nominal robot agree with { $unit }

robot-contradicts-order = the nominal robot agrees with the joints in the order { $columns }, not in the order that the headings state: check headings and robot file

robot-reverses = { $column } has the opposite direction of `{ $joint }`: the nominal robot agrees with the opposite sign

robot-orders = the nominal robot agrees with the joints in the order { $columns }

robot-reproduces = the nominal robot reproduces { $points } in { $unit } with a residual of { FIXED($rms_mm, 4) } mm (root mean square of { $rows } rows, base and target fitted)
robot-orders-angles = the orientations of the nominal robot fit { $kind ->
        [vector] a rotation vector
       *[angles] three angles in the order { $order }
    } in { $unit }, within { FIXED($misfit_deg, 2) }°; no other form fits
robot-orders-quaternion = the orientations of the nominal robot fit the quaternion with the scalar { $scalar ->
        [first] first
       *[last] last
    }

points-commanded = { $points } are commanded or computed, not measured: the nominal robot reproduces them to the last digit (residual { FIXED($rms_mm, 6) } mm)

points-perhaps-commanded = { $points } may be commanded, not measured: the residual of { FIXED($rms_mm, 4) } mm is as small as the rounding of coordinates and joints

file-is = `{ $file }`: { $kind }, { $rows ->
        [one] 1 row
       *[other] { $rows } rows
    }{ $coordinates ->
        [none] {""}
        [open] , coordinates of unknown unit
       *[other] , coordinates in { $coordinates }
    }{ $joints ->
        [none] {""}
        [open] , joints of unknown unit
       *[other] , joints in { $joints }
    }{ $times ->
        [none] {""}
        [open] , times of unknown unit
       *[other] , times in { $times }
    }

files-join = { $matching } of { $keys } rows of `{ $file }` match a row of `{ $log }` by { $by }

files-not-joined = no key joins all exports with the { $rows } rows of `{ $log }`
recording-not-joined = the times do not join `{ $log }`: there are fewer standstills of at least 1 s than points ({ $standstills }), and no clock offset assigns a separate row to each point
rows-of-several-targets = `{ $file }` has { $rows } rows, { $count } for each of the { $poses } rows of the log: it may contain { $count } targets. Write target and pose of each row into columns

doubt-numbers-and-text = column { $column } contains numbers in { $count } of { $rows } rows, and `{ $text }`: exclude such rows (`header`, `comment`)

doubt-array-columns = `{ $array }` has { $count } columns: joints, coordinates, or both
zero-count-alone = `zero_count` has no effect without `per_count`

# Means: `payload` in robot.toml lists joints that bend under a load, but the table has no column of
# the load.
# Matters: Without mass and centre of mass, the deflection is unknown.
# Do: Add the column, or give the load as a constant of the file.
# Example: `payload = [2, 3]` and a table without `load_kg`
payload-column-missing = `payload` of the robot file needs the column `{ $column }`
    .expected = `load_kg`, and the centre of mass in the flange: `load_x_mm`, `load_y_mm`, `load_z_mm`
    .hint = add the column, 0 in rows without a load, or remove `payload` from the robot file

# Means: A cell of the payload is empty, infinite, or a negative mass.
# Matters: The deflection of the row is unknown.
# Do: Correct the cell. In a row without a load, write 0.
# Example: -5 in the column `load_kg`
payload-invalid = `{ $column }` is { $value ->
        [missing] missing
       *[other] { $value }
    }
    .expected = a mass in kg of at least 0, or a length in mm
    .hint = write 0 in rows without a load

# Means: `torque` in robot.toml lists a joint that bends in proportion to its torque, but the table
# has no column of this torque.
# Matters: Without the torque, the deflection of the joint is unknown.
# Do: Add the column, or remove the joint from `torque`.
# Example: `torque = [2, 3]` and a table without `tau3_nm`
torque-column-missing = `torque` of the robot file lists joint `{ $joint }`, but the column `{ $column }` is missing
    .hint = add the column, or remove the joint from `torque` in the robot file

# Means: A cell of a torque is empty or infinite.
# Matters: The deflection of the joint in this row is unknown.
# Do: Complete the cell with a torque in N·m, or exclude the row.
# Example: an empty cell in the column `tau2_nm`
torque-invalid = `{ $column }` is { $value ->
        [missing] missing
       *[other] { $value }
    }
    .expected = a torque in N·m
    .hint = correct the cell, or exclude the row

# Means: `drift` or `expansion` in robot.toml depends on the temperature of the robot, but the table
# has no column of it.
# Matters: Without the temperature, the change of joint zeros and lengths is unknown.
# Do: Add the column, or remove `drift` and `expansion`.
# Example: `expansion = true` and a table without `temperature_c`
temperature-column-missing = `drift` or `expansion` of the robot file needs the column `{ $column }`
    .expected = the temperature of the robot in °C
    .hint = add the column, or remove `drift` and `expansion` from the robot file

# Means: A cell of the temperature is empty, infinite, or below absolute zero.
# Matters: The change of joint zeros and lengths in this row is unknown.
# Do: Correct the cell, or exclude the row.
# Example: -999 in the column `temperature_c`
temperature-invalid = `{ $column }` is { $value ->
        [missing] missing
       *[other] { $value }
    }
    .expected = a temperature in °C, above absolute zero
    .hint = correct the cell, or exclude the row

# Means: One cycle has no reading of a pose that most other cycles contain. The table has no column
# `approach`, so it is unknown whether the robot passed this pose.
# Matters: The next visit counts for AP and RP, but not for a single approach and not for vAP.
# Do: Nothing, if only the reading failed. If the robot took another path, name the approaches in a
# column `approach`.
# Example: cycle 17 has rows of poses 1, 2 and 4, all other cycles of poses 1 to 4
approach-unknown = unknown approach of { $visits }{ $count ->
        [one] {""}
       *[other] {""}; { $count } in all
    }: the reading of the previous pose is missing
    .hint = if the robot passed no other pose in between, name the approaches in a column `approach`

visit-of-cycle = pose { $pose } in cycle { $cycle }

### Messages of formats. Above each message: its explanation (see CONTRIBUTING.md, "A message").

column-without-place = a column has either a `name` or a `number` from 1
column-wrong-occurrence = `occurrence` counts from 1, and `per_count` is not 0
# Means: `columns` of a format names an orientation, or uncertainties, in two forms.
# Matters: Only one form can be read; the other may differ from it.
# Do: Remove the columns of one form from `columns`.
# Example: `columns = ["x", "y", "z", "qw", "qx", "qy", "qz", "rx_deg", "ry_deg", "rz_deg"]`
columns-in-two-forms = `columns` names { $quantity ->
        [orientation] two forms of the orientation
       *[uncertainty] standard and expanded uncertainties
    }
    .hint = remove the columns of one form

# Means: `columns` names only some of the columns that belong together.
# Matters: A quaternion, a rotation matrix or a direction is undefined without all its numbers.
# Do: Name all columns of the group, or none.
# Example: `columns = ["x", "y", "z", "i", "j"]`: the column `k` is missing
column-group-incomplete = `columns` names only some of { $names }
    .hint = name all of them, or none

header-without-words = `header` is empty, expected a word of the row before the data
# Means: A key of a format describes columns that `columns` does not name.
# Matters: The key would have no effect, so a column is probably misnamed.
# Do: Name these columns in `columns`, or remove the key.
# Example: `rotation = "zyx"` for columns x, y, z without angles
key-needs-columns = `{ $key }` needs the columns { $columns }
    .hint = name these columns in `columns`, or remove `{ $key }`

# Means: The columns u95x, u95y, u95z hold expanded uncertainties, and their coverage factor is
# unknown.
# Matters: The standard uncertainty is the expanded uncertainty divided by the coverage factor (GUM
# 6.2).
# Do: Give the factor from the certificate or the manual of the instrument.
# Example: a column `u95x` in `format` without `coverage_factor`
coverage-factor-missing = expanded uncertainties need their `coverage_factor`
    .hint = give it in `format`, for example `coverage_factor = 2`

row-number-unknown = `{ $stated }` is unknown, expected `row`, or `row + 100` for a second file
# Means: Some coordinates of a row have an uncertainty and others have none.
# Matters: Observations are weighted by their uncertainties; a missing one is not zero.
# Do: Name one column of uncertainties for each coordinate, or none.
# Example: `columns = ["x", "y", "z", "u1", "u2"]`
uncertainty-column-count = `columns` names { $stated ->
        [one] 1 uncertainty
       *[other] { $stated } uncertainties
    } for { $coordinates ->
        [one] 1 coordinate
       *[other] { $coordinates } coordinates
    }
    .expected = one for each coordinate ({ $names }), or none

# Means: The format of delimited text gives no separation of columns, or more than one.
# Matters: The separation of columns is never guessed.
# Do: Give one of the three keys.
# Example: `format = { columns = ["x", "y", "z"] }`
column-separation-unclear = the format gives { $stated ->
        [0] no separation of the columns
       *[other] { $stated } separations of the columns
    }
    .expected = one of `delimiter`, `widths` and `sheet`
    .hint = `etalon formats FILE` proposes how to read the file

# Means: `widths` has a column without characters.
# Matters: The column could hold no value.
# Do: Give the number of characters of each column.
# Example: `widths = [8, 0, 10]`
column-width-zero = a column of `widths` is 0 characters wide
    .hint = give the number of characters of each column

# Means: `columns` names more columns than `widths` describes.
# Matters: The last columns have no position in the row.
# Do: Give a width for each column.
# Example: `widths = [8, 10]` with `columns = ["x", "y", "z"]`
more-columns-than-widths = `columns` names { $columns } columns, `widths` has { $widths }
    .hint = give one width for each column

# Means: The comma is given as delimiter and as decimal mark.
# Matters: `1,25` would be one number or two.
# Do: Export the file with other marks.
# Example: `delimiter = ","` with `decimal = ","`
comma-ambiguous = a comma cannot both separate columns and mark decimals: `1,25` would be one number or two
    .hint = export the file with semicolons or tabs, or with a decimal point

# Means: The mark between groups of three digits is also the decimal mark or the delimiter.
# Matters: `1.234` would be 1234 or 1.234.
# Do: Remove `thousands`, or give the mark of the file.
# Example: `thousands = "."` with `decimal = "."`
thousands-mark-ambiguous = the thousands mark `{ $mark }` is also the { $other ->
        [decimal] decimal mark
       *[delimiter] delimiter
    }
    .hint = remove or correct `thousands`

# Means: `columns` gives the same role to two columns.
# Matters: One of the columns would be ignored.
# Do: Correct the role, or give the unused column the role `-`.
# Example: `columns = ["label", "x", "y", "y"]`
column-role-twice = `columns` names `{ $role }` twice
    .hint = correct one of them; the role `-` marks a column that is not read

# Means: `columns` names coordinates of a fixed kind and coordinates whose kind each row gives.
# Matters: A row would have two positions.
# Do: Name either x, y, z (or angles and distances), or c1, c2, c3.
# Example: `columns = ["type", "x", "y", "c3"]`
coordinates-of-two-kinds = `columns` names both coordinates of a fixed kind and c1, c2, c3
    .expected = either x, y, z or angles and distances, or c1, c2, c3

# Means: The meaning of the columns c1, c2, c3 is not given.
# Matters: Each row gives its coordinate type; the meaning of its numbers depends on the table of
# types.
# Do: Name a column `type`, and give the coordinates of each type in `types`.
# Example: `columns = ["label", "c1", "c2", "c3"]` without `types`
row-types-missing = columns c1, c2, c3 need a column `type` and the key `types`
    .hint = for example `types = {"{"} 0 = ["x", "y", "z"], 7 = ["azimuth", "zenith", "distance"] {"}"}`

# Means: A coordinate type does not have three coordinates.
# Matters: c1, c2 and c3 each need a meaning.
# Do: Give three coordinates for each type, and name c1, c2 and c3 in `columns`.
# Example: `types = { 0 = ["x", "y"] }`
row-type-incomplete = `{ $key }` does not give the meaning of c1, c2 and c3
    .expected = three coordinates, and c1, c2, c3 in `columns`

# Means: The named columns do not form the coordinates of one point.
# Matters: Without them the position of a point is undefined.
# Do: Name Cartesian, cylindrical or spherical coordinates.
# Example: `columns = ["label", "x", "z"]`
not-coordinates = `{ $key }` names { $count ->
        [0] no coordinates
       *[other] { $names }, which are not the coordinates of one point
    }
    .expected = x and y, and z in space; radius, azimuth and z; or azimuth, zenith or elevation, and distance

# Means: The format names angles and no unit.
# Matters: 1 rad is 57.3 deg or 63.7 gon; the unit is never guessed.
# Do: Set `angle_unit` in the format.
# Example: `columns = ["azimuth", "zenith", "distance"]` without `angle_unit`
angle-unit-missing = `{ $key }` names angles without a unit
    .hint = set `angle_unit` (option `--angle-unit`): "deg", "rad" or "gon"

# Means: `coordinates` confirms another coordinate type than the columns have.
# Matters: One of the two statements is wrong.
# Do: Correct `coordinates` or `columns`.
# Example: `coordinates = "spherical"` with columns x, y, z
coordinate-type-differs = `coordinates` gives { $stated ->
        [cartesian] Cartesian
        [cylindrical] cylindrical
       *[spherical] spherical
    }, `{ $key }` names { $named ->
        [cartesian] Cartesian
        [cylindrical] cylindrical
       *[spherical] spherical
    } coordinates
    .hint = correct one of them

# Means: A column is given by its heading, and the format gives no header row.
# Matters: The column cannot be found.
# Do: Set `header = 1`, or give the number of the column.
# Example: `columns = { x = "X" }` without `header`
header-not-stated = `columns` names the heading `{ $column }`, and no header row is given
    .hint = set `header = 1`, or give the number of the column

# Means: The last row of the header has a number in each column of coordinates.
# Matters: The first measured point would be lost, and the number of every later row would be wrong.
# Do: Give one row less: empty lines and comments are not rows.
# Example: `header = 1` for a file whose first line is a point
header-is-data = row { $rows } of the header has numbers in the columns of coordinates
    .hint = empty lines and comments are not rows: set `header = { $fewer }`

# Means: The expression of a computed column is incomplete or has an unknown sign.
# Matters: The values of the column cannot be computed.
# Do: Write headings, numbers of columns and numbers with + - * / and brackets between them.
# Example: `x_mm = "x_t -"`
expression-malformed = cannot read the expression `{ $expression }`: { $fault ->
        [too-long] it is longer than 1000 characters
        [left-over] `{ $rest }` at the end is superfluous
        [brackets-too-deep] its brackets are nested too deeply
        [too-many-signs] it has too many operators
        [bracket-open] a bracket is not closed
        [column-number] `$` is not followed by the number of a column, from 1
       *[incomplete] a column or a number is missing
    }
    .expected = headings, `$3` for the third column, and numbers, with + - * / and brackets between them

# Means: The file has no column of this name.
# Matters: The values of the column are needed.
# Do: Write the name as in the header of the file.
# Example: `columns = { rho3_mm = "RP33" }` for a header with RP1, RP2 and RP3
column-unknown = column `{ $column }` is missing

# Means: A table could not be built or written.
# Matters: The command cannot continue.
# Do: Report the error as a defect of etalon.
# Example: two columns of different lengths
table-failed = cannot build the table: { $reason }

# Means: A column of whole numbers holds another value.
# Matters: Rows are matched by these whole numbers.
# Do: Correct the cell, or read another column.
# Example: `1.5` in the column `cycle`
not-whole-number = `{ $value }` in the column `{ $column }` is not a whole number

# Means: A table in the output folder was changed or damaged after the run.
# Matters: Results computed from it would be wrong.
# Do: Run the campaign again.
# Example: `observations.parquet` of another run, copied into the output folder
stored-table-damaged = the stored table is damaged: { $reason }
    .hint = run the campaign again: `etalon run CAMPAIGN`

stored-row-count = it has { $found ->
        [one] 1 row
       *[other] { $found } rows
    } instead of { $rows }

# Means: A row of the file holds no measured point.
# Matters: This command needs a point in each row.
# Do: Remove the row from the file.
# Example: a row with empty coordinates in a table of balls
row-without-point = the row holds no point: { $reason }
    .hint = remove the row from the file

# Means: Rows of the file hold no measured point and are not used.
# Matters: The result rests on the other rows.
# Do: Check the first of these rows.
# Example: a QIF file with a feature that was not measured
rows-left-out = { $count ->
        [one] 1 row
       *[other] { $count } rows
    } left out; the first: { $reason }

# Means: A joint is read from an upload of Galil arrays, and the value of an encoder count is
# unknown.
# Matters: The arrays hold encoder counts, not mm or deg.
# Do: Set `per_count` in the unit of the key.
# Example: `columns = { q1_mm = "one" }` for `format = "galil"`
count-value-missing = `{ $key }` does not give the value of one count: Galil arrays hold encoder counts
    .expected = `{ $key } = {"{"} name = "...", per_count = 0.001 {"}"}`, per_count in the unit of the key

# Means: An array of a Galil controller has an empty cell before its end.
# Matters: A short array ends early, but has no empty cells in between: the upload is damaged.
# Do: Upload the array again.
# Example: an empty cell in row 3 of 10
galil-array-hole = the array of `{ $column }` has an empty cell before its end
    .hint = upload the array again

galil-array-ended = no count: the array of { $columns } has ended

# Means: An array of a Galil controller holds no value.
# Matters: Its joint has no values.
# Do: Upload the arrays after the recording has ended.
# Example: a heading without any count below it
galil-array-empty = one of the arrays is empty
    .hint = upload the arrays again after the recording has ended

# Means: A value of an array is not a 32-bit integer.
# Matters: A Galil controller records encoder counts; this file was scaled, or another program wrote
# it.
# Do: Read a scaled file as delimited text: omit `format = "galil"`.
# Example: `3.5` in an array
not-a-count = { $value } is not an encoder count
    .expected = a 32-bit integer
    .hint = if the values are scaled, omit `format = "galil"`

# Means: A counter jumped by more than half of its range.
# Matters: The counter wrapped: joint values before and after the jump do not belong together.
# Do: Set the encoder to zero before recording.
# Example: a count of 2147483647 followed by -2147483648
counter-wrapped = the counter wrapped: { $to } follows { $from }
    .hint = set the encoder to zero before recording

# Means: The cycle counter IPOC of a KUKA RSI recording skips cycles.
# Matters: Samples are missing: telegrams were lost.
# Do: If the gaps lie in a motion that is evaluated, record again with a faster computer.
# Example: IPOC 12, 16, 24 for a cycle of 4 ms
rsi-cycles-missing = { $count ->
        [one] 1 row
       *[other] { $count } rows
    } where `IPOC` does not advance by { $step_ms } ms
    .hint = telegrams were lost, because the recording computer was too slow; record again if the gaps matter

# Means: The rows of a ROS recording name joints in different orders.
# Matters: Two publishers share the topic, so a column mixes two joints.
# Do: Record each publisher into a file of its own.
# Example: `field.name0` is `shoulder` in one row and `elbow` in another
ros-joints-change = joint { $number } is `{ $found }` in this row and `{ $first }` in the first row
    .hint = two publishers share the topic: record each into its own file

# Means: A key of `columns` is neither a standard column of logs nor a joint with a unit.
# Matters: The unit of the values is unknown.
# Do: Write the joint with its unit.
# Example: `columns = { q1 = "RP1" }`
log-column-unknown = `{ $key }` is not a column of a log
    .expected = `pose`, `cycle`, `time_s`, `label`, or a joint with its unit such as `q1_deg`, `q1_rad`, `rho1_mm`

# Means: Two keys give the same quantity of a log.
# Matters: The two may differ.
# Do: Remove one of them.
# Example: `columns = { q1_deg = "J1", q1_rad = "J2" }`, or a column `time_s` beside `period_s`
log-column-twice = `{ $key }` gives `{ $name }` a second time
    .hint = remove one of them; `pose = "row"` replaces the column of the pose, `period_s` the column of the time

# Means: A key is given for a column or a log to which it does not apply.
# Matters: It would have no effect, so the log is probably of another kind than the campaign gives.
# Do: Remove the key, or correct `format`.
# Example: `values = "raw"` for a log that is not a TwinCAT export
log-key-inapplicable = `{ $key }` does not apply to { $column ->
        [none] this log
       *[other] `{ $column }`
    }
    .hint = { $key ->
        [per_count] `per_count` is the value of one encoder count of a joint: remove it
        [values] `values` belongs to `format = "twincat"`: remove it
        [comment] a file of arrays has no text: remove `{ $key }`
        [decimal] a file of arrays has no text: remove `{ $key }`
        [delimiter] a file of arrays has no text: remove `{ $key }`
        [encoding] a file of arrays has no text: remove `{ $key }`
        [sheet] a file of arrays has no text: remove `{ $key }`
        [header] a TwinCAT export names its channels: remove `header`
       *[other] channels of a TwinCAT export have their own times: remove `{ $key }`
    }

# Means: The unit in the key of a column differs from the unit that the controller writes.
# Matters: Joint values would be wrong by the factor between the units.
# Do: Write the key with the unit of the column.
# Example: `q1_deg = "actual_q_0"` for UR RTDE, which records rad
column-unit-differs = `{ $key }` gives { $stated }, but `{ $column }` is in { $known ->
        [wall-clock] whole seconds of a wall clock; the clock of this log is `IPOC`
       *[other] { $known }
    }

write-column = write `{ $key } = "{ $column }"`

column-in-unit = a column in { $unit }

# Means: No line of the file holds all words that `header` gives.
# Matters: The data begin after this line.
# Do: Copy the words from the header row of the file.
# Example: `header = ["Meas Q"]` for a file with `Meas X`
header-words-missing = no line holds the words of the header: { $words }
    .hint = copy the words from the header row of the file

# Means: The file has no row of values after its header.
# Matters: There is nothing to compute from.
# Do: Record or export the file again.
# Example: a file with a row of names alone
data-rows-missing = the file has no data rows
    .hint = export it again; if its only row holds values, set `header = false`

# Means: The number of fields in a row differs from the other rows, the columns or the format.
# Matters: Its values would be read from the wrong columns.
# Do: Correct the row: a delimiter is missing or superfluous. A decimal comma in a file separated by
# commas adds fields. A file that was cut off lacks fields.
# Example: `1;2;3` below the header `a;b`
row-field-count = the row has { $fields ->
        [one] 1 field
       *[other] { $fields } fields
    }
    .expected = { $expected }
    .hint = check delimiter, decimal mark and quotes: a decimal comma adds fields; a file that was cut off lacks fields

fields-like = { $like ->
        [header] { $width }, as the header
        [first-row] { $width }, as the first row
       *[names] at most { $width }, as the row of names
    }

# Means: The stated delimiter does not occur in the rows.
# Matters: Each row is a single field.
# Do: Give the delimiter and the decimal mark of the file.
# Example: a file separated by semicolons, read with the default delimiter `,`
delimiter-does-not-split = the rows have one column when separated by `{ $delimiter }`

state-delimiter = set `delimiter = "{ $delimiter }"` and `decimal = "{ $decimal }"` (options --delimiter and --decimal)

state-delimiter-of-rows = set `delimiter` and `decimal` of the rows

# Means: The row that should name the columns holds numbers.
# Matters: The file has no header: its first row of values would be lost.
# Do: Set `header = false`, and give columns by number.
# Example: a log whose first line is `1,0.5,0.7`
header-holds-numbers = the header row contains numbers instead of names
    .hint = if the file has no header, set `header = false` and give columns by number

# Means: A column is given by its number, and its number changes between files of this format.
# Matters: Another joint would be read without a message.
# Do: Give the name of the column.
# Example: `q1_mm = { number = 1, per_count = 0.001 }` for `format = "galil"`
column-by-number = a column of this format cannot be given by its number: { $format ->
        [galil] arrays are in alphabetical order, not in the order of joints
        [ros] the order of joints is arbitrary
       *[twincat] the order of channels differs between exports
    }
    .hint = give its name

# Means: A column is given by a number that is larger than the number of columns.
# Matters: The column does not exist.
# Do: Count the columns from 1.
# Example: `q5_deg = 9` for a file with five columns
column-number-unknown = column { $number } does not exist
    .expected = a number from 1 to { $columns }

# Means: The header names a column several times, and the campaign does not give which one is meant,
# or gives a number that does not exist.
# Matters: The columns hold different values.
# Do: Set `occurrence`, counted from 1.
# Example: `target_current_0` in a UR RTDE recording, which has it twice
heading-repeated = the header has { $times ->
        [one] 1 column
       *[other] { $times } columns
    } `{ $column }`
    .expected = an `occurrence` from 1 to { $times }
    .hint = give its number: `{"{"} name = "{ $column }", occurrence = 1 {"}"}`

log-row-needs-values = read the log from the controller again, or remove the row: every row needs its values

# Means: The assembly mode of a row is neither 1 nor -1.
# Matters: The mode selects one of the solutions of the direct kinematics.
# Do: Correct the cell. If the mode is unknown, omit the column: the nearer solution is then used.
# Example: 0 in the column `assembly`
assembly-mode-invalid = the assembly mode is { $value }
    .expected = 1 or -1
    .hint = correct it; if the mode is unknown, omit the column `assembly`

# Means: The log has no time span in which all joints stay within the stated limits for long enough.
# Matters: Without standstills no joint values can be assigned to measured points.
# Do: Compare the limits with the noise of the encoders, and the time with the dwell of the program.
# Example: `at_least_s = 5` for a program that waits 2 s
standstill-missing = the robot of log `{ $log }` is never at a standstill for { $at_least_s } s
    .hint = its longest standstill within the limits lasts { FIXED($longest_s, 3) } s: check `at_least_s` and the limits

# Means: The search for standstills needs times, and the log has none.
# Matters: The duration of a standstill is unknown.
# Do: Give the column of the time, or the period of the log.
# Example: [log.standstill] without `time_s` in `columns`
standstill-time-missing = [log.standstill] needs the times of the rows
    .hint = set `time_s`, `time_ms` or `time_ns` in `columns`, or `period_s`

# Means: [log.standstill] has no limit for a kind of joint in the log.
# Matters: The limit defines when this joint stands still.
# Do: Give the largest difference that the encoder shows at a standstill.
# Example: a log with `q1_deg`, and [log.standstill] without `within_deg`
standstill-limit-missing = [log.standstill] has no limit for `{ $column }`
    .hint = set `{ $key }`: the largest difference of two values at a standstill

# Means: The pose, cycle, label or assembly mode changes while the robot stands still.
# Matters: It is unknown which of the values belongs to the joint values.
# Do: Leave the column out, or lower the limits if the robot moved.
# Example: pose 3 and pose 4 within one standstill
changes-at-standstill = `{ $column }` changes from { $from } to { $to } within a standstill
    .hint = leave the column out, or lower the limits of [log.standstill]

# Means: Two keys of `columns` have the same column in a log to simulate.
# Matters: A column holds one quantity.
# Do: Give each key its own column.
# Example: `columns = { q1_deg = 1, q2_deg = 1 }`
simulated-column-clash = the column of `{ $key }` cannot be simulated
    .expected = one column for each key, at most { $most } columns

# Means: `columns` names a quantity that the simulation does not produce.
# Matters: The log cannot be written.
# Do: Leave the key out of the campaign to simulate.
# Example: `columns = { q7_deg = "J7" }` for a robot with six joints
simulated-column-unknown = `{ $key }` cannot be simulated
    .expected = `pose`, `cycle`, `time_s` and the joints with their units

# Means: `columns` names no channel of a TwinCAT export.
# Matters: Nothing would be read.
# Do: Name the channels of the joints.
# Example: `format = "twincat"` with `columns = {}`
log-columns-missing = `columns` of this log names no channel

# Means: A channel and its unit both have a scale factor or offset, and the values are raw.
# Matters: The order in which they apply is not documented.
# Do: Export scaled values.
# Example: `ScaleFactor` 0.001 and `Unit ScaleFactor` 1000 with `values = "raw"`
twincat-two-scales = channel `{ $channel }` has a scale, and so has its unit
    .hint = export scaled values and set `values = "scaled"`

# Means: A channel has a scale factor or offset, and the file does not give whether it is applied.
# Matters: Joint values would be wrong by this factor.
# Do: Set `values` according to the option of the export.
# Example: `ScaleFactor` 0.001 in the head of the export, and no `values` in [log]
twincat-scale-undecided = channel `{ $channel }` has a scale (factor and offset { $scale }; its unit { $unit_scale }): it is unknown whether the values are scaled
    .hint = set `values = "raw"` or `values = "scaled"`, according to the option of the export

# Means: A channel has values again after empty cells.
# Matters: Each channel of a TwinCAT export ends once: the file was edited or damaged.
# Do: Export the recording again.
# Example: an empty cell in the middle of a channel
channel-resumes = channel `{ $channel }` continues after its end
    .hint = export the recording again

# Means: The selected channels have no time in common.
# Matters: A row of the log needs the values of all joints at one time; nothing is interpolated.
# Do: Export channels of one task with one sample time.
# Example: channels sampled at 0, 2, 4 ms and at 1, 3, 5 ms
channels-without-common-time = these channels have no time in common
    .hint = export channels of one task with one sample time

# Means: A channel has samples at times at which another selected channel has none.
# Matters: These samples are left out; nothing is interpolated.
# Do: Nothing, if the remaining samples are dense enough; otherwise export channels of one sample
# time.
# Example: a channel of 1 ms beside a channel of 2 ms
channel-samples-unused = channel `{ $channel }`: { $count ->
        [one] 1 sample
       *[other] { $count } samples
    } left out, because another channel has none at these times

# Means: The first lines are not the head of a TwinCAT 3 Scope export.
# Matters: The head names the channels and their units.
# Do: Export the recording as CSV, or give another `format`.
# Example: a CSV file of another program with `format = "twincat"`
twincat-head-malformed = this is not a TwinCAT 3 Scope export: { $part ->
        [first-line] its first line does not begin with `Name` and a separator
        [names] no row of its head names the channels
       *[end] no empty line ends its head
    }
    .hint = export the recording as CSV again, or give another `format`

# Means: A row of the head and the row of names have different numbers of fields.
# Matters: The separator also occurs as the decimal mark, or in a name.
# Do: Export again, separated by tabs or semicolons.
# Example: an export separated by commas on a computer with decimal comma
twincat-head-ragged = row `{ $row }` of the head has { $fields } fields, the row of names { $width }: the separator also occurs in values or names
    .hint = export again, separated by tabs or semicolons

# Means: The fields of a TwinCAT export are separated by blanks.
# Matters: Blanks also stand for missing values and occur in names.
# Do: Export again, separated by tabs or semicolons.
# Example: a first line `Name scope`
twincat-separated-by-blanks = the export is separated by blanks, which also stand for missing values and occur in names
    .hint = export again, separated by tabs or semicolons

# Means: A scale factor or offset in the head of a TwinCAT export is not a number.
# Matters: The values of the channel cannot be scaled.
# Do: Export the recording again.
# Example: `ScaleFactor` with the value `x`
channel-scale-not-number = `{ $key }` of channel `{ $channel }` is `{ $value }`, not a number
    .hint = export the recording again

# Means: The delimiter of the campaign differs from that of the export.
# Matters: Rows would not be split.
# Do: Remove `delimiter` from this log.
# Example: `delimiter = ";"` for an export separated by tabs
delimiter-differs = the export is separated by { $separator }
    .hint = remove `delimiter` from this log: the export gives it

# Means: Two tables have different coordinates: one has z or an angle that the other lacks.
# Matters: An error is the difference of two positions in the same coordinates.
# Do: Give both tables the same coordinates; planar robots omit z in both.
# Example: attained poses with x, y, z and commanded poses with x, y
coordinates-differ = attained and commanded positions have different coordinates
    .expected = the coordinates of `{ $file }`
    .hint = planar robots omit `z_mm` in both tables

# Means: A coordinate or an angle of a row is empty, infinite or not a number.
# Matters: The pose of the row is incomplete.
# Do: Complete the cell, or remove the row.
# Example: an empty cell in the column `x_mm`
coordinate-missing = a coordinate is missing or non-finite
    .hint = complete the cell, or remove the row

# Means: The table has columns that this command does not know.
# Matters: They have no influence; a misspelled name would also be ignored.
# Do: Check the names.
# Example: a column `aproach`
columns-not-read = not read: { $count ->
        [one] column
       *[other] columns
    } { $columns }

# Means: robot.toml gives backlash of a joint, and the table lacks its direction of approach.
# Matters: The sign of the backlash depends on this direction.
# Do: Add the column. A campaign derives the direction from a log with times.
# Example: `backlash = ["q2"]` and a table without `q2_direction`
joint-direction-missing = `backlash` of joint `{ $joint }` needs the direction of approach of the joint
    .expected = a column `{ $column }`: +1 from below, -1 from above
    .hint = use a log with times, or remove the joint from `backlash` of the robot file

# Means: The direction of approach of a joint is neither +1 nor -1.
# Matters: The sign of the backlash depends on this direction.
# Do: Correct the cell.
# Example: 0 in the column `q2_direction`
joint-direction-invalid = `{ $column }` is { $value ->
        [missing] missing
       *[other] { $value }
    }
    .expected = +1 if `{ $joint }` came from below, -1 from above

# Means: The table has two columns of one joint, in different units.
# Matters: The two may differ.
# Do: Remove one of the columns.
# Example: columns `q1_deg` and `q1_rad`
joint-column-twice = the table has joint `{ $joint }` twice: `{ $first }` and `{ $second }`
    .hint = remove one of the columns

in-row = row { $row }: { $message }

# Means: The table of commanded poses names a pose twice.
# Matters: It is unknown which position was commanded.
# Do: Remove or rename one of the rows.
# Example: two rows with the pose 1
pose-commanded-twice = pose { $pose } is commanded twice
    .hint = remove or rename one of the rows

# Means: A pose was attained that was not commanded.
# Matters: Its accuracy is undefined.
# Do: Add the pose to the table of commanded poses, or correct its name.
# Example: pose 7 attained, poses 1 to 5 commanded
pose-not-commanded = pose { $pose } is not among the commanded poses
    .hint = add it to `{ $file }`, or correct its name

# Means: A pose was attained twice in one cycle.
# Matters: Repeated visits would be counted as one visit, or readings of one visit as several.
# Do: Number the cycles; name approaches in `approach`; number readings of one visit in `reading`.
# Example: two rows with pose 1 and cycle 1
pose-attained-twice = pose { $pose } was attained twice in cycle { $cycle }
    .hint = number the cycles, name approaches in `approach`, or number readings of one visit in `reading`

# Means: A commanded pose has no measurement.
# Matters: The characteristics rest on the other poses.
# Do: Measure the pose, or remove it from the commanded poses.
# Example: poses 1 to 5 commanded, poses 1 to 4 measured
commanded-pose-not-measured = pose { $pose } is commanded but was not measured

# Means: The table holds no measured pose.
# Matters: There is nothing to evaluate.
# Do: Check the names of the poses.
# Example: attained poses that are all missing among the commanded ones
no-pose-measured = no pose was measured
    .hint = check the names of the poses

# Means: A recorded motion has no time stamps.
# Matters: Velocities and passes need the time of each sample.
# Do: Give the sampling rate of the instrument, or record time stamps.
# Example: a recording with x, y, z alone
recording-time-missing = the recording has no time column
    .expected = a column `time_s`, or the sampling rate
    .hint = give the rate of the instrument: `--rate-hz 1000`, in a campaign `rate_hz = 1000`

state-sampling-rate = give the sampling rate (`--rate-hz`): the time stamps are coarser than the sampling

# Means: At the stated sampling rate the samples take another time than their time stamps span.
# Matters: All velocities would be wrong by the ratio of the two times.
# Do: Correct the sampling rate, or leave out the column of time stamps if it is wrong.
# Example: `--rate-hz 1000` for a recording that was sampled at 200 Hz
rate-contradicts-stamps = { $samples } samples at { $rate_hz } Hz take { FIXED($by_rate_s, 2) } s; their time stamps span { FIXED($stamped_s, 2) } s
    .hint = correct the sampling rate, or give the columns without the time stamps

# Means: The velocity of more than 1 % of the samples exceeds 20 m/s.
# Matters: No industrial robot moves so fast: the sampling rate, the unit or the order is wrong.
# Do: Check the sampling rate, the unit, and the order of the samples.
# Example: a recording in m that is given to be in inch
recording-implausible = { $count } of { $samples } samples are faster than 20 m/s: no robot moves so fast
    .hint = check the sampling rate, the unit and the order of the samples

# Means: Reference targets compensate the drift of positions, but not that of angles.
# Matters: Orientation errors contain the rotation of the set-up.
# Do: Give all three angles and the order of their rotations.
# Example: a table with `c_deg` alone for a spatial robot
angles-not-compensated = angles are not compensated for drift by the reference targets
    .expected = all of a_deg, b_deg, c_deg (for a planar robot c_deg) and the order of their rotations
    .hint = give the order: `--rotation-order "Rz(c) Ry(b) Rx(a)"`, in a campaign `rotation_order`

# Means: A cycle was measured before the first measurement of the reference targets.
# Matters: Its drift is unknown.
# Do: Measure the reference targets before the test.
# Example: cycles from 1 and reference targets from cycle 2
cycle-before-reference-targets = cycle { $cycle } was measured before any reference target
    .hint = measure the reference targets before the test; their first measurement is in cycle { $first }

# Means: A reference target has two positions in one cycle.
# Matters: It is unknown which of them is valid.
# Do: Remove one of the rows, or correct the name.
# Example: two rows with target `a` and cycle 1
reference-target-twice = the reference target `{ $target }` was measured twice in cycle { $cycle }
    .hint = remove one of the rows, or correct its name

# Means: The reference targets of a cycle differ from those of the first cycle.
# Matters: Drift is the change of the same targets.
# Do: Measure the same targets each time.
# Example: targets a, b, c in cycle 1, and a, b in cycle 3
reference-targets-differ = the reference targets of cycle { $cycle } differ from the first ones
    .expected = { $targets }

# Means: `columns` names a quantity that a table of observations does not have.
# Matters: The column would be ignored.
# Do: Use a name of docs/observations.md. Coordinates and joints end with their unit.
# Example: `columns = { x = "X" }`
observation-column-unknown = `{ $column }` is not a column of observations
    .hint = coordinates and joints end with their unit: x_mm, q1_deg; docs/observations.md lists all columns

# Means: The same column of the file is given for two quantities.
# Matters: One of the statements is wrong.
# Do: Correct one of them.
# Example: `columns = { q1_deg = "J1", q2_deg = "J1" }`
column-stated-twice = the column `{ $column }` is given for both `{ $first }` and `{ $second }`
    .hint = correct one of them

# Means: Several columns have the same heading.
# Matters: It is unknown which of the columns is meant.
# Do: Rename or remove one of the columns, or give the number of the column.
# Example: a header `pose,rho1_mm,rho1_mm`
heading-twice = the header names `{ $column }` more than once
    .hint = rename or remove one of the columns

# Means: A quantity is given for all rows, and the table also has a column for it.
# Matters: The two may differ.
# Do: Give one of them.
# Example: `target = "ball"` for a table with a column `target`
stated-and-in-table = `{ $key }` is given, and the table has a column of this name
    .hint = remove one of them

# Means: The filters `only` and `without` leave no row.
# Matters: There is nothing to compute from.
# Do: Compare the cells in the filters with the cells of the file.
# Example: `only = { device = "T1" }` for a file with `T-1`
no-row-selected = `only` and `without` select no row
    .hint = compare their cells with the cells of the file

# Means: All rows of the log lack a value of this column: its cells are empty or mean "not measured".
# Matters: No row of the log has all joint values.
# Do: Correct the name or number of the column, or state in `missing` which cells mean "not measured".
# Example: a channel that was selected and not recorded
log-without-values = no row of the log has a value of `{ $column }`
    .hint = correct the column, or state other cells in `missing`

# Means: A constant of `[log]` does not fit its column: a text for a number, a fraction for a cycle, or
# `cycle = "visit"` in a log without the column `pose`.
# Matters: The rows of the log would have no such value.
# Do: Correct the constant.
# Example: `constants = { q7_mm = "zero" }`
log-constant-invalid = the constant { $value } cannot be the column `{ $column }` of a log
    .hint = { $column ->
        [cycle] give a whole number, or "visit" in a log with poses
        [assembly] state 1 or -1
        [pose] give a number or a name
       *[other] give a number
    }

# Means: A computed column has an infinite or undefined value in a row.
# Matters: The value cannot be used.
# Do: Check the expression: it divides by zero or overflows.
# Example: `x_mm = "a / b"` for a row with b = 0
computed-not-finite = the computed value of `{ $column }` is { $value }
    .hint = check the expression: it divides by zero or overflows

# Means: A name begins like a formula of a spreadsheet.
# Matters: The name is written to tables again, and a spreadsheet would execute it.
# Do: Rename it.
# Example: `=1+1` in the column `target`
name-is-formula = a spreadsheet would take the name `{ $name }` in the column `{ $column }` for a formula
    .hint = use a name that does not begin with = + - or @

# Means: The file has no bytes.
# Matters: There is nothing to read.
# Do: Export it again.
# Example: an export that was interrupted
file-empty = the file is empty
    .hint = export it again

# Means: The file is a known kind of document without measured points or joint values.
# Matters: No reading is proposed for it.
# Do: Export the points, or write the numbers as CSV: one row for each point or pose, below a row
# with the names of the columns.
# Example: `etalon formats robot.yaml`
file-without-points = this is { $kind ->
        [json] a JSON document
        [yaml] a YAML document
        [toml] a TOML or INI document
        [certificate] a digital calibration certificate: results of a calibration without measured points
        [roughness] a file of roughness parameters of a Mitutoyo SJ-410 without coordinates
        [diadem] a header of DIAdem: its values are in a file `.r64` beside it
       *[xml] an XML document of an unknown kind
    }
    .expected = measured points or a log, as a table of text or a workbook
    .hint = { $kind ->
        [certificate] name the file of the measured points
        [roughness] name the file of the measured points
        [diadem] convert header and values to CSV, as KUKA.Trace exports them
       *[other] write the numbers as CSV: one row for each point or pose, below a row with the names of the columns
    }

# Means: With every delimiter and decimal mark, the rows of the file have fewer than two numbers.
# Matters: The file holds neither points nor joint values in a form that can be read.
# Do: Export the points as text, one row each.
# Example: `etalon formats letter.txt`
no-rows-of-numbers = { $file ->
        [workbook] no sheet of the workbook has
       *[text] no reading as delimited text gives
    } rows with two or more numbers
    .hint = export the points as text, one row each

robot-does-not-test = the proposal cannot be tested with a robot of the model `{ $model }`: its flange has no free pose in space

robot-not-tested = the proposal cannot be tested with the nominal robot: at least { $fewest } rows with joints are needed, with coordinates that span space

robot-contradicts = the nominal robot does not reproduce { $points } with any order, direction and unit of the joints that was tried{ $known ->
        [yes] ; the smallest residual is { FIXED($rms_mm, 2) } mm (root mean square)
       *[no] {""}
    }

robot-ambiguous = the data do not determine order and direction of { $joints }: another choice leaves { FIXED($rms_mm, 3) } mm (root mean square)

robot-units-ambiguous = the data do not determine the units of the joints: another unit leaves { FIXED($rms_mm, 3) } mm (root mean square)

robot-finds-targets = the nominal robot reproduces the coordinates if each value of { $column } is a target of its own

robot-contradicts-unit = the heading of { $column } gives { $stated }, but the kinematics of the nominal robot fit with { $unit }

robot-contradicts-order = the nominal robot fits with the joints in the order { $columns }, against the numbers in the headings: check headings and robot file

robot-reverses = { $column } counts against the direction of `{ $joint }`: the nominal robot fits with the opposite sign

robot-orders = the nominal robot fits with the joints in the order { $columns }

robot-reproduces = the nominal robot reproduces { $points } in { $unit } with a residual of { FIXED($rms_mm, 4) } mm (root mean square of { $rows } rows, base and target fitted)
robot-orders-quaternion = the orientations of the nominal robot fit the quaternion with the scalar { $scalar ->
        [first] first
       *[last] last
    }

points-commanded = { $points } are commanded or computed, not measured: the nominal robot reproduces them to their rounding (residual { FIXED($rms_mm, 6) } mm)

points-perhaps-commanded = { $points } may be commanded, not measured: the residual of { FIXED($rms_mm, 4) } mm is within the rounding of coordinates and joints

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

files-join = { $matching } of { $keys } rows of `{ $file }` have a row of `{ $log }` by { $by }

files-not-joined = no key joins all exports with the { $rows } rows of `{ $log }`
recording-not-joined = the times do not join `{ $log }`: standstills of 1 s or more are fewer than the points ({ $standstills }), and no clock offset gives each point its own row

doubt-numbers-and-text = column { $column } holds numbers in { $count } of { $rows } rows, and `{ $text }`: leave out such rows (`header`, `comment`)

doubt-array-columns = `{ $array }` has { $count } columns: joints, coordinates, or both beside each other
zero-count-alone = `zero_count` has no effect without `per_count`

# Means: `payload` in robot.toml names joints that bend under a load, and the table lacks a column of the load.
# Matters: The deflection follows from mass and centre of mass; without the column they are unknown.
# Do: Add the column, or give it as a constant of the file.
# Example: `payload = [2, 3]` and a table without `load_kg`
payload-column-missing = `payload` of the robot file needs the column `{ $column }`
    .expected = `load_kg`, and the centre of mass in the flange: `load_x_mm`, `load_y_mm`, `load_z_mm`
    .hint = add the column, 0 in rows without a load, or remove `payload` from the robot file

# Means: A cell of the payload is empty, infinite, or a negative mass.
# Matters: The deflection of the row is unknown.
# Do: Correct the cell; a row without a load has the mass 0.
# Example: -5 in the column `load_kg`
payload-invalid = `{ $column }` is { $value ->
        [missing] missing
       *[other] { $value }
    }
    .expected = a mass in kg of at least 0, or a length in mm
    .hint = state 0 where the robot carries nothing

# Means: `torque` in robot.toml names a joint that bends in proportion to its torque, and the
# table lacks the column of this torque.
# Matters: Without the torque the deflection of the joint is unknown.
# Do: Add the column, or remove the joint from `torque`.
# Example: `torque = [2, 3]` and a table without `tau3_nm`
torque-column-missing = `torque` of the robot file names joint `{ $joint }`, and the column `{ $column }` is missing
    .hint = add the column, or remove the joint from `torque` in the robot file

# Means: A cell of a torque is empty or infinite.
# Matters: The deflection of the joint in this row is unknown.
# Do: Correct the cell, or exclude the row.
# Example: an empty cell in the column `tau2_nm`
torque-invalid = `{ $column }` is { $value ->
        [missing] missing
       *[other] { $value }
    }
    .expected = a torque in N·m
    .hint = correct the cell, or exclude the row

# Means: `drift` or `expansion` in robot.toml follows from the temperature of the robot, and the
# table lacks its column.
# Matters: Without the temperature the change of zeros and lengths is unknown.
# Do: Add the column, or remove the two keys.
# Example: `expansion = true` and a table without `temperature_c`
temperature-column-missing = `drift` or `expansion` of the robot file needs the column `{ $column }`
    .expected = the temperature of the robot in °C
    .hint = add the column, or remove `drift` and `expansion` from the robot file

# Means: A cell of the temperature is empty, infinite, or below absolute zero.
# Matters: The change of zeros and lengths in this row is unknown.
# Do: Correct the cell, or exclude the row.
# Example: -999 in the column `temperature_c`
temperature-invalid = `{ $column }` is { $value ->
        [missing] missing
       *[other] { $value }
    }
    .expected = a temperature in °C, above absolute zero
    .hint = correct the cell, or exclude the row

# Means: In a cycle the reading of a pose is missing that most cycles have. The table has no column
# `approach`: it is unknown whether the robot passed the pose.
# Matters: The next visit counts for AP and RP, but for no approach and not for vAP.
# Do: Nothing, if a reading failed. If the robot took another path, name the approaches in a column
# `approach`.
# Example: cycle 17 has rows of poses 1, 2 and 4, all other cycles of poses 1 to 4
approach-unknown = unknown approach of { $visits }{ $count ->
        [one] {""}
       *[other] {""}; { $count } in all
    }: the reading of the previous pose is missing
    .hint = if the robot passed no other pose in between, name the approaches in a column `approach`

visit-of-cycle = pose { $pose } in cycle { $cycle }

### Messages of stages. Above each message: its explanation (see CONTRIBUTING.md, "A message").

rigid-distance-off = the distance { $first }-{ $second } is { FIXED($off_mm, 3) } mm { $side ->
        [shorter] shorter
       *[longer] longer
    } than its median (tolerance { $limit_mm } mm)

rigid-targets-exchanged = the distances agree if `{ $first }` and `{ $second }` are swapped

# Means: [[rigid]] rejects all rows of a target. Their distances to the other targets differ from
# the median by more than `tolerance_mm`.
# Matters: The target has no position, although the exports contain it.
# Do: Correct the labels if two targets are swapped. Otherwise correct `tolerance_mm`, or remove the
# target from [[rigid]].
# Example: at half of the poses, two reflectors have each other's names
rigid-target-refused = [[rigid]] rejects { $rows ->
        [one] the only row
       *[other] all { $rows } rows
    } of `{ $target }`, the first in `{ $file }`, line { $line }: { $reason }
    .hint = correct swapped labels or `tolerance_mm`, or remove the target from [[rigid]]

rigid-point-coincides = { $message }; the point has the position of `{ $other }`

# Means: A distance between targets of a rigid part differs from its median by more than
# `tolerance_mm` of [[rigid]].
# Matters: The row is excluded and listed in import.json. The target was confused with another,
# moved, or was measured badly.
# Do: Look at the row. Correct its label, or accept the exclusion.
# Example: a reflector measured under the name of its neighbour
rigid-row-refused = row { $row }: `{ $target }` is rejected: { $reason }

# Means: `targets` of [[rigid]] contains a single target, or one target twice.
# Matters: The rule compares distances between targets.
# Do: List at least two targets, each once.
# Example: `targets = ["SMR_1"]`
rigid-targets = a rigid part needs at least two different targets
    .hint = list each target of the part once in `targets`

# Means: A [[rigid]] contains targets of several branches of the robot.
# Matters: Joints move these targets relative to each other, so their distances are not constant.
# Do: Write a separate [[rigid]] for the targets of each branch.
# Example: `targets = ["L1", "R1"]` of a left and a right hand
rigid-across-branches = the rigid part { $targets } spans several branches of the robot
    .hint = write a separate [[rigid]] for the targets of each branch

# Means: `tolerance_mm` of [[rigid]] or `drift_mm` of [[fixed]] is zero, negative or not finite.
# Matters: With this limit, either all rows or no rows would be rejected.
# Do: Give the largest permitted deviation of a distance, or the largest permitted motion of a
# target.
# Example: `tolerance_mm = 0`
limit-not-positive = `{ $key }` must be a positive number
    .expected = { $key ->
            [drift_mm] the largest motion of a fixed target during the campaign, for example 0.02
           *[tolerance_mm] the largest deviation of a distance from its median, a multiple of the scatter, for example 0.1
        }

# Means: [[rigid]] contains an uncertainty or coverage factor of `places_mm`, but no `places_mm`.
# Matters: The key has no effect.
# Do: Set `places_mm`, or remove the key.
# Example: `coverage_factor = 2` in a [[rigid]] without `places_mm`
rigid-uncertainty-without-places = `{ $key }` belongs to `places_mm`, which is missing
    .hint = set `places_mm`, or remove `{ $key }`

# Means: `places_mm` of [[rigid]] contains a target that is missing in `targets` of the same part.
# Matters: This position has no effect.
# Do: Correct the name, or add the target to `targets`.
# Example: `places_mm = { SMR_9 = [0, 0, 0] }` with targets SMR_1 to SMR_3
rigid-place-unknown = `places_mm` contains `{ $target }`, which is not a target of this rigid part

# Means: `places_mm` of [[rigid]] contains the positions of only some targets of the part.
# Matters: The shape of the part can be used only as a whole.
# Do: Add the position of the missing target.
# Example: `places_mm` of two of three targets
rigid-place-missing = the position of `{ $target }` is missing in `places_mm`
    .hint = add its coordinates, or remove it from `targets`

# Means: `places_mm` of [[rigid]] is given without its uncertainty.
# Matters: The positions are used like a measurement, and their uncertainty gives their weight.
# Do: Add `expanded_uncertainty_um` and `coverage_factor` of these positions.
# Example: `places_mm` alone
rigid-places-need-uncertainty = `places_mm` needs `{ $key }`, a positive number
    .expected = the expanded uncertainty of one coordinate, and its coverage factor

# Means: A row of a target in [[rigid]] has neither a pose nor a time.
# Matters: It is unknown which rows of the other targets were measured at the same pose.
# Do: Add the pose to `label` or `columns`, or remove the target from [[rigid]].
# Example: the label `SMR_1` read as `{target}`
rigid-row-without-pose = [[rigid]] contains `{ $target }`, but this row has neither a pose nor a time
    .hint = add the pose to `label` or `columns`, or remove the target from [[rigid]]

# Means: Two rows of a target in [[rigid]] have the same time, and no pose.
# Matters: It is unknown which of the two belongs to the rows of the other targets.
# Do: Add the pose to `label` or `columns`.
# Example: a target measured twice with the same time stamp
rigid-time-twice = [[rigid]] contains `{ $target }`, but two of its rows have the same time
    .hint = the first is line { $first }; add the pose to `label` or `columns`

# Means: No two targets of [[rigid]] have rows with the same pose and cycle, or with the same time.
# Matters: There is no distance to compare.
# Do: Add the pose to `label` or `columns`. For files with one target each, `pose = "row"` numbers
# the rows.
# Example: targets of one part in two files without poses
rigid-never-together = the targets { $targets } of [[rigid]] are never measured together
    .expected = rows with the same pose and cycle, or with the same time
    .hint = add the pose to `label` or `columns`; for files with one target each, `pose = "row"` numbers the rows

# Means: Two targets of [[rigid]] were measured together too rarely to compute the median of their
# distance.
# Matters: This distance rejects no row, so mistakes at these targets are not detected.
# Do: Measure both targets at more poses, or remove one of them from [[rigid]].
# Example: two poses
rigid-few-distances = the distance `{ $first }`-`{ $second }` of [[rigid]] cannot reject a row: it was measured only { $count ->
        [one] once
       *[other] { $count } times
    }
    .expected = at least { $least } times

# Means: [[identify.exclude]] contains neither poses nor rows, or both.
# Matters: It is undefined which readings are excluded.
# Do: Use `poses`, optionally with `cycle` and `target`. Or use `file` and `rows`.
# Example: `rows = "3"` without `file`
exclusion-mixed = an exclusion needs either poses, or the rows of a file
    .expected = `poses`, optionally with `cycle` and `target`; or `file` and `rows`

# Means: `file` of [[identify.exclude]] is not an export of the campaign, or is an export without
# rows.
# Matters: The exclusion has no effect.
# Do: Copy the name of the file from the [[export]].
# Example: `file = "pose.txt"` for the export `poses.txt`
exclusion-file-unknown = `{ $file }` is not an export with rows to exclude

of-name = `{ $name }`: { $message }

# Means: The coordinates of a row belong to another point. This is a point of the same pose, or the
# row is far from the other rows with its name.
# Matters: The row is used as it is. A wrong label makes every result wrong that uses this point.
# Do: Correct the label, or exclude the row. A [[rigid]] rejects rows whose distances to the other
# targets are wrong.
# Example: the reflector `base_3`, measured while the instrument pointed at `SMR_3`
point-lies-at-another = row { $row }: `{ $point }` has the position of `{ $other }`{ $rows ->
        [one] {""}
       *[other] {""}; { $rows } such rows in total
    }
    .hint = if the instrument pointed at the other target, or the label is wrong, correct the label or exclude the row

# Means: A target of [[fixed]] has too few rows to compare parts of the recording.
# Matters: If the target or the instrument moved, the program does not notice it.
# Do: Measure this target more often during the campaign.
# Example: a fixed target measured before and after only
drift-few-readings = `{ $target }` is measured { $count ->
        [one] once
       *[other] { $count } times
    }: too few to detect a drift
    .expected = at least { $least } times

# Means: A fixed target has moved: the medians of two parts of its rows differ by more than
# `drift_mm` of [[fixed]].
# Matters: The target or the instrument moved, so points of different times are not in one frame.
# Do: Check the temperature and the mounting of the instrument. If [frame.world] has `targets` and
# `each = "pose"`, the frame follows the targets.
# Example: an instrument that warms up
reference-drifts = `{ $target }` drifts: it moves { LENGTH($moved_mm) } from rows { $first } to rows { $second }; limit { LENGTH($limit_mm) }
    .hint = check temperature and mounting of the instrument; if [frame.world] has `targets` and `each = "pose"`, the frame follows the targets

# Means: The exports contain points relative to different working frames.
# Matters: Points in different frames cannot be combined.
# Do: Export all points in one working frame, or use only the exports of one frame.
# Example: one QIF file relative to `Base`, another relative to `Part`
frames-differ = the points are relative to the frame `{ $second }`; the points of another export are relative to `{ $first }`
    .hint = export them in one working frame, or use only the exports of one frame

# Means: An export contains no points.
# Matters: The file, or the description of its format, is probably wrong.
# Do: Check the format with `etalon formats FILE`, or export the points again.
# Example: a file that contains only a header
export-empty = `{ $file }` contains no points
    .hint = export the points again, or remove this [[export]]; `etalon formats FILE` shows how to read a text

# Means: The name of a target would run as a formula in a spreadsheet.
# Matters: Tables of results contain this name.
# Do: Rename the target, or write a `label` without its first character.
# Example: `=ball`
target-formula = a spreadsheet would read the name `{ $target }` as a formula
    .hint = rename it, or write a `label` without its first character

# Means: A row contains a target of the robot, but no pose.
# Matters: A target on the robot needs the joint values of its pose.
# Do: Add the pose to the label, or set `pose = "row"` for this export.
# Example: the label `SMR_1` read as `{target}`
target-without-pose = the row contains a target but no pose
    .hint = add the pose to the label, or set `pose = "row"` for this export

# Means: Two rows have the same target, pose and cycle.
# Matters: It is unknown which of the two rows is right.
# Do: Give each repeat a different cycle number, or remove one row. If the rows of two files are
# poses, number them differently.
# Example: two files with `pose = "row"`
target-twice = target `{ $target }` occurs twice at pose { $pose }, cycle { $cycle }
    .hint = the first is { $file }:{ $line }; { $numbered ->
            [by-row] set `pose = "row + 100"` for one of the files
           *[by-label] give each repeat a different cycle number, or remove one
        }

# Means: Some labels belong to no target of the robot, and no feature, frame or step uses them.
# Matters: These points have no effect. A label with a spelling mistake loses its point in this way.
# Do: Correct the spelling of the label, or `label` of this export. Points that do not move with the
# robot need no change: `targets` of `[frame.world]` defines the world by them.
# Example: `SMR1_3` with `label = "{target}_{pose}"` and a target `SMR_1`
labels-unused = { $count ->
        [one] 1 label belongs
       *[other] { $count } labels belong
    } to no target and { $count ->
        [one] is
       *[other] are
    } not used by a feature or frame; the first is `{ $label }`
    .hint = { $points ->
            [stationary] points that do not move with the robot need no change; `targets` of [frame.world] makes them a world
           *[moving] correct the label, or the pattern `label` of this export
        }

column-step = { $column } to { $step } { $unit }

# Means: All values of a coordinate are multiples of a step, whose rounding error is larger than the
# uncertainty of the instrument. The standard uncertainty of rounding is step/√12 (JCGM 100:2008,
# 4.3.7).
# Matters: The results are less accurate than the uncertainty of the instrument suggests.
# Do: Change the export to more decimals.
# Example: coordinates with one decimal from a tracker with 15 µm
coordinates-rounded = coordinates of `{ $file }` are rounded ({ $columns }): standard uncertainty of the rounding { FIXED($rounding_um, 1) } µm, of the instrument { FIXED($instrument_um, 1) } µm
    .hint = export them with more decimals

# Means: One row of an export is exactly 0 0 0. Trackers write such a row for a lost target. But if
# the origin of the frame is a measured point, its row is also 0 0 0.
# Matters: The row is excluded and listed in import.json.
# Do: If the point was really measured, set `missing = [""]` in `format`.
# Example: coordinates relative to the first point: `1 0 0 0`, `2 12.503 -3.118 0.044`
origin-not-measured = line { $line } of `{ $file }` is 0 0 0: the row counts as not measured
    .hint = if it is a measured point at the origin of the frame, set `missing = [""]` in `format`

# Means: No label has the form that a step of a procedure needs.
# Matters: The step cannot be evaluated.
# Do: Compare the pattern with the labels of the exports; correct the pattern, or add the export.
# Example: `label = "visit_{pose}_{cycle}"`, but the labels begin with `pose`
labels-missing = no point has a label of the form `{ $pattern }`
    .hint = correct the pattern, or add the export

# Means: An exclusion on the command line gives no reason.
# Matters: A reader of the report must be able to judge why measurements are excluded.
# Do: Add the reason after a colon: `--exclude "13: ball loose"`.
# Example: `--exclude 13`
exclusion-option-without-reason = { $option } { $text } contains no reason
    .expected = excluded poses or rows, and the reason: "13, 20-22: ball loose"

exclusion-poses = { $count ->
        [one] pose
       *[other] poses
    } { $poses }

exclusion-cycle = cycle { $cycle }

exclusion-target = target `{ $target }`

# Means: Readings were excluded because `exclude` contains them.
# Matters: Excluded readings have no influence on the result; the report lists them with the reason.
# Do: Check that the reason justifies the exclusion.
# Example: `exclude = [{ poses = "13", reason = "ball loose" }]`
excluded-readings = excluded: { $count ->
        [one] 1 reading
       *[other] { $count } readings
    }, { $of }: { $reason }

# Means: All readings are excluded.
# Matters: Parameters cannot be identified without readings.
# Do: Remove an exclusion, or reduce its range of poses.
# Example: `poses = "1-1000"` of 100 poses
exclusions-leave-nothing = all readings are excluded
    .hint = remove an exclusion

# Means: The text of an exclusion is not a list of poses or rows.
# Matters: The exclusion has no effect.
# Do: Write names, numbers and ranges.
# Example: `poses = "rest"`
exclusion-names-nothing = `{ $stated }` selects no { $of ->
        [rows] rows
       *[poses] poses
    } to exclude
    .expected = { $of ->
            [rows] numbers and ranges like "13, 20-22", counted from the first row of data
           *[poses] names and ranges like "13, 20-22, home"
        }

# Means: A row or a key refers to a joint or target that the robot does not have.
# Matters: It is unknown which joint or target was meant.
# Do: Correct the name; the message proposes similar names.
# Example: `SMR_4` of a robot with the targets SMR_1 to SMR_3
not-of-this-robot = `{ $name }` is not a { $kind ->
        [joint] joint
       *[target] target
    } of this robot

# Means: `reason` of an exclusion is empty.
# Matters: A reader of the report must be able to judge why measurements are excluded.
# Do: Enter the reason for the exclusion, for example `reason = "ball loose"`.
# Example: `reason = ""`
exclusion-without-reason = an exclusion needs a reason
    .hint = write into `reason` why the measurements are excluded

# Means: An exclusion refers to a pose or row that was not measured.
# Matters: The exclusion has no effect, so the wrong readings are still used.
# Do: Correct the pose, cycle, target or row in the exclusion.
# Example: `poses = "130"` of 100 poses
exclusion-matches-nothing = { $of ->
        [rows] there is no row { $name } to exclude
       *[poses] there is no reading at pose { $name } with this cycle and target to exclude
    }
    .hint = correct the exclusion, or remove it

# Means: For every measured point, the nearest row of the log is more than `tolerance_s` away.
# Matters: No observations remain. Usually the clock offset is wrong.
# Do: Check value and sign of `clock_offset_s`: time of the measurement minus time of the log.
# Example: `clock_offset_s = 3600`, but the log is one hour ahead
join-by-time-empty = no measured point matches a row of log `{ $log }`: the two nearest times are { FIXED($apart_s, 3) } s apart
    .hint = check value and sign of `clock_offset_s`: time of the measurement minus time of the log

both-rows-near = a point between two rows needs both within `tolerance_s`: set it at least to the time between two rows

# Means: No measured point and no row of the log have the same pose, cycle or row number.
# Matters: No observations remain.
# Do: Compare the names of the poses in exports and log, or choose another kind of join with `by`.
# Example: poses 1 to 50 in the export, 0 to 49 in the log
join-empty = no measured point matches a row of log `{ $log }`: the first pose of the points is `{ $measured }`, of the log `{ $logged }`
    .hint = compare poses and cycles of exports and log, or choose another key with `by` in [join]

# Means: The offset of the clocks was computed from the standstills of the log: with this offset,
# every measured point is within a standstill.
# Matters: Each point gets the joint values of its standstill. The number after ± is half of the
# range of possible offsets.
# Do: Nothing, if all points were measured during standstills.
# Example: `clock_offset_s = "standstills"`
clock-from-standstills = the clock of log `{ $log }` is set from { $count ->
        [one] 1 standstill
       *[other] { $count } standstills
    }: offset { FIXED($offset_s, 3) } s ± { FIXED($half_width_s, 3) } s
    .hint = with this offset, every measured point is within a standstill

# Means: The world frame is measured at each pose, but could not be determined at some poses.
# Matters: The points of these poses cannot be expressed in the world frame, so they are excluded.
# Do: Look for rejected frame targets in import.json, or measure these poses again.
# Example: a frame target that was not measured at pose 2
pose-without-frame = { $count ->
        [one] 1 pose
       *[other] { $count } poses
    } without a world frame, excluded: { $poses }
    .hint = the frame targets were rejected or not measured: see import.json

# Means: A measured point and its row of the log have different poses or cycles.
# Matters: Joint values are assigned to the wrong points.
# Do: Join by pose. If the column of the log has another meaning, remove it from `columns`.
# Example: a join by row, although the row of pose 7 is missing in the export
join-contradicts = { $count ->
        [one] 1 measured point has
       *[other] { $count } measured points have
    } a different { $column } in the joined row of log `{ $log }`: { $measured } and { $logged } (line { $line } of the log)
    .hint = join by pose; if `{ $column }` has another meaning in the log, remove it from `columns` of the log

# Means: A join by row needs as many rows in the log as in the export, but the numbers differ.
# Matters: After the first missing row, the joint values belong to other points.
# Do: Complete the file, or add pose and cycle to both files and join by them.
# Example: 100 rows of the export, 99 of the log
row-counts-differ = `{ $file }` has { $rows } rows, but log `{ $log }` has { $log_rows }
    .expected = equal numbers of rows for a join by row
    .hint = complete the file in which rows are missing; or add pose and cycle to both files, and join by them

# Means: The robot has `backlash`, but the log contains neither times nor a column of directions.
# Matters: The error of a joint with backlash depends on the direction of its last motion.
# Do: Add the times of the rows (`time_s` in `columns`, or `period_s`), or a column of directions:
# +1 from below, -1 from above.
# Example: `backlash = [2]` with a log without times
approach-direction-unknown = the direction of approach of joint `{ $joint }` is unknown in log `{ $log }`
    .hint = `backlash` needs it: add the times of the rows (`time_s` in `columns`, or `period_s`), or `{ $column }` in `columns`: +1 from below, -1 from above

# Means: Before the first poses, the log contains no motion of a joint with backlash.
# Matters: The direction of approach is unknown there, so these poses are excluded.
# Do: Start the log before the robot moves to the first pose, or add the column of directions.
# Example: a log whose first row is pose 1
backlash-direction-unknown = log `{ $log }` contains no motion of a joint with backlash before pose { $poses }: excluded
    .hint = start the log before the first pose, or add the column of directions

# Means: The targets of a planar robot have different heights in the world frame, by more than 0.5
# mm.
# Matters: The xy plane of the world is tilted against the plane of motion, so projected lengths are
# too short.
# Do: Check z of the exports (unit, sign, column) and the points that define the plane of the world
# frame.
# Example: two columns of the export are swapped
targets-out-of-plane = the targets of the planar robot have heights from { FIXED($low_mm, 3) } mm to { FIXED($high_mm, 3) } mm in the world frame
    .hint = check z of the exports (unit, sign, column) and the points that define the plane of the world frame

# Means: A column that every row needs is missing, or its cell is empty.
# Matters: The meaning of the row is unknown.
# Do: Add the column, or complete the cell.
# Example: a row of kind `distance` without `other`
column-empty = the column `{ $column }` is empty or missing
    .hint = add the column, or complete the cell

# Means: Some targets were not measured at some poses.
# Matters: The other targets of these poses are used. A pose or an orientation needs all targets.
# Do: If you need the orientation, measure these poses again.
# Example: a hidden reflector at pose 12
targets-missing = targets are missing at { $count ->
        [one] pose { $poses }
       *[other] poses { $poses }
    }
    .hint = the other targets of these poses are used; a pose or an orientation needs all targets

row-is-a-pose = `{ $file }` has `pose = "row"`, so each row is a separate pose: remove this line if several targets were measured at one pose

key-in-lines = { $key } (lines { $lines })

remove-repeated-rows = remove the repeated rows: their joint values are equal digit for digit
remove-invalid-rows = remove the invalid rows

# Means: Several rows of the log have the same pose, or the same pose and cycle.
# Matters: It is unknown which joint values belong to the measured points.
# Do: Join by pose and cycle, or remove the rows that are not valid.
# Example: pose 3 logged twice with `by = "pose"`
log-key-twice = log `{ $log }` has { $count ->
        [one] 1 key
       *[other] { $count } keys
    } more than once: { $keys }
    .hint = add `cycle` to the key, or remove the invalid rows

# Means: Some measured points match no row of the log, or some rows of the log match no measured
# point.
# Matters: They have no influence on the result; import.json lists all of them.
# Do: Nothing, if this is intended. Otherwise compare the poses and cycles in both files.
# Example: a log of 100 poses, but only 90 were measured
keys-unmatched = { $count ->
        [one] 1 key
       *[other] { $count } keys
    } of { $of ->
        [log] log `{ $log }` without a measured point
       *[points] measured points without a row of log `{ $log }`
    } ({ $columns }): { $keys }; see import.json

# Means: A rigid part has so many targets that only some of their distances are compared.
# Matters: Each target has distances that are compared, so a wrong target is still found.
# Do: Nothing. To compare all distances, write parts with at most 64 targets.
# Example: `targets` of [[rigid]] with 300 names
rigid-pairs-sampled = { $compared } of the { $pairs } distances between { $targets } targets of a rigid part are compared

# Means: Many pairs of names have points at one position; the message lists the first pairs.
# Matters: Positions cannot distinguish these names, so some may be swapped.
# Do: Check the labels of the export, and whether these targets really have one position.
# Example: 300 targets with the coordinates of one target
point-pairs-many = { $pairs } pairs of names have points at the same position; the first { $named } are listed
    .hint = check the labels of the export

# Means: A pose is only in the export or only in the log, and other poses of the other file are
# unmatched as well.
# Matters: The name of the pose is probably spelt differently in the two files, so its measurements
# are lost.
# Do: Write the name of the pose in the same way in both files.
# Example: `home` in the log, `hom` in the export
pose-misspelt = pose `{ $pose }` { $of ->
        [log] of log `{ $log }` was not measured, and measured poses are not in the log
       *[points] is not in log `{ $log }`, and poses of the log were not measured
    }

# Means: Rows of an export or of the log have no pose, cycle or row number, which the join needs.
# Matters: These rows cannot be joined.
# Do: Add this key to `label` of the exports and to `columns` of the log, or change `by` in [join].
# Example: `by = "pose_and_cycle"` with labels without a cycle
join-key-missing = the join needs `{ $key }`, which is missing in some rows
    .hint = add it to `label` of the exports and to `columns` of the log, or change `by` in [join]

# Means: A join by label needs a robot with a single target that touches points of a plate.
# Matters: The label of a point does not show which of several targets touched it.
# Do: Keep one target in `targets`, or join by pose.
# Example: `by = "label"` with three targets
join-by-label-targets = a join by label needs a robot with one target; this robot has { $count }
    .hint = keep one target, or choose another key with `by` in [join]

# Means: The plate is measured once, but the world frame is measured again at each pose.
# Matters: In a frame that changes with the pose, the points of the plate have no single position.
# Do: Define the world frame by points that do not move.
# Example: `each = "pose"` in [frame.world] with `by = "label"`
join-by-label-frame = a join by label needs one world frame for all poses
    .hint = define the frame by points that do not move

# Means: A row of the log contains a point that no export contains.
# Matters: The position of the point is unknown.
# Do: Correct the label in the log, or add the export of the point.
# Example: `ball_7` of a plate with balls 1 to 6
label-not-measured = no measured point has the label `{ $label }`

# Means: No row of the log contains these points of the plate.
# Matters: These points have no effect.
# Do: Nothing, if the robot did not touch them. Otherwise correct their labels.
# Example: a plate of 30 balls; the robot touched 20
points-untouched = { $count ->
        [one] 1 point is
       *[other] { $count } points are
    } not touched in log `{ $log }`; the first is `{ $label }`

# Means: The time of a row of the log is not later than the time of the previous row.
# Matters: The program searches the row of a point by time, which needs increasing times.
# Do: Sort the log by time, and remove rows with equal times.
# Example: a log written by two recorders into one file
log-times-not-increasing = times of log `{ $log }` do not increase at its row { $row }
    .hint = sort the log by time, and remove rows with equal times

# Means: The join is by time, but some rows of an export or of the log have no time.
# Matters: These rows cannot be joined.
# Do: Add `time_s` with the column of times to `columns` of the exports and of the log.
# Example: `by = "time"` with an export without a column of times
times-missing = { $of ->
        [log] the log has rows without a time
        [export] the export has rows without a time
       *[points] no measured point has a time
    }
    .hint = a join by time needs `time_s` in the columns of exports and log

# Means: Several rows of the log are within `tolerance_s` of a measured point.
# Matters: The nearest row is used. If the robot moved, this choice influences the result.
# Do: Set `tolerance_s` to less than half of the time between two rows.
# Example: `tolerance_s = 20` with rows 10 s apart
several-rows-near = { $count ->
        [one] 1 measured point has
       *[other] { $count } measured points have
    } several rows of log `{ $log }` within { $tolerance_s } s: the nearest row is used
    .hint = set `tolerance_s` to less than half of the time between two rows

# Means: Some measured points have no row of the log within `tolerance_s`.
# Matters: These points are excluded; import.json lists them.
# Do: If the log should contain these points, check `clock_offset_s` and `tolerance_s`.
# Example: points measured after the log ended
points-without-row = { $count ->
        [one] 1 measured point has
       *[other] { $count } measured points have
    } no row of log `{ $log }` within { $tolerance_s } s

# Means: Some rows of the log are not the nearest row of any measured point.
# Matters: These rows have no influence on the result; import.json lists them.
# Do: Nothing, if no point was measured at these times.
# Example: a row at 99 s, and points up to 20 s
rows-without-point = { $count ->
        [one] 1 row
       *[other] { $count } rows
    } of log `{ $log }` without a measured point

# Means: Several points of one target have the same time.
# Matters: A target has only one position at a time.
# Do: Correct the times, or give each point its own target.
# Example: two reflectors with the same name
target-time-twice = { $count } points of target `{ $target }` have the same time (lines { $lines })
    .hint = correct the times, or give each point its own target

# Means: One row of the log is the nearest row of several points of one target.
# Matters: The target had only one position at that time, so one of the points belongs to another
# row.
# Do: Reduce `tolerance_s`, or check `clock_offset_s`.
# Example: `tolerance_s` longer than the time between two poses
log-row-met-twice = row { $row } of log `{ $log }` is the nearest row of { $count } points of target `{ $target }` (lines { $lines })
    .hint = reduce `tolerance_s`, or check `clock_offset_s`; of several readings in one standstill, give their mean as one point

# Means: With no offset of the clocks, every measured point is within a standstill of the log.
# Matters: The standstills do not determine the offset. A point was measured in motion, or a
# standstill is missing in the log.
# Do: Remove points that were measured in motion. Or set `clock_offset_s` as a number; the message
# then lists points without a row.
# Example: a point taken while the robot moved
clock-offset-none = with no offset of the clocks, every measured point is within a standstill of the log: { $count ->
        [one] the first point (up to { $last_s } s) fits
       *[other] the first { $count } points (up to { $last_s } s) fit with one offset
    }, the point at { $first_s } s does not
    .hint = remove points measured in motion, or set `clock_offset_s` as a number: points without a row are then listed

range-of-seconds = { FIXED($low_s, 3) } to { FIXED($high_s, 3) } s

# Means: With several offsets of the clocks, every measured point is within a standstill.
# Matters: Only one of these offsets is right; with another one, points get the joint values of a
# wrong pose.
# Do: Compare the two clocks once, and set `clock_offset_s` as a number.
# Example: standstills at equal intervals
clock-offsets-several = the standstills allow { $count } ranges of the clock offset, the first: { $ranges }
    .hint = compare the two clocks, and set `clock_offset_s` as a number

axis-of-world = "x", "y" or "z"

# Means: A key that its kind requires is missing in an [[observe]] or [[known]] of a truth.
# Matters: This row cannot be simulated.
# Do: Add the key.
# Example: `kind = "distance"` without `other`
observe-key-missing = kind `{ $kind }` needs `{ $column }`
    .hint = set `{ $column }`

# Means: A distance is missing, zero, negative or not a number.
# Matters: The row contains no observation.
# Do: Correct the distance, or remove the row.
# Example: an empty `distance_mm`
distance-not-positive = `distance_mm` is missing or not a length
    .expected = a length above 0

# Means: A fixed point, socket or station has the name of a target on the robot, or `base`.
# Matters: The program uses the coordinates of the target on the moving part.
# Do: Give the fixed point a name that no target on the robot has.
# Example: `other = "SMR_1"` where SMR_1 is on the robot
fixed-point-on-robot = `{ $name }` is a target on the robot, not a fixed point
    .hint = give fixed points names that no target has; rows with only fixed points have no pose

# Means: A distance is given from a point to the same point.
# Matters: The row contains no observation.
# Do: Correct `target` or `other`.
# Example: `target = "A"`, `other = "A"`
distance-to-itself = the distance is from `{ $name }` to itself
    .hint = correct `other`

# Means: A row contains two targets of the same link.
# Matters: Their distance is the same at every pose, so it gives no information about the robot.
# Do: Use a target of another branch in `other`. The shape of the targets on one link belongs to
# [[rigid]].
# Example: `target = "L1"`, `other = "L2"` on the same hand
target-of-same-branch = `{ $target }` and `{ $name }` are on the same branch
    .hint = use a target of another branch; the shape of the targets on one link belongs to [[rigid]]

# Means: `other` of a bar is not a target of another branch.
# Matters: A bar of `kind = "bar"` connects two branches of the robot.
# Do: Use a target of another branch in `other`. For a bar with a fixed end, use `kind =
# "distance"`.
# Example: `kind = "bar"` with `other = "anchor"`
bar-without-other-hand = `{ $name }` is not a target of another branch than `{ $target }`
    .hint = use a target of another branch; for a bar with a fixed end, use `kind = "distance"`

# Means: A row of `kind = "bar"` contains both a pose and a distance.
# Matters: A bar has one length. In a row with a pose, its uncertainty would count again at each
# pose.
# Do: Give the length in a row without a pose. For lengths that are measured at each pose, use `kind
# = "distance"`.
# Example: `kind = "bar"`, `pose = 3`, `distance_mm = 500`
bar-length-at-pose = a bar has one length at all poses
    .hint = set `distance_mm` in a row without a pose; for lengths that are measured at each pose, use `kind = "distance"`

# Means: A required number of the row is missing or cannot be read.
# Matters: The row contains no observation.
# Do: Complete the row, or remove it.
# Example: a row of kind `joints` without `value_deg`
number-missing = `{ $column }` is missing or not a number
    .expected = { $column ->
            [offset_mm] the distance of the target from the plane along its axis, or from the sphere outwards: the radius of a ball, or 0
           *[value_deg] the value of the joint from the switch or second encoder
        }

# Means: A row has no pose, but its kind needs one.
# Matters: Without a pose the joint values of the row are unknown.
# Do: Add the pose, or use a kind for fixed points and surfaces.
# Example: a row of kind `contact` with an empty `pose`
row-without-pose = a row of kind `{ $kind }` has no pose
    .hint = rows without a pose contain positions (`point`) and distances (`distance`) of fixed points, or points on a `plane`, `line` or `sphere`

# Means: A [[known]] of a truth has a kind that always needs a pose.
# Matters: The row cannot be simulated.
# Do: Use `point`, `distance`, `plane`, `line` or `sphere`, or move it to [[observe]].
# Example: `kind = "contact"` in [[known]]
known-unsupported = [[known]] cannot have the kind `{ $kind }`
    .expected = `point`, `distance`, `plane`, `line` or `sphere`

# Means: A [[known]] has `near_mm`, but is a point or a distance.
# Matters: `near_mm` has an effect only for points on a surface.
# Do: Remove `near_mm`.
# Example: `near_mm` with `kind = "point"`
near-without-surface = `near_mm` is for points on surfaces
    .hint = remove `near_mm`

# Means: Joint values and poses of bodies can be observed on spatial arms only.
# Matters: The model of this robot has no such observation.
# Do: Observe positions or distances.
# Example: a row of kind `joints` for a planar robot
kind-of-arms = { $kind ->
        [joints] joint values
       *[poses] poses
    } are for spatial arms, not for `{ $model }`
    .hint = observe positions or distances of targets

# Means: The column `kind` contains an unknown kind of observation.
# Matters: The meaning of the row is unknown.
# Do: Use one of the kinds in docs/observations.md.
# Example: `kind = "points"`
kind-unknown = `{ $name }` is not a kind of observation

# Means: A name occurs in one or two rows, and differs by only a few characters from a name in many
# rows.
# Matters: With its own name, the item is identified from these few rows alone, which then give no
# information about the robot.
# Do: Correct the name, or exclude the rows.
# Example: `SMR_l` in one row, `SMR_1` in 99 rows
name-on-few-rows = `{ $name }` occurs in { $count ->
        [one] 1 row
       *[other] { $count } rows
    } only, but `{ $meant }` occurs in { $meant_count }
    .hint = did you mean `{ $meant }`? otherwise exclude the rows of `{ $name }`: they do not determine its position

# Means: Joints of the URDF move `base_link`, and an instrument measured positions.
# Matters: The positions are interpreted relative to the moving base, but an instrument usually
# stands in the room.
# Do: If the instrument is fixed in the room, set `base_link` to the root of the URDF.
# Example: `base_link = "link_1"` of an arm on a rail
base-moves = the joints { $joints } move `base_link`: positions are interpreted relative to this moving link
    .hint = if the instrument is fixed in the room, set `base_link` to the root of the URDF

names-of-fixed-things = give targets, points and planes different names

# Means: Some rows contain only one or two coordinates of a target.
# Matters: Each coordinate counts as a separate observation.
# Do: Nothing, if the other coordinates were not measured.
# Example: heights measured with a dial gauge: `z_mm` alone
partial-coordinates = { $count ->
        [one] 1 row contains
       *[other] { $count } rows contain
    } one or two coordinates of a target: each coordinate counts as a separate observation ({ $by ->
        [line] line
       *[pose] pose
    } { $rows }{ $more ->
        [0] {""}
       *[other] {" "}and { $more } more
    })

# Means: In some rows, a joint value or all coordinates of a point are missing.
# Matters: These rows are excluded, like rows of an export or a log that were not measured.
# Do: Nothing, if nothing was measured. Otherwise complete the cells.
# Example: `12,SMR,10.0,20.0,,,` with empty coordinates
rows-not-measured = { $count ->
        [one] 1 row without a joint value or without coordinates is
       *[other] { $count } rows without a joint value or without coordinates are
    } excluded ({ $by ->
        [line] line
       *[pose] pose
    } { $rows }{ $more ->
        [0] {""}
       *[other] {" "}and { $more } more
    })

# Means: A few rows have an empty cell in the column `station`, but many rows contain a station.
# Matters: Rows without a station belong to the station of the world frame, which must observe the
# robot at three poses or more.
# Do: Write the station into the empty cells.
# Example: one row of 100 without its station
station-missing = the column `station` is empty here, but other points have a station
    .hint = add the station: rows without one belong to the station of the world frame, which must observe the robot at { $least } poses or more

# Means: `coordinates` of a truth contains other letters than x, y and z.
# Matters: It is unknown which coordinates are simulated.
# Do: Use one to three of the letters x, y and z.
# Example: `coordinates = "h"`
coordinates-unknown = `{ $text }` is not a list of coordinates
    .expected = letters of x, y and z: "z", "xy"

# Means: A row without a pose gives the position of a fixed point, but a coordinate is missing.
# Matters: The row contains no observation.
# Do: Complete the coordinates, or remove the row.
# Example: an empty `z_mm` of a fixed point
place-missing = the position of `{ $point }` is missing or not a number
    .hint = complete its coordinates, or remove the row

# Means: The value of a joint is missing in a row.
# Matters: The pose of the robot is unknown in this row.
# Do: Complete the joint values, or remove the row.
# Example: an empty `q3_deg`
joint-value-missing = a joint value is missing or not a number
    .hint = complete or remove the row

# Means: A row of a further station is not a point with three coordinates and one uncertainty.
# Matters: The frame of this station is identified together with the robot, which needs such points.
# Do: Measure points with x_mm, y_mm, z_mm and one uncertainty `u_mm` from this station.
# Example: a height alone, measured from a second station
station-row-unsupported = { $fault ->
        [kind] a row of kind `{ $kind }` belongs to station `{ $station }`
        [coordinate] a coordinate measured by station `{ $station }` is missing or not a number
        [covariance] a point measured by station `{ $station }` has a covariance
       *[uncertainties] coordinates measured by station `{ $station }` have separate uncertainties
    }
    .expected = rows of kind `point` with x_mm, y_mm, z_mm and one uncertainty `u_mm`, for stations other than the first

# Means: An `[[export]]` has `station`, but `[join]` has `by = "label"`.
# Matters: Points that the robot touches are measured once, in the world frame.
# Do: Join by pose, row or time, or export all points in one frame.
# Example: sockets on a table, measured by a tracker at a second place
station-join-by-label = points of station `{ $station }` are joined by label
    .hint = join them by pose, row or time: a touched point is measured in the world frame

# Means: The standard uncertainty of a row is negative.
# Matters: The uncertainty gives the weight of the row.
# Do: Correct the value, or empty the cell.
# Example: `u_mm = -1`
uncertainty-not-positive = `{ $column }` = { $value } is not a standard uncertainty
    .expected = a positive number

# Means: Some coordinates of a target are missing in a row. If only these coordinates were measured,
# the row also needs their standard uncertainty.
# Matters: A gap in a table of positions is not a measurement of single coordinates.
# Do: Complete the row, or remove it. If only some coordinates were measured, add their uncertainty.
# Example: `nan` as the x of one row
coordinates-of-rows-missing = { $axes } { $missing ->
        [one] is
       *[other] are
    } missing in { $by ->
        [line] line
       *[pose] pose
    } { $rows }{ $more ->
        [0] {""}
       *[other] {" "}and { $more } more
    }
    .hint = complete the row or remove it; if only the other coordinates were measured, add their standard uncertainty: a column `u_mm`, `expanded_uncertainty_um` in [instrument], or --standard-uncertainty-um of `etalon identify` and `etalon verify`

# Means: A row has no standard uncertainty, and no uncertainty is given for all rows.
# Matters: The uncertainty gives the weight of the row.
# Do: Give one uncertainty for all rows, or add a column.
# Example: a distance in a table without `u_mm`
uncertainty-missing = { $count ->
        [one] a row has
       *[other] { $count } rows have
    } no standard uncertainty of { $column ->
        [urot_deg] rotation
       *[u_mm] length
    }: { $by ->
        [line] line
       *[pose] pose
    } { $rows }{ $more ->
        [0] {""}
       *[other] {" "}and { $more } more
    }
    .hint = { $column ->
            [urot_deg] set `expanded_rotation_uncertainty_deg` in [instrument], or a column `urot_deg`; in `etalon identify` and `etalon verify`, add --rotation-uncertainty-deg
           *[u_mm] set `expanded_uncertainty_um` in [instrument], or a column `u_mm`; in `etalon identify` and `etalon verify`, add --standard-uncertainty-um
        }

# Means: A plane or line is identified, but the column `axis` does not contain the nearest axis of
# the world.
# Matters: The parameters of the plane or line depend on this axis.
# Do: Write `x`, `y` or `z` into the column `axis`.
# Example: a row of kind `plane` without `axis`
surface-axis-missing = { $kind ->
        [line] the line `{ $name }` needs the axis of the world that is nearest to it
       *[plane] the plane `{ $name }` needs the axis of the world that is nearest to its normal
    }
    .expected = x, y or z in the column `axis`{ $kind ->
            [line] {""}
           *[plane] : z for a table, x or y for a wall
        }

# Means: `offset_mm` is given for a target on a line.
# Matters: An offset from a line has no defined direction.
# Do: Empty the cell.
# Example: `offset_mm = 5` in a row of kind `line`
offset-of-line = `offset_mm` is for planes and spheres, not for a line
    .hint = empty the cell

# Means: A [[known]] of a truth is a point on a plane or line, but has no position.
# Matters: The point cannot be simulated.
# Do: Set `near_mm` to a position on the surface.
# Example: `kind = "plane"` in [[known]] without `near_mm`
near-missing = a point on a { $kind } needs `near_mm`
    .hint = set it to an approximate position in the world frame

# Means: A cell in the column `direction` of a table of loads is not a signed axis.
# Matters: The compliance is computed for each direction.
# Do: Write a sign and an axis, for example `+x`.
# Example: `x` instead of `+x`
load-direction-unknown = `{ $direction }` is not a direction
    .expected = +x, -x, +y, -y, +z or -z

# Means: The table contains a load along z, but no column `z_mm`.
# Matters: The displacement along the force was not measured.
# Do: Add the column `z_mm`, or remove the row.
# Example: `direction = "+z"` in a table of x and y
load-direction-unmeasured = direction `{ $direction }` needs `z_mm`: the displacement in this direction was not measured
    .hint = add the column `z_mm`, or remove the row

# Means: A force is missing, negative or not a number.
# Matters: The load of this row is unknown.
# Do: Write the magnitude in newtons; the direction gives the sign.
# Example: `force_n = -50`
force-not-a-number = `{ $text }` is not a force
    .expected = newtons, zero or more: the direction gives the sign

# Means: `drift_set` is set, but there are no commanded poses.
# Matters: Drift is the change of pose accuracy, which needs commanded poses (ISO 9283, 7.6).
# Do: Set `commanded`, or remove `drift_set`.
# Example: `drift_set = 10` without `commanded`
drift-without-commanded = `drift_set` needs commanded poses
    .hint = add them: `commanded = "commanded.csv"`

# Means: The campaign contains both [poses] and [repeatability].
# Matters: Both give the attained poses of one test, so it is undefined which apply.
# Do: Keep [repeatability] for labelled points, or [poses] for a table.
# Example: [poses] with `attained` and [repeatability] with `label`
attained-poses-twice = [poses] and [repeatability] both give attained poses
    .hint = keep [repeatability] for labelled points, or [poses] for a table

# Means: A limit applies to a characteristic that some poses do not have.
# Matters: The limit cannot be judged at these poses.
# Do: Visit every pose at least twice, and add its commanded position. Or remove the limit.
# Example: `repeatability_max_mm`, but pose 4 was visited only once
limit-without-value = the limit `{ $limit }` cannot be judged: it has no value at pose { $pose }
    .hint = visit every pose at least twice, and add its commanded position

# Means: After compensation with the reference targets, the positions scatter more than before.
# Matters: The reference targets did not move together with the measuring system, so compensation
# makes the positions worse.
# Do: Look for a wrong reading among the reference targets, or remove the reference targets.
# Example: a reference target touched during the test
compensation-scatters = after compensation with the reference targets, attained positions scatter by { LENGTH($after_mm) } about the mean of their pose, before it by { LENGTH($before_mm) }
    .hint = look for a wrong reading among the reference targets, or remove them

# Means: The distances between reference targets changed by more than twice the expanded uncertainty
# of the instrument.
# Matters: A target moved or was measured wrongly, and the compensation contains this error.
# Do: Measure the reference targets again, or exclude the wrong target.
# Example: one of four reference targets bumped in cycle 12
reference-targets-misshapen = reference targets of cycle { $cycle } deviate by { LENGTH($rms_mm) } (root mean square) from a rigid motion since the first cycle; expanded uncertainty { LENGTH($expanded_mm) }
    .hint = a target moved or was measured wrongly: measure the targets again, or exclude the wrong target

# Means: [repeatability] needs a world frame that is measured once, but the campaign measures it at
# each pose.
# Matters: A frame that is measured at each pose adds its own scatter to the repeatability.
# Do: Define the world frame by points that are measured once.
# Example: `each = "pose"` in [frame.world] with [repeatability]
repeatability-frame = [repeatability] needs a world frame that is measured once
    .hint = define the frame by points that do not move

# Means: The table of commanded poses contains angles, but labelled points contain only positions.
# Matters: The accuracy of orientation cannot be computed.
# Do: Remove the column, or give attained poses with angles as a table in [poses].
# Example: `a_deg` in `commanded` of [repeatability]
commanded-angle-unmeasured = `{ $column }` is commanded, but labelled points contain only positions
    .hint = remove the column, or give attained poses with angles as a table: [poses]

# Means: A visited pose is missing in the table of commanded poses.
# Matters: Its accuracy cannot be computed.
# Do: Add a row for every measured pose of the trajectory.
# Example: a trajectory of five poses, but a table of four rows
commanded-pose-missing = no position is commanded for pose { $poses }
    .hint = add a row for every measured pose of the trajectory

# Means: The table of commanded poses contains a pose that was not visited.
# Matters: There are no characteristics of this pose.
# Do: Nothing, if the pose is not part of the test.
# Example: a table of five poses, four visited
commanded-pose-unmeasured = pose { $pose } is commanded but was not measured

# Means: `trajectory` of [repeatability] is an empty list.
# Matters: The order of the visits is unknown.
# Do: Write the poses of one cycle in their order.
# Example: `trajectory = []`
trajectory-empty = the trajectory has no pose
    .hint = write the poses of one cycle in their order, for example [1, 2, 1, 3]

# Means: `coplanar` of [repeatability] contains a pose twice, or a pose that is missing in
# `trajectory`.
# Matters: The deviation from the plane is computed from four visited poses.
# Do: List four different poses of the trajectory.
# Example: `coplanar = [1, 2, 3, 3]`
coplanar-not-four = `coplanar` must contain four different poses of the trajectory
    .expected = four poses of the trajectory, each once

# Means: A label contains a pose that is missing in `trajectory` of [repeatability].
# Matters: The position of this visit in the order of the cycle is unknown.
# Do: Correct the label, or add the pose to `trajectory`.
# Example: the label `visit_9_1` with `trajectory = [1, 2, 3]`
pose-not-in-trajectory = pose { $pose } (cycle { $cycle }) is missing in the trajectory
    .hint = correct the label, or add the pose to `trajectory`

# Means: The labels of [repeatability] contain visits of several targets.
# Matters: Repeatability refers to one point, but several targets have different positions.
# Do: Write the name of one target into `label`.
# Example: `label = "{target}_{pose}_{cycle}"` with three balls
pose-of-several-targets = pose { $pose } (cycle { $cycle }) has visits of `{ $target }` and of another target
    .hint = write the name of one target into `label`

pose-of-cycle = pose { $pose } of cycle { $cycle }

# Means: In a cycle, the number of visits of a pose differs from the trajectory.
# Matters: It is unknown which visit is missing. The directions of approach are therefore unknown.
# Do: Add the missing visit, or remove all visits of this pose and cycle.
# Example: two visits, but the trajectory passes the pose three times
visit-count-differs = pose { $pose } was measured { $found } times in cycle { $cycle }, but the trajectory passes it { $count } times
    .hint = add the missing visit, or remove all visits of this pose and cycle: their previous poses are unknown

# Means: In some cycles, poses of the trajectory were not visited.
# Matters: Their characteristics come from fewer cycles.
# Do: Nothing, if the test was interrupted. Otherwise look for labels with spelling mistakes.
# Example: cycle 30 ended at pose 3
visits-missing = not measured: { $poses }{ $count ->
        [one] {""}
       *[other] {""}; { $count } in total
    }

# Means: The expanded uncertainty of the instrument exceeds 25 % of the repeatability of homing.
# Matters: The value is an upper bound of the robot's repeatability.
# Do: Use the value as an upper bound, or measure with a more accurate instrument.
# Example: a repeatability of 5 µm measured with U = 3 µm
homing-instrument-too-coarse = the measurement uncertainty exceeds 25 % of the repeatability of homing, { LENGTH($rp_mm) }
    .hint = use the value as an upper bound, or measure with a more accurate instrument

# Means: The central part of a path is larger than 100 %.
# Matters: The central part cannot be longer than the path.
# Do: Use 100 or less.
# Example: `central_percent = 150`
central-part-too-large = { $option } exceeds 100 %
    .expected = a number above 0 and at most 100

# Means: The number of command points on a path is below 2 or above 100000.
# Matters: Path accuracy is evaluated in a plane at each command point.
# Do: Use a number from 2 to 100000.
# Example: `path_points = 1`
path-points-out-of-range = { $option } is out of range
    .expected = 2 to 100000

# Means: A velocity or a weave is commanded, but there is no commanded path.
# Matters: The command has no effect.
# Do: Add the file of the commanded path.
# Example: `velocity_mm_s = 100` without `path`
path-not-stated = { $option } needs { $path }
    .hint = add the file of the commanded path

# Means: One of stroke, frequency and direction of a weave is missing.
# Matters: Weaving deviations compare all three.
# Do: Add the missing key.
# Example: `weave_hz` alone
weave-incomplete = `{ $option }` of the weave is missing
    .hint = set stroke, frequency and direction

# Means: The direction of a weave does not have three finite numbers.
# Matters: The stroke is measured along this direction.
# Do: Write x, y and z of the direction.
# Example: `weave_across = [0, 1]`
weave-direction-count = { $option } does not have three numbers
    .expected = x, y and z of the direction of the weaving motion

# Means: Two [[stream]] have the same name.
# Matters: Results and comparisons of campaigns refer to the name.
# Do: Give each stream a different name.
# Example: two [[stream]] with `name = "square"`
stream-twice = stream `{ $stream }` occurs twice
    .hint = give each stream a different name

in-observation = pose { $pose } cycle { $cycle } of the observations: { $message }

in-candidate = pose { $pose } of the candidates: { $message }

in-feature = feature `{ $name }`: { $message }

# Means: Rows with the same pose and cycle have different joint values.
# Matters: All targets of a pose must be measured at the same joint values.
# Do: Correct the joint values. If the rows are repeats, number them in the column `cycle`.
# Example: `q1_deg` 10.0 and 10.5 at pose 3, cycle 1
joints-of-pose-differ = rows of one pose and cycle have different joint values
    .hint = correct them, or number repeats in the column `cycle`

# Means: A target has two rows with the same pose and cycle.
# Matters: It is unknown which of the two rows is right.
# Do: If the rows are repeats, number them in the column `cycle`. Otherwise remove one row.
# Example: two rows `3,1,SMR_1`
target-repeated = target `{ $target }` occurs twice
    .hint = number repeats in the column `cycle`

# Means: At these joint values, the arms of the nominal robot cannot meet.
# Matters: The pose cannot be computed.
# Do: Check unit, sign and offset of the joints, then the nominal parameters.
# Example: `theta1` = 180 deg, `theta2` = 0 deg of a five-bar robot
arms-apart = with nominal parameters the arms do not meet at these joint values
    .hint = check unit, sign and offset of the joints, and the nominal parameters

# Means: The candidates are joint values of a parallel robot, but have no assembly mode.
# Matters: With the same joint values, the robot has two positions.
# Do: Add the column `assembly` with 1 or -1, or use positions as candidates.
# Example: `pose,theta1_deg,theta2_deg` of a five-bar robot
assembly-mode-missing = the assembly mode is not given
    .expected = 1 or -1 in the column `assembly`
    .hint = positions can also be candidates: `pose,x_mm,y_mm` without joints gives all working modes

# Means: The positions of the two assembly modes are about equally far from the measured position.
# Matters: The measurement does not determine the assembly mode.
# Do: Add the column `assembly`, or the position of the base under [nominal].
# Example: a five-bar robot measured along its line of symmetry
assembly-mode-ambiguous = both assembly modes fit equally well: { FIXED($near_mm, 2) } mm and { FIXED($far_mm, 2) } mm from the measured position
    .hint = add a column `assembly` with 1 or -1; or the position of the base (x_o, y_o, phi) under [nominal]

# Means: The log contains no assembly mode, so the mode nearer to the measurement is used.
# Matters: A wrong mode causes an error of millimetres at this pose.
# Do: If the log contains the assembly mode, add the column `assembly`.
# Example: a log of a five-bar robot without `assembly`
assembly-modes-assumed = the assembly mode of { $count } observations was taken from the measurement ({ $positive } in mode +1, { $negative } in mode -1); the least clear pose is { $pose }: { FIXED($near_mm, 1) } mm and { FIXED($far_mm, 1) } mm
    .hint = if the log contains the mode, add a column `assembly` with 1 or -1

# Means: The table contains both columns `ux_mm` .. and columns `cxx_mm2` ..
# Matters: It is undefined which of them give the weights.
# Do: Remove the columns of one form.
# Example: columns `ux_mm` and `cxx_mm2` in one table
uncertainties-twice = the table contains both standard uncertainties and covariances of coordinates
    .hint = remove `ux_mm`, `uy_mm`, `uz_mm`

# Means: A row contains the uncertainties of only some coordinates.
# Matters: The weight of the row is unknown.
# Do: Complete the row, or leave the uncertainty cells of this row empty.
# Example: `ux_mm` without `uy_mm` in a row
coordinate-uncertainty-missing = the row contains an uncertainty, but `{ $column }` is empty
    .expected = from 0.00002 to 100 mm for each coordinate, or empty cells for all

# Means: The uncertainty of a coordinate is zero, negative, below 0.02 µm or above 100 mm.
# Matters: No instrument has such an uncertainty, so the column is probably in another unit.
# Do: Correct the unit or the value.
# Example: `ux_mm = 0.000001`
coordinate-uncertainty-unusable = `{ $column }` = { $value } cannot be the uncertainty of a coordinate
    .expected = from 0.00002 to 100 mm for each coordinate, or empty cells for all

# Means: The covariance of a position has an eigenvalue that is not positive.
# Matters: The covariance of measured coordinates is positive definite: two elements are swapped, or
# have a wrong unit.
# Do: Check the order and the unit of the columns `cxx_mm2` ..
# Example: a correlation above 1
position-covariance-invalid = the covariance of the row is not positive definite
    .hint = check order and unit of the columns `cxx_mm2` ..

unplaced = { $kind ->
        [targets] { $count ->
            [one] 1 target
           *[other] { $count } targets
        }
        [fixtures] { $count ->
            [one] 1 fixture
           *[other] { $count } fixtures
        }
       *[both] { $count } targets and fixtures
    } measured only at validation poses: { $names }; their positions are computed from these readings, with the identified robot held

# Means: All targets of the validation poses are measured only there. All readings are needed to
# compute their positions.
# Matters: No reading remains that could contradict the identified robot.
# Do: Measure these targets at calibration poses too, or move some of their poses to `calibration`.
# Example: a second ball measured at the validation poses, once each
validation-leaves-nothing = { $unplaced }: no redundant reading remains for validation
    .hint = measure them at calibration poses too, or move some of their poses to `calibration`

# Means: A target is measured only at validation poses, and its position is fitted to these
# readings.
# Matters: The errors of these readings are smaller than in an independent validation. The
# statistics account for their redundancy.
# Do: Measure the target at calibration poses too.
# Example: a second ball measured at the validation poses
placed-by-validation = { $unplaced }; the statistics account for this
    .hint = measure them at calibration poses too, or move some of their poses to `calibration`

# Means: Some targets are measured only at validation poses, and their positions are fitted to these
# few readings.
# Matters: Errors of these readings are not judged: for any robot, they are almost zero.
# Do: Measure the targets at calibration poses too.
# Example: a ball measured once, at a validation pose
placed-by-validation-unjudged = { $unplaced }; readings without redundancy are not judged: { $names }
    .hint = measure them at calibration poses too, or move some of their poses to `calibration`

# Means: The nominal robot cannot reach any candidate position, or its model has no inverse
# kinematics.
# Matters: There is nothing to choose from.
# Do: Check the unit of the positions, or give joint values instead.
# Example: candidates in metres
candidate-positions-unreachable = the `{ $model }` cannot reach any candidate position, or the model has no inverse kinematics
    .hint = give joint values instead, one column per joint with its unit

check-readings = check these readings for swapped labels and mistakes; measure them again, or exclude them with `exclude` in [identify]

# Means: A coordinate contradicts the other readings. With the decimal mark elsewhere, or with the
# other sign, it agrees.
# Matters: The row is wrong. Identified parameters absorb the error.
# Do: Compare the coordinate with the display of the instrument, and correct the row of the export.
# Example: 1451,879 mm written as 14518,79 mm
coordinates-wrong = { $count ->
        [one] a coordinate agrees
       *[other] { $count } coordinates agree
    } with the other readings only with another decimal mark or sign: { $coordinates }
    .hint = check the decimal mark and the sign of these coordinates in the export

# Means: A coordinate is far from all other rows of its target. With the decimal mark elsewhere, it
# is among them.
# Matters: The row is wrong, and all parameters change with it.
# Do: Compare the row with the display of the instrument, and correct the export.
# Example: 1451,879 mm without its decimal comma
decimal-mark-wrong = row { $row }: { $axis } of { $target } is { FIXED($value_mm, 3) } mm; most other rows are between { FIXED($least_mm, 0) } and { FIXED($most_mm, 0) } mm, as { FIXED($agrees_mm, 3) } mm is
    .hint = check the decimal mark of this row

settle-readings = settle the readings of { $number ->
        [one] pose
       *[other] poses
    } { $poses } first: correct them, measure them again, or exclude them with `exclude` in [identify]

# Means: A few readings contradict all others, and the result depends on them: without them, a
# parameter changes by more than its standard uncertainty.
# Matters: Either these readings or the parameters are wrong. No controller file is written.
# Do: Look for the cause: a swapped row, a moved reflector, a wrong label. Correct the readings,
# measure them again, or exclude them with `exclude` in [identify].
# Example: one of 112 calibration poses off by 2 mm
readings-decide = { $count ->
        [one] a reading (pose { $poses }) contradicts the others and decides the result: without it
       *[other] { $count } readings (poses { $poses }) contradict the others and decide the result: without them
    }, `{ $parameter }` changes by { FIXED($times, 1) } standard uncertainties

# Means: The parameters of a robust fit and of least squares differ significantly, and no single
# pose is the cause.
# Matters: The residuals are not normally distributed, so standard uncertainties may be too small.
# Do: Look for errors of the robot that the model does not describe, and check the given
# uncertainty.
# Example: base and targets held at wrong nominal values
robust-fit-disagrees = a robust fit changes `{ $parameter }` by { FIXED($over_u, 1) } standard uncertainties of the difference (limit { FIXED($limit, 1) }); no pose disagrees with all others: the residuals are not normal
    .hint = the robot has errors that the model does not describe, or the given uncertainty is too small

# Means: The parameters of a robust fit and of least squares differ significantly. The robust fit
# gives some poses a low weight.
# Matters: These poses contradict the others, and change the parameters.
# Do: Check these poses for swapped labels and wrong readings.
# Example: a pose with the joint values of another pose
robust-fit-disagrees-at-poses = a robust fit changes `{ $parameter }` by { FIXED($over_u, 1) } standard uncertainties of the difference (limit { FIXED($limit, 1) }); poses that disagree with the others: { $poses }

target-positions = `{ $target }` ({ $count ->
        [one] 1 position
       *[other] { $count } positions
    })

# Means: The nominal robot computes all coordinates of a target from the joint values, to the last
# digit of the file.
# Matters: Measured coordinates contain errors of robot and instrument. These coordinates were
# computed, so no parameters can be identified from them.
# Do: Use the measured coordinates in `columns`. If the data are simulated, set `synthetic`.
# Example: `columns` contains the commanded position instead of the measured one
coordinates-commanded = the nominal robot computes the coordinates of { $targets } from the joint values to within { SCIENTIFIC($largest_mm, 2) } mm, the rounding of the file: they were commanded, not measured
    .hint = use the measured coordinates in `columns`; if the data are simulated, set `synthetic` in the campaign

# Means: The points of the world frame agree with the mirror image of `nominal_mm`, not with
# `nominal_mm`.
# Matters: No rotation mirrors a body: two axes of the export are swapped, or one axis has the wrong
# sign.
# Do: Check the columns and the signs of the export.
# Example: `columns = ["label", "y", "x", "z"]`
frame-points-mirrored = the points of the world frame are { FIXED($off_mm, 3) } mm from their nominal positions, but agree with the mirror image within { FIXED($limit_mm, 3) } mm
    .hint = two axes of the export are swapped, or one axis has the wrong sign: check the columns

# Means: One point of the world frame is not at its nominal position; the other points agree.
# Matters: This point shifts or rotates the frame, and every position with it.
# Do: Check the point, its label and `nominal_mm`, or set the tolerance of the drawing.
# Example: a reflector that is not seated in its nest
frame-point-off = `{ $point }` is { FIXED($off_mm, 3) } mm from its nominal position relative to the other points (tolerance { $tolerance_mm } mm, U = { FIXED($expanded_mm, 4) } mm)
    .hint = check the point, its label and `nominal_mm`, or set the tolerance of the drawing

# Means: Some points of the world frame are not at their nominal positions, and no single point is
# the cause.
# Matters: The frame, and every position with it, is wrong by about this amount.
# Do: Check the points, their labels and `nominal_mm`, or set the tolerance of the drawing.
# Example: `nominal_mm` in inches
frame-points-off = the measured distance from `{ $first }` to `{ $second }` is { FIXED($measured_mm, 3) } mm, the nominal distance { FIXED($nominal_mm, 3) } mm (tolerance { $tolerance_mm } mm, U = { FIXED($expanded_mm, 4) } mm)
    .hint = check the point, its label and `nominal_mm`, or set the tolerance of the drawing

# Means: `nominal_mm` of [frame.world] contains a point that no export contains.
# Matters: The point cannot be compared.
# Do: Correct the name of the point, or remove it.
# Example: `nominal_mm = { base_9 = [0, 0, 0] }` with base_1 to base_4
nominal-point-unmeasured = `nominal_mm` contains `{ $point }`, which was not measured

# Means: `nominal_mm` of [frame.world] contains fewer than three points.
# Matters: Two points agree with any drawing if only their distance is right.
# Do: Add points of the frame to `nominal_mm`, or remove the key.
# Example: `nominal_mm` of two points
nominal-few-points = `nominal_mm` needs three points or more
    .hint = add points of the frame, or remove `nominal_mm`

# Means: The identified base is far from [nominal] of robot.toml. If axes of the world frame are
# swapped, the two agree.
# Matters: The robot itself is identified correctly. But the base, and positions in the world frame,
# refer to other axes than robot.toml.
# Do: Check the axes and points of the world frame, and [nominal].
# Example: z is vertical in the export, y is vertical in robot.toml
world-axes-exchanged = the base is { FIXED($off_mm, 0) } mm and { FIXED($off_deg, 1) } deg from its position in robot.toml: x, y, z of robot.toml are { $axes } of the world frame
    .hint = check axes, unit and points of the world frame, and [nominal] of robot.toml

# Means: The identified base is far from its position in [nominal] of robot.toml.
# Matters: The points of the world frame or its unit are wrong, or robot.toml contains another
# position.
# Do: Check axes, unit and points of the world frame, then [nominal].
# Example: a world frame defined by the points of another fixture
base-off-nominal = the base is { FIXED($off_mm, 0) } mm and { FIXED($off_deg, 1) } deg from its position in robot.toml; limit { $limit_mm } mm, { FIXED($limit_deg, 1) } deg
    .hint = check axes, unit and points of the world frame, and [nominal] of robot.toml

orientation-slip = { $slip ->
        [scalar-last] the scalar of the quaternions last
        [scalar-first] the scalar of the quaternions first
        [scalar-last-inverse] the scalar of the quaternions last, and the inverse rotations
        [order] angles in the order `{ $name }`
        [vectors] rotation vectors instead of angles
        [order-of-vectors] angles in the order `{ $name }` instead of rotation vectors
        [radians] angles in radians instead of degrees
        [degrees] angles in degrees instead of radians
        [negated] the angles with the opposite sign
        [inverse] the inverse rotations
       *[left-handed] a left-handed frame ({ $name } reversed)
    }

# Means: Observed orientations differ from the orientations of the robot by more than errors of the
# joints can explain.
# Matters: They have another convention than their columns say, or a joint is reversed. Parameters
# identified from them have no meaning.
# Do: Check the causes in the hint. Otherwise check that qw, qx, qy, qz rotate vectors from the body
# to the world, with the scalar first. For angles, check their order.
# Example: quaternions with the scalar last in columns qw, qx, qy, qz
orientations-off = observed orientations differ from the orientations of the { $robot ->
        [nominal] nominal
       *[identified] identified
    } robot by { FIXED($median_deg, 1) } deg (median)
    .hint = check that qw, qx, qy, qz rotate vectors from the body to the world, with the scalar first; or check the order of angles: without `orientation`, the message lists the orders that agree

# Means: There are too few calibration poses to predict some of them from the others.
# Matters: Effects are compared by their errors at held-out poses, so they cannot be compared.
# Do: Measure more poses, or select more poses in `calibration`.
# Example: `etalon recommend` with four poses
few-poses-to-leave-out = { $count ->
        [one] 1 calibration pose is
       *[other] { $count } calibration poses are
    } too few to hold some out
    .expected = at least { $least }
    .hint = measure more poses, or select more poses in `calibration`

# Means: The observations contain no position, distance or contact.
# Matters: Effects are compared by their position errors.
# Do: Measure positions, distances or contacts.
# Example: a table of orientations alone
nothing-to-judge = the observations contain no position, distance or contact
    .hint = parameters are judged by position errors: measure positions, distances or contacts

# Means: In joint space, half of the validation poses are much nearer to a calibration pose than
# calibration poses are to each other.
# Matters: These poses repeat the errors of the calibration. At other poses, errors may be larger.
# Do: Choose validation poses between the calibration poses.
# Example: the poses of the calibration measured again
validation-repeats-calibration = validation repeats the calibration: the median distance of a validation pose from the nearest calibration pose is { FIXED($median, 2) } times the spacing of the calibration poses; limit { $limit }
    .hint = at other poses the error may be larger: choose validation poses between the calibration poses

# Means: In joint space, half of the validation poses are much farther from the calibration poses
# than calibration poses are from each other.
# Matters: At these poses the parameters are extrapolated, so errors are larger than in the
# calibrated region.
# Do: Calibrate at poses that cover the whole workspace in use.
# Example: calibration in one corner, validation in the other
validation-far = validation is far from the calibration: the median distance of a validation pose from the nearest calibration pose is { FIXED($median, 2) } times the spacing of the calibration poses; limit { $limit }
    .hint = calibrate at poses that cover the whole workspace in use

# Means: The column `quantity` of a table of errors contains an unknown name.
# Matters: The report cannot be written from this table.
# Do: Run the campaign again with this version of etalon.
# Example: `quantity` is `velocity`
error-quantity-unknown = `{ $name }` is not a quantity of errors
    .hint = run the campaign again: `etalon run CAMPAIGN`

# Means: The column `set` of a table of errors contains neither `calibration` nor `validation`.
# Matters: It is unknown to which statistics the row belongs.
# Do: Correct the cell.
# Example: `set` is `control`
pose-set-unknown = `{ $name }` is not a set of poses
    .expected = calibration or validation

# Means: All rows were measured at the same joint values. Or the joint values differ so little that
# noise hides the effect of every parameter.
# Matters: Repeats of one pose show only noise, so no parameter of the robot can be identified.
# Do: Measure poses with different values of every joint. If the robot did move, check the columns
# of the joint values.
# Example: one pose measured thirty times
joints-do-not-move = the joints do not move: all { $rows } observations are { $motion }; they determine no parameter of the robot{ $points ->
        [0] {""}
       *[other] {" "}(scatter of the measured points: { FIXED($scatter_mm, 3) } mm)
    }
    .hint = measure poses with different values of every joint; if the robot did move, check the columns and the file of the joint values

motion-none = at one pose

motion-within-angle = within { FIXED($range_deg, 3) } deg in every joint

motion-within-length = within { FIXED($range_mm, 3) } mm in every joint

motion-within-both = within { FIXED($range_deg, 3) } deg and { FIXED($range_mm, 3) } mm in every joint

# Means: A joint has the same value at all calibration poses. Parameters that only its motion
# determines keep their nominal values.
# Matters: At other values of the joint, errors of these parameters remain, up to their tolerances.
# Do: Move the joint between the calibration poses, or use the robot only at this value of the
# joint.
# Example: joint 6 at 0 in all poses
joint-does-not-move = `{ $joint }` does not move: { $count ->
        [one] the data do not determine 1 parameter
       *[other] the data do not determine { $count } parameters
    }, known only within tolerance: { $parameters }
    .hint = move `{ $joint }` between the calibration poses, or use the robot only at this value; otherwise errors up to the tolerance of `{ $first }` remain

# Means: The standard uncertainty of the direction of a feature is too large for a frame.
# Matters: The direction of a frame that uses this feature is arbitrary.
# Do: Measure points that are farther apart and not on one line.
# Example: a plane through three points on one line
direction-undetermined = its direction has a standard uncertainty of { FIXED($direction_deg, 0) } deg; limit { $limit_deg } deg
    .hint = measure points that are farther apart and not on one line

# Means: The direction of a feature has a large standard uncertainty.
# Matters: A frame that uses this feature rotates all positions by this uncertainty.
# Do: Measure points that are farther apart.
# Example: five readings of a plane over 300 mm, one of them wrong by 5 mm
direction-uncertain = its direction has a standard uncertainty of { FIXED($direction_deg, 2) } deg; limit { $limit_deg } deg
    .hint = measure points that are farther apart

# Means: `towards` of [frame.world] is a point on the axis.
# Matters: A point on the axis does not determine the direction of the other axis.
# Do: Use a point away from the axis in `towards`.
# Example: `towards` equal to the end of `x_axis`
world-side-undetermined = `towards` lies on the axis, so the direction of the other axis is unknown
    .hint = use a point away from the axis

# Means: `targets` of [frame.world] contains fewer than three targets.
# Matters: Two points leave one rotation undetermined.
# Do: List at least three targets.
# Example: `targets = ["base_1", "base_2"]`
frame-few-targets = the world frame has { $count ->
        [one] 1 target
       *[other] { $count } targets
    }
    .expected = at least three targets

# Means: No pose has all targets of [frame.world], or these targets are at one position or on one
# line.
# Matters: The world frame cannot be determined.
# Do: Measure all targets of the frame, and check their labels.
# Example: the label of a frame target has a spelling mistake in the whole export
frame-never-complete = no pose has all targets { $targets } of the world frame at different positions
    .hint = measure all of these targets, and check their labels

# Means: The table contains orientations in two forms.
# Matters: It is undefined which columns apply.
# Do: Remove the columns of one form, or skip them.
# Example: columns `qw, qx, qy, qz` and `a_deg, b_deg, c_deg`
orientations-twice = the table contains orientations in two forms: { $first } and { $second }
    .hint = remove one of them

# Means: The table contains only some of the columns of an orientation.
# Matters: The orientation is incomplete.
# Do: Add the missing columns.
# Example: `qx, qy, qz` without `qw`
orientation-columns-missing = columns of the orientation are missing: { $missing }
    .expected = { $columns }: orientation of the body in the world

# Means: A number of an orientation is missing or cannot be read.
# Matters: The orientation is incomplete.
# Do: Complete the row, or remove it.
# Example: an empty `qz`
orientation-missing = the orientation is missing or not a number
    .expected = orientation of the body in the world: qw, qx, qy, qz, or a rotation vector, or three angles

# Means: Orientations are given as three angles, but the order of the rotations is missing.
# Matters: The orientation depends on the order of the rotations.
# Do: Look up the order in the manual of the measuring system or controller, and set `orientation`.
# Example: `a_deg, b_deg, c_deg` without `orientation`
angle-order-missing = the order of the angles is not given
    .hint = set `orientation = "zyx"` in [observations], or add --orientation

angle-orders-unfit = no order of angles agrees with the nominal robot: the smallest residual is { FIXED($left_deg, 1) } deg (root mean square) with `{ $order }`; check the joints, and that the angles rotate from the body to the world

angle-order-leaves = `{ $order }`: residual { FIXED($left_deg, 3) } deg

angle-orders-fit = set `orientation = "{ $order }"` in [observations], or --orientation; with the nominal robot, { $orders } (root mean square)

# Means: A step of the geometric calibration needs several balls in one cycle, but one ball was not
# measured.
# Matters: The step cannot be evaluated for this pose and cycle.
# Do: Measure the ball, or remove the other readings of this pose and cycle.
# Example: K measured at the end of the offsets, but not L
ball-missing = ball `{ $target }` is missing (pose { $pose }, cycle { $cycle })
    .hint = measure the ball, or remove the other readings of this pose and cycle

# Means: `actuator` of [[geometric.lead]] is not 1, 2 or 3.
# Matters: A PreXYT has three actuators.
# Do: Write 1, 2 or 3.
# Example: `actuator = 4`
actuator-unknown = actuator { $actuator } does not exist
    .expected = 1, 2 or 3

# Means: The position in a label of a lead measurement does not exist in `positions_mm`.
# Matters: The commanded displacement is unknown.
# Do: Correct the label, or complete `positions_mm`.
# Example: position 6 with five `positions_mm`
lead-position-unknown = position { $position } of actuator { $actuator } is not among `positions_mm`
    .hint = correct the label, or complete `positions_mm`

# Means: The geometric calibration needs a world frame defined by the rails and ball R.
# Matters: Without it, the base of the robot is unknown.
# Do: Set `plane`, `origin`, `y_axis` and `towards` of [frame.world] (thesis 3.4.1).
# Example: [frame.world] with `targets`
geometric-frame = the geometric calibration needs a world frame from the rails and ball R
    .expected = `plane`, `origin`, `y_axis = [origin, other end]` and `towards`, as in the thesis’ 3.4.1

# Means: [geometric] is given for a robot that is not a PreXYT.
# Matters: The steps of [geometric] measure the links of a PreXYT.
# Do: Remove [geometric], or set `model = "prexyt"`.
# Example: [geometric] with a six-axis arm
geometric-other-robot = [geometric] is available only for a PreXYT
    .expected = a robot with model `prexyt`

# Means: The measured length of a scale bar differs from its certificate by more than the maximum
# permissible error (MPE) of the instrument.
# Matters: The instrument does not meet its specification. Lengths in this campaign have errors of
# similar size.
# Do: Check probe, temperature and mounting of the instrument, and measure the bar again.
# Example: a bar measured with an unqualified probe
scale-bar-error = scale bar `{ $name }`: an error of { FIXED($error_mm, 4) } mm exceeds the permissible { FIXED($limit_mm, 4) } mm
    .hint = check probe, temperature and mounting of the instrument, and measure the bar again

# Means: A measured length of a scale bar is off by more than the permissible error plus the
# uncertainty of the bar. Without a good certificate, instrument or bar may be wrong.
# Matters: Lengths of this campaign may have errors of similar size.
# Do: State the length from the bar's certificate; check probe, temperature and mounting of the
# instrument, and measure the bar again.
# Example: a bar with a nominal length of 300 mm that is 300.4 mm long
scale-bar-deviates = scale bar `{ $name }`: a distance deviates by { FIXED($error_mm, 4) } mm from the stated length; permissible are { FIXED($limit_mm, 4) } mm and U = { FIXED($u_mm, 4) } mm of the length
    .hint = state length and uncertainty from the bar's certificate, check probe and temperature, and measure the bar again

# Means: The maximum permissible error of the instrument is less than four times the expanded
# uncertainty of the bar (4:1 rule of ANSI/NCSL Z540).
# Matters: The bar is not accurate enough to verify the instrument.
# Do: Use a bar with a smaller uncertainty in its certificate.
# Example: a bar with U = 3 µm for a permissible error of 5 µm
scale-bar-uncertain = scale bar `{ $name }`: the permissible error is { FIXED($ratio, 1) } times the expanded uncertainty of its certificate, { $least } times are required
    .hint = use a bar with a smaller uncertainty: this bar cannot verify the instrument

# Means: In a step of the geometric calibration, the residuals scatter more than the uncertainty of
# the instrument.
# Matters: The uncertainties of this step are computed from the residuals.
# Do: Check for play, a dirty ball or a loose nest, then measure the step again.
# Example: a ball that moves in its nest
step-scatters = { $step }: residuals scatter by { FIXED($found_mm, 4) } mm, the instrument by { FIXED($stated_mm, 4) } mm; uncertainties are computed from the residuals
    .hint = check for play, a dirty ball or a loose nest; measure the step again

# Means: A table of the geometric report selects no pose at which K and L were measured in the same
# cycle.
# Matters: The table is empty.
# Do: Measure both balls in the same cycle, or select other poses.
# Example: `poses = "9-13"`, but only K was measured at these poses
table-without-poses = the table `{ $title }` has no pose at which K and L were measured together
    .hint = measure both balls in the same cycle, or select other poses

# Means: parameters.json contains no covariance, because the identification had no degrees of
# freedom.
# Matters: It is impossible to judge whether new measurements contradict the parameters.
# Do: Measure more poses, and identify again.
# Example: a parameters.json whose `covariance` is empty
given-without-covariance = the parameters have no covariance
    .hint = identify again from more data: the identification had no degrees of freedom

# Means: The given parameters do not contain the base or the targets of the observations.
# Matters: The positions of this base or of these targets are unknown.
# Do: Use the targets of the calibration, at the same positions on the moving part.
# Example: a new reflector on the flange
calibrated-targets-missing = the parameters do not contain { $names }: the observations have another base or other targets
    .hint = use the targets of the calibration, at the same positions on the moving part

# Means: parameters.json and robot.toml describe different robots.
# Matters: The parameters have no meaning for this robot.
# Do: Give the robot.toml that the identification used.
# Example: parameters of a `serial` arm with a `prexyt`
parameters-of-other-robot = the parameters belong to a `{ $identified }`; robot.toml describes another robot (`{ $stated }`)
    .hint = give the robot.toml that the identification used

parameters-lacking = the parameters do not contain { $names }; give the robot.toml that the identification used

# Means: parameters.json contains parameters that robot.toml does not describe.
# Matters: Poses would be computed without these parameters, that is, for another robot.
# Do: Add the lines in the hint to robot.toml, or give the robot.toml that the identification used.
# Example: parameters with `bending_2`, robot.toml without `bending`
parameters-undescribed = the parameters contain { $names }, which robot.toml does not describe
    .hint = give the robot.toml that the identification used

add-lines = add { $lines } to robot.toml, before its first table

# Means: A nominal value in robot.toml differs from the value used in the identification.
# Matters: The parameters probably belong to another robot, or robot.toml was edited after the
# identification.
# Do: Check the serial number of the robot, and restore the robot.toml of the identification.
# Example: `a_2 = 225` in robot.toml, 270 in parameters.json
nominal-value-changed = `{ $parameter }` is nominally { $stated }{ $unit ->
        [mm] {" "}mm
        [deg] {" "}deg
       *[other] {""}
    } in robot.toml, but was { $identified }{ $unit ->
        [mm] {" "}mm
        [deg] {" "}deg
       *[other] {""}
    } when the parameters were identified
    .hint = check that the parameters belong to this robot

# Means: robot.toml describes another geometry than the robot that was identified: with equal values
# of all parameters, the two robots have different flange positions.
# Matters: The parameters are corrections of the identified robot. They do not correct this robot.
# Do: Give the robot.toml that the identification used, or identify again with this one.
# Example: a robot in screw axes (`poe`) whose fourth axis was moved by 10 mm after the run
robot-geometry-changed = robot.toml describes another geometry than the identified robot: { $case ->
        [apart] with equal parameters, the flanges are { $distance_mm } mm apart
       *[other] joints or links differ
    }
    .hint = give the robot.toml that the identification used, or identify again

# Means: robot.toml is not the file that the identification used. parameters.json comes from an
# earlier version, and contains no flange positions to compare.
# Matters: The nominal geometry outside the parameters may be different, for example screw axes
# (`poe`).
# Do: Run the campaign again. The new parameters.json can be compared with robot.toml.
# Example: parameters.json of version 0.1, and a robot.toml that was edited since
robot-geometry-unknown = robot.toml is not a file of the identification, and parameters.json contains no geometry to compare it with
    .hint = check that robot.toml describes the identified robot, or run the campaign again

# Means: parameters.json contains no standard uncertainty of a coordinate, and its residuals do not
# determine one.
# Matters: It is unknown how large the deviations of new measurements may be.
# Do: Identify again with the uncertainty of the instrument.
# Example: a parameters.json with `degrees_of_freedom` 0 and without a given uncertainty
calibration-without-residuals = the calibration does not determine the standard uncertainty of a coordinate
    .hint = identify again with the uncertainty of the instrument

# Means: An effect that was not identified could reduce the error at held-out calibration poses
# significantly.
# Matters: Errors of the robot by this effect are part of the residuals.
# Do: Add the line to robot.toml, or the effect to `effects` in [identify].
# Example: a geared arm with eccentric gears, but only its geometry was identified
effect-would-prove = significant effect: { $effect }{ $count ->
        [0] {""}
       *[other] {" "}of joints { $joints }
    }; with it, the error at held-out calibration poses falls from { FIXED($without_mm, 3) } to { FIXED($with_mm, 3) } mm (position, root mean square)
    .hint = add "{ $effect }" to `effects` in [identify]

# Means: `outliers = "exclude"` would exclude more than a tenth of all readings.
# Matters: So many readings cannot be outliers: the model or the set-up is wrong.
# Do: Set `outliers = "keep"`, and check the readings that it reports.
# Example: 16 of 80 readings are wrong by 1 mm
outliers-too-many = `outliers = "exclude"` would exclude more than { $share_percent } % of all readings
    .hint = the model or the set-up is wrong: check the readings that `outliers = "keep"` reports

# Means: The residuals with one log correlate with the difference between the two logs.
# Matters: The other log describes the pose of the robot better, for example encoder values instead
# of commanded values.
# Do: Use the log that gives smaller residuals for the identification.
# Example: one log of commanded joint values, one of encoder values
log-correlates = with log `{ $log }`, residuals correlate with the difference of the two logs (r = { FIXED($correlation, 2) }): residuals { FIXED($rms_mm, 3) } mm (root mean square), with log `{ $other }` { FIXED($other_rms_mm, 3) } mm

use-log = { $hint ->
        [name-first] identify with log `{ $log }`: move its [[log]] to the first place
       *[is-used] log `{ $log }` is the better one, and this campaign uses it
    }

# Means: `calibration` or `validation` contains a pose that has no measurements or no joint values.
# Matters: The set contains fewer poses than you selected.
# Do: Correct the name, or measure the pose.
# Example: `calibration = "1-40, hom"`, but the pose is `home`
selected-pose-unmeasured = `{ $pose }` is not the name of a measured pose

# Means: `calibration` or `validation` selects none of the measured poses.
# Matters: There are no poses for the identification or the validation.
# Do: Select poses that were measured; the message lists them.
# Example: `calibration = "100-200"` of poses 1 to 50
selection-without-pose = `{ $set }` selects no measured pose

# Means: Poses are both in calibration and in validation.
# Matters: The errors at calibration poses are too small for a validation.
# Do: Remove each of these poses from one of the two sets.
# Example: `calibration = "1-40"`, `validation = "30-50"`
sets-overlap = poses in both calibration and validation: { $poses }
    .hint = `validation = "rest"` selects all poses that calibration does not use

# Means: A pose is in several series.
# Matters: The scatter between series is computed from separate poses.
# Do: Remove each of these poses from all but one series.
# Example: `series = ["1-40", "30-50"]`
series-overlap = poses in several series: { $poses }
    .hint = put each pose into one series

# Means: A series contains no calibration pose: its poses are for validation, or excluded.
# Matters: The scatter between series is computed from calibration poses, so this series has no
# influence.
# Do: Nothing. To include the series, use some of its poses for calibration.
# Example: `calibration = "1-40"`, `series = ["1-20", "21-40", "41-60"]`
series-without-calibration = series without a calibration pose, which have no influence: { $series }

# Means: Some calibration poses are in no series.
# Matters: The scatter between series is computed from all calibration poses.
# Do: Add the poses to their series, or add `"rest"` as the last series.
# Example: `series = ["1-40", "41-80"]` with 90 poses
series-incomplete = calibration poses that are in no series: { $poses }
    .hint = `"rest"` selects all poses that are in no earlier series

# Means: All calibration poses are in one series.
# Matters: A single series shows no scatter between series, so the uncertainties do not include it.
# Do: List the poses of each set-up, day or file, or remove `series`.
# Example: `series = ["all"]`
series-single = only one series of `series` contains calibration poses
    .hint = write at least two series, or remove `series`

# Means: A table of the geometric report selects no pose of calibration or validation.
# Matters: The table is empty.
# Do: Select poses of these sets.
# Example: `poses = "100-110"` of poses 1 to 50
table-selection-empty = the table `{ $title }` contains no measured pose
    .hint = select poses of `calibration` and `validation`

poses-measured = { $count ->
        [one] 1 pose is
       *[other] { $count } poses are
    } measured and joined, from { $first } to { $last }

poses-unmeasured = no pose is measured and joined

at-pose = pose { $pose }: { $message }

values-of-column = { $message } (like { $count } of { $total } values)

check-column-unit = check the unit of its column: all values are in range in { $units ->
        [degrees] degrees instead of radians
       *[millimetres] millimetres instead of metres
    }

# Means: A joint value is outside the limits of robot.toml, larger than two turns, or far from all
# other values of its column.
# Matters: A decimal mark is missing, or the unit is wrong. The gain of the joint would absorb such
# a mistake without a message.
# Do: Check decimal mark and unit. If the joint can really reach this value, correct its limits in
# robot.toml.
# Example: `179500` for 179.500 deg
joint-out-of-range = joint `{ $joint }` = { $value } { $unit } is out of range
    .expected = from { $lower } to { $upper } { $unit }: { $reason ->
            [limits] the limits of the robot file, plus 1 % of their range
            [turns] two turns, because the robot file contains no limits
           *[others] the range of the other values
        }
    .hint = check its decimal mark and unit; if the joint can reach this value, { $reason ->
            [limits] correct its limits in the robot file
           *[others] add its limits to the robot file
        }

# Means: Errors common to all readings (scale, temperature, homing) are given, but the observations
# are not only positions of targets.
# Matters: `etalon uncertainty` simulates common errors for positions only.
# Do: Use the uncertainties from `etalon run`, which propagates common errors linearly.
# Example: `expanded_scale_uncertainty_um_per_m` for a campaign of distances
common-errors-of-conditions = errors common to all readings (scale, temperature, homing) are simulated for positions of targets only
    .hint = `etalon run` gives the uncertainties of this campaign by linear propagation

# Means: The points of a feature are probe centres, but the file contains neither the radius nor the
# side of the probe.
# Matters: The distance of the feature from these points is the probe radius; the side is unknown.
# Do: Add the option in the hint.
# Example: a QIF file with centre points and without a sensor
probe-of-feature-unknown = `{ $feature }` is not fitted: its points are probe centres, and the file does not give { $missing ->
        [side] the side of the probe
       *[radius] the radius of the probe
    }
    .hint = { $missing ->
            [side] add --probe-side inside, outside or x,y,z
           *[radius] add --probe-radius-mm
        }

unstable-parameter = `{ $parameter }` ({ FIXED($over_sd, 1) }, limit { FIXED($limit, 1) })

# Means: Parameters identified from a part of the poses differ significantly from the parameters of
# all poses.
# Matters: Something changed during the measurement, so the values describe only a part of the
# poses. They are loaded nevertheless, because errors at held-out poses are larger without them.
# Do: Look for changes during the measurement: temperature, a target that moved, a joint that was
# homed again. Check the residuals.
# Example: a reflector that moved after half of the poses
parameters-unstable = unstable parameters; differences between a part of the poses and all poses, in standard deviations of the difference: { $parameters }
    .hint = check for changes during the measurement (temperature, a target that moved, a joint that was homed again), and check the residuals

remedy = { $remedy ->
        [pose-uncertainty] add it (--standard-uncertainty-um), or use `residuals = "targets"`
        [contact-uncertainty] add the repeatability of the contact (--standard-uncertainty-um), and use `residuals = "targets"`
        [compare-targets] use `residuals = "targets"`
        [targets] use positions of its targets: rows of kind `point`
        [uncertainty] add it (--standard-uncertainty-um)
        [own-uncertainties] use `residuals = "targets"`, or remove the columns of uncertainties
        [row-uncertainty] add it to every row, or add --standard-uncertainty-um
        [part] `frame` is `flange` for an arm, `platform` for a PreXYT, `targets` for any robot
        [positions] choose more positions, or hold parameters with `--hold`
        [hold-fewer] hold fewer parameters, and measure more poses
        [more-poses] measure more poses (repeats of a pose add nothing), or hold parameters with `hold` in [identify] or --hold
        [hold] keep parameters at nominal with `hold` in [identify] or --hold, or measure more poses
        [unreachable] check unit (degrees or radians), sign and offset of the joints, and the nominal parameters
        [extent] check `unit` of the exports, the units of the joints in the log, and the lengths of the robot
        [readings] check these readings and the order of the rows of the log, or omit these poses (`exclude`, --exclude)
        [assembly] correct the column `assembly` of these poses, or empty it: the program then chooses the mode nearer to the measurement
       *[joints] check units, order and signs of the joints and the nominal parameters; `hold` in [identify] keeps parameters at nominal
    }

reading-off = { FIXED($off_mm, 4) } mm ({ $target }, pose { $pose }, cycle { $cycle })
orientation-off = { FIXED($off_deg, 3) } deg in orientation ({ $target }, pose { $pose }, cycle { $cycle })
quantity-off = { FIXED($off_mm, 4) } mm in { $quantity } ({ $target }, pose { $pose }, cycle { $cycle })
deviation-of-lengths = { FIXED($deviation_mm, 4) } mm ({ $quantity })
deviation-of-angles = { FIXED($deviation_deg, 3) } deg (orientation)

# Means: The residuals exceed the instrument's uncertainty, but a robust fit finds no outliers. The
# message lists the largest residuals of this fit.
# Matters: Errors of the robot affect all poses; wrong readings affect single poses.
# Do: First check these readings for swapped labels and mistakes. If they are right, add the missing
# effect to the model.
# Example: a robot whose gear errors are not in the model
largest-residuals = largest residuals of a robust fit: { $readings }
    .hint = first check these readings for swapped labels and mistakes; errors of the robot affect all poses

outlier-readings = { $count ->
        [one] 1 of { $total } readings is an outlier
       *[other] { $count } of { $total } readings are outliers
    }: residuals above { $times } times { $scales }, the standard deviation of the others in a robust fit: { $readings }

# Means: In a robust fit, some residuals are much larger than the standard deviation of the others.
# Matters: Wrong readings change all parameters.
# Do: Check these readings for swapped labels and mistakes. Measure them again, or exclude them with
# `exclude` in [identify].
# Example: a reflector measured with the name of its neighbour
outliers = { $outliers }

# Means: `outliers = "exclude"` has excluded readings from the calibration.
# Matters: These readings have no influence on the result.
# Do: Check these readings: an outlier can also be an error of the robot at one pose.
# Example: `outliers = "exclude"` with one wrong reading
outliers-excluded = excluded by `outliers = "exclude"`: { $outliers }

repeated-position = { $target } at poses { $first } and { $second }

# Means: A target has identical coordinates at two poses, although the nominal robot moves it
# between them.
# Matters: No instrument repeats a reading to the last digit. One of the two readings belongs to
# another pose.
# Do: Measure one of these poses again, or exclude the reading.
# Example: a reading that was exported twice
positions-repeat = measured positions are identical although the joints moved, { $count ->
        [one] once
       *[other] { $count } times
    }: { $pairs }
    .hint = the export contains a reading of another pose: measure these poses again, or exclude them

repeated-joints = poses { $first } and { $second }, { FIXED($apart_mm, 3) } mm apart

# Means: Two poses have identical joint values, although a target moved between them.
# Matters: One of the two rows of the log belongs to another pose.
# Do: Log the joint values of these poses again, or exclude the wrong pose.
# Example: a log whose recorder missed one pose
joint-values-repeat = joint values are identical although the targets moved, { $count ->
        [one] once
       *[other] { $count } times
    }: { $pairs }
    .hint = the log contains the joint values of another pose: log these poses again, or exclude them

# Means: The scatter of a fixed point exceeds the uncertainty of the instrument.
# Matters: Features and frames that use this point are less accurate than expected.
# Do: Check `unit` of the export and the uncertainty of the instrument. Check that the point did not
# move.
# Example: an uncertainty of 15 µm for an arm with 60 µm
repeats-scatter = repeats of `{ $label }` are up to { FIXED($off_mm, 4) } mm from their median; standard uncertainty of the instrument { FIXED($u_mm, 4) } mm
    .hint = check `unit` of the export and the uncertainty of the instrument, and that the point did not move

# Means: One or a few repeats of a fixed point are far from the others.
# Matters: Features and frames that use this point depend on it, and so does every result.
# Do: Remove the wrong reading from the export, or measure the point again.
# Example: a reading taken while the reflector was put down
repeat-off = { $away } of { $count ->
        [one] 1 repeat
       *[other] { $count } repeats
    } of `{ $label }` { $away ->
        [one] lies
       *[other] lie up to
    } { FIXED($off_mm, 4) } mm from their median; standard uncertainty of the instrument { FIXED($u_mm, 4) } mm
    .hint = remove the wrong reading from the export, or measure the point again: every result depends on it

# Means: The standard uncertainties of some rows are 0, because the file rounds them. The program
# replaces them with the resolution of the column: half of the last digit divided by √3 (GUM 4.3.7).
# Matters: A reading with uncertainty zero would outweigh all others.
# Do: Change the export to more decimals.
# Example: `0.00` in a column with two decimals
uncertainty-zero-rounded = `{ $column }` is 0 in { $count ->
        [one] 1 row
       *[other] { $count } rows
    }: rounded, and replaced with the resolution of the column, u = { $u } { $unit } (half of the last digit over √3)
    .hint = export uncertainties with more decimals

# Means: The standard uncertainties of some rows are 0, and the column does not show its resolution.
# Matters: A reading with uncertainty zero would outweigh all others. The program uses the
# uncertainty of the instrument instead.
# Do: Change the export to more decimals.
# Example: a column that is 0 in all rows
uncertainty-zero = `{ $column }` is 0 in { $count ->
        [one] 1 row
       *[other] { $count } rows
    }, and its resolution is unknown: the uncertainty of the instrument is used instead
    .hint = export uncertainties with more decimals

# Means: A key for delimited text is given, but the table is a sheet of a workbook or a topic of a
# recording.
# Matters: These tables have no delimiter and no encoding; the numbers of a recording have no
# decimal mark.
# Do: Remove the key.
# Example: `delimiter = ";"` with `sheet`
key-of-text-table = `{ $key }` has no effect on a sheet of a workbook or a topic of a recording
    .hint = remove `{ $key }`: it applies to delimited text only

# Means: The errors of the identified robot exceed 2 % of the range of the measured positions.
# Matters: The errors of a calibrated robot are about a thousandth of its workspace. These are not
# measurements of this robot at these joint values.
# Do: Follow the hint. It gives a cause only if the errors show the cause.
# Example: a log of another campaign
measurements-undescribed = on the { $set ->
        [validation] validation
       *[calibration] calibration
    } poses, errors are { FIXED($after_mm, 3) } mm (root mean square), and positions span { FIXED($spread_mm, 1) } mm; { $count } of { $total } errors exceed { FIXED($limit_mm, 1) } mm: the model does not describe these measurements

undescribed-targets = only the readings of { $targets } have large errors: check labels, and whether the target moved

undescribed-rows-shifted = from pose { $first } to pose { $last }, the positions agree with the joint values of the { $neighbour ->
        [previous] previous
       *[next] next
    } pose: check whether the log has a row too many or too few there

undescribed-readings = { $readings }: { $remedy }

undescribed-set-up = check units, order and signs of the joints, the nominal parameters, and the join of log and points

undescribed-frame-moved = after a motion of the frame by { FIXED($motion_mm, 1) } mm, only { FIXED($left_mm, 3) } mm remain: base or measuring system has moved between calibration and validation poses

undescribed-unchecked = the calibration poses have no redundant coordinate, so other positions of base and targets agree equally well: measure more calibration poses, distributed over the workspace

undescribed-other-poses = the calibration poses agree, but no motion of the frame explains the other poses: check that log and exports of the validation poses belong together (possible causes: a log of another campaign, or another numbering of poses)

# Means: `--frames prior` is given for nominal parameters.
# Matters: In this mode, base and targets are fitted with weights from the covariance of the
# identified parameters. Nominal parameters have no covariance.
# Do: Add `--parameters` with identified parameters, or use `--frames refit`.
# Example: `etalon validate --frames prior` without `--parameters`
prior-of-nominal = nominal parameters have no covariance for `--frames prior`
    .hint = add identified parameters with `--parameters`, or use `--frames refit`

# Means: `--frames prior` is given, but the table does not contain positions only.
# Matters: This mode exists for measured positions only.
# Do: Remove rows of other kinds, or use `--frames refit`.
# Example: `--frames prior` with distances
prior-of-conditions = `--frames prior` is for measured positions only
    .hint = remove rows of other kinds, or use `--frames refit` to fit base and targets again

# Means: `--frames given` needs the nominal values of base and targets, but one of them is missing.
# Matters: The position is unknown.
# Do: Use `--frames refit` to fit base and targets to the calibration poses.
# Example: `--frames given` with nominal parameters of an arm
place-without-nominal = `{ $parameter }` has no nominal value: only measurements determine it
    .hint = use `--frames refit` to fit base and targets to the calibration poses

# Means: With the given parameters, the errors are larger than with nominal parameters.
# Matters: The parameters probably belong to another robot, or base and targets have moved since.
# Do: Check that the parameters belong to this robot. If base and targets have moved, use `--frames
# refit`.
# Example: parameters of the neighbouring robot
given-parameters-worse = errors with the given parameters are { FIXED($given_mm, 3) } mm, with nominal parameters { FIXED($nominal_mm, 3) } mm (root mean square)
    .hint = check that the parameters belong to this robot, and that base and targets have not moved (`--frames`)

# Means: The number of poses to choose is zero, or exceeds the number of candidates.
# Matters: A plan of this size is impossible.
# Do: Reduce `--positions`, or add candidates.
# Example: `--positions 20` of 12 candidates
candidate-poses-too-few = { $wanted } of { $count } candidate poses cannot be chosen
    .hint = reduce `--positions`, or add candidates

# Means: If the names of two targets are swapped, the residuals fall to less than a tenth.
# Matters: Each of the two targets was measured with the name of the other.
# Do: Swap the two names in the export.
# Example: SMR_1 and SMR_2 have each other's names
target-names-exchanged = with the names of targets `{ $first }` and `{ $second }` swapped, the residuals fall from { FIXED($before_mm, 3) } to { FIXED($left_mm, 3) } mm
    .hint = swap the two names in the export

# Means: The observations contradict the parameters; without one pose they agree.
# Matters: This pose was probably measured or logged wrongly.
# Do: Measure this pose again, and log its joint values again.
# Example: a verification pose with the joints of another pose
one-pose-contradicts = without pose `{ $pose }`, the observations do not contradict the parameters
    .hint = measure this pose again, and log its joint values again

# Means: The observations contradict the parameters; without one reading they agree.
# Matters: This reading is probably wrong, because the other targets of the pose agree with the
# joint values.
# Do: Measure this target at this pose again.
# Example: a reflector that was not seated at one pose
one-reading-contradicts = without target `{ $target }` at pose `{ $pose }`, the observations do not contradict the parameters
    .hint = measure this target at this pose again

# Means: With other names of the targets, the residuals fall to less than a tenth.
# Matters: Each target was measured with the name of another target.
# Do: Correct the names in the export.
# Example: SMR_1, SMR_2 and SMR_3 measured as SMR_2, SMR_3 and SMR_1
target-names-permuted = with the target names { $names }, the residuals fall from { FIXED($before_mm, 3) } to { FIXED($left_mm, 3) } mm
    .hint = correct the names in the export

# Means: Several motions explain the residuals of a verification: of the base, of the zero of a
# joint, or of a target.
# Matters: The data do not show which motion occurred.
# Do: Measure poses whose joint values differ more.
# Example: a verification at one pose
motions-alike = { $count ->
        [one] 1 other motion explains
       *[other] { $count } other motions explain
    } these residuals too: { $motions }
    .hint = measure poses whose joint values differ more

# Means: The identified position of a target is more than 10 mm, and more than its uncertainty, from
# the position that was given for it.
# Matters: The given position, or the link to which it belongs, is wrong: poses of the flange are
# then poses of another link. A wrong zero of the last joint looks the same.
# Do: Check the tool link of the URDF or the last row of the robot file, the given position and the
# zero of the last joint.
# Example: `tool_link = "flange"` with the position of a target at the link `tool`
target-far-from-given = the target `{ $target }` is identified at ({ FIXED($x_mm, 1) }, { FIXED($y_mm, 1) }, { FIXED($z_mm, 1) }) mm, { FIXED($distance_mm, 1) } mm from its given position ({ FIXED($sx_mm, 1) }, { FIXED($sy_mm, 1) }, { FIXED($sz_mm, 1) }) mm
    .hint = check the tool link or flange of the robot, the given position, and the zero of the last joint

# Means: The calibration poses do not have more coordinates than there are parameters.
# Matters: For any measurement the residuals are zero, so nothing checks the parameters.
# Do: Measure more poses, distributed over the workspace.
# Example: 12 parameters of a planar robot from three poses with two balls
no-coordinates-to-check = { $count ->
        [one] 1 coordinate
       *[other] { $count } coordinates
    } of the calibration poses for { $parameters ->
        [one] 1 parameter
       *[other] { $parameters } parameters
    }: nothing checks the parameters
    .hint = measure more poses, distributed over the workspace

# Means: A few errors at validation poses exceed a multiple of the median error.
# Matters: These readings are probably wrong, but they are part of the reported accuracy.
# Do: Check these readings for swapped labels and mistakes. Measure them again, or exclude them with
# `exclude` in [identify].
# Example: one validation pose with wrong joint values
validation-outliers = { $count } of { $total } validation errors exceed { FIXED($limit_mm, 4) } mm, { $times } times their median: { $readings }

# Means: All identified lengths differ from their nominal values by the same significant factor.
# Matters: A scale error of the measuring system or of the joints is more likely than the same error
# in so many parts.
# Do: Check scale, temperature compensation and unit of the measuring system and of the encoders.
# Example: an instrument without temperature compensation
common-scale = { $parameters } are all about { FIXED($factor, 5) } times nominal: a scale error of the measuring system or of the joints is more likely than errors of { $count } parts
    .hint = check scale, temperature compensation and unit of the measuring system and of the encoders

# Means: The identified compliance of a joint is negative, and its value is more than three standard
# uncertainties from zero.
# Matters: No joint bends against its load: the direction of gravity or of the joint axis is wrong.
# Do: Check `gravity` and the direction of the joint’s axis in robot.toml.
# Example: `gravity = [0, 0, 1]` for a robot on the floor
compliance-negative = `{ $parameter }` is negative ({ FIXED($value, 5) } { $unit }): the joint bends against gravity
    .hint = check `gravity` and the direction of the joint’s axis in robot.toml

# Means: The bending under the given loads contradicts the measurements. With one change of the
# given centre of mass, it agrees.
# Matters: The compliance is wrong, and errors under load remain.
# Do: Compare the columns of the load with the data sheet of the load: axes of the flange, signs, unit.
# Example: `load_x_mm` and `load_z_mm` swapped
load-columns-slip = the given centres of mass contradict the measurements ({ FIXED($over_u, 1) } standard uncertainties); { $count ->
        [one] they agree after one change: { $changes }
       *[other] they agree after each of these changes: { $changes }
    }
    .hint = compare the columns of the load with its data sheet: axes of the flange, signs, unit

load-change-exchanged = `{ $first }` and `{ $second }` are swapped

load-change-sign = `{ $column }` has the opposite sign

load-change-unit = the centre of mass is in { $unit }

# Means: The identified backlash of a joint is negative, and its value is more than three standard
# uncertainties from zero.
# Matters: A joint cannot move ahead of its drive. The directions of approach have the wrong sign,
# or belong to another motion.
# Do: Check the sign of the directions, and that the times of the log belong to the same motion.
# Example: direction -1, although the joint value increased
backlash-negative = `{ $parameter }` is negative ({ FIXED($value, 5) } { $unit }): the joint would move ahead of its drive
    .hint = check the sign of the directions of approach (+1 if the joint value increased, -1 if it decreased), and that the times of the log belong to the same motion

# Means: The torque of a joint has the same value in all calibration readings.
# Matters: A constant torque deflects the joint by a constant angle, which cannot be separated from
# the zero of the joint. The compliance of this joint cannot be determined and is held.
# Do: Nothing, if the joint carries no load, such as the vertical first axis of a robot on the
# floor. Otherwise measure other poses or other loads, or check the column.
# Example: `torque = [1, 2, 3]` for a robot on the floor, whose first axis carries no torque
torque-constant = the torque of joint `{ $joint }` is { FIXED($value, 3) } N·m in all calibration readings (`{ $column }`): it cannot be separated from the zero of the joint, and the compliance of this joint is held

# Means: Under torque, some joints have a positive compliance and others a negative one, each by
# more than three standard uncertainties.
# Matters: All joints yield in the same way: against the torques of the drives, or in the direction
# of the load. Different signs mean that some torques have the wrong sign, or belong to other
# joints.
# Do: Check the sign and the order of the columns of torques.
# Example: `tau3_nm` is the torque of the drive, `tau2_nm` the torque of the load
torque-signs-differ = identified bending under torque is positive for { $positive } and negative for { $negative }: some joints yield in the direction of the given torque, others against it
    .hint = check the sign and the order of the columns of torques

# Means: If the torques of two joints are swapped, the residuals agree with the uncertainty of the
# instrument. Without the swap, they do not.
# Matters: The torque of another joint does not describe the deflection of a joint.
# Do: Check which joint each column of torques belongs to.
# Example: the columns `tau2_nm` and `tau3_nm` are swapped
torques-exchanged = the model agrees with the readings if `{ $first }` and `{ $second }` are swapped, and not as given
    .hint = check which joint each column of torques belongs to

# Means: All calibration readings have the same temperature of the robot.
# Matters: The change of lengths and zeros with the temperature cannot be determined. The parameters
# apply at this temperature only.
# Do: Measure the robot both cold and warm, or remove `drift` and `expansion` from robot.toml.
# Example: 20.0 in each cell of `temperature_c`
temperature-constant = the temperature is { FIXED($value, 1) } °C in all calibration readings: expansion and drift cannot be determined and are held; lengths and zeros apply at this temperature

# Means: The temperatures of the robot are not usual for a workshop.
# Matters: If they are in another unit, expansion and drift are wrong, and lengths and zeros apply
# at another temperature. The values are used as they are.
# Do: Check the unit of the column `temperature_c`. If the robot works in a cold store, the values
# are right.
# Example: 68 to 86, in degrees Fahrenheit
temperature-questioned = the temperatures of the calibration readings are { FIXED($low, 1) } to { FIXED($high, 1) } °C, outside { $least } to { $most } °C

# Means: A payload of a reading is much heavier than arms of this reach carry.
# Matters: Compliances by masses in grams are a thousand times too small: under a payload in kilograms
# they correct nothing.
# Do: State masses in kg, and the unit of the column in the campaign.
# Example: a column `load_kg` with 3000 for 3 kg
load-questioned = payloads of up to { $high_kg } kg are too heavy for an arm that reaches { FIXED($reach_m, 2) } m
    .hint = check the unit of the column `load_kg`: read as grams it is { $in_grams_kg } kg

temperature-units = check the unit: read as °F they are { FIXED($from_fahrenheit, 1) } to { FIXED($to_fahrenheit, 1) } °C, read as K { FIXED($from_kelvin, 1) } to { FIXED($to_kelvin, 1) } °C

# Means: The identified distance between the balls K and L has the opposite sign of its nominal
# value.
# Matters: Each of the two balls was measured with the name of the other.
# Do: Swap the names of the two targets in the labels of the export.
# Example: K and L have each other's names
ball-names-exchanged = `{ $parameter }`, the distance of K and L, is { FIXED($value, 3) } { $unit }: K and L are swapped
    .hint = swap the names of the two targets in the labels of the export

# Means: On a set of poses, the identified robot has larger errors than the nominal robot.
# Matters: The parameters describe the noise of too few poses. They must not reach a controller.
# Do: Measure more poses, distributed over the workspace, or hold parameters that the poses do not
# determine.
# Example: 30 parameters identified from ten poses in one corner
identified-worse-than-nominal = on the { $set ->
        [validation] validation
       *[calibration] calibration
    } poses the identified robot is worse than the nominal one: { FIXED($before_mm, 4) } mm before, { FIXED($after_mm, 4) } mm after (root mean square)
    .hint = measure more poses, distributed over the workspace, or hold parameters that the poses do not determine

value-beyond-tolerance = `{ $parameter }` = { $unit ->
        [mm] { FIXED($value, 3) } { $unit } (nominal { $nominal } { $unit }, tolerance { FIXED($tolerance, 3) } { $unit })
        [deg] { FIXED($value, 3) } { $unit } (nominal { $nominal } { $unit }, tolerance { FIXED($tolerance, 3) } { $unit })
       *[other] { FIXED($value, 4) } (nominal { $nominal }, tolerance { FIXED($tolerance, 3) })
    }

# Means: According to the data, parameters exceed their tolerance by more than twice their standard
# uncertainty.
# Matters: No real robot differs so much from its drawing: a sign, unit, order of joints, nominal
# value or frame is wrong. The parameters must not reach a controller.
# Do: Check signs, units and order of the joints, the nominal values, and the frames. If the robot
# has larger tolerances, set `tolerance` in the robot file.
# Example: joint 2 logged with the opposite sign
tolerance-exceeded = { $count ->
        [one] 1 parameter is
       *[other] { $count } parameters are
    } beyond the tolerance of the robot: { $parameters }
    .hint = check signs, units and order of the joints, the nominal values, and the frames; if the robot has larger tolerances, set `tolerance` in the robot file

format-not-identified = the identification for format `{ $format }` failed: { $message }

# Means: The clocks run at different rates: with an offset alone, some points are outside the
# standstills. Offset and rate were computed together.
# Matters: Each point gets the joint values of its standstill. The rate is within 100 ppm, as for
# quartz clocks; the log of another run does not agree.
# Do: Nothing, if all points were measured during standstills. Next time, synchronise the clocks.
# Example: `clock_rate = "standstills"` for an instrument and a controller that recorded for an hour
clock-rate-from-standstills = the clock of the measurement runs { FIXED($rate_ppm, 1) } ppm ± { FIXED($u_ppm, 1) } ppm (k = 1) relative to the clock of log `{ $log }` (possible: { FIXED($low_ppm, 1) } to { FIXED($high_ppm, 1) } ppm); offset { FIXED($offset_s, 3) } s ± { FIXED($u_s, 3) } s (k = 1) at { FIXED($reference_s, 3) } s of the log
    .hint = with this offset and rate, every measured point is within a standstill; with an offset alone, some are not

# Means: With an offset alone, every measured point is within a standstill: the clocks may run at
# the same rate.
# Matters: The rate is not applied. The true rate is within the range in the message.
# Do: Omit `clock_rate`: only the offset is used.
# Example: clocks that differ by 5 ppm, and a measurement of ten minutes
clock-rate-insignificant = the standstills of log `{ $log }` show no significant difference of the clock rates: the difference is between { FIXED($low_ppm, 1) } and { FIXED($high_ppm, 1) } ppm
    .hint = omit `clock_rate`: only the offset is used

# Means: The offset of the clocks, and with `clock_rate` their rate, was computed from the speeds of
# a motion that the instrument and the controller recorded. The places of the targets on the robot
# are fitted together with the offset: robot.toml need not state them.
# Matters: Each point gets the joint values at its time. The uncertainty is computed from the
# differences of the speeds. A rate within two standard uncertainties of zero is not applied.
# Do: Nothing, if the correlation is near 1. Next time, start both recordings with one trigger.
# Example: `clock_offset_s = "motion"` for a tracker that follows a moving robot
clock-from-motion = the clock of log `{ $log }` is set from the speeds of the motion (correlation { FIXED($correlation, 3) }): offset { FIXED($offset_s, 4) } s ± { FIXED($u_s, 4) } s (k = 1) at { FIXED($reference_s, 3) } s of the log, rate { FIXED($rate_ppm, 1) } ppm ± { FIXED($u_ppm, 1) } ppm (k = 1)
    .hint = the points are joined with the rows of the log at these times

# Means: The measured speeds of the targets do not correlate with their speeds computed from the
# joint values.
# Matters: The clocks cannot be compared by this motion.
# Do: Check that log and export are of the same motion. Then check units, joints and targets.
# Example: the log of another run
clock-motion-unlike = the speeds of points and log do not correlate at any offset of the clocks: the largest correlation is { FIXED($correlation, 2) }
    .hint = check that log and points are of the same motion; for points measured only at standstills, set `clock_offset_s = "standstills"`, or a number

# Means: The motion repeats, so the speeds agree at several offsets of the clocks.
# Matters: Only one of these offsets is right.
# Do: Record a motion that does not repeat, or compare the two clocks once.
# Example: a robot that moves back and forth
clock-motion-several = the speeds of points and log agree at { $count } offsets of the clocks: { $ranges }
    .hint = record a motion that does not repeat, or set `clock_offset_s` as a number

# Means: The recording contains too few speeds to compare the clocks.
# Matters: The offset of the clocks is unknown.
# Do: Record points and joint values during a motion.
# Example: `clock_offset_s = "motion"` for ten points at standstill
clock-motion-short = { $count ->
        [one] 1 measured speed is
       *[other] { $count } measured speeds are
    } too few to compare the clocks by their motion
    .expected = at least 20 speeds, in the points and in the log

# Means: With no offset and rate of the clocks, every measured point is within a standstill.
# Matters: A point was measured in motion, a standstill is missing in the log, or the log is of
# another run. The rates of quartz clocks differ less than the limit in the message.
# Do: Check that the log belongs to the measurement, and remove points measured in motion.
# Example: the log of yesterday's run
clock-rate-none = with no offset of the clocks and no rate within ± { $most_ppm } ppm, every measured point is within a standstill of the log
    .hint = check that the log belongs to this measurement, and remove points measured in motion; or set `clock_offset_s` as a number
# Means: A limit is given, but its quantity was not measured at the poses to which the limit
# applies.
# Matters: The limit is undecided, and the exit code is 1.
# Do: Measure the quantity at the validation poses, or remove the limit.
# Example: `position_max_mm` for a campaign of draw wires
limit-not-assessable = limit `{ $limit }` cannot be assessed: its quantity was not measured at the poses to which it applies
    .hint = measure the quantity at these poses, or remove the limit from [limits]
# Means: An option contains a joint that has neither a sweep nor a column of values.
# Matters: The option has no effect, or the order of the joints is wrong.
# Do: Write the name of the joint as in the column `joint`.
# Example: `--prismatic Z` for a table with the joints q1 to q4
sweep-joint-unknown = `{ $joint }` is not a joint of these sweeps
    .expected = { $known }

# Means: The names of the joints contain no numbers, so their order from the base is unknown.
# Matters: With another order of the axes, the robot would be another robot.
# Do: Add the order of the joints, starting at the base.
# Example: sweeps of the axes X, Y, Z and C of a gantry
sweep-order-missing = the order of the joints { $joints } from the base is unknown
    .hint = add it: --joints NAME,...

# Means: Two columns contain values of the same joint.
# Matters: It is unknown which column is right.
# Do: Remove or rename one of the columns.
# Example: q1_deg and q1_rad in one table
sweep-joint-column-twice = two columns have values of joint `{ $joint }`
    .hint = remove one of them

# Means: Some joint values are missing: in a row, in some sweeps, or at a check pose.
# Matters: The program never guesses missing values.
# Do: Give the values of all joints in every row, or only at check poses.
# Example: an empty cell in the column q4_deg
sweep-values-partial = joint values are incomplete
    .expected = values of all joints in every row, or in no row of a sweep
    .hint = a row without a swept joint is a check pose, which needs the values of all joints

# Means: `--backwards` is given for a joint, but the table contains joint values.
# Matters: The joint values already give the direction of the sweep.
# Do: Omit `--backwards`.
# Example: `--backwards q2` with a column q2_deg
sweep-sign-by-values = the joint values already give the direction of each sweep
    .hint = omit --backwards

# Means: In the sweep of one joint, the values of another joint change.
# Matters: The axis is assigned to the wrong joint.
# Do: Correct the column `joint`, or the headings of the columns of joint values.
# Example: a sweep of q3 with the name q2
sweep-other-joint = `{ $moved }` moves in the sweep of `{ $joint }`, but `{ $joint }` does not
    .hint = correct the column `joint`, or the headings of the joint values

# Means: A second joint moves during the sweep of a joint.
# Matters: The paths are then neither circles nor lines, and the axis belongs to neither joint.
# Do: Measure the sweep again with all other joints at rest.
# Example: a sweep of joint 1 in which joint 2 turns by a tenth of the angle
sweep-two-joints = `{ $also }` also moves in the sweep of `{ $joint }`, by { $by }
    .hint = measure the sweep again with all other joints at rest

sweep-by-angle = { FIXED($by, 3) } deg

sweep-by-length = { FIXED($by, 3) } mm

# Means: The motion of the targets differs from the change of the joint value.
# Matters: The joint value has another unit, is a motor value, or another joint moves too. The zero
# of the joint is wrong.
# Do: Correct the unit in the heading. For a motor value, compute the column: `--column
# "q1_deg=motor1/100"`.
# Example: radians under the heading q1_deg
sweep-ratio = the targets move by { FIXED($ratio, 5) } × the values of `{ $joint }` (u = { SCIENTIFIC($u, 1) })
    .hint = { $unit ->
            [deg-as-rad] the values are degrees but are read as radians: correct the heading
            [rad-as-deg] the values are radians but are read as degrees: correct the heading
            [inch-as-mm] the values are inches but are read as millimetres
            [m-as-mm] the values are metres but are read as millimetres: correct the heading
            [mm-as-m] the values are millimetres but are read as metres: correct the heading
           *[none] correct the unit of the column, or compute the joint value from the motor value
        }

# Means: In a sweep, the readings of a target before and after a row are on two different paths
# about the same axis.
# Matters: The target moved in its seat, or the base or the instrument moved.
# Do: Measure the sweep again, or give the target another name from this row on.
# Example: a reflector that moves by 0.5 mm during the sweep
sweep-target-moved = target `{ $target }` moved in the sweep of `{ $joint }` before row { $row }: deviation from one path { FIXED($before_um, 1) } µm, from two paths { FIXED($after_um, 1) } µm
    .hint = measure the sweep again, or give the target another name from this row on

# Means: Many readings are far from the path through most readings.
# Matters: The path through most readings may be wrong.
# Do: Check whether a second joint moved, a reflector turned away, or rows belong to another sweep.
# Example: 5 of 24 readings are wrong by 0.7 mm
sweep-many-outliers = { $aside } of { $readings } readings of the sweep of `{ $joint }` are not on the path of the others
    .hint = check whether a second joint moved, or whether rows belong to another sweep

# Means: Some readings are outliers: much farther from the path than noise can explain.
# Matters: The axis is computed without these readings.
# Do: Look at these rows. Remove them if you know the cause.
# Example: a reading of another reflector
sweep-outliers = { $count ->
        [one] 1 reading of the sweep of `{ $joint }` is excluded: line { $lines }
       *[other] { $count } readings of the sweep of `{ $joint }` are excluded: lines { $lines }
    }
    .hint = look at these lines: the readings are far from the path of all others

# Means: Readings deviate smoothly from their path: the deviation is much larger than the difference
# between neighbouring readings, so it is not noise.
# Matters: Possible causes are run-out of the bearing, an error of the gear, motion of another
# joint, or bending of a part. The uncertainty of the axis includes these deviations as harmonics of
# one turn.
# Do: Check that all other joints were at rest, and compare the deviations with the run-out of the
# bearing.
# Example: a wobble of 0.15 mm with nine periods per turn
sweep-smooth = the targets deviate smoothly from their path in the sweep of `{ $joint }`, by { FIXED($rms_um, 1) } µm (root mean square); the noise from reading to reading is { FIXED($noise_um, 1) } µm; the uncertainty of the axis includes both
    .hint = check that all other joints were at rest, and compare with the run-out of the bearing

# Means: The direction of an axis has a large uncertainty.
# Matters: Predicted positions have an error of this angle times their distance from the axis.
# Do: Measure a longer arc, a target farther from the axis, or more targets.
# Example: an arc of 7 degrees
sweep-weak = the direction of the axis of `{ $joint }` has a standard uncertainty of { FIXED($u_mrad, 2) } mrad
    .hint = measure a longer arc, a target farther from the axis, or more targets

# Means: All targets are within a few millimetres of all axes.
# Matters: The coordinates are probably in metres, but are read as millimetres. The exit code is 1,
# and robot.toml is not written.
# Do: Check the unit of the coordinates, and convert all three columns. If the mechanism is really
# so small, use `--force`.
# Example: coordinates in metres under the heading x_mm
sweep-unit = all targets are within { FIXED($radius_mm, 3) } mm of the axes: the coordinates are probably in metres
    .hint = check the unit, and convert the columns, for example x: --column 'x_mm={ $source }*1000'

# Means: A sweep has fewer readings than its axis and paths need.
# Matters: The axis cannot be determined.
# Do: Measure more readings in this sweep; readings in excess of the minimum determine the
# uncertainty.
# Example: two readings of one target
sweep-few = the sweep of `{ $joint }` has { $readings } readings, and needs { $needed }
    .hint = measure more readings; redundant readings determine the uncertainty

# Means: The readings of a sweep do not determine an axis. They are at one position, or readings of
# a revolute joint are on a straight line.
# Matters: The axis is unknown.
# Do: Measure a longer arc, or a target farther from the axis. If the joint is prismatic, add
# `--prismatic`.
# Example: a target on the axis
sweep-undetermined = the readings of the sweep of `{ $joint }` do not determine an axis
    .hint = measure a longer arc or a target farther from the axis; for a prismatic joint, add --prismatic

# Means: Some joints have columns of values, but no sweep.
# Matters: The axes of these joints are unknown, so robot.toml is not written.
# Do: Measure a sweep of each joint.
# Example: sweeps of q1 to q3, and a column of values of q4
sweep-joint-missing = { $count ->
        [one] joint { $joints } has no sweep
       *[other] joints { $joints } have no sweep
    }: robot.toml is not written
    .hint = measure a sweep of each joint

# Means: The first readings of a target differ between sweeps. Without joint values, all sweeps must
# start from the same pose.
# Matters: The zeros of the joints are undefined, so robot.toml is not written. Each axis applies to
# the pose in which it was measured.
# Do: Start every sweep from the same pose, or add the joint values.
# Example: a target that was removed between two sweeps
sweep-starts-apart = the sweeps of `{ $first }` and `{ $second }` start { FIXED($gap_mm, 3) } mm apart at target `{ $target }`: robot.toml is not written
    .hint = start every sweep from the same pose, with the target at its place, or add columns of joint values

# Means: A target is measured at check poses, but in no sweep.
# Matters: Its position on the flange is unknown, so robot.toml is not written.
# Do: At check poses, measure targets that are also in the sweeps.
# Example: a check pose with another reflector
sweep-target-unswept = a target of check poses is in no sweep: robot.toml is not written
    .hint = at check poses, measure targets that are also in the sweeps

# Means: The sweeps or check poses agree only if two joints are swapped.
# Matters: The robot is wrong at every pose.
# Do: Swap the names of the two joints, in the column `joint` and in the headings.
# Example: axes 4 and 5 of an arm have each other's names
sweeps-exchanged = `{ $first }` and `{ $second }` are swapped: positions differ by { FIXED($stated_mm, 3) } mm (root mean square) as given, and by { FIXED($left_mm, 3) } mm with the joints swapped
    .hint = swap their names in the column `joint` and in the headings

# Means: The check poses agree only if the sweep of a joint went in the negative direction.
# Matters: The sign of the joint is wrong.
# Do: Add the joint to `--backwards`.
# Example: a sweep from +30 to -30 degrees without joint values
sweep-reversed = the sweep of `{ $joint }` went in the negative direction: check poses differ by { FIXED($stated_mm, 3) } mm (root mean square) as given, and by { FIXED($left_mm, 3) } mm with the opposite sign
    .hint = add --backwards { $joint }

# Means: Measured positions differ from the positions of the robot by more than their uncertainty.
# Matters: Possible causes are a target that moved between sweeps, bending of a joint, or errors of
# a transmission. The uncertainty of the robot is too small.
# Do: Check the seats of the targets and the joint values. Then use this robot as the start of a
# calibration (`etalon identify`, `etalon run`).
# Example: a target that was moved by 1 mm between two sweeps
sweeps-disagree = { $what ->
        [checks] check poses differ from the robot by up to { FIXED($distance_mm, 3) } mm
       *[sweeps] the sweeps contradict each other by up to { FIXED($distance_mm, 3) } mm
    } (standard uncertainty { FIXED($u_mm, 4) } mm)
    .hint = check the seats of the targets and the joint values; `etalon identify` and `etalon run` can start from this robot

# Means: The parameters of a Denavit-Hartenberg table cannot describe this position of the base.
# Matters: The base of the table is rotated and shifted relative to the base that you chose.
# Do: Identify the base in a calibration, or use `poe`.
# Example: a base whose x axis is not the common normal of its z axis and axis 1
table-base-not-held = the table has another base, rotated by { FIXED($angle_deg, 4) } deg and shifted by { FIXED($shift_mm, 4) } mm
    .hint = identify the base, or use `poe`

# Means: The parameters of a Denavit-Hartenberg table cannot describe this position of the flange.
# Matters: The flange of the table, with its targets and tools, is rotated and shifted relative to
# the flange that you chose.
# Do: Identify the targets in a calibration, or use `poe`.
# Example: a flange whose z axis is not the last axis
table-flange-not-held = the table has another flange, rotated by { FIXED($angle_deg, 4) } deg and shifted by { FIXED($shift_mm, 4) } mm
    .hint = identify the targets, or use `poe`

# Means: Two axes are nearly parallel. The nominal table has no parameter for one component of the
# angle between them: Hayati's beta is identified, not given.
# Matters: The error of a point is this angle times its distance from the axis.
# Do: Identify the robot, which determines beta, or use `poe`.
# Example: axes 2 and 3 of an arm, parallel within 0.2 mrad
table-tilt-not-held = the table treats { $joint ->
        [none] two axes
       *[other] the axes at the link of `{ $joint }`
    } as parallel: it does not contain the angle of { FIXED($angle_mrad, 4) } mrad between them
    .hint = `etalon identify` determines beta; `poe` contains the angle
row-excluded = excluded: { $reason }
row-at-origin = not measured: 0 0 0
row-of-station-unused = station `{ $station }`: the robot has no target with this name
row-of-several = { $rows } rows of log `{ $log }` are within { $tolerance_s } s: the nearest row is used
no-rows-around = in log `{ $log }`, a row before or after the point is missing within { $tolerance_s } s
no-row-near = no row of log `{ $log }` is within { $tolerance_s } s
no-point-nearest = another row is nearer to each measured point
no-row-of-key = no row of log `{ $log }` has this key
no-point-of-key = no measured point has this key
label-names-nothing = its label belongs to no target and to no point of a feature or frame
no-row-touches = no row of log `{ $log }` touches the point
row-of-unframed-pose = the pose of the row has no world frame

table-of-observations = observations
table-of-attained-poses = attained poses
table-of-commanded-poses = commanded poses
table-of-reference-targets = reference targets
table-of-commanded-path = commanded path
table-of-compliance = static compliance
recorded-motion-file = recorded motion
read-in-unit = { $format }, unit { $unit }
read-in-frame = { $read }, relative to `{ $frame }`
read-without-columns = { $read }, { $unread } of { $all } columns not read
read-except-columns = { $read }, not read: { $columns }

side-stated = as given by the user
side-from-values = from the { $values } { $of }
side-from-key = from `InternalExternal`: { $value }
# Means: An export joined by label contains orientations, and several rows of the log contain the
# same label.
# Matters: The robot touched this point several times, but the point was measured once. The measured
# orientation is not the orientation of the body on the robot, so only positions are used.
# Do: Nothing. If the instrument measured the body on the robot at each pose, join by pose, row or
# time.
# Example: nests of a plate, measured with a 6-DOF probe
label-orientations-unused = orientations of the export are not used: log `{ $log }` contains `{ $label }` in { $count } rows
    .hint = if the instrument measured the body on the robot at each pose, join by pose, row or time

# Means: The temperatures in the rows of the exports differ from `temperature_c` of the campaign.
# Matters: Identified lengths apply at `temperature_c`. A robot of aluminium expands by 23 µm/m for
# each degree.
# Do: Correct `temperature_c`, or convert the column to degrees Celsius.
# Example: `temperature_c = 20.0`, and rows with 24.6 to 25.3
temperature-elsewhere = `temperature_c` = { $stated_c }, but the rows of the exports contain { FIXED($lowest_c, 1) } °C to { FIXED($highest_c, 1) } °C
    .hint = correct `temperature_c`, or convert the column to degrees Celsius

# Means: `load_kg` of [conditions] differs from loads in the rows of the readings.
# Matters: The report prints both. A reader takes the single load for the load of all readings.
# Do: Remove `load_kg`, because the readings give their loads; or correct the column of the loads.
# Example: `load_kg = 1.0`, and rows with 0, 1.5 and 3 kg
load-elsewhere = `load_kg` = { $stated_kg }, but the readings contain loads of { $lowest_kg } kg to { $highest_kg } kg
    .hint = remove `load_kg` from [conditions], or correct the loads of the readings

# Means: The temperatures in the rows of the exports vary by more than [expansion] allows.
# Matters: The uncertainty of lengths due to temperature is too small, because rows are not
# corrected for temperature.
# Do: Increase `expanded_temperature_uncertainty_c` until it includes the whole range.
# Example: `expanded_temperature_uncertainty_c = 0.5`, and rows with 19.1 to 22.8
temperature-varies = the rows of the exports contain { FIXED($lowest_c, 1) } °C to { FIXED($highest_c, 1) } °C, more than ±{ $expanded_c } °C; the uncertainty of lengths is too small
    .hint = set an `expanded_temperature_uncertainty_c` that includes the whole range
axes-comment-method = axes from sweeps of one joint at a time (etalon axes); no nominal model

axes-comment-base = base from axes 1 and 2, rule `{ $rule }`: z along axis 1

axes-comment-joint = q{ $number } is { $name }

axes-comment-zero = joint values are zero at the start of the sweeps

axes-comment-target = target { $name } on the flange (mm): { FIXED($x, 4) } { FIXED($y, 4) } { FIXED($z, 4) }
axes-comment-tolerance = the sweeps determine these parameters: tolerances are half-widths of rectangular distributions

axes-robot-name = Robot from its axes

# Means: The table has fewer readings than the task needs.
# Matters: The answer is not unique.
# Do: Measure more readings; readings in excess of the minimum determine the uncertainty.
# Example: a tool centre point from two orientations
cell-few = `{ $solve }` needs { $needed } readings; there are { $readings }
    .hint = measure more readings; redundant readings determine the uncertainty

# Means: All readings of a target belong to one value of the axis.
# Matters: Without motion, the readings determine neither the direction nor the ratio of the axis.
# Do: Move the axis over its range, and measure the target at several values.
# Example: nine readings at 500 mm
cell-axis-at-rest = the axis does not move: all readings of each target ({ $readings } in total) are at one value of the axis
    .hint = measure the targets at several values of the axis

# Means: The robot has the same orientation in all rows.
# Matters: The tool moves together with the flange, so the readings do not depend on its position.
# Do: Rotate the robot between the readings, about at least two axes.
# Example: a tool centre point from poses with one orientation
cell-same-orientation = the robot has the same orientation in all rows
    .hint = rotate the robot between the readings, about at least two axes

# Means: All orientations of the robot differ by rotations about a single axis.
# Matters: A shift of the tool along this axis changes no reading, so the position along it is
# unknown.
# Do: Add readings with rotations about another axis.
# Example: a tool centre point from rotations of the last joint alone
cell-one-axis = all orientations differ by rotations about one axis, [{ $direction }] in the flange: the position along it is not determined
    .hint = add readings with rotations about another axis

# Means: All points of the table are at one position.
# Matters: The points determine no direction.
# Do: Measure points that are farther apart. For different orientations about one fixed point, use
# `--solve tool-point`.
# Example: a reflector that stays at one position while the robot rotates
cell-points-coincide = all points are at one position
    .hint = measure points that are farther apart; for different orientations about one fixed point, use `--solve tool-point`

# Means: All points are on one line.
# Matters: The rotation about this line is unknown.
# Do: Measure a point away from the line.
# Example: three corners along one edge of a fixture
cell-points-collinear = all points are collinear in the direction [{ $direction }]: the rotation about this line is not determined
    .hint = measure a point away from the line

# Means: Two different frames agree equally well with the readings.
# Matters: The readings do not show which of the two is right.
# Do: Add readings with orientations that differ by 30 deg or more.
# Example: four readings of a reflector with little rotation
cell-ambiguous = two different frames agree equally well with the readings
    .hint = add readings with other orientations

# Means: The readings do not determine all unknown quantities.
# Matters: The answer is unknown.
# Do: Add readings at other poses, or at other values of the axis.
# Example: an external axis whose target was measured at one value
cell-undetermined = the readings do not determine all unknown quantities
    .hint = add readings at other poses, or at other values of the axis

# Means: The poses have no columns of an orientation.
# Matters: A pose needs a position and an orientation.
# Do: Add the columns. If they have other headings, use `--column flange_qw=...`.
# Example: a table of `flange_x_mm`, `flange_y_mm`, `flange_z_mm` alone
cell-orientation-missing = the poses have no columns of an orientation
    .expected = { $prefix }qw, { $prefix }qx, { $prefix }qy, { $prefix }qz, or { $prefix }rx_deg .. of a rotation vector, or { $prefix }a_deg .. of three angles, or { $prefix }r11 .. { $prefix }r33
    .hint = add the columns; if they have other headings, use `--column { $prefix }qw=HEADING`

# Means: Orientations are given as three angles, but the order of the rotations is missing.
# Matters: The orientation depends on the order of the rotations.
# Do: Look up the order in the manual of the controller: KUKA A B C "zyx", FANUC W P R and Yaskawa
# "fixed xyz".
# Example: `flange_a_deg, flange_b_deg, flange_c_deg` without `--orientation`
cell-order-missing = the order of the angles { $prefix }a, { $prefix }b, { $prefix }c is not given
    .hint = add the order from the manual: `{ $option } zyx` for A B C of KUKA, `{ $option } "fixed xyz"` for W P R of FANUC

# Means: For a hand-eye calibration, the program must know whether the instrument or the target is
# on the robot.
# Matters: An instrument on the robot measures the inverse of what a stationary instrument measures.
# Do: If the instrument is stationary, add `--mounting target`. If it is on the robot, add
# `--mounting sensor`.
# Example: a camera on the flange that observes a stationary board
cell-mounting-missing = it is unknown whether the instrument or the target is on the robot
    .hint = add `--mounting target` (the instrument is stationary) or `--mounting sensor` (the instrument is on the robot)

# Means: A standard uncertainty in the table is zero, negative or missing.
# Matters: The weight of the row is undefined.
# Do: Correct the cell, or remove the column if you do not know the uncertainty.
# Example: an empty `uz_mm`
cell-uncertainty-not-positive = a standard uncertainty is missing or not positive

# Means: The column `point` contains an unknown name.
# Matters: The meaning of this point is unknown.
# Do: Use the names of points in the message.
# Example: `origo` for `origin`
cell-point-unknown = `{ $name }` is not a point of this task
    .expected = { $known }

# Means: One table contains points of two methods: origin, x, xy, and x1, x2, y1.
# Matters: The two methods give different origins of the frame.
# Do: Use only the points of one method.
# Example: `origin`, `x2`, `y1`
cell-roles-mixed = the table contains points of two methods
    .expected = origin, x, xy, or x1, x2, y1

# Means: The values of the external axis are missing in the table.
# Matters: The direction and the scale of the axis depend on these values.
# Do: Add the column with the values of the axis.
# Example: a heading `E1` of the controller
cell-axis-missing = the values of the axis are missing in the table
    .hint = add the column: `--column { $column }=HEADING`

# Means: The controller has no data for this kind of answer.
# Matters: No file is written for the controller.
# Do: Use the numbers in the text or in `--json`, or choose another format. docs/cell.md lists what
# each format contains.
# Example: `--solve linear-axis --controller kuka`
cell-no-controller-data = `{ $maker }` has no data for the answer of `{ $solve }`
    .hint = use the numbers in the text or in `--json`, or choose another format

# Means: These kinematics have two rotary axes, but the answer contains only one.
# Matters: The position of one axis does not determine the position of the other.
# Do: Measure the other axis, write its answer to a file with `--json`, and add this file with
# `--with`.
# Example: `--controller xyzac-trt-kins` with only the axis A
cell-second-axis-missing = `{ $maker }` needs two rotary axes: one along { $axis } of the machine, one along z
    .hint = add the answer of the other axis with `--with FILE` (JSON of `etalon cell --solve rotary-axis`)

# Means: A measured rotary axis is not parallel to the axis of the machine that these kinematics
# have.
# Matters: The machine has other kinematics, or the points are in another frame.
# Do: Measure in the coordinates of the machine, and choose the kinematics of the machine.
# Example: an axis B for `xyzac-trt-kins`
cell-axis-direction = the angle between a rotary axis and the axis { $axis } of the machine is { FIXED($angle_deg, 2) } deg, but `{ $maker }` rotates about this axis
    .hint = measure in the coordinates of the machine, or choose the kinematics of the machine

# Means: The rotary axes turn in a direction that these kinematics do not have.
# Matters: The tool and the part move apart.
# Do: Reverse the sign of the axis in the configuration of the machine, and measure again.
# Example: an axis A with positive direction and an axis C with negative direction for
# `xyzac-trt-kins`
cell-axis-sense = { $sense ->
        [opposite] the axis along { $axis } and the axis along z turn in opposite directions; in `{ $maker }` both have the same direction
        [positive] the axis turns about positive { $axis }; `{ $maker }` turns about negative { $axis }
       *[negative] the axes turn about negative { $axis } and z; `{ $maker }` turns about the positive axes
    }
    .hint = reverse the sign of the axis in the configuration of the machine, and measure again

# Means: The pivot length is the distance from the tilting axis to the gauge line, but the measured
# target is at the end of a tool.
# Matters: The measured distance includes the length of this tool.
# Do: Add the length of the tool. For a target at the gauge line, use 0.
# Example: `--controller maxkins` without `--tool-length-mm`
cell-tool-length-missing = `{ $maker }` needs the length of the tool that carries the first target
    .hint = add `--tool-length-mm`; for a target at the gauge line, use 0

# Means: The tool is longer than the distance from the pivot to the end of the tool.
# Matters: The pivot is below the gauge line of the spindle.
# Do: Check the length of the tool. Check that the first target is below the pivot at B = 0.
# Example: `--tool-length-mm 900` with a target 250 mm below the axis
cell-pivot-above = the tool ({ FIXED($tool_mm, 3) } mm) is longer than the distance from the axis down to the first target ({ FIXED($along_mm, 3) } mm, with the axis at zero)
    .hint = check the length of the tool, and that z of the machine points up the spindle

# Means: Number 1 is the robot itself; external kinematics have the numbers 2 to 7.
# Matters: The file overwrites the definition of the robot.
# Do: Use the number of the external kinematics in the controller.
# Example: `--solve rotary-axis --controller kuka --number 1`
cell-machine-number = `MACHINE_DEF[{ $number }]` is not an external kinematic system
    .expected = 2 to 7
    .hint = set `--number` to the number of the external kinematics

# Means: The entry of the tool file contains lines for load data, but etalon does not identify load
# data.
# Matters: If you load the file as it is, mass and centre of gravity become zero.
# Do: Copy the line of the frame into your own file, or complete the lines of the load.
# Example: `--controller yaskawa`
cell-loads-replaced = the entry of tool { $number } contains zero mass and zero centre of gravity: load data are not identified
    .hint = copy the line of the frame into your own file, or complete the lines of the load

# Means: A rotary axis is tilted against the axis of the machine, but these kinematics cannot
# describe a tilt.
# Matters: The error of a point is proportional to its distance from the axis.
# Do: Align the axis, or accept the error in the message.
# Example: an axis C that leans by 0.05 deg
cell-axis-tilted = the axis along { $axis } is tilted by { FIXED($angle_deg, 4) } deg, but `{ $maker }` cannot describe a tilt: the error is { FIXED($left_um, 1) } µm at 100 mm from the axis
    .hint = align the axis, or accept this error

# Means: This task does not use some columns that `--column` gives.
# Matters: Measured values may be in a column with a wrong name.
# Do: Use the columns of this task: `etalon cell --help` lists them.
# Example: `--column x_mm=X` instead of `--column flange_x_mm=X` with `tool-point`
cell-columns-unused = { $count ->
        [one] the given column { $columns } is
       *[other] the given columns { $columns } are
    } not used by `{ $solve }`
    .hint = `etalon cell --help` lists the columns of each task

# Means: The readings contradict each other; after a change of the input they agree.
# Matters: The frame is wrong.
# Do: Check the change on the robot, and correct the table or the options. If the message lists
# several changes, the readings do not show which one is right.
# Example: angles of KUKA (zyx) read in the order xyz
cell-slip = readings contradict each other by { FIXED($stated_mm, 3) } mm (standard deviation); { $count ->
        [one] after one change, { FIXED($left_mm, 4) } mm remain: { $changes }
       *[other] after each of these changes, { FIXED($left_mm, 4) } mm or slightly more remain: { $changes }
    }
    .hint = correct the table or the options

# Means: The residuals of positions are too large. The limit is the given uncertainty plus 2 mm for
# the robot, or a tenth of the size of tool and motion.
# Matters: The readings do not come from one rigid cell, so frames and uncertainties are wrong. The
# exit code is 1, and no controller data are written.
# Do: Check columns, signs, units and the order of the rows, and measure again. If the uncertainty
# is really larger than 2 mm, give it.
# Example: the columns of two robots are swapped
cell-refuted = positions have residuals of { FIXED($found_mm, 3) } mm (standard deviation), more than any plausible uncertainty: the answer is rejected
    .hint = check columns, signs, units and the order of the rows

# Means: The residuals of orientations are too large. The limit is the given uncertainty plus 2 deg
# for the robot, or a tenth of the rotations between poses.
# Matters: The readings do not come from one rigid cell, so frames and uncertainties are wrong. The
# exit code is 1, and no controller data are written.
# Do: Check columns, signs, units and the order of the rows, and measure again. If the uncertainty
# is really larger than 2 deg, give it.
# Example: measured poses in the order of another recording
cell-refuted-turned = orientations have residuals of { FIXED($found_deg, 2) } deg (standard deviation), more than any plausible uncertainty: the answer is rejected
    .hint = check columns, signs, units and the order of the rows

# Means: The answer has errors, so no controller data are written.
# Matters: With these data, the robot could move with a wrong tool or frame.
# Do: Remove the causes of the errors. With `--force`, the data are written, and their header
# contains a warning.
# Example: `--controller kuka` of a table with an outlier
cell-data-withheld = controller data for { $maker } are not written: the answer must not be loaded
    .hint = remove the causes of the errors; `--force` writes the data

# Means: A reading is an outlier: noise alone causes such a residual in fewer than one of a thousand
# tables.
# Matters: The reading shifts the result. The exit code is 1, and no controller data are written.
# The uncertainties are larger, because they include this residual.
# Do: Check the reading. If it is wrong, exclude it with `--without`.
# Example: the tip touched a place next to the fixed point once
cell-outlier = the reading of line { $line } contradicts the others: residual { FIXED($residual_mm, 4) } mm
    .hint = check the reading; if it is wrong, exclude it with `--without`

# Means: An orientation is an outlier: noise alone causes such a residual in fewer than one of a
# thousand tables.
# Matters: The reading shifts the result. The exit code is 1, and no controller data are written.
# Do: Check the reading. If it is wrong, exclude it with `--without`.
# Example: one pose of a camera with swapped corners
cell-outlier-turned = the orientation of line { $line } contradicts the others: residual { FIXED($residual_deg, 4) } deg
    .hint = check the reading; if it is wrong, exclude it with `--without`

# Means: The residuals of positions are larger than the given uncertainty explains.
# Matters: The uncertainties of the result are computed from the residuals.
# Do: Check the given uncertainty: it must include the robot and the measurement.
# Example: the uncertainty of the tracker alone
cell-noise-larger = positions have residuals of { FIXED($found_um, 1) } µm (standard deviation), more than the given uncertainty explains; uncertainties are computed from the residuals
    .hint = give the uncertainty of robot and measurement together

# Means: The residuals of orientations are larger than the given uncertainty explains.
# Matters: The uncertainties of the result are computed from the residuals.
# Do: Check the given uncertainty: it must include the robot and the measurement.
# Example: the uncertainty of the tracker alone
cell-noise-larger-turned = orientations have residuals of { FIXED($found_deg, 4) } deg (standard deviation), more than the given uncertainty explains; uncertainties are computed from the residuals
    .hint = give the uncertainty of robot and measurement together

# Means: The readings have no redundancy, and no uncertainty is given.
# Matters: The uncertainty of the result is unknown.
# Do: Measure more readings, or add `--standard-uncertainty-um`.
# Example: a work object from three points, each measured once
cell-no-uncertainty = the uncertainty is unknown: the readings have no redundancy, and no uncertainty is given
    .hint = measure more readings, or add `--standard-uncertainty-um`

# Means: All positions of the flange are within a few millimetres of the base of the robot.
# Matters: If coordinates in metres are read as millimetres, the tool is a thousand times too small.
# Do: If the positions are in metres, use `flange_x_m`, `flange_y_m`, `flange_z_m`.
# Example: poses of a ROS topic in metres, read as `flange_x_mm`
cell-unit = all positions of the flange are within { FIXED($distance_mm, 3) } mm of the base, and the tool is shorter than 2 mm: positions are probably in metres
    .hint = for metres, use `flange_x_m`, `flange_y_m`, `flange_z_m`

# Means: The poses are far outside the reach of any robot, and the tool is too long for any robot.
# Matters: If coordinates in millimetres are read as metres, the tool is a thousand times too long.
# Do: If the positions are in millimetres, use `flange_x_mm`, `flange_y_mm`, `flange_z_mm`.
# Example: poses of a KUKA in millimetres, read as `flange_x_m`
cell-unit-large = the flange is { FIXED($distance_m, 1) } m from the base, and the tool is { FIXED($tool_m, 1) } m long: positions are probably in millimetres
    .hint = for millimetres, use `flange_x_mm`, `flange_y_mm`, `flange_z_mm`

# Means: Within its uncertainty, the tool centre point is at the origin of the poses.
# Matters: The poses probably belong to an active tool. The result is then a correction of this
# tool.
# Do: Export the poses with tool 0 (flange), or use the result as a correction of the active tool.
# Example: poses of ABB with `tool1` instead of `tool0`
cell-tool-active = the tool centre point is { FIXED($distance_mm, 4) } mm from the origin of the poses (u = { FIXED($u_mm, 4) } mm): they are probably poses of the tool, not of the flange
    .hint = export the poses with tool 0

# Means: The motion of the targets differs from the values of the axis.
# Matters: The values are probably in another unit, or the transmission ratio is wrong.
# Do: Check the unit of the column and the ratio of the axis.
# Example: values in degrees in the column `axis_rad`
cell-scale = the axis moves by { FIXED($scale, 5) } × its values (u = { SCIENTIFIC($u, 1) })
    .hint = check the unit of the column and the ratio of the axis

cell-change-orientations = { $what }, in the orientations { $side ->
        [flange] of the flange
       *[measured] of the measured poses
    }

cell-change-inverse = the poses { $side ->
        [flange] of the flange
       *[measured] that are measured
    } are inverse

cell-change-unit = the positions { $side ->
        [flange] of the flange
       *[measured] of the measured points
    } are in { $unit }

cell-change-axes = { $first } and { $second } of the positions { $side ->
        [flange] of the flange
       *[measured] of the measured poses
    } are swapped

cell-change-sign = { $axis } of the positions { $side ->
        [flange] of the flange
       *[measured] of the measured poses
    } has the opposite sign

cell-change-measured-mirrored = two coordinates of the measured points are swapped, or one has the opposite sign

cell-change-scale = the measured points are multiplied by { $factor }

cell-change-mirrored = the known points are mirrored (two coordinates are swapped, or one has the opposite sign)

cell-change-exchanged = the points of lines { $first } and { $second } are swapped

# Means: `field = true` requests a residual field, but none is used.
# Matters: Parameters and results do not include a field.
# Do: Read the reason in the message: measure more poses, correct the set-up, or omit `field`.
# Example: `field = true` in a campaign whose model already fits
field-refused = no residual field: { $reason }

# Means: The data agree equally well with a tilt of the base and with a tilt of the first joint
# across its axis.
# Matters: Predicted positions are the same, but the tilt may belong to the other part.
# Do: Treat the parameters as the common tilt of base and first joint. Dial indicators on the base
# show which part yields.
# Example: `pedestal = true` for an arm whose first joint yields equally in all directions
tilt-of-base-or-joint = { $stated ->
        [pedestal] the tilt of the base (`pedestal`) may be a tilt of joint `{ $joint }` across its axis (`lateral`)
       *[lateral] the tilt of joint `{ $joint }` across its axis (`lateral`) may be a tilt of the base (`pedestal`)
    }: chi-square is { FIXED($chi_square, 1) } with the first model and { FIXED($of_other, 1) } with the second
    .hint = treat the parameters as the common tilt of base and first joint

# Means: A residual field depends on a joint whose values increase or decrease in the order of the
# poses.
# Matters: A set-up that drifts during the measurement causes the same residuals. The field assigns
# this drift to the robot.
# Do: Measure the poses in another order, or test the field at poses of another day.
# Example: poses sorted by the first joint, while the tracker drifted
field-follows-order = the residual field depends on `{ $joint }`, whose values follow the order of the poses (rank correlation { FIXED($correlation, 2) }): a drift of the set-up causes the same residuals
    .hint = test the field with `etalon validate --field` at poses in another order

# Means: Some poses have joint values outside the range in which the residual field was measured.
# Matters: The field fades out there, so only the parameters reduce the errors.
# Do: Measure these regions in the calibration, or judge these poses separately.
# Example: a validation at joint values that no calibration pose reached
poses-beyond-field = { $count } of { $total } poses are outside the measured range of the residual field
    .hint = measure calibration poses in this region

field-parameters-wrong = the identification reports an error, which a field would hide

# Means: The expanded uncertainty (k = 2) of a component of the answer exceeds its bound. The bound
# is the given one (`--uncertainty-bound`, `uncertainty_bound` in campaign.toml), or the default.
# The default is ten times the uncertainty of a coordinate divided by the measured extent, at least
# 2 % and at most 5 % of the extent. For angles it is this share in radians, at least 0.5 %.
# Matters: The answer must not be loaded: the robot could move to another position. The uncertainty
# itself is correct.
# Do: Measure the readings in the hint, which determine this component. If the uncertainty is small
# enough for your task, give a larger bound: `--uncertainty-bound "5 mm, 2 deg"`.
# Example: `x` of three points touched only 0.03 mm from the origin
uncertainty-beyond-bound = { $component }: U = { $expanded }{ $unit ->
    [1] {""}
   *[other] {" "}{ $unit }
} (k = 2) exceeds { $source ->
    [stated] the given bound
   *[default] the bound
} { $bound }{ $unit ->
    [1] {""}
   *[other] {" "}{ $unit }
}{ $source ->
    [stated] {""}
   *[default] { " " }(by default, for a measured extent of { $extent_mm } mm)
}: { $cause }

# Means: The text is not a bound of uncertainties.
# Matters: The uncertainties cannot be compared with it.
# Do: Write a length, an angle, or both, each with its unit (`mm`, `um`, `deg`, `rad`): `0.5 mm, 0.1
# deg`.
# Example: `--uncertainty-bound 0.5`
uncertainty-bound-unreadable = `{ $text }` is not a bound of uncertainties: expected a length, an angle, or both with their units
    .hint = for example "0.5 mm, 0.1 deg"

bound-position = position { $axis } of `{ $name }`
bound-rotation = rotation of `{ $name }` about { $axis }
bound-direction = component { $axis } of the direction of the axis
bound-ratio = ratio of the axis
bound-axis-direction = direction of the axis of `{ $joint }`
bound-axis-point = position of the axis of `{ $joint }`
bound-parameter = { $parameter }
bound-open-rotation = the readings hardly depend on the rotation about the direction { $direction }
bound-open-translation = the readings hardly depend on the position along { $direction }
bound-open-combination = the readings hardly depend on the combination of { $names }
bound-open-alone = the readings hardly depend on it
bound-remedy = { $case ->
    [tool] touch the point with orientations that differ by 30 deg or more about two axes of the flange
    [poses] add poses whose orientations differ by 30 deg or more about two axes, over a larger region
    [points] measure points that are farther apart, and farther from the line through the others
    [travel] measure over a longer travel
    [turn] measure a target farther from the axis, and over a larger arc
    [base] measure over a larger region, and use points of the world frame that are farther apart and not on one line
    [region] calibrate with poses in the region of these targets
   *[robot] measure poses in which the effects of these parameters differ, or hold them
}; or give a larger bound

# Means: The gain of a revolute joint, or its zero, differs from nominal by much more than encoders
# and homing can explain. An encoder counts whole turns, so its gain is known. A zero of more than 1
# deg is rarely an error of the robot.
# Matters: The data cannot distinguish such a value from a mistake in the log. Such mistakes are a
# wrong scale, a coupled joint, or a joint that was mastered again after the log. With this value, a
# controller would move the joint to a wrong position.
# Do: Check the column of the joint in the log, its gear ratio and its mastering. If the value is
# real, correct robot.toml, or set a `tolerance` of the parameter there.
# Example: the log of a joint, multiplied by 1.01
encoder-implausible = { $count ->
    [one] a gain or zero of a revolute joint is
   *[other] { $count } gains or zeros of revolute joints are
} farther from nominal than encoders and homing explain: { $parameters }
    .hint = check the column of the joint in the log, its gear ratio and its mastering; if the value is real, set its `tolerance` in robot.toml

value-beyond-encoder = `{ $parameter }` = { FIXED($value, 5) }{ $unit ->
    [deg] {" "}deg
   *[other] {""}
} (nominal { FIXED($nominal, 5) }, off by { $times } u)

# Means: The smallest changes that the chosen poses detect with a probability of 95 % exceed their
# bound. The bound comes from `--uncertainty-bound`; by default it is a share of the extent of the
# candidates.
# Matters: With these poses, a robot that has moved by this much would still be accepted.
# Do: Choose more poses, add candidates in a larger region, or give a larger bound.
# Example: candidates within 0.1 deg of each other
changes-undetected = the chosen poses do not detect { $count ->
    [one] a change
   *[other] { $count } changes
} within the bound: { $changes }
    .hint = choose more poses (`--positions`), add candidates in a larger region, or give a larger bound

change-beyond-bound = { $name }: { $change } { $unit }, bound { $bound } { $unit }

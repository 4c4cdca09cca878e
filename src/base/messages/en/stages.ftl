### Messages of stages. Above each message: its explanation (see CONTRIBUTING.md, "A message").

rigid-distance-off = the distance { $first }-{ $second } is { FIXED($off_mm, 3) } mm { $side ->
        [shorter] shorter
       *[longer] longer
    } than its median (tolerance { $limit_mm } mm)

rigid-targets-exchanged = the distances fit if `{ $first }` and `{ $second }` are exchanged

# Means: The rule [[rigid]] refuses all rows of a target: their distances to the other targets differ
# from the median by more than `tolerance_mm`.
# Matters: The target has no position. The exports do contain it.
# Do: Correct the labels of exchanged targets, or `tolerance_mm`, or remove the target from [[rigid]].
# Example: two reflectors with each other's names at half of the poses
rigid-target-refused = [[rigid]] refuses { $rows ->
        [one] the only row
       *[other] all { $rows } rows
    } of `{ $target }`, the first in `{ $file }`, line { $line }: { $reason }
    .hint = correct exchanged labels or `tolerance_mm`, or remove the target from [[rigid]]

rigid-point-coincides = { $message }; the point coincides with `{ $other }`

# Means: A distance between targets of a rigid part differs from its median by more than
# `tolerance_mm` of [[rigid]].
# Matters: The row is left out and listed in import.json: a target was confused with another, moved,
# or measured badly.
# Do: Check the row; correct its label, or leave it refused.
# Example: a reflector measured under the name of its neighbour
rigid-row-refused = row { $row }: `{ $target }` is refused: { $reason }

# Means: `targets` of [[rigid]] names a single target, or one target twice.
# Matters: The rule compares distances between targets.
# Do: Name each target of the part once.
# Example: `targets = ["SMR_1"]`
rigid-targets = a rigid part needs two or more targets, each named once
    .hint = name each target of the part once in `targets`

# Means: A rule of [[rigid]] lists targets of several branches of the robot.
# Matters: Joints move these targets against each other, so that their distances vary.
# Do: Give one [[rigid]] for the targets of each branch.
# Example: `targets = ["L1", "R1"]` of a left and a right hand
rigid-across-branches = the rigid part { $targets } spans several branches of the robot
    .hint = give one [[rigid]] for the targets of each branch

# Means: `tolerance_mm` of [[rigid]] or `drift_mm` of [[fixed]] is zero, negative or not finite.
# Matters: With such a limit, either all rows or none would be refused.
# Do: Give the largest permitted deviation of a distance, or motion of a target.
# Example: `tolerance_mm = 0`
limit-not-positive = `{ $key }` must be a positive number
    .expected = { $key ->
            [drift_mm] the largest motion of a fixed target during the campaign, for example 0.02
           *[tolerance_mm] the largest deviation of a distance from its median, a multiple of the scatter, for example 0.1
        }

# Means: [[rigid]] gives an uncertainty or coverage factor of `places_mm` without `places_mm`.
# Matters: The statement has no effect.
# Do: Set `places_mm`, or remove the key.
# Example: `coverage_factor = 2` in a [[rigid]] without `places_mm`
rigid-uncertainty-without-places = `{ $key }` belongs to `places_mm`, which is missing
    .hint = set `places_mm`, or remove `{ $key }`

# Means: `places_mm` of [[rigid]] names a target that is missing in `targets` of the same part.
# Matters: The position would not be used.
# Do: Correct the name, or add the target to `targets`.
# Example: `places_mm = { SMR_9 = [0, 0, 0] }` with targets SMR_1 to SMR_3
rigid-place-unknown = `places_mm` names `{ $target }`, which is not a target of this rigid part

# Means: `places_mm` of [[rigid]] gives the positions of only some targets of the part.
# Matters: The shape of the part is used as a whole.
# Do: Add the position of the target.
# Example: `places_mm` of two of three targets
rigid-place-missing = `places_mm` lacks the position of `{ $target }`
    .hint = add its coordinates, or remove it from `targets`

# Means: `places_mm` of [[rigid]] is given without its uncertainty.
# Matters: The positions count as a measurement; its weight needs the uncertainty.
# Do: Set `expanded_uncertainty_um` and `coverage_factor` of the positions.
# Example: `places_mm` alone
rigid-places-need-uncertainty = `places_mm` needs `{ $key }`, a positive number
    .expected = the expanded uncertainty of one coordinate, and its coverage factor

# Means: A row of a target of [[rigid]] has neither pose nor time.
# Matters: It is unknown with which rows of the other targets it was measured.
# Do: Name the pose in `label` or `columns`, or remove the target from [[rigid]].
# Example: the label `SMR_1` read as `{target}`
rigid-row-without-pose = [[rigid]] names `{ $target }`, but this row has neither pose nor time
    .hint = name the pose in `label` or `columns`, or remove the target from [[rigid]]

# Means: Two rows of a target of [[rigid]] have the same time and do not give a pose.
# Matters: It is unknown which of them belongs to the rows of the other targets.
# Do: Name the pose in `label` or `columns`.
# Example: a target measured twice with the same time stamp
rigid-time-twice = [[rigid]] names `{ $target }`, but two of its rows have the same time
    .hint = the first is line { $first }; name the pose in `label` or `columns`

# Means: No two targets of [[rigid]] have rows of the same pose and cycle, or of the same time.
# Matters: The rule has no distance to compare.
# Do: Name the pose in `label` or `columns`; `pose = "row"` numbers rows of files with one target
# each.
# Example: targets of one part in two files without poses
rigid-never-together = { $targets } of [[rigid]] are never measured together
    .expected = rows with the same pose and cycle, or with the same time
    .hint = name the pose in `label` or `columns`; `pose = "row"` numbers rows of files with one target each

# Means: Two targets of [[rigid]] are measured together too few times for a median of their
# distance.
# Matters: No row is refused by this distance, so errors of these targets are not detected.
# Do: Measure the targets together at more poses, or remove one from [[rigid]].
# Example: two poses
rigid-few-distances = the distance `{ $first }`-`{ $second }` of [[rigid]] cannot reject a row: it was measured only { $count ->
        [one] once
       *[other] { $count } times
    }
    .expected = { $least } times or more

# Means: [[identify.exclude]] names neither poses nor rows, or both.
# Matters: It is undefined which readings are left out.
# Do: Set `poses`, optionally with `cycle` and `target`; or `file` and `rows`.
# Example: `rows = "3"` without `file`
exclusion-mixed = an exclusion names either poses or the rows of a file
    .expected = `poses`, optionally with `cycle` and `target`; or `file` and `rows`

# Means: `file` of [[identify.exclude]] is not an export of the campaign, or is an export without
# rows.
# Matters: Nothing would be left out.
# Do: Write the name of the file as in the [[export]].
# Example: `file = "pose.txt"` for the export `poses.txt`
exclusion-file-unknown = `{ $file }` is not an export with rows to exclude

of-name = `{ $name }`: { $message }

# Means: The coordinates of a row are those of another point: of the same pose, or far from the
# other rows of its name.
# Matters: The row is used as given. A wrong label falsifies every result that uses this point.
# Do: Correct the label, or exclude the row. [[rigid]] refuses rows whose distances to the other
# targets are wrong.
# Example: the reflector `base_3` measured while the instrument pointed at `SMR_3`
point-lies-at-another = row { $row }: `{ $point }` has the position of `{ $other }`{ $rows ->
        [one] {""}
       *[other] {""}; { $rows } such rows in all
    }
    .hint = if the instrument pointed at the other target or the label is wrong, correct the label or exclude the row; [[rigid]] refuses rows by their distances

# Means: A target of [[fixed]] has too few rows to compare parts of the recording.
# Matters: A motion of the target or the instrument is not detected.
# Do: Measure the target more often.
# Example: a fixed target measured before and after only
drift-few-readings = `{ $target }` is measured { $count ->
        [one] once
       *[other] { $count } times
    }: too few to detect a drift
    .expected = { $least } or more

# Means: The medians of two parts of the rows of a fixed target lie farther apart than `drift_mm` of
# [[fixed]].
# Matters: Target or instrument moved: points of different times are not in one frame.
# Do: Check the temperature and the mounting of the instrument. With `targets` and `each = "pose"`
# in [frame.world] the frame follows the targets.
# Example: an instrument that warms up
reference-drifts = `{ $target }` drifts: from rows { $first } to rows { $second } it moves { FIXED($moved_mm, 4) } mm; limit { $limit_mm } mm
    .hint = check temperature and mounting of the instrument; with `targets` and `each = "pose"` in [frame.world] the frame follows the targets

# Means: Exports give the working frame of their points, and the frames differ.
# Matters: Points of different frames do not describe one geometry.
# Do: Export all points in one working frame, or do not use them together.
# Example: one QIF file relative to `Base`, another relative to `Part`
frames-differ = the points are relative to the frame `{ $second }`; the points of another export are relative to `{ $first }`
    .hint = export them in one working frame, or do not use them together

# Means: No row of an export is a point.
# Matters: The export contributes no measurements; the file or its description is probably wrong.
# Do: Export the points again, or remove this [[export]].
# Example: a file that holds a header alone
export-empty = `{ $file }` holds no points
    .hint = export the points again, or remove this [[export]]; `etalon formats FILE` shows how a text is read

# Means: A target has a name that a spreadsheet would execute.
# Matters: Tables of results contain the names of targets.
# Do: Rename the target, or give a `label` without its first character.
# Example: `=ball`
target-formula = a spreadsheet would take the name `{ $target }` for a formula
    .hint = rename it, or give a `label` without its first character

# Means: A row names a target of the robot without a pose.
# Matters: A measured target needs the pose of the robot, that is, its joint values.
# Do: Name the pose in the label, or set `pose = "row"` for this export.
# Example: the label `SMR_1` read as `{target}`
target-without-pose = the row names a target but no pose
    .hint = name the pose in the label, or set `pose = "row"` for this export

# Means: Two rows have the same target, pose and cycle.
# Matters: It is unknown which of them is valid.
# Do: Give each repeat its own cycle number, or remove one row. Files whose rows are poses need
# different numbers.
# Example: two files with `pose = "row"`
target-twice = target `{ $target }` occurs twice at pose { $pose }, cycle { $cycle }
    .hint = the first is { $file }:{ $line }; { $numbered ->
            [by-row] set `pose = "row + 100"` for one of the files
           *[by-label] give each repeat its own cycle number, or remove one
        }

# Means: Labels name no target of the robot and are not used by a feature, frame or step of a
# procedure.
# Matters: These points are not used. A misspelt label loses its point in this way.
# Do: Correct the label, or `label` of this export.
# Example: `SMR1_3` where `label = "{target}_{pose}"` has the target `SMR_1`
labels-unused = { $count ->
        [one] 1 label names
       *[other] { $count } labels name
    } no target and { $count ->
        [one] is
       *[other] are
    } not used by a feature or frame; the first is `{ $label }`
    .hint = correct the label, or the pattern `label` of this export

column-step = { $column } to { $step } { $unit }

# Means: All values of a coordinate are multiples of a step whose rounding error is larger than the
# uncertainty of the instrument. A step has the standard uncertainty step/√12 (JCGM 100:2008,
# 4.3.7).
# Matters: The results are less accurate than the stated uncertainty of the instrument suggests.
# Do: Export the coordinates with more decimals.
# Example: coordinates with one decimal from a tracker with 15 µm
coordinates-rounded = coordinates of `{ $file }` are rounded ({ $columns }): standard uncertainty of the rounding { FIXED($rounding_um, 1) } µm, of the instrument { FIXED($instrument_um, 1) } µm
    .hint = export them with more decimals

# Means: One row of an export is exactly 0 0 0. Trackers write such rows for a lost target; a frame
# with its origin at a measured point has such a row too, and nothing else in the file shows it.
# Matters: The row is left out and listed in import.json.
# Do: If the point was measured, set `missing = [""]` in `format`.
# Example: coordinates relative to the first point: `1 0 0 0`, `2 12.503 -3.118 0.044`
origin-not-measured = line { $line } of `{ $file }` is 0 0 0: the row counts as not measured
    .hint = if it is a measured point at the origin of the frame, give a format with `missing = [""]`

# Means: No point has a label of the form that a step of a procedure gives.
# Matters: The step cannot be evaluated.
# Do: Correct the pattern, or add the export.
# Example: `label = "visit_{pose}_{cycle}"` where the labels begin with `pose`
labels-missing = no point has a label of the form `{ $pattern }`
    .hint = correct the pattern, or add the export

# Means: An exclusion on the command line gives no reason.
# Matters: Readers of the report must be able to judge why measurements are excluded.
# Do: Add the reason after a colon.
# Example: `--exclude 13`
exclusion-option-without-reason = { $option } { $text } gives no reason
    .expected = excluded poses or rows, and the reason: "13, 20-22: ball loose"

exclusion-poses = { $count ->
        [one] pose
       *[other] poses
    } { $poses }

exclusion-cycle = cycle { $cycle }

exclusion-target = target `{ $target }`

# Means: Readings were excluded as the campaign gives.
# Matters: Excluded readings do not take part in the result; the report repeats them.
# Do: Check the reason.
# Example: `exclude = [{ poses = "13", reason = "ball loose" }]`
excluded-readings = excluded: { $count ->
        [one] 1 reading
       *[other] { $count } readings
    }, { $of }: { $reason }

# Means: The exclusions exclude all readings.
# Matters: Parameters cannot be identified without readings.
# Do: Remove an exclusion.
# Example: `poses = "1-1000"` of 100 poses
exclusions-leave-nothing = all readings are excluded
    .hint = remove an exclusion

# Means: The text of an exclusion is not a list of poses or rows.
# Matters: No reading would be excluded.
# Do: Give names, numbers and ranges.
# Example: `poses = "rest"`
exclusion-names-nothing = `{ $stated }` names no { $of ->
        [rows] rows
       *[poses] poses
    } to exclude
    .expected = { $of ->
            [rows] numbers and ranges like "13, 20-22", counted from the first row of data
           *[poses] names and ranges like "13, 20-22, home"
        }

# Means: A row or statement names a joint or target that the robot lacks.
# Matters: It is unknown to which joint or target the row refers.
# Do: Correct the name.
# Example: `SMR_4` of a robot with the targets SMR_1 to SMR_3
not-of-this-robot = `{ $name }` is not a { $kind ->
        [joint] joint
       *[target] target
    } of this robot

# Means: `reason` of an exclusion is empty.
# Matters: Readers of the report must be able to judge why measurements are excluded.
# Do: Give the reason.
# Example: `reason = ""`
exclusion-without-reason = an exclusion needs a reason
    .hint = state in `reason` why the measurements are excluded

# Means: An exclusion names a pose or row that was not measured.
# Matters: The exclusion has no effect; the intended readings are still used.
# Do: Correct the pose, cycle, target or row.
# Example: `poses = "130"` of 100 poses
exclusion-matches-nothing = { $of ->
        [rows] there is no row { $name } to exclude
       *[poses] there is no reading at pose { $name } with this cycle and target to exclude
    }
    .hint = correct the exclusion, or remove it

# Means: No measured point has a row of the log within `tolerance_s`.
# Matters: No observations remain. Usually the clock offset is wrong.
# Do: Check value and sign of `clock_offset_s`: time of the measurement minus time of the log.
# Example: `clock_offset_s = 3600` where the log is one hour ahead
join-by-time-empty = no measured point has a partner in log `{ $log }`: the two nearest times are { FIXED($apart_s, 3) } s apart
    .hint = check value and sign of `clock_offset_s`: time of the measurement minus time of the log

both-rows-near = a point between two rows needs both within `tolerance_s`: give at least the time from row to row

# Means: No measured point and no row of the log have the same pose, cycle or row.
# Matters: No observations remain.
# Do: Compare the names in exports and log, or choose another key with `by` in [join].
# Example: poses 1 to 50 in the export, 0 to 49 in the log
join-empty = no measured point has a partner in log `{ $log }`: the first pose of the points is `{ $measured }`, of the log `{ $logged }`
    .hint = compare poses and cycles of exports and log, or choose another key with `by` in [join]

# Means: The offset of the clocks was determined from the standstills of the log: with this offset,
# every measured point falls into a standstill.
# Matters: Each point has the joint values of its standstill. The uncertainty of the offset is the
# stated half width.
# Do: Nothing, if all points were measured during standstills.
# Example: `clock_offset_s = "standstills"`
clock-from-standstills = the clock of log `{ $log }` is set by { $count ->
        [one] 1 standstill
       *[other] { $count } standstills
    }: offset { FIXED($offset_s, 3) } s ± { FIXED($half_width_s, 3) } s
    .hint = with this offset every measured point falls into a standstill

# Means: The world frame is measured at each pose, and could not be determined at some poses.
# Matters: Points of these poses cannot be expressed in the world; they are left out.
# Do: Find the refused frame targets in import.json, or measure them again.
# Example: a frame target that was not measured at pose 2
pose-without-frame = { $count ->
        [one] 1 pose
       *[other] { $count } poses
    } without a world frame, left out: { $poses }
    .hint = the frame targets were refused or not measured: see import.json

# Means: Measured points and their rows of the log state different poses or cycles.
# Matters: Joint values would be assigned to the wrong points.
# Do: Join by pose. If the column counts something else in the log, remove it from `columns`.
# Example: a join by row where the export lacks the row of pose 7
join-contradicts = { $count ->
        [one] 1 measured point has
       *[other] { $count } measured points have
    } a different { $column } in the joined row of log `{ $log }`: { $measured } and { $logged } (line { $line } of the log)
    .hint = join by pose; or remove `{ $column }` from `columns` of the log, if this column has another meaning in the log

# Means: A join by row needs one row of the log for each row of the export, and the counts differ.
# Matters: From the first missing row on, joint values would belong to other points.
# Do: Complete the file, or name pose and cycle in both and join by them.
# Example: 100 rows of the export, 99 of the log
row-counts-differ = `{ $file }` has { $rows } rows, but log `{ $log }` has { $log_rows }
    .expected = equal counts for a join by row
    .hint = complete the file that lacks rows; or name pose and cycle in both, and join by them

# Means: The robot has `backlash`, but the log has neither times nor a column of directions.
# Matters: The error of a joint with backlash depends on the direction of its last motion.
# Do: Give the times of the rows (`time_s` in `columns`, or `period_s`), or the column of
# directions: +1 from below, -1 from above.
# Example: `backlash = [2]` with a log without times
approach-direction-unknown = log `{ $log }` does not show the direction of approach of joint `{ $joint }`
    .hint = `backlash` needs it: give the times of the rows (`time_s` in `columns`, or `period_s`), or `{ $column }` in `columns`: +1 from below, -1 from above

# Means: The log has no motion of a joint with backlash before the first poses.
# Matters: The direction of approach is unknown there; these poses are left out.
# Do: Begin the log before the first pose, or give the direction.
# Example: a log whose first row is pose 1
backlash-direction-unknown = log `{ $log }` has no motion of a joint with backlash before pose { $poses }: left out
    .hint = begin the log before the first pose, or give the direction

# Means: The targets of a planar robot differ in height in the world frame by more than 0.5 mm.
# Matters: The plane of the world is tilted relative to the plane of motion; projected lengths are
# too short.
# Do: Check z of the exports (unit, sign, column) and the points that define the plane of the world
# frame.
# Example: two columns of the export exchanged
targets-out-of-plane = the targets of the planar robot have heights from { FIXED($low_mm, 3) } mm to { FIXED($high_mm, 3) } mm in the world frame
    .hint = check z of the exports (unit, sign, column) and the points that define the plane of the world frame

# Means: A column that each row needs is missing, or has an empty cell.
# Matters: It is unknown to which item the row refers.
# Do: Add the column, or complete the cell.
# Example: a row of kind `distance` without `other`
column-empty = the column `{ $column }` is empty or missing
    .hint = add the column, or complete the cell

# Means: Some targets were not measured at some poses.
# Matters: The measured targets are used. A pose or orientation needs all targets.
# Do: Measure the poses again if their orientations matter.
# Example: a hidden reflector at pose 12
targets-missing = targets are missing at { $count ->
        [one] pose { $poses }
       *[other] poses { $poses }
    }
    .hint = the other targets of these poses are used; a pose or an orientation needs all targets

row-is-a-pose = `{ $file }` gives `pose = "row"`, so that each row is a pose of its own: remove this line if several targets were measured at one pose

key-in-lines = { $key } (lines { $lines })

# Means: Several rows of the log have the same pose, or pose and cycle.
# Matters: It is unknown which joint values belong to the measured points.
# Do: Join by pose and cycle, or remove the invalid rows.
# Example: pose 3 logged twice with `by = "pose"`
log-key-twice = log `{ $log }` has { $count ->
        [one] 1 key
       *[other] { $count } keys
    } more than once: { $keys }
    .hint = add `cycle` to the key, or remove the invalid rows

# Means: Some measured points have no row of the log, or some rows of the log have no measured
# point.
# Matters: They do not take part in the result; import.json lists all of them.
# Do: Nothing, if these rows need no partner. Otherwise compare poses and cycles of both files.
# Example: a log of 100 poses, of which 90 were measured
keys-unmatched = { $count ->
        [one] 1 key
       *[other] { $count } keys
    } of { $of ->
        [log] log `{ $log }` without a measured point
       *[points] measured points without a row of log `{ $log }`
    } ({ $columns }): { $keys }; see import.json

# Means: A rigid part has so many targets that not every pair of them is compared.
# Matters: A wrong distance of a pair that is not compared is found by the other pairs of its targets.
# Do: Nothing, or state parts of at most 64 targets.
# Example: `targets` of [[rigid]] with 300 names
rigid-pairs-sampled = { $compared } of the { $pairs } distances between { $targets } targets of a rigid part are compared

# Means: Many pairs of names have points at one place; only the first pairs are listed.
# Matters: The names cannot be told apart by their positions, and some may be exchanged.
# Do: Check the labels of the export, and whether these targets are at one place.
# Example: 300 targets with the coordinates of one target
point-pairs-many = { $pairs } pairs of names have points at one place; the first { $named } are listed
    .hint = check the labels of the export

# Means: A named pose is only in the export or only in the log, and the other file also has poses
# without a partner.
# Matters: The spelling of the pose probably differs between the two files; its measurements would
# be lost.
# Do: Write the name of the pose the same in both files.
# Example: `home` in the log, `hom` in the export
pose-misspelt = pose `{ $pose }` { $of ->
        [log] of log `{ $log }` was not measured, and measured poses are not in the log
       *[points] is not in log `{ $log }`, and poses of the log were not measured
    }

# Means: Rows of an export or of the log lack the pose, cycle or row number that the join compares.
# Matters: These rows cannot be joined.
# Do: Give this key in `label` of the exports and in `columns` of the log, or change `by` in [join].
# Example: `by = "pose_and_cycle"` with labels without a cycle
join-key-missing = the join needs `{ $key }`, which is missing in some rows
    .hint = give it in `label` of the exports and in `columns` of the log, or change `by` in [join]

# Means: A join by label needs a robot with one target that touches points of a plate.
# Matters: A label does not give which of several targets touched the point.
# Do: Name one target, or join by pose.
# Example: `by = "label"` with three targets
join-by-label-targets = a join by label needs a robot with one target; this robot has { $count }
    .hint = name one target, or choose another key with `by` in [join]

# Means: The plate is measured once, but the world frame is measured at each pose.
# Matters: The points of the plate have no common position in a frame that changes with the pose.
# Do: Define the world frame by stationary points.
# Example: `each = "pose"` in [frame.world] with `by = "label"`
join-by-label-frame = a join by label needs one world frame for all poses
    .hint = define the frame by stationary points

# Means: A row of the log names a point that no export has.
# Matters: The position of the point is unknown.
# Do: Correct the label in the log, or add the export of the point.
# Example: `ball_7` of a plate with balls 1 to 6
label-not-measured = no measured point has the label `{ $label }`

# Means: No row of the log names these points of the plate.
# Matters: They are not used.
# Do: Nothing, if the robot did not touch them. Otherwise correct their labels.
# Example: a plate of 30 balls, of which 20 were touched
points-untouched = { $count ->
        [one] 1 point is
       *[other] { $count } points are
    } not touched in log `{ $log }`; the first is `{ $label }`

# Means: The time of a row of the log is not later than that of the previous row.
# Matters: The search for the row of a point needs increasing times.
# Do: Sort the log by time, and remove rows with equal times.
# Example: a log written by two recorders into one file
log-times-not-increasing = times of log `{ $log }` do not increase at its row { $row }
    .hint = sort the log by time, and remove rows with equal times

# Means: The join is by time, but rows of an export or of the log have no time.
# Matters: These rows cannot be joined.
# Do: Give the column of times as `time_s` in `columns` of exports and log.
# Example: `by = "time"` with an export without a column of times
times-missing = { $of ->
        [log] the log has rows without a time
        [export] the export has rows without a time
       *[points] no measured point has a time
    }
    .hint = a join by time needs `time_s` in the columns of exports and log

# Means: Several rows of the log are within `tolerance_s` of a measured point.
# Matters: The nearest row is used; if the robot moved, the choice affects the result.
# Do: Lower `tolerance_s` to less than half the period of the log.
# Example: `tolerance_s = 20` with rows 10 s apart
several-rows-near = { $count ->
        [one] 1 measured point has
       *[other] { $count } measured points have
    } several rows of log `{ $log }` within { $tolerance_s } s: the nearest row is used
    .hint = lower `tolerance_s` to less than half the period of the log

# Means: Measured points have no row of the log within `tolerance_s`.
# Matters: They are excluded from the result; import.json lists them.
# Do: If these points have partners, check `clock_offset_s` and `tolerance_s`.
# Example: points measured after the log ended
points-without-row = { $count ->
        [one] 1 measured point has
       *[other] { $count } measured points have
    } no row of log `{ $log }` within { $tolerance_s } s

# Means: Some rows of the log are not the nearest row of any measured point.
# Matters: They do not take part in the result; import.json lists them.
# Do: Nothing, if no point was measured at these times.
# Example: a row at 99 s, and points up to 20 s
rows-without-point = { $count ->
        [one] 1 row
       *[other] { $count } rows
    } of log `{ $log }` without a measured point

# Means: Several points of one target have the same time.
# Matters: A target has one position at a time.
# Do: Correct the times, or name the target of each point.
# Example: two reflectors read under one name
target-time-twice = { $count } points of target `{ $target }` have the same time (lines { $lines })
    .hint = correct the times, or name the target of each point

# Means: One row of the log is the nearest row of several points of one target.
# Matters: The target had one position at that time, so one of the points belongs to another row.
# Do: Lower `tolerance_s`, or check `clock_offset_s`.
# Example: `tolerance_s` longer than the time between two poses
log-row-met-twice = row { $row } of log `{ $log }` is the nearest row of { $count } points of target `{ $target }` (lines { $lines })
    .hint = lower `tolerance_s`, or check `clock_offset_s`

# Means: No offset of the clocks puts every measured point into a standstill of the log.
# Matters: The standstills do not determine the offset: a point was measured in motion, or the log
# lacks a standstill.
# Do: Set `clock_offset_s` as a number; rows without a partner are then listed.
# Example: a point taken while the robot moved
clock-offset-none = no offset of the clocks puts every measured point into a standstill of the log: { $count ->
        [one] the first point (up to { $last_s } s) fits
       *[other] the first { $count } points (up to { $last_s } s) fit with one offset
    }, the point at { $first_s } s does not
    .hint = remove points measured in motion, or set `clock_offset_s` as a number; rows without a partner are then listed

range-of-seconds = { FIXED($low_s, 3) } to { FIXED($high_s, 3) } s

# Means: Several offsets of the clocks put every measured point into a standstill.
# Matters: Only one of these offsets is right; with any other, points are joined with a wrong pose.
# Do: Compare the clocks once and set `clock_offset_s` as a number.
# Example: standstills at equal intervals
clock-offsets-several = the standstills allow { $count } ranges of the clock offset, the first: { $ranges }
    .hint = compare the clocks, and set `clock_offset_s` as a number

axis-of-world = "x", "y" or "z"

# Means: An [[observe]] or [[known]] of a truth lacks a required key of its kind.
# Matters: The row cannot be simulated.
# Do: Give the key.
# Example: `kind = "distance"` without `other`
observe-key-missing = kind `{ $kind }` needs `{ $column }`
    .hint = set `{ $column }`

# Means: A distance is missing, zero, negative or not a number.
# Matters: The row has no observation.
# Do: Correct or remove the row.
# Example: an empty `distance_mm`
distance-not-positive = `distance_mm` is missing or not a length
    .expected = a length above 0

# Means: A fixed point, socket or station has the name of a target on the robot, or `base`.
# Matters: Its coordinates would be those of the target on the moving part.
# Do: Give fixed points their own names.
# Example: `other = "SMR_1"` where SMR_1 is on the robot
fixed-point-on-robot = `{ $name }` is a target on the robot, not a fixed point
    .hint = give fixed points their own names; rows that give only fixed points have no pose

# Means: A distance is given from a point to the same point.
# Matters: The row has no observation.
# Do: Correct `other`.
# Example: `target = "A"`, `other = "A"`
distance-to-itself = the distance is from `{ $name }` to itself
    .hint = correct `other`

# Means: A row relates two targets of the same link.
# Matters: Their distance is the same at every pose and says nothing about the robot.
# Do: Name a target of another branch, or give the shape of the targets in [[rigid]].
# Example: `target = "L1"`, `other = "L2"` on the same hand
target-of-same-branch = `{ $target }` and `{ $name }` are on the same branch
    .hint = name a target of another branch; the shape of targets on one link is given in [[rigid]]

# Means: `other` of a bar names something else than a target of another branch.
# Matters: Two links of the robot hold a bar of `kind = "bar"`.
# Do: Name a target of another branch in `other`; for a bar with a fixed end use `kind = "distance"`.
# Example: `kind = "bar"` with `other = "anchor"`
bar-without-other-hand = `{ $name }` is not a target of another branch than `{ $target }`
    .hint = name a target of another branch; `kind = "distance"` is for a bar with a fixed end

# Means: A row of `kind = "bar"` with a pose gives a distance.
# Matters: A bar has one length. Its uncertainty would count once a pose.
# Do: Give the length in a row without pose, or use `kind = "distance"` for lengths that are
# measured at each pose.
# Example: `kind = "bar"`, `pose = 3`, `distance_mm = 500`
bar-length-at-pose = a bar has one length at all poses
    .hint = set `distance_mm` in a row without pose; lengths that are measured at each pose are `kind = "distance"`

# Means: A required number of the row is missing or cannot be read.
# Matters: The row has no observation.
# Do: Complete or remove the row.
# Example: a row of kind `joints` without `value_deg`
number-missing = `{ $column }` is missing or not a number
    .expected = { $column ->
            [offset_mm] the distance of the target from the plane along its axis, or from the sphere outwards: the radius of a ball, or 0
           *[value_deg] the value of the joint by the switch or second encoder
        }

# Means: A row without a pose is of a kind that needs a pose.
# Matters: Without a pose the joint values of the row are unknown.
# Do: Give the pose, or use a kind for fixed points and surfaces.
# Example: a row of kind `contact` with an empty `pose`
row-without-pose = a row of kind `{ $kind }` has no pose
    .hint = rows without a pose state positions (`point`) and distances (`distance`) of fixed points, and points on a `plane`, `line` or `sphere`

# Means: A [[known]] of a truth is of a kind that always needs a pose.
# Matters: The row cannot be simulated.
# Do: Use `point`, `distance`, `plane`, `line` or `sphere`, or give it as [[observe]].
# Example: `kind = "contact"` in [[known]]
known-unsupported = [[known]] cannot have the kind `{ $kind }`
    .expected = `point`, `distance`, `plane`, `line` or `sphere`

# Means: `near_mm` of a [[known]] is given for a point or distance.
# Matters: `near_mm` gives the position of a point on a surface; here it has no effect.
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

# Means: The column `kind` names a kind of observation that does not exist.
# Matters: The meaning of the row is unknown.
# Do: Use one of the kinds in docs/observations.md.
# Example: `kind = "points"`
kind-unknown = `{ $name }` is not a kind of observation

# Means: A name occurs in one or two rows and is spelt almost like a name in many rows.
# Matters: The named item would be identified from these rows alone, which then contribute nothing
# to the robot.
# Do: Correct the name, or exclude the rows.
# Example: `SMR_l` in one row, `SMR_1` in 99 rows
name-on-few-rows = `{ $name }` occurs in { $count ->
        [one] 1 row
       *[other] { $count } rows
    } only, but `{ $meant }` in { $meant_count }
    .hint = did you mean `{ $meant }`? otherwise exclude the rows of `{ $name }`: they do not determine its position

# Means: Joints of the URDF move `base_link`, and an instrument measured positions.
# Matters: Positions are taken as relative to the moving base. An instrument usually stands in the
# room.
# Do: If the instrument is fixed in the room, give the root of the URDF as `base_link`.
# Example: `base_link = "link_1"` of an arm on a rail
base-moves = the joints { $joints } move `base_link`: positions are taken as relative to this moving link
    .hint = if the instrument is fixed in the room, give the root of the URDF as `base_link`

names-of-fixed-things = give targets, points and planes different names

# Means: Rows give one or two coordinates of a target.
# Matters: Each coordinate counts as a separate observation.
# Do: Nothing, if the other coordinates were not measured.
# Example: heights measured with a dial gauge: `z_mm` alone
partial-coordinates = { $count ->
        [one] 1 row gives
       *[other] { $count } rows give
    } one or two coordinates of a target: each coordinate counts as a separate observation ({ $by ->
        [line] line
       *[pose] pose
    } { $rows }{ $more ->
        [0] {""}
       *[other] {" "}and { $more } more
    })

# Means: Rows of a table lack a joint value or all coordinates of a point.
# Matters: These rows are left out, like rows of an export or a log that were not measured.
# Do: Nothing, if nothing was measured there; otherwise correct the cells.
# Example: `12,SMR,10.0,20.0,,,` with empty coordinates
rows-not-measured = { $count ->
        [one] 1 row without a joint value or without coordinates is
       *[other] { $count } rows without a joint value or without coordinates are
    } left out ({ $by ->
        [line] line
       *[pose] pose
    } { $rows }{ $more ->
        [0] {""}
       *[other] {" "}and { $more } more
    })

# Means: A few rows have an empty column `station`, but many rows have a station.
# Matters: Rows without a station belong to the station of the world, which must observe the robot
# at three poses or more.
# Do: Complete the column.
# Example: one row of 100 without its station
station-missing = the column `station` is empty here, but other points have a station
    .hint = give the station: rows without one belong to the station of the world, which must observe the robot at { $least } poses or more

# Means: `coordinates` of a truth has letters other than x, y and z.
# Matters: It is unknown which coordinates are simulated.
# Do: Give one to three of the letters x, y and z.
# Example: `coordinates = "h"`
coordinates-unknown = `{ $text }` does not name coordinates
    .expected = letters of x, y and z: "z", "xy"

# Means: A row without a pose gives the position of a fixed point, and a coordinate is missing.
# Matters: The row has no observation.
# Do: Complete or remove the row.
# Example: an empty `z_mm` of a fixed point
place-missing = the position of `{ $point }` is missing or not a number
    .hint = complete its coordinates, or remove the row

# Means: A row lacks the value of a joint.
# Matters: The pose of the robot is unknown there.
# Do: Complete or remove the row.
# Example: an empty `q3_deg`
joint-value-missing = a joint value is missing or not a number
    .hint = complete or remove the row

# Means: A row of a station other than the first is not a point with three coordinates and one
# uncertainty.
# Matters: The frame of the station is identified with the robot; this needs points with three
# coordinates.
# Do: Give x_mm, y_mm, z_mm and `u_mm`.
# Example: a height alone, measured from a second station
station-row-unsupported = { $fault ->
        [kind] a row of kind `{ $kind }` gives the station `{ $station }`
        [coordinate] a coordinate measured by station `{ $station }` is missing or not a number
        [covariance] a point measured by station `{ $station }` gives a covariance
       *[uncertainties] coordinates measured by station `{ $station }` have separate uncertainties
    }
    .expected = rows of kind `point` with x_mm, y_mm, z_mm and one uncertainty `u_mm`, for stations other than the first

# Means: An `[[export]]` gives `station`, and `[join]` has `by = "label"`.
# Matters: Points that the robot touches are measured once, in the frame of the world.
# Do: Join by pose, row or time, or export all points in one frame.
# Example: sockets on a table, measured by a tracker at a second place
station-join-by-label = points of station `{ $station }` are joined by label
    .hint = join them by pose, row or time: a touched point is measured in the frame of the world

# Means: The standard uncertainty of a row is negative.
# Matters: The weight of the row depends on its uncertainty.
# Do: Correct the value, or leave the cell empty.
# Example: `u_mm = -1`
uncertainty-not-positive = `{ $column }` = { $value } is not a standard uncertainty
    .expected = a positive number

# Means: Some coordinates of a target are missing. Such a row may be meant as single coordinates, each
# an observation, and then needs its standard uncertainty.
# Matters: A gap in a table of positions is not a measurement of single coordinates.
# Do: Complete the row, or leave it out; if only some coordinates were measured, give their
# uncertainty.
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
    .hint = complete the row or leave it out; if only the other coordinates were measured, give their standard uncertainty: a column `u_mm`, `expanded_uncertainty_um` in [instrument], or --standard-uncertainty-um of `etalon identify` and `etalon verify`

# Means: A row has no standard uncertainty, and no uncertainty is given for all rows.
# Matters: The weight of the row depends on its uncertainty.
# Do: Give an uncertainty for all rows, or in a column.
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
            [urot_deg] set `expanded_rotation_uncertainty_deg` in [instrument], or a column `urot_deg`; of `etalon identify` and `etalon verify` --rotation-uncertainty-deg
           *[u_mm] set `expanded_uncertainty_um` in [instrument], or a column `u_mm`; of `etalon identify` and `etalon verify` --standard-uncertainty-um
        }

# Means: A plane or line is identified, and the column `axis` does not give the nearest axis of the
# world.
# Matters: The parameters of the plane or line refer to this axis.
# Do: Set `x`, `y` or `z`.
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
# Matters: The offset from a line has no defined direction.
# Do: Leave the cell empty.
# Example: `offset_mm = 5` in a row of kind `line`
offset-of-line = `offset_mm` is for planes and spheres, not for a line
    .hint = leave the cell empty

# Means: A [[known]] of a truth is a point on a plane or line without its position.
# Matters: The point cannot be simulated.
# Do: Set `near_mm`.
# Example: `kind = "plane"` in [[known]] without `near_mm`
near-missing = a point on a { $kind } needs `near_mm`
    .hint = give its approximate position in the world

# Means: The text in the column `direction` of a table of loads is not a signed axis.
# Matters: The compliance is evaluated for each direction.
# Do: Correct the cell.
# Example: `x` instead of `+x`
load-direction-unknown = `{ $direction }` is not a direction
    .expected = +x, -x, +y, -y, +z or -z

# Means: The table has a load along z, but no `z_mm`.
# Matters: The displacement along the force was not measured.
# Do: Add the column `z_mm`, or remove the row.
# Example: `direction = "+z"` in a table of x and y
load-direction-unmeasured = direction `{ $direction }` needs `z_mm`: the displacement in this direction was not measured
    .hint = add the column `z_mm`, or remove the row

# Means: A force is missing, negative or not a number.
# Matters: The row has no load.
# Do: Give the magnitude in newtons; the direction gives the sign.
# Example: `force_n = -50`
force-not-a-number = `{ $text }` is not a force
    .expected = newtons, zero or more: the direction gives the sign

# Means: `drift_set` is given without commanded poses.
# Matters: Drift is the change of pose accuracy, which needs commanded poses (ISO 9283, 7.2.4).
# Do: Set `commanded`, or remove `drift_set`.
# Example: `drift_set = 10` without `commanded`
drift-without-commanded = `drift_set` needs commanded poses
    .hint = give them: `commanded = "commanded.csv"`

# Means: The campaign has [poses] and [repeatability].
# Matters: Both give the attained poses of one test: it is undefined which apply.
# Do: Keep [repeatability] for labelled points, or [poses] for a table.
# Example: [poses] with `attained` beside [repeatability] with `label`
attained-poses-twice = [poses] and [repeatability] both state attained poses
    .hint = keep [repeatability] for labelled points, or [poses] for a table

# Means: A limit is given for a characteristic that some poses do not have.
# Matters: The limit cannot be judged at these poses.
# Do: Visit every pose at least twice, and give its commanded position; or remove the limit.
# Example: `repeatability_max_mm` where pose 4 was visited once
limit-without-value = the limit `{ $limit }` cannot be judged: it has no value at pose { $pose }
    .hint = visit every pose at least twice, and give its commanded position

# Means: Compensation by reference targets increases the scatter of the positions.
# Matters: The reference targets did not move with the measuring system; compensated values are
# worse than measured ones.
# Do: Look for a wrong reading among the reference targets, or leave them out.
# Example: a reference target touched during the test
compensation-scatters = attained positions scatter by { FIXED($after_mm, 4) } mm about the mean of their pose after compensation by reference targets, by { FIXED($before_mm, 4) } mm before
    .hint = look for a wrong reading among the reference targets, or leave them out

# Means: The distances between reference targets changed by more than twice the expanded uncertainty
# of the instrument.
# Matters: A target moved or was measured wrongly; the compensation of the set-up contains this
# error.
# Do: Measure the reference targets again, or exclude the wrong one.
# Example: one of four reference targets bumped in cycle 12
reference-targets-misshapen = reference targets of cycle { $cycle } deviate by { FIXED($rms_mm, 4) } mm (root mean square) from a rigid motion since the first cycle; expanded uncertainty { FIXED($expanded_mm, 4) } mm
    .hint = a target moved or was measured wrongly: measure the targets again, or exclude the wrong one

# Means: [repeatability] needs a world frame that is measured once, but the campaign measures it at
# each pose.
# Matters: A frame that is measured at each pose adds its scatter to the repeatability.
# Do: Define the world frame by points that are measured once.
# Example: `each = "pose"` in [frame.world] with [repeatability]
repeatability-frame = [repeatability] needs a world frame that is measured once
    .hint = define the frame by stationary points

# Means: The table of commanded poses has angles, but labelled points have positions only.
# Matters: Accuracy of orientation cannot be evaluated.
# Do: Remove the column, or give attained poses with angles as a table in [poses].
# Example: `a_deg` in `commanded` of [repeatability]
commanded-angle-unmeasured = `{ $column }` is commanded, but labelled points have positions only
    .hint = remove the column, or give attained poses with angles as a table: [poses]

# Means: A pose was visited, and the table of commanded poses lacks it.
# Matters: Its accuracy cannot be evaluated.
# Do: Add a row for every pose of the trajectory that was measured.
# Example: a trajectory of five poses, four rows
commanded-pose-missing = no position is commanded for pose { $poses }
    .hint = add a row for every pose of the trajectory that was measured

# Means: The table of commanded poses has a pose that was not visited.
# Matters: The pose has no characteristics.
# Do: Nothing, if the pose is not part of the test.
# Example: a table of five poses, four visited
commanded-pose-unmeasured = pose { $pose } is commanded, but nothing was measured there

# Means: `trajectory` of [repeatability] is an empty list.
# Matters: The order of the visits is unknown.
# Do: Give the poses of one cycle in their order.
# Example: `trajectory = []`
trajectory-empty = the trajectory has no pose
    .hint = give the poses of one cycle in their order, for example [1, 2, 1, 3]

# Means: `coplanar` of [repeatability] names a pose twice, or a pose that `trajectory` lacks.
# Matters: The deviation from the plane is computed from four visited poses.
# Do: Name four poses of the trajectory, each once.
# Example: `coplanar = [1, 2, 3, 3]`
coplanar-not-four = `coplanar` must name four different poses of the trajectory
    .expected = four poses of the trajectory, each once

# Means: A label names a pose that `trajectory` of [repeatability] lacks.
# Matters: The visit has no position in the order of the cycle.
# Do: Correct the label, or add the pose to `trajectory`.
# Example: the label `visit_9_1` with `trajectory = [1, 2, 3]`
pose-not-in-trajectory = pose { $pose } (cycle { $cycle }) is not in the trajectory
    .hint = correct the label, or add the pose to `trajectory`

# Means: Labels of [repeatability] match visits of several targets.
# Matters: Repeatability refers to one point; several targets have different positions.
# Do: Name one target in `label`.
# Example: `label = "{target}_{pose}_{cycle}"` with three balls
pose-of-several-targets = pose { $pose } (cycle { $cycle }) has visits of `{ $target }` and of another target
    .hint = name the one target of the test in `label`

pose-of-cycle = pose { $pose } of cycle { $cycle }

# Means: The number of visits of a pose in a cycle differs from that of the trajectory.
# Matters: It is unknown which visit is missing, and therefore from which poses the others were
# approached.
# Do: Add the visit, or remove all visits of this pose and cycle.
# Example: two visits where the trajectory passes the pose three times
visit-count-differs = pose { $pose } was measured { $found } times in cycle { $cycle }, but the trajectory passes it { $count } times
    .hint = add the visit, or remove all visits of this pose and cycle: their previous poses are unknown

# Means: Poses of the trajectory have no visit in some cycles.
# Matters: Their characteristics are based on fewer cycles.
# Do: Nothing, if the cycles were interrupted. Otherwise look for misspelt labels.
# Example: cycle 30 ended at pose 3
visits-missing = not measured: { $poses }{ $count ->
        [one] {""}
       *[other] {""}; { $count } in all
    }

# Means: The expanded uncertainty of the instrument exceeds 25 % of the repeatability of homing.
# Matters: The value is an upper bound for the robot's repeatability.
# Do: Use the value as an upper bound, or measure with a better instrument.
# Example: a repeatability of 5 µm measured with U = 3 µm
homing-instrument-too-coarse = the measurement uncertainty exceeds 25 % of the repeatability of homing, { FIXED($rp_mm, 4) } mm
    .hint = use the value as an upper bound, or measure with a better instrument

# Means: The central part of a path is given as more than 100 %.
# Matters: The central part lies within the path.
# Do: Give 100 or less.
# Example: `central_percent = 150`
central-part-too-large = { $option } exceeds 100 %
    .expected = a number above 0 and at most 100

# Means: The number of command points on a path is below 2 or above 100000.
# Matters: Path accuracy is evaluated in a plane at each command point.
# Do: Give a number from 2 to 100000.
# Example: `path_points = 1`
path-points-out-of-range = { $option } is out of range
    .expected = 2 to 100000

# Means: A velocity or weave is commanded without a commanded path.
# Matters: Such a command has no effect.
# Do: Give the file of the commanded path.
# Example: `velocity_mm_s = 100` without `path`
path-not-stated = { $option } needs { $path }
    .hint = give the file of the commanded path

# Means: A weave needs stroke, frequency and direction, and one of them is missing.
# Matters: Weaving deviations compare all three.
# Do: Give the missing one.
# Example: `weave_hz` alone
weave-incomplete = the weave lacks { $option }
    .hint = state stroke, frequency and direction

# Means: The direction of a weave does not have three finite numbers.
# Matters: The swing is measured along this direction.
# Do: Give x, y and z of the direction.
# Example: `weave_across = [0, 1]`
weave-direction-count = { $option } does not have three numbers
    .expected = x, y and z of the direction of the swing

# Means: Two [[stream]] have the same name.
# Matters: Results and comparisons of campaigns refer to the name.
# Do: Give each stream its own name.
# Example: two [[stream]] with `name = "square"`
stream-twice = stream `{ $stream }` occurs twice
    .hint = give each stream its own name

in-observation = pose { $pose } cycle { $cycle } of the observations: { $message }

in-candidate = pose { $pose } of the candidates: { $message }

in-feature = feature `{ $name }`: { $message }

# Means: Rows of one pose and cycle have different joint values.
# Matters: All targets of a pose are measured at the same joint values.
# Do: Correct the joint values, or number repeats in the column `cycle`.
# Example: `q1_deg` 10.0 and 10.5 at pose 3, cycle 1
joints-of-pose-differ = rows of one pose and cycle have different joint values
    .hint = correct them, or number repeats in the column `cycle`

# Means: A target has two rows at one pose and cycle.
# Matters: It is unknown which of them is valid.
# Do: Number repeats in the column `cycle`.
# Example: two rows `3,1,SMR_1`
target-repeated = target `{ $target }` occurs twice
    .hint = number repeats in the column `cycle`

# Means: The arms of the nominal robot are too short, or too far apart, to meet at these joint
# values.
# Matters: The pose cannot be computed.
# Do: Check unit, sign and offset of the joints, and the nominal parameters.
# Example: `theta1` = 180 deg, `theta2` = 0 deg of a five-bar robot
arms-apart = with nominal parameters the arms do not meet at these joint values
    .hint = check unit, sign and offset of the joints, and the nominal parameters

# Means: Candidates are joint values of a parallel robot without the assembly mode.
# Matters: The robot has two positions at the same joint values.
# Do: Give 1 or -1 in the column `assembly`, or state candidates as positions.
# Example: `pose,theta1_deg,theta2_deg` of a five-bar robot
assembly-mode-missing = the assembly mode is not given
    .expected = 1 or -1 in the column `assembly`
    .hint = candidates may also be positions: `pose,x_mm,y_mm` without joints gives all working modes

# Means: The positions of both assembly modes have about the same distance from the measured
# position.
# Matters: The measurement does not determine the mode.
# Do: Give the column `assembly`, or the position of the base under [nominal].
# Example: a five-bar robot measured along its line of symmetry
assembly-mode-ambiguous = both assembly modes fit equally well: { FIXED($near_mm, 2) } mm and { FIXED($far_mm, 2) } mm from the measured position
    .hint = give a column `assembly` with 1 or -1; or give the position of the base (x_o, y_o, phi) under [nominal]

# Means: The log gives no assembly mode; the mode nearer to the measurement was used.
# Matters: A wrong mode would cause an error of millimetres at this pose.
# Do: Give the column `assembly`, if the log has it.
# Example: a log of a five-bar robot without `assembly`
assembly-modes-assumed = the assembly mode of { $count } observations was taken from the measurement ({ $positive } in mode +1, { $negative } in mode -1); the least clear pose is { $pose }: { FIXED($near_mm, 1) } mm and { FIXED($far_mm, 1) } mm
    .hint = give a column `assembly` with 1 or -1 if the log has it

# Means: The table has both columns `ux_mm` .. and columns `cxx_mm2` ..
# Matters: It is undefined which columns weight the rows.
# Do: Remove `ux_mm`, `uy_mm`, `uz_mm`.
# Example: `ux_mm` beside `cxx_mm2`
uncertainties-twice = the table gives both standard uncertainties and covariances of coordinates
    .hint = remove `ux_mm`, `uy_mm`, `uz_mm`

# Means: A row gives the uncertainties of only some coordinates.
# Matters: Its weight is unknown.
# Do: Complete the row, or leave all cells of its uncertainties empty.
# Example: `ux_mm` without `uy_mm` in a row
coordinate-uncertainty-missing = the row gives an uncertainty, but `{ $column }` is empty
    .expected = from 0.00002 to 100 mm for each coordinate, or empty cells for all

# Means: The uncertainty of a coordinate is zero, negative, below 0.02 µm or above 100 mm.
# Matters: No instrument has such an uncertainty; the column is probably in another unit.
# Do: Correct the unit or the value.
# Example: `ux_mm = 0.000001`
coordinate-uncertainty-unusable = `{ $column }` = { $value } cannot be the uncertainty of a coordinate
    .expected = from 0.00002 to 100 mm for each coordinate, or empty cells for all

# Means: The covariance of a position has an eigenvalue of zero or below.
# Matters: A covariance of measured coordinates is positive definite: two elements are exchanged, or
# have a wrong unit.
# Do: Check the columns `cxx_mm2` ..
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
    } measured only at validation poses: { $names }; located by these readings, with the identified robot held

# Means: All targets of the validation poses are measured only there, and all readings are needed to
# locate them.
# Matters: No reading is left that could contradict the identified robot.
# Do: Also measure the targets at calibration poses, or move a pose where they are measured to
# `calibration`.
# Example: a second ball measured at the validation poses, once each
validation-leaves-nothing = { $unplaced }: no redundant reading is left for validation
    .hint = also measure them at calibration poses, or move a pose where they are measured to `calibration`

# Means: A target is measured only at validation poses. Its position was fitted to these readings.
# Matters: The errors of these readings are smaller than those of an independent validation; the
# statistics account for their redundancy.
# Do: Also measure the target at calibration poses.
# Example: a second ball measured at the validation poses
placed-by-validation = { $unplaced }; the statistics take this into account
    .hint = also measure them at calibration poses, or move a pose where they are measured to `calibration`

# Means: Some targets are measured only at validation poses, and their positions are fitted to these
# few readings.
# Matters: Errors of these readings are not judged: they would be near zero for any robot.
# Do: Also measure the targets at calibration poses.
# Example: a ball measured once, at a validation pose
placed-by-validation-unjudged = { $unplaced }; readings without redundancy are not judged: { $names }
    .hint = also measure them at calibration poses, or move a pose where they are measured to `calibration`

# Means: The nominal robot reaches no candidate position, or its model has no inverse kinematics.
# Matters: There are no configurations from which to choose.
# Do: Give joint values instead of positions.
# Example: candidates in metres
candidate-positions-unreachable = the `{ $model }` reaches no candidate position, or the model has no inverse kinematics
    .hint = give joint values, one column per joint with its unit

check-readings = check these readings for exchanged labels and mistakes; measure them again, or exclude them with `exclude` in [identify]

# Means: A robust fit and least squares give significantly different parameters, and no
# single pose is the cause.
# Matters: The residuals are not normally distributed; standard uncertainties may be too small.
# Do: Look for errors of the robot that the model does not describe, and check the stated
# uncertainty.
# Example: base and targets held at nominal values that are wrong
robust-fit-disagrees = a robust fit changes `{ $parameter }` by { FIXED($over_u, 1) } standard uncertainties of the difference (limit { FIXED($limit, 1) }); no pose disagrees with all others: the residuals are not normal
    .hint = the robot has errors that the model does not describe, or the stated uncertainty is too small

# Means: A robust fit and least squares give significantly different parameters, and the
# robust fit gives some poses a low weight.
# Matters: These poses contradict the others and distort the parameters.
# Do: Check these poses for exchanged labels and wrong readings.
# Example: a pose whose log row belongs to another pose
robust-fit-disagrees-at-poses = a robust fit changes `{ $parameter }` by { FIXED($over_u, 1) } standard uncertainties of the difference (limit { FIXED($limit, 1) }); poses that disagree with the others: { $poses }

target-positions = `{ $target }` ({ $count ->
        [one] 1 position
       *[other] { $count } positions
    })

# Means: The nominal robot reproduces all coordinates of a target from the joint values, to the
# rounding of the file.
# Matters: Measured coordinates contain errors of robot and instrument. These coordinates were
# computed: parameters cannot be identified from them.
# Do: Name the measured coordinates in `columns`; set `synthetic` for simulated data.
# Example: `columns` names the commanded position of an export instead of the measured one
coordinates-commanded = the nominal robot reproduces the coordinates of { $targets } from the joint values to { SCIENTIFIC($largest_mm, 2) } mm, the rounding of the file: they were commanded, not measured
    .hint = name the measured coordinates in `columns`; if the data are simulated, set `synthetic` in the campaign

# Means: The points of the world frame fit the mirror image of `nominal_mm` rather than `nominal_mm`
# itself.
# Matters: A body cannot be mirrored: two axes of the export are exchanged, or one axis has the
# wrong sign.
# Do: Check the columns and signs of the export.
# Example: `columns = ["label", "y", "x", "z"]`
frame-points-mirrored = the points of the world frame are { FIXED($off_mm, 3) } mm from their nominal positions, but fit the mirror image within { FIXED($limit_mm, 3) } mm
    .hint = two axes of the export are exchanged, or one axis has the wrong sign: check the columns

# Means: One point of the world frame deviates from its nominal position, and the others fit without
# it.
# Matters: The point shifts or rotates the frame, and with it every position.
# Do: Check the point, its label and `nominal_mm`, or give the tolerance of the drawing.
# Example: a reflector that does not sit in its nest
frame-point-off = `{ $point }` is { FIXED($off_mm, 3) } mm from its nominal position relative to the other points (tolerance { $tolerance_mm } mm, U = { FIXED($expanded_mm, 4) } mm)
    .hint = check the point, its label and `nominal_mm`, or give the tolerance of the drawing

# Means: Points of the world frame deviate from their nominal positions, and no single point is the
# cause.
# Matters: The frame, and with it every position, is wrong by about as much.
# Do: Check the points, their labels and `nominal_mm`, or give the tolerance of the drawing.
# Example: `nominal_mm` in inches
frame-points-off = the distance from `{ $first }` to `{ $second }` is { FIXED($measured_mm, 3) } mm measured, { FIXED($nominal_mm, 3) } mm nominal (tolerance { $tolerance_mm } mm, U = { FIXED($expanded_mm, 4) } mm)
    .hint = check the point, its label and `nominal_mm`, or give the tolerance of the drawing

# Means: `nominal_mm` of [frame.world] names a point that no export has.
# Matters: The point cannot be compared.
# Do: Correct the name.
# Example: `nominal_mm = { base_9 = [0, 0, 0] }` with base_1 to base_4
nominal-point-unmeasured = `nominal_mm` names `{ $point }`, which was not measured

# Means: `nominal_mm` of [frame.world] gives one or two points.
# Matters: Two points fit any drawing of the right length.
# Do: Add points of the frame, or remove `nominal_mm`.
# Example: `nominal_mm` of two points
nominal-few-points = `nominal_mm` needs three points or more
    .hint = add points of the frame, or remove `nominal_mm`

# Means: The identified base is far from [nominal] of robot.toml, and exchanged axes of the world
# frame explain the difference.
# Matters: The robot itself is identified correctly. Base parameters, and positions in the world,
# refer to other axes than robot.toml gives.
# Do: Check axes and points of the world frame, and [nominal].
# Example: an export whose z is vertical, robot.toml with y vertical
world-axes-exchanged = the base is { FIXED($off_mm, 0) } mm and { FIXED($off_deg, 1) } deg from the position in robot.toml: x, y, z of robot.toml are { $axes } of the world frame
    .hint = check axes, unit and points of the world frame, and [nominal] of robot.toml

# Means: The identified base is far from its position in [nominal] of robot.toml.
# Matters: The world frame has wrong points or a wrong unit, or robot.toml gives another position.
# Do: Check axes, unit and points of the world frame, and [nominal].
# Example: a world frame defined by the points of another fixture
base-off-nominal = the base is { FIXED($off_mm, 0) } mm and { FIXED($off_deg, 1) } deg from the position in robot.toml; limit { $limit_mm } mm, { FIXED($limit_deg, 1) } deg
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
        [negated] the angles with the other sign
        [inverse] the inverse rotations
       *[left-handed] a left-handed frame ({ $name } reversed)
    }

# Means: Observed orientations differ from those of the robot by more than errors of the joints
# explain.
# Matters: They follow a convention other than stated by the columns, or a joint is reversed.
# Parameters identified from them would be meaningless.
# Do: Check the causes in the hint. Otherwise check that qw, qx, qy, qz rotate vectors from the body
# to the world, with the scalar first; or check the order of angles.
# Example: quaternions with the scalar last in columns qw, qx, qy, qz
orientations-off = observed orientations differ from those of the { $robot ->
        [nominal] nominal
       *[identified] identified
    } robot by { FIXED($median_deg, 1) } deg (median)
    .hint = check that qw, qx, qy, qz rotate vectors from the body to the world, with the scalar first; or check the order of angles: without `orientation`, the orders that fit are named

# Means: There are too few calibration poses to leave some out and predict them from the others.
# Matters: Effects cannot be compared by their error at left-out poses.
# Do: Measure more poses, or select more in `calibration`.
# Example: `etalon recommend` with four poses
few-poses-to-leave-out = { $count ->
        [one] 1 calibration pose is
       *[other] { $count } calibration poses are
    } too few to leave some out
    .expected = at least { $least }
    .hint = measure more poses, or select more in `calibration`

# Means: The observations contain no position, distance or contact.
# Matters: Effects are compared by position errors.
# Do: Measure positions, distances or contacts.
# Example: a table of orientations alone
nothing-to-judge = the observations contain no position, distance or contact
    .hint = parameters are judged by position errors: measure positions, distances or contacts

# Means: In joint space, half of the validation poses are much nearer to a calibration pose than
# calibration poses are to each other.
# Matters: Such poses repeat the errors of the calibration; elsewhere errors may be larger.
# Do: Validate on poses between the calibration poses.
# Example: the poses of the calibration measured again
validation-repeats-calibration = validation repeats the calibration: the median distance of a validation pose from the nearest calibration pose is { FIXED($median, 2) } times the spacing of the calibration poses; limit { $limit }
    .hint = the robot’s error elsewhere may be larger: validate on poses between the calibration poses

# Means: In joint space, half of the validation poses are much farther from the calibration poses
# than these are from each other.
# Matters: The parameters are extrapolated there; errors are larger than within the calibrated
# region.
# Do: Calibrate on poses spread over the whole workspace in use.
# Example: calibration in one corner, validation in the other
validation-far = validation is far from the calibration: the median distance of a validation pose from the nearest calibration pose is { FIXED($median, 2) } times the spacing of the calibration poses; limit { $limit }
    .hint = calibrate on poses spread over the whole workspace in use

# Means: The column `quantity` of a table of errors has an unknown name.
# Matters: The report cannot be written from this table.
# Do: Run the campaign again with this version.
# Example: `quantity` is `velocity`
error-quantity-unknown = `{ $name }` is not a quantity of errors
    .hint = run the campaign again: `etalon run CAMPAIGN`

# Means: The column `set` of a table of errors is neither calibration nor validation.
# Matters: It is unknown to which statistics the row belongs.
# Do: Correct the cell.
# Example: `set` is `control`
pose-set-unknown = `{ $name }` is not a set of poses
    .expected = calibration or validation

# Means: All rows were measured at the same joint values, or at values so near to each other that the
# noise hides the effect of every parameter of the robot.
# Matters: Repeats of one pose show the noise alone: no parameter of the robot can be identified.
# Do: Measure poses with different values of every joint; check that the joint values are read from
# the right columns.
# Example: one pose measured thirty times
joints-do-not-move = the joints do not move: all { $rows } observations are { $motion }; they show no parameter of the robot{ $points ->
        [0] {""}
       *[other] {" "}(scatter of the measured points: { FIXED($scatter_mm, 3) } mm)
    }
    .hint = measure poses with different values of every joint; if the robot did move, the joint values are read from wrong columns or a stale file

motion-none = at one pose

motion-within-angle = within { FIXED($range_deg, 3) } deg in every joint

motion-within-length = within { FIXED($range_mm, 3) } mm in every joint

motion-within-both = within { FIXED($range_deg, 3) } deg and { FIXED($range_mm, 3) } mm in every joint

# Means: A joint has the same value at all calibration poses. Parameters that only its motion would
# determine keep their nominal values.
# Matters: Errors of these parameters, up to their tolerances, remain at other values of the joint.
# Do: Move the joint between the calibration poses, or use the robot only at this value of the
# joint.
# Example: joint 6 at 0 in all poses
joint-does-not-move = `{ $joint }` does not move: { $count ->
        [one] the data do not determine 1 parameter
       *[other] the data do not determine { $count } parameters
    }, known only within tolerance: { $parameters }
    .hint = move `{ $joint }` between the calibration poses, or use the robot only at this value; otherwise errors up to the tolerance of `{ $first }` remain

# Means: The standard uncertainty of the direction of a feature is too large for a frame.
# Matters: A frame defined by it would have an arbitrary direction.
# Do: Measure points farther apart, not all on one line.
# Example: a plane through three points on one line
direction-undetermined = its direction has a standard uncertainty of { FIXED($direction_deg, 0) } deg; limit { $limit_deg } deg
    .hint = measure points farther apart, not all on one line

# Means: The direction of a feature has a large standard uncertainty.
# Matters: A frame defined by it rotates all positions by as much.
# Do: Measure points farther apart.
# Example: one of five readings of a corner of a plane that is off by 5 mm over 300 mm
direction-uncertain = its direction has a standard uncertainty of { FIXED($direction_deg, 2) } deg; limit { $limit_deg } deg
    .hint = measure points farther apart

# Means: `towards` of [frame.world] is a point on the axis.
# Matters: It does not define the side of the other axis.
# Do: Name a point away from the axis.
# Example: `towards` equal to the end of `x_axis`
world-side-undetermined = `towards` lies on the axis: it does not define the side of the other axis
    .hint = name a point away from the axis

# Means: `targets` of [frame.world] names one or two targets.
# Matters: Two points leave one rotation undetermined.
# Do: Name three targets or more.
# Example: `targets = ["base_1", "base_2"]`
frame-few-targets = the world frame has { $count ->
        [one] 1 target
       *[other] { $count } targets
    }
    .expected = three targets or more

# Means: No pose has all targets of [frame.world], or the targets coincide or lie on one line.
# Matters: The frame cannot be determined.
# Do: Measure all targets of the frame; check their labels.
# Example: a label of a frame target misspelt in the whole export
frame-never-complete = no pose has all targets { $targets } of the world frame at different positions
    .hint = measure all of these targets, and check their labels

# Means: The table has columns of orientations in two forms.
# Matters: It is undefined which columns apply.
# Do: Remove one form.
# Example: `qw, qx, qy, qz` beside `a_deg, b_deg, c_deg`
orientations-twice = the table has orientations twice: { $first } and { $second }
    .hint = remove one of them

# Means: The table has only some of the columns of an orientation.
# Matters: The orientation is incomplete.
# Do: Add the missing columns.
# Example: `qx, qy, qz` without `qw`
orientation-columns-missing = the orientation lacks { $missing }
    .expected = { $columns }: orientation of the body in the world

# Means: A number of an orientation is missing or cannot be read.
# Matters: The orientation is incomplete.
# Do: Complete the row, or remove it.
# Example: an empty `qz`
orientation-missing = the orientation is missing or not a number
    .expected = orientation of the body in the world: qw, qx, qy, qz, or a rotation vector, or three angles

# Means: Orientations are three angles, and the order of the rotations is not given.
# Matters: The orientation depends on the order of the rotations.
# Do: Set `orientation` according to the manual of the measuring system or controller.
# Example: `a_deg, b_deg, c_deg` without `orientation`
angle-order-missing = the order of the angles is not given
    .hint = set `orientation = "zyx"` in [observations], or --orientation

angle-orders-unfit = no order of angles fits the nominal robot: the smallest residual is { FIXED($left_deg, 1) } deg (root mean square) with `{ $order }`; check the joints, and that the angles rotate from the body to the world

angle-order-leaves = `{ $order }`: residual { FIXED($left_deg, 3) } deg

angle-orders-fit = set `orientation = "{ $order }"` in [observations], or --orientation; with the nominal robot, { $orders } (root mean square)

# Means: A step of the geometric calibration needs several balls in one cycle, and one ball was not
# measured.
# Matters: The step cannot be evaluated for this pose and cycle.
# Do: Measure the ball, or remove the other readings of the cycle.
# Example: K measured at the end of the offsets without L
ball-missing = ball `{ $target }` is missing (pose { $pose }, cycle { $cycle })
    .hint = measure the ball, or remove the other readings of this pose and cycle

# Means: `actuator` of [[geometric.lead]] is not 1, 2 or 3.
# Matters: A PreXYT has three actuators.
# Do: Correct the number.
# Example: `actuator = 4`
actuator-unknown = actuator { $actuator } does not exist
    .expected = 1, 2 or 3

# Means: The position in a label of a lead measurement is missing in `positions_mm`.
# Matters: The commanded displacement is unknown.
# Do: Correct the label, or complete `positions_mm`.
# Example: position 6 with five `positions_mm`
lead-position-unknown = position { $position } of actuator { $actuator } is not among `positions_mm`
    .hint = correct the label, or complete `positions_mm`

# Means: The geometric calibration needs a world frame defined by the rails and ball R.
# Matters: The base of the robot is unknown.
# Do: Set `plane`, `origin`, `y_axis` and `towards` (thesis 3.4.1).
# Example: [frame.world] with `targets`
geometric-frame = the geometric calibration needs a world frame from the rails and ball R
    .expected = `plane`, `origin`, `y_axis = [origin, other end]` and `towards`, as in the thesis’ 3.4.1

# Means: [geometric] is given for a robot other than a PreXYT.
# Matters: Its steps measure the links of a PreXYT.
# Do: Remove [geometric], or set `model = "prexyt"`.
# Example: [geometric] with a six-axis arm
geometric-other-robot = [geometric] is available only for a PreXYT
    .expected = a robot with model `prexyt`

# Means: The measured length of a scale bar differs from its certificate by more than the
# permissible error of the instrument.
# Matters: The instrument does not meet its specification; lengths of this campaign have errors of
# similar size.
# Do: Check probe, temperature and mounting of the instrument, and measure the bar again.
# Example: a bar measured with an unqualified probe
scale-bar-error = scale bar `{ $name }`: an error of { FIXED($error_mm, 4) } mm exceeds the permissible { FIXED($limit_mm, 4) } mm
    .hint = check probe, temperature and mounting of the instrument, and measure the bar again

# Means: The permissible error of the instrument is less than four times the expanded uncertainty of
# the bar (4:1 rule of ANSI/NCSL Z540).
# Matters: The bar cannot verify the instrument.
# Do: Use a bar with a better certificate.
# Example: a bar with U = 3 µm for a permissible error of 5 µm
scale-bar-uncertain = scale bar `{ $name }`: the permissible error is { FIXED($ratio, 1) } times the expanded uncertainty of its certificate, { $least } times are required
    .hint = use a bar with a better certificate: this bar cannot verify the instrument

# Means: Residuals of a step of the geometric calibration scatter more than the uncertainty of the
# instrument explains.
# Matters: The uncertainties of the step are taken from the residuals.
# Do: Check for play, a dirty ball or a loose nest; measure the step again.
# Example: a ball that moves in its nest
step-scatters = { $step }: residuals scatter by { FIXED($found_mm, 4) } mm, the instrument by { FIXED($stated_mm, 4) } mm; uncertainties are computed from the residuals
    .hint = check for play, a dirty ball or a loose nest; measure the step again

# Means: A table of the geometric report selects poses without a cycle in which both K and L were
# measured.
# Matters: The table would be empty.
# Do: Measure both balls in the same cycle, or select other poses.
# Example: `poses = "9-13"`, where only K was measured at these poses
table-without-poses = the table `{ $title }` has no pose at which K and L were measured together
    .hint = measure both balls in the same cycle, or select other poses

# Means: parameters.json has no covariance: the identification left no degrees of freedom.
# Matters: It cannot be judged whether new measurements contradict the parameters.
# Do: Identify again from data with more degrees of freedom.
# Example: a parameters.json whose `covariance` is empty
given-without-covariance = the parameters have no covariance
    .hint = identify again from more data: the identification had no degrees of freedom

# Means: The given parameters lack the base or targets of the observations.
# Matters: The positions of this base or of these targets are unknown.
# Do: Observe the targets of the calibration, at the same positions on the moving part.
# Example: a new reflector on the flange
calibrated-targets-missing = the parameters lack { $names }: the observations have another base or other targets
    .hint = observe the targets of the calibration, at the same positions on the moving part

# Means: parameters.json and robot.toml describe different robots.
# Matters: The parameters have no meaning for this robot.
# Do: Name the robot.toml with which the parameters were identified.
# Example: parameters of a `serial` arm with a `prexyt`
parameters-of-other-robot = the parameters are those of a `{ $identified }`; robot.toml describes another robot (`{ $stated }`)
    .hint = name the robot.toml with which they were identified

parameters-lacking = the parameters lack { $names }; name the robot.toml with which they were identified

# Means: parameters.json has parameters of the robot that robot.toml does not describe.
# Matters: Poses would be computed without these parameters, for another robot.
# Do: Add the lines that the hint names, or name the robot.toml of the identification.
# Example: parameters with `bending_2`, robot.toml without `bending`
parameters-undescribed = the parameters hold { $names }, which robot.toml does not describe
    .hint = name the robot.toml with which they were identified

add-lines = add { $lines } to robot.toml, before its first table

# Means: A nominal value in robot.toml differs from the value used in the identification.
# Matters: The parameters are probably those of another robot, or robot.toml has been edited since.
# Do: Check that the parameters are those of this robot.
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
    .hint = check that the parameters are those of this robot

# Means: robot.toml describes another geometry than the robot whose parameters were identified: with
# equal values of all parameters, the flanges of the two robots are apart.
# Matters: The parameters are deviations of the identified robot. They do not correct this one.
# Do: Name the robot.toml of the identification, or identify again with this one.
# Example: a robot in screw axes (`poe`) whose fourth axis was moved by 10 mm after the run
robot-geometry-changed = robot.toml describes another geometry than that of the identification: { $case ->
        [apart] with equal parameters, the flanges are { $distance_mm } mm apart
       *[other] joints or links differ
    }
    .hint = name the robot.toml with which the parameters were identified, or identify again

# Means: robot.toml differs from the file that the identification used. parameters.json is from an
# earlier version and stores no flange positions to compare.
# Matters: Nominal geometry outside the parameters may differ, for example screw axes (`poe`).
# Do: Run the campaign again: the new parameters.json is compared with robot.toml.
# Example: parameters.json of version 0.1, and a robot.toml that was edited since
robot-geometry-unknown = robot.toml is not a file of the identification, and parameters.json holds no geometry to compare it with
    .hint = check that robot.toml describes the identified robot, or run the campaign again

# Means: parameters.json gives no standard uncertainty of a coordinate, and its residuals do not
# determine one.
# Matters: Expected deviations of new measurements are unknown.
# Do: Identify with a stated standard uncertainty.
# Example: a parameters.json with `degrees_of_freedom` 0 and without a stated uncertainty
calibration-without-residuals = the calibration does not determine the standard uncertainty of a coordinate
    .hint = identify with a stated standard uncertainty

# Means: An effect that is not identified would reduce the error at left-out calibration poses
# significantly.
# Matters: The robot has this effect; with it, the parameters describe the robot better.
# Do: Add the line to robot.toml, or the effect to `effects` in [identify].
# Example: a geared arm with eccentric gears, identified by geometry alone
effect-would-prove = significant effect: { $effect }{ $count ->
        [0] {""}
       *[other] {" "}of joints { $joints }
    }; with it, the error at left-out calibration poses falls from { FIXED($without_mm, 3) } to { FIXED($with_mm, 3) } mm (position, root mean square)
    .hint = add "{ $effect }" to `effects` in [identify], or set `effects = "proven"`

# Means: `outliers = "exclude"` would leave out more than a tenth of all readings.
# Matters: So many readings are not outliers: the model or the set-up is wrong.
# Do: Check the readings that `outliers = "keep"` reports.
# Example: 16 of 80 readings that are off by 1 mm
outliers-too-many = `outliers = "exclude"` would leave out more than { $share_percent } % of all readings
    .hint = the model or the set-up is wrong: check the readings that `outliers = "keep"` reports

# Means: Residuals of identification with one log correlate with the difference between the two
# logs.
# Matters: The other log describes the pose of the robot better, for example encoder values instead
# of commanded ones.
# Do: Identify with the log that gives smaller residuals.
# Example: commanded joints beside encoder values
log-correlates = with log `{ $log }`, residuals correlate with the difference of the two logs (r = { FIXED($correlation, 2) }): residuals { FIXED($rms_mm, 3) } mm (root mean square), with log `{ $other }` { FIXED($other_rms_mm, 3) } mm

use-log = { $hint ->
        [name-first] identify with log `{ $log }`: give it first
       *[is-used] log `{ $log }` is the better one, and this campaign uses it
    }

# Means: `calibration` or `validation` names a pose without measurements and joint values.
# Matters: The set is smaller than stated.
# Do: Correct the name, or measure the pose.
# Example: `calibration = "1-40, hom"` with the pose `home`
selected-pose-unmeasured = `{ $pose }` does not name a measured pose

# Means: `calibration` or `validation` selects none of the measured poses.
# Matters: Identification or validation has no poses.
# Do: Select poses that were measured.
# Example: `calibration = "100-200"` of poses 1 to 50
selection-without-pose = `{ $set }` selects no measured pose

# Means: Poses are both in calibration and in validation.
# Matters: Errors at calibration poses are too small for a validation.
# Do: Put each pose into one set.
# Example: `calibration = "1-40"`, `validation = "30-50"`
sets-overlap = poses in both calibration and validation: { $poses }
    .hint = `validation = "rest"` selects all poses that calibration does not use

# Means: A pose is in several series.
# Matters: The scatter between series compares separate poses.
# Do: Put each pose into one series.
# Example: `series = ["1-40", "30-50"]`
series-overlap = poses in several series: { $poses }
    .hint = put each pose into one series

# Means: A series holds no calibration pose: its poses are for validation, or excluded.
# Matters: The scatter between series compares calibration poses, so this series does not count.
# Do: Nothing, or let the calibration use poses of it.
# Example: `calibration = "1-40"`, `series = ["1-20", "21-40", "41-60"]`
series-without-calibration = series without a calibration pose, which do not count: { $series }

# Means: `series` is given, and no series contains these calibration poses.
# Matters: The scatter between series compares all calibration poses.
# Do: Add the poses to their series, or `"rest"` as the last series.
# Example: `series = ["1-40", "41-80"]` with 90 poses
series-incomplete = calibration poses in no series: { $poses }
    .hint = `"rest"` selects all poses of no earlier series

# Means: All calibration poses are in one series.
# Matters: One series shows no scatter between series, so the uncertainties would not contain it.
# Do: Give the poses of each set-up, day or file, or remove `series`.
# Example: `series = ["all"]`
series-single = `series` has a single series with calibration poses
    .hint = give at least two, or remove `series`

# Means: A table of the geometric report selects no pose of calibration or validation.
# Matters: The table would be empty.
# Do: Select poses of these sets.
# Example: `poses = "100-110"` of poses 1 to 50
table-selection-empty = the table `{ $title }` has no measured pose
    .hint = select poses of `calibration` and `validation`

poses-measured = { $count ->
        [one] 1 pose is
       *[other] { $count } poses are
    } measured and joined, from { $first } to { $last }

poses-unmeasured = no pose is measured and joined

at-pose = pose { $pose }: { $message }

values-of-column = { $message } (as are { $count } of { $total } values)

check-column-unit = check the unit of its column: all values are in range in { $units ->
        [degrees] degrees instead of radians
       *[millimetres] millimetres instead of metres
    }

# Means: A joint value is beyond the limits of robot.toml, beyond two turns, or far from all others
# of its column.
# Matters: A decimal mark is missing, or the unit is wrong. A gain would absorb such a value
# unnoticed.
# Do: Check decimal mark and unit; if the joint can reach the value, state or correct its limits in
# robot.toml.
# Example: `179500` for 179.500 deg
joint-out-of-range = joint `{ $joint }` = { $value } { $unit } is out of range
    .expected = from { $lower } to { $upper } { $unit }: { $reason ->
            [limits] the limits of the robot file, beyond which 1 % of their distance is allowed
            [turns] two turns, because the robot file gives no limits
           *[others] range of the other values
        }
    .hint = check its decimal mark and unit; if the joint can reach this value, { $reason ->
            [limits] correct its limits in the robot file
           *[others] give its limits in the robot file
        }

# Means: Errors common to all readings (scale, temperature, homing) are given, but the observations
# contain more than positions of targets.
# Matters: `etalon uncertainty` draws common errors for positions only.
# Do: Use the uncertainties of `etalon run`, which propagates them linearly.
# Example: `expanded_scale_uncertainty_um_per_m` for a campaign of distances
common-errors-of-conditions = errors common to all readings (scale, temperature, homing) are drawn for positions of targets only
    .hint = `etalon run` gives the uncertainties of this campaign by linear propagation

# Means: The points of a feature are centres of a probe, and the file gives neither radius nor side
# of the probe.
# Matters: The feature is offset from these points by the probe radius, to an unknown side.
# Do: Give the option that the hint names.
# Example: a QIF file with centre points and without a sensor
probe-of-feature-unknown = `{ $feature }` is not fitted: its points are probe centres, and the file does not set { $missing ->
        [side] the side of the probe
       *[radius] the radius of the probe
    }
    .hint = { $missing ->
            [side] give it: --probe-side inside, outside or x,y,z
           *[radius] give it: --probe-radius-mm
        }

unstable-parameter = `{ $parameter }` ({ FIXED($over_sd, 1) }, limit { FIXED($limit, 1) })

# Means: Parameters identified from a part of the poses differ significantly from the parameters of
# all poses.
# Matters: Something changed during the measurement, so the values suit only a part of the poses.
# They are loaded all the same, because errors at left-out poses are larger without them.
# Do: Check for changes (temperature, a target that moved, a joint that was homed again), and check
# the residuals.
# Example: a reflector that moved after half of the poses
parameters-unstable = unstable parameters; differences between a part of the poses and all poses, in standard deviations of the difference: { $parameters }
    .hint = check for changes during the measurement (temperature, a target that moved, a joint that was homed again), and check the residuals

remedy = { $remedy ->
        [pose-uncertainty] give it (--standard-uncertainty-um), or compare targets
        [contact-uncertainty] give the repeatability of the contact (--standard-uncertainty-um) too, and compare targets
        [compare-targets] use `residuals = "targets"`
        [targets] state positions of its targets: rows of kind `point`
        [uncertainty] give it (--standard-uncertainty-um)
        [own-uncertainties] compare targets, or remove the columns of uncertainties
        [row-uncertainty] give it in every row, or with --standard-uncertainty-um
        [part] `frame` is `flange` for an arm, `platform` for a PreXYT, `targets` for any robot
        [positions] choose more positions, or hold parameters with `--hold`
        [hold-fewer] hold fewer parameters, and measure more poses
        [more-poses] measure more poses (repeats of a pose add nothing), or hold parameters with `hold` in [identify] or --hold
        [hold] hold parameters in [identify], or measure more poses
        [unreachable] check unit (degrees or radians), sign and offset of the joints, and the nominal parameters
        [extent] check `unit` of the exports, the units of the joints in the log, and the lengths of the robot
        [readings] check these readings and the order of the rows of the log, or omit these poses (`exclude`, --exclude)
        [assembly] correct the column `assembly` of these poses, or leave it empty: the mode is then taken from the measurement
       *[joints] check units, order and signs of the joints and the nominal parameters; `hold` in [identify] holds parameters
    }

reading-off = { FIXED($off_mm, 4) } mm ({ $target }, pose { $pose }, cycle { $cycle })

# Means: The residuals exceed the instrument's uncertainty, and a robust fit has no outliers. These
# are its largest residuals.
# Matters: Errors of the robot affect all poses; wrong readings affect single ones.
# Do: Check these readings first for exchanged labels and mistakes.
# Example: a robot with gear errors that are not modelled
largest-residuals = largest residuals of a robust fit: { $readings }
    .hint = check these readings first for exchanged labels and mistakes; errors of the robot affect all poses

outlier-readings = { $count ->
        [one] 1 of { $total } readings is an outlier
       *[other] { $count } of { $total } readings are outliers
    }, more than { $times } times { FIXED($scale_mm, 4) } mm, the standard deviation of the others in a robust fit: { $readings }

# Means: Residuals of a robust fit exceed a multiple of the standard deviation of the others.
# Matters: Wrong readings distort all parameters.
# Do: Check these readings for exchanged labels and mistakes; measure them again, or exclude them
# with `exclude` in [identify].
# Example: a reflector measured under the name of its neighbour
outliers = { $outliers }

# Means: `outliers = "exclude"` excluded readings from the calibration.
# Matters: They do not take part in the result.
# Do: Check these readings: an outlier can also be an error of the robot at one pose.
# Example: `outliers = "exclude"` with one wrong reading
outliers-excluded = excluded by `outliers = "exclude"`: { $outliers }

repeated-position = { $target } at poses { $first } and { $second }

# Means: A target has the same coordinates to the last digit at two poses, although the nominal
# robot moves it between them.
# Matters: No instrument repeats to the last digit: one of the readings is that of another pose.
# Do: Measure the pose again, or exclude the reading.
# Example: a reading that was exported twice
positions-repeat = measured positions repeat to the last digit while the joints move, { $count ->
        [one] once
       *[other] { $count } times
    }: { $pairs }
    .hint = the export has a reading of another pose: measure these poses again, or exclude them

repeated-joints = poses { $first } and { $second }, { FIXED($apart_mm, 3) } mm apart

# Means: Two poses have the same joint values to the last digit, although a target moved between
# them.
# Matters: One row of the log is that of another pose.
# Do: Log the joints of this pose again, or exclude the pose.
# Example: a log whose recorder stopped for one pose
joint-values-repeat = joint values repeat to the last digit while the targets move, { $count ->
        [one] once
       *[other] { $count } times
    }: { $pairs }
    .hint = the log has the joint values of another pose: log these poses again, or exclude them

# Means: The scatter of a fixed point exceeds the uncertainty of the instrument.
# Matters: Features and frames defined by this point are less accurate than stated.
# Do: Check `unit` of the export and the uncertainty of the instrument, and that the point did not
# move.
# Example: an uncertainty of 15 µm stated for an arm with 60 µm
repeats-scatter = repeats of `{ $label }` lie up to { FIXED($off_mm, 4) } mm from their median; standard uncertainty of the instrument { FIXED($u_mm, 4) } mm
    .hint = check `unit` of the export and the uncertainty of the instrument, and that the point did not move

# Means: One or a few repeats of a fixed point are far from the others.
# Matters: Features and frames defined by this point, and every result, depend on it.
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

# Means: Standard uncertainties of rows are 0, because the file rounds them. They are taken as the
# resolution of the column, half of the last digit over √3 (GUM 4.3.7).
# Matters: A reading without uncertainty would outweigh all others.
# Do: Export uncertainties with more decimals.
# Example: `0.00` in a column with two decimals
uncertainty-zero-rounded = `{ $column }` is 0 in { $count ->
        [one] 1 row
       *[other] { $count } rows
    }: rounded, and taken as the resolution of the column, u = { $u } { $unit } (half of the last digit over √3)
    .hint = export uncertainties with more decimals

# Means: Standard uncertainties of rows are 0, and the column does not show its resolution.
# Matters: A reading without uncertainty would outweigh all others; the uncertainty of the
# instrument is used instead.
# Do: Export uncertainties with more decimals.
# Example: a column that is 0 in all rows
uncertainty-zero = `{ $column }` is 0 in { $count ->
        [one] 1 row
       *[other] { $count } rows
    }, and its resolution is unknown: the uncertainty of the instrument is used instead
    .hint = export uncertainties with more decimals

# Means: A key for delimited text is given for a sheet of a workbook or a topic of a recording.
# Matters: Their cells have no delimiter and no encoding, and numbers of a recording no marks.
# Do: Remove the key.
# Example: `delimiter = ";"` with `sheet`
key-of-text-table = `{ $key }` has no effect on a sheet of a workbook or a topic of a recording
    .hint = remove `{ $key }`: it applies to delimited text only

# Means: Errors of the identified robot exceed 2 % of the spread of the measured positions.
# Matters: Errors of a calibrated robot are thousandths of the workspace: these are not measurements
# of this robot at these joint values.
# Do: Follow the hint; it names a cause only if the errors show the cause.
# Example: a log of another campaign
measurements-undescribed = on the { $set ->
        [validation] validation
       *[calibration] calibration
    } poses errors are { FIXED($after_mm, 3) } mm (root mean square), and positions spread over { FIXED($spread_mm, 1) } mm; { $count } of { $total } errors exceed { FIXED($limit_mm, 1) } mm: the model does not describe these measurements

undescribed-targets = every reading of { $targets } has a large error, and no other reading has: check labels, and whether the target moved

undescribed-readings = { $readings }: { $remedy }

undescribed-set-up = check units, order and signs of the joints, the nominal parameters, and the join of log and points

undescribed-frame-moved = one motion of the frame by { FIXED($motion_mm, 1) } mm leaves { FIXED($left_mm, 3) } mm: base or measuring system has moved between calibration and validation poses

undescribed-unchecked = the calibration poses have no redundant coordinate: other positions of base and targets fit equally well; measure more calibration poses, spread over the workspace

undescribed-other-poses = the calibration poses fit, but no motion of the frame explains the others: check that log and exports of the validation poses belong together (not a log of another campaign, or another numbering of poses)

# Means: `--frames prior` is given for nominal parameters.
# Matters: This mode weights base and targets by the covariance of identified parameters.
# Do: Give identified parameters, or fit base and targets again.
# Example: `etalon validate --frames prior` without `--parameters`
prior-of-nominal = nominal parameters have no covariance for `--frames prior`
    .hint = state identified parameters with `--parameters`, or use `--frames refit`

# Means: `--frames prior` is given for a table that contains more than positions.
# Matters: This mode is available for measured positions only.
# Do: Remove rows of other kinds, or fit base and targets again.
# Example: `--frames prior` with distances
prior-of-conditions = `--frames prior` is for measured positions only
    .hint = remove rows of other kinds, or fit base and targets again: `--frames refit`

# Means: `--frames given` needs nominal values of base and targets, and one of them is missing.
# Matters: The position is unknown.
# Do: Fit base and targets to the calibration poses.
# Example: `--frames given` with nominal parameters of an arm
place-without-nominal = `{ $parameter }` has no nominal value: only measurements determine it
    .hint = fit base and targets to the calibration poses: `--frames refit`

# Means: Errors with the given parameters are larger than with nominal parameters.
# Matters: The parameters are probably those of another robot, or base and targets have moved since.
# Do: Check that the parameters are those of this robot, and whether base and targets are those of
# this campaign (`--frames`).
# Example: parameters of the neighbouring robot
given-parameters-worse = errors with the given parameters are { FIXED($given_mm, 3) } mm, with nominal parameters { FIXED($nominal_mm, 3) } mm (root mean square)
    .hint = check that the parameters are those of this robot, and whether base and targets are those of this campaign (`--frames`)

# Means: The number of poses to choose is zero, or exceeds the number of candidates.
# Matters: The plan cannot be made.
# Do: Give fewer `--positions`, or more candidates.
# Example: `--positions 20` of 12 candidates
candidate-poses-too-few = { $wanted } of { $count } candidate poses cannot be chosen
    .hint = state fewer `--positions`, or more candidates

# Means: If the names of two targets are exchanged, the residuals fall to less than a tenth.
# Matters: Each target was measured under the name of the other.
# Do: Exchange the two names in the export.
# Example: SMR_1 and SMR_2 with exchanged names
target-names-exchanged = with the names of targets `{ $first }` and `{ $second }` exchanged, the residuals fall from { FIXED($before_mm, 3) } to { FIXED($left_mm, 3) } mm
    .hint = exchange the two names in the export

# Means: The observations contradict the parameters, but without one pose they agree.
# Matters: This pose was probably measured or logged wrongly.
# Do: Measure the pose again, and log its joints again.
# Example: a verification pose with the joints of another pose
one-pose-contradicts = without pose `{ $pose }` the observations do not contradict the parameters
    .hint = measure this pose again, and log its joints again

# Means: The observations contradict the parameters, but without one reading they agree.
# Matters: This reading is probably wrong. The other targets of the pose agree with its joints.
# Do: Measure this target at this pose again.
# Example: a reflector that was not seated at one pose
one-reading-contradicts = without target `{ $target }` at pose `{ $pose }` the observations do not contradict the parameters
    .hint = measure this target at this pose again

# Means: With other names of the targets the residuals fall to less than a tenth.
# Matters: Each target was measured under the name of another one.
# Do: Correct the names in the export.
# Example: SMR_1, SMR_2 and SMR_3 measured as SMR_2, SMR_3 and SMR_1
target-names-permuted = with the names of the targets as { $names }, the residuals fall from { FIXED($before_mm, 3) } to { FIXED($left_mm, 3) } mm
    .hint = correct the names in the export

# Means: Several motions (of the base, of the zero of a joint, of a target) explain the residuals of
# a verification.
# Matters: The data do not show which of them occurred.
# Do: Observe poses with larger differences of the joint values.
# Example: a verification at one pose
motions-alike = { $count ->
        [one] 1 other motion explains
       *[other] { $count } other motions explain
    } these residuals too: { $motions }
    .hint = observe poses with larger differences of the joint values

# Means: The calibration poses do not have more coordinates than parameters.
# Matters: Residuals are zero for any measurement, so the parameters are unchecked.
# Do: Measure more poses, spread over the workspace.
# Example: 12 parameters of a planar robot from three poses with two balls
no-coordinates-to-check = { $count ->
        [one] 1 coordinate
       *[other] { $count } coordinates
    } of the calibration poses for { $parameters ->
        [one] 1 parameter
       *[other] { $parameters } parameters
    }: the parameters are unchecked
    .hint = measure more poses, spread over the workspace

# Means: A few errors at validation poses exceed a multiple of the median error.
# Matters: They contribute to the stated accuracy, and are probably wrong readings.
# Do: Check these readings for exchanged labels and mistakes; measure them again, or exclude them
# with `exclude` in [identify].
# Example: one validation pose logged wrongly
validation-outliers = { $count } of { $total } validation errors exceed { FIXED($limit_mm, 4) } mm, { $times } times their median: { $readings }

# Means: All identified lengths differ significantly from their nominal values by one factor.
# Matters: A scale error of the measuring system or of the joints is more probable than errors of so
# many parts.
# Do: Check scale, temperature compensation and unit of the measuring system and of the encoders.
# Example: an instrument without temperature compensation
common-scale = { $parameters } are all about { FIXED($factor, 5) } times nominal: a scale error of the measuring system or of the joints explains this, rather than errors of { $count } parts
    .hint = check scale, temperature compensation and unit of the measuring system and of the encoders

# Means: The identified compliance of a joint is negative, by more than three standard
# uncertainties.
# Matters: No material bends against its load: gravity or the axis of the joint has the wrong
# direction.
# Do: Check `gravity` and the direction of the joint’s axis in robot.toml.
# Example: `gravity = [0, 0, 1]` of a standing robot
compliance-negative = `{ $parameter }` is negative ({ FIXED($value, 5) } { $unit }): the joint bends against gravity
    .hint = check `gravity` and the direction of the joint’s axis in robot.toml

# Means: The bending under the stated loads contradicts the measurements, and one change of the stated centre of mass explains them.
# Matters: The compliance is wrong, and errors under load remain.
# Do: Compare the columns of the load with the data sheet of the load: axes of the flange, signs, unit.
# Example: `load_x_mm` and `load_z_mm` exchanged
load-columns-slip = the stated centres of mass contradict the measurements ({ FIXED($over_u, 1) } standard uncertainties); { $count ->
        [one] one change explains them: { $changes }
       *[other] each of these changes explains them: { $changes }
    }
    .hint = compare the columns of the load with its data sheet: axes of the flange, signs, unit

load-change-exchanged = `{ $first }` and `{ $second }` are exchanged

load-change-sign = `{ $column }` has the other sign

load-change-unit = the centre of mass is in { $unit }

# Means: The identified backlash of a joint is negative, by more than three standard uncertainties.
# Matters: A joint cannot be ahead of its drive: the directions of approach have the wrong sign, or
# belong to another motion.
# Do: Check the sign of the directions, and that the times of the log belong to the same motion.
# Example: direction -1 stated where the joint value increased
backlash-negative = `{ $parameter }` is negative ({ FIXED($value, 5) } { $unit }): the joint would be ahead of its drive
    .hint = check the sign of the directions of approach (+1 if the joint value increased, -1 if it decreased), and that the times of the log belong to the same motion

# Means: The stated torque of a joint has the same value in all calibration readings.
# Matters: A constant torque deflects the joint by a constant angle, which is a part of its zero; the
# compliance of the joint cannot be determined and is held.
# Do: Nothing, if the joint carries no load, such as the vertical first axis of a standing robot.
# Otherwise measure other poses or other loads, or check the column.
# Example: `torque = [1, 2, 3]` of a standing robot, whose first axis carries no torque
torque-constant = the torque of joint `{ $joint }` is { FIXED($value, 3) } N·m in all calibration readings (`{ $column }`): it cannot be told from the zero of the joint, and the compliance of this joint is held

# Means: The compliances of joints under their torques have different signs, each by more than three
# standard uncertainties.
# Matters: All joints yield in the same manner: against the torques of the drives, or with those of
# the load. Different signs show that torques have different signs, or belong to other joints.
# Do: Check the sign and the order of the columns of torques.
# Example: `tau3_nm` of the drive beside `tau2_nm` of the load
torque-signs-differ = identified bending under torque is positive for { $positive } and negative for { $negative }: some joints yield with the stated torque, others against it
    .hint = check the sign and the order of the columns of torques

# Means: With the torques of two joints exchanged, the residuals agree with the uncertainty of the
# instrument; as given, they do not.
# Matters: Torques of another joint do not describe the deflection.
# Do: Check which joint each column belongs to.
# Example: the columns `tau2_nm` and `tau3_nm` exchanged
torques-exchanged = the model fits the readings with `{ $first }` and `{ $second }` exchanged, but not as given
    .hint = check which joint each column of torques belongs to

# Means: All calibration readings give the same temperature of the robot.
# Matters: The change of lengths and zeros with the temperature cannot be determined; the parameters
# hold at the stated temperature alone.
# Do: Measure the cold and the warm robot, or remove `drift` and `expansion` from robot.toml.
# Example: 20.0 in each cell of `temperature_c`
temperature-constant = the temperature is { FIXED($value, 1) } °C in all calibration readings: expansion and drift cannot be determined and are held; lengths and zeros are those at this temperature

# Means: The stated temperatures of the robot are not those of a workshop.
# Matters: In another unit, expansion and drift are those of another difference, and lengths and zeros
# refer to another temperature than the stated one. The values are used as they are.
# Do: Check the unit of the column `temperature_c`. In a cold store the values are right: keep them.
# Example: 68 to 86, which are degrees Fahrenheit
temperature-questioned = the temperatures of the calibration readings are { FIXED($low, 1) } to { FIXED($high, 1) } °C, outside { $least } to { $most } °C

temperature-units = check the unit: read as °F they are { FIXED($from_fahrenheit, 1) } to { FIXED($to_fahrenheit, 1) } °C, read as K { FIXED($from_kelvin, 1) } to { FIXED($to_kelvin, 1) } °C

# Means: The identified distance of the balls K and L has the opposite sign of its nominal value.
# Matters: Each ball was measured under the name of the other.
# Do: Exchange the names of the two targets in the labels of the export.
# Example: K and L with exchanged names
ball-names-exchanged = `{ $parameter }`, the distance of K and L, is { FIXED($value, 3) } { $unit }: K and L are exchanged
    .hint = exchange the names of the two targets in the labels of the export

# Means: The identified robot has larger errors than the nominal robot on a set of poses.
# Matters: The parameters fit the noise of too few poses, and must not reach a controller.
# Do: Measure more poses, spread over the workspace, or hold parameters that the poses do not
# determine.
# Example: 30 parameters identified from ten poses in one corner
identified-worse-than-nominal = on the { $set ->
        [validation] validation
       *[calibration] calibration
    } poses the identified robot is worse than the nominal one: { FIXED($before_mm, 4) } mm before, { FIXED($after_mm, 4) } mm after (root mean square)
    .hint = measure more poses, spread over the workspace, or hold parameters that the poses do not determine

value-beyond-tolerance = `{ $parameter }` = { $unit ->
        [mm] { FIXED($value, 3) } { $unit } (nominal { $nominal } { $unit }, tolerance { FIXED($tolerance, 3) } { $unit })
        [deg] { FIXED($value, 3) } { $unit } (nominal { $nominal } { $unit }, tolerance { FIXED($tolerance, 3) } { $unit })
       *[other] { FIXED($value, 4) } (nominal { $nominal }, tolerance { FIXED($tolerance, 3) })
    }

# Means: The data alone put parameters beyond their stated tolerance, by more than twice their
# standard uncertainty.
# Matters: No real robot deviates so far: a sign, unit, order of joints, nominal value or frame is
# wrong. The parameters must not reach a controller.
# Do: Check signs, units and order of the joints, the nominal values, and the frames; if the robot
# has larger tolerances, set `tolerance` in the robot file.
# Example: joint 2 logged with the opposite sign
tolerance-exceeded = { $count ->
        [one] 1 parameter is
       *[other] { $count } parameters are
    } beyond the tolerance of the robot: { $parameters }
    .hint = check signs, units and order of the joints, the nominal values, and the frames; if the robot has larger tolerances, set `tolerance` in the robot file

format-not-identified = parameters of the format `{ $format }` could not be identified again: { $message }

# Means: The clocks drift apart: no offset alone puts every measured point into a standstill. Offset
# and rate were determined together.
# Matters: Each point has the joint values of its standstill. The rate is within 100 ppm, as for
# crystal clocks: the log of another run does not fit.
# Do: Nothing, if all points were measured during standstills. Synchronise the clocks next time.
# Example: `clock_rate = "standstills"` for an instrument and a controller that run for an hour
clock-rate-from-standstills = the clock of the measurement runs { FIXED($rate_ppm, 1) } ppm ± { FIXED($u_ppm, 1) } ppm (k = 1) relative to the clock of log `{ $log }` (possible: { FIXED($low_ppm, 1) } to { FIXED($high_ppm, 1) } ppm); offset { FIXED($offset_s, 3) } s ± { FIXED($u_s, 3) } s (k = 1) at { FIXED($reference_s, 3) } s of the log
    .hint = with this offset and rate every measured point falls into a standstill; no offset alone does so

# Means: An offset alone puts every measured point into a standstill: the rates of the clocks may be
# equal.
# Matters: The rate is not applied. The true rate is within the stated range.
# Do: Omit `clock_rate`.
# Example: clocks that differ by 5 ppm, and a measurement of ten minutes
clock-rate-insignificant = the standstills of log `{ $log }` show no significant difference of the clock rates: the difference is between { FIXED($low_ppm, 1) } and { FIXED($high_ppm, 1) } ppm
    .hint = omit `clock_rate`: only the offset is used

# Means: The offset of the clocks was determined from the speeds of a motion that the instrument and
# the controller recorded, and with `clock_rate` their rate.
# Matters: Each point has the joint values at its time. The uncertainty follows from the differences of
# the speeds; a rate within two standard uncertainties is not applied.
# Do: Nothing, if the correlation is near 1. Trigger both recordings together next time.
# Example: `clock_offset_s = "motion"` for a tracker that follows a moving robot
clock-from-motion = the clock of log `{ $log }` is set by the speeds of the motion (correlation { FIXED($correlation, 3) }): offset { FIXED($offset_s, 4) } s ± { FIXED($u_s, 4) } s (k = 1) at { FIXED($reference_s, 3) } s of the log, rate { FIXED($rate_ppm, 1) } ppm ± { FIXED($u_ppm, 1) } ppm (k = 1)
    .hint = the points are joined with the rows of the log at these times

# Means: The measured speeds of the targets and their speeds by the joint values do not correlate.
# Matters: The clocks cannot be compared by this motion.
# Do: Check that log and export are of one motion, and that units, joints and targets are right.
# Example: the log of another run
clock-motion-unlike = the speeds of points and log do not correlate at any offset of the clocks: at most { FIXED($correlation, 2) }
    .hint = check that log and points are of the same motion, or set `clock_offset_s` as a number

# Means: A motion that repeats itself has the same speeds at several offsets of the clocks.
# Matters: Only one of these offsets is right.
# Do: Record a motion that does not repeat itself, or compare the clocks once.
# Example: a robot that swings to and fro
clock-motion-several = the speeds of points and log correlate at { $count } offsets of the clocks: { $ranges }
    .hint = record a motion that does not repeat itself, or set `clock_offset_s` as a number

# Means: Too few speeds are recorded for a comparison of the clocks.
# Matters: The offset of the clocks is not determined.
# Do: Record points and joint values during a motion.
# Example: `clock_offset_s = "motion"` for ten points at standstill
clock-motion-short = { $count ->
        [one] 1 measured speed is
       *[other] { $count } measured speeds are
    } too few to compare the clocks by their motion
    .expected = at least 20 speeds, in the points and in the log

# Means: No offset and rate of the clocks put every measured point into a standstill.
# Matters: A point was measured in motion, the log lacks a standstill, or it is the log of another
# run. Quartz clocks differ by less than the stated rate.
# Do: Check that the log belongs to the measurement, and remove points measured in motion.
# Example: the log of yesterday's run
clock-rate-none = no offset of the clocks and no rate within ± { $most_ppm } ppm put every measured point into a standstill of the log
    .hint = check that the log belongs to this measurement, and remove points measured in motion; or set `clock_offset_s` as a number
# Means: A limit is given, and the poses that decide do not show its quantity.
# Matters: The limit is undecided, and the exit code is 1.
# Do: Measure the quantity at the validation poses, or remove the limit.
# Example: `position_max_mm` for a campaign of draw wires
limit-not-assessable = limit `{ $limit }` cannot be assessed: the poses that decide do not show its quantity
    .hint = measure the quantity at these poses, or remove the limit from [limits]
# Means: An option names a joint that has neither a sweep nor a column of values in the table.
# Matters: The order of the joints, or a statement about a joint, would be wrong.
# Do: Write the name as in the column `joint`.
# Example: `--prismatic Z` for a table with the joints q1 to q4
sweep-joint-unknown = `{ $joint }` is not a joint of these sweeps
    .expected = { $known }

# Means: The names of the joints have no numbers, so that their order from the base is unknown.
# Matters: Axes in another order form another robot.
# Do: Give the order from the base.
# Example: sweeps of the axes X, Y, Z and C of a gantry
sweep-order-missing = the order of the joints { $joints } from the base is unknown
    .hint = give it: --joints NAME,...

# Means: Two columns contain values of the same joint.
# Matters: It is unknown which column applies.
# Do: Remove or rename one of the columns.
# Example: q1_deg and q1_rad in one table
sweep-joint-column-twice = two columns have values of joint `{ $joint }`
    .hint = remove one of them

# Means: Joint values are missing in a row, in some sweeps, or at a check pose.
# Matters: The missing values would have to be guessed.
# Do: Give the values of all joints in every row, or at check poses only.
# Example: an empty cell in the column q4_deg
sweep-values-partial = joint values are incomplete
    .expected = values of all joints in every row, or in no row of a sweep
    .hint = a row without a swept joint is a check pose and needs the values of all joints

# Means: `--backwards` is given for a joint, and the table has joint values.
# Matters: The joint values already determine the sign.
# Do: Omit the option.
# Example: `--backwards q2` with a column q2_deg
sweep-sign-by-values = the joint values already determine the direction of each sweep
    .hint = omit --backwards

# Means: Rows name one joint as the swept joint, but the values of another joint change.
# Matters: The axis would belong to another joint.
# Do: Correct the column `joint`, or the headings of the columns of joint values.
# Example: the sweep of q3 under the name of q2
sweep-other-joint = `{ $moved }` moves in the sweep of `{ $joint }`, which is at rest
    .hint = correct the column `joint`, or the headings of the joint values

# Means: A second joint moves during the sweep of a joint.
# Matters: The paths are not circles or lines; the axis would belong to neither joint.
# Do: Measure the sweep again with all other joints at rest.
# Example: a sweep of joint 1 during which joint 2 turns by a tenth of its angle
sweep-two-joints = `{ $also }` also moves in the sweep of `{ $joint }`, by { $by }
    .hint = measure the sweep again with all other joints at rest

sweep-by-angle = { FIXED($by, 3) } deg

sweep-by-length = { FIXED($by, 3) } mm

# Means: The motion of the targets about or along the axis differs from the joint value.
# Matters: The joint value has another unit or is that of a motor, or another joint moves too. The
# zero of the joint would be wrong.
# Do: Correct the unit in the heading, or compute the column: `--column "q1_deg=motor1/100"`.
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

# Means: Before and after a row, the readings of a target are on two different paths about one axis.
# Matters: The target slipped in its seat, or the base or the instrument moved.
# Do: Measure the sweep again, or give the target another name from this row on.
# Example: a reflector that moves by 0.5 mm during the sweep
sweep-target-moved = target `{ $target }` moved in the sweep of `{ $joint }` before row { $row }: deviation from one path { FIXED($before_um, 1) } µm, from two paths { FIXED($after_um, 1) } µm
    .hint = measure the sweep again, or give the target another name from this row on

# Means: Many readings are far from the path of the majority.
# Matters: The path of the majority may be the wrong one.
# Do: Check for a second joint that moved, a reflector that turned away, or rows of another sweep.
# Example: 5 of 24 readings that are off by 0.7 mm
sweep-many-foreign = { $aside } of { $readings } readings of the sweep of `{ $joint }` are not on the path of the others
    .hint = check for a second joint that moved, or for rows of another sweep

# Means: Some readings are much farther from the path than noise explains.
# Matters: They are not used for the axis.
# Do: Check these rows; remove them if the cause is known.
# Example: a reading of another reflector
sweep-foreign = { $count ->
        [one] 1 reading of the sweep of `{ $joint }` is excluded: line { $lines }
       *[other] { $count } readings of the sweep of `{ $joint }` are excluded: lines { $lines }
    }
    .hint = check these lines: the readings are far from the path of all others

# Means: Readings deviate from their path by much more than neighbouring readings differ: the
# deviation is smooth, not noise.
# Matters: Possible causes are run-out of the bearing, a wave of the gear, motion of another joint,
# or bending of a part. The uncertainty of the axis includes the deviations as harmonics of a turn.
# Do: Check that all other joints were at rest; compare the deviations with the run-out of the
# bearing.
# Example: a wobble of 0.15 mm with nine periods a turn
sweep-smooth = the targets deviate smoothly from their path in the sweep of `{ $joint }`, by { FIXED($rms_um, 1) } µm (root mean square); the noise from reading to reading is { FIXED($noise_um, 1) } µm; the uncertainty of the axis includes both
    .hint = check that all other joints were at rest, and compare with the run-out of the bearing

# Means: The direction of an axis is poorly known.
# Matters: Predicted positions have an error of this angle times their distance from the axis.
# Do: Measure a longer arc, or a target farther from the axis.
# Example: an arc of 7 degrees
sweep-weak = the direction of the axis of `{ $joint }` has a standard uncertainty of { FIXED($u_mrad, 2) } mrad
    .hint = measure a longer arc, a target farther from the axis, or more targets

# Means: All targets are within a few millimetres of all axes.
# Matters: The coordinates are probably in metres, and are read as millimetres. The exit code is 1, and robot.toml is not written.
# Do: Check the unit of the coordinates, and convert all three columns. For a mechanism of this size use `--force`.
# Example: coordinates in metres under the heading x_mm
sweep-unit = all targets are within { FIXED($radius_mm, 3) } mm of the axes: the coordinates are probably in metres
    .hint = check the unit, and convert the columns, here x: --column 'x_mm={ $source }*1000'

# Means: A sweep has fewer readings than its axis and paths need.
# Matters: The axis cannot be determined.
# Do: Measure more readings.
# Example: two readings of one target
sweep-few = the sweep of `{ $joint }` has { $readings } readings, and needs { $needed }
    .hint = measure more readings; redundant readings determine the uncertainty

# Means: The readings of a sweep do not determine an axis: they coincide, or readings of a revolute
# joint are on a straight line.
# Matters: The axis is unknown.
# Do: Measure a longer arc or a target farther from the axis; state prismatic joints.
# Example: a target on the axis
sweep-undetermined = the readings of the sweep of `{ $joint }` do not determine an axis
    .hint = measure a longer arc or a target farther from the axis; give a prismatic joint with --prismatic

# Means: Joints have columns of values but no sweep.
# Matters: Their axes are unknown; robot.toml is not written.
# Do: Measure a sweep of each joint.
# Example: sweeps of q1 to q3, and a column of values of q4
sweep-joint-missing = { $count ->
        [one] joint { $joints } has no sweep
       *[other] joints { $joints } have no sweep
    }: robot.toml is not written
    .hint = measure a sweep in every joint

# Means: The first readings of a target differ between sweeps, although sweeps without joint values
# must start from the same pose.
# Matters: The zeros of the joints are undefined; robot.toml is not written. Each axis applies to
# the pose in which it was measured.
# Do: Start every sweep from the same pose, or add the joint values.
# Example: a target that was removed between two sweeps
sweep-starts-apart = the sweeps of `{ $first }` and `{ $second }` start { FIXED($gap_mm, 3) } mm apart at target `{ $target }`: robot.toml is not written
    .hint = start every sweep from the same pose with the target in its place, or add columns of joint values

# Means: A target occurs in check poses but in no sweep.
# Matters: Its position on the flange is unknown; robot.toml is not written.
# Do: Use targets of the sweeps.
# Example: a check pose with another reflector
sweep-target-unswept = a target of check poses is in no sweep: robot.toml is not written
    .hint = use targets of the sweeps in check poses

# Means: Sweeps or check poses agree only if two joints are exchanged.
# Matters: The robot would be wrong at every pose.
# Do: Exchange the names of the joints.
# Example: axes 4 and 5 of an arm with exchanged names
sweeps-exchanged = `{ $first }` and `{ $second }` are exchanged: positions differ by { FIXED($stated_mm, 3) } mm (root mean square) as given, and by { FIXED($left_mm, 3) } mm with the joints exchanged
    .hint = exchange their names in the column `joint` and in the headings

# Means: The check poses agree only if a joint was swept in negative direction.
# Matters: The sign of the joint would be wrong.
# Do: Give the joint in `--backwards`.
# Example: a sweep from +30 to -30 degrees without joint values
sweep-reversed = `{ $joint }` was swept in negative direction: check poses differ by { FIXED($stated_mm, 3) } mm (root mean square) as given, and by { FIXED($left_mm, 3) } mm with the other sign
    .hint = give it: --backwards { $joint }

# Means: Measured positions differ from those of the robot by more than their uncertainty.
# Matters: Possible causes are a target that moved between sweeps, bending of a joint, or errors of
# a transmission. The uncertainty of the robot is too small.
# Do: Check the seats of the targets and the joint values; start a calibration from this robot
# (`etalon identify`, `etalon run`).
# Example: a target that was moved by 1 mm between two sweeps
sweeps-disagree = { $what ->
        [checks] check poses differ from the robot by up to { FIXED($distance_mm, 3) } mm
       *[sweeps] the sweeps contradict each other by up to { FIXED($distance_mm, 3) } mm
    } (standard uncertainty { FIXED($u_mm, 4) } mm)
    .hint = check the seats of the targets and the joint values; `etalon identify` and `etalon run` can start from this robot

# Means: A Denavit-Hartenberg table has no parameters for this position of the base.
# Matters: The base of the table is rotated and shifted relative to the stated base.
# Do: Identify the base, or use `poe`.
# Example: a base whose x axis is not the common normal of its z axis and axis 1
table-base-not-held = the table has its own base, rotated by { FIXED($angle_deg, 4) } deg and shifted by { FIXED($shift_mm, 4) } mm
    .hint = identify the base, or use `poe`

# Means: A Denavit-Hartenberg table has no parameters for this position of the flange.
# Matters: The flange of the table, with its targets and tools, is rotated and shifted relative to
# the stated flange.
# Do: Identify the targets, or use `poe`.
# Example: a flange whose z axis is not the last axis
table-flange-not-held = the table has its own flange, rotated by { FIXED($angle_deg, 4) } deg and shifted by { FIXED($shift_mm, 4) } mm
    .hint = identify the targets, or use `poe`

# Means: Two axes are near-parallel, and one component of the angle between them has no parameter in
# the nominal table (Hayati's beta is identified, not given).
# Matters: A point beyond the axis is displaced by this angle times its distance.
# Do: Identify the robot, which determines beta; or use `poe`.
# Example: axes 2 and 3 of an arm, parallel within 0.2 mrad
table-tilt-not-held = the table treats { $joint ->
        [none] two axes
       *[other] the axes at the link of `{ $joint }`
    } as parallel: it does not contain the angle of { FIXED($angle_mrad, 4) } mrad between them
    .hint = `etalon identify` determines beta; `poe` contains the angle
row-excluded = excluded: { $reason }
row-at-origin = not measured: 0 0 0
row-of-station-unused = station `{ $station }`: the robot has no target of this name
row-of-several = { $rows } rows of log `{ $log }` are within { $tolerance_s } s: the nearest row is used
no-rows-around = log `{ $log }` lacks a row before or after the point within { $tolerance_s } s
no-row-near = no row of log `{ $log }` is within { $tolerance_s } s
no-point-nearest = another row is nearer to each measured point
no-row-of-key = no row of log `{ $log }` has this key
no-point-of-key = no measured point has this key
label-names-nothing = its label names no target and no point of a feature or frame
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
# Means: An export joined by label has orientations, and the log names a label in several rows.
# Matters: The robot then touches a point that was measured once; the measured orientation is not
# that of the body on the robot. Only positions are used.
# Do: Nothing, or join by pose, row or time if the instrument measured the body at each pose.
# Example: nests of a plate measured by a probe of six degrees of freedom
label-orientations-unused = orientations of the export are not used: log `{ $log }` names `{ $label }` in { $count } rows
    .hint = join by pose, row or time if the instrument measured the body on the robot at each pose

# Means: Temperatures in the rows of the exports differ from `temperature_c` of the campaign.
# Matters: Identified lengths apply at the stated temperature; a robot of aluminium expands by 23
# µm/m for each degree.
# Do: Correct `temperature_c`, or the unit of the column (degrees Celsius).
# Example: `temperature_c = 20.0`, and rows with 24.6 to 25.3
temperature-elsewhere = `temperature_c` = { $stated_c }; the rows of the exports set { FIXED($lowest_c, 1) } °C to { FIXED($highest_c, 1) } °C
    .hint = correct `temperature_c`, or the unit of the column (degrees Celsius)

# Means: Temperatures in the rows of the exports vary by more than [expansion] gives.
# Matters: The uncertainty of lengths due to temperature is too small. Rows are not corrected for
# temperature.
# Do: Give the expanded uncertainty that covers the range.
# Example: `expanded_temperature_uncertainty_c = 0.5`, and rows with 19.1 to 22.8
temperature-varies = the rows of the exports set { FIXED($lowest_c, 1) } °C to { FIXED($highest_c, 1) } °C, more than ±{ $expanded_c } °C; the uncertainty of lengths is too small
    .hint = give an `expanded_temperature_uncertainty_c` that covers the range
axes-comment-method = axes by sweeps of one joint at a time (etalon axes); no nominal model

axes-comment-base = base by axes 1 and 2, rule `{ $rule }`: z along axis 1

axes-comment-joint = q{ $number } is { $name }

axes-comment-zero = joint values are zero at the start of the sweeps

axes-comment-target = target { $name } on the flange (mm): { FIXED($x, 4) } { FIXED($y, 4) } { FIXED($z, 4) }
axes-comment-tolerance = the sweeps determine these parameters: tolerances are half-widths of rectangular distributions

axes-robot-name = Robot by its axes

# Means: The table has fewer readings than the problem needs.
# Matters: The answer is not determined.
# Do: Measure more readings; redundant readings determine the uncertainty.
# Example: a tool centre point from two orientations
cell-few = `{ $solve }` needs { $needed } readings; there are { $readings }
    .hint = measure more readings; redundant readings determine the uncertainty

# Means: All readings of a target are at one value of the axis.
# Matters: Readings at one place give no direction and no ratio of the axis.
# Do: Move the axis over its range; measure the target at several values.
# Example: nine readings at 500 mm
cell-axis-at-rest = the axis does not move: all readings of each target ({ $readings } in total) are at one value of the axis
    .hint = measure the targets at several values of the axis

# Means: The robot has the same orientation in all rows.
# Matters: A tool moves with the flange: its position does not show.
# Do: Turn the robot between the readings, about at least two axes.
# Example: a tool centre point from poses with one orientation
cell-same-orientation = the robot has the same orientation in all rows
    .hint = turn the robot between the readings, about at least two axes

# Means: All orientations of the robot differ by rotations about one axis.
# Matters: A shift of the tool along this axis changes no reading; the position along it is unknown.
# Do: Add readings with rotations about another axis.
# Example: a tool centre point from rotations of the last joint alone
cell-one-axis = all orientations differ by rotations about one axis, [{ $direction }] in the flange: the position along it is not determined
    .hint = add readings with rotations about another axis

# Means: All points of the table coincide.
# Matters: They determine no direction.
# Do: Measure points that are apart; for orientations about one fixed point use `--solve tool-point`.
# Example: a reflector that stays at one place while the robot turns
cell-points-coincide = all points coincide
    .hint = measure points that are apart; for orientations about one fixed point use `--solve tool-point`

# Means: All points are on one line.
# Matters: The rotation about this line is not determined.
# Do: Measure a point beside the line.
# Example: three corners along one edge of a fixture
cell-points-collinear = all points are collinear in the direction [{ $direction }]: the rotation about this line is not determined
    .hint = measure a point beside the line

# Means: Two different frames fit the readings equally well.
# Matters: The readings do not decide between them.
# Do: Add readings with other orientations.
# Example: four readings of a reflector with little rotation
cell-ambiguous = two different frames fit the readings equally well
    .hint = add readings with other orientations

# Means: The readings do not determine all unknown quantities.
# Matters: The answer is unknown.
# Do: Add readings at other poses or values of the axis.
# Example: an external axis whose target was measured at one value
cell-undetermined = the readings do not determine all unknown quantities
    .hint = add readings at other poses or values of the axis

# Means: The poses lack columns of their orientation.
# Matters: Without orientations a pose is incomplete.
# Do: Name the columns, with `--column flange_qw=...` where they have other headings.
# Example: a table of `flange_x_mm`, `flange_y_mm`, `flange_z_mm` alone
cell-orientation-missing = the poses have no columns of an orientation
    .expected = { $prefix }qw, { $prefix }qx, { $prefix }qy, { $prefix }qz, or { $prefix }rx_deg .. of a rotation vector, or { $prefix }a_deg .. of three angles, or { $prefix }r11 .. { $prefix }r33
    .hint = name the columns, with `--column { $prefix }qw=HEADING` where they have other headings

# Means: Orientations are three angles, and the order of the rotations is not given.
# Matters: The orientation depends on the order of the rotations.
# Do: Give the order from the manual of the controller: KUKA A B C "zyx", FANUC W P R and Yaskawa
# "fixed xyz".
# Example: `flange_a_deg, flange_b_deg, flange_c_deg` without `--orientation`
cell-order-missing = the order of the angles { $prefix }a, { $prefix }b, { $prefix }c is not given
    .hint = give it from the manual: `{ $option } zyx` for A B C of KUKA, `{ $option } "fixed xyz"` for W P R of FANUC

# Means: Hand-eye calibration needs to know what is on the robot.
# Matters: A sensor on the robot measures the inverse of what a standing sensor measures.
# Do: Set `--mounting target` if the instrument stands, `--mounting sensor` if it is on the robot.
# Example: a camera on the flange that sees a standing board
cell-mounting-missing = the part of the measuring system that is on the robot is not given
    .hint = set `--mounting target` (the instrument stands) or `--mounting sensor` (the instrument is on the robot)

# Means: A standard uncertainty in the table is zero, negative or missing.
# Matters: The weight of the row is undefined.
# Do: Correct the cell.
# Example: an empty `uz_mm`
cell-uncertainty-not-positive = a standard uncertainty is missing or not positive

# Means: The column `point` holds an unknown name.
# Matters: The part of the point is unknown.
# Do: Use the names of the problem.
# Example: `origo` for `origin`
cell-point-unknown = `{ $name }` is not a point of this problem
    .expected = { $known }

# Means: Points of both rules are in one table: origin, x, xy and x1, x2, y1.
# Matters: The rules differ in the origin of the frame.
# Do: Use the points of one rule.
# Example: `origin`, `x2`, `y1`
cell-roles-mixed = points of two rules are mixed
    .expected = origin, x, xy, or x1, x2, y1

# Means: The table lacks the values of the external axis.
# Matters: Its direction and scale refer to these values.
# Do: Name the column.
# Example: a heading `E1` of the controller
cell-axis-missing = the table lacks the values of the axis
    .hint = name the column: `--column { $column }=HEADING`

# Means: The data of this controller have no place for the answer.
# Matters: Nothing is written.
# Do: Take the numbers from the text or `--json`, or choose another format: docs/cell.md lists what each one holds.
# Example: `--solve linear-axis --controller kuka`
cell-no-controller-data = `{ $maker }` has no data for the answer of `{ $solve }`
    .hint = take the numbers from the text or `--json`, or choose another format

# Means: The kinematics need two rotary axes of one machine, and the answer has one.
# Matters: One axis does not determine the place of the other.
# Do: Measure the other axis, write its answer with `--json` to a file, and give the file.
# Example: `--controller xyzac-trt-kins` with the axis A alone
cell-second-axis-missing = `{ $maker }` needs two rotary axes: one along { $axis } of the machine, one along z
    .hint = give the answer of the other axis with `--with FILE` (JSON of `etalon cell --solve rotary-axis`)

# Means: A rotary axis is not along the axis of the machine about which the kinematics turn.
# Matters: The machine has other kinematics, or the points are in another frame.
# Do: Measure in the coordinates of the machine, and choose the kinematics of the machine.
# Example: an axis B for `xyzac-trt-kins`
cell-axis-direction = a rotary axis is { FIXED($angle_deg, 2) } deg from the axis { $axis } of the machine, about which `{ $maker }` turns
    .hint = measure in the coordinates of the machine, or choose the kinematics of the machine

# Means: The rotary axes turn in a sense that the kinematics do not have.
# Matters: Tool and part would move apart.
# Do: Reverse the sign of the axis in its configuration, and measure again.
# Example: an axis A of positive and an axis C of negative sense for `xyzac-trt-kins`
cell-axis-sense = { $sense ->
        [opposite] the axis along { $axis } and the axis along z turn in opposite senses; `{ $maker }` has one sense for both
        [positive] the axis turns about positive { $axis }; `{ $maker }` turns about negative { $axis }
       *[negative] the axes turn about negative { $axis } and z; `{ $maker }` turns about positive ones
    }
    .hint = reverse the sign of the axis in its configuration, and measure again

# Means: The pivot length reaches from the tilting axis to the gauge line, and the measured target is at the end of a tool.
# Matters: The length of this tool is part of the measured distance.
# Do: Give the length of the tool, 0 for a target at the gauge line.
# Example: `--controller maxkins` without `--tool-length-mm`
cell-tool-length-missing = `{ $maker }` needs the length of the tool at whose end the first target is
    .hint = set `--tool-length-mm`, 0 for a target at the gauge line

# Means: The tool is longer than the distance from the pivot to its end.
# Matters: The pivot would be below the gauge line of the spindle.
# Do: Check the length of the tool, and that the first target is below the pivot at B = 0.
# Example: `--tool-length-mm 900` with a target 250 mm below the axis
cell-pivot-above = the tool ({ FIXED($tool_mm, 3) } mm) is longer than the distance from the axis to the first target below it ({ FIXED($along_mm, 3) } mm, axis at zero)
    .hint = check the length of the tool, and that z of the machine points up the spindle

# Means: Number 1 is the robot itself, and external kinematics are numbers 2 to 7.
# Matters: The definition of the robot would be overwritten.
# Do: Give the number of the external kinematic.
# Example: `--solve rotary-axis --controller kuka --number 1`
cell-machine-number = `MACHINE_DEF[{ $number }]` does not define an external kinematic
    .expected = 2 to 7
    .hint = set `--number`

# Means: The entry of the tool file has lines for load data, and load data are not identified.
# Matters: Loading the file as it is replaces mass and centre of gravity by zero.
# Do: Copy the line of the frame into your own file, or complete the lines of the load.
# Example: `--controller yaskawa`
cell-loads-replaced = the entry of tool { $number } has zero mass and centre of gravity: load data are not identified
    .hint = copy the line of the frame into your own file, or complete the lines of the load

# Means: A rotary axis is tilted against the axis of the machine, and the kinematics have no tilt.
# Matters: The error of a point grows with its distance from the axis.
# Do: Align the axis, or accept the stated error.
# Example: an axis C that leans by 0.05 deg
cell-axis-tilted = the axis along { $axis } is tilted by { FIXED($angle_deg, 4) } deg, and `{ $maker }` has no tilt: { FIXED($left_um, 1) } µm at 100 mm from the axis
    .hint = align the axis, or accept this error

# Means: Columns that `--column` gives have no effect on this problem.
# Matters: Measured values are perhaps under another name than meant.
# Do: Give the columns of the problem: `etalon cell --help` lists them.
# Example: `--column x_mm=X` in place of `--column flange_x_mm=X` with `tool-point`
cell-columns-unused = { $count ->
        [one] the stated column { $columns } is
       *[other] the stated columns { $columns } are
    } not used by `{ $solve }`
    .hint = `etalon cell --help` lists the columns of each problem

# Means: Readings that contradict each other agree after a change of the input.
# Matters: The frame would be wrong.
# Do: Correct the input if the change is true; with several changes the readings do not decide between them.
# Example: angles of KUKA (zyx) read in the order xyz
cell-slip = readings contradict each other by { FIXED($stated_mm, 3) } mm (standard deviation); { $count ->
        [one] one change leaves { FIXED($left_mm, 4) } mm: { $changes }
       *[other] each of these changes leaves { FIXED($left_mm, 4) } mm or little more: { $changes }
    }
    .hint = correct the table or the options

# Means: Residuals of positions exceed the stated uncertainty with 2 mm for the robot, or a tenth of the size of tool and motion.
# Matters: Frames and uncertainties are wrong: the readings are not those of one rigid cell. The exit code is 1, and no data of a controller are written.
# Do: Check columns, signs, units and the order of rows, and measure again. An uncertainty above 2
# mm has to be given.
# Example: the columns of two robots exchanged
cell-refuted = positions have residuals of { FIXED($found_mm, 3) } mm (standard deviation), more than any plausible uncertainty explains: the answer is refuted
    .hint = check columns, signs, units and the order of the rows

# Means: Residuals of orientations exceed the stated uncertainty with 2 deg for the robot, or a tenth of the rotations between poses.
# Matters: Frames and uncertainties are wrong: the readings are not those of one rigid cell. The exit code is 1, and no data of a controller are written.
# Do: Check columns, signs, units and the order of rows, and measure again. An uncertainty above 2
# deg has to be given.
# Example: measured poses in the order of another recording
cell-refuted-turned = orientations have residuals of { FIXED($found_deg, 2) } deg (standard deviation), more than any plausible uncertainty explains: the answer is refuted
    .hint = check columns, signs, units and the order of the rows

# Means: The answer has errors, so that the data of the controller are not printed.
# Matters: Loaded, they could move the robot by a wrong tool or frame.
# Do: Correct what the errors name, or write the data with `--force`; their header says so.
# Example: `--controller kuka` of a table with an outlier
cell-data-withheld = data for { $maker } are not written: the answer must not be loaded
    .hint = correct what the errors name; `--force` writes the data

# Means: A reading fits the others less than noise explains once in a thousand tables.
# Matters: It shifts the result: the exit code is 1, and no data of a controller are written. The residuals contain it, so uncertainties are larger.
# Do: Check the reading; leave it out with `--without` if it is wrong.
# Example: one touch of the tip beside the fixed point
cell-foreign = the reading of line { $line } does not fit the others: residual { FIXED($residual_mm, 4) } mm
    .hint = check the reading, and leave it out with `--without` if it is wrong

# Means: An orientation fits the others less than noise explains once in a thousand tables.
# Matters: It shifts the result: the exit code is 1, and no data of a controller are written.
# Do: Check the reading; leave it out with `--without` if it is wrong.
# Example: one pose of a camera with exchanged corners
cell-foreign-turned = the orientation of line { $line } does not fit the others: residual { FIXED($residual_deg, 4) } deg
    .hint = check the reading, and leave it out with `--without` if it is wrong

# Means: Residuals of positions are larger than the stated uncertainty explains.
# Matters: Uncertainties of the result are from the residuals.
# Do: Check the stated uncertainty: it includes robot and measurement.
# Example: the uncertainty of the tracker alone
cell-noise-larger = positions have residuals of { FIXED($found_um, 1) } µm (standard deviation), more than the stated uncertainty explains; uncertainties are from the residuals
    .hint = give the uncertainty of robot and measurement together

# Means: Residuals of orientations are larger than the stated uncertainty explains.
# Matters: Uncertainties of the result are from the residuals.
# Do: Check the stated uncertainty: it includes robot and measurement.
# Example: the uncertainty of the tracker alone
cell-noise-larger-turned = orientations have residuals of { FIXED($found_deg, 4) } deg (standard deviation), more than the stated uncertainty explains; uncertainties are from the residuals
    .hint = give the uncertainty of robot and measurement together

# Means: The readings have no redundancy, and no uncertainty is given.
# Matters: The uncertainty of the result is unknown.
# Do: Measure more readings, or set `--standard-uncertainty-um`.
# Example: a work object from three points, each measured once
cell-no-uncertainty = the uncertainty is unknown: the readings have no redundancy, and no uncertainty is given
    .hint = measure more readings, or set `--standard-uncertainty-um`

# Means: All positions of the flange are within a few millimetres of the base of the robot.
# Matters: Coordinates in metres under `_mm` give a tool that is a thousand times too small.
# Do: Use `flange_x_m` .. for metres.
# Example: poses of a ROS topic in metres under `flange_x_mm`
cell-unit = all positions of the flange are within { FIXED($distance_mm, 3) } mm of the base, and the tool is shorter than 2 mm: positions are probably in metres
    .hint = use `flange_x_m`, `flange_y_m`, `flange_z_m` for metres

# Means: Poses are far beyond the reach of a robot, and the tool is longer than any.
# Matters: Coordinates in millimetres under `_m` give a tool that is a thousand times too long.
# Do: Use `flange_x_mm` .. for millimetres.
# Example: poses of a KUKA in millimetres under `flange_x_m`
cell-unit-large = the flange is { FIXED($distance_m, 1) } m from the base, and the tool is { FIXED($tool_m, 1) } m long: positions are probably in millimetres
    .hint = use `flange_x_mm`, `flange_y_mm`, `flange_z_mm` for millimetres

# Means: The tool centre point is at the origin of the poses, within its uncertainty.
# Matters: The poses are probably those of an active tool, and the result is its correction.
# Do: Export poses with tool 0 (flange), or take the result as correction of the active tool.
# Example: poses of ABB with `tool1` in place of `tool0`
cell-tool-active = the tool centre point is { FIXED($distance_mm, 4) } mm from the origin of the poses (u = { FIXED($u_mm, 4) } mm): the poses are probably those of the tool, not of the flange
    .hint = export poses with tool 0

# Means: Targets move by another amount than the values of the axis state.
# Matters: The values are probably in another unit, or the transmission ratio is wrong.
# Do: Check the unit of the column and the ratio of the axis.
# Example: values in degrees under `axis_rad`
cell-scale = the axis moves by { FIXED($scale, 5) } × its values (u = { SCIENTIFIC($u, 1) })
    .hint = check the unit of the column and the ratio of the axis

cell-change-radians = the angles { $side ->
        [flange] of the flange
       *[measured] of the measured poses
    } are in radians

cell-change-degrees = the angles { $side ->
        [flange] of the flange
       *[measured] of the measured poses
    } are in degrees

cell-change-order = the angles { $side ->
        [flange] of the flange
       *[measured] of the measured poses
    } have the order "{ $order }"

cell-change-vector = the angles { $side ->
        [flange] of the flange
       *[measured] of the measured poses
    } are a rotation vector

cell-change-angles = the rotation vectors { $side ->
        [flange] of the flange
       *[measured] of the measured poses
    } are angles in the order "{ $order }"

cell-change-scalar-last = the quaternions { $side ->
        [flange] of the flange
       *[measured] of the measured poses
    } have the scalar last

cell-change-turned-back = the orientations { $side ->
        [flange] of the flange
       *[measured] of the measured poses
    } are inverse

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
    } are exchanged

cell-change-sign = { $axis } of the positions { $side ->
        [flange] of the flange
       *[measured] of the measured poses
    } has the other sign

cell-change-measured-mirrored = two coordinates of the measured points are exchanged, or one has the other sign

cell-change-scale = the measured points are multiplied by { $factor }

cell-change-mirrored = the known points are mirrored (two coordinates are exchanged, or one has the other sign)

cell-change-exchanged = the points of lines { $first } and { $second } are exchanged

# Means: `field = true` asks for a residual field, and none is accepted.
# Matters: Parameters and results are those without a field.
# Do: Read the reason: measure more poses, correct the set-up, or omit `field`.
# Example: `field = true` in a campaign in which the model fits
field-refused = no residual field: { $reason }

# Means: The tilt of the base and the tilt of the first joint across its axis explain the data alike.
# Matters: Predicted positions are the same, but the parameters may belong to the other part.
# Do: Take them as the tilt of base and first joint together. Indicators on the base tell which yields.
# Example: `pedestal = true` for an arm whose first joint yields equally in all directions
tilt-of-base-or-joint = { $stated ->
        [pedestal] the tilt of the base (`pedestal`) may be that of joint `{ $joint }` across its axis (`lateral`)
       *[lateral] the tilt of joint `{ $joint }` across its axis (`lateral`) may be that of the base (`pedestal`)
    }: chi-square is { FIXED($chi_square, 1) } with the first and { FIXED($of_other, 1) } with the second
    .hint = take the parameters as the tilt of base and first joint together

# Means: A residual field depends on a joint whose values rise or fall with the order of the poses.
# Matters: A set-up that drifts or moves during the measurement leaves the same residuals, and the
# field would carry it into the robot.
# Do: Measure the poses in another order, or judge the field at poses of another day.
# Example: poses sorted by the first joint, while the tracker drifts
field-follows-order = the residual field depends on `{ $joint }`, whose values follow the order of the poses (rank correlation { FIXED($correlation, 2) }): a drift of the set-up would look the same
    .hint = judge the field by `etalon validate --field` at poses in another order

# Means: Joint values of some poses are beyond the range in which the residual field was measured.
# Matters: There the field fades out, and errors are those of the parameters alone.
# Do: Measure these regions in the calibration, or judge them separately.
# Example: a validation at joint values that no calibration pose reached
poses-beyond-field = { $count } of { $total } poses are beyond the residual field, where it fades out
    .hint = measure calibration poses in this region

field-parameters-wrong = the identification reports an error, which a field would hide

# Means: The expanded uncertainty (k = 2) of a component of the answer exceeds the bound: the stated one (`--uncertainty-bound`, `uncertainty_bound` in campaign.toml), or the default. The default is a share of the measured extent, ten times the uncertainty of a coordinate over the extent, at least 2 % and at most 5 %; for angles this share in radians, at least 0.5 %.
# Matters: The answer must not be loaded: a robot with it may move to another place. The uncertainty itself is true.
# Do: Measure what the hint says, so that the named motion shows. If the uncertainty is good enough
# for your task, give a larger bound: `--uncertainty-bound "5 mm, 2 deg"`.
# Example: `x` of three points touched 0.03 mm from the origin
uncertainty-beyond-bound = { $component }: U = { $expanded }{ $unit ->
    [1] {""}
   *[other] {" "}{ $unit }
} (k = 2) exceeds { $source ->
    [stated] the stated bound
   *[default] the bound
} { $bound }{ $unit ->
    [1] {""}
   *[other] {" "}{ $unit }
}{ $source ->
    [stated] {""}
   *[default] { " " }(by default, for a measured extent of { $extent_mm } mm)
}: { $cause }

# Means: The bound of uncertainties cannot be read.
# Matters: No uncertainty can be compared with it.
# Do: Give a length, an angle, or both, each with its unit: `0.5 mm, 0.1 deg` (mm, um, deg, rad).
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
bound-open-rotation = the readings hardly show the rotation about the direction { $direction }
bound-open-translation = the readings hardly show the position along { $direction }
bound-open-combination = the readings hardly show the combination of { $names }
bound-open-alone = the readings hardly show it
bound-remedy = { $case ->
    [tool] touch the point with orientations that differ by 30 deg or more about two axes of the flange
    [poses] add poses whose orientations differ by 30 deg or more about two axes, over a larger region
    [points] measure points farther apart, and farther from the line through the others
    [travel] measure over a longer travel
    [turn] measure a target farther from the axis, and over a larger arc
    [base] measure over a larger region, and points of the world frame farther apart, away from one line
    [region] calibrate with poses in the region of these targets
   *[robot] measure poses in which the named parameters act differently, or hold them
}; or give a larger bound

# Means: The gain of a revolute joint, or its zero, differs from nominal by more than encoders and homing leave, and by many standard uncertainties. An encoder counts whole turns: its gain is known. A zero of more than 1 deg is rarely an error of the robot.
# Matters: The data cannot tell such a value from a mistake in the log of the joint: a wrong scale, a coupled joint, or a joint that was mastered again between log and measurement. A controller with the value then moves the joint to a wrong place.
# Do: Check the column of the joint in the log, its gear ratio and its mastering. If the value is
# real, give it: correct robot.toml, or give the parameter a `tolerance` there.
# Example: the log of a joint multiplied by 1.01
encoder-implausible = { $count ->
    [one] a gain or zero of a revolute joint is
   *[other] { $count } gains or zeros of revolute joints are
} further from nominal than encoders and homing leave: { $parameters }
    .hint = check the column of the joint in the log, its gear ratio and its mastering; if the value is real, give its `tolerance` in robot.toml

value-beyond-encoder = `{ $parameter }` = { FIXED($value, 5) }{ $unit ->
    [deg] {" "}deg
   *[other] {""}
} (nominal { FIXED($nominal, 5) }, off by { $times } u)

# Means: The smallest changes that the chosen poses detect with 95 % exceed their bound: the stated one (`--uncertainty-bound`), or a share of the extent of the candidates, as for uncertainties.
# Matters: The poses would call a robot valid that has moved by this much.
# Do: Choose more poses, offer candidates in a larger region, or give a larger bound.
# Example: candidates within 0.1 deg of each other
changes-undetected = the chosen poses do not detect { $count ->
    [one] a change
   *[other] { $count } changes
} within the bound: { $changes }
    .hint = choose more poses (`--positions`), offer candidates in a larger region, or give a larger bound

change-beyond-bound = { $name }: { $change } { $unit }, bound { $bound } { $unit }

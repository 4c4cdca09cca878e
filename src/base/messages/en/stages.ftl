### Messages of stages. Above each message: its explanation (see CONTRIBUTING.md, "A message").

rigid-distance-off = the distance { $first }-{ $second } is { FIXED($off_mm, 3) } mm { $side ->
        [shorter] shorter
       *[longer] longer
    } than its median (tolerance { $limit_mm } mm)

rigid-point-coincides = { $message }; the point lies where `{ $other }` is

# Means: A distance between targets of a rigid part differs from its median by more than
# `tolerance_mm` of [[rigid]].
# Matters: The row is left out and listed in import.json: a target was mistaken, moved or measured
# badly.
# Do: Look at the row; correct its label, or keep it refused.
# Example: a reflector measured under the name of its neighbour
rigid-row-refused = row { $row }: `{ $target }` is refused: { $reason }

# Means: `targets` of [[rigid]] names one target, or one of them twice.
# Matters: The rule compares distances between targets.
# Do: Name each target of the part once.
# Example: `targets = ["SMR_1"]`
rigid-targets = a rigid part needs two or more targets, each named once
    .hint = name each target of the part once in `targets`

# Means: `tolerance_mm` of [[rigid]] or `drift_mm` of [[fixed]] is zero, negative or not finite.
# Matters: Every row would violate the limit, or none.
# Do: State how far a distance may differ from its median, or a target may move.
# Example: `tolerance_mm = 0`
limit-not-positive = `{ $key }` must be a positive number
    .expected = { $key ->
            [drift_mm] the largest motion of a fixed target during the campaign, for example 0.02
           *[tolerance_mm] the largest deviation of a distance from its median: some times its scatter, for example 0.1
        }

# Means: [[rigid]] states an uncertainty or coverage factor of `places_mm` and no `places_mm`.
# Matters: The statement has no effect.
# Do: State the places, or remove the key.
# Example: `coverage_factor = 2` in a [[rigid]] without `places_mm`
rigid-uncertainty-without-places = `{ $key }` belongs to `places_mm`, which is missing
    .hint = state `places_mm`, or remove `{ $key }`

# Means: `places_mm` of [[rigid]] names a target that `targets` of the same part does not name.
# Matters: The place would not be used.
# Do: Correct the name, or add the target to `targets`.
# Example: `places_mm = { SMR_9 = [0, 0, 0] }` with targets SMR_1 to SMR_3
rigid-place-unknown = `places_mm` names `{ $target }`, which is not a target of this rigid part

# Means: `places_mm` of [[rigid]] states the places of some targets of the part only.
# Matters: The shape of the part is used as a whole.
# Do: Add the place of the target.
# Example: `places_mm` of two of three targets
rigid-place-missing = `places_mm` lacks the place of `{ $target }`
    .hint = add its coordinates, or remove it from `targets`

# Means: `places_mm` of [[rigid]] is stated without its uncertainty.
# Matters: The places count as a measurement; its weight needs the uncertainty.
# Do: State `expanded_uncertainty_um` and `coverage_factor` of the places.
# Example: `places_mm` alone
rigid-places-need-uncertainty = `places_mm` needs `{ $key }`, a positive number
    .expected = the expanded uncertainty of one coordinate, and its coverage factor

# Means: A row of a target of [[rigid]] has neither pose nor time.
# Matters: It is unknown with which rows of the other targets it was measured.
# Do: Name the pose in `label` or `columns`, or remove the target from [[rigid]].
# Example: the label `SMR_1` read as `{target}`
rigid-row-without-pose = [[rigid]] names `{ $target }`, and this row has neither pose nor time
    .hint = name the pose in `label` or `columns`, or remove the target from [[rigid]]

# Means: Two rows of a target of [[rigid]] have the same time, and no pose.
# Matters: It is unknown which of them belongs to the rows of the other targets.
# Do: Name the pose in `label` or `columns`.
# Example: a target measured twice within one time stamp
rigid-time-twice = [[rigid]] names `{ $target }`, and two of its rows have the same time
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
# Matters: No row is refused by this distance; errors of these targets are not found.
# Do: Measure the targets together at more poses, or remove one from [[rigid]].
# Example: two poses
rigid-few-distances = the distance `{ $first }`-`{ $second }` of [[rigid]] refuses no row: it was measured { $count ->
        [one] once
       *[other] { $count } times
    }
    .expected = { $least } times or more

# Means: [[identify.exclude]] names neither poses nor rows, or both.
# Matters: It is undefined what is left out.
# Do: State `poses`, perhaps with `cycle` and `target`; or `file` and `rows`.
# Example: `rows = "3"` without `file`
exclusion-mixed = an exclusion names either poses or the rows of a file
    .expected = `poses`, perhaps with `cycle` and `target`; or `file` and `rows`

# Means: `file` of [[identify.exclude]] is no export of the campaign, or an export without rows.
# Matters: Nothing would be left out.
# Do: Name the file as the [[export]] does.
# Example: `file = "pose.txt"` for the export `poses.txt`
exclusion-file-unknown = `{ $file }` is not an export with rows to exclude

of-file = `{ $file }`: { $message }

# Means: A row lies where another point was measured: in the same pose, or far from the other rows
# of its own name.
# Matters: The row is used as stated. With a wrong label it falsifies whatever uses this point.
# Do: Correct the label, or leave the row out. [[rigid]] refuses rows whose distances to the other
# targets are wrong.
# Example: the reflector `base_3` measured while the instrument pointed at `SMR_3`
point-lies-at-another = row { $row }: `{ $point }` lies where `{ $other }` is{ $rows ->
        [one] {""}
       *[other] {""}; { $rows } such rows in all
    }
    .hint = if the instrument pointed at the other target or the label is wrong, correct the label or leave the row out; [[rigid]] refuses rows by their distances

# Means: A target of [[fixed]] has too few rows to compare parts of the recording.
# Matters: A motion of the target or the instrument stays unnoticed.
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
# Do: Look for temperature and a moved instrument. With `targets` and `each = "pose"` in
# [frame.world] the frame follows the targets.
# Example: an instrument that warms up
reference-drifts = `{ $target }` drifts: from rows { $first } to rows { $second } it moves { FIXED($moved_mm, 4) } mm; limit { $limit_mm } mm
    .hint = check temperature and mounting of the instrument; with `targets` and `each = "pose"` in [frame.world] the frame follows the targets

# Means: Exports state the working frame of their points, and the frames differ.
# Matters: Points of different frames do not describe one geometry.
# Do: Export all points in one working frame, or do not use them together.
# Example: one QIF file relative to `Base`, another relative to `Part`
frames-differ = the points are relative to the frame `{ $second }`; the points of another export are relative to `{ $first }`
    .hint = export them in one working frame, or do not use them together

# Means: No row of an export is a point.
# Matters: The export adds nothing; the file or its description is probably wrong.
# Do: Export the points again, or remove this [[export]].
# Example: a file that holds a header alone
export-empty = `{ $file }` holds no points
    .hint = export the points again, or remove this [[export]]; `etalon formats FILE` shows how a text reads

# Means: A target has a name that a spreadsheet would execute.
# Matters: Tables of results hold names of targets.
# Do: Rename the target, or state a `label` without its first character.
# Example: `=ball`
target-formula = the target `{ $target }` is a formula in a spreadsheet
    .hint = rename it, or state a `label` without its first character

# Means: A row names a target of the robot, and no pose.
# Matters: A measured target needs the pose of the robot, that is, its joint values.
# Do: Name the pose in the label, or state `pose = "row"` for this export.
# Example: the label `SMR_1` read as `{target}`
target-without-pose = the row names a target but no pose
    .hint = name the pose in the label, or state `pose = "row"` for this export

# Means: Two rows have the same target, pose and cycle.
# Matters: It is unknown which of them counts.
# Do: Number repeats as cycles, or remove one row. Files whose rows are poses need different
# numbers.
# Example: two files with `pose = "row"`
target-twice = target `{ $target }` is there twice at pose { $pose }, cycle { $cycle }
    .hint = the first is { $file }:{ $line }; { $numbered ->
            [by-row] state `pose = "row + 100"` for one of the files
           *[by-label] number repeats as cycles, or remove one
        }

# Means: Labels name no target of the robot, and no feature, frame or step of a procedure uses them.
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
    .hint = correct the label, or `label` of this export

column-step = { $column } to { $step } { $unit }

# Means: All values of a coordinate are multiples of a step whose rounding error is larger than the
# uncertainty of the instrument. A step has the standard uncertainty step/√12 (JCGM 100:2008,
# 4.3.7).
# Matters: The results are less certain than the stated uncertainty of the instrument says.
# Do: Export the coordinates with more decimals.
# Example: coordinates with one decimal from a tracker with 15 µm
coordinates-rounded = coordinates of `{ $file }` are rounded ({ $columns }): a standard uncertainty of { FIXED($rounding_um, 1) } µm, instrument { FIXED($instrument_um, 1) } µm
    .hint = export them with more decimals

# Means: A step of a procedure names the form of its labels, and no point has such a label.
# Matters: The step cannot be evaluated.
# Do: Correct the pattern, or add the export.
# Example: `label = "visit_{pose}_{cycle}"` where the labels begin with `pose`
labels-missing = no point has a label of the form `{ $pattern }`
    .hint = correct the pattern, or add the export

# Means: An exclusion on the command line states no reason.
# Matters: Whoever reads the report must be able to judge why measurements are left out.
# Do: Add the reason after a colon.
# Example: `--exclude 13`
exclusion-option-without-reason = { $option } { $text } states no reason
    .expected = what is left out, and why: "13, 20-22: ball loose"

exclusion-poses = { $count ->
        [one] pose
       *[other] poses
    } { $poses }

exclusion-cycle = cycle { $cycle }

exclusion-target = target `{ $target }`

# Means: Readings were excluded as the campaign states.
# Matters: Excluded readings do not take part in the result; the report repeats them.
# Do: Check the reason.
# Example: `exclude = [{ poses = "13", reason = "ball loose" }]`
excluded-readings = excluded: { $count ->
        [one] 1 reading
       *[other] { $count } readings
    }, { $of }: { $reason }

# Means: The exclusions leave out everything that was measured.
# Matters: There is nothing to identify from.
# Do: Remove an exclusion.
# Example: `poses = "1-1000"` of 100 poses
exclusions-leave-nothing = the exclusions leave no reading
    .hint = remove an exclusion

# Means: An exclusion states poses or rows in a form that names none.
# Matters: Nothing would be left out.
# Do: State names, numbers and ranges.
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
# Matters: It is unknown what the row belongs to.
# Do: Correct the name.
# Example: `SMR_4` of a robot with the targets SMR_1 to SMR_3
not-of-this-robot = `{ $name }` is not a { $kind ->
        [joint] joint
       *[target] target
    } of this robot

# Means: `reason` of an exclusion is empty.
# Matters: Whoever reads the report must be able to judge why measurements are left out.
# Do: State the reason.
# Example: `reason = ""`
exclusion-without-reason = an exclusion needs its reason
    .hint = state in `reason` why the measurements are left out

# Means: An exclusion names a pose or row that was not measured.
# Matters: The exclusion has no effect; what it means is still in the result.
# Do: Correct the pose, cycle, target or row.
# Example: `poses = "130"` of 100 poses
exclusion-matches-nothing = { $of ->
        [rows] there is no row { $name } to exclude
       *[poses] there is no reading at pose { $name } with this cycle and target to exclude
    }
    .hint = correct the exclusion, or remove it

# Means: Exports and logs are stated without [join].
# Matters: It is unknown which rows of the log belong to which points.
# Do: State `by` in [join].
# Example: [[export]] and [log] alone
join-missing = exports and logs need [join]
    .hint = state `by` in [join]: "pose", "pose_and_cycle", "row", "time" or "label"

# Means: No measured point has a row of the log within `tolerance_s`.
# Matters: There are no observations. Usually the clock offset is wrong.
# Do: Check value and sign of `clock_offset_s`: time of the measurement minus time of the log.
# Example: `clock_offset_s = 3600` where the log is one hour ahead
join-by-time-empty = no measured point has a partner in log `{ $log }`: the two nearest times are { FIXED($apart_s, 3) } s apart
    .hint = check value and sign of `clock_offset_s`: time of the measurement minus time of the log

# Means: No measured point and no row of the log have the same pose, cycle or row.
# Matters: There are no observations.
# Do: Compare the names in exports and log, or choose another key with `by` in [join].
# Example: poses 1 to 50 in the export, 0 to 49 in the log
join-empty = no measured point has a partner in log `{ $log }`: the first pose of the points is `{ $measured }`, of the log `{ $logged }`
    .hint = compare poses and cycles of exports and log, or choose another key with `by` in [join]

# Means: The offset of the clocks was taken from the standstills of the log: with it every measured
# point falls into one.
# Matters: Joint values are from the standstill of each point. The offset itself is uncertain by the
# stated half width.
# Do: Nothing, if points were measured during standstills only.
# Example: `clock_offset_s = "standstills"`
clock-from-standstills = the clock of log `{ $log }` is set by { $count ->
        [one] 1 standstill
       *[other] { $count } standstills
    }: offset { FIXED($offset_s, 3) } s ± { FIXED($half_width_s, 3) } s
    .hint = with this offset every measured point falls into a standstill

# Means: The world frame is measured at each pose, and at some poses it could not be made.
# Matters: Points of these poses cannot be expressed in the world; they are left out.
# Do: Look in import.json which frame targets were refused, or measure them.
# Example: a frame target hidden at pose 12
pose-without-frame = { $count ->
        [one] 1 pose
       *[other] { $count } poses
    } without a world frame, left out: { $poses }
    .hint = the frame targets were refused or not measured: see import.json

# Means: Points and the rows of the log that they are joined with state different poses or cycles.
# Matters: Joint values would be assigned to the wrong points.
# Do: Join by pose. If the column counts something else in the log, leave it out of `columns`.
# Example: a join by row where the export lacks the row of pose 7
join-contradicts = { $count ->
        [one] 1 measured point has
       *[other] { $count } measured points have
    } another { $column } than the row of log `{ $log }` they are joined with: { $measured } and { $logged } (line { $line } of the log)
    .hint = join by pose; or leave `{ $column }` out of `columns` of the log, if it counts something else there

# Means: A join by row needs one row of the log for each row of the export, and the counts differ.
# Matters: From the first missing row on, joint values would belong to other points.
# Do: Complete the file, or name pose and cycle in both and join by them.
# Example: 100 rows of the export, 99 of the log
row-counts-differ = `{ $file }` has { $rows } rows, log `{ $log }` has { $log_rows }
    .expected = equal counts for a join by row
    .hint = complete the file that lacks rows; or name pose and cycle in both, and join by them

# Means: The robot has `backlash`, and the log has neither times nor a column of directions.
# Matters: The error of a joint with backlash depends on the direction of its last motion.
# Do: State the times of the rows (`time_s` in `columns`, or `period_s`), or the column of
# directions: +1 from below, -1 from above.
# Example: `backlash = [2]` with a log without times
approach-direction-unknown = log `{ $log }` does not show from which direction joint `{ $joint }` moved
    .hint = `backlash` needs it: state the times of the rows (`time_s` in `columns`, or `period_s`), or `{ $column }` in `columns`: +1 from below, -1 from above

# Means: The log has no motion of a joint with backlash before the first poses.
# Matters: The direction of approach is unknown there; these poses are left out.
# Do: Begin the log before the first pose, or state the direction.
# Example: a log whose first row is pose 1
backlash-direction-unknown = log `{ $log }` has no motion of a joint with backlash before pose { $poses }: left out
    .hint = begin the log before the first pose, or state the direction

# Means: The targets of a planar robot differ in height in the world frame by more than 0.5 mm.
# Matters: The plane of the world is tilted against the plane of motion; projected lengths are too
# short.
# Do: Check z of the exports (unit, sign, column) and the points that define the plane of the world
# frame.
# Example: two columns of the export exchanged
targets-out-of-plane = the targets of the planar robot have heights from { FIXED($low_mm, 3) } mm to { FIXED($high_mm, 3) } mm in the world frame
    .hint = check z of the exports (unit, sign, column) and the points that define the plane of the world frame

# Means: The log has no column of a joint of the robot.
# Matters: Joint values are incomplete.
# Do: Name the column in `columns` of [log].
# Example: `columns = ["pose", "q1_deg"]` of a robot with two joints
log-column-missing = log `{ $log }` has no column `{ $column }`

# Means: A column that each row needs is missing, or has an empty cell.
# Matters: It is unknown what the row refers to.
# Do: Add the column, or complete the cell.
# Example: a row of kind `distance` without `other`
column-empty = the column `{ $column }` is empty or missing
    .hint = add the column, or complete the cell

# Means: Some targets were not measured at some poses.
# Matters: The targets that were measured still count. A pose or orientation needs all of them.
# Do: Measure the poses again if their orientations matter.
# Example: a hidden reflector at pose 12
targets-missing = targets are missing at pose { $poses }
    .hint = their other targets still count; a pose or an orientation needs all of them

key-in-lines = { $key } in lines { $lines }

# Means: Several rows of the log have the same pose, or pose and cycle.
# Matters: It is unknown which joint values belong to the measured points.
# Do: Join by pose and cycle, or remove the rows that do not count.
# Example: pose 3 logged twice with `by = "pose"`
log-key-twice = log `{ $log }` has { $count ->
        [one] 1 key
       *[other] { $count } keys
    } more than once: { $keys }
    .hint = add `cycle` to the key, or remove the rows that do not count

# Means: Measured points without a row of the log, or rows of the log without a measured point.
# Matters: They do not take part in the result; import.json lists all of them.
# Do: Nothing, if they were not meant to be joined. Otherwise compare poses and cycles of both
# files.
# Example: a log of 100 poses, of which 90 were measured
keys-unmatched = { $count ->
        [one] 1 key
       *[other] { $count } keys
    } of { $of ->
        [log] log `{ $log }` without a measured point
       *[points] measured points without a row of log `{ $log }`
    } ({ $columns }): { $keys }; see import.json

# Means: A named pose is in the export or in the log only, and the other has poses without a
# partner.
# Matters: The pose is probably spelt differently in the two files; its measurements would be lost.
# Do: Write the name of the pose the same in both files.
# Example: `home` in the log, `hom` in the export
pose-misspelt = pose `{ $pose }` { $of ->
        [log] of log `{ $log }` was not measured, and measured poses are not in the log
       *[points] is not in log `{ $log }`, and poses of the log were not measured
    }

# Means: Rows of an export or of the log lack the pose, cycle or row that the join compares.
# Matters: These rows cannot be joined.
# Do: Name it in `label` of the exports and in `columns` of the log, or change `by` in [join].
# Example: `by = "pose_and_cycle"` with labels without a cycle
join-key-missing = the join needs `{ $key }`, which some rows do not have
    .hint = name it in `label` of the exports and in `columns` of the log, or change `by` in [join]

# Means: A join by label is for one target on the robot, which touches points of a plate.
# Matters: A label does not state which of several targets touched the point.
# Do: Name one target, or join by pose.
# Example: `by = "label"` with three targets
join-by-label-targets = a join by label is for a robot with one target; this robot has { $count }
    .hint = name one target, or choose another key with `by` in [join]

# Means: The plate is measured once, and the world frame is made at each pose.
# Matters: The points of the plate have no place in the world.
# Do: Make the world frame of points that do not move.
# Example: `each = "pose"` in [frame.world] with `by = "label"`
join-by-label-frame = a join by label needs one world frame for all poses
    .hint = make the frame of points that do not move

# Means: A row of the log names a point that no export has.
# Matters: Its place is unknown.
# Do: Correct the label in the log, or add the export of the point.
# Example: `ball_7` of a plate with balls 1 to 6
label-not-measured = no measured point has the label `{ $label }`

# Means: Points of the plate are not named by any row of the log.
# Matters: They are not used.
# Do: Nothing, if the robot did not touch them. Otherwise correct their labels.
# Example: a plate of 30 balls, of which 20 were touched
points-untouched = { $count ->
        [one] 1 point is
       *[other] { $count } points are
    } touched by no row of log `{ $log }`; the first is `{ $label }`

# Means: A row of the log has a time that is not later than the time of the row before.
# Matters: The row of a point is found by the order of times.
# Do: Sort the log by time, and remove rows with equal times.
# Example: a log written by two recorders into one file
log-times-not-increasing = times of log `{ $log }` do not increase at its row { $row }
    .hint = sort the log by time, and remove rows with equal times

# Means: A join by time, and rows of an export or of the log have no time.
# Matters: These rows cannot be joined.
# Do: Name the column of times as `time_s` in `columns` of exports and log.
# Example: `by = "time"` with an export without a column of times
times-missing = { $of ->
        [log] the log has rows without a time
        [export] the export has rows without a time
       *[points] no measured point has a time
    }
    .hint = a join by time needs `time_s` in the columns of exports and log

# Means: Several rows of the log are within `tolerance_s` of a measured point.
# Matters: The nearest row counts; if the robot moved, the choice matters.
# Do: Lower `tolerance_s` to less than half the period of the log.
# Example: `tolerance_s = 5` with a row each second
several-rows-near = { $count ->
        [one] 1 measured point has
       *[other] { $count } measured points have
    } several rows of log `{ $log }` within { $tolerance_s } s: the nearest counts
    .hint = lower `tolerance_s` to less than half the period of the log

# Means: Measured points have no row of the log within `tolerance_s`.
# Matters: They do not take part in the result; import.json lists them.
# Do: Check `clock_offset_s` and `tolerance_s` if they should have been joined.
# Example: points measured after the log ended
points-without-row = { $count ->
        [one] 1 measured point has
       *[other] { $count } measured points have
    } no row of log `{ $log }` within { $tolerance_s } s

# Means: Rows of the log are nearest to no measured point.
# Matters: They do not take part in the result; import.json lists them.
# Do: Nothing, if nothing was measured then.
# Example: standstills of the robot in which nothing was measured
rows-without-point = { $count ->
        [one] 1 row
       *[other] { $count } rows
    } of log `{ $log }` without a measured point

# Means: Several points of one target have the same time.
# Matters: A target is at one place at a time.
# Do: Correct the times, or name the target of each point.
# Example: two reflectors read under one name
target-time-twice = { $count } points of target `{ $target }` have the same time (lines { $lines })
    .hint = correct the times, or name the target of each point

# Means: One row of the log is nearest to several points of one target.
# Matters: The target was at one place at that time: one of the points belongs to another row.
# Do: Lower `tolerance_s`, or check `clock_offset_s`.
# Example: `tolerance_s` longer than the time between two poses
log-row-met-twice = row { $row } of log `{ $log }` is nearest to { $count } points of target `{ $target }` (lines { $lines })
    .hint = lower `tolerance_s`, or check `clock_offset_s`

# Means: There is no offset of the clocks at which every measured point falls into a standstill of
# the log.
# Matters: The clocks cannot be set by the standstills: a point was measured in motion, or the log
# lacks a standstill.
# Do: State `clock_offset_s` as a number; rows without a partner are then listed.
# Example: a point taken while the robot moved
clock-offset-none = at no offset of the clocks does every measured point fall into a standstill of the log: { $count ->
        [one] 1 time does
       *[other] { $count } times do
    }, up to { $last_s } s; the time { $first_s } s does not fit
    .hint = remove points measured in motion; or state `clock_offset_s` as a number: rows without a partner are then listed

range-of-seconds = { FIXED($low_s, 3) } to { FIXED($high_s, 3) } s

# Means: At several offsets of the clocks every measured point falls into a standstill.
# Matters: Points would be joined with the wrong pose at all but one of them.
# Do: Compare the clocks once and state `clock_offset_s` as a number.
# Example: standstills at equal intervals
clock-offsets-several = the standstills allow { $count } ranges of the clock offset, the first: { $ranges }
    .hint = compare the clocks, and state `clock_offset_s` as a number

### Messages of simulate. Above each message: its explanation (see CONTRIBUTING.md, "A message").

# Means: A pose of the truth has more or fewer joint values than the robot has joints.
# Matters: The pose of the robot is undefined.
# Do: Give one value for each joint, and the assembly mode of a platform.
# Example: `joints = [[0, 10]]` for a robot of three joints
truth-joint-count = a pose has { $values } joint values, but the robot has { $joints } joints
    .hint = give one value for each joint, and the assembly mode of a platform

# Means: `label` in [[poses]] is given together with `circles`.
# Matters: Poses on circles have no common label.
# Do: Set `joints`, or omit `label`.
# Example: `circles = [{ ... }]` and `label = "A"`
truth-label-with-circles = `label` in [[poses]] is for `joints`, not for `circles`
    .hint = omit `label`, or set `joints`

# Means: [[poses]] names a point for which no [[point]] exists.
# Matters: The position of the pose is unknown.
# Do: Use the label of a [[point]].
# Example: `label = "P3"` without a [[point]] of this label
truth-point-unknown = [[poses]] names the point `{ $label }`, but no [[point]] has this label

# Means: `circles` are given for a spatial robot.
# Matters: Circles are poses of a planar platform.
# Do: Set `joints`.
# Example: `circles` for a serial arm
truth-circles-not-planar = `circles` are for planar robots
    .hint = use `joints`

# Means: [parameters] names a parameter that the robot model lacks.
# Matters: The stated value has no effect.
# Do: Use a parameter of the model.
# Example: `s_9 = 1.0`
truth-parameter-unknown = [parameters] names `{ $parameter }`, which is not a parameter of this robot

# Means: [repeatability] of the truth names a target that the robot lacks.
# Matters: No position can be simulated.
# Do: Use a target of the robot.
# Example: `target = "T9"`
truth-target-unknown = [repeatability] of the truth: the robot has no target `{ $target }`

# Means: A pose of the trajectory is not in the truth.
# Matters: Its position and scatter are unknown.
# Do: Add it to `joints` of [[poses]] and to [[repeatability.pose]].
# Example: `trajectory = [1, 2, 6]` with five poses
truth-pose-missing = pose { $pose } of the trajectory is not in the truth
    .hint = add it to `joints` of [[poses]] and to [[repeatability.pose]]

# Means: The truth has [repeatability], but the campaign does not.
# Matters: The campaign gives labels and trajectory.
# Do: Add [repeatability] in campaign.toml.
# Example: truth.toml of a test with a campaign.toml of a calibration
truth-repeatability-without-campaign = the truth has [repeatability], but the campaign does not
    .hint = add [repeatability] in campaign.toml: it gives labels and trajectory

# Means: `home` has more or fewer joint values than the robot has joints.
# Matters: The home position of the robot is undefined.
# Do: Give one value for each joint.
# Example: `home = [0, 0]` for three joints
truth-home-count = `home` has { $values } joint values, but the robot has { $joints } joints
    .hint = give one value for each joint

# Means: `etalon simulate` cannot write this kind of file.
# Matters: The campaign cannot be tried on simulated data without a change.
# Do: Give a file that can be simulated, and replace it by the real file afterwards.
# Example: a log with `standstill`
simulate-not-written = `etalon simulate` cannot write { $what }
    .hint = give a file that can be simulated, and replace it by the real file afterwards

# Means: The campaign reads several tables of observations.
# Matters: `etalon simulate` writes one table.
# Do: Simulate a campaign with one of them.
# Example: two [[observations]] beside a truth.toml
several-tables = `etalon simulate` writes one table of observations, not several
    .hint = simulate a campaign with one of them

simulated-kind = { $kind ->
        [twincat] a TwinCAT export
        [moving-log] a log that is recorded while the robot moves
        [period-log] a log with `period_s` for a join by time
        [repeated-columns] a log that names columns twice
        [workbook-sheet] a sheet of a workbook
        [encoding] a table in another encoding than UTF-8
        [blank-columns] a table of observations with blanks between columns: its empty cells would be lost
        [computed-columns] a table of observations with computed, numbered or constant columns, filters, or a header of more or fewer rows than one
        [unmodelled] a table of observations with errors of {"["}unmodelled]
        [circumstances] a log of a robot with backlash whose readings give a payload, torques or a temperature
       *[backlash] a table of observations of a robot with backlash
    }

# Means: `coordinates` is given for an observation that is not a point in the world.
# Matters: Only points may state some of their coordinates.
# Do: Omit `coordinates`.
# Example: `kind = "distance"` and `coordinates = "xy"`
coordinates-of-other-kind = `coordinates` is for kind `point` without a station
    .hint = omit `coordinates`

in-numbered-table = [[{ $table }]] { $number }: { $message }

in-set = set `{ $set }`: { $message }

# Means: The truth has no points for this export.
# Matters: An export without points cannot be read.
# Do: Add a [[point]] with this `export`, or `label` or `target` to the export in the campaign.
# Example: an export `world.txt` and no [[point]] with `export = "world.txt"`
export-without-points = the truth has no points for the export `{ $file }`
    .hint = add a [[point]] with this `export`, or `label` or `target` to the export in the campaign

# Means: The export gives an encoding.
# Matters: `etalon simulate` writes UTF-8.
# Do: Omit `encoding` of this export.
# Example: `encoding = "windows-1252"`
simulate-utf8 = `etalon simulate` writes UTF-8
    .hint = omit `encoding` of this export

# Means: A reader of the written export would find another number of rows.
# Matters: The simulation would not test the campaign as given.
# Do: Name target, pose and cycle in `label` or `columns`.
# Example: a point at 0, 0, 0 in a PolyWorks file, which counts as not measured
simulated-rows-lost = `{ $file }` would be read with { $read } instead of { $rows } rows
    .hint = name target, pose and cycle in `label` or `columns`; `pose = "row"` is for one target a file; without a cycle, set `cycles = 1` in the truth

# Means: A row of the written export would be read as another measurement.
# Matters: The simulation would not test the campaign as given.
# Do: Name target, pose and cycle in `label` or `columns`.
# Example: labels without the number of the cycle
simulated-row-misread = line { $line } of `{ $file }` is { $meant }, but would be read as { $read }
    .hint = name target, pose and cycle in `label` or `columns`; `pose = "row"` is for one target a file; without a cycle, set `cycles = 1` in the truth

measurement-name = target `{ $target }`, pose { $pose }, cycle { $cycle }

# Means: A pose of the truth violates a limit of the robot.
# Matters: A real robot cannot attain this pose.
# Do: Correct the pose in the truth, or [reach] in robot.toml.
# Example: a joint value of 200 deg with a limit of 170 deg
truth-pose-out-of-reach = pose { $pose } is out of reach: { $reason }
    .hint = correct the pose in the truth, or [reach] in robot.toml

# Means: The true robot cannot bring its target to a point.
# Matters: No joint values can be simulated for the pose.
# Do: Correct the point or the pose in the truth.
# Example: a point 5 m away from an arm of 1 m
truth-point-out-of-reach = pose { $pose }: the true robot does not reach its point { $point } mm
    .hint = correct the point or the pose in the truth

# Means: The truth has [[observe]], but the campaign has no [observations].
# Matters: The file and its columns are unknown.
# Do: Set `[observations]` with `file` in campaign.toml.
# Example: [[observe]] of a distance without [observations]
observe-without-table = the truth has [[observe]], but the campaign has no [observations]
    .hint = give the table in campaign.toml: `[observations]` with `file`

# Means: The campaign has [observations], but the truth has no [[observe]].
# Matters: The table would be empty.
# Do: Give the observations in the truth.
# Example: [observations] with `file` and a truth without [[observe]]
table-without-observe = the truth has no [[observe]] for the table of [observations]
    .hint = give the observations: kind = "point", target = "ball" ...; docs/observations.md lists the kinds

# Means: The campaign does not state that its data are synthetic.
# Matters: Its files may be measured data, which simulated data must never overwrite.
# Do: Set `synthetic` in campaign.toml: every report repeats it.
# Example: `etalon simulate` in the folder of a real campaign
campaign-not-synthetic = the campaign does not state that it is synthetic: its files may be measured data
    .hint = set `synthetic = "how the data are made"` in campaign.toml; `etalon init --synthetic FOLDER` writes such a campaign with a truth

# Means: More decimals are given than a floating-point number has.
# Matters: Further digits are rounding errors.
# Do: Give fewer decimals.
# Example: `decimals = 30`
truth-decimals = { $decimals } decimals exceed the precision of a number
    .expected = 0 to { $most }

# Means: One file of the campaign has joints and points.
# Matters: `etalon simulate` writes exports and logs as separate files.
# Do: Give a separate export and [log] for the simulation.
# Example: an export with `joints`
joints-and-points-together = a file with joints and points together cannot be simulated
    .hint = give a separate export and [log]

# Means: The label of a [[point]] begins like a formula of a spreadsheet.
# Matters: A spreadsheet would execute it.
# Do: Give the point another label.
# Example: `label = "=A1"`
point-label-formula = a spreadsheet would take the label `{ $label }` of a [[point]] for a formula
    .hint = use a label that does not begin with = + - or @

# Means: [parameters] lacks coordinates of observed fixed points or surfaces.
# Matters: Their true positions are unknown.
# Do: Give them in [parameters].
# Example: a target `anchor_A` without `anchor_A_x`
truth-parameters-missing = [parameters] does not set { $parameters }
    .hint = give the true positions of the observed fixed points and surfaces

# Means: [unmodelled] names a joint that the robot lacks.
# Matters: The stated error has no effect.
# Do: Use a joint of the robot.
# Example: `backlash = { q9 = 0.01 }`
unmodelled-joint-unknown = [unmodelled] names `{ $joint }`, which is not a joint of this robot

# Means: The period of an interpolation error is zero, negative or not a number.
# Matters: The error is periodic in the joint.
# Do: Give a positive period.
# Example: `interpolation = { q1 = { period = 0 } }`
unmodelled-period = [unmodelled] `period` of `{ $joint }` must be positive
    .hint = give a positive period

# Means: A set of poses does not determine all parameters.
# Matters: The undetermined parameters would remain at nominal values in all calibrations.
# Do: Add poses to the set.
# Example: two poses that differ in one joint
study-too-few-poses = too few poses to identify all parameters
    .hint = add poses to the set

# Means: A set has no poses, or no poses within the reach of the robot.
# Matters: There is nothing to simulate.
# Do: Give poses within reach.
# Example: a circle outside of the workspace
study-set-empty = a set has no pose that the robot reaches
    .hint = give poses within reach

# Means: Poses are given by positions, but the robot needs joint values.
# Matters: A position does not determine the joints of this robot.
# Do: Set `joints`, or a table in `file`.
# Example: `positions_mm` for a serial arm
study-not-by-position = `{ $model }` cannot be placed by positions
    .hint = set `joints`, or a table in `file`

# Means: No joint values near those of the truth bring the targets into contact.
# Matters: The observation cannot be simulated.
# Do: Give joint values nearer to the contact, or a wider range of drawn joint values.
# Example: a plane 2 m away from the robot
truth-not-touching = pose { $pose }: no joint values near those of the truth make the contact
    .hint = give joint values nearer to the contact, or a wider range of drawn joint values

# Means: No uncertainty of angles is given.
# Matters: Simulated orientations would have no noise, and identified orientations no weight.
# Do: Set `expanded_rotation_uncertainty_deg` in [instrument], or `urot_deg` in the [[observe]].
# Example: `kind = "orientation"` without an uncertainty
angle-uncertainty-missing = the uncertainty of an angle is missing
    .hint = set `expanded_rotation_uncertainty_deg` in [instrument], or `urot_deg` in the [[observe]]

# Means: The truth has [geometric], but the campaign has no [geometric], or its robot is not a
# PreXYT.
# Matters: The campaign gives the labels of the geometric method.
# Do: Add [geometric] in campaign.toml.
# Example: [geometric] in truth.toml alone
truth-geometric-without-campaign = the truth has [geometric], but the campaign has no [geometric] or its robot is not a PreXYT
    .hint = add [geometric] in campaign.toml: it gives the labels
study-error-in-base = true pose of the tool in the base frame minus the commanded one
study-error-in-world = true pose of the tool in the world minus the commanded one
poses-in-set = poses in the set `{ $set }`
positions-in-workspace = positions in `workspace`
counted-calibrations = calibrations
errors-to-evaluate = errors to evaluate
poses-to-simulate = poses to simulate
points-to-simulate = points to simulate

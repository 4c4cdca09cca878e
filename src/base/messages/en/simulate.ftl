### Messages of simulate. Above each message: its explanation (see CONTRIBUTING.md, "A message").

# Means: A pose in the truth has more or fewer joint values than the robot has joints.
# Matters: The pose is undefined.
# Do: Give one value for each joint. For a platform, add the assembly mode.
# Example: `joints = [[0, 10]]` for a robot of three joints
truth-joint-count = a pose has { $values } joint values, but the robot has { $joints } joints
    .hint = give one value for each joint; for a platform, add the assembly mode

# Means: [[poses]] contains both `label` and `circles`.
# Matters: The label belongs to one point, but the poses are on circles.
# Do: Omit `label`, or replace `circles` with `joints`.
# Example: `circles = [{ ... }]` and `label = "A"`
truth-label-with-circles = `label` in [[poses]] is for `joints`, not for `circles`
    .hint = omit `label`, or replace `circles` with `joints`

# Means: [[poses]] refers to a point, but no [[point]] has this label.
# Matters: The position of the pose is unknown.
# Do: Correct the label, or add a [[point]] with this label.
# Example: `label = "P3"` without a [[point]] of this label
truth-point-unknown = [[poses]] refers to the point `{ $label }`, but no [[point]] has this label

# Means: `circles` are given for a spatial robot.
# Matters: Circles are poses of a planar platform.
# Do: Replace `circles` with `joints`.
# Example: `circles` for a serial arm
truth-circles-not-planar = `circles` are for planar robots
    .hint = replace `circles` with `joints`

# Means: [parameters] contains a parameter that the robot model does not have.
# Matters: The value has no effect.
# Do: Correct the name; the message proposes similar names.
# Example: `s_9 = 1.0`
truth-parameter-unknown = [parameters] contains `{ $parameter }`, which is not a parameter of this robot

# Means: [repeatability] of the truth contains a target that the robot does not have.
# Matters: No position can be simulated.
# Do: Use the name of a target of the robot.
# Example: `target = "T9"`
truth-target-unknown = [repeatability] of the truth: the robot has no target `{ $target }`

# Means: The trajectory contains a pose that is missing in the truth.
# Matters: The position and the scatter of this pose are unknown.
# Do: Add the pose to `joints` of [[poses]] and to [[repeatability.pose]].
# Example: `trajectory = [1, 2, 6]` with five poses
truth-pose-missing = pose { $pose } of the trajectory is missing in the truth
    .hint = add it to `joints` of [[poses]] and to [[repeatability.pose]]

# Means: The truth has [repeatability], but the campaign does not.
# Matters: The labels and the trajectory come from the campaign.
# Do: Add [repeatability] to campaign.toml.
# Example: truth.toml of a test with a campaign.toml of a calibration
truth-repeatability-without-campaign = the truth has [repeatability], but the campaign does not
    .hint = add [repeatability] to campaign.toml: the labels and the trajectory come from there

# Means: `home` has more or fewer joint values than the robot has joints.
# Matters: The home position is undefined.
# Do: Write one value for each joint into `home`.
# Example: `home = [0, 0]` for three joints
truth-home-count = `home` has { $values } joint values, but the robot has { $joints } joints
    .hint = give one value for each joint

# Means: `etalon simulate` cannot write this kind of file.
# Matters: The campaign cannot be tested on simulated data without a change.
# Do: For the simulation, use a file of a simpler kind. Afterwards replace it with the real file.
# Example: a log with `standstill`
simulate-not-written = `etalon simulate` cannot write { $what }
    .hint = use a file that can be simulated, and replace it with the real file afterwards

# Means: The campaign contains several tables of observations.
# Matters: `etalon simulate` writes a single table.
# Do: Make a campaign with one of the tables for the simulation.
# Example: two [[observations]] and a truth.toml
several-tables = `etalon simulate` writes one table of observations, not several
    .hint = simulate a campaign with one of them

simulated-kind = { $kind ->
        [twincat] a TwinCAT export
        [moving-log] a log that is recorded while the robot moves
        [period-log] a log with `period_s` for a join by time
        [repeated-columns] a log that uses a column twice
        [workbook-sheet] a sheet of a workbook
        [encoding] a table in another encoding than UTF-8
        [blank-columns] a table of observations with blanks between columns: its empty cells would be lost
        [computed-columns] a table of observations with computed, numbered or constant columns, filters, or a header that is not exactly one row
        [unmodelled] a table of observations with errors of {"["}unmodelled]
        [circumstances] a log of a robot with backlash whose readings give a payload, torques or a temperature
       *[backlash] a table of observations of a robot with backlash
    }

# Means: `coordinates` is given, but the observation is not a point in the world frame.
# Matters: Only for points, some of the coordinates may be missing.
# Do: Omit `coordinates` in this [[observe]].
# Example: `kind = "distance"` and `coordinates = "xy"`
coordinates-of-other-kind = `coordinates` is for kind `point` without a station
    .hint = omit `coordinates`

in-numbered-table = [[{ $table }]] { $number }: { $message }

in-set = set `{ $set }`: { $message }

# Means: The truth contains no points for this export.
# Matters: The export is empty.
# Do: Add a [[point]] with this `export`, or add `label` or `target` to the export in the campaign.
# Example: an export `world.txt` and no [[point]] with `export = "world.txt"`
export-without-points = the truth contains no points for the export `{ $file }`
    .hint = add a [[point]] with this `export`, or add `label` or `target` to the export in the campaign

# Means: An export in the campaign has another encoding than UTF-8.
# Matters: `etalon simulate` writes only UTF-8.
# Do: Omit `encoding` of this export for the simulation.
# Example: `encoding = "windows-1252"`
simulate-utf8 = `etalon simulate` writes only UTF-8
    .hint = omit `encoding` of this export

# Means: If etalon reads the simulated export again, it finds another number of rows.
# Matters: The simulation does not test this campaign.
# Do: Add target, pose and cycle to `label` or to `columns`.
# Example: a point at 0, 0, 0 in a PolyWorks file, which counts as not measured
simulated-rows-lost = `{ $file }` has { $rows } rows, but etalon would read { $read }
    .hint = add target, pose and cycle to `label` or `columns`; `pose = "row"` is for one target per file; without a cycle, set `cycles = 1` in the truth

# Means: If etalon reads the simulated export again, it takes a row for another measurement.
# Matters: The simulation does not test this campaign.
# Do: Add target, pose and cycle to `label` or to `columns`.
# Example: labels without the number of the cycle
simulated-row-misread = line { $line } of `{ $file }` is { $meant }, but etalon would read it as { $read }
    .hint = add target, pose and cycle to `label` or `columns`; `pose = "row"` is for one target per file; without a cycle, set `cycles = 1` in the truth

measurement-name = target `{ $target }`, pose { $pose }, cycle { $cycle }

# Means: A pose of the truth violates a limit of the robot.
# Matters: A real robot cannot reach this pose.
# Do: Correct the pose in the truth, or the limits in [reach] of robot.toml.
# Example: a joint value of 200 deg with a limit of 170 deg
truth-pose-out-of-reach = pose { $pose } is out of reach: { $reason }
    .hint = correct the pose in the truth, or [reach] in robot.toml

# Means: The true robot cannot move its target to a point.
# Matters: There are no joint values for this pose.
# Do: Correct the coordinates of the point, or use another point for the pose.
# Example: a point 5 m away from an arm of 1 m
truth-point-out-of-reach = pose { $pose }: the true robot does not reach its point { $point } mm
    .hint = correct the point or the pose in the truth

# Means: The truth has [[observe]], but the campaign has no [observations].
# Matters: The file and its columns are unknown.
# Do: Add [observations] with `file` to campaign.toml.
# Example: [[observe]] of a distance without [observations]
observe-without-table = the truth has [[observe]], but the campaign has no [observations]
    .hint = add [observations] with `file` to campaign.toml

# Means: The campaign has [observations], but the truth has no [[observe]].
# Matters: The table is empty.
# Do: Add an [[observe]] for each kind of observation to the truth.
# Example: [observations] with `file` and a truth without [[observe]]
table-without-observe = the truth has no [[observe]] for the table of [observations]
    .hint = add an [[observe]] with kind = "point", target = "ball" ...; docs/observations.md lists the kinds

# Means: The campaign is not marked as synthetic.
# Matters: Its files may be measured data, which simulated data must never overwrite.
# Do: Set `synthetic` in campaign.toml. Every report then says that the data are synthetic.
# Example: `etalon simulate` in the folder of a real campaign
campaign-not-synthetic = the campaign is not marked as synthetic: its files may be measured data
    .hint = set `synthetic = "how the data are made"` in campaign.toml; `etalon init --synthetic FOLDER` writes such a campaign with a truth

# Means: `decimals` is larger than the number of decimals of a floating-point number.
# Matters: The additional digits are rounding errors.
# Do: Use fewer decimals.
# Example: `decimals = 30`
truth-decimals = { $decimals } decimals exceed the precision of a number
    .expected = 0 to { $most }

# Means: One file of the campaign contains both joints and points.
# Matters: `etalon simulate` writes exports and logs as separate files.
# Do: For the simulation, use a separate export and a separate [log].
# Example: an export with `joints`
joints-and-points-together = a file with joints and points together cannot be simulated
    .hint = use a separate export and a separate [log]

# Means: The label of a [[point]] begins like a formula of a spreadsheet.
# Matters: A spreadsheet runs the label as a formula.
# Do: Change the label.
# Example: `label = "=A1"`
point-label-formula = a spreadsheet would read the label `{ $label }` of a [[point]] as a formula
    .hint = use a label that does not begin with = + - or @

# Means: [parameters] does not contain the coordinates of a fixed point or surface that is observed.
# Matters: The true position of this point or surface is unknown.
# Do: Add its coordinates to [parameters].
# Example: a target `anchor_A` without the parameter `anchor_A_x`
truth-parameters-missing = [parameters] does not contain { $parameters }
    .hint = add the true positions of the observed fixed points and surfaces

# Means: [unmodelled] contains a joint that the robot does not have.
# Matters: The error has no effect.
# Do: Use the name of a joint of the robot.
# Example: `backlash = { q9 = 0.01 }`
unmodelled-joint-unknown = [unmodelled] contains `{ $joint }`, which is not a joint of this robot

# Means: The period of an interpolation error is zero, negative or not a number.
# Matters: The error repeats after this period of the joint.
# Do: Give a positive period in the unit of the joint.
# Example: `interpolation = { q1 = { period = 0 } }`
unmodelled-period = [unmodelled] `period` of `{ $joint }` must be positive
    .hint = give a positive period

# Means: A set of poses does not determine all parameters.
# Matters: The undetermined parameters stay at their nominal values in all calibrations.
# Do: Add poses in which more joints move.
# Example: two poses that differ in one joint
study-too-few-poses = too few poses to identify all parameters
    .hint = add poses to the set

# Means: A set contains no pose within the reach of the robot.
# Matters: There is nothing to simulate.
# Do: Add poses that the robot can reach.
# Example: a circle outside of the workspace
study-set-empty = a set has no pose that the robot reaches
    .hint = add poses that the robot can reach

# Means: The poses are given as positions, but this robot needs joint values.
# Matters: A position alone does not determine the joints of this robot.
# Do: Use `joints`, or a table in `file`.
# Example: `positions_mm` for a serial arm
study-not-by-position = positions do not determine the joints of `{ $model }`
    .hint = use `joints`, or a table in `file`

# Means: The targets touch at no joint values near the joint values in the truth.
# Matters: The observation cannot be simulated.
# Do: Choose joint values nearer to the contact, or increase the range in which joint values are
# varied.
# Example: a plane 2 m away from the robot
truth-not-touching = pose { $pose }: there is no contact at joint values near the ones in the truth
    .hint = choose joint values nearer to the contact, or increase the range in which joint values are varied

# Means: The uncertainty of angles is missing.
# Matters: Simulated orientations have no noise, and identified orientations no weight.
# Do: Set `expanded_rotation_uncertainty_deg` in [instrument], or `urot_deg` in the [[observe]].
# Example: `kind = "orientation"` without an uncertainty
angle-uncertainty-missing = the uncertainty of an angle is missing
    .hint = set `expanded_rotation_uncertainty_deg` in [instrument], or `urot_deg` in the [[observe]]

# Means: The truth has [geometric], but the campaign has no [geometric], or its robot is not a
# PreXYT.
# Matters: The labels of the geometric method come from the campaign.
# Do: Add [geometric] to campaign.toml.
# Example: [geometric] in truth.toml alone
truth-geometric-without-campaign = the truth has [geometric], but the campaign has no [geometric] or its robot is not a PreXYT
    .hint = add [geometric] to campaign.toml: the labels come from there
study-error-in-base = true pose of the tool minus commanded pose, in the base frame
study-error-in-world = true pose of the tool minus commanded pose, in the world frame
poses-in-set = poses in the set `{ $set }`
positions-in-workspace = positions in `workspace`
counted-calibrations = calibrations
errors-to-evaluate = errors to evaluate
poses-to-simulate = poses to simulate
points-to-simulate = points to simulate

### Messages of cli. Above each message: its explanation (see CONTRIBUTING.md, "A message").

batch-done = done
batch-failed = failed
batch-not-done = { $ended }: { $campaign }
batch-not-met = not met
batch-skipped = skipped
batch-unchanged = { $ended }, unchanged
# Means: No message of the catalogue has this id.
# Matters: Only ids of the catalogue have an explanation.
# Do: Copy the id from the brackets of the message, or list all ids with `etalon explain`.
# Example: `etalon explain parameter-twise`
message-unknown = `{ $id }` is not the id of a message

# Means: An option that needs a positive number has zero, a negative number or NaN.
# Matters: The value has no meaning.
# Do: State a positive number.
# Example: `--near-mm inf`
option-not-positive = { $option } must be positive
    .hint = state a positive number

# Means: The value of an option cannot be read.
# Matters: The command never guesses a value.
# Do: Use one of the values that `--help` lists.
# Example: `--delimiter comma2`
option-refused = { $option }: { $reason }
    .hint = `etalon COMMAND --help` lists the values

# Means: An option that names a column has no `=`.
# Matters: It is unknown what is stated about the column.
# Do: State NAME=HEADING, NAME=VALUE or COLUMN=CELL.
# Example: `--column q1_deg`
column-option-malformed = --{ $option }: `{ $text }` has no `=`
    .expected = { $option ->
        [column] q1_deg=J1
        [constant] kind=distance
       *[other] deleted=1
    }

# Means: The columns are stated from the left (`--columns`) and by name (`--column`).
# Matters: The two statements may differ.
# Do: Omit one of the two options.
# Example: `--columns x,y,z --column x=X`
option-columns-twice = --columns and --column both state the columns
    .hint = omit one of the two options

# Means: Neither an option nor the file states the unit of lengths.
# Matters: Most exports carry no unit; a wrong guess falsifies every result.
# Do: State the unit.
# Example: `etalon fit plane points.txt`
option-unit-missing = the length unit of the files is not stated
    .hint = state it: --unit mm, m, um or inch; it is never guessed

# Means: parameters.json is named without the robot to which it belongs.
# Matters: Deviations are computed with the robot model.
# Do: Name the robot.toml.
# Example: `etalon axis-table parameters.json --axis q1_mm=0:100:10`
robot-option-missing = parameters.json needs --robot FILE
    .hint = name the robot.toml: --robot FILE

# Means: An axis is named that the robot lacks.
# Matters: Its table cannot be computed.
# Do: Use a joint of the robot, or x_mm, y_mm, z_mm.
# Example: `--axis q9_mm=0:100:10`
axis-unknown = the robot has no axis `{ $axis }`
    .hint = use a joint of the robot, or x_mm, y_mm, z_mm

# Means: Cartesian axes and joints are mixed in one table.
# Matters: The positions of a table are those of the tool or of joints.
# Do: Use one kind.
# Example: `--axis x_mm=0:100:10 --axis q1_deg=0:90:10`
axes-mixed = the axes of a table are either Cartesian (x_mm, y_mm, z_mm) or joints
    .expected = joints { $joints }

# Means: A table of several joints names a revolute joint.
# Matters: The correction of one joint by another is defined only for prismatic joints in series.
# Do: Use x_mm and y_mm, positions of the nominal robot.
# Example: `--axis q1_deg=0:90:10 --corrected q2_deg`
table-of-turning-joints = a table of several joints needs prismatic joints in series
    .hint = use x_mm and y_mm, positions of the nominal robot

# Means: geometric.json has no lead of the named axis.
# Matters: Its deviations are unknown.
# Do: Measure the lead ([[geometric.lead]]), or name another axis.
# Example: `--axis rho3_mm=0:100:10` where leads 1 and 2 were measured
lead-not-measured = no lead of `{ $axis }` was measured
    .expected = { $measured }

# Means: A lead is used for more than one axis, or to correct another one.
# Matters: A lead is the deviation of an actuator as a function of its own position.
# Do: Name the actuator alone.
# Example: `--axis rho1_mm=0:100:10 --corrected rho2_mm`
lead-of-one-axis = a lead corrects a single axis by its own position
    .hint = name this axis alone

# Means: A cell of the table is empty or not a number.
# Matters: The row cannot be used, and leaving it out without a message would change the result.
# Do: Correct or remove the row.
# Example: an empty cell in the column `x_mm`
table-value-missing = a value is missing or not a number
    .hint = correct or remove the row

# Means: The positions of the table do not form a grid.
# Matters: A plane is interpolated between nodes of a grid.
# Do: State one row for each position of each base axis.
# Example: a table without the row of one corner
not-a-grid = the positions do not form a grid
    .expected = one row for each position of each base axis

# Means: The positions of a base axis are not stated.
# Matters: The table has no rows.
# Do: State from, to and step.
# Example: `--axis q1_mm` for parameters.json
axis-without-positions = `{ $axis }` has no positions
    .expected = --axis { $axis }=FROM:TO:STEP

# Means: The compensated command needs another configuration of the robot than the target states, or a long motion of a joint.
# Matters: A singularity lies between the target with and without compensation: the robot would turn its joints on the way. A program or list is not written.
# Do: Move the target away from the singularity, or check working mode, `confdata`, Status and Turn of the target.
# Example: a target at a wrist singularity
configuration-changed = target { $target }: the compensated command needs another configuration
    .hint = move the target away from the singularity, or check its configuration data (working mode, confdata, Status and Turn)

# Means: The program computes poses while it runs.
# Matters: Computed poses are not compensated.
# Do: Check these poses: a pose computed from a compensated target has the compensation of that
# target, not its own.
# Example: `Offs(p1, 0, 0, 100)` in RAPID
poses-computed-by-program = poses computed by { $names } are not compensated
    .hint = check them: a pose computed from a compensated target has the compensation of that target, not its own

# Means: The program does not state the working mode at its start.
# Matters: A five-bar robot reaches a point in several working modes.
# Do: State the joint values at the start.
# Example: a Mecaprol program without `--start`
working-mode-missing = the program does not state the working mode at its start
    .hint = state the joint values at the start: --start N,N,+1

# Means: The program uses a tool or a work object whose pose is not stated.
# Matters: Targets are poses of this tool in this frame.
# Do: State its pose; give the targets of several tools or frames as programs of their own.
# Example: `MoveL p1, v10, fine, tGrip` without `--tool`
program-frames = the program uses { $names }

one-program-each = split the program: one program for each

state-pose-option = state its pose: --{ $option } x,y,z,qw,qx,qy,qz

# Means: The program states its tool or base in numbers, and the option states another pose.
# Matters: Targets are poses of one of the two: the other compensation is wrong.
# Do: State the pose of the program, or omit the option if it is the flange or the base.
# Example: `$TOOL={X 0,Y 0,Z 150,A 0,B 0,C 0}` with `--tool 0,0,0`
program-frame-other = the program states { $frame }, and --{ $option } states another pose
    .hint = state the pose of the program: --{ $option } { $pose }

# Means: `--frame world` is stated for a program.
# Matters: Targets of a program are in the frame of its work object.
# Do: State `--object`.
# Example: `etalon compensate a.mod --frame world`
program-in-world = targets of a program cannot be in the world frame
    .hint = use --object

# Means: The encoder counts per mm or deg of the axes are missing.
# Matters: Positions of a Galil controller are encoder counts.
# Do: State the counts of each axis.
# Example: `--format galil` without `--counts-per-unit`
counts-missing = `galil` needs the encoder counts per mm or deg of { $axes } axes
    .hint = state --counts-per-unit N,N

# Means: `--frame world` is stated for targets by joint values.
# Matters: Joint values have no frame.
# Do: Omit `--frame`.
# Example: a table of joints and `--frame world`
joints-in-world = joint values have no frame
    .hint = omit --frame

# Means: The nominal robot has no pose at these joint values.
# Matters: The target has no nominal pose.
# Do: Check the joint values and the assembly mode.
# Example: joint values of another assembly mode
nominal-pose-unreachable = the nominal robot has no pose at these joint values
    .hint = check joint values and assembly mode

# Means: At this pose joints can move without moving the tool: the pose is singular, and its solutions are a family.
# Matters: The answer has one member of the family, the nearest to the start. Near the pose the joints turn fast, and errors of the pose grow.
# Do: State the joints of the row for another member, or avoid the pose.
# Example: a pose with q5 = 0, where q4 and q6 turn about the same axis
pose-singular = pose { $pose } is singular: { $joints } can move together without moving the tool; the solution nearest to the start is given
    .hint = state joint values in the row to choose another solution, or avoid the pose

# Means: The robot model has no base in the world frame.
# Matters: Targets in the world cannot be moved into the base.
# Do: Omit `--frame world`.
# Example: `--frame world` for a model without base parameters
base-not-in-world = `{ $model }` has no base in the world frame
    .hint = omit --frame

# Means: Mecaprol is the language of five-bar robots.
# Matters: The robot cannot be commanded in it.
# Do: Use another format.
# Example: `--format mecaprol` for a serial arm
mecaprol-other-robot = Mecaprol commands a five-bar robot, not `{ $model }`
    .hint = use another --format

# Means: The identified robot does not reach a target.
# Matters: The target cannot be compensated.
# Do: Move the target, or check limits in robot.toml.
# Example: a target beyond the travel of a joint
target-unreachable = target { $target }: { $reason }
    .hint = move the target, or check the limits in robot.toml

# Means: The robot does not reach a pose of the table.
# Matters: The answer has no joint values for it.
# Do: Check the pose, and limits in robot.toml.
# Example: a pose beyond the reach of an arm
pose-unreachable = pose { $pose }: { $reason }
    .hint = check the pose and the limits in robot.toml

# Means: `--controller-hash` is stated without a format that contains the hash of a calibration.
# Matters: Other formats have no hash of a controller.
# Do: Name the format, or omit the hash.
# Example: `--format csv --controller-hash calib_1`
hash-of-other-format = `--controller-hash` is for the formats that contain it: { $formats }
    .hint = name one of them with --format

# Means: A run wrote the output folder while files for a controller were made from it.
# Matters: The files may contain parameters of two runs.
# Do: Repeat the command.
# Example: `etalon run` and `etalon export` at the same time
run-while-exporting = a run wrote `{ $folder }` while files for a controller were made
    .hint = repeat the command: the files may contain earlier parameters

# Means: An element is named without a file.
# Matters: There are no points.
# Do: Name the file.
# Example: `etalon fit plane`
fit-file-missing = no file of points is stated for `{ $element }`
    .hint = name the file: etalon fit { $element } FILE

# Means: No element is named, and the file is not QIF.
# Matters: Only QIF files name the elements of their features.
# Do: Name the element.
# Example: `etalon fit points.txt`
fit-element-missing = the element is not stated, and the file is not QIF
    .hint = state it: etalon fit ELEMENT { $file }

# Means: Columns or a radius are stated for a QIF file.
# Matters: A QIF file has no columns, and its features have different radii.
# Do: Omit these options.
# Example: `etalon fit b.qif --radius-mm 15`
qif-with-columns = a QIF file has neither columns nor one radius for all its features
    .hint = omit --columns, --delimiter and --radius-mm

# Means: A data set of a test is for an element that the test package does not have.
# Matters: No answer can be given for it.
# Do: Compare the data set with the manual of the test.
# Example: `TORUS` in a test of Gaussian elements
tracim-object-unknown = the element `{ $object }` of data set `{ $id }` is unknown in this test
    .expected = LINE_3D, PLANE, CIRCLE, CYLINDER, CONE or SPHERE (Gauss); LINE_2D, CIRCLE_2D, PLANE, SPHERE or CYLINDER (Chebyshev)

# Means: The answer has no customer.
# Matters: The server refuses answers without a customer.
# Do: State the customer as registered.
# Example: `etalon fit --tracim data.xml`
tracim-customer-missing = the customer of the answer is blank: the server refuses it
    .hint = add --customer NAME, as registered with TraCIM

# Means: The public documents state all names of an answer except the one of the form deviation.
# Matters: `formDeviation` is named like its maximum permissible error `mpe_formDeviation`; another name would be refused.
# Do: Try the answer with the free sample test, or compare it with the schema of the server.
# Example: `etalon fit --tracim chebyshev.xml --customer NAME`
tracim-form-name = the name of the element `formDeviation` is not in the public documents of the Chebyshev test
    .hint = try the answer with the free sample test of the server before an ordered one

# Means: No measured feature of the QIF file was fitted.
# Matters: The answer is empty.
# Do: Name an element of which the file has points.
# Example: `etalon fit plane b.qif` where the file has circles only
no-feature-fitted = no measured feature was fitted as { $kind }
    .expected = features with points that determine them
    .hint = features with points in the file: { $seen }

# Means: The side of the probe is neither inside, outside nor a direction.
# Matters: The element would be moved by the probe radius to an unknown side.
# Do: State the side.
# Example: `--probe-side left`
probe-side-unknown = --probe-side: `{ $text }` is not a side
    .expected = inside, outside, or three numbers x,y,z towards the probe
    .hint = inside for a bore, outside for a shaft, 0,0,1 for a probe above a plane

# Means: The radius of the probe is stated without its side.
# Matters: It is unknown whether the probe radius is added or subtracted.
# Do: State the side.
# Example: `--probe-radius-mm 2.5` alone
probe-side-missing = the side of the probe is not stated
    .expected = --probe-side inside, outside or x,y,z
    .hint = inside for a bore, outside for a shaft, the direction to the probe for a plane or line

# Means: The side of the probe is stated without its radius.
# Matters: Without the radius nothing is compensated.
# Do: State the qualified radius, or omit both for contact points.
# Example: `--probe-side inside` alone
probe-radius-missing = --probe-side is stated without the probe radius
    .expected = --probe-radius-mm
    .hint = state the qualified radius of the probe, or omit both for contact points

# Means: A probe is stated for an enclosing circle or sphere.
# Matters: Enclosing elements of probe centres cannot be corrected by the radius.
# Do: Omit the probe.
# Example: `etalon fit enclosing-sphere p.txt --probe-radius-mm 2.5 --probe-side inside`
enclosing-with-probe = { $element } is not compensated for a probe
    .hint = omit --probe-radius-mm and --probe-side

# Means: `--minimum-zone` is stated for an enclosing circle or sphere.
# Matters: An enclosing element has no zone.
# Do: Omit `--minimum-zone`, or fit a circle2d or sphere.
# Example: `etalon fit enclosing-circle p.txt --minimum-zone`
enclosing-minimum-zone = an { $element } has no minimum zone
    .hint = omit --minimum-zone, or fit a circle2d or sphere

# Means: A stated uncertainty cannot be that of a coordinate in micrometres.
# Matters: The uncertainties of all results depend on it.
# Do: State expanded uncertainty over coverage factor, per coordinate, in µm.
# Example: `--standard-uncertainty-um 0.0027` for 2.7 µm
uncertainty-implausible = { $option } cannot be the uncertainty of a coordinate in micrometres
    .hint = state the expanded uncertainty over the coverage factor, per coordinate: 0.0027 mm is 2.7 µm

# Means: The named robot is not in the table of `etalon init`.
# Matters: Geometry is taken from published sources only.
# Do: Describe the robot by its URDF, or by your own robot.toml.
# Example: `etalon init arm --robot ur99`
robot-not-in-table = the geometry of `{ $name }` is not in the table of robots
    .expected = { $names }
    .hint = describe it by your own robot file, --robot robot.toml, or by its URDF, --urdf FILE

# Means: A row has no position, no measured value or no direction.
# Matters: Positioning is evaluated for each position and direction (ISO 230-2).
# Do: Complete the row.
# Example: a row with direction 0
iso230-row-incomplete = a row has no position, no measured value or no direction
    .expected = numbers, and +1 or -1 as `direction`

# Means: A position has fewer than two runs in a direction.
# Matters: A standard deviation needs two values; ISO 230-2 requires five.
# Do: Measure more runs.
# Example: one run from the negative side
iso230-few-runs = position { $position } mm has fewer than two runs in direction { $direction }
    .expected = at least two runs in each direction, five to ISO 230-2

# Means: `--drift-set` is smaller than two cycles.
# Matters: Drift compares means and scatter of sets of cycles.
# Do: State two cycles or more.
# Example: `--drift-set 1`
drift-set-too-small = { $option } must be at least 2
    .hint = state the number of cycles of a set

# Means: No commanded poses are stated.
# Matters: AP, distances and drift are relative to commanded poses; RP needs none.
# Do: State them with `--commanded`.
# Example: `etalon iso9283 --poses attained.csv`
commanded-missing = no commanded poses are stated: AP is not evaluated (null); RP needs none
    .hint = state them with --commanded for AP, distances and drift

# Means: The arm has more joints than a pose has degrees of freedom.
# Matters: It reaches a pose in infinitely many ways.
# Do: Ask for one solution.
# Example: `etalon kinematics inverse` for a seven-axis arm
infinite-solutions = { $joints } joints reach a pose in infinitely many ways
    .hint = ask for one: --nearest

# Means: The robot model has no kinematics of position and orientation.
# Matters: The command works on whole poses.
# Do: Use another model.
# Example: a program's own model without kinematics
no-whole-pose = `{ $model }` has no kinematics of a whole pose
    .hint = use another model

# Means: The command needs one chain of joints, from the base to one tool.
# Matters: A robot with several branches has a tool at the end of each.
# Do: Use the calibrated URDF in a robot.toml with one `tool_link`.
# Example: `etalon kinematics` for a robot with [[branch]]
several-branches = a robot with several branches ({ $links }) has no single chain
    .hint = state one link as `tool_link` of a robot.toml whose URDF is the calibrated one: `etalon export --format urdf` writes the calibrated tree

# Means: A quaternion of the table does not have the length 1.
# Matters: Its components are probably in another order or mistyped.
# Do: Correct the quaternion.
# Example: `qw,qx,qy,qz` = 0.7, 0, 0, 0.6
table-quaternion-length = the quaternion has the length { FIXED($length, 4) }
    .expected = 1: qw, qx, qy, qz of a rotation
    .hint = check the order of the columns (qw is the scalar part), and that they are not angles

# Means: The name of a file does not end like a report.
# Matters: The kind of report follows from the ending.
# Do: Use one of the endings.
# Example: `--report plan.docx`
not-a-report = `{ $file }` does not end like a report
    .expected = a file that ends in { $endings }

# Means: A run failed, and the output folder holds the results of an earlier one.
# Matters: Its report and controller files are not those of this run.
# Do: Do not load controller files from this folder: they belong to the earlier run.
# Example: a run that stops at an error in campaign.toml
earlier-run-left = nothing is written: `{ $report }` and the files beside it are from an earlier run
    .hint = do not load controller files from this folder: they belong to the earlier run

# Means: There is no schema of this name.
# Matters: Schemas exist for input files and JSON documents.
# Do: Use a name that `etalon schema --help` lists.
# Example: `etalon schema parameter`
schema-unknown = unknown schema `{ $name }`

# Means: The observations contain a quantity that the calibration did not observe.
# Matters: The model error of this quantity is unknown, so its deviations cannot be judged.
# Do: Leave these rows out, or calibrate with observations of this quantity.
# Example: orientations, where only positions were calibrated
verify-quantity-without-residuals = the calibration has no residuals of the quantity "{ $quantity }": its model error is unknown
    .hint = leave these rows out, or calibrate with observations of this quantity

# Means: No row of the observations has a whole position of a target.
# Matters: Motions of base and joints are found from positions.
# Do: Measure positions of targets.
# Example: a table of contacts alone
verify-without-positions = the observations contain no position of a target
    .hint = measure positions of the targets of the calibration

# Means: The campaign of `--like` has no section `[observations]`.
# Matters: The section states how the table is read.
# Do: State a campaign with this section, or the options of tables.
# Example: a campaign with exports and a log
campaign-without-observations = the campaign `{ $campaign }` has no section `[observations]`
    .hint = state a campaign with this section, or the options of tables (`--column` ...)

# Means: The campaign of `--like` has several sections `[[observations]]`, which may describe different tables.
# Matters: The columns of another table would be read in a wrong meaning.
# Do: State how the table is read by the options of tables.
# Example: a campaign with a table of positions and one of distances
campaign-with-several-observations = the campaign `{ $campaign }` has { $count } sections `[[observations]]`; which of them describes the table is open
    .hint = state how the table is read by the options of tables (`--column` ...) instead of `--like`

# Means: The workspace does not have six or four numbers.
# Matters: A box has six coordinates, a rectangle four.
# Do: State the smallest coordinates, then the largest.
# Example: `--workspace-mm 1,2,3`
workspace-numbers = --workspace-mm has { $count } numbers
    .expected = six, or four for planar robots

# Means: A reorientation is stated without an initial orientation.
# Matters: A test on reorientation starts at a stated orientation.
# Do: State `--orientation-deg` as well.
# Example: `--reorientation-deg 0,0,30` alone
reorientation-alone = a reorientation is stated without an initial orientation
    .hint = state --orientation-deg as well

# Means: The robot file does not state the reach of the robot.
# Matters: The plan cannot be checked against limits.
# Do: Omit `--robot`, and try the positions on the robot at low speed.
# Example: a URDF model without limits
reach-unknown = the robot file of model `{ $model }` does not state its reach
    .hint = omit --robot, and try the positions on the robot at low speed

# Means: Rows were excluded as stated.
# Matters: Excluded rows do not take part in the result; the report repeats them.
# Do: Check the reason.
# Example: `--exclude 4-6:reflector loose`
excluded-rows = excluded: { $count ->
        [one] 1 row
       *[other] { $count } rows
    }, rows { $rows }: { $reason }

# Means: The format leaves identified parameters out, and the run did not identify again without
# them.
# Matters: The file holds the estimate conditioned on nominal values of these parameters; the
# accuracy of the robot with this file is unknown.
# Do: Run the campaign with the format among its `controllers`, and export from its output folder.
# Example: `etalon export --format linuxcnc parameters.json` for an arm with bending
controller-error-not-measured = format `{ $format }` does not hold { $parameters }: the file is conditioned on nominal values of these, and its error was not measured
    .hint = run the campaign with "{ $format }" among its `controllers`, and export from its output folder; recommended parameters: `etalon export CAMPAIGN --parameters recommended`

# Means: `--from` is stated without a robot.
# Matters: Joints and targets are those of a robot.
# Do: Name the robot, or its URDF.
# Example: `etalon init cell --from points.csv`
from-needs-robot = --from needs the robot
    .hint = name it: --robot ur5e, --robot robot.toml for your own robot file, or --urdf FILE

# Means: Two files of `--from` have the same name in different folders.
# Matters: The files are copied into one folder.
# Do: Give one of them another name.
# Example: `--from a/points.csv b/points.csv`
two-files-of-one-name = two files are called `{ $name }`
    .hint = give one of them another name

# Means: The lines that `etalon formats` proposes for a file are not TOML.
# Matters: A campaign cannot be written from them.
# Do: Report the file as a defect; state the format by hand in campaign.toml.
# Example: two tables of attained poses beside one of commanded poses
proposal-not-toml = the proposal for `{ $name }` cannot be read: { $error }

# Means: A URDF has several chains of joints, to fingers or to other arms, and the longest was chosen.
# Matters: The robot has the joints of that chain, and its last link carries the targets.
# Do: State the link that carries the targets, if another one does.
# Example: `etalon init arm --urdf FILE` with the URDF of an arm with a gripper
urdf-chain-chosen = the chain from `{ $base }` to `{ $tool }` with { $count ->
        [one] one joint
       *[other] { $count } joints
    } was chosen; other chains end at { $others }
    .hint = if another link carries the targets, state `tool_link` in robot.toml; in Python `Robot.from_urdf(path, tool_link="{ $other }")`

tool-link-longest = the chain with the most moving joints: the files have no joints
tool-link-by-names = the files name the joints of this chain
tool-link-by-count = the files have { $count } columns of joints, as this chain alone
tool-link-by-residual = with this chain the nominal robot reproduces the points with a residual of { FIXED($rms_mm, 2) } mm, with every other chain at least three times as much
tool-link-shortest = with this chain the nominal robot reproduces the points with a residual of { FIXED($rms_mm, 2) } mm; further joints do not reduce it
tool-link-moves = the files name the joints of this chain; further joints of them do not move
tool-link-fits = `{ $link }` fits the files: its joints are { $joints }

# Means: No column of a file is recognised as coordinates or joints.
# Matters: The campaign would not read the file.
# Do: Look at the columns with `etalon formats`, and state the format in campaign.toml.
# Example: `etalon init NEW --from README.md`
nothing-recognised = no column of `{ $name }` is recognised
    .hint = `etalon formats { $path }` states what its columns could be

# Means: An option of a call is unknown, has a wrong value, or lacks another option.
# Matters: Options are checked as on the command line.
# Do: Correct the option; `etalon COMMAND --help` lists all.
# Example: `etalon.plan(robot, table, positions="many")` in Python
option-of-call-refused = { $reason }

# Means: Options of `etalon axis-table` contradict each other or the format.
# Matters: The table would be wrong, or its format cannot hold it.
# Do: Correct the option that the message names.
# Example: `--to sinumerik-cec` without `--sign`
table-options-refused = { $fault ->
        [axes] a table has one base axis or two different ones
        [positions] the table has more than { $most } positions
        [zero] --zero-at needs one position for each base axis
        [numbers] --numbers needs one number for each axis
        [sign-missing] the vendor does not publish the sign of the values in this table: --sign is missing
        [sign-known] --sign is for tables whose sign is not published
        [plane] a plane needs two base axes
        [one-axis] this table has one base axis
       *[own-axis] this table has one base axis, which is the corrected axis
    }
    .hint = { $fault ->
        [sign-missing] state --sign add or --sign subtract, after a trial at one position of the machine
       *[other] correct the option; `etalon axis-table --help` describes them
    }

# Means: The deviation of an axis cannot be computed at a position of the table.
# Matters: A table of corrections needs a value at each position.
# Do: Use positions that the robot reaches, or that were measured.
# Example: `--axis rho1_mm=0:500:10` where the lead was measured to 400 mm
deviation-unknown = no deviation at { $position }: { $reason }
    .hint = use positions that the robot reaches, or that were measured

robot-file-of-run = run the campaign again, or name the robot.toml of that run
# Means: The robot model has no chain of joints.
# Matters: Only chains have screw axes, Denavit-Hartenberg parameters or a URDF.
# Do: Convert arms alone.
# Example: `etalon robot convert` for a five-bar
convert-no-chain = `{ $model }` has no chain of joints; other conventions cannot describe it

# Means: Joint values move several axes of the chain.
# Matters: robot.toml of a serial arm has one joint value for each axis.
# Do: Keep the URDF, where `mimic` states it.
# Example: a gripper or a parallelogram with `mimic`
convert-shared-joints = { $axes } axes share { $joints } joint values
    .hint = keep the URDF, where `mimic` states it

# Means: The robot has bending, harmonics, backlash or coupling.
# Matters: A description of axes alone has no place for them; the converted robot lacks them.
# Do: State them in the new robot.toml, and identify them again.
# Example: an arm with `bending = [2, 3]`
convert-left-out = { $count ->
        [one] 1 parameter is not geometry and is left out
       *[other] { $count } parameters are not geometry and are left out
    }: { $names }
    .hint = state `bending`, `harmonics`, `backlash` and `coupling` in the new file, and identify them again

# Means: Joint values are multiplied by a gain.
# Matters: A URDF has no gains: its joint values are those of the axes.
# Do: Multiply the joint values, or convert to `poe`.
# Example: a joint logged in motor angles
convert-gains-not-held = a URDF has no gain of { $joints }: its joint values are those of the axes
    .hint = multiply the joint values, or convert to `poe`

# Means: The travel of a sliding joint is not stated, and a URDF demands one.
# Matters: The file states one metre to either side.
# Do: Correct `limit` in the file.
# Example: a linear axis without `travel_mm`
convert-travel-unknown = the travel of { $joints } is not stated: the URDF has 1 m to either side
    .hint = correct `limit` in the file, or state `travel_mm` in robot.toml

# Means: The converted description, read again, moves the flange differently from the robot.
# Matters: A robot that is described by it reaches other poses. Nothing is printed.
# Do: Check the lengths of the robot file: they may be so large that digits are lost.
# Example: axes 100 km from the base
convert-not-reproduced = the converted description does not reproduce the robot: the flange is off by up to { FIXED($off_mm, 6) } mm and { FIXED($off_deg, 6) } deg
    .hint = check the lengths of the robot file: very large ones lose digits

# Means: A smallest enclosing element is asked for together with setting points aside.
# Matters: An enclosing element is held by its extreme points, which a robust fit would exclude.
# Do: Fit a circle or sphere by least squares with `--robust`.
# Example: `etalon fit enclosing-circle points.txt --robust`
enclosing-robust = the extreme points define `{ $element }`: a robust fit would remove them
    .hint = fit circle2d or sphere with --robust

# Means: A robust fit is asked for the features of a QIF file.
# Matters: A feature of the file is compared with the fit of all its points.
# Do: Leave `--robust` out, or fit the points from a table.
# Example: `etalon fit results.qif --robust`
qif-robust = features of a QIF file are fitted to all their points
    .hint = leave --robust out, or fit the points from a table
axis-without-errors = the axis has no errors of its own in this model
lead-not-measured-there = the lead was not measured at this position
table-without-row = the table has no row for this position

# Means: A point of the planned test is out of reach of the robot.
# Matters: The test cannot be run with this point.
# Do: Move or shrink the workspace, or state another orientation.
# Example: a workspace that extends beyond the arm
test-point-unreached = point { $point } of the list `{ $list }` is not reached: { $reason }
    .hint = move or shrink the workspace (--workspace-mm), or state another orientation (--orientation-deg)

# Means: Every draw of a generated candidate violates a limit, the box or the line of sight.
# Matters: Nothing can be planned.
# Do: Widen the constraint that excludes most draws; check its unit (mm, deg), its frame (base of the robot) and its signs.
# Example: `--box z=0.2:0.5` in metres
no-candidate-generated = none of { $draws } draws is a candidate: { $counts }
    .hint = widen what excludes most: limits and `--range` (deg, mm), `--box` (mm, base of the robot), `--reflector`, `--instrument`, `--obstacle` and `--link`

# Means: Hardly any draw obeys limits, box and line of sight: the search ended before the number of candidates was reached.
# Matters: The plan chooses among fewer candidates.
# Do: Widen the constraint that excludes most draws, or accept fewer candidates.
# Example: a box at the edge of the reach
few-candidates-generated = { $found } of { $wanted } candidates found in { $draws } draws: { $counts }
    .hint = widen what excludes most: limits and `--range` (deg, mm), `--box` (mm, base of the robot), `--reflector` and `--instrument`

draws-beyond-limits = { $count } beyond the limits of joints or links, or without a pose

draws-outside-box = { $count } with a target outside the box (within the limits, targets are in x { FIXED($x0, 0) } to { FIXED($x1, 0) }, y { FIXED($y0, 0) } to { FIXED($y1, 0) }, z { FIXED($z0, 0) } to { FIXED($z1, 0) } mm)

draws-facing-away = { $count } with a reflector that faces away from the instrument ({ $reversed } of them would face it with opposite axes)

# Means: Candidates are drawn within the range of each joint, and this joint has none: neither the robot file nor an option states it.
# Matters: A range is never guessed: poses beyond it would stop the program of measurement.
# Do: State the limits in the robot file or as `--range`.
# Example: an arm without `limits_deg`
joint-range-missing = joint { $joint } has no limits
    .hint = state them in the robot file, or as `--range { $column }=FROM:TO`

# Means: The column of `--range` does not name a joint of the robot.
# Matters: The range would be ignored.
# Do: Use the name of a joint with its unit.
# Example: `--range q7_deg=-90:90` for six joints
range-joint-unknown = `--range { $column }`: the robot has no such joint

# Means: The stated ranges of a joint and its limits have no value in common.
# Matters: No candidate is possible.
# Do: Check the unit and the sign of the range.
# Example: `--range q2_rad=-60:-45` for limits of -110 to 110 deg
range-outside-limits = the ranges of joint { $joint } and its limits ({ FIXED($from, 3) } to { FIXED($to, 3) } { $unit }) have no value in common
    .hint = check unit and sign of `--range`

# Means: An arm, delta or hexapod carries its reflectors at places that its model does not know.
# Matters: Poses cannot be compared without a measured point.
# Do: State each reflector with its position in the flange.
# Example: `--reflector A=30,0,50`
reflector-missing = generated candidates need at least one reflector on the flange
    .hint = state it: `--reflector A=X,Y,Z` (mm in the flange)

# Means: Two options state the same reflector.
# Matters: Its position is ambiguous.
# Do: Give each reflector its own name.
# Example: `--reflector A=0,0,50 --reflector A=30,0,50`
reflector-twice = reflector { $name } is stated twice
    .hint = give each reflector its own name

# Means: The targets of this model are parameters of the robot file, and its moving part has no orientation in space.
# Matters: Stated reflectors, and their line of sight to an instrument, would be ignored.
# Do: Omit `--reflector` and `--instrument`.
# Example: `--reflector A=0,0,50` for a five-bar
reflector-of-own-targets = `{ $model }` has targets of its own: reflectors and an instrument cannot be stated
    .hint = omit `--reflector` and `--instrument`

# Means: Only an instrument, or only reflectors with an axis are stated.
# Matters: The line of sight needs both.
# Do: State `--instrument`, and at least one reflector with its axis and acceptance angle.
# Example: `--reflector A=0,0,50 --instrument 2000,0,500`
sight-incomplete = { $missing ->
        [axis] the instrument has no reflector with an axis to face it
       *[other] reflectors with an axis have no instrument to face
    }
    .hint = { $missing ->
        [axis] state the axis in the flange and the acceptance half-angle: `--reflector A=X,Y,Z,I,J,K,ANGLE`
       *[other] state its position in the base: `--instrument X,Y,Z`
    }

# Means: Two options state the same obstacle.
# Matters: Hidden candidates could not be attributed to one of them.
# Do: Give each obstacle its own name.
# Example: two options `--obstacle column=...`
obstacle-twice = obstacle { $name } is stated twice
    .hint = give each obstacle its own name

# Means: The instrument is inside a body that blocks its view.
# Matters: No reflector could be seen.
# Do: Check position and size of the body, and the position of the instrument (mm, base of the robot).
# Example: `--instrument 500,0,0 --obstacle table=box:1000,1000,800,500,0,0`
instrument-inside-obstacle = the instrument is inside obstacle { $name }
    .hint = check both (mm, base of the robot)

# Means: A reflector is inside the capsule of the link that carries it.
# Matters: The link would hide it at every pose.
# Do: State a smaller radius, or the ends of the link, or check the position of the reflector.
# Example: `--link q6=60 --reflector A=0,0,10`
reflector-inside-link = reflector { $reflector } is inside the link of joint { $joint }, which carries it
    .hint = state a smaller radius or the ends of the link: `--link { $joint }=RADIUS,X,Y,Z,X,Y,Z`

# Means: A link is stated by a joint that the robot does not have.
# Matters: The link would block no view.
# Do: Name the joint that moves the link.
# Example: `--link elbow=60`
link-joint-unknown = the robot has no joint { $joint }

# Means: Links are stated for a robot whose joints do not form a single chain.
# Matters: The links would block no view.
# Do: Omit `--link`; state bodies that do not move as `--obstacle`.
# Example: `--link q1=60` for a delta
links-unsuited = a robot of model `{ $model }` is not a single chain of joints: links cannot be stated
    .hint = omit `--link`; state bodies that do not move as `--obstacle`

draws-hidden = { $count } with a reflector hidden by { $obstacle }

# Means: `--box` names an axis that the positions of the robot lack.
# Matters: The box would be ignored.
# Do: Use x and y, and z for robots in space.
# Example: `--box z=0:100` for a planar table
box-axis-unknown = `--box`: targets of this robot have no axis `{ $name }`
    .expected = { $dimension ->
        [2] x or y
       *[other] x, y or z
    }

# Means: Candidates of a robot with working modes are positions, which are drawn within x and y of a box.
# Matters: The positions are drawn within the box: x and y must be bounded.
# Do: State x and y.
# Example: a five-bar with `--generate 500` alone
box-missing = candidates of `{ $model }` are drawn by position: x and y of `--box` are missing
    .hint = state the region in the base of the robot: `--box x=FROM:TO,y=FROM:TO` (mm)

check-source = { $rows ->
        [one] { $file }: 1 row, { $refused } refused ({ $dialect })
       *[other] { $file }: { $rows } rows, { $refused } refused ({ $dialect })
    }
check-verdict = { $warnings ->
        [0] { $file }: nothing is wrong
        [one] { $file }: no errors, 1 warning
       *[other] { $file }: no errors, { $warnings } warnings
    }
study-head = Error: { $error }.
    Mean of { $runs } calibrations, { $draws } draws: median [95 % of the draws].
study-set = set
study-noise = noise µm
study-error = error
study-rms-before = before RMS
study-rms = RMS
study-largest = max
study-parameter = parameter
study-actual = actual
study-mean = mean
study-spread = 3 s
targets-compensated = { $count ->
        [one] 1 target compensated
       *[other] { $count } targets compensated
    }; { $left ->
        [one] 1 target by joint values left as it is
       *[other] { $left } targets by joint values left as they are
    }
batch-counts = { $done } done, { $not_met } with limits not met, { $failed } failed, { $skipped } skipped
run-skipped = skipped: { $campaign } needs data below ${ $name }, which is not set
no-controller-files = no controller file is written: the result is implausible
next-recommend = { $command } shows what each parameter contributes; controller files are in the output folder
unmodelled-said = simulated errors that no parameter describes: { $error }
unmodelled-backlash = backlash { $joints }
unmodelled-interpolation = encoder interpolation { $joints }
unmodelled-every = { $joint } { $amplitude } every { $period }
unmodelled-homing = homing (standard deviation) { $joints }
unmodelled-growth = thermal growth { $growth } µm for each metre and hour
unmodelled-bending = bending { $bending } µm one metre from the base
axis-table-largest = { $count ->
        [one] 1 position, largest deviation { FIXED($largest, 6) } { $unit }
       *[other] { $count } positions, largest deviation { FIXED($largest, 6) } { $unit }
    }
iso230-accuracy = accuracy A
iso230-systematic = systematic positioning error E
iso230-repeatability = repeatability R
iso230-mean-systematic = mean systematic error M
iso230-reversal = reversal error B
iso230-mean-reversal = mean reversal error
iso230-both = bidirectional
iso230-positive = positive
iso230-negative = negative
fit-seen-none = none of any kind
fit-any-element = any element
zone-by-least-squares = leave --minimum-zone out: the fit is by least squares then
fit-head = { $element }: { $count ->
        [one] 1 point
       *[other] { $count } points
    }
fit-center = center
fit-point = point
fit-normal = normal
fit-axis = axis
fit-radius = radius
fit-minor-radius = minor radius
fit-apex-angle = apex angle
fit-residuals = residuals
fit-flatness = flatness
fit-held-by = held by
fit-proof = proof
fit-probe = probe
fit-probe-center = probe center
fit-its-radius = its radius
fit-stated-point = stated point
fit-stated-direction = {"  "}direction
fit-stated-radius = {"  "}radius
fit-stated-minor-radius = {"  "}minor radius
fit-stated-apex-angle = {"  "}apex angle
fit-held-points = points { $upper } and { $lower }
fit-proof-global = no other zone is narrower
fit-proof-local = no neighbouring zone is narrower
fit-proof-none = none
fit-spread = rms { $rms }, max { $max }, form { $form }
fit-off = { $value } { $unit }, fitted { $off } { $unit }
fit-apart = { $value }, fitted { $apart } { $unit } apart
axes-head = { $joint } { $kind ->
        [slides] slides
       *[turns] turns
    }: { $count ->
        [one] 1 reading
       *[other] { $count } readings
    }{ $aside ->
        [0] {""}
       *[other] , { $aside } excluded
    }
axes-direction = {"  "}direction    { $direction }  (u = { $u } deg)
axes-point = {"  "}point        { $point }  (u = { $u } mm)
axes-circle = {"  "}`{ $target }`  radius { $radius } mm (u = { $u } mm), arc { $arc } deg
axes-line = {"  "}`{ $target }`  length { $length } mm
axes-error-motions = {"    "}radial error motion { $radial } µm (noise alone { $radial_noise } µm), face error motion { $face } µm (noise alone { $face_noise } µm)
axes-straightness = {"    "}straightness { $radial } µm (noise alone { $radial_noise } µm) and { $face } µm (noise alone { $face_noise } µm)
axes-axial-and-tilt = {"  "}axial error motion { $axial } µm (noise alone { $axial_noise } µm), tilt error motion { $tilt } deg (noise alone { $tilt_noise } deg)
axes-motion = {"  "}motion       { $ratio } × joint value (u = { $u }), difference { $rms } { $unit } (rms)
axes-base = base ({ $rule })
axes-origin = {"  "}origin       { $point }
axes-target = target `{ $target }` on the flange
axes-check-pose = check pose, line { $line }: { $distance } mm from the robot  (u = { $u } mm a component)
next-paste = paste these lines into campaign.toml; `etalon check FOLDER` tries them
next-paste-refused = { $next }; they would be refused: { $reasons }
next-simulate = { $command } writes the exports and the log
next-copy = copy the exports and the log into { $folder }; `etalon formats FILE` proposes how to read each; { $command }
next-check-asks = { $command } asks for { $keys }
next-check-refused = { $next }; the proposal would then be refused: { $reasons }
next-command = { $command }
units-of-joints = the units of joints
axis-steps-not-whole = from { $from } to { $to } are not whole steps of { $step }
assignment-without-number = `{ $name }` has no number
newer-than-unreadable = the file of `--newer-than` cannot be read: { $reason }
pose-argument-expected = expected x,y,z in mm, or these and a unit quaternion qw,qx,qy,qz
axis-name-expected = an axis is named by letters and digits
stdout-not-written = stdout cannot be written
plan-side = side { $side } mm, test plane { $plane }
converted-by = converted by etalon robot convert
convert-base-of-table = base of the table in the base of the robot: xyz { $xyz_mm } mm, rpy { $rpy_deg } deg
convert-flange-of-table = flange of the robot in the flange of the table: xyz { $xyz_mm } mm, rpy { $rpy_deg } deg
from-other-joints = the file has { $columns } columns of joints, and the robot { $joints } joints: leave out those that it does not have
from-joints-in-order = the joints are those of robot.toml in the order of the file
from-unit-of-joints = for UNIT write deg, rad, mm, m or um: the file does not state it

cell-frame = { $name ->
        [tool] tool
        [target] target
        [sensor] sensor
        [base] base
        [world] measuring system
        [object] object
       *[axis] axis
    } { $reference ->
        [flange] in flange
        [base] in base
        [world] in the measuring system
       *[points] in points
    }
cell-point = { $name ->
        [tool] tool point
       *[fixed] fixed point
    } { $reference ->
        [flange] in flange
        [base] in base
        [world] in the measuring system
       *[points] in points
    }
cell-position = {"  "}position     { $position } mm{ $known ->
        [no] {""}
       *[yes] {"  "}(u = { $u } mm)
    }
cell-quaternion = {"  "}quaternion   { $quaternion }{ $known ->
        [no] {""}
       *[yes] {"  "}(u = { $u } deg about x y z)
    }
cell-axis = { $kind ->
        [linear] linear axis
       *[rotary] rotary axis
    }
cell-direction = {"  "}direction    { $direction }
cell-axis-scale = {"  "}scale        { $scale } × axis value{ $known ->
        [no] {""}
       *[yes] {"  "}(u = { $u })
    }
cell-residuals = { $measure ->
        [position] position
       *[orientation] orientation
    } residuals: standard deviation { $deviation } { $measure ->
        [position] mm
       *[orientation] deg
    }, redundancy { $redundancy }; uncertainties from { $source ->
        [stated] stated values
       *[residuals] residuals
    }
cell-largest-residual = { $measure ->
        [position] largest position residual:
       *[orientation] largest orientation residual:
    } { $length } { $measure ->
        [position] mm
       *[orientation] deg
    }, line { $line }

# Means: Joint values of some targets are beyond the range in which the residual field was measured.
# Matters: There the field fades out, and the command compensates the parameters alone.
# Do: Accept the larger error there, or measure these regions in the calibration.
# Example: a target with a joint 40 degrees beyond all calibration poses
targets-beyond-field = { $count ->
        [one] target { $targets } is
       *[other] targets { $targets } are
    } beyond the residual field, where it fades out
    .hint = measure calibration poses in this region
# Means: The last day on which the laboratory states the parameters as valid has passed.
# Matters: The robot may have changed since: joint offsets by a collision or a new motor, geometry
# by wear.
# Do: Measure a few poses and use `etalon verify`, or calibrate again.
# Example: `etalon export parameters.json` in 2027 with `valid_until = "2026-03-02"`
parameters-expired = the parameters are valid until { $last }; today is { $today }
    .hint = measure a few poses and use `etalon verify`, or calibrate again

# Means: The axis has backlash, and the table holds one value for both directions of motion.
# Matters: The table corrects the middle of the backlash; half of it remains in each direction.
# Do: State the value as the backlash of the axis in the control, or use a format with both directions (linuxcnc, beckhoff).
# Example: `etalon axis-table out/parameters.json --robot robot.toml --axis q1_mm=0:500:50 --to sinumerik`
backlash-not-in-table = the table has one value for both directions; the backlash of `{ $axis }`, up to { FIXED($backlash, 5) } { $unit }, is not in it
    .hint = state it as the backlash of the axis in the control

# Means: Two options `--column` name different headings for one column, and a table has both.
# Matters: Only one of them can be the column.
# Do: State the heading that is meant, or give the tables in files with different headings.
# Example: `--column x_mm=X1 --column x_mm=X2` for a table with X1 and X2
option-column-ambiguous = --column states both `{ $first }` and `{ $second }` for `{ $column }`, and `{ $file }` has both
    .hint = state one of them

# Means: Measured rows have no prediction of their pose and target.
# Matters: A program is compared on all test rows; a missing row could be the worst one.
# Do: Predict every row of the table of joint values.
# Example: a row of the predictions is deleted
predictions-missing = { $count ->
        [one] a measured row has no prediction: pose { $pose }, target `{ $target }`
       *[other] { $count } measured rows have no prediction, first pose { $pose }, target `{ $target }`
    }
    .hint = predict every row of the table of joint values

# Means: Two rows predict the same target at the same pose.
# Matters: It is unknown which of the two is the answer.
# Do: State one row for each pose and target.
# Example: a row of the predictions is repeated
prediction-repeated = pose { $pose }, target `{ $target }` is predicted twice, first in line { $line }
    .hint = state one row for each pose and target

benchmark-counts = { $poses } poses
benchmark-position = position
benchmark-orientation = orientation
benchmark-mean = mean
benchmark-rms = RMS
benchmark-p95 = 95 %
benchmark-max = maximum
benchmark-coverage = coverage
benchmark-width = width
benchmark-score = score

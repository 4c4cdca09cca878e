### Messages of cli. Above each message: its explanation (see CONTRIBUTING.md, "A message").

batch-done = done
batch-failed = failed
batch-not-done = { $ended }: { $campaign }
batch-not-met = not met
batch-skipped = skipped
batch-unchanged = { $ended }, unchanged
# Means: No message of the catalogue has this id.
# Matters: Only ids of the catalogue have an explanation.
# Do: Copy the id from the brackets of the message. `etalon explain` alone lists all ids.
# Example: `etalon explain parameter-twise`
message-unknown = `{ $id }` is not the id of a message

# Means: An option that needs a positive number has zero, a negative number or NaN.
# Matters: No such quantity can be zero, negative or infinite.
# Do: Check the number and its unit.
# Example: `--near-mm inf`
option-not-positive = { $option } must be positive
    .hint = give a positive number

# Means: The value of an option cannot be read.
# Matters: The command never guesses a value.
# Do: Look up the option in `--help`, and use one of its values.
# Example: `--delimiter comma2`
option-refused = { $option }: { $reason }
    .hint = `etalon COMMAND --help` lists the values

# Means: The value of an option for columns has no `=`.
# Matters: The command needs two parts: the column, and its heading or value.
# Do: Write NAME=HEADING, NAME=VALUE or COLUMN=CELL.
# Example: `--column q1_deg`
column-option-malformed = --{ $option }: `{ $text }` has no `=`
    .expected = { $option ->
        [column] q1_deg=J1
        [constant] kind=distance
       *[other] deleted=1
    }

# Means: The columns are given both by their order (`--columns`) and by name (`--column`).
# Matters: The two may contradict each other.
# Do: Use `--columns` for files without a header, `--column` for files with one.
# Example: `--columns x,y,z --column x=X`
option-columns-twice = --columns and --column both give the columns
    .hint = omit one of the two options

# Means: Neither an option nor the file gives the unit of lengths.
# Matters: Most exports carry no unit; a wrong guess falsifies every result.
# Do: Look up the unit in the export settings of the measuring software, and give it with `--unit`.
# Example: `etalon fit plane points.txt`
option-unit-missing = the length unit of the files is not given
    .hint = add `--unit mm`, `m`, `um` or `inch`; the unit is never guessed

# Means: The command has a parameters.json, but not the robot to which the parameters belong.
# Matters: Deviations are computed with the robot model.
# Do: Give the robot.toml of the run that wrote parameters.json.
# Example: `etalon axis-table parameters.json --axis q1_mm=0:100:10`
robot-option-missing = parameters.json needs --robot FILE
    .hint = give the robot.toml: --robot FILE

# Means: The option contains an axis that the robot does not have.
# Matters: Its table cannot be computed.
# Do: Use the name of a joint of the robot, or x_mm, y_mm, z_mm.
# Example: `--axis q9_mm=0:100:10`
axis-unknown = the robot has no axis `{ $axis }`
    .hint = use a joint of the robot, or x_mm, y_mm, z_mm

# Means: A table has both Cartesian axes and joints.
# Matters: The positions of a table are either positions of the tool or joint values.
# Do: Make one table for the Cartesian axes and one for the joints.
# Example: `--axis x_mm=0:100:10 --axis q1_deg=0:90:10`
axes-mixed = the axes of a table are either Cartesian (x_mm, y_mm, z_mm) or joints
    .expected = joints { $joints }

# Means: A table of several joints contains a revolute joint.
# Matters: The correction of one joint by another is defined only for prismatic joints in series.
# Do: Use x_mm and y_mm instead: positions of the nominal robot.
# Example: `--axis q1_deg=0:90:10 --corrected q2_deg`
table-of-turning-joints = a table of several joints needs prismatic joints in series
    .hint = use x_mm and y_mm, positions of the nominal robot

# Means: geometric.json contains no lead of this axis.
# Matters: The deviations of the axis are unknown.
# Do: Measure the lead ([[geometric.lead]]), or give one of the measured axes.
# Example: `--axis rho3_mm=0:100:10` where leads 1 and 2 were measured
lead-not-measured = no lead of `{ $axis }` was measured
    .expected = { $measured }

# Means: A lead is used for more than one axis, or for the correction of another axis.
# Matters: A lead is the deviation of an actuator as a function of its own position.
# Do: Give a single `--axis`, and omit `--corrected`.
# Example: `--axis rho1_mm=0:100:10 --corrected rho2_mm`
lead-of-one-axis = a lead corrects a single axis by its own position
    .hint = give this axis alone

# Means: A cell of the table is empty or not a number.
# Matters: The row cannot be used, and omitting it without a message would change the result.
# Do: Complete the cell, or remove the row.
# Example: an empty cell in the column `x_mm`
table-value-missing = a value is missing or not a number
    .hint = complete the cell, or remove the row

# Means: The positions of the table do not form a grid.
# Matters: A plane is interpolated between nodes of a grid.
# Do: Add the missing rows: one row for each combination of the positions of the base axes.
# Example: a table without the row of one corner
not-a-grid = the positions do not form a grid
    .expected = one row for each position of each base axis

# Means: The positions of a base axis are not given.
# Matters: The table has no rows.
# Do: Add the first position, the last position and the step: `--axis q1_mm=0:500:50`.
# Example: `--axis q1_mm` for parameters.json
axis-without-positions = `{ $axis }` has no positions
    .expected = --axis { $axis }=FROM:TO:STEP

# Means: The compensated command needs another configuration of the robot than the target, or a long
# motion of a joint.
# Matters: There is a singularity between the original and the compensated target: the robot turns
# its joints on the way. No program and no list of targets is written.
# Do: Move the target away from the singularity, or correct the working mode, `confdata`, or Status
# and Turn of the target.
# Example: a target at a wrist singularity
configuration-changed = target { $target }: the compensated command needs another configuration
    .hint = move the target away from the singularity, or check its configuration data (working mode, confdata, Status and Turn)

# Means: The program computes poses while it runs.
# Matters: Computed poses are not compensated.
# Do: Check each of these poses. A pose that is computed from a compensated target has the
# compensation of that target, not its own.
# Example: `Offs(p1, 0, 0, 100)` in RAPID
poses-computed-by-program = poses computed by { $names } are not compensated
    .hint = check them: a pose computed from a compensated target has the compensation of that target, not its own

# Means: The program does not contain the working mode of the robot at its start.
# Matters: A five-bar robot reaches a point in several working modes.
# Do: Add the joint values at the start with `--start`.
# Example: a Mecaprol program without `--start`
working-mode-missing = the working mode at the start of the program is unknown
    .hint = give the joint values at the start: --start N,N,+1

# Means: The program uses a tool or a work object whose pose is not given.
# Matters: The targets are poses of this tool in this frame.
# Do: Give the pose of the tool or work object. If the program uses several, split it: one program
# for each tool and frame.
# Example: `MoveL p1, v10, fine, tGrip` without `--tool`
program-frames = the program uses { $names }

one-program-each = split the program: one program for each

state-pose-option = give its pose: --{ $option } x,y,z,qw,qx,qy,qz

# Means: The program sets its tool or base by numbers, and the option gives another pose.
# Matters: The targets were programmed with one of the two poses. If etalon uses the other pose, the
# compensation is wrong.
# Do: Give the pose that is written in the program. Omit the option if this pose is the flange or
# the base.
# Example: `$TOOL={X 0,Y 0,Z 150,A 0,B 0,C 0}` with `--tool 0,0,0`
program-frame-other = the program sets { $frame }, and --{ $option } gives another pose
    .hint = give the pose of the program: --{ $option } { $pose }

# Means: `--frame world` is given for a program.
# Matters: Targets of a program are in the frame of its work object.
# Do: Give the pose of the work object with `--object`.
# Example: `etalon compensate a.mod --frame world`
program-in-world = targets of a program cannot be in the world frame
    .hint = give the pose of the work object with --object

# Means: The encoder counts per mm or deg of the axes are missing.
# Matters: Positions of a Galil controller are encoder counts.
# Do: Look up the counts per mm or deg in the configuration of each axis.
# Example: `--format galil` without `--counts-per-unit`
counts-missing = `galil` needs the encoder counts per mm or deg of { $axes } axes
    .hint = add --counts-per-unit N,N

# Means: `--frame world` is given for targets by joint values.
# Matters: Joint values have no frame.
# Do: Omit `--frame`.
# Example: a table of joints and `--frame world`
joints-in-world = joint values have no frame
    .hint = omit --frame

# Means: The nominal robot has no pose at these joint values.
# Matters: The target has no nominal pose.
# Do: Check the joint values, their units, and the assembly mode.
# Example: joint values of another assembly mode
nominal-pose-unreachable = the nominal robot has no pose at these joint values
    .hint = check the joint values and the assembly mode

# Means: The pose is singular: some joints can move together without moving the tool, so there are
# infinitely many solutions.
# Matters: The answer contains one solution, the nearest to the start. Near this pose the joints
# move fast, and small errors of the pose cause large errors of the joints.
# Do: To get another solution, add its approximate joint values to the row; otherwise avoid the
# pose.
# Example: a pose with q5 = 0, where q4 and q6 turn about the same axis
pose-singular = pose { $pose } is singular: { $joints } can move together without moving the tool; the solution nearest to the start is given
    .hint = give joint values in the row to choose another solution, or avoid the pose

# Means: The robot model has no base in the world frame.
# Matters: The command cannot convert targets from the world frame to the base frame.
# Do: Omit `--frame world`, and give targets in the base frame.
# Example: `--frame world` for a model without base parameters
base-not-in-world = `{ $model }` has no base in the world frame
    .hint = omit --frame

# Means: Mecaprol is the language of five-bar robots.
# Matters: Mecaprol cannot command this robot.
# Do: Choose another `--format`; `--help` lists the formats.
# Example: `--format mecaprol` for a serial arm
mecaprol-other-robot = Mecaprol commands a five-bar robot, not `{ $model }`
    .hint = use another --format

# Means: The identified robot does not reach a target.
# Matters: The target cannot be compensated.
# Do: Move the target, or correct the joint limits in robot.toml.
# Example: a target beyond the travel of a joint
target-unreachable = target { $target }: { $reason }
    .hint = move the target, or check the limits in robot.toml

# Means: The robot does not reach a pose of the table.
# Matters: The answer contains no joint values for this pose.
# Do: Check the unit and the frame of the pose, and the limits in robot.toml.
# Example: a pose beyond the reach of an arm
pose-unreachable = pose { $pose }: { $reason }
    .hint = check the pose and the limits in robot.toml

# Means: `--controller-hash` is given without a format that contains the hash of a calibration.
# Matters: Files in other formats contain no hash of a controller.
# Do: Choose one of these formats with `--format`, or omit `--controller-hash`.
# Example: `--format csv --controller-hash calib_1`
hash-of-other-format = `--controller-hash` is for the formats that contain it: { $formats }
    .hint = choose one of them with --format, or omit the hash

# Means: A run wrote the output folder while files for a controller were made from it.
# Matters: The files may contain parameters of two runs.
# Do: Run the export again when the run has ended.
# Example: `etalon run` and `etalon export` at the same time
run-while-exporting = a run wrote `{ $folder }` while files for a controller were made
    .hint = repeat the command: the files may contain parameters of two runs

# Means: The command contains an element, but no file of points.
# Matters: There are no points to fit.
# Do: Add the file of points after the element.
# Example: `etalon fit plane`
fit-file-missing = no file of points is given for `{ $element }`
    .hint = add the file: etalon fit { $element } FILE

# Means: The command contains no element, and the file is not QIF.
# Matters: Only QIF files contain the elements of their features.
# Do: Add the element (plane, circle3d, sphere ...) before the file.
# Example: `etalon fit points.txt`
fit-element-missing = the element is not given, and the file is not QIF
    .hint = add it: etalon fit ELEMENT { $file }

# Means: Columns or a radius are given for a QIF file.
# Matters: A QIF file has no columns, and its features have different radii.
# Do: Omit `--columns`, `--delimiter` and `--radius-mm`.
# Example: `etalon fit b.qif --radius-mm 15`
qif-with-columns = a QIF file has neither columns nor one radius for all its features
    .hint = omit --columns, --delimiter and --radius-mm

# Means: The test contains a data set for an element that its test package does not define.
# Matters: etalon cannot answer this data set.
# Do: Look up the element in the manual of the test.
# Example: `TORUS` in a test of Gaussian elements
tracim-object-unknown = the element `{ $object }` of data set `{ $id }` is unknown in this test
    .expected = LINE_3D, PLANE, CIRCLE, CYLINDER, CONE or SPHERE (Gauss); LINE_2D, CIRCLE_2D, PLANE, SPHERE or CYLINDER (Chebyshev)

# Means: The answer does not contain the customer.
# Matters: The server rejects answers without a customer.
# Do: Add `--customer` with the name that you registered with TraCIM.
# Example: `etalon fit --tracim data.xml`
tracim-customer-missing = the customer of the answer is empty: the server rejects it
    .hint = add --customer NAME, as registered with TraCIM

# Means: The public documents of the test describe all elements of an answer except the form
# deviation.
# Matters: etalon calls this element `formDeviation`, in analogy to its maximum permissible error
# `mpe_formDeviation`. If the server uses another name, it rejects the answer.
# Do: Send the answer of the free sample test first, or compare it with the schema of the server.
# Example: `etalon fit --tracim chebyshev.xml --customer NAME`
tracim-form-name = the public documents of the Chebyshev test do not contain the name of the form deviation: `formDeviation` is an assumption
    .hint = try the answer with the free sample test of the server before an ordered one

# Means: No measured feature of the QIF file was fitted.
# Matters: The answer is empty.
# Do: Choose an element for which the file contains points.
# Example: `etalon fit plane b.qif` where the file has circles only
no-feature-fitted = no measured feature was fitted as { $kind }
    .expected = features with enough points for the fit
    .hint = features with points in the file: { $seen }

# Means: The side of the probe is neither inside, outside nor a direction.
# Matters: The command moves the element by the probe radius to an unknown side.
# Do: Use `inside` for a bore, `outside` for a shaft, or the direction from the surface to the
# probe.
# Example: `--probe-side left`
probe-side-unknown = --probe-side: `{ $text }` is not a side
    .expected = inside, outside, or three numbers x,y,z towards the probe
    .hint = inside for a bore, outside for a shaft, 0,0,1 for a probe above a plane

# Means: The radius of the probe is given without its side.
# Matters: It is unknown whether the probe radius is added or subtracted.
# Do: Add `--probe-side`.
# Example: `--probe-radius-mm 2.5` alone
probe-side-missing = the side of the probe is not given
    .expected = --probe-side inside, outside or x,y,z
    .hint = inside for a bore, outside for a shaft, the direction to the probe for a plane or line

# Means: The side of the probe is given without its radius.
# Matters: Without the radius nothing is compensated.
# Do: Add `--probe-radius-mm` with the qualified radius. If the points are contact points, omit both
# options.
# Example: `--probe-side inside` alone
probe-radius-missing = --probe-side is given without the probe radius
    .expected = --probe-radius-mm
    .hint = give the qualified radius of the probe, or omit both for contact points

# Means: A probe is given for an enclosing circle or sphere.
# Matters: An enclosing element of probe centres cannot be corrected by the probe radius.
# Do: Export contact points, or omit both options of the probe.
# Example: `etalon fit enclosing-sphere p.txt --probe-radius-mm 2.5 --probe-side inside`
enclosing-with-probe = { $element } is not compensated for a probe
    .hint = omit --probe-radius-mm and --probe-side

# Means: `--minimum-zone` is given for an enclosing circle or sphere.
# Matters: An enclosing element has no zone.
# Do: Omit `--minimum-zone`, or choose circle2d or sphere.
# Example: `etalon fit enclosing-circle p.txt --minimum-zone`
enclosing-minimum-zone = an { $element } has no minimum zone
    .hint = omit --minimum-zone, or fit a circle2d or sphere

# Means: The given uncertainty is too small or too large for a coordinate in micrometres.
# Matters: The uncertainties of all results depend on it.
# Do: Divide the expanded uncertainty by its coverage factor, and give the result in µm for one
# coordinate.
# Example: `--standard-uncertainty-um 0.0027` for 2.7 µm
uncertainty-implausible = { $option } cannot be the uncertainty of a coordinate in micrometres
    .hint = give the expanded uncertainty over the coverage factor, per coordinate: 0.0027 mm is 2.7 µm
state-expanded-um = give it in micrometres, per coordinate (k = 2): 0.0027 mm is 2.7 µm

# Means: `etalon init` does not know the geometry of this robot.
# Matters: The table contains only geometry from published sources.
# Do: Describe the robot in your own robot.toml, or use its URDF.
# Example: `etalon init arm --robot ur99`
robot-not-in-table = the geometry of `{ $name }` is not in the table of robots
    .expected = { $names }
    .hint = describe it by your own robot file, --robot robot.toml, or by its URDF, --urdf FILE

# Means: A row has no position, no measured value or no direction.
# Matters: Positioning is evaluated for each position and direction (ISO 230-2).
# Do: Complete the row: position, measured value, and +1 or -1 as direction.
# Example: a row with direction 0
iso230-row-incomplete = { $column ->
        [direction] `direction` is neither +1 nor -1
       *[other] `{ $column }` is missing or not finite
    }
    .expected = numbers, and +1 or -1 as `direction`

# Means: All values of `position_mm` differ, but the values of `measured_mm` repeat. An axis is driven
# to the same programmed position several times.
# Matters: Deviations are measured minus programmed positions: their sign and place would be wrong.
# Do: Swap the two columns.
# Example: programmed positions under the heading `measured_mm`
iso230-columns-exchanged = `position_mm` and `measured_mm` are swapped: the values of `measured_mm` repeat, and the values of `position_mm` do not
    .hint = swap the columns: `--column position_mm=measured_mm`, `--column measured_mm=position_mm`

# Means: A position has fewer than two runs in a direction.
# Matters: A standard deviation needs two values; ISO 230-2 requires five.
# Do: Measure at least five runs in each direction, as ISO 230-2 requires.
# Example: one run from the negative side
iso230-few-runs = position { $position } mm has fewer than two runs in direction { $direction }
    .expected = at least two runs in each direction, five to ISO 230-2

# Means: `--drift-set` is less than two cycles.
# Matters: The drift is the change between sets of cycles; a set needs at least two cycles.
# Do: Give a number of cycles from 2.
# Example: `--drift-set 1`
drift-set-too-small = { $option } must be at least 2
    .hint = give the number of cycles in a set

# Means: No commanded poses are given.
# Matters: AP, distances and drift are relative to commanded poses; RP needs none.
# Do: If you need AP, add the table of commanded poses with `--commanded`.
# Example: `etalon iso9283 --poses attained.csv`
commanded-missing = no commanded poses are given: AP is not evaluated (null); RP needs none
    .hint = add --commanded FILE for AP, distances and drift

# Means: The arm has more joints than a pose has degrees of freedom.
# Matters: It reaches a pose in infinitely many ways.
# Do: Add `--nearest` to get the solution nearest to the given joint values.
# Example: `etalon kinematics inverse` for a seven-axis arm
infinite-solutions = { $joints } joints reach a pose in infinitely many ways
    .hint = add --nearest to get one solution

# Means: The kinematics of this robot model do not include position and orientation.
# Matters: The command works on whole poses.
# Do: Use a robot model with full kinematics.
# Example: a program's own model without kinematics
no-whole-pose = the kinematics of `{ $model }` do not include position and orientation
    .hint = use another model

# Means: The command needs one chain of joints, from the base to one tool.
# Matters: A robot with several branches has one tool at the end of each branch.
# Do: Write the calibrated URDF with `etalon export --format urdf`. Then use it in a robot.toml with
# one `tool_link`.
# Example: `etalon kinematics` for a robot with [[branch]]
several-branches = a robot with several branches ({ $links }) has no single chain
    .hint = set one link as `tool_link` of a robot.toml whose URDF is the calibrated one: `etalon export --format urdf` writes the calibrated tree

# Means: A quaternion of the table does not have the length 1.
# Matters: Its components are probably in another order or mistyped.
# Do: Check the order of the columns: qw is the scalar part.
# Example: `qw,qx,qy,qz` = 0.7, 0, 0, 0.6
table-quaternion-length = the quaternion has the length { FIXED($length, 4) }
    .expected = 1: qw, qx, qy, qz of a rotation
    .hint = check the order of the columns (qw is the scalar part), and that they are not angles

# Means: The name of the file does not end like the name of a report.
# Matters: The ending determines the kind of report.
# Do: Use one of the expected endings.
# Example: `--report plan.docx`
not-a-report = the ending of `{ $file }` is not the ending of a report
    .expected = a name that ends in { $endings }

# Means: A run failed, and the output folder contains the results of an earlier run.
# Matters: The report and the controller files in the folder do not belong to the failed run.
# Do: Correct the error and run again. Do not load controller files from this folder before.
# Example: a run that stops at an error in campaign.toml
earlier-run-left = nothing is written: `{ $report }` and the other files of its folder are from an earlier run
    .hint = do not load controller files from this folder: they belong to the earlier run

# Means: Files of the campaign changed after its run. The certificate is written from the output
# folder of this run.
# Matters: The certificate would show the earlier statements and data. Its checksums would not
# belong to the present files.
# Do: Run the campaign again, then write the certificate.
# Example: `customer` added to [report] after the run
certificate-of-earlier-inputs = the run is older than the changes of { $files }: the certificate would show the earlier state
    .hint = run the campaign again, then write the certificate

# Means: Files of the campaign changed after its run. The report is written from the output folder of
# this run.
# Matters: The report shows the earlier statements and data.
# Do: Run the campaign again if the report shall show the changes.
# Example: a limit changed in campaign.toml after the run
report-of-earlier-inputs = the run is older than the changes of { $files }: the report shows the earlier state
    .hint = run the campaign again to include the changes

# Means: There is no schema of this name.
# Matters: Schemas exist for input files and JSON documents.
# Do: Choose one of the names in `etalon schema --help`.
# Example: `etalon schema parameter`
schema-unknown = unknown schema `{ $name }`

# Means: The observations contain a quantity that the calibration did not observe.
# Matters: The model error of this quantity is unknown, so its deviations cannot be judged.
# Do: Remove the rows of this quantity, or calibrate with observations of this quantity.
# Example: orientations, where only positions were calibrated
verify-quantity-without-residuals = the calibration has no residuals of the quantity "{ $quantity }": its model error is unknown
    .hint = remove these rows, or calibrate with observations of this quantity

# Means: No row of the table contains a measured value.
# Matters: Nothing can be compared with the parameters.
# Do: Measure again what the calibration measured: positions, distances, contacts.
# Example: a table of points without coordinates
verify-without-observations = no row of the table contains an observation
    .hint = measure again what the calibration measured: positions, distances, contacts

# Means: At least half of the rows have joint values and measured values of the calibration, equal to
# the last digit.
# Matters: A copy of the readings shows no change of the robot: the parameters were identified from
# them.
# Do: Replace exports and logs by the files of the new measurement.
# Example: an unchanged copy of the campaign
readings-of-calibration = { $count } of { $rows } rows are equal to readings of the calibration: they verify nothing
    .hint = replace exports and logs by the files of the new measurement

# Means: `etalon verify` has a campaign as its observations, together with options for reading a
# table.
# Matters: The campaign itself describes how its files are read; the options would be ignored.
# Do: Remove the options, or give a table instead of the campaign.
# Example: `etalon verify today --target SMR_1`
options-of-table-for-campaign = options of tables have no effect on the campaign `{ $campaign }`
    .hint = state in its campaign.toml how its files are read

# Means: The campaign of `--like` has no section `[observations]`.
# Matters: This section describes how the table is read.
# Do: Use a campaign with this section, or describe the table with `--column` and the other options
# of tables.
# Example: a campaign with exports and a log
campaign-without-observations = the campaign `{ $campaign }` has no section `[observations]`
    .hint = use a campaign with this section, or the options of tables (`--column` ...)

# Means: The campaign of `--like` has several sections `[[observations]]`, which may describe different tables.
# Matters: The columns of the wrong section give the columns another meaning.
# Do: Omit `--like`, and describe the table with the options of tables.
# Example: a campaign with a table of positions and one of distances
campaign-with-several-observations = the campaign `{ $campaign }` has { $count } sections `[[observations]]`; it is unknown which one describes the table
    .hint = describe the table with the options of tables (`--column` ...) instead of `--like`

# Means: The workspace has neither six nor four numbers.
# Matters: A box needs six coordinates, a rectangle four.
# Do: Give the smallest coordinates first, then the largest: `x,y,z,x,y,z`.
# Example: `--workspace-mm 1,2,3`
workspace-numbers = --workspace-mm has { $count } numbers
    .expected = six, or four for planar robots

# Means: A reorientation is given without an initial orientation.
# Matters: The test starts at this orientation.
# Do: Add the orientation at the start with `--orientation-deg`.
# Example: `--reorientation-deg 0,0,30` alone
reorientation-alone = a reorientation is given without an initial orientation
    .hint = add --orientation-deg

# Means: The robot file does not give the reach of the robot.
# Matters: The plan cannot be checked against the limits of the robot.
# Do: Omit `--robot`. Then move to the positions at low speed before the test.
# Example: a URDF model without limits
reach-unknown = the robot file of model `{ $model }` does not contain the reach of the robot
    .hint = omit --robot, and move to the positions at low speed before the test

# Means: Rows were excluded because `exclude` contains them.
# Matters: Excluded rows have no influence on the result; the report lists them with the reason.
# Do: Check that the reason justifies the exclusion.
# Example: `--exclude 4-6:reflector loose`
excluded-rows = excluded: { $count ->
        [one] 1 row
       *[other] { $count } rows
    }, rows { $rows }: { $reason }

# Means: The format cannot hold some of the identified parameters, and the run did not identify the
# others without them.
# Matters: The values in the file are computed from the covariance, with these parameters at
# nominal. The accuracy of the robot with this file is unknown.
# Do: Add the format to `controllers` of the campaign, run it again, and load the file from its
# output folder.
# Example: `etalon export --format linuxcnc parameters.json` for an arm with bending
controller-error-not-measured = format `{ $format }` cannot hold { $parameters }: the other values are computed with nominal values of these, and the error of the file was not measured
    .hint = run the campaign with "{ $format }" among its `controllers`, and export from its output folder; recommended parameters: `etalon export CAMPAIGN --parameters recommended`

# Means: The run of these parameters answered that a controller should load nothing. The files are
# written, and their headers say so.
# Matters: The robot may become less accurate with the files, or the errors with them are unknown.
# Do: Follow the next steps of the report, run the campaign again, and export then.
# Example: `etalon export samples/field-arm/out/parameters.json`
nothing-to-load-by-run = not to be loaded, by the answer of the run: { $reason }
    .hint = follow the next steps of the report and run the campaign again; `etalon recommend` explains the answer

# Means: `--from` is given without a robot.
# Matters: The joints and targets of the files belong to a robot.
# Do: Add `--robot` or `--urdf`.
# Example: `etalon init cell --from points.csv`
from-needs-robot = --from needs the robot
    .hint = add --robot ur5e, --robot robot.toml for your own robot file, or --urdf FILE

# Means: Two files of `--from` have the same name in different folders.
# Matters: The command copies all files into one folder.
# Do: Rename one of the files.
# Example: `--from a/points.csv b/points.csv`
two-files-of-one-name = two files are called `{ $name }`
    .hint = rename one of them

# Means: The lines that `etalon formats` proposes for a file are not TOML.
# Matters: A campaign cannot be written from them.
# Do: Report the file as a defect of etalon. Write the format in campaign.toml yourself.
# Example: two tables of attained poses and one of commanded poses
proposal-not-toml = the proposal for `{ $name }` cannot be read: { $error }

# Means: A URDF contains several chains of joints, for example to fingers or to other arms. The
# longest chain was chosen.
# Matters: The robot has the joints of this chain, and the last link carries the targets.
# Do: If another link carries the targets, set `tool_link` in robot.toml.
# Example: `etalon init arm --urdf FILE` with the URDF of an arm with a gripper
urdf-chain-chosen = the chain from `{ $base }` to `{ $tool }` with { $count ->
        [one] one joint
       *[other] { $count } joints
    } was chosen; other chains end at { $others }
    .hint = if another link carries the targets, set `tool_link` in robot.toml; in Python `Robot.from_urdf(path, tool_link="{ $other }")`

tool-link-longest = the chain with the most moving joints: the files have no joints
tool-link-by-names = the names of joints in the files are the joints of this chain
tool-link-by-count = the files have { $count } columns of joints, as many as this chain alone has joints
tool-link-by-residual = with this chain the nominal robot reproduces the points with a residual of { FIXED($rms_mm, 2) } mm, with every other chain at least three times as much
tool-link-shortest = with this chain the nominal robot reproduces the points with a residual of { FIXED($rms_mm, 2) } mm; further joints do not reduce it
tool-link-moves = the names of joints in the files are the joints of this chain; further joints of the files do not move
tool-link-fits = `{ $link }` fits the files: its joints are { $joints }

# Means: No column of a file is recognised as coordinates or joints.
# Matters: The campaign does not read the file.
# Do: Look at the columns with `etalon formats`, and give the format in campaign.toml.
# Example: `etalon init NEW --from README.md`
nothing-recognised = no column of `{ $name }` is recognised
    .hint = `etalon formats { $path }` lists what its columns could be

# Means: An option of a Python call is unknown, has a wrong value, or needs another option.
# Matters: The call checks its options like the command line.
# Do: Correct the option; `etalon COMMAND --help` lists all options.
# Example: `etalon.plan(robot, table, positions="many")` in Python
option-of-call-refused = { $reason }

# Means: Options of `etalon axis-table` contradict each other or the format.
# Matters: The table is wrong, or the format cannot represent it.
# Do: Correct the option in the message; `etalon axis-table --help` describes all options.
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
       *[own-axis] this table has one base axis, and corrects this axis itself
    }
    .hint = { $fault ->
        [sign-missing] try one position on the machine, then add --sign add or --sign subtract
       *[other] correct the option; `etalon axis-table --help` describes all options
    }

# Means: The deviation of an axis cannot be computed at a position of the table.
# Matters: A table of corrections needs a value at each position.
# Do: Choose positions that the robot reaches, or positions within the measured range.
# Example: `--axis rho1_mm=0:500:10` where the lead was measured to 400 mm
deviation-unknown = no deviation at { $position }: { $reason }
    .hint = choose positions that the robot reaches, or that were measured

robot-file-of-run = run the campaign again, or name the robot.toml of that run
# Means: The robot model has no chain of joints.
# Matters: Only chains have screw axes, Denavit-Hartenberg parameters or a URDF.
# Do: Convert only serial arms and URDFs.
# Example: `etalon robot convert` for a five-bar
convert-no-chain = `{ $model }` has no chain of joints; other conventions cannot describe it

# Means: One joint value moves several axes of the chain.
# Matters: robot.toml of a serial arm contains one joint value for each axis.
# Do: Keep the URDF: its `mimic` describes the shared motion.
# Example: a gripper or a parallelogram with `mimic`
convert-shared-joints = { $axes } axes share { $joints } joint values
    .hint = keep the URDF: its `mimic` describes the shared motion

# Means: The robot has bending, harmonics, backlash or coupling.
# Matters: A description of the axes alone cannot contain these effects; the converted robot does
# not have them.
# Do: Add the effects to the new robot.toml, and identify them again.
# Example: an arm with `bending = [2, 3]`
convert-left-out = { $count ->
        [one] 1 parameter is not geometry and is not converted
       *[other] { $count } parameters are not geometry and are not converted
    }: { $names }
    .hint = set `bending`, `harmonics`, `backlash` and `coupling` in the new file, and identify them again

# Means: Joint values are multiplied by a gain.
# Matters: A URDF has no gains: its joint values are the angles or positions of the axes.
# Do: Multiply the logged joint values by the gain, or convert to `poe`.
# Example: a joint logged in motor angles
convert-gains-not-held = a URDF cannot contain the gain of { $joints }: its joint values are the values of the axes
    .hint = multiply the joint values, or convert to `poe`

# Means: The travel of a prismatic joint is unknown, but a URDF requires it.
# Matters: The URDF allows one metre in both directions.
# Do: Set `travel_mm` in robot.toml and convert again, or correct `limit` in the URDF.
# Example: a linear axis without `travel_mm`
convert-travel-unknown = the travel of { $joints } is not given: the URDF allows 1 m in both directions
    .hint = set `travel_mm` in robot.toml, or correct `limit` in the file

# Means: The converted description, read again, moves the flange differently from the robot.
# Matters: A robot with this description would reach other poses. Nothing is printed.
# Do: Check the lengths in the robot file: digits are lost if they are very large.
# Example: axes 100 km from the base
convert-not-reproduced = the converted description does not reproduce the robot: the flange is off by up to { FIXED($off_mm, 6) } mm and { FIXED($off_deg, 6) } deg
    .hint = check the lengths of the robot file: very large ones lose digits

# Means: A robust fit is requested for a smallest enclosing element.
# Matters: The extreme points define an enclosing element; a robust fit could exclude them.
# Do: Fit a circle or sphere by least squares with `--robust`.
# Example: `etalon fit enclosing-circle points.txt --robust`
enclosing-robust = the extreme points define `{ $element }`: a robust fit would remove them
    .hint = fit circle2d or sphere with --robust

# Means: A robust fit is requested for the features of a QIF file.
# Matters: The command compares each feature of the file with a fit to all its points.
# Do: Omit `--robust`, or fit the points from a table.
# Example: `etalon fit results.qif --robust`
qif-robust = features of a QIF file are fitted to all their points
    .hint = omit --robust, or fit the points from a table
axis-without-errors = the model contains no errors of this axis
lead-not-measured-there = the lead was not measured at this position
table-without-row = the table has no row for this position

# Means: A point of the planned test is out of reach of the robot.
# Matters: The test cannot be run with this point.
# Do: Move or shrink the workspace, or change the orientation.
# Example: a workspace that extends beyond the arm
test-point-unreached = the robot does not reach point { $point } of the list `{ $list }`: { $reason }
    .hint = move or shrink the workspace (--workspace-mm), or change the orientation (--orientation-deg)

# Means: Each random pose violates a limit, the box or the line of sight.
# Matters: Nothing can be planned.
# Do: Relax the condition that excludes most poses. Check its unit (mm, deg), its frame (base of the
# robot) and its signs.
# Example: `--box z=0.2:0.5` in metres
no-candidate-generated = none of { $draws } random poses is a candidate: { $counts }
    .hint = relax the condition that excludes most poses: limits and `--range` (deg, mm), `--box` (mm, base of the robot), `--reflector`, `--instrument`, `--obstacle` and `--link`

# Means: Very few random poses satisfy limits, box and line of sight. The search ended before it
# found enough candidates.
# Matters: The plan can choose only from these candidates.
# Do: Relax the condition that excludes most poses, or accept fewer candidates.
# Example: a box at the edge of the reach
few-candidates-generated = { $found } of { $wanted } candidates found in { $draws } random poses: { $counts }
    .hint = relax the condition that excludes most poses: limits and `--range` (deg, mm), `--box` (mm, base of the robot), `--reflector` and `--instrument`

draws-beyond-limits = { $count } beyond the limits of joints or links, or without a solution

draws-outside-box = { $count } with a target outside the box (within the limits, targets are in x { FIXED($x0, 0) } to { FIXED($x1, 0) }, y { FIXED($y0, 0) } to { FIXED($y1, 0) }, z { FIXED($z0, 0) } to { FIXED($z1, 0) } mm)

draws-facing-away = { $count } with a reflector that faces away from the instrument ({ $reversed } of them would face it if its axis were reversed)

# Means: Candidates are random poses within the range of each joint, but the range of this joint is
# unknown.
# Matters: A range is never guessed: the measuring program stops at a pose outside the real range.
# Do: Add the limits to the robot file, or give them with `--range`.
# Example: an arm without `limits_deg`
joint-range-missing = joint { $joint } has no limits
    .hint = add them to the robot file, or give them with `--range { $column }=FROM:TO`

# Means: The robot has no joint with the name in `--range`.
# Matters: The range has no effect.
# Do: Use the name of a joint with its unit.
# Example: `--range q7_deg=-90:90` for six joints
range-joint-unknown = `--range { $column }`: the robot has no such joint

# Means: The given range of a joint and the limits of the joint do not overlap.
# Matters: No candidate is possible.
# Do: Check the unit and the sign of the range; `robot.toml` contains the limits.
# Example: `--range q2_rad=-60:-45` for limits of -110 to 110 deg
range-outside-limits = the range of joint { $joint } and its limits ({ FIXED($from, 3) } to { FIXED($to, 3) } { $unit }) do not overlap
    .hint = check the unit and the sign of `--range`

# Means: The model of an arm, delta or hexapod does not know where its reflectors are.
# Matters: Poses cannot be compared without a measured point.
# Do: Give each reflector with its position in the flange frame, in mm.
# Example: `--reflector A=30,0,50`
reflector-missing = generated candidates need at least one reflector on the flange
    .hint = add `--reflector A=X,Y,Z` (mm, flange frame)

# Means: Two options give the same reflector.
# Matters: It is unknown which of the two positions is right.
# Do: Use a different name for each reflector.
# Example: `--reflector A=0,0,50 --reflector A=30,0,50`
reflector-twice = reflector { $name } is given twice
    .hint = use a different name for each reflector

# Means: The targets of this model are parameters in the robot file. Its moving part has no
# orientation in space.
# Matters: Reflectors and a line of sight to an instrument have no effect.
# Do: Omit `--reflector` and `--instrument`.
# Example: `--reflector A=0,0,50` for a five-bar
reflector-of-own-targets = `{ $model }` has its own targets: reflectors and an instrument cannot be given
    .hint = omit `--reflector` and `--instrument`

# Means: The options give an instrument without reflector axes, or reflector axes without an
# instrument.
# Matters: The line of sight depends on both.
# Do: Give `--instrument`, and at least one reflector with its axis and acceptance angle.
# Example: `--reflector A=0,0,50 --instrument 2000,0,500`
sight-incomplete = { $missing ->
        [axis] an instrument is given, but no reflector with an axis
       *[other] reflectors with an axis are given, but no instrument
    }
    .hint = { $missing ->
        [axis] add the axis in the flange frame and the acceptance half-angle: `--reflector A=X,Y,Z,I,J,K,ANGLE`
       *[other] add its position in the base frame: `--instrument X,Y,Z`
    }

# Means: Two options give the same obstacle.
# Matters: The messages could not tell which obstacle hides a candidate.
# Do: Use a different name for each obstacle.
# Example: two options `--obstacle column=...`
obstacle-twice = obstacle { $name } is given twice
    .hint = use a different name for each obstacle

# Means: The instrument is inside a body that blocks its view.
# Matters: The instrument could see no reflector.
# Do: Check position and size of the obstacle, and the position of the instrument (mm, base of the
# robot).
# Example: `--instrument 500,0,0 --obstacle table=box:1000,1000,800,500,0,0`
instrument-inside-obstacle = the instrument is inside obstacle { $name }
    .hint = check the positions of both (mm, base of the robot)

# Means: A reflector is inside the capsule of the link that carries it.
# Matters: The link hides it at every pose.
# Do: Check the position of the reflector, or give a smaller radius or other end points of the link.
# Example: `--link q6=60 --reflector A=0,0,10`
reflector-inside-link = reflector { $reflector } is inside the link of joint { $joint }, which carries it
    .hint = give a smaller radius or the end points of the link: `--link { $joint }=RADIUS,X,Y,Z,X,Y,Z`

# Means: `--link` contains a joint that the robot does not have.
# Matters: The link hides nothing.
# Do: Use the name of the joint that moves the link.
# Example: `--link elbow=60`
link-joint-unknown = the robot has no joint { $joint }

# Means: Links are given for a robot whose joints do not form a single chain.
# Matters: The links hide nothing.
# Do: Omit `--link`. Describe bodies that do not move with `--obstacle`.
# Example: `--link q1=60` for a delta
links-unsuited = a robot of model `{ $model }` is not a single chain of joints: links cannot be given
    .hint = omit `--link`; describe bodies that do not move with `--obstacle`

draws-hidden = { $count } with a reflector hidden by { $obstacle }

# Means: `--box` contains an axis that the positions of the robot do not have.
# Matters: This limit of the box has no effect.
# Do: Use x and y for a planar robot, and x, y, z for a robot in space.
# Example: `--box z=0:100` for a planar table
box-axis-unknown = `--box`: targets of this robot have no axis `{ $name }`
    .expected = { $dimension ->
        [2] x or y
       *[other] x, y or z
    }

# Means: Candidates of a robot with working modes are random positions in a box.
# Matters: Without limits of x and y the positions would be unbounded.
# Do: Give the limits of x and y with `--box`.
# Example: a five-bar with `--generate 500` alone
box-missing = candidates of `{ $model }` are random positions: x and y of `--box` are missing
    .hint = give the region in the base frame of the robot: `--box x=FROM:TO,y=FROM:TO` (mm)

check-not-detectable = undetectable by these data: { $what } (controlled by { $keys })
check-source = { $rows ->
        [one] { $file }: 1 row, { $refused } rejected ({ $dialect })
       *[other] { $file }: { $rows } rows, { $refused } rejected ({ $dialect })
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
run-skipped = skipped: { $campaign } needs files in the folder ${ $name }, which is not set
no-controller-files = no controller file is written: the result is implausible
next-recommend = { $command } shows what each parameter contributes; controller files are in the output folder{ $withheld ->
        [0] {""}
       *[other] , marked as not to be loaded
    }
unmodelled-said = simulated errors that no parameter of the model describes: { $error }
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
fit-seen-none = none
fit-any-element = any element
zone-by-least-squares = omit --minimum-zone to fit by least squares
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
fit-held-by = defined by
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
next-paste = copy these lines into campaign.toml; `etalon check FOLDER` checks them
next-paste-refused = { $next }; these errors would remain: { $reasons }
next-simulate = { $command } writes the exports and the log
next-copy = copy the exports and the log into { $folder }; `etalon formats FILE` proposes how to read each; { $command }
next-check-asks = { $command } asks for { $keys }
next-check-refused = { $next }; these errors would remain: { $reasons }
next-command = { $command }
units-of-joints = the units of joints
unit-of-times = the unit of times
unit-of-rotations = the unit of rotations
axis-steps-not-whole = the range from { $from } to { $to } is not a whole number of steps of { $step }
assignment-without-number = `{ $name }` has no number
newer-than-unreadable = the file of `--newer-than` cannot be read: { $reason }
pose-argument-expected = expected x,y,z in mm, optionally followed by a unit quaternion qw,qx,qy,qz
axis-name-expected = the name of an axis consists of letters and digits
stdout-not-written = stdout cannot be written
plan-side = side { $side } mm, test plane { $plane }
converted-by = converted by etalon robot convert
convert-base-of-table = base of the table in the base of the robot: xyz { $xyz_mm } mm, rpy { $rpy_deg } deg
convert-flange-of-table = flange of the robot in the flange of the table: xyz { $xyz_mm } mm, rpy { $rpy_deg } deg
from-other-joints = the file has { $columns } columns of joints, and the robot has { $joints } joints: remove the columns of joints that the robot does not have
from-joints-in-order = the joints are the joints of robot.toml in the order of the file
from-unit-of-joints = replace UNIT with deg, rad, mm, m or um: the file does not give it

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

# Means: Some targets have joint values outside the range in which the residual field was measured.
# Matters: The field fades out there, so only the parameters are compensated.
# Do: Accept the larger error there, or measure these regions in the next calibration.
# Example: a target with a joint 40 degrees beyond all calibration poses
targets-beyond-field = { $count ->
        [one] target { $targets } is
       *[other] targets { $targets } are
    } outside the measured range of the residual field
    .hint = measure calibration poses in this region
# Means: `compensate` computes the commands for a controller that uses the nominal values of robot.toml.
# Controllers of Universal Robots use the factory calibration of each arm.
# Matters: If these values differ from robot.toml, the commands correct errors that the controller
# already corrects. The robot can be less accurate than without compensation, by more than 1 mm.
# Do: Put the values of the controller's calibration file into robot.toml, run the campaign again and
# compensate with them. Measure some poses after loading.
# Example: `etalon compensate prog.script --robot robot.toml` with the data sheet's values in robot.toml
controller-calibrated = the controller computes with the factory calibration of its own arm; the commands are right only if { $robot } contains these values
    .hint = put the values of the controller's calibration file into { $robot }, or measure some poses after loading
# Means: The laboratory gave a last day of validity for the parameters, and this day has passed.
# Matters: The robot may have changed: a collision or a new motor changes joint offsets, wear
# changes the geometry.
# Do: Measure a few poses and check them with `etalon verify`, or calibrate again.
# Example: `etalon export parameters.json` in 2027 with `valid_until = "2026-03-02"`
parameters-expired = the parameters are valid until { $last }; today is { $today }
    .hint = measure a few poses and check them with `etalon verify`, or calibrate again

# Means: A date of the campaign is later than today.
# Matters: Measurements and receipts are in the past: the year or the clock of the computer is
# probably wrong. Certificates print the date.
# Do: Correct the date, or the clock.
# Example: `date = "2062-03-02"` in campaign.toml
date-in-future = `{ $key }` ({ $date }) is later than today ({ $today })
    .hint = correct the date, or the clock of this computer

# Means: The axis has backlash, but the table contains one value for both directions of motion.
# Matters: The table corrects the mean of both directions; half of the backlash remains in each.
# Do: Set the backlash in the parameters of the axis, or use a format with both directions
# (linuxcnc, beckhoff).
# Example: `etalon axis-table out/parameters.json --robot robot.toml --axis q1_mm=0:500:50 --to sinumerik`
backlash-not-in-table = the table has one value for both directions; the backlash of `{ $axis }`, up to { FIXED($backlash, 5) } { $unit }, is not in it
    .hint = set it as the backlash of the axis in the control

# Means: Two options `--column` give different headings for the same column, and a file contains
# both headings.
# Matters: Only one of the two can be the column.
# Do: Remove the option with the wrong heading, or rename a heading in the file.
# Example: `--column x_mm=X1 --column x_mm=X2` for a table with X1 and X2
option-column-ambiguous = --column gives the headings `{ $first }` and `{ $second }` for `{ $column }`, and `{ $file }` contains both
    .hint = remove one of the two options

# Means: Some measured rows have no prediction with their pose and target.
# Matters: Each program must predict all test rows: the worst row could be among the missing ones.
# Do: Write a prediction for every row of the table of joint values.
# Example: a row of the predictions is deleted
predictions-missing = { $count ->
        [one] a measured row has no prediction: pose { $pose }, target `{ $target }`
       *[other] { $count } measured rows have no prediction, first pose { $pose }, target `{ $target }`
    }
    .hint = write a prediction for every row of the table of joint values

# Means: Two rows predict the same target at the same pose.
# Matters: It is unknown which of the two predictions counts.
# Do: Remove one of the rows.
# Example: a row of the predictions is repeated
prediction-repeated = pose { $pose }, target `{ $target }` is predicted twice, first in line { $line }
    .hint = keep one row for each pose and target

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

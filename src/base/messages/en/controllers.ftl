### Messages of controllers. Above each message: its explanation (see CONTRIBUTING.md, "A message").

compensate-programs = a language or vendor of robot programs: correct its programs with `etalon compensate PROGRAM`; `etalon cell` writes its tool and work object

# Means: The name of a controller format is unknown.
# Matters: No file is written.
# Do: Choose one of the formats in `etalon export --help`.
# Example: `--format jsn`
controller-format-unknown = `{ $name }` is not a controller format

kind-hexapod = a hexapod (`hexapod`)

kind-five-bar = a five-bar robot (`five_bar`)

kind-six-axis-arm = a serial arm with six revolute joints

kind-delta = a delta robot (`delta`, `delta_linear`)

kind-delta-towers = a delta robot with linear axes (`delta_linear`)

kind-urdf = a robot that a URDF file describes (`urdf`)

kind-planar-or-serial = a planar robot or a serial arm

# Means: The controller format is for another kind of robot.
# Matters: The file cannot contain the parameters of this robot.
# Do: Choose a format for this kind of robot; `etalon export --help` lists all formats.
# Example: `etalon export --format linuxcnc-hexapod` for a serial arm
format-for-other-robots = format `{ $format }` cannot describe a robot of `model = "{ $model }"`
    .expected = { $kind }
    .hint = choose another format: `etalon export --help` lists them

# Means: The robot has more joints than the format supports.
# Matters: Some joints are missing in the file.
# Do: Choose a format without this limit, for example `json` or `c-kinematics`.
# Example: an arm of ten joints for `linuxcnc-component`
format-too-many-joints = the robot has { $joints } joints, format `{ $format }` supports { $most }

# Means: The URDF file is not well-formed XML.
# Matters: The identified errors cannot be written into the origins of its joints.
# Do: Open the file in an XML editor: it marks the element that is not closed.
# Example: a `<joint>` element without its end tag
urdf-malformed = `{ $file }` is not well-formed XML
    .hint = correct the file

# Means: The program contains no closed-form formulas for the kinematics of this robot model.
# Matters: Code for a controller is generated from such formulas.
# Do: Choose a format that contains only the parameters, for example `json` or `c-header`.
# Example: `etalon export --format c-kinematics` for a model without formulas
formulas-missing = etalon cannot write the kinematics of `{ $model }` as code: it has no closed-form formulas for this model
    .hint = choose a format that contains only the parameters: `json`, `csv`, `c-header`

# Means: A constant of the generated kinematics is infinite or not a number.
# Matters: The controller computes undefined joint values.
# Do: Check the identified parameters: a length of zero or an angle of 90 deg can make a constant
# infinite.
# Example: a length of 0 mm by which the formulas divide
formula-constant-not-finite = a constant of the kinematics is non-finite
    .hint = check the identified parameters: lengths of zero and angles of 90 deg

error-above-nominal = position error at { $set } poses{ $left_out_count ->
        [0] {""}
       *[other] {" "}without { $left_out }
    }: { FIXED($written_mm, $decimals) } mm (RMS); with nominal parameters: { FIXED($nominal_mm, $decimals) } mm

# Means: The format cannot hold some of the identified parameters. Without them, the robot is less
# accurate than with nominal parameters.
# Matters: Loading this file makes the robot worse.
# Do: Choose a format that can hold these parameters; `etalon export --help` lists the formats.
# Example: `linuxcnc` for an arm whose bending was identified together with its geometry
file-worse-than-nominal = format `{ $format }` is not written: { $reason }
    .hint = choose a format that can hold these parameters; `etalon export --force` writes the file

error-near-nominal = { $case ->
        [rms] the position error is not clearly smaller than with nominal parameters
        [maximum] the largest position error is larger than with nominal parameters
       *[both] the position error is not clearly smaller than with nominal parameters, and its maximum is larger
    }: { $set } poses { FIXED($written_mm, $decimals) } mm (RMS), { FIXED($written_max_mm, $decimals) } mm (maximum); nominal { FIXED($nominal_mm, $decimals) } mm and { FIXED($nominal_max_mm, $decimals) } mm

# Means: With this file, the RMS error at these poses is less than 5 % smaller than with nominal
# parameters, or the largest error is larger. The file is written.
# Matters: The file hardly improves the robot, and some poses may become worse.
# Do: If the format omits parameters, choose a format that can hold them. Otherwise measure more
# poses, or identify other effects.
# Example: `universal-robots` for an arm whose transmission ratios cause most of its error
file-near-nominal = { $formats_count ->
        [1] format
       *[other] formats
    } `{ $formats }`: { $reason }
    .hint = compare the errors in controllers.json; if the format omits parameters, choose a format that can hold them

# Means: The format is for arms of Universal Robots, and the axes of this arm are arranged differently.
# Matters: The file contains the kinematics of this arm. But no controller of Universal Robots
# accepts them, and ur_description displays other links.
# Do: Check the convention, the order and the signs of the rows in robot.toml. For an arm of another
# vendor, choose another format, for example `urdf` or `c-kinematics`.
# Example: `universal-robots` for an ABB IRB 120
file-of-other-structure = format `{ $format }`: the axes of this arm differ from arms of Universal Robots: { $difference }
    .hint = check convention, order and signs in robot.toml; for an arm of another vendor choose another format: `etalon export --help` lists them

structure-angle = the angle between axes { $first } and { $second } is { FIXED($deg, 1) }° instead of { FIXED($expected, 0) }°

structure-no-link = axes { $first } and { $second } are parallel, only { FIXED($mm, 1) } mm apart: the link between them is missing

structure-apart = axes { $first } and { $second } are { FIXED($mm, 1) } mm apart instead of intersecting

structure-wrist-meets = axes 4 and 6 intersect axis 5 only { FIXED($mm, 1) } mm apart: the length of the wrist is missing

structure-wrist-in-plane = the distance of the wrist from the plane of axis 1 is only { FIXED($mm, 1) } mm: the shoulder offset is missing

# Means: The format cannot hold some of the identified parameters, and parameters.json does not
# contain their covariance.
# Matters: Without these parameters the others have different values. The covariance is needed to
# compute them.
# Do: Add the format to `controllers` of the campaign, so that the run identifies again without
# these parameters.
# Example: `etalon export --format linuxcnc` with an empty `covariance`
covariance-missing = format `{ $format }` cannot hold { $parameters }, and parameters.json does not contain their covariance
    .hint = run the campaign with `controllers = ["{ $format }"]`: the run then identifies again without these parameters

# Means: The solver did not converge.
# Matters: The parameters are not the solution. A robot with these parameters may be less accurate
# than before.
# Do: Check starting values and observations, and run the identification again.
# Example: parameters.json whose `termination` is `lost_patience`
parameters-not-converged = the parameters must not be loaded: { $termination }
    .hint = run the identification again before you export

# Means: The covariance matrix contains infinity or NaN.
# Matters: The uncertainties computed from it are undefined.
# Do: Run the identification again: the file was edited or damaged.
# Example: `"covariance": [[1e999]]`
covariance-not-finite = the covariance contains a non-finite number
    .hint = run the identification again

# Means: A parameter has an infinite or undefined value, nominal value or uncertainty.
# Matters: Such a number must not reach a machine.
# Do: Run the identification again: the file was edited or damaged.
# Example: a parameter `d` with the value NaN
parameter-not-finite = a number of parameter `{ $parameter }` is infinite or undefined
    .expected = finite value, nominal value and uncertainty

# Means: Two parameters in parameters.json have the same name.
# Matters: It is undefined which of them the controller uses.
# Do: Remove the wrong entry from parameters.json, or run the identification again.
# Example: two entries `"name": "d"`
parameter-twice = there are two parameters `{ $parameter }`
    .hint = run the identification again

# Means: Two parameters have the same name in the language of the controller.
# Matters: In the controller, one value overwrites the other.
# Do: Rename the target or joint after which a parameter is named. If the model names both
# parameters, choose another format.
# Example: `d-2` and `d_2`, both `ETALON_PREXYT_D_2_MM` in C
parameter-names-collide = parameters `{ $first }` and `{ $second }` both become `{ $name }` in { $language }
    .hint = rename the target or joint after which one is named, or choose another format

# Means: A parameter of the robot is missing in parameters.json.
# Matters: Its value is unknown; the nominal value is a guess.
# Do: Give the robot.toml that the identification of these parameters used.
# Example: parameters of a five-bar robot with the robot.toml of a PreXYT
parameter-missing = parameter `{ $parameter }` is missing
    .hint = give the robot.toml that the identification of these parameters used

# Means: The format stores measured positions and their errors. The folder of these parameters
# contains no measured positions.
# Matters: The file would be empty, so it is not written.
# Do: Use the `parameters.json` in the output folder of a run that measured positions.
# Example: `etalon export --format mcap` for a parameters.json outside of an output folder
positions-not-measured = format `{ $format }` contains measured positions, but no measured positions belong to these parameters
    .expected = the parameters.json in the output folder of a run that measured positions

# Means: The recording cannot be written.
# Matters: The other files of the command are not written either.
# Do: Report the message as a defect of etalon, with the parameters.json.
# Example: a recording that is larger than the memory of the machine
recording-failed = the recording cannot be written: { $reason }

# Means: The format needs the robot model, but no robot file is given.
# Matters: The names and values of parameters do not describe the kinematics.
# Do: Add the robot.toml with `--robot`.
# Example: `etalon export --format linuxcnc parameters.json` without `--robot`
robot-missing = this format needs the robot model
    .hint = add the robot.toml: `--robot FILE`

# Means: The format needs a parameter that the robot model does not have.
# Matters: The file cannot be written.
# Do: Choose a format for this robot model; `etalon export --help` lists all formats.
# Example: a format of linear deltas for a robot without the parameter `rod_1`
robot-parameter-missing = the robot has no parameter `{ $parameter }`
    .hint = choose another format: `etalon export --help` lists them

# Means: The deviation of an axis changes by more than 5 % of the distance between two neighbouring
# positions.
# Matters: No transmission has such a large error: positions and deviations are in different units.
# Do: Convert the deviations or the positions, so that both are in mm or both in deg.
# Example: positions in mm, deviations in µm
deviation-steep = the deviation changes by { $change } from { $from } to { $to }
    .expected = at most 5 % of the distance
    .hint = give positions and deviations in the same unit, mm or deg

# Means: The compensation table has more positions than the controller reads.
# Matters: The controller rejects the table, or ignores the last positions.
# Do: Measure fewer positions, or remove positions from the table.
# Example: 300 positions for LinuxCNC
axis-table-too-long = { $positions } positions are too many for { $controller }
    .expected = at most { $most }

# Means: The compensation table has fewer than two positions.
# Matters: An interpolation needs two positions.
# Do: Measure at least two positions.
# Example: one position for a SINUMERIK
axis-table-too-short = a SINUMERIK table has { $positions ->
        [one] 1 position
       *[other] { $positions } positions
    }
    .expected = at least two positions

# Means: The positions are not equidistant.
# Matters: A SINUMERIK table contains a single interval for all positions.
# Do: Measure at equal distances, or choose the table of another controller.
# Example: positions 0, 100 and 250 mm
axis-positions-uneven = the positions are not equidistant
    .hint = measure at equal distances, or choose the table of another controller

# Means: The grid has different intervals along its two axes.
# Matters: A Beckhoff CNC uses one interval for both axes.
# Do: Measure a grid with equal intervals along both axes.
# Example: 50 mm along x, 100 mm along y
plane-steps-differ = the grid has different intervals along its two axes
    .expected = { $step_mm } mm along both

# Means: A parameter is too large for a variable of a Galil controller.
# Matters: The controller stores another value.
# Do: Choose a format of floating-point numbers, for example `twincat`.
# Example: a length of 3000 m
galil-value-too-large = `{ $parameter }` is too large for a variable of a Galil controller
    .hint = choose a format of floating-point numbers

# Means: A constant of the inverse kinematics is too large for the fixed-point numbers of a Galil
# controller.
# Matters: The fixed-point arithmetic of the program overflows.
# Do: Check the parameters. If the robot really has this size, choose another controller format.
# Example: a PreXYT with a rail inclined by 10 deg
galil-constant-too-large = { $name } = { FIXED($value, 6) } is too large for the inverse kinematics on a Galil controller
    .expected = at most { $most }

# Means: A variable of a Galil controller rounds a parameter by more than a tenth of its
# uncertainty.
# Matters: The rounding makes the calibrated robot less accurate.
# Do: Choose a format of floating-point numbers, for example `twincat`.
# Example: a length with a standard uncertainty of 1e-11 mm
galil-rounding = `{ $parameter }` loses { SCIENTIFIC($rounding, 1) } { $unit } on a Galil controller; its standard uncertainty is { SCIENTIFIC($uncertainty, 1) } { $unit }
    .hint = choose a format of floating-point numbers

# Means: The robot has more joints than a Galil controller has axes.
# Matters: The program could not command all joints.
# Do: Choose another language for the targets.
# Example: targets of a robot with nine joints
galil-axes = { $joints } joints are too many for a Galil controller
    .expected = at most eight

# Means: A target is too many encoder counts away for a variable of a Galil controller.
# Matters: The controller moves to another position.
# Do: Check `counts_per_unit` and the position of the target.
# Example: 1000 counts per mm at 10,000,000 mm
galil-counts-out-of-range = target { $target }: { $counts } counts are out of range
    .expected = at most { $most } counts

# Means: The campaign gives no date of the measurements.
# Matters: A calibration certificate must contain the date of the measurements (ISO/IEC 17025,
# 7.8.2.1).
# Do: Add `date` to campaign.toml, and run the campaign again.
# Example: `controllers = ["dcc"]` without `date`
certificate-date-missing = a calibration certificate needs the date of the measurements
    .expected = `date = "YYYY-MM-DD"` in campaign.toml
    .hint = add the date and run the campaign again

# Means: A value of the plan is infinite or undefined.
# Matters: Such a number must not reach a machine, so no target is written.
# Do: Check the joint ranges and the conditions of the plan: one of them allows this value.
# Example: a position whose `x_mm` is NaN
targets-not-finite = a value of the plan is non-finite
    .hint = check the joint ranges and conditions of the plan; no target is written

# Means: The ending of the file name is not the ending of a format of targets.
# Matters: The ending determines the format.
# Do: Use a name that ends in `.json` or `.h`. For CSV use `--poses`.
# Example: `etalon plan --targets targets.txt`
targets-format-unknown = the ending of `{ $file }` is not the ending of a format of targets
    .expected = a name that ends in `.json` or `.h`
    .hint = for CSV use `--poses`

# Means: Two neighbouring axes of the arm lie on the same line.
# Matters: Denavit-Hartenberg parameters are undefined for this arm.
# Do: Check lengths and twists in robot.toml: a value of zero is probably wrong.
# Example: an arm whose links have no length and no twist
axes-coincide = two axes of the arm coincide
    .hint = check lengths and twists in robot.toml

# Means: The platform of the identified robot cannot reach the centre of the base.
# Matters: The positions of the towers are computed from the joint values at this position.
# Do: Compare the identified lengths with the drawing: a length is probably wrong.
# Example: rods of 1 mm
platform-out-of-reach = the platform does not reach the centre
    .hint = check the identified lengths

# Means: The towers are not numbered counterclockwise (seen from above), or are not 120 deg apart.
# Matters: The format requires this order; with another order, motors would be swapped.
# Do: Number the towers counterclockwise in robot.toml.
# Example: a tower that is 54 degrees from its position
tower-order = the towers are not 120 deg apart in counterclockwise order, seen from above
    .hint = number them counterclockwise: `{ $format }` requires this order

# Means: A movement, tool or base does not contain all its coordinates.
# Matters: The missing coordinates come from the previous position or frame, so they depend on what
# the program did before.
# Do: Write all coordinates in this command.
# Example: `MoveC X10` in Mecaprol, `PA 100` for two axes on a Galil controller, `$TOOL={Z 150}` in KRL
move-incomplete = `{ $command }` does not contain { $coordinates }
    .hint = write all coordinates in this command

x-and-y = both X and Y

position-of-every-axis = a position of every axis

pose-of-six = all of X, Y, Z, A, B and C

# Means: The program changes the working mode of the robot.
# Matters: The compensation computes joint values in a single working mode.
# Do: Split the program: one program for each working mode.
# Example: `M1` and `M3` in one Mecaprol program
working-mode-changes = the program changes the working mode
    .hint = split the program: one program for each working mode

# Means: A block of the program is an arc, or its coordinates are relative or not in mm.
# Matters: Its path or target depends on other blocks, so it cannot be compensated alone.
# Do: Write straight movements to absolute coordinates in mm. Replace an arc by short straight
# movements.
# Example: `G91` (relative coordinates) in G-code, `CIRC` and `LIN_REL` in KRL, `MoveC` in RAPID
movement-not-compensated = `{ $command }` cannot be compensated
    .expected = straight movements to absolute coordinates

# Means: The program uses variables or subroutines.
# Matters: The values are known only when the program runs.
# Do: Replace each variable in a target by its number.
# Example: `#1 = 10` in G-code
subroutine-not-compensated = targets with variables or subroutines cannot be compensated
    .hint = write the targets as numbers

# Means: A coordinate letter is not followed by a number.
# Matters: The target is unknown.
# Do: Replace the variable or expression by its number.
# Example: `G0 X[#1+2]`
coordinate-not-number = `{ $letter }` is not followed by a number
    .hint = write the coordinate as a number

# Means: The program moves before it sets a coordinate.
# Matters: The target depends on the position of the machine at the start of the program.
# Do: Add the coordinate to the first block that moves.
# Example: `G0 X10` as the first movement of a robot with x and y
coordinate-unknown = `{ $letter }` has no value at the first movement
    .hint = add it to the first block that moves

# Means: The quaternion of a target or of a measured pose does not have the length 1.
# Matters: The four numbers are not an orientation: a number is mistyped, or the columns contain
# another quantity.
# Do: Correct the number, or correct the columns qw, qx, qy, qz (scalar first).
# Example: `[0.7, 0, 0, 0.6]`
quaternion-length = the quaternion of { $target } has the length { FIXED($length, 4) }
    .expected = length 1

# Means: The first line of the template does not list the parameters that its file contains.
# Matters: Identified parameters that are not listed count as omitted, so the others are identified
# again without them.
# Do: Begin the template with a comment that lists the parameters, or patterns of their names.
# Example: a template that begins with its first line of output
template-without-holds = the template does not list the parameters that its file contains
    .expected = a first line like `{"{#"} holds: theta_* {"#}"}`
    .hint = list the parameters; `*` matches any text, so `holds: *` lists all parameters

convert-to-denavit-hartenberg = an arm of screw axes (`poe`) has no joint zeros: write its robot.toml with `etalon robot convert robot.toml --to dh`, and run the campaign again

# Means: The first line of the template lists a parameter that the robot does not have.
# Matters: A value that the template needs is missing in the file.
# Do: Correct the name; parameters.json contains all names.
# Example: `{# holds: thta_* #}`
template-holds-unknown = no parameter matches `{ $pattern }`

# Means: The first line of a template lists parameters whose values the template does not write.
# Matters: Errors, verdict and test of the file contain the values of these parameters; the controller
# keeps its own.
# Do: List after `holds:` only the parameters that the template writes.
# Example: `holds: theta_*` in a template that writes `theta_2` and `theta_3`
template-parameters-unread = the template lists { $count ->
        [one] 1 parameter
       *[other] { $count } parameters
    } that it does not write: { $names }; the errors of this file are the errors of another file
    .hint = list after `holds:` only the parameters that the template writes

# Means: The file name of a template does not end with `.j2`.
# Matters: The template NAME.j2 writes the file NAME.
# Do: Rename the template: add `.j2` to the name of the file that it writes.
# Example: `etalon export --template offsets.ini`
template-name = the name of template `{ $file }` does not end with `.j2`
    .hint = rename the template: NAME.j2 writes the file NAME

# Means: A template cannot be filled with the parameters.
# Matters: No file is written.
# Do: Correct this line. The page "Write a format of your own" lists the values and filters of a
# template.
# Example: `{{ parameter["theta_9"].value }}` for a robot of six joints
controller-template-failed = the template cannot be filled: { $reason }
    .hint = correct this line

# Means: The language of the measuring program is unknown: neither the ending of the file nor an
# option gives it.
# Matters: The language is not guessed.
# Do: Use the ending of the language, or add `--program-language`.
# Example: `--program measure.txt`
measuring-language-unknown = the language of { $file } is unknown
    .expected = .mod (RAPID), .src (KRL), .script (URScript), .ls (FANUC), .kl (Karel), .jbi (INFORM) or .ngc (G-code), or `--program-language`

# Means: Programs in this language move six revolute axes, and in some languages prismatic external
# axes. This robot has other joints.
# Matters: It is unknown which axis of the controller belongs to a joint.
# Do: Write the poses as a table (`--poses`) or as targets (`--targets`), and program them by hand.
# Example: `--program measure.mod` for a delta
measuring-joints-unsuited = a program in { $language } moves six revolute axes{ $external ->
        [0] { "" }
       *[other] , after up to { $external } prismatic external axes
    }; this robot has { $revolute } revolute and { $prismatic } prismatic joints
    .hint = write the poses with `--poses FILE` or `--targets FILE`

# Means: The values of a joint are motor values: its nominal gain is not 1.
# Matters: A program commands joint values; with motor values the joint would move to a wrong
# position.
# Do: Write the poses as a table, divide the values by the gain, and program them by hand.
# Example: a joint with gain 0.01
measuring-motor-values = the values of joint { $joint } are motor values (gain { $gain }), but a program commands joint values
    .hint = write the poses with `--poses FILE`, and convert them to joint values

# Means: The language has no digital output with this name or number.
# Matters: The controller rejects the program, or sets another output.
# Do: Give the name of the signal (RAPID) or the number of the output, as configured in the
# controller.
# Example: `--program measure.src --trigger probe`
measuring-output-unsuited = `{ $output }` is not a digital output of { $language }
    .expected = { $language ->
        [rapid] the name of a signal
       *[other] a number from { $first } to { $last }
    }

# Means: In this language, each axis has a letter, and the option with the letters is missing.
# Matters: The letters are a setting of the controller, and are never guessed.
# Do: Add `--axes` with one letter for each joint, in the order of the robot file.
# Example: `--program measure.ngc` without `--axes`
measuring-axes-missing = a program in { $language } needs the letter of each of { $joints } axes
    .hint = add them in the order of the joints: `--axes LETTERS` (of XYZABCUVW)

# Means: Programs in this language command motor pulses, and the pulses per degree are unknown.
# Matters: The pulses per degree, with their sign, are settings of the controller, and are never
# guessed.
# Do: Add `--pulses` with one number for each joint, in the order of the robot file.
# Example: `--program measure.jbi` without `--pulses`
measuring-pulses-missing = a job in { $language } needs the pulses per deg or mm of each of { $joints } joints
    .hint = add them in the order of the joints: `--pulses P1,P2,...`


# Means: Two neighbouring axes are nearly parallel. `genserkins` has no Hayati angle: its table
# needs the common normal of the two axes, which is far away from the arm.
# Matters: Large lengths then cancel each other. If a value in the HAL file is rounded, the flange
# moves, and the inverse kinematics of `genserkins` loses digits.
# Do: Use `linuxcnc-component`, which uses the identified model with Hayati's angle or screw axes.
# Otherwise copy all digits.
# Example: axes 2 and 3 of an arm, parallel within 1 mrad
linuxcnc-distant-normal = axes { $first } and { $second } are nearly parallel: the table of `genserkins` contains their common normal, { FIXED($away_mm, 0) } mm away, so rounded values move the flange
    .hint = use the format `linuxcnc-component`, which contains Hayati's angle and screw axes

# Means: The arm has joint offsets, but `genserkins` has none: it uses the position of a LinuxCNC
# joint as the angle of the table.
# Matters: Without the offsets, the loaded file describes another arm.
# Do: Add the offset of each joint to HOME_OFFSET, HOME, MIN_LIMIT and MAX_LIMIT of its [JOINT_n]
# section, or use `linuxcnc-component`, which contains them.
# Example: an arm whose table has theta = 90 deg in one row
linuxcnc-joint-offsets = `genserkins` has no joint offsets: without them the flange is off by { FIXED($off_mm, 1) } mm at joint values zero. Offsets by LinuxCNC joint (deg): { $offsets_deg }
    .hint = add them to HOME_OFFSET, HOME, MIN_LIMIT and MAX_LIMIT of [JOINT_n], or use `linuxcnc-component`

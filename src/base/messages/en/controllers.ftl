### Messages of controllers. Above each message: its explanation (see CONTRIBUTING.md, "A message").

compensate-programs = a language or maker of robot programs: correct its programs with `etalon compensate PROGRAM`; `etalon cell` writes its tool and work object

# Means: The name of a controller format is unknown.
# Matters: No file is written.
# Do: Use a format that `etalon export --help` lists.
# Example: `--format jsn`
controller-format-unknown = `{ $name }` is not a controller format

kind-hexapod = a hexapod (`hexapod`)

kind-five-bar = a five-bar robot (`five_bar`)

kind-six-axis-arm = a serial arm with six revolute joints

kind-delta = a delta robot (`delta`, `delta_linear`)

kind-delta-towers = a delta robot with linear axes (`delta_linear`)

kind-urdf = a robot that a URDF file describes (`urdf`)

kind-planar-or-serial = a planar robot or a serial arm

# Means: The controller format describes another kind of robot.
# Matters: The file has no place for the parameters of this robot.
# Do: Choose a format for this kind of robot; `etalon export --help` lists all formats.
# Example: `etalon export --format linuxcnc-hexapod` for a serial arm
format-for-other-robots = format `{ $format }` cannot describe a robot of `model = "{ $model }"`
    .expected = { $kind }
    .hint = choose another format: `etalon export --help` lists them

# Means: The robot has more joints than the controller moves.
# Matters: The file would lack joints.
# Do: Choose another format.
# Example: an arm of ten joints for `linuxcnc-component`
format-too-many-joints = the robot has { $joints } joints, format `{ $format }` has { $most }

# Means: The URDF file is not well-formed XML.
# Matters: The identified errors cannot be written into the origins of its joints.
# Do: Correct the file with an XML editor.
# Example: a `<joint>` element without its end tag
urdf-malformed = `{ $file }` is not well-formed XML
    .hint = correct the file

# Means: etalon has no closed formulas for the kinematics of this robot model.
# Matters: Code for a controller is generated from these formulas.
# Do: Use a format that holds parameters, for example `json` or `c-header`.
# Example: `etalon export --format c-kinematics` for a model without formulas
formulas-missing = no formulas exist for the kinematics of `{ $model }`
    .hint = use a format that holds parameters: `json`, `csv`, `c-header`

# Means: A constant of the generated kinematics is infinite or not a number.
# Matters: The controller would compute undefined joint values.
# Do: Check the parameters: lengths of zero and angles of 90 deg make constants infinite.
# Example: a length of 0 mm by which the formulas divide
formula-constant-not-finite = a constant of the kinematics is non-finite
    .hint = check the identified parameters

error-above-nominal = position error at { $set } poses{ $left_out_count ->
        [0] {""}
       *[other] {" "}without { $left_out }
    }: { FIXED($written_mm, $decimals) } mm (RMS); with nominal parameters: { FIXED($nominal_mm, $decimals) } mm

# Means: The format leaves out identified parameters, and without them the robot is less accurate
# than with nominal parameters.
# Matters: The robot would be less accurate with this file.
# Do: Use a format that holds these parameters.
# Example: `linuxcnc` for an arm whose bending was identified together with its geometry
file-worse-than-nominal = format `{ $format }` is not written: { $reason }
    .hint = use a format that holds these parameters; `etalon export --force` writes the file

error-near-nominal = { $case ->
        [rms] the position error is not clearly smaller than with nominal parameters
        [maximum] the largest position error exceeds that of nominal parameters
       *[both] the position error is not clearly smaller than with nominal parameters, and its maximum is larger
    }: { $set } poses { FIXED($written_mm, $decimals) } mm (RMS), { FIXED($written_max_mm, $decimals) } mm (maximum); nominal { FIXED($nominal_mm, $decimals) } mm and { FIXED($nominal_max_mm, $decimals) } mm

# Means: The file is written. At these poses it reduces the RMS error by less than 5 %, or increases
# the largest error.
# Matters: The robot gains little by the file, or is less accurate at some poses.
# Do: Use a format that holds all identified parameters. If the format holds them, measure more
# poses or identify other effects.
# Example: `universal-robots` for an arm whose transmission ratios cause most of its error
file-near-nominal = { $formats_count ->
        [1] format
       *[other] formats
    } `{ $formats }`: { $reason }
    .hint = compare the errors in controllers.json; if the format omits parameters, use a format that holds them

# Means: The format is for arms of Universal Robots, and the axes of this arm are arranged differently.
# Matters: The file holds the kinematics of this arm, but no controller of Universal Robots fits it, and
# ur_description draws other links.
# Do: Check robot.toml: convention, order and signs of the rows. For an arm of another maker use
# another format, for example `urdf` or `c-kinematics`.
# Example: `universal-robots` for an ABB IRB 120
file-of-other-structure = format `{ $format }`: this arm has other axes than arms of Universal Robots: { $difference }
    .hint = check convention, order and signs in robot.toml; for an arm of another maker choose another format: `etalon export --help` lists them

structure-angle = axes { $first } and { $second } are { FIXED($deg, 1) }° apart instead of { FIXED($expected, 0) }°

structure-no-link = axes { $first } and { $second } are parallel at a distance of { FIXED($mm, 1) } mm, without a link between them

structure-apart = axes { $first } and { $second } pass each other at { FIXED($mm, 1) } mm instead of meeting

structure-wrist-meets = axes 4 and 6 meet axis 5 { FIXED($mm, 1) } mm from each other instead of a wrist length apart

structure-wrist-in-plane = the wrist is { FIXED($mm, 1) } mm beside the plane of axis 1 instead of a shoulder offset

# Means: The format leaves out identified parameters, and parameters.json has no covariance of them.
# Matters: Only the covariance determines how the other parameters change without them.
# Do: Let the run identify again without these parameters.
# Example: `etalon export --format linuxcnc` with an empty `covariance`
covariance-missing = format `{ $format }` does not hold { $parameters }, and parameters.json has no covariance of them
    .hint = run the campaign with `controllers = ["{ $format }"]`: the run identifies again without these parameters

# Means: The solver did not converge.
# Matters: The parameters are not the solution; a robot that uses them may be less accurate than
# before.
# Do: Identify again: check starting values and observations.
# Example: parameters.json whose `termination` is `lost_patience`
parameters-not-converged = the parameters are not fit for a controller: { $termination }
    .hint = identify again before exporting

# Means: The covariance matrix holds infinity or not-a-number.
# Matters: Uncertainties that follow from it are undefined.
# Do: Run the identification again; the file was changed or damaged.
# Example: `"covariance": [[1e999]]`
covariance-not-finite = the covariance holds a non-finite number
    .hint = run the identification again

# Means: A parameter has a value, nominal value or uncertainty that is infinite or not a number.
# Matters: It must not reach a machine.
# Do: Run the identification again; the file was changed or damaged.
# Example: a parameter `d` with the value NaN
parameter-not-finite = parameter `{ $parameter }` has a non-finite number
    .expected = finite value, nominal value and uncertainty

# Means: Two parameters have the same name.
# Matters: It is undefined which of them the controller uses.
# Do: Remove one of them from parameters.json, or run the identification again.
# Example: two entries `"name": "d"`
parameter-twice = there are two parameters `{ $parameter }`
    .hint = run the identification again

# Means: Two parameters have the same name in the language of the controller.
# Matters: One would overwrite the other.
# Do: Rename one of the parameters, or use another format.
# Example: `d-2` and `d_2`, both `ETALON_PREXYT_D_2_MM` in C
parameter-names-collide = parameters `{ $first }` and `{ $second }` are both `{ $name }` in { $language }
    .hint = rename one of them, or use another format

# Means: parameters.json lacks a parameter that the robot has.
# Matters: Its value is unknown; the nominal value would be a guess.
# Do: Name the robot.toml with which the parameters were identified.
# Example: parameters of a five-bar robot with the robot.toml of a PreXYT
parameter-missing = parameter `{ $parameter }` is missing
    .hint = name the robot.toml with which the parameters were identified

# Means: The recording contains measured positions and their errors, and these parameters have none.
# Matters: The file would be empty.
# Do: Export from the `parameters.json` in the output folder of a run that measured positions.
# Example: `etalon export --format mcap` for a parameters.json outside of an output folder
positions-not-measured = format `{ $format }` needs measured positions, and the parameters come without them
    .expected = the parameters.json in the output folder of a run that measured positions

# Means: The recording cannot be written.
# Matters: The other files of the command are not written either.
# Do: Report the message with the parameters.json: etalon writes recordings of any size in memory.
# Example: a recording beyond the memory of the machine
recording-failed = the recording cannot be written: { $reason }

# Means: The format needs the robot model, and no robot is named.
# Matters: Names and values of parameters alone do not describe the kinematics.
# Do: Name the robot.toml.
# Example: `etalon export --format linuxcnc parameters.json` without `--robot`
robot-missing = this format needs the robot model
    .hint = name the robot.toml: `--robot FILE`

# Means: A format asks for a parameter that the robot model lacks.
# Matters: The file cannot be written.
# Do: Choose a format for this robot model.
# Example: a format of linear deltas for a robot without the parameter `rod_1`
robot-parameter-missing = the robot has no parameter `{ $parameter }`
    .hint = choose another format: `etalon export --help` lists them

# Means: The deviation of an axis changes by more than 5 % of the distance between two neighbouring
# positions.
# Matters: No transmission changes as much: positions and deviations are in different units.
# Do: State positions and deviations in the same unit, mm or deg.
# Example: positions in mm, deviations in µm
deviation-steep = the deviation changes by { $change } from { $from } to { $to }
    .expected = at most 5 % of the distance
    .hint = state positions and deviations in the same unit, mm or deg

# Means: The compensation table has more positions than the controller reads.
# Matters: The controller rejects the file, or ignores the rest.
# Do: Measure at fewer positions.
# Example: 300 positions for LinuxCNC
axis-table-too-long = { $positions } positions are too many for { $controller }
    .expected = at most { $most }

# Means: The compensation table has fewer than two positions.
# Matters: An interpolation needs two positions.
# Do: Measure at two positions at least.
# Example: one position for a SINUMERIK
axis-table-too-short = a SINUMERIK table has { $positions ->
        [one] 1 position
       *[other] { $positions } positions
    }
    .expected = at least two positions

# Means: The distances between the positions differ.
# Matters: A SINUMERIK table states one constant distance.
# Do: Measure at equal distances, or use another table.
# Example: positions 0, 100 and 250 mm
axis-positions-uneven = the positions are not equidistant
    .hint = measure at equal distances, or use another table

# Means: The grid of a plane has different distances along its two axes.
# Matters: A Beckhoff CNC has one interval for both axes.
# Do: Measure a grid of squares.
# Example: 50 mm along x, 100 mm along y
plane-steps-differ = the grid has different distances along its axes
    .expected = { $step_mm } mm along both

# Means: A parameter exceeds the range of a variable of a Galil controller.
# Matters: The controller would store another value.
# Do: Use a format of floating-point numbers, for example `twincat`.
# Example: a length of 3000 m
galil-value-too-large = `{ $parameter }` is too large for a variable of a Galil controller
    .hint = use a format of floating-point numbers

# Means: A constant of the inverse kinematics is too large for the fixed-point numbers of a Galil
# controller.
# Matters: Products of the program would overflow.
# Do: Check the parameters; use another controller format for a robot of this size.
# Example: a PreXYT with a rail inclined by 10 deg
galil-constant-too-large = { $name } = { FIXED($value, 6) } is too large for the inverse kinematics on a Galil controller
    .expected = at most { $most }

# Means: A variable of a Galil controller rounds a parameter by more than a tenth of its
# uncertainty.
# Matters: The calibration would lose accuracy.
# Do: Use a format of floating-point numbers.
# Example: a length with a standard uncertainty of 1e-11 mm
galil-rounding = `{ $parameter }` loses { SCIENTIFIC($rounding, 1) } { $unit } on a Galil controller; its standard uncertainty is { SCIENTIFIC($uncertainty, 1) } { $unit }
    .hint = use a format of floating-point numbers

# Means: The robot has more joints than a Galil controller has axes.
# Matters: The program cannot command all joints.
# Do: Use another language.
# Example: targets of a robot with nine joints
galil-axes = { $joints } joints are too many for a Galil controller
    .expected = at most eight

# Means: A target needs more encoder counts than a variable of a Galil controller holds.
# Matters: The controller would move to another position.
# Do: Check `counts_per_unit` and the target.
# Example: 1000 counts per mm at 10,000,000 mm
galil-counts-out-of-range = target { $target }: { $counts } counts are out of range
    .expected = at most { $most } counts

# Means: The campaign states no date of the measurements.
# Matters: A calibration certificate has the date of its measurements (ISO/IEC 17025, 7.8.2.1).
# Do: State `date` in campaign.toml and run the campaign again.
# Example: `controllers = ["dcc"]` without `date`
certificate-date-missing = a calibration certificate needs the date of the measurements
    .expected = `date = "YYYY-MM-DD"` in campaign.toml
    .hint = state the date and run the campaign again

# Means: A value of the plan is infinite or not a number.
# Matters: It must not reach a machine, so no target is written.
# Do: Check the joint ranges and conditions of the plan.
# Example: a position whose `x_mm` is NaN
targets-not-finite = a value of the plan is non-finite
    .hint = check the joint ranges and conditions of the plan; no target is written

# Means: The ending of the file name is not a format of targets.
# Matters: The format follows from the ending.
# Do: End the name in `.json` or `.h`; write CSV with `--poses`.
# Example: `etalon plan --targets targets.txt`
targets-format-unknown = the ending of `{ $file }` is not a format of targets
    .expected = a name that ends in `.json` or `.h`
    .hint = for CSV use `--poses`

# Means: Two neighbouring axes of the arm are the same line.
# Matters: Denavit-Hartenberg parameters of such an arm are undefined.
# Do: Check the robot.toml.
# Example: an arm whose links have no length and no twist
axes-coincide = two axes of the arm coincide
    .hint = check the robot.toml

# Means: The identified robot cannot place its platform at the centre of the base.
# Matters: The positions of the towers follow from joint values at this place.
# Do: Check the identified lengths.
# Example: rods of 1 mm
platform-out-of-reach = the platform does not reach the centre
    .hint = check the identified lengths

# Means: The towers do not follow each other at 120 deg, counterclockwise seen from above.
# Matters: The format has the towers in this order; another order would exchange motors.
# Do: Number the towers counterclockwise in robot.toml.
# Example: a tower that is 54 degrees from its position
tower-order = the towers are not at 120 deg from each other, counterclockwise from above
    .hint = number them counterclockwise: `{ $format }` has them in this order

# Means: A movement, or a tool or base, does not state all its coordinates.
# Matters: The missing coordinates are those of the previous position or frame, which depends on the
# course of the program.
# Do: State all coordinates.
# Example: `MoveC X10` in Mecaprol, `PA 100` for two axes on a Galil controller, `$TOOL={Z 150}` in KRL
move-incomplete = `{ $command }` does not state { $coordinates }
    .hint = state all coordinates

x-and-y = both X and Y

position-of-every-axis = a position of every axis

pose-of-six = all of X, Y, Z, A, B and C

# Means: The program changes the working mode of the robot.
# Matters: Compensation computes joint values in one working mode.
# Do: Give the targets of each working mode as a program of their own.
# Example: `M1` and `M3` in one Mecaprol program
working-mode-changes = the program changes the working mode
    .hint = give the targets of each working mode as a program of their own

# Means: A block of the program is an arc, or its coordinates are relative or not in mm.
# Matters: Its path or target depends on other blocks, so that it cannot be compensated alone.
# Do: Rewrite the block with absolute coordinates, and an arc as short straight movements.
# Example: `G91` (relative coordinates) in G-code, `CIRC` and `LIN_REL` in KRL, `MoveC` in RAPID
movement-not-compensated = `{ $command }` is not compensated
    .expected = straight movements to absolute coordinates

# Means: The program uses variables or subroutines.
# Matters: Their values are known only when the program runs.
# Do: Write the targets as numbers.
# Example: `#1 = 10` in G-code
subroutine-not-compensated = variables and subroutines are not compensated
    .hint = write the targets as numbers

# Means: A coordinate letter is not followed by a number.
# Matters: The target is unknown.
# Do: Write the coordinate as a number.
# Example: `G0 X[#1+2]`
coordinate-not-number = `{ $letter }` is not followed by a number
    .hint = write the coordinate as a number

# Means: The program moves before a coordinate has a value.
# Matters: The target depends on the position of the machine at the start.
# Do: State the coordinate in the first block that moves.
# Example: `G0 X10` as the first movement of a robot with x and y
coordinate-unknown = `{ $letter }` has no value yet
    .hint = state it in the first block that moves

# Means: The quaternion of a target or of a measured pose does not have the length 1.
# Matters: It is not an orientation; a number is mistyped, or a column holds another quantity.
# Do: Correct the quaternion, or the columns qw, qx, qy, qz (scalar first).
# Example: `[0.7, 0, 0, 0.6]`
quaternion-length = the quaternion of { $target } has the length { FIXED($length, 4) }
    .expected = length 1

# Means: The first line of a template does not state which parameters its file holds.
# Matters: All other identified parameters count as left out: the values are identified again without them.
# Do: Begin the template with a comment that names parameters, or patterns of their names.
# Example: a template that begins with its first line of output
template-without-holds = the template does not state the parameters that its file holds
    .expected = a first line like `{"{#"} holds: theta_* {"#}"}`
    .hint = name the parameters; `*` stands for any text, and `holds: *` for all parameters

# Means: The first line of a template names parameters that the robot lacks.
# Matters: The file would lack values that the template expects.
# Do: Correct the name; parameters.json lists all of them.
# Example: `{# holds: thta_* #}`
template-holds-unknown = no parameter matches `{ $pattern }`

# Means: The file name of a template does not end with `.j2`.
# Matters: The template NAME.j2 writes the file NAME.
# Do: Rename the template.
# Example: `etalon export --template offsets.ini`
template-name = the name of template `{ $file }` does not end with `.j2`
    .hint = rename the template: NAME.j2 writes the file NAME

# Means: A template cannot be filled with the parameters.
# Matters: No file is written.
# Do: Correct the line; the page "Write a format of your own" lists values and filters.
# Example: `{{ parameter["theta_9"].value }}` for a robot of six joints
controller-template-failed = the template cannot be filled: { $reason }
    .hint = correct this line

# Means: Neither the ending of the file nor an option states the language of the measuring program.
# Matters: The language is not guessed.
# Do: Use an ending of the language, or state it.
# Example: `--program measure.txt`
measuring-language-unknown = the language of { $file } is unknown
    .expected = .mod (RAPID), .src (KRL), .script (URScript), .ls (FANUC), .kl (Karel), .jbi (INFORM) or .ngc (G-code), or `--program-language`

# Means: The language moves arms with six revolute axes, perhaps on prismatic external axes; this robot has other joints.
# Matters: It is unknown which axis of the controller a joint is.
# Do: Write the poses as a table (`--poses`) or as targets (`--targets`), and program them by hand.
# Example: `--program measure.mod` for a delta
measuring-joints-unsuited = a program in { $language } moves six revolute axes{ $external ->
        [0] { "" }
       *[other] , after up to { $external } prismatic external axes
    }; this robot has { $revolute } revolute and { $prismatic } prismatic joints
    .hint = write the poses with `--poses FILE` or `--targets FILE`

# Means: The values of a joint are those of its motor: its nominal gain differs from 1.
# Matters: A controller would move the joint to the value of the motor.
# Do: Write the poses as a table, and convert them to joint values.
# Example: a joint with gain 0.01
measuring-motor-values = the values of joint { $joint } are those of its motor (gain { $gain }), which a program does not command
    .hint = write the poses with `--poses FILE`, and convert them to joint values

# Means: The language has no output of the stated form for the trigger.
# Matters: The program would not load, or would set another output.
# Do: State the signal (RAPID) or the number of the output as the controller has it.
# Example: `--program measure.src --trigger probe`
measuring-output-unsuited = `{ $output }` is not a digital output of { $language }
    .expected = { $language ->
        [rapid] the name of a signal
       *[other] a number from { $first } to { $last }
    }

# Means: The language moves axes by letters, and an option has to state which letters.
# Matters: The letter of a joint is a setting of the controller, which is never guessed.
# Do: State one letter for each joint, in the order of the robot file.
# Example: `--program measure.ngc` without `--axes`
measuring-axes-missing = a program in { $language } needs the letter of each of { $joints } axes
    .hint = state them in the order of the joints: `--axes LETTERS` (of XYZABCUVW)

# Means: The language commands pulses of the motors.
# Matters: Pulses per degree are parameters of the controller, with a sign of their own, and are never guessed.
# Do: State one number for each joint, in the order of the robot file.
# Example: `--program measure.jbi` without `--pulses`
measuring-pulses-missing = a job in { $language } needs the pulses per deg or mm of each of { $joints } joints
    .hint = state them in the order of the joints: `--pulses P1,P2,...`


# Means: Two neighbouring axes are near-parallel. `genserkins` has no Hayati angle, so its table
# places the axes by their exact common normal, which is far from the arm.
# Matters: Large lengths cancel each other: rounding a value in the HAL file moves the flange, and the
# iterative inverse kinematics of `genserkins` loses digits.
# Do: Use `linuxcnc-component`, whose equations are those of the identified model, with Hayati's
# angle or screw axes. Otherwise copy every digit.
# Example: axes 2 and 3 of an arm, parallel within 1 mrad
linuxcnc-distant-normal = axes { $first } and { $second } are near-parallel: `genserkins` has their common normal { FIXED($away_mm, 0) } mm away, so that rounded values move the flange
    .hint = use the format `linuxcnc-component`, which holds Hayati's angle and screw axes

# Means: The arm has joint offsets. `genserkins` has none: it takes the position of a LinuxCNC joint
# for the angle of the table.
# Matters: Loaded without the offsets, the file describes another arm.
# Do: Add the offset of each joint to HOME_OFFSET, HOME, MIN_LIMIT and MAX_LIMIT of its [JOINT_n]
# section, or use `linuxcnc-component`, which contains them.
# Example: an arm whose table has theta = 90 deg in one row
linuxcnc-joint-offsets = `genserkins` has no joint offsets: without them the flange is off by { FIXED($off_mm, 1) } mm at joint values zero. Offsets by LinuxCNC joint (deg): { $offsets_deg }
    .hint = add them to HOME_OFFSET, HOME, MIN_LIMIT and MAX_LIMIT of [JOINT_n], or use `linuxcnc-component`

### Messages of campaign. Above each message: its explanation (see CONTRIBUTING.md, "A message").

no-file-listed = the list of files is empty
# Means: A recording states `format` without `unit`, or `unit` without `format`.
# Matters: Exports of a format carry no unit; a plain table states units in its header.
# Do: State both, or neither.
# Example: `format = "polyworks"` without `unit`
recording-unit = `format` and `unit` of a recording belong together
    .hint = state both, or neither for a table time_s,x_mm,y_mm,z_mm, whose header states the units

# Means: The folder has no campaign.toml, or the file does not exist.
# Matters: A command on a campaign starts from this file.
# Do: Check the path, or write a campaign with `etalon init`.
# Example: `etalon run nowhere`
campaign-missing = the campaign file `{ $file }` does not exist
    .hint = `etalon init FOLDER` writes one to start from

# Means: An export with `joints` is not delimited text with at most one row of names.
# Matters: Joint columns are found by their names in the header.
# Do: State the delimiter and the header, or name the joints in a [log].
# Example: `joints` for `format = "polyworks"`
joints-need-delimited-text = `joints` can be read from delimited text with at most one row of names
    .hint = state `format = {"{"} delimiter = .., header = 1, columns = .. {"}"}`; for other files name the joints in a [log]

# Means: Two exports of one file state different columns as `joints`.
# Matters: The joints of a row are the joints of all its points.
# Do: State the same columns in both exports.
# Example: `joints` with `J2` in one and `J3` in the other [[export]] of a file
joints-differ = two exports of `{ $file }` state different `joints`
    .hint = state the same columns in both

# Means: Joint values are stated in an export and in [log].
# Matters: It is undefined which values apply.
# Do: Leave one of them out.
# Example: `joints` of an export beside a [log]
joints-twice = the joints are stated twice: in `joints` of `{ $file }` and in [log]
    .hint = leave one of them out

# Means: An export with `joints` is joined by another key than the row.
# Matters: Its points and joints are in the same row.
# Do: State `by = "row"` in [join], or omit [join].
# Example: `by = "time"` beside `joints` of an export
joints-joined-by-row = an export with `joints` is joined by its rows
    .hint = state `by = "row"` in [join], or omit [join]

# Means: A path begins with `$NAME/`, and this environment variable is not set.
# Matters: The file cannot be found.
# Do: Set the variable to the folder that holds the file.
# Example: `file = "$DATA/poses.txt"` without `DATA`
environment-missing = the environment variable `{ $name }` is not set
    .hint = set { $name } to the folder that holds `{ $file }`

# Means: A path leaves the folder of the campaign.
# Matters: A campaign must be complete in its folder, so that it can be archived and run elsewhere.
# Do: Copy the file into the folder, or use a path that starts with `$NAME/`.
# Example: `file = "../poses.txt"`
path-outside = `{ $file }` leaves the folder of the campaign
    .expected = a path inside the campaign's folder, or one that starts with `$NAME/`

# Means: The campaign of a spatial robot names no target.
# Matters: Measured points are points of targets on the robot.
# Do: Name the targets in `targets` of [join], as `target` of the exports, or in a column `target`.
# Example: a serial arm without `targets`
no-target = a spatial robot needs at least one target
    .hint = name the targets in `targets` of [join], as `target` of the exports, or in a column `target` of the table

# Means: A target is called `base`.
# Matters: Its parameters would have the same names as those of the robot's base.
# Do: Give the target another name.
# Example: a label `base_1_1` read as `{target}_{pose}_{cycle}`
target-called-base = a target must not be called `base`: its parameters would have the same names as parameters of the robot's base
    .hint = give the target another name in label or columns

# Means: A key that needs a positive number has zero, a negative number or NaN.
# Matters: The value has no meaning.
# Do: Correct the value.
# Example: `gear_ratio = 0`
key-not-positive = `{ $key }` must be positive
    .hint = correct the value

# Means: A joint of robot.toml lacks a key.
# Matters: The kinematics are incomplete.
# Do: State the key.
# Example: a [[joint]] without `a_mm`
joint-key-missing = the key `{ $key }` is missing in `joint`

direction-in-base = a direction in the base, for example { $example }

# Means: Two keys state the same quantity in different units or forms.
# Matters: It is undefined which of them applies.
# Do: Leave one of them out.
# Example: `a_mm = 300` and `a_m = 0.3`
keys-state-the-same = { $keys } state the same quantity: leave one of them out

# Means: The file states more or fewer than six legs for a hexapod.
# Matters: The kinematics of a hexapod need exactly six legs.
# Do: State one [[leg]] for each leg.
# Example: five [[leg]]
leg-count = a hexapod has six legs; the file states { $count }
    .hint = add one [[leg]] with base_mm and platform_mm for each leg

# Means: At its home pose the platform can move while all legs keep their lengths.
# Matters: Leg lengths do not determine the pose there.
# Do: Check `base_mm` and `platform_mm`, or state another home pose.
# Example: six parallel legs
hexapod-singular = the hexapod is singular at its home pose: six leg lengths do not determine its pose there
    .hint = check `base_mm` and `platform_mm`, or state another home pose

# Means: robot.toml of a serial arm has no joints.
# Matters: There is nothing to identify.
# Do: Add one [[joint]] for each joint, from the base.
# Example: `model = "serial"` alone
no-joints = a serial arm needs its joints
    .hint = add one [[joint]] with alpha_deg, a_mm, theta_deg, d_mm for each joint, from the base

# Means: `gravity` is zero or not finite.
# Matters: Bending depends on the direction of gravity.
# Do: State the direction in the base.
# Example: `gravity = [0, 0, 0]`
gravity-without-direction = `gravity` has no direction
    .expected = a direction in the base, for example [0, 0, -1]

# Means: A key of screw axes is stated for Denavit-Hartenberg parameters.
# Matters: It has no effect.
# Do: State `convention = "poe"`, or remove the key.
# Example: `point_mm` in a [[joint]] with `a_mm`
not-denavit-hartenberg = `{ $key }` is not a Denavit-Hartenberg parameter
    .hint = it belongs to `convention = "poe"`

# Means: Denavit-Hartenberg parameters or `parallel` are stated for a screw axis.
# Matters: They have no effect.
# Do: State `direction` and `point_mm`.
# Example: `a_mm` with `convention = "poe"`
not-screw-axis = a screw axis has neither Denavit-Hartenberg parameters nor `parallel`
    .hint = state `direction` and `point_mm`

# Means: The axis of a joint is zero or not finite.
# Matters: The joint has no motion.
# Do: State the direction of the axis in the base.
# Example: `direction = [0, 0, 0]`
joint-axis-without-direction = the axis of the joint has no direction
    .expected = a direction in the base, for example [0, 0, 1]

# Means: Screw axes are stated without the pose of the flange.
# Matters: The pose of the flange at zero joints is part of a product of exponentials.
# Do: State the pose of the flange.
# Example: `convention = "poe"` without `flange_mm`
flange-missing = screw axes need the pose of the flange at zero joints: the key `{ $key }` is missing

# Means: The pose of a flange is stated for Denavit-Hartenberg parameters.
# Matters: The last row of the table gives the flange; the key has no effect.
# Do: Remove the key.
# Example: `flange_mm` with `a_mm`
flange-of-table = `{ $key }` has no effect on Denavit-Hartenberg parameters
    .hint = it belongs to `convention = "poe"`

# Means: The range of a joint is stated with the key for the other kind of motion.
# Matters: Degrees and millimetres would be mixed up.
# Do: Use the key that the hint names.
# Example: `limits_deg` of a prismatic joint
range-of-other-motion = `{ $key }` is not a key of a { $motion ->
        [slides] prismatic joint
       *[turns] revolute joint
    }
    .hint = state `{ $own }`

# Means: The first limit of a range is not smaller than the second.
# Matters: The joint would have no position.
# Do: State the smaller limit first.
# Example: `limits_deg = [170, -170]`
range-exchanged = `{ $key }` is not a range: { $lower } to { $upper }
    .expected = the smaller limit, then the larger one

# Means: A coupling or transmission names joints wrongly.
# Matters: The statement cannot be assigned to joints.
# Do: Use each joint once, by number or name.
# Example: `harmonics = [8]` of a six-axis arm
joint-reference-wrong = { $fault ->
        [unknown-number] there is no joint { $joint }
        [unknown-name] there is no joint `{ $joint }`
        [slides] joint { $joint } is prismatic: it does not rotate
        [twice] joint { $joint } is named twice
        [itself] joint { $joint } is coupled with itself: state its gain instead
       *[pair] the pair { $joint } is named twice
    }
    .expected = joints from 1 to { $count }, each once
    .hint = the joints are { $joints }

# Means: A joint on the chain of a URDF has a type that etalon does not support.
# Matters: A chain has only joints with a single motion.
# Do: Use fixed, revolute, continuous or prismatic joints.
# Example: `<joint type="planar">`
urdf-joint-kind = joint `{ $joint }` is { $kind }, which is not supported
    .expected = fixed, revolute, continuous or prismatic

# Means: The axis of a joint of a URDF is zero.
# Matters: The joint has no motion.
# Do: State `<axis xyz="..."/>`.
# Example: `<axis xyz="0 0 0"/>`
urdf-axis-without-direction = the axis of joint `{ $joint }` has no direction
    .expected = <axis xyz="0 0 1"/> or another direction

# Means: The distance of an origin of a URDF from its parent exceeds the size of a robot.
# Matters: Lengths of a URDF are in metres; the file is probably in millimetres.
# Do: Divide the lengths of the file by 1000.
# Example: `<origin xyz="300 0 0"/>`
urdf-origin-far = the origin of joint `{ $joint }` is { FIXED($away_m, 0) } m from its parent
    .hint = lengths of a URDF are in metres: divide the lengths of this file by 1000

# Means: A link of a URDF is the child of two joints.
# Matters: A URDF is a tree; loops are closed by `mimic`.
# Do: Remove one of the joints.
# Example: a parallelogram of four joints
urdf-two-parents = link `{ $link }` has two parents: `{ $first }` and `{ $second }`
    .hint = a URDF is a tree: close loops by `mimic`

# Means: Joints of a URDF form a loop.
# Matters: A URDF is a tree; loops are closed by `mimic`.
# Do: Remove one of the joints.
# Example: a joint whose child is the base link
urdf-loop = the joints beyond link `{ $link }` form a loop
    .hint = a URDF is a tree: close loops by `mimic`

# Means: The campaign names a link that the URDF lacks.
# Matters: Base or tool of the chain are unknown.
# Do: Use a link of the file.
# Example: `tool_link = "tool9"`
urdf-link-unknown = `{ $file }` has no link `{ $link }`

# Means: No chain of joints leads from the base link to the tool link.
# Matters: The tool does not move with the robot.
# Do: Check `base_link` and `tool_link`.
# Example: a base link of another robot in the same file
urdf-no-path = no joints lead from `{ $from }` to `{ $to }`
    .hint = check `base_link` and `tool_link`: no joint carries `{ $root }`

# Means: A joint mimics a joint that the file lacks.
# Matters: Its motion is unknown.
# Do: Name a joint of the file in <mimic>.
# Example: `<mimic joint="q9"/>`
urdf-mimic-unknown = joint `{ $joint }` mimics `{ $mimics }`, which the file does not have

# Means: A joint mimics itself.
# Matters: Its motion is undefined.
# Do: Name another joint in <mimic>.
# Example: `<joint name="q1"><mimic joint="q1"/>`
urdf-mimics-itself = joint `{ $joint }` mimics itself
    .hint = name another joint in <mimic>

# Means: A joint has several elements `mimic`. URDF couples a joint to one other joint.
# Matters: With one of them alone the kinematics would be wrong.
# Do: Keep the element that applies, or remove all of them and log the value of the joint.
# Example: a wrist whose angle is the sum of two motor angles
urdf-mimics-several = joint `{ $joint }` mimics several joints
    .hint = keep one `mimic`: a URDF joint follows one master. If `{ $joint }` depends on several joints of the chain, keep none: log the first master under its name, and state the factor of each further master in `coupling = [["{ $joint }", "..."]]` and [nominal]

# Means: All joints between base link and tool link are fixed.
# Matters: There is nothing to identify.
# Do: Check `base_link` and `tool_link`.
# Example: `tool_link` on the base
urdf-nothing-moves = no joint moves between `{ $from }` and `{ $to }`
    .hint = check `base_link` and `tool_link`

# Means: All joints of the URDF are fixed.
# Matters: There is nothing to identify.
# Do: Name the URDF of a robot.
# Example: the URDF of a table
urdf-no-moving-joint = no joint of the file moves
    .hint = name the URDF of a robot

# Means: `bending` is stated for a robot whose base link moves with joints.
# Matters: Bending needs a fixed direction of gravity.
# Do: Remove `bending`, or state a stationary link as `base_link`.
# Example: an arm on a tilting column
bending-on-moving-base = `bending` needs a fixed direction of gravity, but joints move `{ $link }`
    .hint = remove `bending`, or state a stationary link as `base_link`

# Means: `bending` is stated for a joint, but no link beyond it has a mass.
# Matters: Without a mass, gravity does not bend the joint.
# Do: Add <inertial> to its links.
# Example: a URDF without <inertial>
bending-without-mass = `bending` of joint `{ $joint }` needs a mass beyond it
    .hint = add <inertial> to its links

# Means: A target has the name of a joint, so that two parameters have the same name.
# Matters: Values could not be assigned.
# Do: Rename the target.
# Example: a target `q1`
parameter-name-doubled = two parameters would be called `{ $name }`
    .hint = rename the target: a target must not have the name of a joint

# Means: A robot of `model = "urdf"` states no link that carries its targets.
# Matters: The end of the chain is unknown.
# Do: State `tool_link`, or a [[branch]] for each link with targets.
# Example: robot.toml with `file` and `base_link` alone
tool-link-missing = no link carries the targets
    .hint = state `tool_link = "..."`, or a [[branch]] with `tool_link` and `targets` for each of several links

# Means: robot.toml states both `tool_link` and [[branch]].
# Matters: A target would be on two links.
# Do: Keep `tool_link` for one link, or [[branch]] for several.
# Example: `tool_link = "left_hand"` above a [[branch]]
tool-link-beside-branches = `tool_link` and [[branch]] both state the links of the targets
    .hint = remove `tool_link`, and give its link a [[branch]] with `targets`

# Means: Two branches list the same target.
# Matters: A target is on one link.
# Do: Remove the target from one of the branches.
# Example: `targets = ["L1"]` in both branches
target-on-two-branches = target `{ $target }` is on two branches: `{ $first }` and `{ $second }`
    .hint = remove it from `targets` of one of them

# Means: A target of the campaign is on none of the branches of robot.toml.
# Matters: Its position on the robot is unknown.
# Do: Add the target to `targets` of the branch whose link carries it.
# Example: a target `L3` that no [[branch]] lists
target-on-no-branch = target `{ $target }` is on no branch
    .hint = add it to `targets` of the [[branch]] whose link carries it

# Means: `bending` names a joint that carries several branches.
# Matters: Its load depends on the joints and masses of all branches, which one chain does not hold.
# Do: Remove the joint from `bending`.
# Example: `bending = ["torso"]` of a robot with two hands
bending-in-branches = `bending` of joint `{ $joint }` is not modelled: several branches load it
    .hint = remove the joint from `bending`

# Means: `payload` names a joint of a robot with several branches.
# Matters: Each hand has a payload of its own, and a row states one.
# Do: Remove `payload`, or describe the branch alone with `tool_link`.
# Example: `payload = ["torso"]` of a robot with two hands
payload-in-branches = `payload` of joint `{ $joint }` is not modelled: the robot has several branches
    .hint = remove `payload`, or describe the branch alone with `tool_link`

# Means: `lateral` or `pedestal` is stated for a robot with several branches.
# Matters: The masses of all branches bend the common joints and the base, and a row states one payload.
# Do: Remove the key, or describe the branch alone with `tool_link`.
# Example: `pedestal = true` of a robot with two hands
elastic-in-branches = `{ $key }` is not modelled: the robot has several branches
    .hint = remove `{ $key }`, or describe the branch alone with `tool_link`

# Means: `coupling` names a joint that moves a joint of another branch.
# Matters: A coupling is modelled along one chain.
# Do: Remove the pair.
# Example: `coupling = [["left_1", "right_1"]]`
coupling-across-branches = joint `{ $by }` does not move the branch `{ $link }`, in which `{ $joint }` is coupled to it
    .hint = remove the pair from `coupling`: both joints must be on the way to each link

# Means: A key of robot.toml belongs to another robot model.
# Matters: It has no effect on this model.
# Do: Remove the key, or state the model to which it belongs.
# Example: `l11_mm` with `model = "serial"`
key-of-other-model = `{ $key }` has no effect on this model
    .hint = it belongs to `model = "{ $model }"`

# Means: [nominal] names a parameter that the robot model lacks.
# Matters: The value has no effect.
# Do: Use a parameter of the model.
# Example: `[nominal] s9 = 1.0`
nominal-unknown = [nominal] names `{ $parameter }`, which is not a parameter of this robot

# Means: A nominal length is zero or negative.
# Matters: The mirrored robot would explain the measurements equally well.
# Do: State the length as it is drawn.
# Example: `l11 = -230`
nominal-length-not-positive = the length `{ $parameter }` must be positive
    .hint = state the length as it is drawn

# Means: [nominal] lacks dimensions of the robot.
# Matters: The geometry is never guessed or taken from another machine.
# Do: State the geometry of your machine as it is drawn, in mm.
# Example: a five-bar robot without `l11`
nominal-missing = [nominal] does not state { $parameters }
    .hint = state the geometry of your machine as it is drawn, in mm: it is never guessed

# Means: A tolerance is zero, negative or not a number.
# Matters: A tolerance of zero would fix the parameter; a negative one has no meaning.
# Do: State the tolerance of the drawing, or hold the parameter with `hold`.
# Example: `tolerance = { a_2 = 0 }`
tolerance-not-positive = the tolerance `{ $parameter }` must be positive
    .hint = state the tolerance of the drawing

# Means: `tolerance` names a parameter that the robot model lacks.
# Matters: The tolerance has no effect.
# Do: Use a parameter of the model, or a kind of parameters (`length_mm`, `angle_deg`, `ratio`).
# Example: `tolerance = { a_99 = 1 }`
tolerance-unknown = `tolerance` names `{ $parameter }`, which is not a parameter of this robot

# Means: A selection of poses cannot be read.
# Matters: It is unknown which poses calibrate and which validate.
# Do: State names and ranges.
# Example: `calibration = "1-8, , 12"`
selection-empty = `{ $stated }` names no poses
    .expected = names and ranges like "1-8, 12, home", a list of them, "all", "rest" or "index mod 10 < 7"

# Means: A number of the file is infinite or not a number.
# Matters: Every result computed from it would be undefined.
# Do: State a finite number.
# Example: `expanded_uncertainty_um = nan`
not-a-measured-value = `{ $value }` is not a measured value
    .expected = a finite number

# Means: A key has a value of another kind: a text for a number, or a list of another length.
# Matters: The value cannot be read.
# Do: State a value of the expected kind.
# Example: `coverage_factor = "2"`
value-of-other-kind = { $element ->
        [yes] an element of `{ $key }`
       *[no] `{ $key }`
    } is { $found }

kind-of-value = { $kind ->
        [text] a text
        [date] a date without quotation marks
        [list] a list of { $length }
       *[table] a table
    }

# Means: A text is not one of the known choices.
# Matters: The value has no meaning for this key.
# Do: Use one of the expected texts.
# Example: `unit = "milimetre"`
unknown-variant = unknown value `{ $text }`

# Means: A required key is missing.
# Matters: The statement is incomplete, and its value is never guessed.
# Do: State the key.
# Example: a [[export]] without `unit`
key-missing = the key `{ $key }` is missing{ $has_section ->
        [yes] {" "}in `{ $section }`
       *[no] {""}
    }

state-unit = state `unit = "mm"`, or "m", "um" or "inch" as the file was written; it is never guessed

state-instrument = [instrument] states name, expanded_uncertainty_um and coverage_factor: take them from its calibration certificate

state-file = name the file, in the folder of the campaign

copy-keys = `etalon init FOLDER` writes a campaign with all keys to copy from

# Means: The file is not valid TOML, or a value has a form that its key refuses.
# Matters: The file cannot be read beyond this place.
# Do: Correct the line.
# Example: `name = "x` without the closing quotation mark
toml-invalid = { $reason }

# Means: A table has the same key twice.
# Matters: Usually the header of a table is missing before the second key.
# Do: Begin each table of a list with its header in double brackets.
# Example: two joints under one [[joint]]
table-key-twice = this table has this key twice{ $more ->
        [0] {""}
        [one] , and repeats 1 further key
       *[other] , and repeats { $more } further keys
    }
    .hint = begin each table of a list with its header in double brackets, like `[[joint]]`: is a header missing before this key?

# Means: A section has a key that etalon does not know.
# Matters: A misspelled key would have no effect.
# Do: Correct the name of the key, or move it to its section.
# Example: `coverage_facter = 2`
unknown-key = { $count ->
        [one] unknown key { $keys }
       *[other] unknown keys { $keys }
    }

key-belongs-at-top = `{ $key }` belongs at the top, before the first section

table-head-missing = is the header of their table missing, like `[section]` or `[[joint]]`?

key-remedy = { $key ->
        [station] stations of an instrument are a column `station` of a table of observations: state {"["}observations] instead of exports and log
       *[base_turn_y_deg] delete it: base_rx, base_ry and base_rz are a rotation vector, and no orientation of the base is singular
    }

# Means: The document element of the file is not <robot>.
# Matters: The file describes no robot.
# Do: Name a URDF file.
# Example: an SDF file
urdf-no-robot = the file is not a URDF
    .expected = the element <robot>

# Means: The file holds elements of xacro, the macro language of ROS.
# Matters: Links, joints and lengths of the robot are known only after the expansion, which etalon
# does not do.
# Do: Run the command of the hint where ROS is installed (`ros2 run xacro xacro` is the same command),
# with the arguments of the file as NAME:=VALUE, and name the resulting URDF.
# Example: `<xacro:arm prefix="left_"/>`
xacro-construct = `{ $construct }` of xacro is not expanded here
    .hint = expand the file, and name the URDF instead: { $command }

# Means: Two joints of a URDF have the same name.
# Matters: Logs and couplings name joints.
# Do: Rename one of them.
# Example: two `<joint name="q1">`
urdf-joint-twice = there are two joints `{ $joint }`
    .hint = rename one of them

# Means: A joint names a link that the file lacks.
# Matters: The chain is broken there.
# Do: Name a link of the file.
# Example: `<child link="link9"/>`
urdf-joint-link-unknown = joint `{ $joint }` names the link `{ $link }`, which the file does not have

# Means: A joint of a URDF has no parent or child.
# Matters: The chain is broken there.
# Do: Add the element.
# Example: a `<joint>` without `<child>`
urdf-joint-without-link = joint `{ $joint }` has no <{ $child } link="..."/>
    .hint = add the element

# Means: The lower limit of a joint is larger than the upper limit.
# Matters: The joint would have no position.
# Do: Exchange the limits.
# Example: `<limit lower="1" upper="-1"/>`
urdf-limits-exchanged = the limits of joint `{ $joint }` are exchanged: { $lower } to { $upper }
    .hint = exchange them

# Means: An angle of `rpy` exceeds a full turn.
# Matters: Angles of a URDF are in radians; the file is probably in degrees.
# Do: Convert the angles to radians.
# Example: `rpy="0 0 90"`
urdf-angles-beyond-turn = angles of `rpy` exceed a full turn
    .hint = angles of a URDF are in radians: 90 deg are 1.5707963267948966

# Means: An element of the URDF lacks an attribute.
# Matters: The robot is incompletely described.
# Do: Add the attribute.
# Example: `<joint type="revolute">` without `name`
urdf-attribute-missing = <{ $element }> has no `{ $attribute }`
    .hint = add the attribute

# Means: An attribute of the URDF holds something that is not a number.
# Matters: The value cannot be read.
# Do: Correct the value.
# Example: `xyz="0 0 x"`
urdf-not-number = `{ $attribute }`: `{ $word }` is not a number
    .hint = correct the value

# Means: An attribute of the URDF has too many or too few numbers.
# Matters: The value cannot be read.
# Do: State as many numbers as expected.
# Example: `xyz="0 0"`
urdf-number-count = `{ $attribute }` has { $count ->
        [one] 1 number
       *[other] { $count } numbers
    }
    .expected = { $expected_count ->
            [one] one number
           *[other] { $expected_count } numbers
        }

# Means: A campaign that `etalon init --from` proposed has a line that the files cannot complete.
# Matters: A unit or a target is never guessed.
# Do: Complete the line as its remark says; `check` lists all open lines at once.
# Example: `target = "?"`
key-open = `{ $key }` is incomplete
    .hint = complete the line{ $remark ->
        [none] {""}
       *[other] : { $remark }
    }

# Means: A campaign that `etalon init --from` proposed does not state the unit of the joints.
# Matters: Joint values read in a wrong unit give wrong poses.
# Do: Replace UNIT by deg, rad, mm or m.
# Example: `q1_UNIT = "J1"`
joint-unit-open = the unit of the joints is not stated
    .hint = replace UNIT by deg, rad, mm or m

# Means: A proposed campaign does not state the unit of the times of an export or a log.
# Matters: Points would be joined with joint values of another moment.
# Do: Replace `time_UNIT` by `time_s`, `time_ms`, `time_us` or `time_ns`.
# Example: `time_UNIT = "Timestamp"`
time-unit-open = the unit of the times is not stated
    .hint = replace `time_UNIT` by `time_s`, `time_ms`, `time_us` or `time_ns`

kind-expected = { $kind ->
        [text] a text
        [number] a number
        [whole] a whole number{ $limit ->
            [none] {""}
           *[other] {" "}from { $limit }
        }
        [list] a list{ $limit ->
            [none] {""}
           *[other] {" "}of { $limit }
        }
       *[table] a table
    }

alternatives = { $first ->
        [none] {""}
       *[other] { $first } or{" "}
    }{ $last }

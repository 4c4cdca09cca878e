### Messages of campaign. Above each message: its explanation (see CONTRIBUTING.md, "A message").

no-file-listed = the list of files is empty
# Means: A recording has `format` without `unit`, or `unit` without `format`.
# Matters: The files of a format contain no unit; a plain table gives its units in the header.
# Do: Give both keys for a file of a format, and neither key for a plain table.
# Example: `format = "polyworks"` without `unit`
recording-unit = `format` and `unit` of a recording belong together
    .hint = give both, or neither for a table time_s,x_mm,y_mm,z_mm, whose header gives the units

# Means: The folder has no campaign.toml, or the file does not exist.
# Matters: A command on a campaign starts from this file.
# Do: Check the path, or write a campaign with `etalon init`.
# Example: `etalon run nowhere`
campaign-missing = the campaign file `{ $file }` does not exist
    .hint = `etalon init FOLDER` writes one to start from

# Means: An export with `joints` is not delimited text with at most one row of names.
# Matters: Joint columns are found by their names in the header.
# Do: Set the delimiter and the header of the export, or read the joints from a [log].
# Example: `joints` for `format = "polyworks"`
joints-need-delimited-text = `joints` can be read from delimited text with at most one row of names
    .hint = set `format = {"{"} delimiter = .., header = 1, columns = .. {"}"}`; for other files read the joints in a [log]

# Means: Two exports of one file have different columns in `joints`.
# Matters: The joints of a row are the joints of all its points.
# Do: Copy `joints` from one [[export]] to the other.
# Example: `joints` with `J2` in one and `J3` in the other [[export]] of a file
joints-differ = two exports of `{ $file }` have different `joints`
    .hint = give the same columns in both

# Means: Joint values are given both in an export and in [log].
# Matters: It is undefined which values apply.
# Do: Remove `joints` from the export, or remove the section [log].
# Example: `joints` of an export in addition to a [log]
joints-twice = the joints are given twice: in `joints` of `{ $file }` and in [log]
    .hint = remove one of them

# Means: [join] joins an export with `joints` by another key than the row.
# Matters: The points and joints of this export are in the same row.
# Do: Set `by = "row"` in [join], or omit [join].
# Example: `by = "time"` for an export with `joints`
joints-joined-by-row = an export with `joints` is joined by its rows
    .hint = set `by = "row"` in [join], or omit [join]

# Means: A path begins with `$NAME/`, and this environment variable is not set.
# Matters: The file cannot be found.
# Do: Set the variable to the folder that contains the file, for example `export DATA=/path`.
# Example: `file = "$DATA/poses.txt"` without `DATA`
environment-missing = the environment variable `{ $name }` is not set
    .hint = set { $name } to the folder that contains `{ $file }`

# Means: The name of an export stands for a file for each pose, and no file has this form.
# Matters: Nothing was measured, or the files are elsewhere.
# Do: Measure the first pose, or correct `file`. A blank folder is in order before the first pose.
# Example: `file = "scans/{pose}.txt"` with an empty folder `scans`
export-files-missing = no file has the form `{ $file }`
    .hint = measure the first pose, or correct `file` of this [[export]]

# Means: A path leads out of the folder of the campaign.
# Matters: The folder of a campaign must be complete, so that it can be archived and run elsewhere.
# Do: Copy the file into the folder, or use a path that starts with `$NAME/`.
# Example: `file = "../poses.txt"`
path-outside = `{ $file }` is outside the folder of the campaign
    .expected = a path inside the campaign's folder, or one that starts with `$NAME/`

# Means: The campaign of a spatial robot gives no target.
# Matters: Each measured point is the position of a target on the robot.
# Do: List the targets in `targets` of [join], in `target` of the exports, or in a column `target`.
# Example: a serial arm without `targets`
no-target = a spatial robot needs at least one target
    .hint = give `target = "NAME"` for the table or the exports (option --target), a column `target` of the table, or `targets` in [join]

# Means: A target is called `base`.
# Matters: The parameters of the target have the same names as the parameters of the robot's base.
# Do: Change the labels of the export, or rename the target in `columns`.
# Example: a label `base_1_1` read as `{target}_{pose}_{cycle}`
target-called-base = a target must not be called `base`: its parameters would have the same names as parameters of the robot's base
    .hint = give the target another name in the label or in `columns`

# Means: A key that needs a positive number has zero, a negative number or NaN.
# Matters: No such quantity can be zero or negative.
# Do: Correct the value in the file.
# Example: `gear_ratio = 0`
key-not-positive = `{ $key }` must be positive
    .hint = correct the value

# Means: A joint of robot.toml lacks a key.
# Matters: The kinematics are incomplete.
# Do: Add the key to this [[joint]].
# Example: a [[joint]] without `a_mm`
joint-key-missing = the key `{ $key }` is missing in `joint`

direction-in-base = a direction in the base, for example { $example }

# Means: Two keys give the same quantity in different units or forms.
# Matters: It is undefined which of them applies.
# Do: Keep the key with the unit of your drawing, and remove the other.
# Example: `a_mm = 300` and `a_m = 0.3`
keys-state-the-same = { $keys } give the same quantity: remove one of them

# Means: robot.toml describes more or fewer than six legs of a hexapod.
# Matters: The kinematics of a hexapod need exactly six legs.
# Do: Write one [[leg]] for each of the six legs.
# Example: five [[leg]]
leg-count = a hexapod has six legs; the file describes { $count }
    .hint = add one [[leg]] with base_mm and platform_mm for each leg

# Means: At its home pose the platform can move while all legs keep their lengths.
# Matters: The leg lengths do not determine the pose there.
# Do: Check `base_mm` and `platform_mm` for wrong digits. If they are right, give another home pose.
# Example: six parallel legs
hexapod-singular = the hexapod is singular at its home pose: six leg lengths do not determine its pose there
    .hint = check `base_mm` and `platform_mm`, or give another home pose

# Means: robot.toml of a serial arm has no joints.
# Matters: There is nothing to identify.
# Do: Add one [[joint]] for each joint, from the base.
# Example: `model = "serial"` alone
no-joints = a serial arm needs its joints
    .hint = add one [[joint]] with alpha_deg, a_mm, theta_deg, d_mm for each joint, from the base

# Means: `gravity` is zero or not finite.
# Matters: Bending depends on the direction of gravity.
# Do: Give the direction in the base.
# Example: `gravity = [0, 0, 0]`
gravity-without-direction = `gravity` has no direction
    .expected = a direction in the base, for example [0, 0, -1]

# Means: A key of screw axes is given for Denavit-Hartenberg parameters.
# Matters: The key has no effect.
# Do: Set `convention = "poe"`, or remove the key.
# Example: `point_mm` in a [[joint]] with `a_mm`
not-denavit-hartenberg = `{ $key }` is not a Denavit-Hartenberg parameter
    .hint = it belongs to `convention = "poe"`

# Means: A twist or an offset of a joint is in another unit than its key says. Either the value is in
# degrees under a key of radians, or it is a quarter turn in radians under a key of degrees.
# Matters: All poses of the robot would be wrong.
# Do: Write the value with the key of its unit.
# Example: `alpha_deg = 1.5708`
joint-angle-unit = `{ $key }` = { FIXED($value, 4) } is { $unit ->
        [rad] more than two turns: the value is in degrees
       *[deg] a multiple of π/2: the value is in radians
    }
    .hint = write the value as `{ $other }`

# Means: Denavit-Hartenberg parameters or `parallel` are given for a screw axis.
# Matters: These keys have no effect.
# Do: Set `direction` and `point_mm`.
# Example: `a_mm` with `convention = "poe"`
not-screw-axis = a screw axis has neither Denavit-Hartenberg parameters nor `parallel`
    .hint = set `direction` and `point_mm`

# Means: The axis of a joint is zero or not finite.
# Matters: The joint has no motion.
# Do: Give the direction of the axis in the base.
# Example: `direction = [0, 0, 0]`
joint-axis-without-direction = the axis of the joint has no direction
    .expected = a direction in the base, for example [0, 0, 1]

# Means: Screw axes are given without the pose of the flange.
# Matters: The pose of the flange at zero joints is part of a product of exponentials.
# Do: Give the pose of the flange.
# Example: `convention = "poe"` without `flange_mm`
flange-missing = screw axes need the pose of the flange at zero joints: the key `{ $key }` is missing

# Means: The pose of a flange is given for Denavit-Hartenberg parameters.
# Matters: The last row of the table gives the flange, so the key has no effect.
# Do: Remove the key.
# Example: `flange_mm` with `a_mm`
flange-of-table = `{ $key }` has no effect on Denavit-Hartenberg parameters
    .hint = it belongs to `convention = "poe"`

# Means: The range of a joint is given with the key for the other kind of motion.
# Matters: Degrees and millimetres are mixed up.
# Do: Use `limits_deg` for a revolute joint and `travel_mm` for a prismatic joint.
# Example: `limits_deg` of a prismatic joint
range-of-other-motion = `{ $key }` is not a key of a { $motion ->
        [slides] prismatic joint
       *[turns] revolute joint
    }
    .hint = set `{ $own }`

# Means: The first limit of a range is not smaller than the second.
# Matters: No joint value is allowed.
# Do: Give the smaller limit first.
# Example: `limits_deg = [170, -170]`
range-exchanged = `{ $key }` is not a range: { $lower } to { $upper }
    .expected = the smaller limit, then the larger one

# Means: A key such as `coupling` or `harmonics` refers to a joint that does not exist, or refers to
# it twice.
# Matters: The effect cannot be assigned to a joint.
# Do: Use each joint once, by its number or by its name.
# Example: `harmonics = [8]` of a six-axis arm
joint-reference-wrong = { $fault ->
        [unknown-number] there is no joint { $joint }
        [unknown-name] there is no joint `{ $joint }`
        [slides] joint { $joint } is prismatic: it does not rotate
        [twice] joint { $joint } is listed twice
        [itself] joint { $joint } is coupled with itself: give its gain instead
       *[pair] the pair { $joint } is listed twice
    }
    .expected = joints from 1 to { $count }, each once
    .hint = the joints are { $joints }

# Means: A joint on the chain of a URDF has a type that etalon does not support.
# Matters: Each joint of a chain must have a single motion.
# Do: Replace the joint by fixed, revolute, continuous or prismatic joints.
# Example: `<joint type="planar">`
urdf-joint-kind = joint `{ $joint }` has the type { $kind }, which is not supported
    .expected = fixed, revolute, continuous or prismatic

# Means: The axis of a joint of a URDF is zero.
# Matters: The joint has no motion.
# Do: Write the axis of the joint in `<axis xyz="..."/>`.
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
# Do: Remove one of the joints, and describe the loop with `mimic`.
# Example: a parallelogram of four joints
urdf-two-parents = link `{ $link }` has two parents: `{ $first }` and `{ $second }`
    .hint = a URDF is a tree: describe loops with `mimic`

# Means: Joints of a URDF form a loop.
# Matters: A URDF is a tree; loops are closed by `mimic`.
# Do: Remove one joint from the loop. If its motion follows another joint, describe this motion with
# `mimic`.
# Example: a joint whose child is the base link
urdf-loop = the joints beyond link `{ $link }` form a loop
    .hint = a URDF is a tree: describe loops with `mimic`

# Means: The campaign refers to a link that the URDF does not contain.
# Matters: The base or the tool of the chain is unknown.
# Do: Correct the name; the message proposes similar names.
# Example: `tool_link = "tool9"`
urdf-link-unknown = `{ $file }` has no link `{ $link }`

# Means: No chain of joints leads from the base link to the tool link.
# Matters: The tool does not move with the robot.
# Do: Check `base_link` and `tool_link`: both must be on one tree of joints.
# Example: a base link of another robot in the same file
urdf-no-path = no joints lead from `{ $from }` to `{ $to }`
    .hint = check `base_link` and `tool_link`: no joint carries `{ $root }`

# Means: A joint mimics a joint that the file does not contain.
# Matters: The motion of the joint is unknown.
# Do: Correct the name of the joint in <mimic>.
# Example: `<mimic joint="q9"/>`
urdf-mimic-unknown = joint `{ $joint }` mimics `{ $mimics }`, which the file does not contain

# Means: A joint mimics itself.
# Matters: Its motion is undefined.
# Do: Write the name of another joint in <mimic>.
# Example: `<joint name="q1"><mimic joint="q1"/>`
urdf-mimics-itself = joint `{ $joint }` mimics itself
    .hint = write the name of another joint in <mimic>

# Means: A joint has several elements `mimic`. In a URDF, a joint can follow only one other joint.
# Matters: With only one of these elements, the kinematics are wrong.
# Do: Keep the element that applies. If several apply, remove all of them, and log the value of the
# joint.
# Example: a wrist whose angle is the sum of two motor angles
urdf-mimics-several = joint `{ $joint }` mimics several joints
    .hint = keep one `mimic`: a URDF joint follows one master. If `{ $joint }` depends on several joints of the chain, keep none. Then log the first master under its name, and give the factor of each further master in `coupling = [["{ $joint }", "..."]]` and [nominal]

# Means: All joints between base link and tool link are fixed.
# Matters: There is nothing to identify.
# Do: Compare `base_link` and `tool_link` with the links of the file: at least one joint between
# them must move.
# Example: `tool_link` on the base
urdf-nothing-moves = no joint moves between `{ $from }` and `{ $to }`
    .hint = check `base_link` and `tool_link`

# Means: All joints of the URDF are fixed.
# Matters: There is nothing to identify.
# Do: Give the URDF of a robot instead.
# Example: the URDF of a table
urdf-no-moving-joint = no joint of the file moves
    .hint = give the URDF of a robot

# Means: `bending` is given for a robot whose base link moves with joints.
# Matters: Bending needs a fixed direction of gravity.
# Do: Remove `bending`, or set `base_link` to a link that does not move.
# Example: an arm on a tilting column
bending-on-moving-base = `bending` needs a fixed direction of gravity, but joints move `{ $link }`
    .hint = remove `bending`, or set `base_link` to a link that does not move

# Means: `bending` is given for a joint, but no link beyond it has a mass.
# Matters: Without a mass, gravity does not bend the joint.
# Do: Add `<inertial>` with mass and centre of mass to the links beyond the joint.
# Example: a URDF without <inertial>
bending-without-mass = `bending` of joint `{ $joint }` needs a mass beyond it
    .hint = add <inertial> to its links

# Means: A target has the name of a joint, so that two parameters have the same name.
# Matters: The value of one parameter is taken for the other.
# Do: Give the target a name that no joint has.
# Example: a target `q1`
parameter-name-doubled = two parameters would be called `{ $name }`
    .hint = rename the target: a target must not have the name of a joint

# Means: robot.toml with `model = "urdf"` gives no link that carries the targets.
# Matters: The end of the chain is unknown.
# Do: Set `tool_link`, or write a [[branch]] for each link with targets.
# Example: robot.toml with `file` and `base_link` alone
tool-link-missing = no link carries the targets
    .hint = set `tool_link = "..."`, or a [[branch]] with `tool_link` and `targets` for each of several links

# Means: robot.toml has both `tool_link` and [[branch]].
# Matters: A target is on two links.
# Do: Use `tool_link` for a single link, or [[branch]] for several links.
# Example: `tool_link = "left_hand"` above a [[branch]]
tool-link-beside-branches = `tool_link` and [[branch]] both give the links of the targets
    .hint = remove `tool_link`, and write a [[branch]] with `targets` for its link

# Means: Two branches list the same target.
# Matters: Each target is on exactly one link.
# Do: Remove the target from `targets` of the wrong branch.
# Example: `targets = ["L1"]` in both branches
target-on-two-branches = target `{ $target }` is on two branches: `{ $first }` and `{ $second }`
    .hint = remove it from `targets` of one of them

# Means: No [[branch]] of robot.toml contains a target of the campaign.
# Matters: Its position on the robot is unknown.
# Do: Add the target to `targets` of the branch whose link carries it.
# Example: a target `L3` that no [[branch]] lists
target-on-no-branch = target `{ $target }` is on no branch
    .hint = add it to `targets` of the [[branch]] whose link carries it

# Means: `bending` contains a joint that carries several branches.
# Matters: The load of the joint depends on the joints and masses of all branches; the model of
# bending covers one chain only.
# Do: Remove the joint from `bending`.
# Example: `bending = ["torso"]` of a robot with two hands
bending-in-branches = `bending` of joint `{ $joint }` is not modelled: several branches load it
    .hint = remove the joint from `bending`

# Means: `payload` contains a joint of a robot with several branches.
# Matters: Each hand has its own payload, but a row contains only one.
# Do: Remove `payload`, or describe a single branch with `tool_link`.
# Example: `payload = ["torso"]` of a robot with two hands
payload-in-branches = `payload` of joint `{ $joint }` is not modelled: the robot has several branches
    .hint = remove `payload`, or describe a single branch with `tool_link`

# Means: `lateral` or `pedestal` is given for a robot with several branches.
# Matters: The masses of all branches bend the common joints and the base, but a row contains only
# one payload.
# Do: Remove the key, or describe a single branch with `tool_link`.
# Example: `pedestal = true` of a robot with two hands
elastic-in-branches = `{ $key }` is not modelled: the robot has several branches
    .hint = remove `{ $key }`, or describe a single branch with `tool_link`

# Means: `coupling` contains a pair of joints on different branches.
# Matters: A coupling is modelled within one chain only.
# Do: Remove this pair, or correct the names of its joints.
# Example: `coupling = [["left_1", "right_1"]]`
coupling-across-branches = joint `{ $by }` does not move the branch `{ $link }`, to which the coupled joint `{ $joint }` belongs
    .hint = remove the pair from `coupling`: both joints must be on one chain from the base to a link

# Means: A key of robot.toml belongs to another robot model.
# Matters: It has no effect on this model.
# Do: Remove the key, or set `model` to the model to which it belongs.
# Example: `l11_mm` with `model = "serial"`
key-of-other-model = `{ $key }` has no effect on this model
    .hint = it belongs to `model = "{ $model }"`

# Means: [nominal] contains a parameter that the robot model does not have.
# Matters: The value has no effect.
# Do: Correct the name; the message proposes similar names.
# Example: `[nominal] s9 = 1.0`
nominal-unknown = [nominal] contains `{ $parameter }`, which is not a parameter of this robot

# Means: A nominal length is zero or negative.
# Matters: The mirrored robot explains the measurements equally well.
# Do: Give the length of the drawing, without a sign.
# Example: `l11 = -230`
nominal-length-not-positive = the length `{ $parameter }` must be positive
    .hint = give the length of the drawing, without a sign

# Means: [nominal] lacks dimensions of the robot.
# Matters: etalon never guesses the geometry, and never takes it from another machine.
# Do: Copy the missing dimensions from the drawing of your machine, in mm.
# Example: a five-bar robot without `l11`
nominal-missing = [nominal] does not contain { $parameters }
    .hint = give the geometry of the drawing of your machine, in mm: it is never guessed

# Means: A tolerance is zero, negative or not a number.
# Matters: A tolerance of zero fixes the parameter; a negative one has no meaning.
# Do: Give the tolerance of the drawing. To fix the parameter, list it in `hold`.
# Example: `tolerance = { a_2 = 0 }`
tolerance-not-positive = the tolerance `{ $parameter }` must be positive
    .hint = give the tolerance of the drawing

# Means: `tolerance` contains a parameter that the robot model does not have.
# Matters: The tolerance has no effect.
# Do: Use a parameter of the model, or a kind of parameters (`length_mm`, `angle_deg`, `ratio`).
# Example: `tolerance = { a_99 = 1 }`
tolerance-unknown = `tolerance` contains `{ $parameter }`, which is not a parameter of this robot

# Means: A selection of poses cannot be read.
# Matters: It is unknown which poses calibrate and which validate.
# Do: Write names and ranges of poses, for example "1-8, 12, home".
# Example: `calibration = "1-8, , 12"`
selection-empty = `{ $stated }` selects no poses
    .expected = names and ranges like "1-8, 12, home", a list of them, "all", "rest" or "index mod 10 < 7"

# Means: A number of the file is infinite or not a number.
# Matters: Every result computed from it is undefined.
# Do: Replace the value by a finite number.
# Example: `expanded_uncertainty_um = nan`
not-a-measured-value = `{ $value }` is not a measured value
    .expected = a finite number

# Means: A key has a value of the wrong type: a text instead of a number, or a list of the wrong
# length.
# Matters: The value cannot be read.
# Do: Give a value of the expected type. Numbers have no quotation marks.
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
# Matters: The program does not know what this text means for the key.
# Do: Use one of the expected texts.
# Example: `unit = "milimetre"`
unknown-variant = unknown value `{ $text }`

# Means: A required key is missing.
# Matters: The value is never guessed, so the section cannot be used without it.
# Do: Add the key with your own value.
# Example: a [[export]] without `unit`
key-missing = the key `{ $key }` is missing{ $has_section ->
        [yes] {" "}in `{ $section }`
       *[no] {""}
    }

campaign-title = { $kind ->
        [calibration] Calibration of
        [geometry] Geometric calibration of
       *[test] Test of
    } { $robot }

campaign-title-dated = { $kind ->
        [calibration] Calibration of
        [geometry] Geometric calibration of
       *[test] Test of
    } { $robot }, { $date }

state-unit = set `unit = "mm"`, or "m", "um" or "inch" as the file was written; it is never guessed

state-instrument = [instrument] needs name, expanded_uncertainty_um and coverage_factor: take them from its calibration certificate

state-file = give the name of the file, in the folder of the campaign

copy-keys = `etalon init FOLDER` writes a campaign with all keys to copy from

# Means: The file is not valid TOML, or a value has a form that its key does not accept.
# Matters: The rest of the file cannot be read.
# Do: Correct the marked line.
# Example: `name = "x` without the closing quotation mark
toml-invalid = { $reason }

# Means: A table contains the same key twice.
# Matters: Usually the header of a table is missing before the second key.
# Do: Write the header of a list in double brackets, such as [[joint]], before each of its tables.
# Example: two joints under one [[joint]]
table-key-twice = this table has this key twice{ $more ->
        [0] {""}
        [one] , and repeats 1 further key
       *[other] , and repeats { $more } further keys
    }
    .hint = begin each table of a list with its header in double brackets, such as `[[joint]]`: is a header missing before this key?

# Means: A section contains a key that etalon does not know.
# Matters: A misspelled key has no effect.
# Do: Correct the name of the key, or move it to its section.
# Example: `coverage_facter = 2`
unknown-key = { $count ->
        [one] unknown key { $keys }
       *[other] unknown keys { $keys }
    }

key-belongs-at-top = `{ $key }` belongs at the top, before the first section

table-head-missing = is the header of their table missing, like `[section]` or `[[joint]]`?

key-remedy = { $key ->
        [station] give the stations of an instrument in a column `station` of a table of observations: use {"["}observations] instead of exports and log
       *[base_turn_y_deg] remove it: base_rx, base_ry and base_rz are a rotation vector, which is not singular at any orientation of the base
    }

# Means: The root element of the file is not <robot>.
# Matters: The file is not a description of a robot.
# Do: Give a URDF file. Other formats (SDF, MJCF) must be converted first.
# Example: an SDF file
urdf-no-robot = the file is not a URDF
    .expected = the element <robot>

# Means: The file contains elements of xacro, the macro language of ROS. etalon does not expand
# them.
# Matters: Links, joints and lengths of the robot are known only after the expansion.
# Do: Run the command of the hint on a machine with ROS, or `ros2 run xacro xacro` with the same
# arguments. Add the arguments of the file as NAME:=VALUE. Then use the resulting URDF.
# Example: `<xacro:arm prefix="left_"/>`
xacro-construct = the xacro element `{ $construct }` is not supported
    .hint = expand the file, and use the resulting URDF: { $command }

# Means: Two joints of a URDF have the same name.
# Matters: Logs and couplings refer to joints by their names.
# Do: Rename one of the joints, in the URDF and in the log.
# Example: two `<joint name="q1">`
urdf-joint-twice = there are two joints `{ $joint }`
    .hint = rename one of the joints

# Means: A joint refers to a link that the file does not contain.
# Matters: The chain is broken there.
# Do: Correct the name of the link, or add the link.
# Example: `<child link="link9"/>`
urdf-joint-link-unknown = joint `{ $joint }` refers to the link `{ $link }`, which the file does not contain

# Means: A joint of a URDF has no parent or child.
# Matters: The chain is broken there.
# Do: Add the element <parent> or <child> to the joint.
# Example: a `<joint>` without `<child>`
urdf-joint-without-link = joint `{ $joint }` has no <{ $child } link="..."/>
    .hint = add the element

# Means: The lower limit of a joint is larger than the upper limit.
# Matters: No joint value is allowed.
# Do: Swap the two limits, or correct their signs.
# Example: `<limit lower="1" upper="-1"/>`
urdf-limits-exchanged = the lower limit of joint `{ $joint }` is larger than the upper limit: { $lower } to { $upper }
    .hint = swap the two limits

# Means: An angle of `rpy` exceeds a full turn.
# Matters: Angles of a URDF are in radians; the file is probably in degrees.
# Do: Convert the angles to radians.
# Example: `rpy="0 0 90"`
urdf-angles-beyond-turn = angles of `rpy` exceed a full turn
    .hint = angles of a URDF are in radians: 90 deg are 1.5707963267948966

# Means: An element of the URDF lacks an attribute.
# Matters: The description of the robot is incomplete.
# Do: Add the attribute to the element.
# Example: `<joint type="revolute">` without `name`
urdf-attribute-missing = <{ $element }> has no `{ $attribute }`
    .hint = add the attribute

# Means: An attribute of the URDF contains something that is not a number.
# Matters: The value cannot be read.
# Do: Write a number with a decimal point.
# Example: `xyz="0 0 x"`
urdf-not-number = `{ $attribute }`: `{ $word }` is not a number
    .hint = correct the value

# Means: An attribute of the URDF has too many or too few numbers.
# Matters: The value cannot be read.
# Do: Write as many numbers as the message expects, separated by blanks.
# Example: `xyz="0 0"`
urdf-number-count = `{ $attribute }` has { $count ->
        [one] 1 number
       *[other] { $count } numbers
    }
    .expected = { $expected_count ->
            [one] one number
           *[other] { $expected_count } numbers
        }

# Means: A campaign that `etalon init --from` proposed contains a line that you must complete: the
# files do not give this value.
# Matters: A unit or a target is never guessed.
# Do: Complete the line as its remark says; `check` lists all open lines at once.
# Example: `target = "?"`
key-open = `{ $key }` is incomplete
    .hint = complete the line{ $remark ->
        [none] {""}
       *[other] : { $remark }
    }

# Means: A campaign that `etalon init --from` proposed does not give the unit of the joints.
# Matters: Joint values read in a wrong unit give wrong poses.
# Do: Replace UNIT in the key with deg, rad, mm or m: `q1_deg = "J1"`.
# Example: `q1_UNIT = "J1"`
joint-unit-open = the unit of the joints is not given
    .hint = replace UNIT with deg, rad, mm or m

# Means: A proposed campaign does not give the unit of measured rotations.
# Matters: Orientations read in a wrong unit give wrong tools and wrong angles.
# Do: Replace `rx_UNIT` with `rx_deg` or `rx_rad`, and the other two names as well.
# Example: `columns = ["x", "y", "z", "rx_UNIT", "ry_UNIT", "rz_UNIT"]`
angle-unit-open = the unit of the measured rotations is not given
    .hint = replace UNIT in `rx_UNIT`, `ry_UNIT` and `rz_UNIT` with deg or rad

# Means: A proposed campaign does not give the unit of the times of an export or a log.
# Matters: Points would be joined with joint values of another moment.
# Do: Replace `time_UNIT` with `time_s`, `time_ms`, `time_us` or `time_ns`.
# Example: `time_UNIT = "Timestamp"`
time-unit-open = the unit of the times is not given
    .hint = replace `time_UNIT` with `time_s`, `time_ms`, `time_us` or `time_ns`

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

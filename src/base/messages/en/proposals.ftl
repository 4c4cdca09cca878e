### Proposals for reading a file: contents of columns, evidence, doubts and questions.

ask-anchor = the point from which the distance is measured: `other` in `constants`
ask-angle-unit = the unit of the angles: `angle_unit` in `format`
ask-blocks = which target and pose each of the { $count } blocks is: the headings stand above its rows again, the second time in line { $line }
ask-computed-by-controller = whether an instrument measured `{ $body }`, as proposed: the headings of the joints have the same words, so the controller may have computed it; other coordinates are { $others }
ask-direction = per_count: -1 if the log counts against the joint, as the points show; 1 if robot.toml has to be corrected
ask-direction-of-columns = { $columns }, as the points show; without `-1 *` if robot.toml has to be corrected
ask-joint-states = which joint of the robot each column is; JointState contains rad for revolute joints and m for prismatic joints: write `q1_m` for a prismatic joint
ask-joints = which joint each column is, and its unit
ask-joints-again = which joints belong to the robot: their headings occur { $count } times. The proposal uses the first, { $names }
ask-joints-of-format = which joint each column is, and its unit if it is unknown
ask-log-of-format = whether it is { $what } (`[log]` with `format = "{ $format }"`)
ask-numbers-without-headings = which of the { $count } numbers of a row are joints, and which are the measured point: the file has no headings. `--robot` finds the joints and the point by the kinematics
ask-number-with-gaps = whether { $column } is the number of the pose, as proposed: it increases from { $before } to { $after }, so it is not the number of the row
ask-order-of-columns = whether the columns are x, y, z in this order, or angles and distances
ask-other-arrays = which array contains the measurement: the proposal uses `{ $used }`. As many columns have { $others }{ $more ->
        [0] {""}
       *[other] {" "}and { $more } more
    }
ask-points-in-row = whether the { $numbers } numbers of a row are { $count } points with three coordinates each, as proposed: the file has no names for them
ask-quaternion-order = which of { $columns } is the scalar of the quaternion; the proposal uses the { $used ->
        [last] last
       *[first] first
    }
ask-recorded-motion = whether it is a recorded motion, as proposed, or points with times (then [[export]])
ask-rotation = whether the three numbers are a rotation vector or angles, and the order of the rotations
ask-sets-alike = what columns { $first } and columns { $second } are: their headings or values are nearly equal. They may be two targets, or commanded and measured coordinates
ask-sign-of-difference = whether the difference is commanded minus measured, as proposed, or measured minus commanded (then `+`)
ask-targets-of-topics = which target each topic of poses or points is
ask-text-in-all-rows = whether `{ $text }`, the same text in all rows, is the target, as proposed, or a code
ask-time-unit = the unit of the times in { $column }: the step is { $step }
ask-two-frames = whether `{ $first }` and `{ $second }` are two targets, or one point in two frames: the distances from row to row agree. `etalon cell` finds the relation of two frames
ask-unit = the unit of lengths
ask-unit-of-size = the unit of lengths: the largest length is { $largest }; for a robot, { $units ->
        [inch-or-mm] inch or mm is plausible
       *[other] { $units } is plausible
    }
because-arrays = it contains arrays of { $format }
because-arrays-of-numbers = it contains these arrays of numbers: { $arrays }
because-columns = { $read } of { $rows } rows contain numbers, in { $columns ->
        [one] 1 column
       *[other] { $columns } columns
    }
because-columns-of = it has the columns of { $what }
because-comments = lines that begin with `{ $comment }` are comments
because-decimal-marks = { $fractions } of { $numbers } numbers have the decimal mark `{ $mark }`
because-end = the last row is the word `{ $end }`
because-fields = { $read } of { $rows } rows have { $fields } fields separated by `{ $delimiter }`
because-it-is = it is { $what }
because-joints-named = the names of the joints are the names of the robot's joints
because-line = line { $line } { $is ->
        [header] contains the names of the columns
       *[last] is the last line before the data
    }
because-log = a log: { $reason }
because-numbers = each row has { $count } numbers, and no three of them form a unit vector
because-recording = it is a recording of ROS 2: { $storage ->
        [db3] a SQLite database with topics
       *[mcap] it begins like an MCAP file
    }
because-sampled = the values of the first { $rows } rows were examined; the file has more
because-columns-sampled = the first { $columns } of { $width } columns were examined
because-several-points = the headings describe { $count } measured points in each row: each is an [[export]] of the file
because-test-of-poses = a test to ISO 9283: poses that were attained in several cycles, and each of these poses once
because-topic = topic `{ $topic }` has { $count ->
        [one] 1 message
       *[other] { $count } messages
    } of type { $message_type }
because-unit-stated = line { $line } gives the unit: { $how }
doubt-all-commanded = according to their headings, all coordinates are commanded: the file contains no measured coordinates
doubt-bare-metre = the headings end in `_m`: metres, or "measured"
doubt-columns-not-read = numbers that are not read: columns { $columns }{ $more ->
        [0] {""}
       *[other] {" "}and { $more } more
    }
doubt-computed-by-controller = the proposal uses `{ $used }`. The headings of `{ $body }` have the words of the joints, so the controller computed it
doubt-controller-pose = coordinates of `{ $body }` may be computed by the controller; only an instrument measures a target
doubt-coordinates-left = coordinates of { $left } are not used: other headings are more likely
doubt-dates = in dates with `/`, it is unknown whether day or month comes first: they are not read
doubt-decimal-mark = no number has a decimal mark: `{ $mark }` is assumed
doubt-direction-length = the direction is not a unit vector in all rows
doubt-encoding = the file is not UTF-8 and is read as { $encoding }: check its special letters (°, µ, umlauts)
doubt-first-increases = column 1 increases in all rows: it is a time or a coordinate
doubt-four-joints = the headings could also be four joints q0 to q3
doubt-in-line = line { $line }: { $problem }
doubt-groups-alone = line { $line } names groups of columns: three columns of a group are taken as x, y, z
doubt-joints-without-headings = { $count } numbers without headings: they are joints, or coordinates and angles
doubt-matrix-order = a matrix without headings: the proposal reads it row by row, as the rotation from the body to the world
doubt-more-problems = and { $count ->
        [one] 1 more problem
       *[other] { $count } more problems
    } of the same kind
doubt-one-row = one row of { $count } numbers without headings: a program wrote an array in one line, and the file does not show how to divide it
doubt-order-of-joints = the joints have no order in the file: the proposal uses the order of their numbers, or of the parts of an arm
doubt-orientation-of-body = the proposal uses the orientation `{ $body }` for the measured point, although its headings name another body
doubt-origin = line { $line } is 0 0 0: it counts as "not measured" unless you set `missing`
doubt-other-reading = { $reading }, { $columns ->
        [one] 1 column
       *[other] { $columns } columns
    } is equally possible: compare a row with the file
doubt-other-sheets = the workbook has { $count ->
        [one] 1 more sheet
       *[other] { $count } more sheets
    }: { $sheets }
doubt-polar = there are an azimuth and a distance, but no zenith angle or elevation
doubt-pose-of-robot = `{ $body }` is a pose of the robot in the same rows: `etalon cell --solve { $solve }` finds its relation to the measurement
doubt-quaternion-length = the norm of the quaternion is not 1 in all rows
doubt-quaternion-order = a quaternion without headings: the scalar is last, as in ROS, or first
doubt-rows-not-read = { $count ->
        [one] 1 row
       *[other] { $count } rows
    } cannot be read in this way; the first is line { $line }
doubt-rows-refused = line { $line }: { $reason }, and { $more } more
doubt-scanned = the proposal reads the numbers after x, y, z as intensity and colour: whole numbers up to 255
doubt-second-log = topic `{ $topic }` also contains joint values
doubt-sets-by-difference = columns { $difference } are the difference between columns { $measured } and { $commanded } in all rows: the proposal reads it as measured minus commanded
doubt-several-logs = { $count } logs: { $first } identifies the robot, and the others are compared with it. If several files are one recording, join them into one file
doubt-summary = sheet `{ $sheet }` is left out: the other sheets contain all its rows
doubt-sign-of-difference = the sign of the difference is not given: compare a row with the measurement
doubt-six-without-headings = six numbers without headings: a position and three angles, or six joints of which three are prismatic
doubt-stationary-points = the proposal treats its { $count } points as points that do not move. Their names could be poses, but another file has { $poses } poses
doubt-thousands-mark = three digits follow each `{ $mark }`: it may be a thousands mark
doubt-time-decreases = { $column } has the name of a time but decreases
doubt-topic-unreadable = topic `{ $topic }` cannot be read: { $reason }
doubt-two-families = { $names } could also be joints; the proposal uses `{ $kept }`
doubt-units-differ = the file contains two units: { $unit } (line { $line }) and { $of_second } (line { $second })
doubt-transposed = { $rows } rows of { $columns } numbers: rows and columns may be exchanged. Write one row per pose or time
doubt-unnamed-joints = the proposal uses { $names } as joints: no other quantity is possible, but the file does not say so
doubt-vertical-angle = { $column } is a vertical angle: its values fit { $zenith ->
        [yes] a zenith angle
       *[no] an elevation
    }, but the heading does not say which
doubt-words-of-header = line { $line } has { $words } words for { $columns } columns: their order is unknown
is-aqdef = a file in the Q-DAS ASCII transfer format, by its first field
is-attained-poses = attained poses of a test to ISO 9283
is-calypso = a table of Zeiss Calypso, by its header
is-commanded-poses = commanded poses, or candidates for `etalon plan`
is-compliance-test = a test of static compliance
is-dmis = DMIS output, by its first record
is-drilled-plate = a table of drilled holes in columns of fixed width, by its header
is-galil-arrays = an upload of Galil arrays: only whole numbers, under names in alphabetical order
is-geopak-scan = a scan of GEOPAK-Win, by its first record
is-kuka-rsi = a recording of KUKA RSI: its header names the counter `IPOC`
is-leica-at960 = an export of a Leica AT960 or AT930 in six degrees of freedom, by its header
is-leica-emscon = a list of stationary points measured through Leica's emScon interface, by its header
is-observations = a table of observations
is-pcdmis-report = a report of PC-DMIS with a block for each dimension, by its heading `AX`
is-stl = an STL file, by its triangles
is-pcd = a PCD file, by the lines FIELDS and DATA
is-e57 = an E57 file of a scanner, by its first bytes
is-c3d = a C3D file of motion capture, by its first bytes
is-fanuc-ls = a program of a FANUC controller, by its first line
is-abb-rapid = a module of ABB RAPID, by MODULE and ENDMODULE
is-ptx = a PTX scan, by its head of ten lines
is-leica-gsi = a file of Leica GSI, by the words of its lines
is-pcdmis = an .xyz file of PC-DMIS, by its first line
is-ply = a PLY file, by its first line
is-polyworks-project = a project description of PolyWorks|Inspector, by its first line
is-polyworks-report = a report of PolyWorks with a row for each control, by its header
is-qif = a QIF document
is-recorded-motion = a recorded motion
is-reference-targets = reference targets that are measured repeatedly
is-ros-messages = ROS messages, with the header that `rostopic echo -p` writes
is-spatialanalyzer = a SpatialAnalyzer export of points, by its comments
is-twincat = an export of Beckhoff TwinCAT 3 Scope: its head contains the start of the export
is-ur-rtde = a recording of Universal Robots RTDE: its header contains RTDE's names of joint positions
is-vda-fs = a VDA-FS file, by its header
means-appearance = intensity or colour
means-azimuth = azimuth
means-clock = date and time of day
means-commanded = commanded { $axis }
means-count = a running number
means-cycle = number of the repeat
means-day = date
means-deleted = mark of deleted rows
means-difference = difference of { $axis }
means-direction = direction { $component }
means-distance = distance
means-elevation = elevation
means-expanded-uncertainty = expanded uncertainty of { $axis }
means-joint = joint { $number }
means-label = label of the point
means-matrix = rotation matrix r{ $row }{ $column }
means-matrix-end = last row of a 4x4 matrix
means-measured = measured { $axis }
means-measured-of-point = measured { $axis } of point { $number }
means-motion = velocity, force or current
means-other-joint = commanded joint
means-other-orientation = { $component } of the orientation of another body
means-pose = name of the pose
means-quaternion = quaternion { $component }
means-rotation = rotation, number { $number } of three
means-target = name of the target
means-scatter = uncertainty or scatter of the whole point
means-temperature = temperature
means-text = a text that is not read
means-time = time
means-time-of-day = time of day
means-uncertainty = standard uncertainty, number { $number }
means-unknown = not known
means-zenith = zenith angle
names-of-columns = { $said }: { $names }
says-commanded-and-difference = the header contains a commanded point and its difference
says-joints = the header contains joints
says-joints-and-length = joints and one length in each row
says-joints-beside = the header contains joints and points
says-orientations = the header contains orientations
why-ambiguous-dates = dates in which day and month could be swapped
why-as-many-as-joints = each row has as many numbers as an arm has joints, and no three of them form a unit vector
why-axes-differ = the headings of three columns differ only in x, y, z
why-behind-lengths = they follow three lengths that are larger than any angle
why-colours = whole numbers up to 255 after a point
why-commanded-heading = its heading means a commanded value
why-commanded-rotation = its heading means a commanded rotation
why-constant = the same whole number in all rows
why-counts = whole numbers that increase by 1
why-counts-first = whole numbers that increase row by row, first in the row
why-counts-with-gaps = whole numbers that increase, with gaps
why-numbers-rows = its heading means a number, and each row has another one
why-vertical = a vertical angle by its heading, beside azimuth and distance
why-dates = every cell is a date or a time of day
why-difference-heading = its heading means a difference
why-empty = it is empty
why-epoch = { $why }; its size is the number of { $unit } since 1970
why-fits-without = the kinematics of the nominal robot agree without it
why-four-of-length-one = the four numbers have norm 1 in all rows
why-heading = its heading
why-heading-and-four = its heading, and the four numbers have norm 1 in all rows
why-heading-and-three = its heading, and the three numbers have norm 1 in all rows
why-heading-increases = its heading; it increases in all rows
why-heading-ordered = its heading; it never decreases
why-heading-unordered = its heading, although it does not increase
why-in-unit = { $why }, in { $unit }
why-increases = only this column increases in all rows
why-kinematics-fit = the kinematics of the nominal robot agree with it in { $unit }{ $way ->
        [reversed] , in the opposite direction
       *[forward] {""}
    }
why-last-of-matrix = last column of a 4x4 matrix whose rotation is orthonormal
why-measured-heading = its heading means a measured value
why-nine-orthonormal = the nine numbers form an orthonormal matrix in all rows
why-names-of-points = the names of points that do not move with the robot
why-nothing-known = its heading is unknown
why-orthonormal = orthonormal in all rows, row by row
why-other-arm = its heading occurs again
why-other-body = its heading means another body than the measured point
why-other-family = the proposal takes the joints from the columns `{ $kept }`
why-others-measured = its heading means a commanded value, and there are measured ones
why-place = its position in the row: there are no names of columns
why-quaternion-not-joints = the four numbers have norm 1 in all rows: a quaternion, scalar first, not joints
why-range-of-deg = its heading, and its range from { $low } to { $high }: more than a turn in rad, so it is deg or mm
why-range-of-rad = its heading, and its range from { $low } to { $high }: it is rad or m
why-repeats-as-texts = its heading means repeats, and its cells are texts
why-robot-computes = the nominal robot computes it to the last digit
why-robot-reproduces = the nominal robot reproduces the three columns
why-row-0001 = the row 0 0 0 1
why-targets-fit = the nominal robot agrees if each of its values is a separate target
why-text-before = a text before the numbers
why-text-behind = a text after numbers
why-text-in-all-rows = the same text in all rows, before the numbers
why-texts-differ = texts that differ from row to row, before the numbers
why-three-of-length-one = the three numbers have norm 1 in all rows
why-whole-before-decimals = whole numbers before numbers with a decimal mark

### Proposals for reading a file: contents of columns, evidence, doubts and questions.

ask-anchor = the point from which the distance is measured: `other` in `constants`
ask-angle-unit = the unit of the angles: `angle_unit` in `format`
ask-joint-states = which joint of the robot each column is; JointState has rad for revolute joints, m for prismatic ones: write `q1_m` for a prismatic joint
ask-joints = which joint each column is, and its unit
ask-joints-of-format = which joint each column is, and its unit where it is not known
ask-log-of-format = whether it is { $what } (`[log]` with `format = "{ $format }"`)
ask-number-with-gaps = whether { $column } is the number of the pose, as proposed: it goes from { $before } to { $after }, so the number of the row is another
ask-order-of-columns = whether the columns are x, y, z in this order, or angles and distances
ask-points-in-row = whether the { $numbers } numbers of a row are { $count } points of three coordinates each, as proposed: nothing names them
ask-quaternion-order = which of { $columns } is the scalar of the quaternion: the first is taken
ask-recorded-motion = whether it is a recorded motion, as proposed, or points with times (then [[export]])
ask-rotation = whether the three are a rotation vector, or angles and in which order they turn
ask-seconds = whether `{ $name }` is in seconds (`time_ms`, `time_ns` otherwise)
ask-sets-alike = what columns { $first } and columns { $second } are: their headings are equal, or their values nearly equal: two targets, or commanded and measured coordinates
ask-sign-of-difference = whether the difference is commanded minus measured, as proposed, or measured minus commanded (then `+`)
ask-targets-of-topics = which target each topic of poses or points is
ask-time-unit = the unit of the times in { $column }: the step is { $step }
ask-unit = the unit of lengths
ask-unit-of-size = the unit of lengths: the largest is { $largest }, so { $units ->
        [inch-or-mm] inch or mm fits
       *[other] { $units } fits
    } a robot
because-arrays = it holds arrays of { $format }
because-arrays-of-numbers = its arrays of numbers are { $arrays }
because-columns = { $read } of { $rows } rows have numbers, in { $columns ->
        [one] 1 column
       *[other] { $columns } columns
    }
because-columns-of = its columns are those of { $what }
because-comments = lines that start with `{ $comment }` are comments
because-decimal-marks = { $fractions } of { $numbers } numbers have the decimal mark `{ $mark }`
because-end = the last row is the word `{ $end }`
because-fields = { $read } of { $rows } rows have { $fields } fields separated by `{ $delimiter }`
because-it-is = it is { $what }
because-joints-named = the joints have the names of the robot's joints
because-line = line { $line } { $is ->
        [header] names the columns
       *[last] is the last before the data
    }
because-log = a log: { $reason }
because-numbers = each row has { $count } numbers, and no three of them form a unit vector
because-recording = it is a recording of ROS 2: { $storage ->
        [db3] a SQLite database with topics
       *[mcap] it begins like an MCAP file
    }
because-sampled = the values of the first { $rows } rows were examined; the file has more
because-columns-sampled = the first { $columns } of { $width } columns were examined
because-several-points = the headings name { $count } measured points in each row: each is an [[export]] of the file
because-topic = topic `{ $topic }` has { $count ->
        [one] 1 message
       *[other] { $count } messages
    } of type { $message_type }
because-unit-stated = line { $line } gives the unit: { $how }
doubt-all-commanded = the headings of all coordinates say commanded: the file contains no measured coordinates
doubt-bare-metre = the headings end in `_m`: metres, or "measured"
doubt-columns-not-read = numbers that are not read: column { $columns }{ $more ->
        [0] {""}
       *[other] {" "}and { $more } more
    }
doubt-controller-pose = coordinates of `{ $body }` may be what the controller computes: an instrument measures a target
doubt-coordinates-left = coordinates of { $left } are not taken: others have a heading that is closer
doubt-dates = dates with `/` do not give whether the day or the month is first: they are not read
doubt-decimal-mark = no number has a decimal mark: `{ $mark }` is assumed
doubt-direction-length = the direction is not a unit vector in all rows
doubt-encoding = the file is not UTF-8 and is read as { $encoding }: check that its letters (°, µ, umlauts) are right
doubt-first-increases = column 1 increases in all rows: a time, or a coordinate
doubt-four-joints = four joints q0 to q3 would have the same headings
doubt-in-line = line { $line }: { $problem }
doubt-joints-without-headings = { $count } numbers without headings: joints, or coordinates and angles
doubt-matrix-order = a matrix without headings: row by row, turning vectors of the body to the world
doubt-more-problems = and { $count ->
        [one] 1 more problem
       *[other] { $count } more problems
    } like that
doubt-one-row = one row of { $count } numbers without headings: a program wrote an array in one line, and nothing shows how it is divided
doubt-order-of-joints = the joints are in no order in the file: they are taken in the order of their numbers
doubt-orientation-of-body = the orientation `{ $body }` is taken for that of the measured point: its headings name another body
doubt-origin = line { $line } is 0 0 0: taken as "not measured" unless `missing` gives otherwise
doubt-other-reading = { $reading }, { $columns ->
        [one] 1 column
       *[other] { $columns } columns
    } explains it as well: check a row by eye
doubt-other-sheets = the workbook has { $count ->
        [one] 1 sheet
       *[other] { $count } sheets
    } more: { $sheets }
doubt-points-without-headings = { $count } numbers without headings: the first three are taken; several points in a row are several [[export]] with columns by number
doubt-polar = an azimuth and a distance, and no zenith angle or elevation beside them
doubt-quaternion-length = the norm of the quaternion is not 1 in all rows
doubt-quaternion-order = a quaternion without headings: scalar last, as ROS writes it, or scalar first
doubt-rows-not-read = { $count ->
        [one] 1 row
       *[other] { $count } rows
    } not read this way, the first is line { $line }
doubt-rows-refused = line { $line }: { $reason }, and { $more } more
doubt-scanned = the numbers behind x, y, z are taken for intensity and colour: whole numbers up to 255
doubt-second-log = topic `{ $topic }` has joint values too
doubt-sets-by-difference = columns { $difference } are the difference of columns { $measured } and { $commanded } in all rows: taken for measured minus commanded
doubt-several-logs = { $count } logs: { $first } identifies the robot, the others are compared with it; rows of one recording in several files belong into one file
doubt-sign-of-difference = the sign of the difference is not given: compare a row with the measurement
doubt-six-without-headings = six numbers without headings: a position and three angles, or six joints, three of them prismatic
doubt-stationary-points = its { $count } points are taken for points that do not move: their names could be poses, but another file has { $poses } poses
doubt-thousands-mark = every `{ $mark }` is before three digits: it may be a thousands mark
doubt-time-decreases = { $column } is called a time and decreases
doubt-topic-unreadable = topic `{ $topic }` cannot be read: { $reason }
doubt-two-families = { $names } could be joints as well: `{ $kept }` is used
doubt-units-differ = the file gives { $unit } (line { $line }) and { $of_second } (line { $second })
doubt-unnamed-joints = { $names } are taken as joints: no other quantity fits, but the file does not name them
doubt-words-of-header = line { $line } has { $words } words for { $columns } columns: their order is not known
is-aqdef = a file in the Q-DAS ASCII transfer format, by its first field
is-attained-poses = attained poses of a test to ISO 9283
is-calypso = a table of Zeiss Calypso, by its header
is-commanded-poses = commanded poses, or of candidates for `etalon plan`
is-compliance-test = a test of static compliance
is-dmis = DMIS output, by its first record
is-drilled-plate = a table of drilled holes in columns of fixed width, by its header
is-galil-arrays = an upload of Galil arrays: whole numbers alone, under names in alphabetical order
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
is-reference-targets = reference targets that are measured from time to time
is-ros-messages = messages of ROS: its header is that of `rostopic echo -p`
is-spatialanalyzer = a SpatialAnalyzer export of points, by its comments
is-twincat = an export of Beckhoff TwinCAT 3 Scope: its head gives the start of the export
is-ur-rtde = a recording of Universal Robots RTDE: its header has RTDE's names of joint positions
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
means-other-orientation = quaternion { $component } of another body
means-pose = name of the pose
means-quaternion = quaternion { $component }
means-rotation = rotation, number { $number } of three
means-target = name of the target
means-temperature = temperature
means-text = a text that nothing reads
means-time = time
means-time-of-day = time of day
means-uncertainty = standard uncertainty, number { $number }
means-unknown = not known
means-zenith = zenith angle
names-of-columns = { $said }: { $names }
says-commanded-and-difference = the header names a commanded point and its difference
says-joints = the header names joints
says-joints-and-length = joints and one length in each row
says-joints-beside = the header names joints beside the points
says-orientations = the header names orientations
why-ambiguous-dates = dates whose day and month could be exchanged
why-as-many-as-joints = each row has as many numbers as an arm has joints, and no three of them form a unit vector
why-axes-differ = the headings of three columns differ in x, y, z alone
why-behind-lengths = behind three lengths that are larger than any angle
why-colours = whole numbers behind a point, up to 255
why-commanded-heading = its heading gives a commanded value
why-commanded-rotation = its heading gives a commanded rotation
why-constant = the same whole number in all rows
why-counts = whole numbers that increase by 1
why-counts-first = whole numbers that increase row by row, first in the row
why-counts-with-gaps = whole numbers that increase, with gaps
why-dates = every cell is a date or a time of day
why-difference-heading = its heading gives a difference
why-empty = it is empty
why-epoch = { $why }; { $unit } since 1970 by its size
why-fits-without = the nominal robot fits without it
why-four-of-length-one = the four numbers have norm 1 in all rows
why-heading = its heading
why-heading-and-four = its heading, and the four numbers have norm 1 in all rows
why-heading-and-three = its heading, and the three numbers have norm 1 in all rows
why-heading-increases = its heading; it increases in all rows
why-heading-ordered = its heading; it never decreases
why-heading-unordered = its heading, though it does not increase
why-in-unit = { $why }, in { $unit }
why-increases = it increases in all rows, and the others do not
why-kinematics-fit = the kinematics of the nominal robot fit with it in { $unit }{ $way ->
        [reversed] , which counts in the opposite direction
       *[forward] {""}
    }
why-last-of-matrix = last column of a 4x4 matrix whose rotation is orthonormal
why-measured-heading = its heading gives a measured value
why-nine-orthonormal = the nine numbers form an orthonormal matrix in all rows
why-names-of-points = the names of points that do not move with the robot
why-nothing-known = nothing is known of its heading
why-orthonormal = orthonormal in all rows, row by row
why-other-body = its heading names another body than the measured point
why-other-family = the joints are taken from the columns `{ $kept }`
why-others-measured = its heading gives a commanded value, and others are measured
why-place = its place: nothing names the columns
why-quaternion-not-joints = the four numbers have norm 1 in all rows: a quaternion, scalar first, not joints
why-range-of-deg = its heading; from { $low } to { $high }: more than a turn in rad, so deg or mm fits
why-range-of-rad = its heading; from { $low } to { $high }: rad, or m, fits
why-repeats-as-texts = its heading names repeats, and it holds texts
why-robot-computes = the nominal robot computes it to its rounding
why-robot-reproduces = the nominal robot reproduces the three columns
why-row-0001 = the row 0 0 0 1
why-targets-fit = with a target for each of its values the nominal robot fits
why-text-before = a text before the numbers
why-text-behind = a text behind numbers
why-texts-differ = texts that differ from row to row, before the numbers
why-three-of-length-one = the three numbers have norm 1 in all rows
why-whole-before-decimals = whole numbers before numbers with a decimal mark

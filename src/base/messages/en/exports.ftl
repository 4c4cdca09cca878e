### Messages of formats: input files, exports and their numbers. Above each message: its explanation
### (see CONTRIBUTING.md, "A message").

in-file = `{ $file }`: { $message }

# Means: A folder is named where a file is needed.
# Matters: The measurements are in one of its files.
# Do: Name a file in the folder.
# Example: `file = "exports"`
input-is-folder = `{ $folder }` is a folder
    .expected = a file
    .hint = name a file in it: { $files }

# Means: The file does not exist.
# Matters: The campaign is incomplete.
# Do: Correct the path, or copy the file. Paths in campaign.toml begin at its folder, paths of a
# command at the current folder.
# Example: `file = "exports/pose.txt"` where the folder has `poses.txt`
input-missing = the file `{ $file }` does not exist

simulate-the-file = write it from truth.toml: `etalon simulate { $folder }`

place-the-file = copy the file to this path, or name another path: paths in campaign.toml begin at its folder, paths of a command at the current folder

name-a-file = the folder has { $files }

# Means: A line of the file is longer than any line of measurements.
# Matters: The file is a binary recording or an archive, or its line ends are lost.
# Do: Export the measurements as text with one row per line.
# Example: a gigabyte of digits without a line end
line-too-long = `{ $file }`: line { $line } is longer than { $most_mib } MiB
    .hint = export the measurements as text, one row per line: the file may be a binary recording or an archive

# Means: A `.db3` file is not complete, is written with a write-ahead log, or is another database.
# Matters: Recorded ROS messages may be missing.
# Do: Follow the hint.
# Example: a `.db3` that was copied while ROS was recording
database-unreadable = the SQLite database cannot be read as a recording of rosbag2: { $fault ->
        [log] it has a write-ahead log
        [tables] it has no tables `topics` and `messages`
        [encoding] its texts are in UTF-16
        [end] it ends early
        [page] a page is malformed
       *[record] a record is malformed
    }
    .hint = { $fault ->
        [log] merge the log: sqlite3 FILE "PRAGMA journal_mode=DELETE"
        [tables] export its table as text, and state the columns
       *[record] copy the file again; `ros2 bag reindex FOLDER` repairs a recording that was cut
    }

# Means: The first bytes of the file are those of a binary format without text.
# Matters: Measurements are read from text, Excel workbooks (.xlsx), XML, and binary files in a stated format.
# Do: Convert the file as the hint says.
# Example: a MATLAB file `poses.mat`
file-not-text = `{ $file }` is { $kind ->
        [matlab] a MATLAB file
        [matlab-hdf5] a MATLAB file of -v7.3 (HDF5)
        [numpy] a file of NumPy
        [hdf5] an HDF5 file
        [gzip] compressed with gzip
        [xls] an old Excel workbook (.xls)
        [rosbag1] a recording of ROS 1 (.bag)
        [stl] a binary STL file
        [ply] a binary PLY file
        [pcd] a binary PCD file
        [c3d] a C3D file
        [e57] an E57 file
       *[pdf] a PDF document
    }
    .expected = text, a workbook (.xlsx), or a recording (.mcap)
    .hint = { $kind ->
        [matlab] state the name of its array as `sheet`, or in a log `format = "matlab"`
        [matlab-hdf5] save it again in MATLAB with `-v7`: S = load('FILE'); save('NEW.mat', '-struct', 'S', '-v7')
        [numpy] state the name of its array as `sheet`, or in a log `format = "numpy"`
        [hdf5] write its table as text, and state the columns
        [gzip] unpack the file
        [xls] save it as .xlsx or as text
        [rosbag1] convert it: `rosbags-convert --src FILE --dst FOLDER --dst-storage mcap`; then state the .mcap file and `topic`
        [stl] state its format: `format = "{ $kind }"`, or `--format { $kind }`
        [ply] state its format: `format = "{ $kind }"`, or `--format { $kind }`
        [pcd] state its format: `format = "{ $kind }"`, or `--format { $kind }`
        [c3d] state its format: `format = "{ $kind }"`, or `--format { $kind }`
        [e57] state its format: `format = "{ $kind }"`, or `--format { $kind }`
       *[pdf] export the points as text
    }

# Means: The points are the vertices of the triangles of a mesh.
# Matters: A program computed or thinned out the mesh; its vertices are not measured points, and their spread is not that of a measurement.
# Do: Fit measured points where you have them: export the point cloud as PLY, PCD or text.
# Example: `etalon fit sphere ball.stl --format stl --unit mm`
vertices-of-mesh = the points are vertices of a mesh, not measured points
    .hint = export the measured points as PLY or as text

# Means: The points are positions of a robot program: taught, computed or calibrated.
# Matters: They say where the robot shall go, not where it was measured.
# Do: Use them as commanded poses, and measure the attained ones.
# Example: an `[[export]]` of `format = "fanuc_ls"`
positions-of-program = the positions of a robot program are commanded, not measured
    .hint = use them as commanded poses

# Means: `encoding` contradicts the byte-order mark of the file.
# Matters: Names would be read wrongly.
# Do: Remove `encoding`; the byte-order mark states the encoding.
# Example: `encoding = "utf-8"` for a file that begins with the bytes FF FE
encoding-differs = the file begins with the byte-order mark of { $of_file }; the campaign states { $stated }
    .hint = remove `encoding`: the byte-order mark states it

# Means: A byte of the file does not exist in the encoding.
# Matters: Names and signs such as ± and µ would be read wrongly.
# Do: State the encoding in which the file was written.
# Example: the byte B1 (± in Windows-1252) in a file without `encoding`
encoding-invalid = byte { $byte } (line { $line }, { $hex }) is not { $encoding }
    .hint = state how the file was written, for example `encoding = "windows-1252"`

encoding-guessed = state how the file was written, for example `encoding = "{ $encoding }"`: the text is then `{ $sample }`

# Means: The text contains a zero byte.
# Matters: Text contains no zero byte: the file is damaged, binary, or UTF-16 without a byte-order
# mark.
# Do: State `encoding = "utf-16le"` if the file is UTF-16; otherwise export the file again.
# Example: UTF-16 text saved without its byte-order mark
nul-byte = the file contains a NUL byte (line { $line })
    .expected = text
    .hint = state `encoding = "utf-16le"` if the file is UTF-16; otherwise export the file again

# Means: The workbook has no sheet of this name.
# Matters: It is unknown which sheet holds the measurements.
# Do: Use a name of the workbook.
# Example: `sheet = "CMM"` for a workbook with the sheet `CMM 1`
sheet-missing = the workbook has no sheet `{ $sheet }`

# Means: A cell of the sheet lies outside the range that is read.
# Matters: Such a sheet is not a table of measurements, or a stray cell was filled by mistake.
# Do: Delete the cell, or copy the table to a sheet of its own.
# Example: a number in cell XFD1048576
sheet-too-large = sheet `{ $sheet }` has a cell in column { $column }, row { $row }
    .expected = at most { $columns } columns and { $rows } rows
    .hint = delete the cell, or copy the table to a sheet of its own

state-column-or-pose = state `columns = {"{"} pose = "{ $heading }" {"}"}` with its heading (option --column), or `pose = "row"` if the number of the row is the number of the pose (option --pose)
state-column-or-target = state `columns = {"{"} target = "{ $heading }" {"}"}` with its heading (option --column), or `target = "NAME"` if all rows are of one target (option --target)

# Means: A packed file (workbook, arrays, recording) unpacks to more than the maximum size. The sizes
# that it declares are checked before it is unpacked, others while it is unpacked.
# Matters: It would exhaust the memory or take minutes; files of measurements are smaller.
# Do: Save the sheet, the arrays or the topics of the measurement alone.
# Example: a workbook of 200 MiB of blanks that is packed into 1 MiB
unpacked-too-large = the { $kind ->
        [workbook] workbook unpacks
        [arrays] arrays of the file unpack
       *[recording] recording unpacks
    } to more than { $most_mib } MiB
    .hint = { $kind ->
        [workbook] save the sheet alone, or as text
        [arrays] save the arrays of the measurement alone
       *[recording] record the topics of the measurement alone
    }

# Means: The file is not a valid Excel workbook (.xlsx).
# Matters: Its sheets cannot be read.
# Do: Save the workbook again as .xlsx, or the sheet as text.
# Example: a workbook whose second half is missing
workbook-unreadable = the workbook cannot be read: { $reason }
    .hint = save it again as .xlsx, or the sheet as text

cells-unordered = the cells of sheet `{ $sheet }` are not in ascending order (row { $row })

# Means: The file is not well-formed XML.
# Matters: The rest of the file cannot be assigned to elements.
# Do: Export the file again.
# Example: `<Point>` closed by `</Points>`
xml-malformed = the XML is not well-formed: { $reason }
    .hint = export the file again

entity-unknown = the entity `&{ $name };` is unknown

second-root-element = a second root element follows

# Means: The XML file declares a document type.
# Matters: A document type may define entities that change the text or exhaust the memory.
# Do: Remove the declaration `<!DOCTYPE ...>`.
# Example: `<!DOCTYPE QIFDocument [<!ENTITY a "...">]>`
xml-doctype = the XML file declares a document type
    .hint = remove `<!DOCTYPE ...>`: measurements need none

# Means: The file has no test data of TraCIM.
# Matters: There is nothing to fit.
# Do: Save the answer of the server as it is.
# Example: `etalon fit --tracim features.qif`
tracim-test-missing = the file has no test data of TraCIM
    .expected = `tracim:test` with at least one `testElement`
    .hint = save the answer of the server as it is

# Means: The test is of another package than elements by least squares or minimum zone.
# Matters: Its objects and its criterion are unknown.
# Do: Order a test of Gaussian or Chebyshev elements.
# Example: `<tracim:test xsi:type="thread3d-test:thread3dTestPackage">`
tracim-package-unknown = the test package `{ $package }` is unknown
    .expected = `gauss:gaussTestPackage` or `chebyshev:chebyshevTestPackage`

# Means: The test data have no key of their process.
# Matters: The server assigns an answer by this key.
# Do: Save the answer of the server as it is.
# Example: a file without `<tracim:process>`
tracim-key-missing = the test data have no process key
    .expected = `tracim:process` with `tracim:key`
    .hint = save the answer of the server as it is

# Means: A point of a data set lacks a coordinate.
# Matters: The element cannot be fitted.
# Do: Save the answer of the server as it is.
# Example: `<gauss:vectors>` without `<gauss:z>`
tracim-coordinate-missing = a point of data set `{ $id }` has no coordinate `{ $coordinate }`
    .hint = save the answer of the server as it is

# Means: Elements or blocks are nested deeper than in any file of measurements.
# Matters: The file is damaged, or not one of this format.
# Do: Export the file again.
# Example: 100 nested XML elements
nested-too-deep = `{ $name }` is nested { $depth } levels deep
    .expected = at most { $most } levels
    .hint = export the file again

# Means: The file has more elements, or its features more points, than are read.
# Matters: The memory would be exhausted.
# Do: Export fewer features at a time.
# Example: a QIF file of five million elements
file-too-many-items = the file has more than { $most } { $items ->
        [elements] XML elements
       *[points] points in its features
    }
    .hint = export fewer features at a time

# Means: The file ends before a record that a complete file has.
# Matters: Measurements may be missing.
# Do: Export or copy the file again.
# Example: a PLY file of 1000 vertices with 500 lines
file-cut-off = the file ends before { $missing }
    .hint = export or copy the file again: it is incomplete

item-of-count = `{ $name }` { $number } of { $count }

export-again-or-add = export or copy the file again; if it is complete, add the line `{ $line }`

# Means: The file does not begin like a file of the stated format.
# Matters: In this format, its numbers would have a wrong meaning or none.
# Do: State the format of the file; `etalon formats FILE` proposes it.
# Example: `format = "ply"` for a PolyWorks text
format-differs = the file is not in format `{ $format }`
    .expected = { $signature }
    .hint = state the format of the file: `etalon formats FILE` proposes it

begins-with = a file that begins with `{ $text }`

header-in-tabs = a header separated by tabs with { $names }

header-with = a header with { $names }

records-like = records like `{ $example }`

root-element = an XML file with the root element `{ $name }`

# Means: The version of the format is not supported.
# Matters: Records of another version may have another meaning.
# Do: Export the file in a supported version.
# Example: a QIF file with `versionQIF="1.0"`
version-unsupported = { $format } version `{ $version }` is not supported
    .expected = { $versions }
    .hint = export the file in a supported version

# Means: The format does not define this record, value or word.
# Matters: Its meaning is unknown.
# Do: Correct the record, or export the file again.
# Example: `#04:XZ(Y)` in a scan of GEOPAK-Win
record-invalid = `{ $text }` is not valid in format `{ $format }`
    .expected = { $valid }

k-field-or-values = a K field such as `K2002/1 Ball 1.X`, or a row of values

unicode-in-hexadecimal = text, or `UNICODE( ... )` with four hexadecimal digits a character

three-numbers = three numbers

# Means: A record of the file needs another record before it.
# Matters: It is unknown to which item the record belongs.
# Do: Export the file again; the earlier record is missing or was moved.
# Example: `K0002/1 0` before `K0001/1 12.5` in a Q-DAS file
record-too-early = `{ $record }` needs an earlier `{ $needed }`
    .hint = export the file again: a record is missing or misplaced

# Means: An element of the file lacks a record that the format requires.
# Matters: Its value is unknown.
# Do: Export the file with this record.
# Example: a PLY file without `property float z`
record-missing = `{ $parent }` has no `{ $record }`
    .hint = export the file with this record

# Means: The format defines this element, and etalon does not read it.
# Matters: Ignoring it could falsify the points.
# Do: Export the points without it.
# Example: `BinaryPoints` in a QIF file
element-unsupported = `{ $element }` is not supported
    .hint = export the points without it

export-points-as-text = export the points as text: QIF does not state the byte order of binary points

export-without-lists = export the points without lists

# Means: The file has no points that were measured.
# Matters: There is nothing to evaluate.
# Do: Name the file that holds the measured points.
# Example: a DMIS measuring program instead of its output file
no-measured-points = the file has no measured points{ $contents ->
        [none] {""}
       *[other] : it contains { $contents }
    }
    .expected = records `{ $records }`

measuring-program = a measuring program

head-of-a-run = the head of a run

output-of-program = name the output file that the program writes

calypso-head = name the `_chr` or `_fet` file beside it; the head states the length unit `{ $unit }` and a workpiece temperature of { $temperature } °C

export-measured-points = export the measured points instead of the geometry of the part

export-one-dfq = export description and values in one .dfq file: a .dfd file has no values, a .dfx file no names

fields-of-columns = { $count } fields, as `columns` states

polyworks-fields = `x y z` or `x y z i j k`, optionally preceded by a name

spatialanalyzer-fields = `collection, group, target, x, y, z`, or the last five, four or three of them

three-to-eight-numbers = three to eight numbers separated by commas

propose-format = check delimiter, decimal mark and quotes of the row, and that the file was not cut off; `etalon formats FILE` proposes how to read the file

quote-names = put names with blanks in quotes, or state the delimiter and the columns: `format = {"{"} delimiter = .., columns = .. {"}"}`

state-as-delimited = state a file with names or tabs as delimited text: `format = {"{"} delimiter = .., columns = .. {"}"}`

state-columns = export the axes as comments, or state the columns: format = {"{"} delimiter = "{ $delimiter }", comment = "//", columns = [{ $columns }] {"}"}

commas-in-commas = export the report with semicolons: decimal commas and separating commas cannot be told apart

# Means: A record has too many or too few numbers for its kind.
# Matters: Its numbers cannot be assigned to coordinates, direction and diameter.
# Do: Export the file again: it was edited or cut off.
# Example: `#03: 1.0 2.0` in a scan of GEOPAK-Win
number-count-differs = `{ $name }` has { $found ->
        [one] 1 number
       *[other] { $found } numbers
    }
    .expected = { $counts }
    .hint = export the file again: it was edited or cut off

three-per-point = three numbers for each point

dmis-continuation = check whether the file was cut off: a record continues only after a line that ends in `$`

# Means: The number of values differs from the count that the file states.
# Matters: Values may be missing, or belong to other points.
# Do: Export the file again: it was edited or cut off.
# Example: `PSET / 5` followed by 14 numbers
stated-count-differs = `{ $name }` has { $found ->
        [one] 1 value
       *[other] { $found } values
    }
    .expected = { $stated }, by the count that the file states
    .hint = export the file again: it was edited or cut off

# Means: The cell that assigns the row to a pose, a cycle or a feature is empty.
# Matters: The row cannot be matched with others.
# Do: Complete the cell, or export the file again.
# Example: a row of a Calypso table without `featureid`
cell-empty = `{ $column }` is empty
    .hint = complete the cell, or export the file again: it was edited or cut off

# Means: The text is not a number in the stated decimal and thousands marks.
# Matters: A guessed mark would change the value by a factor of 1000.
# Do: State `decimal` and `thousands` as the file uses them, or correct the cell.
# Example: `10,5` in a file with decimal points
not-a-number = `{ $text }` is not a number
    .expected = a number with the decimal mark `{ $decimal }`{ $thousands ->
            [none] {""}
           *[other] , and `{ $thousands }` between groups of three digits
        }

number-marks = if the file writes numbers this way, state { $first }{ $second ->
        [none] {""}
       *[other] {" "}or { $second }
    }

format-with-decimal-comma = if the file has decimal commas, state `format = "{ $format }, decimal comma"`

# Means: A cell is empty where the format needs a number.
# Matters: The value is unknown; zero would be a guess.
# Do: Complete the cell.
# Example: `K_1;10.5;;30` in a file separated by semicolons
number-empty = a number is missing
    .expected = a number with the decimal mark `{ $decimal }`{ $thousands ->
            [none] {""}
           *[other] , and `{ $thousands }` between groups of three digits
        }

save-computed-workbook = the formula has no value: save the workbook in the program that computes it

# Means: A number has more characters than any program writes.
# Matters: The file is damaged, or the stated delimiter is wrong.
# Do: Export the file again, or state its delimiter.
# Example: a field of 50000 digits
number-too-long = `{ $start }...` has { $characters } characters
    .expected = a number of at most { $most } characters
    .hint = export the file again, or state its delimiter

pose-number-or-name = a whole number, or a name like `home`

whole-number = a whole number

# Means: The text is not a date with a time of day, or day and month could be exchanged.
# Matters: Poses are assigned to a log by time.
# Do: Export times in one of the forms of the example.
# Example: `26.11.2026 25:00:00`
time-invalid = `{ $text }` is not a date with a time of day
    .expected = a time like `11.10.2022 15:06:48.043` or `2022-10-11T15:06:48`

# Means: A quote in the line has no partner, or text follows a closing quote.
# Matters: The fields of the line cannot be separated.
# Do: Close the quote, or write a quote inside a quoted field twice.
# Example: `"ball 1,10.5,20,30`
quote-unmatched = { $fault ->
        [open] a quote is not closed on its line
       *[behind] text follows a closing quote
    }
    .hint = close the quote; a quote inside a quoted field is written twice

# Means: A row to be written begins like a comment.
# Matters: A reader of the file would skip the row.
# Do: State another `comment`, or rename the point.
# Example: a label `#1` with `comment = "#"`
row-is-comment = the row `{ $row }` would be read as a comment
    .hint = state another `comment`

state-column-number = state the number of the column instead of its name

# Means: Rows follow the line that ends the data.
# Matters: It is unknown whether they are measurements.
# Do: Remove the rows, or the line that ends the data.
# Example: points after the line `END` of a Calypso table
rows-after-end = rows follow the end of the data, `{ $end }`
    .hint = remove these rows, or `{ $end }`

# Means: A row states a coordinate type that `types` does not explain.
# Matters: Its numbers may be angles or lengths.
# Do: Add the type to `types`.
# Example: type 3 where `types` states 0 and 7
coordinate-type-unknown = `types` does not state the coordinates of type `{ $name }`
    .expected = { $known }
    .hint = add the type to `types`

# Means: The file states coordinates that are not Cartesian, and its format does not define their
# columns and units.
# Matters: Angles would be read as lengths.
# Do: Export Cartesian coordinates.
# Example: `// AXES = SPHERICAL: R, T, P` in a SpatialAnalyzer export
coordinates-not-cartesian = the coordinates are `{ $found }`
    .expected = Cartesian coordinates: { $cartesian }
    .hint = export Cartesian coordinates

export-cartesian-or-columns = export Cartesian coordinates, or state the columns: format = {"{"} delimiter = ",", comment = "//", columns = [{ $columns }], angle_unit = "deg" {"}"}

# Means: The points of a feature are in another coordinate system than the first points, or in two
# dimensions.
# Matters: Points of two coordinate systems cannot be combined.
# Do: Export all points in one coordinate system with three dimensions.
# Example: `"Circle 1: 2D MCS Points"` in an InSpec export
coordinate-system-differs = the points of `{ $feature }` are in `{ $found }`
    .expected = `{ $needed }`
    .hint = export all points in one coordinate system

# Means: All rows have two small angles and one length in the columns x, y and z.
# Matters: Spherical coordinates read as Cartesian ones give points on a line.
# Do: State the columns as angles and distance, or confirm `coordinates = "cartesian"`.
# Example: a tracker's export `K_1 0.7853 1.5707 3000.0` with `columns = ["label", "x", "y", "z"]`
coordinates-look-spherical = x, y and z look like azimuth (rad), zenith (rad) and distance
    .expected = Cartesian coordinates: all rows have two small angles and one length
    .hint = state the columns "azimuth", "zenith", "distance" with `angle_unit = "rad"`, or `coordinates = "cartesian"`

# Means: A row has some numbers of an orientation, and its other cells of the orientation are empty.
# Matters: The orientation is undefined.
# Do: Complete the orientation, or leave all its cells empty.
# Example: a quaternion with `qw`, `qx`, `qy` and an empty `qz`
orientation-incomplete = the orientation has { $found } of { $needed } numbers
    .hint = complete the orientation, or leave all its cells empty

# Means: The three numbers of a direction do not have the length 1.
# Matters: They are probably another quantity, for example angles in degrees.
# Do: Skip the columns, or export unit vectors.
# Example: `i`, `j`, `k` with the values 90, 90, 0
direction-not-unit = the direction ({ $i }, { $j }, { $k }) has the length { FIXED($length, 3) }
    .expected = a unit vector

skip-columns = skip the columns with "-" if they are another quantity

skip-direction-angles = skip the columns with "-": they are the angles of the direction (deg)

# Means: The direction of a feature is zero.
# Matters: The feature has no orientation.
# Do: Export the feature again.
# Example: `<Normal>0 0 0</Normal>` in a QIF file
direction-zero = the direction `{ $direction }` has no length
    .expected = three numbers, not all zero

# Means: The notation of directions in the file differs from that of the stated format.
# Matters: Angles (deg) read as unit vectors, or the reverse, give wrong directions.
# Do: State the format that the hint names.
# Example: `90, 90, 0` as direction with `format = "dmis"`
direction-notation-differs = the direction is written as { $found ->
        [angles] angles (deg)
       *[vector] a unit vector
    }
    .expected = { $found ->
            [angles] a unit vector, as in DMIS
           *[vector] angles (deg), as written by GEOPAK
        }
    .hint = state `format = "{ $format }"`

# Means: The unit of length in the file differs from that of the campaign or the command.
# Matters: All coordinates would be wrong by a constant factor.
# Do: State the unit of the file; if its heading is wrong, correct the heading.
# Example: `unit = "inch"` for a DMIS file with `UNITS/MM`
unit-differs = the file is in { $of_file } ({ $how }); the stated unit is { $stated }
    .hint = if the heading of the file is wrong, correct it there; otherwise state the unit of the file

default-of-format = no `{ $record }`: default of the format

# Means: The unit that the file states is not a unit of this quantity.
# Matters: The scale of its values is unknown.
# Do: Export the file in one of the expected units.
# Example: `UNITS/FEET` in a DMIS file
unit-unknown = `{ $unit }` is not a known unit
    .expected = { $units }
    .hint = export the file in one of these units

# Means: The file does not state its unit, and the unit is stated nowhere else.
# Matters: A guessed unit would falsify every result.
# Do: State the unit, or export the file with its units.
# Example: `etalon fit plane part.qif` for a file without `FileUnits`
file-unit-missing = the file does not state its unit of { $quantity ->
        [length] length
       *[angle] angle
    }
    .expected = `{ $record }` with its factor in `FileUnits/PrimaryUnits`
    .hint = { $quantity ->
        [length] state the unit: `unit` of the export, or `--unit`
       *[angle] export the file with its units
    }

# Means: A unit of a QIF file has a factor that is zero or negative, or an offset.
# Matters: Lengths and angles have a positive factor and no offset.
# Do: Export the file again.
# Example: `<Factor>0</Factor>`
unit-factor-invalid = the unit has the factor { $factor } and the offset { $offset }
    .expected = a positive factor, no offset

# Means: Files of this format cannot have the stated unit.
# Matters: A simulated file in this unit would be read wrongly by other programs.
# Do: State a unit of the format.
# Example: `etalon simulate` with `format = "pcdmis_xyz"` and `unit = "m"`
format-without-unit = format `{ $format }` cannot have the unit { $unit }
    .expected = { $units }
    .hint = state one of these units

# Means: `etalon simulate` cannot write this format or dialect.
# Matters: The export of the simulated campaign would be missing.
# Do: State another format for this export.
# Example: `format = "qif"` in a campaign that is simulated
format-not-simulated = `etalon simulate` cannot write { $kind ->
        [fixed] fixed widths or workbooks
        [types] rows that state their coordinate type
        [numbers] columns that are stated by number
       *[qif] QIF
    }
    .hint = { $kind ->
        [fixed] state a `delimiter` for this export
        [types] state `columns` with one coordinate type
        [numbers] state the names of the columns
       *[qif] state `format = "polyworks"` or a delimited format for this export
    }

# Means: The pattern of labels has an error.
# Matters: Target, pose and cycle cannot be read from the labels.
# Do: Correct the pattern.
# Example: `label = "{target}_{pos}"`
label-pattern-invalid = { $fault ->
        [open] `{ $pattern }` has a `{"{"}` without `{"}"}`
        [unknown] `{ $pattern }` has the unknown name `{ $name }`
       *[twice] `{ $pattern }` has `{ $name }` twice
    }
    .expected = text with {"{"}target{"}"}, {"{"}pose{"}"} and {"{"}cycle{"}"}, each at most once
    .hint = correct `label`

state-encoding = state the encoding of the file: it was decoded in another one

# Means: A Q-DAS file has several data sets.
# Matters: Characteristics of different parts have the same numbers.
# Do: Divide the file into one file for each data set, each with an [[export]].
# Example: two fields `K0100` in one .dfq file
several-data-sets = a second `{ $record }`: the file has several data sets
    .hint = divide it into one file for each data set, each with an [[export]]

# Means: A field of a Q-DAS file has a larger index than K0100 announces.
# Matters: The file was cut off, or combined from several files.
# Do: Export the file again.
# Example: `K2002/7` after `K0100 6`
characteristic-beyond-count = characteristic { $index } does not exist: the number of characteristics in K0100 is { $count }
    .hint = export the file again: it was edited or combined from several files

# Means: Values of a characteristic are missing before this one.
# Matters: Coordinates of different parts would be combined into one point.
# Do: Write values that were not measured with the attribute 255 (K0002).
# Example: a value of `Ball 1.Y` for piece 2 and none for piece 1
value-of-piece-missing = value { $number } of `{ $name }` belongs to piece { $piece }: an earlier value is missing
    .hint = export values that were not measured with the attribute 255 (K0002)

# Means: The coordinates of a point have different numbers of values.
# Matters: Coordinates of different parts would be combined into one point.
# Do: Write values that were not measured with the attribute 255 (K0002).
# Example: three values of `Ball 1.X` and two of `Ball 1.Y`
coordinate-counts-differ = `{ $name }` has { $found ->
        [one] 1 value
       *[other] { $found } values
    }; another coordinate of the point has { $count }
    .hint = export values that were not measured with the attribute 255 (K0002)

# Means: `METRIC` is in the first line, outside of columns 11 to 16.
# Matters: PC-DMIS reads the unit from the columns of the word, which mean inches here; the word
# means millimetres.
# Do: Find out the unit from the author of the file, then correct line 1.
# Example: `XYZIJK METRIC` with one blank
metric-misplaced = `METRIC` is outside of columns 11 to 16: the unit is ambiguous (inch or mm)
    .expected = `XYZIJK    METRIC`, or `XYZIJK` alone for inches
    .hint = correct line 1, or state the file as delimited text with its unit

# Means: A vertex of a PLY file is infinite or not a number.
# Matters: It is not a measured point.
# Do: Export the measured points alone.
# Example: a binary PLY file whose first x is NaN
vertex-not-finite = vertex { $number } is { $coordinates }
    .expected = finite coordinates
    .hint = export the measured points alone

# Means: Columns 73 to 80 hold eight digits that are not the number of the line.
# Matters: They may be part of a coordinate.
# Do: Export the file without line numbers.
# Example: `00000041` in line 42 of a VDA-FS file
line-number-differs = columns 73 to 80 hold `{ $digits }`: a line number or a value
    .expected = `{ $number }`, the number of this line
    .hint = export the file without line numbers

feature-without-points = `{ $feature }` has no usable points: { $message }

# Means: Some points of a feature are contact points, others are centres of the probe or of another
# probe.
# Matters: The fitted element is corrected for one probe radius.
# Do: Fit these points separately.
# Example: a cylinder measured with two probes
compensation-mixed = the points have different probe compensation
    .hint = fit these points separately

# Means: An element refers to another element that the file lacks.
# Matters: Points or names of the feature are missing.
# Do: Export the file again: it was edited or cut off.
# Example: `<WholePointSetId>7</WholePointSetId>` without a point set 7
reference-broken = `{ $name }` refers to { $id }, which is not a `{ $kind }` of this file

# Means: Points of a feature are in another QIF document.
# Matters: Only one file is read; the feature has no points.
# Do: Export feature and points in one document.
# Example: `<WholePointSetId xId="2">7</WholePointSetId>`
reference-external = point set { $id } is in another document
    .hint = export feature and points in one document

# Means: The range of points is not within the point set.
# Matters: The points of the feature are unknown.
# Do: Export the file again: it was edited.
# Example: `range="90 110"` of a set of 100 points
point-range-invalid = `{ $range }` is not a range of point set { $id } (line { $line })
    .expected = whole numbers from 1 to { $count }, the smaller first

# Means: No feature refers to a point set of the file.
# Matters: Its points are not used.
# Do: Check whether a feature is missing.
# Example: a scanned surface without a feature
point-set-unused = no feature refers to point set { $id }

# Means: Two elements of the file have the same id.
# Matters: References use the first element, which may be the wrong one.
# Do: Export the file again: it was combined from several files.
# Example: two elements with `id="5"`
id-repeated = id { $id } is used twice, first in line { $line }: references use the first
    .hint = export the file again: it was combined from several files

# Means: The file has more messages than are shown.
# Matters: Their causes may differ from those of the messages that are shown.
# Do: Correct the causes of the messages that are shown, and read the file again.
# Example: a QIF file with 60 repeated ids
further-messages = { $count ->
        [one] 1 further message
       *[other] { $count } further messages
    } about this file

# Means: The recording (MCAP) is damaged or not finished.
# Matters: Messages after the damage are missing.
# Do: Repair it with `mcap recover`, or record again.
# Example: a recording without its end, because the power of the recorder failed
recording-unreadable = the recording cannot be read: { $fault ->
        [checksum] the checksum of a chunk differs
        [compression] a chunk has another compression than LZ4 and Zstandard
        [size] a chunk is larger than 256 MiB
        [unpack] a chunk cannot be unpacked
        [channel] a message has no channel
       *[end] the file ends within a record
    }
    .hint = repair it with `mcap recover FILE -o REPAIRED`, or copy it again

# Means: `topic` is stated for a file that is not an MCAP recording.
# Matters: Only MCAP recordings have topics; this file has another format, or an older format of
# recordings.
# Do: Name the `.mcap` file inside the folder of the recording, or omit `topic`.
# Example: `topic = "/joint_states"` for a CSV file
recording-missing = the file is not an MCAP recording: it has no topic `{ $topic }`
    .hint = name the .mcap file in the folder of the recording, or omit `topic`

# Means: The file is a recording (MCAP) with several topics, and `topic` is missing.
# Matters: It is unknown which messages hold the measurements or joint values.
# Do: State `topic`; `etalon formats FILE` lists the topics.
# Example: a log with `file = "run_0.mcap"` without `topic`
topic-not-stated = the file is a recording (MCAP), and `topic` is missing

# Means: The recording has no message of this topic.
# Matters: There is nothing to read.
# Do: State a topic of the recording.
# Example: `topic = "/joint_state"` for the topic `/joint_states`
topic-missing = the recording has no message of topic `{ $topic }`

# Means: The messages of the topic exceed the maximum size in memory.
# Matters: The recording cannot be read as one table.
# Do: Cut the recording to the time of the measurements with `ros2 bag convert` or `mcap filter`.
# Example: a day of joint values at 1 kHz
topic-too-large = the messages of topic `{ $topic }` are larger than { $most_mib } MiB
    .hint = cut the recording to the time of the measurements: `mcap filter FILE -o SHORTER --start SECONDS --end SECONDS`

# Means: etalon reads no joint values or coordinates from messages of this type.
# Matters: The topic cannot be a log or an export.
# Do: State a topic with one of the expected types.
# Example: `topic = "/tf"`
topic-type-unknown = topic `{ $topic }` has messages of type `{ $message }`
    .expected = { $known }
    .hint = state the topic of the joint values or measured poses: `etalon formats FILE` lists the topics

# Means: The messages are not in CDR, the encoding of ROS 2.
# Matters: Their numbers cannot be read.
# Do: Convert the recording to ROS 2, for example with `rosbags-convert`.
# Example: a recording of ROS 1 that was converted to MCAP
topic-encoding-unknown = the messages of topic `{ $topic }` have the encoding `{ $encoding }`
    .expected = `cdr`, the encoding of ROS 2
    .hint = convert the recording to ROS 2: `rosbags-convert --src FILE --dst FOLDER --dst-storage mcap`

# Means: A message does not have the layout of its type.
# Matters: The numbers in it are unknown.
# Do: Record again without compression of single messages, and without a changed message definition.
# Example: `ros2 bag record --compression-mode message`
ros-message-malformed = message { $number } of topic `{ $topic }` does not have the layout of its type
    .hint = record without `--compression-mode message`; `ros2 bag convert` writes such a recording again

# Means: A JointState message has different numbers of positions and of names.
# Matters: It is unknown which joint a position belongs to.
# Do: Correct the node that publishes the topic.
# Example: seven names, and six positions because the gripper has none
joint-state-lengths-differ = message { $number } of topic `{ $topic }` has { $names } names of joints and { $positions } positions
    .expected = a position for each name, or no position
    .hint = correct the node that publishes the topic

# Means: A JointState message names a joint twice.
# Matters: It is unknown which of the two positions is that of the joint.
# Do: Correct the node that publishes the topic.
# Example: the driver merges the arm with itself
joint-state-name-twice = message { $number } of topic `{ $topic }` names the joint `{ $joint }` twice
    .hint = correct the node that publishes the topic

# Means: All JointState messages of the topic have an empty list of positions.
# Matters: The recording holds no joint values, only velocities or efforts.
# Do: State the topic with the measured positions.
# Example: the topic of commands `/joint_commands` in place of `/joint_states`
topic-without-positions = no message of topic `{ $topic }` has positions ({ $count ->
        [one] 1 message
       *[other] { $count } messages
    })
    .hint = state the topic with the measured positions: `etalon formats FILE` lists the topics

ros-messages-of-other-joints = { $count ->
        [one] message
       *[other] first of { $count } messages
    } without any of the joints in `columns`: published by another node

# Means: The recording (MCAP) has no topic with joint values, poses or points that etalon reads.
# Matters: The recording has no measurements, or has them in messages of another type.
# Do: Record JointState, PoseStamped or PointStamped messages.
# Example: a recording of the topic `/rosout` alone
recording-without-known-topics = the recording has no topic with joint values, poses or points: { $found }
    .expected = sensor_msgs/JointState, geometry_msgs/PoseStamped or geometry_msgs/PointStamped
    .hint = record a topic with one of these types

# Means: The file has no numeric array of this name, or the part is not in the notation of its
# language.
# Matters: The column cannot be read.
# Do: Use an array of the file; `etalon formats FILE` lists them.
# Example: `q1_rad = "Q(:,1)"` for the variable `q`
array-missing = the file has no numeric array `{ $column }`

# Means: The stated part of an array is not a single column or row.
# Matters: It is unknown which numbers form the column.
# Do: Write the part as in Python or MATLAB.
# Example: `q1_rad = "q"` for a matrix of six columns
array-part-unknown = `{ $column }` is not one column: `{ $name }` is { $shape }
    .hint = write the part as in the language of the file: `{ $example }`

# Means: Two columns of a log have different lengths.
# Matters: It is unknown which values belong together.
# Do: State arrays of one recording and of equal length.
# Example: times at 1 kHz beside joints at 100 Hz
array-lengths-differ = `{ $first }` has { $count } numbers and `{ $second }` has { $other }
    .expected = columns of equal length
    .hint = state arrays of one recording; if the columns of a matrix are times, its rows are joints

# Means: The file is damaged, or has another format than stated.
# Matters: Its numbers cannot be read.
# Do: Save the file again.
# Example: a copy that was interrupted
arrays-unreadable = the file cannot be read as arrays of { $format ->
        [numpy] NumPy (.npz, .npy)
       *[matlab] MATLAB (.mat of -v6 or -v7)
    }
    .hint = save it again, or correct `format`

# Means: The file is a workbook, and no sheet is stated.
# Matters: A workbook may have several sheets.
# Do: State the sheet: in `format` of an [[export]], otherwise in the section of the table.
# Example: `file = "joints.xlsx"` without `sheet`
sheet-not-stated = the sheet of the workbook is not stated; the workbook has { $sheets }
    .hint = state the `sheet`

state-sheet = state `sheet = "{ $sheet }"` (option --sheet)

state-column = if it is the column `{ $heading }`, state `columns = {"{"} { $column } = "{ $heading }" {"}"}` (option --column)
row-marked-deleted = left out: it is marked as deleted (`{ $cell }`)
row-left-out-by-cell = left out: `{ $column }` is `{ $cell }`
row-without-coordinates = not measured: no coordinates
row-cell-empty = not measured: { $column } is empty
row-invisible = not measured: 0 0 0 with the quaternion 0 0 0 0
row-not-measured = not measured: { $column } is `{ $cell }`
characteristic-of-no-axis = no coordinate: the name of the characteristic does not end in X, Y or Z
feature-of-no-point = a feature `{ $kind }`: its point may be anywhere on the feature
feature-not-read = a feature `{ $kind }`: this kind is not read
point-incomplete = no point: { $found } without { $missing }
probe-centre-no-point = a probe centre, not a point of the feature

log-delimited = delimited by `{ $delimiter }`, decimal `{ $decimal }`
log-of-arrays = arrays of { $format }
log-of-sheet = workbook, sheet `{ $sheet }`
log-of-topic = ROS recording, topic `{ $topic }`
log-of-format = { $format }, { $read }
log-with-start = { $read }, start { $start }
read-with-decimal-comma = { $format }, decimal `,`

value-without-label = a value without a label
primitive-no-point = a primitive of type `{ $kind }`, not a point

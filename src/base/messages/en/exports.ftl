### Messages of formats: input files, exports and their numbers. Above each message: its explanation
### (see CONTRIBUTING.md, "A message").

in-file = `{ $file }`: { $message }

# Means: The path is a folder, but the command needs a file.
# Matters: The measurements are in one of its files.
# Do: Add the name of the file to the path.
# Example: `file = "exports"`
input-is-folder = `{ $folder }` is a folder
    .expected = a file
    .hint = give a file in it: { $files }

# Means: The file does not exist.
# Matters: The measurements of this file are missing.
# Do: Correct the path, or copy the file to it. Paths in campaign.toml start at its folder, paths of
# a command at the current folder.
# Example: `file = "exports/pose.txt"`, but the file is `poses.txt`
input-missing = the file `{ $file }` does not exist

simulate-the-file = write it from truth.toml: `etalon simulate { $folder }`

place-the-file = copy the file to this path, or give another path: paths in campaign.toml start at its folder, paths of a command at the current folder

name-a-file = the folder contains { $files }

# Means: A line of the file is longer than any line of measurements.
# Matters: The file is probably a binary recording or an archive, or its line ends are missing.
# Do: Export the measurements as text, with one row per line.
# Example: a gigabyte of digits without a line end
line-too-long = `{ $file }`: line { $line } is longer than { $most_mib } MiB
    .hint = export the measurements as text, one row per line: the file may be a binary recording or an archive

# Means: A `.db3` file is incomplete, has a write-ahead log, or is another kind of database.
# Matters: Recorded ROS messages could be missing.
# Do: Copy the file again after ROS has stopped recording, or merge its log as the hint shows.
# Example: a `.db3` that was copied while ROS was recording
database-unreadable = the SQLite database cannot be read as a recording of rosbag2: { $fault ->
        [log] a write-ahead log belongs to it
        [tables] it has no tables `topics` and `messages`
        [encoding] its text is in UTF-16
        [end] its end is missing
        [page] a page is malformed
       *[record] a record is malformed
    }
    .hint = { $fault ->
        [log] merge the log: sqlite3 FILE "PRAGMA journal_mode=DELETE"
        [tables] export its table as text, and describe the columns in `format`
       *[record] copy the file again; `ros2 bag reindex FOLDER` repairs a recording without its end
    }

# Means: The file has a binary format that the command does not read without a given format.
# Matters: Measurements are read from text, Excel workbooks (.xlsx), XML, and binary files whose
# format is given.
# Do: Give the format of the file, or convert the file to text.
# Example: a MATLAB file `poses.mat`
file-not-text = `{ $file }` is { $kind ->
        [matlab] a MATLAB file
        [matlab-hdf5] a MATLAB file saved with -v7.3 (HDF5)
        [numpy] a NumPy file
        [hdf5] an HDF5 file
        [gzip] compressed with gzip
        [xls] an old Excel workbook (.xls)
        [rosbag1] a recording of ROS 1 (.bag)
        [stl] a binary STL file
        [ply] a binary PLY file
        [pcd] a binary PCD file
        [c3d] a C3D file
        [e57] an E57 file
        [image] a picture
        [pickle] a Python pickle
        [archive] an archive
       *[pdf] a PDF document
    }
    .expected = text, a workbook (.xlsx), or a recording (.mcap)
    .hint = { $kind ->
        [matlab] set `sheet` to the name of its array; in a log set `format = "matlab"`
        [matlab-hdf5] save it again in MATLAB with `-v7`: S = load('FILE'); save('NEW.mat', '-struct', 'S', '-v7')
        [numpy] set `sheet` to the name of its array; in a log set `format = "numpy"`
        [hdf5] write its table as text, and describe the columns in `format`
        [gzip] unpack the file
        [xls] save it as .xlsx or as text
        [rosbag1] convert it: `rosbags-convert --src FILE --dst FOLDER --dst-storage mcap`; then use the .mcap file and set `topic`
        [stl] give its format: `format = "{ $kind }"`, or `--format { $kind }`
        [ply] give its format: `format = "{ $kind }"`, or `--format { $kind }`
        [pcd] give its format: `format = "{ $kind }"`, or `--format { $kind }`
        [c3d] give its format: `format = "{ $kind }"`, or `--format { $kind }`
        [e57] give its format: `format = "{ $kind }"`, or `--format { $kind }`
       *[pdf] export the points as text
    }

# Means: The points are the vertices of the triangles of a mesh.
# Matters: A program computed or thinned out the mesh. Its vertices are not measured points, and
# their scatter is not the scatter of a measurement.
# Do: Export the point cloud as PLY, PCD or text, and fit its points.
# Example: `etalon fit sphere ball.stl --format stl --unit mm`
vertices-of-mesh = the points are vertices of a mesh, not measured points
    .hint = export the measured points as PLY or as text, and fit these points

# Means: The points are positions in a robot program: taught, computed or calibrated.
# Matters: These positions are targets of the robot; they were not measured.
# Do: Use them as commanded poses, and measure the attained poses.
# Example: an `[[export]]` of `format = "fanuc_ls"`
positions-of-program = the positions of a robot program are commanded, not measured
    .hint = use them as commanded poses

# Means: `encoding` contradicts the byte-order mark at the beginning of the file.
# Matters: Names are read wrongly.
# Do: Remove `encoding`.
# Example: `encoding = "utf-8"` for a file that begins with the bytes FF FE
encoding-differs = the file begins with the byte-order mark of { $of_file }; the campaign gives { $stated }
    .hint = remove `encoding`: the byte-order mark gives it

# Means: The file contains a byte that does not exist in this encoding.
# Matters: Names and signs such as ± and µ are read wrongly.
# Do: Set `encoding` to the encoding of the program that wrote the file.
# Example: the byte B1 (± in Windows-1252) in a file without `encoding`
encoding-invalid = byte { $byte } (line { $line }, { $hex }) is not { $encoding }
    .hint = give the encoding of the file, for example `encoding = "windows-1252"`

encoding-guessed = give the encoding of the file, for example `encoding = "{ $encoding }"`: the text then reads `{ $sample }`

# Means: The file contains a zero byte.
# Matters: Text contains no zero bytes: the file is damaged, binary, or UTF-16 without a byte-order
# mark.
# Do: If the file is UTF-16, set `encoding = "utf-16le"`. Otherwise export it again.
# Example: UTF-16 text saved without its byte-order mark
nul-byte = the file contains a NUL byte (line { $line })
    .expected = text
    .hint = set `encoding = "utf-16le"` if the file is UTF-16; otherwise export the file again

# Means: The workbook has no sheet of this name.
# Matters: It is unknown which sheet contains the measurements.
# Do: Use one of the sheet names in the message.
# Example: `sheet = "CMM"` for a workbook with the sheet `CMM 1`
sheet-missing = the workbook has no sheet `{ $sheet }`

# Means: A cell of the sheet is outside the range that is read.
# Matters: The sheet is not a table of measurements, or a cell far away was filled by mistake.
# Do: Delete this cell, or copy the table to a new sheet.
# Example: a number in cell XFD1048576
sheet-too-large = sheet `{ $sheet }` has a cell in column { $column }, row { $row }
    .expected = at most { $columns } columns and { $rows } rows
    .hint = delete this cell, or copy the table to a new sheet

state-column-or-pose = set `columns = {"{"} pose = "{ $heading }" {"}"}` with the heading of the column (option --column), or `pose = "row"` if the number of the row is the number of the pose (option --pose)
state-column-or-target = set `columns = {"{"} target = "{ $heading }" {"}"}` with the heading of the column (option --column), or `target = "NAME"` if all rows belong to one target (option --target)
state-column-or-cycle = set `columns = {"{"} cycle = "{ $heading }" {"}"}` with the heading of the column (option --column), or `cycle = "visit"` if the rows are in the order of measurement (option --constant cycle=visit)

# Means: A compressed file (workbook, arrays, recording) is larger than the maximum size when
# unpacked.
# Matters: It exhausts the memory or takes minutes. Files of measurements are smaller.
# Do: Save only the sheet, the arrays or the topics of the measurement.
# Example: a workbook of 200 MiB of blanks that is packed into 1 MiB
unpacked-too-large = the { $kind ->
        [workbook] workbook unpacks
        [arrays] arrays of the file unpack
       *[recording] recording unpacks
    } to more than { $most_mib } MiB
    .hint = { $kind ->
        [workbook] save only the sheet of the measurement, or save it as text
        [arrays] save only the arrays of the measurement
       *[recording] record only the topics of the measurement
    }

# Means: The file is not a valid Excel workbook (.xlsx).
# Matters: Its sheets cannot be read.
# Do: Open the workbook in its program, and save it again as .xlsx or as text.
# Example: a workbook whose second half is missing
workbook-unreadable = the workbook cannot be read: { $reason }
    .hint = save it again as .xlsx, or the sheet as text

cells-unordered = the cells of sheet `{ $sheet }` are not in ascending order (row { $row })

# Means: The file is not well-formed XML.
# Matters: The elements after this place cannot be read.
# Do: Export the file again; it was probably cut off or edited.
# Example: `<Point>` closed by `</Points>`
xml-malformed = the XML is not well-formed: { $reason }
    .hint = export the file again

entity-unknown = the entity `&{ $name };` is unknown

second-root-element = a second root element follows

# Means: The XML file contains a document type declaration.
# Matters: A document type may define entities that change the text or exhaust the memory.
# Do: Remove the declaration `<!DOCTYPE ...>`.
# Example: `<!DOCTYPE QIFDocument [<!ENTITY a "...">]>`
xml-doctype = the XML file contains a document type declaration
    .hint = remove `<!DOCTYPE ...>`: files of measurements do not need it

# Means: The file contains no test data of TraCIM.
# Matters: There is nothing to fit.
# Do: Save the answer of the server without changes.
# Example: `etalon fit --tracim features.qif`
tracim-test-missing = the file contains no test data of TraCIM
    .expected = `tracim:test` with at least one `testElement`
    .hint = save the answer of the server without changes

# Means: The test package is neither the least-squares package (Gauss) nor the minimum-zone package
# (Chebyshev).
# Matters: etalon does not know the objects and the criterion of the test.
# Do: Order a test with Gaussian or Chebyshev elements.
# Example: `<tracim:test xsi:type="thread3d-test:thread3dTestPackage">`
tracim-package-unknown = the test package `{ $package }` is unknown
    .expected = `gauss:gaussTestPackage` or `chebyshev:chebyshevTestPackage`

# Means: The test data contain no process key.
# Matters: The server uses this key to assign the answer to the test.
# Do: Save the answer of the server without changes.
# Example: a file without `<tracim:process>`
tracim-key-missing = the test data have no process key
    .expected = `tracim:process` with `tracim:key`
    .hint = save the answer of the server without changes

# Means: A coordinate of a point in a data set is missing.
# Matters: The element cannot be fitted.
# Do: Save the answer of the server without changes.
# Example: `<gauss:vectors>` without `<gauss:z>`
tracim-coordinate-missing = a point of data set `{ $id }` has no coordinate `{ $coordinate }`
    .hint = save the answer of the server without changes

# Means: Elements or blocks are nested deeper than in any file of measurements.
# Matters: The file is damaged, or is not a file of measurements.
# Do: Check that this is the right file, then export it again.
# Example: 100 nested XML elements
nested-too-deep = `{ $name }` is nested { $depth } levels deep
    .expected = at most { $most } levels
    .hint = export the file again

# Means: The file has more elements, or its features have more points, than the program can read.
# Matters: The memory is exhausted.
# Do: Export part of the features into each of several files.
# Example: a QIF file of five million elements
file-too-many-items = the file has more than { $most } { $items ->
        [elements] XML elements
       *[points] points in its features
    }
    .hint = export fewer features per file

# Means: The end of the file is missing.
# Matters: Measurements may be missing.
# Do: Export or copy the file again, and wait until the copy is complete.
# Example: a PLY file of 1000 vertices with 500 lines
file-cut-off = the file ends before { $missing }
    .hint = export or copy the file again: it is incomplete

item-of-count = `{ $name }` { $number } of { $count }

export-again-or-add = export or copy the file again; if it is complete, add the line `{ $line }`

# Means: The file does not begin like a file of the given format.
# Matters: The numbers would be read with a wrong meaning.
# Do: Run `etalon formats FILE`: it proposes the format.
# Example: `format = "ply"` for a PolyWorks text
format-differs = the file is not in format `{ $format }`
    .expected = { $signature }
    .hint = run `etalon formats FILE`: it proposes the format

begins-with = a file that begins with `{ $text }`

header-in-tabs = a tab-separated header with { $names }

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

unicode-in-hexadecimal = text, or `UNICODE( ... )` with four hexadecimal digits for each character

three-numbers = three numbers

# Means: A record of the file must follow another record that is missing.
# Matters: It is unknown to which item the record belongs.
# Do: Export the file again: a record was deleted or moved.
# Example: `K0002/1 0` before `K0001/1 12.5` in a Q-DAS file
record-too-early = `{ $record }` needs an earlier `{ $needed }`
    .hint = export the file again: a record is missing or misplaced

# Means: A record that the format requires is missing in an element of the file.
# Matters: Its value is unknown.
# Do: Change the settings of the export so that it writes this record.
# Example: a PLY file without `property float z`
record-missing = `{ $record }` is missing in `{ $parent }`
    .hint = export the file with this record

# Means: The format defines this element, but etalon does not read it.
# Matters: The points could be wrong without it.
# Do: Export the points without this element.
# Example: `BinaryPoints` in a QIF file
element-unsupported = `{ $element }` is not supported
    .hint = export the points without this element

export-points-as-text = export the points as text: QIF does not give the byte order of binary points

export-without-lists = export the points without lists

# Means: The file contains no measured points.
# Matters: There is nothing to evaluate.
# Do: Give the file that contains the measured points.
# Example: a DMIS measuring program instead of its output file
no-measured-points = the file contains no measured points{ $contents ->
        [none] {""}
       *[other] , but { $contents }
    }
    .expected = records `{ $records }`

measuring-program = a measuring program

head-of-a-run = the head of a run

output-of-program = give the output file that the program writes

calypso-head = give the `_chr` or `_fet` file from the same folder; the head contains the length unit `{ $unit }` and a workpiece temperature of { $temperature } °C

export-measured-points = export the measured points instead of the geometry of the part

export-one-dfq = export description and values in one .dfq file: a .dfd file contains no values, a .dfx file no names

fields-of-columns = { $count } fields, as many as `columns`

polyworks-fields = `x y z` or `x y z i j k`, optionally after a name

spatialanalyzer-fields = `collection, group, target, x, y, z`, or only the last five, four or three of these

three-to-eight-numbers = three to eight numbers separated by commas

propose-format = check delimiter, decimal mark and quotes of the row, and whether the file is complete; `etalon formats FILE` proposes how to read the file

quote-names = put names with blanks in quotes, or describe the file: `format = {"{"} delimiter = .., columns = .. {"}"}`

state-as-delimited = describe a file with names or tabs as delimited text: `format = {"{"} delimiter = .., columns = .. {"}"}`

state-columns = export the axes as comments, or describe the columns: format = {"{"} delimiter = "{ $delimiter }", comment = "//", columns = [{ $columns }] {"}"}

commas-in-commas = export the report with semicolons: in this file, a comma can be a decimal mark or a separator

# Means: A record has too many or too few numbers for its kind.
# Matters: The numbers cannot be assigned to coordinates, direction and diameter.
# Do: Export the file again: it was edited, or its end is missing.
# Example: `#03: 1.0 2.0` in a scan of GEOPAK-Win
number-count-differs = `{ $name }` has { $found ->
        [one] 1 number
       *[other] { $found } numbers
    }
    .expected = { $counts }
    .hint = export the file again: it was edited or cut off

three-per-point = three numbers for each point

dmis-continuation = check whether the file is complete: a record continues on the next line only if its line ends in `$`

# Means: The number of values differs from the count that the file gives.
# Matters: Values could be missing, or belong to other points.
# Do: Export the file again: it was edited, or its end is missing.
# Example: `PSET / 5` followed by 14 numbers
stated-count-differs = `{ $name }` has { $found ->
        [one] 1 value
       *[other] { $found } values
    }
    .expected = { $stated }, the count in the file
    .hint = export the file again: it was edited or cut off

# Means: The cell with the pose, the cycle or the feature of the row is empty.
# Matters: The row cannot be matched with other rows.
# Do: Complete the cell, or export the file again.
# Example: a row of a Calypso table without `featureid`
cell-empty = `{ $column }` is empty
    .hint = complete the cell, or export the file again: it was edited or cut off

# Means: The text is not a number with the given decimal mark and thousands mark.
# Matters: With the wrong mark, a value would be wrong by a factor of 1000.
# Do: Set `decimal` and `thousands` to the marks of the file, or correct the cell.
# Example: `10,5` in a file with decimal points
not-a-number = `{ $text }` is not a number
    .expected = a number with the decimal mark `{ $decimal }`{ $thousands ->
            [none] {""}
           *[other] , and `{ $thousands }` between groups of three digits
        }

number-marks = if all numbers of the file look like this, set { $first }{ $second ->
        [none] {""}
       *[other] {" "}or { $second }
    }

format-with-decimal-comma = if the file contains decimal commas, set `format = "{ $format }, decimal comma"`

# Means: A cell is empty, but the format needs a number.
# Matters: The value is unknown; zero is a guess.
# Do: Write the number into the cell, or remove the row.
# Example: `K_1;10.5;;30` in a file separated by semicolons
number-empty = a number is missing
    .expected = a number with the decimal mark `{ $decimal }`{ $thousands ->
            [none] {""}
           *[other] , and `{ $thousands }` between groups of three digits
        }

save-computed-workbook = the formula has no stored value: open the workbook in its program, and save it again

# Means: A number has more characters than any program writes.
# Matters: The file is damaged, or the given delimiter is wrong.
# Do: Check the delimiter, or export the file again.
# Example: a field of 50000 digits
number-too-long = `{ $start }...` has { $characters } characters
    .expected = a number of at most { $most } characters
    .hint = check the delimiter, or export the file again

pose-number-or-name = a whole number, or a name like `home`

whole-number = a whole number

# Means: The text is not a date with a time of day, or its day and month could be swapped.
# Matters: Points are assigned to the rows of a log by time.
# Do: Export times in one of the expected forms.
# Example: `26.11.2026 25:00:00`
time-invalid = `{ $text }` is not a date with a time of day
    .expected = a time like `11.10.2022 15:06:48.043` or `2022-10-11T15:06:48`

# Means: A quotation mark in the line is not closed, or text follows a closing quotation mark.
# Matters: The fields of the line cannot be separated.
# Do: Close the quotation mark. Write a quotation mark inside a quoted field twice.
# Example: `"ball 1,10.5,20,30`
quote-unmatched = { $fault ->
        [open] a quotation mark is not closed on its line
       *[behind] text follows a closing quotation mark
    }
    .hint = close the quotation mark; inside a quoted field, write it twice

# Means: A row that will be written begins like a comment.
# Matters: A program that reads the file skips the row.
# Do: Set another `comment`, or rename the point.
# Example: a label `#1` with `comment = "#"`
row-is-comment = the row `{ $row }` would be read as a comment
    .hint = set another `comment`

state-column-number = give the number of the column instead of its name

# Means: The file contains rows after the line that ends the data.
# Matters: It is unknown whether they are measurements.
# Do: Remove the rows, or remove the line that ends the data.
# Example: points after the line `END` of a Calypso table
rows-after-end = rows follow `{ $end }`, the end of the data
    .hint = remove these rows, or `{ $end }`

# Means: A row contains a coordinate type that `types` does not describe.
# Matters: Its numbers could be angles or lengths.
# Do: Add the type to `types`, with its three coordinates.
# Example: type 3 where `types` gives 0 and 7
coordinate-type-unknown = `types` does not describe the coordinates of type `{ $name }`
    .expected = { $known }
    .hint = add the type to `types`

# Means: The coordinates in the file are not Cartesian, and the format does not define their columns
# and units.
# Matters: Angles are read as lengths.
# Do: Change the export to Cartesian coordinates.
# Example: `// AXES = SPHERICAL: R, T, P` in a SpatialAnalyzer export
coordinates-not-cartesian = the coordinates are `{ $found }`
    .expected = Cartesian coordinates: { $cartesian }
    .hint = export Cartesian coordinates

export-cartesian-or-columns = export Cartesian coordinates, or describe the columns: format = {"{"} delimiter = ",", comment = "//", columns = [{ $columns }], angle_unit = "deg" {"}"}

# Means: Some points of a feature are in another coordinate system than the first points, or have
# only two dimensions.
# Matters: Points of two coordinate systems cannot be combined.
# Do: Export all points of the feature in one coordinate system, in three dimensions.
# Example: `"Circle 1: 2D MCS Points"` in an InSpec export
coordinate-system-differs = the points of `{ $feature }` are in `{ $found }`
    .expected = `{ $needed }`
    .hint = export all points in one coordinate system

# Means: All rows have two small angles and one length in the columns x, y and z.
# Matters: Spherical coordinates that are read as Cartesian ones give points on a line.
# Do: Describe the columns as angles and distance. If they really are Cartesian, set `coordinates =
# "cartesian"`.
# Example: a tracker's export `K_1 0.7853 1.5707 3000.0` with `columns = ["label", "x", "y", "z"]`
coordinates-look-spherical = x, y and z look like azimuth (rad), zenith (rad) and distance
    .expected = Cartesian coordinates: all rows have two small angles and one length
    .hint = set the columns "azimuth", "zenith", "distance" with `angle_unit = "rad"`, or `coordinates = "cartesian"`

# Means: Some cells of the orientation in a row are empty.
# Matters: The orientation is undefined.
# Do: Complete the orientation, or empty all its cells.
# Example: a quaternion with `qw`, `qx`, `qy` and an empty `qz`
orientation-incomplete = { $found } of { $needed } numbers of the orientation are given
    .hint = complete the orientation, or empty all its cells

# Means: The three numbers of a direction do not have the length 1.
# Matters: The numbers are probably another quantity, for example angles in degrees.
# Do: If they are another quantity, skip the columns with "-". Otherwise export unit vectors.
# Example: `i`, `j`, `k` with the values 90, 90, 0
direction-not-unit = the direction ({ $i }, { $j }, { $k }) has the length { FIXED($length, 3) }
    .expected = a unit vector

skip-columns = if the columns are another quantity, skip them with "-"

skip-direction-angles = skip the columns with "-": they are the angles of the direction (deg)

# Means: The direction of a feature is zero.
# Matters: The feature has no orientation.
# Do: Export the feature again, or remove it.
# Example: `<Normal>0 0 0</Normal>` in a QIF file
direction-zero = the direction `{ $direction }` has no length
    .expected = three numbers, not all zero

# Means: The file writes directions in another notation than the given format.
# Matters: If angles are read as unit vectors, or unit vectors as angles, the directions are wrong.
# Do: Use the format in the hint.
# Example: `90, 90, 0` as direction with `format = "dmis"`
direction-notation-differs = the direction is written as { $found ->
        [angles] angles (deg)
       *[vector] a unit vector
    }
    .expected = { $found ->
            [angles] a unit vector, as in DMIS
           *[vector] angles (deg), as written by GEOPAK
        }
    .hint = set `format = "{ $format }"`

# Means: The file contains another unit of length than the campaign or the command.
# Matters: All coordinates are wrong by a constant factor.
# Do: Set `unit` to the unit of the file. If the file itself is wrong, correct its heading.
# Example: `unit = "inch"` for a DMIS file with `UNITS/MM`
unit-differs = the file is in { $of_file } ({ $how }); the given unit is { $stated }
    .hint = set the unit of the file; if the heading of the file is wrong, correct it there

default-of-format = no `{ $record }`: default of the format

# Means: The unit in the file is not a unit of this quantity.
# Matters: The scale of the values is unknown.
# Do: Change the settings of the export to one of the expected units.
# Example: `UNITS/FEET` in a DMIS file
unit-unknown = `{ $unit }` is not a known unit
    .expected = { $units }
    .hint = export the file in one of these units

# Means: The file does not contain its unit, and no other place gives it.
# Matters: A guessed unit falsifies every result.
# Do: Give the unit of lengths with `unit` or `--unit`. Export a file with angles again with its
# units.
# Example: `etalon fit plane part.qif` for a file without `FileUnits`
file-unit-missing = the file does not give its unit of { $quantity ->
        [length] length
       *[angle] angle
    }
    .expected = `{ $record }` with its factor in `FileUnits/PrimaryUnits`
    .hint = { $quantity ->
        [length] set `unit` of the export, or add `--unit`
       *[angle] export the file with its units
    }

# Means: The factor of a unit in a QIF file is zero or negative, or the unit has an offset.
# Matters: Units of length and angle have a positive factor and no offset.
# Do: Export the file again with valid units.
# Example: `<Factor>0</Factor>`
unit-factor-invalid = the unit has the factor { $factor } and the offset { $offset }
    .expected = a positive factor, no offset

# Means: Files of this format cannot have the given unit.
# Matters: Other programs would read the simulated file with a wrong unit.
# Do: Choose one of the units of the format.
# Example: `etalon simulate` with `format = "pcdmis_xyz"` and `unit = "m"`
format-without-unit = format `{ $format }` cannot have the unit { $unit }
    .expected = { $units }
    .hint = choose one of these units

# Means: `etalon simulate` cannot write this format or dialect.
# Matters: The simulated campaign has no export.
# Do: Change the format of this export as the hint shows.
# Example: `format = "qif"` in a campaign that is simulated
format-not-simulated = `etalon simulate` cannot write { $kind ->
        [fixed] fixed widths or workbooks
        [types] rows with a coordinate type
        [numbers] columns that are given by their number
       *[qif] QIF
    }
    .hint = { $kind ->
        [fixed] set a `delimiter` for this export
        [types] set `columns` with one coordinate type
        [numbers] give the names of the columns
       *[qif] set `format = "polyworks"` or a delimited format for this export
    }

# Means: The pattern of labels has an error.
# Matters: Target, pose and cycle cannot be read from the labels.
# Do: Use `{"{"}target{"}"}`, `{"{"}pose{"}"}` and `{"{"}cycle{"}"}`, each at most once.
# Example: `label = "{target}_{pos}"`
label-pattern-invalid = { $fault ->
        [open] `{ $pattern }` contains a `{"{"}` without `{"}"}`
        [unknown] `{ $pattern }` contains the unknown name `{ $name }`
       *[twice] `{ $pattern }` contains `{ $name }` twice
    }
    .expected = text with {"{"}target{"}"}, {"{"}pose{"}"} and {"{"}cycle{"}"}, each at most once
    .hint = correct `label`

state-encoding = set the encoding of the file: it was read with a wrong encoding

# Means: A Q-DAS file contains several data sets.
# Matters: Characteristics of different workpieces have the same numbers in it.
# Do: Split the file into one file for each data set, and write an [[export]] for each.
# Example: two fields `K0100` in one .dfq file
several-data-sets = a second `{ $record }`: the file contains several data sets
    .hint = split it into one file for each data set, and write an [[export]] for each

# Means: The index of a field in a Q-DAS file is larger than the count in K0100.
# Matters: The file is incomplete, or was combined from several files.
# Do: Export the data set again into its own file.
# Example: `K2002/7` after `K0100 6`
characteristic-beyond-count = characteristic { $index } does not exist: the number of characteristics in K0100 is { $count }
    .hint = export the file again: it was edited or combined from several files

# Means: A characteristic has a value for this workpiece, but none for an earlier workpiece.
# Matters: Coordinates of different workpieces are combined into one point.
# Do: Change the export: write a value with the attribute 255 (K0002) if it was not measured.
# Example: a value of `Ball 1.Y` for workpiece 2 and none for workpiece 1
value-of-piece-missing = value { $number } of `{ $name }` belongs to workpiece { $piece }: an earlier value is missing
    .hint = export missing values with the attribute 255 (K0002)

# Means: The coordinates of a point have different numbers of values.
# Matters: Coordinates of different workpieces are combined into one point.
# Do: Change the export: write a value with the attribute 255 (K0002) if it was not measured.
# Example: three values of `Ball 1.X` and two of `Ball 1.Y`
coordinate-counts-differ = `{ $name }` has { $found ->
        [one] 1 value
       *[other] { $found } values
    }; another coordinate of the point has { $count }
    .hint = export missing values with the attribute 255 (K0002)

# Means: The word `METRIC` is in the first line, but not in columns 11 to 16.
# Matters: PC-DMIS reads the unit from these columns only. Here they mean inches, but the word means
# millimetres.
# Do: Ask the author of the file for the unit, then correct line 1.
# Example: `XYZIJK METRIC` with one blank
metric-misplaced = `METRIC` is outside of columns 11 to 16: the unit is ambiguous (inch or mm)
    .expected = `XYZIJK    METRIC`, or `XYZIJK` alone for inches
    .hint = correct line 1, or read the file as delimited text with its unit

# Means: A vertex of a PLY file is infinite or undefined.
# Matters: It is not a measured point.
# Do: Export only the measured points.
# Example: a binary PLY file whose first x is NaN
vertex-not-finite = vertex { $number } is { $coordinates }
    .expected = finite coordinates
    .hint = export only the measured points

# Means: Columns 73 to 80 contain eight digits, but these are not the number of the line.
# Matters: The digits could be part of a coordinate.
# Do: Export the file without line numbers.
# Example: `00000041` in line 42 of a VDA-FS file
line-number-differs = columns 73 to 80 contain `{ $digits }`: a line number or a value
    .expected = `{ $number }`, the number of this line
    .hint = export the file without line numbers

feature-without-points = `{ $feature }` has no usable points: { $message }

# Means: Some points of a feature are contact points, others are probe centres, or the probes
# differ.
# Matters: The fitted element can be corrected for a single probe radius only.
# Do: Fit the points of each probe separately.
# Example: a cylinder measured with two probes
compensation-mixed = the points of the feature have different probe compensation
    .hint = fit the points of each probe separately

# Means: An element refers to another element that the file does not contain.
# Matters: Points or names of the feature are missing.
# Do: Export the file again: it was edited, or its end is missing.
# Example: `<WholePointSetId>7</WholePointSetId>` without a point set 7
reference-broken = `{ $name }` refers to { $id }, which is not a `{ $kind }` of this file

# Means: Points of a feature are in another QIF document.
# Matters: The program reads a single file, so the feature has no points.
# Do: Export the feature and its points in one document.
# Example: `<WholePointSetId xId="2">7</WholePointSetId>`
reference-external = point set { $id } is in another document
    .hint = export the feature and its points in one document

# Means: The range of points is not within the point set.
# Matters: The points of the feature are unknown.
# Do: Export the file again: the range was edited.
# Example: `range="90 110"` of a set of 100 points
point-range-invalid = `{ $range }` is not a range of point set { $id } (line { $line })
    .expected = whole numbers from 1 to { $count }, the smaller first

# Means: No feature refers to a point set of the file.
# Matters: These points have no influence.
# Do: Check whether a feature is missing in the export.
# Example: a scanned surface without a feature
point-set-unused = no feature refers to point set { $id }

# Means: Two elements of the file have the same id.
# Matters: A reference could mean either element; the first one is used.
# Do: Export the file again: it was combined from several files.
# Example: two elements with `id="5"`
id-repeated = id { $id } is used twice, first in line { $line }: references use the first one
    .hint = export the file again: it was combined from several files

# Means: The file causes more messages than the program shows.
# Matters: The other messages may have other causes.
# Do: Remove the causes of these messages, and read the file again.
# Example: a QIF file with 60 repeated ids
further-messages = { $count ->
        [one] 1 further message
       *[other] { $count } further messages
    } about this file

# Means: The recording (MCAP) is damaged or not finished.
# Matters: All messages after the damage are missing.
# Do: Try `mcap recover`, or copy the recording again.
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

# Means: `topic` is given for a file that is not a recording of ROS 2.
# Matters: Only recordings of ROS 2 (`.mcap` or `.db3`) have topics.
# Do: Give the `.mcap` or `.db3` file in the folder of the recording. For a file without topics,
# omit `topic`.
# Example: `topic = "/joint_states"` for a CSV file
recording-missing = the file is not a recording of ROS 2, so it has no topic `{ $topic }`
    .hint = give the .mcap or .db3 file in the folder of the recording, or omit `topic`

# Means: The file is a recording of ROS 2 with several topics, and `topic` is missing.
# Matters: It is unknown which messages contain the measurements or the joint values.
# Do: Run `etalon formats FILE` to list the topics, and set `topic`.
# Example: a log with `file = "run_0.mcap"` without `topic`
topic-not-stated = the file is a recording of ROS 2, and `topic` is missing

# Means: The recording contains no message of this topic.
# Matters: There is nothing to read.
# Do: Use one of the topics that `etalon formats FILE` lists.
# Example: `topic = "/joint_state"` for the topic `/joint_states`
topic-missing = the recording contains no message of topic `{ $topic }`

# Means: The messages of the topic exceed the maximum size in memory.
# Matters: The recording cannot be read as one table.
# Do: Shorten the recording to the time of the measurements, with `ros2 bag convert` or `mcap
# filter`.
# Example: a day of joint values at 1 kHz
topic-too-large = the messages of topic `{ $topic }` are larger than { $most_mib } MiB
    .hint = shorten the recording to the time of the measurements: `mcap filter FILE -o SHORTER --start SECONDS --end SECONDS`

# Means: etalon reads no joint values or coordinates from messages of this type.
# Matters: The topic cannot be used as a log or as an export.
# Do: Use a topic whose messages have one of the expected types.
# Example: `topic = "/tf"`
topic-type-unknown = topic `{ $topic }` has messages of type `{ $message }`
    .expected = { $known }
    .hint = use the topic of the joint values or of the measured poses: `etalon formats FILE` lists the topics

# Means: The messages are not in CDR, the encoding of ROS 2.
# Matters: Their numbers cannot be read.
# Do: Convert the recording to ROS 2 with `rosbags-convert`.
# Example: a recording of ROS 1 that was converted to MCAP
topic-encoding-unknown = the messages of topic `{ $topic }` have the encoding `{ $encoding }`
    .expected = `cdr`, the encoding of ROS 2
    .hint = convert the recording to ROS 2: `rosbags-convert --src FILE --dst FOLDER --dst-storage mcap`

# Means: A message does not have the layout of its type.
# Matters: The numbers in the message cannot be read.
# Do: Record again without `--compression-mode message`, and with the standard definition of the
# message.
# Example: `ros2 bag record --compression-mode message`
ros-message-malformed = message { $number } of topic `{ $topic }` does not have the layout of its type
    .hint = record without `--compression-mode message`; convert an existing recording with `ros2 bag convert`

# Means: A JointState message contains more or fewer positions than names.
# Matters: It is unknown which joint a position belongs to.
# Do: Correct the node that publishes the topic: it must publish one position for each name.
# Example: seven names, and six positions because the gripper has none
joint-state-lengths-differ = message { $number } of topic `{ $topic }` contains { $names } names of joints and { $positions } positions
    .expected = a position for each name, or no position
    .hint = correct the node that publishes the topic

# Means: A JointState message contains the name of a joint twice.
# Matters: It is unknown which of the two positions is right.
# Do: Find out which node publishes this message (`ros2 topic info --verbose TOPIC`), and correct
# it.
# Example: the driver merges the arm with itself
joint-state-name-twice = message { $number } of topic `{ $topic }` contains the joint `{ $joint }` twice
    .hint = correct the node that publishes the topic

# Means: All JointState messages of the topic have an empty list of positions.
# Matters: The topic contains only velocities or efforts.
# Do: Use the topic with the measured positions.
# Example: the topic of commands `/joint_commands` instead of `/joint_states`
topic-without-positions = no message of topic `{ $topic }` has positions ({ $count ->
        [one] 1 message
       *[other] { $count } messages
    })
    .hint = give the topic with the measured positions: `etalon formats FILE` lists the topics

ros-messages-of-other-joints = { $count ->
        [one] message
       *[other] first of { $count } messages
    } without any of the joints in `columns`: published by another node

# Means: The recording contains no topic with joint values, poses or points that etalon can read.
# Matters: There are no measurements, or their messages have another type.
# Do: Record a topic of the type JointState, PoseStamped or PointStamped.
# Example: a recording of the topic `/rosout` alone
recording-without-known-topics = the recording has no topic with joint values, poses or points: { $found }
    .expected = sensor_msgs/JointState, geometry_msgs/PoseStamped or geometry_msgs/PointStamped
    .hint = record a topic of one of these types

# Means: The file contains no numeric array with this name, or the index is not in the notation of
# MATLAB or Python.
# Matters: The column cannot be read.
# Do: Run `etalon formats FILE` to list the arrays.
# Example: `q1_rad = "Q(:,1)"` for the variable `q`
array-missing = the file contains no numeric array `{ $column }`

# Means: The index selects more than one column or row of an array.
# Matters: It is unknown which numbers form the column.
# Do: Select one column in the notation of MATLAB or Python.
# Example: `q1_rad = "q"` for a matrix of six columns
array-part-unknown = `{ $column }` selects more than one column: `{ $name }` is { $shape }
    .hint = select one column in the notation of the file: `{ $example }`

# Means: Two columns of a log have different lengths.
# Matters: It is unknown which values belong together.
# Do: Use arrays of one recording with the same number of values.
# Example: times at 1 kHz and joint values at 100 Hz
array-lengths-differ = `{ $first }` has { $count } numbers and `{ $second }` has { $other }
    .expected = columns of equal length
    .hint = use arrays of one recording; if the columns of a matrix are the times, select its rows as joints

# Means: The file is damaged, or has another format than stated.
# Matters: Its numbers cannot be read.
# Do: Save the file again.
# Example: a copy that was interrupted
arrays-unreadable = the file cannot be read as arrays of { $format ->
        [numpy] NumPy (.npz, .npy)
        [kuka_trace] KUKA.Trace (.dat with channels, and .r64)
       *[matlab] MATLAB (.mat of -v6 or -v7)
    }
    .hint = save it again, or correct `format`

# Means: The header of the data set names a file for its numbers, and the folder of the header lacks this file.
# Matters: The header contains no joint values.
# Do: Copy all files of the trace into one folder, with their names unchanged.
# Example: `log_KRCIpo.dat` without `log_KRCIpo.r64`
numbers-file-missing = `{ $file }` is missing: the header contains no numbers
    .hint = copy all files of the recording into one folder

# Means: The trace of a drive contains the position of its motor, before the gear.
# Matters: Ratio and direction of the gear are unknown, so that the values are no joint values.
# Do: Use the file of the interpolator of the same trace: its name ends in `_KRCIpo.dat`.
# Example: `q1_deg = "Istposition"` of `log_NextGenDrive#1.dat`
trace-of-motor = `Istposition` and `Sollposition` are positions of a motor, not of a joint
    .hint = use the trace `..._KRCIpo.dat`, with `q1_deg = "AxisPos_Act1"`

# Means: A channel is stored as text, or as a type of numbers that etalon does not know.
# Matters: Its values cannot be read.
# Do: Save the data set with channels of type REAL64, or convert it to CSV.
# Example: `214,ASCII` in the header
trace-storage-unknown = channel `{ $channel }` is stored as `{ $storage }`
    .expected = REAL64, REAL32, INT32, INT16, WORD32 or WORD16
    .hint = save the data set with REAL64, or convert it to CSV

# Means: The header states more values than the file of numbers contains.
# Matters: The recording or its copy was interrupted, or the file belongs to another header.
# Do: Copy the files of the trace again.
# Example: 500 values are stated, and the file ends after 320
trace-values-missing = the file of numbers has fewer than the { $count } values of channel `{ $channel }`
    .hint = copy the files of the trace again

# Means: The file is a workbook, and no sheet is given.
# Matters: A workbook may have several sheets.
# Do: Set `sheet`: in `format` of an [[export]], otherwise in the section of the table.
# Example: `file = "joints.xlsx"` without `sheet`
sheet-not-stated = the file is a workbook, and `sheet` is missing; its sheets are { $sheets }
    .hint = set `sheet`

state-sheet = set `sheet = "{ $sheet }"` (option --sheet)

state-column = if it is the column `{ $heading }`, set `columns = {"{"} { $column } = "{ $heading }" {"}"}` (option --column)
state-column-of = state its heading: `columns = {"{"} { $column } = "HEADING" {"}"}` (option --column); headings that nothing reads: { $names }
state-column-in-unit = if it is the column `{ $heading }`, set `columns = {"{"} { $column } = "{ $heading }" {"}"}` (option --column): its values suggest { $unit }
state-columns-together = set `columns = {"{"} { $columns } {"}"}` (option --column)
row-marked-deleted = excluded: it is marked as deleted (`{ $cell }`)
row-left-out-by-cell = excluded: `{ $column }` is `{ $cell }`
row-without-coordinates = not measured: no coordinates
row-cell-empty = not measured: { $column } is empty
row-invisible = not measured: 0 0 0 with the quaternion 0 0 0 0
row-not-measured = not measured: { $column } is `{ $cell }`
characteristic-of-no-axis = not a coordinate: the name of the characteristic does not end in X, Y or Z
feature-of-no-point = a feature `{ $kind }`: it does not define a single point
feature-not-read = a feature `{ $kind }`: etalon does not read this kind
point-incomplete = not a point: { $found } without { $missing }
probe-centre-no-point = a probe centre, not a contact point

log-delimited = delimited by `{ $delimiter }`, decimal `{ $decimal }`
log-of-arrays = arrays of { $format }
log-of-sheet = workbook, sheet `{ $sheet }`
log-of-topic = ROS recording, topic `{ $topic }`
log-of-format = { $format }, { $read }
log-with-start = { $read }, starts at { $start }
read-with-decimal-comma = { $format }, decimal `,`

value-without-label = a value without a label
primitive-no-point = a primitive of type `{ $kind }`, not a point

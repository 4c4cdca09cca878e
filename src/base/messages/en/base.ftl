### Messages of base. Above each message: its explanation (see CONTRIBUTING.md, "A message").

also-in-lines = { $message }; also in lines { $second }, { $third } and { $more ->
        [one] 1 more row
       *[other] { $more } more rows
    }

did-you-mean = did you mean `{ $name }`?

expected-whole-number = expected a whole number from 0 to { $most }
is-a-folder = it is a folder
meant-in-unit = convert to `{ $name }`: 1 { $from } is { $factor } { $to }

known-names = use one of: { $names }

known-names-first = use one of: { $names }, ...

no-regular-file = it is a pipe, a socket or a device, expected a regular file
# Means: A pose has an empty name.
# Matters: Poses are matched by their names between exports, logs and plans.
# Do: Give the pose a number or a name.
# Example: an empty cell in the column `pose`
pose-name-empty = the name of the pose is empty
    .expected = a whole number, or a name like `home` or `A-3`

# Means: The name of a pose has more characters than a table can show.
# Matters: A name of this length is usually a wrong column, for example a comment.
# Do: Read the name from another column, or shorten it.
# Example: a comment of 300 characters in the column `pose`
pose-name-too-long = the name of the pose has { $characters } characters
    .expected = at most { $most } characters: a whole number, or a name like `home` or `A-3`

# Means: The name of a pose holds a control character or begins like a formula of a spreadsheet.
# Matters: Tables with this name would be read wrongly, or executed by a spreadsheet.
# Do: Rename the pose.
# Example: `=1+1` in the column `pose`
pose-name-unprintable = a table cannot hold the name `{ $name }`
    .expected = a whole number, or a name like `home` or `A-3`

# Means: Two names of poses differ only in capital letters, blanks, `_`, `-`, leading zeros or
# characters that are not visible, such as a zero-width space.
# Matters: They are probably one pose. Two poses with half of the readings each falsify
# repeatability.
# Do: Write the name of a pose the same in all rows and files.
# Example: `P1` in one row, `p 01` in another
pose-name-two-spellings = `{ $first }` and `{ $second }` differ only in capital letters, blanks, `_`, `-`, zeros or invisible characters
    .hint = write the name of a pose the same in all rows and files

# Means: The product of the stated counts exceeds the limit of the program.
# Matters: The computation would take hours or exhaust the memory.
# Do: Reduce one of the counts.
# Example: 1000000 cycles of 1000 poses
counts-too-large = too many { $of }: { $counts }
    .expected = at most { $most }

# Means: The operating system refused to read a file.
# Matters: Without the file the command cannot run.
# Do: Check the path, the permissions and whether another program holds the file.
# Example: `file = "exports/poses.txt"` where the file is missing
cannot-read-file = cannot read `{ $file }`: { $reason }

# Means: A file exceeds the maximum size.
# Matters: A larger file is usually not the intended one, and would exhaust the memory.
# Do: Export the measurements without point clouds, or split the file.
# Example: a log of 5 GiB
file-too-large = cannot read `{ $file }`: it is larger than { $most_mib } MiB

# Means: A text file has bytes that are not UTF-8.
# Matters: Names with accents would be read wrongly.
# Do: Save the file as UTF-8.
# Example: `campaign.toml` saved in Windows-1252 with an umlaut
not-utf8 = `{ $file }` is not UTF-8 (byte { $byte })
    .hint = save the file as UTF-8

# Means: The operating system refused to write a file.
# Matters: The result is not stored.
# Do: Check the folder, the permissions and the free space of the disk.
# Example: `--output /no-such-folder/file`
cannot-write-file = cannot write `{ $file }`: { $reason }

# Means: The file to be written already exists.
# Matters: The command never replaces files that it did not write itself.
# Do: Name a new folder or remove the file.
# Example: `etalon init` twice with the same folder
file-exists = `{ $file }` already exists
    .hint = name a new folder

# Means: The name of the lock file is taken by a folder, a link or a device.
# Matters: Without its lock two processes could write the same result.
# Do: Remove the folder, link or device that has the name of the lock.
# Example: a symbolic link `out.lock` beside the output folder `out`
lock-foreign = cannot write `{ $file }`: `{ $lock }` is not a lock of etalon
    .expected = a regular file without other hard links
    .hint = remove it: etalon needs this name for its lock

# Means: A symbolic link leads to the place that would be written.
# Matters: Files of another folder could be overwritten or lose their mode and owner.
# Do: Replace the link by a folder, or name the folder itself.
# Example: a symbolic link `out` in the folder of a campaign
output-through-link = cannot write `{ $file }`: `{ $link }` is a symbolic link
    .expected = a folder or file that no link leads to
    .hint = replace the link by a folder, or name the folder itself

# Means: The place that would be written is a device, a pipe or a socket.
# Matters: etalon replaces files as a whole; a device would be lost.
# Do: Name a file; without the option many commands print to stdout.
# Example: `etalon plan --output /dev/null`
output-not-a-file = cannot write `{ $file }`: it is a device, a pipe or a socket
    .hint = name a regular file

# Means: A template exceeds the limit of time or memory, or ends without a result.
# Matters: No file is written. The usual cause is a loop that does not end.
# Do: Correct the template.
# Example: `{% for i in range(10000000) %}` in report.html
template-failed = the template `{ $template }` { $fault ->
        [time] takes more than a minute
        [memory] needs more than 2 GiB of memory
        [ended] ends without a result
       *[other] cannot be run: { $fault }
    }
    .hint = check the loops of the template: each must end

# Means: Brackets, operators or blocks of a template are nested too deeply.
# Matters: The template is not read: each level takes memory of the stack.
# Do: Compute parts of the expression with `set`, one after the other.
# Example: an expression with 300 opening brackets
template-too-nested = line { $line } of the template `{ $template }` has more than { $most } levels of brackets, operators and blocks
    .hint = split the expression with `set`

template-width = a width of more than { $most }
template-size = a text of more than { $most_mib } MiB
template-instructions = more than { $most } instructions

# Means: The variable SOURCE_DATE_EPOCH has a value that is not a time.
# Matters: Reports without a date of their own would have a wrong date.
# Do: Set it to the seconds since 1970, or unset it.
# Example: `SOURCE_DATE_EPOCH=-1`
environment-date = the environment variable `SOURCE_DATE_EPOCH` is `{ $value }`
    .expected = the seconds since 1970, from 0 to the year 9999
    .hint = set it to a whole number, or unset it

# Means: A variable states a number of threads that the program cannot start.
# Matters: The command would take minutes to start its threads, or end without memory.
# Do: Set a number near that of the cores, or unset the variable.
# Example: `POLARS_MAX_THREADS=1000000`
environment-threads = the environment variable `{ $name }` is `{ $threads }`
    .expected = at most { $most } threads
    .hint = set the number of cores, or unset the variable

# Means: Another process is writing the same file.
# Matters: Two processes would mix their results.
# Do: Wait until the other process has ended.
# Example: two runs of one campaign at the same time
locked = process { $process } is writing `{ $file }`
    .hint = wait until it has ended

# Means: An output file is one of the files that the command reads.
# Matters: The measurements would be lost.
# Do: Name another output file.
# Example: `etalon plan --poses poses.csv --output poses.csv`
output-is-input = `{ $output }` would overwrite the input `{ $input }`
    .hint = name another output file

# Means: The operating system refused to write the output folder.
# Matters: The earlier folder is unchanged; the new result is not stored.
# Do: Check the permissions and the free space, and close programs that hold files of the folder.
# Example: a file in place of the output folder
cannot-write-folder = cannot write the folder `{ $folder }`: { $reason }

# Means: A document cannot be written in its format.
# Matters: No file is written.
# Do: Report the error as a defect of etalon.
# Example: a value that JSON cannot hold
cannot-encode = cannot write { $format }: { $reason }

# Means: The text is not an order of three angles.
# Matters: The orientation depends on the order of the three rotations.
# Do: State three axes in the order of the rotations; `fixed` denotes the axes of the world.
# Example: `orientation = "zxz fixed"`
angle-order-unknown = `{ $text }` is not an order of three angles
    .expected = "zyx", "xyz", "zyz" .. about the axes of the body, or "fixed xyz" .. about the axes of the world

pose-number-too-large = the number of a pose is above 9223372036854775807
# Means: The nine elements do not form a rotation matrix.
# Matters: The columns may be exchanged, rounded, or scaled.
# Do: Check the columns r11 to r33.
# Example: r11 = 2
rotation-not-orthonormal = the rotation matrix is not orthonormal: products of its rows differ from 1 and 0 by { $off }
    .expected = r11 to r33, row by row: orientation of the body in the world

# Means: The determinant of a rotation matrix is -1.
# Matters: A body cannot be mirrored: a frame is left-handed or a sign is wrong.
# Do: Check the signs of the columns.
# Example: a matrix with one column negated
rotation-mirrors = the rotation matrix is a reflection: its determinant is -1
    .hint = check the signs of its columns

factor = { $count } { $of ->
        [poses] poses
        [cycles] cycles
        [repeats] repeats
        [draws] draws
       *[runs] runs
    }
product = { $first } × { $second }
unknown-country = unknown country code `{ $code }`, expected two capital letters of ISO 3166-1, as CA, DE or GB

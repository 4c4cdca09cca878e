### Messages of base. Above each message: its explanation (see CONTRIBUTING.md, "A message").

also-in-lines = { $message }; also in lines { $second }, { $third } and { $more ->
        [one] 1 more row
       *[other] { $more } more rows
    }

did-you-mean = did you mean `{ $name }`?

expected-whole-number = expected a whole number from 0 to { $most }
is-a-folder = it is a folder
meant-in-unit = convert to `{ $name }`: 1 { $from } is { $factor } { $to }

name-without-unit = add the unit: { $names }

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
# Matters: Such a long name is usually the text of a wrong column, for example a comment.
# Do: Read the name from another column, or shorten it.
# Example: a comment of 300 characters in the column `pose`
pose-name-too-long = the name of the pose has { $characters } characters
    .expected = at most { $most } characters: a whole number, or a name like `home` or `A-3`

# Means: The name of a pose contains a control character, or begins like a formula of a spreadsheet.
# Matters: A spreadsheet could run the name as a formula, and other programs could read the table
# wrongly.
# Do: Rename the pose: use letters, digits, `_` and `-`.
# Example: `=1+1` in the column `pose`
pose-name-unprintable = the name `{ $name }` cannot be written to a table
    .expected = a whole number, or a name like `home` or `A-3`

# Means: Two names of poses differ only in capital letters, blanks, `_`, `-`, leading zeros or
# characters that are not visible, such as a zero-width space.
# Matters: They probably mean one pose. If its readings are split between two names, the
# repeatability of both is wrong.
# Do: Choose one spelling, and use it in the exports, the log and the plan.
# Example: `P1` in one row, `p 01` in another
pose-name-two-spellings = `{ $first }` and `{ $second }` differ only in capital letters, blanks, `_`, `-`, zeros or invisible characters
    .hint = write the name of a pose the same in all rows and files

# Means: The product of the given counts (cycles, poses, repeats or draws) exceeds the limit of the
# program.
# Matters: The computation takes hours or exhausts the memory.
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
# Matters: Such a file is usually not the intended one, and it exhausts the memory.
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
# Do: Give the name of a new folder, or delete the old one if you do not need it any more.
# Example: `etalon init` twice with the same folder
file-exists = `{ $file }` already exists
    .hint = give the name of a new folder

# Means: The name of the lock file is used by a folder, a link or a device.
# Matters: Without its lock two processes could write the same result.
# Do: Check why this file exists, then remove it or rename it.
# Example: a symbolic link `out.lock` next to the output folder `out`
lock-foreign = cannot write `{ $file }`: `{ $lock }` is not a lock of etalon
    .expected = a regular file without other hard links
    .hint = remove it: etalon needs this name for its lock

# Means: The output path is a symbolic link, or contains one.
# Matters: Through a link, the command could overwrite files in another folder, or change their mode
# and owner.
# Do: Replace the link with a folder, or give the path of the folder to which the link points.
# Example: a symbolic link `out` in the folder of a campaign
output-through-link = cannot write `{ $file }`: `{ $link }` is a symbolic link
    .expected = a path without symbolic links
    .hint = replace the link with a folder, or give the path of the folder to which it points

# Means: The output path is a device, a pipe or a socket.
# Matters: etalon replaces the whole file. It does not replace a device.
# Do: Give the name of a regular file. Without the option, many commands print to stdout.
# Example: `etalon plan --output /dev/null`
output-not-a-file = cannot write `{ $file }`: it is a device, a pipe or a socket
    .hint = give the name of a regular file

# Means: A template exceeds the limit of time or memory, or ends without a result.
# Matters: No file is written. The usual cause is a loop that does not end.
# Do: Look for a loop over a very long list in the template, and shorten it.
# Example: `{% for i in range(10000000) %}` in report.html
template-failed = the template `{ $template }` { $fault ->
        [time] takes more than a minute
        [memory] needs more than 2 GiB of memory
        [ended] ends without a result
       *[other] cannot be run: { $fault }
    }
    .hint = check the loops of the template: each must end

# Means: Brackets, operators or blocks of a template are nested too deeply.
# Matters: Each level needs stack memory, so the template is rejected before it runs.
# Do: Compute parts of the expression in separate `set` statements.
# Example: an expression with 300 opening brackets
template-too-nested = line { $line } of the template `{ $template }` has more than { $most } levels of brackets, operators and blocks
    .hint = split the expression: compute its parts with `set`

template-width = a width of more than { $most }
template-size = a text of more than { $most_mib } MiB
template-instructions = more than { $most } instructions

# Means: The environment variable SOURCE_DATE_EPOCH is not a time.
# Matters: Reports of campaigns without a date would show a wrong date.
# Do: Set the variable to the number of seconds since 1970, or unset it.
# Example: `SOURCE_DATE_EPOCH=-1`
environment-date = the environment variable `SOURCE_DATE_EPOCH` is `{ $value }`
    .expected = the seconds since 1970, from 0 to the year 9999
    .hint = set the variable to a whole number, or unset it

# Means: An environment variable asks for more threads than the program can start.
# Matters: The command would take minutes to start its threads, or end without memory.
# Do: Set the variable to the number of processor cores, or unset it.
# Example: `POLARS_MAX_THREADS=1000000`
environment-threads = the environment variable `{ $name }` is `{ $threads }`
    .expected = at most { $most } threads
    .hint = set the variable to the number of processor cores, or unset it

# Means: Another process is writing the same file.
# Matters: If two processes write the same file, their results are mixed.
# Do: Wait until the process with this number has ended, then repeat the command.
# Example: two runs of one campaign at the same time
locked = process { $process } is writing `{ $file }`
    .hint = wait until it has ended

# Means: An output file is one of the files that the command reads.
# Matters: Otherwise the measurements are lost.
# Do: Give an output path that is not one of the input files.
# Example: `etalon plan --poses poses.csv --output poses.csv`
output-is-input = `{ $output }` would overwrite the input `{ $input }`
    .hint = give another output file

# Means: The operating system refused to write the output folder.
# Matters: The earlier folder is unchanged; the new result is not stored.
# Do: Check the permissions and the free space, and close programs that hold files of the folder.
# Example: a file that has the name of the output folder
cannot-write-folder = cannot write the folder `{ $folder }`: { $reason }

# Means: A document cannot be written in its format.
# Matters: No file is written.
# Do: Report the error as a defect of etalon.
# Example: a value that JSON cannot represent
cannot-encode = cannot write { $format }: { $reason }

# Means: The text is not an order of three angles.
# Matters: The orientation depends on the order of the three rotations.
# Do: Give three axes in the order of the rotations. Put `fixed` first if the axes are the axes of
# the world.
# Example: `orientation = "zxz fixed"`
angle-order-unknown = `{ $text }` is not an order of three angles
    .expected = "zyx", "xyz", "zyz" .. about the axes of the body, or "fixed xyz" .. about the axes of the world

pose-number-too-large = the number of a pose is above 9223372036854775807
# Means: The nine elements do not form a rotation matrix.
# Matters: The columns may be swapped, rounded, or scaled.
# Do: Check the columns r11 to r33: their order, their digits and their unit.
# Example: r11 = 2
rotation-not-orthonormal = the rotation matrix is not orthonormal: products of its rows differ from 1 and 0 by { $off }
    .expected = r11 to r33, row by row: orientation of the body in the world

# Means: The determinant of a rotation matrix is -1.
# Matters: No rotation mirrors a body: the frame is left-handed, or a sign is wrong.
# Do: Check that the frame is right-handed, and that no sign was lost in the columns r11 to r33.
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
unknown-country = unknown country code `{ $code }`, expected two capital letters of ISO 3166-1, such as CA, DE or GB

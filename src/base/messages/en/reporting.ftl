### Messages of report. Above each message: its explanation (see CONTRIBUTING.md, "A message").

# Means: A report template of the laboratory contains an error.
# Matters: The report is not written.
# Do: Correct the marked line of the template.
# Example: `{{ title | upppercase }}` in report.html
template-invalid = the template of the report has an error: { $reason }

# Means: The logo file is too large, or is neither SVG nor PNG.
# Matters: A report contains the logo itself, and can show only SVG and PNG.
# Do: Save the logo as SVG or PNG of at most 1 MiB.
# Example: `logo = "logo.pdf"`
logo-unusable = `{ $file }` { $fault ->
        [size] is too large for a logo
       *[format] is neither an SVG nor a PNG picture
    }
    .expected = an SVG or PNG picture of at most 1 MiB

# Means: The operating system refused to list a folder.
# Matters: The templates in this folder cannot be read.
# Do: Check that the folder exists, and that you may list its files.
# Example: `templates = "no-such-folder"`
cannot-read-folder = cannot read the folder `{ $folder }`: { $reason }
    .hint = check the path and the permissions

# Means: A folder of templates has no file that ends in `.html` or `.css`, and no `report.typ`.
# Matters: The report looks like the built-in report.
# Do: Write the built-in templates to the folder, then change them.
# Example: an empty folder `templates`
no-templates = the folder `{ $folder }` has no template
    .hint = `etalon report --write-templates FOLDER` writes the built-in templates to the folder

# Means: The PDF report cannot be typeset.
# Matters: report.pdf is not written.
# Do: Correct the marked line if it belongs to a template of the laboratory. Otherwise report the
# error as a defect of etalon.
# Example: a function in report.typ that Typst does not have
typesetting-failed = report.pdf cannot be typeset: { $reason }

own-hint = { $text }

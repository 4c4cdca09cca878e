### Meldungen von report; Erklärungen in en/report.ftl.

template-invalid = die Vorlage des Berichts hat einen Fehler: { $reason }

logo-unusable = `{ $file }` { $fault ->
        [size] ist zu groß für ein Logo
       *[format] ist weder ein SVG- noch ein PNG-Bild
    }
    .expected = ein SVG- oder PNG-Bild von höchstens 1 MiB

cannot-read-folder = der Ordner `{ $folder }` kann nicht gelesen werden: { $reason }
    .hint = Pfad und Berechtigungen prüfen

no-templates = der Ordner `{ $folder }` hat keine Vorlage
    .hint = `etalon report --write-templates ORDNER` schreibt die eingebauten Vorlagen

typesetting-failed = report.pdf kann nicht gesetzt werden: { $reason }

own-hint = { $text }

### Meldungen von report; Erklärungen in en/report.ftl.

template-failed = die Vorlage `{ $template }` { $fault ->
        [time] braucht mehr als eine Minute
        [memory] braucht mehr als 2 GiB Speicher
        [ended] endet ohne Ergebnis
       *[other] kann nicht ausgeführt werden: { $fault }
    }
    .hint = die Schleifen der Vorlage prüfen: jede muss enden

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

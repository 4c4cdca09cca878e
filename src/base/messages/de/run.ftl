### Meldungen von run; Erklärungen in en/run.ftl.

contact-without-targets = [contact] hat keine Wirkung auf Residuen der Pose
    .hint = `residuals = "targets"` angeben oder [contact] entfernen

uncertainty-source = { $section ->
        [instrument] aus dem Kalibrierschein des Messgeräts übernehmen
        [tool] die Unsicherheit des Punktes am Werkzeug angeben
       *[contact] denselben Punkt mehrmals antasten und die Streuung der Geberwerte verwenden
    }

key-uncertainty-implausible = `{ $key }` = { $value } kann nicht die Unsicherheit einer gemessenen Koordinate in Mikrometern sein
    .expected = ein Wert von { $least } bis { $most }
    .hint = die Einheit prüfen: 0,0027 mm sind 2,7 µm

target-named-twice = die Zielmarke `{ $target }` ist zweimal genannt
    .hint = jede Zielmarke einmal nennen

limit-without-result = der Grenzwert `{ $limit }` braucht { $needs ->
        [identify] {"["}identify]
        [commanded] {"["}repeatability] mit `commanded` oder [poses]
       *[repeatability] {"["}repeatability] oder [poses]
    }
    .hint = den Grenzwert entfernen oder den Abschnitt ergänzen, der die Größe bestimmt

section-beside-observations = `{ $section }` ist neben [observations] angegeben
    .hint = entweder [observations] angeben oder [[export]], [[log]] und [join]

join-clock-missing = eine Verknüpfung über die Zeit braucht { $keys }
    .hint = in [join] { $lines } ergänzen: der Versatz ist die Zeit der Messung minus die Zeit des Protokolls. Weichen die Uhren voneinander ab, `clock_offset_s = "standstills"` angeben und in [log] `{ $standstill }`

standstills-missing = der Uhrenversatz kann nicht geschätzt werden: Protokoll `{ $log }` hat keinen Abschnitt [log.standstill]
    .hint = in [log] `{ $standstill }` ergänzen (`within_mm` für Schubgelenke) oder `clock_offset_s` als Zahl angeben

interpolate-with-standstills = `interpolate` hat keine Wirkung: Protokoll `{ $log }` hat [log.standstill]
    .hint = `interpolate` entfernen: jeder Punkt wird mit dem Stillstand verknüpft, in den seine Zeit fällt

key-of-other-join = `{ $key }` hat in dieser Verknüpfung keine Wirkung
    .hint = `{ $key }` entfernen oder `by = "{ $by }"` angeben

key-negative = `{ $key }` ist negativ
    .expected = null oder eine positive Zahl

key-above-maximum = `{ $key }` überschreitet { $most }
    .hint = den Wert und seine Einheit prüfen

join-label-missing = eine Verknüpfung über die Bezeichnung braucht die Bezeichnung des Punktes im Protokoll `{ $log }`
    .hint = `label` in seinen `columns` ergänzen, mit Name oder Nummer der Spalte

key-and-column = `{ $key }` ist zweimal angegeben: als Schlüssel des Exports und als eine seiner Spalten
    .hint = eine der beiden Angaben entfernen

key-and-file-name = `{ $key }` ist zweimal angegeben: durch den Namen der Datei, und durch einen Schlüssel, eine Spalte oder die Bezeichnung
    .hint = eine der beiden Angaben entfernen

input-in-output-folder = der Ausgabeordner enthält die Eingabe `{ $input }`
    .expected = ein Ordner ohne Eingabedateien: er wird als Ganzes ersetzt
    .hint = einen anderen Ordner angeben oder `output` entfernen: Vorgabe ist `out`

feature-element = Geometrieelement `{ $feature }` muss genau ein Element nennen
    .expected = einer der Schlüssel `plane`, `line`, `circle`, `cylinder` mit den Bezeichnungen seiner Punkte

feature-label-twice = Geometrieelement `{ $feature }` nennt `{ $label }` zweimal
    .hint = jede Bezeichnung einmal nennen

nominal-without-tolerance = `nominal_mm` und `tolerance_mm` des Weltkoordinatensystems gehören zusammen
    .hint = die Positionen nach der Zeichnung und den größten zulässigen Abstand eines Punktes davon angeben

world-frame-definition = das Weltkoordinatensystem muss auf genau eine Weise definiert sein
    .expected = `plane` mit `origin` und einer Achse oder `targets` oder `as_exported = true`

key-of-other-frame = `{ $key }` hat in diesem Weltkoordinatensystem keine Wirkung
    .hint = `{ $key }` entfernen oder das Koordinatensystem durch `{ $definition }` definieren

frame-axis-without-direction = die Achse des Weltkoordinatensystems hat keine Richtung
    .expected = zwei Bezeichnungen (von, nach) oder ein Geometrieelement mit einer Richtung

plane-frame-incomplete = ein durch eine Ebene definiertes Weltkoordinatensystem braucht `origin`, entweder `x_axis` oder `y_axis`, und `towards`
    .hint = in `towards` einen Punkt nennen, dessen Koordinate entlang der anderen Achse positiv ist: er bestimmt die Richtung von z

file-name-empty = der Name der Datei ist leer
    .hint = die Datei im Ordner der Kampagne angeben

date-invalid = `{ $key }` beginnt nicht mit einem Datum des Kalenders
    .expected = Jahr-Monat-Tag (ISO 8601), zum Beispiel 2026-01-31
dates-out-of-order = `{ $later }` ({ $second }) liegt vor `{ $earlier }` ({ $first })
    .hint = eines der beiden Daten korrigieren

temperature-implausible = `temperature_c` = { $value } ist keine Temperatur eines Roboters in Grad Celsius
    .expected = ein Wert von { $least } bis { $most }
    .hint = die Einheit prüfen: 293,15 K sind 20 °C

geometric-step-missing = in [geometric] fehlt der Schlüssel `{ $missing }`, den `{ $step }` braucht
    .hint = ergänzen; s braucht `shaft` und `arc`; d1 und d3 brauchen `offsets`, `mid_travel_mm`, `arc`, `turn` und `shaft`; O braucht `arc`; C braucht `turn`

errors-table-incomplete = eine Tabelle der Abweichungen braucht die vollständige geometrische Kalibrierung und [identify]
    .hint = alle Schritte von [geometric] und [identify] angeben oder die Tabelle entfernen

key-out-of-range = `{ $key }` = { $value } liegt außerhalb von { $least } bis { $most }

plausible-value = { $quantity ->
        [scale] die Einheit prüfen: 1 µm/m ist 1 ppm
        [polar] die Einheit prüfen: 10 ppm sind 10 µm/m, 1 Bogensekunde ist 4,85 µm/m
        [expansion] die Einheit prüfen: Stahl dehnt sich um `11.5e-6` je Grad aus, Aluminium um `23.5e-6`
        [temperature] in Grad Celsius angeben
        [coverage] den Erweiterungsfaktor angeben: 2 entspricht einem Grad des Vertrauens von etwa 95 %
       *[homing] mehrere Referenzfahrten ausführen und die Streuung eines Gelenks an seinem Schalter verwenden
    }

homing-incomplete = in [homing] fehlt `{ $key }` für Gelenk `{ $joint }` (Werte in { $unit })
    .hint = den Schlüssel angeben; 0, wenn die Referenzfahrt keine Abweichung hinzufügt

polar-with-observations = `polar` braucht Exporte: eine Beobachtungstabelle enthält nicht die Position des Messgeräts
    .hint = die Kovarianz jeder Zeile (`cxx_mm2` bis `czz_mm2`) in der Tabelle angeben

section-without-identify = [{ $section }] hat keine Wirkung: die Kampagne hat keinen Abschnitt [identify]
    .hint = [{ $section }] entfernen oder [identify] ergänzen

label-unknown = kein Punkt hat die Bezeichnung `{ $label }`

feature-unknown = unbekanntes Geometrieelement `{ $feature }`

point-or-feature-unknown = unbekannter Punkt oder unbekanntes Geometrieelement `{ $name }`

target-not-exported = kein Export enthält die Zielmarke `{ $target }`

names-unchecked = kein lesbarer Export enthält { $names }
    .hint = diese Namen prüfen, wenn alle Exporte lesbar sind

target-not-of-robot = `{ $target }` ist keine Zielmarke dieses Roboters

targets-incomplete = `targets` lässt `{ $target }` aus
    .expected = alle Zielmarken dieses Roboters

travel-missing = der Arbeitsraum braucht den Verfahrweg der Antriebe
    .hint = `travel_mm` der drei Antriebe unter [reach] in robot.toml angeben

z-column-missing = in `columns` fehlt z, das ein räumlicher Roboter braucht
    .hint = `z` ergänzen, mit Name oder Nummer der Spalte

log-name-invalid = `{ $name }` kann nicht der Name dieses Protokolls sein
    .expected = Buchstaben, Ziffern, `_` und `-`; ein anderer Name für jedes Protokoll

log-joint-unknown = `{ $key }` ist kein Gelenk dieses Roboters
    .hint = eines der Gelenke { $joints } verwenden, auch mit anderer Einheit

log-joint-missing = Protokoll `{ $log }` hat keine Spalte für Gelenk `{ $joint }`
    .hint = `{ $column }` in seinen `columns` ergänzen, mit Name oder Nummer der Spalte

label-form-differs = keine Bezeichnung von `{ $file }` hat die Form `{ $form }`
    .hint = die Form ihrer Bezeichnungen mit {"{"}target{"}"}, {"{"}pose{"}"} und {"{"}cycle{"}"} angeben; die erste ist `{ $first }`

results-not-synced = die Ergebnisse können nicht auf den Datenträger geschrieben werden: { $reason }
    .hint = den Datenträger prüfen, dann den Stapel noch einmal ausführen

threads-failed = die Kampagnen können nicht gleichzeitig ausgeführt werden: { $reason ->
        [ended] ein Thread endete ohne Ergebnis
       *[other] { $reason }
    }
    .hint = mit weniger Threads ausführen: `RAYON_NUM_THREADS=1`

data-elsewhere = ihre Daten liegen unter ${ $name }, einer nicht gesetzten Umgebungsvariablen

not-an-output-folder = `{ $folder }` ist kein Ausgabeordner eines Laufs: manifest.json fehlt
    .hint = einen Ordner angeben, den `etalon run` geschrieben hat, oder eine ausgeführte Kampagne

file-not-of-run = der Lauf hat `{ $file }` nicht geschrieben
    .hint = die Kampagne erneut ausführen: `etalon run KAMPAGNE`

file-changed-since-run = `{ $file }` wurde nach dem Lauf geändert
    .expected = der SHA-256 { $sha256 } aus manifest.json
    .hint = die Kampagne erneut ausführen: `etalon run KAMPAGNE`

folder-replaced = ein anderer Prozess hat `{ $folder }` beim Lesen ersetzt
    .hint = den Befehl wiederholen, wenn der andere Prozess beendet ist

document-unreadable = `{ $file }` ist kein Dokument dieser Version: { $reason }
    .hint = die Kampagne mit dieser Version erneut ausführen: `etalon run KAMPAGNE`

document-schema-other = `{ $file }` hat { $schema ->
        [none] kein Schema
       *[other] das Schema `{ $schema }`
    }
    .expected = das Schema `{ $wanted }`
    .hint = die Kampagne mit dieser Version erneut ausführen: `etalon run KAMPAGNE`

foreign-file = `{ $file }` würde überschrieben, obwohl kein Lauf diese Datei geschrieben hat
    .hint = die Datei in einen anderen Ordner verschieben oder in campaign.toml ein anderes `output` angeben

input-changed = `{ $file }` hat sich während des Laufs geändert
    .hint = die Kampagne erneut ausführen, wenn die Datei vollständig ist

identify-missing = die Kampagne hat keinen Abschnitt [identify], der die Posen zur Beurteilung der Parameter nennt
    .hint = `calibration` und `validation` in [identify] angeben

clock-rate-without-offset = `clock_rate` braucht `clock_offset_s` mit demselben Wort: `standstills` oder `motion`
    .hint = `clock_offset_s` mit demselben Wort angeben oder `clock_rate` weglassen

label-form-missing = die Bezeichnungen von `{ $file }` nennen Zielmarken, aber die Form der Bezeichnungen ist nicht angegeben
    .hint = `label = "{ $form }"` in diesem [[export]] angeben: alle seine Bezeichnungen haben diese Form

state-targets = `targets = { $targets }` in [join] angeben: die Bezeichnungen nennen diese Zielmarken
valid-until-no-date = `valid_until` ist kein Datum: "{ $date }"
    .expected = der letzte Tag der Gültigkeit in Anführungszeichen, zum Beispiel "2027-03-02"

valid-until-before-measurements = `valid_until` ({ $date }) liegt vor den Messungen ({ $measured })
    .hint = `valid_until` oder `date` berichtigen

template-name-reserved = ein Lauf schreibt `{ $file }` selbst
    .hint = die Vorlage umbenennen

controller-template = Vorlage eines Steuerungsformats

field-of-other-parameters = `{ $field }` gehört nicht zu `{ $parameters }`: die Prüfsumme der Parameter weicht ab
    .hint = beide Dateien eines Laufs angeben
valid-stated-twice = `valid_until` und `valid_for_months` sind beide angegeben
    .hint = eines von beiden weglassen

valid-months-without-date = `valid_for_months` braucht das Datum (`date`) der Messungen
    .hint = `date = "2026-03-02"` oder den letzten Tag als `valid_until` angeben

valid-months-implausible = `valid_for_months` ist { $months }
    .expected = 1 bis { $most } Monate

### Meldungen von formats; Erklärungen in en/formats.ftl.

column-without-place = eine Spalte hat entweder `name` oder `number` ab 1
column-wrong-occurrence = `occurrence` zählt ab 1, und `per_count` ist nicht 0
columns-in-two-forms = `columns` nennt { $quantity ->
        [orientation] zwei Formen der Orientierung
       *[uncertainty] Standardunsicherheiten und erweiterte Messunsicherheiten
    }
    .hint = die Spalten einer Form weglassen

column-group-incomplete = `columns` nennt nur einen Teil von { $names }
    .hint = alle diese Spalten nennen oder keine

header-without-words = `header` ist leer, ein Wort der Zeile vor den Daten wird erwartet
key-needs-columns = `{ $key }` braucht die Spalten { $columns }
    .hint = diese Spalten in `columns` nennen oder `{ $key }` entfernen

coverage-factor-missing = erweiterte Messunsicherheiten brauchen ihren Erweiterungsfaktor `coverage_factor`
    .hint = ihn in `format` angeben, zum Beispiel `coverage_factor = 2`

row-number-unknown = `{ $stated }` ist unbekannt, erwartet wird `row` oder, für eine zweite Datei, `row + 100`
uncertainty-column-count = `columns` nennt { $stated ->
        [one] 1 Unsicherheit
       *[other] { $stated } Unsicherheiten
    } für { $coordinates ->
        [one] 1 Koordinate
       *[other] { $coordinates } Koordinaten
    }
    .expected = eine je Koordinate ({ $names }) oder keine

column-separation-unclear = das Format gibt { $stated ->
        [0] keine Trennung der Spalten an
       *[other] { $stated } Trennungen der Spalten an
    }
    .expected = eines von `delimiter`, `widths` und `sheet`
    .hint = `etalon formats DATEI` schlägt vor, wie die Datei zu lesen ist

column-width-zero = eine Spalte von `widths` ist 0 Zeichen breit
    .hint = die Zahl der Zeichen jeder Spalte angeben

more-columns-than-widths = `columns` nennt { $columns } Spalten, `widths` hat { $widths }
    .hint = eine Breite je Spalte angeben

comma-ambiguous = ein Komma kann nicht zugleich Spaltentrennzeichen und Dezimalzeichen sein: `1,25` wäre eine Zahl oder zwei
    .hint = die Datei mit Semikolons oder Tabulatoren exportieren oder mit Dezimalpunkt

thousands-mark-ambiguous = das Tausenderzeichen `{ $mark }` ist auch das { $other ->
        [decimal] Dezimalzeichen
       *[delimiter] Trennzeichen
    }
    .hint = `thousands` entfernen oder berichtigen

column-role-twice = `columns` nennt `{ $role }` zweimal
    .hint = eine Angabe berichtigen; eine Spalte, die nicht gelesen wird, ist `-`

coordinates-of-two-kinds = `columns` nennt sowohl Koordinaten fester Art als auch c1, c2, c3
    .expected = entweder x, y, z oder Winkel und Abstände, oder c1, c2, c3

row-types-missing = die Spalten c1, c2, c3 brauchen eine Spalte `type` und den Schlüssel `types`
    .hint = zum Beispiel `types = {"{"} 0 = ["x", "y", "z"], 7 = ["azimuth", "zenith", "distance"] {"}"}`

row-type-incomplete = `{ $key }` gibt nicht an, was c1, c2 und c3 sind
    .expected = drei Koordinaten sowie c1, c2, c3 in `columns`

not-coordinates = `{ $key }` nennt { $count ->
        [0] keine Koordinaten
       *[other] { $names }: nicht die Koordinaten eines Punkts
    }
    .expected = x und y, im Raum auch z; Radius, Azimut und z; oder Azimut, Zenit- oder Höhenwinkel und Abstand

angle-unit-missing = `{ $key }` nennt Winkel ohne Einheit
    .hint = `angle_unit` (Option `--angle-unit`) angeben: "deg", "rad" oder "gon"

coordinate-type-differs = `coordinates` gibt { $stated ->
        [cartesian] kartesische
        [cylindrical] zylindrische
       *[spherical] sphärische
    } Koordinaten an, `{ $key }` nennt { $named ->
        [cartesian] kartesische
        [cylindrical] zylindrische
       *[spherical] sphärische
    }
    .hint = eine Angabe berichtigen

header-not-stated = `columns` nennt die Überschrift `{ $column }`, aber es ist keine Kopfzeile angegeben
    .hint = `header = 1` angeben oder die Nummer der Spalte nennen

header-is-data = Zeile { $rows } der Kopfzeilen enthält Zahlen in den Spalten der Koordinaten
    .hint = leere Zeilen und Kommentare zählen nicht: `header = { $fewer }` angeben

expression-malformed = der Ausdruck `{ $expression }` kann nicht gelesen werden: { $fault ->
        [too-long] er ist länger als 1000 Zeichen
        [left-over] `{ $rest }` bleibt übrig
        [brackets-too-deep] seine Klammern sind zu tief geschachtelt
        [too-many-signs] er hat zu viele Operatoren
        [bracket-open] eine Klammer ist nicht geschlossen
        [column-number] auf `$` folgt keine Spaltennummer ab 1
       *[incomplete] eine Spalte oder eine Zahl fehlt
    }
    .expected = Überschriften, `$3` für die dritte Spalte und Zahlen, dazwischen + - * / und Klammern

column-unknown = es gibt keine Spalte `{ $column }`

table-failed = die Tabelle kann nicht gebildet werden: { $reason }

not-whole-number = `{ $value }` in der Spalte `{ $column }` ist keine ganze Zahl

stored-table-damaged = die gespeicherte Tabelle ist beschädigt: { $reason }
    .hint = die Kampagne erneut ausführen: `etalon run KAMPAGNE`

stored-row-count = sie hat { $found ->
        [one] 1 Zeile
       *[other] { $found } Zeilen
    } statt { $rows }

row-without-point = die Zeile enthält keinen Punkt: { $reason }
    .hint = die Zeile aus der Datei entfernen

rows-left-out = { $count ->
        [one] 1 Zeile
       *[other] { $count } Zeilen
    } ausgelassen; die erste: { $reason }

count-value-missing = `{ $key }` gibt den Wert eines Inkrements nicht an: Galil-Arrays enthalten Geberinkremente
    .expected = `{ $key } = {"{"} name = "...", per_count = 0.001 {"}"}`, per_count in der Einheit des Schlüssels

galil-array-hole = das Array von `{ $column }` hat eine Lücke
    .hint = das Array erneut aus der Steuerung auslesen

galil-array-ended = Wert fehlt: das Array von { $columns } ist zu Ende

galil-array-empty = eines der Arrays ist leer
    .hint = die Arrays nach dem Ende der Aufzeichnung erneut aus der Steuerung auslesen

not-a-count = { $value } ist keine Anzahl von Geberinkrementen
    .expected = eine ganze Zahl mit 32 Bit
    .hint = sind die Werte schon umgerechnet, `format = "galil"` weglassen

counter-wrapped = der Zähler ist übergelaufen: auf { $from } folgt { $to }
    .hint = den Geber vor der Aufzeichnung auf null setzen

rsi-cycles-missing = { $count ->
        [one] 1 Zeile, in der
       *[other] { $count } Zeilen, in denen
    } `IPOC` nicht um { $step_ms } ms fortschreitet
    .hint = Telegramme gingen verloren, weil der aufzeichnende Rechner zu langsam war; erneut aufzeichnen, falls die Lücken stören

ros-joints-change = Gelenk { $number } ist in dieser Zeile `{ $found }` und in der ersten `{ $first }`
    .hint = zwei Sender teilen das Topic: jeden in eine eigene Datei aufzeichnen

log-column-unknown = `{ $key }` ist keine Spalte eines Protokolls
    .expected = `pose`, `cycle`, `time_s`, `label` oder ein Gelenk mit seiner Einheit wie `q1_deg`, `q1_rad`, `rho1_mm`

log-column-twice = `{ $key }` gibt `{ $name }` ein zweites Mal an
    .hint = eine Angabe weglassen; `pose = "row"` ersetzt die Spalte der Pose, `period_s` die Spalte der Zeit

log-key-inapplicable = `{ $key }` gilt nicht für { $column ->
        [none] dieses Protokoll
       *[other] `{ $column }`
    }
    .hint = { $key ->
        [per_count] `per_count` ist der Wert eines Geberinkrements und gilt nur für ein Gelenk: den Schlüssel entfernen
        [values] `values` gehört zu `format = "twincat"`: den Schlüssel entfernen
        [comment] eine Array-Datei enthält keinen Text: `{ $key }` entfernen
        [decimal] eine Array-Datei enthält keinen Text: `{ $key }` entfernen
        [delimiter] eine Array-Datei enthält keinen Text: `{ $key }` entfernen
        [encoding] eine Array-Datei enthält keinen Text: `{ $key }` entfernen
        [sheet] eine Array-Datei enthält keinen Text: `{ $key }` entfernen
        [header] ein TwinCAT-Export nennt seine Kanäle: `header` entfernen
       *[other] Kanäle eines TwinCAT-Exports haben eigene Zeiten: `{ $key }` entfernen
    }

column-unit-differs = `{ $key }` gibt { $stated } an, `{ $column }` ist in { $known ->
        [wall-clock] ganzen Sekunden der Uhrzeit; die Uhr dieses Protokolls ist `IPOC`
       *[other] { $known }
    }

write-column = `{ $key } = "{ $column }"` schreiben

column-in-unit = eine Spalte in { $unit }

header-words-missing = keine Zeile enthält alle Wörter der Kopfzeile: { $words }
    .hint = die Wörter aus der Kopfzeile der Datei übernehmen

data-rows-missing = die Datei hat keine Datenzeilen
    .hint = sie erneut exportieren; enthält ihre einzige Zeile Werte, `header = false` angeben

row-field-count = die Zeile hat { $fields ->
        [one] 1 Feld
       *[other] { $fields } Felder
    }
    .expected = { $expected }
    .hint = Trennzeichen, Dezimalzeichen und Anführungszeichen prüfen: ein Dezimalkomma vermehrt die Felder; in einer abgeschnittenen Datei fehlen sie

fields-like = { $like ->
        [header] { $width } wie die Kopfzeile
        [first-row] { $width } wie die erste Zeile
       *[names] höchstens { $width } wie die Zeile der Namen
    }

delimiter-does-not-split = durch `{ $delimiter }` getrennt haben die Zeilen eine einzige Spalte

state-delimiter = `delimiter = "{ $delimiter }"` und `decimal = "{ $decimal }"` angeben (Optionen --delimiter und --decimal)

state-delimiter-of-rows = `delimiter` und `decimal` der Zeilen angeben

header-holds-numbers = die Kopfzeile enthält Zahlen statt Namen
    .hint = hat die Datei keinen Kopf, `header = false` und die Nummern der Spalten angeben

column-by-number = eine Spalte dieses Formats kann nicht durch ihre Nummer angegeben werden: { $format ->
        [galil] Arrays stehen in alphabetischer Reihenfolge, unabhängig von ihrem Gelenk
        [ros] die Reihenfolge der Gelenke ist beliebig
       *[twincat] die Reihenfolge der Kanäle wechselt von Export zu Export
    }
    .hint = ihren Namen angeben

column-number-unknown = Spalte { $number } existiert nicht
    .expected = eine Nummer von 1 bis { $columns }

heading-repeated = der Kopf hat { $times ->
        [one] 1 Spalte
       *[other] { $times } Spalten
    } `{ $column }`
    .expected = `occurrence` von 1 bis { $times }
    .hint = angeben, welche: `{"{"} name = "{ $column }", occurrence = 1 {"}"}`

log-row-needs-values = das Protokoll erneut aus der Steuerung auslesen oder die Zeile entfernen: jede Zeile braucht ihre Werte

assembly-mode-invalid = der Montagemodus ist { $value }
    .expected = 1 oder -1
    .hint = ihn berichtigen; ist er unbekannt, die Spalte `assembly` weglassen

standstill-missing = der Roboter des Protokolls `{ $log }` steht nie { $at_least_s } s lang still
    .hint = sein längster Stillstand innerhalb der Grenzen dauert { FIXED($longest_s, 3) } s: `at_least_s` und die Grenzen prüfen

standstill-time-missing = [log.standstill] braucht die Zeiten der Zeilen
    .hint = `time_s`, `time_ms` oder `time_ns` in `columns` angeben oder `period_s`

standstill-limit-missing = [log.standstill] hat keine Grenze für `{ $column }`
    .hint = `{ $key }` angeben: die größte Differenz zweier Werte im Stillstand

changes-at-standstill = `{ $column }` wechselt während eines Stillstands von { $from } zu { $to }
    .hint = die Spalte weglassen oder die Grenzen von [log.standstill] senken

simulated-column-clash = die Spalte von `{ $key }` kann nicht geschrieben werden
    .expected = eine eigene Spalte je Schlüssel, höchstens { $most } Spalten

simulated-column-unknown = `{ $key }` kann nicht simuliert werden
    .expected = `pose`, `cycle`, `time_s` und die Gelenke mit ihren Einheiten

log-columns-missing = `columns` dieses Protokolls nennt keinen Kanal

twincat-two-scales = Kanal `{ $channel }` hat eine Skalierung, und auch seine Einheit hat eine
    .hint = skalierte Werte exportieren und `values = "scaled"` angeben

twincat-scale-undecided = Kanal `{ $channel }` hat eine Skalierung (Faktor und Offset { $scale }, der Einheit { $unit_scale }): es ist unbekannt, ob sie schon angewendet ist
    .hint = `values = "raw"` oder `values = "scaled"` angeben, je nach Einstellung des Exports

channel-resumes = Kanal `{ $channel }` geht nach seinem Ende weiter
    .hint = die Aufzeichnung erneut exportieren

channels-without-common-time = diese Kanäle haben keinen gemeinsamen Zeitpunkt
    .hint = Kanäle einer Task mit einer Abtastzeit exportieren

channel-samples-unused = Kanal `{ $channel }`: { $count ->
        [one] 1 Abtastwert
       *[other] { $count } Abtastwerte
    } ausgelassen, weil ein anderer Kanal zu diesen Zeitpunkten keinen Abtastwert hat

twincat-head-malformed = das ist kein Export von TwinCAT 3 Scope: { $part ->
        [first-line] die erste Zeile beginnt nicht mit `Name` und einem Trennzeichen
        [names] keine Zeile des Kopfes nennt die Kanäle
       *[end] keine leere Zeile beendet den Kopf
    }
    .hint = die Aufzeichnung erneut als CSV exportieren oder ein anderes `format` angeben

twincat-head-ragged = Zeile `{ $row }` des Kopfes hat { $fields } Felder, die Zeile der Namen { $width }: das Trennzeichen kommt auch in Werten oder Namen vor
    .hint = erneut exportieren, getrennt durch Tabulatoren oder Semikolons

twincat-separated-by-blanks = der Export ist durch Leerzeichen getrennt, aber ein Leerzeichen steht auch für einen fehlenden Wert oder ist Teil eines Namens
    .hint = erneut exportieren, getrennt durch Tabulatoren oder Semikolons

channel-scale-not-number = `{ $key }` von Kanal `{ $channel }` ist `{ $value }`, keine Zahl
    .hint = die Aufzeichnung erneut exportieren

delimiter-differs = der Export ist durch { $separator } getrennt
    .hint = `delimiter` dieses Protokolls entfernen: der Export gibt sein Trennzeichen selbst an

coordinates-differ = Ist- und Sollpositionen haben verschiedene Koordinaten
    .expected = die Koordinaten von `{ $file }`
    .hint = ebene Roboter lassen `z_mm` in beiden Tabellen weg

coordinate-missing = eine Koordinate fehlt oder ist nicht endlich
    .hint = die Zelle ergänzen oder die Zeile entfernen

columns-not-read = nicht gelesen: { $count ->
        [one] Spalte
       *[other] Spalten
    } { $columns }

joint-direction-missing = `backlash` von Gelenk `{ $joint }` braucht die Anfahrrichtung
    .expected = eine Spalte `{ $column }`: +1 bei Annäherung von kleineren Werten, -1 von größeren Werten
    .hint = ein Protokoll mit Zeiten verwenden oder das Gelenk aus `backlash` der Roboterdatei entfernen

joint-direction-invalid = `{ $column }` { $value ->
        [missing] fehlt
       *[other] ist { $value }
    }
    .expected = +1, wenn `{ $joint }` von kleineren Werten her kommt, -1 von größeren Werten her

joint-column-twice = die Tabelle enthält Gelenk `{ $joint }` zweimal: `{ $first }` und `{ $second }`
    .hint = eine der Spalten entfernen

in-row = Zeile { $row }: { $message }

pose-commanded-twice = Pose { $pose } steht zweimal unter den Sollposen
    .hint = eine der Zeilen entfernen oder umbenennen

pose-not-commanded = Pose { $pose } ist nicht unter den Sollposen
    .hint = sie in `{ $file }` ergänzen oder ihren Namen berichtigen

pose-attained-twice = Pose { $pose } wurde in Zyklus { $cycle } zweimal angefahren
    .hint = die Zyklen nummerieren, Anfahrrichtungen in `approach` nennen oder die Messwerte einer Anfahrt in `reading` nummerieren

commanded-pose-not-measured = Pose { $pose } ist Sollpose, wurde aber nicht gemessen

no-pose-measured = keine Pose wurde gemessen
    .hint = die Namen der Posen prüfen

recording-time-missing = die Aufzeichnung hat keine Zeitspalte
    .expected = eine Spalte `time_s` oder die Abtastrate
    .hint = die Abtastrate des Messgeräts angeben: `--rate-hz 1000`, in einer Kampagne `rate_hz = 1000`

row-repeats = diese Zeile entfernen: sie hat die Koordinaten der Zeile { $line }, Ziffer für Ziffer

state-sampling-rate = die Abtastrate angeben (`--rate-hz`): die Zeitstempel sind gröber als die Abtastung

rate-contradicts-stamps = { $samples } Abtastwerte mit { $rate_hz } Hz dauern { FIXED($by_rate_s, 2) } s; ihre Zeitstempel umfassen { FIXED($stamped_s, 2) } s
    .hint = die Abtastrate berichtigen oder die Spalten ohne die Zeitstempel angeben

recording-implausible = { $count } von { $samples } Abtastwerten sind schneller als 20 m/s: so schnell bewegt sich kein Roboter
    .hint = Abtastrate, Einheit und Reihenfolge der Abtastwerte prüfen

angles-not-compensated = die Drift der Winkel wird nicht durch die Referenzmarken korrigiert
    .expected = a_deg, b_deg und c_deg (bei einem ebenen Roboter nur c_deg) und die Reihenfolge ihrer Drehungen
    .hint = die Reihenfolge angeben: `--rotation-order "Rz(c) Ry(b) Rx(a)"`, in einer Kampagne `rotation_order`

cycle-before-reference-targets = Zyklus { $cycle } wurde vor allen Referenzmarken gemessen
    .hint = die Referenzmarken vor der Prüfung messen; ihre erste Messung gehört zu Zyklus { $first }

reference-target-twice = die Referenzmarke `{ $target }` wurde in Zyklus { $cycle } zweimal gemessen
    .hint = eine der Zeilen entfernen oder ihren Namen berichtigen

reference-targets-differ = die Referenzmarken von Zyklus { $cycle } unterscheiden sich von den ersten
    .expected = { $targets }

observation-column-unknown = `{ $column }` ist keine Spalte von Beobachtungen
    .hint = Koordinaten und Gelenke enden mit ihrer Einheit: x_mm, q1_deg; docs/observations.md nennt alle Spalten

columns-inverted = `columns` ist vertauscht: Überschriften der Tabelle stehen als Namen von Spalten

column-stated-twice = die Spalte `{ $column }` ist als `{ $first }` und als `{ $second }` angegeben
    .hint = eine Angabe berichtigen

heading-twice = der Kopf nennt `{ $column }` mehrmals
    .hint = eine der Spalten umbenennen oder entfernen

stated-and-in-table = `{ $key }` ist angegeben, aber die Tabelle hat auch eine Spalte dieses Namens
    .hint = eines davon entfernen

no-row-selected = `only` und `without` wählen keine Zeile aus
    .hint = ihre Zellen mit den Zellen der Datei vergleichen
log-without-values = keine Zeile des Protokolls hat einen Wert für `{ $column }`
    .hint = die Spalte berichtigen oder in `missing` andere Zellen angeben
log-constant-invalid = die Konstante { $value } kann nicht die Spalte `{ $column }` eines Protokolls sein
    .hint = { $column ->
        [cycle] eine ganze Zahl oder, in einem Protokoll mit Posen, "visit" angeben
        [assembly] 1 oder -1 angeben
        [pose] eine Zahl oder einen Namen angeben
       *[other] eine Zahl angeben
    }

computed-not-finite = der berechnete Wert von `{ $column }` ist { $value }
    .hint = den Ausdruck prüfen: Division durch null oder Überlauf

name-is-formula = der Name `{ $name }` in der Spalte `{ $column }` wäre in einer Tabellenkalkulation eine Formel
    .hint = einen Namen verwenden, der nicht mit = + - oder @ beginnt

file-empty = die Datei ist leer
    .hint = sie erneut exportieren

file-without-points = das ist { $kind ->
        [json] ein JSON-Dokument
        [yaml] ein YAML-Dokument
        [toml] ein TOML- oder INI-Dokument
        [certificate] ein digitaler Kalibrierschein: Ergebnisse einer Kalibrierung ohne Messpunkte
        [sdr33] eine Datei mit Beobachtungen einer Totalstation von Sokkia (SDR33)
        [m5] eine Datei mit Beobachtungen einer Totalstation von Zeiss oder Trimble (M5)
        [south] eine Datei mit Beobachtungen einer Totalstation von South
        [mesh] ein Netz (OBJ, OFF, VRML oder VTK): die Ecken sind keine Messpunkte eines Roboters
        [las] ein Scan im Format LAS
        [urscript] ein Programm einer Steuerung von Universal Robots mit Sollposen, ohne gemessene Posen
        [krl] ein Programm einer KUKA-Steuerung mit Sollposen, ohne gemessene Posen
        [gcode] ein Programm einer Werkzeugmaschine (G-Code) mit Sollpositionen, ohne gemessene Positionen
        [cad] ein CAD-Modell (STEP oder DXF) mit Nennpunkten
        [roughness] eine Datei mit Rauheitskennwerten eines Mitutoyo SJ-410 ohne Koordinaten
       *[xml] ein XML-Dokument unbekannter Art
    }
    .expected = Messpunkte oder ein Protokoll, als Texttabelle oder Arbeitsmappe
    .hint = { $kind ->
        [certificate] die Datei der Messpunkte angeben
        [roughness] die Datei der Messpunkte angeben
        [sdr33] die Koordinaten der Punkte als Text exportieren, eine Zeile je Punkt
        [m5] die Koordinaten der Punkte als Text exportieren, eine Zeile je Punkt
        [south] die Koordinaten der Punkte als Text exportieren, eine Zeile je Punkt
        [mesh] die Datei mit den Messpunkten angeben; Netze eines Roboters gehören zu seiner URDF
        [las] die Punkte als Text, PLY oder E57 exportieren
        [urscript] die Datei mit den Messpunkten angeben
        [krl] die Datei mit den Messpunkten angeben
        [gcode] die Datei mit den Messpunkten angeben
        [cad] die Datei mit den Messpunkten angeben
       *[other] die Zahlen als CSV schreiben: eine Zeile je Punkt oder Pose, darüber die Namen der Spalten
    }

stations-several = in Zeile { $line } wurde das Messgerät neu aufgestellt: Richtungen und Strecken zweier Aufstellungen haben kein gemeinsames Koordinatensystem
    .hint = die Koordinaten der Punkte (Wörter 81, 82, 83) exportieren, oder eine Datei je Aufstellung

matrices-in-blocks = die Zeilen sind 4×4-Matrizen, eine unter der anderen
    .expected = eine Zeile je Punkt oder Pose
    .hint = jede Matrix in eine Zeile mit 16 Zahlen schreiben, Zeile für Zeile

gsi-feet = die Länge ist in Fuß, und GSI gibt nicht an, in welchem
    .expected = Längen in Metern
    .hint = die Punkte in Metern exportieren

numbers-behind-names = die Zahlen stehen hinter ihren Namen, wie in `x:428.031`
    .expected = eine Zahl je Spalte
    .hint = die Namen einmal als Zeile von Überschriften schreiben und darunter die Zahlen

numbers-in-brackets = die Zahlen stehen in Listen mit Klammern
    .expected = eine Zahl je Spalte
    .hint = die Zahlen ohne Klammern schreiben, zum Beispiel mit `numpy.savetxt`

numbers-in-cells = die Zellen enthalten Listen von Zahlen: zwei Trennzeichen teilen die Zahlen einer Zeile
    .expected = eine Zahl je Spalte
    .hint = eine Zahl je Spalte schreiben, mit einem Trennzeichen

no-rows-of-numbers = { $file ->
        [workbook] kein Blatt der Arbeitsmappe hat
        [arrays] kein Array der Datei enthält Gelenkwerte oder Punkte, mit
       *[text] keine Lesart als Text mit Trennzeichen ergibt
    } Zeilen mit zwei oder mehr Zahlen
    .hint = die Punkte als Text exportieren, eine Zeile je Punkt

robot-does-not-test = mit einem Roboter des Modells `{ $model }` lässt sich der Vorschlag nicht prüfen: die Pose seines Flansches im Raum ist nicht frei

robot-not-tested = der Vorschlag wird nicht mit dem nominalen Roboter geprüft: nötig sind mindestens { $fewest } Zeilen, in denen sich drei Gelenke bewegen, mit Koordinaten, die den Raum aufspannen; Messreihen einzelner Gelenke wertet `etalon axes` aus

robot-contradicts = der nominale Roboter reproduziert { $points } mit keiner der versuchten Reihenfolgen, Richtungen und Einheiten der Gelenke{ $known ->
        [yes] ; das kleinste Residuum ist { FIXED($rms_mm, 2) } mm (quadratischer Mittelwert)
       *[no] {""}
    }

robot-ambiguous = die Daten bestimmen Reihenfolge und Richtung von { $joints } nicht: eine andere Lesart ergibt ein Residuum von { FIXED($rms_mm, 3) } mm (quadratischer Mittelwert)

robot-units-ambiguous = die Daten bestimmen die Einheiten der Gelenke nicht: eine andere Einheit ergibt ein Residuum von { FIXED($rms_mm, 3) } mm (quadratischer Mittelwert)

robot-finds-targets = mit einer eigenen Zielmarke für jeden Wert von { $column } reproduziert der nominale Roboter die Koordinaten

robot-contradicts-unit = die Überschrift von { $column } nennt { $stated }, aber die Kinematik des nominalen Roboters passt zu { $unit }

robot-contradicts-order = der nominale Roboter passt mit den Gelenken in der Reihenfolge { $columns }, entgegen der Reihenfolge der Überschriften: Überschriften und Roboterdatei prüfen

robot-reverses = { $column } zählt entgegen der Richtung von `{ $joint }`: der nominale Roboter passt mit umgekehrtem Vorzeichen

robot-orders = der nominale Roboter passt mit den Gelenken in der Reihenfolge { $columns }

robot-reproduces = der nominale Roboter reproduziert { $points } in { $unit } mit einem Residuum von { FIXED($rms_mm, 4) } mm (quadratischer Mittelwert aus { $rows } Zeilen, Basis und Zielmarke frei)
robot-orders-angles = die Orientierungen des nominalen Roboters passen auf { FIXED($misfit_deg, 2) }° zu { $kind ->
        [vector] einem Rotationsvektor
       *[angles] drei Winkeln in der Reihenfolge { $order }
    } in { $unit }; keine andere Form passt
robot-orders-quaternion = die Orientierungen des nominalen Roboters passen zum Quaternion mit dem Skalar { $scalar ->
        [first] an erster Stelle
       *[last] an letzter Stelle
    }

points-commanded = { $points }: Sollwerte oder berechnete Werte, keine Messwerte; der nominale Roboter ergibt sie bis auf die Rundung (Residuum { FIXED($rms_mm, 6) } mm)

points-perhaps-commanded = { $points }: vielleicht Sollwerte, keine Messwerte; das Residuum von { FIXED($rms_mm, 4) } mm liegt innerhalb der Rundung von Koordinaten und Gelenkwerten

file-is = `{ $file }`: { $kind }, { $rows ->
        [one] 1 Zeile
       *[other] { $rows } Zeilen
    }{ $coordinates ->
        [none] {""}
        [open] , Koordinaten unbekannter Einheit
       *[other] , Koordinaten in { $coordinates }
    }{ $joints ->
        [none] {""}
        [open] , Gelenke unbekannter Einheit
       *[other] , Gelenke in { $joints }
    }{ $times ->
        [none] {""}
        [open] , Zeiten unbekannter Einheit
       *[other] , Zeiten in { $times }
    }

files-join = zu { $matching } von { $keys } Zeilen von `{ $file }` gibt es eine Zeile in `{ $log }` (Schlüssel: { $by })

files-not-joined = kein Schlüssel verknüpft alle Exporte mit den { $rows } Zeilen von `{ $log }`
recording-not-joined = die Zeiten verknüpfen `{ $log }` nicht: es gibt weniger Stillstände von mindestens 1 s als Punkte ({ $standstills }), und kein Versatz der Uhren gibt jedem Punkt eine eigene Zeile
rows-of-several-targets = `{ $file }` hat { $rows } Zeilen, { $count } für jede der { $poses } Zeilen des Protokolls: sie enthält vielleicht { $count } Zielmarken. Zielmarke und Pose jeder Zeile in Spalten schreiben

doubt-numbers-and-text = Spalte { $column } enthält in { $count } von { $rows } Zeilen Zahlen, und `{ $text }`: solche Zeilen weglassen (`header`, `comment`)

doubt-array-columns = `{ $array }` hat { $count } Spalten: Gelenke, Koordinaten oder beides nebeneinander
zero-count-alone = `zero_count` ist ohne `per_count` wirkungslos

payload-column-missing = `payload` der Roboterdatei braucht die Spalte `{ $column }`
    .expected = `load_kg` und der Schwerpunkt im Flansch: `load_x_mm`, `load_y_mm`, `load_z_mm`
    .hint = die Spalte ergänzen, mit 0 in Zeilen ohne Last; oder `payload` aus der Roboterdatei entfernen

payload-invalid = `{ $column }` { $value ->
        [missing] fehlt
       *[other] ist { $value }
    }
    .expected = eine Masse in kg von mindestens 0 oder eine Länge in mm
    .hint = 0 angeben, wo der Roboter nichts trägt

torque-column-missing = `torque` der Roboterdatei nennt das Gelenk `{ $joint }`, aber die Spalte `{ $column }` fehlt
    .hint = die Spalte ergänzen oder das Gelenk aus `torque` der Roboterdatei entfernen

torque-invalid = `{ $column }` { $value ->
        [missing] fehlt
       *[other] ist { $value }
    }
    .expected = ein Drehmoment in N·m
    .hint = die Zelle berichtigen oder die Zeile ausschließen

temperature-column-missing = `drift` oder `expansion` der Roboterdatei braucht die Spalte `{ $column }`
    .expected = die Temperatur des Roboters in °C
    .hint = die Spalte ergänzen oder `drift` und `expansion` aus der Roboterdatei entfernen

temperature-invalid = `{ $column }` { $value ->
        [missing] fehlt
       *[other] ist { $value }
    }
    .expected = eine Temperatur in °C über dem absoluten Nullpunkt
    .hint = die Zelle berichtigen oder die Zeile ausschließen

approach-unknown = unbekannte Anfahrrichtung: { $visits }{ $count ->
        [one] {""}
       *[other] {""}; insgesamt { $count }
    }; der Messwert der vorhergehenden Pose fehlt
    .hint = falls der Roboter dazwischen keine andere Pose anfuhr, die Anfahrrichtungen in einer Spalte `approach` nennen

visit-of-cycle = Pose { $pose } in Zyklus { $cycle }

### Meldungen von cli; Erklärungen in en/cli.ftl.

message-unknown = `{ $id }` ist nicht die Kennung einer Meldung

option-not-positive = { $option } muss positiv sein
    .hint = eine positive Zahl angeben

option-refused = { $option }: { $reason }
    .hint = `etalon BEFEHL --help` zählt die Werte auf

column-option-malformed = --column: `{ $text }` hat kein `=`
    .expected = q1_deg=J1

option-unit-missing = die Dateien nennen ihre Längeneinheit nicht
    .hint = sie angeben: --unit mm, m, um oder inch; sie wird nie geraten

robot-option-missing = parameters.json braucht --robot DATEI
    .hint = die robot.toml angeben: --robot DATEI

axis-unknown = der Roboter hat keine Achse `{ $axis }`
    .hint = ein Gelenk des Roboters oder x_mm, y_mm, z_mm verwenden

axes-mixed = die Achsen einer Tabelle sind alle aus x_mm, y_mm, z_mm oder alle Gelenke
    .expected = Gelenke { $joints }

table-of-turning-joints = eine Tabelle mehrerer Gelenke braucht aufeinanderfolgende Schubgelenke
    .hint = x_mm und y_mm verwenden: Posen des nominalen Roboters

lead-not-measured = keine Steigung von `{ $axis }` wurde gemessen
    .expected = { $measured }

lead-of-one-axis = eine Steigung gehört zu einer Achse, die sie korrigiert
    .hint = nur diese Achse angeben

table-value-missing = ein Wert fehlt oder ist keine Zahl
    .hint = die Zeile berichtigen oder entfernen

not-a-grid = die Positionen sind nicht die eines Rasters
    .expected = eine Zeile für jede Position jeder Basisachse

axis-without-positions = `{ $axis }` hat keine Positionen
    .expected = --axis { $axis }=VON:BIS:SCHRITT

configuration-changed = Ziel { $target }: der Befehl ist in einer anderen Konfiguration
    .hint = seine Konfigurationsdaten (Arbeitsmodus, confdata, Status und Turn) bleiben unverändert: prüfen

poses-computed-by-program = Posen von { $names } bleiben unverändert
    .hint = prüfen: was ein Programm aus kompensierten Zielen berechnet, hat deren Kompensation, nicht die eigene

working-mode-missing = das Programm nennt nicht den Arbeitsmodus, in dem der Roboter beginnt
    .hint = die Gelenkwerte am Anfang angeben: --start N,N,+1

program-frames = das Programm verwendet { $names }

one-program-each = die Ziele von jedem als eigenes Programm angeben

state-pose-option = seine Pose angeben: --{ $option } x,y,z,qw,qx,qy,qz

program-in-world = Ziele eines Programms sind nicht im Weltsystem
    .hint = --object verwenden

counts-missing = `galil` braucht die Impulse von { $axes } Achsen je mm oder deg
    .hint = --counts-per-unit N,N

joints-in-world = Gelenkwerte sind nicht im Weltsystem
    .hint = --frame weglassen

nominal-pose-unreachable = der nominale Roboter kann nicht dort sein, wohin ihn die Gelenke stellen
    .hint = Gelenkwerte und Montagemodus prüfen

base-not-in-world = `{ $model }` hat keine Basis im Weltsystem
    .hint = --frame weglassen

mecaprol-other-robot = Mecaprol steuert einen Fünfgelenkroboter, nicht `{ $model }`
    .hint = ein anderes --format verwenden

target-unreachable = Ziel { $target }: { $reason }
    .hint = das Ziel verschieben oder die Grenzen in robot.toml prüfen

pose-unreachable = Pose { $pose }: { $reason }
    .hint = die Pose und die Grenzen in robot.toml prüfen

controller-format-unknown = `{ $name }` ist kein Steuerungsformat

hash-of-other-format = `--controller-hash` gilt für die Formate, die ihn enthalten: { $formats }
    .hint = eines davon mit --format angeben

run-while-exporting = ein Lauf schrieb `{ $folder }`, während Steuerungsdateien entstanden
    .hint = den Befehl wiederholen: sie können von früheren Parametern stammen

fit-file-missing = für `{ $element }` ist keine Datei angegeben
    .hint = die Datei angeben: etalon fit { $element } DATEI

fit-element-missing = das Element ist nicht angegeben, und die Datei ist nicht QIF
    .hint = es angeben: etalon fit ELEMENT { $file }

qif-with-columns = eine QIF-Datei hat weder Spalten noch einen Radius für alle Elemente
    .hint = --columns, --delimiter und --radius-mm weglassen

no-feature-fitted = kein gemessenes Element wurde als { $kind } angepasst
    .expected = Elemente mit Punkten, die sie bestimmen
    .hint = Elemente mit Punkten in der Datei: { $seen }

probe-side-unknown = --probe-side: `{ $text }` ist keine Seite
    .expected = inside, outside oder drei Zahlen x,y,z zum Taster
    .hint = inside für eine Bohrung, outside für eine Welle, 0,0,1 für einen Taster über einer Ebene

probe-side-missing = die Seite des Tasters ist nicht angegeben
    .expected = --probe-side inside, outside oder x,y,z
    .hint = inside für eine Bohrung, outside für eine Welle, die Richtung zum Taster für Ebene oder Gerade

probe-radius-missing = --probe-side ohne Taster
    .expected = --probe-radius-mm
    .hint = den qualifizierten Radius des Tasters angeben oder bei Kontaktpunkten beides weglassen

enclosing-with-probe = { $element } wird nicht um einen Taster korrigiert
    .hint = --probe-radius-mm und --probe-side weglassen

enclosing-minimum-zone = es gibt keine Minimumzone von { $element }
    .hint = --minimum-zone weglassen oder circle2d oder sphere anpassen

uncertainty-implausible = { $option } ist keine Unsicherheit einer Koordinate in Mikrometern
    .hint = erweiterte Unsicherheit durch Erweiterungsfaktor, je Koordinate: 0.0027 mm sind 2.7 um

robot-not-in-table = die Geometrie von `{ $name }` ist nicht in der Robotertabelle
    .expected = { $names }
    .hint = ihn durch seine URDF beschreiben: --urdf DATEI

iso230-row-incomplete = eine Zeile hat keine Position, keinen Messwert oder keine Richtung
    .expected = Zahlen und +1 oder -1 als `direction`

iso230-no-rows = die Tabelle hat keine Zeilen
    .hint = die Datei prüfen

iso230-few-runs = Position { $position } mm hat weniger als zwei Läufe in Richtung { $direction }
    .expected = Läufe von beiden Seiten, fünf nach ISO 230-2

nothing-to-evaluate = nichts zum Auswerten ist angegeben
    .hint = Posen, Aufzeichnung oder Lasten angeben: `etalon iso9283 --help`

drift-set-too-small = { $option } muss mindestens 2 sein
    .hint = die Zahl der Zyklen eines Satzes angeben

commanded-missing = keine Sollposen angegeben: AP ist nicht bestimmt (null); RP braucht keine
    .hint = für AP, Abstände und Drift mit --commanded angeben

infinite-solutions = { $joints } Gelenke erreichen eine Pose auf unendlich viele Arten
    .hint = nach einer fragen: --nearest

no-whole-pose = `{ $model }` hat keine Kinematik einer ganzen Pose
    .hint = ein anderes Modell verwenden

table-quaternion-length = die Quaternion hat die Länge { FIXED($length, 4) }
    .expected = 1: qw, qx, qy, qz einer Drehung
    .hint = die Reihenfolge der Spalten prüfen (qw ist der Skalarteil), und dass es keine Winkel sind

not-a-report = `{ $file }` endet nicht wie ein Bericht
    .expected = eine Datei, die auf { $endings } endet

report-folder-missing = kein Ordner ist angegeben
    .hint = den Ausgabeordner eines Laufs angeben

earlier-run-left = nichts ist geschrieben: `{ $report }` und die Dateien daneben sind von einem früheren Lauf
    .hint = seine Steuerungsdateien nicht laden, als wären sie von diesem

schema-unknown = es gibt kein Schema `{ $name }`

verify-other-column = die Beobachtungen haben eine Spalte `{ $column }`: nur Positionen werden verglichen
    .hint = Zeilen anderer Arten und ihre Spalten weglassen

workspace-numbers = --workspace-mm hat { $count } Zahlen
    .expected = sechs, oder vier für ebene Roboter

reorientation-alone = eine Umorientierung ohne Anfangsorientierung
    .hint = auch --orientation-deg angeben

reach-unknown = die Roboterdatei des Modells `{ $model }` nennt seine Reichweite nicht
    .hint = --robot weglassen und die Orte am Roboter mit kleiner Geschwindigkeit probieren

excluded-rows = ausgeschlossen: { $count ->
        [one] 1 Zeile
       *[other] { $count } Zeilen
    }, Zeilen { $rows }: { $reason }

controller-error-not-measured = Format `{ $format }` enthält { $parameters } nicht: seine Datei ist auf ihre Nennwerte bedingt, und ihr Fehler wurde nicht gemessen
    .hint = die Kampagne mit "{ $format }" unter ihren `controllers` ausführen und aus ihrem Ausgabeordner exportieren

from-needs-robot = --from braucht den Roboter
    .hint = ihn nennen: --robot ur5e, oder --urdf DATEI

two-files-of-one-name = zwei Dateien heißen `{ $name }`
    .hint = einer davon einen anderen Namen geben

proposal-not-toml = der Vorschlag für `{ $name }` ist nicht lesbar: { $error }

nothing-recognised = in `{ $name }` wird nichts erkannt
    .hint = `etalon formats { $path }` nennt, was seine Spalten sein können

table-to-evaluate-missing = die auszuwertende Tabelle fehlt

option-of-call-refused = { $reason }

table-options-refused = { $fault ->
        [axes] eine Tabelle hat eine Basisachse oder zwei verschiedene
        [positions] die Tabelle hat mehr als { $most } Positionen
        [zero] --zero-at braucht eine Position je Basisachse
        [numbers] --numbers braucht eine Nummer je Achse
        [sign-missing] der Hersteller veröffentlicht das Vorzeichen der Werte dieser Tabelle nicht: --sign fehlt
        [sign-known] --sign gilt für Tabellen, deren Vorzeichen nicht veröffentlicht ist
        [plane] eine Ebene braucht zwei Basisachsen
        [one-axis] diese Tabelle hat eine Basisachse
       *[own-axis] diese Tabelle hat eine Basisachse, die korrigierte Achse
    }
    .hint = { $fault ->
        [sign-missing] --sign add oder --sign subtract angeben, nach einem Versuch an einer Position der Maschine
       *[other] die Option berichtigen; `etalon axis-table --help` beschreibt sie
    }

deviation-unknown = keine Abweichung bei { $position }: { $reason ->
        [not-measured] die Steigung wurde dort nicht gemessen
        [no-error] `{ $axis }` hat in diesem Modell keine eigenen Fehler
       *[other] { $reason }
    }
    .hint = Positionen verwenden, die der Roboter erreicht oder die gemessen wurden

robot-file-of-run = die Kampagne noch einmal ausführen oder die robot.toml angeben, mit der sie ausgeführt wurde

convert-no-chain = `{ $model }` ist keine Kette von Gelenken und hat keine andere Konvention

convert-shared-joints = { $axes } Achsen teilen sich { $joints } Gelenkwerte
    .hint = die URDF behalten, in der `mimic` das angibt

convert-left-out = { $count ->
        [one] 1 Parameter ist
       *[other] { $count } Parameter sind
    } keine Geometrie und weggelassen: { $names }
    .hint = `bending`, `harmonics`, `backlash` und `coupling` in der neuen Datei angeben und neu identifizieren

convert-gains-not-held = eine URDF hat keine Übersetzung von { $joints }: ihre Gelenkwerte sind die der Achsen
    .hint = die Gelenkwerte multiplizieren oder in `poe` umwandeln

convert-travel-unknown = der Hub von { $joints } ist nicht angegeben: die URDF hat 1 m nach beiden Seiten
    .hint = `limit` in der Datei berichtigen oder `travel_mm` in robot.toml angeben

enclosing-robust = `{ $element }` wird von seinen äußersten Punkten gehalten: keiner kann beiseitegelegt werden
    .hint = circle2d oder sphere mit --robust ausgleichen

qif-robust = Elemente einer QIF-Datei werden aus allen ihren Punkten ausgeglichen
    .hint = --robust weglassen oder die Punkte aus einer Tabelle ausgleichen

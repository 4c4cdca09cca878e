### Meldungen von cli; Erklärungen in en/cli.ftl.

batch-done = fertig
batch-failed = fehlgeschlagen
batch-not-done = { $ended }: { $campaign }
batch-not-met = nicht eingehalten
batch-skipped = übersprungen
batch-unchanged = { $ended }, unverändert
message-unknown = `{ $id }` ist nicht die Kennung einer Meldung

option-not-positive = { $option } muss positiv sein
    .hint = eine positive Zahl angeben

option-refused = { $option }: { $reason }
    .hint = `etalon BEFEHL --help` nennt die zulässigen Werte

column-option-malformed = --{ $option }: `{ $text }` hat kein `=`
    .expected = { $option ->
        [column] q1_deg=J1
        [constant] kind=distance
       *[other] deleted=1
    }

option-columns-twice = --columns und --column nennen beide die Spalten
    .hint = eine der beiden Optionen weglassen

option-unit-missing = die Längeneinheit der Dateien ist nicht angegeben
    .hint = die Einheit angeben: --unit mm, m, um oder inch; sie wird nie geraten

robot-option-missing = parameters.json braucht --robot DATEI
    .hint = die robot.toml angeben: --robot DATEI

axis-unknown = der Roboter hat keine Achse `{ $axis }`
    .hint = ein Gelenk des Roboters oder x_mm, y_mm, z_mm verwenden

axes-mixed = die Achsen einer Tabelle sind entweder kartesisch (x_mm, y_mm, z_mm) oder Gelenke
    .expected = Gelenke { $joints }

table-of-turning-joints = eine Tabelle mehrerer Gelenke braucht Schubgelenke in Reihe
    .hint = x_mm und y_mm verwenden: Positionen des nominalen Roboters

lead-not-measured = für `{ $axis }` wurde keine Steigung gemessen
    .expected = { $measured }

lead-of-one-axis = eine Steigung korrigiert eine einzelne Achse nach deren eigener Position
    .hint = nur diese Achse angeben

table-value-missing = ein Wert fehlt oder ist keine Zahl
    .hint = die Zeile berichtigen oder entfernen

not-a-grid = die Positionen bilden kein Raster
    .expected = eine Zeile für jede Position jeder Basisachse

axis-without-positions = `{ $axis }` hat keine Positionen
    .expected = --axis { $axis }=VON:BIS:SCHRITT

configuration-changed = Ziel { $target }: der kompensierte Sollwert braucht eine andere Konfiguration
    .hint = das Ziel von der Singularität entfernen oder seine Konfigurationsdaten (Arbeitsmodus, confdata, Status und Turn) prüfen

poses-computed-by-program = von { $names } berechnete Posen werden nicht kompensiert
    .hint = diese Posen prüfen: eine aus einem kompensierten Ziel berechnete Pose enthält die Kompensation des Ziels, nicht ihre eigene

working-mode-missing = das Programm gibt an seinem Anfang keinen Arbeitsmodus an
    .hint = die Gelenkwerte am Anfang angeben: --start N,N,+1

program-frames = das Programm verwendet { $names }

one-program-each = das Programm aufteilen: ein Programm für jedes

state-pose-option = seine Pose angeben: --{ $option } x,y,z,qw,qx,qy,qz

program-frame-other = das Programm gibt { $frame } an, --{ $option } eine andere Pose
    .hint = die Pose des Programms angeben: --{ $option } { $pose }

program-in-world = Ziele eines Programms können nicht im Weltkoordinatensystem sein
    .hint = --object verwenden

counts-missing = `galil` braucht die Zahl der Geberinkremente je mm oder deg von { $axes } Achsen
    .hint = --counts-per-unit N,N angeben

joints-in-world = Gelenkwerte haben kein Koordinatensystem
    .hint = --frame weglassen

nominal-pose-unreachable = der nominale Roboter hat bei diesen Gelenkwerten keine Pose
    .hint = Gelenkwerte und Montagemodus prüfen

pose-singular = Pose { $pose } ist singulär: { $joints } können sich gemeinsam bewegen, ohne das Werkzeug zu bewegen; angegeben ist die Lösung, die dem Start am nächsten liegt
    .hint = Gelenkwerte in der Zeile angeben, um eine andere Lösung zu wählen, oder die Pose meiden

base-not-in-world = `{ $model }` hat keine Basis im Weltkoordinatensystem
    .hint = --frame weglassen

mecaprol-other-robot = Mecaprol steuert einen Fünfgelenkroboter, nicht `{ $model }`
    .hint = ein anderes --format verwenden

target-unreachable = Ziel { $target }: { $reason }
    .hint = das Ziel verschieben oder die Grenzen in robot.toml prüfen

pose-unreachable = Pose { $pose }: { $reason }
    .hint = die Pose und die Grenzen in robot.toml prüfen

hash-of-other-format = `--controller-hash` gilt nur für Formate, die diese Prüfsumme enthalten: { $formats }
    .hint = eines davon mit --format angeben

run-while-exporting = ein Lauf schrieb `{ $folder }`, während Steuerungsdateien entstanden
    .hint = den Befehl wiederholen: die Dateien können von früheren Parametern stammen

fit-file-missing = für `{ $element }` ist keine Datei mit Punkten angegeben
    .hint = die Datei angeben: etalon fit { $element } DATEI

fit-element-missing = das Element ist nicht angegeben, und die Datei ist keine QIF-Datei
    .hint = es angeben: etalon fit ELEMENT { $file }

qif-with-columns = eine QIF-Datei hat weder Spalten noch einen gemeinsamen Radius für alle Geometrieelemente
    .hint = --columns, --delimiter und --radius-mm weglassen

tracim-object-unknown = das Element `{ $object }` des Datensatzes `{ $id }` ist in dieser Prüfung unbekannt
    .expected = LINE_3D, PLANE, CIRCLE, CYLINDER, CONE oder SPHERE (Gauß); LINE_2D, CIRCLE_2D, PLANE, SPHERE oder CYLINDER (Tschebyscheff)

tracim-customer-missing = der Kunde fehlt in der Antwort: der Server lehnt sie ab
    .hint = --customer NAME angeben, wie bei TraCIM registriert

tracim-form-name = der Name des Elements `formDeviation` steht nicht in den öffentlichen Dokumenten der Tschebyscheff-Prüfung
    .hint = die Antwort zuerst mit der kostenlosen Beispielprüfung des Servers erproben, dann eine Prüfung bestellen

no-feature-fitted = kein gemessenes Geometrieelement wurde angepasst; gesucht: { $kind }
    .expected = Geometrieelemente mit Punkten, die sie bestimmen
    .hint = Geometrieelemente mit Punkten in der Datei: { $seen }

probe-side-unknown = --probe-side: `{ $text }` ist keine Seite
    .expected = inside, outside oder drei Zahlen x,y,z zum Taster
    .hint = inside für eine Bohrung, outside für eine Welle, 0,0,1 für einen Taster über einer Ebene

probe-side-missing = die Seite des Tasters ist nicht angegeben
    .expected = --probe-side inside, outside oder x,y,z
    .hint = inside für eine Bohrung, outside für eine Welle, die Richtung zum Taster für Ebene oder Gerade

probe-radius-missing = --probe-side ist ohne Tasterradius angegeben
    .expected = --probe-radius-mm
    .hint = den eingemessenen Radius des Tasters angeben oder bei Kontaktpunkten beides weglassen

enclosing-with-probe = { $element } wird nicht um den Tasterradius korrigiert
    .hint = --probe-radius-mm und --probe-side weglassen

enclosing-minimum-zone = für das Element { $element } gibt es keine Minimumzone
    .hint = --minimum-zone weglassen oder circle2d oder sphere anpassen

uncertainty-implausible = { $option } kann nicht die Unsicherheit einer Koordinate in Mikrometern sein
    .hint = die erweiterte Messunsicherheit geteilt durch den Erweiterungsfaktor angeben, je Koordinate: 0,0027 mm sind 2,7 µm
state-expanded-um = in Mikrometern je Koordinate angeben (k = 2): 0,0027 mm sind 2,7 µm

robot-not-in-table = die Geometrie von `{ $name }` steht nicht in der Robotertabelle
    .expected = { $names }
    .hint = ihn durch die eigene Roboterdatei beschreiben, --robot robot.toml, oder durch seine URDF-Datei, --urdf DATEI

iso230-row-incomplete = { $column ->
        [direction] `direction` ist weder +1 noch -1
       *[other] `{ $column }` fehlt oder ist nicht endlich
    }
    .expected = Zahlen und als `direction` +1 oder -1

iso230-columns-exchanged = `position_mm` und `measured_mm` sind vertauscht: die Werte von `measured_mm` wiederholen sich, die Werte von `position_mm` nicht
    .hint = die Spalten tauschen: `--column position_mm=measured_mm`, `--column measured_mm=position_mm`

iso230-few-runs = Position { $position } mm hat weniger als zwei Anfahrten in Richtung { $direction }
    .expected = mindestens zwei Anfahrten in jeder Richtung, nach ISO 230-2 fünf

drift-set-too-small = { $option } muss mindestens 2 sein
    .hint = die Zahl der Zyklen eines Satzes angeben

commanded-missing = es sind keine Sollposen angegeben: AP wird nicht ausgewertet (`null`); RP braucht keine Sollposen
    .hint = für AP, Abstände und Drift die Sollposen mit --commanded angeben

infinite-solutions = { $joints } Gelenke erreichen eine Pose auf unendlich viele Arten
    .hint = eine davon wählen: --nearest

no-whole-pose = das Modell `{ $model }` hat keine Kinematik der vollständigen Pose
    .hint = ein anderes Modell verwenden

several-branches = ein Roboter mit mehreren Zweigen ({ $links }) hat keine einzelne Kette
    .hint = ein Glied als `tool_link` in einer robot.toml angeben, die auf die kalibrierte URDF-Datei verweist: `etalon export --format urdf` schreibt den kalibrierten Baum

table-quaternion-length = das Quaternion hat die Länge { FIXED($length, 4) }
    .expected = 1: qw, qx, qy, qz einer Drehung
    .hint = prüfen, ob die Reihenfolge der Spalten stimmt (qw ist der Skalarteil) und ob es keine Winkel sind

not-a-report = `{ $file }` hat nicht die Endung eines Berichts
    .expected = eine Datei, deren Name auf { $endings } endet

earlier-run-left = nichts wurde geschrieben: `{ $report }` und die Dateien daneben stammen von einem früheren Lauf
    .hint = keine Steuerungsdateien aus diesem Ordner laden: sie gehören zum früheren Lauf

certificate-of-earlier-inputs = der Lauf ist älter als die Änderungen von { $files }: der Kalibrierschein würde den früheren Stand zeigen
    .hint = die Kampagne erneut ausführen, dann den Kalibrierschein schreiben

report-of-earlier-inputs = der Lauf ist älter als die Änderungen von { $files }: der Bericht zeigt den früheren Stand
    .hint = die Kampagne erneut ausführen, damit der Bericht die Änderungen enthält

schema-unknown = unbekanntes Schema `{ $name }`

verify-quantity-without-residuals = die Kalibrierung hat keine Residuen der Größe „{ $quantity }“: ihr Modellfehler ist unbekannt
    .hint = diese Zeilen weglassen oder mit Beobachtungen dieser Größe kalibrieren

verify-without-observations = keine Zeile der Tabelle enthält eine Beobachtung
    .hint = erneut messen, was bei der Kalibrierung gemessen wurde: Positionen, Abstände, Berührungen

readings-of-calibration = { $count } von { $rows } Zeilen sind Messwerten der Kalibrierung gleich: sie überprüfen nichts
    .hint = Exporte und Protokolle durch die der neuen Messung ersetzen

options-of-table-for-campaign = Optionen von Tabellen wirken nicht auf die Kampagne `{ $campaign }`
    .hint = in ihrer campaign.toml angeben, wie ihre Dateien gelesen werden

campaign-without-observations = die Kampagne `{ $campaign }` hat keinen Abschnitt `[observations]`
    .hint = eine Kampagne mit diesem Abschnitt oder die Optionen von Tabellen (`--column` ...) angeben

campaign-with-several-observations = die Kampagne `{ $campaign }` hat { $count } Abschnitte `[[observations]]`; welcher davon die Tabelle beschreibt, ist offen
    .hint = die Optionen von Tabellen (`--column` ...) statt `--like` angeben

workspace-numbers = --workspace-mm hat { $count ->
        [one] 1 Zahl
       *[other] { $count } Zahlen
    }
    .expected = sechs, oder vier für ebene Roboter

reorientation-alone = eine Umorientierung ist ohne Anfangsorientierung angegeben
    .hint = auch --orientation-deg angeben

reach-unknown = die Roboterdatei des Modells `{ $model }` nennt seine Reichweite nicht
    .hint = --robot weglassen und die Positionen am Roboter mit kleiner Geschwindigkeit erproben

excluded-rows = ausgeschlossen: { $count ->
        [one] 1 Zeile
       *[other] { $count } Zeilen
    }, Zeilen { $rows }: { $reason }

controller-error-not-measured = Format `{ $format }` enthält { $parameters } nicht: seine Datei setzt die Nennwerte dieser Parameter voraus, und ihre Abweichung wurde nicht gemessen
    .hint = die Kampagne mit "{ $format }" in `controllers` ausführen und aus ihrem Ausgabeordner exportieren; empfohlene Parameter: `etalon export KAMPAGNE --parameters recommended`

nothing-to-load-by-run = nach der Antwort des Laufs nicht zu laden: { $reason }
    .hint = die nächsten Schritte des Berichts ausführen und die Kampagne erneut ausführen; `etalon recommend` erklärt die Antwort

from-needs-robot = --from braucht einen Roboter
    .hint = ihn angeben: --robot ur5e, --robot robot.toml für die eigene Roboterdatei oder --urdf DATEI

two-files-of-one-name = zwei Dateien heißen `{ $name }`
    .hint = einer davon einen anderen Namen geben

proposal-not-toml = der Vorschlag für `{ $name }` ist nicht lesbar: { $error }
urdf-chain-chosen = die Kette von `{ $base }` bis `{ $tool }` mit { $count ->
        [one] einem Gelenk
       *[other] { $count } Gelenken
    } wurde gewählt; andere Ketten enden an { $others }
    .hint = wenn ein anderes Glied die Zielmarken trägt, `tool_link` in robot.toml angeben; in Python `Robot.from_urdf(path, tool_link="{ $other }")`

tool-link-longest = die Kette mit den meisten beweglichen Gelenken: die Dateien haben keine Gelenke
tool-link-by-names = die Dateien nennen die Gelenke dieser Kette
tool-link-by-count = die Dateien haben { $count } Gelenkspalten; nur diese Kette hat ebenso viele Gelenke
tool-link-by-residual = mit dieser Kette gibt der nominale Roboter die Punkte mit einem Residuum von { FIXED($rms_mm, 2) } mm wieder, mit jeder anderen mindestens mit dem Dreifachen
tool-link-shortest = mit dieser Kette gibt der nominale Roboter die Punkte mit einem Residuum von { FIXED($rms_mm, 2) } mm wieder; weitere Gelenke verkleinern es nicht
tool-link-moves = die Dateien nennen die Gelenke dieser Kette; weitere Gelenke bewegen sich nicht
tool-link-fits = `{ $link }` passt zu den Dateien: die Gelenke sind { $joints }

nothing-recognised = in `{ $name }` ist keine Spalte erkannt
    .hint = `etalon formats { $path }` nennt mögliche Bedeutungen der Spalten

option-of-call-refused = { $reason }

table-options-refused = { $fault ->
        [axes] eine Tabelle hat eine Basisachse oder zwei verschiedene Basisachsen
        [positions] die Tabelle hat mehr als { $most } Positionen
        [zero] --zero-at braucht eine Position je Basisachse
        [numbers] --numbers braucht eine Nummer je Achse
        [sign-missing] der Hersteller veröffentlicht das Vorzeichen der Werte dieser Tabelle nicht: --sign fehlt
        [sign-known] --sign gilt für Tabellen, deren Vorzeichen nicht veröffentlicht ist
        [plane] eine Ebene braucht zwei Basisachsen
        [one-axis] diese Tabelle hat nur eine Basisachse
       *[own-axis] diese Tabelle hat nur eine Basisachse, nämlich die korrigierte Achse
    }
    .hint = { $fault ->
        [sign-missing] --sign add oder --sign subtract angeben, nach einem Versuch an einer Position der Maschine
       *[other] die Option berichtigen; `etalon axis-table --help` beschreibt sie
    }

deviation-unknown = keine Abweichung bei { $position }: { $reason }
    .hint = Positionen verwenden, die der Roboter erreicht oder die gemessen wurden

robot-file-of-run = die Kampagne erneut ausführen oder die robot.toml angeben, mit der sie ausgeführt wurde
convert-no-chain = `{ $model }` hat keine Gelenkkette: andere Konventionen können dieses Modell nicht beschreiben

convert-shared-joints = { $axes } Achsen teilen sich { $joints } Gelenkwerte
    .hint = die URDF-Datei behalten, in der `mimic` dies angibt

convert-left-out = { $count ->
        [one] 1 Parameter ist
       *[other] { $count } Parameter sind
    } nicht Teil der Geometrie und daher weggelassen: { $names }
    .hint = `bending`, `harmonics`, `backlash` und `coupling` in der neuen Datei angeben und neu identifizieren

convert-gains-not-held = eine URDF-Datei enthält keinen Übertragungsfaktor von { $joints }: ihre Gelenkwerte sind Achswerte
    .hint = die Gelenkwerte multiplizieren oder in `poe` umwandeln

convert-travel-unknown = der Verfahrweg von { $joints } ist nicht angegeben: die URDF-Datei enthält 1 m nach beiden Seiten
    .hint = `limit` in der Datei berichtigen oder `travel_mm` in robot.toml angeben

convert-not-reproduced = die umgewandelte Beschreibung gibt den Roboter nicht wieder: der Flansch weicht um bis zu { FIXED($off_mm, 6) } mm und { FIXED($off_deg, 6) } deg ab
    .hint = die Längen der Roboterdatei prüfen: sehr große verlieren Stellen

enclosing-robust = die äußersten Punkte bestimmen das umschließende Element `{ $element }`: eine robuste Anpassung würde sie ausschließen
    .hint = circle2d oder sphere mit --robust anpassen

qif-robust = die Geometrieelemente einer QIF-Datei werden an alle ihre Punkte angepasst
    .hint = --robust weglassen oder an die Punkte einer Tabelle anpassen
axis-without-errors = die Achse hat in diesem Modell keine eigenen Abweichungen
lead-not-measured-there = die Steigung wurde an dieser Position nicht gemessen
table-without-row = die Tabelle hat keine Zeile für diese Position

test-point-unreached = Punkt { $point } der Liste `{ $list }` wird nicht erreicht: { $reason }
    .hint = den Arbeitsraum verschieben oder verkleinern (--workspace-mm) oder eine andere Orientierung angeben (--orientation-deg)

no-candidate-generated = keine von { $draws } Ziehungen ist ein Kandidat: { $counts }
    .hint = die Bedingung lockern, die die meisten Ziehungen ausschließt: Grenzen und `--range` (deg, mm), `--box` (mm, Basis des Roboters), `--reflector`, `--instrument`, `--obstacle` und `--link`

few-candidates-generated = { $found } von { $wanted } Kandidaten in { $draws } Ziehungen gefunden: { $counts }
    .hint = die Bedingung lockern, die die meisten Ziehungen ausschließt: Grenzen und `--range` (deg, mm), `--box` (mm, Basis des Roboters), `--reflector` und `--instrument`

draws-beyond-limits = { $count } außerhalb der Grenzen von Gelenken oder Gliedern oder ohne Pose

draws-outside-box = { $count } mit einer Zielmarke außerhalb des Quaders (innerhalb der Grenzen liegen die Zielmarken in x { FIXED($x0, 0) } bis { FIXED($x1, 0) }, y { FIXED($y0, 0) } bis { FIXED($y1, 0) }, z { FIXED($z0, 0) } bis { FIXED($z1, 0) } mm)

draws-facing-away = { $count } mit einem Reflektor, der vom Messgerät abgewandt ist ({ $reversed } davon wären ihm mit umgekehrten Achsen zugewandt)

joint-range-missing = Gelenk { $joint } hat keine Grenzen
    .hint = sie in der Roboterdatei oder als `--range { $column }=VON:BIS` angeben

range-joint-unknown = `--range { $column }`: der Roboter hat kein solches Gelenk

range-outside-limits = die Bereiche von Gelenk { $joint } und seine Grenzen ({ FIXED($from, 3) } bis { FIXED($to, 3) } { $unit }) haben keinen Wert gemeinsam
    .hint = Einheit und Vorzeichen von `--range` prüfen

reflector-missing = erzeugte Kandidaten brauchen mindestens einen Reflektor am Flansch
    .hint = ihn angeben: `--reflector A=X,Y,Z` (mm im Flansch)

reflector-twice = Reflektor { $name } ist zweimal angegeben
    .hint = jedem Reflektor einen eigenen Namen geben

reflector-of-own-targets = `{ $model }` hat eigene Zielmarken: Reflektoren und ein Messgerät können nicht angegeben werden
    .hint = `--reflector` und `--instrument` weglassen

sight-incomplete = { $missing ->
        [axis] kein Reflektor hat eine Achse, die dem Messgerät zugewandt sein kann
       *[other] für die Reflektoren mit einer Achse ist kein Messgerät angegeben
    }
    .hint = { $missing ->
        [axis] die Achse im Flansch und den halben Akzeptanzwinkel angeben: `--reflector A=X,Y,Z,I,J,K,WINKEL`
       *[other] seine Position in der Basis angeben: `--instrument X,Y,Z`
    }

obstacle-twice = Hindernis { $name } ist zweimal angegeben
    .hint = jedem Hindernis einen eigenen Namen geben

instrument-inside-obstacle = das Messgerät liegt im Hindernis { $name }
    .hint = beide prüfen (mm, Basis des Roboters)

reflector-inside-link = Reflektor { $reflector } liegt im Glied von Gelenk { $joint }, das ihn trägt
    .hint = einen kleineren Radius oder die Enden des Glieds angeben: `--link { $joint }=RADIUS,X,Y,Z,X,Y,Z`

link-joint-unknown = der Roboter hat kein Gelenk { $joint }

links-unsuited = ein Roboter des Modells `{ $model }` ist keine einfache Kette von Gelenken: Glieder können nicht angegeben werden
    .hint = `--link` weglassen; feste Körper als `--obstacle` angeben

draws-hidden = { $count } mit einem Reflektor, den { $obstacle } verdeckt

box-axis-unknown = `--box`: Zielmarken dieses Roboters haben keine Achse `{ $name }`
    .expected = { $dimension ->
        [2] x oder y
       *[other] x, y oder z
    }

box-missing = Kandidaten von `{ $model }` werden nach Position gezogen: x und y von `--box` fehlen
    .hint = den Bereich in der Basis des Roboters angeben: `--box x=VON:BIS,y=VON:BIS` (mm)

check-not-detectable = mit diesen Daten nicht aufdeckbar: { $what } (kontrolliert durch { $keys })
check-source = { $rows ->
        [one] { $file }: 1 Zeile, { $refused } abgelehnt ({ $dialect })
       *[other] { $file }: { $rows } Zeilen, { $refused } abgelehnt ({ $dialect })
    }
check-verdict = { $warnings ->
        [0] { $file }: alles in Ordnung
        [one] { $file }: keine Fehler, 1 Warnung
       *[other] { $file }: keine Fehler, { $warnings } Warnungen
    }
study-head = Abweichung: { $error }.
    Mittel von { $runs } Kalibrierungen, { $draws } Ziehungen: Median [95 % der Ziehungen].
study-set = Satz
study-noise = Rauschen µm
study-error = Abweichung
study-rms-before = RMS vorher
study-rms = RMS
study-largest = max.
study-parameter = Parameter
study-actual = wahr
study-mean = Mittel
study-spread = 3 s
targets-compensated = { $count ->
        [one] 1 Ziel kompensiert
       *[other] { $count } Ziele kompensiert
    }; { $left ->
        [one] 1 Ziel in Gelenkwerten unverändert
       *[other] { $left } Ziele in Gelenkwerten unverändert
    }
batch-counts = { $done } fertig, { $not_met } mit nicht eingehaltenen Grenzwerten, { $failed } fehlgeschlagen, { $skipped } übersprungen
run-skipped = übersprungen: { $campaign } benötigt Daten unter ${ $name }; die Variable ist nicht gesetzt
no-controller-files = keine Steuerungsdatei wird geschrieben: das Ergebnis ist nicht plausibel
next-recommend = { $command } zeigt den Beitrag jedes Parameters; Steuerungsdateien sind im Ausgabeordner{ $withheld ->
        [0] {""}
       *[other] , als nicht zu laden gekennzeichnet
    }
unmodelled-said = simulierte Abweichungen, die kein Parameter beschreibt: { $error }
unmodelled-backlash = Umkehrspiel { $joints }
unmodelled-interpolation = Interpolation des Gebers { $joints }
unmodelled-every = { $joint } { $amplitude } alle { $period }
unmodelled-homing = Referenzfahrt (Standardabweichung) { $joints }
unmodelled-growth = Wärmedehnung { $growth } µm je Meter und Stunde
unmodelled-bending = Durchbiegung { $bending } µm in einem Meter Abstand von der Basis
axis-table-largest = { $count ->
        [one] 1 Position, größte Abweichung { FIXED($largest, 6) } { $unit }
       *[other] { $count } Positionen, größte Abweichung { FIXED($largest, 6) } { $unit }
    }
iso230-accuracy = Genauigkeit A
iso230-systematic = systematische Positionierabweichung E
iso230-repeatability = Wiederholgenauigkeit R
iso230-mean-systematic = mittlere systematische Abweichung M
iso230-reversal = Umkehrspanne B
iso230-mean-reversal = mittlere Umkehrspanne
iso230-both = beidseitig
iso230-positive = positiv
iso230-negative = negativ
fit-seen-none = keine
fit-any-element = jedes Element
zone-by-least-squares = --minimum-zone weglassen: die Anpassung erfolgt dann nach der Methode der kleinsten Quadrate
fit-head = { $element }: { $count ->
        [one] 1 Punkt
       *[other] { $count } Punkte
    }
fit-center = Mittelpunkt
fit-point = Punkt
fit-normal = Normale
fit-axis = Achse
fit-radius = Radius
fit-minor-radius = kleiner Radius
fit-apex-angle = Öffnungswinkel
fit-residuals = Residuen
fit-flatness = Ebenheit
fit-held-by = Stützpunkte
fit-proof = Nachweis
fit-probe = Taster
fit-probe-center = Tastermitte
fit-its-radius = ihr Radius
fit-stated-point = angegeb. Punkt
fit-stated-direction = {"  "}Richtung
fit-stated-radius = {"  "}Radius
fit-stated-minor-radius = {"  "}kl. Radius
fit-stated-apex-angle = {"  "}Öffn.winkel
fit-held-points = Punkte { $upper } und { $lower }
fit-proof-global = keine andere Zone ist schmaler
fit-proof-local = keine benachbarte Zone ist schmaler
fit-proof-none = keiner
fit-spread = RMS { $rms }, max. { $max }, Form { $form }
fit-off = { $value } { $unit }, angepasst { $off } { $unit }
fit-apart = { $value }, angepasst { $apart } { $unit } entfernt
axes-head = { $joint } { $kind ->
        [slides] (Schubgelenk)
       *[turns] (Drehgelenk)
    }: { $count ->
        [one] 1 Messwert
       *[other] { $count } Messwerte
    }{ $aside ->
        [0] {""}
       *[other] , { $aside } ausgeschlossen
    }
axes-direction = {"  "}Richtung     { $direction }  (u = { $u } deg)
axes-point = {"  "}Punkt        { $point }  (u = { $u } mm)
axes-circle = {"  "}`{ $target }`  Radius { $radius } mm (u = { $u } mm), Bogen { $arc } deg
axes-line = {"  "}`{ $target }`  Länge { $length } mm
axes-error-motions = {"    "}radiale Bewegungsabweichung { $radial } µm (Rauschen allein { $radial_noise } µm), an der Stirnfläche { $face } µm (Rauschen allein { $face_noise } µm)
axes-straightness = {"    "}Geradheit { $radial } µm (Rauschen allein { $radial_noise } µm) und { $face } µm (Rauschen allein { $face_noise } µm)
axes-axial-and-tilt = {"  "}axiale Bewegungsabweichung { $axial } µm (Rauschen allein { $axial_noise } µm), Kippbewegungsabweichung { $tilt } deg (Rauschen allein { $tilt_noise } deg)
axes-motion = {"  "}Bewegung     { $ratio } × Gelenkwert (u = { $u }), Differenz { $rms } { $unit } (RMS)
axes-base = Basis ({ $rule })
axes-origin = {"  "}Ursprung     { $point }
axes-target = Zielmarke `{ $target }` am Flansch
axes-check-pose = Kontrollpose, Zeile { $line }: { $distance } mm vom Roboter  (u = { $u } mm je Komponente)
next-paste = diese Zeilen in campaign.toml einfügen; `etalon check ORDNER` probiert sie aus
next-paste-refused = { $next }; sie würden abgelehnt: { $reasons }
next-simulate = { $command } schreibt die Exporte und das Protokoll
next-copy = die Exporte und das Protokoll in { $folder } kopieren; `etalon formats DATEI` schlägt für jede Datei vor, wie sie zu lesen ist; { $command }
next-check-asks = { $command } fragt nach { $keys }
next-check-refused = { $next }; der Vorschlag würde dann abgelehnt: { $reasons }
next-command = { $command }
units-of-joints = den Einheiten der Gelenke
unit-of-times = der Einheit der Zeiten
unit-of-rotations = der Einheit der Drehungen
axis-steps-not-whole = von { $from } bis { $to } sind keine ganzen Schritte von { $step }
assignment-without-number = `{ $name }` hat keine Zahl
newer-than-unreadable = die Datei von `--newer-than` kann nicht gelesen werden: { $reason }
pose-argument-expected = erwartet: x,y,z in mm oder diese Werte und ein Einheitsquaternion qw,qx,qy,qz
axis-name-expected = der Name einer Achse besteht aus Buchstaben und Ziffern
stdout-not-written = stdout kann nicht geschrieben werden
plan-side = Seite { $side } mm, Prüfebene { $plane }
converted-by = umgewandelt mit etalon robot convert
convert-base-of-table = Basis der Tabelle in der Basis des Roboters: xyz { $xyz_mm } mm, rpy { $rpy_deg } deg
convert-flange-of-table = Flansch des Roboters im Flansch der Tabelle: xyz { $xyz_mm } mm, rpy { $rpy_deg } deg
from-other-joints = die Datei hat { $columns } Gelenkspalten, der Roboter { $joints } Gelenke: die überzähligen Spalten weglassen
from-joints-in-order = die Gelenkspalten gelten in der Reihenfolge der Datei als Gelenke von robot.toml
from-unit-of-joints = für UNIT deg, rad, mm, m oder um schreiben: die Datei gibt sie nicht an

cell-frame = { $name ->
        [tool] Werkzeug
        [target] Zielmarke
        [sensor] Sensor
        [base] Basis
        [world] Messsystem
        [object] Werkstückkoordinatensystem
       *[axis] Achse
    } { $reference ->
        [flange] im Flansch
        [base] in der Basis
        [world] im Messsystem
       *[points] in den Punkten
    }
cell-point = { $name ->
        [tool] Werkzeugpunkt
       *[fixed] fester Punkt
    } { $reference ->
        [flange] im Flansch
        [base] in der Basis
        [world] im Messsystem
       *[points] in den Punkten
    }
cell-position = {"  "}Position     { $position } mm{ $known ->
        [no] {""}
       *[yes] {"  "}(u = { $u } mm)
    }
cell-quaternion = {"  "}Quaternion   { $quaternion }{ $known ->
        [no] {""}
       *[yes] {"  "}(u = { $u } deg um x y z)
    }
cell-axis = { $kind ->
        [linear] Linearachse
       *[rotary] Drehachse
    }
cell-direction = {"  "}Richtung     { $direction }
cell-axis-scale = {"  "}Maßstab      { $scale } × Achswert{ $known ->
        [no] {""}
       *[yes] {"  "}(u = { $u })
    }
cell-residuals = { $measure ->
        [position] Position
       *[orientation] Orientierung
    }: Standardabweichung der Residuen { $deviation } { $measure ->
        [position] mm
       *[orientation] deg
    }, Redundanz { $redundancy }; Unsicherheiten aus { $source ->
        [stated] den Angaben
       *[residuals] den Residuen
    }
cell-largest-residual = { $measure ->
        [position] größtes Residuum der Position:
       *[orientation] größtes Residuum der Orientierung:
    } { $length } { $measure ->
        [position] mm
       *[orientation] deg
    }, Zeile { $line }

targets-beyond-field = { $count ->
        [one] Ziel { $targets } liegt
       *[other] Ziele { $targets } liegen
    } außerhalb des Residuenfelds, wo es abklingt
    .hint = Kalibrierposen in diesem Bereich messen
controller-calibrated = die Steuerung rechnet mit der Werkskalibrierung ihres eigenen Arms; die Befehle stimmen nur, wenn { $robot } diese Werte enthält
    .hint = die Werte der Kalibrierdatei der Steuerung in { $robot } eintragen oder nach dem Laden einige Posen messen
parameters-expired = die Parameter gelten bis { $last }; heute ist der { $today }
    .hint = einige Posen messen und `etalon verify` verwenden oder neu kalibrieren
date-in-future = `{ $key }` ({ $date }) liegt nach dem heutigen Tag ({ $today })
    .hint = das Datum oder die Uhr dieses Rechners korrigieren

backlash-not-in-table = die Tabelle hat einen Wert für beide Richtungen; das Umkehrspiel von `{ $axis }`, bis { FIXED($backlash, 5) } { $unit }, ist nicht enthalten
    .hint = es als Umkehrspiel der Achse in der Steuerung angeben

option-column-ambiguous = --column nennt für `{ $column }` sowohl `{ $first }` als auch `{ $second }`, und `{ $file }` hat beide
    .hint = nur eine davon nennen

predictions-missing = { $count ->
        [one] eine gemessene Zeile hat keine Vorhersage: Pose { $pose }, Zielmarke `{ $target }`
       *[other] { $count } gemessene Zeilen haben keine Vorhersage, zuerst Pose { $pose }, Zielmarke `{ $target }`
    }
    .hint = jede Zeile der Tabelle der Gelenkwerte vorhersagen

prediction-repeated = Pose { $pose }, Zielmarke `{ $target }` ist zweimal vorhergesagt, zuerst in Zeile { $line }
    .hint = je Pose und Zielmarke eine Zeile angeben

benchmark-counts = { $poses } Posen
benchmark-position = Position
benchmark-orientation = Orientierung
benchmark-mean = Mittel
benchmark-rms = RMS
benchmark-p95 = 95 %
benchmark-max = Maximum
benchmark-coverage = Überdeckung
benchmark-width = Breite
benchmark-score = Bewertung

### Proposals for reading a file: contents of columns, evidence, doubts and questions.

ask-anchor = der Punkt, von dem der Abstand gemessen ist: `other` in `constants`
ask-angle-unit = die Einheit der Winkel: `angle_unit` in `format`
ask-joint-states = welches Gelenk des Roboters jede Spalte ist; JointState hat rad für Drehgelenke, m für Schubgelenke: für ein Schubgelenk `q1_m` schreiben
ask-joints = welches Gelenk jede Spalte ist und ihre Einheit
ask-joints-of-format = welches Gelenk jede Spalte ist, und ihre Einheit, wo sie unbekannt ist
ask-log-of-format = ob es ist: { $what } (`[log]` mit `format = "{ $format }"`)
ask-order-of-columns = ob die Spalten x, y, z in dieser Reihenfolge sind oder Winkel und Abstände
ask-recorded-motion = ob es eine aufgezeichnete Bewegung ist, wie vorgeschlagen, oder Punkte mit Zeiten (dann [[export]])
ask-rotation = ob die drei ein Drehvektor sind oder Winkel, und in welcher Reihenfolge sie drehen
ask-seconds = ob `{ $name }` in Sekunden ist (sonst `time_ms`, `time_ns`)
ask-sign-of-difference = ob die Differenz Soll minus Ist ist, wie vorgeschlagen, oder Ist minus Soll (dann `+`)
ask-targets-of-topics = welche Zielmarke jedes Thema mit Posen oder Punkten ist
ask-unit = die Einheit der Längen
ask-unit-of-size = die Einheit der Längen: die größte ist { $largest }, also passt { $units ->
        [inch-or-mm] inch oder mm
       *[other] { $units }
    } zu einem Roboter
because-arrays = sie enthält Felder von { $format }
because-arrays-of-numbers = die Zahlenfelder sind { $arrays }
because-columns = { $read } von { $rows } Zeilen haben Zahlen, in { $columns ->
        [one] 1 Spalte
       *[other] { $columns } Spalten
    }
because-columns-of = die Spalten sind: { $what }
because-comments = Zeilen, die mit `{ $comment }` beginnen, sind Kommentare
because-decimal-marks = { $fractions } von { $numbers } Zahlen haben das Dezimalzeichen `{ $mark }`
because-end = die letzte Zeile ist das Wort `{ $end }`
because-fields = { $read } von { $rows } Zeilen haben { $fields } Felder, getrennt durch `{ $delimiter }`
because-it-is = es ist { $what }
because-line = Zeile { $line } { $is ->
        [header] benennt die Spalten
       *[last] ist die letzte vor den Daten
    }
because-log = ein Protokoll: { $reason }
because-numbers = jede Zeile hat { $count } Zahlen, und keine Richtung darunter
because-recording = es ist eine Aufzeichnung von ROS 2: sie beginnt wie eine MCAP-Datei
because-sampled = die Werte der ersten { $rows } Zeilen wurden geprüft; die Datei hat mehr
because-several-points = die Überschriften nennen { $count } gemessene Punkte je Zeile: jeder ist ein [[export]] der Datei
because-topic = das Thema `{ $topic }` hat { $count ->
        [one] 1 Nachricht
       *[other] { $count } Nachrichten
    } vom Typ { $message_type }
doubt-all-commanded = jede Koordinate heißt Sollwert: keine Messung
doubt-bare-metre = die Überschriften enden auf `_m`: Meter oder „gemessen“
doubt-columns-not-read = nicht gelesene Zahlen: Spalte { $columns }
doubt-coordinates-left = Koordinaten von { $left } sind nicht genommen: andere haben eine passendere Überschrift
doubt-dates = Daten mit `/` sagen nicht, ob Tag oder Monat zuerst kommt: sie werden nicht gelesen
doubt-decimal-mark = keine Zahl hat ein Dezimalzeichen: dass es `{ $mark }` ist, ist nicht belegt
doubt-direction-length = die Richtung hat nicht in allen Zeilen die Länge 1
doubt-encoding = die Datei ist nicht UTF-8; prüfen, ob ihre Buchstaben als { $encoding } lesbar sind
doubt-first-increases = Spalte 1 steigt in allen Zeilen: eine Zeit oder eine Koordinate
doubt-four-joints = vier Gelenke q0 bis q3 hätten dieselben Überschriften
doubt-in-line = Zeile { $line }: { $problem }
doubt-joints-without-headings = { $count } Zahlen ohne Überschriften: Gelenke oder Koordinaten und Winkel
doubt-matrix-order = eine Matrix ohne Überschriften: zeilenweise, vom Körper in die Welt
doubt-more-problems = und { $count ->
        [one] 1 weiteres Problem
       *[other] { $count } weitere Probleme
    } dieser Art
doubt-order-of-joints = die Gelenke sind in der Datei ungeordnet: sie gelten in der Reihenfolge ihrer Nummern
doubt-origin = Zeile { $line } ist 0 0 0: gilt als „nicht gemessen“, wenn `missing` nichts anderes angibt
doubt-other-reading = { $reading }, { $columns ->
        [one] 1 Spalte
       *[other] { $columns } Spalten
    } erklärt sie ebenso: eine Zeile von Hand prüfen
doubt-other-sheets = die Arbeitsmappe hat { $count ->
        [one] 1 weiteres Blatt
       *[other] { $count } weitere Blätter
    }: { $sheets }
doubt-points-without-headings = { $count } Zahlen ohne Überschriften: die ersten drei sind genommen; mehrere Punkte je Zeile sind mehrere [[export]] mit Spalten nach Nummer
doubt-polar = ein Azimut und ein Abstand, ohne Zenit- oder Höhenwinkel
doubt-quaternion-length = das Quaternion hat nicht in allen Zeilen die Länge 1
doubt-quaternion-order = ein Quaternion ohne Überschriften: Skalar zuletzt, wie ROS es schreibt, oder zuerst
doubt-rows-not-read = { $count ->
        [one] 1 Zeile
       *[other] { $count } Zeilen
    } so nicht lesbar, die erste ist Zeile { $line }
doubt-rows-refused = Zeile { $line }: { $reason }, und { $more } weitere
doubt-second-log = auch das Thema `{ $topic }` hat Gelenkwerte
doubt-sign-of-difference = das Vorzeichen der Differenz ist nicht angegeben: eine Zeile mit der Messung vergleichen
doubt-six-without-headings = sechs Zahlen ohne Überschriften: eine Position und drei Winkel oder Gelenke, davon drei Schubgelenke
doubt-thousands-mark = jedes `{ $mark }` steht vor drei Ziffern: es kann ein Tausendertrennzeichen sein
doubt-time-decreases = { $column } heißt Zeit und fällt
doubt-topic-unreadable = das Thema `{ $topic }` ist nicht lesbar: { $reason }
doubt-two-families = { $names } könnten auch Gelenke sein: `{ $kept }` ist genommen
doubt-unnamed-joints = nichts sagt, dass { $names } Gelenke sind: sonst passt nichts
doubt-words-of-header = Zeile { $line } hat { $words } Wörter für { $columns } Spalten: die Reihenfolge ist unbekannt
is-aqdef = eine Datei im ASCII-Transferformat von Q-DAS, nach dem ersten Feld
is-attained-poses = Istposen einer Prüfung nach ISO 9283
is-calypso = eine Tabelle von Zeiss Calypso, nach der Kopfzeile
is-commanded-poses = Sollposen oder Kandidaten für `etalon plan`
is-compliance-test = eine Prüfung der statischen Nachgiebigkeit
is-dmis = DMIS-Ausgabe, nach dem ersten Satz
is-drilled-plate = eine Tabelle von Bohrungen in Spalten fester Breite, nach der Kopfzeile
is-galil-arrays = ein Abzug von Galil-Feldern: nur ganze Zahlen unter Namen in alphabetischer Reihenfolge
is-geopak-scan = ein Scan von GEOPAK-Win, nach dem ersten Satz
is-kuka-rsi = eine Aufzeichnung von KUKA RSI: die Kopfzeile nennt den Zähler `IPOC`
is-leica-at960 = ein Export eines Leica AT960 oder AT930 in sechs Freiheitsgraden, nach der Kopfzeile
is-leica-emscon = eine Liste stationärer Punkte, gemessen über die emScon-Schnittstelle von Leica, nach der Kopfzeile
is-observations = eine Tabelle von Beobachtungen
is-pcdmis = eine .xyz-Datei von PC-DMIS, nach der ersten Zeile
is-ply = eine PLY-Datei, nach der ersten Zeile
is-polyworks-project = eine Projektbeschreibung von PolyWorks|Inspector, nach der ersten Zeile
is-polyworks-report = ein Bericht von PolyWorks mit einer Zeile je Prüfung, nach der Kopfzeile
is-qif = ein QIF-Dokument
is-recorded-motion = eine aufgezeichnete Bewegung
is-reference-targets = Referenzmarken, die von Zeit zu Zeit gemessen sind
is-ros-messages = Nachrichten von ROS: die Kopfzeile ist die von `rostopic echo -p`
is-spatialanalyzer = ein Punktexport von SpatialAnalyzer, nach den Kommentaren
is-twincat = ein Export von Beckhoff TwinCAT 3 Scope: der Kopf nennt den Beginn des Exports
is-ur-rtde = eine RTDE-Aufzeichnung von Universal Robots: die Kopfzeile hat die RTDE-Namen der Gelenkpositionen
is-vda-fs = eine VDA-FS-Datei, nach dem Kopf
means-azimuth = Azimut
means-clock = Datum und Uhrzeit
means-commanded = Soll-{ $axis }
means-count = eine laufende Nummer
means-cycle = Nummer der Wiederholung
means-day = Datum
means-deleted = Marke gelöschter Zeilen
means-difference = Differenz von { $axis }
means-direction = Richtung { $component }
means-distance = Abstand
means-elevation = Höhenwinkel
means-expanded-uncertainty = erweiterte Messunsicherheit von { $axis }
means-joint = Gelenk { $number }
means-label = Bezeichnung des Punkts
means-matrix = Drehmatrix r{ $row }{ $column }
means-matrix-end = letzte Zeile einer 4x4-Matrix
means-measured = gemessenes { $axis }
means-measured-of-point = gemessenes { $axis } des Punkts { $number }
means-motion = Geschwindigkeit, Kraft oder Strom
means-other-joint = Sollwert eines Gelenks
means-pose = Name der Pose
means-quaternion = Quaternion { $component }
means-rotation = Drehung, Nummer { $number } von drei
means-target = Name der Zielmarke
means-temperature = Temperatur
means-text = ein Text, den nichts liest
means-time = Zeit
means-time-of-day = Uhrzeit
means-uncertainty = Standardunsicherheit, Nummer { $number }
means-unknown = unbekannt
means-zenith = Zenitwinkel
names-of-columns = { $said }: { $names }
says-commanded-and-difference = die Kopfzeile nennt einen Sollpunkt und seine Differenz
says-joints = die Kopfzeile nennt Gelenke
says-joints-and-length = Gelenke und eine Länge je Zeile
says-joints-beside = die Kopfzeile nennt Gelenke neben den Punkten
says-orientations = die Kopfzeile nennt Orientierungen
why-ambiguous-dates = Daten, deren Tag und Monat vertauscht sein könnten
why-as-many-as-joints = jede Zeile hat so viele Zahlen wie ein Arm Gelenke, und keine Richtung darunter
why-axes-differ = die Überschriften dreier Spalten unterscheiden sich nur in x, y, z
why-behind-lengths = hinter drei Längen, die größer als jeder Winkel sind
why-commanded-heading = die Überschrift nennt einen Sollwert
why-commanded-rotation = die Überschrift nennt eine Solldrehung
why-counts = ganze Zahlen, die um 1 steigen
why-counts-first = ganze Zahlen, die von Zeile zu Zeile steigen, am Zeilenanfang
why-dates = jede Zelle ist ein Datum oder eine Uhrzeit
why-difference-heading = die Überschrift nennt eine Differenz
why-empty = sie ist leer
why-fits-without = der nominale Roboter passt ohne sie
why-four-of-length-one = die vier haben in allen Zeilen die Länge 1
why-heading = die Überschrift
why-heading-and-four = die Überschrift, und die vier haben in allen Zeilen die Länge 1
why-heading-and-three = die Überschrift, und die drei haben in allen Zeilen die Länge 1
why-heading-increases = die Überschrift; sie steigt in allen Zeilen
why-heading-ordered = die Überschrift; sie fällt nie
why-heading-unordered = die Überschrift, obwohl sie nicht steigt
why-in-unit = { $why }, in { $unit }
why-increases = sie steigt in allen Zeilen, die anderen nicht
why-kinematics-fit = die Kinematik des nominalen Roboters passt damit in { $unit }{ $way ->
        [reversed] , mit umgekehrter Zählrichtung
       *[forward] {""}
    }
why-last-of-matrix = letzte Spalte einer 4x4-Matrix mit orthonormaler Drehung
why-measured-heading = die Überschrift nennt einen Messwert
why-nine-orthonormal = die neun bilden in allen Zeilen eine orthonormale Matrix
why-nothing-known = die Überschrift ist unbekannt
why-orthonormal = orthonormal in allen Zeilen, zeilenweise
why-other-family = die Gelenke sind aus den Spalten `{ $kept }` genommen
why-others-measured = die Überschrift nennt einen Sollwert, und andere sind gemessen
why-place = ihre Stelle: nichts benennt die Spalten
why-quaternion-not-joints = die vier haben in allen Zeilen die Länge 1: ein Quaternion, Skalar zuerst, keine Gelenke
why-range-of-deg = die Überschrift; von { $low } bis { $high }: in rad mehr als eine Umdrehung, also passt deg oder mm
why-range-of-rad = die Überschrift; von { $low } bis { $high }: rad oder m passt
why-repeats-as-texts = die Überschrift nennt Wiederholungen, die Spalte enthält Texte
why-robot-computes = der nominale Roboter berechnet sie bis auf die Rundung
why-robot-reproduces = der nominale Roboter gibt die drei Spalten wieder
why-row-0001 = die Zeile 0 0 0 1
why-targets-fit = mit einer Zielmarke je Wert passt der nominale Roboter
why-text-before = ein Text vor den Zahlen
why-text-behind = ein Text hinter Zahlen
why-texts-differ = Texte vor den Zahlen, die sich von Zeile zu Zeile unterscheiden
why-three-of-length-one = die drei haben in allen Zeilen die Länge 1
why-whole-before-decimals = ganze Zahlen vor Zahlen mit Dezimalzeichen

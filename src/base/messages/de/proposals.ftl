### Proposals for reading a file: contents of columns, evidence, doubts and questions.

ask-anchor = der Punkt, von dem aus der Abstand gemessen ist: `other` in `constants`
ask-angle-unit = die Einheit der Winkel: `angle_unit` in `format`
ask-blocks = zu welcher Zielmarke und Pose jeder der { $count } Blöcke gehört: die Überschriften stehen vor seinen Zeilen wieder, zum zweiten Mal in Zeile { $line }
ask-computed-by-controller = ob ein Messgerät `{ $body }` gemessen hat, wie vorgeschlagen: die Überschriften der Gelenke haben dieselben Wörter, also kann die Steuerung es berechnet haben; andere Koordinaten sind { $others }
ask-direction = per_count: -1, wenn entgegen dem Gelenk gezählt wird, wie die Punkte zeigen; 1, wenn robot.toml zu berichtigen ist
ask-direction-of-columns = { $columns }, wie die Punkte zeigen; ohne `-1 *`, wenn robot.toml zu berichtigen ist
ask-joint-states = zu welchem Gelenk des Roboters jede Spalte gehört; JointState enthält rad für Drehgelenke und m für Schubgelenke: für ein Schubgelenk `q1_m` schreiben
ask-joints = zu welchem Gelenk jede Spalte gehört, und ihre Einheit
ask-joints-again = welche Gelenke zum Roboter gehören: ihre Überschriften stehen { $count }-mal da. Angenommen sind die ersten, { $names }
ask-joints-of-format = zu welchem Gelenk jede Spalte gehört, und ihre Einheit, wenn sie unbekannt ist
ask-log-of-format = ob es Folgendes ist: { $what } (`[log]` mit `format = "{ $format }"`)
ask-numbers-without-headings = welche der { $count } Zahlen einer Zeile Gelenke sind und welche der gemessene Punkt: die Datei hat keine Überschriften. `--robot` findet Gelenke und Punkt mit der Kinematik
ask-number-with-gaps = ob { $column } wie vorgeschlagen die Nummer der Pose ist: sie springt von { $before } auf { $after }, die Nummer der Zeile ist also eine andere
ask-order-of-columns = ob die Spalten x, y, z in dieser Reihenfolge sind oder Winkel und Abstände
ask-other-arrays = welches Array die Messung enthält: angenommen ist `{ $used }`. Ebenso viele Spalten haben { $others }{ $more ->
        [0] {""}
       *[other] {" "}und { $more } weitere
    }
ask-points-in-row = ob die { $numbers } Zahlen einer Zeile wie vorgeschlagen { $count } Punkte zu drei Koordinaten sind: die Spalten sind nicht benannt
ask-quaternion-order = welche der Spalten { $columns } der Skalar des Quaternions ist: angenommen ist die { $used ->
        [last] letzte
       *[first] erste
    }
ask-recorded-motion = ob es eine aufgezeichnete Bewegung ist, wie vorgeschlagen, oder Punkte mit Zeitpunkten (dann [[export]])
ask-rotation = ob die drei Zahlen ein Rotationsvektor sind oder Winkel, und in welcher Reihenfolge diese drehen
ask-sets-alike = was die Spalten { $first } und die Spalten { $second } sind (ihre Überschriften sind gleich oder ihre Werte fast gleich): zwei Zielmarken oder Sollkoordinaten und gemessene Koordinaten
ask-sign-of-difference = ob die Differenz Sollwert minus Messwert ist, wie vorgeschlagen, oder Messwert minus Sollwert (dann `+`)
ask-targets-of-topics = zu welcher Zielmarke jedes Topic mit Posen oder Punkten gehört
ask-text-in-all-rows = ob `{ $text }`, derselbe Text in allen Zeilen, die Zielmarke ist, wie vorgeschlagen, oder ein Code
ask-time-unit = die Einheit der Zeiten in { $column }: der Schritt ist { $step }
ask-two-frames = ob `{ $first }` und `{ $second }` zwei Zielmarken sind oder ein Punkt in zwei Koordinatensystemen: die Abstände von Zeile zu Zeile stimmen überein. `etalon cell` findet die Beziehung zweier Koordinatensysteme
ask-unit = die Einheit der Längen
ask-unit-of-size = die Einheit der Längen: die größte ist { $largest }, also passt { $units ->
        [inch-or-mm] inch oder mm
       *[other] { $units }
    } zu einem Roboter
because-arrays = sie enthält Arrays von { $format }
because-arrays-of-numbers = ihre Arrays aus Zahlen sind: { $arrays }
because-columns = { $read } von { $rows } Zeilen enthalten Zahlen, in { $columns ->
        [one] 1 Spalte
       *[other] { $columns } Spalten
    }
because-columns-of = ihre Spalten gehören zu: { $what }
because-comments = Zeilen, die mit `{ $comment }` beginnen, sind Kommentare
because-decimal-marks = { $fractions } von { $numbers } Zahlen haben das Dezimalzeichen `{ $mark }`
because-end = die letzte Zeile ist das Wort `{ $end }`
because-fields = { $read } von { $rows } Zeilen haben { $fields } Felder, getrennt durch `{ $delimiter }`
because-it-is = es ist Folgendes: { $what }
because-joints-named = die Gelenke heißen wie die Gelenke des Roboters
because-line = Zeile { $line } { $is ->
        [header] benennt die Spalten
       *[last] ist die letzte vor den Daten
    }
because-log = ein Protokoll: { $reason }
because-numbers = jede Zeile hat { $count } Zahlen, von denen keine drei einen Einheitsvektor bilden
because-recording = es ist eine Aufzeichnung von ROS 2: { $storage ->
        [db3] eine SQLite-Datenbank mit Topics
       *[mcap] sie beginnt wie eine MCAP-Datei
    }
because-sampled = die Werte der ersten { $rows } Zeilen wurden geprüft; die Datei enthält mehr
because-columns-sampled = die ersten { $columns } von { $width } Spalten wurden geprüft
because-several-points = die Überschriften nennen { $count } gemessene Punkte je Zeile: jeder ist ein [[export]] der Datei
because-test-of-poses = eine Prüfung nach ISO 9283: in mehreren Zyklen angefahrene Posen, und jede dieser Posen einmal
because-topic = das Topic `{ $topic }` hat { $count ->
        [one] 1 Nachricht
       *[other] { $count } Nachrichten
    } vom Typ { $message_type }
because-unit-stated = Zeile { $line } gibt die Einheit an: { $how }
doubt-all-commanded = die Überschriften aller Koordinaten bezeichnen Sollwerte: die Datei enthält keine gemessenen Koordinaten
doubt-bare-metre = die Überschriften enden auf `_m`: Meter oder „gemessen“
doubt-columns-not-read = nicht gelesene Zahlen: Spalte { $columns }{ $more ->
        [0] {""}
       *[other] {" "}und { $more } weitere
    }
doubt-computed-by-controller = angenommen ist `{ $used }`. Die Überschriften von `{ $body }` haben die Wörter der Gelenke, also hat die Steuerung die Werte berechnet
doubt-controller-pose = Koordinaten von `{ $body }` hat möglicherweise die Steuerung berechnet: ein Messgerät misst eine Zielmarke
doubt-coordinates-left = Koordinaten von { $left } werden nicht verwendet: andere haben eine passendere Überschrift
doubt-dates = Datumsangaben mit `/` lassen offen, ob Tag oder Monat zuerst kommt: sie werden nicht gelesen
doubt-decimal-mark = keine Zahl hat ein Dezimalzeichen: `{ $mark }` wird angenommen
doubt-direction-length = die Richtung hat nicht in allen Zeilen den Betrag 1
doubt-encoding = die Datei ist nicht UTF-8; sie wird als { $encoding } gelesen: prüfen, ob ihre Buchstaben (°, µ, Umlaute) stimmen
doubt-first-increases = Spalte 1 steigt in allen Zeilen: ein Zeitpunkt oder eine Koordinate
doubt-four-joints = vier Gelenke q0 bis q3 hätten dieselben Überschriften
doubt-in-line = Zeile { $line }: { $problem }
doubt-groups-alone = Zeile { $line } benennt Gruppen von Spalten: drei Spalten einer Gruppe gelten als x, y, z
doubt-joints-without-headings = { $count } Zahlen ohne Überschriften: Gelenke oder Koordinaten und Winkel
doubt-matrix-order = eine Matrix ohne Überschriften: zeilenweise gelesen, dreht sie Vektoren vom Körper in das Weltkoordinatensystem
doubt-more-problems = und { $count ->
        [one] 1 weiteres Problem
       *[other] { $count } weitere Probleme
    } dieser Art
doubt-one-row = eine Zeile mit { $count } Zahlen ohne Überschriften: ein Programm hat ein Array in eine Zeile geschrieben; seine Aufteilung ist nicht erkennbar
doubt-order-of-joints = die Gelenke stehen in der Datei nicht der Reihe nach: sie werden nach ihren Nummern oder nach den Teilen des Arms geordnet
doubt-orientation-of-body = die Orientierung `{ $body }` wird dem gemessenen Punkt zugeordnet: ihre Überschriften nennen einen anderen Körper
doubt-origin = Zeile { $line } ist 0 0 0: sie gilt als „nicht gemessen“, wenn `missing` nichts anderes angibt
doubt-other-reading = { $reading }, { $columns ->
        [one] 1 Spalte
       *[other] { $columns } Spalten
    }, erklärt sie ebenso gut: eine Zeile selbst prüfen
doubt-other-sheets = die Arbeitsmappe hat { $count ->
        [one] 1 weiteres Blatt
       *[other] { $count } weitere Blätter
    }: { $sheets }
doubt-polar = ein Azimut und ein Abstand, ohne Zenitwinkel oder Höhenwinkel
doubt-pose-of-robot = `{ $body }` ist eine Pose des Roboters in denselben Zeilen: `etalon cell --solve { $solve }` findet ihre Beziehung zur Messung
doubt-quaternion-length = das Quaternion hat nicht in allen Zeilen den Betrag 1
doubt-quaternion-order = ein Quaternion ohne Überschriften: Skalar zuletzt, wie ROS es schreibt, oder zuerst
doubt-rows-not-read = { $count ->
        [one] 1 Zeile
       *[other] { $count } Zeilen
    } so nicht lesbar; die erste ist Zeile { $line }
doubt-rows-refused = Zeile { $line }: { $reason }; weitere Zeilen: { $more }
doubt-scanned = die Zahlen hinter x, y, z werden für Intensität und Farbe gehalten: ganze Zahlen bis 255
doubt-second-log = auch das Topic `{ $topic }` hat Gelenkwerte
doubt-sets-by-difference = die Spalten { $difference } sind in allen Zeilen die Differenz der Spalten { $measured } und { $commanded }: als Messwert minus Sollwert gelesen
doubt-several-logs = { $count } Protokolle: { $first } identifiziert den Roboter, die anderen werden damit verglichen; Zeilen einer Aufzeichnung in mehreren Dateien gehören in eine Datei
doubt-summary = das Blatt `{ $sheet }` bleibt weg: die anderen Blätter enthalten alle seine Zeilen
doubt-sign-of-difference = das Vorzeichen der Differenz ist nicht angegeben: eine Zeile mit der Messung vergleichen
doubt-six-without-headings = sechs Zahlen ohne Überschriften: eine Position und drei Winkel oder Gelenke, davon drei Schubgelenke
doubt-stationary-points = ihre { $count } Punkte gelten als ruhend: ihre Namen könnten Posen sein, aber eine andere Datei hat { $poses } Posen
doubt-thousands-mark = jedes `{ $mark }` steht vor drei Ziffern: es kann ein Tausendertrennzeichen sein
doubt-time-decreases = { $column } heißt wie eine Zeit, fällt aber
doubt-topic-unreadable = das Topic `{ $topic }` kann nicht gelesen werden: { $reason }
doubt-two-families = { $names } könnten auch Gelenke sein: `{ $kept }` wird verwendet
doubt-units-differ = die Datei gibt { $unit } (Zeile { $line }) und { $of_second } (Zeile { $second }) an
doubt-transposed = { $rows } Zeilen mit { $columns } Zahlen: Zeilen und Spalten können vertauscht sein. Eine Zeile je Pose oder Zeitpunkt schreiben
doubt-unnamed-joints = { $names } werden als Gelenke gelesen: keine andere Größe passt, aber die Datei benennt sie nicht
doubt-vertical-angle = { $column } ist ein Vertikalwinkel: die Werte passen zu { $zenith ->
        [yes] einem Zenitwinkel
       *[no] einem Höhenwinkel
    }, aber die Überschrift sagt nicht, welcher es ist
doubt-words-of-header = Zeile { $line } hat { $words } Wörter für { $columns } Spalten: die Reihenfolge ist unbekannt
is-aqdef = eine Datei im ASCII-Transferformat von Q-DAS, erkannt am ersten Feld
is-attained-poses = Istposen einer Prüfung nach ISO 9283
is-calypso = eine Tabelle von Zeiss Calypso, erkannt an der Kopfzeile
is-commanded-poses = Sollposen oder Kandidaten für `etalon plan`
is-compliance-test = eine Prüfung der statischen Nachgiebigkeit
is-dmis = eine DMIS-Ausgabe, erkannt am ersten Datensatz
is-drilled-plate = eine Tabelle von Bohrungen in Spalten fester Breite, erkannt an der Kopfzeile
is-galil-arrays = aus einer Galil-Steuerung gelesene Arrays (upload): nur ganze Zahlen unter Namen in alphabetischer Reihenfolge
is-geopak-scan = ein Scan von GEOPAK-Win, erkannt am ersten Datensatz
is-kuka-rsi = eine Aufzeichnung von KUKA RSI: die Kopfzeile enthält den Zähler `IPOC`
is-leica-at960 = ein Export eines Leica AT960 oder AT930 in sechs Freiheitsgraden, erkannt an der Kopfzeile
is-leica-emscon = eine Liste stationärer Punkte, gemessen über die emScon-Schnittstelle von Leica, erkannt an der Kopfzeile
is-observations = eine Tabelle von Beobachtungen
is-pcdmis-report = ein Protokoll von PC-DMIS mit einem Block je Merkmal, erkannt an der Überschrift `AX`
is-stl = eine STL-Datei, erkannt an ihren Dreiecken
is-pcd = eine PCD-Datei, erkannt an den Zeilen FIELDS und DATA
is-e57 = eine E57-Datei eines Scanners, erkannt an den ersten Bytes
is-c3d = eine C3D-Datei einer Bewegungserfassung, erkannt an den ersten Bytes
is-fanuc-ls = ein Programm einer FANUC-Steuerung, erkannt an der ersten Zeile
is-abb-rapid = ein Modul in ABB RAPID, erkannt an MODULE und ENDMODULE
is-ptx = ein PTX-Scan, erkannt am Kopf von zehn Zeilen
is-leica-gsi = eine Datei im Format Leica GSI, erkannt an den Wörtern ihrer Zeilen
is-pcdmis = eine .xyz-Datei von PC-DMIS, erkannt an der ersten Zeile
is-ply = eine PLY-Datei, erkannt an der ersten Zeile
is-polyworks-project = eine Projektbeschreibung von PolyWorks|Inspector, erkannt an der ersten Zeile
is-polyworks-report = ein Bericht von PolyWorks mit einer Zeile je Prüfung, erkannt an der Kopfzeile
is-qif = ein QIF-Dokument
is-recorded-motion = eine aufgezeichnete Bewegung
is-reference-targets = Referenzmarken, die von Zeit zu Zeit gemessen wurden
is-ros-messages = Nachrichten von ROS: die Kopfzeile hat die Form von `rostopic echo -p`
is-spatialanalyzer = ein Punktexport von SpatialAnalyzer, erkannt an den Kommentaren
is-twincat = ein Export von Beckhoff TwinCAT 3 Scope: der Kopf nennt den Beginn des Exports
is-ur-rtde = eine RTDE-Aufzeichnung von Universal Robots: die Kopfzeile enthält die RTDE-Namen der Gelenkpositionen
is-vda-fs = eine VDA-FS-Datei, erkannt am Kopf
means-appearance = Intensität oder Farbe
means-azimuth = Azimut
means-clock = Datum und Uhrzeit
means-commanded = Sollwert von { $axis }
means-count = eine laufende Nummer
means-cycle = Nummer der Wiederholung
means-day = Datum
means-deleted = Kennzeichen gelöschter Zeilen
means-difference = Differenz von { $axis }
means-direction = Richtung { $component }
means-distance = Abstand
means-elevation = Höhenwinkel
means-expanded-uncertainty = erweiterte Messunsicherheit von { $axis }
means-joint = Gelenk { $number }
means-label = Bezeichnung des Punkts
means-matrix = Rotationsmatrix r{ $row }{ $column }
means-matrix-end = letzte Zeile einer 4x4-Matrix
means-measured = Messwert von { $axis }
means-measured-of-point = Messwert von { $axis } des Punkts { $number }
means-motion = Geschwindigkeit, Kraft oder Strom
means-other-joint = Sollwert eines Gelenks
means-other-orientation = { $component } der Orientierung eines anderen Körpers
means-pose = Name der Pose
means-quaternion = Quaternion { $component }
means-rotation = Rotation, Zahl { $number } von drei
means-target = Name der Zielmarke
means-scatter = Unsicherheit oder Streuung des ganzen Punkts
means-temperature = Temperatur
means-text = ein Text, der nicht verwendet wird
means-time = Zeitpunkt
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
why-ambiguous-dates = Datumsangaben, deren Tag und Monat vertauscht sein könnten
why-as-many-as-joints = jede Zeile hat so viele Zahlen, wie ein Arm Gelenke hat, und keine drei bilden einen Einheitsvektor
why-axes-differ = die Überschriften dreier Spalten unterscheiden sich nur in x, y und z
why-behind-lengths = nach drei Längen, die größer als jeder Winkel sind
why-colours = ganze Zahlen bis 255 hinter einem Punkt
why-commanded-heading = die Überschrift nennt einen Sollwert
why-commanded-rotation = die Überschrift nennt den Sollwert einer Rotation
why-constant = dieselbe ganze Zahl in allen Zeilen
why-counts = ganze Zahlen, die um 1 steigen
why-counts-first = ganze Zahlen, die von Zeile zu Zeile steigen, am Zeilenanfang
why-counts-with-gaps = ganze Zahlen, die mit Lücken zunehmen
why-numbers-rows = die Überschrift bedeutet eine Nummer, und jede Zeile hat eine andere
why-vertical = Vertikalwinkel nach der Überschrift, neben Azimut und Distanz
why-dates = jede Zelle ist ein Datum oder eine Uhrzeit
why-difference-heading = die Überschrift nennt eine Differenz
why-empty = sie ist leer
why-epoch = { $why }; der Größe nach { $unit } seit 1970
why-fits-without = der nominale Roboter passt ohne sie
why-four-of-length-one = die vier Zahlen haben in allen Zeilen den Betrag 1
why-heading = die Überschrift
why-heading-and-four = die Überschrift, und die vier Zahlen haben in allen Zeilen den Betrag 1
why-heading-and-three = die Überschrift, und die drei Zahlen haben in allen Zeilen den Betrag 1
why-heading-increases = die Überschrift; sie steigt in allen Zeilen
why-heading-ordered = die Überschrift; sie fällt nie
why-heading-unordered = die Überschrift, obwohl sie nicht steigt
why-in-unit = { $why }, in { $unit }
why-increases = sie steigt in allen Zeilen, die anderen nicht
why-kinematics-fit = die Kinematik des nominalen Roboters passt, wenn sie in { $unit } ist{ $way ->
        [reversed] , mit umgekehrter Zählrichtung
       *[forward] {""}
    }
why-last-of-matrix = letzte Spalte einer 4x4-Matrix mit orthonormaler Rotation
why-measured-heading = die Überschrift nennt einen Messwert
why-nine-orthonormal = die neun Zahlen bilden in allen Zeilen eine orthonormale Matrix
why-names-of-points = die Namen von Punkten, die sich nicht mit dem Roboter bewegen
why-nothing-known = die Bedeutung der Überschrift ist unbekannt
why-orthonormal = in allen Zeilen orthonormal, zeilenweise gelesen
why-other-arm = ihre Überschrift kommt noch einmal vor
why-other-body = ihre Überschrift nennt einen anderen Körper als den gemessenen Punkt
why-other-family = die Gelenke sind den Spalten `{ $kept }` entnommen
why-others-measured = die Überschrift nennt einen Sollwert, und andere Spalten sind gemessen
why-place = die Stelle der Spalte; die Spalten sind nicht benannt
why-quaternion-not-joints = die vier Zahlen haben in allen Zeilen den Betrag 1: ein Quaternion, Skalar zuerst, keine Gelenke
why-range-of-deg = die Überschrift; von { $low } bis { $high }: in rad mehr als eine Umdrehung, also passt deg oder mm
why-range-of-rad = die Überschrift; von { $low } bis { $high }: rad oder m passt
why-repeats-as-texts = die Überschrift nennt Wiederholungen, die Spalte enthält Texte
why-robot-computes = der nominale Roboter berechnet sie bis auf die Rundung
why-robot-reproduces = der nominale Roboter reproduziert die drei Spalten
why-row-0001 = die Zeile 0 0 0 1
why-targets-fit = mit einer Zielmarke für jeden ihrer Werte passt der nominale Roboter
why-text-before = ein Text vor den Zahlen
why-text-behind = ein Text nach Zahlen
why-text-in-all-rows = derselbe Text in allen Zeilen, vor den Zahlen
why-texts-differ = Texte vor den Zahlen, die sich von Zeile zu Zeile unterscheiden
why-three-of-length-one = die drei Zahlen haben in allen Zeilen den Betrag 1
why-whole-before-decimals = ganze Zahlen vor Zahlen mit Dezimalzeichen

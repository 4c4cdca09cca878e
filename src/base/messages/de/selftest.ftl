### Meldungen von selftest; Erklärungen in en/selftest.ftl.

selftest-data-unreadable = die Referenzdaten `{ $name }` im Programm sind nicht lesbar: { $reason }
    .hint = etalon neu installieren

selftest-folder-not-written = `{ $folder }` kann nicht geschrieben werden: { $reason }
    .hint = `TMPDIR` (unter Windows `TEMP`) auf einen beschreibbaren Ordner setzen

selftest-hash-expected = ein SHA-256: 64 hexadezimale Ziffern

selftest-fits = Geometrieelemente: Anpassungen stimmen mit einem unabhängigen Programm (60 Stellen) überein, Minimumzonen und Hüllkreise mit exakten Werten
selftest-solver = Löser: veröffentlichte nichtlineare Probleme der kleinsten Quadrate ergeben die veröffentlichten Minima
selftest-frames = Koordinatensysteme: Orientierungen und Transformationen stimmen mit exakten Werten überein
selftest-kinematics = Kinematik: jedes Modell stimmt mit einem unabhängigen Programm (60 Stellen), seiner Inversen, numerischen Ableitungen und dem exportierten Code überein
selftest-identification = Identifikation: exakte Beobachtungen ergeben die Parameter; eine ganze Kampagne ergibt die wahren Werte innerhalb ihrer Unsicherheit
selftest-reference = Referenzkampagnen: Parameter, Kovarianz und Abweichungen stimmen mit einem unabhängigen Programm (110 Stellen) überein
selftest-uncertainty = Unsicherheiten: veröffentlichte Beispiele des GUM (H.1 bis H.3) und von JCGM 101 (9.2 bis 9.5) werden reproduziert
selftest-standards = ISO 9283 und ISO 230-2: die Kenngrößen stimmen mit unabhängigen Programmen überein
selftest-coverage = Überdeckung: 95-%-Intervalle enthalten den wahren Wert in 95 % der simulierten Kampagnen
selftest-formats = Exporte von Messsystemen: bekannte Texte ergeben ihre Koordinaten; jedes Format wird gelesen, wie es geschrieben wurde
selftest-exports = Dateien für Steuerungen: geschriebene Werte werden unverändert zurückgelesen
selftest-threads = Threads: dieselbe Eingabe ergibt dieselben Bytes auf einem und auf vielen Threads
selftest-nist = Referenzdaten des NIST: angepasste Elemente stimmen mit den veröffentlichten überein

selftest-not-made = { $name }: nicht möglich: { $reason }
selftest-fit-point = { $name }: Punkt
selftest-fit-direction = { $name }: Richtung
selftest-fit-size = { $name }: Radius oder Winkel
selftest-fit-squares = { $name }: Quadratsumme
selftest-fit-uncertainty = { $name }: Standardunsicherheit des Radius
selftest-zone = { $name }: Minimumzone
selftest-enclosing = { $name }: kleinster Hüllradius
selftest-sum-of-squares = { $name }: Quadratsumme am Minimum
selftest-solution = { $name }: Parameter am Minimum
selftest-covariance = { $name }: Kovarianz
selftest-quaternion = Quaternion einer Drehung
selftest-quaternion-back = Drehung eines Quaternions
selftest-rotation-vector = Rotationsmatrix eines Rotationsvektors
selftest-rotation-vector-back = Rotationsvektor einer Rotationsmatrix
selftest-rpy = Rotationsmatrix aus Roll-, Nick- und Gierwinkel
selftest-rpy-back = Roll-, Nick- und Gierwinkel einer Rotationsmatrix
selftest-apply = Transformation eines Punktes
selftest-inverse = Transformation nach ihrer Inversen
selftest-rigid = Transformation zwischen zwei Punktmengen
selftest-rigid-rms = Residuen dieser Transformation
selftest-positions = { $name }: Positionen der Zielmarken
selftest-jacobian = { $name }: Ableitungen minus numerische Ableitungen
selftest-inverse-none = { $name }: die Inverse findet keine Gelenkwerte
selftest-direct-of-inverse = { $name }: direkt(invers(Pose)) minus Pose
selftest-inverse-of-direct = { $name }: invers(direkt(Gelenke)) minus Gelenke
selftest-code = { $name }: Position nach dem exportierten `{ $format }`
selftest-recovered = { $name }: Positionen nach den Parametern aus exakten Beobachtungen
selftest-truth = { $name }: größte Abweichung eines Parameters vom wahren Wert, bezogen auf seine Unsicherheit
selftest-chi-square = Chi-Quadrat durch Freiheitsgrade
selftest-certified-values = { $name }: { $count } Parameter
selftest-certified-uncertainties = { $name }: Standardunsicherheiten
selftest-certified-status = { $name }: zu Unrecht festgehaltene oder identifizierte Parameter
selftest-certified-covariance = { $name }: Kovarianz
selftest-certified-residuals = { $name }: quadratischer Mittelwert und Chi-Quadrat
selftest-certified-errors = { $name }: Abweichungen vorher und nachher
selftest-gum = { $name }
selftest-draws-mean = { $name }: Mittelwert der Ziehungen
selftest-draws-u = { $name }: Standardunsicherheit der Ziehungen
selftest-draws-interval = { $name }: Intervall zu { $percent } %
selftest-draws-shortest = { $name }: kürzestes Intervall zu { $percent } %
selftest-linear-u = { $name }: Standardunsicherheit erster Ordnung
selftest-chi-square-table = Quantile von Chi-Quadrat
selftest-f-table = Quantil der F-Verteilung
selftest-conformity = Konformitätswahrscheinlichkeit
selftest-characteristic = { $name }
selftest-shares = Anteil der Intervalle, die den wahren Wert enthalten, { $parameters } Parameter, { $draws } Kampagnen
selftest-mean-chi-square = mittleres Chi-Quadrat durch Freiheitsgrade, { $draws } Kampagnen
selftest-read = { $name } in { $unit }: bekannter Text
selftest-written-read = { $name } in { $unit }: geschrieben und gelesen
selftest-listed = { $format }: Werte neben ihren Namen
selftest-file-robot = { $format }: Roboter, den die Datei beschreibt
selftest-same-bytes = Dateien, die sich zwischen 1 und { $threads } Threads unterscheiden, von { $files }
selftest-files-written = alle Dateien sind geschrieben
selftest-nist-sets = { $name }: größte Abweichung in { $count } Datensätzen

selftest-wrong-digit = falsche Ziffer: signifikante Ziffer { $digit } von `{ $place }`
selftest-swapped = vertauscht: `{ $first }` und `{ $second }`
selftest-wrong-unit = falsche Einheit: `{ $place }` mal { SCIENTIFIC($factor, 3) }

selftest-other-version = das abgelegte Dokument ist von etalon { $before }, das Programm ist etalon { $after }
selftest-other-input = `{ $file }` wurde geändert
selftest-new-input = `{ $file }` ist nicht unter den abgelegten Eingaben
selftest-missing-input = `{ $file }` ist keine Eingabe mehr
selftest-other-model = der Roboter war vom Modell `{ $before }` und ist vom Modell `{ $after }`

selftest-title = Validierung der Installation
selftest-subtitle = etalon { $version } unter { $system } { $architecture }; Validierung der Software vor der Verwendung (ISO/IEC 17025:2017, 7.11.2)
selftest-passed = { $checks } Prüfungen von { $requirements } Anforderungen bestanden; { $slips } von { $slips } absichtlichen Fehlern wurden erkannt
selftest-failed = { $failed ->
        [one] { $failed } von { $checks } Prüfungen ist nicht bestanden
       *[other] { $failed } von { $checks } Prüfungen sind nicht bestanden
    }
selftest-slips-missed = { $missed ->
        [one] { $missed } von { $slips } absichtlichen Fehlern wurde nicht erkannt
       *[other] { $missed } von { $slips } absichtlichen Fehlern wurden nicht erkannt
    }
selftest-program-changed = die Programmdatei hat nicht den angegebenen SHA-256
selftest-program-unreadable = die Programmdatei ist nicht lesbar
selftest-reference-changed = geänderte Referenzdaten: { $files }
selftest-values-same = Kampagne { $campaign }: { $compared } Parameter stimmen mit dem abgelegten Dokument überein
selftest-values-moved = { $moved ->
        [one] Kampagne { $campaign }: { $moved } Wert weicht vom abgelegten Dokument ab
       *[other] Kampagne { $campaign }: { $moved } Werte weichen vom abgelegten Dokument ab
    }
selftest-statement = Dieses Protokoll gilt für die Programmdatei mit diesem SHA-256, auf diesem Rechner.
selftest-overview = Anforderungen
selftest-failed-tests = Nicht bestandene Prüfungen
selftest-installation = Installation (IQ)
selftest-operation = Funktion (OQ)
selftest-slips = Absichtliche Fehler, die erkannt werden müssen
selftest-performance = Leistung (PQ)
selftest-program-hash = SHA-256 des Programms
selftest-stated-hash = angegebener SHA-256
selftest-system = System
selftest-threads-offered = Threads
selftest-packages = Pakete
selftest-packages-note = Pakete aus Cargo.lock, aus denen das Programm, seine Build-Skripte und seine Tests gebaut sind.
selftest-nist-absent = Referenzdaten des NIST: nicht vorhanden (`ETALON_REFERENCE` auf einen Ordner setzen, der sie enthält)
selftest-nist-present = Referenzdaten des NIST: vorhanden
selftest-requirement = Anforderung
selftest-tests = Prüfungen
selftest-test = Prüfung
selftest-source = Quelle
selftest-expected = erwartet
selftest-found = gefunden
selftest-deviation = Abweichung
selftest-permissible = zulässig
selftest-result = Ergebnis
selftest-result-pass = bestanden
selftest-result-fail = nicht bestanden
selftest-slip = absichtlicher Fehler
selftest-tests-failed = nicht bestandene Prüfungen
selftest-as-it-must = schlägt wie verlangt fehl
selftest-missed = nicht erkannt
selftest-reference-data = Referenzdaten
selftest-package = Paket
selftest-version = Version
selftest-quantity = Größe
selftest-over-u = Differenz / u
selftest-tolerance = Zulässig: { SCIENTIFIC($of_uncertainty, 0) } Standardunsicherheiten für einen Wert, relativ { SCIENTIFIC($of_uncertainty, 0) } für eine Unsicherheit, relativ { SCIENTIFIC($relative, 0) } für einen Wert ohne Unsicherheit.
selftest-cause = Bekannter Unterschied: { $cause }.
selftest-cause-unknown = Kein bekannter Unterschied: Version, Modell und Eingaben sind dieselben.

### Meldungen von documents; Erklärungen in en/documents.ftl.

limits-for-several-robots = Grenzwerte gelten für einen Roboter, und die Tabelle hat { $robots }
    .hint = jeden Roboter einzeln prüfen; zusammen ergeben sie die Austauschbarkeit

few-cycles = weniger als { $least } Zyklen an Pose { $poses }
    .hint = 30 Zyklen messen (ISO 9283) oder mit den Intervallen urteilen

few-cycles-of-direction = weniger als { $least } Zyklen in Richtung { $directions }
    .hint = mehr Zyklen messen

instrument-too-coarse = die Messunsicherheit übersteigt 25 % des geprüften Werts an Pose { $poses }
    .hint = die Werte als obere Schranken verwenden oder mit einem besseren Messgerät messen

several-approaches = mehrere Anfahrrichtungen an Pose { $poses }: AP, RP und ihre Intervalle gelten für alle Anfahrten zusammen
    .hint = die Werte jeder Anfahrrichtung verwenden: die aller Anfahrten enthalten vAP, und ihre Streuung ist nicht normalverteilt

path-without-pass = die Aufzeichnung enthält keinen Durchlauf der Sollbahn
    .expected = eine Bewegung durch { $planes } Ebenen, jede innerhalb von { $near_mm } mm der Bahn
    .hint = System und Richtung von Aufzeichnung und Bahn prüfen; `--near-mm` erlaubt größere Abweichungen

samples-too-fast = { $count ->
        [one] 1 Abtastwert
       *[other] { $count } Abtastwerte
    } ausgelassen: schneller als ein Roboter
    .hint = Zeile { $lines } prüfen

weave-velocity-not-compared = die Sollgeschwindigkeit wird nicht verglichen: die Bahn ist die Mittellinie eines Pendelns
    .hint = die Bahn ohne Pendeln fahren, um Geschwindigkeiten auszuwerten

arrivals-unsettled = Ankünfte, die sich nicht im Grenzband stabilisieren: bei { $times_s } s
    .hint = ein Grenzband angeben, das breiter als das Rauschen des stehenden Roboters ist

passes-incomplete = { $count ->
        [one] 1 Durchlauf
       *[other] { $count } Durchläufe
    } begonnen und nicht beendet: ausgelassen
    .hint = prüfen, ob die Aufzeichnung abgeschnitten ist; bei stark verrundeten Ecken ein größeres near_mm angeben (`--near-mm`)

corner-in-central-part = der mittlere Teil der Bahn enthält eine Ecke bei { FIXED($at_mm, 3) } mm
    .hint = eine Bahn ohne Ecke oder einen kleineren mittleren Teil angeben: Abbremsen wirkt auf AV, RV und FV

zone-proved-locally = die Minimumzone ist nur unter benachbarten Elementen ({ $element }) als engste bewiesen
    .hint = ihre Formabweichung mit der der Ausgleichung nach kleinsten Quadraten vergleichen

zone-unproved = es wurde nicht bewiesen, dass kein anderes Element { $element } eine engere Zone hat
    .hint = mehr von der Fläche messen: so gestreute Punkte zeigen das Element kaum

hold-another = um einen anderen Parameter einer solchen Gruppe festzuhalten, ihn unter `hold` in [identify] nennen; Vorgabe ist der letzte des Modells

set-up-origin = { $origin ->
        [unit] `unit` des Exports
       *[world-frame] `unit` und Bezeichnungen der Punkte, die es bestimmen
    }

check-rigid-part = Einheit und Namen in `places_mm` prüfen und ob das Teil seit ihrer Bestimmung verändert wurde

plan-cube = { $shape ->
        [square] das größte Quadrat
       *[cube] der größte Würfel
    } im angegebenen Arbeitsraum, Kanten parallel zu den Achsen; C1 bis C4 vom kleinsten x und y an
plan-poses = P1: Mitte; P2 bis P5: 10 % der Diagonalen von den Ecken der Prüfebene, in deren Reihenfolge
plan-clauses = P1 bis P5, Lasten, Geschwindigkeiten und 30 Zyklen folgen dem Text der Norm; Bahnen, andere Anzahlen und die Reihenfolge der Ecken wurden nicht mit einem gekauften Exemplar verglichen
plan-reach-not-examined = nicht geprüft: ob der Roboter die Posen erreicht und ob sich zwischen ihnen alle Gelenke bewegen
plan-reach = Reichweite: Nennparameter und die Grenzen der Roboterdatei; von mehreren Arbeitsmodi gilt entlang einer Liste der, der am meisten von ihr erreicht; { $moves ->
        [all] zwischen P1 und P5 bewegen sich alle Gelenke
       *[some] zwischen P1 und P5 bewegen sich nicht alle Gelenke, wie die Norm verlangt
    }
covariance-not-square = die Kovarianz ist nicht quadratisch mit { $identified } Zeilen, einer je identifiziertem Parameter
uncertainty-negative = eine Standardunsicherheit oder Varianz ist negativ oder keine Zahl
parameter-listed-twice = es enthält den Parameter `{ $parameter }` zweimal

method-levenberg-marquardt = Levenberg-Marquardt auf Block-QR mit skalierten Spalten, Abschluss mit Gauß-Newton
method-enclosing = kleinstes umschließendes Element, durch { $points } Punkte bestimmt
method-minimum-zone = minimale Zone (Tschebyschew)

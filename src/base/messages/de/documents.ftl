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

points-set-aside = { $count ->
        [one] 1 Punkt ist beiseitegelegt
       *[other] { $count } Punkte sind beiseitegelegt
    }: { $points }
    .hint = sie liegen weiter vom Element aller anderen, als Rauschen erklärt

foreign-points = { $count ->
        [one] 1 Punkt liegt weit vom Element aller anderen ({ $points }) und verschiebt
       *[other] { $count } Punkte liegen weit vom Element aller anderen ({ $points }) und verschieben
    } den Ausgleich um { FIXED($shift, 1) } Standardunsicherheiten
    .hint = sie ansehen; `--robust` legt sie beiseite

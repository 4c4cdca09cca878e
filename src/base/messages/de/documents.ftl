### Meldungen von documents; Erklärungen in en/documents.ftl.

limits-for-several-robots = Grenzwerte gelten für einen Roboter, die Tabelle enthält aber { $robots }
    .hint = jeden Roboter einzeln prüfen; zusammen ergeben sie die Austauschbarkeit

few-cycles = weniger als { $least } Zyklen (Posen: { $poses })
    .hint = 30 Zyklen messen (ISO 9283) oder mit den Intervallen urteilen

few-cycles-of-direction = weniger als { $least } Zyklen (Richtungen: { $directions })
    .hint = mehr Zyklen messen

instrument-too-coarse = die Messunsicherheit übersteigt 25 % der geprüften Kenngröße (Posen: { $poses })
    .hint = die Werte als Obergrenzen verwenden oder mit einem besseren Messgerät messen

several-approaches = mehrere Anfahrrichtungen (Posen: { $poses }): AP, RP und ihre Intervalle gelten für alle Anfahrten zusammen
    .hint = die Werte jeder Anfahrrichtung verwenden: die Werte aller Anfahrten zusammen enthalten vAP, und ihre Streuung ist nicht normalverteilt

path-without-pass = die Aufzeichnung enthält keinen Durchlauf der Sollbahn
    .expected = eine Bewegung durch { $planes } Ebenen, jeweils höchstens { $near_mm } mm von der Bahn entfernt
    .hint = Koordinatensystem und Richtung von Aufzeichnung und Bahn prüfen; `--near-mm` erlaubt größere Abweichungen

samples-too-fast = { $count ->
        [one] 1 Abtastwert
       *[other] { $count } Abtastwerte
    } ausgelassen: zu schnell für einen Roboter
    .hint = diese Zeilen prüfen: { $lines }

weave-velocity-not-compared = die Sollgeschwindigkeit wird nicht verglichen: die Bahn ist die Mittellinie einer Pendelbewegung
    .hint = die Bahn ohne Pendeln fahren, um Geschwindigkeiten auszuwerten

arrivals-unsettled = Ankünfte, die sich nicht im Grenzband stabilisieren: bei { $times_s } s
    .hint = ein Grenzband angeben, das breiter ist als das Rauschen des stehenden Roboters

passes-incomplete = { $count ->
        [one] 1 Durchlauf
       *[other] { $count } Durchläufe
    } begonnen und nicht beendet: ausgelassen
    .hint = prüfen, ob die Aufzeichnung abgeschnitten ist; bei stark verrundeten Ecken ein größeres near_mm angeben (`--near-mm`)

corner-in-central-part = der mittlere Teil der Bahn enthält eine Ecke bei { FIXED($at_mm, 3) } mm
    .hint = eine Bahn ohne Ecke oder einen kürzeren mittleren Teil angeben: das Abbremsen an der Ecke beeinflusst AV, RV und FV

zone-proved-locally = es ist nur unter benachbarten Elementen ({ $element }) bewiesen, dass die Minimumzone die engste ist
    .hint = ihre Formabweichung mit der Formabweichung der Anpassung nach kleinsten Quadraten vergleichen

zone-unproved = es wurde nicht bewiesen, dass kein anderes Element { $element } eine engere Zone hat
    .hint = einen größeren Teil der Fläche messen: so stark streuende Punkte bestimmen das Element kaum

hold-another = um einen anderen Parameter einer solchen Gruppe festzuhalten, ihn unter `hold` in [identify] nennen; ohne Angabe ist es der letzte des Modells

set-up-origin = { $origin ->
        [unit] `unit` des Exports
       *[world-frame] `unit` und Bezeichnungen der Punkte, die es bestimmen
    }

check-rigid-part = Einheit und Namen in `places_mm` prüfen und ob das Teil seit ihrer Bestimmung verändert wurde

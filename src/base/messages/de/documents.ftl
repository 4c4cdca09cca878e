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
action-add-cycles = Pose{ $count ->
        [one] {" "}{ $poses }
       *[other] n { $poses }
    } mindestens { $required } Mal anfahren
action-add-cycles-reason = die kleinste Zahl der Anfahrten einer Pose ist { $least }; die Intervalle von AP und RP sind daher breit
action-add-effect = `{ $line }` in robot.toml ergänzen
action-add-effect-reason = Abweichung an ausgelassenen Posen: { $without } → { $with } (quadratisches Mittel)
action-add-validation = Posen zur Validierung der Parameter messen und unter `validation` in [identify] nennen
action-add-validation-reason = Abweichungen an den Kalibrierposen allein sind kleiner als an neuen Posen
action-finer-instrument = mit einer erweiterten Unsicherheit von höchstens { $uncertainty } messen
action-finer-instrument-reason = U = { $uncertainty } ist { $percent } % der Kenngröße an Pose{ $count ->
        [one] {" "}{ $poses }
       *[other] n { $poses }
    }; ISO 9283 erlaubt 25 %
action-keep-nominal = { $count ->
        [0] die Nennparameter behalten
       *[other] { $formats } nicht laden
    }
action-keep-nominal-reason = quadratisches Mittel der Abweichung { $rms }, größte { $max }; Nennparameter: { $nominal_rms } und { $nominal_max }
action-load = `{ $file }`{ $count ->
        [0] {""}
       *[other] {" "}(oder { $others })
    } laden
action-load-reason = erwartete Abweichung { $expected }, mit Nennparametern { $nominal } (quadratisches Mittel an { $count } { $set ->
        [validation] Validierposen
       *[calibration] Kalibrierposen
    })
action-load-synthetic = `{ $file }`{ $count ->
        [0] {""}
       *[other] {" "}(oder { $others })
    } in eine simulierte Steuerung laden, nicht in einen Roboter: die Daten sind synthetisch
action-measure-again = { $count ->
        [one] Pose { $poses }
       *[other] Posen { $poses }
    } erneut messen{ $more ->
        [0] {""}
       *[other] {" "}({ $more } weitere weichen ab)
    }
action-measure-again-reason = Pose { $pose } weicht von den anderen ab: { $error }, { $times } σ
action-measure-quantity = die Größe von `{ $limit }` an den entscheidenden Posen messen oder die Grenze entfernen
action-measure-quantity-reason = eine Grenze für eine nicht gemessene Größe ist nicht beurteilbar
action-meet-limit = die Ursache der Abweichungen suchen: { $limit }
action-meet-limit-at-pose = die Ursache der Abweichung an Pose { $pose } suchen: { $limit }
action-meet-limit-reason = { $value }, Grenze { $limit }: um { $beyond } zu groß
action-prove-effects = `{ $line }` in [identify] angeben
action-reduce-uncertainty = die Unsicherheit verringern: { $limit }
action-reduce-uncertainty-by-source = U = { $present }; eine Entscheidung verlangt { $required }; größter Anteil: { $source } ({ $percent } %)
action-reduce-uncertainty-reason = U = { $present }; eine Entscheidung verlangt { $required }
action-resolve = über diese Warnung entscheiden
action-state-limits = die Toleranz der Anwendung in [limits] angeben
action-state-limits-reason = ohne Grenzen gibt es kein Urteil
action-warm-up = den Roboter vor der Prüfung warmfahren und `warm_up_minutes` angeben
action-warm-up-cold = der Roboter wurde kalt geprüft
action-warm-up-drift = AP driftet um { $change } in { $cycles } Zyklen und ist nicht stabil

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

action-add-cycles = Pose{ $count ->
        [one] {" "}{ $poses }
       *[other] n { $poses }
    } mindestens { $required } Mal anfahren
action-add-cycles-reason = die kleinste Zahl der Anfahrten einer Pose ist { $least }; die Intervalle von AP und RP sind daher breit
action-add-effect = `{ $line }` in robot.toml ergänzen
action-add-effect-reason = Abweichung an ausgelassenen Posen: { $without } → { $with } (quadratisches Mittel)
action-add-validation = Posen zur Validierung der Parameter messen und unter `validation` in [identify] nennen
action-add-validation-reason = Abweichungen an den Kalibrierposen allein sind kleiner als an neuen Posen
action-finer-instrument = mit einer erweiterten Unsicherheit einer Position von höchstens { $uncertainty } messen
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

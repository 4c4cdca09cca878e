### Meldungen von documents; Erklärungen in en/documents.ftl.

action-load-or-compensate = `{ $file }`{ $count ->
        [0] {""}
       *[other] {" "}(oder { $others })
    } in eigene Software laden: keine Steuerung liest diese Datei. Für eine Steuerung deren Format in `controllers` ergänzen oder die Programme mit `etalon compensate` korrigieren

limits-for-several-robots = Grenzwerte gelten für einen Roboter, die Tabelle enthält aber { $robots }
    .hint = jeden Roboter einzeln prüfen; nur die Austauschbarkeit wird aus allen Robotern zusammen bestimmt

few-cycles = weniger als { $least } Zyklen { $count ->
        [one] an Pose { $poses }
       *[other] an den Posen { $poses }
    }

decide-by-intervals = 30 Zyklen messen (ISO 9283) oder anhand der Intervalle entscheiden
measure-cycles = 30 Zyklen messen (ISO 9283): ein oder zwei Zyklen haben keine Intervalle

limits-without-instrument = die Grenzwerte werden ohne die Unsicherheit des Messgeräts beurteilt: U enthält nur die Streuung der Zyklen
    .hint = die erweiterte Messunsicherheit einer Koordinate angeben: `--expanded-uncertainty-um`

few-cycles-of-direction = weniger als { $least } Zyklen { $count ->
        [one] in Richtung { $directions }
       *[other] in den Richtungen { $directions }
    }
    .hint = mehr Zyklen messen

instrument-too-coarse = die Messunsicherheit übersteigt 25 % der geprüften Kenngröße { $count ->
        [one] an Pose { $poses }
       *[other] an den Posen { $poses }
    }
    .hint = das obere Ende des Intervalls von RP verwenden oder mit einem besseren Messgerät messen

positions-drift = die Position von Pose { $pose } ändert sich vom ersten bis zum letzten Zyklus um { LENGTH($change_mm) }: AP und RP enthalten diese Drift
    .hint = `drift_set` in [poses] angeben (`--drift-set`) oder den Roboter vor der Prüfung warmfahren

several-approaches = mehrere Anfahrrichtungen { $count ->
        [one] an Pose { $poses }
       *[other] an den Posen { $poses }
    }: Intervalle, Grenzwerte und 25-%-Regel gelten für jede Anfahrrichtung
    .hint = die Werte jeder Anfahrrichtung verwenden: die Werte aller Anfahrten zusammen enthalten vAP

positions-in-other-unit = { $axes } der { $table ->
        [commanded] Sollpositionen
        [robot] Positionen des Roboters { $robot }
       *[attained] Istpositionen
    } { $count ->
        [one] ist
       *[other] sind
    } in { $unit }, nicht in mm: mal { $length_mm } { $count ->
        [one] stimmt
       *[other] stimmen
    } sie mit der anderen Tabelle überein
    .hint = { $unit ->
        [cm] diese Spalten mit 10 multiplizieren
       *[other] die Spalten nach ihrer Einheit benennen (`x_{ $unit }`) oder in mm umrechnen
    }

coordinates-exchanged = die Istpositionen liegen { FIXED($deviation_mm, 1) } mm neben den Sollpositionen; { $change ->
        [swapped] sind { $columns } einer Tabelle vertauscht
        [order] stehen x, y, z in den Spalten { $columns } der Istpositionen
       *[sign] hat { $columns } einer Tabelle das andere Vorzeichen
    }, bleiben { FIXED($left_mm, 3) } mm
    .hint = diese Spalten in der falschen Tabelle berichtigen; bis dahin sind AP und AT falsch, RP der Position ist richtig

poses-in-other-frame = die Istpositionen liegen { FIXED($deviation_mm, 1) } mm neben den Sollpositionen; ohne ihre gemeinsame Verschiebung um ({ FIXED($x_mm, 1) }, { FIXED($y_mm, 1) }, { FIXED($z_mm, 1) }) mm{ $turned ->
        [turned] {" "}und Drehung um { FIXED($turn_deg, 1) } deg
       *[shifted] {""}
    } bleiben { FIXED($left_mm, 3) } mm
    .hint = beide Tabellen in einem Koordinatensystem angeben; AP und AT enthalten den Abstand der Koordinatensysteme, RP und RT nicht

deviation-as-large-as-test = die Istpositionen liegen { FIXED($deviation_mm, 1) } mm neben den Sollpositionen; das entspricht der Ausdehnung der Prüfposen ({ FIXED($extent_mm, 1) } mm); am weitesten entfernt: { $poses }
    .hint = die Namen der Posen und die Spalten beider Tabellen prüfen

angles-in-other-unit = { $count ->
        [one] der Winkel { $angles } der { $table ->
            [commanded] Sollposen
           *[attained] Istposen
        } ist
       *[other] die Winkel { $angles } der { $table ->
            [commanded] Sollposen
           *[attained] Istposen
        } sind
    } in rad, nicht in Grad: mal 57,29578 { $count ->
        [one] stimmt er
       *[other] stimmen sie
    } mit der anderen Tabelle überein
    .hint = die Spalten nach ihrer Einheit benennen (`a_rad`) oder in Grad umrechnen

angles-far-from-commanded = Istwinkel ({ $angles }) weichen bis zu { FIXED($deviation_deg, 1) } deg von den Sollwinkeln ab; größte Abweichungen an: { $poses }
    .hint = prüfen, ob die Spalten a, b, c beider Tabellen zu denselben Drehungen gehören, in gleicher Reihenfolge und im selben Koordinatensystem

rotation-order-unknown = `{ $text }` ist keine Reihenfolge der Drehungen a, b, c
    .expected = drei Drehungen um x, y oder z mit a, b und c, von links nach rechts multipliziert

rotation-orders = `rotation_order = "Rz(c) Ry(b) Rx(a)"` (Option --rotation-order), wenn a, b, c um die festen Achsen x, y, z drehen; `rotation_order = "Rz(a) Ry(b) Rx(c)"`, wenn sie um z, y, x des bewegten Körpers drehen
rotation-orders-of-axes = `rotation_order = "{ $by_axis }"` (Option --rotation-order), wenn a, b, c die Winkel um x, y, z sind; `rotation_order = "{ $by_place }"`, wenn a, b, c die Winkel in der Reihenfolge dieser Achsen sind

readings-outlying = { $count ->
        [one] 1 Messung liegt
       *[other] { $count } Messungen liegen
    } weit neben allen anderen ihrer Pose und { $count ->
        [one] ist
       *[other] sind
    } in AP und RP enthalten: { $readings }{ $more ->
        [0] {""}
       *[other] {" "}und { $more } weitere
    }
    .hint = Bezeichnung und Werte prüfen: Zeilen nur bei bekannter Ursache berichtigen oder entfernen und den Grund festhalten; sonst die Prüfung wiederholen

outlying-reading = Pose { $pose } in Zyklus { $cycle }, { LENGTH($distance_mm) } (Median der Abstände { LENGTH($median_mm) })
outlying-reading-near = Pose { $pose } in Zyklus { $cycle }, { LENGTH($distance_mm) } (Median der Abstände { LENGTH($median_mm) }; näher an Pose { $near })

runs-outlying = { $count ->
        [one] 1 Anfahrt liegt
       *[other] { $count } Anfahrten liegen
    } weit neben allen anderen ihrer Position und Richtung und { $count ->
        [one] ist
       *[other] sind
    } in A und R enthalten: { $runs }{ $more ->
        [0] {""}
       *[other] {" "}und { $more } weitere
    }
    .hint = diese Werte prüfen: eine Zeile nur berichtigen oder entfernen, wenn die Ursache bekannt ist, und den Grund festhalten; sonst die Prüfung wiederholen

outlying-run = Anfahrt { $run } auf { $position_mm } mm in Richtung { $direction }, { FIXED($distance_mm, 4) } mm (Median der Abstände { FIXED($median_mm, 4) } mm)

runs-repeated = die Tabelle enthält dieselben Anfahrten { $times }-mal, Ziffer für Ziffer: R und A sind zu klein
    .hint = die kopierten Zeilen entfernen

axis-test-short = die Achse hat { $positions } Positionen mit mindestens { $runs } Anfahrten je Richtung; ISO 230-2 verlangt je { $least }
    .hint = mindestens { $least } Positionen mit { $least } Anfahrten je Richtung messen

readings-repeated = { $count ->
        [one] 1 Messung wiederholt
       *[other] { $count } Messungen wiederholen
    } eine frühere Messung Ziffer für Ziffer: { $readings }{ $more ->
        [0] {""}
       *[other] {" "}und { $more } weitere
    }
    .hint = die kopierten Zeilen entfernen: sie sind keine weiteren Zyklen

repeated-reading = Pose { $pose } in Zyklus { $cycle } wie in Zyklus { $first }

path-velocity-far = die mittlere Geschwindigkeit auf der Bahn ist { FIXED($mean_mm_s, 3) } mm/s, die Sollgeschwindigkeit { FIXED($commanded_mm_s, 3) } mm/s
    .hint = die Sollgeschwindigkeit in mm/s angeben (`--velocity-mm-s`) und die Zeitstempel in s

angles-not-separable = die Winkel { $first } und { $second } { $place } { $order ->
        [stated] sind nicht trennbar: ihre Drehungen haben fast dieselbe Achse, und jeder Winkel allein sagt nichts aus
       *[unknown] ändern sich gemeinsam, weit mehr als ihre Summe oder Differenz: ihre Drehungen haben fast dieselbe Achse, und jeder Winkel allein sagt nichts aus
    }
    .hint = { $order ->
        [stated] die Rotationsvektoren verwenden (AP rx bis RP rz) oder die Winkel in einer anderen Reihenfolge der Drehungen aufzeichnen
       *[unknown] die Reihenfolge der drei Winkel der Posen angeben (`--rotation-order "Rz(c) Ry(b) Rx(a)"`, in einer Kampagne `rotation_order`): dann werden Rotationsvektoren ausgewertet; oder die Winkel in einer anderen Reihenfolge aufzeichnen
    }

angles-of-poses = { $count ->
        [one] an Pose { $poses }
       *[other] an den Posen { $poses }
    }

angles-of-path = auf der Bahn

angles-of-standstills = { $count ->
        [one] am Stillstand ab { $times_s } s
       *[other] an { $count } Stillständen (ab { $times_s } s)
    }

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

few-passes = { $count ->
        [one] 1 Durchlauf
       *[other] { $count } Durchläufe
    } der Bahn, weniger als { $least }
    .hint = { $least } Durchläufe messen (ISO 9283) oder nach den Intervallen von AT und RT entscheiden

corner-in-central-part = der mittlere Teil der Bahn enthält eine Ecke bei { FIXED($at_mm, 3) } mm
    .hint = eine Bahn ohne Ecke oder einen kürzeren mittleren Teil angeben: das Abbremsen an der Ecke beeinflusst AV, RV und FV

zone-proved-locally = es ist nur unter benachbarten Elementen ({ $element }) bewiesen, dass die Minimumzone die engste ist
    .hint = ihre Formabweichung mit der Formabweichung der Anpassung nach kleinsten Quadraten vergleichen

zone-unproved = eine engere Zone des Elements { $element } kann nicht ausgeschlossen werden
    .hint = einen größeren Teil der Fläche messen: so stark streuende Punkte bestimmen das Element kaum

hold-another = um einen anderen Parameter der Gruppe festzuhalten, ihn unter `hold` in [identify] nennen; ohne Angabe ist es der Parameter, dessen Toleranz die Zielmarken am wenigsten bewegt

set-up-origin = { $origin ->
        [unit] `unit` des Exports
       *[world-frame] `unit` und Bezeichnungen der Punkte, die es bestimmen
    }

check-rigid-part = Einheit und Namen in `places_mm` prüfen und ob das Teil seit ihrer Bestimmung verändert wurde

plan-cube = { $shape ->
        [square] das größte Quadrat
       *[cube] der größte Würfel
    } im angegebenen Arbeitsraum, Kanten parallel zu den Achsen; C1 bis C4, beginnend beim kleinsten x und y
plan-poses = P1: Mitte; P2 bis P5: auf den Diagonalen der Prüfebene, 10 % ihrer Länge von den Ecken entfernt, in der Reihenfolge der Ecken
plan-clauses = P1 bis P5, Lasten, Geschwindigkeiten und 30 Zyklen folgen dem Text der Norm; Bahnen, andere Anzahlen und die Reihenfolge der Ecken wurden nicht mit einem gekauften Exemplar verglichen
plan-reach-not-examined = nicht geprüft: ob der Roboter die Posen erreicht und ob sich zwischen ihnen alle Gelenke bewegen
plan-reach = Reichweite: nach den Nennparametern und Grenzen der Roboterdatei; für jede Liste von Posen gilt der Arbeitsmodus, der die meisten ihrer Posen erreicht; { $moves ->
        [all] zwischen P1 und P5 bewegen sich alle Gelenke
       *[some] zwischen P1 und P5 bewegen sich nicht alle Gelenke; die Norm verlangt es
    }
covariance-not-square = seine Kovarianz ist nicht quadratisch mit { $identified } Zeilen, je identifizierten Parameter eine
uncertainty-negative = eine Standardunsicherheit oder Varianz ist negativ oder keine Zahl
parameter-listed-twice = es enthält den Parameter `{ $parameter }` zweimal

method-levenberg-marquardt = Levenberg-Marquardt mit Block-QR und skalierten Spalten, Abschluss mit Gauß-Newton
method-enclosing = kleinstes umschließendes Element, durch { $points } Punkte bestimmt
method-minimum-zone = Minimumzone (Tschebyscheff)
action-add-cycles = { $count ->
        [one] Pose { $poses }
       *[other] die Posen { $poses }
    } mindestens { $required }-mal anfahren
action-add-cycles-reason = eine Pose hat nur { $least } Anfahrten: die Intervalle von AP und RP sind daher breit
action-add-effect = `{ $line }` in robot.toml vor der ersten Tabelle ergänzen
action-add-effect-first = noch nichts laden: `{ $line }` in robot.toml vor der ersten Tabelle ergänzen und den Lauf wiederholen
action-add-effect-not-in-file = Abweichung an ausgelassenen Posen: { $without } → { $with } (quadratischer Mittelwert). Keine Datei dieser Kampagne für die Steuerung kann { $effect } enthalten: der Gewinn verlangt ein anderes Format oder mit `etalon compensate` korrigierte Programme
action-add-effect-reason = Abweichung an ausgelassenen Posen: { $without } → { $with } (quadratischer Mittelwert)
action-add-validation = Posen zur Validierung messen und unter `validation` in [identify] angeben
action-add-validation-reason = Abweichungen an den Kalibrierposen sind kleiner als Abweichungen an neuen Posen
action-add-validation-unknown = quadratischer Mittelwert der Positionsabweichung: { $calibration } an Kalibrierposen, { $left_out } an ausgelassenen; nur weitere Posen zeigen die Abweichungen an anderen Orten
action-agree-rule = mit dem Kunden eine Entscheidungsregel vereinbaren: { $limit }
action-agree-rule-reason = der Grenzwert liegt innerhalb von U = { $present }; eine Entscheidung braucht { $required }, etwa { $times }-mal so viele Messungen. `decision_rule = "simple-acceptance"` in [limits] vergleicht den Wert selbst
action-compensate = rechnet die Steuerung mit Nenngeometrie, keine Datei laden: ihre Programme mit `etalon compensate` und `--field { $file }` korrigieren; das Residuenfeld ergänzt Abweichungen, die kein Parameter beschreibt
action-compensate-reason = quadratischer Mittelwert der Abweichung an { $count } zurückgehaltenen Posen: { $without } → { $with }
action-verify = die geladene Datei prüfen: einige Posen damit anfahren, messen und ihre Abweichungen mit der erwarteten vergleichen. Sind sie größer, die vorherige Datei der Steuerung wiederherstellen
action-verify-moved = das Laden verschiebt geteachte Positionen an den gemessenen Posen um bis zu { $change } (Flansch im Basiskoordinatensystem, Pose { $pose }): Freiräume prüfen und Werkstücke neu einlernen. { $count ->
        [0] Die gesicherte Datei als `controller_backup` in [conditions] nennen: der Bericht gibt dann ihren SHA-256 an
       *[other] Die vorherige Datei ist `{ $file }`; derselbe Abschnitt nennt ihren SHA-256
    }
action-verify-reason = die vorherige Datei vor dem Laden sichern; `controller_backup` in [conditions] ergänzt ihren SHA-256
action-verify-at-pose = das Laden an Pose { $pose } prüfen: „Prüfung nach dem Laden und Rückweg“ nennt die angezeigte Pose und ihre Toleranz. Bei einem Unterschied die vorherige Datei der Steuerung wiederherstellen
action-verify-software-at-pose = die Datei in der eigenen Software oder das erste korrigierte Programm an Pose { $pose } prüfen: „Prüfung nach dem Laden und Rückweg“ nennt Posen und Toleranz. Bei einem Unterschied den vorherigen Stand wiederherstellen
action-verify-backup = die vorherige Datei ist `{ $file }`; derselbe Abschnitt nennt ihren SHA-256
action-finer-instrument = mit einer erweiterten Messunsicherheit der Position von höchstens { $uncertainty } messen
action-finer-instrument-reason = an Pose { $pose } ist U = { $uncertainty }, also { $percent } % der Kenngröße; ISO 9283 erlaubt 25 %; diesen Wert { $count ->
        [one] überschreitet Pose { $poses }
       *[other] überschreiten die Posen { $poses }
    }
action-keep-nominal = { $count ->
        [0] die Nennparameter behalten
       *[other] { $formats } nicht laden
    }
action-keep-nominal-reason = RMS-Abweichung { $rms }, größte Abweichung { $max }; Nennparameter: { $nominal_rms } und { $nominal_max }
action-load = den Stand der Steuerung sichern, dann `{ $file }`{ $count ->
        [0] {""}
       *[other] {" "}(oder { $others })
    } laden
action-load-reason = quadratischer Mittelwert der Abweichung ({ $quantity }) an { $count } { $set ->
        [validation] Validierungsposen
        [held-out] ausgelassenen Kalibrierposen
       *[calibration] Kalibrierposen
    }: mit Nennparametern { $nominal }, mit dieser Datei { $expected }
action-load-with-inputs = { $action }. Die Software, die die Datei anwendet, muss sie an jeder Pose mit { $inputs } auswerten: Gelenkwerte allein genügen nicht
action-load-synthetic = `{ $file }`{ $count ->
        [0] {""}
       *[other] {" "}(oder { $others })
    } in eine simulierte Steuerung laden, nicht in einen Roboter: die Daten sind synthetisch
action-load-synthetic-software = `{ $file }`{ $count ->
        [0] {""}
       *[other] {" "}(oder { $others })
    } in eigene Software laden und damit keinen Roboter bewegen: die Daten sind synthetisch, und keine Steuerung liest diese Datei
action-measure-again = { $count ->
        [one] Pose { $poses }
       *[other] Posen { $poses }
    } erneut messen{ $more ->
        [0] {""}
        [one] {" "}(1 weitere Pose weicht ab)
       *[other] {" "}({ $more } weitere Posen weichen ab)
    }
action-measure-again-reason = Pose { $pose } passt nicht zu den anderen: { $error }, { $times } σ
action-measure-quantity = die Größe von `{ $limit }` an den entscheidenden Posen messen oder den Grenzwert entfernen
action-measure-quantity-reason = der Grenzwert einer nicht gemessenen Größe ist nicht beurteilbar
action-meet-limit = die Ursache der Abweichungen suchen: { $limit }
action-meet-limit-at-pose = die Ursache der Abweichung an Pose { $pose } suchen: { $limit }
action-meet-limit-reason = { $value }, Grenzwert { $limit }: um { $beyond } überschritten
action-use-all-parameters = die Steuerung alle identifizierten Parameter nutzen lassen, durch ein anderes Format oder `etalon compensate`: { $limit }
action-use-all-parameters-reason = { $value } mit den Werten dieser Datei, { $whole } mit allen identifizierten Parametern; Grenzwert { $limit }
action-prove-effects = `{ $line }` in [identify] angeben
action-prove-effects-first = noch nichts laden: `{ $line }` in [identify] angeben und den Lauf wiederholen
action-reduce-uncertainty = die Messunsicherheit verringern: { $limit }
action-reduce-uncertainty-by-source = U = { $present }; für eine Entscheidung nötig: { $required }; größter Beitrag: { $source } ({ $percent } %)
action-reduce-uncertainty-reason = U = { $present }; für eine Entscheidung nötig: { $required }
action-resolve = diese Warnung klären
action-run-again = nach einer Änderung erneut ausführen, und nur eine Datei laden, die die neue Bewertung nennt
action-run-again-backup = bis dahin behält die Steuerung ihre Werte. Sind Werte dieser Messung geladen, `{ $file }` wiederherstellen
action-run-again-reason = bis dahin behält die Steuerung ihre Werte. Sind Werte dieser Messung geladen, die vorherige Datei der Steuerung wiederherstellen
action-state-limits = die Toleranz der Anwendung in [limits] angeben
action-state-limits-reason = ohne Grenzwerte gibt es keine Bewertung
action-state-limits-to-accept = nur Grenzwerte zeigen, ob die Genauigkeit für die Anwendung ausreicht
action-warm-up = den Roboter vor der Prüfung warmfahren und `warm_up_minutes` angeben
action-warm-up-cold = der Roboter wurde kalt geprüft
action-warm-up-drift = AP von Pose { $pose } ändert sich vom ersten bis zum letzten von { $sets } Sätzen von Zyklen um { $change }, und eine Stabilisierung ist nicht nachgewiesen

field-of-other-robot = das Residuenfeld gehört zu einem anderen Roboter: `{ $name }`
    .hint = die field.json des Laufs verwenden, der diesen Roboter identifiziert hat

field-inconsistent = das Residuenfeld ist widersprüchlich
    .hint = die Kampagne erneut ausführen

field-needs-positions = Messwerte eines Residuenfelds sind Positionen von Zielmarken, ohne Bedingungen, starre Teile, Plattformen und angegebene Kovarianzen
field-needs-poses = { $poses ->
        [one] { $poses } Pose
       *[other] { $poses } Posen
    }; ein Residuenfeld braucht { $needed }
field-readings-suspect = an der zurückgehaltenen Pose { $pose } beträgt die Abweichung mit dem Feld { FIXED($error_mm, 3) } mm, mehr als das 8-Fache des Medians aller Posen: ihre Messwerte sind verdächtig
field-undetermined = die Positionen bestimmen die Parameter nicht in jeder Teilmenge der Posen
field-not-shown = die Residuen zeigen keine Abhängigkeit von den Gelenken: die Likelihood steigt um { FIXED($rise, 1) }, erforderlich ist { FIXED($threshold, 1) } (−2 ln L)
field-not-proven = an zurückgehaltenen Posen beträgt die Positionsabweichung { FIXED($without_mm, 3) } mm ohne und { FIXED($with_mm, 3) } mm mit dem Feld (quadratischer Mittelwert); die Verringerung beträgt das { FIXED($gain, 1) }-Fache ihrer Standardunsicherheit, erforderlich ist das 2,3-Fache

zeros-of-the-joints = Nullpunkte der Gelenke
geometry = Geometrie
gains = Übertragungsfaktoren
harmonics-of-the-transmissions = Harmonische der Getriebe
backlash = Umkehrspiel
coupling = Kopplung
bending = Biegung
payload-bending = Biegung unter der Nutzlast
torque-bending = Biegung unter den Drehmomenten der Gelenke
expansion-with-temperature = Ausdehnung mit der Temperatur
drift-with-temperature = Drift der Nullpunkte mit der Temperatur
lateral-bending = Kippung der Gelenke quer zu ihren Achsen
pedestal-bending = Kippung der Basis unter dem Arm
reading-payload-mass = Nutzlast
reading-payload-centre = Schwerpunkt der Nutzlast im Flansch
reading-torque = Drehmomente der Gelenke
reading-temperature = Temperatur des Roboters
reading-in-unit = { $quantity } ({ $unit })

### Meldungen von stages; Erklärungen in en/stages.ftl.

rigid-distance-off = der Abstand { $first }-{ $second } ist { FIXED($off_mm, 3) } mm { $side ->
        [shorter] kürzer
       *[longer] länger
    } als sein Median (Toleranz { $limit_mm } mm)

rigid-point-coincides = { $message }; der Punkt liegt, wo `{ $other }` ist

rigid-row-refused = Zeile { $row }: `{ $target }` ist abgewiesen: { $reason }

rigid-targets = ein starres Teil braucht zwei oder mehr Zielmarken, jede einmal genannt
    .hint = jede Zielmarke des Teils einmal in `targets` nennen

limit-not-positive = `{ $key }` muss eine positive Zahl sein
    .expected = { $key ->
            [drift_mm] die größte Bewegung einer festen Zielmarke während der Kampagne, zum Beispiel 0.02
           *[tolerance_mm] die größte Abweichung eines Abstands von seinem Median: einige Male seine Streuung, zum Beispiel 0.1
        }

rigid-uncertainty-without-places = `{ $key }` gehört zu `places_mm`, das fehlt
    .hint = `places_mm` angeben oder `{ $key }` entfernen

rigid-place-unknown = `places_mm` nennt `{ $target }`, das keine Zielmarke dieses starren Teils ist

rigid-place-missing = in `places_mm` fehlt der Ort von `{ $target }`
    .hint = seine Koordinaten ergänzen oder es aus `targets` entfernen

rigid-places-need-uncertainty = `places_mm` braucht `{ $key }`, eine positive Zahl
    .expected = die erweiterte Messunsicherheit einer Koordinate und ihr Erweiterungsfaktor

rigid-row-without-pose = [[rigid]] nennt `{ $target }`, und diese Zeile hat weder Pose noch Zeit
    .hint = die Pose in `label` oder `columns` nennen oder die Zielmarke aus [[rigid]] entfernen

rigid-time-twice = [[rigid]] nennt `{ $target }`, und zwei seiner Zeilen haben dieselbe Zeit
    .hint = die erste ist Zeile { $first }; die Pose in `label` oder `columns` nennen

rigid-never-together = { $targets } von [[rigid]] sind nie zusammen gemessen
    .expected = Zeilen mit derselben Pose und demselben Zyklus oder mit derselben Zeit
    .hint = die Pose in `label` oder `columns` nennen; `pose = "row"` nummeriert Zeilen von Dateien mit je einer Zielmarke

rigid-few-distances = der Abstand `{ $first }`-`{ $second }` von [[rigid]] weist keine Zeile ab: er wurde { $count }-mal gemessen
    .expected = { $least }-mal oder öfter

exclusion-mixed = ein Ausschluss nennt entweder Posen oder die Zeilen einer Datei
    .expected = `poses`, dazu `cycle` und `target`, wenn nötig; oder `file` und `rows`

exclusion-file-unknown = `{ $file }` ist kein Export mit Zeilen zum Ausschließen

of-file = `{ $file }`: { $message }

point-lies-at-another = Zeile { $row }: `{ $point }` liegt, wo `{ $other }` ist{ $rows ->
        [one] {""}
       *[other] {""}; insgesamt { $rows } solche Zeilen
    }
    .hint = wenn das Messgerät auf die andere Zielmarke zeigte oder die Bezeichnung falsch ist, sie berichtigen oder die Zeile auslassen; [[rigid]] weist Zeilen nach ihren Abständen ab

drift-few-readings = `{ $target }` ist { $count }-mal gemessen: zu selten, um eine Drift zu erkennen
    .expected = { $least } oder mehr

reference-drifts = `{ $target }` driftet: von den Zeilen { $first } zu den Zeilen { $second } bewegt es sich um { FIXED($moved_mm, 4) } mm; Grenze { $limit_mm } mm
    .hint = Temperatur und Aufstellung des Messgeräts prüfen; mit `targets` und `each = "pose"` in [frame.world] folgt das System den Zielmarken

frames-differ = die Punkte beziehen sich auf das System `{ $second }`, die eines anderen Exports auf `{ $first }`
    .hint = sie in einem Arbeitssystem exportieren oder nicht zusammen verwenden

export-empty = `{ $file }` enthält keine Punkte
    .hint = die Punkte neu exportieren oder diesen [[export]] entfernen; `etalon formats DATEI` zeigt, wie ein Text gelesen wird

target-formula = die Zielmarke `{ $target }` ist in einer Tabellenkalkulation eine Formel
    .hint = sie umbenennen oder ein `label` ohne ihr erstes Zeichen angeben

target-without-pose = die Zeile nennt eine Zielmarke, aber keine Pose
    .hint = die Pose in der Bezeichnung nennen oder für diesen Export `pose = "row"` angeben

target-twice = die Zielmarke `{ $target }` steht bei Pose { $pose }, Zyklus { $cycle } zweimal da
    .hint = zuerst in { $file }:{ $line }; { $numbered ->
            [by-row] für eine der Dateien `pose = "row + 100"` angeben
           *[by-label] Wiederholungen als Zyklen nummerieren oder eine entfernen
        }

labels-unused = { $count ->
        [one] 1 Bezeichnung nennt keine Zielmarke und wird
       *[other] { $count } Bezeichnungen nennen keine Zielmarke und werden
    } von keinem Element oder System verwendet; die erste ist `{ $label }`
    .hint = die Bezeichnung oder `label` dieses Exports berichtigen

column-step = { $column } auf { $step } { $unit }

coordinates-rounded = Koordinaten von `{ $file }` sind gerundet ({ $columns }): Standardunsicherheit { FIXED($rounding_um, 1) } µm, Messgerät { FIXED($instrument_um, 1) } µm
    .hint = sie mit mehr Dezimalen exportieren

labels-missing = kein Punkt hat eine Bezeichnung der Form `{ $pattern }`
    .hint = das Muster berichtigen oder den Export hinzufügen

exclusion-option-without-reason = { $option } { $text } gibt keinen Grund an
    .expected = was ausgelassen wird und warum: "13, 20-22: Kugel lose"

exclusion-poses = { $count ->
        [one] Pose
       *[other] Posen
    } { $poses }

exclusion-cycle = Zyklus { $cycle }

exclusion-target = Zielmarke `{ $target }`

excluded-readings = ausgeschlossen: { $count ->
        [one] 1 Ablesung
       *[other] { $count } Ablesungen
    }, { $of }: { $reason }

exclusions-leave-nothing = die Ausschlüsse lassen keine Ablesung übrig
    .hint = einen Ausschluss entfernen

exclusion-names-nothing = `{ $stated }` nennt keine { $of ->
        [rows] Zeilen
       *[poses] Posen
    } zum Ausschließen
    .expected = { $of ->
            [rows] Nummern und Bereiche wie "13, 20-22", gezählt von der ersten Datenzeile an
           *[poses] Namen und Bereiche wie "13, 20-22, home"
        }

not-of-this-robot = `{ $name }` ist { $kind ->
        [joint] kein Gelenk
       *[target] keine Zielmarke
    } dieses Roboters

exclusion-without-reason = ein Ausschluss braucht seinen Grund
    .hint = in `reason` angeben, warum die Messungen ausgelassen werden

exclusion-matches-nothing = { $of ->
        [rows] es gibt keine Zeile { $name } zum Ausschließen
       *[poses] es gibt keine Ablesung bei Pose { $name } mit diesem Zyklus und dieser Zielmarke zum Ausschließen
    }
    .hint = den Ausschluss berichtigen oder entfernen

join-missing = Exporte und Protokolle brauchen [join]
    .hint = `by` in [join] angeben: "pose", "pose_and_cycle", "row", "time" oder "label"

join-by-time-empty = kein Messpunkt hat ein Gegenstück in Protokoll `{ $log }`: die beiden nächsten Zeiten liegen { FIXED($apart_s, 3) } s auseinander
    .hint = Wert und Vorzeichen von `clock_offset_s` prüfen: Zeit der Messung minus Zeit des Protokolls

join-empty = kein Messpunkt hat ein Gegenstück in Protokoll `{ $log }`: die erste Pose der Punkte ist `{ $measured }`, des Protokolls `{ $logged }`
    .hint = Posen und Zyklen von Exporten und Protokoll vergleichen oder mit `by` in [join] einen anderen Schlüssel wählen

clock-from-standstills = die Uhr von Protokoll `{ $log }` ist nach { $count ->
        [one] 1 Stillstand
       *[other] { $count } Stillständen
    } gestellt: Versatz { FIXED($offset_s, 3) } s ± { FIXED($half_width_s, 3) } s
    .hint = mit diesem Versatz fällt jeder Messpunkt in einen Stillstand

pose-without-frame = { $count ->
        [one] 1 Pose
       *[other] { $count } Posen
    } ohne Weltsystem, ausgelassen: { $poses }
    .hint = die Zielmarken des Systems wurden abgewiesen oder nicht gemessen: siehe import.json

join-contradicts = { $count ->
        [one] 1 Messpunkt hat
       *[other] { $count } Messpunkte haben
    } ein anderes { $column } als die verknüpfte Zeile von Protokoll `{ $log }`: { $measured } und { $logged } (Zeile { $line } des Protokolls)
    .hint = nach Pose verknüpfen; oder `{ $column }` aus `columns` des Protokolls weglassen, wenn es dort anderes zählt

row-counts-differ = `{ $file }` hat { $rows } Zeilen, Protokoll `{ $log }` hat { $log_rows }
    .expected = gleiche Anzahlen für eine Verknüpfung nach Zeilen
    .hint = die Datei ergänzen, der Zeilen fehlen; oder in beiden Pose und Zyklus nennen und danach verknüpfen

approach-direction-unknown = Protokoll `{ $log }` zeigt nicht, aus welcher Richtung Gelenk `{ $joint }` kam
    .hint = `backlash` braucht sie: die Zeiten der Zeilen angeben (`time_s` in `columns`, oder `period_s`), oder `{ $column }` in `columns`: +1 von unten, -1 von oben

backlash-direction-unknown = Protokoll `{ $log }` hat keine Bewegung eines Gelenks mit Umkehrspiel vor Pose { $poses }: ausgelassen
    .hint = das Protokoll vor der ersten Pose beginnen oder die Anfahrrichtung angeben

targets-out-of-plane = die Zielmarken des ebenen Roboters haben Höhen von { FIXED($low_mm, 3) } mm bis { FIXED($high_mm, 3) } mm im Weltsystem
    .hint = z der Exporte (Einheit, Vorzeichen, Spalte) und die Punkte prüfen, die die Ebene des Weltsystems festlegen

log-column-missing = Protokoll `{ $log }` hat keine Spalte `{ $column }`

column-empty = die Spalte `{ $column }` ist leer oder fehlt
    .hint = die Spalte hinzufügen oder die Zelle ausfüllen

targets-missing = Zielmarken fehlen bei Pose { $poses }
    .hint = ihre übrigen Zielmarken zählen; eine Pose oder Orientierung braucht alle

key-in-lines = { $key } in den Zeilen { $lines }

log-key-twice = Protokoll `{ $log }` hat { $count ->
        [one] 1 Schlüssel
       *[other] { $count } Schlüssel
    } mehr als einmal: { $keys }
    .hint = dem Schlüssel `cycle` hinzufügen oder die Zeilen entfernen, die nicht zählen

keys-unmatched = { $count ->
        [one] 1 Schlüssel
       *[other] { $count } Schlüssel
    } { $of ->
        [log] des Protokolls `{ $log }` ohne Messpunkt
       *[points] von Messpunkten ohne Zeile in Protokoll `{ $log }`
    } ({ $columns }): { $keys }; siehe import.json

pose-misspelt = Pose `{ $pose }` { $of ->
        [log] des Protokolls `{ $log }` ist nicht gemessen, und gemessene Posen fehlen im Protokoll
       *[points] ist nicht in Protokoll `{ $log }`, und Posen des Protokolls sind nicht gemessen
    }

join-key-missing = die Verknüpfung braucht `{ $key }`, das manche Zeilen nicht haben
    .hint = es in `label` der Exporte und in `columns` des Protokolls nennen oder `by` in [join] ändern

join-by-label-targets = eine Verknüpfung nach Bezeichnung ist für Roboter mit einer Zielmarke; dieser hat { $count }
    .hint = eine Zielmarke nennen oder mit `by` in [join] einen anderen Schlüssel wählen

join-by-label-frame = eine Verknüpfung nach Bezeichnung braucht ein Weltsystem für alle Posen
    .hint = das System aus Punkten bilden, die sich nicht bewegen

label-not-measured = kein Messpunkt hat die Bezeichnung `{ $label }`

points-untouched = { $count ->
        [one] 1 Punkt wird
       *[other] { $count } Punkte werden
    } von keiner Zeile des Protokolls `{ $log }` berührt; der erste ist `{ $label }`

log-times-not-increasing = die Zeiten des Protokolls `{ $log }` nehmen bei seiner Zeile { $row } nicht zu
    .hint = das Protokoll nach der Zeit sortieren und Zeilen mit gleichen Zeiten entfernen

times-missing = { $of ->
        [log] das Protokoll hat Zeilen ohne Zeit
        [export] der Export hat Zeilen ohne Zeit
       *[points] kein Messpunkt hat eine Zeit
    }
    .hint = eine Verknüpfung nach der Zeit braucht `time_s` in den Spalten von Exporten und Protokoll

several-rows-near = { $count ->
        [one] 1 Messpunkt hat
       *[other] { $count } Messpunkte haben
    } mehrere Zeilen von Protokoll `{ $log }` innerhalb von { $tolerance_s } s: die nächste zählt
    .hint = `tolerance_s` auf weniger als die halbe Periode des Protokolls verringern

points-without-row = { $count ->
        [one] 1 Messpunkt hat
       *[other] { $count } Messpunkte haben
    } keine Zeile von Protokoll `{ $log }` innerhalb von { $tolerance_s } s

rows-without-point = { $count ->
        [one] 1 Zeile
       *[other] { $count } Zeilen
    } von Protokoll `{ $log }` ohne Messpunkt

target-time-twice = { $count } Punkte der Zielmarke `{ $target }` haben dieselbe Zeit (Zeilen { $lines })
    .hint = die Zeiten berichtigen oder die Zielmarke jedes Punkts nennen

log-row-met-twice = Zeile { $row } von Protokoll `{ $log }` ist { $count } Punkten der Zielmarke `{ $target }` am nächsten (Zeilen { $lines })
    .hint = `tolerance_s` verringern oder `clock_offset_s` prüfen

clock-offset-none = bei keinem Versatz der Uhren fällt jeder Messpunkt in einen Stillstand des Protokolls: { $count ->
        [one] 1 Zeit passt
       *[other] { $count } Zeiten passen
    }, bis { $last_s } s; die Zeit { $first_s } s passt nicht
    .hint = in Bewegung gemessene Punkte entfernen; oder `clock_offset_s` als Zahl angeben: Zeilen ohne Gegenstück werden dann aufgelistet

range-of-seconds = { FIXED($low_s, 3) } bis { FIXED($high_s, 3) } s

clock-offsets-several = die Stillstände lassen { $count } Bereiche des Uhrenversatzes zu, zuerst: { $ranges }
    .hint = die Uhren vergleichen und `clock_offset_s` als Zahl angeben

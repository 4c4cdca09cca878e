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

of-name = `{ $name }`: { $message }

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

key-in-lines = { $key } (Zeilen { $lines })

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

axis-of-world = "x", "y" oder "z"

observe-key-missing = die Art `{ $kind }` braucht `{ $column }`
    .hint = `{ $column }` angeben

distance-not-positive = `distance_mm` fehlt oder ist keine Länge
    .expected = eine Länge größer als 0

fixed-point-on-robot = `{ $name }` ist eine Zielmarke am Roboter, kein fester Punkt
    .hint = festen Punkten eigene Namen geben; Zeilen allein über sie haben keine Pose

distance-to-itself = der Abstand ist von `{ $name }` zu sich selbst
    .hint = `other` berichtigen

number-missing = `{ $column }` fehlt oder ist keine Zahl
    .expected = { $column ->
            [offset_mm] der Abstand der Zielmarke von der Ebene längs ihrer Achse oder von der Kugel nach außen: der Radius einer Kugel, oder 0
           *[value_deg] der Gelenkwert nach dem Schalter oder dem zweiten Drehgeber
        }

row-without-pose = eine Zeile der Art `{ $kind }` hat keine Pose
    .hint = Zeilen ohne Pose geben Orte (`point`) und Abstände (`distance`) fester Punkte an, und Orte auf `plane`, `line` oder `sphere`

known-unsupported = eine Zeile der Art `{ $kind }` hat kein [[known]]
    .expected = `point`, `distance`, `plane`, `line` oder `sphere`

near-without-surface = `near_mm` ist für Orte auf Flächen
    .hint = `near_mm` entfernen

kind-of-arms = { $kind ->
        [joints] Gelenkwerte
       *[poses] Posen
    } sind für räumliche Arme, nicht für `{ $model }`
    .hint = Positionen oder Abstände von Zielmarken beobachten

kind-unknown = `{ $name }` ist keine Art von Beobachtung

name-on-few-rows = `{ $name }` steht nur in { $count ->
        [one] 1 Zeile
       *[other] { $count } Zeilen
    }, `{ $meant }` in { $meant_count }
    .hint = meinten Sie `{ $meant }`? sonst die Zeilen von `{ $name }` auslassen: sie bestimmen nicht, wo es ist

base-moves = die Gelenke { $joints } bewegen `base_link`: Positionen gelten als in einem mitbewegten System gemessen
    .hint = wenn das Messgerät im Raum steht, die Wurzel der URDF als `base_link` angeben

names-of-fixed-things = Zielmarken, Punkten und Ebenen eigene Namen geben

partial-coordinates = { $count ->
        [one] 1 Zeile gibt
       *[other] { $count } Zeilen geben
    } eine oder zwei Koordinaten einer Zielmarke an: jede zählt für sich

station-missing = die Spalte `station` ist hier leer, und andere Punkte haben eine
    .hint = die Station nennen: Zeilen ohne Station gehören zur Station des Weltsystems, die den Roboter an mindestens { $least } Posen sehen muss

coordinates-unknown = `{ $text }` nennt keine Koordinaten
    .expected = Buchstaben aus x, y und z: "z", "xy"

place-missing = der Ort von `{ $point }` fehlt oder ist keine Zahl
    .hint = seine Koordinaten ergänzen oder die Zeile entfernen

joint-value-missing = ein Gelenkwert fehlt oder ist keine Zahl
    .hint = die Zeile ergänzen oder entfernen

station-row-unsupported = { $fault ->
        [kind] eine Zeile der Art `{ $kind }` gibt die Station `{ $station }` an
        [coordinate] eine von Station `{ $station }` gemessene Koordinate fehlt oder ist keine Zahl
        [covariance] ein von Station `{ $station }` gemessener Punkt gibt eine Kovarianz an
       *[uncertainties] von Station `{ $station }` gemessene Koordinaten haben eigene Unsicherheiten
    }
    .expected = Zeilen der Art `point` mit x_mm, y_mm, z_mm und einer Unsicherheit `u_mm`, für alle Stationen außer der ersten

uncertainty-not-positive = `{ $column }` = { $value } ist keine Standardunsicherheit
    .expected = eine positive Zahl

uncertainty-missing = die Zeile hat keine Standardunsicherheit
    .hint = { $column ->
            [urot_deg] --rotation-uncertainty-deg (in einer Kampagne `expanded_rotation_uncertainty_deg` von [instrument]) oder eine Spalte `urot_deg` angeben
           *[u_mm] --standard-uncertainty-um oder eine Spalte `u_mm` angeben
        }

surface-axis-missing = { $kind ->
        [line] die Gerade `{ $name }` braucht die Achse des Weltsystems, die ihr am nächsten ist
       *[plane] die Ebene `{ $name }` braucht die Achse des Weltsystems, die ihrer Normalen am nächsten ist
    }
    .expected = x, y oder z in der Spalte `axis`{ $kind ->
            [line] {""}
           *[plane] : z für einen Tisch, x oder y für eine Wand
        }

offset-of-line = `offset_mm` ist für Ebenen und Kugeln, nicht für eine Gerade
    .hint = die Zelle leer lassen

near-missing = ein Ort auf { $kind } braucht `near_mm`
    .hint = angeben, wo ungefähr er im Weltsystem liegt

load-direction-unknown = `{ $direction }` ist keine Richtung
    .expected = +x, -x, +y, -y, +z oder -z

load-direction-unmeasured = Richtung `{ $direction }` braucht `z_mm`: dort ist keine Verschiebung gemessen
    .hint = die Spalte `z_mm` hinzufügen oder die Zeile entfernen

force-not-a-number = `{ $text }` ist keine Kraft
    .expected = Newton, null oder mehr: die Richtung gibt das Vorzeichen

drift-without-commanded = `drift_set` braucht Sollposen
    .hint = sie angeben: `commanded = "commanded.csv"`

attained-poses-twice = [poses] und [repeatability] geben beide Istposen an
    .hint = behalten, worin die Messungen sind: Bezeichnungen oder eine Tabelle

limit-without-value = der Grenzwert `{ $limit }` kann nicht beurteilt werden: Pose { $pose } hat keinen solchen Wert
    .hint = jede Pose mindestens zweimal anfahren und als Sollpose angeben

compensation-scatters = Istpositionen streuen nach der Kompensation durch Referenzmarken um { FIXED($after_mm, 4) } mm um das Mittel ihrer Pose, vorher um { FIXED($before_mm, 4) } mm
    .hint = nach einer falschen Ablesung unter den Referenzmarken suchen oder sie weglassen

reference-targets-misshapen = Referenzmarken von Zyklus { $cycle } liegen { FIXED($rms_mm, 4) } mm (quadratisches Mittel) neben einer starren Bewegung des ersten Zyklus; erweiterte Messunsicherheit { FIXED($expanded_mm, 4) } mm
    .hint = eine hat sich bewegt oder ist falsch gemessen: neu messen oder weglassen

repeatability-frame = [repeatability] braucht ein einmal gemessenes Weltsystem
    .hint = das System aus Punkten bilden, die sich nicht bewegen

commanded-angle-unmeasured = `{ $column }` ist vorgegeben, aber Bezeichnungen liefern nur Positionen
    .hint = die Spalte entfernen oder Istposen mit Winkeln als Tabelle angeben: [poses]

commanded-pose-missing = für Pose { $poses } ist keine Sollposition angegeben
    .hint = für jede gemessene Pose des Ablaufs eine Zeile ergänzen

commanded-pose-unmeasured = Pose { $pose } ist vorgegeben, aber dort ist nichts gemessen

trajectory-empty = der Ablauf hat keine Pose
    .hint = die Posen eines Zyklus in ihrer Reihenfolge angeben, zum Beispiel [1, 2, 1, 3]

coplanar-not-four = `coplanar` nennt nicht vier Posen des Ablaufs
    .expected = vier seiner Posen, jede einmal

pose-not-in-trajectory = Pose { $pose } (Zyklus { $cycle }) ist nicht im Ablauf
    .hint = die Bezeichnung berichtigen oder die Pose in `trajectory` ergänzen

pose-of-several-targets = Pose { $pose } (Zyklus { $cycle }) hat Ablesungen von `{ $target }` und einer anderen Zielmarke
    .hint = die eine Zielmarke der Prüfung in `label` nennen

pose-of-cycle = Pose { $pose } von Zyklus { $cycle }

visit-count-differs = Pose { $pose } ist in Zyklus { $cycle } { $found }-mal gemessen, der Ablauf fährt sie { $count }-mal an
    .hint = die fehlende Ablesung ergänzen oder alle dieser Pose und dieses Zyklus entfernen: die Anfahrrichtung der anderen ist unbekannt

visits-missing = nicht gemessen: { $poses }{ $count ->
        [one] {""}
       *[other] {""}; insgesamt { $count }
    }

homing-instrument-too-coarse = die Messunsicherheit übersteigt 25 % der Wiederholgenauigkeit der Referenzfahrt, { FIXED($rp_mm, 4) } mm
    .hint = den Wert als obere Schranke verwenden oder mit einem besseren Messgerät messen

central-part-too-large = { $option } ist mehr als die Bahn
    .expected = eine Zahl größer als 0 und höchstens 100

path-points-out-of-range = { $option } ist außerhalb des Bereichs
    .expected = 2 bis 100000

path-not-stated = { $option } braucht { $path }
    .hint = die Datei der Sollbahn angeben

weave-incomplete = dem Pendeln fehlt { $option }
    .hint = Hub, Frequenz und Richtung angeben

weave-direction-count = { $option } hat nicht drei Zahlen
    .expected = x, y und z der Richtung der Auslenkung

stream-twice = der Datenstrom `{ $stream }` steht zweimal da
    .hint = jedem Datenstrom einen eigenen Namen geben

in-observation = Pose { $pose } Zyklus { $cycle } der Beobachtungen: { $message }

in-candidate = Pose { $pose } der Kandidaten: { $message }

in-feature = Element `{ $name }`: { $message }

joints-of-pose-differ = seine Zeilen haben verschiedene Gelenkwerte
    .hint = sie berichtigen oder Wiederholungen in der Spalte `cycle` nummerieren

target-repeated = die Zielmarke `{ $target }` kommt zweimal vor
    .hint = Wiederholungen in der Spalte `cycle` nummerieren

table-without-observations = es gibt keine Beobachtungen
    .hint = Datei und Ausschlüsse prüfen

arms-apart = mit Nennparametern treffen sich die Arme bei diesen Gelenkwerten nicht
    .hint = Einheit, Vorzeichen und Versatz der Gelenke und die Nennparameter prüfen

assembly-mode-missing = der Aufbaumodus ist nicht angegeben
    .expected = 1 oder -1 in der Spalte `assembly`
    .hint = Kandidaten können auch Positionen sein: `pose,x_mm,y_mm` ohne Gelenke ergibt alle Arbeitsmodi

assembly-mode-ambiguous = beide Aufbaumodi passen gleich gut: { FIXED($near_mm, 2) } mm und { FIXED($far_mm, 2) } mm von der gemessenen Position
    .hint = eine Spalte `assembly` mit 1 oder -1 angeben; oder den Ort der Basis (x_o, y_o, phi) unter [nominal]

assembly-modes-assumed = der Aufbaumodus von { $count } Beobachtungen wurde der Messung entnommen ({ $positive } in Modus +1, { $negative } in Modus -1); am wenigsten eindeutig ist Pose { $pose }: { FIXED($near_mm, 1) } mm und { FIXED($far_mm, 1) } mm
    .hint = eine Spalte `assembly` mit 1 oder -1 angeben, wenn das Protokoll sie enthält

height-missing = Beobachtungen eines räumlichen Roboters fehlt `z_mm`
    .hint = die Spalte `z_mm` hinzufügen

uncertainties-twice = die Tabelle gibt Standardunsicherheiten und Kovarianzen von Koordinaten an
    .hint = `ux_mm`, `uy_mm`, `uz_mm` entfernen

coordinate-uncertainty-missing = die Zeile gibt eine Unsicherheit an, aber `{ $column }` ist leer
    .expected = von 0,00002 bis 100 mm, oder alle leer

coordinate-uncertainty-unusable = `{ $column }` = { $value } ist nicht die Unsicherheit einer Koordinate
    .expected = von 0,00002 bis 100 mm, oder alle leer

position-covariance-invalid = die Kovarianz der Zeile ist nicht positiv definit
    .hint = Reihenfolge und Einheit der Spalten `cxx_mm2` .. prüfen

unplaced = { $kind ->
        [targets] { $count ->
            [one] 1 Zielmarke
           *[other] { $count } Zielmarken
        }
        [fixtures] { $count ->
            [one] 1 feste Größe
           *[other] { $count } feste Größen
        }
       *[both] { $count } Zielmarken und feste Größen
    } nur an Validierungsposen gemessen: { $names }; durch diese Ablesungen platziert, bei festgehaltenem identifiziertem Roboter

validation-leaves-nothing = { $unplaced }: zum Validieren bleibt nichts
    .hint = sie auch an Kalibrierposen messen oder eine Pose, an der sie gemessen sind, nach `calibration` verschieben

placed-by-validation = { $unplaced }; die Statistik berücksichtigt das
    .hint = sie auch an Kalibrierposen messen oder eine Pose, an der sie gemessen sind, nach `calibration` verschieben

placed-by-validation-unjudged = { $unplaced }; Ablesungen ohne Redundanz werden nicht beurteilt: { $names }
    .hint = sie auch an Kalibrierposen messen oder eine Pose, an der sie gemessen sind, nach `calibration` verschieben

candidate-positions-unreachable = keine Kandidatenposition wird vom `{ $model }` erreicht, oder das Modell hat keine Inverse
    .hint = Gelenkwerte angeben, eine Spalte je Gelenk mit ihrer Einheit

check-readings = dort nach vertauschten Bezeichnungen und falschen Ablesungen suchen; neu messen oder mit `exclude` in [identify] auslassen

robust-fit-disagrees = eine robuste Anpassung ändert `{ $parameter }` um { FIXED($over_u, 1) } Standardunsicherheiten der Differenz (Grenze { FIXED($limit, 1) }); keine Pose widerspricht allen anderen: die Residuen sind nicht normalverteilt
    .hint = der Roboter hat Abweichungen, die das Modell nicht beschreibt, oder die angegebene Unsicherheit ist zu klein

robust-fit-disagrees-at-poses = eine robuste Anpassung ändert `{ $parameter }` um { FIXED($over_u, 1) } Standardunsicherheiten der Differenz (Grenze { FIXED($limit, 1) }); Posen, die den anderen widersprechen: { $poses }

target-positions = `{ $target }` ({ $count ->
        [one] 1 Position
       *[other] { $count } Positionen
    })

coordinates-commanded = der Nennroboter ergibt die Koordinaten von { $targets } aus den Gelenkwerten auf { SCIENTIFIC($largest_mm, 2) } mm, die Rundung der Datei: sie sind Sollwerte, nicht gemessen
    .hint = in `columns` die gemessenen Koordinaten nennen; bei simulierten Daten in der Kampagne `synthetic` angeben

frame-points-mirrored = die Punkte des Weltsystems sind { FIXED($off_mm, 3) } mm von ihren Nennorten entfernt und passen zu deren Spiegelbild auf { FIXED($limit_mm, 3) } mm
    .hint = zwei Achsen des Exports sind vertauscht, oder eine hat das andere Vorzeichen: seine Spalten prüfen

frame-point-off = `{ $point }` ist { FIXED($off_mm, 3) } mm von seinem Nennort relativ zu den anderen Punkten entfernt (Toleranz { $tolerance_mm } mm, U = { FIXED($expanded_mm, 4) } mm)
    .hint = den Punkt, seine Bezeichnung und `nominal_mm` prüfen oder die Toleranz der Zeichnung angeben

frame-points-off = von `{ $first }` bis `{ $second }` sind es gemessen { FIXED($measured_mm, 3) } mm, nominal { FIXED($nominal_mm, 3) } mm (Toleranz { $tolerance_mm } mm, U = { FIXED($expanded_mm, 4) } mm)
    .hint = den Punkt, seine Bezeichnung und `nominal_mm` prüfen oder die Toleranz der Zeichnung angeben

nominal-point-unmeasured = `nominal_mm` nennt `{ $point }`, das nicht gemessen ist

nominal-few-points = `nominal_mm` braucht drei Punkte oder mehr
    .hint = Punkte des Systems ergänzen oder es entfernen

world-axes-exchanged = die Basis ist { FIXED($off_mm, 0) } mm und { FIXED($off_deg, 1) } deg von dem Ort entfernt, den robot.toml angibt: x, y, z von robot.toml sind { $axes } des Weltsystems
    .hint = Achsen, Einheit und Punkte des Weltsystems und [nominal] in robot.toml prüfen

base-off-nominal = die Basis ist { FIXED($off_mm, 0) } mm und { FIXED($off_deg, 1) } deg von dem Ort entfernt, den robot.toml angibt; Grenze { $limit_mm } mm, { FIXED($limit_deg, 1) } deg
    .hint = Achsen, Einheit und Punkte des Weltsystems und [nominal] in robot.toml prüfen

orientation-slip = { $slip ->
        [joint] `{ $name }` umgekehrt
        [scalar-last] dem Skalar der Quaternionen am Ende
        [scalar-first] dem Skalar der Quaternionen am Anfang
        [scalar-last-inverse] dem Skalar der Quaternionen am Ende und den inversen Drehungen
        [order] Winkeln in der Reihenfolge `{ $name }`
        [vectors] Drehvektoren statt Winkeln
        [order-of-vectors] Winkeln in der Reihenfolge `{ $name }` statt Drehvektoren
        [radians] Winkeln in Radiant statt Grad
        [degrees] Winkeln in Grad statt Radiant
        [inverse] den inversen Drehungen
       *[left-handed] einem linkshändigen System ({ $name } umgekehrt)
    }

slip-leaves = mit { $slip } um { FIXED($left_deg, 2) } deg

check-slips = sie unterscheiden sich { $slips }: das zuerst prüfen

orientations-off = beobachtete Orientierungen unterscheiden sich von denen des { $robot ->
        [nominal] Nennroboters
       *[identified] identifizierten Roboters
    } um { FIXED($median_deg, 1) } deg (Median)
    .hint = prüfen, dass qw, qx, qy, qz Vektoren des Körpers in die Welt drehen, der Skalar zuerst; oder die Reihenfolge der Winkel: ohne `orientation` werden die passenden genannt

few-poses-to-leave-out = { $count ->
        [one] 1 Kalibrierpose ist
       *[other] { $count } Kalibrierposen sind
    } zu wenig, um einige auszulassen
    .expected = mindestens { $least }
    .hint = mehr messen oder mehr in `calibration` nennen

nothing-to-judge = nichts Beobachtetes ist eine Position, ein Abstand oder ein Kontakt
    .hint = Parameter werden nach Positionsabweichungen beurteilt: einige messen

validation-repeats-calibration = die Validierung wiederholt die Kalibrierung: die Hälfte der Validierungsposen liegt näher als das { FIXED($median, 2) }-Fache des Abstands der Kalibrierposen an einer von diesen; Grenze { $limit }
    .hint = die Abweichung des Roboters kann anderswo größer sein: an Posen zwischen denen der Kalibrierung validieren

validation-far = die Validierung ist weit von der Kalibrierung entfernt: die Hälfte der Validierungsposen liegt weiter als das { FIXED($median, 2) }-Fache des Abstands der Kalibrierposen von der nächsten; Grenze { $limit }
    .hint = an Posen kalibrieren, die über den benutzten Arbeitsraum verteilt sind

error-quantity-unknown = `{ $name }` ist keine Größe von Abweichungen
    .hint = die Kampagne neu rechnen: `etalon run CAMPAIGN`

pose-set-unknown = `{ $name }` ist keine Menge von Posen
    .expected = calibration oder validation

joint-does-not-move = `{ $joint }` bewegt sich nicht: die Daten überlassen { $count ->
        [one] 1 Parameter seiner Toleranz
       *[other] { $count } Parameter ihren Toleranzen
    }: { $parameters }
    .hint = `{ $joint }` zwischen den Kalibrierposen bewegen oder im Gebrauch bei seinem Wert bleiben; sonst bleiben Abweichungen bis zur Toleranz von `{ $first }`

direction-undetermined = die Punkte lassen seine Richtung um { FIXED($direction_deg, 0) } deg unsicher (k = 1); Grenze { $limit_deg } deg
    .hint = Punkte weiter auseinander messen, nicht alle auf einer Geraden

direction-uncertain = seine Richtung hat eine Standardunsicherheit von { FIXED($direction_deg, 2) } deg; Grenze { $limit_deg } deg
    .hint = Punkte weiter auseinander messen

world-frame-incomplete = das Weltsystem { $fault ->
        [plane] hat keine Ebene
        [feature] hat eine Ebene, die kein Element ist
        [origin] hat keinen Ursprung
        [towards] hat kein `towards`
       *[axis] braucht eines von `x_axis` und `y_axis`
    }
    .hint = `plane`, `origin`, `x_axis` oder `y_axis` und `towards` in [frame.world] angeben

frame-name-unknown = keine Bezeichnung und kein Element heißt `{ $name }`
    .hint = den Namen berichtigen oder das Element hinzufügen

world-axis-without-direction = die Achse des Weltsystems hat keine Richtung
    .expected = zwei Bezeichnungen, von und nach, oder ein Element mit einer Richtung

world-side-undetermined = `towards` liegt auf der Achse: es legt die Seite der anderen Achse nicht fest
    .hint = einen Punkt neben der Achse nennen

frame-few-targets = das Weltsystem hat { $count ->
        [one] 1 Zielmarke
       *[other] { $count } Zielmarken
    }
    .expected = drei Zielmarken oder mehr

frame-never-complete = keine Pose hat alle Zielmarken { $targets } des Weltsystems getrennt voneinander
    .hint = alle messen und ihre Bezeichnungen prüfen

orientations-twice = die Tabelle hat Orientierungen zweimal: { $first } und { $second }
    .hint = eine davon weglassen

orientation-columns-missing = der Orientierung fehlt { $missing }
    .expected = { $columns }: Körper im Weltsystem

orientation-missing = die Orientierung fehlt oder ist keine Zahl
    .expected = qw, qx, qy, qz: Körper im Weltsystem; oder ein Drehvektor, oder drei Winkel

angle-order-missing = die Reihenfolge der Winkel ist nicht angegeben
    .hint = `orientation = "zyx"` in [observations] oder --orientation angeben

angle-orders-unfit = keine Reihenfolge der Winkel passt zum Nennroboter: `{ $order }` lässt { FIXED($left_deg, 1) } deg (quadratisches Mittel); prüfen, dass sie den Körper in die Welt drehen, und die Gelenke

angle-order-leaves = `{ $order }` lässt { FIXED($left_deg, 3) } deg

angle-orders-fit = `orientation = "zyx"` in [observations] oder --orientation angeben; vom Nennroboter { $orders } (quadratisches Mittel)

ball-missing = Kugel `{ $target }` fehlt (Pose { $pose }, Zyklus { $cycle })
    .hint = sie messen oder den Rest dieser Pose und dieses Zyklus entfernen

actuator-unknown = es gibt keinen Antrieb { $actuator }
    .expected = 1, 2 oder 3

lead-position-unknown = Position { $position } von Antrieb { $actuator } ist nicht in `positions_mm`
    .hint = die Bezeichnung berichtigen oder `positions_mm` ergänzen

geometric-frame = die geometrische Kalibrierung braucht ein Weltsystem aus den Schienen und Kugel R
    .expected = `plane`, `origin`, `y_axis = [Ursprung, anderes Ende]` und `towards`, wie in 3.4.1 der Arbeit

geometric-other-robot = [geometric] ist die geometrische Kalibrierung eines PreXYT
    .expected = ein Roboter mit Modell `prexyt`

scale-bar-error = Maßstab `{ $name }`: eine Abweichung von { FIXED($error_mm, 4) } mm überschreitet die zulässige von { FIXED($limit_mm, 4) } mm
    .hint = Taster, Temperatur und Aufstellung des Messgeräts prüfen und den Maßstab neu messen

scale-bar-uncertain = Maßstab `{ $name }`: die zulässige Abweichung ist das { FIXED($ratio, 1) }-Fache der erweiterten Messunsicherheit seines Zertifikats, gefordert ist das { $least }-Fache
    .hint = einen Maßstab mit besserem Zertifikat verwenden: dieser verifiziert nichts

step-scatters = { $step }: Residuen streuen um { FIXED($found_mm, 4) } mm, das Messgerät gibt { FIXED($stated_mm, 4) } mm an: die Unsicherheiten folgen den Residuen
    .hint = nach Spiel, einer schmutzigen Kugel oder einem losen Sitz suchen; den Schritt neu messen

table-without-poses = an keiner Pose der Tabelle `{ $title }` sind K und L zusammen gemessen
    .hint = beide Kugeln im selben Zyklus messen oder andere Posen wählen

given-without-covariance = die Parameter haben keine Kovarianz
    .hint = aus Daten neu identifizieren, die Freiheitsgrade lassen

calibrated-targets-missing = den Parametern fehlen { $names }: andere Basis oder andere Zielmarken
    .hint = die Zielmarken der Kalibrierung beobachten, wo sie am bewegten Teil waren

parameters-of-other-robot = die Parameter gehören zu einem `{ $identified }`; robot.toml beschreibt einen anderen Roboter (`{ $stated }`)
    .hint = die robot.toml angeben, mit der sie identifiziert wurden

parameters-lacking = den Parametern fehlen { $names }; die robot.toml angeben, mit der sie identifiziert wurden

parameters-undescribed = die Parameter enthalten { $names }, die robot.toml nicht beschreibt
    .hint = die robot.toml angeben, mit der sie identifiziert wurden

add-lines = { $lines } in robot.toml vor der ersten Tabelle ergänzen

nominal-value-changed = `{ $parameter }` hat in robot.toml den Nennwert { $stated }{ $unit ->
        [mm] {" "}mm
        [deg] {" "}deg
       *[other] {""}
    } und hatte bei der Identifikation { $identified }{ $unit ->
        [mm] {" "}mm
        [deg] {" "}deg
       *[other] {""}
    }
    .hint = prüfen, dass die Parameter die dieses Roboters sind

calibration-without-residuals = die Kalibrierung zeigt keine Standardabweichung einer Koordinate
    .hint = mit angegebener Standardunsicherheit identifizieren

effect-would-prove = { $effect }{ $count ->
        [0] {""}
       *[other] {" "}der Gelenke { $joints }
    } würde sich nachweisen lassen: die Abweichung an ausgelassenen Kalibrierposen fällt von { FIXED($without_mm, 3) } auf { FIXED($with_mm, 3) } mm (Position, quadratisches Mittel)
    .hint = "{ $effect }" in `effects` von [identify] ergänzen oder `effects = "proven"` angeben

outliers-too-many = `outliers = "exclude"` würde mehr als { $share_percent } % aller Ablesungen auslassen
    .hint = das Modell oder der Aufbau ist falsch: sehen, was `outliers = "keep"` meldet

log-correlates = mit Protokoll `{ $log }` korrelieren die Residuen mit dem Unterschied beider Protokolle (r = { FIXED($correlation, 2) }): ihr quadratisches Mittel ist { FIXED($rms_mm, 3) } mm, mit Protokoll `{ $other }` { FIXED($other_rms_mm, 3) } mm

use-log = { $hint ->
        [name-first] mit Protokoll `{ $log }` identifizieren: es zuerst nennen
       *[is-used] Protokoll `{ $log }` ist das richtige, wie in dieser Kampagne
    }

selected-pose-unmeasured = `{ $pose }` nennt keine gemessene Pose

selection-without-pose = `{ $set }` wählt keine gemessene Pose

sets-overlap = Posen sowohl in der Kalibrierung als auch in der Validierung: { $poses }
    .hint = `validation = "rest"` nimmt alle, die die Kalibrierung nicht nimmt

table-selection-empty = die Tabelle `{ $title }` hat keine gemessene Pose
    .hint = eine Tabelle zeigt Posen von `calibration` und `validation`

poses-measured = { $count ->
        [one] 1 Pose ist
       *[other] { $count } Posen sind
    } gemessen und verknüpft, von { $first } bis { $last }

poses-unmeasured = keine Pose ist gemessen und verknüpft

at-pose = Pose { $pose }: { $message }

values-of-column = { $message } ({ $count } von { $total } Werten sind es)

check-column-unit = die Einheit seiner Spalte prüfen: alle Werte liegen im Bereich, wenn sie { $units ->
        [degrees] Grad statt Radiant
       *[millimetres] Millimeter statt Meter
    } sind

joint-out-of-range = Gelenk `{ $joint }` = { $value } { $unit } ist außerhalb des Bereichs
    .expected = von { $lower } bis { $upper } { $unit }: { $reason ->
            [limits] die Grenzen, die die Roboterdatei angibt, und 0,1 darüber hinaus
            [turns] zwei Umdrehungen, da die Roboterdatei keine Grenzen angibt
           *[others] da die Hälfte seiner Werte beieinander liegt
        }
    .hint = Dezimalzeichen und Einheit prüfen; kann das Gelenk dort sein, { $reason ->
            [limits] seine Grenzen in der Roboterdatei berichtigen
           *[others] seine Grenzen in der Roboterdatei angeben
        }

common-errors-of-conditions = gemeinsame Abweichungen aller Ablesungen (Maßstab, Temperatur, Referenzfahrt) werden nur für Positionen von Zielmarken gezogen
    .hint = `etalon run` gibt die Unsicherheiten dieser Kampagne durch lineare Fortpflanzung an

probe-of-feature-unknown = `{ $feature }` wird nicht angepasst: seine Punkte sind Tastermittelpunkte, und die Datei gibt nicht an, { $missing ->
        [side] auf welcher Seite der Taster war
       *[radius] welchen Radius der Taster hat
    }
    .hint = { $missing ->
            [side] angeben: --probe-side inside, outside oder x,y,z
           *[radius] angeben: --probe-radius-mm
        }

unstable-parameter = `{ $parameter }` ({ FIXED($over_sd, 1) }, Grenze { FIXED($limit, 1) })

parameters-unstable = nicht stabil und festgehalten: Werte aus einem Teil der Posen weichen von denen aus allen ab, in Standardabweichungen der Differenz: { $parameters }
    .hint = nach Änderungen während der Messung suchen (Temperatur, eine bewegte Zielmarke, ein neu referenziertes Gelenk) und die Residuen ansehen

hold-unknown = `hold` nennt `{ $pattern }`, das kein Parameter dieses Roboters ist

residuals-pose-not-planar = `residuals = "pose"` ist für ebene Roboter, nicht für `{ $model }`
    .hint = `residuals = "targets"` verwenden

remedy = { $remedy ->
        [pose-uncertainty] sie angeben (--standard-uncertainty-um) oder Zielmarken vergleichen
        [contact-uncertainty] auch die Wiederholbarkeit des Kontakts angeben (--standard-uncertainty-um) und Zielmarken vergleichen
        [targets] Positionen seiner Zielmarken angeben: Zeilen der Art `point`
        [uncertainty] sie angeben (--standard-uncertainty-um)
        [own-uncertainties] Zielmarken vergleichen oder die Spalten der Unsicherheiten entfernen
        [row-uncertainty] sie in jeder Zeile angeben oder mit --standard-uncertainty-um
        [part] `frame` ist `flange` für einen Arm, `platform` für einen PreXYT, `targets` für jeden Roboter
        [positions] mehr Positionen wählen oder Parameter mit `--hold` festhalten
        [base] mehr Posen messen oder base_x .. base_rz und die Zielmarken unter [nominal] in der Roboterdatei angeben
        [hold-fewer] weniger Parameter festhalten und mehr Posen messen
        [more-poses] mehr Posen messen (Wiederholungen einer Pose bringen nichts) oder Parameter mit `hold` in [identify] oder --hold festhalten
        [hold] Parameter in [identify] festhalten oder mehr Posen messen
        [unreachable] Einheit (Grad oder Radiant), Vorzeichen und Versatz der Gelenke und die Nennparameter prüfen
        [extent] `unit` der Exporte, die Einheiten der Gelenke im Protokoll und die Längen des Roboters prüfen
        [assembly] die Spalte `assembly` dieser Posen berichtigen oder leer lassen: der Modus wird dann der Messung entnommen
       *[joints] Einheiten, Reihenfolge und Vorzeichen der Gelenke und die Nennparameter prüfen; `hold` in [identify] hält Parameter fest
    }

reading-off = { FIXED($off_mm, 4) } mm ({ $target }, Pose { $pose }, Zyklus { $cycle })

largest-residuals = größte Residuen einer robusten Anpassung: { $readings }
    .hint = dort zuerst nach vertauschten Bezeichnungen und falschen Ablesungen suchen; Abweichungen des Roboters verteilen sich auf alle Posen

outlier-readings = { $count ->
        [one] 1 von { $total } Ablesungen ist ein Ausreißer
       *[other] { $count } von { $total } Ablesungen sind Ausreißer
    }, mehr als das { $times }-Fache von { FIXED($scale_mm, 4) } mm, der Standardabweichung der anderen in einer robusten Anpassung: { $readings }

outliers = { $outliers }

outliers-excluded = durch `outliers = "exclude"` ausgeschlossen: { $outliers }

repeated-position = { $target } an den Posen { $first } und { $second }

positions-repeat = gemessene Positionen wiederholen sich bis zur letzten Ziffer, während sich die Gelenke bewegen, { $count }-mal: { $pairs }
    .hint = der Export hat eine Ablesung einer anderen Pose: diese neu messen oder auslassen

repeated-joints = Posen { $first } und { $second }, { FIXED($apart_mm, 3) } mm auseinander

joint-values-repeat = Gelenkwerte wiederholen sich bis zur letzten Ziffer, während sich die Zielmarken bewegen, { $count }-mal: { $pairs }
    .hint = das Protokoll hat eine Ablesung einer anderen Pose: diese neu aufzeichnen oder auslassen

repeats-scatter = Wiederholungen von `{ $label }` liegen bis zu { FIXED($off_mm, 4) } mm neben ihrem Median; Standardunsicherheit des Messgeräts { FIXED($u_mm, 4) } mm
    .hint = `unit` des Exports und die Unsicherheit des Messgeräts prüfen, und dass sich der Punkt nicht bewegt hat

repeat-off = { $away } von { $count } Wiederholungen von `{ $label }` { $away ->
        [one] liegt
       *[other] liegen bis zu
    } { FIXED($off_mm, 4) } mm neben ihrem Median; Standardunsicherheit des Messgeräts { FIXED($u_mm, 4) } mm
    .hint = die falsche Ablesung aus dem Export entfernen oder den Punkt neu messen: jedes Ergebnis hängt davon ab

uncertainty-zero-rounded = `{ $column }` ist in { $count ->
        [one] 1 Zeile
       *[other] { $count } Zeilen
    } 0: gerundet, und als Auflösung der Spalte gelesen, u = { $u } { $unit } (Hälfte der letzten Ziffer durch √3)
    .hint = Unsicherheiten mit mehr Dezimalen exportieren

uncertainty-zero = `{ $column }` ist in { $count ->
        [one] 1 Zeile
       *[other] { $count } Zeilen
    } 0 und zeigt keine Auflösung: dort zählt die Unsicherheit des Messgeräts
    .hint = Unsicherheiten mit mehr Dezimalen exportieren

key-of-text-table = `{ $key }` hat für ein Blatt einer Arbeitsmappe keine Bedeutung
    .hint = `{ $key }` entfernen: Zellen einer Arbeitsmappe werden gelesen, wie sie sind

measurements-undescribed = an den { $set ->
        [validation] Validierungsposen
       *[calibration] Kalibrierposen
    } lässt das Modell { FIXED($after_mm, 3) } mm (quadratisches Mittel) von Positionen übrig, die über { FIXED($spread_mm, 1) } mm streuen; { $count } von { $total } Ablesungen weichen um mehr als { FIXED($limit_mm, 1) } mm ab: das Modell beschreibt diese Messungen nicht

undescribed-targets = alle Ablesungen von { $targets } weichen ab, und keine anderen: Bezeichnungen prüfen, und ob die Zielmarke bewegt wurde

undescribed-readings = { $readings }: { $remedy }

undescribed-set-up = Einheiten, Reihenfolge und Vorzeichen der Gelenke, die Nennparameter und die Verknüpfung von Protokoll und Punkten prüfen

undescribed-frame-moved = eine Bewegung des Systems um { FIXED($motion_mm, 1) } mm lässt { FIXED($left_mm, 3) } mm: Basis oder Messsystem hat sich zwischen Kalibrier- und Validierungsposen bewegt

undescribed-unchecked = die Kalibrierposen lassen keine Koordinate zur Kontrolle übrig: andere Lagen von Basis und Zielmarken passen ebenso zu ihnen; mehr Kalibrierposen messen, im Arbeitsraum verteilt

undescribed-other-poses = die Kalibrierposen passen, und keine Bewegung des Systems erklärt die anderen: prüfen, ob Protokoll und Exporte der Validierungsposen dieselben Posen sind (Protokoll einer anderen Kampagne oder anders nummerierte Posen)

prior-of-nominal = Nennparameter haben keine Kovarianz für `--frames prior`
    .hint = identifizierte mit `--parameters` angeben oder `--frames refit` verwenden

prior-of-conditions = `--frames prior` ist nur für gemessene Positionen
    .hint = Zeilen anderer Art weglassen oder Basis und Zielmarken neu anpassen: `--frames refit`

place-without-nominal = `{ $parameter }` hat keinen Nennwert: er wird aus Messungen bestimmt
    .hint = Basis und Zielmarken an die Kalibrierposen anpassen: `--frames refit`

given-parameters-worse = die gegebenen Parameter lassen { FIXED($given_mm, 3) } mm, die Nennparameter { FIXED($nominal_mm, 3) } mm (quadratisches Mittel)
    .hint = prüfen, dass es die dieses Roboters sind, und ob Basis und Zielmarken die dieser Kampagne sind (`--frames`)

candidate-poses-too-few = { $wanted } von { $count } Kandidatenposen können nicht gewählt werden
    .hint = weniger `--positions` oder mehr Kandidaten angeben

target-names-exchanged = mit vertauschten Namen der Zielmarken `{ $first }` und `{ $second }` fallen die Residuen von { FIXED($before_mm, 3) } auf { FIXED($left_mm, 3) } mm
    .hint = die beiden Namen im Export vertauschen

one-pose-contradicts = ohne Pose `{ $pose }` widersprechen die Beobachtungen den Parametern nicht
    .hint = diese Pose neu messen und ihre Gelenkwerte neu aufzeichnen

motions-alike = { $count ->
        [one] 1 andere Bewegung erklärt
       *[other] { $count } andere Bewegungen erklären
    } diese Residuen ebenfalls: { $motions }
    .hint = Posen beobachten, die sich in den Gelenkwerten stärker unterscheiden

no-coordinates-to-check = { $count ->
        [one] 1 Koordinate der Kalibrierposen bestimmt
       *[other] { $count } Koordinaten der Kalibrierposen bestimmen
    } { $parameters } Parameter: keine bleibt, um sie zu prüfen
    .hint = mehr Posen messen, über den Arbeitsraum verteilt

validation-outliers = { $count } von { $total } Validierungsabweichungen überschreiten { FIXED($limit_mm, 4) } mm, das { $times }-Fache ihres Medians: { $readings }

common-scale = { $parameters } sind alle etwa das { FIXED($factor, 5) }-Fache des Nennwerts: ein Maßstabsfehler des Messsystems oder der Gelenke erklärt das eher als Abweichungen von { $count } Teilen
    .hint = Maßstab, Temperaturkompensation und Einheit des Messsystems und der Drehgeber prüfen

compliance-negative = `{ $parameter }` ist negativ ({ FIXED($value, 5) } { $unit }): das Gelenk biegt sich gegen die Schwerkraft
    .hint = `gravity` und die Richtung der Gelenkachse in robot.toml prüfen

backlash-negative = `{ $parameter }` ist negativ ({ FIXED($value, 5) } { $unit }): das Gelenk eilt seinem Antrieb voraus, was kein Umkehrspiel erklärt
    .hint = das Vorzeichen der Anfahrrichtungen prüfen (+1, wo der Gelenkwert stieg, -1, wo er fiel), und dass die Zeiten des Protokolls zur selben Bewegung gehören

ball-names-exchanged = `{ $parameter }`, der Abstand von K und L, ist { FIXED($value, 3) } { $unit }: K und L sind vertauscht
    .hint = die Namen der beiden Zielmarken in den Bezeichnungen des Exports vertauschen

identified-worse-than-nominal = an den { $set ->
        [validation] Validierungsposen
       *[calibration] Kalibrierposen
    } ist der identifizierte Roboter schlechter als der Nennroboter: { FIXED($before_mm, 4) } mm vorher, { FIXED($after_mm, 4) } mm nachher (quadratisches Mittel)
    .hint = mehr Posen messen, über den Arbeitsraum verteilt, oder Parameter festhalten, die sie nicht bestimmen

value-beyond-tolerance = `{ $parameter }` = { $unit ->
        [mm] { FIXED($value, 3) } { $unit } (Nennwert { $nominal } { $unit }, Toleranz { FIXED($tolerance, 3) } { $unit })
        [deg] { FIXED($value, 3) } { $unit } (Nennwert { $nominal } { $unit }, Toleranz { FIXED($tolerance, 3) } { $unit })
       *[other] { FIXED($value, 4) } (Nennwert { $nominal }, Toleranz { FIXED($tolerance, 3) })
    }

tolerance-exceeded = { $count ->
        [one] 1 Parameter liegt
       *[other] { $count } Parameter liegen
    } außerhalb der Toleranz des Roboters: { $parameters }
    .hint = Vorzeichen, Einheiten und Reihenfolge der Gelenke, die Nennwerte und die Systeme prüfen; ist der Roboter anders gezeichnet, `tolerance` in der Roboterdatei angeben

format-not-identified = die Parameter des Formats `{ $format }` konnten nicht neu identifiziert werden: { $message }

clock-rate-from-standstills = die Uhr der Messung geht um { FIXED($rate_ppm, 1) } ppm ± { FIXED($u_ppm, 1) } ppm (k = 1) gegen die Uhr des Protokolls `{ $log }` (möglich: { FIXED($low_ppm, 1) } bis { FIXED($high_ppm, 1) } ppm); Versatz { FIXED($offset_s, 3) } s ± { FIXED($u_s, 3) } s (k = 1) bei { FIXED($reference_s, 3) } s des Protokolls
    .hint = mit diesem Versatz und Gang fällt jeder Messpunkt in einen Stillstand; mit einem Versatz allein nicht

clock-rate-insignificant = die Stillstände des Protokolls `{ $log }` zeigen keinen Gangunterschied der Uhren: er liegt zwischen { FIXED($low_ppm, 1) } und { FIXED($high_ppm, 1) } ppm
    .hint = `clock_rate` weglassen: der Versatz allein wird verwendet

clock-rate-none = bei keinem Versatz der Uhren und keinem Gangunterschied bis ± { $most_ppm } ppm fällt jeder Messpunkt in einen Stillstand des Protokolls
    .hint = prüfen, ob das Protokoll zu dieser Messung gehört, und in Bewegung gemessene Punkte entfernen; oder `clock_offset_s` als Zahl angeben

row-excluded = ausgeschlossen: { $reason }
row-at-origin = nicht gemessen: 0 0 0
row-of-several = { $rows } Zeilen des Protokolls `{ $log }` liegen innerhalb von { $tolerance_s } s: die nächste zählt
no-rows-around = dem Protokoll `{ $log }` fehlt davor oder danach eine Zeile innerhalb von { $tolerance_s } s
no-row-near = keine Zeile des Protokolls `{ $log }` liegt innerhalb von { $tolerance_s } s
no-point-nearest = kein gemessener Punkt liegt ihr am nächsten
no-row-of-key = keine Zeile des Protokolls `{ $log }` hat diesen Schlüssel
no-point-of-key = kein gemessener Punkt hat diesen Schlüssel
no-row-touches = keine Zeile des Protokolls `{ $log }` berührt ihn
row-of-unframed-pose = seine Pose hat kein Weltkoordinatensystem

table-of-observations = Beobachtungen
table-of-attained-poses = Istposen
table-of-commanded-poses = Sollposen
table-of-reference-targets = Referenzmarken
table-of-commanded-path = Sollbahn
table-of-compliance = statische Nachgiebigkeit
recorded-motion-file = aufgezeichnete Bewegung
read-in-unit = { $format }, Einheit { $unit }
read-in-frame = { $read }, bezogen auf `{ $frame }`

side-stated = wie vom Benutzer angegeben
side-from-values = aus { $of ->
        [normal] der Normalen
        [location] der Lage
       *[diameter] dem Durchmesser
    } ({ $values ->
        [nominal] Nennwert
       *[stated] Angabe
    })
side-from-key = aus `InternalExternal`: { $value }

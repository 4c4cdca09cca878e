### Meldungen von stages; Erklärungen in en/stages.ftl.

rigid-distance-off = der Abstand { $first }-{ $second } ist { FIXED($off_mm, 3) } mm { $side ->
        [shorter] kürzer
       *[longer] länger
    } als sein Median (Toleranz { $limit_mm } mm)

rigid-targets-exchanged = die Abstände passen, wenn `{ $first }` und `{ $second }` vertauscht sind

rigid-target-refused = [[rigid]] lehnt { $rows ->
        [one] die einzige Zeile
       *[other] alle { $rows } Zeilen
    } von `{ $target }` ab, die erste in `{ $file }`, Zeile { $line }: { $reason }
    .hint = vertauschte Bezeichnungen oder `tolerance_mm` berichtigen oder die Zielmarke aus [[rigid]] entfernen

rigid-point-coincides = { $message }; der Punkt fällt mit `{ $other }` zusammen

rigid-row-refused = `{ $target }` wird in Zeile { $row } abgelehnt: { $reason }

rigid-targets = ein starres Teil braucht mindestens zwei Zielmarken, jede einmal genannt
    .hint = jede Zielmarke des Teils einmal in `targets` nennen

rigid-across-branches = das starre Teil { $targets } erstreckt sich über mehrere Zweige des Roboters
    .hint = je ein [[rigid]] für die Zielmarken jedes Zweigs angeben

limit-not-positive = `{ $key }` muss eine positive Zahl sein
    .expected = { $key ->
            [drift_mm] die größte Bewegung einer festen Zielmarke während der Kampagne, zum Beispiel `0.02`
           *[tolerance_mm] die größte Abweichung eines Abstands von seinem Median: ein kleines Vielfaches seiner Streuung, zum Beispiel `0.1`
        }

rigid-uncertainty-without-places = `{ $key }` gehört zu `places_mm`, das fehlt
    .hint = `places_mm` angeben oder `{ $key }` entfernen

rigid-place-unknown = `places_mm` nennt `{ $target }`, das keine Zielmarke dieses starren Teils ist

rigid-place-missing = in `places_mm` fehlt die Position von `{ $target }`
    .hint = ihre Koordinaten ergänzen oder die Zielmarke aus `targets` entfernen

rigid-places-need-uncertainty = `places_mm` braucht `{ $key }`, eine positive Zahl
    .expected = die erweiterte Messunsicherheit einer Koordinate und ihr Erweiterungsfaktor

rigid-row-without-pose = [[rigid]] nennt `{ $target }`, aber diese Zeile hat weder Pose noch Zeit
    .hint = die Pose in `label` oder `columns` nennen oder die Zielmarke aus [[rigid]] entfernen

rigid-time-twice = [[rigid]] nennt `{ $target }`, aber zwei ihrer Zeilen haben dieselbe Zeit
    .hint = die erste ist Zeile { $first }; die Pose in `label` oder `columns` nennen

rigid-never-together = { $targets } von [[rigid]] werden nie zusammen gemessen
    .expected = Zeilen mit derselben Pose und demselben Zyklus oder mit derselben Zeit
    .hint = die Pose in `label` oder `columns` nennen; `pose = "row"` nummeriert Zeilen von Dateien mit einer einzigen Zielmarke

rigid-few-distances = der Abstand `{ $first }`-`{ $second }` von [[rigid]] kann keine Zeile ablehnen: er wurde nur { $count }-mal gemessen
    .expected = mindestens { $least }-mal

exclusion-mixed = ein Ausschluss nennt entweder Posen oder die Zeilen einer Datei
    .expected = `poses`, bei Bedarf mit `cycle` und `target`; oder `file` und `rows`

exclusion-file-unknown = `{ $file }` ist kein Export, aus dem Zeilen ausgeschlossen werden können

of-name = `{ $name }`: { $message }

point-lies-at-another = Zeile { $row }: `{ $point }` fällt mit `{ $other }` zusammen{ $rows ->
        [one] {""}
       *[other] {""}; insgesamt { $rows } solche Zeilen
    }
    .hint = wenn das Messgerät auf die andere Zielmarke zeigte oder die Bezeichnung falsch ist, die Bezeichnung berichtigen oder die Zeile ausschließen; [[rigid]] lehnt Zeilen nach ihren Abständen ab

drift-few-readings = `{ $target }` wurde nur { $count }-mal gemessen: zu selten, um eine Drift zu erkennen
    .expected = mindestens { $least }-mal

reference-drifts = `{ $target }` driftet: von den Zeilen { $first } bis zu den Zeilen { $second } bewegt sie sich um { LENGTH($moved_mm) }; Grenzwert { LENGTH($limit_mm) }
    .hint = Temperatur und Aufstellung des Messgeräts prüfen; mit `targets` und `each = "pose"` in [frame.world] folgt das Koordinatensystem den Zielmarken

frames-differ = die Punkte beziehen sich auf das Koordinatensystem `{ $second }`, die Punkte eines anderen Exports auf `{ $first }`
    .hint = sie in demselben Koordinatensystem exportieren oder nicht zusammen verwenden

export-empty = `{ $file }` enthält keine Punkte
    .hint = die Punkte neu exportieren oder diesen [[export]] entfernen; `etalon formats DATEI` zeigt, wie eine Textdatei gelesen wird

target-formula = der Zielmarkenname `{ $target }` wäre in einer Tabellenkalkulation eine Formel
    .hint = die Zielmarke umbenennen oder ein `label` ohne das erste Zeichen angeben

target-without-pose = die Zeile nennt eine Zielmarke, aber keine Pose
    .hint = die Pose in der Bezeichnung nennen oder für diesen Export `pose = "row"` angeben

target-twice = die Zielmarke `{ $target }` kommt an Pose { $pose }, Zyklus { $cycle } zweimal vor
    .hint = zuerst in { $file }:{ $line }; { $numbered ->
            [by-row] für eine der Dateien `pose = "row + 100"` angeben
           *[by-label] Wiederholungen als Zyklen nummerieren oder eine entfernen
        }

labels-unused = { $count ->
        [one] 1 Bezeichnung nennt keine Zielmarke und wird
       *[other] { $count } Bezeichnungen nennen keine Zielmarke und werden
    } von keinem Geometrieelement oder Koordinatensystem verwendet; die erste ist `{ $label }`
    .hint = { $points ->
            [stationary] Punkte, die sich nicht mit dem Roboter bewegen, so lassen; `targets` von [frame.world] macht sie zum Weltkoordinatensystem
           *[moving] die Bezeichnung oder `label` dieses Exports berichtigen
        }

column-step = { $column } auf { $step } { $unit }

coordinates-rounded = die Koordinaten von `{ $file }` sind gerundet ({ $columns }): Standardunsicherheit der Rundung { FIXED($rounding_um, 1) } µm, Messgerät { FIXED($instrument_um, 1) } µm
    .hint = sie mit mehr Nachkommastellen exportieren
origin-not-measured = Zeile { $line } von `{ $file }` ist 0 0 0: sie gilt als nicht gemessen
    .hint = wenn es ein gemessener Punkt im Ursprung des Koordinatensystems ist, ein Format mit `missing = [""]` angeben

labels-missing = kein Punkt hat eine Bezeichnung der Form `{ $pattern }`
    .hint = das Muster berichtigen oder den Export hinzufügen

exclusion-option-without-reason = { $option } { $text } gibt keinen Grund an
    .expected = was ausgeschlossen wird und warum: "13, 20-22: Kugel lose"

exclusion-poses = { $count ->
        [one] Pose
       *[other] Posen
    } { $poses }

exclusion-cycle = Zyklus { $cycle }

exclusion-target = Zielmarke `{ $target }`

excluded-readings = ausgeschlossen: { $count ->
        [one] 1 Messwert
       *[other] { $count } Messwerte
    }, { $of }: { $reason }

exclusions-leave-nothing = die Ausschlüsse lassen keinen Messwert übrig
    .hint = einen Ausschluss entfernen

exclusion-names-nothing = `{ $stated }` nennt keine { $of ->
        [rows] Zeilen
       *[poses] Posen
    } zum Ausschluss
    .expected = { $of ->
            [rows] Nummern und Bereiche wie "13, 20-22", gezählt von der ersten Datenzeile an
           *[poses] Namen und Bereiche wie "13, 20-22, home"
        }

not-of-this-robot = `{ $name }` ist { $kind ->
        [joint] kein Gelenk
       *[target] keine Zielmarke
    } dieses Roboters

exclusion-without-reason = ein Ausschluss braucht eine Begründung
    .hint = in `reason` angeben, warum die Messungen ausgeschlossen werden

exclusion-matches-nothing = { $of ->
        [rows] es gibt keine Zeile { $name } zum Ausschluss
       *[poses] es gibt an Pose { $name } keinen Messwert dieses Zyklus und dieser Zielmarke zum Ausschluss
    }
    .hint = den Ausschluss berichtigen oder entfernen

join-by-time-empty = kein Messpunkt hat eine zugehörige Zeile in Protokoll `{ $log }`: die beiden nächsten Zeitpunkte liegen { FIXED($apart_s, 3) } s auseinander
    .hint = Wert und Vorzeichen von `clock_offset_s` prüfen: Zeit der Messung minus Zeit des Protokolls

both-rows-near = ein Punkt zwischen zwei Zeilen braucht beide innerhalb von `tolerance_s`: mindestens den Zeitabstand zweier Zeilen angeben

join-empty = kein Messpunkt hat eine zugehörige Zeile in Protokoll `{ $log }`: die erste Pose der Punkte ist `{ $measured }`, die erste des Protokolls `{ $logged }`
    .hint = Posen und Zyklen von Exporten und Protokoll vergleichen oder mit `by` in [join] einen anderen Schlüssel wählen

clock-from-standstills = die Uhr von Protokoll `{ $log }` ist nach { $count ->
        [one] 1 Stillstand
       *[other] { $count } Stillständen
    } gestellt: Versatz { FIXED($offset_s, 3) } s ± { FIXED($half_width_s, 3) } s
    .hint = mit diesem Versatz fällt jeder Messpunkt in einen Stillstand

pose-without-frame = { $count ->
        [one] 1 Pose
       *[other] { $count } Posen
    } ohne Weltkoordinatensystem, ausgeschlossen: { $poses }
    .hint = die Zielmarken des Koordinatensystems wurden abgelehnt oder nicht gemessen: siehe import.json

join-contradicts = { $count ->
        [one] 1 Messpunkt hat
       *[other] { $count } Messpunkte haben
    } einen anderen Wert von { $column } als die verknüpfte Zeile von Protokoll `{ $log }`: { $measured } und { $logged } (Zeile { $line } des Protokolls)
    .hint = nach Pose verknüpfen; oder `{ $column }` aus `columns` des Protokolls weglassen, wenn die Spalte dort etwas anderes bedeutet

row-counts-differ = `{ $file }` hat { $rows } Zeilen, Protokoll `{ $log }` hat { $log_rows }
    .expected = gleich viele Zeilen für eine Verknüpfung nach Zeilen
    .hint = die Datei ergänzen, der Zeilen fehlen; oder in beiden Pose und Zyklus nennen und danach verknüpfen

approach-direction-unknown = Protokoll `{ $log }` zeigt die Anfahrrichtung von Gelenk `{ $joint }` nicht
    .hint = `backlash` braucht sie: die Zeiten der Zeilen angeben (`time_s` in `columns` oder `period_s`), oder `{ $column }` in `columns`: +1 von kleineren Werten, -1 von größeren Werten

backlash-direction-unknown = Protokoll `{ $log }` enthält vor diesen Posen keine Bewegung eines Gelenks mit Umkehrspiel; sie sind ausgeschlossen: { $poses }
    .hint = das Protokoll vor der ersten Pose beginnen oder die Anfahrrichtung angeben

targets-out-of-plane = die Höhen der Zielmarken des ebenen Roboters reichen von { FIXED($low_mm, 3) } mm bis { FIXED($high_mm, 3) } mm im Weltkoordinatensystem
    .hint = z der Exporte (Einheit, Vorzeichen, Spalte) und die Punkte prüfen, die die Ebene des Weltkoordinatensystems festlegen

column-empty = die Spalte `{ $column }` ist leer oder fehlt
    .hint = die Spalte hinzufügen oder die Zelle ausfüllen

targets-missing = Zielmarken fehlen { $count ->
        [one] an Pose { $poses }
       *[other] an den Posen { $poses }
    }
    .hint = die übrigen Zielmarken dieser Posen werden verwendet; eine Pose oder Orientierung braucht alle Zielmarken

row-is-a-pose = `{ $file }` hat `pose = "row"`, sodass jede Zeile eine eigene Pose ist: diese Zeile entfernen, wenn mehrere Zielmarken an einer Pose gemessen wurden

key-in-lines = { $key } (Zeilen { $lines })

remove-repeated-rows = die doppelten Zeilen entfernen: ihre Gelenkwerte sind Ziffer für Ziffer gleich
remove-invalid-rows = die ungültigen Zeilen entfernen

log-key-twice = Protokoll `{ $log }` enthält { $count ->
        [one] 1 Schlüssel
       *[other] { $count } Schlüssel
    } mehr als einmal: { $keys }
    .hint = dem Schlüssel `cycle` hinzufügen oder die ungültigen Zeilen entfernen

keys-unmatched = { $count ->
        [one] 1 Schlüssel
       *[other] { $count } Schlüssel
    } { $of ->
        [log] des Protokolls `{ $log }` ohne Messpunkt
       *[points] von Messpunkten ohne Zeile in Protokoll `{ $log }`
    } ({ $columns }): { $keys }; siehe import.json
rigid-pairs-sampled = von den { $pairs } Abständen zwischen { $targets } Zielmarken eines starren Teils werden { $compared } verglichen

point-pairs-many = { $pairs } Paare von Namen haben Punkte an derselben Stelle; die ersten { $named } sind aufgeführt
    .hint = die Bezeichnungen des Exports prüfen

pose-misspelt = Pose `{ $pose }` { $of ->
        [log] des Protokolls `{ $log }` wurde nicht gemessen, und gemessene Posen fehlen im Protokoll
       *[points] ist nicht in Protokoll `{ $log }`, und Posen des Protokolls wurden nicht gemessen
    }

join-key-missing = die Verknüpfung braucht `{ $key }`, das in manchen Zeilen fehlt
    .hint = `{ $key }` in `label` der Exporte und in `columns` des Protokolls nennen oder `by` in [join] ändern

join-by-label-targets = eine Verknüpfung nach Bezeichnung setzt einen Roboter mit einer einzigen Zielmarke voraus; dieser hat { $count }
    .hint = eine Zielmarke nennen oder mit `by` in [join] einen anderen Schlüssel wählen

join-by-label-frame = eine Verknüpfung nach Bezeichnung braucht ein einziges Weltkoordinatensystem für alle Posen
    .hint = das Koordinatensystem durch unbewegte Punkte definieren

label-not-measured = kein Messpunkt hat die Bezeichnung `{ $label }`

points-untouched = { $count ->
        [one] 1 Punkt wird
       *[other] { $count } Punkte werden
    } von keiner Zeile des Protokolls `{ $log }` berührt; der erste ist `{ $label }`

log-times-not-increasing = die Zeiten des Protokolls `{ $log }` nehmen in Zeile { $row } nicht zu
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
    } mehrere Zeilen von Protokoll `{ $log }` innerhalb von { $tolerance_s } s: die zeitlich nächste Zeile wird verwendet
    .hint = `tolerance_s` auf weniger als die halbe Periode des Protokolls verringern

points-without-row = { $count ->
        [one] 1 Messpunkt hat
       *[other] { $count } Messpunkte haben
    } keine Zeile von Protokoll `{ $log }` innerhalb von { $tolerance_s } s

rows-without-point = { $count ->
        [one] 1 Zeile
       *[other] { $count } Zeilen
    } von Protokoll `{ $log }` ohne Messpunkt

target-time-twice = { $count } Punkte der Zielmarke `{ $target }` haben dieselbe Zeit (Zeilen { $lines })
    .hint = die Zeiten berichtigen oder die Zielmarke jedes Punkts nennen

log-row-met-twice = Zeile { $row } von Protokoll `{ $log }` liegt { $count } Punkten der Zielmarke `{ $target }` am nächsten (Zeilen { $lines })
    .hint = `tolerance_s` verringern oder `clock_offset_s` prüfen; von mehreren Messungen in einem Stillstand den Mittelwert als einen Punkt angeben

clock-offset-none = kein Versatz der Uhren legt alle Messpunkte in Stillstände des Protokolls: { $count ->
        [one] der erste Punkt (bis { $last_s } s) passt
       *[other] die ersten { $count } Punkte (bis { $last_s } s) passen mit einem gemeinsamen Versatz
    }, der Punkt bei { $first_s } s passt nicht
    .hint = in Bewegung gemessene Punkte entfernen; oder `clock_offset_s` als Zahl angeben: Zeilen ohne Zuordnung werden dann aufgelistet

range-of-seconds = { FIXED($low_s, 3) } bis { FIXED($high_s, 3) } s

clock-offsets-several = die Stillstände sind mit { $count } Bereichen des Uhrenversatzes vereinbar, zuerst: { $ranges }
    .hint = die Uhren vergleichen und `clock_offset_s` als Zahl angeben

axis-of-world = "x", "y" oder "z"

observe-key-missing = die Art `{ $kind }` braucht `{ $column }`
    .hint = `{ $column }` angeben

distance-not-positive = `distance_mm` fehlt oder ist keine Länge
    .expected = eine Länge größer als 0

fixed-point-on-robot = `{ $name }` ist eine Zielmarke am Roboter, kein fester Punkt
    .hint = festen Punkten eigene Namen geben; Zeilen, die nur feste Punkte betreffen, haben keine Pose

distance-to-itself = der Abstand reicht von `{ $name }` zu sich selbst
    .hint = `other` berichtigen

target-of-same-branch = `{ $target }` und `{ $name }` gehören zum selben Zweig
    .hint = eine Zielmarke eines anderen Zweigs angeben; die Form der Zielmarken an einem Glied steht in [[rigid]]

bar-without-other-hand = `{ $name }` ist keine Zielmarke auf einem anderen Zweig als `{ $target }`
    .hint = eine Zielmarke eines anderen Zweigs angeben; `kind = "distance"` gilt für einen Stab mit festem Ende

bar-length-at-pose = ein Stab hat an allen Posen dieselbe Länge
    .hint = `distance_mm` in einer Zeile ohne Pose angeben; an jeder Pose gemessene Längen haben `kind = "distance"`

number-missing = `{ $column }` fehlt oder ist keine Zahl
    .expected = { $column ->
            [offset_mm] der Abstand der Zielmarke von der Ebene, längs der angegebenen Achse, oder von der Kugel, nach außen: Radius der Zielkugel oder 0
           *[value_deg] der Gelenkwert nach dem Schalter oder dem zweiten Geber
        }

row-without-pose = eine Zeile der Art `{ $kind }` hat keine Pose
    .hint = nur Zeilen über feste Punkte haben keine Pose: Positionen (`point`), Abstände (`distance`) und Positionen auf `plane`, `line` oder `sphere`

known-unsupported = für eine Zeile der Art `{ $kind }` gibt es kein [[known]]
    .expected = `point`, `distance`, `plane`, `line` oder `sphere`

near-without-surface = `near_mm` gilt nur für Positionen auf Flächen
    .hint = `near_mm` entfernen

kind-of-arms = { $kind ->
        [joints] Gelenkwerte
       *[poses] Posen
    } gelten nur für räumliche Arme, nicht für `{ $model }`
    .hint = Positionen oder Abstände von Zielmarken beobachten

kind-unknown = `{ $name }` ist keine Art von Beobachtung

name-on-few-rows = `{ $name }` steht nur in { $count ->
        [one] 1 Zeile
       *[other] { $count } Zeilen
    }, `{ $meant }` in { $meant_count }
    .hint = war `{ $meant }` gemeint? Sonst die Zeilen von `{ $name }` ausschließen: sie bestimmen seine Lage nicht

base-moves = die Gelenke { $joints } bewegen `base_link`: Positionen gelten als in einem mitbewegten Koordinatensystem gemessen
    .hint = wenn das Messgerät fest im Raum steht, die Wurzel der URDF-Datei als `base_link` angeben

names-of-fixed-things = Zielmarken, Punkten und Ebenen verschiedene Namen geben

partial-coordinates = { $count ->
        [one] 1 Zeile gibt
       *[other] { $count } Zeilen geben
    } eine oder zwei Koordinaten einer Zielmarke an: jede Koordinate zählt einzeln ({ $by ->
        [line] Zeile
       *[pose] Pose
    } { $rows }{ $more ->
        [0] {""}
       *[other] {" "}und { $more } weitere
    })

rows-not-measured = { $count ->
        [one] 1 Zeile ohne Gelenkwert oder ohne Koordinaten ist
       *[other] { $count } Zeilen ohne Gelenkwert oder ohne Koordinaten sind
    } ausgelassen ({ $by ->
        [line] Zeile
       *[pose] Pose
    } { $rows }{ $more ->
        [0] {""}
       *[other] {" "}und { $more } weitere
    })

station-missing = die Spalte `station` ist hier leer, obwohl andere Punkte eine Station angeben
    .hint = die Station nennen: Zeilen ohne Station gehören zur Station des Weltkoordinatensystems, die den Roboter an mindestens { $least } Posen sehen muss

coordinates-unknown = `{ $text }` nennt keine Koordinaten
    .expected = Buchstaben aus x, y und z: "z", "xy"

place-missing = die Position von `{ $point }` fehlt oder ist keine Zahl
    .hint = seine Koordinaten ergänzen oder die Zeile entfernen

joint-value-missing = ein Gelenkwert fehlt oder ist keine Zahl
    .hint = die Zeile ergänzen oder entfernen

station-row-unsupported = { $fault ->
        [kind] eine Zeile der Art `{ $kind }` gibt die Station `{ $station }` an
        [coordinate] eine von Station `{ $station }` gemessene Koordinate fehlt oder ist keine Zahl
        [covariance] ein von Station `{ $station }` gemessener Punkt gibt eine Kovarianz an
       *[uncertainties] von Station `{ $station }` gemessene Koordinaten haben eigene Unsicherheiten
    }
    .expected = Zeilen der Art `point` oder `pose` mit x_mm, y_mm, z_mm und einer Unsicherheit `u_mm`, für alle Stationen außer der ersten
station-join-by-label = die Punkte der Station `{ $station }` werden nach Bezeichnung verknüpft
    .hint = sie nach Pose, Zeile oder Zeit verknüpfen: ein angetasteter Punkt wird im Weltkoordinatensystem gemessen

uncertainty-not-positive = `{ $column }` = { $value } ist keine Standardunsicherheit
    .expected = eine positive Zahl

coordinates-of-rows-missing = { $axes } { $missing ->
        [one] fehlt
       *[other] fehlen
    } in { $by ->
        [line] Zeile
       *[pose] Pose
    } { $rows }{ $more ->
        [0] {""}
       *[other] {" "}und { $more } weiteren
    }
    .hint = die Zeile vervollständigen oder weglassen; wenn nur die anderen Koordinaten gemessen wurden, deren Standardunsicherheit angeben: eine Spalte `u_mm`, `expanded_uncertainty_um` in [instrument], oder --standard-uncertainty-um bei `etalon identify` und `etalon verify`

uncertainty-missing = { $count ->
        [one] eine Zeile hat
       *[other] { $count } Zeilen haben
    } keine Standardunsicherheit der { $column ->
        [urot_deg] Drehung
       *[u_mm] Länge
    }: { $by ->
        [line] Zeile
       *[pose] Pose
    } { $rows }{ $more ->
        [0] {""}
       *[other] {" "}und { $more } weitere
    }
    .hint = { $column ->
            [urot_deg] `expanded_rotation_uncertainty_deg` in [instrument] oder eine Spalte `urot_deg` angeben; bei `etalon identify` und `etalon verify` --rotation-uncertainty-deg
           *[u_mm] `expanded_uncertainty_um` in [instrument] oder eine Spalte `u_mm` angeben; bei `etalon identify` und `etalon verify` --standard-uncertainty-um
        }

surface-axis-missing = { $kind ->
        [line] die Gerade `{ $name }` braucht die Achse des Weltkoordinatensystems, die ihrer Richtung am nächsten ist
       *[plane] die Ebene `{ $name }` braucht die Achse des Weltkoordinatensystems, die ihrer Normalen am nächsten ist
    }
    .expected = x, y oder z in der Spalte `axis`{ $kind ->
            [line] {""}
           *[plane] : z für einen Tisch, x oder y für eine Wand
        }

offset-of-line = `offset_mm` gilt nur für Ebenen und Kugeln, nicht für eine Gerade
    .hint = die Zelle leer lassen

near-missing = eine Position auf `{ $kind }` braucht `near_mm`
    .hint = ihre ungefähre Position im Weltkoordinatensystem angeben

load-direction-unknown = `{ $direction }` ist keine Richtung
    .expected = +x, -x, +y, -y, +z oder -z

load-direction-unmeasured = Richtung `{ $direction }` braucht `z_mm`: in dieser Richtung ist keine Verschiebung gemessen
    .hint = die Spalte `z_mm` hinzufügen oder die Zeile entfernen

force-not-a-number = `{ $text }` ist keine Kraft
    .expected = eine Kraft in Newton, null oder positiv: die Richtung gibt das Vorzeichen

drift-without-commanded = `drift_set` braucht Sollposen
    .hint = sie angeben: `commanded = "commanded.csv"`

attained-poses-twice = [poses] und [repeatability] geben beide Istposen an
    .hint = [repeatability] für Punkte mit Bezeichnung oder [poses] für eine Tabelle behalten

limit-without-value = der Grenzwert `{ $limit }` kann nicht beurteilt werden: an Pose { $pose } fehlt dieser Wert
    .hint = jede Pose mindestens zweimal anfahren und als Sollpose angeben

compensation-scatters = die Istpositionen streuen nach der Korrektur durch die Referenzmarken um { LENGTH($after_mm) } um das Mittel ihrer Pose, vorher um { LENGTH($before_mm) }
    .hint = nach einem falschen Messwert unter den Referenzmarken suchen oder sie weglassen

reference-targets-misshapen = die Referenzmarken von Zyklus { $cycle } weichen um { LENGTH($rms_mm) } (quadratischer Mittelwert) von einer starren Bewegung seit dem ersten Zyklus ab; erweiterte Messunsicherheit { LENGTH($expanded_mm) }
    .hint = eine Referenzmarke hat sich bewegt oder wurde falsch gemessen: sie neu messen oder weglassen

repeatability-frame = [repeatability] braucht ein einmal gemessenes Weltkoordinatensystem
    .hint = das Koordinatensystem durch unbewegte Punkte definieren

commanded-angle-unmeasured = `{ $column }` hat Sollwerte, aber Punkte mit Bezeichnung haben nur Positionen
    .hint = die Spalte entfernen oder Istposen mit Winkeln als Tabelle angeben: [poses]

commanded-pose-missing = für diese Posen ist keine Sollposition angegeben: { $poses }
    .hint = für jede gemessene Pose des Ablaufs eine Zeile ergänzen

commanded-pose-unmeasured = Pose { $pose } ist Sollpose, aber dort wurde nichts gemessen

trajectory-empty = der Ablauf hat keine Pose
    .hint = die Posen eines Zyklus in ihrer Reihenfolge angeben, zum Beispiel [1, 2, 1, 3]

coplanar-not-four = `coplanar` nennt nicht vier Posen des Ablaufs
    .expected = vier seiner Posen, jede einmal

pose-not-in-trajectory = Pose { $pose } (Zyklus { $cycle }) ist nicht im Ablauf
    .hint = die Bezeichnung berichtigen oder die Pose in `trajectory` ergänzen

pose-of-several-targets = Pose { $pose } (Zyklus { $cycle }) hat Messwerte von `{ $target }` und einer anderen Zielmarke
    .hint = in `label` die einzige Zielmarke der Prüfung nennen

pose-of-cycle = Pose { $pose } von Zyklus { $cycle }

visit-count-differs = Pose { $pose } wurde in Zyklus { $cycle } { $found }-mal gemessen, der Ablauf fährt sie aber { $count }-mal an
    .hint = den fehlenden Messwert ergänzen oder alle Messwerte dieser Pose und dieses Zyklus entfernen: ihre Anfahrrichtungen sind unbekannt

visits-missing = nicht gemessen: { $poses }{ $count ->
        [one] {""}
       *[other] {""}; insgesamt { $count }
    }

homing-instrument-too-coarse = die Messunsicherheit übersteigt 25 % der Wiederholgenauigkeit der Referenzfahrt, { LENGTH($rp_mm) }
    .hint = den Wert als Obergrenze verwenden oder mit einem besseren Messgerät messen

central-part-too-large = { $option } überschreitet 100 %
    .expected = eine Zahl größer als 0 und höchstens 100

path-points-out-of-range = der Wert von { $option } liegt außerhalb des zulässigen Bereichs
    .expected = 2 bis 100000

path-not-stated = { $option } braucht { $path }
    .hint = die Datei der Sollbahn angeben

weave-incomplete = für das Pendeln fehlt { $option }
    .hint = Hub, Frequenz und Richtung angeben

weave-direction-count = { $option } muss drei Zahlen haben
    .expected = x, y und z der Auslenkungsrichtung

stream-twice = die Aufzeichnung `{ $stream }` kommt zweimal vor
    .hint = jeder Aufzeichnung einen eigenen Namen geben

in-observation = Pose { $pose }, Zyklus { $cycle } der Beobachtungen: { $message }

in-candidate = Pose { $pose } der Kandidaten: { $message }

in-feature = Geometrieelement `{ $name }`: { $message }

joints-of-pose-differ = die Zeilen dieser Pose haben verschiedene Gelenkwerte
    .hint = sie berichtigen oder Wiederholungen in der Spalte `cycle` nummerieren

target-repeated = die Zielmarke `{ $target }` kommt zweimal vor
    .hint = Wiederholungen in der Spalte `cycle` nummerieren

arms-apart = mit Nennparametern treffen sich die Arme bei diesen Gelenkwerten nicht
    .hint = Einheit, Vorzeichen und Versatz der Gelenke und die Nennparameter prüfen

assembly-mode-missing = der Montagemodus ist nicht angegeben
    .expected = 1 oder -1 in der Spalte `assembly`
    .hint = Kandidaten können auch Positionen sein: `pose,x_mm,y_mm` ohne Gelenkwerte ergibt alle Arbeitsmodi

assembly-mode-ambiguous = beide Montagemodi passen gleich gut: { FIXED($near_mm, 2) } mm und { FIXED($far_mm, 2) } mm von der gemessenen Position
    .hint = eine Spalte `assembly` mit 1 oder -1 angeben; oder die Lage der Basis (x_o, y_o, phi) unter [nominal]

assembly-modes-assumed = der Montagemodus von { $count } Beobachtungen wurde aus der Messung abgeleitet ({ $positive } in Modus +1, { $negative } in Modus -1); am wenigsten eindeutig ist Pose { $pose }: { FIXED($near_mm, 1) } mm und { FIXED($far_mm, 1) } mm
    .hint = eine Spalte `assembly` mit 1 oder -1 angeben, wenn das Protokoll sie enthält

uncertainties-twice = die Tabelle gibt sowohl Standardunsicherheiten als auch Kovarianzen von Koordinaten an
    .hint = `ux_mm`, `uy_mm`, `uz_mm` entfernen

coordinate-uncertainty-missing = die Zeile gibt eine Unsicherheit an, aber `{ $column }` ist leer
    .expected = für jede Koordinate 0,00002 mm bis 100 mm oder alle Zellen leer

coordinate-uncertainty-unusable = `{ $column }` = { $value } kann nicht die Unsicherheit einer Koordinate sein
    .expected = für jede Koordinate 0,00002 mm bis 100 mm oder alle Zellen leer

position-covariance-invalid = die Kovarianz der Zeile ist nicht positiv definit
    .hint = Reihenfolge und Einheit der Spalten `cxx_mm2` .. prüfen

unplaced = { $kind ->
        [targets] { $count ->
            [one] 1 Zielmarke
           *[other] { $count } Zielmarken
        }
        [fixtures] { $count ->
            [one] 1 festes Element
           *[other] { $count } feste Elemente
        }
       *[both] { $count } Zielmarken und feste Elemente
    } nur an Validierungsposen gemessen: { $names }; Lage aus diesen Messwerten bestimmt, bei festgehaltenen identifizierten Roboterparametern

validation-leaves-nothing = { $unplaced }: für die Validierung bleibt kein redundanter Messwert
    .hint = sie auch an Kalibrierposen messen oder eine Pose, an der sie gemessen wurden, in `calibration` aufnehmen

placed-by-validation = { $unplaced }; die Statistik berücksichtigt das
    .hint = sie auch an Kalibrierposen messen oder eine Pose, an der sie gemessen wurden, in `calibration` aufnehmen

placed-by-validation-unjudged = { $unplaced }; Messwerte ohne Redundanz werden nicht beurteilt: { $names }
    .hint = sie auch an Kalibrierposen messen oder eine Pose, an der sie gemessen wurden, in `calibration` aufnehmen

candidate-positions-unreachable = das Modell `{ $model }` erreicht keine Kandidatenposition oder hat keine inverse Kinematik
    .hint = Gelenkwerte angeben, eine Spalte je Gelenk mit ihrer Einheit

check-readings = dort nach vertauschten Bezeichnungen und falschen Messwerten suchen; neu messen oder mit `exclude` in [identify] ausschließen

coordinates-wrong = { $count ->
        [one] eine Koordinate passt
       *[other] { $count } Koordinaten passen
    } nur mit anderem Dezimalzeichen oder Vorzeichen zu den anderen Messwerten: { $coordinates }
    .hint = Dezimalzeichen und Vorzeichen dieser Koordinaten im Export prüfen

decimal-mark-wrong = Zeile { $row }: { $axis } von { $target } ist { FIXED($value_mm, 3) } mm; die meisten anderen Zeilen liegen zwischen { FIXED($least_mm, 0) } und { FIXED($most_mm, 0) } mm, wie { FIXED($agrees_mm, 3) } mm
    .hint = das Dezimalzeichen dieser Zeile prüfen

settle-readings = zuerst die Messwerte der { $number ->
        [one] Pose
       *[other] Posen
    } { $poses } klären: berichtigen, neu messen oder mit `exclude` in [identify] ausschließen

readings-decide = { $count ->
        [one] ein Messwert (Pose { $poses }) widerspricht den anderen und bestimmt das Ergebnis: ohne ihn
       *[other] { $count } Messwerte (Posen { $poses }) widersprechen den anderen und bestimmen das Ergebnis: ohne sie
    } ändert sich `{ $parameter }` um { FIXED($times, 1) } Standardunsicherheiten

robust-fit-disagrees = eine robuste Anpassung ändert `{ $parameter }` um { FIXED($over_u, 1) } Standardunsicherheiten der Differenz (Grenzwert { FIXED($limit, 1) }); keine Pose widerspricht allen anderen: die Residuen sind nicht normalverteilt
    .hint = der Roboter hat Abweichungen, die das Modell nicht beschreibt, oder die angegebene Unsicherheit ist zu klein

robust-fit-disagrees-at-poses = eine robuste Anpassung ändert `{ $parameter }` um { FIXED($over_u, 1) } Standardunsicherheiten der Differenz (Grenzwert { FIXED($limit, 1) }); Posen, die den anderen widersprechen: { $poses }

target-positions = `{ $target }` ({ $count ->
        [one] 1 Position
       *[other] { $count } Positionen
    })

coordinates-commanded = der nominale Roboter reproduziert die Koordinaten von { $targets } aus den Gelenkwerten bis auf { SCIENTIFIC($largest_mm, 2) } mm, die Rundung der Datei: sie sind Sollwerte, keine Messwerte
    .hint = in `columns` die gemessenen Koordinaten nennen; bei simulierten Daten in der Kampagne `synthetic` angeben

frame-points-mirrored = die Punkte des Weltkoordinatensystems sind { FIXED($off_mm, 3) } mm von ihren Nennpositionen entfernt, passen aber bis auf { FIXED($limit_mm, 3) } mm zu deren Spiegelbild
    .hint = zwei Achsen des Exports sind vertauscht, oder eine hat das falsche Vorzeichen: seine Spalten prüfen

frame-point-off = `{ $point }` ist relativ zu den anderen Punkten { FIXED($off_mm, 3) } mm von seiner Nennposition entfernt (Toleranz { $tolerance_mm } mm, U = { FIXED($expanded_mm, 4) } mm)
    .hint = den Punkt, seine Bezeichnung und `nominal_mm` prüfen oder die Toleranz nach der Zeichnung angeben

frame-points-off = Abstand von `{ $first }` zu `{ $second }`: gemessen { FIXED($measured_mm, 3) } mm, nominal { FIXED($nominal_mm, 3) } mm (Toleranz { $tolerance_mm } mm, U = { FIXED($expanded_mm, 4) } mm)
    .hint = den Punkt, seine Bezeichnung und `nominal_mm` prüfen oder die Toleranz nach der Zeichnung angeben

nominal-point-unmeasured = `nominal_mm` nennt `{ $point }`, das nicht gemessen wurde

nominal-few-points = `nominal_mm` braucht mindestens drei Punkte
    .hint = Punkte des Koordinatensystems ergänzen oder `nominal_mm` entfernen

world-axes-exchanged = die Basis ist { FIXED($off_mm, 0) } mm und { FIXED($off_deg, 1) } deg von der Lage entfernt, die robot.toml angibt: x, y, z von robot.toml entsprechen { $axes } des Weltkoordinatensystems
    .hint = Achsen, Einheit und Punkte des Weltkoordinatensystems und [nominal] in robot.toml prüfen

base-off-nominal = die Basis ist { FIXED($off_mm, 0) } mm und { FIXED($off_deg, 1) } deg von der Lage entfernt, die robot.toml angibt; Grenzwert { $limit_mm } mm, { FIXED($limit_deg, 1) } deg
    .hint = Achsen, Einheit und Punkte des Weltkoordinatensystems und [nominal] in robot.toml prüfen

orientation-slip = { $slip ->
        [scalar-last] der Skalar der Quaternionen am Ende
        [scalar-first] der Skalar der Quaternionen am Anfang
        [scalar-last-inverse] der Skalar der Quaternionen am Ende und die inversen Drehungen
        [order] Winkel in der Reihenfolge `{ $name }`
        [vectors] Rotationsvektoren statt Winkel
        [order-of-vectors] Winkel in der Reihenfolge `{ $name }` statt Rotationsvektoren
        [radians] Winkel in Radiant statt Grad
        [degrees] Winkel in Grad statt Radiant
        [negated] die Winkel mit dem anderen Vorzeichen
        [inverse] die inversen Drehungen
       *[left-handed] ein Linkssystem ({ $name } umgekehrt)
    }

orientations-off = die beobachteten Orientierungen unterscheiden sich von den Orientierungen des { $robot ->
        [nominal] nominalen Roboters
       *[identified] identifizierten Roboters
    } um { FIXED($median_deg, 1) } deg (Median)
    .hint = prüfen, ob qw, qx, qy, qz (Skalar zuerst) Vektoren vom Körper in das Weltkoordinatensystem drehen; oder die Reihenfolge der Winkel prüfen: ohne `orientation` werden die passenden Reihenfolgen genannt

few-poses-to-leave-out = { $count ->
        [one] 1 Kalibrierpose ist
       *[other] { $count } Kalibrierposen sind
    } zu wenige, um einige auszulassen
    .expected = mindestens { $least }
    .hint = mehr Posen messen oder mehr Posen in `calibration` nennen

nothing-to-judge = keine Beobachtung ist eine Position, ein Abstand oder ein Kontakt
    .hint = Parameter werden nach Positionsabweichungen beurteilt: Positionen, Abstände oder Kontakte messen

validation-repeats-calibration = die Validierung wiederholt die Kalibrierung: der Abstand einer Validierungspose von der nächsten Kalibrierpose beträgt im Median das { FIXED($median, 2) }-Fache des Abstands der Kalibrierposen; Grenzwert { $limit }
    .hint = die Abweichung des Roboters kann anderswo größer sein: an Posen zwischen den Kalibrierposen validieren

validation-far = die Validierung ist weit von der Kalibrierung entfernt: der Abstand einer Validierungspose von der nächsten Kalibrierpose beträgt im Median das { FIXED($median, 2) }-Fache des Abstands der Kalibrierposen; Grenzwert { $limit }
    .hint = an Posen kalibrieren, die über den benutzten Arbeitsraum verteilt sind

error-quantity-unknown = `{ $name }` ist keine Größe einer Abweichung
    .hint = die Kampagne erneut ausführen: `etalon run KAMPAGNE`

pose-set-unknown = `{ $name }` ist keine Gruppe von Posen
    .expected = calibration oder validation

joints-do-not-move = die Gelenke bewegen sich nicht: alle { $rows } Beobachtungen liegen { $motion }; sie zeigen keinen Parameter des Roboters{ $points ->
        [0] {""}
       *[other] {" "}(Streuung der gemessenen Punkte: { FIXED($scatter_mm, 3) } mm)
    }
    .hint = Posen mit verschiedenen Werten jedes Gelenks messen; wenn sich der Roboter doch bewegt hat, sind die Gelenkwerte aus falschen Spalten oder aus einer veralteten Datei gelesen

motion-none = an einer Pose

motion-within-angle = innerhalb von { FIXED($range_deg, 3) } deg jedes Gelenks

motion-within-length = innerhalb von { FIXED($range_mm, 3) } mm jedes Gelenks

motion-within-both = innerhalb von { FIXED($range_deg, 3) } deg und { FIXED($range_mm, 3) } mm jedes Gelenks

joint-does-not-move = `{ $joint }` bewegt sich nicht: mangels Daten { $count ->
        [one] bleibt 1 Parameter nur bis auf seine Toleranz bekannt
       *[other] bleiben { $count } Parameter nur bis auf ihre Toleranz bekannt
    }: { $parameters }
    .hint = `{ $joint }` zwischen den Kalibrierposen bewegen oder den Roboter nur bei diesem Wert verwenden; sonst bleiben Abweichungen bis zur Toleranz von `{ $first }`

direction-undetermined = seine Richtung hat eine Standardunsicherheit von { FIXED($direction_deg, 0) } deg; Grenzwert { $limit_deg } deg
    .hint = Punkte mit größerem Abstand messen, nicht alle auf einer Geraden

direction-uncertain = seine Richtung hat eine Standardunsicherheit von { FIXED($direction_deg, 2) } deg; Grenzwert { $limit_deg } deg
    .hint = Punkte mit größerem Abstand messen

world-side-undetermined = `towards` liegt auf der Achse: die Seite der anderen Achse ist damit nicht festgelegt
    .hint = einen Punkt neben der Achse angeben

frame-few-targets = das Weltkoordinatensystem hat { $count ->
        [one] 1 Zielmarke
       *[other] { $count } Zielmarken
    }
    .expected = mindestens drei Zielmarken

frame-never-complete = an keiner Pose sind alle Zielmarken { $targets } des Weltkoordinatensystems gemessen und voneinander verschieden
    .hint = alle messen und ihre Bezeichnungen prüfen

orientations-twice = die Tabelle gibt die Orientierung zweimal an: { $first } und { $second }
    .hint = eine davon weglassen

orientation-columns-missing = der Orientierung fehlt { $missing }
    .expected = { $columns }: Orientierung des Körpers im Weltkoordinatensystem

orientation-missing = die Orientierung fehlt oder ist keine Zahl
    .expected = qw, qx, qy, qz: Orientierung des Körpers im Weltkoordinatensystem; oder ein Rotationsvektor, oder drei Winkel

angle-order-missing = die Reihenfolge der Winkel ist nicht angegeben
    .hint = `orientation = "zyx"` in [observations] oder --orientation angeben

angle-orders-unfit = keine Reihenfolge der Winkel passt zum nominalen Roboter: mit `{ $order }` ist die Abweichung { FIXED($left_deg, 1) } deg (quadratischer Mittelwert); prüfen, ob die Winkel die Drehung vom Körper in das Weltkoordinatensystem beschreiben, und die Gelenkwerte prüfen

angle-order-leaves = { FIXED($left_deg, 3) } deg mit `{ $order }`

angle-orders-fit = `orientation = "{ $order }"` in [observations] oder --orientation angeben; Abweichung vom nominalen Roboter (quadratischer Mittelwert): { $orders }

ball-missing = Kugel `{ $target }` fehlt (Pose { $pose }, Zyklus { $cycle })
    .hint = die Kugel messen oder die anderen Messwerte dieser Pose und dieses Zyklus entfernen

actuator-unknown = Antrieb { $actuator } existiert nicht
    .expected = 1, 2 oder 3

lead-position-unknown = Position { $position } von Antrieb { $actuator } ist nicht in `positions_mm`
    .hint = die Bezeichnung berichtigen oder `positions_mm` ergänzen

geometric-frame = die geometrische Kalibrierung braucht ein durch die Schienen und Kugel R definiertes Weltkoordinatensystem
    .expected = `plane`, `origin`, `y_axis = [Ursprung, anderes Ende]` und `towards`, wie in 3.4.1 der Dissertation

geometric-other-robot = [geometric] ist nur für einen PreXYT verfügbar
    .expected = ein Roboter mit Modell `prexyt`

scale-bar-error = Kalibrierstab `{ $name }`: die Abweichung von { FIXED($error_mm, 4) } mm überschreitet die Fehlergrenze von { FIXED($limit_mm, 4) } mm
    .hint = Taster, Temperatur und Aufstellung des Messgeräts prüfen und den Kalibrierstab neu messen

scale-bar-deviates = Kalibrierstab `{ $name }`: ein Abstand weicht um { FIXED($error_mm, 4) } mm von der angegebenen Länge ab; zulässig sind { FIXED($limit_mm, 4) } mm und U = { FIXED($u_mm, 4) } mm der Länge
    .hint = Länge und Unsicherheit aus dem Kalibrierschein des Stabs angeben, Taster und Temperatur prüfen und den Stab neu messen

scale-bar-uncertain = Kalibrierstab `{ $name }`: die Fehlergrenze ist das { FIXED($ratio, 1) }-Fache der erweiterten Messunsicherheit seines Kalibrierscheins, gefordert ist mindestens das { $least }-Fache
    .hint = einen Kalibrierstab mit kleinerer Messunsicherheit im Kalibrierschein verwenden: dieser Stab kann das Messgerät nicht prüfen

step-scatters = { $step }: die Residuen streuen um { FIXED($found_mm, 4) } mm, die Unsicherheit des Messgeräts ist { FIXED($stated_mm, 4) } mm: die Unsicherheiten folgen aus den Residuen
    .hint = nach Spiel, einer schmutzigen Kugel oder einer losen Halterung suchen; den Schritt neu messen

table-without-poses = an keiner Pose der Tabelle `{ $title }` wurden K und L zusammen gemessen
    .hint = beide Kugeln im selben Zyklus messen oder andere Posen wählen

given-without-covariance = die Parameter haben keine Kovarianz
    .hint = aus mehr Daten neu identifizieren: die Identifikation hatte keine Freiheitsgrade

calibrated-targets-missing = den Parametern fehlen { $names }: die Beobachtungen haben eine andere Basis oder andere Zielmarken
    .hint = die Zielmarken der Kalibrierung an derselben Stelle des bewegten Teils beobachten

parameters-of-other-robot = die Parameter gehören zu einem Roboter `{ $identified }`; robot.toml beschreibt einen anderen (`{ $stated }`)
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
    .hint = prüfen, ob die Parameter zu diesem Roboter gehören

robot-geometry-changed = robot.toml beschreibt eine andere Geometrie als die Identifikation: { $case ->
        [apart] bei gleichen Parametern liegen die Flansche { $distance_mm } mm auseinander
       *[other] Gelenke oder Glieder sind andere
    }
    .hint = die robot.toml angeben, mit der die Parameter identifiziert wurden, oder neu identifizieren

robot-geometry-unknown = robot.toml ist keine Datei der Identifikation, und parameters.json enthält keine Geometrie zum Vergleich
    .hint = prüfen, ob robot.toml den identifizierten Roboter beschreibt, oder die Kampagne erneut ausführen

calibration-without-residuals = aus der Kalibrierung ergibt sich keine Standardunsicherheit einer Koordinate
    .hint = mit angegebener Standardunsicherheit identifizieren

effect-would-prove = signifikanter Effekt: { $effect }{ $count ->
        [0] {""}
       *[other] {" "}der Gelenke { $joints }
    }; damit sinkt die Abweichung an ausgelassenen Kalibrierposen von { FIXED($without_mm, 3) } auf { FIXED($with_mm, 3) } mm (Position, quadratischer Mittelwert)
    .hint = "{ $effect }" in `effects` von [identify] ergänzen

outliers-too-many = `outliers = "exclude"` würde mehr als { $share_percent } % aller Messwerte ausschließen
    .hint = das Modell oder der Aufbau ist falsch: die Messwerte prüfen, die `outliers = "keep"` meldet

log-correlates = mit Protokoll `{ $log }` korrelieren die Residuen mit der Differenz beider Protokolle (r = { FIXED($correlation, 2) }); ihr quadratischer Mittelwert ist { FIXED($rms_mm, 3) } mm, mit Protokoll `{ $other }` dagegen { FIXED($other_rms_mm, 3) } mm

use-log = { $hint ->
        [name-first] mit Protokoll `{ $log }` identifizieren: dieses zuerst nennen
       *[is-used] Protokoll `{ $log }` verwenden, wie in dieser Kampagne
    }

selected-pose-unmeasured = `{ $pose }` nennt keine gemessene Pose

selection-without-pose = `{ $set }` wählt keine gemessene Pose aus

sets-overlap = diese Posen gehören zur Kalibrierung und zur Validierung: { $poses }
    .hint = `validation = "rest"` nimmt alle Posen, die nicht zur Kalibrierung gehören

series-overlap = diese Posen gehören zu mehreren Serien: { $poses }
    .hint = jede Pose nur einer Serie zuordnen

series-without-calibration = Serien ohne Kalibrierpose bleiben unberücksichtigt: { $series }

series-incomplete = diese Kalibrierposen gehören zu keiner Serie: { $poses }
    .hint = `"rest"` nimmt alle Posen, die zu keiner früheren Serie gehören

series-single = `series` enthält nur eine Serie mit Kalibrierposen
    .hint = mindestens zwei Serien angeben oder `series` entfernen

table-selection-empty = die Tabelle `{ $title }` enthält keine gemessene Pose
    .hint = Posen von `calibration` und `validation` wählen

poses-measured = { $count ->
        [one] 1 Pose ist
       *[other] { $count } Posen sind
    } gemessen und verknüpft, von { $first } bis { $last }

poses-unmeasured = keine Pose ist gemessen und verknüpft

at-pose = Pose { $pose }: { $message }

values-of-column = { $message } (betrifft { $count } von { $total } Werten)

check-column-unit = die Einheit seiner Spalte prüfen: alle Werte liegen im Bereich, wenn sie { $units ->
        [degrees] Grad statt Radiant
       *[millimetres] Millimeter statt Meter
    } sind

joint-out-of-range = Gelenk `{ $joint }` = { $value } { $unit } ist außerhalb des Bereichs
    .expected = von { $lower } bis { $upper } { $unit }: { $reason ->
            [limits] die Grenzen der Roboterdatei, über die 1 % ihres Abstands hinausgehen darf
            [turns] zwei Umdrehungen, da die Roboterdatei keine Grenzen angibt
           *[others] nach dem Bereich der anderen Werte
        }
    .hint = Dezimalzeichen und Einheit des Werts prüfen; kann das Gelenk diesen Wert annehmen, { $reason ->
            [limits] seine Grenzen in der Roboterdatei berichtigen
           *[others] seine Grenzen in der Roboterdatei angeben
        }

common-errors-of-conditions = die Ziehungen erfassen gemeinsame Abweichungen aller Messwerte (Maßstab, Temperatur, Referenzfahrt) nur bei Positionen von Zielmarken
    .hint = `etalon run` gibt die Unsicherheiten dieser Kampagne mit linearer Fortpflanzung an

probe-of-feature-unknown = `{ $feature }` wird nicht angepasst: seine Punkte sind Tastermittelpunkte, und die Datei gibt nicht an, { $missing ->
        [side] auf welcher Seite der Taster war
       *[radius] welchen Radius der Taster hat
    }
    .hint = { $missing ->
            [side] angeben: --probe-side inside, outside oder x,y,z
           *[radius] angeben: --probe-radius-mm
        }

unstable-parameter = `{ $parameter }` ({ FIXED($over_sd, 1) }, Grenzwert { FIXED($limit, 1) })

parameters-unstable = instabile Parameter; die Werte aus einem Teil der Posen weichen von den Werten aus allen Posen ab (in Standardabweichungen der Differenz): { $parameters }
    .hint = nach Änderungen während der Messung suchen (Temperatur, eine bewegte Zielmarke, ein neu referenziertes Gelenk) und die Residuen prüfen

remedy = { $remedy ->
        [pose-uncertainty] sie angeben (--standard-uncertainty-um) oder Zielmarken vergleichen
        [contact-uncertainty] auch die Wiederholgenauigkeit der Antastung angeben (--standard-uncertainty-um) und Zielmarken vergleichen
        [compare-targets] `residuals = "targets"` verwenden
        [targets] Positionen seiner Zielmarken angeben: Zeilen der Art `point`
        [uncertainty] sie angeben (--standard-uncertainty-um)
        [own-uncertainties] Zielmarken vergleichen oder die Spalten der Unsicherheiten entfernen
        [row-uncertainty] sie in jeder Zeile angeben oder mit --standard-uncertainty-um
        [part] `frame` ist `flange` für einen Arm, `platform` für einen PreXYT, `targets` für jeden Roboter
        [positions] mehr Positionen wählen oder Parameter mit `--hold` festhalten
        [hold-fewer] weniger Parameter festhalten und mehr Posen messen
        [more-poses] mehr Posen messen (Wiederholungen einer Pose bringen nichts) oder Parameter mit `hold` in [identify] oder --hold festhalten
        [hold] Parameter in [identify] festhalten oder mehr Posen messen
        [unreachable] Einheit (Grad oder Radiant), Vorzeichen und Versatz der Gelenke und die Nennparameter prüfen
        [extent] `unit` der Exporte, die Einheiten der Gelenke im Protokoll und die Längen des Roboters prüfen
        [readings] diese Messwerte und die Reihenfolge der Zeilen des Protokolls prüfen oder diese Posen auslassen (`exclude`, --exclude)
        [assembly] die Spalte `assembly` dieser Posen berichtigen oder leer lassen: der Modus wird dann aus der Messung abgeleitet
       *[joints] Einheiten, Reihenfolge und Vorzeichen der Gelenke und die Nennparameter prüfen; `hold` in [identify] hält Parameter fest
    }

reading-off = { FIXED($off_mm, 4) } mm ({ $target }, Pose { $pose }, Zyklus { $cycle })
orientation-off = { FIXED($off_deg, 3) } deg Orientierung ({ $target }, Pose { $pose }, Zyklus { $cycle })
quantity-off = { FIXED($off_mm, 4) } mm { $quantity } ({ $target }, Pose { $pose }, Zyklus { $cycle })
deviation-of-lengths = { FIXED($deviation_mm, 4) } mm ({ $quantity })
deviation-of-angles = { FIXED($deviation_deg, 3) } deg (Orientierung)

largest-residuals = größte Residuen einer robusten Anpassung: { $readings }
    .hint = dort zuerst nach vertauschten Bezeichnungen und falschen Messwerten suchen; Abweichungen des Roboters verteilen sich auf alle Posen

outlier-readings = { $count ->
        [one] 1 von { $total } Messwerten ist ein Ausreißer
       *[other] { $count } von { $total } Messwerten sind Ausreißer
    } mit einem Residuum über dem { $times }-Fachen von { $scales }, der Standardabweichung der anderen in einer robusten Anpassung: { $readings }

outliers = { $outliers }

outliers-excluded = durch `outliers = "exclude"` ausgeschlossen: { $outliers }

repeated-position = { $target } an den Posen { $first } und { $second }

positions-repeat = gemessene Positionen stimmen bis zur letzten Ziffer überein, obwohl sich die Gelenke bewegen, { $count }-mal: { $pairs }
    .hint = der Export enthält einen Messwert einer anderen Pose: diese Posen neu messen oder ausschließen

repeated-joints = Posen { $first } und { $second }, { FIXED($apart_mm, 3) } mm auseinander

joint-values-repeat = Gelenkwerte stimmen bis zur letzten Ziffer überein, obwohl sich die Zielmarken bewegen, { $count }-mal: { $pairs }
    .hint = das Protokoll enthält Werte einer anderen Pose: diese Posen neu aufzeichnen oder ausschließen

repeats-scatter = die Wiederholungen von `{ $label }` weichen bis zu { FIXED($off_mm, 4) } mm von ihrem Median ab; Standardunsicherheit des Messgeräts { FIXED($u_mm, 4) } mm
    .hint = `unit` des Exports und die Unsicherheit des Messgeräts prüfen und ob sich der Punkt bewegt hat

repeat-off = { $away } von { $count } Wiederholungen von `{ $label }` { $away ->
        [one] weicht um
       *[other] weichen um bis zu
    } { FIXED($off_mm, 4) } mm von ihrem Median ab; Standardunsicherheit des Messgeräts { FIXED($u_mm, 4) } mm
    .hint = den falschen Messwert aus dem Export entfernen oder den Punkt neu messen: alle Ergebnisse hängen davon ab

uncertainty-zero-rounded = `{ $column }` ist in { $count ->
        [one] 1 Zeile
       *[other] { $count } Zeilen
    } 0: gerundeter Wert, ersetzt durch die Auflösung der Spalte, u = { $u } { $unit } (halbe letzte Stelle geteilt durch √3)
    .hint = Unsicherheiten mit mehr Nachkommastellen exportieren

uncertainty-zero = `{ $column }` ist in { $count ->
        [one] 1 Zeile
       *[other] { $count } Zeilen
    } 0, und die Spalte zeigt keine Auflösung: für diese Zeilen gilt die Unsicherheit des Messgeräts
    .hint = Unsicherheiten mit mehr Nachkommastellen exportieren

key-of-text-table = `{ $key }` hat für ein Blatt einer Arbeitsmappe oder ein Topic einer Aufzeichnung keine Bedeutung
    .hint = `{ $key }` entfernen: der Schlüssel gilt nur für Text mit Trennzeichen

measurements-undescribed = an den { $set ->
        [validation] Validierungsposen
       *[calibration] Kalibrierposen
    } betragen die Abweichungen { FIXED($after_mm, 3) } mm (quadratischer Mittelwert), die Positionen erstrecken sich über { FIXED($spread_mm, 1) } mm; { $count } von { $total } Abweichungen übersteigen { FIXED($limit_mm, 1) } mm: das Modell beschreibt diese Messungen nicht

undescribed-targets = alle Messwerte von { $targets } und keine anderen haben große Abweichungen: die Bezeichnungen der Zielmarke prüfen und ob sie bewegt wurde

undescribed-rows-shifted = von Pose { $first } bis Pose { $last } passen die Positionen zu den Gelenkwerten der { $neighbour ->
        [previous] vorigen
       *[next] nächsten
    } Pose: prüfen, ob das Protokoll dort eine Zeile zu viel oder zu wenig hat

undescribed-readings = { $readings }: { $remedy }

undescribed-set-up = Einheiten, Reihenfolge und Vorzeichen der Gelenke, die Nennparameter und die Verknüpfung von Protokoll und Punkten prüfen

undescribed-frame-moved = mit einer einzigen Verschiebung des Koordinatensystems um { FIXED($motion_mm, 1) } mm ist das Residuum { FIXED($left_mm, 3) } mm: Basis oder Messsystem hat sich zwischen Kalibrier- und Validierungsposen bewegt

undescribed-unchecked = die Kalibrierposen lassen keine Koordinate zur Kontrolle übrig: andere Lagen von Basis und Zielmarken passen ebenso gut; mehr Kalibrierposen messen, über den Arbeitsraum verteilt

undescribed-other-poses = das Modell passt zu den Kalibrierposen, und keine Verschiebung des Koordinatensystems erklärt die anderen: prüfen, ob Protokoll und Exporte der Validierungsposen zu denselben Posen gehören (Protokoll einer anderen Kampagne oder anders nummerierte Posen)

prior-of-nominal = Nennparameter haben keine Kovarianz für `--frames prior`
    .hint = identifizierte Parameter mit `--parameters` angeben oder `--frames refit` verwenden

prior-of-conditions = `--frames prior` gilt nur für gemessene Positionen
    .hint = Zeilen anderer Art weglassen oder Basis und Zielmarken neu anpassen: `--frames refit`

place-without-nominal = `{ $parameter }` hat keinen Nennwert: der Wert wird aus Messungen bestimmt
    .hint = Basis und Zielmarken an die Kalibrierposen anpassen: `--frames refit`

given-parameters-worse = die Abweichungen betragen { FIXED($given_mm, 3) } mm mit den gegebenen Parametern, { FIXED($nominal_mm, 3) } mm mit den Nennparametern (quadratischer Mittelwert)
    .hint = prüfen, ob die Parameter zu diesem Roboter und ob Basis und Zielmarken zu dieser Kampagne gehören (`--frames`)

candidate-poses-too-few = { $wanted } Posen können nicht aus { $count } Kandidaten ausgewählt werden
    .hint = weniger `--positions` oder mehr Kandidaten angeben

target-names-exchanged = werden die Namen der Zielmarken `{ $first }` und `{ $second }` vertauscht, sinken die Residuen von { FIXED($before_mm, 3) } auf { FIXED($left_mm, 3) } mm
    .hint = die beiden Namen im Export vertauschen

one-pose-contradicts = ohne Pose `{ $pose }` widersprechen die Beobachtungen den Parametern nicht
    .hint = diese Pose neu messen und ihre Gelenkwerte neu aufzeichnen

one-reading-contradicts = ohne Zielmarke `{ $target }` an Pose `{ $pose }` widersprechen die Beobachtungen den Parametern nicht
    .hint = diese Zielmarke an dieser Pose neu messen

target-names-permuted = mit den Namen der Zielmarken { $names } sinken die Residuen von { FIXED($before_mm, 3) } auf { FIXED($left_mm, 3) } mm
    .hint = die Namen im Export berichtigen

motions-alike = { $count ->
        [one] 1 andere Bewegung erklärt
       *[other] { $count } andere Bewegungen erklären
    } diese Residuen ebenfalls: { $motions }
    .hint = Posen beobachten, die sich in den Gelenkwerten stärker unterscheiden

target-far-from-given = die Zielmarke `{ $target }` wurde bei ({ FIXED($x_mm, 1) }, { FIXED($y_mm, 1) }, { FIXED($z_mm, 1) }) mm identifiziert, { FIXED($distance_mm, 1) } mm neben ihrer angegebenen Position ({ FIXED($sx_mm, 1) }, { FIXED($sy_mm, 1) }, { FIXED($sz_mm, 1) }) mm
    .hint = Werkzeugglied oder Flansch des Roboters, die angegebene Position und den Nullpunkt der letzten Achse prüfen

no-coordinates-to-check = { $count ->
        [one] 1 Koordinate der Kalibrierposen bestimmt
       *[other] { $count } Koordinaten der Kalibrierposen bestimmen
    } { $parameters } Parameter: für die Prüfung bleibt keine Koordinate übrig
    .hint = mehr Posen messen, über den Arbeitsraum verteilt

validation-outliers = { $count } von { $total } Validierungsabweichungen überschreiten { FIXED($limit_mm, 4) } mm, das { $times }-Fache ihres Medians: { $readings }

common-scale = { $parameters } sind alle etwa das { FIXED($factor, 5) }-Fache des Nennwerts: eine Maßstabsabweichung des Messsystems oder der Gelenke ist wahrscheinlicher als Abweichungen von { $count } Teilen
    .hint = Maßstab, Temperaturkompensation und Einheit des Messsystems und der Geber prüfen

compliance-negative = `{ $parameter }` ist negativ ({ FIXED($value, 5) } { $unit }): das Gelenk biegt sich entgegen der Schwerkraft
    .hint = `gravity` und die Richtung der Gelenkachse in robot.toml prüfen

load-columns-slip = die angegebenen Schwerpunkte widersprechen den Messungen ({ FIXED($over_u, 1) } Standardunsicherheiten); { $count ->
        [one] eine Änderung erklärt sie: { $changes }
       *[other] jede dieser Änderungen erklärt sie: { $changes }
    }
    .hint = die Spalten der Last mit ihrem Datenblatt vergleichen: Achsen des Flansches, Vorzeichen, Einheit

load-change-exchanged = `{ $first }` und `{ $second }` sind vertauscht

load-change-sign = `{ $column }` hat das andere Vorzeichen

load-change-unit = der Schwerpunkt ist in { $unit }

backlash-negative = `{ $parameter }` ist negativ ({ FIXED($value, 5) } { $unit }): das Gelenk würde seinem Antrieb vorauseilen
    .hint = das Vorzeichen der Anfahrrichtungen prüfen (+1 bei steigendem Gelenkwert, -1 bei fallendem), und ob die Zeiten des Protokolls zu derselben Bewegung gehören

torque-constant = das Drehmoment des Gelenks `{ $joint }` ist in allen Kalibriermesswerten { FIXED($value, 3) } N·m (`{ $column }`): seine Wirkung ist vom Nullpunkt des Gelenks nicht zu unterscheiden, und die Nachgiebigkeit dieses Gelenks wird festgehalten

torque-signs-differ = die identifizierte Biegung unter den Drehmomenten ist positiv für { $positive } und negativ für { $negative }: einige Gelenke geben im Drehsinn des angegebenen Drehmoments nach, andere im Gegensinn
    .hint = Vorzeichen und Reihenfolge der Spalten der Drehmomente prüfen

torques-exchanged = das Modell beschreibt die Messwerte mit vertauschten Spalten `{ $first }` und `{ $second }`, aber nicht wie angegeben
    .hint = prüfen, zu welchem Gelenk jede Spalte der Drehmomente gehört

temperature-constant = die Temperatur ist in allen Kalibriermesswerten { FIXED($value, 1) } °C: Ausdehnung und Drift sind nicht bestimmbar und werden festgehalten; Längen und Nullpunkte gelten bei dieser Temperatur

temperature-questioned = die Temperaturen der Kalibriermesswerte sind { FIXED($low, 1) } bis { FIXED($high, 1) } °C, außerhalb von { $least } bis { $most } °C

load-questioned = Traglasten bis { $high_kg } kg sind zu schwer für einen Arm, der { FIXED($reach_m, 2) } m weit reicht
    .hint = die Einheit der Spalte `load_kg` prüfen: als Gramm gelesen sind es { $in_grams_kg } kg

temperature-units = die Einheit prüfen: als °F gelesen sind es { FIXED($from_fahrenheit, 1) } bis { FIXED($to_fahrenheit, 1) } °C, als K gelesen { FIXED($from_kelvin, 1) } bis { FIXED($to_kelvin, 1) } °C

ball-names-exchanged = `{ $parameter }`, der Abstand von K und L, ist { FIXED($value, 3) } { $unit }: K und L sind vertauscht
    .hint = die Namen der beiden Zielmarken in den Bezeichnungen des Exports vertauschen

identified-worse-than-nominal = an den { $set ->
        [validation] Validierungsposen
       *[calibration] Kalibrierposen
    } ist der identifizierte Roboter schlechter als der nominale Roboter: { FIXED($before_mm, 4) } mm vorher, { FIXED($after_mm, 4) } mm nachher (quadratischer Mittelwert)
    .hint = mehr Posen messen, über den Arbeitsraum verteilt, oder die Parameter festhalten, die diese Posen nicht bestimmen

value-beyond-tolerance = `{ $parameter }` = { $unit ->
        [mm] { FIXED($value, 3) } { $unit } (Nennwert { $nominal } { $unit }, Toleranz { FIXED($tolerance, 3) } { $unit })
        [deg] { FIXED($value, 3) } { $unit } (Nennwert { $nominal } { $unit }, Toleranz { FIXED($tolerance, 3) } { $unit })
       *[other] { FIXED($value, 4) } (Nennwert { $nominal }, Toleranz { FIXED($tolerance, 3) })
    }

tolerance-exceeded = { $count ->
        [one] 1 Parameter liegt
       *[other] { $count } Parameter liegen
    } außerhalb der Toleranz des Roboters: { $parameters }
    .hint = Vorzeichen, Einheiten und Reihenfolge der Gelenke, die Nennwerte und die Koordinatensysteme prüfen; gilt nach der Zeichnung eine andere Toleranz, `tolerance` in der Roboterdatei angeben

format-not-identified = die Parameter des Formats `{ $format }` konnten nicht neu identifiziert werden: { $message }

clock-rate-from-standstills = die Uhr der Messung hat gegenüber der Uhr des Protokolls `{ $log }` einen Gangunterschied von { FIXED($rate_ppm, 1) } ppm ± { FIXED($u_ppm, 1) } ppm (k = 1) (möglich: { FIXED($low_ppm, 1) } bis { FIXED($high_ppm, 1) } ppm); Versatz { FIXED($offset_s, 3) } s ± { FIXED($u_s, 3) } s (k = 1) bei { FIXED($reference_s, 3) } s des Protokolls
    .hint = mit diesem Versatz und diesem Gangunterschied fällt jeder Messpunkt in einen Stillstand; der Versatz allein reicht nicht aus

clock-rate-insignificant = die Stillstände des Protokolls `{ $log }` zeigen keinen signifikanten Gangunterschied der Uhren: er liegt zwischen { FIXED($low_ppm, 1) } und { FIXED($high_ppm, 1) } ppm
    .hint = `clock_rate` weglassen: der Versatz allein wird verwendet

clock-from-motion = die Uhr des Protokolls `{ $log }` ist durch die Geschwindigkeiten der Bewegung bestimmt (Korrelation { FIXED($correlation, 3) }): Versatz { FIXED($offset_s, 4) } s ± { FIXED($u_s, 4) } s (k = 1) bei { FIXED($reference_s, 3) } s des Protokolls, Gang { FIXED($rate_ppm, 1) } ppm ± { FIXED($u_ppm, 1) } ppm (k = 1)
    .hint = die Punkte sind mit den Zeilen des Protokolls zu diesen Zeiten verknüpft

clock-motion-unlike = die Geschwindigkeiten der Punkte und des Protokolls korrelieren bei keinem Versatz der Uhren: höchstens { FIXED($correlation, 2) }
    .hint = prüfen, ob Protokoll und Punkte zur selben Bewegung gehören; für nur im Stillstand gemessene Punkte `clock_offset_s = "standstills"` oder eine Zahl angeben

clock-motion-several = die Geschwindigkeiten der Punkte und des Protokolls korrelieren bei { $count } Versätzen der Uhren: { $ranges }
    .hint = eine Bewegung aufzeichnen, die sich nicht wiederholt, oder `clock_offset_s` als Zahl angeben

clock-motion-short = { $count ->
        [one] 1 gemessene Geschwindigkeit ist
       *[other] { $count } gemessene Geschwindigkeiten sind
    } zu wenige, um die Uhren anhand der Bewegung zu vergleichen
    .expected = mindestens 20 Geschwindigkeiten, in den Punkten und im Protokoll

clock-rate-none = kein Versatz der Uhren, auch nicht mit einem Gangunterschied bis ± { $most_ppm } ppm, legt alle Messpunkte in Stillstände des Protokolls
    .hint = prüfen, ob das Protokoll zu dieser Messung gehört, und in Bewegung gemessene Punkte entfernen; oder `clock_offset_s` als Zahl angeben
limit-not-assessable = der Grenzwert `{ $limit }` ist nicht beurteilbar: seine Größe ist an den entscheidenden Posen nicht gemessen
    .hint = die Größe an diesen Posen messen oder den Grenzwert aus [limits] entfernen
sweep-joint-unknown = `{ $joint }` ist kein Gelenk dieser Messreihen
    .expected = { $known }

sweep-order-missing = die Reihenfolge der Gelenke { $joints } von der Basis aus ist unbekannt
    .hint = sie angeben: --joints NAME,...

sweep-joint-column-twice = zwei Spalten haben Werte des Gelenks `{ $joint }`
    .hint = eine davon entfernen

sweep-values-partial = die Gelenkwerte sind unvollständig
    .expected = Werte aller Gelenke in jeder Zeile oder in keiner Zeile einer Messreihe
    .hint = eine Zeile ohne bewegtes Gelenk ist eine Kontrollpose und braucht die Werte aller Gelenke

sweep-sign-by-values = die Gelenkwerte bestimmen bereits die Richtung jeder Messreihe
    .hint = --backwards weglassen

sweep-other-joint = in der Messreihe von `{ $joint }` bewegt sich `{ $moved }`, `{ $joint }` ruht
    .hint = die Spalte `joint` oder die Überschriften der Gelenkwerte berichtigen

sweep-two-joints = in der Messreihe von `{ $joint }` bewegt sich auch `{ $also }`, um { $by }
    .hint = die Messreihe wiederholen, während alle anderen Gelenke ruhen

sweep-by-angle = { FIXED($by, 3) } deg

sweep-by-length = { FIXED($by, 3) } mm

sweep-ratio = die Zielmarken bewegen sich um { FIXED($ratio, 5) } × die Werte von `{ $joint }` (u = { SCIENTIFIC($u, 1) })
    .hint = { $unit ->
            [deg-as-rad] die Werte sind Grad und werden als Radiant gelesen: die Überschrift berichtigen
            [rad-as-deg] die Werte sind Radiant und werden als Grad gelesen: die Überschrift berichtigen
            [inch-as-mm] die Werte sind Zoll und werden als Millimeter gelesen
            [m-as-mm] die Werte sind Meter und werden als Millimeter gelesen: die Überschrift berichtigen
            [mm-as-m] die Werte sind Millimeter und werden als Meter gelesen: die Überschrift berichtigen
           *[none] die Einheit der Spalte berichtigen oder den Gelenkwert aus dem Motorwert berechnen
        }

sweep-target-moved = Zielmarke `{ $target }` hat sich in der Messreihe von `{ $joint }` vor Zeile { $row } bewegt: Abweichung von einer Bahn { FIXED($before_um, 1) } µm, von zwei Bahnen { FIXED($after_um, 1) } µm
    .hint = die Messreihe wiederholen oder die Zielmarke ab dieser Zeile anders nennen

sweep-many-outliers = { $aside } von { $readings } Messwerten der Messreihe von `{ $joint }` liegen nicht auf der Bahn der anderen
    .hint = nach einem zweiten bewegten Gelenk oder nach Zeilen einer anderen Messreihe suchen

sweep-outliers = { $count ->
        [one] 1 Messwert der Messreihe von `{ $joint }` ist ausgeschlossen: Zeile { $lines }
       *[other] { $count } Messwerte der Messreihe von `{ $joint }` sind ausgeschlossen: Zeilen { $lines }
    }
    .hint = diese Zeilen prüfen: die Messwerte liegen weit von der Bahn aller anderen

sweep-smooth = in der Messreihe von `{ $joint }` weichen die Zielmarken stetig um { FIXED($rms_um, 1) } µm (RMS) von ihrer Bahn ab; von Messwert zu Messwert beträgt das Rauschen { FIXED($noise_um, 1) } µm; die Unsicherheit der Achse enthält beides
    .hint = prüfen, ob alle anderen Gelenke ruhten, und mit dem Schlag des Lagers vergleichen

sweep-weak = die Richtung der Achse von `{ $joint }` hat eine Standardunsicherheit von { FIXED($u_mrad, 2) } mrad
    .hint = einen längeren Bogen, eine Zielmarke weiter von der Achse oder mehr Zielmarken messen

sweep-unit = alle Zielmarken liegen innerhalb von { FIXED($radius_mm, 3) } mm um die Achsen: die Koordinaten sind wahrscheinlich in Metern
    .hint = die Einheit prüfen und die Spalten umrechnen, hier x: --column 'x_mm={ $source }*1000'

sweep-few = die Messreihe von `{ $joint }` hat { $readings } Messwerte und braucht { $needed }
    .hint = mehr Messwerte aufnehmen; überzählige Messwerte bestimmen die Unsicherheit

sweep-undetermined = die Messwerte der Messreihe von `{ $joint }` bestimmen keine Achse
    .hint = einen längeren Bogen oder eine Zielmarke weiter von der Achse messen; ein Schubgelenk wird mit --prismatic angegeben

sweep-joint-missing = { $count ->
        [one] Gelenk { $joints } hat keine Messreihe
       *[other] Gelenke { $joints } haben keine Messreihe
    }: robot.toml wird nicht geschrieben
    .hint = von jedem Gelenk eine Messreihe aufnehmen

sweep-starts-apart = die Messreihen von `{ $first }` und `{ $second }` beginnen an Zielmarke `{ $target }` { FIXED($gap_mm, 3) } mm auseinander: robot.toml wird nicht geschrieben
    .hint = jede Messreihe in derselben Pose mit der Zielmarke an ihrem Platz beginnen oder Spalten der Gelenkwerte ergänzen

sweep-target-unswept = eine Zielmarke der Kontrollposen kommt in keiner Messreihe vor: robot.toml wird nicht geschrieben
    .hint = an Kontrollposen Zielmarken der Messreihen verwenden

sweeps-exchanged = `{ $first }` und `{ $second }` sind vertauscht: die Positionen weichen mit den angegebenen Gelenken um { FIXED($stated_mm, 3) } mm (RMS) ab, mit vertauschten Gelenken um { FIXED($left_mm, 3) } mm
    .hint = ihre Namen in der Spalte `joint` und in den Überschriften vertauschen

sweep-reversed = `{ $joint }` wurde in negativer Richtung bewegt: die Kontrollposen weichen mit der angegebenen Richtung um { FIXED($stated_mm, 3) } mm (RMS) ab, mit der umgekehrten um { FIXED($left_mm, 3) } mm
    .hint = die Richtung angeben: --backwards { $joint }

sweeps-disagree = { $what ->
        [checks] Kontrollposen weichen vom Roboter um bis zu { FIXED($distance_mm, 3) } mm ab
       *[sweeps] die Messreihen widersprechen einander um bis zu { FIXED($distance_mm, 3) } mm
    } (Standardunsicherheit { FIXED($u_mm, 4) } mm)
    .hint = den Sitz der Zielmarken und die Gelenkwerte prüfen; `etalon identify` und `etalon run` können von diesem Roboter ausgehen

table-base-not-held = die Tabelle hat ihre eigene Basis, gedreht um { FIXED($angle_deg, 4) } deg und verschoben um { FIXED($shift_mm, 4) } mm
    .hint = die Basis identifizieren oder `poe` verwenden

table-flange-not-held = die Tabelle hat ihren eigenen Flansch, gedreht um { FIXED($angle_deg, 4) } deg und verschoben um { FIXED($shift_mm, 4) } mm
    .hint = die Zielmarken identifizieren oder `poe` verwenden

table-tilt-not-held = die Tabelle behandelt { $joint ->
        [none] zwei Achsen
       *[other] die Achsen am Glied von `{ $joint }`
    } als parallel: den Winkel von { FIXED($angle_mrad, 4) } mrad zwischen ihnen enthält sie nicht
    .hint = `etalon identify` bestimmt beta; `poe` enthält den Winkel
row-excluded = ausgeschlossen: { $reason }
row-at-origin = nicht gemessen: 0 0 0
row-of-station-unused = Station `{ $station }`: der Roboter hat keine Zielmarke dieses Namens
row-of-several = { $rows } Zeilen des Protokolls `{ $log }` liegen innerhalb von { $tolerance_s } s: die nächste Zeile wird verwendet
no-rows-around = dem Protokoll `{ $log }` fehlt innerhalb von { $tolerance_s } s eine Zeile vor oder nach diesem Punkt
no-row-near = keine Zeile des Protokolls `{ $log }` liegt innerhalb von { $tolerance_s } s
no-point-nearest = jedem Messpunkt liegt eine andere Zeile näher
no-row-of-key = keine Zeile des Protokolls `{ $log }` hat diesen Schlüssel
no-point-of-key = kein Messpunkt hat diesen Schlüssel
label-names-nothing = seine Bezeichnung nennt keine Zielmarke und keinen Punkt eines Geometrieelements oder Koordinatensystems
no-row-touches = keine Zeile des Protokolls `{ $log }` berührt den Punkt
row-of-unframed-pose = die Pose der Zeile hat kein Weltkoordinatensystem

table-of-observations = Beobachtungen
table-of-attained-poses = Istposen
table-of-commanded-poses = Sollposen
table-of-reference-targets = Referenzmarken
table-of-commanded-path = Sollbahn
table-of-compliance = statische Nachgiebigkeit
recorded-motion-file = aufgezeichnete Bewegung
read-in-unit = { $format }, Einheit { $unit }
read-in-frame = { $read }, bezogen auf `{ $frame }`
read-without-columns = { $read }, { $unread } von { $all } Spalten nicht gelesen
read-except-columns = { $read }, nicht gelesen: { $columns }

side-stated = wie vom Benutzer angegeben
side-from-values = aus { $of ->
        [normal] der Normalen
        [location] der Lage
       *[diameter] dem Durchmesser
    } ({ $values ->
        [nominal] Nennwerte
       *[stated] angegebene Werte
    })
side-from-key = aus `InternalExternal`: { $value }
label-orientations-unused = die Orientierungen des Exports werden nicht verwendet: Protokoll `{ $log }` nennt `{ $label }` in { $count } Zeilen
    .hint = nach Pose, Zeile oder Zeitpunkt verknüpfen, wenn das Messgerät an jeder Pose den Körper am Roboter gemessen hat

temperature-elsewhere = `temperature_c` = { $stated_c }; die Zeilen der Exporte nennen { FIXED($lowest_c, 1) } °C bis { FIXED($highest_c, 1) } °C
    .hint = `temperature_c` oder die Einheit der Spalte (Grad Celsius) berichtigen

load-elsewhere = `load_kg` = { $stated_kg }; die Messwerte nennen Lasten von { $lowest_kg } kg bis { $highest_kg } kg
    .hint = `load_kg` aus [conditions] entfernen oder die Lasten der Messwerte berichtigen

temperature-varies = die Zeilen der Exporte nennen { FIXED($lowest_c, 1) } °C bis { FIXED($highest_c, 1) } °C, mehr als ±{ $expanded_c } °C; die Messunsicherheit der Längen ist zu klein
    .hint = für `expanded_temperature_uncertainty_c` einen Wert angeben, der den Bereich abdeckt

axes-comment-method = Achsen aus Messreihen mit je einem bewegten Gelenk (etalon axes); ohne nominales Modell

axes-comment-base = Basis aus den Achsen 1 und 2, Regel `{ $rule }`: z längs Achse 1

axes-comment-joint = q{ $number } ist { $name }

axes-comment-zero = die Gelenkwerte sind zu Beginn der Messreihen null

axes-comment-target = Zielmarke { $name } am Flansch (mm): { FIXED($x, 4) } { FIXED($y, 4) } { FIXED($z, 4) }
axes-comment-tolerance = die Messreihen bestimmen diese Parameter: die Toleranzen sind Halbbreiten von Rechteckverteilungen

axes-robot-name = Roboter nach seinen Achsen

cell-few = `{ $solve }` braucht { $needed } Messwerte; vorhanden sind { $readings }
    .hint = mehr Messwerte aufnehmen; überzählige Messwerte bestimmen die Unsicherheit

cell-axis-at-rest = die Achse bewegt sich nicht: alle Messwerte jeder Zielmarke ({ $readings } insgesamt) gehören zu einem Wert der Achse
    .hint = die Zielmarken bei mehreren Werten der Achse messen

cell-same-orientation = der Roboter hat in allen Zeilen dieselbe Orientierung
    .hint = den Roboter zwischen den Messwerten um mindestens zwei Achsen drehen

cell-one-axis = alle Orientierungen unterscheiden sich durch Drehungen um eine Achse, [{ $direction }] im Flansch: die Lage entlang dieser Achse ist nicht bestimmt
    .hint = Messwerte mit Drehungen um eine andere Achse hinzufügen

cell-points-coincide = alle Punkte fallen zusammen
    .hint = Punkte mit Abstand messen; bei Orientierungen um einen festen Punkt `--solve tool-point` verwenden

cell-points-collinear = alle Punkte liegen auf einer Geraden in Richtung [{ $direction }]: die Drehung um diese Gerade ist nicht bestimmt
    .hint = einen Punkt neben der Geraden messen

cell-ambiguous = zwei verschiedene Koordinatensysteme passen gleich gut zu den Messwerten
    .hint = Messwerte mit anderen Orientierungen hinzufügen

cell-undetermined = die Messwerte bestimmen nicht alle unbekannten Größen
    .hint = Messwerte in anderen Posen oder bei anderen Achswerten hinzufügen

cell-orientation-missing = die Posen haben keine Spalten einer Orientierung
    .expected = { $prefix }qw, { $prefix }qx, { $prefix }qy, { $prefix }qz oder { $prefix }rx_deg .. eines Rotationsvektors oder { $prefix }a_deg .. von drei Winkeln oder { $prefix }r11 .. { $prefix }r33
    .hint = die Spalten nennen, mit `--column { $prefix }qw=KOPF` bei anderen Spaltenköpfen

cell-order-missing = die Reihenfolge der Winkel { $prefix }a, { $prefix }b, { $prefix }c ist nicht angegeben
    .hint = sie nach dem Handbuch angeben: `{ $option } zyx` für A B C von KUKA, `{ $option } "fixed xyz"` für W P R von FANUC

cell-mounting-missing = der Teil des Messsystems am Roboter ist nicht angegeben
    .hint = `--mounting target` (das Messgerät steht fest) oder `--mounting sensor` (das Messgerät ist am Roboter) angeben

cell-uncertainty-not-positive = eine Standardunsicherheit fehlt oder ist nicht positiv

cell-point-unknown = `{ $name }` ist kein Punkt dieser Aufgabe
    .expected = { $known }

cell-roles-mixed = Punkte zweier Regeln sind gemischt
    .expected = origin, x, xy; oder x1, x2, y1

cell-axis-missing = der Tabelle fehlen die Werte der Achse
    .hint = die Spalte nennen: `--column { $column }=KOPF`

cell-no-controller-data = `{ $maker }` hat keine Daten für das Ergebnis von `{ $solve }`
    .hint = die Zahlen dem Text oder `--json` entnehmen oder ein anderes Format wählen

cell-second-axis-missing = `{ $maker }` braucht zwei Drehachsen: eine längs { $axis } der Maschine, eine längs z
    .hint = das Ergebnis der anderen Achse mit `--with DATEI` angeben (JSON von `etalon cell --solve rotary-axis`)

cell-axis-direction = eine Drehachse liegt { FIXED($angle_deg, 2) } deg neben der Achse { $axis } der Maschine, um die `{ $maker }` dreht
    .hint = in den Koordinaten der Maschine messen oder die Kinematik der Maschine wählen

cell-axis-sense = { $sense ->
        [opposite] die Achse längs { $axis } und die Achse längs z drehen in entgegengesetztem Sinn; `{ $maker }` hat einen Sinn für beide
        [positive] die Achse dreht um positives { $axis }; `{ $maker }` dreht um negatives { $axis }
       *[negative] die Achsen drehen um negatives { $axis } und z; `{ $maker }` dreht um positive
    }
    .hint = das Vorzeichen der Achse in ihrer Konfiguration umkehren und erneut messen

cell-tool-length-missing = `{ $maker }` braucht die Länge des Werkzeugs, an dessen Ende die erste Zielmarke ist
    .hint = `--tool-length-mm` angeben, 0 für eine Zielmarke an der Bezugsebene der Spindel

cell-pivot-above = das Werkzeug ({ FIXED($tool_mm, 3) } mm) ist länger als der Abstand von der Achse zur ersten Zielmarke darunter ({ FIXED($along_mm, 3) } mm, Achse bei null)
    .hint = prüfen, ob die Länge des Werkzeugs stimmt und ob z der Maschine die Spindel hinauf zeigt

cell-machine-number = `MACHINE_DEF[{ $number }]` definiert keine externe Kinematik
    .expected = 2 bis 7
    .hint = `--number` angeben

cell-loads-replaced = der Eintrag von Werkzeug { $number } hat Masse und Schwerpunkt null: Lastdaten sind nicht identifiziert
    .hint = die Zeile des Koordinatensystems in die eigene Datei kopieren oder die Zeilen der Last ergänzen

cell-axis-tilted = die Achse längs { $axis } ist um { FIXED($angle_deg, 4) } deg geneigt, und `{ $maker }` kennt keine Neigung: { FIXED($left_um, 1) } µm in 100 mm Abstand von der Achse
    .hint = die Achse ausrichten oder diese Abweichung hinnehmen

cell-slip = die Messwerte widersprechen einander um { FIXED($stated_mm, 3) } mm (Standardabweichung); { $count ->
        [one] mit einer Änderung bleiben { FIXED($left_mm, 4) } mm: { $changes }
       *[other] mit jeder dieser Änderungen bleiben { FIXED($left_mm, 4) } mm oder wenig mehr: { $changes }
    }
    .hint = die Tabelle oder die Optionen berichtigen

cell-outlier = der Messwert in Zeile { $line } passt nicht zu den anderen: Residuum { FIXED($residual_mm, 4) } mm
    .hint = den Messwert prüfen und mit `--without` weglassen, wenn er falsch ist

cell-outlier-turned = die Orientierung in Zeile { $line } passt nicht zu den anderen: Residuum { FIXED($residual_deg, 4) } deg
    .hint = den Messwert prüfen und mit `--without` weglassen, wenn er falsch ist

cell-noise-larger = die Residuen der Positionen betragen { FIXED($found_um, 1) } µm (Standardabweichung), mehr als die angegebene Unsicherheit erklärt; die Unsicherheiten folgen aus den Residuen
    .hint = die Unsicherheit von Roboter und Messung zusammen angeben

cell-noise-larger-turned = die Residuen der Orientierungen betragen { FIXED($found_deg, 4) } deg (Standardabweichung), mehr als die angegebene Unsicherheit erklärt; die Unsicherheiten folgen aus den Residuen
    .hint = die Unsicherheit von Roboter und Messung zusammen angeben

cell-no-uncertainty = die Unsicherheit ist unbekannt: die Messwerte haben keine Redundanz, und keine Unsicherheit ist angegeben
    .hint = mehr Messwerte aufnehmen oder `--standard-uncertainty-um` angeben

cell-columns-unused = { $count ->
        [one] die angegebene Spalte { $columns } wird
       *[other] die angegebenen Spalten { $columns } werden
    } von `{ $solve }` nicht verwendet
    .hint = `etalon cell --help` nennt die Spalten jeder Aufgabe

cell-refuted = die Residuen der Positionen betragen { FIXED($found_mm, 3) } mm (Standardabweichung), mehr als jede plausible Unsicherheit erklärt: das Ergebnis ist widerlegt
    .hint = Spalten, Vorzeichen, Einheiten und die Reihenfolge der Zeilen prüfen

cell-refuted-turned = die Residuen der Orientierungen betragen { FIXED($found_deg, 2) } deg (Standardabweichung), mehr als jede plausible Unsicherheit erklärt: das Ergebnis ist widerlegt
    .hint = Spalten, Vorzeichen, Einheiten und die Reihenfolge der Zeilen prüfen

cell-data-withheld = Daten für { $maker } werden nicht geschrieben: das Ergebnis darf nicht geladen werden
    .hint = die Ursachen der gemeldeten Fehler beheben; `--force` schreibt die Daten trotzdem

cell-unit-large = der Flansch ist { FIXED($distance_m, 1) } m von der Basis entfernt, und das Werkzeug ist { FIXED($tool_m, 1) } m lang: die Positionen sind wahrscheinlich in Millimetern
    .hint = `flange_x_mm`, `flange_y_mm`, `flange_z_mm` für Millimeter verwenden

cell-unit = alle Positionen des Flansches liegen innerhalb von { FIXED($distance_mm, 3) } mm um die Basis, und das Werkzeug ist kürzer als 2 mm: die Positionen sind wahrscheinlich in Metern
    .hint = `flange_x_m`, `flange_y_m`, `flange_z_m` für Meter verwenden

cell-tool-active = der Werkzeugmittelpunkt liegt { FIXED($distance_mm, 4) } mm vom Ursprung der Posen (u = { FIXED($u_mm, 4) } mm): die Posen gehören wahrscheinlich zum Werkzeug, nicht zum Flansch
    .hint = Posen mit Werkzeug 0 exportieren

cell-scale = die Achse bewegt sich um { FIXED($scale, 5) } × ihre Werte (u = { SCIENTIFIC($u, 1) })
    .hint = die Einheit der Spalte und die Übersetzung der Achse prüfen

cell-change-orientations = { $what }, bei den Orientierungen { $side ->
        [flange] des Flansches
       *[measured] der gemessenen Posen
    }

cell-change-inverse = die Posen { $side ->
        [flange] des Flansches
       *[measured] der Messung
    } sind invers

cell-change-unit = die Positionen { $side ->
        [flange] des Flansches
       *[measured] der gemessenen Punkte
    } sind in { $unit }

cell-change-axes = { $first } und { $second } der Positionen { $side ->
        [flange] des Flansches
       *[measured] der gemessenen Posen
    } sind vertauscht

cell-change-sign = { $axis } der Positionen { $side ->
        [flange] des Flansches
       *[measured] der gemessenen Posen
    } hat das andere Vorzeichen

cell-change-measured-mirrored = zwei Koordinaten der gemessenen Punkte sind vertauscht, oder eine hat das andere Vorzeichen

cell-change-scale = die gemessenen Punkte sind mit { $factor } multipliziert

cell-change-mirrored = die bekannten Punkte sind gespiegelt (zwei Koordinaten sind vertauscht, oder eine hat das andere Vorzeichen)

cell-change-exchanged = die Punkte der Zeilen { $first } und { $second } sind vertauscht

field-refused = kein Residuenfeld: { $reason }

tilt-of-base-or-joint = { $stated ->
        [pedestal] die Kippung der Basis (`pedestal`) kann die Kippung von Gelenk `{ $joint }` quer zu seiner Achse (`lateral`) sein
       *[lateral] die Kippung von Gelenk `{ $joint }` quer zu seiner Achse (`lateral`) kann die Kippung der Basis (`pedestal`) sein
    }: Chi-Quadrat ist { FIXED($chi_square, 1) } mit der ersten und { FIXED($of_other, 1) } mit der zweiten
    .hint = die Parameter als Kippung von Basis und erstem Gelenk zusammen verstehen

field-follows-order = das Residuenfeld hängt von `{ $joint }` ab, dessen Werte der Reihenfolge der Posen folgen (Rangkorrelation { FIXED($correlation, 2) }): eine Drift des Aufbaus sähe gleich aus
    .hint = das Feld mit `etalon validate --field` an Posen in anderer Reihenfolge beurteilen

poses-beyond-field = { $count } von { $total } Posen liegen außerhalb des Residuenfelds, wo es abklingt
    .hint = Kalibrierposen in diesem Bereich messen

field-parameters-wrong = die Identifikation meldet einen Fehler, den ein Feld verdecken würde

uncertainty-beyond-bound = { $component }: U = { $expanded }{ $unit ->
    [1] {""}
   *[other] {" "}{ $unit }
} (k = 2) überschreitet { $source ->
    [stated] die angegebene Grenze
   *[default] die Grenze
} { $bound }{ $unit ->
    [1] {""}
   *[other] {" "}{ $unit }
}{ $source ->
    [stated] {""}
   *[default] { " " }(Vorgabe für eine gemessene Ausdehnung von { $extent_mm } mm)
}: { $cause }
uncertainty-bound-unreadable = `{ $text }` ist keine Grenze der Unsicherheit: erwartet wird eine Länge, ein Winkel oder beides mit ihren Einheiten
    .hint = zum Beispiel "0.5 mm, 0.1 deg"
bound-position = Position { $axis } von `{ $name }`
bound-rotation = Drehung von `{ $name }` um { $axis }
bound-direction = Komponente { $axis } der Richtung der Achse
bound-ratio = Verhältnis der Achse
bound-axis-direction = Richtung der Achse von `{ $joint }`
bound-axis-point = Lage der Achse von `{ $joint }`
bound-parameter = { $parameter }
bound-open-rotation = die Messwerte zeigen die Drehung um die Richtung { $direction } kaum
bound-open-translation = die Messwerte zeigen die Position entlang { $direction } kaum
bound-open-combination = die Messwerte zeigen die Kombination von { $names } kaum
bound-open-alone = die Messwerte zeigen sie kaum
bound-remedy = { $case ->
    [tool] den Punkt mit Orientierungen antasten, die sich um mindestens 30 deg um zwei Achsen des Flansches unterscheiden
    [poses] in einem größeren Bereich weitere Posen messen, deren Orientierungen sich um mindestens 30 deg um zwei Achsen unterscheiden
    [points] Punkte messen, die weiter voneinander und von der Geraden durch die anderen entfernt sind
    [travel] über einen längeren Verfahrweg messen
    [turn] eine Zielmarke weiter von der Achse und über einen größeren Bogen messen
    [base] in einem größeren Bereich messen und Punkte des Weltkoordinatensystems wählen, die weiter auseinander und nicht auf einer Geraden liegen
    [region] mit Posen im Bereich dieser Ziele kalibrieren
   *[robot] Posen messen, in denen die genannten Parameter verschieden wirken, oder diese Parameter festhalten
}; oder eine größere Grenze angeben

encoder-implausible = { $count ->
    [one] ein Übertragungsfaktor oder Nullpunkt eines Drehgelenks weicht
   *[other] { $count } Übertragungsfaktoren oder Nullpunkte von Drehgelenken weichen
} weiter vom Nennwert ab, als Geber und Referenzfahrt es zulassen: { $parameters }
    .hint = die Spalte des Gelenks im Protokoll, die Getriebeübersetzung und die Justage des Gelenks prüfen; stimmt der Wert, seine `tolerance` in robot.toml angeben
value-beyond-encoder = `{ $parameter }` = { FIXED($value, 5) }{ $unit ->
    [deg] {" "}deg
   *[other] {""}
} (nominal { FIXED($nominal, 5) }, Abweichung { $times } u)

changes-undetected = die gewählten Posen erkennen { $count ->
    [one] eine Änderung
   *[other] { $count } Änderungen
} nicht innerhalb der Grenze: { $changes }
    .hint = mehr Posen wählen (`--positions`), Kandidaten in einem größeren Bereich anbieten oder eine größere Grenze angeben
change-beyond-bound = { $name }: { $change } { $unit }, Grenze { $bound } { $unit }

### Meldungen von campaign; Erklärungen in en/campaign.ftl.

no-file-listed = die Liste der Dateien ist leer
recording-unit = eine Aufzeichnung mit `format` braucht `unit`; ohne `format` ist `unit` nicht zulässig
    .hint = beide angeben; ohne beide ist die Aufzeichnung eine Tabelle time_s,x_mm,y_mm,z_mm, deren Kopf die Einheiten angibt

campaign-missing = die Kampagnendatei `{ $file }` ist nicht vorhanden
    .hint = `etalon init ORDNER` schreibt eine Kampagne als Ausgangspunkt

joints-need-delimited-text = `joints` wird nur aus Text mit Trennzeichen und höchstens einer Namenszeile gelesen
    .hint = `format = {"{"} delimiter = .., header = 1, columns = .. {"}"}` angeben; bei anderen Dateien die Gelenke in einem [log] nennen

joints-differ = zwei Exporte von `{ $file }` geben verschiedene `joints` an
    .hint = in beiden dieselben Spalten angeben

joints-twice = die Gelenke sind zweimal angegeben: in `joints` von `{ $file }` und in [log]
    .hint = eine Angabe weglassen

joints-joined-by-row = ein Export mit `joints` wird zeilenweise verknüpft
    .hint = `by = "row"` in [join] angeben oder [join] weglassen

environment-missing = die Umgebungsvariable `{ $name }` ist nicht gesetzt
    .hint = sie auf den Ordner setzen, der `{ $file }` enthält

export-files-missing = keine Datei hat die Form `{ $file }`
    .hint = die erste Pose messen, oder `file` dieses [[export]] berichtigen

path-outside = `{ $file }` verlässt den Ordner der Kampagne
    .expected = ein Pfad im Ordner der Kampagne oder einer, der mit `$NAME/` beginnt

no-target = ein räumlicher Roboter braucht mindestens eine Zielmarke
    .hint = `target = "NAME"` der Tabelle oder der Exporte angeben (Option --target), eine Spalte `target` der Tabelle, oder `targets` in [join]

target-called-base = eine Zielmarke darf nicht `base` heißen: ihre Parameter hätten dieselben Namen wie die Parameter der Roboterbasis
    .hint = der Zielmarke in `label` oder `columns` einen anderen Namen geben

key-not-positive = `{ $key }` muss positiv sein
    .hint = den Wert berichtigen

joint-key-missing = der Schlüssel `{ $key }` fehlt in `joint`

direction-in-base = eine Richtung in der Basis, zum Beispiel { $example }

keys-state-the-same = { $keys } geben dieselbe Größe an: einen der Schlüssel weglassen

leg-count = ein Hexapod hat sechs Beine, die Datei gibt { $count } an
    .hint = je Bein ein [[leg]] mit base_mm und platform_mm ergänzen

hexapod-singular = der Hexapod ist in seiner Grundstellung singulär: die sechs Beinlängen bestimmen seine Pose dort nicht
    .hint = `base_mm` und `platform_mm` prüfen oder eine andere Grundstellung angeben

no-joints = ein serieller Arm braucht seine Gelenke
    .hint = je Gelenk von der Basis aus ein [[joint]] mit alpha_deg, a_mm, theta_deg, d_mm ergänzen

gravity-without-direction = `gravity` hat keine Richtung
    .expected = eine Richtung in der Basis, zum Beispiel [0, 0, -1]

not-denavit-hartenberg = `{ $key }` ist kein Denavit-Hartenberg-Parameter
    .hint = `{ $key }` gehört zu `convention = "poe"`

joint-angle-unit = `{ $key }` = { FIXED($value, 4) } { $unit ->
        [rad] ist mehr als zwei Umdrehungen: der Wert ist in Grad
       *[deg] ist ein Vielfaches von π/2: der Wert ist im Bogenmaß
    }
    .hint = den Wert als `{ $other }` angeben

not-screw-axis = eine Schraubachse hat weder Denavit-Hartenberg-Parameter noch `parallel`
    .hint = `direction` und `point_mm` angeben

joint-axis-without-direction = die Gelenkachse hat keine Richtung
    .expected = eine Richtung in der Basis, zum Beispiel [0, 0, 1]

flange-missing = Schraubachsen brauchen die Pose des Flansches bei Gelenkwerten von null: der Schlüssel `{ $key }` fehlt

flange-of-table = `{ $key }` hat für Denavit-Hartenberg-Parameter keine Bedeutung
    .hint = `{ $key }` gehört zu `convention = "poe"`

range-of-other-motion = `{ $key }` ist kein Schlüssel eines { $motion ->
        [slides] Schubgelenks
       *[turns] Drehgelenks
    }
    .hint = `{ $own }` angeben

range-exchanged = `{ $key }` ist kein Bereich: von { $lower } bis { $upper }
    .expected = die kleinere Grenze, dann die größere

joint-reference-wrong = { $fault ->
        [unknown-number] es gibt kein Gelenk { $joint }
        [unknown-name] es gibt kein Gelenk `{ $joint }`
        [slides] Gelenk { $joint } ist ein Schubgelenk: es dreht sich nicht
        [twice] Gelenk { $joint } kommt zweimal vor
        [itself] Gelenk { $joint } ist mit sich selbst gekoppelt: stattdessen seinen Übertragungsfaktor angeben
       *[pair] das Paar { $joint } kommt zweimal vor
    }
    .expected = Gelenke von 1 bis { $count }, jedes einmal
    .hint = die Gelenke sind { $joints }

urdf-joint-kind = Gelenk `{ $joint }` ist vom Typ { $kind }; dieser Typ wird nicht unterstützt
    .expected = fixed, revolute, continuous oder prismatic

urdf-axis-without-direction = die Achse von Gelenk `{ $joint }` hat keine Richtung
    .expected = <axis xyz="0 0 1"/> oder eine andere Richtung

urdf-origin-far = der Ursprung von Gelenk `{ $joint }` ist { FIXED($away_m, 0) } m von seinem Vorgänger entfernt
    .hint = Längen einer URDF-Datei sind in Metern: die Längen dieser Datei durch 1000 teilen

urdf-two-parents = Glied `{ $link }` hat zwei Vorgänger: `{ $first }` und `{ $second }`
    .hint = eine URDF-Datei beschreibt einen Baum: Schleifen durch `mimic` schließen

urdf-loop = die Gelenke ab Glied `{ $link }` bilden eine Schleife
    .hint = eine URDF-Datei beschreibt einen Baum: Schleifen durch `mimic` schließen

urdf-link-unknown = `{ $file }` hat kein Glied `{ $link }`

urdf-no-path = keine Gelenkkette führt von `{ $from }` zu `{ $to }`
    .hint = `base_link` und `tool_link` prüfen: kein Gelenk trägt `{ $root }`

urdf-mimic-unknown = Gelenk `{ $joint }` folgt dem Gelenk `{ $mimics }`, das in der Datei fehlt

urdf-mimics-itself = Gelenk `{ $joint }` folgt sich selbst
    .hint = in <mimic> ein anderes Gelenk nennen
urdf-mimics-several = Gelenk `{ $joint }` folgt mehreren Gelenken
    .hint = nur ein `mimic` behalten: in einer URDF-Datei folgt ein Gelenk genau einem führenden Gelenk. Hängt `{ $joint }` von mehreren Gelenken der Kette ab, kein `mimic` behalten: das erste führende Gelenk unter dessen Namen aufzeichnen und den Faktor jedes weiteren in `coupling = [["{ $joint }", "..."]]` und [nominal] angeben

urdf-nothing-moves = zwischen `{ $from }` und `{ $to }` bewegt sich kein Gelenk
    .hint = `base_link` und `tool_link` prüfen

urdf-no-moving-joint = kein Gelenk der Datei bewegt sich
    .hint = die URDF-Datei eines Roboters angeben

bending-on-moving-base = `bending` braucht eine feste Richtung der Schwerkraft, aber Gelenke bewegen `{ $link }`
    .hint = `bending` entfernen oder ein unbewegtes Glied als `base_link` angeben

bending-without-mass = `bending` von Gelenk `{ $joint }` braucht eine Masse hinter dem Gelenk
    .hint = <inertial> in den Gliedern hinter dem Gelenk ergänzen

parameter-name-doubled = zwei Parameter würden `{ $name }` heißen
    .hint = die Zielmarke umbenennen: eine Zielmarke darf nicht den Namen eines Gelenks haben

tool-link-missing = kein Glied trägt die Zielmarken
    .hint = `tool_link = "..."` angeben oder bei mehreren Gliedern je ein [[branch]] mit `tool_link` und `targets`

tool-link-beside-branches = `tool_link` und [[branch]] geben beide die Glieder der Zielmarken an
    .hint = `tool_link` entfernen und für sein Glied ein [[branch]] mit `targets` angeben

target-on-two-branches = Zielmarke `{ $target }` gehört zu zwei Zweigen: `{ $first }` und `{ $second }`
    .hint = aus `targets` eines der beiden Zweige entfernen

target-on-no-branch = Zielmarke `{ $target }` gehört zu keinem Zweig
    .hint = in `targets` des [[branch]] aufnehmen, dessen Glied sie trägt

bending-in-branches = `bending` von Gelenk `{ $joint }` wird nicht modelliert: mehrere Zweige belasten es
    .hint = das Gelenk aus `bending` entfernen

payload-in-branches = `payload` des Gelenks `{ $joint }` wird nicht modelliert: der Roboter hat mehrere Zweige
    .hint = `payload` entfernen oder den Zweig allein mit `tool_link` beschreiben

elastic-in-branches = `{ $key }` wird nicht modelliert: der Roboter hat mehrere Zweige
    .hint = `{ $key }` entfernen oder den Zweig allein mit `tool_link` beschreiben

coupling-across-branches = Gelenk `{ $by }` bewegt den Zweig `{ $link }` nicht, in dem `{ $joint }` mit ihm gekoppelt ist
    .hint = das Paar aus `coupling` entfernen: beide Gelenke müssen auf dem Weg zu jedem Glied liegen

key-of-other-model = `{ $key }` hat für dieses Modell keine Bedeutung
    .hint = `{ $key }` gehört zu `model = "{ $model }"`

nominal-unknown = [nominal] nennt `{ $parameter }`, das kein Parameter dieses Roboters ist

nominal-length-not-positive = die Länge `{ $parameter }` muss positiv sein
    .hint = die Länge nach der Zeichnung angeben

nominal-missing = [nominal] gibt { $parameters } nicht an
    .hint = die Geometrie der Maschine nach der Zeichnung in mm angeben: sie wird nie geraten

tolerance-not-positive = die Toleranz `{ $parameter }` muss positiv sein
    .hint = die Toleranz nach der Zeichnung angeben

tolerance-unknown = `tolerance` nennt `{ $parameter }`, das kein Parameter dieses Roboters ist

selection-empty = `{ $stated }` nennt keine Posen
    .expected = Namen und Bereiche wie "1-8, 12, home", eine Liste aus Namen und Bereichen, "all", "rest" oder "index mod 10 < 7"

not-a-measured-value = `{ $value }` ist kein Messwert
    .expected = eine endliche Zahl

value-of-other-kind = { $element ->
        [yes] ein Element von `{ $key }`
       *[no] `{ $key }`
    } ist { $found }

kind-of-value = { $kind ->
        [text] ein Text
        [date] ein Datum ohne Anführungszeichen
        [list] eine Liste von { $length }
       *[table] eine Tabelle
    }

unknown-variant = unbekannter Wert `{ $text }`

key-missing = der Schlüssel `{ $key }` fehlt{ $has_section ->
        [yes] {" "}in `{ $section }`
       *[no] {""}
    }

campaign-title = { $kind ->
        [calibration] Kalibrierung:
        [geometry] Geometrische Kalibrierung:
       *[test] Prüfung:
    } { $robot }

campaign-title-dated = { $kind ->
        [calibration] Kalibrierung:
        [geometry] Geometrische Kalibrierung:
       *[test] Prüfung:
    } { $robot }, { $date }

state-unit = `unit = "mm"`, "m", "um" oder "inch" angeben, je nach Einheit der Datei; sie wird nie geraten

state-instrument = in [instrument] name, expanded_uncertainty_um und coverage_factor angeben: Werte aus dem Kalibrierschein des Messgeräts

state-file = die Datei im Ordner der Kampagne angeben

copy-keys = `etalon init ORDNER` schreibt eine Kampagne mit allen Schlüsseln zum Kopieren

toml-invalid = { $reason }

table-key-twice = diese Tabelle enthält den Schlüssel zweimal{ $more ->
        [0] {""}
        [one] , ebenso 1 weiteren Schlüssel
       *[other] , ebenso { $more } weitere Schlüssel
    }
    .hint = jede Tabelle einer Liste mit ihrem Kopf in doppelten Klammern beginnen, wie `[[joint]]`: fehlt ein solcher Kopf vor diesem Schlüssel?

unknown-key = { $count ->
        [one] unbekannter Schlüssel { $keys }
       *[other] unbekannte Schlüssel { $keys }
    }

key-belongs-at-top = `{ $key }` gehört an den Anfang, vor den ersten Abschnitt

table-head-missing = fehlt der Kopf ihrer Tabelle, wie `[section]` oder `[[joint]]`?

key-remedy = { $key ->
        [station] Stationen eines Messgeräts sind eine Spalte `station` einer Beobachtungstabelle: {"["}observations] statt Exporten und Protokoll angeben
       *[base_turn_y_deg] den Schlüssel löschen: base_rx, base_ry und base_rz sind ein Rotationsvektor, und keine Orientierung der Basis ist singulär
    }

urdf-no-robot = die Datei ist keine URDF-Datei
    .expected = das Element <robot>

xacro-construct = `{ $construct }` von xacro wird hier nicht expandiert
    .hint = die Datei expandieren und stattdessen die URDF-Datei angeben: { $command }

urdf-joint-twice = es gibt zwei Gelenke `{ $joint }`
    .hint = eines umbenennen

urdf-joint-link-unknown = Gelenk `{ $joint }` nennt das Glied `{ $link }`, das in der Datei fehlt

urdf-joint-without-link = Gelenk `{ $joint }` hat kein <{ $child } link="..."/>
    .hint = das Element ergänzen

urdf-limits-exchanged = die Grenzen von Gelenk `{ $joint }` sind vertauscht: { $lower } bis { $upper }
    .hint = die beiden Grenzen tauschen

urdf-angles-beyond-turn = Winkel von `rpy` übersteigen eine volle Umdrehung
    .hint = Winkel einer URDF-Datei sind in Radiant: 90 deg sind `1.5707963267948966`

urdf-attribute-missing = <{ $element }> hat kein `{ $attribute }`
    .hint = das Attribut ergänzen

urdf-not-number = `{ $attribute }`: `{ $word }` ist keine Zahl
    .hint = den Wert berichtigen

urdf-number-count = `{ $attribute }` hat { $count ->
        [one] 1 Zahl
       *[other] { $count } Zahlen
    }
    .expected = { $expected_count ->
            [one] eine Zahl
           *[other] { $expected_count } Zahlen
        }

key-open = `{ $key }` ist noch offen
    .hint = die Zeile ergänzen{ $remark ->
        [none] {""}
       *[other] : { $remark }
    }

joint-unit-open = die Einheit der Gelenke ist noch offen
    .hint = deg, rad, mm oder m für UNIT einsetzen

angle-unit-open = die Einheit der gemessenen Drehungen ist noch offen
    .hint = in `rx_UNIT`, `ry_UNIT` und `rz_UNIT` deg oder rad für UNIT einsetzen

time-unit-open = die Einheit der Zeiten ist noch offen
    .hint = `time_s`, `time_ms`, `time_us` oder `time_ns` für `time_UNIT` einsetzen

kind-expected = { $kind ->
        [text] ein Text
        [number] eine Zahl
        [whole] eine ganze Zahl{ $limit ->
            [none] {""}
           *[other] {" "}ab { $limit }
        }
        [list] eine Liste{ $limit ->
            [none] {""}
           *[other] {" "}von { $limit }
        }
       *[table] eine Tabelle
    }

alternatives = { $first ->
        [none] {""}
       *[other] { $first } oder{" "}
    }{ $last }

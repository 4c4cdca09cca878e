### Meldungen von simulate; Erklärungen in en/simulate.ftl.

truth-joint-count = eine Pose hat { $values } Gelenkwerte, der Roboter { $joints } Gelenke
    .hint = einen Wert je Gelenk angeben, bei einer Plattform auch ihren Montagemodus

truth-label-with-circles = `label` in [[poses]] gilt nur für `joints`, nicht für `circles`
    .hint = `label` weglassen oder `joints` angeben

truth-point-unknown = [[poses]] nennt den Punkt `{ $label }`, aber kein [[point]] hat diese Bezeichnung

truth-circles-not-planar = `circles` gilt nur für ebene Roboter
    .hint = `joints` verwenden

truth-parameter-unknown = [parameters] nennt `{ $parameter }`, das kein Parameter dieses Roboters ist

truth-target-unknown = [repeatability] der wahren Werte: der Roboter hat keine Zielmarke `{ $target }`

truth-pose-missing = Pose { $pose } des Ablaufs fehlt in den wahren Werten
    .hint = sie in `joints` von [[poses]] und in [[repeatability.pose]] ergänzen

truth-repeatability-without-campaign = [repeatability] steht in den wahren Werten, aber nicht in der Kampagne
    .hint = [repeatability] in campaign.toml angeben: der Abschnitt nennt Bezeichnungen und Ablauf

truth-home-count = `home` hat { $values } Gelenkwerte, der Roboter { $joints } Gelenke
    .hint = einen Wert je Gelenk angeben

simulate-not-written = `etalon simulate` kann { $what } nicht schreiben
    .hint = eine simulierbare Datei angeben und danach durch die wirkliche Datei ersetzen

several-tables = `etalon simulate` schreibt nur eine Beobachtungstabelle
    .hint = eine Kampagne mit einer davon simulieren

simulated-kind = { $kind ->
        [twincat] einen TwinCAT-Export
        [moving-log] ein während der Bewegung aufgezeichnetes Protokoll
        [period-log] ein Protokoll, dessen Zeiten aus seiner Periode folgen, bei Verknüpfung über die Zeit
        [repeated-columns] ein Protokoll, das Spalten zweimal nennt
        [workbook-sheet] ein Blatt einer Arbeitsmappe
        [encoding] eine Tabelle in anderer Kodierung als UTF-8
        [blank-columns] eine Beobachtungstabelle mit Leerzeichen zwischen den Spalten: ihre leeren Zellen gingen verloren
        [computed-columns] eine Beobachtungstabelle mit berechneten, nummerierten oder konstanten Spalten, mit Filtern oder mit einem anderen Kopf als einer Zeile
        [unmodelled] eine Beobachtungstabelle mit Abweichungen aus {"["}unmodelled]
        [circumstances] ein Protokoll eines Roboters mit Umkehrspiel, dessen Messwerte eine Nutzlast, Drehmomente oder eine Temperatur angeben
       *[backlash] eine Beobachtungstabelle eines Roboters mit Umkehrspiel
    }

coordinates-of-other-kind = `coordinates` gilt nur für die Art `point` ohne Station
    .hint = `coordinates` weglassen

in-numbered-table = [[{ $table }]] { $number }: { $message }

in-set = Gruppe `{ $set }`: { $message }

export-without-points = die wahren Werte enthalten keine Punkte für den Export `{ $file }`
    .hint = einen [[point]] mit diesem `export` oder beim Export in der Kampagne `label` oder `target` ergänzen

simulate-utf8 = `etalon simulate` schreibt UTF-8
    .hint = `encoding` dieses Exports weglassen

simulated-rows-lost = aus `{ $file }` würden nur { $read } von { $rows } Zeilen gelesen
    .hint = Zielmarke, Pose und Zyklus in `label` oder `columns` nennen; `pose = "row"` setzt eine einzige Zielmarke je Datei voraus; ohne Zyklus `cycles = 1` in den wahren Werten angeben

simulated-row-misread = Zeile { $line } von `{ $file }` ist { $meant }, würde aber als { $read } gelesen
    .hint = Zielmarke, Pose und Zyklus in `label` oder `columns` nennen; `pose = "row"` setzt eine einzige Zielmarke je Datei voraus; ohne Zyklus `cycles = 1` in den wahren Werten angeben

measurement-name = Zielmarke `{ $target }`, Pose { $pose }, Zyklus { $cycle }

truth-pose-out-of-reach = Pose { $pose } ist nicht erreichbar: { $reason }
    .hint = die Pose in den wahren Werten oder [reach] in robot.toml berichtigen

truth-point-out-of-reach = Pose { $pose }: der wahre Roboter erreicht den Punkt { $point } mm nicht
    .hint = den Punkt oder die Pose in den wahren Werten berichtigen

observe-without-table = die wahren Werte enthalten [[observe]], aber die Kampagne hat keinen Abschnitt [observations]
    .hint = die Tabelle in campaign.toml angeben: `[observations]` mit `file`

table-without-observe = die wahren Werte enthalten kein [[observe]] für die Tabelle von [observations]
    .hint = angeben, was beobachtet wird: kind = "point", target = "ball" ...; docs/observations.md nennt die Arten

campaign-not-synthetic = die Kampagne gibt nicht an, dass ihre Daten synthetisch sind: ihre Dateien können Messungen sein
    .hint = `synthetic = "Herkunft der Daten"` in campaign.toml angeben; `etalon init --synthetic ORDNER` schreibt eine solche Kampagne mit wahren Werten

truth-decimals = { $decimals } Nachkommastellen überschreiten die Genauigkeit einer Zahl
    .expected = 0 bis { $most }

joints-and-points-together = eine Datei, die Gelenke und Punkte zusammen enthält, kann nicht simuliert werden
    .hint = einen Export und ein [log] getrennt angeben

point-label-formula = die Bezeichnung `{ $label }` eines [[point]] wäre in einer Tabellenkalkulation eine Formel
    .hint = eine Bezeichnung verwenden, die nicht mit = + - oder @ beginnt

truth-parameters-missing = [parameters] gibt { $parameters } nicht an
    .hint = die wahren Lagen der beobachteten festen Punkte und Flächen angeben

unmodelled-joint-unknown = [unmodelled] nennt `{ $joint }`, das kein Gelenk dieses Roboters ist

unmodelled-period = [unmodelled] `period` von `{ $joint }` muss positiv sein
    .hint = eine positive Periode angeben

study-too-few-poses = zu wenige Posen, um alle Parameter zu identifizieren
    .hint = der Gruppe Posen hinzufügen

study-set-empty = eine Gruppe hat keine Pose, die der Roboter erreicht
    .hint = erreichbare Posen angeben

study-not-by-position = `{ $model }` kann nicht durch Positionen festgelegt werden
    .hint = `joints` oder eine Tabelle in `file` angeben

truth-not-touching = Pose { $pose }: keine Gelenkwerte nahe den wahren Werten stellen den Kontakt her
    .hint = Gelenkwerte näher am Kontakt angeben oder den Bereich der Ziehungen vergrößern

angle-uncertainty-missing = die Unsicherheit eines Winkels fehlt
    .hint = `expanded_rotation_uncertainty_deg` in [instrument] oder `urot_deg` in [[observe]] angeben

truth-geometric-without-campaign = [geometric] steht in den wahren Werten, aber nicht in der Kampagne, oder ihr Roboter ist kein PreXYT
    .hint = [geometric] in campaign.toml angeben: der Abschnitt nennt die Bezeichnungen
study-error-in-base = wahre Pose des Werkzeugs im Basiskoordinatensystem minus Sollpose
study-error-in-world = wahre Pose des Werkzeugs im Weltkoordinatensystem minus Sollpose
poses-in-set = Posen der Gruppe `{ $set }`
positions-in-workspace = Positionen in `workspace`
counted-calibrations = Kalibrierungen
errors-to-evaluate = auszuwertende Abweichungen
poses-to-simulate = zu simulierende Posen
points-to-simulate = zu simulierende Punkte

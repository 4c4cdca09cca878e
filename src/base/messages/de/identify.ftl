### Meldungen von identify; Erklärungen in en/identify.ftl.

no-observations = es gibt keine Beobachtungen, aus denen Parameter identifiziert werden können
    .hint = prüfen, welche Posen gewählt und welche ausgeschlossen sind

pose-residuals-without-uncertainty = die Residuen der Pose enthalten mm und rad: sie brauchen die Standardunsicherheit einer Koordinate

common-uncertainty-alone = eine gemeinsame Unsicherheit mehrerer Beobachtungen braucht Residuen von Zielmarken und die Unsicherheit jeder Beobachtung

parameter-unknown = `{ $pattern }` ist kein Parameter dieses Roboters

observations-need-arm = Orientierungen, Abstände, Kontakte, Flächen und Gelenkwerte gelten nur für räumliche Arme, nicht für `{ $model }`

kinds-need-target-residuals = Orientierungen, Abstände, Kontakte, Flächen und Gelenkwerte brauchen Residuen von Zielmarken ohne gemeinsame Unsicherheit
    .hint = Zielmarken vergleichen und die gemeinsame Unsicherheit weglassen

kinds-without-uncertainty = Beobachtungen verschiedener Art brauchen die Standardunsicherheit einer Koordinate

own-uncertainties-unusable = Messwerte mit eigenen Unsicherheiten brauchen Residuen von Zielmarken ohne gemeinsame Unsicherheit

readings-without-uncertainty = { $without } von { $readings } Messwerten haben keine Unsicherheit

pose-residuals-not-planar = Residuen der Pose gelten nur für ebene Roboter, nicht für `{ $model }`

tool-part-missing = der Werkzeugpunkt ist im Koordinatensystem { $part ->
        [flange] des Flansches
       *[platform] der Plattform
    } angegeben: ein solches Teil hat `{ $model }` nicht

too-few-poses-planned = { $poses } Posen reichen nicht aus, um { $parameters } Parameter zu bestimmen

nothing-to-identify = es bleibt kein Parameter zu identifizieren{ $cause ->
        [none] {""}
       *[other] : { $cause }
    }

hold-fewer-parameters = weniger Parameter festhalten

parameters-undetermined = { $residuals ->
        [one] 1 Residuum
       *[other] { $residuals } Residuen
    } aus { $poses ->
        [one] 1 Pose
       *[other] { $poses } Posen
    }, davon { $independent } unabhängig, bestimmen { $parameters ->
        [one] 1 Parameter nicht
       *[other] { $parameters } Parameter nicht
    }

parameter-without-effect = die Daten hängen nicht von `{ $parameter }` ab

parameters-inseparable = `{ $parameter }` ist nicht getrennt von { $others } identifizierbar

identification-without-result = die Identifikation endete ohne Ergebnis: { $reason }

solver-ended = { $termination ->
        [iteration-limit] keine Konvergenz innerhalb der Iterationsgrenze
        [not-a-number] ein Residuum ist keine Zahl
        [rank-deficient] Parameter sind nicht getrennt identifizierbar
        [unsteady] die Menge der getrennt identifizierbaren Parameter ändert sich zwischen den Schritten des Lösers
        [too-few-equations] es gibt weniger Gleichungen als Parameter
       *[converged] Konvergenz, aber das Ergebnis ist nicht eindeutig
    }

readings-contradict = die meisten Messwerte passen, die Messwerte von { $poses } nicht{ $count ->
        [0] {""}
       *[other] {""}: die Gelenkwerte der Posen { $pairs } sind vertauscht
    }{ $wrong ->
        [0] {""}
       *[other] {""}: { $coordinates }
    }

wrong-coordinate = { $axis } von { $target } an Pose { $pose } (Zyklus { $cycle }) ist { FIXED($measured_mm, 3) } mm, und { FIXED($changed_mm, 3) } mm passt

change-of-reference = einer Bewegung von Basis oder Messsystem

change-of-target = einer Bewegung der Zielmarke `{ $target }` auf ihrem Träger

change-of-zero = einem anderen Nullpunkt des Gelenks `{ $joint }`

change-or-another = { $message }; die Messwerte passen ebenso zu { $others }

named-poses = { $count ->
        [one] Pose { $poses }
       *[other] { $count } Posen ({ $poses })
    }

poses-unreachable = der nominale Roboter kann diese Gelenkwerte nicht annehmen: { $poses }

extents-differ = die gemessenen Punkte erstrecken sich über { FIXED($measured_mm, 0) } mm, die Punkte des Modells über { FIXED($model_mm, 0) } mm

assembly-mode-contradicted = die gemessene Position widerspricht dem Montagemodus ({ $poses }): an Pose { $worst } ist die Abweichung mit dem angegebenen Modus { $stated } { FIXED($stated_mm, 1) } mm, mit Modus { $other } { FIXED($other_mm, 1) } mm

scale-unobserved = keine Beobachtung enthält eine Länge: der Maßstab des Roboters folgt aus seinen Nennlängen{ $lengths ->
        [none] {""}
       *[other] {" "}({ $lengths })
    }
    .hint = einen Abstand zwischen zwei Aufnahmen oder zu einem festen Punkt oder die Position einer Zielmarke messen

readings-weighted = { $own } von { $readings } Messwerten sind mit ihren eigenen Standardunsicherheiten gewichtet: { FIXED($least_mm, 4) } bis { FIXED($most_mm, 4) } mm je Koordinate

rigid-part-contradicted = { $places } von { $targets } widersprechen den Messungen über ihre Unsicherheit hinaus: der Abstand von `{ $first }` bis `{ $second }` ist { FIXED($found_mm, 4) } mm { $by ->
        [identification] (ohne diese Angaben identifiziert)
       *[measurement] (gemessen)
    }, angegeben sind { FIXED($stated_mm, 4) } mm

stated-positions = angegebene Positionen

comparison-without-uncertainty = ein Vergleich mit gegebenen Parametern braucht die Standardunsicherheit einer Koordinate
    .hint = die Unsicherheit des Messgeräts angeben

robot-not-at-joints = der Roboter kann diese Gelenkwerte mit { $parameters ->
        [nominal] Nennparametern
       *[given] den gegebenen Parametern
    } nicht annehmen
    .hint = Einheit, Vorzeichen und Versatz der Gelenkwerte prüfen, und ob die Parameter zu diesem Roboter gehören

covariance-not-positive-definite = die Kovarianz der Parameter ist nicht positiv definit
    .hint = die Kovarianz so verwenden, wie die Identifikation sie angegeben hat

no-redundant-observations = es gibt so viele Gleichungen wie Parameter: die Unsicherheit der Parameter ist unbekannt
    .hint = mehr Posen messen oder die Unsicherheit des Messgeräts angeben

pose-residuals-correlated = die Residuen derselben Pose sind korreliert: die Standardunsicherheiten sind aus der Streuung der Posen geschätzt und betragen das { FIXED($ratio, 1) }-Fache der Werte aus dem Messgerät
    .hint = der Roboter hat Abweichungen, die das Modell nicht beschreibt, oder das Messgerät hat gemeinsame Abweichungen aller Messwerte einer Pose

series-not-estimated = die Unsicherheiten enthalten die Streuung zwischen den Serien nicht: es sind weniger als acht Posen, oder mehrere Posen haben gemeinsame Messwerte

instrument-uncertainty-too-large = die Residuen betragen das { FIXED($ratio, 2) }-Fache der angegebenen Unsicherheit der Messwerte (Chi-Quadrat { FIXED($chi_square, 1) }, { $degrees } Freiheitsgrade): die Standardunsicherheiten sind zu groß
    .hint = Unsicherheit des Messgeräts, ihre Einheit und ihren Erweiterungsfaktor prüfen; gemeinsame Abweichungen aller Posen sind in den Residuen nicht sichtbar

residuals-exceed-uncertainty = die Residuen betragen das { FIXED($ratio, 1) }-Fache der angegebenen Unsicherheit der Messwerte (Chi-Quadrat { FIXED($chi_square, 0) }, { $degrees } Freiheitsgrade): die Standardunsicherheiten sind { $from ->
        [poses] aus der Streuung der Posen geschätzt
        [regions] aus der Streuung von Bereichen des Arbeitsraums geschätzt
       *[residuals] vergrößert, als wären die Residuen derselben Pose unabhängig
    } (das { FIXED($inflation, 1) }-Fache der Werte aus der angegebenen Unsicherheit, Median)
    .hint = Ausreißer und Modell prüfen: der Roboter hat Abweichungen, die das Modell nicht beschreibt, oder die angegebene Unsicherheit ist zu klein

parameters-fixed-by-frames = { $count } Parameter sind nicht getrennt von Basis und Zielmarken identifizierbar und bleiben auf ihren Nennwerten: { $parameters }

target-place-free = die Daten können { $parameters } nicht von der Position der Basis trennen: sie sind auf 0 gesetzt, damit Positionen im Basiskoordinatensystem Positionen dieser Zielmarke sind
    .hint = für Positionen der Plattform die Zielmarke auf ihr messen, ihre Koordinaten in robot.toml unter [nominal] ergänzen und mit `hold` festhalten

parameter-held-without-effect = die Daten hängen nicht von `{ $parameter }` ab: er bleibt auf seinem Nennwert

parameter-held-inseparable = `{ $parameter }` und { $others } sind nicht getrennt identifizierbar: `{ $parameter }` bleibt auf seinem Nennwert

parameter-separable-poorly = `{ $parameter }` ist von { $others } nur mit einer Standardunsicherheit von { FIXED($uncertainty, 2) }{ $unit ->
        [mm] {" "}{ $unit }
        [deg] {" "}{ $unit }
       *[other] {""}
    } trennbar: { $held ->
        [placed] er behält seinen Startwert
       *[nominal] er bleibt auf seinem Nennwert, der genauer ist
    }
    .hint = Posen messen, in denen diese Parameter verschieden wirken

tool-targets-collinear = die Zielmarken bestimmen kein Koordinatensystem für den Werkzeugpunkt: nötig sind im Raum drei, die nicht auf einer Geraden liegen, in der Ebene zwei
    .hint = den Punkt im Flanschkoordinatensystem angeben oder die erste Zielmarke selbst verwenden ([0, 0, 0])

nominal-robot-far = der nominale Roboter weicht von den Messungen um { FIXED($left_mm, 3) } mm ab (quadratischer Mittelwert, Basis und Zielmarken angepasst); die Toleranzen lassen { FIXED($allowed_mm, 3) } mm zu
    .hint = Vorzeichen, Einheiten und Reihenfolge der Gelenke, die Nennwerte und die Verknüpfung von Gelenkwerten und Punkten prüfen

nominal-robot-not-at-joints = der nominale Roboter kann diese Gelenkwerte nicht annehmen
    .hint = Vorzeichen, Einheiten und Reihenfolge der Gelenke, die Nennwerte und die Verknüpfung von Gelenkwerten und Punkten prüfen

placement-unexplained = keine Position von Basis und Zielmarken erklärt die Messungen: Residuen betragen { FIXED($left_mm, 1) } mm, die gemessenen Punkte erstrecken sich über { FIXED($spread_mm, 1) } mm
    .hint = Einheiten, Reihenfolge, Vorzeichen und Versatz der Gelenke, festgehaltene Parameter von Basis und Zielmarken und die Nennparameter des Roboters prüfen

joint-zero-shifted = ab Pose { $pose } weicht die Differenz wahrer minus aufgezeichneter Wert des Gelenks `{ $joint }` um { FIXED($change, 4) } { $unit } ± { FIXED($expanded, 4) } { $unit } von den Posen bis { $previous } ab: der geänderte Nullpunkt erklärt { FIXED($share_percent, 0) } % der Residuen
    .hint = Geber und Justage des Gelenks prüfen: die Posen vor und nach der Änderung getrennt identifizieren oder neu messen

reference-moved = ab Pose { $pose } sind gemessene Positionen um { FIXED($shift_mm, 3) } mm ± { FIXED($expanded_mm, 3) } mm ({ $vector_mm } mm) gegenüber den Positionen bis Pose { $previous } verschoben: die Verschiebung erklärt { FIXED($share_percent, 0) } % der Residuen
    .hint = Basis oder Messsystem hat sich bewegt: die beiden Teile getrennt identifizieren oder neu messen

target-shifted = ab Pose { $pose } ist die Zielmarke `{ $target }` um { FIXED($shift_mm, 3) } mm ± { FIXED($expanded_mm, 3) } mm ({ $vector_mm } mm im Koordinatensystem des Flansches) gegenüber ihrer Lage bis Pose { $previous } verschoben: die Verschiebung erklärt { FIXED($share_percent, 0) } % der Residuen
    .hint = die Zielmarke hat sich auf ihrem Träger bewegt: ihr ab dieser Pose einen anderen Namen geben oder neu messen

poses-exchanged = { $count ->
        [one] die Gelenkwerte der Posen { $pairs } sind vertauscht
       *[other] die Gelenkwerte von { $count } Paaren von Posen sind vertauscht: { $pairs }
    }: getauscht sind sie keine Ausreißer
    .hint = die Reihenfolge der Zeilen des Protokolls und die Namen der Posen prüfen

set-up-contradicted = die Messwerte widersprechen dem angegebenen Aufbau
    .hint = die Änderungen prüfen, die die Messwerte erklären

set-up-untested = von diesen Daten nicht geprüft: { $changes }
    .hint = diese Fehler am Roboter prüfen oder eine zweite Zielmarke abseits der Achse des letzten Gelenks in Posen messen, die alle Gelenke bewegen

untested-change = { $change } (Standardabweichung einer Koordinate { FIXED($changed_mm, 3) } mm statt { FIXED($stated_mm, 3) } mm; der Flansch weicht um bis zu { FIXED($flange_mm, 0) } mm und { FIXED($flange_deg, 0) } deg ab)
pair-of-poses = { $first } und { $second }

parameters-weakly-identifiable = { $groups } sind aus diesen Posen nur schwach identifizierbar: Standardunsicherheiten { $uncertainties } (Korrelation { FIXED($correlation, 6) })

parameter-groups-weakly-identifiable = { $count } Gruppen von Parametern sind aus diesen Posen nur schwach identifizierbar (größte Standardunsicherheiten: { $uncertainties }; innerhalb einer Gruppe heben sich die Abweichungen in der Nähe dieser Posen auf): { $groups }

uncertainty-of-parameter = u({ $parameter }) = { FIXED($u, 3) } { $unit }

uncertainty-of-ratio = u({ $parameter }) = { SCIENTIFIC($u, 1) }

parameter-group = { $first } und { $second }

parameter-groups = { $first }; { $others }

separate-parameters = Posen messen, in denen diese Parameter verschieden wirken

separate-parameters-by-joints = Posen über einen größeren Bereich von { $joints } messen, in denen diese Parameter verschieden wirken

too-many-positions = { $positions } Positionen können nicht aus { $candidates } Kandidaten ausgewählt werden
    .expected = eine Zahl von 1 bis { $candidates }

start-pose-unknown = die Startpose { $pose } ist kein Kandidat
    .hint = Posen aus der Tabelle der Kandidaten verwenden

start-too-large = die Startauswahl hat { $start } Kandidaten, zu wählen sind nur { $positions } Positionen
    .hint = weniger Posen als Startauswahl angeben oder mehr Positionen wählen

study-too-few-positions = { $positions } Positionen reichen nicht aus, um alle Parameter zu bestimmen
    .hint = mehr Positionen wählen

no-candidates = es gibt keine Kandidaten
    .hint = die Tabelle der Kandidaten prüfen

candidates-unreachable = kein Kandidat ist erreichbar: Pose { $pose } ({ $reason })
    .hint = Gelenkwerte, ihre Einheiten und die Grenzen des Roboters prüfen

candidates-left-out = { $count ->
        [one] 1 Kandidat ist nicht erreichbar und wird nie gewählt
       *[other] { $count } Kandidaten sind nicht erreichbar und werden nie gewählt
    }: { $candidates }

candidate-violation = Pose { $pose } ({ $reason })

at-geometric-step = { $step ->
        [lead-1] Steigung von Antrieb 1
        [lead-2] Steigung von Antrieb 2
        [lead-3] Steigung von Antrieb 3
        [base] Basiskoordinatensystem
        [mobile] bewegtes Koordinatensystem
        [shaft] Welle
       *[offsets] Versätze
    }: { $message }

geometric-step-alone = { $step ->
        [shaft] die Welle braucht den Bogen der Kugel N
       *[offsets] die Verschiebung von Antrieb 1 braucht den Bogen der Kugel N, die gedrehte Plattform und die Welle
    }
    .hint = die fehlenden Schritte messen oder diesen weglassen

geometry-incomplete = die vollständige Geometrie braucht den Bogen der Kugel N, die gedrehte Plattform, die Welle in zwei Positionen und eine Verschiebung von Antrieb 1
    .expected = mindestens eine Wiederholung jedes Schritts

ball-unmoved = { $ball ->
        [R] Kugel R hat sich nicht bewegt, während Antrieb 2 bis zum Anschlag fuhr
       *[K] Kugel K hat sich entlang x um weniger als 1 mm bewegt, während Antrieb 1 bis zum Anschlag fuhr
    }
    .hint = Kugel { $ball } noch einmal messen, nachdem Antrieb { $actuator } allein bis zum Anschlag gefahren ist

lead-undetermined = diese Positionen bestimmen die Steigung des Antriebs nicht
    .expected = mindestens drei Messwerte bei mindestens zwei Sollverschiebungen

shaft-positions-parallel = die beiden Positionen der Welle sind parallel: ihre Achsen schneiden sich nicht
    .hint = dazwischen nur Antrieb 2 bis zum Anschlag fahren

points-undetermined = diese Punkte bestimmen das angepasste Element nicht
    .hint = die Positionen über den ganzen Weg oder Drehwinkel verteilen

slip-reversed = { $joint } umgekehrt

slip-exchanged = { $first } und { $second } vertauscht
slip-branches-exchanged = die Zielmarken von { $first } und { $second } vertauscht

slip-joint-order = die Gelenke { $order ->
        [reversed] in umgekehrter Reihenfolge
        [left] um einen Platz verschoben
       *[right] um einen Platz in der Gegenrichtung verschoben
    }

slip-joint-block = die Gelenke { $first } bis { $last } { $order ->
        [left] um einen Platz verschoben
       *[right] um einen Platz in der Gegenrichtung verschoben
    }

slip-offset = { $degrees } deg zu { $joint } addiert

slip-unit = { $quantity ->
        [all-joints] alle Gelenke
        [joints-of-kind] alle Gelenke dieser Art
        [lengths] alle gemessenen Längen
        [distances] die gemessenen Abstände
        [points] die gemessenen Punkte
       *[other] { $quantity }
    } { $slip ->
        [m-mm] in Metern statt Millimetern
        [mm-m] in Millimetern statt Metern
        [inch-mm] in Zoll statt Millimetern
        [mm-inch] in Millimetern statt Zoll
        [rad-deg] in Radiant statt Grad
        [gon-deg] in Gon statt Grad
        [deg-gon] in Grad statt Gon
       *[deg-rad] in Grad statt Radiant
    }

slip-unit-of-targets = die Messpunkte von { $targets } { $slip ->
        [m-mm] in Metern statt Millimetern
        [mm-m] in Millimetern statt Metern
        [inch-mm] in Zoll statt Millimetern
       *[mm-inch] in Millimetern statt Zoll
    }

slip-points = { $change ->
        [mirrored] die gemessenen Punkte gespiegelt (ein Linkssystem oder zwei vertauschte Koordinaten)
        [exchanged] x und y der gemessenen Punkte vertauscht
        [x] x der gemessenen Punkte umgekehrt
       *[y] y der gemessenen Punkte umgekehrt
    }

slip-poses-inverse = Inverse der gemessenen Posen (Pose des Messgeräts im Koordinatensystem der Zielmarke)
slip-targets = die Zielmarken { $first } und { $second } vertauscht
slip-fixtures-exchanged = die Punkte oder Flächen { $first } und { $second } vertauscht

slip-neighbour = die Gelenkwerte jeder Pose aus der { $neighbour ->
        [previous] vorigen Pose
       *[next] nächsten Pose
    } genommen

slip-world-frame = das Weltkoordinatensystem um { FIXED($angle_deg, 1) } deg gedreht und um ({ FIXED($x_mm, 1) }; { FIXED($y_mm, 1) }) mm verschoben

slip-reading = der Messwert von `{ $target }` an Pose { $pose } ausgelassen
slip-pair = { $first }, und { $second }
slip-nominal = `{ $parameter }` = { FIXED($found, 2) } { $unit } statt { FIXED($nominal, 2) } { $unit }

with-slip = { $slip }{ $origin ->
        [none] {""}
       *[other] {" "}({ $origin })
    }

set-up-slip = { $others ->
        [none] eine Änderung erklärt die Messwerte: { $first }
       *[other] jede dieser Änderungen erklärt die Messwerte: { $first }; { $others }
    }. { $stated ->
        [unreachable] Ohne Änderung sind Posen nicht erreichbar; mit der Änderung beträgt die Standardabweichung einer Koordinate { FIXED($changed_mm, 3) } mm
        [angles] Die Standardabweichung der Orientierungen sinkt von { FIXED($stated_deg, 2) } deg auf { FIXED($changed_deg, 2) } deg
        [tolerances] Mit der Änderung beträgt die Standardabweichung einer Koordinate { FIXED($changed_mm, 3) } mm, und die Parameter bleiben in ihren Toleranzen
       *[residuals] Die Standardabweichung einer Koordinate sinkt von { FIXED($stated_mm, 3) } mm auf { FIXED($changed_mm, 3) } mm
    } (an Posen, die die Identifikation auslässt): dies zuerst prüfen

index-o1 = O1 = (s1...sm)^(1/m) / sqrt(n), m Parameter, n Konfigurationen; Jacobi-Matrix in mm je mm, rad und 1
index-o2 = O2 = smin / smax; Jacobi-Matrix in mm je mm, rad und 1
index-o3 = O3 = smin; Jacobi-Matrix in mm je mm, rad und 1
index-o4 = O4 = smin^2 / smax; Jacobi-Matrix in mm je mm, rad und 1
index-o5 = O5 = 1 / (1/s1 + ... + 1/sm); Jacobi-Matrix in mm je mm, rad und 1
index-d = D = (s1...sm)^(1/m); Jacobi-Matrix in mm je mm, rad und 1
index-a = A = 1 / sqrt(tr((J'J)^-1)); Spalten von J durch ihre Normen über alle Kandidaten geteilt
index-e = E = smin; Spalten von J durch ihre Normen über alle Kandidaten geteilt
index-i = I = 1 / quadratischer Mittelwert der Standardunsicherheit der Position über alle Kandidaten, je mm Rauschen

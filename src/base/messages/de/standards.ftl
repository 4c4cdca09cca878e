### Meldungen von standards; Erklärungen in en/standards.ftl.

characteristic = { $name ->
        [bootstrap] Bootstrap
        [ap-interval] Intervall von AP
        [rp-interval] Intervall von RP
        [commanded-path] Sollbahn
        [exchangeability] Austauschbarkeit
        [reading-noise] Rauschen der Messwerte
        [rp-without-noise] Wiederholgenauigkeit ohne Rauschen
        [pose-repeatability] Pose-Wiederholgenauigkeit
        [reference-targets] Referenzmarken
        [error-ellipsoid] Fehlerellipsoid
        [pose-accuracy] Pose-Genauigkeit
        [coplanarity] Koplanarität
        [distance] Abstand
        [variation] Mehrfachrichtungs-Streuung der Pose-Genauigkeit
        [static-compliance] statische Nachgiebigkeit
        [path-accuracy-interval] Intervall der Bahngenauigkeit
        [path-repeatability-interval] Intervall der Bahn-Wiederholgenauigkeit
        [cornering] Eckenabweichungen
        [path-repeatability] Bahn-Wiederholgenauigkeit
        [path-accuracy] Bahngenauigkeit
        [path-velocity] Bahngeschwindigkeit
       *[drift] Drift
    }

too-few-positions = { $of }: { $count ->
        [one] 1 Istposition
       *[other] { $count } Istpositionen
    }
    .expected = mindestens { $least }
    .hint = mehr Zyklen messen

position-not-finite = { $of }: Position { $number } ist nicht endlich
    .hint = diese Position entfernen oder berichtigen

too-few-passes = { $of }: { $count ->
        [0] kein vollständiger Durchlauf
        [one] 1 vollständiger Durchlauf
       *[other] { $count } vollständige Durchläufe
    } der Bahn
    .expected = mindestens { $least }
    .hint = mehr Durchläufe der Bahn aufzeichnen

passes-of-other-path = { $of }: die Durchläufe gehören zu einer anderen Bahn
    .hint = Durchläufe mit denselben Sollpunkten suchen und auswerten

passes-need-points = Durchläufe einer Bahn brauchen zwei Sollpunkte und einen positiven Abstand
    .hint = zwei Sollpunkte und einen positiven Abstand angeben

workspace-not-box = der Arbeitsraum ist kein Quader
    .expected = kleinstes x, y, z, dann größtes

angle-count = { $option } hat { $count ->
        [one] 1 Winkel
       *[other] { $count } Winkel
    }
    .expected = { $angles }

planar-test-plane = ein ebener Roboter hat nur eine Prüfebene
    .hint = die Prüfebene weglassen

test-plane-unknown = unbekannte Prüfebene `{ $name }`
    .expected = { $planes }

standstill-thresholds = Radius und Dauer eines Stillstands müssen positiv sein
    .hint = einen Radius über dem Rauschen des stehenden Roboters und eine Dauer unter dem kürzesten Halt angeben

in-sample = Abtastwert { $sample }: { $message }

stream-too-short = eine aufgezeichnete Bewegung braucht mindestens zwei Abtastwerte mit denselben Spalten
    .hint = die Bewegung neu aufzeichnen

stream-value-missing = eine Koordinate oder die Zeit fehlt oder ist nicht endlich
    .hint = diesen Abtastwert entfernen

time-not-increasing = die Zeit nimmt nicht zu: { $later_s } s nach { $earlier_s } s
    .hint = die Zeilen nach der Zeit sortieren und doppelte entfernen oder mit feineren Zeitstempeln aufzeichnen

weave-direction = Pendeln: die Auslenkung hat keine Komponente quer zur Mittellinie
    .hint = eine Richtung quer zur Mittellinie angeben

weave-command = Pendeln: Sollhub und Sollfrequenz müssen positiv sein
    .hint = Sollhub und Sollfrequenz angeben

weave-without-samples = Pendeln: keine Abtastwerte
    .hint = prüfen, wo das Pendeln beginnt und wo es endet

weave-too-few-turns = Pendeln: { $turns ->
        [one] 1 Umkehrpunkt
       *[other] { $turns } Umkehrpunkte
    }
    .expected = mindestens fünf, um ein Viertel des Sollhubs voneinander entfernt
    .hint = eine längere Pendelbewegung aufzeichnen

corner-without-points = Eckenabweichungen: kein Sollpunkt auf der Schenkelhälfte, die an die Ecke grenzt
    .hint = mehr Sollpunkte angeben

path-without-reorientation = Bahngenauigkeit bei Umorientierung: kein Sollwinkel ändert sich entlang der Bahn
    .hint = die Sollwinkel der Bahn angeben

commanded-angle-missing = Sollbahn: ein Winkel fehlt oder ist nicht endlich
    .hint = alle Winkel an jedem Punkt angeben oder keinen

commanded-point-repeated = Sollbahn: die Punkte { $first } und { $second } sind gleich
    .hint = einen der beiden Punkte entfernen

velocity-not-positive = Bahngeschwindigkeit: die Sollgeschwindigkeit muss positiv sein
    .hint = die Sollgeschwindigkeit angeben

velocity-too-few-points = Bahngeschwindigkeit: weniger als drei Sollpunkte im mittleren Teil
    .hint = mehr Sollpunkte oder einen größeren mittleren Teil angeben

too-few-of = { $of }: { $sets }
    .expected = mindestens { $least }
    .hint = die Messungen vervollständigen

sets-of-cycles = { $count ->
        [one] 1 Satz von Zyklen
       *[other] { $count } Sätze von Zyklen
    }

poses = { $count ->
        [one] 1 Pose
       *[other] { $count } Posen
    }

approaches = { $count ->
        [one] 1 Anfahrrichtung
       *[other] { $count } Anfahrrichtungen
    }

epochs = { $count ->
        [0] keine Messung
       *[other] { $count } Messungen
    }

robots-at-other-poses = Austauschbarkeit: die Roboter haben nicht dieselben Posen
    .expected = mindestens zwei Roboter, jeder an jeder Pose

robot-without-pose = Austauschbarkeit: Roboter `{ $robot }` hat Pose { $pose } nicht angefahren
    .expected = jeder Roboter an jeder Pose

visits-read-once = Wiederholgenauigkeit ohne Rauschen: keine Anfahrt hat zwei Messwerte
    .hint = bei jeder Anfahrt mehrere Messwerte aufnehmen: sie bestimmen das Rauschen des Messgeräts

coplanar-poses-on-line = Koplanarität: drei der vier mittleren Positionen liegen auf einer Geraden
    .hint = vier Posen nennen, die eine Ebene aufspannen

distance-counts-differ = Abstand: die beiden Posen haben { $first } und { $second } Positionen
    .expected = beide Posen in denselben Zyklen

force-not-positive = statische Nachgiebigkeit: eine Kraft ist nicht positiv
    .expected = der Betrag der Kraft; ihre Richtung gibt das Vorzeichen

unloaded-position-missing = Richtung { $direction }, Zyklus { $cycle }: keine Zeile ohne Kraft
    .hint = die unbelastete Position mit Kraft 0 aufzeichnen

force-missing = keine Zeile enthält eine Kraft
    .hint = die Kraft jeder belasteten Zeile angeben

no-working-mode-reaches = kein Arbeitsmodus erreicht sie innerhalb der Grenzen

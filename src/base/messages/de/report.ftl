### Texte der Berichte; die Begriffe der ISO 9283 sind die der DIN EN ISO 9283.

accepted = angenommen
accuracy = Genauigkeit
accuracy-at-pose = Größter Wert der Pose-Genauigkeit AP: { $accuracy } µm, an Pose { $pose }.
accuracy-not-tested = Die Kampagne enthält keine Sollpositionen: Die Pose-Genauigkeit (AP) ist nicht geprüft.
accuracy-drifts = AP ändert sich während der Prüfung signifikant { $count ->
        [one] an Pose { $poses }
       *[other] an den Posen { $poses }
    }. Das Intervall dort enthält AP jedes Satzes von Zyklen: Es ist nicht das Überdeckungsintervall eines stabilen Roboters.
accuracy-of-position = Positioniergenauigkeit
accuracy-over-cycles = Pose-Genauigkeit jeder Pose im Verlauf der Prüfung.
action-label = Abhilfe:
actual-lead = tatsächliche Steigung
actuator = Antrieb
after = nachher
after-named = nachher ({ $name })
against = in Abhängigkeit von
agree = in Übereinstimmung
all-distances = alle
all-poses-conform = { $count ->
        [one] die einzige Pose ist konform
       *[other] alle { $count } Posen sind konform
    }
all-tables = Alle Tabellen
allowed = zulässig
along-path-in-mm = entlang der Bahn (mm)
amends-report = Änderung zu Bericht
and-more = und { $count } weitere
angle-ad = AD des Winkels { $axis }
angle-rd = RD des Winkels { $axis }
angle-vap = vAP des Winkels { $axis }
ap-by-set = AP je Satz
ap-of-judged-approach = AP der bewerteten Anfahrrichtung
ap-interval-from = AP, 95 % von
ap-interval-to = AP, 95 % bis
ap-within-limit = AP innerhalb des Grenzwerts
approach-not-known = Anfahrrichtung unbekannt
approaches-unknown = Pose { $pose }: { $count ->
        [one] Einer Anfahrt
       *[other] { $count } Anfahrten
    } (Zyklus { $cycles }) geht keine erfasste Pose voraus, daher ist die Anfahrrichtung unbekannt. Die Werte einer Anfahrrichtung enthalten { $count ->
        [one] diese Anfahrt nicht.
       *[other] diese Anfahrten nicht.
    }
approached = angefahren
approved-by = Freigegeben von
arc = Bogen
area = Fläche
arrivals = Ankünfte
arrivals-title = Ankünfte
arrows-common = Pfeile vorher und nachher { $factor }-fach vergrößert; der längste: { $longest }.
arrows-description = Ein Pfeil je gemessener Position: gemessene minus vorhergesagte Position, { $factor }-fach vergrößert.
arrows-longest = Pfeile { $factor }-fach vergrößert; der längste: { $longest }.
at-interval-from = AT, 95 % von
at-interval-to = AT, 95 % bis
at-location = Ort von AT
at-of-angles = AT der Winkel (deg)
at-position = { $value }, bei { $position } mm
at-rt-diamonds = Rauten: größtes AT und größtes RT mit ihren Intervallen. Das Maximum vieler streuender Werte liegt systematisch zu hoch: RT kann über dem Intervall für unendlich viele Durchläufe liegen.
at-tool-point = Am Werkzeugpunkt: { $count ->
        [one] 1 Pose
       *[other] { $count } Posen
    }
attached-accuracy = Abweichungen vorher und nachher
attached-campaign = Angaben der Kampagne
attached-cell = Koordinatensysteme der Zelle
attached-certificate = Digitaler Kalibrierschein (DCC), Entwurf
attached-changes = Änderungen zwischen Kampagnen
attached-characteristics = Kenngrößen nach ISO 9283
attached-compliance = Statische Nachgiebigkeit
attached-controllers = Dateien für die Steuerung
attached-distributions = Verteilungen der Ergebnisse
attached-geometric = Geometrische Kalibrierung
attached-parameters = Identifizierte Parameter, Kovarianz, Herkunft
attached-plan = Gewählte Posen
attached-recommendation = Empfehlung
attached-selftest = Validierung der Installation
attached-streams = Aufgezeichnete Bewegungen
attached-validation = Abweichungen vorgegebener Parameter
attached-verification = Zu prüfende Posen
attached-verified = Überprüfung
authorised-by = freigegeben durch
axis-after = nachher, { $axis }
axis-before = vorher, { $axis }
axis-commanded = Sollwert { $axis }
axis-direction = Richtung { $axis }
axis-mean = Mittel { $axis }
axis-origin = Ursprung { $axis }
axis-point = Punkt { $axis }
axis-x = x
axis-y = y
axis-z = z
ball = Kugel
bar-too-uncertain = die Unsicherheit des Kalibrierstabs ist zu groß (4:1 gefordert)
base-and-targets = Basis und Zielmarken
base-motion-explains-most = die Parameter gelten nicht mehr: eine Bewegung der Basis um { $by } (k = 2) erklärt { $percent } % der Abweichung; die verbleibenden Residuen sind größer als erwartet
base-moved = die Basis hat sich um { $by } bewegt (k = 2, im Weltkoordinatensystem)
base-rotation = Drehung der Basis
base-shift = Verschiebung der Basis
batch-ends = { $pass } bestanden, { $conditional } bedingt, { $undecided } unentschieden, { $fail } nicht bestanden, { $failed } nicht gerechnet, { $skipped } übersprungen
batch-synthetic = { $count ->
    [one] 1 Kampagne hat
   *[other] { $count } Kampagnen haben
} synthetische Daten: Niemand hat sie gemessen, und sie sind kein Nachweis über einen Roboter.
before = vorher
before-after-description = Abweichungen mit Nennparametern und nach der Kalibrierung, auf einer Achse.
before-named = vorher ({ $name })
best-possible-choice = die bestmögliche Auswahl
between-poses = zwischen den Posen
birge-ratio = Birge-Verhältnis
bootstrap-resamples = Bootstrap: { $count } Stichproben aus Posen und Zyklen.
bootstrap-without-tolerances = Das Bootstrap-Verfahren behält die Nennwerte und lässt ihre Toleranzen aus. Bei { $count ->
        [one] 1 Parameter, den
       *[other] { $count } Parametern, die
    } die Daten allein kaum bestimmen, ist u kleiner als die Hälfte des linearen Werts; der lineare Wert gilt.
both = beide
box-of-poses = Der Quader umschließt die Posen; seine Kanten sind parallel zu den Achsen.
branch-and-bound-nodes = Branch-and-Bound-Knoten
budget-left-out = U enthält nicht, weil die Kampagne keine Werte angibt: { $sources }.
budget-note = Beiträge zu den Standardunsicherheiten (k = 1), in der Einheit jeder Zeile. Die letzte Spalte ist die Wurzel ihrer Quadratsumme. Effekte, die mehreren Messwerten gemeinsam sind, gelten als korreliert.
budget-of-default-tolerances = Voreingestellte Toleranzen sind mit { $factor } multipliziert, dem Faktor, der am besten zu den Daten passt.
budget-of-errors-note = Messunsicherheit der Abweichungen in dieser Tabelle: Messwerte, Koordinatensysteme, angepasste Basis und Zielmarken. Die identifizierten Parameter sind Gegenstand der Prüfung und tragen nichts bei. Die Grenzwerte werden mit der erweiterten Messunsicherheit beurteilt, dem Doppelten dieser Werte (k = 2).
budget-of-nominal-values = Standardunsicherheit eines Nennwerts: Toleranz / √3, für eine Rechteckverteilung (GUM 4.3.7).
budget-of-parameters = Messunsicherheitsbudget der Parameter
budget-shares-description = Ein Balken je Ergebnis: Quadrate der Beiträge in Prozent der Varianz.
budget-shares-title = Anteile der Unsicherheitsquellen an der Varianz
bullet-accepted = angenommen
bullet-beyond = über dem Grenzwert
bullet-description = Jeder Wert geteilt durch seinen Grenzwert, mit { $drawn ->
        [interval] den Enden seines Intervalls. Der Schutzabstand ist der Abstand des Werts vom oberen Ende.
        [both] U (k = 2) oder den Enden seines Intervalls. Der Schutzabstand ist der Abstand des Werts vom oberen Ende.
       *[uncertainty] U (k = 2). Der Schutzabstand ist U.
    }
bullet-description-accepted = Jeder Wert geteilt durch seinen Grenzwert, mit { $drawn ->
        [interval] den Enden seines Intervalls.
        [both] U (k = 2) oder den Enden seines Intervalls.
       *[uncertainty] U (k = 2).
    }
bullet-guard-band = Schutzabstand
bullet-within-u = angenommen, um weniger als U unter dem Grenzwert: siehe Risiko
bullet-not-measured = nicht gemessen, Grenzwert { $limit } { $unit }
bullet-value = Wert
bullet-value-limit = { $value } { $unit }, Grenzwert { $limit } { $unit }
bullet-value-limit-drift = { $value } { $unit }, Grenzwert { $limit } { $unit }, AP driftet
bullet-value-limit-risk = { $value } { $unit }, Grenzwert { $limit } { $unit }, Risiko { $risk } %
by-approach = Nach Anfahrrichtung
bytes = Bytes
calibration = Kalibrierung
calibration-certificate = Kalibrierschein
calibration-certificate-draft = Entwurf eines Kalibrierscheins
calibration-of-synthetic-data = Kalibrierung mit synthetischen Daten, kein Kalibrierschein
calibration-report-of-model = Kalibrierbericht: { $model }
calibration-report-of-robot = Kalibrierbericht des Roboters { $robot }
campaign = Kampagne
campaign-as-named = Kampagne, in der angegebenen Reihenfolge
campaign-column = Kampagne
campaign-from = { $to } gegenüber { $from }
campaign-of-parameters = Kampagne der Parameter
campaign-value = Kampagne { $campaign }: { $value } { $unit }
campaigns = Kampagnen
campaigns-in-order = { $count } Kampagnen, in der angegebenen Reihenfolge
campaigns-of-robot = { $count } Kampagnen des Roboters { $robot }, in der angegebenen Reihenfolge
campaigns-of-robots = { $campaigns } Kampagnen von { $robots } Robotern
campaigns-shown = { $shown } von { $total } Kampagnen
candidate-tooltip = Pose { $pose }, { $configurations ->
        [one] 1 Konfiguration
       *[other] { $configurations } Konfigurationen
    }: x { $x }, y { $y } mm
candidates = Kandidaten
candidates-and-chosen-positions = Kandidaten und gewählte Positionen
candidates-and-configurations = { $candidates }, { $configurations } Konfigurationen
candidates-chosen = { $chosen } von { $candidates } Kandidaten sind gewählt. Die Größe einer Marke zeigt, wie viele Konfigurationen sie erreichen.
candidates-drawn = { $candidates } von { $draws } Ziehungen; ausgelassen: { $limits } außerhalb der Grenzen, { $region } außerhalb des Quaders, { $sight } abgewandt
candidates-hidden = { $count } verdeckt durch { $obstacle }
cause-column = Ursache
cell-controller-lines = Zeilen für { $maker }
cell-controller-written = Ausgabe von `--controller { $maker }`; dieselben Zahlen wie in den Tabellen.
cell-frames = Koordinatensysteme und Punkte
cell-frames-note = U: erweiterte Messunsicherheit (k = 2) jeder Koordinate und einer kleinen Drehung um x, y und z des Bezugssystems.
cell-head-frame = Koordinatensystem
cell-head-length = Länge
cell-head-measure = Größe
cell-measure-orientation = Orientierung
cell-measure-position = Position
cell-motion-by-value = Bewegung je Achswert
cell-residuals-note = Gemessen minus berechnet; Orientierungen als Rotationsvektor. p: Wahrscheinlichkeit eines mindestens so großen Residuums durch Rauschen.
cell-residuals-title = Residuen der Messwerte
cell-step-choose = Die Zeilen für die Steuerung ausgeben: den Befehl mit `--controller NAME` wiederholen.
cell-step-choose-reason = `etalon cell --help` nennt die Steuerungen; jede hat eigene Einheiten und eine eigene Reihenfolge der Winkel.
cell-step-load = Die Zeilen für { $maker } laden.
cell-step-load-reason = Vor der Produktion einen Messwert prüfen, der nicht in der Tabelle steht.
cell-step-measure = Mehr Messwerte aufnehmen.
cell-step-measure-reason = Die Messwerte haben keine Redundanz: Nichts prüft das Ergebnis.
cell-step-messages = Zuerst die Warnungen klären.
cell-step-messages-reason = Jede Warnung sagt, worauf sie sich auswirkt.
cell-subtitle = Roboterzelle, { $readings ->
        [one] ein Messwert
       *[other] { $readings } Messwerte
    }
cell-title = { $solve ->
        [tool-point] Werkzeugmittelpunkt
        [tool-reflector] Reflektor am Werkzeug
        [tool-axes] Werkzeugkoordinatensystem
        [hand-eye] Hand-Auge-Kalibrierung
        [object] Werkstückkoordinatensystem
        [three-points] Werkstückkoordinatensystem aus drei Punkten
        [linear-axis] Linearachse
       *[rotary-axis] Drehachse
    }
cell-verdict-axis = Maßstab { $scale } ± { $u } (k = 2)
cell-verdict-known = { $frame }: U = { $um } µm längs x, y, z{ $turned ->
        [no] {""}
       *[yes] {" "}und { $deg } deg um x, y, z
    } (k = 2)
cell-verdict-unknown = { $frame }: die Messunsicherheit ist unbekannt
cell-verdict-warnings = { $count ->
        [one] eine Warnung schränkt das Ergebnis ein
       *[other] { $count } Warnungen schränken das Ergebnis ein
    }
certificate-coverage = U: erweiterte Messunsicherheit, Erweiterungsfaktor k = 2, Überdeckungswahrscheinlichkeit etwa 95 % bei Normalverteilung.
certificate-computed = „Nachher“ ist mit den identifizierten Parametern aus den Gelenkwerten der Kampagne berechnet; der Roboter wurde nicht mit einer geladenen Datei gemessen. „Vorher“ ist mit den Nennparametern des Roboters berechnet; Basis, Zielmarken und Vorrichtungen sind angepasst, soweit die Kampagne sie freilässt.
certificate-controller-before = Die Steuerung hatte die Werte von `{ $file }` (SHA-256 { $sha256 }), die von den Nennwerten abweichen können.
certificate-controller-unknown = Die Werte in der Steuerung sind nicht angegeben und können von den Nennwerten abweichen.
certificate-held = Die Werte gelten gemeinsam. U setzt voraus, dass die festgehaltenen Werte exakt sind. Ein einzelner Wert ist kein Maß eines Teils des Roboters.
certificate-interval = U: erweiterte Messunsicherheit des Werts, Erweiterungsfaktor k = 2. Letzte Spalte: Abweichung des Roboters ohne das Rauschen der Messwerte, Überdeckungswahrscheinlichkeit mindestens 95 %.
certificate-no-file = Dieser Kalibrierschein nennt keine Datei zum Laden: { $reason }.
certificate-parameters = Parameter, identifiziert und festgehalten
certificate-parameters-hash = parameters.json, SHA-256
certificate-reproduction = Dieses Dokument darf nur vollständig vervielfältigt werden.
certificate-without-uncertainty = Werte ohne U oder Intervall dienen der Information: ihre Unsicherheit wurde nicht ermittelt.
chain-of-links = Die Parameter beschreiben die Kette vom Glied `{ $base }`, dem Basiskoordinatensystem, bis { $ends }.{ $count ->
        [0] {""}
       *[other] {" "}Gelenke bewegen das Glied `{ $base }`: es ist nicht die Basis einer Steuerung.
    }
change = Änderung
change-by-u = Änderung / u
change-over-u = Änderung / u
change-with-interval = Änderung ± U (k = 2)
changed = geändert
changed-below = unterhalb von { $significance } als geändert gemeldet
changes = Änderungen
check-column = Prüfung
checklist-clause = Abschnitt
checklist-field = Angabe
checklist-key = Schlüssel
checklist-keys = Schlüssel und Abschnitte
checklist-note = { $count ->
    [one] Eine Angabe fehlt. In campaign.toml ergänzen und die Kampagne erneut ausführen.
   *[other] { $count } Angaben fehlen. In campaign.toml ergänzen und die Kampagne erneut ausführen.
}
checklist-title = Vor der Unterschrift zu ergänzen
checks-of-the-model = Prüfung des Modells
checksums-of-files = Steuerungsdateien und ihre Prüfsummen
chi-square = Chi-Quadrat
choice = Auswahl
choice-gap = höchstens { $percent } % unter der bestmöglichen Auswahl
choice-proven = Bewiesen: Keine andere Auswahl von { $chosen } aus { $candidates } Kandidaten ergibt ein größeres { $index }
choice-within-percent = { $index } liegt höchstens { $percent } % unter der bestmöglichen Auswahl von { $chosen } aus { $candidates } Kandidaten
choice-without-bound = Für { $index } ist keine Schranke bekannt: Eine bessere Auswahl ist möglich
chosen = gewählt
chosen-candidate-tooltip = Pose { $pose }, { $configurations ->
        [one] 1 Konfiguration
       *[other] { $configurations } Konfigurationen
    }, gewählt: x { $x }, y { $y } mm
chosen-candidates-marks = Leere Marken: Kandidaten; gefüllte Marken mit der Nummer ihrer Pose: gewählt.
chosen-one-by-one = { $poses } Posen, { $configurations } Konfigurationen, einzeln
chosen-poses = Gewählte Posen
chosen-with-all-modes = { $poses } Posen, { $configurations } Konfigurationen, alle Arbeitsmodi einer Pose zusammen
circle = Kreis
circle-x-y = Kreis x, y
clause-compliance = statische Nachgiebigkeit
clause-cornering = Eckenabweichungen
clause-directions = Mehrfachrichtungs-Streuung der Pose-Genauigkeit
clause-distances = Abstandsgenauigkeit und Abstands-Wiederholgenauigkeit
clause-drift = Drift der Pose-Kenngrößen
clause-exchangeability = Austauschbarkeit
clause-not-tested = nicht geprüft
clause-overshoot = Pose-Überschwingen
clause-path-accuracy = Bahngenauigkeit
clause-path-repeatability = Bahn-Wiederholgenauigkeit
clause-pose-accuracy = Pose-Genauigkeit
clause-pose-repeatability = Pose-Wiederholgenauigkeit
clause-posing-time = minimale Positionierzeit
clause-reorientation = Bahngenauigkeit bei Umorientierung
clause-stabilisation = Pose-Stabilisierungszeit
clause-tested = geprüft
clause-velocity = Kenngrößen der Bahngeschwindigkeit
clause-weaving = Pendelabweichungen
clauses-evidence = Abschnitte der ISO 9283:1998: geprüft, nicht geprüft und Bestätigung der Auswertung
clauses-note = Der Bericht gilt nur für die geprüften Abschnitte. `etalon selftest` wiederholt die Vergleiche mit dem unabhängigen Programm.
clauses-summary = Geprüfte Abschnitte der ISO 9283:1998: { $tested }. Nicht geprüft: { $untested }.
clauses-title = Abschnitte der ISO 9283:1998
colours = Farben
command = Sollwert
command-theta = Sollwert θ
command-x = Sollwert x
command-y = Sollwert y
commanded-away = Sollposition, { $distance } µm entfernt
commanded-velocity = Sollgeschwindigkeit
commanded-frequency = Sollfrequenz
commanded-stroke = Sollhub
commanded-tooltip = Sollposition: x { $x }, y { $y }, z { $z } µm vom Mittel
compared-with = verglichen mit
compliance = Nachgiebigkeit
condition = Kondition
condition-number = Konditionszahl
conditional = bedingt
conditions = Bedingungen
configurations = Konfigurationen
conforming = konform
conformity-by-rule = Nach { $rule }: { $results }.
conformity-disproved = widerlegt
conformity-neither = weder nachgewiesen noch widerlegt
conformity-proved = nachgewiesen
confounded-with = nicht trennbar von
contact = Antastung
encoders = Geber
contents = Inhalt
controlled-by = kontrolliert durch
controller = Steuerung
controller-files = Steuerungsdateien
convention-angles = die Winkel a, b, c sind stetig fortgesetzt und einzeln ausgewertet; Reihenfolge der Drehungen: { $order }
convention-angles-not-drift-compensated = die Drift der Positionen ist durch die Referenzmarken korrigiert, die Drift der Winkel nicht
convention-angles-of-motion = die Winkel { $angles } sind entlang der Bewegung stetig fortgesetzt und einzeln ausgewertet
convention-angles-of-unknown-order = die Winkel a, b, c sind stetig fortgesetzt und einzeln ausgewertet; Reihenfolge der Drehungen: nicht angegeben
convention-ap-interval = AP: Intervall der Differenz, aus beiden Intervallen bestimmt (MOVER, Zou & Donner 2008)
convention-ap-rp = AP: Mittel minus Sollposition; RP: mittlerer Radius + 3 s, s mit n - 1; 95-%-Intervalle, normalverteilte Streuung
convention-approach = Anfahrt: von der vorigen Pose im Ablauf; 25-%-Regel mit U bei k = { $k }; Positionen im Weltkoordinatensystem ({ $frame })
convention-at-rt = AT: Intervall der Differenz, aus beiden Intervallen bestimmt, wie bei AP; RT: dasselbe Verfahren auf der logarithmischen Skala um die Mitten beider Intervalle, die RT für unendlich viele Durchläufe schätzen; in simulierten Prüfungen mit zehn Durchläufen enthalten die Bootstrap-Intervalle den wahren Wert je nach Art der Streuung in 90 % bis 98 % der Prüfungen statt in 95 %
convention-birge = Modellfehler: die Intervalle der Parameteränderungen sind mit dem Birge-Verhältnis (mindestens 1) aller Roboterparameter beider Kampagnen multipliziert, weil die Parameter an den gemessenen Posen Modellfehler aufnehmen
convention-change-of-parameters = Parameter: Änderung geteilt durch die Wurzel aus u1² + u2², nach der t-Verteilung mit den Freiheitsgraden von Welch, wenn die Unsicherheiten aus Residuen geschätzt sind; beide Kampagnen gelten als unabhängig
convention-compared-with = jede Kampagne ist mit der ersten und mit der vorigen verglichen, in der angegebenen Reihenfolge
convention-compliance = Nachgiebigkeit: Verschiebung in Richtung der Kraft je Krafteinheit, kleinste Quadrate durch die unbelastete Position
convention-compliance-clause = Abschnitt 10 wurde nicht mit einem gekauften Exemplar der Norm verglichen
convention-different-instruments = die Kampagnen haben verschiedene Messgeräte: ein systematischer Unterschied zwischen ihnen, den keine Streuung zeigt, erscheint als Änderung des Roboters
convention-drift-compensated = die Drift der Positionen und Orientierungen ist durch die Referenzmarken korrigiert
convention-f-test = Parameter insgesamt: F-Test; er ist eine Näherung, wenn die Unsicherheiten aus den Abweichungen der Posen geschätzt sind, und dann zu oft signifikant, wenn nur eine oder zwei Koordinaten je Pose gemessen wurden
convention-first-robot = von { $count } Robotern: alle Werte gelten für `{ $robot }`, außer der Austauschbarkeit
convention-guarded-acceptance = Konformität: Annahme mit Schutzabstand (ILAC-G8:09/2019, 4.2.3) und 95-%-Intervall: nur nachgewiesen, wenn das ganze Intervall auf einer Seite des Grenzwerts liegt
convention-interval-of-sets = AP driftet signifikant { $count ->
        [one] an Pose { $poses }
       *[other] an den Posen { $poses }
    }: das Intervall dort enthält AP jedes Satzes von Zyklen
convention-intervals-instrument = die Intervalle berücksichtigen die Stichprobe und die erweiterte Messunsicherheit einer Koordinate, { $uncertainty_um } µm (k = 2)
convention-intervals-sampling = die Intervalle berücksichtigen nur die Stichprobe: für das Messgerät ist keine Messunsicherheit angegeben
convention-limit-band = Grenzband: { $band } mm um das Mittel des Stillstands
convention-mean-errors = mittlere Abweichungen: t-Test von Welch mit einer Abweichung je Pose; konservativ (zu selten signifikant), wenn beide Kampagnen dieselben Posen gemessen haben
convention-mean-positions = mittlere Positionen: t-Test von Welch für jede Koordinate, aus der Streuung der Anfahrten; die Unsicherheit der Koordinatensysteme der Messungen ist nicht enthalten
convention-motion-clauses = die Abschnitte 7.4, 7.5, 8, 9 und 11 wurden nicht mit einem gekauften Exemplar der Norm verglichen
convention-no-commanded-poses = keine Sollposen: AP, Abstände und Drift sind nicht bestimmt (im Dokument: null)
convention-path = Bahn: Normalebenen an { $points } Sollpunkten, den Mitten gleicher Teile; je Ebene der letzte Durchgang innerhalb von { $near } mm
convention-path-corners = keine Ebene innerhalb von { $near } mm um eine Ecke (höchstens ein Viertel ihres Schenkels); die Ecke wird für sich ausgewertet
convention-path-intervals = AT und RT: Intervalle für unendlich viele Durchläufe durch parametrischen Bootstrap über die Durchläufe; in simulierten Prüfungen mit zehn Durchläufen enthalten sie den wahren Wert je nach Art der Streuung in 90 % bis 98 % der Prüfungen
convention-path-velocities = Geschwindigkeiten zwischen den Ebenen in den mittleren { $percent } % der Bahn
convention-planar = die Sollpositionen haben kein z: alle Kenngrößen außer der Koplanarität gelten in der Ebene xy
convention-positions-drift-compensated = die Drift der Positionen ist durch die Referenzmarken korrigiert
convention-readings-averaged = die Messwerte einer Anfahrt sind gemittelt; ihre Streuung ist das Rauschen des Messgeräts
convention-rotation-vectors = AP rx bis rz: Rotationsvektor von der Soll- zur mittleren Orientierung um x, y, z der Tabelle; RP rx bis rz: drei Standardabweichungen der Drehungen von der mittleren Orientierung; AD r, RD r, vAP r: Winkel zwischen Orientierungen
convention-rp-clause = RP folgt dem Text der Norm (7.2.2); die anderen Abschnitte wurden nicht mit einem gekauften Exemplar verglichen
convention-rp-ratio = RP: F-Test des Verhältnisses, mit den Freiheitsgraden des Intervalls in geschlossener Form (normalverteilte Streuung)
convention-set-up = die Parameter von Basis und Zielmarken ändern sich mit jedem Aufbau: eine Änderung dort kommt nicht unbedingt vom Roboter
convention-shared-instrument = alle Kampagnen haben dasselbe Messgerät { $instrument }: seine gleichbleibenden Abweichungen heben sich in den Änderungen auf; enthält u diese Abweichungen, sind die Unsicherheiten der Änderungen zu groß angegeben; eine Drift des Messgeräts zwischen den Kampagnen erscheint als Änderung des Roboters
convention-shared-risk = Konformität: geteiltes Risiko (JCGM 106:2012, 8.2.1): entschieden, wenn die erweiterte Messunsicherheit höchstens ein Viertel des Grenzwerts ist
convention-significance = eine Änderung ist signifikant, wenn ihr p-Wert, korrigiert für die Zahl der Größen ihrer Familie in einem Paar von Kampagnen, unter 5 % liegt: bei Parametern nach der Verteilung der größten Änderung mit ihren Kovarianzen (Westfall & Young 1993), bei anderen Größen nach Holm (1979); die 95-%-Intervalle sind nicht korrigiert
convention-simple-acceptance = Konformität: einfache Annahme (ILAC-G8:09/2019, 4.2.1)
convention-standing = Stillstand: { $duration } s oder länger innerhalb von { $radius } mm um das Mittel; eine Pose gilt innerhalb von { $near } mm als erreicht; ihre Position ist das Mittel der mittleren Hälfte des Stillstands
convention-tables = 25-%-Regel mit U bei k = { $k }; Positionen im Koordinatensystem der Tabellen
convention-times-as-stamped = Zeiten: Zeitstempel der Aufzeichnung
convention-times-by-rate = Zeiten: Abtastwerte mit der angegebenen Rate von { $rate } Hz
conventions = Konventionen
conventions-and-drift = Konventionen, Drift der Aufzeichnung
cooks-distance = Cook-Abstand
cooks-distance-description = Ein Balken je Pose der Tabelle; Posen über der Linie sind einflussreich.
cooks-distance-note = Cook-Abstand: Änderung der Parameter ohne die Pose, bezogen auf ihre Kovarianz. Eine Pose über { $limit } ist einflussreich (Median von F; Cook 1977).
cooks-distance-of-poses = Cook-Abstand der Posen
cooks-distance-tooltip = Pose { $pose }: Cook-Abstand { $distance }
coordinate = Koordinate
coordinates-of-targets = Koordinaten von Zielmarken
coordinate-uncertainty = { $uncertainty } mm (k = 1) je Koordinate
coordinate-uncertainty-in-common = { $uncertainty } mm (k = 1) je Koordinate, unabhängig für jede Beobachtung, und { $common } mm gemeinsam für alle Beobachtungen eines gemessenen Punkts
coordinates = Koordinaten
coplanarity = Koplanarität
coplanarity-of-pose = Abstand der mittleren Position von der Ebene der drei anderen
coplanarity-peak-to-valley = Koplanarität, Spitze-Tal
copy = Kopieren
corner = Ecke
corners = Ecken
correlated-pairs = Korrelation von 0,9 oder mehr: { $pairs }.
correlated-pairs-strongest = { $count } Paare haben eine Korrelation von 0,9 oder mehr. Die stärksten: { $pairs }.
correlated-with = korreliert mit
correlation-description = Eine Zelle je Paar: blau bei positiver, orange bei negativer Korrelation.
correlation-title = Korrelation der identifizierten Parameter
correlation-tooltip = { $first } und { $second }: { $correlation }
count-at-poses = { $count } an { $poses } Posen
count-of-set = { $count ->
        [one] 1 Punkt
       *[other] { $count } Punkte
    } ({ $set })
coverage-factor = Erweiterungsfaktor
curve = Kurve
curve-caption = In jedem Schritt kommt die beste Position mit allen ihren Konfigurationen hinzu.
curve-description = Kreise: Index, linke Achse. Rauten: Konditionszahl, rechte Achse.
curve-point-tooltip = { $curve }: { $value } bei { $at }
curve-singular = { $count ->
    [one] Die erste Auswahl ist singulär: Ihre Konditionszahl ist nicht gezeichnet.
   *[other] Die ersten { $count } Auswahlen sind singulär: Ihre Konditionszahlen sind nicht gezeichnet.
}
curve-title = { $index } und Konditionszahl über der Anzahl der Positionen
curve-tooltip = { $positions ->
        [one] 1 Position
       *[other] { $positions } Positionen
    }, { $configurations ->
        [one] 1 Konfiguration
       *[other] { $configurations } Konfigurationen
    }: { $index } { $value }, Kondition { $condition }
customer = Kunde
cycle = Zyklus
cycles = Zyklen
cylinder = Zylinder
date = Datum
date-column = Datum
date-not-stated = Datum: nicht angegeben
date-of-issue = Ausstellungsdatum
date-of-receipt = Eingangsdatum
decide-now = Jetzt zu entscheiden
decision-rule = Entscheidungsregel
decision-rule-by-default = Die Kampagne nennt keine Entscheidungsregel; es gilt diese Vorgabe.
decision-rule-explained = Entscheidungsregel, { $rule }: { $explanation }.
decision-rule-named = Entscheidungsregel: { $rule }.
definition = Definition
definition-ad-rd = AD: mittlerer Ist-Abstand minus Sollabstand; RD: drei Standardabweichungen des Ist-Abstands (ISO 9283:1998, 7.3).
definition-ap = AP: Abstand der mittleren Istposition von der Sollposition, mit seinen Komponenten (ISO 9283:1998, 7.2.1).
definition-ap-rp-of-angles = AP: mittlerer Istwinkel minus Sollwinkel; RP: drei Standardabweichungen; ausgewertet für jeden Winkel (ISO 9283:1998, 7.2.1 und 7.2.2).
definition-compliance = Verschiebung in Richtung der Kraft je Krafteinheit: Steigung der Ausgleichsgeraden durch die unbelastete Position (ISO 9283:1998, 10).
definition-drift = dAP und dRP: Betrag der Differenz zwischen dem ersten und dem letzten Satz von Zyklen (ISO 9283:1998, 7.6). U von dAP enthält die Streuung innerhalb der Sätze; Abweichungen, die das Messgerät wiederholt, heben sich auf. AP ist stabilisiert nach fünf aufeinanderfolgenden Änderungen von höchstens 10 % der größten Änderung: Dazu sind mindestens sieben Sätze nötig.
definition-of-errors = Definition der Abweichungen
definition-posing-time = Zeit vom Verlassen einer Pose bis zum Ende der Stabilisierung an der nächsten Pose (ISO 9283:1998, 9). U enthält die Streuung der Bewegungen und das Abtastintervall. Der geradlinige Abstand liegt zwischen den beiden Stillständen; die Bahnlänge folgt der Istbahn.
definition-quarter-rule = ISO 9283: Die erweiterte Messunsicherheit darf 25 % der geprüften Kenngröße nicht überschreiten. U ist die erweiterte Messunsicherheit einer Position (k = 2). Bei mehreren Anfahrrichtungen enthält jede Zeile die Anfahrrichtung mit dem kleinsten Wert.
definition-rp = RP: ISO 9283:1998, 7.2.2. Jede Zeile enthält nur ihre eigenen Anfahrten. Ergänzend zur Norm: RP ohne das Rauschen des Messgeräts (bei mehreren Messwerten je Anfahrt) und das Ellipsoid, das die nächste Position mit einer Wahrscheinlichkeit von 95 % enthält.
definition-stabilisation = Zeit vom ersten Eintritt in das Grenzband bis zu dem Zeitpunkt, ab dem der Roboter darin bleibt (ISO 9283:1998, 7.4 und 7.5). U enthält die Streuung der Ankünfte und das Abtastintervall; U eines Überschwingens enthält die Streuung im Stillstand.
definition-standstill-distance = Abstand des Mittels jedes Stillstands vom ersten Stillstand an derselben Pose. Ein wachsender Abstand weist auf Drift hin, ein gleichbleibender auf die Wiederholgenauigkeit.
definition-target-displacement = Verschiebung der festen Zielmarken seit ihrer ersten Messung und verbleibende Verschiebung nach Korrektur der Positionen (nicht Teil der Norm).
definition-vap = vAP: größter Abstand zwischen den mittleren Positionen zweier Anfahrrichtungen (ISO 9283:1998, 7.2.3).
degrees-of-freedom = Freiheitsgrade
degrees-of-freedom-sum = { $degrees } = { $residuals } Residuen + { $stated } angegebene Werte − { $determined } von den Daten bestimmte Parameter
detected-from = erkannt ab
detected-with-probability = Wahrscheinlichkeit der Erkennung: { $percent } %
deviation = Abweichung
deviation-along-path = Abweichung entlang der Bahn
deviation-of-mean-value = seine Standardabweichung
deviation-of-the-mean-path = Abweichung der mittleren Bahn
deviations-from-the-method = Abweichungen vom Verfahren
difference = Differenz
difference-over-u = Differenz / u
different-instruments = Verschiedene Messgeräte: { $instruments }. Ihre systematischen Unterschiede erscheinen als Änderungen.
different-models = Verschiedene Modelle: { $counts } Parameter wurden identifiziert. Die in einem Modell festgehaltenen Parameter wirken auf die übrigen.
different-set-ups = Verschiedene Aufbauten: { $differences }.
differs = verschieden
direction = Richtung
disagrees = abweichend
displacement-up-to = Verschiebung bis
distance = Abstand
distance-after-entry = Abstand von der Istpose nach dem ersten Eintritt in das Grenzband: erste Ankünfte an jeder Pose.
distance-between-poses-in-mm = Abstand der Posen (mm)
distance-error-tooltip = { $name }: { $value } µm; { $from } bis { $to } mm, { $pairs } Paare
distance-error-tooltip-u = { $name }: { $value } µm ± { $u } µm (k = 2); { $from } bis { $to } mm, { $pairs } Paare
distance-from-base-in-mm = Abstand von der Basis (mm)
distance-from-the-base = Abstand von der Basis
distance-in-mm = Abstand (mm)
distances = Abstände
distances-between-poses = Abstände zwischen Posen
distances-by-distance-description = Größe der Abweichungen von { $pairs } Abständen nach Stufen des Abstands; logarithmische Achse. Die Intervalle sind erweiterte Messunsicherheiten (k = 2).
distances-by-distance-title = Abweichungen der Abstände zwischen Posen, nach Abstand
distances-from-to = { $from } bis { $to }
distances-max = Abstände, max.
distances-rms = Abstände, RMS
distributions-of-errors = Verteilungen der Abweichungen an den Validierungsposen
distributions-of-parameters = Verteilungen der Parameter
download-csv = CSV herunterladen
download-svg = SVG herunterladen
draft-mark = ENTWURF
draws-agree = Die lineare Fortpflanzung stimmt mit { $draws } Monte-Carlo-Ziehungen für alle { $parameters } Parameter überein.
draws-differ = Die lineare Fortpflanzung und { $draws } Monte-Carlo-Ziehungen weichen bei { $differing } von { $parameters } Parametern voneinander ab (um mehr als eine halbe Einheit der zweiten Stelle der Standardunsicherheit).
draws-of-stated = Die Ziehungen erfassen die angegebenen Unsicherheiten, nicht den Modellfehler.
draws-too-few = Zu wenige Ziehungen für zwei signifikante Stellen jeder Standardunsicherheit: Anzahl erhöhen.
draws-without-model-bootstrap = Der Bootstrap erfasst den Modellfehler; die Ziehungen eines Parameters erfassen ihn, wenn sie mit dem Bootstrap übereinstimmen. Die Ziehungen der Abweichungen erfassen nur die angegebenen Unsicherheiten.
draws-without-model-both = Die Standardunsicherheiten des Berichts und der Bootstrap erfassen den Modellfehler; die Ziehungen eines Parameters erfassen ihn, wenn sie mit dem Bericht übereinstimmen. Die Ziehungen der Abweichungen erfassen nur die angegebenen Unsicherheiten.
draws-without-model-report = Die Standardunsicherheiten des Berichts erfassen den Modellfehler; die Ziehungen eines Parameters erfassen ihn, wenn sie mit dem Bericht übereinstimmen. Die Ziehungen der Abweichungen erfassen nur die angegebenen Unsicherheiten.
drift = Drift
drift-title = Drift der Pose-Genauigkeit und der Pose-Wiederholgenauigkeit
effect = Effekt
effect-at-worst-pose = Verschiebung an der empfindlichsten Pose ({ $unit })
effect-tooltip = { $name }: { $value } ± { $half } { $unit } an Pose { $pose }
effective-parameters = Effektive, nicht physikalische Parameter: { $names }. Die Residuen übersteigen die Unsicherheit des Messgeräts, und die Unsicherheit dieser Werte stammt überwiegend aus dem Modellfehler. Sie beschreiben die gemessenen Posen, können aber von den Maßen des Roboters abweichen.
effects-cross-validated = Effekte: { $folds }-fache Kreuzvalidierung an { $poses } Posen, Wiederholungen: { $repeats }
effects-description = Jeder Balken: Verschiebung des Messpunkts, der sich am stärksten bewegt, wenn der Parameter statt des Nennwerts den identifizierten Wert hat und alle anderen unverändert bleiben. { $count } von { $total } Parametern.
effects-of-all = Wirkungen aller Parameter
effects-reduce-errors = Effekte, die die Abweichungen an ausgelassenen Posen verringern: { $effects }
effects-section = Parameter nach ihrer Wirkung
effects-title = Wirkungen der Parameter
ellipsoid-semi-axes = Ellipsoid, Halbachsen
ellipsoid-semi-axis-1 = Ellipsoid, Halbachse 1
ellipsoid-semi-axis-2 = Ellipsoid, Halbachse 2
ellipsoid-semi-axis-3 = Ellipsoid, Halbachse 3
enclosing-circle-radius = Hüllkreis in x, y, Radius
enclosing-sphere-radius = Hüllkugel, Radius
end-of-report = Ende des Berichts
environment = Umgebung
error = Abweichung
error-after-in-plane = Abweichung nach der Kalibrierung: { $quantity }, { $plane }
error-after-max = Abweichung nachher, Maximum
error-after-mean = Abweichung nachher, Mittelwert
error-against = Abweichung nach der Kalibrierung: { $quantity }, über { $against }
error-at-poses = { $quantity } an { $count ->
        [one] 1 Pose
       *[other] { $count } Posen
    } ({ $set }{ $readings ->
        [0] {""}
       *[other] {", "}{ $readings } Messwerte
    }): { $before } → { $after } { $unit }.
error-axis-linear = Die Achse der Abweichung ist linear: Die größte Abweichung vor der Kalibrierung ist höchstens das { $factor }-Fache des Medians nach der Kalibrierung.
error-axis-logarithmic = Die Achse der Abweichung ist logarithmisch: Die größte Abweichung vor der Kalibrierung übersteigt das { $factor }-Fache des Medians nach der Kalibrierung.
error-before-in-plane = Abweichung vor der Kalibrierung: { $quantity }, { $plane }
error-before-max = Abweichung vorher, Maximum
error-before-mean = Abweichung vorher, Mittelwert
error-definition = Abweichung: { $error }; { $values }; Statistik über die Beträge, jede Wiederholung einzeln gezählt
error-in = Abweichung in { $quantity } ({ $unit })
error-by-pose = Abweichungen je Pose: { $quantity }
error-in-unit = Abweichung ({ $unit })
error-log = Abweichung ({ $unit }), logarithmisch
error-left-out = RMS-Abweichung an den ausgelassenen Posen: { $nominal } mm mit den Nennparametern, { $all } mm mit allen Parametern, { $recommended } mm mit den empfohlenen Parametern
error-map-description = Marken an den gemessenen Positionen: Farbe und Größe von 0 bis { $top }, vorher und nachher gleiche Skala; größte Abweichung { $largest }.
error-map-own-scale = Marken an den gemessenen Positionen: Farbe und Größe von 0 bis { $top }, Skala nur für dieses Bild; größte Abweichung { $largest }.
error-of-platform = gemessene Pose der Plattformmitte C (aus den Kugeln) minus der aus den Gelenkwerten vorhergesagten Pose; Positionen: C im Basiskoordinatensystem
error-of-positions = gemessene minus aus den Gelenkwerten vorhergesagte Position jeder Zielmarke; Positionen: Zielmarken im Weltkoordinatensystem
error-of-quantities = gemessener minus aus den Gelenkwerten vorhergesagter Wert jeder Messgröße (Abstand, Abstand von einer Fläche oder einer Aufnahme, einzelne Koordinate)
error-of-targets = gemessene minus aus den Gelenkwerten vorhergesagte Position jeder Zielmarke; Orientierung: Drehung zwischen den gemessenen und den vorhergesagten Zielmarken; Positionen: Zielmarken im Weltkoordinatensystem
error-of-tool = Abweichung: wahre Position von { $point } im Basiskoordinatensystem minus der von der Steuerung berechneten Position
error-sizes-after = Verteilung der Abweichungen nach der Kalibrierung: { $quantity }
error-sizes-before = Verteilung der Abweichungen vor der Kalibrierung: { $quantity }
error-tooltip = Pose { $pose }, Zyklus { $cycle }, { $target } ({ $set }): { $before } vorher, { $after } nachher
error-vectors-after = Abweichungsvektoren nach der Kalibrierung, { $plane }-Ebene
error-vectors-before = Abweichungsvektoren vor der Kalibrierung, { $plane }-Ebene
errors = Abweichungen
errors-against-description = Eine Marke je Abweichung: Kreise für Kalibrierposen, Rauten für Validierungsposen.
errors-before-after = Abweichungen vor → nach der Kalibrierung, Posen der { $set }:
errors-before-after-of = Abweichungen ({ $point }) vor → nach der Kalibrierung, Posen der { $set }:
errors-before-and-after = Abweichungen vorher und nachher
errors-below-axis = { $count ->
    [one] 1 kleinere Abweichung ist am unteren Rand gezeichnet.
   *[other] { $count } kleinere Abweichungen sind am unteren Rand gezeichnet.
}
errors-by-number-of-positions = Positionsabweichungen über der Anzahl der Positionen
errors-by-pose-linear = Eine Marke je Pose, Zyklus und Zielmarke; lineare Achse ({ $unit }).
errors-by-pose-logarithmic = Eine Marke je Pose, Zyklus und Zielmarke; logarithmische Achse ({ $unit }).
errors-by-set-and-pose = Abweichungen nach Gruppe und nach Pose
errors-contain-noise = Jede Abweichung enthält das Rauschen ihres Messwerts, das Mittelwert, quadratischen Mittelwert und Maximum vergrößert. Die Abweichung des Roboters ohne Rauschen liegt mit einer Wahrscheinlichkeit von mindestens 95 % unter Wert + U. Wert ± U ist nicht ihr Überdeckungsintervall.
errors-draws-confirm = Die Ziehungen bestätigen die berichtete Unsicherheit der { $errors } Abweichungen in der Tabelle der Abweichungen.
errors-draws-larger = Bei { $differing } von { $errors } Abweichungen an den Validierungsposen ist die Unsicherheit der Ziehungen größer (JCGM 101:2008, Abschnitt 8). Der lineare Wert im Bericht ist zu klein.
errors-hold-among = { $region ->
        [beyond] Einige Validierungsposen liegen außerhalb des gemessenen Bereichs; ihre Abweichungen zählen mit
       *[within] Diese Werte gelten im gemessenen Bereich
    }: Der Abstand einer Validierungspose von der nächsten Kalibrierpose ist das { $ratio }-Fache des Abstands der Kalibrierposen (Median; höchstens das { $largest }-Fache). Verschiedene Gelenkstellungen der Validierung mit einem Gelenk außerhalb seines Kalibrierbereichs: { $outside } von { $total }.
errors-not-drawn = { $count ->
        [one] 1 Abweichung, deren Position oder Wert nicht endlich ist, ist nicht gezeichnet.
       *[other] { $count } Abweichungen, deren Position oder Wert nicht endlich ist, sind nicht gezeichnet.
    }
errors-of-each-pose = Abweichungen je Pose
errors-of-noise-alone = Rauschen allein kann die größte Abweichung dieser Größen erklären: { $quantities }. Der Wert ist dann vor allem Rauschen.
errors-of-poses-drawn = { $drawn } von { $total } Abweichungen sind gezeichnet.
errors-overlaid-description = Anteile von { $count } Punkten ({ $set }); logarithmische Achse.
errors-overlaid-title = Abweichungen vorher und nachher: { $quantity }
errors-that-do-not-decide = Weitere Abweichungen
errors-with-all-parameters = Mit allen identifizierten Parametern
errors-with-file = Mit den Werten von `{ $file }`: { $set }, { $poses } Posen
example-label = Beispiel:
exchangeability = Austauschbarkeit
exchangeability-between-robots = Austauschbarkeit E = { $distance } µm: größter Abstand zwischen den mittleren Positionen zweier Roboter an derselben Pose (ISO 9283:1998, 7.7).
expanded-of = U ({ $figure })
expected = erwartet
expected-from-the-points = aus den Punkten erwartet
expected-label = erwartet:
expected-of-parameters = erwartet, Parameter (k = 1)
expected-standard = erwartet (k = 1)
expected-value = { $value }, erwartet { $expected }
expected-value-judged = { $value }, erwartet { $expected } ({ $criterion })
expanded-uncertainty-of-quantity = { $quantity }: U = { $uncertainty } { $unit } je Komponente eines Messwerts (k = 2)
expired = abgelaufen
explained = erklärt
explanations-of-messages = Erklärungen dieser Meldungen
export = Export
fail = nicht bestanden
features = Geometrieelemente
field-components = Komponenten des Felds und ihre Unsicherheit
field-deviation = Standardabweichung
field-gain = An zurückgehaltenen Posen, mit Parametern und Feld der anderen Posen, sinkt die Positionsabweichung (quadratischer Mittelwert) von { $without } auf { $with } µm. Das Feld beschreibt { $share } % der mittleren quadratischen Abweichung; die Verringerung beträgt das { $gain }-Fache ihrer Standardunsicherheit.
field-held-out-caption = Jede Pose wird aus Parametern und Feld der anderen Posen vorhergesagt (fünf Teile).
field-held-out-description = Positionsabweichungen zurückgehaltener Posen ohne und mit Residuenfeld.
field-held-out-title = Positionsabweichung zurückgehaltener Posen, ohne und mit Feld
field-inputs = abhängig von, mit gemessenem Bereich
field-note = Das Feld beschreibt Abweichungen der Gelenke, die die Parameter übrig lassen. Außerhalb der gemessenen Bereiche klingt es ab; dort gelten die Abweichungen der Parameter allein.
field-refused-because = Es wird kein Residuenfeld verwendet: { $reason }.
field-uncertainty = { $coverage } % der Koordinaten zurückgehaltener Posen liegen innerhalb von 1,96 vorhergesagten Standardunsicherheiten. Die Standardunsicherheit des Felds wird mit { $factor } multipliziert, damit sie zu diesen Abweichungen passt.
figure = Ergebnis
figure-of-set = { $quantity }, { $figure } ({ $set })
figures-of-measurement-point = Alle Werte beziehen sich auf den Messpunkt: { $point }.
figures-with-field = Die Abweichungen „nachher“ schließen das Feld ein.
figures-without-field = Die anderen Werte dieses Berichts gelten ohne das Feld.
file = Datei
file-with-hash = { $file }, SHA-256 { $sha256 }
filter = Filter
filter-rows = Zeilen filtern
first-cycle = erster Zyklus
fit = Anpassung
fit-and-observability = Anpassung und Beobachtbarkeit
first-set = { $symbol }, erster Satz
fits = Anpassungen
fixed-in-the-world = Im Weltkoordinatensystem feste Elemente
folder = Ordner
folds-over-u = Standardabweichung der Teilmengen / u
force-up-to = Kraft bis
formats = Formate
formats-without-all-parameters = Diese Formate können nicht alle identifizierten Parameter aufnehmen. Ihre Dateien enthalten eine zweite Identifikation, bei der die übrigen Parameter auf ihren Nennwerten festgehalten sind. Positionsabweichungen: RMS und Maximum.
formulas-of-characteristics = Kenngrößen: nach ISO 9283:1998, von der nur der Text von 7.2.2 verglichen wurde
formulas-of-identification = Koordinatensysteme und Identifikation: gewichtete kleinste Quadrate, verglichen mit den Tabellen einer Dissertation über einen PreXYT-Tisch und einen Fünfgelenkroboter (A. Joubair, ÉTS Montréal 2012, Kapitel 1 bis 4)
formulas-of-uncertainties = Unsicherheiten: nach JCGM 100:2008 und JCGM 101:2008
frame-as-exported = die Koordinaten der Exporte sind im Weltkoordinatensystem angegeben
frame-from-plane = xy-Ebene: Geometrieelement `{ $plane }`; Ursprung: `{ $origin }`; { $axis }-Achse: von `{ $from }` nach `{ $to }`; andere Achse in Richtung `{ $towards }`
frame-of-recording = Koordinatensystem der Aufzeichnung
frame-of-reference-targets = Koordinatensystem der Tabellen bei der ersten Messung der Referenzmarken
frame-of-tables = Koordinatensystem der Tabellen
frame-sentence = Koordinatensystem der Positionen: { $frame }.
frame-from-targets = Anpassung an die Zielmarken { $targets }: Ursprung in der ersten Zielmarke, x-Achse zur zweiten, die dritte in der xy-Ebene
frame-from-targets-each = Anpassung an die Zielmarken { $targets }, an jeder Pose neu gemessen: Ursprung in der ersten Zielmarke, x-Achse zur zweiten, die dritte in der xy-Ebene
frames-and-features = Koordinatensysteme und Geometrieelemente
frames-of-poses = Koordinatensysteme der Posen
from = von
from-cycle-on = ab Zyklus
from-data = aus den Daten
from-distance = von
from-in-unit = von ({ $unit })
from-nominal-value = überwiegend aus dem Nennwert
from-pose = von Pose
from-pose-named = von Pose { $pose }
from-residuals = aus den Residuen (als unabhängig behandelt)
from-residuals-by-pose = aus den Residuen, nach Posen gruppiert
from-residuals-by-region = der effektiven Parameter, aus der Streuung zwischen Bereichen des Arbeitsraums{ $series ->
        [0] ; Unterschiede zwischen Aufbauten sind nicht enthalten
       *[other] { " " }und zwischen { $series } Serien; { $percent ->
            [0] kein Unterschied darüber hinaus ist nachweisbar
           *[other] diese tragen { $percent } % der Varianzen bei
        }
    }
from-the-instrument = aus der angegebenen Unsicherheit
gain-over-u = Verringerung / u
generated-candidates = erzeugte Kandidaten
geometric = geometrisch
geometric-definition = Dissertation, Kapitel 2: Jede Größe ist an eigens dafür gemessene Punkte angepasst, ohne Optimierung des Robotermodells; gamma, beta und epsilon_theta sind auf null gesetzt; d3 ist um die Steigungen der Antriebe 2 und 3 korrigiert. Unsicherheiten: aus den Punkten, fortgepflanzt durch alle Anpassungen und Koordinatensysteme; aus den Residuen, wo deren Streuung die angegebene Unsicherheit des Messgeräts übersteigt. Abweichungen: Mittel aus gemessener minus vorhergesagter Pose, nominal und geometrisch, im geometrisch bestimmten Basiskoordinatensystem
geometric-u-note = u (k = 1) enthält die Unsicherheit des Basiskoordinatensystems. Sie ist allen Wiederholungen gemeinsam und daher nicht in deren Standardabweichung enthalten.
geometric-u-without-angles = gamma, beta und epsilon_theta gelten als null. u von s, d und d3 enthält die Verschiebungen durch diese Winkel nicht: sie sind nicht identifiziert und haben nicht alle eine angegebene Toleranz.
geometric-u-with-angles = gamma, beta und epsilon_theta gelten als null. u von s, d und d3 enthält die Verschiebungen durch ihre identifizierten Werte oder angegebenen Toleranzen (GUM F.2.4.5).
geometry-alone = Geometrie allein
geometry-alone-title = Messungen mit Geometrie allein
geometry-beside-identification = Geometrie allein, im Vergleich mit der Identifikation
geometry-improvement = Die größte mittlere Positionsabweichung sinkt durch Geometrie allein von { $nominal } mm auf { $geometric } mm: Faktor { $improvement }.
guarded-acceptance = Annahme mit Schutzabstand (ILAC-G8:09/2019, 4.2.3)
guarded-acceptance-explained = bestanden, wenn der Wert zuzüglich seiner erweiterten Messunsicherheit U den Grenzwert einhält; nicht bestanden, wenn der Wert abzüglich U ihn überschreitet; sonst unentschieden
head-along = entlang
head-and = und
head-between = zwischen
head-characteristic = Kenngröße
head-clause = Abschnitt
head-column = Spalte
head-commanded = Sollwert
head-duration = Dauer
head-exchangeability = Austauschbarkeit
head-expanded-uncertainty = erweiterte Messunsicherheit
head-family = Gruppe
head-frequency = Frequenz
head-hint = Hinweis
head-labels = Bezeichnungen
head-meaning = Bedeutung
head-passes = Durchläufe
head-refused = abgelehnt
head-samples = Abtastwerte
head-severity = Schweregrad
head-stroke = Hub
hash-without-backup = SHA-256 von `{ $file }` ohne die Zeile `controller_backup`: der Rückweg ändert die Ergebnisse nicht.
head-u-by-angles = davon Winkel
head-residual-over-u = Residuum / u
head-identified-minus-stated = identifiziert minus angegeben
head-stated-value = angegebener Wert
head-stated-u = angegebenes u (k = 1)
head-values = Werte
head-symbols = Formelzeichen
head-tested = dieser Bericht
head-u-nominal = u des Nennwerts
head-without-noise = ohne Rauschen, 95 %
head-verified = Auswertung bestätigt durch
head-what = Gegenstand
held = festgehalten
held-by-the-campaign = von der Kampagne festgehalten
held-not-identifiable = festgehalten: nicht getrennt identifizierbar
held-singular-values = Rauten: die { $count } kleinsten Singulärwerte mit allen Parametern; ebenso viele Parameter sind festgehalten. Richtungen auf oder unter der Linie (das { $cut }-Fache des größten) sind unbeobachtbar; Richtungen knapp darüber sind kaum beobachtbar.
hint-label = Hinweis:
histogram-description = Anteil der Punkte jeder Gruppe in Schritten von { $step }.
histogram-shares = Anteil jeder Gruppe in Schritten von { $step }: { $totals }.
histogram-tooltip = { $from } bis { $to } { $unit }: { $points ->
        [one] 1 Punkt
       *[other] { $points } Punkte
    } ({ $set }), { $percent } %
how-changes-are-judged = Entscheidungsregel für Änderungen
how-many-and-where = Anzahl und Lage der Positionen
identification-against-geometry = Die Identifikation aller Parameter aus derselben Kampagne ergibt { $identified } mm; mit Geometrie allein bleibt das { $ratio }-Fache.
identification-ended = Die Identifikation ist fehlgeschlagen: { $reason }.
identified = identifiziert
identified-max = identifiziert, max.
identified-minus-geometric = identifiziert − geometrisch
identified-minus-nominal = identifiziert minus nominal
identified-minus-nominal-in = identifiziert minus nominal ({ $unit })
identified-minus-true = identifiziert − wahr
identified-minus-true-in = identifiziert minus wahr ({ $unit })
identified-rms = identifiziert, RMS
import = Import
in-space = im Raum
index = Index
index-value-of-poses = { $index } = { $value }, Posen { $poses }
influential = einflussreich
instrument = Messgerät
instrument-calibration = Kalibrierung des Messgeräts
instrument-expanded-uncertainty = erweiterte Messunsicherheit des Messgeräts
instrument-good-enough = Eignung des Messgeräts
instrument-good-for-all = Geeignet: Die Messunsicherheit der Positionen übersteigt an keiner Pose 25 % von { $tested ->
        [repeatability] RP
       *[accuracy] AP und RP
    }.
instrument-good-for-none = Die Messunsicherheit übersteigt an jeder Pose 25 % von { $tested ->
        [repeatability] RP: RP enthält
       *[accuracy] AP oder RP; wo sie 25 % von RP übersteigt, enthält RP
    } viel Rauschen des Messgeräts.
in-the-laboratory = im Laboratorium
instrument-good-for-some = Die Messunsicherheit übersteigt 25 % von { $tested ->
        [repeatability] RP
       *[accuracy] AP oder RP
    } an den Posen { $poor }; wo sie 25 % von RP übersteigt, enthält RP viel Rauschen des Messgeräts. Geeignet an den Posen: { $good }.
left-out-feature = Geometrieelement `{ $feature }`, ohne redundanten Punkt gemessen
left-out-scale = Maßstab des Messsystems (`expanded_scale_uncertainty_um_per_m`)
left-out-temperature = Wärmedehnung von Roboter und Teil ([expansion])
left-out-temperature-of-part = Wärmedehnung des Bezugs der Koordinaten ([expansion])
moved-base = Basis
orientations-without-quarter-rule = Die Messunsicherheit der Orientierungen wird nicht ausgewertet.
instrument-uncertainty = Unsicherheit des Messgeräts
instrument-uncertainty-of-position = U = { $uncertainty } µm für eine Position
instrument-uncertainty-with-k = U = { $uncertainty } µm je Koordinate (k = { $k })
instrument-uncertainty-without-k = U = { $uncertainty } µm je Koordinate (Erweiterungsfaktor nicht angegeben)
interval-95 = 95-%-Intervall
interval-from = 95 % von
interval-of = Intervall für
interval-to = 95 % bis
intervals-caption = Identifiziert minus nominal. Der Strich durch eine Marke stellt ± 2u dar und ist oft kürzer als die Marke. Werte: siehe Tabelle oben.
intervals-description = Eine Marke je identifiziertem Parameter: identifiziert minus nominal; Strich: ± 2u.
intervals-of-95 = 95-%-Intervalle.
intervals-of-ratios-title = { $group }: Änderung der Verhältnisse, ± 2u
intervals-title = { $group }: Änderung ({ $unit }), ± 2u
iso9283-characteristics = Ergebnisse: Leistungskenngrößen (ISO 9283)
iso9283-report = Prüfbericht nach ISO 9283:1998: { $characteristics }
item-customer-traceability = Gegenstand, Kunde, Rückführbarkeit
joint-motion-explains-most = die Parameter gelten nicht mehr: eine Verschiebung des Nullpunkts von Gelenk { $joint } um { $by } (k = 2) erklärt { $percent } % der Abweichung; die verbleibenden Residuen sind größer als erwartet
joint-zero-moved = der Nullpunkt von Gelenk { $joint } hat sich verschoben: wahrer minus protokollierter Wert { $by } (k = 2)
joints = Gelenke
kind = Art
knee-at = Knie: { $count }
knee-caption = Knie: Punkt der Kurve, der am weitesten über der Geraden durch ihren ersten und letzten Wert liegt.
known-points = bekannte Punkte
known-values-note = Jeder Wert zählt wie ein Messwert. Ist keine Koordinate gemessen, bestimmen die Längen den Maßstab.
known-values-title = Bekannte Längen und Positionen
joint-value = Gelenkwert
laboratory = Labor
lack-of-fit = Streuung der Wiederholungen: { $repeats } µm je Koordinate ({ $degrees_of_freedom } Freiheitsgrade). Modellfehler darüber hinaus: { $model } µm je Pose (F-Test auf mangelnde Anpassung: { $probability }).
largest = größter Beitrag
largest-displacement = größte Verschiebung
largest-distance = größter Abstand
largest-error = größte Abweichung
largest-error-drawn = `max` ist die Abweichung des Messwerts mit der größten Abweichung in den Daten. Jede Ziehung misst diesen Messwert neu. „in Übereinstimmung“ ist „nein“, wenn die Unsicherheit der Ziehungen größer ist.
largest-errors-drawn = An jeder der { $places } Positionen ist die größte Abweichung gezeichnet (von { $total } Abweichungen).
largest-errors-of-poses = Abweichungen je Pose, die größten zuerst
largest-mean-deviation-from-linear = größte mittlere Linearitätsabweichung
largest-of-all-modes = größte aller Arbeitsmodi
largest-residual-of-a-coordinate = größtes Residuum einer Koordinate
last-set = { $symbol }, letzter Satz
last-cycle = letzter Zyklus
leads = Spindelsteigungen
left = verbleibend
left-out-errors = Ausgelassene Posen
left-out-rms = ausgelassene Posen, RMS
left-rms = verbleibend, RMS
length = Länge
limit = Grenzwert
limit-accuracy-max = größter Wert der Pose-Genauigkeit AP
limit-band-value = Das Grenzband beträgt { $value } µm.
limit-contact-max = größter Abstand von einer Aufnahme
limit-coordinate-max = größte Koordinatenabweichung
limit-distance-max = größte Abstandsabweichung
limit-exceeded-sentence = Grenzwert { $limit } µm überschritten.
limit-kept-sentence = Grenzwert { $limit } µm eingehalten.
limit-margin = Reserve { $margin } { $unit }, Risiko einer falschen Annahme { $risk } %
limit-margin-without-uncertainty = Reserve { $margin } { $unit }, Unsicherheit unbekannt
limit-met-sentence = Der Grenzwert der Kampagne ist eingehalten.
limit-not-met-sentence = Der Grenzwert der Kampagne ist nicht eingehalten.
limit-of = Grenzwert: { $quantity } { $value } { $unit }
limit-orientation-max = größte Orientierungsabweichung
limit-position-max = größte Positionsabweichung
limit-position-mean = mittlere Positionsabweichung
limit-position-rms = Positionsabweichung, RMS
limit-repeatability-max = größter Wert der Pose-Wiederholgenauigkeit RP
limit-surface-max = größter Abstand von einer Fläche
limit-undecided-sentence = Grenzwert: { $limit } µm.
limited-error = { $quantity } an { $count ->
        [one] 1 Pose
       *[other] { $count } Posen
    } ({ $set }{ $readings ->
        [0] {""}
       *[other] {", "}{ $readings } Messwerte
    }): { $before } → { $after } { $unit }, Grenzwert { $limit } { $unit }: { $verdict }
limits = Grenzwerte
limits-all-met = Alle { $count } Grenzwerte der Kampagne sind eingehalten.
limits-are-of-file = Bewertet mit den Werten von `{ $file }`.
limits-by-interval = Ein Wert mit einem Intervall wird nach den Grenzen des Intervalls statt nach U bewertet.
limits-both-met = Beide Grenzwerte der Kampagne sind eingehalten.
limits-not-assessable = Nicht beurteilbar (Größe nicht gemessen): { $limits }.
limits-not-met = { $count ->
    [one] 1 von { $total } Grenzwerten der Kampagne ist nicht eingehalten.
   *[other] { $count } von { $total } Grenzwerten der Kampagne sind nicht eingehalten.
}
limits-specification = Spezifikation der Grenzwerte
limits-undecided = Unentschieden (Grenzwert innerhalb der Unsicherheit): { $limits }.
line = Zeile
line-number = Zeile { $line }
load = Last
load-centre = Lastschwerpunkt (ab der mechanischen Schnittstelle)
load-sentence = Last: { $load } kg.
log = Protokoll
logo-of-the-laboratory = Logo des Labors
manufacturer = Hersteller
margin = Reserve
max = max.
max-after = max. nachher
max-before = max. vorher
mean = Mittel
mean-deviation-from-linear = mittlere Abweichung von der Geraden
mean-distance-from-barycentre = mittlerer Abstand vom Schwerpunkt
mean-distance-from-mean = mittlerer Abstand von der mittleren Position
mean-error = mittlere Abweichung
mean-error-named = Mittlere Abweichung: { $name }
mean-error-of-set = { $quantity }, { $when } (Posen: { $set })
mean-from-overall-mean = Abstand ihres Mittels vom Gesamtmittel (µm)
mean-from-plane = mittlere Position von der Ebene der anderen drei
mean-of = { $quantity }, Mittel
mean-of-attained-positions = Mittel der Istpositionen.
mean-of-axis = Mittel { $axis }
mean-of-identifications = Mittel aus { $runs } Identifikationen. Werte: siehe Tabelle oben.
mean-plus-3s = Mittel + 3 s
mean-plus-3s-of-distance = Mittel + 3 s des Abstands von der mittleren Position (µm)
mean-positions = Mittlere Positionen
mean-positions-changed = Die mittleren Positionen haben sich geändert: durch den Roboter oder durch die Bestimmung seines Koordinatensystems.
mean-radius-plus-3s = mittlerer Radius + 3 s der Durchläufe
mean-radius-three-s = mittlerer Radius + 3 s
mean-tooltip = Mittel { $approach }: x { $x }, y { $y }, z { $z } µm
mean-velocity = mittlere Geschwindigkeit
meaning-and-sign = Bedeutung und Vorzeichen
meanings-title = Bedeutung der Parameter
measured = gemessen
measured-minus-predicted-in = gemessen minus vorhergesagt ({ $unit })
measured-values = { $count } Messwerte (mm)
measurement-dates = Datum der Messungen
measurement-place = Ort der Messungen
measurement-point = Messpunkt
measuring-order = Reihenfolge der Messung
met = eingehalten
method = Verfahren
method-identification = Identifikation der kinematischen Parameter ({ $model }) nach der Methode der kleinsten Quadrate
method-iso9283 = Leistungsprüfung nach ISO 9283:1998
method-iterations = { $method }, { $iterations ->
        [one] 1 Iteration
       *[other] { $iterations } Iterationen
    };
minimum-posing-time = Minimale Positionierzeit
mode-count = { $count ->
    [one] 1 Modus
   *[other] { $count } Modi
}
model = Modell
model-and-residuals = Die Residuen betragen das { $ratio }-Fache des Werts, der aus { $uncertainty } zu erwarten ist: { $fit ->
        [incomplete] Das Modell ist unvollständig
        [correlated] Das Modell lässt Abweichungen übrig, die den Messwerten einer Pose gemeinsam sind
        [doubtful] Das Modell ist möglicherweise unvollständig
        [lacking] Dem Modell fehlt ein Effekt, den zurückgehaltene Posen bestätigen
       *[fits] Das Modell passt
    } ({ $criterion }).
model-criterion = Chi-Quadrat: { $p }, Grenze { $limit }
model-delta = Delta-Roboter
model-delta-linear = Linear-Delta-Roboter
model-five-bar = Fünfgelenk
model-hexapod = Hexapod
model-of-the-robot = Modell des Roboters
model-prexyt = PreXYT-Tisch
model-serial = serieller Arm
model-urdf = durch eine URDF-Datei beschriebener Arm
more-in-annex = { $count ->
    [one] 1 weitere Meldung: siehe Anhang.
   *[other] { $count } weitere Meldungen: siehe Anhang.
}
more-warnings-and-remarks = Weitere Warnungen und Bemerkungen
more-without-picture = { $count ->
    [one] 1 weitere Größe ohne Bild: siehe Tabellen.
   *[other] { $count } weitere Größen ohne Bild: siehe Tabellen.
}
motion = Bewegung
mounting = Aufstellung
moved = Bewegung
movement = Bewegung
movement-of-the-set-up = Bewegung des Aufbaus
moves = Bewegungen
multiples-description = { $plane }, um den Schwerpunkt, alle Posen in einem Maßstab (halbe Breite { $half } µm). { $count } von { $total } Posen.
multiples-title = Anfahrten der Posen
name = Name
name-date-signature = Name, Datum, Unterschrift
named-from = zugeordnet ab
naming-probability = Wahrscheinlichkeit, dass das bewegte Gelenk erkannt wird: { $percent } %.
needed = nötig
next-step = nächster Schritt { $number }
next-steps = Nächste Schritte
no = nein
no-certificate-stated = kein Kalibrierschein angegeben
no-correlated-pairs = Kein Paar hat eine Korrelation von 0,9 oder mehr.
no-error-to-draw = Keine Abweichungen zu zeichnen.
no-errors-are-given = Das Dokument enthält keine Abweichungen.
no-messages = Keine.
no-messages-but-routine = Keine, die die Ergebnisse einschränken. Der Anhang des Berichts enthält { $count ->
        [one] einen weiteren Hinweis
       *[other] { $count } weitere Hinweise
    }.
no-noise-stated = kein Rauschen angegeben
no-quantity-changed = Signifikante Änderungen: 0 von { $total } Größen des Roboters.
no-significant-change = keine signifikante Änderung
no-significant-change-sentence = Keine signifikante Änderung.
no-trend-pictures = { $others ->
        [yes] Abweichungen über den anderen Gelenkwerten und Abständen
       *[no] Abweichungen über Gelenkwerten und Abstand
    }: kein signifikanter Trend
no-uncertainty-is-known = die Unsicherheit ist unbekannt
noise = Rauschen
noise-of-reading-x = Rauschen eines Messwerts, x
noise-of-reading-y = Rauschen eines Messwerts, y
noise-of-reading-z = Rauschen eines Messwerts, z
nominal = nominal
nominal-lead = Nennsteigung
nominal-max = nominal, max.
nominal-minus-identified = nominal minus identifiziert
nominal-parameters = nominal
nominal-rms = nominal, RMS
nominal-values = Nennwerte
none = keine
norm = Betrag
normal-quantile = Quantil der Normalverteilung
not-accepted = nicht angenommen
not-assessable = nicht beurteilbar
not-by-these-poses = mit diesen Posen nicht beobachtbar
not-conforming = nicht konform
not-controlled-by-the-data = Fehler, die die Daten nicht aufdecken können
not-detectable = nicht aufdeckbar
not-identifiable = nicht identifizierbar
not-judged-by-misfit = nicht beurteilt: das Modell passt nicht
not-known = unbekannt
not-met = nicht eingehalten
not-run = nicht gerechnet
not-stated = nicht angegeben
nothing-to-load = { $answer ->
        [keep_nominal] die identifizierten Parameter sind nicht deutlich besser als die Nennparameter
        [identify_further] mit weiteren Effekten sind die Fehler an zurückgehaltenen Posen um mehr als 5 % kleiner
       *[resolve] nach der Bewertung darf keine Datei geladen werden
    }
not-stated-items = Nicht angegeben, neben den vor der Unterschrift zu ergänzenden Feldern: { $items }.
notes = Bemerkungen
nothing-held = Kein Parameter ist festgehalten: Der Abstand jeder Spalte von der linearen Hülle der anderen übersteigt die Rangschwelle { $cut }.
nothing-to-verify = nichts zu prüfen
number = Nummer
numbers-of-arrows = Werte der { $count } Pfeile
numbers-of-the-curve = Werte der Kurve
numbers-of-this-picture = Werte dieses Bildes
observability = Beobachtbarkeit
observability-scaling = O1 bis O5: ungewichtete Jacobi-Matrix (mm je mm, rad und 1); Konditionszahl: Spalten auf Norm 1 skaliert
observability-scaling-eliminated = O1 bis O5: ungewichtete Jacobi-Matrix (mm je mm, rad und 1); Konditionszahl: Spalten auf Norm 1 skaliert; { $parameters } Parameter, nach Elimination der { $coordinates } Koordinaten unbekannter Punkte
observations = Beobachtungen
off-the-line = Abstand von der Geraden
one-after-the-other = nacheinander
one-scale = gemeinsame Skala
operator = Prüfer
operator-sheet = Blatt für die Messung
operator-sheet-before = Vor der ersten Pose
operator-sheet-note = Gelenkwerte der Steuerung (deg, mm). Jede Pose abhaken, sobald ihre Punkte unter ihrer Bezeichnung gespeichert sind.
operator-sheet-poses = Posen in der Reihenfolge der Messung
order-of-poses = { $poses } ({ $percent } % der Gelenkbewegung in der Reihenfolge ihrer Namen)
order-of-the-measurement = Reihenfolge der Messung
orientation = Orientierung
orientation-after = nachher, Orientierung
orientation-after-max = Orientierung nachher, max.
orientation-before = vorher, Orientierung
orientation-before-max = Orientierung vorher, max.
orientation-error-by-pose = Orientierungsabweichung je Pose, vor und nach der Kalibrierung
orientation-error-in = Orientierungsabweichung ({ $unit })
orientation-max = Orientierung, max.
orientation-title = Orientierung
origin-in-the-exports = Ursprung in den Exporten
other-planes = Weitere Ansichten
other-pose = andere Pose
outliers-note = Farbige Zahlen: Ausreißer (modifizierter z-Wert über 3,5; Iglewicz und Hoaglin, 1993). Bezug: die Kampagnen desselben Roboters oder, wenn dieser weniger als acht hat, die Kampagnen von Robotern derselben Bauart.
outliers-then-largest-errors = Abweichungen je Pose: Ausreißer, dann die größten
overshoot = Überschwingen
overshoot-co = Überschwingen CO
own-scale-of-each = eigene Skalen
p-of-family = p der Familie
p-value = p-Wert
page-of = Seite { $page } von { $total }
pairs = Paare
parameter = Parameter
parameter-errors-description = Ein Balken je Parameter: identifiziert minus wahr.
parameter-errors-title = Abweichungen der identifizierten Parameter ({ $unit })
parameter-named = Parameter { $name }
parameters = Parameter
parameters-implausible = Diese Parameter sind für den Roboter unplausibel: nicht laden.
parameters-left-out = weggelassene Parameter
one-pose-deviates = eine Pose (`{ $pose }`) widerspricht den Parametern; ohne diese Pose sind die Parameter gültig
parameters-no-longer-valid = die Parameter gelten nicht mehr; keine Bewegung der Basis, eines einzelnen Gelenks oder einer einzelnen Zielmarke erklärt die Abweichung
parameters-note = u: Standardunsicherheit (k = 1); U = 2u: erweiterte Messunsicherheit. Die Werte sind auf die zweite Stelle von u gerundet. „Vorher“: Nur Basis und Zielmarken sind angepasst. Änderung: identifiziert minus nominal.
parameters-of-robot = Parameter des Roboters
parameters-of-set-up = Parameter von Basis und Zielmarken
parameters-of-the-answer = der Antwort
parameters-of-the-run = des Laufs
parameters-still-valid = die Parameter gelten für diese Posen noch
parameters-title = Parameter
pass = bestanden
path = Bahn
path-accuracy-at = Bahngenauigkeit AT
path-accuracy-at-reorientation = Bahngenauigkeit AT bei Umorientierung
path-accuracy-title = Bahngenauigkeit AT
path-passes = { $length } mm, { $passes ->
        [one] 1 Durchlauf
       *[other] { $passes } Durchläufe
    }
path-passes-incomplete = { $length } mm, { $passes ->
        [one] 1 Durchlauf
       *[other] { $passes } Durchläufe
    }, { $incomplete } unvollständig
path-repeatability-rt = Bahn-Wiederholgenauigkeit RT
path-repeatability-title = Bahn-Wiederholgenauigkeit RT
path-velocity = Bahngeschwindigkeit
path-length = Bahnlänge
percent-of-rated = { $percent } % der Nenngeschwindigkeit
perhaps-changed = unsicher, erneut messen: Die Residuen eines unveränderten Roboters sind bei { FIXED($percent, 1) } % aller Überprüfungen so groß. Beste Erklärung: { $meaning }
permissible = Fehlergrenze
permissible-over-certificate = Fehlergrenze / Unsicherheit des Kalibrierscheins
picture-marks = Kreise: Kalibrierposen; Rauten: Validierungsposen. Den Mauszeiger auf eine Marke setzen, um Pose, Zyklus, Zielmarke und Abweichung zu lesen; ein Klick markiert die Pose in allen Bildern. Werte: siehe die Tabellen.
picture-page-command = `etalon view ORDNER --export view.html` schreibt eine Seite, die die Abweichungen räumlich zeigt und sich ohne das Programm öffnet.
picture-selection = Von vielen Abweichungen zeigen die Bilder die größte jeder Pose nach der Kalibrierung: zuerst Validierungsposen, dann eine gleichmäßige Auswahl der Kalibrierposen.
pictures = Bilder
pictures-of-thesis = Bilder (Dissertation, Bilder 4.8 und 4.9)
place-of-the-base = Lage der Basis
placed-by-validation-poses = durch Validierungsposen bestimmt
places-of-the-targets = Lage der Zielmarken
plan-better-than = Posen { $poses }: { $value } (der Plan ist { $percent } % besser)
plan-for-model = Kalibrierplan: { $model }
plane = Ebene
plane-named = { $plane }-Ebene
platform-as-measured = Plattformmitte (aus den Kugeln)
platform-centre = Plattformmitte C
platform-in-base = der Plattformmitte C im Basiskoordinatensystem
plot-ap-rp = AP und RP jeder Pose in mm
plot-changes = Änderung jedes Parameters geteilt durch ihre Standardunsicherheit
plot-errors-by-pose = Größte Positionsabweichung jeder Pose in mm
point = Punkt
point-error-in-common = die Abweichung des Messgeräts an einem Punkt ist allen Beobachtungen dieses Punkts gemeinsam
point-in-flange = Punkt { $point } mm im Flanschkoordinatensystem
point-in-platform = Punkt { $point } mm im Plattformkoordinatensystem
point-in-targets = Punkt { $point } mm im Koordinatensystem der Zielmarken
points = Punkte
points-drawn = { $drawn } von { $total } Punkten sind gezeichnet: eine gleichmäßige Auswahl einschließlich der größten Abweichung in dieser Ebene.
points-of = { $set }, Punkte
pose = Pose
pose-accuracy-ap = Pose-Genauigkeit AP
pose-and-visit = Pose { $pose }, Anfahrt { $visit }
pose-conforms = Pose { $pose } ist konform
pose-coordinates = { $count } Posekoordinaten (mm und rad)
pose-named = Pose { $pose }
pose-repeatability-rp = Pose-Wiederholgenauigkeit RP
pose-tooltip = Pose { $pose }: x { $x }, y { $y }, z { $z } mm
poses-and-cycles = Posen und Zyklen
poses-and-visits = { $poses } Posen, je { $visits ->
        [one] 1 Anfahrt
       *[other] { $visits } Anfahrten
    }
poses-conform = { $count ->
    [one] 1 von { $total } Posen ist konform
   *[other] { $count } von { $total } Posen sind konform
}
poses-not-conforming = { $count ->
    [one] Pose { $poses } ist nicht konform
   *[other] die Posen { $poses } sind nicht konform
}
poses-of-the-test = Prüfposen
poses-that-decide = Entscheidende Posen
poses-title = Posen
poses-to-measure = Zu messende Posen
poses-to-measure-named = Zu messende Posen: { $poses }.
poses-to-verify-identified-parameters = Posen zur Überprüfung identifizierter Parameter
poses-undecided = { $count ->
    [one] Pose { $poses } ist unentschieden
   *[other] die Posen { $poses } sind unentschieden
}
posing-time = Positionierzeit
position = Position
position-after-max = Position nachher, max.
position-after-mean = Position nachher, Mittel
position-before-max = Position vorher, max.
position-before-mean = Position vorher, Mittel
position-error-after = Positionsabweichung nach der Kalibrierung, { $plane }
position-error-against = Positionsabweichung nach der Kalibrierung über { $quantity }
position-error-before = Positionsabweichung vor der Kalibrierung, { $plane }
position-error-by-pose = Positionsabweichung je Pose, vor und nach der Kalibrierung
position-error-in = Positionsabweichung ({ $unit })
position-max = Position, max.
position-residuals-before-rms = Positionsresiduen vor der Identifikation, RMS
position-residuals-expected-rms = aus den angegebenen Unsicherheiten erwartete Positionsresiduen, RMS
position-residuals-explained = Positionsresiduen: RMS { $rms } { $unit }; aus den angegebenen Unsicherheiten erwartet: { $expected } { $unit }.
position-residuals-rms = Positionsresiduen, RMS
position-rms = Position, RMS
positions = Positionen
preconditions-column = Vorbehalte
predicted-target-uncertainty = vorhergesagte Unsicherheit der Zielmarkenpositionen an den Kandidaten (k = 1)
predicted-u = vorhergesagtes u (k = 1)
predicted-uncertainty-title = Vorhergesagte Unsicherheit der Parameter
prediction-behind = Überdecken sich Zellen, ist die Zelle mit dem größten Wert gezeichnet.
prediction-description = Eine Zelle je { $spacing } mm im Basiskoordinatensystem, im Bereich der Kalibrierposen. Farbe von 0 bis { $colour }, gleiche Skala für beide Bilder; größter Wert { $largest }.
prediction-difference-title = Werkzeugpunkt: nominales minus identifiziertes Modell, { $plane }-Ebene
prediction-expected-title = Werkzeugpunkt: erwartete Abweichung mit den identifizierten Parametern, { $plane }-Ebene
prediction-map-definition = { $error }; nominal minus identifiziert: Differenz der Positionen, die beide Parametersätze vorhersagen; erwartet: Betrag (k = 1) aus der Kovarianz der Parameter, der Toleranz nicht bestimmbarer Parameter, dem Modellfehler über die Unsicherheit des Messgeräts hinaus und der Lage des Punkts am Werkzeug; p95_mm: Obergrenze von 95 % der Abweichungen an einem Knoten, bei Normalverteilung (Box 1954)
prediction-own-scale = Eine Zelle je { $spacing } mm im Basiskoordinatensystem, im Bereich der Kalibrierposen. Farbe von 0 bis { $colour }, Skala nur für dieses Bild; größter Wert { $largest }.
prediction-tooltip = x { $x }, y { $y }, z { $z } mm: nominal minus identifiziert { $difference }; erwartete Abweichung { $expected } (k = 1), zu 95 % kleiner als { $largest }
probability-by-chance = p-Wert
probability-of-errors = Wahrscheinlichkeit so großer Abweichungen bei der Unsicherheit von Parametern und Messung: { $probability }.
projected-into-xy = in die xy-Ebene projiziert
proven-effects = An ausgelassenen Posen bestätigte Effekte
provenance = Herkunft
quantile-95 = 95 %
quantiles-description = Sortierte Residuen über den Quantilen einer Normalverteilung; Gerade: normalverteiltes Rauschen.
quantities-changed = Signifikante Änderungen: { $changed } von { $total } Größen des Roboters: { $names }.
quantity = Größe
quantity-at = { $quantity }, { $place }
quantity-in-unit = { $quantity } ({ $unit })
quarter-rule = 25-%-Regel
radius = Radius
range = { $from } bis { $to }
readings-give = Messwerte: { $values }
readings-of-set-give = Messwerte der { $set ->
        [validation] Validierung
       *[calibration] Kalibrierung
    }: { $values }
reference-temperature = das Modell bezieht sich auf { $value } °C
rank = Rang
rank-cut = Rangschwelle { $value }
ratio = Verhältnis
reached = erreicht
read-as = gelesen als
reading-uncertainty = { $uncertainty } mm (k = 1) je Messwert
reading-uncertainty-with-k = U = { $uncertainty } µm je Messwert (k = { $k })
reading-uncertainty-without-k = U = { $uncertainty } µm je Messwert (Erweiterungsfaktor nicht angegeben)
readings = Messwerte
readings-not-judged = { $target } ({ $readings ->
        [one] 1 Messwert
       *[other] { $readings } Messwerte
    }, Redundanz { $redundancy }: nicht beurteilt)
readings-redundancy = { $target } ({ $readings ->
        [one] 1 Messwert
       *[other] { $readings } Messwerte
    }, Redundanz { $redundancy })
readings-scatter-more = die Messwerte streuen { FIXED($ratio, 2) }-mal so stark wie erwartet; keine Bewegung der Basis, eines einzelnen Gelenks oder einer einzelnen Zielmarke erklärt das
reason = Grund
recommend-file = `{ $file }` des Laufs laden: { $load } von { $count } Parametern mit ihren identifizierten Werten; die anderen bleiben auf dem Nennwert
recommend-further = noch nichts laden: zuerst { $effects } identifizieren; damit sind die Abweichungen an ausgelassenen Posen kleiner
recommend-nominal = nichts laden: die Nennparameter behalten. Die identifizierten sind an neuen Posen nicht deutlich besser
recommend-parameters = die identifizierten Parameter des Laufs laden: { $load } von { $count }; die anderen bleiben auf dem Nennwert
recommend-resolve = noch nichts laden: nach der Bewertung darf keine Datei geladen werden. Zuerst die nächsten Schritte des Laufs ausführen
recommendation-title = Empfehlung der zu ladenden Parameter
recorded = aufgezeichnet
recorded-motion = Aufgezeichnete Bewegung
recording-begins-at-pose = Die Aufzeichnung beginnt an Pose { $pose }: Zum ersten Stillstand gibt es keine Ankunft und keine Bewegung.
reference-targets = Referenzmarken
refused = abgelehnt
refused-rows = { $refused } von { $total } Zeilen abgelehnt
region-note = Bereiche der Werte an den gemessenen Posen. Die Ergebnisse gelten in den Bereichen der Kalibrierung.
region-of-c = Bereich von C, im Basiskoordinatensystem
region-of-orientation = Orientierung { $orientation } deg
region-of-orientations = jede Orientierung von { $from } bis { $to } deg
region-of-readings = Die Abweichungen gelten für diese Werte der Kalibriermessungen: { $values }.
region-of-validity = Geltungsbereich
relative-accuracy = Relative Genauigkeit: Abstände zwischen Posen ({ $set })
relative-accuracy-note = Vorhergesagter minus gemessener Abstand einer Zielmarke zwischen zwei Posen. Die Basis wirkt sich auf diese Abweichungen nicht aus; die Zielmarke nicht, wenn beide Posen dieselbe Orientierung haben. U (k = 2): Messgerät, Koordinatensysteme und Zielmarken; die Parameter werden geprüft und tragen nicht bei.
relative-accuracy-selection = Gezählt wird eine gleichmäßige Auswahl von { $pairs } aus { $available } Paaren; das Maximum bezieht sich auf diese Auswahl.
relative-error = relative Abweichung
relative-humidity = relative Luftfeuchte
relaxation-alone = Relaxation allein
reliability-note = Zuverlässigkeit (Baarda 1968; Signifikanzniveau { $significance } %, Teststärke { $power } %). Kleinster aufdeckbarer Fehler einer Koordinate: Median { $median }, ungünstigster Messwert { $largest }; kleinste Redundanz { $redundancy }. Messwerte mit einem Residuum über { $factor } Standardabweichungen: { $beyond } von { $readings }.
repeatability = Wiederholgenauigkeit
repeatability-at-pose = Größter Wert der Pose-Wiederholgenauigkeit RP: { $repeatability } µm, an Pose { $pose }.
repeatability-from-one-approach = { $approaches ->
        [one] Wiederholgenauigkeit bei der einzigen Anfahrrichtung mit mehreren Anfahrten an Pose { $pose }: { $largest } µm; alle Anfahrrichtungen zusammen: { $together } µm.
       *[other] Wiederholgenauigkeit bei einer einzigen Anfahrrichtung an Pose { $pose } ({ $approaches } Anfahrrichtungen): { $smallest } bis { $largest } µm; alle Anfahrrichtungen zusammen: { $together } µm.
    }
repeatability-over-cycles = Pose-Wiederholgenauigkeit jeder Pose im Verlauf der Prüfung.
repeatability-title = Wiederholgenauigkeit
repeats = Wiederholungen
report = Bericht
report-element = Element
report-homing = Referenzfahrt
report-number = Nummer des Berichts
report-poses = Posen
reservation-drift = AP änderte sich vom ersten bis zum letzten Satz um bis zu { $change } µm, und eine Stabilisierung ist nicht nachgewiesen an { $count ->
        [one] Pose { $poses }
       *[other] den Posen { $poses }
    } (ISO 9283, 7.6)
reservation-errors-unknown = quadratischer Mittelwert der Positionsabweichung { $calibration } an Kalibrierposen, { $left_out } an ausgelassenen: die Kalibrierposen zeigen die Abweichungen an anderen Posen nicht
reservation-few-cycles = weniger als { $required } Zyklen an { $count ->
        [one] Pose { $poses }
       *[other] den Posen { $poses }
    }
reservation-file-hardly-better = die Steuerungsdatei für { $formats } bringt keine deutliche Verbesserung gegenüber den Nennparametern: RMS { $rms } mm (nominal { $nominal_rms } mm), größte Abweichung { $max } mm (nominal { $nominal_max } mm)
reservation-file-not-written = mindestens eine Steuerungsdatei wurde nicht geschrieben (siehe Meldungen)
reservation-given-refused = die Parameter dürfen nicht verwendet werden: sie sind an den gemessenen Posen schlechter als die Nennparameter oder gehören zu einem anderen Roboter
reservation-hardly-better = die identifizierten Parameter sind kaum besser als die Nennparameter: RMS { $rms } mm (nominal { $nominal_rms } mm), größte Abweichung { $max } mm (nominal { $nominal_max } mm)
reservation-instrument-too-coarse = die Messunsicherheit übersteigt 25 % der geprüften Kenngröße an { $count ->
        [one] Pose { $poses }
       *[other] den Posen { $poses }
    } (ISO 9283, Abschnitt 6)
reservation-model-does-not-fit = die Residuen sind { $times } × die angegebene Unsicherheit der Messwerte: das Modell passt nicht, { $set ->
        [calibration] und Abweichungen an anderen Posen können größer sein als an den Kalibrierposen
       *[validation] es gelten die Abweichungen an den Validierungsposen
    }
reservation-set-up-untested = { $count ->
        [one] ein Fehler des Aufbaus ist
       *[other] { $count } Fehler des Aufbaus sind
    } von den Messungen nicht geprüft; der Flansch würde um bis zu { $flange_mm } mm und { $flange_deg } deg abweichen
reservation-no-warm-up = der Roboter wurde vor der Prüfung nicht warmgefahren
reservation-open-warnings =
    { $count ->
        [one] eine Warnung ist nicht geklärt: { $warnings }
       *[other] Warnungen sind nicht geklärt: { $warnings }
    }
reservations = Vorbehalte: { $reasons }.
residual-field = Residuenfeld
residual-over = Residuum / σ
residuals = Residuen
residuals-against-normal = Residuen der Kalibrierposen im Vergleich mit einer Normalverteilung
residuals-by-pose = Residuen je Pose nach der Kalibrierung
residuals-by-pose-description = Eine Marke je Pose, Zyklus, Zielmarke und Achse.
residuals-max = Residuen, max.
residuals-over-uncertainty = Residuen / angegebene Unsicherheit, √(χ²/ν)
residuals-pattern = Residuen mit erkennbarem Muster sind kein Rauschen: Das Modell ist unvollständig.
residuals-rms = Residuen, RMS
residuals-summary = { $count } Residuen, Mittel { $mean }, Standardabweichung { $deviation }; Gerade: Rauschen allein.
residuals-title = Residuen
results-before-and-after = Ergebnisse: Abweichungen vorher und nachher
results-of-external-providers = Ergebnisse externer Anbieter
results-relate-to-item = Diese Ergebnisse beziehen sich nur auf den geprüften Gegenstand.
results-with-uncertainty = Abweichungen nach der Kalibrierung mit ihrer Unsicherheit
rigid-parts = starre Teile
risk = Risiko
risk-without-coverage = Für AP ist kein Risiko einer falschen Annahme angegeben: AP driftet, daher ist das Intervall kein Überdeckungsintervall.
rms = RMS
rms-after = RMS nachher
rms-and-largest = RMS { $rms } µm, größter Wert { $largest } µm
rms-and-max = RMS und max.
rms-and-max-values = { $rms } und { $max }
rms-before = RMS vorher
rms-expected = { $value } { $unit }, aus Messgerät, Parametern und Modellfehler erwartet { $expected } { $unit }
rms-of = { $quantity }, RMS
rms-ratio = RMS-Verhältnis
rms-with-it = RMS mit dem Effekt
rms-without-it = RMS ohne den Effekt
robot = Roboter
robot-changed-as-a-whole = Die Parameter des Roboters haben sich insgesamt signifikant geändert; keine einzelne Größe hat sich signifikant geändert.
robot-changed-together = Kampagne { $to } gegenüber { $from }: Die { $parameters } Parameter des Roboters haben sich insgesamt signifikant geändert (F = { $f } mit { $parameters } und { $degrees_of_freedom } Freiheitsgraden, { $probability }).
robot-column = Roboter
robot-instrument-conditions = Roboter, Messgerät, Bedingungen
robot-of-model = Roboter: { $model }
robot-of-name = Roboter { $name }
robot-unchanged-together = Kampagne { $to } gegenüber { $from }: Die { $parameters } Parameter des Roboters haben sich insgesamt nicht signifikant geändert (F = { $f } mit { $parameters } und { $degrees_of_freedom } Freiheitsgraden, { $probability }).
robust = robust
robust-fit = Robuste Anpassung
robust-fit-agrees = Die robuste Anpassung stimmt mit der Anpassung nach kleinsten Quadraten überein. Größte Differenz: { $parameter }, { $difference } Standardunsicherheiten der Differenz (durch Zufall erwartet: { $chance }).
robust-fit-difference = Die robuste Anpassung weicht von der Anpassung nach kleinsten Quadraten ab. Größte Differenz: { $parameter }, { $difference } Standardunsicherheiten der Differenz (durch Zufall erwartet: { $chance }).
robust-fit-note = Messwerte, die weit von den anderen liegen, haben wenig Gewicht (Cauchy-Verlustfunktion, c = { $c } σ mit σ = { $sigma } µm; Holland & Welsch 1977). Differenz: robuster Wert minus Wert nach kleinsten Quadraten. Ihre Standardunsicherheit ist der größere von zwei Schätzwerten: aus normalverteilten Residuen und aus der Streuung der Posen. Die Tabelle enthält die Parameter mit den größten Differenzen.
robust-fit-poses = Posen mit einem Residuum über { $factor } σ, unvereinbar mit den anderen: { $poses }.
round-off-cr = Eckenverrundung CR
routine-remarks = Weitere Hinweise
rows = Zeilen
rows-in-frame = { $count } Zeilen: innerhalb der Tabelle scrollen.
rows-in-workbook = { $count ->
        [one] 1 weitere Zeile
       *[other] { $count } weitere Zeilen
    }: siehe Arbeitsmappe.
rp-along-x = RP entlang x
rp-along-y = RP entlang y
rp-along-z = RP entlang z
rp-by-set = RP je Satz
rp-circle = Radius: mittlerer Abstand + 3 s
rp-circle-tooltip = Pose { $pose }: { $text }
rp-in-plane = RP in x, y
rp-of-judged-approach = RP der bewerteten Anfahrrichtung
scatter-of-all-visits = alle Anfahrten: { $distance } µm
rp-interval-from = RP, 95 % von
rp-interval-to = RP, 95 % bis
rp-within-limit = RP innerhalb des Grenzwerts
rp-without-noise = RP ohne Rauschen
rt-interval-from = RT, 95 % von
rt-interval-to = RT, 95 % bis
rt-location = Ort von RT
rt-of-angles = RT der Winkel (deg)
rule-not-stated = { $rule } (Vorgabe; die Kampagne nennt keine Regel)
samples-in-seconds = { $samples } Abtastwerte in { $seconds } s
scale = Maßstab
scale-bars = Kalibrierstäbe
scaling-label = Skalierung:
seed = Startwert der Zufallszahlen
serial-number = Seriennummer
series-agree = Mit diesen Posen ist kein Unterschied zwischen den { $series } Serien nachweisbar.
series-differ = Unterschiede zwischen den { $series } Serien tragen im Mittel { $percent } % zu den Varianzen der Parameter bei.
set = Gruppe
set-of-cycles = Satz von Zyklen
set-summary = { $set }: { $poses ->
        [one] 1 Pose
       *[other] { $poses } Posen
    }, { $errors ->
        [one] 1 Abweichung
       *[other] { $errors } Abweichungen
    }
set-summary-of = { $set }: { $poses ->
        [one] 1 Pose
       *[other] { $poses } Posen
    }, { $errors ->
        [one] 1 Abweichung
       *[other] { $errors } Abweichungen
    } ({ $point })
set-up-changes = Basis und Zielmarken: { $changed } von { $total } Größen haben sich geändert (bei neuem Aufbau zu erwarten).
set-up-corrected = Der Aufbau hat sich um bis zu { $moved } bewegt (größte Verschiebung einer festen Zielmarke seit ihrer ersten Messung). Die Positionen wurden in { $steps ->
        [one] einem Schritt
       *[other] { $steps } Schritten
    } korrigiert; die verbleibende Verschiebung der Zielmarken beträgt höchstens { $left } (RMS).
set-up-parameter-named = Parameter { $name } (Basis oder Zielmarke)
sets = Sätze
settled-after-set = stabilisiert nach Satz
severity-error = Fehler
severity-warning = Warnung
share-of-points = Anteil (%)
share-of-set = Anteil der Gruppe (%)
shared-risk = Annahme mit geteiltem Risiko (JCGM 106:2012, 8.2.1)
shared-risk-explained = bestanden, wenn der Wert den Grenzwert einhält; unentschieden, wenn U ein Viertel des Grenzwerts übersteigt
sheet-all-together = Alle zusammen
sheet-approach = Anfahrt von
sheet-approach-above = { $joint } von oben
sheet-approach-below = { $joint } von unten
sheet-between-series = Zwischen Serien
sheet-budget-of-errors = Budget der Abweichungen
sheet-budget-of-orientations = Orientierungsbudget
sheet-cell-frames = Koordinatensysteme
sheet-cell-residuals = Residuen der Zelle
sheet-clauses = ISO 9283, Abschnitte
sheet-controller-values = Steuerungswerte
sheet-corners = Ecken
sheet-correlation = Korrelation
sheet-covariance = Kovarianz
sheet-detectable = Erkennbare Änderungen
sheet-distributions = Verteilungen
sheet-distributions-of-errors = Verteilungen der Abweichungen
sheet-done = erledigt
sheet-errors = Abweichungen
sheet-frames = Koordinatensysteme
sheet-geometry-balls = Geometrie, Kugeln
sheet-geometry-fits = Geometrie, Anpassungen
sheet-geometry-leads = Geometrie, Steigungen
sheet-geometry-methods = Geometrie, Verfahren
sheet-geometry-poses = Geometrie, Posen
sheet-geometry-quantities = Geometrie, Größen
sheet-geometry-scale-bars = Geometrie, Kalibrierstäbe
sheet-geometry-workspace = Geometrie, Arbeitsraum
sheet-influence-of-poses = Einfluss der Posen
sheet-inputs = Eingaben
sheet-instrument-at = Messgerät bei (mm, Basis des Roboters)
sheet-iso9283-approaches = ISO 9283, Anfahrrichtungen
sheet-iso9283-compliance = ISO 9283, Nachgiebigkeit
sheet-iso9283-distances = ISO 9283, Abstände
sheet-iso9283-drift = ISO 9283, Drift
sheet-iso9283-places = ISO 9283, mittlere Positionen
sheet-iso9283-poses = ISO 9283, Posen
sheet-iso9283-reference-targets = ISO 9283, Referenzmarken
sheet-iso9283-robot = ISO 9283, Roboter
sheet-iso9283-variation = ISO 9283, Streuung
sheet-iso9283-visits = ISO 9283, Anfahrten
sheet-label = Bezeichnung
sheet-known-values = Bekannte Werte
sheet-messages = Meldungen
sheet-moved-values = Veränderte Werte
sheet-not-a-number = keine Zahl
sheet-not-controlled = Nicht kontrolliert
sheet-number = Nr.
sheet-operator-date = Datum, Prüfer
sheet-packages = Pakete
sheet-parameter-effects = Wirkung der Parameter
sheet-path = Bahn
sheet-posing = Positionierzeit
sheet-predicted-errors = Vorhergesagte Abweichungen
sheet-program = Programm
sheet-program-value = { $file } ({ $language })
sheet-proven-effects = Nachgewiesene Effekte
sheet-reference-data = Referenzdaten
sheet-reflector-at = Reflektor { $name } bei (mm, Flansch)
sheet-reflector-axis = { $at }; Achse { $axis }, höchstens { $angle }° vom Messgerät
sheet-refused-rows = Abgelehnte Zeilen
sheet-readings = Messwerte
sheet-relative-accuracy = Relative Genauigkeit
sheet-requirements = Anforderungen
sheet-robust-fit-poses = Robuste Anpassung, Posen
sheet-rows-left-out = { $count ->
    [one] 1 weitere Zeile fehlt hier: die Dokumente enthalten sie
   *[other] { $count } weitere Zeilen fehlen hier: die Dokumente enthalten alle
}
sheet-singular-values = Singulärwerte
sheet-slips = Absichtliche Fehler
sheet-stabilisation = Stabilisierung
sheet-standstills = Stillstände
sheet-step = Schritt
sheet-step-frame = Punkte des Weltkoordinatensystems und der Referenzmarken gemessen; sie werden nach der letzten Pose wieder gemessen.
sheet-step-instrument = Messgerät warm, nivelliert und nach Vorgabe des Herstellers geprüft; seine Position stimmt mit der obigen überein.
sheet-step-reflectors = Reflektoren an ihren Plätzen, fest und sauber.
sheet-step-slow = Alle Posen einmal langsam angefahren: keine Kollision, Kabel und Sichtlinie frei.
sheet-step-zero = Gelenkwerte der ersten Pose in der Anzeige der Steuerung stimmen mit diesem Blatt überein.
sheet-streams = Aufzeichnungen
sheet-study-parameters = Studie, Parameter
sheet-study-positions = Studie, Positionen
sheet-summary = Zusammenfassung
sheet-temperature = Lufttemperatur zu Beginn und am Ende (°C)
sheet-tests = Prüfungen
sheet-tool-point = Werkzeugpunkt
sheet-trends-of-residuals = Trends der Residuen
sheet-values = Werte
sheet-wait = Wartezeit an jeder Pose
sheet-wait-seconds = { $seconds } s
sheet-wait-trigger = { $seconds } s; Ausgang { $output } ist in der zweiten Hälfte eingeschaltet
sheet-way-back = Prüfung nach dem Laden
sheet-without-partner = Ohne Zuordnung
should-know = Zur Kenntnis
show = Anzeigen
show-all-rows = Alle Zeilen zeigen
show-more = Mehr anzeigen
signatures = Unterschriften
significant-changes = Signifikant: { $campaigns }.
simple-acceptance = einfache Annahme (ILAC-G8:09/2019, 4.2.1)
simple-acceptance-explained = bestanden, wenn der Wert den Grenzwert einhält; das Risiko einer falschen Annahme ist geteilt und für jeden Grenzwert angegeben
simulated-calibration-note = Synthetische Daten: normalverteiltes Rauschen von { $noise } µm auf jeder Koordinate; Mittel aus { $identifications } Identifikationen. Parameter und Bilder zeigen eines dieser Mittel. Abweichungen über der Anzahl der Positionen sind Mediane aus { $medians }. Die Abweichungen beziehen sich auf { $point }, ausgewertet über { $configurations } Konfigurationen.
simulated-calibration-title = Simulierte Kalibrierung
single-balls = Einzelne Kugeln, wiederholt gemessen
singular-value = Singulärwert
singular-value-number = Nummer des Singulärwerts
singular-value-scaled = Singulärwert (Spalten durch ihre Normen geteilt)
singular-values-caption = Singulärwerte der Jacobi-Matrix an der Lösung, Spalten wie in der Identifikation auf Norm 1 skaliert: Rang { $rank }, Konditionszahl { $condition } (größter durch kleinsten Kreis).
singular-values-description = Eine Marke je Singulärwert, in absteigender Folge, auf logarithmischer Achse. Oben: gut beobachtbar; unten: schlecht beobachtbar.
singular-values-title = Singulärwerte der Identifikation
sketch-title = Das Modell und seine Parameter
skipped = übersprungen
smallest-sphere-and-circle = Radius von Hüllkugel und Hüllkreis (µm)
solver = Löser
solver-gradient-vanished = konvergiert: die Residuen sind orthogonal zur Jacobi-Matrix
solver-iteration-limit = nicht konvergiert innerhalb der zulässigen Iterationen: Startwerte prüfen
solver-no-start = kein Startwert der Suche führte zu einem Element
solver-not-finite = abgebrochen: ein Residuum ist nicht endlich; Startwerte und Daten prüfen
solver-rank-deficient = abgebrochen: Parameter sind nicht getrennt identifizierbar; einen davon festhalten
solver-residuals-zero = konvergiert: die Residuen sind bis auf Rundung null
solver-rounding = bis auf Rundung konvergiert: kein kürzerer Schritt verkleinert die Residuen
solver-step-vanished = konvergiert: der letzte Schritt ließ die Parameter unverändert
solver-too-few-equations = abgebrochen: weniger Gleichungen als Parameter; mehr Posen messen oder Parameter festhalten
source-backup = Steuerungsdatei vor dem Laden
source-contact-meaning = angegebene Unsicherheit der Antastung eines Sockels, einer Fläche oder eines gemessenen Punkts
source-encoders-meaning = angegebene Unsicherheit der Geber an den Gliedern
source-frame-meaning = Punkte, die das Weltkoordinatensystem festlegen (allen Posen gemeinsam)
source-frame-of-poses-meaning = Punkte des Koordinatensystems, das an jeder Pose neu gemessen wird
source-homing-meaning = Gelenkwerte nach der Referenzfahrt (allen Posen gemeinsam)
source-instrument-meaning = angegebene Unsicherheit jedes Messwerts des Messgeräts
source-single-coordinates-meaning = angegebene Unsicherheit von Messwerten einer Koordinate, zum Beispiel einer Messuhr
single-coordinates = einzelne Koordinaten
source-known-points-meaning = angegebene Positionen und Längen fester Punkte
source-model-meaning = Modellfehler: Anteil der Residuen, den keine andere Quelle erklärt
source-nominal-values-meaning = Toleranzen der Nennwerte der Parameter
source-repeatability-meaning = Streuung der Wiederholungen einer Pose über die Unsicherheit des Messgeräts hinaus
source-residuals-meaning = Streuung der Residuen (keine Unsicherheit angegeben)
source-rigid-parts-meaning = angegebene Formen der Teile, die Zielmarken tragen
source-scale-meaning = Maßstab des Messsystems (allen Längen gemeinsam)
source-temperature-meaning = Wärmeausdehnung von Roboter und Werkstück (allen Längen gemeinsam)
sources-of-the-formulas = Quellen der Formeln
sphere-x-y-z = Kugel x, y, z
spheres-and-conventions = Hüllkugeln und Konventionen
stabilisation-and-overshoot = Pose-Stabilisierungszeit und Pose-Überschwingen
stabilisation-path-length = Bahnlänge der Stabilisierung
stabilisation-time = Stabilisierungszeit
straight-distance = geradliniger Abstand
stability = Stabilität
standard-deviation = Standardabweichung
standstills = Stillstände
state-of-the-robot = Zustand des Roboters
stated-tolerance = angegebene Toleranz
stated-uncertainty = angegebene Unsicherheit
static-compliance = Statische Nachgiebigkeit
status = Status
step-arc = Bogen der Kugel { $ball } um { $about }
step-plane-of-rails = Ebene der Schienen
step-shaft = Welle, Wiederholung { $repeat }, Stellung { $position }
step-travel = Verfahrweg des Antriebs { $actuator }
stream = Aufzeichnung

sum-of-squares-tested = χ² = { $sum } bei { $degrees } Freiheitsgraden, { $p }

template = Vorlage

surface = Fläche
synthetic-data = synthetische Daten
synthetic-data-label = Synthetische Daten:
synthetic-mark = SYNTHETISCHE DATEN
table = Tabelle
target = Zielmarke
target-coordinates = { $count } Koordinaten von Zielmarken (mm)
target-motion-explains-most = die Parameter gelten nicht mehr: eine Bewegung der Zielmarke { $target } um { $by } (k = 2) erklärt { $percent } % der Abweichung; die verbleibenden Residuen sind größer als erwartet
target-moved = die Zielmarke { $target } hat sich auf ihrem Teil um { $by } (k = 2) bewegt
target-movement-caption = Größte Bewegung einer Zielmarke seit ihrer ersten Messung und RMS der verbleibenden Verschiebung.
target-named = Zielmarke { $target }
targets-as-measured = gemessene Zielmarken
targets-from-their-places = Abstand der Zielmarken von ihren Referenzpositionen
targets-in-world = den Zielmarken im Weltkoordinatensystem
targets-placed-by-validation = Keine Kalibrierpose misst { $targets }: aus den Messwerten an den Validierungsposen bestimmt, bei festgehaltenen identifizierten Roboterparametern. Jede dieser Abweichungen ist durch √r geteilt (r: Redundanz). U ist die erweiterte Messunsicherheit der anderen Messwerte.
temperature = Temperatur
temperature-range = { $lowest } °C bis { $highest } °C in den Exporten
temperature-of-robot = Temperatur des Roboters
torques-of-joints = Drehmomente der Gelenke
test-certificate = Prüfschein
test-certificate-draft = Entwurf eines Prüfscheins
test-cube = P1 ist die Mitte eines Würfels von { $size } mm, P2 bis P5 liegen auf den Diagonalen der Prüfebene (ISO 9283:1998, 6).
test-of-changes = Residuen, die Basis oder Gelenke verursachen können
test-of-rest = alle anderen Residuen
test-of-synthetic-data = Prüfung mit synthetischen Daten, kein Prüfschein
test-square = P1 ist die Mitte eines Quadrats von { $size } mm, P2 bis P5 liegen auf seinen Diagonalen (ISO 9283:1998, 6).
tested-by = Geprüft von
text = Text
texts-of-campaign-note = Texte der Kampagne sind nicht übersetzt.
the-campaign-fits-no-features = Die Kampagne enthält keine angepassten Geometrieelemente.
the-campaign-states-no-limits = Es sind keine Grenzwerte angegeben: Eine Bewertung ist nicht möglich.
their-standard-deviation = Standardabweichung
this-file-max = diese Datei, max.
this-file-rms = diese Datei, RMS
three-s-of-x = 3 s von x
three-s-of-y = 3 s von y
three-s-of-z = 3 s von z
time-in-s = Zeit (s)
time-since-entry = Zeit seit dem Eintritt (s)
times-for-each-cycle = { $count } Mal, einmal je Pose und Zyklus
to = bis
to-complete-count = Vor der Unterschrift zu ergänzen: { $count ->
        [one] eine Angabe
       *[other] { $count } Angaben
    }
to-distance = bis
to-hold = festzuhalten
to-load = zu laden
to-load-later = später zu laden
to-pose = nach Pose
tolerance = Toleranz
tool-error-definition = { $error }; nominal minus identifiziert: Differenz der Positionen, die beide Parametersätze vorhersagen; erwartet: Betrag (k = 1) aus der Kovarianz der Parameter, der Toleranz nicht bestimmbarer Parameter, dem Modellfehler über die Unsicherheit des Messgeräts hinaus und der Lage des Punkts am Werkzeug; die Abweichungen der Zielmarken enthalten keine Parameter, die Zielmarken und Werkzeug gleich verschieben
tool-point-expected = Erwartete Abweichung, RMS (k = 1): Parameter { $parameters } µm; nicht bestimmbare Parameter (Toleranz) { $undetermined } µm; Modellfehler { $model } µm; Lage des Punkts am Werkzeug { $point } µm. Größte erweiterte Messunsicherheit einer Pose (k = 2): { $largest } µm.
tool-point-headline = Werkzeugpunkt, RMS: nominal minus identifiziert → erwartet
traceability = Rückführbarkeit
trend = Trend
trend-description = Eine Marke je Kampagne mit ihrem 95-%-Intervall; Rauten: signifikante Änderung.
trend-in-picture = Nicht modellierter Trend ({ $probability }).
trend-of = Verlauf von
trend-of-all-quantities = Nicht modellierter Trend aller gemessenen Größen zusammen ({ $probability }).
trends-note = F-Tests der mittleren Abweichungen der Kalibrierposen nach der Identifikation: Parabel gegen Konstante; p-Werte für mehrfaches Testen korrigiert (Holm 1979). Ein Trend ist eine Abweichung, die das Modell nicht beschreibt.
trends-of-the-residuals = Trends der Residuen
trends-suggest-field = Die Residuen zeigen noch einen Trend: `field = true` in [identify] sucht ein Residuenfeld.
true = wahr
turn-down = Nach unten drehen
turn-left = Nach links drehen
turn-right = Nach rechts drehen
turn-up = Nach oben drehen
type = Typ
u-allowed = zulässige U
u-bootstrap = u, Bootstrap
u-draws = u, Ziehungen
u-linear = u, linear
u-of-deviation = u der Abweichung (k = 1)
u-of-identified = u des identifizierten Werts
u-of-position = U einer Position
u-over-ap = U / AP
u-over-rp = U / RP
u-over-value = U / Wert
u-report = u, Bericht
uncertainties = Unsicherheiten
uncertainties-enlarged-by = Vergrößerungsfaktor der Unsicherheiten
uncertainties-of-robot = Unsicherheiten des Roboters { $robot }
uncertainty-by-default-tolerances = Für diese gilt die voreingestellte Toleranz des Programms, multipliziert mit { $factor }, dem Faktor, der am besten zu den Daten passt.
uncertainty-by-tolerances = Werte, deren verbleibende Unsicherheit vor allem aus Toleranzen von Nennwerten stammt, eigenen oder anderen ({ $count }): { $names }. Darunter Vorgaben des Modells: { $default }.
uncertainty-budget = Messunsicherheitsbudget
uncertainty-for-outliers = ± { $uncertainty } µm je Koordinate ({ $factor } Standardabweichungen), unabhängig für jede Beobachtung
uncertainty-inflation = das { $factor }-Fache des Werts aus { $beside ->
        [instrument] der angegebenen Unsicherheit allein
       *[residuals] unabhängigen Residuen
    } (Median)
uncertainty-of-instrument = der Standardunsicherheit des Messgeräts
uncertainty-of-instrument-and-contact = der Standardunsicherheit von Messgerät und Antastung
uncertainty-of-readings = der angegebenen Standardunsicherheit der Messwerte
uncertainty-of-rp = Unsicherheit von RP
undecided = unentschieden
unit = Einheit
unjudged-by-misfit = Nicht beurteilt, weil das Modell nicht passt: { $count }.
unjudged-without-uncertainty = Nicht beurteilt, weil die Unsicherheit unbekannt ist: { $count }.
unknown-without-redundancy = unbekannt (gleich viele Gleichungen wie Parameter)
unshown-frame-points = Abweichungen der Punkte, die das Weltkoordinatensystem festlegen: ohne Redundanz verschieben sie nur das Koordinatensystem
unshown-frame-targets = Positionsabweichungen der Zielmarken, die das Weltkoordinatensystem festlegen: die gemessenen Positionen sind der Bezug
unshown-scale = ein allen gemessenen Längen gemeinsamer Faktor: die Längen des Roboters nehmen ihn auf
unshown-shift = eine allen Messwerten gemeinsame Verschiebung oder Drehung: die Basis nimmt sie auf
valid-until = gültig bis
valid-until-agreed = gültig bis, mit dem Kunden vereinbart
valid-until-column = Gültig bis
validation = Validierung
validation-of-given-parameters = Validierung gegebener Parameter
value = Wert
value-and-limit = { $quantity } { $value } { $unit }, Grenzwert { $limit } { $unit }
value-tooltip = { $name }: { $value } ± { $uncertainty } { $unit }
value-with-interval = { $value } µm (95 %: { $low } bis { $high })
values-by-nominal = { $count ->
        [one] 1 Wert stammt überwiegend aus seinem Nennwert, weil die Daten ihn kaum bestimmen: { $names }.
       *[other] { $count } Werte stammen überwiegend aus ihren Nennwerten, weil die Daten sie kaum bestimmen: { $names }.
    }
values-given = vorher: Nennparameter des Roboters mit der Basis und den Zielmarken, die die frühere Kalibrierung daran angepasst hat; nachher: alle Parameter wie gegeben, einschließlich Basis und Zielmarken; keine Anpassung an diese Daten
values-given-prior = vorher: Nennparameter des Roboters, mit an die Kalibrierposen angepasster Basis und Zielmarken; nachher: alle Parameter wie gegeben, Basis und Zielmarken aus ihrer gegebenen Kovarianz und den Kalibrierposen geschätzt (wahrscheinlichste Werte)
values-given-refit = vorher: Nennparameter des Roboters; nachher: gegebene Parameter; beide mit an die Kalibrierposen angepasster Basis und Zielmarken
values-nominal = vorher und nachher: Nennparameter, einschließlich Basis und Zielmarken; keine Anpassung an diese Daten
values-nominal-refit = vorher und nachher: Nennparameter des Roboters, mit an die Kalibrierposen angepasster Basis und Zielmarken
values-of-every-campaign = Werte je Kampagne
values-of-identification = vorher: Nennparameter des Roboters, nur Basis und Zielmarken an die Kalibrierposen angepasst; nachher: alle identifizierten Parameter
velocities = Geschwindigkeiten
velocity-of-poses = { $velocity } (Posen)
velocity-of-recording = { $value } mm/s ({ $name })
velocity-sentence = Geschwindigkeit: { $velocity }.
verdict = Bewertung
files-beyond-limits = { $files } nicht laden: mit den Werten { $count ->
        [one] dieser Datei
       *[other] dieser Dateien
    } ist ein Grenzwert nicht eingehalten.
given-not-loaded = Die gegebenen Parameter nicht laden. Sind sie geladen, die vorherige Datei der Steuerung wiederherstellen.
verdict-conditional = Bewertung: bestanden mit Vorbehalten.
verdict-fail = Bewertung: nicht bestanden.
verdict-is-of-file = Diese Abweichungen gelten für `{ $file }`{ $count ->
        [0] {""}
        [one] , ohne einen identifizierten Parameter
       *[other] , ohne { $count } identifizierte Parameter
    }: RMS { $rms } { $unit }; mit allen Parametern { $whole } { $unit }.
verdict-pass = Bewertung: bestanden.
verdict-title = Bewertung
verdict-undecided = Bewertung: unentschieden.
verification-of-identified-parameters = Überprüfung identifizierter Parameter
verified-by-copies = es wurde nichts neu gemessen: { $count } von { $rows } Messwerten sind Messwerte der Kalibrierung
verified-by-program = ein unabhängiges Programm; nicht mit einem gekauften Exemplar der Norm verglichen
verified-by-simulation = simulierte Bewegungen; nicht mit einem gekauften Exemplar der Norm verglichen
verified-by-text = Text der Norm, einen veröffentlichten Datensatz und ein unabhängiges Programm
verify-step-apart = Posen messen, die diese Bewegungen unterscheiden: { $motions }
verify-step-apart-reason = sie erklären die Residuen gleich gut; `etalon verify --candidates` wählt Posen
verify-step-base = Befestigung der Basis und Referenzpunkte des Weltkoordinatensystems prüfen
verify-step-base-reason = eine Bewegung der Basis ändert keinen Parameter des Roboters selbst
verify-step-joint = Gelenk { $joint } neu justieren oder { $by } zu seinen Gelenkwerten addieren
verify-step-joint-reason = das Gelenk steht tatsächlich bei seinem protokollierten Wert plus dieser Änderung
verify-step-keep = die geladene Datei behalten
verify-step-keep-reason = keine Änderung ist signifikant; die kleinsten Änderungen, die diese Posen zeigen, stehen unten
verify-step-new = die Posen erneut messen, Exporte und Protokolle ersetzen
verify-step-new-reason = { $count } Zeilen sind Kopien von Messwerten der Kalibrierung
verify-step-other = an anderen Posen erneut messen; bleibt die Abweichung, neu kalibrieren
verify-step-other-reason = keine einzelne Bewegung erklärt sie; begann sie mit dem Laden einer Datei, die vorherige Datei wiederherstellen
verify-step-target = Befestigung der Zielmarke { $target } prüfen
verify-step-target-reason = den Parametern des Roboters selbst widersprechen die Messwerte nicht
verify-step-verify = dann `etalon verify` erneut ausführen
verify-step-verify-reason = nur neue Messwerte zeigen, dass die Änderung behoben ist
view-as-drawn = Anfangsansicht
view-xy = x-y
view-xz = x-z
view-yz = y-z
visit-of-cycle-tooltip = Pose { $pose }, Zyklus { $cycle }: x { $x }, y { $y } µm
visit-tooltip = Pose { $pose }, Zyklus { $cycle }, { $approach }: x { $x }, y { $y }, z { $z } µm vom Mittel
visits = Anfahrten
visits-by-approach = { $visits } Anfahrten um ihr Mittel, nach Anfahrrichtung; große Marken: Mittel.
visits-by-approach-in-space = { $visits } Anfahrten um ihr Mittel; Farbe und Form: Anfahrrichtung; große Marken: Mittel.
visits-by-plane = Anfahrten jeder Pose, je Ebene
visits-from-one-pose = { $visits } Anfahrten um ihr Mittel, { $unknown ->
        [0] alle aus derselben Anfahrrichtung; große Marke: Mittel.
        [one] alle bis auf eine aus derselben Anfahrrichtung; die Anfahrrichtung einer Anfahrt ist unbekannt, weil davor keine Pose erfasst wurde. Große Marke: Mittel der übrigen Anfahrten.
       *[other] alle bis auf { $unknown } aus derselben Anfahrrichtung; die Anfahrrichtung von { $unknown } Anfahrten ist unbekannt, weil davor keine Pose erfasst wurde. Große Marke: Mittel der übrigen Anfahrten.
    }
visits-from-unknown-poses = { $visits } Anfahrten um ihr Mittel; ihre Anfahrrichtungen sind unbekannt.
visits-of-pose-title = Pose { $pose }, { $plane }-Ebene
visits-over-time = Anfahrten über der Zeit
warm-up-before-the-test = Warmlauf vor der Prüfung
warnings-and-remarks = Warnungen und Bemerkungen
way-back-after = nach dem Laden
way-back-before = vor dem Laden
way-back-display = angezeigte Pose
way-back-evaluated = Mit den Eingaben von Pose { $pose } ({ $inputs }) und ihren Gelenkwerten ({ $joints }) ergibt die Datei x = { $x }, y = { $y }, z = { $z } mm. Software, die die Eingaben nicht auswertet, weicht dort um { $effect } mm ab.
way-back-file = Datei vor dem Laden
way-back-base-moves = Gelenke bewegen das Glied `{ $base }`; deshalb zeigt keine Steuerung diese Posen an. Software, die die Kette berechnet, liefert sie, zum Beispiel `etalon kinematics direct`.
way-back-links = Basiskoordinatensystem: Glied `{ $base }`. Flansch: Glied `{ $link }`.
way-back-inputs = Beide Zeilen sind berechnet mit: { $inputs }. Bei anderen Werten ist die zweite Zeile eine andere.
way-back-loaded = zu ladende Datei
way-back-moved = größte Änderung einer geteachten Position
way-back-moved-by = { $change } mm im Basiskoordinatensystem, an Pose { $pose }
way-back-not-stated = nicht angegeben: sichern und als `controller_backup` in [conditions] angeben
way-back-other-poses = Anzeige an anderen Posen, aus den Gelenkwerten vor dem Laden: `etalon kinematics direct JOINTS.csv --robot robot.toml --parameters out/parameters.json --loaded { $file }`.
way-back-restore = Rückweg: die gesicherte Datei wieder laden. Sie gilt wieder, wenn die Anzeige am selben Ort dieselbe Pose wie vor dem Laden zeigt.
way-back-test = Vor dem Laden Pose { $pose } anfahren: { $joints }. Laden, ohne den Roboter zu bewegen. Die Anzeige muss von der ersten zur zweiten Zeile wechseln. Sie zeigt den Flansch im Basiskoordinatensystem, ohne Werkzeug und Werkstück. Die erste Zeile gilt für Nennwerte: hat die Steuerung andere, stattdessen ihre Anzeige notieren.
way-back-title = Prüfung nach dem Laden und Rückweg
way-back-unread = Die Werte dieser Datei werden nicht gelesen: „vorher“ ist der Roboter mit Nennparametern.
way-back-change-too-small = Die Rundung der Gelenkwerte und der Anzeige erklärt Unterschiede bis { $tolerance } mm; die Datei ändert diese Pose um { $change } mm. Stattdessen durch eine Messung prüfen.
way-back-compensated = Werden stattdessen Programme mit `etalon compensate` korrigiert, keine Datei laden. Ein Ziel in der zweiten Zeile wird dann als erste Zeile befohlen, und die Anzeige muss die obigen Gelenkwerte zeigen.
way-back-tolerance = Toleranz des Vergleichs: { $tolerance } mm. Die Rundung der Gelenkwerte und der Anzeige erklärt keinen größeren Unterschied.
way-back-without-display = Das Modell hat keine Pose eines Flansches, die eine Anzeige zeigt. Die Datei durch eine Messung prüfen: einige Posen damit anfahren und messen. Rückweg: die gesicherte Datei wieder laden.
way-back-verify = Später einige Posen messen und die neuen Dateien in eine Kopie der Kampagne legen. Dann `etalon verify COPY --robot robot.toml --parameters out/parameters.json` ausführen.
way-back-verify-mastered = Enthalten die Gelenkwerte der Steuerung die geladenen Nullpunkte (Justage), `--mastered { $file }` hinzufügen.
weaker-trends = Weitere signifikante Trends
weave = Pendeln
way-back-mastered = Übernimmt die Steuerung die Datei als Justagewerte, müssen ihre Gelenkwerte wechseln zu: { $joints }.
weave-passes = { $passes ->
        [one] 1 Durchlauf
       *[other] { $passes } Durchläufe
    }, { $turns ->
        [one] 1 Umkehrpunkt
       *[other] { $turns } Umkehrpunkte
    }
way-back-test-software = An Pose { $pose } die Pose des Flansches bei diesen Gelenkwerten berechnen: { $joints }. Mit Nennparametern muss die eigene Software die erste Zeile ergeben, mit der Datei die zweite. Beide Zeilen gelten im Basiskoordinatensystem, ohne Werkzeug und Werkstück.
weaving = Pendeln
weaving-frequency = Pendelfrequenz
weaving-frequency-measured = { $measured } Hz, Sollwert { $commanded } Hz: WF { $ratio } %
weaving-passes = Pendeln, Durchläufe
weaving-stroke = Pendelhub
weaving-stroke-measured = { $measured } mm, Sollwert { $commanded } mm: WS { $ratio } %
weaving-turns = Pendeln, Umkehrpunkte
weight = Gewicht
what-changed = Änderungen zwischen Kampagnen
what-differs-between-series = Unterschiede zwischen den Serien
what-no-reading-shows = nicht aufdeckbare Fehler
wider-than-window = Breiter als das Fenster: seitwärts scrollen.
with-colon = { $label }:
with-field = mit Feld
without-field = ohne Feld
workspace = Arbeitsraum
workspace-outlines = Umrisse dieser Bereiche; dicke Linie: mit jeder Orientierung erreichbar.
workspace-plane = Arbeitsraum der Plattformmitte C, { $plane }-Ebene
world-frame = Weltkoordinatensystem
world-frame-title = Weltkoordinatensystem
worst-campaigns = Die { $worst } schlechtesten Kampagnen sind gezeigt. Die übrigen { $left_out } erscheinen, wenn Skripte aktiviert sind; batch.parquet enthält alle Kampagnen.
written-by = geschrieben von
x-y-z-rp = x, y, z (RP)
yes = ja

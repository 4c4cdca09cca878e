### Bedeutungen der Parameter und Titel der Zeichnungen.

meaning-axis-displacement = Kleine Verschiebung der Gelenkachse längs der am Ende des Namens genannten Achse.
meaning-axis-rotation = Kleine Drehung der Gelenkachse um die am Ende des Namens genannte Achse; gegen den Uhrzeigersinn positiv.
meaning-backlash = Umkehrspiel des Gelenks: Stellung beim Anfahren von größeren Werten minus Stellung beim Anfahren von kleineren Werten, beim selben aufgezeichneten Wert; 0 ohne Spiel.
meaning-ball-distance = Abstand der Kugeln K und L.
meaning-ball-line-angle = Winkel von der x-Achse der Plattform zur Geraden durch die Kugeln K und L; gegen den Uhrzeigersinn positiv.
meaning-base-orientation = Orientierung der Basis im Weltkoordinatensystem als Rotationsvektor; gegen den Uhrzeigersinn positiv.
meaning-base-origin = Ursprung der Basis im Weltkoordinatensystem, längs der am Ende des Namens genannten Achse.
meaning-base-origin-x = Ursprung der Basis im Weltkoordinatensystem, längs x.
meaning-base-origin-y = Ursprung der Basis im Weltkoordinatensystem, längs y.
meaning-bending = Biegung unter Schwerkraft: Winkel unter dem größten Moment (Arm waagerecht gestreckt); positiv im Drehsinn des Lastmoments.
meaning-carriage-1-place = Lage von Schlitten 1 bei Antriebswert null, längs x.
meaning-carriage-1-travel = Weg von Schlitten 1 längs x je Millimeter Sollweg; Nennwert 1.
meaning-carriage-2-travel = Weg von Schlitten 2 je Millimeter Sollweg; Nennwert 1.
meaning-carriage-3-place = Lage von Schlitten 3 bei Antriebswert null, längs y.
meaning-carriage-3-travel = Weg von Schlitten 3 je Millimeter Sollweg; Nennwert 1.
meaning-carriage-offset = Versatz des Schlittens: wird zu seiner Höhe addiert.
meaning-centre-across-balls = Plattformmitte C ab Kugel K, senkrecht zur Geraden durch die Kugeln.
meaning-centre-along-balls = Plattformmitte C ab Kugel K, längs der Geraden durch die Kugeln.
meaning-coupling = Kopplung: Bewegung des ersten Gelenks je Einheit der Bewegung des zweiten.
meaning-distal-link-1 = Länge des äußeren Gliedes von Arm 1, B1 bis C.
meaning-distal-link-2 = Länge des äußeren Gliedes von Arm 2, B2 bis C.
meaning-drift = Drift des Nullpunkts des Gelenks mit der Temperatur des Roboters: Änderung des Gelenkwerts, wenn die Temperatur um 10 K steigt.
meaning-encoder-1-offset = Nullpunktversatz von Geber 1: wird zu seinem Wert addiert; gegen den Uhrzeigersinn positiv.
meaning-encoder-2-offset = Nullpunktversatz von Geber 2: wird zu seinem Wert addiert; gegen den Uhrzeigersinn positiv.
meaning-encoder-offset = Nullpunktversatz des Gebers: wird zu seinem Wert addiert; ein größerer Versatz senkt den Arm.
meaning-expansion = Gemeinsame Ausdehnung aller Längen des Arms mit der Temperatur des Roboters: mm je Meter und Kelvin (Stahl: 0,0115).
meaning-fixture-place = Lage oder Größe eines im Weltkoordinatensystem festen Elements: Koordinate längs der am Ende des Namens genannten Achse oder Radius.
meaning-foot-aside = Seitliche Lage des Fußpunkts von Motorachse oder Säule, längs der y-Achse des Beins.
meaning-foot-outwards = Abstand des Fußpunkts von Motorachse oder Säule von der z-Achse der Basis, längs der x-Achse des Beins; nach außen positiv.
meaning-gain = Übertragungsfaktor des Gelenks: Bewegung je Einheit des aufgezeichneten Wertes; Nennwert 1.
meaning-guide-angle = Winkel der Führung auf Schlitten 1 zur y-Achse der Basis; im Uhrzeigersinn positiv.
meaning-harmonic = Harmonische des Getriebes: Gelenkbewegung je Einheit des Sinus oder Kosinus (am Ende des Namens) des einfachen oder doppelten Gelenkwinkels.
meaning-hayati-angle = Winkel nach Hayati zwischen nahezu parallelen Achsen, um die y-Achse; ersetzt den Versatz des Gliedes; gegen den Uhrzeigersinn positiv.
meaning-joint-offset = Nullpunktversatz des Gelenks: wird zum aufgezeichneten Gelenkwert addiert, um die z-Achse; gegen den Uhrzeigersinn positiv.
meaning-lateral = Kippung des Gelenks quer zu seiner Achse, um die am Ende des Namens genannte Achse des Koordinatensystems, das das Gelenk bewegt: Winkel unter einem Moment von 100 N·m um dieselbe Achse; positiv im Drehsinn des Moments.
meaning-leg-joint-on-base = Mittelpunkt des Beingelenks an der Basis, längs der am Ende des Namens genannten Achse der Basis.
meaning-leg-joint-on-platform = Mittelpunkt des Beingelenks an der Plattform, längs der am Ende des Namens genannten Achse der Plattform.
meaning-leg-length = Länge des Beins zwischen den Mittelpunkten seiner Gelenke, bei Gelenkwert null.
meaning-link-length-before = Länge des Gliedes vor dem Gelenk: Abstand seiner beiden Achsen, längs der vorigen x-Achse.
meaning-link-length-behind = Länge des Gliedes nach dem Gelenk: Abstand seiner beiden Achsen, längs der neuen x-Achse.
meaning-link-offset = Versatz des Gliedes längs der z-Achse des Gelenks.
meaning-link-twist-before = Verwindung des Gliedes vor dem Gelenk: Winkel von der vorigen z-Achse zur z-Achse des Gelenks, um die vorige x-Achse; gegen den Uhrzeigersinn positiv.
meaning-link-twist-behind = Verwindung des Gliedes nach dem Gelenk: Winkel von der z-Achse des Gelenks zur nächsten z-Achse, um die neue x-Achse; gegen den Uhrzeigersinn positiv.
meaning-motor-axis-turn-x = Drehung der Motorachse um die x-Achse des Beins; gegen den Uhrzeigersinn positiv.
meaning-motor-axis-turn-z = Drehung der Motorachse um die z-Achse des Beins; gegen den Uhrzeigersinn positiv.
meaning-motor-direction = Richtung von Motor A1 zu Motor A2 im Weltkoordinatensystem; gegen den Uhrzeigersinn positiv.
meaning-motor-distance = Abstand der Motorachsen A1 und A2.
meaning-motor-height = Höhe der Motorachse über der Basis, längs z.
meaning-motors-middle-x = Mittelpunkt zwischen den Motoren im Weltkoordinatensystem, längs x.
meaning-motors-middle-y = Mittelpunkt zwischen den Motoren im Weltkoordinatensystem, längs y.
meaning-payload = Biegung des Gelenks unter der Nutzlast eines Messwerts: Winkel unter einem Moment von 100 N·m; positiv im Drehsinn des Lastmoments.
meaning-pedestal = Kippung oder Torsion der Basis um ihre am Ende des Namens genannte Achse: Winkel unter einem Moment von 100 N·m um dieselbe Achse; positiv im Drehsinn des Moments.
meaning-proximal-link-1 = Länge des inneren Gliedes von Arm 1, A1 bis B1.
meaning-proximal-link-2 = Länge des inneren Gliedes von Arm 2, A2 bis B2.
meaning-rail-1-angle = Winkel der Schiene 1 zur x-Achse der Basis; gegen den Uhrzeigersinn positiv.
meaning-rail-1-distance = Abstand der Schiene 1 vom Ursprung der Basis, längs y.
meaning-rail-3-angle = Winkel der Schiene 3 zur y-Achse der Basis; gegen den Uhrzeigersinn positiv.
meaning-rail-3-distance = Abstand der Schiene 3 von Schiene 2, längs x.
meaning-rod-joint = Abstand des Stangengelenks von der z-Achse der Plattform, längs der x-Achse des Beins; nach außen positiv.
meaning-rod-length = Länge der Stange (Unterarm) zwischen den Mittelpunkten ihrer Gelenke.
meaning-station-pose = Pose eines weiteren Standorts des Messgeräts im Weltkoordinatensystem: sein Ursprung und seine Orientierung als Rotationsvektor.
meaning-bar-length = Länge eines Stabs zwischen zwei Zielmarken.
meaning-surface-direction = Richtung einer im Weltkoordinatensystem festen Fläche: Neigung ihrer Spur längs der am Ende des Namens genannten Achse.
meaning-target-orientation = Orientierung des Zielmarkenkörpers am Flansch, als Rotationsvektor.
meaning-target-place = Lage der Zielmarke im Koordinatensystem von Flansch oder Plattform, längs der am Ende des Namens genannten Achse.
meaning-tool-angle = Winkel bei B2 von C zum Werkzeug E; gegen den Uhrzeigersinn positiv.
meaning-tool-distance = Abstand des Werkzeugs E von B2.
meaning-torque = Biegung des Gelenks unter seinem Drehmoment: Winkel unter 100 N·m des angegebenen Drehmoments; positiv in dessen Drehsinn, also negativ, wenn das Drehmoment des Antriebs angegeben ist: gegen dieses gibt das Gelenk nach.
meaning-tower-turn-x = Drehung der Säule um die x-Achse des Beins; gegen den Uhrzeigersinn positiv.
meaning-tower-turn-y = Drehung der Säule um die y-Achse des Beins; gegen den Uhrzeigersinn positiv.
meaning-upper-arm-length = Länge des Oberarms, von der Motorachse bis zur Stange.
pedestal-or-first-joint = `pedestal` oder Gelenk { $joint } in `lateral` angeben, nicht beide: Basis und erstes Gelenk geben unter dem Arm gleich nach
sketch-arm = Arm bei Gelenkwerten null: Gelenkachsen und Längen der Glieder.
sketch-five-bar = Fünfgelenkmechanismus von oben: Glieder und Winkel (gegen den Uhrzeigersinn positiv). Das Werkzeug ist neben C gezeichnet.
sketch-legs = Roboter in der Mitte seiner Gelenkbereiche, mit den Parametern von Bein 1. Die anderen Beine haben dieselben Parameter.
sketch-link-dh = Glied mit seinen klassischen Denavit-Hartenberg-Parametern.
sketch-link-mdh = Glied mit seinen modifizierten Denavit-Hartenberg-Parametern.
sketch-table = Tisch von oben, Neigungen übertrieben dargestellt: Schienen, Schlitten, Plattform C und Kugeln K und L.

measure-all-working-modes = jede Position in allen Arbeitsmodi messen, die sie erreichen, und die Positionen über den ganzen Arbeitsraum verteilen

measure-different-angles = Posen mit verschiedenen |theta| messen, zum Beispiel 0 und dem größten Wert des Tisches

out-of-reach = nicht erreichbar
out-of-reach-by = nicht erreichbar: { FIXED($away_mm, 1) } mm vom ersten Gelenk entfernt, der Arm reicht { FIXED($reach_mm, 1) } mm weit
pose-not-finite = die Pose enthält Werte, die keine endlichen Zahlen sind
no-solution-found = keine Lösung von { $starts } Startwerten innerhalb der Gelenkgrenzen gefunden
out-of-nominal-reach = für den nominalen Roboter nicht erreichbar
joint-beyond-limits = { $joint } = { $q } { $unit }, außerhalb der Grenzen { $lower } und { $upper } { $unit }
angle-beyond-limits = { $joint } = { FIXED($q, 3) } deg, außerhalb der Grenzen { $least } und { $greatest } deg
actuator-beyond-travel = { $actuator } = { $rho } mm, der Verfahrweg ist 0 bis { $end } mm
legs-apart = die Beine erreichen die Plattform nicht
arms-do-not-meet = die Arme treffen sich nicht
singularity-near = { FIXED($found, 3) } deg von der Singularität des Typs { $kind } entfernt { $kind ->
        [1] (ein Arm gestreckt oder gefaltet)
       *[2] (die äußeren Glieder auf einer Geraden)
    }: mindestens { $margin } deg sind nötig
links-near = Glieder { FIXED($found, 3) } mm auseinander: mehr als { $least } mm sind nötig
command-refused = die Steuerung weist diesen Sollwert ab: { $reason }
joints-admit-no-pose = der Roboter hat bei diesen Gelenkwerten keine Pose
no-command-leads-there = kein Sollwert bringt den Roboter zum Ziel: die kleinste Abweichung ist { SCIENTIFIC($left_mm, 2) } mm
published-arm = ein anderer Roboter: { $title }
table-read-as = die Tabelle der Gelenke, gelesen als { $convention ->
        [modified] modifizierte
        [standard] klassische
       *[other] { $convention }
    } Denavit-Hartenberg-Parameter

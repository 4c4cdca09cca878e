### Meldungen von fit; Erklärungen in en/fit.ftl.

element = { $name ->
        [line2d] ebene Gerade (`line2d`)
        [line] Gerade (`line`)
        [plane] Ebene (`plane`)
        [circle2d] ebener Kreis (`circle2d`)
        [circle3d] Kreis (`circle3d`)
        [sphere] Kugel (`sphere`)
        [cylinder] Zylinder (`cylinder`)
        [cone] Kegel (`cone`)
        [torus] Torus (`torus`)
        [enclosing-circle] Hüllkreis
        [enclosing-sphere] Hüllkugel
        [rigid-transform] starre Transformation
       *[other] { $name }
    }

element-unknown = unbekanntes Element `{ $name }`

point-uncertainty-not-positive = die Standardunsicherheit eines Punkts ist { $uncertainty_mm } mm
    .expected = eine positive Zahl
    .hint = die Standardunsicherheit eines Punkts angeben oder weglassen: dann folgt die Unsicherheit aus den Residuen

probe-radius-not-positive = der Tasterradius ist { $radius } mm
    .expected = eine positive Zahl
    .hint = den eingemessenen Radius des Tasters angeben, nicht den Durchmesser; bei Kontaktpunkten weglassen

probe-side-needs-direction = innen und außen sind für das Element { $element } nicht definiert
    .expected = die Richtung vom Element zum Taster
    .hint = drei Zahlen angeben, zum Beispiel 0,0,1 für einen Taster darüber

probe-side-needs-inside = eine Richtung gibt für das Element { $element } nicht die Seite des Tasters an
    .expected = inside (Bohrung) oder outside (Welle)
    .hint = die Seite des Tasters angeben: inside oder outside

probe-direction-zero = der Richtungsvektor { $direction } zum Taster ist null
    .expected = drei endliche Zahlen, nicht alle null
    .hint = die Richtung von der Oberfläche zum Taster angeben

probe-direction-along-element = die Richtung { $direction } zum Taster ist parallel zum Element { $element }
    .expected = eine Richtung vom Element weg
    .hint = die Richtung von der Oberfläche zum Taster angeben

probe-larger-than-element = ein Taster mit dem Radius { $probe_mm } mm kann das Element { $element } nicht von außen berühren
    .expected = Mittelpunkte auf einem Radius, der größer als der Tasterradius ist; ihr Radius ist { FIXED($centres_mm, 6) } mm
    .hint = die andere Seite angeben: der Taster war innen

compensated-twice = die Anpassung ist schon um den Tasterradius korrigiert
    .expected = eine Anpassung an die Tastermittelpunkte
    .hint = nur einmal korrigieren

held-radius-unsupported = das Element { $element } hat keinen Radius
    .expected = kein Radius
    .hint = den Radius weglassen

held-radius-not-positive = der festgehaltene Radius ist { $radius } mm
    .expected = eine positive Zahl
    .hint = den Radius in Millimetern angeben

held-radius-below-probe = ein Taster im Element { $element } mit dem Radius { $radius } mm hätte seine Mittelpunkte auf dem Radius { $centres } mm
    .expected = ein Taster, der kleiner als der festgehaltene Radius ist
    .hint = die andere Seite angeben oder den Radius berichtigen

held-axis-unsupported = das Element { $element } hat keine Achse
    .expected = keine Achse
    .hint = die Achse weglassen

held-axis-zero = die festgehaltene Achse { $axis } hat keine Richtung
    .expected = drei Zahlen, nicht alle null
    .hint = die Achse angeben

element-ambiguous = ein anderes Element { $element } passt fast ebenso gut zu den Punkten
    .hint = dort mehr Punkte messen, wo das Element nicht erfasst ist, oder die Achse festhalten

element-not-determined = das Element { $element } konnte nicht angepasst werden: { $termination }
    .expected = Punkte, die ein Element { $element } bestimmen
    .hint = die Punkte prüfen: zu kurzer Bogen, Gerade statt Bogen oder falsches Element; sonst Radius oder Achse festhalten

zone-flat = keine Minimumzone des Elements { $element }: eine Ebene passt ebenso gut zu den Punkten
    .expected = Punkte auf einem Teil der Fläche, dessen Höhe größer ist als die Formabweichung
    .hint = einen größeren Teil der Fläche messen oder die Minimumzone einer Ebene auswerten

zone-straight = keine Minimumzone eines Kreises: eine Gerade passt ebenso gut zu den Punkten
    .expected = Punkte auf einem Bogen, dessen Höhe größer ist als die Formabweichung
    .hint = einen längeren Bogen messen oder die Minimumzone einer Geraden auswerten

zone-unsupported = die Minimumzone des Elements { $element } ist nicht verfügbar
    .expected = line2d, plane, circle2d, circle3d, sphere, cylinder oder cone
    .hint = die Anpassung nach kleinsten Quadraten verwenden

point-counts-differ = { $from } Punkte können nicht { $to } Punkten zugeordnet werden
    .expected = dieselbe Anzahl von Punkten in derselben Reihenfolge
    .hint = jede Zielmarke in beiden Listen einmal nennen

rotation-ambiguous = keine starre Transformation kann angepasst werden: mehrere Drehungen passen gleich gut
    .expected = zwei Punktmengen derselben Form
    .hint = prüfen, ob beide Listen die Zielmarken in derselben Reihenfolge nennen und keine gespiegelt ist

rotation-uncertain = die Drehung hat eine erweiterte Messunsicherheit von { FIXED($expanded_deg, 1) } deg (k = 2)
    .hint = Zielmarken mit größerem Abstand voneinander verwenden und prüfen, ob ihre Namen vertauscht sind

too-few-points = { $count ->
        [one] 1 Punkt ist
       *[other] { $count } Punkte sind
    } für das Element { $element } gegeben
    .expected = mindestens { $minimum } Punkte
    .hint = mehr Punkte messen oder alle Punkte nennen, die zum Element gehören

point-not-finite = Punkt { $number } des Elements { $element } hat die Koordinaten { $coordinates }
    .expected = endliche Koordinaten in Millimetern
    .hint = diesen Punkt im Export prüfen

points-degenerate = das Element { $element } kann nicht angepasst werden: { $spanned ->
        [0] alle Punkte sind gleich
        [1] alle Punkte liegen auf einer Geraden
       *[other] alle Punkte liegen in einer Ebene
    }
    .expected = Punkte, die { $spanned ->
            [0] verschieden sind
            [1] nicht auf einer Geraden liegen
           *[other] nicht in einer Ebene liegen
        }
    .hint = die Punkte über das Element verteilen

weights-unusable = die { $weights } Gewichte des Elements { $element } passen nicht zu seinen { $points } Punkten
    .expected = ein positives endliches Gewicht für jeden Punkt; zwei Gewichte im Verhältnis von höchstens 1e12
    .hint = 1/u² jedes Punktes verwenden; einen Punkt weglassen, statt ihm das Gewicht null zu geben

element-without-redundancy = das Element { $element } hat keinen überzähligen Punkt: die Residuen sind null und die Unsicherheit ist unbekannt
    .hint = mehr Punkte als die Mindestzahl messen

residuals-exceed-points = die Residuen ({ $element }) sind { FIXED($times, 1) } × die angegebene Unsicherheit der Punkte
    .hint = Form und Ausreißer prüfen; wenn die Form zählt, `--standard-uncertainty-um` weglassen: dann folgt die Unsicherheit aus den Residuen

points-repeated = { $count ->
        [one] 1 Punkt wiederholt
       *[other] { $count } Punkte wiederholen
    } einen früheren Punkt Ziffer für Ziffer, daher ist die Unsicherheit zu klein: { $points }
    .hint = die kopierten Punkte entfernen: sie sind keine weiteren Messungen

radius-uncertain = der Radius { FIXED($radius_mm, 6) } mm des Elements { $element } hat eine erweiterte Messunsicherheit von { SCIENTIFIC($expanded_mm, 2) } mm (95 %){ $covered_deg ->
        [none] {""}
       *[other] {" "}über { $covered_deg } deg
    }
    .hint = einen längeren Bogen messen oder den Radius auf dem Nennwert festhalten

element-direction-uncertain = die Richtung des Elements { $element } hat eine erweiterte Messunsicherheit von { FIXED($expanded_deg, 1) } deg (95 %)
    .hint = weiter auseinanderliegende Punkte messen, bei einer Ebene in beiden Richtungen, oder die Richtung festhalten

cone-is-cylinder = der Kegelwinkel ist nicht signifikant von null verschieden (k = 2)
    .hint = einen Zylinder anpassen

cone-is-plane = der Kegelwinkel ist nicht signifikant von 180 deg verschieden (k = 2): der Kegel ist eine Ebene
    .hint = eine Ebene anpassen

points-set-aside = { $count ->
        [one] 1 Punkt ist ausgeschlossen
       *[other] { $count } Punkte sind ausgeschlossen
    }: { $points }
    .hint = sie liegen weiter vom Element der anderen Punkte entfernt, als das Rauschen erklärt

points-outlying = { $count ->
        [one] 1 Punkt liegt weit vom Element der anderen Punkte ({ $points }) und verschiebt
       *[other] { $count } Punkte liegen weit vom Element der anderen Punkte ({ $points }) und verschieben
    } die Anpassung um { FIXED($shift, 1) } Standardunsicherheiten
    .hint = sie prüfen; `--robust` schließt sie aus

robust-few-points = eine robuste Anpassung des Elements { $element } braucht { $needed } Punkte, nicht { $points }
    .hint = mehr Punkte messen oder an alle anpassen, ohne Punkte auszuschließen
method-principal-directions = Hauptrichtungen der zentrierten Punkte
method-orthogonal-distance = orthogonaler Abstand, Gauß-Newton mit Trust-Region
method-circle-in-plane = Ebene nach kleinsten Quadraten, Projektion, Kreis in der Ebene nach orthogonalem Abstand

### Meldungen von compare; Erklärungen in en/compare.ftl.

stream-not-in-all = die Aufzeichnung `{ $stream }` ist nicht in jeder Kampagne vorhanden
    .hint = der Aufzeichnung derselben Bahn in allen Kampagnen denselben Namen geben

stream-commands-differ = die Sollpunkte der Aufzeichnung `{ $stream }` sind verschieden: AT und RT werden nicht verglichen
    .hint = in allen Kampagnen dieselbe Bahn, dasselbe Koordinatensystem und dieselben Werte von `path_points` und `near_mm` verwenden

stream-few-passes = AT und RT der Aufzeichnung `{ $stream }` beruhen auf { $passes ->
        [one] 1 Durchlauf
       *[other] { $passes } Durchläufen
    }; der Test auf Änderung wurde mit { $validated } Durchläufen validiert
    .hint = die Bahn zehnmal fahren (ISO 9283)

path-change-uncertain = signifikante Änderung: { $names }; in simulierten Prüfungen enthalten Intervalle von AT den wahren Wert in 93 % bis 95 % der Fälle, Intervalle von RT in 90 % bis 98 %
    .hint = die Prüfung wiederholen, bevor Folgerungen gezogen werden

nothing-to-compare = die Kampagnen haben keine gemeinsamen Ergebnisse
    .expected = parameters.json, iso9283.json oder iso9283-streams.json im Ordner jeder Kampagne
    .hint = die Kampagnen mit dieser Version ausführen: `etalon run KAMPAGNE`

one-campaign = ein Vergleich braucht mindestens zwei Kampagnen
    .expected = zwei Ordner oder mehr

campaign-twice = `{ $folder }` ist zweimal genannt
    .hint = jeden Ordner einmal nennen

robots-differ = verschiedene Roboter: `{ $first }` hat `{ $first_robot }` gemessen, `{ $second }` `{ $second_robot }`
    .hint = Kampagnen eines Roboters vergleichen; ist es derselbe, ihm in robot.toml überall denselben `name` geben und die Kampagnen erneut ausführen

models-differ = verschiedene Robotermodelle: `{ $first }` hat `{ $first_model }` identifiziert, `{ $second }` `{ $second_model }`
    .hint = beide mit demselben Modell identifizieren

parameters-differ = `{ $first }` und `{ $second }` haben verschiedene Parameter: { $parameters }
    .hint = dieselbe Roboterdatei, dieselben Zielmarken und dasselbe Modell verwenden

campaigns-with-same-readings = { $count ->
        [one] zwei Ordner enthalten
       *[other] Ordner enthalten
    } dieselben Messwerte: { $pairs }
    .hint = Exporte und Protokolle der späteren Kampagne durch die ihrer eigenen Messung ersetzen
same-readings = `{ $first }` und `{ $second }`

campaigns-out-of-order = `{ $first }` ist vor `{ $second }` genannt, hat aber das spätere Datum
    .hint = die früheste Kampagne zuerst angeben

document-not-in-all = { $document } wird nicht verglichen: es fehlt in { $folders }
    .hint = Kampagnen vergleichen, die alle dieses Dokument haben

poses-not-in-all = { $count ->
        [one] nicht in jeder Kampagne enthaltene Pose: { $poses }
       *[other] nicht in jeder Kampagne enthaltene Posen: { $poses }
    }
    .hint = der Name einer Pose muss in allen Kampagnen dieselbe Pose bedeuten

homing = Referenzfahrt

parameters-not-in-all = nicht jede Kampagne hat { $parameters } identifiziert
    .hint = dieselben Parameter identifizieren: ähnlich wirkende Parameter können die Abweichung der festgehaltenen aufgenommen haben

nominal-values-differ = die Nennwerte unterscheiden sich zwischen den Roboterdateien: { $parameters }
    .hint = dieselbe Roboterdatei verwenden: auf Nennwerten festgehaltene Parameter wirken auf die anderen

model-misfits = Residuen von { $campaigns } überschreiten die Unsicherheit des Messgeräts: Änderungen von Parametern und mittleren Abweichungen werden nicht getestet (keine p-Werte); die Intervalle der Parameter enthalten die Komponente zwischen den Serien (Birge-Verhältnis bis { $birge })
    .hint = mit einem Modell identifizieren, das den Roboter beschreibt, und jedes Mal dieselben Posen messen

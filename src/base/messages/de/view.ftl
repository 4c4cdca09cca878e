### Meldungen von view; Erklärungen in en/view.ftl.

view-busy = mehr als { $most } Verbindungen zugleich
    .hint = andere Seiten dieses Programms schließen und die Seite neu laden

view-request-malformed = die Anfrage ist nicht lesbar
    .hint = die Seite neu laden

view-request-slow = die Anfrage kam nicht rechtzeitig an
    .hint = die Anfrage erneut senden

view-request-without-length = die Anfrage gibt die Länge ihres Inhalts nicht an
    .hint = `Content-Length` angeben

view-request-too-large = die Datei ist größer als { $mib } MiB
    .hint = die Datei in den Ordner der Kampagne kopieren und die Seite neu laden

view-request-unknown = der Server kennt diese Adresse nicht
    .hint = die Seite von der Adresse laden, die das Programm ausgibt

view-other-host = die Anfrage nennt einen anderen Server
    .expected = { $name }
    .hint = die Seite von der Adresse laden, die das Programm ausgibt

view-other-origin = die Anfrage kommt von einer anderen Seite
    .hint = die andere Seite schließen

view-token-missing = das Token der Seite fehlt oder stammt von einem früheren Start
    .hint = die Adresse öffnen, die das Programm ausgibt

view-file-name = der Name der Datei ist kein einfacher Dateiname
    .expected = ein Name ohne Ordner und ohne die Zeichen : * ? " < > |
    .hint = die Datei umbenennen und erneut ablegen

view-download-unknown = die Seite bietet keine Datei dieses Namens an
    .hint = die Kampagne ausführen und eine Datei der Liste wählen

view-file-exists = `{ $name }` ist im Ordner bereits vorhanden
    .hint = die abgelegte Datei umbenennen oder die andere aus dem Ordner entfernen

view-folder-full = mehr als { $files } Dateien oder { $mib } MiB wurden abgelegt
    .hint = die Dateien in den Ordner der Kampagne kopieren und die Seite neu laden

view-file-not-dropped = `{ $name }` wurde nicht auf dieser Seite abgelegt
    .hint = die Datei im Ordner selbst entfernen

view-nothing-dropped = keine Datei mit Messwerten wurde abgelegt
    .hint = den Export des Messsystems und das Protokoll der Steuerung ablegen

view-campaign-exists = im Ordner ist bereits eine campaign.toml
    .hint = campaign.toml selbst ändern oder `etalon view` mit einem neuen Ordner starten

view-without-campaign = der Ordner enthält keine lesbare Kampagne
    .hint = Dateien ablegen und den Vorschlag annehmen oder campaign.toml berichtigen

view-run-in-progress = ein Lauf ist noch nicht beendet
    .hint = sein Ende abwarten

view-not-identified = die Kampagne hat keine Identifikation zum Vergleichen
    .hint = die Fehler der Kampagne beheben oder [identify] ergänzen

view-pose-unknown = Pose `{ $name }` wurde nicht gemessen
    .hint = eine gemessene Pose wählen

view-reason-missing = die Änderung hat keine Begründung
    .hint = angeben, warum die Kampagne geändert wird

view-nothing-asked = es wurde keine Änderung verlangt
    .hint = eine Pose oder Zielmarke weglassen, einen Parameter festhalten oder freigeben oder einen anderen Grenzwert angeben

view-campaign-not-editable = `{ $key }` kann die Seite in campaign.toml nicht ändern
    .hint = campaign.toml von Hand ändern, zum Beispiel mit [identify] als eigenem Abschnitt

view-parameter-stays-held = Parameter `{ $name }` ist nicht mit seinem Namen in `hold` festgehalten
    .hint = `hold` oder `effects` in [identify] von Hand ändern

view-port-unavailable = der Server kann Port { $port } nicht öffnen: { $error }
    .hint = einen anderen `--port` angeben; ohne `--port` wird ein freier Port gewählt

view-browser-not-opened = der Browser ließ sich nicht öffnen
    .hint = { $url } öffnen

watch-disagrees = Pose { $pose } widerspricht dem Modell: { FIXED($error_um, 0) } µm an { $target }, erwartet höchstens { FIXED($expected_um, 0) } µm
    .hint = die Pose erneut messen und Zielmarke und Gelenkwerte prüfen

watch-labels-exchanged = Pose { $pose } passt, wenn `{ $first }` und `{ $second }` vertauscht werden
    .hint = die Bezeichnungen im Messsystem berichtigen oder die Pose erneut messen

watch-joints-of-other-pose = Pose { $pose } passt zu den Gelenkwerten von Pose { $other }
    .hint = prüfen, wann die Steuerung das Protokoll schreibt: es ist vielleicht verspätet

watch-target-missing = an Pose { $pose } nicht gemessen: { $targets }
    .hint = die Zielmarke zum Messgerät drehen und die Pose erneut messen

watch-poses-gone = { $count ->
        [one] Pose { $poses } ist verschwunden
       *[other] { $count } Posen sind verschwunden: { $poses }
    }
    .hint = die Datei zurücklegen oder die Posen erneut messen

view-opened = Seite: { $url }
view-next = die Seite schließen oder Strg-C drücken, um das Programm zu beenden
view-run-begins = Dateien werden gelesen
view-run-writes = der Bericht wird geschrieben
view-next-drop = den Export des Messsystems und das Protokoll der Steuerung auf der Seite ablegen
view-verdict-limit = { $limit }: { FIXED($value, 4) } { $unit } ± { FIXED($expanded, 4) } { $unit } (k = 2), Grenzwert { FIXED($bound, 4) } { $unit }
view-verdict-limit-unknown = { $limit }: { FIXED($value, 4) } { $unit }, Grenzwert { FIXED($bound, 4) } { $unit }
view-verdict-no-limit = kein Grenzwert ist angegeben
view-download-report = Bericht ({ $kind })
view-download-file = Datei für eine Steuerung oder ein anderes Programm
view-question-instrument = Wie heißt das Messsystem?
view-question-uncertainty = Wie groß ist die erweiterte Messunsicherheit einer Koordinate (µm, k = 2)? Der Kalibrierschein gibt sie an.
view-question-rotation = Wie groß ist die erweiterte Messunsicherheit einer gemessenen Orientierung (°)?
view-question-unit = Welche Einheit haben die Längen in { $file }?
view-question-joint-unit = Welche Einheit haben die Gelenkwerte in { $file }?
view-question-time-unit = Welche Einheit haben die Zeiten in { $file }?
view-question-angle-unit = Welche Einheit haben die gemessenen Drehungen in { $file }?
view-question-rotation-order = In welcher Reihenfolge drehen die drei Winkel in { $file } (`zyx`, `fixed xyz`), oder sind sie ein Rotationsvektor (`vector`)?
view-question-world = Wurde im Koordinatensystem des Roboters gemessen? Andernfalls in [frame.world] aus Punkten festlegen.
view-question-robot = Welcher Roboter wurde gemessen?
view-question-key = Was ist `{ $key }` in [{ $section }]?
watch-waiting = die erste Pose wird erwartet
watch-few = { $received ->
        [one] { $received } Pose: zu wenige für eine Identifikation
       *[other] { $received } Posen: zu wenige für eine Identifikation
    }
watch-agrees = Pose { $pose } passt: { FIXED($error_um, 0) } µm, erwartet höchstens { FIXED($expected_um, 0) } µm
watch-first = { $received ->
        [one] { $received } Pose identifiziert
       *[other] { $received } Posen identifiziert
    }
watch-stop-met = Grenzwert mit Schutzabstand eingehalten: { FIXED($value_um, 0) } µm ± { FIXED($expanded_um, 0) } µm (k = 2), Grenzwert { FIXED($limit_um, 0) } µm
watch-stop-open = noch nicht: { FIXED($value_um, 0) } µm ± { FIXED($expanded_um, 0) } µm (k = 2), Grenzwert { FIXED($limit_um, 0) } µm
watch-stop-no-limit = kein Grenzwert ist angegeben: `position_max_mm` in [limits] angeben
watch-next-of-plan = nächste Pose des Plans
watch-next-of-most-information = von den übrigen Posen verringert diese Pose die Unsicherheit der Parameter am stärksten

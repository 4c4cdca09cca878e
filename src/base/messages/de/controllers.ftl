### Meldungen von controllers; Erklärungen in en/controllers.ftl.

compensate-programs = eine Sprache oder ein Hersteller von Roboterprogrammen: die Programme mit `etalon compensate PROGRAMM` korrigieren; `etalon cell` schreibt Werkzeug und Werkstückkoordinatensystem

controller-format-unknown = `{ $name }` ist kein Steuerungsformat

kind-hexapod = ein Hexapod (`hexapod`)

kind-five-bar = ein Fünfgelenkroboter (`five_bar`)

kind-six-axis-arm = ein serieller Arm mit sechs Drehgelenken

kind-delta = ein Deltaroboter (`delta`, `delta_linear`)

kind-delta-towers = ein Deltaroboter mit Linearachsen (`delta_linear`)

kind-urdf = ein Roboter, den eine URDF-Datei beschreibt (`urdf`)

kind-planar-or-serial = ein ebener Roboter oder ein serieller Arm

format-for-other-robots = das Format `{ $format }` kann keinen Roboter mit `model = "{ $model }"` beschreiben
    .expected = { $kind }
    .hint = ein anderes Format wählen: `etalon export --help` nennt die Formate

format-too-many-joints = der Roboter hat { $joints } Gelenke, das Format `{ $format }` erlaubt { $most }

urdf-malformed = `{ $file }` ist kein wohlgeformtes XML
    .hint = die Datei berichtigen

formulas-missing = die Kinematik von `{ $model }` kann nicht als Code geschrieben werden: etalon enthält für dieses Modell keine geschlossenen Formeln
    .hint = ein Format verwenden, das Parameter enthält: `json`, `csv`, `c-header`

formula-constant-not-finite = eine Konstante der Kinematik ist nicht endlich
    .hint = die identifizierten Parameter prüfen

error-above-nominal = Positionsabweichung an den { $set ->
        [validation] Validierungsposen
       *[other] Kalibrierposen
    }{ $left_out_count ->
        [0] {""}
       *[other] {" "}ohne { $left_out }
    }: { FIXED($written_mm, $decimals) } mm (RMS); mit Nennparametern: { FIXED($nominal_mm, $decimals) } mm

file-worse-than-nominal = Format `{ $format }` wird nicht geschrieben: { $reason }
    .hint = ein Format verwenden, das diese Parameter enthält; `etalon export --force` schreibt die Datei

error-near-nominal = { $case ->
        [rms] die Positionsabweichung ist nicht deutlich kleiner als mit Nennparametern
        [maximum] die größte Positionsabweichung ist größer als mit Nennparametern
       *[both] die Positionsabweichung ist nicht deutlich kleiner als mit Nennparametern, ihr Maximum ist größer
    }: { $set ->
        [validation] Validierungsposen
       *[other] Kalibrierposen
    } { FIXED($written_mm, $decimals) } mm (RMS), { FIXED($written_max_mm, $decimals) } mm (Maximum); mit Nennparametern { FIXED($nominal_mm, $decimals) } mm und { FIXED($nominal_max_mm, $decimals) } mm

file-near-nominal = { $formats_count ->
        [1] Format
       *[other] Formate
    } `{ $formats }`: { $reason }
    .hint = die Abweichungen in controllers.json vergleichen; falls Parameter ausgelassen sind, ein Format verwenden, das sie enthält

file-of-other-structure = Format `{ $format }`: die Achsen dieses Arms liegen anders als bei Armen von Universal Robots: { $difference }
    .hint = Konvention, Reihenfolge und Vorzeichen in robot.toml prüfen; für einen Arm eines anderen Herstellers ein anderes Format wählen: `etalon export --help` nennt die Formate

structure-angle = die Achsen { $first } und { $second } schließen { FIXED($deg, 1) }° ein statt { FIXED($expected, 0) }°

structure-no-link = die Achsen { $first } und { $second } sind parallel im Abstand von { FIXED($mm, 1) } mm, ohne Glied dazwischen

structure-apart = die Achsen { $first } und { $second } gehen im Abstand von { FIXED($mm, 1) } mm aneinander vorbei, statt sich zu schneiden

structure-wrist-meets = die Achsen 4 und 6 schneiden Achse 5 im Abstand von { FIXED($mm, 1) } mm statt im Abstand einer Handgelenklänge

structure-wrist-in-plane = das Handgelenk liegt { FIXED($mm, 1) } mm neben der Ebene von Achse 1; erwartet ist ein Schulterversatz

covariance-missing = Format `{ $format }` enthält { $parameters } nicht, und parameters.json enthält deren Kovarianz nicht
    .hint = die Kampagne mit `controllers = ["{ $format }"]` ausführen: der Lauf identifiziert ohne diese Parameter neu

parameters-not-converged = die Parameter sind für eine Steuerung nicht geeignet: { $termination }
    .hint = vor dem Export neu identifizieren

covariance-not-finite = die Kovarianz enthält eine nicht endliche Zahl
    .hint = die Identifikation erneut ausführen

parameter-not-finite = Parameter `{ $parameter }` enthält eine nicht endliche Zahl
    .expected = endliche Zahlen für Wert, Nennwert und Unsicherheit

parameter-twice = es gibt zwei Parameter `{ $parameter }`
    .hint = die Identifikation erneut ausführen

parameter-names-collide = die Parameter `{ $first }` und `{ $second }` heißen beide `{ $name }` in { $language }
    .hint = die Zielmarke oder das Gelenk umbenennen, das einem den Namen gibt, oder ein anderes Format verwenden

parameter-missing = die Parameter enthalten kein `{ $parameter }`
    .hint = die robot.toml angeben, mit der sie identifiziert wurden

positions-not-measured = das Format `{ $format }` enthält gemessene Positionen, aber zu diesen Parametern gehören keine
    .expected = die parameters.json im Ausgabeordner einer Kampagne, die Positionen gemessen hat

recording-failed = die Aufzeichnung kann nicht geschrieben werden: { $reason }

robot-missing = dieses Format braucht das Robotermodell
    .hint = die robot.toml angeben: `--robot DATEI`

robot-parameter-missing = der Roboter hat keinen Parameter `{ $parameter }`
    .hint = ein anderes Format wählen: `etalon export --help` nennt die Formate

deviation-steep = die Abweichung ändert sich von { $from } bis { $to } um { $change }
    .expected = höchstens 5 % des Abstands
    .hint = Positionen und Abweichungen in derselben Einheit angeben, mm oder deg

axis-table-too-long = { $positions } Positionen sind zu viele für { $controller }
    .expected = höchstens { $most }

axis-table-too-short = eine SINUMERIK-Tabelle hat { $positions ->
        [one] 1 Position
       *[other] { $positions } Positionen
    }
    .expected = mindestens zwei Positionen

axis-positions-uneven = die Positionen haben keinen gleichmäßigen Abstand
    .hint = in gleichen Abständen messen oder eine andere Tabelle verwenden

plane-steps-differ = das Raster hat entlang seiner Achsen verschiedene Abstände
    .expected = { $step_mm } mm entlang beider

galil-value-too-large = `{ $parameter }` ist zu groß für eine Variable einer Galil-Steuerung
    .hint = ein Format mit Gleitkommazahlen verwenden

galil-constant-too-large = { $name } = { FIXED($value, 6) } ist zu groß für die inverse Kinematik auf einer Galil-Steuerung
    .expected = höchstens { $most }

galil-rounding = `{ $parameter }` verliert auf einer Galil-Steuerung { SCIENTIFIC($rounding, 1) } { $unit } durch Rundung; seine Standardunsicherheit ist { SCIENTIFIC($uncertainty, 1) } { $unit }
    .hint = ein Format mit Gleitkommazahlen verwenden

galil-axes = { $joints } Gelenke sind zu viele für eine Galil-Steuerung
    .expected = höchstens acht

galil-counts-out-of-range = Ziel { $target }: { $counts } Inkremente liegen außerhalb des Bereichs
    .expected = höchstens { $most } Inkremente

certificate-date-missing = ein Kalibrierschein braucht das Datum der Messungen
    .expected = `date = "JJJJ-MM-TT"` in campaign.toml
    .hint = das Datum angeben und die Kampagne erneut ausführen

targets-not-finite = ein Wert des Plans ist nicht endlich
    .hint = Gelenkbereiche und Bedingungen des Plans prüfen; es wird kein Ziel geschrieben

targets-format-unknown = die Endung von `{ $file }` gehört zu keinem Format für Ziele
    .expected = ein Name, der auf `.json` oder `.h` endet
    .hint = für CSV `--poses` verwenden

axes-coincide = zwei Achsen des Arms fallen zusammen
    .hint = die robot.toml prüfen

platform-out-of-reach = die Plattform erreicht die Mitte nicht
    .hint = die identifizierten Längen prüfen

tower-order = die Säulen stehen nicht im Winkelabstand von 120 deg, von oben gesehen gegen den Uhrzeigersinn
    .hint = sie gegen den Uhrzeigersinn nummerieren: `{ $format }` verlangt diese Reihenfolge

move-incomplete = `{ $command }` gibt nicht { $coordinates } an
    .hint = alle Koordinaten angeben

x-and-y = X und Y

position-of-every-axis = eine Position jeder Achse

pose-of-six = alle Koordinaten X, Y, Z, A, B und C

working-mode-changes = das Programm wechselt den Arbeitsmodus
    .hint = die Ziele jedes Arbeitsmodus in einem eigenen Programm angeben

movement-not-compensated = `{ $command }` wird nicht kompensiert
    .expected = geradlinige Bewegungen auf absolute Koordinaten

subroutine-not-compensated = Variablen und Unterprogramme werden nicht kompensiert
    .hint = die Ziele als Zahlen schreiben

coordinate-not-number = auf `{ $letter }` folgt keine Zahl
    .hint = die Koordinate als Zahl schreiben

coordinate-unknown = `{ $letter }` hat noch keinen Wert
    .hint = ihn im ersten Satz mit einer Bewegung angeben

quaternion-length = das Quaternion von { $target } hat die Länge { FIXED($length, 4) }
    .expected = Länge 1

template-without-holds = die Vorlage nennt die Parameter nicht, die ihre Datei enthält
    .expected = eine erste Zeile wie `{"{#"} holds: theta_* {"#}"}`
    .hint = die Parameter nennen; `*` steht für beliebigen Text und `holds: *` für alle Parameter

convert-to-denavit-hartenberg = ein Arm aus Schraubachsen (`poe`) hat keine Nullpunkte von Gelenken: robot.toml mit `etalon robot convert robot.toml --to dh` schreiben und die Kampagne erneut ausführen

template-holds-unknown = kein Parameter entspricht `{ $pattern }`

template-parameters-unread = die Vorlage nennt { $count ->
        [one] 1 Parameter
       *[other] { $count } Parameter
    }, ohne ihren Wert zu schreiben: { $names }; die Abweichungen dieser Datei sind die einer anderen Datei
    .hint = nach `holds:` nur die Parameter nennen, die die Vorlage schreibt

template-name = der Name der Vorlage `{ $file }` endet nicht auf `.j2`
    .hint = die Vorlage umbenennen: NAME.j2 schreibt die Datei NAME

controller-template-failed = die Vorlage lässt sich nicht füllen: { $reason }
    .hint = diese Zeile berichtigen

measuring-language-unknown = die Sprache von { $file } ist unbekannt
    .expected = .mod (RAPID), .src (KRL), .script (URScript), .ls (FANUC), .kl (Karel), .jbi (INFORM) oder .ngc (G-Code) oder die Angabe `--program-language`

measuring-joints-unsuited = ein Programm in { $language } bewegt sechs Drehachsen{ $external ->
        [0] { "" }
       *[other] {" "}nach höchstens { $external } externen Linearachsen
    }; dieser Roboter hat { $revolute } Dreh- und { $prismatic } Linearachsen
    .hint = die Posen mit `--poses DATEI` oder `--targets DATEI` schreiben

measuring-motor-values = die Werte von Gelenk { $joint } sind die Werte seines Motors (Übertragungsfaktor { $gain }); ein Programm gibt keine Motorwerte vor
    .hint = die Posen mit `--poses DATEI` schreiben und in Gelenkwerte umrechnen

measuring-output-unsuited = `{ $output }` ist kein digitaler Ausgang von { $language }
    .expected = { $language ->
        [rapid] der Name eines Signals
       *[other] eine Zahl von { $first } bis { $last }
    }

measuring-axes-missing = ein Programm in { $language } braucht den Buchstaben jeder der { $joints } Achsen
    .hint = sie in der Reihenfolge der Gelenke angeben: `--axes BUCHSTABEN` (aus XYZABCUVW)

measuring-pulses-missing = ein Programm in { $language } braucht die Impulse je deg oder mm für jedes der { $joints } Gelenke
    .hint = sie in der Reihenfolge der Gelenke angeben: `--pulses P1,P2,...`


linuxcnc-distant-normal = die Achsen { $first } und { $second } sind fast parallel: `genserkins` hat ihre gemeinsame Normale in { FIXED($away_mm, 0) } mm Entfernung, so dass gerundete Werte den Flansch verschieben
    .hint = das Format `linuxcnc-component` verwenden, das Hayatis Winkel und Schraubachsen enthält

linuxcnc-joint-offsets = `genserkins` hat keine Gelenkversätze: ohne sie weicht der Flansch bei Gelenkwerten null um { FIXED($off_mm, 1) } mm ab. Versätze nach LinuxCNC-Gelenk (deg): { $offsets_deg }
    .hint = sie zu HOME_OFFSET, HOME, MIN_LIMIT und MAX_LIMIT von [JOINT_n] addieren oder `linuxcnc-component` verwenden

### Meldungen von formats: Eingabedateien, Exporte und ihre Zahlen; Erklärungen in en/exports.ftl.

in-file = `{ $file }`: { $message }

input-is-folder = `{ $folder }` ist ein Ordner
    .expected = eine Datei
    .hint = eine Datei darin angeben: { $files }

input-missing = die Datei `{ $file }` existiert nicht

simulate-the-file = sie aus truth.toml schreiben: `etalon simulate { $folder }`

place-the-file = die Datei an diesen Ort kopieren oder einen anderen Pfad angeben: Pfade in campaign.toml beginnen in deren Ordner, Pfade eines Befehls im aktuellen Ordner

name-a-file = der Ordner enthält { $files }

line-too-long = `{ $file }`: Zeile { $line } ist länger als { $most_mib } MiB
    .hint = die Datei als Text mit Zeilen exportieren: sie ist wohl eine binäre Aufzeichnung oder ein Archiv
database-unreadable = die SQLite-Datenbank ist nicht als Aufzeichnung von rosbag2 lesbar: { $fault ->
        [log] sie hat ein Write-Ahead-Log
        [tables] ihr fehlen die Tabellen `topics` und `messages`
        [encoding] ihre Texte sind in UTF-16
        [end] sie endet zu früh
        [page] eine Seite ist fehlerhaft
       *[record] ein Datensatz ist fehlerhaft
    }
    .hint = { $fault ->
        [log] das Log einarbeiten: sqlite3 DATEI "PRAGMA journal_mode=DELETE"
        [tables] ihre Tabelle als Text exportieren und die Spalten angeben
       *[record] die Datei erneut kopieren; `ros2 bag reindex ORDNER` repariert eine unterbrochene Aufzeichnung
    }

file-not-text = `{ $file }` ist { $kind ->
        [matlab] eine MATLAB-Datei
        [matlab-hdf5] eine MATLAB-Datei im Format -v7.3 (HDF5)
        [numpy] eine NumPy-Datei
        [hdf5] eine HDF5-Datei
        [gzip] mit gzip komprimiert
        [xls] eine alte Excel-Mappe (.xls)
        [rosbag1] eine Aufzeichnung von ROS 1 (.bag)
        [stl] eine binäre STL-Datei
        [ply] eine binäre PLY-Datei
        [pcd] eine binäre PCD-Datei
        [c3d] eine C3D-Datei
        [e57] eine E57-Datei
        [image] ein Bild
        [pickle] eine Pickle-Datei von Python
        [archive] ein Archiv
       *[pdf] ein PDF-Dokument
    }
    .expected = Text, eine Arbeitsmappe (.xlsx) oder eine Aufzeichnung (.mcap)
    .hint = { $kind ->
        [matlab] den Namen des Arrays als `sheet` angeben, in einem Protokoll auch `format = "matlab"`
        [matlab-hdf5] sie in MATLAB neu mit `-v7` speichern: S = load('DATEI'); save('NEU.mat', '-struct', 'S', '-v7')
        [numpy] den Namen des Arrays als `sheet` angeben, in einem Protokoll auch `format = "numpy"`
        [hdf5] die Tabelle als Text schreiben und die Spalten angeben
        [gzip] die Datei entpacken
        [xls] sie als .xlsx oder als Text speichern
        [rosbag1] sie umwandeln: `rosbags-convert --src DATEI --dst ORDNER --dst-storage mcap`; dann die .mcap-Datei und `topic` angeben
        [stl] ihr Format angeben: `format = "{ $kind }"` oder `--format { $kind }`
        [ply] ihr Format angeben: `format = "{ $kind }"` oder `--format { $kind }`
        [pcd] ihr Format angeben: `format = "{ $kind }"` oder `--format { $kind }`
        [c3d] ihr Format angeben: `format = "{ $kind }"` oder `--format { $kind }`
        [e57] ihr Format angeben: `format = "{ $kind }"` oder `--format { $kind }`
       *[pdf] die Punkte als Text exportieren
    }

vertices-of-mesh = die Punkte sind Eckpunkte eines Netzes, keine gemessenen Punkte
    .hint = die gemessenen Punkte als PLY oder als Text exportieren

positions-of-program = die Positionen eines Roboterprogramms sind Sollwerte, keine Messwerte
    .hint = sie als Sollposen verwenden

encoding-differs = die Datei beginnt mit der Byte-Reihenfolge-Marke (BOM) von { $of_file }; die Kampagne gibt { $stated } an
    .hint = `encoding` entfernen: die Marke der Datei gibt die Kodierung an

encoding-invalid = Byte { $byte } (Zeile { $line }, { $hex }) ist in { $encoding } nicht gültig
    .hint = die Kodierung der Datei angeben, zum Beispiel `encoding = "windows-1252"`

encoding-guessed = die Kodierung der Datei angeben, zum Beispiel `encoding = "{ $encoding }"`: der Text ist dann `{ $sample }`

nul-byte = die Datei enthält ein NUL-Byte (Zeile { $line })
    .expected = Text
    .hint = `encoding = "utf-16le"` angeben, falls die Datei UTF-16 ist; sonst die Datei neu exportieren

sheet-missing = die Arbeitsmappe hat kein Blatt `{ $sheet }`

sheet-too-large = Blatt `{ $sheet }` hat eine Zelle in Spalte { $column }, Zeile { $row }
    .expected = höchstens { $columns } Spalten und { $rows } Zeilen
    .hint = die Zelle löschen oder die Tabelle in ein eigenes Blatt kopieren

state-column-or-pose = `columns = {"{"} pose = "{ $heading }" {"}"}` mit der Überschrift der Spalte angeben (Option --column) oder `pose = "row"`, wenn die Zeilennummer die Nummer der Pose ist (Option --pose)
state-column-or-target = `columns = {"{"} target = "{ $heading }" {"}"}` mit der Überschrift der Spalte angeben (Option --column) oder `target = "NAME"`, wenn alle Zeilen zu einer Zielmarke gehören (Option --target)
state-column-or-cycle = die Überschrift der Spalte angeben, `columns = {"{"} cycle = "{ $heading }" {"}"}` (Option --column), oder `cycle = "visit"`, falls die Zeilen in der Reihenfolge der Messung stehen (Option --constant cycle=visit)

unpacked-too-large = { $kind ->
        [workbook] die entpackte Arbeitsmappe ist
        [arrays] die entpackten Arrays der Datei sind
       *[recording] die entpackte Aufzeichnung ist
    } größer als { $most_mib } MiB
    .hint = { $kind ->
        [workbook] das Blatt allein oder als Text speichern
        [arrays] die Arrays der Messung allein speichern
       *[recording] die Topics der Messung allein aufzeichnen
    }

workbook-unreadable = die Arbeitsmappe kann nicht gelesen werden: { $reason }
    .hint = sie neu als .xlsx speichern oder das Blatt als Text

cells-unordered = die Zellen von Blatt `{ $sheet }` sind nicht aufsteigend geordnet (Zeile { $row })

xml-malformed = das XML ist nicht wohlgeformt: { $reason }
    .hint = die Datei neu exportieren

entity-unknown = die Entität `&{ $name };` ist unbekannt

second-root-element = die Datei enthält ein zweites Wurzelelement

xml-doctype = die XML-Datei deklariert einen Dokumenttyp
    .hint = `<!DOCTYPE ...>` entfernen: Messungen brauchen keinen

tracim-test-missing = die Datei enthält keine Prüfdaten von TraCIM
    .expected = `tracim:test` mit mindestens einem `testElement`
    .hint = die Antwort des Servers unverändert speichern

tracim-package-unknown = das Prüfpaket `{ $package }` ist unbekannt
    .expected = `gauss:gaussTestPackage` oder `chebyshev:chebyshevTestPackage`

tracim-key-missing = die Prüfdaten haben keinen Prozessschlüssel
    .expected = `tracim:process` mit `tracim:key`
    .hint = die Antwort des Servers unverändert speichern

tracim-coordinate-missing = ein Punkt des Datensatzes `{ $id }` hat keine Koordinate `{ $coordinate }`
    .hint = die Antwort des Servers unverändert speichern

nested-too-deep = `{ $name }` ist { $depth } Ebenen tief geschachtelt
    .expected = höchstens { $most } Ebenen
    .hint = die Datei neu exportieren

file-too-many-items = die Datei hat mehr als { $most } { $items ->
        [elements] XML-Elemente
       *[points] Punkte in ihren Geometrieelementen
    }
    .hint = weniger Geometrieelemente auf einmal exportieren

file-cut-off = die Datei endet vor { $missing }
    .hint = die Datei neu exportieren oder kopieren: sie ist unvollständig

item-of-count = `{ $name }` { $number } von { $count }

export-again-or-add = die Datei neu exportieren oder kopieren; ist sie vollständig, die Zeile `{ $line }` ergänzen

format-differs = die Datei ist nicht im Format `{ $format }`
    .expected = { $signature }
    .hint = das Format der Datei angeben: `etalon formats DATEI` schlägt es vor

begins-with = eine Datei, die mit `{ $text }` beginnt

header-in-tabs = ein Kopf mit Tabulatoren zwischen { $names }

header-with = ein Kopf mit { $names }

records-like = Datensätze wie `{ $example }`

root-element = eine XML-Datei mit dem Wurzelelement `{ $name }`

version-unsupported = { $format } Version `{ $version }` wird nicht unterstützt
    .expected = { $versions }
    .hint = die Datei in einer unterstützten Version exportieren

record-invalid = `{ $text }` ist im Format `{ $format }` nicht gültig
    .expected = { $valid }

k-field-or-values = ein K-Feld wie `K2002/1 Ball 1.X` oder eine Zeile mit Werten

unicode-in-hexadecimal = Text oder `UNICODE( ... )` mit vier Hexadezimalziffern je Zeichen

three-numbers = drei Zahlen

record-too-early = `{ $record }` braucht vorher `{ $needed }`
    .hint = die Datei neu exportieren: ein Datensatz fehlt oder steht an falscher Stelle

record-missing = `{ $parent }` hat kein `{ $record }`
    .hint = die Datei mit diesem Datensatz exportieren

element-unsupported = `{ $element }` wird nicht unterstützt
    .hint = die Punkte ohne dieses Element exportieren

export-points-as-text = die Punkte als Text exportieren: QIF gibt die Bytefolge binärer Punkte nicht an

export-without-lists = die Punkte ohne Listen exportieren

no-measured-points = die Datei hat keine gemessenen Punkte{ $contents ->
        [none] {""}
       *[other] : sie enthält { $contents }
    }
    .expected = Datensätze `{ $records }`

measuring-program = ein Messprogramm

head-of-a-run = den Kopf eines Messlaufs

output-of-program = die Ausgabedatei angeben, die das Programm schreibt

calypso-head = die zugehörige Datei `_chr` oder `_fet` angeben; der Kopf nennt die Längeneinheit `{ $unit }` und eine Werkstücktemperatur von { $temperature } °C

export-measured-points = die gemessenen Punkte statt der Geometrie des Teils exportieren

export-one-dfq = Beschreibung und Werte in einer einzigen .dfq-Datei exportieren: eine .dfd-Datei enthält keine Werte, eine .dfx-Datei keine Namen

fields-of-columns = { $count } Felder, wie `columns` angibt

polyworks-fields = `x y z` oder `x y z i j k`, davor wahlweise ein Name

spatialanalyzer-fields = `collection, group, target, x, y, z` oder die letzten fünf, vier oder drei dieser Felder

three-to-eight-numbers = drei bis acht Zahlen, durch Kommas getrennt

propose-format = Trennzeichen, Dezimalzeichen und Anführungszeichen der Zeile prüfen und ob die Datei abgeschnitten ist; `etalon formats DATEI` schlägt vor, wie die Datei zu lesen ist

quote-names = Namen mit Leerzeichen in Anführungszeichen setzen oder Trennzeichen und Spalten angeben: `format = {"{"} delimiter = .., columns = .. {"}"}`

state-as-delimited = eine Datei mit Namen oder Tabulatoren als Text mit Trennzeichen angeben: `format = {"{"} delimiter = .., columns = .. {"}"}`

state-columns = die Achsen als Kommentar exportieren oder die Spalten angeben: format = {"{"} delimiter = "{ $delimiter }", comment = "//", columns = [{ $columns }] {"}"}

commas-in-commas = den Bericht mit Semikolons exportieren: Dezimalkommas sind von trennenden Kommas nicht unterscheidbar

number-count-differs = `{ $name }` hat { $found ->
        [one] 1 Zahl
       *[other] { $found } Zahlen
    }
    .expected = { $counts }
    .hint = die Datei neu exportieren: sie wurde bearbeitet oder abgeschnitten

three-per-point = drei Zahlen je Punkt

dmis-continuation = prüfen, ob die Datei abgeschnitten ist: ein Datensatz wird nur nach einer Zeile fortgesetzt, die mit `$` endet

stated-count-differs = `{ $name }` hat { $found ->
        [one] 1 Wert
       *[other] { $found } Werte
    }
    .expected = { $stated }, nach der Anzahl, die die Datei angibt
    .hint = die Datei neu exportieren: sie wurde bearbeitet oder abgeschnitten

cell-empty = `{ $column }` ist leer
    .hint = die Zelle ergänzen oder die Datei neu exportieren: sie wurde bearbeitet oder abgeschnitten

not-a-number = `{ $text }` ist keine Zahl
    .expected = eine Zahl mit dem Dezimalzeichen `{ $decimal }`{ $thousands ->
            [none] {""}
           *[other] {" "}und `{ $thousands }` zwischen Gruppen von drei Ziffern
        }

number-marks = falls die Datei Zahlen so schreibt, { $first }{ $second ->
        [none] {""}
       *[other] {" "}oder { $second }
    } angeben

format-with-decimal-comma = falls die Datei Dezimalkommas hat, `format = "{ $format }, decimal comma"` angeben

number-empty = eine Zahl fehlt
    .expected = eine Zahl mit dem Dezimalzeichen `{ $decimal }`{ $thousands ->
            [none] {""}
           *[other] {" "}und `{ $thousands }` zwischen Gruppen von drei Ziffern
        }

save-computed-workbook = die Formel hat keinen Wert: die Arbeitsmappe in dem Programm speichern, das sie berechnet

number-too-long = `{ $start }...` hat { $characters } Zeichen
    .expected = eine Zahl mit höchstens { $most } Zeichen
    .hint = die Datei neu exportieren oder ihr Trennzeichen angeben

pose-number-or-name = eine ganze Zahl oder ein Name wie `home`

whole-number = eine ganze Zahl

time-invalid = `{ $text }` ist kein Datum mit Uhrzeit
    .expected = eine Zeit wie `11.10.2022 15:06:48.043` oder `2022-10-11T15:06:48`

quote-unmatched = { $fault ->
        [open] ein Anführungszeichen wird in seiner Zeile nicht geschlossen
       *[behind] Text folgt auf ein schließendes Anführungszeichen
    }
    .hint = das Anführungszeichen schließen; innerhalb eines Felds in Anführungszeichen wird ein Anführungszeichen doppelt geschrieben

row-is-comment = die Zeile `{ $row }` würde als Kommentar gelesen
    .hint = ein anderes `comment` angeben

state-column-number = statt des Namens die Nummer der Spalte angeben

rows-after-end = auf `{ $end }`, das die Daten beendet, folgen Zeilen
    .hint = diese Zeilen oder `{ $end }` entfernen

coordinate-type-unknown = `types` gibt die Koordinaten des Typs `{ $name }` nicht an
    .expected = { $known }
    .hint = den Typ in `types` ergänzen

coordinates-not-cartesian = die Koordinaten sind `{ $found }`
    .expected = kartesische Koordinaten: { $cartesian }
    .hint = kartesische Koordinaten exportieren

export-cartesian-or-columns = kartesische Koordinaten exportieren oder die Spalten angeben: format = {"{"} delimiter = ",", comment = "//", columns = [{ $columns }], angle_unit = "deg" {"}"}

coordinate-system-differs = die Punkte von `{ $feature }` sind im Koordinatensystem `{ $found }`
    .expected = `{ $needed }`
    .hint = alle Punkte in demselben Koordinatensystem exportieren

coordinates-look-spherical = x, y und z sehen aus wie Azimut (rad), Zenitwinkel (rad) und Entfernung
    .expected = kartesische Koordinaten: alle Zeilen haben zwei kleine Winkel und eine Länge
    .hint = die Spalten "azimuth", "zenith", "distance" mit `angle_unit = "rad"` oder `coordinates = "cartesian"` angeben

orientation-incomplete = die Orientierung hat { $found } von { $needed } Zahlen
    .hint = die Orientierung vervollständigen oder alle ihre Zellen leer lassen

direction-not-unit = der Richtungsvektor ({ $i }; { $j }; { $k }) hat die Länge { FIXED($length, 3) }
    .expected = ein Einheitsvektor

skip-columns = die Spalten mit "-" auslassen, falls sie eine andere Größe enthalten

skip-direction-angles = die Spalten mit "-" auslassen: sie sind die Winkel der Richtung (deg)

direction-zero = der Richtungsvektor `{ $direction }` ist null
    .expected = drei Zahlen, nicht alle null

direction-notation-differs = die Richtung ist als { $found ->
        [angles] Winkel (deg)
       *[vector] Einheitsvektor
    } geschrieben
    .expected = { $found ->
            [angles] ein Einheitsvektor, wie in DMIS
           *[vector] Winkel (deg), wie GEOPAK sie schreibt
        }
    .hint = `format = "{ $format }"` angeben

unit-differs = die Datei ist in { $of_file } ({ $how }); angegeben ist die Einheit { $stated }
    .hint = ist der Kopf der Datei falsch, ihn dort berichtigen; sonst die Einheit der Datei angeben

default-of-format = kein `{ $record }`: Vorgabe des Formats

unit-unknown = `{ $unit }` ist keine bekannte Einheit
    .expected = { $units }
    .hint = die Datei in einer dieser Einheiten exportieren

file-unit-missing = die Datei gibt ihre { $quantity ->
        [length] Längeneinheit
       *[angle] Winkeleinheit
    } nicht an
    .expected = `{ $record }` mit Faktor in `FileUnits/PrimaryUnits`
    .hint = { $quantity ->
        [length] die Einheit angeben: `unit` des Exports oder `--unit`
       *[angle] die Datei mit ihren Einheiten exportieren
    }

unit-factor-invalid = die Einheit hat den Faktor { $factor } und den Versatz { $offset }
    .expected = ein positiver Faktor, kein Versatz

format-without-unit = im Format `{ $format }` ist die Einheit { $unit } nicht möglich
    .expected = { $units }
    .hint = eine dieser Einheiten angeben

format-not-simulated = `etalon simulate` kann { $kind ->
        [fixed] keine festen Breiten oder Arbeitsmappen
        [types] keine Zeilen mit eigener Koordinatenart
        [numbers] keine nur durch Nummern angegebenen Spalten
       *[qif] kein QIF
    } schreiben
    .hint = { $kind ->
        [fixed] für diesen Export ein `delimiter` angeben
        [types] `columns` mit einer Koordinatenart angeben
        [numbers] die Namen der Spalten angeben
       *[qif] für diesen Export `format = "polyworks"` oder ein Format mit Trennzeichen angeben
    }

label-pattern-invalid = { $fault ->
        [open] `{ $pattern }` hat ein `{"{"}` ohne `{"}"}`
        [unknown] `{ $pattern }` hat den unbekannten Namen `{ $name }`
       *[twice] `{ $pattern }` hat `{ $name }` zweimal
    }
    .expected = Text mit {"{"}target{"}"}, {"{"}pose{"}"} und {"{"}cycle{"}"}, je höchstens einmal
    .hint = `label` berichtigen

state-encoding = die Kodierung der Datei angeben: die Datei wurde mit einer anderen gelesen

several-data-sets = ein zweites `{ $record }`: die Datei hat mehrere Datensätze
    .hint = sie in eine Datei je Datensatz aufteilen, jede mit einem [[export]]

characteristic-beyond-count = es gibt kein Merkmal { $index }: K0100 gibt { $count } an
    .hint = die Datei neu exportieren: sie wurde bearbeitet oder aus mehreren Dateien zusammengesetzt

value-of-piece-missing = Wert { $number } von `{ $name }` gehört zu Teil { $piece }: ein früherer Wert fehlt
    .hint = nicht gemessene Werte mit dem Attribut 255 (K0002) exportieren

coordinate-counts-differ = `{ $name }` hat { $found ->
        [one] 1 Wert
       *[other] { $found } Werte
    }; eine andere Koordinate des Punktes hat { $count }
    .hint = nicht gemessene Werte mit dem Attribut 255 (K0002) exportieren

metric-misplaced = `METRIC` steht außerhalb der Spalten 11 bis 16: die Einheit ist mehrdeutig (Zoll oder mm)
    .expected = `XYZIJK    METRIC` oder `XYZIJK` allein für Zoll
    .hint = Zeile 1 berichtigen oder die Datei als Text mit Trennzeichen und ihrer Einheit angeben

vertex-not-finite = Punkt { $number } (`vertex`) hat die Koordinaten { $coordinates }
    .expected = endliche Koordinaten
    .hint = nur die gemessenen Punkte exportieren

line-number-differs = die Spalten 73 bis 80 enthalten `{ $digits }`: eine Zeilennummer oder einen Wert
    .expected = `{ $number }`, die Nummer dieser Zeile
    .hint = die Datei ohne Zeilennummern exportieren

feature-without-points = `{ $feature }` hat keine verwendbaren Punkte: { $message }

compensation-mixed = die Punkte sind verschieden um den Tasterradius korrigiert
    .hint = diese Punkte getrennt anpassen

reference-broken = `{ $name }` verweist auf { $id }: das ist kein `{ $kind }` dieser Datei

reference-external = die Punktmenge { $id } ist in einem anderen Dokument
    .hint = Geometrieelement und Punkte in einem Dokument exportieren

point-range-invalid = `{ $range }` ist kein Bereich der Punktmenge { $id } (Zeile { $line })
    .expected = ganze Zahlen von 1 bis { $count }, die kleinere zuerst

point-set-unused = kein Geometrieelement verweist auf die Punktmenge { $id }

id-repeated = die Kennung { $id } ist zweimal vergeben, zuerst in Zeile { $line }: Verweise gelten der ersten
    .hint = die Datei neu exportieren: sie wurde aus mehreren Dateien zusammengesetzt

further-messages = { $count ->
        [one] 1 weitere Meldung
       *[other] { $count } weitere Meldungen
    } zu dieser Datei

recording-unreadable = die Aufzeichnung kann nicht gelesen werden: { $fault ->
        [checksum] die Prüfsumme eines Blocks weicht ab
        [compression] ein Block ist anders als mit LZ4 oder Zstandard komprimiert
        [size] ein Block ist größer als 256 MiB
        [unpack] ein Block kann nicht entpackt werden
        [channel] eine Nachricht hat keinen Kanal
       *[end] sie endet mitten in einem Eintrag
    }
    .hint = sie mit `mcap recover DATEI -o REPARIERT` reparieren oder neu kopieren

recording-missing = die Datei ist keine Aufzeichnung von ROS 2 und enthält daher kein Topic `{ $topic }`
    .hint = die .mcap- oder .db3-Datei im Ordner der Aufzeichnung angeben oder `topic` weglassen

topic-not-stated = die Datei ist eine Aufzeichnung (MCAP), und `topic` fehlt

topic-missing = die Aufzeichnung hat keine Nachricht des Topics `{ $topic }`

topic-too-large = die Nachrichten des Topics `{ $topic }` sind größer als { $most_mib } MiB
    .hint = die Aufzeichnung auf die Zeit der Messungen kürzen: `mcap filter DATEI -o KURZ --start SEKUNDEN --end SEKUNDEN`

topic-type-unknown = das Topic `{ $topic }` hat Nachrichten des Typs `{ $message }`
    .expected = { $known }
    .hint = das Topic der Gelenkwerte oder der gemessenen Posen angeben: `etalon formats DATEI` nennt die Topics

topic-encoding-unknown = die Nachrichten des Topics `{ $topic }` haben die Kodierung `{ $encoding }`
    .expected = `cdr`, die Kodierung von ROS 2
    .hint = die Aufzeichnung nach ROS 2 umwandeln: `rosbags-convert --src DATEI --dst ORDNER --dst-storage mcap`

ros-message-malformed = die Nachricht { $number } des Topics `{ $topic }` hat nicht den Aufbau ihres Typs
    .hint = ohne `--compression-mode message` aufzeichnen; `ros2 bag convert` schreibt eine solche Aufzeichnung neu

joint-state-lengths-differ = die Nachricht { $number } des Topics `{ $topic }` hat { $names } Gelenknamen und { $positions } Positionen
    .expected = eine Position für jeden Namen oder keine Position
    .hint = den Knoten berichtigen, der das Topic veröffentlicht

joint-state-name-twice = die Nachricht { $number } des Topics `{ $topic }` nennt das Gelenk `{ $joint }` zweimal
    .hint = den Knoten berichtigen, der das Topic veröffentlicht

topic-without-positions = keine Nachricht des Topics `{ $topic }` hat Positionen ({ $count ->
        [one] 1 Nachricht
       *[other] { $count } Nachrichten
    })
    .hint = das Topic mit den gemessenen Positionen angeben: `etalon formats DATEI` nennt die Topics

ros-messages-of-other-joints = { $count ->
        [one] Nachricht
       *[other] erste von { $count } Nachrichten
    } ohne eines der Gelenke in `columns`: von einem anderen Knoten veröffentlicht

recording-without-known-topics = die Aufzeichnung hat kein Topic mit Gelenkwerten, Posen oder Punkten: { $found }
    .expected = sensor_msgs/JointState, geometry_msgs/PoseStamped oder geometry_msgs/PointStamped
    .hint = ein Topic mit einem dieser Typen aufzeichnen

array-missing = die Datei hat kein Zahlenarray `{ $column }`

array-part-unknown = `{ $column }` ist nicht genau eine Spalte: `{ $name }` hat die Größe { $shape }
    .hint = den Teil so schreiben wie in der Sprache, aus der die Datei stammt: `{ $example }`

array-lengths-differ = `{ $first }` hat { $count } Zahlen und `{ $second }` hat { $other }
    .expected = Spalten gleicher Länge
    .hint = Arrays einer einzigen Aufzeichnung angeben; eine Matrix, deren Spalten Zeitpunkte sind, hat ihre Gelenke in Zeilen

arrays-unreadable = die Datei kann nicht als Arrays von { $format ->
        [numpy] NumPy (.npz, .npy)
        [kuka_trace] KUKA.Trace (.dat mit Kanälen, und .r64)
       *[matlab] MATLAB (.mat im Format -v6 oder -v7)
    } gelesen werden
    .hint = sie neu speichern oder `format` berichtigen

numbers-file-missing = `{ $file }` fehlt: der Kopf allein enthält keine Zahlen
    .hint = alle Dateien der Aufzeichnung in einen Ordner kopieren

trace-of-motor = `Istposition` und `Sollposition` sind Positionen eines Motors, nicht eines Gelenks
    .hint = die Aufzeichnung `..._KRCIpo.dat` verwenden, mit `q1_deg = "AxisPos_Act1"`

trace-storage-unknown = Kanal `{ $channel }` ist als `{ $storage }` gespeichert
    .expected = REAL64, REAL32, INT32, INT16, WORD32 oder WORD16
    .hint = den Datensatz mit REAL64 speichern oder in CSV umwandeln

trace-values-missing = die Datei der Zahlen hat weniger als die { $count } Werte des Kanals `{ $channel }`
    .hint = die Dateien der Aufzeichnung erneut kopieren

sheet-not-stated = das Blatt der Arbeitsmappe ist nicht angegeben; die Arbeitsmappe enthält { $sheets }
    .hint = das Blatt (`sheet`) angeben

state-sheet = `sheet = "{ $sheet }"` angeben (Option --sheet)

state-column = ist es die Spalte `{ $heading }`, `columns = {"{"} { $column } = "{ $heading }" {"}"}` angeben (Option --column)
state-column-of = ihre Überschrift angeben: `columns = {"{"} { $column } = "HEADING" {"}"}` (Option --column); Überschriften, die nichts liest: { $names }
state-column-in-unit = falls es die Spalte `{ $heading }` ist: `columns = {"{"} { $column } = "{ $heading }" {"}"}` angeben (Option --column); ihre Werte sprechen für { $unit }
state-columns-together = `columns = {"{"} { $columns } {"}"}` angeben (Option --column)
row-marked-deleted = weggelassen: als gelöscht markiert (`{ $cell }`)
row-left-out-by-cell = weggelassen: `{ $column }` ist `{ $cell }`
row-without-coordinates = nicht gemessen: keine Koordinaten
row-cell-empty = nicht gemessen: { $column } ist leer
row-invisible = nicht gemessen: 0 0 0 mit dem Quaternion 0 0 0 0
row-not-measured = nicht gemessen: { $column } ist `{ $cell }`
characteristic-of-no-axis = keine Koordinate: der Name des Merkmals endet nicht auf X, Y oder Z
feature-of-no-point = ein Geometrieelement `{ $kind }`: sein Punkt kann überall auf dem Element liegen
feature-not-read = ein Geometrieelement `{ $kind }`: diese Art wird nicht gelesen
point-incomplete = kein Punkt: { $found } ohne { $missing }
probe-centre-no-point = ein Tastermittelpunkt, kein Punkt des Geometrieelements

log-delimited = Trennzeichen `{ $delimiter }`, Dezimalzeichen `{ $decimal }`
log-of-arrays = Arrays von { $format }
log-of-sheet = Arbeitsmappe, Blatt `{ $sheet }`
log-of-topic = ROS-Aufzeichnung, Topic `{ $topic }`
log-of-format = { $format }, { $read }
log-with-start = { $read }, Beginn { $start }
read-with-decimal-comma = { $format }, Dezimalzeichen `,`

value-without-label = ein Wert ohne Bezeichnung
primitive-no-point = ein Grundelement der Art `{ $kind }`, kein Punkt

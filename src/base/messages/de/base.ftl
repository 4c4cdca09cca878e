### Meldungen von base; Erklärungen in en/base.ftl.

also-in-lines = { $message }; ebenso in den Zeilen { $second }, { $third } und { $more ->
        [one] 1 weiteren Zeile
       *[other] { $more } weiteren Zeilen
    }

did-you-mean = war `{ $name }` gemeint?

expected-whole-number = ganze Zahl von 0 bis { $most } erwartet
is-a-folder = es ist ein Ordner
meant-in-unit = in `{ $name }` umrechnen: 1 { $from } = { $factor } { $to }

name-without-unit = die Einheit ergänzen: { $names }

known-names = einen dieser Namen verwenden: { $names }

known-names-first = einen dieser Namen verwenden: { $names }, ...

no-regular-file = es ist eine Pipe, ein Socket oder ein Gerät, eine gewöhnliche Datei wird erwartet
pose-name-empty = der Name der Pose ist leer
    .expected = eine ganze Zahl oder ein Name wie `home` oder `A-3`

pose-name-too-long = der Name der Pose hat { $characters } Zeichen
    .expected = höchstens { $most } Zeichen: eine ganze Zahl oder ein Name wie `home` oder `A-3`

pose-name-unprintable = eine Tabelle kann den Namen `{ $name }` nicht enthalten
    .expected = eine ganze Zahl oder ein Name wie `home` oder `A-3`

pose-name-two-spellings = `{ $first }` und `{ $second }` unterscheiden sich nur in Groß- und Kleinschreibung, Leerzeichen, `_`, `-`, Nullen oder unsichtbaren Zeichen
    .hint = den Namen einer Pose in allen Zeilen und Dateien gleich schreiben

counts-too-large = zu viele { $of }: { $counts }
    .expected = höchstens { $most }

cannot-read-file = `{ $file }` kann nicht gelesen werden: { $reason }

file-too-large = `{ $file }` kann nicht gelesen werden: größer als { $most_mib } MiB

not-utf8 = `{ $file }` ist nicht UTF-8 (Byte { $byte })
    .hint = die Datei als UTF-8 speichern

cannot-write-file = `{ $file }` kann nicht geschrieben werden: { $reason }

file-exists = `{ $file }` ist schon vorhanden
    .hint = einen neuen Ordner angeben

lock-foreign = `{ $file }` kann nicht geschrieben werden: `{ $lock }` ist keine Sperrdatei von etalon
    .expected = eine gewöhnliche Datei ohne weitere harte Links
    .hint = die Datei entfernen: etalon braucht diesen Namen für seine Sperrdatei

output-through-link = `{ $file }` kann nicht geschrieben werden: `{ $link }` ist ein symbolischer Link
    .expected = ein Ordner oder eine Datei, deren Pfad keinen symbolischen Link enthält
    .hint = den Link durch einen Ordner ersetzen oder das Ziel des Links angeben

output-not-a-file = `{ $file }` kann nicht geschrieben werden: es ist ein Gerät, eine Pipe oder ein Socket
    .hint = eine gewöhnliche Datei angeben

template-failed = die Vorlage `{ $template }` { $fault ->
        [time] braucht mehr als eine Minute
        [memory] braucht mehr als 2 GiB Speicher
        [ended] endet ohne Ergebnis
       *[other] kann nicht ausgeführt werden: { $fault }
    }
    .hint = die Schleifen der Vorlage prüfen: jede muss enden

template-too-nested = Zeile { $line } der Vorlage `{ $template }` hat mehr als { $most } Ebenen von Klammern, Operatoren und Blöcken
    .hint = den Ausdruck mit `set` zerlegen

template-width = eine Breite von mehr als { $most }
template-size = ein Text von mehr als { $most_mib } MiB
template-instructions = mehr als { $most } Anweisungen

environment-date = die Umgebungsvariable `SOURCE_DATE_EPOCH` ist `{ $value }`
    .expected = die Sekunden seit 1970, von 0 bis zum Jahr 9999
    .hint = eine ganze Zahl angeben oder die Variable löschen

environment-threads = die Umgebungsvariable `{ $name }` ist `{ $threads }`
    .expected = höchstens { $most } Threads
    .hint = die Zahl der Kerne angeben oder die Variable löschen

locked = Prozess { $process } schreibt `{ $file }`
    .hint = warten, bis er beendet ist

output-is-input = `{ $output }` würde die Eingabe `{ $input }` überschreiben
    .hint = eine andere Ausgabedatei angeben

cannot-write-folder = der Ordner `{ $folder }` kann nicht geschrieben werden: { $reason }

cannot-encode = { $format } kann nicht geschrieben werden: { $reason }

angle-order-unknown = `{ $text }` ist keine Reihenfolge von drei Winkeln
    .expected = "zyx", "xyz", "zyz" .. um die Achsen des Körpers oder "fixed xyz" .. um die Achsen des Weltkoordinatensystems

pose-number-too-large = die Nummer einer Pose ist größer als 9223372036854775807
rotation-not-orthonormal = die Rotationsmatrix ist nicht orthonormal: Skalarprodukte ihrer Zeilen weichen um { $off } von 1 oder 0 ab
    .expected = r11 bis r33, zeilenweise: Orientierung des Körpers im Weltkoordinatensystem

rotation-mirrors = die Rotationsmatrix enthält eine Spiegelung: ihre Determinante ist -1
    .hint = die Vorzeichen ihrer Spalten prüfen

factor = { $of ->
        [poses] { $count ->
            [one] 1 Pose
           *[other] { $count } Posen
        }
        [cycles] { $count ->
            [one] 1 Zyklus
           *[other] { $count } Zyklen
        }
        [repeats] { $count ->
            [one] 1 Wiederholung
           *[other] { $count } Wiederholungen
        }
        [draws] { $count ->
            [one] 1 Ziehung
           *[other] { $count } Ziehungen
        }
       *[runs] { $count ->
            [one] 1 Lauf
           *[other] { $count } Läufe
        }
    }
product = { $first } × { $second }
unknown-country = unbekannter Ländercode `{ $code }`, zwei Großbuchstaben nach ISO 3166-1 werden erwartet, zum Beispiel CA, DE oder GB

### Messages de formats : fichiers d’entrée, exports et leurs nombres ; explications dans en/exports.ftl.

in-file = `{ $file }` : { $message }

input-is-folder = `{ $folder }` est un dossier
    .expected = un fichier
    .hint = indiquer un fichier de ce dossier : { $files }

input-missing = le fichier `{ $file }` n’existe pas

simulate-the-file = l’écrire à partir de truth.toml : `etalon simulate { $folder }`

place-the-file = copier le fichier à cet endroit, ou indiquer un autre chemin : les chemins de campaign.toml partent de son dossier, les chemins d’une ligne de commande partent du dossier courant

name-a-file = le dossier contient { $files }

line-too-long = `{ $file }` : la ligne { $line } dépasse { $most_mib } Mio
    .hint = exporter les mesures en texte, une ligne par mesure : le fichier est peut-être un enregistrement binaire ou une archive
database-unreadable = la base SQLite ne se lit pas comme un enregistrement de rosbag2 : { $fault ->
        [log] elle a un journal d’écriture (WAL)
        [tables] les tables `topics` et `messages` y manquent
        [encoding] ses textes sont en UTF-16
        [end] elle se termine trop tôt
        [page] une page est malformée
       *[record] un enregistrement est malformé
    }
    .hint = { $fault ->
        [log] intégrer le journal : sqlite3 FICHIER "PRAGMA journal_mode=DELETE"
        [tables] exporter sa table en texte, et indiquer les colonnes
       *[record] copier de nouveau le fichier ; `ros2 bag reindex DOSSIER` répare un enregistrement interrompu
    }

file-not-text = `{ $file }` est { $kind ->
        [matlab] un fichier MATLAB
        [matlab-hdf5] un fichier MATLAB au format -v7.3 (HDF5)
        [numpy] un fichier NumPy
        [hdf5] un fichier HDF5
        [gzip] compressé avec gzip
        [xls] un ancien classeur Excel (.xls)
        [rosbag1] un enregistrement de ROS 1 (.bag)
        [stl] un fichier STL binaire
        [ply] un fichier PLY binaire
        [pcd] un fichier PCD binaire
        [c3d] un fichier C3D
        [e57] un fichier E57
        [image] une image
        [pickle] un fichier pickle de Python
        [archive] une archive
       *[pdf] un document PDF
    }
    .expected = du texte, un classeur (.xlsx) ou un enregistrement (.mcap)
    .hint = { $kind ->
        [matlab] indiquer le nom de son tableau comme `sheet`, ou dans un journal `format = "matlab"`
        [matlab-hdf5] l’enregistrer de nouveau dans MATLAB avec `-v7` : S = load('FICHIER'); save('NOUVEAU.mat', '-struct', 'S', '-v7')
        [numpy] indiquer le nom de son tableau comme `sheet`, ou dans un journal `format = "numpy"`
        [hdf5] exporter son tableau en texte, et indiquer les colonnes
        [gzip] décompresser le fichier
        [xls] l’enregistrer en .xlsx ou en texte
        [rosbag1] le convertir : `rosbags-convert --src FICHIER --dst DOSSIER --dst-storage mcap` ; puis indiquer le fichier .mcap et `topic`
        [stl] indiquer son format : `format = "{ $kind }"`, ou `--format { $kind }`
        [ply] indiquer son format : `format = "{ $kind }"`, ou `--format { $kind }`
        [pcd] indiquer son format : `format = "{ $kind }"`, ou `--format { $kind }`
        [c3d] indiquer son format : `format = "{ $kind }"`, ou `--format { $kind }`
        [e57] indiquer son format : `format = "{ $kind }"`, ou `--format { $kind }`
       *[pdf] exporter les points en texte
    }

vertices-of-mesh = les points sont les sommets d’un maillage, et non des points mesurés
    .hint = exporter les points mesurés en PLY ou en texte

positions-of-program = les positions d’un programme de robot sont commandées, et non mesurées
    .hint = les utiliser comme poses commandées

encoding-differs = le fichier commence par la marque d’ordre des octets (BOM) de { $of_file } ; la campagne indique { $stated }
    .hint = supprimer `encoding` : la marque du fichier indique déjà l’encodage

encoding-invalid = l’octet { $byte } (ligne { $line }, { $hex }) n’est pas valable en { $encoding }
    .hint = indiquer l’encodage du fichier, par exemple `encoding = "windows-1252"`

encoding-guessed = indiquer l’encodage du fichier, par exemple `encoding = "{ $encoding }"` : le texte est alors `{ $sample }`

nul-byte = le fichier contient un octet NUL (ligne { $line })
    .expected = du texte
    .hint = indiquer `encoding = "utf-16le"` si le fichier est en UTF-16 ; sinon exporter de nouveau le fichier

sheet-missing = le classeur n’a pas de feuille `{ $sheet }`

sheet-too-large = la feuille `{ $sheet }` a une cellule en colonne { $column }, ligne { $row }
    .expected = au plus { $columns } colonnes et { $rows } lignes
    .hint = supprimer la cellule ou copier le tableau dans une feuille à part

state-column-or-pose = indiquer `columns = {"{"} pose = "{ $heading }" {"}"}` avec son en-tête (option --column), ou `pose = "row"` si le numéro de la ligne est celui de la pose (option --pose)
state-column-or-target = indiquer `columns = {"{"} target = "{ $heading }" {"}"}` avec son en-tête (option --column), ou `target = "NAME"` si toutes les lignes sont d’une seule cible (option --target)
state-column-or-cycle = indiquer l’en-tête de la colonne, `columns = {"{"} cycle = "{ $heading }" {"}"}` (option --column), ou `cycle = "visit"` si les lignes sont dans l’ordre des mesures (option --constant cycle=visit)

unpacked-too-large = { $kind ->
        [workbook] le classeur décompressé dépasse
        [arrays] les tableaux décompressés du fichier dépassent
       *[recording] l’enregistrement décompressé dépasse
    } { $most_mib } Mio
    .hint = { $kind ->
        [workbook] enregistrer la feuille seule, ou comme texte
        [arrays] enregistrer seuls les tableaux de la mesure
       *[recording] enregistrer seuls les topics de la mesure
    }

workbook-unreadable = le classeur ne peut pas être lu : { $reason }
    .hint = l’enregistrer de nouveau en .xlsx, ou enregistrer la feuille en texte

cells-unordered = les cellules de la feuille `{ $sheet }` ne sont pas en ordre croissant (ligne { $row })

xml-malformed = le XML n’est pas bien formé : { $reason }
    .hint = exporter de nouveau le fichier

entity-unknown = l’entité `&{ $name };` est inconnue

second-root-element = le fichier contient un second élément racine

xml-doctype = le fichier XML déclare un type de document
    .hint = supprimer `<!DOCTYPE ...>` : des mesures n’en ont pas besoin

tracim-test-missing = le fichier ne contient pas de données d’essai TraCIM
    .expected = `tracim:test` avec au moins un `testElement`
    .hint = enregistrer la réponse du serveur telle quelle

tracim-package-unknown = le lot d’essais `{ $package }` est inconnu
    .expected = `gauss:gaussTestPackage` ou `chebyshev:chebyshevTestPackage`

tracim-key-missing = les données d’essai n’ont pas de clé de processus
    .expected = `tracim:process` avec `tracim:key`
    .hint = enregistrer la réponse du serveur telle quelle

tracim-coordinate-missing = un point du jeu de données `{ $id }` n’a pas de coordonnée `{ $coordinate }`
    .hint = enregistrer la réponse du serveur telle quelle

nested-too-deep = `{ $name }` est imbriqué à { $depth } niveaux
    .expected = au plus { $most } niveaux
    .hint = exporter de nouveau le fichier

file-too-many-items = le fichier a plus de { $most } { $items ->
        [elements] éléments XML
       *[points] points dans ses éléments géométriques
    }
    .hint = exporter moins d’éléments géométriques à la fois

file-cut-off = le fichier se termine avant { $missing }
    .hint = exporter ou copier de nouveau le fichier : il est incomplet

item-of-count = `{ $name }` { $number } sur { $count }

export-again-or-add = exporter ou copier de nouveau le fichier ; s’il est complet, ajouter la ligne `{ $line }`

format-differs = le fichier n’est pas au format `{ $format }`
    .expected = { $signature }
    .hint = indiquer le format du fichier : `etalon formats FICHIER` le propose

begins-with = un fichier qui commence par `{ $text }`

header-in-tabs = un en-tête séparé par des tabulations avec { $names }

header-with = un en-tête avec { $names }

records-like = des enregistrements comme `{ $example }`

root-element = un fichier XML dont l’élément racine est `{ $name }`

version-unsupported = la version `{ $version }` de { $format } n’est pas prise en charge
    .expected = { $versions }
    .hint = exporter le fichier dans une version prise en charge

record-invalid = `{ $text }` n’est pas valable au format `{ $format }`
    .expected = { $valid }

k-field-or-values = un champ K comme `K2002/1 Ball 1.X`, ou une ligne de valeurs

unicode-in-hexadecimal = du texte, ou `UNICODE( ... )` avec quatre chiffres hexadécimaux par caractère

three-numbers = trois nombres

record-too-early = `{ $record }` doit être précédé de `{ $needed }`
    .hint = exporter de nouveau le fichier : un enregistrement manque ou est mal placé

record-missing = `{ $parent }` n’a pas de `{ $record }`
    .hint = exporter le fichier avec cet enregistrement

element-unsupported = `{ $element }` n’est pas pris en charge
    .hint = exporter les points sans cet élément

export-points-as-text = exporter les points en texte : QIF n’indique pas l’ordre des octets des points binaires

export-without-lists = exporter les points sans listes

no-measured-points = le fichier n’a pas de points mesurés{ $contents ->
        [none] {""}
       *[other] {" "}: il contient { $contents }
    }
    .expected = des enregistrements `{ $records }`

measuring-program = un programme de mesure

head-of-a-run = l’en-tête d’une exécution

output-of-program = indiquer le fichier de sortie que le programme écrit

calypso-head = indiquer le fichier `_chr` ou `_fet` qui l’accompagne ; l’en-tête donne l’unité de longueur `{ $unit }` et une température de pièce de { $temperature } °C

export-measured-points = exporter les points mesurés au lieu de la géométrie de la pièce

export-one-dfq = exporter la description et les valeurs dans un seul fichier .dfq : un fichier .dfd ne contient pas de valeurs, un fichier .dfx pas de noms

fields-of-columns = { $count } champs, comme l’indique `columns`

polyworks-fields = `x y z` ou `x y z i j k`, éventuellement précédés d’un nom

spatialanalyzer-fields = `collection, group, target, x, y, z`, ou les cinq, quatre ou trois derniers de ces champs

three-to-eight-numbers = trois à huit nombres séparés par des virgules

propose-format = vérifier le séparateur de colonnes, le séparateur décimal et les guillemets de la ligne, et que le fichier n’est pas tronqué ; `etalon formats FICHIER` propose une lecture du fichier

quote-names = mettre entre guillemets les noms qui contiennent des espaces, ou indiquer le séparateur et les colonnes : `format = {"{"} delimiter = .., columns = .. {"}"}`

state-as-delimited = déclarer comme texte délimité un fichier qui contient des noms ou des tabulations : `format = {"{"} delimiter = .., columns = .. {"}"}`

state-columns = exporter les axes en commentaire, ou indiquer les colonnes : format = {"{"} delimiter = "{ $delimiter }", comment = "//", columns = [{ $columns }] {"}"}

commas-in-commas = exporter le rapport avec des points-virgules : les virgules décimales ne se distinguent pas des virgules de séparation

number-count-differs = `{ $name }` a { $found ->
        [one] { $found } nombre
       *[other] { $found } nombres
    }
    .expected = { $counts }
    .hint = exporter de nouveau le fichier : il a été modifié ou tronqué

three-per-point = trois nombres par point

dmis-continuation = vérifier si le fichier est tronqué : un enregistrement ne se poursuit qu’après une ligne terminée par `$`

stated-count-differs = `{ $name }` a { $found ->
        [one] { $found } valeur
       *[other] { $found } valeurs
    }
    .expected = { $stated }, d’après le nombre indiqué dans le fichier
    .hint = exporter de nouveau le fichier : il a été modifié ou tronqué

cell-empty = `{ $column }` est vide
    .hint = compléter la cellule, ou exporter de nouveau le fichier : il a été modifié ou tronqué

not-a-number = `{ $text }` n’est pas un nombre
    .expected = un nombre avec le séparateur décimal `{ $decimal }`{ $thousands ->
            [none] {""}
           *[other] {" "}et `{ $thousands }` entre groupes de trois chiffres
        }

number-marks = si les nombres du fichier sont écrits ainsi, indiquer { $first }{ $second ->
        [none] {""}
       *[other] {" "}ou { $second }
    }

format-with-decimal-comma = si le fichier a des virgules décimales, indiquer `format = "{ $format }, decimal comma"`

number-empty = un nombre manque
    .expected = un nombre avec le séparateur décimal `{ $decimal }`{ $thousands ->
            [none] {""}
           *[other] {" "}et `{ $thousands }` entre groupes de trois chiffres
        }

save-computed-workbook = la formule n’a pas de valeur : enregistrer le classeur dans le programme qui la calcule

number-too-long = `{ $start }...` a { $characters } caractères
    .expected = un nombre d’au plus { $most } caractères
    .hint = exporter de nouveau le fichier, ou indiquer son séparateur

pose-number-or-name = un nombre entier, ou un nom comme `home`

whole-number = un nombre entier

time-invalid = `{ $text }` n’est pas une date avec une heure
    .expected = une heure comme `11.10.2022 15:06:48.043` ou `2022-10-11T15:06:48`

quote-unmatched = { $fault ->
        [open] un guillemet n’est pas fermé sur sa ligne
       *[behind] du texte suit un guillemet fermant
    }
    .hint = fermer le guillemet ; à l’intérieur d’un champ entre guillemets, un guillemet s’écrit deux fois

row-is-comment = la ligne `{ $row }` serait lue comme un commentaire
    .hint = indiquer un autre `comment`

state-column-number = indiquer le numéro de la colonne au lieu de son nom

rows-after-end = des lignes suivent `{ $end }`, qui termine les données
    .hint = supprimer ces lignes, ou `{ $end }`

coordinate-type-unknown = `types` n’indique pas les coordonnées du type `{ $name }`
    .expected = { $known }
    .hint = ajouter le type à `types`

coordinates-not-cartesian = les coordonnées sont `{ $found }`
    .expected = des coordonnées cartésiennes : { $cartesian }
    .hint = exporter des coordonnées cartésiennes

export-cartesian-or-columns = exporter des coordonnées cartésiennes, ou indiquer les colonnes : format = {"{"} delimiter = ",", comment = "//", columns = [{ $columns }], angle_unit = "deg" {"}"}

coordinate-system-differs = les points de `{ $feature }` sont dans le système `{ $found }`
    .expected = `{ $needed }`
    .hint = exporter tous les points dans un même système de coordonnées

coordinates-look-spherical = x, y et z ressemblent à un azimut (rad), un angle zénithal (rad) et une distance
    .expected = des coordonnées cartésiennes : toutes les lignes ont deux petits angles et une longueur
    .hint = indiquer les colonnes "azimuth", "zenith", "distance" avec `angle_unit = "rad"`, ou `coordinates = "cartesian"`

orientation-incomplete = l’orientation a { $found } nombres sur { $needed }
    .hint = compléter l’orientation, ou laisser vides toutes ses cellules

direction-not-unit = la direction ({ $i } ; { $j } ; { $k }) a pour norme { FIXED($length, 3) }
    .expected = un vecteur unitaire

skip-columns = ignorer ces colonnes avec "-" si elles contiennent une autre grandeur

skip-direction-angles = ignorer ces colonnes avec "-" : ce sont les angles de la direction (deg)

direction-zero = le vecteur de direction `{ $direction }` est nul
    .expected = trois nombres, non tous nuls

direction-notation-differs = la direction est écrite comme { $found ->
        [angles] des angles (deg)
       *[vector] un vecteur unitaire
    }
    .expected = { $found ->
            [angles] un vecteur unitaire, comme en DMIS
           *[vector] des angles (deg), comme les écrit GEOPAK
        }
    .hint = indiquer `format = "{ $format }"`

unit-differs = le fichier est en { $of_file } ({ $how }) ; l’unité indiquée est { $stated }
    .hint = si l’en-tête du fichier est faux, le corriger dans le fichier ; sinon indiquer l’unité du fichier

default-of-format = pas de `{ $record }` : valeur par défaut du format

unit-unknown = `{ $unit }` n’est pas une unité connue
    .expected = { $units }
    .hint = exporter le fichier dans l’une de ces unités

file-unit-missing = le fichier n’indique pas son unité { $quantity ->
        [length] de longueur
       *[angle] d’angle
    }
    .expected = `{ $record }` avec son facteur dans `FileUnits/PrimaryUnits`
    .hint = { $quantity ->
        [length] indiquer l’unité : `unit` de l’export, ou `--unit`
       *[angle] exporter le fichier avec ses unités
    }

unit-factor-invalid = l’unité a le facteur { $factor } et le décalage { $offset }
    .expected = un facteur positif, pas de décalage

format-without-unit = le format `{ $format }` n’admet pas l’unité { $unit }
    .expected = { $units }
    .hint = indiquer l’une de ces unités

format-not-simulated = `etalon simulate` ne peut pas écrire { $kind ->
        [fixed] de largeurs fixes ni de classeurs
        [types] de lignes qui indiquent leur type de coordonnées
        [numbers] de colonnes indiquées par leur numéro
       *[qif] de QIF
    }
    .hint = { $kind ->
        [fixed] indiquer un `delimiter` pour cet export
        [types] indiquer `columns` avec un seul type de coordonnées
        [numbers] indiquer les noms des colonnes
       *[qif] indiquer `format = "polyworks"` ou un format délimité pour cet export
    }

label-pattern-invalid = { $fault ->
        [open] `{ $pattern }` a un `{"{"}` sans `{"}"}`
        [unknown] `{ $pattern }` a le nom inconnu `{ $name }`
       *[twice] `{ $pattern }` a deux fois `{ $name }`
    }
    .expected = du texte avec {"{"}target{"}"}, {"{"}pose{"}"} et {"{"}cycle{"}"}, chacun au plus une fois
    .hint = corriger `label`

state-encoding = indiquer l’encodage du fichier : il a été lu avec un autre encodage

several-data-sets = un second `{ $record }` : le fichier a plusieurs jeux de données
    .hint = le diviser en un fichier par jeu de données, chacun avec un [[export]]

characteristic-beyond-count = il n’y a pas de caractéristique { $index } : K0100 en indique { $count }
    .hint = exporter de nouveau le fichier : il a été modifié ou assemblé à partir de plusieurs fichiers

value-of-piece-missing = la valeur { $number } de `{ $name }` appartient à la pièce { $piece } : une valeur antérieure manque
    .hint = exporter avec l’attribut 255 (K0002) les valeurs qui n’ont pas été mesurées

coordinate-counts-differ = `{ $name }` a { $found ->
        [one] { $found } valeur
       *[other] { $found } valeurs
    } ; une autre coordonnée du point en a { $count }
    .hint = exporter avec l’attribut 255 (K0002) les valeurs qui n’ont pas été mesurées

metric-misplaced = `METRIC` est hors des colonnes 11 à 16 : l’unité est ambiguë (inch ou mm)
    .expected = `XYZIJK    METRIC`, ou `XYZIJK` seul pour des pouces
    .hint = corriger la ligne 1, ou déclarer le fichier comme texte délimité avec son unité

vertex-not-finite = le point { $number } (`vertex`) a les coordonnées { $coordinates }
    .expected = des coordonnées finies
    .hint = n’exporter que les points mesurés

line-number-differs = les colonnes 73 à 80 contiennent `{ $digits }` : un numéro de ligne ou une valeur
    .expected = `{ $number }`, le numéro de cette ligne
    .hint = exporter le fichier sans numéros de ligne

feature-without-points = `{ $feature }` n’a pas de points utilisables : { $message }

compensation-mixed = les points n’ont pas tous la même correction de palpeur
    .hint = ajuster ces points séparément

reference-broken = `{ $name }` renvoie à { $id }, qui n’est pas un élément `{ $kind }` de ce fichier

reference-external = l’ensemble de points { $id } est dans un autre document
    .hint = exporter l’élément et les points dans un même document

point-range-invalid = `{ $range }` n’est pas une plage de l’ensemble de points { $id } (ligne { $line })
    .expected = des nombres entiers de 1 à { $count }, le plus petit d’abord

point-set-unused = aucun élément ne renvoie à l’ensemble de points { $id }

id-repeated = l’identifiant { $id } sert deux fois, d’abord à la ligne { $line } : les renvois désignent le premier
    .hint = exporter de nouveau le fichier : il a été assemblé à partir de plusieurs fichiers

further-messages = { $count ->
        [one] { $count } autre message
       *[other] { $count } autres messages
    } sur ce fichier

recording-unreadable = l’enregistrement ne peut pas être lu : { $fault ->
        [checksum] la somme de contrôle d’un bloc diffère
        [compression] un bloc a une autre compression que LZ4 et Zstandard
        [size] un bloc dépasse 256 Mio
        [unpack] un bloc ne peut pas être décompressé
        [channel] un message n’a pas de canal
       *[end] le fichier se termine au milieu d’un élément
    }
    .hint = le réparer avec `mcap recover FICHIER -o REPARE`, ou le copier de nouveau

recording-missing = le fichier n’est pas un enregistrement de ROS 2 : il n’a pas de topic `{ $topic }`
    .hint = indiquer le fichier .mcap ou .db3 du dossier de l’enregistrement, ou omettre `topic`

topic-not-stated = le fichier est un enregistrement (MCAP), et `topic` manque

topic-missing = l’enregistrement n’a aucun message du topic `{ $topic }`

topic-too-large = les messages du topic `{ $topic }` dépassent { $most_mib } Mio
    .hint = réduire l’enregistrement à la durée des mesures : `mcap filter FICHIER -o COURT --start SECONDES --end SECONDES`

topic-type-unknown = le topic `{ $topic }` a des messages de type `{ $message }`
    .expected = { $known }
    .hint = indiquer le topic des valeurs articulaires ou des poses mesurées : `etalon formats FICHIER` énumère les topics

topic-encoding-unknown = les messages du topic `{ $topic }` ont l’encodage `{ $encoding }`
    .expected = `cdr`, l’encodage de ROS 2
    .hint = convertir l’enregistrement en ROS 2 : `rosbags-convert --src FICHIER --dst DOSSIER --dst-storage mcap`

ros-message-malformed = le message { $number } du topic `{ $topic }` n’a pas la structure de son type
    .hint = enregistrer sans `--compression-mode message` ; `ros2 bag convert` réécrit un tel enregistrement

joint-state-lengths-differ = le message { $number } du topic `{ $topic }` a { $names } noms d’articulations et { $positions } positions
    .expected = une position pour chaque nom, ou aucune position
    .hint = corriger le nœud qui publie le topic

joint-state-name-twice = le message { $number } du topic `{ $topic }` mentionne deux fois l’articulation `{ $joint }`
    .hint = corriger le nœud qui publie le topic

topic-without-positions = aucun message du topic `{ $topic }` n’a de positions ({ $count ->
        [one] 1 message
       *[other] { $count } messages
    })
    .hint = indiquer le topic des positions mesurées : `etalon formats FICHIER` énumère les topics

ros-messages-of-other-joints = { $count ->
        [one] message
       *[other] premier de { $count } messages
    } sans aucune des articulations de `columns` : publié par un autre nœud

recording-without-known-topics = l’enregistrement n’a aucun topic avec des valeurs articulaires, des poses ou des points : { $found }
    .expected = sensor_msgs/JointState, geometry_msgs/PoseStamped ou geometry_msgs/PointStamped
    .hint = enregistrer un topic de l’un de ces types

array-missing = le fichier n’a pas de tableau de nombres `{ $column }`

array-part-unknown = `{ $column }` ne désigne pas une seule colonne : `{ $name }` est de taille { $shape }
    .hint = écrire la partie comme dans le langage d’origine du fichier : `{ $example }`

array-lengths-differ = `{ $first }` a { $count } nombres et `{ $second }` en a { $other }
    .expected = des colonnes de même longueur
    .hint = indiquer des tableaux d’un même enregistrement ; une matrice dont les colonnes sont des instants a ses articulations en lignes

arrays-unreadable = le fichier ne peut pas être lu comme des tableaux de { $format ->
        [numpy] NumPy (.npz, .npy)
        [kuka_trace] KUKA.Trace (.dat avec voies, et .r64)
       *[matlab] MATLAB (.mat au format -v6 ou -v7)
    }
    .hint = l’enregistrer de nouveau, ou corriger `format`

numbers-file-missing = `{ $file }` manque : l’en-tête seul ne contient pas de nombres
    .hint = copier tous les fichiers de l’enregistrement dans un même dossier

trace-of-motor = `Istposition` et `Sollposition` sont des positions d’un moteur, non d’une articulation
    .hint = utiliser l’enregistrement `..._KRCIpo.dat`, avec `q1_deg = "AxisPos_Act1"`

trace-storage-unknown = la voie `{ $channel }` est enregistrée comme `{ $storage }`
    .expected = REAL64, REAL32, INT32, INT16, WORD32 ou WORD16
    .hint = enregistrer les données avec REAL64, ou les convertir en CSV

trace-values-missing = le fichier des nombres a moins que les { $count } valeurs de la voie `{ $channel }`
    .hint = copier de nouveau les fichiers de l’enregistrement

sheet-not-stated = la feuille du classeur n’est pas indiquée ; le classeur contient { $sheets }
    .hint = indiquer la feuille (`sheet`)

state-sheet = indiquer `sheet = "{ $sheet }"` (option --sheet)

state-column = si c’est la colonne `{ $heading }`, indiquer `columns = {"{"} { $column } = "{ $heading }" {"}"}` (option --column)
state-column-of = indiquer son en-tête : `columns = {"{"} { $column } = "HEADING" {"}"}` (option --column) ; en-têtes que rien ne lit : { $names }
state-column-in-unit = si c’est la colonne `{ $heading }`, indiquer `columns = {"{"} { $column } = "{ $heading }" {"}"}` (option --column) : ses valeurs font penser à { $unit }
state-columns-together = indiquer `columns = {"{"} { $columns } {"}"}` (option --column)
row-marked-deleted = omise : elle est marquée comme supprimée (`{ $cell }`)
row-left-out-by-cell = omise : `{ $column }` est `{ $cell }`
row-without-coordinates = non mesurée : pas de coordonnées
row-cell-empty = non mesurée : { $column } est vide
row-invisible = non mesurée : 0 0 0 avec le quaternion 0 0 0 0
row-not-measured = non mesurée : { $column } est `{ $cell }`
characteristic-of-no-axis = pas une coordonnée : le nom de la caractéristique ne se termine pas par X, Y ou Z
feature-of-no-point = un élément `{ $kind }` : son point peut se trouver n’importe où sur l’élément
feature-not-read = un élément `{ $kind }` : ce type n’est pas lu
point-incomplete = pas un point : { $found } sans { $missing }
probe-centre-no-point = un centre de palpeur, non un point de l’élément

log-delimited = séparateur `{ $delimiter }`, séparateur décimal `{ $decimal }`
log-of-arrays = tableaux de { $format }
log-of-sheet = classeur, feuille `{ $sheet }`
log-of-topic = enregistrement ROS, topic `{ $topic }`
log-of-format = { $format }, { $read }
log-with-start = { $read }, début { $start }
read-with-decimal-comma = { $format }, séparateur décimal `,`

value-without-label = une valeur sans étiquette
primitive-no-point = une primitive de type `{ $kind }`, non un point

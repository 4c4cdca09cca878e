### Proposals for reading a file: contents of columns, evidence, doubts and questions.

ask-anchor = le point depuis lequel la distance est mesurée : `other` dans `constants`
ask-angle-unit = l’unité des angles : `angle_unit` dans `format`
ask-blocks = à quelle cible et à quelle pose appartient chacun des { $count } blocs : les en-têtes se répètent au-dessus de ses lignes, la deuxième fois à la ligne { $line }
ask-computed-by-controller = si un instrument a mesuré `{ $body }`, comme proposé : les en-têtes des articulations ont les mêmes mots, la commande a donc pu le calculer ; les autres coordonnées sont { $others }
ask-direction = per_count : -1 si le comptage est en sens inverse de l’articulation, comme le montrent les points ; 1 si robot.toml est à corriger
ask-direction-of-columns = { $columns }, comme le montrent les points ; sans `-1 *` si robot.toml est à corriger
ask-joint-states = à quelle articulation du robot correspond chaque colonne ; JointState est en rad pour les articulations rotoïdes, en m pour les prismatiques : écrire `q1_m` pour une articulation prismatique
ask-joints = à quelle articulation correspond chaque colonne, et son unité
ask-joints-again = quelles articulations appartiennent au robot : leurs en-têtes figurent { $count } fois. Les premières sont supposées, { $names }
ask-joints-of-format = à quelle articulation correspond chaque colonne, et son unité si elle n’est pas connue
ask-log-of-format = si le fichier est de ce type : { $what } (`[log]` avec `format = "{ $format }"`)
ask-numbers-without-headings = lesquels des { $count } nombres d’une ligne sont des articulations, et lesquels le point mesuré : le fichier n’a pas d’en-têtes. `--robot` trouve les articulations et le point par la cinématique
ask-number-with-gaps = si { $column } est le numéro de la pose, comme proposé : il passe de { $before } à { $after }, le numéro de la ligne en est donc un autre
ask-order-of-columns = si les colonnes sont x, y, z dans cet ordre, ou des angles et des distances
ask-other-arrays = quel tableau contient la mesure : `{ $used }` est supposé. Autant de colonnes dans { $others }{ $more ->
        [0] {""}
       *[other] {" "}et { $more } de plus
    }
ask-points-in-row = si les { $numbers } nombres d’une ligne sont { $count } points de trois coordonnées, comme proposé : rien ne les nomme
ask-quaternion-order = laquelle des colonnes { $columns } est le scalaire du quaternion : la { $used ->
        [last] dernière
       *[first] première
    } colonne est supposée l’être
ask-recorded-motion = s’il s’agit d’un mouvement enregistré, comme proposé, ou de points avec leurs instants (alors [[export]])
ask-rotation = si les trois nombres sont un vecteur de rotation, ou des angles, et dans quel ordre ceux-ci tournent
ask-sets-alike = ce que sont les colonnes { $first } et les colonnes { $second }, dont les en-têtes sont égaux ou les valeurs presque égales : deux cibles, ou des coordonnées commandées et mesurées
ask-sign-of-difference = si la différence est valeur commandée moins valeur mesurée, comme proposé, ou l’inverse (alors `+`)
ask-targets-of-topics = à quelle cible correspond chaque topic de poses ou de points
ask-text-in-all-rows = si `{ $text }`, le même texte à toutes les lignes, est la cible, comme proposé, ou un code
ask-time-unit = l’unité des temps dans { $column } : le pas est { $step }
ask-two-frames = si `{ $first }` et `{ $second }` sont deux cibles, ou un point dans deux référentiels : les distances d’une ligne à l’autre concordent. `etalon cell` trouve la relation de deux référentiels
ask-unit = l’unité des longueurs
ask-unit-of-size = l’unité des longueurs : la plus grande est { $largest }, donc { $units ->
        [inch-or-mm] inch ou mm convient
       *[other] { $units } convient
    } à un robot
because-arrays = il contient des tableaux de { $format }
because-arrays-of-numbers = ses tableaux de nombres sont : { $arrays }
because-columns = { $read } lignes sur { $rows } contiennent des nombres, dans { $columns ->
        [one] 1 colonne
       *[other] { $columns } colonnes
    }
because-columns-of = ses colonnes correspondent à : { $what }
because-comments = les lignes qui commencent par `{ $comment }` sont des commentaires
because-decimal-marks = { $fractions } nombres sur { $numbers } ont le séparateur décimal `{ $mark }`
because-end = la dernière ligne est le mot `{ $end }`
because-fields = { $read } lignes sur { $rows } ont { $fields } champs séparés par `{ $delimiter }`
because-it-is = type reconnu : { $what }
because-joints-named = les articulations portent les noms des articulations du robot
because-line = la ligne { $line } { $is ->
        [header] indique le nom des colonnes
       *[last] est la dernière avant les données
    }
because-log = un journal : { $reason }
because-numbers = chaque ligne a { $count } nombres, dont aucun triplet n’est un vecteur unitaire
because-recording = c’est un enregistrement de ROS 2 : { $storage ->
        [db3] une base SQLite avec des topics
       *[mcap] il commence comme un fichier MCAP
    }
because-sampled = les valeurs des { $rows } premières lignes ont été examinées ; le fichier en a davantage
because-columns-sampled = les { $columns } premières des { $width } colonnes ont été examinées
because-several-points = les en-têtes mentionnent { $count } points mesurés par ligne : chacun est un [[export]] du fichier
because-test-of-poses = un essai selon ISO 9283 : des poses atteintes en plusieurs cycles, et chacune de ces poses une fois
because-topic = le topic `{ $topic }` a { $count ->
        [one] 1 message
       *[other] { $count } messages
    } du type { $message_type }
because-unit-stated = la ligne { $line } indique l’unité : { $how }
doubt-all-commanded = les en-têtes de toutes les coordonnées indiquent des valeurs commandées : le fichier ne contient pas de coordonnées mesurées
doubt-bare-metre = les en-têtes se terminent par `_m` : mètres, ou « mesuré »
doubt-columns-not-read = nombres non lus : colonne { $columns }{ $more ->
        [0] {""}
        [one] {" "}et { $more } autre
       *[other] {" "}et { $more } autres
    }
doubt-computed-by-controller = `{ $used }` est supposé. Les en-têtes de `{ $body }` ont les mots des articulations, le contrôleur a donc calculé ces valeurs
doubt-controller-pose = les coordonnées de `{ $body }` sont peut-être calculées par le contrôleur : un instrument mesure une cible
doubt-coordinates-left = les coordonnées de { $left } ne sont pas utilisées : d’autres ont un en-tête plus proche
doubt-dates = les dates avec `/` n’indiquent pas si le jour ou le mois est en premier : elles ne sont pas lues
doubt-decimal-mark = aucun nombre n’a de séparateur décimal : `{ $mark }` est supposé
doubt-direction-length = la direction n’est pas un vecteur unitaire à toutes les lignes
doubt-encoding = le fichier n’est pas en UTF-8 et est lu en { $encoding } : vérifier que ses lettres (°, µ, accents) sont justes
doubt-first-increases = la colonne 1 augmente à chaque ligne : un instant, ou une coordonnée
doubt-four-joints = quatre articulations q0 à q3 auraient les mêmes en-têtes
doubt-in-line = ligne { $line } : { $problem }
doubt-groups-alone = la ligne { $line } nomme des groupes de colonnes : trois colonnes d’un groupe sont prises pour x, y, z
doubt-joints-without-headings = { $count } nombres sans en-têtes : des articulations, ou des coordonnées et des angles
doubt-matrix-order = une matrice sans en-têtes : lue ligne par ligne, elle transforme les vecteurs du corps vers le repère atelier
doubt-more-problems = et { $count ->
        [one] 1 autre problème
       *[other] { $count } autres problèmes
    } de ce genre
doubt-one-row = une ligne de { $count } nombres sans en-têtes : un programme a écrit un tableau sur une ligne, et rien ne montre son découpage
doubt-order-of-joints = les articulations ne suivent aucun ordre dans le fichier : elles sont prises dans l’ordre de leurs numéros ou des parties du bras
doubt-orientation-of-body = l’orientation `{ $body }` est prise pour l’orientation du point mesuré : ses en-têtes nomment un autre corps
doubt-origin = ligne { $line } : 0 0 0, considéré comme « non mesuré » sauf indication contraire de `missing`
doubt-other-reading = { $reading }, { $columns ->
        [one] 1 colonne
       *[other] { $columns } colonnes
    } l’explique aussi bien : vérifier une ligne à l’œil
doubt-other-sheets = le classeur a { $count ->
        [one] 1 autre feuille
       *[other] { $count } autres feuilles
    } : { $sheets }
doubt-polar = un azimut et une distance, sans angle zénithal ni angle d’élévation
doubt-pose-of-robot = `{ $body }` est une pose du robot dans les mêmes lignes : `etalon cell --solve { $solve }` trouve sa relation avec la mesure
doubt-quaternion-length = le quaternion n’a pas la norme 1 à toutes les lignes
doubt-quaternion-order = un quaternion sans en-têtes : scalaire à la fin, comme l’écrit ROS, ou au début
doubt-rows-not-read = { $count ->
        [one] 1 ligne non lue
       *[other] { $count } lignes non lues
    } de cette façon ; la première est la ligne { $line }
doubt-rows-refused = ligne { $line } : { $reason } ; autres lignes : { $more }
doubt-scanned = les nombres après x, y, z sont pris pour l’intensité et la couleur : des entiers jusqu’à 255
doubt-second-log = le topic `{ $topic }` a aussi des valeurs articulaires
doubt-sets-by-difference = les colonnes { $difference } sont, à toutes les lignes, la différence des colonnes { $measured } et { $commanded } : elles sont lues comme valeur mesurée moins valeur commandée
doubt-several-logs = { $count } journaux : { $first } identifie le robot, les autres lui sont comparés ; les lignes d’un même enregistrement réparties sur plusieurs fichiers sont à réunir en un seul
doubt-summary = la feuille `{ $sheet }` est omise : les autres feuilles contiennent toutes ses lignes
doubt-sign-of-difference = le signe de la différence n’est pas indiqué : comparer une ligne avec la mesure
doubt-six-without-headings = six nombres sans en-têtes : une position et trois angles, ou des articulations dont trois sont prismatiques
doubt-stationary-points = ses { $count } points sont pris pour des points fixes : leurs noms pourraient être des poses, mais un autre fichier a { $poses } poses
doubt-thousands-mark = chaque `{ $mark }` précède trois chiffres : ce peut être un séparateur de milliers
doubt-time-decreases = { $column } porte le nom d’un temps, mais diminue
doubt-topic-unreadable = impossible de lire le topic `{ $topic }` : { $reason }
doubt-two-families = { $names } pourraient aussi être des articulations : `{ $kept }` est utilisé
doubt-units-differ = le fichier indique { $unit } (ligne { $line }) et { $of_second } (ligne { $second })
doubt-transposed = { $rows } lignes de { $columns } nombres : lignes et colonnes peuvent être échangées. Écrire une ligne par pose ou par instant
doubt-unnamed-joints = { $names } sont pris pour des articulations : aucune autre grandeur ne convient, mais le fichier ne les nomme pas
doubt-vertical-angle = { $column } est un angle vertical : ses valeurs correspondent à { $zenith ->
        [yes] un angle zénithal
       *[no] un angle d’élévation
    }, mais l’en-tête ne dit pas lequel
doubt-words-of-header = la ligne { $line } a { $words } mots pour { $columns } colonnes : leur ordre est inconnu
is-aqdef = un fichier au format de transfert ASCII de Q-DAS, d’après son premier champ
is-attained-poses = des poses atteintes d’un essai selon l’ISO 9283
is-calypso = un tableau de Zeiss Calypso, d’après son en-tête
is-commanded-poses = des poses commandées, ou candidates pour `etalon plan`
is-compliance-test = un essai de compliance statique
is-dmis = une sortie DMIS, d’après son premier enregistrement
is-drilled-plate = un tableau de trous percés en colonnes de largeur fixe, d’après son en-tête
is-galil-arrays = des tableaux lus dans un contrôleur Galil (upload) : seulement des nombres entiers, sous des noms en ordre alphabétique
is-geopak-scan = un scan de GEOPAK-Win, d’après son premier enregistrement
is-kuka-rsi = un enregistrement de KUKA RSI : son en-tête contient le compteur `IPOC`
is-leica-at960 = un export d’un Leica AT960 ou AT930 en six degrés de liberté, d’après son en-tête
is-leica-emscon = une liste de points stationnaires mesurés par l’interface emScon de Leica, d’après son en-tête
is-observations = un tableau d’observations
is-pcdmis-report = un rapport de PC-DMIS avec un bloc par caractéristique, d’après son en-tête `AX`
is-stl = un fichier STL, d’après ses triangles
is-pcd = un fichier PCD, d’après les lignes FIELDS et DATA
is-e57 = un fichier E57 d’un scanner, d’après ses premiers octets
is-c3d = un fichier C3D de capture de mouvement, d’après ses premiers octets
is-fanuc-ls = un programme d’un contrôleur FANUC, d’après sa première ligne
is-abb-rapid = un module ABB RAPID, d’après MODULE et ENDMODULE
is-ptx = un scan PTX, d’après ses dix lignes d’en-tête
is-leica-gsi = un fichier Leica GSI, d’après les mots de ses lignes
is-pcdmis = un fichier .xyz de PC-DMIS, d’après sa première ligne
is-ply = un fichier PLY, d’après sa première ligne
is-polyworks-project = une description de projet de PolyWorks|Inspector, d’après sa première ligne
is-polyworks-report = un rapport de PolyWorks à une ligne par contrôle, d’après son en-tête
is-qif = un document QIF
is-recorded-motion = un mouvement enregistré
is-reference-targets = des cibles de référence mesurées de temps en temps
is-ros-messages = des messages de ROS : l’en-tête est celui de `rostopic echo -p`
is-spatialanalyzer = un export de points de SpatialAnalyzer, d’après ses commentaires
is-twincat = un export de Beckhoff TwinCAT 3 Scope : son en-tête indique le début de l’export
is-ur-rtde = un enregistrement RTDE d’Universal Robots : son en-tête contient les noms RTDE des positions articulaires
is-vda-fs = un fichier VDA-FS, d’après son en-tête
means-appearance = intensité ou couleur
means-azimuth = azimut
means-clock = date et heure
means-commanded = { $axis } commandé
means-count = un numéro d’ordre
means-cycle = numéro de la répétition
means-day = date
means-deleted = marque des lignes supprimées
means-difference = différence de { $axis }
means-direction = direction { $component }
means-distance = distance
means-elevation = angle d’élévation
means-expanded-uncertainty = incertitude élargie de { $axis }
means-joint = articulation { $number }
means-label = étiquette du point
means-matrix = matrice de rotation r{ $row }{ $column }
means-matrix-end = dernière ligne d’une matrice 4x4
means-measured = { $axis } mesuré
means-measured-of-point = { $axis } mesuré du point { $number }
means-motion = vitesse, force ou courant
means-other-joint = valeur articulaire commandée
means-other-orientation = { $component } de l’orientation d’un autre corps
means-pose = nom de la pose
means-quaternion = quaternion { $component }
means-rotation = rotation, nombre { $number } sur trois
means-target = nom de la cible
means-scatter = incertitude ou dispersion du point entier
means-temperature = température
means-text = un texte qui n’est pas lu
means-time = instant
means-time-of-day = heure
means-uncertainty = incertitude-type, numéro { $number }
means-unknown = inconnu
means-zenith = angle zénithal
names-of-columns = { $said } : { $names }
says-commanded-and-difference = l’en-tête mentionne un point commandé et sa différence
says-joints = l’en-tête mentionne des articulations
says-joints-and-length = des articulations et une longueur par ligne
says-joints-beside = l’en-tête mentionne des articulations à côté des points
says-orientations = l’en-tête mentionne des orientations
why-ambiguous-dates = des dates dont le jour et le mois pourraient être intervertis
why-as-many-as-joints = chaque ligne a autant de nombres qu’un bras a d’articulations, et aucun triplet n’est un vecteur unitaire
why-axes-differ = les en-têtes de trois colonnes ne diffèrent que par x, y et z
why-behind-lengths = après trois longueurs plus grandes que tout angle
why-colours = des entiers jusqu’à 255 après un point
why-commanded-heading = son en-tête indique une valeur commandée
why-commanded-rotation = son en-tête indique une rotation commandée
why-constant = le même nombre entier dans toutes les lignes
why-counts = des nombres entiers qui augmentent de 1
why-counts-first = des nombres entiers qui augmentent d’une ligne à l’autre, en début de ligne
why-counts-with-gaps = des entiers croissants, avec des lacunes
why-numbers-rows = son en-tête signifie un numéro, et chaque ligne en a un autre
why-vertical = un angle vertical selon l’en-tête, à côté d’un azimut et d’une distance
why-dates = chaque cellule est une date ou une heure
why-difference-heading = son en-tête indique une différence
why-empty = la colonne est vide
why-epoch = { $why } ; { $unit } depuis 1970 d’après sa grandeur
why-fits-without = le robot nominal reproduit les données sans elle
why-four-of-length-one = les quatre nombres ont la norme 1 à chaque ligne
why-heading = son en-tête
why-heading-and-four = son en-tête, et les quatre nombres ont la norme 1 à chaque ligne
why-heading-and-three = son en-tête, et les trois nombres ont la norme 1 à chaque ligne
why-heading-increases = son en-tête ; la colonne augmente à chaque ligne
why-heading-ordered = son en-tête ; la colonne ne diminue jamais
why-heading-unordered = son en-tête, bien que la colonne n’augmente pas
why-in-unit = { $why }, en { $unit }
why-increases = cette colonne augmente à chaque ligne, les autres n’augmentent pas
why-kinematics-fit = la cinématique du robot nominal concorde si cette colonne est en { $unit }{ $way ->
        [reversed] , comptée dans le sens opposé
       *[forward] {""}
    }
why-last-of-matrix = dernière colonne d’une matrice 4x4 dont la rotation est orthonormée
why-measured-heading = son en-tête indique une valeur mesurée
why-nine-orthonormal = les neuf nombres forment une matrice orthonormée à chaque ligne
why-names-of-points = les noms de points qui ne bougent pas avec le robot
why-nothing-known = son en-tête n’a pas de signification connue
why-orthonormal = orthonormée à chaque ligne, lue ligne par ligne
why-other-arm = son en-tête figure une nouvelle fois
why-other-body = son en-tête nomme un autre corps que le point mesuré
why-other-family = les articulations sont prises dans les colonnes `{ $kept }`
why-others-measured = son en-tête indique une valeur commandée, et d’autres colonnes sont mesurées
why-place = sa place : rien n’indique le nom des colonnes
why-quaternion-not-joints = les quatre nombres ont la norme 1 à chaque ligne : un quaternion, scalaire en premier, et non des articulations
why-range-of-deg = son en-tête ; de { $low } à { $high } : plus d’un tour en rad, donc deg ou mm convient
why-range-of-rad = son en-tête ; de { $low } à { $high } : rad, ou m, convient
why-repeats-as-texts = son en-tête mentionne des répétitions, et elle contient des textes
why-robot-computes = le robot nominal la calcule à l’arrondi près
why-robot-reproduces = le robot nominal reproduit les trois colonnes
why-row-0001 = la ligne 0 0 0 1
why-targets-fit = avec une cible pour chacune de ses valeurs, le robot nominal concorde avec les données
why-text-before = un texte avant les nombres
why-text-behind = un texte après des nombres
why-text-in-all-rows = le même texte à toutes les lignes, avant les nombres
why-texts-differ = des textes différents d’une ligne à l’autre, avant les nombres
why-three-of-length-one = les trois nombres ont la norme 1 à chaque ligne
why-whole-before-decimals = des nombres entiers avant des nombres à séparateur décimal

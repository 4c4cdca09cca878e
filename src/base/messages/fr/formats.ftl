### Messages de formats ; explications dans en/formats.ftl.

column-without-place = une colonne a soit un `name`, soit un `number` à partir de 1
column-wrong-occurrence = `occurrence` compte à partir de 1, et `per_count` diffère de 0
columns-in-two-forms = `columns` mentionne { $quantity ->
        [orientation] deux formes de l’orientation
       *[uncertainty] des incertitudes-types et des incertitudes élargies
    }
    .hint = omettre les colonnes de l’une des formes

column-group-incomplete = `columns` ne mentionne qu’une partie de { $names }
    .hint = indiquer toutes ces colonnes, ou aucune

header-without-words = `header` est vide, un mot de la ligne avant les données est attendu
key-needs-columns = `{ $key }` exige les colonnes { $columns }
    .hint = indiquer ces colonnes dans `columns`, ou supprimer `{ $key }`

coverage-factor-missing = des incertitudes élargies exigent leur facteur d’élargissement `coverage_factor`
    .hint = l’indiquer dans `format`, par exemple `coverage_factor = 2`

row-number-unknown = `{ $stated }` est inconnu, `row` est attendu, ou `row + 100` pour un deuxième fichier
uncertainty-column-count = `columns` mentionne { $stated ->
        [one] { $stated } incertitude
       *[other] { $stated } incertitudes
    } pour { $coordinates ->
        [one] { $coordinates } coordonnée
       *[other] { $coordinates } coordonnées
    }
    .expected = une par coordonnée ({ $names }), ou aucune

column-separation-unclear = le format indique { $stated ->
        [0] aucune séparation des colonnes
       *[other] { $stated } séparations des colonnes
    }
    .expected = l’une des clés `delimiter`, `widths` et `sheet`
    .hint = `etalon formats FICHIER` propose une lecture du fichier

column-width-zero = une colonne de `widths` a une largeur de 0 caractère
    .hint = indiquer le nombre de caractères de chaque colonne

more-columns-than-widths = `columns` indique { $columns } colonnes, `widths` en a { $widths }
    .hint = indiquer une largeur par colonne

comma-ambiguous = une virgule ne peut pas être à la fois séparateur de colonnes et séparateur décimal : `1,25` serait un nombre ou deux
    .hint = exporter le fichier avec des points-virgules ou des tabulations, ou avec un point décimal

thousands-mark-ambiguous = le séparateur de milliers `{ $mark }` est aussi le { $other ->
        [decimal] séparateur décimal
       *[delimiter] séparateur de colonnes
    }
    .hint = supprimer ou corriger `thousands`

column-role-twice = `columns` mentionne `{ $role }` deux fois
    .hint = corriger l’une des deux ; le rôle `-` désigne une colonne qui n’est pas lue

coordinates-of-two-kinds = `columns` mentionne à la fois des coordonnées de type fixe et c1, c2, c3
    .expected = soit x, y, z ou des angles et des distances, soit c1, c2, c3

row-types-missing = les colonnes c1, c2, c3 exigent une colonne `type` et de la clé `types`
    .hint = par exemple `types = {"{"} 0 = ["x", "y", "z"], 7 = ["azimuth", "zenith", "distance"] {"}"}`

row-type-incomplete = `{ $key }` n’indique pas la signification de c1, c2 et c3
    .expected = trois coordonnées, et c1, c2, c3 dans `columns`

not-coordinates = `{ $key }` mentionne { $count ->
        [0] aucune coordonnée
       *[other] { $names }, qui ne sont pas les coordonnées d’un point
    }
    .expected = x et y, et z dans l’espace ; rayon, azimut et z ; ou azimut, angle zénithal ou angle d’élévation, et distance

angle-unit-missing = `{ $key }` mentionne des angles sans unité
    .hint = indiquer `angle_unit` (option `--angle-unit`) : "deg", "rad" ou "gon"

coordinate-type-differs = `coordinates` indique des coordonnées { $stated ->
        [cartesian] cartésiennes
        [cylindrical] cylindriques
       *[spherical] sphériques
    }, `{ $key }` mentionne des coordonnées { $named ->
        [cartesian] cartésiennes
        [cylindrical] cylindriques
       *[spherical] sphériques
    }
    .hint = corriger l’une des deux

header-not-stated = `columns` mentionne l’en-tête `{ $column }`, mais aucune ligne d’en-tête n’est indiquée
    .hint = indiquer `header = 1`, ou donner le numéro de la colonne

header-is-data = la ligne { $rows } de l’en-tête contient des nombres dans les colonnes de coordonnées
    .hint = les lignes vides et les commentaires ne comptent pas comme lignes : indiquer `header = { $fewer }`

expression-malformed = impossible de lire l’expression `{ $expression }` : { $fault ->
        [too-long] elle dépasse 1000 caractères
        [left-over] `{ $rest }` est de trop
        [brackets-too-deep] ses parenthèses sont trop imbriquées
        [too-many-signs] elle contient trop de signes
        [bracket-open] une parenthèse n’est pas fermée
        [column-number] `$` n’est pas suivi d’un numéro de colonne, à partir de 1
       *[incomplete] il manque une colonne ou un nombre
    }
    .expected = des en-têtes, `$3` pour la troisième colonne et des nombres, avec + - * / et des parenthèses

column-unknown = la colonne `{ $column }` manque

table-failed = impossible de construire le tableau : { $reason }

not-whole-number = `{ $value }` dans la colonne `{ $column }` n’est pas un nombre entier

stored-table-damaged = le tableau enregistré est endommagé : { $reason }
    .hint = relancer la campagne : `etalon run CAMPAGNE`

stored-row-count = il a { $found ->
        [one] { $found } ligne
       *[other] { $found } lignes
    } au lieu de { $rows }

row-without-point = la ligne ne contient pas de point : { $reason }
    .hint = supprimer la ligne du fichier

rows-left-out = { $count ->
        [one] { $count } ligne omise
       *[other] { $count } lignes omises
    } ; la première : { $reason }

count-value-missing = `{ $key }` n’indique pas la valeur d’une impulsion : les tableaux Galil contiennent des impulsions de codeur
    .expected = `{ $key } = {"{"} name = "...", per_count = 0.001 {"}"}`, per_count dans l’unité de la clé

galil-array-hole = le tableau de `{ $column }` a une cellule vide avant sa fin
    .hint = relire le tableau dans le contrôleur

galil-array-ended = valeur absente : le tableau de { $columns } est terminé

galil-array-empty = l’un des tableaux est vide
    .hint = relire les tableaux dans le contrôleur après la fin de l’enregistrement

not-a-count = { $value } n’est pas un nombre d’impulsions de codeur
    .expected = un nombre entier de 32 bits
    .hint = si les valeurs sont déjà converties, omettre `format = "galil"`

counter-wrapped = le compteur a débordé : la valeur { $to } suit { $from }
    .hint = mettre le codeur à zéro avant l’enregistrement

rsi-cycles-missing = { $count ->
        [one] { $count } ligne
       *[other] { $count } lignes
    } où `IPOC` n’avance pas de { $step_ms } ms
    .hint = des télégrammes ont été perdus, car l’ordinateur d’acquisition était trop lent ; enregistrer de nouveau si les lacunes gênent

ros-joints-change = l’articulation { $number } est `{ $found }` dans cette ligne et `{ $first }` dans la première
    .hint = deux émetteurs partagent le topic : enregistrer chacun dans un fichier séparé

log-column-unknown = `{ $key }` n’est pas une colonne d’un journal
    .expected = `pose`, `cycle`, `time_s`, `label`, ou une articulation avec son unité comme `q1_deg`, `q1_rad`, `rho1_mm`

log-column-twice = `{ $key }` indique `{ $name }` une deuxième fois
    .hint = omettre l’une des deux ; `pose = "row"` remplace la colonne de la pose, `period_s` celle du temps

log-key-inapplicable = `{ $key }` ne s’applique pas à { $column ->
        [none] ce journal
       *[other] `{ $column }`
    }
    .hint = { $key ->
        [per_count] `per_count` est la valeur d’une impulsion de codeur et ne vaut que pour une articulation : supprimer la clé
        [values] `values` appartient à `format = "twincat"` : supprimer la clé
        [comment] un fichier de tableaux ne contient pas de texte : supprimer `{ $key }`
        [decimal] un fichier de tableaux ne contient pas de texte : supprimer `{ $key }`
        [delimiter] un fichier de tableaux ne contient pas de texte : supprimer `{ $key }`
        [encoding] un fichier de tableaux ne contient pas de texte : supprimer `{ $key }`
        [sheet] un fichier de tableaux ne contient pas de texte : supprimer `{ $key }`
        [header] un export TwinCAT donne le nom de ses voies : supprimer `header`
       *[other] les voies d’un export TwinCAT ont leurs propres instants : supprimer `{ $key }`
    }

column-unit-differs = `{ $key }` indique { $stated }, mais `{ $column }` est en { $known ->
        [wall-clock] secondes entières de l’heure du jour ; l’horloge de ce journal est `IPOC`
       *[other] { $known }
    }

write-column = écrire `{ $key } = "{ $column }"`

column-in-unit = une colonne en { $unit }

header-words-missing = aucune ligne ne contient tous les mots de l’en-tête : { $words }
    .hint = copier les mots de la ligne d’en-tête du fichier

data-rows-missing = le fichier n’a pas de lignes de données
    .hint = l’exporter de nouveau ; si sa seule ligne contient des valeurs, indiquer `header = false`

row-field-count = la ligne a { $fields ->
        [one] { $fields } champ
       *[other] { $fields } champs
    }
    .expected = { $expected }
    .hint = vérifier le séparateur de colonnes, le séparateur décimal et les guillemets : une virgule décimale ajoute des champs ; il manque des champs à un fichier tronqué

fields-like = { $like ->
        [header] { $width }, comme l’en-tête
        [first-row] { $width }, comme la première ligne
       *[names] au plus { $width }, comme la ligne des noms
    }

delimiter-does-not-split = séparées par `{ $delimiter }`, les lignes n’ont qu’une colonne

state-delimiter = indiquer `delimiter = "{ $delimiter }"` et `decimal = "{ $decimal }"` (options --delimiter et --decimal)

state-delimiter-of-rows = indiquer `delimiter` et `decimal` des lignes

header-holds-numbers = la ligne d’en-tête contient des nombres au lieu de noms
    .hint = si le fichier n’a pas d’en-tête, indiquer `header = false` et désigner les colonnes par leur numéro

column-by-number = une colonne de ce format ne peut pas être désignée par son numéro : { $format ->
        [galil] les tableaux sont en ordre alphabétique, et non dans l’ordre des articulations
        [ros] l’ordre des articulations est arbitraire
       *[twincat] l’ordre des voies change d’un export à l’autre
    }
    .hint = la désigner par son nom

column-number-unknown = la colonne { $number } n’existe pas
    .expected = un numéro de 1 à { $columns }

heading-repeated = l’en-tête a { $times ->
        [one] { $times } colonne
       *[other] { $times } colonnes
    } `{ $column }`
    .expected = `occurrence` de 1 à { $times }
    .hint = indiquer laquelle : `{"{"} name = "{ $column }", occurrence = 1 {"}"}`

log-row-needs-values = relire le journal du contrôleur, ou supprimer la ligne : chaque ligne doit avoir ses valeurs

assembly-mode-invalid = le mode d’assemblage est { $value }
    .expected = 1 ou -1
    .hint = le corriger ; s’il est inconnu, omettre la colonne `assembly`

standstill-missing = le robot du journal `{ $log }` n’est jamais à l’arrêt pendant { $at_least_s } s
    .hint = son plus long arrêt dans les limites dure { FIXED($longest_s, 3) } s : vérifier `at_least_s` et les limites

standstill-time-missing = [log.standstill] exige l’instant de chaque ligne
    .hint = indiquer `time_s`, `time_ms` ou `time_ns` dans `columns`, ou `period_s`

standstill-limit-missing = [log.standstill] n’a pas de limite pour `{ $column }`
    .hint = indiquer `{ $key }` : la plus grande différence entre deux valeurs à l’arrêt

changes-at-standstill = `{ $column }` passe de { $from } à { $to } pendant un arrêt
    .hint = omettre la colonne, ou abaisser les limites de [log.standstill]

simulated-column-clash = la colonne de `{ $key }` ne peut pas être écrite
    .expected = une colonne distincte pour chaque clé, au plus { $most } colonnes

simulated-column-unknown = `{ $key }` ne peut pas être simulé
    .expected = `pose`, `cycle`, `time_s` et les articulations avec leurs unités

log-columns-missing = `columns` de ce journal ne mentionne aucune voie

twincat-two-scales = la voie `{ $channel }` a un facteur d’échelle, et son unité en a un aussi
    .hint = exporter des valeurs mises à l’échelle et indiquer `values = "scaled"`

twincat-scale-undecided = la voie `{ $channel }` a un facteur d’échelle (facteur et décalage { $scale }, de l’unité { $unit_scale }) : on ignore si ce facteur est déjà appliqué
    .hint = indiquer `values = "raw"` ou `values = "scaled"`, selon le réglage de l’export

channel-resumes = la voie `{ $channel }` reprend après sa fin
    .hint = exporter de nouveau l’enregistrement

channels-without-common-time = ces voies n’ont aucun instant en commun
    .hint = exporter des voies d’une même tâche, avec une même période d’échantillonnage

channel-samples-unused = voie `{ $channel }` : { $count ->
        [one] { $count } échantillon omis
       *[other] { $count } échantillons omis
    }, car une autre voie n’en a pas à ces instants

twincat-head-malformed = ce n’est pas un export de TwinCAT 3 Scope : { $part ->
        [first-line] sa première ligne ne commence pas par `Name` et un séparateur
        [names] aucune ligne de son en-tête ne donne le nom des voies
       *[end] aucune ligne vide ne termine son en-tête
    }
    .hint = exporter de nouveau l’enregistrement en CSV, ou indiquer un autre `format`

twincat-head-ragged = la ligne `{ $row }` de l’en-tête a { $fields } champs, la ligne des noms { $width } : le séparateur apparaît aussi dans des valeurs ou des noms
    .hint = exporter de nouveau, avec des tabulations ou des points-virgules

twincat-separated-by-blanks = l’export est séparé par des espaces, or un espace peut aussi être une valeur manquante ou faire partie d’un nom
    .hint = exporter de nouveau, avec des tabulations ou des points-virgules

channel-scale-not-number = `{ $key }` de la voie `{ $channel }` est `{ $value }`, qui n’est pas un nombre
    .hint = exporter de nouveau l’enregistrement

delimiter-differs = l’export est séparé par { $separator }
    .hint = supprimer `delimiter` de ce journal : l’export indique son séparateur

coordinates-differ = les positions atteintes et commandées ont des coordonnées différentes
    .expected = les coordonnées de `{ $file }`
    .hint = les robots plans omettent `z_mm` dans les deux tableaux

coordinate-missing = une coordonnée manque ou n’est pas finie
    .hint = compléter la cellule, ou supprimer la ligne

columns-not-read = non lues : { $count ->
        [one] colonne
       *[other] colonnes
    } { $columns }

joint-direction-missing = `backlash` de l’articulation `{ $joint }` exige le sens d’approche de l’articulation
    .expected = une colonne `{ $column }` : +1 pour une approche par valeurs croissantes, -1 par valeurs décroissantes
    .hint = utiliser un journal horodaté, ou retirer l’articulation de `backlash` du fichier de robot

joint-direction-invalid = `{ $column }` { $value ->
        [missing] manque
       *[other] est { $value }
    }
    .expected = +1 pour une approche de `{ $joint }` par valeurs croissantes, -1 par valeurs décroissantes

joint-column-twice = le tableau contient deux fois l’articulation `{ $joint }` : `{ $first }` et `{ $second }`
    .hint = supprimer l’une des colonnes

in-row = ligne { $row } : { $message }

pose-commanded-twice = la pose { $pose } est commandée deux fois
    .hint = supprimer ou renommer l’une des lignes

pose-not-commanded = la pose { $pose } n’est pas parmi les poses commandées
    .hint = l’ajouter à `{ $file }`, ou corriger son nom

pose-attained-twice = la pose { $pose } a été atteinte deux fois au cycle { $cycle }
    .hint = numéroter les cycles, indiquer les directions d’approche dans `approach`, ou numéroter les lectures d’un positionnement dans `reading`

commanded-pose-not-measured = la pose { $pose } est commandée mais n’a pas été mesurée

no-pose-measured = aucune pose n’a été mesurée
    .hint = vérifier les noms des poses

recording-time-missing = l’enregistrement n’a pas de colonne de temps
    .expected = une colonne `time_s`, ou la fréquence d’échantillonnage
    .hint = indiquer la fréquence d’échantillonnage de l’instrument : `--rate-hz 1000`, dans une campagne `rate_hz = 1000`

row-repeats = supprimer cette ligne : elle a les coordonnées de la ligne { $line }, chiffre pour chiffre

state-sampling-rate = indiquer la fréquence d’échantillonnage (`--rate-hz`) : un horodatage plus grossier que l’échantillonnage ne permet pas de dater les échantillons

rate-contradicts-stamps = { $samples } échantillons à { $rate_hz } Hz durent { FIXED($by_rate_s, 2) } s ; leur horodatage couvre { FIXED($stamped_s, 2) } s
    .hint = corriger la fréquence d’échantillonnage, ou indiquer les colonnes sans l’horodatage

recording-implausible = { $count } échantillons sur { $samples } dépassent 20 m/s : aucun robot n’est aussi rapide
    .hint = vérifier la fréquence d’échantillonnage, l’unité et l’ordre des échantillons

angles-not-compensated = les cibles de référence ne corrigent pas la dérive des angles
    .expected = a_deg, b_deg et c_deg (c_deg seul pour un robot plan) et l’ordre de leurs rotations
    .hint = indiquer l’ordre : `--rotation-order "Rz(c) Ry(b) Rx(a)"`, dans une campagne `rotation_order`

cycle-before-reference-targets = le cycle { $cycle } a été mesuré avant toute cible de référence
    .hint = mesurer les cibles de référence avant l’essai ; leur première mesure est du cycle { $first }

reference-target-twice = la cible de référence `{ $target }` a été mesurée deux fois au cycle { $cycle }
    .hint = supprimer l’une des lignes, ou corriger son nom

reference-targets-differ = les cibles de référence du cycle { $cycle } diffèrent des premières
    .expected = { $targets }

observation-column-unknown = `{ $column }` n’est pas une colonne d’observations
    .hint = les coordonnées et les articulations se terminent par leur unité : x_mm, q1_deg ; docs/observations.md énumère les colonnes

columns-inverted = `columns` est inversé : des en-têtes du tableau y sont donnés comme noms de colonnes

column-stated-twice = la colonne `{ $column }` est indiquée comme `{ $first }` et comme `{ $second }`
    .hint = corriger l’une des deux

heading-twice = l’en-tête mentionne `{ $column }` plusieurs fois
    .hint = renommer ou supprimer l’une des colonnes

stated-and-in-table = `{ $key }` est indiquée, mais le tableau a aussi une colonne de ce nom
    .hint = supprimer l’une des deux

no-row-selected = `only` et `without` ne retiennent aucune ligne
    .hint = comparer leurs cellules à celles du fichier
log-without-values = aucune ligne du journal n’a de valeur pour `{ $column }`
    .hint = corriger la colonne, ou indiquer d’autres cellules dans `missing`
log-constant-invalid = la constante { $value } ne peut pas être la colonne `{ $column }` d’un journal
    .hint = { $column ->
        [cycle] indiquer un nombre entier, ou "visit" dans un journal avec des poses
        [assembly] indiquer 1 ou -1
        [pose] indiquer un nombre ou un nom
       *[other] indiquer un nombre
    }

computed-not-finite = la valeur calculée de `{ $column }` est { $value }
    .hint = vérifier l’expression : division par zéro ou dépassement de capacité

name-is-formula = un tableur prendrait le nom `{ $name }` de la colonne `{ $column }` pour une formule
    .hint = utiliser un nom qui ne commence pas par = + - ou @

file-empty = le fichier est vide
    .hint = l’exporter de nouveau

file-without-points = c’est { $kind ->
        [json] un document JSON
        [yaml] un document YAML
        [toml] un document TOML ou INI
        [certificate] un certificat d’étalonnage numérique : des résultats d’étalonnage sans points mesurés
        [sdr33] un fichier d’observations d’une station totale Sokkia (SDR33)
        [m5] un fichier d’observations d’une station totale Zeiss ou Trimble (M5)
        [south] un fichier d’observations d’une station totale South
        [las] un relevé au format LAS
        [urscript] un programme d’une commande Universal Robots : il contient des poses commandées, sans poses mesurées
        [krl] un programme d’une commande KUKA : il contient des poses commandées, sans poses mesurées
        [gcode] un programme d’une machine-outil (G-code) : il contient des positions commandées, sans positions mesurées
        [cad] un modèle CAO (STEP ou DXF) : ses points sont nominaux
        [mesh] un maillage (OBJ, OFF, VRML ou VTK) : ses sommets ne sont pas des points mesurés d’un robot
        [roughness] un fichier de paramètres de rugosité d’un Mitutoyo SJ-410, sans coordonnées
       *[xml] un document XML de type inconnu
    }
    .expected = des points mesurés ou un journal, sous forme de tableau de texte ou de classeur
    .hint = { $kind ->
        [certificate] indiquer le fichier des points mesurés
        [roughness] indiquer le fichier des points mesurés
        [sdr33] exporter les coordonnées des points en texte, une ligne par point
        [m5] exporter les coordonnées des points en texte, une ligne par point
        [south] exporter les coordonnées des points en texte, une ligne par point
        [las] exporter les points en texte, PLY ou E57
        [urscript] indiquer le fichier des points mesurés
        [krl] indiquer le fichier des points mesurés
        [gcode] indiquer le fichier des points mesurés
        [cad] indiquer le fichier des points mesurés
        [mesh] indiquer le fichier des points mesurés ; les maillages d’un robot appartiennent à son URDF
       *[other] écrire les nombres en CSV : une ligne par point ou par pose, sous une ligne avec les noms des colonnes
    }

stations-several = l’instrument a été remis en station à la ligne { $line } : directions et distances de deux stations n’ont pas de référentiel commun
    .hint = exporter les coordonnées des points (mots 81, 82, 83), ou un fichier par station

matrices-in-blocks = les lignes sont des matrices 4×4, l’une sous l’autre
    .expected = une ligne par point ou par pose
    .hint = écrire chaque matrice sur une ligne de 16 nombres, ligne par ligne

gsi-feet = la longueur est en pieds, et GSI n’indique pas lesquels
    .expected = des longueurs en mètres
    .hint = exporter les points en mètres

numbers-behind-names = les nombres sont derrière leurs noms, comme dans `x:428.031`
    .expected = un nombre par colonne
    .hint = écrire les noms une seule fois, comme ligne d’en-têtes, et les nombres en dessous

numbers-in-brackets = les nombres sont dans des listes entre crochets
    .expected = un nombre par colonne
    .hint = écrire les nombres sans crochets, par exemple avec `numpy.savetxt`

numbers-in-cells = les cellules contiennent des listes de nombres : deux séparateurs divisent les nombres d’une ligne
    .expected = un nombre par colonne
    .hint = écrire un nombre par colonne, avec un seul séparateur

no-rows-of-numbers = { $file ->
        [workbook] aucune feuille du classeur ne contient
        [arrays] aucun tableau du fichier ne contient des valeurs articulaires ou des points, et
       *[text] aucune lecture comme texte délimité ne donne
    } de lignes de deux nombres ou plus
    .hint = exporter les points en texte, une ligne par point

robot-does-not-test = un robot du modèle `{ $model }` ne permet pas de vérifier la proposition : sa bride n’a pas de pose libre dans l’espace

robot-not-tested = la proposition ne peut pas être vérifiée avec le robot nominal : il faut au moins { $fewest } lignes où trois articulations bougent, avec des coordonnées réparties dans l’espace ; `etalon axes` évalue les balayages d’une seule articulation

robot-contradicts = le robot nominal ne reproduit { $points } avec aucun ordre, sens ni unité des articulations essayés{ $known ->
        [yes] {" "}; le plus petit résidu est de { FIXED($rms_mm, 2) } mm (moyenne quadratique)
       *[no] {""}
    }

robot-ambiguous = les données ne déterminent pas l’ordre et le sens de { $joints } : une autre interprétation donne un résidu de { FIXED($rms_mm, 3) } mm (moyenne quadratique)

robot-units-ambiguous = les données ne déterminent pas les unités des articulations : une autre unité donne un résidu de { FIXED($rms_mm, 3) } mm (moyenne quadratique)

robot-finds-targets = avec une cible propre à chaque valeur de { $column }, le robot nominal reproduit les coordonnées

robot-contradicts-unit = l’en-tête de { $column } indique { $stated }, mais la cinématique du robot nominal concorde avec { $unit }

robot-contradicts-order = le robot nominal concorde avec les données si les articulations sont dans l’ordre { $columns }, contrairement à l’ordre des en-têtes : vérifier les en-têtes et le fichier de robot

robot-reverses = { $column } est compté en sens inverse de `{ $joint }` : le robot nominal concorde avec le signe opposé

robot-orders = le robot nominal concorde avec les données si les articulations sont dans l’ordre { $columns }

robot-reproduces = le robot nominal reproduit { $points } en { $unit } avec un résidu de { FIXED($rms_mm, 4) } mm (moyenne quadratique de { $rows } lignes, base et cible ajustées)
robot-orders-angles = les orientations du robot nominal s’accordent, à { FIXED($misfit_deg, 2) }° près, à { $kind ->
        [vector] un vecteur rotation
       *[angles] trois angles dans l’ordre { $order }
    } en { $unit } ; aucune autre forme ne convient
robot-orders-quaternion = les orientations du robot nominal s’accordent au quaternion dont le scalaire est { $scalar ->
        [first] en premier
       *[last] en dernier
    }

points-commanded = { $points } : valeurs commandées ou calculées, non mesurées ; le robot nominal les reproduit à l’arrondi près (résidu { FIXED($rms_mm, 6) } mm)

points-perhaps-commanded = { $points } : peut-être des valeurs commandées, non mesurées ; le résidu de { FIXED($rms_mm, 4) } mm ne dépasse pas l’arrondi des coordonnées et des valeurs articulaires

file-is = `{ $file }` : { $kind }, { $rows ->
        [one] 1 ligne
       *[other] { $rows } lignes
    }{ $coordinates ->
        [none] {""}
        [open] , coordonnées d’unité inconnue
       *[other] , coordonnées en { $coordinates }
    }{ $joints ->
        [none] {""}
        [open] , articulations d’unité inconnue
       *[other] , articulations en { $joints }
    }{ $times ->
        [none] {""}
        [open] , temps d’unité inconnue
       *[other] , temps en { $times }
    }

files-join = { $matching } des { $keys } lignes de `{ $file }` ont une ligne correspondante dans `{ $log }` (clé : { $by })

files-not-joined = aucune clé ne joint tous les exports aux { $rows } lignes de `{ $log }`
recording-not-joined = les instants ne joignent pas `{ $log }` : les arrêts d’au moins 1 s sont moins nombreux que les points ({ $standstills }), et aucun décalage des horloges ne donne à chaque point sa propre ligne
rows-of-several-targets = `{ $file }` a { $rows } lignes, { $count } pour chacune des { $poses } lignes du journal : il contient peut-être { $count } cibles. Écrire la cible et la pose de chaque ligne dans des colonnes

doubt-numbers-and-text = la colonne { $column } contient des nombres dans { $count } des { $rows } lignes, et `{ $text }` : exclure ces lignes (`header`, `comment`)

doubt-array-columns = `{ $array }` a { $count } colonnes : des articulations, des coordonnées, ou les deux côte à côte
zero-count-alone = `zero_count` est sans effet sans `per_count`

payload-column-missing = `payload` du fichier de robot exige la colonne `{ $column }`
    .expected = `load_kg`, et le centre de masse dans la bride : `load_x_mm`, `load_y_mm`, `load_z_mm`
    .hint = ajouter la colonne, avec 0 dans les lignes sans charge, ou supprimer `payload` du fichier de robot

payload-invalid = `{ $column }` { $value ->
        [missing] manque
       *[other] vaut { $value }
    }
    .expected = une masse en kg d’au moins 0, ou une longueur en mm
    .hint = indiquer 0 lorsque le robot ne porte rien

torque-column-missing = `torque` du fichier de robot mentionne l’articulation `{ $joint }`, et la colonne `{ $column }` manque
    .hint = ajouter la colonne, ou retirer l’articulation de `torque` dans le fichier de robot

torque-invalid = `{ $column }` { $value ->
        [missing] manque
       *[other] vaut { $value }
    }
    .expected = un couple en N·m
    .hint = corriger la cellule, ou exclure la ligne

temperature-column-missing = `drift` ou `expansion` du fichier de robot exige la colonne `{ $column }`
    .expected = la température du robot en °C
    .hint = ajouter la colonne, ou retirer `drift` et `expansion` du fichier de robot

temperature-invalid = `{ $column }` { $value ->
        [missing] manque
       *[other] vaut { $value }
    }
    .expected = une température en °C, au-dessus du zéro absolu
    .hint = corriger la cellule, ou exclure la ligne

approach-unknown = direction d’approche inconnue : { $visits }{ $count ->
        [one] {""}
       *[other] {""} ; { $count } en tout
    } ; la lecture de la pose précédente manque
    .hint = si le robot n’est passé par aucune autre pose, indiquer les directions d’approche dans une colonne `approach`

visit-of-cycle = pose { $pose } du cycle { $cycle }

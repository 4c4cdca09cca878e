### Messages de stages ; explications dans en/stages.ftl.

rigid-distance-off = la distance { $first }-{ $second } est { $side ->
        [shorter] plus courte
       *[longer] plus longue
    } que sa médiane de { FIXED($off_mm, 3) } mm (tolérance { $limit_mm } mm)

rigid-point-coincides = { $message } ; le point se trouve où est `{ $other }`

rigid-row-refused = ligne { $row } : `{ $target }` est refusé : { $reason }

rigid-targets = une pièce rigide demande deux cibles ou plus, chacune nommée une fois
    .hint = nommer chaque cible de la pièce une fois dans `targets`

limit-not-positive = `{ $key }` doit être un nombre positif
    .expected = { $key ->
            [drift_mm] le plus grand mouvement d’une cible fixe pendant la campagne, par exemple 0.02
           *[tolerance_mm] le plus grand écart d’une distance à sa médiane : quelques fois sa dispersion, par exemple 0.1
        }

rigid-uncertainty-without-places = `{ $key }` appartient à `places_mm`, qui manque
    .hint = indiquer `places_mm`, ou supprimer `{ $key }`

rigid-place-unknown = `places_mm` nomme `{ $target }`, qui n’est pas une cible de cette pièce rigide

rigid-place-missing = `places_mm` n’indique pas la position de `{ $target }`
    .hint = ajouter ses coordonnées, ou la supprimer de `targets`

rigid-places-need-uncertainty = `places_mm` demande `{ $key }`, un nombre positif
    .expected = l’incertitude élargie d’une coordonnée, et son facteur d’élargissement

rigid-row-without-pose = [[rigid]] nomme `{ $target }`, et cette ligne n’a ni pose ni temps
    .hint = nommer la pose dans `label` ou `columns`, ou supprimer la cible de [[rigid]]

rigid-time-twice = [[rigid]] nomme `{ $target }`, et deux de ses lignes ont le même temps
    .hint = la première est la ligne { $first } ; nommer la pose dans `label` ou `columns`

rigid-never-together = { $targets } de [[rigid]] ne sont jamais mesurées ensemble
    .expected = des lignes de mêmes pose et cycle, ou de même temps
    .hint = nommer la pose dans `label` ou `columns` ; `pose = "row"` numérote les lignes de fichiers à une cible

rigid-few-distances = la distance `{ $first }`-`{ $second }` de [[rigid]] ne refuse aucune ligne : elle a été mesurée { $count } fois
    .expected = { $least } fois ou plus

exclusion-mixed = une exclusion nomme soit des poses, soit les lignes d’un fichier
    .expected = `poses`, éventuellement avec `cycle` et `target` ; ou `file` et `rows`

exclusion-file-unknown = `{ $file }` n’est pas un export avec des lignes à exclure

of-name = `{ $name }` : { $message }

point-lies-at-another = ligne { $row } : `{ $point }` se trouve où est `{ $other }`{ $rows ->
        [one] {""}
       *[other] {""} ; { $rows } lignes de ce genre en tout
    }
    .hint = si l’instrument visait l’autre cible ou si l’étiquette est fausse, la corriger ou exclure la ligne ; [[rigid]] refuse des lignes d’après leurs distances

drift-few-readings = `{ $target }` est mesurée { $count } fois : trop peu pour détecter une dérive
    .expected = { $least } ou plus

reference-drifts = `{ $target }` dérive : des lignes { $first } aux lignes { $second }, elle se déplace de { FIXED($moved_mm, 4) } mm ; limite { $limit_mm } mm
    .hint = vérifier la température et la fixation de l’instrument ; avec `targets` et `each = "pose"` dans [frame.world], le repère suit les cibles

frames-differ = les points sont relatifs au repère `{ $second }` ; ceux d’un autre export le sont au repère `{ $first }`
    .hint = les exporter dans un même repère de travail, ou ne pas les utiliser ensemble

export-empty = `{ $file }` ne contient aucun point
    .hint = exporter de nouveau les points, ou supprimer cet [[export]] ; `etalon formats FICHIER` montre comment un texte est lu

target-formula = la cible `{ $target }` est une formule dans un tableur
    .hint = la renommer, ou indiquer un `label` sans son premier caractère

target-without-pose = la ligne nomme une cible mais pas de pose
    .hint = nommer la pose dans l’étiquette, ou indiquer `pose = "row"` pour cet export

target-twice = la cible `{ $target }` figure deux fois à la pose { $pose }, cycle { $cycle }
    .hint = la première est { $file }:{ $line } ; { $numbered ->
            [by-row] indiquer `pose = "row + 100"` pour l’un des fichiers
           *[by-label] numéroter les répétitions comme cycles, ou en supprimer une
        }

labels-unused = { $count ->
        [one] { $count } étiquette ne nomme aucune cible et n’est utilisée
       *[other] { $count } étiquettes ne nomment aucune cible et ne sont utilisées
    } par aucun élément ni repère ; la première est `{ $label }`
    .hint = corriger l’étiquette, ou `label` de cet export

column-step = { $column } à { $step } { $unit }

coordinates-rounded = des coordonnées de `{ $file }` sont arrondies ({ $columns }) : incertitude-type { FIXED($rounding_um, 1) } µm, instrument { FIXED($instrument_um, 1) } µm
    .hint = les exporter avec plus de décimales

labels-missing = aucun point n’a une étiquette de la forme `{ $pattern }`
    .hint = corriger le motif, ou ajouter l’export

exclusion-option-without-reason = { $option } { $text } n’indique pas de raison
    .expected = ce qui est exclu, et pourquoi : "13, 20-22: bille desserrée"

exclusion-poses = { $count ->
        [one] pose
       *[other] poses
    } { $poses }

exclusion-cycle = cycle { $cycle }

exclusion-target = cible `{ $target }`

excluded-readings = exclu : { $count ->
        [one] { $count } lecture
       *[other] { $count } lectures
    }, { $of } : { $reason }

exclusions-leave-nothing = les exclusions ne laissent aucune lecture
    .hint = supprimer une exclusion

exclusion-names-nothing = `{ $stated }` ne nomme aucune { $of ->
        [rows] ligne
       *[poses] pose
    } à exclure
    .expected = { $of ->
            [rows] des numéros et plages comme "13, 20-22", comptés depuis la première ligne de données
           *[poses] des noms et plages comme "13, 20-22, home"
        }

not-of-this-robot = `{ $name }` n’est pas une { $kind ->
        [joint] articulation
       *[target] cible
    } de ce robot

exclusion-without-reason = une exclusion demande sa raison
    .hint = indiquer dans `reason` pourquoi les mesures sont exclues

exclusion-matches-nothing = { $of ->
        [rows] il n’y a pas de ligne { $name } à exclure
       *[poses] il n’y a pas de lecture à la pose { $name } de ces cycle et cible à exclure
    }
    .hint = corriger l’exclusion, ou la supprimer

join-missing = des exports et des journaux demandent [join]
    .hint = indiquer `by` dans [join] : "pose", "pose_and_cycle", "row", "time" ou "label"

join-by-time-empty = aucun point mesuré n’a de partenaire dans le journal `{ $log }` : les deux temps les plus proches sont distants de { FIXED($apart_s, 3) } s
    .hint = vérifier la valeur et le signe de `clock_offset_s` : temps de la mesure moins temps du journal

join-empty = aucun point mesuré n’a de partenaire dans le journal `{ $log }` : la première pose des points est `{ $measured }`, celle du journal `{ $logged }`
    .hint = comparer les poses et cycles des exports et du journal, ou choisir une autre clé par `by` dans [join]

clock-from-standstills = l’horloge du journal `{ $log }` est réglée par { $count ->
        [one] { $count } arrêt
       *[other] { $count } arrêts
    } : décalage { FIXED($offset_s, 3) } s ± { FIXED($half_width_s, 3) } s
    .hint = avec ce décalage, chaque point mesuré tombe dans un arrêt

pose-without-frame = { $count ->
        [one] { $count } pose
       *[other] { $count } poses
    } sans repère du monde, exclues : { $poses }
    .hint = les cibles du repère ont été refusées ou non mesurées : voir import.json

join-contradicts = { $count ->
        [one] { $count } point mesuré a
       *[other] { $count } points mesurés ont
    } un autre { $column } que la ligne du journal `{ $log }` à laquelle ils sont joints : { $measured } et { $logged } (ligne { $line } du journal)
    .hint = joindre par pose ; ou omettre `{ $column }` de `columns` du journal, s’il y compte autre chose

row-counts-differ = `{ $file }` a { $rows } lignes, le journal `{ $log }` en a { $log_rows }
    .expected = des nombres égaux pour une jointure par ligne
    .hint = compléter le fichier auquel il manque des lignes ; ou nommer pose et cycle dans les deux, et joindre par eux

approach-direction-unknown = le journal `{ $log }` ne montre pas dans quel sens l’articulation `{ $joint }` est arrivée
    .hint = `backlash` le demande : indiquer les temps des lignes (`time_s` dans `columns`, ou `period_s`), ou `{ $column }` dans `columns` : +1 par le bas, -1 par le haut

backlash-direction-unknown = le journal `{ $log }` n’a pas de mouvement d’une articulation à jeu avant la pose { $poses } : exclue
    .hint = commencer le journal avant la première pose, ou indiquer le sens d’approche

targets-out-of-plane = les cibles du robot plan ont des hauteurs de { FIXED($low_mm, 3) } mm à { FIXED($high_mm, 3) } mm dans le repère du monde
    .hint = vérifier z des exports (unité, signe, colonne) et les points qui définissent le plan du repère du monde

log-column-missing = le journal `{ $log }` n’a pas de colonne `{ $column }`

column-empty = la colonne `{ $column }` est vide ou manque
    .hint = ajouter la colonne, ou compléter la cellule

targets-missing = des cibles manquent à la pose { $poses }
    .hint = leurs autres cibles comptent ; une pose ou une orientation les demande toutes

key-in-lines = { $key } (lignes { $lines })

log-key-twice = le journal `{ $log }` a { $count ->
        [one] { $count } clé
       *[other] { $count } clés
    } plus d’une fois : { $keys }
    .hint = ajouter `cycle` à la clé, ou supprimer les lignes qui ne comptent pas

keys-unmatched = { $count ->
        [one] { $count } clé
       *[other] { $count } clés
    } { $of ->
        [log] du journal `{ $log }` sans point mesuré
       *[points] de points mesurés sans ligne du journal `{ $log }`
    } ({ $columns }) : { $keys } ; voir import.json

pose-misspelt = la pose `{ $pose }` { $of ->
        [log] du journal `{ $log }` n’a pas été mesurée, et des poses mesurées ne sont pas dans le journal
       *[points] n’est pas dans le journal `{ $log }`, et des poses du journal n’ont pas été mesurées
    }

join-key-missing = la jointure demande `{ $key }`, que des lignes n’ont pas
    .hint = la nommer dans `label` des exports et dans `columns` du journal, ou changer `by` dans [join]

join-by-label-targets = une jointure par étiquette est pour un robot à une cible ; celui-ci en a { $count }
    .hint = nommer une cible, ou choisir une autre clé par `by` dans [join]

join-by-label-frame = une jointure par étiquette demande un repère du monde unique pour toutes les poses
    .hint = définir le repère par des points qui ne bougent pas

label-not-measured = aucun point mesuré n’a l’étiquette `{ $label }`

points-untouched = { $count ->
        [one] { $count } point n’est touché
       *[other] { $count } points ne sont touchés
    } par aucune ligne du journal `{ $log }` ; le premier est `{ $label }`

log-times-not-increasing = les temps du journal `{ $log }` ne croissent pas à sa ligne { $row }
    .hint = trier le journal par temps, et supprimer les lignes de temps égaux

times-missing = { $of ->
        [log] le journal a des lignes sans temps
        [export] l’export a des lignes sans temps
       *[points] aucun point mesuré n’a de temps
    }
    .hint = une jointure par temps demande `time_s` dans les colonnes des exports et du journal

several-rows-near = { $count ->
        [one] { $count } point mesuré a
       *[other] { $count } points mesurés ont
    } plusieurs lignes du journal `{ $log }` à moins de { $tolerance_s } s : la plus proche compte
    .hint = réduire `tolerance_s` à moins de la moitié de la période du journal

points-without-row = { $count ->
        [one] { $count } point mesuré n’a
       *[other] { $count } points mesurés n’ont
    } aucune ligne du journal `{ $log }` à moins de { $tolerance_s } s

rows-without-point = { $count ->
        [one] { $count } ligne
       *[other] { $count } lignes
    } du journal `{ $log }` sans point mesuré

target-time-twice = { $count } points de la cible `{ $target }` ont le même temps (lignes { $lines })
    .hint = corriger les temps, ou nommer la cible de chaque point

log-row-met-twice = la ligne { $row } du journal `{ $log }` est la plus proche de { $count } points de la cible `{ $target }` (lignes { $lines })
    .hint = réduire `tolerance_s`, ou vérifier `clock_offset_s`

clock-offset-none = aucun décalage des horloges ne place chaque point mesuré dans un arrêt du journal : { $count ->
        [one] { $count } temps convient
       *[other] { $count } temps conviennent
    }, jusqu’à { $last_s } s ; le temps { $first_s } s ne convient pas
    .hint = supprimer les points mesurés en mouvement ; ou indiquer `clock_offset_s` par un nombre : les lignes sans partenaire sont alors listées

range-of-seconds = { FIXED($low_s, 3) } à { FIXED($high_s, 3) } s

clock-offsets-several = les arrêts admettent { $count } plages du décalage des horloges, les premières : { $ranges }
    .hint = comparer les horloges, et indiquer `clock_offset_s` par un nombre

axis-of-world = "x", "y" ou "z"

observe-key-missing = le type `{ $kind }` demande `{ $column }`
    .hint = indiquer `{ $column }`

distance-not-positive = `distance_mm` manque ou n’est pas une longueur
    .expected = une longueur supérieure à 0

fixed-point-on-robot = `{ $name }` est une cible sur le robot, pas un point fixe
    .hint = donner aux points fixes leurs propres noms ; les lignes qui ne concernent qu’eux n’ont pas de pose

distance-to-itself = la distance est de `{ $name }` à lui-même
    .hint = corriger `other`

number-missing = `{ $column }` manque ou n’est pas un nombre
    .expected = { $column ->
            [offset_mm] la distance de la cible au plan suivant son axe, ou à la sphère vers l’extérieur : le rayon d’une bille, ou 0
           *[value_deg] la valeur de l’articulation d’après l’interrupteur ou le second codeur
        }

row-without-pose = une ligne de type `{ $kind }` n’a pas de pose
    .hint = les lignes sans pose indiquent des positions (`point`) et distances (`distance`) de points fixes, et des positions sur un `plane`, une `line` ou une `sphere`

known-unsupported = une ligne de type `{ $kind }` n’a pas de [[known]]
    .expected = `point`, `distance`, `plane`, `line` ou `sphere`

near-without-surface = `near_mm` est pour des positions sur des surfaces
    .hint = supprimer `near_mm`

kind-of-arms = les { $kind ->
        [joints] valeurs d’articulations
       *[poses] poses
    } sont pour des bras spatiaux, pas pour `{ $model }`
    .hint = observer des positions ou distances de cibles

kind-unknown = `{ $name }` n’est pas un type d’observation

name-on-few-rows = `{ $name }` n’est nommé que dans { $count ->
        [one] { $count } ligne
       *[other] { $count } lignes
    }, et `{ $meant }` dans { $meant_count }
    .hint = vouliez-vous dire `{ $meant }` ? sinon exclure les lignes de `{ $name }` : elles ne déterminent pas où il est

base-moves = les articulations { $joints } déplacent `base_link` : les positions sont prises comme mesurées dans un repère qui le suit
    .hint = si l’instrument est fixe dans la salle, prendre pour `base_link` la racine de l’URDF

names-of-fixed-things = donner aux cibles, points et plans leurs propres noms

partial-coordinates = { $count ->
        [one] { $count } ligne donne
       *[other] { $count } lignes donnent
    } une ou deux coordonnées d’une cible : chacune compte pour elle-même

station-missing = la colonne `station` est vide ici, et d’autres points en ont une
    .hint = nommer la station : les lignes sans station sont celles de la station du monde, qui doit voir le robot à { $least } poses ou plus

coordinates-unknown = `{ $text }` ne nomme pas de coordonnées
    .expected = des lettres parmi x, y et z : "z", "xy"

place-missing = la position de `{ $point }` manque ou n’est pas un nombre
    .hint = compléter ses coordonnées, ou supprimer la ligne

joint-value-missing = une valeur d’articulation manque ou n’est pas un nombre
    .hint = compléter ou supprimer la ligne

station-row-unsupported = { $fault ->
        [kind] une ligne de type `{ $kind }` indique la station `{ $station }`
        [coordinate] une coordonnée mesurée par la station `{ $station }` manque ou n’est pas un nombre
        [covariance] un point mesuré par la station `{ $station }` indique une covariance
       *[uncertainties] les coordonnées mesurées par la station `{ $station }` ont leurs propres incertitudes
    }
    .expected = des lignes de type `point` avec x_mm, y_mm, z_mm et une incertitude `u_mm`, pour les stations autres que la première

uncertainty-not-positive = `{ $column }` = { $value } n’est pas une incertitude-type
    .expected = un nombre positif

uncertainty-missing = la ligne n’a pas d’incertitude-type
    .hint = { $column ->
            [urot_deg] indiquer --rotation-uncertainty-deg (dans une campagne `expanded_rotation_uncertainty_deg` de [instrument]), ou une colonne `urot_deg`
           *[u_mm] indiquer --standard-uncertainty-um, ou une colonne `u_mm`
        }

surface-axis-missing = { $kind ->
        [line] la droite `{ $name }` demande l’axe du monde le plus proche d’elle
       *[plane] le plan `{ $name }` demande l’axe du monde le plus proche de sa normale
    }
    .expected = x, y ou z dans la colonne `axis`{ $kind ->
            [line] {""}
           *[plane] {""} : z pour une table, x ou y pour un mur
        }

offset-of-line = `offset_mm` est pour les plans et sphères, pas pour une droite
    .hint = laisser la cellule vide

near-missing = une position sur { $kind } demande `near_mm`
    .hint = indiquer environ où elle est, dans le monde

load-direction-unknown = `{ $direction }` n’est pas une direction
    .expected = +x, -x, +y, -y, +z ou -z

load-direction-unmeasured = la direction `{ $direction }` demande `z_mm` : aucun déplacement n’y est mesuré
    .hint = ajouter la colonne `z_mm`, ou supprimer la ligne

force-not-a-number = `{ $text }` n’est pas une force
    .expected = des newtons, zéro ou plus : la direction donne le signe

drift-without-commanded = `drift_set` demande des poses commandées
    .hint = les indiquer : `commanded = "commanded.csv"`

attained-poses-twice = [poses] et [repeatability] indiquent tous deux des poses atteintes
    .hint = garder celui où sont les mesures : des étiquettes, ou un tableau

limit-without-value = la limite `{ $limit }` ne peut pas être jugée : la pose { $pose } n’a pas cette valeur
    .hint = atteindre chaque pose au moins deux fois, et la commander

compensation-scatters = les positions atteintes se dispersent de { FIXED($after_mm, 4) } mm autour de la moyenne de leur pose après compensation par les cibles de référence, de { FIXED($before_mm, 4) } mm avant
    .hint = chercher une lecture fausse parmi les cibles de référence, ou les omettre

reference-targets-misshapen = les cibles de référence du cycle { $cycle } s’écartent de { FIXED($rms_mm, 4) } mm (moyenne quadratique) d’un mouvement rigide du premier cycle ; incertitude élargie { FIXED($expanded_mm, 4) } mm
    .hint = l’une d’elles a bougé ou a été mal mesurée : les mesurer de nouveau, ou l’omettre

repeatability-frame = [repeatability] demande un repère du monde mesuré une fois
    .hint = définir le repère par des points qui ne bougent pas

commanded-angle-unmeasured = `{ $column }` est commandé, mais les étiquettes n’apportent que des positions
    .hint = supprimer la colonne, ou donner les poses atteintes avec leurs angles en tableau : [poses]

commanded-pose-missing = aucune position n’est commandée pour la pose { $poses }
    .hint = ajouter une ligne pour chaque pose de la trajectoire qui a été mesurée

commanded-pose-unmeasured = la pose { $pose } est commandée, mais rien n’y a été mesuré

trajectory-empty = la trajectoire n’a pas de pose
    .hint = indiquer les poses d’un cycle dans leur ordre, par exemple [1, 2, 1, 3]

coplanar-not-four = `coplanar` ne nomme pas quatre poses de la trajectoire
    .expected = quatre de ses poses, une fois chacune

pose-not-in-trajectory = la pose { $pose } (cycle { $cycle }) n’est pas dans la trajectoire
    .hint = corriger l’étiquette, ou ajouter la pose à `trajectory`

pose-of-several-targets = la pose { $pose } (cycle { $cycle }) a des visites de `{ $target }` et d’une autre cible
    .hint = nommer l’unique cible de l’essai dans `label`

pose-of-cycle = pose { $pose } du cycle { $cycle }

visit-count-differs = la pose { $pose } a été mesurée { $found } fois dans le cycle { $cycle }, la trajectoire y passe { $count } fois
    .hint = ajouter la visite, ou supprimer toutes celles de cette pose et de ce cycle : l’approche des autres est inconnue

visits-missing = non mesuré : { $poses }{ $count ->
        [one] {""}
       *[other] {""} ; { $count } en tout
    }

homing-instrument-too-coarse = l’incertitude de mesure dépasse 25 % de la répétabilité de la prise d’origine, { FIXED($rp_mm, 4) } mm
    .hint = utiliser la valeur comme borne supérieure, ou mesurer avec un meilleur instrument

central-part-too-large = { $option } dépasse la trajectoire
    .expected = un nombre supérieur à 0 et au plus 100

path-points-out-of-range = { $option } est hors plage
    .expected = 2 à 100000

path-not-stated = { $option } demande { $path }
    .hint = indiquer le fichier de la trajectoire commandée

weave-incomplete = il manque { $option } au balayage
    .hint = indiquer course, fréquence et direction

weave-direction-count = { $option } n’a pas trois nombres
    .expected = x, y et z de la direction de l’oscillation

stream-twice = le flux `{ $stream }` figure deux fois
    .hint = donner à chaque flux son propre nom

in-observation = pose { $pose } cycle { $cycle } des observations : { $message }

in-candidate = pose { $pose } des candidates : { $message }

in-feature = élément `{ $name }` : { $message }

joints-of-pose-differ = ses lignes ont des valeurs d’articulation différentes
    .hint = les corriger, ou numéroter les répétitions dans la colonne `cycle`

target-repeated = la cible `{ $target }` figure deux fois
    .hint = numéroter les répétitions dans la colonne `cycle`

table-without-observations = il n’y a pas d’observations
    .hint = vérifier le fichier et les exclusions

arms-apart = avec les paramètres nominaux, les bras ne se rejoignent pas à ces valeurs d’articulation
    .hint = vérifier unité, signe et décalage des articulations, et les paramètres nominaux

assembly-mode-missing = le mode d’assemblage n’est pas indiqué
    .expected = 1 ou -1 dans la colonne `assembly`
    .hint = les candidates peuvent aussi être des positions : `pose,x_mm,y_mm` sans articulations donne tous les modes de travail

assembly-mode-ambiguous = les deux modes d’assemblage conviennent également : à { FIXED($near_mm, 2) } mm et { FIXED($far_mm, 2) } mm de la position mesurée
    .hint = indiquer une colonne `assembly` avec 1 ou -1 ; ou indiquer la position de la base (x_o, y_o, phi) sous [nominal]

assembly-modes-assumed = le mode d’assemblage de { $count } observations a été tiré de la mesure ({ $positive } en mode +1, { $negative } en mode -1) ; le moins net est celui de la pose { $pose } : { FIXED($near_mm, 1) } mm et { FIXED($far_mm, 1) } mm
    .hint = indiquer une colonne `assembly` avec 1 ou -1 si le journal la contient

height-missing = les observations d’un robot spatial n’ont pas de `z_mm`
    .hint = ajouter la colonne `z_mm`

uncertainties-twice = le tableau indique à la fois des incertitudes-types et des covariances de coordonnées
    .hint = supprimer `ux_mm`, `uy_mm`, `uz_mm`

coordinate-uncertainty-missing = la ligne indique une incertitude, mais `{ $column }` est vide
    .expected = de 0,00002 à 100 mm, ou toutes vides

coordinate-uncertainty-unusable = `{ $column }` = { $value } n’est pas l’incertitude d’une coordonnée
    .expected = de 0,00002 à 100 mm, ou toutes vides

position-covariance-invalid = la covariance de la ligne n’est pas définie positive
    .hint = vérifier l’ordre et l’unité des colonnes `cxx_mm2` ..

unplaced = { $kind ->
        [targets] { $count ->
            [one] { $count } cible mesurée
           *[other] { $count } cibles mesurées
        }
        [fixtures] { $count ->
            [one] { $count } élément fixe mesuré
           *[other] { $count } éléments fixes mesurés
        }
       *[both] { $count } cibles et éléments fixes mesurés
    } aux seules poses de validation : { $names } ; placés par ces lectures, le robot identifié étant imposé

validation-leaves-nothing = { $unplaced } : il ne reste rien pour valider
    .hint = les mesurer aussi à des poses d’étalonnage, ou déplacer une pose où elles sont mesurées vers `calibration`

placed-by-validation = { $unplaced } ; les statistiques en tiennent compte
    .hint = les mesurer aussi à des poses d’étalonnage, ou déplacer une pose où elles sont mesurées vers `calibration`

placed-by-validation-unjudged = { $unplaced } ; les lectures sans redondance ne sont pas jugées : { $names }
    .hint = les mesurer aussi à des poses d’étalonnage, ou déplacer une pose où elles sont mesurées vers `calibration`

candidate-positions-unreachable = aucune position candidate n’est atteinte par le `{ $model }`, ou le modèle n’a pas d’inverse
    .hint = indiquer des valeurs d’articulation, une colonne par articulation avec son unité

check-readings = y chercher des étiquettes échangées et des lectures fausses ; les mesurer de nouveau, ou les exclure par `exclude` dans [identify]

robust-fit-disagrees = un ajustement robuste change `{ $parameter }` de { FIXED($over_u, 1) } incertitudes-types de la différence (limite { FIXED($limit, 1) }) ; aucune pose ne contredit toutes les autres : les résidus ne sont pas normaux
    .hint = le robot a des erreurs que le modèle ne décrit pas, ou l’incertitude indiquée est trop petite

robust-fit-disagrees-at-poses = un ajustement robuste change `{ $parameter }` de { FIXED($over_u, 1) } incertitudes-types de la différence (limite { FIXED($limit, 1) }) ; poses qui contredisent les autres : { $poses }

target-positions = `{ $target }` ({ $count ->
        [one] { $count } position
       *[other] { $count } positions
    })

coordinates-commanded = le robot nominal reproduit les coordonnées de { $targets } à partir des valeurs d’articulation à { SCIENTIFIC($largest_mm, 2) } mm près, l’arrondi du fichier : elles ont été commandées, non mesurées
    .hint = nommer les coordonnées mesurées dans `columns` ; si les données sont simulées, indiquer `synthetic` dans la campagne

frame-points-mirrored = les points du repère du monde sont à { FIXED($off_mm, 3) } mm de leurs positions nominales, et conviennent à leur image miroir à { FIXED($limit_mm, 3) } mm près
    .hint = deux axes de l’export sont échangés, ou l’un a le signe opposé : vérifier ses colonnes

frame-point-off = `{ $point }` est à { FIXED($off_mm, 3) } mm de sa position nominale par rapport aux autres points (tolérance { $tolerance_mm } mm, U = { FIXED($expanded_mm, 4) } mm)
    .hint = vérifier le point, son étiquette et `nominal_mm`, ou indiquer la tolérance du plan

frame-points-off = de `{ $first }` à `{ $second }`, il y a { FIXED($measured_mm, 3) } mm mesurés, { FIXED($nominal_mm, 3) } mm nominaux (tolérance { $tolerance_mm } mm, U = { FIXED($expanded_mm, 4) } mm)
    .hint = vérifier le point, son étiquette et `nominal_mm`, ou indiquer la tolérance du plan

nominal-point-unmeasured = `nominal_mm` nomme `{ $point }`, qui n’a pas été mesuré

nominal-few-points = `nominal_mm` demande trois points ou plus
    .hint = ajouter des points du repère, ou le supprimer

world-axes-exchanged = la base est à { FIXED($off_mm, 0) } mm et { FIXED($off_deg, 1) } deg de la position indiquée dans robot.toml : x, y, z de robot.toml sont { $axes } du repère du monde
    .hint = vérifier axes, unité et points du repère du monde, et [nominal] de robot.toml

base-off-nominal = la base est à { FIXED($off_mm, 0) } mm et { FIXED($off_deg, 1) } deg de la position indiquée dans robot.toml ; limite { $limit_mm } mm, { FIXED($limit_deg, 1) } deg
    .hint = vérifier axes, unité et points du repère du monde, et [nominal] de robot.toml

orientation-slip = { $slip ->
        [joint] `{ $name }` inversée
        [scalar-last] le scalaire des quaternions en dernier
        [scalar-first] le scalaire des quaternions en premier
        [scalar-last-inverse] le scalaire des quaternions en dernier, et les rotations inverses
        [order] les angles dans l’ordre `{ $name }`
        [vectors] des vecteurs de rotation au lieu d’angles
        [order-of-vectors] des angles dans l’ordre `{ $name }` au lieu de vecteurs de rotation
        [radians] les angles en radians au lieu de degrés
        [degrees] les angles en degrés au lieu de radians
        [inverse] les rotations inverses
       *[left-handed] un repère indirect ({ $name } inversé)
    }

slip-leaves = avec { $slip } de { FIXED($left_deg, 2) } deg

check-slips = elles diffèrent { $slips } : vérifier cela d’abord

orientations-off = les orientations observées diffèrent de celles du robot { $robot ->
        [nominal] nominal
       *[identified] identifié
    } de { FIXED($median_deg, 1) } deg (médiane)
    .hint = vérifier que qw, qx, qy, qz tournent des vecteurs du corps vers le monde, le scalaire en premier ; ou l’ordre des angles : sans `orientation`, ceux qui conviennent sont nommés

few-poses-to-leave-out = { $count ->
        [one] { $count } pose d’étalonnage est insuffisante
       *[other] { $count } poses d’étalonnage sont insuffisantes
    } pour en laisser de côté
    .expected = au moins { $least }
    .hint = en mesurer plus, ou en nommer plus dans `calibration`

nothing-to-judge = rien de ce qui a été observé n’est une position, une distance ou un contact
    .hint = les paramètres sont jugés par des erreurs de position : en mesurer

validation-repeats-calibration = la validation répète l’étalonnage : la moitié des poses de validation sont à moins de { FIXED($median, 2) } fois l’espacement des poses d’étalonnage de l’une d’elles ; limite { $limit }
    .hint = l’erreur du robot peut être plus grande ailleurs : valider sur des poses entre celles de l’étalonnage

validation-far = la validation est loin de l’étalonnage : la moitié des poses de validation sont à plus de { FIXED($median, 2) } fois l’espacement des poses d’étalonnage de la plus proche ; limite { $limit }
    .hint = étalonner sur des poses réparties dans l’espace de travail où le robot est utilisé

error-quantity-unknown = `{ $name }` n’est pas une grandeur d’erreur
    .hint = relancer la campagne : `etalon run CAMPAIGN`

pose-set-unknown = `{ $name }` n’est pas un ensemble de poses
    .expected = calibration ou validation

joint-does-not-move = `{ $joint }` ne bouge pas : les données laissent { $count ->
        [one] { $count } paramètre à sa tolérance
       *[other] { $count } paramètres à leurs tolérances
    } : { $parameters }
    .hint = déplacer `{ $joint }` entre les poses d’étalonnage, ou garder sa valeur à l’usage ; sinon des erreurs jusqu’à la tolérance de `{ $first }` demeurent

direction-undetermined = les points laissent sa direction incertaine de { FIXED($direction_deg, 0) } deg (k = 1) ; limite { $limit_deg } deg
    .hint = mesurer des points plus éloignés, pas tous alignés

direction-uncertain = sa direction a une incertitude-type de { FIXED($direction_deg, 2) } deg ; limite { $limit_deg } deg
    .hint = mesurer des points plus éloignés

world-frame-incomplete = le repère du monde { $fault ->
        [plane] n’a pas de plan
        [feature] a un plan qui n’est pas un élément
        [origin] n’a pas d’origine
        [towards] n’a pas de `towards`
       *[axis] demande soit `x_axis`, soit `y_axis`
    }
    .hint = indiquer `plane`, `origin`, `x_axis` ou `y_axis`, et `towards` dans [frame.world]

frame-name-unknown = aucune étiquette ni aucun élément ne s’appelle `{ $name }`
    .hint = corriger le nom, ou ajouter l’élément

world-axis-without-direction = l’axe du repère du monde n’a pas de direction
    .expected = deux étiquettes, de et à, ou un élément avec une direction

world-side-undetermined = `towards` est sur l’axe : il ne détermine pas le côté de l’autre axe
    .hint = nommer un point à côté de l’axe

frame-few-targets = le repère du monde a { $count ->
        [one] { $count } cible
       *[other] { $count } cibles
    }
    .expected = trois cibles ou plus

frame-never-complete = aucune pose n’a toutes les cibles { $targets } du repère du monde, distinctes
    .hint = les mesurer toutes, et vérifier leurs étiquettes

orientations-twice = le tableau a des orientations deux fois : { $first } et { $second }
    .hint = omettre l’une d’elles

orientation-columns-missing = il manque { $missing } à l’orientation
    .expected = { $columns } : corps dans le monde

orientation-missing = l’orientation manque ou n’est pas un nombre
    .expected = qw, qx, qy, qz : corps dans le monde ; ou un vecteur de rotation, ou trois angles

angle-order-missing = l’ordre des angles n’est pas indiqué
    .hint = indiquer `orientation = "zyx"` dans [observations], ou --orientation

angle-orders-unfit = aucun ordre des angles ne convient au robot nominal : `{ $order }` laisse { FIXED($left_deg, 1) } deg (moyenne quadratique) ; vérifier qu’ils tournent le corps vers le monde, et les articulations

angle-order-leaves = `{ $order }` laisse { FIXED($left_deg, 3) } deg

angle-orders-fit = indiquer `orientation = "zyx"` dans [observations], ou --orientation ; du robot nominal { $orders } (moyenne quadratique)

ball-missing = la bille `{ $target }` manque (pose { $pose }, cycle { $cycle })
    .hint = la mesurer, ou supprimer le reste de cette pose et de ce cycle

actuator-unknown = il n’y a pas d’actionneur { $actuator }
    .expected = 1, 2 ou 3

lead-position-unknown = la position { $position } de l’actionneur { $actuator } n’est pas dans `positions_mm`
    .hint = corriger l’étiquette, ou compléter `positions_mm`

geometric-frame = l’étalonnage géométrique demande un repère du monde défini par les rails et la bille R
    .expected = `plane`, `origin`, `y_axis = [origine, autre extrémité]` et `towards`, comme en 3.4.1 de la thèse

geometric-other-robot = [geometric] est l’étalonnage géométrique d’un PreXYT
    .expected = un robot de modèle `prexyt`

scale-bar-error = barre étalon `{ $name }` : une erreur de { FIXED($error_mm, 4) } mm dépasse l’erreur tolérée de { FIXED($limit_mm, 4) } mm
    .hint = vérifier palpeur, température et fixation de l’instrument, et mesurer la barre de nouveau

scale-bar-uncertain = barre étalon `{ $name }` : l’erreur tolérée vaut { FIXED($ratio, 1) } fois l’incertitude élargie de son certificat, { $least } sont exigées
    .hint = utiliser une barre avec un meilleur certificat : celle-ci ne vérifie rien

step-scatters = { $step } : les résidus se dispersent de { FIXED($found_mm, 4) } mm, l’instrument indique { FIXED($stated_mm, 4) } mm : les incertitudes suivent les résidus
    .hint = chercher un jeu, une bille sale ou un nid desserré ; mesurer l’étape de nouveau

table-without-poses = à aucune pose du tableau `{ $title }` K et L n’ont été mesurées ensemble
    .hint = mesurer les deux billes dans le même cycle, ou choisir d’autres poses

given-without-covariance = les paramètres n’ont pas de covariance
    .hint = identifier de nouveau à partir de données qui laissent des degrés de liberté

calibrated-targets-missing = il manque { $names } aux paramètres : une autre base ou d’autres cibles
    .hint = observer les cibles de l’étalonnage, là où elles étaient sur la partie mobile

parameters-of-other-robot = les paramètres sont ceux d’un `{ $identified }` ; robot.toml décrit un autre robot (`{ $stated }`)
    .hint = indiquer le robot.toml avec lequel ils ont été identifiés

parameters-lacking = il manque { $names } aux paramètres ; indiquer le robot.toml avec lequel ils ont été identifiés

parameters-undescribed = les paramètres contiennent { $names }, que robot.toml ne décrit pas
    .hint = indiquer le robot.toml avec lequel ils ont été identifiés

add-lines = ajouter { $lines } à robot.toml, avant son premier tableau

nominal-value-changed = `{ $parameter }` a pour valeur nominale { $stated }{ $unit ->
        [mm] {" "}mm
        [deg] {" "}deg
       *[other] {""}
    } dans robot.toml, et avait { $identified }{ $unit ->
        [mm] {" "}mm
        [deg] {" "}deg
       *[other] {""}
    } lors de l’identification
    .hint = vérifier que les paramètres sont ceux de ce robot

calibration-without-residuals = l’étalonnage ne montre aucun écart-type d’une coordonnée
    .hint = identifier avec une incertitude-type indiquée

effect-would-prove = { $effect }{ $count ->
        [0] {""}
       *[other] {" "}des articulations { $joints }
    } serait démontré : l’erreur aux poses d’étalonnage laissées de côté passe de { FIXED($without_mm, 3) } à { FIXED($with_mm, 3) } mm (position, moyenne quadratique)
    .hint = ajouter "{ $effect }" à `effects` dans [identify], ou indiquer `effects = "proven"`

outliers-too-many = `outliers = "exclude"` exclurait plus de { $share_percent } % des lectures
    .hint = le modèle ou le montage est faux : voir ce que signale `outliers = "keep"`

log-correlates = avec le journal `{ $log }`, les résidus sont corrélés à la différence des deux journaux (r = { FIXED($correlation, 2) }) : leur moyenne quadratique est { FIXED($rms_mm, 3) } mm, avec le journal `{ $other }` { FIXED($other_rms_mm, 3) } mm

use-log = { $hint ->
        [name-first] identifier avec le journal `{ $log }` : le nommer en premier
       *[is-used] le journal `{ $log }` est à utiliser, comme le fait cette campagne
    }

selected-pose-unmeasured = `{ $pose }` ne nomme aucune pose mesurée

selection-without-pose = `{ $set }` ne choisit aucune pose mesurée

sets-overlap = poses à la fois dans l’étalonnage et la validation : { $poses }
    .hint = `validation = "rest"` prend toutes celles que l’étalonnage ne prend pas

table-selection-empty = le tableau `{ $title }` n’a aucune pose mesurée
    .hint = un tableau montre des poses de `calibration` et `validation`

poses-measured = { $count ->
        [one] { $count } pose est mesurée et jointe
       *[other] { $count } poses sont mesurées et jointes
    }, de { $first } à { $last }

poses-unmeasured = aucune pose n’est mesurée et jointe

at-pose = pose { $pose } : { $message }

values-of-column = { $message } ({ $count } valeurs sur { $total } le sont)

check-column-unit = vérifier l’unité de sa colonne : toutes les valeurs sont dans la plage en { $units ->
        [degrees] degrés au lieu de radians
       *[millimetres] millimètres au lieu de mètres
    }

joint-out-of-range = articulation `{ $joint }` = { $value } { $unit } : hors plage
    .expected = de { $lower } à { $upper } { $unit } : { $reason ->
            [limits] les limites qu’indique le fichier du robot, et 0,1 au-delà
            [turns] deux tours, car le fichier du robot n’indique pas de limites
           *[others] car la moitié de ses valeurs sont groupées
        }
    .hint = vérifier son signe décimal et son unité ; si l’articulation peut y être, { $reason ->
            [limits] corriger ses limites dans le fichier du robot
           *[others] indiquer ses limites dans le fichier du robot
        }

common-errors-of-conditions = les erreurs communes à toutes les lectures (échelle, température, prise d’origine) ne sont tirées que pour des positions de cibles
    .hint = `etalon run` indique les incertitudes de cette campagne par propagation linéaire

probe-of-feature-unknown = `{ $feature }` n’est pas ajusté : ses points sont des centres de palpeur, et le fichier n’indique pas { $missing ->
        [side] de quel côté était le palpeur
       *[radius] le rayon du palpeur
    }
    .hint = { $missing ->
            [side] l’indiquer : --probe-side inside, outside ou x,y,z
           *[radius] l’indiquer : --probe-radius-mm
        }

unstable-parameter = `{ $parameter }` ({ FIXED($over_sd, 1) }, limite { FIXED($limit, 1) })

parameters-unstable = non stables, et imposés : les valeurs tirées d’une partie des poses diffèrent de celles tirées de toutes, en écarts-types de la différence : { $parameters }
    .hint = chercher ce qui a changé pendant la mesure (température, cible déplacée, nouvelle prise d’origine), et regarder les résidus

hold-unknown = `hold` nomme `{ $pattern }`, qui n’est pas un paramètre de ce robot

residuals-pose-not-planar = `residuals = "pose"` est pour les robots plans, pas pour `{ $model }`
    .hint = utiliser `residuals = "targets"`

remedy = { $remedy ->
        [pose-uncertainty] l’indiquer (--standard-uncertainty-um), ou comparer des cibles
        [contact-uncertainty] indiquer aussi la répétabilité du contact (--standard-uncertainty-um), et comparer des cibles
        [targets] donner les positions de ses cibles : des lignes de type `point`
        [uncertainty] l’indiquer (--standard-uncertainty-um)
        [own-uncertainties] comparer des cibles, ou supprimer les colonnes d’incertitudes
        [row-uncertainty] l’indiquer à chaque ligne, ou par --standard-uncertainty-um
        [part] `frame` est `flange` pour un bras, `platform` pour un PreXYT, `targets` pour tout robot
        [positions] choisir plus de positions, ou imposer des paramètres par `--hold`
        [base] mesurer plus de poses, ou indiquer base_x .. base_rz et les cibles sous [nominal] dans le fichier du robot
        [hold-fewer] imposer moins de paramètres, et mesurer plus de poses
        [more-poses] mesurer plus de poses (répéter une pose n’ajoute rien), ou imposer des paramètres par `hold` dans [identify] ou --hold
        [hold] imposer des paramètres dans [identify], ou mesurer plus de poses
        [unreachable] vérifier unité (degrés ou radians), signe et décalage des articulations, et les paramètres nominaux
        [extent] vérifier `unit` des exports, les unités des articulations dans le journal, et les longueurs du robot
        [assembly] corriger la colonne `assembly` de ces poses, ou la laisser vide : le mode est alors tiré de la mesure
       *[joints] vérifier unités, ordre et signes des articulations et les paramètres nominaux ; `hold` dans [identify] impose des paramètres
    }

reading-off = { FIXED($off_mm, 4) } mm ({ $target }, pose { $pose }, cycle { $cycle })

largest-residuals = plus grands résidus d’un ajustement robuste : { $readings }
    .hint = y chercher d’abord des étiquettes échangées et des lectures fausses ; les erreurs du robot se répartissent sur toutes les poses

outlier-readings = { $count ->
        [one] { $count } lecture sur { $total } est aberrante
       *[other] { $count } lectures sur { $total } sont aberrantes
    }, de plus de { $times } fois { FIXED($scale_mm, 4) } mm, l’écart-type des autres dans un ajustement robuste : { $readings }

outliers = { $outliers }

outliers-excluded = exclu par `outliers = "exclude"` : { $outliers }

repeated-position = { $target } aux poses { $first } et { $second }

positions-repeat = des positions mesurées se répètent au dernier chiffre alors que les articulations bougent, { $count } fois : { $pairs }
    .hint = l’export contient une lecture d’une autre pose : mesurer celles-ci de nouveau, ou les exclure

repeated-joints = poses { $first } et { $second }, distantes de { FIXED($apart_mm, 3) } mm

joint-values-repeat = des valeurs d’articulation se répètent au dernier chiffre alors que les cibles bougent, { $count } fois : { $pairs }
    .hint = le journal contient une lecture d’une autre pose : les enregistrer de nouveau, ou les exclure

repeats-scatter = les répétitions de `{ $label }` sont jusqu’à { FIXED($off_mm, 4) } mm de leur médiane ; incertitude-type de l’instrument { FIXED($u_mm, 4) } mm
    .hint = vérifier `unit` de l’export et l’incertitude de l’instrument, et que le point n’a pas bougé

repeat-off = { $away } sur { $count } répétitions de `{ $label }` { $away ->
        [one] est à
       *[other] sont jusqu’à
    } { FIXED($off_mm, 4) } mm de leur médiane ; incertitude-type de l’instrument { FIXED($u_mm, 4) } mm
    .hint = supprimer la lecture fausse de l’export, ou mesurer le point de nouveau : tous les résultats en dépendent

uncertainty-zero-rounded = `{ $column }` est 0 dans { $count ->
        [one] { $count } ligne
       *[other] { $count } lignes
    } : arrondi, et lu comme la résolution de la colonne, u = { $u } { $unit } (moitié du dernier chiffre sur √3)
    .hint = exporter les incertitudes avec plus de décimales

uncertainty-zero = `{ $column }` est 0 dans { $count ->
        [one] { $count } ligne
       *[other] { $count } lignes
    }, et ne montre aucune résolution : l’incertitude de l’instrument y compte
    .hint = exporter les incertitudes avec plus de décimales

key-of-text-table = `{ $key }` n’a pas de sens pour une feuille de classeur
    .hint = supprimer `{ $key }` : les cellules d’un classeur sont lues telles quelles

measurements-undescribed = aux poses { $set ->
        [validation] de validation
       *[calibration] d’étalonnage
    }, le modèle laisse { FIXED($after_mm, 3) } mm (moyenne quadratique) pour des positions étalées sur { FIXED($spread_mm, 1) } mm ; { $count } lectures sur { $total } s’écartent de plus de { FIXED($limit_mm, 1) } mm : le modèle ne décrit pas ces mesures

undescribed-targets = toutes les lectures de { $targets } s’écartent, et aucune autre : vérifier ses étiquettes, et si elle a été déplacée

undescribed-readings = { $readings } : { $remedy }

undescribed-set-up = vérifier unités, ordre et signes des articulations, les paramètres nominaux, et la jointure du journal et des points

undescribed-frame-moved = un mouvement du repère de { FIXED($motion_mm, 1) } mm laisse { FIXED($left_mm, 3) } mm : la base ou le système de mesure a bougé entre les poses d’étalonnage et de validation

undescribed-unchecked = les poses d’étalonnage ne laissent aucune coordonnée pour le contrôle : d’autres positions de la base et des cibles y conviennent aussi ; mesurer davantage de poses d’étalonnage, réparties dans l’espace de travail

undescribed-other-poses = les poses d’étalonnage conviennent, et aucun mouvement du repère n’explique les autres : vérifier que le journal et les exports des poses de validation concernent les mêmes poses (journal d’une autre campagne, ou poses numérotées autrement)

prior-of-nominal = des paramètres nominaux n’ont pas de covariance pour `--frames prior`
    .hint = en nommer d’identifiés par `--parameters`, ou utiliser `--frames refit`

prior-of-conditions = `--frames prior` est pour des positions mesurées seulement
    .hint = exclure les lignes d’autres types, ou réajuster base et cibles : `--frames refit`

place-without-nominal = `{ $parameter }` n’a pas de valeur nominale : il est tiré des mesures
    .hint = ajuster base et cibles aux poses d’étalonnage : `--frames refit`

given-parameters-worse = les paramètres donnés laissent { FIXED($given_mm, 3) } mm, les nominaux { FIXED($nominal_mm, 3) } mm (moyenne quadratique)
    .hint = vérifier que ce sont ceux de ce robot, et si base et cibles sont celles de cette campagne (`--frames`)

candidate-poses-too-few = { $wanted } poses candidates sur { $count } ne peuvent être choisies
    .hint = indiquer moins de `--positions`, ou plus de candidates

target-names-exchanged = avec les noms des cibles `{ $first }` et `{ $second }` échangés, les résidus passent de { FIXED($before_mm, 3) } à { FIXED($left_mm, 3) } mm
    .hint = échanger les deux noms dans l’export

one-pose-contradicts = sans la pose `{ $pose }`, les observations ne contredisent pas les paramètres
    .hint = mesurer cette pose de nouveau, et enregistrer de nouveau ses articulations

motions-alike = { $count ->
        [one] { $count } autre mouvement explique
       *[other] { $count } autres mouvements expliquent
    } aussi ces résidus : { $motions }
    .hint = observer des poses qui diffèrent plus par les valeurs des articulations

no-coordinates-to-check = { $count ->
        [one] { $count } coordonnée des poses d’étalonnage détermine
       *[other] { $count } coordonnées des poses d’étalonnage déterminent
    } { $parameters ->
        [one] { $parameters } paramètre
       *[other] { $parameters } paramètres
    } : il n’en reste pas pour les vérifier
    .hint = mesurer plus de poses, réparties dans l’espace de travail

validation-outliers = { $count } erreurs de validation sur { $total } dépassent { FIXED($limit_mm, 4) } mm, { $times } fois leur médiane : { $readings }

common-scale = { $parameters } valent tous environ { FIXED($factor, 5) } fois leur valeur nominale : une erreur d’échelle du système de mesure ou des articulations l’explique mieux que des erreurs de { $count } pièces
    .hint = vérifier échelle, compensation de température et unité du système de mesure et des codeurs

compliance-negative = `{ $parameter }` est négatif ({ FIXED($value, 5) } { $unit }) : l’articulation fléchit contre la pesanteur
    .hint = vérifier `gravity` et la direction de l’axe de l’articulation dans robot.toml

backlash-negative = `{ $parameter }` est négatif ({ FIXED($value, 5) } { $unit }) : l’articulation devance son entraînement, ce qu’aucun jeu n’explique
    .hint = vérifier le signe des sens d’approche (+1 où la valeur croissait, -1 où elle décroissait), et que les temps du journal sont ceux du même mouvement

ball-names-exchanged = `{ $parameter }`, la distance de K et L, vaut { FIXED($value, 3) } { $unit } : K et L sont échangées
    .hint = échanger les noms des deux cibles dans les étiquettes de l’export

identified-worse-than-nominal = aux poses { $set ->
        [validation] de validation
       *[calibration] d’étalonnage
    }, le robot identifié est moins bon que le robot nominal : { FIXED($before_mm, 4) } mm avant, { FIXED($after_mm, 4) } mm après (moyenne quadratique)
    .hint = mesurer plus de poses, réparties dans l’espace de travail, ou imposer des paramètres qu’elles ne déterminent pas

value-beyond-tolerance = `{ $parameter }` = { $unit ->
        [mm] { FIXED($value, 3) } { $unit } (nominal { $nominal } { $unit }, tolérance { FIXED($tolerance, 3) } { $unit })
        [deg] { FIXED($value, 3) } { $unit } (nominal { $nominal } { $unit }, tolérance { FIXED($tolerance, 3) } { $unit })
       *[other] { FIXED($value, 4) } (nominal { $nominal }, tolérance { FIXED($tolerance, 3) })
    }

tolerance-exceeded = { $count ->
        [one] { $count } paramètre dépasse
       *[other] { $count } paramètres dépassent
    } la tolérance du robot : { $parameters }
    .hint = vérifier signes, unités et ordre des articulations, les valeurs nominales et les repères ; si le robot est dessiné autrement, indiquer `tolerance` dans le fichier du robot

format-not-identified = les paramètres du format `{ $format }` n’ont pas pu être identifiés de nouveau : { $message }

clock-rate-from-standstills = l’horloge de la mesure avance de { FIXED($rate_ppm, 1) } ppm ± { FIXED($u_ppm, 1) } ppm (k = 1) par rapport à celle du journal `{ $log }` (possible : { FIXED($low_ppm, 1) } à { FIXED($high_ppm, 1) } ppm) ; décalage { FIXED($offset_s, 3) } s ± { FIXED($u_s, 3) } s (k = 1) à { FIXED($reference_s, 3) } s du journal
    .hint = avec ce décalage et cette dérive, chaque point mesuré tombe dans un arrêt ; aucun décalage seul n’y suffit

clock-rate-insignificant = les arrêts du journal `{ $log }` ne montrent aucune dérive entre les horloges : elle est comprise entre { FIXED($low_ppm, 1) } et { FIXED($high_ppm, 1) } ppm
    .hint = omettre `clock_rate` : seul le décalage est utilisé

clock-rate-none = à aucun décalage des horloges et à aucune dérive dans ± { $most_ppm } ppm chaque point mesuré ne tombe dans un arrêt du journal
    .hint = vérifier que le journal est celui de cette mesure et retirer les points mesurés en mouvement ; ou indiquer `clock_offset_s` par un nombre

row-excluded = exclue : { $reason }
row-at-origin = non mesuré : 0 0 0
row-of-several = { $rows } lignes du journal `{ $log }` sont à moins de { $tolerance_s } s : la plus proche compte
no-rows-around = le journal `{ $log }` n’a pas de ligne avant ou après à moins de { $tolerance_s } s
no-row-near = aucune ligne du journal `{ $log }` n’est à moins de { $tolerance_s } s
no-point-nearest = aucun point mesuré n’en est le plus proche
no-row-of-key = aucune ligne du journal `{ $log }` n’a cette clé
no-point-of-key = aucun point mesuré n’a cette clé
no-row-touches = aucune ligne du journal `{ $log }` ne le touche
row-of-unframed-pose = sa pose n’a pas de référentiel atelier

table-of-observations = observations
table-of-attained-poses = poses atteintes
table-of-commanded-poses = poses commandées
table-of-reference-targets = cibles de référence
table-of-commanded-path = trajectoire commandée
table-of-compliance = souplesse statique
recorded-motion-file = mouvement enregistré
read-in-unit = { $format }, unité { $unit }
read-in-frame = { $read }, par rapport à `{ $frame }`

side-stated = comme indiqué par l’utilisateur
side-from-values = d’après { $of ->
        [normal] la normale
        [location] la position
       *[diameter] le diamètre
    } { $values ->
        [nominal] nominal
       *[stated] indiqué
    }
side-from-key = d’après `InternalExternal` : { $value }

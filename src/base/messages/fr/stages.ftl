### Messages de stages ; explications dans en/stages.ftl.

rigid-distance-off = la distance { $first }-{ $second } est { $side ->
        [shorter] plus courte
       *[longer] plus longue
    } de { FIXED($off_mm, 3) } mm que sa médiane (tolérance { $limit_mm } mm)

rigid-targets-exchanged = les distances concordent si `{ $first }` et `{ $second }` sont interverties

rigid-target-refused = [[rigid]] rejette { $rows ->
        [one] la seule ligne
       *[other] toutes les { $rows } lignes
    } de `{ $target }`, la première dans `{ $file }`, ligne { $line } : { $reason }
    .hint = corriger les étiquettes interverties ou `tolerance_mm`, ou retirer la cible de [[rigid]]

rigid-point-coincides = { $message } ; le point coïncide avec `{ $other }`

rigid-row-refused = `{ $target }` est rejetée à la ligne { $row } : { $reason }

rigid-targets = une pièce rigide nécessite au moins deux cibles, chacune indiquée une seule fois
    .hint = indiquer chaque cible de la pièce une seule fois dans `targets`

rigid-across-branches = la pièce rigide { $targets } s’étend sur plusieurs branches du robot
    .hint = indiquer un [[rigid]] pour les cibles de chaque branche

limit-not-positive = `{ $key }` doit être un nombre positif
    .expected = { $key ->
            [drift_mm] le plus grand mouvement d’une cible fixe pendant la campagne, par exemple `0.02`
           *[tolerance_mm] le plus grand écart d’une distance à sa médiane : un multiple de la dispersion, par exemple `0.1`
        }

rigid-uncertainty-without-places = `{ $key }` appartient à `places_mm`, qui manque
    .hint = indiquer `places_mm`, ou supprimer `{ $key }`

rigid-place-unknown = `places_mm` mentionne `{ $target }`, qui n’est pas une cible de cette pièce rigide

rigid-place-missing = `places_mm` n’indique pas la position de `{ $target }`
    .hint = ajouter ses coordonnées, ou supprimer la cible de `targets`

rigid-places-need-uncertainty = `places_mm` nécessite `{ $key }`, un nombre positif
    .expected = l’incertitude élargie d’une coordonnée, et son facteur d’élargissement

rigid-row-without-pose = [[rigid]] mentionne `{ $target }`, mais cette ligne n’a ni pose ni horodatage
    .hint = indiquer la pose dans `label` ou `columns`, ou supprimer la cible de [[rigid]]

rigid-time-twice = [[rigid]] mentionne `{ $target }`, mais deux de ses lignes ont le même instant
    .hint = la première est la ligne { $first } ; indiquer la pose dans `label` ou `columns`

rigid-never-together = { $targets } de [[rigid]] ne sont jamais mesurées ensemble
    .expected = des lignes de même pose et de même cycle, ou de même instant
    .hint = indiquer la pose dans `label` ou `columns` ; `pose = "row"` numérote les lignes de fichiers à une seule cible

rigid-few-distances = la distance `{ $first }`-`{ $second }` de [[rigid]] ne peut faire rejeter une ligne : elle n’a été mesurée que { $count } fois
    .expected = au moins { $least } fois

exclusion-mixed = une exclusion désigne soit des poses, soit les lignes d’un fichier
    .expected = `poses`, éventuellement avec `cycle` et `target` ; ou `file` et `rows`

exclusion-file-unknown = `{ $file }` n’est pas un export dont des lignes peuvent être exclues

of-name = `{ $name }` : { $message }

point-lies-at-another = ligne { $row } : `{ $point }` coïncide avec `{ $other }`{ $rows ->
        [one] {""}
       *[other] {""} ; { $rows } lignes de ce type en tout
    }
    .hint = si l’instrument visait l’autre cible ou si l’étiquette est fausse, la corriger ou exclure la ligne ; [[rigid]] rejette des lignes d’après leurs distances

drift-few-readings = `{ $target }` n’est mesurée que { $count } fois : trop peu pour déceler une dérive
    .expected = au moins { $least } fois

reference-drifts = `{ $target }` dérive : entre les lignes { $first } et les lignes { $second }, elle se déplace de { LENGTH($moved_mm) } ; limite { LENGTH($limit_mm) }
    .hint = vérifier la température et la fixation de l’instrument ; avec `targets` et `each = "pose"` dans [frame.world], le repère suit les cibles

frames-differ = les points se rapportent au repère `{ $second }` ; ceux d’un autre export, au repère `{ $first }`
    .hint = les exporter dans un même repère, ou ne pas les utiliser ensemble

export-empty = `{ $file }` ne contient aucun point
    .hint = exporter de nouveau les points, ou supprimer cet [[export]] ; `etalon formats FICHIER` montre comment un fichier texte est lu

target-formula = un tableur prendrait le nom `{ $target }` pour une formule
    .hint = renommer la cible, ou indiquer un `label` qui omet le premier caractère

target-without-pose = la ligne indique une cible, mais pas de pose
    .hint = indiquer la pose dans l’étiquette, ou indiquer `pose = "row"` pour cet export

target-twice = la cible `{ $target }` apparaît deux fois à la pose { $pose }, cycle { $cycle }
    .hint = la première est { $file }:{ $line } ; { $numbered ->
            [by-row] indiquer `pose = "row + 100"` pour l’un des fichiers
           *[by-label] donner à chaque répétition son propre numéro de cycle, ou en supprimer une
        }

labels-unused = { $count ->
        [one] { $count } étiquette ne désigne aucune cible et n’est utilisée
       *[other] { $count } étiquettes ne désignent aucune cible et ne sont utilisées
    } par aucun élément ni repère ; la première est `{ $label }`
    .hint = { $points ->
            [stationary] laisser tels quels les points qui ne bougent pas avec le robot ; `targets` de [frame.world] en fait le référentiel atelier
           *[moving] corriger l’étiquette, ou le motif `label` de cet export
        }

column-step = { $column } à { $step } { $unit } près

coordinates-rounded = les coordonnées de `{ $file }` sont arrondies ({ $columns }) : incertitude-type de l’arrondi { FIXED($rounding_um, 1) } µm, de l’instrument { FIXED($instrument_um, 1) } µm
    .hint = les exporter avec plus de décimales
origin-not-measured = la ligne { $line } de `{ $file }` est 0 0 0 : elle est considérée comme non mesurée
    .hint = si c’est un point mesuré à l’origine du repère, indiquer un format avec `missing = [""]`

labels-missing = aucun point n’a une étiquette de la forme `{ $pattern }`
    .hint = corriger le motif, ou ajouter l’export

exclusion-option-without-reason = { $option } { $text } n’indique pas de raison
    .expected = les poses ou lignes exclues, et la raison : "13, 20-22: bille desserrée"

exclusion-poses = { $count ->
        [one] pose
       *[other] poses
    } { $poses }

exclusion-cycle = cycle { $cycle }

exclusion-target = cible `{ $target }`

excluded-readings = { $count ->
        [one] { $count } lecture exclue
       *[other] { $count } lectures exclues
    }, { $of } : { $reason }

exclusions-leave-nothing = toutes les lectures sont exclues
    .hint = supprimer une exclusion

exclusion-names-nothing = `{ $stated }` ne désigne aucune { $of ->
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

exclusion-without-reason = une exclusion doit être motivée
    .hint = indiquer dans `reason` pourquoi les mesures sont exclues

exclusion-matches-nothing = { $of ->
        [rows] il n’y a pas de ligne { $name } à exclure
       *[poses] il n’y a pas, à la pose { $name }, de lecture de ce cycle et de cette cible à exclure
    }
    .hint = corriger l’exclusion, ou la supprimer

join-by-time-empty = aucun point mesuré n’a de ligne correspondante dans le journal `{ $log }` : les deux instants les plus proches sont distants de { FIXED($apart_s, 3) } s
    .hint = vérifier la valeur et le signe de `clock_offset_s` : instant de la mesure moins instant du journal

both-rows-near = un point entre deux lignes exige que les deux soient à moins de `tolerance_s` : indiquer au moins l’intervalle de temps entre deux lignes

join-empty = aucun point mesuré n’a de ligne correspondante dans le journal `{ $log }` : la première pose des points est `{ $measured }`, celle du journal `{ $logged }`
    .hint = comparer les poses et cycles des exports et du journal, ou choisir une autre clé par `by` dans [join]

clock-from-standstills = l’horloge du journal `{ $log }` est calée sur { $count ->
        [one] { $count } arrêt
       *[other] { $count } arrêts
    } : décalage { FIXED($offset_s, 3) } s ± { FIXED($half_width_s, 3) } s
    .hint = avec ce décalage, chaque point mesuré tombe dans un arrêt

pose-without-frame = { $count ->
        [one] { $count } pose
       *[other] { $count } poses
    } sans repère atelier, exclues : { $poses }
    .hint = les cibles du repère ont été rejetées ou n’ont pas été mesurées : voir import.json

join-contradicts = { $count ->
        [one] { $count } point mesuré a
       *[other] { $count } points mesurés ont
    } une autre valeur de { $column } que la ligne du journal `{ $log }` à laquelle ils sont joints : { $measured } et { $logged } (ligne { $line } du journal)
    .hint = joindre par pose ; ou supprimer `{ $column }` de `columns` du journal, si cette colonne y a une autre signification

row-counts-differ = `{ $file }` a { $rows } lignes, le journal `{ $log }` en a { $log_rows }
    .expected = le même nombre de lignes pour une jointure par ligne
    .hint = compléter le fichier auquel il manque des lignes ; ou indiquer pose et cycle dans les deux fichiers, et joindre par pose et cycle

approach-direction-unknown = le journal `{ $log }` ne montre pas le sens d’approche de l’articulation `{ $joint }`
    .hint = `backlash` l’exige : indiquer l’instant de chaque ligne (`time_s` dans `columns`, ou `period_s`), ou `{ $column }` dans `columns` : +1 par valeurs croissantes, -1 par valeurs décroissantes

backlash-direction-unknown = le journal `{ $log }` ne contient aucun mouvement d’une articulation à jeu avant les poses { $poses }, qui sont exclues
    .hint = commencer le journal avant la première pose, ou indiquer le sens d’approche

targets-out-of-plane = les hauteurs des cibles du robot plan vont de { FIXED($low_mm, 3) } mm à { FIXED($high_mm, 3) } mm dans le repère atelier
    .hint = vérifier z des exports (unité, signe, colonne) et les points qui définissent le plan du repère atelier

column-empty = la colonne `{ $column }` est vide ou manque
    .hint = ajouter la colonne, ou compléter la cellule

targets-missing = des cibles manquent { $count ->
        [one] à la pose { $poses }
       *[other] aux poses { $poses }
    }
    .hint = les autres cibles de ces poses sont utilisées ; une pose ou une orientation exige toutes les cibles

row-is-a-pose = `{ $file }` indique `pose = "row"` : chaque ligne est alors une pose à part ; supprimer cette ligne si plusieurs cibles ont été mesurées à une même pose

key-in-lines = { $key } (lignes { $lines })

remove-repeated-rows = supprimer les lignes doubles : leurs valeurs articulaires sont égales chiffre pour chiffre
remove-invalid-rows = supprimer les lignes non valables

log-key-twice = le journal `{ $log }` contient { $count ->
        [one] { $count } clé
       *[other] { $count } clés
    } plus d’une fois : { $keys }
    .hint = ajouter `cycle` à la clé, ou supprimer les lignes non valables

keys-unmatched = { $count ->
        [one] { $count } clé
       *[other] { $count } clés
    } { $of ->
        [log] du journal `{ $log }` sans point mesuré
       *[points] de points mesurés sans ligne du journal `{ $log }`
    } ({ $columns }) : { $keys } ; voir import.json
rigid-pairs-sampled = { $compared } des { $pairs } distances entre { $targets } cibles d’une pièce rigide sont comparées

point-pairs-many = { $pairs } paires de noms ont des points au même endroit ; les { $named } premières sont indiquées
    .hint = vérifier les étiquettes de l’export

pose-misspelt = la pose `{ $pose }` { $of ->
        [log] du journal `{ $log }` n’a pas été mesurée, et des poses mesurées ne sont pas dans le journal
       *[points] n’est pas dans le journal `{ $log }`, et des poses du journal n’ont pas été mesurées
    }

join-key-missing = la jointure exige `{ $key }`, absent de certaines lignes
    .hint = indiquer `{ $key }` dans `label` des exports et dans `columns` du journal, ou changer `by` dans [join]

join-by-label-targets = une jointure par étiquette suppose un robot à une seule cible ; celui-ci en a { $count }
    .hint = indiquer une cible, ou choisir une autre clé par `by` dans [join]

join-by-label-frame = une jointure par étiquette suppose un repère atelier unique pour toutes les poses
    .hint = définir le repère par des points qui ne bougent pas

label-not-measured = aucun point mesuré n’a l’étiquette `{ $label }`

points-untouched = { $count ->
        [one] { $count } point n’est touché
       *[other] { $count } points ne sont touchés
    } par aucune ligne du journal `{ $log }` ; le premier est `{ $label }`

log-times-not-increasing = les instants du journal `{ $log }` ne sont pas croissants à la ligne { $row }
    .hint = trier le journal par le temps, et supprimer les lignes de même instant

times-missing = { $of ->
        [log] le journal contient des lignes sans instant
        [export] l’export contient des lignes sans instant
       *[points] aucun point mesuré n’a d’instant
    }
    .hint = une jointure par le temps nécessite `time_s` dans les colonnes des exports et du journal

several-rows-near = { $count ->
        [one] { $count } point mesuré a
       *[other] { $count } points mesurés ont
    } plusieurs lignes du journal `{ $log }` à moins de { $tolerance_s } s : la ligne la plus proche est utilisée
    .hint = réduire `tolerance_s` à moins de la moitié de la période du journal

points-without-row = { $count ->
        [one] { $count } point mesuré n’a
       *[other] { $count } points mesurés n’ont
    } aucune ligne du journal `{ $log }` à moins de { $tolerance_s } s

rows-without-point = { $count ->
        [one] { $count } ligne
       *[other] { $count } lignes
    } du journal `{ $log }` sans point mesuré

target-time-twice = { $count } points de la cible `{ $target }` ont le même instant (lignes { $lines })
    .hint = corriger les instants, ou indiquer la cible de chaque point

log-row-met-twice = la ligne { $row } du journal `{ $log }` est la ligne la plus proche de { $count } points de la cible `{ $target }` (lignes { $lines })
    .hint = réduire `tolerance_s`, ou vérifier `clock_offset_s` ; de plusieurs mesures pendant un arrêt, donner la moyenne comme un seul point

clock-offset-none = aucun décalage des horloges ne place tous les points mesurés dans des arrêts du journal : { $count ->
        [one] le premier point (jusqu’à { $last_s } s) convient
       *[other] les { $count } premiers points (jusqu’à { $last_s } s) conviennent avec un même décalage
    }, le point à { $first_s } s ne convient pas
    .hint = supprimer les points mesurés en mouvement ; ou donner à `clock_offset_s` une valeur numérique : les lignes sans correspondance sont alors énumérées

range-of-seconds = { FIXED($low_s, 3) } à { FIXED($high_s, 3) } s

clock-offsets-several = les arrêts sont compatibles avec { $count } plages du décalage des horloges, les premières : { $ranges }
    .hint = comparer les horloges, et donner à `clock_offset_s` une valeur numérique

axis-of-world = "x", "y" ou "z"

observe-key-missing = le type `{ $kind }` exige `{ $column }`
    .hint = indiquer `{ $column }`

distance-not-positive = `distance_mm` manque ou n’est pas une longueur
    .expected = une longueur supérieure à 0

fixed-point-on-robot = `{ $name }` est une cible portée par le robot, et non un point fixe
    .hint = donner aux points fixes leurs propres noms ; les lignes qui ne concernent que des points fixes n’ont pas de pose

distance-to-itself = la distance va de `{ $name }` à lui-même
    .hint = corriger `other`

target-of-same-branch = `{ $target }` et `{ $name }` sont sur la même branche
    .hint = indiquer une cible d’une autre branche ; la disposition des cibles d’un même segment est indiquée dans [[rigid]]

bar-without-other-hand = `{ $name }` n’est pas une cible d’une autre branche que `{ $target }`
    .hint = indiquer une cible d’une autre branche ; `kind = "distance"` convient à une barre dont une extrémité est fixe

bar-length-at-pose = une barre a une seule longueur pour toutes les poses
    .hint = indiquer `distance_mm` dans une ligne sans pose ; des longueurs mesurées à chaque pose sont `kind = "distance"`

number-missing = `{ $column }` manque ou n’est pas un nombre
    .expected = { $column ->
            [offset_mm] la distance de la cible au plan, suivant l’axe indiqué, ou à la sphère, vers l’extérieur : rayon de la bille, ou 0
           *[value_deg] la valeur de l’articulation d’après l’interrupteur ou le second codeur
        }

row-without-pose = une ligne de type `{ $kind }` n’a pas de pose
    .hint = les lignes sans pose indiquent des positions (`point`) et des distances (`distance`) de points fixes, et des points sur un `plane`, une `line` ou une `sphere`

known-unsupported = [[known]] n’existe pas pour une ligne de type `{ $kind }`
    .expected = `point`, `distance`, `plane`, `line` ou `sphere`

near-without-surface = `near_mm` ne s’applique qu’à des positions sur des surfaces
    .hint = supprimer `near_mm`

kind-of-arms = les { $kind ->
        [joints] valeurs articulaires
       *[poses] poses
    } ne s’appliquent qu’aux bras tridimensionnels, et non à `{ $model }`
    .hint = observer des positions ou des distances de cibles

kind-unknown = `{ $name }` n’est pas un type d’observation

name-on-few-rows = `{ $name }` n’est indiqué que dans { $count ->
        [one] { $count } ligne
       *[other] { $count } lignes
    }, et `{ $meant }` dans { $meant_count }
    .hint = vouliez-vous dire `{ $meant }` ? sinon exclure les lignes de `{ $name }` : elles ne suffisent pas à le localiser

base-moves = les articulations { $joints } déplacent `base_link` : les positions sont considérées comme relatives à ce segment mobile
    .hint = si l’instrument est fixe dans l’atelier, prendre pour `base_link` la racine du fichier URDF

names-of-fixed-things = donner aux cibles, aux points et aux plans des noms différents

partial-coordinates = { $count ->
        [one] { $count } ligne donne
       *[other] { $count } lignes donnent
    } une ou deux coordonnées d’une cible : chaque coordonnée compte comme une observation distincte ({ $by ->
        [line] ligne
       *[pose] pose
    } { $rows }{ $more ->
        [0] {""}
        [one] {" "}et { $more } autre
       *[other] {" "}et { $more } autres
    })

rows-not-measured = { $count ->
        [one] { $count } ligne sans valeur articulaire ou sans coordonnées est omise
       *[other] { $count } lignes sans valeur articulaire ou sans coordonnées sont omises
    } ({ $by ->
        [line] ligne
       *[pose] pose
    } { $rows }{ $more ->
        [0] {""}
        [one] {" "}et { $more } autre
       *[other] {" "}et { $more } autres
    })

station-missing = la colonne `station` est vide ici, alors que d’autres points en indiquent une
    .hint = indiquer la station : les lignes sans station appartiennent à la station du repère atelier, qui doit observer le robot à au moins { $least } poses

coordinates-unknown = `{ $text }` ne désigne pas de coordonnées
    .expected = des lettres parmi x, y et z : "z", "xy"

place-missing = la position de `{ $point }` manque ou n’est pas un nombre
    .hint = compléter ses coordonnées, ou supprimer la ligne

joint-value-missing = une valeur articulaire manque ou n’est pas un nombre
    .hint = compléter ou supprimer la ligne

station-row-unsupported = { $fault ->
        [kind] une ligne de type `{ $kind }` indique la station `{ $station }`
        [coordinate] une coordonnée mesurée par la station `{ $station }` manque ou n’est pas un nombre
        [covariance] un point mesuré par la station `{ $station }` indique une covariance
       *[uncertainties] des coordonnées mesurées par la station `{ $station }` ont leurs propres incertitudes
    }
    .expected = des lignes de type `point` avec x_mm, y_mm, z_mm et une incertitude `u_mm`, pour les stations autres que la première
station-join-by-label = les points de la station `{ $station }` sont joints par étiquette
    .hint = les joindre par pose, ligne ou temps : un point touché se mesure dans le repère atelier

uncertainty-not-positive = `{ $column }` = { $value } n’est pas une incertitude-type
    .expected = un nombre positif

coordinates-of-rows-missing = { $axes } { $missing ->
        [one] manque
       *[other] manquent
    } : { $by ->
        [line] ligne
       *[pose] pose
    } { $rows }{ $more ->
        [0] {""}
        [one] {" "}et { $more } autre
       *[other] {" "}et { $more } autres
    }
    .hint = compléter la ligne ou l’omettre ; si seules les autres coordonnées ont été mesurées, indiquer leur incertitude-type : une colonne `u_mm`, `expanded_uncertainty_um` dans [instrument], ou --standard-uncertainty-um pour `etalon identify` et `etalon verify`

uncertainty-missing = { $count ->
        [one] une ligne n’a pas
       *[other] { $count } lignes n’ont pas
    } d’incertitude-type de { $column ->
        [urot_deg] rotation
       *[u_mm] longueur
    } : { $by ->
        [line] ligne
       *[pose] pose
    } { $rows }{ $more ->
        [0] {""}
        [one] {" "}et { $more } autre
       *[other] {" "}et { $more } autres
    }
    .hint = { $column ->
            [urot_deg] indiquer `expanded_rotation_uncertainty_deg` dans [instrument], ou une colonne `urot_deg` ; pour `etalon identify` et `etalon verify` --rotation-uncertainty-deg
           *[u_mm] indiquer `expanded_uncertainty_um` dans [instrument], ou une colonne `u_mm` ; pour `etalon identify` et `etalon verify` --standard-uncertainty-um
        }

surface-axis-missing = { $kind ->
        [line] la droite `{ $name }` exige l’axe du repère atelier le plus proche de sa direction
       *[plane] le plan `{ $name }` exige l’axe du repère atelier le plus proche de sa normale
    }
    .expected = x, y ou z dans la colonne `axis`{ $kind ->
            [line] {""}
           *[plane] {""} : z pour une table, x ou y pour un mur
        }

offset-of-line = `offset_mm` ne s’applique qu’aux plans et aux sphères, et non à une droite
    .hint = laisser la cellule vide

near-missing = un point sur un élément de type { $kind } exige `near_mm`
    .hint = indiquer sa position approximative dans le repère atelier

load-direction-unknown = `{ $direction }` n’est pas une direction
    .expected = +x, -x, +y, -y, +z ou -z

load-direction-unmeasured = la direction `{ $direction }` exige `z_mm` : le déplacement dans cette direction n’a pas été mesuré
    .hint = ajouter la colonne `z_mm`, ou supprimer la ligne

force-not-a-number = `{ $text }` n’est pas une force
    .expected = une force en newtons, positive ou nulle : la direction donne le signe

drift-without-commanded = `drift_set` nécessite des poses commandées
    .hint = les indiquer : `commanded = "commanded.csv"`

attained-poses-twice = [poses] et [repeatability] indiquent toutes deux des poses atteintes
    .hint = garder [repeatability] pour des points étiquetés, ou [poses] pour un tableau

limit-without-value = la limite `{ $limit }` ne peut pas être jugée : elle n’a pas de valeur à la pose { $pose }
    .hint = atteindre chaque pose au moins deux fois, et indiquer sa position commandée

compensation-scatters = la dispersion des positions atteintes autour de la moyenne de leur pose est de { LENGTH($after_mm) } après correction par les cibles de référence, de { LENGTH($before_mm) } avant
    .hint = chercher une lecture erronée parmi les cibles de référence, ou les omettre

reference-targets-misshapen = les cibles de référence du cycle { $cycle } s’écartent de { LENGTH($rms_mm) } (moyenne quadratique) d’un déplacement rigide depuis le premier cycle ; incertitude élargie { LENGTH($expanded_mm) }
    .hint = une cible a bougé ou a été mal mesurée : mesurer de nouveau les cibles, ou exclure la cible erronée

repeatability-frame = [repeatability] exige un repère atelier mesuré une seule fois
    .hint = définir le repère par des points qui ne bougent pas

commanded-angle-unmeasured = `{ $column }` est commandé, mais les points étiquetés ne donnent que des positions
    .hint = supprimer la colonne, ou donner les poses atteintes avec leurs angles en tableau : [poses]

commanded-pose-missing = aucune position commandée pour ces poses : { $poses }
    .hint = ajouter une ligne pour chaque pose mesurée de la trajectoire

commanded-pose-unmeasured = la pose { $pose } est commandée, mais rien n’y a été mesuré

trajectory-empty = la trajectoire n’a pas de pose
    .hint = indiquer les poses d’un cycle dans leur ordre, par exemple [1, 2, 1, 3]

coplanar-not-four = `coplanar` doit indiquer quatre poses différentes de la trajectoire
    .expected = quatre poses de la trajectoire, une fois chacune

pose-not-in-trajectory = la pose { $pose } (cycle { $cycle }) n’est pas dans la trajectoire
    .hint = corriger l’étiquette, ou ajouter la pose à `trajectory`

pose-of-several-targets = la pose { $pose } (cycle { $cycle }) a des positionnements de `{ $target }` et d’une autre cible
    .hint = indiquer dans `label` la seule cible de l’essai

pose-of-cycle = pose { $pose } du cycle { $cycle }

visit-count-differs = la pose { $pose } a été mesurée { $found } fois dans le cycle { $cycle }, alors que la trajectoire y passe { $count } fois
    .hint = ajouter le positionnement manquant, ou supprimer tous les positionnements de cette pose et de ce cycle : leurs poses précédentes sont inconnues

visits-missing = non mesurées : { $poses }{ $count ->
        [one] {""}
       *[other] {""} ; { $count } en tout
    }

homing-instrument-too-coarse = l’incertitude de mesure dépasse 25 % de la répétabilité de la prise d’origine, { LENGTH($rp_mm) }
    .hint = utiliser la valeur comme majorant, ou mesurer avec un meilleur instrument

central-part-too-large = la valeur de { $option } dépasse 100 %
    .expected = un nombre supérieur à 0 et au plus 100

path-points-out-of-range = la valeur de { $option } est hors plage
    .expected = 2 à 100000

path-not-stated = { $option } exige { $path }
    .hint = indiquer le fichier de la trajectoire commandée

weave-incomplete = il manque { $option } pour le balayage
    .hint = indiquer course, fréquence et direction

weave-direction-count = { $option } doit avoir trois nombres
    .expected = x, y et z de la direction d’oscillation

stream-twice = l’enregistrement `{ $stream }` apparaît deux fois
    .hint = donner à chaque enregistrement son propre nom

in-observation = pose { $pose }, cycle { $cycle } des observations : { $message }

in-candidate = pose { $pose } des candidates : { $message }

in-feature = élément `{ $name }` : { $message }

joints-of-pose-differ = les lignes d’une même pose et d’un même cycle ont des valeurs articulaires différentes
    .hint = les corriger, ou numéroter les répétitions dans la colonne `cycle`

target-repeated = la cible `{ $target }` apparaît deux fois
    .hint = numéroter les répétitions dans la colonne `cycle`

arms-apart = avec les paramètres nominaux, les bras ne se rejoignent pas à ces valeurs articulaires
    .hint = vérifier l’unité, le signe et le décalage des articulations, et les paramètres nominaux

assembly-mode-missing = le mode d’assemblage n’est pas indiqué
    .expected = 1 ou -1 dans la colonne `assembly`
    .hint = les poses candidates peuvent aussi être des positions : `pose,x_mm,y_mm` sans valeurs articulaires donne tous les modes de travail

assembly-mode-ambiguous = les deux modes d’assemblage conviennent aussi bien l’un que l’autre : à { FIXED($near_mm, 2) } mm et à { FIXED($far_mm, 2) } mm de la position mesurée
    .hint = indiquer une colonne `assembly` avec 1 ou -1 ; ou indiquer la position de la base (x_o, y_o, phi) sous [nominal]

assembly-modes-assumed = le mode d’assemblage de { $count } observations a été déduit de la mesure ({ $positive } en mode +1, { $negative } en mode -1) ; le cas le moins net est la pose { $pose } : { FIXED($near_mm, 1) } mm et { FIXED($far_mm, 1) } mm
    .hint = indiquer une colonne `assembly` avec 1 ou -1 si le journal la contient

uncertainties-twice = le tableau indique à la fois des incertitudes-types et des covariances de coordonnées
    .hint = supprimer `ux_mm`, `uy_mm`, `uz_mm`

coordinate-uncertainty-missing = la ligne indique une incertitude, mais `{ $column }` est vide
    .expected = de 0,00002 mm à 100 mm pour chaque coordonnée, ou toutes les cellules vides

coordinate-uncertainty-unusable = `{ $column }` = { $value } ne peut pas être l’incertitude d’une coordonnée
    .expected = de 0,00002 mm à 100 mm pour chaque coordonnée, ou toutes les cellules vides

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
    } aux seules poses de validation : { $names } ; localisation d’après ces lectures, les paramètres identifiés du robot étant fixés

validation-leaves-nothing = { $unplaced } : il ne reste aucune lecture redondante pour la validation
    .hint = les mesurer aussi à des poses d’étalonnage, ou déplacer vers `calibration` une pose où elles sont mesurées

placed-by-validation = { $unplaced } ; les statistiques tiennent compte de cette localisation
    .hint = les mesurer aussi à des poses d’étalonnage, ou déplacer vers `calibration` une pose où elles sont mesurées

placed-by-validation-unjudged = { $unplaced } ; les lectures sans redondance ne sont pas jugées : { $names }
    .hint = les mesurer aussi à des poses d’étalonnage, ou déplacer vers `calibration` une pose où elles sont mesurées

candidate-positions-unreachable = le modèle `{ $model }` n’atteint aucune position candidate, ou n’a pas de modèle géométrique inverse
    .hint = indiquer des valeurs articulaires, une colonne par articulation avec son unité

check-readings = chercher dans ces lectures des étiquettes interverties et des erreurs ; les mesurer de nouveau, ou les exclure par `exclude` dans [identify]

coordinates-wrong = { $count ->
        [one] { $count } coordonnée ne concorde
       *[other] { $count } coordonnées ne concordent
    } avec les autres lectures qu’avec un autre signe décimal ou un autre signe : { $coordinates }
    .hint = vérifier le signe décimal et le signe de ces coordonnées dans l’export

decimal-mark-wrong = ligne { $row } : { $axis } de { $target } vaut { FIXED($value_mm, 3) } mm ; la plupart des autres lignes se trouvent entre { FIXED($least_mm, 0) } et { FIXED($most_mm, 0) } mm, comme { FIXED($agrees_mm, 3) } mm
    .hint = vérifier le signe décimal de cette ligne

settle-readings = éclaircir d’abord les lectures { $number ->
        [one] de la pose
       *[other] des poses
    } { $poses } : les corriger, les mesurer de nouveau ou les exclure par `exclude` dans [identify]

readings-decide = { $count ->
        [one] une lecture (pose { $poses }) contredit les autres et détermine le résultat : sans elle
       *[other] { $count } lectures (poses { $poses }) contredisent les autres et déterminent le résultat : sans elles
    }, `{ $parameter }` change de { FIXED($times, 1) } incertitudes-types

robust-fit-disagrees = un ajustement robuste modifie `{ $parameter }` de { FIXED($over_u, 1) } incertitudes-types de la différence (limite { FIXED($limit, 1) }) ; aucune pose ne contredit toutes les autres : les résidus ne suivent pas une loi normale
    .hint = le robot a des erreurs que le modèle ne décrit pas, ou l’incertitude indiquée est trop petite

robust-fit-disagrees-at-poses = un ajustement robuste modifie `{ $parameter }` de { FIXED($over_u, 1) } incertitudes-types de la différence (limite { FIXED($limit, 1) }) ; poses qui contredisent les autres : { $poses }

target-positions = `{ $target }` ({ $count ->
        [one] { $count } position
       *[other] { $count } positions
    })

coordinates-commanded = le robot nominal reproduit les coordonnées de { $targets } à partir des valeurs articulaires à { SCIENTIFIC($largest_mm, 2) } mm près, soit l’arrondi du fichier : elles sont commandées, et non mesurées
    .hint = indiquer les coordonnées mesurées dans `columns` ; si les données sont simulées, indiquer `synthetic` dans la campagne

frame-points-mirrored = les points du repère atelier sont à { FIXED($off_mm, 3) } mm de leurs positions nominales, mais correspondent à leur image miroir à { FIXED($limit_mm, 3) } mm près
    .hint = deux axes de l’export sont intervertis, ou l’un d’eux a le signe opposé : vérifier les colonnes

frame-point-off = `{ $point }` est à { FIXED($off_mm, 3) } mm de sa position nominale par rapport aux autres points (tolérance { $tolerance_mm } mm, U = { FIXED($expanded_mm, 4) } mm)
    .hint = vérifier le point, son étiquette et `nominal_mm`, ou indiquer la tolérance du dessin technique

frame-points-off = distance de `{ $first }` à `{ $second }` : mesurée { FIXED($measured_mm, 3) } mm, nominale { FIXED($nominal_mm, 3) } mm (tolérance { $tolerance_mm } mm, U = { FIXED($expanded_mm, 4) } mm)
    .hint = vérifier le point, son étiquette et `nominal_mm`, ou indiquer la tolérance du dessin technique

nominal-point-unmeasured = `nominal_mm` mentionne `{ $point }`, qui n’a pas été mesuré

nominal-few-points = `nominal_mm` exige au moins trois points
    .hint = ajouter des points du repère, ou supprimer `nominal_mm`

world-axes-exchanged = la base est à { FIXED($off_mm, 0) } mm et { FIXED($off_deg, 1) } deg de la position indiquée dans robot.toml : x, y, z de robot.toml sont { $axes } du repère atelier
    .hint = vérifier les axes, l’unité et les points du repère atelier, et [nominal] de robot.toml

base-off-nominal = la base est à { FIXED($off_mm, 0) } mm et { FIXED($off_deg, 1) } deg de la position indiquée dans robot.toml ; limite { $limit_mm } mm, { FIXED($limit_deg, 1) } deg
    .hint = vérifier les axes, l’unité et les points du repère atelier, et [nominal] de robot.toml

orientation-slip = { $slip ->
        [scalar-last] le scalaire des quaternions en dernier
        [scalar-first] le scalaire des quaternions en premier
        [scalar-last-inverse] le scalaire des quaternions en dernier, et les rotations inverses
        [order] les angles dans l’ordre `{ $name }`
        [vectors] des vecteurs de rotation au lieu d’angles
        [order-of-vectors] des angles dans l’ordre `{ $name }` au lieu de vecteurs de rotation
        [radians] les angles en radians au lieu de degrés
        [degrees] les angles en degrés au lieu de radians
        [negated] les angles avec le signe opposé
        [inverse] les rotations inverses
       *[left-handed] un repère indirect ({ $name } inversé)
    }

orientations-off = les orientations observées diffèrent de celles du robot { $robot ->
        [nominal] nominal
       *[identified] identifié
    } de { FIXED($median_deg, 1) } deg (médiane)
    .hint = vérifier que qw, qx, qy, qz (scalaire en premier) transforment les vecteurs du corps vers le repère atelier ; ou vérifier l’ordre des angles : sans `orientation`, les ordres qui conviennent sont indiqués

few-poses-to-leave-out = { $count ->
        [one] { $count } pose d’étalonnage est insuffisante
       *[other] { $count } poses d’étalonnage sont insuffisantes
    } pour en omettre quelques-unes
    .expected = au moins { $least }
    .hint = mesurer plus de poses, ou en sélectionner plus dans `calibration`

nothing-to-judge = aucune observation n’est une position, une distance ou un contact
    .hint = les paramètres sont jugés d’après des erreurs de position : mesurer des positions, des distances ou des contacts

validation-repeats-calibration = la validation répète l’étalonnage : la distance médiane d’une pose de validation à la pose d’étalonnage la plus proche vaut { FIXED($median, 2) } fois l’espacement des poses d’étalonnage ; limite { $limit }
    .hint = ailleurs, l’erreur du robot peut être plus grande : valider à des poses situées entre les poses d’étalonnage

validation-far = la validation est loin de l’étalonnage : la distance médiane d’une pose de validation à la pose d’étalonnage la plus proche vaut { FIXED($median, 2) } fois l’espacement des poses d’étalonnage ; limite { $limit }
    .hint = étalonner à des poses réparties dans tout l’espace de travail utilisé

error-quantity-unknown = `{ $name }` n’est pas une grandeur d’erreur
    .hint = relancer la campagne : `etalon run CAMPAGNE`

pose-set-unknown = `{ $name }` n’est pas un ensemble de poses
    .expected = calibration ou validation

joints-do-not-move = les articulations ne bougent pas : les { $rows } observations sont { $motion } ; elles ne déterminent aucun paramètre du robot{ $points ->
        [0] {""}
       *[other] {" "}(dispersion des points mesurés : { FIXED($scatter_mm, 3) } mm)
    }
    .hint = mesurer des poses où chaque articulation prend plusieurs valeurs ; si le robot a bougé, les valeurs articulaires sont lues dans de mauvaises colonnes ou dans un fichier périmé

motion-none = à une seule pose

motion-within-angle = à moins de { FIXED($range_deg, 3) } deg l’une de l’autre pour chaque articulation

motion-within-length = à moins de { FIXED($range_mm, 3) } mm l’une de l’autre pour chaque articulation

motion-within-both = à moins de { FIXED($range_deg, 3) } deg et de { FIXED($range_mm, 3) } mm l’une de l’autre pour chaque articulation

joint-does-not-move = `{ $joint }` ne bouge pas : faute de données, { $count ->
        [one] { $count } paramètre reste connu à sa tolérance près
       *[other] { $count } paramètres restent connus à leur tolérance près
    } : { $parameters }
    .hint = déplacer `{ $joint }` entre les poses d’étalonnage, ou n’utiliser le robot qu’à cette valeur ; sinon des erreurs allant jusqu’à la tolérance de `{ $first }` subsistent

direction-undetermined = sa direction a une incertitude-type de { FIXED($direction_deg, 0) } deg ; limite { $limit_deg } deg
    .hint = mesurer des points plus éloignés les uns des autres, et non alignés

direction-uncertain = sa direction a une incertitude-type de { FIXED($direction_deg, 2) } deg ; limite { $limit_deg } deg
    .hint = mesurer des points plus éloignés les uns des autres

world-side-undetermined = `towards` est sur l’axe : il ne détermine pas de quel côté va l’autre axe
    .hint = indiquer un point hors de l’axe

frame-few-targets = le repère atelier a { $count ->
        [one] { $count } cible
       *[other] { $count } cibles
    }
    .expected = au moins trois cibles

frame-never-complete = aucune pose n’a toutes les cibles { $targets } du repère atelier à des positions distinctes
    .hint = mesurer toutes ces cibles, et vérifier leurs étiquettes

orientations-twice = le tableau donne deux fois l’orientation : { $first } et { $second }
    .hint = supprimer l’une des deux

orientation-columns-missing = il manque { $missing } à l’orientation
    .expected = { $columns } : orientation du corps dans le repère atelier

orientation-missing = l’orientation manque ou n’est pas un nombre
    .expected = qw, qx, qy, qz : orientation du corps dans le repère atelier ; ou un vecteur de rotation, ou trois angles

angle-order-missing = l’ordre des angles n’est pas indiqué
    .hint = indiquer `orientation = "zyx"` dans [observations], ou --orientation

angle-orders-unfit = aucun ordre des angles ne correspond au robot nominal : le plus petit résidu est de { FIXED($left_deg, 1) } deg (moyenne quadratique) avec `{ $order }` ; vérifier que les angles décrivent la rotation du corps vers le repère atelier, et vérifier les valeurs articulaires

angle-order-leaves = { FIXED($left_deg, 3) } deg avec `{ $order }`

angle-orders-fit = indiquer `orientation = "{ $order }"` dans [observations], ou --orientation ; résidus avec le robot nominal (moyenne quadratique) : { $orders }

ball-missing = la bille `{ $target }` manque (pose { $pose }, cycle { $cycle })
    .hint = mesurer la bille, ou supprimer les autres lectures de cette pose et de ce cycle

actuator-unknown = l’actionneur { $actuator } n’existe pas
    .expected = 1, 2 ou 3

lead-position-unknown = la position { $position } de l’actionneur { $actuator } n’est pas dans `positions_mm`
    .hint = corriger l’étiquette, ou compléter `positions_mm`

geometric-frame = l’étalonnage géométrique exige un repère atelier défini par les rails et la bille R
    .expected = `plane`, `origin`, `y_axis = [origine, autre extrémité]` et `towards`, comme au 3.4.1 de la thèse

geometric-other-robot = [geometric] n’est disponible que pour un PreXYT
    .expected = un robot de modèle `prexyt`

scale-bar-error = barre étalon `{ $name }` : l’erreur de { FIXED($error_mm, 4) } mm dépasse l’erreur maximale tolérée de { FIXED($limit_mm, 4) } mm
    .hint = vérifier palpeur, température et fixation de l’instrument, et mesurer la barre de nouveau

scale-bar-deviates = barre étalon `{ $name }` : une distance s’écarte de { FIXED($error_mm, 4) } mm de la longueur indiquée ; sont tolérés { FIXED($limit_mm, 4) } mm et U = { FIXED($u_mm, 4) } mm de la longueur
    .hint = indiquer la longueur et l’incertitude du certificat de la barre, vérifier palpeur et température, et mesurer la barre de nouveau

scale-bar-uncertain = barre étalon `{ $name }` : l’erreur maximale tolérée vaut { FIXED($ratio, 1) } fois l’incertitude élargie du certificat de la barre ; au moins { $least } fois sont exigées
    .hint = utiliser une barre dont le certificat a une plus petite incertitude : cette barre ne permet pas de vérifier l’instrument

step-scatters = { $step } : la dispersion des résidus est de { FIXED($found_mm, 4) } mm, celle de l’instrument de { FIXED($stated_mm, 4) } mm ; les incertitudes sont calculées à partir des résidus
    .hint = chercher un jeu, une bille sale ou un support desserré ; mesurer l’étape de nouveau

table-without-poses = à aucune pose du tableau `{ $title }`, K et L n’ont été mesurées ensemble
    .hint = mesurer les deux billes dans le même cycle, ou choisir d’autres poses

given-without-covariance = les paramètres n’ont pas de covariance
    .hint = identifier de nouveau à partir de plus de données : l’identification n’avait aucun degré de liberté

calibrated-targets-missing = il manque { $names } aux paramètres : les observations ont une autre base ou d’autres cibles
    .hint = observer les cibles de l’étalonnage, aux mêmes positions sur la partie mobile

parameters-of-other-robot = les paramètres sont ceux d’un robot `{ $identified }` ; robot.toml décrit un autre robot (`{ $stated }`)
    .hint = indiquer le robot.toml avec lequel les paramètres ont été identifiés

parameters-lacking = il manque { $names } aux paramètres ; indiquer le robot.toml avec lequel les paramètres ont été identifiés

parameters-undescribed = les paramètres contiennent { $names }, que robot.toml ne décrit pas
    .hint = indiquer le robot.toml avec lequel les paramètres ont été identifiés

add-lines = ajouter { $lines } à robot.toml, avant sa première table

nominal-value-changed = `{ $parameter }` a pour valeur nominale { $stated }{ $unit ->
        [mm] {" "}mm
        [deg] {" "}deg
       *[other] {""}
    } dans robot.toml, et avait { $identified }{ $unit ->
        [mm] {" "}mm
        [deg] {" "}deg
       *[other] {""}
    } lors de l’identification
    .hint = vérifier si les paramètres sont ceux de ce robot

robot-geometry-changed = robot.toml décrit une autre géométrie que celle de l’identification : { $case ->
        [apart] à paramètres égaux, les brides sont à { $distance_mm } mm l’une de l’autre
       *[other] les articulations ou les segments diffèrent
    }
    .hint = indiquer le robot.toml avec lequel les paramètres ont été identifiés, ou identifier de nouveau

robot-geometry-unknown = robot.toml n’est pas un fichier de l’identification, et parameters.json ne contient pas de géométrie à lui comparer
    .hint = vérifier si robot.toml décrit le robot identifié, ou relancer la campagne

calibration-without-residuals = l’étalonnage ne détermine pas l’incertitude-type d’une coordonnée
    .hint = identifier en indiquant l’incertitude-type

effect-would-prove = effet significatif : { $effect }{ $count ->
        [0] {""}
       *[other] {" "}des articulations { $joints }
    } ; avec cet effet, l’erreur aux poses d’étalonnage omises passe de { FIXED($without_mm, 3) } à { FIXED($with_mm, 3) } mm (position, moyenne quadratique)
    .hint = ajouter "{ $effect }" à `effects` dans [identify]

outliers-too-many = `outliers = "exclude"` exclurait plus de { $share_percent } % des lectures
    .hint = le modèle ou le montage est incorrect : vérifier les lectures que signale `outliers = "keep"`

log-correlates = avec le journal `{ $log }`, les résidus sont corrélés à la différence des deux journaux (r = { FIXED($correlation, 2) }) ; leur moyenne quadratique est de { FIXED($rms_mm, 3) } mm, contre { FIXED($other_rms_mm, 3) } mm avec le journal `{ $other }`

use-log = { $hint ->
        [name-first] identifier avec le journal `{ $log }` : l’indiquer en premier
       *[is-used] le journal `{ $log }` est le meilleur, et cette campagne l’utilise
    }

selected-pose-unmeasured = `{ $pose }` ne désigne aucune pose mesurée

selection-without-pose = `{ $set }` ne désigne aucune pose mesurée

sets-overlap = ces poses servent à la fois à l’étalonnage et à la validation : { $poses }
    .hint = `validation = "rest"` prend toutes les poses qui ne servent pas à l’étalonnage

series-overlap = ces poses appartiennent à plusieurs séries : { $poses }
    .hint = mettre chaque pose dans une seule série

series-without-calibration = séries sans pose d’étalonnage, qui ne comptent pas : { $series }

series-incomplete = ces poses d’étalonnage n’appartiennent à aucune série : { $poses }
    .hint = `"rest"` prend toutes les poses qui n’appartiennent à aucune série précédente

series-single = `series` ne contient qu’une série avec des poses d’étalonnage
    .hint = en indiquer au moins deux, ou supprimer `series`

table-selection-empty = le tableau `{ $title }` ne contient aucune pose mesurée
    .hint = un tableau montre des poses de `calibration` et `validation`

poses-measured = { $count ->
        [one] { $count } pose est mesurée et jointe au journal
       *[other] { $count } poses sont mesurées et jointes au journal
    }, de { $first } à { $last }

poses-unmeasured = aucune pose n’est mesurée et jointe au journal

at-pose = pose { $pose } : { $message }

values-of-column = { $message } ({ $count } valeurs sur { $total } sont dans ce cas)

check-column-unit = vérifier l’unité de sa colonne : toutes les valeurs seraient dans la plage en { $units ->
        [degrees] degrés au lieu de radians
       *[millimetres] millimètres au lieu de mètres
    }

joint-out-of-range = articulation `{ $joint }` = { $value } { $unit } : hors plage
    .expected = de { $lower } à { $upper } { $unit } : { $reason ->
            [limits] les limites du fichier de robot, avec un dépassement admis de 1 % de leur écart
            [turns] deux tours, car le fichier de robot n’indique pas de limites
           *[others] plage des autres valeurs
        }
    .hint = vérifier le séparateur décimal et l’unité de la valeur ; si l’articulation peut l’atteindre, { $reason ->
            [limits] corriger ses limites dans le fichier de robot
           *[others] indiquer ses limites dans le fichier de robot
        }

common-errors-of-conditions = les tirages ne couvrent les erreurs communes à toutes les lectures (échelle, température, prise d’origine) que pour des positions de cibles
    .hint = `etalon run` indique les incertitudes de cette campagne par propagation linéaire

probe-of-feature-unknown = `{ $feature }` n’est pas ajusté : ses points sont des centres du palpeur, et le fichier n’indique pas { $missing ->
        [side] de quel côté était le palpeur
       *[radius] le rayon du palpeur
    }
    .hint = { $missing ->
            [side] l’indiquer : --probe-side inside, outside ou x,y,z
           *[radius] l’indiquer : --probe-radius-mm
        }

unstable-parameter = `{ $parameter }` ({ FIXED($over_sd, 1) }, limite { FIXED($limit, 1) })

parameters-unstable = paramètres instables ; différences entre une partie des poses et toutes les poses, en écarts-types de la différence : { $parameters }
    .hint = chercher ce qui a changé pendant la mesure (température, cible déplacée, nouvelle prise d’origine), et vérifier les résidus

remedy = { $remedy ->
        [pose-uncertainty] l’indiquer (--standard-uncertainty-um), ou comparer des cibles
        [contact-uncertainty] indiquer aussi la répétabilité du contact (--standard-uncertainty-um), et comparer des cibles
        [compare-targets] utiliser `residuals = "targets"`
        [targets] donner les positions de ses cibles : des lignes de type `point`
        [uncertainty] l’indiquer (--standard-uncertainty-um)
        [own-uncertainties] comparer des cibles, ou supprimer les colonnes d’incertitudes
        [row-uncertainty] l’indiquer à chaque ligne, ou par --standard-uncertainty-um
        [part] `frame` est `flange` pour un bras, `platform` pour un PreXYT, `targets` pour tout robot
        [positions] choisir plus de positions, ou fixer des paramètres par `--hold`
        [hold-fewer] fixer moins de paramètres, et mesurer plus de poses
        [more-poses] mesurer plus de poses (répéter une pose n’ajoute rien), ou fixer des paramètres par `hold` dans [identify] ou --hold
        [hold] fixer des paramètres dans [identify], ou mesurer plus de poses
        [unreachable] vérifier l’unité (degrés ou radians), le signe et le décalage des articulations, et les paramètres nominaux
        [extent] vérifier `unit` des exports, les unités des articulations dans le journal, et les longueurs du robot
        [readings] vérifier ces lectures et l’ordre des lignes du journal, ou omettre ces poses (`exclude`, --exclude)
        [assembly] corriger la colonne `assembly` de ces poses, ou la laisser vide : le mode est alors déduit de la mesure
       *[joints] vérifier les unités, l’ordre et les signes des articulations, et les paramètres nominaux ; `hold` dans [identify] fixe des paramètres
    }

reading-off = { FIXED($off_mm, 4) } mm ({ $target }, pose { $pose }, cycle { $cycle })
orientation-off = { FIXED($off_deg, 3) } deg en orientation ({ $target }, pose { $pose }, cycle { $cycle })
quantity-off = { FIXED($off_mm, 4) } mm en { $quantity } ({ $target }, pose { $pose }, cycle { $cycle })
deviation-of-lengths = { FIXED($deviation_mm, 4) } mm ({ $quantity })
deviation-of-angles = { FIXED($deviation_deg, 3) } deg (orientation)

largest-residuals = plus grands résidus d’un ajustement robuste : { $readings }
    .hint = chercher d’abord dans ces lectures des étiquettes interverties et des erreurs ; les erreurs du robot affectent toutes les poses

outlier-readings = { $count ->
        [one] { $count } lecture sur { $total } est aberrante
       *[other] { $count } lectures sur { $total } sont aberrantes
    } : résidu supérieur à { $times } fois { $scales }, écart-type des autres dans un ajustement robuste : { $readings }

outliers = { $outliers }

outliers-excluded = lectures exclues par `outliers = "exclude"` : { $outliers }

repeated-position = { $target } aux poses { $first } et { $second }

positions-repeat = des positions mesurées sont identiques jusqu’au dernier chiffre alors que les articulations bougent, { $count } fois : { $pairs }
    .hint = l’export contient une lecture d’une autre pose : mesurer ces poses de nouveau, ou les exclure

repeated-joints = poses { $first } et { $second }, distantes de { FIXED($apart_mm, 3) } mm

joint-values-repeat = des valeurs articulaires sont identiques jusqu’au dernier chiffre alors que les cibles bougent, { $count } fois : { $pairs }
    .hint = le journal contient les valeurs articulaires d’une autre pose : enregistrer ces poses de nouveau, ou les exclure

repeats-scatter = les répétitions de `{ $label }` s’écartent jusqu’à { FIXED($off_mm, 4) } mm de leur médiane ; incertitude-type de l’instrument { FIXED($u_mm, 4) } mm
    .hint = vérifier `unit` de l’export et l’incertitude de l’instrument, et que le point n’a pas bougé

repeat-off = { $away } sur { $count } répétitions de `{ $label }` { $away ->
        [one] s’écarte de
       *[other] s’écartent jusqu’à
    } { FIXED($off_mm, 4) } mm de leur médiane ; incertitude-type de l’instrument { FIXED($u_mm, 4) } mm
    .hint = supprimer la lecture erronée de l’export, ou mesurer le point de nouveau : tous les résultats en dépendent

uncertainty-zero-rounded = `{ $column }` est 0 dans { $count ->
        [one] { $count } ligne
       *[other] { $count } lignes
    } : valeur arrondie, remplacée par la résolution de la colonne, u = { $u } { $unit } (moitié du dernier chiffre divisée par √3)
    .hint = exporter les incertitudes avec plus de décimales

uncertainty-zero = `{ $column }` est 0 dans { $count ->
        [one] { $count } ligne
       *[other] { $count } lignes
    }, et la résolution de la colonne est inconnue : l’incertitude de l’instrument est utilisée à la place
    .hint = exporter les incertitudes avec plus de décimales

key-of-text-table = `{ $key }` est sans objet pour une feuille de classeur ou un topic d’un enregistrement
    .hint = supprimer `{ $key }` : la clé ne vaut que pour un texte délimité

measurements-undescribed = aux poses { $set ->
        [validation] de validation
       *[calibration] d’étalonnage
    }, les erreurs sont de { FIXED($after_mm, 3) } mm (moyenne quadratique) pour des positions étalées sur { FIXED($spread_mm, 1) } mm ; { $count } erreurs sur { $total } dépassent { FIXED($limit_mm, 1) } mm : le modèle ne décrit pas ces mesures

undescribed-targets = chaque lecture de { $targets } a une grande erreur, et aucune autre lecture n’en a : vérifier les étiquettes, et si la cible a bougé

undescribed-rows-shifted = de la pose { $first } à la pose { $last }, les positions correspondent aux valeurs articulaires de la pose { $neighbour ->
        [previous] précédente
       *[next] suivante
    } : vérifier si le journal y a une ligne de trop ou en moins

undescribed-readings = { $readings } : { $remedy }

undescribed-set-up = vérifier les unités, l’ordre et les signes des articulations, les paramètres nominaux, et la jointure du journal et des points

undescribed-frame-moved = un seul déplacement du repère, de { FIXED($motion_mm, 1) } mm, ramène les erreurs à { FIXED($left_mm, 3) } mm : la base ou le système de mesure a bougé entre les poses d’étalonnage et de validation

undescribed-unchecked = les poses d’étalonnage n’ont aucune coordonnée redondante : d’autres positions de la base et des cibles conviennent aussi bien ; mesurer plus de poses d’étalonnage, réparties dans l’espace de travail

undescribed-other-poses = le modèle convient aux poses d’étalonnage, et aucun déplacement du repère n’explique les autres : vérifier que le journal et les exports des poses de validation vont ensemble (et non le journal d’une autre campagne, ou une autre numérotation des poses)

prior-of-nominal = les paramètres nominaux n’ont pas de covariance pour `--frames prior`
    .hint = indiquer des paramètres identifiés par `--parameters`, ou utiliser `--frames refit`

prior-of-conditions = `--frames prior` ne s’applique qu’à des positions mesurées
    .hint = supprimer les lignes d’autres types, ou réajuster base et cibles : `--frames refit`

place-without-nominal = `{ $parameter }` n’a pas de valeur nominale : seules les mesures le déterminent
    .hint = ajuster base et cibles aux poses d’étalonnage : `--frames refit`

given-parameters-worse = les erreurs sont de { FIXED($given_mm, 3) } mm avec les paramètres donnés, de { FIXED($nominal_mm, 3) } mm avec les paramètres nominaux (moyenne quadratique)
    .hint = vérifier si les paramètres sont ceux de ce robot, et si base et cibles sont celles de cette campagne (`--frames`)

candidate-poses-too-few = impossible de choisir { $wanted } poses parmi { $count } candidates
    .hint = indiquer moins de `--positions`, ou plus de poses candidates

target-names-exchanged = si l’on intervertit les noms des cibles `{ $first }` et `{ $second }`, les résidus passent de { FIXED($before_mm, 3) } à { FIXED($left_mm, 3) } mm
    .hint = intervertir les deux noms dans l’export

one-pose-contradicts = sans la pose `{ $pose }`, les observations ne contredisent pas les paramètres
    .hint = mesurer cette pose de nouveau, et enregistrer de nouveau ses valeurs articulaires

one-reading-contradicts = sans la cible `{ $target }` à la pose `{ $pose }`, les observations ne contredisent pas les paramètres
    .hint = mesurer cette cible de nouveau à cette pose

target-names-permuted = avec les noms de cibles { $names }, les résidus passent de { FIXED($before_mm, 3) } à { FIXED($left_mm, 3) } mm
    .hint = corriger les noms dans l’export

motions-alike = { $count ->
        [one] { $count } autre mouvement explique
       *[other] { $count } autres mouvements expliquent
    } aussi ces résidus : { $motions }
    .hint = observer des poses dont les valeurs articulaires diffèrent davantage

target-far-from-given = la cible `{ $target }` est identifiée en ({ FIXED($x_mm, 1) }, { FIXED($y_mm, 1) }, { FIXED($z_mm, 1) }) mm, à { FIXED($distance_mm, 1) } mm de sa position indiquée ({ FIXED($sx_mm, 1) }, { FIXED($sy_mm, 1) }, { FIXED($sz_mm, 1) }) mm
    .hint = vérifier le segment de l’outil ou la bride du robot, la position indiquée et le zéro de la dernière articulation

no-coordinates-to-check = { $count ->
        [one] { $count } coordonnée des poses d’étalonnage détermine
       *[other] { $count } coordonnées des poses d’étalonnage déterminent
    } { $parameters ->
        [one] { $parameters } paramètre
       *[other] { $parameters } paramètres
    } : les paramètres ne sont pas vérifiés
    .hint = mesurer plus de poses, réparties dans l’espace de travail

validation-outliers = { $count } erreurs de validation sur { $total } dépassent { FIXED($limit_mm, 4) } mm, { $times } fois leur médiane : { $readings }

common-scale = { $parameters } valent tous environ { FIXED($factor, 5) } fois leur valeur nominale : une erreur d’échelle du système de mesure ou des articulations l’explique mieux que des erreurs de { $count } pièces
    .hint = vérifier l’échelle, la compensation de température et l’unité du système de mesure et des codeurs

compliance-negative = `{ $parameter }` est négatif ({ FIXED($value, 5) } { $unit }) : l’articulation fléchit en sens inverse de la pesanteur
    .hint = vérifier `gravity` et la direction de l’axe de l’articulation dans robot.toml

load-columns-slip = les centres de masse indiqués contredisent les mesures ({ FIXED($over_u, 1) } incertitudes-types) ; { $count ->
        [one] une modification les explique : { $changes }
       *[other] chacune de ces modifications les explique : { $changes }
    }
    .hint = comparer les colonnes de la charge avec sa fiche technique : axes de la bride, signes, unité

load-change-exchanged = `{ $first }` et `{ $second }` sont intervertis

load-change-sign = `{ $column }` a le signe opposé

load-change-unit = le centre de masse est en { $unit }

backlash-negative = `{ $parameter }` est négatif ({ FIXED($value, 5) } { $unit }) : l’articulation devancerait son entraînement
    .hint = vérifier le signe des sens d’approche (+1 par valeurs croissantes, -1 par valeurs décroissantes), et que les instants du journal sont ceux du même mouvement

torque-constant = le couple de l’articulation `{ $joint }` vaut { FIXED($value, 3) } N·m dans toutes les lectures d’étalonnage (`{ $column }`) : il se confond avec le zéro de l’articulation, et la compliance de cette articulation est fixée

torque-signs-differ = la flexion identifiée sous les couples est positive pour { $positive } et négative pour { $negative } : certaines articulations cèdent dans le sens du couple indiqué, d’autres en sens inverse
    .hint = vérifier le signe et l’ordre des colonnes de couples

torques-exchanged = le modèle décrit les lectures avec `{ $first }` et `{ $second }` intervertis, mais non tels qu’ils sont indiqués
    .hint = vérifier à quelle articulation appartient chaque colonne de couples

temperature-constant = la température vaut { FIXED($value, 1) } °C dans toutes les lectures d’étalonnage : la dilatation et la dérive ne sont pas déterminables et sont fixées ; longueurs et zéros sont ceux de cette température

temperature-questioned = les températures des lectures d’étalonnage vont de { FIXED($low, 1) } à { FIXED($high, 1) } °C, hors de { $least } à { $most } °C

load-questioned = des charges jusqu’à { $high_kg } kg sont trop lourdes pour un bras d’une portée de { FIXED($reach_m, 2) } m
    .hint = vérifier l’unité de la colonne `load_kg` : lue en grammes, c’est { $in_grams_kg } kg

temperature-units = vérifier l’unité : lues en °F, elles vont de { FIXED($from_fahrenheit, 1) } à { FIXED($to_fahrenheit, 1) } °C, lues en K de { FIXED($from_kelvin, 1) } à { FIXED($to_kelvin, 1) } °C

ball-names-exchanged = `{ $parameter }`, distance de K à L, vaut { FIXED($value, 3) } { $unit } : K et L sont interverties
    .hint = intervertir les noms des deux cibles dans les étiquettes de l’export

identified-worse-than-nominal = aux poses { $set ->
        [validation] de validation
       *[calibration] d’étalonnage
    }, le robot identifié est moins bon que le robot nominal : { FIXED($before_mm, 4) } mm avant, { FIXED($after_mm, 4) } mm après (moyenne quadratique)
    .hint = mesurer plus de poses, réparties dans l’espace de travail, ou fixer les paramètres que les poses ne déterminent pas

value-beyond-tolerance = `{ $parameter }` = { $unit ->
        [mm] { FIXED($value, 3) } { $unit } (nominal { $nominal } { $unit }, tolérance { FIXED($tolerance, 3) } { $unit })
        [deg] { FIXED($value, 3) } { $unit } (nominal { $nominal } { $unit }, tolérance { FIXED($tolerance, 3) } { $unit })
       *[other] { FIXED($value, 4) } (nominal { $nominal }, tolérance { FIXED($tolerance, 3) })
    }

tolerance-exceeded = { $count ->
        [one] { $count } paramètre dépasse
       *[other] { $count } paramètres dépassent
    } la tolérance du robot : { $parameters }
    .hint = vérifier les signes, les unités et l’ordre des articulations, les valeurs nominales et les repères ; si le dessin technique indique une autre tolérance, l’indiquer par `tolerance` dans le fichier de robot

format-not-identified = les paramètres du format `{ $format }` n’ont pas pu être identifiés de nouveau : { $message }

clock-rate-from-standstills = l’horloge de la mesure avance de { FIXED($rate_ppm, 1) } ppm ± { FIXED($u_ppm, 1) } ppm (k = 1) par rapport à celle du journal `{ $log }` (possible : { FIXED($low_ppm, 1) } à { FIXED($high_ppm, 1) } ppm) ; décalage { FIXED($offset_s, 3) } s ± { FIXED($u_s, 3) } s (k = 1) à { FIXED($reference_s, 3) } s du journal
    .hint = avec ce décalage et cette dérive, chaque point mesuré tombe dans un arrêt ; le décalage seul n’y suffit pas

clock-rate-insignificant = les arrêts du journal `{ $log }` ne montrent aucune dérive significative entre les horloges : la dérive est comprise entre { FIXED($low_ppm, 1) } et { FIXED($high_ppm, 1) } ppm
    .hint = omettre `clock_rate` : seul le décalage est utilisé

clock-from-motion = l’horloge du journal `{ $log }` est calée sur les vitesses du mouvement (corrélation { FIXED($correlation, 3) }) : décalage { FIXED($offset_s, 4) } s ± { FIXED($u_s, 4) } s (k = 1) à { FIXED($reference_s, 3) } s du journal, dérive { FIXED($rate_ppm, 1) } ppm ± { FIXED($u_ppm, 1) } ppm (k = 1)
    .hint = les points sont joints aux lignes du journal à ces instants

clock-motion-unlike = les vitesses des points et du journal ne sont corrélées pour aucun décalage des horloges : au plus { FIXED($correlation, 2) }
    .hint = vérifier que le journal et les points sont du même mouvement ; pour des points mesurés seulement à l'arrêt, donner à `clock_offset_s` la valeur `"standstills"` ou un nombre

clock-motion-several = les vitesses des points et du journal sont corrélées pour { $count } décalages des horloges : { $ranges }
    .hint = enregistrer un mouvement qui ne se répète pas, ou donner à `clock_offset_s` une valeur numérique

clock-motion-short = { $count ->
        [one] { $count } vitesse mesurée ne suffit
       *[other] { $count } vitesses mesurées ne suffisent
    } pas à comparer les horloges par le mouvement
    .expected = au moins 20 vitesses, dans les points et dans le journal

clock-rate-none = aucun décalage des horloges, même avec une dérive jusqu’à ± { $most_ppm } ppm, ne place tous les points mesurés dans des arrêts du journal
    .hint = vérifier si le journal est celui de cette mesure, et supprimer les points mesurés en mouvement ; ou donner à `clock_offset_s` une valeur numérique
limit-not-assessable = la limite `{ $limit }` ne peut pas être évaluée : sa grandeur n’est pas mesurée aux poses décisives
    .hint = mesurer la grandeur à ces poses, ou supprimer la limite dans [limits]
sweep-joint-unknown = `{ $joint }` n’est pas une articulation de ces balayages
    .expected = { $known }

sweep-order-missing = l’ordre des articulations { $joints } à partir de la base est inconnu
    .hint = l’indiquer : --joints NOM,...

sweep-joint-column-twice = deux colonnes donnent des valeurs de l’articulation `{ $joint }`
    .hint = en supprimer une

sweep-values-partial = les valeurs articulaires sont incomplètes
    .expected = les valeurs de toutes les articulations à chaque ligne, ou à aucune ligne d’un balayage
    .hint = une ligne sans articulation balayée est une pose de contrôle et exige les valeurs de toutes les articulations

sweep-sign-by-values = les valeurs articulaires déterminent déjà le sens de chaque balayage
    .hint = omettre --backwards

sweep-other-joint = `{ $moved }` bouge dans le balayage de `{ $joint }`, qui est au repos
    .hint = corriger la colonne `joint` ou les en-têtes des valeurs articulaires

sweep-two-joints = dans le balayage de `{ $joint }`, `{ $also }` bouge aussi, de { $by }
    .hint = refaire le balayage avec toutes les autres articulations au repos

sweep-by-angle = { FIXED($by, 3) } deg

sweep-by-length = { FIXED($by, 3) } mm

sweep-ratio = les cibles se déplacent de { FIXED($ratio, 5) } × les valeurs de `{ $joint }` (u = { SCIENTIFIC($u, 1) })
    .hint = { $unit ->
            [deg-as-rad] les valeurs sont en degrés et lues en radians : corriger l’en-tête
            [rad-as-deg] les valeurs sont en radians et lues en degrés : corriger l’en-tête
            [inch-as-mm] les valeurs sont en pouces et lues en millimètres
            [m-as-mm] les valeurs sont en mètres et lues en millimètres : corriger l’en-tête
            [mm-as-m] les valeurs sont en millimètres et lues en mètres : corriger l’en-tête
           *[none] corriger l’unité de la colonne, ou calculer la valeur articulaire à partir de celle du moteur
        }

sweep-target-moved = la cible `{ $target }` a bougé dans le balayage de `{ $joint }` avant la ligne { $row } : écart à une seule trajectoire { FIXED($before_um, 1) } µm, à deux trajectoires { FIXED($after_um, 1) } µm
    .hint = refaire le balayage, ou donner un autre nom à la cible à partir de cette ligne

sweep-many-outliers = { $aside } lectures sur { $readings } du balayage de `{ $joint }` ne sont pas sur la trajectoire des autres
    .hint = chercher une deuxième articulation qui bouge, ou des lignes d’un autre balayage

sweep-outliers = { $count ->
        [one] { $count } lecture du balayage de `{ $joint }` est exclue : ligne { $lines }
       *[other] { $count } lectures du balayage de `{ $joint }` sont exclues : lignes { $lines }
    }
    .hint = vérifier ces lignes : leurs lectures sont loin de la trajectoire de toutes les autres

sweep-smooth = dans le balayage de `{ $joint }`, les cibles s’écartent continûment de leur trajectoire, de { FIXED($rms_um, 1) } µm (moyenne quadratique) ; le bruit d’une lecture à l’autre est de { FIXED($noise_um, 1) } µm ; l’incertitude de l’axe comprend les deux
    .hint = vérifier que toutes les autres articulations étaient au repos, et comparer avec le faux-rond du palier

sweep-weak = la direction de l’axe de `{ $joint }` a une incertitude-type de { FIXED($u_mrad, 2) } mrad
    .hint = mesurer un arc plus long, une cible plus éloignée de l’axe, ou plus de cibles

sweep-unit = toutes les cibles sont à moins de { FIXED($radius_mm, 3) } mm des axes : les coordonnées sont probablement en mètres
    .hint = vérifier l’unité, et convertir les colonnes, ici x : --column 'x_mm={ $source }*1000'

sweep-few = le balayage de `{ $joint }` a { $readings } lectures, il en faut { $needed }
    .hint = prendre plus de lectures ; les lectures redondantes déterminent l’incertitude

sweep-undetermined = les lectures du balayage de `{ $joint }` ne déterminent aucun axe
    .hint = mesurer un arc plus long ou une cible plus éloignée de l’axe ; une articulation prismatique s’indique par --prismatic

sweep-joint-missing = { $count ->
        [one] l’articulation { $joints } n’a pas de balayage
       *[other] les articulations { $joints } n’ont pas de balayage
    } : robot.toml n’est pas écrit
    .hint = mesurer un balayage de chaque articulation

sweep-starts-apart = les balayages de `{ $first }` et `{ $second }` commencent à { FIXED($gap_mm, 3) } mm l’un de l’autre pour la cible `{ $target }` : robot.toml n’est pas écrit
    .hint = commencer chaque balayage à la même pose avec la cible à sa place, ou ajouter les colonnes de valeurs articulaires

sweep-target-unswept = une cible des poses de contrôle n’est dans aucun balayage : robot.toml n’est pas écrit
    .hint = aux poses de contrôle, utiliser des cibles des balayages

sweeps-exchanged = `{ $first }` et `{ $second }` sont interverties : les positions diffèrent de { FIXED($stated_mm, 3) } mm (moyenne quadratique) avec les articulations telles qu’indiquées, et de { FIXED($left_mm, 3) } mm une fois les articulations interverties
    .hint = intervertir leurs noms dans la colonne `joint` et dans les en-têtes

sweep-reversed = `{ $joint }` a été balayée dans le sens négatif : les poses de contrôle diffèrent de { FIXED($stated_mm, 3) } mm (moyenne quadratique) avec le sens indiqué, et de { FIXED($left_mm, 3) } mm avec le sens opposé
    .hint = l’indiquer : --backwards { $joint }

sweeps-disagree = { $what ->
        [checks] les poses de contrôle s’écartent du robot jusqu’à { FIXED($distance_mm, 3) } mm
       *[sweeps] les balayages se contredisent, jusqu’à { FIXED($distance_mm, 3) } mm
    } (incertitude-type { FIXED($u_mm, 4) } mm)
    .hint = vérifier les supports des cibles et les valeurs articulaires ; `etalon identify` et `etalon run` peuvent partir de ce robot

table-base-not-held = le tableau a sa propre base, tournée de { FIXED($angle_deg, 4) } deg et décalée de { FIXED($shift_mm, 4) } mm
    .hint = identifier la base, ou utiliser `poe`

table-flange-not-held = le tableau a sa propre bride, tournée de { FIXED($angle_deg, 4) } deg et décalée de { FIXED($shift_mm, 4) } mm
    .hint = identifier les cibles, ou utiliser `poe`

table-tilt-not-held = le tableau tient { $joint ->
        [none] deux axes
       *[other] les axes du segment de `{ $joint }`
    } pour parallèles : il ne contient pas l’angle de { FIXED($angle_mrad, 4) } mrad entre eux
    .hint = `etalon identify` détermine beta ; `poe` contient cet angle
row-excluded = exclue : { $reason }
row-at-origin = non mesurée : 0 0 0
row-of-station-unused = station `{ $station }` : le robot n’a pas de cible de ce nom
row-of-several = { $rows } lignes du journal `{ $log }` sont à moins de { $tolerance_s } s : la ligne la plus proche est utilisée
no-rows-around = le journal `{ $log }` n’a pas de ligne avant ou après ce point à moins de { $tolerance_s } s
no-row-near = aucune ligne du journal `{ $log }` n’est à moins de { $tolerance_s } s
no-point-nearest = une autre ligne est plus proche de chaque point mesuré
no-row-of-key = aucune ligne du journal `{ $log }` n’a cette clé
no-point-of-key = aucun point mesuré n’a cette clé
label-names-nothing = son étiquette ne nomme ni cible, ni point d’un élément ou d’un repère
no-row-touches = aucune ligne du journal `{ $log }` ne touche ce point
row-of-unframed-pose = la pose de la ligne n’a pas de repère atelier

table-of-observations = observations
table-of-attained-poses = poses atteintes
table-of-commanded-poses = poses commandées
table-of-reference-targets = cibles de référence
table-of-commanded-path = trajectoire commandée
table-of-compliance = compliance statique
recorded-motion-file = mouvement enregistré
read-in-unit = { $format }, unité { $unit }
read-in-frame = { $read }, par rapport à `{ $frame }`
read-without-columns = { $read }, { $unread } colonnes sur { $all } non lues
read-except-columns = { $read }, non lues : { $columns }

side-stated = comme indiqué par l’utilisateur
side-from-values = d’après { $of ->
        [normal] la normale
        [location] la position
       *[diameter] le diamètre
    } ({ $values ->
        [nominal] valeurs nominales
       *[stated] valeurs indiquées
    })
side-from-key = d’après `InternalExternal` : { $value }
label-orientations-unused = les orientations de l’export ne sont pas utilisées : le journal `{ $log }` indique `{ $label }` dans { $count } lignes
    .hint = joindre par pose, ligne ou instant si l’instrument a mesuré à chaque pose le corps porté par le robot

temperature-elsewhere = `temperature_c` = { $stated_c } ; les lignes des exports indiquent de { FIXED($lowest_c, 1) } °C à { FIXED($highest_c, 1) } °C
    .hint = corriger `temperature_c`, ou l’unité de la colonne (degrés Celsius)

load-elsewhere = `load_kg` = { $stated_kg } ; les lectures indiquent des charges de { $lowest_kg } kg à { $highest_kg } kg
    .hint = supprimer `load_kg` de [conditions], ou corriger les charges des lectures

temperature-varies = les lignes des exports indiquent de { FIXED($lowest_c, 1) } °C à { FIXED($highest_c, 1) } °C, soit plus de ±{ $expanded_c } °C ; l’incertitude des longueurs est trop petite
    .hint = indiquer une `expanded_temperature_uncertainty_c` qui couvre cette étendue
axes-comment-method = axes déterminés par balayage d’une articulation à la fois (etalon axes) ; sans modèle nominal

axes-comment-base = base définie par les axes 1 et 2, règle `{ $rule }` : z suivant l’axe 1

axes-comment-joint = q{ $number } est { $name }

axes-comment-zero = les valeurs articulaires sont nulles au début des balayages

axes-comment-target = cible { $name } sur la bride (mm) : { FIXED($x, 4) } { FIXED($y, 4) } { FIXED($z, 4) }
axes-comment-tolerance = les balayages déterminent ces paramètres : les tolérances sont des demi-largeurs de lois rectangulaires

axes-robot-name = Robot décrit par ses axes

cell-few = `{ $solve }` exige { $needed } lectures ; il y en a { $readings }
    .hint = prendre plus de lectures ; les lectures redondantes déterminent l’incertitude

cell-axis-at-rest = l’axe ne bouge pas : toutes les lectures de chaque cible ({ $readings } au total) sont à une seule valeur de l’axe
    .hint = mesurer les cibles à plusieurs valeurs de l’axe

cell-same-orientation = le robot a la même orientation dans toutes les lignes
    .hint = tourner le robot entre les lectures, autour d’au moins deux axes

cell-one-axis = toutes les orientations diffèrent par des rotations autour d’un seul axe, [{ $direction }] dans la bride : la position le long de cet axe n’est pas déterminée
    .hint = ajouter des lectures avec des rotations autour d’un autre axe

cell-points-coincide = tous les points coïncident
    .hint = mesurer des points distants ; pour des orientations autour d’un point fixe, utiliser `--solve tool-point`

cell-points-collinear = tous les points sont sur une droite de direction [{ $direction }] : la rotation autour de cette droite n’est pas déterminée
    .hint = mesurer un point à côté de la droite

cell-ambiguous = deux repères différents conviennent aussi bien aux lectures
    .hint = ajouter des lectures avec d’autres orientations

cell-undetermined = les lectures ne déterminent pas toutes les grandeurs inconnues
    .hint = ajouter des lectures à d’autres poses ou valeurs de l’axe

cell-orientation-missing = les poses n’ont pas de colonnes d’orientation
    .expected = { $prefix }qw, { $prefix }qx, { $prefix }qy, { $prefix }qz, ou { $prefix }rx_deg .. d’un vecteur de rotation, ou { $prefix }a_deg .. de trois angles, ou { $prefix }r11 .. { $prefix }r33
    .hint = indiquer les colonnes, par `--column { $prefix }qw=TITRE` si leurs titres sont différents

cell-order-missing = l’ordre des angles { $prefix }a, { $prefix }b, { $prefix }c n’est pas indiqué
    .hint = l’indiquer d’après le manuel : `{ $option } zyx` pour A B C de KUKA, `{ $option } "fixed xyz"` pour W P R de FANUC

cell-mounting-missing = la partie du système de mesure qui est sur le robot n’est pas indiquée
    .hint = indiquer `--mounting target` (l’instrument est fixe) ou `--mounting sensor` (l’instrument est sur le robot)

cell-uncertainty-not-positive = une incertitude-type manque ou n’est pas positive

cell-point-unknown = `{ $name }` n’est pas un point de ce problème
    .expected = { $known }

cell-roles-mixed = des points de deux règles sont mélangés
    .expected = origin, x, xy, ou x1, x2, y1

cell-axis-missing = les valeurs de l’axe manquent dans le tableau
    .hint = indiquer la colonne : `--column { $column }=TITRE`

cell-no-controller-data = `{ $maker }` n’a pas de données pour le résultat de `{ $solve }`
    .hint = prendre les nombres dans le texte ou dans `--json`, ou choisir un autre format

cell-second-axis-missing = `{ $maker }` exige deux axes rotatifs : un le long de { $axis } de la machine, un le long de z
    .hint = indiquer le résultat de l’autre axe par `--with FICHIER` (JSON de `etalon cell --solve rotary-axis`)

cell-axis-direction = un axe rotatif est à { FIXED($angle_deg, 2) } deg de l’axe { $axis } de la machine, autour duquel tourne `{ $maker }`
    .hint = mesurer dans les coordonnées de la machine, ou choisir la cinématique de la machine

cell-axis-sense = { $sense ->
        [opposite] l’axe le long de { $axis } et l’axe le long de z tournent en sens opposés ; `{ $maker }` a un seul sens pour les deux
        [positive] l’axe tourne autour de { $axis } positif ; `{ $maker }` tourne autour de { $axis } négatif
       *[negative] les axes tournent autour de { $axis } et z négatifs ; `{ $maker }` tourne autour des axes positifs
    }
    .hint = inverser le signe de l’axe dans sa configuration, et mesurer à nouveau

cell-tool-length-missing = `{ $maker }` exige la longueur de l’outil au bout duquel se trouve la première cible
    .hint = indiquer `--tool-length-mm`, 0 pour une cible au plan de jauge

cell-pivot-above = l’outil ({ FIXED($tool_mm, 3) } mm) est plus long que la distance de l’axe à la première cible située dessous ({ FIXED($along_mm, 3) } mm, axe à zéro)
    .hint = vérifier la longueur de l’outil, et que z de la machine monte le long de la broche

cell-machine-number = `MACHINE_DEF[{ $number }]` n’est pas une cinématique externe
    .expected = 2 à 7
    .hint = indiquer `--number`

cell-loads-replaced = l’entrée de l’outil { $number } a une masse et un centre de gravité nuls : les données de charge ne sont pas identifiées
    .hint = copier la ligne du repère dans son propre fichier, ou compléter les lignes de la charge

cell-axis-tilted = l’axe le long de { $axis } est incliné de { FIXED($angle_deg, 4) } deg, et `{ $maker }` n’admet pas d’inclinaison : { FIXED($left_um, 1) } µm à 100 mm de l’axe
    .hint = aligner l’axe, ou accepter cette erreur

cell-slip = les lectures se contredisent de { FIXED($stated_mm, 3) } mm (écart-type) ; { $count ->
        [one] une modification ramène l’écart à { FIXED($left_mm, 4) } mm : { $changes }
       *[other] chacune de ces modifications ramène l’écart à { FIXED($left_mm, 4) } mm ou un peu plus : { $changes }
    }
    .hint = corriger le tableau ou les options

cell-outlier = la lecture de la ligne { $line } ne s’accorde pas avec les autres : résidu { FIXED($residual_mm, 4) } mm
    .hint = vérifier la lecture, et l’omettre par `--without` si elle est fausse

cell-outlier-turned = l’orientation de la ligne { $line } ne s’accorde pas avec les autres : résidu { FIXED($residual_deg, 4) } deg
    .hint = vérifier la lecture, et l’omettre par `--without` si elle est fausse

cell-noise-larger = les résidus des positions sont de { FIXED($found_um, 1) } µm (écart-type), plus que l’incertitude indiquée n’en explique ; les incertitudes sont calculées à partir des résidus
    .hint = indiquer l’incertitude composée du robot et de la mesure

cell-noise-larger-turned = les résidus des orientations sont de { FIXED($found_deg, 4) } deg (écart-type), plus que l’incertitude indiquée n’en explique ; les incertitudes sont calculées à partir des résidus
    .hint = indiquer l’incertitude composée du robot et de la mesure

cell-no-uncertainty = l’incertitude est inconnue : les lectures n’ont pas de redondance, et aucune incertitude n’est indiquée
    .hint = prendre plus de lectures, ou indiquer `--standard-uncertainty-um`

cell-columns-unused = { $count ->
        [one] la colonne indiquée { $columns } n’est pas utilisée
       *[other] les colonnes indiquées { $columns } ne sont pas utilisées
    } par `{ $solve }`
    .hint = `etalon cell --help` énumère les colonnes de chaque problème

cell-refuted = les résidus des positions sont de { FIXED($found_mm, 3) } mm (écart-type), qu’aucune incertitude plausible n’explique : le résultat est réfuté
    .hint = vérifier les colonnes, les signes, les unités et l’ordre des lignes

cell-refuted-turned = les résidus des orientations sont de { FIXED($found_deg, 2) } deg (écart-type), qu’aucune incertitude plausible n’explique : le résultat est réfuté
    .hint = vérifier les colonnes, les signes, les unités et l’ordre des lignes

cell-data-withheld = les données pour { $maker } ne sont pas écrites : le résultat ne doit pas être chargé
    .hint = corriger ce qu’indiquent les erreurs ; `--force` écrit les données

cell-unit-large = la bride est à { FIXED($distance_m, 1) } m de la base, et l’outil mesure { FIXED($tool_m, 1) } m : les positions sont probablement en millimètres
    .hint = utiliser `flange_x_mm`, `flange_y_mm`, `flange_z_mm` pour des millimètres

cell-unit = toutes les positions de la bride sont à moins de { FIXED($distance_mm, 3) } mm de la base, et l’outil mesure moins de 2 mm : les positions sont probablement en mètres
    .hint = utiliser `flange_x_m`, `flange_y_m`, `flange_z_m` pour des mètres

cell-tool-active = le point d’outil est à { FIXED($distance_mm, 4) } mm de l’origine des poses (u = { FIXED($u_mm, 4) } mm) : les poses sont probablement celles de l’outil et non de la bride
    .hint = exporter les poses avec l’outil 0

cell-scale = l’axe se déplace de { FIXED($scale, 5) } × ses valeurs (u = { SCIENTIFIC($u, 1) })
    .hint = vérifier l’unité de la colonne et le rapport de l’axe

cell-change-orientations = { $what }, pour les orientations { $side ->
        [flange] de la bride
       *[measured] des poses mesurées
    }

cell-change-inverse = les poses { $side ->
        [flange] de la bride
       *[measured] mesurées
    } sont inverses

cell-change-unit = les positions { $side ->
        [flange] de la bride
       *[measured] des points mesurés
    } sont en { $unit }

cell-change-axes = { $first } et { $second } des positions { $side ->
        [flange] de la bride
       *[measured] des poses mesurées
    } sont intervertis

cell-change-sign = { $axis } des positions { $side ->
        [flange] de la bride
       *[measured] des poses mesurées
    } a le signe opposé

cell-change-measured-mirrored = deux coordonnées des points mesurés sont interverties, ou l’une d’elles a le signe opposé

cell-change-scale = les points mesurés sont multipliés par { $factor }

cell-change-mirrored = les points connus sont inversés par symétrie (deux coordonnées sont interverties, ou l’une d’elles a le signe opposé)

cell-change-exchanged = les points des lignes { $first } et { $second } sont intervertis

field-refused = pas de champ résiduel : { $reason }

tilt-of-base-or-joint = { $stated ->
        [pedestal] le basculement de la base (`pedestal`) peut être celui de l’articulation `{ $joint }` en travers de son axe (`lateral`)
       *[lateral] le basculement de l’articulation `{ $joint }` en travers de son axe (`lateral`) peut être celui de la base (`pedestal`)
    } : le khi-deux est de { FIXED($chi_square, 1) } avec le premier et de { FIXED($of_other, 1) } avec le second
    .hint = considérer les paramètres comme le basculement de la base et de la première articulation ensemble

field-follows-order = le champ résiduel dépend de `{ $joint }`, dont les valeurs suivent l’ordre des poses (corrélation de rang { FIXED($correlation, 2) }) : une dérive du montage aurait le même effet
    .hint = juger le champ par `etalon validate --field` à des poses dans un autre ordre

poses-beyond-field = { $count } poses sur { $total } sont au-delà du champ résiduel, là où il décroît vers zéro
    .hint = mesurer des poses d’étalonnage dans cette région

field-parameters-wrong = l’identification signale une erreur, qu’un champ masquerait

uncertainty-beyond-bound = { $component } : U = { $expanded }{ $unit ->
    [1] {""}
   *[other] {" "}{ $unit }
} (k = 2) dépasse { $source ->
    [stated] la limite indiquée
   *[default] la limite
} { $bound }{ $unit ->
    [1] {""}
   *[other] {" "}{ $unit }
}{ $source ->
    [stated] {""}
   *[default] { " " }(par défaut, pour une étendue mesurée de { $extent_mm } mm)
} : { $cause }
uncertainty-bound-unreadable = `{ $text }` n’est pas une limite d’incertitude : une longueur, un angle, ou les deux, avec leurs unités, sont attendus
    .hint = par exemple `0.5 mm, 0.1 deg`
bound-position = position { $axis } de `{ $name }`
bound-rotation = rotation de `{ $name }` autour de { $axis }
bound-direction = composante { $axis } de la direction de l’axe
bound-ratio = rapport de l’axe
bound-axis-direction = direction de l’axe de `{ $joint }`
bound-axis-point = position de l’axe de `{ $joint }`
bound-parameter = { $parameter }
bound-open-rotation = les lectures ne déterminent guère la rotation autour de la direction { $direction }
bound-open-translation = les lectures ne déterminent guère la position le long de { $direction }
bound-open-combination = les lectures ne déterminent guère la combinaison de { $names }
bound-open-alone = les lectures ne déterminent guère cette composante
bound-remedy = { $case ->
    [tool] toucher le point avec des orientations qui diffèrent de 30 deg ou plus autour de deux axes de la bride
    [poses] ajouter des poses dont les orientations diffèrent de 30 deg ou plus autour de deux axes, dans une région plus grande
    [points] mesurer des points plus éloignés les uns des autres, et plus éloignés de la droite qui passe par les autres
    [travel] mesurer sur une course plus longue
    [turn] mesurer une cible plus éloignée de l’axe, sur un arc plus grand
    [base] mesurer dans une région plus grande, et mesurer des points du repère atelier plus éloignés les uns des autres et non alignés
    [region] étalonner avec des poses dans la région de ces cibles
   *[robot] mesurer des poses où les paramètres nommés agissent différemment, ou fixer ces paramètres
} ; ou indiquez une limite plus grande

encoder-implausible = { $count ->
    [one] un gain ou un zéro d’une articulation rotoïde s’écarte
   *[other] { $count } gains ou zéros d’articulations rotoïdes s’écartent
} de la valeur nominale plus que codeurs et prise d’origine ne le permettent : { $parameters }
    .hint = vérifier la colonne de l’articulation dans le journal, son rapport de réduction et sa prise d’origine ; si la valeur est réelle, indiquer sa `tolerance` dans robot.toml
value-beyond-encoder = `{ $parameter }` = { FIXED($value, 5) }{ $unit ->
    [deg] {" "}deg
   *[other] {""}
} (nominal { FIXED($nominal, 5) }, écart de { $times } u)

changes-undetected = les poses choisies ne décèlent pas { $count ->
    [one] un changement
   *[other] { $count } changements
} dans la limite : { $changes }
    .hint = choisir plus de poses (`--positions`), proposer des poses candidates dans une région plus grande, ou indiquer une limite plus grande
change-beyond-bound = { $name } : { $change } { $unit }, limite { $bound } { $unit }

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

of-file = `{ $file }` : { $message }

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

key-in-lines = { $key } aux lignes { $lines }

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

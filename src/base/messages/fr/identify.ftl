### Messages de identify ; explications dans en/identify.ftl.

no-observations = il n’y a pas d’observations à partir desquelles identifier les paramètres
    .hint = vérifier quelles poses sont choisies et lesquelles sont exclues

pose-residuals-without-uncertainty = les résidus de la pose mêlent mm et rad : ils nécessitent l’incertitude-type d’une coordonnée

common-uncertainty-alone = une incertitude commune à plusieurs observations nécessite les résidus des cibles et l’incertitude de chaque observation

parameter-unknown = `{ $pattern }` n’est pas un paramètre de ce robot

observations-need-arm = orientations, distances, contacts, surfaces et valeurs articulaires ne s’appliquent qu’aux bras tridimensionnels, et non à `{ $model }`

kinds-need-target-residuals = orientations, distances, contacts, surfaces et valeurs articulaires nécessitent les résidus des cibles sans incertitude commune
    .hint = comparer les cibles, et omettre l’incertitude commune

kinds-without-uncertainty = des observations de plusieurs types nécessitent l’incertitude-type d’une coordonnée

own-uncertainties-unusable = des lectures avec leur propre incertitude nécessitent les résidus des cibles sans incertitude commune

readings-without-uncertainty = { $without } des { $readings } lectures n’ont pas d’incertitude

pose-residuals-not-planar = les résidus de la pose ne s’appliquent qu’aux robots plans, et non à `{ $model }`

tool-part-missing = le point d’outil est indiqué dans le repère de { $part ->
        [flange] la bride
       *[platform] la plate-forme
    } : `{ $model }` n’en a pas

too-few-poses-planned = { $poses } poses ne suffisent pas à déterminer { $parameters } paramètres

nothing-to-identify = il ne reste aucun paramètre à identifier{ $cause ->
        [none] {""}
       *[other] {" "}: { $cause }
    }

hold-fewer-parameters = fixer moins de paramètres

parameters-undetermined = { $residuals ->
        [one] { $residuals } résidu
       *[other] { $residuals } résidus
    } de { $poses ->
        [one] { $poses } pose
       *[other] { $poses } poses
    }, dont { $independent } indépendants, ne suffisent pas à déterminer { $parameters ->
        [one] { $parameters } paramètre
       *[other] { $parameters } paramètres
    }

parameter-without-effect = les données ne dépendent pas de `{ $parameter }`

parameters-inseparable = `{ $parameter }` n’est pas identifiable séparément de { $others }

identification-without-result = l’identification s’est terminée sans résultat : { $reason }

solver-ended = { $termination ->
        [iteration-limit] pas de convergence avant la limite d’itérations
        [not-a-number] un résidu n’est pas un nombre
        [rank-deficient] des paramètres ne sont pas identifiables séparément
        [unsteady] l’ensemble des paramètres identifiables séparément change entre les pas du solveur
        [too-few-equations] il y a moins d’équations que de paramètres
       *[converged] convergence, mais le résultat n’est pas unique
    }

readings-contradict = la plupart des lectures concordent, mais non celles de { $poses }{ $count ->
        [0] {""}
       *[other] {" "}: les valeurs articulaires des poses { $pairs } sont interverties
    }{ $wrong ->
        [0] {""}
       *[other] {" "}: { $coordinates }
    }

wrong-coordinate = { $axis } de { $target } à la pose { $pose } (cycle { $cycle }) vaut { FIXED($measured_mm, 3) } mm, et { FIXED($changed_mm, 3) } mm concorde

change-of-reference = un mouvement de la base ou du système de mesure

change-of-target = un mouvement de la cible `{ $target }` sur son support

change-of-zero = un autre zéro de l’articulation `{ $joint }`

change-or-another = { $message } ; les mesures s’accordent aussi bien avec { $others }

named-poses = { $count ->
        [one] la pose { $poses }
       *[other] { $count } poses ({ $poses })
    }

poses-unreachable = le robot nominal n’a pas de pose aux valeurs articulaires de { $poses }

extents-differ = l’étendue des points mesurés est de { FIXED($measured_mm, 0) } mm, celle des points prédits de { FIXED($model_mm, 0) } mm

assembly-mode-contradicted = la position mesurée contredit le mode d’assemblage pour { $poses } : à la pose { $worst }, le résidu est de { FIXED($stated_mm, 1) } mm avec le mode indiqué { $stated }, de { FIXED($other_mm, 1) } mm avec le mode { $other }

scale-unobserved = aucune observation ne contient de longueur : l’échelle du robot est celle de ses longueurs nominales{ $lengths ->
        [none] {""}
       *[other] {" "}({ $lengths })
    }
    .hint = mesurer une distance entre deux logements ou à un point fixe, ou la position d’une cible

readings-weighted = { $own } des { $readings } lectures sont pondérées par leurs propres incertitudes-types : { FIXED($least_mm, 4) } à { FIXED($most_mm, 4) } mm par coordonnée

rigid-part-contradicted = { $places } de { $targets } contredisent les mesures au-delà de leur incertitude : distance de `{ $first }` à `{ $second }` { $by ->
        [identification] identifiée sans elles
       *[measurement] mesurée
    } { FIXED($found_mm, 4) } mm, indiquée { FIXED($stated_mm, 4) } mm

stated-positions = les positions indiquées

comparison-without-uncertainty = une comparaison avec des paramètres donnés nécessite l’incertitude-type d’une coordonnée
    .hint = indiquer l’incertitude de l’instrument

robot-not-at-joints = le robot n’a pas de pose à ces valeurs articulaires avec les paramètres { $parameters ->
        [nominal] nominaux
       *[given] donnés
    }
    .hint = vérifier l’unité, le signe et le décalage des valeurs articulaires, et que les paramètres sont ceux de ce robot

covariance-not-positive-definite = la covariance des paramètres n’est pas définie positive
    .hint = utiliser la covariance telle que l’identification l’a fournie

no-redundant-observations = il y a autant d’équations que de paramètres : l’incertitude des paramètres est inconnue
    .hint = mesurer plus de poses, ou indiquer l’incertitude de l’instrument

pose-residuals-correlated = les résidus d’une même pose sont corrélés : les incertitudes-types sont estimées d’après la dispersion des poses et valent { FIXED($ratio, 1) } fois les incertitudes-types données par l’instrument
    .hint = le robot a des erreurs que le modèle ne décrit pas, ou l’instrument a des erreurs communes aux lectures d’une pose

series-not-estimated = les incertitudes ne contiennent pas la dispersion entre séries : moins de huit poses, ou des mesures communes à plusieurs poses

instrument-uncertainty-too-large = les résidus valent { FIXED($ratio, 2) } fois l’incertitude indiquée des lectures (khi-deux { FIXED($chi_square, 1) }, { $degrees } degrés de liberté) : les incertitudes-types sont trop grandes
    .hint = vérifier l’incertitude de l’instrument, son unité et son facteur d’élargissement ; les erreurs communes à toutes les poses n’apparaissent pas dans les résidus

residuals-exceed-uncertainty = les résidus valent { FIXED($ratio, 1) } fois l’incertitude indiquée des lectures (khi-deux { FIXED($chi_square, 0) }, { $degrees } degrés de liberté) : les incertitudes-types sont { $from ->
        [poses] estimées d’après la dispersion des poses
        [regions] estimées d’après la dispersion des régions de l’espace de travail
       *[residuals] majorées, comme si les résidus d’une même pose étaient indépendants
    } ({ FIXED($inflation, 1) } fois celles que donne l’incertitude indiquée, en médiane)
    .hint = vérifier les valeurs aberrantes et le modèle : le robot a des erreurs que le modèle ne décrit pas, ou l’incertitude indiquée est trop petite

parameters-fixed-by-frames = { $count } paramètres ne sont pas identifiables séparément de la base et des cibles, et sont fixés à leur valeur nominale : { $parameters }

target-place-free = les données ne peuvent séparer { $parameters } de la position de la base : fixés à 0, de sorte que les positions dans le référentiel de la base sont celles de cette cible
    .hint = pour des positions de la plateforme, y mesurer la cible, ajouter ses coordonnées sous [nominal] dans robot.toml, et les fixer par `hold`

parameter-held-without-effect = les données ne dépendent pas de `{ $parameter }` : il est fixé à sa valeur nominale

parameter-held-inseparable = `{ $parameter }` et { $others } ne sont pas identifiables séparément : `{ $parameter }` est fixé à sa valeur nominale

parameter-separable-poorly = `{ $parameter }` n’est séparable de { $others } qu’avec une incertitude-type de { FIXED($uncertainty, 2) }{ $unit ->
        [mm] {" "}{ $unit }
        [deg] {" "}{ $unit }
       *[other] {""}
    } : { $held ->
        [placed] il garde sa valeur de départ
       *[nominal] il reste à sa valeur nominale, plus exacte
    }
    .hint = mesurer des poses dans lesquelles ces paramètres agissent différemment

tool-targets-collinear = les cibles ne définissent pas de repère pour le point d’outil : il faut trois cibles non alignées pour un robot tridimensionnel, deux pour un robot plan
    .hint = indiquer le point dans le repère de la bride, ou utiliser la première cible elle-même ([0, 0, 0])

nominal-robot-far = le robot nominal s’écarte des mesures de { FIXED($left_mm, 3) } mm (moyenne quadratique, base et cibles ajustées) ; les tolérances admettent { FIXED($allowed_mm, 3) } mm
    .hint = vérifier les signes, les unités et l’ordre des articulations, les valeurs nominales, et la jointure des valeurs articulaires et des points

nominal-robot-not-at-joints = le robot nominal n’a pas de pose à ces valeurs articulaires
    .hint = vérifier les signes, les unités et l’ordre des articulations, les valeurs nominales, et la jointure des valeurs articulaires et des points

placement-unexplained = aucune position de la base et des cibles n’explique les mesures : les résidus sont de { FIXED($left_mm, 1) } mm, l’étendue des points mesurés est de { FIXED($spread_mm, 1) } mm
    .hint = vérifier les unités, l’ordre, les signes et les décalages des articulations, les paramètres fixés de la base et des cibles, et les paramètres nominaux du robot

joint-zero-shifted = à partir de la pose { $pose }, la valeur vraie moins la valeur enregistrée de l’articulation `{ $joint }` diffère de { FIXED($change, 4) } { $unit } ± { FIXED($expanded, 4) } { $unit } de celle des poses jusqu’à { $previous } : le changement du zéro explique { FIXED($share_percent, 0) } % des résidus
    .hint = contrôler le codeur et le calage de l’articulation : identifier séparément les poses avant et après le changement, ou mesurer de nouveau

reference-moved = à partir de la pose { $pose }, les positions mesurées sont décalées de { FIXED($shift_mm, 3) } mm ± { FIXED($expanded_mm, 3) } mm ({ $vector_mm } mm) par rapport aux positions mesurées jusqu’à la pose { $previous } : ce décalage explique { FIXED($share_percent, 0) } % des résidus
    .hint = la base ou le système de mesure a bougé : identifier les deux parties séparément ou mesurer de nouveau

target-shifted = à partir de la pose { $pose }, la cible `{ $target }` est décalée de { FIXED($shift_mm, 3) } mm ± { FIXED($expanded_mm, 3) } mm ({ $vector_mm } mm dans le repère de la bride) par rapport à la position qu’elle avait jusqu’à la pose { $previous } : ce décalage explique { FIXED($share_percent, 0) } % des résidus
    .hint = la cible a bougé sur son support : lui donner un autre nom à partir de cette pose, ou mesurer de nouveau

poses-exchanged = { $count ->
        [one] les valeurs articulaires des poses { $pairs } sont interverties
       *[other] les valeurs articulaires de { $count } paires de poses sont interverties : { $pairs }
    } : une fois remises en ordre, elles ne sont plus aberrantes
    .hint = vérifier l’ordre des lignes du journal et les noms des poses

set-up-contradicted = les mesures contredisent le montage déclaré
    .hint = vérifier les modifications qui expliquent les mesures

set-up-untested = non contrôlé par ces données : { $changes }
    .hint = les vérifier sur le robot, ou mesurer une seconde cible à l’écart de l’axe de la dernière articulation, à des poses qui font bouger toutes les articulations

untested-change = { $change } (écart-type d’une coordonnée { FIXED($changed_mm, 3) } mm au lieu de { FIXED($stated_mm, 3) } mm ; la bride s’écarte de { FIXED($flange_mm, 0) } mm et { FIXED($flange_deg, 0) } deg au plus)
pair-of-poses = { $first } et { $second }

parameters-weakly-identifiable = { $groups } sont faiblement identifiables à partir de ces poses : incertitudes-types { $uncertainties } (corrélation { FIXED($correlation, 6) })

parameter-groups-weakly-identifiable = { $count } groupes de paramètres sont faiblement identifiables à partir de ces poses (plus grandes incertitudes-types : { $uncertainties } ; au sein d’un groupe, les erreurs se compensent au voisinage de ces poses) : { $groups }

uncertainty-of-parameter = u({ $parameter }) = { FIXED($u, 3) } { $unit }

uncertainty-of-ratio = u({ $parameter }) = { SCIENTIFIC($u, 1) }

parameter-group = { $first } et { $second }

parameter-groups = { $first } ; { $others }

separate-parameters = mesurer des poses dans lesquelles ces paramètres agissent différemment

separate-parameters-by-joints = mesurer des poses sur une plus grande plage de { $joints }, dans lesquelles ces paramètres agissent différemment

too-many-positions = impossible de choisir { $positions } positions parmi { $candidates } candidates
    .expected = un nombre de 1 à { $candidates }

start-pose-unknown = la pose de départ { $pose } n’est pas une pose candidate
    .hint = utiliser des poses du tableau des poses candidates

start-too-large = le choix de départ compte { $start } poses candidates, plus que les { $positions } positions à choisir
    .hint = indiquer moins de poses de départ, ou choisir plus de positions

study-too-few-positions = { $positions } positions ne suffisent pas à déterminer tous les paramètres
    .hint = choisir plus de positions

no-candidates = il n’y a pas de poses candidates
    .hint = vérifier le tableau des poses candidates

candidates-unreachable = aucune pose candidate n’est à portée : pose { $pose } ({ $reason })
    .hint = vérifier les valeurs articulaires, leurs unités et les limites du robot

candidates-left-out = { $count ->
        [one] { $count } pose candidate est hors de portée et n’est jamais choisie
       *[other] { $count } poses candidates sont hors de portée et ne sont jamais choisies
    } : { $candidates }

candidate-violation = pose { $pose } ({ $reason })

at-geometric-step = { $step ->
        [lead-1] pas de l’actionneur 1
        [lead-2] pas de l’actionneur 2
        [lead-3] pas de l’actionneur 3
        [base] repère de la base
        [mobile] repère mobile
        [shaft] arbre
       *[offsets] décalages
    } : { $message }

geometric-step-alone = { $step ->
        [shaft] l’arbre nécessite l’arc de la bille N
       *[offsets] le déplacement de l’actionneur 1 nécessite l’arc de la bille N, la plate-forme tournée et l’arbre
    }
    .hint = mesurer les étapes manquantes, ou omettre cette étape

geometry-incomplete = la géométrie complète nécessite l’arc de la bille N, la plate-forme tournée, l’arbre dans deux positions et un déplacement de l’actionneur 1
    .expected = au moins une répétition de chaque étape

ball-unmoved = { $ball ->
        [R] la bille R n’a pas bougé pendant que l’actionneur 2 allait en fin de course
       *[K] la bille K a bougé de moins de 1 mm selon x pendant que l’actionneur 1 allait en fin de course
    }
    .hint = mesurer de nouveau la bille { $ball } après avoir déplacé le seul actionneur { $actuator } jusqu’en fin de course

lead-undetermined = ces positions ne déterminent pas le pas de l’actionneur
    .expected = au moins trois lectures, pour deux déplacements commandés ou plus

shaft-positions-parallel = les deux positions de l’arbre sont parallèles : leurs axes ne se coupent pas
    .hint = entre les deux, déplacer le seul actionneur 2 jusqu’en fin de course

points-undetermined = ces points ne déterminent pas l’élément ajusté
    .hint = répartir les positions sur toute la course ou sur tout l’angle de rotation

slip-reversed = { $joint } inversé

slip-exchanged = { $first } et { $second } intervertis
slip-branches-exchanged = les cibles de { $first } et { $second } interverties

slip-joint-order = les articulations { $order ->
        [reversed] dans l’ordre inverse
        [left] décalées d’un rang
       *[right] décalées d’un rang dans l’autre sens
    }

slip-joint-block = les articulations { $first } à { $last } { $order ->
        [left] décalées d’un rang
       *[right] décalées d’un rang dans l’autre sens
    }

slip-offset = { $degrees } deg ajoutés à { $joint }

slip-unit = { $quantity ->
        [all-joints] toutes les articulations
        [joints-of-kind] toutes les articulations de ce type
        [lengths] toutes les longueurs mesurées
        [distances] les distances mesurées
        [points] les points mesurés
       *[other] { $quantity }
    } { $slip ->
        [m-mm] en mètres au lieu de millimètres
        [mm-m] en millimètres au lieu de mètres
        [inch-mm] en pouces au lieu de millimètres
        [mm-inch] en millimètres au lieu de pouces
        [rad-deg] en radians au lieu de degrés
        [gon-deg] en grades au lieu de degrés
        [deg-gon] en degrés au lieu de grades
       *[deg-rad] en degrés au lieu de radians
    }

slip-unit-of-targets = les points mesurés de { $targets } { $slip ->
        [m-mm] en mètres au lieu de millimètres
        [mm-m] en millimètres au lieu de mètres
        [inch-mm] en pouces au lieu de millimètres
       *[mm-inch] en millimètres au lieu de pouces
    }

slip-points = { $change ->
        [mirrored] les points mesurés inversés par symétrie (un repère indirect, ou deux coordonnées interverties)
        [exchanged] x et y des points mesurés intervertis
        [x] x des points mesurés inversé
       *[y] y des points mesurés inversé
    }

slip-poses-inverse = inverse des poses mesurées (pose de l’instrument dans le repère de la cible)
slip-targets = les cibles { $first } et { $second } interverties
slip-fixtures-exchanged = les points ou surfaces { $first } et { $second } intervertis

slip-neighbour = les valeurs articulaires de chaque pose prises à la pose { $neighbour ->
        [previous] précédente
       *[next] suivante
    }

slip-world-frame = le repère atelier tourné de { FIXED($angle_deg, 1) } deg et décalé de ({ FIXED($x_mm, 1) } ; { FIXED($y_mm, 1) }) mm

slip-reading = la lecture de `{ $target }` à la pose { $pose } omise
slip-pair = { $first }, et { $second }
slip-nominal = `{ $parameter }` = { FIXED($found, 2) } { $unit } au lieu de { FIXED($nominal, 2) } { $unit }

with-slip = { $slip }{ $origin ->
        [none] {""}
       *[other] {" "}({ $origin })
    }

set-up-slip = { $others ->
        [none] une modification explique les mesures : { $first }
       *[other] chacune de ces modifications explique les mesures : { $first } ; { $others }
    }. { $stated ->
        [unreachable] Sans modification, des poses sont hors de portée ; avec elle, l’écart-type d’une coordonnée est de { FIXED($changed_mm, 3) } mm
        [angles] L’écart-type des orientations passe de { FIXED($stated_deg, 2) } deg à { FIXED($changed_deg, 2) } deg
        [tolerances] Avec la modification, l’écart-type d’une coordonnée est de { FIXED($changed_mm, 3) } mm, et les paramètres restent dans leurs tolérances
       *[residuals] L’écart-type d’une coordonnée passe de { FIXED($stated_mm, 3) } mm à { FIXED($changed_mm, 3) } mm
    } (aux poses exclues de l’identification) : le vérifier d’abord

index-o1 = O1 = (s1...sm)^(1/m) / sqrt(n), m paramètres, n configurations ; jacobienne en mm par mm, rad et 1
index-o2 = O2 = smin / smax ; jacobienne en mm par mm, rad et 1
index-o3 = O3 = smin ; jacobienne en mm par mm, rad et 1
index-o4 = O4 = smin^2 / smax ; jacobienne en mm par mm, rad et 1
index-o5 = O5 = 1 / (1/s1 + ... + 1/sm) ; jacobienne en mm par mm, rad et 1
index-d = D = (s1...sm)^(1/m) ; jacobienne en mm par mm, rad et 1
index-a = A = 1 / sqrt(tr((J’J)^-1)) ; colonnes de J divisées par leurs normes sur toutes les candidates
index-e = E = smin ; colonnes de J divisées par leurs normes sur toutes les candidates
index-i = I = 1 / moyenne quadratique de l’incertitude-type de position sur toutes les candidates, par mm de bruit

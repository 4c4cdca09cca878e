### Messages de documents ; explications dans en/documents.ftl.

action-load-or-compensate = charger `{ $file }`{ $count ->
        [0] {""}
       *[other] {" "}(ou { $others })
    } dans votre propre logiciel : aucun contrôleur ne lit ce fichier. Pour un contrôleur, ajouter son format à `controllers`, ou corriger ses programmes par `etalon compensate`

limits-for-several-robots = les limites valent pour un seul robot, or le tableau en contient { $robots }
    .hint = soumettre chaque robot séparément à l’essai ; seule l’interchangeabilité est évaluée sur tous les robots ensemble

few-cycles = moins de { $least } cycles { $count ->
        [one] à la pose { $poses }
       *[other] aux poses { $poses }
    }

decide-by-intervals = mesurer 30 cycles (ISO 9283), ou juger avec les intervalles
measure-cycles = mesurer 30 cycles (ISO 9283) : un ou deux cycles n’ont pas d’intervalle

limits-without-instrument = les limites sont jugées sans l’incertitude de l’instrument : U ne contient que la dispersion des cycles
    .hint = indiquer l’incertitude élargie d’une coordonnée mesurée : `--expanded-uncertainty-um`

few-cycles-of-direction = moins de { $least } cycles { $count ->
        [one] dans la direction { $directions }
       *[other] dans les directions { $directions }
    }
    .hint = mesurer plus de cycles

instrument-too-coarse = l’incertitude de mesure dépasse 25 % de la caractéristique évaluée { $count ->
        [one] à la pose { $poses }
       *[other] aux poses { $poses }
    }
    .hint = utiliser la borne supérieure de l’intervalle de RP, ou mesurer avec un meilleur instrument

positions-drift = la position de la pose { $pose } change de { LENGTH($change_mm) } du premier au dernier cycle : AP et RP contiennent cette dérive
    .hint = indiquer `drift_set` dans [poses] (`--drift-set`), ou mettre le robot en température avant l’essai

several-approaches = plusieurs directions d’approche { $count ->
        [one] à la pose { $poses }
       *[other] aux poses { $poses }
    } : les intervalles, les limites et la règle des 25 % valent pour chaque direction
    .hint = utiliser les valeurs de chaque direction d’approche : les valeurs de l’ensemble contiennent vAP

positions-in-other-unit = { $axes } des positions { $table ->
        [commanded] commandées
        [robot] du robot { $robot }
       *[attained] atteintes
    } { $count ->
        [one] est
       *[other] sont
    } en { $unit }, et non en mm : après multiplication par { $length_mm }, l’accord avec l’autre tableau est obtenu
    .hint = { $unit ->
        [cm] multiplier ces colonnes par 10
       *[other] nommer les colonnes par leur unité (`x_{ $unit }`), ou les convertir en mm
    }

coordinates-exchanged = les positions atteintes sont à { FIXED($deviation_mm, 1) } mm des positions commandées ; { $change ->
        [swapped] si { $columns } d’un tableau sont inversés
        [order] si x, y, z sont dans les colonnes { $columns } des positions atteintes
       *[sign] si { $columns } d’un tableau est de signe opposé
    }, il reste { FIXED($left_mm, 3) } mm
    .hint = corriger ces colonnes dans le tableau erroné ; en attendant, AP et AT sont faux, RP de la position est juste

poses-in-other-frame = les positions atteintes sont à { FIXED($deviation_mm, 1) } mm des positions commandées ; sans leur décalage commun de ({ FIXED($x_mm, 1) }, { FIXED($y_mm, 1) }, { FIXED($z_mm, 1) }) mm{ $turned ->
        [turned] {" "}et leur rotation de { FIXED($turn_deg, 1) } deg
       *[shifted] {""}
    }, il reste { FIXED($left_mm, 3) } mm
    .hint = exprimer les deux tableaux dans un même repère ; AP et AT contiennent l’écart entre les repères, RP et RT ne le contiennent pas

deviation-as-large-as-test = les positions atteintes sont à { FIXED($deviation_mm, 1) } mm des positions commandées, soit l’étendue de l’essai ({ FIXED($extent_mm, 1) } mm) ; les plus éloignées : { $poses }
    .hint = vérifier les noms des poses et les colonnes des deux tableaux

angles-in-other-unit = { $count ->
        [one] l’angle { $angles } des poses { $table ->
            [commanded] commandées
           *[attained] atteintes
        } est
       *[other] les angles { $angles } des poses { $table ->
            [commanded] commandées
           *[attained] atteintes
        } sont
    } en radians, et non en degrés : après multiplication par 57,29578, l’accord avec l’autre tableau est obtenu
    .hint = nommer les colonnes par leur unité (`a_rad`), ou les convertir en degrés

angles-far-from-commanded = des angles atteints ({ $angles }) s’écartent jusqu’à { FIXED($deviation_deg, 1) } deg des angles commandés ; plus grands écarts : { $poses }
    .hint = vérifier que les colonnes a, b, c des deux tableaux désignent les mêmes rotations, dans le même ordre et le même repère

rotation-order-unknown = `{ $text }` n’est pas un ordre des rotations a, b, c
    .expected = trois rotations autour de x, y ou z, d’angles a, b et c, multipliées de gauche à droite

rotation-orders = `rotation_order = "Rz(c) Ry(b) Rx(a)"` (option --rotation-order) si a, b, c tournent autour des axes fixes x, y, z ; `rotation_order = "Rz(a) Ry(b) Rx(c)"` s’ils tournent autour de z, y, x du corps mobile
rotation-orders-of-axes = `rotation_order = "{ $by_axis }"` (option --rotation-order) si a, b, c sont les angles autour de x, y, z ; `rotation_order = "{ $by_place }"` si a, b, c sont les angles dans l’ordre de ces axes

readings-outlying = { $count ->
        [one] 1 mesure est loin
       *[other] { $count } mesures sont loin
    } de toutes les autres de la même pose, et AP et RP { $count ->
        [one] la
       *[other] les
    } contiennent : { $readings }{ $more ->
        [0] {""}
       *[other] {" "}et { $more } de plus
    }
    .hint = vérifier désignations et valeurs : ne corriger ou retirer une ligne que si la cause est connue, et noter la raison ; sinon répéter l’essai

outlying-reading = pose { $pose } du cycle { $cycle }, { LENGTH($distance_mm) } (distance médiane { LENGTH($median_mm) })
outlying-reading-near = pose { $pose } du cycle { $cycle }, { LENGTH($distance_mm) } (distance médiane { LENGTH($median_mm) } ; plus près de la pose { $near })

runs-outlying = { $count ->
        [one] 1 passage est loin
       *[other] { $count } passages sont loin
    } de tous les autres de la même position et du même sens, et A et R { $count ->
        [one] le
       *[other] les
    } contiennent : { $runs }{ $more ->
        [0] {""}
       *[other] {" "}et { $more } de plus
    }
    .hint = vérifier ces valeurs : corriger ou supprimer une ligne seulement si la cause est connue, et noter la raison ; sinon répéter l’essai

outlying-run = passage { $run } à { $position_mm } mm dans le sens { $direction }, { FIXED($distance_mm, 4) } mm (distance médiane { FIXED($median_mm, 4) } mm)

runs-repeated = le tableau contient les mêmes passages { $times } fois, chiffre pour chiffre : R et A sont trop petits
    .hint = supprimer les lignes copiées

axis-test-short = l’axe a { $positions } positions avec au moins { $runs } passages dans chaque sens ; l’ISO 230-2 en exige { $least }
    .hint = mesurer au moins { $least } positions avec { $least } passages dans chaque sens

readings-repeated = { $count ->
        [one] 1 mesure répète
       *[other] { $count } mesures répètent
    } une mesure antérieure chiffre pour chiffre : { $readings }{ $more ->
        [0] {""}
       *[other] {" "}et { $more } de plus
    }
    .hint = supprimer les lignes copiées : ce ne sont pas d’autres cycles

repeated-reading = pose { $pose } du cycle { $cycle } comme au cycle { $first }

path-velocity-far = la vitesse moyenne sur la trajectoire est de { FIXED($mean_mm_s, 3) } mm/s, la vitesse commandée de { FIXED($commanded_mm_s, 3) } mm/s
    .hint = indiquer la vitesse commandée en mm/s (`--velocity-mm-s`) et l’horodatage en s

angles-not-separable = les angles { $first } et { $second } { $place } { $order ->
        [stated] ne sont pas séparables : leurs rotations ont presque le même axe, et chaque angle seul ne signifie rien
       *[unknown] varient ensemble, bien plus que leur somme ou leur différence : leurs rotations ont presque le même axe, et chaque angle seul ne signifie rien
    }
    .hint = { $order ->
        [stated] utiliser les vecteurs de rotation (AP rx à RP rz), ou enregistrer les angles dans un autre ordre de rotations
       *[unknown] indiquer l’ordre des trois angles des poses (`--rotation-order "Rz(c) Ry(b) Rx(a)"`, dans une campagne `rotation_order`) : les vecteurs de rotation sont alors évalués ; ou enregistrer les angles dans un autre ordre
    }

angles-of-poses = { $count ->
        [one] à la pose { $poses }
       *[other] aux poses { $poses }
    }

angles-of-path = sur la trajectoire

angles-of-standstills = { $count ->
        [one] à l’arrêt commençant à { $times_s } s
       *[other] à { $count } arrêts (commençant à { $times_s } s)
    }

path-without-pass = l’enregistrement ne contient aucun passage de la trajectoire commandée
    .expected = un mouvement à travers { $planes } plans, chacun à moins de { $near_mm } mm de la trajectoire
    .hint = vérifier le repère et le sens de l’enregistrement et de la trajectoire ; `--near-mm` admet de plus grands écarts

samples-too-fast = { $count ->
        [one] { $count } échantillon omis
       *[other] { $count } échantillons omis
    } : vitesse supérieure à celle d’un robot
    .hint = vérifier l’enregistrement à ces lignes : { $lines }

weave-velocity-not-compared = la vitesse commandée n’est pas comparée : la trajectoire est la ligne médiane d’un balayage
    .hint = parcourir la trajectoire sans balayage pour évaluer les vitesses

arrivals-unsettled = arrivées qui ne se stabilisent pas dans la bande limite : à { $times_s } s
    .hint = indiquer une bande limite plus large que le bruit du robot immobile

passes-incomplete = { $count ->
        [one] { $count } passage commencé et inachevé : omis
       *[other] { $count } passages commencés et inachevés : omis
    }
    .hint = vérifier si l’enregistrement est tronqué ; si les angles sont fortement arrondis, indiquer un near_mm plus grand (`--near-mm`)

few-passes = { $count ->
        [one] { $count } passage
       *[other] { $count } passages
    } de la trajectoire, moins de { $least }
    .hint = mesurer { $least } passages (ISO 9283), ou décider d’après les intervalles de AT et RT

corner-in-central-part = la partie centrale de la trajectoire contient un angle à { FIXED($at_mm, 3) } mm
    .hint = indiquer une trajectoire sans angle, ou une partie centrale plus courte : le ralentissement dans l’angle influe sur AV, RV et FV

zone-proved-locally = il est prouvé seulement que la zone minimale est la plus étroite parmi les éléments voisins ({ $element })
    .hint = comparer son écart de forme à celui de l’ajustement par moindres carrés

zone-unproved = une zone plus étroite de l’élément { $element } ne peut être exclue
    .hint = mesurer une plus grande partie de la surface : l’élément se distingue à peine de la dispersion des points

hold-another = pour fixer un autre paramètre du groupe, l’indiquer sous `hold` dans [identify] ; par défaut, le paramètre fixé est celui dont la tolérance déplace le moins les cibles

set-up-origin = { $origin ->
        [unit] `unit` de l’export
       *[world-frame] `unit` et étiquettes des points qui le définissent
    }

check-rigid-part = vérifier l’unité et les noms dans `places_mm`, et si la pièce a été modifiée depuis leur détermination

plan-cube = le plus grand { $shape ->
        [square] carré
       *[cube] cube
    } dans l’espace de travail indiqué, arêtes parallèles aux axes ; C1 à C4 à partir des plus petits x et y
plan-poses = P1 : centre ; P2 à P5 : sur les diagonales du plan d’essai, à 10 % de leur longueur des sommets, dans l’ordre des sommets
plan-clauses = P1 à P5, charges, vitesses et 30 cycles suivent le texte de la norme ; les trajectoires, les autres nombres et l’ordre des sommets n’ont pas été comparés à un exemplaire acheté
plan-reach-not-examined = ni le mouvement de toutes les articulations entre les poses ni l’accessibilité des poses n’ont été examinés
plan-reach = accessibilité : d’après les paramètres nominaux et les limites du fichier de robot ; un seul mode de travail par liste de poses, celui qui en atteint le plus ; { $moves ->
        [all] toutes les articulations bougent entre les poses P1 à P5
       *[some] certaines articulations ne bougent pas entre les poses P1 à P5, alors que la norme l’exige
    }
covariance-not-square = sa covariance n’est pas une matrice carrée à { $identified } lignes, une par paramètre identifié
uncertainty-negative = une incertitude-type ou une variance est négative ou n’est pas un nombre
parameter-listed-twice = il contient deux fois le paramètre `{ $parameter }`

method-levenberg-marquardt = Levenberg-Marquardt avec QR par blocs et colonnes mises à l’échelle, terminé par Gauss-Newton
method-enclosing = plus petit élément englobant, défini par { $points } points
method-minimum-zone = zone minimale (Tchebychev)
action-add-cycles = atteindre { $count ->
        [one] la pose { $poses }
       *[other] les poses { $poses }
    } au moins { $required } fois
action-add-cycles-reason = une pose n’a que { $least } positionnements : les intervalles de AP et de RP sont donc larges
action-add-effect = ajouter `{ $line }` à robot.toml, avant sa première table
action-add-effect-first = ne rien charger encore : ajouter `{ $line }` à robot.toml, avant sa première table, puis relancer
action-add-effect-not-in-file = erreur aux poses omises : { $without } → { $with } (moyenne quadratique). Aucun fichier de contrôleur de cette campagne ne peut contenir { $effect } : ce gain demande un autre format, ou des programmes corrigés par `etalon compensate`
action-add-effect-reason = erreur aux poses omises : { $without } → { $with } (moyenne quadratique)
action-add-validation = mesurer des poses de validation, et les indiquer sous `validation` dans [identify]
action-add-validation-reason = les erreurs aux poses d’étalonnage sont plus petites que les erreurs à de nouvelles poses
action-add-validation-unknown = moyenne quadratique de l’erreur de position : { $calibration } aux poses d’étalonnage, { $left_out } aux poses omises ; seules d’autres poses montrent les erreurs ailleurs
action-agree-rule = convenir avec le client d’une règle de décision : { $limit }
action-agree-rule-reason = la limite est à l’intérieur de U = { $present } ; une décision exige { $required }, soit environ { $times } fois plus de lectures. `decision_rule = "simple-acceptance"` dans [limits] compare la valeur elle-même
action-compensate = si le contrôleur calcule avec la géométrie nominale, ne charger aucun fichier : corriger ses programmes avec `etalon compensate` et `--field { $file }`, qui ajoute les erreurs qu’aucun paramètre ne décrit
action-compensate-reason = moyenne quadratique de l’erreur aux { $count } poses réservées : { $without } → { $with }
action-verify = vérifier le fichier chargé : commander quelques poses avec lui, les mesurer et comparer leurs erreurs à l’erreur attendue. Si elles sont plus grandes, rétablir le fichier précédent du contrôleur
action-verify-moved = le chargement déplace les positions apprises de { $change } au plus aux poses mesurées (bride dans le référentiel de la base, pose { $pose }) : vérifier les dégagements et réapprendre les pièces. { $count ->
        [0] Nommer le fichier sauvegardé `controller_backup` dans [conditions] : le rapport donne alors son SHA-256
       *[other] Le fichier précédent est `{ $file }` ; la même section donne son SHA-256
    }
action-verify-reason = sauvegarder le fichier précédent avant le chargement ; `controller_backup` dans [conditions] ajoute son SHA-256
action-verify-at-pose = vérifier le chargement à la pose { $pose } : « Vérification après chargement et retour » donne la pose affichée et sa tolérance. Si elle diffère, rétablir le fichier précédent du contrôleur
action-verify-software-at-pose = vérifier le fichier dans votre logiciel, ou le premier programme corrigé, à la pose { $pose } : « Vérification après chargement et retour » donne les poses et la tolérance. Si elles diffèrent, rétablir l’état précédent
action-verify-backup = le fichier précédent est `{ $file }` ; la même section donne son SHA-256
action-finer-instrument = mesurer avec une incertitude élargie d’une position de { $uncertainty } au plus
action-finer-instrument-reason = à la pose { $pose }, U = { $uncertainty } représente { $percent } % de la caractéristique ; l’ISO 9283 admet 25 %, ce que { $count ->
        [one] la pose { $poses } dépasse
       *[other] les poses { $poses } dépassent
    }
action-keep-nominal = { $count ->
        [0] garder les paramètres nominaux
       *[other] ne pas charger { $formats }
    }
action-keep-nominal-reason = erreur RMS { $rms }, maximale { $max } ; paramètres nominaux : { $nominal_rms } et { $nominal_max }
action-load = sauvegarder l’état du contrôleur, puis charger `{ $file }`{ $count ->
        [0] {""}
       *[other] {" "}(ou { $others })
    }
action-load-reason = moyenne quadratique de l’erreur ({ $quantity }) aux { $count } poses { $set ->
        [validation] de validation
        [held-out] d’étalonnage omises
       *[calibration] d’étalonnage
    } : nominale { $nominal }, avec ce fichier { $expected }
action-load-with-inputs = { $action }. Le logiciel qui applique le fichier doit l’évaluer à chaque pose avec { $inputs } : les valeurs articulaires seules ne suffisent pas
action-load-synthetic = charger `{ $file }`{ $count ->
        [0] {""}
       *[other] {" "}(ou { $others })
    } dans un contrôleur simulé, non dans un robot : les données sont synthétiques
action-load-synthetic-software = charger `{ $file }`{ $count ->
        [0] {""}
       *[other] {" "}(ou { $others })
    } dans votre propre logiciel, sans déplacer de robot : les données sont synthétiques, et aucun contrôleur ne lit ce fichier
action-measure-again = mesurer de nouveau { $count ->
        [one] la pose { $poses }
       *[other] les poses { $poses }
    }{ $more ->
        [0] {""}
        [one] {" "}(1 autre pose en désaccord)
       *[other] {" "}({ $more } autres poses en désaccord)
    }
action-measure-again-reason = la pose { $pose } est en désaccord avec les autres : { $error }, { $times } σ
action-measure-quantity = mesurer la grandeur de `{ $limit }` aux poses décisives, ou supprimer la limite
action-measure-quantity-reason = une limite sur une grandeur non mesurée ne peut pas être évaluée
action-meet-limit = chercher la cause des erreurs : { $limit }
action-meet-limit-at-pose = chercher la cause de l’erreur à la pose { $pose } : { $limit }
action-meet-limit-reason = { $value }, limite { $limit } : dépassement de { $beyond }
action-use-all-parameters = faire utiliser tous les paramètres identifiés par le contrôleur, par un autre format ou par `etalon compensate` : { $limit }
action-use-all-parameters-reason = { $value } avec les valeurs de ce fichier, { $whole } avec tous les paramètres identifiés ; limite { $limit }
action-prove-effects = indiquer `{ $line }` dans [identify]
action-prove-effects-first = ne rien charger encore : indiquer `{ $line }` dans [identify], puis relancer
action-reduce-uncertainty = réduire l’incertitude de mesure : { $limit }
action-reduce-uncertainty-by-source = U = { $present } ; pour décider, il faut { $required } ; plus grande contribution : { $source } ({ $percent } %)
action-reduce-uncertainty-reason = U = { $present } ; pour décider, il faut { $required }
action-resolve = décider de la suite à donner à cet avertissement
action-run-again = après une modification, relancer, et ne charger qu’un fichier que le nouveau verdict nomme
action-run-again-backup = d’ici là, le contrôleur garde ses valeurs. Si des valeurs de cette campagne sont chargées, rétablir `{ $file }`
action-run-again-reason = d’ici là, le contrôleur garde ses valeurs. Si des valeurs de cette campagne sont chargées, rétablir le fichier précédent du contrôleur
action-state-limits = indiquer la tolérance de l’application dans [limits]
action-state-limits-reason = sans limites, il n’y a pas de verdict
action-state-limits-to-accept = seules des limites montrent si l’exactitude suffit à l’application
action-warm-up = mettre le robot en température avant l’essai, et indiquer `warm_up_minutes`
action-warm-up-cold = le robot a été essayé à froid
action-warm-up-drift = AP de la pose { $pose } varie de { $change } de la première à la dernière de { $sets } séries de cycles, et la stabilisation n’est pas démontrée

field-of-other-robot = le champ résiduel est celui d’un autre robot : `{ $name }`
    .hint = utiliser le field.json de l’exécution qui a identifié ce robot

field-inconsistent = le champ résiduel est incohérent
    .hint = relancer la campagne

field-needs-positions = les lectures d’un champ résiduel sont des positions de cibles, sans conditions, pièces rigides, plates-formes ni covariances indiquées
field-needs-poses = { $poses ->
        [one] { $poses } pose
       *[other] { $poses } poses
    } ; un champ résiduel en exige { $needed }
field-readings-suspect = à la pose réservée { $pose }, l’erreur avec le champ est de { FIXED($error_mm, 3) } mm, plus de 8 fois la médiane de toutes les poses : ses lectures sont douteuses
field-undetermined = les positions ne déterminent pas les paramètres dans chaque partie des poses
field-not-shown = les résidus ne dépendent pas significativement des articulations : la vraisemblance augmente de { FIXED($rise, 1) }, alors que { FIXED($threshold, 1) } est exigé (−2 ln L)
field-not-proven = aux poses réservées, l’erreur de position est de { FIXED($without_mm, 3) } mm sans le champ et de { FIXED($with_mm, 3) } mm avec lui (moyenne quadratique) ; le gain est de { FIXED($gain, 1) } fois son incertitude-type, alors que 2,3 fois sont exigées

zeros-of-the-joints = zéros des articulations
geometry = géométrie
gains = gains
harmonics-of-the-transmissions = harmoniques des transmissions
backlash = jeu
coupling = couplage
bending = flexion
payload-bending = flexion sous la charge
torque-bending = flexion sous les couples des articulations
expansion-with-temperature = dilatation avec la température
drift-with-temperature = dérive des zéros avec la température
lateral-bending = basculement des articulations en travers de leurs axes
pedestal-bending = basculement de la base sous le bras
reading-payload-mass = charge
reading-payload-centre = centre de la charge dans la bride
reading-torque = couples des articulations
reading-temperature = température du robot
reading-in-unit = { $quantity } ({ $unit })

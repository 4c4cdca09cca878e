### Messages de documents ; explications dans en/documents.ftl.

action-load-or-compensate = charger `{ $file }`{ $count ->
        [0] {""}
       *[other] {" "}(ou { $others })
    } dans votre propre logiciel ; pour une commande à géométrie nominale, corriger ses programmes par `etalon compensate`

limits-for-several-robots = les limites valent pour un seul robot, or le tableau en contient { $robots }
    .hint = vérifier chaque robot séparément ; ensemble, ils donnent l’interchangeabilité

few-cycles = moins de { $least } cycles { $count ->
        [one] à la pose { $poses }
       *[other] aux poses { $poses }
    }
    .hint = mesurer 30 cycles (ISO 9283), ou juger avec les intervalles

few-cycles-of-direction = moins de { $least } cycles { $count ->
        [one] dans la direction { $directions }
       *[other] dans les directions { $directions }
    }
    .hint = mesurer plus de cycles

instrument-too-coarse = l’incertitude de mesure dépasse 25 % de la caractéristique évaluée { $count ->
        [one] à la pose { $poses }
       *[other] aux poses { $poses }
    }
    .hint = utiliser les valeurs comme majorants, ou mesurer avec un meilleur instrument

positions-drift = la position de la pose { $pose } change de { FIXED($change_mm, 3) } mm du premier au dernier cycle : AP et RP contiennent cette dérive
    .hint = indiquer `drift_set` dans [poses] (`--drift-set`), ou chauffer le robot avant l’essai

several-approaches = plusieurs directions d’approche { $count ->
        [one] à la pose { $poses }
       *[other] aux poses { $poses }
    } : AP, RP et leurs intervalles valent pour l’ensemble des positionnements
    .hint = utiliser les valeurs de chaque direction d’approche : celles de l’ensemble contiennent vAP, et leur dispersion n’est pas gaussienne

positions-in-other-unit = { $axes } des positions { $table ->
        [commanded] commandées
        [robot] du robot { $robot }
       *[attained] atteintes
    } { $count ->
        [one] est
       *[other] sont
    } en { $unit }, et non en mm : multiplié par { $length_mm }, l’accord avec l’autre tableau est obtenu
    .hint = nommer les colonnes par leur unité (`x_m`), ou les convertir en mm

poses-in-other-frame = les positions atteintes sont à { FIXED($deviation_mm, 1) } mm des positions commandées, car les tableaux sont dans des référentiels différents : après un décalage du centre de ({ FIXED($x_mm, 1) }, { FIXED($y_mm, 1) }, { FIXED($z_mm, 1) }) mm{ $turned ->
        [turned] {" "}et une rotation de { FIXED($turn_deg, 1) } deg
       *[shifted] {""}
    }, il reste { FIXED($left_mm, 3) } mm
    .hint = exprimer les deux tableaux dans un même référentiel ; AP et AT contiennent l’écart des référentiels, RP et RT non

deviation-as-large-as-test = les positions atteintes sont à { FIXED($deviation_mm, 1) } mm des positions commandées, autant que l’étendue de l’essai ({ FIXED($extent_mm, 1) } mm) ; les plus éloignées : { $poses }
    .hint = vérifier les noms des poses et les colonnes des deux tableaux

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
    .hint = vérifier le référentiel et le sens de l’enregistrement et de la trajectoire ; `--near-mm` admet de plus grands écarts

samples-too-fast = { $count ->
        [one] { $count } échantillon omis
       *[other] { $count } échantillons omis
    } : vitesse impossible pour un robot
    .hint = vérifier ces lignes : { $lines }

weave-velocity-not-compared = la vitesse commandée n’est pas comparée : la trajectoire est la ligne médiane d’un balayage
    .hint = parcourir la trajectoire sans balayage pour évaluer les vitesses

arrivals-unsettled = arrivées qui ne se stabilisent pas dans la bande limite : à { $times_s } s
    .hint = indiquer une bande limite plus large que le bruit du robot immobile

passes-incomplete = { $count ->
        [one] { $count } passage commencé et inachevé : omis
       *[other] { $count } passages commencés et inachevés : omis
    }
    .hint = vérifier si l’enregistrement est tronqué ; si les angles sont fortement arrondis, indiquer un near_mm plus grand (`--near-mm`)

corner-in-central-part = la partie centrale de la trajectoire contient un angle à { FIXED($at_mm, 3) } mm
    .hint = indiquer une trajectoire sans angle, ou une partie centrale plus courte : le ralentissement dans l’angle influe sur AV, RV et FV

zone-proved-locally = il est prouvé seulement que la zone minimale est la plus étroite parmi les éléments voisins ({ $element })
    .hint = comparer son écart de forme à celui de l’ajustement par moindres carrés

zone-unproved = une zone plus étroite de l’élément { $element } ne peut être exclue
    .hint = mesurer une plus grande partie de la surface : des points aussi dispersés caractérisent mal l’élément

hold-another = pour fixer un autre paramètre du groupe, l’indiquer sous `hold` dans [identify] ; par défaut, c’est celui dont la tolérance déplace le moins les cibles

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
plan-reach-not-examined = non examiné : si le robot atteint les poses, et si toutes les articulations bougent entre elles
plan-reach = portée : d’après les paramètres nominaux et les limites du fichier de robot ; entre plusieurs modes de travail, celui qui atteint le plus de poses d’une liste est conservé pour toute la liste ; { $moves ->
        [all] toutes les articulations bougent entre P1 et P5
       *[some] certaines articulations ne bougent pas entre P1 et P5, alors que la norme l’exige de toutes
    }
covariance-not-square = sa covariance n’est pas carrée, avec { $identified } lignes, une par paramètre identifié
uncertainty-negative = une incertitude-type ou une variance est négative ou n’est pas un nombre
parameter-listed-twice = il contient deux fois le paramètre `{ $parameter }`

method-levenberg-marquardt = Levenberg-Marquardt avec QR par blocs et colonnes mises à l’échelle, terminé par Gauss-Newton
method-enclosing = plus petit élément englobant, défini par { $points } points
method-minimum-zone = zone minimale (Tchebychev)
action-add-cycles = mesurer { $count ->
        [one] la pose { $poses }
       *[other] les poses { $poses }
    } au moins { $required } fois
action-add-cycles-reason = le plus petit nombre de positionnements à une pose est { $least } : les intervalles de AP et de RP sont donc larges
action-add-effect = ajouter `{ $line }` à robot.toml
action-add-effect-reason = erreur aux poses omises : { $without } → { $with } (moyenne quadratique)
action-add-validation = mesurer des poses de validation, et les indiquer sous `validation` dans [identify]
action-add-validation-reason = les erreurs aux seules poses d’étalonnage sont plus petites qu’aux nouvelles poses
action-agree-rule = convenir avec le client d’une règle de décision : { $limit }
action-agree-rule-reason = la limite est à l’intérieur de U = { $present } ; une décision exige { $required }, soit environ { $times } fois plus de mesures. `decision_rule = "simple-acceptance"` dans [limits] compare la valeur elle-même
action-compensate = si la commande calcule avec la géométrie nominale, ne charger aucun fichier : corriger ses programmes avec `etalon compensate` et `--field { $file }`, qui ajoute les erreurs qu’aucun paramètre ne décrit
action-compensate-reason = moyenne quadratique de l’erreur aux { $count } poses réservées : { $without } → { $with }
action-verify = vérifier le chargement : à quelques poses, comparer la pose affichée par la commande avec `etalon kinematics direct` pour parameters.json. Si elles diffèrent, rétablir le fichier que la commande avait
action-verify-reason = sauvegarder ce fichier avant le chargement. Plus tard, `etalon verify` indique à partir de quelques poses mesurées si la base ou le robot ont changé ; `--candidates` choisit ces poses
action-finer-instrument = mesurer avec une incertitude élargie d’au plus { $uncertainty }
action-finer-instrument-reason = à la pose { $pose }, U = { $uncertainty } représente { $percent } % de la caractéristique ; l’ISO 9283 admet 25 %, ce que { $count ->
        [one] la pose { $poses } dépasse
       *[other] les poses { $poses } dépassent
    }
action-keep-nominal = { $count ->
        [0] garder les paramètres nominaux
       *[other] ne pas charger { $formats }
    }
action-keep-nominal-reason = erreur RMS { $rms }, maximale { $max } ; paramètres nominaux : { $nominal_rms } et { $nominal_max }
action-load = charger `{ $file }`{ $count ->
        [0] {""}
       *[other] {" "}(ou { $others })
    }
action-load-reason = erreur quadratique moyenne ({ $quantity }) sur { $count } poses { $set ->
        [validation] de validation
       *[calibration] d’étalonnage
    } : nominale { $nominal }, identifiée { $expected }
action-load-synthetic = charger `{ $file }`{ $count ->
        [0] {""}
       *[other] {" "}(ou { $others })
    } dans un système de commande simulé, non dans un robot : les données sont synthétiques
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
action-measure-quantity-reason = la limite d’une grandeur non mesurée ne peut pas être évaluée
action-meet-limit = chercher la cause des erreurs : { $limit }
action-meet-limit-at-pose = chercher la cause de l’erreur à la pose { $pose } : { $limit }
action-meet-limit-reason = { $value }, limite { $limit } : dépassement de { $beyond }
action-prove-effects = indiquer `{ $line }` dans [identify]
action-reduce-uncertainty = réduire l’incertitude de mesure : { $limit }
action-reduce-uncertainty-by-source = U = { $present } ; pour décider, il faut { $required } ; plus grande contribution : { $source } ({ $percent } %)
action-reduce-uncertainty-reason = U = { $present } ; pour décider, il faut { $required }
action-resolve = traiter cet avertissement
action-state-limits = indiquer la tolérance de l’application dans [limits]
action-state-limits-reason = sans limites, il n’y a pas de verdict
action-warm-up = mettre le robot en température avant l’essai, et indiquer `warm_up_minutes`
action-warm-up-cold = le robot a été essayé à froid
action-warm-up-drift = dérive de AP : { $change } en { $cycles } cycles, sans stabilisation

field-of-other-robot = le champ résiduel est celui d’un autre robot : `{ $name }`
    .hint = utiliser le field.json de l’exécution qui a identifié ce robot

field-inconsistent = le champ résiduel est incohérent
    .hint = relancer la campagne

field-needs-positions = les lectures d’un champ résiduel sont des positions de cibles, sans conditions, pièces rigides, plateformes ni covariances indiquées
field-needs-poses = { $poses ->
        [one] { $poses } pose
       *[other] { $poses } poses
    } ; un champ résiduel en demande { $needed }
field-readings-suspect = à la pose réservée { $pose }, l’erreur avec le champ est de { FIXED($error_mm, 3) } mm, plus de 8 fois la médiane de toutes les poses : ses lectures sont douteuses
field-undetermined = les positions ne déterminent pas les paramètres dans chaque partie des poses
field-not-shown = les résidus ne dépendent pas visiblement des articulations : la vraisemblance augmente de { FIXED($rise, 1) }, et { FIXED($threshold, 1) } est requis (−2 ln L)
field-not-proven = aux poses réservées, l’erreur de position est de { FIXED($without_mm, 3) } mm sans le champ et de { FIXED($with_mm, 3) } mm avec lui (moyenne quadratique) ; le gain est de { FIXED($gain, 1) } fois son incertitude-type, et 2,3 sont requis

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

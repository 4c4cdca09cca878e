### Messages de standards ; explications dans en/standards.ftl.

characteristic = { $name ->
        [bootstrap] bootstrap
        [ap-interval] intervalle de AP
        [rp-interval] intervalle de RP
        [commanded-path] trajectoire commandée
        [exchangeability] interchangeabilité
        [reading-noise] bruit des lectures
        [rp-without-noise] répétabilité sans bruit
        [pose-repeatability] répétabilité de pose
        [reference-targets] cibles de référence
        [error-ellipsoid] ellipsoïde d’erreur
        [pose-accuracy] exactitude de pose
        [coplanarity] coplanéité
        [distance] distance
        [variation] variation multidirectionnelle de l’exactitude de pose
        [static-compliance] compliance statique
        [path-accuracy-interval] intervalle de l’exactitude de trajectoire
        [path-repeatability-interval] intervalle de la répétabilité de trajectoire
        [cornering] écarts aux angles
        [path-repeatability] répétabilité de trajectoire
        [path-accuracy] exactitude de trajectoire
        [path-velocity] vitesse de trajectoire
       *[drift] dérive
    }

too-few-positions = { $of } : { $count ->
        [one] { $count } position atteinte
       *[other] { $count } positions atteintes
    }
    .expected = au moins { $least }
    .hint = mesurer plus de cycles

position-not-finite = { $of } : la position { $number } n’est pas finie
    .hint = supprimer ou corriger cette position

too-few-passes = { $of } : { $count ->
        [0] aucun passage complet
        [one] { $count } passage complet
       *[other] { $count } passages complets
    } de la trajectoire
    .expected = au moins { $least }
    .hint = enregistrer plus de passages de la trajectoire

passes-of-other-path = { $of } : les passages appartiennent à une autre trajectoire
    .hint = chercher et évaluer les passages qui ont les mêmes points commandés

passes-need-points = les passages d’une trajectoire nécessitent deux points commandés et une distance positive
    .hint = indiquer deux points commandés et une distance positive

workspace-not-box = l’espace de travail n’est pas un parallélépipède
    .expected = les plus petits x, y, z, puis les plus grands

angle-count = { $option } a { $count ->
        [one] { $count } angle
       *[other] { $count } angles
    }
    .expected = { $angles }

planar-test-plane = un robot plan n’a qu’un plan d’essai
    .hint = omettre le plan d’essai

test-plane-unknown = plan d’essai inconnu `{ $name }`
    .expected = { $planes }

standstill-thresholds = le rayon et la durée d’un arrêt doivent être positifs
    .hint = indiquer un rayon supérieur au bruit du robot immobile et une durée inférieure à l’arrêt le plus court

in-sample = échantillon { $sample } : { $message }

stream-too-short = un mouvement enregistré comporte au moins deux échantillons avec les mêmes colonnes
    .hint = enregistrer de nouveau le mouvement

stream-value-missing = une coordonnée ou l’instant manque ou n’est pas fini
    .hint = supprimer cet échantillon

time-not-increasing = le temps n’est pas croissant : { $later_s } s après { $earlier_s } s
    .hint = trier les lignes par instant et supprimer les doubles, ou enregistrer avec un horodatage plus fin

weave-direction = balayage : l’oscillation n’a pas de composante transversale à la ligne médiane
    .hint = indiquer une direction transversale à la ligne médiane

weave-command = balayage : la course et la fréquence commandées doivent être positives
    .hint = indiquer la course et la fréquence commandées

weave-without-samples = balayage : aucun échantillon
    .hint = vérifier où le balayage commence et où il finit

weave-too-few-turns = balayage : { $turns ->
        [one] { $turns } inversion
       *[other] { $turns } inversions
    }
    .expected = au moins cinq, espacées d’un quart de la course commandée
    .hint = enregistrer un balayage plus long

corner-without-points = écarts aux angles : la moitié d’un côté adjacente à l’angle ne contient aucun point commandé
    .hint = indiquer plus de points commandés

path-without-reorientation = exactitude de trajectoire lors d’une réorientation : aucun angle commandé ne change
    .hint = indiquer les angles commandés de la trajectoire

commanded-angle-missing = trajectoire commandée : un angle manque ou n’est pas fini
    .hint = indiquer tous les angles à chaque point, ou aucun

commanded-point-repeated = trajectoire commandée : les points { $first } et { $second } sont identiques
    .hint = supprimer l’un des deux points

velocity-not-positive = vitesse de trajectoire : la vitesse commandée doit être positive
    .hint = indiquer la vitesse commandée

velocity-too-few-points = vitesse de trajectoire : moins de trois points commandés dans la partie centrale
    .hint = indiquer plus de points commandés, ou une partie centrale plus grande

too-few-of = { $of } : { $sets }
    .expected = au moins { $least }
    .hint = compléter les mesures

sets-of-cycles = { $count ->
        [one] { $count } série de cycles
       *[other] { $count } séries de cycles
    }

poses = { $count ->
        [one] { $count } pose
       *[other] { $count } poses
    }

approaches = { $count ->
        [one] { $count } direction d’approche
       *[other] { $count } directions d’approche
    }

epochs = { $count ->
        [0] aucune mesure
       *[other] { $count } mesures
    }

robots-at-other-poses = interchangeabilité : les robots n’ont pas les mêmes poses
    .expected = au moins deux robots, chacun à toutes les poses

robot-without-pose = interchangeabilité : le robot `{ $robot }` n’a pas atteint la pose { $pose }
    .expected = chaque robot à chaque pose

visits-read-once = répétabilité sans bruit : aucun positionnement n’a deux lectures
    .hint = faire plusieurs lectures à chaque positionnement : elles déterminent le bruit de l’instrument

coplanar-poses-on-line = coplanéité : trois des quatre positions moyennes sont alignées
    .hint = indiquer quatre poses qui définissent un plan

distance-counts-differ = distance : les deux poses ont { $first } et { $second } positions
    .expected = les deux poses dans les mêmes cycles

force-not-positive = compliance statique : une force n’est pas positive
    .expected = la valeur de la force ; sa direction donne le signe

unloaded-position-missing = direction { $direction }, cycle { $cycle } : aucune ligne sans force
    .hint = enregistrer la position sans charge avec une force de 0

force-missing = aucune ligne n’indique de force
    .hint = indiquer la force de chaque ligne en charge
no-working-mode-reaches = aucun mode de travail ne l’atteint dans les limites

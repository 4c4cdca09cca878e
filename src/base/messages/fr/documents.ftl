### Messages de documents ; explications dans en/documents.ftl.

limits-for-several-robots = les limites valent pour un robot, et le tableau en a { $robots }
    .hint = vérifier chaque robot séparément ; ensemble, ils donnent l’interchangeabilité

few-cycles = moins de { $least } cycles à la pose { $poses }
    .hint = mesurer 30 cycles (ISO 9283), ou juger avec les intervalles

few-cycles-of-direction = moins de { $least } cycles dans la direction { $directions }
    .hint = mesurer plus de cycles

instrument-too-coarse = l’incertitude de mesure dépasse 25 % de la valeur vérifiée à la pose { $poses }
    .hint = utiliser les valeurs comme bornes supérieures, ou mesurer avec un meilleur instrument

several-approaches = plusieurs approches à la pose { $poses } : AP, RP et leurs intervalles sont ceux de toutes les visites
    .hint = utiliser les valeurs de chaque approche : celles de toutes les visites contiennent vAP, et leur dispersion n’est pas gaussienne

path-without-pass = l’enregistrement ne contient aucun passage de la trajectoire commandée
    .expected = un mouvement à travers { $planes } plans, chacun à moins de { $near_mm } mm de la trajectoire
    .hint = vérifier le repère et le sens de l’enregistrement et de la trajectoire ; `--near-mm` admet de plus grands écarts

samples-too-fast = { $count ->
        [one] { $count } échantillon omis
       *[other] { $count } échantillons omis
    } : plus rapide qu’un robot
    .hint = vérifier la ligne { $lines }

weave-velocity-not-compared = la vitesse commandée n’est pas comparée : la trajectoire est la ligne médiane d’un balayage
    .hint = parcourir la trajectoire sans balayage pour évaluer les vitesses

arrivals-unsettled = arrivées qui ne se stabilisent pas dans la bande limite : à { $times_s } s
    .hint = indiquer une bande limite plus large que le bruit du robot immobile

passes-incomplete = { $count ->
        [one] { $count } passage commencé et inachevé : omis
       *[other] { $count } passages commencés et inachevés : omis
    }
    .hint = vérifier si l’enregistrement est coupé ; si les angles sont très arrondis, indiquer un near_mm plus grand (`--near-mm`)

corner-in-central-part = la partie centrale de la trajectoire contient un angle à { FIXED($at_mm, 3) } mm
    .hint = indiquer une trajectoire sans angle, ou une partie centrale plus petite : le ralentissement affecte AV, RV et FV

zone-proved-locally = la zone minimale est prouvée la plus étroite parmi les éléments voisins ({ $element }) seulement
    .hint = comparer son écart de forme à celui de l’ajustement par moindres carrés

zone-unproved = il n’est pas prouvé qu’aucun autre élément { $element } n’ait une zone plus étroite
    .hint = mesurer une plus grande partie de la surface : des points aussi dispersés montrent à peine l’élément

hold-another = pour imposer un autre paramètre d’un tel groupe, le nommer sous `hold` dans [identify] ; par défaut, c’est le dernier du modèle

set-up-origin = { $origin ->
        [unit] `unit` de l’export
       *[world-frame] `unit` et étiquettes des points qui le définissent
    }

check-rigid-part = vérifier l’unité et les noms dans `places_mm`, et si la pièce a été modifiée depuis leur détermination

points-set-aside = { $count ->
        [one] 1 point est écarté
       *[other] { $count } points sont écartés
    } : { $points }
    .hint = ils sont plus loin de l’élément de tous les autres que le bruit ne l’explique

foreign-points = { $count ->
        [one] 1 point est loin de l’élément de tous les autres ({ $points }) et décale
       *[other] { $count } points sont loin de l’élément de tous les autres ({ $points }) et décalent
    } l’ajustement de { FIXED($shift, 1) } incertitudes-types
    .hint = les examiner ; `--robust` les écarte

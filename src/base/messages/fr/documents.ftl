### Messages de documents ; explications dans en/documents.ftl.

limits-for-several-robots = les limites valent pour un seul robot, or le tableau en contient { $robots }
    .hint = vérifier chaque robot séparément ; ensemble, ils donnent l’interchangeabilité

few-cycles = moins de { $least } cycles (poses : { $poses })
    .hint = mesurer 30 cycles (ISO 9283), ou juger avec les intervalles

few-cycles-of-direction = moins de { $least } cycles (directions : { $directions })
    .hint = mesurer plus de cycles

instrument-too-coarse = l’incertitude de mesure dépasse 25 % de la caractéristique évaluée (poses : { $poses })
    .hint = utiliser les valeurs comme majorants, ou mesurer avec un meilleur instrument

several-approaches = plusieurs directions d’approche (poses : { $poses }) : AP, RP et leurs intervalles valent pour l’ensemble des positionnements
    .hint = utiliser les valeurs de chaque direction d’approche : celles de l’ensemble contiennent vAP, et leur dispersion n’est pas gaussienne

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

zone-unproved = il n’est pas prouvé qu’aucun autre élément { $element } n’ait une zone plus étroite
    .hint = mesurer une plus grande partie de la surface : des points aussi dispersés caractérisent mal l’élément

hold-another = pour fixer un autre paramètre d’un tel groupe, l’indiquer sous `hold` dans [identify] ; par défaut, c’est le dernier du modèle

set-up-origin = { $origin ->
        [unit] `unit` de l’export
       *[world-frame] `unit` et étiquettes des points qui le définissent
    }

check-rigid-part = vérifier l’unité et les noms dans `places_mm`, et si la pièce a été modifiée depuis leur détermination

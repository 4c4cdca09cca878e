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

plan-cube = le plus grand { $shape ->
        [square] carré
       *[cube] cube
    } dans l’espace de travail indiqué, arêtes parallèles aux axes ; C1 à C4 à partir des plus petits x et y
plan-poses = P1 : centre ; P2 à P5 : à 10 % des diagonales des sommets du plan d’essai, dans leur ordre
plan-clauses = P1 à P5, charges, vitesses et 30 cycles suivent le texte de la norme ; les trajectoires, les autres nombres et l’ordre des sommets n’ont pas été comparés avec un exemplaire acheté
plan-reach-not-examined = non examiné : si le robot atteint les poses, et si toutes les articulations bougent entre elles
plan-reach = atteinte : paramètres nominaux et limites du fichier du robot ; de plusieurs modes, celui qui atteint le plus d’une liste est gardé le long de celle-ci ; { $moves ->
        [all] toutes les articulations bougent entre P1 et P5
       *[some] toutes les articulations ne bougent pas entre P1 et P5, comme la norme l’exige
    }
covariance-not-square = sa covariance n’est pas carrée avec { $identified } lignes, une par paramètre identifié
uncertainty-negative = une incertitude-type ou variance est négative ou n’est pas un nombre
parameter-listed-twice = il contient deux fois le paramètre `{ $parameter }`

method-levenberg-marquardt = Levenberg-Marquardt par QR par blocs à colonnes normées, fin par Gauss-Newton
method-enclosing = plus petit élément englobant, défini par { $points } points
method-minimum-zone = zone minimale (Tchebychev)

### Messages de fit ; explications dans en/fit.ftl.

element = { $name ->
        [line2d] droite plane (`line2d`)
        [line] droite (`line`)
        [plane] plan (`plane`)
        [circle2d] cercle plan (`circle2d`)
        [circle3d] cercle (`circle3d`)
        [sphere] sphère (`sphere`)
        [cylinder] cylindre (`cylinder`)
        [cone] cône (`cone`)
        [torus] tore (`torus`)
        [enclosing-circle] plus petit cercle circonscrit
        [enclosing-sphere] plus petite sphère circonscrite
        [rigid-transform] transformation rigide
       *[other] { $name }
    }

element-unknown = élément inconnu `{ $name }`

point-uncertainty-not-positive = l’incertitude-type d’un point est { $uncertainty_mm } mm
    .expected = un nombre positif
    .hint = indiquer l’incertitude-type d’un point, ou l’omettre : l’incertitude vient alors des résidus

probe-radius-not-positive = le rayon du palpeur est { $radius } mm
    .expected = un nombre positif
    .hint = indiquer le rayon qualifié du palpeur, pas son diamètre ; l’omettre pour des points de contact

probe-side-needs-direction = intérieur et extérieur ne sont pas définis pour l’élément { $element }
    .expected = la direction de l’élément vers le palpeur
    .hint = indiquer trois nombres, par exemple 0,0,1 pour un palpeur au-dessus

probe-side-needs-inside = une direction ne donne pas le côté du palpeur pour l’élément { $element }
    .expected = inside (alésage) ou outside (arbre)
    .hint = indiquer le côté du palpeur : inside ou outside

probe-direction-zero = le vecteur de direction { $direction } vers le palpeur est nul
    .expected = trois nombres finis, non tous nuls
    .hint = indiquer la direction de la surface vers le palpeur

probe-direction-along-element = la direction { $direction } vers le palpeur est parallèle à l’élément { $element }
    .expected = une direction qui s’écarte de l’élément
    .hint = indiquer la direction de la surface vers le palpeur

probe-larger-than-element = un palpeur de rayon { $probe_mm } mm ne peut pas toucher l’élément { $element } de l’extérieur
    .expected = des centres situés à un rayon supérieur à celui du palpeur ; ce rayon est de { FIXED($centres_mm, 6) } mm
    .hint = indiquer l’autre côté : le palpeur était à l’intérieur

compensated-twice = l’ajustement est déjà corrigé du rayon du palpeur
    .expected = un ajustement aux centres du palpeur
    .hint = ne corriger qu’une fois

held-radius-unsupported = l’élément { $element } n’a pas de rayon
    .expected = pas de rayon
    .hint = omettre le rayon

held-radius-not-positive = le rayon fixé est { $radius } mm
    .expected = un nombre positif
    .hint = indiquer le rayon en millimètres

held-radius-below-probe = un palpeur à l’intérieur de l’élément { $element } de rayon { $radius } mm aurait ses centres au rayon { $centres } mm
    .expected = un palpeur plus petit que le rayon fixé
    .hint = indiquer l’autre côté, ou corriger le rayon

held-axis-unsupported = l’élément { $element } n’a pas d’axe
    .expected = pas d’axe
    .hint = omettre l’axe

held-axis-zero = l’axe fixé { $axis } n’a pas de direction
    .expected = trois nombres, non tous nuls
    .hint = indiquer l’axe

element-ambiguous = un autre élément { $element } s’ajuste presque aussi bien aux points
    .hint = mesurer plus de points là où l’élément n’est pas couvert, ou fixer l’axe

element-not-determined = aucun élément { $element } n’a pu être ajusté : { $termination }
    .expected = des points qui déterminent un élément { $element }
    .hint = vérifier les points (arc trop court, points alignés, autre élément), ou fixer le rayon ou l’axe

zone-flat = pas de zone minimale pour l’élément { $element } : un plan s’ajuste aussi bien aux points
    .expected = des points sur une partie de la surface dont la hauteur dépasse l’écart de forme
    .hint = mesurer une plus grande partie de la surface, ou évaluer la zone minimale d’un plan

zone-straight = pas de zone minimale pour un cercle : une droite s’ajuste aussi bien aux points
    .expected = des points sur un arc dont la flèche dépasse l’écart de forme
    .hint = mesurer un arc plus long, ou évaluer la zone minimale d’une droite

zone-unsupported = la zone minimale de l’élément { $element } n’est pas disponible
    .expected = line2d, plane, circle2d, circle3d, sphere, cylinder ou cone
    .hint = utiliser l’ajustement par moindres carrés

point-counts-differ = impossible d’associer { $from } points à { $to } points
    .expected = le même nombre de points dans le même ordre
    .hint = indiquer chaque cible une fois dans les deux listes

rotation-ambiguous = aucune transformation rigide ne peut être ajustée : plusieurs rotations conviennent aussi bien les unes que les autres
    .expected = deux ensembles de points de même forme
    .hint = vérifier que les deux listes donnent les cibles dans le même ordre et qu’aucune n’est une image miroir

rotation-uncertain = la rotation a une incertitude élargie de { FIXED($expanded_deg, 1) } deg (k = 2)
    .hint = utiliser des cibles plus éloignées les unes des autres, et vérifier que leurs noms ne sont pas intervertis

too-few-points = { $count ->
        [one] { $count } point donné
       *[other] { $count } points donnés
    } pour l’élément { $element }
    .expected = au moins { $minimum } points
    .hint = mesurer plus de points, ou indiquer tous les points de l’élément

point-not-finite = le point { $number } de l’élément { $element } a les coordonnées { $coordinates }
    .expected = des coordonnées finies en millimètres
    .hint = vérifier ce point dans l’export

points-degenerate = aucun élément { $element } ne peut être ajusté : { $spanned ->
        [0] tous les points sont identiques
        [1] tous les points sont alignés
       *[other] tous les points sont coplanaires
    }
    .expected = des points { $spanned ->
            [0] distincts
            [1] non alignés
           *[other] non coplanaires
        }
    .hint = répartir les points sur l’élément

weights-unusable = les { $weights } poids de l’élément { $element } ne conviennent pas à ses { $points } points
    .expected = un poids positif et fini par point, le rapport de deux poids ne dépassant pas 1e12
    .hint = utiliser 1/u² de chaque point ; omettre un point au lieu de lui donner un poids nul

element-without-redundancy = l’élément { $element } n’a pas de point redondant : les résidus sont nuls et son incertitude est inconnue
    .hint = mesurer plus de points que le minimum

residuals-exceed-points = les résidus ({ $element }) sont { FIXED($times, 1) } × l’incertitude indiquée des points
    .hint = vérifier la forme et les points aberrants ; si la forme compte, omettre `--standard-uncertainty-um` : l’incertitude vient alors des résidus

points-repeated = { $count ->
        [one] 1 point répète
       *[other] { $count } points répètent
    } un point antérieur chiffre pour chiffre, donc l’incertitude est trop petite : { $points }
    .hint = supprimer les points copiés : ce ne sont pas d’autres mesures

radius-uncertain = le rayon { FIXED($radius_mm, 6) } mm de l’élément { $element } a une incertitude élargie de { SCIENTIFIC($expanded_mm, 2) } mm (95 %){ $covered_deg ->
        [none] {""}
       *[other] {" "}sur { $covered_deg } deg
    }
    .hint = mesurer un arc plus long, ou fixer le rayon à sa valeur nominale

element-direction-uncertain = la direction de l’élément { $element } a une incertitude élargie de { FIXED($expanded_deg, 1) } deg (95 %)
    .hint = mesurer des points plus éloignés, dans les deux directions d’un plan, ou fixer la direction

cone-is-cylinder = l’angle au sommet du cône n’est pas significativement différent de zéro (k = 2)
    .hint = ajuster un cylindre

cone-is-plane = l’angle au sommet du cône n’est pas significativement différent de 180 deg (k = 2) : le cône est un plan
    .hint = ajuster un plan

points-set-aside = { $count ->
        [one] 1 point est exclu
       *[other] { $count } points sont exclus
    } : { $points }
    .hint = ils sont plus loin de l’élément ajusté à tous les autres que le bruit ne l’explique

points-outlying = { $count ->
        [one] 1 point est loin de l’élément ajusté à tous les autres ({ $points }) et décale
       *[other] { $count } points sont loin de l’élément ajusté à tous les autres ({ $points }) et décalent
    } l’ajustement de { FIXED($shift, 1) } incertitudes-types
    .hint = les examiner ; `--robust` les exclut

robust-few-points = un ajustement robuste de l’élément { $element } exige { $needed } points, et non { $points }
    .hint = mesurer plus de points, ou les ajuster tous sans en exclure
method-principal-directions = directions principales des points centrés
method-orthogonal-distance = distance orthogonale, Gauss-Newton dans une région de confiance
method-circle-in-plane = plan des moindres carrés, projection, cercle dans le plan par distance orthogonale

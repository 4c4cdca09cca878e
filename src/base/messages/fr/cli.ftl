### Messages de cli ; explications dans en/cli.ftl.

batch-done = terminée
batch-failed = échec
batch-not-done = { $ended } : { $campaign }
batch-not-met = limites non respectées
batch-skipped = ignorée
batch-unchanged = { $ended }, inchangée
message-unknown = `{ $id }` n’est pas l’identifiant d’un message

option-not-positive = { $option } doit être positif
    .hint = indiquer un nombre positif

option-refused = { $option } : { $reason }
    .hint = `etalon COMMANDE --help` énumère les valeurs

column-option-malformed = --{ $option } : `{ $text }` n’a pas de `=`
    .expected = { $option ->
        [column] q1_deg=J1
        [constant] kind=distance
       *[other] deleted=1
    }

option-columns-twice = --columns et --column indiquent toutes deux les colonnes
    .hint = en garder une

option-unit-missing = les fichiers n’indiquent pas leur unité de longueur
    .hint = indiquer l’unité : --unit mm, m, um ou inch ; elle n’est jamais devinée

robot-option-missing = parameters.json nécessite --robot FICHIER
    .hint = indiquer le robot.toml : --robot FICHIER

axis-unknown = le robot n’a pas d’axe `{ $axis }`
    .hint = utiliser une articulation du robot, ou x_mm, y_mm, z_mm

axes-mixed = les axes d’une table sont soit cartésiens (x_mm, y_mm, z_mm), soit des articulations
    .expected = articulations { $joints }

table-of-turning-joints = une table de plusieurs articulations exige des articulations prismatiques consécutives
    .hint = utiliser x_mm et y_mm, positions du robot nominal

lead-not-measured = aucun pas de `{ $axis }` n’a été mesuré
    .expected = { $measured }

lead-of-one-axis = un pas ne corrige qu’un seul axe, d’après la position de cet axe
    .hint = n’indiquer que cet axe

table-value-missing = une valeur manque ou n’est pas un nombre
    .hint = corriger ou supprimer la ligne

not-a-grid = les positions ne forment pas une grille
    .expected = une ligne pour chaque position de chaque axe de base

axis-without-positions = `{ $axis }` n’a pas de positions
    .expected = --axis { $axis }=DE:À:PAS

configuration-changed = cible { $target } : la commande compensée exige une autre configuration
    .hint = éloigner la cible de la singularité, ou vérifier ses données de configuration (mode de travail, confdata, Status et Turn)

poses-computed-by-program = les poses calculées par { $names } ne sont pas compensées
    .hint = les vérifier : une pose calculée à partir d’une cible compensée reçoit la compensation de cette cible, et non la sienne

working-mode-missing = le programme n’indique pas le mode de travail à son début
    .hint = indiquer les valeurs articulaires de départ : --start N,N,+1

program-frames = le programme utilise { $names }

one-program-each = diviser le programme : un programme pour chacun

state-pose-option = indiquer sa pose : --{ $option } x,y,z,qw,qx,qy,qz

program-frame-other = le programme indique { $frame }, et --{ $option } indique une autre pose
    .hint = indiquer la pose du programme : --{ $option } { $pose }

program-in-world = les cibles d’un programme ne peuvent pas être dans le repère atelier
    .hint = utiliser --object

counts-missing = `galil` exige le nombre d’impulsions par mm ou par deg de { $axes } axes
    .hint = indiquer --counts-per-unit N,N

joints-in-world = les valeurs articulaires n’ont pas de repère
    .hint = omettre --frame

nominal-pose-unreachable = le robot nominal n’a pas de pose à ces valeurs articulaires
    .hint = vérifier les valeurs articulaires et le mode d’assemblage

pose-singular = la pose { $pose } est singulière : { $joints } peuvent bouger ensemble sans déplacer l’outil ; la solution la plus proche du départ est donnée
    .hint = indiquer des valeurs articulaires dans la ligne pour choisir une autre solution, ou éviter la pose

base-not-in-world = `{ $model }` n’a pas de base dans le repère atelier
    .hint = omettre --frame

mecaprol-other-robot = Mecaprol commande un robot à cinq barres, pas `{ $model }`
    .hint = utiliser un autre --format

target-unreachable = cible { $target } : { $reason }
    .hint = déplacer la cible, ou vérifier les limites dans robot.toml

pose-unreachable = pose { $pose } : { $reason }
    .hint = vérifier la pose et les limites dans robot.toml

hash-of-other-format = `--controller-hash` ne s’applique qu’aux formats qui contiennent cette empreinte : { $formats }
    .hint = en indiquer un avec --format

run-while-exporting = une exécution a écrit `{ $folder }` pendant la création de fichiers pour le contrôleur
    .hint = répéter la commande : les fichiers peuvent contenir des paramètres antérieurs

fit-file-missing = aucun fichier de points n’est indiqué pour `{ $element }`
    .hint = indiquer le fichier : etalon fit { $element } FICHIER

fit-element-missing = l’élément n’est pas indiqué, et le fichier n’est pas un fichier QIF
    .hint = l’indiquer : etalon fit ÉLÉMENT { $file }

qif-with-columns = un fichier QIF n’a ni colonnes ni rayon commun à tous ses éléments
    .hint = omettre --columns, --delimiter et --radius-mm

tracim-object-unknown = l’élément `{ $object }` du jeu de données `{ $id }` est inconnu dans cet essai
    .expected = LINE_3D, PLANE, CIRCLE, CYLINDER, CONE ou SPHERE (Gauss) ; LINE_2D, CIRCLE_2D, PLANE, SPHERE ou CYLINDER (Tchebychev)

tracim-customer-missing = le client n’est pas indiqué dans la réponse : le serveur la refuse
    .hint = ajouter --customer NOM, tel qu’inscrit auprès de TraCIM

tracim-form-name = le nom de l’élément `formDeviation` ne figure pas dans les documents publics de l’essai de Tchebychev
    .hint = essayer la réponse avec l’essai gratuit du serveur avant un essai commandé

no-feature-fitted = aucun élément mesuré n’a été ajusté comme { $kind }
    .expected = des éléments avec des points qui les déterminent
    .hint = éléments avec points dans le fichier : { $seen }

probe-side-unknown = --probe-side : `{ $text }` n’est pas un côté
    .expected = inside, outside, ou trois nombres x,y,z vers le palpeur
    .hint = inside pour un alésage, outside pour un arbre, 0,0,1 pour un palpeur au-dessus d’un plan

probe-side-missing = le côté du palpeur n’est pas indiqué
    .expected = --probe-side inside, outside ou x,y,z
    .hint = inside pour un alésage, outside pour un arbre, la direction vers le palpeur pour un plan ou une droite

probe-radius-missing = --probe-side est indiqué sans le rayon du palpeur
    .expected = --probe-radius-mm
    .hint = indiquer le rayon qualifié du palpeur, ou omettre les deux options pour des points de contact

enclosing-with-probe = { $element } n’est pas corrigé du rayon du palpeur
    .hint = omettre --probe-radius-mm et --probe-side

enclosing-minimum-zone = il n’existe pas de zone minimale pour l’élément { $element }
    .hint = omettre --minimum-zone, ou ajuster un circle2d ou une sphere

uncertainty-implausible = la valeur de { $option } ne peut pas être l’incertitude d’une coordonnée en micromètres
    .hint = indiquer l’incertitude élargie divisée par le facteur d’élargissement, par coordonnée : 0,0027 mm = 2,7 µm
state-expanded-um = l’indiquer en micromètres, par coordonnée (k = 2) : 0,0027 mm font 2,7 µm

robot-not-in-table = la géométrie de `{ $name }` n’est pas dans la table des robots
    .expected = { $names }
    .hint = le décrire par votre propre fichier, --robot robot.toml, ou par son fichier URDF, --urdf FICHIER

iso230-row-incomplete = { $column ->
        [direction] `direction` n’est ni +1 ni -1
       *[other] `{ $column }` manque ou n’est pas fini
    }
    .expected = des nombres, et +1 ou -1 comme `direction`

iso230-columns-exchanged = `position_mm` et `measured_mm` sont inversés : les valeurs de `measured_mm` se répètent, celles de `position_mm` non
    .hint = inverser les colonnes : `--column position_mm=measured_mm`, `--column measured_mm=position_mm`

iso230-few-runs = moins de deux passages dans le sens { $direction } à la position { $position } mm
    .expected = au moins deux passages dans chaque sens, cinq selon l’ISO 230-2

drift-set-too-small = { $option } doit valoir au moins 2
    .hint = indiquer le nombre de cycles d’une série

commanded-missing = aucune pose commandée n’est indiquée : AP n’est pas évaluée (null) ; RP n’en a pas besoin
    .hint = les indiquer avec --commanded pour AP, distances et dérive

infinite-solutions = { $joints } articulations atteignent une pose d’une infinité de façons
    .hint = en choisir une : --nearest

no-whole-pose = le modèle `{ $model }` n’a pas de cinématique de la pose complète
    .hint = utiliser un autre modèle

several-branches = un robot à plusieurs branches ({ $links }) n’a pas de chaîne unique
    .hint = indiquer un seul segment comme `tool_link` d’un robot.toml qui utilise le fichier URDF étalonné : `etalon export --format urdf` écrit l’arborescence étalonnée

table-quaternion-length = le quaternion a pour norme { FIXED($length, 4) }
    .expected = 1 : qw, qx, qy, qz d’une rotation
    .hint = vérifier l’ordre des colonnes (qw est la partie scalaire), et qu’elles ne contiennent pas d’angles

not-a-report = `{ $file }` n’a pas l’extension d’un rapport
    .expected = un fichier dont le nom se termine par { $endings }

earlier-run-left = rien n’est écrit : `{ $report }` et les fichiers voisins proviennent d’une exécution antérieure
    .hint = ne pas charger les fichiers pour le contrôleur de ce dossier : ils proviennent de l’exécution antérieure

certificate-of-earlier-inputs = l’exécution est antérieure aux modifications de { $files } : le certificat montrerait l’état antérieur
    .hint = relancer la campagne, puis écrire le certificat

report-of-earlier-inputs = l’exécution est antérieure aux modifications de { $files } : le rapport montre l’état antérieur
    .hint = relancer la campagne pour inclure les modifications

schema-unknown = schéma inconnu `{ $name }`

verify-quantity-without-residuals = l’étalonnage n’a pas de résidus de la grandeur « { $quantity } » : son erreur de modèle est inconnue
    .hint = omettre ces lignes, ou étalonner avec des observations de cette grandeur

verify-without-observations = aucune ligne du tableau ne contient d’observation
    .hint = mesurer de nouveau ce que l’étalonnage a mesuré : positions, distances, contacts

readings-of-calibration = { $count } lignes sur { $rows } sont égales à des lectures de l’étalonnage : elles ne vérifient rien
    .hint = remplacer les exports et les journaux par ceux de la nouvelle mesure

options-of-table-for-campaign = les options des tableaux n’ont pas d’effet sur la campagne `{ $campaign }`
    .hint = indiquer dans son campaign.toml la lecture de ses fichiers

campaign-without-observations = la campagne `{ $campaign }` n’a pas de section `[observations]`
    .hint = indiquer une campagne avec cette section, ou les options des tableaux (`--column` ...)

campaign-with-several-observations = la campagne `{ $campaign }` a { $count } sections `[[observations]]` ; on ignore laquelle décrit le tableau
    .hint = indiquer la lecture du tableau par les options des tableaux (`--column` ...) au lieu de `--like`

workspace-numbers = --workspace-mm a { $count ->
        [one] { $count } nombre
       *[other] { $count } nombres
    }
    .expected = six, ou quatre pour les robots plans

reorientation-alone = une réorientation est indiquée sans orientation de départ
    .hint = indiquer aussi --orientation-deg

reach-unknown = le fichier de robot du modèle `{ $model }` n’indique pas le rayon d’action
    .hint = omettre --robot, et essayer les positions sur le robot à vitesse réduite

excluded-rows = { $count ->
        [one] { $count } ligne exclue
       *[other] { $count } lignes exclues
    } (n° { $rows }) : { $reason }

controller-error-not-measured = le format `{ $format }` ne contient pas { $parameters } : le fichier suppose leurs valeurs nominales, et son erreur n’a pas été mesurée
    .hint = exécuter la campagne avec "{ $format }" dans `controllers`, et exporter depuis son dossier de sortie ; paramètres recommandés : `etalon export CAMPAIGN --parameters recommended`

nothing-to-load-by-run = à ne pas charger, d’après l’exécution : { $reason }
    .hint = suivre les prochaines étapes du rapport et relancer la campagne ; `etalon recommend` explique la réponse

from-needs-robot = --from exige le robot
    .hint = l’indiquer : --robot ur5e, --robot robot.toml pour votre propre fichier, ou --urdf FICHIER

two-files-of-one-name = deux fichiers s’appellent `{ $name }`
    .hint = donner un autre nom à l’un d’eux

proposal-not-toml = la proposition pour `{ $name }` n’est pas lisible : { $error }
urdf-chain-chosen = la chaîne de `{ $base }` à `{ $tool }` avec { $count ->
        [one] une articulation
       *[other] { $count } articulations
    } a été choisie ; d’autres chaînes se terminent à { $others }
    .hint = si un autre segment porte les cibles, indiquer `tool_link` dans robot.toml ; en Python `Robot.from_urdf(path, tool_link="{ $other }")`

tool-link-longest = la chaîne qui a le plus d’articulations mobiles : les fichiers n’en ont aucune
tool-link-by-names = les fichiers nomment les articulations de cette chaîne
tool-link-by-count = les fichiers ont { $count } colonnes d’articulations, et seule cette chaîne a autant d’articulations
tool-link-by-residual = avec cette chaîne, le robot nominal reproduit les points avec un résidu de { FIXED($rms_mm, 2) } mm, avec toute autre chaîne un résidu au moins trois fois plus grand
tool-link-shortest = avec cette chaîne, le robot nominal reproduit les points avec un résidu de { FIXED($rms_mm, 2) } mm ; d’autres articulations ne le réduisent pas
tool-link-moves = les fichiers nomment les articulations de cette chaîne ; les autres articulations qu’ils nomment ne bougent pas
tool-link-fits = `{ $link }` convient aux fichiers : ses articulations sont { $joints }

nothing-recognised = aucune colonne de `{ $name }` n’est reconnue
    .hint = `etalon formats { $path }` indique ce que ses colonnes peuvent être

option-of-call-refused = { $reason }

table-options-refused = { $fault ->
        [axes] une table a un axe de base, ou deux axes de base différents
        [positions] la table a plus de { $most } positions
        [zero] --zero-at nécessite une position par axe de base
        [numbers] --numbers nécessite un numéro par axe
        [sign-missing] le constructeur ne publie pas le signe des valeurs de cette table : --sign manque
        [sign-known] --sign ne vaut que pour les tables dont le signe n’est pas publié
        [plane] un plan nécessite deux axes de base
        [one-axis] cette table n’a qu’un axe de base
       *[own-axis] cette table n’a qu’un axe de base, l’axe corrigé
    }
    .hint = { $fault ->
        [sign-missing] indiquer --sign add ou --sign subtract, après un essai à une position de la machine
       *[other] corriger l’option ; `etalon axis-table --help` les décrit
    }

deviation-unknown = pas d’écart à { $position } : { $reason }
    .hint = utiliser des positions que le robot atteint, ou qui ont été mesurées

robot-file-of-run = relancer la campagne, ou indiquer le robot.toml avec lequel elle a été exécutée
convert-no-chain = `{ $model }` n’a pas de chaîne d’articulations : d’autres conventions ne peuvent pas le décrire

convert-shared-joints = { $axes } axes partagent { $joints } valeurs articulaires
    .hint = conserver l’URDF, où `mimic` l’indique

convert-left-out = { $count ->
        [one] 1 paramètre n’est pas de la géométrie et est omis
       *[other] { $count } paramètres ne sont pas de la géométrie et sont omis
    } : { $names }
    .hint = indiquer `bending`, `harmonics`, `backlash` et `coupling` dans le nouveau fichier, et les identifier de nouveau

convert-gains-not-held = un fichier URDF ne contient pas le gain de { $joints } : ses valeurs articulaires sont celles des axes
    .hint = multiplier les valeurs articulaires, ou convertir en `poe`

convert-travel-unknown = la course de { $joints } n’est pas indiquée : le fichier URDF contient 1 m de chaque côté
    .hint = corriger `limit` dans le fichier, ou indiquer `travel_mm` dans robot.toml

convert-not-reproduced = la description convertie ne reproduit pas le robot : la bride s’en écarte de { FIXED($off_mm, 6) } mm et { FIXED($off_deg, 6) } deg au plus
    .hint = vérifier les longueurs du fichier de robot : les longueurs très grandes perdent des chiffres

enclosing-robust = les points extrêmes déterminent l’élément englobant `{ $element }` : un ajustement robuste les écarterait
    .hint = ajuster circle2d ou sphere avec --robust

qif-robust = les éléments d’un fichier QIF sont ajustés à tous leurs points
    .hint = omettre --robust, ou ajuster les points d’un tableau
axis-without-errors = l’axe n’a pas d’erreurs propres dans ce modèle
lead-not-measured-there = le pas n’a pas été mesuré à cette position
table-without-row = le tableau n’a pas de ligne pour cette position

test-point-unreached = le point { $point } de la liste `{ $list }` n’est pas atteint : { $reason }
    .hint = déplacer ou réduire l’espace de travail (--workspace-mm), ou indiquer une autre orientation (--orientation-deg)

no-candidate-generated = aucun des { $draws } tirages ne donne une pose candidate : { $counts }
    .hint = élargir ce qui exclut le plus : limites et `--range` (deg, mm), `--box` (mm, base du robot), `--reflector`, `--instrument`, `--obstacle` et `--link`

few-candidates-generated = { $found } poses candidates sur { $wanted } trouvées en { $draws } tirages : { $counts }
    .hint = élargir ce qui exclut le plus : limites et `--range` (deg, mm), `--box` (mm, base du robot), `--reflector` et `--instrument`

draws-beyond-limits = { $count } au-delà des limites des articulations ou des segments, ou sans pose

draws-outside-box = { $count } avec une cible hors de la boîte (dans les limites, les cibles sont en x { FIXED($x0, 0) } à { FIXED($x1, 0) }, y { FIXED($y0, 0) } à { FIXED($y1, 0) }, z { FIXED($z0, 0) } à { FIXED($z1, 0) } mm)

draws-facing-away = { $count } avec un réflecteur tourné à l’opposé de l’instrument ({ $reversed } d’entre eux lui feraient face avec des axes opposés)

joint-range-missing = l’articulation { $joint } n’a pas de limites
    .hint = les indiquer dans le fichier de robot, ou par `--range { $column }=DE:À`

range-joint-unknown = `--range { $column }` : le robot n’a pas cette articulation

range-outside-limits = les plages de l’articulation { $joint } et ses limites ({ FIXED($from, 3) } à { FIXED($to, 3) } { $unit }) n’ont aucune valeur commune
    .hint = vérifier l’unité et le signe de `--range`

reflector-missing = la génération de poses candidates exige au moins un réflecteur sur la bride
    .hint = l’indiquer : `--reflector A=X,Y,Z` (mm, dans la bride)

reflector-twice = le réflecteur { $name } est indiqué deux fois
    .hint = donner à chaque réflecteur son propre nom

reflector-of-own-targets = `{ $model }` a ses propres cibles : ni réflecteurs ni instrument ne peuvent être indiqués
    .hint = omettre `--reflector` et `--instrument`

sight-incomplete = { $missing ->
        [axis] aucun réflecteur muni d’un axe ne fait face à l’instrument
       *[other] les réflecteurs munis d’un axe n’ont pas d’instrument auquel faire face
    }
    .hint = { $missing ->
        [axis] indiquer l’axe dans la bride et le demi-angle d’acceptation : `--reflector A=X,Y,Z,I,J,K,ANGLE`
       *[other] indiquer sa position dans la base : `--instrument X,Y,Z`
    }

obstacle-twice = l’obstacle { $name } est indiqué deux fois
    .hint = donner à chaque obstacle son propre nom

instrument-inside-obstacle = l’instrument est à l’intérieur de l’obstacle { $name }
    .hint = vérifier les deux (mm, base du robot)

reflector-inside-link = le réflecteur { $reflector } est à l’intérieur du segment de l’articulation { $joint }, qui le porte
    .hint = indiquer un rayon plus petit ou les extrémités du segment : `--link { $joint }=RAYON,X,Y,Z,X,Y,Z`

link-joint-unknown = le robot n’a pas d’articulation { $joint }

links-unsuited = un robot du modèle `{ $model }` n’est pas une chaîne simple d’articulations : ses segments ne peuvent pas être indiqués
    .hint = omettre `--link` ; indiquer les corps fixes par `--obstacle`

draws-hidden = { $count } avec un réflecteur caché par { $obstacle }

box-axis-unknown = `--box` : les cibles de ce robot n’ont pas d’axe `{ $name }`
    .expected = { $dimension ->
        [2] x ou y
       *[other] x, y ou z
    }

box-missing = les poses candidates de `{ $model }` sont tirées par position : il manque x et y dans `--box`
    .hint = indiquer la région dans la base du robot : `--box x=DE:À,y=DE:À` (mm)

check-not-detectable = indécelable par ces données : { $what } (contrôlé par { $keys })
check-source = { $rows ->
        [one] { $file } : { $rows } ligne, dont { $refused } rejetée ({ $dialect })
       *[other] { $file } : { $rows } lignes, dont { $refused } rejetées ({ $dialect })
    }
check-verdict = { $warnings ->
        [0] { $file } : ni erreur ni avertissement
        [one] { $file } : aucune erreur, 1 avertissement
       *[other] { $file } : aucune erreur, { $warnings } avertissements
    }
study-head = Erreur : { $error }.
    Moyenne de { $runs } étalonnages, { $draws } tirages : médiane [95 % des tirages].
study-set = jeu
study-noise = bruit µm
study-error = erreur
study-rms-before = RMS avant
study-rms = RMS
study-largest = max.
study-parameter = paramètre
study-actual = valeur vraie
study-mean = moyenne
study-spread = 3 s
targets-compensated = { $count ->
        [one] { $count } cible compensée
       *[other] { $count } cibles compensées
    } ; { $left ->
        [one] { $left } cible en valeurs articulaires inchangée
       *[other] { $left } cibles en valeurs articulaires inchangées
    }
batch-counts = { $done } terminées, { $not_met } avec des limites non respectées, { $failed } échouées, { $skipped } ignorées
run-skipped = ignorée : { $campaign } nécessite des données sous ${ $name }, qui n’est pas défini
no-controller-files = aucun fichier pour le contrôleur n’est écrit : le résultat n’est pas plausible
next-recommend = { $command } montre la contribution de chaque paramètre ; les fichiers pour le contrôleur sont dans le dossier de sortie{ $withheld ->
        [0] {""}
       *[other] , marqués « à ne pas charger »
    }
unmodelled-said = erreurs simulées qu’aucun paramètre ne décrit : { $error }
unmodelled-backlash = jeu { $joints }
unmodelled-interpolation = interpolation du codeur { $joints }
unmodelled-every = { $joint } { $amplitude } tous les { $period }
unmodelled-homing = prise d’origine (écart-type) { $joints }
unmodelled-growth = dilatation thermique de { $growth } µm par mètre et par heure
unmodelled-bending = flexion de { $bending } µm à un mètre de la base
axis-table-largest = { $count ->
        [one] { $count } position, plus grand écart { FIXED($largest, 6) } { $unit }
       *[other] { $count } positions, plus grand écart { FIXED($largest, 6) } { $unit }
    }
iso230-accuracy = exactitude A
iso230-systematic = erreur systématique de positionnement E
iso230-repeatability = répétabilité R
iso230-mean-systematic = erreur systématique moyenne M
iso230-reversal = erreur de réversibilité B
iso230-mean-reversal = erreur de réversibilité moyenne
iso230-both = bidirectionnel
iso230-positive = positif
iso230-negative = négatif
fit-seen-none = aucun
fit-any-element = élément géométrique
zone-by-least-squares = omettre --minimum-zone : l’ajustement se fait alors par moindres carrés
fit-head = { $element } : { $count ->
        [one] { $count } point
       *[other] { $count } points
    }
fit-center = centre
fit-point = point
fit-normal = normale
fit-axis = axe
fit-radius = rayon
fit-minor-radius = petit rayon
fit-apex-angle = angle au sommet
fit-residuals = résidus
fit-flatness = planéité
fit-held-by = appuis
fit-proof = preuve
fit-probe = palpeur
fit-probe-center = centre palpé
fit-its-radius = son rayon
fit-stated-point = point indiqué
fit-stated-direction = {"  "}direction
fit-stated-radius = {"  "}rayon
fit-stated-minor-radius = {"  "}petit rayon
fit-stated-apex-angle = {"  "}angle au sommet
fit-held-points = points { $upper } et { $lower }
fit-proof-global = aucune autre zone n’est plus étroite
fit-proof-local = aucune zone voisine n’est plus étroite
fit-proof-none = aucune
fit-spread = RMS { $rms }, max. { $max }, forme { $form }
fit-off = { $value } { $unit }, ajusté { $off } { $unit }
fit-apart = { $value }, ajusté à { $apart } { $unit }
axes-head = { $joint } { $kind ->
        [slides] prismatique
       *[turns] rotoïde
    } : { $count ->
        [one] { $count } lecture
       *[other] { $count } lectures
    }{ $aside ->
        [0] {""}
        [one] , dont { $aside } exclue
       *[other] , dont { $aside } exclues
    }
axes-direction = {"  "}direction    { $direction }  (u = { $u } deg)
axes-point = {"  "}point        { $point }  (u = { $u } mm)
axes-circle = {"  "}`{ $target }`  rayon { $radius } mm (u = { $u } mm), arc { $arc } deg
axes-line = {"  "}`{ $target }`  longueur { $length } mm
axes-error-motions = {"    "}mouvement d’erreur radial { $radial } µm (bruit seul { $radial_noise } µm), de face { $face } µm (bruit seul { $face_noise } µm)
axes-straightness = {"    "}rectitude { $radial } µm (bruit seul { $radial_noise } µm) et { $face } µm (bruit seul { $face_noise } µm)
axes-axial-and-tilt = {"  "}mouvement d’erreur axial { $axial } µm (bruit seul { $axial_noise } µm), d’inclinaison { $tilt } deg (bruit seul { $tilt_noise } deg)
axes-motion = {"  "}mouvement    { $ratio } × valeur articulaire (u = { $u }), écart { $rms } { $unit } (RMS)
axes-base = base ({ $rule })
axes-origin = {"  "}origine      { $point }
axes-target = cible `{ $target }` sur la bride
axes-check-pose = pose de contrôle, ligne { $line } : à { $distance } mm du robot  (u = { $u } mm par composante)
next-paste = coller ces lignes dans campaign.toml ; `etalon check DOSSIER` les essaie
next-paste-refused = { $next } ; elles seraient refusées : { $reasons }
next-simulate = { $command } écrit les exports et le journal
next-copy = copier les exports et le journal dans { $folder } ; `etalon formats FICHIER` propose la lecture de chacun ; { $command }
next-check-asks = { $command } demande { $keys }
next-check-refused = { $next } ; la proposition serait alors refusée : { $reasons }
next-command = { $command }
units-of-joints = les unités des articulations
unit-of-times = l’unité des temps
unit-of-rotations = l’unité des rotations
axis-steps-not-whole = de { $from } à { $to }, les pas de { $step } ne sont pas entiers
assignment-without-number = `{ $name }` n’a pas de nombre
newer-than-unreadable = le fichier de `--newer-than` ne peut pas être lu : { $reason }
pose-argument-expected = attendu : x,y,z en mm, ou ces valeurs et un quaternion unité qw,qx,qy,qz
axis-name-expected = le nom d’un axe se compose de lettres et de chiffres
stdout-not-written = stdout ne peut pas être écrit
plan-side = côté { $side } mm, plan d’essai { $plane }
converted-by = converti par etalon robot convert
convert-base-of-table = base du tableau dans le repère de la base du robot : xyz { $xyz_mm } mm, rpy { $rpy_deg } deg
convert-flange-of-table = bride du robot dans la bride du tableau : xyz { $xyz_mm } mm, rpy { $rpy_deg } deg
from-other-joints = le fichier a { $columns } colonnes d’articulations, et le robot { $joints } articulations : omettre les articulations que le robot n’a pas
from-joints-in-order = les articulations sont celles de robot.toml dans l’ordre du fichier
from-unit-of-joints = remplacer UNIT par deg, rad, mm, m ou um : le fichier ne l’indique pas

cell-frame = { $name ->
        [tool] outil
        [target] cible
        [sensor] capteur
        [base] base
        [world] système de mesure
        [object] objet
       *[axis] axe
    } { $reference ->
        [flange] dans la bride
        [base] dans la base
        [world] dans le système de mesure
       *[points] dans les points
    }
cell-point = { $name ->
        [tool] point d’outil
       *[fixed] point fixe
    } { $reference ->
        [flange] dans la bride
        [base] dans la base
        [world] dans le système de mesure
       *[points] dans les points
    }
cell-position = {"  "}position     { $position } mm{ $known ->
        [no] {""}
       *[yes] {"  "}(u = { $u } mm)
    }
cell-quaternion = {"  "}quaternion   { $quaternion }{ $known ->
        [no] {""}
       *[yes] {"  "}(u = { $u } deg autour de x y z)
    }
cell-axis = { $kind ->
        [linear] axe linéaire
       *[rotary] axe rotatif
    }
cell-direction = {"  "}direction    { $direction }
cell-axis-scale = {"  "}échelle      { $scale } × valeur de l’axe{ $known ->
        [no] {""}
       *[yes] {"  "}(u = { $u })
    }
cell-residuals = { $measure ->
        [position] position
       *[orientation] orientation
    } : écart-type des résidus { $deviation } { $measure ->
        [position] mm
       *[orientation] deg
    }, redondance { $redundancy } ; incertitudes d’après { $source ->
        [stated] les valeurs indiquées
       *[residuals] les résidus
    }
cell-largest-residual = { $measure ->
        [position] plus grand résidu de position :
       *[orientation] plus grand résidu d’orientation :
    } { $length } { $measure ->
        [position] mm
       *[orientation] deg
    }, ligne { $line }

targets-beyond-field = { $count ->
        [one] la cible { $targets } est
       *[other] les cibles { $targets } sont
    } au-delà du champ résiduel, là où il décroît vers zéro
    .hint = mesurer des poses d’étalonnage dans cette région
controller-calibrated = la commande calcule avec l’étalonnage d’usine de son propre bras ; les ordres ne sont justes que si { $robot } contient ces valeurs
    .hint = reporter dans { $robot } les valeurs du fichier d’étalonnage de la commande, ou mesurer quelques poses après le chargement
parameters-expired = les paramètres sont valables jusqu’au { $last } ; nous sommes le { $today }
    .hint = mesurer quelques poses et utiliser `etalon verify`, ou étalonner à nouveau
date-in-future = `{ $key }` ({ $date }) est postérieure à aujourd’hui ({ $today })
    .hint = corriger la date ou l’horloge de cet ordinateur

backlash-not-in-table = la table a une valeur pour les deux sens ; le jeu de `{ $axis }`, jusqu’à { FIXED($backlash, 5) } { $unit }, n’y figure pas
    .hint = l’indiquer comme jeu de l’axe dans le contrôleur

option-column-ambiguous = --column indique `{ $first }` et `{ $second }` pour `{ $column }`, et `{ $file }` a les deux
    .hint = n’en indiquer qu’un

predictions-missing = { $count ->
        [one] une ligne mesurée n’a pas de prédiction : pose { $pose }, cible `{ $target }`
       *[other] { $count } lignes mesurées n’ont pas de prédiction, la première à la pose { $pose }, cible `{ $target }`
    }
    .hint = prédire chaque ligne du tableau des valeurs articulaires

prediction-repeated = la cible `{ $target }` est prédite deux fois à la pose { $pose }, la première fois à la ligne { $line }
    .hint = indiquer une ligne par pose et cible

benchmark-counts = { $poses } poses
benchmark-position = position
benchmark-orientation = orientation
benchmark-mean = moyenne
benchmark-rms = RMS
benchmark-p95 = 95 %
benchmark-max = maximum
benchmark-coverage = couverture
benchmark-width = largeur
benchmark-score = score

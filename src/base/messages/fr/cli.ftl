### Messages de cli ; explications dans en/cli.ftl.

message-unknown = `{ $id }` n’est pas l’identifiant d’un message

option-not-positive = { $option } doit être positif
    .hint = indiquer un nombre positif

option-refused = { $option } : { $reason }
    .hint = `etalon COMMANDE --help` énumère les valeurs

column-option-malformed = --column : `{ $text }` n’a pas de `=`
    .expected = q1_deg=J1

option-unit-missing = les fichiers n’indiquent pas leur unité de longueur
    .hint = l’indiquer : --unit mm, m, um ou inch ; elle n’est jamais devinée

robot-option-missing = parameters.json demande --robot FICHIER
    .hint = indiquer le robot.toml : --robot FICHIER

axis-unknown = le robot n’a pas d’axe `{ $axis }`
    .hint = utiliser une articulation du robot, ou x_mm, y_mm, z_mm

axes-mixed = les axes d’une table sont tous parmi x_mm, y_mm, z_mm, ou tous des articulations
    .expected = articulations { $joints }

table-of-turning-joints = une table de plusieurs articulations demande des articulations prismatiques successives
    .hint = utiliser x_mm et y_mm : poses du robot nominal

lead-not-measured = aucun pas de `{ $axis }` n’a été mesuré
    .expected = { $measured }

lead-of-one-axis = un pas est celui d’un axe, qu’il corrige
    .hint = indiquer cet axe seul

table-value-missing = une valeur manque ou n’est pas un nombre
    .hint = corriger ou supprimer la ligne

not-a-grid = les positions ne sont pas celles d’une grille
    .expected = une ligne pour chaque position de chaque axe de base

axis-without-positions = `{ $axis }` n’a pas de positions
    .expected = --axis { $axis }=DE:À:PAS

configuration-changed = cible { $target } : la commande est dans une autre configuration
    .hint = ses données de configuration (mode de travail, confdata, Status et Turn) restent telles quelles : les vérifier

poses-computed-by-program = les poses de { $names } restent telles quelles
    .hint = les vérifier : ce qu’un programme calcule à partir de cibles compensées a leur compensation, pas la sienne

working-mode-missing = le programme n’indique pas le mode de travail de départ du robot
    .hint = indiquer les valeurs articulaires de départ : --start N,N,+1

program-frames = le programme utilise { $names }

one-program-each = donner les cibles de chacun dans un programme à part

state-pose-option = indiquer sa pose : --{ $option } x,y,z,qw,qx,qy,qz

program-in-world = les cibles d’un programme ne sont pas dans le repère du monde
    .hint = utiliser --object

counts-missing = `galil` demande les impulsions de { $axes } axes par mm ou deg
    .hint = --counts-per-unit N,N

joints-in-world = des valeurs articulaires ne sont pas dans le repère du monde
    .hint = omettre --frame

nominal-pose-unreachable = le robot nominal ne peut pas être là où les articulations le placent
    .hint = vérifier les valeurs articulaires et le mode d’assemblage

base-not-in-world = `{ $model }` n’a pas de base dans le repère du monde
    .hint = omettre --frame

mecaprol-other-robot = Mecaprol commande un robot à cinq barres, pas `{ $model }`
    .hint = utiliser un autre --format

target-unreachable = cible { $target } : { $reason }
    .hint = déplacer la cible, ou vérifier les limites dans robot.toml

pose-unreachable = pose { $pose } : { $reason }
    .hint = vérifier la pose et les limites dans robot.toml

controller-format-unknown = `{ $name }` n’est pas un format de commande

hash-of-other-format = `--controller-hash` est pour les formats qui la contiennent : { $formats }
    .hint = en indiquer un avec --format

run-while-exporting = une exécution a écrit `{ $folder }` pendant la création de fichiers de commande
    .hint = répéter la commande : ils peuvent provenir de paramètres antérieurs

fit-file-missing = aucun fichier à ajuster pour `{ $element }`
    .hint = indiquer le fichier : etalon fit { $element } FICHIER

fit-element-missing = l’élément n’est pas indiqué, et le fichier n’est pas QIF
    .hint = l’indiquer : etalon fit ÉLÉMENT { $file }

qif-with-columns = un fichier QIF n’a ni colonnes ni un même rayon pour tous ses éléments
    .hint = omettre --columns, --delimiter et --radius-mm

no-feature-fitted = aucun élément mesuré n’a été ajusté comme { $kind }
    .expected = des éléments avec des points qui les déterminent
    .hint = éléments avec points dans le fichier : { $seen }

probe-side-unknown = --probe-side : `{ $text }` n’est pas un côté
    .expected = inside, outside, ou trois nombres x,y,z vers le palpeur
    .hint = inside pour un alésage, outside pour un arbre, 0,0,1 pour un palpeur au-dessus d’un plan

probe-side-missing = le côté du palpeur n’est pas indiqué
    .expected = --probe-side inside, outside ou x,y,z
    .hint = inside pour un alésage, outside pour un arbre, la direction vers le palpeur pour un plan ou une droite

probe-radius-missing = --probe-side sans palpeur
    .expected = --probe-radius-mm
    .hint = indiquer le rayon qualifié du palpeur, ou omettre les deux pour des points de contact

enclosing-with-probe = { $element } n’est pas compensé d’un palpeur
    .hint = omettre --probe-radius-mm et --probe-side

enclosing-minimum-zone = il n’y a pas de zone minimale d’un { $element }
    .hint = omettre --minimum-zone, ou ajuster un circle2d ou une sphere

uncertainty-implausible = { $option } n’est pas une incertitude d’une coordonnée en micromètres
    .hint = incertitude élargie sur facteur d’élargissement, par coordonnée : 0.0027 mm = 2.7 um

robot-not-in-table = la géométrie de `{ $name }` n’est pas dans la table des robots
    .expected = { $names }
    .hint = le décrire par son URDF : --urdf FICHIER

iso230-row-incomplete = une ligne n’a pas de position, de valeur mesurée ou de direction
    .expected = des nombres, et +1 ou -1 comme `direction`

iso230-no-rows = le tableau n’a pas de lignes
    .hint = vérifier le fichier

iso230-few-runs = la position { $position } mm a moins de deux passages dans la direction { $direction }
    .expected = des passages des deux côtés, cinq selon l’ISO 230-2

nothing-to-evaluate = rien à évaluer n’est indiqué
    .hint = indiquer poses, enregistrement ou charges : `etalon iso9283 --help`

drift-set-too-small = { $option } doit être au moins 2
    .hint = indiquer le nombre de cycles d’une série

commanded-missing = aucune pose commandée n’est indiquée : AP n’est pas déterminé, et nul (null) ; RP n’en a pas besoin
    .hint = les indiquer avec --commanded pour AP, distances et dérive

infinite-solutions = { $joints } articulations atteignent une pose d’une infinité de façons
    .hint = en demander une : --nearest

no-whole-pose = `{ $model }` n’a pas de cinématique d’une pose complète
    .hint = utiliser un autre modèle

table-quaternion-length = le quaternion a la norme { FIXED($length, 4) }
    .expected = 1 : qw, qx, qy, qz d’une rotation
    .hint = vérifier l’ordre des colonnes (qw est la partie scalaire), et que ce ne sont pas des angles

not-a-report = `{ $file }` ne se termine pas comme un rapport
    .expected = un fichier qui se termine par { $endings }

report-folder-missing = aucun dossier n’est indiqué
    .hint = indiquer le dossier de sortie d’une exécution

earlier-run-left = rien n’est écrit : `{ $report }` et les fichiers voisins sont d’une exécution antérieure
    .hint = ne pas charger ses fichiers de commande comme s’ils étaient de celle-ci

schema-unknown = il n’y a pas de schéma `{ $name }`

verify-other-column = les observations ont une colonne `{ $column }` : seules les positions sont comparées
    .hint = omettre les lignes d’autres genres et leurs colonnes

workspace-numbers = --workspace-mm a { $count } nombres
    .expected = six, ou quatre pour les robots plans

reorientation-alone = une réorientation sans orientation de départ
    .hint = indiquer aussi --orientation-deg

reach-unknown = le fichier de robot du modèle `{ $model }` n’indique pas sa portée
    .hint = omettre --robot, et essayer les positions sur le robot à faible vitesse

excluded-rows = exclu : { $count ->
        [one] { $count } ligne
       *[other] { $count } lignes
    }, lignes { $rows } : { $reason }

controller-error-not-measured = le format `{ $format }` ne contient pas { $parameters } : son fichier est conditionné par leurs valeurs nominales, et son erreur n’a pas été mesurée
    .hint = exécuter la campagne avec "{ $format }" parmi ses `controllers`, et exporter depuis son dossier de sortie

from-needs-robot = --from a besoin du robot
    .hint = le nommer : --robot ur5e, ou --urdf FICHIER

two-files-of-one-name = deux fichiers s’appellent `{ $name }`
    .hint = donner un autre nom à l’un d’eux

proposal-not-toml = la proposition pour `{ $name }` n’est pas lisible : { $error }

nothing-recognised = rien n’est reconnu dans `{ $name }`
    .hint = `etalon formats { $path }` indique ce que ses colonnes pourraient être

table-to-evaluate-missing = il manque le tableau à évaluer

option-of-call-refused = { $reason }

table-options-refused = { $fault ->
        [axes] un tableau a un axe de base ou deux différents
        [positions] le tableau a plus de { $most } positions
        [zero] --zero-at demande une position par axe de base
        [numbers] --numbers demande un numéro par axe
        [sign-missing] le constructeur ne publie pas le signe des valeurs de ce tableau : --sign manque
        [sign-known] --sign est pour les tableaux dont le signe n’est pas publié
        [plane] un plan demande deux axes de base
        [one-axis] ce tableau a un axe de base
       *[own-axis] ce tableau a un axe de base, qui est l’axe corrigé
    }
    .hint = { $fault ->
        [sign-missing] indiquer --sign add ou --sign subtract, après un essai à une position de la machine
       *[other] corriger l’option ; `etalon axis-table --help` les décrit
    }

deviation-unknown = pas d’écart à { $position } : { $reason }
    .hint = utiliser des positions que le robot atteint, ou qui ont été mesurées

robot-file-of-run = exécuter de nouveau la campagne, ou indiquer le robot.toml avec lequel elle a été exécutée

axis-without-errors = l’axe n’a pas d’erreurs propres dans ce modèle
lead-not-measured-there = le pas n’y a pas été mesuré
table-without-row = le tableau n’y a pas de ligne

### Messages de campaign ; explications dans en/campaign.ftl.

no-file-listed = la liste des fichiers est vide
recording-unit = un enregistrement exige `unit` s’il a un `format`, et ne l’admet pas sans `format`
    .hint = indiquer les deux ; sans l’un ni l’autre, c’est un tableau time_s,x_mm,y_mm,z_mm, dont l’en-tête indique les unités

campaign-missing = le fichier de campagne `{ $file }` n’existe pas
    .hint = `etalon init DOSSIER` écrit une campagne de départ

joints-need-delimited-text = `joints` ne se lit que dans un texte délimité avec au plus une ligne de noms
    .hint = indiquer `format = {"{"} delimiter = .., header = 1, columns = .. {"}"}` ; pour d’autres fichiers, indiquer les articulations dans un [log]

joints-differ = deux exports de `{ $file }` indiquent des `joints` différents
    .hint = indiquer les mêmes colonnes dans les deux

joints-twice = les articulations sont indiquées deux fois : dans `joints` de `{ $file }` et dans [log]
    .hint = omettre l’une des deux

joints-joined-by-row = un export avec `joints` se joint ligne par ligne
    .hint = indiquer `by = "row"` dans [join], ou omettre [join]

environment-missing = la variable d’environnement `{ $name }` n’est pas définie
    .hint = lui donner pour valeur le dossier qui contient `{ $file }`

export-files-missing = aucun fichier n’a la forme `{ $file }`
    .hint = mesurer la première pose, ou corriger `file` de ce [[export]]

path-outside = `{ $file }` sort du dossier de la campagne
    .expected = un chemin dans le dossier de la campagne, ou qui commence par `$NAME/`

no-target = un robot tridimensionnel exige au moins une cible
    .hint = indiquer `target = "NAME"` du tableau ou des exports (option --target), une colonne `target` du tableau, ou `targets` dans [join]

target-called-base = aucune cible ne peut s’appeler `base` : ses paramètres porteraient le nom de ceux de la base du robot
    .hint = donner un autre nom à la cible dans `label` ou `columns`

key-not-positive = `{ $key }` doit être positif
    .hint = corriger la valeur

joint-key-missing = la clé `{ $key }` manque dans `joint`

direction-in-base = une direction dans la base, par exemple { $example }

keys-state-the-same = { $keys } indiquent la même grandeur : en omettre une

leg-count = un hexapode a six jambes, le fichier en indique { $count }
    .hint = ajouter un [[leg]] avec base_mm et platform_mm par jambe

hexapod-singular = l’hexapode est singulier à sa pose d’origine : les six longueurs de jambe n’y déterminent pas sa pose
    .hint = vérifier `base_mm` et `platform_mm`, ou indiquer une autre pose d’origine

no-joints = un bras série exige ses articulations
    .hint = ajouter un [[joint]] avec alpha_deg, a_mm, theta_deg, d_mm par articulation, depuis la base

gravity-without-direction = `gravity` n’a pas de direction
    .expected = une direction dans la base, par exemple [0, 0, -1]

not-denavit-hartenberg = `{ $key }` n’est pas un paramètre de Denavit-Hartenberg
    .hint = `{ $key }` appartient à `convention = "poe"`

joint-angle-unit = `{ $key }` = { FIXED($value, 4) } { $unit ->
        [rad] fait plus de deux tours : la valeur est en degrés
       *[deg] est un multiple de π/2 : la valeur est en radians
    }
    .hint = indiquer la valeur comme `{ $other }`

not-screw-axis = un axe de vissage n’a ni paramètres de Denavit-Hartenberg ni `parallel`
    .hint = indiquer `direction` et `point_mm`

joint-axis-without-direction = l’axe de l’articulation n’a pas de direction
    .expected = une direction dans la base, par exemple [0, 0, 1]

flange-missing = les axes de vissage exigent la pose de la bride aux valeurs articulaires nulles : la clé `{ $key }` manque

flange-of-table = `{ $key }` est sans objet pour des paramètres de Denavit-Hartenberg
    .hint = `{ $key }` appartient à `convention = "poe"`

range-of-other-motion = `{ $key }` n’est pas une clé d’une articulation { $motion ->
        [slides] prismatique
       *[turns] rotoïde
    }
    .hint = indiquer `{ $own }`

range-exchanged = `{ $key }` n’est pas une plage : de { $lower } à { $upper }
    .expected = la plus petite limite, puis la plus grande

joint-reference-wrong = { $fault ->
        [unknown-number] il n’y a pas d’articulation { $joint }
        [unknown-name] il n’y a pas d’articulation `{ $joint }`
        [slides] l’articulation { $joint } est prismatique : elle ne tourne pas
        [twice] l’articulation { $joint } apparaît deux fois
        [itself] l’articulation { $joint } est couplée à elle-même : indiquer plutôt son gain
       *[pair] la paire { $joint } apparaît deux fois
    }
    .expected = articulations de 1 à { $count }, une fois chacune
    .hint = les articulations sont { $joints }

urdf-joint-kind = l’articulation `{ $joint }` est de type { $kind }, qui n’est pas pris en charge
    .expected = fixed, revolute, continuous ou prismatic

urdf-axis-without-direction = l’axe de l’articulation `{ $joint }` n’a pas de direction
    .expected = <axis xyz="0 0 1"/> ou une autre direction

urdf-origin-far = l’origine de l’articulation `{ $joint }` est à { FIXED($away_m, 0) } m de son parent
    .hint = les longueurs d’un fichier URDF sont en mètres : diviser celles de ce fichier par 1000

urdf-two-parents = le segment `{ $link }` a deux parents : `{ $first }` et `{ $second }`
    .hint = un fichier URDF décrit un arbre : fermer les boucles par `mimic`

urdf-loop = les articulations au-delà du segment `{ $link }` forment une boucle
    .hint = un fichier URDF décrit un arbre : fermer les boucles par `mimic`

urdf-link-unknown = `{ $file }` n’a pas de segment `{ $link }`

urdf-no-path = aucune chaîne d’articulations ne mène de `{ $from }` à `{ $to }`
    .hint = vérifier `base_link` et `tool_link` : aucune articulation ne porte `{ $root }`

urdf-mimic-unknown = l’articulation `{ $joint }` imite `{ $mimics }`, absente du fichier

urdf-mimics-itself = l’articulation `{ $joint }` s’imite elle-même
    .hint = indiquer une autre articulation dans <mimic>
urdf-mimics-several = l’articulation `{ $joint }` imite plusieurs articulations
    .hint = garder un seul `mimic` : une articulation URDF en imite une seule. Si `{ $joint }` dépend de plusieurs articulations de la chaîne, n’en garder aucun : enregistrer la première sous son nom, et indiquer le facteur de chaque autre dans `coupling = [["{ $joint }", "..."]]` et [nominal]

urdf-nothing-moves = aucune articulation ne bouge entre `{ $from }` et `{ $to }`
    .hint = vérifier `base_link` et `tool_link`

urdf-no-moving-joint = aucune articulation du fichier ne bouge
    .hint = indiquer le fichier URDF d’un robot

bending-on-moving-base = `bending` exige une direction fixe de la pesanteur, or des articulations déplacent `{ $link }`
    .hint = supprimer `bending`, ou prendre pour `base_link` un segment immobile

bending-without-mass = `bending` de l’articulation `{ $joint }` exige une masse au-delà de cette articulation
    .hint = ajouter <inertial> aux segments qu’elle porte

parameter-name-doubled = deux paramètres s’appelleraient `{ $name }`
    .hint = renommer la cible : aucune cible ne peut porter le nom d’une articulation

tool-link-missing = aucun segment ne porte les cibles
    .hint = indiquer `tool_link = "..."`, ou un [[branch]] avec `tool_link` et `targets` pour chacun de plusieurs segments

tool-link-beside-branches = `tool_link` et [[branch]] indiquent tous deux les segments des cibles
    .hint = supprimer `tool_link`, et donner à son segment un [[branch]] avec `targets`

target-on-two-branches = la cible `{ $target }` est sur deux branches : `{ $first }` et `{ $second }`
    .hint = la supprimer dans `targets` de l’une d’elles

target-on-no-branch = la cible `{ $target }` n’est sur aucune branche
    .hint = l’ajouter à `targets` du [[branch]] dont le segment la porte

bending-in-branches = `bending` de l’articulation `{ $joint }` n’est pas modélisé : plusieurs branches la chargent
    .hint = supprimer l’articulation de `bending`

payload-in-branches = `payload` de l’articulation `{ $joint }` n’est pas modélisé : le robot a plusieurs branches
    .hint = supprimer `payload`, ou décrire la branche seule par `tool_link`

elastic-in-branches = `{ $key }` n’est pas modélisé : le robot a plusieurs branches
    .hint = supprimer `{ $key }`, ou décrire la branche seule avec `tool_link`

coupling-across-branches = l’articulation `{ $by }` ne déplace pas la branche `{ $link }`, dans laquelle `{ $joint }` lui est couplée
    .hint = supprimer la paire de `coupling` : les deux articulations doivent se trouver sur le chemin vers chaque segment

key-of-other-model = `{ $key }` est sans objet pour ce modèle
    .hint = `{ $key }` appartient à `model = "{ $model }"`

nominal-unknown = [nominal] mentionne `{ $parameter }`, qui n’est pas un paramètre de ce robot

nominal-length-not-positive = la longueur `{ $parameter }` doit être positive
    .hint = indiquer la longueur d’après le dessin technique

nominal-missing = [nominal] n’indique pas { $parameters }
    .hint = indiquer la géométrie de votre machine d’après le dessin technique, en mm : elle n’est jamais devinée

tolerance-not-positive = la tolérance `{ $parameter }` doit être positive
    .hint = indiquer la tolérance du dessin technique

tolerance-unknown = `tolerance` mentionne `{ $parameter }`, qui n’est pas un paramètre de ce robot

selection-empty = `{ $stated }` ne désigne aucune pose
    .expected = des noms et des plages comme "1-8, 12, home", une liste de noms et de plages, "all", "rest" ou "index mod 10 < 7"

not-a-measured-value = `{ $value }` n’est pas une valeur mesurée
    .expected = un nombre fini

value-of-other-kind = { $element ->
        [yes] un élément de `{ $key }`
       *[no] `{ $key }`
    } est { $found }

kind-of-value = { $kind ->
        [text] un texte
        [date] une date sans guillemets
        [list] une liste de { $length }
       *[table] une table
    }

unknown-variant = valeur inconnue `{ $text }`

key-missing = la clé `{ $key }` manque{ $has_section ->
        [yes] {" "}dans `{ $section }`
       *[no] {""}
    }

campaign-title = { $kind ->
        [calibration] Étalonnage :
        [geometry] Étalonnage géométrique :
       *[test] Essai :
    } { $robot }

campaign-title-dated = { $kind ->
        [calibration] Étalonnage :
        [geometry] Étalonnage géométrique :
       *[test] Essai :
    } { $robot }, { $date }

state-unit = indiquer `unit = "mm"`, ou "m", "um" ou "inch", l’unité dans laquelle le fichier a été écrit ; elle n’est jamais devinée

state-instrument = [instrument] indique name, expanded_uncertainty_um et coverage_factor : les prendre dans son certificat d’étalonnage

state-file = indiquer le fichier, dans le dossier de la campagne

copy-keys = `etalon init DOSSIER` écrit une campagne avec toutes les clés à copier

toml-invalid = { $reason }

table-key-twice = cette table contient la clé deux fois{ $more ->
        [0] {""}
        [one] , et répète encore { $more } clé
       *[other] , et répète encore { $more } clés
    }
    .hint = une table parmi plusieurs commence par son en-tête entre doubles crochets, comme `[[joint]]` : un en-tête manque-t-il avant cette clé ?

unknown-key = { $count ->
        [one] clé inconnue { $keys }
       *[other] clés inconnues { $keys }
    }

key-belongs-at-top = `{ $key }` doit figurer en tête, avant la première section

table-head-missing = l’en-tête de leur table manque-t-il, comme `[section]` ou `[[joint]]` ?

key-remedy = { $key ->
        [station] les stations d’un instrument sont une colonne `station` d’un tableau d’observations : indiquer {"["}observations] au lieu d’exports et de journal
       *[base_turn_y_deg] supprimer la clé : base_rx, base_ry et base_rz sont un vecteur de rotation, et aucune orientation de la base n’est singulière
    }

urdf-no-robot = le fichier n’est pas un fichier URDF
    .expected = l’élément <robot>

xacro-construct = `{ $construct }` de xacro n’est pas développé ici
    .hint = développer le fichier, et indiquer l’URDF à sa place : { $command }

urdf-joint-twice = il y a deux articulations `{ $joint }`
    .hint = renommer l’une des deux

urdf-joint-link-unknown = l’articulation `{ $joint }` mentionne le segment `{ $link }`, absent du fichier

urdf-joint-without-link = l’articulation `{ $joint }` n’a pas de <{ $child } link="..."/>
    .hint = ajouter l’élément

urdf-limits-exchanged = les limites de l’articulation `{ $joint }` sont inversées : { $lower } à { $upper }
    .hint = les inverser

urdf-angles-beyond-turn = des angles de `rpy` dépassent un tour complet
    .hint = les angles d’un fichier URDF sont en radians : 90 deg valent 1,5707963267948966

urdf-attribute-missing = <{ $element }> n’a pas de `{ $attribute }`
    .hint = ajouter l’attribut

urdf-not-number = `{ $attribute }` : `{ $word }` n’est pas un nombre
    .hint = corriger la valeur

urdf-number-count = `{ $attribute }` a { $count ->
        [one] { $count } nombre
       *[other] { $count } nombres
    }
    .expected = { $expected_count ->
            [one] un nombre
           *[other] { $expected_count } nombres
        }

key-open = `{ $key }` reste à compléter
    .hint = compléter la ligne{ $remark ->
        [none] {""}
       *[other] {" "}: { $remark }
    }

joint-unit-open = l’unité des articulations reste à indiquer
    .hint = écrire deg, rad, mm ou m au lieu de UNIT

angle-unit-open = l’unité des rotations mesurées reste à indiquer
    .hint = écrire deg ou rad au lieu de UNIT dans `rx_UNIT`, `ry_UNIT` et `rz_UNIT`

time-unit-open = l’unité des temps reste à indiquer
    .hint = écrire `time_s`, `time_ms`, `time_us` ou `time_ns` au lieu de `time_UNIT`

kind-expected = { $kind ->
        [text] un texte
        [number] un nombre
        [whole] un nombre entier{ $limit ->
            [none] {""}
           *[other] {" "}à partir de { $limit }
        }
        [list] une liste{ $limit ->
            [none] {""}
           *[other] {" "}de { $limit }
        }
       *[table] une table
    }

alternatives = { $first ->
        [none] {""}
       *[other] { $first } ou{" "}
    }{ $last }

### Messages de run ; explications dans en/run.ftl.

contact-without-targets = [contact] est sans effet sur les résidus de la pose
    .hint = indiquer `residuals = "targets"`, ou supprimer [contact]

uncertainty-source = { $section ->
        [instrument] la prendre dans le certificat d’étalonnage de l’instrument
        [tool] indiquer l’incertitude du point sur l’outil
       *[contact] toucher plusieurs fois le même point et prendre la dispersion des lectures des codeurs
    }

key-uncertainty-implausible = `{ $key }` = { $value } ne peut pas être l’incertitude d’une coordonnée mesurée en micromètres
    .expected = une valeur de { $least } à { $most }
    .hint = vérifier l’unité : 0,0027 mm font 2,7 µm

target-named-twice = la cible `{ $target }` est indiquée deux fois
    .hint = indiquer chaque cible une fois

limit-without-result = la limite `{ $limit }` nécessite { $needs ->
        [identify] {"["}identify]
        [commanded] {"["}repeatability] avec `commanded`, ou [poses]
       *[repeatability] {"["}repeatability] ou [poses]
    }
    .hint = supprimer la limite, ou ajouter la section qui détermine la grandeur

section-beside-observations = `{ $section }` figure en plus de [observations]
    .hint = indiquer soit [observations], soit [[export]], [[log]] et [join]

join-clock-missing = une jointure par le temps nécessite { $keys }
    .hint = ajouter à [join] { $lines } : le décalage est l’instant de la mesure moins celui du journal. Si les horloges diffèrent, indiquer `clock_offset_s = "standstills"`, et dans [log] `{ $standstill }`

standstills-missing = le décalage des horloges ne peut pas être estimé : le journal `{ $log }` n’a pas de [log.standstill]
    .hint = ajouter à [log] `{ $standstill }` (`within_mm` pour les articulations prismatiques), ou donner à `clock_offset_s` une valeur numérique

interpolate-with-standstills = `interpolate` est sans effet : le journal `{ $log }` a [log.standstill]
    .hint = supprimer `interpolate` : chaque point est joint à l’arrêt qui contient son instant

key-of-other-join = `{ $key }` est sans effet dans cette jointure
    .hint = supprimer `{ $key }`, ou indiquer `by = "{ $by }"`

key-negative = `{ $key }` est négatif
    .expected = zéro ou un nombre positif

key-above-maximum = `{ $key }` dépasse { $most }
    .hint = vérifier la valeur et son unité

join-label-missing = une jointure par étiquette exige l’étiquette du point dans le journal `{ $log }`
    .hint = ajouter `label` à ses `columns`, avec le nom ou le numéro de la colonne

key-and-column = `{ $key }` est indiqué deux fois : comme clé de l’export et comme une de ses colonnes
    .hint = supprimer l’un des deux

key-and-file-name = `{ $key }` est indiqué deux fois : par le nom du fichier, et par une clé, une colonne ou l’étiquette
    .hint = supprimer l’un des deux

input-in-output-folder = le dossier de sortie contient l’entrée `{ $input }`
    .expected = un dossier sans fichiers d’entrée : une exécution remplace le dossier entier
    .hint = indiquer un autre dossier, ou supprimer `output` : la valeur par défaut est `out`

feature-element = l’élément `{ $feature }` doit désigner un seul élément géométrique
    .expected = l’une des clés `plane`, `line`, `circle`, `cylinder` avec les étiquettes de ses points

feature-label-twice = l’élément `{ $feature }` mentionne `{ $label }` deux fois
    .hint = indiquer chaque étiquette une fois

nominal-without-tolerance = `nominal_mm` et `tolerance_mm` du repère atelier vont de pair
    .hint = indiquer les positions du dessin technique et la plus grande distance admise entre un point et sa position

world-frame-definition = le repère atelier doit être défini d’une seule manière
    .expected = `plane` avec `origin` et un axe, ou `targets`, ou `as_exported = true`

key-of-other-frame = `{ $key }` est sans effet dans ce repère atelier
    .hint = supprimer `{ $key }`, ou définir le repère par `{ $definition }`

frame-axis-without-direction = l’axe du repère atelier n’a pas de direction
    .expected = deux étiquettes (de, à), ou un élément qui a une direction

plane-frame-incomplete = un repère atelier défini par un plan exige `origin`, soit `x_axis` soit `y_axis`, et `towards`
    .hint = indiquer dans `towards` un point dont la coordonnée le long de l’autre axe est positive : il détermine le sens de z

file-name-empty = le nom du fichier est vide
    .hint = indiquer le fichier dans le dossier de la campagne

date-invalid = `{ $key }` ne commence pas par une date du calendrier
    .expected = année-mois-jour (ISO 8601), par exemple 2026-01-31
dates-out-of-order = `{ $later }` ({ $second }) précède `{ $earlier }` ({ $first })
    .hint = corriger l’une des dates

temperature-implausible = `temperature_c` = { $value } n’est pas la température d’un robot en degrés Celsius
    .expected = une valeur de { $least } à { $most }
    .hint = vérifier l’unité : 293,15 K font 20 °C

geometric-step-missing = il manque à [geometric] la clé `{ $missing }`, nécessaire à `{ $step }`
    .hint = l’ajouter ; s nécessite `shaft` et `arc` ; d1 et d3 nécessitent `offsets`, `mid_travel_mm`, `arc`, `turn` et `shaft` ; O nécessite `arc` ; C nécessite `turn`

errors-table-incomplete = un tableau d’erreurs nécessite l’étalonnage géométrique complet et [identify]
    .hint = indiquer toutes les étapes de [geometric] et [identify], ou supprimer le tableau

key-out-of-range = `{ $key }` = { $value } est hors de la plage de { $least } à { $most }

plausible-value = { $quantity ->
        [scale] vérifier l’unité : 1 µm/m vaut 1 ppm
        [polar] vérifier l’unité : 10 ppm valent 10 µm/m, 1 seconde d’arc vaut 4,85 µm/m
        [expansion] vérifier l’unité : l’acier se dilate de `11.5e-6` par degré, l’aluminium de `23.5e-6`
        [temperature] l’indiquer en degrés Celsius
        [coverage] indiquer le facteur d’élargissement : 2 correspond à une probabilité de couverture d’environ 95 %
       *[homing] faire plusieurs prises d’origine et prendre la dispersion de l’articulation à son interrupteur
    }

homing-incomplete = il manque à [homing] `{ $key }` pour l’articulation `{ $joint }` (valeurs en { $unit })
    .hint = l’indiquer, ou indiquer 0 si la prise d’origine n’ajoute pas d’erreur

polar-with-observations = `polar` nécessite des exports : un tableau d’observations ne contient pas la position de l’instrument
    .hint = indiquer la covariance de chaque ligne (`cxx_mm2` à `czz_mm2`) dans le tableau

section-without-identify = [{ $section }] est sans effet : la campagne n’a pas de section [identify]
    .hint = supprimer [{ $section }], ou ajouter [identify]

label-unknown = aucun point n’a l’étiquette `{ $label }`

feature-unknown = élément inconnu `{ $feature }`

point-or-feature-unknown = point ou élément inconnu `{ $name }`

target-not-exported = aucun export ne contient la cible `{ $target }`

names-unchecked = aucun export lisible ne contient { $names }
    .hint = vérifier ces noms quand tous les exports seront lisibles

target-not-of-robot = `{ $target }` n’est pas une cible de ce robot

targets-incomplete = `targets` omet `{ $target }`
    .expected = toutes les cibles de ce robot

travel-missing = l’espace de travail exige la course des actionneurs
    .hint = indiquer `travel_mm` des trois actionneurs sous [reach] dans robot.toml

z-column-missing = `columns` n’indique pas z, nécessaire à un robot tridimensionnel
    .hint = ajouter `z`, avec le nom ou le numéro de la colonne

log-name-invalid = `{ $name }` ne peut pas être le nom de ce journal
    .expected = lettres, chiffres, `_` et `-` ; un nom différent pour chaque journal

log-joint-unknown = `{ $key }` n’est pas une articulation de ce robot
    .hint = utiliser l’une des articulations { $joints }, éventuellement dans une autre unité

log-joint-missing = le journal `{ $log }` n’a pas de colonne pour l’articulation `{ $joint }`
    .hint = ajouter `{ $column }` à ses `columns`, avec le nom ou le numéro de la colonne

label-form-differs = aucune étiquette de `{ $file }` n’a la forme `{ $form }`
    .hint = indiquer la forme de ses étiquettes avec {"{"}target{"}"}, {"{"}pose{"}"} et {"{"}cycle{"}"} ; la première est `{ $first }`

results-not-synced = les résultats ne peuvent pas être écrits sur le disque : { $reason }
    .hint = vérifier le disque, puis relancer le lot

threads-failed = les campagnes ne peuvent pas être exécutées en parallèle : { $reason ->
        [ended] un fil d’exécution s’est terminé sans résultat
       *[other] { $reason }
    }
    .hint = relancer avec moins de fils d’exécution : `RAYON_NUM_THREADS=1`

data-elsewhere = ses données sont dans le dossier ${ $name }, variable d’environnement non définie

not-an-output-folder = `{ $folder }` n’est pas le dossier de sortie d’une exécution : manifest.json y manque
    .hint = indiquer un dossier écrit par `etalon run`, ou une campagne exécutée

file-not-of-run = l’exécution n’a pas écrit `{ $file }`
    .hint = relancer la campagne : `etalon run CAMPAGNE`

file-changed-since-run = `{ $file }` a été modifié après l’exécution
    .expected = le SHA-256 { $sha256 } de manifest.json
    .hint = relancer la campagne : `etalon run CAMPAGNE`

folder-replaced = un autre processus a remplacé `{ $folder }` pendant sa lecture
    .hint = répéter la commande quand l’autre processus est terminé

document-unreadable = `{ $file }` n’est pas un document de cette version : { $reason }
    .hint = relancer la campagne avec cette version : `etalon run CAMPAGNE`

document-schema-other = `{ $file }` { $schema ->
        [none] n’a pas de schéma
       *[other] a le schéma `{ $schema }`
    }
    .expected = le schéma `{ $wanted }`
    .hint = relancer la campagne avec cette version : `etalon run CAMPAGNE`

foreign-file = `{ $file }` serait écrasé, alors qu’aucune exécution ne l’a écrit
    .hint = le déplacer dans un autre dossier, ou indiquer un autre `output` dans campaign.toml

input-changed = `{ $file }` a changé pendant l’exécution de la campagne
    .hint = relancer la campagne quand le fichier est complet

identify-missing = la campagne n’a pas de section [identify], qui désigne les poses sur lesquelles juger les paramètres
    .hint = indiquer `calibration` et `validation` dans [identify]

clock-rate-without-offset = `clock_rate` exige `clock_offset_s` avec le même mot : `standstills` ou `motion`
    .hint = indiquer `clock_offset_s` avec le même mot, ou omettre `clock_rate`

label-form-missing = les étiquettes de `{ $file }` mentionnent des cibles, mais la forme des étiquettes n’est pas indiquée
    .hint = indiquer `label = "{ $form }"` dans ce [[export]] : toutes ses étiquettes ont cette forme

state-targets = indiquer `targets = { $targets }` dans [join] : les étiquettes les mentionnent
valid-until-no-date = `valid_until` n’est pas une date : "{ $date }"
    .expected = le dernier jour de validité entre guillemets, comme "2027-03-02"

valid-until-before-measurements = `valid_until` ({ $date }) précède les mesures ({ $measured })
    .hint = corriger `valid_until` ou `date`

template-name-reserved = une exécution écrit elle-même `{ $file }`
    .hint = renommer le gabarit

controller-template = gabarit d’un format de contrôleur

field-of-other-parameters = `{ $field }` n’appartient pas à `{ $parameters }` : l’empreinte des paramètres diffère
    .hint = indiquer les deux fichiers d’une même exécution
valid-stated-twice = `valid_until` et `valid_for_months` sont indiqués tous les deux
    .hint = omettre l’un des deux

valid-months-without-date = `valid_for_months` exige la date (`date`) des mesures
    .hint = indiquer `date = "2026-03-02"`, ou le dernier jour par `valid_until`

valid-months-implausible = `valid_for_months` vaut { $months }
    .expected = 1 à { $most } mois

### Messages de controllers ; explications dans en/controllers.ftl.

compensate-programs = un langage ou un fabricant de programmes de robot : corriger ses programmes par `etalon compensate PROGRAMME` ; `etalon cell` écrit l’outil et le repère objet

controller-format-unknown = `{ $name }` n’est pas un format de contrôleur

kind-hexapod = un hexapode (`hexapod`)

kind-five-bar = un robot à cinq barres (`five_bar`)

kind-six-axis-arm = un bras série à six articulations rotoïdes

kind-delta = un robot delta (`delta`, `delta_linear`)

kind-delta-towers = un robot delta à axes linéaires (`delta_linear`)

kind-urdf = un robot décrit par un fichier URDF (`urdf`)

kind-planar-or-serial = un robot plan ou un bras série

format-for-other-robots = le format `{ $format }` ne peut pas décrire un robot de `model = "{ $model }"`
    .expected = { $kind }
    .hint = choisir un autre format : `etalon export --help` les énumère

format-too-many-joints = le robot a { $joints } articulations, le format `{ $format }` en admet { $most }

urdf-malformed = `{ $file }` n’est pas un document XML bien formé
    .hint = corriger le fichier

formulas-missing = la cinématique de `{ $model }` ne peut pas être écrite en code : etalon ne contient pas de formules explicites pour ce modèle
    .hint = utiliser un format qui contient des paramètres : `json`, `csv`, `c-header`

formula-constant-not-finite = une constante de la cinématique n’est pas finie
    .hint = vérifier les paramètres identifiés

error-above-nominal = erreur de position aux poses { $set ->
        [validation] de validation
       *[other] d’étalonnage
    }{ $left_out_count ->
        [0] {""}
       *[other] {" "}sans { $left_out }
    } : { FIXED($written_mm, $decimals) } mm (RMS) ; avec les paramètres nominaux : { FIXED($nominal_mm, $decimals) } mm

file-worse-than-nominal = le format `{ $format }` n’est pas écrit : { $reason }
    .hint = utiliser un format qui contient ces paramètres ; `etalon export --force` écrit le fichier

error-near-nominal = { $case ->
        [rms] l’erreur de position n’est pas nettement inférieure à celle des paramètres nominaux
        [maximum] la plus grande erreur de position est supérieure à celle des paramètres nominaux
       *[both] l’erreur de position n’est pas nettement inférieure à celle des paramètres nominaux, et son maximum est supérieur
    } : poses { $set ->
        [validation] de validation
       *[other] d’étalonnage
    } { FIXED($written_mm, $decimals) } mm (RMS), { FIXED($written_max_mm, $decimals) } mm (maximum) ; nominal { FIXED($nominal_mm, $decimals) } mm et { FIXED($nominal_max_mm, $decimals) } mm

file-near-nominal = { $formats_count ->
        [1] format
       *[other] formats
    } `{ $formats }` : { $reason }
    .hint = comparer les erreurs dans controllers.json ; si le format omet des paramètres, utiliser un format qui les contient

file-of-other-structure = format `{ $format }` : les axes de ce bras diffèrent de ceux des bras Universal Robots : { $difference }
    .hint = vérifier convention, ordre et signes dans robot.toml ; pour un bras d’un autre fabricant, choisir un autre format : `etalon export --help` les énumère

structure-angle = les axes { $first } et { $second } forment un angle de { FIXED($deg, 1) }° au lieu de { FIXED($expected, 0) }°

structure-no-link = les axes { $first } et { $second } sont parallèles à { FIXED($mm, 1) } mm, sans segment entre eux

structure-apart = les axes { $first } et { $second } passent à { FIXED($mm, 1) } mm l’un de l’autre au lieu de se couper

structure-wrist-meets = les axes 4 et 6 coupent l’axe 5 à { FIXED($mm, 1) } mm l’un de l’autre au lieu d’une longueur de poignet

structure-wrist-in-plane = le poignet est à { FIXED($mm, 1) } mm du plan de l’axe 1 au lieu d’un déport d’épaule

covariance-missing = le format `{ $format }` ne contient pas { $parameters }, et parameters.json ne donne pas leur covariance
    .hint = exécuter la campagne avec `controllers = ["{ $format }"]` : l’exécution identifie de nouveau sans ces paramètres

parameters-not-converged = les paramètres ne conviennent pas à un contrôleur : { $termination }
    .hint = identifier de nouveau avant l’export

covariance-not-finite = la covariance contient un nombre non fini
    .hint = relancer l’identification

parameter-not-finite = le paramètre `{ $parameter }` contient un nombre non fini
    .expected = valeur, valeur nominale et incertitude finies

parameter-twice = il y a deux paramètres `{ $parameter }`
    .hint = relancer l’identification

parameter-names-collide = les paramètres `{ $first }` et `{ $second }` s’appellent tous deux `{ $name }` en { $language }
    .hint = renommer la cible ou l’articulation qui donne son nom à l’un des deux, ou utiliser un autre format

parameter-missing = le paramètre `{ $parameter }` manque
    .hint = indiquer le robot.toml avec lequel les paramètres ont été identifiés

positions-not-measured = le format `{ $format }` contient des positions mesurées, mais aucune position mesurée n’accompagne ces paramètres
    .expected = le parameters.json du dossier de sortie d’une campagne qui a mesuré des positions

recording-failed = l’enregistrement ne peut pas être écrit : { $reason }

robot-missing = ce format exige le modèle du robot
    .hint = indiquer le robot.toml : `--robot FICHIER`

robot-parameter-missing = le robot n’a pas de paramètre `{ $parameter }`
    .hint = choisir un autre format : `etalon export --help` les énumère

deviation-steep = l’écart varie de { $change } entre { $from } et { $to }
    .expected = au plus 5 % de la distance
    .hint = indiquer positions et écarts dans la même unité, mm ou deg

axis-table-too-long = { $positions } positions sont trop nombreuses pour { $controller }
    .expected = au plus { $most }

axis-table-too-short = une table SINUMERIK a { $positions ->
        [one] { $positions } position
       *[other] { $positions } positions
    }
    .expected = au moins deux positions

axis-positions-uneven = les positions ne sont pas équidistantes
    .hint = mesurer à intervalles réguliers ou utiliser une autre table

plane-steps-differ = la grille a des pas différents selon ses axes
    .expected = { $step_mm } mm selon les deux

galil-value-too-large = `{ $parameter }` est trop grand pour une variable d’un contrôleur Galil
    .hint = utiliser un format à virgule flottante

galil-constant-too-large = { $name } = { FIXED($value, 6) } est trop grand pour la cinématique inverse sur un contrôleur Galil
    .expected = au plus { $most }

galil-rounding = `{ $parameter }` perd { SCIENTIFIC($rounding, 1) } { $unit } par arrondi sur un contrôleur Galil ; son incertitude-type est de { SCIENTIFIC($uncertainty, 1) } { $unit }
    .hint = utiliser un format à virgule flottante

galil-axes = { $joints } articulations sont trop nombreuses pour un contrôleur Galil
    .expected = au plus huit

galil-counts-out-of-range = cible { $target } : { $counts } impulsions sont hors plage
    .expected = au plus { $most } impulsions

certificate-date-missing = un certificat d’étalonnage exige la date des mesures
    .expected = `date = "YYYY-MM-DD"` dans campaign.toml
    .hint = indiquer la date et relancer la campagne

targets-not-finite = une valeur du plan n’est pas finie
    .hint = vérifier les plages des articulations et les conditions du plan ; aucune cible n’est écrite

targets-format-unknown = la terminaison de `{ $file }` n’est pas un format de cibles
    .expected = un nom qui se termine par `.json` ou `.h`
    .hint = pour CSV, utiliser `--poses`

axes-coincide = deux axes du bras coïncident
    .hint = vérifier le robot.toml

platform-out-of-reach = la plate-forme n’atteint pas le centre
    .hint = vérifier les longueurs identifiées

tower-order = les colonnes ne sont pas à 120 deg l’une de l’autre, dans le sens trigonométrique vu d’en haut
    .hint = les numéroter dans le sens trigonométrique : `{ $format }` les exige dans cet ordre

move-incomplete = `{ $command }` n’indique pas { $coordinates }
    .hint = indiquer toutes les coordonnées

x-and-y = à la fois X et Y

position-of-every-axis = une position de chaque axe

pose-of-six = toutes les coordonnées X, Y, Z, A, B et C

working-mode-changes = le programme change de mode de travail
    .hint = donner les cibles de chaque mode de travail dans un programme séparé

movement-not-compensated = `{ $command }` n’est pas compensé
    .expected = des mouvements rectilignes vers des coordonnées absolues

subroutine-not-compensated = les variables et sous-programmes ne sont pas compensés
    .hint = écrire les cibles sous forme de nombres

coordinate-not-number = `{ $letter }` n’est pas suivi d’un nombre
    .hint = écrire la coordonnée sous forme de nombre

coordinate-unknown = `{ $letter }` n’a pas encore de valeur
    .hint = l’indiquer dans le premier bloc de déplacement

quaternion-length = le quaternion de { $target } a pour norme { FIXED($length, 4) }
    .expected = norme 1

template-without-holds = le gabarit n’indique pas les paramètres que contient son fichier
    .expected = une première ligne comme `{"{#"} holds: theta_* {"#}"}`
    .hint = nommer les paramètres ; `*` remplace un texte quelconque, et `holds: *` tous les paramètres

convert-to-denavit-hartenberg = un bras décrit par des axes de vissage (`poe`) n’a pas de zéros d’articulation : écrire son robot.toml par `etalon robot convert robot.toml --to dh`, et relancer la campagne

template-holds-unknown = aucun paramètre ne correspond à `{ $pattern }`

template-parameters-unread = le gabarit nomme { $count ->
        [one] 1 paramètre
       *[other] { $count } paramètres
    } sans en écrire la valeur : { $names } ; les erreurs de ce fichier sont celles d’un autre fichier
    .hint = après `holds:`, ne nommer que les paramètres que le gabarit écrit

template-name = le nom du gabarit `{ $file }` ne se termine pas par `.j2`
    .hint = renommer le gabarit : NOM.j2 écrit le fichier NOM

controller-template-failed = le gabarit ne peut pas être rempli : { $reason }
    .hint = corriger cette ligne

measuring-language-unknown = le langage de { $file } est inconnu
    .expected = .mod (RAPID), .src (KRL), .script (URScript), .ls (FANUC), .kl (Karel), .jbi (INFORM) ou .ngc (G-code), ou `--program-language`

measuring-joints-unsuited = un programme en { $language } déplace six axes rotoïdes{ $external ->
        [0] { "" }
       *[other] , après { $external } axes externes prismatiques au plus
    } ; ce robot a { $revolute } articulations rotoïdes et { $prismatic } prismatiques
    .hint = écrire les poses par `--poses FICHIER` ou `--targets FICHIER`

measuring-motor-values = les valeurs de l’articulation { $joint } sont celles de son moteur (gain { $gain }), qu’un programme ne commande pas
    .hint = écrire les poses par `--poses FICHIER`, et les convertir en valeurs articulaires

measuring-output-unsuited = `{ $output }` n’est pas une sortie numérique de { $language }
    .expected = { $language ->
        [rapid] le nom d’un signal
       *[other] un nombre de { $first } à { $last }
    }

measuring-axes-missing = un programme en { $language } demande la lettre de chacun des { $joints } axes
    .hint = les indiquer dans l’ordre des articulations : `--axes LETTRES` (parmi XYZABCUVW)

measuring-pulses-missing = un programme en { $language } demande les impulsions par deg ou mm de chacune des { $joints } articulations
    .hint = les indiquer dans l’ordre des articulations : `--pulses P1,P2,...`


linuxcnc-distant-normal = les axes { $first } et { $second } sont presque parallèles : `genserkins` place leur normale commune à { FIXED($away_mm, 0) } mm, si bien que des valeurs arrondies déplacent la bride
    .hint = utiliser le format `linuxcnc-component`, qui contient l’angle de Hayati et les axes de vissage

linuxcnc-joint-offsets = `genserkins` n’a pas de décalages articulaires : sans eux, la bride s’écarte de { FIXED($off_mm, 1) } mm aux valeurs articulaires nulles. Décalages par articulation de LinuxCNC (deg) : { $offsets_deg }
    .hint = les ajouter à HOME_OFFSET, HOME, MIN_LIMIT et MAX_LIMIT de [JOINT_n], ou utiliser `linuxcnc-component`

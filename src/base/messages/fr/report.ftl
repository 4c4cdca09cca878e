### Textes des rapports ; les termes de l’ISO 9283 sont ceux de son édition française.

accepted = accepté
accuracy = Exactitude
accuracy-at-pose = Plus grande valeur de l’exactitude de pose AP : { $accuracy } µm, à la pose { $pose }.
accuracy-not-tested = La campagne n’a pas de positions commandées : l’exactitude de pose (AP) n’est pas évaluée.
accuracy-drifts = AP varie de façon significative pendant l’essai { $count ->
        [one] à la pose { $poses }
       *[other] aux poses { $poses }
    }. L’intervalle y contient AP de chaque série de cycles : ce n’est pas l’intervalle élargi d’un robot stable.
accuracy-of-position = Exactitude de positionnement
accuracy-over-cycles = Exactitude de pose de chaque pose au cours de l’essai.
action-label = à faire :
actual-lead = pas réel
actuator = actionneur
after = après
after-named = { $name }, après
against = en fonction de
agree = en accord
all-distances = toutes
all-poses-conform = { $count ->
        [one] la seule pose est conforme
       *[other] les { $count } poses sont toutes conformes
    }
all-tables = Tous les tableaux
allowed = admissible
along-path-in-mm = le long de la trajectoire (mm)
amends-report = amendement au rapport
and-more = et { $count ->
        [one] { $count } autre
       *[other] { $count } autres
    }
angle-ad = AD de l’angle { $axis }
angle-rd = RD de l’angle { $axis }
angle-vap = vAP de l’angle { $axis }
ap-by-set = AP par série
ap-of-judged-approach = AP de la direction d’approche évaluée
ap-interval-from = AP, 95 %, de
ap-interval-to = AP, 95 %, à
ap-within-limit = AP dans sa limite
approach-not-known = direction d’approche inconnue
approaches-unknown = Pose { $pose } : aucune pose enregistrée ne précède { $count ->
        [one] un positionnement
       *[other] { $count } positionnements
    } (cycle { $cycles }), la direction d’approche est donc inconnue. Les valeurs d’une direction d’approche ne contiennent pas { $count ->
        [one] ce positionnement.
       *[other] ces positionnements.
    }
approached = approchée
approved-by = Approuvé par
arc = arc
area = aire
arrivals = arrivées
arrivals-title = Arrivées
arrows-common = Flèches agrandies { $factor } fois, avant comme après ; la plus longue : { $longest }.
arrows-description = Une flèche par position mesurée : position mesurée moins position prédite, agrandie { $factor } fois.
arrows-longest = Flèches agrandies { $factor } fois ; la plus longue : { $longest }.
at-interval-from = AT, 95 %, de
at-interval-to = AT, 95 %, à
at-location = point de AT
at-of-angles = AT des angles (deg)
at-position = { $value }, à { $position } mm
at-rt-diamonds = Losanges : plus grandes valeurs de AT et de RT, avec leurs intervalles. Le maximum de nombreuses valeurs dispersées est biaisé vers le haut : RT peut dépasser l’intervalle valable pour une infinité de passages.
at-tool-point = Au point d’outil : { $count ->
        [one] { $count } pose
       *[other] { $count } poses
    }
attached-accuracy = Erreurs avant et après
attached-campaign = Indications de la campagne
attached-cell = Repères de la cellule
attached-certificate = Certificat d’étalonnage numérique (DCC), projet
attached-changes = Changements entre les campagnes
attached-characteristics = Caractéristiques de l’ISO 9283
attached-compliance = Compliance statique
attached-controllers = Fichiers pour le contrôleur
attached-distributions = Distributions des résultats
attached-geometric = Étalonnage géométrique
attached-parameters = Paramètres identifiés, covariance, provenance
attached-plan = Poses choisies
attached-recommendation = Recommandation
attached-selftest = Validation de l’installation
attached-streams = Mouvements enregistrés
attached-validation = Erreurs de paramètres donnés
attached-verification = Poses à vérifier
attached-verified = Vérification
authorised-by = autorisé par
axis-after = après, { $axis }
axis-before = avant, { $axis }
axis-commanded = { $axis } commandé
axis-direction = direction { $axis }
axis-mean = moyenne { $axis }
axis-origin = origine { $axis }
axis-point = point { $axis }
axis-x = x
axis-y = y
axis-z = z
ball = bille
bar-too-uncertain = l’incertitude de la barre est trop grande (4:1 exigé)
base-and-targets = base et cibles
base-motion-explains-most = les paramètres ne sont plus valables : un mouvement de la base de { $by } (k = 2) explique { $percent } % de l’écart ; les résidus restants sont plus grands que prévu
base-moved = la base a bougé de { $by } (k = 2, dans le référentiel atelier)
base-rotation = rotation de la base
base-shift = déplacement de la base
batch-ends = { $pass } conformes, { $conditional } sous réserve, { $undecided } indécidées, { $fail } non conformes, { $failed } non calculées, { $skipped } ignorées
batch-synthetic = { $count ->
    [one] { $count } campagne porte
   *[other] { $count } campagnes portent
} sur des données synthétiques : personne ne les a mesurées, et elles ne prouvent rien sur un robot.
before = avant
before-after-description = Erreurs avec les paramètres nominaux et après étalonnage, sur un même axe.
before-named = { $name }, avant
best-possible-choice = le meilleur choix possible
between-poses = entre les poses
birge-ratio = Rapport de Birge
bootstrap-resamples = Bootstrap : { $count } rééchantillonnages des poses et des cycles.
bootstrap-without-tolerances = Le bootstrap garde les valeurs nominales et omet leurs tolérances. Son u est inférieur à la moitié de la valeur linéaire pour { $count ->
        [one] { $count } paramètre, que les données seules déterminent
       *[other] { $count } paramètres, que les données seules déterminent
    } peu ; la valeur linéaire s’applique.
both = les deux
box-of-poses = La boîte englobe les poses ; ses arêtes sont parallèles aux axes.
branch-and-bound-nodes = nœuds de séparation et évaluation
budget-left-out = U ne comprend pas, faute de valeurs dans la campagne : { $sources }.
budget-note = Contributions aux incertitudes-types (k = 1), dans l’unité de chaque ligne. La dernière colonne est la racine carrée de la somme de leurs carrés. Les effets communs à plusieurs lectures sont traités comme corrélés.
budget-of-default-tolerances = Les tolérances par défaut sont multipliées par { $factor }, le facteur le plus compatible avec les données.
budget-of-errors-note = Incertitude de mesure des erreurs de ce tableau : lectures, repères, base et cibles telles qu’ajustées. Les paramètres identifiés sont l’objet de l’essai et n’y contribuent pas. Les limites sont jugées avec l’incertitude élargie, soit le double de ces valeurs (k = 2).
budget-of-nominal-values = Incertitude-type d’une valeur nominale : tolérance / √3, pour une loi rectangulaire (GUM 4.3.7).
budget-of-parameters = Bilan d’incertitude des paramètres
budget-shares-description = Une barre par résultat : carrés des contributions, en pour cent de la variance.
budget-shares-title = Parts des sources d’incertitude dans la variance
bullet-accepted = acceptée
bullet-beyond = au-delà de la limite
bullet-description = Chaque valeur rapportée à sa limite, avec { $drawn ->
        [interval] les bornes de son intervalle ; la largeur de la bande de garde est la distance de la valeur à la borne supérieure.
        [both] U (k = 2) ou les bornes de son intervalle ; la largeur de la bande de garde est la distance de la valeur à la borne supérieure.
       *[uncertainty] U (k = 2) ; la bande de garde a la largeur U.
    }
bullet-description-accepted = Chaque valeur rapportée à sa limite, avec { $drawn ->
        [interval] les bornes de son intervalle.
        [both] U (k = 2) ou les bornes de son intervalle.
       *[uncertainty] U (k = 2).
    }
bullet-guard-band = bande de garde
bullet-within-u = acceptée, à moins de U de la limite : voir le risque
bullet-not-measured = non mesurée, limite { $limit } { $unit }
bullet-value = valeur
bullet-value-limit = { $value } { $unit }, limite { $limit } { $unit }
bullet-value-limit-drift = { $value } { $unit }, limite { $limit } { $unit }, AP dérive
bullet-value-limit-risk = { $value } { $unit }, limite { $limit } { $unit }, risque { $risk } %
by-approach = Par direction d’approche
bytes = octets
calibration = étalonnage
calibration-certificate = Certificat d’étalonnage
calibration-certificate-draft = Projet de certificat d’étalonnage
calibration-of-synthetic-data = Étalonnage sur données synthétiques, sans valeur de certificat
calibration-report-of-model = Rapport d’étalonnage : { $model }
calibration-report-of-robot = Rapport d’étalonnage du robot { $robot }
campaign = campagne
campaign-as-named = Campagne, dans l’ordre donné
campaign-column = Campagne
campaign-from = { $to } par rapport à { $from }
campaign-of-parameters = campagne des paramètres
campaign-value = campagne { $campaign } : { $value } { $unit }
campaigns = Campagnes
campaigns-in-order = { $count } campagnes, dans l’ordre donné
campaigns-of-robot = { $count } campagnes du robot { $robot }, dans l’ordre donné
campaigns-of-robots = { $campaigns } campagnes de { $robots } robots
campaigns-shown = { $shown } campagnes sur { $total }
candidate-tooltip = pose { $pose }, { $configurations ->
        [one] { $configurations } configuration
       *[other] { $configurations } configurations
    } : x { $x }, y { $y } mm
candidates = candidates
candidates-and-chosen-positions = Candidates et positions choisies
candidates-and-configurations = { $candidates }, { $configurations } configurations
candidates-chosen = { $chosen } candidates sur { $candidates } sont choisies. La taille d’une marque indique le nombre de configurations qui l’atteignent.
candidates-drawn = { $candidates } sur { $draws } tirages ; exclues : { $limits } au-delà des limites, { $region } hors de la boîte, { $sight } tournées à l’opposé
candidates-hidden = { $count } cachées par { $obstacle }
cause-column = Cause
cell-controller-lines = Lignes pour { $maker }
cell-controller-written = Sortie de `--controller { $maker }` ; les mêmes nombres que dans les tableaux.
cell-frames = Repères et points
cell-frames-note = U : incertitude élargie (k = 2) de chaque coordonnée, et d’une petite rotation autour de x, y et z du repère de référence.
cell-head-frame = repère
cell-head-length = longueur
cell-head-measure = grandeur
cell-measure-orientation = orientation
cell-measure-position = position
cell-motion-by-value = mouvement par unité de la valeur de l’axe
cell-residuals-note = Mesuré moins prédit ; orientations en vecteurs de rotation. p : probabilité d’un résidu au moins aussi grand, dû au bruit seul.
cell-residuals-title = Résidus des lectures
cell-step-choose = Afficher les lignes pour le contrôleur : répéter la commande avec `--controller NOM`.
cell-step-choose-reason = `etalon cell --help` énumère les contrôleurs ; chacun a ses unités et son ordre des angles.
cell-step-load = Charger les lignes pour { $maker }.
cell-step-load-reason = Avant la production, vérifier une lecture qui n’est pas dans le tableau.
cell-step-measure = Mesurer davantage de lectures.
cell-step-measure-reason = Les lectures n’ont pas de redondance : rien ne vérifie le résultat.
cell-step-messages = Traiter d’abord les avertissements.
cell-step-messages-reason = Chaque avertissement indique ce qu’il affecte.
cell-subtitle = Cellule de robot, { $readings ->
        [one] une lecture
       *[other] { $readings } lectures
    }
cell-title = { $solve ->
        [tool-point] Centre d’outil
        [tool-reflector] Réflecteur sur l’outil
        [tool-axes] Repère d’outil
        [hand-eye] Étalonnage main-œil
        [object] Objet de travail
        [three-points] Objet de travail par trois points
        [linear-axis] Axe linéaire
       *[rotary-axis] Axe rotatif
    }
cell-verdict-axis = échelle { $scale } ± { $u } (k = 2)
cell-verdict-known = { $frame } : U = { $um } µm selon x, y, z{ $turned ->
        [no] {""}
       *[yes] {" "}et { $deg } deg autour de x, y, z
    } (k = 2)
cell-verdict-unknown = { $frame } : l’incertitude est inconnue
cell-verdict-warnings = { $count ->
        [one] un avertissement limite le résultat
       *[other] { $count } avertissements limitent le résultat
    }
certificate-coverage = U : incertitude élargie, facteur d’élargissement k = 2, probabilité de couverture d’environ 95 % pour une loi normale.
certificate-computed = « Après » est calculé avec les paramètres identifiés d’après les valeurs articulaires de la campagne ; le robot n’a pas été mesuré avec un fichier chargé. « Avant » est calculé avec les paramètres nominaux du robot ; base, cibles et montages sont ajustés dans la mesure où la campagne les laisse libres.
certificate-controller-before = Le contrôleur avait les valeurs de `{ $file }` (SHA-256 { $sha256 }), qui peuvent différer des valeurs nominales.
certificate-controller-unknown = Les valeurs dans le contrôleur ne sont pas indiquées et peuvent différer des valeurs nominales.
certificate-held = Les valeurs s’appliquent ensemble. U suppose que les valeurs fixées sont exactes. Une valeur seule n’est pas la cote d’une pièce du robot.
certificate-interval = U : incertitude élargie de la valeur, facteur d’élargissement k = 2. Dernière colonne : erreur du robot sans le bruit des lectures, probabilité de couverture d’au moins 95 %.
certificate-no-file = Ce certificat ne cite aucun fichier à charger : { $reason }.
certificate-parameters = Paramètres identifiés et fixés
certificate-parameters-hash = parameters.json, SHA-256
certificate-reproduction = Ce document ne doit être reproduit que dans son intégralité.
certificate-without-uncertainty = Les valeurs sans U ni intervalle sont données à titre d’information : leur incertitude n’a pas été évaluée.
chain-of-links = Les paramètres décrivent la chaîne du segment `{ $base }`, référentiel de la base, à { $ends }.{ $count ->
        [0] {""}
       *[other] {" "}Des articulations déplacent le segment `{ $base }` : ce n’est pas la base d’un contrôleur.
    }
change = écart
change-by-u = écart / u
change-over-u = écart / u
change-with-interval = changement ± U (k = 2)
changed = a changé
changed-below = déclaré changé au-dessous de { $significance }
changes = Changements
check-column = Contrôle
checklist-clause = article
checklist-field = champ
checklist-key = clé
checklist-keys = Clés et articles
checklist-note = { $count ->
    [one] Un champ manque. L’indiquer dans campaign.toml et relancer la campagne.
   *[other] { $count } champs manquent. Les indiquer dans campaign.toml et relancer la campagne.
}
checklist-title = À compléter avant signature
checks-of-the-model = Vérifications du modèle
checksums-of-files = Fichiers pour le contrôleur et leurs sommes de contrôle
chi-square = khi-deux
choice = Choix
choice-gap = inférieur d’au plus { $percent } % au meilleur choix possible
choice-proven = Prouvé : aucun autre choix de { $chosen } candidates parmi { $candidates } ne donne un { $index } plus grand
choice-within-percent = { $index } est inférieur d’au plus { $percent } % au meilleur choix possible de { $chosen } candidates parmi { $candidates }
choice-without-bound = Aucune borne n’est connue pour { $index } : un meilleur choix peut exister
chosen = choisies
chosen-candidate-tooltip = pose { $pose }, { $configurations ->
        [one] { $configurations } configuration
       *[other] { $configurations } configurations
    }, choisie : x { $x }, y { $y } mm
chosen-candidates-marks = Marques vides : candidates ; marques pleines avec le numéro de leur pose : choisies.
chosen-one-by-one = { $poses } poses, { $configurations } configurations, une à une
chosen-poses = Poses choisies
chosen-with-all-modes = { $poses } poses, { $configurations } configurations, tous les modes de travail d’une pose ensemble
circle = cercle
circle-x-y = cercle x, y
clause-compliance = compliance statique
clause-cornering = écarts aux angles
clause-directions = variation multidirectionnelle de l’exactitude de pose
clause-distances = exactitude et répétabilité de distance
clause-drift = dérive des caractéristiques de pose
clause-exchangeability = interchangeabilité
clause-not-tested = non essayé
clause-overshoot = dépassement de pose
clause-path-accuracy = exactitude de trajectoire
clause-path-repeatability = répétabilité de trajectoire
clause-pose-accuracy = exactitude de pose
clause-pose-repeatability = répétabilité de pose
clause-posing-time = temps minimal de positionnement
clause-reorientation = exactitude de trajectoire lors d’une réorientation
clause-stabilisation = temps de stabilisation de pose
clause-tested = essayé
clause-velocity = caractéristiques de vitesse sur trajectoire
clause-weaving = écarts de balayage
clauses-evidence = Articles de l’ISO 9283:1998 : essayés, non essayés et vérification de l’évaluation
clauses-note = Le rapport ne vaut que pour les articles essayés. `etalon selftest` répète les comparaisons avec le programme indépendant.
clauses-summary = Articles de l’ISO 9283:1998 essayés : { $tested }. Non essayés : { $untested }.
clauses-title = Articles de l’ISO 9283:1998
colours = Couleurs
command = commande
command-theta = consigne θ
command-x = consigne x
command-y = consigne y
commanded-away = position commandée, à { $distance } µm
commanded-velocity = vitesse commandée
commanded-frequency = fréquence commandée
commanded-stroke = course commandée
commanded-tooltip = position commandée : x { $x }, y { $y }, z { $z } µm depuis la moyenne
compared-with = comparé à
compliance = compliance
condition = conditionnement
condition-number = conditionnement
conditional = sous réserve
conditions = Conditions
configurations = configurations
conforming = conforme
conformity-by-rule = Selon l’{ $rule } : { $results }.
conformity-disproved = réfuté
conformity-neither = ni prouvé ni réfuté
conformity-proved = prouvé
confounded-with = confondu avec
contact = contact
encoders = codeurs
contents = Sommaire
controlled-by = contrôlée par
controller = contrôleur
controller-files = Fichiers pour le contrôleur
convention-angles = les angles a, b, c sont rendus continus et traités séparément ; ordre des rotations : { $order }
convention-angles-not-drift-compensated = la dérive des positions est corrigée par les cibles de référence, la dérive des angles ne l’est pas
convention-angles-of-motion = les angles { $angles } sont rendus continus le long du mouvement et traités séparément
convention-angles-of-unknown-order = les angles a, b, c sont rendus continus et traités séparément ; ordre des rotations : non indiqué
convention-ap-interval = AP : intervalle de la différence, obtenu à partir des deux intervalles (MOVER, Zou & Donner 2008)
convention-ap-rp = AP : moyenne moins position commandée ; RP : rayon moyen + 3 s, s avec n - 1 ; intervalles à 95 %, dispersion gaussienne
convention-approach = approche : depuis la pose précédente de la trajectoire ; règle des 25 % avec U à k = { $k } ; positions dans le repère atelier ({ $frame })
convention-at-rt = AT : intervalle de la différence, obtenu à partir des deux intervalles, comme pour AP ; RT : même méthode, à l’échelle logarithmique, autour des centres des deux intervalles, qui estiment RT pour une infinité de passages ; dans des essais simulés de dix passages, les intervalles du bootstrap contiennent la valeur vraie dans 90 % à 98 % des cas au lieu de 95 %, selon le type de dispersion
convention-birge = erreur du modèle : les intervalles des changements de paramètres sont élargis par le rapport de Birge (au moins 1) de tous les paramètres du robot des deux campagnes ; en effet, les paramètres absorbent l’erreur du modèle aux poses mesurées
convention-change-of-parameters = paramètres : changement divisé par la racine carrée de u1² + u2², loi de Student avec les degrés de liberté de Welch si les incertitudes sont estimées à partir des résidus ; les deux campagnes sont supposées indépendantes
convention-compared-with = chaque campagne est comparée à la première et à la précédente, dans l’ordre donné
convention-compliance = compliance : déplacement suivant la force par unité de force, par moindres carrés, droite passant par la position sans charge
convention-compliance-clause = l’article 10 n’a pas été comparé à un exemplaire acheté de la norme
convention-different-instruments = les campagnes ont des instruments différents : une différence systématique entre instruments, que la dispersion ne révèle pas, apparaît comme un changement du robot
convention-drift-compensated = la dérive des positions et des orientations est corrigée par les cibles de référence
convention-f-test = paramètres dans leur ensemble : test F ; le test est approché si les incertitudes sont estimées à partir des erreurs des poses ; il est alors trop souvent significatif si une pose n’a qu’une ou deux coordonnées mesurées
convention-first-robot = { $count } robots : tous les résultats, sauf l’interchangeabilité, se rapportent à `{ $robot }`
convention-guarded-acceptance = conformité : acceptation avec bande de garde (ILAC-G8:09/2019, 4.2.3) : limite respectée ou non respectée seulement si l’intervalle à 95 % est entièrement d’un côté de la limite
convention-interval-of-sets = AP dérive de façon significative { $count ->
        [one] à la pose { $poses }
       *[other] aux poses { $poses }
    } : l’intervalle y contient AP de chaque série de cycles
convention-intervals-instrument = les intervalles tiennent compte de l’échantillonnage et de l’incertitude élargie de l’instrument pour une coordonnée, { $uncertainty_um } µm (k = 2)
convention-intervals-sampling = les intervalles ne tiennent compte que de l’échantillonnage : aucune incertitude de l’instrument n’est indiquée
convention-limit-band = bande limite : { $band } mm autour de la moyenne de l’arrêt
convention-mean-errors = erreurs moyennes : test t de Welch, avec une erreur par pose ; le test est conservateur (trop rarement significatif) si les deux campagnes ont mesuré les mêmes poses
convention-mean-positions = positions moyennes : test t de Welch de chaque coordonnée, d’après la dispersion des positionnements ; l’incertitude des repères de mesure n’est pas comprise
convention-motion-clauses = les articles 7.4, 7.5, 8, 9 et 11 n’ont pas été comparés à un exemplaire acheté de la norme
convention-no-commanded-poses = pas de poses commandées : AP, distances et dérive ne sont pas évaluées (null)
convention-path = trajectoire : plans normaux en { $points } points commandés, au milieu de parts égales de la trajectoire ; pour chaque plan, la dernière traversée à moins de { $near } mm
convention-path-corners = aucun plan à moins de { $near } mm d’un angle (au plus un quart de son côté) ; les angles sont évalués à part
convention-path-intervals = AT et RT : intervalles pour une infinité de passages, par bootstrap paramétrique sur les passages ; dans des essais simulés de dix passages, ils contiennent la valeur vraie dans 90 % à 98 % des cas, selon le type de dispersion
convention-path-velocities = vitesses entre les plans dans les { $percent } % centraux de la trajectoire
convention-planar = les positions commandées n’ont pas de z : toutes les caractéristiques, sauf la coplanéité, sont évaluées dans le plan xy
convention-positions-drift-compensated = la dérive des positions est corrigée par les cibles de référence
convention-readings-averaged = la moyenne des lectures de chaque positionnement est utilisée ; leur dispersion est le bruit de l’instrument
convention-rotation-vectors = AP rx à rz : vecteur de rotation de l’orientation commandée à l’orientation moyenne, autour de x, y, z du tableau ; RP rx à rz : trois écarts-types des rotations par rapport à l’orientation moyenne ; AD r, RD r, vAP r : angles entre orientations
convention-rp-clause = RP suit le texte de la norme (7.2.2) ; les autres articles n’ont pas été comparés à un exemplaire acheté
convention-rp-ratio = RP : test F du rapport, avec les degrés de liberté de l’intervalle en forme explicite (dispersion gaussienne)
convention-set-up = les paramètres de la base et des cibles changent à chaque montage : leur changement ne vient pas forcément du robot
convention-shared-instrument = toutes les campagnes ont le même instrument { $instrument } : ses erreurs constantes s’annulent dans les changements, dont l’incertitude est surestimée si u contient ces erreurs ; la dérive de l’instrument entre les campagnes apparaît comme un changement du robot
convention-shared-risk = conformité : acceptation à risque partagé (JCGM 106:2012, 8.2.1) : décision si l’incertitude élargie est au plus le quart de la limite
convention-significance = un changement est significatif si sa valeur p, corrigée du nombre de grandeurs de sa famille dans une paire de campagnes, est inférieure à 5 % ; paramètres : correction par la loi du plus grand changement, avec les covariances (Westfall & Young 1993) ; autres grandeurs : correction de Holm (1979) ; les intervalles à 95 % ne sont pas corrigés
convention-simple-acceptance = conformité : acceptation simple (ILAC-G8:09/2019, 4.2.1)
convention-standing = arrêt : à moins de { $radius } mm de la moyenne pendant { $duration } s ou plus ; un arrêt à moins de { $near } mm d’une pose est un positionnement à cette pose ; position atteinte : moyenne de la moitié centrale de l’arrêt
convention-tables = règle des 25 % avec U à k = { $k } ; positions dans le repère des tableaux
convention-times-as-stamped = instants : horodatage de l’enregistrement
convention-times-by-rate = instants : d’après la fréquence d’échantillonnage indiquée, { $rate } Hz
conventions = conventions
conventions-and-drift = Conventions, dérive de l’enregistrement
cooks-distance = distance de Cook
cooks-distance-description = Une barre par pose du tableau ; les poses au-dessus de la ligne sont influentes.
cooks-distance-note = Distance de Cook : variation des paramètres lorsque la pose est omise, rapportée à leur covariance. Une pose au-dessus de { $limit } est influente (médiane de F ; Cook 1977).
cooks-distance-of-poses = Distance de Cook des poses
cooks-distance-tooltip = pose { $pose } : distance de Cook { $distance }
coordinate = coordonnée
coordinates-of-targets = coordonnées des cibles
coordinate-uncertainty = { $uncertainty } mm (k = 1) par coordonnée
coordinate-uncertainty-in-common = { $uncertainty } mm (k = 1) par coordonnée, indépendante pour chaque observation, et { $common } mm communs à toutes les observations d’un point mesuré
coordinates = coordonnées
coplanarity = Coplanéité
coplanarity-of-pose = distance de la position moyenne au plan des trois autres
coplanarity-peak-to-valley = coplanéité, crête à creux
copy = Copier
corner = angle
corners = sommets
correlated-pairs = Corrélation de 0,9 ou plus : { $pairs }.
correlated-pairs-strongest = { $count } paires ont une corrélation de 0,9 ou plus. Les plus fortes : { $pairs }.
correlated-with = corrélé à
correlation-description = Une case par paire : bleue pour une corrélation positive, orange pour une corrélation négative.
correlation-title = Corrélation des paramètres identifiés
correlation-tooltip = { $first } et { $second } : { $correlation }
count-at-poses = { $count } sur { $poses } poses
count-of-set = { $count ->
        [one] { $count } point
       *[other] { $count } points
    } ({ $set })
coverage-factor = facteur d’élargissement
curve = courbe
curve-caption = À chaque pas, la meilleure position est ajoutée avec toutes ses configurations.
curve-description = Cercles : indice, axe de gauche. Losanges : conditionnement, axe de droite.
curve-point-tooltip = { $curve } : { $value } à { $at }
curve-singular = { $count ->
    [one] Le premier choix est singulier : son conditionnement n’est pas tracé.
   *[other] Les { $count } premiers choix sont singuliers : leurs conditionnements ne sont pas tracés.
}
curve-title = { $index } et conditionnement en fonction du nombre de positions
curve-tooltip = { $positions ->
        [one] { $positions } position
       *[other] { $positions } positions
    }, { $configurations ->
        [one] { $configurations } configuration
       *[other] { $configurations } configurations
    } : { $index } { $value }, conditionnement { $condition }
customer = client
cycle = cycle
cycles = cycles
cylinder = cylindre
date = date
date-column = Date
date-not-stated = date : non indiquée
date-of-issue = date d’émission
date-of-receipt = date de réception
decide-now = À décider maintenant
decision-rule = règle de décision
decision-rule-by-default = La campagne n’indique aucune règle de décision ; cette règle par défaut s’applique.
decision-rule-explained = Règle de décision, { $rule } : { $explanation }.
decision-rule-named = Règle de décision : { $rule }.
definition = définition
definition-ad-rd = AD : distance moyenne atteinte moins distance commandée ; RD : trois écarts-types de la distance atteinte (ISO 9283:1998, 7.3).
definition-ap = AP : distance entre la position moyenne atteinte et la position commandée, avec ses composantes (ISO 9283:1998, 7.2.1).
definition-ap-rp-of-angles = AP : angle moyen atteint moins angle commandé ; RP : trois écarts-types ; évaluées pour chaque angle (ISO 9283:1998, 7.2.1 et 7.2.2).
definition-compliance = Déplacement suivant la force par unité de force : pente de la droite ajustée passant par la position sans charge (ISO 9283:1998, 10).
definition-drift = dAP et dRP : valeur absolue de la différence entre la première et la dernière série (ISO 9283:1998, 7.6). U de dAP contient la dispersion dans les séries ; les erreurs que l’instrument répète s’annulent. AP est stabilisée après cinq variations successives de 10 % au plus de la plus grande variation : il y faut au moins sept séries.
definition-of-errors = définition des erreurs
definition-posing-time = Temps entre le départ d’une pose et la fin de la stabilisation à la pose suivante (ISO 9283:1998, 9). U contient la dispersion des mouvements et la période d’échantillonnage. La distance en ligne droite est celle des deux arrêts ; la longueur de la trajectoire suit la trajectoire atteinte.
definition-quarter-rule = ISO 9283 : l’incertitude de mesure élargie ne doit pas dépasser 25 % de la caractéristique évaluée. U est l’incertitude élargie d’une position (k = 2). S’il y a plusieurs directions d’approche, chaque ligne donne la direction de plus petite valeur.
definition-rp = RP : ISO 9283:1998, 7.2.2. Chaque ligne ne contient que ses propres positionnements. En complément de la norme : RP sans le bruit de l’instrument (si chaque positionnement a plusieurs lectures), et l’ellipsoïde qui contient la position suivante avec une probabilité de 95 %.
definition-stabilisation = Temps entre la première entrée dans la bande limite et l’instant à partir duquel le robot y reste (ISO 9283:1998, 7.4 et 7.5). U contient la dispersion des arrivées et la période d’échantillonnage ; U d’un dépassement contient la dispersion à l’arrêt.
definition-standstill-distance = Distance entre la moyenne de chaque arrêt et celle du premier arrêt à la même pose. Une distance croissante traduit une dérive, une distance constante la répétabilité.
definition-target-displacement = Déplacement des cibles fixes depuis leur première mesure, et déplacement restant après correction des positions (hors norme).
definition-vap = vAP : plus grande distance entre les positions moyennes de deux directions d’approche (ISO 9283:1998, 7.2.3).
degrees-of-freedom = degrés de liberté
degrees-of-freedom-sum = { $degrees } = { $residuals } résidus + { $stated } valeurs indiquées − { $determined } paramètres déterminés par les données
detected-from = détecté à partir de
detected-with-probability = Probabilité de détection : { $percent } %
deviation = écart
deviation-along-path = Écart le long de la trajectoire
deviation-of-mean-value = son écart-type
deviation-of-the-mean-path = écart de la trajectoire moyenne
deviations-from-the-method = écarts par rapport à la méthode
difference = différence
difference-over-u = différence / u
different-instruments = Instruments de mesure différents : { $instruments }. Les différences systématiques entre ces instruments apparaissent comme des changements.
different-models = Modèles différents : { $counts } paramètres ont été identifiés. Les paramètres fixés dans un modèle influent sur les autres.
different-set-ups = Montages différents : { $differences }.
differs = diffère
direction = direction
disagrees = en désaccord
displacement-up-to = déplacement jusqu’à
distance = distance
distance-after-entry = Distance à la pose atteinte après la première entrée dans la bande limite : premières arrivées à chaque pose.
distance-between-poses-in-mm = distance entre poses (mm)
distance-error-tooltip = { $name } : { $value } µm ; { $from } à { $to } mm, { $pairs } paires
distance-error-tooltip-u = { $name } : { $value } µm ± { $u } µm (k = 2) ; { $from } à { $to } mm, { $pairs } paires
distance-from-base-in-mm = distance à la base (mm)
distance-from-the-base = distance à la base
distance-in-mm = distance (mm)
distances = distances
distances-between-poses = Distances entre poses
distances-by-distance-description = Grandeur des erreurs de { $pairs } distances, par tranche de distance ; axe logarithmique. Les intervalles sont les incertitudes élargies (k = 2).
distances-by-distance-title = Erreurs des distances entre poses, selon la distance
distances-from-to = { $from } à { $to }
distances-max = distances, max.
distances-rms = distances, RMS
distributions-of-errors = Distributions des erreurs aux poses de validation
distributions-of-parameters = Distributions des paramètres
download-csv = Télécharger CSV
download-svg = Télécharger SVG
draft-mark = PROJET
draws-agree = La propagation linéaire concorde avec { $draws } tirages de Monte-Carlo pour les { $parameters } paramètres.
draws-differ = La propagation linéaire et { $draws } tirages de Monte-Carlo diffèrent pour { $differing } paramètres sur { $parameters } (de plus d’une demi-unité du deuxième chiffre de l’incertitude-type).
draws-of-stated = Les tirages couvrent les incertitudes indiquées, et non l’erreur du modèle.
draws-too-few = Trop peu de tirages pour assurer deux chiffres significatifs de chaque incertitude-type : en augmenter le nombre.
draws-without-model-bootstrap = Le bootstrap couvre l’erreur du modèle ; les tirages d’un paramètre la couvrent s’ils concordent avec le bootstrap. Les tirages des erreurs ne couvrent que les incertitudes indiquées.
draws-without-model-both = Les incertitudes-types du rapport et le bootstrap couvrent l’erreur du modèle ; les tirages d’un paramètre la couvrent s’ils concordent avec le rapport. Les tirages des erreurs ne couvrent que les incertitudes indiquées.
draws-without-model-report = Les incertitudes-types du rapport couvrent l’erreur du modèle ; les tirages d’un paramètre la couvrent s’ils concordent avec le rapport. Les tirages des erreurs ne couvrent que les incertitudes indiquées.
drift = Dérive
drift-title = Dérive de l’exactitude et de la répétabilité de pose
effect = effet
effect-at-worst-pose = déplacement à la pose la plus sensible ({ $unit })
effect-tooltip = { $name } : { $value } ± { $half } { $unit } à la pose { $pose }
effective-parameters = Paramètres effectifs et non physiques : { $names }. Les résidus dépassent l’incertitude de l’instrument, et l’incertitude de ces valeurs provient surtout de l’erreur du modèle. Elles décrivent les poses mesurées, mais peuvent différer des dimensions du robot.
effects-cross-validated = Effets : validation croisée à { $folds } blocs sur { $poses } poses, répétitions : { $repeats }
effects-description = Chaque barre : déplacement du point mesuré qui se déplace le plus, pour la valeur identifiée du paramètre moins sa valeur nominale, les autres paramètres étant inchangés. { $count } paramètres sur { $total }.
effects-of-all = Effets de tous les paramètres
effects-reduce-errors = effets qui réduisent les erreurs aux poses omises : { $effects }
effects-section = Paramètres selon leur effet
effects-title = Effets des paramètres
ellipsoid-semi-axes = ellipsoïde, demi-axes
ellipsoid-semi-axis-1 = ellipsoïde, demi-axe 1
ellipsoid-semi-axis-2 = ellipsoïde, demi-axe 2
ellipsoid-semi-axis-3 = ellipsoïde, demi-axe 3
enclosing-circle-radius = cercle circonscrit dans x, y, rayon
enclosing-sphere-radius = sphère circonscrite, rayon
end-of-report = Fin du rapport
environment = environnement
error = erreur
error-after-in-plane = Erreur après étalonnage : { $quantity }, { $plane }
error-after-max = erreur après, maximum
error-after-mean = erreur après, moyenne
error-against = Erreur après étalonnage : { $quantity }, en fonction de : { $against }
error-at-poses = { $quantity } sur { $count ->
        [one] { $count } pose
       *[other] { $count } poses
    } ({ $set }{ $readings ->
        [0] {""}
       *[other] {", "}{ $readings } lectures
    }) : { $before } → { $after } { $unit }.
error-axis-linear = L’axe des erreurs est linéaire : la plus grande erreur avant étalonnage vaut au plus { $factor } fois la médiane après étalonnage.
error-axis-logarithmic = L’axe des erreurs est logarithmique : la plus grande erreur avant étalonnage dépasse { $factor } fois la médiane après étalonnage.
error-before-in-plane = Erreur avant étalonnage : { $quantity }, { $plane }
error-before-max = erreur avant, maximum
error-before-mean = erreur avant, moyenne
error-definition = erreur : { $error } ; { $values } ; statistiques sur les normes, chaque répétition étant comptée
error-in = erreur selon { $quantity } ({ $unit })
error-by-pose = Erreurs par pose : { $quantity }
error-in-unit = erreur ({ $unit })
error-log = erreur ({ $unit }), logarithmique
error-left-out = erreur RMS aux poses omises : { $nominal } mm avec les paramètres nominaux, { $all } mm avec tous les paramètres, { $recommended } mm avec les paramètres recommandés
error-map-description = Marques aux positions mesurées : couleur et taille de 0 à { $top }, même échelle avant et après ; erreur maximale { $largest }.
error-map-own-scale = Marques aux positions mesurées : couleur et taille de 0 à { $top }, échelle propre à cette figure ; erreur maximale { $largest }.
error-of-platform = pose mesurée du centre C de la plate-forme (d’après les billes) moins la pose prédite à partir des valeurs articulaires ; positions : C dans le repère de la base
error-of-positions = position mesurée moins position prédite de chaque cible, d’après les valeurs articulaires ; positions : cibles dans le repère atelier
error-of-quantities = valeur mesurée moins valeur prédite de chaque grandeur mesurée (distance, distance à une surface ou à un logement, coordonnée isolée), d’après les valeurs articulaires
error-of-targets = position mesurée moins position prédite de chaque cible, d’après les valeurs articulaires ; orientation : rotation entre les cibles mesurées et prédites ; positions : cibles dans le repère atelier
error-of-tool = erreur : position vraie de { $point } dans le repère de la base moins la position calculée par le contrôleur
error-sizes-after = Distribution des erreurs après étalonnage : { $quantity }
error-sizes-before = Distribution des erreurs avant étalonnage : { $quantity }
error-tooltip = pose { $pose }, cycle { $cycle }, { $target } ({ $set }) : { $before } avant, { $after } après
error-vectors-after = Vecteurs d’erreur après étalonnage, plan { $plane }
error-vectors-before = Vecteurs d’erreur avant étalonnage, plan { $plane }
errors = erreurs
errors-against-description = Une marque par erreur : cercles pour les poses d’étalonnage, losanges pour les poses de validation.
errors-before-after = Erreurs avant → après étalonnage (poses : { $set }) :
errors-before-after-of = Erreurs ({ $point }) avant → après étalonnage (poses : { $set }) :
errors-before-and-after = Erreurs avant et après
errors-below-axis = { $count ->
    [one] 1 erreur plus petite est tracée sur le bord inférieur.
   *[other] { $count } erreurs plus petites sont tracées sur le bord inférieur.
}
errors-by-number-of-positions = Erreurs de position en fonction du nombre de positions
errors-by-pose-linear = Une marque par pose, cycle et cible ; axe linéaire ({ $unit }).
errors-by-pose-logarithmic = Une marque par pose, cycle et cible ; axe logarithmique ({ $unit }).
errors-by-set-and-pose = Erreurs par ensemble et par pose
errors-contain-noise = Une erreur contient le bruit de sa lecture, qui augmente moyenne, moyenne quadratique et maximum. L’erreur du robot sans bruit est inférieure à valeur + U avec une probabilité d’au moins 95 %. Valeur ± U n’est pas son intervalle de couverture.
errors-draws-confirm = Les tirages confirment l’incertitude rapportée des { $errors } erreurs du tableau des erreurs.
errors-draws-larger = Pour { $differing } erreurs sur { $errors } aux poses de validation, l’incertitude des tirages est la plus grande (JCGM 101:2008, article 8). La valeur linéaire du rapport est trop petite.
errors-hold-among = { $region ->
        [beyond] Certaines poses de validation sont hors de la région mesurée ; leurs erreurs sont comprises
       *[within] Ces valeurs s’appliquent à la région mesurée
    } : la distance d’une pose de validation à la pose d’étalonnage la plus proche vaut { $ratio } fois l’espacement des poses d’étalonnage (médiane ; maximum { $largest } fois). Positions articulaires distinctes de la validation avec une articulation hors de sa plage d’étalonnage : { $outside } sur { $total }.
errors-not-drawn = { $count ->
        [one] { $count } erreur dont la position ou la valeur n’est pas finie n’est pas tracée.
       *[other] { $count } erreurs dont la position ou la valeur n’est pas finie ne sont pas tracées.
    }
errors-of-each-pose = Erreurs par pose
errors-of-noise-alone = Le bruit seul peut expliquer la plus grande erreur de ces grandeurs : { $quantities }. La valeur est alors surtout du bruit.
errors-of-poses-drawn = { $drawn } erreurs sur { $total } sont tracées.
errors-overlaid-description = Proportions de { $count } points ({ $set }) ; axe logarithmique.
errors-overlaid-title = Erreurs avant et après : { $quantity }
errors-that-do-not-decide = Autres erreurs
errors-with-all-parameters = Avec tous les paramètres identifiés
errors-with-file = Avec les valeurs de `{ $file }` : { $set }, { $poses } poses
example-label = exemple :
exchangeability = Interchangeabilité
exchangeability-between-robots = Interchangeabilité E = { $distance } µm : plus grande distance entre les positions moyennes de deux robots à une même pose (ISO 9283:1998, 7.7).
expanded-of = U ({ $figure })
expected = attendu
expected-from-the-points = attendu d’après les points
expected-label = attendu :
expected-of-parameters = attendu, paramètres (k = 1)
expected-standard = attendu (k = 1)
expected-value = { $value }, attendu { $expected }
expected-value-judged = { $value }, attendu { $expected } ({ $criterion })
expanded-uncertainty-of-quantity = { $quantity } : U = { $uncertainty } { $unit } par composante d’une lecture (k = 2)
expired = expiré
explained = expliqué
explanations-of-messages = Explications de ces messages
export = export
fail = non conforme
features = Éléments géométriques
field-components = Composantes du champ et leur incertitude
field-deviation = écart-type
field-gain = Aux poses réservées, avec les paramètres et le champ tirés des autres poses, l’erreur de position (moyenne quadratique) passe de { $without } à { $with } µm. Le champ décrit { $share } % de l’erreur quadratique moyenne ; le gain est de { $gain } fois son incertitude-type.
field-held-out-caption = Chaque pose est prédite par les paramètres et le champ tirés des autres poses (cinq parties).
field-held-out-description = Erreurs de position des poses réservées, sans et avec le champ résiduel.
field-held-out-title = Erreur de position des poses réservées, sans et avec le champ
field-inputs = dépend de, avec la plage mesurée
field-note = Le champ décrit les erreurs dépendant des articulations que les paramètres ne décrivent pas. Au-delà des plages mesurées, il décroît vers zéro : seules les erreurs des paramètres s’appliquent.
field-refused-because = Aucun champ résiduel n’est utilisé : { $reason }.
field-uncertainty = { $coverage } % des coordonnées des poses réservées sont à moins de 1,96 incertitude-type prédite. L’incertitude-type du champ est multipliée par { $factor } afin de concorder avec ces erreurs.
figure = résultat
figure-of-set = { $quantity }, { $figure } ({ $set })
figures-of-measurement-point = Toutes les valeurs se rapportent au point de mesure : { $point }.
figures-with-field = Les erreurs après étalonnage tiennent compte du champ.
figures-without-field = Les autres valeurs de ce rapport ne tiennent pas compte du champ.
file = fichier
file-with-hash = { $file }, SHA-256 { $sha256 }
filter = Filtre
filter-rows = Filtrer les lignes
first-cycle = premier cycle
fit = ajustement
fit-and-observability = Ajustement et observabilité
first-set = { $symbol }, première série
fits = Ajustements
fixed-in-the-world = Éléments fixes dans le repère atelier
folder = dossier
folds-over-u = écart-type entre blocs / u
force-up-to = force jusqu’à
formats = formats
formats-without-all-parameters = Ces formats ne peuvent pas contenir tous les paramètres identifiés. Leurs fichiers contiennent une seconde identification, les autres paramètres étant fixés à leurs valeurs nominales. Erreurs de position : RMS et maximum.
formulas-of-characteristics = caractéristiques : d’après l’ISO 9283:1998, dont seul le texte de 7.2.2 a été comparé
formulas-of-identification = repères et identification : moindres carrés pondérés, comparés aux tableaux d’une thèse sur une table PreXYT et un robot à cinq barres (A. Joubair, ÉTS Montréal 2012, chapitres 1 à 4)
formulas-of-uncertainties = incertitudes : d’après JCGM 100:2008 et JCGM 101:2008
frame-as-exported = les coordonnées des exports sont dans le repère atelier
frame-from-plane = plan xy : élément `{ $plane }` ; origine : `{ $origin }` ; axe { $axis } : de `{ $from }` vers `{ $to }` ; autre axe vers `{ $towards }`
frame-of-recording = référentiel de l’enregistrement
frame-of-reference-targets = référentiel des tableaux lors de la première mesure des cibles de référence
frame-of-tables = référentiel des tableaux
frame-sentence = Référentiel des positions : { $frame }.
frame-from-targets = ajustement aux cibles { $targets } : origine à la première cible, axe x vers la deuxième, la troisième dans le plan xy
frame-from-targets-each = ajustement aux cibles { $targets }, mesurées de nouveau à chaque pose : origine à la première cible, axe x vers la deuxième, la troisième dans le plan xy
frames-and-features = Repères et éléments géométriques
frames-of-poses = repères des poses
from = de
from-cycle-on = à partir du cycle
from-data = d’après les données
from-distance = de
from-in-unit = de ({ $unit })
from-nominal-value = surtout d’après la valeur nominale
from-pose = de la pose
from-pose-named = depuis la pose { $pose }
from-residuals = d’après les résidus (traités comme indépendants)
from-residuals-by-pose = d’après les résidus, regroupés par pose
from-residuals-by-region = des paramètres effectifs, d’après la dispersion entre régions de l’espace de travail{ $series ->
        [0] {" "}; les différences entre montages n’y sont pas comprises
       *[other] { " " }et entre { $series } séries ; { $percent ->
            [0] aucune différence supplémentaire n’est décelable
           *[other] celles-ci apportent { $percent } % des variances
        }
    }
from-the-instrument = d’après l’incertitude indiquée
gain-over-u = gain / u
generated-candidates = poses candidates tirées
geometric = géométrique
geometric-definition = thèse, chapitre 2 : chaque grandeur est ajustée à des points mesurés à cet effet, sans optimisation du modèle du robot ; gamma, beta et epsilon_theta sont fixés à zéro ; d3 est corrigé des pas des actionneurs 2 et 3. Incertitudes : d’après les points, propagées à travers tous les ajustements et repères ; d’après les résidus là où leur dispersion dépasse l’incertitude indiquée de l’instrument. Erreurs : moyennes de la pose mesurée moins la pose prédite, nominale et géométrique, dans le repère de la base déterminé géométriquement
geometric-u-note = u (k = 1) comprend l’incertitude du repère de la base. Cette incertitude est commune à toutes les répétitions ; l’écart-type des répétitions ne la contient donc pas.
geometric-u-without-angles = gamma, beta et epsilon_theta sont pris nuls. u de s, d et d3 ne contient pas les décalages causés par ces angles : ils ne sont pas identifiés et n’ont pas tous une tolérance indiquée.
geometric-u-with-angles = gamma, beta et epsilon_theta sont pris nuls. u de s, d et d3 contient les décalages que causent leurs valeurs identifiées ou leurs tolérances indiquées (GUM F.2.4.5).
geometry-alone = Géométrie seule
geometry-alone-title = Mesures par la géométrie seule
geometry-beside-identification = Géométrie seule, comparée à l’identification
geometry-improvement = La plus grande erreur moyenne de position passe de { $nominal } mm à { $geometric } mm par la géométrie seule (facteur { $improvement }).
guarded-acceptance = acceptation avec bande de garde (ILAC-G8:09/2019, 4.2.3)
guarded-acceptance-explained = conforme si la valeur augmentée de son incertitude élargie U respecte la limite ; non conforme si la valeur diminuée de U dépasse la limite ; sinon indécidé
head-along = suivant
head-and = et
head-between = entre
head-characteristic = caractéristique
head-clause = article
head-column = colonne
head-commanded = commandé
head-duration = durée
head-exchangeability = interchangeabilité
head-expanded-uncertainty = incertitude élargie
head-family = famille
head-frequency = fréquence
head-hint = conseil
head-labels = étiquettes
head-meaning = signification
head-passes = passages
head-refused = rejeté
head-samples = échantillons
head-severity = gravité
head-stroke = course
hash-without-backup = SHA-256 de `{ $file }` sans sa ligne `controller_backup` : le retour ne change pas les résultats.
head-u-by-angles = dont angles
head-residual-over-u = résidu / u
head-identified-minus-stated = identifié moins indiqué
head-stated-value = valeur indiquée
head-stated-u = u indiquée (k = 1)
head-values = valeurs
head-symbols = symboles
head-tested = ce rapport
head-u-nominal = u de la valeur nominale
head-without-noise = sans bruit, 95 %
head-verified = évaluation vérifiée par
head-what = objet
held = fixé
held-by-the-campaign = fixé par la campagne
held-not-identifiable = fixé : non identifiable séparément
held-singular-values = Losanges : les { $count } plus petites valeurs singulières avec tous les paramètres ; autant de paramètres sont fixés. Les directions sur la ligne ({ $cut } fois la plus grande valeur) ou au-dessous sont inobservables ; les directions juste au-dessus sont à peine observables.
hint-label = conseil :
histogram-description = Part des points de chaque ensemble par pas de { $step }.
histogram-shares = Part de chaque ensemble par pas de { $step } : { $totals }.
histogram-tooltip = { $from } à { $to } { $unit } : { $points ->
        [one] { $points } point
       *[other] { $points } points
    } ({ $set }), { $percent } %
how-changes-are-judged = Règle de décision pour les changements
how-many-and-where = Nombre et emplacements des positions
identification-against-geometry = L’identification de tous les paramètres à partir de la même campagne donne { $identified } mm ; avec la géométrie seule, l’erreur est { $ratio } fois plus grande.
identification-ended = L’identification a échoué : { $reason }.
identified = identifié
identified-max = identifié, max.
identified-minus-geometric = identifié − géométrique
identified-minus-nominal = identifié moins nominal
identified-minus-nominal-in = identifié moins nominal ({ $unit })
identified-minus-true = identifié − vrai
identified-minus-true-in = identifié moins vrai ({ $unit })
identified-rms = identifié, RMS
import = Importation
in-space = dans l’espace
index = indice
index-value-of-poses = { $index } = { $value }, poses { $poses }
influential = influent
instrument = instrument de mesure
instrument-calibration = étalonnage de l’instrument
instrument-expanded-uncertainty = incertitude de mesure élargie de l’instrument
instrument-good-enough = Aptitude de l’instrument
instrument-good-for-all = Apte : l’incertitude de mesure des positions est au plus 25 % { $tested ->
        [repeatability] de RP
       *[accuracy] de AP et de RP
    } à toutes les poses.
instrument-good-for-none = L’incertitude de mesure dépasse 25 % { $tested ->
        [repeatability] de RP à toutes les poses : RP contient
       *[accuracy] de AP ou de RP à toutes les poses ; là où elle dépasse 25 % de RP, RP contient
    } beaucoup de bruit de l’instrument.
in-the-laboratory = au laboratoire
instrument-good-for-some = L’incertitude de mesure dépasse 25 % { $tested ->
        [repeatability] de RP
       *[accuracy] de AP ou de RP
    } aux poses { $poor } ; là où elle dépasse 25 % de RP, RP contient beaucoup de bruit de l’instrument. Instrument apte aux poses : { $good }.
left-out-feature = élément géométrique `{ $feature }`, mesuré sans point redondant
left-out-scale = échelle du système de mesure (`expanded_scale_uncertainty_um_per_m`)
left-out-temperature = dilatation thermique du robot et de la pièce ([expansion])
left-out-temperature-of-part = dilatation thermique de la référence des coordonnées ([expansion])
moved-base = base
orientations-without-quarter-rule = L’incertitude de mesure des orientations n’est pas évaluée.
instrument-uncertainty = incertitude de l’instrument
instrument-uncertainty-of-position = U = { $uncertainty } µm pour une position
instrument-uncertainty-with-k = U = { $uncertainty } µm par coordonnée (k = { $k })
instrument-uncertainty-without-k = U = { $uncertainty } µm par coordonnée (facteur d’élargissement non indiqué)
interval-95 = intervalle à 95 %
interval-from = 95 %, de
interval-of = intervalle de
interval-to = 95 %, à
intervals-caption = Identifié moins nominal. Le trait qui traverse une marque représente ± 2u, et est souvent plus court que la marque. Valeurs : voir le tableau ci-dessus.
intervals-description = Une marque par paramètre identifié : identifié moins nominal ; trait : ± 2u.
intervals-of-95 = Intervalles à 95 %.
intervals-of-ratios-title = { $group } : écart des rapports, ± 2u
intervals-title = { $group } : écart ({ $unit }), ± 2u
iso9283-characteristics = Résultats : caractéristiques de performance (ISO 9283)
iso9283-report = Rapport d’essai selon l’ISO 9283:1998 : { $characteristics }
item-customer-traceability = Objet, client, traçabilité
joint-motion-explains-most = les paramètres ne sont plus valables : un décalage du zéro de l’articulation { $joint } de { $by } (k = 2) explique { $percent } % de l’écart ; les résidus restants sont plus grands que prévu
joint-zero-moved = le zéro de l’articulation { $joint } s’est décalé : valeur vraie moins valeur du journal { $by } (k = 2)
joints = articulations
kind = type
knee-at = coude : { $count }
knee-caption = Coude : point de la courbe situé le plus haut au-dessus de la droite qui joint sa première et sa dernière valeur.
known-points = points connus
known-values-note = Chacune compte comme une lecture. Si aucune coordonnée n’est mesurée, les longueurs déterminent l’échelle.
known-values-title = Longueurs et positions connues
joint-value = valeur articulaire
laboratory = laboratoire
lack-of-fit = Dispersion des répétitions : { $repeats } µm par coordonnée ({ $degrees_of_freedom } degrés de liberté). Erreur du modèle au-delà de cette dispersion : { $model } µm par pose (test F de défaut d’ajustement : { $probability }).
largest = plus grande contribution
largest-displacement = plus grand déplacement
largest-distance = plus grande distance
largest-error = plus grande erreur
largest-error-drawn = `max` est l’erreur de la mesure dont l’erreur est la plus grande dans les données. Chaque tirage répète cette mesure. La colonne de concordance indique « non » si l’incertitude des tirages est plus grande.
largest-errors-drawn = La plus grande erreur est tracée à chacune des { $places } positions (sur { $total } erreurs).
largest-errors-of-poses = Erreurs par pose, les plus grandes d’abord
largest-mean-deviation-from-linear = plus grand écart moyen de linéarité
largest-of-all-modes = la plus grande de tous les modes de travail
largest-residual-of-a-coordinate = plus grand résidu d’une coordonnée
last-set = { $symbol }, dernière série
last-cycle = dernier cycle
leads = Pas de vis
left = restant
left-out-errors = Erreurs aux poses omises
left-out-rms = poses omises, RMS
left-rms = restant, RMS
length = longueur
limit = limite
limit-accuracy-max = plus grande valeur de l’exactitude de pose AP
limit-band-value = La bande limite est de { $value } µm.
limit-contact-max = distance maximale à un logement
limit-coordinate-max = erreur de coordonnée maximale
limit-distance-max = erreur de distance maximale
limit-exceeded-sentence = Limite de { $limit } µm dépassée.
limit-kept-sentence = Limite de { $limit } µm respectée.
limit-margin = marge { $margin } { $unit }, risque de fausse acceptation { $risk } %
limit-margin-without-uncertainty = marge { $margin } { $unit }, incertitude inconnue
limit-met-sentence = La limite de la campagne est respectée.
limit-not-met-sentence = La limite de la campagne n’est pas respectée.
limit-of = limite : { $quantity } { $value } { $unit }
limit-orientation-max = erreur d’orientation maximale
limit-position-max = erreur de position maximale
limit-position-mean = erreur de position moyenne
limit-position-rms = erreur de position, RMS
limit-repeatability-max = plus grande valeur de la répétabilité de pose RP
limit-surface-max = distance maximale à une surface
limit-undecided-sentence = Limite : { $limit } µm.
limited-error = { $quantity } sur { $count ->
        [one] { $count } pose
       *[other] { $count } poses
    } ({ $set }{ $readings ->
        [0] {""}
       *[other] {", "}{ $readings } lectures
    }) : { $before } → { $after } { $unit }, limite { $limit } { $unit } : { $verdict }
limits = Limites
limits-all-met = Les { $count } limites de la campagne sont toutes respectées.
limits-are-of-file = Jugé avec les valeurs de `{ $file }`.
limits-by-interval = Une valeur avec un intervalle est évaluée d’après les bornes de l’intervalle et non d’après U.
limits-both-met = Les deux limites de la campagne sont respectées.
limits-not-assessable = Non évaluable (grandeur non mesurée) : { $limits }.
limits-not-met = { $count ->
    [one] 1 des { $total } limites de la campagne n’est pas respectée.
   *[other] { $count } des { $total } limites de la campagne ne sont pas respectées.
}
limits-specification = spécification des limites
limits-undecided = Indécidé (limite à l’intérieur de l’incertitude) : { $limits }.
line = ligne
line-number = ligne { $line }
load = charge
load-centre = centre de la charge (depuis l’interface mécanique)
load-sentence = Charge : { $load } kg.
log = journal
logo-of-the-laboratory = Logo du laboratoire
manufacturer = fabricant
margin = marge
max = max.
max-after = max. après
max-before = max. avant
mean = moyenne
mean-deviation-from-linear = écart moyen à la linéarité
mean-distance-from-barycentre = distance moyenne au barycentre
mean-distance-from-mean = distance moyenne à la position moyenne
mean-error = erreur moyenne
mean-error-named = Erreur moyenne : { $name }
mean-error-of-set = { $quantity }, { $when } (poses : { $set })
mean-from-overall-mean = distance de sa moyenne à la moyenne générale (µm)
mean-from-plane = position moyenne par rapport au plan des trois autres
mean-of = { $quantity }, moyenne
mean-of-attained-positions = Moyenne des positions atteintes.
mean-of-axis = moyenne { $axis }
mean-of-identifications = Moyenne de { $runs } identifications. Valeurs : voir le tableau ci-dessus.
mean-plus-3s = moyenne + 3 s
mean-plus-3s-of-distance = moyenne + 3 s de la distance à la position moyenne (µm)
mean-positions = Positions moyennes
mean-positions-changed = Les positions moyennes ont changé : à cause du robot ou de la détermination de son repère.
mean-radius-plus-3s = rayon moyen + 3 s des passages
mean-radius-three-s = rayon moyen + 3 s
mean-tooltip = moyenne { $approach } : x { $x }, y { $y }, z { $z } µm
mean-velocity = vitesse moyenne
meaning-and-sign = signification et signe
meanings-title = Signification des paramètres
measured = mesuré
measured-minus-predicted-in = mesuré moins prédit ({ $unit })
measured-values = { $count } valeurs mesurées (mm)
measurement-dates = date des mesures
measurement-place = lieu des mesures
measurement-point = point de mesure
measuring-order = ordre de mesure
met = respectée
method = méthode
method-identification = identification des paramètres cinématiques ({ $model }) par moindres carrés
method-iso9283 = essai de performance selon l’ISO 9283:1998
method-iterations = { $method }, { $iterations ->
        [one] { $iterations } itération
       *[other] { $iterations } itérations
    } ;
minimum-posing-time = Temps minimal de positionnement
mode-count = { $count ->
    [one] 1 mode
   *[other] { $count } modes
}
model = modèle
model-and-residuals = Les résidus valent { $ratio } fois la valeur attendue d’après { $uncertainty } : { $fit ->
        [incomplete] le modèle est incomplet
        [correlated] le modèle laisse des erreurs communes aux lectures d’une pose
        [doubtful] le modèle est peut-être incomplet
        [lacking] il manque au modèle un effet que les poses réservées confirment
       *[fits] le modèle convient
    } ({ $criterion }).
model-criterion = khi-deux : { $p }, limite { $limit }
model-delta = robot delta
model-delta-linear = robot delta linéaire
model-five-bar = mécanisme à cinq barres
model-hexapod = hexapode
model-of-the-robot = modèle du robot
model-prexyt = table PreXYT
model-serial = bras série
model-urdf = bras décrit par un fichier URDF
more-in-annex = { $count ->
    [one] 1 autre message : voir l’annexe.
   *[other] { $count } autres messages : voir l’annexe.
}
more-warnings-and-remarks = Autres avertissements et remarques
more-without-picture = { $count ->
    [one] 1 autre grandeur sans figure : voir les tableaux.
   *[other] { $count } autres grandeurs sans figure : voir les tableaux.
}
motion = mouvement
mounting = montage
moved = déplacement
movement = déplacement
movement-of-the-set-up = Déplacement du montage
moves = déplacements
multiples-description = { $plane }, autour du barycentre, toutes les poses à la même échelle (demi-largeur { $half } µm). { $count } poses sur { $total }.
multiples-title = Positionnements aux poses
name = nom
name-date-signature = nom, date, signature
named-from = attribuée à partir de
naming-probability = Probabilité que l’articulation déplacée soit identifiée : { $percent } %.
needed = nécessaire
next-step = prochaine étape { $number }
next-steps = Prochaines étapes
no = non
no-certificate-stated = aucun certificat n’est indiqué
no-correlated-pairs = Aucune paire n’a une corrélation de 0,9 ou plus.
no-error-to-draw = Aucune erreur à tracer.
no-errors-are-given = Le document ne contient aucune erreur.
no-messages = Aucun.
no-messages-but-routine = Aucun qui limite les résultats. L’annexe du rapport contient { $count ->
        [one] une autre remarque
       *[other] { $count } autres remarques
    }.
no-noise-stated = aucun bruit indiqué
no-quantity-changed = Changements significatifs : 0 grandeur du robot sur { $total }.
no-significant-change = pas de changement significatif
no-significant-change-sentence = Pas de changement significatif.
no-trend-pictures = { $others ->
        [yes] Erreurs en fonction des autres valeurs articulaires et distances
       *[no] Erreurs en fonction des valeurs articulaires et de la distance
    } : aucune tendance significative
no-uncertainty-is-known = incertitude inconnue
noise = bruit
noise-of-reading-x = bruit d’une lecture, x
noise-of-reading-y = bruit d’une lecture, y
noise-of-reading-z = bruit d’une lecture, z
nominal = nominal
nominal-lead = pas nominal
nominal-max = nominal, max.
nominal-minus-identified = nominal moins identifié
nominal-parameters = nominaux
nominal-rms = nominal, RMS
nominal-values = valeurs nominales
none = aucun
norm = norme
normal-quantile = quantile de la loi normale
not-accepted = non accepté
not-assessable = non évaluable
not-by-these-poses = non observable avec ces poses
not-conforming = non conforme
not-controlled-by-the-data = Erreurs que les données ne peuvent pas déceler
not-detectable = non décelable
not-identifiable = non identifiable
not-judged-by-misfit = non jugée : le modèle ne convient pas
not-known = inconnu
not-met = non respectée
not-run = non calculée
not-stated = non indiqué
nothing-to-load = { $answer ->
        [keep_nominal] les paramètres identifiés ne sont pas nettement meilleurs que les paramètres nominaux
        [identify_further] avec d’autres effets, les erreurs aux poses mises de côté sont plus petites de plus de 5 %
       *[resolve] le verdict ne permet de charger aucun fichier
    }
not-stated-items = Non indiqué, outre les champs à compléter avant signature : { $items }.
notes = remarques
nothing-held = Aucun paramètre n’est fixé : la distance de chaque colonne à l’espace engendré par les autres dépasse le seuil de rang { $cut }.
nothing-to-verify = rien à vérifier
number = numéro
numbers-of-arrows = Valeurs des { $count } flèches
numbers-of-the-curve = Valeurs de la courbe
numbers-of-this-picture = Valeurs de cette figure
observability = Observabilité
observability-scaling = O1 à O5 : jacobienne non pondérée (mm par mm, rad et 1) ; conditionnement : colonnes ramenées à la norme 1
observability-scaling-eliminated = O1 à O5 : jacobienne non pondérée (mm par mm, rad et 1) ; conditionnement : colonnes ramenées à la norme 1 ; { $parameters } paramètres, après élimination des { $coordinates } coordonnées des points inconnus
observations = observations
off-the-line = écart à la droite
one-after-the-other = l’une après l’autre
one-scale = même échelle
operator = opérateur
operator-sheet = Fiche de l’opérateur
operator-sheet-before = Avant la première pose
operator-sheet-note = Les valeurs articulaires sont celles du contrôleur (deg, mm). Cocher chaque pose quand ses points sont enregistrés sous son étiquette.
operator-sheet-poses = Poses dans l’ordre de mesure
order-of-poses = { $poses } ({ $percent } % du mouvement des articulations dans l’ordre de leurs noms)
order-of-the-measurement = ordre de mesure
orientation = orientation
orientation-after = après, orientation
orientation-after-max = orientation après, max.
orientation-before = avant, orientation
orientation-before-max = orientation avant, max.
orientation-error-by-pose = Erreur d’orientation par pose, avant et après étalonnage
orientation-error-in = erreur d’orientation ({ $unit })
orientation-max = orientation, max.
orientation-title = Orientation
origin-in-the-exports = origine dans les exports
other-planes = Autres vues
other-pose = autre pose
outliers-note = Nombres en couleur : valeurs aberrantes (z modifié supérieur à 3,5 ; Iglewicz et Hoaglin, 1993). Référence : les campagnes du même robot ou, s’il en a moins de huit, celles de robots du même type.
outliers-then-largest-errors = Erreurs par pose : valeurs aberrantes, puis les plus grandes
overshoot = dépassement
overshoot-co = dépassement d’angle CO
own-scale-of-each = échelles individuelles
p-of-family = p de la famille
p-value = valeur p
page-of = page { $page } sur { $total }
pairs = paires
parameter = paramètre
parameter-errors-description = Une barre par paramètre : identifié moins vrai.
parameter-errors-title = Erreurs des paramètres identifiés ({ $unit })
parameter-named = Paramètre { $name }
parameters = paramètres
parameters-implausible = Ces paramètres ne sont pas plausibles pour le robot : ne pas les charger.
parameters-left-out = paramètres omis
one-pose-deviates = une pose contredit les paramètres (`{ $pose }`) ; sans elle ils sont valables
parameters-no-longer-valid = les paramètres ne sont plus valables ; aucun mouvement de la base, d’une seule articulation ou d’une seule cible n’explique l’écart
parameters-note = u : incertitude-type (k = 1) ; U = 2u : incertitude élargie. Les valeurs sont arrondies au deuxième chiffre de u. « Avant » : seules la base et les cibles sont ajustées. Écart : valeur identifiée moins valeur nominale.
parameters-of-robot = Paramètres du robot
parameters-of-set-up = Paramètres de la base et des cibles
parameters-of-the-answer = de la réponse
parameters-of-the-run = de l’exécution
parameters-still-valid = les paramètres sont encore valables pour ces poses
parameters-title = Paramètres
pass = conforme
path = trajectoire
path-accuracy-at = exactitude de trajectoire AT
path-accuracy-at-reorientation = exactitude de trajectoire AT lors d’une réorientation
path-accuracy-title = Exactitude de trajectoire AT
path-passes = { $length } mm, { $passes ->
        [one] { $passes } passage
       *[other] { $passes } passages
    }
path-passes-incomplete = { $length } mm, { $passes ->
        [one] { $passes } passage
       *[other] { $passes } passages
    }, { $incomplete ->
        [one] { $incomplete } incomplet
       *[other] { $incomplete } incomplets
    }
path-repeatability-rt = répétabilité de trajectoire RT
path-repeatability-title = Répétabilité de trajectoire RT
path-velocity = vitesse de trajectoire
path-length = longueur de la trajectoire
percent-of-rated = { $percent } % de la vitesse assignée
perhaps-changed = incertain, mesurer de nouveau : les résidus d’un robot inchangé sont aussi grands dans { FIXED($percent, 1) } % de toutes les vérifications. Meilleure explication : { $meaning }
permissible = erreur maximale tolérée
permissible-over-certificate = erreur maximale tolérée / incertitude du certificat
picture-marks = Cercles : poses d’étalonnage ; losanges : poses de validation. Pointer une marque pour lire sa pose, son cycle, sa cible et son erreur ; un clic marque la pose dans toutes les figures. Valeurs : voir les tableaux.
picture-page-command = `etalon view DOSSIER --export view.html` écrit une page qui montre les erreurs en trois dimensions et s’ouvre sans le programme.
picture-selection = Si les erreurs sont nombreuses, les figures montrent la plus grande de chaque pose après étalonnage : d’abord les poses de validation, puis une sélection régulière des poses d’étalonnage.
pictures = Figures
pictures-of-thesis = Figures (thèse, figures 4.8 et 4.9)
place-of-the-base = Position de la base
placed-by-validation-poses = localisé par les poses de validation
places-of-the-targets = Positions des cibles
plan-better-than = poses { $poses } : { $value } (le plan est meilleur de { $percent } %)
plan-for-model = Plan d’étalonnage : { $model }
plane = plan
plane-named = plan { $plane }
platform-as-measured = centre de la plate-forme (d’après les billes)
platform-centre = centre C de la plate-forme
platform-in-base = centre C de la plate-forme dans le repère de la base
plot-ap-rp = AP et RP de chaque pose en mm
plot-changes = Écart de chaque paramètre, divisé par son incertitude-type
plot-errors-by-pose = Plus grande erreur de position de chaque pose en mm
point = point
point-error-in-common = l’erreur de l’instrument en un point est commune à toutes les observations de ce point
point-in-flange = le point { $point } mm dans le repère de la bride
point-in-platform = le point { $point } mm dans le repère de la plate-forme
point-in-targets = le point { $point } mm dans le repère des cibles
points = points
points-drawn = { $drawn } points sur { $total } sont tracés : une sélection régulière qui contient la plus grande erreur dans ce plan.
points-of = { $set }, points
pose = pose
pose-accuracy-ap = Exactitude de pose AP
pose-and-visit = pose { $pose }, positionnement { $visit }
pose-conforms = la pose { $pose } est conforme
pose-coordinates = { $count } coordonnées de pose (mm et rad)
pose-named = pose { $pose }
pose-repeatability-rp = Répétabilité de pose RP
pose-tooltip = pose { $pose } : x { $x }, y { $y }, z { $z } mm
poses-and-cycles = poses et cycles
poses-and-visits = { $poses } poses, { $visits ->
        [one] { $visits } positionnement
       *[other] { $visits } positionnements
    } par pose
poses-conform = { $count ->
    [one] 1 pose sur { $total } est conforme
   *[other] { $count } poses sur { $total } sont conformes
}
poses-not-conforming = { $count ->
    [one] la pose { $poses } n’est pas conforme
   *[other] les poses { $poses } ne sont pas conformes
}
poses-of-the-test = Poses de l’essai
poses-that-decide = Poses décisives
poses-title = Poses
poses-to-measure = Poses à mesurer
poses-to-measure-named = Poses à mesurer : { $poses }.
poses-to-verify-identified-parameters = Poses pour la vérification des paramètres identifiés
poses-undecided = { $count ->
    [one] la pose { $poses } est indécidée
   *[other] les poses { $poses } sont indécidées
}
posing-time = temps de positionnement
position = position
position-after-max = position après, max.
position-after-mean = position après, moyenne
position-before-max = position avant, max.
position-before-mean = position avant, moyenne
position-error-after = Erreur de position après étalonnage, { $plane }
position-error-against = Erreur de position après étalonnage en fonction de : { $quantity }
position-error-before = Erreur de position avant étalonnage, { $plane }
position-error-by-pose = Erreur de position par pose, avant et après étalonnage
position-error-in = erreur de position ({ $unit })
position-max = position, max.
position-residuals-before-rms = résidus de position avant identification, RMS
position-residuals-expected-rms = résidus de position attendus d’après les incertitudes indiquées, RMS
position-residuals-explained = Résidus de position : RMS { $rms } { $unit } ; attendu d’après les incertitudes indiquées : { $expected } { $unit }.
position-residuals-rms = résidus de position, RMS
position-rms = position, RMS
positions = positions
preconditions-column = Réserves
predicted-target-uncertainty = incertitude prédite des positions des cibles aux poses candidates (k = 1)
predicted-u = u prédite (k = 1)
predicted-uncertainty-title = Incertitude prédite des paramètres
prediction-behind = Là où des cellules se superposent, la cellule de plus grande valeur est tracée.
prediction-description = Une cellule tous les { $spacing } mm dans le repère de la base, dans la région des poses d’étalonnage. Couleur de 0 à { $colour }, même échelle pour les deux figures ; plus grande valeur { $largest }.
prediction-difference-title = Point d’outil : modèle nominal moins modèle identifié, plan { $plane }
prediction-expected-title = Point d’outil : erreur attendue avec les paramètres identifiés, plan { $plane }
prediction-map-definition = { $error } ; nominal moins identifié : différence entre les positions prédites par les deux jeux de paramètres ; attendue : norme (k = 1) ; contributions : covariance des paramètres, tolérance des paramètres que les données ne peuvent pas déterminer, erreur du modèle au-delà de l’incertitude de l’instrument, position du point sur l’outil ; p95_mm : limite supérieure de 95 % des erreurs à un nœud, pour des erreurs de loi normale (Box 1954)
prediction-own-scale = Une cellule tous les { $spacing } mm dans le repère de la base, dans la région des poses d’étalonnage. Couleur de 0 à { $colour }, échelle propre à cette figure ; plus grande valeur { $largest }.
prediction-tooltip = x { $x }, y { $y }, z { $z } mm : nominal moins identifié { $difference } ; erreur attendue { $expected } (k = 1), à 95 % inférieure à { $largest }
probability-by-chance = valeur p
probability-of-errors = Probabilité d’erreurs aussi grandes, compte tenu de l’incertitude des paramètres et de la mesure : { $probability }.
projected-into-xy = projetées dans le plan xy
proven-effects = Effets confirmés aux poses omises
provenance = Provenance
quantile-95 = 95 %
quantiles-description = Résidus triés en fonction des quantiles d’une loi normale ; droite : bruit de loi normale.
quantities-changed = Changements significatifs : { $changed } grandeurs du robot sur { $total } : { $names }.
quantity = grandeur
quantity-at = { $quantity }, { $place }
quantity-in-unit = { $quantity } ({ $unit })
quarter-rule = règle des 25 %
radius = rayon
range = { $from } à { $to }
readings-give = lectures : { $values }
readings-of-set-give = lectures { $set ->
        [validation] de validation
       *[calibration] d’étalonnage
    } : { $values }
reference-temperature = le modèle se rapporte à { $value } °C
rank = rang
rank-cut = seuil de rang { $value }
ratio = rapport
reached = atteint
read-as = lu comme
reading-uncertainty = { $uncertainty } mm (k = 1) par lecture
reading-uncertainty-with-k = U = { $uncertainty } µm par lecture (k = { $k })
reading-uncertainty-without-k = U = { $uncertainty } µm par lecture (facteur d’élargissement non indiqué)
readings = lectures
readings-not-judged = { $target } ({ $readings ->
        [one] { $readings } lecture
       *[other] { $readings } lectures
    }, redondance { $redundancy } : non jugée)
readings-redundancy = { $target } ({ $readings ->
        [one] { $readings } lecture
       *[other] { $readings } lectures
    }, redondance { $redundancy })
readings-scatter-more = les lectures se dispersent { FIXED($ratio, 2) } fois plus que prévu ; aucun mouvement de la base, d’une seule articulation ou d’une seule cible ne l’explique
reason = raison
recommend-file = charger `{ $file }` de l’exécution : { $load } paramètres sur { $count }, à leurs valeurs identifiées ; les autres restent aux valeurs nominales
recommend-further = ne rien charger encore : identifier d’abord { $effects }, qui réduisent les erreurs aux poses omises
recommend-nominal = ne rien charger : garder les paramètres nominaux. Les paramètres identifiés ne sont pas nettement meilleurs à de nouvelles poses
recommend-parameters = charger les paramètres identifiés de l’exécution : { $load } sur { $count } ; les autres restent aux valeurs nominales
recommend-resolve = ne rien charger encore : le verdict ne permet de charger aucun fichier. Suivre d’abord les prochaines étapes de l’exécution
recommendation-title = Recommandation des paramètres à charger
recorded = enregistré
recorded-motion = Mouvement enregistré
recording-begins-at-pose = L’enregistrement commence à la pose { $pose } : son premier arrêt n’a ni arrivée ni mouvement.
reference-targets = Cibles de référence
refused = rejetées
refused-rows = { $refused } lignes sur { $total } rejetées
region-note = Plages des valeurs aux poses mesurées. Les résultats s’appliquent dans les plages de l’étalonnage.
region-of-c = région de C, dans le repère de la base
region-of-orientation = orientation de { $orientation } deg
region-of-orientations = toute orientation de { $from } à { $to } deg
region-of-readings = Les erreurs s’appliquent à ces valeurs des lectures d’étalonnage : { $values }.
region-of-validity = Domaine de validité
relative-accuracy = Exactitude relative : distances entre poses ({ $set })
relative-accuracy-note = Distance prédite moins distance mesurée d’une cible entre deux poses. La base est sans effet sur ces erreurs ; la cible aussi si les deux poses ont la même orientation. U (k = 2) : instrument, repères et cibles ; les paramètres sont l’objet de l’essai et n’y contribuent pas.
relative-accuracy-selection = Une sélection régulière de { $pairs } paires sur { $available } est évaluée ; le maximum est celui de cette sélection.
relative-error = erreur relative
relative-humidity = humidité relative
relaxation-alone = relaxation seule
reliability-note = Fiabilité (Baarda 1968 ; niveau de signification { $significance } %, puissance { $power } %). Plus petite erreur décelable d’une coordonnée : médiane { $median }, lecture la plus défavorable { $largest } ; redondance minimale { $redundancy }. Lectures dont le résidu dépasse { $factor } écarts-types : { $beyond } sur { $readings }.
repeatability = répétabilité
repeatability-at-pose = Plus grande valeur de la répétabilité de pose RP : { $repeatability } µm, à la pose { $pose }.
repeatability-from-one-approach = { $approaches ->
        [one] Répétabilité pour la seule direction d’approche à plusieurs positionnements à la pose { $pose } : { $largest } µm ; toutes les directions ensemble : { $together } µm.
       *[other] Répétabilité pour une seule direction d’approche à la pose { $pose } ({ $approaches } directions) : { $smallest } à { $largest } µm ; toutes les directions ensemble : { $together } µm.
    }
repeatability-over-cycles = Répétabilité de pose de chaque pose au cours de l’essai.
repeatability-title = Répétabilité
repeats = répétitions
report = rapport
report-element = élément
report-homing = prise d’origine
report-number = numéro du rapport
report-poses = poses
reservation-drift = AP a varié de { $change } µm au plus de la première à la dernière série, et sa stabilisation n’est pas démontrée { $count ->
        [one] à la pose { $poses }
       *[other] aux poses { $poses }
    } (ISO 9283, 7.6)
reservation-errors-unknown = moyenne quadratique de l’erreur de position { $calibration } aux poses d’étalonnage, { $left_out } aux poses omises : les poses d’étalonnage ne montrent pas les erreurs à d’autres poses
reservation-few-cycles = moins de { $required } cycles { $count ->
        [one] à la pose { $poses }
       *[other] aux poses { $poses }
    }
reservation-file-hardly-better = le fichier pour le contrôleur ({ $formats }) n’apporte pas d’amélioration significative par rapport aux paramètres nominaux : RMS { $rms } mm (nominal { $nominal_rms } mm), plus grande erreur { $max } mm (nominal { $nominal_max } mm)
reservation-file-not-written = au moins un fichier pour le contrôleur n’a pas été écrit (voir les messages)
reservation-given-refused = les paramètres ne doivent pas être utilisés : ils sont moins bons que les paramètres nominaux aux poses mesurées, ou ce sont ceux d’un autre robot
reservation-hardly-better = les paramètres identifiés ne sont guère meilleurs que les paramètres nominaux : RMS { $rms } mm (nominal { $nominal_rms } mm), plus grande erreur { $max } mm (nominal { $nominal_max } mm)
reservation-instrument-too-coarse = l’incertitude de mesure dépasse 25 % de la caractéristique évaluée { $count ->
        [one] à la pose { $poses }
       *[other] aux poses { $poses }
    } (ISO 9283, article 6)
reservation-model-does-not-fit = les résidus valent { $times } × l’incertitude indiquée des lectures : le modèle ne s’ajuste pas, et { $set ->
        [calibration] les erreurs à d’autres poses peuvent dépasser celles aux poses d’étalonnage
       *[validation] les erreurs aux poses de validation font foi
    }
reservation-set-up-untested = { $count ->
        [one] une erreur du montage n’est pas contrôlée
       *[other] { $count } erreurs du montage ne sont pas contrôlées
    } par les mesures ; la bride pourrait s’écarter de { $flange_mm } mm et de { $flange_deg } deg au plus
reservation-no-warm-up = le robot n’a pas été mis en température avant l’essai
reservation-open-warnings =
    { $count ->
        [one] un avertissement n’est pas résolu : { $warnings }
       *[other] des avertissements ne sont pas résolus : { $warnings }
    }
reservations = Réserves : { $reasons }.
residual-field = Champ résiduel
residual-over = résidu / σ
residuals = résidus
residuals-against-normal = Résidus des poses d’étalonnage comparés à une loi normale
residuals-by-pose = Résidus par pose après étalonnage
residuals-by-pose-description = Une marque par pose, cycle, cible et axe.
residuals-max = résidus, max.
residuals-over-uncertainty = résidus / incertitude indiquée, √(χ²/ν)
residuals-pattern = Des résidus structurés ne sont pas du bruit : le modèle est incomplet.
residuals-rms = résidus, RMS
residuals-summary = { $count } résidus, moyenne { $mean }, écart-type { $deviation } ; droite : bruit seul.
residuals-title = Résidus
results-before-and-after = Résultats : erreurs avant et après
results-of-external-providers = résultats de prestataires externes
results-relate-to-item = Ces résultats ne se rapportent qu’à l’objet soumis à l’essai.
results-with-uncertainty = Erreurs après étalonnage, avec leur incertitude
rigid-parts = pièces rigides
risk = risque
risk-without-coverage = Le risque d’acceptation à tort n’est pas donné pour AP : AP dérive, et son intervalle n’est pas un intervalle élargi.
rms = RMS
rms-after = RMS après
rms-and-largest = RMS { $rms } µm, maximum { $largest } µm
rms-and-max = RMS et max.
rms-and-max-values = { $rms } et { $max }
rms-before = RMS avant
rms-expected = { $value } { $unit }, attendu d’après l’instrument, les paramètres et l’erreur du modèle { $expected } { $unit }
rms-of = { $quantity }, RMS
rms-ratio = rapport des RMS
rms-with-it = RMS avec l’effet
rms-without-it = RMS sans l’effet
robot = robot
robot-changed-as-a-whole = Les paramètres du robot ont changé significativement dans leur ensemble ; aucune grandeur seule n’a changé significativement.
robot-changed-together = Campagne { $to } par rapport à { $from } : les { $parameters } paramètres du robot ont changé significativement dans leur ensemble (F = { $f } avec { $parameters } et { $degrees_of_freedom } degrés de liberté, { $probability }).
robot-column = Robot
robot-instrument-conditions = Robot, instrument, conditions
robot-of-model = Robot : { $model }
robot-of-name = Robot { $name }
robot-unchanged-together = Campagne { $to } par rapport à { $from } : les { $parameters } paramètres du robot n’ont pas changé significativement dans leur ensemble (F = { $f } avec { $parameters } et { $degrees_of_freedom } degrés de liberté, { $probability }).
robust = robuste
robust-fit = Ajustement robuste
robust-fit-agrees = L’ajustement robuste concorde avec l’ajustement par moindres carrés. Plus grande différence : { $parameter }, { $difference } incertitudes-types de la différence (attendu par hasard : { $chance }).
robust-fit-difference = L’ajustement robuste diffère de l’ajustement par moindres carrés. Plus grande différence : { $parameter }, { $difference } incertitudes-types de la différence (attendu par hasard : { $chance }).
robust-fit-note = Les lectures éloignées des autres ont un faible poids (fonction de perte de Cauchy, c = { $c } σ avec σ = { $sigma } µm ; Holland & Welsch 1977). Différence : valeur robuste moins valeur des moindres carrés. Son incertitude-type est la plus grande de deux estimations : l’une suppose des résidus de loi normale, l’autre s’appuie sur la dispersion des poses. Le tableau donne les paramètres dont les différences sont les plus grandes.
robust-fit-poses = Poses dont un résidu dépasse { $factor } σ, incompatibles avec les autres : { $poses }.
round-off-cr = arrondi d’angle CR
routine-remarks = Autres remarques
rows = lignes
rows-in-frame = { $count } lignes : faire défiler à l’intérieur du tableau.
rows-in-workbook = { $count ->
        [one] { $count } autre ligne
       *[other] { $count } autres lignes
    } : voir le classeur.
rp-along-x = RP selon x
rp-along-y = RP selon y
rp-along-z = RP selon z
rp-by-set = RP par série
rp-circle = rayon : distance moyenne + 3 s
rp-circle-tooltip = pose { $pose } : { $text }
rp-in-plane = RP dans x, y
rp-of-judged-approach = RP de la direction d’approche évaluée
scatter-of-all-visits = ensemble : { $distance } µm
rp-interval-from = RP, 95 %, de
rp-interval-to = RP, 95 %, à
rp-within-limit = RP dans sa limite
rp-without-noise = RP sans le bruit
rt-interval-from = RT, 95 %, de
rt-interval-to = RT, 95 %, à
rt-location = point de RT
rt-of-angles = RT des angles (deg)
rule-not-stated = { $rule } (par défaut ; la campagne n’indique aucune règle)
samples-in-seconds = { $samples } échantillons en { $seconds } s
scale = échelle
scale-bars = Barres étalons
scaling-label = Mise à l’échelle :
seed = graine
serial-number = numéro de série
series-agree = Avec ces poses, aucune différence entre les { $series } séries n’est décelable.
series-differ = Les différences entre les { $series } séries apportent en moyenne { $percent } % des variances des paramètres.
set = ensemble
set-of-cycles = série de cycles
set-summary = { $set } : { $poses ->
        [one] { $poses } pose
       *[other] { $poses } poses
    }, { $errors ->
        [one] { $errors } erreur
       *[other] { $errors } erreurs
    }
set-summary-of = { $set } : { $poses ->
        [one] { $poses } pose
       *[other] { $poses } poses
    }, { $errors ->
        [one] { $errors } erreur
       *[other] { $errors } erreurs
    } ({ $point })
set-up-changes = Base et cibles : { $changed } grandeurs sur { $total } ont changé (attendu à chaque nouveau montage).
set-up-corrected = Le montage s’est déplacé de { $moved } au plus (plus grand déplacement d’une cible fixe depuis sa première mesure). Les positions ont été corrigées en { $steps ->
        [one] une étape
       *[other] { $steps } étapes
    } ; le déplacement restant des cibles est de { $left } au plus (RMS).
set-up-parameter-named = Paramètre { $name } (base ou cible)
sets = séries
settled-after-set = stabilisé après la série
severity-error = erreur
severity-warning = avertissement
share-of-points = proportion (%)
share-of-set = part de l’ensemble (%)
shared-risk = acceptation à risque partagé (JCGM 106:2012, 8.2.1)
shared-risk-explained = conforme si la valeur respecte la limite ; indécidé si U dépasse un quart de la limite
sheet-all-together = Ensemble
sheet-approach = approche depuis
sheet-approach-above = { $joint } par valeurs décroissantes
sheet-approach-below = { $joint } par valeurs croissantes
sheet-between-series = Entre séries
sheet-budget-of-errors = Bilan des erreurs
sheet-budget-of-orientations = Bilan des orientations
sheet-cell-frames = Repères
sheet-cell-residuals = Résidus de la cellule
sheet-clauses = Articles ISO 9283
sheet-controller-values = Valeurs du contrôleur
sheet-corners = Angles
sheet-correlation = Corrélation
sheet-covariance = Covariance
sheet-detectable = Changements décelables
sheet-distributions = Distributions
sheet-distributions-of-errors = Distributions des erreurs
sheet-done = fait
sheet-errors = Erreurs
sheet-frames = Repères
sheet-geometry-balls = Géométrie, billes
sheet-geometry-fits = Géométrie, ajustements
sheet-geometry-leads = Géométrie, pas
sheet-geometry-methods = Géométrie, méthodes
sheet-geometry-poses = Géométrie, poses
sheet-geometry-quantities = Géométrie, grandeurs
sheet-geometry-scale-bars = Géométrie, barres étalons
sheet-geometry-workspace = Géométrie, espace de travail
sheet-influence-of-poses = Influence des poses
sheet-inputs = Entrées
sheet-instrument-at = instrument en (mm, base du robot)
sheet-iso9283-approaches = ISO 9283 approches
sheet-iso9283-compliance = ISO 9283 compliance
sheet-iso9283-distances = ISO 9283 distances
sheet-iso9283-drift = ISO 9283 dérive
sheet-iso9283-places = ISO 9283 positions moyennes
sheet-iso9283-poses = ISO 9283 poses
sheet-iso9283-reference-targets = ISO 9283 cibles de référence
sheet-iso9283-robot = ISO 9283 robot
sheet-iso9283-variation = ISO 9283 variation
sheet-iso9283-visits = ISO 9283 positionnements
sheet-label = étiquette
sheet-known-values = Valeurs connues
sheet-messages = Messages
sheet-moved-values = Valeurs déplacées
sheet-not-a-number = pas un nombre
sheet-not-controlled = Non contrôlé
sheet-number = n°
sheet-operator-date = date, opérateur
sheet-packages = Paquets
sheet-parameter-effects = Effets des paramètres
sheet-path = Trajectoire
sheet-posing = Temps de positionnement
sheet-predicted-errors = Erreurs prédites
sheet-program = programme
sheet-program-value = { $file } ({ $language })
sheet-proven-effects = Effets confirmés
sheet-reference-data = Données de référence
sheet-reflector-at = réflecteur { $name } en (mm, bride)
sheet-reflector-axis = { $at } ; axe { $axis }, à moins de { $angle }° de l’instrument
sheet-refused-rows = Lignes rejetées
sheet-readings = Lectures
sheet-relative-accuracy = Exactitude relative
sheet-requirements = Exigences
sheet-robust-fit-poses = Ajustement robuste, poses
sheet-rows-left-out = { $count ->
    [one] { $count } autre ligne est omise : les documents la contiennent
   *[other] { $count } autres lignes sont omises : les documents les contiennent toutes
}
sheet-singular-values = Valeurs singulières
sheet-slips = Défauts introduits
sheet-stabilisation = Stabilisation
sheet-standstills = Arrêts
sheet-step = étape
sheet-step-frame = Points du repère atelier et des cibles de référence mesurés ; ils sont mesurés de nouveau après la dernière pose.
sheet-step-instrument = Instrument en température, de niveau et vérifié comme l’exige son fabricant ; sa position est celle indiquée ci-dessus.
sheet-step-reflectors = Réflecteurs en place, serrés et propres.
sheet-step-slow = Toutes les poses une fois à petite vitesse : ni collision, ni câble tendu, ni visée coupée.
sheet-step-zero = Les valeurs articulaires de la première pose affichées par le contrôleur sont celles de cette fiche.
sheet-streams = Enregistrements
sheet-study-parameters = Étude, paramètres
sheet-study-positions = Étude, positions
sheet-summary = Résumé
sheet-temperature = température de l’air au début et à la fin (°C)
sheet-tests = Essais
sheet-tool-point = Point d’outil
sheet-trends-of-residuals = Tendances des résidus
sheet-values = Valeurs
sheet-wait = attente à chaque pose
sheet-wait-seconds = { $seconds } s
sheet-wait-trigger = { $seconds } s ; la sortie { $output } est active pendant la seconde moitié
sheet-way-back = Essai après chargement
sheet-without-partner = Sans correspondance
should-know = À savoir
show = Afficher
show-all-rows = Afficher toutes les lignes
show-more = Afficher plus
signatures = Signatures
significant-changes = Significatif : { $campaigns }.
simple-acceptance = acceptation simple (ILAC-G8:09/2019, 4.2.1)
simple-acceptance-explained = conforme si la valeur respecte la limite ; le risque d’acceptation à tort est partagé et indiqué pour chaque limite
simulated-calibration-note = Données synthétiques : bruit gaussien de { $noise } µm sur chaque coordonnée ; moyenne de { $identifications } identifications. Les paramètres et les figures montrent l’une de ces moyennes. Les erreurs en fonction du nombre de positions sont des médianes de { $medians }. Les erreurs se rapportent à { $point } et sont évaluées sur { $configurations } configurations.
simulated-calibration-title = Étalonnage simulé
single-balls = Billes isolées, mesurées plusieurs fois
singular-value = valeur singulière
singular-value-number = numéro de la valeur singulière
singular-value-scaled = valeur singulière (colonnes divisées par leurs normes)
singular-values-caption = Valeurs singulières de la jacobienne à la solution, colonnes ramenées à la norme 1 comme dans l’identification : rang { $rank }, conditionnement { $condition } (plus grand cercle divisé par le plus petit).
singular-values-description = Une marque par valeur singulière, en ordre décroissant, sur un axe logarithmique. En haut : bien observable ; en bas : mal observable.
singular-values-title = Valeurs singulières de l’identification
sketch-title = Le modèle et ses paramètres
skipped = ignorée
smallest-sphere-and-circle = rayon de la plus petite sphère et du plus petit cercle circonscrits (µm)
solver = Solveur
solver-gradient-vanished = convergence : les résidus sont orthogonaux à la jacobienne
solver-iteration-limit = pas de convergence dans le nombre d’itérations permis : vérifier les valeurs de départ
solver-no-start = aucun départ de la recherche n’a mené à un élément
solver-not-finite = arrêt : un résidu n’est pas fini ; vérifier les valeurs de départ et les données
solver-rank-deficient = arrêt : des paramètres ne sont pas identifiables séparément ; en fixer un
solver-residuals-zero = convergence : les résidus sont nuls à l’arrondi près
solver-rounding = convergence à l’arrondi près : aucun pas plus court ne réduit les résidus
solver-step-vanished = convergence : le dernier pas a laissé les paramètres inchangés
solver-too-few-equations = arrêt : moins d’équations que de paramètres ; mesurer plus de poses ou fixer des paramètres
source-backup = fichier du contrôleur avant chargement
source-contact-meaning = incertitude indiquée du contact avec un siège, une surface ou un point mesuré
source-encoders-meaning = incertitude indiquée des codeurs aux segments
source-frame-meaning = points qui définissent le repère atelier (communs à toutes les poses)
source-frame-of-poses-meaning = points du repère mesuré de nouveau à chaque pose
source-homing-meaning = valeurs articulaires après la prise d’origine (communes à toutes les poses)
source-instrument-meaning = incertitude indiquée de chaque lecture de l’instrument
source-single-coordinates-meaning = incertitude indiquée des lectures d’une coordonnée, par exemple d’un comparateur
single-coordinates = coordonnées isolées
source-known-points-meaning = positions et longueurs indiquées de points fixes
source-model-meaning = erreur du modèle : part des résidus qu’aucune autre source n’explique
source-nominal-values-meaning = tolérances des valeurs nominales des paramètres
source-repeatability-meaning = dispersion des répétitions d’une pose au-delà de l’incertitude de l’instrument
source-residuals-meaning = dispersion des résidus (aucune incertitude n’est indiquée)
source-rigid-parts-meaning = formes indiquées des pièces qui portent des cibles
source-scale-meaning = échelle du système de mesure (commune à toutes les longueurs)
source-temperature-meaning = dilatation thermique du robot et de la pièce (commune à toutes les longueurs)
sources-of-the-formulas = Sources des formules
sphere-x-y-z = sphère x, y, z
spheres-and-conventions = Sphères circonscrites et conventions
stabilisation-and-overshoot = Temps de stabilisation et dépassement de pose
stabilisation-path-length = longueur de trajectoire de stabilisation
stabilisation-time = temps de stabilisation
straight-distance = distance en ligne droite
stability = stabilité
standard-deviation = écart-type
standstills = arrêts
state-of-the-robot = état du robot
stated-tolerance = tolérance indiquée
stated-uncertainty = incertitude indiquée
static-compliance = Compliance statique
status = état
step-arc = arc de la bille { $ball } autour de { $about }
step-plane-of-rails = plan des rails
step-shaft = arbre, répétition { $repeat }, position { $position }
step-travel = course de l’actionneur { $actuator }
stream = enregistrement

sum-of-squares-tested = χ² = { $sum } pour { $degrees } degrés de liberté, { $p }

template = gabarit

surface = surface
synthetic-data = données synthétiques
synthetic-data-label = Données synthétiques :
synthetic-mark = DONNÉES SYNTHÉTIQUES
table = tableau
target = cible
target-coordinates = { $count } coordonnées de cibles (mm)
target-motion-explains-most = les paramètres ne sont plus valables : un mouvement de la cible { $target } de { $by } (k = 2) explique { $percent } % de l’écart ; les résidus restants sont plus grands que prévu
target-moved = la cible { $target } a bougé de { $by } (k = 2) sur sa pièce
target-movement-caption = Plus grand déplacement d’une cible depuis sa première mesure, et RMS du déplacement restant.
target-named = la cible { $target }
targets-as-measured = cibles mesurées
targets-from-their-places = distance des cibles à leurs positions de référence
targets-in-world = cibles dans le repère atelier
targets-placed-by-validation = Aucune pose d’étalonnage ne mesure { $targets } : cibles localisées d’après les lectures aux poses de validation, les paramètres identifiés du robot étant fixés. Chacune de ces erreurs est divisée par √r (r : redondance). La valeur de U est celle des autres lectures.
temperature = température
temperature-range = de { $lowest } °C à { $highest } °C dans les exports
temperature-of-robot = température du robot
torques-of-joints = couples des articulations
test-certificate = Certificat d’essai
test-certificate-draft = Projet de certificat d’essai
test-cube = P1 est le centre d’un cube de { $size } mm, P2 à P5 sont sur les diagonales du plan d’essai (ISO 9283:1998, 6).
test-of-changes = résidus que la base ou les articulations peuvent causer
test-of-rest = tous les autres résidus
test-of-synthetic-data = Essai sur données synthétiques, sans valeur de certificat
test-square = P1 est le centre d’un carré de { $size } mm, P2 à P5 sont sur ses diagonales (ISO 9283:1998, 6).
tested-by = Essai réalisé par
text = texte
texts-of-campaign-note = Les textes de la campagne ne sont pas traduits.
the-campaign-fits-no-features = La campagne n’ajuste aucun élément.
the-campaign-states-no-limits = Aucune limite n’est indiquée : aucun verdict n’est possible.
their-standard-deviation = écart-type
this-file-max = ce fichier, max.
this-file-rms = ce fichier, RMS
three-s-of-x = 3 s de x
three-s-of-y = 3 s de y
three-s-of-z = 3 s de z
time-in-s = temps (s)
time-since-entry = temps depuis l’entrée (s)
times-for-each-cycle = { $count } fois, une par pose et cycle
to = à
to-complete-count = À compléter avant signature : { $count ->
        [one] un champ
       *[other] { $count } champs
    }
to-distance = à
to-hold = à fixer
to-load = à charger
to-load-later = à charger plus tard
to-pose = à la pose
tolerance = tolérance
tool-error-definition = { $error } ; nominal moins identifié : différence entre les positions prédites par les deux jeux de paramètres ; attendue : norme (k = 1) ; contributions : covariance des paramètres, tolérance des paramètres que les données ne peuvent pas déterminer, erreur du modèle au-delà de l’incertitude de l’instrument, position du point sur l’outil ; les erreurs des cibles excluent les paramètres qui déplacent cibles et outil de la même façon
tool-point-expected = Erreur attendue, RMS (k = 1) : paramètres { $parameters } µm ; paramètres que les données ne peuvent pas déterminer (tolérance) { $undetermined } µm ; erreur du modèle { $model } µm ; position du point sur l’outil { $point } µm. Plus grande incertitude élargie d’une pose (k = 2) : { $largest } µm.
tool-point-headline = point d’outil, RMS : nominal moins identifié → attendue
traceability = traçabilité
trend = tendance
trend-description = Une marque par campagne avec son intervalle à 95 % ; losanges : changement significatif.
trend-in-picture = Tendance non modélisée ({ $probability }).
trend-of = Évolution de
trend-of-all-quantities = Tendance non modélisée de toutes les grandeurs mesurées ensemble ({ $probability }).
trends-note = Tests F des erreurs moyennes des poses d’étalonnage après identification : parabole contre constante ; valeurs p corrigées de la multiplicité des tests (Holm 1979). Une tendance est une erreur que le modèle ne décrit pas.
trends-of-the-residuals = Tendances des résidus
trends-suggest-field = Les résidus présentent encore une tendance : `field = true` dans [identify] cherche un champ résiduel.
true = vrai
turn-down = Tourner vers le bas
turn-left = Tourner à gauche
turn-right = Tourner à droite
turn-up = Tourner vers le haut
type = type
u-allowed = U admise
u-bootstrap = u, bootstrap
u-draws = u, tirages
u-linear = u, linéaire
u-of-deviation = son u (k = 1)
u-of-identified = u de la valeur identifiée
u-of-position = U d’une position
u-over-ap = U / AP
u-over-rp = U / RP
u-over-value = U / valeur
u-report = u, rapport
uncertainties = incertitudes
uncertainties-enlarged-by = facteur de majoration des incertitudes
uncertainties-of-robot = Incertitudes du robot { $robot }
uncertainty-by-default-tolerances = Pour celles-ci, le programme prend sa tolérance par défaut, multipliée par { $factor }, le facteur le plus compatible avec les données.
uncertainty-by-tolerances = Valeurs dont l’incertitude restante provient surtout des tolérances de valeurs nominales, les leurs ou d’autres ({ $count }) : { $names }. Parmi ces tolérances, valeurs par défaut du modèle : { $default }.
uncertainty-budget = Bilan d’incertitude
uncertainty-for-outliers = ± { $uncertainty } µm par coordonnée ({ $factor } écarts-types), indépendante pour chaque observation
uncertainty-inflation = { $factor } fois la valeur due { $beside ->
        [instrument] à l’incertitude indiquée seule
       *[residuals] à des résidus indépendants
    } (médiane)
uncertainty-of-instrument = l’incertitude-type de l’instrument
uncertainty-of-instrument-and-contact = l’incertitude-type de l’instrument et du contact
uncertainty-of-readings = l’incertitude-type indiquée des lectures
uncertainty-of-rp = Incertitude de RP
undecided = indécidé
unit = unité
unjudged-by-misfit = Non jugées, car le modèle ne convient pas : { $count }.
unjudged-without-uncertainty = Non jugées, car l’incertitude est inconnue : { $count }.
unknown-without-redundancy = inconnue (nombres égaux d’équations et de paramètres)
unshown-frame-points = erreurs des points qui définissent le repère atelier : sans redondance, elles ne font que déplacer le repère
unshown-frame-targets = erreurs de position des cibles qui définissent le repère atelier : les positions mesurées sont la référence
unshown-scale = un facteur commun à toutes les longueurs mesurées : absorbé par les longueurs du robot
unshown-shift = une translation ou une rotation commune à toutes les lectures : absorbée par la base
valid-until = valable jusqu’au
valid-until-agreed = valable jusqu’au, convenu avec le client
valid-until-column = Valable jusqu’au
validation = validation
validation-of-given-parameters = Validation de paramètres donnés
value = valeur
value-and-limit = { $quantity } { $value } { $unit }, limite { $limit } { $unit }
value-tooltip = { $name } : { $value } ± { $uncertainty } { $unit }
value-with-interval = { $value } µm (95 % : { $low } à { $high })
values-by-nominal = { $count ->
        [one] { $count } valeur provient surtout de sa valeur nominale, car les données la déterminent peu : { $names }.
       *[other] { $count } valeurs proviennent surtout de leurs valeurs nominales, car les données les déterminent peu : { $names }.
    }
values-given = avant : paramètres nominaux du robot, avec la base et les cibles que l’étalonnage antérieur leur a ajustées ; après : tous les paramètres tels que donnés, base et cibles comprises ; aucun ajustement à ces données
values-given-prior = avant : paramètres nominaux du robot, avec base et cibles ajustées aux poses d’étalonnage ; après : tous les paramètres tels que donnés, base et cibles étant estimées d’après leur covariance donnée et les poses d’étalonnage (valeurs les plus probables)
values-given-refit = avant : paramètres nominaux du robot ; après : paramètres donnés ; les deux avec base et cibles ajustées aux poses d’étalonnage
values-nominal = avant et après : paramètres nominaux, base et cibles comprises ; aucun ajustement à ces données
values-nominal-refit = avant et après : paramètres nominaux du robot, avec base et cibles ajustées aux poses d’étalonnage
values-of-every-campaign = Valeurs par campagne
values-of-identification = avant : paramètres nominaux du robot, avec seules base et cibles ajustées aux poses d’étalonnage ; après : tous les paramètres identifiés
velocities = vitesses
velocity-of-poses = { $velocity } (poses)
velocity-of-recording = { $value } mm/s ({ $name })
velocity-sentence = Vitesse : { $velocity }.
verdict = verdict
files-beyond-limits = Ne pas charger { $files } : avec les valeurs de { $count ->
        [one] ce fichier
       *[other] ces fichiers
    }, une limite n’est pas respectée.
given-not-loaded = Ne pas charger les paramètres donnés. S’ils sont chargés, rétablir le fichier précédent du contrôleur.
verdict-conditional = Verdict : conforme avec réserves.
verdict-fail = Verdict : non conforme.
verdict-is-of-file = Ces erreurs sont celles de `{ $file }`{ $count ->
        [0] {""}
        [one] , sans un paramètre identifié
       *[other] , sans { $count } paramètres identifiés
    } : RMS { $rms } { $unit } ; avec tous les paramètres { $whole } { $unit }.
verdict-pass = Verdict : conforme.
verdict-title = Verdict
verdict-undecided = Verdict : indécidé.
verification-of-identified-parameters = Vérification de paramètres identifiés
verified-by-copies = rien de nouveau n’a été mesuré : { $count } lectures sur { $rows } sont des lectures de l’étalonnage
verified-by-program = un programme indépendant ; non comparé à un exemplaire acheté de la norme
verified-by-simulation = des mouvements simulés ; non comparés à un exemplaire acheté de la norme
verified-by-text = le texte de la norme, un jeu de données publié et un programme indépendant
verify-step-apart = mesurer des poses qui distinguent ces mouvements : { $motions }
verify-step-apart-reason = ils expliquent aussi bien les résidus ; `etalon verify --candidates` choisit des poses
verify-step-base = contrôler la fixation de la base et les points de référence du référentiel atelier
verify-step-base-reason = un mouvement de la base ne change aucun paramètre du robot lui-même
verify-step-joint = recaler l’articulation { $joint }, ou ajouter { $by } à ses valeurs articulaires
verify-step-joint-reason = l’articulation se trouve en réalité à sa valeur du journal plus ce décalage
verify-step-keep = garder le fichier chargé
verify-step-keep-reason = aucun changement n’est significatif ; les plus petits changements que ces poses détectent figurent ci-dessous
verify-step-new = mesurer de nouveau les poses, remplacer les exports et les journaux
verify-step-new-reason = { $count } lignes sont des copies de lectures de l’étalonnage
verify-step-other = mesurer de nouveau à d’autres poses ; si l’écart persiste, étalonner de nouveau
verify-step-other-reason = aucun mouvement seul ne l’explique ; s’il est apparu au chargement d’un fichier, restaurer le fichier précédent
verify-step-target = contrôler le montage de la cible { $target }
verify-step-target-reason = les paramètres du robot lui-même ne sont pas contredits
verify-step-verify = puis exécuter de nouveau `etalon verify`
verify-step-verify-reason = seules de nouvelles lectures montrent que le changement est corrigé
view-as-drawn = Vue initiale
view-xy = x-y
view-xz = x-z
view-yz = y-z
visit-of-cycle-tooltip = pose { $pose }, cycle { $cycle } : x { $x }, y { $y } µm
visit-tooltip = pose { $pose }, cycle { $cycle }, { $approach } : x { $x }, y { $y }, z { $z } µm depuis la moyenne
visits = positionnements
visits-by-approach = { $visits } positionnements autour de leur moyenne, par direction d’approche ; grandes marques : moyennes.
visits-by-approach-in-space = { $visits } positionnements autour de leur moyenne ; couleur et forme : direction d’approche ; grandes marques : moyennes.
visits-by-plane = Positionnements à chaque pose, par plan
visits-from-one-pose = { $visits } positionnements autour de leur moyenne, { $unknown ->
        [0] tous selon la même direction d’approche ; grande marque : moyenne.
        [one] tous sauf un selon la même direction d’approche ; la direction d’un positionnement est inconnue, car aucune pose n’a été enregistrée avant lui. Grande marque : moyenne des autres positionnements.
       *[other] tous sauf { $unknown } selon la même direction d’approche ; la direction de { $unknown } positionnements est inconnue, car aucune pose n’a été enregistrée avant eux. Grande marque : moyenne des autres positionnements.
    }
visits-from-unknown-poses = { $visits } positionnements autour de leur moyenne ; leurs directions d’approche sont inconnues.
visits-of-pose-title = Pose { $pose }, plan { $plane }
visits-over-time = Positionnements au fil du temps
warm-up-before-the-test = mise en température avant l’essai
warnings-and-remarks = Avertissements et remarques
way-back-after = après chargement
way-back-before = avant chargement
way-back-display = pose affichée
way-back-evaluated = Avec les entrées de la pose { $pose } ({ $inputs }) et ses valeurs articulaires ({ $joints }), le fichier donne x = { $x }, y = { $y }, z = { $z } mm. Un logiciel qui ignore les entrées s’en écarte de { $effect } mm.
way-back-file = fichier avant chargement
way-back-base-moves = Des articulations déplacent le segment `{ $base }` : aucun contrôleur n’affiche ces poses. Un logiciel qui calcule la chaîne les donne, par exemple `etalon kinematics direct`.
way-back-links = Référentiel de la base : segment `{ $base }`. Bride : segment `{ $link }`.
way-back-inputs = Les deux lignes sont calculées avec : { $inputs }. Avec d’autres valeurs, la seconde ligne diffère.
way-back-loaded = fichier à charger
way-back-moved = plus grand changement d’une position apprise
way-back-moved-by = { $change } mm dans le référentiel de la base, à la pose { $pose }
way-back-not-stated = non indiqué : le sauvegarder et l’indiquer comme `controller_backup` dans [conditions]
way-back-other-poses = Affichage à d’autres poses, d’après les valeurs articulaires avant chargement : `etalon kinematics direct JOINTS.csv --robot robot.toml --parameters out/parameters.json --loaded { $file }`.
way-back-restore = Retour : recharger le fichier d’avant le chargement. Il est rétabli si l’affichage donne au même endroit la même pose qu’avant le chargement.
way-back-test = Avant le chargement, aller à la pose { $pose } : { $joints }. Charger sans bouger le robot. L’affichage doit passer de la première à la deuxième ligne. Il montre la bride dans le référentiel de la base, sans outil ni pièce. La première ligne vaut pour les valeurs nominales : si le contrôleur en a d’autres, noter son affichage.
way-back-title = Vérification après chargement et retour
way-back-unread = Les valeurs de ce fichier ne sont pas lues : « avant » désigne le robot avec les paramètres nominaux.
way-back-change-too-small = L’arrondi des valeurs articulaires et de l’affichage explique des écarts jusqu’à { $tolerance } mm ; le fichier modifie cette pose de { $change } mm. Vérifier plutôt par une mesure.
way-back-compensated = Si l’on corrige plutôt les programmes par `etalon compensate`, ne charger aucun fichier. Une cible à la seconde ligne est alors commandée comme la première ligne, et l’affichage doit montrer les valeurs articulaires ci-dessus.
way-back-tolerance = Tolérance de la comparaison : { $tolerance } mm. L’arrondi des valeurs articulaires et de l’affichage n’explique pas d’écart plus grand.
way-back-without-display = Le modèle n’a pas de pose d’une bride que montre un affichage. Vérifier le fichier par une mesure : commander quelques poses avec lui et les mesurer. Retour : recharger le fichier sauvegardé.
way-back-verify = Plus tard, mesurer quelques poses et placer les nouveaux fichiers dans une copie de la campagne. Lancer ensuite `etalon verify COPY --robot robot.toml --parameters out/parameters.json`.
way-back-verify-mastered = Si les valeurs articulaires du contrôleur contiennent les zéros chargés (calage), ajouter `--mastered { $file }`.
weaker-trends = Autres tendances significatives
weave = balayage
way-back-mastered = Si le contrôleur prend le fichier comme valeurs de calage, ses valeurs articulaires doivent devenir : { $joints }.
weave-passes = { $passes ->
        [one] { $passes } passage
       *[other] { $passes } passages
    }, { $turns ->
        [one] { $turns } inversion
       *[other] { $turns } inversions
    }
way-back-test-software = À la pose { $pose }, calculer la pose de la bride pour ces valeurs articulaires : { $joints }. Avec les paramètres nominaux, votre logiciel doit donner la première ligne, avec le fichier la seconde. Les deux lignes sont dans le référentiel de la base, sans outil ni pièce.
weaving = Balayage
weaving-frequency = fréquence du balayage
weaving-frequency-measured = { $measured } Hz, commandée { $commanded } Hz : WF { $ratio } %
weaving-passes = balayage, passages
weaving-stroke = course du balayage
weaving-stroke-measured = { $measured } mm, commandée { $commanded } mm : WS { $ratio } %
weaving-turns = balayage, inversions
weight = poids
what-changed = Changements entre campagnes
what-differs-between-series = Différences entre les séries
what-no-reading-shows = erreurs non décelables
wider-than-window = Plus large que la fenêtre : faire défiler latéralement.
with-colon = { $label } :
with-field = avec le champ
without-field = sans le champ
workspace = Espace de travail
workspace-outlines = Contours de ces régions ; trait fort : atteignable avec toutes les orientations.
workspace-plane = Espace de travail du centre C de la plate-forme, plan { $plane }
world-frame = repère atelier
world-frame-title = Repère atelier
worst-campaigns = Les { $worst } campagnes les moins bonnes sont affichées. Les { $left_out } autres apparaissent lorsque les scripts sont activés ; batch.parquet contient toutes les campagnes.
written-by = écrit par
x-y-z-rp = x, y, z (RP)
yes = oui

### Messages de selftest ; explications dans en/selftest.ftl.

selftest-data-unreadable = les données de référence `{ $name }` du programme ne peuvent pas être lues : { $reason }
    .hint = installer etalon de nouveau

selftest-folder-not-written = impossible d’écrire dans `{ $folder }` : { $reason }
    .hint = définir `TMPDIR` (`TEMP` sous Windows) comme un dossier accessible en écriture

selftest-hash-expected = un SHA-256 : 64 chiffres hexadécimaux

selftest-fits = Éléments géométriques : les ajustements concordent avec un programme indépendant (60 chiffres), les zones minimales et les cercles circonscrits avec des valeurs exactes
selftest-solver = Solveur : des problèmes publiés de moindres carrés non linéaires atteignent leurs minima publiés
selftest-frames = Repères : orientations et transformations concordent avec des valeurs exactes
selftest-kinematics = Cinématique : chaque modèle concorde avec un programme indépendant (60 chiffres), son inverse, des dérivées numériques et le code exporté
selftest-identification = Identification : des observations exactes redonnent les paramètres ; une campagne entière redonne les valeurs vraies dans leur incertitude
selftest-reference = Campagnes de référence : paramètres, covariance et erreurs concordent avec un programme indépendant (110 chiffres)
selftest-uncertainty = Incertitudes : les exemples publiés du GUM (H.1 à H.3) et de JCGM 101 (9.2 à 9.5) sont reproduits
selftest-standards = ISO 9283 et ISO 230-2 : les caractéristiques concordent avec des programmes indépendants
selftest-coverage = Couverture : les intervalles à 95 % contiennent la valeur vraie dans 95 % des campagnes simulées
selftest-formats = Exports des systèmes de mesure : des textes connus donnent leurs coordonnées ; chaque format se relit comme il a été écrit
selftest-exports = Fichiers pour le contrôleur : les valeurs écrites se relisent sans changement
selftest-threads = Fils d’exécution : la même entrée donne les mêmes octets sur un et sur plusieurs fils
selftest-nist = Données de référence du NIST : les éléments ajustés concordent avec les éléments publiés

selftest-not-made = { $name } : impossible : { $reason }
selftest-fit-point = { $name } : point
selftest-fit-direction = { $name } : direction
selftest-fit-size = { $name } : rayon ou angle
selftest-fit-squares = { $name } : somme des carrés
selftest-fit-uncertainty = { $name } : incertitude-type du rayon
selftest-zone = { $name } : zone minimale
selftest-enclosing = { $name } : plus petit rayon circonscrit
selftest-sum-of-squares = { $name } : somme des carrés au minimum
selftest-solution = { $name } : paramètres au minimum
selftest-covariance = { $name } : covariance
selftest-quaternion = quaternion d’une rotation
selftest-quaternion-back = rotation d’un quaternion
selftest-rotation-vector = matrice de rotation d’un vecteur de rotation
selftest-rotation-vector-back = vecteur de rotation d’une matrice de rotation
selftest-rpy = matrice de rotation de roulis, tangage, lacet
selftest-rpy-back = roulis, tangage, lacet d’une matrice de rotation
selftest-apply = transformation d’un point
selftest-inverse = transformation après son inverse
selftest-rigid = transformation entre deux ensembles de points
selftest-rigid-rms = résidus de cette transformation
selftest-positions = { $name } : positions des cibles
selftest-jacobian = { $name } : dérivées moins dérivées numériques
selftest-inverse-none = { $name } : l’inverse ne trouve aucune valeur articulaire
selftest-direct-of-inverse = { $name } : direct(inverse(pose)) moins pose
selftest-inverse-of-direct = { $name } : inverse(direct(articulations)) moins articulations
selftest-code = { $name } : position calculée par le code `{ $format }` exporté
selftest-recovered = { $name } : positions par les paramètres identifiés à partir d’observations exactes
selftest-truth = { $name } : plus grand écart d’un paramètre à sa valeur vraie, divisé par son incertitude
selftest-chi-square = khi-deux divisé par les degrés de liberté
selftest-certified-values = { $name } : { $count } paramètres
selftest-certified-uncertainties = { $name } : incertitudes-types
selftest-certified-status = { $name } : paramètres fixés ou identifiés à tort
selftest-certified-covariance = { $name } : covariance
selftest-certified-residuals = { $name } : moyenne quadratique et khi-deux
selftest-certified-errors = { $name } : erreurs avant et après
selftest-gum = { $name }
selftest-draws-mean = { $name } : moyenne des tirages
selftest-draws-u = { $name } : incertitude-type des tirages
selftest-draws-interval = { $name } : intervalle à { $percent } %
selftest-draws-shortest = { $name } : plus court intervalle à { $percent } %
selftest-linear-u = { $name } : incertitude-type au premier ordre
selftest-chi-square-table = quantiles du khi-deux
selftest-f-table = quantile de la loi F
selftest-conformity = probabilité de conformité
selftest-characteristic = { $name }
selftest-shares = part des intervalles qui contiennent la valeur vraie, { $parameters } paramètres, { $draws } campagnes
selftest-mean-chi-square = moyenne du khi-deux divisé par les degrés de liberté, { $draws } campagnes
selftest-read = { $name } en { $unit } : texte connu
selftest-written-read = { $name } en { $unit } : écrit et relu
selftest-listed = { $format } : valeurs placées à côté de leurs noms
selftest-file-robot = { $format } : robot décrit par le fichier
selftest-same-bytes = fichiers différents entre 1 et { $threads } fils d’exécution, sur { $files }
selftest-files-written = tous les fichiers sont écrits
selftest-nist-sets = { $name } : plus grand écart dans { $count } jeux de données

selftest-wrong-digit = chiffre faux : chiffre significatif { $digit } de `{ $place }`
selftest-swapped = intervertis : `{ $first }` et `{ $second }`
selftest-wrong-unit = unité fausse : `{ $place }` fois { SCIENTIFIC($factor, 3) }

selftest-other-version = le document conservé est d’etalon { $before }, le programme est etalon { $after }
selftest-other-input = `{ $file }` a changé
selftest-new-input = `{ $file }` n’est pas parmi les entrées conservées
selftest-missing-input = `{ $file }` n’est plus une entrée
selftest-other-model = le robot était du modèle `{ $before }` et est du modèle `{ $after }`

selftest-title = Validation de l’installation
selftest-subtitle = etalon { $version } sous { $system } { $architecture } ; validation du logiciel avant utilisation (ISO/IEC 17025:2017, 7.11.2)
selftest-passed = { $checks } essais de { $requirements } exigences réussis ; { $slips } défauts introduits sur { $slips } ont été détectés
selftest-failed = { $failed ->
        [one] { $failed } essai sur { $checks } a échoué
       *[other] { $failed } essais sur { $checks } ont échoué
    }
selftest-slips-missed = { $missed ->
        [one] { $missed } défaut introduit sur { $slips } n’a pas été détecté
       *[other] { $missed } défauts introduits sur { $slips } n’ont pas été détectés
    }
selftest-program-changed = le fichier du programme n’a pas le SHA-256 déclaré
selftest-program-unreadable = le fichier du programme ne peut pas être lu
selftest-reference-changed = données de référence modifiées : { $files }
selftest-values-same = campagne { $campaign } : { $compared } paramètres sont ceux du document conservé
selftest-values-moved = { $moved ->
        [one] campagne { $campaign } : { $moved } valeur diffère du document conservé
       *[other] campagne { $campaign } : { $moved } valeurs diffèrent du document conservé
    }
selftest-statement = Ce procès-verbal s’applique au fichier de programme qui a ce SHA-256, sur cette machine.
selftest-overview = Exigences
selftest-failed-tests = Essais échoués
selftest-installation = Installation (QI)
selftest-operation = Fonctionnement (QO)
selftest-slips = Défauts introduits à détecter
selftest-performance = Performance (QP)
selftest-program-hash = SHA-256 du programme
selftest-stated-hash = SHA-256 déclaré
selftest-system = système
selftest-threads-offered = fils d’exécution
selftest-packages = paquets
selftest-packages-note = Paquets de Cargo.lock, à partir desquels sont construits le programme, ses scripts de construction et ses essais.
selftest-nist-absent = données de référence du NIST : absentes (définir `ETALON_REFERENCE` comme un dossier qui les contient)
selftest-nist-present = données de référence du NIST : présentes
selftest-requirement = exigence
selftest-tests = essais
selftest-test = essai
selftest-source = source
selftest-expected = attendu
selftest-found = trouvé
selftest-deviation = écart
selftest-permissible = admissible
selftest-result = résultat
selftest-result-pass = conforme
selftest-result-fail = non conforme
selftest-slip = défaut introduit
selftest-tests-failed = essais échoués
selftest-as-it-must = échoue comme prévu
selftest-missed = non détecté
selftest-reference-data = données de référence
selftest-package = paquet
selftest-version = version
selftest-quantity = grandeur
selftest-over-u = différence / u
selftest-tolerance = Admissible : { SCIENTIFIC($of_uncertainty, 0) } incertitude-type pour une valeur, { SCIENTIFIC($of_uncertainty, 0) } d’elle-même pour une incertitude, { SCIENTIFIC($relative, 0) } d’elle-même pour une valeur sans incertitude.
selftest-cause = Différence connue : { $cause }.
selftest-cause-unknown = Aucune différence connue : version, modèle et entrées sont les mêmes.

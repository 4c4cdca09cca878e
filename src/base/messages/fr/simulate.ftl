### Messages de simulate ; explications dans en/simulate.ftl.

truth-joint-count = une pose a { $values } valeurs articulaires, le robot { $joints } articulations
    .hint = indiquer une valeur par articulation, et le mode d’assemblage d’une plate-forme

truth-label-with-circles = `label` dans [[poses]] est pour `joints`, pas pour `circles`
    .hint = omettre `label`, ou indiquer `joints`

truth-point-unknown = [[poses]] nomme le point `{ $label }`, qui n’est pas un [[point]]

truth-circles-not-planar = `circles` est pour les robots plans
    .hint = utiliser `joints`

truth-parameter-unknown = [parameters] nomme `{ $parameter }`, qui n’est pas un paramètre de ce robot

truth-target-unknown = [repeatability] de la vérité : le robot n’a pas de cible `{ $target }`

truth-pose-missing = la pose { $pose } de la trajectoire n’est pas dans la vérité
    .hint = l’ajouter à `joints` de [[poses]] et à [[repeatability.pose]]

truth-repeatability-without-campaign = la vérité a [repeatability], la campagne non
    .hint = indiquer [repeatability] dans campaign.toml : elle nomme étiquettes et trajectoire

truth-home-count = `home` a { $values } valeurs articulaires, le robot { $joints } articulations
    .hint = indiquer une valeur par articulation

simulate-not-written = simulate ne peut pas écrire { $what }
    .hint = indiquer un autre fichier pour simuler, puis le vrai

several-tables = plusieurs tableaux d’observations ne sont pas simulés
    .hint = simuler une campagne avec un seul d’entre eux

simulated-kind = { $kind ->
        [twincat] un export TwinCAT
        [moving-log] un journal enregistré pendant le mouvement
        [period-log] un journal dont les temps suivent de sa période, pour une jointure par temps
        [repeated-columns] un journal qui nomme des colonnes deux fois
        [workbook-sheet] une feuille de classeur
        [encoding] un tableau dans un autre codage que UTF-8
        [blank-columns] un tableau d’observations à colonnes séparées par des espaces : ses cellules vides disparaîtraient
        [computed-columns] un tableau d’observations à colonnes calculées, numérotées ou constantes, à filtres, ou dont l’en-tête n’est pas d’une ligne
        [unmodelled] un tableau d’observations avec des erreurs de {"["}unmodelled]
       *[backlash] un tableau d’observations d’un robot à jeu
    }

coordinates-of-other-kind = `coordinates` est pour le genre `point` sans station
    .hint = omettre `coordinates`

in-numbered-table = [[{ $table }]] { $number } : { $message }

in-set = ensemble `{ $set }` : { $message }

export-without-points = rien dans la vérité ne va dans l’export `{ $file }`
    .hint = ajouter un [[point]] avec cet `export`, ou `label` ou `target` à l’export dans la campagne

simulate-utf8 = simulate écrit en UTF-8
    .hint = omettre `encoding` de cet export

simulated-rows-lost = `{ $file }` serait lu avec { $read } lignes sur { $rows }
    .hint = nommer cible, pose et cycle dans `label` ou `columns` ; `pose = "row"` est pour une cible par fichier ; sans cycle, indiquer `cycles = 1` dans la vérité

simulated-row-misread = la ligne { $line } de `{ $file }` est { $meant }, et serait lue comme { $read }
    .hint = nommer cible, pose et cycle dans `label` ou `columns` ; `pose = "row"` est pour une cible par fichier ; sans cycle, indiquer `cycles = 1` dans la vérité

measurement-name = cible `{ $target }`, pose { $pose }, cycle { $cycle }

truth-pose-out-of-reach = la pose { $pose } est hors d’atteinte : { $reason }
    .hint = corriger la pose dans la vérité, ou [reach] dans robot.toml

truth-point-out-of-reach = pose { $pose } : le robot vrai n’atteint pas son point { $point } mm
    .hint = corriger le point ou la pose dans la vérité

observe-without-table = la vérité a [[observe]], et la campagne pas de [observations]
    .hint = indiquer le tableau dans campaign.toml : `[observations]` avec `file`

table-without-observe = la vérité n’a pas de [[observe]] pour le tableau de [observations]
    .hint = indiquer ce qui est observé : kind = "point", target = "ball" ... ; docs/observations.md énumère les genres

campaign-not-synthetic = la campagne n’indique pas qu’elle est synthétique : ses fichiers peuvent être mesurés
    .hint = indiquer `synthetic = "origine des données"` dans campaign.toml ; `etalon init --synthetic DOSSIER` écrit une telle campagne avec une vérité

truth-decimals = { $decimals } décimales, c’est plus qu’un nombre n’en a
    .expected = 0 à { $most }

joints-and-points-together = un fichier avec articulations et points ensemble ne peut pas être simulé
    .hint = indiquer un export et un [log] séparés

point-label-formula = l’étiquette `{ $label }` d’un [[point]] est une formule dans un tableur
    .hint = utiliser une étiquette qui ne commence pas par = + - ou @

truth-parameters-missing = [parameters] n’indique pas { $parameters }
    .hint = indiquer où sont les objets fixes observés

unmodelled-joint-unknown = [unmodelled] nomme `{ $joint }`, qui n’est pas une articulation de ce robot

unmodelled-period = [unmodelled] `period` de `{ $joint }` doit être positif
    .hint = indiquer une période positive

study-too-few-poses = trop peu de poses pour identifier tous les paramètres
    .hint = ajouter des poses à l’ensemble

study-set-empty = un ensemble n’a pas de pose que le robot atteint
    .hint = indiquer des poses atteignables

study-not-by-position = `{ $model }` ne peut pas être placé par des positions
    .hint = indiquer `joints`, ou un tableau dans `file`

study-without-tool = `{ $model }` n’a pas de pose d’outil
    .hint = utiliser un modèle avec cinématique

truth-not-touching = pose { $pose } : aucune valeur articulaire proche de la vérité n’établit le contact
    .hint = indiquer des valeurs articulaires plus proches du contact, ou une plage de tirage plus large

angle-uncertainty-missing = l’incertitude d’un angle manque
    .hint = indiquer `expanded_rotation_uncertainty_deg` dans [instrument], ou `urot_deg` dans [[observe]]

simulated-table-misread = `{ $file }` serait mal lu : une observation de la pose { $pose } s’écarte de { FIXED($off, 3) } mm ou rad
    .hint = `pose = "row"` et `target` de [observations] sont pour une cible et une ligne par pose

truth-geometric-without-campaign = la vérité a [geometric], la campagne non ou son robot n’est pas un PreXYT
    .hint = indiquer [geometric] dans campaign.toml : elle nomme les étiquettes

study-error-in-base = pose vraie de l’outil dans le référentiel de la base moins la pose commandée
study-error-in-world = pose vraie de l’outil dans le référentiel atelier moins la pose commandée
poses-in-set = poses de l’ensemble `{ $set }`
positions-in-workspace = positions dans `workspace`
counted-calibrations = étalonnages
errors-to-evaluate = erreurs à évaluer
poses-to-simulate = poses à simuler
points-to-simulate = points à simuler

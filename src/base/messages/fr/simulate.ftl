### Messages de simulate ; explications dans en/simulate.ftl.

truth-joint-count = une pose a { $values } valeurs articulaires, le robot { $joints } articulations
    .hint = indiquer une valeur par articulation, et pour une plate-forme son mode d’assemblage

truth-label-with-circles = `label` dans [[poses]] ne s’applique qu’à `joints`, et non à `circles`
    .hint = omettre `label`, ou indiquer `joints`

truth-point-unknown = [[poses]] mentionne le point `{ $label }`, qui n’est pas un [[point]]

truth-circles-not-planar = `circles` ne s’applique qu’aux robots plans
    .hint = utiliser `joints`

truth-parameter-unknown = [parameters] mentionne `{ $parameter }`, qui n’est pas un paramètre de ce robot

truth-target-unknown = [repeatability] des valeurs vraies : le robot n’a pas de cible `{ $target }`

truth-pose-missing = la pose { $pose } de la trajectoire manque dans les valeurs vraies
    .hint = l’ajouter à `joints` de [[poses]] et à [[repeatability.pose]]

truth-repeatability-without-campaign = [repeatability] figure dans les valeurs vraies, mais pas dans la campagne
    .hint = indiquer [repeatability] dans campaign.toml : cette section donne les étiquettes et la trajectoire

truth-home-count = `home` a { $values } valeurs articulaires, le robot { $joints } articulations
    .hint = indiquer une valeur par articulation

simulate-not-written = `etalon simulate` ne peut pas écrire { $what }
    .hint = indiquer un fichier qui peut être simulé, et le remplacer ensuite par le vrai fichier

several-tables = `etalon simulate` n’écrit qu’un tableau d’observations, et non plusieurs
    .hint = simuler une campagne avec un seul d’entre eux

simulated-kind = { $kind ->
        [twincat] un export TwinCAT
        [moving-log] un journal enregistré pendant le mouvement
        [period-log] un journal avec `period_s` pour une jointure par le temps
        [repeated-columns] un journal qui mentionne deux fois une colonne
        [workbook-sheet] une feuille de classeur
        [encoding] un tableau dans un autre encodage que UTF-8
        [blank-columns] un tableau d’observations dont les colonnes sont séparées par des espaces : ses cellules vides disparaîtraient
        [computed-columns] un tableau d’observations à colonnes calculées, numérotées ou constantes, à filtres, ou dont l’en-tête n’est pas d’une ligne
        [unmodelled] un tableau d’observations avec des erreurs de {"["}unmodelled]
        [circumstances] un journal d’un robot à jeu dont les lectures indiquent une charge, des couples ou une température
       *[backlash] un tableau d’observations d’un robot à jeu
    }

coordinates-of-other-kind = `coordinates` ne s’applique qu’au type `point` sans station
    .hint = omettre `coordinates`

in-numbered-table = [[{ $table }]] { $number } : { $message }

in-set = ensemble `{ $set }` : { $message }

export-without-points = les valeurs vraies n’ont aucun point pour l’export `{ $file }`
    .hint = ajouter un [[point]] avec cet `export`, ou `label` ou `target` à l’export de la campagne

simulate-utf8 = `etalon simulate` écrit en UTF-8
    .hint = omettre `encoding` de cet export

simulated-rows-lost = seules { $read } lignes sur { $rows } de `{ $file }` seraient lues
    .hint = indiquer cible, pose et cycle dans `label` ou `columns` ; `pose = "row"` suppose une seule cible par fichier ; sans cycle, indiquer `cycles = 1` dans les valeurs vraies

simulated-row-misread = la ligne { $line } de `{ $file }` est { $meant }, mais serait lue comme { $read }
    .hint = indiquer cible, pose et cycle dans `label` ou `columns` ; `pose = "row"` suppose une seule cible par fichier ; sans cycle, indiquer `cycles = 1` dans les valeurs vraies

measurement-name = cible `{ $target }`, pose { $pose }, cycle { $cycle }

truth-pose-out-of-reach = la pose { $pose } est hors de portée : { $reason }
    .hint = corriger la pose dans les valeurs vraies, ou [reach] dans robot.toml

truth-point-out-of-reach = pose { $pose } : le robot vrai n’atteint pas le point { $point } mm
    .hint = corriger le point ou la pose dans les valeurs vraies

observe-without-table = les valeurs vraies contiennent [[observe]], mais la campagne n’a pas de section [observations]
    .hint = indiquer le tableau dans campaign.toml : `[observations]` avec `file`

table-without-observe = les valeurs vraies ne contiennent pas de [[observe]] pour le tableau de [observations]
    .hint = indiquer les observations : kind = "point", target = "ball" ... ; docs/observations.md énumère les types

campaign-not-synthetic = la campagne n’indique pas que ses données sont synthétiques : ses fichiers sont peut-être des mesures
    .hint = indiquer `synthetic = "origine des données"` dans campaign.toml ; `etalon init --synthetic DOSSIER` écrit une telle campagne avec ses valeurs vraies

truth-decimals = { $decimals } décimales dépassent la précision d’un nombre
    .expected = 0 à { $most }

joints-and-points-together = un fichier qui contient à la fois articulations et points ne peut pas être simulé
    .hint = indiquer un export et un [log] séparés

point-label-formula = un tableur prendrait l’étiquette `{ $label }` d’un [[point]] pour une formule
    .hint = utiliser une étiquette qui ne commence pas par = + - ou @

truth-parameters-missing = [parameters] n’indique pas { $parameters }
    .hint = indiquer les positions vraies des points fixes et des surfaces observés

unmodelled-joint-unknown = [unmodelled] mentionne `{ $joint }`, qui n’est pas une articulation de ce robot

unmodelled-period = [unmodelled] `period` de `{ $joint }` doit être positif
    .hint = indiquer une période positive

study-too-few-poses = trop peu de poses pour identifier tous les paramètres
    .hint = ajouter des poses à l’ensemble

study-set-empty = un ensemble ne contient aucune pose que le robot atteigne
    .hint = indiquer des poses atteignables

study-not-by-position = `{ $model }` ne peut pas être positionné par des coordonnées
    .hint = indiquer `joints`, ou un tableau dans `file`

truth-not-touching = pose { $pose } : aucune valeur articulaire proche des valeurs vraies ne réalise le contact
    .hint = indiquer des valeurs articulaires plus proches du contact, ou une plage de tirage plus large

angle-uncertainty-missing = l’incertitude d’un angle manque
    .hint = indiquer `expanded_rotation_uncertainty_deg` dans [instrument], ou `urot_deg` dans [[observe]]

truth-geometric-without-campaign = [geometric] figure dans les valeurs vraies, mais pas dans la campagne, ou son robot n’est pas un PreXYT
    .hint = indiquer [geometric] dans campaign.toml : cette section donne les étiquettes
study-error-in-base = pose vraie de l’outil dans le repère de la base moins la pose commandée
study-error-in-world = pose vraie de l’outil dans le repère atelier moins la pose commandée
poses-in-set = poses de l’ensemble `{ $set }`
positions-in-workspace = positions dans `workspace`
counted-calibrations = étalonnages
errors-to-evaluate = erreurs à évaluer
poses-to-simulate = poses à simuler
points-to-simulate = points à simuler

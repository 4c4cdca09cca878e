### Messages de compare ; explications dans en/compare.ftl.

stream-not-in-all = l’enregistrement `{ $stream }` n’est pas dans toutes les campagnes
    .hint = donner le même nom, dans toutes les campagnes, à l’enregistrement d’une même trajectoire

stream-commands-differ = les points commandés de l’enregistrement `{ $stream }` diffèrent : AT et RT ne sont pas comparées
    .hint = utiliser la même trajectoire, le même repère et les mêmes `path_points` et `near_mm` dans toutes les campagnes

stream-few-passes = AT et RT de l’enregistrement `{ $stream }` reposent sur { $passes ->
        [one] { $passes } passage
       *[other] { $passes } passages
    } ; le test de changement a été validé avec { $validated } passages
    .hint = parcourir la trajectoire dix fois (ISO 9283)

path-change-uncertain = changement significatif : { $names } ; dans des essais simulés, les intervalles de AT contiennent la valeur vraie dans 93 % à 95 % des cas, ceux de RT dans 90 % à 98 %
    .hint = répéter l’essai avant de conclure

nothing-to-compare = les campagnes n’ont aucun résultat en commun
    .expected = parameters.json, iso9283.json ou iso9283-streams.json dans le dossier de chaque campagne
    .hint = exécuter les campagnes avec cette version : `etalon run CAMPAGNE`

one-campaign = une comparaison nécessite au moins deux campagnes
    .expected = deux dossiers ou plus

campaign-twice = `{ $folder }` est indiqué deux fois
    .hint = indiquer chaque dossier une fois

robots-differ = robots différents : `{ $first }` a mesuré `{ $first_robot }`, `{ $second }` a mesuré `{ $second_robot }`
    .hint = comparer des campagnes d’un même robot ; si le robot est le même, lui donner partout le même `name` dans robot.toml et relancer les campagnes

models-differ = modèles de robot différents : `{ $first }` a identifié `{ $first_model }`, `{ $second }` a identifié `{ $second_model }`
    .hint = identifier les deux avec le même modèle

parameters-differ = `{ $first }` et `{ $second }` ont des paramètres différents : { $parameters }
    .hint = utiliser le même fichier de robot, les mêmes cibles et le même modèle

campaigns-with-same-readings = { $count ->
        [one] deux dossiers contiennent
       *[other] des dossiers contiennent
    } les mêmes lectures : { $pairs }
    .hint = remplacer les exports et les journaux de la campagne ultérieure par ceux de sa propre mesure
same-readings = `{ $first }` et `{ $second }`

campaigns-out-of-order = `{ $first }` est indiqué avant `{ $second }`, mais a une date postérieure
    .hint = indiquer d’abord la campagne la plus ancienne

document-not-in-all = { $document } n’est pas comparé : il manque dans { $folders }
    .hint = comparer des campagnes qui ont toutes ce document

poses-not-in-all = { $count ->
        [one] pose absente d’au moins une campagne : { $poses }
       *[other] poses absentes d’au moins une campagne : { $poses }
    }
    .hint = le nom d’une pose doit désigner la même pose dans toutes les campagnes

homing = prise d’origine

parameters-not-in-all = toutes les campagnes n’ont pas identifié { $parameters }
    .hint = identifier les mêmes paramètres : des paramètres voisins ont pu absorber l’erreur des paramètres fixés

nominal-values-differ = les valeurs nominales diffèrent entre les fichiers de robot : { $parameters }
    .hint = utiliser le même fichier de robot : les paramètres fixés influent sur les paramètres identifiés

model-misfits = les résidus de { $campaigns } dépassent l’incertitude de l’instrument : les changements de paramètres et d’erreurs moyennes ne sont pas testés (sans valeur p) ; les intervalles des paramètres contiennent la composante entre séries (rapport de Birge jusqu’à { $birge })
    .hint = identifier avec un modèle qui décrit le robot, et mesurer chaque fois les mêmes poses

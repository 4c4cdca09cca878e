### Messages de compare ; explications dans en/compare.ftl.

stream-not-in-all = le flux `{ $stream }` n’est pas dans toutes les campagnes
    .hint = donner le même nom au flux d’une trajectoire dans toutes les campagnes

stream-commands-differ = les points commandés du flux `{ $stream }` diffèrent : AT et RT ne sont pas comparés
    .hint = utiliser la même trajectoire, le même référentiel, `path_points` et `near_mm` dans toutes les campagnes

stream-few-passes = AT et RT du flux `{ $stream }` reposent sur { $passes ->
        [one] { $passes } passage
       *[other] { $passes } passages
    } ; l’essai de changement est validé avec { $validated }
    .hint = parcourir la trajectoire dix fois (ISO 9283)

path-change-uncertain = déclarés changés : { $names } ; dans des essais simulés, les intervalles de AT contiennent la valeur vraie dans 93 % à 95 % des cas, ceux de RT dans 90 % à 98 %
    .hint = répéter l’essai avant d’agir

nothing-to-compare = les campagnes n’ont aucun résultat en commun
    .expected = parameters.json, iso9283.json ou iso9283-streams.json dans le dossier de chaque campagne
    .hint = exécuter les campagnes avec cette version : `etalon run CAMPAGNE`

one-campaign = une comparaison nécessite au moins deux campagnes
    .expected = deux dossiers ou plus

campaign-twice = `{ $folder }` est indiqué deux fois
    .hint = indiquer chaque dossier une fois

robots-differ = robots différents : `{ $first }` a mesuré `{ $first_robot }`, `{ $second }` `{ $second_robot }`
    .hint = comparer des campagnes d’un même robot ; s’il est le même, lui donner un seul `name` dans robot.toml et relancer

models-differ = modèles de robot différents : `{ $first }` a identifié `{ $first_model }`, `{ $second }` `{ $second_model }`
    .hint = identifier les deux avec un seul modèle

parameters-differ = `{ $first }` et `{ $second }` ont des paramètres différents : { $parameters }
    .hint = utiliser le même fichier de robot, les mêmes cibles et le même modèle

campaigns-out-of-order = `{ $first }` est indiqué avant `{ $second }` et a la date la plus récente
    .hint = indiquer d’abord la campagne la plus ancienne

document-not-in-all = { $document } n’est pas comparé : il manque dans { $folders }
    .hint = comparer des campagnes qui l’ont toutes

poses-not-in-all = pas dans toutes les campagnes : pose { $poses }
    .hint = le nom d’une pose doit désigner la même pose dans toutes les campagnes

homing = prise d’origine

parameters-not-in-all = toutes les campagnes n’ont pas identifié { $parameters }
    .hint = identifier les mêmes paramètres : des paramètres semblables ont pu absorber l’erreur des paramètres imposés

nominal-values-differ = les valeurs nominales diffèrent entre les fichiers de robot : { $parameters }
    .hint = utiliser le même fichier de robot : les paramètres imposés à leur valeur nominale agissent sur les autres

model-misfits = les résidus de { $campaigns } dépassent l’incertitude de l’instrument : les différences de paramètres et d’erreurs moyennes ne prouvent aucun changement et n’ont pas de valeur p ; les intervalles des paramètres contiennent la composante entre séries (rapport de Birge jusqu’à { $birge })
    .hint = identifier avec un modèle qui décrit le robot, et mesurer chaque fois les mêmes poses

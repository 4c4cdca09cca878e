### Messages de view ; explications dans en/view.ftl.

view-busy = plus de { $most } connexions en même temps
    .hint = fermer les autres pages de ce programme et recharger la page

view-request-malformed = la requête est illisible
    .hint = recharger la page

view-request-slow = la requête n’est pas arrivée à temps
    .hint = envoyer la requête à nouveau

view-request-without-length = la requête n’indique pas la longueur de son contenu
    .hint = indiquer `Content-Length`

view-request-too-large = le fichier dépasse { $mib } Mio
    .hint = copier le fichier dans le dossier de la campagne et recharger la page

view-request-unknown = le serveur ne connaît pas cette adresse
    .hint = charger la page depuis l’adresse affichée par le programme

view-other-host = la requête nomme un autre serveur
    .expected = { $name }
    .hint = charger la page depuis l’adresse affichée par le programme

view-other-origin = la requête vient d’une autre page
    .hint = fermer l’autre page

view-token-missing = le jeton de la page manque ou date d’un démarrage antérieur
    .hint = ouvrir l’adresse affichée par le programme

view-file-name = le nom du fichier n’est pas un simple nom de fichier
    .expected = un nom sans dossier et sans les caractères : * ? " < > |
    .hint = renommer le fichier et le déposer à nouveau

view-download-unknown = la page n’offre aucun fichier de ce nom
    .hint = exécuter la campagne et choisir un fichier de la liste

view-file-exists = `{ $name }` existe déjà dans le dossier
    .hint = renommer le fichier déposé, ou retirer l’autre du dossier

view-folder-full = plus de { $files } fichiers ou { $mib } Mio ont été déposés
    .hint = copier les fichiers dans le dossier de la campagne et recharger la page

view-file-not-dropped = `{ $name }` n’a pas été déposé sur cette page
    .hint = retirer le fichier dans le dossier même

view-nothing-dropped = aucun fichier de mesures n’a été déposé
    .hint = déposer l’export du système de mesure et le journal du contrôleur

view-campaign-exists = le dossier contient déjà un campaign.toml
    .hint = modifier campaign.toml, ou lancer `etalon view` avec un nouveau dossier

view-without-campaign = le dossier ne contient aucune campagne lisible
    .hint = déposer des fichiers et accepter la proposition, ou corriger campaign.toml

view-run-in-progress = une exécution est en cours
    .hint = attendre sa fin

view-not-identified = la campagne n’a aucune identification à comparer
    .hint = corriger les erreurs de la campagne, ou ajouter [identify]

view-pose-unknown = la pose `{ $name }` n’a pas été mesurée
    .hint = choisir une pose mesurée

view-reason-missing = la modification n’a pas de motif
    .hint = écrire pourquoi la campagne est modifiée

view-nothing-asked = aucune modification n’a été demandée
    .hint = exclure une pose ou une cible, fixer ou libérer un paramètre, ou indiquer une autre limite

view-campaign-not-editable = la page ne peut pas modifier `{ $key }` dans campaign.toml
    .hint = modifier campaign.toml à la main, par exemple avec [identify] comme section propre

view-parameter-stays-held = le paramètre `{ $name }` n’est pas fixé par son nom dans `hold`
    .hint = modifier `hold` ou `effects` dans [identify] à la main

view-port-unavailable = le serveur ne peut pas écouter sur le port { $port } : { $error }
    .hint = indiquer un autre `--port`, ou aucun pour un port libre

view-browser-not-opened = le navigateur n’a pas pu être ouvert
    .hint = ouvrir { $url }

watch-disagrees = la pose { $pose } est en désaccord : { FIXED($error_um, 0) } µm à { $target }, au plus { FIXED($expected_um, 0) } µm attendus
    .hint = mesurer la pose à nouveau, vérifier la cible et les valeurs articulaires

watch-labels-exchanged = la pose { $pose } convient si `{ $first }` et `{ $second }` sont interverties
    .hint = corriger les étiquettes dans le système de mesure, ou mesurer la pose à nouveau

watch-joints-of-other-pose = la pose { $pose } convient avec les valeurs articulaires de la pose { $other }
    .hint = vérifier quand le contrôleur écrit le journal : il est peut-être en retard

watch-target-missing = il manque { $targets } à la pose { $pose }
    .hint = tourner la cible vers l’instrument et mesurer la pose à nouveau

watch-poses-gone = { $count ->
        [one] la pose { $poses } a disparu
       *[other] { $count } poses ont disparu : { $poses }
    }
    .hint = remettre le fichier en place, ou mesurer de nouveau les poses

view-opened = page : { $url }
view-next = fermer la page ou appuyer sur Ctrl-C pour terminer le programme
view-run-begins = lecture des fichiers
view-run-writes = écriture du rapport
view-next-drop = déposer sur la page l’export du système de mesure et le journal du contrôleur
view-verdict-limit = { $limit } : { FIXED($value, 4) } { $unit } ± { FIXED($expanded, 4) } { $unit } (k = 2), limite { FIXED($bound, 4) } { $unit }
view-verdict-limit-unknown = { $limit } : { FIXED($value, 4) } { $unit }, limite { FIXED($bound, 4) } { $unit }
view-verdict-no-limit = aucune limite n’est indiquée
view-download-report = rapport ({ $kind })
view-download-file = fichier pour un contrôleur ou un autre programme
view-question-instrument = Comment s’appelle le système de mesure ?
view-question-uncertainty = Quelle est l’incertitude élargie d’une coordonnée (µm, k = 2) ? Le certificat d’étalonnage l’indique.
view-question-rotation = Quelle est l’incertitude élargie d’une orientation mesurée (°) ?
view-question-unit = Quelle est l’unité des longueurs dans { $file } ?
view-question-joint-unit = Quelle est l’unité des valeurs articulaires dans { $file } ?
view-question-time-unit = Quelle est l’unité des temps dans { $file } ?
view-question-angle-unit = Quelle est l’unité des rotations mesurées dans { $file } ?
view-question-rotation-order = Dans quel ordre tournent les trois angles de { $file } (`zyx`, `fixed xyz`), ou sont-ils un vecteur rotation (`vector`) ?
view-question-world = A-t-on mesuré dans le référentiel du robot ? Sinon, le définir à partir de points dans [frame.world].
view-question-robot = Quel robot a été mesuré ?
view-question-key = Que vaut `{ $key }` dans [{ $section }] ?
watch-waiting = en attente de la première pose
watch-few = { $received ->
        [one] { $received } pose : trop peu pour une identification
       *[other] { $received } poses : trop peu pour une identification
    }
watch-agrees = la pose { $pose } convient : { FIXED($error_um, 0) } µm, au plus { FIXED($expected_um, 0) } µm attendus
watch-first = { $received ->
        [one] { $received } pose identifiée
       *[other] { $received } poses identifiées
    }
watch-stop-met = limite respectée avec sa bande de garde : { FIXED($value_um, 0) } µm ± { FIXED($expanded_um, 0) } µm (k = 2), limite { FIXED($limit_um, 0) } µm
watch-stop-open = pas encore : { FIXED($value_um, 0) } µm ± { FIXED($expanded_um, 0) } µm (k = 2), limite { FIXED($limit_um, 0) } µm
watch-stop-no-limit = aucune limite n’est indiquée : indiquer `position_max_mm` dans [limits]
watch-next-of-plan = pose suivante du plan
watch-next-of-most-information = parmi les poses restantes, celle-ci réduit le plus l’incertitude des paramètres

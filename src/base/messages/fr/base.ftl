### Messages de base ; explications dans en/base.ftl.

also-in-lines = { $message } ; également aux lignes { $second }, { $third } et { $more ->
        [one] { $more } autre ligne
       *[other] { $more } autres lignes
    }

did-you-mean = vouliez-vous dire `{ $name }` ?

expected-whole-number = nombre entier de 0 à { $most } attendu
is-a-folder = c’est un dossier
meant-in-unit = convertir en `{ $name }` : 1 { $from } = { $factor } { $to }

name-without-unit = ajouter l’unité : { $names }

known-names = utiliser l’un de ces noms : { $names }

known-names-first = utiliser l’un de ces noms : { $names }, ...

no-regular-file = c’est un tube, une socket ou un périphérique, un fichier ordinaire est attendu
pose-name-empty = le nom de la pose est vide
    .expected = un nombre entier, ou un nom comme `home` ou `A-3`

pose-name-too-long = le nom de la pose a { $characters } caractères
    .expected = au plus { $most } caractères : un nombre entier, ou un nom comme `home` ou `A-3`

pose-name-unprintable = un tableau ne peut pas contenir le nom `{ $name }`
    .expected = un nombre entier, ou un nom comme `home` ou `A-3`

pose-name-two-spellings = `{ $first }` et `{ $second }` ne diffèrent que par des majuscules, des espaces, `_`, `-`, des zéros ou des caractères invisibles
    .hint = écrire le nom d’une pose de la même façon dans toutes les lignes et tous les fichiers

counts-too-large = trop de { $of } : { $counts }
    .expected = au plus { $most }

cannot-read-file = impossible de lire `{ $file }` : { $reason }

file-too-large = impossible de lire `{ $file }` : plus de { $most_mib } Mio

not-utf8 = `{ $file }` n’est pas en UTF-8 (octet { $byte })
    .hint = enregistrer le fichier en UTF-8

cannot-write-file = impossible d’écrire `{ $file }` : { $reason }

file-exists = `{ $file }` existe déjà
    .hint = indiquer un nouveau dossier

lock-foreign = impossible d’écrire `{ $file }` : `{ $lock }` n’est pas un verrou d’etalon
    .expected = un fichier ordinaire qui n’a qu’un nom
    .hint = le supprimer : etalon a besoin de ce nom pendant l’écriture

output-through-link = impossible d’écrire `{ $file }` : `{ $link }` est un lien symbolique
    .expected = un dossier ou un fichier auquel aucun lien ne mène
    .hint = remplacer le lien par un dossier, ou indiquer le dossier même

output-not-a-file = impossible d’écrire `{ $file }` : c’est un périphérique, un tube ou une socket
    .hint = indiquer un fichier ordinaire

template-failed = le gabarit `{ $template }` { $fault ->
        [time] prend plus d’une minute
        [memory] prend plus de 2 Gio de mémoire
        [ended] se termine sans résultat
       *[other] ne peut pas être exécuté : { $fault }
    }
    .hint = vérifier les boucles du gabarit : chacune doit se terminer

template-too-nested = la ligne { $line } du gabarit `{ $template }` a plus de { $most } niveaux de parenthèses, d’opérateurs et de blocs
    .hint = découper l’expression avec `set`

template-width = une largeur de plus de { $most }
template-size = un texte de plus de { $most_mib } Mio
template-instructions = plus de { $most } instructions

environment-date = la variable d’environnement `SOURCE_DATE_EPOCH` vaut `{ $value }`
    .expected = les secondes depuis 1970, de 0 à l’an 9999
    .hint = indiquer un nombre entier, ou supprimer la variable

environment-threads = la variable d’environnement `{ $name }` vaut `{ $threads }`
    .expected = au plus { $most } fils d’exécution
    .hint = indiquer le nombre de cœurs, ou supprimer la variable

locked = le processus { $process } écrit `{ $file }`
    .hint = attendre la fin de ce processus

output-is-input = `{ $output }` écraserait l’entrée `{ $input }`
    .hint = indiquer un autre fichier de sortie

cannot-write-folder = impossible d’écrire le dossier `{ $folder }` : { $reason }

cannot-encode = impossible d’écrire { $format } : { $reason }

angle-order-unknown = `{ $text }` n’est pas un ordre de trois angles
    .expected = "zyx", "xyz", "zyz" .. autour des axes du corps, ou "fixed xyz" .. autour des axes du repère atelier

pose-number-too-large = le numéro d’une pose dépasse 9223372036854775807
rotation-not-orthonormal = la matrice de rotation n’est pas orthonormée : les produits scalaires de ses lignes s’écartent de 1 ou de 0 de { $off }
    .expected = r11 à r33, ligne par ligne : orientation du corps dans le repère atelier

rotation-mirrors = la matrice de rotation contient une réflexion : son déterminant est -1
    .hint = vérifier les signes de ses colonnes

factor = { $of ->
        [poses] { $count ->
            [one] { $count } pose
           *[other] { $count } poses
        }
        [cycles] { $count ->
            [one] { $count } cycle
           *[other] { $count } cycles
        }
        [repeats] { $count ->
            [one] { $count } répétition
           *[other] { $count } répétitions
        }
        [draws] { $count ->
            [one] { $count } tirage
           *[other] { $count } tirages
        }
       *[runs] { $count ->
            [one] { $count } exécution
           *[other] { $count } exécutions
        }
    }
product = { $first } × { $second }
unknown-country = code de pays `{ $code }` inconnu, deux majuscules de l’ISO 3166-1 sont attendues, comme CA, DE ou GB

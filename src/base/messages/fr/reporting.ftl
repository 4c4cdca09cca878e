### Messages de report ; explications dans en/report.ftl.

template-invalid = le gabarit du rapport contient une erreur : { $reason }

logo-unusable = `{ $file }` { $fault ->
        [size] est trop grand pour un logo
       *[format] n’est ni une image SVG ni une image PNG
    }
    .expected = une image SVG ou PNG de 1 Mio au plus

cannot-read-folder = impossible de lire le dossier `{ $folder }` : { $reason }
    .hint = vérifier le chemin et les droits

no-templates = le dossier `{ $folder }` n’a pas de gabarit
    .hint = `etalon report --write-templates DOSSIER` écrit les gabarits intégrés

typesetting-failed = report.pdf ne peut pas être composé : { $reason }

own-hint = { $text }

### Significations des paramètres et titres des dessins.

meaning-axis-displacement = Petit déplacement de l’axe de l’articulation, suivant l’axe en fin de nom.
meaning-axis-rotation = Petite rotation de l’axe de l’articulation, autour de l’axe en fin de nom ; positive dans le sens trigonométrique.
meaning-backlash = Jeu de l’articulation : position en approche par valeurs décroissantes moins position en approche par valeurs croissantes, pour la même valeur enregistrée ; 0 sans jeu.
meaning-ball-distance = Distance entre les billes K et L.
meaning-ball-line-angle = Angle de l’axe x de la plate-forme à la droite des billes K et L ; positif dans le sens trigonométrique.
meaning-base-orientation = Orientation de la base dans le repère atelier, en vecteur de rotation ; positive dans le sens trigonométrique.
meaning-base-origin = Origine de la base dans le repère atelier, suivant l’axe en fin de nom.
meaning-base-origin-x = Origine de la base dans le repère atelier, suivant x.
meaning-base-origin-y = Origine de la base dans le repère atelier, suivant y.
meaning-bending = Flexion sous la pesanteur : angle sous le plus grand moment (bras tendu à l’horizontale) ; positive dans le sens du moment de la charge.
meaning-carriage-1-place = Position du chariot 1 à la valeur nulle de l’actionneur, suivant x.
meaning-carriage-1-travel = Course du chariot 1 suivant x par millimètre commandé ; nominalement 1.
meaning-carriage-2-travel = Course du chariot 2 par millimètre commandé ; nominalement 1.
meaning-carriage-3-place = Position du chariot 3 à la valeur nulle de l’actionneur, suivant y.
meaning-carriage-3-travel = Course du chariot 3 par millimètre commandé ; nominalement 1.
meaning-carriage-offset = Décalage du chariot : ajouté à sa hauteur.
meaning-centre-across-balls = Centre C de la plate-forme depuis la bille K, perpendiculairement à la droite des billes.
meaning-centre-along-balls = Centre C de la plate-forme depuis la bille K, le long de la droite des billes.
meaning-coupling = Couplage : déplacement de la première articulation par unité de déplacement de la seconde.
meaning-distal-link-1 = Longueur du segment distal du bras 1, de B1 à C.
meaning-distal-link-2 = Longueur du segment distal du bras 2, de B2 à C.
meaning-drift = Dérive du zéro de l’articulation avec la température du robot : variation de la valeur articulaire pour un échauffement de 10 K.
meaning-encoder-1-offset = Décalage du codeur 1 : ajouté à sa valeur ; positif dans le sens trigonométrique.
meaning-encoder-2-offset = Décalage du codeur 2 : ajouté à sa valeur ; positif dans le sens trigonométrique.
meaning-encoder-offset = Décalage du codeur : ajouté à sa valeur ; un décalage plus grand abaisse le bras.
meaning-expansion = Dilatation commune de toutes les longueurs du bras avec la température du robot : mm par mètre et par kelvin (acier : 0,0115).
meaning-fixture-place = Position ou dimension d’un élément fixe dans le repère atelier : coordonnée suivant l’axe en fin de nom, ou rayon.
meaning-foot-aside = Position latérale du pied de l’axe moteur ou de la colonne, suivant l’axe y de sa jambe.
meaning-foot-outwards = Distance du pied de l’axe moteur ou de la colonne à l’axe z de la base, suivant l’axe x de sa jambe ; positive vers l’extérieur.
meaning-gain = Gain de l’articulation : déplacement par unité de la valeur enregistrée ; nominalement 1.
meaning-guide-angle = Angle du guide du chariot 1 avec l’axe y de la base ; positif dans le sens horaire.
meaning-harmonic = Harmonique de la transmission : déplacement de l’articulation par unité du sinus ou cosinus (en fin de nom) d’une ou deux fois l’angle de l’articulation.
meaning-hayati-angle = Angle de Hayati entre axes presque parallèles, autour de l’axe y ; remplace le décalage du segment ; positif dans le sens trigonométrique.
meaning-joint-offset = Décalage de l’articulation : ajouté à la valeur enregistrée, autour de l’axe z ; positif dans le sens trigonométrique.
meaning-lateral = Basculement de l’articulation perpendiculairement à son axe, autour de l’axe (en fin de nom) du repère que l’articulation déplace : angle sous un moment de 100 N·m autour du même axe ; positif dans le sens du moment.
meaning-leg-joint-on-base = Centre de l’articulation de la jambe sur la base, suivant l’axe de la base en fin de nom.
meaning-leg-joint-on-platform = Centre de l’articulation de la jambe sur la plate-forme, suivant l’axe de la plate-forme en fin de nom.
meaning-leg-length = Longueur de la jambe entre les centres de ses articulations, à la valeur articulaire nulle.
meaning-link-length-before = Longueur du segment avant l’articulation : distance entre ses deux axes, suivant l’axe x précédent.
meaning-link-length-behind = Longueur du segment après l’articulation : distance entre ses deux axes, suivant le nouvel axe x.
meaning-link-offset = Décalage du segment suivant l’axe z de l’articulation.
meaning-link-twist-before = Torsion du segment avant l’articulation : angle de l’axe z précédent à l’axe z de l’articulation, autour de l’axe x précédent ; positive dans le sens trigonométrique.
meaning-link-twist-behind = Torsion du segment après l’articulation : angle de l’axe z de l’articulation à l’axe z suivant, autour du nouvel axe x ; positive dans le sens trigonométrique.
meaning-motor-axis-turn-x = Rotation de l’axe moteur autour de l’axe x de sa jambe ; positive dans le sens trigonométrique.
meaning-motor-axis-turn-z = Rotation de l’axe moteur autour de l’axe z de sa jambe ; positive dans le sens trigonométrique.
meaning-motor-direction = Direction du moteur A1 vers le moteur A2 dans le repère atelier ; positive dans le sens trigonométrique.
meaning-motor-distance = Distance entre les axes des moteurs A1 et A2.
meaning-motor-height = Hauteur de l’axe moteur au-dessus de la base, suivant z.
meaning-motors-middle-x = Milieu des moteurs dans le repère atelier, suivant x.
meaning-motors-middle-y = Milieu des moteurs dans le repère atelier, suivant y.
meaning-payload = Flexion de l’articulation sous la charge d’une lecture : angle sous un moment de 100 N·m ; positive dans le sens du moment de la charge.
meaning-pedestal = Basculement ou torsion de la base autour de son axe en fin de nom : angle sous un moment de 100 N·m autour du même axe ; positif dans le sens du moment.
meaning-proximal-link-1 = Longueur du segment proximal du bras 1, de A1 à B1.
meaning-proximal-link-2 = Longueur du segment proximal du bras 2, de A2 à B2.
meaning-rail-1-angle = Angle du rail 1 avec l’axe x de la base ; positif dans le sens trigonométrique.
meaning-rail-1-distance = Distance du rail 1 à l’origine de la base, suivant y.
meaning-rail-3-angle = Angle du rail 3 avec l’axe y de la base ; positif dans le sens trigonométrique.
meaning-rail-3-distance = Distance du rail 3 au rail 2, suivant x.
meaning-rod-joint = Distance de l’articulation de la bielle à l’axe z de la plate-forme, suivant l’axe x de sa jambe ; positive vers l’extérieur.
meaning-rod-length = Longueur de la bielle (avant-bras) entre les centres de ses articulations.
meaning-station-pose = Pose d’une autre station de l’instrument dans le repère atelier : son origine, et son orientation en vecteur de rotation.
meaning-bar-length = Longueur d’une barre tenue entre deux cibles.
meaning-surface-direction = Direction d’une surface fixe dans le repère atelier : pente de sa trace suivant l’axe en fin de nom.
meaning-target-orientation = Orientation du corps qui porte la cible sur la bride, en vecteur de rotation.
meaning-target-place = Position de la cible dans le repère de la bride ou de la plate-forme, suivant l’axe en fin de nom.
meaning-tool-angle = Angle en B2, de C à l’outil E ; positif dans le sens trigonométrique.
meaning-tool-distance = Distance de l’outil E à B2.
meaning-torque = Flexion de l’articulation sous son couple : angle sous 100 N·m du couple indiqué ; positive dans le sens du couple, donc négative si les couples sont ceux de l’entraînement, contre lequel l’articulation cède.
meaning-tower-turn-x = Rotation de la colonne autour de l’axe x de sa jambe ; positive dans le sens trigonométrique.
meaning-tower-turn-y = Rotation de la colonne autour de l’axe y de sa jambe ; positive dans le sens trigonométrique.
meaning-upper-arm-length = Longueur du bras proximal, de l’axe moteur à la bielle.
pedestal-or-first-joint = indiquer `pedestal` ou l’articulation { $joint } dans `lateral`, mais pas les deux : la base et la première articulation cèdent de la même façon sous le bras
sketch-arm = Bras aux valeurs articulaires nulles : axes des articulations et longueurs des segments.
sketch-five-bar = Mécanisme à cinq barres vu de dessus : segments et angles (positifs dans le sens trigonométrique). L’outil est dessiné à côté de C.
sketch-legs = Robot à mi-course de ses articulations, avec les paramètres de la jambe 1. Les autres jambes ont les mêmes paramètres.
sketch-link-dh = Segment et ses paramètres de Denavit-Hartenberg (standard).
sketch-link-mdh = Segment et ses paramètres de Denavit-Hartenberg (modifiés).
sketch-table = Table vue de dessus, inclinaisons exagérées : rails, chariots, plate-forme C et billes K et L.

measure-all-working-modes = mesurer chaque position dans tous les modes de travail qui l’atteignent, et répartir les positions sur tout l’espace de travail

measure-different-angles = mesurer des poses de |theta| différents, par exemple 0 et la plus grande valeur de la table
out-of-reach = hors de portée
out-of-reach-by = hors de portée : à { FIXED($away_mm, 1) } mm de la première articulation, le bras atteint { FIXED($reach_mm, 1) } mm
pose-not-finite = la pose contient des valeurs qui ne sont pas des nombres finis
no-solution-found = aucune solution trouvée à partir de { $starts } départs dans les limites articulaires
out-of-nominal-reach = hors de portée du robot nominal
joint-beyond-limits = { $joint } = { $q } { $unit }, hors des limites { $lower } et { $upper } { $unit }
angle-beyond-limits = { $joint } = { FIXED($q, 3) } deg, hors des limites { $least } et { $greatest } deg
actuator-beyond-travel = { $actuator } = { $rho } mm, sa course va de 0 à { $end } mm
legs-apart = les jambes ne rejoignent pas la plate-forme
arms-do-not-meet = les bras ne se rejoignent pas
singularity-near = à { FIXED($found, 3) } deg de la singularité de type { $kind } { $kind ->
        [1] (un bras tendu ou replié)
       *[2] (les segments distaux alignés)
    } : il faut au moins { $margin } deg
links-near = segments distants de { FIXED($found, 3) } mm : il faut plus de { $least } mm
command-refused = le contrôleur rejette cette commande : { $reason }
joints-admit-no-pose = le robot n’a pas de pose à ces valeurs articulaires
no-command-leads-there = aucune commande n’amène le robot à la cible : la plus petite erreur est de { SCIENTIFIC($left_mm, 2) } mm
published-arm = un autre robot : { $title }
table-read-as = le tableau des articulations, lu comme paramètres de Denavit-Hartenberg { $convention ->
        [modified] modifiés
        [standard] standard
       *[other] { $convention }
    }

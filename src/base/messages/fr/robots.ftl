### Messages de robots ; explications dans en/robots.ftl.

measure-all-working-modes = mesurer chaque position dans tous les modes de travail qui l’atteignent, et des positions tout autour de l’espace de travail

measure-different-angles = mesurer des poses avec des |theta| différents, par exemple 0 et le plus grand que la table atteint

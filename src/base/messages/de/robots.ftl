### Meldungen von robots; Erklärungen in en/robots.ftl.

measure-all-working-modes = jede Position in allen Arbeitsmodi messen, die sie erreichen, und Positionen rund um den Arbeitsraum

measure-different-angles = Posen mit verschiedenen |theta| messen, zum Beispiel 0 und dem größten, das der Tisch erreicht
